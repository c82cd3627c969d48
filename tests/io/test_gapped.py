"""Skeletons of which numbers are missing: the joints that are known stand where they stand in the whole recording."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.datasets import compose_session
from leitmotion.motion import Motion, joint_points


@pytest.fixture(scope="module")
def whole() -> Motion:
    return compose_session(seed=2, rate=30).motion[:40]


def spoilt(motion: Motion, path, frame: int, column: int, word: str) -> io.Reading:
    lines = io.write(motion, path, unit="m").read_text().splitlines()
    row = lines[frame - len(motion)].split()
    row[column] = word
    lines[frame - len(motion)] = " ".join(row)
    path.write_text("\n".join(lines) + "\n")
    return io.open_recording(path, unit="m", up="y")


@pytest.mark.parametrize("word", ["nan", "-1.#IND", "NaN"])
def test_joints_below_a_missing_rotation_are_unseen_in_its_frame_and_nothing_else_is(tmp_path, whole, word):
    complete = io.read(io.write(whole, tmp_path / "whole.bvh", unit="m"), unit="m", up="y")
    skeleton, truth = complete.skeleton, joint_points(complete)
    joint = skeleton.index("LeftUpLeg") if "LeftUpLeg" in skeleton.names else int(skeleton.parents[-1])
    # columns of a BVH: six of the root, then three a joint, as they stand
    reading = spoilt(whole, tmp_path / "gaps.bvh", 7, 3 + 3 * joint, word)
    (points,) = reading.recordings
    assert (points.names, points.kind, points.rate) == (truth.names, "joint", truth.rate)
    below = np.zeros(len(skeleton), dtype=bool)
    for k, parent in enumerate(skeleton.parents):
        below[k] = parent == joint or (parent >= 0 and below[parent])
    assert below.any()
    gone = np.isnan(points.positions).any(axis=2)
    assert np.array_equal(gone[7], below)
    assert gone.sum() == below.sum()
    np.testing.assert_array_equal(points.positions[~gone], truth.positions[~gone])
    assert any(f"missing in 1 of {len(truth)} frames" in warning for warning in reading.warnings)


def test_a_missing_place_of_the_root_takes_everything_of_its_frame(tmp_path, whole):
    (points,) = spoilt(whole, tmp_path / "gaps.bvh", 0, 1, "1.#QNAN").recordings
    gone = np.isnan(points.positions).any(axis=2)
    assert gone[0].all()
    assert not gone[1:].any()


AMC = ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\nback 0\n2\nroot 0 0 0 0 0 0\nback nan\n"
ASF = """:version 1.10
:units
  length 1
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    name back
    direction 0 1 0
    length 2
    axis 0 0 0 XYZ
    dof rx
  end
:hierarchy
  begin
    root back
  end
"""


def test_an_amc_with_a_missing_number_is_points_too(tmp_path):
    (tmp_path / "a.asf").write_text(ASF)
    (tmp_path / "a.amc").write_text(AMC)
    reading = io.open_recording(tmp_path / "a.amc", unit="m", up="y")
    (points,) = reading.recordings
    assert points.kind == "joint"
    assert np.isfinite(
        points.positions
    ).all()  # what turns about a joint of which nothing hangs is nowhere seen
    assert any("missing in 1 of 2 frames" in warning for warning in reading.warnings)


def test_no_frame_that_is_whole_is_no_crash(tmp_path, whole):
    path = io.write(whole[:2], tmp_path / "a.bvh", unit="m")
    lines = path.read_text().splitlines()
    lines[-2:] = [" ".join(["nan"] * len(line.split())) for line in lines[-2:]]
    path.write_text("\n".join(lines) + "\n")
    assert np.isnan(io.read(path, unit="m").positions).all()
