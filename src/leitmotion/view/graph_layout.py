"""How a motion graph is laid out: its states in their places, its paths as curves between them (paper S, 3.3 and 3.5).

Conventions
-----------
As in :mod:`leitmotion.view.graph_places`: lengths are widths of a card, x runs right from the axis, y down. A path is a
cubic Bézier curve from card to card, four points. A symmetric path runs along the axis where it can; the mirror image
of a path is the mirror image of its curve, and of a path from a state to that state's own image, which would lie on
itself, the curve turned by half a turn about the middle between the two.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from leitmotion.discovery import MotionGraph, Path, State
from leitmotion.view.graph_places import CARD, place_states

HALF = np.divide(CARD, 2)
AIR = 0.07  # between a card and the point of an arrow
BENDS = tuple(sign * bend for bend in (0.0, 0.35, 0.55, *np.arange(0.8, 3.3, 0.16)) for sign in (1, -1))
TURNS = np.arange(16) * np.pi / 8  # where a loop may lie
LOOP, OPEN = 0.7, 0.36  # how far a loop reaches beyond its card, half the angle at which it opens
EDGE = 0.04  # around all
NEAR, TOUCH = 0.34, 0.03  # two curves closer than this are read as one, or cross
SAMPLES = np.linspace(0, 1, 41)
MIDDLE = 20  # of them
ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82)
LETTER, LINE = 0.15, 0.26  # width of a letter and height of a name
SLIM = 0.6  # of that: a star, a bracket, a subscript
OVER_A_CARD, ON_A_CURVE, ACROSS, CROWDED, TOGETHER, BEND, AWAY = 15.0, 12.0, 3.0, 1.0, 0.6, 1.0, 0.6


class Layout(NamedTuple):
    """A graph in the plane."""

    places: dict[str, tuple[float, float]]
    """The middle of each state."""

    curves: dict[str, np.ndarray]
    """(4, 2) of each path, from its source to its target."""

    labels: dict[str, tuple[float, float]]
    """Where the name of each path stands: the middle of it, upon its curve."""

    box: tuple[float, float, float, float]
    """Left, top, right and bottom of all."""


def lay_out(graph: MotionGraph) -> Layout:
    """Lay a motion graph out in the composite layout.

    Parameters
    ----------
    graph : MotionGraph
        Any.

    Returns
    -------
    Layout
        The same for the same graph.

    Examples
    --------
    >>> from leitmotion.discovery import MotionGraph, Path, State
    >>> states = State("A", False, (), "A*"), State("X", True, (), "X"), State("A*", False, (), "A")
    >>> paths = Path("ax", "A", "X", False, True, (), "(ax)*"), Path("(ax)*", "A*", "X", False, True, (), "ax")
    >>> lay_out(MotionGraph(states, paths, (), (), 1.0, {})).places
    {'X': (0.0, 0.0), 'A': (-2.05, 0.0), 'A*': (2.05, 0.0)}
    """
    places = place_states(graph)
    drawn = _Drawing(graph, places)
    for path in drawn.in_order():
        drawn.lay(path)
    labels = drawn.name_paths()
    return Layout(places, drawn.curves, labels, _box(places, drawn.curves, labels))


def points_of(curve: np.ndarray, at: np.ndarray = SAMPLES) -> np.ndarray:
    """Follow a Bézier curve.

    Parameters
    ----------
    curve : (4, 2) float
        Its points.
    at : (K,) float
        Where, 0 to 1.

    Returns
    -------
    (K, 2) float
        Points on it.
    """
    t = np.asarray(at)[:, None]
    a, b, c, d = curve
    return np.asarray((1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d)


class _Drawing:
    """A graph whose paths are laid one after another, each where it disturbs the others least."""

    def __init__(self, graph: MotionGraph, places: dict[str, tuple[float, float]]) -> None:
        self.paths = {path.name: path for path in graph.paths}
        self.states: dict[str, State] = {state.name: state for state in graph.states}
        self.places = places
        self.cards = np.array(list(places.values())).reshape(-1, 2)
        self.curves: dict[str, np.ndarray] = {}
        self.laid: dict[str, np.ndarray] = {}

    def in_order(self) -> Iterator[Path]:
        """Give one of each path and its image: symmetric ones first, then short ones, loops last."""

        def rank(path: Path) -> tuple[bool, bool, float, bool]:
            apart = np.hypot(*np.subtract(self.places[path.source], self.places[path.target]))
            return path.source == path.target, not path.symmetric, round(float(apart), 6), "*" in path.name

        done = set()
        for path in sorted(self.paths.values(), key=rank):
            if path.name not in done:
                done |= {path.name, path.mirror}
                yield path

    def lay(self, path: Path) -> None:
        """Choose a path's curve, and with it that of its mirror image."""
        best = min(self._choices(path), key=lambda choice: choice[0] + self._trouble(path, choice[1]))
        for name, curve in self._with_image(path, best[1]).items():
            self.curves[name] = curve
            self.laid[name] = points_of(curve)

    def _choices(self, path: Path) -> Iterator[tuple[float, np.ndarray]]:
        """Give curves with what each costs by itself."""
        a, b = np.array(self.places[path.source]), np.array(self.places[path.target])
        if path.source == path.target:
            for turn in TURNS:
                edge = min(
                    half / max(abs(way), 1e-9)
                    for half, way in zip(HALF, (np.cos(turn), np.sin(turn)), strict=True)
                )
                far = 4 / 3 * (edge + LOOP) / np.cos(OPEN)
                reach = [far * np.array([np.cos(turn + side), np.sin(turn + side)]) for side in (-OPEN, OPEN)]
                yield (
                    AWAY * self._astray(path, turn),
                    _between_cards(np.array([a, a + reach[0], a + reach[1], a])),
                )
            return
        along = b - a
        left = np.array([along[1], -along[0]]) / np.hypot(
            *along
        )  # of someone who walks the path, y being down
        for bend in BENDS:
            if not self._fitting(path, bend * left[0]):
                continue
            inner = [a + along * part + left * bend * 4 / 3 for part in (0.3, 0.7)]
            yield BEND * abs(bend), _between_cards(np.array([a, *inner, b]))

    def _fitting(self, path: Path, aside: float) -> bool:
        """Whether a path between two symmetric states bends to its side: none but a symmetric one is straight."""
        ends = self.states[path.source], self.states[path.target]
        if not all(state.symmetric for state in ends) or path.symmetric:
            return True
        return aside > 0.01 if "*" in path.name else aside < -0.01

    def _astray(self, path: Path, turn: float) -> float:
        """How far a loop is from where it belongs: on the axis up or down, outward beside it, 0 to 2."""
        x = self.places[path.source][0]
        if path.symmetric and x == 0:
            return 1 - abs(np.sin(turn)) + 0.01 * (np.sin(turn) > 0)
        outward = np.sign(x) or (1.0 if "*" in path.name else -1.0)
        return 1 - float(outward * np.cos(turn)) + 0.01 * (np.sin(turn) > 0.01)

    def _with_image(self, path: Path, curve: np.ndarray) -> dict[str, np.ndarray]:
        """Give a path's curve and that of its mirror image."""
        image = self.paths.get(path.mirror)
        if image is None or image.name == path.name:
            return {path.name: curve}
        source = self.states[path.source]
        on_itself = path.target == source.mirror and not source.symmetric
        other = [0.0, 2 * self.places[path.source][1]] - curve if on_itself else curve * [-1.0, 1.0]
        to_source, to_target = (
            float(np.hypot(*(other[0] - self.places[end]))) for end in (image.source, image.target)
        )
        return {path.name: curve, image.name: other if to_source <= to_target else other[::-1]}

    def _trouble(self, path: Path, curve: np.ndarray) -> float:
        """How much a curve and its image hide, cross and crowd."""
        from leitmotion.view._layout_kernels import crowd

        trouble = 0.0
        fresh = {name: points_of(each) for name, each in self._with_image(path, curve).items()}
        for name, points in fresh.items():
            own = [self.places[self.paths[name].source], self.places[self.paths[name].target]]
            others = np.array([card for card in self.places.values() if card not in own]).reshape(-1, 2)
            over = (np.abs(points[:, None] - others) < HALF + AIR).all(axis=2)
            trouble += OVER_A_CARD * over.any(axis=0).sum() + over.sum() / len(points)
            trouble += CROWDED * sum(
                _names_touch(name, points[MIDDLE], other, there[MIDDLE]) for other, there in self.laid.items()
            )
            beside = np.array(
                [*self.laid.values(), *(each for other, each in fresh.items() if other != name)]
            )
            if len(beside):
                tips = beside[:, [0, -1]].reshape(-1, 1, 2) - points[[0, -1]]
                trouble += TOGETHER * (np.hypot(*tips.T) < AIR).sum()
                close, touched = crowd(points, beside, NEAR, TOUCH, 4, 6)
                trouble += ON_A_CURVE * close + ACROSS * touched
        return float(trouble) / len(fresh)

    def name_paths(self) -> dict[str, tuple[float, float]]:
        """Put each name upon its curve, where it covers least; an image's name at the image of the place."""
        labels: dict[str, tuple[float, float]] = {}

        def covered(spot: dict[str, tuple[float, float]]) -> float:
            return sum(self._covers(name, place, labels) for name, place in spot.items())

        for path in self.in_order():
            spots = [self._spots(path, at) for at in ALONG]
            best: dict[str, tuple[float, float]] = min(spots, key=covered)
            labels.update(best)
        return labels

    def _spots(self, path: Path, at: float) -> dict[str, tuple[float, float]]:
        """Give the place on a path's curve and its image."""
        place = points_of(self.curves[path.name], np.array([at]))
        there = self._with_image(path, np.repeat(place, 4, axis=0))
        return {name: (float(point[0, 0]), float(point[0, 1])) for name, point in there.items()}

    def _covers(self, name: str, at: tuple[float, float], labels: dict[str, tuple[float, float]]) -> float:
        half = np.array([name_width(name), LINE]) / 2
        card = (np.abs(self.cards - at) < half + HALF).all(axis=1).sum()
        names = sum(_names_touch(name, at, other, there) for other, there in labels.items())
        curves = sum(
            bool((np.abs(points - at) < half + 0.03).all(axis=1).any())
            for other, points in self.laid.items()
            if other != name
        )
        return float(10 * card + 10 * names + 2 * curves)


