"""Static figures for papers: the distance map with its stripes, the lanes of patterns, stick figures.

Conventions
-----------
Each function returns a new matplotlib ``Figure`` that belongs to no window and no global state; save it with
``figure.savefig``. The look is the page's: colour means which pattern, everything else is ink; the right side of
a body is filled, the left is hollow.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from leitmotion.discovery import Pattern, Patterns
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.segmentation import Segmentation
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view.counting import clock
from leitmotion.view.distances import Told, distance_cap, how_told
from leitmotion.view.palette import Theme, colour_of, mixed, theme_named
from leitmotion.view.stick_figures import figure_shapes, paint_figure
from leitmotion.view.words import lane_head

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.text import Text

    from leitmotion.body import Body


CELLS, SMOOTH_BELOW = 1500, 600  # more cells are not seen in print; fewer are smoothed
TICKS_S = (0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600)
UNCERTAIN = 0.5
SMALL, BODY, TITLE = 8.0, 9.0, 11.0
LANE, HEAD, DIGIT = 0.36, 1.6, 0.13  # inches: height of a lane, width of its head, room for a cycle's number
CAPTION = 0.24  # inches


def plot_matrix(
    matrix: SimilarityMatrix,
    patterns: Patterns | None = None,
    *,
    title: str = "Every moment against every other",
    theme: str = "light",
    width: float = 5.0,
) -> Figure:
    """Draw the distance map: dark where two moments are alike; above the diagonal the stripes that were traced.

    Parameters
    ----------
    matrix : SimilarityMatrix
        Rows run down, columns to the right.
    patterns : Patterns, optional
        Whose pairs are drawn as stripes and whose stretches stand as bars along both edges.
    title : str
        Above the map; empty for none.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        Time axes in seconds, the legend in the unit of the recording.

    Raises
    ------
    ParameterError
        When the theme is unknown.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(300) / 60
    >>> values = abs(np.sin(2 * t)[:, None] - np.sin(2 * t))
    >>> figure = plot_matrix(SimilarityMatrix(values, "mean_norm", 60, 60, unit="m"))
    >>> figure.axes[0].get_title(loc="left")
    'Every moment against every other'
    """
    from matplotlib.colors import LinearSegmentedColormap

    colours = theme_named(theme)
    figure = new_figure(width, width * 1.06, colours)
    axes = figure.add_axes((0.11, 0.105, 0.85, 0.85 / 1.06))
    told = how_told(matrix)
    cap = distance_cap(matrix.values, told)
    rows, columns = matrix.values.shape
    seconds = columns / matrix.column_rate, rows / matrix.row_rate
    axes.imshow(
        matrix.values[:: max(1, rows // CELLS), :: max(1, columns // CELLS)] * told.factor,
        cmap=LinearSegmentedColormap.from_list("distance", colours.ramp[::-1]),
        vmin=0, vmax=cap, extent=(0, seconds[0], seconds[1], 0), aspect="auto",
        interpolation="antialiased" if columns > SMOOTH_BELOW else "bilinear",
    )  # fmt: skip
    if patterns is not None:
        for pair in patterns.stripes:
            colour = colour_of(pair.pattern, colours)
            path = pair.path / patterns.rate
            axes.plot(path[:, 1], path[:, 0], color=colour, lw=1.6, **halo(colours, 3.2), zorder=3)
        _edge_bars(axes, patterns, colours)
    axes.set(
        xlim=(0, seconds[0]),
        ylim=(seconds[1], 0),
        xticks=time_ticks(seconds[0]),
        yticks=time_ticks(seconds[1]),
    )
    axes.xaxis.set_ticks_position("top")
    style_axes(axes, colours)
    tell_unit_of_time(axes)
    axes.set_title(title, loc="left", fontsize=TITLE, color=colours.ink, pad=22)
    _legend(figure, colours, _far_end(cap, told))
    return figure


def plot_patterns(
    patterns: Patterns,
    *,
    seconds: float | None = None,
    labels: Segmentation | None = None,
    theme: str = "light",
    width: float = 7.0,
) -> Figure:
    """Draw the time line: a lane for each pattern with its stretches and cycles.

    Parameters
    ----------
    patterns : Patterns
        What was found. Patterns of a confidence below one half are hatched.
    seconds : float, optional
        How long the recording is; by default to the end of the last stretch.
    labels : Segmentation, optional
        What a person called the stretches: one more lane, in ink.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        One axis of seconds for all lanes.

    Raises
    ------
    ParameterError
        When the theme is unknown.

    Examples
    --------
    >>> figure = plot_patterns(Patterns((), (), rate=60, parameters={}), seconds=10)
    >>> float(figure.axes[0].get_xlim()[1])
    10.0
    """
    colours = theme_named(theme)
    lanes = max(1, len(patterns)) + (labels is not None)
    height = lanes * LANE + 0.45
    figure = new_figure(width, height, colours)
    axes = figure.add_axes((HEAD / width, 0.08 / height, 1 - (HEAD + 0.15) / width, lanes * LANE / height))
    if seconds is None:
        ends = [int(pattern.stretches.stops[-1]) / patterns.rate for pattern in patterns.patterns]
        seconds = max(ends, default=1.0)
    axes.set(xlim=(0, seconds), ylim=(lanes, 0), yticks=[], xticks=time_ticks(seconds))
    axes.xaxis.set_ticks_position("top")
    style_axes(axes, colours)
    tell_unit_of_time(axes)
    per_second = (width - HEAD - 0.15) / seconds
    for lane, pattern in enumerate(patterns.patterns):
        _lane(axes, lane, pattern, colours, per_second)
    if not len(patterns):
        axes.text(seconds / 2, 0.5, "Nothing repeats here", ha="center", va="center", color=colours.ink2,
                  fontsize=BODY)  # fmt: skip
    if labels is not None:
        _label_lane(axes, lanes - 1, labels, colours)
    for lane in range(1, lanes):
        axes.axhline(lane, color=colours.line, lw=0.6, zorder=0)
    return figure


def plot_figures(
    body: Body,
    frames: Sequence[int],
    *,
    captions: Sequence[str] | None = None,
    theme: str = "light",
    height: float = 1.8,
) -> Figure:
    """Draw the body at chosen moments, side by side, turned to one direction.

    Parameters
    ----------
    body : Body
        Points with roles. A limb of which a joint is missing is absent; a body without roles is dots.
    frames : sequence of int
        Which moments.
    captions : sequence of str, optional
        Under each; by default its time.
    theme : {"light", "dark"}
        Light for paper.
    height : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        The figures in one scale on one ground line.

    Raises
    ------
    ParameterError
        When a frame is outside the recording, none is given, or captions do not match.
    """
    colours = theme_named(theme)
    chosen = [int(frame) for frame in frames]
    if not chosen or min(chosen) < 0 or max(chosen) >= len(body):
        raise ParameterError(f"frames must be some of 0 to {len(body) - 1}, got {list(frames)}.")
    words = [clock(frame / body.rate) for frame in chosen] if captions is None else list(captions)
    if len(words) != len(chosen):
        raise ParameterError(f"captions must be {len(chosen)}, one a frame, got {len(words)}.")

    drawn = [figure_shapes(body, frame) for frame in chosen]
    reach = [np.abs(shape.outline[:, 0]).max() + shape.stroke for shapes in drawn for shape in shapes]
    heights = np.concatenate([[0.0, 0.1], *(shape.outline[:, 1] for shapes in drawn for shape in shapes)])
    half, low, high = 1.12 * max(reach, default=0.5), heights.min(), heights.max()
    low, high = low - 0.03 * (high - low), high + 0.03 * (high - low)
    scale = (height - CAPTION) / (high - low)  # inches a metre
    width = 2 * half * len(chosen) * scale
    figure = new_figure(width, height, colours)
    axes = figure.add_axes((0, CAPTION / height, 1, 1 - CAPTION / height))
    axes.set(xlim=(-half, (2 * len(chosen) - 1) * half), ylim=(low, high))
    axes.axis("off")
    for k, (shapes, word) in enumerate(zip(drawn, words, strict=True)):
        paint_figure(axes, shapes, (2 * half * k, 0.0), (1.0, 1.0), 72 * scale, colours)
        middle = (2 * k + 1) / (2 * len(chosen))
        figure.text(middle, 0.06 / height, word, ha="center", fontsize=SMALL, color=colours.ink2)
    return figure


def new_figure(width: float, height: float, colours: Theme) -> Figure:
    """Begin a figure of the house: so many inches, on the theme's surface."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), dpi=200, facecolor=colours.surface)


