"""Shape: roles told from how a body is built and moves, where names say nothing.

The four limbs come from :mod:`leitmotion.body.limbs`; the rest is read along them, from the tree or, of points without
one, from the place beside the trunk. Left is told last, from where the feet point, how the knees bend and which way the
person walks (:mod:`leitmotion.body.sides`).
"""

from __future__ import annotations

import numpy as np

from leitmotion.body.cloud import BALL, KNUCKLES, beside_trunk, gap, neck_and_head
from leitmotion.body.graph import Graph, graph_of
from leitmotion.body.limbs import Fit, fit_body
from leitmotion.body.look import Look, typical
from leitmotion.body.roles import mirror_role
from leitmotion.body.sides import weigh_sides
from leitmotion.motion import Motion, Skeleton, Trajectories

Found = dict[str, tuple[tuple[int, ...], float]]
"""role -> (its points, confidence)"""

SURE = 0.8  # a role that build and motion tell clearly
UNSURE = 0.5  # the most that a role has whose side, or whose body, is not clear
TREE, POINTS = (
    (0.8, 1.0),
    (0.45, 0.6),
)  # cost of a body that is not clear, and of none; markers make cheap trees
CLEAR_IN_POINTS = ("pelvis", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe")
TOE_TIP = 0.06  # of stature: how far from the ankle an end must be to show where the foot points


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
    doubtful, most = TREE if isinstance(recording, Motion) else POINTS
    fit = fit_body(graph, most) if graph is not None else None
    if graph is None or fit is None:
        return {}
    chosen = _limbs(graph, fit)
    if isinstance(recording, Motion):
        points = _along_tree(recording.skeleton, graph, fit, chosen, look.positions)
    else:
        points = beside_trunk(graph, fit, chosen)
    tips = {f"{side}_toe": fit.ends[k] for k, side in enumerate(("left", "right"))}
    now, later = (
        {role: placed[:, point] for role, point in points.items()} for placed in (look.positions, look.later)
    )
    for role, tip in tips.items():
        if (
            role not in now
            and gap(graph.positions, tip, chosen[role.replace("toe", "ankle")]) > TOE_TIP * fit.stature
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
    body = SURE if fit.cost < doubtful else UNSURE
    found: Found = {}
    for role, point in points.items():
        named = mirror_role(role) if check.balance < 0 else role
        sided = named != mirror_role(named)
        plain = clear or not sided
        if not isinstance(recording, Motion) and role.rpartition("_")[2] not in CLEAR_IN_POINTS:
            plain = False
        found[named] = ((point,), body if plain else min(body, UNSURE))
    return found


def _limbs(graph: Graph, fit: Fit) -> dict[str, int]:
    """Name the places of arms and legs, the first leg left, and the arm on its side as well."""
    places = {}
    legs, arms = fit.legs, fit.arms
    hips, shoulders = (
        graph.positions[:, pair[0].joints[0]] - graph.positions[:, pair[1].joints[0]] for pair in (legs, arms)
    )
    hands = fit.ends[2:]
    if typical(np.einsum("mc,mc->m", hips, shoulders)) < 0:
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
    points.update(neck_and_head(_to_first_fork(skeleton, skull, arms), positions, fit.stature))
    for k, side in enumerate(("left", "right")):
        if f"{side}_shoulder" in points:
            own, other = points[f"{side}_shoulder"], points.get(f"{mirror_role(side + '_shoulder')}", pelvis)
            held = [p for p in above[own] if p != own and p not in above[other] and p not in skull]
            if held:
                points[f"{side}_clavicle"] = held[0]
        if f"{side}_ankle" in points:
            way = graph.path(chosen[f"{side}_ankle"], fit.ends[k])[1:]
            away = [gap(graph.positions, place, chosen[f"{side}_ankle"]) / fit.stature for place in way]
            toes = [
                graph.members[place][0]
                for place, far in zip(way, away, strict=True)
                if graph.members[place][0] < joints and BALL[0] <= far <= BALL[1]
            ]
            if toes:
                points[f"{side}_toe"] = toes[0]
        if f"{side}_wrist" in points:
            hand = _knuckles(skeleton, points[f"{side}_wrist"], positions, fit.stature)
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


def _knuckles(skeleton: Skeleton, wrist: int, positions: np.ndarray, stature: float) -> int | None:
    """Find the joint in the middle of the first ones that are not at the wrist any more, or that carries others."""
    least, most = (share * stature for share in KNUCKLES)
    beside = [int(j) for j in np.flatnonzero(skeleton.parents == wrist)]
    first, waiting = [], list(beside)
    while waiting:
        joint = waiting.pop()
        away = gap(positions, wrist, joint)
        if least <= away <= most:
            first.append(joint)
        elif away < least:
            waiting += [int(j) for j in np.flatnonzero(skeleton.parents == joint)]
    first = first or [joint for joint in beside if (skeleton.parents == joint).any()]
    if not first:
        return None
    middle = positions[:, first].mean(axis=1)
    aside = [typical(np.linalg.norm(positions[:, j] - middle, axis=1)) // (least / 4) for j in first]
    carried = np.ones(len(skeleton))
    for joint in range(len(skeleton) - 1, 0, -1):
        carried[skeleton.parents[joint]] += carried[joint]
    reach = [gap(positions, wrist, j) for j in first]
    return min(zip(aside, -carried[first], [-r for r in reach], first, strict=True))[-1]
