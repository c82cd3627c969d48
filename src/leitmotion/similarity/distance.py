"""Distances between the moments of one recording, or of two.

Conventions
-----------
A frame is D = M·width numbers: M groups of `width` (3 for a point, 4 for a quaternion, 1 for a number). The
distance of two frames is the mean over the groups of what the metric says of one group, so it has the unit of
the features and does not grow with the number of joints.

References
----------
Paper P, section 2.2: Tang, Leung, Komura, Shum, "Finding repetitive patterns in 3D human motion captured
data", 2008.
"""

from __future__ import annotations

import os

import numpy as np

from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import DataError, ParameterError
from leitmotion.similarity.matrix import SimilarityMatrix

METRICS = ("mean_norm", "geodesic")
MEMORY_SHARE = 0.75  # of the machine's memory, the most one matrix may take


def self_distance(features: FeatureSequence, *, metric: str = "mean_norm") -> SimilarityMatrix:
    """Compare every moment of a recording with every other.

    Paper P, eq. 2: ``C(i, j) = (1/M) Σ_m ‖p_i,m - p_j,m‖``, a mean of norms. Symmetric to the bit, zero on
    the diagonal, and a metric.

    Parameters
    ----------
    features : FeatureSequence
        (T, D) values in M groups of `features.width`. A group with NaN in either frame is left out of the
        mean; frames that share no group are NaN apart.
    metric : {"mean_norm", "geodesic"}
        "mean_norm" is eq. 2. "geodesic" takes groups of 4 as unit quaternions and gives the mean angle
        between the rotations, radians; q and -q are the same rotation.

    Returns
    -------
    SimilarityMatrix
        (T, T) float32, with the scale and unit of the features.

    Raises
    ------
    ParameterError
        When the metric is unknown or does not fit the width.
    DataError
        When the matrix would not fit in memory.

    Examples
    --------
    >>> from leitmotion.features import FeatureSequence
    >>> hand = FeatureSequence([[0, 0, 0], [3, 4, 0]], ("hand",), rate=60, width=3)
    >>> self_distance(hand).values.tolist()
    [[0.0, 5.0], [5.0, 0.0]]
    """
    kind = _kind_of_tile(metric, features)
    rows = _across_time(features, _centre(metric, features))
    values = _blank(len(features), len(features))
    from leitmotion.similarity import _kernels

    _kernels.self_distance(rows, features.width, kind, values)
    return _matrix(values, metric, features, features)


def cross_distance(a: FeatureSequence, b: FeatureSequence, *, metric: str = "mean_norm") -> SimilarityMatrix:
    """Compare every moment of one recording with every moment of another.

    Parameters
    ----------
    a, b : FeatureSequence
        (N, D) and (M, D) values with the same names and width.
    metric : {"mean_norm", "geodesic"}
        As in :func:`self_distance`.

    Returns
    -------
    SimilarityMatrix
        (N, M) float32: rows are moments of `a`, columns of `b`. Its `scale` is the mean of the two.

    Raises
    ------
    ParameterError
        When the two do not hold the same features, or the metric is unknown or does not fit.
    DataError
        When the matrix would not fit in memory.

    Examples
    --------
    >>> from leitmotion.features import FeatureSequence
    >>> hand = FeatureSequence([[0, 0, 0], [3, 4, 0]], ("hand",), rate=60, width=3)
    >>> cross_distance(hand, hand[1:]).values.tolist()
    [[5.0], [0.0]]
    """
    check_comparable(a, b)
    kind = max(_kind_of_tile(metric, a), _kind_of_tile(metric, b))
    centre = _centre(metric, a)
    values = _blank(len(a), len(b))
    from leitmotion.similarity import _kernels

    _kernels.cross_distance(_across_time(a, centre), _across_time(b, centre), a.width, kind, values)
    return _matrix(values, metric, a, b)


def _kind_of_tile(metric: str, features: FeatureSequence) -> int:
    """Choose the kernel's loop; ordered so that the larger of two also serves the other."""
    if metric not in METRICS:
        raise ParameterError(f"metric must be one of {', '.join(METRICS)}, got {metric!r}.")
    if metric == "geodesic" and features.width != 4:
        raise ParameterError(
            f"metric 'geodesic' needs quaternions, groups of 4 values, got groups of {features.width}.",
            remedy="Take joint rotations, or metric 'mean_norm'.",
        )
    from leitmotion.similarity._kernels import ANGLES, GROUPS, POINTS

    if metric == "geodesic":
        return ANGLES
    all_seen = features.width == 3 and not np.isnan(features.values.sum())
    return POINTS if all_seen else GROUPS


def check_comparable(a: FeatureSequence, b: FeatureSequence) -> None:
    """Refuse to compare what does not hold the same features in the same unit."""
    if a.names != b.names or a.width != b.width:
        missing = sorted(set(a.names) ^ set(b.names))
        what = f"these stand in one only: {', '.join(missing)}" if missing else "order or width differ"
        raise ParameterError(
            f"Two recordings are compared by the same features, got {len(a.names)} and {len(b.names)} names; "
            f"{what}.",
            remedy="Compute both from the same roles.",
        )
    if a.unit != b.unit:
        raise ParameterError(f"Two recordings are compared in one unit, got {a.unit!r} and {b.unit!r}.")


def _centre(metric: str, features: FeatureSequence) -> np.ndarray:
    """Choose what to subtract before rounding to float32, so that a far-off origin eats no digits."""
    dimensions = features.values.shape[1]
    if metric == "geodesic" or len(features) == 0:
        return np.zeros(dimensions)
    seen = np.isfinite(features.values)
    total = np.where(seen, features.values, 0.0).sum(axis=0)
    return np.asarray(total / np.maximum(seen.sum(axis=0), 1))


def _across_time(features: FeatureSequence, centre: np.ndarray) -> np.ndarray:
    """Turn to (D, T) float32, one dimension at a time so that no second large array is made."""
    rows = np.empty(features.values.shape[::-1], np.float32)
    for d, middle in enumerate(centre):
        rows[d] = features.values[:, d] - middle
    return rows


def _blank(rows: int, columns: int) -> np.ndarray:
    """Make room for the matrix, or say that there is none before the system ends the process for want of it."""
    needed = 4 * rows * columns
    if needed > MEMORY_SHARE * _memory():
        raise DataError(
            f"Comparing {rows:,} moments with {columns:,} needs {needed / 1e9:.1f} GB of memory.",
            remedy="Take every n-th frame, or a window of the recording.",
        )
    return np.empty((rows, columns), np.float32)


def _memory() -> float:
    """Bytes of memory this machine has; infinite where it does not tell."""
    try:
        return float(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (AttributeError, ValueError, OSError):
        return float("inf")


def _matrix(values: np.ndarray, metric: str, a: FeatureSequence, b: FeatureSequence) -> SimilarityMatrix:
    values.flags.writeable = False  # a read-only array is taken over by the noun, not copied
    angle = metric == "geodesic"
    return SimilarityMatrix(
        values,
        metric,
        row_rate=a.rate,
        column_rate=b.rate,
        scale=1.0 if angle else (a.scale + b.scale) / 2,
        unit="rad" if angle else a.unit,
    )
