"""Feet in seams: what stands keeps standing, bones keep their lengths, and the rest is left alone."""

import numpy as np
import pytest

from leitmotion.body import BodyMap, find_roles
from leitmotion.datasets import Action, compose
from leitmotion.motion import Motion, forward_kinematics
from leitmotion.motion.rotations import geodesic_angle
from leitmotion.synthesis import join
from leitmotion.synthesis.blending import smooth_weights
from leitmotion.synthesis.footing import Leg, _corrections, hold_feet, legs_of, planted

RATE = 60.0


@pytest.fixture(scope="module")
def session() -> Motion:
    """Somebody who stands, squats, walks and jumps."""
    actions = [Action("still"), Action("squat", 2), Action("walk", 2), Action("jumping jack", 2)]
    return compose(actions, seed=5, rate=RATE).motion


@pytest.fixture(scope="module")
def legs(session: Motion) -> tuple[Leg, ...]:
    return legs_of(session, find_roles(session))


def stance(motion: Motion, apart: float, frames: int) -> Motion:
    """The first posture, held, with the left leg out to the side by some radians."""
    from leitmotion.motion.rotations import from_axis_angle, multiply

    held = motion[:1]
    turned = held.local_rotations.copy()
    leg = motion.skeleton.names.index("LeftUpLeg")
    turned[:, leg] = multiply(turned[:, leg], from_axis_angle("z", np.array([apart])))
    return motion.replace(
        local_positions=held.local_positions.repeat(frames, axis=0),
        local_rotations=turned.repeat(frames, axis=0),
    )


def mixed(a: Motion, b: Motion) -> Motion:
    """Half of one, half of the other, so that feet lie between."""
    half = (
        a.local_rotations
        + np.sign((a.local_rotations * b.local_rotations).sum(-1))[..., None] * b.local_rotations
    )
    return a.replace(local_rotations=half / np.linalg.norm(half, axis=-1, keepdims=True))


def test_both_legs_are_found_with_what_they_stand_on(session: Motion, legs: tuple[Leg, ...]) -> None:
    names = session.skeleton.names
    assert [names[leg.hip] for leg in legs] == ["LeftUpLeg", "RightUpLeg"]
    assert [names[leg.foot] for leg in legs] == ["LeftToeBase", "RightToeBase"]
    floor = forward_kinematics(session).positions[..., 1].min()
    assert all(leg.floor == pytest.approx(floor, abs=0.05) for leg in legs)


def test_where_roles_are_unknown_nothing_is_held(session: Motion) -> None:
    assert legs_of(session, BodyMap((), (), np.zeros(0))) == ()
    only_hip = BodyMap(("left_hip",), (("LeftUpLeg",),), np.ones(1))
    assert legs_of(session, only_hip) == ()


def test_a_foot_that_stands_is_told_from_one_that_swings(session: Motion, legs: tuple[Leg, ...]) -> None:
    places = forward_kinematics(session).positions[:, legs[0].foot]
    stands = planted(places, legs[0], RATE)
    assert stands[:60].all()
    high = places[:, 1] > legs[0].floor + 0.055
    assert high.any()
    assert not stands[high].any()


def test_bones_hips_and_the_direction_of_feet_stay(session: Motion, legs: tuple[Leg, ...]) -> None:
    a, b = session[150:186], session[230:266]
    seam = mixed(a, b)
    before, after = forward_kinematics(seam), forward_kinematics(hold_feet(seam, a, b, legs))
    assert np.allclose(hold_feet(seam, a, b, legs).local_positions, seam.local_positions)
    parents = session.skeleton.parents
    for joint in range(1, len(parents)):
        bones = [pose.positions[:, joint] - pose.positions[:, parents[joint]] for pose in (before, after)]
        assert np.allclose(*(np.linalg.norm(bone, axis=1) for bone in bones), atol=1e-9)
    for leg in legs:
        assert np.allclose(before.positions[:, leg.hip], after.positions[:, leg.hip], atol=1e-9)
        assert geodesic_angle(before.rotations[:, leg.ankle], after.rotations[:, leg.ankle]).max() < 1e-6
    others = [j for j in range(len(parents)) if not any(j in leg[:3] for leg in legs)]
    held = hold_feet(seam, a, b, legs)
    assert np.array_equal(held.local_rotations[:, others], seam.local_rotations[:, others])


@pytest.mark.parametrize("apart", [0.1, 0.3])
def test_of_two_stances_each_foot_holds_the_first_then_steps_to_the_second(
    session: Motion, legs: tuple[Leg, ...], apart: float
) -> None:
    a, b = stance(session, 0.0, 60), stance(session, apart, 60)
    left = next(leg for leg in legs if session.skeleton.names[leg.hip] == "LeftUpLeg")._replace(floor=1.0)
    held = hold_feet(mixed(a, b), a, b, (left,))
    foot, first, last = (forward_kinematics(motion).positions[:, left.foot] for motion in (held, a, b))
    assert np.allclose(foot[:18], first[:18], atol=0.012)
    assert np.allclose(foot[-18:], last[-18:], atol=0.012)
    assert foot[:, 1].max() > max(first[0, 1], last[0, 1]) + 0.01
    assert np.linalg.norm(np.diff(foot, axis=0), axis=1).max() * RATE < 3.0


def test_feet_that_swing_at_both_ends_are_left_alone(session: Motion, legs: tuple[Leg, ...]) -> None:
    a, b = session[150:170], session[300:320]
    sunk = tuple(leg._replace(floor=-9.0) for leg in legs)
    seam = mixed(a, b)
    assert np.array_equal(hold_feet(seam, a, b, sunk).local_rotations, seam.local_rotations)


def test_overlapping_pieces_of_one_motion_are_that_motion_with_feet_held(
    session: Motion, legs: tuple[Leg, ...]
) -> None:
    joined = join([session[:200], session[160:300], session[270:]], [40, 30], legs)
    places = [forward_kinematics(motion).positions for motion in (joined.recording, session)]
    np.testing.assert_allclose(*places, atol=2e-4)


@pytest.mark.parametrize(("stays", "comes"), [(0, 4), (3, 5), (36, 36), (36, 0), (33, 35), (10, 30), (32, 0)])
def test_no_foot_is_torn_away_whenever_it_stands(stays: int, comes: int) -> None:
    """A leg of 0.85 m whose foot stands for some frames at 0 and from some frame on 12 cm beside it."""
    leg = Leg(0, 1, 2, 3, 0.85, 0.02)
    frames, rate = 36, 120.0
    first, last = np.full((frames, 3), 0.02), np.full((frames, 3), 0.02)
    last[:, 0] += 0.12
    first[stays:, 1], last[:comes, 1] = 0.2, 0.2
    between = smooth_weights(frames)[:, None]
    shift = _corrections((1 - between) * first + between * last, first, last, leg, rate)
    assert shift is not None
    jumps = np.linalg.norm(np.diff(shift[:, [0, 2]], axis=0), axis=1)
    assert jumps.max() * rate < 3.0
    assert np.linalg.norm(shift[[0, -1]][:, [0, 2]], axis=1).max() < 0.03
