"""``leitmotion symmetry``: what it prints, its documents, its tables and files, and what it refuses."""

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
from leitmotion.cli import shares, symmetry
from leitmotion.discovery import notation
from leitmotion.discovery.symmetry_span import MOTIFS
from leitmotion.view.symmetry_words import CHIEF
from oracles import motifs

DOCS = Path(__file__).resolve().parents[2] / "docs" / "json.md"
SCHEMA = json.loads(re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[-1])


def rows_of(path: str) -> list[dict[str, str]]:
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_a_person_reads_motifs_in_plain_words_and_in_those_of_the_thesis(run: Run, made: Path) -> None:
    told = run("symmetry", made / "jacks.bvh")
    assert (told.exit_code, told.stderr) == (0, "")
    assert told.stdout.startswith("Both sides move together.\n")
    assert "symmetric palindrome, cyclic" in told.stdout
    assert re.search(r"^States and paths: .+;.+↔", told.stdout, re.MULTILINE)
    assert re.search(r"^Symmetry index 0\.\d\d: ", told.stdout, re.MULTILINE)
    assert "bias" not in told.stdout
    assert (
        "The bias of the sides in the mean posture ("
        in run("symmetry", made / "jacks.bvh", "--bias", "mean").stdout
    )


def test_it_tells_which_side_moves_and_the_page_says_the_same(run: Run, tmp_path: Path) -> None:
    motion = motifs.movement("asymmetric_palindrome")
    lm.write(motion, tmp_path / "arm.bvh")
    found = lm.find_symmetry(lm.read(tmp_path / "arm.bvh"))
    best = max(found.spans, key=lambda span: (span.motif == "asymmetric_palindrome", span.confidence))
    told = run("symmetry", tmp_path / "arm.bvh", "-o", "arm.html", "--min-still", "0.3")
    title, lead = told.stdout.splitlines()[:2]
    assert title == f"The {best.side} side moves more."
    assert f"the {best.side} side more: arm" in lead
    assert f"{best.side}: arm" in told.stdout
    assert json.dumps(lead)[1:-1] in Path("arm.html").read_text(encoding="utf-8")
    document = json.loads(run("symmetry", tmp_path / "arm.bvh", "--json").stdout)
    assert faults(document, SCHEMA) == []
    for told_span, span in zip(document["result"]["spans"], found.spans, strict=True):
        assert (told_span["side"] or "", tuple(told_span["links"])) == (span.side, span.links)
    run("symmetry", tmp_path / "arm.bvh", "-o", "arm.csv")
    assert [row["side"] for row in rows_of("arm.csv")] == [span.side for span in found.spans]


@pytest.mark.data
def test_a_held_pose_and_a_raised_arm_are_told_as_they_are(run: Run, data: Path) -> None:
    held = run("symmetry", f"{data}/bandai_namco/dataset-1_dance-short_normal_001.bvh[0s:8s]").stdout
    assert held.startswith("The body keeps still.\n")
    raised = run("symmetry", data / "uiprmd/correct/Kinect/Positions/m07_s01_e01_positions.txt").stdout
    assert raised.startswith("The right side moves more.\nOne stretch moves the right side more: arm.\n")


def test_of_many_stretches_the_clearest_are_told_in_order(run: Run, made: Path, monkeypatch) -> None:
    found = lm.find_symmetry(lm.read(made / "jacks.bvh"))
    monkeypatch.setattr(symmetry, "TOLD", 1)
    told = run("symmetry", made / "jacks.bvh").stdout
    best = max(found.spans, key=lambda span: (span.motif in CHIEF, span.confidence))
    assert len(re.findall(r"^\d:\d\d\.\d", told, re.MULTILINE)) == 1
    assert f"  {CHIEF[best.motif].name}  " in told
    assert f"{len(found.spans) - 1} more, which tell less, are in the JSON." in told


def test_the_document_says_what_the_library_says(run: Run, made: Path) -> None:
    told = run(
        "symmetry", made / "jacks.bvh", made / "bad.bvh", "--json", "--metric", "geodesic", "--bias", "mean"
    )
    assert told.exit_code == 1
    document, failed = (json.loads(line) for line in told.stdout.splitlines())
    assert faults(document, SCHEMA) == faults(failed, SCHEMA) == []
    motion = lm.read(made / "jacks.bvh")
    found = lm.find_symmetry(motion, metric="geodesic", bias="mean")
    result = document["result"]
    assert [(span["motif"], span["start"], span["stop"]) for span in result["spans"]] == [
        (span.motif, span.start, span.stop) for span in found.spans
    ]
    for told_span, span in zip(result["spans"], found.spans, strict=True):
        assert told_span["score"] == pytest.approx(span.confidence, abs=1e-4)
        assert told_span["partner"] is None or told_span["partner"]["start"] == span.partner[0]
    assert result["notation"] == notation(lm.motion_graph(motion, bias="mean"))
    assert result["bias"]["pose"] == document["parameters"]["bias"] == "mean"
    assert result["shares"]["symmetric_palindrome"] > max(
        share for motif, share in result["shares"].items() if motif.startswith(("a", "ref"))
    )
    assert set(result["shares"]) == set(MOTIFS)


