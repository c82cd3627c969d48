"""The figures by which patterns are judged, of one recording or of many together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun

MEASURES = (
    "type_one", "type_two", "precision", "recall", "f1", "paper_type_one", "paper_type_two",
    "border_error_s", "inner_border_error_s", "counts_within",
)  # fmt: skip
"""What an interval can be given for."""


@noun
class RunCount(Noun):
    """How often a movement repeats within one run.

    Parameters
    ----------
    label : str
        The action.
    start, stop : int
        The run, frames.
    found : int
        Occurrences that belong to the action and lie in the run, of the pattern that covers most of it.
    cycles, least, most : float
        What a person counted, and the least and the most that one may count; NaN where nobody did.
    recurs : bool
        Whether the action recurs.
    """

    label: str
    start: int
    stop: int
    found: int
    cycles: float = math.nan
    least: float = math.nan
    most: float = math.nan
    recurs: bool = True

    @property
    def judged(self) -> bool:
        """Whether the action recurs and a person counted: what is done once cannot be found."""
        return self.recurs and math.isfinite(self.cycles)

    @property
    def within(self) -> bool:
        """Whether what was found is no less than the least and no more than the most."""
        return self.least <= self.found <= self.most


@noun
class PatternScores(Noun):
    """How good patterns are; of several recordings (:func:`pool`) everything is strung together.

    Parameters
    ----------
    pairs : int
        Pairs found.
    wrong_pairs : int
        Those whose two stretches belong to different actions or to none.
    unfounded_pairs : int
        Those whose stretches belong to one action, which is known not to recur.
    patterns, stray_patterns : int
        Patterns found, and those of which no two occurrences belong to one recurring action.
    recurring, missed : tuple of str
        The actions that recur, and those of them that were not found.
    true_pairs, missed_pairs : int
        Pairs of runs of one recurring action, and cyclic runs, each with itself; and those that no right pair links.
    start_errors_s, stop_errors_s : tuple of float
        Of each run in which its action was found: found start less true start, found stop less true stop, seconds.
    inner_errors_s : tuple of float
        Of each border between two repetitions that are known exactly, in a run in which its action was found: distance
        to the nearest border found, seconds.
    counts : tuple of RunCount
        Every run, and how many cycles were found in it.
    """

    pairs: int = 0
    wrong_pairs: int = 0
    unfounded_pairs: int = 0
    patterns: int = 0
    stray_patterns: int = 0
    recurring: tuple[str, ...] = ()
    missed: tuple[str, ...] = ()
    true_pairs: int = 0
    missed_pairs: int = 0
    start_errors_s: tuple[float, ...] = ()
    stop_errors_s: tuple[float, ...] = ()
    inner_errors_s: tuple[float, ...] = ()
    counts: tuple[RunCount, ...] = ()

    @property
    def type_one(self) -> float:
        """Share of the pairs that are wrong; NaN where there are none."""
        return _share(self.wrong_pairs, self.pairs)

    @property
    def type_two(self) -> float:
        """Share of the recurring actions that are missed; NaN where none recurs."""
        return _share(len(self.missed), len(self.recurring))

    @property
    def precision(self) -> float:
        """Share of the pairs that show what recurs: neither wrong nor unfounded; NaN where there are none."""
        return _share(self.pairs - self.wrong_pairs - self.unfounded_pairs, self.pairs)

    @property
    def recall(self) -> float:
        """Share of the true pairs that are linked; NaN where there are none."""
        return _share(self.true_pairs - self.missed_pairs, self.true_pairs)

    @property
    def f1(self) -> float:
        """Harmonic mean of precision and recall; 0 where nothing was found of what recurs, NaN where nothing does."""
        if not self.true_pairs:
            return math.nan
        if not self.pairs or not self.precision + self.recall:
            return 0.0
        return 2 * self.precision * self.recall / (self.precision + self.recall)

    @property
    def paper_type_one(self) -> float:
        """Paper P's own: u / (U - u + v), of U pairs found, u of them wrong, and v missed."""
        return _share(self.wrong_pairs, self.pairs - self.wrong_pairs + self.missed_pairs)

    @property
    def paper_type_two(self) -> float:
        """Paper P's own: v / (U - u + v), of U pairs found, u of them wrong, and v missed."""
        return _share(self.missed_pairs, self.pairs - self.wrong_pairs + self.missed_pairs)

    @property
    def border_error_s(self) -> float:
        """Mean distance of the found extent of a run from the true one, at both ends, seconds."""
        return _mean_distance(self.start_errors_s + self.stop_errors_s)

    @property
    def inner_border_error_s(self) -> float:
        """Mean distance of the true borders between repetitions from the nearest found one, seconds."""
        return _mean_distance(self.inner_errors_s)

    @property
    def counts_within(self) -> float:
        """Share of the counted runs of recurring actions whose count a person may give; NaN where there are none."""
        counted = [run for run in self.counts if run.judged]
        return _share(sum(run.within for run in counted), len(counted))


def pool(scores: Sequence[PatternScores]) -> PatternScores:
    """Take several recordings as one: counts are added, lists strung together.

    Parameters
    ----------
    scores : sequence of PatternScores
        One a recording.

    Returns
    -------
    PatternScores
        Those of all.

    Examples
    --------
    >>> both = pool([PatternScores(pairs=3, wrong_pairs=1), PatternScores(pairs=5, wrong_pairs=1)])
    >>> both.type_one
    0.25
    """
    empty = PatternScores()
    summed = {
        field.name: sum((getattr(one, field.name) for one in scores), getattr(empty, field.name))
        for field in fields(PatternScores)
    }
    return PatternScores(**summed)


def interval(
    scores: Sequence[PatternScores],
    measure: str,
    *,
    level: float = 0.95,
    draws: int = 2000,
    seed: int = 0,
) -> tuple[float, float]:
    """Interval of a pooled figure by the bootstrap: recordings are drawn with replacement and pooled again.

    Parameters
    ----------
    scores : sequence of PatternScores
        One a recording.
    measure : str
        Which figure: one of :data:`MEASURES`.
    level : float
        How much of the draws the interval holds.
    draws : int
        How often the recordings are drawn.
    seed : int
        Of the drawing.

    Returns
    -------
    (float, float)
        The lower and the upper end; NaN where the figure has no value in any draw, or of fewer than two recordings.

    Raises
    ------
    ParameterError
        When there is no such figure.

    Examples
    --------
    >>> scores = [PatternScores(pairs=10, wrong_pairs=wrong) for wrong in (0, 1, 2, 5)]
    >>> low, high = interval(scores, "type_one")
    >>> low < pool(scores).type_one < high
    True
    """
    if measure not in MEASURES:
        raise ParameterError(f"measure must be one of {', '.join(MEASURES)}, got {measure!r}.")
    if len(scores) < 2:
        return math.nan, math.nan
    rng = np.random.default_rng(seed)
    drawn = rng.integers(len(scores), size=(draws, len(scores)))
    values = np.array([getattr(pool([scores[k] for k in few]), measure) for few in drawn])
    values = values[np.isfinite(values)]
    if not values.size:
        return math.nan, math.nan
    low, high = np.quantile(values, [(1 - level) / 2, (1 + level) / 2])
    return float(low), float(high)


def _share(part: int, whole: int) -> float:
    return part / whole if whole else math.nan


def _mean_distance(errors: tuple[float, ...]) -> float:
    return float(np.mean(np.abs(errors))) if errors else math.nan
