"""Marker posture: the normalisation of paper P, marker by marker.

References
----------
[1] Tang, Leung, Komura, Shum, *Finding repetitive patterns in 3D human motion captured data* (2008), section
    2.1, eq. 1, figure 4.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.body import find_roles
from leitmotion.features.posture import turn_to_front
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import DataError, ParameterError, Trajectories
from leitmotion.motion.errors import in_short

MID_BACK = ("T10", "BACK", "SPINE", "MBAK", "V.SACRAL", "VSAC", "SACR")
"""Names of the marker in the middle of the back, in small or capital letters, in the order of preference."""


def marker_posture(
    markers: Trajectories,
    *,
    mid_back: str | Sequence[str] | None = None,
    trunk: tuple[str, str, str] | None = None,
) -> FeatureSequence:
    """Describe each frame by where all markers are, as [1] does.

    Eq. 1 moves every marker so that the mid-back marker stands on the vertical axis, heights kept. Then the
    body is turned about the vertical until the horizontal part of N, the normal of the plane through three
    trunk markers, points to +Z: with the markers left L, right R and low M, ``N = (L - R) x ((L + R) / 2 -
    M)``. Lengths stay as they are: [1] scales its matrix, not the postures.

    Parameters
    ----------
    markers : Trajectories
        T frames of P markers in three dimensions.
    mid_back : str or sequence of str, optional
        The marker of the body centre, or several whose mean it is; by default a marker with one of the names
        of :data:`MID_BACK`, else the pelvis markers.
    trunk : tuple of str, optional
        The left, right and low marker that span the trunk; by default the two shoulders and the body centre.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 3 P), ``width`` 3, in the recording's unit. A frame that does not show the body centre
        and the trunk markers is NaN, and so is one in which N is vertical.

    Raises
    ------
    ParameterError
        When a marker named is not there.
    DataError
        When the recording is planar, or the markers needed cannot be told from their names.

    Examples
    --------
    >>> names = ("T10", "LSHO", "RSHO")
    >>> backwards = [[[5, 1, 5], [4.8, 1.4, 5], [5.2, 1.4, 5]]]
    >>> (marker_posture(Trajectories(names, backwards, rate=120)).values.round(3) + 0.0).tolist()
    [[0.0, 1.0, 0.0, 0.2, 1.4, 0.0, -0.2, 1.4, 0.0]]
    """
    if markers.positions.shape[2] != 3:
        raise DataError("Marker posture needs markers in three dimensions, got two.")
    centre = _mean(markers, _body_centre(markers, mid_back))
    left, right, low = _trunk(markers, trunk, centre)
    normal = np.cross(left - right, (left + right) / 2 - low)
    flat = np.hypot(normal[:, 0], normal[:, 2])
    yaw = np.where(flat > 0, np.arctan2(normal[:, 0], normal[:, 2]), np.nan)
    placed = markers.positions - (centre * [1.0, 0.0, 1.0])[:, None]
    return FeatureSequence(
        values=turn_to_front(placed, yaw).reshape(len(markers), -1),
        names=markers.names,
        rate=markers.rate,
        invariant_to=("place", "yaw"),
        width=3,
        unit=markers.unit,
    )


def _body_centre(markers: Trajectories, mid_back: str | Sequence[str] | None) -> tuple[str, ...]:
    if mid_back is not None:
        return (mid_back,) if isinstance(mid_back, str) else tuple(mid_back)
    capitals = {name.split(":")[-1].upper(): name for name in reversed(markers.names)}
    named = next((capitals[name] for name in MID_BACK if name in capitals), None)
    if named is not None:
        return (named,)
    return _members(markers, "pelvis", "mid_back")


def _trunk(
    markers: Trajectories, trunk: tuple[str, str, str] | None, centre: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    if trunk is not None:
        left, right, low = (_mean(markers, (name,)) for name in trunk)
        return left, right, low
    shoulders = [_mean(markers, _members(markers, f"{side}_shoulder", "trunk")) for side in ("left", "right")]
    return shoulders[0], shoulders[1], centre


def _members(markers: Trajectories, role: str, argument: str) -> tuple[str, ...]:
    found = find_roles(markers)
    if role not in found.roles:
        raise DataError(
            f"Marker postures are turned by the trunk, and no marker for the {role.replace('_', ' ')} is known among "
            f"{in_short(markers.names)}.",
            remedy=f"Compare posture: --features posture. In Python the marker can be named with {argument}=.",
        )
    return found.members[found.roles.index(role)]


def _mean(markers: Trajectories, members: Sequence[str]) -> np.ndarray:
    missing = [name for name in members if name not in markers.names]
    if missing or not members:
        raise ParameterError(
            f"The recording has no marker {missing[0] if missing else ''!r}.",
            remedy=f"It has {in_short(markers.names)}.",
        )
    return markers.positions[:, [markers.names.index(name) for name in members]].mean(axis=1)
