"""Resampling: a recording at another rate, the first frame on the first frame.

A frame that stands where one stood stays as it was, to the bit. Between two frames positions go along the straight line
and rotations along the shorter arc, both at constant speed. Nothing is smoothed: what is faster than half the new rate
is not filtered out.
"""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np

from leitmotion.motion import rotations
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.motion import Motion
from leitmotion.motion.time import FASTEST
from leitmotion.motion.trajectories import Trajectories

R = TypeVar("R", Motion, Trajectories, Motion | Trajectories)

_SNAP = 1e-6  # how near a frame, in frames, a moment is taken to be that frame


def resample(recording: R, rate: float) -> R:
    """Bring a recording to another rate.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.
    rate : float
        Frames per second wanted.

    Returns
    -------
    Motion or Trajectories
        The same span of time, ``floor((T - 1) rate / recording.rate) + 1`` frames; of equal rates the recording itself.
        A point is unseen (NaN) where either neighbour is, so that no gap is bridged; its confidence goes along the
        straight line too, and is the lesser of its neighbours' where it is unseen.

    Raises
    ------
    ParameterError
        When the rate is not above 0 and up to 1e6 Hz, or the recording is none.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> ramp = Trajectories(("hand",), [[[0.0, 0, 0]], [[1.0, 0, 0]], [[2.0, 0, 0]]], rate=60)
    >>> resample(ramp, 120).positions[:, 0, 0].tolist()
    [0.0, 0.5, 1.0, 1.5, 2.0]
    """
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(
            f"What is resampled is a Motion or Trajectories, got a {type(recording).__name__}."
        )
    if not isinstance(rate, int | float) or not 0 < rate <= FASTEST:
        raise ParameterError(f"rate must be a number of hertz above 0 and up to {FASTEST:.0e}, got {rate!r}.")
    if rate == recording.rate:
        return recording
    before, share = _places(len(recording), recording.rate, float(rate))
    after = np.minimum(before + 1, max(len(recording) - 1, 0))
    if isinstance(recording, Motion):
        return _motion(recording, before, after, share, float(rate))
    return _trajectories(recording, before, after, share, float(rate))


def _places(frames: int, old: float, new: float) -> tuple[np.ndarray, np.ndarray]:
    """The frame at or before each new one, and how far on towards the next it stands."""
    count = math.floor((frames - 1) * new / old + _SNAP) + 1 if frames else 0
    place = np.arange(count) * (old / new)
    near = np.round(place)
    place = np.where(np.abs(place - near) < _SNAP, near, place)
    before = place.astype(np.int64)
    return before, place - before


def _between(values: np.ndarray, before: np.ndarray, after: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Values along the straight line; those of a frame itself where a new one stands on it."""
    share = share.reshape(-1, *[1] * (values.ndim - 1))
    start = values[before]
    return np.where(share == 0, start, (1 - share) * start + share * values[after])


def _motion(motion: Motion, before: np.ndarray, after: np.ndarray, share: np.ndarray, rate: float) -> Motion:
    turned = motion.local_rotations[before]
    on_the_way = share > 0
    turned[on_the_way] = rotations.slerp(
        turned[on_the_way], motion.local_rotations[after[on_the_way]], share[on_the_way, None]
    )
    return motion.replace(
        local_positions=_between(motion.local_positions, before, after, share),
        local_rotations=rotations.continuous(turned),
        rate=rate,
    )


def _trajectories(
    points: Trajectories, before: np.ndarray, after: np.ndarray, share: np.ndarray, rate: float
) -> Trajectories:
    positions = _between(points.positions, before, after, share)
    sure = points.confidence
    if sure is not None:
        lesser = np.where(share[:, None] == 0, sure[before], np.minimum(sure[before], sure[after]))
        seen = np.isfinite(positions).all(axis=2)
        sure = np.where(seen, _between(sure, before, after, share), lesser).clip(0.0, 1.0)
    return points.replace(positions=positions, confidence=sure, rate=rate)
