"""C3D: three processors and two kinds of storage against a plain writer and against ezc3d on real files."""

import ezc3d
import numpy as np
import pytest

from leitmotion import io
from leitmotion.motion import DataError, FormatError
from oracles.c3d import DEC, INTEL, SGI, c3d_bytes


@pytest.fixture
def walk(rng):
    """Positions (T, P, 3) of four points, millimetres, Z up."""
    places = rng.uniform(-800, 800, (12, 4, 3))
    places[:, 0, 2] += 2000  # the head
    return np.round(places, 1)


LABELS = ["HEAD", "LANK", "RANK", "LTOE"]


def y_up(places):
    return np.stack([places[..., 0], places[..., 2], -places[..., 1]], axis=-1) / 1000


def put(tmp_path, content):
    path = tmp_path / "trial.c3d"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("processor", [INTEL, DEC, SGI])
@pytest.mark.parametrize(("scale", "close"), [(-1.0, 1e-6), (0.1, 6e-5)])
@pytest.mark.parametrize("analog", [0, 6])
def test_all_processors_and_storages_say_the_same(tmp_path, walk, processor, scale, close, analog):
    residuals = np.zeros(walk.shape[:2])
    residuals[3, 1] = -1
    content = c3d_bytes(walk, LABELS, processor=processor, scale=scale, residuals=residuals, analog=analog)
    reading = io.open_recording(put(tmp_path, content))
    (markers,) = reading.recordings
    expected = y_up(walk)
    expected[3, 1] = np.nan
    np.testing.assert_allclose(markers.positions, expected, rtol=0, atol=close)
    assert markers.names == tuple(LABELS)
    assert markers.rate == 50.0
    assert (reading.findings["unit"].value, reading.findings["up"].how) == ("mm", "read")


@pytest.mark.data
@pytest.mark.parametrize(
    "name",
    ["btk/Dec_real", "btk/Eb015pr", "btk/Gait", "btk/PiG_Motion3_FF", "btk/pc_int", "pycgm/Movement_trial"],
)
def test_real_files_read_as_ezc3d_reads_them(data, name):
    path = data / f"{name}.c3d"
    markers = io.read(path)
    theirs = ezc3d.c3d(str(path))
    labels = theirs["parameters"]["POINT"]["LABELS"]["value"]
    points = theirs["data"]["points"][:3].transpose(2, 1, 0)
    assert markers.rate == pytest.approx(theirs["header"]["points"]["frame_rate"])
    for k, label in enumerate(markers.names):
        if "#" not in label:
            np.testing.assert_allclose(
                markers.positions[:, k], y_up(points[:, labels.index(label)]), atol=1e-9
            )


@pytest.mark.data
def test_the_trial_stored_by_three_processors_is_one(data):
    trials = [io.read(data / "btk" / f"{name}.c3d").positions for name in ("Dec_real", "pc_int", "sgi_int")]
    np.testing.assert_array_equal(trials[1], trials[2])
    np.testing.assert_allclose(trials[0], trials[1], atol=3e-4)  # one step of the whole numbers


@pytest.mark.data
@pytest.mark.parametrize(("name", "frames", "points"), [("Dance", 499, 40), ("golfswing", 514, 29)])
def test_files_with_wrong_headers_are_read_and_told(data, name, frames, points):
    reading = io.open_recording(data / "btk" / f"{name}.c3d")
    (markers,) = reading.recordings
    assert markers.positions.shape == (frames, points, 3)
    assert any("counts of frames disagree" in warning for warning in reading.warnings)
    # the screen's vertical is wrong in both: the dancers stand along X
    assert reading.findings["up"].value == "x"
    assert any("--up z" in warning for warning in reading.warnings)
    height = np.ptp(markers.positions[..., 1], axis=1)
    assert 1.2 < np.median(height) < 1.9
    assert abs(np.percentile(markers.positions[..., 1].min(axis=1), 50)) < 0.15


