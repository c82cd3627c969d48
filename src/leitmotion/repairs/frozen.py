"""Frozen points: a point that stays where it is to the last bit while the others move on.

Some trackers go on writing the last place of a marker that they lost. No marker on a person keeps its place to the
bit, so that such a stretch is a gap in disguise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.motion import Trajectories
from leitmotion.repairs.repaired import Change, Repaired, need_points, placed_anew, runs
from leitmotion.repairs.usual import least_step

SHORTEST_S = 0.25
MOVED_M = 0.03  # how far the others go meanwhile
COARSE = 0.02  # of the frames that begin a shorter hold: places that are written coarsely repeat without being lost


class Frozen(NamedTuple):
    """A point that stands still while the others move.

    Attributes
    ----------
    joint : str
        Its name.
    start, stop : int
        The frames in which its place is only repeated, half-open: the one before is the last that was seen.
    """

    joint: str
    start: int
    stop: int


def find_frozen(trajectories: Trajectories) -> tuple[Frozen, ...]:
    """Find points that do not move for a quarter of a second or more while half of the others do.

    Parameters
    ----------
    trajectories : Trajectories
        T frames of P points.

    Returns
    -------
    tuple of Frozen
        By point, then by time. A point that never moves is none: it may be a fixed mark; nor is one that stands still
        for moments all the time, as pixels do.
    """
    positions = trajectories.positions
    frames, points = positions.shape[:2]
    shortest = max(2, round(SHORTEST_S * trajectories.rate))
    if frames <= shortest or points < 3:
        return ()
    steps = np.diff(positions, axis=0)
    same = (steps == 0).all(axis=2)
    travelled = np.concatenate(
        (np.zeros((1, points)), np.cumsum(np.nan_to_num(np.linalg.norm(steps, axis=2)), axis=0))
    )
    floor = least_step(positions, trajectories.unit, MOVED_M)
    found = []
    for point in np.flatnonzero(same.any(axis=0) & (travelled[-1] > 0)):
        held = runs(same[:, point])
        if sum(stop - start < shortest for start, stop in held) > COARSE * frames:
            continue
        for start, stop in held:
            if stop - start < shortest:
                continue
            went = np.delete(travelled[stop] - travelled[start], point)
            if np.median(went) > floor:
                found.append(Frozen(trajectories.names[point], start + 1, stop + 1))
    return tuple(found)


def release_frozen(trajectories: Trajectories) -> Repaired:
    """Mark frozen stretches as unseen, for :func:`~leitmotion.repairs.fill_gaps` to fill.

    Parameters
    ----------
    trajectories : Trajectories
        T frames of P points.

    Returns
    -------
    Repaired
        The points, with a change "frozen" for each stretch.

    Examples
    --------
    >>> t = np.arange(100.0)[:, None, None] / 100
    >>> three = t + np.array([[0.0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]])
    >>> three[40:70, 1] = three[39, 1]
    >>> mended = release_frozen(Trajectories(("a", "b", "c"), three, rate=100))
    >>> mended.changes[0][:4], int(np.isnan(mended.recording.positions[:, 1, 0]).sum())
    (('frozen', 'b', 40, 70), 30)
    """
    trajectories = need_points(trajectories, "Releasing frozen points")
    frozen = find_frozen(trajectories)
    if not frozen:
        return Repaired(trajectories)
    positions = trajectories.positions.copy()
    changes = []
    for joint, start, stop in frozen:
        positions[start:stop, trajectories.names.index(joint)] = np.nan
        changes.append(Change("frozen", joint, start, stop, "stood still while the others moved; now unseen"))
    return Repaired(placed_anew(trajectories, positions), tuple(changes))
