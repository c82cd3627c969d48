"""Local alignment written to be obviously right: a dictionary of cells, no ring of rows."""

import numpy as np


def align_locally(D, theta, still, still_distance, still_gain, ceiling):
    """Gain and best predecessor of every cell above the diagonal that a path reaches."""
    N = len(D)
    H, S, step = {}, {}, {}
    for i in range(N):
        first = i + 1
        while first < N and D[i, first] < min(theta[i], theta[first]):
            first += 1
        for j in range(first, N):
            if still[i] or still[j]:
                gain = still_gain if D[i, j] < still_distance else -1.0
            else:
                gain = max(-1.0, 1.0 - D[i, j] / min(theta[i], theta[j]))
            entries = [(H.get((i - a, j - b), 0.0), (i - a, j - b)) for a, b in ((1, 1), (2, 1), (1, 2))]
            height, source = max(entries, key=lambda entry: entry[0])
            height = min(height, ceiling) + gain
            if height > 0:
                H[i, j] = height
                S[i, j] = S.get(source, 0.0) + gain
                step[i, j] = source if source in H else None
    return np.array([[S.get((i, j), 0.0) for j in range(N)] for i in range(N)]), step


def measure(path, D, alike):
    """Cost, background and gain of a path that needs no trimming."""
    i, j = path.T
    d = D[i, j].astype(float)
    gain = np.where(
        alike.still[i] | alike.still[j], -0.1, 1 - d / np.minimum(alike.threshold[i], alike.threshold[j])
    )
    every = max(1, len(path) // 64)
    block = D[i[0] : i[-1] + 1 : every, j[0] : j[-1] + 1 : every]
    return np.nanmean(d), np.nanmedian(block), np.nansum(gain)
