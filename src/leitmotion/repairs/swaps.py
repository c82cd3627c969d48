"""Exchanges: two points take each other's place from one frame to the next, as when markers were labelled anew.

Conventions
-----------
An exchange is told by two sudden leaps that undo each other: where one point was going, the other is now. It lasts
until the two change places again; one that never ends, or began before the recording, is taken to be its shorter part.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.motion import Trajectories
from leitmotion.repairs.repaired import Change, Repaired, need_points
from leitmotion.repairs.usual import least_step, usual_around

SMALLEST_M = 0.03  # of a leap: smaller, the two points are nearly in one place
UNUSUAL = 2.5  # times what is usual around: how far a point must be from where it was going
EXACT = 0.35  # of the leaps: how far the points may be from each other's places
LONGEST_BLIND_S = 0.1  # unseen, within which an exchange is still told


class Exchange(NamedTuple):
    """Two points that bear each other's names for a while.

    Attributes
    ----------
    first, second : str
        Their names.
    start, stop : int
        The frames, half-open.
    """

    first: str
    second: str
    start: int
    stop: int


def find_exchanges(trajectories: Trajectories) -> tuple[Exchange, ...]:
    """Find points that take each other's place.

    Parameters
    ----------
    trajectories : Trajectories
        T frames of P points.

    Returns
    -------
    tuple of Exchange
        Each stretch in which two points bear each other's names, by first frame.
    """
    positions = trajectories.positions
    frames = len(positions)
    if frames < 3 or positions.shape[1] < 2:
        return ()
    leaps, speeds = _leaps(trajectories)
    turns: dict[tuple[int, int], list[int]] = {}
    for frame, before, points in leaps:
        was, now = positions[before, points], positions[frame, points]
        going = was + (frame - before) * speeds[before, points]
        # points may have stopped, or their last step was itself a leap: they are expected where they were, too
        missed = [np.linalg.norm(now[:, None] - expected[None], axis=2) for expected in (going, was)]
        leaps_of = np.minimum(*(np.diagonal(off) for off in missed))
        for a, b in sorted({pair for off in missed for pair in _mutual(off, leaps_of)}):
            pair = int(points[a]), int(points[b])
            turns.setdefault(pair, []).append(frame)
            # each goes on as the other did
            speeds[frame, list(pair)] = (
                positions[frame, list(pair)] - positions[before, list(pair[::-1])]
            ) / (frame - before)
    found = []
    for (a, b), at in turns.items():
        for start, stop in _stretches(at, frames):
            found.append(Exchange(trajectories.names[a], trajectories.names[b], start, stop))
    return tuple(sorted(found, key=lambda one: (one.start, one.stop)))


def undo_exchanges(trajectories: Trajectories, exchanges: Sequence[Exchange] | None = None) -> Repaired:
    """Give points that took each other's place their own names back.

    Parameters
    ----------
    trajectories : Trajectories
        T frames of P points.
    exchanges : sequence of Exchange, optional
        Which; by default those that :func:`find_exchanges` finds.

    Returns
    -------
    Repaired
        The points, with a change "swap" for each point of an exchange.

    Examples
    --------
    >>> t = np.arange(60)[:, None, None] / 60
    >>> feet = np.concatenate((t + [0.1, 0, 0], t + [-0.1, 0, 0]), axis=1)
    >>> feet[20:30] = feet[20:30, ::-1]
    >>> mended = undo_exchanges(Trajectories(("LANK", "RANK"), feet, rate=60))
    >>> [change[:4] for change in mended.changes], np.ptp(mended.recording.positions[:, 0, 0] - t[:, 0, 0]) < 1e-12
    ([('swap', 'LANK', 20, 30), ('swap', 'RANK', 20, 30)], np.True_)
    """
    trajectories = need_points(trajectories, "Undoing exchanges")
    exchanges = find_exchanges(trajectories) if exchanges is None else exchanges
    if not exchanges:
        return Repaired(trajectories)
    positions = trajectories.positions.copy()
    sure = None if trajectories.confidence is None else trajectories.confidence.copy()
    changes = []
    for first, second, start, stop in exchanges:
        pair = [trajectories.names.index(first), trajectories.names.index(second)]
        for held in (positions, sure):
            if held is not None:
                held[start:stop, pair] = held[start:stop, pair[::-1]]
        changes.append(Change("swap", first, start, stop, f"exchanged with {second}"))
        changes.append(Change("swap", second, start, stop, f"exchanged with {first}"))
    return Repaired(trajectories.replace(positions=positions, confidence=sure), tuple(changes))


def _leaps(trajectories: Trajectories) -> tuple[list[tuple[int, int, np.ndarray]], np.ndarray]:
    """Moments at which two points or more are not where they were going, and how fast each goes.

    A moment is its frame, the frame before that shows the points, and the points; a speed is a step per frame.
    """
    positions, rate = trajectories.positions, trajectories.rate
    speeds = np.zeros_like(positions)
    speeds[1:] = np.nan_to_num(np.diff(positions, axis=0))
    bends = np.full(positions.shape[:2], np.nan)
    bends[1:] = np.linalg.norm(positions[1:] - positions[:-1] - speeds[:-1], axis=2)
    limit = np.maximum(
        least_step(positions, trajectories.unit, SMALLEST_M), UNUSUAL * usual_around(bends, rate)
    )
    wild = np.nan_to_num(bends) > limit
    leaps = [(int(k), int(k) - 1, np.flatnonzero(wild[k])) for k in np.flatnonzero(wild.sum(axis=1) >= 2)]
    seen = np.isfinite(positions).all(axis=2)
    vanish = seen[:-1] & ~seen[1:]  # points that vanish may come back exchanged
    for before in np.flatnonzero(vanish.sum(axis=1) >= 2):
        last = min(int(before) + 2 + round(LONGEST_BLIND_S * rate), len(seen))
        for frame in range(int(before) + 2, last):
            back = np.flatnonzero(vanish[before] & seen[frame])
            if back.size >= 2:
                ahead = positions[before, back] + (frame - before) * speeds[before, back]
                off = np.linalg.norm(positions[frame, back] - ahead, axis=1)
                far = back[off > (frame - before) * limit[before, back]]
                if far.size >= 2:
                    leaps.append((frame, int(before), far))
                break
    return sorted(leaps, key=lambda leap: leap[0]), speeds


def _mutual(missed: np.ndarray, leaps: np.ndarray) -> list[tuple[int, int]]:
    """Pairs of which each is where the other was expected: `missed` is (now, expected), `leaps` how far off each is."""
    elsewhere = missed.copy()
    np.fill_diagonal(elsewhere, np.inf)
    nearest = elsewhere.argmin(axis=1)
    return [
        (a, int(b))
        for a, b in enumerate(nearest)
        if a < b and nearest[b] == a and max(missed[a, b], missed[b, a]) < EXACT * min(leaps[a], leaps[b])
    ]


def _stretches(turns: list[int], frames: int) -> list[tuple[int, int]]:
    """What lies between an odd turn and the next even one, or all the rest where that is less."""
    borders = [*turns, frames] if len(turns) % 2 else turns
    inside = [(borders[k], borders[k + 1]) for k in range(0, len(borders), 2)]
    if len(turns) % 2 == 0 or sum(stop - start for start, stop in inside) <= frames / 2:
        return inside
    whole = [0, *turns]
    return [(whole[k], whole[k + 1]) for k in range(0, len(whole), 2)]