def test_computed_and_unlabelled_points_are_left_out_and_counted(tmp_path, walk):
    axes = ["PELO", "PELA", "PELL", "PELP"]
    labels = [*LABELS, "*3", "LHipAngles", *axes]
    content = c3d_bytes(np.repeat(walk[:, :1], 10, axis=1), labels, parameters={"ANGLES": ["LHipAngles"]})
    reading = io.open_recording(put(tmp_path, content))
    assert reading.recordings[0].names == tuple(LABELS)
    assert any(warning.startswith("5 points that a model computed") for warning in reading.warnings)
    assert any(warning.startswith("1 trajectories without a label") for warning in reading.warnings)


def test_subject_prefixes_are_people(tmp_path, walk):
    path = put(tmp_path, c3d_bytes(walk, ["Ann:HEAD", "Ann:LANK", "Bob:HEAD", "Bob:LANK"]))
    assert [m.names for m in io.read_all(path)] == [("HEAD", "LANK")] * 2
    with pytest.raises(DataError, match=r"2 people: Ann, Bob.*--person"):
        io.read(path)
    bob = io.read(path, person="Bob")
    np.testing.assert_allclose(bob.positions, y_up(walk)[:, 2:], atol=1e-6)
    assert bob == io.read(path, person=2)


def test_one_subject_is_taken_off_the_names(tmp_path, walk):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, [f"Ann:{label}" for label in LABELS])))
    assert reading.recordings[0].names == tuple(LABELS)
    assert reading.people == ("Ann",)


@pytest.mark.parametrize(
    "parameters",
    [
        {"LONG_FRAMES": 70000.0},
        {"TRIAL:ACTUAL_START_FIELD": (1, 0), "TRIAL:ACTUAL_END_FIELD": (70000 & 0xFFFF, 1)},
        {},
    ],
)
def test_more_frames_than_the_header_can_count(tmp_path, parameters):
    places = np.ones((1, 1, 3)) * 100
    content = c3d_bytes(places, ["HEAD"], scale=0.1, parameters=parameters, header_frames=70000)
    frame = content[-8:]
    markers = io.read(put(tmp_path, content + frame * 69999), up="z")
    assert len(markers) == 70000


def test_more_labels_than_one_parameter_holds(tmp_path, walk):
    content = c3d_bytes(walk, LABELS[:2], parameters={"LABELS2": LABELS[2:]})
    assert io.read(put(tmp_path, content)).names == tuple(LABELS)


def test_a_point_exactly_in_the_origin_is_unseen(tmp_path, walk):
    walk[2, 3] = 0
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS)))
    assert np.isnan(reading.recordings[0].positions[2, 3]).all()
    assert any("1 places lie exactly in the origin" in warning for warning in reading.warnings)


def test_without_unit_and_screen_both_are_judged(tmp_path, rng):
    places = rng.normal(np.array([[0, 0, 1700], [100, 0, 80], [-100, 0, 80], [100, -150, 10]]), 5, (30, 4, 3))
    content = c3d_bytes(places, LABELS, parameters={"UNITS": None, "X_SCREEN": None, "Y_SCREEN": None})
    findings = io.open_recording(put(tmp_path, content)).findings
    assert [(findings[key].value, findings[key].how) for key in ("unit", "up")] == [
        ("mm", "guessed"),
        ("z", "guessed"),
    ]


@pytest.mark.parametrize(
    ("cut", "match"),
    [(100, "mark 0x50"), (600, "labelled|points|frame|data|scale"), (1024 + 30, "whole frame")],
)
def test_cut_short_is_one_sentence(tmp_path, walk, cut, match):
    content = c3d_bytes(walk, LABELS)
    with pytest.raises(FormatError, match=match):
        io.read(put(tmp_path, content[:cut]))


def test_cut_within_the_data_reads_the_whole_frames(tmp_path, walk):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS)[:-70]))
    assert len(reading.recordings[0]) == 10
    assert any("promises 12 frames, the file holds 10" in warning for warning in reading.warnings)


def test_no_rate_asks_for_one(tmp_path, walk):
    path = put(tmp_path, c3d_bytes(walk, LABELS, rate=0.0))
    with pytest.raises(FormatError, match="--rate"):
        io.read(path)
    assert io.read(path, rate=60).rate == 60
