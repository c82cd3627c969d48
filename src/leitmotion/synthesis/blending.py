"""Blending: pieces of motion joined end to end, each placed and turned so that it goes on where the last one was.

Conventions
-----------
Neighbouring pieces share a *seam* of L frames: the last L of one are played together with the first L of the next,
with weights that pass from one to the other. The next piece is placed on the floor and turned about the vertical
first; heights stay as they are.

References
----------
Kovar, Gleicher, Pighin, "Motion graphs", ACM Transactions on Graphics 21(3), 2002, section 3: two clouds of points
laid over one another by a turn about the vertical and a shift on the floor, in closed form; blending of postures.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.motion import Motion, ParameterError, Trajectories, forward_kinematics
from leitmotion.motion.rotations import conjugate, continuous, multiply, normalize, rotate, yaw_rotation
from leitmotion.synthesis.footing import Leg, hold_feet

Recording = Motion | Trajectories

LOW = 0.15  # of the body's extent: points below this height are feet on the floor
HOLD = 4.0  # how much more such a point counts: feet should not slide
STATIC = 1e-6  # metres, and parts of a quaternion
OPPOSED = -0.9999  # rotations that are nearly a full turn apart have no direction of their own


class Placement(NamedTuple):
    """How a piece is turned about the vertical and shifted on the floor."""

    yaw: float
    x: float
    z: float


class Joined(NamedTuple):
    """Pieces joined, and the frame at which each of them begins."""

    recording: Recording
    starts: tuple[int, ...]


def join(pieces: Sequence[Recording], seams: Sequence[int], legs: tuple[Leg, ...] = ()) -> Joined:
    """Join pieces of one person into one recording.

    Within a seam local rotations turn along the shorter way and places go straight, by the smooth weight 3t² − 2t³. So
    bones keep their lengths, and outside of the seams each piece is as it was but for its place and direction.
    A point is unseen in a seam where either piece lacks it.

    Parameters
    ----------
    pieces : sequence of Motion, or of Trajectories
        At least one; of one skeleton or of the same points, at one rate.
    seams : sequence of int
        For each two neighbours the frames that they share; 0 puts them one after the other.
    legs : tuple of Leg
        Of a Motion: legs whose feet keep standing in a seam (:func:`leitmotion.synthesis.footing.hold_feet`).

    Returns
    -------
    Joined
        ``recording`` of sum(len(pieces)) − sum(seams) frames, which begins where the first piece does, and ``starts``.

    Raises
    ------
    ParameterError
        When the pieces are of different kind, skeleton, points or rate, or the seams of a piece are longer than it.

    Examples
    --------
    >>> import numpy as np
    >>> way = np.zeros((20, 1, 3))
    >>> way[:, 0, 2] = np.arange(20) / 10
    >>> walk = Trajectories(("hip",), way, rate=10)
    >>> joined = join([walk[:12], walk[4:]], [8])
    >>> joined.starts, bool(np.allclose(joined.recording.positions, way))
    ((0, 4), True)
    """
    _check(pieces, seams)
    carriers = _carriers(pieces)
    held = [pieces[0]]
    starts = [0]
    for piece, seam in zip(pieces[1:], seams, strict=True):
        before = held.pop()
        to = Placement(0.0, 0.0, 0.0)
        if seam:
            to = placement(_points(before[len(before) - seam :], carriers), _points(piece[:seam], carriers))
        placed = _placed(piece, to, carriers)
        starts.append(starts[-1] + len(before) - seam)
        if seam:
            mixed = _mixed(before[len(before) - seam :], placed[:seam], legs)
            placed = _after_one_another([mixed, placed[seam:]]) if seam < len(placed) else mixed
        # what comes before the seam is settled; the rest may still be part of the next one
        held += [*([before[: len(before) - seam]] if seam < len(before) else []), placed]
    return Joined(_after_one_another(held), tuple(starts))


def placement(a: np.ndarray, b: np.ndarray) -> Placement:
    """Find the turn and the shift that lay points `b` over points `a`, frame by frame, in the least squares sense.

    Points near the floor in both count five times, so that feet that stand keep standing.

    Parameters
    ----------
    a, b : (L, P, C) float
        Points in the world, NaN where unseen; of points in a picture (C = 2) only the shift along x is found.

    Returns
    -------
    Placement
        No turn and no shift where no frame shows a point of both.
    """
    weights = np.where(np.isfinite(a).all(axis=2) & np.isfinite(b).all(axis=2), 1.0, 0.0)
    if not weights.any():
        return Placement(0.0, 0.0, 0.0)
    a, b = np.nan_to_num(a), np.nan_to_num(b)
    if a.shape[2] == 2:
        return Placement(0.0, float(np.average((a - b)[..., 0], weights=weights)), 0.0)
    weights *= 1.0 + HOLD * _lowness(a, weights) * _lowness(b, weights)
    total = weights.sum()
    # z + ix, so that a turn by the yaw is a product with exp(i yaw)
    at, bt = a[..., 2] + 1j * a[..., 0], b[..., 2] + 1j * b[..., 0]
    middle_a, middle_b = (weights * at).sum() / total, (weights * bt).sum() / total
    yaw = float(np.angle((weights * np.conj(bt - middle_b) * (at - middle_a)).sum()))
    shift = middle_a - np.exp(1j * yaw) * middle_b
    return Placement(yaw, float(shift.imag), float(shift.real))


def apart(before: Recording, after: Recording) -> float:
    """Tell how far the postures of two pieces are apart once placed, as a share of the body's extent.

    Parameters
    ----------
    before, after : Motion or Trajectories
        As many frames of each, of one skeleton or of the same points.

    Returns
    -------
    float
        Of the point that is farthest, the median over the frames; 0 where nothing is seen in both.
    """
    carriers = _carriers([before, after])
    a = _points(before, carriers)
    b = _points(_placed(after, placement(a, _points(after, carriers)), carriers), carriers)
    distances = np.linalg.norm(a - b, axis=2)
    extent = _extent(np.concatenate((a, b)))
    seen = np.isfinite(distances).any(axis=1)
    if not seen.any() or extent == 0:
        return 0.0
    return float(np.median(np.nanmax(distances[seen], axis=1))) / extent


def smooth_weights(count: int) -> np.ndarray:
    """Weights that pass smoothly from 0 to 1 in `count` frames, neither end among them: 3t² − 2t³."""
    t = np.arange(1, count + 1) / (count + 1)
    return t * t * (3.0 - 2.0 * t)


def _mixed(a: Recording, b: Recording, legs: tuple[Leg, ...]) -> Recording:
    w = smooth_weights(len(a))[:, None, None]
    if isinstance(a, Motion) and isinstance(b, Motion):
        mixed = a.replace(
            local_positions=a.local_positions + w * (b.local_positions - a.local_positions),
            local_rotations=_turned(a.local_rotations, b.local_rotations, w),
        )
        return hold_feet(mixed, a, b, legs) if legs else mixed
    return _mixed_points(a, b, w)  # type: ignore[arg-type]  # the pieces were checked to be of one kind


def _mixed_points(a: Trajectories, b: Trajectories, w: np.ndarray) -> Trajectories:
    sure = None
    if a.confidence is not None and b.confidence is not None:
        sure = np.clip(a.confidence + w[..., 0] * (b.confidence - a.confidence), 0.0, 1.0)
    return a.replace(positions=a.positions + w * (b.positions - a.positions), confidence=sure)


def _turned(a: np.ndarray, b: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Spherical interpolation whose way round is chosen once for the seam, so that it never flips within it."""
    a, b = continuous(a), continuous(b)
    dot = np.einsum("tjc,tjc->tj", a, b)
    sign = np.where(dot.sum(axis=0) < 0, -1.0, 1.0) * np.ones_like(dot)
    sign = np.where(sign * dot < OPPOSED, -sign, sign)
    dot, b = np.clip(sign * dot, -1.0, 1.0)[..., None], sign[..., None] * b
    angle = np.arccos(dot)
    sine = np.sin(angle)
    near = sine < 1e-6
    safe = np.where(near, 1.0, sine)
    left = np.where(near, 1.0 - w, np.sin((1.0 - w) * angle) / safe)
    right = np.where(near, w, np.sin(w * angle) / safe)
    return normalize(left * a + right * b)


