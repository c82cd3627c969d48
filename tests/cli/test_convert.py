"""``leitmotion convert``: whole folders, the bad ones in their place, a second run, and what is never replaced."""

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path
from typing import Any

import pytest

import leitmotion
from cli import pieces
from cli.conftest import Run
from cli.json_schema import faults
from leitmotion import io
from leitmotion.cli import convert as module
from leitmotion.cli.ledger import NAME
from leitmotion.io import files

TESTS = Path(__file__).resolve().parents[1]
DOCS = TESTS.parent / "docs" / "json.md"
POSIX = pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")


@pytest.fixture(autouse=True)
def one_process(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Convert in this process, which is quicker, where a test does not ask for `processes`."""

    def here(work: Any, pieces: Any, jobs: int) -> Any:
        return ((place, work(piece)) for place, piece in enumerate(pieces))

    if "processes" not in request.fixturenames:
        monkeypatch.setattr(module, "each_as_done", here)


@pytest.fixture
def processes() -> None:
    """Ask for processes of their own."""


@pytest.fixture
def src(run: Run, made: Path) -> Path:
    """``src`` with good recordings (one in a folder, one with an odd name), a bad and an empty one, and labels."""
    folder = Path("src")
    (folder / "deep er").mkdir(parents=True)
    shutil.copy(made / "jacks.bvh", folder / "one.bvh")
    shutil.copy(made / "once.bvh", folder / "two.bvh")
    shutil.copy(made / "once.bvh", folder / "deep er" / "drei é [1].bvh")
    shutil.copy(made / "bad.bvh", folder / "bad.bvh")
    shutil.copy(made / "empty.bvh", folder / "empty.bvh")
    (folder / "labels.csv").write_text("start_s,stop_s,label\n0,1,hop\n", encoding="utf-8")
    return folder


def content(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


GOOD = ["deep er/drei é [1].npz", "one.npz", "two.npz"]


def test_one_file_to_another(run: Run, made: Path) -> None:
    told = run("convert", made / "jacks.bvh", "-o", "new/jacks.npz")
    assert told.exit_code == 0
    assert told.stdout == f"{made / 'jacks.bvh'} → {Path('new/jacks.npz')}\n"
    assert os.listdir("new") == ["jacks.npz"]
    before = leitmotion.read(made / "jacks.bvh")
    assert leitmotion.read("new/jacks.npz") == before


def test_a_folder_keeps_its_shape_and_a_bad_file_stops_nobody(run: Run, src: Path) -> None:
    told = run("convert", "src", "-o", "out", "--to", "npz")
    assert told.exit_code == 1
    assert sorted(content(Path("out"))) == [NAME, *GOOD]
    assert told.stdout.splitlines()[-1] == "Converted 3 of 5; 2 failed, 0 skipped."
    lines = told.stderr.splitlines()
    assert [line.partition(":")[0] for line in lines] == [
        str(src / "bad.bvh"),
        str(src / "empty.bvh"),
        str(src / "labels.csv"),
    ]
    assert "Left out, as no recording" in lines[2]


def test_several_at_a_time_are_as_one_after_another_to_the_byte(run: Run, src: Path, processes: None) -> None:
    for jobs in (1, 3):
        run(
            "convert", "src", "-o", f"out{jobs}", "--to", "bvh", "-j", jobs, "--fps", 24, "--out-unit", "inch"
        )
    assert content(Path("out1")) == content(Path("out3"))
    leitmotion.convert("src/one.bvh", "one.bvh", fps=24.0, out_unit="inch")
    assert Path("one.bvh").read_bytes() == Path("out3/one.bvh").read_bytes()
    told = leitmotion.read("one.bvh", unit="inch", up="y")
    assert told.rate == 24.0


def test_the_documents_are_those_of_the_contract_in_the_order_given(run: Run, src: Path) -> None:
    schema = json.loads(re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[-1])
    told = run(
        "convert",
        "src/two.bvh",
        "src/bad.bvh",
        "src/one.bvh[1s:2s]",
        "-o",
        "out",
        "--to",
        "bvh",
        "--fps",
        15,
        "--json",
    )
    documents = [json.loads(line) for line in told.stdout.splitlines()]
    assert [fault for document in documents for fault in faults(document, schema)] == []
    assert [document["source"][0]["path"] for document in documents] == [
        "src/two.bvh", "src/bad.bvh", "src/one.bvh[1s:2s]",
    ]  # fmt: skip
    assert documents[1]["error"]["type"] == "FormatError"
    third = documents[2]
    assert third["parameters"] == {"to": "bvh", "fps": 15.0, "window": {"start": 30, "stop": 60}}
    assert third["result"]["written"] == [str(Path("out/one.bvh"))]
    assert third["result"]["skipped"] is False
    assert [change["what"] for change in third["result"]["changes"]] == ["rate"]
    assert third["source"][0]["frames"] == 30
    assert third["source"][0]["rate"] == 30.0
    assert len(leitmotion.read("out/one.bvh")) == 15
    again = run(
        "convert",
        "src/two.bvh",
        "src/bad.bvh",
        "src/one.bvh[1s:2s]",
        "-o",
        "out",
        "--to",
        "bvh",
        "--fps",
        15,
        "--json",
    )
    same = [json.loads(line) for line in again.stdout.splitlines()]
    assert [document["result"].pop("skipped") for document in same if "result" in document] == [True, True]
    for document in documents:
        document.get("result", {}).pop("skipped", None)
    assert same == documents


def test_standard_output_and_input(run: Run, made: Path) -> None:
    run("convert", made / "jacks.bvh", "-o", "file.npz")
    assert (
        run("convert", made / "jacks.bvh", "-o", "-", "--to", "npz").stdout_bytes
        == Path("file.npz").read_bytes()
    )
    piped = run("convert", "-", "-o", "-", "--to", "BVH", stdin=(made / "jacks.bvh").read_bytes())
    Path("piped.bvh").write_bytes(piped.stdout_bytes)
    assert leitmotion.read("piped.bvh").skeleton == leitmotion.read(made / "jacks.bvh").skeleton
    failed = run("convert", made / "bad.bvh", "-o", "-", "--to", "npz")
    assert (failed.exit_code, failed.stdout) == (1, "")


TWO = "HIERARCHY\n{}MOTION\nFrames: 2\nFrame Time: 0.01\n{}\n{}\n".format(
    "".join(
        f"ROOT {name}\n{{\nOFFSET 0 90 0\nCHANNELS 3 Xposition Yposition Zposition\n"
        "End Site\n{\nOFFSET 0 80 0\n}\n}\n" for name in ("Anna", "Ben/1")
    ),
    "0 90 0 50 90 0", "1 90 0 51 90 0",
)  # fmt: skip


def test_each_of_several_people_gets_a_file(run: Run) -> None:
    Path("duo.bvh").write_text(TWO, encoding="utf-8")
    told = run("convert", "duo.bvh", "-o", "new.npz", "--unit", "cm", "--up", "y")
    assert told.exit_code == 0, told.stderr
    assert sorted(path.name for path in Path().glob("*.npz")) == ["new.Anna.npz", "new.Ben_1.npz"]
    assert run("convert", "duo.bvh", "-o", "one.npz", "--person", "Anna").exit_code == 0
    assert Path("one.npz").exists()
    told = run("convert", "duo.bvh", "-o", "-", "--to", "npz")
    assert told.exit_code == 1
    assert "holds 2 people: Anna, Ben/1. Choose one with --person NAME." in told.stderr


def test_a_person_s_file_does_not_take_another_input_s_place(run: Run, made: Path) -> None:
    Path("duo.bvh").write_text(TWO, encoding="utf-8")
    shutil.copy(made / "jacks.bvh", "duo.Anna.bvh")
    told = run("convert", "duo.bvh", "duo.Anna.bvh", "-o", "out", "--to", "npz", "--force")
    assert told.exit_code == 1
    assert "is what another input becomes" in told.stderr
    assert leitmotion.read("out/duo.Anna.npz") == leitmotion.read(made / "jacks.bvh").replace(name="duo.Anna")


def people(*names: str) -> str:
    return TWO.replace("Anna", names[0]).replace("Ben/1", names[1])


def test_people_of_names_that_look_alike_get_files_of_their_own(run: Run) -> None:
    Path("duo.bvh").write_text(people("A|B", "a*b"), encoding="utf-8")
    call = ("convert", "duo.bvh", "-o", "out", "--to", "npz", "--unit", "cm", "--up", "y", "--json")
    told = json.loads(run(*call).stdout)
    assert told["result"]["written"] == [
        str(Path("out/duo.A_B.npz")), str(Path("out/duo.a_b-2.npz")),
    ]  # fmt: skip
    made = [leitmotion.read(path) for path in told["result"]["written"]]
    assert made[0] != made[1].replace(name=made[0].name)
    assert json.loads(run(*call).stdout)["result"]["skipped"]
    assert leitmotion.convert("duo.bvh", "o/duo.npz", unit="cm", up="y").written == (
        Path("o/duo.A_B.npz"), Path("o/duo.a_b-2.npz"),
    )  # fmt: skip


@pytest.mark.parametrize("force", [(), ("--force",)])
def test_a_person_s_file_does_not_take_the_place_of_another_input_s_person(
    run: Run, force: tuple[str, ...]
) -> None:
    Path("a.bvh").write_text(people("b.c", "x"), encoding="utf-8")
    Path("a.b.bvh").write_text(people("c", "y"), encoding="utf-8")
    for order in (("a.bvh", "a.b.bvh"), ("a.b.bvh", "a.bvh")):
        told = run("convert", *order, "-o", "out", "--to", "npz", "--unit", "cm", "--up", "y", *force)
        assert told.exit_code == 1
        assert told.stderr.count("is what another input becomes") == 1
        assert sorted(content(Path("out"))) == [NAME, "a.b.c.npz", "a.b.y.npz"]
        shutil.rmtree("out")


def test_a_source_that_changes_while_it_is_read_is_not_taken_for_what_was_read(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(made / "jacks.bvh", "walk.bvh")
    prepare = leitmotion.conversion.prepare

    def slow(*given: Any, **options: Any) -> Any:
        prepared = prepare(*given, **options)
        shutil.copy(made / "once.bvh", "walk.bvh")
        return prepared

    with monkeypatch.context() as patched:
        patched.setattr(leitmotion.conversion, "prepare", slow)
        told = run("convert", "walk.bvh", "-o", "out", "--to", "npz")
    assert told.exit_code == 1
    assert "walk.bvh changed while it was read. Convert it again." in told.stderr
    assert run("convert", "walk.bvh", "-o", "out", "--to", "npz").exit_code == 0
    assert len(leitmotion.read("out/walk.npz")) == len(leitmotion.read(made / "once.bvh"))


def test_a_file_that_appears_while_another_is_converted_stays(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = io.write_whole

    def late(path: Path, held: bytes, **options: Any) -> Path:
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(b"mine")
        return write(path, held, **options)

    with monkeypatch.context() as patched:
        patched.setattr(io, "write_whole", late)
        told = run("convert", made / "jacks.bvh", "-o", "out", "--to", "npz")
    again = run("convert", made / "jacks.bvh", "-o", "out", "--to", "npz")
    for one in (told, again):
        assert one.exit_code == 1
        assert "jacks.npz is there with other content." in one.stderr
    assert Path("out/jacks.npz").read_bytes() == b"mine"


def test_an_archive_s_checksum_is_taken_once_for_all_its_recordings(
    run: Run, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with zipfile.ZipFile("takes.zip", "w") as box:
        for k in range(5):
            box.write("src/two.bvh", f"{k}.bvh")
    taken = []
    checksum = files.checksum
    monkeypatch.setattr(files, "checksum", lambda *paths: taken.extend(paths) or checksum(*paths))
    assert run("convert", "takes.zip", "-o", "out", "--to", "npz").exit_code == 0
    assert [path.name for path in taken].count("takes.zip") == 1
    with zipfile.ZipFile("takes.zip", "a") as box:
        box.writestr("note.txt", "more")
    assert run("convert", "takes.zip", "-o", "out", "--to", "npz").exit_code == 0
    assert [path.name for path in taken].count("takes.zip") == 2


def test_what_a_format_cannot_hold_is_one_sentence(run: Run, made: Path) -> None:
    io.write(leitmotion.motion.joint_points(leitmotion.read(made / "jacks.bvh")), "points.npz")
    told = run("convert", "points.npz", made / "jacks.bvh", "-o", "out", "--to", "bvh")
    assert told.exit_code == 1
    assert told.stderr.startswith("points.npz: Error: A BVH holds a skeleton in motion")
    assert Path("out/jacks.bvh").exists()


# --- the second run


def test_a_second_run_does_only_what_is_left(run: Run, src: Path) -> None:
    run("convert", "src", "-o", "out", "--to", "npz")
    before, times = (
        content(Path("out")),
        {path: path.stat().st_mtime_ns for path in Path("out").rglob("*.npz")},
    )
    Path("out/one.npz").unlink()
    again = run("convert", "src", "-o", "out", "--to", "npz")
    assert again.stdout.splitlines()[-1] == "Converted 1 of 5; 2 failed, 2 skipped."
    assert content(Path("out")) == before
    assert {path.name for path, when in times.items() if path.stat().st_mtime_ns != when} == {"one.npz"}


def test_what_has_changed_is_done_anew(run: Run, src: Path, made: Path) -> None:
    run("convert", "src", "-o", "out", "--to", "npz")
    shutil.copy(made / "once.bvh", "src/one.bvh")
    told = run("convert", "src", "-o", "out", "--to", "npz")
    assert told.stdout.splitlines()[-1] == "Converted 1 of 5; 2 failed, 2 skipped."
    assert leitmotion.read("out/one.npz") == leitmotion.read(made / "once.bvh").replace(name="one")
    told = run("convert", "src", "-o", "out", "--to", "npz", "--fps", 10)
    assert told.stdout.splitlines()[-2:] == [
        "Converted 3 of 5; 2 failed, 0 skipped.",
        "Changed: rate of 3. With --json each is told.",
    ]
    assert leitmotion.read("out/one.npz").rate == 10.0


def test_another_skeleton_is_another_recording(run: Run, data: Path) -> None:
    shutil.copy(data / "cmu_amc" / "02_01.amc", "02_01.amc")
    shutil.copy(data / "cmu_amc" / "02.asf", "elsewhere.asf")
    call = ("convert", "02_01.amc[:5]", "-o", "out", "--to", "npz", "--json")
    skipped = []
    for _ in range(2):
        skipped.append(json.loads(run(*call).stdout)["result"]["skipped"])
    Path("02.asf").write_bytes(Path("elsewhere.asf").read_bytes().replace(b"length 7", b"length 6"))
    skipped.append(json.loads(run(*call).stdout)["result"]["skipped"])
    assert skipped == [False, True, False]


def test_a_frame_of_a_clip_in_files_of_their_own_is_a_change(run: Run) -> None:
    def frame(k: int, shift: float) -> None:
        numbers = [n for j in range(25) for n in (100 + 3 * j + shift, 200.0 + 5 * j, 0.9)]
        held = {"people": [{"pose_keypoints_2d": numbers}]}
        Path("clip").mkdir(exist_ok=True)
        Path(f"clip/duet_{k:012d}_keypoints.json").write_text(json.dumps(held), encoding="utf-8")

    for k in range(3):
        frame(k, float(k))
    call = ("convert", "clip", "-o", "out", "--to", "npz", "--rate", 30, "--json")
    first = json.loads(run(*call).stdout)
    assert first["result"]["written"] == [str(Path("out/duet.npz"))]
    assert json.loads(run(*call).stdout)["result"]["skipped"]
    frame(2, 9.0)
    assert not json.loads(run(*call).stdout)["result"]["skipped"]
    assert json.loads(run(*call).stdout)["result"]["skipped"]
    frame(3, 0.0)
    assert not json.loads(run(*call).stdout)["result"]["skipped"]


def test_an_archive_is_converted_as_a_folder_and_never_written_over(run: Run, src: Path) -> None:
    with zipfile.ZipFile("takes.zip", "w") as box:
        box.write("src/one.bvh", "deep/one.bvh")
        box.write("src/two.bvh", "two.bvh")
    told = run("convert", "takes.zip", "-o", "out", "--to", "npz")
    assert told.exit_code == 0, told.stderr
    assert sorted(content(Path("out"))) == [NAME, "deep/one.npz", "two.npz"]
    assert "2 skipped" in run("convert", "takes.zip", "-o", "out", "--to", "npz").stdout
    assert run("convert", "takes.zip/two.bvh", "-o", "two.npz").exit_code == 0
    assert Path("two.npz").read_bytes() == Path("out/two.npz").read_bytes()


def test_force_does_all_anew(run: Run, src: Path) -> None:
    run("convert", "src", "-o", "out", "--to", "npz")
    before = content(Path("out"))
    Path("out/one.npz").write_bytes(b"somebody else's")
    told = run("convert", "src", "-o", "out", "--to", "npz", "--force")
    assert content(Path("out")) == before
    assert "3 failed" not in told.stdout


def test_what_something_else_wrote_or_changed_stays(run: Run, src: Path) -> None:
    Path("out").mkdir()
    Path("out/one.npz").write_bytes(b"mine")
    told = run("convert", "src", "-o", "out", "--to", "npz")
    assert told.stdout.splitlines()[-1] == "Converted 2 of 5; 3 failed, 0 skipped."
    assert f"{Path('out/one.npz')} is there with other content. Replace it with --force." in told.stderr
    Path("out/two.npz").write_bytes(b"edited since")
    told = run("convert", "src", "-o", "out", "--to", "npz")
    assert told.stdout.splitlines()[-1] == "Converted 0 of 5; 4 failed, 1 skipped."
    assert Path("out/one.npz").read_bytes() == b"mine"
    assert Path("out/two.npz").read_bytes() == b"edited since"


def test_a_file_of_the_same_name_from_elsewhere_is_not_replaced(run: Run, src: Path, made: Path) -> None:
    run("convert", "src/one.bvh", "-o", "out", "--to", "npz")
    Path("other").mkdir()
    shutil.copy(made / "once.bvh", "other/one.bvh")
    told = run("convert", "other/one.bvh", "-o", "out", "--to", "npz")
    assert told.exit_code == 1
    assert "is there with other content" in told.stderr


def test_a_folder_inside_and_the_folder_itself_are_not_converted_again(run: Run, src: Path) -> None:
    for out in ("src/out", "src"):
        first = run("convert", "src", "-o", out, "--to", "npz")
        before = content(Path("src"))
        again = run("convert", "src", "-o", out, "--to", "npz")
        assert content(Path("src")) == before
        assert "Converted 0 of" in again.stdout
        shutil.rmtree("src/out", ignore_errors=True)
        assert first.stdout.splitlines()[-1] == "Converted 3 of 5; 2 failed, 0 skipped."


def test_an_input_is_never_written_over(run: Run, src: Path) -> None:
    before = content(src)
    told = run("convert", "src", "-o", "src", "--to", "bvh", "--force", "--fps", 5)
    assert told.stderr.count("is an input, and inputs are never written over.") == 3
    after = content(src)
    assert {name: after[name] for name in before} == before
    assert run("convert", "src/one.bvh", "-o", "src/one.bvh", "--force").exit_code == 2
    os.link("src/one.bvh", "same.bvh")
    assert run("convert", "src/one.bvh", "-o", "same.bvh", "--force").exit_code == 2


@pytest.mark.skipif(sys.platform != "linux", reason="names that only Linux lets a file have")
def test_odd_names(run: Run, made: Path) -> None:
    Path("src").mkdir()
    good = (made / "once.bvh").read_bytes()
    odd = [b"caf\xe9", b"n" * 245, b"new\nline", b"-dash", b"win[0:5]", b" blank ", b"a'\"b"]
    for name in odd:
        with open(b"src/" + name + b".bvh", "wb") as file:
            file.write(good)
    for form in ("npz", "bvh", "csv"):
        told = run("convert", "src", "-o", form, "--to", form, "--json")
        assert told.exit_code == 0, told.stdout
        assert "7 skipped" in run("convert", "src", "-o", form, "--to", form).stdout
        assert set(os.listdir(os.fsencode(form))) == {
            os.fsencode(NAME), *(b"%b.%b" % (name, form.encode()) for name in odd)
        }  # fmt: skip
    told = run("convert", "src/-dash.bvh", "-o", f"{'n' * 260}.npz")
    assert told.exit_code == 2
    assert "too long" in told.stderr


# --- the second run is as the first


def changed_window(call: list[object], made: Path) -> None:
    call[1] = "walk.bvh[10:20]"


def changed_source(call: list[object], made: Path) -> None:
    shutil.copy(made / "once.bvh", "walk.bvh")


def with_map(call: list[object], made: Path) -> None:
    Path("map.json").write_text('{"head": "Head"}', encoding="utf-8")
    call += ["--map", "map.json"]


def option(*words: object) -> Any:
    return lambda call, made: call.extend(words)


@pytest.mark.parametrize(
    "change",
    [
        changed_window,
        changed_source,
        with_map,
        option("--unit", "m"),
        option("--up", "z"),
        option("--fps", 10),
        option("--rate", 60),
        option("--person", "walk"),
        option("--out-unit", "m"),
        option(),
    ],
)
def test_what_is_skipped_is_what_a_run_by_force_would_write(run: Run, made: Path, change: Any) -> None:
    shutil.copy(made / "jacks.bvh", "walk.bvh")
    call: list[object] = ["convert", "walk.bvh", "-o", "out", "--to", "bvh"]
    assert run(*call).exit_code == 0
    change(call, made)
    told = run(*call)
    after = content(Path("out"))
    forced = run(*call, "--force")
    assert (told.exit_code, told.stderr) == (forced.exit_code, forced.stderr)
    assert content(Path("out")) == after


def test_another_window_into_the_same_folder_is_converted(run: Run, made: Path) -> None:
    for window, frames in (("[0:10]", 10), ("[10:30]", 20), ("", len(leitmotion.read(made / "jacks.bvh")))):
        told = run("convert", f"{made / 'jacks.bvh'}{window}", "-o", "out", "--to", "npz")
        assert told.exit_code == 0
        assert "was there already" not in told.stdout
        assert len(leitmotion.read("out/jacks.npz")) == frames
    assert "was there already" in run("convert", made / "jacks.bvh", "-o", "out", "--to", "npz").stdout


@pytest.mark.parametrize("before", [True, False])
def test_what_a_run_wrote_that_was_killed_is_no_input_of_the_next(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch, before: bool
) -> None:
    """Killed between the writing of a file and the note of it, or before the writing."""
    Path("src").mkdir()
    Path("src/duo.bvh").write_text(TWO, encoding="utf-8")
    shutil.copy(made / "jacks.bvh", "src/jacks.bvh")
    call = ("convert", "src", "-o", "src", "--to", "npz", "--unit", "cm", "--up", "y")
    write = io.write_whole

    def killed(path: Path, held: bytes, **options: Any) -> Path:
        if before or path.suffix != ".npz":
            raise SystemExit(137)
        write(path, held, **options)
        if path.name == "duo.Ben_1.npz":
            raise SystemExit(137)
        return path

    with monkeypatch.context() as patched:
        patched.setattr(io, "write_whole", killed)
        assert run(*call).exit_code == 137
    assert len(list(Path("src").glob("*.npz"))) == (0 if before else 2)
    assert run(*call).exit_code == 0
    again = content(Path("src"))
    assert [name for name in sorted(again) if name.endswith(".npz")] == [
        "duo.Anna.npz", "duo.Ben_1.npz", "jacks.npz",
    ]  # fmt: skip
    assert "0 failed, 2 skipped" in run(*call).stdout
    assert content(Path("src")) == again


# --- wrong usage, before any work


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ("src/one.bvh", "Missing option '-o'"),
        ("src/one.bvh -o x", "--to with one of c3d, bvh"),
        ("src/one.bvh -o x.fbx", "--to with one of c3d, bvh"),
        ("src/one.bvh -o -", "--to with one of c3d, bvh"),
        ("src/one.bvh -o x --to fbx", "'fbx' is no format that is written"),
        ("src -o x.npz", "Name a folder: -o x --to npz."),
        ("src/one.bvh -o x.npz --to bvh", "x.npz ends in .npz, but --to says bvh."),
        ("src/one.bvh -o x.npz --out-unit cm", "has a unit of its own"),
        ("src/one.bvh -o x.bvh --out-unit ell", "The unit must be one of"),
        ("src/one.bvh -o src/labels.csv/x --to npz", "is a file, not a folder"),
        ("src/one.bvh -o src/labels.csv --to npz", "labels.csv ends in .csv, but --to says npz."),
        ("src/one.bvh src/one.bvh -o x --to npz", "is named twice"),
        ("src/one.bvh -o - --to npz --json", "--json"),
        ("src/one.bvh src/two.bvh -o - --to npz", "there are 2"),
        ("src/one.bvh -o x --to npz --jobs 0", "--jobs"),
        ("src/one.bvh -o x.npz --fps nan", "--fps"),
    ],
)  # fmt: skip
def test_wrong_usage(run: Run, src: Path, arguments: str, complaint: str) -> None:
    before = content(Path())
    told = run("convert", *arguments.split())
    assert told.exit_code == 2
    assert complaint in told.stderr
    assert content(Path()) == before


# --- processes that are killed, and Ctrl-C


@POSIX
def test_a_process_that_is_killed_is_one_failure(
    run: Run, src: Path, processes: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "work", pieces.work_but_two_dies)
    told = run("convert", "src", "-o", "out", "--to", "npz", "--jobs", 2)
    assert told.exit_code == 1
    assert told.stdout.splitlines()[-1] == "Converted 2 of 5; 3 failed, 0 skipped."
    assert "src/two.bvh: Error: The process that converted src/two.bvh was ended by signal 9." in told.stderr
    assert sorted(content(Path("out"))) == [NAME, "deep er/drei é [1].npz", "one.npz"]


def begun(work: str, *arguments: str) -> subprocess.Popen[str]:
    """Start the program with other work to do, in a session of its own as a terminal would."""
    code = (
        "import signal, sys\n"
        "from cli import pieces\n"
        "from leitmotion.cli import convert, main\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"convert.work = pieces.{work}\n"
        "main(sys.argv[1:])"
    )
    paths = os.pathsep.join([str(TESTS), *sys.path])
    return subprocess.Popen(
        [sys.executable, "-c", code, "convert", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
        env=os.environ | {"PYTHONPATH": paths},
    )  # fmt: skip


def wait_until(true: Any, seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end
        time.sleep(0.02)


def gone(group: int) -> bool:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(group, 0)
        return False
    return True


@POSIX
def test_ctrl_c_stops_at_once_and_leaves_nothing_half_written_and_nobody_behind(run: Run, src: Path) -> None:
    with begun("endless_work", "src", "-o", "out", "--to", "npz", "-j", "2") as running:
        assert running.stdout is not None
        assert running.stderr is not None
        assert [running.stdout.readline() for _ in range(2)] == ["working\n"] * 2
        wait_until(lambda: len(content(Path("out"))) == 2)
        os.killpg(running.pid, signal.SIGINT)
        assert running.wait(timeout=60) == 130
        assert running.stderr.read().split() == ["Stopped."]
    wait_until(lambda: gone(running.pid))
    assert content(Path("out")) == {}


@POSIX
def test_killed_midway_and_run_again_is_as_one_run(run: Run, src: Path) -> None:
    for k in range(4):
        shutil.copy("src/one.bvh", f"src/more{k}.bvh")
    with begun("slow_work", "src", "-o", "out", "--to", "npz", "-j", "2") as running:
        wait_until(lambda: Path("out", NAME).exists())
        running.kill()
        running.wait()
        assert running.stdout is not None
        wait_until(lambda: gone(running.pid))
    assert 0 < len(list(Path("out").glob("*.npz"))) < 7
    told = run("convert", "src", "-o", "out", "--to", "npz")
    assert not told.stdout.splitlines()[-1].endswith(" 0 skipped.")
    run("convert", "src", "-o", "whole", "--to", "npz")
    assert content(Path("out")) == content(Path("whole"))
