"""The curves of dynamics: every curve is drawn from the value, flights are bands."""

import numpy as np
import pytest

from leitmotion.body import Flight, dynamics
from leitmotion.datasets import compose_session
from leitmotion.motion import ParameterError
from leitmotion.view import plot_dynamics


@pytest.fixture(scope="module")
def found():
    return dynamics(compose_session(seed=0, rate=30.0).motion[:120], mass=60)


def test_curves_show_the_numbers(found):
    height, momentum, energy, turning = plot_dynamics(found).axes
    assert np.allclose(height.lines[0].get_ydata(), found.centre_of_mass[:, 1])
    assert np.allclose(momentum.lines[1].get_ydata(), found.linear_momentum[:, 1])
    assert np.allclose(energy.lines[0].get_ydata(), found.kinetic_energy)
    assert np.ptp(energy.lines[2].get_ydata() - found.kinetic_energy - found.potential_energy) < 1e-9
    assert np.allclose(turning.lines[2].get_ydata(), found.angular_momentum[:, 2])


def test_flights_are_bands_and_the_title_counts_them(found):
    flight = Flight(30, 45, 9.7, 0.001, np.zeros(3), 0.1, 0.02)
    figure = plot_dynamics(found.replace(flights=(flight,)))
    assert all(len(axes.patches) == 1 for axes in figure.axes)
    band = figure.axes[0].patches[0].get_bbox()
    assert (band.x0, band.x1) == pytest.approx((1.0, 1.5))
    assert "1 flight" in figure.axes[0].get_title(loc="left")
    assert "no flight" in plot_dynamics(found.replace(flights=())).axes[0].get_title(loc="left")


def test_a_theme_that_is_not_there_is_refused(found):
    with pytest.raises(ParameterError, match="theme"):
        plot_dynamics(found, theme="pink")
