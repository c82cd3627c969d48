"""Search: one pass, from stripes to themes and returns."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion.discovery import search
from leitmotion.discovery.families import Run
from leitmotion.discovery.recurrence import MAX_DISTANCE, MIN_AMPLITUDE, MIN_CONTRAST
from leitmotion.discovery.refine import Refiner
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances

CYCLE = 30


def swings(sizes):
    """Cycles of one joint, a second one joining in by so much in each."""
    swing = 0.5 * (1 - np.cos(2 * np.pi * np.arange(CYCLE) / CYCLE))
    lift = np.sin(2 * np.pi * np.arange(CYCLE) / CYCLE)
    shape = np.stack((swing, lift, np.zeros(CYCLE)), axis=1)
    still = np.zeros((CYCLE, 3))
    return np.concatenate([np.concatenate((0.4 * shape, size * shape, still), axis=1) for size in sizes])


def seen_in(values):
    features = FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3)
    criteria = search.Criteria(MAX_DISTANCE, MIN_CONTRAST, MIN_AMPLITUDE, 15)
    return search.search(Distances(features), criteria, Refiner(features, 30.0, MAX_DISTANCE))


def test_a_walk_that_becomes_a_run_step_by_step_is_two_themes():
    sizes = [0.0] * 4 + [0.1, 0.2, 0.3] + [0.4] * 4
    themes = sorted(seen_in(swings(sizes)).themes, key=lambda theme: theme.runs[0].start)
    assert len(themes) == 2
    walk, run = (max(theme.runs, key=lambda run: run.cycles) for theme in themes)
    assert (walk.cycles, run.cycles) >= (4, 4)
    assert walk.borders[-1] <= run.borders[0]


def test_one_walk_stays_one_theme():
    (theme,) = seen_in(swings([0.2] * 8)).themes
    (run,) = theme.runs
    assert run.cycles == 8


def run(*borders):
    return Run(borders[0], borders[-1], 30.0, [], [], list(borders))


@pytest.mark.parametrize("second", [(75.0, 105.0, 135.0), (80.0, 95.0)])
def test_a_later_run_gives_up_what_the_earlier_one_holds(second):
    settled = search._settled([run(*second), run(0.0, 30.0, 60.0, 90.0)])
    assert settled[0].borders == [0.0, 30.0, 60.0, 90.0]
    assert all(before.stop <= after.start for before, after in pairwise(settled))
    assert [r.borders for r in settled[1:]] == ([[105.0, 135.0]] if len(second) == 3 else [])


@pytest.mark.parametrize("second", [(89.0, 120.0), (82.0, 120.0, 150.0)])
def test_a_cycle_that_the_earlier_run_hardly_reaches_into_is_kept(second):
    _, later = search._settled([run(0.0, 30.0, 60.0, 90.0), run(*second)])
    assert (later.start, later.borders) == (90.0, [90.0, *second[1:]])


def test_the_second_look_is_wider_and_never_less_strict_than_asked():
    first = search.Criteria(0.1, 0.3, 0.01, 15)
    look = search.SecondLook(wider=1.5, min_contrast=0.2, amplitude_share=0.9)
    assert look.of(first) == first._replace(max_distance=pytest.approx(0.15), share=0.9)
    assert look.of(first._replace(min_contrast=0.1)).min_contrast == 0.2


def test_a_larger_share_of_the_amplitude_lets_farther_postures_be_alike():
    distances = Distances(FeatureSequence(swings([0.2] * 4), ("a", "b", "c"), 30.0, ("place",), 3))
    half, whole = (
        search.Criteria(10.0, 0.3, 0.01, 15, share=share).likeness(distances).threshold for share in (0.5, 1)
    )
    np.testing.assert_allclose(whole, 2 * half, rtol=1e-6)
