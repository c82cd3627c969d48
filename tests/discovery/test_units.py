"""Units: what comes back in one order is divided at its pauses; what is one movement stays whole."""

import numpy as np
import pytest

from leitmotion.discovery import stripes
from leitmotion.discovery.families import is_near
from leitmotion.discovery.tracing import trace_stripes
from leitmotion.discovery.units import alternation, divide
from leitmotion.features import FeatureSequence, weighted
from leitmotion.features.mirror import mirrored
from leitmotion.similarity import Distances

NEAR = 0.08
SHORTEST = 15
NAMES = ("left_hand", "right_hand", "head")
KICK = (0, 1, 2)  # coordinates of the left hand
SQUAT = (6, 7, 8)  # of the head


def rise(count):
    """From 0 to 1, smoothly, at rest at both ends."""
    return 0.5 * (1 - np.cos(np.pi * np.arange(count) / count))


def moved(which, count=45, size=0.6):
    """A closed movement of some coordinates: away and back."""
    values = np.zeros((count, 9))
    for k, c in enumerate(which):
        values[:, c] = size * np.sin(np.pi * rise(count)) ** 2 * np.cos(0.9 * k)
    return values


def rest(count):
    return np.zeros((count, 9))


def compared(*parts, names=NAMES):
    return Distances(FeatureSequence(np.concatenate(parts), names, 30.0, ("place",), 3))


def prepared(distances):
    return stripes.likeness(distances, max_distance=NEAR, min_amplitude=0.012)


def traced(distances):
    return trace_stripes(distances, prepared(distances), max_distance=NEAR, min_duration_s=0.5).stripes


def whole(distances, first, second, count):
    """The stripe that joins two stretches moment by moment."""
    path = np.stack((first + np.arange(count), second + np.arange(count)), axis=1)
    (stripe,) = stripes.measure([path], distances, prepared(distances))
    return stripe


def divided(found, distances, alternates=None, shortest=SHORTEST):
    return divide(
        found,
        distances,
        prepared(distances),
        alternates or alternation(distances, 1.5 * NEAR),
        max_distance=NEAR,
        shortest=shortest,
    )


def twice(unit, between=90):
    """A unit, something else, the unit again, and the stripe that joins the two."""
    other = moved((3, 4, 5), between)
    distances = compared(unit, other, unit)
    return distances, whole(distances, 0, len(unit) + between, len(unit))


def test_two_movements_that_come_back_in_one_order_are_divided_at_the_pause():
    distances, stripe = twice(np.concatenate((moved(KICK), rest(12), moved(SQUAT))))
    one, other = sorted(divided([stripe], distances), key=lambda s: s.a)
    assert (one.a[0], other.a[1]) == (stripe.a[0], stripe.a[1])
    assert 45 - 6 <= one.a[1] <= other.a[0] <= 45 + 12 + 8
    assert (one.b[1] - one.a[1], other.b[0] - other.a[0]) == (stripe.lag, stripe.lag)


def test_a_movement_with_a_hold_in_its_middle_stays_whole():
    kick = moved(KICK, 60)
    top = int(np.argmax(np.abs(kick).sum(axis=1)))
    held = np.concatenate((kick[:top], np.tile(kick[top], (15, 1)), kick[top:]))
    distances, stripe = twice(held)
    assert divided([stripe], distances) == [stripe]


def test_a_movement_and_its_mirror_image_are_not_divided():
    left, right = moved((0, 1, 2)), moved((3, 4, 5)) * np.tile([-1, 1, 1], 3)
    unit = np.concatenate((left, rest(12), right))
    distances = compared(unit, moved(SQUAT, 90), unit)
    stripe = whole(distances, 0, len(unit) + 90, len(unit))
    assert divided([stripe], distances) == [stripe]
    assert len(divided([stripe], distances, lambda a, b: False)) == 2


@pytest.mark.parametrize("periods", [1, 2, 3])
def test_the_stripe_of_several_periods_of_one_movement_stays_whole(periods):
    distances = compared(*[moved(KICK)] * 6)
    stripe = whole(distances, 5, 5 + 45 * periods, 45 * (6 - periods) - 10)
    assert is_near(stripe)
    assert divided([stripe], distances) == [stripe]


