"""An alignment: which moment of one stretch is which moment of another."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.noun import Noun, noun, set_array


@noun
class Alignment(Noun):
    """A warping path between two stretches.

    Parameters
    ----------
    path : (K, 2) int
        Frames of the first and of the second, never decreasing.
    cost : float
        Mean distance along the path, in the unit of the matrix.
    stop : int
        Frame of the second sequence after the last one matched.
    progress : float
        Which share of the first sequence is matched, 0 to 1.
    """

    path: np.ndarray
    cost: float
    stop: int
    progress: float = 1.0

    def __post_init__(self) -> None:
        set_array(self, "path", dtype=np.int64, shape=(None, 2))
