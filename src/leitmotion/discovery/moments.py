"""Moments: what of one recording or several is compared, smooth enough that its speed tells when the body turns.

A *stretch* is what was seen of a recording without a break. What lies between two stretches nobody saw: it is no
moment, and no way leads across it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.evening import matched_bias
from leitmotion.discovery.pauses import true_runs
from leitmotion.features import FeatureSequence, without_bias
from leitmotion.features.resampling import resample
from leitmotion.features.rotations import towards_mean
from leitmotion.motion.errors import DataError
from leitmotion.motion.rotations import normalize
from leitmotion.motion.smoothing import SHORTEST, smooth
from leitmotion.similarity import double_metric

RATE = 30.0
"""Moments a second."""
MOST = 4000
"""Moments in all recordings together."""
CUTOFFS = (1.5, 6.0)
"""Hertz between which the cutoff is chosen."""
ABOVE_NOISE = 4.0  # times the power of the noise, from which on there is movement


class Moments(NamedTuple):
    """Moments of the stretches of one recording or several, one after another, beside their mirror images."""

    own: np.ndarray
    """(N, N) float32: the angle by which a mean link is turned between two moments, root mean square, radians."""
    mirror: np.ndarray
    """(N, N) float32: the same to the mirror image of the second moment."""
    speed: np.ndarray
    """(N,) radians a second of a mean link."""
    starts: np.ndarray
    """(S + 1,) int: the moment at which each stretch begins, and the end."""
    origins: np.ndarray
    """(S, 2) int: the recording of each stretch, and how many moments after that it begins."""
    rate: float
    """Moments a second."""
    half: float
    """The angle at which two moments are half alike."""
    evened: tuple[float, ...]
    """Of each recording the largest angle between a link and the image of its partner that was taken out, radians."""


def moments_of(chains: Sequence[FeatureSequence], *, weights: np.ndarray | None = None) -> Moments:
    """Smooth kinematic chains, and compare every moment with every other and with its mirror image."""
    rate = min(RATE, *(chain.rate for chain in chains))
    seconds = sum(len(chain) / chain.rate for chain in chains)
    rate = min(rate, MOST / max(seconds, 1.0))
    pieces = [resample(smoothed(chain), rate) for chain in chains]
    biases = [matched_bias(piece) for piece in pieces]
    pieces = [
        piece if bias is None else without_bias(piece, bias)
        for piece, bias in zip(pieces, biases, strict=True)
    ]
    evened = tuple(0.0 if bias is None else float(bias.angles.max()) for bias in biases)
    runs = [true_runs(np.isfinite(piece.values).any(axis=1)) for piece in pieces]
    if not any(runs):
        raise DataError("The motion graph needs a body that was seen, and nothing of it was in any frame.")
    values = np.concatenate(
        [piece.values[a:b] for piece, seen in zip(pieces, runs, strict=True) for a, b in seen]
    )
    turned = values.reshape(len(values), -1, 4)
    whole = pieces[0].replace(values=(turned * towards_mean(turned)).reshape(len(values), -1))
    double = double_metric(whole, weights=weights)
    starts = np.concatenate(([0], np.cumsum([b - a for seen in runs for a, b in seen])))
    origins = np.array([(k, a) for k, seen in enumerate(runs) for a, _ in seen])
    own, mirror = (_angle(each) for each in (double.own, double.mirror))
    speed = np.concatenate([_speed(own[a:b, a:b], rate) for a, b in pairwise(starts)])
    return Moments(own, mirror, speed, starts, origins, rate, double.half_angle, evened)


def smoothed(chain: FeatureSequence) -> FeatureSequence:
    """Take away what is faster than the movement; what is unseen stays unseen."""
    if len(chain) < SHORTEST or chain.rate < 2.5 * CUTOFFS[0]:
        return chain
    turned = chain.values.reshape(len(chain), -1, 4)
    seen = np.isfinite(turned).all(axis=2)
    values = np.stack([_filled(turned[:, k], seen[:, k]) for k in range(turned.shape[1])], axis=1)
    flat = values.reshape(len(chain), -1)
    cutoff = cutoff_of(flat, chain.rate)
    if cutoff < 0.44 * chain.rate:
        values = normalize(smooth(flat, cutoff, chain.rate).reshape(values.shape))
    return chain.replace(values=np.where(seen[..., None], values, np.nan).reshape(len(chain), -1))


def cutoff_of(values: np.ndarray, rate: float) -> float:
    """Where the movement sinks below the noise, hertz: the power at high frequencies is taken for noise."""
    centred = (values - values.mean(axis=0)) * np.hanning(len(values))[:, None]
    power = (np.abs(np.fft.rfft(centred, axis=0)) ** 2).sum(axis=1)
    hertz = np.fft.rfftfreq(len(values), 1.0 / rate)
    noise = np.median(power[hertz >= 0.3 * rate])
    wide = max(1, round(0.5 * len(values) / rate))
    level = np.convolve(power, np.ones(wide) / wide, mode="same")
    loud = hertz[level > ABOVE_NOISE * noise]
    return float(np.clip(loud.max() if loud.size else 0.0, *CUTOFFS))


def _filled(values: np.ndarray, seen: np.ndarray) -> np.ndarray:
    if seen.all():
        return values
    if not seen.any():
        return np.tile([1.0, 0.0, 0.0, 0.0], (len(values), 1))
    frames = np.arange(len(values))
    return np.stack([np.interp(frames, frames[seen], column[seen]) for column in values.T], axis=1)


def _angle(cost: np.ndarray) -> np.ndarray:
    return 2.0 * np.arccos(np.clip(1.0 - np.nan_to_num(cost, nan=1.0), 0.0, 1.0))


def _speed(own: np.ndarray, rate: float) -> np.ndarray:
    count = len(own)
    if count < 3:
        return np.zeros(count)
    here = np.arange(count)
    before, after = np.maximum(here - 1, 0), np.minimum(here + 1, count - 1)
    return own[before, after] * rate / (after - before)
