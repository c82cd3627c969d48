"""C3D: three processors and two kinds of storage against a plain writer and against ezc3d on real files."""

import warnings

import c3d
import ezc3d
import numpy as np
import pytest

from leitmotion import io
from leitmotion.io.c3d import _positions
from leitmotion.io.c3d_layout import find_layout
from leitmotion.io.c3d_parameters import read_header
from leitmotion.io.reading import Source
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


LONG = {
    "the first block only": ({}, {}),
    "LONG_FRAMES": ({"LONG_FRAMES": 70000.0}, {}),
    "LONG_FRAMES in two words": ({"LONG_FRAMES": (70000 & 0xFFFF, 1)}, {}),
    "FRAMES as a float": ({"FRAMES": 70000.0}, {}),
    "FRAMES is -1": ({"FRAMES": (-1,)}, {}),
    "the field's end": (
        {"TRIAL:ACTUAL_START_FIELD": (1, 0), "TRIAL:ACTUAL_END_FIELD": (70000 & 0xFFFF, 1)},
        {},
    ),
    "the field's end alone": ({"TRIAL:ACTUAL_END_FIELD": (70000 & 0xFFFF, 1)}, {}),
    "the field's end as a float": ({"TRIAL:ACTUAL_END_FIELD": 70000.0}, {}),
    "wrapped at 16 bits": ({"FRAMES": (70000 & 0xFFFF,)}, {4: 70000 & 0xFFFF}),
    "FRAMES wrapped only": ({"FRAMES": (70000 & 0xFFFF,)}, {}),
    "from a later frame on": (
        {"TRIAL:ACTUAL_START_FIELD": (101, 0), "TRIAL:ACTUAL_END_FIELD": (70100 & 0xFFFF, 1)},
        {3: 101},
    ),
}


@pytest.mark.parametrize("pad", [0, 500])
@pytest.mark.parametrize("how", LONG)
def test_more_frames_than_the_header_can_count(tmp_path, how, pad):
    parameters, header = LONG[how]
    places = np.full((1, 1, 3), 100.0)
    content = c3d_bytes(places, ["HEAD"], scale=0.1, parameters=parameters, header=header, repeat=70000)
    reading = io.open_recording(put(tmp_path, content + b"\0" * pad), up="z")
    assert len(reading.recordings[0]) == 70000
    assert reading.warnings == ()


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
    [
        (1, "mark 0x50 .* found none"),
        (100, "512 bytes, found the end after 100"),
        (600, "labelled|points|frame|data|scale"),
        (1024 + 30, "whole frame"),
    ],
)
def test_cut_short_is_one_sentence(tmp_path, walk, cut, match):
    content = c3d_bytes(walk, LABELS)
    with pytest.raises(FormatError, match=match):
        io.read(put(tmp_path, content[:cut]))


@pytest.mark.parametrize("promise", [{}, {"LONG_FRAMES": 1e9}, {"FRAMES": 1e9}])
def test_a_promise_of_countless_frames_reads_those_there_are(tmp_path, walk, promise):
    content = c3d_bytes(walk, LABELS, header={4: 65535}, parameters=promise)
    reading = io.open_recording(put(tmp_path, content))
    assert len(reading.recordings[0]) == len(walk)
    assert any(warning.endswith("the file holds 12; 12 were read.") for warning in reading.warnings)


def test_cut_within_the_data_reads_the_whole_frames(tmp_path, walk):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS)[:-70]))
    assert len(reading.recordings[0]) == 10
    assert any("promises 12 frames, the file holds 10" in warning for warning in reading.warnings)


def test_no_rate_asks_for_one(tmp_path, walk):
    path = put(tmp_path, c3d_bytes(walk, LABELS, rate=0.0))
    with pytest.raises(FormatError, match="--rate"):
        io.read(path)
    assert io.read(path, rate=60).rate == 60


def test_data_beyond_the_promised_frames_are_told(tmp_path, walk):
    reading = io.open_recording(put(tmp_path, c3d_bytes(np.tile(walk, (2, 1, 1)), LABELS, header={4: 12})))
    np.testing.assert_allclose(reading.recordings[0].positions, y_up(walk), atol=1e-6)
    assert reading.warnings == ("The header promises 12 frames, the file would hold 24; 12 were read.",)


