"""Ways through posture space: curves that one goes there, or back, with or without a halt at either end."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.datasets._angles import mirrored, posture

Curve = Callable[[np.ndarray], np.ndarray]
"""Postures (T, 35) at places (T,) of a way, 0 at its source and 1 at its target."""


class Way(NamedTuple):
    """A path of the motion graph, as it is composed."""

    source: str
    target: str
    curve: Curve
    seconds: float
    halts: tuple[bool, bool] = (True, True)
    """Whether the body comes to a halt at the source, at the target."""
    symmetric: bool = False


class Step(NamedTuple):
    """One time that a way is gone."""

    way: str
    reversed: bool = False
    mirrored: bool = False


class Motif(NamedTuple):
    """A motif that a dance has, by the steps that it spans: from the first to before the last."""

    name: str
    steps: tuple[int, int]
    cyclic: bool = False
    partner: tuple[int, int] | None = None
    widest: tuple[int, int] | None = None
    """How far it may be told to reach, where that is farther."""


class Dance(NamedTuple):
    """What is done: ways by name, the order in which they are gone, and the motifs that it has by that."""

    ways: dict[str, Way]
    steps: tuple[Step, ...]
    motifs: tuple[Motif, ...]
    dwell_s: float = 0.0
    """Seconds for which the body usually stays where it comes to a halt at a state."""
    afloat: float = 0.0
    """Speed of a swimmer, m/s."""
    middle: np.ndarray = posture()
    """The posture about which the movement is made larger or smaller."""


def through(postures: Sequence[np.ndarray], at: Sequence[float] | None = None) -> Curve:
    """Lead smoothly through postures, evenly or at these places."""
    from scipy.interpolate import CubicSpline

    places = np.linspace(0.0, 1.0, len(postures)) if at is None else at
    if len(postures) == 2:
        return lambda u: postures[0] + u[:, None] * (postures[1] - postures[0])
    return CubicSpline(places, np.array(postures), bc_type="natural")


def around(postures: Sequence[np.ndarray], at: Sequence[float] | None = None) -> Curve:
    """Lead smoothly through postures and back to the first, without an end."""
    from scipy.interpolate import CubicSpline

    places = np.linspace(0.0, 1.0, len(postures) + 1) if at is None else at
    return CubicSpline(places, np.array([*postures, postures[0]]), bc_type="periodic")


def part(curve: Curve, start: float, stop: float) -> Curve:
    """Take a stretch of a curve."""
    return lambda u: curve(start + u * (stop - start))


def across(postures: Sequence[np.ndarray]) -> Curve:
    """Lead through postures to a symmetric one, the last, so that the way goes on as its own mirror image reversed."""
    return part(through([*postures, *(mirrored(each) for each in postures[-2::-1])]), 0.0, 0.5)


def go(way: Way, step: Step, share: np.ndarray) -> np.ndarray:
    """Take the postures (T, 35) of a step at shares (T,) of its time."""
    first, last = way.halts[::-1] if step.reversed else way.halts
    done = _eased(share, first, last)
    made = way.curve(1.0 - done if step.reversed else done)
    return mirrored(made) if step.mirrored else made


def _eased(share: np.ndarray, first: bool, last: bool) -> np.ndarray:
    """How much of a way is done: from and to a halt, or running on."""
    if first and last:
        return 0.5 - 0.5 * np.cos(np.pi * share)
    if first:
        return 1.0 - np.cos(0.5 * np.pi * share)
    return np.sin(0.5 * np.pi * share) if last else share
