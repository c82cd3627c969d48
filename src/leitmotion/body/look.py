"""A look at a recording: where its points are at a few moments spread over it, and a little later."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.motion import Motion, Trajectories, forward_kinematics
from leitmotion.motion.kinematics import end_site_positions

MOMENTS = 64
STEP_S = 0.25  # a walk goes a third of a metre meanwhile, and a sway comes back


class Look(NamedTuple):
    """Where the points of a recording are at M moments."""

    positions: np.ndarray
    """(M, P + K, C): its joints or points, then the end sites of its skeleton; NaN where unseen."""

    later: np.ndarray
    """The same, `step` seconds later."""

    step: float
    """Seconds; 0 where the recording is too short for one."""

    duration: float
    """Seconds that the recording lasts."""

    metric: bool
    """Whether a number is metres."""


def look_at(recording: Motion | Trajectories) -> Look:
    """Place the points of a recording in the world, at a few moments evenly spread.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames, Y up.

    Returns
    -------
    Look
        At most 64 moments, fewer of a recording that has fewer frames.
    """
    frames = len(recording)
    ahead = min(max(1, round(STEP_S * recording.rate)), max(frames - 1, 0))
    moments = np.unique(np.linspace(0, max(frames - ahead - 1, 0), MOMENTS).astype(int))[:frames]
    both = np.concatenate((moments, moments + ahead))[: 2 * len(moments)]
    if isinstance(recording, Motion):
        few = recording.replace(
            local_positions=recording.local_positions[both], local_rotations=recording.local_rotations[both]
        )
        pose = forward_kinematics(few)
        placed = np.concatenate((pose.positions, end_site_positions(few, pose)), axis=1)
    else:
        placed = recording.positions[both]
    metric = isinstance(recording, Motion) or recording.unit == "m"
    now, later = placed[: len(moments)], placed[len(moments) :]
    return Look(now, later, ahead / recording.rate, recording.duration, metric)


def by_role(
    positions: np.ndarray, names: Sequence[str], members: Mapping[str, Sequence[str]]
) -> dict[str, np.ndarray]:
    """Gather the points of each role.

    Parameters
    ----------
    positions : (M, P, C) float
        Positions, the named ones first.
    names : sequence of str
        What they are called.
    members : mapping of str to sequence of str
        For each role the points whose mean it is.

    Returns
    -------
    dict of str to (M, C) float
        The mean of each role's members, NaN where one is unseen.
    """
    place = {name: i for i, name in enumerate(names)}
    return {role: positions[:, [place[n] for n in those]].mean(axis=1) for role, those in members.items()}


def between(points: Mapping[str, np.ndarray], start: str, end: str) -> np.ndarray | None:
    """Tell the way from one role to another.

    Parameters
    ----------
    points : mapping of str to (M, C) float
        Positions by role.
    start, end : str
        Two roles.

    Returns
    -------
    (M, C) float or None
        The way, NaN where either is unseen; None where either is unknown.
    """
    return points[end] - points[start] if start in points and end in points else None


def typical(values: np.ndarray) -> float:
    """Median of what is finite; NaN, against which every comparison is false, where nothing is."""
    values = values[np.isfinite(values)]
    return float(np.median(values)) if len(values) else np.nan
