"""Where cycles are cut, and how borders are refined at the recording's own rate."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion import body, features
from leitmotion.datasets import Action, compose
from leitmotion.discovery import find_patterns
from leitmotion.discovery.cuts import CUTS, cut_by_autocorrelation, cut_by_members
from leitmotion.discovery.families import Run
from leitmotion.discovery.refine import Refiner
from leitmotion.discovery.stripes import Stripe
from leitmotion.features import FeatureSequence
from leitmotion.motion import ParameterError


def stripe(start, stop, lag):
    i = np.arange(start, stop)
    return Stripe(np.stack((i, i + lag), axis=1), 0.2, 1.0, 50.0)


def swing(periods, frames_each, joints=3):
    phase = 2 * np.pi * np.arange(periods * frames_each) / frames_each
    return np.stack([0.3 * np.cos(phase + k) for k in range(3 * joints)], axis=1)


def sequence(values, rate):
    return FeatureSequence(values, tuple("abc"), rate, ("place",), 3)


def test_members_say_where_cycles_begin_and_end():
    members = [stripe(0, 92, 30), stripe(0, 61, 61), stripe(0, 32, 90)]
    run = Run(0, 122, 30, members[:1], members, [0.0, 28.0, 58.0, 96.0, 122.0])
    assert cut_by_members(run, run.borders) == [0.0, 31.0, 61.0, 91.0, 122.0]


def test_where_no_member_speaks_a_border_stays():
    run = Run(0, 120, 30, [], [stripe(0, 90, 30)], [0.0, 30.0, 58.0, 90.0, 120.0])
    assert cut_by_members(run, run.borders)[2] == 58.0


def test_the_autocorrelation_cuts_into_equal_cycles():
    run = Run(30, 150, 29, [], [], [])
    assert cut_by_autocorrelation(run, swing(6, 30)) == pytest.approx([30, 60, 90, 120, 150], abs=1)


def test_borders_go_to_the_frame_where_postures_agree(rng):
    refiner = Refiner(sequence(swing(6, 120), 120.0), 30.0, 0.08)
    true = 30.0 * np.arange(1, 6)
    moved = refiner.borders(true + np.array([0.0, 1.5, -1.25, 0.75, -0.5]))
    assert np.ptp(moved - true) < 1e-9


def test_a_border_moves_by_two_moments_at_most_and_not_to_what_is_not_alike():
    apart = swing(6, 120)
    apart[430:] += 1.0
    refiner = Refiner(sequence(apart, 120.0), 30.0, 0.08)
    given = [30.0, 60.0, 94.0, 120.0]
    moved = refiner.borders(given)
    assert max(abs(np.subtract(moved, given))) <= 2
    assert moved[3] == 120.0
    assert Refiner(sequence(apart, 20.0), 30.0, 0.08).borders(given) == given


@pytest.mark.parametrize("rate", [30.0, 120.0])
def test_no_border_leaves_the_recording(rate):
    whole = swing(6, round(rate))
    last = 180 - 60 / rate  # two frames are cut off, at which a cycle would begin or end
    for values, given in (
        (whole[2:], [0.0, *(30.0 * np.arange(1, 6) - 60 / rate)]),
        (whole[:-2], [*(30.0 * np.arange(1, 6)), last]),
    ):
        moved = Refiner(sequence(values, rate), 30.0, 0.08).borders(given)
        assert 0 <= min(moved) <= max(moved) <= last


def test_unseen_postures_move_no_border():
    gaps = swing(6, 120)
    gaps[230:250] = np.nan
    assert Refiner(sequence(gaps, 120.0), 30.0, 0.08).borders([30.0, 60.5, 90.0])[1] == 60.5


def test_occurrences_stay_in_order_without_overlap():
    refiner = Refiner(sequence(swing(6, 120), 120.0), 30.0, 0.08)
    spans = refiner.spans([(30.0, 61.0), (61.0, 90.5), (90.5, 121.0)])
    assert all(a < b for a, b in spans)
    assert all(b <= c for (_, b), (c, _) in pairwise(spans))


@pytest.mark.parametrize("cuts", CUTS)
def test_squats_are_cut_at_their_borders_however_it_is_done(cuts):
    session = compose([Action("still"), Action("squat", 5), Action("still")], seed=7, rate=120)
    (pattern,) = find_patterns(features.posture(body.embody(session.motion)), cuts=cuts).patterns
    assert pattern.cycles == 5
    lengths = np.diff(session.cycles.starts)
    inner = np.diff(pattern.occurrences.starts)
    assert (
        abs(inner - lengths).mean() / 120 < {"stripes": 0.05, "members": 0.15, "autocorrelation": 0.15}[cuts]
    )


def test_an_unknown_cut_is_refused():
    with pytest.raises(
        ParameterError, match="cuts must be one of stripes, members, autocorrelation, got 'peaks'"
    ):
        find_patterns(sequence(swing(3, 30), 30.0), cuts="peaks")
