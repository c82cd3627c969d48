"""From a file's unit and axes to the house's: metres, Y up, right-handed.

What the format states is taken; what the caller states overrules it; what nobody states is judged from the body:
the unit from its size, the vertical from where the head and the feet are.
"""

from __future__ import annotations

import numpy as np

from leitmotion.io.reading import Draft, Finding, Options, PointTake, SkeletonTake
from leitmotion.motion import Motion, ParameterError, Skeleton, Trajectories, forward_kinematics

METRES = {
    "m": 1.0,
    "cm": 0.01,
    "mm": 0.001,
    "dm": 0.1,
    "inch": 0.0254,
    "ft": 0.3048,
    "1/0.45 inch": 0.0254 / 0.45,
}
"""Length of each unit in metres."""

_SPELLINGS = {
    "meter": "m", "meters": "m", "metre": "m", "metres": "m", "centimeters": "cm", "centimetres": "cm",
    "millimeters": "mm", "millimetres": "mm", "in": "inch", "inches": "inch", "feet": "ft", "foot": "ft",
    "cmu": "1/0.45 inch",
}  # fmt: skip
_CANDIDATES = ("m", "cm", "mm", "inch", "1/0.45 inch")
_ADULT = 1.7  # metres, a standing adult
_LOOKS = 32  # frames looked at to judge a recording

_HIGH = ("head", "fhd", "bhd", "neck", "c7", "clav", "shoulder", "sho", "acro", "chest", "thorax", "ster")
_LOW = ("foot", "feet", "toe", "ankle", "heel", "ank", "hee", "mt1", "mt2", "mt5", "shank", "tibia", "knee")

_TO_Y_UP = {
    "y": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "z": ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    "x": ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    "-y": ((1, 0, 0), (0, -1, 0), (0, 0, -1)),
    "-z": ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    "-x": ((0, 1, 0), (-1, 0, 0), (0, 0, 1)),
}
"""For each vertical the turn that brings it to +Y; with Z up, facing -Y becomes facing +Z."""


def unit_in_metres(unit: str | float) -> tuple[str, float]:
    """Name a unit and tell its length in metres.

    Parameters
    ----------
    unit : str or float
        A name such as "cm", or a number of metres.

    Returns
    -------
    tuple of str and float
        The name as the house spells it, the length in metres.

    Raises
    ------
    ParameterError
        When the name is unknown or the number is not positive.
    """
    if isinstance(unit, str):
        word = unit.strip().lower()
        word = _SPELLINGS.get(word, word)
        if word in METRES:
            return word, METRES[word]
        try:
            unit = float(word)
        except ValueError:
            raise ParameterError(
                f"The unit must be one of {', '.join(METRES)} or a number of metres, got {unit!r}."
            ) from None
    if not (np.isfinite(unit) and unit > 0):
        raise ParameterError(f"The unit must be a positive number of metres, got {unit}.")
    return f"{unit:g} m", float(unit)


def conform(
    draft: Draft, options: Options, name: str
) -> tuple[list[Motion | Trajectories], dict[str, Finding]]:
    """Bring a draft to the house's unit and axes.

    Parameters
    ----------
    draft : Draft
        What the reader found.
    options : Options
        What the caller said.
    name : str
        What the recording is called.

    Returns
    -------
    tuple
        The nouns, one a person, and the findings "unit", "up", "rate" and the reader's own.
    """
    looks = [_look(take) for take in draft.takes]
    names = draft.takes[0].names
    rate = _given(options.rate, "rate") or draft.rate
    up = _given(options.up, "up") or draft.up or _judge_up(looks[0], names, draft.takes[0])
    turn = _turn_to_y_up(up.value, looks[0].shape[-1])
    findings = {"up": up, "rate": rate}
    if options.unit is not None and options.unit not in ("px", "relative"):
        word, metres = unit_in_metres(options.unit)
        findings["unit"] = Finding(word, "given", "unit given by the caller")
    else:
        unit = (
            draft.unit if options.unit is None else Finding(options.unit, "given", "unit given by the caller")
        )
        findings["unit"] = unit = unit or _judge_unit(looks)
        metres = METRES.get(unit.value, 1.0)
    word = findings["unit"].value
    kind = word if word in ("px", "relative") else "m"
    people = len(draft.takes) > 1
    nouns: list[Motion | Trajectories] = []
    for take in draft.takes:
        called = f"{name}:{take.person}" if people else name
        if isinstance(take, SkeletonTake):
            nouns.append(_motion(take, metres, turn, float(rate.value), called))
        else:
            nouns.append(_trajectories(take, metres, turn, kind, float(rate.value), called))
    findings.update(draft.findings)
    if isinstance(draft.takes[0], SkeletonTake):
        side = _judge_sides(nouns[0])  # type: ignore[arg-type]
        if side:
            findings["handedness"] = side
            if side.value == "left":
                draft.warnings.append(f"The sides look swapped: {side.reason}.")
    return nouns, findings


