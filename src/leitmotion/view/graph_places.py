"""Where the states of a motion graph stand: the composite layout of paper S, sections 3.3 and 3.5.

Conventions
-----------
Symmetric states stand on the vertical axis, x = 0; an asymmetric one stands left of it, its mirror image, whose name
bears a star, as far to the right at the same height. A state is a card of :data:`CARD`; lengths are widths of a card,
y runs down. Rows and columns are a grid on which no two cards touch.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from functools import partial

import numpy as np

from leitmotion.discovery import MotionGraph

CARD = (1.0, 1.3)
"""Width and height of a state."""
ROW, COLUMN = 1.95, 2.05
FIRST_COLUMN = {True: 2.05, False: 1.15}  # from the axis: whether a state stands on it
TALL = 4  # asymmetric states one below another before another column is begun
EVERY_ORDER = 6  # symmetric states of which every order is tried
CROSSING, OVER_A_CARD, SHARP, LATE = 6.0, 15.0, 2.0, 0.02  # how bad, beside squared lengths of paths
CLOSE = 0.93  # cosine of the angle under which two paths at one state are hard to tell apart
STARTS = 8  # placings that are improved, of which the best is taken
ENOUGH, MOST = 4000, 8000  # placings that are weighed before no other start is made, before the search ends

Orbit = tuple[str, ...]  # a state and its mirror image, where the graph holds it
Slot = tuple[int, float]  # column and row


def place_states(graph: MotionGraph) -> dict[str, tuple[float, float]]:
    """Give each state of a graph its place.

    Paths become short, cross little and pass over no state; what was visited first stands high. The search is greedy
    and always takes the same steps.

    Parameters
    ----------
    graph : MotionGraph
        Any.

    Returns
    -------
    dict
        The middle of each state, right and down from the top of the axis.
    """
    axis = [(state.name,) for state in graph.states if state.symmetric]
    sides = _side_orbits(graph)
    if not axis and not sides:
        return {}
    rows = max(len(axis), min(len(sides), TALL), -(-len(sides) // 3))
    shift = (rows - len(axis)) / 2
    columns = -(-len(sides) // rows)
    price = _Price(graph, bool(axis))
    on_axis = {orbit: (0, row + shift) for row, orbit in enumerate(_axis_order(axis, price))}
    free = [(column, float(row)) for column in range(1, columns + 1) for row in range(rows)]
    if axis and len(sides) < rows:
        free += [(1, row + 0.5) for row in range(rows - 1)]
    found = []
    for attempt in range(STARTS if len(sides) > 1 else 1):
        order = np.random.default_rng(attempt).permutation(len(sides)) if attempt else range(len(sides))
        slots: dict[Orbit, Slot] = dict(on_axis)
        for k in order:
            fitting = [slot for slot in free if _fits(slot, slots)]
            slots[sides[k]] = min(fitting, key=lambda slot: price({**slots, sides[k]: slot}))
        found.append(_improved(slots, free, price))
        if price.asked > ENOUGH:
            break
    return price.places(min(found, key=lambda each: each[0])[1])


def _improved(
    slots: dict[Orbit, Slot], free: Sequence[Slot], price: _Price
) -> tuple[float, dict[Orbit, Slot]]:
    """Exchange states and move them elsewhere as long as that helps."""
    best, before = price(slots), np.inf
    while best < before - 1e-9 and price.asked < MOST:
        before = best
        exchanges = [
            partial(_exchanged, one=one, other=other) for one, other in itertools.combinations(slots, 2)
        ]
        moves = [partial(_moved, orbit=orbit, slot=slot) for orbit in slots for slot in free]
        for move in exchanges + moves:
            tried = move(slots)
            if tried is not None and (cost := price(tried)) < best - 1e-9:
                best, slots = cost, tried
    return best, slots


def _side_orbits(graph: MotionGraph) -> list[Orbit]:
    """Pair asymmetric states with their mirror images; the one without a star first."""
    names = {state.name for state in graph.states}
    orbits: dict[frozenset[str], Orbit] = {}
    for state in graph.states:
        if state.symmetric:
            continue
        pair = {state.name} | ({state.mirror} & names)
        orbits.setdefault(frozenset(pair), tuple(sorted(pair, key=lambda name: ("*" in name, name))))
    return list(orbits.values())


def _axis_order(axis: Sequence[Orbit], price: _Price) -> tuple[Orbit, ...]:
    """Order the symmetric states by their first visits, unless another order makes their paths shorter."""
    if len(axis) > EVERY_ORDER:
        return tuple(axis)
    orders = itertools.permutations(axis)  # begins with that of first visits
    return min(orders, key=lambda order: price({orbit: (0, row) for row, orbit in enumerate(order)}))


def _fits(slot: Slot, slots: dict[Orbit, Slot]) -> bool:
    """Whether no card of that column is less than a row away."""
    return all(column != slot[0] or abs(row - slot[1]) >= 1 for column, row in slots.values())


def _exchanged(slots: dict[Orbit, Slot], one: Orbit, other: Orbit) -> dict[Orbit, Slot] | None:
    """Exchange two states of the axis, or two beside it."""
    here, there = slots[one], slots[other]
    return {**slots, one: there, other: here} if (here[0] == 0) == (there[0] == 0) else None


def _moved(slots: dict[Orbit, Slot], orbit: Orbit, slot: Slot) -> dict[Orbit, Slot] | None:
    """Move an asymmetric state elsewhere, where there is room."""
    others = {name: taken for name, taken in slots.items() if name != orbit}
    return {**slots, orbit: slot} if slots[orbit][0] and _fits(slot, others) else None


class _Price:
    """What a placing costs, its paths as straight lines."""

    def __init__(self, graph: MotionGraph, has_axis: bool) -> None:
        self.first = FIRST_COLUMN[has_axis]
        mirror = {state.name: state.mirror for state in graph.states}
        ends = {tuple(sorted((path.source, path.target))) for path in graph.paths}
        images = {pair: tuple(sorted(mirror[name] for name in pair)) for pair in ends}
        self.pairs = sorted(  # of a path and its mirror image one
            pair
            for pair, image in images.items()
            if pair[0] != pair[1] and (image not in ends or _stars(pair) <= _stars(image))
        )
        self.asked = 0
        ends_at = [
            (k, name, way)
            for k, pair in enumerate(self.pairs)
            for name, way in zip(pair, (1, -1), strict=True)
        ]
        self.meeting = np.array([
            (k, other, way * elsewhere)
            for (k, name, way), (other, there, elsewhere) in itertools.combinations(ends_at, 2)
            if name == there
        ], dtype=int).reshape(-1, 3)  # fmt: skip
        self.order = {state.name: k for k, state in enumerate(graph.states)}

    def places(self, slots: dict[Orbit, Slot]) -> dict[str, tuple[float, float]]:
        found = {}
        for orbit, (column, row) in slots.items():
            x = self.first + (column - 1) * COLUMN if column else 0.0
            for name in orbit:
                found[name] = (x if "*" in name or not column else -x, row * ROW)
        return found

    def __call__(self, slots: dict[Orbit, Slot]) -> float:
        from leitmotion.view._layout_kernels import count_crossings, count_passed

        self.asked += 1
        places = self.places(slots)
        late = sum(
            LATE * row * (1 - self.order[orbit[0]] / len(self.order)) for orbit, (_, row) in slots.items()
        )
        known = [k for k, (a, b) in enumerate(self.pairs) if a in places and b in places]
        if not known:
            return late
        starts = np.array([places[self.pairs[k][0]] for k in known])
        ends = np.array([places[self.pairs[k][1]] for k in known])
        cards = np.array(list(places.values()))
        over = count_passed(starts, ends, cards, CARD[0] / 2, CARD[1] / 2) - 2 * len(known)
        sharp = 0
        if len(known) == len(self.pairs):
            ways = (ends - starts) / np.hypot(*(ends - starts).T)[:, None]
            one, other, sign = self.meeting.T
            sharp = int(((ways[one] * ways[other]).sum(axis=1) * sign > CLOSE).sum())
        lengths = float(((ends - starts) ** 2).sum())
        return lengths + CROSSING * count_crossings(starts, ends) + OVER_A_CARD * over + SHARP * sharp + late


def _stars(pair: tuple[str, ...]) -> tuple[int, tuple[str, ...]]:
    return sum("*" in name for name in pair), pair
