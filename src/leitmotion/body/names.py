"""Names: what a joint or marker name says, whoever wrote it.

``LeftUpLeg``, ``l_thigh``, ``thigh.L``, ``lThigh``, ``mixamorig:LeftUpLeg``, ``Bip01 L Thigh`` and ``lfemur``
all say a side and a word. Sides are read from whole tokens (``left``, ``R``, the ``FL`` of ``Hip-FL``), never
from inside a word. What nearly all names begin or end with (``Bip01``, ``_JNT``) says nothing. A letter glued
to a word (``lfemur``, ``RSHO``, ``ASISl``) counts only when the rest is a word that
:mod:`leitmotion.body.vocabulary` knows and the same word stands on the other side, too.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.body.vocabulary import WORDS

SIDES = {"left": "left", "right": "right", "l": "left", "r": "right"}
CORNERS = {
    "fl": ("left", "front"), "fr": ("right", "front"), "bl": ("left", "back"), "br": ("right", "back"),
    "lf": ("left", "front"), "rf": ("right", "front"), "lb": ("left", "back"), "rb": ("right", "back"),
    "f": ("", "front"), "b": ("", "back"),
}  # fmt: skip
MIDDLE = "c"  # the side of what has none
MOST = 0.8  # of the names: a token that begins so many is the name of a character, not of a joint

_TOKEN = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|\d+")


class PointName(NamedTuple):
    """What the name of a joint or marker says."""

    side: str
    """"left", "right" or ""."""

    word: str
    """The rest in small letters without separators: ``upleg``, ``spine1``, ``hipfront``."""


def parse_names(names: Sequence[str]) -> tuple[PointName, ...]:
    """Read the names of one recording together.

    Parameters
    ----------
    names : sequence of str, P
        Names of its joints or markers.

    Returns
    -------
    tuple of PointName, P
        The side and the word of each.

    Examples
    --------
    >>> [tuple(name) for name in parse_names(["mixamorig:LeftUpLeg", "Hip-FL", "Neck_01"])]
    [('left', 'upleg'), ('left', 'hipfront'), ('', 'neck1')]
    >>> [tuple(name) for name in parse_names(["lfemur", "rfemur", "lowerback", "radius"])]
    [('left', 'femur'), ('right', 'femur'), ('', 'lowerback'), ('', 'radius')]
    """
    rows = _without_prefix([_tokens(name) for name in names])
    rows = [row[::-1] for row in _without_prefix([row[::-1] for row in rows], numbers=False)]
    return _unglue([_side_and_word(row) for row in rows])


def _tokens(name: str) -> list[str]:
    last = re.split(r"[:|]", name)[-1]  # what stands before is the name of a character or of a subject
    return [token.lower().lstrip("0") or "0" for token in _TOKEN.findall(last)]


def _without_prefix(rows: list[list[str]], numbers: bool = True) -> list[list[str]]:
    """Take off the leading tokens that nearly all names share: the ``Bip01`` of ``Bip01 L Thigh``."""
    for _ in range(max(map(len, rows), default=0)):
        token, count = Counter(row[0] for row in rows if row).most_common(1)[0]
        says = token in SIDES or token in WORDS or not (numbers or token.isalpha())
        if len(rows) < 3 or count < MOST * len(rows) or says:
            break
        rows = [row[1:] if row[:1] == [token] else row for row in rows]
    return rows


def _side_and_word(tokens: list[str]) -> PointName:
    if (len(tokens) > 1 and not tokens[1].isdigit()) or len(tokens) > 2:
        for place in (0, -1):
            if tokens[place] in SIDES:
                rest = tokens[1:] if place == 0 else tokens[:-1]
                return PointName(SIDES[tokens[place]], "".join(rest))
        if tokens[-1] in CORNERS:
            side, corner = CORNERS[tokens[-1]]
            return PointName(side, "".join(tokens[:-1]) + corner)
        return _side_within(tokens)
    return PointName("", "".join(tokens))


def _side_within(tokens: list[str]) -> PointName:
    """Read a side that stands inside: the ``L`` of ``WaistLFront``, the ``C`` of ``J_Bip_C_Hips``."""
    for place, token in enumerate(tokens[:-1]):
        if token in SIDES or token == MIDDLE:
            first, last = "".join(tokens[:place]), "".join(tokens[place + 1 :])
            if first + last not in WORDS and last in WORDS:
                return PointName(SIDES.get(token, ""), last)
            if token in SIDES and last.isalpha():
                return PointName(SIDES[token], first + last)
    return PointName("", "".join(tokens))


def _unglue(parsed: Sequence[PointName]) -> tuple[PointName, ...]:
    """Split ``lfemur`` into left and femur where ``rfemur`` stands beside it."""
    words = {name.word for name in parsed if not name.side}
    words |= {name.side[0] + name.word for name in parsed if name.side}
    return tuple(name if name.side else _split_glued(name.word, words) for name in parsed)


def _split_glued(word: str, words: set[str]) -> PointName:
    for letter, rest, partner in (
        (word[:1], word[1:], lambda other: other + word[1:]),
        (word[-1:], word[:-1], lambda other: word[:-1] + other),
    ):
        if letter in ("l", "r") and rest in WORDS and partner("r" if letter == "l" else "l") in words:
            return PointName(SIDES[letter], rest)
    return PointName("", word)
