"""CSV and Parquet written and read back: nothing is lost, whatever the names; Parquet as others write it."""

import io as streams
import subprocess
import sys

import numpy as np
import pyarrow as arrow
import pyarrow.parquet as parquet
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion import compose_session, io
from leitmotion.motion import DataError, FormatError, ParameterError, Trajectories, joint_points

WORD = st.text(
    st.characters(blacklist_categories=("Cs", "Cc")) | st.sampled_from("\n\t\r"), min_size=1, max_size=9
)
TRICKY = st.sampled_from(
    [
        "A_x",
        "x",
        "X1",
        "velocity",
        "Ann:A",
        "a,b",
        'say "A"',
        " A ",
        "A_",
        "# A",
        "A_confidence",
        "mixamorig:Hips",
        "0\t",
        "a;b;c",
    ]
)
NUMBER = st.just(np.nan) | st.floats(-1e9, 1e9) | st.floats(-2, 2)


@st.composite
def points(draw):
    names = draw(st.lists(TRICKY | WORD.filter(str.strip), min_size=1, max_size=4, unique=True))
    frames, size = draw(st.integers(1, 4)), draw(st.sampled_from([2, 3]))
    count = frames * len(names) * size
    positions = np.array(draw(st.lists(NUMBER, min_size=count, max_size=count))).reshape(
        frames, len(names), size
    )
    positions[~np.isfinite(positions).all(axis=-1)] = np.nan
    sure = draw(st.none() | st.lists(st.floats(0, 1), min_size=count // size, max_size=count // size))
    return Trajectories(
        tuple(names), positions,
        rate=draw(st.sampled_from([30.0, 120.0, 30000 / 1001, 1e-3, 480.0, 0.1 + 0.2])),
        unit=draw(st.sampled_from(["m", "px", "relative"])),
        kind=draw(st.sampled_from(["marker", "joint"])),
        confidence=None if sure is None else np.reshape(sure, (frames, len(names))),
        name=draw(WORD),
    )  # fmt: skip


@pytest.mark.parametrize("extension", ["csv", "parquet"])
@given(recording=points())
@settings(max_examples=60, deadline=None)
def test_what_is_written_reads_back(tmp_path_factory, extension, recording):
    path = io.write(recording, tmp_path_factory.mktemp("points") / f"points.{extension}")
    reading = io.open_recording(path)
    assert reading.recordings == (recording,)
    assert {topic: reading.findings[topic].how for topic in ("unit", "up", "rate")} == dict.fromkeys(
        ("unit", "up", "rate"), "read"
    )


@pytest.mark.parametrize("extension", ["csv", "parquet"])
def test_joints_of_a_skeleton_are_written_as_points(tmp_path, extension):
    motion = compose_session(seed=3, rate=30).motion
    path = io.write(motion, tmp_path / f"motion.{extension}")
    assert io.read(path) == joint_points(motion)
    text = io.read(io.write(motion, path, unit="mm"))
    np.testing.assert_allclose(text.positions, joint_points(motion).positions, atol=1e-12)
    assert io.open_recording(path).findings["unit"].value == "mm"


def test_a_table_written_here_may_be_edited(tmp_path):
    hands = Trajectories(("L", "R"), np.ones((3, 2, 3)), rate=50, kind="joint", name="hands")
    path = io.write(hands, tmp_path / "hands.csv")
    lines = path.read_text().splitlines()
    lines[5] += ",remark"
    lines[6:] = [f"{line},1" for line in lines[6:]]
    path.write_text("\n".join(lines) + "\n")
    assert io.read(path) == hands


@pytest.mark.parametrize("extension", ["csv", "parquet"])
def test_what_cannot_be_written_is_one_sentence(tmp_path, extension):
    path = tmp_path / f"points.{extension}"
    flat = Trajectories(("A",), np.ones((2, 1, 2)), rate=30, unit="px")
    with pytest.raises(ParameterError, match="Points in px have no length to write in 'mm'"):
        io.write(flat, path, unit="mm")
    with pytest.raises(ParameterError, match=r"expected one such as mm, got 0\.3"):
        io.write(flat.replace(unit="m"), path, unit=0.3)
    with pytest.raises(DataError, match="at least one point and one frame"):
        io.write(flat[:0], path)
    with pytest.raises(ParameterError, match="have the options unit, got order"):
        io.write(flat, path, order="xyz")
    assert not path.exists()


# --- Parquet of others


def foreign(tmp_path, columns, metadata=None):
    path = tmp_path / "foreign.parquet"
    parquet.write_table(arrow.table(columns).replace_schema_metadata(metadata), path)
    return path


def test_wide_tables_of_others(tmp_path):
    path = foreign(
        tmp_path,
        {"time": [0.0, 0.02, 0.04], "A.X": [1, 2, None], "A.Y": [1.0, 2.0, 3.0], "A.Z": [1, 2, 3],
         "phase": ["a", "b", "c"]},
        {"unit": "mm", "pandas": "{}"},
    )  # fmt: skip
    reading = io.open_recording(path, up="y")
    (recording,) = reading.recordings
    assert (recording.names, recording.rate, reading.findings["unit"].value) == (("A",), 50.0, "mm")
    np.testing.assert_allclose(recording.positions[:2, 0], [[1e-3] * 3, [2e-3] * 3])
    assert np.isnan(recording.positions[2]).all()
    assert reading.warnings == ("A column that is no point was left out: phase.",)


def test_long_tables_of_others(tmp_path):
    path = foreign(
        tmp_path,
        {"frame": [0, 0, 1], "name": ["A", "B", "A"], "x": [1.0, 4, 7], "y": [2.0, 5, 8], "z": [3.0, 6, 9]},
    )
    (recording,) = io.open_recording(path, up="y", unit="m", rate=25).recordings
    np.testing.assert_array_equal(recording.positions, [[[1, 2, 3], [4, 5, 6]], [[7, 8, 9], [np.nan] * 3]])


def test_timestamps_are_times(tmp_path):
    when = arrow.array([0, 20_000, 40_000], arrow.timestamp("us"))
    path = foreign(tmp_path, {"timestamp": when, "A_x": [1, 2, 3], "A_y": [1, 2, 3], "A_z": [1, 2, 3]})
    assert io.read(path, unit="m").rate == 50.0


@pytest.mark.parametrize(
    ("columns", "match"),
    [
        ({"a": [1]}, "expected columns such as NAME_x, NAME_y, NAME_z, found a"),
        ({"A_x": ["u"], "A_y": [1], "A_z": [1]}, "expected numbers in the column 'A_x', found string"),
        ({"A_x": [1], "A_y": [1], "A_z": [1]}, "column of times, found none"),
        ({"A_x": arrow.array([], arrow.float64())}, "expected a row a frame, found none"),
    ],
)
def test_faults_of_a_parquet_file_are_one_sentence(tmp_path, columns, match):
    with pytest.raises(FormatError, match=match):
        io.read(foreign(tmp_path, columns))


def test_a_damaged_file_is_one_sentence_wherever_it_is_cut(tmp_path):
    content = streams.BytesIO()
    parquet.write_table(
        arrow.table({"time": [0.0, 1.0], "A_x": [1, 2], "A_y": [1, 2], "A_z": [1, 2]}), content
    )
    whole = content.getvalue()
    path = tmp_path / "cut.parquet"
    for stop in range(4, len(whole), 37):
        path.write_bytes(whole[:stop])
        with pytest.raises(FormatError, match="cannot be read as Parquet"):
            io.read(path)


def test_without_pyarrow_a_sentence_says_what_to_install(tmp_path):
    path = tmp_path / "a.parquet"
    path.write_bytes(b"PAR1")
    code = (
        "import sys; sys.modules['pyarrow'] = None\n"
        "from leitmotion import io\n"
        "from leitmotion.motion import DataError\n"
        f"try: io.read({str(path)!r})\n"
        "except DataError as error: print(error)"
    )
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert told.strip() == (
        'Parquet needs the library pyarrow, which is not installed. Install it: pip install "leitmotion[archive]".'
    )


@pytest.mark.parametrize("name", ["0\t", "a;b;c"])
def test_what_stands_in_quotes_divides_nothing(tmp_path, name):
    recording = Trajectories((name,), np.zeros((2, 1, 2)), rate=30.0, name="x")
    assert io.read(io.write(recording, tmp_path / "points.csv")).names == (name,)
