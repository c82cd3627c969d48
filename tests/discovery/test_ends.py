"""Ends: a cycle that passes from one movement straight into another is none of either."""

import numpy as np

from leitmotion.discovery.ends import without_transitions
from leitmotion.discovery.families import Run
from leitmotion.discovery.stripes import likeness
from leitmotion.discovery.themes import Theme
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances

CYCLE = 30
NEAR = 0.08


def circling(radii):
    """Joints that go round at radii given moment by moment, (N, 9)."""
    phase = 2 * np.pi * np.arange(len(radii)) / CYCLE
    return np.stack([radii * np.cos(phase + k) for k in range(9)], axis=1)


def borders_left(values, *runs):
    """How many cycles of one theme are left in each run, given where its cycles begin and how many there are."""
    distances = Distances(FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3))
    speed = likeness(distances, max_distance=NEAR, min_amplitude=0.0).speed
    made = []
    for start, count in runs:
        borders = [float(start + CYCLE * k) for k in range(count + 1)]
        made.append(Run(borders[0], borders[-1], CYCLE, [], [], borders))
    (theme,) = without_transitions([Theme(made)], distances, speed, NEAR)
    return [(run.start, run.stop, run.cycles) for run in theme.runs]


def larger_from(moment, count, over=20):
    """Radii that grow within so many moments."""
    return 0.1 + 0.1 * np.clip((np.arange(count) - moment) / over, 0, 1)


def test_the_cycle_in_which_a_movement_becomes_another_is_left_out():
    values = circling(larger_from(4.2 * CYCLE, 8 * CYCLE))
    assert borders_left(values, (0, 5)) == [(0, 120, 4)]
    assert borders_left(values[::-1], (3 * CYCLE, 5)) == [(4 * CYCLE, 8 * CYCLE, 4)]


def test_a_last_cycle_that_comes_to_rest_stays():
    radii = larger_from(4.2 * CYCLE, 5 * CYCLE)
    values = circling(radii)
    still = np.concatenate((values, np.tile(values[-1], (CYCLE, 1))))
    assert borders_left(still, (0, 5)) == [(0, 150, 5)]


def test_alike_cycles_stay_whatever_follows():
    values = np.concatenate((circling(np.full(5 * CYCLE, 0.1)), 0.5 + circling(np.full(CYCLE, 0.3))))
    assert borders_left(values, (0, 5)) == [(0, 150, 5)]


def test_a_run_keeps_two_cycles():
    values = circling(np.concatenate((np.full(6 * CYCLE, 0.1), larger_from(0, 4 * CYCLE))))
    assert borders_left(values, (0, 4), (5 * CYCLE, 2))[1] == (5 * CYCLE, 7 * CYCLE, 2)
