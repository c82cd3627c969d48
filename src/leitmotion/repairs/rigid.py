"""Rigid bodies: which points keep their distances to one another, and how they turn as one.

References
----------
[1] Kabsch, *A solution for the best rotation to relate two sets of vectors*, Acta Crystallographica A 32 (1976).
"""

from __future__ import annotations

import numpy as np

STEADY = 0.05  # of a distance: neighbours on one segment keep theirs better than this, even on the skin
SAMPLE = 500  # frames that speak for a distance, evenly spread
MOST = 6  # companions that a fit uses
FLATTEST = 0.1  # of the longest extent: narrower, points lie on a line and do not tell a turn about it


def companions(positions: np.ndarray, point: int) -> np.ndarray:
    """Find the points that keep their distance to a point, the steadiest first.

    Parameters
    ----------
    positions : (T, P, C) float
        Where the points are, NaN where unseen.
    point : int
        Whose neighbours are wanted.

    Returns
    -------
    (K,) int
        Those whose distance to it spreads by less than a twentieth of itself; the spread is the standard deviation
        over the frames that show both.
    """
    few = positions[:: max(1, len(positions) // SAMPLE)]
    distances = np.linalg.norm(few - few[:, point : point + 1], axis=2)
    seen = np.isfinite(distances)
    count = np.maximum(seen.sum(axis=0), 1)
    mean = np.where(seen, distances, 0.0).sum(axis=0) / count
    spread = np.sqrt(np.where(seen, (distances - mean) ** 2, 0.0).sum(axis=0) / count)
    fit = (seen.sum(axis=0) >= 3) & (mean > 0) & (spread <= STEADY * mean)
    fit[point] = False
    order = np.argsort(spread, kind="stable")
    return order[fit[order]]


def spanning(cloud: np.ndarray) -> int:
    """Count how many of some points are needed to tell a rotation.

    Parameters
    ----------
    cloud : (K, C) float
        Places of points, the most wanted first.

    Returns
    -------
    int
        The least number of leading points, at least C, that do not lie on a line (in a plane: in one place); 0 where
        all of them do.
    """
    components = cloud.shape[1]
    for count in range(components, len(cloud) + 1):
        centred = cloud[:count] - cloud[:count].mean(axis=0)
        extents = np.linalg.svd(centred, compute_uv=False)
        if extents[components - 2] > FLATTEST * extents[0] > 0:
            return count
    return 0


def carried(before: np.ndarray, after: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Carry a point along with a rigid body, by the rotation and shift that fit its other points best [1].

    Parameters
    ----------
    before : (K, C) float
        The body's other points in one frame.
    after : (T, K, C) float
        The same in others.
    point : (C,) float
        The point in the one frame.

    Returns
    -------
    (T, C) float
        The point in the others.
    """
    centre, centres = before.mean(axis=0), after.mean(axis=1)
    covariance = np.einsum("ki,tkj->tij", before - centre, after - centres[:, None])
    u, _, vt = np.linalg.svd(covariance)
    proper = np.sign(np.linalg.det(u @ vt))
    vt[:, -1] *= np.where(proper == 0, 1.0, proper)[:, None]
    turned: np.ndarray = np.einsum("tij,tjk,i->tk", u, vt, point - centre)
    return turned + centres