def _placed(piece: Recording, to: Placement, carriers: Sequence[int]) -> Recording:
    if to == Placement(0.0, 0.0, 0.0):
        return piece
    shift, turn = np.array([to.x, 0.0, to.z]), yaw_rotation(np.array(to.yaw))
    if isinstance(piece, Trajectories):
        if piece.positions.shape[2] == 2:
            return piece.replace(positions=piece.positions + shift[:2])
        return piece.replace(positions=rotate(turn, piece.positions) + shift)
    positions, rotations = piece.local_positions.copy(), piece.local_rotations.copy()
    pose = forward_kinematics(piece[:1])
    for joint in carriers:
        parent = int(piece.skeleton.parents[joint])
        # what a carrier hangs on never moves: one frame tells how it stands
        base_p = pose.positions[0, parent] if parent >= 0 else np.zeros(3)
        base_q = pose.rotations[0, parent] if parent >= 0 else np.array([1.0, 0.0, 0.0, 0.0])
        world = rotate(turn, base_p + rotate(base_q, positions[:, joint])) + shift
        positions[:, joint] = rotate(conjugate(base_q), world - base_p)
        whole = multiply(conjugate(base_q), multiply(turn, base_q))
        rotations[:, joint] = normalize(multiply(whole, rotations[:, joint]))
    return piece.replace(local_positions=positions, local_rotations=rotations)


