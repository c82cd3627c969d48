"""Forms of a movement in time and space: runs of cycles and of half-cycles, ways there and back.

Conventions
-----------
A form is told in waypoints. A *cycle* ends where it began and goes on; half a cycle later an anti-phase movement is
its own mirror image. A *turn* is a moment from which the movement goes back the way it came, itself (a palindrome) or
as its mirror image (an anti-palindrome).

References
----------
Paper S, sections 3.4.3 to 3.4.8.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.signals import Signal
from leitmotion.discovery.waypoints import Waypoints

LEAST_EXTENT = 1.8  # of a path, over the angle within which postures are alike
LARGEST_GAP = 0.35  # of a cycle, between two stretches that are one after the other
SAME = 0.6  # of a run, that another covers which tells the same
OUTER = 1.7  # ways: as much of the first and the last is told, where no further turn is seen
FEWEST_TURNS = 3  # that make a run: two ways there and two back
PASSING = 1.1  # as much more an anti-palindrome spans: what just passes a symmetric posture is like one
MET = 0.85  # of a way, that a turn reaches into the next at least
MET_IN_CYCLE = 0.4  # the same, where cycles tell of both


class Form(NamedTuple):
    """A run of cycles, or of ways between turns."""

    marks: tuple[int, ...]
    """Waypoints: the first, where each cycle, half-cycle or way begins, and the last."""
    moments: tuple[int, ...]
    """When the body is there; of a turn, the middle of the time between the same posture before and after."""
    mirror: bool
    reversed: bool
    cost: float
    """Mean distance along its signals, over what is alike."""
    covered: float
    """Share of it that its signals tell."""
    extent: float
    """What its postures span, over what is alike."""

    @property
    def first(self) -> int:
        """First waypoint."""
        return self.marks[0]

    @property
    def last(self) -> int:
        """Last waypoint."""
        return self.marks[-1]

    @property
    def way(self) -> float:
        """Waypoints of a cycle, a half-cycle or a way between turns."""
        return float(np.median(np.diff(self.marks)))


def runs_of_cycles(
    signals: Sequence[Signal], waypoints: Waypoints, *, within: Sequence[Form] = ()
) -> list[Form]:
    """Tell runs of cycles from forward signals whose two stretches join, of half-cycles from those in D*.

    Parameters
    ----------
    signals : sequence of Signal
        Forward, all of D or all of D*.
    waypoints : Waypoints
        K waypoints.
    within : sequence of Form
        Of half-cycles, the runs of cycles: one that holds whole cycles is none, but a run that is reflected.

    Returns
    -------
    list of Form
        None of which a run of shorter cycles tells the greater part.
    """
    joined = [signal for signal in signals if _joins(signal) and signal.extent >= LEAST_EXTENT]
    found: list[Form] = []
    for signal in sorted(joined, key=lambda each: float(np.median(np.diff(each.path)))):
        form = _run(signal, waypoints)
        shorter = [*found, *(run for run in within if run.way <= (1 + LARGEST_GAP) * form.way)]
        if sum(covered_by(form, run) for run in shorter) < SAME:
            found.append(form)
    return found


def runs_of_turns(signals: Sequence[Signal], waypoints: Waypoints, cycles: Sequence[Form]) -> list[Form]:
    """Tell palindromes from reversed signals that meet the identity axis, anti-palindromes from those in D*.

    Parameters
    ----------
    signals : sequence of Signal
        Reversed, all of D or all of D*.
    waypoints : Waypoints
        K waypoints.
    cycles : sequence of Form
        Runs of cycles, or in D* of half-cycles, as which turns that follow one another show as well.

    Returns
    -------
    list of Form
        Three turns or more that follow one another, with the way between two in the reach of both, are one form; of
        others each is one.
    """
    far = waypoints.first_far
    turns = sorted(
        (
            signal
            for signal in signals
            if _spans(signal, waypoints) >= LEAST_EXTENT and signal.later[0] <= far[signal.earlier[1]]
        ),
        key=_turn,
    )
    chains: list[list[Signal]] = []
    for signal in turns:
        if chains and _follows(chains[-1][-1], signal, cycles):
            chains[-1].append(signal)
        else:
            chains.append([signal])
    long = [_chain(chain, waypoints) for chain in chains if len(chain) >= FEWEST_TURNS]
    short = [_chain([signal], waypoints) for chain in chains if len(chain) < FEWEST_TURNS for signal in chain]
    return long + [form for form in short if sum(covered_by(form, run) for run in long) < SAME]


def covered_by(one: Form, other: Form) -> float:
    """Share of a form that lies in another."""
    both = min(one.last, other.last) - max(one.first, other.first)
    return max(both, 0) / max(one.last - one.first, 1)


def _joins(signal: Signal) -> bool:
    lag = float(np.median(np.diff(signal.path)))
    return signal.later[0] - signal.earlier[1] <= LARGEST_GAP * lag


def _run(signal: Signal, waypoints: Waypoints) -> Form:
    """Follow a movement from cycle to cycle along its signal."""
    earlier, later = signal.path.T
    marks = [int(earlier[0])]
    while marks[-1] <= earlier[-1]:
        marks.append(round(float(np.interp(marks[-1], earlier, later))))
    last = int(later[-1])
    if last - marks[-1] > LARGEST_GAP * (marks[-1] - marks[-2]):
        marks.append(last)
    else:
        marks[-1] = last
    covered = np.union1d(_filled(earlier), _filled(later)).size / (last - marks[0] + 1)
    moments = (waypoints.left(marks[0]), *(int(waypoints.at[mark]) for mark in marks[1:]))
    return Form(tuple(marks), moments, signal.mirror, False, signal.cost, float(covered), signal.extent)


def _filled(stretch: np.ndarray) -> np.ndarray:
    return np.arange(stretch.min(), stretch.max() + 1)


def _spans(signal: Signal, waypoints: Waypoints) -> float:
    """What a turn spans, over what is alike: one way of a palindrome, both of an anti-palindrome."""
    if not signal.mirror:
        return signal.extent
    stretch = slice(signal.earlier[0], signal.later[1] + 1)
    return float(waypoints.own[stretch, stretch].max() / waypoints.alike[stretch].mean()) / PASSING


def _turn(signal: Signal) -> float:
    return (signal.earlier[1] + signal.later[0]) / 2


def _follows(one: Signal, other: Signal, cycles: Sequence[Form]) -> bool:
    """Whether the way between two turns lies in the reach of both.

    Within a run of cycles that have such ways a part is enough, and a turn or two between them may be unseen.
    """
    here, there = _turn(one), _turn(other)
    way = there - here
    if way <= 0:
        return False
    reach = min(one.later[1] - here, there - other.earlier[0])
    for cycle in cycles:
        usual = cycle.way / (1 if one.mirror else 2)
        times = round(way / usual)
        if (
            cycle.first <= here
            and there <= cycle.last
            and 1 <= times <= FEWEST_TURNS
            and abs(way - times * usual) <= LARGEST_GAP * usual
            and reach >= MET_IN_CYCLE * usual
        ):
            return True
    return reach >= MET * way


def _chain(turns: list[Signal], waypoints: Waypoints) -> Form:
    first, last = turns[0], turns[-1]
    at = waypoints.at
    marks = [round(_turn(signal)) for signal in turns]
    turned = [int(at[signal.earlier[1]] + at[signal.later[0]]) // 2 for signal in turns]
    start, stop = first.earlier[0], last.later[1]
    if len(marks) > 1:
        marks, turned = _with_unseen(marks, turned, at)
        way = float(np.median(np.diff(marks)))
        start = max(start, round(marks[0] - OUTER * way))
        stop = min(stop, round(marks[-1] + OUTER * way))
    reached = np.zeros(stop - start + 1, bool)
    for signal in turns:
        reached[max(signal.earlier[0] - start, 0) : max(signal.later[1] - start + 1, 0)] = True
    lengths = [len(signal.path) for signal in turns]
    return Form(
        (start, *marks, stop),
        (min(waypoints.left(start), turned[0]), *turned, max(int(at[stop]), turned[-1])),
        first.mirror,
        True,
        float(np.average([signal.cost for signal in turns], weights=lengths)),
        float(reached.mean()),
        max(signal.extent for signal in turns),
    )


def _with_unseen(marks: list[int], turned: list[int], at: np.ndarray) -> tuple[list[int], list[int]]:
    """Turns with those between them that were not seen, since two lie so many ways apart."""
    ways = np.diff(marks)
    usual = float(np.quantile(ways, 0.25))
    all_marks, all_turned = marks[:1], turned[:1]
    for k, way in enumerate(ways):
        times = max(round(way / usual), 1)
        unseen = [round(marks[k] + way * n / times) for n in range(1, times)]
        all_marks += [*unseen, marks[k + 1]]
        all_turned += [*(int(at[mark]) for mark in unseen), turned[k + 1]]
    return all_marks, all_turned
