"""Sides: feet, knees, elbows and the way walked say whether left is left."""

import numpy as np
import pytest

from leitmotion.body import BodyMap, check_sides, find_roles, mirror_role, swap_sides
from leitmotion.body.sides import weigh_sides
from oracles.body import human, mirrored, moved, points_of, scaled

io = pytest.importorskip("leitmotion.io")

STILL = {
    "pelvis": (0.0, 1.0, 0.0), "neck": (0.0, 1.5, 0.0),
    "left_hip": (0.1, 0.9, 0.0), "right_hip": (-0.1, 0.9, 0.0),
}  # fmt: skip


def standing(frames=50, **places):
    """Some roles of a person who faces +Z, in every frame at one place unless an array is given."""
    return {
        role: np.broadcast_to(np.asarray(place, dtype=float), (frames, 3))
        for role, place in {**STILL, **places}.items()
    }


def both(**limbs):
    """The right side's places and the left's, which is their mirror image."""
    return {
        f"{side}_{role}": (sign * x, y, z)
        for side, sign in (("left", 1), ("right", -1))
        for role, (x, y, z) in limbs.items()
    }


def going(points, velocity, step=0.25):
    """Where they all are a step later."""
    return {role: place + np.asarray(velocity) * step for role, place in points.items()}


def swapped(points):
    return {mirror_role(role): place for role, place in points.items()}


FEET = both(ankle=(0.1, 0.1, 0.0), toe=(0.1, 0.02, 0.14))
BENT_KNEES = both(knee=(0.1, 0.5, 0.15), ankle=(0.1, 0.1, 0.0))
HANGING_ARMS = both(shoulder=(0.2, 1.4, 0.0), elbow=(0.22, 1.12, -0.08), wrist=(0.2, 0.9, 0.1))


@pytest.mark.parametrize(("limbs", "kind"), [(FEET, "feet"), (BENT_KNEES, "knees"), (HANGING_ARMS, "elbows")])
def test_each_part_of_a_body_votes(limbs, kind):
    points = standing(**limbs)
    said = weigh_sides(points, points, 0.25, 10.0)
    assert said.votes == {kind: pytest.approx(1.0)}
    assert weigh_sides(swapped(points), swapped(points), 0.25, 10.0).votes == {kind: pytest.approx(-1.0)}


def test_walking_votes_once_it_is_far_enough():
    points = standing(**BENT_KNEES)
    for velocity, seconds, vote in (((0, 0, 1.2), 10, 1.0), ((0, 0, -1.2), 10, -1.0), ((0, 0, 1.2), 1, None)):
        said = weigh_sides(points, going(points, velocity), 0.25, seconds)
        assert said.votes.get("walking") == (None if vote is None else pytest.approx(vote))
    sideways = weigh_sides(points, going(points, (1.2, 0, 0)), 0.25, 10)
    assert sideways.votes["walking"] == pytest.approx(0.0)


def test_who_walks_backwards_is_not_turned_round():
    points = standing(**BENT_KNEES)
    said = weigh_sides(points, going(points, (0, 0, -1.2)), 0.25, 10)
    assert (said.verdict, said.confidence) == ("agree", 0.5), "the knees say so, and the walk takes sureness"
    with_feet = standing(**BENT_KNEES, **both(toe=(0.1, 0.02, 0.14)))
    assert weigh_sides(with_feet, going(with_feet, (0, 0, -1.2)), 0.25, 10).confidence == 0.9


def test_without_feet_or_a_walk_no_verdict_is_sure():
    for limbs in (BENT_KNEES, HANGING_ARMS, {}):
        points = standing(**limbs)
        assert weigh_sides(points, points, 0.25, 60.0).confidence <= 0.5


def test_a_walk_alone_is_no_verdict():
    points = standing()
    assert weigh_sides(points, going(points, (0, 0, 1.2)), 0.25, 60.0).verdict == "unknown"


