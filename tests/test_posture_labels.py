"""The pairs of postures and the empty clips that were labelled by eye: laws of the tables."""

import csv
import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

import leitmotion

BENCHMARKS = Path(__file__).resolve().parents[1] / "benchmarks"
LABELS = BENCHMARKS / "labels"
PAIRS = ["recording_a", "frame_a", "recording_b", "frame_b", "alike", "person", "group", "how"]
CLIPS = ["recording", "start", "stop", "what"]
KINDS = {"1": {"cycle", "takes", "dtw"}, "0": {"random", "phase", "near"}}
SHORTEST = 1.5  # seconds of an empty clip


def table(name: str, columns: list[str]) -> list[dict[str, str]]:
    with open(LABELS / name, newline="") as file:
        rows = csv.DictReader(file)
        assert rows.fieldnames == columns
        return list(rows)


def pairs() -> list[dict[str, str]]:
    return table("posture_pairs.csv", PAIRS)


def clips() -> list[dict[str, str]]:
    return table("empty_clips.csv", CLIPS)


@cache
def length_and_rate(recording: str, data: Path) -> tuple[int, float]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LEITMOTION_DATA", str(data))
        patch.setattr(sys, "path", [str(BENCHMARKS), *sys.path])
        from recordings import locate

        body = leitmotion.embody(leitmotion.read(locate(recording)))
    return len(body.positions), body.rate


def test_as_many_pairs_are_alike_as_not_in_each_group() -> None:
    counts = Counter((row["group"], row["alike"]) for row in pairs())
    assert counts == {("fit", "1"): 100, ("fit", "0"): 100, ("check", "1"): 60, ("check", "0"): 60}


def test_kinds_of_pairs_that_are_not_alike_are_a_third_each() -> None:
    assert all(row["how"] in KINDS[row["alike"]] for row in pairs())
    for group in ("fit", "check"):
        counts = Counter(row["how"] for row in pairs() if row["group"] == group and row["alike"] == "0")
        assert counts.keys() == KINDS["0"]
        assert max(counts.values()) - min(counts.values()) <= 1


def test_nobody_and_no_recording_is_in_both_groups() -> None:
    fit, check = ([row for row in pairs() if row["group"] == group] for group in ("fit", "check"))
    for columns in (["person"], ["recording_a", "recording_b"]):
        assert not {row[c] for row in fit for c in columns} & {row[c] for row in check for c in columns}


def test_no_pair_stands_twice_and_none_is_one_posture() -> None:
    postures = [
        frozenset([(row["recording_a"], row["frame_a"]), (row["recording_b"], row["frame_b"])])
        for row in pairs()
    ]
    assert all(len(pair) == 2 for pair in postures)
    assert len(set(postures)) == len(postures)


def test_people_and_their_pairs_are_those_that_the_text_names() -> None:
    counts = Counter((row["group"], row["person"], row["alike"]) for row in pairs())
    lines = (line.strip("| ").split(" | ") for line in (LABELS / "postures.md").read_text().splitlines())
    told = {
        (group, person, alike): int(n)
        for group, person, *both in (line for line in lines if line[0] in ("fit", "check"))
        for alike, n in zip("10", both, strict=True)
    }
    assert {key: n for key, n in told.items() if n} == counts


def test_empty_clips_are_twenty_of_six_sets() -> None:
    rows = clips()
    assert len(rows) == len({row["recording"] for row in rows}) == 20
    assert len({row["recording"].split("/")[0] for row in rows}) >= 6
    assert all(row["what"] for row in rows)


@pytest.mark.data
def test_frames_of_pairs_lie_inside_the_recordings(data: Path) -> None:
    for row in pairs():
        for side in "ab":
            n, _ = length_and_rate(row[f"recording_{side}"], data)
            assert 0 <= int(row[f"frame_{side}"]) < n, row


@pytest.mark.data
def test_empty_clips_lie_inside_the_recordings_and_are_long_enough(data: Path) -> None:
    for row in clips():
        n, rate = length_and_rate(row["recording"], data)
        start, stop = int(row["start"]), int(row["stop"])
        assert 0 <= start < stop <= n, row
        assert stop - start >= SHORTEST * rate, row