def name_width(name: str) -> float:
    """How wide a name is written."""
    return LETTER * sum(SLIM if letter in "*()0123456789" else 1.0 for letter in name) + 0.06


def _names_touch(name: str, at: ArrayLike, other: str, there: ArrayLike) -> bool:
    room = np.array([name_width(name) + name_width(other), 2 * LINE]) / 2
    return bool((np.abs(np.subtract(at, there)) < room).all())


def _between_cards(curve: np.ndarray) -> np.ndarray:
    """Cut a curve from the middle of one card to that of another where it leaves the one and enters the other."""
    t = np.linspace(0, 1, 401)
    points = points_of(curve, t)
    half = HALF + AIR
    from_source = (np.abs(points - curve[0]) <= half).all(axis=1)
    from_target = (np.abs(points - curve[3]) <= half).all(axis=1)
    outside = np.flatnonzero(~from_source & ~from_target)
    if not len(outside):
        return curve
    return _part(curve, t[outside[0]], t[outside[-1]])


def _part(curve: np.ndarray, start: float, stop: float) -> np.ndarray:
    """Give the part of a Bézier curve between two of its moments (de Casteljau)."""
    a, b, c, d = curve

    def blossom(u: float, v: float, w: float) -> np.ndarray:
        ab, bc, cd = a + (b - a) * u, b + (c - b) * u, c + (d - c) * u
        abc, bcd = ab + (bc - ab) * v, bc + (cd - bc) * v
        return np.asarray(abc + (bcd - abc) * w)

    return np.array([
        blossom(start, start, start), blossom(start, start, stop), blossom(start, stop, stop), blossom(stop, stop, stop)
    ])  # fmt: skip


def _box(
    places: dict[str, tuple[float, float]],
    curves: dict[str, np.ndarray],
    labels: dict[str, tuple[float, float]],
) -> tuple[float, float, float, float]:
    corners = [np.outer([-1, 1], HALF) if not places else np.zeros((1, 2))]
    for place in places.values():
        corners.append(np.add(place, np.outer([-1, 1], HALF + EDGE)))
    corners += [points_of(curve) for curve in curves.values()]
    for name, place in labels.items():
        corners.append(np.add(place, np.outer([-1, 1], [name_width(name) / 2, LINE / 2])))
    told = np.concatenate(corners)
    (left, top), (right, bottom) = told.min(axis=0), told.max(axis=0)
    return float(left), float(top), float(right), float(bottom)