# --- what is said twice, or not at all


@pytest.mark.parametrize("scale", [-1.0, 0.1])
@pytest.mark.parametrize(
    ("parameters", "header", "told"),
    [
        ({"USED": (5,)}, {}, "number of points is 4 in the first block, 5 in POINT:USED; 4 was taken, with which"),
        ({}, {1: 3}, "number of points is 3 in the first block, 4 in POINT:USED; 4 was taken, with which"),
        ({"USED": None}, {}, None),
        ({}, {1: 0}, None),
        ({"DATA_START": (9,)}, {}, "first block of data is 3 in the first block, 9 in POINT:DATA_START; 3 was"),
        ({"DATA_START": (3,)}, {8: 4}, "first block of data is 4 in the first block, 3 in POINT:DATA_START; 3 was"),
        ({"DATA_START": (3,)}, {8: 0}, None),
        ({"DATA_START": None}, {8: 0}, None),
        ({"DATA_START": (0,)}, {8: 60000}, None),
        ({}, {2: 5}, "analog numbers in a frame is 5 in the first block, 2 in ANALOG:USED; 2 was taken, with"),
        ({"ANALOG:USED": (9,)}, {}, None),
        ({"SCALE": None}, {}, None),
        ({"SCALE": 0.0}, {}, None),
        ({"SCALE": float("nan")}, {}, None),
        ({}, {6: 0.0}, None),
        ({"FRAMES": (11,)}, {}, "counts of frames disagree: 120 were read, but POINT:FRAMES 11"),
        ({"FRAMES": (120,)}, {4: 119}, "counts of frames disagree: 120 were read, but the first block 119"),
        ({}, {4: 0, 3: 1}, "promises 0 frames, the file holds 120; 120 were read"),
        ({"FRAMES": (120,)}, {4: 0, 3: 1}, None),
    ],
)  # fmt: skip
def test_the_length_of_the_file_tells_which_of_two_statements_is_true(
    tmp_path, walk, parameters, header, told, scale
):
    walk = np.tile(walk, (10, 1, 1))
    content = c3d_bytes(walk, LABELS, scale=scale, analog=2, parameters=parameters, header=header)
    reading = io.open_recording(put(tmp_path, content))
    np.testing.assert_allclose(reading.recordings[0].positions, y_up(walk), atol=6e-5)
    if told is None:
        assert reading.warnings == ()
    else:
        assert len(reading.warnings) == 1
        assert told in reading.warnings[0]


@pytest.mark.parametrize(("own", "scale"), [(-0.1, 0.1), (0.1, -0.1)])
def test_a_scale_of_the_wrong_sign_is_told_by_the_length(tmp_path, own, scale):
    walk = np.random.default_rng(1).uniform(-900, 900, (40, 4, 3))
    content = c3d_bytes(walk, LABELS, scale=own, header={6: scale})
    reading = io.open_recording(put(tmp_path, content), up="z")
    np.testing.assert_allclose(reading.recordings[0].positions, y_up(walk), atol=6e-5)
    assert any("way of storing numbers" in warning for warning in reading.warnings)


def test_two_scales_are_told_and_the_parameter_taken(tmp_path, walk):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS, scale=0.1, header={6: 0.2})), up="z")
    np.testing.assert_allclose(reading.recordings[0].positions, y_up(walk), atol=6e-5)
    said = "0.2 in the first block, 0.1 in POINT:SCALE; 0.1 was taken"
    assert any(said in warning for warning in reading.warnings)


def test_whole_numbers_without_a_scale_are_taken_as_they_are(tmp_path):
    walk = np.random.default_rng(1).integers(-900, 900, (70, 4, 3)) * 1.0
    content = c3d_bytes(walk, LABELS, scale=1.0, header={6: 0.0}, parameters={"SCALE": None})
    reading = io.open_recording(put(tmp_path, content), up="z")
    np.testing.assert_allclose(reading.recordings[0].positions, y_up(walk), atol=1e-9)
    assert any("states no scale" in warning for warning in reading.warnings)


