"""``leitmotion repair``: what is chosen is done and told, nothing else; inputs stay as they are."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import leitmotion as lm
from cli.conftest import Run
from cli.json_schema import faults
from cli.test_contract import schema  # noqa: F401
from leitmotion.motion import joint_points


@pytest.fixture(scope="module")
def hurt(made: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a recording of points that has a gap, a spike and a repeated frame, and one that has none."""
    folder = tmp_path_factory.mktemp("hurt")
    points = joint_points(lm.read(made / "jacks.bvh"))
    lm.write(points, folder / "deep" / "clean.npz")
    positions = points.positions.copy()
    positions[40:44, 3] = np.nan
    positions[60, 5] += 0.5
    positions[80] = positions[79]
    lm.write(points.replace(positions=positions), folder / "hurt.npz")
    return folder


def result(told: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(told.stdout)["result"]
    return found


def test_nothing_chosen_is_answered_with_what_would_help(run: Run, hurt: Path) -> None:
    told = run("repair", hurt / "hurt.npz", "-o", "out.npz")
    assert told.exit_code == 0
    assert not Path("out.npz").exists()
    assert f"leitmotion repair {hurt / 'hurt.npz'} --duplicates --spikes --fill" in told.stdout
    assert "No problem was found" in run("repair", hurt / "deep" / "clean.npz").stdout


def test_what_is_suggested_can_be_typed_and_leaves_no_problem(run: Run, hurt: Path) -> None:
    suggestion = result(run("repair", hurt / "hurt.npz", "--json"))["suggestion"]
    assert run(*suggestion.split()[1:]).exit_code == 0
    assert run("repair", "hurt-repaired.npz").stdout.endswith("No problem was found that one would mend.\n")


def test_every_change_is_told_and_nothing_else_changes(
    run: Run,
    hurt: Path,
    schema: dict[str, Any],  # noqa: F811
) -> None:
    before = (hurt / "hurt.npz").read_bytes()
    told = run("repair", hurt / "hurt.npz", "--fill", "linear", "--json", "-o", "out.npz")
    assert told.exit_code == 0
    assert faults(json.loads(told.stdout), schema) == []
    found = result(told)
    assert found["written"] == "out.npz"
    ((what, joint, start, stop),) = {
        (one["what"], one["joint"], one["stretch"]["start"], one["stretch"]["stop"])
        for one in found["changes"]
    }
    assert (what, start, stop, found["changes"][0]["frames"]) == ("fill", 40, 44, 4)
    was, now = lm.read(hurt / "hurt.npz"), lm.read("out.npz")
    differs = (was.positions != now.positions).any(axis=2)
    assert np.argwhere(differs).tolist() == [[k, was.names.index(joint)] for k in range(40, 44)]
    assert (hurt / "hurt.npz").read_bytes() == before


def test_how_it_was_read_is_said_again(run: Run, hurt: Path) -> None:
    entries = Path("my map.json")
    entries.write_text(json.dumps({"head": "Head", "left_knee": "LeftLeg"}), encoding="utf-8")
    path = hurt / "hurt.npz"
    told = run("repair", path, "--rate", "30", "--map", entries, "--json")
    assert result(told)["suggestion"].startswith(
        f"leitmotion repair {path} --rate 30.0 --map 'my map.json' --duplicates"
    )
    (problem,) = [
        one
        for one in result(run("info", path, "--map", entries, "--json"))["problems"]
        if one["what"] == "roles"
    ]
    assert problem["command"] == f"leitmotion info {path} --map roles.json"


def test_without_an_output_it_tells_what_would_change(run: Run, hurt: Path) -> None:
    told = run("repair", hurt / "hurt.npz", "--spikes", "--duplicates")
    assert told.stdout.startswith("2 changes; nothing was written: name a file with -o.\n")
    assert list(Path().iterdir()) == []
    assert "duplicate" in told.stdout
    assert "spike" in told.stdout


def test_a_folder_keeps_its_order(run: Run, hurt: Path) -> None:
    told = run("repair", hurt, "--fill", "spline", "-o", "out")
    assert told.exit_code == 0
    assert sorted(path.relative_to("out").as_posix() for path in Path("out").rglob("*.npz")) == [
        "deep/clean.npz", "hurt.npz",
    ]  # fmt: skip
    again = run("repair", hurt, "--fill", "spline", "-o", "out")
    assert again.exit_code == 0
    other = run("repair", hurt, "--spikes", "-o", "out")
    assert other.exit_code == 1
    assert "hurt.npz is there with other content. Replace it with --force." in other.stderr
    assert run("repair", hurt, "--spikes", "-o", "out", "--force").exit_code == 0
    clean = hurt / "deep" / "clean.npz"
    assert lm.read("out/deep/clean.npz") == lm.read(clean)


def test_a_file_of_other_content_stays_unless_by_force(run: Run, hurt: Path) -> None:
    Path("victim.npz").write_bytes(b"somebody else's")
    call = ("repair", hurt / "hurt.npz", "--spikes", "-o", "victim.npz")
    told = run(*call)
    assert told.exit_code == 1
    assert "victim.npz is there with other content. Replace it with --force." in told.stderr
    assert Path("victim.npz").read_bytes() == b"somebody else's"
    for force in ("--force", "--json"):  # the second finds what the first wrote
        assert run(*call, force).exit_code == 0
    assert lm.read("victim.npz").names == lm.read(hurt / "hurt.npz").names


def test_what_the_format_does_not_keep_is_told(run: Run, hurt: Path) -> None:
    told = run("repair", hurt / "hurt.npz", "--spikes", "-o", "out.trc", "--json")
    assert json.loads(told.stdout)["warnings"] == ["out.trc: Points of kind joint became markers."]


def test_inputs_that_differ_in_their_ending_keep_it(run: Run, hurt: Path) -> None:
    Path("in").mkdir()
    points = lm.read(hurt / "hurt.npz")
    for ending in ("npz", "trc"):
        lm.write(points, f"in/hurt.{ending}")
    assert run("repair", "in", "--spikes", "-o", "out").exit_code == 0
    assert sorted(path.name for path in Path("out").iterdir()) == ["hurt.npz", "hurt.trc"]


def test_sides_are_swapped_in_what_is_written(run: Run, hurt: Path, made: Path) -> None:
    assert run("repair", made / "jacks.bvh", "--swap-sides", "-o", "swapped.bvh").exit_code == 0
    assert run("repair", "swapped.bvh", "--swap-sides", "-o", "back.bvh").exit_code == 0
    assert lm.read("back.bvh").skeleton.names == lm.read(made / "jacks.bvh").skeleton.names
    assert lm.read("swapped.bvh").skeleton.names != lm.read(made / "jacks.bvh").skeleton.names
    part = run("repair", hurt / "hurt.npz", "--swap-sides", "--frames", "10:20", "--json")
    assert result(part)["changes"][0]["stretch"]["stop"] == 20


def test_the_sides_of_an_analysis_are_swapped_and_the_recording_is_not(run: Run, made: Path) -> None:
    one, other = (
        json.loads(run(verb, made / "jacks.bvh", "--json", "--swap-sides").stdout)
        for verb in ("info", "patterns")
    )
    plain = json.loads(run("info", made / "jacks.bvh", "--json").stdout)
    members = {role["role"]: role["members"] for role in one["result"]["roles"]}
    assert members["left_knee"] == next(
        role["members"] for role in plain["result"]["roles"] if role["role"] == "right_knee"
    )
    assert one["parameters"]["swap_sides"] is other["parameters"]["swap_sides"] is True
    assert one["result"]["skeleton"] == plain["result"]["skeleton"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--frames", "3:9"), "give --swap-sides as well"),
        (("--max-gap", "1"), "give --fill as well"),
        (("--swap-sides", "--frames", "9:3"), "no stretch of frames such as 120:180"),
        (("--filter", "six"), "neither a number of hertz nor auto"),
        (("--fill", "magic"), "is not one of"),
        (("--spikes", "-o", "out.pdf"), "end it in"),
        (("--spikes", "-o", "."), "is an input"),
    ],
)
def test_wrong_usage(run: Run, hurt: Path, words: tuple[str, ...], sentence: str) -> None:
    Path("hurt.npz").write_bytes((hurt / "hurt.npz").read_bytes())
    told = run("repair", "hurt.npz", *words)
    assert told.exit_code == 2
    assert sentence in " ".join(told.stderr.split())


def test_what_cannot_be_done_is_said_in_its_place(run: Run, made: Path, hurt: Path) -> None:
    told = run("repair", made / "jacks.bvh", hurt / "hurt.npz", "--fill", "linear", "--json")
    assert told.exit_code == 1
    first, second = (json.loads(line) for line in told.stdout.splitlines())
    assert "is a skeleton, and fill mends points alone" in first["error"]["message"]
    assert second["result"]["changes"][0]["what"] == "fill"
