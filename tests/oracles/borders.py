"""Where movements begin and end, with numpy and scipy over the distances of all moments."""

import numpy as np
from scipy.ndimage import minimum_filter1d


def around(D, frame, other, beside):
    """Mean distance of what stands beside two frames; infinite where something was not seen or nothing is left."""
    pairs = [(frame + k, other + k) for k in beside]
    inside = [D[i, j] for i, j in pairs if min(i, j) >= 0 and max(i, j) < len(D)]
    mean = np.mean(inside) if inside else np.inf
    return np.inf if np.isnan(mean) else mean


def pauses(speed, reach, around, share):
    """Slowest moments, slower than before and after."""
    lowest = minimum_filter1d(speed, 2 * reach + 1)
    found = []
    for p in np.flatnonzero(speed <= lowest).tolist():
        before, after = speed[max(0, p - around) : p + 1].max(), speed[p : p + around + 1].max()
        if speed[p] < share * min(before, after) and not (found and p - found[-1] < reach):
            found.append(p)
    return found


def closes(D, path, away, near, back, settle):
    """Whether both stretches lead away and come back."""
    for first, last in zip(path[0], path[-1], strict=True):
        apart = D[first, first : last + 1]
        farthest = np.nanmax(apart)
        if farthest < away or not np.nanmin(apart[-1 - settle :], initial=np.inf) <= max(
            near, back * farthest
        ):
            return False
    return True
