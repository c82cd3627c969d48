"""OpenSim MOT and STO: joint angles that move a body, points, and what is refused."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.body import find_roles
from leitmotion.motion import FormatError, Motion, forward_kinematics, rotations

NAMES = [
    *(f"pelvis_{word}" for word in ("tilt", "list", "rotation", "tx", "ty", "tz")),
    *(f"{word}_{side}" for side in "rl" for word in ("hip_flexion", "hip_adduction", "hip_rotation", "knee_angle",
                                                     "ankle_angle", "subtalar_angle", "mtp_angle")),
    *(f"lumbar_{word}" for word in ("extension", "bending", "rotation")),
    *(f"{word}_{side}" for side in "rl" for word in ("arm_flex", "arm_add", "arm_rot", "elbow_flex")),
]  # fmt: skip
ARMS = ("arm", "elbow")


def motion_file(angles=None, *, names=NAMES, degrees="yes", delimiter="\t", frames=3, label="{}"):
    """A MOT in which each coordinate stays as it is told, else zero."""
    angles = {"pelvis_ty": 1.0, **(angles or {})}
    head = ["Coordinates", "version=1", f"nRows={frames}", f"nColumns={len(names) + 1}", f"inDegrees={degrees}", "",
            "Angles are in degrees.", "", "endheader"]  # fmt: skip
    rows = [["time", *(label.format(name) for name in names)]]
    for k in range(frames):
        rows.append([f"{k / 50:.8f}", *(f"{angles.get(name, 0.0):.8f}" for name in names)])
    return "\n".join(head) + "\n" + "".join(delimiter.join(row) + "\n" for row in rows)


def read(tmp_path, text, name="trial.mot", **options):
    path = tmp_path / name
    path.write_text(text)
    return io.open_recording(path, **options)


def places(tmp_path, text, **options):
    (motion,) = read(tmp_path, text, **options).recordings
    assert isinstance(motion, Motion)
    return dict(zip(motion.skeleton.names, forward_kinematics(motion).positions[0]))


def test_with_all_angles_zero_the_body_stands(tmp_path):
    place = places(tmp_path, motion_file())
    np.testing.assert_allclose(place["pelvis"], [0, 1, 0])
    order = ["ankle", "knee", "hip", "elbow", "shoulder"]
    assert [place[f"left_{name}"][1] for name in order] == sorted(place[f"left_{name}"][1] for name in order)
    for name in (*order, "toe", "wrist"):
        left, right = place[f"left_{name}"], place[f"right_{name}"]
        assert right[2] > 0.05  # Z is the person's right
        np.testing.assert_allclose(left, right * [1, 1, -1])
    assert place["right_toe"][0] > place["right_ankle"][0] + 0.1  # X is forward


def test_bones_are_those_of_the_stated_stature(tmp_path):
    reading = read(tmp_path, motion_file())
    (motion,) = reading.recordings
    place = dict(zip(motion.skeleton.names, forward_kinematics(motion).positions[0]))
    shares = {
        ("hip", "knee"): 0.245,
        ("knee", "ankle"): 0.246,
        ("shoulder", "elbow"): 0.186,
        ("elbow", "wrist"): 0.146,
    }
    for (above, below), share in shares.items():
        length = np.linalg.norm(place[f"left_{above}"] - place[f"left_{below}"])
        assert length == pytest.approx(share * 1.70)
    upright = place["right_shoulder"][1] - place["right_ankle"][1] + 0.039 * 1.70
    assert upright == pytest.approx(0.818 * 1.70)
    assert (reading.findings["bones"].value, reading.findings["bones"].how) == ("1.7 m", "guessed")
    assert any("1.70 m tall, stand in" in warning for warning in reading.warnings)


@pytest.mark.parametrize(
    ("coordinate", "point", "axis", "sign"),
    [
        ("hip_flexion_r", "right_knee", 0, 1), ("hip_flexion_l", "left_knee", 0, 1),
        ("hip_adduction_r", "right_knee", 2, -1), ("hip_adduction_l", "left_knee", 2, 1),
        ("hip_rotation_r", "right_toe", 2, -1), ("hip_rotation_l", "left_toe", 2, 1),
        ("ankle_angle_r", "right_toe", 1, 1), ("ankle_angle_l", "left_toe", 1, 1),
        ("subtalar_angle_r", "right_toe", 2, -1), ("subtalar_angle_l", "left_toe", 2, 1),
        ("pelvis_tilt", "head", 0, -1), ("pelvis_list", "head", 2, 1), ("pelvis_rotation", "right_hip", 0, 1),
        ("lumbar_extension", "head", 0, -1), ("lumbar_bending", "head", 2, 1),
        ("lumbar_rotation", "right_shoulder", 0, 1),
        ("arm_flex_r", "right_elbow", 0, 1), ("arm_flex_l", "left_elbow", 0, 1),
        ("arm_add_r", "right_elbow", 2, -1), ("arm_add_l", "left_elbow", 2, 1),
        ("elbow_flex_r", "right_wrist", 0, 1), ("elbow_flex_l", "left_wrist", 0, 1),
    ],
)  # fmt: skip
def test_what_a_positive_angle_does(tmp_path, coordinate, point, axis, sign):
    moved = places(tmp_path, motion_file({coordinate: 20}))[point] - places(tmp_path, motion_file())[point]
    assert sign * moved[axis] > 0.02


@pytest.mark.parametrize("sign", [1, -1])
def test_knees_bend_backwards_in_older_and_newer_models(tmp_path, sign):
    bent = places(tmp_path, motion_file({"knee_angle_r": 90 * sign, "knee_angle_l": -2 * sign}))
    np.testing.assert_allclose(bent["right_ankle"] - bent["right_knee"], [-0.246 * 1.7, 0, 0], atol=1e-9)


def test_the_pelvis_turns_by_tilt_then_list_then_rotation(tmp_path):
    angles = {"pelvis_tilt": 30, "pelvis_list": 20, "pelvis_rotation": 40}
    (motion,) = read(tmp_path, motion_file(angles)).recordings
    expected = rotations.multiply(
        rotations.multiply(
            rotations.from_axis_angle("z", np.deg2rad(30)), rotations.from_axis_angle("x", np.deg2rad(20))
        ),
        rotations.from_axis_angle("y", np.deg2rad(40)),
    )
    np.testing.assert_allclose(np.abs((motion.local_rotations[0, 0] * expected).sum()), 1.0)


ANGLES = {"hip_flexion_r": 25.0, "knee_angle_r": -40.0, "arm_flex_l": 12.0, "pelvis_tx": 0.5}


@pytest.mark.parametrize(
    "change",
    [
        lambda **kw: motion_file(ANGLES, delimiter=",", **kw),
        lambda **kw: motion_file(ANGLES, delimiter="  ", **kw),
        lambda **kw: motion_file(ANGLES, **kw).replace("\n", "\r\n"),
        lambda **kw: motion_file(ANGLES, label="/jointset/some/{}/value", **kw),
        lambda **kw: "name trial.mot\ndatacolumns 32\ndatarows 3\nrange 0 1\nendheader\n"
        + motion_file(ANGLES, **kw).partition("endheader\n")[2],
        lambda **kw: motion_file(
            {n: v if n == "pelvis_tx" else np.deg2rad(v) for n, v in ANGLES.items()}, degrees="no", **kw
        ),
        lambda **kw: "\n".join(
            line + "," * (32 - line.count(",") - 1) if "endheader" not in line else line + ",,,"
            for line in motion_file(ANGLES, delimiter=",", **kw).splitlines()
        ) + "\n",
    ],
    ids=["commas", "blanks", "crlf", "paths", "simm", "radians", "commas-everywhere"],
)  # fmt: skip
def test_spellings_of_one_motion(tmp_path, change):
    (expected,) = read(tmp_path, motion_file(ANGLES)).recordings
    (motion,) = read(tmp_path, change()).recordings
    assert motion.rate == 50.0
    assert motion.skeleton == expected.skeleton
    np.testing.assert_allclose(motion.local_rotations, expected.local_rotations, atol=1e-7)
    np.testing.assert_allclose(motion.local_positions, expected.local_positions)


def test_joints_without_angles_are_not_invented(tmp_path):
    legs = [name for name in NAMES if not name.startswith(ARMS)]
    names = read(tmp_path, motion_file(names=legs)).recordings[0].skeleton.names
    assert {"left_shoulder", "head", "left_toe"} <= set(names)
    assert not {"left_elbow", "right_wrist"} & set(names)
    names = (
        read(tmp_path, motion_file(names=[n for n in legs if "lumbar" not in n])).recordings[0].skeleton.names
    )
    assert not {"chest", "head", "left_shoulder"} & set(names)


def test_every_role_is_found_and_columns_left_out_are_named(tmp_path):
    reading = read(tmp_path, motion_file(names=[*NAMES, "pro_sup_r", "knee_angle_r_beta"]))
    found = find_roles(reading.recordings[0])
    assert len(found.roles) == 19
    assert (found.confidence == 1.0).all()
    assert any(warning.endswith("left out: pro_sup_r.") for warning in reading.warnings)


def test_a_body_in_one_place_is_told(tmp_path):
    reading = read(tmp_path, motion_file(names=[name for name in NAMES if name[-3:-1] != "_t"]))
    assert any("does not say where the pelvis is" in warning for warning in reading.warnings)


def test_a_gap_in_the_times_keeps_the_pose(tmp_path):
    head, _, rows = motion_file(ANGLES, frames=40).partition("time")
    rows = "".join(
        row if k <= 20 else f"{float(row.split()[0]) + 2.0}\t{row.partition(chr(9))[2]}"
        for k, row in enumerate(rows.splitlines(keepends=True))
    )
    reading = read(tmp_path, head + "time" + rows)
    assert len(reading.recordings[0]) == 140
    assert any("the body keeps the pose before" in warning for warning in reading.warnings)


POINTS = "Positions\nversion=1\nnRows=2\nnColumns=13\ninDegrees=yes\nendheader\n"


@pytest.mark.parametrize(
    ("head", "header", "first"),
    [
        (POINTS, "pelvis_X pelvis_Y pelvis_Z pelvis_Ox pelvis_Oy pelvis_Oz "
                 "head_X head_Y head_Z head_Ox head_Oy head_Oz", [1, 2, 3, 9, 9, 9, 4, 5, 6, 9, 9, 9]),
        (POINTS, "pelvis_tx pelvis_ty pelvis_tz head_tx head_ty head_tz", [1, 2, 3, 4, 5, 6]),
        (POINTS, "pelvis_px pelvis_py pelvis_pz head_px head_py head_pz", [1, 2, 3, 4, 5, 6]),
        (POINTS, "pelvis_X pelvis_Y pelvis_Z head_X head_Y head_Z center_of_mass_X center_of_mass_Y center_of_mass_Z",
         [1, 2, 3, 4, 5, 6, 9, 9, 9]),
        (POINTS.replace("inDegrees=yes", "DataType=Vec3"), "pelvis head", ["1,2,3", "4,5,6"]),
    ],
    ids=["bodies", "tx", "px", "with-centre", "vec3"],
)  # fmt: skip
def test_points(tmp_path, head, header, first):
    rows = "".join("\t".join([f"{k / 50}", *map(str, first)]) + "\n" for k in range(2))
    reading = read(
        tmp_path, head + "time\t" + header.replace(" ", "\t") + "\n" + rows, "points.sto", unit="m"
    )
    (points,) = reading.recordings
    assert (points.names, points.rate, reading.findings["up"].value) == (("pelvis", "head"), 50.0, "y")
    np.testing.assert_array_equal(points.positions, [[[1, 2, 3], [4, 5, 6]]] * 2)


@pytest.mark.parametrize(
    ("head", "header", "match"),
    [
        (POINTS, "ground_force_vx ground_force_vy ground_force_vz ground_force_px ground_force_py ground_force_pz",
         "found forces: ground_force_vx, .*Read the motion itself"),
        (POINTS.replace("Positions", "Velocities"), "a_X a_Y a_Z b_X b_Y b_Z", "found speeds or accelerations: a_X"),
        (POINTS, "soleus_r.activation gasmed_r.activation", "found activations of muscles: soleus_r"),
        (POINTS, "thorax_tilt thorax_tx thorax_ty thorax_tz shoulder_ele", "found other coordinates: thorax_tilt"),
        (POINTS.replace("inDegrees=yes", "DataType=Quaternion"), "a b", "found a table of the type Quaternion"),
    ],
)  # fmt: skip
def test_what_is_no_motion_is_refused(tmp_path, head, header, match):
    rows = "".join("\t".join([f"{k / 50}", *["1"] * len(header.split())]) + "\n" for k in range(2))
    with pytest.raises(FormatError, match=match):
        read(tmp_path, head + "time\t" + header.replace(" ", "\t") + "\n" + rows)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda s: s.replace("endheader", "end"), "line endheader, found none"),
        (lambda s: s.partition("endheader")[0] + "endheader\n", "line of names"),
        (lambda s: s.partition("0.00000000")[0], "a row a time"),
        (lambda s: s.replace("time", "zeit"), "column time"),
        (lambda s: s.replace("0.04000000\t0.00000000", "0.04000000\t"),
         "pelvis_tilt in each row, found none in row 3"),
        (lambda s: s.replace("0.04000000\t0.00000000", "0.04000000\tx"), "line 13: expected a number, found 'x'"),
    ],
)  # fmt: skip
def test_faults_are_one_sentence(tmp_path, change, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, change(motion_file()))


@pytest.mark.data
def test_angles_and_markers_of_one_run_agree(data):
    motion = io.read(data / "opensim" / "subject02_running_ik.mot")
    markers = io.read(data / "opensim" / "subject02_running.trc")
    frames = min(len(motion), len(markers))
    joints = dict(
        zip(motion.skeleton.names, np.moveaxis(forward_kinematics(motion).positions[:frames], 1, 0))
    )
    seen = dict(zip(markers.names, np.moveaxis(markers.positions[:frames], 1, 0)))
    beside = {"elbow": ("Elbow",), "wrist": ("Wrist.Med", "Wrist.Lat"), "toe": ("Toe.Lat", "Toe.Med"),
              "knee": ("Thigh.Front", "Shank.Front"), "ankle": ("Heel", "Midfoot.Sup")}  # fmt: skip
    pairs = {
        f"{side}_{joint}": np.mean([seen[f"{side[0].upper()}.{name}"] for name in names], axis=0)
        for side in ("left", "right")
        for joint, names in beside.items()
    }
    pelvis = joints["pelvis"]
    arms = np.concatenate([joints[name] - pelvis for name in pairs])
    reach = np.concatenate([place - pelvis for place in pairs.values()])
    scale = (arms * reach).sum() / (
        arms * arms
    ).sum()  # the runner's size, the one thing that angles do not tell
    assert 0.9 < scale < 1.15
    for name, place in pairs.items():
        off = np.median(np.linalg.norm(pelvis + scale * (joints[name] - pelvis) - place, axis=-1))
        assert off < 0.10, f"{name} is {off:.3f} m from its markers"
        other = pairs[name.replace("left", "LEFT").replace("right", "left").replace("LEFT", "right")]
        assert (
            off < np.median(np.linalg.norm(pelvis + scale * (joints[name] - pelvis) - other, axis=-1)) / 1.5
        )


@pytest.mark.data
def test_a_squat_goes_down_on_its_feet(data):
    motion = io.read(data / "opencap" / "squats1_videoAndMocap.mot")
    place = dict(zip(motion.skeleton.names, np.moveaxis(forward_kinematics(motion).positions, 1, 0)))
    sinks = np.ptp(place["pelvis"][:, 1])
    assert sinks > 0.3
    for foot in ("left_ankle", "right_ankle"):  # near the ground: their bones are not those of this person
        assert np.ptp(place[foot][:, 1]) < 0.3 * sinks
    lowest = place["pelvis"][:, 1].argmin()
    assert place["left_knee"][lowest, 0] > place["left_hip"][lowest, 0] + 0.2  # the knee in front of the hip
    with pytest.raises(FormatError, match=r"found other coordinates: thorax_tilt.*save its markers as TRC"):
        io.read(data / "pyomeca" / "inverse_kin.mot")


BENT = {"hip_flexion_r": 40.0, "knee_angle_r": -70.0, "hip_flexion_l": -20.0, "arm_flex_r": 30.0}
SILENT = "inDegrees=yes\n"


@pytest.mark.parametrize(
    ("label", "radians", "unit"),
    [("{}", False, "degrees"), ("{}", True, "radians"), ("/jointset/some/{}/value", True, "radians")],
)
def test_a_header_that_does_not_say_what_angles_are_is_told(tmp_path, label, radians, unit):
    angles = {name: np.radians(value) if radians else value for name, value in BENT.items()}
    expected = read(tmp_path, motion_file(BENT)).recordings[0].local_rotations
    text = motion_file(angles, label=label)
    assert SILENT in text
    reading = read(tmp_path, text.replace(SILENT, ""))
    np.testing.assert_allclose(reading.recordings[0].local_rotations, expected, atol=1e-7)
    assert (reading.findings["angles"].value, reading.findings["angles"].how) == (unit, "guessed")
    assert any(f"{unit} were guessed" in warning for warning in reading.warnings)


@pytest.mark.parametrize(("word", "unit"), [("yes", "degrees"), ("no", "radians")])
def test_what_the_header_says_of_angles_is_read(tmp_path, word, unit):
    reading = read(tmp_path, motion_file({"knee_angle_r": -1.0}, degrees=word))
    assert (reading.findings["angles"].value, reading.findings["angles"].how) == (unit, "read")
    assert not any("guessed" in warning for warning in reading.warnings)


def test_a_motion_has_as_many_rows_as_its_header_promises(tmp_path):
    reading = read(tmp_path, motion_file(frames=3).replace("nRows=3", "nRows=9"))
    assert "The header promises 9 rows, the file has 3; those it has were read." in reading.warnings
