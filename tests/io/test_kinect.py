"""Tables of a Kinect without names: joints by their number, axes and sides against geometry and a Vicon."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import leitmotion as lm
from leitmotion import io
from leitmotion.io.joint_sets import AZURE, KINECT_1, KINECT_2
from leitmotion.motion import FormatError


def rows(values, mark=" "):
    return "\n".join(mark.join(f"{value:.6f}" for value in row.ravel()) for row in values) + "\n"


@pytest.fixture
def person():
    """Named places of a person of 1.7 m who faces the camera: y up, z away from it, the left at smaller x."""
    half = {
        "Shoulder": (0.2, 1.4), "Elbow": (0.25, 1.1), "Wrist": (0.27, 0.85), "Hand": (0.27, 0.78), "Hip": (0.1, 0.9),
        "Knee": (0.1, 0.5), "Ankle": (0.1, 0.08), "Clavicle": (0.05, 1.4), "HandTip": (0.27, 0.7), "Thumb": (0.25, 0.8),
        "Eye": (0.03, 1.65), "Ear": (0.07, 1.62),
    }  # fmt: skip
    places = {
        "Head": (0, 1.6, 3), "Neck": (0, 1.45, 3), "ShoulderCenter": (0, 1.45, 3), "SpineShoulder": (0, 1.4, 3),
        "Spine": (0, 1.1, 3), "SpineMid": (0, 1.15, 3), "SpineBase": (0, 0.92, 3), "HipCenter": (0, 0.92, 3),
        "Pelvis": (0, 0.92, 3), "SpineNavel": (0, 1.1, 3), "SpineChest": (0, 1.25, 3), "Nose": (0, 1.6, 2.9),
    }  # fmt: skip
    for side, sign in (("Left", -1), ("Right", 1)):
        places |= {f"{part}{side}": (sign * x, y, 3.0) for part, (x, y) in half.items()}
        places[f"Foot{side}"] = (sign * 0.1, 0.03, 2.85)
    return places


@pytest.mark.parametrize("numbers", [3, 7])
@pytest.mark.parametrize("mark", [" ", ",", ";", "\t"])
@pytest.mark.parametrize("joints", [KINECT_1, KINECT_2, AZURE])
def test_joints_are_told_by_their_number_and_left_is_left(tmp_path, person, joints, mark, numbers):
    values = np.ones((40, len(joints.joints), numbers))
    values[..., :3] = [person[name] for name in joints.joints]
    values[:, :, 0] += np.linspace(0, 0.2, 40)[:, None]
    if joints is AZURE:
        values[..., :3] *= [1000, -1000, 1000]
        values[..., 0] *= -1  # with y down and z away, the left of who faces the camera is at larger x
    (tmp_path / "a.txt").write_text(rows(values, mark))
    told = lm.info(tmp_path / "a.txt")
    assert told.names == joints.joints
    assert told.findings["joints"].how == "guessed"
    assert (told.findings["unit"].value, told.findings["up"].value) == (
        ("mm", "-y") if joints is AZURE else ("m", "y")
    )
    assert {"head", "left_wrist", "left_toe", "right_knee"} <= set(told.roles.roles)
    assert told.findings["size"].value == pytest.approx(1.49, abs=0.05)
    facing = 0.0 if joints is AZURE else np.pi  # towards the camera, which Azure's axes have at the other end
    assert abs(abs(told.findings["facing"].value) - facing) < 1e-6
    assert not told.problems
    (tmp_path / "stdin").write_text(rows(values, mark))
    assert io.read(tmp_path / "stdin").names == joints.joints


def test_joints_in_the_origin_are_unseen_and_counted(tmp_path, person):
    values = np.repeat(np.array([person[name] for name in KINECT_2.joints])[None], 30, axis=0)
    values[4:9, 2] = 0.0
    (tmp_path / "a.csv").write_text(rows(values, ","))
    reading = io.open_recording(tmp_path / "a.csv")
    assert np.isnan(reading.recordings[0].positions[4:9, 2]).all()
    assert np.isnan(reading.recordings[0].positions).sum() == 15
    assert any("5 places lie exactly in the origin" in warning for warning in reading.warnings)


def test_other_lengths_and_words_are_no_table_of_a_kinect(tmp_path):
    (tmp_path / "stdin").write_text(rows(np.zeros((4, 11, 3))))
    with pytest.raises(FormatError, match="expected a first line that names the columns, found 33 numbers"):
        io.read(tmp_path / "stdin")
    (tmp_path / "a.txt").write_text(rows(np.ones((4, 25, 3))) + "1 2 3\n" + rows(np.ones((4, 25, 3))))
    with pytest.raises(FormatError, match="line 5: expected 75 numbers"):
        io.read(tmp_path / "a.txt")


@pytest.mark.data
def test_keraal_kinect_faces_the_camera_and_is_no_mirror_image_of_the_vicon(data):
    kinect = io.read(data / "keraal" / "G3-Kinect-CTK-P1T1-Unknown-C-0.txt")
    assert kinect.names == KINECT_2.joints
    assert len(kinect) == 197
    assert kinect.kind == "joint"
    told = lm.info(kinect)
    assert 1.3 < told.findings["size"].value < 1.45
    assert abs(abs(np.degrees(told.findings["facing"].value)) - 180) < 20
    at = dict(zip(kinect.names, np.nanmean(kinect.positions, axis=0)))
    for side in ("Left", "Right"):
        assert at[f"Foot{side}"][2] < at[f"Ankle{side}"][2]  # toes towards the camera
        assert at[f"Knee{side}"][2] < at[f"Hip{side}"][2]  # a person who sits

    vicon = io.read(data / "keraal" / "G3-Vicon-CTK-P1T1-Unknown-C-0.txt")
    assert len(vicon) == 390
    assert vicon.rate == 60.0
    pairs = {
        f"{part}{side}": f"{side}{part}"
        for part in ("Hand", "Foot", "Shoulder")
        for side in ("Left", "Right")
    }
    pairs |= {"Head": "Head", "SpineBase": "Hips"}
    a = kinect.positions[:, [kinect.names.index(name) for name in pairs]].reshape(-1, 3)
    frames = np.linspace(0, len(vicon) - 1, len(kinect)).round().astype(int)
    b = vicon.positions[frames][:, [vicon.names.index(name) for name in pairs.values()]].reshape(-1, 3)
    a, b = a - a.mean(axis=0), b - b.mean(axis=0)

    def apart(places):
        turn, _ = Rotation.align_vectors(b, places)
        return np.sqrt(((turn.apply(places) - b) ** 2).sum(axis=1).mean())

    assert apart(a) < 0.15
    assert apart(a * [-1, 1, 1]) > 2 * apart(a)


@pytest.mark.parametrize("joints", [KINECT_1, KINECT_2, AZURE])
def test_a_table_with_names_has_all_roles(tmp_path, person, joints):
    header = ",".join(f"{name}_{axis}" for name in joints.joints for axis in "XYZ")
    values = np.repeat(np.array([person[name] for name in joints.joints])[None], 40, axis=0)
    (tmp_path / "a.csv").write_text(f"{header}\n{rows(values, ',')}")
    told = lm.info(tmp_path / "a.csv", rate=30)
    limbs = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe")
    sided = {f"{side}_{limb}" for side in ("left", "right") for limb in limbs}
    assert sided | {"pelvis", "neck", "head"} <= set(told.roles.roles)
