"""What recurs: patterns, where they occur, and the pairs of stretches that show it.

Conventions
-----------
An *occurrence* is one time the movement happens: of a cyclic pattern one cycle. A *stretch* is a stretch of time in
which the movement goes on without a break: several cycles with their lead-in and rest, or one acyclic occurrence.
Frames are half-open and belong to the recording's own rate.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array
from leitmotion.motion.segmentation import Segmentation

KINDS = ("cyclic", "acyclic")


@noun
class Pattern(Noun):
    """A movement that recurs.

    Parameters
    ----------
    id : str
        Its letter: A has the most time.
    kind : {"cyclic", "acyclic"}
        Whether it repeats continuously or comes back later.
    occurrences : Segmentation
        At least two, without overlap, in order; of a cyclic pattern one per cycle. The score is the likeness of
        each to the others, 0 to 1.
    stretches : Segmentation
        The stretches of time that hold the occurrences, in order; of an acyclic pattern the occurrences.
    period_s : float
        Median length of a cycle or an occurrence, seconds.
    cost : float
        Mean distance between occurrences along their warping paths, in the recording's own unit (metres).
    confidence : float
        0 to 1.
    reason : str
        Why that confidence, in words.

    Raises
    ------
    ParameterError
        When there are fewer than two occurrences or two of them overlap.
    """

    id: str
    kind: str
    occurrences: Segmentation
    stretches: Segmentation
    period_s: float
    cost: float
    confidence: float
    reason: str = ""

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ParameterError(f"Pattern.kind must be one of {', '.join(KINDS)}, got {self.kind!r}.")
        for what in ("occurrences", "stretches"):
            spans = getattr(self, what)
            if (spans.starts[1:] < spans.stops[:-1]).any():
                raise ParameterError(f"Pattern.{what} must stand in order without overlap.")
        if len(self.occurrences) < 2:
            raise ParameterError(f"A pattern must occur at least twice, got {len(self.occurrences)}.")

    @property
    def cycles(self) -> int:
        """How many cycles a cyclic pattern has in all; 0 of an acyclic one."""
        return len(self.occurrences) if self.kind == "cyclic" else 0


@noun
class PatternPair(Noun):
    """Two stretches of time that show the same movement, moment by moment.

    Parameters
    ----------
    pattern : str
        Id of the pattern.
    path : (K, 2) int
        The warping path, frames of the earlier and of the later stretch, never decreasing.
    cost : float
        Mean distance along the path, in the recording's own unit.
    """

    pattern: str
    path: np.ndarray
    cost: float

    def __post_init__(self) -> None:
        set_array(self, "path", dtype=np.int64, shape=(None, 2))

    @property
    def a(self) -> tuple[int, int]:
        """The earlier stretch, frames ``[start, stop)``."""
        return int(self.path[0, 0]), int(self.path[-1, 0]) + 1

    @property
    def b(self) -> tuple[int, int]:
        """The later stretch, frames ``[start, stop)``."""
        return int(self.path[0, 1]), int(self.path[-1, 1]) + 1


@noun
class Patterns(Noun):
    """Everything that recurs in one recording.

    Parameters
    ----------
    patterns : tuple of Pattern
        In order of the time they fill, most first. Occurrences of two patterns may overlap where one movement passes
        into the other, those of acyclic ones by half of the shortest stretch that was looked for.
    pairs : tuple of PatternPair
        Paths between two occurrences of one pattern, at most one for each two.
    stripes : tuple of PatternPair
        The paths as they were traced, as long as they go: through several cycles, and of a movement that repeats
        without a break with ends that overlap. Both ends lie in stretches of the pattern.
    rate : float
        Frames per second of the recording.
    parameters : dict
        What was looked for and how: method, thresholds in body size and in metres, shortest length, roles used.
    nearest_miss : str
        When nothing was found: what came nearest, with its number; else empty.
    """

    patterns: tuple[Pattern, ...]
    pairs: tuple[PatternPair, ...]
    rate: float
    parameters: dict[str, object]
    nearest_miss: str = ""
    stripes: tuple[PatternPair, ...] = ()

    def __post_init__(self) -> None:
        check_rate(self)
        object.__setattr__(self, "parameters", dict(self.parameters))

    def __len__(self) -> int:
        return len(self.patterns)

    def __iter__(self) -> Iterator[Pattern]:
        return iter(self.patterns)


def cut_at_occurrences(
    path: np.ndarray, occurrences: Segmentation, *, share: float = 0.5
) -> dict[tuple[int, int], slice]:
    """Cut a traced path into what it says of each two occurrences.

    Parameters
    ----------
    path : (K, 2) int
        Frames of the earlier and of the later moment, never decreasing.
    occurrences : Segmentation
        In order, without overlap.
    share : float
        How much of both occurrences a piece must pass through.

    Returns
    -------
    dict of (int, int) to slice
        The piece of the path by which two occurrences it joins.

    Examples
    --------
    >>> cycles = Segmentation([0, 10, 20], [10, 20, 30], rate=1)
    >>> path = np.stack((np.arange(20), np.arange(10, 30)), axis=1)
    >>> cut_at_occurrences(path, cycles)
    {(0, 1): slice(0, 10, None), (1, 2): slice(10, 20, None)}
    """
    which = np.searchsorted(occurrences.starts, path, side="right") - 1
    inside = (which >= 0) & (path < occurrences.stops[which])
    pieces = {}
    edges = (
        np.flatnonzero((np.diff(which, axis=0) != 0).any(axis=1) | (np.diff(inside, axis=0) != 0).any(axis=1))
        + 1
    )
    for start, stop in pairwise([0, *edges.tolist(), len(path)]):
        k, m = which[start].tolist()
        if k == m or not inside[start].all():
            continue
        passed = path[stop - 1] - path[start] + 1
        lengths = occurrences.stops[[k, m]] - occurrences.starts[[k, m]]
        if (passed >= share * lengths).all():
            pieces[k, m] = slice(start, stop)
    return pieces


def letter(k: int) -> str:
    """Letter of the k-th pattern: A to Z, then AA, AB and so on.

    Parameters
    ----------
    k : int
        0 for the first.

    Returns
    -------
    str
        Its letter or letters.

    Examples
    --------
    >>> letter(0), letter(25), letter(26)
    ('A', 'Z', 'AA')
    """
    text = ""
    k += 1
    while k:
        k, rest = divmod(k - 1, 26)
        text = chr(ord("A") + rest) + text
    return text
