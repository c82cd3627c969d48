"""A posture as the angles of its joints, all of them, and the body that takes it, borne by what touches the floor.

Unlike :mod:`leitmotion.datasets._posing`, where feet are placed and legs follow, nothing here is solved for: a posture
is 35 numbers, its mirror image is known exactly, and between two postures every number may be interpolated.

Conventions
-----------
Radians. Pitch leans forward, positive yaw turns to the person's left, positive roll raises the left side; trunk and
head are seen from what bears them. Flexion brings arm and leg forward, abduction and spread bring them outward, elbow
and knee bend, the wrist bends as the elbow does, the ankle points the foot. The lift is a height above the floor, in
body heights; hands is 1 where the body stands on its hands as well as on its feet, and 0 where not.
"""

from __future__ import annotations

import numpy as np

from leitmotion.datasets._posing import _arm, _reflect, as_motion
from leitmotion.motion import Motion, Skeleton, rotations
from leitmotion.motion.kinematics import end_site_positions, forward_kinematics
from leitmotion.motion.rotations import from_axis_angle, from_euler

AXIS = tuple(f"{part}_{turn}" for part in ("pelvis", "trunk", "head") for turn in ("yaw", "pitch", "roll"))
SIDE = (
    "flexion", "abduction", "outward", "elbow", "shrug", "wrist",
    "hip", "spread", "turn", "knee", "ankle", "toes",
)  # fmt: skip
ANGLES = (*AXIS, *(f"left_{name}" for name in SIDE), *(f"right_{name}" for name in SIDE), "lift", "hands")
STANDING = {"flexion": 0.04, "abduction": 0.13, "elbow": 0.20, "hip": 0.05, "knee": 0.08, "turn": 0.10}
CONTACT = 0.012  # body heights: how far above the floor a point bears little of the body
_NUMBER = {name: k for k, name in enumerate(ANGLES)}
_SWAPPED = np.array(
    [
        _NUMBER[
            name.replace("left_", "right_") if name.startswith("left_") else name.replace("right_", "left_")
        ]
        for name in ANGLES
    ]
)
_SIGNS = np.array([-1.0 if name in AXIS and not name.endswith("pitch") else 1.0 for name in ANGLES])


def posture(**angles: float) -> np.ndarray:
    """Make a posture (35,): standing at ease but for these angles; one without a side is of both sides.

    Where no ankle is given, the sole is kept level.
    """
    made = np.zeros(len(ANGLES))
    for name, angle in {**STANDING, **angles}.items():
        for column in [name] if name in _NUMBER else [f"left_{name}", f"right_{name}"]:
            made[_NUMBER[column]] = angle
    for side in ("left", "right"):
        if not {"ankle", f"{side}_ankle"} & set(angles):
            hip, knee = made[_NUMBER[f"{side}_hip"]], made[_NUMBER[f"{side}_knee"]]
            made[_NUMBER[f"{side}_ankle"]] = hip - knee - made[_NUMBER["pelvis_pitch"]]
    return made


def mirrored(postures: np.ndarray) -> np.ndarray:
    """Exchange left and right of postures (..., 35)."""
    image: np.ndarray = postures[..., _SWAPPED] * _SIGNS
    return image


def on_hands(skeleton: Skeleton, local_rotations: np.ndarray, hands: np.ndarray) -> np.ndarray:
    """Lean the pelvis so that hands and feet come to one height, where the body stands on both (T,)."""
    hips = np.zeros((len(hands), 3))
    hung = as_motion(skeleton, hips, local_rotations, rate=1.0, name="")
    pose = forward_kinematics(hung)
    points = np.concatenate((pose.positions, end_site_positions(hung, pose)), axis=1)
    names = [*skeleton.names, *(skeleton.names[parent] for parent in skeleton.end_parents)]
    hand, foot = (
        _lowest(points[:, [name.endswith(ends) for name in names]])
        for ends in (("Hand",), ("Foot", "ToeBase"))
    )
    lean = np.arctan2(hand[:, 1] - foot[:, 1], np.maximum(hand[:, 2] - foot[:, 2], 0.2))
    leant = local_rotations.copy()
    turn = from_axis_angle("x", np.clip(hands, 0.0, 1.0) * lean)
    leant[:, 0] = rotations.multiply(turn, local_rotations[:, 0])
    return leant


