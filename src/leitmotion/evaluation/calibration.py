"""Calibration: from which distance on two postures are alike, told by pairs that a person labelled.

Conventions
-----------
Two postures count as alike at a threshold T when their distance is at most T. The *false match rate* is the share of
the pairs not alike that count as alike, the *false non-match rate* the share of the alike pairs that do not. Over T the
first rises from 0 to 1 and the second falls from 1 to 0, both in steps at the distances of the pairs. Each class counts
by its share, so the two need not have equally many pairs.

References
----------
Paper P (Tang, Leung, Komura, Shum, 2008), section 2.3.1 and figure 13.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from leitmotion.motion.errors import DataError, ParameterError
from leitmotion.motion.noun import Noun, noun, set_array

LEVEL = 0.95  # of the intervals
DRAWS = 2000
Interval = tuple[float, float]


@noun
class ErrorRates(Noun):
    """How often pairs are taken wrongly at one threshold.

    Parameters
    ----------
    threshold : float
        At most this far apart counts as alike.
    false_match, false_non_match : float
        Share of the pairs not alike that count as alike; share of the alike pairs that do not.
    alike, not_alike : int
        How many pairs of each were looked at.
    interval : (float, float)
        Of the error, 95 % by the bootstrap; NaN where it was not asked for.
    """

    threshold: float
    false_match: float
    false_non_match: float
    alike: int
    not_alike: int
    interval: Interval = (math.nan, math.nan)

    @property
    def error(self) -> float:
        """The mean of the two rates: 0.5 is a guess."""
        return (self.false_match + self.false_non_match) / 2


@noun
class Calibration(Noun):
    """A threshold with what speaks for it.

    Parameters
    ----------
    threshold : float
        Where both error rates are equal: in the middle where that holds between two distances.
    equal_error_rate : float
        Both rates there. Where they cross within a step, the rate at which they do when the pairs of that distance are
        taken as alike by a coin that makes them equal.
    thresholds : (C,) float
        The curve: 0 and every distance of a pair, ascending.
    false_match, false_non_match : (C,) float
        Both rates at these thresholds; each holds up to the next.
    alike, not_alike : int
        How many pairs of each were labelled.
    threshold_interval, rate_interval : (float, float)
        95 % of the threshold and of the equal error rate, by the bootstrap; NaN where a class has a single pair. Where
        the pairs are parted without an error, that of the rate has no width: it then says nothing of rare errors.
    check : ErrorRates, optional
        The errors of other pairs at this threshold.

    Raises
    ------
    ParameterError
        When shapes disagree.
    """

    threshold: float
    equal_error_rate: float
    thresholds: np.ndarray
    false_match: np.ndarray
    false_non_match: np.ndarray
    alike: int
    not_alike: int
    threshold_interval: Interval = (math.nan, math.nan)
    rate_interval: Interval = (math.nan, math.nan)
    check: ErrorRates | None = None

    def __post_init__(self) -> None:
        count = len(set_array(self, "thresholds", dtype=np.float64, shape=(None,)))
        for field in ("false_match", "false_non_match"):
            set_array(self, field, dtype=np.float64, shape=(count,))


def equal_error_rate(
    distances: np.ndarray,
    alike: np.ndarray,
    *,
    owners: Sequence[object] | None = None,
    draws: int = DRAWS,
    seed: int = 0,
) -> Calibration:
    """Find the threshold at which as many alike pairs are missed as others are taken for alike, in shares.

    Parameters
    ----------
    distances : (K,) float
        How far the two postures of each pair are apart.
    alike : (K,) bool
        Whether a person calls them alike.
    owners : sequence of K values, optional
        Whose pair it is. The bootstrap then draws people with all their pairs, as pairs of one person resemble each
        other; without it, pairs of each class.
    draws : int
        Of the bootstrap; 0 for no intervals.
    seed : int
        Of the drawing.

    Returns
    -------
    Calibration
        The threshold, the rate, both curves and the intervals.

    Raises
    ------
    DataError
        When only one class is labelled.
    ParameterError
        When shapes disagree, or a distance is negative or not finite.

    Examples
    --------
    >>> found = equal_error_rate([0.1, 0.2, 0.4, 0.3, 0.6, 0.8], [1, 1, 1, 0, 0, 0])
    >>> found.threshold, round(found.equal_error_rate, 3)
    (0.35, 0.333)
    >>> found.false_match.round(2).tolist()
    [0.0, 0.0, 0.0, 0.33, 0.33, 0.67, 1.0]
    """
    distances, alike = _checked(distances, alike)
    thresholds, false_match, false_non_match = _curves(distances, alike)
    threshold, rate = _crossing(thresholds, false_match, false_non_match)
    drawn = np.array(
        [
            _crossing(*_curves(distances[chosen], alike[chosen]))
            for chosen in _draws(alike, owners, draws, seed)
        ]
    ).reshape(-1, 2)
    return Calibration(
        threshold=threshold,
        equal_error_rate=rate,
        thresholds=thresholds,
        false_match=false_match,
        false_non_match=false_non_match,
        alike=int(alike.sum()),
        not_alike=int((~alike).sum()),
        threshold_interval=_interval(drawn[:, 0]),
        rate_interval=_interval(drawn[:, 1]),
    )


def errors_at(
    threshold: float,
    distances: np.ndarray,
    alike: np.ndarray,
    *,
    owners: Sequence[object] | None = None,
    draws: int = DRAWS,
    seed: int = 0,
) -> ErrorRates:
    """Tell how often pairs are taken wrongly at a threshold, such as one that was calibrated on others.

    Parameters
    ----------
    threshold : float
        At most this far apart counts as alike.
    distances, alike, owners, draws, seed
        As for :func:`equal_error_rate`.

    Returns
    -------
    ErrorRates
        Both rates, and the interval of their mean.

    Raises
    ------
    DataError
        When only one class is labelled.
    ParameterError
        When shapes disagree, or a distance is negative or not finite.

    Examples
    --------
    >>> told = errors_at(0.35, [0.1, 0.4, 0.3, 0.5], [True, True, False, False])
    >>> told.false_match, told.false_non_match, told.error
    (0.5, 0.5, 0.5)
    """
    distances, alike = _checked(distances, alike)
    wrong = (distances <= threshold) != alike
    drawn = [
        (wrong[chosen][alike[chosen]].mean() + wrong[chosen][~alike[chosen]].mean()) / 2
        for chosen in _draws(alike, owners, draws, seed)
    ]
    return ErrorRates(
        threshold=threshold,
        false_match=float(wrong[~alike].mean()),
        false_non_match=float(wrong[alike].mean()),
        alike=int(alike.sum()),
        not_alike=int((~alike).sum()),
        interval=_interval(np.array(drawn)),
    )


def _checked(distances: np.ndarray, alike: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    distances, labels = np.asarray(distances, dtype=np.float64), np.asarray(alike)
    if distances.ndim != 1 or distances.shape != labels.shape:
        raise ParameterError(f"Each distance has one label, got shapes {distances.shape} and {labels.shape}.")
    if not np.isin(labels, (0, 1)).all():
        raise ParameterError("A label is true or false.")
    wrong = np.flatnonzero(~(np.isfinite(distances) & (distances >= 0)))
    if wrong.size:
        raise ParameterError(
            f"A distance is 0 or more and finite, got {distances[wrong[0]]} at pair {wrong[0]}."
        )
    alike = labels.astype(bool)
    if alike.all() or not alike.any():
        count = len(alike)
        one_kind = (
            f"{'the one' if count == 1 else f'each of the {count}'} is {'' if alike.all() else 'not '}alike"
        )
        raise DataError(
            f"A threshold lies between pairs alike and pairs not alike, but {one_kind}.",
            remedy="Label some of both.",
        )
    return distances, alike


def _curves(distances: np.ndarray, alike: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Both rates at 0 and at every distance, exactly."""
    thresholds = np.unique(np.append(distances, 0.0))
    same, other = np.sort(distances[alike]), np.sort(distances[~alike])
    false_match = np.searchsorted(other, thresholds, side="right") / len(other)
    false_non_match = (len(same) - np.searchsorted(same, thresholds, side="right")) / len(same)
    return thresholds, false_match, false_non_match


