"""Labels as two public data sets write them: the ends of segments of CMU subject 86, and the blocks of mocap6."""

from __future__ import annotations

import csv
import io
import math
import re
from pathlib import Path

from leitmotion.motion import FormatError, ParameterError

Row = tuple[float, float, str, float]  # start and stop in frames, label, score

_ACA_RATE = 120.0
_BLOCK = 12  # frames of 120 Hz in a block of the mocap6 labels


def from_aca(text: str, rate: float, trial: str | None, path: Path) -> list[Row]:
    """Blocks of ``name earliest best latest``, the frames, from 1 at 120 Hz, with which a segment ends."""
    blocks: dict[str, list[Row]] = {}
    rows: list[Row] = []
    begin = 0.0
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if len(words) == 2 and words[0].isdigit():
            begin, rows = 0.0, blocks.setdefault("_".join(words), [])
        elif len(words) == 4 and re.fullmatch(r"[0-9]{1,12}", words[2]):
            end = (
                float(words[2]) * rate / _ACA_RATE
            )  # the last frame counted from 1 is the stop counted from 0
            rows.append((begin, end, words[0], math.nan))
            begin = end
        elif words:
            raise FormatError(
                f"{path.name}, line {number}: expected a trial or a name and three frames, found {line!r}."
            )
    wanted = trial.replace(" ", "_") if trial else None
    if wanted is None and len(blocks) == 1:
        wanted = next(iter(blocks))
    if wanted not in blocks:
        asked = f"no trial {trial!r}" if trial else "several trials"
        raise ParameterError(
            f"{path.name} holds {asked}; it holds {', '.join(blocks)}: choose one with trial=."
        )
    return blocks[wanted]


def from_blocks(text: str, rate: float, path: Path) -> list[Row]:
    """One number a block of 12 frames at 120 Hz; runs of one number are one stretch."""
    names = {}
    beside = path.with_name("action_names.csv")
    if beside.is_file():
        for cells in csv.reader(io.StringIO(beside.read_text(encoding="utf-8-sig"))):
            if len(cells) > 1 and cells[0].strip().isdigit():
                names[int(cells[0])] = cells[1].strip()
    frames = _BLOCK * rate / _ACA_RATE
    rows: list[Row] = []
    numbers = [int(word) for word in text.split()]
    begin = 0
    for k, number in enumerate(numbers):
        if k + 1 == len(numbers) or numbers[k + 1] != number:
            rows.append((begin * frames, (k + 1) * frames, names.get(number, str(number)), math.nan))
            begin = k + 1
    return rows
