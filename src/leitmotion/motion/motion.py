"""A motion: a skeleton and how each of its joints moves."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.noun import Noun, check_rate, noun, set_array
from leitmotion.motion.skeleton import Skeleton
from leitmotion.motion.time import slice_rate


@noun
class Motion(Noun):
    """A skeleton in motion, one person.

    Parameters
    ----------
    skeleton : Skeleton
        The joints and their tree.
    local_positions : (T, J, 3) float
        Position of each joint in its parent's frame (of a root: in the world), metres. Equal to the offset
        wherever the file moves only rotations.
    local_rotations : (T, J, 4) float
        Unit quaternion (w, x, y, z) of each joint in its parent's frame, continuous along time.
    rate : float
        Frames per second.
    name : str
        What the recording is called.

    Raises
    ------
    ParameterError
        When shapes disagree with the skeleton, a number is not finite or the rate is not positive.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Motion, Skeleton
    >>> arm = Skeleton(("shoulder", "elbow"), [-1, 0], [[0, 0, 0], [0.3, 0, 0]])
    >>> still = np.tile([1.0, 0, 0, 0], (240, 2, 1))
    >>> motion = Motion(arm, np.broadcast_to(arm.offsets, (240, 2, 3)), still, rate=120)
    >>> len(motion), motion.duration, len(motion[60:120])
    (240, 2.0, 60)
    """

    skeleton: Skeleton
    local_positions: np.ndarray
    local_rotations: np.ndarray
    rate: float
    name: str = ""

    def __post_init__(self) -> None:
        joints = len(self.skeleton)
        frames = set_array(self, "local_positions", dtype=np.float64, shape=(None, joints, 3)).shape[0]
        set_array(self, "local_rotations", dtype=np.float64, shape=(frames, joints, 4))
        check_rate(self)

    def __len__(self) -> int:
        return self.local_positions.shape[0]

    @property
    def duration(self) -> float:
        """Length in seconds."""
        return len(self) / self.rate

    @property
    def times(self) -> np.ndarray:
        """Time of each frame in seconds, shape (T,)."""
        return np.arange(len(self)) / self.rate

    def __getitem__(self, frames: slice) -> Motion:
        rate = slice_rate(self.rate, frames)  # refuses what is no slice before an array is asked
        return self.replace(
            local_positions=self.local_positions[frames],
            local_rotations=self.local_rotations[frames],
            rate=rate,
        )
