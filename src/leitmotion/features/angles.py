"""Joint angles: which way each bone points, seen from the bone that it hangs on; told by places alone.

Conventions
-----------
A direction is a unit vector. Of two directions the distance of their vectors is 2 sin(angle / 2), so the angle in
radians, to 5 % up to 60 degrees; it never wraps around and has no pole. Frames have +X to the person's left, +Y up the
trunk, +Z to the front:

- the *pelvis'* frame is spanned by the trunk (pelvis to neck) and the line of the hips, the *chest's* by the trunk and
  the line of the shoulders;
- the frame of an upper arm is the chest's, of a thigh the pelvis', turned the shortest way that brings a direction of
  rest onto the bone. The shortest way is undefined only where the bone points against its rest. Rest is therefore down,
  to the front and outwards: no arm or leg points up, to the back and inwards.
"""

from __future__ import annotations

import numpy as np

from leitmotion.body import Body
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import DataError
from leitmotion.motion.errors import in_short

LIMBS = (("shoulder", "elbow", "wrist"), ("hip", "knee", "ankle"))
REST = np.array([1.0, -1.0, 1.0]) / np.sqrt(3.0)  # of the left side


def joint_angles(body: Body) -> FeatureSequence:
    """Describe each frame by the angles between the bones, whatever the place, yaw, size and proportions of the body.

    Joint angles are what the authors of paper P name as a better feature than places. These are computed from the
    places of the joints, so any recording has them, with rotations or without.

    ============================ ==========================================================================
    name                         direction, and the frame in which it is seen
    ============================ ==========================================================================
    pelvis                       the vertical, seen from the pelvis: how the trunk leans
    chest                        the line of the shoulders, seen from the pelvis: how the trunk is twisted
    neck                         neck to head, seen from the chest
    left_shoulder, …             upper arm, seen from the chest: flexion and abduction
    left_elbow, …                forearm, seen from the upper arm: flexion, and the twist of the upper arm
    left_hip, …                  thigh, seen from the pelvis
    left_knee, …                 shank, seen from the thigh
    ============================ ==========================================================================

    Parameters
    ----------
    body : Body
        T frames in three dimensions, with the roles that the angles need.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 3 R), ``width`` 3, ``unit`` "rad", those angles of the list whose joints the body has; NaN where
        a joint was unseen or two coincide. Invariant to place, yaw, body size, unit and the lengths of the bones whose
        directions these are.

    Raises
    ------
    DataError
        When the recording is planar, or the body lacks the pelvis, the neck, or both the hips and the shoulders.

    Examples
    --------
    >>> names = ("pelvis", "neck", "left_shoulder", "right_shoulder", "left_elbow", "left_wrist")
    >>> bent = [[0, 1, 0], [0, 1.5, 0], [0.2, 1.5, 0], [-0.2, 1.5, 0], [0.5, 1.5, 0], [0.5, 1.5, 0.25]]
    >>> told = joint_angles(Body(names, [bent], facing=[0.0], rate=30, size=1.5))
    >>> dict(zip(told.names, told.values.reshape(-1, 3).round(2).tolist()))["left_shoulder"]
    [1.0, 0.0, 0.0]
    """
    if body.positions.shape[2] != 3:
        raise DataError("Joint angles need joints in three dimensions, got two.")
    at = {role: body.positions[:, k] for k, role in enumerate(body.roles)}
    pelvis, chest = _frames(at)
    told = {"pelvis": _within(pelvis, np.broadcast_to([0.0, 1.0, 0.0], (len(body), 3)))}
    if {"left_shoulder", "right_shoulder"} <= set(at):
        told["chest"] = _within(pelvis, at["left_shoulder"] - at["right_shoulder"])
    if "head" in at:
        told["neck"] = _within(chest, at["head"] - at["neck"])
    for (upper, middle, lower), frame in zip(LIMBS, (chest, pelvis), strict=True):
        for side, rest in (("left", REST), ("right", REST * [-1.0, 1.0, 1.0])):
            first, second, third = (f"{side}_{joint}" for joint in (upper, middle, lower))
            if first in at and second in at:
                bone = told[first] = _within(frame, at[second] - at[first])
                if third in at:
                    told[second] = _turned_back(_within(frame, at[third] - at[second]), bone, rest)
    return FeatureSequence(
        values=np.concatenate(list(told.values()), axis=1),
        names=tuple(told),
        rate=body.rate,
        invariant_to=("place", "yaw", "body_size", "unit", "bone_lengths"),
        width=3,
        unit="rad",
    )


def _frames(at: dict[str, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Frames of pelvis and chest, (T, 3, 3) with the axes as rows."""
    lines = {
        joint: at[f"left_{joint}"] - at[f"right_{joint}"]
        for joint in ("hip", "shoulder")
        if {f"left_{joint}", f"right_{joint}"} <= set(at)
    }
    missing = [role for role in ("pelvis", "neck") if role not in at]
    if missing or not lines:
        what = missing[0] if missing else "pair of hips or shoulders"
        raise DataError(
            f"Joint angles are seen from the trunk, but no {what} is known among {in_short(at)}.",
            remedy="Name it in a map file, --map FILE (body_map= in Python), or compare posture.",
        )
    up = _unit(at["neck"] - at["pelvis"])
    hips, shoulders = (lines.get(joint, next(iter(lines.values()))) for joint in ("hip", "shoulder"))
    return _frame(up, hips), _frame(up, shoulders)


def _frame(up: np.ndarray, left: np.ndarray) -> np.ndarray:
    front = _unit(np.cross(left, up))
    return np.stack((np.cross(up, front), up, front), axis=1)


def _within(frame: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Directions (T, 3) in the axes of a frame."""
    return np.einsum("tab,tb->ta", frame, _unit(vectors))


def _turned_back(vectors: np.ndarray, bone: np.ndarray, rest: np.ndarray) -> np.ndarray:
    """Turn vectors the shortest way that brings the bone onto its rest (Rodrigues)."""
    axis = np.cross(bone, rest)  # of length sin
    cosine = (bone * rest).sum(axis=1, keepdims=True)
    along = (axis * vectors).sum(axis=1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):  # against its rest, no way is the shortest
        return cosine * vectors + np.cross(axis, vectors) + axis * along / (1.0 + cosine)


def _unit(vectors: np.ndarray) -> np.ndarray:
    with np.errstate(divide="ignore", invalid="ignore"):  # joints in one place have no direction
        unit: np.ndarray = vectors / np.linalg.norm(vectors, axis=1, keepdims=True)
    return unit
