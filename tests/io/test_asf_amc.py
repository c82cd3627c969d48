"""ASF/AMC: agreement with the BVH of the same trial and with chained scipy Rotations."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.io.asf import find_asf
from leitmotion.motion import FormatError, forward_kinematics, rotations
from oracles import amc as amc_oracle
from oracles import bvh as bvh_oracle

UNIT = 0.0254 / 0.45

BVH_NAME = {
    "root": "Hips",
    "lhipjoint": "LHipJoint", "lfemur": "LeftUpLeg", "ltibia": "LeftLeg", "lfoot": "LeftFoot", "ltoes": "LeftToeBase",
    "rhipjoint": "RHipJoint", "rfemur": "RightUpLeg", "rtibia": "RightLeg", "rfoot": "RightFoot",
    "rtoes": "RightToeBase",
    "lowerback": "LowerBack", "upperback": "Spine", "thorax": "Spine1",
    "lowerneck": "Neck", "upperneck": "Neck1", "head": "Head",
    "lclavicle": "LeftShoulder", "lhumerus": "LeftArm", "lradius": "LeftForeArm", "lwrist": "LeftHand",
    "lhand": "LeftFingerBase", "lfingers": "LFingers", "lthumb": "LThumb",
    "rclavicle": "RightShoulder", "rhumerus": "RightArm", "rradius": "RightForeArm", "rwrist": "RightHand",
    "rhand": "RightFingerBase", "rfingers": "RFingers", "rthumb": "RThumb",
}  # fmt: skip


DROPPED = ("lowerneck", "lclavicle", "rclavicle", "lhand", "lthumb", "rhand", "rthumb")
"""Where a bone branches, the program that made this BVH hung its children on the bone's joint and not on its tip."""


@pytest.fixture(scope="module")
def pair(data):
    """The same trial as AMC and as BVH, which begins with a T-pose more."""
    of_amc = io.read(data / "cmu_amc" / "01_01.amc")
    of_bvh = io.read(data / "cmu_bvh" / "01_01.bvh")
    assert len(of_bvh) == len(of_amc) + 1
    return of_amc, of_bvh[1:]


def _apart(a, b):
    ours, theirs = forward_kinematics(a).positions, forward_kinematics(b).positions
    pairs = [(a.skeleton.index(x), b.skeleton.index(y)) for x, y in BVH_NAME.items()]
    return {
        name: np.abs(ours[:, i] - theirs[:, j]).max() for name, (i, j) in zip(BVH_NAME, pairs, strict=True)
    }


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_agree_below_the_chest(pair):
    apart = _apart(*pair)
    below = [n for n in BVH_NAME if n in ("root", "lowerback", "upperback", "thorax") or n[1:] in (
        "hipjoint", "femur", "tibia", "foot", "toes")]  # fmt: skip
    assert len(below) == 14
    assert max(apart[name] for name in below) < 1e-4


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_agree_joint_by_joint(pair):
    of_amc, of_bvh = pair
    moved = np.array(of_bvh.local_positions)
    for name in DROPPED:
        j = of_bvh.skeleton.index(BVH_NAME[name])
        assert not of_bvh.skeleton.offsets[j].any()
        moved[:, j] = of_amc.skeleton.offsets[of_amc.skeleton.index(name)]
    apart = _apart(of_amc, of_bvh.replace(local_positions=moved))
    assert max(apart.values()) < 1e-4


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_turn_alike(pair):
    of_amc, of_bvh = pair
    for ours, theirs in BVH_NAME.items():
        a = of_amc.local_rotations[:, of_amc.skeleton.index(ours)]
        b = of_bvh.local_rotations[:, of_bvh.skeleton.index(theirs)]
        assert rotations.geodesic_angle(a, b).max() < 1e-5, ours


@pytest.mark.data
@pytest.mark.parametrize("trial", ["cmu_amc/01_01", "cmu86/86_01"])
def test_amc_agrees_with_chained_rotations(data, trial):
    path = data / f"{trial}.amc"
    motion = io.read(path)
    frames = [0, 17, 1000, 2750]
    positions = forward_kinematics(motion).positions[frames]
    twin = amc_oracle.joint_positions(path.with_name(f"{path.name[:2]}.asf"), path, frames)
    assert set(twin) == set(motion.skeleton.names)
    for name, places in twin.items():
        np.testing.assert_allclose(
            positions[:, motion.skeleton.index(name)], places * UNIT, rtol=0, atol=1e-6
        )


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "unit"), [("cmu_bvh/01_01", UNIT), ("cmu_bvh/10_01", 0.01), ("perfume_dance/A_test", 0.01)]
)
def test_bvh_agrees_with_chained_rotations(data, name, unit):
    path = data / f"{name}.bvh"
    motion = io.read(path)
    frames = [0, 17, 500]
    positions = forward_kinematics(motion).positions[frames]
    for joint, places in bvh_oracle.joint_positions(path, frames).items():
        np.testing.assert_allclose(
            positions[:, motion.skeleton.index(joint)], places * unit, rtol=0, atol=1e-6
        )


