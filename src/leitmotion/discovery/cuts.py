"""Cuts: where one cycle of a run ends and the next begins.

Conventions
-----------
Moments of the working rate. A run of n cycles has n + 1 borders, the first where it starts.

References
----------
Paper P, section 2.5, cuts at the peaks of an autocorrelation (eq. 5), which gives equal cycles wherever the tempo
changes; its future work is to refine the cuts by where the members of the family start and end.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from leitmotion.discovery.autocorrelation import cycle_lags
from leitmotion.discovery.families import Run

CUTS = ("stripes", "members", "autocorrelation")
WHOLE = 0.75  # share of a cycle's movement that counts as one at the end of a stretch
BESIDE = 0.25  # of a period: a member's start or end this near to a border speaks of it
BETWEEN = 0.7  # of a period: no two peaks of eq. 5 are nearer to one another


def cutter(how: str, speed: np.ndarray, postures: np.ndarray) -> Callable[[Run], list[float]]:
    """Choose what cuts a run.

    Parameters
    ----------
    how : {"stripes", "members", "autocorrelation"}
        See the functions below.
    speed : (N,) float
        How fast the posture changes at each moment.
    postures : (N, D) float
        The recording at the working rate.

    Returns
    -------
    callable
        Gives the borders of a run.
    """
    if how == "autocorrelation":
        return lambda run: cut_by_autocorrelation(run, postures)
    if how == "members":
        return lambda run: cut_by_members(run, cut_by_stripes(run, speed))
    return lambda run: cut_by_stripes(run, speed)


def cut_by_stripes(run: Run, speed: np.ndarray) -> list[float]:
    """Carry the first border from cycle to cycle along the stripes of one period.

    The last cycle is whole when it goes as far as the others do: no rest need follow it.

    Parameters
    ----------
    run : Run
        A stretch that repeats, with its stripes.
    speed : (N,) float
        How fast the posture changes at each moment; see :class:`leitmotion.discovery.stripes.Likeness`.

    Returns
    -------
    list of float
        One border more than there are cycles, moments.
    """
    borders = [float(run.start)]
    while True:
        t = borders[-1]
        over = [s for s in run.stripes if s.a[0] <= t <= s.a[1] - 1]
        if over:
            step = max(over, key=lambda s: s.gain).forward(t) - t
        elif t + run.period <= run.stop:
            step = run.period
        else:
            break
        if t + step > run.stop or step < 1:
            break
        borders.append(t + step)
    whole = [_travelled(start, stop, speed) for start, stop in pairwise(borders)]
    if whole and _travelled(borders[-1], run.stop, speed) >= WHOLE * float(np.median(whole)):
        borders.append(float(run.stop))
    return borders


def _travelled(start: float, stop: float, speed: np.ndarray) -> float:
    """How far the posture goes in a stretch of time: what a rest adds to hardly at all."""
    return float(speed[int(start) : int(np.ceil(stop))].sum())


def cut_by_members(run: Run, borders: list[float]) -> list[float]:
    """Move borders to where members of the family start and end.

    The member at k periods pairs ``[start, stop - k)`` with ``[start + k, stop)``: its later stretch starts at border k
    and its earlier one ends at border n - k.

    Parameters
    ----------
    run : Run
        A stretch that repeats, with its stripes.
    borders : list of float
        Where it is cut so far.

    Returns
    -------
    list of float
        Each inner border in the middle of the starts and ends beside it; where there are none it stays.
    """
    told = np.array([moment for stripe in run.support for moment in (stripe.b[0], stripe.a[1])])
    moved = list(borders)
    for k in range(1, len(borders) - 1):
        beside = told[np.abs(told - borders[k]) <= BESIDE * run.period]
        if beside.size:
            moved[k] = float(np.median(beside))
    return moved


def cut_by_autocorrelation(run: Run, postures: np.ndarray) -> list[float]:
    """Cut at the peaks of paper P, eq. 5.

    Parameters
    ----------
    run : Run
        A stretch that repeats.
    postures : (N, D) float
        The recording at the working rate.

    Returns
    -------
    list of float
        One border more than there are cycles, moments.
    """
    start, stop = int(run.start), int(run.stop)
    lags = cycle_lags(postures[start:stop], max(1, round(BETWEEN * run.period)))
    return [float(start), *(float(start + lag) for lag in lags), float(stop)]
