"""What the sides differ by for long, taken out of the angles in D*: posture by posture, in double precision."""

import numpy as np


def without_lasting(own, products, since, until, *, largest, left_over, nearest):
    """The same as the library's, by its definition: antisymmetric parts without their means."""
    count = len(own)
    squares = np.full((count, count), np.inf)
    for window in ((since, until), (np.zeros(count, int), np.full(count, count))):
        around = [np.arange(start, stop) for start, stop in zip(*window, strict=True)]
        means = np.array([products[each].mean(axis=0) for each in around])
        lasting = [2 * np.sqrt(max(means[i, each].mean(), 0)) for i, each in enumerate(around)]
        share = np.array([min(1, largest / angle) if angle else 1 for angle in lasting])
        part = products - share[:, None] * means
        part = part - share * np.array([part[:, each].mean(axis=1) for each in around]).T
        for i in range(count):
            for j in range(count):
                symmetric = own[i, j] ** 2 - (products[i, i] + products[j, j] - 2 * products[i, j])
                square = symmetric + part[i, i] + part[j, j] + 2 * part[i, j]
                squares[i, j] = min(squares[i, j], max(square, 0))
    least = min(np.quantile(squares.min(axis=1), nearest), left_over**2)
    return np.sqrt(np.maximum(squares - least, 0))
