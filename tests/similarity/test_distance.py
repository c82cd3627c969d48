"""Distance matrices: the laws of a metric, the twin, unseen points, rotations, memory."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.features import FeatureSequence
from leitmotion.motion import DataError, ParameterError
from leitmotion.similarity import cross_distance, distance, self_distance
from oracles.similarity import cross_distance as twin


def sequence(values, width=3, rate=60.0, scale=1.0):
    values = np.asarray(values, float)
    names = tuple(f"p{m}" for m in range(values.shape[1] // width))
    return FeatureSequence(values, names, rate=rate, width=width, scale=scale)


def quaternions(rng, frames, joints):
    q = rng.standard_normal((frames, joints, 4))
    return (q / np.linalg.norm(q, axis=2, keepdims=True)).reshape(frames, -1)


@settings(deadline=None, max_examples=40)
@given(
    frames=st.integers(0, 9),
    points=st.integers(1, 5),
    width=st.integers(1, 5),
    holes=st.booleans(),
    seed=st.integers(0, 999),
)
def test_self_distance_equals_its_twin(frames, points, width, holes, seed):
    rng = np.random.default_rng(seed)
    values = rng.standard_normal((frames, points * width))
    if holes:
        values[rng.random(values.shape) < 0.2] = np.nan
    found = self_distance(sequence(values, width)).values
    np.testing.assert_allclose(found, twin(values, values, width), rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize(("n", "m"), [(1, 700), (255, 257), (256, 256), (300, 5)])
def test_every_border_of_a_tile_is_filled(rng, n, m):
    a, b = rng.standard_normal((n, 9)), rng.standard_normal((m, 9))
    a[0, 0], b[-1, -1] = np.nan, np.nan
    rows, columns = np.r_[0, n // 2, n - 1], np.r_[0, m // 2, m - 1]
    found = cross_distance(sequence(a), sequence(b)).values
    assert np.isfinite(found).all()
    np.testing.assert_allclose(found[np.ix_(rows, columns)], twin(a[rows], b[columns], 3), rtol=1e-5)


def test_it_is_a_metric(rng):
    C = self_distance(sequence(rng.standard_normal((300, 30)))).values
    assert np.array_equal(C, C.T)
    assert not C.diagonal().any()
    assert (C[~np.eye(300, dtype=bool)] > 0).all()
    for k in range(0, 300, 7):
        assert (C[:, [k]] + C[[k]] - C > -1e-5).all()


def test_a_part_is_compared_as_in_the_whole(rng):
    whole = sequence(rng.standard_normal((600, 12)))
    C = cross_distance(whole, whole).values
    np.testing.assert_array_equal(cross_distance(whole[:7], whole).values.shape, (7, 600))
    np.testing.assert_allclose(C, self_distance(whole).values, atol=1e-6)
    np.testing.assert_allclose(cross_distance(whole[100:401], whole[3:9]).values, C[100:401, 3:9], atol=1e-6)
    np.testing.assert_array_equal(C, cross_distance(whole, whole).values)


def test_the_fast_path_and_the_one_for_gaps_agree_to_the_bit(rng):
    values = rng.standard_normal((333, 9))
    values -= values.mean(axis=0)
    gap = np.vstack([values, np.full((1, 9), np.nan)])
    with_gap = self_distance(sequence(gap)).values
    np.testing.assert_array_equal(with_gap[:-1, :-1], self_distance(sequence(values)).values)
    assert np.isnan(with_gap[-1]).all()


def test_place_and_turn_of_both_frames_do_not_matter(rng):
    p = rng.standard_normal((50, 4, 3))
    turn, _ = np.linalg.qr(rng.standard_normal((3, 3)))
    moved = p @ turn + [1000.0, -2000.0, 500.0]
    C, D = (self_distance(sequence(x.reshape(50, -1))).values for x in (p, moved))
    np.testing.assert_allclose(C, D, atol=2e-6)


def test_a_mean_does_not_grow_with_the_number_of_points(rng):
    p = rng.standard_normal((40, 6))
    twice = np.concatenate([p, p], axis=1)
    np.testing.assert_allclose(
        self_distance(sequence(p)).values, self_distance(sequence(twice)).values, rtol=1e-6
    )


def test_points_unseen_in_either_frame_are_left_out():
    a = [[0, 0, 0, 9, 9, 9], [3, 4, 0, np.nan, 9, 9], [np.nan] * 6]
    C = self_distance(sequence(a)).values
    assert C[0, 1] == 5.0
    assert np.isnan(C[2]).all()


def test_geodesic_is_the_mean_angle(rng):
    q = quaternions(rng, 60, 3)
    C = self_distance(sequence(q, 4), metric="geodesic")
    np.testing.assert_allclose(C.values, twin(q, q, 4, "geodesic"), atol=2e-6)
    assert (C.unit, C.scale) == ("rad", 1.0)
    assert not C.values.diagonal().any()


def test_geodesic_knows_no_difference_between_q_and_minus_q(rng):
    q = quaternions(rng, 40, 2)
    signs = np.repeat(rng.choice([-1.0, 1.0], (40, 2)), 4, axis=1)
    C, D = (self_distance(sequence(x, 4), metric="geodesic").values for x in (q, q * signs))
    np.testing.assert_array_equal(C, D)


@pytest.mark.parametrize("angle", [1e-5, 1e-3, 0.1, 1.0, np.pi / 2, 3.0, np.pi])
def test_geodesic_of_a_turn_is_its_angle(angle):
    q = [[1, 0, 0, 0], [np.cos(angle / 2), 0, np.sin(angle / 2), 0]]
    C = self_distance(sequence(q, 4), metric="geodesic").values
    assert C[0, 1] == pytest.approx(angle, rel=2e-6)


def test_geodesic_passes_over_unseen_joints(rng):
    q = quaternions(rng, 5, 2)
    q[1, :4] = np.nan
    C = self_distance(sequence(q, 4), metric="geodesic").values
    np.testing.assert_allclose(C, twin(q, q, 4, "geodesic"), atol=2e-6)


def test_the_matrix_knows_rates_scale_and_unit(rng):
    a, b = rng.standard_normal((4, 3)), rng.standard_normal((5, 3))
    C = cross_distance(sequence(a, rate=30, scale=1.6), sequence(b, rate=120, scale=1.8))
    assert (C.row_rate, C.column_rate, C.unit, C.metric) == (30, 120, "m", "mean_norm")
    assert C.scale == pytest.approx(1.7)
    assert C.values.dtype == np.float32
    assert not C.values.flags.writeable


def test_what_cannot_be_compared_says_why(rng):
    points = sequence(rng.standard_normal((4, 6)))
    other = points.replace(names=("p0", "nose"))
    with pytest.raises(ParameterError, match="stand in one only: nose, p1"):
        cross_distance(points, other)
    with pytest.raises(ParameterError, match="one unit, got 'm' and 'px'"):
        cross_distance(points, points.replace(unit="px"))
    with pytest.raises(ParameterError, match="groups of 4 values, got groups of 3"):
        self_distance(points, metric="geodesic")
    with pytest.raises(ParameterError, match="mean_norm, geodesic, got 'cosine'"):
        self_distance(points, metric="cosine")


def test_a_matrix_beyond_memory_is_a_sentence(rng, monkeypatch):
    points = sequence(rng.standard_normal((100, 3)))
    monkeypatch.setattr(distance, "_memory", lambda: 30_000.0)
    with pytest.raises(DataError, match=r"100 moments with 100 needs 0\.0 GB of memory"):
        self_distance(points)
    assert self_distance(points[:50]).values.shape == (50, 50)
