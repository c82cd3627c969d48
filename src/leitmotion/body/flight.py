"""Flights: the time between take-off and landing, when nothing but gravity acts, so that physics judges the recording.

Conventions
-----------
In flight the centre of mass falls with g and goes level at a constant speed, and the whole body's angular momentum
about it is constant. By how much a recording strays from that tells how far its scale, its rate, the masses and the
filter are from right. A flight is where the centre of mass, filtered, is accelerated downwards by more than half of g;
feet that are off the floor half-way through tell it from a quick crouch. Its ends, where the filter mixes it with the
ground, are left out.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from leitmotion.body.size import OF_STATURE, size_of_body
from leitmotion.motion.noun import Noun, noun, set_array
from leitmotion.motion.smoothing import derivative

GRAVITY = 9.80665
"""Metres per second squared: the standard."""
FALLS = 0.5  # of g, how fast what is in flight falls at least
ENDS = 0.3  # of the cutoff's period, what is left out at each end
SHORTEST_S = 0.1  # of what is left
FEWEST = 5  # frames of what is left: a parabola has three numbers
FLOOR = 2.0  # percentile of a foot's heights
CLEAR = {
    "toe": 0.01,
    "ankle": 0.05,
}  # of the stature, by which feet are off the floor; heels rise before toes do


@noun
class Flight(Noun):
    """A stretch in which nothing but gravity acts, and how well the recording obeys.

    Parameters
    ----------
    start, stop : int
        Frames, half-open: what was judged, without the ends that the filter mixes with the ground.
    gravity : float
        What the centre of mass falls with, m/s², from the parabola through its unfiltered heights.
    residual : float
        How far the centre of mass is from its parabola, m, root mean square of the distance.
    angular_momentum : (3,) float
        The mean, about the centre of mass, kg m²/s.
    drift : float
        How far the angular momentum strays from its mean, kg m²/s, root mean square.
    drift_share : float
        The same as a share of what the segments carry: of the mean sum of their angular momenta's sizes, which
        cancel in part. Body mass does not matter to it.
    """

    start: int
    stop: int
    gravity: float
    residual: float
    angular_momentum: np.ndarray
    drift: float
    drift_share: float

    def __post_init__(self) -> None:
        set_array(self, "angular_momentum", dtype=np.float64, shape=(3,), finite=False)

    @property
    def gravity_error(self) -> float:
        """By which share the gravity found is too large: 0.05 is 5 %."""
        return self.gravity / GRAVITY - 1.0


def find_flights(
    points: Mapping[str, np.ndarray], filtered: np.ndarray, rate: float, cutoff_hz: float
) -> list[tuple[int, int]]:
    """Find the stretches of free flight.

    Parameters
    ----------
    points : mapping of str to (T, 3) float
        Global positions by role, m, Y up, without gaps.
    filtered : (T, 3) float
        The centre of mass, filtered, m.
    rate : float
        Frames per second.
    cutoff_hz : float
        Of the filter: it says how much of the ends is left out.

    Returns
    -------
    list of tuple of int
        Frames, half-open, the ends left out.
    """
    falling = derivative(derivative(filtered[:, 1], rate), rate) < -FALLS * GRAVITY
    borders = np.flatnonzero(np.diff(np.concatenate(([False], falling, [False]))))
    off = _off_the_floor(points)
    trimmed = int(np.ceil(ENDS / cutoff_hz * rate))
    fewest = max(FEWEST, int(np.ceil(SHORTEST_S * rate)))
    flights = []
    for start, stop in borders.reshape(-1, 2).tolist():
        first, last = start + trimmed, stop - trimmed
        if last - first >= fewest and off[(start + stop) // 2]:
            flights.append((first, last))
    return flights


def judge_flight(
    span: tuple[int, int], centre: np.ndarray, whole: np.ndarray, parts: np.ndarray, rate: float
) -> Flight:
    """Compare a flight with what physics says.

    Parameters
    ----------
    span : tuple of int
        Frames, half-open.
    centre : (T, 3) float
        The centre of mass, unfiltered, m.
    whole : (T, 3) float
        The body's angular momentum about it, kg m²/s.
    parts : (T, S, 3) float
        What each segment adds to that.
    rate : float
        Frames per second.

    Returns
    -------
    Flight
        What was found.
    """
    start, stop = span
    times = (np.arange(stop - start) - (stop - start - 1) / 2) / rate
    there = centre[start:stop]
    fall = np.polynomial.polynomial.polyfit(times, there[:, 1], 2)
    level = np.polynomial.polynomial.polyfit(times, there[:, [0, 2]], 1)
    off = np.column_stack(
        (
            there[:, 1] - np.polynomial.polynomial.polyval(times, fall),
            there[:, [0, 2]] - np.polynomial.polynomial.polyval(times, level).T,
        )
    )
    momentum = whole[start:stop]
    drift = float(np.sqrt(np.mean(np.sum((momentum - momentum.mean(axis=0)) ** 2, axis=1))))
    carried = float(np.linalg.norm(parts[start:stop], axis=-1).sum(axis=1).mean())
    return Flight(
        start=start,
        stop=stop,
        gravity=float(-2.0 * fall[2]),
        residual=float(np.sqrt(np.mean(np.sum(off**2, axis=1)))),
        angular_momentum=momentum.mean(axis=0),
        drift=drift,
        drift_share=drift / carried if carried > 0 else 0.0,
    )


def _off_the_floor(points: Mapping[str, np.ndarray]) -> np.ndarray:
    """Whether both feet are higher than where they usually are lowest, (T,)."""
    stature = (size_of_body(points) or np.nan) / OF_STATURE
    off = []
    for side in ("left", "right"):
        part = "toe" if f"{side}_toe" in points else "ankle"
        height = points[f"{side}_{part}"][:, 1]
        off.append(height > np.percentile(height, FLOOR) + CLEAR[part] * stature)
    both: np.ndarray = np.logical_and(*off)
    return both
