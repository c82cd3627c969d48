"""The body that OpenSim's joint angles move: which coordinate turns which joint, and bones of mean length.

Conventions
-----------
OpenSim's frame: X forward, Y up, Z the person's right; all joint frames are parallel when every angle is zero, and the
body then stands upright with its arms down. The head does not turn on the trunk. The coordinates are those of the
models Gait2354, Gait2392, Hamner 2010, Rajagopal 2016 and LaiUhlrich [2]_: the pelvis turns by tilt about Z, then list
about X, then rotation about Y, a hip by flexion, adduction, rotation and the trunk by extension, bending, rotation in
the same way; what turns a joint of the right side about X or Y turns that of the left the other way. The older models
bend a knee by negative angles, the newer by positive ones; knees hardly bend the other way, so the numbers tell.

Angles have no lengths. Limbs, shoulders and head are shares of the stature [1]_, the hips lie below and behind the
pelvis' origin between the two front spines as [3]_ found, for spines 0.24 m apart; the trunk turns where the generic
model of [2]_, of the same stature, has its joint.

References
----------
.. [1] D. A. Winter: Biomechanics and motor control of human movement, 4th edition, Wiley, 2009, section 4.1, after
   R. Drillis, R. Contini: Body segment parameters, New York University, 1966.
.. [2] A. Rajagopal, C. L. Dembia, M. S. DeMers, D. D. Delp, J. L. Hicks, S. L. Delp: Full-body musculoskeletal model
   for muscle-driven simulation of human gait, IEEE Transactions on Biomedical Engineering 63, 2016.
.. [3] A. L. Bell, D. R. Pedersen, R. A. Brand: A comparison of the accuracy of several hip center location prediction
   methods, Journal of Biomechanics 23, 1990.
.. [4] V. T. Inman: The joints of the ankle, Williams and Wilkins, 1976: the axis of the subtalar joint.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from leitmotion.io.reading import SkeletonTake
from leitmotion.motion import rotations

STATURE = 1.70
"""Metres, the height of the body whose bones stand in."""

_SPINES = 0.24  # metres between the front spines of the pelvis
_HIP = np.array([-0.19, -0.30, 0.36]) * _SPINES
_TRUNK = np.array([-0.1007, 0.0815, 0.0])
_SHOULDER_HEIGHT, _NECK_HEIGHT, _EAR_HEIGHT = (
    (share - 0.530) * STATURE + _HIP[1] - _TRUNK[1] for share in (0.818, 0.870, 0.936)
)  # above the trunk's joint: the hip is 0.530 of the stature high
_AXES = {
    "x": np.array([1.0, 0.0, 0.0]),
    "y": np.array([0.0, 1.0, 0.0]),
    "z": np.array([0.0, 0.0, 1.0]),
    "knee": np.array([0.0, 0.0, -1.0]),
    "subtalar": np.array([0.684, 0.669, -0.290])
    / np.linalg.norm([0.684, 0.669, -0.290]),  # 42° up, 23° inwards
}
"""Of the right side."""


class _Joint(NamedTuple):
    """A joint of the middle or of the right side."""

    name: str
    parent: str
    offset: tuple[float, float, float]
    turns: tuple[tuple[str, str], ...] = ()
    """Coordinates and the axes they turn about, in their order."""

    end: tuple[float, float, float] | None = None


_MIDDLE = (
    _Joint("pelvis", "", (0, 0, 0), (("pelvis_tilt", "z"), ("pelvis_list", "x"), ("pelvis_rotation", "y"))),
    _Joint("spine", "pelvis", tuple(_TRUNK),
           (("lumbar_extension", "z"), ("lumbar_bending", "x"), ("lumbar_rotation", "y"))),
    _Joint("chest", "spine", (0, 0.6 * _SHOULDER_HEIGHT, 0)),
    _Joint("neck", "chest", (0, _NECK_HEIGHT - 0.6 * _SHOULDER_HEIGHT, 0)),
    _Joint("head", "neck", (0, _EAR_HEIGHT - _NECK_HEIGHT, 0), end=(0, 0.064 * STATURE, 0)),
)  # fmt: skip
_RIGHT = (
    _Joint("hip", "pelvis", tuple(_HIP), (("hip_flexion", "z"), ("hip_adduction", "x"), ("hip_rotation", "y"))),
    _Joint("knee", "hip", (0, -0.245 * STATURE, 0), (("knee_angle", "knee"),)),
    _Joint("ankle", "knee", (0, -0.246 * STATURE, 0), (("ankle_angle", "z"), ("subtalar_angle", "subtalar"))),
    _Joint("toe", "ankle", (0.077 * STATURE, -0.027 * STATURE, 0), (("mtp_angle", "z"),),
           end=(0.046 * STATURE, -0.008 * STATURE, 0)),
    _Joint("shoulder", "chest", (0, 0.4 * _SHOULDER_HEIGHT, 0.1 * STATURE),
           (("arm_flex", "z"), ("arm_add", "x"), ("arm_rot", "y"))),
    _Joint("elbow", "shoulder", (0, -0.186 * STATURE, 0), (("elbow_flex", "z"),)),
    _Joint("wrist", "elbow", (0, -0.146 * STATURE, 0)),
)  # fmt: skip
_PLACES = ("pelvis_tx", "pelvis_ty", "pelvis_tz")


def moves_a_body(coordinates: Mapping[str, np.ndarray]) -> bool:
    """Tell whether the coordinates turn a pelvis, a hip and a knee."""
    needed = ("hip_flexion", "knee_angle")
    return "pelvis_tilt" in coordinates and any(
        all(f"{name}_{side}" in coordinates for name in needed) for side in "rl"
    )


def pose_body(coordinates: Mapping[str, np.ndarray]) -> tuple[SkeletonTake, set[str]]:
    """Turn a body of mean proportions by the coordinates of a motion.

    What hangs on a joint whose angles the coordinates do not hold is left out.

    Parameters
    ----------
    coordinates : mapping of str to (T,) float
        Angles in radians, places in metres, by name.

    Returns
    -------
    tuple of SkeletonTake and set of str
        The body, and the coordinates that it used.
    """
    frames = len(next(iter(coordinates.values())))
    bends = _knee_sign(coordinates)
    names: list[str] = []
    parents: list[int] = []
    offsets, turns, end_parents, ends = [], [], [], []
    used: set[str] = set()
    known: set[str] = set()  # joints of which the file tells how they are turned
    for joint, side in [*((j, "") for j in _MIDDLE), *((j, s) for s in ("left", "right") for j in _RIGHT)]:
        name, suffix = (f"{side}_{joint.name}", f"_{side[0]}") if side else (joint.name, "")
        above = joint.parent if joint.parent in known else f"{side}_{joint.parent}"
        own = [(f"{word}{suffix}", axis) for word, axis in joint.turns if f"{word}{suffix}" in coordinates]
        if joint.parent and above not in known:
            continue
        if own or not joint.turns:
            known.add(name)
        mirror = np.array([1.0, 1.0, -1.0 if side == "left" else 1.0])
        turn = np.tile([1.0, 0.0, 0.0, 0.0], (frames, 1))
        for word, axis in own:
            angle = coordinates[word] * (bends if axis == "knee" else 1.0)
            turn = rotations.multiply(turn, _turn(_AXES[axis], angle, mirror))
        used.update(word for word, _ in own)
        parents.append(names.index(above) if above in names else -1)
        names.append(name)
        offsets.append(mirror * joint.offset)
        turns.append(turn)
        if joint.end is not None:
            end_parents.append(len(names) - 1)
            ends.append(mirror * joint.end)
    positions = np.tile(np.array(offsets), (frames, 1, 1))
    for k, word in enumerate(_PLACES):
        if word in coordinates:
            positions[:, 0, k] = coordinates[word]
            used.add(word)
    take = SkeletonTake(
        names, np.array(parents), np.array(offsets), np.array(end_parents, dtype=np.int64),
        np.array(ends).reshape(-1, 3), positions,
        np.stack(turns, axis=1),
    )  # fmt: skip
    return take, used


def _knee_sign(coordinates: Mapping[str, np.ndarray]) -> float:
    """1 where knees bend by positive angles, -1 where by negative ones."""
    knees = np.concatenate(
        [coordinates[name] for name in ("knee_angle_r", "knee_angle_l") if name in coordinates]
    )
    return -1.0 if -knees.min() > knees.max() else 1.0


def _turn(axis: np.ndarray, angle: np.ndarray, mirror: np.ndarray) -> np.ndarray:
    """Quaternions (T, 4) about an axis of the right side, on the left side seen in a mirror."""
    half = angle[:, None] / 2.0
    # in a mirror an axis that lies in its plane points as before, but what turns about it turns the other way
    return np.concatenate((np.cos(half), np.sin(half) * axis * mirror * mirror[2]), axis=1)
