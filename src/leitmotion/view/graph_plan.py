"""How the picture of a motion graph is divided: the graph, the two subspaces and the cells of the paths on one sheet.

Conventions
-----------
Inches from the top left, y down; what is handed out are shares of the figure from the bottom left, as matplotlib has
them. A graph that is narrow stands left of all else, a wide one above it; the cells fill what is free, row by row.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

LARGEST, LEAST = 0.78, 0.45  # inches that a state is wide
HIGHEST = 6.6  # inches of a graph, unless its states would be smaller than the least
NARROW = 0.45  # share of the width that a graph takes beside which all else stands
GAP, EDGE, TITLE = 0.22, 0.1, 0.2
LARGER = (1.7, 1.5, 1.3, 1.15)  # times the usual that plots and cells may be beside a tall graph

Box = tuple[float, float, float, float]


class Sizes(NamedTuple):
    """Inches of what stands beside a graph."""

    plot: float = 1.75
    """Width and height of a subspace."""
    wide: float = 1.02
    high: float = 1.3
    """Of the cell of a path."""

    def times(self, factor: float) -> Sizes:
        """Enlarge all."""
        return Sizes(*(factor * length for length in self))

    def across(self, room: float) -> int:
        """How many cells stand side by side."""
        return max(0, int(room / self.wide + 0.02))


class Plan(NamedTuple):
    """Where the parts stand."""

    height: float
    """Of the figure, inches."""
    unit: float
    """Inches that a state is wide."""
    sizes: Sizes
    graph: Box
    plots: list[Box]
    cells: list[Box]


def plan_picture(box: Box, width: float, *, head: float, subspaces: bool, cells: int) -> Plan:
    """Divide a figure.

    Parameters
    ----------
    box : (float, float, float, float)
        Left, top, right and bottom of the graph, in cards' widths.
    width, head : float
        Of the figure and of what is written above, inches.
    subspaces : bool
        Whether the two subspaces are drawn.
    cells : int
        How many paths are shown as postures.

    Returns
    -------
    Plan
        No two parts touch.
    """
    left, top, right, bottom = box
    wide, high = right - left, bottom - top
    unit = min(LARGEST, (width - 2 * EDGE) / wide, max(LEAST, HIGHEST / high))
    wide, high = wide * unit, high * unit
    y = EDGE + head + GAP
    if wide > NARROW * width:
        graph = ((width - wide) / 2, y, wide, high)
        plots, placed = _fill(width, graph, (EDGE, y + high + GAP), Sizes(), subspaces, cells)
        return _plan(width, unit, Sizes(), graph, plots, placed)
    graph = (EDGE, y, wide, high)
    for sizes in (*(Sizes().times(factor) for factor in LARGER), Sizes()):
        plots, placed = _fill(width, graph, (EDGE + wide + GAP, y), sizes, subspaces, cells)
        parts = [*plots, *placed]
        if all(x + w <= width and y + h <= graph[1] + high + EDGE for x, y, w, h in parts):
            break
    beside = max((part[1] + part[3] for part in plots), default=0.0)
    graph = (EDGE, y + max(0.0, beside - y - high) / 2, wide, high)
    return _plan(width, unit, sizes, graph, plots, placed)


def _plan(width: float, unit: float, sizes: Sizes, graph: Box, plots: list[Box], cells: list[Box]) -> Plan:
    height = max(part[1] + part[3] for part in (graph, *plots, *cells)) + EDGE

    def share(part: Box) -> Box:
        x, y, wide, high = part
        return x / width, 1 - (y + high) / height, wide / width, high / height

    return Plan(
        height, unit, sizes, share(graph), [share(part) for part in plots], [share(part) for part in cells]
    )


def _fill(
    width: float, graph: Box, corner: tuple[float, float], sizes: Sizes, subspaces: bool, cells: int
) -> tuple[list[Box], list[Box]]:
    """Place the subspaces and then the cells."""
    x, y = corner
    plots = [
        (x + k * (sizes.plot + GAP), y + TITLE, sizes.plot, sizes.plot) for k in range(2 if subspaces else 0)
    ]
    placed: list[Box] = []
    for left, top, wide, high in _zones(width, graph, plots, corner, sizes, cells):
        across, down = sizes.across(wide), max(0, int(high / sizes.high + 1e-6))
        for k in range(min(across * down, cells - len(placed))):
            place = left + k % across * sizes.wide, top + k // across * sizes.high
            placed.append((*place, sizes.wide, sizes.high))
    return plots, placed


def _zones(
    width: float, graph: Box, plots: list[Box], corner: tuple[float, float], sizes: Sizes, cells: int
) -> Iterator[Box]:
    """Give what is free, in reading order: beside the subspaces, beneath them beside the graph, beneath all."""
    x, bottom = corner
    end = graph[1] + graph[3] + GAP
    narrow = x > graph[0]
    if plots:
        after = plots[-1][0] + sizes.plot + GAP
        across = sizes.across(width - EDGE - after)
        rows = 1 if narrow or cells <= across else 2
        yield after, bottom, width - EDGE - after, rows * sizes.high
        bottom += max(TITLE + sizes.plot + GAP, rows * sizes.high if cells and across else 0.0)
    if narrow:
        yield x, bottom, width - EDGE - x, end - bottom
        bottom = max(bottom, end)
    yield EDGE, bottom, width - 2 * EDGE, 1e9
