"""What numbers describe a frame, and what are they invariant to."""

from leitmotion.features.angles import joint_angles
from leitmotion.features.averaging import averaged
from leitmotion.features.bias import SideBias, side_bias, without_bias
from leitmotion.features.catalogue import FEATURES, Feature, extract
from leitmotion.features.chain import kinematic_chain
from leitmotion.features.directions import limb_directions, limbs_of
from leitmotion.features.markers import marker_posture
from leitmotion.features.mirror import mirror_distance, mirrored
from leitmotion.features.parts import Parts, symmetry_parts
from leitmotion.features.posture import choose_roles, posture
from leitmotion.features.resampling import resample
from leitmotion.features.rotations import joint_rotations
from leitmotion.features.sequence import FeatureSequence
from leitmotion.features.side_ways import SideWays, side_ways
from leitmotion.features.velocity import velocity
from leitmotion.features.weights import active_weights, weighted

__all__ = [
    "FEATURES",
    "Feature",
    "FeatureSequence",
    "Parts",
    "SideBias",
    "SideWays",
    "active_weights",
    "averaged",
    "choose_roles",
    "extract",
    "joint_angles",
    "joint_rotations",
    "kinematic_chain",
    "limb_directions",
    "limbs_of",
    "marker_posture",
    "mirror_distance",
    "mirrored",
    "posture",
    "resample",
    "side_bias",
    "side_ways",
    "symmetry_parts",
    "velocity",
    "weighted",
    "without_bias",
]
