"""ASF/AMC: agreement with the BVH of the same trial and with chained scipy Rotations."""

import numpy as np
import pytest

from fuzzing.law import bounded
from leitmotion import io
from leitmotion.io.asf import read_asf
from leitmotion.io.asf_search import find_asf
from leitmotion.io.reading import Source
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


# --- the same in other spellings


def respelled(tmp_path, of_asf=lambda s: s, of_amc=lambda s: s):
    path = put(tmp_path)
    for file, change in ((tmp_path / "s.asf", of_asf), (path, of_amc)):
        changed = change(file.read_text("latin-1"))
        file.write_bytes(changed if isinstance(changed, bytes) else changed.encode("latin-1"))
    return io.open_recording(path, unit="m", rate=120)


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s.replace("\n", "\r\n"),
        lambda s: s.replace("\n", "\r"),
        lambda s: s.encode("utf-16"),
        lambda s: s.encode("utf-16-be"),
        lambda s: s + "\x1a",
        lambda s: s.replace(":units\n  length 1.0\n  angle deg", ":UNITS mass 1.0 length 1.0 angle DEG"),
        lambda s: s.replace("length 1.0\n  angle deg", "mass 1\n  length 1.0"),
        lambda s: s.replace("  dof rx\n", "  dof RX\n  limits (-160.0 20.0)\n"),
        lambda s: s.replace("    dof rx\n", "    limits\n (-160\n 20)\n\n  dof  rx   # one\n"),
        lambda s: s.replace("  order TX TY TZ RX RY RZ\n  axis XYZ\n", "  axis xyz\n  order tx ty tz rx ry rz\n"),
        lambda s: s.replace("begin\n    name back", "begin\n  id 1\n  bodymass 3\n  cofmass 0 1 0\n  name back"),
        lambda s: (
            s.upper().replace("NAME BACK", "NAME back").replace("NAME HEAD", "NAME head").replace("ROOT B", "root b")
        ),
        lambda s: s.replace(":hierarchy\n  begin\n", ":hierarchy\n\n# ours\n  begin\n\n"),
        lambda s: s.replace("    root back\n    back head\n", "    back head\n    root back\n"),
        lambda s: s.replace("    axis 0 0 0 XYZ\n    dof rz", "    axis 0 0 0\n    dof rz"),
        lambda s: s + ":skin x.skn\n:documentation\n  begin\n  made by hand\n",
    ],
    ids=[
        "crlf", "cr", "utf-16", "utf-16-be", "ctrl-z", "units in a line", "no angle", "upper dof", "limits",
        "root order", "more keys", "upper case", "blank lines", "children first", "no axis letters", "more sections",
    ],
)  # fmt: skip
def test_spellings_of_one_skeleton_are_one(tmp_path, change):
    expected = respelled(tmp_path)
    assert respelled(tmp_path, of_asf=change).recordings == expected.recordings


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s.replace("\n", "\r"),
        lambda s: s.encode("utf-16"),
        lambda s: s.replace("\n", "\n\n"),
        lambda s: s.replace(":DEGREES\n", "# a remark\n:DEGREES\n:SAMPLES-PER-SECOND 60\n\n"),
        lambda s: s.replace("back 0\n", "back 0 # still\n# nothing\n"),
        lambda s: s.replace("root", "ROOT").replace("head", "Head"),
        lambda s: s.replace("0 0 0\n", "0.0 -0 0e0\n").replace("90\n", "9.0E+01\n"),
        lambda s: s.replace("\n1\n", "\n0\n").replace("\n2\n", "\n1\n"),
        lambda s: s.replace(":FULLY-SPECIFIED\n", "").replace(":DEGREES\n", ":degrees\n"),
        lambda s: s.replace("head 90\n2", "head 90\n  2  "),
        lambda s: s.replace("root 10", "\troot\t10"),
    ],
    ids=[
        "cr", "utf-16", "blank lines", "header", "remarks", "case", "exponents", "from 0", "degrees alone", "blanks",
        "tabs",
    ],
)  # fmt: skip
def test_spellings_of_one_motion_are_one(tmp_path, change):
    expected = respelled(tmp_path)
    reading = respelled(tmp_path, of_amc=change)
    assert reading.recordings == expected.recordings
    assert reading.warnings == ()


def test_names_with_blanks(tmp_path):
    changes = [lambda s: s.replace("back", "lower back").replace("head", "head 2")] * 2
    motion = respelled(tmp_path, *changes).recordings[0]
    assert motion.skeleton.names == ("root", "lower back", "head 2")
    expected = respelled(tmp_path).recordings[0]
    np.testing.assert_array_equal(motion.local_rotations, expected.local_rotations)


