"""``leitmotion patterns --lesson``: what to learn first, and how each time differs."""

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest

import leitmotion as lm
from cli.conftest import Run
from cli.json_schema import faults
from cli.test_contract import schema  # noqa: F401


def rows(path: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(Path(path).read_text(encoding="utf-8"))))


def test_the_typical_time_then_the_others(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--lesson")
    assert told.exit_code == 0
    assert told.stderr == ""
    assert told.stdout.startswith("1 movement to learn, most frequent first.\n\n1. A, four times, ")
    assert " Typical: 0:0" in told.stdout
    assert len([line for line in told.stdout.splitlines() if " cm " in line]) == 3


def test_json_holds_every_occurrence_once(
    run: Run,
    made: Path,
    schema: dict[str, Any],  # noqa: F811
) -> None:
    document = json.loads(run("patterns", made / "jacks.bvh", "--lesson", "--json").stdout)
    assert faults(document, schema) == []
    (step,) = document["result"]["lesson"]
    told = sorted([step["typical"], *step["variations"]], key=lambda each: each["occurrence"])
    assert [each["occurrence"] for each in told] == [1, 2, 3, 4]
    occurrences = document["result"]["patterns"][0]["occurrences"]
    assert [(each["start"], each["stop"]) for each in told] == [(o["start"], o["stop"]) for o in occurrences]
    size = lm.embody(lm.read(made / "jacks.bvh")).size
    for each in step["variations"]:
        assert each["apart_m"] == pytest.approx(each["distance"] * size, abs=2e-6)
        assert len(each["differences"]) == 3


def test_the_table_says_the_same(run: Run, made: Path) -> None:
    run("patterns", made, "--lesson", "-o", "lesson.csv")
    run("patterns", made / "jacks.bvh", "--lesson", "-o", "lesson.json")
    table = rows("lesson.csv")
    (step,) = json.loads(Path("lesson.json").read_text(encoding="utf-8"))["result"]["lesson"]
    assert [row["role"] for row in table] == ["typical", "variation", "variation", "variation"]
    assert [float(row["distance"]) for row in table[1:]] == [each["distance"] for each in step["variations"]]
    assert [row["words"] for row in table[1:]] == ["; ".join(each["words"]) for each in step["variations"]]
    assert table[0]["occurrence"] == str(step["typical"]["occurrence"])


def test_labels_for_elan_count_from_the_start_of_the_file(run: Run, made: Path) -> None:
    whole = run("patterns", f"{made / 'jacks.bvh'}[15:]", "--lesson", "-o", "lesson.eaf", "--json")
    (step,) = json.loads(whole.stdout)["result"]["lesson"]
    labels = lm.read_annotations("lesson.eaf", rate=30.0)
    assert len(labels) == 1 + len(step["variations"])
    typical = labels.labels.index("A: typical")
    assert labels.starts[typical] == step["typical"]["start"] + 15


def test_the_page_holds_the_lesson(run: Run, made: Path) -> None:
    assert run("patterns", made / "jacks.bvh", "--lesson", "-o", "lesson.html").exit_code == 0
    assert '"lesson":{"steps":[{' in Path("lesson.html").read_text(encoding="utf-8")
    assert '"opens_with":"lesson"' in Path("lesson.html").read_text(encoding="utf-8")


def test_nothing_recurs_nothing_to_learn(run: Run, made: Path) -> None:
    told = run("patterns", made / "once.bvh", "--lesson", "-o", "lesson.csv")
    assert told.exit_code == 0
    assert told.stdout.startswith("Nothing repeats here.\n")
    assert rows("lesson.csv") == []


@pytest.mark.parametrize(
    ("name", "complaint"), [("l.png", "end it in"), ("l.bvh", "end it in"), ("in.bvh", "end it in")]
)
def test_an_unknown_ending_is_wrong_usage(run: Run, made: Path, name: str, complaint: str) -> None:
    told = run("patterns", made / "jacks.bvh", "--lesson", "-o", name)
    assert told.exit_code == 2
    assert complaint in " ".join(told.stderr.split())


def test_a_page_shows_one_recording(run: Run, made: Path) -> None:
    told = run("patterns", made, "--lesson", "-o", "all.html")
    assert told.exit_code == 2
    assert "Write a .csv or .json of" in " ".join(told.stderr.split())


def test_only_the_joints_that_were_asked_for_are_compared(run: Run, made: Path) -> None:
    told = run(
        "patterns", made / "jacks.bvh", "--lesson", "--json", "--joints", "pelvis,neck,*_wrist,*_ankle,*_hip"
    )
    (step,) = json.loads(told.stdout)["result"]["lesson"]
    named = {one["joint"] for each in step["variations"] for one in each["differences"]}
    assert named <= {
        "pelvis",
        "neck",
        "left_wrist",
        "right_wrist",
        "left_ankle",
        "right_ankle",
        "left_hip",
        "right_hip",
    }


def test_postures_are_compared_whatever_was_searched_by(run: Run, made: Path) -> None:
    asked = ["--features", "joint_rotations", "--max-distance", "0.3", "--joints", "*_shoulder,*_hip"]
    for what in (["--lesson"], ["--summary", "-o", "short.bvh"]):
        told = run("patterns", made / "jacks.bvh", *what, *asked)
        assert told.exit_code == 0, told.stderr
        assert told.stdout.startswith("1 movement ")