def style_axes(axes: Axes, colours: Theme) -> None:
    """Draw axes as the house does: small ticks in ink, no frame."""
    axes.set_facecolor(colours.surface)
    axes.tick_params(
        length=2.5, width=0.6, labelsize=SMALL, color=colours.ink2, labelcolor=colours.ink2, pad=6
    )
    for spine in axes.spines.values():
        spine.set_visible(False)


def tell_unit_of_time(axes: Axes) -> None:
    """Write the unit once, at the first tick."""
    ticks = axes.get_xticks()
    axes.set_xticks(ticks, [f"{tick:g}" + (" s" if k == 0 else "") for k, tick in enumerate(ticks)])


def time_ticks(seconds: float) -> np.ndarray:
    """Place three to eight ticks a person reads."""
    step = next((s for s in TICKS_S if seconds / s <= 8), TICKS_S[-1])
    return np.arange(0, seconds + 1e-9, step)


def _far_end(cap: float, told: Told) -> str:
    """Say what the lightest cells of the map are."""
    return f"{cap:.3g}{'' if told.word[0] in '°%' else ' '}{told.word} apart or more"


def _legend(figure: Figure, colours: Theme, far_end: str) -> None:
    from matplotlib.colors import LinearSegmentedColormap

    near = figure.text(0.11, 0.05, "same posture", va="center", fontsize=SMALL, color=colours.ink2)
    end = near.get_window_extent().x1 / figure.bbox.width + 0.015
    bar = figure.add_axes((end, 0.038, 0.2, 0.024))
    ramp = LinearSegmentedColormap.from_list("distance", colours.ramp[::-1])
    bar.imshow(np.linspace(0, 1, 256)[None], cmap=ramp, aspect="auto")
    bar.set(xticks=[], yticks=[])
    for spine in bar.spines.values():
        spine.set(color=colours.line, linewidth=0.5)
    figure.text(end + 0.215, 0.05, far_end, va="center", fontsize=SMALL, color=colours.ink2)


