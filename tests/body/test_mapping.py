"""Roles from names: one person under every convention."""

import numpy as np
import pytest

from leitmotion.body import ANALYSIS_ROLES, ROLES, find_roles
from leitmotion.motion import Motion, Skeleton, Trajectories, rotations
from oracles.body import human, mirrored, points_of, renamed, skeleton, without

BOTH = ("Left", "Right")


def sided(**words):
    """MotionBuilder's name to another's, both sides; ``{s}`` left, ``{c}`` L, ``{l}`` l."""
    return {
        side + own: word.format(S=side, s=side.lower(), C=side[0], c=side[0].lower())
        for side in BOTH
        for own, word in words.items()
    }


CONVENTIONS = {
    "motionbuilder": {},
    "mixamo": {name: f"mixamorig:{name}" for name in skeleton().names},
    "biovision": sided(
        Shoulder="{S}Collar", Arm="{S}Shoulder", ForeArm="{S}Elbow", Hand="{S}Wrist",
        UpLeg="{S}Hip", Leg="{S}Knee", Foot="{S}Ankle", ToeBase="{S}Toe",
    ),
    "cmu": {
        "Hips": "root", "Spine": "lowerback", "Spine1": "upperback", "Spine2": "thorax", "Neck": "lowerneck",
        "Head": "head",
        **sided(
            Shoulder="{c}clavicle", Arm="{c}humerus", ForeArm="{c}radius", Hand="{c}wrist",
            UpLeg="{c}femur", Leg="{c}tibia", Foot="{c}foot", ToeBase="{c}toes",
        ),
    },
    "daz": {
        "Hips": "hip", "Spine": "abdomen", "Spine2": "chest", "Neck": "neck", "Head": "head",
        **sided(
            Shoulder="{c}Collar", Arm="{c}Shldr", ForeArm="{c}ForeArm", Hand="{c}Hand",
            UpLeg="{c}Thigh", Leg="{c}Shin", Foot="{c}Foot", ToeBase="{c}Toe",
        ),
    },
    "unreal": {
        "Hips": "pelvis", "Spine": "spine_01", "Spine1": "spine_02", "Spine2": "spine_03", "Neck": "neck_01",
        "Head": "head",
        **sided(
            Shoulder="clavicle_{c}", Arm="upperarm_{c}", ForeArm="lowerarm_{c}", Hand="hand_{c}",
            UpLeg="thigh_{c}", Leg="calf_{c}", Foot="foot_{c}", ToeBase="ball_{c}",
        ),
    },
    "biped": {
        "Hips": "Bip01 Pelvis", "Spine": "Bip01 Spine", "Spine1": "Bip01 Spine1", "Spine2": "Bip01 Spine2",
        "Neck": "Bip01 Neck", "Head": "Bip01 Head",
        **sided(
            Shoulder="Bip01 {C} Clavicle", Arm="Bip01 {C} UpperArm", ForeArm="Bip01 {C} Forearm",
            Hand="Bip01 {C} Hand", UpLeg="Bip01 {C} Thigh", Leg="Bip01 {C} Calf", Foot="Bip01 {C} Foot",
            ToeBase="Bip01 {C} Toe0",
        ),
    },
    "blender": sided(
        Shoulder="shoulder.{C}", Arm="upper_arm.{C}", ForeArm="forearm.{C}", Hand="hand.{C}",
        UpLeg="thigh.{C}", Leg="shin.{C}", Foot="foot.{C}", ToeBase="toe.{C}",
    ),
    "smpl": {
        "Hips": "pelvis", "Spine": "spine1", "Spine1": "spine2", "Spine2": "spine3", "Neck": "neck", "Head": "head",
        **sided(
            Shoulder="{s}_collar", Arm="{s}_shoulder", ForeArm="{s}_elbow", Hand="{s}_wrist",
            UpLeg="{s}_hip", Leg="{s}_knee", Foot="{s}_ankle", ToeBase="{s}_foot",
        ),
    },
    "bandai": {
        **sided(
            Shoulder="Shoulder_{C}", Arm="UpperArm_{C}", ForeArm="LowerArm_{C}", Hand="Hand_{C}",
            UpLeg="UpperLeg_{C}", Leg="LowerLeg_{C}", Foot="Foot_{C}", ToeBase="Toes_{C}",
        ),
    },
    "kinect": {
        "Hips": "SpineBase", "Spine": "SpineMid", "Spine2": "SpineShoulder", "Neck": "Neck", "Head": "Head",
        **sided(
            Shoulder="Collar{S}", Arm="Shoulder{S}", ForeArm="Elbow{S}", Hand="Wrist{S}",
            UpLeg="Hip{S}", Leg="Knee{S}", Foot="Ankle{S}", ToeBase="Foot{S}",
        ),
    },
}  # fmt: skip
MEANT = {
    "Hips": "pelvis", "Neck": "neck", "Head": "head",
    **sided(
        Arm="{s}_shoulder", ForeArm="{s}_elbow", Hand="{s}_wrist", UpLeg="{s}_hip", Leg="{s}_knee", Foot="{s}_ankle",
        ToeBase="{s}_toe",
    ),
}  # fmt: skip


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_every_convention_names_the_same_joints(convention, rng):
    names = CONVENTIONS[convention]
    found = find_roles(renamed(human(rng), names))
    for own, role in MEANT.items():
        place = found.roles.index(role)
        assert found.members[place] == (names.get(own, own),)
        assert found.confidence[place] == 1.0


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_points_without_a_tree_are_named_the_same(convention, rng):
    names = {own: CONVENTIONS[convention].get(own, own) for own in MEANT}
    found = find_roles(points_of(human(rng), names))
    assert {role: members for role, members in zip(found.roles, found.members) if role in MEANT.values()} == {
        role: (names[own],) for own, role in MEANT.items()
    }


