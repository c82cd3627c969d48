"""Labels as two public data sets write them: the ends of segments of CMU subject 86, and the blocks of mocap6."""

from __future__ import annotations

import csv
import io
import math
import re
from pathlib import Path

from leitmotion.motion import FormatError, ParameterError
from leitmotion.motion.errors import in_short

Row = tuple[float, float, str, float]  # start and stop in frames, label, score
Span = tuple[float, float]  # start and stop in frames

_ACA_RATE = 120.0
_BLOCK = 12  # frames of 120 Hz in a block of the mocap6 labels
_DOUBT = 0.25  # seconds before and after a change of label that stand in blocks of a tenth of a second


def decoded(content: bytes) -> str:
    """The text of a file of labels."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def is_blocks(text: str) -> bool:
    """Whether there is one number a block."""
    return re.fullmatch(r"[\d\s]+", text) is not None


def is_aca(text: str) -> bool:
    """Whether there are lines of a name and three frames."""
    return re.search(r"^\S+[ \t]+\d+[ \t]+\d+[ \t]+\d+[ \t]*$", text, re.MULTILINE) is not None


def from_aca(text: str, rate: float, trial: str | None, path: Path) -> list[Row]:
    """Blocks of ``name earliest best latest``, the frames, from 1 at 120 Hz, with which a segment ends."""
    rows: list[Row] = []
    begin = 0.0
    for name, _, best, _ in _aca_block(text, trial, path):
        end = best * rate / _ACA_RATE  # the last frame counted from 1 is the stop counted from 0
        rows.append((begin, end, name, math.nan))
        begin = end
    return rows


def aca_intervals(text: str, rate: float, trial: str | None, path: Path) -> list[Span]:
    """From the earliest to the latest end that the annotator accepts of each segment, frames."""
    block = _aca_block(text, trial, path)
    scale = rate / _ACA_RATE
    return [(earliest * scale, latest * scale) for _, earliest, _, latest in block if latest > earliest]


def _aca_block(text: str, trial: str | None, path: Path) -> list[tuple[str, float, float, float]]:
    """The lines of one trial."""
    blocks: dict[str, list[tuple[str, float, float, float]]] = {}
    rows: list[tuple[str, float, float, float]] = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if len(words) == 2 and words[0].isdigit():
            rows = blocks.setdefault("_".join(words), [])
        elif len(words) == 4 and all(re.fullmatch(r"[0-9]{1,12}", word) for word in words[1:]):
            rows.append((words[0], float(words[1]), float(words[2]), float(words[3])))
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
            f"{path.name} holds {asked}; it holds {in_short(list(blocks))}.",
            remedy="Choose one with --trial NAME (trial= in Python).",
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


def block_changes(text: str, rate: float, path: Path) -> list[Span]:
    """A quarter of a second on both sides of each change of label, frames."""
    doubt = _DOUBT * rate
    rows = from_blocks(text, rate, path)
    return [(max(start - doubt, 0.0), start + doubt) for start, _, _, _ in rows[1:]]
