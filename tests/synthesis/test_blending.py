"""Blending: what is joined goes on where the last piece was, and nothing else about it changes."""

import numpy as np
import pytest

from leitmotion.datasets import Action, compose
from leitmotion.motion import Motion, ParameterError, Skeleton, Trajectories, forward_kinematics, joint_points
from leitmotion.motion.rotations import from_axis_angle, geodesic_angle, multiply, rotate, yaw_rotation
from leitmotion.synthesis import Placement, join, placement

RATE = 60.0


@pytest.fixture(scope="module")
def walk() -> Motion:
    """A person who walks, then jumps."""
    return compose([Action("walk", 2), Action("jumping jack", 2)], seed=3, rate=RATE).motion


def moved(motion: Motion, yaw: float, x: float, z: float) -> Motion:
    """The same motion elsewhere, written by hand for a skeleton of one root that is joint 0."""
    turn = yaw_rotation(np.array(yaw))
    positions, rotations = motion.local_positions.copy(), motion.local_rotations.copy()
    positions[:, 0] = rotate(turn, positions[:, 0]) + np.array([x, 0, z])
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    return motion.replace(local_positions=positions, local_rotations=rotations)


def places(motion: Motion) -> np.ndarray:
    return forward_kinematics(motion).positions


def test_overlapping_pieces_of_one_motion_are_that_motion(walk: Motion) -> None:
    joined = join([walk[:100], walk[80:180], walk[150:]], [20, 30])
    assert joined.starts == (0, 80, 150)
    np.testing.assert_allclose(places(joined.recording), places(walk), atol=1e-9)


@pytest.mark.parametrize(("yaw", "x", "z"), [(0.7, 3.0, -2.0), (-3.0, -40.0, 0.1), (np.pi, 0.0, 0.0)])
def test_where_a_piece_was_made_does_not_matter(walk: Motion, yaw: float, x: float, z: float) -> None:
    joined = join([walk[:100], moved(walk[80:], yaw, x, z)], [20])
    np.testing.assert_allclose(places(joined.recording), places(walk), atol=1e-9)


def test_the_same_holds_for_points(walk: Motion) -> None:
    points, elsewhere = joint_points(walk), joint_points(moved(walk, 2.0, 5.0, 5.0))
    joined = join([points[:100], elsewhere[80:]], [20])
    np.testing.assert_allclose(joined.recording.positions, points.positions, atol=1e-9)


def test_a_root_that_never_moves_stays_and_the_body_below_it_is_placed(walk: Motion) -> None:
    bones = walk.skeleton
    held = Skeleton(
        ("stage", *bones.names),
        [-1, *(bones.parents + 1)],
        np.concatenate([[[0.2, 0.0, 0.1]], bones.offsets]),
    )
    still_p = np.broadcast_to([[0.2, 0.0, 0.1]], (len(walk), 1, 3))
    still_q = np.broadcast_to(from_axis_angle("y", 0.4), (len(walk), 1, 4))
    under = Motion(
        held,
        np.concatenate([still_p, walk.local_positions], axis=1),
        np.concatenate([still_q, walk.local_rotations], axis=1),
        RATE,
    )
    seam = join([under[:90], under[150:]], [24]).recording
    np.testing.assert_allclose(seam.local_positions[:, 0], [[0.2, 0.0, 0.1]] * len(seam))
    np.testing.assert_allclose(seam.local_rotations[:, 0], still_q[: len(seam), 0])
    bare = join([walk[:90], walk[150:]], [24]).recording
    start = places(under)[0, 1:]
    turned = rotate(from_axis_angle("y", 0.4), places(bare)) + np.array([0.2, 0.0, 0.1])
    np.testing.assert_allclose(places(seam)[0, 1:], start)
    np.testing.assert_allclose(places(seam)[:, 1:], turned, atol=1e-9)


def test_bones_keep_their_lengths_and_quaternions_go_on_smoothly(walk: Motion) -> None:
    seam = join([walk[:90], moved(walk[150:], 1.0, 4.0, 2.0)], [18]).recording
    np.testing.assert_array_equal(
        seam.local_positions[:, 1:],
        np.broadcast_to(walk.local_positions[0, 1:], seam.local_positions[:, 1:].shape),
    )
    assert np.einsum("tjc,tjc->tj", seam.local_rotations[1:], seam.local_rotations[:-1]).min() > 0.9


def test_outside_of_the_seam_nothing_changes_but_place_and_direction(walk: Motion) -> None:
    seam = join([walk[:90], walk[150:]], [18]).recording
    np.testing.assert_array_equal(seam.local_rotations[:72], walk.local_rotations[:72])
    after = geodesic_angle(seam.local_rotations[90:, 1:], walk.local_rotations[168:, 1:])
    assert after.max() < 1e-6