# --- what the format may hold, on a skeleton small enough to reckon by hand

ASF = """# a comment
:version 1.10
:units
  length 1.0
  angle {angle}
:root
  order {order}
  axis XYZ
  position 1 2 3
  orientation 0 0 0
:bonedata
  begin
    name back
    direction 0 1 0
    length 2
    axis 0 0 0 XYZ
    dof {dofs}
  end
  begin
    name head
    direction 0 2 0
    length 1
    axis {axis} XYZ
    dof rz
  end
:hierarchy
  begin
    root back
    back head
  end
"""
AMC = """:FULLY-SPECIFIED
:DEGREES
1
root 10 20 30 0 0 0
back {back}
head 90
2
root 10 20 30 0 0 90
back {back}
head 0
"""


def put(tmp_path, *, angle="deg", order="TX TY TZ RX RY RZ", dofs="rx", back="0", axis="0 0 0", amc=AMC):
    text = ASF.format(angle=angle, order=order, dofs=dofs, axis=axis)
    (tmp_path / "s.asf").write_bytes(text.encode("latin-1"))
    path = tmp_path / "s_01.amc"
    path.write_bytes(amc.replace("{back}", back).encode("latin-1"))
    return path


def places(path, **options):
    return forward_kinematics(io.read(path, unit="m", **options)).positions


def test_a_bone_is_the_joint_at_its_proximal_end(tmp_path):
    motion = io.read(put(tmp_path), unit="m")
    assert motion.skeleton.names == ("root", "back", "head")
    np.testing.assert_allclose(motion.skeleton.offsets, [[1, 2, 3], [0, 0, 0], [0, 2, 0]])
    np.testing.assert_allclose(motion.skeleton.end_offsets, [[0, 1, 0]])  # the tip of the only leaf
    expected = [[[11, 22, 33], [11, 22, 33], [11, 24, 33]], [[11, 22, 33], [11, 22, 33], [9, 22, 33]]]
    np.testing.assert_allclose(forward_kinematics(motion).positions, expected, atol=1e-12)


def test_angles_may_be_radians(tmp_path):
    degrees = places(put(tmp_path, back="30"))
    text = AMC.replace("90", str(np.pi / 2)).replace("DEGREES", "RADIANS")
    radians = places(put(tmp_path, angle="rad", back=str(np.pi / 6), amc=text))
    np.testing.assert_allclose(radians, degrees, atol=1e-12)
    mixed = places(put(tmp_path, back=str(np.pi / 6), amc=text))  # the frames' own word counts
    np.testing.assert_allclose(mixed, degrees, atol=1e-12)
    silent = places(put(tmp_path, angle="rad", back=str(np.pi / 6), amc=text.replace(":RADIANS\n", "")))
    np.testing.assert_allclose(silent, degrees, atol=1e-12)


def test_the_root_follows_its_order(tmp_path):
    text = AMC.replace("root 10 20 30 0 0 0", "root 0 0 0 30 10 20").replace(
        "root 10 20 30 0 0 90", "root 0 90 0 30 10 20"
    )
    turned = io.read(put(tmp_path, order="RX RZ RY TZ TX TY", amc=text), unit="m")
    plain = io.read(put(tmp_path), unit="m")
    np.testing.assert_allclose(turned.local_positions, plain.local_positions)
    np.testing.assert_allclose(turned.local_rotations, plain.local_rotations, atol=1e-12)


def test_translations_and_stretch_of_a_bone(tmp_path):
    moved = places(put(tmp_path, dofs="tx rx l", back="0.5 0 3"))
    plain = places(put(tmp_path))
    np.testing.assert_allclose(moved[0] - plain[0], [[0, 0, 0], [0.5, 0, 0], [0.5, 3, 0]], atol=1e-12)


def test_a_bone_turns_about_its_own_axes(tmp_path):
    motion = io.read(put(tmp_path, axis="90 0 0"), unit="m")
    # its own z axis is the world's -y at rest
    np.testing.assert_allclose(
        motion.local_rotations[0, 2], rotations.from_axis_angle("y", -np.pi / 2), atol=1e-12
    )


def test_names_in_latin_1_and_crlf(tmp_path):
    text = "#!OML:ASF X:\\für Bonn\n" + AMC
    np.testing.assert_array_equal(
        places(put(tmp_path, amc=text.replace("\n", "\r\n"))), places(put(tmp_path))
    )


