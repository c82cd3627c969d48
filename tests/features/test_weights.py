"""Weights of joints: one scale, no joint ignored, and nothing but movement counts."""

import numpy as np
import pytest

from leitmotion.body import embody
from leitmotion.features import FeatureSequence, active_weights, posture, weighted
from leitmotion.features.weights import FLOOR
from leitmotion.motion import ParameterError
from leitmotion.similarity import self_distance
from oracles.body import human


@pytest.fixture
def dancer(rng):
    return posture(embody(human(rng, frames=240)))


def waving(*, frames=300, rate=30.0, share=1.0):
    """Four joints of which the last waves for a share of the time."""
    values = np.zeros((frames, 12))
    values[:, 9] = np.sin(2 * np.pi * np.arange(frames) / rate) * (np.arange(frames) < share * frames)
    return FeatureSequence(values, ("a", "b", "c", "hand"), rate=rate, width=3)


def test_they_sum_to_the_number_of_joints_and_none_is_ignored(dancer):
    weights = active_weights(dancer)
    assert weights.sum() == pytest.approx(len(dancer.names))
    assert weights.min() >= FLOOR
    assert np.ptp(weights) > 0.5


def test_a_unit_or_an_order_changes_nothing(dancer):
    weights = active_weights(dancer)
    assert np.allclose(active_weights(dancer.replace(values=dancer.values * 100)), weights)
    turned = dancer.values.reshape(len(dancer), -1, 3)[:, ::-1].reshape(len(dancer), -1)
    assert np.allclose(active_weights(dancer.replace(values=turned, names=dancer.names[::-1])), weights[::-1])


def test_the_frame_rate_hardly_matters(dancer):
    assert np.allclose(active_weights(dancer[::2]), active_weights(dancer), atol=0.05)


def test_whoever_waves_counts_most_even_if_for_a_quarter_of_the_time():
    for share in (1.0, 0.25):
        assert active_weights(waving(share=share)).tolist() == pytest.approx([0.25, 0.25, 0.25, 3.25])


def test_a_joint_that_leaps_away_for_a_moment_gains_nothing(dancer):
    values = dancer.values.copy()
    values[100:104, :3] += 50.0
    assert np.allclose(active_weights(dancer.replace(values=values)), active_weights(dancer), atol=0.1)


def test_where_nothing_moves_or_is_seen_all_count_alike(dancer):
    still = dancer.replace(values=np.broadcast_to(dancer.values[0], dancer.values.shape))
    assert active_weights(still).tolist() == [1.0] * 15
    assert active_weights(dancer[:1]).tolist() == [1.0] * 15
    assert active_weights(dancer.replace(values=np.full_like(dancer.values, np.nan))).tolist() == [1.0] * 15


def test_a_joint_seen_at_times_is_weighed_by_what_is_seen(dancer):
    values = dancer.values.copy()
    values[:80, 15:18] = np.nan
    assert np.allclose(active_weights(dancer.replace(values=values)), active_weights(dancer), atol=0.4)
    assert np.isfinite(active_weights(dancer.replace(values=values))).all()


def test_the_mean_of_norms_becomes_the_weighted_mean(dancer, rng):
    weights = rng.uniform(0, 3, len(dancer.names))
    apart = self_distance(weighted(dancer, weights)).values
    joints = dancer.values.reshape(len(dancer), -1, 3)
    norms = np.linalg.norm(joints[17] - joints[101], axis=1)
    assert apart[17, 101] == pytest.approx((weights * norms).sum() / weights.sum(), rel=1e-5)


def test_equal_weights_are_no_weights(dancer):
    assert np.allclose(weighted(dancer, np.full(15, 7.0)).values, dancer.values)


def test_quiet_joints_no_longer_outvote_a_waving_hand():
    hand = waving()
    equal, active = (
        self_distance(each).values[0, 7] for each in (hand, weighted(hand, active_weights(hand)))
    )
    assert active == pytest.approx(3.25 * equal, rel=1e-5)


@pytest.mark.parametrize("wrong", [[1.0], [-1.0, 1, 1, 1], [0.0] * 4, [np.nan, 1, 1, 1], 2.0])
def test_weights_that_are_none_are_refused(wrong):
    with pytest.raises(ParameterError):
        weighted(waving(), wrong)
