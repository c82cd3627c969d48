"""What recurs: patterns, where they occur, and the pairs of stretches that show it.

Conventions
-----------
An *occurrence* is one time the movement happens: of a cyclic pattern one cycle. A *stretch* is a stretch of time in
which the movement goes on without a break: several cycles with their lead-in and rest, or one acyclic occurrence.
Frames are half-open and belong to the recording's own rate.
"""

from __future__ import annotations

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
    """Two stretches that show the same movement: a stripe in the matrix.

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
        In order of the time they fill, most first.
    pairs : tuple of PatternPair
        The traced paths; both ends of each lie in stretches of its pattern.
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

    def __post_init__(self) -> None:
        check_rate(self)

    def __len__(self) -> int:
        return len(self.patterns)


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
