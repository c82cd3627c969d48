"""``leitmotion calibrate``: the threshold, its curves, and how it is used."""

import csv
import json
import re
from pathlib import Path

import pytest

import leitmotion as lm
from cli.conftest import Run
from cli.json_schema import faults
from leitmotion.cli.options import Options

DOCS = Path(__file__).resolve().parents[2] / "docs" / "json.md"


@pytest.fixture
def pairs(made: Path, tmp_path: Path) -> Path:
    """Pairs of the person who jumps: a frame apart, and a quarter of a second."""
    rows = [f"{made / 'jacks.bvh'},{k},{made / 'jacks.bvh'},{k + 1},1,fit" for k in range(30, 90, 3)]
    rows += [f"{made / 'jacks.bvh'},{k},{made / 'jacks.bvh'},{k + 8},0,fit" for k in range(30, 90, 3)]
    rows += [row.replace("fit", "check") for row in rows[::2]]
    table = tmp_path / "pairs.csv"
    table.write_text(
        "recording_a,frame_a,recording_b,frame_b,alike,group\n" + "\n".join(rows) + "\n", encoding="utf-8"
    )
    return table


def test_the_answer_and_how_to_use_it(run: Run, made: Path, pairs: Path) -> None:
    told = run("calibrate", pairs, "--group", "fit", "--check", "check", "--features", "joint_angles")
    assert told.exit_code == 0, told.stderr
    assert re.match(r"Postures at most [\d.]+ radians apart are alike\.", told.stdout)
    for words in ("equal error rate", "of 20 pairs alike and 20 not", "error of the check group"):
        assert words in told.stdout
    command = (
        told.stdout.splitlines()[-1].partition("leitmotion ")[2].replace("INPUT", str(made / "jacks.bvh"))
    )
    used = run(*command.split(), "--json")
    assert used.exit_code == 0, used.stderr
    parameters = json.loads(used.stdout)["parameters"]
    found = lm.calibrate(pairs, group="fit", features="joint_angles")
    assert parameters["max_distance"] == pytest.approx(found.threshold, rel=0.01)
    assert parameters["feature"] == "joint_angles"


def test_the_document_fits_its_schema(run: Run, pairs: Path, made: Path) -> None:
    schema = json.loads(re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[-1])
    for options in (["--group", "fit"], ["--check", "check", "--weights", "active"]):
        document = json.loads(run("calibrate", pairs, *options, "--json").stdout)
        assert faults(document, schema) == []
        (source,) = document["source"]
        assert source["path"] == str(made / "jacks.bvh")
        result = document["result"]
        found = lm.calibrate(pairs, group="fit", weights=document["parameters"]["weights"])
        assert result["threshold"] == pytest.approx(found.threshold, abs=1e-6)
        assert len(result["curve"]) == len(found.thresholds)
        assert (result["check"] is None) == ("--check" not in options)


def test_a_table_without_recordings_has_its_recording_beside_it(run: Run, made: Path, tmp_path: Path) -> None:
    (tmp_path / "short.csv").write_text("frame_a,frame_b,alike\n40,41,1\n40,48,0\n", encoding="utf-8")
    assert run("calibrate", "short.csv", made / "jacks.bvh").exit_code == 0
    alone = run("calibrate", "short.csv")
    assert alone.exit_code == 1
    assert alone.stderr.startswith("Error: The pairs name no recordings.")


def test_a_few_pairs_are_told_to_settle_nothing(run: Run, made: Path, pairs: Path, tmp_path: Path) -> None:
    few = "settle no threshold, however narrow the interval: label about a hundred of each."
    (tmp_path / "short.csv").write_text("frame_a,frame_b,alike\n40,41,1\n40,48,0\n", encoding="utf-8")
    told = run("calibrate", "short.csv", made / "jacks.bvh")
    assert f"Note: So few pairs, 1 alike and 1 not, {few}" in told.stderr
    assert "of 1 pair alike and 1 not" in told.stdout
    assert few not in run("calibrate", pairs, "--group", "fit").stderr  # twenty of each


@pytest.mark.parametrize("ending", [".png", ".svg", ".pdf"])
def test_picture(run: Run, pairs: Path, ending: str) -> None:
    assert run("calibrate", pairs, "-o", f"curve{ending}").exit_code == 0
    assert Path(f"curve{ending}").stat().st_size > 2000


def test_tables_hold_the_curve(run: Run, pairs: Path) -> None:
    assert run("calibrate", pairs, "-o", "curve.csv").exit_code == 0
    assert run("calibrate", pairs, "-o", "curve.json").exit_code == 0
    with open("curve.csv", encoding="utf-8", newline="") as file:
        rows = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(file)]
    assert rows == json.loads(Path("curve.json").read_text(encoding="utf-8"))["result"]["curve"]


