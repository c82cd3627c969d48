"""What a search for patterns wrote, read again: occurrences, pairs, and of which recording."""

from __future__ import annotations

import json
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from leitmotion.io.annotation_table import recordings_of_table
from leitmotion.io.annotations import parse_documents, read_annotations
from leitmotion.io.containers import read_file
from leitmotion.io.dataset_labels import decoded
from leitmotion.io.sources import split_window
from leitmotion.motion import DataError, FormatError, ParameterError, Segmentation

_TABLES = (".csv", ".tsv")
_WRITE_IT = "Write it with leitmotion patterns INPUT -o found.json."


class StoredPatterns(NamedTuple):
    """What was found in one recording."""

    recording: str
    """Path of the recording as it was typed; empty where the file does not tell."""
    frames: int
    """Its length; 0 where the file does not tell."""
    occurrences: Segmentation
    """Each occurrence with the id of its pattern."""
    pairs: np.ndarray | None
    """(K, 4) start and stop of both stretches, frames; None where the file holds no pairs."""


def read_answers(path: str | PathLike[str], *, rate: float | None = None) -> list[StoredPatterns]:
    """Read what ``leitmotion patterns -o`` wrote of one recording or of several.

    Parameters
    ----------
    path : str or path
        ``.json``, ``.csv`` or ``.eaf``.
    rate : float, optional
        Frames per second of the recordings, when the file does not tell: an ``.eaf`` never does.

    Returns
    -------
    list of StoredPatterns
        One a recording, in the file's order.

    Raises
    ------
    FormatError
        When the file is missing or is no answer of a search for patterns.
    DataError
        When an answer is about a part of a recording.
    ParameterError
        When neither the file nor `rate` tells the frame rate.
    """
    path, content = read_file(Path(path))
    if path.suffix.lower() in _TABLES:
        return _of_table(decoded(content), path, rate)
    if path.suffix.lower() not in (".json", ".eaf"):
        raise FormatError(
            f"{path.name}: expected the answer of a search for patterns (.json, .csv, .eaf or .npz), found another.",
            remedy=_WRITE_IT,
        )
    if path.suffix.lower() == ".eaf":
        if rate is None:
            raise _no_rate(path)
        return [StoredPatterns("", 0, read_annotations(path, rate=rate), None)]
    documents = parse_documents(decoded(content), path)
    return [_of_document(one, path) for one in (documents if isinstance(documents, list) else [documents])]


def _of_document(document: Any, path: Path) -> StoredPatterns:
    if isinstance(document, dict) and isinstance(document.get("error"), dict):
        raise FormatError(f"{path.name} holds no answer but an error: {document['error'].get('message', '')}")
    try:
        source, result = document["source"][0], document["result"]
        recording, frames, rate = str(source["path"]), int(source["frames"]), float(source["rate"])
        window = document["parameters"].get("window")
        spans = [
            (one["start"], one["stop"], each["id"])
            for each in result["patterns"]
            for one in each["occurrences"]
        ]
        pairs = [[pair[side][end] for side in "ab" for end in ("start", "stop")] for pair in result["pairs"]]
        answer = StoredPatterns(
            recording,
            frames,
            Segmentation(
                np.array([start for start, _, _ in spans], dtype=np.int64),
                np.array([stop for _, stop, _ in spans], dtype=np.int64),
                tuple(str(name) for _, _, name in spans),
                rate=rate,
            ),
            np.array(pairs, dtype=np.int64).reshape(-1, 4),
        )
    except (
        KeyError,
        IndexError,
        TypeError,
        ValueError,
        OverflowError,
        AttributeError,
        ParameterError,
    ) as error:
        raise FormatError(
            f"{path.name}: expected what `leitmotion patterns` writes, found another document ({error}).",
            remedy=_WRITE_IT,
        ) from None
    if window is not None:
        raise _only_a_part(path, recording)
    return answer


def _of_table(text: str, path: Path, rate: float | None) -> list[StoredPatterns]:
    told = rate or rate_of(path)
    if told is None:
        raise _no_rate(path)
    held = []
    for recording in recordings_of_table(text, path) or [""]:
        if split_window(recording)[1] is not None:
            raise _only_a_part(path, recording)
        held.append(StoredPatterns(recording, 0, read_annotations(path, rate=told, trial=recording), None))
    return held


def rate_of(path: str | PathLike[str]) -> float | None:
    """Tell the frame rate of a recording from a file of stretches in it, where they stand in frames and in seconds.

    Parameters
    ----------
    path : str or path
        ``.csv`` or ``.json``.

    Returns
    -------
    float or None
        Frames per second; None where the file does not tell.
    """
    path, content = read_file(Path(path))
    text = decoded(content)
    if path.suffix.lower() == ".json":
        return _rate_of_json(text)
    if path.suffix.lower() not in _TABLES:
        return None
    # read once in frames and once in seconds: they agree at the one rate
    import csv

    rows = csv.DictReader(text.splitlines(), delimiter=max(",;\t", key=text.partition("\n")[0].count))
    best: tuple[float, float] | None = None
    for row in rows:
        try:
            stop, stop_s = float(row["stop"]), float(row["stop_s"])
        except (KeyError, TypeError, ValueError):
            return None
        if stop_s > 0 and (best is None or stop > best[0]):
            best = stop, stop_s
    return None if best is None else _nice(best[0] / best[1], best[1])


def _nice(rate: float, seconds: float) -> float:
    """The whole rate, where one is as near as seconds of four decimals can tell."""
    whole = round(rate)
    return float(whole) if whole and abs(rate - whole) <= 1e-4 * rate / seconds else rate


def _rate_of_json(text: str) -> float | None:
    try:
        document = json.loads(text)
        told = document["rate"] if "rate" in document else document["source"][0]["rate"]
        return float(told) if float(told) > 0 else None
    except (ValueError, TypeError, KeyError, IndexError, RecursionError):
        return None


def _no_rate(path: Path) -> ParameterError:
    return ParameterError(
        f"{path.name} does not tell the frame rate of the recording.", remedy="Say it: --rate HZ, or rate=."
    )


def _only_a_part(path: Path, recording: str) -> DataError:
    return DataError(
        f"{path.name} is the answer about a part of a recording, {recording}.",
        remedy="Search the whole recording, as the truth tells of the whole.",
    )