def test_plain_cycles_stay_whole():
    distances = compared(*[moved(KICK, 45)] * 4)
    (near,) = (stripe for stripe in traced(distances) if stripe.lag < 1.5 * 45)
    assert is_near(near)
    assert near.a[1] - near.a[0] > 2 * 45
    assert divided([near], distances) == [near]


def test_a_piece_shorter_than_the_shortest_stretch_is_no_unit():
    distances, stripe = twice(np.concatenate((moved(KICK), rest(12), moved(SQUAT))))
    assert divided([stripe], distances, shortest=60) == [stripe]
    assert divided([], distances) == []


@pytest.fixture
def sides():
    """A movement of the left hand, the same of the right, and one of both at once: 45 moments each."""
    left, right = moved((0, 1, 2)), moved((3, 4, 5)) * np.tile([-1, 1, 1], 3)
    return left, right, left + right


def test_a_movement_and_its_mirror_image_alternate(sides):
    left, right, _ = sides
    distances = compared(left, right)
    np.testing.assert_allclose(mirrored(distances.features).values[:45], right, atol=1e-6)
    alternates = alternation(distances, 1.5 * NEAR)
    assert alternates((0, 45), (45, 90))
    assert alternates((45, 90), (0, 45))
    assert not alternates((0, 45), (0, 45))


@pytest.mark.parametrize("weights", [(2.7, 0.15, 0.15), (0.15, 2.7, 0.15)])
def test_sides_alternate_though_one_counts_for_more(sides, weights):
    distances = Distances(weighted(compared(*sides[:2]).features, weights))
    assert alternation(distances, 1.5 * NEAR)((0, 45), (45, 90))


def test_what_is_the_same_on_both_sides_does_not_alternate(sides):
    distances = compared(sides[2], 1.05 * sides[2])
    assert not alternation(distances, 1.5 * NEAR)((0, 45), (45, 90))


def test_nothing_alternates_where_names_tell_no_sides(sides):
    distances = compared(*sides[:2], names=("a", "b", "c"))
    assert not alternation(distances, 1.5 * NEAR)((0, 45), (45, 90))


def gone(count=45, size=0.6):
    """An open movement: the right hand leads away and stays."""
    values = np.zeros((count, 9))
    values[:, 3:6] = size * rise(count)[:, None]
    return values


def test_a_closed_movement_is_parted_from_an_open_one_after_it():
    distances, stripe = twice(np.concatenate((moved(KICK), rest(12), gone(75))))
    one, other = sorted(divided([stripe], distances), key=lambda s: s.a)
    assert 39 <= one.a[1] <= other.a[0] <= 65


def test_a_closed_movement_is_parted_from_an_open_one_before_it():
    away = gone()
    there = away[-1]
    unit = np.concatenate((away, rest(12) + there, moved(KICK) + there))
    distances, stripe = twice(unit)
    one, other = sorted(divided([stripe], distances), key=lambda s: s.a)
    assert 39 <= one.a[1] <= other.a[0] <= 65


def test_what_hardly_leads_away_does_not_close():
    distances, stripe = twice(np.concatenate((moved(KICK, size=0.2), rest(12), moved(SQUAT, size=0.2))))
    assert divided([stripe], distances) == [stripe]


def test_two_movements_in_turn_without_a_break_are_divided_all_along():
    unit = np.concatenate((moved(KICK), rest(12), moved(SQUAT), rest(12)))
    distances = compared(unit, unit, unit)
    near = whole(distances, 0, len(unit), 2 * len(unit))
    assert is_near(near)
    assert len(divided([near], distances)) == 4


def test_moments_that_were_not_seen_hide_no_alternation():
    left, right = moved((0, 1, 2)), moved((3, 4, 5)) * np.tile([-1, 1, 1], 3)
    hidden = np.concatenate((left, right))
    hidden[20:22] = np.nan
    assert alternation(compared(hidden), NEAR)((0, 45), (45, 90))
