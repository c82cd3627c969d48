"""Distances of a recording with itself, computed when they are asked for: an hour has more than fit in memory."""

from __future__ import annotations

import numpy as np

from leitmotion.features.sequence import FeatureSequence
from leitmotion.similarity.distance import _across_time, _centre
from leitmotion.similarity.matrix import SimilarityMatrix


class Distances:
    """Paper P, eq. 2, between any two moments of one recording; to the bit what :func:`self_distance` says.

    Parameters
    ----------
    features : FeatureSequence
        N moments.

    Examples
    --------
    >>> hand = FeatureSequence([[0, 0, 0], [3, 4, 0], [0, 0, 1]], ("hand",), rate=60, width=3)
    >>> distances = Distances(hand)
    >>> distances.between(range(0, 1), range(1, 3)).tolist()
    [[5.0, 1.0]]
    """

    def __init__(self, features: FeatureSequence) -> None:
        self.features = features
        self.width = features.width
        self.across = _across_time(features, _centre("mean_norm", features))
        """(D, N) float32: what is compared, one moment a column."""
        self._bands: dict[int, SimilarityMatrix] = {}

    def __len__(self) -> int:
        return self.across.shape[1]

    def between(self, rows: range, columns: range) -> np.ndarray:
        """Distances of some moments to others.

        Parameters
        ----------
        rows, columns : range
            Moments, in ascending order.

        Returns
        -------
        (len(rows), len(columns)) float32
        """
        from leitmotion.similarity import _kernels

        values = np.empty((len(rows), len(columns)), np.float32)
        _kernels.between(
            self.across, rows.start, rows.step, columns.start, columns.stop, columns.step, self.width, values
        )
        return values

    def along(self, path: np.ndarray) -> np.ndarray:
        """Distances along a path.

        Parameters
        ----------
        path : (K, 2) int
            Moments.

        Returns
        -------
        (K,) float32
        """
        from leitmotion.similarity import _kernels

        values = np.empty(len(path), np.float32)
        _kernels.along(self.across, path[:, 0], path[:, 1], self.width, values)
        return values

    def band(self, reach: int) -> SimilarityMatrix:
        """Distances of each moment to those that follow it closely.

        Parameters
        ----------
        reach : int
            How many moments later the last one is.

        Returns
        -------
        SimilarityMatrix
            Banded, (N, reach + 1); kept, as much is read from it.
        """
        if reach in self._bands:
            return self._bands[reach]
        from leitmotion.similarity import _kernels

        values = np.empty((len(self), reach + 1), np.float32)
        _kernels.band(self.across, self.width, values)
        values.flags.writeable = False
        features = self.features
        self._bands[reach] = SimilarityMatrix(
            values, "mean_norm", features.rate, features.rate, features.scale, features.unit, "banded"
        )
        return self._bands[reach]
