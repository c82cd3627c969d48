"""The time line of several recordings: a lane for each, colours by pattern."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from leitmotion.discovery import SharedPattern, SharedPatterns
from leitmotion.view.palette import Theme, colour_of, mixed, theme_named
from leitmotion.view.plots import (
    BODY,
    SMALL,
    UNCERTAIN,
    draw_bar,
    halo,
    new_figure,
    style_axes,
    tell_unit_of_time,
    time_ticks,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LANE, SLIM, HEAD, LETTER = 0.3, 0.16, 2.2, 0.12  # inches
MANY = 40  # lanes from which on they are slim
LONGEST, LONGEST_SLIM = 30, 40  # marks of a name that fit the head


def plot_shared_patterns(found: SharedPatterns, *, theme: str = "light", width: float = 8.0) -> Figure:
    """Draw a lane for each recording, with the stretches and occurrences of every pattern in its colour.

    Parameters
    ----------
    found : SharedPatterns
        What the recordings share. Patterns of a confidence below one half are hatched; those of a single recording
        are pale.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        One axis of seconds for all lanes, each recording from its own start.

    Raises
    ------
    ParameterError
        When the theme is unknown.

    Examples
    --------
    >>> figure = plot_shared_patterns(SharedPatterns((), (), ("a", "b"), [30, 60], [300, 1200], {}))
    >>> float(figure.axes[0].get_xlim()[1])
    20.0
    """
    colours = theme_named(theme)
    lanes = len(found.names)
    lane = LANE if lanes <= MANY else SLIM
    height = lanes * lane + 0.45
    seconds = float(np.max(found.frames / found.rates))
    figure = new_figure(width, height, colours)
    axes = figure.add_axes((HEAD / width, 0.08 / height, 1 - (HEAD + 0.15) / width, lanes * lane / height))
    axes.set(xlim=(0, seconds), ylim=(lanes, 0), yticks=[], xticks=time_ticks(seconds))
    axes.xaxis.set_ticks_position("top")
    style_axes(axes, colours)
    tell_unit_of_time(axes)
    per_second = (width - HEAD - 0.15) / seconds
    for k in range(lanes):
        axes.plot([0, found.frames[k] / found.rates[k]], [k + 0.5] * 2, color=colours.line, lw=0.8, zorder=0)
        _head(axes, k, found, colours, width)
    for pattern in found.patterns:
        _pattern(axes, pattern, found, colours, per_second)
    return figure


def _pattern(
    axes: Axes, pattern: SharedPattern, found: SharedPatterns, colours: Theme, per_second: float
) -> None:
    colour = colour_of(pattern.id, colours)
    strength = 1.0 if len(pattern.recordings) > 1 else 0.5
    hatch = "////" if pattern.confidence < UNCERTAIN else None
    for lane, start, stop, _ in pattern.stretches:
        rate = found.rates[lane]
        fill = mixed(colour, 0.13 * strength, colours.surface)
        draw_bar(axes, lane, start / rate, stop / rate, fill, hatch, colour)
    for k, (lane, start, stop, _) in enumerate(pattern.occurrences):
        begin, end = start / found.rates[lane], stop / found.rates[lane]
        fill = mixed(colour, (0.42 if k % 2 else 0.28) * strength, colours.surface)
        draw_bar(axes, lane, begin, end, fill, hatch, colour)
        axes.plot([begin] * 2, [lane + 0.14, lane + 0.86], color=colour, lw=0.8, alpha=strength)
    for lane, start, stop, _ in pattern.stretches:
        begin, end = start / found.rates[lane], stop / found.rates[lane]
        if (end - begin) * per_second > LETTER:
            told = axes.text((begin + end) / 2, lane + 0.5, pattern.id, ha="center", va="center_baseline")
            told.set(fontsize=SMALL - 1, weight="bold", color=colour, alpha=strength)
            told.set(path_effects=halo(colours, 2)["path_effects"])


def _head(axes: Axes, lane: int, found: SharedPatterns, colours: Theme, width: float) -> None:
    """Name the recording left of its lane, and tell how many patterns occur in it."""
    name = found.names[lane]
    fit = LONGEST_SLIM if len(found.names) > MANY else LONGEST
    called = name if len(name) <= fit else f"{name[: fit // 2]}…{name[1 - fit // 2 :]}"
    count = int(np.count_nonzero(found.counts[lane]))
    inch = 1 / (width - HEAD - 0.15)
    size = SMALL - 1 if len(found.names) > MANY else BODY - 1
    axes.text(-(HEAD - 0.1) * inch, lane + 0.5, called, transform=axes.get_yaxis_transform(), va="center",
              fontsize=size - 1, color=colours.ink, clip_on=False)  # fmt: skip
    axes.text(-0.06 * inch, lane + 0.5, str(count) if count else "–", transform=axes.get_yaxis_transform(),
              ha="right", va="center", fontsize=size - 1, color=colours.ink2, clip_on=False)  # fmt: skip
