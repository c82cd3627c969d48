"""Frames and seconds: frames are ints, half-open ``[start, stop)``; seconds stand at the edges, through the rate."""

from __future__ import annotations

from leitmotion.motion.errors import ParameterError

FASTEST = 1e6
"""Hertz of the highest rate that is believed of a recording of movement."""


def slice_rate(rate: float, frames: slice) -> float:
    """Rate of a recording after slicing it along time.

    Parameters
    ----------
    rate : float
        Frames per second before.
    frames : slice
        The slice; a step of n keeps every n-th frame.

    Returns
    -------
    float
        Frames per second after.

    Raises
    ------
    ParameterError
        When it is not a slice or runs backwards.

    Examples
    --------
    >>> slice_rate(120.0, slice(None, None, 4))
    30.0
    """
    if not isinstance(frames, slice):
        raise ParameterError(f"A recording is cut by a slice of frames such as [100:400], got {frames!r}.")
    step = 1 if frames.step is None else int(frames.step)
    if step < 1:
        raise ParameterError(f"A recording is cut forwards in time, got a step of {step}.")
    return rate / step
