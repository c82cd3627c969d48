"""Facing: turns with the body, stays through bends, somersaults, cartwheels and gaps."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.body import embody
from leitmotion.body.facing import yaw_of_trunk
from leitmotion.motion import rotations
from oracles.body import human, mirrored, moved, points_of, stiff

TRUNK = {
    "pelvis": (0.0, 0.0, 0.0),
    "neck": (0.0, 0.5, 0.0),
    "left_hip": (0.1, 0.0, 0.0),
    "right_hip": (-0.1, 0.0, 0.0),
    "left_shoulder": (0.2, 0.45, 0.0),
    "right_shoulder": (-0.2, 0.45, 0.0),
}


def angle(a, b):
    return np.abs((a - b + np.pi) % (2 * np.pi) - np.pi).max()


@pytest.mark.parametrize(("yaw", "front"), [(0.0, (0, 1)), (np.pi / 2, (1, 0)), (-np.pi / 2, (-1, 0))])
def test_convention(yaw, front):
    facing = embody(stiff(rotations.yaw_rotation(np.array([yaw])))).facing[0]
    assert np.allclose((np.sin(facing), np.cos(facing)), front)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 1000), st.floats(-6, 6))
def test_turns_with_the_body(seed, yaw):
    motion = human(np.random.default_rng(seed), frames=20)
    assert angle(embody(moved(motion, yaw=yaw, by=[1, 0, 2])).facing, embody(motion).facing + yaw) < 1e-9


def test_changes_sign_in_the_mirror(rng):
    motion = human(rng)
    assert angle(embody(mirrored(motion)).facing, -embody(motion).facing) < 1e-9


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10_000))
def test_is_the_twist_of_the_swing_twist_decomposition(seed):
    """The twin: split the trunk's quaternion into a twist about the vertical and a swing without one."""
    q = np.random.default_rng(seed).normal(size=(50, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    placed = {role: rotations.rotate(q, np.array(place)) for role, place in TRUNK.items()}
    upright = q[:, 0] ** 2 + q[:, 2] ** 2 > 0.15
    for one in np.flatnonzero(upright):
        yaw = yaw_of_trunk({role: place[one : one + 1] for role, place in placed.items()})
        assert angle(yaw, 2 * np.arctan2(q[one, 2], q[one, 0])) < 1e-9


@pytest.mark.parametrize("axis", ["x", "z"])
@pytest.mark.parametrize("way", [1, -1])
def test_stays_through_somersault_and_cartwheel(axis, way):
    over = rotations.from_axis_angle(axis, way * np.linspace(0, 2 * np.pi, 240))
    wobble = rotations.multiply(rotations.yaw_rotation(np.full(240, 0.7)), over)
    facing = embody(stiff(wobble)).facing
    leans = 0.15 if axis == "z" else 1e-9  # the neck of this skeleton stands a little behind the pelvis
    assert np.abs(facing - 0.7).max() < leans


def test_no_spin_when_upside_down_and_wobbling(rng):
    over = rotations.from_axis_angle("x", np.linspace(0, 2 * np.pi, 240))
    roll = rotations.from_axis_angle("z", 0.1 * np.sin(np.linspace(0, 12, 240)))
    facing = embody(stiff(rotations.multiply(over, roll))).facing
    assert np.abs(facing).max() < 0.6
    assert np.abs(np.diff(facing)).max() < 0.1


def test_stays_when_lying_down():
    down = rotations.from_axis_angle("x", np.linspace(0, -np.pi / 2, 60))
    assert np.abs(embody(stiff(down)).facing).max() < 1e-9


def test_is_unwrapped():
    spin = embody(stiff(rotations.yaw_rotation(np.linspace(0, 20, 200)))).facing
    assert np.allclose(spin, np.linspace(0, 20, 200))


def test_gaps_take_the_facing_from_around_them(rng):
    points = points_of(stiff(rotations.yaw_rotation(np.linspace(0, 1, 101))))
    holes = points.positions.copy()
    holes[40:60] = np.nan
    body = embody(points.replace(positions=holes))
    assert np.allclose(body.facing, np.linspace(0, 1, 101))
    assert np.isnan(body.positions[40:60]).all()
    assert np.isfinite(body.positions[:40]).all()


def test_upper_body_alone_tells_it(rng):
    motion = moved(human(rng, bend=0.1), yaw=1.0, by=[0, 0, 0])
    arms = {f"{s}{j}": f"{s}{j}" for s in ("Left", "Right") for j in ("Arm", "ForeArm", "Hand")}
    alone = embody(points_of(motion, arms)).facing
    assert angle(alone, embody(motion).facing) < 0.3


def test_planar_recordings_have_none(rng):
    points = points_of(human(rng))
    flat = points.replace(positions=points.positions[..., :2], unit="px")
    assert not embody(flat).facing.any()
