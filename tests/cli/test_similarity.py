"""``leitmotion similarity``: what it prints, its documents, its tables, and what it refuses."""

import csv
import json
import re
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from cli import odd
from cli.conftest import Run
from cli.json_schema import faults
from leitmotion.cli import mirrored, postures

DOCS = Path(__file__).resolve().parents[2] / "docs" / "json.md"
SCHEMA = json.loads(re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[-1])


def rows_of(path: str) -> list[dict[str, str]]:
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_a_person_reads_the_figures(run: Run, made: Path) -> None:
    told = run("similarity", made / "jacks.bvh")
    assert (told.exit_code, told.stderr) == (0, "")
    assert re.match(r"\d+ moments compared with \d+\.\nshare alike ", told.stdout)
    assert "at most 0.054 body sizes apart" in told.stdout
    told = run("similarity", made / "jacks.bvh", "--symmetry", "--bias", "standing")
    assert re.match(r"Two postures are half alike at [\d.]+° a link, β = [\d.e+]+\.\n", told.stdout)
    assert re.search(
        r"The bias of the sides in the standing posture \(\d+ frames\) is taken out: ", told.stdout
    )


def test_the_figures_are_those_of_the_matrix(run: Run, made: Path) -> None:
    told = run("similarity", made / "jacks.bvh", made / "bad.bvh", "--json", "--features", "joint_angles")
    assert told.exit_code == 1
    document, failed = (json.loads(line) for line in told.stdout.splitlines())
    assert faults(document, SCHEMA) == faults(failed, SCHEMA) == []
    matrix = lm.compare(lm.read(made / "jacks.bvh"), features="joint_angles").values
    result = document["result"]
    assert result["moments"] == list(matrix.shape)
    assert result["share_alike"] == pytest.approx((matrix <= result["alike"]).mean(), abs=1e-4)
    assert result["median"] == pytest.approx(np.median(matrix), rel=1e-6)
    apart = np.abs(np.subtract.outer(np.arange(len(matrix)), np.arange(len(matrix)))) >= 30
    assert result["nearest"]["nearest_distance"] == pytest.approx(matrix[apart].min(), abs=1e-6)
    a, b = result["nearest"]["frame"], result["nearest"]["nearest_frame"]
    assert matrix[a, b] == matrix[apart].min()


def test_the_figures_of_the_mirror_are_those_of_both_matrices(run: Run, made: Path) -> None:
    call = ("similarity", made / "jacks.bvh", "--symmetry", "--metric", "geodesic", "--bias", "mean")
    document = json.loads(run(*call, "--json").stdout)
    assert faults(document, SCHEMA) == []
    found, every, bias, _ = lm.compare_with_mirror(
        lm.read(made / "jacks.bvh"), metric="geodesic", bias="mean"
    )
    result = document["result"]
    assert (result["moments"], result["frames_a_moment"]) == (len(found), every)
    assert result["half_alike_deg"] == pytest.approx(np.degrees(found.half))
    assert result["share_alike_to_mirror"] == pytest.approx((found.mirror <= found.half).mean(), abs=1e-4)
    assert result["lopsidedness_deg"]["mean"] == pytest.approx(
        np.degrees(found.lopsidedness).mean(), rel=1e-6
    )
    assert result["bias"]["angles_deg"]["left_tibia"] == pytest.approx(
        np.degrees(bias.angles[bias.names.index("left_tibia")]), abs=1e-4
    )
    assert [(one["start"], one["stop"]) for one in result["still"]] == [
        (start, stop) for start, stop, _, _ in lm.similarity.still_spans(found)
    ]


def test_the_tables_have_a_row_per_moment_of_each_input(run: Run, made: Path) -> None:
    both = made / "jacks.bvh", made / "once.bvh"
    assert run("similarity", *both, "-o", "near.csv").exit_code == 0
    assert run("similarity", *both, "--symmetry", "-o", "mirror.csv").exit_code == 0
    near, mirror = rows_of("near.csv"), rows_of("mirror.csv")
    assert tuple(near[0]) == postures.COLUMNS
    assert tuple(mirror[0]) == mirrored.COLUMNS
    recordings = [lm.read(path) for path in both]
    assert len(near) == len(mirror) == sum(len(one) for one in recordings)
    later = len(recordings[0]) + 12
    assert (near[later]["path"], near[later]["frame"]) == (str(both[1]), "12")
    matrix = lm.compare(recordings[1]).values
    assert float(near[later]["nearest_distance"]) == pytest.approx(matrix[12, 42:].min(), abs=1e-6)
    found = lm.compare_with_mirror(recordings[1]).distances
    lopsided = np.degrees(lm.similarity.link_angle(found.lopsidedness[12], found.metric))
    assert float(mirror[later]["lopsidedness_deg"]) == pytest.approx(lopsided, abs=1e-4)
    assert {row["still"] for row in mirror} == {"0", "1"}
    assert run("similarity", *both, "-o", "near.csv").exit_code == 0  # it is ours
    assert run("similarity", *both, "--symmetry", "-o", "mirror.csv").exit_code == 0


