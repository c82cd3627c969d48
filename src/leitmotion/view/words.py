"""The sentences of the page: plain, short, in the present; a person, not a signal.

Conventions
-----------
A *stretch* is one time the movement goes on without a break; a *cycle* is one repeat inside it. A *lead* is a tuple
of pieces: text, or :class:`Chip`, the letter of a pattern that is drawn as a coloured chip.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.body import Body
from leitmotion.discovery import Pattern, Patterns
from leitmotion.view.counting import clock, count_word, plural, times_word
from leitmotion.view.lengths import lasts

LEAD_CHIPS = 8
STILL = 0.012  # body sizes: a body of which no point goes farther keeps still
HOLES = 0.1  # share of positions unseen from which on they may be why nothing was found

PLACES = {"toe": "toes"}


class Chip(NamedTuple):
    """The letter of a pattern, drawn as its coloured chip."""

    id: str


Lead = tuple[str | Chip, ...]


def title(patterns: Patterns) -> str:
    """Say what was found, as the heading of the page.

    Parameters
    ----------
    patterns : Patterns
        What recurs.

    Returns
    -------
    str
        For example ``"Four movements recur"``.
    """
    if not len(patterns):
        return "Nothing repeats here"
    if len(patterns) == 1:
        return f"One movement recurs, {times_word(len(patterns.patterns[0].occurrences))}"
    return f"{count_word(len(patterns)).capitalize()} movements recur"


def as_they_stand(patterns: Patterns, body: Body) -> str:
    """Say that postures were compared without turning the person to one side, where the facing is unknown.

    Parameters
    ----------
    patterns : Patterns
        What was found; its parameters tell what the comparison is invariant to.
    body : Body
        The person.

    Returns
    -------
    str
        Two sentences, or one of points in a picture; empty where the person was turned.
    """
    if "yaw" in patterns.parameters.get("invariant_to", ("yaw",) if body.facing_told else ()):  # type: ignore[operator]
        return ""
    if body.positions.shape[2] == 2:
        return "In a picture nobody can be turned, so a movement seen from another side counts as another."
    return (
        "Which way the person faces is not known, so the points were compared as they stand, and a movement made in "
        "another direction counts as another. A map file that names the hips or shoulders settles it: --map FILE."
    )


def lead(patterns: Patterns, seconds: float, body: Body | None = None) -> Lead:
    """Say in one line which pattern comes back how often.

    Parameters
    ----------
    patterns : Patterns
        What recurs.
    seconds : float
        Length of the recording.
    body : Body, optional
        The person: where nothing was found, it may tell why.

    Returns
    -------
    tuple of str and Chip
        The pieces of the line, in order.
    """
    if not len(patterns):
        return (_nothing(seconds, body),)
    if len(patterns) == 1:
        only = patterns.patterns[0]
        return (Chip(only.id), f" {_stay(only)}.")
    shown = patterns.patterns[:LEAD_CHIPS]
    by_count: dict[int, list[str]] = {}
    for pattern in shown:
        by_count.setdefault(len(pattern.stretches), []).append(pattern.id)
    within = by_count.pop(1, [])
    pieces: list[str | Chip] = []
    for k, count in enumerate(sorted(by_count, reverse=True)):
        ids = by_count[count]
        pieces += [" and " if k == len(by_count) - 1 else ", "] if k else []
        pieces += listed(ids)
        verb = (" comes back " if len(ids) == 1 else " come back ") if k == 0 else " "
        pieces.append(verb + times_word(count))
    if by_count:
        pieces.append(". ")
    if within:
        verb = " repeats within one stretch." if len(within) == 1 else _each_within(len(within))
        pieces += [*listed(within), verb]
    rest = len(patterns) - len(shown)
    if rest:
        pieces.append(f" {count_word(rest).capitalize()} more {'recurs' if rest == 1 else 'recur'}.")
    return tuple(joined(pieces))


def lane_head(pattern: Pattern) -> tuple[str, str]:
    """Say in two lines how often a pattern occurs and how long one time lasts.

    Parameters
    ----------
    pattern : Pattern
        What recurs.

    Returns
    -------
    tuple of str
        For example ``("3 stretches", "4 cycles of 1.74 s")``.
    """
    return plural(len(pattern.stretches), "stretch"), _cycles(len(pattern.occurrences), pattern)


def stretch_name(pattern: Pattern, k: int) -> str:
    """Name a stretch for someone who hears the page.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    k : int
        Which of its stretches, from 0.

    Returns
    -------
    str
        For example ``"Pattern C, stretch 2 of 2, 33.9 to 38.1 seconds"``.
    """
    start, stop = _span(pattern, k)
    return f"Pattern {pattern.id}, stretch {k + 1} of {len(pattern.stretches)}, {start:.1f} to {stop:.1f} seconds"


def stretch_tip(pattern: Pattern, k: int) -> str:
    """Say all there is about a stretch, in the line that stands beside its bar.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    k : int
        Which of its stretches, from 0.

    Returns
    -------
    str
        For example ``"C, 2 of 2 · 0:33.9 to 0:38.1 · 1 cycle of 1.67 s · confidence 0.82: …"``.
    """
    start, stop = _span(pattern, k)
    inside = cycles_in(pattern, k)
    parts = [f"{pattern.id}, {k + 1} of {len(pattern.stretches)}", f"{clock(start)} to {clock(stop)}"]
    if pattern.kind == "cyclic":
        cycle = float(np.median([b - a for a, b in inside])) if inside else pattern.period_s
        parts.append(f"{plural(len(inside), 'cycle')} of {cycle:.2f} s")
    reason = f": {pattern.reason.rstrip('.')}" if pattern.reason else ""
    parts.append(f"confidence {pattern.confidence:.2f}{reason}")
    return " · ".join(parts)


def cycles_in(pattern: Pattern, k: int) -> list[tuple[float, float]]:
    """List the cycles inside a stretch, seconds; none of an acyclic pattern.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    k : int
        Which of its stretches, from 0.

    Returns
    -------
    list of (float, float)
        Start and stop of each, seconds.
    """
    if pattern.kind != "cyclic":
        return []
    first, last = int(pattern.stretches.starts[k]), int(pattern.stretches.stops[k])
    rate = pattern.occurrences.rate
    return [(a / rate, b / rate) for a, b, _, _ in pattern.occurrences if a >= first and b <= last]


def empty_text(patterns: Patterns, *, still: bool, remark: str = "") -> str:
    """Say why nothing was found and what the page can still do.

    Parameters
    ----------
    patterns : Patterns
        A search without a result.
    still : bool
        Whether the body keeps still somewhere, so that the matrix shows dark blocks.
    remark : str
        What else a person should know, such as :func:`as_they_stand` says.

    Returns
    -------
    str
        A few plain sentences.
    """
    shortest = _shortest(patterns)
    what = "half a second" if shortest == 0.5 else f"{shortest:g} s" if shortest else ""
    sentences = [f"No stretch of {what} or longer comes back." if what else "No stretch comes back."]
    if patterns.nearest_miss:
        sentences.append(patterns.nearest_miss.rstrip(".") + ".")
    if still and not patterns.parameters.get("stillness"):
        sentences.append(
            "Moments look alike only where the body keeps still (the dark blocks), "
            "and stillness does not count as a repeat."
        )
    if remark:
        sentences.append(remark)
    sentences.append("You can still play it and compare any two moments.")
    return " ".join(sentences)


def looked_for(patterns: Patterns) -> str:
    """Say what the search was for.

    Parameters
    ----------
    patterns : Patterns
        What was found, with the parameters of the search.

    Returns
    -------
    str
        One sentence.
    """
    shortest = _shortest(patterns)
    length = f"of at least {shortest:g} s " if shortest else ""
    return f"Stretches {length}whose postures come back, anywhere in the recording, in the same order."


def role_word(role: str) -> str:
    """Name a role as a person would: ``left_toe`` is "left toes".

    Parameters
    ----------
    role : str
        A role, or the name of a point.

    Returns
    -------
    str
        Its plain name.

    Examples
    --------
    >>> role_word("left_toe"), role_word("head")
    ('left toes', 'head')
    """
    side, _, place = role.partition("_")
    return f"{side} {PLACES.get(place, place)}" if side in ("left", "right") and place else role


def _stay(pattern: Pattern) -> str:
    stretches = len(pattern.stretches)
    cycles = _cycles(len(pattern.occurrences), pattern)
    if pattern.kind != "cyclic":
        return f"comes back {times_word(stretches)}, {lasts(pattern)} each"
    if stretches == 1:
        return f"repeats within one stretch: {cycles}"
    return f"comes back in {count_word(stretches)} stretches: {cycles}"


def _cycles(count: int, pattern: Pattern) -> str:
    if pattern.kind != "cyclic":
        return f"of {lasts(pattern)}"
    return f"{plural(count, 'cycle')} of {lasts(pattern)}"


def _each_within(count: int) -> str:
    return " repeat within one stretch." if count == 2 else " repeat within one stretch each."


def listed(ids: Sequence[str]) -> list[str | Chip]:
    """Letters of patterns with what stands between them: A, B and C."""
    pieces: list[str | Chip] = []
    for k, name in enumerate(ids):
        pieces += [" and " if k == len(ids) - 1 else ", "] if k else []
        pieces.append(Chip(name))
    return pieces


def joined(pieces: Sequence[str | Chip]) -> list[str | Chip]:
    """Join neighbouring texts, so that a piece is a chip or all the words up to the next one."""
    made: list[str | Chip] = []
    for piece in pieces:
        if made and isinstance(piece, str) and isinstance(made[-1], str):
            made[-1] += piece
        else:
            made.append(piece)
    if made and isinstance(made[-1], str):
        made[-1] = made[-1].rstrip()
    return made


def _nothing(seconds: float, body: Body | None) -> str:
    """Say that nothing came back, and what of that the recording itself explains."""
    if body is not None and len(body) == 1:
        return "One frame: nothing can come back in it."
    seen = np.isfinite(body.positions).all(axis=2) if body is not None else np.array([])
    if body is not None and not seen.any():
        return "No point is ever seen."
    if body is not None and _reach(body, seen) < STILL * body.size:
        return "Nothing moves here."
    unseen = 1.0 - float(seen.mean()) if seen.size else 0.0
    why = f"; {unseen:.0%} of the positions are unseen, which may be why" if unseen >= HOLES else ""
    return f"Nothing in {_these_seconds(seconds)} was near and clear enough to count as a repeat{why}."


def _reach(body: Body, seen: np.ndarray) -> float:
    """How far the point that moves most goes along an axis, in the unit of the body."""
    places = body.positions[:, seen.any(axis=0)]
    return float((np.nanmax(places, axis=0) - np.nanmin(places, axis=0)).max())


def _these_seconds(seconds: float) -> str:
    if seconds >= 100:
        return f"these {round(seconds / 60)} minutes"
    whole = max(round(seconds), 1)
    return "this second" if whole == 1 else f"these {whole} seconds"


def _span(pattern: Pattern, k: int) -> tuple[float, float]:
    rate = pattern.stretches.rate
    return float(pattern.stretches.starts[k] / rate), float(pattern.stretches.stops[k] / rate)


def _shortest(patterns: Patterns) -> float | None:
    value = patterns.parameters.get("min_duration_s")
    return float(value) if isinstance(value, int | float) else None
