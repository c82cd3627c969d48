"""Joint angles: what may change without changing them, that they are angles, and that none has a pole."""

import numpy as np
import pytest

from leitmotion.body import Body, embody, mirror_role
from leitmotion.features import joint_angles
from leitmotion.motion import DataError
from leitmotion.similarity import self_distance
from oracles.body import human, mirrored, points_of

STANDING = {
    "pelvis": (0.0, 1.0, 0.0), "neck": (0.0, 1.5, 0.0), "head": (0.0, 1.7, 0.0),
    "left_shoulder": (0.2, 1.45, 0.0), "left_elbow": (0.2, 1.15, 0.0), "left_wrist": (0.2, 0.9, 0.0),
    "right_shoulder": (-0.2, 1.45, 0.0), "right_elbow": (-0.2, 1.15, 0.0), "right_wrist": (-0.2, 0.9, 0.0),
    "left_hip": (0.1, 0.95, 0.0), "left_knee": (0.1, 0.5, 0.0), "left_ankle": (0.1, 0.1, 0.0),
    "right_hip": (-0.1, 0.95, 0.0), "right_knee": (-0.1, 0.5, 0.0), "right_ankle": (-0.1, 0.1, 0.0),
}  # fmt: skip


def directions(body):
    told = joint_angles(body)
    return dict(zip(told.names, told.values.reshape(len(body), -1, 3).swapaxes(0, 1), strict=True))


def posed(*poses):
    frames = [[(STANDING | pose)[role] for role in STANDING] for pose in poses]
    return Body(tuple(STANDING), frames, facing=np.zeros(len(frames)), rate=30, size=1.5)


def about(axis, angle):
    """The matrix of a turn, from its definition."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def test_all_are_directions(rng):
    told = joint_angles(embody(human(rng)))
    lengths = np.linalg.norm(told.values.reshape(len(told), -1, 3), axis=2)
    assert told.names == (
        "pelvis", "chest", "neck", "left_shoulder", "left_elbow", "right_shoulder", "right_elbow",
        "left_hip", "left_knee", "right_hip", "right_knee",
    )  # fmt: skip
    assert told.unit == "rad"
    assert np.allclose(lengths, 1.0)


def test_places_alone_tell_them(rng):
    motion = human(rng)
    assert np.allclose(joint_angles(embody(motion)).values, joint_angles(embody(points_of(motion))).values)


def test_equivariant_to_the_mirror(rng):
    motion = human(rng)
    own, image = (directions(embody(each)) for each in (motion, mirrored(motion)))
    for name in own:
        if name == "chest":  # the line from the right to the left is turned round as well
            assert np.allclose(image[name], own[name] * [1.0, -1.0, -1.0])
        else:
            assert np.allclose(image[mirror_role(name)], own[name] * [-1.0, 1.0, 1.0]), name


@pytest.mark.parametrize("angle", [0.1, 0.7, 1.5, 2.5])
def test_a_bent_elbow_moves_the_elbow_alone_by_its_angle(angle):
    wrist = np.array(STANDING["left_elbow"]) + 0.25 * np.array([0.0, -np.cos(angle), np.sin(angle)])
    straight, bent = joint_angles(posed({}, {"left_wrist": tuple(wrist)})).values.reshape(2, -1, 3)
    moved = np.linalg.norm(bent - straight, axis=1)
    assert np.flatnonzero(moved > 1e-9).tolist() == [4]
    assert 2 * np.arcsin(moved[4] / 2) == pytest.approx(angle)


def test_a_swing_from_the_shoulder_leaves_the_elbow(rng):
    """A stiff arm in any pose a person takes keeps its elbow's direction near; the bend itself is exact."""
    shoulder = np.array(STANDING["left_shoulder"])
    upper, fore = np.array([0.0, -0.3, 0.0]), np.array([0.0, 0.0, 0.25])
    for _ in range(40):
        turn = about(rng.normal(size=3), rng.uniform(0, 1.2))
        elbow = shoulder + turn @ upper
        told = directions(posed({"left_elbow": tuple(elbow), "left_wrist": tuple(elbow + turn @ fore)}))
        rest = np.array([1, -1, 1]) / np.sqrt(3)
        assert told["left_elbow"][0] @ rest == pytest.approx(
            0.0, abs=1e-9
        )  # a right angle, whatever the swing


def test_an_arm_raised_over_the_head_makes_no_leap():
    """Past straight up, where angles of elevation and azimuth leap, the directions move as far as the arm does."""
    steps = np.linspace(0.8 * np.pi, 1.2 * np.pi, 41)
    shoulder = np.array(STANDING["left_shoulder"])
    for axis in ((0, 0, 1.0), (1.0, 0, 0), (1.0, 0, 1.0)):
        poses = []
        for angle in steps:
            turn = about(axis, -angle)
            elbow = shoulder + turn @ [0.0, -0.3, 0.0]
            poses.append({"left_elbow": tuple(elbow), "left_wrist": tuple(elbow + turn @ [0.0, -0.1, 0.2])})
        told = directions(posed(*poses))
        for name in ("left_shoulder", "left_elbow"):
            assert np.linalg.norm(np.diff(told[name], axis=0), axis=1).max() < 3.5 * (steps[1] - steps[0]), (
                axis
            )


def test_leaning_is_seen_from_gravity_and_turning_is_not():
    upright = np.array(list(STANDING.values()))
    centre = np.array(STANDING["pelvis"])
    frames = [
        (turn @ (upright - centre).T).T + centre
        for turn in (np.eye(3), about((0, 1, 0), 2.0), about((1, 0, 0), 0.5))
    ]
    apart = self_distance(
        joint_angles(Body(tuple(STANDING), frames, facing=[0, 0, 0], rate=30, size=1.5))
    ).values
    assert apart[0, 1] == pytest.approx(0.0, abs=1e-6)
    assert apart[0, 2] == pytest.approx(2 * np.sin(0.25) / 11, abs=1e-6)


def test_what_is_unseen_hides_what_hangs_on_it(rng):
    body = embody(human(rng, frames=4))
    positions = body.positions.copy()
    positions[1, body.roles.index("left_elbow")] = np.nan
    told = directions(body.replace(positions=positions))
    assert {name for name, rows in told.items() if np.isnan(rows[1]).any()} == {"left_shoulder", "left_elbow"}
    assert not any(np.isnan(rows[[0, 2, 3]]).any() for rows in told.values())


def test_joints_in_one_place_have_no_direction():
    told = directions(posed({"left_elbow": STANDING["left_shoulder"]}))
    assert {name for name, rows in told.items() if np.isnan(rows).any()} == {"left_shoulder", "left_elbow"}


def test_what_cannot_be_told_is_a_sentence():
    flat = Body(("pelvis", "neck"), np.zeros((1, 2, 2)), facing=[0.0], rate=30, size=1.0)
    with pytest.raises(DataError, match="three dimensions, got two"):
        joint_angles(flat)
    for roles, lacks in (
        (("pelvis", "left_hip", "right_hip"), "no neck"),
        (("pelvis", "neck"), "hips or shoulders"),
    ):
        with pytest.raises(DataError, match=lacks):
            joint_angles(Body(roles, np.ones((1, len(roles), 3)), facing=[0.0], rate=30, size=1.0))
