"""Sides told from D and D* alone: beside the antisymmetric parts themselves, and blind to what lasts."""

import numpy as np
import pytest

from leitmotion.discovery.sides import LARGEST, antisymmetric, sides_of, without_lasting
from leitmotion.discovery.waypoints import angles
from leitmotion.features import averaged, kinematic_chain, mirrored
from leitmotion.similarity import double_metric
from oracles import body as oracle
from oracles import motifs as made


def matrices(chain):
    found = double_metric(chain)
    own, mirror = (angles(each.astype(float), "inner") for each in (found.own, found.mirror))
    return own, mirror, antisymmetric(own, mirror)


def test_the_products_are_those_of_the_antisymmetric_parts(rng):
    chain = kinematic_chain(oracle.human(rng, bend=0.15))
    _, _, products = matrices(chain)
    q, image = (each.values.reshape(len(chain), -1, 4) for each in (chain, mirrored(chain)))
    image = image * np.where((q * image).sum(axis=-1, keepdims=True) < 0, -1.0, 1.0)
    part = (q - image) / 2
    direct = (
        4 * np.einsum("ila,jla->ij", part, part) / q.shape[1]
    )  # an angle is twice that between quaternions
    assert np.abs(products - direct).max() < 0.05 * np.abs(direct).max()


@pytest.mark.parametrize(
    ("motif", "least", "most"),
    [
        ("symmetric_cycle", 0.0, 0.01),
        ("symmetric_palindrome", 0.0, 0.01),
        ("asymmetric_cycle", 0.45, 0.55),
        ("asymmetric_palindrome", 0.45, 0.55),
        ("anti_palindrome", 0.9, 1.0),
    ],
)
def test_nothing_a_half_or_all_of_a_movement_parts_the_sides(motif, least, most):
    own, _, products = matrices(kinematic_chain(made.movement(motif))[::2])
    sides = sides_of(own, products, 0, len(own) - 1)
    assert least <= sides.parting <= most


def test_what_lasts_is_no_parting_and_is_taken_out():
    left = made.there_and_back(60, 3)
    own, mirror, products = matrices(
        kinematic_chain(made.human_doing(left, left + np.radians([15.0, 0.0])))[::2]
    )
    sides = sides_of(own, products, 0, len(own) - 1)
    assert sides.parting < 0.05
    assert np.radians(4.0) < sides.lasting < LARGEST
    count = len(own)
    without = without_lasting(own, products, np.zeros(count, int), np.full(count, count))
    assert np.diagonal(mirror).min() > np.radians(4.0)
    assert np.diagonal(without).mean() < 0.4 * np.diagonal(mirror).mean()


def test_of_a_posture_that_is_held_to_one_side_no_more_than_a_bias_is_taken_out():
    held = made.rest(120) + np.radians([90.0, 0.0])
    chain = averaged(kinematic_chain(made.human_doing(made.rest(120), held)), 0.04)
    own, mirror, products = matrices(chain[::4])
    count = len(own)
    without = without_lasting(own, products, np.zeros(count, int), np.full(count, count))
    assert np.diagonal(mirror).min() > 2 * LARGEST
    assert np.diagonal(without).min() > np.diagonal(mirror).min() - 1.6 * LARGEST
