"""Names: one side and one word, whoever wrote them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from leitmotion.body.names import parse_names


@pytest.mark.parametrize(
    ("name", "side", "word"),
    [
        ("LeftUpLeg", "left", "upleg"),
        ("mixamorig:RightForeArm", "right", "forearm"),
        ("thigh.L", "left", "thigh"),
        ("upper_arm_R", "right", "upperarm"),
        ("l_thigh", "left", "thigh"),
        ("lThigh", "left", "thigh"),
        ("R.Knee.Medial", "right", "kneemedial"),
        ("UpperLeg_L", "left", "upperleg"),
        ("Hip-FL", "left", "hipfront"),
        ("Hip_BR", "right", "hipback"),
        ("Head-B", "", "headback"),
        ("SHOULDER_LEFT", "left", "shoulder"),
        ("ElbowRight", "right", "elbow"),
        ("LHipAngles", "left", "hipangles"),
        ("Spine_01", "", "spine1"),
        ("T10", "", "t10"),
        ("C7", "", "c7"),
        ("*115", "", "115"),
    ],
)
def test_reads_side_and_word(name, side, word):
    assert tuple(parse_names([name])[0]) == (side, word)


def test_glued_letters_need_a_known_word_and_a_partner():
    read = dict(zip(names := ("LSHO", "RSHO", "lfemur", "lowerback", "root", "LELB"), parse_names(names)))
    assert tuple(read["LSHO"]) == ("left", "sho")
    assert tuple(read["lfemur"]) == ("", "lfemur"), "no rfemur stands beside it"
    assert tuple(read["lowerback"]) == ("", "lowerback")
    assert tuple(read["root"]) == ("", "root")


def test_letter_glued_behind():
    assert [tuple(name) for name in parse_names(["ASISl", "ASISr"])] == [("left", "asis"), ("right", "asis")]


def test_what_all_names_share_says_nothing():
    read = parse_names(["Bip01", "Bip01 L Thigh", "Bip01 R Thigh", "Bip01 Pelvis"])
    assert [tuple(name) for name in read] == [("", ""), ("left", "thigh"), ("right", "thigh"), ("", "pelvis")]


def test_a_helper_without_the_prefix_does_not_hide_it():
    read = parse_names(
        ["Armature", *(f"mixamorig_{joint}" for joint in ("Hips", "Spine", "Neck", "LeftArm", "Head"))]
    )
    assert tuple(read[-2]) == ("left", "arm")
    assert tuple(read[0]) == ("", "armature")


def test_a_shared_side_is_no_prefix():
    assert {name.side for name in parse_names(["LeftArm", "LeftHand", "LeftLeg"])} == {"left"}


@given(st.lists(st.text(max_size=12), max_size=6))
def test_any_names_are_read(names):
    assert len(parse_names(names)) == len(names)
