# mypy: allow-untyped-defs
"""Loops over inner products P (K, K) of antisymmetric parts: means around each posture, and what is left without them.

The stretch around posture i is ``[since[i], until[i])``.
"""

import numpy as np
from numba import njit

BLOCK = 64  # columns whose running sums stay in the second-level cache


@njit(cache=True, nogil=True)
def row_means(P, since, until, first, last, R):
    """Fill columns [first, last) of R (K, K): R[i, j] is the mean of P[k, j] over the stretch around i."""
    K = P.shape[0]
    summed = np.empty((K + 1, BLOCK))
    for j0 in range(first, last, BLOCK):
        width = min(BLOCK, last - j0)
        summed[0] = 0.0
        for k in range(K):
            for j in range(width):
                summed[k + 1, j] = summed[k, j] + P[k, j0 + j]
        for i in range(K):
            share = 1.0 / (until[i] - since[i])
            upper, lower = summed[until[i]], summed[since[i]]
            for j in range(width):
                R[i, j0 + j] = (upper[j] - lower[j]) * share


@njit(cache=True, nogil=True)
def mean_of_means(R, since, until, means):
    """Fill means (K,) with the mean of R[i, k] over the k around i."""
    for i in range(R.shape[0]):
        total = 0.0
        for k in range(since[i], until[i]):
            total += R[i, k]
        means[i] = total / (until[i] - since[i])


@njit(cache=True, nogil=True)
def without_means(P, R, share, since, until, first, last):
    """Turn rows [first, last) of R into P without share times the mean around each posture, on both sides."""
    K = P.shape[0]
    row = np.empty(K)
    summed = np.empty(K + 1)
    summed[0] = 0.0
    for i in range(first, last):
        for k in range(K):
            row[k] = P[i, k] - share[i] * R[i, k]
        for k in range(K):
            summed[k + 1] = summed[k] + row[k]
        for j in range(K):
            R[i, j] = row[j] - share[j] * (summed[until[j]] - summed[since[j]]) / (until[j] - since[j])


@njit(cache=True, nogil=True)
def least_squares(own, P, near, sizes, near_sizes, all_sizes, first, last, squares):
    """Fill rows [first, last) of squares (K, K) with the lesser of two squares of the angle in D*.

    `near` is P without the mean around each posture, `sizes` and `near_sizes` are the diagonals. What the mean of all
    takes out of sizes and products together stands in `all_sizes`.
    """
    K = P.shape[0]
    for i in range(first, last):
        size, near_size, all_size = sizes[i], near_sizes[i], all_sizes[i]
        for j in range(K):
            angle = np.float64(own[i, j])
            symmetric = angle * angle - size - sizes[j] + 2.0 * P[i, j]
            one = near_size + near_sizes[j] + 2.0 * near[i, j]
            two = all_size + all_sizes[j] + 2.0 * P[i, j]
            square = symmetric + (one if one < two else two)
            squares[i, j] = square if square > 0.0 else 0.0