def test_a_skeleton_unknown_is_judged_by_its_size(tmp_path):
    reading = io.open_recording(put(tmp_path))
    assert reading.findings["unit"].how == "guessed"
    assert reading.findings["skeleton"].value.endswith("s.asf")
    assert (reading.findings["rate"].value, reading.findings["rate"].how) == (120.0, "guessed")


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        (
            "2\nroot 10 20 30 0 0 90\nback",
            "2\nback 0\nroot 1 2 3 4 5 6\nhead",
            "line 8: expected bone 'root', as in the",
        ),
        (
            "\nback {back}\nhead 0",
            "\nhead 0",
            "line 9: expected bone 'back', as in the first frame, found 'head 0'",
        ),
        (
            "root 10 20 30 0 0 90",
            "root 10 20 30 0 0",
            "line 8: expected 'root' and 6 numbers, found 'root 10 20 30 0 0'",
        ),
        ("root 10 20 30 0 0 90", "root 10 20 30 0 0 90 1", "line 8: expected 'root' and 6 numbers"),
        ("root 10 20 30 0 0 90", "root 10 20 30 0 0 nan", "line 8: expected a number, found 'nan'"),
        ("\nhead 90", "", "line 3: expected a line of bone 'head' in the first frame.*--skeleton"),
        ("head 90", "tail 90", "line 3: expected bones of the skeleton, found 'tail'.*--skeleton"),
        ("\n2\n", "\ntwo\n", "line 8: expected every bone once a frame, found 'root' again"),
        ("1\nroot", "root", "line 3: expected the number of the first frame"),
    ],
)
def test_faults_name_their_line(tmp_path, old, new, match):
    assert old in AMC
    with pytest.raises(FormatError, match=match):
        io.read(put(tmp_path, amc=AMC.replace(old, new, 1)))


def test_a_frame_cut_short_is_left_out_and_told(tmp_path):
    reading = io.open_recording(put(tmp_path, amc=AMC[: AMC.rindex("0 90")]))
    assert len(reading.recordings[0]) == 1
    assert any("ends within its frame 2, at bone 'root'" in warning for warning in reading.warnings)


def test_frame_numbers_that_jump_are_told(tmp_path):
    reading = io.open_recording(put(tmp_path, amc=AMC.replace("\n2\n", "\n7\n")))
    assert any("7 follows 1" in warning for warning in reading.warnings)


# --- which skeleton belongs to a recording


@pytest.fixture
def deep(tmp_path):
    """A folder so deep that the search does not leave the test's own."""
    folder = tmp_path / "1" / "2" / "3"
    folder.mkdir(parents=True)
    return folder


@pytest.mark.parametrize(
    ("amc", "asfs", "found"),
    [
        ("86_09.amc", ["85.asf", "86.asf"], "86.asf"),
        ("86_09.amc", ["8.asf", "86.asf", "86_09.asf"], "86_09.asf"),
        ("HDM_mm_walk_001_120.amc", ["HDM_bd.asf", "HDM_mm.asf"], "HDM_mm.asf"),
        ("131_04-dance.amc", ["131-dance.asf", "13-dance.asf"], "131-dance.asf"),
        ("a/b/c/86_09.amc", ["86.asf"], "86.asf"),
        ("a/86_09.amc", ["a/other.asf", "86.asf"], "86.asf"),
        ("walk.amc", ["skeleton.asf"], "skeleton.asf"),
        ("a/walk.amc", ["skeleton.asf"], "skeleton.asf"),
    ],
)
def test_the_skeleton_of_a_recording(deep, amc, asfs, found):
    for name in [amc, *asfs]:
        (deep / name).parent.mkdir(parents=True, exist_ok=True)
        (deep / name).touch()
    path, reason = find_asf(deep / amc)
    assert path == deep / found
    assert ("only" in reason) == (found == "skeleton.asf")


@pytest.mark.parametrize(
    ("amc", "asfs", "match"),
    [
        ("35_01.amc", ["02.asf", "05.asf"], "2 of other names: 02.asf, 05.asf.*--skeleton"),
        ("a/b/c/d/86_09.amc", ["86.asf"], "found none"),
        ("35_01.amc", [], "found none"),
    ],
)
def test_no_skeleton_is_one_sentence(deep, amc, asfs, match):
    for name in [amc, *asfs]:
        (deep / name).parent.mkdir(parents=True, exist_ok=True)
        (deep / name).touch()
    with pytest.raises(FormatError, match=match):
        find_asf(deep / amc)


@pytest.mark.data
def test_the_skeleton_may_be_given(data, tmp_path):
    alone = tmp_path / "walk.amc"
    alone.write_bytes((data / "cmu_amc" / "02_01.amc").read_bytes())
    reading = io.open_recording(alone, skeleton=data / "cmu_amc" / "02.asf")
    assert reading.findings["skeleton"].how == "given"
    expected = io.read(data / "cmu_amc" / "02_01.amc")
    assert reading.recordings[0] == expected.replace(name="walk")
