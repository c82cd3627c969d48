"""A motion: a skeleton and how each of its joints moves."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array
from leitmotion.motion.skeleton import Skeleton
from leitmotion.motion.time import slice_rate

_UNIT = 1e-6  # how far from 1 the length of a unit quaternion may lie


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
        When shapes disagree with the skeleton, a number is not finite, a quaternion has another length than 1 (by more
        than 1e-6) or the rate is not positive.

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
        if not isinstance(self.skeleton, Skeleton):
            raise ParameterError(f"Motion.skeleton must be a Skeleton, got {self.skeleton!r:.60}.")
        joints = len(self.skeleton)
        frames = set_array(self, "local_positions", dtype=np.float64, shape=(None, joints, 3)).shape[0]
        quaternions = set_array(self, "local_rotations", dtype=np.float64, shape=(frames, joints, 4))
        squares = np.einsum("tjc,tjc->tj", quaternions, quaternions)
        if squares.size and not (squares.min() >= (1 - _UNIT) ** 2 and squares.max() <= (1 + _UNIT) ** 2):
            frame, joint = np.unravel_index(np.abs(squares - 1.0).argmax(), squares.shape)
            raise ParameterError(
                "Motion.local_rotations must be unit quaternions, got one of length "
                f"{squares[frame, joint] ** 0.5:.9g} of joint {self.skeleton.names[joint]!r} in frame {frame}.",
                remedy="leitmotion.motion.rotations.normalize scales quaternions that are not zero.",
            )
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
