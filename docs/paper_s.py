"""The figures of paper S, remade: each motif of the taxonomy composed and real, and the seven worked motions.

As in the thesis Z is red and Z* cyan, added on black. A triangle stands on its identity axis, on which time runs to the
right; two moments meet above the middle between them. Brackets beneath it are what :func:`leitmotion.find_symmetry`
tells: a dashed one is where the motif is and was not told.
"""

from __future__ import annotations

from functools import cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import paper_s_motions
from paper_s_motions import BODY, KATA, LIGHT, SMALL, WIDTH, draw_image, inches, new_figure

import leitmotion as lm
from leitmotion.body import Body, embody
from leitmotion.comparing import Mirrored
from leitmotion.datasets import Action, compose, compose_motif
from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.motion import Motion
from leitmotion.view.stick_figures import figure_shapes, paint_figure
from leitmotion.view.symmetry import _turned, symmetry_image
from recordings import locate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

CMU = "cmu_amc/cmu_amc_pack.tar.xz"
KICK = "one side kick"
BASE, FIGURES_HIGH = 2.7, 0.56  # inches: a triangle's identity axis, the postures beneath it
SHOWN = 7  # postures beneath a triangle
Span = tuple[float, float]


class Case(NamedTuple):
    """A stretch of a motion that has a motif."""

    source: str
    """A composed motion or a recording, by name."""
    shown: Span
    """What is drawn, seconds."""
    at: Span
    """Where the motif is."""
    partner: Span | None = None
    """Of a paired motif, where it is again."""
    alone: bool = False
    """Whether no more than what is drawn is looked at."""


class Seen(NamedTuple):
    """What is told of a motion."""

    motion: Motion
    body: Body
    mirrored: Mirrored
    symmetry: Symmetry


CASES: dict[str, tuple[Case, Case]] = {
    "stillness": (
        Case("sun salutation", (8.2, 11.9), (10.0, 11.2)),
        Case("cmu86/86_01.amc", (29.4, 33.4), (30.95, 31.85)),
    ),
    "state_repetition": (
        Case("sun salutation", (14.2, 18.8), (14.4, 15.4), (17.5, 17.8)),
        Case("mocap6/13_29.amc", (13.9, 16.4), (14.3, 14.7), (15.6, 16.0)),
    ),
    "path_repetition": (
        Case("sun salutation", (0.4, 9.4), (0.7, 3.0), (6.9, 9.2)),
        Case(KATA, (8.9, 12.7), (9.3, 10.2), (10.8, 12.3)),
    ),
    "path_reversal": (
        Case("sun salutation", (6.0, 26.6), (6.1, 12.8), (20.6, 26.4)),
        Case("cmu86/86_01.amc", (16.4, 18.4), (16.8, 17.3), (17.3, 17.8)),
    ),
    "symmetric_path": (
        Case("sun salutation", (7.0, 13.2), (0.8, 13.0)),
        Case("mocap6/13_30.amc", (10.4, 17.4), (11.6, 16.5)),
    ),
    "reflected_state_repetition": (
        Case("walking", (0.0, 0.6), (0.0, 0.1), (0.4, 0.5), alone=True),
        Case(KATA, (20.1, 22.8), (20.4, 20.7), (22.1, 22.5)),
    ),
    "reflected_path_repetition": (
        Case("side kicks", (0.0, 15.0), (0.2, 6.8), (8.2, 14.8)),
        Case(f"{CMU}/135/135_11.amc", (0.8, 19.8), (1.7, 8.3), (9.4, 19.2)),
    ),
    "symmetric_cycle": (
        Case("butterfly", (0.0, 7.5), (0.0, 7.5)),
        Case("mocap6/13_31.amc", (18.6, 22.4), (19.2, 21.8)),
    ),
    "asymmetric_cycle": (
        Case("limping", (0.0, 8.1), (0.0, 8.1)),
        Case(f"{CMU}/135/135_11.amc", (9.2, 20.0), (10.5, 19.2)),
    ),
    "symmetric_palindrome": (
        Case("jumping jacks", (0.0, 7.4), (0.0, 7.4)),
        Case("mocap6/13_29.amc", (0.0, 4.6), (0.0, 3.9)),
    ),
    "asymmetric_palindrome": (
        Case(KICK, (1.5, 4.2), (0.6, 5.1)),
        Case("mocap6/13_31.amc", (7.8, 9.9), (8.1, 9.6)),
    ),
    "anti_phase": (
        Case("walking", (0.0, 6.7), (0.0, 6.7)),
        Case(f"{CMU}/16/16_22.amc", (0.0, 2.6), (0.0, 2.6)),
    ),
    "anti_palindrome": (
        Case("jogging in place", (0.0, 6.7), (0.0, 6.7)),
        Case(f"{CMU}/135/135_11.amc", (7.4, 10.2), (8.2, 9.2)),
    ),
}  # fmt: skip
"""By motif the composed example and the real one."""


