"""Refining: borders found at the working rate, moved by a moment or two where the recording's own rate says better.

Conventions
-----------
Borders are in moments of the working rate, here with fractions: frames of the recording over the number of frames in a
moment. Occurrences of one movement begin alike and end alike; so each border is put where the postures around it
agree best with those around the most typical one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from leitmotion.discovery.families import Run
from leitmotion.features.sequence import FeatureSequence
from leitmotion.similarity import Distances

SHIFT = 2  # moments a border may move
AROUND = (-3, -2, -1, 0, 1, 2, 3)  # moments beside a border that must agree, too
SAMPLED = 24  # borders among which the most typical one is looked for


class Refiner:
    """Moves borders at the recording's own rate; a recording slower than the working rate keeps them.

    Parameters
    ----------
    features : FeatureSequence
        Postures in body sizes, T frames.
    working_rate : float
        Moments per second.
    max_distance : float
        Where postures around a border differ by more, on average, it stays. Body sizes.
    """

    def __init__(self, features: FeatureSequence, working_rate: float, max_distance: float) -> None:
        self.ratio = features.rate / working_rate
        self.around = np.round(np.array(AROUND) * self.ratio).astype(np.int64)
        self.distances = Distances(features)
        self.max_distance = max_distance

    def run(self, run: Run) -> Run:
        """Move the borders of a run's cycles, and its ends with them where they were the same.

        Parameters
        ----------
        run : Run
            With its borders.

        Returns
        -------
        Run
            As many cycles, none of which is lost.
        """
        borders = self.borders(run.borders)
        if any(b <= a for a, b in pairwise(borders)):
            return run
        start = borders[0] if run.start == run.borders[0] else min(run.start, borders[0])
        stop = borders[-1] if run.stop == run.borders[-1] else max(run.stop, borders[-1])
        return replace(run, start=start, stop=stop, borders=borders)

    def spans(self, spans: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        """Move where occurrences of one movement start and stop.

        Parameters
        ----------
        spans : sequence of (float, float)
            In order, without overlap, moments.

        Returns
        -------
        list of (float, float)
            As many, in order, without overlap.
        """
        starts = self.borders([start for start, _ in spans])
        stops = self.borders([stop for _, stop in spans])
        stops = [min(stop, following) for stop, following in zip(stops, [*starts[1:], np.inf], strict=True)]
        moved = list(zip(starts, stops, strict=True))
        return moved if all(stop > start for start, stop in moved) else list(spans)

    def borders(self, borders: Sequence[float]) -> list[float]:
        """Move borders that belong together.

        Parameters
        ----------
        borders : sequence of float
            Moments at which the same posture is expected.

        Returns
        -------
        list of float
            As many, each at most two moments away.
        """
        if self.ratio < 1:
            return list(borders)
        frames = np.round(np.array(borders) * self.ratio).astype(np.int64)
        shifts = np.arange(-round(SHIFT * self.ratio), round(SHIFT * self.ratio) + 1)
        shifts = shifts[np.argsort(np.abs(shifts), kind="stable")]  # of equals the least
        typical = self._typical(frames)
        moved = []
        for border, frame in zip(borders, frames, strict=True):
            places = frame + shifts
            places = places[(places == frame) | ((places >= 0) & (places <= len(self.distances)))]
            apart = self._apart(typical, places)
            best = int(np.argmin(apart))
            stays = best == 0 or not apart[best] < self.max_distance
            moved.append(float(border) if stays else float(places[best] / self.ratio))
        return moved

    def _typical(self, frames: np.ndarray) -> int:
        """The border whose postures are nearest to those of the others."""
        some = np.unique(np.linspace(0, len(frames) - 1, min(len(frames), SAMPLED)).round().astype(int))
        apart = [np.sum(self._apart(frame, frames[some])) for frame in frames[some].tolist()]
        return int(frames[some][np.argmin(apart)])

    def _apart(self, frame: int, others: np.ndarray) -> np.ndarray:
        """Mean distance of the postures around a frame and around others; infinite where something was not seen."""
        from leitmotion.discovery._border_kernels import around

        apart = np.empty(len(others))
        around(self.distances.across, self.distances.width, frame, others, self.around, apart)
        return apart
