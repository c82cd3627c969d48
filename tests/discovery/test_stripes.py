"""Stripes: the kernel against its twin, and what a stripe must be."""

import numpy as np
import pytest

from leitmotion.discovery import stripes
from leitmotion.discovery._kernels import NONE, align_locally, walk_back
from oracles import stripes as twin


def wave(periods, rate=30, period_s=1.0, joints=3):
    """Postures of a body that swings `periods` times, (N, joints * 3)."""
    phase = 2 * np.pi * np.arange(round(periods * period_s * rate)) / (period_s * rate)
    return np.stack([0.3 * np.cos(phase + k) for k in range(joints * 3)], axis=1)


def matrix(postures):
    a = postures.reshape(len(postures), -1, 3)
    return np.linalg.norm(a[:, None] - a[None], axis=-1).mean(axis=-1).astype(np.float32)


def trace(D, rate=30.0):
    alike = stripes.likeness(D, rate, max_distance=0.08, min_amplitude=0.012)
    return stripes.trace_stripes(D, alike, rate, max_distance=0.08, min_duration_s=0.5)


def test_the_kernel_gives_every_path_the_gain_of_its_twin(rng):
    walk = np.cumsum(rng.normal(scale=0.02, size=(60, 6)), axis=0)
    walk[40:55] = walk[5:20] + rng.normal(scale=0.002, size=(15, 6))
    D = matrix(walk)
    theta = np.full(60, 0.06, np.float32)
    still = np.zeros(60, bool)
    still[50:53] = True
    step_into, rows, columns, gains = align_locally(
        D, theta, still, 0.03, np.float32(-0.1), np.float32(8), np.float32(0.5)
    )
    S, steps = twin.align_locally(D, theta, still, 0.03, -0.1, 8.0)
    assert len(rows) > 0
    for i, j, gain in zip(rows, columns, gains, strict=True):
        assert gain == pytest.approx(S[i, j], abs=1e-4)
    assert {(i, j) for i, j in np.argwhere(step_into != NONE)} == set(steps)


def test_a_path_walked_back_never_goes_back_in_time_and_closes_its_corridor(rng):
    D = matrix(wave(3))
    theta = np.full(len(D), 0.06, np.float32)
    step_into, rows, columns, gains = align_locally(
        D, theta, np.zeros(len(D), bool), 0.03, np.float32(-0.1), np.float32(8), np.float32(3)
    )
    order = np.argsort(-gains)
    points, offsets = walk_back(step_into, rows[order], columns[order], 4, 15)
    assert len(offsets) > 1
    for path in np.split(points, offsets[1:-1]):
        steps = {tuple(int(n) for n in step) for step in np.diff(path, axis=0)}
        assert steps <= {(1, 1), (2, 1), (1, 2)}
    assert all(step_into[i, j] == NONE for i, j in points)


def test_a_swing_shows_one_stripe_a_period():
    found = trace(matrix(wave(4)))
    assert sorted(round(stripe.lag) for stripe in found) == [30, 60, 90]
    assert all(stripe.cost < 1e-3 and stripe.contrast > 0.95 for stripe in found)


def test_stillness_shows_no_stripe(rng):
    still = np.zeros((200, 9)) + rng.normal(scale=0.001, size=(200, 9))
    assert trace(matrix(still)) == []


def test_time_reversed_movement_shows_no_stripe():
    once = np.cumsum(np.full((60, 9), 0.02), axis=0)
    assert trace(matrix(np.concatenate((once, once[::-1])))) == []


def test_unseen_moments_are_never_alike():
    D = matrix(wave(3))
    D[40:50] = D[:, 40:50] = np.nan
    found = trace(D)
    assert all(np.isfinite(stripe.cost) for stripe in found)
    assert all(np.isfinite(D[stripe.path[[0, -1], 0], stripe.path[[0, -1], 1]]).all() for stripe in found)


def test_a_moment_is_carried_there_and_back():
    stripe = max(trace(matrix(wave(3))), key=lambda s: s.gain)
    assert stripe.backward(stripe.forward(20.0)) == pytest.approx(20.0, abs=1.5)


def test_a_part_is_measured_anew():
    D = matrix(wave(3))
    alike = stripes.likeness(D, 30.0, max_distance=0.08, min_amplitude=0.012)
    whole = max(trace(D), key=lambda s: s.gain)
    half = np.arange(len(whole.path)) < len(whole.path) // 2
    piece = stripes.part(whole, half, D, alike)
    assert piece.a[0] == whole.a[0]
    assert piece.a[1] < whole.a[1]
    assert stripes.part(whole, np.zeros(len(half), bool), D, alike) is None
