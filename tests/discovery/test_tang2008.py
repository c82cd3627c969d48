"""Paper P to the letter: its steps against their twins, its equations by hand, its verdicts on made motion."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion import body, features, io
from leitmotion.discovery import _tang_kernels as kernels
from leitmotion.discovery import autocorrelation, tang2008
from leitmotion.discovery.tang2008 import Trace, find_patterns_tang2008
from leitmotion.features import FeatureSequence
from leitmotion.motion import ParameterError
from oracles import tang2008 as twin


def hand(values, rate=60.0):
    values = np.asarray(values, float)
    return FeatureSequence(values, ("hand",), rate=rate, width=3)


def circling(turns, rate=60.0, period=1.0):
    phase = 2 * np.pi * np.arange(round(turns * period * rate)) / (period * rate)
    return np.stack([np.cos(phase), np.sin(phase), 0 * phase], axis=1)


def wandering(rng, seconds, rate=60.0):
    """Make a smooth way through space that does not meet itself for long."""
    knots = rng.standard_normal((round(seconds * 3) + 1, 3)).cumsum(axis=0)
    t = np.linspace(0, len(knots) - 1, round(seconds * rate))
    return np.stack([np.interp(t, np.arange(len(knots)), k) for k in knots.T], axis=1)


def random_matrix(rng, n):
    way = np.cumsum(rng.standard_normal((n, 2)), axis=0) % 4
    C = np.linalg.norm(way[:, None] - way, axis=2).astype(np.float32)
    return C / C.max()


def stripes(n, *, lag, gap=range(0), slope=1.0):
    """Make a matrix that is far everywhere but along one diagonal stripe."""
    C = np.ones((n, n), np.float32)
    for x in range(lag, n):
        y = round((x - lag) * slope)
        if x not in gap and 0 < y < x:
            for d in (-1, 0, 1):
                C[x, y + d] = C[y + d, x] = 0.1 * abs(d)
    np.fill_diagonal(C, 0)
    return C


def marked(points, n):
    minima = np.zeros((n, n), np.bool_)
    for x, y in points:
        minima[x, y] = True
    return minima


@settings(deadline=None, max_examples=25)
@given(
    n=st.integers(3, 40),
    threshold=st.floats(0.1, 0.9),
    apart=st.integers(1, 6),
    reach=st.integers(1, 3),
    seed=st.integers(0, 999),
)
def test_thinning_starts_and_tracing_equal_their_twins(n, threshold, apart, reach, seed):
    C = random_matrix(np.random.default_rng(seed), n)
    minima = np.zeros((n, n), np.bool_)
    kernels.thin(C, threshold, apart, minima)
    expected = twin.thin(C, threshold, apart)
    assert {(int(x), int(y)) for x, y in np.argwhere(minima)} == expected
    starts = kernels.start_points(minima, reach)
    assert starts == twin.start_points(expected, reach)
    for start in starts[:4]:
        found = kernels.trace(C, minima, *start, apart, 5, 7, 0.5)
        assert found == twin.trace(C, expected, start, apart, (5, 7), 0.5)


def test_a_start_point_needs_something_ahead_and_nothing_behind():
    diagonal = [(20 + k, 5 + k) for k in range(6)]
    assert kernels.start_points(marked(diagonal, 40), 3) == [(20, 5)]
    against_time = [(20 + k, 15 - k) for k in range(6)]
    assert kernels.start_points(marked(against_time, 40), 3) == []
    assert kernels.start_points(marked([(20, 5)], 40), 3) == []


@pytest.mark.parametrize("slope", [-2.0, -1.0, -0.7, -0.5])
def test_an_anti_diagonal_has_no_start_point(slope):
    """It is invalid (figure 7), however flat: several of its points may lie in one row."""
    against_time = [(20 + k, round(18 + slope * k)) for k in range(9)]
    assert kernels.start_points(marked(against_time, 40), 3) == []


@pytest.mark.parametrize("slope", [0.5, 0.7, 1.0, 2.0])
def test_a_diagonal_has_one_start_point(slope):
    diagonal = [(40 + k, round(5 + slope * k)) for k in range(9)]
    assert kernels.start_points(marked(diagonal, 60), 3) == diagonal[:1]


def test_a_rest_that_is_not_of_the_duration_of_most_cycles_is_none():
    cycles = [(0, 60), (60, 125), (125, 180)]
    assert tang2008._whole([*cycles, (180, 330)]) == cycles
    assert tang2008._whole([*cycles, (180, 205)]) == cycles
    assert tang2008._whole([*cycles, (180, 215)]) == [*cycles, (180, 215)]


def traced(C):
    return tang2008._trace_patterns(C, 0.26, (30, 50), 0.5, 30, 3)


def test_a_gap_is_bridged_and_the_start_beyond_it_bypassed():
    whole, gapped = stripes(400, lag=150), stripes(400, lag=150, gap=range(250, 270))
    assert [t.segments for t in traced(gapped)] == [t.segments for t in traced(whole)]
    assert len(traced(gapped)) == 1
    torn = traced(stripes(500, lag=150, gap=range(250, 350)))
    assert len(torn) == 2


@pytest.mark.parametrize(("slope", "long"), [(1.0, True), (0.6, True), (0.4, False)])
def test_the_slope_is_limited(slope, long):
    traces = traced(stripes(400, lag=60, slope=slope))
    assert any(t.segments[1][1] - t.segments[1][0] > 200 for t in traces) == long


def by_hand(s_min, e_max):
    return Trace(np.array([[s_min, s_min + 10], [e_max - 11, e_max - 1]]), 0.1)


def test_families_are_clustered_by_where_they_start_and_end():
    """Eq. 3: Cc = |2| + |3| = 5 against 0.05 of eq. 4's D = 200, and 40 of the third."""
    a, near, far = by_hand(100, 300), by_hand(102, 303), by_hand(120, 320)
    assert tang2008._cluster([a, near, far], 0.05) == [[a, near], [far]]
    assert tang2008._cluster([a, near, far], 0.5) == [[a, near, far]]


