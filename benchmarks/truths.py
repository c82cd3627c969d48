"""What people saw in the recordings of the benchmarks: the tables in ``benchmarks/labels`` as values.

The runs of the annotated recordings keep the annotators' borders and names; how often the movement happens in each was
counted by eye. Where the annotator accepts several borders, or labels tenths of a second, no label holds.
"""

from __future__ import annotations

import csv
from collections import defaultdict
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from leitmotion import io
from leitmotion.evaluation import PatternTruth
from leitmotion.motion import Segmentation
from recordings import locate

LABELS = Path(__file__).resolve().parent / "labels"
FIT = ("mocap6/13_29.amc", "mocap6/13_30.amc")
"""Annotated recordings that the method may be fitted on."""
REPORT = ("cmu86/86_01.amc", "mocap6/13_31.amc", "mocap6/14_06.amc")
"""Annotated recordings that it is judged by."""


class Clip(NamedTuple):
    """A stretch of a recording in which nothing recurs."""

    recording: str
    start: int
    stop: int
    what: str


def annotated(recording: str) -> PatternTruth:
    """Tell the runs of an annotated recording, all at 120 Hz, and where no label holds."""
    path = locate(recording)
    text = path.with_name("mocap.txt") if recording.startswith("cmu86/") else path.with_suffix(".txt")
    unlabelled = io.read_unlabelled(text, rate=120, trial=path.stem)
    return _truth(_runs("runs.csv")[recording], 120, unlabelled)


def counted(recording: str, rate: float) -> PatternTruth:
    """Tell the counted runs of a recording at its own rate."""
    return _truth(_runs("counted_runs.csv")[recording], rate)


def counted_recordings() -> tuple[str, ...]:
    """Name the recordings of which runs were counted."""
    return tuple(_runs("counted_runs.csv"))


def empty() -> list[Clip]:
    """List the clips in which nothing recurs."""
    return [
        Clip(row["recording"], int(row["start"]), int(row["stop"]), row["what"])
        for row in _rows("empty_clips.csv")
    ]


@cache
def _runs(table: str) -> dict[str, list[dict[str, str]]]:
    held: dict[str, list[dict[str, str]]] = defaultdict(list)
    for row in _rows(table):
        held[row["recording"]].append(row)
    return held


def _rows(table: str) -> list[dict[str, str]]:
    with (LABELS / table).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def _truth(
    rows: list[dict[str, str]], rate: float, unlabelled: list[tuple[int, int]] | None = None
) -> PatternTruth:
    runs = Segmentation(
        [int(row["start"]) for row in rows],
        [int(row["stop"]) for row in rows],
        tuple(row["action"] for row in rows),
        rate=rate,
    )
    cycles = [[float(row[column]) for column in ("cycles", "least", "most")] for row in rows]
    return PatternTruth(runs, unlabelled=np.array(unlabelled or []), cycles=np.array(cycles))
