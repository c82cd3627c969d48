"""The low-pass: linear, without delay, blind to place and turn, and half of the power at its cutoff."""

import numpy as np
import pytest

from leitmotion.motion import DataError, ParameterError, Trajectories, rotations
from leitmotion.repairs import choose_cutoff, low_pass
from oracles.body import human, moved
from oracles.rigid import RATE, cut, tumbling


def smooth(positions, cutoff=6.0):
    recording = Trajectories(tuple("abcdef")[: positions.shape[1]], positions, rate=RATE)
    return low_pass(recording, cutoff).recording.positions


def test_constants_stay(rng):
    still = np.broadcast_to(rng.normal(size=(3, 3)), (80, 3, 3))
    assert np.array_equal(smooth(still), still)


def test_it_is_linear_and_blind_to_place_and_turn(rng):
    a, b = rng.normal(size=(2, 120, 2, 3))
    assert np.abs(smooth(2 * a - 3 * b) - 2 * smooth(a) + 3 * smooth(b)).max() < 1e-12
    far = np.array([10.0, -5, 3])
    assert np.abs(smooth(a + far) - smooth(a) - far).max() < 1e-12
    turn = rotations.from_euler("xyz", np.array([0.3, -1.0, 2.0]))
    assert np.abs(smooth(rotations.rotate(turn, a)) - rotations.rotate(turn, smooth(a))).max() < 1e-12


def test_backwards_it_is_the_same(rng):
    a = np.pad(rng.normal(size=(100, 1, 3)), ((200, 200), (0, 0), (0, 0)))
    assert np.abs(smooth(a[::-1])[::-1] - smooth(a)).max() < 1e-9


@pytest.mark.parametrize("cutoff", [4.0, 10.0, 20.0])
def test_half_of_the_power_is_left_at_the_cutoff_and_nothing_is_delayed(cutoff):
    t = np.arange(1000) / RATE
    wave = np.sin(2 * np.pi * cutoff * t)
    passed = smooth(np.stack((wave, 0 * t, 0 * t), axis=1)[:, None], cutoff)[300:700, 0, 0]
    assert np.sqrt(2 * np.mean(passed**2)) == pytest.approx(np.sqrt(0.5), abs=0.005)
    assert np.corrcoef(passed, wave[300:700])[0, 1] > 0.9999


def test_gaps_stay_and_each_stretch_is_filtered_on_its_own(rng):
    body = tumbling(rng, jitter=0.002)
    lost = cut(cut(body, 2, 60, 80), 4, 3, 10)
    mended = low_pass(lost, 6.0)
    assert np.array_equal(np.isnan(mended.recording.positions), np.isnan(lost.positions))
    alone = low_pass(body[:60], 6.0).recording.positions[:, 2]
    assert np.abs(mended.recording.positions[:60, 2] - alone).max() < 1e-12
    assert np.array_equal(mended.recording.positions[:3, 4], lost.positions[:3, 4])
    assert mended.remarks == ("1 stretch of fewer than 5 frames left unfiltered.",)


def test_rotations_stay_unit_turn_with_the_body_and_lose_their_noise(rng):
    clean = human(rng, frames=240)
    noise = rotations.normalize(np.concatenate(
        (np.ones((240, len(clean.skeleton), 1)), rng.normal(scale=0.01, size=(240, len(clean.skeleton), 3))), axis=2
    ))  # fmt: skip
    noisy = clean.replace(
        local_rotations=rotations.continuous(rotations.multiply(clean.local_rotations, noise))
    )
    mended = low_pass(noisy, 5.0).recording
    before = rotations.geodesic_angle(noisy.local_rotations, clean.local_rotations)
    after = rotations.geodesic_angle(mended.local_rotations, clean.local_rotations)
    assert np.median(after) < 0.5 * np.median(before)
    elsewhere = low_pass(moved(noisy, yaw=1.0, by=[1, 0, 2]), 5.0).recording
    here = moved(mended, yaw=1.0, by=[1, 0, 2])
    assert np.abs(elsewhere.local_rotations - here.local_rotations).max() < 1e-9
    assert np.abs(elsewhere.local_positions - here.local_positions).max() < 1e-9


def test_the_chosen_cutoff_is_stated_and_lies_between_the_movement_and_the_noise(rng):
    body = tumbling(rng, frames=800, jitter=0.002)
    chosen = choose_cutoff(body)
    assert 2.0 < chosen < 12.0
    (change,) = low_pass(body).changes
    assert f"cutoff {chosen:.3g} Hz, chosen by residual analysis" in change.detail
    assert choose_cutoff(tumbling(rng, frames=800, jitter=0.02)) < chosen


def test_a_cutoff_that_cannot_be_is_refused(rng):
    body = tumbling(rng)
    for cutoff in (0.0, -1.0, 50.0, "six", True):
        with pytest.raises(ParameterError, match="above 0 and below 45 Hz"):
            low_pass(body, cutoff)
    with pytest.raises(DataError, match="nothing in it moves"):
        choose_cutoff(body.replace(positions=np.zeros_like(body.positions)))