def test_the_nearest_of_two_families_is_joined():
    a, b, between = by_hand(0, 1000), by_hand(60, 1060), by_hand(22, 1022)
    assert tang2008._cluster([a, b, between], 0.1) == [[a, between], [b]]


def test_autocorrelation_is_equation_5(rng):
    x = rng.standard_normal((50, 3))
    r = []
    for lag in range(50):
        centred = x - x.mean(axis=0)
        r.append(np.mean((centred[: 50 - lag] * centred[lag:]).sum(axis=0) / (centred**2).sum(axis=0)))
    np.testing.assert_allclose(autocorrelation._autocorrelation(x), r, atol=1e-12)
    still_and_unseen = np.column_stack([x, np.ones(50), np.r_[np.nan, x[1:, 0]]])
    np.testing.assert_allclose(autocorrelation._autocorrelation(still_and_unseen), r, atol=1e-12)
    assert not autocorrelation._autocorrelation(np.ones((50, 2))).any()


@pytest.mark.parametrize("turns", [2, 3, 8])
@pytest.mark.parametrize("rate", [30.0, 60.0, 100.0])
def test_turns_are_counted_at_any_rate(turns, rate):
    found = find_patterns_tang2008(hand(circling(turns, rate), rate))
    (pattern,) = found.patterns
    assert (pattern.kind, pattern.cycles) == ("cyclic", turns)
    assert pattern.period_s == pytest.approx(1.0, abs=0.04)
    assert pattern.confidence > 0.9
    assert pattern.occurrences.rate == rate


