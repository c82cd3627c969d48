"""Velocity: how fast and which way the joints move, seen from the body itself.

Conventions
-----------
Velocities are those in the world (locomotion is seen in every joint), turned so that the body faces +Z. One
unit is one body size a second.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.body import Body
from leitmotion.features.posture import choose_roles, turn_to_front
from leitmotion.features.sequence import FeatureSequence

RATES = {"m": "m/s", "px": "px/s", "relative": "relative/s"}


def velocity(body: Body, *, roles: Sequence[str] | None = None) -> FeatureSequence:
    """Describe each frame by the velocities of the joints, whatever the body's place, yaw and size.

    Central differences of the positions (one-sided at the ends), so that the values answer to time in seconds
    and not to the frame rate.

    Parameters
    ----------
    body : Body
        T frames.
    roles : sequence of str, optional
        Which points; by default as in :func:`leitmotion.features.posture`.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 3 R), ``width`` 3 (2 for a planar recording), ``scale`` the body's size, so that values
        times `scale` are metres a second; NaN in frames in which a point was unseen, and beside them.

    Raises
    ------
    ParameterError
        When the body lacks one of the roles asked for.

    Examples
    --------
    >>> walk = [[[0.0, 1.0, 0.1 * t]] for t in range(4)]
    >>> body = Body(("pelvis",), walk, facing=[0.0] * 4, rate=10, size=2.0)
    >>> velocity(body).values.round(3).tolist()[1]
    [0.0, 0.0, 0.5]
    """
    chosen = choose_roles(body, roles)
    positions = body.positions[:, [body.roles.index(role) for role in chosen]]
    if len(positions) > 1:
        moved = np.gradient(positions, axis=0) * body.rate
        moved[np.isnan(positions)] = np.nan  # a central difference looks past the frame itself
    else:
        moved = np.where(np.isnan(positions), np.nan, 0.0)
    values = turn_to_front(moved, body.facing) / body.size
    told = ("yaw",) if body.facing_told else ()
    return FeatureSequence(
        values=values.reshape(len(values), -1),
        names=chosen,
        rate=body.rate,
        invariant_to=("place", *told, "body_size", "unit"),
        width=positions.shape[2],
        scale=body.size,
        unit=RATES[body.unit],
    )
