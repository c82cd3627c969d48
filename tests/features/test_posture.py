"""Posture: what may change without changing the numbers."""

import numpy as np
import pytest

from leitmotion.body import ANALYSIS_ROLES, Body, embody, mirror_role
from leitmotion.features import posture
from leitmotion.motion import ParameterError
from oracles.body import human, mirrored, moved, points_of, scaled, without


@pytest.fixture
def dancer(rng):
    return human(rng, frames=90)


def described(motion):
    return posture(embody(motion)).values


def test_invariant_to_place_and_yaw(dancer):
    assert np.allclose(described(dancer), described(moved(dancer, yaw=2.1, by=[4.0, 0.0, -3.0])))


def test_sees_height(dancer):
    whole, lower = (posture(embody(m)) for m in (dancer, moved(dancer, yaw=0.0, by=[0.0, -0.3, 0.0])))
    drop = (whole.values - lower.values).reshape(90, -1, 3)
    assert np.allclose(drop * lower.scale, [0.0, 0.3, 0.0])


@pytest.mark.parametrize("factor", [0.7, 100.0])
def test_invariant_to_unit_and_size(dancer, factor):
    other = posture(embody(scaled(dancer, factor)))
    assert np.allclose(described(dancer), other.values)
    assert other.scale == pytest.approx(factor * embody(dancer).size)


def test_equivariant_to_the_mirror(dancer):
    own, image = posture(embody(dancer)), posture(embody(mirrored(dancer)))
    swap = [own.names.index(mirror_role(name)) for name in own.names]
    expected = own.values.reshape(90, -1, 3)[:, swap] * [-1.0, 1.0, 1.0]
    assert np.allclose(image.values.reshape(90, -1, 3), expected)


def test_a_frame_is_described_by_itself(dancer):
    """Slicing in time changes nothing but the body's size, which is a median over the frames."""
    body = embody(dancer)
    slow = embody(dancer[::3]).replace(size=body.size)
    assert np.allclose(posture(slow).values, posture(body).values[::3])


@pytest.mark.parametrize("joint", ["Spine1", "RightShoulder"])
def test_invariant_to_joints_between(dancer, joint):
    assert np.allclose(described(dancer), described(without(dancer, joint)))


def test_invariant_to_having_a_tree(dancer):
    assert np.allclose(described(dancer), described(points_of(dancer)))


def test_pelvis_stands_on_the_axis_and_the_front_is_z(dancer):
    features = posture(embody(dancer))
    values = features.values.reshape(90, -1, 3)
    assert np.allclose(values[:, features.names.index("pelvis")][:, [0, 2]], 0)
    left = values[:, features.names.index("left_hip")] - values[:, features.names.index("right_hip")]
    assert (left[:, 0] > 0).mean() > 0.9


def test_names_are_the_analysis_roles(dancer):
    assert posture(embody(dancer)).names == ANALYSIS_ROLES
    assert posture(embody(dancer), roles=["head", "left_toe"]).names == ("head", "left_toe")


def test_unseen_points_stay_unseen(dancer):
    points = points_of(dancer)
    holes = points.positions.copy()
    holes[10, points.names.index("LeftHand")] = np.nan
    holes[20, points.names.index("Hips")] = np.nan
    features = posture(embody(points.replace(positions=holes)))
    unseen = np.isnan(features.values.reshape(90, -1, 3)).any(axis=2)
    assert [features.names[i] for i in np.flatnonzero(unseen[10])] == ["left_wrist"]
    assert unseen[20].all()
    assert unseen.sum() == 1 + len(features.names)


def test_points_without_roles_are_centred_on_the_steadiest():
    positions = np.random.default_rng(3).normal(size=(30, 5, 3))
    positions[4, 0] = np.nan
    body = Body(tuple("abcde"), positions, np.zeros(30), rate=30, size=2.0, facing_told=False)
    values = posture(body).values.reshape(30, 5, 3)
    assert np.allclose(values[:, 1:, [0, 2]].mean(axis=1), 0)
    assert np.isfinite(values[4, 1:]).all()
    assert posture(body).invariant_to == ("place", "body_size", "unit")


def test_a_few_roles_among_other_names_do_not_hide_them():
    positions = np.random.default_rng(3).normal(size=(30, 3, 3))
    body = Body(("left_wrist", "right_wrist", "bow"), positions, np.zeros(30), rate=30, size=2.0)
    assert posture(body).names == body.roles


def test_planar_points_keep_two_coordinates(dancer):
    points = points_of(dancer)
    flat = posture(embody(points.replace(positions=points.positions[..., :2], unit="px")))
    assert flat.width == 2
    assert flat.values.shape == (90, 2 * len(flat.names))
    assert "yaw" not in flat.invariant_to


def test_an_unknown_role_is_named(dancer):
    with pytest.raises(ParameterError, match="left_wing"):
        posture(embody(dancer), roles=["left_wing"])
