"""Cloud: the joints of a body that has no tree, told by where they are beside its limbs and its trunk."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from leitmotion.body.graph import Graph
from leitmotion.body.limbs import Fit
from leitmotion.body.look import typical

BALL = (0.03, 0.2)  # of stature: how far from the ankle the ball of the foot is
KNUCKLES = (0.035, 0.12)  # of stature: how far from the wrist the knuckles are; a stick reaches farther
SKULL = 0.1  # of stature: about how far the base of the skull is from that of the neck, along the joints
MIDDLE = 0.3  # of half the breadth of the shoulders: how far aside a point of the trunk is at most
INNERMOST = 0.1  # of the same: how far aside a clavicle is at least
LOWEST, PELVIS = -0.15, 0.3  # between hips, 0, and shoulders, 1: where the pelvis is
NECK, SHOULDERS = (
    0.95,
    (0.8, 1.3),
)  # likewise: about where the base of the neck is; where it and clavicles may be
COINCIDING = 3  # points in one place at the shoulders: the neck and both clavicles
BELOW = 0.1  # how far below the clavicles the base of the neck may be
ALIKE = 0.25  # by how much the heights and the sides of two clavicles may differ


def beside_trunk(graph: Graph, fit: Fit, chosen: dict[str, int]) -> dict[str, int]:
    """Name the points of a body without a tree by how high along the trunk they are, and how far to the left of it.

    Parameters
    ----------
    graph : Graph
        The points, joined by what stays as long as it is.
    fit : Fit
        The limbs among them.
    chosen : dict of str to int
        The places of the limbs' joints by role, the ends of the hands as "left_fingers" and "right_fingers".

    Returns
    -------
    dict of str to int
        The point of each role.
    """
    roles = {role: place for role, place in chosen.items() if not role.endswith("fingers")}
    beyond: set[int] = set()
    for k, side in enumerate(("left", "right")):
        foot, hand = graph.path(roles[f"{side}_ankle"], fit.ends[k]), _way_to_hand(graph, chosen, side)
        for role, way, (least, most) in (("toe", foot, BALL), ("hand", hand, KNUCKLES)):
            far = [place for place in way[1:] if gap(graph.positions, way[0], place) >= least * fit.stature]
            if far and gap(graph.positions, way[0], far[0]) <= most * fit.stature:
                roles[f"{side}_{role}"] = far[0]
            beyond.update(way)
    free = [place for place in range(len(graph.members)) if place not in beyond | set(roles.values())]
    height, aside = _in_trunk(graph, chosen)
    pair = _pair_beside(free, height, aside)
    roles.update(zip(("left_clavicle", "right_clavicle"), pair, strict=False))
    middle = [place for place in free if abs(aside[place]) < MIDDLE and place not in pair]
    middle.sort(key=lambda place: height[place])
    lowest = min((height[place] for place in pair), default=SHOULDERS[0] + BELOW) - BELOW
    top = [place for place in middle if lowest <= height[place] < SHOULDERS[1]]
    joint = [place for place in top if len(graph.members[place]) >= COINCIDING]
    neck = min(joint or top, key=lambda place: abs(height[place] - NECK), default=None)
    trunk = [place for place in middle if LOWEST < height[place] < (NECK if neck is None else height[neck])]
    if trunk and height[trunk[0]] < PELVIS:
        roles["pelvis"] = trunk.pop(0)
    if trunk:
        roles["chest"] = trunk[-1]
    if len(trunk) > 1:
        roles["spine"] = min(trunk[:-1], key=lambda place: abs(height[place] - height[trunk[-1]] / 2))
    above = [
        place for place in middle if place not in trunk and neck is not None and height[place] >= height[neck]
    ]
    roles.update(neck_and_head(above, graph.positions, fit.stature))
    points = {role: graph.members[place][0] for role, place in roles.items()}
    coinciding = graph.members[roles["neck"]] if "neck" in roles else ()
    if len(coinciding) >= COINCIDING and not pair:
        points.update(zip(("left_clavicle", "right_clavicle"), coinciding[1:], strict=False))
    return points


def _pair_beside(free: list[int], height: np.ndarray, aside: np.ndarray) -> tuple[int, ...]:
    """Find the left and the right of two points that are as high and as far aside as each other, at the shoulders."""
    best: tuple[int, ...] = ()
    least = ALIKE
    for left in free:
        for right in free:
            off = abs(aside[left] + aside[right]) + abs(height[left] - height[right])
            apart = INNERMOST < aside[left] < 1 and aside[right] < -INNERMOST
            if apart and SHOULDERS[0] <= height[left] < SHOULDERS[1] and off < least:
                best, least = (left, right), off
    return best


def _way_to_hand(graph: Graph, chosen: dict[str, int], side: str) -> list[int]:
    return graph.path(chosen[f"{side}_wrist"], chosen[f"{side}_fingers"])


def _in_trunk(graph: Graph, chosen: dict[str, int]) -> tuple[np.ndarray, np.ndarray]:
    """Tell for each place how high it is, hips 0 and shoulders 1, and how far to the left, the left shoulder 1."""
    left, right, low_left, low_right = (
        graph.positions[:, chosen[role]]
        for role in ("left_shoulder", "right_shoulder", "left_hip", "right_hip")
    )
    up, across = (left + right - low_left - low_right) / 2, (left - right) / 2
    high = np.einsum("mnc,mc->mn", graph.positions - (low_left + low_right)[:, None] / 2, up)
    far = np.einsum("mnc,mc->mn", graph.positions - (left + right)[:, None] / 2, across)
    high = high / np.einsum("mc,mc->m", up, up)[:, None]
    far = far / np.einsum("mc,mc->m", across, across)[:, None]
    return np.array([typical(row) for row in high.T]), np.array([typical(row) for row in far.T])


def neck_and_head(line: list[int], positions: np.ndarray, stature: float) -> dict[str, int]:
    """Name the neck, the first of a line of joints, and of the others the one that is as far away as a skull's base."""
    if not line:
        return {}
    if len(line) == 1:
        return {"head": line[0]}
    along = np.cumsum([gap(positions, a, b) for a, b in pairwise(line)])
    return {"neck": line[0], "head": line[1 + int(np.abs(along - SKULL * stature).argmin())]}


def gap(positions: np.ndarray, a: int, b: int) -> float:
    """Usual distance of two points; 0 of such as are never seen together."""
    gap = typical(np.linalg.norm(positions[:, a] - positions[:, b], axis=1))
    return gap if gap > 0 else 0.0
