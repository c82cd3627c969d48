"""Roles: partners, links, and what analyses compare."""

import pytest

from leitmotion.body import ANALYSIS_ROLES, LINKS, ROLES, links_between, mirror_role


@pytest.mark.parametrize("role", ROLES)
def test_mirror_is_its_own_inverse(role):
    assert mirror_role(role) in ROLES
    assert mirror_role(mirror_role(role)) == role
    assert (mirror_role(role) == role) == (not role.startswith(("left_", "right_")))


def test_the_mirror_of_the_links_is_the_links():
    assert {(mirror_role(a), mirror_role(b)) for a, b in LINKS} == set(LINKS)


def test_all_roles_hang_on_the_pelvis():
    assert {below for _, below in LINKS} == set(ROLES) - {"pelvis"}
    assert set(links_between(ROLES)) == set(LINKS)


def test_gaps_are_bridged():
    links = links_between(ANALYSIS_ROLES)
    assert len(links) == len(ANALYSIS_ROLES) - 1
    assert ("neck", "left_shoulder") in links
    assert ("pelvis", "neck") in links


def test_names_that_are_no_roles_are_joined_to_nothing():
    assert links_between(["Channel101", "Channel102"]) == ()
