"""Shape: roles told from how a body is built and moves, where names say nothing.

The four limbs come from :mod:`leitmotion.body.limbs`; the rest is read along them, from the tree or, of points without
one, from the place beside the trunk. Left is told last, from where the feet point, how the knees bend and which way the
person walks (:mod:`leitmotion.body.sides`).
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from leitmotion.body.graph import Graph, graph_of
from leitmotion.body.limbs import Fit, fit_body
from leitmotion.body.look import Look
from leitmotion.body.roles import mirror_role
from leitmotion.body.sides import weigh_sides
from leitmotion.motion import Motion, Skeleton, Trajectories

Found = dict[str, tuple[tuple[int, ...], float]]
"""role -> (its points, confidence)"""

SURE = 0.8  # a role that build and motion tell clearly
UNSURE = 0.5  # the most that a role has whose side, or whose body, is not clear
DOUBTFUL = 0.45  # cost from which a body is not clear
WORST, WORST_POINTS = (
    1.0,
    0.6,
)  # cost of what is no body; markers on the skin make odd trees, some of them cheap
BALL = 0.03  # of stature: how far from the ankle the ball of the foot is at least
KNUCKLES = 0.035  # of stature: how far from the wrist the knuckles are at least
TOE_TIP = 0.06  # of stature: how far from the ankle an end must be to show where the foot points
SKULL = 0.1  # of stature: about how far the base of the skull is from that of the neck, along the joints
MIDDLE = 0.3  # of half the breadth of the shoulders: how far aside a point of the trunk is at most
LOWEST, PELVIS, NECK, HIGHEST = (
    -0.15,
    0.3,
    0.8,
    1.7,
)  # between hips, 0, and shoulders, 1: up to where each part reaches


def roles_from_shape(recording: Motion | Trajectories, look: Look) -> Found:
    """Tell roles from the shape and the motion of a body alone.

    Parameters
    ----------
    recording : Motion or Trajectories
        Whose names are not looked at.
    look : Look
        Where its points are at some moments.

    Returns
    -------
    dict of str to (points, confidence)
        Empty where no whole body is found. Confidence is 0.8; 0.5 and less where it is unclear which side is left (of
        the roles that have one) or whether this is a body.
    """
    graph = graph_of(recording, look.positions)
    most = WORST if isinstance(recording, Motion) else WORST_POINTS
    fit = fit_body(graph, most) if graph is not None else None
    if graph is None or fit is None:
        return {}
    chosen = _limbs(graph, fit)
    if isinstance(recording, Motion):
        points = _along_tree(recording.skeleton, graph, fit, chosen, look.positions)
    else:
        points = _beside_trunk(graph, fit, chosen)
    tips = {f"{side}_toe": fit.ends[k] for k, side in enumerate(("left", "right"))}
    now, later = (
        {role: placed[:, point] for role, point in points.items()} for placed in (look.positions, look.later)
    )
    for role, tip in tips.items():
        if (
            role not in now
            and _apart(graph, tip, chosen[role.replace("toe", "ankle")]) > TOE_TIP * fit.stature
        ):
            now[role] = graph.positions[:, tip]
    if "pelvis" not in now:
        now["pelvis"], later["pelvis"] = (
            (those["left_hip"] + those["right_hip"]) / 2 for those in (now, later)
        )
    if "neck" not in now:
        now["neck"] = (now["left_shoulder"] + now["right_shoulder"]) / 2
    check = weigh_sides(now, later, look.step if look.metric else 0.0, look.duration)
    clear = check.confidence > UNSURE
    body = SURE if fit.cost < DOUBTFUL else UNSURE
    found: Found = {}
    for role, point in points.items():
        named = mirror_role(role) if check.balance < 0 else role
        sided = named != mirror_role(named)
        found[named] = ((point,), body if clear or not sided else min(body, UNSURE))
    return found


def _limbs(graph: Graph, fit: Fit) -> dict[str, int]:
    """Name the places of arms and legs, the first leg left, and the arm on its side as well."""
    places = {}
    legs, arms = fit.legs, fit.arms
    hips, shoulders = (
        graph.positions[:, pair[0].joints[0]] - graph.positions[:, pair[1].joints[0]] for pair in (legs, arms)
    )
    hands = fit.ends[2:]
    if np.nanmedian(np.einsum("ti,ti->t", hips, shoulders)) < 0:
        arms, hands = arms[::-1], hands[::-1]
    for k, side in enumerate(("left", "right")):
        for limb, roles in ((legs[k], ("hip", "knee", "ankle")), (arms[k], ("shoulder", "elbow", "wrist"))):
            places.update({f"{side}_{role}": place for role, place in zip(roles, limb.joints, strict=True)})
        places[f"{side}_fingers"] = hands[k]
    return places


def _along_tree(
    skeleton: Skeleton, graph: Graph, fit: Fit, chosen: dict[str, int], positions: np.ndarray
) -> dict[str, int]:
    """Name the joints of a skeleton: those of the limbs, and what hangs on them or holds them."""
    joints = len(skeleton)
    points = {
        role: graph.members[place][0]
        for role, place in chosen.items()
        if not role.endswith("fingers") and graph.members[place][0] < joints
    }
    pelvis = graph.members[fit.pelvis][0]
    points["pelvis"] = pelvis
    above = {point: _line(skeleton, point) for point in range(joints)}
    shoulders = [points[f"{side}_shoulder"] for side in ("left", "right") if f"{side}_shoulder" in points]
    arms = {point for shoulder in shoulders for point in above[shoulder]}
    top = [point for place in fit.head for point in graph.members[place] if point < joints]
    skull = above[top[-1]] if top else []
    points.update(_neck_and_head(_to_first_fork(skeleton, skull, arms), positions, fit.stature))
    for k, side in enumerate(("left", "right")):
        if f"{side}_shoulder" in points:
            own, other = points[f"{side}_shoulder"], points.get(f"{mirror_role(side + '_shoulder')}", pelvis)
            held = [p for p in above[own] if p != own and p not in above[other] and p not in skull]
            if held:
                points[f"{side}_clavicle"] = held[0]
        if f"{side}_ankle" in points:
            way = graph.path(chosen[f"{side}_ankle"], fit.ends[k])[1:]
            toes = [
                graph.members[place][0]
                for place in way
                if graph.members[place][0] < joints
                and _apart(graph, place, chosen[f"{side}_ankle"]) >= BALL * fit.stature
            ]
            if toes:
                points[f"{side}_toe"] = toes[0]
        if f"{side}_wrist" in points:
            hand = _knuckles(skeleton, points[f"{side}_wrist"], positions, KNUCKLES * fit.stature)
            if hand is not None:
                points[f"{side}_hand"] = hand
    return points


def _line(skeleton: Skeleton, joint: int) -> list[int]:
    """List a joint and all above it, the root first."""
    line = [joint]
    while skeleton.parents[line[-1]] >= 0:
        line.append(int(skeleton.parents[line[-1]]))
    return line[::-1]


def _to_first_fork(skeleton: Skeleton, line: list[int], arms: set[int]) -> list[int]:
    """Take from a line the joints that carry no arm, up to the first that carries several: eyes sit on the head."""
    way = [joint for joint in line if joint not in arms]
    forks = [k for k, joint in enumerate(way) if np.count_nonzero(skeleton.parents == joint) > 1]
    return way[: forks[0] + 1] if forks else way


def _neck_and_head(line: list[int], positions: np.ndarray, stature: float) -> dict[str, int]:
    """Name the neck, the first of a line of joints, and of the others the one that is as far away as a skull's base."""
    if not line:
        return {}
    if len(line) == 1:
        return {"head": line[0]}
    along = np.cumsum([_gap(positions, a, b) for a, b in pairwise(line)])
    return {"neck": line[0], "head": line[1 + int(np.abs(along - SKULL * stature).argmin())]}


