"""Kinds: cycles of two kinds in one theme are two themes; alike cycles stay one."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion.discovery import kinds
from leitmotion.discovery.families import Run
from leitmotion.discovery.kinds import part_themes
from leitmotion.discovery.overlay import overlay_of_spans
from leitmotion.discovery.themes import Theme
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances

NEAR = 0.08
CYCLE = 30


def cycles(which):
    """One cycle a letter: a swing, one of other joints, a larger one, or one with another joint; (N, 9)."""
    swing = 0.5 * (1 - np.cos(2 * np.pi * np.arange(CYCLE) / CYCLE))
    shape = {
        "a": np.repeat([1, 0, 0], 3),
        "b": np.repeat([0, 0, 1], 3),
        "c": np.repeat([1.02, 0, 0], 3),
        "d": np.repeat([1, 0.7, 0], 3),
    }
    return np.concatenate([0.5 * swing[:, None] * shape[letter] for letter in which])


def theme_of(*runs):
    """A theme whose runs follow one another, and the distances of what it shows."""
    values = np.concatenate([cycles(run) for run in runs])
    distances = Distances(FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3))
    at, made = 0, []
    for run in runs:
        borders = [float(at + CYCLE * k) for k in range(len(run) + 1)]
        made.append(Run(borders[0] - 0.5, borders[-1] + 0.5, CYCLE, [], [], borders))
        at += CYCLE * len(run)
    return Theme(made), distances


def starts(theme):
    """Which cycles a theme has, by number."""
    return [round(a / CYCLE) for run in theme.runs for a, _ in pairwise(run.borders)]


def test_cycles_of_two_kinds_are_two_themes():
    theme, distances = theme_of("aaabbb")
    parted = sorted(part_themes([theme], distances, NEAR), key=starts)
    assert [starts(part) for part in parted] == [[0, 1, 2], [3, 4, 5]]
    (first,), (second,) = (part.runs for part in parted)
    assert (first.start, first.stop) == (-0.5, 90.0)
    assert (second.start, second.stop) == (90.0, 180.5)


def test_kinds_not_far_apart_are_two_themes_where_the_one_passes_into_the_other_at_once():
    theme, distances = theme_of("aaaddd")
    one, other = ((CYCLE * k, CYCLE * (k + 1)) for k in (2, 3))
    assert NEAR < overlay_of_spans(distances, one, other, NEAR) < kinds.AGREED * NEAR
    parted = sorted(part_themes([theme], distances, NEAR), key=starts)
    assert [starts(part) for part in parted] == [[0, 1, 2], [3, 4, 5]]


def test_moments_that_were_not_seen_part_no_theme():
    theme, distances = theme_of("aaaaaa")
    hidden = distances.features.values.copy()
    for cycle in (1, 4):
        hidden[CYCLE * cycle + 12 : CYCLE * cycle + 14] = np.nan
    holed = Distances(distances.features.replace(values=hidden))
    assert part_themes([theme], holed, NEAR) == [theme]


def test_alike_cycles_stay_one_theme_untouched():
    theme, distances = theme_of("aca", "ac")
    assert part_themes([theme], distances, NEAR) == [theme]
    assert part_themes([theme], distances, 1e-4) != [theme]


def test_cycles_of_a_kind_that_do_not_follow_one_another_are_runs_of_their_own():
    theme, distances = theme_of("aabba", "bb")
    parted = sorted(part_themes([theme], distances, NEAR), key=starts)
    assert [[run.borders for run in part.runs] for part in parted] == [
        [[0, 30, 60], [120, 150]],
        [[60, 90, 120], [150, 180, 210]],
    ]


def test_a_kind_of_one_cycle_is_no_theme():
    theme, distances = theme_of("aaab")
    assert [starts(part) for part in part_themes([theme], distances, NEAR)] == [[0, 1, 2]]


@pytest.mark.parametrize("compared", [4, 24])
def test_cycles_that_are_not_compared_with_each_go_to_the_nearest(monkeypatch, compared):
    monkeypatch.setattr(kinds, "COMPARED", compared)
    theme, distances = theme_of("aaaaaaabbbbb")
    parted = sorted(part_themes([theme], distances, NEAR), key=starts)
    assert [starts(part) for part in parted] == [list(range(7)), list(range(7, 12))]


def growing(steps):
    """A swing that grows a little from cycle to cycle, as one theme with its distances."""
    swing = 0.5 * (1 - np.cos(2 * np.pi * np.arange(CYCLE) / CYCLE))
    sizes = np.concatenate([np.full(CYCLE, size) for size in steps])
    values = (np.tile(swing, len(steps)) * sizes)[:, None] * np.repeat([1, 0, 0], 3)
    distances = Distances(FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3))
    borders = [float(CYCLE * k) for k in range(len(steps) + 1)]
    return Theme([Run(0.0, borders[-1], CYCLE, [], [], borders)]), distances


def test_a_movement_that_changes_step_by_step_is_one():
    theme, distances = growing([0.2, 0.4, 0.6, 0.8, 1.0, 1.2])
    assert part_themes([theme], distances, NEAR) == [theme]


def test_one_that_changes_at_once_is_two():
    theme, distances = growing([0.2, 0.25, 0.3, 1.1, 1.15, 1.2])
    assert [len(starts(part)) for part in part_themes([theme], distances, NEAR)] == [3, 3]