def test_roles_come_in_one_order_and_once(rng):
    found = find_roles(human(rng))
    assert list(found.roles) == [role for role in ROLES if role in found.roles]
    joints = [name for members in found.members for name in members]
    assert len(joints) == len(set(joints))


def test_trunk_is_read_from_the_tree(rng):
    found = find_roles(renamed(human(rng), {"Spine": "Chest", "Spine1": "Chest2", "Spine2": "Chest3"}))
    assert found.members[found.roles.index("chest")] == ("Chest3",)
    assert found.members[found.roles.index("spine")] == ("Chest",)


def test_a_missing_neck_is_implied_with_less_confidence(rng):
    found = find_roles(without(human(rng), "Neck"))
    place = found.roles.index("neck")
    assert found.members[place] == ("LeftShoulder", "RightShoulder")
    assert found.confidence[place] == 0.8


def test_pose_estimator_points():
    names = tuple(f"{side}_{joint}" for side in ("left", "right") for joint in (
        "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "heel", "foot_index", "ear", "index", "pinky"
    ))  # fmt: skip
    found = find_roles(Trajectories(("nose", *names), np.full((1, 23, 3), np.nan), 30, kind="joint"))
    told = dict(zip(found.roles, found.members))
    assert set(ANALYSIS_ROLES) <= set(told)
    assert told["pelvis"] == ("left_hip", "right_hip")
    assert told["neck"] == ("left_shoulder", "right_shoulder")
    assert told["head"] == ("left_ear", "right_ear")
    assert told["left_toe"] == ("left_foot_index",)
    assert told["left_hand"] == ("left_index", "left_pinky")


PLUG_IN_GAIT = (
    *(
        "LFHD",
        "RFHD",
        "LBHD",
        "RBHD",
        "C7",
        "T10",
        "CLAV",
        "STRN",
        "RBAK",
        "LSHO",
        "LUPA",
        "LELB",
        "LFRM",
        "LWRA",
    ),
    *(
        "LWRB",
        "LFIN",
        "RSHO",
        "RUPA",
        "RELB",
        "RFRM",
        "RWRA",
        "RWRB",
        "RFIN",
        "LASI",
        "RASI",
        "LPSI",
        "RPSI",
        "LTHI",
    ),
    *(
        "LKNE",
        "LTIB",
        "LANK",
        "LHEE",
        "LTOE",
        "RTHI",
        "RKNE",
        "RTIB",
        "RANK",
        "RHEE",
        "RTOE",
        "LHipAngles",
        "*41",
    ),
)


