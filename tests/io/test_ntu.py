"""NTU RGB+D: people who come and go, joints that are not tracked."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.io.joint_sets import KINECT_2
from leitmotion.motion import FormatError

FIRST, SECOND = "72057594037931101", "72057594037931102"  # they differ beyond what a float can tell


def skeletons(places, *, states=None):
    """The text of frames, each a list of (tracking number, places (25, 3))."""
    lines = [f"{len(places)}"]
    for t, frame in enumerate(places):
        lines.append(f"{len(frame)}")
        for who, joints in frame:
            lines += [f"{who} 0 1 1 1 1 0 0.02 -0.16 2", "25"]
            for j, (x, y, z) in enumerate(joints):
                state = 2 if states is None else states[t][j]
                lines.append(
                    f"{x:.7f} {y:.7f} {z:.7f} 279.6 184.3 1036.2 517.1 -0.2 -0.01 0.97 -0.05 {state}"
                )
    return "\n".join(lines) + "\n"


@pytest.fixture
def bodies(rng):
    base = rng.uniform(-0.8, 0.8, (25, 3)) + np.array([0.0, 0.0, 3.0])
    return base, base + np.array([1.0, 0.0, 0.0])


def test_each_tracking_number_is_a_person_and_absent_is_nan(tmp_path, bodies):
    a, b = bodies
    frames = [[(FIRST, a)]] * 3 + [[(SECOND, b), (FIRST, a)]] * 4 + [[]] + [[(SECOND, b)]] * 2
    (tmp_path / "S001.skeleton").write_text(skeletons(frames))
    reading = io.open_recording(tmp_path / "S001.skeleton")
    assert reading.people == (FIRST, SECOND)
    one, two = reading.recordings
    assert one.names == KINECT_2.joints
    assert one.rate == 30.0
    assert len(one) == 10
    assert reading.findings["rate"].how == "guessed"
    assert reading.findings["up"].value == "y"
    np.testing.assert_allclose(one.positions[:7], np.repeat(a[None], 7, axis=0), atol=1e-6)
    assert np.isnan(one.positions[7:]).all()
    assert np.isnan(two.positions[[0, 1, 2, 7]]).all()
    np.testing.assert_allclose(two.positions[-1], b, atol=1e-6)
    assert (one.confidence[7:] == 0).all()
    assert (one.confidence[:7] == 1).all()
    (tmp_path / "stdin").write_text(skeletons(frames))
    assert io.open_recording(tmp_path / "stdin").people == (FIRST, SECOND)


def test_joints_not_tracked_have_no_confidence_and_zeros_are_unseen(tmp_path, bodies):
    a = bodies[0].copy()
    a[7] = 0.0
    states = [[2] * 25 for _ in range(5)]
    states[1][3], states[1][4] = 0, 1
    (tmp_path / "a.skeleton").write_text(skeletons([[(FIRST, a)]] * 5, states=states))
    reading = io.open_recording(tmp_path / "a.skeleton")
    points = reading.recordings[0]
    assert points.confidence[1, 3:6].tolist() == [0.0, 0.5, 1.0]
    assert np.isnan(points.positions[:, 7]).all()
    assert np.isfinite(points.positions[1, 3]).all()
    assert any("5 places lie exactly in the origin" in warning for warning in reading.warnings)


def test_frames_before_anybody_comes(tmp_path, bodies):
    (tmp_path / "stdin").write_text(skeletons([[], [], [(FIRST, bodies[0])]]))
    points = io.read(tmp_path / "stdin")
    assert np.isnan(points.positions[:2]).all()
    assert np.isfinite(points.positions[2]).all()


def test_a_broken_file_is_one_sentence_that_names_the_line(tmp_path, bodies):
    text = skeletons([[(FIRST, bodies[0])]] * 3)
    path = tmp_path / "a.skeleton"
    path.write_text(text[: len(text) // 2])
    with pytest.raises(FormatError, match="line 45: expected 12 numbers of a joint, found 2"):
        io.read(path)
    path.write_text(text.replace("\n25\n", "\n24\n", 1))
    with pytest.raises(FormatError, match="line 4: expected 25 joints, found 24"):
        io.read(path)
    path.write_text("2\n0\n0\n")
    with pytest.raises(FormatError, match="found nobody in its 2 frames"):
        io.read(path)
    path.write_text("many\n")
    with pytest.raises(FormatError, match="line 1: expected the number of frames, found 'many'"):
        io.read(path)
    path.write_text(skeletons([[(FIRST, bodies[0])]] * 3).replace("3\n", "9\n", 1))
    reading = io.open_recording(path)
    assert any("promises 9 frames, the file has 3" in warning for warning in reading.warnings)
