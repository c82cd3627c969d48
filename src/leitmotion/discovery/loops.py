"""Loops: recordings that are one stretch, copied, frame for frame.

Conventions
-----------
Frames of the recording. Nobody performs a movement twice so alike: a copy is one cycle, whatever comes back within it.
"""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.families import TOUCH, Run
from leitmotion.discovery.pauses import true_runs
from leitmotion.discovery.stripes import Likeness, measure
from leitmotion.discovery.themes import Theme
from leitmotion.features.sequence import FeatureSequence
from leitmotion.similarity import Distances

COPIED = 1e-4  # body sizes: copies differ by how a file rounds
PROBES = 32  # frames by which most lengths are ruled out
ROWS = 4096  # frames compared at once


def loop_length(features: FeatureSequence, shortest: int) -> int | None:
    """Find after how many frames a recording is the same again, to its end.

    Parameters
    ----------
    features : FeatureSequence
        Postures in body sizes, T frames.
    shortest : int
        Least length, frames.

    Returns
    -------
    int or None
        The least length, at most half of the recording; None where it is no loop.

    Examples
    --------
    >>> once = np.random.default_rng(1).normal(size=(40, 3))
    >>> hand = FeatureSequence(np.tile(once, (3, 1)), ("hand",), rate=30, width=3)
    >>> loop_length(hand, 15), loop_length(hand[:70], 15)
    (40, None)
    """
    values, half = features.values, len(features) // 2
    lengths = np.arange(max(1, shortest), half + 1)
    for probe in np.linspace(0, half, PROBES, endpoint=False).astype(int).tolist():
        for d in range(values.shape[1]):
            lengths = lengths[_same(values[probe + lengths, d], values[probe, d])]
    # where a body keeps still nearly always, the frame farthest from the first rules out what the probes do not
    farthest = int(np.argmax(_apart(values)))
    counterparts = np.where(farthest < lengths, farthest + lengths, farthest - lengths)
    lengths = lengths[_same(values[counterparts], values[farthest]).all(axis=1)]
    for length in lengths.tolist():
        last = len(values) - length
        if all(
            _same(values[k + length : k + length + ROWS], values[k : min(k + ROWS, last)]).all()
            for k in range(0, last, ROWS)
        ):
            return int(length)
    return None


def loop_of(features: FeatureSequence, distances: Distances, alike: Likeness, shortest: int) -> Theme | None:
    """Take a recording that is a loop for one cyclic movement.

    Parameters
    ----------
    features : FeatureSequence
        Postures in body sizes, T frames.
    distances : Distances
        Posture distances of the same at the working rate, N moments.
    alike : Likeness
        What counts as alike.
    shortest : int
        Least length of a cycle, moments.

    Returns
    -------
    Theme or None
        One run with a cycle for each copy; None where the recording is no loop, or where the body rests in it for
        more than a quarter of a copy: then it is a movement that comes back after a break.
    """
    ratio = features.rate / distances.features.rate
    length = loop_length(features, int(np.ceil(shortest * ratio)))
    if length is None:
        return None
    period, last = length / ratio, len(distances)
    rests = true_runs(alike.still | ~alike.moving)
    if any(stop - start > TOUCH * period for start, stop in rests):
        return None
    borders = [length * k / ratio for k in range(len(features) // length + 1)]
    lag = round(period)
    path = np.stack((np.arange(last - lag), np.arange(lag, last)), axis=1)
    stripes = [stripe for stripe in measure([path], distances, alike) if stripe is not None]
    return Theme([Run(0.0, len(features) / ratio, period, stripes, list(stripes), borders)], stripes)


def _apart(values: np.ndarray) -> np.ndarray:
    """How far the numbers of each frame are from those of the first, at most. (T,)."""
    apart = np.zeros(len(values))
    for column in values.T:
        np.fmax(apart, np.abs(column - column[0]), out=apart)
    return apart


def _same(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Where numbers are those of a copy; what was not seen is like what was not seen."""
    return np.asarray((np.abs(one - other) < COPIED) | (np.isnan(one) & np.isnan(other)))
