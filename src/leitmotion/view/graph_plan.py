"""How the picture of a motion graph is divided: the graph, the two subspaces and the cells of the paths on one sheet.

Conventions
-----------
Inches from the top left, y down; what is handed out are shares of the figure from the bottom left, as matplotlib has
them. A graph that is narrow stands left of all else, a wide one above it; the cells fill what is free, row by row.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

LARGEST, LEAST, HIGHEST = (
    0.78,
    0.45,
    6.6,
)  # inches: width of a state, height of a graph that is not larger than least
NARROW = 0.45  # share of the width that a graph takes beside which all else stands
PLOT, TITLE, CELL = 1.75, 0.2, (1.02, 1.3)  # a subspace and its title, the cell of a path
GAP, EDGE = 0.22, 0.1

Box = tuple[float, float, float, float]


class Plan(NamedTuple):
    """Where the parts stand."""

    height: float
    """Of the figure, inches."""
    unit: float
    """Inches that a state is wide."""
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
    narrow = wide <= NARROW * width
    if narrow or not (subspaces or cells):
        graph = (EDGE, y + max(0.0, TITLE + PLOT - high) / 2 * subspaces, wide, high)
    else:
        graph = ((width - wide) / 2, y, wide, high)
    x, below = (EDGE + wide + GAP, y) if narrow else (EDGE, y + high + GAP)
    plots = [(x + k * (PLOT + GAP), below + TITLE, PLOT, PLOT) for k in range(2)] if subspaces else []
    placed = _cells(cells, _zones(width, graph, plots, narrow, (x, below), cells))
    height = max(part[1] + part[3] for part in (graph, *plots, *placed)) + EDGE

    def share(part: Box) -> Box:
        x, y, wide, high = part
        return x / width, 1 - (y + high) / height, wide / width, high / height

    return Plan(height, unit, share(graph), [share(part) for part in plots], [share(part) for part in placed])


def _zones(
    width: float, graph: Box, plots: list[Box], narrow: bool, corner: tuple[float, float], cells: int
) -> Iterator[Box]:
    """Give what is free, in reading order: beside the subspaces, beneath them beside the graph, beneath all."""
    x, y = corner
    bottom = y
    if plots:
        after = plots[-1][0] + PLOT + GAP
        across = _fitting(width - EDGE - after)
        rows = 1 if narrow or cells <= across else 2
        yield after, y, width - EDGE - after, rows * CELL[1]
        bottom = y + max(TITLE + PLOT + GAP, (rows * CELL[1] if cells and across else 0.0))
    if narrow:
        yield x, bottom, width - EDGE - x, graph[1] + graph[3] + GAP - bottom
        bottom = max(bottom, graph[1] + graph[3] + GAP)
    yield EDGE, bottom, width - 2 * EDGE, 1e9


def _cells(count: int, zones: Iterator[Box]) -> list[Box]:
    """Fill zones row by row."""
    placed: list[Box] = []
    for x, y, wide, high in zones:
        across, down = _fitting(wide), max(0, int(high / CELL[1] + 1e-6))
        for k in range(min(across * down, count - len(placed))):
            placed.append((x + k % across * CELL[0], y + k // across * CELL[1], *CELL))
    return placed


def _fitting(room: float) -> int:
    return max(0, int(room / CELL[0] + 0.02))
