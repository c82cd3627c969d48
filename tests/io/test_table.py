"""Tables of points, CSV and TRC: layouts, missing cells, rates, units."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.motion import FormatError

EXPECTED = np.array([[[1, 2, 3], [4, 5, 6]], [[1.5, 2.5, 3.5], [np.nan] * 3], [[2, 3, 4], [5, 6, 7]]])


def read(tmp_path, text, name="points.csv", **options):
    path = tmp_path / name
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return io.open_recording(path, **{"unit": "m", "up": "y", **options})


def table(header, delimiter=","):
    rows = [["0", "1", "2", "3", "4", "5", "6"], ["0.02", "1.5", "2.5", "3.5", "", "", ""],
            ["0.04", "2", "3", "4", "5", "6", "7"]]  # fmt: skip
    return "\n".join(delimiter.join(row) for row in [header, *rows]) + "\n"


@pytest.mark.parametrize(
    ("header", "names"),
    [
        ("time A_x A_y A_z B_x B_y B_z", ("A", "B")),
        ("Time A.X A.Y A.Z B.X B.Y B.Z", ("A", "B")),
        ("t lhx lhy lhz rhx rhy rhz", ("lh", "rh")),
        ("time X1 Y1 Z1 X2 Y2 Z2", ("1", "2")),
        ("time A:x A:y A:z B:x B:y B:z", ("A", "B")),
        ("time_s L.ASIS_x L.ASIS_y L.ASIS_z C7[x] C7[y] C7[z]", ("L.ASIS", "C7")),
    ],
)
@pytest.mark.parametrize("delimiter", [",", "\t", ";"])
def test_layouts_of_one_table(tmp_path, header, names, delimiter):
    (points,) = read(tmp_path, table(header.split(), delimiter)).recordings
    assert points.names == names
    assert points.rate == 50.0
    np.testing.assert_array_equal(points.positions, EXPECTED)


@pytest.mark.parametrize("word", ["NaN", "nan", "1.#IND", "-1.#IND", "NA", "null"])
def test_missing_is_nan_and_zero_is_zero(tmp_path, word):
    text = f"time,A_x,A_y,A_z,B_x,B_y,B_z\n0,0,0,0,1,2,3\n0.1,{word},{word},{word},1,2,3\n0.2,1,,3,1,2,3\n"
    (points,) = read(tmp_path, text).recordings
    np.testing.assert_array_equal(points.positions[:, 0], [[0, 0, 0], [np.nan] * 3, [np.nan] * 3])
    assert points.rate == 10


@pytest.mark.parametrize(
    ("column", "step", "rate"),
    [("time", 0.0083, 120.48), ("time", 1 / 30, 30), ("timestamp", 33, 30.3), ("time_ms", 0.5, 2000),
     ("timestamp", 16667, 59.999)],
)  # fmt: skip
def test_the_rate_comes_from_the_times(tmp_path, column, step, rate):
    rows = "".join(f"{k * step:.6f},1,2,3\n" for k in range(40))
    reading = read(tmp_path, f"{column},A_x,A_y,A_z\n" + rows)
    assert reading.recordings[0].rate == pytest.approx(rate, rel=5e-3)
    assert column in reading.findings["rate"].reason


def test_uneven_times_are_told(tmp_path):
    times = np.cumsum([0, 30, 31, 90, 30, 140, 30, 31, 30, 31])
    reading = read(tmp_path, "timestamp,A_x,A_y,A_z\n" + "".join(f"{t},1,2,3\n" for t in times))
    assert any("unevenly spaced" in warning for warning in reading.warnings)


def timed(tmp_path, times, **options):
    text = "time_ms,A_x,A_y,A_z\n" + "".join(f"{t},{k},2,3\n" for k, t in enumerate(times))
    return read(tmp_path, text, **options)


def test_a_gap_in_the_times_is_missing_frames(tmp_path):
    times = [*range(0, 1000, 20), *range(11000, 12000, 20)]
    reading = timed(tmp_path, times)
    (points,) = reading.recordings
    assert (points.rate, len(points)) == (50.0, 600)
    rows = np.concatenate((np.arange(50.0), np.full(500, np.nan), np.arange(50.0, 100.0)))
    np.testing.assert_array_equal(points.positions[:, 0, 0], rows)
    assert reading.warnings == (
        "500 frames are missing where the times leap: 10 s after row 50 (at 0.98 s).",
    )


def test_between_gaps_rows_that_stay_near_even_steps_are_frames(tmp_path):
    times = np.arange(200) * 33.5 + np.random.default_rng(0).choice([-15, 0, 15], 200)
    times[80:] += 40_000
    reading = timed(tmp_path, times)
    (points,) = reading.recordings
    row = points.positions[:, 0, 0]
    np.testing.assert_array_equal(row[np.isfinite(row)], np.arange(200))
    assert np.isnan(row[80:-120]).all()
    assert len(row) / points.rate == pytest.approx(times[-1] / 1000, abs=0.1)
    assert any("they were taken as even" in warning for warning in reading.warnings)


def test_frames_of_uneven_rows_are_those_nearest_in_time(tmp_path):
    rng = np.random.default_rng(0)
    steps = rng.choice([16, 31, 31, 31, 47, 78, 110], 2000)
    steps[1200] = 40_000
    times = np.cumsum(steps)
    reading = timed(tmp_path, times)
    (points,) = reading.recordings
    assert reading.findings["rate"].how == "read"
    assert points.rate == pytest.approx(1000 / 31)
    assert "usual step of 31.0 ms" in reading.findings["rate"].reason
    at = times[0] + np.arange(len(points)) * 31.0
    row = points.positions[:, 0, 0]
    seen = np.isfinite(row)
    nearest = np.abs(times[:, None] - at[None]).min(axis=0)
    np.testing.assert_array_equal(np.abs(times[row[seen].astype(int)] - at[seen]), nearest[seen])
    assert (np.flatnonzero(~seen) == np.arange(np.argmin(seen), np.argmin(seen) + (~seen).sum())).all()
    assert (~seen).sum() * 31.0 == pytest.approx(40_000, abs=62)
    assert any("frames repeat a row" in warning for warning in reading.warnings)
    assert any("40 s after row 1200" in warning for warning in reading.warnings)


@pytest.mark.parametrize("rate", [60, 120, 240, 29.97])
def test_times_rounded_to_milliseconds_are_even(tmp_path, rate):
    reading = timed(tmp_path, np.rint(np.arange(3000) * 1000 / rate).astype(int))
    assert reading.recordings[0].rate == pytest.approx(rate, rel=2e-3)
    assert len(reading.recordings[0]) == 3000


def test_dropped_rows_do_not_shift_the_others(tmp_path):
    kept = np.delete(np.arange(2000), np.random.default_rng(1).integers(1, 1000, 60))
    (points,) = timed(tmp_path, kept * 20).recordings
    assert (points.rate, len(points)) == (50.0, 2000)
    assert points.positions[-1, 0, 0] == len(kept) - 1


def test_with_a_rate_given_each_row_is_a_frame(tmp_path):
    reading = timed(tmp_path, [0, 20, 40, 90_000, 90_020], rate=25)
    assert (len(reading.recordings[0]), reading.recordings[0].rate) == (5, 25)
    assert any("each row was taken as a frame" in warning for warning in reading.warnings)


@pytest.mark.parametrize(
    ("times", "match"),
    [
        (
            [*range(0, 2000, 20), 10**8],
            r"spans 100000 s.*Part the file where its times leap \(row 101\).*--rate HZ",
        ),
        ([*range(0, 1000, 20), *range(0, 2000, 20)], "leap back in row 51 of the table.*Part the file there"),
        ([5], "one row of numbers tells no rate.*--rate HZ"),
    ],
)
def test_times_that_make_no_recording_are_refused(tmp_path, times, match):
    with pytest.raises(FormatError, match=match):
        timed(tmp_path, times)
    assert len(timed(tmp_path, times, rate=50).recordings[0]) == len(times)


def test_a_point_given_twice_is_numbered(tmp_path):
    text = "time,A_x,A_y,A_z,A_c,A_x,A_y,A_z,A_c\n0,1,2,3,0.5,4,5,6,0.25\n0.1,1,2,3,0.5,4,5,6,0.25\n"
    reading = read(tmp_path, text)
    (points,) = reading.recordings
    assert points.names == ("A", "A#2")
    np.testing.assert_array_equal(points.positions[0], [[1, 2, 3], [4, 5, 6]])
    np.testing.assert_array_equal(points.confidence[0], [0.5, 0.25])
    assert reading.warnings == ("Names stand more than once and were numbered: A.",)


def test_the_rate_may_stand_in_a_comment_or_be_given(tmp_path):
    text = "A_x,A_y,A_z\n1,2,3\n1,2,3\n"
    assert read(tmp_path, "# rate: 60 Hz\n" + text).recordings[0].rate == 60
    assert read(tmp_path, text, rate=25).recordings[0].rate == 25
    with pytest.raises(FormatError, match=r"column of times.*--rate HZ"):
        read(tmp_path, text)


def test_points_in_a_plane_keep_their_unit_and_stand_upright(tmp_path):
    text = "time,head_x,head_y,ankle_x,ankle_y\n" + "".join(f"{k / 30},0.1,-0.9,0.2,0.9\n" for k in range(5))
    reading = read(tmp_path, text, unit=None, up=None)
    (points,) = reading.recordings
    assert (points.unit, reading.findings["up"].value) == ("relative", "-y")
    np.testing.assert_allclose(points.positions[0], [[0.1, 0.9], [0.2, -0.9]])
    assert read(tmp_path, text.replace("0.", "40"), unit=None, up=None).recordings[0].unit == "px"
    assert read(tmp_path, text, unit="px", up="y").recordings[0].unit == "px"


def test_confidence_and_columns_that_are_no_points(tmp_path):
    text = 'time,image,A_x,A_y,A_z,A_confidence\n0,"im, 0.jpg",1,2,3,0.25\n0.1,im 1.jpg,1,2,3,\n'
    reading = read(tmp_path, text)
    np.testing.assert_array_equal(reading.recordings[0].confidence, [[0.25], [0.0]])
    assert any("left out: image" in warning for warning in reading.warnings)


def test_confidences_outside_0_to_1_are_told(tmp_path):
    text = "time,A_x,A_y,A_z,A_confidence\n0,1,2,3,1.5\n0.1,1,2,3,-0.5\n0.2,1,2,3,1\n"
    reading = read(tmp_path, text, unit="m")
    np.testing.assert_array_equal(reading.recordings[0].confidence, [[1.0], [0.0], [1.0]])
    assert any("2 confidences lie outside 0 to 1" in warning for warning in reading.warnings)


def test_subjects_before_a_colon_are_people(tmp_path):
    text = table(["time", "Ann:A_x", "Ann:A_y", "Ann:A_z", "Bob:A_x", "Bob:A_y", "Bob:A_z"])
    reading = read(tmp_path, text)
    assert reading.people == ("Ann", "Bob")
    np.testing.assert_array_equal(reading.recordings[1].positions, EXPECTED[:, 1:])


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("trial,where\n1,2\n", "columns such as NAME_x"),
        ("time,A_x,A_y,A_z\n0,1,2,3,4\n1,1,2,3\n", "line 2: expected 4 numbers in the row, found more"),
        ("time,A_x,A_y,A_z\n0,1,2,oops\n", "line 2: expected a number, found 'oops'"),
        ("time,A_x,A_y,A_z\n", "row a frame|one line"),
        ("time,A_x,A_y,A_z", "one line"),
        ("time,A_x,A_y,A_z\n0,1,2,3\n0,1,2,3\n", "times that grow.*--rate"),
    ],
)
def test_faults_are_one_sentence(tmp_path, text, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, text)


# --- TRC

TRC = """PathFileType\t4\t(X/Y/Z)\tclip.trc
DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames
50.00\t50.00\t3\t2\tmm\t50.00\t1\t3
Frame#\tTime\tHEAD\t\t\tLANK\t\t
\t\tX1\tY1\tZ1\tX2\tY2\tZ2
\t
1\t0.000\t1\t1700\t3\t4\t80\t6
2\t0.020\t1.5\t1700\t3.5\t\t\t
3\t0.040\t2\t1700\t4\t5\t80\t7
"""
MILLIMETRES = np.array(
    [[[1, 1700, 3], [4, 80, 6]], [[1.5, 1700, 3.5], [np.nan] * 3], [[2, 1700, 4], [5, 80, 7]]], dtype=float
)


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s,
        lambda s: s.replace("\t", ","),
        lambda s: s.replace("\n", "\r\n"),
        lambda s: s.replace("\n\t\n", "\n"),
        lambda s: s.replace("LANK\t\t\n", "LANK\n"),
        lambda s: s.replace("3.5\t\t\t\n", "3.5\n"),
        lambda s: s.replace("6\n", "6\t\n").replace("50.00\t50.00\t3", "  50.0\t\t 50.0\t\t 3"),
        lambda s: s.replace("HEAD", "Ann:HEAD").replace("LANK", "Ann:LANK"),
        lambda s: "\ufeff" + s,
    ],
    ids=["plain", "commas", "crlf", "no-blank", "short-names", "short-row", "padded", "subject", "bom"],
)
def test_spellings_of_one_trc(tmp_path, change):
    reading = read(tmp_path, change(TRC), "clip.trc", unit=None, up=None)
    (markers,) = reading.recordings
    assert (markers.names, markers.rate, reading.warnings) == (("HEAD", "LANK"), 50.0, ())
    np.testing.assert_allclose(markers.positions, MILLIMETRES / 1000)
    assert [reading.findings[k].how for k in ("unit", "up", "rate")] == ["read", "guessed", "read"]


def test_markers_nameless_or_never_seen_are_left_out_and_told(tmp_path):
    text = TRC.replace("LANK\t\t", "LANK\t\t\tGHOST\t\t").replace("80\t6", "80\t6\t\t\t\t9\t9\t9")
    reading = read(tmp_path, text, "clip.trc")
    assert reading.recordings[0].names == ("HEAD", "LANK")
    assert any("1 markers that are never seen" in warning for warning in reading.warnings)
    assert any("1 markers without a name" in warning for warning in reading.warnings)


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        ("PathFileType", "Path", "PathFileType"),
        ("Frame#\tTime\tHEAD\t\t\tLANK\t\t", "Frame#\tTime", "line 4: expected names of markers"),
        ("Frame#", "Image", "line 4: expected the columns Frame#.*found 'Image Time HEAD"),
        ("1700\t3.5", "x\t3.5", "line 8: expected a number, found 'x'"),
    ],
)
def test_faults_of_a_trc_name_their_line(tmp_path, old, new, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, TRC.replace(old, new), "clip.trc")


def test_a_trc_without_rate_is_placed_by_its_times(tmp_path):
    rows = "".join(
        f"{k}\t{t:.3f}\t{k}\t1700\t3\t4\t80\t6\n" for k, t in enumerate([0, 0.02, 0.04, 0.34, 0.36], 1)
    )
    reading = read(tmp_path, TRC.partition("1\t0.000")[0].replace("50.00\t50.00", "0\t0") + rows, "clip.trc")
    (markers,) = reading.recordings
    assert (markers.rate, len(markers)) == (50.0, 19)
    assert np.isnan(markers.positions[3:17]).all()
    assert any("14 frames are missing" in warning for warning in reading.warnings)


def test_a_wrong_count_of_frames_is_told(tmp_path):
    reading = read(tmp_path, TRC.replace("\t3\t2\tmm", "\t9\t2\tmm"), "clip.trc")
    assert any("promises 9 frames, the file has 3" in warning for warning in reading.warnings)


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "shape", "rate", "up", "low", "high"),
    [
        ("bmclab/walk.trc", (184, 28), 150, "y", 0.02, 1.1), ("bmclab/walk1.trc", (364, 28), 150, "y", 0.02, 1.15),
        ("btk/Gait.trc", (487, 33), 100, "z", 0.0, 1.5), ("btk/T.trc", (89, 41), 30, "y", 0.02, 1.7),
        ("btk/ballet_reduced.trc", (100, 41), 30, "y", 0.02, 1.7),
        ("opensim/motion_capture_walk.trc", (238, 41), 100, "y", 0.0, 1.6),
        ("opensim/subject02_running.trc", (600, 41), 60, "y", -0.01, 1.8),
        ("pyomeca/markers.trc", (93, 51), 100, "z", -0.02, 0.7),
    ],
)  # fmt: skip
def test_real_trc(data, name, shape, rate, up, low, high):
    reading = io.open_recording(data / name)
    (markers,) = reading.recordings
    assert (markers.positions.shape[:2], markers.rate, reading.findings["up"].value) == (shape, rate, up)
    heights = markers.positions[..., 1]
    assert low < np.nanmin(heights)
    assert np.nanmax(heights) < high


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "rate", "row"), [("a1", 32.05, 1549), ("a3", 30.0, 748), ("b1", 30.0, 892), ("c1", 29.87, 173)]
)
def test_real_tables_with_a_leap(data, name, rate, row):
    reading = io.open_recording(data / "gesture_phase" / f"{name}_raw.csv")
    (points,) = reading.recordings
    assert points.rate == pytest.approx(rate, abs=0.01)
    assert np.isnan(points.positions).all(axis=(1, 2)).sum() / points.rate == pytest.approx(40, abs=0.1)
    assert any(f"40 s after row {row} " in warning for warning in reading.warnings)
