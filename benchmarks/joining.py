"""How clips of one skeleton are joined: put where the last one ends, led over to, performed at another speed."""

from __future__ import annotations

import numpy as np

from leitmotion.motion import Motion, forward_kinematics, rotations

FADES = 0.1
"""Seconds in which the movement at a clip's end dies away within the blend."""


def rooted(motion: Motion) -> Motion:
    """Let the joint that carries both legs stand in the world itself, whatever helper nodes are above it."""
    pelvis = _root(motion)
    if pelvis == 0:
        return motion
    pose = forward_kinematics(motion)
    positions, turns = motion.local_positions.copy(), motion.local_rotations.copy()
    positions[:, :pelvis], turns[:, :pelvis] = 0.0, (1.0, 0.0, 0.0, 0.0)
    positions[:, pelvis], turns[:, pelvis] = pose.positions[:, pelvis], pose.rotations[:, pelvis]
    return motion.replace(local_positions=positions, local_rotations=rotations.continuous(turns))


def placed(clip: Motion, before: Motion, frames: int) -> Motion:
    """Put a clip where the person is after a blend of so many frames, facing as they face."""
    root = _root(clip)
    turn = _yaw(before.local_rotations[-1, root], clip.local_rotations[0, root])
    positions, turns = clip.local_positions.copy(), clip.local_rotations.copy()
    positions[:, root] = rotations.rotate(turn, positions[:, root])
    turns[:, root] = rotations.multiply(turn, turns[:, root])
    speed = (_velocity(before.local_positions)[1][root] + _velocity(positions)[0][root]) / 2
    goal = before.local_positions[-1, root] + (frames + 1) * speed
    positions[:, root] += (goal - positions[0, root]) * (1, 0, 1)
    return clip.replace(local_positions=positions, local_rotations=rotations.continuous(turns))


def blended(before: Motion, after: Motion, frames: int) -> Motion:
    """Lead over from one clip to the next.

    Each goes on beyond its end at the speed it has there, which dies away in a tenth of a second; the root keeps its
    speed over the floor. The blend passes from the one to the other, so that position and speed are continuous.
    """
    root = _root(before)
    steps = np.arange(1, frames + 1)[:, None, None]
    share = steps / (frames + 1)
    share = share * share * (3 - 2 * share)
    fade = FADES * before.rate
    onward, back = (fade * -np.expm1(-s / fade) for s in (steps, frames + 1 - steps))

    (_, leaving), (arriving, _) = _velocity(before.local_positions), _velocity(after.local_positions)
    past, coming = onward * leaving, -back * arriving
    floor = np.array([1.0, 0.0, 1.0])
    past[:, root] += (steps[:, 0] - onward[:, 0]) * leaving[root] * floor
    coming[:, root] -= (frames + 1 - steps[:, 0] - back[:, 0]) * arriving[root] * floor
    positions = (1 - share) * (before.local_positions[-1] + past) + share * (
        after.local_positions[0] + coming
    )

    # rotation vectors from the last posture on: where slerp would change sides half-way, they go on
    last, first = before.local_rotations[-1], after.local_rotations[0]
    past = onward * _turning(before.local_rotations[-2], last)
    coming = _turning(last, first) - back * _turning(first, after.local_rotations[1])
    turns = rotations.multiply(rotations.from_rotation_vector((1 - share) * past + share * coming), last)
    return before.replace(local_positions=positions, local_rotations=rotations.normalize(turns))


def warped(clip: Motion, rng: np.random.Generator, *, slowest: float = 0.85, fastest: float = 1.15) -> Motion:
    """Perform a clip at a speed that varies smoothly within bounds."""
    ends = rng.uniform(slowest, fastest, size=3)
    place = np.linspace(0, 2, 512)
    share = place % 1
    share = share * share * (3 - 2 * share)
    left = np.minimum(place.astype(int), 1)
    share[-1] = 1.0
    speed = (1 - share) * ends[left] + share * ends[left + 1]
    passed = np.concatenate(([0], np.cumsum(2 / (speed[1:] + speed[:-1]))))  # time at each place of the clip
    frames = max(2, round(passed[-1] / (len(place) - 1) * (len(clip) - 1)) + 1)
    moments = np.interp(np.linspace(0, passed[-1], frames), passed, place / 2 * (len(clip) - 1))
    first = np.minimum(moments.astype(int), len(clip) - 2)
    share = (moments - first)[:, None, None]
    positions = (1 - share) * clip.local_positions[first] + share * clip.local_positions[first + 1]
    turns = rotations.slerp(clip.local_rotations[first], clip.local_rotations[first + 1], share[..., 0])
    return clip.replace(local_positions=positions, local_rotations=rotations.continuous(turns))


def _root(motion: Motion) -> int:
    """The joint by which the person moves through the world: that of :func:`rooted`."""
    joint = 0
    while np.count_nonzero(motion.skeleton.parents == joint) == 1:
        joint = int(np.flatnonzero(motion.skeleton.parents == joint)[0])
    return joint


def _yaw(to: np.ndarray, of: np.ndarray) -> np.ndarray:
    """The turn about the vertical that brings one orientation nearest to another."""
    between = rotations.multiply(to, rotations.conjugate(of))
    return rotations.normalize(between * (1.0, 0.0, 1.0, 0.0))


def _velocity(positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Metres a frame, at the first and at the last frame."""
    return positions[1] - positions[0], positions[-1] - positions[-2]


def _turning(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Rotation vector from one frame to the next, in the parent's frame."""
    turn = rotations.multiply(second, rotations.conjugate(first))
    turn = np.where(turn[..., :1] < 0, -turn, turn)
    size = np.linalg.norm(turn[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(size, turn[..., :1])
    return np.where(size > 1e-9, turn[..., 1:] / np.maximum(size, 1e-9), 0.0) * angle
