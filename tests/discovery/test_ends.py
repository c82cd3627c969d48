"""Ends: a cycle that passes from one movement straight into another is none of either."""

import numpy as np
import pytest

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


def cycles_of(radii):
    """Radii of cycles that keep one each."""
    return np.repeat(radii, CYCLE)


@pytest.mark.parametrize(("beyond", "left"), [(0.09, 9), (0.12, 8)])
def test_an_end_is_judged_by_how_unlike_the_inner_cycles_are(beyond, left):
    inner = [0.1, 0.14] * 4
    values = circling(cycles_of([*inner, 0.1 + beyond, 0.3]))
    assert borders_left(values, (0, 9))[0][2] == left


@pytest.mark.parametrize(("beyond", "left"), [(0.01, 6), (0.06, 5)])
def test_an_end_that_is_nearer_than_what_is_alike_stays_though_the_inner_cycles_are_the_same(beyond, left):
    values = circling(cycles_of([0.2] * 5 + [0.2 + beyond, 0.5]))
    assert borders_left(values, (0, 6))[0][2] == left


@pytest.mark.parametrize(("speed_beyond", "left"), [(0.35, 6), (0.65, 5)])
def test_a_body_that_slows_to_less_than_half_comes_to_rest(speed_beyond, left):
    values = circling(cycles_of([0.2] * 5 + [0.3, 0.5]))
    distances = Distances(FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3))
    speed = np.where(np.arange(len(values)) < 6 * CYCLE, 0.1, 0.1 * speed_beyond)
    borders = [float(CYCLE * k) for k in range(7)]
    theme = Theme([Run(borders[0], borders[-1], CYCLE, [], [], borders)])
    (kept,) = without_transitions([theme], distances, speed, NEAR)
    assert kept.runs[0].cycles == left
