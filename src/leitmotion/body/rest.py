"""Rest: how a file turns the trunk, the head and the upper bones, counted from a rest pose that is the body's own.

Conventions
-----------
A file's rotations count from its zero pose, in which no joint is turned. Its axes are its own affair: they may be
those of the bones, and the arms may hang or be held out. Here each link is counted from the axes of the body instead:
the zero pose is looked at as a posture, and the shortest way from there to the rest of the chain is taken out.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from typing import NamedTuple

import numpy as np

from leitmotion.body.body import BodyMap
from leitmotion.motion import Motion, Skeleton, forward_kinematics
from leitmotion.motion.directions import between, from_axes
from leitmotion.motion.rotations import conjugate, multiply, rotate

SYMMETRIC = np.cos(np.radians(15.0))  # a zero pose is a posture where left and right point so much alike
UPRIGHT = np.cos(np.radians(60.0))  # and the thighs so much downwards


LIMBS = {"femur": ("hip", "knee", "ankle"), "humerus": ("shoulder", "elbow", "wrist")}
"""Of each upper bone the joints at its ends, and the end of the bone that hangs on it."""


class Turned(NamedTuple):
    """How the trunk, the head and the upper bones are turned."""

    pelvis: np.ndarray
    """(T, 4) in the world, from the axes of the body."""

    thorax: np.ndarray
    """(T, 4), likewise."""

    head: np.ndarray | None
    """(T, 4), likewise; None where there is none."""

    bends: Mapping[str, np.ndarray]
    """(T, 3) of each upper bone (``left_femur``, …): which way in the world its lower bone bends; of any length."""


def rest_axes(bone: str, side: str) -> tuple[np.ndarray, np.ndarray]:
    """Tell which way a limb's upper bone points at rest, and which way the lower one bends.

    Parameters
    ----------
    bone : {"femur", "humerus"}
        The upper bone.
    side : {"left", "right"}
        Of which side.

    Returns
    -------
    along, bend : (3,) float
        Unit vectors in the axes of the body.
    """
    if bone == "femur":
        return np.array([0.0, -1.0, 0.0]), np.array([0.0, 0.0, -1.0])
    return np.array([1.0 if side == "left" else -1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])


def turned_by_file(motion: Motion, body_map: BodyMap) -> Turned | None:
    """Tell how the rotations of a file turn a body.

    Parameters
    ----------
    motion : Motion
        T frames.
    body_map : BodyMap
        Which joints stand for which role.

    Returns
    -------
    Turned or None
        None where the roles are no single joints, or the zero pose is no posture: not the same on both sides within 15
        degrees, or with thighs that do not point downwards within 60.
    """
    joint = {
        role: motion.skeleton.index(members[0])
        for role, members in zip(body_map.roles, body_map.members, strict=True)
        if len(members) == 1
    }
    sides = [
        f"{side}_{role}" for side, limb in product(("left", "right"), LIMBS.values()) for role in limb[:2]
    ]
    if not {"pelvis", "neck", "head", *sides} <= set(joint):
        return None
    zero = _zero_pose(motion.skeleton)
    place = {role: zero[at] for role, at in joint.items()}
    body = _axes(place)
    if body is None:
        return None
    seen = {}
    for side, (bone, (upper, lower, _)) in product(("left", "right"), LIMBS.items()):
        vector = rotate(conjugate(body), place[f"{side}_{lower}"] - place[f"{side}_{upper}"])
        seen[f"{side}_{bone}"] = vector / (np.linalg.norm(vector) or 1.0)
    if not _is_posture(seen):
        return None
    turned = forward_kinematics(motion).rotations
    bends = {}
    for side, (bone, (upper, _, _)) in product(("left", "right"), LIMBS.items()):
        along, bend = rest_axes(bone, side)
        at_zero = rotate(multiply(body, between(along, seen[f"{side}_{bone}"])), bend)
        bends[f"{side}_{bone}"] = rotate(turned[:, joint[f"{side}_{upper}"]], at_zero)
    pelvis, thorax = (
        _bearer(motion.skeleton, joint[f"left_{role}"], joint[f"right_{role}"])
        for role in ("hip", "shoulder")
    )
    axes = [multiply(turned[:, at], body) for at in (pelvis, thorax, joint["head"])]
    return Turned(axes[0], axes[1], axes[2], bends)


def _zero_pose(skeleton: Skeleton) -> np.ndarray:
    places = np.zeros((len(skeleton), 3))
    for joint, parent in enumerate(skeleton.parents):
        places[joint] = skeleton.offsets[joint] + (places[parent] if parent >= 0 else 0.0)
    return places


def _axes(place: Mapping[str, np.ndarray]) -> np.ndarray | None:
    """Which way the zero pose stands and faces."""
    up = place["neck"] - place["pelvis"]
    left = place["left_hip"] - place["right_hip"] + place["left_shoulder"] - place["right_shoulder"]
    front = np.cross(left, up)
    if not (np.linalg.norm(up) > 0 and np.linalg.norm(front) > 0):
        return None
    up, front = up / np.linalg.norm(up), front / np.linalg.norm(front)
    return from_axes(np.cross(up, front), up, front)


def _is_posture(seen: Mapping[str, np.ndarray]) -> bool:
    alike = all(
        seen[f"left_{bone}"] @ (seen[f"right_{bone}"] * [-1.0, 1.0, 1.0]) > SYMMETRIC
        for bone in ("femur", "humerus")
    )
    return alike and -seen["left_femur"][1] > UPRIGHT


def _bearer(skeleton: Skeleton, left: int, right: int) -> int:
    """Find the joint that bears both sides: the nearest one above both."""
    above = {left}
    while skeleton.parents[left] >= 0:
        left = int(skeleton.parents[left])
        above.add(left)
    while right not in above and skeleton.parents[right] >= 0:
        right = int(skeleton.parents[right])
    return right