@cache
def read(source: str) -> Motion:
    """Compose or read a motion by its name."""
    if source == KICK:
        return compose([Action("still"), Action("left side kick"), Action("still")], seed=0).motion
    if "/" in source:
        return lm.read(locate(source))
    return compose_motif(source, variation=None).motion


@cache
def seen(source: str, window: Span | None = None) -> Seen:
    """Compare a motion, or a stretch of it, with its mirror image, and tell its motifs."""
    motion = read(source)
    if window:
        start, stop = (round(at * motion.rate) for at in window)
        motion = motion[start:stop]
    mirrored = lm.compare_with_mirror(motion)
    return Seen(motion, embody(motion), mirrored, lm.find_symmetry(motion, mirrored=mirrored))


def told(case: Case, motif: str) -> SymmetrySpan | None:
    """Give the span of that motif that is told where the case has it."""
    found = _seen(case).symmetry
    wanted = [case.at, *([case.partner] if case.partner else [])]
    fitting = {}
    for span in found.spans:
        if span.motif == motif:
            held = [(span.start, span.stop), *([span.partner] if span.partner else [])]
            fit = [
                _both(one, (a / found.rate, b / found.rate)) for one, (a, b) in zip(wanted, held, strict=True)
            ]
            fitting[min(fit)] = span
    best = max(fitting, default=0.0)
    return fitting[best] if best > 0 else None


def motif_figure(motif: str) -> Figure:
    """Draw the two examples of a motif side by side."""
    high = BASE / 2 + FIGURES_HIGH + 0.44
    figure = new_figure(2 * BASE + 0.3, high)
    for k, (case, word) in enumerate(zip(CASES[motif], ("composed", "real"), strict=True)):
        left = 0.05 + k * (BASE + 0.2)
        places = ((left, FIGURES_HIGH + 0.2, BASE, BASE / 2), (left, 0.0, BASE, FIGURES_HIGH + 0.2))
        triangle, beneath = (figure.add_axes(inches(place, figure)) for place in places)
        span = told(case, motif)
        sure = "not told" if span is None else f"confidence {span.confidence:.2f}"
        name = case.source.rsplit("/", 1)[-1].split(".")[0]
        figure.text(
            left / (2 * BASE + 0.3),
            1 - 0.04 / high,
            f"{word}: {name}",
            va="top",
            fontsize=BODY,
            color=LIGHT.ink,
        )
        figure.text(
            (left + BASE) / (2 * BASE + 0.3), 1 - 0.06 / high, sure, va="top", ha="right", fontsize=SMALL,
            color=LIGHT.ink2,
        )  # fmt: skip
        _triangle(triangle, case)
        _beneath(beneath, case, span)
    return figure


def composition() -> Figure:
    """Figures 32 and 36: Z in red and Z* in cyan make the picture of both."""
    image = symmetry_image(seen("side kicks").mirrored.distances)
    figure = new_figure(WIDTH, 2.45)
    double = seen("side kicks").mirrored.distances
    nothing = np.full_like(double.own, np.inf)
    images = (
        symmetry_image(double.replace(mirror=nothing)),
        symmetry_image(double.replace(own=nothing)),
        image,
    )
    for k, (each, word) in enumerate(zip(images, ("Z", "Z*", "both"), strict=True)):
        axes = figure.add_axes(inches((0.1 + k * 2.5, 0.05, 2.15, 2.15), figure))
        draw_image(axes, each, (0, len(double) / double.rate, len(double) / double.rate, 0))
        axes.set_title(word, loc="left", fontsize=BODY, color=LIGHT.ink, pad=4)
        if k:
            figure.text(
                (k * 2.5 - 0.075) / WIDTH, 0.46, "+="[k - 1], ha="center", fontsize=13, color=LIGHT.ink
            )
    return figure