def markers(names):
    return Trajectories(tuple(names), np.full((1, len(names), 3), np.nan), 100)


def test_plug_in_gait():
    found = find_roles(markers(PLUG_IN_GAIT))
    told = {
        role: (members, sure) for role, members, sure in zip(found.roles, found.members, found.confidence)
    }
    assert set(ANALYSIS_ROLES) <= set(told)
    assert told["head"] == (("LFHD", "RFHD", "LBHD", "RBHD"), 0.9)
    assert told["left_wrist"] == (("LWRA", "LWRB"), 0.9)
    assert told["left_hip"] == (("LASI", "LPSI"), 0.5)
    assert told["right_knee"] == (("RKNE",), 0.9)
    assert told["chest"] == (("T10", "STRN"), 0.9)


def test_a_marker_on_a_segment_is_no_joint():
    names = [
        f"{s}.{n}"
        for s in "RL"
        for n in ("ASIS", "Thigh", "Knee", "Shank", "Ankle", "Forearm", "Elbow", "Wrist")
    ]
    told = dict(zip((found := find_roles(markers(names))).roles, found.members))
    assert told["left_hip"] == ("L.ASIS",)
    assert told["left_elbow"] == ("L.Elbow",)


def test_the_order_of_the_points_does_not_matter(rng):
    table = points_of(human(rng))
    shuffled = rng.permutation(len(table.names))
    other = find_roles(
        table.replace(names=[table.names[i] for i in shuffled], positions=table.positions[:, shuffled])
    )
    assert other == find_roles(table)


def test_a_table_of_bones_is_one_of_joints(rng):
    motion = human(rng)
    table = points_of(motion, kind="marker")
    told, meant = (dict(zip((found := find_roles(one)).roles, found.members)) for one in (table, motion))
    assert {role: told[role] for role in ANALYSIS_ROLES} == {role: meant[role] for role in ANALYSIS_ROLES}


def test_unknown_names_get_no_role():
    found = find_roles(markers([f"Channel{n}" for n in range(101, 141)]))
    assert found.roles == ()
    assert found.confidence.shape == (0,)


def test_swapped_sides_are_doubted_not_repaired(rng):
    motion = human(rng)
    swapped = renamed(motion, {name: name.replace(*pair) for pair in (BOTH, BOTH[::-1])
                               for name in motion.skeleton.names if name.startswith(pair[0])})  # fmt: skip
    found = find_roles(swapped)
    sure = dict(zip(found.roles, found.confidence))
    assert sure["left_knee"] == sure["right_shoulder"] == 0.5
    assert sure["head"] == 1.0
    assert find_roles(mirrored(motion)).confidence.min() == 1.0


def test_unequal_bones_are_doubted(rng):
    motion = human(rng)
    longer = motion.local_positions.copy()
    longer[:, motion.skeleton.index("LeftHand")] *= 2
    sure = dict(zip((found := find_roles(motion.replace(local_positions=longer))).roles, found.confidence))
    assert sure["left_wrist"] == sure["right_wrist"] == 0.5
    assert sure["left_elbow"] == 1.0


def test_a_joint_out_of_its_chain_is_doubted():
    names, places = (
        ("Hips", "LeftUpLeg", "LeftLeg", "LeftFoot"),
        [[0, 1, 0], [0.1, 0, 0], [0.1, -0.4, 0], [0, -0.4, 0]],
    )
    body = Skeleton(names, [-1, 0, 0, 2], places)
    found = find_roles(Motion(body, body.offsets[None], np.tile(rotations.IDENTITY, (1, 4, 1)), rate=1))
    sure = dict(zip(found.roles, found.confidence))
    assert sure["left_knee"] == 0.5
    assert sure["left_ankle"] == 1.0
