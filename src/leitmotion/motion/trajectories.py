"""Trajectories: points that move, without a skeleton, some of them unseen at times."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array, set_names
from leitmotion.motion.time import slice_rate

UNITS = ("m", "px", "relative")
KINDS = ("marker", "joint")


@noun
class Trajectories(Noun):
    """Named points in motion, one person.

    Parameters
    ----------
    names : tuple of str, P
        One name per point.
    positions : (T, P, C) float
        Where each point is, C = 2 or 3; NaN where it was not seen. Metres in the house's frame (Y up,
        right-handed) when `unit` is "m".
    rate : float
        Frames per second.
    unit : {"m", "px", "relative"}
        What a number means.
    kind : {"marker", "joint"}
        Whether a point sits on the skin or in a joint.
    confidence : (T, P) float or None
        How sure the source was of each point, 0 (not at all, or it did not say) to 1; never NaN.
    name : str
        What the recording is called.

    Raises
    ------
    ParameterError
        When shapes disagree, a name is doubled or empty, a confidence lies outside 0 to 1 or a word is none of those
        listed.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Trajectories
    >>> hands = Trajectories(("LFIN", "RFIN"), np.zeros((100, 2, 3)), rate=50)
    >>> len(hands), hands.duration
    (100, 2.0)
    """

    names: tuple[str, ...]
    positions: np.ndarray
    rate: float
    unit: str = "m"
    kind: str = "marker"
    confidence: np.ndarray | None = None
    name: str = ""

    def __post_init__(self) -> None:
        points = len(set_names(self, "names"))
        positions = set_array(self, "positions", dtype=np.float64, shape=(None, points, None), finite=False)
        if positions.shape[2] not in (2, 3):
            raise ParameterError(
                f"Trajectories.positions must have 2 or 3 coordinates, got {positions.shape[2]}."
            )
        if np.isinf(positions).any():
            raise ParameterError("Trajectories.positions must be finite or NaN, got infinity.")
        if self.confidence is not None:
            sure = set_array(self, "confidence", dtype=np.float64, shape=positions.shape[:2])
            if sure.size and not (sure.min() >= 0.0 and sure.max() <= 1.0):
                raise ParameterError(
                    f"Trajectories.confidence must lie in [0, 1], got {sure.min():g} to {sure.max():g}."
                )
        if self.unit not in UNITS:
            raise ParameterError(f"Trajectories.unit must be one of {', '.join(UNITS)}, got {self.unit!r}.")
        if self.kind not in KINDS:
            raise ParameterError(f"Trajectories.kind must be one of {', '.join(KINDS)}, got {self.kind!r}.")
        check_rate(self)

    def __len__(self) -> int:
        return self.positions.shape[0]

    @property
    def duration(self) -> float:
        """Length in seconds."""
        return len(self) / self.rate

    @property
    def times(self) -> np.ndarray:
        """Time of each frame in seconds, shape (T,)."""
        return np.arange(len(self)) / self.rate

    def __getitem__(self, frames: slice) -> Trajectories:
        rate = slice_rate(self.rate, frames)  # refuses what is no slice before an array is asked
        return self.replace(
            positions=self.positions[frames],
            confidence=None if self.confidence is None else self.confidence[frames],
            rate=rate,
        )