def test_feet_that_point_at_the_ground_say_nothing():
    points = standing(**both(ankle=(0.1, 0.1, 0.0), toe=(0.1, 0.0, -0.01)))
    assert weigh_sides(points, points, 0.25, 10.0).votes == {}


def test_feet_that_swing_backwards_in_a_run_cast_no_doubt():
    """Each foot is in the air, its toes behind it, for over half of the stride; the one that is down points ahead."""
    down = np.array([[k < 47, 50 <= k < 97] for k in range(100)])
    points = standing(100)
    for side, x, on_ground in (("left", 0.1, down[:, 0]), ("right", -0.1, down[:, 1])):
        height = np.where(on_ground, 0.1, 0.6)
        points[f"{side}_ankle"] = np.stack([np.full(100, x), height, np.zeros(100)], axis=1)
        points[f"{side}_toe"] = points[f"{side}_ankle"] + np.where(on_ground, 0.15, -0.1)[:, None] * [0, 0, 1]
    assert weigh_sides(points, points, 0.25, 3.0).verdict == "agree"
    assert weigh_sides(swapped(points), points, 0.25, 3.0).verdict == "swapped"


def test_swapping_the_map_turns_the_verdict_round(rng):
    motion = human(rng)
    found = find_roles(motion)
    said, other = check_sides(motion, found), check_sides(motion, swap_sides(found))
    assert (said.verdict, other.verdict) == ("agree", "swapped")
    assert said.confidence == other.confidence > 0.5
    assert other.balance == pytest.approx(-said.balance)


def test_place_turn_size_and_mirror_change_nothing(rng):
    motion = human(rng)
    said = check_sides(motion, find_roles(motion))
    for other in (moved(motion, yaw=2.0, by=(3, 0, -1)), scaled(motion, 1.1), mirrored(motion)):
        told = check_sides(other, find_roles(other))
        assert (told.verdict, told.confidence) == (said.verdict, said.confidence)
        assert told.votes["feet"] == pytest.approx(said.votes["feet"])


def test_arms_on_the_wrong_side_are_told_apart(rng):
    motion = human(rng)
    found = find_roles(motion)
    arms = ("clavicle", "shoulder", "elbow", "wrist")
    crossed = BodyMap(
        tuple(mirror_role(role) if role.split("_")[-1] in arms else role for role in found.roles),
        found.members,
        found.confidence,
    )
    said = check_sides(motion, crossed)
    assert said.crossed
    assert said.verdict == "unknown"
    assert "disagree" in said.reason


def test_pictures_have_no_front(rng):
    table = points_of(human(rng))
    flat = table.replace(positions=table.positions[..., :2], unit="px")
    assert check_sides(flat, find_roles(flat)).verdict == "unknown"


def test_one_frame_is_enough(rng):
    motion = human(rng)[:1]
    assert check_sides(motion, find_roles(motion)).verdict == "agree"


@pytest.mark.data
@pytest.mark.parametrize(
    "file",
    [
        "cmu86/86_01.amc",
        "cmu_bvh/backward-dribble.bvh",
        "bandai_namco/dataset-1_walk-back_normal_001.bvh",
        "bandai_namco/dataset-1_kick_normal_001.bvh",
        "animated_drawings/dab.bvh",
        "perfume_dance/A_test.bvh",
        "pycgm/Movement_trial.c3d",
        "btk/PiG_Motion3_FF.c3d",
        "bmclab/walk.trc",
    ],
)
def test_real_recordings_raise_no_alarm_and_swapped_ones_do(data, file):
    recording = io.read(data / file)
    found = find_roles(recording)
    assert check_sides(recording, found).verdict == "agree"
    assert check_sides(recording, swap_sides(found)).verdict == "swapped"


@pytest.mark.data
def test_left_handed_axes_are_told(data):
    recording = io.read(data / "bmclab" / "walk1.trc")
    said = check_sides(recording, find_roles(recording))
    assert said.verdict == "swapped"
    assert "the foot on the ground points backwards" in said.reason