def _triangle(axes: Axes, case: Case) -> None:
    """Draw Z and Z* of what is shown, the half above the identity axis."""
    double = _seen(case).mirrored.distances
    start, stop = (round(at * double.rate) for at in _shown(case))
    piece = slice(start, stop)
    cut = double.replace(own=double.own[piece, piece], mirror=double.mirror[piece, piece])
    axes.imshow(_turned(symmetry_image(cut)), extent=(0, 1, 0, 1), aspect="auto", interpolation="antialiased")
    axes.plot([0, 0.5, 1, 0], [0, 1, 0, 0], color=LIGHT.ink2, lw=0.5, clip_on=False)
    axes.set(xlim=(0, 1), ylim=(0, 1))
    axes.axis("off")


def _beneath(axes: Axes, case: Case, span: SymmetrySpan | None) -> None:
    """Draw the brackets of a motif, when it is, and postures along the time that is shown."""
    (start, stop), seconds = _shown(case), _shown(case)[1] - _shown(case)[0]
    made = _seen(case)
    rate = made.motion.rate
    held = [case.at, *([case.partner] if case.partner else [])]
    if span is not None:
        held = [
            (a / rate, b / rate)
            for a, b in [(span.start, span.stop), *([span.partner] if span.partner else [])]
        ]
    per_second, high = BASE / seconds, FIGURES_HIGH + 0.2
    axes.set(xlim=(0, BASE), ylim=(0, high))
    axes.axis("off")
    line: dict[str, Any] = {
        "color": LIGHT.ink,
        "lw": 1.1,
        "ls": "-" if span else (0, (2, 1.5)),
        "clip_on": True,
    }
    for a, b in held:
        x0, x1 = ((max(start, min(stop, at)) - start) * per_second for at in (a, b))
        axes.plot([x0, x0, x1, x1], [high - 0.015, high - 0.06, high - 0.06, high - 0.015], **line)
    for mark in () if span is None else span.marks[1:-1] / rate:
        if start < mark < stop:
            axes.plot([(mark - start) * per_second] * 2, [high - 0.06, high - 0.03], **line)
    for at, side in ((start, "left"), (stop, "right")):
        axes.text(
            0 if side == "left" else BASE,
            high - 0.08,
            f"{at:.1f} s",
            ha=side,
            va="top",
            fontsize=6.5,
            color=LIGHT.ink2,
        )
    frames = np.linspace(start * rate, stop * rate - 1, 2 * SHOWN + 1)[1::2].astype(int)
    outlines = [figure_shapes(made.body, min(int(frame), len(made.body) - 1)) for frame in frames]
    every = np.concatenate([shape.outline for shapes in outlines for shape in shapes])
    low, reach = every[:, 1].min(), max(np.ptp(every[:, 1]), made.body.size)
    scale = min(FIGURES_HIGH - 0.1, 0.5) / reach
    for k, shapes in enumerate(outlines):
        foot = (BASE * (2 * k + 1) / (2 * SHOWN), 0.02 - low * scale)
        paint_figure(axes, shapes, foot, (scale, scale), 72 * scale, LIGHT)


def _shown(case: Case) -> Span:
    """What is shown, in seconds of what is looked at."""
    seconds = len(_seen(case).motion) / _seen(case).motion.rate
    start, stop = (0.0, seconds) if case.alone else case.shown
    return start, min(stop, seconds)


def _seen(case: Case) -> Seen:
    return seen(case.source, case.shown if case.alone else None)


def _both(one: Span, other: Span) -> float:
    """Share of both stretches that is common to them."""
    common = min(one[1], other[1]) - max(one[0], other[0])
    return max(common, 0.0) / (max(one[1], other[1]) - min(one[0], other[0]))


FIGURES: dict[str, Any] = {
    "s-32-composition": composition,
    **{f"s-{motif.replace('_', '-')}": partial(motif_figure, motif) for motif in CASES},
    **paper_s_motions.FIGURES,
}