def test_the_matrices_are_saved_and_drawn(run: Run, made: Path) -> None:
    jacks = made / "jacks.bvh"
    for _ in "ab":  # the second is written over the first
        assert run("similarity", jacks, "-o", "own.npz").exit_code == 0
        assert run("similarity", jacks, "--symmetry", "-o", "both.npz").exit_code == 0
    assert lm.load("own.npz") == lm.compare(lm.read(jacks))
    assert lm.load("both.npz") == lm.compare_with_mirror(lm.read(jacks)).distances
    for form in ("square", "triangle"):
        assert run("similarity", jacks, "--symmetry", "--form", form, "-o", f"{form}.svg").exit_code == 0
    assert Path("square.svg").read_text(encoding="utf-8") != Path("triangle.svg").read_text(encoding="utf-8")
    assert run("similarity", jacks, "-o", "own.png").exit_code == 0
    assert Path("own.png").read_bytes().startswith(b"\x89PNG")


def test_another_recording_is_compared_with(run: Run, made: Path) -> None:
    jacks, once = made / "jacks.bvh", made / "once.bvh"
    document = json.loads(run("similarity", jacks, "--against", f"{once}[10:40]", "--json").stdout)
    assert faults(document, SCHEMA) == []
    assert [source["path"] for source in document["source"]] == [str(jacks), f"{once}[10:40]"]
    matrix = lm.compare(lm.read(jacks), lm.read(once)[10:40])
    assert document["result"]["moments"] == list(matrix.values.shape)
    assert document["result"]["nearest"]["nearest_distance"] == pytest.approx(matrix.values.min(), abs=1e-6)
    assert run("similarity", jacks, "--against", once, "-o", "both.png").exit_code == 0
    told = run("similarity", jacks, "--against", "nowhere.bvh")
    assert (told.exit_code, told.stderr) == (1, "Error: There is no file nowhere.bvh.\n")
    lm.save(lm.read(once), "once.npz")
    told = run("similarity", jacks, "--against", "once.npz", "-o", "once.npz", "--force")
    assert (told.exit_code, lm.load("once.npz")) == (2, lm.read(once))
    assert "once.npz is an input, and inputs are never written over." in told.stderr


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["--form", "triangle"], "--form belongs to --symmetry."),
        (["--beta", "3"], "--beta belongs to --symmetry."),
        (["--symmetry", "--features", "velocity"], "--features does not go with --symmetry"),
        (["--symmetry", "--against", "x.bvh"], "--against does not go with --symmetry"),
        (["--against", "x.bvh", "--weights", "active"], "--against does not go with --weights active."),
        (["--against", "x.bvh", "--features", "joint_rotations"], "does not go with --features joint_rotations"),
    ],
)  # fmt: skip
def test_options_that_do_not_go_together(run: Run, made: Path, options: list[str], sentence: str) -> None:
    told = run("similarity", made / "jacks.bvh", *options)
    assert told.exit_code == 2
    assert sentence in told.stderr


def test_one_file_holds_one_matrix(run: Run, made: Path) -> None:
    told = run("similarity", made / "jacks.bvh", made / "once.bvh", "-o", "both.npz")
    assert told.exit_code == 2
    assert "both.npz holds one matrix, but there are 2 recordings" in told.stderr


def test_odd_recordings_are_answered_or_refused_in_a_sentence(run: Run, made: Path, tmp_path: Path) -> None:
    jacks = made / "jacks.bvh"
    flat = odd.planar(tmp_path / "flat.npz", lm.read(jacks))
    told = run("similarity", flat, "--symmetry")
    planar = "Error: The kinematic chain needs joints in three dimensions, got two. "
    assert (told.exit_code, told.stderr.count("\n")) == (1, 1)
    assert told.stderr.startswith(f"{planar}Give the same movement with its depth.")
    assert run("similarity", flat).exit_code == 0
    for frames in (1, 10):
        for mode in ((), ("--symmetry",)):
            told = run("similarity", f"{jacks}[0:{frames}]", *mode, "-o", f"few{frames}.csv", "--force")
            assert told.exit_code == 0, told.stderr
            assert len(rows_of(f"few{frames}.csv")) == frames
    gaps = odd.with_gaps(tmp_path / "gaps.npz", lm.read(jacks))
    document = json.loads(run("similarity", gaps, "--symmetry", "--json").stdout)
    assert faults(document, SCHEMA) == []
    assert all(one["stop"] <= 20 or one["start"] >= 40 for one in document["result"]["still"])
    told = run("similarity", odd.hands_only(tmp_path / "hands.npz"), "--symmetry")
    assert told.exit_code == 1
    assert told.stderr.startswith(
        "Error: The kinematic chain begins with the trunk, but no pelvis is known among "
    )
    assert told.stderr.count("\n") == 1


def test_a_folder_and_standard_input_are_inputs(run: Run, made: Path) -> None:
    told = run("similarity", made, "--symmetry", "--json", "-o", "all.json")
    assert told.exit_code == 1  # two of its files are broken
    assert ["error" in json.loads(line) for line in told.stdout.splitlines()] == [True, True, False, False]
    content = (made / "jacks.bvh").read_bytes()
    document = json.loads(run("similarity", "-", "--json", stdin=content).stdout)
    assert document["source"][0]["path"] == "-"
