# mypy: allow-untyped-defs
"""Loops of the layout of a graph: which lines cross, pass over cards, and come near one another."""

import math

from numba import njit


@njit(cache=True)
def count_crossings(a, b):
    """Count the pairs of lines from a[i] (P, 2) to b[i] that cross within both."""
    count = 0
    for i in range(len(a)):
        for j in range(i):
            if _parts(a[i], b[i], a[j], b[j]) and _parts(a[j], b[j], a[i], b[i]):
                count += 1
    return count


@njit(cache=True)
def _parts(a, b, c, d):
    """Whether the straight line through a and b has c and d on different sides."""
    one = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    two = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0])
    return (one > 0 and two < 0) or (one < 0 and two > 0)


@njit(cache=True)
def count_passed(a, b, cards, half_wide, half_high):
    """Count the pairs of a line from a[i] (P, 2) to b[i] and a card about cards[k] (N, 2) that it passes over.

    A line begins and ends in cards of its own, which count.
    """
    count = 0
    for i in range(len(a)):
        for k in range(len(cards)):
            enter, leave = 0.0, 1.0
            for axis in range(2):
                half = half_wide if axis == 0 else half_high
                low, high = cards[k, axis] - half - a[i, axis], cards[k, axis] + half - a[i, axis]
                way = b[i, axis] - a[i, axis]
                if way == 0.0:
                    if not low < 0.0 < high:
                        leave = -1.0
                elif way > 0:
                    enter, leave = max(enter, low / way), min(leave, high / way)
                else:
                    enter, leave = max(enter, high / way), min(leave, low / way)
            if enter < leave:
                count += 1
    return count


@njit(cache=True)
def crowd(points, others, near, touch, ends, tips):
    """Tell how much a curve of points (K, 2) crowds others (L, K, 2).

    Returns the sum over the others of how near its points are to that curve, `ends` at both ends apart: 1 where they
    lie upon it, 0 from `near` on; and how many of them it touches, `tips` at both ends apart.
    """
    K = len(points)
    close, touched = 0.0, 0
    for other in range(len(others)):
        if _farther(points, others[other], near):
            continue
        beside, least = 0.0, math.inf
        for k in range(ends, K - ends):
            apart = math.inf  # squared
            for j in range(K):
                x, y = points[k, 0] - others[other, j, 0], points[k, 1] - others[other, j, 1]
                apart = min(apart, x * x + y * y)
            if apart < near * near:
                beside += 1 - math.sqrt(apart) / near
            if tips <= k < K - tips:
                least = min(least, apart)
        close += beside / (K - 2 * ends)
        if least < touch * touch:
            touched += 1
    return close, touched


@njit(cache=True)
def _farther(points, others, near):
    """Whether the boxes about two curves lie farther apart than `near`."""
    for axis in range(2):
        low, high = math.inf, -math.inf
        first, last = math.inf, -math.inf
        for k in range(len(points)):
            low, high = min(low, points[k, axis]), max(high, points[k, axis])
            first, last = min(first, others[k, axis]), max(last, others[k, axis])
        if low - last > near or first - high > near:
            return True
    return False
