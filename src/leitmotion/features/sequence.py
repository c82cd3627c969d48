"""A feature sequence: one row of numbers a frame, each knowing what it is invariant to."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array, set_names
from leitmotion.motion.time import slice_rate


@noun
class FeatureSequence(Noun):
    """What describes each frame.

    Parameters
    ----------
    values : (T, D) float
        One row a frame; NaN where a point was unseen.
    names : tuple of str, D / width
        One name per point (``width`` 3), joint (``width`` 4) or number (``width`` 1).
    rate : float
        Frames per second.
    invariant_to : tuple of str
        Of "place", "yaw", "body_size", "unit", "bone_lengths", "tempo": what may change without changing the values.
    width : int
        How many consecutive values belong to one name; distances average the norms of these groups.
    scale : float
        What one unit of `values` is in `unit`: metres when the recording is in metres, so that a distance times
        `scale` is metres again.
    unit : {"m", "px", "relative", "m/s", "px/s", "relative/s", "rad"}
        What values times `scale` are: places in the recording's own unit, velocities in that unit a second,
        rotations in radians.
    weights : tuple of float
        By which the values of each name were multiplied (:func:`leitmotion.features.weighted`); empty where all count
        alike.

    Raises
    ------
    ParameterError
        When shapes disagree.
    """

    values: np.ndarray
    names: tuple[str, ...]
    rate: float
    invariant_to: tuple[str, ...] = ()
    width: int = 1
    scale: float = 1.0
    unit: str = "m"
    weights: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        names = set_names(self, "names")
        set_array(self, "values", dtype=np.float64, shape=(None, len(names) * self.width), finite=False)
        if self.width < 1:
            raise ParameterError(f"FeatureSequence.width must be 1 or more, got {self.width}.")
        weights = tuple(float(weight) for weight in self.weights)
        if weights and len(weights) != len(names):
            raise ParameterError(
                f"FeatureSequence.weights has one for each of the {len(names)} names or none, got {len(weights)}."
            )
        object.__setattr__(self, "weights", weights)
        check_rate(self)

    def __len__(self) -> int:
        return self.values.shape[0]

    def __getitem__(self, frames: slice) -> FeatureSequence:
        return self.replace(values=self.values[frames], rate=slice_rate(self.rate, frames))
