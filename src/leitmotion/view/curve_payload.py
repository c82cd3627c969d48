"""The curves of dynamics that the page offers: what a person would ask of a body's movement, each with its unit."""

from __future__ import annotations

from typing import Any

import numpy as np

from leitmotion.body import Dynamics, Flight
from leitmotion.view.arrays import array

MOST = 32000
MISSING = -32768


def curves_payload(dynamics: Dynamics, *, step: int) -> dict[str, Any]:
    """Turn dynamics into the curves that the page holds.

    Parameters
    ----------
    dynamics : Dynamics
        Of the recording, at its own rate.
    step : int
        Frames of the recording a drawn frame.

    Returns
    -------
    dict
        ``items``: ``id``, ``title``, ``note``, ``unit``, ``digits``, ``from_zero`` and int16 ``values`` in ``quantum``,
        -32768 unknown; ``flights``: ``start`` and ``stop``, seconds, and what they say of the recording.
    """
    mass = f"{dynamics.mass:.0f} kg"
    heavy = mass if dynamics.parameters.get("mass_given") else f"if it weighs {mass}"
    velocity = np.linalg.norm(dynamics.linear_momentum, axis=1) / dynamics.mass
    turning = np.linalg.norm(dynamics.angular_momentum, axis=1)
    told = (
        ("speed", "Speed", "of the centre of mass", "m/s", 2, True, velocity),
        ("height", "Height", "of the centre of mass", "m", 2, False, dynamics.centre_of_mass[:, 1]),
        ("energy", "Kinetic energy", heavy, "J", 0, True, dynamics.kinetic_energy),
        ("turning", "Angular momentum", heavy, "kg m²/s", 1, True, turning),
    )
    return {
        "items": [
            {"id": name, "title": title, "note": note, "unit": unit, "digits": digits, "from_zero": from_zero}
            | _packed(values[::step])
            for name, title, note, unit, digits, from_zero, values in told
        ],
        "flights": [
            {
                "start": each.start / dynamics.rate,
                "stop": each.stop / dynamics.rate,
                "tip": flight_words(each),
            }
            for each in dynamics.flights
        ],
    }


def flight_words(flight: Flight) -> str:
    """Say what a flight tells of the recording's quality.

    Parameters
    ----------
    flight : Flight
        A stretch off the floor.

    Returns
    -------
    str
        For example ``"In the air: falls with 9.4 m/s² (9.8 is right), angular momentum steady within 6 %"``.
    """
    steady = f"angular momentum steady within {100 * flight.drift_share:.0f} %"
    return f"In the air: falls with {flight.gravity:.1f} m/s² (9.8 is right), {steady}"


def _packed(values: np.ndarray) -> dict[str, Any]:
    known = np.isfinite(values)
    quantum = float(np.abs(values[known]).max(initial=0.0)) / MOST or 1.0
    return {
        "quantum": quantum,
        "values": array(np.where(known, np.rint(np.nan_to_num(values) / quantum), MISSING), "i2"),
    }
