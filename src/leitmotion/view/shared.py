"""The page of several recordings: what they share, a lane for each, and any two times of a movement together.

Conventions
-----------
The page counts one time through all recordings, one after another (:mod:`leitmotion.view.in_a_row`); ``parts`` tells
where each lies in it, and a person reads the seconds of the recording itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath
from typing import Any

import numpy as np

from leitmotion.body import Body
from leitmotion.discovery import SharedPattern, SharedPatterns
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view.choose import look_across
from leitmotion.view.counting import clock, count_word, plural, times_word
from leitmotion.view.in_a_row import ROW_RATE, Row, in_a_row
from leitmotion.view.lengths import shared_lasts
from leitmotion.view.payload import page_payload
from leitmotion.view.report import assembled
from leitmotion.view.words import Chip, Lead, as_they_stand, listed

LEAD_CHIPS = 8


def shared_page(
    bodies: Sequence[Body],
    found: SharedPatterns,
    matrix: SimilarityMatrix,
    *,
    paths: Sequence[str] = (),
) -> str:
    """Draw what recordings share as one HTML page that needs nothing beside it.

    Parameters
    ----------
    bodies : sequence of Body
        One person each, as they were searched.
    found : SharedPatterns
        What they share; may be nothing, the page is worth opening all the same.
    matrix : SimilarityMatrix
        Every moment of all recordings, one after another, against every other
        (:func:`leitmotion.view.in_a_row.features_in_a_row`).
    paths : sequence of str
        Where the recordings are from.

    Returns
    -------
    str
        The page.

    Raises
    ------
    ParameterError
        When the bodies are not those that were searched, or the matrix does not cover them.
    """
    return assembled(shared_payload(bodies, found, matrix, paths=paths))


def shared_payload(
    bodies: Sequence[Body],
    found: SharedPatterns,
    matrix: SimilarityMatrix,
    *,
    paths: Sequence[str] = (),
) -> dict[str, Any]:
    """Turn what recordings share into what the page holds.

    Parameters
    ----------
    bodies, found, matrix, paths
        As for :func:`shared_page`.

    Returns
    -------
    dict
        The document of :func:`leitmotion.view.page_payload` for all recordings one after another, with ``parts``.
    """
    found = found.replace(names=_bare(found.names))
    row = in_a_row(bodies, found)
    page = page_payload(row.body, row.patterns, matrix, source={})
    seconds = float((found.frames / found.rates).sum())
    page["title"], page["strips"] = title(found), []
    page["lead"] = [{"chip": piece.id} if isinstance(piece, Chip) else piece for piece in lead(found)]
    page["source"] |= {
        "name": " · ".join(found.names) if len(found.names) <= 3 else plural(len(found.names), "recording"),
        "path": "; ".join(paths),
        "facts": f"{clock(seconds)} in all",
    }
    page["parts"] = [_part(found, row, k) for k in range(len(found.names))]
    for told, pattern in zip(page["patterns"], found.patterns, strict=True):
        told["head"], told["sub"] = pattern_head(pattern, found)
        for stretch, (recording, start, stop, _) in zip(told["stretches"], pattern.stretches, strict=True):
            span = start / found.rates[recording], stop / found.rates[recording]
            stretch |= _stretch_words(pattern, found.names[recording], *span, len(stretch["cycles"]))
    if page["lesson"] is not None:
        _order_steps(page, found)
    if not found.patterns:
        page["empty"] = empty_text(found, as_they_stand(row.patterns, row.body))
    return page


def title(found: SharedPatterns) -> str:
    """Say what recordings share, as the heading of the page.

    Parameters
    ----------
    found : SharedPatterns
        What they share.

    Returns
    -------
    str
        For example ``"Three recordings share four movements"``.

    Examples
    --------
    >>> title(SharedPatterns((), (), ("a", "b"), [30, 60], [300, 1200], {}))
    'Two recordings share nothing'
    """
    shared = len(found.shared)
    what = f"{count_word(shared)} movement{'' if shared == 1 else 's'}" if shared else "nothing"
    return f"{count_word(len(found.names)).capitalize()} recordings share {what}"


def lead(found: SharedPatterns) -> Lead:
    """Say in one line which pattern occurs in how many recordings.

    Parameters
    ----------
    found : SharedPatterns
        What they share.

    Returns
    -------
    tuple of str and Chip
        The pieces of the line, in order.
    """
    if not found.patterns:
        return ("Nothing repeats in any of them, either.",)
    by_count: dict[int, list[str]] = {}
    for pattern in found.patterns[:LEAD_CHIPS]:
        by_count.setdefault(len(pattern.recordings), []).append(pattern.id)
    pieces: list[str | Chip] = []
    for count in sorted(by_count, reverse=True):
        ids = by_count[count]
        many = "" if len(ids) == 1 else "s"
        if count == 1:
            where = f" recur{'s' if len(ids) == 1 else ''} within a single one. "
        else:
            every = count == len(found.names)
            told = ("both" if count == 2 else f"all {count_word(count)}") if every else count_word(count)
            where = f" occur{'' if many else 's'} in {told}. "
        pieces += [*listed(ids), where]
    rest = len(found) - LEAD_CHIPS
    if rest > 0:
        pieces.append(f"{count_word(rest).capitalize()} more {'recurs' if rest == 1 else 'recur'}. ")
    if found.nearest_miss:
        pieces.append(found.nearest_miss)
    return tuple(pieces)


def pattern_head(pattern: SharedPattern, found: SharedPatterns) -> tuple[str, str]:
    """Say in two lines in how many recordings a pattern occurs, and how often.

    Parameters
    ----------
    pattern : SharedPattern
        What recurs.
    found : SharedPatterns
        What it is one of.

    Returns
    -------
    tuple of str
        For example ``("3 of 4 recordings", "7 cycles of 1.10 s")``.
    """
    where = (
        f"{len(pattern.recordings)} of {len(found.names)} recordings"
        if len(pattern.recordings) > 1
        else f"only {found.names[pattern.recordings[0]]}"
    )
    count = len(pattern.occurrences)
    if pattern.kind == "cyclic":
        return where, f"{plural(count, 'cycle')} of {shared_lasts(pattern, found)}"
    return where, f"{times_word(count)}, {shared_lasts(pattern, found)} each"


def empty_text(found: SharedPatterns, remark: str) -> str:
    """Say that nothing was found, and what the page can still do."""
    sentences = ["No movement comes back, neither in two recordings nor within one."]
    sentences += [sentence for sentence in (found.nearest_miss, remark) if sentence]
    return " ".join([*sentences, "You can still play them and compare any two moments."])


def _bare(names: Sequence[str]) -> tuple[str, ...]:
    """Names without their ending, where all end alike and differ without it."""
    bare = tuple(str(PurePath(name).with_suffix("")) if name else name for name in names)
    alike = len({PurePath(name).suffix.lower() for name in names}) == 1
    return bare if alike and len(set(bare)) == len(set(names)) else tuple(names)


def _part(found: SharedPatterns, row: Row, k: int) -> dict[str, Any]:
    frames = slice(int(row.starts[k]), int(row.stops[k]))
    drawn = row.body.positions[frames]
    flat = drawn.shape[2] == 2
    count = int(np.count_nonzero(found.counts[k]))
    return {
        "name": found.names[k],
        "start": frames.start / ROW_RATE,
        "stop": frames.stop / ROW_RATE,
        "seconds": float(found.frames[k] / found.rates[k]),
        "sub": f"{clock(found.frames[k] / found.rates[k])}, {plural(count, 'movement') if count else 'none'}",
        "yaw": 0.0 if flat else look_across(drawn, row.body.facing[frames]),
    }


def _stretch_words(
    pattern: SharedPattern, name: str, start: float, stop: float, cycles: int
) -> dict[str, str]:
    inside = f" · {plural(cycles, 'cycle')}" if pattern.kind == "cyclic" else ""
    reason = f": {pattern.reason.rstrip('.')}" if pattern.reason else ""
    return {
        "name": f"Pattern {pattern.id} in {name}, {start:.1f} to {stop:.1f} seconds",
        "tip": f"{pattern.id} in {name} · {clock(start)} to {clock(stop)}{inside} · "
        f"confidence {pattern.confidence:.2f}{reason}",
    }


def _order_steps(page: dict[str, Any], found: SharedPatterns) -> None:
    """Shared patterns first, as everywhere else; a step tells in how many recordings."""
    for step in page["lesson"]["steps"]:
        step["times"], step["seconds"] = pattern_head(found.patterns[step["pattern"]], found)