def test_the_tables_have_a_row_per_stretch_or_per_recording(run: Run, made: Path) -> None:
    inputs = made / "jacks.bvh", made / "bad.bvh", made / "once.bvh"
    told = run("symmetry", *inputs, "-o", "motifs.csv")
    assert told.exit_code == 1
    found = lm.find_symmetry(lm.read(inputs[0]))
    rows = rows_of("motifs.csv")
    assert tuple(rows[0]) == symmetry.COLUMNS
    assert [row["motif"] for row in rows if row["path"] == str(inputs[0])] == [
        span.motif for span in found.spans
    ]
    assert told.stdout.splitlines()[-2].endswith(str(inputs[2]))  # the last row of the table of shares
    assert run("symmetry", *inputs, "--shares", "-o", "shares.csv").exit_code == 1
    jacks, bad, once = rows_of("shares.csv")
    assert tuple(jacks) == shares.COLUMNS
    taken = np.zeros(found.frames, dtype=bool)
    for span in found.spans:
        if span.motif == "symmetric_palindrome":
            taken[span.start : span.stop] = True
    assert float(jacks["symmetric_palindrome"]) == pytest.approx(taken.mean(), abs=1e-4)
    assert bad["error"].startswith("bad.bvh")
    assert (bad["symmetry_index"], once["error"]) == ("", "")
    assert run("symmetry", *inputs, "--shares", "-o", "shares.csv").exit_code == 1  # it is ours
    assert set(shares.MOTIFS) == set(MOTIFS)


def test_it_is_written_and_read_again(run: Run, made: Path) -> None:
    jacks = made / "jacks.bvh"
    found = lm.find_symmetry(lm.read(jacks))
    for ending in ("npz", "eaf", "svg", "csv", "json", "html"):
        for _ in "ab":  # the second is written over the first
            told = run("symmetry", jacks, "-o", f"found.{ending}")
            assert told.exit_code == 0, told.stderr
    assert lm.load("found.npz") == found
    spans = sum(1 + (span.partner is not None) for span in found.spans)
    assert len(lm.read_annotations("found.eaf", rate=found.rate)) == spans
    for name in ("found.csv", "found.json"):
        labels = lm.read_annotations(name, rate=found.rate)
        assert sorted(labels.labels) == sorted(span.motif for span in found.spans)
        assert sorted(labels.starts.tolist()) == sorted(span.start for span in found.spans)
    page = Path("found.html").read_text(encoding="utf-8")
    assert '"opens_with":"symmetry"' in page.replace('": "', '":"')


def test_wrong_usage_is_told(run: Run, made: Path) -> None:
    told = run("symmetry", made / "jacks.bvh", made / "once.bvh", "-o", "both.html")
    assert (told.exit_code, "both.html shows one recording, but there are 2" in told.stderr) == (2, True)
    told = run("symmetry", made / "jacks.bvh", "--shares")
    assert (told.exit_code, "--shares says what stands in a table" in told.stderr) == (2, True)
    assert run("symmetry", made / "jacks.bvh", "--min-still", "0").exit_code == 2


def test_odd_recordings_are_answered_or_refused_in_a_sentence(run: Run, made: Path, tmp_path: Path) -> None:
    jacks = made / "jacks.bvh"
    refused = {
        odd.planar(
            tmp_path / "flat.npz", lm.read(jacks)
        ): "The kinematic chain needs joints in three dimensions",
        odd.hands_only(
            tmp_path / "hands.npz"
        ): "The kinematic chain begins with the trunk, but no pelvis is known",
        Path("nowhere.bvh"): "There is no file nowhere.bvh.",
        made / "empty.bvh": "empty.bvh",
    }
    for path, sentence in refused.items():
        told = run("symmetry", path)
        assert (told.exit_code, told.stdout) == (1, "")
        assert told.stderr.startswith(f"Error: {sentence}")
        assert told.stderr.count("\n") == 1
    gaps = odd.with_gaps(tmp_path / "gaps.npz", lm.read(jacks))
    for given in (gaps, f"{jacks}[0:1]", f"{jacks}[0:10]", f"{jacks}[1s:3s]"):
        told = run("symmetry", given, "--json")
        assert told.exit_code == 0, told.stderr
        document = json.loads(told.stdout)
        assert faults(document, SCHEMA) == []
        frames = document["source"][0]["frames"]
        assert all(0 <= span["start"] < span["stop"] <= frames for span in document["result"]["spans"])
    assert run("symmetry", f"{jacks}[0:1]").stdout.startswith("No symmetry shows here.\n")
    content = jacks.read_bytes()
    assert json.loads(run("symmetry", "-", "--json", stdin=content).stdout)["source"][0]["path"] == "-"
