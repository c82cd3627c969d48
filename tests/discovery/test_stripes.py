"""Stripes: the kernels against their twins, and what a stripe must be."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion.discovery import _kernels, _near_kernels, _path_kernels, stripes, tracing
from leitmotion.discovery.tiles import BLOCK, LANES, filled_up, side_by_side
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances, self_distance
from oracles import stripes as twin


def wave(periods, rate=30, period_s=1.0, joints=3):
    """Postures of a body that swings `periods` times, (N, joints * 3)."""
    phase = 2 * np.pi * np.arange(round(periods * period_s * rate)) / (period_s * rate)
    return np.stack([0.3 * np.cos(phase + k) for k in range(joints * 3)], axis=1)


def compared(postures, rate=30.0):
    names = tuple(f"joint {k}" for k in range(postures.shape[1] // 3))
    return Distances(FeatureSequence(postures, names, rate, ("place",), 3))


def narrow(values, width):
    names = tuple(f"number {k}" for k in range(values.shape[1] // width))
    return Distances(FeatureSequence(values, names, 30.0, ("place",), width))


def trace(postures):
    distances = compared(postures)
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    return tracing.trace_stripes(distances, alike, max_distance=0.08, min_duration_s=0.5).stripes


@pytest.fixture(scope="module")
def wandering():
    """Two minutes of movement of which some comes back, with a rest and with moments that were not seen."""
    rng = np.random.default_rng(4)
    walk = np.cumsum(rng.normal(scale=0.015, size=(700, 6)), axis=0) % 0.5
    walk[400:520] = walk[50:170] + rng.normal(scale=0.003, size=(120, 6))
    walk[600:660] = walk[100:220:2] + rng.normal(scale=0.003, size=(60, 6))
    walk[300:350] = walk[300]
    walk[230:236] = np.nan
    walk[470:480, :3] = np.nan
    return walk


@pytest.fixture(scope="module")
def aligned(wandering):
    distances = compared(wandering)
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    live, _ = tracing._align(distances, alike, 0.08, 15, len(distances))
    D = self_distance(distances.features).values
    return live, D, twin.align_locally(D, alike.threshold, alike.still, 0.04, -0.1, 8.1)


def live_cells(live):
    """Steps of all live cells, by cell."""
    cells = {}
    for i, (first, stop) in enumerate(pairwise(live.row_offsets)):
        for place, steps in zip(
            live.places[first:stop].tolist(), live.steps[first:stop].tolist(), strict=True
        ):
            for lane in range(LANES):
                step = steps >> _kernels.BITS * lane & 2**_kernels.BITS - 1
                if step != _kernels.NONE:
                    cells[i, place * LANES + lane] = step
    return cells


def test_the_cells_looked_at_are_those_that_hold_a_path(aligned):
    live, _, (_, steps) = aligned
    cells = live_cells(live)
    assert len(cells) > 1000
    assert set(cells) == set(steps)
    came = {_kernels.START: None, _kernels.DIAGONAL: (1, 1), _kernels.STEEP: (2, 1), _kernels.FLAT: (1, 2)}
    for (i, j), how in cells.items():
        expected = None if came[how] is None else (i - came[how][0], j - came[how][1])
        assert expected == steps[i, j]


def test_the_kernel_gives_every_path_the_gain_of_its_twin(aligned):
    live, _, (S, _) = aligned
    assert len(live.rows) > 10
    for i, j, gain in zip(live.rows, live.columns, live.gains, strict=True):
        assert gain == pytest.approx(S[i, j], abs=1e-3)


def test_paths_end_where_nothing_that_gains_follows_and_no_neighbour_gains_more(aligned):
    live, _, (S, steps) = aligned
    extended = {source for cell, source in steps.items() if source in steps and S[cell] - S[source] > 1e-6}
    around = np.pad(S, 1)
    ends = {
        (i, j)
        for i, j in set(steps) - extended
        if S[i, j] > 3 and S[i, j] >= around[i + 1, j] and S[i, j] > around[i + 1, j + 2]
    }
    assert set(zip(live.rows.tolist(), live.columns.tolist(), strict=True)) == ends


@pytest.mark.parametrize("width", [1, 2, 3, 4])
def test_no_two_postures_are_nearer_than_their_blocks_say(wandering, rng, width):
    N = 690
    distances = narrow(wandering[:N, : 6 // width * width], width)
    theta = np.full(N, 0.1, np.float32)
    theta[rng.integers(0, N, 100)] = -1
    theta[np.isnan(wandering[:N]).all(axis=1)] = -1
    centres, radius, most = _near_kernels.block_bounds(distances.across, width, theta)
    blocks = np.flatnonzero(most > 0)
    assert 0 < len(blocks) < len(most)
    tiles, wide = side_by_side(distances.across, width)
    centres, _ = side_by_side(centres[:, blocks], width)
    radius, most = filled_up(radius[blocks], 0), filled_up(most[blocks], -1)
    chosen, offsets, apart, begins = _near_kernels.candidates(
        tiles, filled_up(theta, -1), centres, radius, most, blocks, wide, 0, len(blocks), 0, N // BLOCK, N
    )
    D = np.full((N, len(tiles) * LANES), np.nan, np.float32)
    D[:, :N] = self_distance(distances.features).values
    like = np.minimum.outer(theta, filled_up(theta, -1)) > D
    offered = np.zeros(D.shape, bool)
    for b, (first, stop) in enumerate(pairwise(offsets)):
        for k in range(first, stop):
            cells = slice(BLOCK * b, BLOCK * (b + 1)), slice(chosen[k] * LANES, (chosen[k] + 1) * LANES)
            offered[cells] = True
            np.testing.assert_array_equal(apart[k].reshape(BLOCK, LANES), D[cells])
            np.testing.assert_array_equal(begins[k], like[cells].any(axis=1))
    assert np.triu(like, 1).any()
    assert not (np.triu(like, 1) & ~offered).any()
    assert offered.mean() < 0.5


def test_a_horizon_leaves_out_what_is_farther_apart_and_nothing_else(wandering):
    distances = compared(wandering)
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    far, near = (
        tracing.trace_stripes(distances, alike, max_distance=0.08, min_duration_s=0.5, horizon_s=s)
        for s in (np.inf, 300 / 30)
    )
    assert far.limits == near.limits == {}
    assert max(stripe.lag for stripe in far.stripes) > 300
    assert max(stripe.lag for stripe in near.stripes) <= 300


def test_where_room_is_short_the_horizon_comes_nearer_and_is_told(monkeypatch, wandering):
    distances = compared(wandering)
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    monkeypatch.setattr(tracing, "LIVE", 1200)
    traced = tracing.trace_stripes(distances, alike, max_distance=0.08, min_duration_s=0.5)
    assert 0 < traced.limits["compared_within_s"] < 700 / 30
    assert max(stripe.lag for stripe in traced.stripes) <= 30 * traced.limits["compared_within_s"] + 1


def test_a_path_walked_back_never_goes_back_in_time_and_closes_its_corridor(wandering):
    distances = compared(wandering)
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    live, _ = tracing._align(distances, alike, 0.08, 15, len(distances))
    before = live_cells(live)
    points, lengths, _ = tracing._follow(live, 30.0, 15)
    assert len(lengths) > 2
    after = live_cells(live)
    for path in np.split(points, np.cumsum(lengths)[:-1]):
        steps = {tuple(int(n) for n in step) for step in np.diff(path, axis=0)}
        assert steps <= {(1, 1), (2, 1), (1, 2)}
        assert min(path[-1] - path[0]) + 1 >= 15
        for i, j in path.tolist():
            square = {(i + a, j + b) for a in range(-4, 5) for b in range(-4, 5)}
            assert not square & set(after)
    assert set(after) < set(before)


def test_a_swing_shows_one_stripe_a_period():
    found = trace(wave(4))
    assert sorted(round(stripe.lag) for stripe in found) == [30, 60, 90]
    assert all(stripe.cost < 1e-3 and stripe.contrast > 0.95 for stripe in found)


def test_stillness_shows_no_stripe(rng):
    still = np.zeros((200, 9)) + rng.normal(scale=0.001, size=(200, 9))
    assert trace(still) == []


def test_time_reversed_movement_shows_no_stripe():
    once = np.cumsum(np.full((60, 9), 0.02), axis=0)
    assert trace(np.concatenate((once, once[::-1]))) == []


def test_unseen_moments_are_never_alike():
    swing = wave(3)
    swing[40:50] = np.nan
    D = self_distance(compared(swing).features).values
    found = trace(swing)
    assert found
    assert all(np.isfinite(stripe.cost) for stripe in found)
    assert all(np.isfinite(D[stripe.path[[0, -1], 0], stripe.path[[0, -1], 1]]).all() for stripe in found)


def test_a_moment_is_carried_there_and_back():
    stripe = max(trace(wave(3)), key=lambda s: s.gain)
    assert stripe.backward(stripe.forward(20.0)) == pytest.approx(20.0, abs=1.5)


def test_a_part_is_measured_anew():
    distances = compared(wave(3))
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    whole = max(trace(wave(3)), key=lambda s: s.gain)
    half = np.arange(len(whole.path)) < len(whole.path) // 2
    (piece,) = stripes.measure([stripes.part(whole, half)], distances, alike)
    assert piece.a[0] == whole.a[0]
    assert piece.a[1] < whole.a[1]
    nothing = stripes.part(whole, np.zeros(len(half), bool))
    assert stripes.measure([nothing], distances, alike) == [None]


def test_a_stripe_is_measured_as_its_twin_says(wandering):
    distances = compared(wandering)
    alike = stripes.likeness(distances, max_distance=0.08, min_amplitude=0.012)
    D = self_distance(distances.features).values
    found = trace(wandering)
    assert found
    for stripe in found:
        cost, background, gain = twin.measure(stripe.path, D, alike)
        assert (stripe.cost, stripe.background, stripe.gain) == pytest.approx(
            (cost, background, gain), rel=1e-5
        )


@pytest.mark.parametrize("size", [1, 2, 63, 64, 65, 600, 601, 4000])
def test_the_middle_of_distances_is_their_median(rng, size):
    for distances in (
        rng.uniform(0.02, 0.4, size),
        rng.integers(1, 4, size),
        np.full(size, 0.1),
        rng.exponential(size=size),
    ):
        distances = distances.astype(np.float32)
        assert _path_kernels.median(distances) == np.median(distances)
