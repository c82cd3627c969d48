"""Mirror: exchanges the sides, twice changes nothing, and needs names that tell the sides."""

import numpy as np
import pytest

from leitmotion.features import FeatureSequence, weighted
from leitmotion.features.mirror import mirrored


def postures(rng, names, width=3):
    values = rng.normal(size=(20, len(names) * width))
    return FeatureSequence(values, names, 30.0, tuple("xyzw"[:width]) if width != 3 else ("place",), width)


def test_the_mirror_exchanges_partners_and_negates_x(rng):
    one = postures(rng, ("left_hand", "head", "right_hand"))
    image = mirrored(one)
    seen, expected = (values.reshape(20, 3, 3) for values in (image.values, one.values))
    assert image.names == one.names
    np.testing.assert_array_equal(seen, expected[:, [2, 1, 0]] * [-1, 1, 1])


def test_the_mirror_twice_changes_nothing(rng):
    one = postures(rng, ("left_hand", "head", "right_foot", "right_hand", "left_foot"))
    image = mirrored(one)
    assert image != one
    assert mirrored(image) == one


@pytest.mark.parametrize("names", [("a", "b"), ("left_hand", "head"), ("left_hand", "right_foot")])
def test_there_is_no_mirror_where_names_tell_no_sides_or_a_partner_lacks(rng, names):
    assert mirrored(postures(rng, names)) is None


def test_there_is_no_mirror_of_what_is_no_place(rng):
    sides = ("left_hand", "right_hand")
    assert mirrored(postures(rng, sides)) is not None
    assert mirrored(postures(rng, sides, width=4)) is None


def test_a_walk_in_the_mirror_is_the_walk_half_a_cycle_later():
    phase = 2 * np.pi * np.arange(40) / 40
    left = np.stack((0.2 + 0.02 * np.sin(phase), 0.1 * np.cos(phase) ** 3, 0.5 * np.sin(phase + 0.3)), axis=1)
    right = np.roll(left, -20, axis=0) * [-1, 1, 1]
    head = np.stack((0.05 * np.sin(phase), 1 + 0.03 * np.cos(2 * phase), np.zeros(40)), axis=1)
    names = ("left_foot", "right_foot", "head")
    walk = FeatureSequence(np.concatenate((left, right, head), axis=1), names, 40.0, ("place",), 3)
    np.testing.assert_allclose(mirrored(walk).values, np.roll(walk.values, -20, axis=0), atol=1e-12)
    assert not np.allclose(mirrored(walk).values, walk.values, atol=0.1)


def test_a_line_from_side_to_side_has_no_mirror_image_here():
    names = ("chest", "left_elbow", "right_elbow")
    angles = FeatureSequence(np.zeros((2, 9)), names, 30, (), 3, unit="rad")
    assert mirrored(angles) is None
    assert mirrored(angles.replace(values=np.zeros((2, 6)), names=names[1:])) is not None


def test_the_mirror_has_the_weights_of_the_sides_that_it_shows(rng):
    one = postures(rng, ("left_hand", "head", "right_hand", "left_foot", "right_foot"))
    weights = [3.0, 1.0, 0.5, 0.25, 2.0]
    image = mirrored(weighted(one, weights))
    meant = weighted(mirrored(one), weights)
    np.testing.assert_allclose(image.values, meant.values, rtol=1e-12)
    assert image.weights == meant.weights
    again = mirrored(weighted(weighted(one, weights), weights[::-1]))
    meant = weighted(weighted(mirrored(one), weights), weights[::-1])
    np.testing.assert_allclose(again.values, meant.values, rtol=1e-12)


def test_there_is_no_mirror_where_a_side_has_no_weight(rng):
    one = postures(rng, ("left_hand", "head", "right_hand"))
    assert mirrored(weighted(one, [0, 1, 1])) is None
    image = mirrored(weighted(one, [0, 1, 0]))
    np.testing.assert_allclose(image.values, weighted(mirrored(one), [0, 1, 0]).values)
