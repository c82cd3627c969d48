"""Bodies made by hand: a person of human proportions in smooth motion, turned, mirrored, taken apart."""

import numpy as np

from leitmotion.motion import Motion, Skeleton, Trajectories, forward_kinematics, rotations

LIMBS = (
    ("Shoulder", "Spine2", (0.05, 0.10, 0.0)),
    ("Arm", "Shoulder", (0.13, 0.0, -0.01)),
    ("ForeArm", "Arm", (0.28, 0.0, 0.0)),
    ("Hand", "ForeArm", (0.25, 0.0, 0.0)),
    ("UpLeg", "Hips", (0.09, -0.04, 0.0)),
    ("Leg", "UpLeg", (0.0, -0.41, 0.0)),
    ("Foot", "Leg", (0.0, -0.41, 0.0)),
    ("ToeBase", "Foot", (0.0, -0.06, 0.14)),
)
TRUNK = (
    ("Hips", "", (0.0, 0.95, 0.0)),
    ("Spine", "Hips", (0.0, 0.12, 0.0)),
    ("Spine1", "Spine", (0.0, 0.14, -0.01)),
    ("Spine2", "Spine1", (0.0, 0.12, 0.0)),
    ("Neck", "Spine2", (0.0, 0.14, -0.01)),
    ("Head", "Neck", (0.0, 0.10, 0.02)),
)


def skeleton() -> Skeleton:
    """A person of 1.7 m under MotionBuilder's names, in T-pose, facing +Z."""
    joints = list(TRUNK)
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        for joint, parent, (x, y, z) in LIMBS:
            hangs_on = parent if parent in ("Spine2", "Hips") else side + parent
            joints.append((side + joint, hangs_on, (sign * x, y, z)))
    names = tuple(name for name, _, _ in joints)
    parents = [names.index(parent) if parent else -1 for _, parent, _ in joints]
    return Skeleton(names, parents, [offset for _, _, offset in joints])


def human(rng, *, frames=60, rate=60.0, bend=0.4) -> Motion:
    """The person moves smoothly: every joint swings about an axis of its own, the root wanders and turns."""
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


def stiff(root: np.ndarray, *, rate=60.0) -> Motion:
    """The person in T-pose, turned as a whole by the root's quaternions, (T, 4)."""
    body = skeleton()
    local = np.tile(rotations.IDENTITY, (len(root), len(body), 1))
    local[:, 0] = root
    return Motion(body, np.tile(body.offsets, (len(root), 1, 1)), local, rate=rate)


def moved(motion: Motion, *, yaw: float, by) -> Motion:
    """The same motion elsewhere, in another direction."""
    turn = rotations.yaw_rotation(np.full(len(motion), yaw))
    positions, local = motion.local_positions.copy(), motion.local_rotations.copy()
    positions[:, 0] = rotations.rotate(turn, positions[:, 0]) + np.asarray(by)
    local[:, 0] = rotations.multiply(turn, local[:, 0])
    return motion.replace(local_positions=positions, local_rotations=local)


def scaled(motion: Motion, factor: float) -> Motion:
    """The same motion of a body that is larger by a factor."""
    return motion.replace(
        skeleton=motion.skeleton.replace(offsets=motion.skeleton.offsets * factor),
        local_positions=motion.local_positions * factor,
    )


def stretched(motion: Motion, factors: dict[str, float]) -> Motion:
    """The same motion of a body in which the bones that end in these joints, on both sides, are longer by a factor."""
    by = np.array(
        [factors.get(name.removeprefix("Left").removeprefix("Right"), 1.0) for name in motion.skeleton.names]
    )
    return motion.replace(
        skeleton=motion.skeleton.replace(offsets=motion.skeleton.offsets * by[:, None]),
        local_positions=motion.local_positions * by[:, None],
    )


def mirrored(motion: Motion) -> Motion:
    """The motion in a mirror that swaps left and right; the person is symmetric."""
    names = motion.skeleton.names
    swap = [names.index(other_side(name)) for name in names]
    return motion.replace(
        local_positions=motion.local_positions[:, swap] * [-1.0, 1.0, 1.0],
        local_rotations=motion.local_rotations[:, swap] * [1.0, 1.0, -1.0, -1.0],
    )


def other_side(name: str) -> str:
    """LeftArm for RightArm and back; Hips for Hips."""
    return {"Left": "Right", "Righ": "Left"}.get(name[:4], name[:4]) + name[4 + name.startswith("Right") :]


def without(motion: Motion, joint: str) -> Motion:
    """The same motion of a skeleton that lacks one inner joint: its children hang on its parent."""
    body = motion.skeleton
    pose = forward_kinematics(motion)
    kept = [j for j, name in enumerate(body.names) if name != joint]
    gone = body.index(joint)
    parents = [int(body.parents[gone]) if body.parents[j] == gone else int(body.parents[j]) for j in kept]
    local_p, local_q = pose.positions[:, kept].copy(), pose.rotations[:, kept].copy()
    offsets = body.offsets[kept].copy()
    for place, (j, parent) in enumerate(zip(kept, parents, strict=True)):
        if parent >= 0:
            back = rotations.conjugate(pose.rotations[:, parent])
            local_p[:, place] = rotations.rotate(back, pose.positions[:, j] - pose.positions[:, parent])
            local_q[:, place] = rotations.multiply(back, pose.rotations[:, j])
            if body.parents[j] == gone:
                offsets[place] += body.offsets[gone]
    smaller = Skeleton(
        tuple(body.names[j] for j in kept), [kept.index(p) if p >= 0 else -1 for p in parents], offsets
    )
    return Motion(smaller, local_p, local_q, motion.rate)


def renamed(motion: Motion, names: dict[str, str]) -> Motion:
    """The same motion under other names; what `names` lacks keeps its own."""
    new = tuple(names.get(name, name) for name in motion.skeleton.names)
    return motion.replace(skeleton=motion.skeleton.replace(names=new))


def points_of(motion: Motion, names: dict[str, str] | None = None, *, kind="joint") -> Trajectories:
    """The joints as points without a tree; with `names`, only those, renamed."""
    positions = forward_kinematics(motion).positions
    if names is None:
        return Trajectories(motion.skeleton.names, positions, motion.rate, kind=kind)
    chosen = [motion.skeleton.index(name) for name in names]
    return Trajectories(tuple(names.values()), positions[:, chosen], motion.rate, kind=kind)
