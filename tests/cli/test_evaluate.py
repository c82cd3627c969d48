"""``leitmotion evaluate``: the figures for a person and for a program, and what does not fit in one sentence."""

import csv
import json
from pathlib import Path

import pytest

from cli.conftest import Run
from cli.json_schema import faults
from cli.test_contract import schema  # noqa: F401

LABELS = "start_s,stop_s,label,cycles\n0.5,6,jump,4\n"


@pytest.fixture
def judged(run: Run, made: Path) -> Run:
    Path("labels.csv").write_text(LABELS, encoding="utf-8")
    run("patterns", made / "jacks.bvh", "-o", "found.json")
    return run


def test_a_person_reads_a_sentence_and_a_table(judged):
    told = judged("evaluate", "patterns", "labels.csv", "found.json")
    assert told.exit_code == 0
    assert "pairs wrong, 0 of 1 recurring actions missed." in told.stdout
    for name in ("type I error", "F1", "u/(U-u+v)", "counts"):
        assert name in told.stdout


def test_a_program_reads_a_document_of_the_contract(judged, schema):  # noqa: F811
    told = judged("evaluate", "patterns", "labels.csv", "found.json", "--json", "-o", "scores.json")
    document = json.loads(told.stdout)
    assert faults(document, schema) == []
    assert json.loads(Path("scores.json").read_text(encoding="utf-8")) == document
    assert [source["path"] for source in document["source"]] == ["labels.csv", "found.json"]
    assert document["result"]["metrics"]["type_two"] == {"value": 0.0, "low": None, "high": None}
    assert document["result"]["recordings"][0]["runs"][0]["cycles"] == 4


def test_several_answers_are_judged_together_with_intervals(run, made, schema):  # noqa: F811
    Path("truth").mkdir()
    for name in ("jacks", "once"):
        Path(f"truth/{name}.csv").write_text(LABELS.replace("6", "3.7"), encoding="utf-8")
    run("patterns", made / "jacks.bvh", made / "once.bvh", "-o", "found.json")
    told = run("evaluate", "patterns", "truth", "found.json", "--json", "-o", "scores.csv")
    document = json.loads(told.stdout)
    assert faults(document, schema) == []
    assert len(document["result"]["recordings"]) == 2
    assert document["result"]["metrics"]["type_two"]["low"] is not None
    with open("scores.csv", encoding="utf-8", newline="") as file:
        rows = {row["measure"]: row for row in csv.DictReader(file)}
    assert float(rows["type_two"]["value"]) == document["result"]["metrics"]["type_two"]["value"]
    assert "95 % interval" in run("evaluate", "patterns", "truth", "found.json").stdout


@pytest.mark.parametrize(
    ("truth", "found", "message"),
    [
        ("nothing.csv", "found.json", "There is no file nothing.csv."),
        ("labels.csv", "nothing.json", "There is no file nothing.json."),
        ("labels.csv", "labels.txt", "a search for patterns (.json, .csv, .eaf or .npz), found another."),
        ("labels.csv", "found.eaf", "does not tell the frame rate"),
        ("long.csv", "found.json", "long.csv reaches to 90.00 s, but the recording lasts"),
        ("folder", "found.json", "holds 0 files that may be the truth about"),
        ("words.txt", "found.json", "words.txt, line 1: expected the columns"),
    ],
)
def test_what_does_not_fit_is_told_in_one_sentence(judged, made, schema, truth, found, message):  # noqa: F811
    Path("folder").mkdir()
    Path("long.csv").write_text("start_s,stop_s,label\n0,90,walk\n", encoding="utf-8")
    Path("labels.txt").write_text("no answer", encoding="utf-8")
    Path("words.txt").write_text("no labels", encoding="utf-8")
    judged("patterns", made / "jacks.bvh", "-o", "found.eaf")
    told = judged("evaluate", "patterns", truth, found)
    assert told.exit_code == 1
    assert told.stderr.startswith("Error: ")
    assert message in told.stderr
    document = json.loads(judged("evaluate", "patterns", truth, found, "--json").stdout)
    assert faults(document, schema) == []
    assert message in document["error"]["message"]


def test_wrong_usage(judged):
    assert judged("evaluate", "dance", "labels.csv", "found.json").exit_code == 2
    assert judged("evaluate", "patterns", "labels.csv").exit_code == 2
    assert judged("evaluate", "patterns", "labels.csv", "found.json", "-o", "found.json").exit_code == 2
    assert judged("evaluate", "patterns", "labels.csv", "found.json", "-o", "scores.html").exit_code == 2


def test_what_is_not_known_and_what_lies_beyond_the_truth_is_told(judged):
    Path("short.csv").write_text("start_s,stop_s,label\n0.5,3.8,jump\n", encoding="utf-8")
    told = judged("evaluate", "patterns", "short.csv", "found.json")
    assert "whether jump recurs within its one run is not known" in told.stderr
    assert "The truth ends at 3.80 s of" in told.stderr
    assert judged("evaluate", "patterns", "short.csv", "found.json", "-q").stderr == ""


TWO = "recording,start_s,stop_s,label\na.bvh,0.5,6,jump\na.bvh,6.1,6.2,rest\nb.bvh,0.5,6,jump\n"


def test_a_truth_of_another_recording_is_told_by_both_names(judged):
    Path("two.csv").write_text(TWO, encoding="utf-8")
    Path("one.csv").write_text(TWO.rpartition("b.bvh")[0], encoding="utf-8")
    for truth, *trial in (("two.csv", "--trial", "a.bvh"), ("one.csv",), ("labels.csv", "--trial", "a.bvh")):
        told = judged("evaluate", "patterns", truth, "found.json", *trial)
        assert told.exit_code == 0
        assert f"jacks.bvh was judged by what {truth} tells of a.bvh: are they one recording?" in told.stderr
    own = Path("one.csv").read_text(encoding="utf-8").replace("a.bvh", "elsewhere/jacks.amc")
    Path("one.csv").write_text(own, encoding="utf-8")
    assert "was judged by" not in judged("evaluate", "patterns", "one.csv", "found.json").stderr


def test_which_recording_is_meant_is_asked_with_the_names_that_there_are(judged, made):
    Path("two.csv").write_text(TWO, encoding="utf-8")
    asked = judged("evaluate", "patterns", "two.csv", "found.json").stderr
    assert "expected the stretches of one recording, found those of 2, none of them named " in asked
    assert "jacks.bvh: a.bvh, b.bvh. Keep the rows of one, or say which: --trial NAME" in asked
    judged("patterns", made / "jacks.bvh", made / "once.bvh", "-o", "both.json")
    asked = judged("evaluate", "patterns", "two.csv", "both.json", "--trial", "a.bvh").stderr
    assert "One recording of the truth is named, a.bvh, but both.json holds answers about 2: " in asked
    assert "once.bvh. Leave --trial (trial= in Python) out" in asked
