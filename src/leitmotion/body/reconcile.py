"""Reconcile: what names say and what the shape of the body says, made one.

Names come first, and they decide which side is left. The shape says what they leave open. Only names that contradict it
nearly everywhere, as those of another body or in another order do, are put aside; what the shape says in their place is
then held for unsure.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np

from leitmotion.body.roles import mirror_role
from leitmotion.body.shape import UNSURE, Found

LIMBS = tuple(
    f"{side}_{limb}"
    for side in ("left", "right")
    for limb in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
)
"""Roles in which names and shape are compared; about the others conventions differ."""

ENOUGH = 4  # roles that must be compared before names are put aside
NONSENSE = 0.34  # of them: the most that still agree in names that mean nothing
SAME_PLACE = 1e-3  # metres, or whatever the unit is a thousandth of: one joint twice


def reconcile(
    named: Found, shaped: Found, positions: np.ndarray, meanings: Mapping[int, Collection[str]]
) -> Found:
    """Let the shape of a body say what names leave open.

    Parameters
    ----------
    named : dict of str to (points, confidence)
        Roles that names say.
    shaped : dict of str to (points, confidence)
        Roles that the shape says.
    positions : (M, P, C) float
        Where the points are at some moments.
    meanings : mapping of int to collection of str
        For each point the roles that its name may mean: a ``LeftShoulder`` is the clavicle or the joint itself.

    Returns
    -------
    dict of str to (points, confidence)
        What names say, and for roles and points that they leave free what the shape says.
    """
    if not shaped:
        return named
    compared = [role for role in LIMBS if role in named and role in shaped]
    same = sum(_meet(named[role][0], shaped[role][0], positions) for role in compared)
    crossed = sum(
        _meet(named[role][0], shaped[mirror_role(role)][0], positions)
        for role in compared
        if mirror_role(role) in shaped
    )
    body = max(sure for _, sure in shaped.values())
    if body > UNSURE and len(compared) >= ENOUGH and max(same, crossed) <= NONSENSE * len(compared):
        return {role: (points, min(sure, UNSURE)) for role, (points, sure) in shaped.items()}
    if crossed > same:
        shaped = {mirror_role(role): those for role, those in shaped.items()}
    named = _as_meant(named, shaped, meanings)
    taken = {point for points, _ in named.values() for point in points}
    result = dict(named)
    for role, (points, sure) in shaped.items():
        if role in named or not taken.isdisjoint(points):
            continue
        if role != mirror_role(role) and same != crossed:
            sure = body if same > crossed else UNSURE
        result[role] = (points, sure)
    return result


def _as_meant(named: Found, shaped: Found, meanings: Mapping[int, Collection[str]]) -> Found:
    """Give a point whose name means several roles the one that the shape says."""
    role_of = {points[0]: role for role, (points, _) in shaped.items()}
    meant: Found = {}
    for role, (points, sure) in named.items():
        other = role_of.get(points[0], role) if len(points) == 1 else role
        if other not in named and other in meanings.get(points[0], ()):
            meant[other] = (points, sure)
        else:
            meant[role] = (points, sure)
    return meant


def _meet(one: tuple[int, ...], other: tuple[int, ...], positions: np.ndarray) -> bool:
    """Tell whether two sets of points have the same middle throughout."""
    if one == other:
        return True
    gap = np.linalg.norm(
        positions[:, list(one)].mean(axis=1) - positions[:, list(other)].mean(axis=1), axis=1
    )
    gap = gap[np.isfinite(gap)]
    return bool(len(gap)) and float(gap.max()) <= SAME_PLACE
