"""Which joints or markers stand for which role: read from names and the tree, checked against geometry and motion.

Conventions
-----------
Confidence is 1 where a name says a role outright and the tree and the geometry agree; markers on the skin start at 0.9,
stand-ins lower; what speaks against an assignment lowers it (:mod:`leitmotion.body.plausibility`,
:mod:`leitmotion.body.sides`). What names leave open is told by the body's shape (:mod:`leitmotion.body.shape`), with
at most 0.8. A role that cannot be told is absent. Named sides are never swapped, and a side that is only likely has
no more than 0.5.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from leitmotion.body.body import BodyMap
from leitmotion.body.look import Look, look_at
from leitmotion.body.names import PointName, parse_names
from leitmotion.body.plausibility import DOUBT, SEGMENTS, doubts
from leitmotion.body.reconcile import reconcile
from leitmotion.body.roles import ANALYSIS_ROLES, ROLES, mirror_role
from leitmotion.body.shape import Found, roles_from_shape
from leitmotion.body.sides import weigh_sides
from leitmotion.body.vocabulary import AXIAL_WORDS, BONES, LANDMARKS, LIMB_WORDS, ON_SKIN, Alternative
from leitmotion.motion import Motion, Skeleton, Trajectories


def find_roles(recording: Motion | Trajectories) -> BodyMap:
    """Find what each joint or marker of a recording is, from its name, else from the shape of the body.

    Names are read by :func:`leitmotion.body.names.parse_names` and matched against
    :mod:`leitmotion.body.vocabulary`, all names of the recording together. In a skeleton the trunk is read
    from the tree: ``chest`` is the last joint below the neck and the arms, ``spine`` the one nearest to half
    way between it and the pelvis. What no name says, but others imply, is their mean: the pelvis of two hips
    (confidence 0.8), the neck of two clavicles (0.8) or two shoulders (0.6).

    Where names leave one of :data:`leitmotion.body.ANALYSIS_ROLES` open, or something speaks against them, the shape of
    the body is asked: where its bones meet, how long they are, where feet point and knees bend.

    Parameters
    ----------
    recording : Motion or Trajectories
        Whose names to read. Some frames are placed in the world to check what the names say.

    Returns
    -------
    BodyMap
        The roles found, in the order of :data:`leitmotion.body.ROLES`, each with its members and confidence.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Trajectories
    >>> waist = ("LASI", "RASI", "LPSI", "RPSI", "LKNE", "RKNE")
    >>> found = find_roles(Trajectories(waist, np.full((1, 6, 3), np.nan), rate=100))
    >>> found.roles
    ('pelvis', 'left_hip', 'left_knee', 'right_hip', 'right_knee')
    >>> found.members[0], found.confidence.tolist()
    (('LASI', 'RASI', 'LPSI', 'RPSI'), [0.9, 0.5, 0.9, 0.5, 0.9])
    """
    skeleton = recording.skeleton if isinstance(recording, Motion) else None
    names = skeleton.names if skeleton is not None else recording.names  # type: ignore[union-attr]
    look = look_at(recording)
    parsed = parse_names(names)
    on_skin = (
        isinstance(recording, Trajectories)
        and recording.kind == "marker"
        and not LANDMARKS.isdisjoint(name.word for name in parsed)
    )
    named = _from_names(parsed, ignored=BONES if on_skin else frozenset())
    found = dict(named)
    _complete(found, skeleton)
    against = _doubts(found, skeleton, look)
    open_questions = against or not set(ANALYSIS_ROLES) <= set(found) or _passed_over(found, skeleton)
    if open_questions and not on_skin:
        both = reconcile(named, roles_from_shape(recording, look), look.positions, _meanings(parsed))
        if both != named:
            found = both
            _complete(found, skeleton)
            against = _doubts(found, skeleton, look)
    roles = tuple(role for role in ROLES if role in found)
    highest = ON_SKIN if on_skin else 1.0
    return BodyMap(
        roles=roles,
        members=tuple(tuple(names[i] for i in found[role][0]) for role in roles),
        confidence=np.array([min(found[role][1], highest) * against.get(role, 1.0) for role in roles]),
    )


def _complete(found: Found, skeleton: Skeleton | None) -> None:
    """Add what the roles found say about others."""
    if skeleton is not None:
        _trunk_from_tree(found, skeleton)
    _imply(found)


def _from_names(parsed: Sequence[PointName], ignored: frozenset[str]) -> Found:
    """Let each role choose, in the vocabulary's order, among the words that are left.

    The words `ignored` serve in pairs only (``radius ulna`` are two markers beside the wrist).
    """
    place: dict[PointName, int] = {}
    for i, name in enumerate(parsed):
        place.setdefault(name, i)
    taken: set[int] = set()
    found: Found = {}
    for limb, alternatives in LIMB_WORDS.items():
        for side in ("left", "right"):
            spoken = tuple(one for one in alternatives if one[0] not in ignored)
            _choose(f"{side}_{limb}", side, spoken, place, taken, found)
    for role, alternatives in AXIAL_WORDS.items():
        _choose(role, "", alternatives, place, taken, found)
    return found


def _meanings(parsed: Sequence[PointName]) -> dict[int, list[str]]:
    """Tell for each point all roles that its name may mean."""
    return {
        i: [
            f"{name.side}_{limb}"
            for limb, alternatives in LIMB_WORDS.items()
            if any(name.word == alternative.split()[0] for alternative, _ in alternatives)
        ]
        for i, name in enumerate(parsed)
        if name.side
    }


def _choose(
    role: str,
    side: str,
    alternatives: tuple[Alternative, ...],
    place: Mapping[PointName, int],
    taken: set[int],
    found: Found,
) -> None:
    for alternative, confidence in alternatives:
        words = alternative.split()
        wanted = [
            PointName(part, word.rstrip("*"))
            for word in words
            if word[0] not in "+-"
            for part in (("left", "right") if word.endswith("*") else (side,))
        ]
        conditions = [(word[0] == "+", _is_there(word[1:], side, place)) for word in words if word[0] in "+-"]
        if not all(name in place for name in wanted) or any(want != there for want, there in conditions):
            continue
        points = tuple(place[name] for name in wanted)
        if len(points) > 1 or points[0] not in taken:
            taken.update(points)
            found[role] = (points, confidence)
            return


def _is_there(word: str, side: str, place: Mapping[PointName, int]) -> bool:
    """Whether a name of this side, or of none, says a word."""
    return PointName(side, word) in place or PointName("", word) in place


def _trunk_from_tree(found: Found, skeleton: Skeleton) -> None:
    """Name chest and spine by their place in the tree, whatever the file calls them."""
    top = next((found[role][0][0] for role in ("neck", "head", "left_clavicle") if role in found), None)
    if top is None or "pelvis" not in found:
        return
    pelvis = found["pelvis"][0][0]
    path = _path_between(skeleton.parents, pelvis, top)
    if path is None:
        return
    for role in ("chest", "spine"):
        found.pop(role, None)
    if not path:
        return
    sure = min(1.0, *(found[role][1] for role in ("pelvis", "neck", "head") if role in found))
    heights = np.cumsum([np.linalg.norm(skeleton.offsets[joint]) for joint in path])
    found["chest"] = ((path[-1],), sure)
    if len(path) > 1:
        off = np.abs(heights[:-1] - heights[-1] / 2) / max(heights[-1], 1e-12)
        nearest = int(off.round(6).argmin())  # of two that are as near the lower, whatever the unit
        found["spine"] = ((path[nearest],), sure)


def _path_between(parents: np.ndarray, ancestor: int, joint: int) -> list[int] | None:
    """Joints strictly between an ancestor and a joint, from below; None where it is no ancestor."""
    path: list[int] = []
    joint = int(parents[joint])
    while joint not in (ancestor, -1):
        path.append(joint)
        joint = int(parents[joint])
    return path[::-1] if joint == ancestor else None


def _imply(found: Found) -> None:
    """Fill the pelvis and the neck from the pair of joints around them."""
    for role, pair, confidence in (
        ("pelvis", "hip", 0.8),
        ("neck", "clavicle", 0.8),
        ("neck", "shoulder", 0.6),
    ):
        left, right = found.get(f"left_{pair}"), found.get(f"right_{pair}")
        if role not in found and left is not None and right is not None:
            found[role] = (left[0] + right[0], min(left[1], right[1], confidence))


def _doubts(found: Found, skeleton: Skeleton | None, look: Look) -> dict[str, float]:
    """Multiply, for each role, what geometry, sides and tree have against it."""
    now, later = (
        {role: placed[:, list(points)].mean(axis=1) for role, (points, _) in found.items()}
        for placed in (look.positions, look.later)
    )
    sides = weigh_sides(now, later, look.step if look.metric else 0.0, look.duration)
    against = [doubts(now)]
    if sides.verdict == "swapped" or sides.crossed:
        against.append({role: DOUBT for role in found if role != mirror_role(role)})
    if skeleton is not None:
        against.append(_tree_doubts(found, skeleton))
    return {
        role: factor
        for role in found
        if (factor := float(np.prod([those.get(role, 1.0) for those in against]))) < 1.0
    }


def _passed_over(found: Found, skeleton: Skeleton | None) -> bool:
    """Whether a joint lies between two that should follow each other: a twist, or the one that is meant."""
    return skeleton is not None and any(
        _path_between(skeleton.parents, found[upper][0][0], found[lower][0][0])
        for side in ("left", "right")
        for upper, lower in ((f"{side}_{above}", f"{side}_{below}") for above, below in SEGMENTS)
        if upper in found and lower in found
    )


def _tree_doubts(found: Found, skeleton: Skeleton) -> dict[str, float]:
    """Doubt a joint that does not hang, however far, on the joint that its role hangs on."""
    doubt = {}
    for side in ("left", "right"):
        for above, below in SEGMENTS:
            upper, lower = found.get(f"{side}_{above}"), found.get(f"{side}_{below}")
            if upper and lower and _path_between(skeleton.parents, upper[0][0], lower[0][0]) is None:
                doubt[f"{side}_{below}"] = DOUBT
    return doubt
