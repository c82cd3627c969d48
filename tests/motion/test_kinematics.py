"""Forward kinematics: the textbook's matrices as twin, and the laws."""

import numpy as np
import pytest

from leitmotion.motion import (
    Motion,
    Skeleton,
    end_site_positions,
    forward_kinematics,
    joint_points,
    rotations,
)
from leitmotion.motion.kinematics import CHUNK
from oracles.kinematics import global_pose


def random_motion(rng, frames=7, joints=8, roots=1):
    parents = np.array([-1] * roots + [int(rng.integers(0, k)) for k in range(roots, joints)])
    skeleton = Skeleton(
        tuple(f"j{k}" for k in range(joints)),
        parents,
        rng.normal(size=(joints, 3)),
        [joints - 1, 0],
        rng.normal(size=(2, 3)),
    )
    quaternions = rotations.normalize(rng.normal(size=(frames, joints, 4)))
    return Motion(skeleton, rng.normal(size=(frames, joints, 3)), quaternions, 120)


@pytest.mark.parametrize("roots", [1, 2])
@pytest.mark.parametrize("frames", [1, 7, CHUNK + 3])
def test_poses_are_those_of_the_matrices(rng, frames, roots):
    motion = random_motion(rng, frames, roots=roots)
    pose = forward_kinematics(motion)
    some = slice(max(0, frames - 9), frames)  # across the border of a chunk
    positions, matrices = global_pose(
        motion.skeleton.parents, motion.local_positions[some], motion.local_rotations[some]
    )
    np.testing.assert_allclose(pose.positions[some], positions, atol=1e-12)
    np.testing.assert_allclose(rotations.as_matrix(pose.rotations[some]), matrices, atol=1e-12)
    assert pose.positions.shape == (frames, 8, 3)


def test_bones_keep_their_length(rng):
    motion = random_motion(rng)
    positions = forward_kinematics(motion).positions
    parents = motion.skeleton.parents
    lengths = np.linalg.norm(positions[:, 1:] - positions[:, parents[1:]], axis=-1)
    np.testing.assert_allclose(lengths, np.linalg.norm(motion.local_positions[:, 1:], axis=-1))


def test_turning_and_moving_the_root_turns_and_moves_everything(rng):
    motion = random_motion(rng)
    turn, shift = rotations.normalize(rng.normal(size=4)), rng.normal(size=3)
    positions, quaternions = np.array(motion.local_positions), np.array(motion.local_rotations)
    positions[:, 0] = rotations.rotate(turn, positions[:, 0]) + shift
    quaternions[:, 0] = rotations.multiply(turn, quaternions[:, 0])
    moved = forward_kinematics(motion.replace(local_positions=positions, local_rotations=quaternions))
    still = forward_kinematics(motion)
    np.testing.assert_allclose(moved.positions, rotations.rotate(turn, still.positions) + shift, atol=1e-12)
    np.testing.assert_allclose(moved.rotations, rotations.multiply(turn, still.rotations), atol=1e-12)


def test_a_batch_is_its_frames_one_by_one(rng):
    motion = random_motion(rng)
    whole = forward_kinematics(motion)
    for t in range(len(motion)):
        np.testing.assert_array_equal(forward_kinematics(motion[t : t + 1]).positions[0], whole.positions[t])


def test_the_rest_pose_adds_the_offsets(rng):
    motion = random_motion(rng, 1)
    skeleton = motion.skeleton
    still = Motion(skeleton, skeleton.offsets[None], np.tile(rotations.IDENTITY, (1, 8, 1)), 1)
    expected = np.array(skeleton.offsets)
    for j, parent in enumerate(skeleton.parents):
        if parent >= 0:
            expected[j] += expected[parent]
    np.testing.assert_allclose(forward_kinematics(still).positions[0], expected)


def test_end_sites_are_joints_that_do_not_turn(rng):
    motion = random_motion(rng)
    skeleton = motion.skeleton
    ends = end_site_positions(motion, forward_kinematics(motion))
    longer = Skeleton(
        (*skeleton.names, "end 1", "end 2"),
        [*skeleton.parents, *skeleton.end_parents],
        np.vstack([skeleton.offsets, skeleton.end_offsets]),
    )
    frames = len(motion)
    positions = np.concatenate(
        [motion.local_positions, np.tile(skeleton.end_offsets, (frames, 1, 1))], axis=1
    )
    quaternions = np.concatenate(
        [motion.local_rotations, np.tile(rotations.IDENTITY, (frames, 2, 1))], axis=1
    )
    expected = forward_kinematics(Motion(longer, positions, quaternions, 120)).positions[:, -2:]
    np.testing.assert_allclose(ends, expected, atol=1e-12)


def test_joints_as_points_stand_where_the_pose_places_them(rng):
    motion = random_motion(rng)
    points = joint_points(motion)
    assert (points.names, points.kind, points.rate, points.unit) == (motion.skeleton.names, "joint", 120, "m")
    np.testing.assert_array_equal(points.positions, forward_kinematics(motion).positions)
