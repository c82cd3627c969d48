"""What is usual for a point at a time: robust scales that a spike or an exchange is measured against."""

from __future__ import annotations

import numpy as np

SPAN_S = 0.5  # of movement that says what is usual around a frame


def usual_around(values: np.ndarray, rate: float) -> np.ndarray:
    """Tell what is usual around each frame.

    Parameters
    ----------
    values : (T, P) float
        A measure of each point in each frame, NaN where there is none.
    rate : float
        Frames per second.

    Returns
    -------
    (T, P) float
        The largest median of three stretches of half a second (five frames at least): the one that holds the frame
        and those beside it, so that a movement that begins in the next one counts. Zero where nothing is known.
    """
    frames, points = values.shape
    width = max(5, round(SPAN_S * rate))
    blocks = max(1, -(-frames // width))
    padded = np.full((blocks * width, points), np.nan)
    padded[:frames] = values
    parts = np.sort(padded.reshape(blocks, width, points), axis=1)  # NaN sorts last
    counts = np.isfinite(parts).sum(axis=1)
    middle = np.maximum(counts - 1, 0) // 2
    medians = np.take_along_axis(parts, middle[:, None], axis=1)[:, 0]
    medians = np.where(counts > 0, medians, 0.0)
    edged = np.pad(medians, ((1, 1), (0, 0)))
    around = np.maximum(np.maximum(edged[:-2], edged[1:-1]), edged[2:])
    return np.repeat(around, width, axis=0)[:frames]


def least_step(positions: np.ndarray, unit: str, metres: float) -> float:
    """Tell how small a step may be and still count.

    Parameters
    ----------
    positions : (T, P, C) float
        Positions, NaN where unseen.
    unit : {"m", "px", "relative"}
        What they mean.
    metres : float
        The step of a person in metres.

    Returns
    -------
    float
        The same in the unit of the positions: where that is no metre, a person is taken to be 1.7 m and as long as
        the cloud of points is, usually, in its longest direction.
    """
    if unit == "m":
        return metres
    few = positions[:: max(1, len(positions) // 200)]
    few = few[np.isfinite(few).all(axis=2).any(axis=1)]
    if not len(few):
        return np.inf
    extents = (np.nanmax(few, axis=1) - np.nanmin(few, axis=1)).max(axis=1)
    return metres / 1.7 * float(np.median(extents))