def halo(colours: Theme, width: float) -> dict[str, Any]:
    """Part a line or letter from what lies under it."""
    from matplotlib.patheffects import Normal, Stroke

    return {
        "path_effects": [Stroke(linewidth=width, foreground=colours.surface), Normal()],
        "solid_capstyle": "round",
    }


def _edge_bars(axes: Axes, patterns: Patterns, colours: Theme) -> None:
    """Mark the stretches along the top and the left edge: the bridge to the lanes."""
    across, down = axes.get_xaxis_transform(), axes.get_yaxis_transform()
    for pattern in reversed(patterns.patterns):
        colour = colour_of(pattern.id, colours)
        for start, stop, _, _ in pattern.stretches:
            span = np.array([start, stop]) / patterns.rate
            bar: dict[str, Any] = {"color": colour, "lw": 2.4, "clip_on": False, "solid_capstyle": "butt"}
            axes.plot(span, [1.012, 1.012], transform=across, **bar)
            axes.plot([-0.012, -0.012], span, transform=down, **bar)


def _lane(axes: Axes, lane: int, pattern: Pattern, colours: Theme, per_second: float) -> None:
    colour = colour_of(pattern.id, colours)
    rate = pattern.occurrences.rate
    hatch = "////" if pattern.confidence < UNCERTAIN else None
    for start, stop, _, _ in pattern.stretches:
        draw_bar(axes, lane, start / rate, stop / rate, mixed(colour, 0.13, colours.surface), hatch, colour)
        axes.plot([start / rate] * 2, [lane + 0.14, lane + 0.86], color=colour, lw=1.8, solid_capstyle="butt")
    lengths = (pattern.occurrences.stops - pattern.occurrences.starts) / rate
    numbered = pattern.kind == "cyclic" and lengths.min() * per_second > DIGIT
    holder = np.searchsorted(pattern.stretches.starts, pattern.occurrences.starts, side="right")
    for k, (start, stop, _, _) in enumerate(pattern.occurrences):
        number = k - int(np.argmax(holder == holder[k])) + 1  # within its stretch
        shade = mixed(colour, 0.36 if number % 2 else 0.22, colours.surface)
        draw_bar(axes, lane, start / rate, stop / rate, shade, hatch, colour)
        for border in (start, stop):
            axes.plot([border / rate] * 2, [lane + 0.14, lane + 0.86], color=colour, lw=0.8)
        if numbered:
            axes.text((start + stop) / 2 / rate, lane + 0.5, str(number), ha="center", va="center",
                      fontsize=SMALL, weight="bold", color=colours.ink)  # fmt: skip
    _lane_head(axes, lane, pattern, colour, colours)