def _knuckles(skeleton: Skeleton, wrist: int, positions: np.ndarray, least: float) -> int | None:
    """Find the joint in the middle of the first ones that are not at the wrist any more, or that carries others."""
    beside = [int(j) for j in np.flatnonzero(skeleton.parents == wrist)]
    first, waiting = [], list(beside)
    while waiting:
        joint = waiting.pop()
        if _gap(positions, wrist, joint) >= least:
            first.append(joint)
        else:
            waiting += [int(j) for j in np.flatnonzero(skeleton.parents == joint)]
    first = first or [joint for joint in beside if (skeleton.parents == joint).any()]
    if not first:
        return None
    middle = np.nanmean(positions[:, first], axis=1)
    aside = [np.nanmedian(np.linalg.norm(positions[:, j] - middle, axis=1)) // (least / 4) for j in first]
    carried = np.ones(len(skeleton))
    for joint in range(len(skeleton) - 1, 0, -1):
        carried[skeleton.parents[joint]] += carried[joint]
    reach = [_gap(positions, wrist, j) for j in first]
    return min(zip(aside, -carried[first], [-r for r in reach], first, strict=True))[-1]


def _beside_trunk(graph: Graph, fit: Fit, chosen: dict[str, int]) -> dict[str, int]:
    """Name the points of a body without a tree by how high beside the trunk they are, and how far to the left."""
    roles = {role: place for role, place in chosen.items() if not role.endswith("fingers")}
    beyond: set[int] = set()
    for k, side in enumerate(("left", "right")):
        foot, hand = graph.path(roles[f"{side}_ankle"], fit.ends[k]), _way_to_hand(graph, chosen, side)
        for role, way, least in (("toe", foot, BALL), ("hand", hand, KNUCKLES)):
            far = [place for place in way[1:] if _apart(graph, way[0], place) >= least * fit.stature]
            roles.update({f"{side}_{role}": place for place in far[:1]})
            beyond.update(way)
    free = [place for place in range(len(graph.members)) if place not in beyond | set(roles.values())]
    height, aside = _in_trunk(graph, chosen)
    middle = sorted((place for place in free if abs(aside[place]) < MIDDLE), key=lambda place: height[place])
    trunk = [place for place in middle if LOWEST < height[place] < NECK]
    top = [place for place in middle if NECK <= height[place] < HIGHEST]
    if trunk and height[trunk[0]] < PELVIS:
        roles["pelvis"] = trunk.pop(0)
    if trunk:
        roles["chest"] = trunk[-1]
    if len(trunk) > 1:
        roles["spine"] = min(trunk[:-1], key=lambda place: abs(height[place] - height[trunk[-1]] / 2))
    roles.update(_neck_and_head(top, graph.positions, fit.stature))
    points = {role: graph.members[place][0] for role, place in roles.items()}
    for side, sign in (("left", 1.0), ("right", -1.0)):
        held = [
            place for place in free if MIDDLE <= sign * aside[place] < 1 and NECK <= height[place] < HIGHEST
        ]
        if held:
            points[f"{side}_clavicle"] = graph.members[held[0]][0]
    coinciding = graph.members[roles["neck"]] if "neck" in roles else ()
    if len(coinciding) > 2 and "left_clavicle" not in points:
        points.update(zip(("left_clavicle", "right_clavicle"), coinciding[1:], strict=False))
    return points


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
    return (
        np.nanmedian(high / np.einsum("mc,mc->m", up, up)[:, None], axis=0),
        np.nanmedian(far / np.einsum("mc,mc->m", across, across)[:, None], axis=0),
    )


def _apart(graph: Graph, a: int, b: int) -> float:
    return _gap(graph.positions, a, b)


def _gap(positions: np.ndarray, a: int, b: int) -> float:
    gap = np.linalg.norm(positions[:, a] - positions[:, b], axis=1)
    gap = gap[np.isfinite(gap)]
    return float(np.median(gap)) if len(gap) else 0.0
