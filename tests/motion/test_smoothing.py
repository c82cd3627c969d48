"""Smoothing and differentiating: what is kept, what is taken away, and nothing is delayed."""

import numpy as np
import pytest

from leitmotion.motion.smoothing import derivative, smooth

RATE = 120.0


def test_a_line_and_a_still_place_are_kept_to_the_end(rng):
    times = np.arange(200) / RATE
    line = 3.0 + np.outer(times, rng.normal(size=3))
    assert np.allclose(smooth(line, 6.0, RATE), line, atol=1e-3)


@pytest.mark.parametrize(("hertz", "left"), [(1.0, 1.0), (6.0, np.sqrt(0.5)), (40.0, 0.0)])
def test_half_of_the_power_is_left_at_the_cutoff(hertz, left):
    times = np.arange(2400) / RATE
    wave = np.sin(2 * np.pi * hertz * times)
    passed = smooth(wave, 6.0, RATE)[600:-600]
    assert np.dot(passed, wave[600:-600]) / np.dot(wave[600:-600], wave[600:-600]) == pytest.approx(
        left, abs=0.01
    )


def test_nothing_is_delayed():
    times = np.arange(-300, 301) / RATE
    bump = np.exp(-((times / 0.1) ** 2))
    assert np.allclose(smooth(bump, 8.0, RATE), smooth(bump, 8.0, RATE)[::-1], atol=1e-9)


def test_time_backwards_turns_the_speed(rng):
    path = rng.normal(size=(50, 4)).cumsum(axis=0)
    assert np.allclose(derivative(path[::-1], RATE), -derivative(path, RATE)[::-1])


def test_a_cubic_is_differentiated_exactly():
    times = np.arange(30) / RATE
    assert np.allclose(derivative(times**3 - times, RATE), 3 * times**2 - 1, atol=1e-9)


@pytest.mark.parametrize("rate", [30.0, 60.0, 240.0])
def test_a_speed_hardly_depends_on_the_rate(rate):
    times = np.arange(round(4 * rate)) / rate
    speed = derivative(np.sin(2 * np.pi * 3 * times), rate)
    assert np.abs(speed - 6 * np.pi * np.cos(2 * np.pi * 3 * times)).max() < 0.05 * 6 * np.pi
