"""Tables of labelled stretches: which column is which, whose rows are meant, and what a row says."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path, PurePosixPath
from typing import Any

from leitmotion.io.dataset_labels import Row
from leitmotion.motion import FormatError
from leitmotion.motion.errors import in_short

Lines = list[tuple[int, list[str]]]

COLUMNS = ("start", "stop", "start_s", "stop_s", "label", "score")
"""Columns of a table that is written here."""
_ALIASES = {"end": "stop", "end_s": "stop_s", "begin": "start", "name": "label", "action": "label",
            "start_frame": "start", "stop_frame": "stop", "end_frame": "stop", "recording": "path"}  # fmt: skip
_LAST = 2.0**53  # beyond it frames are no whole numbers


def from_table(text: str, rate: float, path: Path, trial: str | None = None) -> list[Row]:
    """The stretches of a table, of several recordings those of the one that is asked for."""
    names, lines, ours = _read(text, path)
    lines = _of_trial(names, lines, trial, path)
    decimal = any("." in cells[names.index(n)] for _, cells in lines for n in ("start", "stop")
                  if n in names and names.index(n) < len(cells))  # fmt: skip
    rows = []
    for number, cells in lines:
        entry: dict[str, Any] = dict(zip(names, (cell.strip() for cell in cells)))
        if ours:  # written here, and to the letter
            entry["label"] = cells[names.index("label")] if len(cells) == len(names) else entry.get("label")
        if decimal:  # one decimal point makes a column of seconds
            entry = {"start_s": entry.pop("start", ""), "stop_s": entry.pop("stop", ""), **entry}
        rows.append(row_of(entry, rate, f"{path.name}, line {number}"))
    return rows


def recordings_of_table(text: str, path: Path) -> list[str]:
    """The recordings that a table tells of, in its order; none where it does not name them."""
    names, lines, _ = _read(text, path)
    if "path" not in names:
        return []
    place = names.index("path")
    return list(dict.fromkeys(cells[place].strip() for _, cells in lines if place < len(cells)))


def cycles_of_table(text: str, path: Path, trial: str | None = None) -> list[tuple[float, float, float]]:
    """How often the movement happens within each stretch, at least and at most; NaN where it is not told."""
    names, lines, _ = _read(text, path)
    counts = []
    for number, cells in _of_trial(names, lines, trial, path):
        entry = dict(zip(names, (cell.strip() for cell in cells)))
        # an answer of ours, a row an occurrence, tells the cycles of whole patterns
        told = "nan" if "occurrence" in entry else entry.get("cycles") or "nan"
        try:
            counts.append((float(told), float(entry.get("least") or told), float(entry.get("most") or told)))
        except ValueError:
            raise FormatError(
                f"{path.name}, line {number}: expected numbers as cycles, least and most, found "
                f"{told}, {entry.get('least')}, {entry.get('most')}."
            ) from None
    return counts


def named(recordings: list[str], name: str) -> list[str]:
    """Which of some recordings, told by their paths, a name means: by the end of the path, else by the file's name."""
    asked = _parts(name)

    def ends_alike(parts: list[str]) -> bool:
        shared = min(len(parts), len(asked))
        return shared > 0 and parts[-shared:] == asked[-shared:]

    return [one for one in recordings if ends_alike(_parts(one))] or [
        one for one in recordings if PurePosixPath(one).stem == PurePosixPath(name).stem
    ]


def _parts(name: str) -> list[str]:
    return list(PurePosixPath(name.replace("\\", "/")).parts)


def _of_trial(names: list[str], lines: Lines, trial: str | None, path: Path) -> Lines:
    if "path" not in names:
        return lines
    place = names.index("path")
    held = list(dict.fromkeys(cells[place].strip() for _, cells in lines if place < len(cells)))
    if len(held) < 2:
        return lines
    mine = named(held, trial) if trial else []
    if len(mine) != 1:
        those = (f", {'none' if not mine else len(mine)} of them named {trial}") if trial else ""
        raise FormatError(
            f"{path.name}: expected the stretches of one recording, found those of {len(held)}{those}: "
            f"{in_short(held)}.",
            remedy="Keep the rows of one, or say which: --trial NAME (trial= in Python).",
        )
    return [
        (number, cells) for number, cells in lines if place < len(cells) and cells[place].strip() == mine[0]
    ]


def _read(text: str, path: Path) -> tuple[list[str], Lines, bool]:
    """The names of the columns, the lines with their numbers, and whether they were written here."""
    first = text.partition("\n")[0]
    delimiter = max(",;\t", key=first.count)
    try:
        lines = [
            (number, cells)
            for number, cells in enumerate(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter), 1)
            if any(cell.strip() for cell in cells)
        ]
    except csv.Error as error:
        raise FormatError(
            f"{path.name}: expected a table, found that a cell does not end ({error})."
        ) from None
    if not lines:
        raise FormatError(f"{path.name}: expected a table of stretches, found empty lines.")
    ours = lines[0][1] == list(COLUMNS)
    header = [cell.strip().lower() for cell in lines[0][1]]
    names = [_ALIASES.get(word, word) for word in header]
    if {"start", "stop"} <= set(names) or {"start_s", "stop_s"} <= set(names):
        lines = lines[1:]
    elif _is_number(header[0]) and len(header) > 1 and _is_number(header[1]):
        names = ["start", "stop", "label", "score"][: len(header)]
    else:
        raise FormatError(
            f"{path.name}, line 1: expected the columns start, stop, label (frames) or start_s, stop_s, label "
            f"(seconds), found {', '.join(lines[0][1][:6])}."
        )
    ours_called = next((name for name in ("pattern", "motif") if name in names), None)
    if "label" not in names and ours_called:
        names[names.index(ours_called)] = "label"
    if "label" not in names:
        raise FormatError(
            f"{path.name}, line 1: expected a column label (or pattern, or motif), found {', '.join(header[:6])}."
        )
    return names, lines, ours


def row_of(entry: dict[str, Any], rate: float, where: str) -> Row:
    """One stretch, from the words of a table or the values of a document."""
    values = {}
    for name in ("start", "stop", "start_s", "stop_s", "score"):
        given = entry.get(name)
        if given is None or given == "":
            continue
        try:
            values[name] = float(given)
        except (TypeError, ValueError):
            raise FormatError(f"{where}: expected a number as {name}, found {given!r}.") from None
        if name != "score" and not math.isfinite(values[name]):
            raise FormatError(f"{where}: expected a finite {name}, found {given!r}.")
    seconds = "start_s" in values and "stop_s" in values
    if "start" in values and "stop" in values:
        start, stop = values["start"], values["stop"]
        # JSON tells 12 from 12.0 by type, CSV by the decimal point
        if any(isinstance(entry[name], float) or "." in str(entry[name]) for name in ("start", "stop")):
            start, stop = start * rate, stop * rate
        elif seconds and abs(values["stop_s"] * rate - stop) > 0.5:
            start, stop = values["start_s"] * rate, values["stop_s"] * rate
    elif seconds:
        start, stop = values["start_s"] * rate, values["stop_s"] * rate
    else:
        raise FormatError(
            f"{where}: expected start and stop (frames) or start_s and stop_s (seconds), "
            f"found {', '.join(map(str, entry)) or 'nothing'}."
        )
    if not max(abs(start), abs(stop)) < _LAST:
        raise FormatError(f"{where}: expected frames below {_LAST:.0e}, found {start:g} and {stop:g}.")
    label = entry.get("label")
    return start, stop, "" if label is None else str(label), values.get("score", math.nan)


def _is_number(word: str) -> bool:
    try:
        return math.isfinite(float(word))
    except ValueError:
        return False
