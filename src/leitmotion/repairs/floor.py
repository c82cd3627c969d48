"""The floor: where it is, told by the feet that stand on it, and the recording turned so that it is level, at 0.

A foot stands where it is slow, and where it is slow it is nearly always on the floor; a foot that is held in the air
is slow as well, but above. Each point of the feet (ankles, balls, heels, tips) keeps its own height over the floor, so
that one plane with an offset for each point is fitted to the slow moments, the points that lie above it being left
out, time after time.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from leitmotion.body import BodyMap, map_of
from leitmotion.body.names import parse_names
from leitmotion.motion import (
    DataError,
    Trajectories,
    end_site_positions,
    forward_kinematics,
    rotations,
)
from leitmotion.repairs.repaired import Change, Recording, Repaired, need_recording

STANDING_MPS = 0.12  # slower, a point of a foot stands
FOOT_WORDS = ("toe", "heel", "hee", "mt1", "mt2", "mt5", "foot", "ankle", "ank", "cal", "calc", "ball")
FOOT_ROLES = ("ankle", "toe")
NARROWEST_M = 1.0  # what the standing feet must span in a direction for a tilt along it to be told
ABOVE_M = 0.015  # over the plane: farther, a point does not stand on it
ROUNDS = 30
LOWEST = 0.2  # share of a point's standing moments that are on the floor for certain
MOST_MOMENTS = 1500  # that tell the plane, evenly spread over those of each point
FEWEST = 10  # moments at which a point of a foot stands, at least
STEEPEST = np.radians(30)


@dataclass(frozen=True)
class Floor:
    """A plane under the feet.

    Parameters
    ----------
    height : float
        Where it cuts the vertical axis, metres: the height of the lowest point of the feet when it stands.
    slopes : tuple of float
        How much it rises along x and along z, metres a metre.
    moments : int
        Standing points that told it.
    share : float
        Of all moments at which a point of the feet was slow, those.
    blind : int
        In how many of the two directions of the plane nothing told the tilt, which is then taken to be none.
    """

    height: float
    slopes: tuple[float, float]
    moments: int
    share: float
    blind: int

    @property
    def tilt(self) -> float:
        """How far it is from level, radians."""
        return float(np.arctan(np.hypot(*self.slopes)))


def find_floor(
    recording: Recording, body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None
) -> Floor:
    """Find the floor that a person stands on.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames, metres, Y up.
    body_map : BodyMap or mapping of str, optional
        Which joints or points stand for which role; by default what the names say.

    Returns
    -------
    Floor
        The plane.

    Raises
    ------
    DataError
        When it is not in metres or space, has no feet, or they never stand.
    """
    recording = need_recording(recording, "Finding the floor")
    feet = _feet(recording, body_map)
    frames, count = feet.shape[:2]
    if frames < 3:
        raise DataError("The floor is told by feet that stand, and the recording is too short for that.")
    speed = np.linalg.norm(feet[2:] - feet[:-2], axis=2) * recording.rate / 2
    with np.errstate(invalid="ignore"):
        standing = (speed < STANDING_MPS) & np.isfinite(feet[1:-1]).all(axis=2)
    middle = feet[1:-1]
    kinds = [k for k in range(count) if standing[:, k].sum() >= FEWEST]
    if not kinds:
        raise DataError(
            f"The floor of {recording.name or 'the recording'} cannot be told: no foot ever stands still."
        )
    points = np.concatenate([middle[standing[:, k], k] for k in kinds])
    which = np.concatenate([np.full(int(standing[:, k].sum()), place) for place, k in enumerate(kinds)])
    return _fit(points, which, len(kinds))


def level_floor(
    recording: Recording, *, body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None
) -> Repaired:
    """Turn and shift a recording so that its floor is level and at height 0.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames, metres, Y up.
    body_map : BodyMap or mapping of str, optional
        Which joints or points stand for which role; by default what the names say.

    Returns
    -------
    Repaired
        The recording, turned about the origin and shifted along the vertical, with a change "level" that tells the
        tilt in degrees and the shift in metres. A remark says where the feet did not tell the tilt.

    Raises
    ------
    DataError
        When the floor cannot be told, or rises by more than 30 degrees.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0).motion
    >>> raised = session.replace(local_positions=session.local_positions + [0, 0.5, 0] * (
    ...     np.arange(len(session.skeleton)) == 0)[:, None])
    >>> mended = level_floor(raised)
    >>> mended.changes[0].what, abs(find_floor(mended.recording).height) < 1e-3
    ('level', True)
    """
    recording = need_recording(recording, "Levelling")
    floor = find_floor(recording, body_map)
    if floor.tilt > STEEPEST:
        raise DataError(
            f"The floor rises by {np.degrees(floor.tilt):.0f} degrees: that is no floor.",
            remedy="Say with --up which axis is up.",
        )
    normal = np.array([-floor.slopes[0], 1.0, -floor.slopes[1]])
    normal /= np.linalg.norm(normal)
    turn = _turn_to_vertical(normal)
    shift = np.array([0.0, -floor.height * normal[1], 0.0])  # after turning about the origin
    detail = f"tilt of {np.degrees(floor.tilt):.2f} degrees taken out, moved by {shift[1]:+.3f} m"
    change = Change("level", "", 0, len(recording), detail)
    blind = (
        "",
        "along one direction the feet stand too close together to tell a tilt: taken as none.",
        "the feet stand too close together to tell a tilt: only the height was mended.",
    )[floor.blind]
    remarks = (blind[0].upper() + blind[1:],) if blind else ()
    if isinstance(recording, Trajectories):
        return Repaired(
            recording.replace(positions=rotations.rotate(turn, recording.positions) + shift),
            (change,),
            remarks,
        )
    roots = np.flatnonzero(recording.skeleton.parents < 0)
    places, turns = recording.local_positions.copy(), recording.local_rotations.copy()
    places[:, roots] = rotations.rotate(turn, places[:, roots]) + shift
    turns[:, roots] = rotations.multiply(np.broadcast_to(turn, turns[:, roots].shape), turns[:, roots])
    return Repaired(recording.replace(local_positions=places, local_rotations=turns), (change,), remarks)


def _fit(points: np.ndarray, which: np.ndarray, kinds: int) -> Floor:
    """Fit y = slope . (x, z) + offset of each kind, along the directions in which what lies on it tells the slope."""
    keep = _spread(which, kinds)
    points, which = points[keep], which[keep]
    heights, centre = points[:, 1], points[:, [0, 2]].mean(axis=0)
    flat = points[:, [0, 2]] - centre
    axes, spans = _directions(flat, which, kinds)
    axes = axes[spans >= NARROWEST_M]
    while True:
        solution, kept = _plane(flat @ axes.T, heights, which, kinds)
        spans = _spans(flat[kept] @ axes.T, which[kept], kinds)
        if (spans >= NARROWEST_M).all():
            break
        axes = axes[spans >= NARROWEST_M]
    slopes = solution[: len(axes)] @ axes if len(axes) else np.zeros(2)
    height = float(solution[len(axes) :].min() - slopes @ centre)
    slope = (float(slopes[0]), float(slopes[1]))
    return Floor(height, slope, int(kept.sum()), float(kept.mean()), 2 - len(axes))


def _spread(which: np.ndarray, kinds: int) -> np.ndarray:
    """Moments evenly spread over those of each kind, so many that none is left without any."""
    step = max(1, len(which) // MOST_MOMENTS)
    own = [np.flatnonzero(which == k) for k in range(kinds)]
    return np.concatenate([moments[:: max(1, min(step, len(moments) // FEWEST))] for moments in own])


def _directions(flat: np.ndarray, which: np.ndarray, kinds: int) -> tuple[np.ndarray, np.ndarray]:
    """The directions in which single points of the feet get about most and least, and how far they do."""
    own = np.concatenate([flat[which == k] - flat[which == k].mean(axis=0) for k in range(kinds)])
    axes = np.linalg.svd(own, full_matrices=False)[2] if len(own) > 1 else np.eye(2)
    return axes, _spans(flat @ axes.T, which, kinds)


def _spans(along: np.ndarray, which: np.ndarray, kinds: int) -> np.ndarray:
    """How far the one point of the feet that gets about most does so, in each direction."""
    widths = [np.ptp(along[which == k], axis=0) for k in range(kinds) if (which == k).any()]
    return np.max([*widths, np.zeros(along.shape[1])], axis=0)


def _plane(
    along: np.ndarray, heights: np.ndarray, which: np.ndarray, kinds: int
) -> tuple[np.ndarray, np.ndarray]:
    """Slopes and levels, least squares over what lies near the plane, and which points those are."""
    solution = _start(along, heights, which, kinds)
    design = np.concatenate((along, np.eye(kinds)[which]), axis=1)
    kept = np.zeros(len(heights), dtype=bool)
    for _ in range(ROUNDS):
        now = _near(heights - design @ solution, which, kinds)
        if (now == kept).all():
            break
        kept = now
        solution = np.linalg.lstsq(design[kept], heights[kept], rcond=None)[0]
    return solution, kept


def _start(along: np.ndarray, heights: np.ndarray, which: np.ndarray, kinds: int) -> np.ndarray:
    """The slopes, of a grid, under which the most points lie on one level, and the level of each kind.

    A point below the floor counts against it twice: feet may be held in the air, but not under the ground.
    """
    grid = np.tan(np.radians(np.arange(-30.0, 31.0, 2.5)))
    slopes = np.array(list(itertools.product(grid, repeat=along.shape[1])))
    slopes = slopes[np.argsort((slopes**2).sum(axis=1), kind="stable")]  # the most level of equals
    score = np.zeros(len(slopes))
    levels = np.zeros((len(slopes), kinds))
    for k in range(kinds):
        off = heights[which == k] - slopes @ along[which == k].T
        levels[:, k] = np.quantile(off, LOWEST, axis=1)
        off -= levels[:, k : k + 1]
        score += np.count_nonzero(np.abs(off) <= 2 * ABOVE_M, axis=1)
        score -= 2 * np.count_nonzero(off < -2 * ABOVE_M, axis=1)
    best = int(score.argmax())
    return np.concatenate((slopes[best], levels[best]))


def _near(off: np.ndarray, which: np.ndarray, kinds: int) -> np.ndarray:
    """Points that lie on the plane; of a kind that never does its lowest."""
    near: np.ndarray = np.abs(off) <= ABOVE_M
    for k in range(kinds):
        if np.count_nonzero(near[which == k]) < 3:
            near |= (which == k) & (off <= np.quantile(off[which == k], LOWEST))
    return near


def _feet(recording: Recording, body_map: BodyMap | Mapping[str, str | Sequence[str]] | None) -> np.ndarray:
    """Every point of the feet, (T, K, 3)."""
    if isinstance(recording, Trajectories) and (recording.unit != "m" or recording.positions.shape[2] != 3):
        raise DataError("A floor is found in metres and in space; these points are not in both.")
    body_map = map_of(recording, body_map)
    members = dict(zip(body_map.roles, body_map.members, strict=True))
    named = [
        name
        for role in FOOT_ROLES
        for side in ("left", "right")
        for name in members.get(f"{side}_{role}", ())
    ]
    if isinstance(recording, Trajectories):
        named += [
            name
            for name, said in zip(recording.names, parse_names(recording.names), strict=True)
            if said.side and said.word.startswith(FOOT_WORDS)
        ]
        places = [recording.names.index(name) for name in dict.fromkeys(named)]
        feet = recording.positions[:, places]
    else:
        skeleton, pose = recording.skeleton, forward_kinematics(recording)
        joints = [skeleton.index(name) for name in dict.fromkeys(named)]
        tips = np.isin(skeleton.end_parents, joints)
        feet = np.concatenate(
            (pose.positions[:, joints], end_site_positions(recording, pose)[:, tips]), axis=1
        )
    if not feet.shape[1]:
        raise DataError(
            f"The floor of {recording.name or 'the recording'} cannot be told: no ankle or toe is known.",
            remedy="Name them in a map file: --map roles.json (body_map= in Python).",
        )
    return feet


def _turn_to_vertical(normal: np.ndarray) -> np.ndarray:
    """The shortest turn that brings a direction to the vertical."""
    turn = np.array([1.0 + normal[1], -normal[2], 0.0, normal[0]])
    return turn / np.linalg.norm(turn)
