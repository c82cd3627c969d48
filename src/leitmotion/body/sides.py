"""Sides: whether what is called left is on the left of where the person looks.

A body is nearly its own mirror image, so that sides show only against a front. Four things tell where the front is:

- the lower foot points there, from the ankle to the ball; the other may hang;
- a knee bends so that it stands before the line from hip to ankle, an elbow so that it stands behind the line from
  shoulder to wrist: a hinge opens one way only;
- people walk forwards far more often than backwards.

Each gives a vote from -1 (the sides are swapped) to 1 (they are as called). Feet are believed first, then knees.
Walking is believed where the knees say the same, since some walk backwards. Elbows count where the arm hangs, and
little: the shoulder turns them about.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from leitmotion.body.body import BodyMap
from leitmotion.body.look import between, by_role, look_at, typical
from leitmotion.motion import Motion, Trajectories

Points = Mapping[str, np.ndarray]
"""role -> (M, C) positions"""

SLOWEST_MPS = 0.4  # who is slower stands and sways
SHORTEST_M = 2.0  # who goes less far may step aside
BENT = (
    0.12  # of the upper bone: how far a joint must be off the line between its neighbours to be called bent
)
OFTEN = 0.1  # of the moments: knees bent less often count less
HANGING = 0.5  # cosine between the upper arm of a hanging arm and the way down the trunk
LEVEL = 0.3  # cosine between foot and front: a foot that points at the ground shows no front
WEIGHTS = {"feet": 3.0, "knees": 2.0, "walking": 1.0, "elbows": 0.5}
CLEAR = 0.8  # of 1: a clear vote; when running or falling some feet and knees point elsewhere
AGAINST = -0.5  # of 1: a vote that takes another's clearness away

_FEET, _WALK, _HINGE = 0.9, 0.8, 0.5  # how sure: clear feet; a walk and knees; knees alone
_SAYS = {
    "feet": ("the foot on the ground points forwards", "the foot on the ground points backwards"),
    "knees": ("the knees bend forwards", "the knees bend backwards"),
    "walking": ("the person walks forwards", "the person walks backwards"),
    "elbows": ("the elbows point backwards", "the elbows point forwards"),
}


@dataclass(frozen=True)
class SideCheck:
    """What the body says about the names of its sides."""

    verdict: str
    """"agree" where left is left, "swapped" where what is called left is right, "unknown" where it cannot be told."""

    confidence: float
    """How sure the verdict is, 0 to 1; 0 for "unknown"."""

    reason: str
    """Why, in words, taking the sides as they are called."""

    votes: Mapping[str, float]
    """What was seen of "feet", "knees", "walking" and "elbows", each from -1, swapped, to 1, as called."""

    crossed: bool = False
    """Whether hips and shoulders disagree on which side is left."""

    @property
    def balance(self) -> float:
        """All votes together, -1 to 1; 0 without any."""
        total = sum(WEIGHTS[kind] for kind in self.votes)
        return sum(WEIGHTS[kind] * vote for kind, vote in self.votes.items()) / total if total else 0.0


def check_sides(recording: Motion | Trajectories, body_map: BodyMap) -> SideCheck:
    """Tell whether what is called left is on the left of where the person looks.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames, Y up.
    body_map : BodyMap
        Which of its points stand for which role. Needed are both hips, and ankles with toes or knees; the way up is
        told by pelvis and neck, else by the legs.

    Returns
    -------
    SideCheck
        "swapped" also where the file's axes are left-handed; which of the two it is, points alone cannot tell.

    Examples
    --------
    >>> import leitmotion as lm
    >>> from leitmotion.body import find_roles, swap_sides
    >>> motion = lm.compose_session(seed=0, rate=30.0).motion
    >>> check_sides(motion, find_roles(motion)).verdict
    'agree'
    >>> check_sides(motion, swap_sides(find_roles(motion))).verdict
    'swapped'
    """
    names = recording.skeleton.names if isinstance(recording, Motion) else recording.names
    look = look_at(recording)
    members = dict(zip(body_map.roles, body_map.members, strict=True))
    now, later = (by_role(placed, names, members) for placed in (look.positions, look.later))
    seconds = look.step if look.metric else 0.0
    return weigh_sides(now, later, seconds, look.duration)


def weigh_sides(now: Points, later: Points, step: float, duration: float) -> SideCheck:
    """Tell the same from where each role is at some moments and a little later.

    Parameters
    ----------
    now, later : mapping of str to (M, 3) float
        Positions by role, metres, NaN where unseen.
    step : float
        Seconds from `now` to `later`; 0 where walking cannot be told.
    duration : float
        Seconds that the recording lasts.

    Returns
    -------
    SideCheck
        The verdict.
    """
    front = _front(now)
    if front is None:
        return SideCheck("unknown", 0.0, "hips and the way up are not known in three dimensions", {})
    if typical(_dot(_across(now, "hip"), _across(now, "shoulder"))) < 0:
        return SideCheck("unknown", 0.0, "hips and shoulders disagree on which side is left", {}, True)
    seen = {
        "feet": _feet(now, front),
        "knees": _knees(now, front),
        "walking": _walking(now, later, front, step, duration),
        "elbows": _elbows(now, front),
    }
    return _verdict({kind: vote for kind, vote in seen.items() if vote is not None})


def _verdict(votes: dict[str, float]) -> SideCheck:
    sign = 1.0 if SideCheck("", 0.0, "", votes).balance >= 0 else -1.0
    said = {kind: sign * vote for kind, vote in votes.items()}
    feet, knees, walking = (said.get(kind, 0.0) for kind in ("feet", "knees", "walking"))
    if feet >= CLEAR and knees > AGAINST:
        sure = _FEET
    elif walking >= CLEAR and knees >= CLEAR:
        sure = _WALK
    elif knees >= CLEAR and feet > AGAINST:
        sure = _HINGE
    else:
        return SideCheck("unknown", 0.0, _in_words(votes) or "no foot, knee or walk is seen", votes)
    return SideCheck("agree" if sign > 0 else "swapped", sure, _in_words(votes), votes)


def _in_words(votes: Mapping[str, float]) -> str:
    return ", ".join(_SAYS[kind][vote < 0] for kind, vote in votes.items() if abs(vote) >= -AGAINST)


def _feet(now: Points, front: np.ndarray) -> float | None:
    left, right = (between(now, f"{side}_ankle", f"{side}_toe") for side in ("left", "right"))
    if left is None or right is None:
        return None
    lower = now["left_ankle"][:, 1] < now["right_ankle"][:, 1]
    foot = _unit(np.where(lower[:, None], left, right))
    ahead = _dot(foot, front)
    return _vote(ahead) if typical(np.abs(ahead)) >= LEVEL else None


def _knees(now: Points, front: np.ndarray) -> float | None:
    votes = [_hinge(now, side, ("hip", "knee", "ankle"), front) for side in ("left", "right")]
    seen = np.concatenate([vote for vote in votes if vote is not None] or [np.array([])])
    vote = _vote(seen)
    return None if vote is None else vote * min(1.0, float(np.isfinite(seen).mean()) / OFTEN)


def _elbows(now: Points, front: np.ndarray) -> float | None:
    up, votes = _up(now), []
    for side in ("left", "right"):
        vote = _hinge(now, side, ("shoulder", "elbow", "wrist"), front)
        arm = between(now, f"{side}_shoulder", f"{side}_elbow")
        if vote is not None and arm is not None and up is not None:
            votes.append(np.where(_dot(_unit(arm), _unit(up)) < -HANGING, -vote, np.nan))
    return _vote(np.concatenate(votes)) if votes else None


def _walking(now: Points, later: Points, front: np.ndarray, step: float, duration: float) -> float | None:
    if not step or "pelvis" not in now:
        return None
    velocity = (later["pelvis"] - now["pelvis"]) / step * (1.0, 0.0, 1.0)
    speed = np.linalg.norm(velocity, axis=1)
    seen = np.isfinite(speed)
    going = seen & (speed > SLOWEST_MPS)
    if not going.any() or speed[going].sum() / seen.sum() * duration < SHORTEST_M:
        return None
    ahead = _dot(velocity, _unit(front * (1.0, 0.0, 1.0)))[going]
    return float(np.nansum(ahead) / speed[going].sum())


def _hinge(now: Points, side: str, roles: tuple[str, str, str], front: np.ndarray) -> np.ndarray | None:
    """How far before the line between its neighbours a bent joint stands, in upper bones; NaN where it is straight."""
    upper = between(now, f"{side}_{roles[0]}", f"{side}_{roles[1]}")
    whole = between(now, f"{side}_{roles[0]}", f"{side}_{roles[2]}")
    if upper is None or whole is None:
        return None
    line = _unit(whole)
    bone = _unit(upper)
    off = bone - _dot(bone, line)[:, None] * line
    return np.where(np.linalg.norm(off, axis=1) > BENT, _dot(off, front), np.nan)


def _front(now: Points) -> np.ndarray | None:
    left, up = _across(now, "hip"), _up(now)
    if left is None or up is None or left.shape[1] != 3:
        return None
    return _unit(np.cross(left, up))


def _up(now: Points) -> np.ndarray | None:
    trunk = between(now, "pelvis", "neck")
    legs = [between(now, f"{side}_ankle", "pelvis") for side in ("left", "right")]
    if trunk is not None or legs[0] is None or legs[1] is None:
        return trunk
    return legs[0] + legs[1]


def _across(now: Points, pair: str) -> np.ndarray | None:
    return between(now, f"right_{pair}", f"left_{pair}")


def _vote(ahead: np.ndarray) -> float | None:
    """From -1, all of it backwards, to 1; None where there is nothing."""
    ahead = ahead[np.isfinite(ahead)]
    total = np.abs(ahead).sum()
    return float(ahead.sum() / total) if total > 0 else None


def _dot(a: np.ndarray | None, b: np.ndarray | None) -> np.ndarray:
    return np.array([]) if a is None or b is None else np.einsum("ti,ti->t", a, b)


def _unit(vectors: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0, length, np.nan)
