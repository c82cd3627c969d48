"""A mean adult in the joints of SMPL: what a file of SMPL's rotations moves here.

The files hold rotations and the shape as coefficients of a body model, whose licence does not let it be passed on. So
the bones here are not the recorded person's: they are the mean lengths of [1], of a person of 1.70 m. Names, order and
tree of the joints and the T-pose in which they rest are SMPL's. The trunk's joints lie evenly between the pelvis and
the neck, the hip joints half way from the middle to the side of the pelvis; hands are as long as [1] has them, their
fingers evenly parted.

References
----------
[1] Drillis, Contini, *Body segment parameters*, New York University (1966): segment lengths as shares of stature, as
    tabulated in Winter, *Biomechanics and Motor Control of Human Movement*.
[2] Loper, Mahmood, Romero, Pons-Moll, Black, *SMPL: a skinned multi-person linear model*, TOG 2015.
"""

from __future__ import annotations

import numpy as np

from leitmotion.io.joint_sets import HUMANML3D, SMPL, SMPL_H, SMPL_X, JointSet

STATURE = 1.70
"""Metres."""

BODIES: dict[int, JointSet] = {len(one.joints): one for one in (HUMANML3D, SMPL, SMPL_H, SMPL_X)}
"""Joint sets by how many joints they have."""

_PARENT = {
    "spine1": "pelvis", "spine2": "spine1", "spine3": "spine2", "neck": "spine3", "head": "neck", "jaw": "head",
    "hip": "pelvis", "knee": "hip", "ankle": "knee", "foot": "ankle", "eye": "head",
    "collar": "spine3", "shoulder": "collar", "elbow": "shoulder", "wrist": "elbow", "hand": "wrist",
}  # fmt: skip

# in shares of stature, standing in a T: to the left, up from the sole, to the front
_MIDDLE = {
    "pelvis": (0.0, 0.550, 0.0),
    "spine1": (0.0, 0.622, 0.0),
    "spine2": (0.0, 0.694, 0.0),
    "spine3": (0.0, 0.766, 0.0),
    "neck": (0.0, 0.838, 0.0),
    "head": (0.0, 0.918, 0.0),
    "jaw": (0.0, 0.890, 0.020),
}
_LEFT = {
    "hip": (0.0478, 0.530, 0.0),
    "knee": (0.0478, 0.285, 0.0),
    "ankle": (0.0478, 0.039, 0.0),
    "foot": (0.0478, 0.010, 0.076),
    "eye": (0.018, 0.936, 0.050),
    "collar": (0.030, 0.818, 0.0),
    "shoulder": (0.1295, 0.818, 0.0),
    "elbow": (0.3155, 0.818, 0.0),
    "wrist": (0.4615, 0.818, 0.0),
    "hand": (0.5155, 0.818, 0.0),
}
_FINGERS = {
    "index": 0.012,
    "middle": 0.004,
    "ring": -0.004,
    "pinky": -0.012,
}  # to the front of the hand's middle
_THUMB = (0.4765, 0.818, 0.020)
_PHALANX = 0.018


def mean_adult(joints: JointSet) -> tuple[np.ndarray, np.ndarray]:
    """Make the skeleton of a mean adult.

    Parameters
    ----------
    joints : JointSet
        One of :data:`BODIES`.

    Returns
    -------
    tuple of (J,) int and (J, 3) float
        Parents, and offsets in metres in the T-pose, Y up, facing +Z; the pelvis in the origin.

    Examples
    --------
    >>> parents, offsets = mean_adult(SMPL)
    >>> parents[:7].tolist(), float(offsets[4].round(4)[1])
    ([-1, 0, 0, 0, 1, 2, 3], -0.4165)
    """
    names = joints.joints
    places = np.array([_place(name) for name in names]) * STATURE
    parents = np.array([names.index(parent) if (parent := _parent(name)) else -1 for name in names])
    offsets = np.where(parents[:, None] >= 0, places - places[parents], 0.0)
    return parents, offsets


def _place(name: str) -> tuple[float, float, float]:
    if name in _MIDDLE:
        return _MIDDLE[name]
    side, _, part = name.partition("_")
    x, y, z = _LEFT.get(part) or _finger(part)
    return (x if side == "left" else -x, y, z)


def _finger(part: str) -> tuple[float, float, float]:
    finger, phalanx = part[:-1], int(part[-1]) - 1
    x, y, z = _THUMB if finger == "thumb" else (_LEFT["hand"][0], _LEFT["hand"][1], _FINGERS[finger])
    return (x + phalanx * _PHALANX, y, z)


def _parent(name: str) -> str:
    """Name the joint that a joint hangs on, empty for the pelvis."""
    side, _, part = name.rpartition("_")
    if part[-1].isdigit() and side:
        return f"{side}_wrist" if part.endswith("1") else f"{side}_{part[:-1]}{int(part[-1]) - 1}"
    parent = _PARENT.get(part, "")
    return f"{side}_{parent}" if side and parent in _LEFT else parent
