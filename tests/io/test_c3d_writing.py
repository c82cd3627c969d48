"""Writing C3D: what is written reads back, by our reader and by two public ones."""

import warnings
from pathlib import Path

import c3d
import ezc3d
import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from leitmotion import io
from leitmotion.datasets import Action, compose
from leitmotion.io.c3d import read as parse
from leitmotion.io.c3d_parameters import read_header
from leitmotion.io.c3d_writing import write
from leitmotion.io.reading import Source
from leitmotion.motion import Motion, ParameterError, Trajectories, joint_points

FLOAT = 2e-7  # relative error of a 32-bit float, twice


def markers(rng, frames, points, rate=119.88, **how):
    places = rng.normal(0, 1.5, (frames, points, 3))
    places[rng.random((frames, points)) < 0.1] = np.nan
    return Trajectories(tuple(f"M {k}:x" for k in range(points)), places, rate, **how)


def assert_same(back, recording):
    assert (back.names, back.rate, back.unit, back.kind) == (
        recording.names,
        pytest.approx(recording.rate, rel=FLOAT),
        recording.unit,
        recording.kind,
    )
    np.testing.assert_allclose(back.positions, recording.positions, rtol=FLOAT, atol=1e-12)


@pytest.mark.parametrize("unit", ["mm", "m", "cm", "inch"])
@pytest.mark.parametrize(("frames", "points"), [(1, 1), (50, 4), (9, 300), (3, 700)])
def test_what_is_written_reads_back(tmp_path, rng, frames, points, unit):
    recording = markers(rng, frames, points)
    reading = io.open_recording(io.write(recording, tmp_path / "trial.c3d", unit=unit))
    assert_same(reading.recordings[0], recording)
    findings = {topic: (finding.value, finding.how) for topic, finding in reading.findings.items()}
    assert findings == {"unit": (unit, "read"), "up": ("y", "read"), "rate": (119.88, "read")}
    assert reading.warnings == ()


@pytest.mark.parametrize("frames", [65_534, 65_535, 65_536, 70_000])
def test_more_frames_than_the_first_block_counts(tmp_path, rng, frames):
    recording = markers(rng, frames, 2)
    path = io.write(recording, tmp_path / "trial.c3d")
    reading = io.open_recording(path)
    assert_same(reading.recordings[0], recording)
    assert reading.warnings == ()
    for theirs in (by_ezc3d(path), by_c3d(path)):
        np.testing.assert_allclose(theirs[0] / 1000, recording.positions, rtol=2e-7, atol=1e-12)


def test_a_long_count_stands_in_every_place_where_programs_look(tmp_path):
    content = write(Trajectories(("A",), np.ones((70_000, 1, 3)), 120))
    header = read_header(Source(tmp_path, content))
    assert (header.first, header.last, header.number("POINT", "LONG_FRAMES")) == (1, 65535, 70_000)
    assert header.count("POINT", "FRAMES") == 65535
    assert header.parameters["TRIAL", "ACTUAL_START_FIELD"].tolist() == [1, 0]
    assert header.parameters["TRIAL", "ACTUAL_END_FIELD"].tolist() == [70_000 - 65_536, 1]
    assert header.count("POINT", "DATA_START") == header.data_block == header.parameters_end
    assert len(content) == (header.data_block - 1) * 512 + 70_000 * 16


def by_ezc3d(path):
    theirs = ezc3d.c3d(str(path))
    point = theirs["parameters"]["POINT"]
    labels = [word for name in ("LABELS", "LABELS2") if name in point for word in point[name]["value"]]
    return theirs["data"]["points"][:3].transpose(2, 1, 0), point["RATE"]["value"][0], labels


def by_c3d(path):
    with warnings.catch_warnings(), path.open("rb") as file:
        warnings.simplefilter("ignore")
        reader = c3d.Reader(file)
        frames = np.array([points for _, points, _ in reader.read_frames()], dtype=np.float64)
    labels = [word.strip() for word in reader.point_labels]
    return np.where(frames[..., 3:4] < 0, np.nan, frames[..., :3]), reader.point_rate, labels


@pytest.mark.parametrize("theirs", [by_ezc3d, by_c3d])
@pytest.mark.parametrize(("points", "named"), [(4, 4), (255, 255), (300, 300)])
def test_public_readers_read_the_same(tmp_path, rng, theirs, points, named):
    recording = markers(rng, 20, points)
    places, rate, labels = theirs(io.write(recording, tmp_path / "trial.c3d"))
    np.testing.assert_allclose(places / 1000, recording.positions, rtol=4e-7, atol=1e-12)
    assert rate == pytest.approx(119.88, rel=1e-6)
    named = min(named, 255) if theirs is by_c3d else named  # it knows no LABELS2
    assert tuple(labels[:named]) == recording.names[:named]


def test_a_motion_is_written_as_its_joints(tmp_path):
    motion = compose([Action("squat", 1)], seed=1, rate=30).motion
    assert_same(io.read(io.write(motion, tmp_path / "squat.c3d")), joint_points(motion))


