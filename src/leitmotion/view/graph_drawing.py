"""The parts of a motion graph's picture: the graph itself, and the postures of a path laid over one another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from leitmotion.body import Body
from leitmotion.discovery import MotionGraph, Path, State
from leitmotion.view.graph_layout import Layout
from leitmotion.view.graph_moments import Moment
from leitmotion.view.graph_names import arrow_of, in_math, times
from leitmotion.view.graph_places import CARD
from leitmotion.view.palette import Theme, mixed
from leitmotion.view.plots import SMALL, halo
from leitmotion.view.stick_figures import Shape, figure_shapes, paint_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

POSTURES, LIGHTEST = 7, 0.82  # of a path; how far the last one is mixed into the surface
NAME = 0.3  # of a card's height, in cards' widths, for its name
EVERY = 4  # points of an outline, of which one is drawn
ROOM = 0.9  # of a card's width for its posture
SMALLEST = 6.0  # points
FOOT = 0.26  # inches of a cell for its name
DOTTED = (0, (0.5, 2.4))


class Cast(NamedTuple):
    """Who is drawn, and how large the postures are."""

    bodies: list[Body]
    half: float
    """How far the widest posture reaches from its middle, metres."""

    reach: float
    """How far the farthest point is from the pelvis, sideways, metres."""

    low: float
    high: float
    """Lowest and highest point of all, metres."""

    def shapes(self, moment: Moment) -> list[Shape]:
        """Outline a posture, as finely as is seen at its size."""
        shapes = figure_shapes(self.bodies[moment.recording], moment.frame, mirrored=moment.mirrored)
        return [
            shape._replace(outline=shape.outline[::EVERY]) if len(shape.outline) > 4 * EVERY else shape
            for shape in shapes
        ]


def gather(bodies: list[Body], shown: Sequence[Moment]) -> Cast:
    """Measure all postures that are drawn, so that they share one scale.

    Parameters
    ----------
    bodies : list of Body
        Of each recording.
    shown : sequence of Moment
        The postures.

    Returns
    -------
    Cast
        Who is drawn.
    """
    cast = Cast(bodies, 0.5, 0.5, 0.0, 1.0)
    corners = [
        np.concatenate([shape.outline for shape in shapes])
        for shapes in (cast.shapes(moment) for moment in shown)
        if shapes
    ]
    if not corners:
        return cast
    half = max(float(np.ptp(each[:, 0])) / 2 for each in corners)
    low, high = (float(end([end(each[:, 1]) for each in corners])) for end in (np.min, np.max))
    reach = max(float(np.abs(each[:, 0]).max()) for each in corners)
    return Cast(bodies, half + 0.05, reach + 0.03, low - 0.02, high + 0.02)


def draw_graph(
    axes: Axes,
    graph: MotionGraph,
    layout: Layout,
    cast: Cast,
    pictured: dict[str, Moment | None],
    unit: float,
    colours: Theme,
) -> None:
    """Draw states and paths.

    Parameters
    ----------
    axes : Axes
        As large as the layout's box.
    graph : MotionGraph
        What is drawn.
    layout : Layout
        Where it is.
    cast : Cast
        Whose postures.
    pictured : dict
        The posture of each state.
    unit : float
        Inches a card is wide.
    colours : Theme
        Of which theme.
    """
    left, top, right, bottom = layout.box
    axes.set(xlim=(left, right), ylim=(bottom, top))
    axes.axis("off")
    size = min(SMALL, max(SMALLEST, 11.5 * unit))
    if left < 0 < right:
        axes.axvline(0, color=colours.line, lw=0.6, ls=(0, (4, 3)), zorder=0)
    if not graph.states:
        axes.text(0, 0, "no state", ha="center", va="center", fontsize=size, color=colours.ink2)
    for state in graph.states:
        _draw_state(axes, state, layout.places[state.name], cast, pictured[state.name], unit, colours)
    for path in graph.paths:
        _draw_path(axes, path, layout, unit, size, colours)


def _draw_state(
    axes: Axes,
    state: State,
    place: tuple[float, float],
    cast: Cast,
    moment: Moment | None,
    unit: float,
    colours: Theme,
) -> None:
    from matplotlib.patches import FancyBboxPatch

    (x, y), (wide, high) = place, CARD
    reflected = not state.visits
    card = FancyBboxPatch(
        (x - wide / 2 + 0.1, y - high / 2 + 0.1), wide - 0.2, high - 0.2, boxstyle="round,pad=0.1,rounding_size=0.12",
        fc=colours.surface, ec=mixed(colours.ink2, 0.55, colours.surface), lw=0.7, zorder=1,
        ls=DOTTED if reflected else "-", gid=f"state-{state.name}",
    )  # fmt: skip
    axes.add_patch(card)
    axes.text(
        x, y + high / 2 - 0.54 * NAME, f"${in_math(state)}$", ha="center", va="center",
        fontsize=min(9.5, max(SMALLEST, 13 * unit)), color=colours.ink, zorder=5,
    )  # fmt: skip
    shapes = [] if moment is None else cast.shapes(moment)
    if not shapes:
        return
    per_metre = min(ROOM / 2 / cast.half, (high - NAME - 0.1) / (cast.high - cast.low))
    across = [float(end([end(shape.outline[:, 0]) for shape in shapes])) for end in (np.min, np.max)]
    floor = y + high / 2 - NAME - 0.02 + cast.low * per_metre
    foot = (x - sum(across) / 2 * per_metre, floor)
    fade = 0.45 if reflected else 0.0
    paint_figure(
        axes, shapes, foot, (per_metre, -per_metre), 72 * unit * per_metre, colours, fade=fade, order=2
    )


def _draw_path(axes: Axes, path: Path, layout: Layout, unit: float, size: float, colours: Theme) -> None:
    from matplotlib.patches import FancyArrowPatch
    from matplotlib.path import Path as Outline

    curve = layout.curves[path.name]
    # Where there is no way round a state, a path passes behind it.
    line: dict[str, Any] = {"color": colours.ink, "lw": 0.9 * min(1, 1.6 * unit), "zorder": 0.5}
    dashes: dict[str, Any] = {"ls": DOTTED, "capstyle": "round"} if path.reflected else {}
    codes = [Outline.MOVETO, *[Outline.CURVE4] * 3]
    head = min(1.0, 1.7 * unit)
    form = f"-|>,head_width={1.9 * head},head_length={4.2 * head}"
    whole: dict[str, Any] = {"path": Outline(curve, codes), "arrowstyle": "-", "gid": f"path-{path.name}"}
    axes.add_patch(FancyArrowPatch(shrinkA=0, shrinkB=0, **whole, **line, **dashes))
    for end, before in ((3, 2), *(((0, 1),) if path.reversible else ())):
        way = (curve[end] - curve[before]) / (np.hypot(*(curve[end] - curve[before])) or 1)
        tip = Outline([curve[end] - 0.02 * way, curve[end]])
        axes.add_patch(
            FancyArrowPatch(path=tip, arrowstyle=form, mutation_scale=1, shrinkA=0, shrinkB=0, **line)
        )
    axes.text(
        *layout.labels[path.name], f"${in_math(path)}$", ha="center", va="center", fontsize=size, color=colours.ink,
        zorder=4, bbox={"boxstyle": "square,pad=0.12", "fc": colours.surface, "ec": "none"},
    )  # fmt: skip


def draw_cell(
    axes: Axes, path: Path, moments: Sequence[Moment], cast: Cast, size: tuple[float, float], colours: Theme
) -> None:
    """Draw the postures of a path over one another, lightening as time goes on.

    Parameters
    ----------
    axes : Axes
        The cell.
    path : Path
        Which.
    moments : sequence of Moment
        In order of time.
    cast : Cast
        Whose postures.
    size : (float, float)
        Of the cell, inches.
    colours : Theme
        Of which theme.
    """
    wide, high = size[0], size[1] - FOOT
    scale = min(wide / 2 / cast.reach, high / (cast.high - cast.low))  # inches a metre
    axes.set(xlim=(-wide / 2, wide / 2), ylim=(-FOOT, high))
    axes.axis("off")
    for k, moment in reversed(list(enumerate(moments))):
        fade = LIGHTEST * k / max(1, len(moments) - 1)
        foot = (0.0, -cast.low * scale)
        paint_figure(
            axes,
            cast.shapes(moment),
            foot,
            (scale, scale),
            72 * scale,
            colours,
            fade=fade,
            order=len(moments) - k,
        )
    axes.text(
        0, -0.5 * FOOT, f"${in_math(path)}$ {arrow_of(path)}  {times(len(path.visits))}", ha="center", va="center",
        fontsize=SMALL, color=colours.ink2, path_effects=halo(colours, 2)["path_effects"],
    )  # fmt: skip