@pytest.mark.parametrize("encoding", ["latin-1", "utf-8"])
def test_a_name_is_the_same_in_either_encoding(tmp_path, encoding):
    def change(text):
        return text.replace("back", "rücken").encode(encoding)

    motion = respelled(tmp_path, change, lambda s: s.replace("back", "rücken")).recordings[0]
    assert motion.skeleton.names == ("root", "rücken", "head")


@pytest.mark.parametrize(
    ("line", "rate"),
    [(":SAMPLES-PER-SECOND 60.0", 60), ("# fps: 59.94", 59.94), ("#rate 30", 30), ("# 30 takes", None)],
)
def test_a_rate_in_the_header_is_read(tmp_path, line, rate):
    reading = io.open_recording(put(tmp_path, amc=f"{line}\n{AMC}"), unit="m")
    found = reading.findings["rate"]
    assert (found.value, found.how) == ((rate, "read") if rate else (120.0, "guessed"))


def test_a_bone_without_dofs_may_have_a_line_and_one_with_may_have_none_of_its_own(tmp_path):
    still = respelled(
        tmp_path, lambda s: s.replace("    dof rx\n", ""), lambda s: s.replace("back 0\n", "back\n")
    )
    silent = respelled(
        tmp_path, lambda s: s.replace("    dof rx\n", "    dof\n"), lambda s: s.replace("back 0\n", "")
    )
    assert still.recordings == silent.recordings == respelled(tmp_path).recordings


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        (":root\n", ":rood\n", "s.asf: expected a section :root"),
        ("length 1.0", "length one", "expected a unit of length as a number"),
        (
            "dof rx",
            "dof rx rw",
            "line 17: expected degrees of freedom of bone back, each of rx.*, found 'rx rw'",
        ),
        ("dof rx", "dof rx rx", "line 17: expected degrees of freedom"),
        ("order TX TY TZ", "order TX TX TZ", "line 7: expected degrees of freedom of bone root"),
        ("axis XYZ\n  pos", "axis XYX\n  pos", "line 8: expected an order of axes such as XYZ, found 'XYX'"),
        ("axis XYZ\n  pos", "axis\n  pos", "line 8: expected an order of axes such as XYZ, found ''"),
        (
            "axis 0 0 0 XYZ\n    dof rz",
            "axis 0 0\n    dof rz",
            "line 23: expected 3 numbers for the axis of head, found 2",
        ),
        (
            "direction 0 1 0",
            "direction 0 1e300 0",
            "line 14: expected the direction of back as a number below 1e",
        ),
        ("length 2", "length", "line 18: expected a length of bone back before its end"),
        ("name head", "name back", "line 25: expected every bone once, found 'back' again"),
        ("name head", "name root", "line 25: expected every bone once, found 'root' again"),
        ("root back\n", "root tail\n", "line 28: expected bones of the section :bonedata, found 'tail'"),
        ("root back\n", "back root\n", "line 28: expected a root that hangs on no bone"),
        (
            "root back\n",
            "head back\n",
            "s.asf: expected every bone to hang on the root, bone 'back' does not",
        ),
        ("  begin\n    name", "  name", None),
    ],
)
def test_faults_of_a_skeleton_name_their_line(tmp_path, old, new, match):
    if match is None:  # a begin that is missing does no harm
        assert (
            respelled(tmp_path, lambda s: s.replace(old, new, 1)).recordings == respelled(tmp_path).recordings
        )
        return
    with pytest.raises(FormatError, match=match):
        respelled(tmp_path, lambda s: s.replace(old, new, 1))


def test_a_skeleton_of_very_many_bones_is_read_soon(tmp_path):
    bone = "begin\nname b{0}\ndirection 0 1 0\nlength 1\nend\n"
    bones = "".join(bone.format(k) for k in range(5000))
    chain = "root b4999\n" + "".join(f"b{k + 1} b{k}\n" for k in range(4999))
    text = f":root\n order tx\n:bonedata\n{bones}:hierarchy\nbegin\n{chain}end\n"
    (tmp_path / "s.asf").write_text(text)
    with bounded(3):
        skeleton = read_asf(Source(tmp_path / "s.asf", text.encode()))
    assert skeleton.parents[:3] == (-1, 0, 1)
    assert skeleton.names[:3] == ["root", "b4999", "b4998"]
