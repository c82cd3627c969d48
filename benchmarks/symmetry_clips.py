"""The stretches whose symmetry was labelled by eye, as values, and on which of them a detector may be developed."""

from __future__ import annotations

import csv
import re
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from leitmotion.evaluation import SymmetryLabel

LABELS = Path(__file__).resolve().parent / "labels"
TABLES = ("drawn", "found")
DEVELOPMENT = r"^animated_drawings/|/dataset-1_|/jumping_jacks\.|/HDM_bd_|/(86|13|135)_\d+\."
"""Recordings on which the detector may be developed; all others are reported."""
SPLITS = ("reported", "development")
SETS = {
    "CMU": ("cmu86", "cmu_amc", "cmu_bvh", "mocap6"),
    "HDM05": ("hdm05",),
    "Bandai Namco": ("bandai_namco",),
    "UI-PRMD": ("uiprmd",),
}
"""Folders of the data sets; what lies in another is of the others."""


class Clip(NamedTuple):
    """What the labeller saw of a recording, and what was seen there."""

    recording: str
    window: tuple[int, int]
    labels: tuple[SymmetryLabel, ...]
    says: tuple[str, ...]
    """What is done in each stretch."""

    @property
    def split(self) -> str:
        """Whether it is reported, or of the development."""
        return SPLITS[bool(re.search(DEVELOPMENT, self.recording))]

    @property
    def set(self) -> str:
        """The data set."""
        folder = self.recording.split("/")[0]
        return next((name for name, folders in SETS.items() if folder in folders), "others")


def clips(table: str) -> list[Clip]:
    """Give the clips that were drawn at random, or the stretches that were looked for, each a clip of its own."""
    if table == "found":
        return [
            Clip(row["recording"], (label.start, label.stop), (label,), (row["what"],))
            for row in _rows("symmetry_found.csv")
            if (label := _label(row))
        ]
    windows = {row["recording"]: _span(row) for row in _rows("symmetry_drawn.csv")}
    return [
        Clip(name, windows[name], tuple(map(_label, rows)), tuple(row["what"] for row in rows))
        for name, held in groupby(_rows("symmetry_clips.csv"), key=lambda row: row["recording"])
        if (rows := list(held))
    ]


def _rows(file: str) -> list[dict[str, str]]:
    with (LABELS / file).open(encoding="utf-8", newline="") as text:
        return list(csv.DictReader(text))


def _span(row: dict[str, str]) -> tuple[int, int]:
    return int(row["start"]), int(row["stop"])


def _label(row: dict[str, str]) -> SymmetryLabel:
    motifs = () if row["motifs"] == "none" else tuple(row["motifs"].split("|"))
    return SymmetryLabel(*_span(row), row["sides"], row["course"], motifs, row["sure"] == "yes")
