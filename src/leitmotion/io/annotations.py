"""Labelled stretches of time on disk: CSV, JSON and EAF both ways, and two layouts of public data sets.

A stretch is ``{"start", "stop", "start_s", "stop_s", "label", "score"}``: frames half-open, seconds beside them. In CSV
these are columns. Where a file has seconds only, or numbers with a decimal point, they are seconds; where it has both
and they belong to another rate, the seconds count. The answer of a search for patterns is read as labels, too: each
occurrence with the name of its pattern.
"""

from __future__ import annotations

import csv
import io
import json
import math
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from leitmotion.io.annotation_table import COLUMNS, from_table, row_of
from leitmotion.io.containers import read_file
from leitmotion.io.dataset_labels import Row, decoded, from_aca, from_blocks, is_aca, is_blocks
from leitmotion.io.elan import read_eaf
from leitmotion.io.elan_writing import eaf_of
from leitmotion.io.files import write_whole
from leitmotion.motion import FormatError, ParameterError, Segmentation

_LISTS = ("segments", "stretches", "repetitions", "occurrences", "spans")
_NOT_READ = {
    ".textgrid": "Praat", ".anvil": "Anvil", ".trs": "Transcriber", ".boris": "BORIS", ".srt": "subtitle",
    ".vtt": "subtitle",
}  # fmt: skip
"""Annotations that are known but not read, by extension in lower case, and whose they are."""


def read_annotations(
    path: str | PathLike[str],
    *,
    rate: float,
    trial: str | None = None,
    tier: str | None = None,
    frames: int | None = None,
) -> Segmentation:
    """Read labelled stretches of a recording.

    Parameters
    ----------
    path : str or path
        ``.csv``, ``.json``, ``.eaf`` of ELAN, or the text layouts of the ACA annotation of CMU subject 86 (blocks of
        ``name earliest best latest`` frames at which a segment ends) and of mocap6 (one number per 12 frames, names in
        ``action_names.csv`` beside it).
    rate : float
        Frames per second of the recording.
    trial : str, optional
        Which block of a file with several, such as "86_01"; in a table with a column ``path`` or ``recording``, whose
        rows: by the path, its end, or the file's name without ending.
    tier : str, optional
        Which tier of an EAF with several, "*" for all. An annotation there that is shorter than a frame has one.
    frames : int, optional
        Length of the recording; stretches are cut to it.

    Returns
    -------
    Segmentation
        The stretches in the file's order.

    Raises
    ------
    FormatError
        When the file is missing or has another layout.
    ParameterError
        When the file holds several trials and `trial` is none of them, or several tiers and `tier` is none of them.
    """
    path, content = read_file(Path(path))
    if path.suffix.lower() in _NOT_READ:
        raise FormatError(
            f"{path.name}: {_NOT_READ[path.suffix.lower()]} annotations are not read.",
            remedy="Save them as CSV with the columns start_s, stop_s, label, or as ELAN's .eaf.",
        )
    if path.suffix.lower() == ".eaf":
        return _segmentation(_from_eaf(content, rate, tier, path), rate, frames, path)
    text = decoded(content)
    if path.suffix.lower() == ".json" or text.lstrip().startswith(("{", "[")):
        rows = _from_json(text, rate, path)
    elif is_blocks(text):
        rows = from_blocks(text, rate, path)
    elif path.suffix.lower() in (".csv", ".tsv"):
        rows = from_table(text, rate, path, trial)
    elif is_aca(text):
        rows = from_aca(text, rate, trial, path)
    else:
        rows = from_table(text, rate, path, trial)
    return _segmentation(rows, rate, frames, path)


def write_annotations(
    segmentation: Segmentation,
    path: str | PathLike[str],
    *,
    tier: str = "labels",
    media: str | PathLike[str] | None = None,
) -> Path:
    """Write labelled stretches as ``.csv`` or ``.json``, frames and seconds, or as ``.eaf`` for ELAN, milliseconds.

    Parameters
    ----------
    segmentation : Segmentation
        The stretches.
    path : str or path
        The file; its extension chooses the layout.
    tier : str
        What the tier of an EAF is called; stretches that overlap stand on further ones, ``labels 2``.
    media : str or path, optional
        The video or sound that ELAN opens with an EAF.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ParameterError
        When the extension is another, or a label is no text for an EAF.
    """
    path = Path(path)
    if path.suffix.lower() == ".eaf":
        return write_whole(
            path, eaf_of(segmentation, tier=tier, media=None if media is None else Path(media))
        )
    rows = as_stretches(segmentation)
    if path.suffix.lower() == ".json":
        document = {"rate": segmentation.rate, "segments": rows}
        return write_whole(path, json.dumps(document, ensure_ascii=False, indent=1) + "\n")
    if path.suffix.lower() == ".csv":
        file = io.StringIO()
        plain = all(label.isprintable() and label == label.strip() for label in segmentation.labels)
        writer = csv.writer(
            file, lineterminator="\n", quoting=csv.QUOTE_MINIMAL if plain else csv.QUOTE_NONNUMERIC
        )
        writer.writerow(COLUMNS)
        writer.writerows([["" if row[name] is None else row[name] for name in COLUMNS] for row in rows])
        return write_whole(path, file.getvalue())
    raise ParameterError(f"Annotations are written as .csv, .json or .eaf, got {path.suffix or path.name!r}.")


