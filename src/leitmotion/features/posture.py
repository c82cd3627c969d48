"""Posture: where the joints are, seen from the body itself.

Conventions
-----------
Place is the pelvis' (x, z); height stays. Yaw is the body's facing, turned to +Z. One unit is the body's size.

References
----------
[1] Tang, Leung, Komura, Shum, *Finding repetitive patterns in 3D human motion captured data* (2008), section
    2.1.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.body import ANALYSIS_ROLES, ROLES, Body
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import ParameterError


def posture(body: Body, *, roles: Sequence[str] | None = None) -> FeatureSequence:
    """Describe each frame by where the joints are, whatever the place, direction and size of the body.

    The normalisation of [1], eq. 1 and figure 4, for joints: the pelvis moves to the vertical axis, height
    is kept; the body is turned to face +Z; lengths become shares of the body's size. A body without roles is
    centred on the mean of its points instead, over those that are seen in the most frames, so that the centre
    does not jump when a point comes or goes.

    Parameters
    ----------
    body : Body
        T frames.
    roles : sequence of str, optional
        Which points; by default the :data:`leitmotion.body.ANALYSIS_ROLES` that the body has, all points of
        a body without roles.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 3 R), ``width`` 3 (2 for a planar recording), ``scale`` the body's size; NaN where a
        point or the pelvis was unseen. Invariant to place, body size and unit, and to yaw where the body
        knows its facing.

    Raises
    ------
    ParameterError
        When the body lacks one of the roles asked for.

    Examples
    --------
    >>> body = Body(("pelvis", "head"), [[[3, 1, 7], [3, 1.6, 7.1]]], facing=[0.0], rate=30, size=2.0)
    >>> posture(body).values.round(3).tolist()
    [[0.0, 0.5, 0.0, 0.0, 0.8, 0.05]]
    """
    chosen = choose_roles(body, roles)
    width = body.positions.shape[2]
    positions = body.positions[:, [body.roles.index(role) for role in chosen]]
    place = centre(body) * [1.0, 0.0, 1.0][:width]  # an unseen centre hides heights, too: 0 NaN = NaN
    values = turn_to_front(positions - place[:, None], body.facing) / body.size
    told = ("yaw",) if body.facing_told else ()
    return FeatureSequence(
        values=values.reshape(len(values), -1),
        names=chosen,
        rate=body.rate,
        invariant_to=("place", *told, "body_size", "unit"),
        width=width,
        scale=body.size,
        unit=body.unit,
    )


def choose_roles(body: Body, roles: Sequence[str] | None) -> tuple[str, ...]:
    """Check the roles asked for, or choose those that analyses compare.

    Parameters
    ----------
    body : Body
        What they must be part of.
    roles : sequence of str or None
        What was asked for.

    Returns
    -------
    tuple of str
        Roles of the body.

    Raises
    ------
    ParameterError
        When the body lacks one, or none is asked for.
    """
    if roles is None:
        common = tuple(role for role in ANALYSIS_ROLES if role in body.roles)
        return common if common and set(body.roles) <= set(ROLES) else body.roles
    chosen = tuple(roles)
    missing = [role for role in chosen if role not in body.roles]
    if missing or not chosen:
        asked = f"no {missing[0]!r}" if missing else "nothing asked of it"
        raise ParameterError(f"The body has {asked}.", remedy=f"It has {', '.join(body.roles)}.")
    return chosen


def centre(body: Body) -> np.ndarray:
    """Find what stands for the place of a body: its pelvis, else the mean of its steadiest points.

    Parameters
    ----------
    body : Body
        T frames.

    Returns
    -------
    (T, C) float
        NaN where one of those points was unseen.
    """
    if "pelvis" in body.roles:
        return body.positions[:, body.roles.index("pelvis")]
    seen = np.isfinite(body.positions).all(axis=2).sum(axis=0)
    return body.positions[:, seen == seen.max()].mean(axis=1)


def turn_to_front(vectors: np.ndarray, facing: np.ndarray) -> np.ndarray:
    """Turn vectors about the vertical so that what faced `facing` faces +Z.

    Parameters
    ----------
    vectors : (T, R, C) float
        Places or velocities; planar ones (C = 2) stay as they are.
    facing : (T,) float
        Radians; 0 faces +Z, pi/2 faces +X.

    Returns
    -------
    (T, R, C) float
        The turned vectors.
    """
    if vectors.shape[2] != 3:
        return vectors
    cosine, sine = np.cos(facing)[:, None], np.sin(facing)[:, None]
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    return np.stack((cosine * x - sine * z, y, sine * x + cosine * z), axis=-1)
