"""Filtering: noise above a frequency taken away by :mod:`leitmotion.motion.smoothing`, without delay.

References
----------
[1] Winter, *Biomechanics and Motor Control of Human Movement*: the residual analysis that chooses a cutoff.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, rotations
from leitmotion.motion.smoothing import HIGHEST, SHORTEST, smooth
from leitmotion.repairs.repaired import Change, Recording, Repaired, need_recording, runs

CANDIDATES = 40  # cutoffs that the residual analysis tries
MOST_PATHS = 120  # coordinates that speak for the cutoff, evenly spread
MOST_FRAMES = 20_000


def low_pass(recording: Recording, cutoff_hz: float | str = "auto") -> Repaired:
    """Smooth a recording by a zero-lag Butterworth low-pass of order four.

    Positions are filtered coordinate by coordinate, each stretch without a gap on its own; what is unseen stays so.
    Rotations are filtered as quaternions, continuous along time, and scaled back to length 1: that is linear up to
    the scaling and turns with the body exactly.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.
    cutoff_hz : float or "auto"
        Where half of the power is left, hertz; "auto" takes what :func:`choose_cutoff` finds and says so.

    Returns
    -------
    Repaired
        The recording, with one change "filter" that states the cutoff, and a remark that counts stretches of fewer
        than five frames, which are left.

    Raises
    ------
    ParameterError
        When the cutoff is not above zero and below 0.45 of the rate.
    DataError
        When the cutoff is to be chosen, but nothing moves.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> still = Trajectories(("LFIN",), np.ones((50, 1, 3)), rate=100)
    >>> bool(np.allclose(low_pass(still, 6).recording.positions, 1))
    True
    """
    recording = need_recording(recording, "Filtering")
    chosen = choose_cutoff(recording) if cutoff_hz == "auto" else cutoff_hz
    if isinstance(chosen, bool | str) or not 0 < chosen < HIGHEST * recording.rate:
        raise ParameterError(
            f"The cutoff must lie above 0 and below {HIGHEST * recording.rate:g} Hz, 0.45 of the rate, "
            f"got {cutoff_hz!r}."
        )
    why = ", chosen by residual analysis" if cutoff_hz == "auto" else ""
    detail = f"zero-lag Butterworth low-pass of order 4, cutoff {chosen:.3g} Hz{why}"
    change = Change("filter", "", 0, len(recording), detail)
    if isinstance(recording, Motion):
        if len(recording) < SHORTEST:
            return Repaired(recording, (), ("Too short to be filtered.",))
        places, turns = recording.local_positions, recording.local_rotations
        moving = (places != places[:1]).any(axis=(0, 2))
        placed = places.copy()
        placed[:, moving] = smooth(places[:, moving], chosen, recording.rate)
        turning = (turns != turns[:1]).any(axis=(0, 2))
        quiet = turns.copy()
        quiet[:, turning] = rotations.normalize(
            smooth(rotations.continuous(turns[:, turning]), chosen, recording.rate)
        )
        return Repaired(recording.replace(local_positions=placed, local_rotations=quiet), (change,))
    positions, short = recording.positions.copy(), 0
    for stretch, points in _whole_stretches(recording):
        if stretch.stop - stretch.start < SHORTEST:
            short += len(points)
            continue
        positions[stretch, points] = smooth(positions[stretch, points], chosen, recording.rate)
    few = (
        f"{short} {'stretch' if short == 1 else 'stretches'} of fewer than {SHORTEST} frames left unfiltered."
    )
    return Repaired(recording.replace(positions=positions), (change,), (few,) if short else ())


def choose_cutoff(recording: Recording) -> float:
    """Choose a cutoff by residual analysis [1].

    What a filter takes away is measured at many cutoffs. Towards high ones it falls along a straight line: noise
    alone, the same at every frequency. Where that line meets zero hertz it tells the noise of the whole recording, and
    the cutoff that takes away as much is chosen: there the signal lost and the noise kept are equal.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.

    Returns
    -------
    float
        Hertz, the median over the coordinates that move; every coordinate is analysed on its longest stretch without
        a gap, the line being fitted over the upper half of the cutoffs.

    Raises
    ------
    DataError
        When no coordinate moves for a second.
    """
    rate = recording.rate
    cutoffs = np.linspace(min(1.0, 0.02 * rate), min(0.4 * rate, 30.0), CANDIDATES)
    found = []
    for paths in _paths(recording):
        residuals = [
            np.sqrt(np.mean((paths - smooth(paths, cutoff, rate)) ** 2, axis=0)) for cutoff in cutoffs
        ]
        for residual in np.array(residuals).T:
            cutoff = _where_noise_begins(cutoffs, residual)
            if cutoff is not None:
                found.append(cutoff)
    if not found:
        raise DataError(
            f"No cutoff can be chosen for {recording.name or 'the recording'}: nothing in it moves for a second.",
            remedy="State one in hertz.",
        )
    return float(np.median(found))


def _where_noise_begins(cutoffs: np.ndarray, residual: np.ndarray) -> float | None:
    """The cutoff at which the residual is that of the noise alone; None where no line of noise is to be seen."""
    upper = slice(CANDIDATES // 2, None)
    noise = np.polynomial.polynomial.polyfit(cutoffs[upper], residual[upper], 1)[0]
    below = np.flatnonzero(residual <= noise)
    if noise <= 0 or not below.size:
        return None
    k = int(below[0])
    if k == 0:
        return float(cutoffs[0])
    share = (residual[k - 1] - noise) / (residual[k - 1] - residual[k])
    return float(cutoffs[k - 1] + share * (cutoffs[k] - cutoffs[k - 1]))


def _whole_stretches(recording: Trajectories) -> list[tuple[slice, list[int]]]:
    """Stretches without a gap, with the points that have exactly these: what is filtered together."""
    together: dict[tuple[int, int], list[int]] = {}
    seen = np.isfinite(recording.positions).all(axis=2)
    for point in range(seen.shape[1]):
        for stretch in runs(seen[:, point]):
            together.setdefault(stretch, []).append(point)
    return [(slice(*stretch), points) for stretch, points in together.items()]


def _paths(recording: Recording) -> list[np.ndarray]:
    """Coordinates that move, on their longest stretch without a gap if that lasts a second: (T, K) a stretch."""
    if isinstance(recording, Motion):
        turns = rotations.continuous(recording.local_rotations)
        columns = np.concatenate((recording.local_positions[:, 0], turns.reshape(len(turns), -1)), axis=1)
    else:
        columns = recording.positions.reshape(len(recording), -1)
    moving = np.flatnonzero(np.nan_to_num(np.abs(np.diff(columns, axis=0))).sum(axis=0) > 0)
    together: dict[tuple[int, int], list[int]] = {}
    for column in moving[:: max(1, len(moving) // MOST_PATHS)]:
        stretches = runs(np.isfinite(columns[:, column]))
        start, stop = max(stretches, key=lambda stretch: stretch[1] - stretch[0])
        stop = min(stop, start + MOST_FRAMES)
        if stop - start >= max(recording.rate, 3 * SHORTEST) and np.ptp(columns[start:stop, column]) > 0:
            together.setdefault((start, stop), []).append(int(column))
    return [columns[start:stop, held] for (start, stop), held in together.items()]
