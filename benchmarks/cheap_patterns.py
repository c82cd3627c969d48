"""Cheap answers to the question what recurs: what any method of finding patterns has to beat."""

from __future__ import annotations

import numpy as np

from leitmotion import body, features
from leitmotion.evaluation import FoundPatterns, PatternTruth
from leitmotion.motion import Motion, Segmentation, Trajectories

SHORTEST = 0.5
"""Seconds of the shortest period that is looked for."""
STRETCH = 2.0
"""Seconds of the stretches that are taken for one pattern."""


def period(values: np.ndarray, rate: float) -> int:
    """First peak of the autocorrelation of T values of D features, frames; 0 where there is none."""
    x = values - values.mean(axis=0)
    power = np.fft.rfft(x, 2 * len(x), axis=0)
    correlation = np.fft.irfft(np.abs(power) ** 2, axis=0)[: len(x)].sum(axis=1)
    inner = np.arange(1, len(x) // 2)
    peaks = inner[
        (correlation[inner - 1] < correlation[inner]) & (correlation[inner] >= correlation[inner + 1])
    ]
    peaks = peaks[(peaks >= SHORTEST * rate) & (correlation[peaks] > 0)]
    return int(peaks[0]) if len(peaks) else 0


def one_period(recording: Motion | Trajectories) -> FoundPatterns:
    """Take the whole recording for cycles of the period that its autocorrelation has."""
    postures = features.posture(body.embody(recording))
    return _cut(len(postures), postures.rate, period(postures.values, postures.rate))


def everything(recording: Motion | Trajectories) -> FoundPatterns:
    """Take the whole recording, in stretches of two seconds, for one pattern."""
    return _cut(len(recording), recording.rate, round(STRETCH * recording.rate))


def at_random(recording: Motion | Trajectories, found: FoundPatterns, seed: int = 0) -> FoundPatterns:
    """Put as many stretches of the same lengths as were found anywhere else."""
    rng = np.random.default_rng(seed)
    frames = len(recording)

    def moved(spans: np.ndarray) -> np.ndarray:
        lengths = np.diff(spans, axis=1)[:, 0]
        starts = rng.integers(0, np.maximum(frames - lengths, 0) + 1)
        return np.stack((starts, starts + lengths), axis=1)

    occurrences, pairs = found.occurrences, np.asarray(found.pairs)
    spans = moved(np.stack((occurrences.starts, occurrences.stops), axis=1))
    return FoundPatterns(
        occurrences.replace(starts=spans[:, 0], stops=spans[:, 1]),
        np.concatenate((moved(pairs[:, :2]), moved(pairs[:, 2:])), axis=1),
    )


def equally(truth: PatternTruth) -> FoundPatterns:
    """Divide the true extent of each counted run equally into its true number of cycles."""
    spans = [
        (int(ends[k]), int(ends[k + 1]), label)
        for (start, stop, label, _), (cycles, _, _) in zip(truth.runs, truth.cycles, strict=True)
        if np.isfinite(cycles)
        for ends in [np.linspace(start, stop, int(cycles) + 1).round()]
        for k in range(int(cycles))
    ]
    starts, stops, labels = (list(each) for each in zip(*spans, strict=True)) if spans else ([], [], [])
    return FoundPatterns(Segmentation(starts, stops, tuple(labels), rate=truth.rate))


def _cut(frames: int, rate: float, every: int) -> FoundPatterns:
    count = frames // every if every else 0
    starts = np.arange(count if count > 1 else 0) * every
    return FoundPatterns(Segmentation(starts, starts + every, ("A",) * len(starts), rate=rate))
