"""The tables of runs that were labelled by eye: laws of the tables, and what the annotations and recordings say."""

import csv
import sys
from itertools import groupby, pairwise
from pathlib import Path

import pytest

import leitmotion

BENCHMARKS = Path(__file__).resolve().parents[1] / "benchmarks"
COLUMNS = ["recording", "start", "stop", "action", "cycles", "least", "most", "note"]
TABLES = ("runs.csv", "counted_runs.csv")
BLOCK = 12  # frames of one entry of a mocap6 annotation

Run = tuple[int, int, str]


def table(name: str) -> list[dict]:
    with open(BENCHMARKS / "labels" / name, newline="") as file:
        rows = csv.DictReader(file)
        assert rows.fieldnames == COLUMNS
        return [
            {k: int(v) if k in COLUMNS[1:3] + COLUMNS[4:7] else v for k, v in row.items()} for row in rows
        ]


def by_recording(name: str) -> dict[str, list[dict]]:
    return {key: list(rows) for key, rows in groupby(table(name), key=lambda row: row["recording"])}


def frames(data: Path, recording: str, monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    monkeypatch.setattr(sys, "path", [str(BENCHMARKS), *sys.path])
    from recordings import locate

    return len(leitmotion.embody(leitmotion.read(locate(recording))).positions)


@pytest.mark.parametrize("name", TABLES)
def test_counts_lie_between_their_bounds(name: str) -> None:
    for row in table(name):
        assert 0 <= row["start"] < row["stop"], row
        assert 0 <= row["least"] <= row["cycles"] <= row["most"], row
        assert row["most"] >= 1, row
        assert row["action"].isidentifier(), row
        assert row["note"], row


@pytest.mark.parametrize("name", TABLES)
def test_runs_of_a_recording_stand_together_in_order_and_apart(name: str) -> None:
    assert sum(len(rows) for rows in by_recording(name).values()) == len(table(name))
    for rows in by_recording(name).values():
        assert all(a["stop"] <= b["start"] for a, b in pairwise(rows))


def test_annotated_runs_leave_no_gap_and_neighbours_differ() -> None:
    for rows in by_recording("runs.csv").values():
        assert rows[0]["start"] == 0
        assert all(a["stop"] == b["start"] and a["action"] != b["action"] for a, b in pairwise(rows))


def test_counted_runs_are_twenty_others_that_repeat() -> None:
    rows = table("counted_runs.csv")
    assert len(rows) == 20
    assert all(row["cycles"] >= 2 for row in rows)
    assert not by_recording("counted_runs.csv").keys() & by_recording("runs.csv").keys()


@pytest.mark.data
@pytest.mark.parametrize("name", TABLES)
def test_frames_lie_inside_the_recordings(name: str, data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for recording, rows in by_recording(name).items():
        n = frames(data, recording, monkeypatch)
        assert rows[-1]["stop"] <= n, recording
        if name == "runs.csv":
            assert rows[-1]["stop"] == n, recording


def ends_of_86_01(data: Path) -> list[Run]:
    """The first block of the annotation: lines of a name and the earliest, best and latest frame of its end."""
    lines = (data / "cmu86" / "mocap.txt").read_text().split("\n\n")[0].splitlines()[1:]
    ends = [(name, int(best)) for name, _, best, _ in map(str.split, lines)]
    starts = [0, *(best for _, best in ends)]
    return [(start, stop, name) for start, (name, stop) in zip(starts, ends)]


def blocks_of_mocap6(data: Path, trial: str) -> list[Run]:
    names = dict(line.split(",") for line in (data / "mocap6" / "action_names.csv").read_text().split())
    runs: list[Run] = []
    at = 0
    for key, group in groupby((data / "mocap6" / f"{trial}.txt").read_text().split()):
        n = BLOCK * len(list(group))
        runs.append((at, at + n, names[key]))
        at += n
    return runs


@pytest.mark.data
def test_annotated_runs_are_the_annotators(data: Path) -> None:
    for recording, rows in by_recording("runs.csv").items():
        trial = Path(recording).stem
        truth = ends_of_86_01(data) if trial == "86_01" else blocks_of_mocap6(data, trial)
        # The last entry of a mocap6 annotation goes on behind the end of its recording.
        assert 0 <= truth[-1][1] - rows[-1]["stop"] <= BLOCK
        truth[-1] = (truth[-1][0], rows[-1]["stop"], truth[-1][2])
        assert [(row["start"], row["stop"], row["action"]) for row in rows] == truth


@pytest.mark.data
def test_counts_agree_with_those_beside_the_recordings(data: Path) -> None:
    with open(data / "repetition_counts.csv", newline="") as file:
        told = {Path(row["file"]).stem: row for row in csv.DictReader(file)}
    both = [
        (row, told[stem])
        for row in table("counted_runs.csv")
        if (stem := Path(row["recording"]).stem) in told
    ]
    assert len(both) == 3
    for row, other in both:
        assert row["cycles"] == int(other["count"])
        assert all(row["start"] <= int(f) < row["stop"] for f in other["approx_event_frames"].split(";"))
