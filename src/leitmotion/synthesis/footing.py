"""Footing: feet that stand keep standing while one piece passes into another.

Conventions
-----------
Of a seam of L frames there are three: as the piece before goes on, as the piece after begins, and the two mixed. A
foot is the joint of its toes, or of its ankle where the toes have none. Lengths are shares of the leg, so that body
size does not matter. Bones keep their lengths: hip and knee turn, the foot keeps its direction.

References
----------
Kovar, Schreiner, Gleicher, "Footskate cleanup for motion capture editing", SCA 2002: frames in which a foot is planted,
legs turned analytically to reach its place, corrections that fade between.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.body import BodyMap
from leitmotion.motion import Motion, forward_kinematics
from leitmotion.motion.kinematics import GlobalPose
from leitmotion.motion.rotations import conjugate, from_rotation_vector, multiply, normalize, rotate

SLOW = 0.35  # leg lengths a second: a foot that stands is slower, as captured feet are never quite still
LOW = 0.06  # leg lengths above the floor
FLOOR = 2.0  # percentile of a foot's heights in the whole recording
STEP_S = 0.3  # how long a step takes from one stance to another, half the seam at most
WORTH_A_STEP = 0.03  # leg lengths: less is no step
LIFT = 0.15  # of the way
LOWEST, HIGHEST = 0.025, 0.08  # leg lengths
REACH = 0.9995  # of a straight leg


class Leg(NamedTuple):
    """The joints of a leg, the joint by which its foot stands, and how long and high it all is."""

    hip: int
    knee: int
    ankle: int
    foot: int
    length: float
    floor: float


def legs_of(motion: Motion, roles: BodyMap) -> tuple[Leg, ...]:
    """Find the legs that can be turned: hip, knee and ankle are joints that hang on one another.

    Parameters
    ----------
    motion : Motion
        The whole recording, T frames; tells how high the floor is.
    roles : BodyMap
        Which joint stands for which role.

    Returns
    -------
    tuple of Leg
        At most two; none where roles are not known, or are means of several joints.
    """
    joints = {
        role: motion.skeleton.names.index(members[0])
        for role, members in zip(roles.roles, roles.members, strict=True)
        if len(members) == 1 and members[0] in motion.skeleton.names
    }
    wanted = [
        [joints.get(f"{side}_{part}") for part in ("hip", "knee", "ankle")] for side in ("left", "right")
    ]
    if not any(None not in chain for chain in wanted):
        return ()
    places = forward_kinematics(motion).positions
    legs = []
    for side, (hip, knee, ankle) in zip(("left", "right"), wanted, strict=True):
        if hip is None or knee is None or ankle is None:
            continue
        if not (_hangs(motion, knee, hip) and _hangs(motion, ankle, knee)):
            continue
        toe = joints.get(f"{side}_toe")
        foot = toe if toe is not None and _hangs(motion, toe, ankle) else ankle
        bones = places[:, [hip, knee]] - places[:, [knee, ankle]]
        length = float(np.median(np.linalg.norm(bones, axis=2).sum(axis=1)))
        if length > 0:
            legs.append(Leg(hip, knee, ankle, foot, length, float(np.percentile(places[:, foot, 1], FLOOR))))
    return tuple(legs)


def hold_feet(mixed: Motion, before: Motion, after: Motion, legs: tuple[Leg, ...]) -> Motion:
    """Keep feet where they stand during a seam.

    A foot that stands when the seam begins stays where it is for as long as it stands in the piece before; one that
    stands at the end is there from when it begins to stand in the piece after. Between the two the correction passes
    smoothly from one to the other. A foot that has no time for that, as one that stands all through in two places,
    makes a step: 0.3 s, or half of a shorter seam.

    Parameters
    ----------
    mixed : Motion
        The seam, L frames.
    before, after : Motion
        The same frames of either piece, as placed.
    legs : tuple of Leg
        Those that may be turned.

    Returns
    -------
    Motion
        The seam with legs turned; hips stay, and where a leg would have to be longer its foot stays behind.
    """
    pose, a, b = (forward_kinematics(piece) for piece in (mixed, before, after))
    rotations = mixed.local_rotations.copy()
    for leg in legs:
        at, first, last = (each.positions[:, leg.foot] for each in (pose, a, b))
        shift = _corrections(at, first, last, leg, mixed.rate)
        if shift is not None:
            _turn(rotations, pose, mixed.skeleton.parents, leg, shift)
    return mixed.replace(local_rotations=rotations)


def planted(places: np.ndarray, leg: Leg, rate: float) -> np.ndarray:
    """Tell in which frames a foot stands: it is slow and low.

    Parameters
    ----------
    places : (L, 3) float
        Of the foot.
    leg : Leg
        Tells how slow and how low.
    rate : float
        Frames per second.

    Returns
    -------
    (L,) bool
    """
    if len(places) < 2:
        return np.zeros(len(places), dtype=bool)
    speed = np.linalg.norm(np.gradient(places, axis=0), axis=1) * rate
    return (speed < SLOW * leg.length) & (places[:, 1] < leg.floor + LOW * leg.length)


def _corrections(
    at: np.ndarray, first: np.ndarray, last: np.ndarray, leg: Leg, rate: float
) -> np.ndarray | None:
    """How far the foot is moved in each frame, (L, 3); None where it stands at neither end."""
    frames = len(at)
    stays = _leading(planted(first, leg, rate))
    comes = frames - _leading(planted(last, leg, rate)[::-1])
    if stays == 0 and comes == frames:
        return None
    lift, step = 0.0, min(round(STEP_S * rate), frames // 2)
    if comes - stays < step:  # no time to go from one to the other: a step takes it from either
        middle = (stays + comes) // 2
        away = float(np.linalg.norm((last - first)[min(middle, frames - 1), [0, 2]]))
        if away < WORTH_A_STEP * leg.length:
            return None
        lift = float(np.clip(LIFT * away, LOWEST * leg.length, HIGHEST * leg.length))
        stays = min(max(middle - step // 2, 0), frames - step)
        comes = stays + step
    shift = np.zeros_like(at)
    shift[:stays] = first[:stays] - at[:stays]
    shift[comes:] = last[comes:] - at[comes:]
    left = shift[stays - 1] if stays else np.zeros(3)
    right = shift[comes] if comes < frames else np.zeros(3)
    t = np.arange(1, comes - stays + 1)[:, None] / (comes - stays + 1)
    shift[stays:comes] = left + (3 * t**2 - 2 * t**3) * (right - left)
    shift[stays:comes, 1] += lift * np.sin(np.pi * t[:, 0])
    return shift


def _turn(rotations: np.ndarray, pose: GlobalPose, parents: np.ndarray, leg: Leg, shift: np.ndarray) -> None:
    """Turn hip and knee so that the ankle is `shift` farther, and the ankle so that the foot keeps its direction."""
    hip, knee, ankle = (pose.positions[:, joint] for joint in (leg.hip, leg.knee, leg.ankle))
    thigh, shin = (np.linalg.norm(bone, axis=1) for bone in (knee - hip, ankle - knee))
    wanted = ankle + shift - hip
    reach = np.clip(np.linalg.norm(wanted, axis=1), np.abs(thigh - shin) + 1e-9, REACH * (thigh + shin))
    bend, axis = _angle(hip - knee, ankle - knee)
    opened = np.arccos(np.clip((thigh**2 + shin**2 - reach**2) / (2 * thigh * shin), -1.0, 1.0))
    at_knee = from_rotation_vector(axis * (opened - bend)[:, None])
    reached = knee + rotate(at_knee, ankle - knee) - hip
    angle, around = _angle(reached, wanted)
    at_hip = from_rotation_vector(around * angle[:, None])

    def world(joint: int) -> np.ndarray:
        return pose.rotations[:, joint]

    def above(joint: int) -> np.ndarray:
        parent = int(parents[joint])
        return world(parent) if parent >= 0 else np.array([1.0, 0.0, 0.0, 0.0])

    rotations[:, leg.hip] = multiply(conjugate(above(leg.hip)), multiply(at_hip, world(leg.hip)))
    rotations[:, leg.knee] = multiply(conjugate(above(leg.knee)), multiply(at_knee, world(leg.knee)))
    leg_turned = multiply(at_hip, at_knee)
    rotations[:, leg.ankle] = multiply(conjugate(multiply(leg_turned, above(leg.ankle))), world(leg.ankle))
    for joint in (leg.hip, leg.knee, leg.ankle):
        rotations[:, joint] = normalize(rotations[:, joint])


def _angle(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angle from vectors to others, and the unit axis about which it turns; of none an axis across the first."""
    across = np.cross(a, b)
    sine = np.linalg.norm(across, axis=1)
    angle = np.arctan2(sine, (a * b).sum(axis=1))
    straight = sine < 1e-9 * np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
    aside = np.cross(
        a, np.where(np.abs(a[:, :1]) < 0.9 * np.linalg.norm(a, axis=1)[:, None], [1.0, 0, 0], [0, 0, 1.0])
    )
    axis = np.where(straight[:, None], aside, across)
    return angle, axis / np.linalg.norm(axis, axis=1)[:, None]


def _leading(standing: np.ndarray) -> int:
    """How many frames from the first on are all true."""
    return len(standing) if standing.all() else int(np.argmin(standing))


def _hangs(motion: Motion, joint: int, ancestor: int) -> bool:
    """Whether a joint hangs below another."""
    parent = int(motion.skeleton.parents[joint])
    return parent == ancestor or (parent >= 0 and _hangs(motion, parent, ancestor))
