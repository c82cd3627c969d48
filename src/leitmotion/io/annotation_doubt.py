"""What annotations tell beside labels: where none holds, and how often a movement happens within a stretch."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

from leitmotion.io.annotation_table import cycles_of_table
from leitmotion.io.containers import read_file
from leitmotion.io.dataset_labels import Span, aca_intervals, block_changes, decoded, is_aca, is_blocks

_EXACT = (".csv", ".tsv", ".json", ".eaf")
"""Layouts in which every stretch says where it begins and ends."""


def read_unlabelled(
    path: str | PathLike[str], *, rate: float, trial: str | None = None
) -> list[tuple[int, int]]:
    """Read in which spans of a recording nobody can say which label holds.

    Parameters
    ----------
    path : str or path
        Any file that :func:`read_annotations` takes. In the ACA layout the span from the earliest to the latest end of
        a segment has no label, in that of mocap6, whose labels stand in tenths of a second, a quarter of a second on
        both sides of a change. Other files know no such spans.
    rate : float
        Frames per second of the recording.
    trial : str, optional
        Which block of a file with several, such as "86_01".

    Returns
    -------
    list of (int, int)
        Frames ``[start, stop)``, in order.

    Raises
    ------
    FormatError
        When the file is missing or has another layout.
    ParameterError
        When the file holds several trials and `trial` is none of them.
    """
    path, content = read_file(Path(path))
    text = decoded(content)
    spans: list[Span] = []
    if path.suffix.lower() in _EXACT:
        return []
    if is_blocks(text):
        spans = block_changes(text, rate, path)
    elif is_aca(text):
        spans = aca_intervals(text, rate, trial, path)
    return [(round(start), round(stop)) for start, stop in spans]


def read_cycles(path: str | PathLike[str], *, trial: str | None = None) -> list[tuple[float, float, float]]:
    """Read how often a movement happens within each stretch of a table, where it has a column ``cycles``.

    Parameters
    ----------
    path : str or path
        Any file that :func:`read_annotations` takes; only a table tells.
    trial : str, optional
        As for :func:`read_annotations`.

    Returns
    -------
    list of (float, float, float)
        For each stretch the count, the least and the most that a person may count (columns ``least`` and ``most``); NaN
        where nobody counted. Empty of any other file.

    Raises
    ------
    FormatError
        When the file is missing, or something else than a number stands there.
    """
    path, content = read_file(Path(path))
    if path.suffix.lower() not in (".csv", ".tsv"):
        return []
    return cycles_of_table(decoded(content), path, trial)
