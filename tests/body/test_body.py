"""Body and body map: checked when made."""

import numpy as np
import pytest

from leitmotion.body import Body, BodyMap, find_roles, mirror_role, swap_sides
from leitmotion.motion import ParameterError
from oracles.body import human


def test_mirror_partner_only_where_there_is_one():
    found = BodyMap(
        ("head", "left_knee", "right_knee", "left_toe"), (("a",), ("b",), ("c",), ("d",)), np.ones(4)
    )
    assert found.mirror("left_knee") == "right_knee"
    assert found.mirror("head") == "head"
    assert found.mirror("left_toe") is None


@pytest.mark.parametrize(
    ("members", "confidence", "says"),
    [((("a",),), np.ones(2), "one a role"), ((("a",), ("b",)), np.ones(3), "shape")],
)
def test_a_map_needs_members_and_confidence_for_each_role(members, confidence, says):
    with pytest.raises(ParameterError, match=says):
        BodyMap(("head", "neck"), members, confidence)


@pytest.mark.parametrize("size", [0.0, -1.0, np.nan, np.inf])
def test_size_is_a_length(size):
    with pytest.raises(ParameterError, match="positive length"):
        Body(("head",), np.zeros((3, 1, 3)), np.zeros(3), rate=30, size=size)


def test_facing_is_finite_positions_need_not_be():
    Body(("head",), np.full((3, 1, 3), np.nan), np.zeros(3), rate=30, size=1.0)
    with pytest.raises(ParameterError, match="finite"):
        Body(("head",), np.zeros((3, 1, 3)), [0.0, np.nan, 0.0], rate=30, size=1.0)


def test_swapped_sides_are_a_map_of_the_same_points(rng):
    found = find_roles(human(rng))
    found = found.replace(confidence=rng.random(len(found.roles)))
    swapped = swap_sides(found)
    assert swapped.roles == found.roles
    for role, members, sure in zip(found.roles, found.members, found.confidence):
        there = swapped.roles.index(mirror_role(role))
        assert (swapped.members[there], swapped.confidence[there]) == (members, sure)
    assert swap_sides(swapped) == found


def test_a_side_without_a_partner_changes_its_name():
    swapped = swap_sides(BodyMap(("head", "left_toe"), (("a",), ("b",)), (1.0, 0.5)))
    assert (swapped.roles, swapped.members) == (("head", "right_toe"), (("a",), ("b",)))