def _motion(take: SkeletonTake, metres: float, turn: np.ndarray, rate: float, name: str) -> Motion:
    offsets, ends, positions, quaternions = take.offsets, take.end_offsets, take.positions, take.rotations
    if metres != 1.0:
        offsets, ends, positions = offsets * metres, ends * metres, positions * metres
    if not np.array_equal(turn, np.eye(3)):
        # a change of basis for every joint: the rest pose stands upright in the new axes as well
        offsets, ends, positions = offsets @ turn.T, ends @ turn.T, positions @ turn.T
        axis = quaternions[..., 1:] @ turn.T
        quaternions = np.concatenate((quaternions[..., :1], axis), axis=-1)
    skeleton = Skeleton(tuple(take.names), take.parents, offsets, take.end_parents, ends)
    return Motion(skeleton, positions, quaternions, rate, name)


def _trajectories(
    take: PointTake, metres: float, turn: np.ndarray, unit: str, rate: float, name: str
) -> Trajectories:
    positions = take.positions if metres == 1.0 else take.positions * metres
    if not np.array_equal(turn, np.eye(len(turn))):
        positions = positions @ turn.T
    return Trajectories(tuple(take.names), positions, rate, unit, take.kind, take.confidence, name)


def _given(value: object, what: str) -> Finding | None:
    if value is None:
        return None
    if what == "up" and value not in _TO_Y_UP:
        raise ParameterError(f"up must be one of {', '.join(_TO_Y_UP)}, got {value!r}.")
    if what == "rate" and not (isinstance(value, (int, float)) and np.isfinite(value) and value > 0):
        raise ParameterError(f"rate must be a positive number of hertz, got {value!r}.")
    return Finding(value, "given", f"{what} given by the caller")


def _turn_to_y_up(up: str, components: int) -> np.ndarray:
    if components == 2:
        return np.diag([1.0, -1.0 if up == "-y" else 1.0])
    return np.array(_TO_Y_UP[up], dtype=np.float64)


def _look(take: SkeletonTake | PointTake) -> np.ndarray:
    """Global positions of a person's points in a few frames spread over the recording, in the file's unit."""
    frames = len(take.positions)
    chosen = np.unique(np.linspace(0, frames - 1, min(frames, _LOOKS)).astype(int))
    if isinstance(take, PointTake):
        return take.positions[chosen]
    skeleton = Skeleton(tuple(take.names), take.parents, take.offsets)
    return forward_kinematics(Motion(skeleton, take.positions[chosen], take.rotations[chosen], 1.0)).positions


