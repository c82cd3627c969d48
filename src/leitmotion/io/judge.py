"""What a file does not say, judged from the body in it: the unit and the vertical.

Every judgement is a :class:`~leitmotion.io.reading.Finding` that is "guessed" and says why.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from leitmotion.io.reading import Finding, PointTake, SkeletonTake
from leitmotion.io.units import METRES
from leitmotion.motion import Motion, Skeleton, forward_kinematics

_METRIC = ("m", "cm", "mm")
_OTHERS = ("inch", "1/0.45 inch")
_STANDING = 1.7  # metres, the largest distance between two points of a standing adult
_ANKLE_TO_HEAD = 1.5  # metres, along the joints, of an adult
_USUAL = 1.35  # by which factor a body may differ from the usual one without a word
_TOY = 20.0  # by which factor the body of a stated unit may differ from the usual one without a word
_FEWEST = 8  # points by which a body's size contradicts a stated unit
_SMALLEST = 0.25  # share of the usual size that the smallest of people, half a metre tall, still has
_MIDDLE = 0.63  # share of the usual size about which people of all ages lie within a decade
_LOOKS = 32  # frames looked at
_MANY = 200  # points of which every pair is looked at
_STEADY = 0.08  # how far, of the body's size, the lowest point may wander on a ground
_GROUND = 0.2  # how far, of the body's size, a ground may lie from zero
_UPRIGHT = 0.8  # share of the way from feet to head that must lie along one axis

_HIGH = (
    "head",
    "nose",
    "fhd",
    "bhd",
    "neck",
    "c7",
    "clav",
    "shoulder",
    "sho",
    "acro",
    "chest",
    "thorax",
    "ster",
)
_LOW = (
    "foot",
    "feet",
    "toe",
    "ankle",
    "heel",
    "ank",
    "hee",
    "mt1",
    "mt2",
    "mt5",
    "shank",
    "tibia",
    "knee",
    "hip",
    "asi",
    "psi",
    "sacr",
)


def look(take: SkeletonTake | PointTake) -> np.ndarray:
    """Place a person's points in a few frames spread over the recording.

    Parameters
    ----------
    take : SkeletonTake or PointTake
        One person.

    Returns
    -------
    (L, P, C) float
        Global positions in the file's unit and axes, NaN where unseen.
    """
    frames = len(take.positions)
    chosen = np.unique(np.linspace(0, frames - 1, min(frames, _LOOKS)).astype(int))
    if isinstance(take, PointTake):
        return take.positions[chosen]
    skeleton = Skeleton(tuple(take.names), take.parents, take.offsets)
    motion = Motion(skeleton, take.positions[chosen], take.rotations[chosen], rate=1.0)
    return forward_kinematics(motion).positions


def judge_up(positions: np.ndarray, take: SkeletonTake | PointTake) -> Finding:
    """Tell the vertical: the axis from the feet to the head where names tell, else the body's longest.

    Parameters
    ----------
    positions : (L, P, C) float
        What :func:`look` saw.
    take : SkeletonTake or PointTake
        The person.

    Returns
    -------
    Finding
        An axis, "y" or "-z".
    """
    axes = "xyz"[: positions.shape[-1]]
    words = [name.lower() for name in take.names]
    high = [k for k, word in enumerate(words) if any(part in word for part in _HIGH)]
    low = [k for k, word in enumerate(words) if any(part in word for part in _LOW)]
    if len(axes) == 2:
        rise = _median(_mean(positions[:, high]) - _mean(positions[:, low])) if high and low else np.zeros(2)
        seen = _along(axes, rise)
        if seen.endswith("y"):
            return Finding(seen, "guessed", "the head is above the feet along it")
        return Finding("-y", "guessed", "points in a picture, whose rows count downwards")
    if high and low:
        seen = _along(axes, _median(_mean(positions[:, high]) - _mean(positions[:, low])))
        rest = ""
        if isinstance(take, SkeletonTake):
            bind = _rest(take)
            rest = _along(axes, bind[high].mean(axis=0) - bind[low].mean(axis=0))
        if seen and seen == rest:
            return Finding(seen, "guessed", "the head is above the feet along it")
        # who lies is long along another axis than the vertical; the ground tells them apart
        near = min((seen, rest), key=lambda axis: _wander(axis, positions))
        if isinstance(take, SkeletonTake) and not np.isfinite(_wander(near, positions)):
            near = min(("y", "z") if "z" in axes else ("y",), key=lambda axis: _wander(axis, positions))
        if seen and near != seen and np.isfinite(_wander(near, positions)):
            return Finding(near, "guessed", "the ground lies along it, and the body mostly does not stand")
        if seen or rest:
            where = "" if seen else " in the rest pose"
            return Finding(seen or rest, "guessed", f"the head is above the feet along it{where}")
    spread = _median(_reach(positions))
    longest = int(np.argmax(spread))
    if spread[longest] > 1.2 * np.delete(spread, longest).max():
        return Finding(axes[longest], "guessed", "the body is longest along it")
    return Finding("y", "guessed", "nothing in the file tells, and Y is the usual vertical")


def contradict_up(stated: Finding, positions: np.ndarray) -> Finding | None:
    """Tell whether a stated vertical cannot be: the body is tall along another axis, and there it has a floor.

    A floor is where the lowest point of the body stays while the body moves; who lies has one along the true vertical,
    so that lying does not contradict.

    Parameters
    ----------
    stated : Finding
        What the file says.
    positions : (L, P, 3) float
        What :func:`look` saw.

    Returns
    -------
    Finding or None
        The vertical that fits instead, None where the stated one may stand.
    """
    if positions.shape[-1] != 3 or len(positions) < 8:
        return None
    reach = _median(_reach(positions))
    size = reach.max()
    seen = np.isfinite(positions)
    lowest = np.where(seen, positions, np.inf).min(axis=1)
    highest = np.where(seen, positions, -np.inf).max(axis=1)
    whole = np.isfinite(lowest).all(axis=1)
    if size == 0.0 or whole.sum() < 8:
        return None
    wander = [
        np.ptp(np.percentile(edge[whole], (10, 90), axis=0), axis=0) / size for edge in (lowest, highest)
    ]
    said, tall = "xyz".index(stated.value[-1]), int(np.argmax(reach))
    steady = min(wander[0][tall], wander[1][tall])
    if reach[tall] < 1.8 * reach[said] or steady > 0.05 or min(wander[0][said], wander[1][said]) < 0.1:
        return None
    sign = "-" if wander[1][tall] < wander[0][tall] else ""
    return Finding(
        f"{sign}{'xyz'[tall]}",
        "guessed",
        f"{stated.reason}, but the body is tall along this axis and has its floor there",
    )


def judge_unit(take: SkeletonTake | PointTake, positions: np.ndarray) -> tuple[Finding, str]:
    """Tell the unit from the body's size.

    Of a skeleton whose joints are named, the size is the way along its joints from an ankle to the head; else it is
    the largest distance between two points, in the median frame. A metric unit that makes an adult of usual size comes
    first; inch or the unit of the CMU archive is taken where it does and no metric one; else it is the metric unit in
    which the body is a child, and where there is none whatever comes nearest.

    Parameters
    ----------
    take : SkeletonTake or PointTake
        The person.
    positions : (L, P, C) float
        What :func:`look` saw.

    Returns
    -------
    tuple of Finding and str
        The unit's name; a warning where no usual unit makes a body of a usual size, or where one makes an adult and
        another a child, else empty.
    """
    size, usual, what = _body_size(take, positions)
    if size == 0.0:
        return Finding("m", "guessed", "the body has no size to judge a unit by"), ""

    def off(word: str, middle: float) -> float:
        return float(abs(np.log(size * METRES[word] / middle)))

    unit = metric = min(_METRIC, key=lambda word: off(word, _MIDDLE * usual))
    other = min(_OTHERS, key=lambda word: off(word, usual))
    person = size * METRES[metric] >= _SMALLEST * usual
    warning = ""
    if off(metric, usual) > np.log(_USUAL):
        if off(other, usual) <= np.log(_USUAL):
            unit = other
        elif not person:
            unit = min(_METRIC + _OTHERS, key=lambda word: off(word, usual))
    metres = size * METRES[unit]
    if unit == other and person:
        warning = (
            f"Taken as {unit} the body is an adult's, {metres:.2f} m {what}; taken as {metric} it would be a child's, "
            f"{size * METRES[metric]:.2f} m: state the unit with --unit if sizes matter."
        )
    elif off(unit, usual) > np.log(_USUAL):
        warning = (
            f"No usual unit makes this body of a usual size; taken as {unit} it measures {metres:.2f} m {what}: "
            "state the unit with --unit if sizes matter."
        )
    reason = f"with it the body measures {metres:.2f} m {what}, an adult's about {usual} m"
    return Finding(unit, "guessed", reason), warning


def makes_an_adult(unit: str, take: SkeletonTake | PointTake, positions: np.ndarray) -> bool:
    """Tell whether a unit makes the body an adult of usual size, or the body has no size to tell by.

    Parameters
    ----------
    unit : str
        One of the units that have a name.
    take : SkeletonTake or PointTake
        The person.
    positions : (L, P, C) float
        What :func:`look` saw.

    Returns
    -------
    bool
        Whether it does.
    """
    size, usual, _ = _body_size(take, positions)
    return size == 0.0 or bool(abs(np.log(size * METRES[unit] / usual)) <= np.log(_USUAL))


def doubt_unit(stated: Finding, take: SkeletonTake | PointTake, positions: np.ndarray) -> str:
    """Tell whether a stated unit makes the body a toy's or a tower's, and another metric one an adult's.

    Parameters
    ----------
    stated : Finding
        What the file says.
    take : SkeletonTake or PointTake
        The person.
    positions : (L, P, C) float
        What :func:`look` saw.

    Returns
    -------
    str
        A warning, empty where the unit may stand.
    """
    if stated.how != "read" or stated.value not in METRES or len(take.names) < _FEWEST:
        return ""
    about = float(np.linalg.norm(_median(_reach(positions)))) * METRES[stated.value] / _STANDING
    if 2.0 / _TOY < about < _TOY / 2.0:
        return ""  # without a look at every pair of points
    size, usual, what = _body_size(take, positions)
    metres = size * METRES[stated.value]
    if size == 0.0 or 1.0 / _TOY < metres / usual < _TOY:
        return ""
    better = min(_METRIC, key=lambda word: abs(np.log(size * METRES[word] / usual)))
    if not makes_an_adult(better, take, positions):
        return ""
    return (
        f"{stated.reason}, but with it the body measures {metres:.3g} m {what}; with {better} it would be an adult's: "
        f"if so, state the unit with --unit {better}."
    )


def _wander(axis: str, positions: np.ndarray) -> float:
    """How far, of the body's size, its lowest point along an axis wanders; infinite where that is no ground."""
    size = _median(_reach(positions)).max()
    if not axis or size == 0.0:
        return np.inf
    heights = positions[..., "xyz".index(axis[-1])] * (-1.0 if axis[0] == "-" else 1.0)
    lowest = np.where(np.isfinite(heights), heights, np.inf).min(axis=1) / size
    lowest = lowest[np.isfinite(lowest)]
    if lowest.size == 0 or abs(float(np.median(lowest))) > _GROUND:
        return np.inf
    wander = float(np.ptp(np.percentile(lowest, (10, 90))))
    return wander if wander < _STEADY else np.inf


