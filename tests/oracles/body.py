"""Bodies made by hand: a skeleton of human proportions in random motion, turned, mirrored, taken apart."""

import numpy as np

from leitmotion.motion import Motion, Skeleton, Trajectories, forward_kinematics, rotations

JOINTS = {
    "Hips": ("", (0.0, 0.95, 0.0)),
    "Spine": ("Hips", (0.0, 0.12, 0.0)),
    "Spine1": ("Spine", (0.0, 0.14, -0.01)),
    "Spine2": ("Spine1", (0.0, 0.12, 0.0)),
    "Neck": ("Spine2", (0.0, 0.14, -0.01)),
    "Head": ("Neck", (0.0, 0.10, 0.02)),
    **{
        f"{side}{joint}": (parent if parent in ("Spine2", "Hips") else f"{side}{parent}", (sign * x, y, z))
        for side, sign in (("Left", 1.0), ("Right", -1.0))
        for joint, parent, (x, y, z) in (
            ("Shoulder", "Spine2", (0.05, 0.10, 0.0)),
            ("Arm", "Shoulder", (0.13, 0.0, -0.01)),
            ("ForeArm", "Arm", (0.28, 0.0, 0.0)),
            ("Hand", "ForeArm", (0.25, 0.0, 0.0)),
            ("UpLeg", "Hips", (0.09, -0.04, 0.0)),
            ("Leg", "UpLeg", (0.0, -0.41, 0.0)),
            ("Foot", "Leg", (0.0, -0.41, 0.0)),
            ("ToeBase", "Foot", (0.0, -0.06, 0.14)),
        )
    },
}


def skeleton() -> Skeleton:
    """A person of 1.7 m in MotionBuilder's names, T-pose, facing +Z."""
    names = tuple(JOINTS)
    return Skeleton(
        names,
        [names.index(parent) if parent else -1 for parent, _ in JOINTS.values()],
        [offset for _, offset in JOINTS.values()],
    )


def human(rng, *, frames=60, rate=60.0, bend=0.4) -> Motion:
    """The person moves smoothly: every joint swings about a random axis, the root wanders and turns."""
    body = skeleton()
    time = np.arange(frames)[:, None] / rate
    speed, phase = rng.uniform(0.2, 0.8, len(body)), rng.uniform(0, 2 * np.pi, len(body))
    angle = bend * np.sin(2 * np.pi * speed * time + phase)
    axis = rng.normal(size=(len(body), 3))
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    local = np.concatenate((np.cos(angle / 2)[..., None], np.sin(angle / 2)[..., None] * axis), axis=-1)
    local[:, 0] = rotations.multiply(rotations.yaw_rotation(time[:, 0] * 1.5), local[:, 0])
    positions = np.tile(body.offsets, (frames, 1, 1))
    positions[:, 0] += np.concatenate((time, 0.05 * np.sin(5 * time), -0.5 * time), axis=1)
    return Motion(body, positions, rotations.continuous(local), rate=rate, name="made by hand")


def moved(motion: Motion, *, yaw: float, by) -> Motion:
    """The same motion elsewhere, in another direction."""
    turn = rotations.yaw_rotation(np.full(len(motion), yaw))
    positions, local = motion.local_positions.copy(), motion.local_rotations.copy()
    positions[:, 0] = rotations.rotate(turn, positions[:, 0]) + np.asarray(by)
    local[:, 0] = rotations.multiply(turn, local[:, 0])
    return motion.replace(local_positions=positions, local_rotations=local)


def mirrored(motion: Motion) -> Motion:
    """The motion in a mirror that swaps left and right; the person is symmetric."""
    names = motion.skeleton.names
    swap = [
        names.index(
            name.replace("Left", "Right", 1) if name.startswith("Left") else name.replace("Right", "Left", 1)
        )
        for name in names
    ]
    return motion.replace(
        local_positions=motion.local_positions[:, swap] * [-1.0, 1.0, 1.0],
        local_rotations=motion.local_rotations[:, swap] * [1.0, 1.0, -1.0, -1.0],
    )


def points_of(motion: Motion, **renamed: str) -> Trajectories:
    """The joints of a motion as points without a tree."""
    names = tuple(renamed.get(name, name) for name in motion.skeleton.names)
    return Trajectories(
        names, forward_kinematics(motion).positions, motion.rate, kind="joint", name=motion.name
    )
