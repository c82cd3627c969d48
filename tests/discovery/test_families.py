"""Families: runs of cycles from stripes drawn by hand."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion.discovery.cuts import cutter
from leitmotion.discovery.families import cyclic_runs, overlap
from leitmotion.discovery.stripes import Stripe

EVEN = cutter("stripes", np.ones(400), np.zeros((400, 3)))


def stripe(start, stop, lag, gain=50.0, contrast=0.8):
    """A straight stripe: moments [start, stop) come back after `lag`."""
    i = np.arange(start, stop)
    return Stripe(np.stack((i, i + lag), axis=1), 1.0 - contrast, 1.0, gain)


def test_one_stripe_whose_stretches_touch_is_two_cycles():
    (run,) = cyclic_runs([stripe(0, 60, 60)], EVEN)
    assert run.borders == pytest.approx([0, 60, 120], abs=1)


def test_multiples_of_the_period_belong_to_the_same_run():
    (run,) = cyclic_runs([stripe(0, 120, 40), stripe(0, 80, 80), stripe(0, 40, 120)], EVEN)
    assert (run.period, run.cycles) == (40, 4)


def test_a_run_broken_by_one_odd_cycle_is_not_counted_at_twice_its_period():
    runs = cyclic_runs([stripe(0, 60, 30), stripe(95, 170, 30), stripe(0, 140, 60)], EVEN)
    assert all(run.period == 30 for run in runs)
    assert sum(run.cycles for run in runs) >= 6


def test_a_small_repeat_inside_one_cycle_is_part_of_it():
    (run,) = cyclic_runs([stripe(0, 100, 100), stripe(10, 30, 20)], EVEN)
    assert (run.period, run.cycles) == (100, 2)


def test_runs_within_runs_within_runs_are_sorted_out():
    runs = cyclic_runs([stripe(0, 72, 100), stripe(100, 150, 50), stripe(130, 180, 20)], EVEN)
    for first, second in pairwise(runs):
        shared = overlap((first.start, first.stop), (second.start, second.stop))
        assert shared < 0.5 * min(first.stop - first.start, second.stop - second.start)


def test_far_stripes_make_no_run():
    assert cyclic_runs([stripe(0, 40, 120)], EVEN) == []


def test_the_last_cycle_counts_without_the_rest_that_follows_the_others():
    speed = np.ones(400)
    speed[[*range(40, 60), *range(100, 120)]] = 0.01
    (run,) = cyclic_runs([stripe(0, 100, 60)], cutter("stripes", speed, np.zeros((400, 3))))
    assert run.cycles == 3
    assert run.borders[-1] == 160
