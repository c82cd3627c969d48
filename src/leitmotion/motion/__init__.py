"""What is a recording: the nouns, rotation algebra, forward kinematics.

Axes are ``(time, joint, component)``; letters ``T`` frames, ``J`` joints, ``P`` points, ``S`` segments. Metres,
radians, seconds, hertz; right-handed, Y up, facing +Z at rest, +X the person's left; quaternions ``(w, x, y, z)``.
"""

from leitmotion.motion import rotations
from leitmotion.motion.errors import DataError, FormatError, LeitmotionError, ParameterError
from leitmotion.motion.kinematics import GlobalPose, end_site_positions, forward_kinematics, joint_points
from leitmotion.motion.motion import Motion
from leitmotion.motion.resampling import resample
from leitmotion.motion.segmentation import Segmentation
from leitmotion.motion.skeleton import Skeleton
from leitmotion.motion.trajectories import Trajectories

__all__ = [
    "DataError",
    "FormatError",
    "GlobalPose",
    "LeitmotionError",
    "Motion",
    "ParameterError",
    "Segmentation",
    "Skeleton",
    "Trajectories",
    "end_site_positions",
    "forward_kinematics",
    "joint_points",
    "resample",
    "rotations",
]
