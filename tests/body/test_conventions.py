"""Every published convention: from all of its names to all roles that they say, nothing more and nothing less."""

import numpy as np
import pytest

from leitmotion.body import ROLES, find_roles
from leitmotion.motion import Trajectories
from oracles.conventions import CONVENTIONS, both_sides


def told_by(convention, rng):
    """What is told from the names alone, in any order, as {role: names}; and what should be."""
    kind, names, roles, prefix = (*CONVENTIONS[convention], "")[:4]
    names = [prefix + name for name in both_sides(names)]
    names = [names[k] for k in rng.permutation(len(names))]
    found = find_roles(Trajectories(tuple(names), np.full((1, len(names), 3), np.nan), 100, kind=kind))
    wanted = {}
    for entry in both_sides(roles):
        role, _, members = entry.partition("=")
        wanted[role] = {prefix + name for name in members.split("+")}
    return found, {role: set(members) for role, members in zip(found.roles, found.members)}, wanted


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_all_roles_are_told_from_all_names(convention, rng):
    _, told, wanted = told_by(convention, rng)
    assert set(wanted) <= set(ROLES), "the table says only roles"
    assert told == wanted


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_markers_are_not_taken_for_joints(convention, rng):
    found, _, _ = told_by(convention, rng)
    kind = CONVENTIONS[convention][0]
    assert found.confidence.max() == (0.9 if kind == "marker" else 1.0)
