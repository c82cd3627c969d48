"""What numbers describe a frame, and what are they invariant to."""

from leitmotion.features.angles import joint_angles
from leitmotion.features.catalogue import FEATURES, Feature, extract
from leitmotion.features.directions import limb_directions, limbs_of
from leitmotion.features.markers import marker_posture
from leitmotion.features.mirror import mirrored
from leitmotion.features.posture import choose_roles, posture
from leitmotion.features.resampling import resample
from leitmotion.features.rotations import joint_rotations
from leitmotion.features.sequence import FeatureSequence
from leitmotion.features.velocity import velocity
from leitmotion.features.weights import active_weights, weighted

__all__ = [
    "FEATURES",
    "Feature",
    "FeatureSequence",
    "active_weights",
    "choose_roles",
    "extract",
    "joint_angles",
    "joint_rotations",
    "limb_directions",
    "limbs_of",
    "marker_posture",
    "mirrored",
    "posture",
    "resample",
    "velocity",
    "weighted",
]
