"""Pauses: where a movement gives way to the next.

Conventions
-----------
Moments of the working rate, speeds in body sizes a moment. A *pause* is a moment at which the body is slower than
shortly before and after.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

PAUSE = 0.8  # of the speed before and after: slower is a pause
AROUND_S = 0.5  # how far before and after
REST = 0.5  # of how fast a movement is at its fastest: slower is a rest, from which it starts and to which it comes
FAST = 0.9  # quantile of its speed that counts as its fastest
END_S, END_SHARE = 0.4, 0.25  # how near to its ends, and in which share of it, the rest is looked for


def pauses(speed: np.ndarray, rate: float) -> list[int]:
    """Find the pauses of a movement.

    Parameters
    ----------
    speed : (N,) float
        How fast the posture changes.
    rate : float
        Moments per second.

    Returns
    -------
    list of int
        Moments, in order.

    Examples
    --------
    >>> pauses(np.abs(np.sin(np.linspace(0.1, 2 * np.pi - 0.1, 61))), rate=30.0)
    [30]
    """
    from leitmotion.discovery import _border_kernels

    around = max(1, round(AROUND_S * rate))
    found: list[int] = _border_kernels.pauses(
        speed, max(1, around // 2), around, speed.dtype.type(PAUSE)
    ).tolist()
    return found


def from_rest_to_rest(
    spans: Sequence[tuple[float, float]], speed: np.ndarray, rate: float, shortest: int
) -> list[tuple[float, float]]:
    """Let movements start and stop at a rest near their ends, where there is one.

    What leads over from another movement, or to it, has a speed of its own; the rest between the two is where a person
    would cut.

    Parameters
    ----------
    spans : sequence of (float, float)
        Where movements start and stop.
    speed : (N,) float
        How fast the posture changes.
    rate : float
        Moments per second.
    shortest : int
        No movement becomes shorter than so many moments.

    Returns
    -------
    list of (float, float)
        As many, each within the one that it comes from.
    """
    return [_rested(start, stop, speed, rate, shortest) for start, stop in spans]


def _rested(start: float, stop: float, speed: np.ndarray, rate: float, shortest: int) -> tuple[float, float]:
    first, last = max(0, int(start)), min(len(speed), int(stop))
    reach = int(min(END_SHARE * (last - first), END_S * rate)) + 1
    if last - first < max(shortest, 2 * reach):
        return start, stop
    slow = REST * float(np.quantile(speed[first:last], FAST))
    leading, trailing = speed[first : first + reach], speed[last - reach : last][::-1]
    begin = max(start, first + int(np.argmin(leading))) if leading.min() < slow else start
    end = last - int(np.argmin(trailing)) if trailing.min() < slow else stop
    return (begin, end) if end - begin >= shortest else (start, stop)


def true_runs(flags: np.ndarray) -> list[tuple[int, int]]:
    """Find the stretches in which a flag is true.

    Parameters
    ----------
    flags : (N,) bool
        One a moment.

    Returns
    -------
    list of (int, int)
        First moment and the one after the last, in order.

    Examples
    --------
    >>> true_runs(np.array([True, False, True, True]))
    [(0, 1), (2, 4)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate(([0], flags.astype(np.int8), [0])))).reshape(-1, 2)
    return [(int(start), int(stop)) for start, stop in edges]
