"""Forward kinematics: from local to global, a loop over joints, never over frames."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.motion.motion import Motion
from leitmotion.motion.trajectories import Trajectories

CHUNK = 2048  # frames at a time, so that the components of a parent stay in cache


class GlobalPose(NamedTuple):
    """Where every joint is and how it is turned, in the world."""

    positions: np.ndarray
    """Global positions, (T, J, 3), metres."""

    rotations: np.ndarray
    """Global unit quaternions, (T, J, 4)."""


def forward_kinematics(motion: Motion) -> GlobalPose:
    """Place every joint in the world.

    ``p_j = p_parent + q_parent * t_j`` and ``q_j = q_parent q_local``, parents before children.

    Parameters
    ----------
    motion : Motion
        T frames of J joints.

    Returns
    -------
    GlobalPose
        ``positions`` (T, J, 3) in metres and ``rotations`` (T, J, 4).

    Examples
    --------
    >>> from leitmotion.motion import Motion, Skeleton, rotations
    >>> arm = Skeleton(("shoulder", "elbow"), [-1, 0], [[0, 1.4, 0], [0.3, 0, 0]])
    >>> up = np.stack([rotations.from_axis_angle("z", [np.pi / 2]), rotations.from_axis_angle("z", [0.0])], 1)
    >>> forward_kinematics(Motion(arm, arm.offsets[None], up, rate=1)).positions[0, 1].round(6)
    array([0. , 1.7, 0. ])
    """
    frames, joints = motion.local_positions.shape[:2]
    positions = np.empty((frames, joints, 3))
    rotations = np.empty((frames, joints, 4))
    parents = motion.skeleton.parents
    for start in range(0, frames, CHUNK):
        chunk = slice(start, start + CHUNK)
        _chain(
            parents,
            motion.local_positions[chunk],
            motion.local_rotations[chunk],
            positions[chunk],
            rotations[chunk],
        )
    return GlobalPose(positions, rotations)


def end_site_positions(motion: Motion, pose: GlobalPose) -> np.ndarray:
    """Place the end sites (finger tips, toe tips, top of the head) in the world.

    Parameters
    ----------
    motion : Motion
        Whose skeleton has K end sites.
    pose : GlobalPose
        The same motion's global pose.

    Returns
    -------
    (T, K, 3) float
        Metres.
    """
    from leitmotion.motion.rotations import rotate

    on = motion.skeleton.end_parents
    return pose.positions[:, on] + rotate(pose.rotations[:, on], motion.skeleton.end_offsets)


def joint_points(motion: Motion) -> Trajectories:
    """Give the joints of a skeleton as points in the world, for what holds no skeleton.

    Parameters
    ----------
    motion : Motion
        T frames of J joints.

    Returns
    -------
    Trajectories
        J points of kind "joint" under the joints' names, in metres.

    Examples
    --------
    >>> from leitmotion.motion import Motion, Skeleton
    >>> arm = Skeleton(("shoulder", "elbow"), [-1, 0], [[0, 1.4, 0], [0.3, 0, 0]])
    >>> still = Motion(arm, arm.offsets[None], [[[1.0, 0, 0, 0], [1.0, 0, 0, 0]]], rate=1)
    >>> joint_points(still).positions[0, 1]
    array([0.3, 1.4, 0. ])
    """
    positions = forward_kinematics(motion).positions
    return Trajectories(motion.skeleton.names, positions, motion.rate, kind="joint", name=motion.name)


def _chain(
    parents: np.ndarray, local_p: np.ndarray, local_q: np.ndarray, out_p: np.ndarray, out_q: np.ndarray
) -> None:
    p_of: list[tuple[np.ndarray, ...]] = []
    q_of: list[tuple[np.ndarray, ...]] = []
    local_p = np.ascontiguousarray(local_p.transpose(1, 2, 0))  # (J, 3, T): each component contiguous in time
    local_q = np.ascontiguousarray(local_q.transpose(1, 2, 0))
    for j, parent in enumerate(parents):
        tx, ty, tz = local_p[j]
        bw, bx, by, bz = local_q[j]
        if parent < 0:
            p_of.append((tx, ty, tz))
            q_of.append((bw, bx, by, bz))
        else:
            px, py, pz = p_of[parent]
            aw, ax, ay, az = q_of[parent]
            cx = 2.0 * (ay * tz - az * ty)
            cy = 2.0 * (az * tx - ax * tz)
            cz = 2.0 * (ax * ty - ay * tx)
            p_of.append(
                (
                    px + tx + aw * cx + ay * cz - az * cy,
                    py + ty + aw * cy + az * cx - ax * cz,
                    pz + tz + aw * cz + ax * cy - ay * cx,
                )
            )
            q_of.append(
                (
                    aw * bw - ax * bx - ay * by - az * bz,
                    aw * bx + ax * bw + ay * bz - az * by,
                    aw * by - ax * bz + ay * bw + az * bx,
                    aw * bz + ax * by - ay * bx + az * bw,
                )
            )
        for k in range(3):
            out_p[:, j, k] = p_of[j][k]
        for k in range(4):
            out_q[:, j, k] = q_of[j][k]