@pytest.mark.parametrize(
    ("stated", "header", "rate", "told"),
    [
        (119.88, 119.88, 119.88, False),
        (None, 60.0, 60.0, False),
        (0.0, 60.0, 60.0, False),
        (float("nan"), 60.0, 60.0, False),
        (-1.0, 60.0, 60.0, False),
        (100.0, 0.0, 100.0, False),
        (100.0, float("nan"), 100.0, False),
        (100.0, 50.0, 100.0, True),
        (0.01, 100.0, 100.0, True),
    ],
)
def test_the_rate_by_parameter_and_first_block(tmp_path, walk, stated, header, rate, told):
    path = put(tmp_path, c3d_bytes(walk, LABELS, parameters={"RATE": stated}, header={10: header}))
    reading = io.open_recording(path)
    assert reading.recordings[0].rate == rate
    assert any(f"{rate:g} Hz was taken" in warning for warning in reading.warnings) == told
    assert io.open_recording(path, rate=25).warnings == ()


def test_a_frame_of_a_second_is_doubted(tmp_path, walk):
    path = put(tmp_path, c3d_bytes(walk, LABELS, rate=0.5))
    assert any("A frame lasts 2 s" in warning for warning in io.open_recording(path).warnings)
    assert io.open_recording(path, rate=50).warnings == ()


@pytest.mark.parametrize(
    ("units", "unit", "how", "told"),
    [
        (["mm"], "mm", "read", False),
        (["  mm  "], "mm", "read", False),
        (["Millimeters"], "mm", "read", False),
        (["mm", "deg", "N"], "mm", "read", False),
        (["m"], "m", "read", False),
        ([""], "mm", "guessed", False),
        ([], "mm", "guessed", False),
        (["furlong"], "mm", "guessed", True),
    ],
)
def test_units_as_they_are_spelled(tmp_path, walk, units, unit, how, told):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS, parameters={"UNITS": units})))
    assert (reading.findings["unit"].value, reading.findings["unit"].how) == (unit, how)
    assert any("'furlong', which names no unit" in warning for warning in reading.warnings) == told


@pytest.mark.parametrize(("stated", "told"), [("mm", True), ("m", False), ("cm", True)])
def test_a_unit_that_the_body_contradicts_is_kept_and_told(tmp_path, rng, stated, told):
    places = rng.normal(
        [[0, 0, 1.7], [0.1, 0, 0.08], [-0.1, 0, 0.08], [0.1, -0.15, 0.01]] * 2, 0.005, (30, 8, 3)
    )
    labels = [*LABELS, "C7", "T10", "CLAV", "STRN"]
    reading = io.open_recording(put(tmp_path, c3d_bytes(places, labels, parameters={"UNITS": [stated]})))
    assert (reading.findings["unit"].value, reading.findings["unit"].how) == (stated, "read")
    assert any("state the unit with --unit m." in warning for warning in reading.warnings) == told


# --- the section of parameters


@pytest.mark.parametrize("locked", [False, True])
@pytest.mark.parametrize("order", [None, lambda name: (":" not in name, name), lambda name: name[::-1]])
def test_parameters_in_any_order_and_locked_say_the_same(tmp_path, walk, order, locked):
    content = c3d_bytes(walk, LABELS, order=order, locked=locked)
    assert io.open_recording(put(tmp_path, content)).recordings[0] == io.read(
        put(tmp_path, c3d_bytes(walk, LABELS))
    )


@pytest.mark.parametrize(
    "tail",
    [b"\x05\x01\x01\x02\x03\x04\x05", b"\x05\x01WRONG\xff\xff\x04\x01\xff", b"\x7f\x01" + b"A" * 127],
    ids=["no name", "a link to nowhere", "no end"],
)
def test_what_stands_before_the_damage_is_read(tmp_path, walk, tail):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS, tail=tail)))
    assert reading.recordings[0].names == tuple(LABELS)
    np.testing.assert_allclose(reading.recordings[0].positions, y_up(walk), atol=1e-6)


def test_damaged_parameters_are_told_and_the_points_numbered(tmp_path, walk):
    content = bytearray(c3d_bytes(walk, LABELS))
    place = content.index(b"LABELS") + len("LABELS") + 2
    content[place : place + 2] = b"\x77\x09"  # of an unknown kind, in nine dimensions
    reading = io.open_recording(put(tmp_path, bytes(content)), unit="mm", up="z")
    assert reading.recordings[0].names == ("point1", "point2", "point3", "point4")
    assert [warning[:25] for warning in reading.warnings] == [
        "The parameters are damage",
        "4 of 4 points have no lab",
    ]


