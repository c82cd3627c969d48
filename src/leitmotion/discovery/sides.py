"""Sides: how far left and right part in a movement, told from D and D* alone.

Conventions
-----------
With Ψ = S + A of paper S, section 2.10, the squares of the angles are |S - S'|² + |A - A'|² in D, and in D*
|S - S'|² + |A + A'|². Their difference is four times the inner product of two antisymmetric parts, from which follows
all that is said here; it holds for small angles, and well enough for others. A *lasting* antisymmetric part is no
movement: a suit that sits askew, a head that is held to one side.

References
----------
Paper S, sections 2.10 and 2.13.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.discovery.labour import share_work

LARGEST = np.radians(12.0)  # of a mean link, by which both sides may differ for long and be alike
LEFT_OVER = np.radians(
    5.0
)  # that no posture may come nearer to a mirror image: noise, and the sides of a person
ROWS = 256  # that one core looks at together
NEAREST = 0.25  # quantile over the postures, of how near each comes to a mirror image


class Sides(NamedTuple):
    """What the sides of a stretch do."""

    parting: float
    """Share of its movement that is antisymmetric: 0 where both do the same, 1/2 where one moves, 1 where in turn.
    """
    lasting: float
    """Angle of a mean link by which its mean posture differs from its mirror image."""


def antisymmetric(own: np.ndarray, mirror: np.ndarray) -> np.ndarray:
    """Inner products of the antisymmetric parts of postures.

    Parameters
    ----------
    own, mirror : (K, K) float
        Angles in D and in D*.

    Returns
    -------
    (K, K) float
        Radians squared.
    """
    products: np.ndarray = np.square(mirror, dtype=np.float64)
    products -= np.square(own, dtype=np.float64)
    products /= 4
    return products


def sides_of(own: np.ndarray, products: np.ndarray, first: int, last: int) -> Sides:
    """Tell what the sides of a stretch do.

    Parameters
    ----------
    own : (K, K) float
        Angles in D.
    products : (K, K) float
        Of :func:`antisymmetric`.
    first, last : int
        The stretch, the last included.

    Returns
    -------
    Sides
        NaN nowhere; of a stretch without movement nothing parts.
    """
    stretch = slice(first, last + 1)
    inner = products[stretch, stretch]
    mean = max(float(inner.mean()), 0.0)
    whole = float((own[stretch, stretch] ** 2).mean()) / 2
    parting = (float(np.diagonal(inner).mean()) - mean) / whole if whole > 0 else 0.0
    return Sides(float(np.clip(parting, 0, 1)), 2 * float(np.sqrt(mean)))


def without_lasting(
    own: np.ndarray, products: np.ndarray, since: np.ndarray, until: np.ndarray
) -> np.ndarray:
    """Take out of D* what the sides differ by for long: throughout, or around each posture.

    Parameters
    ----------
    own, products : (K, K) float
        Angles in D, and what :func:`antisymmetric` makes.
    since, until : (K,) int
        Around each posture the stretch ``[since, until)``.

    Returns
    -------
    (K, K) float32
        Angles in D* without the mean antisymmetric part, of which no more than 12 degrees of a mean link are taken out,
        and without what is left at least between any posture and a mirror image. Of both means the one that makes a
        pair of postures more alike counts.
    """
    from leitmotion.discovery import _sides_kernels as kernels

    count = len(own)
    if not count:
        return np.zeros((0, 0), np.float32)
    near = _about_means(products, since, until)
    sizes, near_sizes = (np.diagonal(each).astype(np.float64) for each in (products, near))
    throughout = products.mean(axis=0)
    share = float(_share(2 * np.sqrt(max(float(throughout.mean()), 0.0))))
    all_sizes = sizes - 4 * share * throughout + 2 * share**2 * throughout.mean()
    squares = np.empty((count, count), np.float32)
    share_work(
        lambda some: kernels.least_squares(
            own, products, near, sizes, near_sizes, all_sizes, some.start, some.stop, squares
        ),
        count,
        ROWS,
    )
    left_over = min(float(np.quantile(squares.min(axis=1), NEAREST)), LEFT_OVER**2)
    np.subtract(squares, np.float32(left_over), out=squares)
    np.maximum(squares, 0, out=squares)
    mirror: np.ndarray = np.sqrt(squares, out=squares)
    return mirror


def _about_means(products: np.ndarray, since: np.ndarray, until: np.ndarray) -> np.ndarray:
    """Inner products of antisymmetric parts without the mean around each, as far as that is not too large."""
    from leitmotion.discovery import _sides_kernels as kernels

    count = len(products)
    part = np.empty((count, count), np.float32)
    share_work(
        lambda some: kernels.row_means(products, since, until, some.start, some.stop, part), count, ROWS
    )
    means = np.empty(count)
    kernels.mean_of_means(part, since, until, means)
    share = _share(2 * np.sqrt(np.maximum(means, 0)))
    share_work(
        lambda some: kernels.without_means(products, part, share, since, until, some.start, some.stop),
        count,
        ROWS,
    )
    return part


def _share(lasting: np.ndarray | float) -> np.ndarray:
    """How much of a mean antisymmetric part is taken out, by its angle."""
    return np.minimum(1.0, LARGEST / np.maximum(lasting, LARGEST))