def test_a_joint_in_the_origin_and_one_who_lies_come_back(tmp_path):
    places = np.zeros((20, 3, 3))
    places[:, 1, 0] = np.linspace(1.5, 1.6, 20)  # long along X, and still, as a body that stands along it
    places[:, 2, 1] = np.linspace(0.0, 0.6, 20)
    recording = Trajectories(("Hips", "Head", "*3"), places, 30.0, kind="joint")
    reading = io.open_recording(io.write(recording, tmp_path / "lying.c3d"))
    assert_same(reading.recordings[0], recording)
    assert reading.warnings == ()


@pytest.mark.parametrize("unit", ["relative", "px"])
def test_points_in_no_metres_keep_their_unit(tmp_path, rng, unit):
    recording = markers(rng, 10, 3, unit=unit)
    assert_same(io.read(io.write(recording, tmp_path / "pose.c3d")), recording)


names = st.text(min_size=1, max_size=8).map(str.strip).filter(lambda name: name.strip(" \0\t"))


@given(st.lists(names, min_size=3, max_size=3, unique=True))
@example(["Fuß", "頭", "a:b"])
@example(["*1", "uname*2", "x#2"])
@example(["0", "00", "0\x1f"])
def test_any_name_that_is_written_reads_back(own):
    own = [name.strip(" \0\t") for name in own]
    assume(len(set(own)) == 3)
    content = write(Trajectories(own, np.ones((2, 3, 3)), 30))
    (take,) = parse(Source(Path("trial.c3d"), content)).takes
    assert take.names == own


@pytest.mark.parametrize(
    ("recording", "options", "match"),
    [
        (Trajectories(("A",), np.ones((2, 1, 2)), 30, "px"), {}, "points in space, got points with 2 coordinates"),
        (Trajectories(("A",), np.ones((0, 1, 3)), 30), {}, "at least one frame of one point, got 0 frames of 1"),
        (Trajectories((), np.ones((2, 0, 3)), 30), {}, "at least one frame of one point, got 2 frames of 0"),
        (Trajectories(("A" * 256,), np.ones((2, 1, 3)), 30), {}, "at most 255 bytes, 'AAA.*has 256"),
        (Trajectories(("é" * 128,), np.ones((2, 1, 3)), 30), {}, "at most 255 bytes, .*has 256"),
        (Trajectories(("\ud800",), np.ones((2, 1, 3)), 30), {}, "cannot hold .* in a point's name"),
        (Trajectories(("A",), np.full((2, 1, 3), 1e38), 30), {}, "beyond their reach in mm"),
        (Trajectories(("A",), np.ones((2, 1, 3)), 30), {"unit": 0.5}, "unit by name: one of m, cm, mm"),
        (Trajectories(("A",), np.ones((2, 1, 3)), 30), {"unit": "furlong"}, "unit must be one of"),
        (
            Trajectories([f"{k:0200d}" for k in range(700)], np.ones((1, 700, 3)), 30),
            {},
            "130,560 bytes at most, 700 points of such names need more",
        ),
        ("points", {}, "holds a recording, got a str"),
    ],
)  # fmt: skip
def test_what_a_c3d_cannot_hold_is_one_sentence(recording, options, match):
    with pytest.raises(ParameterError, match=match):
        write(recording, **options)


@pytest.mark.data
@pytest.mark.parametrize(
    "name",
    [
        "btk/Dance.c3d", "btk/Dec_real.c3d", "btk/Eb015pr.c3d", "btk/Gait.c3d", "btk/PiG_Motion3_FF.c3d",
        "btk/golfswing.c3d", "btk/pc_int.c3d", "btk/sgi_int.c3d", "pycgm/Movement_trial.c3d", "btk/T.trc",
        "cmu_bvh/131_01.bvh",
    ],
)  # fmt: skip
def test_a_real_recording_survives_the_way_out_and_in(data, tmp_path, name):
    recording = io.read(data / name)
    points = joint_points(recording) if isinstance(recording, Motion) else recording
    reading = io.open_recording(io.write(recording, tmp_path / "trial.c3d"))
    assert_same(reading.recordings[0], points)
    assert reading.warnings == ()


@pytest.mark.parametrize("count", [65_536, 70_000])
def test_more_points_than_the_format_counts_are_refused(count):
    points = Trajectories(tuple(f"p{k}" for k in range(count)), np.zeros((1, count, 3)), rate=50)
    with pytest.raises(ParameterError, match=f"at most 65,535 points, got {count:,}"):
        write(points)


@pytest.mark.parametrize("kind", ["marker", "joint"])
def test_the_kind_of_the_points_takes_no_room_from_their_labels(tmp_path, kind):
    """Twelve thousand labels of ten letters fill the section of parameters nearly."""
    names = tuple(f"point{k:05}" for k in range(12_000))
    points = Trajectories(names, np.ones((1, len(names), 3)), rate=50, kind=kind)
    (tmp_path / "many.c3d").write_bytes(write(points))
    (back,) = io.open_recording(tmp_path / "many.c3d").recordings
    assert (back.names, back.kind) == (names, kind)