def test_any_damage_to_the_parameters_is_a_reading_or_a_sentence(tmp_path, walk, rng):
    whole = c3d_bytes(walk, LABELS, parameters={"SUBJECTS:USES_PREFIXES": (0,)})
    for _ in range(150):
        content = bytearray(whole)
        for place in rng.integers(0, 1024, 6):
            content[place] = rng.integers(0, 256)
        try:
            reading = io.open_recording(put(tmp_path, bytes(content)))
        except FormatError as error:
            sentence = str(error)
        else:
            sentence = f"{len(reading.recordings)} read"
        assert sentence == "1 read" or sentence.startswith("trial.c3d: expected")


def test_points_that_are_never_seen_are_a_recording(tmp_path, walk):
    residuals = np.full(walk.shape[:2], -1.0)
    nothing = {"UNITS": None, "X_SCREEN": None, "Y_SCREEN": None}
    path = put(tmp_path, c3d_bytes(walk, LABELS, residuals=residuals, parameters=nothing))
    assert np.isnan(io.read(path).positions).all()


def test_points_beyond_the_labels_are_numbered_and_told(tmp_path, walk):
    reading = io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS[:2])))
    assert reading.recordings[0].names == ("HEAD", "LANK", "point3", "point4")
    assert reading.warnings == ("2 of 4 points have no label in the file; they are called by number.",)


def test_labels_hold_any_language(tmp_path, walk):
    labels = ["Kopf", "Fuß", "頭", "нога"]
    assert io.read(put(tmp_path, c3d_bytes(walk, labels))).names == tuple(labels)
    latin = c3d_bytes(walk, ["Kopf", "Fu~", "x", "y"]).replace(b"Fu~", "Fuß".encode("latin-1"))
    assert io.read(put(tmp_path, latin)).names[1] == "Fuß"


def test_subjects_whose_prefixes_end_in_no_colon_are_people(tmp_path, walk):
    labels = ["Ann_HEAD", "Ann_LANK", "Bob_HEAD", "Bob_LANK"]
    subjects = {"SUBJECTS:NAMES": ["Ann", "Bob"], "SUBJECTS:LABEL_PREFIXES": ["Ann_", "Bob_"]}
    path = put(tmp_path, c3d_bytes(walk, labels, parameters={**subjects, "SUBJECTS:USES_PREFIXES": (1,)}))
    assert io.open_recording(path).people == ("Ann", "Bob")
    path = put(tmp_path, c3d_bytes(walk, labels, parameters={**subjects, "SUBJECTS:USES_PREFIXES": (0,)}))
    assert io.read(path).names == tuple(labels)


def test_events_change_nothing(tmp_path, walk):
    events = {
        "EVENT:USED": (1,),
        "EVENT:LABELS": ["Foot Strike"],
        "EVENT:TIMES": (0, 1),
        "EVENT_CONTEXT:USED": (1,),
    }
    assert io.open_recording(put(tmp_path, c3d_bytes(walk, LABELS, parameters=events))).recordings == (
        io.read(put(tmp_path, c3d_bytes(walk, LABELS))),
    )


def test_a_point_of_which_one_coordinate_is_missing_is_unseen(tmp_path, walk):
    walk[2, 1, 2] = np.nan
    markers = io.read(put(tmp_path, c3d_bytes(walk, LABELS)))
    assert np.isnan(markers.positions[2, 1]).all()
    assert np.isnan(markers.positions).sum() == 3


# --- twins


def by_ezc3d(path):
    theirs = ezc3d.c3d(str(path))
    points = theirs["data"]["points"][:3].transpose(2, 1, 0)
    return points, theirs["parameters"]["POINT"]["RATE"]["value"][0]


def by_c3d(path):
    with warnings.catch_warnings(), path.open("rb") as file:
        warnings.simplefilter("ignore")
        reader = c3d.Reader(file)
        frames = np.array([points for _, points, _ in reader.read_frames()])
    return np.where(frames[..., 3:4] < 0, np.nan, frames[..., :3]), reader.point_rate