def test_a_move_that_comes_back_is_acyclic(rng):
    move, between, end = wandering(rng, 1.5), wandering(rng, 3), wandering(rng, 2)
    parts = [move, move[-1] + between - between[0]]
    parts += [move, move[-1] - end + end[0]]
    found = find_patterns_tang2008(hand(np.concatenate(parts)), threshold=0.1)
    first = found.patterns[0]
    assert first.kind == "acyclic"
    np.testing.assert_allclose(first.occurrences.starts[:2], [0, 270], atol=12)
    np.testing.assert_allclose(first.occurrences.stops[:2], [90, 360], atol=12)


def test_nothing_comes_back_on_a_straight_way():
    straight = np.linspace(0, 1, 500)[:, None] * [1.0, 2.0, 3.0]
    found = find_patterns_tang2008(hand(straight))
    assert found.patterns == ()
    assert "26% of the recording's largest distance" in found.nearest_miss


@pytest.mark.parametrize("frames", [0, 1, 5, 300])
def test_stillness_is_no_pattern(frames):
    found = find_patterns_tang2008(hand(np.ones((frames, 3))))
    assert (found.patterns, found.pairs) == ((), ())


def test_unseen_moments_are_in_no_pattern():
    x = circling(6)
    x[130:170] = np.nan
    found = find_patterns_tang2008(hand(x))
    for pair in found.pairs:
        assert not ((pair.path >= 130) & (pair.path < 170)).any()


def test_its_answer_is_well_formed(rng):
    noisy = circling(7) + 0.05 * rng.standard_normal((420, 3))
    found = find_patterns_tang2008(hand(np.concatenate([noisy, wandering(rng, 3) * 0.3, noisy[:200]]), 120))
    assert found.patterns
    for pattern in found.patterns:
        spans = pattern.occurrences
        assert ((spans.scores >= 0) & (spans.scores <= 1)).all()
        assert 0 <= pattern.confidence <= 1
        assert "largest distance" in pattern.reason
    stretches = {p.id: p.stretches for p in found.patterns}
    for pair in found.pairs:
        for start, stop in (pair.a, pair.b):
            holder = stretches[pair.pattern]
            assert ((holder.starts <= start) & (stop <= holder.stops)).any()
    filled = [(p.stretches.stops - p.stretches.starts).sum() for p in found.patterns]
    assert filled == sorted(filled, reverse=True)


def test_the_threshold_is_a_share_of_the_clips_own_largest_distance():
    near = find_patterns_tang2008(hand(circling(4)))
    far = find_patterns_tang2008(hand(circling(4) * 50))
    np.testing.assert_array_equal(near.patterns[0].occurrences.starts, far.patterns[0].occurrences.starts)
    assert near.parameters["max_distance_own_unit"] == pytest.approx(0.52, rel=1e-3)
    assert far.patterns[0].cost == pytest.approx(50 * near.patterns[0].cost, abs=1e-4)


@pytest.mark.parametrize("name", ["threshold", "first_window_s", "min_duration_s", "rate_hz"])
def test_parameters_must_be_positive(name):
    with pytest.raises(ParameterError, match=f"{name} must be positive, got 0"):
        find_patterns_tang2008(hand(circling(3)), **{name: 0})


def posture_of(path):
    return features.posture(body.embody(io.read(path)))


@pytest.mark.data
def test_a_walk_gives_its_steps(data):
    found = find_patterns_tang2008(posture_of(data / "bandai_namco/dataset-1_walk_normal_001.bvh"))
    first = found.patterns[0]
    assert (first.kind, first.cycles) == ("cyclic", 6)
    assert first.period_s == pytest.approx(1.08, abs=0.05)


@pytest.mark.data
def test_lying_down_gives_nothing(data):
    found = find_patterns_tang2008(posture_of(data / "hdm05/lieDownFloor/HDM_bd_lieDownFloor_001_120.amc"))
    assert len(found) == 0


@pytest.mark.data
def test_three_jumping_jacks(data):
    found = find_patterns_tang2008(posture_of(data / "cmu_bvh/jumping_jacks.bvh"))
    assert (found.patterns[0].kind, found.patterns[0].cycles) == ("cyclic", 3)
