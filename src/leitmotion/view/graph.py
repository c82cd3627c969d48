"""The picture of a motion graph: composite layout, subspaces and postures (paper S, figures 64 to 71).

Conventions
-----------
All is ink. A state is a card with its posture and its name, a path an arrow with its name: two-headed where it was gone
both ways, dotted where only reflection made it. Each path is shown once more as a cell in which its postures lie over
one another, lightening as time goes on. Postures are turned to one direction and seen in one scale.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from leitmotion.body import Body, BodyMap, embody
from leitmotion.discovery import MotionGraph, Path, State
from leitmotion.features import FeatureSequence, kinematic_chain
from leitmotion.motion import Motion, ParameterError, Trajectories
from leitmotion.view.graph_drawing import POSTURES, draw_cell, draw_graph, gather
from leitmotion.view.graph_layout import lay_out
from leitmotion.view.graph_moments import posture_of, time_of
from leitmotion.view.graph_names import arrow_of, in_math, in_rows
from leitmotion.view.graph_plan import EDGE, plan_picture
from leitmotion.view.graph_visited import most_visited, shown_of
from leitmotion.view.palette import theme_named
from leitmotion.view.plots import BODY, new_figure
from leitmotion.view.subspaces import plot_subspaces

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LETTERS = 12  # of the notation in an inch
LINE = 0.2  # inches a row of it is high


def plot_graph(
    graph: MotionGraph,
    recordings: Sequence[Motion | Trajectories | Body] | Motion | Trajectories | Body,
    *,
    body_maps: Sequence[BodyMap | None] | None = None,
    subspaces: bool = True,
    postures: bool = True,
    theme: str = "light",
    width: float = 7.5,
) -> Figure:
    """Draw a motion graph as paper S does.

    Parameters
    ----------
    graph : MotionGraph
        States and paths.
    recordings : sequence of Motion, Trajectories or Body, or one of these
        What the graph is of, in the order of its recordings, at their own rates.
    body_maps : sequence of BodyMap or None, optional
        Which joints or points of each recording stand for which role; by default what
        :func:`leitmotion.body.find_roles` finds.
    subspaces : bool
        Whether the symmetric and antisymmetric subspaces stand beside it.
    postures : bool
        Whether each path is shown as postures that lie over one another.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        Save it as SVG or PNG. In an SVG each state is a group with the id "state-A", each path one with "path-ab". Of a
        graph of more than 20 states or 24 paths those are drawn that were visited most, and the figure says so.

    Raises
    ------
    ParameterError
        When the recordings are not those of the graph, or the theme is unknown.
    DataError
        When a recording is planar or the joints of its trunk are unknown.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.discovery import MotionGraph, Path, State, Visit
    >>> session = compose_session(seed=0, rate=30.0)
    >>> start, stop = int(session.cycles.starts[0]), int(session.cycles.stops[0])
    >>> state = State("A", False, (Visit(0, start, start + 1),))
    >>> path = Path("aa", "A", "A", False, False, (Visit(0, start, stop),))
    >>> figure = plot_graph(MotionGraph((state,), (path,), ("session",), (30.0,), 1.0, {}), session.motion)
    >>> len(figure.axes)
    4
    """
    colours = theme_named(theme)
    given = [recordings] if isinstance(recordings, Motion | Trajectories | Body) else list(recordings)
    maps = [None] * len(given) if body_maps is None else list(body_maps)
    _check(graph, given)
    whole, graph = graph, most_visited(graph)
    layout = lay_out(graph)
    bodies = [
        each if isinstance(each, Body) else embody(each, roles)
        for each, roles in zip(given, maps, strict=True)
    ]
    chains = _chains(given, maps)
    pictured = {state.name: posture_of(state, graph, chains) for state in graph.states}
    shown = {path.name: time_of(path, graph) for path in graph.paths}
    standing = gather(bodies, [moment for moment in pictured.values() if moment])
    moving = gather(bodies, [moment for time in shown.values() if time for moment in time.moments(POSTURES)])
    heading = [*_heading(graph, width), *filter(None, [shown_of(graph, whole)])]
    cells = len(graph.paths) if postures else 0
    plan = plan_picture(layout.box, width, head=LINE * len(heading), subspaces=subspaces, cells=cells)
    figure = new_figure(width, plan.height, colours)
    for row, line in enumerate(heading):
        figure.text(
            EDGE / width,
            1 - (EDGE + LINE * row) / plan.height,
            line,
            va="top",
            fontsize=BODY,
            color=colours.ink,
        )
    draw_graph(figure.add_axes(plan.graph), graph, layout, standing, pictured, plan.unit, colours)
    if subspaces:
        plot_subspaces([figure.add_axes(place) for place in plan.plots], graph, chains, colours)
    if postures:
        for path, place in zip(graph.paths, plan.cells, strict=True):
            time = shown[path.name]
            moments = time.moments(POSTURES) if time else []
            size = (plan.sizes.wide, plan.sizes.high)
            draw_cell(figure.add_axes(place), path, moments, moving, size, colours)
    return figure


def _chains(
    given: Sequence[Motion | Trajectories | Body], maps: Sequence[BodyMap | None]
) -> list[FeatureSequence]:
    """Describe all recordings by the links that they have in common."""
    chains = [kinematic_chain(each, roles) for each, roles in zip(given, maps, strict=True)]
    common = (
        [link for link in chains[0].names if all(link in chain.names for chain in chains)] if chains else []
    )
    return [
        chain if len(chain.names) == len(common) else kinematic_chain(each, roles, links=common)
        for each, roles, chain in zip(given, maps, chains, strict=True)
    ]


def _check(graph: MotionGraph, given: Sequence[Motion | Trajectories | Body]) -> None:
    if len(given) != len(graph.recordings):
        raise ParameterError(
            f"The graph is of {len(graph.recordings)} recordings, got {len(given)}.",
            remedy="Give those that it was made of, in their order.",
        )
    items: tuple[State | Path, ...] = (*graph.states, *graph.paths)
    for item in items:
        for visit in item.visits:
            if visit.stop > len(given[visit.recording]):
                raise ParameterError(
                    f"{item.name} was visited until frame {visit.stop} of recording {visit.recording + 1}, "
                    f"which has {len(given[visit.recording])}."
                )


def _heading(graph: MotionGraph, width: float) -> list[str]:
    """Write the notation: states, then paths with their arrows, in rows."""
    if not graph.states:
        return []
    states = [f"${in_math(state)}$" for state in graph.states]
    paths = [f"${in_math(path)}$ {arrow_of(path)}" for path in graph.paths]
    room = round(width * LETTERS)
    return [
        *in_rows(states, room, [len(state.name) for state in graph.states]),
        *in_rows(paths, room, [len(path.name) + 2 for path in graph.paths]),
    ]
