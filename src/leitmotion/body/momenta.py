"""The chain of segments in motion: what follows from their masses and frames (paper S, sections 2.4 to 2.6)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from leitmotion.body.flight import GRAVITY, Flight, find_flights, judge_flight
from leitmotion.body.inertia import Table
from leitmotion.body.segments import SEGMENTS, place_segments
from leitmotion.motion import rotations
from leitmotion.motion.smoothing import derivative, smooth

USUAL_CUTOFF = 10.0
"""Hertz, of the filter: measured on jumps (docs/dynamics.md)."""


class Chain(NamedTuple):
    """What of a body does not change along time."""

    table: Table
    lengths: np.ndarray
    masses: np.ndarray
    inertias: np.ndarray
    rate: float
    cutoff: float | None


def move_chain(
    body: Chain, points: Mapping[str, np.ndarray], turns: Mapping[str, np.ndarray]
) -> tuple[dict[str, np.ndarray], list[Flight]]:
    """Compute a stretch without gaps.

    Parameters
    ----------
    body : Chain
        What does not change.
    points : mapping of str to (T, 3) float
        Global positions by role, m, without gaps.
    turns : mapping of str to (T, 4) float
        Global rotations of the joints that carry a segment, by segment.

    Returns
    -------
    dict of str to (T, ...) float
        The arrays of a Dynamics by field.
    list of Flight
        Counted from the start of the stretch.
    """
    raw = place_segments(points, body.table, body.lengths)
    calm, calm_turns = points, turns
    if body.cutoff is not None:
        stacked = smooth(np.stack(list(points.values()), axis=1), body.cutoff, body.rate)
        calm = dict(zip(points, np.moveaxis(stacked, 1, 0), strict=True))
        calm_turns = {
            segment: rotations.normalize(smooth(rotations.continuous(turn), body.cutoff, body.rate))
            for segment, turn in turns.items()
        }
    placed = place_segments(calm, body.table, body.lengths, calm_turns)
    q = rotations.continuous(rotations.from_matrix(placed.axes))
    spin = 2.0 * rotations.multiply(derivative(q, body.rate), rotations.conjugate(q))[..., 1:]
    speed, origin_speed = derivative(placed.centres, body.rate), derivative(placed.origins, body.rate)
    body_spin = np.einsum("tsij,tsi->tsj", placed.axes, spin)
    own = np.einsum("tsij,tsj->tsi", placed.axes, body.inertias * body_spin)
    momenta = body.masses[:, None] * speed
    share = body.masses / body.masses.sum()
    centre, drift = share @ placed.centres, share @ speed
    about = own + np.cross(placed.centres - centre[:, None], body.masses[:, None] * (speed - drift[:, None]))
    whole = about.sum(axis=1)
    moved = {
        "origins": placed.origins,
        "centres": placed.centres,
        "global_rotations": q,
        "velocities": speed,
        "angular_velocities": spin,
        "body_twists": np.concatenate(
            (np.einsum("tsij,tsi->tsj", placed.axes, origin_speed), body_spin), axis=-1
        ),
        "global_twists": np.concatenate((origin_speed - np.cross(spin, placed.origins), spin), axis=-1),
        "linear_momenta": momenta,
        "angular_momenta": own,
        "linear_energies": 0.5 * np.sum(momenta * speed, axis=-1),
        "angular_energies": 0.5 * np.sum(body.inertias * body_spin**2, axis=-1),
        "potential_energies": body.masses * GRAVITY * placed.centres[..., 1],
        "centre_of_mass": centre,
        "linear_momentum": momenta.sum(axis=1),
        "angular_momentum": whole,
    }
    spans = find_flights(points, centre, body.rate, body.cutoff or USUAL_CUTOFF)
    raw_centre = share @ raw.centres
    return moved, [judge_flight(span, raw_centre, whole, about, body.rate) for span in spans]


def unknown(frames: int) -> dict[str, np.ndarray]:
    """Make the arrays of a Dynamics of which nothing is known yet, by field."""
    count = len(SEGMENTS)
    wide = {"global_rotations": 4, "body_twists": 6, "global_twists": 6}
    vectors = ("origins", "centres", "velocities", "angular_velocities", "linear_momenta", "angular_momenta")
    shapes: dict[str, tuple[int, ...]] = {field: (frames, count, 3) for field in vectors}
    shapes |= {field: (frames, count, width) for field, width in wide.items()}
    shapes |= dict.fromkeys(("linear_energies", "angular_energies", "potential_energies"), (frames, count))
    shapes |= dict.fromkeys(("centre_of_mass", "linear_momentum", "angular_momentum"), (frames, 3))
    return {field: np.full(shape, np.nan) for field, shape in shapes.items()}
