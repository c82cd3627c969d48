"""TRC written and read back, and by a reader of its own in the oracle below."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion import compose_session, io
from leitmotion.motion import ParameterError, Trajectories, joint_points

WORD = st.text(st.characters(blacklist_categories=("Cs", "Cc", "Zl", "Zp")), min_size=1, max_size=9).filter(
    lambda word: word == word.strip() and word.isprintable() and ":" not in word
)
PLACE = st.none() | st.tuples(*[st.floats(-1e3, 1e3).filter(bool)] * 3)


@given(
    names=st.lists(WORD, min_size=1, max_size=5, unique=True),
    places=st.lists(PLACE, min_size=10, max_size=30),
    rate=st.sampled_from([30.0, 120.0, 30000 / 1001, 0.5]),
    unit=st.sampled_from(["mm", "m", "inch"]),
)
@settings(max_examples=60, deadline=None)
def test_what_is_written_reads_back(tmp_path_factory, names, places, rate, unit):
    frames = len(places) // len(names)
    flat = [place or (np.nan,) * 3 for place in places[: frames * len(names)]]
    positions = np.array(flat).reshape(frames, len(names), 3)
    positions[0] = 1.0  # a marker never seen is left out
    markers = Trajectories(tuple(names), positions, rate)
    path = io.write(markers, tmp_path_factory.mktemp("trc") / "a.trc", unit=unit)
    reading = io.open_recording(path)
    (again,) = reading.recordings
    assert (again.names, again.rate, reading.findings["unit"].value) == (markers.names, rate, unit)
    assert reading.warnings == ()
    up = io.read(path, up="y").positions
    np.testing.assert_allclose(up, positions, rtol=1e-14, atol=1e-12)
    np.testing.assert_array_equal(np.isnan(up), np.isnan(positions))


def oracle(text):
    """Names, unit, rate, counts and cells of a TRC, line by line as the format says."""
    lines = text.split("\n")
    facts = dict(zip(lines[1].split("\t"), lines[2].split("\t")))
    rows = [line.split("\t") for line in lines[6:-1]]
    return [name for name in lines[3].split("\t")[2:] if name], facts, lines[4].split("\t"), rows


def test_the_header_counts_right(tmp_path):
    motion = compose_session(seed=3, rate=30).motion
    path = io.write(motion, tmp_path / "motion.trc")
    names, facts, axes, rows = oracle(path.read_text())
    assert tuple(names) == motion.skeleton.names
    assert (int(facts["NumMarkers"]), int(facts["NumFrames"]), facts["Units"]) == (
        len(names),
        len(motion),
        "mm",
    )
    assert float(facts["DataRate"]) == motion.rate
    assert axes[2:] == [f"{axis}{k + 1}" for k in range(len(names)) for axis in "XYZ"]
    assert {len(row) for row in rows} == {2 + 3 * len(names)}
    held = np.array(rows, dtype=float)
    np.testing.assert_array_equal(held[:, 0], np.arange(1, len(motion) + 1))
    np.testing.assert_allclose(held[:, 1], motion.times)
    expected = joint_points(motion).positions
    np.testing.assert_allclose(held[:, 2:].reshape(expected.shape) / 1000, expected, atol=1e-12)
    np.testing.assert_allclose(io.read(path).positions, expected, atol=1e-12)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"positions": np.ones((2, 1, 2))}, "points in space; these lie in a plane"),
        ({"unit": "px"}, "holds lengths; these points are in px"),
        ({"names": ("a\tb",)}, r"'a\\tb' would not stay as it is"),
        ({"names": (" a",)}, "' a' would not stay as it is"),
        ({"positions": np.ones((0, 1, 3))}, "at least one point and one frame"),
    ],
)
def test_what_a_trc_does_not_hold_is_refused(tmp_path, change, match):
    points = Trajectories(("A",), np.ones((2, 1, 3)), rate=50).replace(**change)
    with pytest.raises(ParameterError, match=match):
        io.write(points, tmp_path / "a.trc")
    with pytest.raises(ParameterError, match="names its unit"):
        io.write(Trajectories(("A",), np.ones((2, 1, 3)), rate=50), tmp_path / "a.trc", unit="0.3")


@pytest.mark.data
@pytest.mark.parametrize("name", ["btk/Gait.trc", "opensim/subject02_running.trc"])
def test_a_real_trc_written_again_holds_the_same(data, tmp_path, name):
    markers = io.read(data / name)
    again = io.read(io.write(markers, tmp_path / "again.trc"), up="y")
    seen = np.isfinite(markers.positions).any(axis=(0, 2))  # a marker never seen has no place in a TRC
    assert (again.names, again.rate) == (tuple(np.array(markers.names)[seen]), markers.rate)
    np.testing.assert_allclose(again.positions, markers.positions[:, seen], rtol=1e-13)