def _judge_up(look: np.ndarray, names: list[str], take: SkeletonTake | PointTake) -> Finding:
    """Tell the vertical: from the feet to the head where names tell, else the axis along which the body is tall."""
    axes = "xyz"[: look.shape[-1]]
    words = [name.lower() for name in names]
    high = [k for k, word in enumerate(words) if any(h in word for h in _HIGH)]
    low = [k for k, word in enumerate(words) if any(h in word for h in _LOW)]
    if high and low:
        rise = _median(_mean(look[:, high]) - _mean(look[:, low]))
        size = np.linalg.norm(rise)
        axis = int(np.argmax(np.abs(rise)))
        if size > 0 and np.abs(rise[axis]) > 0.8 * size:
            return Finding(
                ("-" if rise[axis] < 0 else "") + axes[axis], "guessed", "the head is above the feet along it"
            )
        if isinstance(take, SkeletonTake):
            rest = _rest(take)
            rise = rest[high].mean(axis=0) - rest[low].mean(axis=0)
            axis = int(np.argmax(np.abs(rise)))
            if np.abs(rise[axis]) > 0.8 * max(np.linalg.norm(rise), 1e-9):
                return Finding(
                    ("-" if rise[axis] < 0 else "") + axes[axis],
                    "guessed",
                    "the head is above the feet along it in the rest pose",
                )
    spread = _median(_reach(look))
    axis = int(np.argmax(spread))
    second = np.partition(spread, -2)[-2] if spread.size > 1 else 0.0
    if spread[axis] > 1.2 * second:
        return Finding(axes[axis], "guessed", "the body is longest along it")
    return Finding("y", "guessed", "nothing in the file tells, and Y is the usual vertical")


def _judge_unit(looks: list[np.ndarray]) -> Finding:
    """Tell the unit from the body's size: the largest distance between two of its points, in the median frame."""
    size = max(_size(look) for look in looks)
    if size == 0:
        return Finding("m", "guessed", "the body has no size to judge a unit by")
    unit = min(_CANDIDATES, key=lambda word: abs(np.log(size * METRES[word] / _ADULT)))
    return Finding(unit, "guessed", f"with it the body measures {size * METRES[unit]:.2f} m")


def _size(look: np.ndarray) -> float:
    sizes = []
    for points in look:
        seen = points[np.isfinite(points).all(axis=1)]
        if len(seen) > 1:
            sizes.append(np.linalg.norm(seen[:, None] - seen[None], axis=-1).max())
    return float(np.median(sizes)) if sizes else 0.0


def _judge_sides(motion: Motion) -> Finding | None:
    """Tell whether left is left: left, up and forward (heel to toe) must make a right-handed frame at rest."""
    words = [name.lower() for name in motion.skeleton.names]
    knees = [_find(words, side, ("knee", "leg", "tibia", "shin")) for side in ("left", "right")]
    feet = [(_find(words, s, ("foot", "ankle")), _find(words, s, ("toe",))) for s in ("left", "right")]
    if None in knees or any(None in pair for pair in feet):
        return None
    pose = forward_kinematics(motion[:: max(1, len(motion) // _LOOKS)]).positions
    left = pose[:, knees[0]] - pose[:, knees[1]]
    forward = np.mean([pose[:, toe] - pose[:, foot] for foot, toe in feet], axis=0)
    turn = left[:, 2] * forward[:, 0] - left[:, 0] * forward[:, 2]
    votes = -np.sign(turn).mean()
    if abs(votes) < 0.5:
        return None
    if votes > 0:
        return Finding("right", "guessed", "the left knee is on the left of where the toes point")
    return Finding("left", "guessed", "the knee named left is on the right of where the toes point")


def _find(words: list[str], side: str, parts: tuple[str, ...]) -> int | None:
    for part in parts:
        for k, word in enumerate(words):
            if part in word and "up" not in word:
                bare = word.replace(part, "", 1)
                if side in bare or bare.strip("_.: ") == side[0]:
                    return k
    return None


def _rest(take: SkeletonTake) -> np.ndarray:
    rest = np.array(take.offsets)
    for joint, parent in enumerate(take.parents):
        if parent >= 0:
            rest[joint] += rest[parent]
    return rest


def _mean(points: np.ndarray) -> np.ndarray:
    """Mean over points of (T, P, C), without those unseen; NaN where none is seen."""
    seen = np.isfinite(points).all(axis=-1, keepdims=True)
    count = seen.sum(axis=1)
    total = np.where(seen, points, 0.0).sum(axis=1)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _reach(look: np.ndarray) -> np.ndarray:
    seen = np.isfinite(look)
    return np.where(seen, look, -np.inf).max(axis=1) - np.where(seen, look, np.inf).min(axis=1)


def _median(rows: np.ndarray) -> np.ndarray:
    rows = rows[np.isfinite(rows).all(axis=1)]
    return np.median(rows, axis=0) if len(rows) else np.zeros(rows.shape[1])
