"""Which recordings an argument means."""

import gzip
import hashlib
import io
import json
import lzma
import os
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from cli.conftest import Run
from fuzzing.seeds import SEEDS, taped, zipped
from leitmotion.cli.inputs import Input, expand

ENDINGS = (".bvh", ".amc", ".csv")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in (
        "b.bvh",
        "A.BVH",
        "deep/er/c.amc",
        "deep/a.bvh",
        ".hidden/d.bvh",
        ".e.bvh",
        "notes.md",
        "labels.csv",
    ):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("x", encoding="utf-8")
    return tmp_path


def shown(*arguments: str) -> list[str]:
    with expand(arguments, ENDINGS) as inputs:
        return [given.shown for given in inputs]


def test_files_stay_in_the_order_given_even_when_they_are_not_there() -> None:
    assert shown("z.bvh", "a.bvh", "z.bvh") == ["z.bvh", "a.bvh", "z.bvh"]


def test_a_folder_is_searched_through_in_alphabetical_order_without_what_is_hidden(folder: Path) -> None:
    names = ["A.BVH", "b.bvh", "labels.csv", "deep/a.bvh", "deep/er/c.amc"]
    assert shown(str(folder)) == [str(folder / name) for name in names]


def test_only_what_may_be_something_else_is_doubtful(folder: Path) -> None:
    with expand([str(folder), str(folder / "labels.csv")], ENDINGS) as inputs:
        assert [given.path.name for given in inputs if given.doubtful] == ["labels.csv"]
        assert not inputs[-1].doubtful


def test_a_window_of_a_folder_is_a_window_of_each_file(folder: Path) -> None:
    assert shown(f"{folder / 'deep'}[1s:2s]") == [
        f"{folder / 'deep' / 'a.bvh'}[1s:2s]",
        f"{folder / 'deep' / 'er' / 'c.amc'}[1s:2s]",
    ]


def test_a_window_of_a_file_is_kept_for_its_reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("clip.bvh").touch()
    with expand(["clip.bvh[100:400]"], ENDINGS) as inputs:
        assert inputs == [Input("clip.bvh[100:400]", Path("clip.bvh"), "[100:400]")]
        assert inputs[0].source == "clip.bvh[100:400]"
        assert inputs[0].name == "clip"


def test_a_folder_without_recordings_stands_in_the_answer_with_its_fault(tmp_path: Path) -> None:
    (tmp_path / "notes.md").touch()
    with expand([str(tmp_path)], ENDINGS) as inputs:
        assert len(inputs) == 1
        assert inputs[0].fault is not None
        assert "holds no recordings" in inputs[0].fault.message
        assert ".amc, .bvh, .csv" in inputs[0].fault.remedy


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="root may read everything")
def test_a_folder_that_may_not_be_read_is_told(folder: Path) -> None:
    closed = folder / "deep"
    closed.chmod(0)
    try:
        with expand([str(folder)], ENDINGS) as inputs:
            faults = [given.fault.message for given in inputs if given.fault is not None]
    finally:
        closed.chmod(0o755)
    assert faults == [f"{closed}: Permission denied."]


def test_standard_input_is_a_copy_that_goes_away(monkeypatch: pytest.MonkeyPatch) -> None:
    content = b"HIERARCHY\nROOT Hips"
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(content)))
    with expand(["-"], ENDINGS) as inputs:
        assert [given.shown for given in inputs] == ["-"]
        assert inputs[0].path.read_bytes() == content
        assert inputs[0].sha256() == hashlib.sha256(content).hexdigest()
        assert inputs[0].name == "stdin"
        copy = inputs[0].path
    assert not copy.exists()


@pytest.mark.parametrize(
    "typed", [["info", ""], ["patterns", ""], ["report", "jacks.bvh", ""], ["demo", "--data", ""]]
)
def test_an_empty_name_is_wrong_usage_and_not_the_current_folder(run: Run, typed: list[str]) -> None:
    Path("dance.bvh").touch()
    told = run(*typed)
    assert told.exit_code == 2
    assert "No input named" in told.stderr
    assert told.stdout == ""


BVH = SEEDS["BVH of a skeleton"]()["clip.bvh"]


@pytest.fixture
def packed(tmp_path: Path) -> Path:
    """A folder with a compressed clip, an archive of several, one of one, one of none and a damaged one."""
    folder = tmp_path / "packed"
    folder.mkdir()
    (folder / "b.bvh.gz").write_bytes(gzip.compress(BVH))
    (folder / "several.zip").write_bytes(
        zipped({"z.bvh": BVH, "deep/a.bvh": BVH, "labels.csv": b"x", "__MACOSX/._z.bvh": b"x"})
    )
    (folder / "one.zip").write_bytes(zipped({"deep/clip.bvh": BVH, "read.me": b"x"}))
    (folder / "none.zip").write_bytes(zipped({"read.me": b"x", "licence.md": b"x"}))
    (folder / "bad.zip").write_bytes(b"PK")
    return folder


def test_an_archive_stands_for_its_recordings_as_a_folder_does(packed: Path) -> None:
    several = packed / "several.zip"
    with expand([f"{several}[0:9]"], ENDINGS) as inputs:
        names = ["labels.csv", "z.bvh", "deep/a.bvh"]
        assert [given.shown for given in inputs] == [f"{several / name}[0:9]" for name in names]
        assert [given.doubtful for given in inputs] == [True, False, False]
        assert [given.name for given in inputs] == ["labels", "z", "a"]
        assert {given.sha256() for given in inputs} == {hashlib.sha256(several.read_bytes()).hexdigest()}


