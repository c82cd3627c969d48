"""Spikes and frozen points: found where they were put, and nowhere else."""

import numpy as np
import pytest

from leitmotion.motion import ParameterError, Trajectories, rotations
from leitmotion.repairs import find_frozen, find_spikes, release_frozen, remove_spikes
from oracles.body import human, points_of
from oracles.rigid import RATE, tumbling


def spoilt(recording, point, start, stop, by):
    positions = recording.positions.copy()
    positions[start:stop, point] += by
    return recording.replace(positions=positions)


@pytest.mark.parametrize("frames", [1, 2, 5])
@pytest.mark.parametrize("jitter", [0.0, 0.001])
def test_a_spike_is_found_with_its_frames_and_taken_out(rng, frames, jitter):
    body = tumbling(rng, jitter=jitter)
    hurt = spoilt(body, 3, 80, 80 + frames, [0.1, 0.2, -0.1])
    (spike,) = find_spikes(hurt)
    assert spike[:3] == ("p3", 80, 80 + frames)
    assert spike.height == pytest.approx(0.245, abs=0.03)
    mended = remove_spikes(hurt)
    assert np.abs(mended.recording.positions - body.positions).max() < 0.01
    assert [change[:4] for change in mended.changes] == [("spike", "p3", 80, 80 + frames)]


def test_a_spike_may_leave_a_gap(rng):
    hurt = spoilt(tumbling(rng), 3, 80, 82, 0.2)
    gone = np.isnan(remove_spikes(hurt, leave="gap").recording.positions)
    assert gone[80:82, 3].all()
    assert gone.sum() == 6


def test_smooth_movement_and_noise_have_none(rng):
    for jitter in (0.0, 0.002):
        assert find_spikes(tumbling(rng, jitter=jitter)) == ()
    motion = human(rng, frames=300)
    assert find_spikes(motion) == ()
    assert find_spikes(points_of(motion)) == ()


def test_a_step_that_does_not_come_back_is_none(rng):
    body = tumbling(rng)
    assert find_spikes(spoilt(body, 3, 80, 200, 0.3)) == ()


def test_a_whole_body_that_is_shaken_has_none(rng):
    body = tumbling(rng)
    positions = body.positions.copy()
    positions[80] += [0.1, 0.0, 0.0]
    assert find_spikes(body.replace(positions=positions)) == ()


def test_a_flip_by_half_a_turn_and_the_sign_of_a_quaternion(rng):
    motion = human(rng, frames=120)
    turns = motion.local_rotations.copy()
    turns[60:, 4] *= -1
    assert find_spikes(motion.replace(local_rotations=turns)) == ()
    turns[50, 7] = rotations.multiply(turns[50, 7], rotations.from_axis_angle("y", np.pi))
    hurt = motion.replace(local_rotations=rotations.continuous(turns))
    (spike,) = find_spikes(hurt)
    assert spike[:3] == (motion.skeleton.names[7], 50, 51)
    mended = remove_spikes(hurt).recording
    assert rotations.geodesic_angle(mended.local_rotations, motion.local_rotations).max() < 0.02
    assert np.array_equal(rotations.continuous(mended.local_rotations[:, 7]), mended.local_rotations[:, 7])


def test_a_turn_that_snaps_away_is_a_spike_of_a_skeleton(rng):
    motion = human(rng, frames=120)
    turns = motion.local_rotations.copy()
    turns[50:52, 7] = rotations.multiply(turns[50:52, 7], rotations.from_axis_angle("y", np.radians(60)))
    hurt = motion.replace(local_rotations=turns)
    (spike,) = find_spikes(hurt)
    assert spike[:3] == (motion.skeleton.names[7], 50, 52)
    assert spike.height == pytest.approx(60, abs=5)
    mended = remove_spikes(hurt).recording
    assert rotations.geodesic_angle(mended.local_rotations, motion.local_rotations).max() < 0.02
    with pytest.raises(ParameterError, match="A skeleton has no gaps"):
        remove_spikes(hurt, leave="gap")


def test_points_in_a_picture_have_spikes_in_their_own_size(rng):
    t = np.arange(100) / RATE
    path = np.stack((100 * t, 50 * np.sin(3 * t)), axis=1)[:, None] + np.array([[0, 0], [0, 170], [40, 80.0]])
    picture = Trajectories(("a", "b", "c"), path, rate=RATE, unit="px")
    assert find_spikes(picture) == ()
    assert [spike[:3] for spike in find_spikes(spoilt(picture, 1, 40, 41, 30.0))] == [("b", 40, 41)]


def test_a_frozen_point_is_found_and_released(rng):
    body = tumbling(rng)
    positions = body.positions.copy()
    positions[60:100, 2] = positions[59, 2]
    stuck = body.replace(positions=positions)
    assert [tuple(one) for one in find_frozen(stuck)] == [("p2", 60, 100)]
    gone = np.isnan(release_frozen(stuck).recording.positions)
    assert gone[60:100, 2].all()
    assert gone.sum() == 120


def test_a_whole_figure_that_holds_still_is_not_frozen(rng):
    body = tumbling(rng)
    positions = body.positions.copy()
    positions[60:120] = positions[59]
    assert find_frozen(body.replace(positions=positions)) == ()
    never = positions.copy()
    never[:, 0] = 1.0
    assert find_frozen(body.replace(positions=never)) == ()
