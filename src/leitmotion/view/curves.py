"""The curves of dynamics: height, speed, energy and turning of a body along time, flights marked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from leitmotion.body import Dynamics
from leitmotion.view.palette import Theme, theme_named
from leitmotion.view.plots import BODY, SMALL, TITLE, new_figure, style_axes, time_ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

HEIGHT = 1.5  # of a curve, inches
DASHES = ("-", (0, (4, 1.5)), (0, (1, 1)))


def plot_dynamics(found: Dynamics, *, theme: str = "light", width: float = 7.0) -> Figure:
    """Draw four curves over time, one under another: centre of mass, linear momentum, energy, angular momentum.

    Parameters
    ----------
    found : Dynamics
        What was computed. Its flights are bands through all curves.
    theme : {"light", "dark"}
        Light for paper.
    width : float
        Of the figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
        Four plots over one axis of seconds. Potential energy is drawn over its lowest.

    Raises
    ------
    ParameterError
        When the theme is unknown.

    Examples
    --------
    >>> from leitmotion.body import dynamics
    >>> from leitmotion.datasets import compose_session
    >>> figure = plot_dynamics(dynamics(compose_session(seed=0, rate=30.0).motion[:90]))
    >>> [axes.get_ylabel() for axes in figure.axes][:2]
    ['height, m', 'momentum, kg m/s']
    """
    colours = theme_named(theme)
    height = 4 * HEIGHT + 0.9
    figure = new_figure(width, height, colours)
    potential = found.potential_energy - np.nanmin(found.potential_energy)
    kinetic = found.kinetic_energy
    share = "" if found.parameters.get("mass_given") else f"; mass not given, {found.mass:.3g} kg"
    going = dict(zip(("along x", "along y, up", "along z"), found.linear_momentum.T, strict=True))
    turning = dict(
        zip(("about x", "about y, the vertical", "about z"), found.angular_momentum.T, strict=True)
    )
    curves = (
        ("height, m", {"centre of mass": found.centre_of_mass[:, 1]}),
        ("momentum, kg m/s", going),
        ("energy, J", {"kinetic": kinetic, "potential": potential, "sum": kinetic + potential}),
        ("turning, kg m²/s", turning),
    )
    for place, (what, lines) in enumerate(curves):
        bottom = (0.55 + (3 - place) * HEIGHT) / height
        axes = figure.add_axes((0.11, bottom, 0.86, (HEIGHT - 0.3) / height))
        _curve(axes, found, what, lines, colours)
        if place == 3:
            axes.set_xlabel("seconds", fontsize=BODY, color=colours.ink2)
        else:
            axes.tick_params(labelbottom=False)
    count = len(found.flights)
    told = f"{count} flight{'' if count == 1 else 's'}" if count else "no flight"
    figure.axes[0].set_title(
        f"{found.name or 'Dynamics'}: {told}{share}", loc="left", fontsize=TITLE, color=colours.ink, pad=8
    )
    return figure


def _curve(axes: Axes, found: Dynamics, what: str, lines: dict[str, np.ndarray], colours: Theme) -> None:
    style_axes(axes, colours)
    for flight in found.flights:
        axes.axvspan(flight.start / found.rate, flight.stop / found.rate, color=colours.line, lw=0, zorder=0)
    for (name, values), dashes in zip(lines.items(), DASHES, strict=False):
        axes.plot(found.times, values, ls=dashes, lw=1.1, color=colours.ink, label=name)
    seconds = len(found) / found.rate
    axes.set(xlim=(0, seconds))
    axes.set_xticks(time_ticks(seconds))
    axes.set_ylabel(what, fontsize=SMALL, color=colours.ink2)
    axes.yaxis.set_label_coords(-0.08, 0.5)
    if len(lines) > 1:
        axes.legend(
            loc="upper left", bbox_to_anchor=(0, 1.2), ncols=3, frameon=False, fontsize=SMALL,
            labelcolor=colours.ink2, handlelength=2.2, columnspacing=1.2,
        )  # fmt: skip
