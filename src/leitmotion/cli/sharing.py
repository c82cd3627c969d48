"""What several recordings share, as the result of the contract and as a person reads it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from leitmotion.cli.documents import COST_DIGITS, SCORE_DIGITS, SECONDS_DIGITS, Document, stretch
from leitmotion.cli.printing import print_table

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Body, SharedPattern, SharedPatterns
    from leitmotion.discovery import Places

LISTED = 8
"""Recordings that a row of the table tells by name; of more it tells how many."""
COLUMNS = 24
"""Patterns that the matrix shows at most."""
MANY = 30
"""Recordings from which on the matrix leaves out those that share nothing."""


def shared_result(found: SharedPatterns) -> Document:
    """Make the result of ``patterns --across``: every stretch says by "source" which recording it is of."""

    def stretches(places: Places, label: str) -> list[Document]:
        return [
            stretch(start, stop, rate=found.rates[source], label=label, score=score) | {"source": source}
            for source, start, stop, score in places
        ]

    def side(end: tuple[int, int, int], label: str) -> Document:
        source, start, stop = end
        return stretch(start, stop, rate=found.rates[source], label=label) | {"source": source}

    return {
        "patterns": [
            {
                "id": pattern.id,
                "kind": pattern.kind,
                "sources": list(pattern.recordings),
                "occurrences": stretches(pattern.occurrences, pattern.id),
                "cycles": pattern.cycles,
                "period_s": round(pattern.period_s, SECONDS_DIGITS),
                "cost": round(pattern.cost, COST_DIGITS),
                "confidence": round(pattern.confidence, SCORE_DIGITS),
                "reason": pattern.reason,
                "stretches": stretches(pattern.stretches, pattern.id),
            }
            for pattern in found.patterns
        ],
        "pairs": [
            {
                "pattern": pair.pattern,
                "a": side(pair.a, pair.pattern),
                "b": side(pair.b, pair.pattern),
                "cost": round(pair.cost, COST_DIGITS),
            }
            for pair in found.pairs
        ],
        "counts": found.counts,
        "nearest_miss": found.nearest_miss,
    }


def remarks(found: SharedPatterns, bodies: Sequence[Body]) -> list[str]:
    """List what the person should know about how the recordings were compared."""
    from leitmotion.body import ANALYSIS_ROLES
    from leitmotion.features import limbs_of

    said = []
    compared = list(found.parameters["features"])  # type: ignore[call-overload]
    directions = found.parameters["feature"] == "limb_directions"
    most = max(
        len(limbs_of(body)) if directions else sum(role in body.roles for role in ANALYSIS_ROLES)
        for body in bodies
    )
    if len(compared) < most:
        said.append(f"Not all recordings have every joint, so they were compared by {', '.join(compared)}.")
    if "compared_within_s" in found.parameters:
        said.append(
            "The recordings show so much of one movement that only those that follow one another within "
            f"{found.parameters['compared_within_s']:,g} s were compared."
        )
    if "yaw" not in found.parameters["invariant_to"]:  # type: ignore[operator]
        said.append(
            "Which way the people face is not known, so a movement made in another direction counts as another."
        )
    return said


def show_shared(console: Console, found: SharedPatterns) -> None:
    """Print what recordings share: the answer in a sentence, a row for each pattern, and who shares what.

    Parameters
    ----------
    console : Console
        Where to print.
    found : SharedPatterns
        What they share.
    """
    console.print(_title(found), style="bold")
    if found.nearest_miss:
        console.print(found.nearest_miss)
    if found.patterns:
        _show_patterns(console, found)
    limit = limit_words(found)
    if limit:
        console.print()
        console.print(limit, style="dim")


def limit_words(found: SharedPatterns) -> str:
    """Say from where on postures differ, where that is not as within one recording; empty where it is."""
    limit, within = (found.parameters.get(name) for name in ("max_distance", "max_distance_within_one"))
    if not isinstance(limit, float) or not isinstance(within, float) or limit == within:
        return ""
    directions = found.parameters.get("unit") == "rad"
    what, unit = ("directions of limbs", "radians") if directions else ("postures", "body sizes")
    return (
        f"Across recordings {what} are alike within {limit:g} {unit}, not {within:g} as within one, since two "
        "people differ more than two takes of one. So a recording can show other patterns here than alone."
    )


def _show_patterns(console: Console, found: SharedPatterns) -> None:
    """Print a row for each pattern and recording, and of three recordings or more who shares what."""
    console.print()
    print_table(
        console,
        ("", "kind", ">recordings", ">each", ">confidence", "in", ">times", "from and to"),
        [row for pattern in found.patterns for row in _rows(pattern, found)],
    )
    if len(found.names) > 2 and found.shared:
        console.print()
        _show_matrix(console, found)


def short_names(shown: Sequence[str]) -> tuple[str, ...]:
    """Recordings' names without the folder that all lie in.

    Examples
    --------
    >>> short_names(["clips/ann/walk.bvh", "clips/bob/walk.bvh"])
    ('ann/walk.bvh', 'bob/walk.bvh')
    """
    try:
        common = os.path.commonpath([os.path.dirname(name) for name in shown])
    except ValueError:  # some are absolute
        common = ""
    return tuple(name[len(common) :].lstrip("/\\") if common else name for name in shown)


def _title(found: SharedPatterns) -> str:
    from leitmotion.view.counting import count_word

    shared, recordings = len(found.shared), len(found.names)
    alone = len(found) - shared
    if not len(found):
        return f"The {count_word(recordings)} recordings share nothing, and nothing repeats in any of them."
    what = f"{count_word(shared)} movement{'' if shared == 1 else 's'}" if shared else "nothing"
    told = f"The {count_word(recordings)} recordings share {what}."
    if alone:
        more = f"{count_word(alone)}{' more' if shared else ''}".capitalize()
        told += f" {more} {'recurs' if alone == 1 else 'recur'} in a single one."
    return told


def _rows(pattern: SharedPattern, found: SharedPatterns) -> list[tuple[str, ...]]:
    """A row for each recording, how often and when; of many the first, in the order given."""
    from leitmotion.view.counting import clock
    from leitmotion.view.lengths import shared_lasts

    head = (
        pattern.id,
        pattern.kind,
        str(len(pattern.recordings)),
        shared_lasts(pattern, found),
        f"{pattern.confidence:.2f}",
    )
    rows: list[tuple[str, ...]] = []
    for recording in pattern.recordings[:LISTED]:
        rate = found.rates[recording]
        spans = [
            f"{clock(start / rate)}–{clock(stop / rate)}"
            for start, stop, _ in pattern.stretches.of(recording)
        ]
        count = str(len(pattern.occurrences.of(recording)))
        rows.append((*(("",) * 5 if rows else head), found.names[recording], count, ", ".join(spans)))
    rest = len(pattern.recordings) - LISTED
    if rest > 0:
        rows.append((*("",) * 5, f"and {rest} more", "", ""))
    return rows


def _show_matrix(console: Console, found: SharedPatterns) -> None:
    """Print how often each shared pattern occurs in each recording."""
    shown, names = found.shared[:COLUMNS], found.names
    counts = found.counts[:, : len(found.shared)]
    told = [k for k in range(len(names)) if len(names) < MANY or counts[k].any()]
    console.print("What they share", style="bold")
    print_table(
        console,
        ("", *(f">{pattern.id}" for pattern in shown)),
        [
            (names[k], *(str(count) if count else "·" for count in counts[k, : len(shown)].tolist()))
            for k in told
        ],
    )
    if len(told) < len(names):
        console.print(f"{len(names) - len(told)} recordings share nothing", style="dim")
    if len(found.shared) > len(shown):
        console.print(f"and {len(found.shared) - len(shown)} more movements", style="dim")