def _crossing(
    thresholds: np.ndarray, false_match: np.ndarray, false_non_match: np.ndarray
) -> tuple[float, float]:
    """Where the rates are equal: on a tread of the steps, else within the step that leads from below to above."""
    ahead = false_match - false_non_match
    equal = np.abs(ahead) < 1e-12
    if equal.any():
        k = int(
            np.argmax(equal)
        )  # every distance changes a rate, so there is one such tread, and a next distance
        return float(thresholds[k] + thresholds[k + 1]) / 2, float(false_match[k])
    k = int(np.argmax(ahead > 0))
    below = ahead[k - 1] if k else -1.0  # before the first distance nothing counts as alike
    start = float(false_non_match[k - 1]) if k else 1.0
    share = -below / (ahead[k] - below)
    return float(thresholds[k]), float(start + share * (false_non_match[k] - start))


def _draws(alike: np.ndarray, owners: Sequence[object] | None, draws: int, seed: int) -> list[np.ndarray]:
    """Choose pairs with replacement: within each class, or people with all that is theirs."""
    rng = np.random.default_rng(seed)
    if owners is None:
        classes = [np.flatnonzero(alike), np.flatnonzero(~alike)]
        if min(map(len, classes)) < 2:
            return []  # one pair tells nothing of how pairs differ
        return [np.concatenate([rng.choice(held, len(held)) for held in classes]) for _ in range(draws)]
    names = [str(owner) for owner in owners]
    if len(names) != len(alike):
        raise ParameterError(f"Each pair has one owner, got {len(names)} for {len(alike)} pairs.")
    theirs = [np.flatnonzero(np.array(names) == name) for name in dict.fromkeys(names)]
    drawn = [
        np.concatenate([theirs[k] for k in rng.integers(len(theirs), size=len(theirs))]) for _ in range(draws)
    ]
    return [chosen for chosen in drawn if 0 < alike[chosen].sum() < len(chosen)]  # both classes are needed


def _interval(drawn: np.ndarray) -> Interval:
    if not drawn.size:
        return math.nan, math.nan
    low, high = np.quantile(drawn, [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return float(low), float(high)