def test_no_point_moves_faster_in_a_seam_than_its_way_and_the_pieces_allow(walk: Motion) -> None:
    pieces, count = (walk[:90], walk[150:]), 18
    a, b = places(pieces[0][72:]), places(pieces[1][:count])
    to = placement(a, b)
    b = rotate(yaw_rotation(np.array(to.yaw)), b) + np.array([to.x, 0, to.z])
    joined = places(join(pieces, [count]).recording)
    fastest = max(np.linalg.norm(np.diff(places(walk), axis=0), axis=2).max() * RATE, 0.1)
    gap = np.linalg.norm(a - b, axis=2).max()
    speeds = np.linalg.norm(np.diff(joined[71:91], axis=0), axis=2) * RATE
    # the steepest slope of the weights is 1.5 a seam; limbs go along arcs, at most pi / 2 as long as straight lines
    assert speeds.max() <= (np.pi / 2) * (fastest + 1.5 * gap * RATE / count)


@pytest.mark.parametrize("yaw", [-2.5, 0.0, 0.3, 3.1])
def test_placement_finds_a_turn_and_a_shift_exactly(yaw: float) -> None:
    points = np.random.default_rng(5).normal(size=(6, 9, 3))
    elsewhere = rotate(yaw_rotation(np.array(-yaw)), points - [1.0, 0.0, -2.0])
    found = placement(points, elsewhere)
    np.testing.assert_allclose(found, (yaw, 1.0, -2.0), atol=1e-9)


def test_placement_is_the_least_squares_optimum(walk: Motion) -> None:
    from scipy.optimize import minimize

    a, b = places(walk[60:70]), places(walk[200:210]) * [1, -1, 1]  # no point is low in both: all count alike

    def cost(to: np.ndarray) -> float:
        laid = rotate(yaw_rotation(np.array(to[0])), b) + np.array([to[1], 0, to[2]])
        return float(((a - laid)[..., [0, 2]] ** 2).sum())

    best = min(minimize(cost, [yaw, 0, 0]).fun for yaw in (0.0, 2.0, -2.0))
    assert cost(np.array(placement(a, b))) <= best + 1e-9


def test_feet_that_stand_keep_standing() -> None:
    """Two stances of one person: upright, and leaning ahead over the same feet."""
    feet = [[0.1, 0.0, 0.0], [-0.1, 0.0, 0.0]]
    upright = np.array([[*feet, [0.0, 1.0, 0.0], [0.0, 1.7, 0.0]]] * 5)
    leaning = np.array([[*feet, [0.0, 0.9, 0.2], [0.0, 1.4, 0.6]]] * 5)
    to = placement(upright, leaning)
    assert abs(to.z) < 0.1 < np.mean([0.0, 0.0, 0.2, 0.6])


def test_what_is_unseen_in_either_piece_is_unseen_in_the_seam(walk: Motion) -> None:
    positions = joint_points(walk).positions.copy()
    positions[80:100, 3] = np.nan
    points = joint_points(walk).replace(positions=positions, confidence=np.full(positions.shape[:2], 0.5))
    joined = join([points[:100], points[150:]], [20]).recording
    assert np.isnan(joined.positions[80:100, 3]).all()
    assert np.isfinite(joined.positions[100:, 3]).all()
    assert np.isfinite(joined.positions[:, 4]).all()
    np.testing.assert_allclose(joined.confidence, 0.5)


def test_points_of_which_none_is_seen_stay_where_they_are() -> None:
    nothing = Trajectories(("a",), np.full((9, 1, 3), np.nan), rate=10)
    assert placement(nothing.positions, nothing.positions) == Placement(0.0, 0.0, 0.0)
    assert len(join([nothing, nothing], [4]).recording) == 14


def test_a_picture_is_only_shifted_along() -> None:
    way = np.random.default_rng(1).normal(size=(20, 4, 2))
    points = Trajectories(tuple("abcd"), way, rate=10, unit="px")
    joined = join([points[:12], points[4:].replace(positions=way[4:] + np.array([7.0, 0.0]))], [8]).recording
    np.testing.assert_allclose(joined.positions, way, atol=1e-12)


@pytest.mark.parametrize(
    ("pieces", "seams", "complaint"),
    [
        ([], [], "one seam fewer"),
        (["a", "a"], [], "one seam fewer"),
        (["a", "b"], [2], "one skeleton"),
        (["a", "slow"], [2], "one rate"),
        (["a", "a"], [11], "must fit"),
        (["a", "a", "a"], [6, 6], "must fit"),
        (["a", "a"], [-1], "must fit"),
    ],
)
def test_what_cannot_be_joined_is_refused(pieces: list[str], seams: list[int], complaint: str) -> None:
    of = {
        "a": Trajectories(("hip",), np.zeros((10, 1, 3)), rate=10),
        "b": Trajectories(("toe",), np.zeros((10, 1, 3)), rate=10),
        "slow": Trajectories(("hip",), np.zeros((10, 1, 3)), rate=5),
    }
    with pytest.raises(ParameterError, match=complaint):
        join([of[name] for name in pieces], seams)
