"""Which moments picture a motion graph: a posture for each state, a time for each path."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery import MotionGraph, Path, State, Visit
from leitmotion.features import FeatureSequence
from leitmotion.view.graph_names import partner_of


class Moment(NamedTuple):
    """A posture of a recording."""

    recording: int
    frame: int
    mirrored: bool = False
    """Whether its mirror image is meant."""


class Time(NamedTuple):
    """Once that a path was gone."""

    visit: Visit
    mirrored: bool = False
    """Whether its mirror image is meant."""

    def moments(self, count: int) -> list[Moment]:
        """Choose so many postures, at even intervals, from the path's source to its target."""
        frames = np.linspace(self.visit.start, self.visit.stop - 1, count).round().astype(int)
        ordered = frames[::-1] if self.visit.reversed else frames
        return [Moment(self.visit.recording, int(frame), self.mirrored) for frame in ordered]


def posture_of(state: State, graph: MotionGraph, chains: Sequence[FeatureSequence]) -> Moment | None:
    """Choose the posture that pictures a state: of the middles of its visits that from which the others differ least.

    Parameters
    ----------
    state : State
        Of the graph. One that only reflection made is pictured by its mirror image.
    graph : MotionGraph
        Whose visits count frames of `chains`.
    chains : sequence of FeatureSequence
        The kinematic chain of each recording.

    Returns
    -------
    Moment or None
        None where nobody visited the state or its image.
    """
    visits, mirrored = _seen(state, graph)
    if not visits:
        return None
    middles = [(visit.recording, (visit.start + visit.stop - 1) // 2) for visit in visits]
    turned = np.array([chains[recording].values[frame] for recording, frame in middles]).reshape(
        len(middles), -1, 4
    )
    alike = np.abs(
        np.einsum("ikx,jkx->ijk", turned, turned)
    )  # a quaternion and its opposite are one rotation
    angles = np.arccos(np.clip(alike, 0.0, 1.0)).mean(axis=2)
    seen = np.isfinite(np.diagonal(angles))
    off = np.where(seen, np.where(seen, angles, 0.0).sum(axis=1), np.inf)
    recording, frame = middles[int(off.argmin())]
    return Moment(recording, frame, mirrored)


def time_of(path: Path, graph: MotionGraph) -> Time | None:
    """Choose the time that pictures a path: the one of middle length, forward where it was gone forward.

    Parameters
    ----------
    path : Path
        Of the graph. One that only reflection made is pictured by its mirror image.
    graph : MotionGraph
        Any.

    Returns
    -------
    Time or None
        None where nobody went the path or its image.
    """
    visits, mirrored = _seen(path, graph)
    if not visits:
        return None
    forward = [visit for visit in visits if not visit.reversed] or list(visits)
    by_length = sorted(forward, key=lambda visit: visit.stop - visit.start)
    return Time(by_length[(len(by_length) - 1) // 2], mirrored)


def _seen(item: State | Path, graph: MotionGraph) -> tuple[tuple[Visit, ...], bool]:
    """Visits of a state or path, else those of its mirror image."""
    partner = partner_of(item, graph)
    if item.visits or partner is None:
        return item.visits, False
    return partner.visits, True