def _along(axes: str, rise: np.ndarray) -> str:
    """Name the axis, with its sign, along which most of a way lies; empty where it lies askew."""
    length = float(np.linalg.norm(rise))
    axis = int(np.argmax(np.abs(rise)))
    if length == 0.0 or abs(rise[axis]) < _UPRIGHT * length:
        return ""
    return ("-" if rise[axis] < 0 else "") + axes[axis]


def _body_size(take: SkeletonTake | PointTake, positions: np.ndarray) -> tuple[float, float, str]:
    """How large a body is in the file's unit, how many metres an adult has there, and from where to where."""
    size = _ankle_to_head(take) if isinstance(take, SkeletonTake) else 0.0
    return (
        (size, _ANKLE_TO_HEAD, "from ankle to head")
        if size > 0.0
        else (_size(positions), _STANDING, "across")
    )


def _ankle_to_head(take: SkeletonTake) -> float:
    """Way along the joints from an ankle to the head, 0 where no joint is named so."""
    words = [name.lower() for name in take.names]
    heads = [k for k, word in enumerate(words) if "head" in word]
    ankles = [k for k, word in enumerate(words) if "ankle" in word or "foot" in word]
    if not heads or not ankles:
        return 0.0
    bones = np.median(
        np.linalg.norm(take.positions[:: max(1, len(take.positions) // _LOOKS)], axis=-1), axis=0
    )

    def above(joint: int) -> set[int]:
        chain = set()
        while joint >= 0:
            chain.add(joint)
            joint = int(take.parents[joint])
        return chain

    head = above(heads[0])
    return float(np.median([sum(bones[j] for j in head ^ above(ankle)) for ankle in ankles]))


def _size(positions: np.ndarray) -> float:
    sizes = []
    for points in positions:
        seen = points[np.isfinite(points).all(axis=1)]
        if len(seen) > 1:
            outer = _outermost(seen)
            sizes.append(np.linalg.norm(outer[:, None] - outer[None], axis=-1).max())
    return float(np.median(sizes)) if sizes else 0.0


def _outermost(points: np.ndarray) -> np.ndarray:
    """Of very many points (P, C) those that lie farthest along an axis or between axes, since pairs are P squared."""
    if len(points) <= _MANY:
        return points
    ways = [way for way in product((-1, 0, 1), repeat=points.shape[1]) if any(way)]
    return points[np.unique((points @ np.array(ways).T).argmax(axis=0))]


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


def _reach(positions: np.ndarray) -> np.ndarray:
    seen = np.isfinite(positions)
    reach = np.where(seen, positions, -np.inf).max(axis=1) - np.where(seen, positions, np.inf).min(axis=1)
    return np.where(np.isfinite(reach), reach, np.nan)


def _median(rows: np.ndarray) -> np.ndarray:
    rows = rows[np.isfinite(rows).all(axis=1)]
    return np.median(rows, axis=0) if len(rows) else np.zeros(rows.shape[1])
