"""Overlay: two stretches laid over one another in time, however long they are."""

import tracemalloc

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d

from leitmotion.discovery import _overlay_kernels, overlay
from leitmotion.discovery.families import Run
from leitmotion.discovery.kinds import part_themes
from leitmotion.discovery.lone import with_lone_occurrences
from leitmotion.discovery.overlay import overlay_cost, overlay_of, overlay_of_stretches
from leitmotion.discovery.returns import Return
from leitmotion.discovery.search import Criteria, Seen
from leitmotion.discovery.themes import Theme
from leitmotion.discovery.units import _same_again, alternation
from leitmotion.discovery.writing import Scribe
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances, align, cross_distance

NAMES = ("left_hand", "right_hand", "head")
MINUTES = 3600  # moments of two


def motion(rng, count, slow=8.0):
    """Smooth motion that never comes back."""
    values = gaussian_filter1d(rng.normal(size=(count, 9)), slow, axis=0)
    return 0.1 * values / values.std()


def sequence(values):
    return FeatureSequence(values, NAMES, 30.0, ("place",), 3)


@pytest.fixture
def hidden(rng):
    """Two stretches of which some moments, and some joints at others, were not seen."""
    one, other = motion(rng, 70), motion(rng, 90)
    one[10:14], other[40:45] = np.nan, np.nan
    one[20:30, :3], other[60:75, 3:] = np.nan, np.nan
    return sequence(one), sequence(other)


def test_a_short_stretch_is_laid_over_another_as_their_distances_say(hidden):
    one, other = hidden
    both = Distances(sequence(np.concatenate((one.values, other.values))))
    rows, columns = range(70), range(70, 160)
    said = overlay_cost(both.between(rows, columns), 0.4)
    assert overlay_of_stretches(both, rows, columns, 0.4) == pytest.approx(said, rel=1e-9)
    assert overlay_of(one, other, 0.4) == overlay_cost(cross_distance(one, other).values, 0.4)


@pytest.mark.parametrize("unseen", [0.0, 0.4])
def test_a_long_stretch_costs_what_a_short_one_does(hidden, monkeypatch, unseen):
    dense = overlay_of(*hidden, unseen)
    monkeypatch.setattr(overlay, "HELD", 0)
    assert overlay_of(*hidden, unseen) == pytest.approx(dense, rel=1e-6)
    nothing = hidden[0].replace(values=np.full((70, 9), np.nan))
    assert overlay_of(nothing, hidden[1], unseen) == unseen


def test_of_very_long_stretches_every_nth_moment_is_enough(rng, monkeypatch):
    values = motion(rng, 2000, slow=20.0)
    both = Distances(sequence(np.concatenate((values, 0.0 * values, 1.05 * values, -values))))
    starts = (0, 4000, 6000)
    first, again, other = (range(start, start + 2000) for start in starts)
    monkeypatch.setattr(overlay, "LOOKED_AT", 500 * 500)
    alike, unlike = (overlay_of_stretches(both, first, it, 1.0) for it in (again, other))
    assert alike == pytest.approx(np.mean(both.along(np.stack((first, again), axis=1))), rel=0.05)
    assert unlike > 10 * alike


def described(distances):
    criteria = Criteria(0.05, 0.3, 0.012, 15)
    theme = Theme([run(0, MINUTES, 2 * MINUTES)])
    return Scribe(distances.features, distances, criteria).describe(Seen([theme], [], {}))


def run(*borders):
    return Run(borders[0], borders[-1], MINUTES, [], [], list(borders))


def alone(distances):
    half = MINUTES // 2
    twice = Return([(0.0, half), (half, MINUTES)], [], np.zeros((0, 2)), 1.0)
    return with_lone_occurrences(
        [twice], np.zeros(2 * MINUTES, bool), distances, max_distance=0.05, min_contrast=0.3
    )


def paired(distances):
    criteria = Criteria(0.05, 0.3, 0.012, 15)
    scribe = Scribe(distances.features, distances, criteria)
    return scribe.write([scribe.held([(0, MINUTES), (MINUTES, 2 * MINUTES)])]).patterns


TOLD_BY = {
    "alone": alone,
    "pairs": paired,
    "kinds": lambda distances: part_themes([Theme([run(0, MINUTES, 2 * MINUTES)])], distances, 0.05),
    "units": lambda distances: _same_again(
        np.repeat(np.arange(2 * MINUTES)[:, None], 2, axis=1), [MINUTES], distances, 0.05
    ),
    "sides": lambda distances: alternation(distances, 0.05)((0, MINUTES), (MINUTES, 2 * MINUTES)),
    "writing": described,
}
"""Who lays two cycles of two minutes over one another."""


@pytest.mark.parametrize("who", TOLD_BY)
def test_memory_does_not_grow_with_the_square_of_a_stretch(rng, who):
    once = motion(rng, MINUTES)
    again = once if who != "sides" else once.reshape(-1, 3, 3)[:, [1, 0, 2]].reshape(-1, 9) * ([-1, 1, 1] * 3)
    distances = Distances(sequence(np.concatenate((once, again))))
    TOLD_BY[who](distances)  # compiles
    tracemalloc.start()
    told = TOLD_BY[who](distances)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert told
    assert peak < MINUTES * MINUTES  # a byte for each of their distances


def test_a_path_between_two_stretches_is_the_general_one(rng):
    distances = Distances(sequence(motion(rng, 60)))
    for rows, columns in (
        (range(3, 20), range(25, 60)),
        (range(30), range(30, 41)),
        (range(4, 5), range(9, 12)),
    ):
        ends = rows.start, rows.stop, columns.start, columns.stop
        cost, path = _overlay_kernels.warped(distances.across, *ends, distances.width)
        aligned = align(distances.between(rows, columns))
        assert cost == pytest.approx(aligned.cost, rel=1e-9)
        np.testing.assert_array_equal(path, aligned.path + np.array((rows.start, columns.start)))


def test_no_path_leads_through_a_moment_that_was_not_seen(hidden):
    cost, path = _overlay_kernels.warped(Distances(hidden[0]).across, 5, 30, 40, 70, 3)
    assert (cost, len(path)) == (np.inf, 0)
