"""Poses frame by frame, made into people: who is who from one frame to the next.

A pose estimator looks at each picture by itself and tells the people in it in any order. Where it names them, the names
count; else each pose goes to the person who was nearest in the frames before.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from leitmotion.io.reading import PointTake

NEAR = 0.5
"""How far a person may move from one frame to the next, in extents of the body; farther is somebody else."""

FLEETING = 0.05
"""Share of the frames below which a person is a mistake of the estimator, where somebody else is there longer."""


@dataclass(frozen=True)
class Pose:
    """One person in one frame."""

    points: np.ndarray
    """(P, C) float, NaN where unseen."""

    sure: np.ndarray | None = None
    """(P,) float, how sure the source was, or None where it does not say."""

    who: str = ""
    """What the file calls the person; empty where it does not."""


def people(frames: Sequence[Sequence[Pose]], names: Sequence[str], warnings: list[str]) -> list[PointTake]:
    """Part poses into people.

    Parameters
    ----------
    frames : sequence of sequence of Pose, T
        The poses of each frame, all of the same points.
    names : sequence of str, P
        What the points are.
    warnings : list of str
        Gains a sentence where people were told apart by nearness, and one where someone was left out.

    Returns
    -------
    list of PointTake
        One a person, in the order in which they appear; NaN in the frames without them.
    """
    if all(all(whos := [pose.who for pose in frame]) and len(set(whos)) == len(whos) for frame in frames):
        tracks: dict[str, dict[int, Pose]] = {}
        for t, frame in enumerate(frames):
            for pose in frame:
                tracks.setdefault(pose.who, {})[t] = pose
    elif max(map(len, frames)) == 1:
        tracks = {"": {t: frame[0] for t, frame in enumerate(frames) if frame}}
    else:
        tracks = {f"{k}": track for k, track in enumerate(_by_nearness(frames), 1)}
        warnings.append(
            f"The file does not tell people apart; by the nearest place from frame to frame there are {len(tracks)}."
        )
    kept = {who: track for who, track in tracks.items() if len(track) >= FLEETING * len(frames)}
    if kept and len(kept) < len(tracks):
        gone = sorted(len(track) for who, track in tracks.items() if who not in kept)
        most = f"{gone[-1]} frame" + ("s" if gone[-1] > 1 else "")
        warnings.append(
            f"{len(gone)} of {len(tracks)} people were seen in {most} at most and were left out as mistakes."
        )
        tracks = kept
    return [_take(track, len(frames), list(names), who) for who, track in tracks.items()]


def _take(track: dict[int, Pose], frames: int, names: list[str], who: str) -> PointTake:
    first = next(iter(track.values()))
    positions = np.full((frames, *first.points.shape), np.nan)
    confidence = None if first.sure is None else np.zeros((frames, len(names)))
    for t, pose in track.items():
        positions[t] = pose.points
        if confidence is not None and pose.sure is not None:
            confidence[t] = pose.sure
    return PointTake(names, positions, "joint", confidence, who)


def _by_nearness(frames: Sequence[Sequence[Pose]]) -> list[dict[int, Pose]]:
    """Give each pose to the track whose last pose is nearest, all of a frame at once; a far one begins a track."""
    from scipy.optimize import linear_sum_assignment

    tracks: list[dict[int, Pose]] = []
    last: list[np.ndarray] = []
    for t, frame in enumerate(frames):
        seen = [pose for pose in frame if np.isfinite(pose.points).any()]
        cost = np.array([[_distance(pose.points, before) for before in last] for pose in seen])
        taken: dict[int, int] = {}
        if cost.size:
            rows, columns = linear_sum_assignment(np.minimum(cost, 2.0 * NEAR))
            taken = {int(i): int(k) for i, k in zip(rows, columns) if cost[i, k] <= NEAR}
        for i, pose in enumerate(seen):
            k = taken.get(i)
            if k is None:
                tracks.append({})
                last.append(pose.points)
                k = len(tracks) - 1
            tracks[k][t] = pose
            last[k] = np.where(np.isfinite(pose.points), pose.points, last[k])
    return tracks


def _distance(pose: np.ndarray, before: np.ndarray) -> float:
    """Median way of the points seen in both, in extents of the body; infinite where there is none."""
    ways = np.linalg.norm(pose - before, axis=1)
    ways = ways[np.isfinite(ways)]
    extent = float(np.nanmax(np.ptp(before[np.isfinite(before).all(axis=1)], axis=0), initial=0.0))
    return float(np.median(ways)) / extent if ways.size and extent > 0 else np.inf
