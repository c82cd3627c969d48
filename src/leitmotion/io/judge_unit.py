"""The unit of a file, judged from the size of the body in it.

Every judgement is a :class:`~leitmotion.io.reading.Finding` that is "guessed" and says why.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from leitmotion.io.reading import Finding, PointTake, SkeletonTake
from leitmotion.io.spread import LOOKS, median, reach
from leitmotion.io.units import METRES

_METRIC = ("m", "cm", "mm")
_OTHERS = ("inch", "1/0.45 inch")
_STANDING = 1.7  # metres, the largest distance between two points of a standing adult
_ANKLE_TO_HEAD = 1.5  # metres, along the joints, of an adult
_USUAL = 1.35  # by which factor a body may differ from the usual one without a word
_TOY = 20.0  # by which factor the body of a stated unit may differ from the usual one without a word
_FEWEST = 8  # points by which a body's size contradicts a stated unit
_SMALLEST = 0.25  # share of the usual size that the smallest of people, half a metre tall, still has
_MIDDLE = 0.63  # share of the usual size about which people of all ages lie within a decade
_MANY = 200  # points of which every pair is looked at


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
    about = float(np.linalg.norm(median(reach(positions)))) * METRES[stated.value] / _STANDING
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
        np.linalg.norm(take.positions[:: max(1, len(take.positions) // LOOKS)], axis=-1), axis=0
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