def test_an_archive_of_one_recording_is_it(packed: Path) -> None:
    with expand([str(packed / "one.zip")], ENDINGS) as inputs:
        assert [(given.shown, given.name) for given in inputs] == [(str(packed / "one.zip"), "clip")]


def test_a_folder_is_searched_for_what_is_packed_too(packed: Path) -> None:
    found = ["b.bvh.gz", "one.zip", "several.zip/labels.csv", "several.zip/z.bvh", "several.zip/deep/a.bvh"]
    with expand([str(packed)], ENDINGS) as inputs:
        assert [given.shown for given in inputs] == [str(packed / name) for name in found]
        assert [given.name for given in inputs][:2] == ["b", "clip"]


@pytest.mark.parametrize(
    ("name", "match"),
    [("none.zip", "holds no recordings, but files ending in .md, .me"), ("bad.zip", "damaged")],
)
def test_an_archive_of_nothing_stands_in_the_answer_with_its_fault(
    packed: Path, name: str, match: str
) -> None:
    with expand([str(packed / name)], ENDINGS) as inputs:
        assert len(inputs) == 1
        assert inputs[0].fault is not None
        assert match in inputs[0].fault.message


def test_what_is_piped_may_be_packed(run: Run, packed: Path) -> None:
    shown = {"b.bvh.gz": ["-"], "one.zip": ["-"], "several.zip": ["-/z.bvh", "-/deep/a.bvh"]}
    for name, expected in shown.items():
        told = run("info", "-", "--json", "--quiet", stdin=(packed / name).read_bytes())
        documents = [json.loads(line) for line in told.stdout.splitlines()]
        assert [document["source"][0]["path"] for document in documents] == expected
        assert {document["source"][0]["frames"] for document in documents} == {12}
        sums = {document["source"][0]["sha256"] for document in documents}
        assert sums == {hashlib.sha256((packed / name).read_bytes()).hexdigest()}


def test_what_is_piped_without_end_is_refused(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("leitmotion.cli.inputs.MOST_PIPED", 1 << 20)
    told = run("info", "-", stdin=b"0" * (4 << 20))
    assert told.exit_code == 1
    assert "Standard input goes on beyond" in told.stderr


def test_files_that_are_one_recording_together_are_one_input(tmp_path: Path) -> None:
    for name in ("c_2_keypoints.json", "c_1_keypoints.json", "c_10_keypoints.json"):
        (tmp_path / "clip").mkdir(exist_ok=True)
        (tmp_path / "clip" / name).write_text("{}", encoding="utf-8")
    with expand([f"{tmp_path / 'clip'}[1:2]"], (".json", ".txt")) as inputs:
        assert [(given.shown, given.source) for given in inputs] == [
            (f"{tmp_path / 'clip'}[1:2]", f"{tmp_path / 'clip' / 'c_1_keypoints.json'}[1:2]")
        ]
        assert inputs[0].name == "c"
        assert inputs[0].sha256() == hashlib.sha256(b"{}" * 3).hexdigest()
    for kind in ("Positions", "Angles"):
        (tmp_path / kind).mkdir()
        (tmp_path / kind / f"m01_{kind.lower()}.txt").write_text("1", encoding="utf-8")
    with expand([str(tmp_path)], (".json", ".txt")) as inputs:
        assert [given.path.name for given in inputs] == ["m01_positions.txt", "c_1_keypoints.json"]
        assert all(given.doubtful for given in inputs)


def test_what_is_not_there_is_told_alike_by_every_verb(run: Run, made: Path) -> None:
    for call in (
        ("patterns", "nowhere"),
        ("patterns", "nowhere", "--across"),
        ("info", "nowhere/"),
        ("convert", "nowhere", "-o", "out", "--to", "npz"),
        ("calibrate", "nowhere"),
        ("evaluate", "patterns", "nowhere", "found.json"),
    ):
        told = run(*call)
        assert told.exit_code == 1
        assert "Error: There is no file or folder nowhere." in told.stderr
    assert run("patterns", "nowhere.bvh").stderr == "Error: There is no file nowhere.bvh.\n"


def test_a_tar_archive_stands_for_its_recordings_as_a_zip_archive_does(run: Run) -> None:
    Path("all").mkdir()
    clips = {"./z.bvh": BVH, "./deep/a.bvh": BVH, "./read.me": b"x"}
    Path("all/pack.tar.xz").write_bytes(lzma.compress(taped(clips)))
    names = [f"{Path('all/pack.tar.xz')}/z.bvh", f"{Path('all/pack.tar.xz')}/deep/a.bvh"]
    for named in ("all", "all/pack.tar.xz"):
        told = run("info", named, "--json")
        assert [json.loads(line)["source"][0]["path"] for line in told.stdout.splitlines()] == names
    assert run("info", "-", "--json", stdin=Path("all/pack.tar.xz").read_bytes()).stdout.count("\n") == 2
    run("convert", "all", "-o", "made", "--to", "npz")
    assert sorted(path.as_posix() for path in Path("made").rglob("*.npz")) == [
        "made/pack/deep/a.npz", "made/pack/z.npz"
    ]  # fmt: skip
