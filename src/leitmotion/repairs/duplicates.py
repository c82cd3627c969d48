"""Duplicates: frames that repeat the one before to the bit, as a recorder writes that lost some or was stretched.

A frame that is dropped would shorten the time, so that none is: the frames keep their number and rate, and those that
only repeat are replaced by what lies between, or, of points, marked as unseen.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion import Motion, ParameterError, Trajectories, rotations
from leitmotion.repairs.lines import line, shares
from leitmotion.repairs.repaired import Change, Recording, Repaired, need_recording, placed_anew, runs

LONGEST_S = 0.5


def repeated_frames(positions: np.ndarray) -> np.ndarray:
    """Tell which frames repeat the one before to the bit.

    Parameters
    ----------
    positions : (T, ...) float
        Positions or rotations; unseen equals unseen, but a frame without anything seen repeats nothing.

    Returns
    -------
    (T,) bool
        Never true of the first.
    """
    flat = positions.reshape(len(positions), -1)
    same = np.zeros(len(flat), dtype=bool)
    if len(flat) > 1:
        both = (flat[1:] == flat[:-1]) | (np.isnan(flat[1:]) & np.isnan(flat[:-1]))
        same[1:] = both.all(axis=1) & np.isfinite(flat[1:]).any(axis=1)
    return same


def replace_duplicates(
    recording: Recording, *, leave: str = "line", max_hold_s: float | None = None
) -> Repaired:
    """Replace frames that only repeat the one before.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.
    leave : {"line", "gap"}
        What stands in their place: positions on a straight line and rotations on the shortest turn from the frame
        that was repeated to the next that differs; or, of points, nothing seen.
    max_hold_s : float, optional
        The longest hold that is replaced, seconds; by default 0.5. A longer one may be a person or a figure who
        stands still, and is left.

    Returns
    -------
    Repaired
        The recording, as long as it was, with a change "duplicate" for each hold, and a remark that counts those that
        were left: too long, or at the end, where nothing follows.

    Raises
    ------
    ParameterError
        When a gap is asked for in a skeleton, which can have none.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> x = np.array([0.0, 1, 1, 1, 4, 5])[:, None, None] * [[[1.0, 0, 0]]]
    >>> mended = replace_duplicates(Trajectories(("LFIN",), x, rate=30))
    >>> mended.recording.positions[:, 0, 0].tolist(), mended.changes[0][2:4]
    ([0.0, 1.0, 2.0, 3.0, 4.0, 5.0], (2, 4))
    """
    recording = need_recording(recording, "Replacing duplicates")
    if leave not in ("line", "gap"):
        raise ParameterError(f"A duplicate leaves a line or a gap, got {leave!r}.")
    if leave == "gap" and isinstance(recording, Motion):
        raise ParameterError("A skeleton has no gaps, so that a duplicate can only leave a line.")
    longest = (LONGEST_S if max_hold_s is None else max_hold_s) * recording.rate + 1e-6
    holds = runs(_repeats(recording))
    fit = [(start, stop) for start, stop in holds if stop - start <= longest and stop < len(recording)]
    remarks: tuple[str, ...] = ()
    if len(fit) < len(holds):
        count = len(holds) - len(fit)
        were = "1 hold was left: it is" if count == 1 else f"{count} holds were left: they are"
        remarks = (f"{were} longer than {longest / recording.rate:.2g} s or at the end.",)
    if not fit:
        return Repaired(recording, (), remarks)
    how = "marked as unseen" if leave == "gap" else "replaced by what lies between"
    changes = tuple(
        Change("duplicate", "", start, stop, f"{_frames(stop - start)} of frame {start - 1}, {how}")
        for start, stop in fit
    )
    if isinstance(recording, Trajectories):
        positions = recording.positions.copy()
        for start, stop in fit:
            positions[start:stop] = np.nan if leave == "gap" else _between(positions, start, stop)
        return Repaired(placed_anew(recording, positions), changes, remarks)
    places, turns = recording.local_positions.copy(), recording.local_rotations.copy()
    for start, stop in fit:
        places[start:stop] = _between(places, start, stop)
        share = shares(start, stop)[:, None]
        ends = turns[start - 1 : start], turns[stop : stop + 1]
        turned = rotations.slerp(*ends, share)
        moved = (ends[0] != ends[1]).any(axis=2)[0]
        turns[start:stop, moved] = turned[:, moved]
    return Repaired(recording.replace(local_positions=places, local_rotations=turns), changes, remarks)


def _repeats(recording: Recording) -> np.ndarray:
    if isinstance(recording, Trajectories):
        return repeated_frames(recording.positions)
    return repeated_frames(np.concatenate((recording.local_positions, recording.local_rotations), axis=2))


def _between(paths: np.ndarray, start: int, stop: int) -> np.ndarray:
    """The line from the repeated frame to the next; what either lacks, or what does not move, stays."""
    straight = line(paths, start, stop)
    return np.where((paths[start - 1] == paths[stop]) | np.isnan(straight), paths[start:stop], straight)


def _frames(count: int) -> str:
    return "1 repetition" if count == 1 else f"{count} repetitions"
