"""The JSON contract: one document per input, the same shape from every verb.

::

    {"leitmotion", "verb", "source": [{"path", "sha256", "frames", "rate", "seconds"}],
     "parameters", "warnings", "result"}
    {"leitmotion", "verb", "source": [{"path"}], "error": {"type", "message", "remedy"}}

Conventions
-----------
A stretch of time is always ``{"start", "stop", "start_s", "stop_s", "label", "score"}``, frames half-open, counted
from the start of what was read: of the window, where one was given. Numbers that are not finite are ``null``.
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from leitmotion import __version__

if TYPE_CHECKING:
    import numpy as np

    from leitmotion.api import Calibration, Info, Patterns, Repaired, Residual, Segmentation
    from leitmotion.cli.failures import Failure
    from leitmotion.cli.inputs import Input

Document = dict[str, Any]

SECONDS_DIGITS = 4
"""Decimals of a time: a tenth of a millisecond, finer than any frame."""
SCORE_DIGITS = 4
"""Decimals of a score or a confidence."""
COST_DIGITS = 6
"""Decimals of a distance: a micrometre, finer than any recording."""
SIGNIFICANT = 9
"""Significant digits of every other number."""


def answer_document(
    verb: str,
    source: list[Document],
    *,
    parameters: Mapping[str, object],
    warnings: Sequence[str],
    result: Document,
) -> Document:
    """Make the document of an input that was answered."""
    return {
        "leitmotion": __version__,
        "verb": verb,
        "source": source,
        "parameters": plain(parameters),
        "warnings": list(warnings),
        "result": plain(result),
    }


def error_document(verb: str, given: Input, failure: Failure) -> Document:
    """Make the document of an input that failed."""
    return {
        "leitmotion": __version__,
        "verb": verb,
        "source": [{"path": given.shown}],
        "error": {"type": failure.type, "message": failure.message, "remedy": failure.remedy},
    }


def as_line(document: Document) -> str:
    """Write a document as one line of JSON."""
    return json.dumps(document, allow_nan=False)


def source_entry(given: Input, *, frames: int, rate: float, sha256: str = "") -> Document:
    """Say what was read: the file as typed, its checksum (taken here where it is not known), and how much of it."""
    return {
        "path": given.shown,
        "sha256": sha256 or given.sha256(),
        "frames": frames,
        "rate": rounded(rate, significant=SIGNIFICANT),
        "seconds": round(frames / rate, SECONDS_DIGITS),
    }


def reading_parameters(
    given: Mapping[str, object], window: tuple[int, int] | None, *, swap_sides: bool = False
) -> Document:
    """Say how the file was read where the person said so, which frames of it when not all, and sides if swapped."""
    parameters: Document = {"reading": dict(given)} if given else {}
    if swap_sides:
        parameters["swap_sides"] = True
    if window is not None:
        parameters["window"] = {"start": window[0], "stop": window[1]}
    return parameters


def stretch(start: int, stop: int, *, rate: float, label: str = "", score: float = math.nan) -> Document:
    """Make a stretch of time.

    Parameters
    ----------
    start, stop : int
        Frames, half-open.
    rate : float
        Frames per second.
    label : str
        What it is called.
    score : float
        How sure it is or how well it fits; NaN where nobody said.

    Returns
    -------
    dict
        The stretch of the contract.

    Examples
    --------
    >>> stretch(120, 300, rate=120.0, label="A", score=0.91)
    {'start': 120, 'stop': 300, 'start_s': 1.0, 'stop_s': 2.5, 'label': 'A', 'score': 0.91}
    """
    return {
        "start": int(start),
        "stop": int(stop),
        "start_s": round(start / rate, SECONDS_DIGITS),
        "stop_s": round(stop / rate, SECONDS_DIGITS),
        "label": label,
        "score": decimals(score, SCORE_DIGITS),
    }


def patterns_result(found: Patterns) -> Document:
    """Make the result of the verb `patterns`."""
    rate = found.rate
    return {
        "patterns": [
            {
                "id": pattern.id,
                "kind": pattern.kind,
                "occurrences": _stretches(pattern.occurrences, pattern.id),
                "cycles": pattern.cycles,
                "period_s": decimals(pattern.period_s, SECONDS_DIGITS),
                "cost": decimals(pattern.cost, COST_DIGITS),
                "confidence": decimals(pattern.confidence, SCORE_DIGITS),
                "reason": pattern.reason,
                "stretches": _stretches(pattern.stretches, pattern.id),
            }
            for pattern in found.patterns
        ],
        "pairs": [
            {
                "pattern": pair.pattern,
                "a": stretch(*pair.a, rate=rate, label=pair.pattern),
                "b": stretch(*pair.b, rate=rate, label=pair.pattern),
                "cost": decimals(pair.cost, COST_DIGITS),
            }
            for pair in found.pairs
        ],
        "nearest_miss": found.nearest_miss,
    }


def residual_result(missed: Residual) -> Document:
    """Make the part of the result that tells what may have been missed, where it was asked for."""
    rate = missed.rate
    return {
        "residual": {
            "candidates": [
                {
                    "a": stretch(*candidate.a, rate=rate),
                    "b": stretch(*candidate.b, rate=rate),
                    "correlation": decimals(candidate.correlation, SCORE_DIGITS),
                }
                for candidate in missed.candidates
            ],
            "left_over": _stretches(missed.left_over, ""),
            "parameters": missed.parameters,
        }
    }


def calibrate_result(found: Calibration, *, measured_in: str) -> Document:
    """Make the result of the verb `calibrate`."""
    check = found.check
    return {
        "threshold": decimals(found.threshold, COST_DIGITS),
        "threshold_interval": [decimals(end, COST_DIGITS) for end in found.threshold_interval],
        "measured_in": measured_in,
        "equal_error_rate": decimals(found.equal_error_rate, SCORE_DIGITS),
        "equal_error_rate_interval": [decimals(end, SCORE_DIGITS) for end in found.rate_interval],
        "alike": found.alike,
        "not_alike": found.not_alike,
        "curve": [
            {
                "threshold": decimals(threshold, COST_DIGITS),
                "false_match": decimals(false_match, SCORE_DIGITS),
                "false_non_match": decimals(false_non_match, SCORE_DIGITS),
            }
            for threshold, false_match, false_non_match in zip(
                found.thresholds, found.false_match, found.false_non_match, strict=True
            )
        ],
        "check": None
        if check is None
        else {
            "error": decimals(check.error, SCORE_DIGITS),
            "error_interval": [decimals(end, SCORE_DIGITS) for end in check.interval],
            "false_match": decimals(check.false_match, SCORE_DIGITS),
            "false_non_match": decimals(check.false_non_match, SCORE_DIGITS),
            "alike": check.alike,
            "not_alike": check.not_alike,
        },
    }


def repair_result(mended: Repaired, *, written: Path | None, suggestion: str) -> Document:
    """Make the result of the verb `repair`."""
    rate = mended.recording.rate
    return {
        "changes": [
            {
                "what": change.what,
                "joint": change.joint,
                "frames": change.stop - change.start,
                "detail": change.detail,
                "stretch": stretch(change.start, change.stop, rate=rate, label=change.what),
            }
            for change in mended.changes
        ],
        "left": mended.remarks,
        "suggestion": suggestion,
        "written": written,
    }


def info_result(info: Info, commands: Sequence[str]) -> Document:
    """Make the result of the verb `info`; of each problem there is a command that mends it, or nothing."""
    findings = {what: dataclasses.asdict(finding) for what, finding in info.findings.items()}
    asf = findings.pop("skeleton", None)
    held: Document = {"count": len(info.names), "names": info.names}
    if info.kind == "skeleton":
        held["file"] = asf
    else:
        held |= {"dimensions": info.dimensions, "unseen": decimals(info.unseen, SCORE_DIGITS)}
    return {
        "kind": info.kind,
        info.kind: held,
        "people": info.people,
        "roles": [
            {"role": role, "members": members, "confidence": decimals(sure, SCORE_DIGITS)}
            for role, members, sure in zip(
                info.roles.roles, info.roles.members, info.roles.confidence, strict=True
            )
        ],
        **findings,
        "problems": [
            {
                "what": problem.what,
                "message": problem.message,
                "remedy": problem.remedy,
                "command": command,
            }
            for problem, command in zip(info.problems, commands, strict=True)
        ],
    }


def curve(values: np.ndarray, rate: float) -> Document:
    """Tell the mean, the least and the most of a curve along time, and when it is most; None where nothing is seen."""
    import numpy as np

    if not np.isfinite(values).any():
        return dict.fromkeys(("mean", "least", "most", "most_at_s"))
    return {
        "mean": float(np.nanmean(values)),
        "least": float(np.nanmin(values)),
        "most": float(np.nanmax(values)),
        "most_at_s": round(float(np.nanargmax(values)) / rate, SECONDS_DIGITS),
    }


def plain(value: Any) -> Any:
    """Make any value plain JSON: NumPy numbers and arrays, tuples and paths as JSON has them, NaN as None."""
    if isinstance(value, Mapping):
        return {str(key): plain(held) for key, held in value.items()}
    if isinstance(value, list | tuple | set | frozenset):
        return [plain(held) for held in (sorted(value) if isinstance(value, set | frozenset) else value)]
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, float):
        return rounded(value, significant=SIGNIFICANT)
    if isinstance(value, Path):
        return str(value)
    return value


def rounded(value: float, *, significant: int) -> float | None:
    """Round to so many significant digits; None where the number is not finite."""
    return float(f"{value:.{significant}g}") if math.isfinite(value) else None


def decimals(value: float, digits: int) -> float | None:
    """Round to so many decimals; None where the number is not finite."""
    return round(float(value), digits) if math.isfinite(value) else None


def _stretches(spans: Segmentation, label: str) -> list[Document]:
    return [
        stretch(start, stop, rate=spans.rate, label=named or label, score=score)
        for start, stop, named, score in spans
    ]