def draw_bar(
    axes: Axes, lane: int, start: float, stop: float, fill: Any, hatch: str | None, edge: str
) -> None:
    """Draw a stretch of time in a lane, hatched where it is uncertain."""
    from matplotlib.patches import Rectangle

    bar = Rectangle(
        (start, lane + 0.14), stop - start, 0.72, fc=fill, ec=edge if hatch else "none", hatch=hatch
    )
    bar.set(linewidth=0, zorder=1.5)
    axes.add_patch(bar)


def _lane_head(axes: Axes, lane: int, pattern: Pattern, colour: str, colours: Theme) -> None:
    stretches, cycles = lane_head(pattern)
    chip = _in_head(axes, lane + 0.5, 0.14, pattern.id, colours.chip, SMALL)
    chip.set(weight="bold", ha="center", bbox={"boxstyle": "round,pad=0.28", "fc": colour, "ec": "none"})
    _in_head(axes, lane + 0.3, 0.34, stretches, colours.ink, SMALL)
    _in_head(axes, lane + 0.7, 0.34, cycles, colours.ink2, SMALL - 1)


def _in_head(axes: Axes, lane: float, inches: float, words: str, colour: str, size: float) -> Text:
    """Write beside the lanes, so many inches from the left edge."""
    from matplotlib.transforms import ScaledTranslation, blended_transform_factory

    edge = ScaledTranslation(inches - HEAD, 0, axes.get_figure().dpi_scale_trans)  # type: ignore[union-attr]
    place = blended_transform_factory(axes.transAxes, axes.transData) + edge
    return axes.text(0, lane, words, color=colour, fontsize=size, va="center", transform=place)


def _label_lane(axes: Axes, lane: int, labels: Segmentation, colours: Theme) -> None:
    """Write each word into its stretch; where it does not fit, its tick alone stands."""
    _in_head(axes, lane + 0.5, 0.34, "Given labels", colours.ink2, SMALL)
    for start, stop, word, _ in labels:
        at, end = start / labels.rate, stop / labels.rate
        axes.plot([at, at], [lane + 0.25, lane + 0.75], color=colours.ink2, lw=0.8)
        place: dict[str, Any] = {
            "xytext": (3, 0),
            "textcoords": "offset points",
            "va": "center",
            "fontsize": SMALL,
        }
        written = axes.annotate(word, (at, lane + 0.5), color=colours.ink2, **place)
        if written.get_window_extent().x1 > axes.transData.transform((end, 0))[0]:
            written.remove()
