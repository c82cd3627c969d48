"""Joint sets: the points that cameras and pose estimators tell, in the order in which they tell them.

Files of such points hold numbers without names. What each is, is known by the program that wrote them, or told by how
many there are. Left is the person's left.

References
----------
[1] OpenPose, ``poseParameters.cpp``: BODY_25, COCO_18, BODY_135.
[2] COCO keypoints (17); COCO-WholeBody (133): Jin et al., *Whole-Body Human Pose Estimation in the Wild*, ECCV 2020.
[3] HALPE (26, 136): Fang et al., *AlphaPose*, TPAMI 2022.
[4] BlazePose (33): Bazarevsky et al., 2020.
[5] Kinect SDK 1.8 (20 joints), 2.0 (25), Azure Kinect Body Tracking SDK (32).
[6] SMPL (24), SMPL-H (52), SMPL-X (55): Loper et al. 2015, Romero et al. 2017, Pavlakos et al. 2019.
[7] Human3.6M (17 of 32 joints): Ionescu et al., TPAMI 2014.
[8] HumanML3D (the first 22 joints of SMPL): Guo et al., CVPR 2022.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class JointSet:
    """What the points of a source are."""

    name: str
    """What the set is called."""

    joints: tuple[str, ...]
    """One name a point, in order."""

    rate: float = 30.0
    """Frames per second that such a source usually has."""

    usual: str = "the usual rate of a camera"
    """Why that rate."""


def _both(*parts: str, sides: tuple[str, str] = ("left", "right")) -> tuple[str, ...]:
    """Name each part on both sides, in turn: ``left_eye``, ``right_eye`` and so on."""
    return tuple(f"{side}_{part}" for part in parts for side in sides)


def _each(side: str, *parts: str) -> tuple[str, ...]:
    return tuple(f"{side}_{part}" for part in parts)


def _numbered(what: str, count: int) -> tuple[str, ...]:
    return tuple(f"{what}_{k}" for k in range(count))


_FACE = ("nose", *_both("eye", "ear"))
_LIMBS = _both("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
_FINGERS = ("thumb", "index", "middle", "ring", "pinky")
_KNUCKLES = ("wrist_point", *(f"{finger}_{k}" for finger in _FINGERS for k in range(1, 5)))

COCO_17 = JointSet("COCO 17", (*_FACE, *_LIMBS))

COCO_18 = JointSet(
    "OpenPose COCO 18",
    (
        "nose", "neck",
        *_each("right", "shoulder", "elbow", "wrist"), *_each("left", "shoulder", "elbow", "wrist"),
        *_each("right", "hip", "knee", "ankle"), *_each("left", "hip", "knee", "ankle"),
        "right_eye", "left_eye", "right_ear", "left_ear",
    ),
)  # fmt: skip

BODY_25 = JointSet(
    "OpenPose BODY_25",
    (
        "nose", "neck",
        *_each("right", "shoulder", "elbow", "wrist"), *_each("left", "shoulder", "elbow", "wrist"),
        "mid_hip",
        *_each("right", "hip", "knee", "ankle"), *_each("left", "hip", "knee", "ankle"),
        "right_eye", "left_eye", "right_ear", "left_ear",
        *_each("left", "big_toe", "small_toe", "heel"), *_each("right", "big_toe", "small_toe", "heel"),
    ),
)  # fmt: skip

BODY_135 = JointSet(
    "OpenPose BODY_135",
    (
        *_FACE, *_LIMBS, "neck", "head_top",
        *_each("left", "big_toe", "small_toe", "heel"), *_each("right", "big_toe", "small_toe", "heel"),
        *_each("left", *_KNUCKLES[1:]), *_each("right", *_KNUCKLES[1:]), *_numbered("face", 70),
    ),
)  # fmt: skip

HALPE_26 = JointSet(
    "HALPE 26",
    (*_FACE, *_LIMBS, "head_top", "neck", "mid_hip", *_both("big_toe", "small_toe", "heel")),
)

HALPE_136 = JointSet(
    "HALPE 136",
    (*HALPE_26.joints, *_numbered("face", 68), *_each("left", *_KNUCKLES), *_each("right", *_KNUCKLES)),
)

WHOLE_BODY = JointSet(
    "COCO-WholeBody",
    (
        *COCO_17.joints,
        *_each("left", "big_toe", "small_toe", "heel"), *_each("right", "big_toe", "small_toe", "heel"),
        *_numbered("face", 68), *_each("left", *_KNUCKLES), *_each("right", *_KNUCKLES),
    ),
)  # fmt: skip

BLAZEPOSE = JointSet(
    "BlazePose",
    (
        "nose", "left_eye_inner", "left_eye", "left_eye_outer", "right_eye_inner", "right_eye", "right_eye_outer",
        *_both("ear"), "mouth_left", "mouth_right",
        *_both("shoulder", "elbow", "wrist", "pinky", "index", "thumb", "hip", "knee", "ankle", "heel", "foot_index"),
    ),
)  # fmt: skip

KINECT_1 = JointSet(
    "Kinect v1",
    (
        "HipCenter", "Spine", "ShoulderCenter", "Head",
        "ShoulderLeft", "ElbowLeft", "WristLeft", "HandLeft",
        "ShoulderRight", "ElbowRight", "WristRight", "HandRight",
        "HipLeft", "KneeLeft", "AnkleLeft", "FootLeft",
        "HipRight", "KneeRight", "AnkleRight", "FootRight",
    ),
    usual="the rate of a Kinect",
)  # fmt: skip

KINECT_2 = JointSet(
    "Kinect v2",
    (
        "SpineBase", "SpineMid", "Neck", "Head",
        *KINECT_1.joints[4:],
        "SpineShoulder", "HandTipLeft", "ThumbLeft", "HandTipRight", "ThumbRight",
    ),
    usual="the rate of a Kinect",
)  # fmt: skip

AZURE = JointSet(
    "Azure Kinect",
    (
        "Pelvis", "SpineNavel", "SpineChest", "Neck",
        *(f"{part}{side}" for side in ("Left", "Right")
          for part in ("Clavicle", "Shoulder", "Elbow", "Wrist", "Hand", "HandTip", "Thumb")),
        *(f"{part}{side}" for side in ("Left", "Right") for part in ("Hip", "Knee", "Ankle", "Foot")),
        "Head", "Nose", "EyeLeft", "EarLeft", "EyeRight", "EarRight",
    ),
    usual="the rate of a Kinect",
)  # fmt: skip

_SMPL_22 = (
    "pelvis", "left_hip", "right_hip", "spine1", "left_knee", "right_knee", "spine2", "left_ankle", "right_ankle",
    "spine3", "left_foot", "right_foot", "neck", "left_collar", "right_collar", "head",
    "left_shoulder", "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
)  # fmt: skip
_SMPL_HANDS = tuple(
    f"{side}_{finger}{k}"
    for side in ("left", "right")
    for finger in ("index", "middle", "pinky", "ring", "thumb")
    for k in (1, 2, 3)
)

HUMANML3D = JointSet("HumanML3D", _SMPL_22, 20.0, "the rate of that data set")
SMPL = JointSet("SMPL", (*_SMPL_22, "left_hand", "right_hand"))
SMPL_H = JointSet("SMPL-H", (*_SMPL_22, *_SMPL_HANDS))
SMPL_X = JointSet("SMPL-X", (*_SMPL_22, "jaw", "left_eye", "right_eye", *_SMPL_HANDS))

HUMAN36M = JointSet(
    "Human3.6M",
    (
        "hip", *_each("right", "hip", "knee", "ankle"), *_each("left", "hip", "knee", "ankle"),
        "spine", "thorax", "neck", "head",
        *_each("left", "shoulder", "elbow", "wrist"), *_each("right", "shoulder", "elbow", "wrist"),
    ),
    50.0,
    "the rate of that data set",
)  # fmt: skip

IN_IMAGES = (COCO_17, COCO_18, BODY_25, HALPE_26, BLAZEPOSE, WHOLE_BODY, BODY_135, HALPE_136)
"""Sets of points in an image; no two have as many points."""

IN_SPACE = (HUMAN36M, KINECT_1, HUMANML3D, SMPL, KINECT_2, AZURE, BLAZEPOSE, SMPL_H, SMPL_X)
"""Sets of points in space; no two have as many points."""


def set_of(count: int, sets: tuple[JointSet, ...]) -> JointSet | None:
    """Tell a joint set by how many points it has, None where no set has so many.

    Examples
    --------
    >>> set_of(33, IN_IMAGES).name, set_of(17, IN_SPACE).name, set_of(5, IN_SPACE)
    ('BlazePose', 'Human3.6M', None)
    """
    return next((one for one in sets if len(one.joints) == count), None)
