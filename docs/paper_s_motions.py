"""Figures 64 to 71 of paper S, remade: the worked motions as Z/Z* with their states and as motion graphs, and strikes.

Composed motions vary as those of the benchmarks do, but for short dwells; the real ones stand beside what they do not
show.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

import leitmotion as lm
from leitmotion.body import embody
from leitmotion.datasets import Variation, compose_motif
from leitmotion.discovery import MotionGraph
from leitmotion.features import kinematic_chain
from leitmotion.motion import Motion
from leitmotion.similarity import axis_speed
from leitmotion.view.graph_drawing import POSTURES, draw_cell, draw_graph, gather
from leitmotion.view.graph_layout import lay_out
from leitmotion.view.graph_moments import posture_of, time_of
from leitmotion.view.graph_names import arrow_of, in_math, in_rows
from leitmotion.view.palette import THEMES
from leitmotion.view.symmetry import BLACK, symmetry_image
from recordings import locate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LIGHT = THEMES["light"]
SMALL, BODY = 7.5, 9.0
SQUARE, BESIDE, WIDTH = 3.15, 0.55, 7.4  # inches: a worked motion's plot, the letters beside it, its figure
CARD, LEAST_CARD, CELL = 0.62, 0.5, (0.84, 1.06)  # inches: how wide a state is, how large the cell of a path
LINE, LETTER = 0.2, 0.115  # inches: a row of the notation, a letter beside the plot
KATA, NEAR = "cmu_amc/135_06-martialArts.amc", 0.5  # seconds to either side of a strike
VARIED = Variation(dwell_s=(0.0, 0.3))
MOTIONS = {
    "s-64-butterfly": "butterfly",
    "s-65-jumping-jacks": "jumping jacks",
    "s-66-jogging": "jogging in place",
    "s-67-walking": "walking",
    "s-68-limping": "limping",
    "s-69-side-kicks": "side kicks",
    "s-70-sun-salutation": "sun salutation",
}
"""Figures of composed motions."""
RECORDINGS = {
    "s-65-jumping-jacks-real": "mocap6/13_29.amc[0s:4s]",
    "s-66-jogging-real": "mocap6/13_31.amc[13.7s:16s]",
    "s-67-walking-real": "cmu_amc/cmu_amc_pack.tar.xz/16/16_22.amc",
    "s-69-side-kicks-real": "cmu_amc/cmu_amc_pack.tar.xz/135/135_11.amc",
}
"""Figures of real ones."""


def worked(name: str) -> Figure:
    """Figures 64 to 70: Z/Z* with its states, and the composite graph with its notation and paths."""
    motion = composed(name) if name in MOTIONS.values() else lm.read(locate(name))
    return draw_worked(motion, lm.motion_graph(motion))


def composed(name: str) -> Motion:
    """Compose a motion as it is shown."""
    return compose_motif(name, variation=VARIED).motion


def draw_worked(motion: Motion, graph: MotionGraph) -> Figure:
    """Draw a motion beside its graph."""
    layout, body, chain = lay_out(graph), embody(motion), kinematic_chain(motion)
    left, top, right, bottom = layout.box
    side = max(SQUARE, min(CARD * (bottom - top), WIDTH - BESIDE - CARD * (right - left) - 0.2))
    room = WIDTH - side - BESIDE - 0.1
    fitting = (side - 2 * LINE - CELL[1]) / (bottom - top)
    beside = fitting >= LEAST_CARD and CELL[0] * len(graph.paths) <= room
    heading = _heading(graph, room if beside else WIDTH)
    head = LINE * len(heading) + 0.1
    unit = min(CARD, room / (right - left), fitting if beside else CARD)
    wide, deep = unit * (right - left), unit * (bottom - top)
    low = LINE if beside else head + LINE
    tall = max(low + side, head + deep)
    high = tall if beside else tall + 0.3 + CELL[1]
    figure = new_figure(WIDTH, high)
    x = side + BESIDE
    _square(figure.add_axes(inches((0.05, high - side - low, side, side), figure)), motion, graph, side)
    for row, line in enumerate(heading):
        place = (x if beside else 0.05) / WIDTH, 1 - (0.04 + LINE * row) / high
        figure.text(*place, line, va="top", fontsize=BODY, color=LIGHT.ink)
    pictured = {state.name: posture_of(state, graph, [chain]) for state in graph.states}
    shown = {path.name: time_of(path, graph) for path in graph.paths}
    standing = gather([body], [moment for moment in pictured.values() if moment])
    moving = gather([body], [moment for time in shown.values() if time for moment in time.moments(POSTURES)])
    free = tall - head - deep - (CELL[1] if beside else 0.0)
    place = x + (room - wide) / 2, high - head - deep - free / 2, wide, deep
    draw_graph(figure.add_axes(inches(place, figure)), graph, layout, standing, pictured, unit, LIGHT)
    apart = min(1.1, (room if beside else WIDTH - 0.1) / max(1, len(graph.paths)))
    first = x + (room - apart * len(graph.paths)) / 2 if beside else 0.05
    for k, path in enumerate(graph.paths):
        place = first + (k + 0.5) * apart - CELL[0] / 2, 0.0, *CELL
        time = shown[path.name]
        moments = time.moments(POSTURES) if time else []
        draw_cell(figure.add_axes(inches(place, figure)), path, moments, moving, CELL, LIGHT)
    return figure


def kata() -> Figure:
    """Figure 71: a karate form, its strikes, and three of them near at hand."""
    motion = lm.read(locate(KATA))
    return draw_strikes(motion, lm.find_symmetry(motion).strikes / motion.rate)


def draw_strikes(motion: Motion, strikes: np.ndarray) -> Figure:
    """Draw Z and Z* of a motion, its strikes (N,) in seconds, its speed, and the three strikes that come fastest."""
    double = lm.compare_with_mirror(motion).distances
    seconds, image = len(double) / double.rate, symmetry_image(double)
    figure = new_figure(WIDTH, SQUARE + LINE + 0.05)
    square = figure.add_axes(inches((0.05, 0.05, SQUARE, SQUARE), figure))
    draw_image(square, image, (0, seconds, seconds, 0))
    square.plot(strikes, strikes, "o", ms=3.0, color="white", mec=BLACK, mew=0.5)
    square.set_title(f"0 to {seconds:.0f} s", loc="left", fontsize=SMALL, color=LIGHT.ink2, pad=3)
    left = SQUARE + 0.3
    room = WIDTH - left - 0.05
    curve = figure.add_axes(inches((left, 1.85, room, 1.2), figure))
    speed = np.degrees(axis_speed(double))
    time = (np.arange(len(double)) + 0.5) / double.rate
    curve.fill_between(time, speed, color=LIGHT.ink2, alpha=0.25, lw=0)
    curve.plot(strikes, np.full(len(strikes), -0.05 * speed.max()), "^", ms=4, color=LIGHT.ink, clip_on=False)
    curve.set(xlim=(0, seconds), ylim=(0, None), xticks=[], yticks=[])
    curve.spines[["top", "left", "right"]].set_visible(False)
    curve.set_title(
        "how thin the identity axis is; strikes", loc="left", fontsize=SMALL, color=LIGHT.ink2, pad=3
    )
    fastest = sorted(strikes, key=lambda at: -speed[max(0, int((at - 0.2) * double.rate)) :][:6].max())[:3]
    side = (room - 0.2) / 3
    for k, at in enumerate(sorted(fastest)):
        axes = figure.add_axes(inches((left + k * (side + 0.1), 0.25, side, side), figure))
        draw_image(axes, image, (0, seconds, seconds, 0))
        axes.images[0].set_interpolation("bilinear")
        axes.set(xlim=(at - NEAR, at + NEAR), ylim=(at + NEAR, at - NEAR))
        axes.set_title(f"{at:.1f} s", loc="left", fontsize=SMALL, color=LIGHT.ink2, pad=3)
    return figure


def _heading(graph: MotionGraph, room: float) -> list[str]:
    states = [f"${in_math(state)}$" for state in graph.states]
    paths = [f"${in_math(path)}$ {arrow_of(path)}" for path in graph.paths]
    letters = round(room * 12)
    return [
        *in_rows(states, letters, [len(state.name) for state in graph.states]),
        *in_rows(paths, letters, [len(path.name) + 2 for path in graph.paths]),
    ]


def _square(axes: Axes, motion: Motion, graph: MotionGraph, side: float) -> None:
    """Draw Z and Z*; to the right of it stands which state is visited when."""
    double = lm.compare_with_mirror(motion).distances
    seconds = len(double) / double.rate
    draw_image(axes, symmetry_image(double), (0, seconds, seconds, 0))
    visits = sorted(
        ((visit.start + visit.stop) / 2 / motion.rate, in_math(state))
        for state in graph.states
        for visit in state.visits
    )
    times, apart = np.array([at for at, _ in visits]), LETTER / side * seconds
    for at, letter, (_, name) in zip(times, spread(times, apart, seconds - apart / 3), visits, strict=True):
        knee, end = seconds * (1 + 0.04 / side), seconds * (1 + 0.1 / side)
        line: dict[str, Any] = {"lw": 0.35, "clip_on": False}
        axes.plot([at, seconds], [at, at], color="white", alpha=0.75, **line)
        axes.plot([seconds, knee, end], [at, at, letter], color=LIGHT.ink2, **line)
        axes.plot([at], [at], "o", ms=2.0, color="white", mec=BLACK, mew=0.4)
        axes.text(end, letter, f"${name}$", va="center", fontsize=SMALL, color=LIGHT.ink)
    axes.set(xlim=(0, seconds), ylim=(seconds, 0))
    axes.set_title(f"0 to {seconds:.0f} s", loc="left", fontsize=SMALL, color=LIGHT.ink2, pad=3)


def spread(at: np.ndarray, apart: float, end: float) -> np.ndarray:
    """Move sorted places (N,) until each two are so far apart, none beyond the end if there is room."""
    steps = np.arange(len(at)) * apart
    least = np.maximum.accumulate(at - steps) + steps
    most = end - steps[::-1]
    return np.minimum.accumulate(np.minimum(least, most)[::-1] + steps)[::-1] - steps[::-1]


def draw_image(axes: Axes, image: np.ndarray, extent: Sequence[float]) -> None:
    axes.imshow(image, extent=extent, aspect="auto", interpolation="antialiased")
    axes.set(xticks=[], yticks=[])
    for spine in axes.spines.values():
        spine.set_visible(False)


def inches(place: tuple[float, float, float, float], figure: Figure) -> tuple[float, float, float, float]:
    """Inches from the bottom left as shares of a figure."""
    wide, high = figure.get_size_inches()
    return place[0] / wide, place[1] / high, place[2] / wide, place[3] / high


def new_figure(width: float, height: float) -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), facecolor=LIGHT.surface)


FIGURES: dict[str, Any] = {
    figure: partial(worked, name) for figure, name in (MOTIONS | RECORDINGS).items()
} | {"s-71-kata": kata}
