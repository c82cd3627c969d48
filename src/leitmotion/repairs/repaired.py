"""What a remedy gives back: the recording, and every change that was made to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from leitmotion.motion import DataError, Motion, ParameterError, Trajectories

Recording = Motion | Trajectories


class Change(NamedTuple):
    """One thing that a remedy did.

    Attributes
    ----------
    what : str
        The remedy: "fill", "spike", "frozen", "swap", "sides", "duplicate", "filter" or "level".
    joint : str
        The joint or point that was changed; empty where all were.
    start, stop : int
        The frames that were changed, half-open.
    detail : str
        How, in words.
    """

    what: str
    joint: str
    start: int
    stop: int
    detail: str


@dataclass(frozen=True)
class Repaired:
    """A recording after a remedy.

    Nothing differs from the recording before but what the changes name.

    Parameters
    ----------
    recording : Motion or Trajectories
        The recording, the very same value where nothing was changed.
    changes : tuple of Change
        What was done, in the order in which it was done.
    remarks : tuple of str
        What was left as it is, and why.
    """

    recording: Recording
    changes: tuple[Change, ...] = ()
    remarks: tuple[str, ...] = ()


def need_points(recording: object, remedy: str) -> Trajectories:
    """Refuse what is no recording of points; as for :func:`need_recording` else."""
    recording = need_recording(recording, remedy)
    if isinstance(recording, Motion):
        raise ParameterError(
            f"{remedy} is for points, but {recording.name or 'the recording'} is a skeleton."
        )
    return recording


def need_recording(recording: object, remedy: str) -> Recording:
    """Refuse what is no recording, or an empty one.

    Parameters
    ----------
    recording : object
        What was given.
    remedy : str
        What was asked, as the beginning of a sentence.

    Returns
    -------
    Motion or Trajectories
        The recording.

    Raises
    ------
    ParameterError
        When it is none.
    DataError
        When it has no frame.
    """
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(f"{remedy} needs a recording, got {type(recording).__name__}.")
    if not len(recording):
        raise DataError(f"{remedy} needs at least one frame, {recording.name or 'the recording'} has none.")
    return recording


def placed_anew(trajectories: Trajectories, positions: np.ndarray) -> Trajectories:
    """Give points the places that a remedy has found, and say how sure these are.

    Parameters
    ----------
    trajectories : Trajectories
        T frames of P points.
    positions : (T, P, C) float
        Where they are now.

    Returns
    -------
    Trajectories
        The points in these places. Where a place is new, the confidence is the lesser of those before and after the
        stretch, from which it was made, and 0 where the point is now unseen; where none is new, it stays.

    Examples
    --------
    >>> held = Trajectories(("LFIN",), np.ones((4, 1, 3)), rate=30, confidence=[[0.9], [0.1], [1.0], [0.8]])
    >>> placed_anew(held, held.positions * [[[1]], [[2]], [[1]], [[np.nan]]]).confidence[:, 0].tolist()
    [0.9, 0.9, 1.0, 0.0]
    """
    if trajectories.confidence is None:
        return trajectories.replace(positions=positions)
    sure, before = trajectories.confidence.copy(), trajectories.positions
    new = ((before != positions) & ~(np.isnan(before) & np.isnan(positions))).any(axis=2)
    seen = np.isfinite(positions).all(axis=2)
    for point in np.flatnonzero(new.any(axis=0)):
        for start, stop in runs(new[:, point]):
            ends = trajectories.confidence[[max(start - 1, 0), min(stop, len(sure) - 1)], point]
            sure[start:stop, point] = np.where(seen[start:stop, point], ends.min(), 0.0)
    return trajectories.replace(positions=positions, confidence=sure)


def runs(flags: np.ndarray) -> list[tuple[int, int]]:
    """Find the stretches in which a flag is set.

    Parameters
    ----------
    flags : (T,) bool
        One flag a frame.

    Returns
    -------
    list of tuple of int
        Half-open stretches, in order.

    Examples
    --------
    >>> runs(np.array([False, True, True, False, True]))
    [(1, 3), (4, 5)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate(([0], np.asarray(flags).astype(np.int8), [0]))))
    return [(int(start), int(stop)) for start, stop in zip(edges[::2], edges[1::2], strict=True)]


def listed(names: Sequence[str]) -> str:
    """Name a few things in a sentence, and count the rest.

    Parameters
    ----------
    names : sequence of str
        At least one.

    Returns
    -------
    str
        "a", "a and b", or the first five "and 3 more".

    Examples
    --------
    >>> listed(["LKNE", "RKNE"])
    'LKNE and RKNE'
    """
    shown = list(names) if len(names) <= 6 else [*names[:5], f"{len(names) - 5} more"]
    return ", ".join(shown[:-1]) + f" and {shown[-1]}" if len(shown) > 1 else shown[0]
