"""The Z/Z* plot: where a movement is like itself, and where it is like its mirror image (paper S, sections 3.2 to 3.4).

Conventions
-----------
Red is Z, cyan is Z*, added on black: white is both. Black in both themes, since the meaning is additive. In the square
time runs right and down; in the triangle it runs right along the identity axis, and two moments meet above the middle
between them, as high as they are apart.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.similarity import DoubleMetric, axis_speed, still_spans
from leitmotion.view.cells import shrunk_likeness
from leitmotion.view.palette import Theme, theme_named
from leitmotion.view.plots import (
    SMALL,
    SMOOTH_BELOW,
    TITLE,
    new_figure,
    style_axes,
    tell_unit_of_time,
    time_ticks,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

RED, CYAN, BLACK = "#FF4C42", "#10C8D6", "#101216"
FORMS = ("square", "triangle")
CELLS = 1200  # more are not seen in print
WORDS = ("like itself", "like its mirror image", "both")
FASTEST = 98  # percentile of the speeds that the curve shows


def plot_symmetry(
    found: DoubleMetric,
    *,
    form: str = "square",
    title: str = "Like itself, like its mirror image",
    theme: str = "light",
    width: float = 5.0,
) -> Figure:
    """Draw Z and Z* of a recording in one picture, with the β that they were made with.

    Parameters
    ----------
    found : DoubleMetric
        T moments.
    form : {"square", "triangle"}
        The whole matrix, or the half above its identity axis turned by 45 degrees, with the speed of the body beneath
        it, read from the width of the axis, and the stretches in which it keeps still.
    title : str
        Above the picture; empty for none.
    theme : {"light", "dark"}
        Of what is around it.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        Time axes in seconds.

    Raises
    ------
    ParameterError
        When the form or the theme is unknown.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> from leitmotion.similarity import double_metric
    >>> found = double_metric(kinematic_chain(compose_session(seed=0, rate=30.0).motion)[::10])
    >>> len(plot_symmetry(found, form="triangle").axes)
    2
    """
    if form not in FORMS:
        raise ParameterError(f"form must be one of {', '.join(FORMS)}, got {form!r}.")
    colours = theme_named(theme)
    seconds = len(found) / found.rate
    composite = symmetry_image(found)
    draw = _draw_square if form == "square" else _draw_triangle
    figure, axes = draw(composite, found, seconds, colours, width)
    axes.set_title(title, loc="left", fontsize=TITLE, color=colours.ink, pad=22 if form == "square" else 8)
    half = f"half alike at {np.degrees(found.half_angle):.2g}°, β = {found.beta:.0f}"
    axes.set_title(half, loc="right", fontsize=SMALL, color=colours.ink2, pad=22 if form == "square" else 8)
    _legend(figure, colours)
    return figure


def symmetry_image(found: DoubleMetric, *, cells: int = CELLS) -> np.ndarray:
    """Colour each cell by Z and Z*.

    Parameters
    ----------
    found : DoubleMetric
        T moments.
    cells : int
        At most so many rows and columns, each the mean of several where there are more moments.

    Returns
    -------
    (N, N, 3) float
        Red, green and blue, 0 to 1; rows run down.
    """
    from matplotlib.colors import to_rgb

    own, mirror = (shrunk_likeness(each, found.beta, cells)[..., None] for each in (found.own, found.mirror))
    added = own * np.array(to_rgb(RED)) + mirror * np.array(to_rgb(CYAN))
    return np.clip(np.maximum(added, to_rgb(BLACK)), 0.0, 1.0)


def _draw_square(
    composite: np.ndarray, found: DoubleMetric, seconds: float, colours: Theme, width: float
) -> tuple[Figure, Axes]:
    figure = new_figure(width, width * 1.06, colours)
    axes = figure.add_axes((0.11, 0.105, 0.85, 0.85 / 1.06))
    smooth = "antialiased" if len(composite) > SMOOTH_BELOW else "bilinear"
    axes.imshow(composite, extent=(0, seconds, seconds, 0), aspect="auto", interpolation=smooth)
    axes.set(xticks=time_ticks(seconds), yticks=time_ticks(seconds))
    axes.xaxis.set_ticks_position("top")
    style_axes(axes, colours)
    tell_unit_of_time(axes)
    return figure, axes


def _draw_triangle(
    composite: np.ndarray, found: DoubleMetric, seconds: float, colours: Theme, width: float
) -> tuple[Figure, Axes]:
    height = 0.36 + width * 0.45 + 1.35
    figure = new_figure(width, height, colours)
    axes = figure.add_axes((0.11, 1.35 / height, 0.87, width * 0.435 / height))
    axes.imshow(_turned(composite), extent=(0, seconds, 0, seconds), aspect="auto", interpolation="nearest")
    axes.set(xticks=[], yticks=time_ticks(seconds)[:: max(1, len(time_ticks(seconds)) // 4)])
    style_axes(axes, colours)
    axes.set_ylabel("apart, s", fontsize=SMALL, color=colours.ink2)
    _draw_speed(figure.add_axes((0.11, 0.72 / height, 0.87, 0.55 / height)), found, seconds, colours)
    return figure, axes


def _turned(composite: np.ndarray) -> np.ndarray:
    """Turn the half above the identity axis by 45 degrees; what lies outside is transparent."""
    cells = len(composite)
    fine = 2 * max(1, -(-600 // cells))  # dots a cell, so that its turned edges stay straight
    across = (np.arange(cells * fine // 2) + 0.5) * 2 / fine
    apart = across[::-1, None]
    first, second = (across - apart / 2), (across + apart / 2)
    inside = (first >= 0) & (second < cells)
    i, j = (np.clip(moment, 0, cells - 1).astype(int) for moment in (first, second))
    return np.concatenate((composite[i, j], inside[..., None].astype(float)), axis=-1)


def _draw_speed(axes: Axes, found: DoubleMetric, seconds: float, colours: Theme) -> None:
    speed = np.degrees(axis_speed(found))
    time = (np.arange(len(found)) + 0.5) / found.rate
    seen = speed[np.isfinite(speed)]
    most = (float(np.percentile(seen, FASTEST)) if seen.size else 0.0) or 1.0
    axes.fill_between(time, np.minimum(speed, 1.15 * most), color=colours.ink2, alpha=0.22, lw=0)
    axes.plot(time, np.minimum(speed, 1.15 * most), color=colours.ink2, lw=0.7)
    for start, stop, _, _ in still_spans(found):
        axes.axvspan(start / found.rate, stop / found.rate, ymax=0.08, color=colours.ink, lw=0)
    axes.set(xlim=(0, seconds), ylim=(0, 1.2 * most), xticks=time_ticks(seconds), yticks=[most])
    style_axes(axes, colours)
    axes.set_yticks([most], [f"{most:.0f} °/s"])
    tell_unit_of_time(axes)


def _legend(figure: Figure, colours: Theme) -> None:
    """Three discs on black."""
    from matplotlib.patches import Ellipse, Rectangle

    wide, high = figure.get_size_inches()
    side, low = 0.15, 0.18
    at = 0.11 * wide
    for word, colour in zip(WORDS, (RED, CYAN, "#FFFFFF"), strict=True):
        inches = figure.dpi_scale_trans
        figure.add_artist(Rectangle((at, low), side, side, fc=BLACK, ec="none", transform=inches))
        middle = (at + side / 2, low + side / 2)
        figure.add_artist(Ellipse(middle, 0.09, 0.09, fc=colour, ec="none", transform=inches))
        text = figure.text(
            (at + side + 0.05) / wide,
            (low + side / 2) / high,
            word,
            va="center",
            fontsize=SMALL,
            color=colours.ink2,
        )
        at = text.get_window_extent().x1 / figure.dpi + 0.14