def test_faults_are_sentences(run: Run, made: Path, pairs: Path) -> None:
    pairs.write_text(pairs.read_text(encoding="utf-8").replace(",33,", ",3300,", 1), encoding="utf-8")
    told = run("calibrate", pairs, "--json")
    assert told.exit_code == 1
    assert "frame 3300 is outside of" in json.loads(told.stdout)["error"]["message"]
    assert run("calibrate", "nowhere.csv").exit_code == 1
    assert run("calibrate", made).exit_code == 2
    assert run("calibrate", pairs, "-o", "curve.xyz").exit_code == 2
    assert run("calibrate", pairs, "-o", pairs).exit_code == 2


def test_what_is_calibrated_steers_the_search(run: Run, made: Path) -> None:
    document = json.loads(
        run("patterns", made / "jacks.bvh", "--max-distance", "0.06", "--weights", "active", "--json").stdout
    )
    assert document["parameters"]["max_distance"] == 0.06
    assert document["parameters"]["weights"] == "active"
    paper = json.loads(
        run("patterns", made / "jacks.bvh", "--method", "tang2008", "--threshold", "0.2", "--json").stdout
    )
    assert paper["parameters"]["threshold"] == 0.2
    for options in (["--threshold", "0.2"], ["--method", "tang2008", "--max-distance", "0.1"]):
        told = run("patterns", made / "jacks.bvh", *options)
        assert told.exit_code == 2
        assert "belongs to --method" in told.stderr


@pytest.mark.parametrize("features", ["joint_angles", "joint_rotations", "velocity"])
def test_every_feature_is_searched_and_shown(run: Run, made: Path, features: str) -> None:
    told = run("report", made / "jacks.bvh", "--features", features, "-o", "page.html")
    assert told.exit_code == 0, told.stderr
    assert Path("page.html").stat().st_size > 10000
    left_over = run("patterns", made / "jacks.bvh", "--features", features, "--residual", "--json")
    assert "residual" in json.loads(left_over.stdout)["result"]


def test_the_features_that_may_be_typed_are_those_there_are() -> None:
    from leitmotion.cli.patterns import patterns
    from leitmotion.describing import WEIGHTS

    choices = {option.name: option.type for option in patterns.params}
    assert tuple(choices["features"].choices) == tuple(lm.features.FEATURES)
    assert tuple(choices["weights"].choices) == WEIGHTS
    assert Options().features == "posture"


@pytest.mark.data
def test_recordings_within_a_solid_archive_are_read(run: Run, data: Path) -> None:
    inside = "hdm05/hdm05_bd_bk_dg.tar.xz/squat1Reps/HDM_dg_squat1Reps_035_120.amc"
    rows = [
        f"{inside},{a},{inside},{b},{alike}"
        for a, b, alike in ((5, 9, 1), (7, 12, 1), (5, 90, 0), (9, 99, 0))
    ]
    table = "recording_a,frame_a,recording_b,frame_b,alike\n" + "\n".join(rows)
    Path("pairs.csv").write_text(table, encoding="utf-8")
    told = run("calibrate", "pairs.csv", "--folder", data)
    assert told.exit_code == 0, told.stderr
    assert told.stdout.startswith("Postures at most ")


def test_what_is_odd_about_a_recording_is_told_with_its_name(run: Run, made: Path) -> None:
    content = (made / "jacks.bvh").read_bytes()
    Path("cut.bvh").write_bytes(content[: len(content) * 9 // 10])
    Path("pairs.csv").write_text("frame_a,frame_b,alike\n0,1,1\n0,2,1\n0,60,0\n0,65,0\n", encoding="utf-8")
    told = run("calibrate", "pairs.csv", "cut.bvh", "--json")
    warnings = json.loads(told.stdout)["warnings"]
    assert any(each.startswith("cut.bvh: The file ends within its row ") for each in warnings)


def test_the_recording_of_the_pairs_is_never_written_over(run: Run, made: Path) -> None:
    lm.write(lm.read(made / "jacks.bvh"), "jacks.csv")
    content = Path("jacks.csv").read_bytes()
    Path("pairs.csv").write_text("frame_a,frame_b,alike\n0,1,1\n0,2,1\n0,60,0\n0,65,0\n", encoding="utf-8")
    told = run("calibrate", "pairs.csv", "jacks.csv[0:90]", "-o", "jacks.csv", "--force")
    assert told.exit_code == 2
    assert "jacks.csv is an input" in told.stderr
    assert Path("jacks.csv").read_bytes() == content
