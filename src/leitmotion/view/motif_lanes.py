"""The time line of symmetry: a lane for each motif that was found, in ink, since colour means which pattern."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.view.palette import Theme, mixed, theme_named
from leitmotion.view.plots import (
    BODY,
    SMALL,
    UNCERTAIN,
    draw_bar,
    new_figure,
    style_axes,
    tell_unit_of_time,
    time_ticks,
)
from leitmotion.view.symmetry_words import TOLD, lane_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LANE, HEAD = 0.36, 2.5  # inches: height of a lane, width of its head


def plot_motifs(found: Symmetry, *, theme: str = "light", width: float = 8.0) -> Figure:
    """Draw the time line: a lane for each motif with its stretches, and ticks where a cycle or a way begins.

    Parameters
    ----------
    found : Symmetry
        The motifs. Stretches of a confidence below one half are hatched; the later of two stretches is paler.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        One axis of seconds for all lanes; strikes are small triangles on it.

    Raises
    ------
    ParameterError
        When the theme is unknown.

    Examples
    --------
    >>> span = SymmetrySpan("stillness", 0, 60, 0.9)
    >>> figure = plot_motifs(Symmetry((span,), 30.0, 300, {}))
    >>> float(figure.axes[0].get_xlim()[1])
    10.0
    """
    colours = theme_named(theme)
    motifs = [motif for motif in TOLD if any(span.motif == motif for span in found.spans)]
    lanes = max(1, len(motifs))
    height = lanes * LANE + 0.45
    seconds = found.frames / found.rate
    figure = new_figure(width, height, colours)
    axes = figure.add_axes((HEAD / width, 0.08 / height, 1 - (HEAD + 0.15) / width, lanes * LANE / height))
    axes.set(xlim=(0, seconds), ylim=(lanes, 0), yticks=[], xticks=time_ticks(seconds))
    axes.xaxis.set_ticks_position("top")
    style_axes(axes, colours)
    tell_unit_of_time(axes)
    for lane, motif in enumerate(motifs):
        spans = [span for span in found.spans if span.motif == motif]
        _head(axes, lane, lane_words(motif, spans), colours, width)
        for span in spans:
            _bar(axes, lane, span, found.rate, colours)
    if not motifs:
        axes.text(seconds / 2, 0.5, "No motif of symmetry was found", ha="center", va="center", color=colours.ink2,
                  fontsize=BODY)  # fmt: skip
    for lane in range(1, lanes):
        axes.axhline(lane, color=colours.line, lw=0.6, zorder=0)
    above: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "clip_on": False}
    axes.plot(found.strikes / found.rate, [1.0] * len(found.strikes), "v", ms=3.5, color=colours.ink, **above)
    return figure


def _bar(axes: Axes, lane: int, span: SymmetrySpan, rate: float, colours: Theme) -> None:
    hatch = "////" if span.confidence < UNCERTAIN else None
    for (start, stop), strength in ((span.start, span.stop), 0.45), (span.partner or (0, 0), 0.2):
        if stop > start:
            fill = mixed(colours.ink2, strength, colours.surface)
            draw_bar(axes, lane, start / rate, stop / rate, fill, hatch, colours.ink2)
    for mark in span.marks.tolist():
        axes.plot([mark / rate] * 2, [lane + 0.14, lane + 0.86], color=colours.ink, lw=0.7)


def _head(axes: Axes, lane: int, words: tuple[str, str], colours: Theme, width: float) -> None:
    """The plain name, and the thesis's term under it."""
    inch = 1 / (width - HEAD - 0.15)
    place: dict[str, Any] = {"transform": axes.get_yaxis_transform(), "va": "center", "clip_on": False}
    name, term = words
    axes.text(-(HEAD - 0.12) * inch, lane + 0.32, name, fontsize=SMALL, color=colours.ink, **place)
    axes.text(-(HEAD - 0.12) * inch, lane + 0.7, term, fontsize=SMALL - 1, color=colours.ink2, **place)
