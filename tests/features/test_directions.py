"""Limb directions: what may change without changing them, that they are directions, and what is refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from leitmotion.body import ROLES, Body, embody
from leitmotion.features import limb_directions, limbs_of, posture
from leitmotion.features.directions import BONES
from leitmotion.features.mirror import mirrored as exchanged
from leitmotion.motion import DataError
from oracles.body import human, mirrored, moved, points_of, stretched

FROM_PELVIS = {"neck": "pelvis", "left_shoulder": "neck", "right_shoulder": "neck", "left_hip": "pelvis",
               "right_hip": "pelvis"} | {name: above for name, above in BONES.items() if name != "neck"}  # fmt: skip
"""A tree of the roles: each with the one that it hangs on, those above first."""


def built(directions, lengths, facing=0.0, size=1.4):
    """A body of one frame whose bones have these directions and lengths."""
    at = {"pelvis": np.array([0.3, 1.0, -0.7])}
    for role, above in FROM_PELVIS.items():
        at[role] = at[above] + lengths[role] * directions[role]
    return Body(tuple(at), np.array(list(at.values()))[None], facing=[facing], rate=30, size=size)


def some(rng):
    vectors = {role: rng.normal(size=3) for role in FROM_PELVIS}
    return {role: vector / np.linalg.norm(vector) for role, vector in vectors.items()}


@given(st.integers(0, 10**6))
def test_the_lengths_of_bones_change_nothing_and_places_change(seed):
    rng = np.random.default_rng(seed)
    directions = some(rng)
    bodies = [built(directions, {role: rng.uniform(0.05, 0.6) for role in FROM_PELVIS}) for _ in range(2)]
    one, other = (limb_directions(body) for body in bodies)
    np.testing.assert_allclose(one.values, other.values, atol=1e-12)
    assert np.abs(posture(bodies[0]).values - posture(bodies[1]).values).max() > 1e-3
    for k, name in enumerate(one.names):
        np.testing.assert_allclose(one.values[0, 3 * k : 3 * k + 3], directions[name], atol=1e-12)


@given(st.floats(-4, 4), st.integers(0, 10**6))
def test_a_turn_about_the_vertical_changes_nothing(angle, seed):
    rng = np.random.default_rng(seed)
    directions, lengths = some(rng), dict.fromkeys(FROM_PELVIS, 0.3)
    cosine, sine = np.cos(angle), np.sin(angle)
    turn = np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]])  # +Z goes to (sin, 0, cos)
    turned = {role: turn @ vector for role, vector in directions.items()}
    one, other = (
        limb_directions(built(ways, lengths, facing)) for ways, facing in ((directions, 0.0), (turned, angle))
    )
    np.testing.assert_allclose(one.values, other.values, atol=1e-12)


def test_all_are_directions_of_any_recording(rng):
    motion = human(rng)
    told = limb_directions(embody(motion))
    assert told.names == tuple(BONES)
    assert (told.unit, told.scale, told.width) == ("rad", 1.0, 3)
    np.testing.assert_allclose(np.linalg.norm(told.values.reshape(len(told), -1, 3), axis=2), 1.0)
    np.testing.assert_allclose(told.values, limb_directions(embody(points_of(motion))).values)


def test_long_limbs_and_another_place_change_nothing_broad_shoulders_hardly(rng):
    motion = human(rng)
    own = limb_directions(embody(motion))
    long = stretched(motion, {"ForeArm": 0.7, "Hand": 1.6, "Leg": 1.2, "Foot": 0.8})
    np.testing.assert_allclose(limb_directions(embody(long)).values, own.values, atol=1e-9)
    broad = stretched(motion, {"Arm": 1.5, "UpLeg": 1.3})  # the facing is told by hips and shoulders together
    np.testing.assert_allclose(limb_directions(embody(broad)).values, own.values, atol=0.02)
    away = moved(motion, yaw=2.0, by=[3.0, 0.0, 1.0])
    np.testing.assert_allclose(limb_directions(embody(away)).values, own.values, atol=1e-9)


def test_the_mirror_exchanges_the_sides(rng):
    motion = human(rng)
    image = exchanged(limb_directions(embody(motion)))
    np.testing.assert_allclose(image.values, limb_directions(embody(mirrored(motion))).values, atol=1e-9)


def test_a_bone_turns_by_its_angle():
    straight, bent = (
        limb_directions(Body(("left_elbow", "left_wrist"), [[[0, 0, 0], wrist]], facing=[0], rate=30, size=1))
        for wrist in ([0.0, -0.3, 0.0], [0.0, -0.3 * np.cos(0.5), 0.3 * np.sin(0.5)])
    )
    assert 2 * np.arcsin(np.linalg.norm(straight.values - bent.values) / 2) == pytest.approx(0.5)


def test_what_is_unseen_or_has_no_length_is_nan_and_the_rest_is_told():
    roles = ("left_hip", "left_knee", "left_ankle")
    frames = [[[0, 1, 0], [0, 0.5, 0], [0, 0.5, 0]], [[0, 1, 0], [np.nan] * 3, [0, 0, 0]]]
    told = limb_directions(Body(roles, frames, facing=[0, 0], rate=30, size=1))
    np.testing.assert_array_equal(told.values, [[0, -1, 0, np.nan, np.nan, np.nan], [np.nan] * 6])


def test_a_plane_and_a_body_without_limbs_are_refused():
    flat = Body(("left_hip", "left_knee"), np.zeros((2, 2, 2)), facing=[0, 0], rate=30, size=1)
    with pytest.raises(DataError, match="three dimensions"):
        limb_directions(flat)
    cloud = Body(("a", "left_knee"), np.zeros((2, 2, 3)), facing=[0, 0], rate=30, size=1)
    assert limbs_of(cloud) == ()
    with pytest.raises(DataError, match="no two joints of one limb"):
        limb_directions(cloud)
    assert set(BONES) | set(BONES.values()) <= set(ROLES)
