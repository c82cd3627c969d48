"""``leitmotion graph``: one motion graph of all inputs, printed and written, and what it refuses."""

import csv
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import leitmotion as lm
from cli import odd
from cli.conftest import Run
from cli.json_schema import faults
from leitmotion.cli.graph import COLUMNS
from leitmotion.discovery import notation, performed

DOCS = Path(__file__).resolve().parents[2] / "docs" / "json.md"
SCHEMA = json.loads(re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[-1])


@pytest.fixture(scope="module")
def jacks(made: Path) -> lm.MotionGraph:
    return lm.motion_graph(lm.read(made / "jacks.bvh"), names=["jacks.bvh"])


def test_a_person_reads_the_notation_and_what_was_done(run: Run, made: Path, jacks: lm.MotionGraph) -> None:
    told = run("graph", made / "jacks.bvh")
    assert (told.exit_code, told.stderr) == (0, "")
    head, line, done, *_ = told.stdout.splitlines()
    assert head == f"{len(jacks.states)} states, {len(jacks.paths)} path{'s' * (len(jacks.paths) > 1)}."
    assert (line, done) == (notation(jacks), performed(jacks))
    assert told.stdout.count("state ") == len(jacks.states)
    assert "X\u0304 ↔ Y\u0304" in told.stdout


def test_the_document_says_what_the_library_says(run: Run, made: Path, jacks: lm.MotionGraph) -> None:
    document = json.loads(run("graph", made / "jacks.bvh", "--json").stdout)
    assert faults(document, SCHEMA) == []
    result = document["result"]
    assert result["notation"] == notation(jacks)
    for told, held in ((result["states"], jacks.states), (result["paths"], jacks.paths)):
        assert [(one["name"], len(one["occurrences"])) for one in told] == [
            (one.name, len(one.visits)) for one in held
        ]
    assert document["parameters"]["bias"] == "none"


def test_several_inputs_make_one_graph_and_one_that_fails_is_named(run: Run, made: Path) -> None:
    both = made / "jacks.bvh", made / "once.bvh"
    told = run("graph", both[0], made / "bad.bvh", both[1], both[0], "--json", "-o", "graph.csv")
    assert told.exit_code == 1
    failed, document = (json.loads(line) for line in told.stdout.splitlines())
    assert faults(document, SCHEMA) == faults(failed, SCHEMA) == []
    assert [source["path"] for source in document["source"]] == [str(path) for path in both]
    assert document["warnings"] == [f"{both[0]} is named twice, and was compared once."]
    graph = lm.motion_graph([lm.read(path) for path in both])
    assert document["result"]["notation"] == notation(graph)
    visits = [visit for each in (*graph.states, *graph.paths) for visit in each.visits]
    with open("graph.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == COLUMNS
    assert len(rows) == len(visits)
    assert {row["path"] for row in rows} == {str(path) for path in both}
    told = run("graph", *both)
    assert re.search(r"^jacks\.bvh: \S", told.stdout, re.MULTILINE)


def test_it_is_written_and_read_again(run: Run, made: Path, jacks: lm.MotionGraph) -> None:
    for ending in ("npz", "graphml", "svg", "html", "csv", "json"):
        for _ in "ab":  # the second is written over the first
            told = run("graph", made / "jacks.bvh", "-o", f"graph.{ending}")
            assert told.exit_code == 0, told.stderr
            assert told.stdout.endswith(f"\nWrote graph.{ending}.\n")
    outlines = re.findall(r' d="([^"]*)"', Path("graph.svg").read_text(encoding="utf-8"))
    assert outlines
    assert not any(re.search(r"\.\d{3}", outline) for outline in outlines)
    loaded = lm.load("graph.npz")
    assert (loaded.states, loaded.paths) == (jacks.states, jacks.paths)
    nodes = ElementTree.parse("graph.graphml").getroot().iter("{http://graphml.graphdrawing.org/xmlns}node")
    assert [node.get("id") for node in nodes] == [state.name for state in jacks.states]
    page = Path("graph.html").read_text(encoding="utf-8")
    assert '"opens_with":"graph"' in page.replace('": "', '":"')
    told = run("graph", made / "jacks.bvh", made / "once.bvh", "-o", "both.html")
    assert (told.exit_code, "both.html shows one recording, but there are 2" in told.stderr) == (2, True)
    Path("graph.graphml").write_text("<graphml/>", encoding="utf-8")
    told = run("graph", made / "jacks.bvh", "-o", "graph.graphml")
    assert (told.exit_code, "does not say that Leitmotion wrote it" in told.stderr) == (2, True)


def test_mirror_images_are_added(run: Run, made: Path) -> None:
    document = json.loads(run("graph", made / "once.bvh", "--racemize", "--json").stdout)
    assert faults(document, SCHEMA) == []
    assert document["result"]["notation"] == notation(
        lm.motion_graph(lm.read(made / "once.bvh"), racemize=True)
    )


def test_odd_recordings_are_answered_or_refused_in_a_sentence(run: Run, made: Path, tmp_path: Path) -> None:
    jacks = made / "jacks.bvh"
    flat = odd.planar(tmp_path / "flat.npz", lm.read(jacks))
    refused = {
        flat: "The kinematic chain needs joints in three dimensions, got two. Give the same movement with its depth.",
        odd.hands_only(
            tmp_path / "hands.npz"
        ): "The kinematic chain begins with the trunk, but no pelvis is known",
        Path("nowhere.bvh"): "There is no file nowhere.bvh.\n",
    }
    for path, sentence in refused.items():
        told = run("graph", path)
        assert (told.exit_code, told.stdout) == (1, "")
        assert told.stderr.startswith(f"Error: {sentence}")
        assert told.stderr.count("\n") == 1
    told = run("graph", flat, jacks)
    assert told.exit_code == 1
    assert told.stderr.startswith(f"{flat}: Error: The kinematic chain needs")
    assert " state" in told.stdout.splitlines()[0]
    gaps = odd.with_gaps(tmp_path / "gaps.npz", lm.read(jacks))
    for given in (gaps, f"{jacks}[0:1]", f"{jacks}[0:10]"):
        for more in ((), ("--json",), ("-o", "odd.svg")):
            told = run("graph", given, *more)
            assert told.exit_code == 0, told.stderr
    (tmp_path / "void").mkdir()
    told = run("graph", "void")
    assert (told.exit_code, told.stderr.splitlines()[0].startswith("Error: void holds no recordings.")) == (
        1,
        True,
    )
    document = json.loads(run("graph", f"{jacks}[10:60]", "--json").stdout)
    assert document["parameters"]["window"] == {"start": 10, "stop": 60}