def _lowest(points: np.ndarray) -> np.ndarray:
    """The mean of points (T, P, 3), the lowest counting most (T, 3)."""
    low = points[..., 1].min(axis=1, keepdims=True)
    share = np.exp(-(points[..., 1] - low) / 0.02)[..., None]
    mean: np.ndarray = (share * points).sum(axis=1) / share.sum(axis=1)
    return mean


def rotations_of(skeleton: Skeleton, postures: np.ndarray) -> np.ndarray:
    """Turn the joints so that the body takes the postures (T, 35): local rotations (T, J, 4)."""
    q = np.tile(rotations.IDENTITY, (len(postures), len(skeleton), 1))
    pelvis, trunk, head = (from_euler("yxz", postures[:, k : k + 3]) for k in (0, 3, 6))
    half_trunk, half_head = (rotations.slerp(rotations.IDENTITY, each, 0.5) for each in (trunk, head))
    for joint, rotation in (
        ("Hips", pelvis), ("Spine", half_trunk), ("Chest", half_trunk), ("Neck", half_head), ("Head", half_head),
    ):  # fmt: skip
        q[:, skeleton.index(joint)] = rotation
    for side in ("Left", "Right"):
        first = _NUMBER[f"{side.lower()}_{SIDE[0]}"]
        angle = dict(zip(SIDE, postures[:, first : first + len(SIDE)].T, strict=True))
        clavicle, arm, forearm = _arm(np.stack([angle[name] for name in SIDE[:5]], axis=-1))
        thigh = from_euler("xzy", np.stack((-angle["hip"], angle["spread"], angle["turn"]), axis=-1))
        turns = {
            "Shoulder": clavicle, "Arm": arm, "ForeArm": forearm, "Hand": from_axis_angle("y", -angle["wrist"]),
            "UpLeg": thigh, "Leg": from_axis_angle("x", angle["knee"]),
            "Foot": from_axis_angle("x", angle["ankle"]), "ToeBase": from_axis_angle("x", -angle["toes"]),
        }  # fmt: skip
        for joint, rotation in turns.items():
            q[:, skeleton.index(side + joint)] = rotation if side == "Left" else _reflect(rotation)
    return q


def embodied(
    skeleton: Skeleton,
    local_rotations: np.ndarray,
    lift: np.ndarray,
    *,
    rate: float,
    name: str,
    afloat: float,
) -> Motion:
    """Let the body be borne by what touches the floor, or, `afloat` (m/s, more than 0), glide at that speed.

    What bears the body does not slide: as the points near the floor move against the pelvis, so the pelvis moves
    against the floor.

    Parameters
    ----------
    skeleton : Skeleton
        J joints.
    local_rotations : (T, J, 4) float
        Of every joint.
    lift : (T,) float
        Metres above the floor, or above the water's.
    rate : float
        Frames per second.
    name : str
        What the recording is called.
    afloat : float
        Speed of a swimmer, m/s.

    Returns
    -------
    Motion
        The body in motion.
    """
    hips = np.zeros((len(lift), 3))
    hung = as_motion(skeleton, hips, local_rotations, rate=rate, name=name)
    pose = forward_kinematics(hung)
    points = np.concatenate((pose.positions, end_site_positions(hung, pose)), axis=1)
    if afloat:
        hips[:, 1], hips[:, 2] = 1.0 + lift, afloat * np.arange(len(lift)) / rate
    else:
        low = points[..., 1].min(axis=1)
        near = np.exp(-(points[..., 1] - low[:, None]) / (CONTACT * 1.75))
        bears = np.minimum(near[1:], near[:-1])[..., None]
        steps = (bears * np.diff(points[..., [0, 2]], axis=0)).sum(axis=1) / bears.sum(axis=1)
        hips[1:, [0, 2]] = -np.cumsum(steps, axis=0)
        hips[:, 1] = lift - low
    return as_motion(skeleton, hips, local_rotations, rate=rate, name=name)
