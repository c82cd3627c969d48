"""Tables as motion-capture programs and pose estimators lay them out: several rows of header, a row a point, angles."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.io.joint_sets import BLAZEPOSE
from leitmotion.motion import FormatError

EXPECTED = np.array([[[1, 2, 3], [4, 5, 6]], [[1.5, 2.5, 3.5], [np.nan] * 3], [[2, 3, 4], [5, 6, 7]]])


def read(tmp_path, text, name="points.csv", **options):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8", newline="")
    return io.open_recording(path, **{"up": "y", **options})


# --- OptiTrack Motive

MOTIVE = """Format Version,1.23,Take Name,Take 5,Capture Frame Rate,50.000000,Export Frame Rate,50.000000,\
Rotation Type,Quaternion,Length Units,Centimeters,Coordinate Space,Global

,Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Marker,Marker,Marker
,Name,Hat,Hat,Hat,Hat,Hat,Hat,Hat,M 1,M 1,M 1
,ID,1,1,1,1,1,1,1,2,2,2
,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,Position,Position
Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z
0,0.000000,0,0,0,1,1,2,3,4,5,6
1,0.020000,0,0,0,1,1.5,2.5,3.5,,,
2,0.040000,0,0,0,1,2,3,4,5,6,7
"""


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s,
        lambda s: "\ufeff" + s.replace("\n", "\r\n"),
        lambda s: s.replace(",Type,", ",,").replace(",Name,", ",,").replace(",ID,", ",,"),
        lambda s: s.replace("\n,,Rotation", "\n,Parent,,,,,,,,,,\n,,Rotation"),
        lambda s: s.replace(
            "\n\n", "\n\n\n"),
    ],
    ids=["1.23", "crlf", "unlabelled", "parents", "blank-lines"],
)  # fmt: skip
def test_markers_and_rigid_bodies_of_motive(tmp_path, change):
    reading = read(tmp_path, change(MOTIVE))
    (points,) = reading.recordings
    assert (points.names, points.rate, points.name) == (("Hat", "M 1"), 50.0, "Take 5")
    np.testing.assert_allclose(points.positions, EXPECTED / 100)
    assert [reading.findings[topic].how for topic in ("unit", "rate")] == ["read", "read"]
    assert any("4 columns that are no points were left out: Hat rotation X" in w for w in reading.warnings)


def test_bones_of_motive_are_joints_of_their_skeletons(tmp_path):
    text = MOTIVE.replace("Rigid Body", "Bone").replace("Hat", "Ann:Hip")
    (points,) = read(tmp_path, text).recordings
    assert (points.names, points.kind) == (("Hip",), "joint")
    bones = text.replace("Marker,Marker,Marker", "Bone,Bone,Bone").replace("M 1", "Bob:Hip")
    assert read(tmp_path, bones).people == ("Ann", "Bob")


def test_what_motive_expects_gives_way_to_what_it_saw(tmp_path):
    text = MOTIVE.replace("Marker,Marker,Marker", "Rigid Body Marker,Rigid Body Marker,Rigid Body Marker")
    assert read(tmp_path, text).recordings[0].names == ("Hat",)
    assert read(tmp_path, MOTIVE.replace("M 1", "Unlabeled 7")).recordings[0].names == ("Hat",)


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        (
            "Hat,Hat,Hat,Hat,Hat,Hat,Hat,M 1,M 1,M 1",
            ",".join(["Unlabeled 7"] * 10),
            "found none but unlabelled ones. Label",
        ),
        ("Space,Global", "Space,Local", "found places in each parent's frame. Export it with"),
        ("Position", "Mean Marker Error", "expected positions of markers, rigid bodies or bones, found none"),
        ("Frame,Time", "Image,Time", "one that begins with Frame, found none"),
        ("1.5,2.5", "x,2.5", "line 9: expected a number, found 'x'"),
        (",Name,Hat", ',Name,"Hat"\x00"', "NUL bytes"),
    ],
)
def test_faults_of_a_motive_csv_are_one_sentence(tmp_path, old, new, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, MOTIVE.replace(old, new))


# --- Vicon Nexus

NEXUS = """Trajectories
50
,,Ann:A,,,Ann:B,,
Frame,Sub Frame,X,Y,Z,X,Y,Z
,,mm,mm,mm,mm,mm,mm
7,0,1,2,3,4,5,6
8,0,1.5,2.5,3.5,,,
9,0,2,3,4,5,6,7
"""
DEVICES = "Devices\n1000\n,,Force,,\nFrame,Sub Frame,Fx,Fy,Fz\n,,N,N,N\n1,0,9,9,9\n\n"


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s,
        lambda s: s.replace("\n", "\r\n"),
        lambda s: "\ufeff\n\n" + s,
        lambda s: DEVICES + s,
        lambda s: s + "\n" + DEVICES,
        lambda s: s.replace(",", "\t"),
        lambda s: s.replace("8,0,1.5,2.5,3.5,,,", "8,0,1.5,2.5,3.5"),
    ],
    ids=["plain", "crlf", "blank-lines", "after-devices", "before-devices", "tabs", "short-row"],
)
def test_trajectories_of_nexus(tmp_path, change):
    reading = read(tmp_path, change(NEXUS))
    (points,) = reading.recordings
    assert (points.names, points.rate, reading.people, reading.warnings) == (("A", "B"), 50.0, ("Ann",), ())
    np.testing.assert_allclose(points.positions, EXPECTED / 1000)


def test_nexus_may_leave_its_units_out_and_have_two_subjects(tmp_path):
    text = NEXUS.replace(",,mm,mm,mm,mm,mm,mm\n", "").replace("Ann:B", "Bob:B")
    reading = read(tmp_path, text, unit="m")
    assert reading.people == ("Ann", "Bob")
    np.testing.assert_array_equal(reading.recordings[1].positions, EXPECTED[:, 1:])


@pytest.mark.parametrize(
    ("text", "match"),
    [
        (DEVICES, "expected a section Trajectories, found Devices. Export"),
        (NEXUS.replace("Frame,Sub", "Image,Sub"), "row that begins with Frame, found Image"),
        (NEXUS[:30], "expected rate, markers, axes and units|one line|row a frame|begins with Frame"),
        (NEXUS.replace("1.5,", "x,"), "line 7: expected a number, found 'x'"),
    ],
)
def test_faults_of_a_nexus_csv_are_one_sentence(tmp_path, text, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, text)


# --- DeepLabCut

DLC = """scorer,net,net,net,net,net,net
bodyparts,nose,nose,nose,left_ankle,left_ankle,left_ankle
coords,x,y,likelihood,x,y,likelihood
0,100,50,0.5,110,300,1.0
1,101,51,0.25,,,
2,102,52,0.75,112,302,0.5
"""


def test_a_network_s_points_are_pixels_with_its_confidence(tmp_path):
    reading = read(tmp_path, DLC, up=None)
    (points,) = reading.recordings
    assert (points.names, points.unit, points.rate) == (("nose", "left_ankle"), "px", 30.0)
    assert (reading.findings["up"].value, reading.findings["rate"].how) == ("-y", "guessed")
    np.testing.assert_array_equal(points.positions[0], [[100, -50], [110, -300]])
    np.testing.assert_array_equal(points.confidence, [[0.5, 1.0], [0.25, 0.0], [0.75, 0.5]])
    assert any("30 frames per second were guessed" in warning for warning in reading.warnings)
    assert read(tmp_path, DLC, rate=25).findings["rate"].how == "given"


def test_individuals_are_people(tmp_path):
    lines = DLC.splitlines()
    lines.insert(1, "individuals,Ann,Ann,Ann,Bob,Bob,Bob")
    reading = read(tmp_path, "\n".join(lines) + "\n")
    assert reading.people == ("Ann", "Bob")
    np.testing.assert_array_equal(reading.recordings[1].confidence, [[1.0], [0.0], [0.5]])


def test_faults_of_a_deeplabcut_csv_are_one_sentence(tmp_path):
    with pytest.raises(FormatError, match="expected rows bodyparts and coords"):
        read(tmp_path, DLC.replace("coords", "places"))


# --- a row a point

LONG = """frame,name,x,y,z
1,A,1,2,3
1,B,4,5,6
3,B,5,6,7
3,A,2,3,4
2,A,1.5,2.5,3.5
"""


@pytest.mark.parametrize(
    "change",
    [
        lambda s: "# rate: 50\n" + s,
        lambda s: s.replace("frame", "time").replace("\n1", "\n0").replace("\n2", "\n0.02").replace("\n3", "\n0.04"),
        lambda s: "# fps = 50\n" + s.replace("name", "Keypoint").replace(",", "\t"),
        lambda s: "# rate: 50\n" + s.replace("name", "marker") + "2,B,,nan,\n",
    ],
    ids=["frames", "times", "tabs", "missing"],
)  # fmt: skip
def test_a_row_a_point(tmp_path, change):
    (points,) = read(tmp_path, change(LONG), unit="m").recordings
    assert (points.names, points.rate) == (("A", "B"), 50.0)
    np.testing.assert_array_equal(points.positions, EXPECTED)


def test_long_tables_of_people_with_confidence(tmp_path):
    text = "frame,person,keypoint,x,y,score\n0,1,nose,10,20,0.5\n0,2,nose,300,20,1\n2,1,nose,11,21,0.25\n"
    reading = read(tmp_path, text)
    assert (reading.people, len(reading.recordings[0])) == (("1", "2"), 2)
    np.testing.assert_array_equal(reading.recordings[0].confidence, [[0.5], [0.25]])
    with pytest.raises(FormatError, match=r"'nose' twice in 0.*track_id"):
        read(tmp_path, text.replace("0,2,", "0,1,"))
    with pytest.raises(FormatError, match="expected 6 cells in row 2 of the table, found 5"):
        read(tmp_path, text.replace("300,20,", "300,"))
    with pytest.raises(FormatError, match="expected a number, found 'oops'"):
        read(tmp_path, text.replace("300", "oops"))


# --- what a header may hold beside points


def test_angles_speeds_and_quaternions_are_no_points(tmp_path):
    words = ["A_x", "A_y", "A_z", "A_rot_x", "A_rot_y", "A_rot_z", "A_qx", "B angle x", "B angle y", "B angle z",
             "knee_flexion", "C_velocity_x", "C_velocity_y", "C_velocity_z"]  # fmt: skip
    text = "time," + ",".join(words) + "\n" + "".join(f"{k / 10}{',1' * len(words)}\n" for k in range(3))
    reading = read(tmp_path, text, unit="m")
    assert reading.recordings[0].names == ("A",)
    assert any("11 columns that are no points were left out: A_rot_x" in w for w in reading.warnings)
    only = "time,hip_angle_x,hip_angle_y,hip_angle_z\n0,1,2,3\n1,1,2,3\n"
    with pytest.raises(FormatError, match=r"columns such as NAME_x.*found time, hip_angle_x"):
        read(tmp_path, only)


def test_numbered_landmarks_have_their_visibility(tmp_path):
    header = ",".join(f"{letter}{k}" for k in range(3) for letter in ("x", "y", "z", "visibility"))
    text = f"frame,{header}\n" + "".join(f"{k},1,2,3,0.5,4,5,6,1,7,8,9,0\n" for k in range(4))
    reading = read(tmp_path, text, unit="m")
    (points,) = reading.recordings
    assert points.names == ("0", "1", "2")
    np.testing.assert_array_equal(points.confidence[0], [0.5, 1.0, 0.0])
    assert reading.findings["rate"].how == "guessed"


def landmarks(style, middle, *, start=0):
    joints = [name.lower() for name in BLAZEPOSE.joints]
    height = {"nose": 0.0, "left_hip": 0.5, "right_hip": 0.5, "left_ankle": 1.0, "right_ankle": 1.0}
    header, row = [], []
    for k, name in enumerate(joints):
        word = str(k + start) if style == "numbered" else f"_{name.upper()}"
        side = 0.1 if name.startswith("left") else -0.1
        header += [f"{letter}{word}" if style == "numbered" else f"{word[1:]}_{letter}"
                   for letter in ("x", "y", "z", "visibility")]  # fmt: skip
        row += [f"{middle + side}", f"{middle - 0.5 + height.get(name, 0.3)}", "-0.2", "0.9"]
    return f"frame,{','.join(header)}\n" + "".join(f"{k},{','.join(row)}\n" for k in range(4))


@pytest.mark.parametrize("start", [0, 1])
@pytest.mark.parametrize("style", ["numbered", "named"])
def test_landmarks_of_blazepose_by_number_or_name(tmp_path, style, start):
    reading = read(tmp_path, landmarks(style, 0.5, start=start), up=None)
    (points,) = reading.recordings
    assert (points.names, points.kind, points.unit) == (BLAZEPOSE.joints, "joint", "relative")
    assert (points.positions.shape[2], reading.findings["up"].value) == (2, "-y")
    assert any("depth of the points is no length" in warning for warning in reading.warnings)
    (points,) = read(tmp_path, landmarks(style, 0.0, start=start), up=None).recordings
    assert (points.unit, points.positions.shape[2]) == ("m", 3)
    nose, ankle = (points.positions[0, points.names.index(name)] for name in ("nose", "left_ankle"))
    np.testing.assert_allclose(nose[1] - ankle[1], 1.0)


@pytest.mark.parametrize(
    ("comment", "topic", "value"),
    [("# unit: mm", "unit", "mm"), ("# up = z", "up", "z"), ("# Unit: centimetres", "unit", "cm"),
     ("# rate: 59.94 Hz", "rate", 59.94), ("# recorded at fps 25", "rate", 25.0), ("# rate: 1e2", "rate", 100.0)],
)  # fmt: skip
def test_what_a_table_states_counts(tmp_path, comment, topic, value):
    rate = "" if topic == "rate" else "# rate: 50\n"
    reading = read(tmp_path, f"{comment}\n{rate}A_x,A_y,A_z\n1,2,3\n1,2,3\n", up=None)
    assert (reading.findings[topic].value, reading.findings[topic].how) == (value, "read")


def test_an_unknown_unit_is_told_and_times_overrule_a_rate_that_is_not_theirs(tmp_path):
    text = "# unit: furlong\n# rate: 10\ntime,A_x,A_y,A_z\n" + "".join(
        f"{k / 50},1,2,{k}\n" for k in range(9)
    )
    reading = read(tmp_path, text)
    assert reading.recordings[0].rate == 50.0
    assert any("'furlong' is none of m, cm, mm" in warning for warning in reading.warnings)
    assert any("10 Hz is stated, but the times tell another" in warning for warning in reading.warnings)


@pytest.mark.parametrize("rate", ["1e308", "1e-300", "0", "none"])
def test_a_rate_beyond_reason_is_none(tmp_path, rate):
    text = f"# rate: {rate}\ntime,A_x,A_y,A_z\n0,1,2,3\n0.02,1,2,3\n"
    assert read(tmp_path, text, unit="m").recordings[0].rate == 50.0


def test_numbers_of_frames_that_leap_are_missing_frames(tmp_path):
    text = "# rate: 50\nframe,A_x,A_y,A_z\n" + "".join(f"{k},{k},2,3\n" for k in (5, 6, 7, 10, 11, 12))
    reading = read(tmp_path, text, unit="m")
    np.testing.assert_array_equal(
        reading.recordings[0].positions[:, 0, 0], [5, 6, 7, np.nan, np.nan, 10, 11, 12]
    )
    assert any("2 frames are missing where the numbers" in warning for warning in reading.warnings)
    again = text.replace("\n7,", "\n5,")  # these count nothing
    assert len(read(tmp_path, again, unit="m").recordings[0]) == 6


def test_a_table_of_points_in_a_plane_is_a_video_s(tmp_path):
    text = "image,head_x,head_y\n" + "".join(f"{k}.jpg,1.{k},2\n" for k in range(4))
    reading = read(tmp_path, text)
    assert (reading.findings["rate"].value, reading.findings["rate"].how) == (30.0, "guessed")
    with pytest.raises(FormatError, match=r"column of times, found none.*--rate HZ"):
        read(tmp_path, "frame,A_x,A_y,A_z\n1,1,2,3\n2,1,2,3\n")


@pytest.mark.parametrize(
    ("header", "row", "up"),
    [
        ("head_x,head_y,left_ankle_x,left_ankle_y", "0.1,0.9,0.1,0.2", "y"),
        ("head_x,head_y,left_ankle_x,left_ankle_y", "0.1,0.2,0.1,0.9", "-y"),
        ("head_x,head_y,left_ankle_x,left_ankle_y", "0.1,0.5,0.9,0.5", "-y"),  # who lies
        ("A_x,A_y,B_x,B_y", "0.1,0.1,0.9,0.1", "-y"),
    ],
)
def test_rows_of_a_picture_count_downwards(tmp_path, header, row, up):
    text = f"time,{header}\n" + "".join(f"{k / 30},{row}\n" for k in range(9))
    assert read(tmp_path, text, up=None).findings["up"].value == up


def test_exponential_maps_are_told_from_other_numbers(tmp_path):
    row = "1.5,17.7,-29.1," + ",".join(["-0", "0.366519143"] * 57) + "\n"
    with pytest.raises(FormatError, match=r"exponential map files are not read.*AMC or BVH"):
        read(tmp_path, row * 3, "jumping_1.txt")


@pytest.mark.parametrize("name", ["joints.csv", "jumping_1.txt", "joints.tsv", "joints.odd"])
@pytest.mark.parametrize("mark", [",", " ", "\t"])
def test_bare_numbers_are_one_sentence(tmp_path, name, mark):
    text = (mark.join(["1.5", "-0", "2e-3"]) + "\n") * 5
    with pytest.raises(FormatError, match=r"found 3 numbers and no names.*time,head_x"):
        read(tmp_path, text, name)


def test_a_quote_that_never_closes_is_one_sentence(tmp_path):
    text = 'time,"A_x,A_y,A_z\n' + "0,1,2,3\n" * 40_000
    with pytest.raises(FormatError, match="expected that quotes which open in a cell close there"):
        read(tmp_path, text)


@pytest.mark.data
def test_real_landmarks_of_a_video(data):
    for path in sorted((data / "ground_guide").glob("*.csv"))[::7]:
        reading = io.open_recording(path)
        (points,) = reading.recordings
        assert (points.positions.shape[1:], points.unit, points.rate) == ((8, 2), "relative", 30.0)
        assert (reading.findings["up"].value, reading.findings["rate"].how) == ("-y", "guessed")
        place = dict(zip(points.names, np.nanmedian(points.positions, axis=0)))
        assert place["left_shoulder"][1] > place["left_hip"][1]  # upright
        assert (
            place["left_shoulder"][0] > place["right_shoulder"][0]
        )  # who faces the camera has the left at its right


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "match"),
    [
        ("cmu86/4d/amc_86_01.4d", "Angles alone make no body: read the AMC"),
        ("cmu_amc/trials.csv", "columns such as NAME_x"),
        ("deepmimic/humanoid3d_walk.txt", r"DeepMimic files are not read.*convert it to BVH"),
        ("mocaptoolbox/mcdemodata.mat", "MATLAB files are not read"),
        ("dm_control/test_trajectories.h5", "HDF5 files are not read"),
    ],
)
def test_real_files_that_are_no_tables_of_points(data, name, match):
    with pytest.raises(FormatError, match=match):
        io.read(data / name)
