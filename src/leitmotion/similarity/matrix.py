"""A similarity matrix: how far apart any two moments are."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun, set_array

KINDS = ("dense", "banded")


@noun
class SimilarityMatrix(Noun):
    """Distances between the moments of one recording, or of two.

    Parameters
    ----------
    values : (N, M) float32
        Distance of row moment to column moment, 0 = same. Of a banded one ``values[i, k]`` is the distance of
        moment i to moment i + k, NaN past the end.
    metric : str
        "mean_norm" (paper P, eq. 2: the mean over joints of the norms) or another named metric.
    row_rate, column_rate : float
        Frames per second along each axis.
    scale : float
        What a distance of 1 is in `unit`.
    unit : {"m", "px", "relative", "m/s", "px/s", "relative/s", "rad"}
        That of the features compared: of places, of velocities, of rotations.
    kind : {"dense", "banded"}
        How the values are stored: all of them, or those next to the diagonal of one recording with itself.

    Raises
    ------
    ParameterError
        When shapes or words are none of these.
    """

    values: np.ndarray
    metric: str
    row_rate: float
    column_rate: float
    scale: float = 1.0
    unit: str = "m"
    kind: str = "dense"

    def __post_init__(self) -> None:
        set_array(self, "values", dtype=np.float32, shape=(None, None), finite=False)
        if self.kind not in KINDS:
            raise ParameterError(
                f"SimilarityMatrix.kind must be one of {', '.join(KINDS)}, got {self.kind!r}."
            )
        if not (self.row_rate > 0 and self.column_rate > 0):
            raise ParameterError(f"Rates must be positive, got {self.row_rate} and {self.column_rate}.")