def as_stretches(segmentation: Segmentation) -> list[dict[str, Any]]:
    """Spell stretches as the house's JSON does; a score that is not finite is None.

    Parameters
    ----------
    segmentation : Segmentation
        S stretches.

    Returns
    -------
    list of dict, S
        With the keys start, stop, start_s, stop_s, label, score.

    Examples
    --------
    >>> as_stretches(Segmentation([0], [60], ("walk",), rate=120))[0]["stop_s"]
    0.5
    """
    return [
        {
            "start": start, "stop": stop,
            "start_s": start / segmentation.rate, "stop_s": stop / segmentation.rate,
            "label": label, "score": score if math.isfinite(score) else None,
        }
        for start, stop, label, score in segmentation
    ]  # fmt: skip


def _from_eaf(content: bytes, rate: float, tier: str | None, path: Path) -> list[Row]:
    rows = []
    for start, stop, label in read_eaf(content, path, tier):
        first = round(start * rate)
        rows.append((float(first), float(max(round(stop * rate), first + 1)), label, math.nan))
    return rows


def _segmentation(rows: list[Row], rate: float, frames: int | None, path: Path) -> Segmentation:
    spans = []
    for start, stop, label, score in rows:
        first, last = round(start), round(stop)
        if frames is not None:
            first, last = min(first, frames), min(last, frames)
            if first == last:
                continue
        spans.append((first, last, label, score))
    try:
        return Segmentation(
            np.array([start for start, _, _, _ in spans], dtype=np.int64),
            np.array([stop for _, stop, _, _ in spans], dtype=np.int64),
            tuple(label for _, _, label, _ in spans),
            np.array([score for _, _, _, score in spans], dtype=np.float64),
            rate,
        )
    except ParameterError as error:
        raise FormatError(f"{path.name}: {error.message}") from None


def _from_json(text: str, rate: float, path: Path) -> list[Row]:
    entries = parse_documents(text, path)
    if isinstance(entries, list) and any(isinstance(entry, dict) and "result" in entry for entry in entries):
        if len(entries) > 1:
            raise FormatError(
                f"{path.name}: expected the answer about one recording, found {len(entries)} answers.",
                remedy="Keep the answer about this recording.",
            )
        entries = entries[0]
    if isinstance(entries, dict):
        entries = entries.get("result", entries)
    if isinstance(entries, dict) and "patterns" in entries:
        entries = _occurrences(entries["patterns"])
    elif isinstance(entries, dict):
        entries = next((entries[name] for name in _LISTS if name in entries), None)
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise FormatError(
            f"{path.name}: expected a list of stretches, alone or under one of the names "
            f"{', '.join(_LISTS)}, or the answer of a search for patterns."
        )
    return [row_of(entry, rate, f"{path.name}, stretch {k + 1}") for k, entry in enumerate(entries)]


def parse_documents(text: str, path: Path) -> Any:
    """A document, or the list of documents of which each has a line."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        try:
            return [json.loads(line) for line in text.splitlines() if line.strip()]
        except (ValueError, RecursionError):
            raise FormatError(f"{path.name} is no JSON: {error}.") from None


def _occurrences(patterns: Any) -> list[dict[str, Any]] | None:
    """The occurrences of all patterns, each with its pattern's name; None where they are not what they should be."""
    if not isinstance(patterns, list) or not all(isinstance(pattern, dict) for pattern in patterns):
        return None
    found: list[dict[str, Any]] = []
    for pattern in patterns:
        occurrences = pattern.get("occurrences")
        if not isinstance(occurrences, list) or not all(isinstance(entry, dict) for entry in occurrences):
            return None
        found += [{**entry, "label": pattern.get("id", entry.get("label"))} for entry in occurrences]
    return found