FILES = {
    "btk/Dance": [by_c3d],
    "btk/Dec_real": [by_c3d, by_ezc3d],
    "btk/Eb015pr": [by_c3d, by_ezc3d],
    "btk/Gait": [by_c3d, by_ezc3d],
    "btk/PiG_Motion3_FF": [by_c3d, by_ezc3d],
    "btk/golfswing": [by_c3d],
    "btk/pc_int": [by_c3d, by_ezc3d],
    "btk/sgi_int": [by_c3d],
    "pycgm/Movement_trial": [by_c3d, by_ezc3d],
}
"""By which public readers each recording can be read; ezc3d refuses those of SGI and of integers in an OFFSET."""


@pytest.mark.data
@pytest.mark.parametrize(("name", "theirs"), [(name, reader) for name in FILES for reader in FILES[name]])
def test_all_points_of_real_files_are_those_of_the_public_readers(data, name, theirs):
    path = data / f"{name}.c3d"
    source = Source(path, path.read_bytes())
    header = read_header(source)
    layout = find_layout(source, header, [])
    points = _positions(source, header, layout, list(range(layout.points)))
    expected, rate = theirs(path)
    assert points.shape == expected.shape
    unseen = np.isnan(expected).any(axis=-1)
    np.testing.assert_array_equal(np.isnan(points), np.repeat(unseen[..., None], 3, axis=-1))
    np.testing.assert_allclose(points, expected, rtol=1e-6, atol=1e-5)
    assert io.read(path).rate == pytest.approx(rate, rel=1e-6)


def written_by_ezc3d(path, places, labels):
    file = ezc3d.c3d()
    for name, value in (("RATE", [119.88]), ("LABELS", labels), ("UNITS", ["mm"])):
        file["parameters"]["POINT"][name]["value"] = value
    points = np.ones((4, places.shape[1], len(places)))
    points[:3] = places.transpose(2, 1, 0)
    file["data"]["points"] = points
    file["data"]["meta_points"]["residuals"] = np.where(np.isnan(places[..., 0]), -1, 0).T[None]
    file["data"]["meta_points"]["camera_masks"] = np.zeros((7, *points.shape[1:]), dtype=bool)
    file.write(str(path))


def written_by_c3d(path, places, labels):
    writer = c3d.Writer(point_rate=119.88, analog_rate=0, point_scale=-1.0)
    writer.set_point_labels(labels)
    for frame in places:
        points = np.zeros((len(frame), 5), dtype=np.float32)
        points[:, :3] = np.nan_to_num(frame)
        points[:, 3] = np.where(np.isnan(frame[:, 0]), -1, 0)
        writer.add_frames([(points, np.array([[]]))])
    with path.open("wb") as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        writer.write(file)


@pytest.mark.parametrize(
    ("write", "frames", "points"),
    [
        (written_by_ezc3d, 50, 4),
        (written_by_ezc3d, 20, 300),
        (written_by_ezc3d, 65535, 1),
        (written_by_ezc3d, 66000, 1),
        (written_by_c3d, 50, 4),
        (written_by_c3d, 66000, 2),
    ],
)
def test_what_public_writers_write_is_read(tmp_path, rng, write, frames, points):
    places = rng.normal(0, 800, (frames, points, 3))
    places[rng.random((frames, points)) < 0.1] = np.nan
    labels = [f"M{k}" for k in range(points)]
    write(tmp_path / "theirs.c3d", places, labels)
    reading = io.open_recording(tmp_path / "theirs.c3d", up="z", unit="mm")
    (markers,) = reading.recordings
    np.testing.assert_allclose(markers.positions, y_up(places), rtol=1e-6, atol=1e-9)
    assert (markers.names, markers.rate, reading.warnings) == (tuple(labels), 119.88, ())


@pytest.mark.data
@pytest.mark.parametrize("name", FILES)
def test_labels_are_those_of_the_public_reader(data, name):
    path = data / f"{name}.c3d"
    with path.open("rb") as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        labels = [label.strip() for label in c3d.Reader(file).point_labels]
    source = Source(path, path.read_bytes())
    assert read_header(source).texts("POINT", "LABELS") == labels
