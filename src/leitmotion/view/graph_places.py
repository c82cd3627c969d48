"""Where the states of a motion graph stand: the composite layout of paper S, sections 3.3 and 3.5.

Conventions
-----------
Symmetric states stand on the vertical axis, x = 0; an asymmetric one stands left of it, its mirror image, whose name
bears a star, as far to the right at the same height. A state is a card of :data:`CARD`; lengths are widths of a card,
y runs down. Rows and columns are a grid on which no two cards touch.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

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
    for attempt in range(STARTS):
        order = np.random.default_rng(attempt).permutation(len(sides)) if attempt else range(len(sides))
        slots: dict[Orbit, Slot] = dict(on_axis)
        for k in order:
            fitting = [slot for slot in free if _fits(slot, slots)]
            slots[sides[k]] = min(fitting, key=lambda slot: price({**slots, sides[k]: slot}))
        found.append(_improved(slots, free, price))
        if len(sides) < 2:
            break
    return price.places(min(found, key=lambda each: each[0])[1])


def _improved(
    slots: dict[Orbit, Slot], free: Sequence[Slot], price: _Price
) -> tuple[float, dict[Orbit, Slot]]:
    """Take the best move as long as there is one that helps."""
    best = price(slots)
    while True:
        moved = min(((price(other), k, other) for k, other in enumerate(_moves(slots, free))), default=None)
        if moved is None or moved[0] > best - 1e-9:
            return best, slots
        best, _, slots = moved


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


def _moves(slots: dict[Orbit, Slot], free: Sequence[Slot]) -> Iterator[dict[Orbit, Slot]]:
    """Exchange two states, or move an asymmetric one elsewhere."""
    for a, b in itertools.combinations(slots, 2):
        if (slots[a][0] == 0) == (slots[b][0] == 0):
            yield {**slots, a: slots[b], b: slots[a]}
    for orbit, (column, _) in slots.items():
        others = {name: slot for name, slot in slots.items() if name != orbit}
        if column:
            yield from ({**slots, orbit: slot} for slot in free if _fits(slot, others))


class _Price:
    """What a placing costs, its paths as straight lines."""

    def __init__(self, graph: MotionGraph, has_axis: bool) -> None:
        self.first = FIRST_COLUMN[has_axis]
        ends = {tuple(sorted((path.source, path.target))) for path in graph.paths}
        self.pairs = sorted((a, b) for a, b in ends if a != b)
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
        places = self.places(slots)
        late = sum(
            LATE * row * (1 - self.order[orbit[0]] / len(self.order)) for orbit, (_, row) in slots.items()
        )
        known = [k for k, (a, b) in enumerate(self.pairs) if a in places and b in places]
        if not known:
            return late
        starts = np.array([places[self.pairs[k][0]] for k in known])
        ends = np.array([places[self.pairs[k][1]] for k in known])
        over = int(_passing(starts, ends, np.array(list(places.values()))).sum()) - 2 * len(known)
        sharp = 0
        if len(known) == len(self.pairs):
            ways = (ends - starts) / np.hypot(*(ends - starts).T)[:, None]
            one, other, sign = self.meeting.T
            sharp = int(((ways[one] * ways[other]).sum(axis=1) * sign > CLOSE).sum())
        lengths = float(((ends - starts) ** 2).sum())
        return lengths + CROSSING * _crossings(starts, ends) + OVER_A_CARD * over + SHARP * sharp + late


def _crossings(starts: np.ndarray, ends: np.ndarray) -> int:
    """Count the pairs of lines that cross within both."""

    def side(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
        (ax, ay), (bx, by), (cx, cy) = (np.moveaxis(each, -1, 0) for each in (a, b, c))
        return np.asarray(np.sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)))

    a, b = starts[:, None], ends[:, None]
    parted = side(a, b, starts[None]) * side(a, b, ends[None])
    return int(((parted < 0) & (parted.T < 0)).sum()) // 2


def _passing(starts: np.ndarray, ends: np.ndarray, cards: np.ndarray) -> np.ndarray:
    """Tell which straight lines pass over which cards, their own at both ends among them: (P, N)."""
    lines = starts[:, None] + np.linspace(0, 1, 24)[:, None] * (ends - starts)[:, None]
    off = np.abs(lines[:, None] - cards[None, :, None])
    return np.asarray((off < np.divide(CARD, 2)).all(axis=-1).any(axis=-1))
