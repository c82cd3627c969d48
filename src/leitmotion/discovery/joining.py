"""Join recordings into one, so that one search compares each with every other.

Conventions
-----------
Moments are of the joined sequence, frames of a recording. Every recording begins on a moment of the search's rate.
Between two recordings lies a gap of unseen moments (NaN), from which everything is infinitely far: no path runs
through it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from leitmotion.features.resampling import resample
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import DataError, ParameterError

SEARCHED_RATE = 30.0  # hertz: what recurrence searches at
FINEST = 4  # times that: where borders are refined
MIN_RATE = 4.0  # hertz: two frames in the shortest stretch
GAP_S = 2.0  # longer than what a path bridges and than what tells how much a body moves
GAP_SHARE = (
    0.4  # of the longer neighbour: stretches of two recordings never touch as two cycles of one run do
)
LEAST_COMMON = 6  # joints: fewer tell too little of a posture, unless they are all that every recording has


@dataclass(frozen=True, eq=False)
class Joined:
    """Several recordings, one after another.

    Parameters
    ----------
    features : FeatureSequence
        All moments, with gaps, at a multiple of the rate that is searched, up to 120 Hz.
    begins : (R,) int
        First moment of each recording.
    rates : (R,) float
        Frames per second of each.
    frames : (R,) int
        How long each is.
    """

    features: FeatureSequence
    begins: np.ndarray
    rates: np.ndarray
    frames: np.ndarray

    def owner(self, moments: np.ndarray) -> np.ndarray:
        """Which recording each moment is of, (N,) int."""
        return np.searchsorted(self.begins, moments, side="right") - 1

    def frame(self, moments: np.ndarray, recordings: np.ndarray) -> np.ndarray:
        """Frame of a recording at each moment, (N,) int, from 0 to its length."""
        own = (moments - self.begins[recordings]) * self.rates[recordings] / self.features.rate
        return np.clip(np.round(own).astype(np.int64), 0, self.frames[recordings])


def join(sequences: Sequence[FeatureSequence], names: Sequence[str]) -> Joined:
    """Join recordings by what all of them have, at one rate.

    Parameters
    ----------
    sequences : sequence of FeatureSequence
        One per recording.
    names : sequence of str
        What an error calls them.

    Returns
    -------
    Joined
        One sequence; its scale is the mean body's where all are in metres, else 1.

    Raises
    ------
    DataError
        When they cannot be compared: in a plane and in space, turned to one side and not, too few joints in common,
        or too few frames a second.
    """
    _check(sequences, names)
    common = _common(sequences, names)
    times = min(FINEST, int(np.ceil(max(one.rate for one in sequences) / SEARCHED_RATE - 1e-6)))
    rate = times * SEARCHED_RATE
    pieces = [resample(_only(one, common), rate).values for one in sequences]
    lengths = [len(piece) for piece in pieces]
    parts, begins, reached = [], [], 0
    for k, piece in enumerate(pieces):
        if k:
            gap = max(round(GAP_S * rate), int(np.ceil(GAP_SHARE * max(lengths[k - 1 : k + 1]))))
            gap += -(reached + gap) % times
            parts.append(np.full((gap, piece.shape[1]), np.nan))
            reached += gap
        begins.append(reached)
        parts.append(piece)
        reached += len(piece)
    first = sequences[0]
    scale, unit = _scale(sequences)
    weights = _only(first, common).weights
    whole = FeatureSequence(
        np.concatenate(parts), common, rate, first.invariant_to, first.width, scale, unit, weights
    )
    rates = np.array([one.rate for one in sequences])
    return Joined(whole, np.array(begins), rates, np.array([len(one) for one in sequences]))


def _check(sequences: Sequence[FeatureSequence], names: Sequence[str]) -> None:
    if len(sequences) < 2:
        raise ParameterError(f"What recordings share takes two recordings or more, got {len(sequences)}.")
    if len(names) != len(sequences):
        raise ParameterError(f"There are {len(sequences)} recordings, but {len(names)} names.")
    for name, one in zip(names, sequences, strict=True):
        if one.rate < MIN_RATE:
            raise DataError(
                f"{name}: Patterns need {MIN_RATE:g} frames a second or more, got {one.rate:g}.",
                remedy="Leave it out.",
            )
    widths = [one.width for one in sequences]
    if len(set(widths)) > 1:
        flat, deep = names[widths.index(min(widths))], names[widths.index(max(widths))]
        raise DataError(
            f"{flat} is in a plane and {deep} in space, and the two cannot be compared.",
            remedy="Look at those in a plane and those in space apart.",
        )
    turned = ["yaw" in one.invariant_to for one in sequences]
    if len(set(turned)) > 1:
        raise DataError(
            f"Which way the person faces is known in {names[turned.index(True)]} and not in "
            f"{names[turned.index(False)]}, so the two cannot be compared.",
            remedy="Name the hips or shoulders of the second in a map file, or leave it out.",
        )


def _common(sequences: Sequence[FeatureSequence], names: Sequence[str]) -> tuple[str, ...]:
    """What all recordings have, in the order of the first."""
    common = tuple(name for name in sequences[0].names if all(name in one.names for one in sequences[1:]))
    if len(common) >= LEAST_COMMON or all(set(one.names) == set(common) for one in sequences):
        return common
    kinds = list(dict.fromkeys(frozenset(one.names) for one in sequences))
    odd = min(kinds, key=lambda kind: sum(len(kind & other) for other in kinds))
    name = names[next(k for k, one in enumerate(sequences) if set(one.names) == odd)]
    told = f"only {', '.join(common)}" if common else "nothing"
    raise DataError(
        f"Recordings are compared by {LEAST_COMMON} joints or more that all have; these have {told} in common.",
        remedy=f"{name} shares fewest with the others: name its joints in a map file, or leave it out.",
    )


def _only(features: FeatureSequence, common: tuple[str, ...]) -> FeatureSequence:
    values = features.values.reshape(len(features), -1, features.width)
    places = [features.names.index(name) for name in common]
    weights = tuple(features.weights[k] for k in places) if features.weights else ()
    kept = values[:, places].reshape(len(features), -1)
    return features.replace(values=kept, names=common, weights=weights)


def _scale(sequences: Sequence[FeatureSequence]) -> tuple[float, str]:
    """What one unit of the values is: of bodies of different size the mean, where all are measured alike."""
    units = {one.unit for one in sequences}
    scales = [one.scale for one in sequences]
    if len(units) == 1 and (len(set(scales)) == 1 or units <= {"m", "m/s"}):
        return float(np.mean(scales)), units.pop()
    return 1.0, "relative"
