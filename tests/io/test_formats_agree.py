"""One recording in several formats is one recording."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.datasets import Action, compose
from leitmotion.motion import Motion, joint_points
from oracles.gltf import Gltf


def places(recording, names):
    points = joint_points(recording) if isinstance(recording, Motion) else recording
    return points.positions[:, [points.names.index(name) for name in names]]


def assert_every_format_agrees(motion, folder, frames):
    """Each file that is written puts the joints where the motion has them, in those frames, to 1e-5 m."""
    names = motion.skeleton.names
    expected = places(motion, names)[frames]
    for extension in ("bvh", "c3d", "npz"):
        back = io.read(io.write(motion, folder / f"clip.{extension}"))
        assert (len(back), back.rate) == (len(motion), pytest.approx(motion.rate, rel=1e-7))
        np.testing.assert_allclose(places(back, names)[frames], expected, atol=1e-5)
    for extension in ("glb", "gltf"):
        file = Gltf(io.write(motion, folder / f"clip.{extension}").read_bytes())
        theirs = np.array([file.world(frame / motion.rate)[: len(names), :3, 3] for frame in frames])
        np.testing.assert_allclose(theirs, expected, atol=1e-5)


@pytest.mark.parametrize("rate", [30, 59.94, 120])
def test_a_motion_written_in_every_format_is_one(tmp_path, rate):
    motion = compose([Action("squat", 1), Action("arm raise", 1)], seed=3, rate=rate).motion
    assert_every_format_agrees(motion, tmp_path, [0, 17, len(motion) - 1])


@pytest.mark.data
@pytest.mark.parametrize("name", ["cmu_amc/01_01.amc", "cmu_bvh/10_03.bvh", "perfume_dance/A_test.bvh"])
def test_a_real_motion_written_in_every_format_is_one(data, tmp_path, name):
    motion = io.read(data / name)
    assert_every_format_agrees(motion, tmp_path, [0, len(motion) // 2, len(motion) - 1])


@pytest.mark.data
def test_a_trial_published_as_c3d_and_as_trc_is_one(data):
    reading, other = (io.open_recording(data / "btk" / f"Gait.{end}") for end in ("c3d", "trc"))
    (c3d,), (trc,) = reading.recordings, other.recordings
    assert (c3d.positions.shape, c3d.rate) == (trc.positions.shape, trc.rate)
    assert [reading.findings[topic].value for topic in ("unit", "up")] == [
        other.findings[topic].value for topic in ("unit", "up")
    ]
    away = np.linalg.norm(c3d.positions - trc.positions, axis=-1)  # their names differ, their order does not
    assert np.isfinite(away).sum() > 5000
    assert np.nanmedian(away) < 0.001
    assert np.nanmax(away) < 0.01  # the TRC was smoothed
