"""Spikes: a point, or a joint's rotation, leaps away for a few frames and comes back.

A run of up to a twentieth of a second (at most eight frames) is a spike when three things hold. It lies twenty times as
far from the straight line between the frames around it as a run of that length usually does, the usual being a median
over the time around (of one frame that is half the second difference). It goes out and comes back by steps of its own
size that point against each other. And a point that moves with others as a rigid body leaves that body by half the
spike's height, so that a whole body that is shaken has none.

References
----------
[1] Hampel, *The influence curve and its role in robust estimation*, JASA 69 (1974): the median and its deviation
    as the scale that outliers do not move.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.motion import Motion, ParameterError, Trajectories, rotations
from leitmotion.repairs.lines import line, shares
from leitmotion.repairs.repaired import Change, Recording, Repaired, need_recording, placed_anew
from leitmotion.repairs.rigid import MOST, carried, companions, spanning
from leitmotion.repairs.usual import least_step, usual_around

LONGEST_S = 0.05
MOST_FRAMES = 8  # of a spike, where the rate is high
SMALLEST_M = 0.02  # of a spike's height; markers jitter by a millimetre
SMALLEST_TURN = np.sqrt(2) * np.sin(
    np.radians(45) / 2
)  # of a rotation's spike: 45 degrees, as a distance of `_free_of_sign`
UNUSUAL = 20.0


class Spike(NamedTuple):
    """A stretch in which a point or joint is far from where it was before and is after.

    Attributes
    ----------
    joint : str
        Its name.
    start, stop : int
        The frames, half-open.
    height : float
        How far off, in the recording's unit; of a rotation, degrees.
    of : {"place", "turn"}
        Whether the place of a point or root leaps, or the rotation of a joint.
    """

    joint: str
    start: int
    stop: int
    height: float
    of: str = "place"


def find_spikes(recording: Recording) -> tuple[Spike, ...]:
    """Find the spikes of every point; of a skeleton those of the joints' rotations and of the root's place.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.

    Returns
    -------
    tuple of Spike
        By joint, then by time; turns first.
    """
    recording = need_recording(recording, "Finding spikes")
    if isinstance(recording, Trajectories):
        floor = least_step(recording.positions, recording.unit, SMALLEST_M)
        found = _spikes(recording.positions, recording.rate, floor)
        steady = {point: companions(recording.positions, point) for point in {spike[0] for spike in found}}
        kept = [spike for spike in found if _breaks_away(recording.positions, steady[spike[0]], *spike)]
        return tuple(Spike(recording.names[point], start, stop, high) for point, start, stop, high in kept)
    names, places = recording.skeleton.names, recording.local_positions
    sudden = _sudden(recording.local_rotations)
    turns = _spikes(_free_of_sign(recording.local_rotations[:, sudden]), recording.rate, SMALLEST_TURN)
    shifts = _spikes(places[:, :1], recording.rate, SMALLEST_M)
    return tuple(
        Spike(
            names[sudden[place]],
            start,
            stop,
            float(np.degrees(2 * np.arcsin(min(1.0, high / np.sqrt(2))))),
            "turn",
        )
        for place, start, stop, high in turns
    ) + tuple(Spike(names[joint], start, stop, high) for joint, start, stop, high in shifts)


def remove_spikes(recording: Recording, *, leave: str = "line") -> Repaired:
    """Take spikes away.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.
    leave : {"line", "gap"}
        What stands in their place: a straight line between the frames around (of rotations, the shortest turn), or,
        of points, a gap to be filled by :func:`~leitmotion.repairs.fill_gaps`.

    Returns
    -------
    Repaired
        The recording, with a change "spike" for each. Rotations beside it stay, the sign of their quaternions may not.

    Raises
    ------
    ParameterError
        When a gap is asked for in a skeleton, which can have none.

    Examples
    --------
    >>> path = np.zeros((50, 1, 3))
    >>> path[20] = [0.0, 0.5, 0.0]
    >>> mended = remove_spikes(Trajectories(("LFIN",), path, rate=100))
    >>> mended.changes[0][:4], float(mended.recording.positions[20, 0, 1])
    (('spike', 'LFIN', 20, 21), 0.0)
    """
    recording = need_recording(recording, "Removing spikes")
    if leave not in ("line", "gap"):
        raise ParameterError(f"A spike leaves a line or a gap, got {leave!r}.")
    if leave == "gap" and isinstance(recording, Motion):
        raise ParameterError("A skeleton has no gaps, so that a spike can only leave a line.")
    spikes = find_spikes(recording)
    if not spikes:
        return Repaired(recording)
    replaced = "left as a gap" if leave == "gap" else "replaced by a line"
    if isinstance(recording, Trajectories):
        positions = recording.positions.copy()
        for joint, start, stop, *_ in spikes:
            path = positions[:, recording.names.index(joint)]
            path[start:stop] = np.nan if leave == "gap" else line(path, start, stop)
        changes = [_told(spike, f"{_height(spike, recording.unit)}, {replaced}") for spike in spikes]
        return Repaired(placed_anew(recording, positions), tuple(changes))
    return _of_motion(recording, spikes, replaced)


def _of_motion(motion: Motion, spikes: tuple[Spike, ...], replaced: str) -> Repaired:
    turned, places = motion.local_rotations.copy(), motion.local_positions.copy()
    changes = []
    for spike in spikes:
        joint = motion.skeleton.index(spike.joint)
        if spike.of == "turn":
            before, after = turned[spike.start - 1, joint], turned[spike.stop, joint]
            turned[spike.start : spike.stop, joint] = rotations.slerp(
                before[None], after[None], shares(spike.start, spike.stop)
            )
            turned[:, joint] = rotations.continuous(
                turned[:, joint]
            )  # a half turn may have turned the sign behind it
            changes.append(_told(spike, f"a turn of {spike.height:.0f} degrees, {replaced}"))
        else:
            path = places[:, joint]
            path[spike.start : spike.stop] = line(path, spike.start, spike.stop)
            changes.append(_told(spike, f"{_height(spike, 'm')}, {replaced}"))
    return Repaired(motion.replace(local_rotations=turned, local_positions=places), tuple(changes))


def _spikes(paths: np.ndarray, rate: float, floor: float) -> list[tuple[int, int, int, float]]:
    """Runs that leap from a path and back: (point, start, stop, height), of overlapping ones the highest."""
    frames = len(paths)
    if frames < 5:
        return []
    steps = np.diff(paths, axis=0)
    sizes = np.linalg.norm(steps, axis=2)
    found: dict[int, list[tuple[int, int, int, float]]] = {}
    for length in range(1, min(max(1, round(LONGEST_S * rate)), MOST_FRAMES, frames - 2) + 1):
        last = frames - length - 1
        back = np.einsum("tpc,tpc->tp", steps[:last], steps[length:])
        smaller = np.minimum(sizes[:last], sizes[length:])
        with np.errstate(invalid="ignore"):
            returns = (back < -0.5 * sizes[:last] * sizes[length:]) & (smaller > 0.5 * floor)
        starts, points = np.nonzero(returns)
        high = _heights([paths[starts + k, points] for k in range(length + 2)])
        leaps = (high > floor) & (smaller[starts, points] > 0.5 * high)
        starts, points, high = starts[leaps], points[leaps], high[leaps]
        for point in np.unique(points):  # few have any
            path = np.ascontiguousarray(paths[:, point])
            whole = _heights([path[k : k + last] for k in range(length + 2)])
            usual = usual_around(whole[:, None], rate)[:, 0]
            for start, height in zip(starts[points == point], high[points == point], strict=True):
                if height > UNUSUAL * usual[start]:
                    run = (int(point), int(start) + 1, int(start) + 1 + length, float(height))
                    found.setdefault(int(point), []).append(run)
    return [spike for point in sorted(found) for spike in _highest(found[point], frames)]


def _free_of_sign(quaternions: np.ndarray) -> np.ndarray:
    """Each quaternion times itself, (T, J, 16): the same for q and -q, and sqrt(2) sin(angle / 2) apart."""
    squares = quaternions[..., :, None] * quaternions[..., None, :]
    return squares.reshape(*quaternions.shape[:2], 16)


def _sudden(quaternions: np.ndarray) -> np.ndarray:
    """The joints that ever turn from frame to frame by about half of the smallest spike: no other has one."""
    cosines = np.einsum("tjc,tjc->tj", quaternions[1:], quaternions[:-1])
    return np.flatnonzero((2 * (1 - cosines**2) > (0.49 * SMALLEST_TURN) ** 2).any(axis=0))


def _heights(frames: Sequence[np.ndarray]) -> np.ndarray:
    """How far runs are, at the least, from the line between the frames around, given all runs frame by frame."""
    before, *inside, after = frames
    heights = np.full(len(before), np.inf)
    for place, share in zip(inside, shares(1, len(frames) - 1), strict=True):
        off = np.linalg.norm(place - (1 - share) * before - share * after, axis=1)
        heights = np.minimum(heights, off)
    return heights


def _highest(runs: list[tuple[int, int, int, float]], frames: int) -> list[tuple[int, int, int, float]]:
    taken = np.zeros(frames + 1, dtype=bool)
    kept: list[tuple[int, int, int, float]] = []
    for run in sorted(runs, key=lambda run: (-run[3], run[2] - run[1])):
        if not taken[run[1] : run[2]].any():
            taken[run[1] - 1 : run[2] + 1] = True
            kept.append(run)
    return sorted(kept, key=lambda run: run[1])


def _breaks_away(
    positions: np.ndarray, steady: np.ndarray, point: int, start: int, stop: int, height: float
) -> bool:
    """Whether it leaves the body that it moves with; true where too few points tell where that is."""
    around = positions[start - 1 : stop]
    steady = steady[np.isfinite(around[:, steady]).all(axis=(0, 2))][:MOST]
    if not steady.size or not spanning(around[0, steady]):
        return True
    expected = carried(around[0, steady], around[1:, steady], around[0, point])
    return bool(np.linalg.norm(around[1:, point] - expected, axis=1).max() > height / 2)


def _told(spike: Spike, detail: str) -> Change:
    return Change("spike", spike.joint, spike.start, spike.stop, detail)


def _height(spike: Spike, unit: str) -> str:
    return f"{100 * spike.height:.1f} cm off" if unit == "m" else f"{spike.height:.3g} off"
