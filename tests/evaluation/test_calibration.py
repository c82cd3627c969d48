"""Calibration: laws of the error curves, and the equal error rate against a search of all thresholds."""

import itertools

import numpy as np
import pytest

from leitmotion.evaluation import equal_error_rate, errors_at
from leitmotion.motion import DataError, ParameterError


def rates(threshold, distances, alike):
    """Both rates, counted one by one."""
    missed = sum(d > threshold for d, same in zip(distances, alike, strict=True) if same)
    taken = sum(d <= threshold for d, same in zip(distances, alike, strict=True) if not same)
    return taken / (len(alike) - sum(alike)), missed / sum(alike)


def crossing(distances, alike):
    """Where the two curves, their steps drawn as lines, meet: bisection along the drawn line."""
    points = [(0.0, 1.0)]
    for distance in sorted(set(distances)):
        points.append(rates(distance, distances, alike))
    for (taken, missed), (then_taken, then_missed) in itertools.pairwise(points):
        if taken <= missed and then_taken >= then_missed:
            low, high = 0.0, 1.0
            for _ in range(60):
                share = (low + high) / 2
                ahead = taken + share * (then_taken - taken) >= missed + share * (then_missed - missed)
                low, high = (low, share) if ahead else (share, high)
            return missed + high * (then_missed - missed)
    raise AssertionError("no crossing")


def drawn(rng, *, alike=40, others=25, ties=False):
    distances = np.concatenate((rng.gamma(3.0, 0.03, alike), rng.gamma(4.0, 0.06, others)))
    labels = np.arange(alike + others) < alike
    order = rng.permutation(len(labels))
    return (np.round(distances, 2) if ties else distances)[order], labels[order]


@pytest.mark.parametrize("ties", [False, True])
@pytest.mark.parametrize(("alike", "others"), [(40, 25), (7, 50), (1, 9), (30, 30)])
def test_the_rate_is_where_the_curves_cross(rng, alike, others, ties):
    for _ in range(20):
        distances, labels = drawn(rng, alike=alike, others=others, ties=ties)
        found = equal_error_rate(distances, labels, draws=0)
        assert found.equal_error_rate == pytest.approx(crossing(distances, labels), abs=1e-9)
        below, above = (rates(found.threshold + step, distances, labels) for step in (-1e-9, 1e-9))
        assert below[0] <= below[1] + 1e-12 or below == above  # before it fewer are taken than missed
        assert above[0] >= above[1] - 1e-12


def test_the_curves_are_exact_and_monotonic(rng):
    distances, labels = drawn(rng, ties=True)
    found = equal_error_rate(distances, labels, draws=0)
    assert found.thresholds[0] == 0.0
    assert set(found.thresholds) == {0.0, *distances}
    for threshold, taken, missed in zip(
        found.thresholds, found.false_match, found.false_non_match, strict=True
    ):
        assert (taken, missed) == pytest.approx(rates(threshold, distances, labels))
    assert (np.diff(found.false_match) >= 0).all()
    assert (np.diff(found.false_non_match) <= 0).all()
    assert (found.false_match[-1], found.false_non_match[-1]) == (1.0, 0.0)
    assert (found.alike, found.not_alike) == (40, 25)


def test_what_is_parted_has_no_error_and_a_threshold_in_the_middle():
    found = equal_error_rate([0.1, 0.2, 0.6, 0.9], [True, True, False, False])
    assert (found.threshold, found.equal_error_rate) == (0.4, 0.0)
    assert found.rate_interval == (0.0, 0.0)


def test_the_wrong_way_round_is_all_error():
    found = equal_error_rate([0.6, 0.9, 0.1, 0.2], [True, True, False, False], draws=0)
    assert (found.threshold, found.equal_error_rate) == (0.4, 1.0)


def test_distances_that_tell_nothing_are_a_guess():
    """All in one place: the coin that makes both rates equal is a fair one, however many there are of each."""
    found = equal_error_rate([0.3] * 5, [True, False, False, False, False], draws=0)
    assert (found.threshold, found.equal_error_rate) == (0.3, 0.5)