def _carriers(pieces: Sequence[Recording]) -> tuple[int, ...]:
    """The joints by which the body moves about: the roots, or of a root that never moves its descendants that do."""
    motions = [piece for piece in pieces if isinstance(piece, Motion)]
    if not motions:
        return ()  # points have no parents
    first = motions[0]
    still = np.ones(len(first.skeleton), dtype=bool)
    for piece in motions:
        for name in ("local_positions", "local_rotations"):
            values = getattr(piece, name)
            still &= (np.abs(values - getattr(first, name)[0]) < STATIC).all(axis=(0, 2))
    parents = first.skeleton.parents
    fixed = np.zeros(len(parents), dtype=bool)
    carriers = []
    for joint, parent in enumerate(parents.tolist()):
        if parent < 0 or fixed[parent]:
            fixed[joint] = still[joint]
            if not still[joint]:
                carriers.append(joint)
    return tuple(carriers) or tuple(np.flatnonzero(parents < 0).tolist())


def _points(piece: Recording, carriers: Sequence[int]) -> np.ndarray:
    """What moves with the body, in the world: (L, P, C)."""
    if isinstance(piece, Trajectories):
        return piece.positions
    moving = np.zeros(len(piece.skeleton), dtype=bool)
    for joint, parent in enumerate(piece.skeleton.parents.tolist()):
        moving[joint] = joint in carriers or (parent >= 0 and moving[parent])
    return forward_kinematics(piece).positions[:, moving]


def _lowness(points: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """1 of a point at the height of the lowest, 0 from 15 % of the body's extent on, (L, P)."""
    height = np.where(weights > 0, points[..., 1], np.nan)
    extent = _extent(np.where(weights[..., None] > 0, points, np.nan))
    if extent == 0:
        return np.zeros_like(height)
    return np.nan_to_num(np.clip(1.0 - (height - np.nanmin(height)) / (LOW * extent), 0.0, 1.0))


def _extent(points: np.ndarray) -> float:
    """How large the body is as it is held: twice the way from its middle to the farthest point, median over frames."""
    seen = points[np.isfinite(points).all(axis=2).any(axis=1)]
    if not len(seen):
        return 0.0
    away = np.linalg.norm(seen - np.nanmean(seen, axis=1, keepdims=True), axis=2)
    return float(2 * np.median(np.nanmax(away, axis=1)))


def _after_one_another(pieces: Sequence[Recording]) -> Recording:
    def along(field: str) -> np.ndarray:
        return np.concatenate([getattr(piece, field) for piece in pieces])

    first = pieces[0]
    if isinstance(first, Motion):
        return first.replace(
            local_positions=along("local_positions"), local_rotations=continuous(along("local_rotations"))
        )
    sure = None if first.confidence is None else along("confidence")
    return first.replace(positions=along("positions"), confidence=sure)


def _check(pieces: Sequence[Recording], seams: Sequence[int]) -> None:
    if not pieces or len(seams) != len(pieces) - 1:
        raise ParameterError(
            f"Pieces are joined by one seam fewer than there are, got {len(pieces)} and {len(seams)}."
        )
    first = pieces[0]
    of = "skeleton" if isinstance(first, Motion) else "names"
    for piece in pieces[1:]:
        if type(piece) is not type(first) or getattr(piece, of) != getattr(first, of):
            raise ParameterError("Pieces that are joined must have one skeleton, or the same points.")
        if piece.rate != first.rate:
            raise ParameterError(
                f"Pieces that are joined must have one rate, got {first.rate:g} and {piece.rate:g} Hz."
            )
    around = [0, *seams, 0]
    for k, piece in enumerate(pieces):
        if min(around) < 0 or around[k] + around[k + 1] > len(piece):
            raise ParameterError(
                f"The seams of a piece must fit into it, got {around[k]} and {around[k + 1]} of {len(piece)} frames."
            )
