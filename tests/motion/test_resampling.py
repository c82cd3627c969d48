"""Resampling: laws that hold for every recording, and the gaps of points."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.datasets import Action, compose
from leitmotion.motion import Motion, ParameterError, Skeleton, Trajectories, resample, rotations

RATES = st.sampled_from([10.0, 23.976, 24.0, 25.0, 29.97, 30.0, 50.0, 60.0, 100.0, 119.88, 120.0])


@pytest.fixture(scope="module")
def motion() -> Motion:
    return compose([Action("walk", 2), Action("squat", 1)], seed=4, rate=30.0).motion


def points(rng: np.random.Generator, frames: int = 60, *, unseen: float = 0.2) -> Trajectories:
    positions = rng.normal(size=(frames, 3, 3))
    positions[rng.random((frames, 3)) < unseen] = np.nan
    return Trajectories(("a", "b", "c"), positions, 60.0, confidence=rng.random((frames, 3)))


def test_the_same_rate_is_the_same_recording_to_the_bit(motion, rng):
    assert resample(motion, motion.rate) is motion
    held = points(rng)
    assert resample(held, 60) is held


@pytest.mark.parametrize("times", [2, 3, 4, 7])
def test_up_and_down_again_returns_to_the_bit(motion, rng, times):
    for recording in (motion, points(rng)):
        assert resample(resample(recording, recording.rate * times), recording.rate) == recording


@pytest.mark.parametrize("every", [2, 3, 5])
def test_down_by_a_whole_number_keeps_every_nth_frame(motion, rng, every):
    for recording in (motion, points(rng)):
        assert resample(recording, recording.rate / every) == recording[::every]


@settings(deadline=None, max_examples=60)
@given(old=RATES, new=RATES, frames=st.integers(1, 200))
def test_constant_velocity_stays_and_the_span_is_kept(old, new, frames):
    times = np.arange(frames) / old
    line = times[:, None, None] * np.array([1.0, -2.0, 0.5])
    moved = resample(Trajectories(("p",), line, old), new)
    assert moved.rate == new
    assert np.allclose(moved.positions, moved.times[:, None, None] * [1.0, -2.0, 0.5], atol=1e-6)
    last = (frames - 1) / old
    assert last - 1 / new < moved.times[-1] + 1e-9
    assert moved.times[-1] <= last + 1e-6


@settings(deadline=None, max_examples=40)
@given(old=RATES, new=RATES)
def test_constant_turning_stays(old, new):
    times = np.arange(int(2 * old)) / old
    stick = Skeleton(("root",), [-1], [[0, 0, 0]])
    turns = rotations.continuous(rotations.from_axis_angle("y", 4.0 * times)[:, None])
    moved = resample(Motion(stick, np.zeros((len(times), 1, 3)), turns, old), new)
    right = rotations.from_axis_angle("y", 4.0 * moved.times)
    assert rotations.geodesic_angle(moved.local_rotations[:, 0], right).max() < 1e-5
    steps = np.einsum("tc,tc->t", moved.local_rotations[1:, 0], moved.local_rotations[:-1, 0])
    assert (steps >= 0).all()


def test_the_shorter_arc_is_taken_whatever_the_signs(motion):
    signs = np.where(np.arange(len(motion)) % 2, -1.0, 1.0)[:, None, None]
    flipped = motion.replace(local_rotations=motion.local_rotations * signs)
    a, b = resample(motion, 75), resample(flipped, 75)
    assert rotations.geodesic_angle(a.local_rotations, b.local_rotations).max() < 1e-6


@settings(deadline=None, max_examples=60)
@given(new=RATES, start=st.integers(1, 100), length=st.integers(1, 60))
def test_a_gap_reaches_from_the_last_seen_frame_to_the_next_and_no_farther(new, start, length):
    old, frames = 60.0, 200
    positions = np.ones((frames, 1, 3))
    positions[start : start + length] = np.nan
    moved = resample(Trajectories(("p",), positions, old), new)
    gone = np.isnan(moved.positions[:, 0, 0])
    last_seen, next_seen = (start - 1) / old, (start + length) / old
    assert not gone[(moved.times <= last_seen + 1e-9) | (moved.times >= next_seen - 1e-9)].any()
    assert gone[(moved.times > last_seen + 1e-6) & (moved.times < next_seen - 1e-6)].all()
    assert abs(gone.sum() / new - (length + 1) / old) < 1 / new + 1e-6


def test_what_is_seen_is_the_same_for_every_component(rng):
    moved = resample(points(rng), 47.0)
    gone = np.isnan(moved.positions)
    assert gone.any()
    assert (gone.all(axis=2) == gone.any(axis=2)).all()


def test_confidence_goes_along_and_is_the_lesser_where_unseen():
    positions = np.zeros((3, 1, 3))
    positions[1] = np.nan
    held = Trajectories(("p",), positions, 10.0, confidence=[[1.0], [0.2], [0.6]])
    assert resample(held, 20.0).confidence.ravel().tolist() == [1.0, 0.2, 0.2, 0.2, 0.6]
    seen = held.replace(positions=np.zeros((3, 1, 3)))
    assert np.allclose(resample(seen, 20.0).confidence.ravel(), [1.0, 0.6, 0.2, 0.4, 0.6])
    assert resample(held.replace(confidence=None), 20.0).confidence is None


def test_a_single_frame_is_kept_and_points_in_a_plane_too():
    one = Trajectories(("p",), [[[3.0, 4.0]]], 30.0, unit="px")
    assert resample(one, 100.0) == one.replace(rate=100.0)


@pytest.mark.parametrize("rate", [0, -1, math.nan, math.inf, 2e6, "30", None])
def test_a_rate_that_is_none_is_refused(motion, rate):
    with pytest.raises(ParameterError, match="number of hertz above 0 and up to 1e"):
        resample(motion, rate)


def test_only_a_recording_is_resampled(motion):
    with pytest.raises(ParameterError, match="got a Skeleton"):
        resample(motion.skeleton, 30.0)
