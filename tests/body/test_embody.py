"""One kind of body: the same person whatever the skeleton."""

import numpy as np
import pytest

from leitmotion.body import ANALYSIS_ROLES, embody
from leitmotion.features import posture
from leitmotion.motion import DataError, Trajectories, forward_kinematics
from oracles.body import human, points_of, scaled, without


def test_positions_are_those_of_forward_kinematics(rng):
    motion = human(rng)
    body = embody(motion)
    elbow = forward_kinematics(motion).positions[:, motion.skeleton.index("LeftForeArm")]
    assert np.allclose(body.positions[:, body.roles.index("left_elbow")], elbow)


@pytest.mark.parametrize("joint", ["Spine1", "Spine", "LeftShoulder"])
def test_joints_between_do_not_matter(joint, rng):
    motion = human(rng)
    whole, less = embody(motion), embody(without(motion, joint))
    for role in ANALYSIS_ROLES:
        assert np.allclose(
            whole.positions[:, whole.roles.index(role)], less.positions[:, less.roles.index(role)]
        ), role
    assert less.size == pytest.approx(whole.size)
    assert np.allclose(less.facing, whole.facing)


def test_a_tree_or_none_is_one_body(rng):
    motion = human(rng)
    tree, points = embody(motion), embody(points_of(motion))
    for role in ANALYSIS_ROLES:
        assert np.allclose(
            tree.positions[:, tree.roles.index(role)], points.positions[:, points.roles.index(role)]
        ), role


def test_size_is_the_chain(rng):
    motion = human(rng)
    trunk = embody(motion)
    pelvis, neck, head = (trunk.positions[:, trunk.roles.index(role)] for role in ("pelvis", "neck", "head"))
    length = np.median(np.linalg.norm(neck - pelvis, axis=1)) + np.median(np.linalg.norm(head - neck, axis=1))
    assert trunk.size == pytest.approx(0.82 + length)


def test_size_goes_with_the_body(rng):
    motion = human(rng)
    assert embody(scaled(motion, 1.3)).size == pytest.approx(1.3 * embody(motion).size)


@pytest.mark.parametrize(
    "joints",
    [
        ("Hips", "UpLeg", "Leg", "Foot"),
        ("Head", "Neck", "Arm", "ForeArm", "Hand"),
        ("Hips", "Neck", "Arm", "ForeArm"),
    ],
)
def test_size_of_half_a_body_is_near_the_whole(joints, rng):
    motion = human(rng)
    names = [
        name for name in motion.skeleton.names if name.removeprefix("Left").removeprefix("Right") in joints
    ]
    half = embody(points_of(motion, {name: name for name in names}))
    assert half.size == pytest.approx(embody(motion).size, rel=0.15)


def test_an_unseen_member_makes_its_role_unseen():
    names = ("LASI", "RASI", "LPSI", "RPSI", "LKNE", "RKNE", "LANK", "RANK")
    positions = np.random.default_rng(1).normal(size=(3, 8, 3))
    positions[1, 0] = np.nan
    body = embody(Trajectories(names, positions, rate=100))
    seen = np.isfinite(body.positions).all(axis=2)
    assert seen[:, body.roles.index("pelvis")].tolist() == [True, False, True]
    assert seen[:, body.roles.index("right_hip")].all()


def test_unknown_points_keep_their_names():
    positions = np.random.default_rng(1).uniform(size=(50, 40, 3))
    positions[..., 1] *= 1.7
    names = tuple(f"Channel{n}" for n in range(101, 141))
    body = embody(Trajectories(names, positions, rate=65))
    assert body.roles == names
    assert not body.facing.any()
    assert 1.2 < body.size < 1.5


def test_a_short_map_gives_unnamed_points_their_facing(rng):
    motion = human(rng)
    names = {name: f"Channel{j}" for j, name in enumerate(motion.skeleton.names)}
    four = {
        "left_hip": "LeftUpLeg",
        "right_hip": "RightUpLeg",
        "left_shoulder": "LeftArm",
        "right_shoulder": "RightArm",
    }
    body = embody(points_of(motion, names), {role: names[joint] for role, joint in four.items()})
    assert body.roles == tuple(names.values())
    assert np.abs(np.sin(body.facing - embody(motion).facing)).max() < 0.1
    assert "yaw" in posture(body).invariant_to


def test_a_skeleton_without_roles_leaves_its_helpers_out(rng):
    from oracles.body import renamed

    motion = human(rng)
    odd = renamed(
        motion, {name: f"bone{j}" for j, name in enumerate(motion.skeleton.names)} | {"Head": "thumb1"}
    )
    body = embody(odd)
    assert "thumb1" not in body.roles
    assert len(body.roles) == len(motion.skeleton) - 1


def test_nothing_to_measure_is_said():
    with pytest.raises(DataError, match="size of the body"):
        embody(Trajectories(("a", "b"), np.full((5, 2, 3), np.nan), rate=30))


def test_no_frame_is_said():
    with pytest.raises(DataError, match="at least one frame"):
        embody(Trajectories(("a",), np.zeros((0, 1, 3)), rate=30))
