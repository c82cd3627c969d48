"""Dynamic time warping: which moment of one stretch is which moment of another.

Conventions
-----------
``d (N, M)`` holds local distances, rows are moments of the first stretch. A path begins at (0, 0), ends at
(N - 1, M - 1) and never steps back in time; an open begin or end frees the column where it starts or ends, so
that the whole of the first is found somewhere in the second.

References
----------
Sakoe, Chiba, "Dynamic programming algorithm optimization for spoken word recognition", 1978: step patterns.
"""

from __future__ import annotations

import numpy as np

from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import DataError, ParameterError
from leitmotion.similarity.alignment import Alignment
from leitmotion.similarity.distance import _across_time, _centre, check_comparable, cross_distance
from leitmotion.similarity.matrix import SimilarityMatrix

STEPS = {"symmetric1": (1.0, False), "symmetric2": (2.0, False), "symmetricP1": (2.0, True)}
"""Weight of a diagonal step, and whether the slope stays within [1/2, 2]."""


def align(
    a: FeatureSequence | SimilarityMatrix | np.ndarray,
    b: FeatureSequence | None = None,
    *,
    step: str = "symmetric1",
    open_begin: bool = False,
    open_end: bool = False,
) -> Alignment:
    """Align two stretches in time so that the distances along the way are least.

    Parameters
    ----------
    a : FeatureSequence, SimilarityMatrix or (N, M) array
        The first stretch, or the distances of two. A NaN distance cannot be passed.
    b : FeatureSequence, optional
        The second stretch, when `a` is the first.
    step : {"symmetric1", "symmetric2", "symmetricP1"}
        "symmetric1" minimises the plain sum of distances. "symmetric2" counts a diagonal step twice, so that
        a path of few diagonals is not dearer for its length. "symmetricP1" also keeps the slope within
        [1/2, 2] everywhere: neither stretch may run more than twice as fast as the other.
    open_begin, open_end : bool
        Whether the first may begin or end anywhere in the second. An open end is put where the weighted mean
        of the distances is least.

    Returns
    -------
    Alignment
        `path` (K, 2), `cost` the mean distance of its K cells, `stop` in frames of the second.

    Raises
    ------
    ParameterError
        When a step pattern is unknown, or it is not said what to align.
    DataError
        When a stretch is empty, or no path leads through.

    Examples
    --------
    >>> import numpy as np
    >>> slow, fast = np.array([0, 1, 1, 2, 3, 3]), np.array([0, 1, 2, 3])
    >>> alignment = align(abs(slow[:, None] - fast))
    >>> alignment.cost, alignment.path.tolist()
    (0.0, [[0, 0], [1, 1], [2, 1], [3, 2], [4, 3], [5, 3]])
    """
    d = _local_distances(a, b)
    if step not in STEPS:
        raise ParameterError(f"step must be one of {', '.join(STEPS)}, got {step!r}.")
    w, limited = STEPS[step]
    from leitmotion.similarity import _kernels

    move = np.empty(d.shape, np.uint8)
    D, W = _kernels.accumulate(d, w, limited, open_begin, move)
    end = _best_end(D, W) if open_end else d.shape[1] - 1
    if not np.isfinite(D[end]):
        raise DataError(
            f"No path leads through the {d.shape[0]} x {d.shape[1]} distances with steps {step!r}.",
            remedy="One stretch is more than twice as long as the other, or distances are missing across.",
        )
    path = _kernels.trace_back(move, end)
    return Alignment(path=path, cost=float(d[path[:, 0], path[:, 1]].mean()), stop=int(end) + 1)


def warping_cost(a: FeatureSequence, b: FeatureSequence, unseen: float) -> float:
    """Mean distance of two stretches along their warping path, in memory that grows with their length alone.

    What :func:`align` calls cost, with steps "symmetric1" and without the path; so two stretches of minutes, whose
    distances would fill the memory, are compared, too. Time grows with the product of their lengths.

    Parameters
    ----------
    a, b : FeatureSequence
        The stretches. Moments of which nothing was seen are left out.
    unseen : float
        The distance of moments that share no group, in the unit of the features.

    Returns
    -------
    float
        `unseen` where nothing was seen of one of them.

    Raises
    ------
    ParameterError
        When the two do not hold the same features.

    Examples
    --------
    >>> slow = FeatureSequence([[0.0], [1.0], [1.0], [2.0], [3.0], [3.0]], ("hand",), rate=30)
    >>> fast = slow.replace(values=[[0.0], [1.0], [2.0], [3.0]])
    >>> warping_cost(slow, fast, 1.0)
    0.0
    """
    check_comparable(a, b)
    rows, columns = (_across_time(stretch, _centre("mean_norm", a)) for stretch in (a, b))
    rows, columns = (part[:, _seen(part, a.width)] for part in (rows, columns))
    if not rows.size or not columns.size:
        return unseen
    from leitmotion.similarity import _kernels

    joined = np.ascontiguousarray(np.concatenate((rows, columns), axis=1))
    return float(_kernels.warping_cost(joined, rows.shape[1], a.width, float(unseen)))


def _seen(across: np.ndarray, width: int) -> np.ndarray:
    """Moments of which a whole group was seen, (T,) bool."""
    groups = across.reshape(-1, width, across.shape[1])
    return np.asarray(np.isfinite(groups).all(axis=1).any(axis=0))


def _local_distances(
    a: FeatureSequence | SimilarityMatrix | np.ndarray, b: FeatureSequence | None
) -> np.ndarray:
    if isinstance(a, FeatureSequence):
        if not isinstance(b, FeatureSequence):
            raise ParameterError(
                "align takes two FeatureSequences or one matrix of distances, got one sequence."
            )
        a = cross_distance(a, b)
    elif b is not None:
        raise ParameterError(
            "align takes two FeatureSequences or one matrix of distances, got a matrix and more."
        )
    d = np.asarray(a.values if isinstance(a, SimilarityMatrix) else a, dtype=np.float64)
    if d.ndim != 2 or d.size == 0:
        raise DataError(
            f"An alignment needs two stretches of at least one frame, got distances of shape {d.shape}."
        )
    return np.where(np.isnan(d), np.inf, d)


def _best_end(D: np.ndarray, W: np.ndarray) -> int:
    """Find the column with the least mean weighted distance; the first of equals."""
    return int(np.argmin(np.where(np.isfinite(D), D / np.maximum(W, 1.0), np.inf)))
