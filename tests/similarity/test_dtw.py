"""Alignments: the laws of time warping, and the cheapest of all paths."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.features import FeatureSequence
from leitmotion.motion import DataError, ParameterError
from leitmotion.similarity import align, cross_distance, warping_cost
from oracles.dtw import PATTERNS, cheapest

STEPS = sorted(PATTERNS)


def weighted_cost(d, path, step):
    """Cost and weight of a path by its steps."""
    diagonal = PATTERNS[step][1]
    weights = [diagonal] + [diagonal if all(s == 1) else 1 for s in np.diff(path, axis=0)]
    return sum(w * d[tuple(cell)] for w, cell in zip(weights, path, strict=True)), sum(weights)


def walk(phase):
    """Make a curve that never meets itself, at the phases given."""
    phase = np.asarray(phase, float)
    values = np.stack([np.cos(phase), np.sin(phase), phase / 3], axis=1)
    return FeatureSequence(values, ("hand",), rate=60, width=3)


@settings(deadline=None, max_examples=80)
@given(
    n=st.integers(1, 5),
    m=st.integers(1, 5),
    step=st.sampled_from(STEPS),
    open_begin=st.booleans(),
    open_end=st.booleans(),
    seed=st.integers(0, 999),
)
def test_no_path_is_cheaper(n, m, step, open_begin, open_end, seed):
    d = np.random.default_rng(seed).random((n, m))
    best = cheapest(d, step, open_begin=open_begin, open_end=open_end)
    if best is None:
        with pytest.raises(DataError, match="No path"):
            align(d, step=step, open_begin=open_begin, open_end=open_end)
        return
    found = align(d, step=step, open_begin=open_begin, open_end=open_end)
    cost, weight = weighted_cost(d, found.path, step)
    assert (cost / weight if open_end else cost) == pytest.approx(best[0])
    assert found.stop - 1 in best[1]


@pytest.mark.parametrize("step", STEPS)
def test_a_path_is_monotone_without_a_gap(rng, step):
    path = align(rng.random((40, 50)), step=step).path
    steps = np.diff(path, axis=0)
    assert path[0].tolist() == [0, 0]
    assert path[-1].tolist() == [39, 49]
    assert ((steps >= 0) & (steps <= 1)).all()
    assert steps.any(axis=1).all()


@pytest.mark.parametrize("step", STEPS)
def test_a_stretch_with_itself_is_the_diagonal(step):
    x = walk(np.linspace(0, 20, 90))
    found = align(x, x, step=step)
    assert found.cost == 0
    np.testing.assert_array_equal(found.path, np.repeat(np.arange(90)[:, None], 2, axis=1))


@pytest.mark.parametrize("step", STEPS)
def test_another_tempo_costs_nothing(step):
    phase = np.linspace(0, 10, 400)
    x, slower = walk(phase), walk(10 * (np.linspace(0, 1, 600) + 0.02 * np.sin(np.linspace(0, 7, 600))))
    found = align(x, slower, step=step, open_end=True)
    assert found.cost < 0.02
    assert align(x, walk(-phase), step=step).cost > 0.5


def test_swapping_the_stretches_turns_the_path(rng):
    d = rng.random((30, 35))
    np.testing.assert_array_equal(align(d).path, align(d.T).path[:, ::-1])
    assert align(d).cost == align(d.T).cost


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("shape", [(1, 1), (7, 9), (20, 20)])
def test_a_constant_distance_is_the_mean(step, shape):
    assert align(np.full(shape, 0.3), step=step).cost == pytest.approx(0.3)


def test_the_slope_stays_within_its_limit(rng):
    path = align(rng.random((60, 90)), step="symmetricP1").path
    ahead = path[np.searchsorted(path[:, 0], np.arange(60), side="left"), 1]
    assert (np.diff(ahead) <= 2).all()
    runs = (np.diff(path, axis=0) == 0).any(axis=1)
    assert not (runs[1:] & runs[:-1]).any()


def test_an_open_begin_and_end_find_a_part_in_the_whole():
    whole = walk(np.linspace(0, 30, 600))
    found = align(whole[200:300], whole, open_begin=True, open_end=True)
    assert found.cost < 1e-6
    assert (found.path[0, 1], found.stop) == (200, 300)


def test_missing_distances_are_walked_round(rng):
    d = np.ones((6, 6))
    d[2, 2] = d[3, 3] = np.nan
    assert align(d).cost == 1.0
    d[2] = np.nan
    with pytest.raises(DataError, match="No path"):
        align(d)


def test_a_matrix_or_its_two_stretches_say_the_same(rng):
    x, y = walk(np.linspace(0, 9, 50)), walk(np.linspace(0, 9.5, 60))
    assert align(x, y) == align(cross_distance(x, y)) == align(cross_distance(x, y).values)


def test_what_cannot_be_aligned_says_why():
    x = walk([0, 1, 2])
    with pytest.raises(ParameterError, match="symmetric1, symmetric2, symmetricP1, got 'rabiner'"):
        align(x, x, step="rabiner")
    with pytest.raises(ParameterError, match="got one sequence"):
        align(x)
    with pytest.raises(ParameterError, match="a matrix and more"):
        align(np.ones((2, 2)), x)
    with pytest.raises(DataError, match="at least one frame"):
        align(x[:0], x)
    with pytest.raises(DataError, match="more than twice as long"):
        align(np.ones((3, 9)), step="symmetricP1")


@settings(deadline=None, max_examples=60)
@given(n=st.integers(1, 12), m=st.integers(1, 12), equal=st.booleans(), seed=st.integers(0, 999))
def test_the_cost_is_the_same_without_the_path(n, m, equal, seed):
    rng = np.random.default_rng(seed)
    one, other = (
        FeatureSequence(rng.integers(0, 2, (k, 6)) if equal else rng.random((k, 6)), ("a", "b"), 30, width=3)
        for k in (n, m)
    )
    assert warping_cost(one, other, 9.0) == pytest.approx(align(one, other).cost, rel=1e-6)


def test_moments_that_were_not_seen_cost_nothing_and_those_that_share_no_joint_what_is_said():
    values = np.arange(24.0).reshape(4, 6)
    values[1] = np.nan
    one = FeatureSequence(values, ("a", "b"), 30, width=3)
    assert warping_cost(one, one.replace(values=values[[0, 2, 3]]), 9.0) == 0
    left, right = values.copy()[:1], values.copy()[:1]
    left[:, :3], right[:, 3:] = np.nan, np.nan
    assert warping_cost(one.replace(values=left), one.replace(values=right), 9.0) == 9.0
    assert warping_cost(one[1:2], one, 9.0) == 9.0


def test_what_does_not_hold_the_same_features_is_not_compared():
    with pytest.raises(ParameterError, match="same features"):
        warping_cost(walk([0, 1]), walk([0, 1]).replace(names=("foot",)), 1.0)
