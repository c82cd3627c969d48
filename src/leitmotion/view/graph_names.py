"""How states and paths are written: a bar over what is symmetric, stars above, subscripts below (paper S, 3.5)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from leitmotion.discovery import MotionGraph, Path, State

ONE_WAY, BOTH_WAYS = "→", "↔"


class Piece(NamedTuple):
    """Letters of one kind."""

    text: str
    kind: str
    """"plain", "bar" over them, "above" or "below" the line."""


def pieces_of(item: State | Path) -> tuple[Piece, ...]:
    """Part a name into what is written how.

    Parameters
    ----------
    item : State or Path
        Of a graph.

    Returns
    -------
    tuple of Piece
        In order.

    Examples
    --------
    >>> pieces_of(Path("xy2", "X", "Y", True, False, ()))
    (Piece(text='xy', kind='bar'), Piece(text='2', kind='below'))
    >>> [piece.text for piece in pieces_of(Path("(aa*)*", "A*", "A", False, False, ()))]
    ['(aa', '*', ')', '*']
    """
    plain = "bar" if item.symmetric else "plain"
    found = re.findall(r"(\*+)|(\d+)|([^*\d]+)", item.name)
    kinds = ("above", "below", plain)
    return tuple(
        Piece(text, kind) for groups in found for text, kind in zip(groups, kinds, strict=True) if text
    )


def in_math(item: State | Path) -> str:
    """Write a name as matplotlib's mathematical text, without its dollar signs.

    Parameters
    ----------
    item : State or Path
        Of a graph.

    Returns
    -------
    str
        Upright letters.
    """
    forms = {"plain": r"\mathrm{%s}", "bar": r"\overline{\mathrm{%s}}", "above": "^{%s}", "below": "_{%s}"}
    return "".join(forms[piece.kind] % piece.text for piece in pieces_of(item))


def arrow_of(path: Path) -> str:
    """Tell by an arrow whether a path was gone both ways."""
    return BOTH_WAYS if path.reversible else ONE_WAY


def times(count: int) -> str:
    """Say how often a path was gone: "once", "4 times"; "reflected" where only its mirror image was."""
    return {0: "reflected", 1: "once", 2: "twice"}.get(count, f"{count} times")


def in_rows(items: Iterable[str], width: int, lengths: Iterable[int]) -> list[str]:
    """Break a list of written names into rows of about so many letters."""
    rows: list[list[str]] = [[]]
    used = 0
    for item, length in zip(items, lengths, strict=True):
        if rows[-1] and used + length > width:
            rows.append([])
            used = 0
        rows[-1].append(item)
        used += length + 2
    return [", ".join(row) for row in rows]


def partner_of(item: State | Path, graph: MotionGraph) -> State | Path | None:
    """Find the mirror image of a state or a path in its graph, None where it is its own or not there."""
    among: Iterable[State | Path] = graph.states if isinstance(item, State) else graph.paths
    return next((other for other in among if other.name == item.mirror and other.name != item.name), None)