def test_a_unit_scales_the_threshold_and_nothing_else(rng):
    distances, labels = drawn(rng)
    one, hundred = (equal_error_rate(distances * factor, labels) for factor in (1.0, 128.0))
    assert hundred.threshold == pytest.approx(128 * one.threshold)
    assert hundred.threshold_interval == pytest.approx(tuple(128 * end for end in one.threshold_interval))
    assert (hundred.equal_error_rate, hundred.rate_interval) == (one.equal_error_rate, one.rate_interval)


def test_order_and_repeated_pairs_change_nothing(rng):
    distances, labels = drawn(rng)
    own = equal_error_rate(distances, labels, draws=0)
    assert equal_error_rate(distances[::-1], labels[::-1], draws=0) == own
    twice = equal_error_rate(np.tile(distances, 2), np.tile(labels, 2), draws=0)
    assert (twice.threshold, twice.equal_error_rate) == (own.threshold, own.equal_error_rate)


def test_the_interval_holds_the_true_rate_about_as_often_as_it_says(rng):
    """Exponential distances of means 1 and 9 cross where exp(-T) = 1 - exp(-T / 9)."""
    grid = np.linspace(0.5, 3.0, 100001)
    truth = np.exp(-grid[np.argmin(np.abs(np.exp(-grid) - 1 + np.exp(-grid / 9)))])
    held = 0
    for _ in range(60):
        distances = np.concatenate((rng.exponential(1.0, 80), rng.exponential(9.0, 80)))
        low, high = equal_error_rate(distances, np.arange(160) < 80, draws=200).rate_interval
        held += low <= truth <= high
    assert held >= 50


def test_pairs_of_one_person_do_not_count_as_many(rng):
    """Ten people with ten copies of one pair each: the interval over people is that of ten pairs, not of a hundred."""
    distances, labels = drawn(rng, alike=12, others=12)
    copies, same = np.repeat(distances, 10), np.repeat(labels, 10)
    people = np.repeat(np.arange(24), 10)
    (low, high), (least, most) = (
        equal_error_rate(copies, same, owners=owners).rate_interval for owners in (None, people)
    )
    assert most - least > 2 * (high - low)


def test_one_pair_has_no_interval():
    found = equal_error_rate([0.1, 0.4, 0.5], [True, False, False])
    assert np.isnan([*found.threshold_interval, *found.rate_interval]).all()


def test_same_seed_same_interval(rng):
    distances, labels = drawn(rng)
    assert equal_error_rate(distances, labels, seed=3) == equal_error_rate(distances, labels, seed=3)
    assert equal_error_rate(distances, labels, seed=3) != equal_error_rate(distances, labels, seed=4)


def test_errors_at_a_threshold_are_counted(rng):
    distances, labels = drawn(rng, ties=True)
    for threshold in (0.0, 0.11, 5.0):
        told = errors_at(threshold, distances, labels)
        taken, missed = rates(threshold, distances, labels)
        assert (told.false_match, told.false_non_match) == pytest.approx((taken, missed))
        assert told.error == pytest.approx((taken + missed) / 2)
        assert told.interval[0] <= told.error <= told.interval[1]


@pytest.mark.parametrize("judge", [equal_error_rate, lambda *args: errors_at(0.1, *args)])
def test_what_cannot_be_judged_is_a_sentence(judge):
    with pytest.raises(DataError, match="but each of the 2 is alike"):
        judge([0.1, 0.2], [True, True])
    with pytest.raises(DataError, match="but the one is not alike"):
        judge([0.1], [False])
    for distances, labels in (
        ([0.1, np.nan], [1, 0]), ([0.1, -1.0], [1, 0]), ([0.1], [1, 0]), ([0.1, 0.2], [1, 2]), ([[0.1]], [[1]]),
    ):  # fmt: skip
        with pytest.raises(ParameterError):
            judge(distances, labels)
    with pytest.raises(ParameterError, match="one owner"):
        equal_error_rate([0.1, 0.2], [1, 0], owners=["a"])
