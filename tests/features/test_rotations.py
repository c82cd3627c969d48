"""Joint rotations: the joints' own turns, whatever stands between them."""

import numpy as np
import pytest

from leitmotion.body import find_roles
from leitmotion.features import joint_rotations
from leitmotion.motion import Motion, ParameterError, Skeleton, rotations
from oracles.body import human, moved, scaled, without


@pytest.fixture
def dancer(rng):
    return human(rng, frames=90)


def test_invariant_to_place_yaw_and_size(dancer):
    own = joint_rotations(dancer).values
    assert np.allclose(own, joint_rotations(moved(dancer, yaw=2.2, by=[1, 2, 3])).values)
    assert np.allclose(own, joint_rotations(scaled(dancer, 2.0)).values)


@pytest.mark.parametrize("joint", ["Spine1", "LeftShoulder"])
def test_joints_between_do_not_matter_to_the_limbs(dancer, joint):
    own, less = joint_rotations(dancer), joint_rotations(without(dancer, joint))
    for role in ("left_elbow", "left_knee", "right_wrist", "pelvis"):
        a, b = (f.values.reshape(90, -1, 4)[:, f.names.index(role)] for f in (own, less))
        assert np.allclose(a, b), role


def test_an_elbow_is_its_local_rotation(dancer):
    features = joint_rotations(dancer, roles=["left_elbow"])
    local = dancer.local_rotations[:, dancer.skeleton.index("LeftForeArm")]
    assert np.allclose(rotations.geodesic_angle(features.values, local), 0, atol=1e-6)


def test_values_are_unit_and_the_pelvis_has_no_yaw(dancer):
    features = joint_rotations(dancer)
    values = features.values.reshape(90, -1, 4)
    assert np.allclose(np.linalg.norm(values, axis=2), 1)
    assert np.allclose(values[:, features.names.index("pelvis"), 2], 0)


def test_signs_do_not_matter(dancer, rng):
    signs = rng.choice([-1.0, 1.0], size=dancer.local_rotations.shape[:2])[..., None]
    flipped = dancer.replace(local_rotations=dancer.local_rotations * signs)
    assert np.allclose(joint_rotations(dancer).values, joint_rotations(flipped).values)


def test_equal_poses_have_equal_values_after_a_full_turn():
    arm = Skeleton(("LeftArm", "LeftForeArm"), [-1, 0], [[0, 1, 0], [0.3, 0, 0]])
    bend = 0.4 * np.sin(np.linspace(0, 4 * np.pi, 101))
    swing = rotations.from_axis_angle("z", bend + np.r_[np.zeros(50), np.full(51, 2 * np.pi)])
    local = np.stack([np.tile(rotations.IDENTITY, (101, 1)), swing], axis=1)
    elbow = joint_rotations(
        Motion(arm, np.tile(arm.offsets, (101, 1, 1)), local, rate=50), roles=["left_elbow"]
    )
    assert np.allclose(elbow.values[:50], elbow.values[50:100])


def test_distance_times_scale_is_an_angle(dancer):
    features = joint_rotations(dancer, roles=["left_knee"])
    a, b = features.values[0], features.values[30]
    assert np.linalg.norm(a - b) * features.scale == pytest.approx(rotations.geodesic_angle(a, b), rel=0.03)


def test_a_role_of_several_joints_has_no_rotation(dancer):
    less = without(dancer, "Neck")
    assert "neck" not in joint_rotations(less, find_roles(less)).names
    with pytest.raises(ParameterError, match="neck"):
        joint_rotations(less, roles=["neck"])
