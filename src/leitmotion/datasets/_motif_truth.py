"""The truth of a composed motion: which motif, state and path is where, told from the steps of which it consists."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.datasets._ways import Dance

STILL_S = 0.5  # a shorter halt is no stillness
SYMMETRIC = "XYTWVUSR"  # letters of symmetric states; others are asymmetric
BAR = "\u0304"


class TrueVisit(NamedTuple):
    """One time that a state was held or passed, or a path was gone: frames ``[start, stop)``."""

    start: int
    stop: int
    reversed: bool = False


class TrueState(NamedTuple):
    """A node of the motion graph."""

    name: str
    symmetric: bool
    visits: tuple[TrueVisit, ...]


class TruePath(NamedTuple):
    """An edge of the motion graph."""

    name: str
    source: str
    target: str
    symmetric: bool
    reversible: bool
    visits: tuple[TrueVisit, ...]


class TrueStep(NamedTuple):
    """One way gone, in the order of time."""

    path: str
    """Name of the way, without a star."""
    start: int
    stop: int
    reversed: bool
    mirrored: bool
    symmetric: bool
    source: str
    """The state in which it begins, in time; empty of a posture that is no state."""
    target: str
    halts: tuple[bool, bool]
    """Whether the body comes to a halt at its beginning, at its end."""


class TrueMotif(NamedTuple):
    """A stretch that has a motif: frames ``[start, stop)``, and of a paired one those of its partner."""

    motif: str
    start: int
    stop: int
    cyclic: bool
    partner: tuple[int, int] | None
    widest: tuple[int, int]
    """Frames as far as which it may be told to reach: the largest stretch that has it in the same way."""


def true_steps(dance: Dance, starts: np.ndarray, stops: np.ndarray) -> tuple[TrueStep, ...]:
    """Tell the steps of a dance from the frames at which they start and stop (K,)."""
    told = []
    for step, start, stop in zip(dance.steps, starts.tolist(), stops.tolist(), strict=True):
        way = dance.ways[step.way]
        ends = [_starred(state) if step.mirrored else state for state in (way.source, way.target)]
        halts = way.halts
        if step.reversed:
            ends, halts = ends[::-1], halts[::-1]
        gone = step.reversed, step.mirrored, way.symmetric
        told.append(TrueStep(step.way, start, stop, *gone, ends[0], ends[1], halts))
    return tuple(told)


def true_states(steps: Sequence[TrueStep], frames: int) -> tuple[TrueState, ...]:
    """Collect the visits of each state; one that is passed without a halt is visited for one frame."""
    seen: dict[str, list[TrueVisit]] = {}
    befores = [("", 0, 0), *((step.target, step.stop, step.stop) for step in steps)]
    for k, (name, start, _) in enumerate(befores):
        state = name or (steps[k].source if k == 0 else "")
        stop = steps[k].start if k < len(steps) else frames
        if state:
            start = min(start, frames - 1)
            seen.setdefault(state, []).append(TrueVisit(start, max(stop, start + 1)))
    return tuple(TrueState(name, name in SYMMETRIC, tuple(visits)) for name, visits in seen.items())


def true_paths(steps: Sequence[TrueStep]) -> tuple[TruePath, ...]:
    """Collect the visits of each path; there and back by way of a posture that is no state is one visit."""
    seen: dict[tuple[str, bool], list[TrueVisit]] = {}
    ends: dict[tuple[str, bool], tuple[str, str, bool]] = {}
    both: dict[str, set[bool]] = {}
    for k, step in enumerate(steps):
        key = step.path, step.mirrored
        both.setdefault(step.path, set()).add(step.reversed)
        if not step.source:
            continue
        loop = not step.target
        stop = steps[k + 1].stop if loop else step.stop
        source, target = (step.source, steps[k + 1].target) if loop else (step.source, step.target)
        if step.reversed:
            source, target = target, source
        seen.setdefault(key, []).append(TrueVisit(step.start, stop, step.reversed))
        ends[key] = source, target, step.symmetric
    return tuple(
        TruePath(
            f"({key[0]})*" if key[1] else key[0],
            *ends[key],
            len(both[key[0]]) == 2,
            tuple(visits),
        )
        for key, visits in seen.items()
    )


def true_motifs(dance: Dance, steps: Sequence[TrueStep], frames: int, rate: float) -> tuple[TrueMotif, ...]:
    """Tell the motifs of a dance in frames, and where the body keeps still for long enough."""

    def stretch(span: tuple[int, int]) -> tuple[int, int]:
        return steps[span[0]].start, steps[span[1] - 1].stop

    told = [
        TrueMotif(
            motif.name,
            *stretch(motif.steps),
            motif.cyclic,
            motif.partner and stretch(motif.partner),
            stretch(motif.widest or motif.steps),
        )
        for motif in dance.motifs
    ]
    halts = zip([0, *(step.stop for step in steps)], [*(step.start for step in steps), frames], strict=True)
    told += [
        TrueMotif("stillness", start, stop, False, None, (start, stop))
        for start, stop in halts
        if stop - start >= STILL_S * rate
    ]
    return tuple(sorted(told, key=lambda one: (one.start, -one.stop)))


def written(states: Sequence[TrueState], paths: Sequence[TruePath]) -> str:
    """Write a motion graph as paper S does: "X̄, Ȳ; x̄y ↔"."""
    nodes = ", ".join(s.name + BAR if s.symmetric else s.name for s in states)
    ways = ", ".join(
        f"{p.name[0] + BAR + p.name[1:] if p.symmetric else p.name} {'↔' if p.reversible else '→'}"
        for p in paths
    )
    return f"{nodes}; {ways}"


def _starred(state: str) -> str:
    """Name the mirror image of a state."""
    if state in SYMMETRIC:  # the empty name too: a posture that is no state
        return state
    return state[:-1] if state.endswith("*") else state + "*"
