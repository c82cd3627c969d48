"""What may have been missed: eq. 6 by its laws and its twin, seams, chains, and a move that a search left over."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.discovery import Pattern, Patterns, residual, search_residual
from leitmotion.discovery.residual import Match
from leitmotion.features import FeatureSequence
from leitmotion.motion import ParameterError, Segmentation
from oracles import residual as twin

RATE = 30.0
NOTHING = Patterns((), (), RATE, {})


def wandering(rng, moments, joints=4):
    """Make a smooth way of some joints, of which one keeps still."""
    steps = rng.standard_normal((moments, joints, 3))
    smooth = np.stack([np.convolve(s, np.hanning(9), "same") for s in steps.reshape(moments, -1).T], axis=1)
    way = 0.05 * smooth.reshape(moments, joints, 3)
    way[:, 0] = 1.0
    return way


def described(values, rate=RATE):
    names = tuple(f"joint {k}" for k in range(values.shape[1]))
    return FeatureSequence(
        values.reshape(len(values), 3 * len(names)), names, rate=rate, width=values.shape[2]
    )


def r(a, b, min_spread=0.003):
    length = len(a)
    moves = [residual.standardised(described(one), length, min_spread) for one in (a, b)]
    return float(residual.correlations(*moves)[0, 0])


def pattern_of(*spans, rate=RATE):
    starts, stops = zip(*spans, strict=True)
    held = Segmentation(starts, stops, rate=rate)
    return Patterns((Pattern("A", "acyclic", held, held, 1.0, 0.0, 1.0),), (), rate, {})


def test_a_window_correlates_fully_with_itself_and_not_at_all_against_itself(rng):
    a = wandering(rng, 15)
    assert r(a, a) == pytest.approx(1.0, abs=1e-6)
    assert r(a, -a) == pytest.approx(-1.0, abs=1e-6)


def test_correlation_is_symmetric_and_within_one(rng):
    a, b = wandering(rng, 15), wandering(rng, 15)
    assert r(a, b) == pytest.approx(r(b, a), abs=1e-6)
    assert -1 <= r(a, b) <= 1


@settings(deadline=None, max_examples=30)
@given(seed=st.integers(0, 999), scale=st.floats(0.2, 20), shift=st.floats(-3, 3))
def test_place_of_each_joint_and_scale_of_each_axis_say_nothing(seed, scale, shift):
    rng = np.random.default_rng(seed)
    a, b = wandering(rng, 15), wandering(rng, 15)
    moved = b * [1.0, scale, 1.0] + shift * rng.standard_normal((1, 4, 3))
    assert r(a, moved) == pytest.approx(r(a, b), abs=1e-4)


def test_one_joint_gives_pearsons_coefficient_of_each_axis(rng):
    a, b = wandering(rng, 15, 2), wandering(rng, 15, 2)
    pearson = [np.corrcoef(a[:, 1, axis], b[:, 1, axis])[0, 1] for axis in range(3)]
    assert r(a, b) == pytest.approx(np.mean(pearson), abs=1e-5)


def test_joints_that_keep_still_do_not_thin_it_out(rng):
    a, b = wandering(rng, 15, 2), wandering(rng, 15, 2)
    more = [np.concatenate((one, np.ones((15, 30, 3))), axis=1) for one in (a, b)]
    assert r(*more, min_spread=0) == pytest.approx(r(a, b), abs=1e-5)


def test_stillness_has_no_correlation(rng):
    still = np.ones((15, 4, 3))
    sway = still + 0.001 * rng.standard_normal(still.shape)
    assert np.isnan(r(still, wandering(rng, 15)))
    assert np.isnan(r(sway, sway))
    found = search_residual(described(np.concatenate([sway] * 8)), NOTHING)
    assert (len(found), len(found.left_over)) == (0, 1)


def test_an_axis_that_both_keep_still_is_left_out_and_one_that_one_keeps_is_0(rng):
    a = wandering(rng, 15) * [1.0, 1.0, 0.0]
    assert r(a, a) == pytest.approx(1.0, abs=1e-6)
    assert r(a, a + wandering(rng, 15) * [0.0, 0.0, 1.0]) == pytest.approx(2 / 3, abs=1e-6)


@settings(deadline=None, max_examples=20)
@given(seed=st.integers(0, 999), length=st.integers(3, 9), least=st.floats(0, 0.8), seams=st.integers(0, 3))
def test_matches_equal_their_twin(seed, length, least, seams):
    rng = np.random.default_rng(seed)
    values = wandering(rng, 60)
    values[20:28] = 1.0
    edges = np.unique([0, *rng.choice(np.arange(1, 60), seams, replace=False), 60]).tolist()
    spans = [(a, b - 1) for a, b in pairwise(edges)]
    movement = residual.standardised(described(values), length, 0.003)
    found = residual._matches(movement, spans, length, least)
    expected = twin.matches(values, spans, length, least, 0.003)
    assert [[m[:2] for m in row] for row in found] == [[m[:2] for m in row] for row in expected]
    for row, wanted in zip(found, expected, strict=True):
        np.testing.assert_allclose([m[2] for m in row], [m[2] for m in wanted], atol=1e-4)


def test_matches_that_follow_one_another_are_one_candidate():
    rows = [[Match(0, 40, 0.9)], [Match(10, 52, 0.8), Match(10, 80, 0.7)], [Match(20, 61, 0.9)]]
    chains = residual._merge(rows, [(0, 120)], 10)
    assert [[m.place for m in chain] for chain in chains] == [[40, 52, 61], [80]]


@pytest.mark.parametrize(
    ("second", "spans"),
    [
        (Match(10, 56, 0.9), [(0, 120)]),  # more than half as fast again
        (Match(10, 50, 0.9), [(0, 50), (50, 120)]),  # beyond a seam
        (Match(30, 50, 0.9), [(0, 10), (30, 120)]),  # windows apart
    ],
)
def test_what_does_not_follow_is_another_candidate(second, spans):
    chains = residual._merge([[Match(0, 40, 0.9)], [second]], spans, 10)
    assert [len(chain) for chain in chains] == [1, 1]


def test_the_two_sides_of_a_candidate_never_overlap():
    t = np.arange(300) / RATE
    circle = np.stack([np.cos(3 * t), np.sin(3 * t), 0 * t], axis=1)[:, None]
    found = search_residual(described(circle), NOTHING)
    assert len(found)
    assert all(one.a[1] <= one.b[0] for one in found)


@pytest.mark.parametrize("rate", [30.0, 60.0, 120.0])
def test_a_move_that_was_missed_is_found_between_what_was_not(rng, rate):
    move, other, end = wandering(rng, 45), wandering(rng, 60), wandering(rng, 30)
    whole = np.concatenate([move, other, 1.5 * move + 0.2, end])
    moments = np.arange(round(len(whole) * rate / RATE)) * RATE / rate
    values = np.stack(
        [np.interp(moments, np.arange(len(whole)), x) for x in whole.reshape(len(whole), -1).T], 1
    )
    features = described(values.reshape(-1, 4, 3), rate)
    nothing = NOTHING.replace(rate=rate)
    best = search_residual(features, nothing).candidates[0]
    assert np.array([*best.a, *best.b]) / rate == pytest.approx([0, 1.5, 3.5, 5.0], abs=0.04)
    assert best.correlation > 0.95
    held = pattern_of((0, round(1.5 * rate)), (round(5 * rate), round(5.5 * rate)), rate=rate)
    left = search_residual(features, held)
    assert [(a / rate, b / rate) for a, b, _, _ in left.left_over] == [
        pytest.approx((1.5, 5.0), abs=0.02),
        pytest.approx((5.5, 6.0), abs=0.02),
    ]
    assert all(one.a[0] >= 1.5 * rate and one.correlation < 0.95 for one in left)


def test_no_candidate_crosses_a_seam(rng):
    features = described(wandering(rng, 300))
    patterns = pattern_of((50, 70), (110, 140), (200, 215))
    found = search_residual(features, patterns, min_correlation=0.0)
    spans = [(a, b) for a, b, _, _ in found.left_over]
    assert spans == [(0, 50), (70, 110), (140, 200), (215, 300)]
    assert len(found) > 10
    for one in found:
        for start, stop in (one.a, one.b):
            assert any(a <= start and stop <= b for a, b in spans)


def test_the_best_comes_first(rng):
    found = search_residual(described(wandering(rng, 300)), NOTHING, min_correlation=0.3)
    weights = [one.correlation * (one.a[1] - one.a[0]) for one in found]
    assert weights == sorted(weights, reverse=True)
    assert all(0.3 < one.correlation <= 1 for one in found)


def test_what_was_unseen_adds_nothing(rng):
    values = wandering(rng, 90)
    seen = search_residual(described(values), NOTHING, min_correlation=0.3)
    values[:, 3] = np.nan
    less = search_residual(described(values), NOTHING, min_correlation=0.3)
    assert np.isfinite([one.correlation for one in less]).all()
    assert less != seen
    values[:] = np.nan
    assert len(search_residual(described(values), NOTHING)) == 0


@pytest.mark.parametrize("moments", [0, 1, 10, 29])
def test_what_is_too_short_for_two_windows_has_no_candidate(rng, moments):
    found = search_residual(described(wandering(rng, 40)[:moments]), NOTHING)
    assert len(found) == 0


@pytest.mark.parametrize(
    ("option", "value", "complaint"),
    [
        ("window_s", 0, "window_s must be positive"),
        ("window_s", np.nan, "window_s must be positive"),
        ("min_correlation", 1.0, r"min_correlation must lie in \[0, 1\)"),
        ("min_spread", -1, "min_spread must be 0 or more"),
    ],
)
def test_options_must_make_sense(rng, option, value, complaint):
    with pytest.raises(ParameterError, match=complaint):
        search_residual(described(wandering(rng, 60)), NOTHING, **{option: value})


def test_patterns_must_be_of_the_recording(rng):
    with pytest.raises(ParameterError, match="at 60 Hz, this one is at 30 Hz"):
        search_residual(described(wandering(rng, 60)), NOTHING.replace(rate=60.0))
    with pytest.raises(ParameterError, match="reach to"):
        search_residual(described(wandering(rng, 60)), pattern_of((0, 20), (40, 100)))
