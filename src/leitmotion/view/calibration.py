"""The figure of a calibration: both error rates over the threshold, and where they are equal (paper P, figure 13)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from leitmotion.evaluation import Calibration, ErrorRates
from leitmotion.view.palette import Theme, theme_named
from leitmotion.view.plots import BODY, SMALL, TITLE, new_figure, style_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN = 4.0  # thresholds; beyond that both curves are flat
MISSED, TAKEN = "alike, but taken for different", "different, but taken for alike"


def plot_calibration(
    calibration: Calibration,
    *,
    measured_in: str = "body sizes",
    theme: str = "light",
    width: float = 6.0,
) -> Figure:
    """Draw both error rates over the threshold, the point where they are equal, and how others fare there.

    Parameters
    ----------
    calibration : Calibration
        What was calibrated; of its check group the two rates at the threshold are drawn as rings.
    measured_in : str
        What a distance of 1 is.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        One plot, shares in per cent. The band is the interval of the threshold.

    Raises
    ------
    ParameterError
        When the theme is unknown.

    Examples
    --------
    >>> from leitmotion.evaluation import equal_error_rate
    >>> found = equal_error_rate([0.1, 0.2, 0.4, 0.3, 0.6, 0.8], [1, 1, 1, 0, 0, 0])
    >>> plot_calibration(found).axes[0].get_xlabel()
    'at most so far apart counts as alike, body sizes'
    """
    colours = theme_named(theme)
    figure = new_figure(width, width * 0.64, colours)
    axes = figure.add_axes((0.13, 0.16, 0.84, 0.72))
    style_axes(axes, colours)
    end = min(float(calibration.thresholds[-1]), SHOWN * calibration.threshold) or 1.0
    _curves(axes, calibration, colours, end)
    _equal(axes, calibration, colours)
    if calibration.check is not None:
        _checked(axes, calibration.check, colours)
    _interval(axes, calibration, colours)
    axes.set(xlim=(0, end), ylim=(0, 1.0), yticks=np.arange(0, 1.01, 0.25))
    axes.set_yticks(np.arange(0, 1.01, 0.25), ["0", "25", "50", "75", "100 %"])
    axes.set_ylabel("pairs judged wrongly", fontsize=BODY, color=colours.ink2)
    axes.set_xlabel(f"at most so far apart counts as alike, {measured_in}", fontsize=BODY, color=colours.ink2)
    axes.set_title(_title(calibration), loc="left", fontsize=TITLE, color=colours.ink, pad=10)
    axes.legend(
        loc="upper right",
        frameon=False,
        fontsize=SMALL,
        labelcolor=colours.ink2,
        handlelength=2.6,
        labelspacing=0.3,
    )
    return figure


def _title(calibration: Calibration) -> str:
    return f"Equal error {calibration.equal_error_rate:.1%} at {calibration.threshold:.3g}"


def _curves(axes: Axes, calibration: Calibration, colours: Theme, end: float) -> None:
    for share in (0.25, 0.5, 0.75):
        axes.axhline(share, color=colours.line, lw=0.6, zorder=0.5)
    at = np.append(calibration.thresholds, max(end, calibration.thresholds[-1]))
    style: dict[str, Any] = {"color": colours.ink, "lw": 1.5, "drawstyle": "steps-post"}
    for rates, words, dashes in (
        (calibration.false_non_match, f"{MISSED} (of {calibration.alike})", "-"),
        (calibration.false_match, f"{TAKEN} (of {calibration.not_alike})", (0, (3, 1.5))),
    ):
        axes.plot(at, np.append(rates, rates[-1]), ls=dashes, label=words, **style)


def _interval(axes: Axes, calibration: Calibration, colours: Theme) -> None:
    low, high = calibration.threshold_interval
    if np.isfinite(low):
        words = "95 % interval of the threshold"
        axes.axvspan(low, high, color=colours.line, lw=0, alpha=0.6, zorder=0, label=words)


def _equal(axes: Axes, calibration: Calibration, colours: Theme) -> None:
    """Mark where both rates are equal."""
    at, rate = calibration.threshold, calibration.equal_error_rate
    axes.plot([at, at], [0, rate], color=colours.left, lw=1.0, zorder=3)
    axes.plot(
        [at],
        [rate],
        "o",
        ms=7,
        color=colours.left,
        zorder=4,
        label=f"both rates equal: the threshold, {at:.3g}",
    )


def _checked(axes: Axes, check: ErrorRates, colours: Theme) -> None:
    """Draw how other pairs fare at the threshold."""
    for rate, words, marker in (
        (check.false_non_match, f"check group, {MISSED}: {check.false_non_match:.1%}", "s"),
        (check.false_match, f"check group, {TAKEN}: {check.false_match:.1%}", "D"),
    ):
        axes.plot(
            [check.threshold], [rate], marker, ms=6, mfc="none", mec=colours.ink, mew=1.2, zorder=5, clip_on=False,
            label=words,
        )  # fmt: skip
