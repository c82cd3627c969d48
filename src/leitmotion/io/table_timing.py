"""When the rows of a table are: by its times, by what it states, or as the frames of a video."""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.reading import Finding, Source
from leitmotion.io.timing import Timing, read_times
from leitmotion.motion.time import FASTEST

VIDEO_RATE = 30.0
"""Frames per second that are guessed where rows are the frames of a video and nothing tells their rate."""

_STRETCH = 10.0  # frames a row beyond which the numbers of the frames are no numbers of frames


def time_rows(
    source: Source,
    *,
    times: np.ndarray | None,
    column: str,
    numbers: np.ndarray | None,
    stated: str,
    video: bool,
    warnings: list[str],
) -> Timing:
    """Tell rate and frames of the rows of a table.

    What the caller gave counts first, then a rate that the table states, unless its times tell another, then its times.

    Parameters
    ----------
    source : Source
        The file, for a rate that the caller gave and for the error.
    times : (R,) float or None
        The column of times.
    column : str
        What it is called.
    numbers : (R,) float or None
        The column of the numbers of the frames.
    stated : str
        What the table states as its rate, empty where it does not.
    video : bool
        Whether the rows are frames of a video, so that a rate may be guessed.
    warnings : list of str
        Gains a sentence where times and rate disagree, frames are missing or the rate was guessed.

    Returns
    -------
    Timing
        The rate and the frames.

    Raises
    ------
    FormatError
        When nothing tells the rate, or the times make no recording.
    """
    told = _stated_rate(stated)
    if told is not None and source.options.rate is None:
        if times is None:
            return _by_number(told, numbers, warnings)
        even = times[0] + np.arange(len(times)) / told.value
        if np.abs(times - even).max() < 0.5 / told.value:  # which no NaN is
            return Timing(told, None)
        warnings.append(
            f"A rate of {told.value:g} Hz is stated, but the times tell another; the times count."
        )
    if times is not None:
        return read_times(source, times, column, warnings)
    if source.options.rate is not None:
        given = Finding(source.options.rate, "given", "rate given by the caller")
        return _by_number(given, numbers, warnings)
    if not video:
        raise source.error("expected a column of times, found none.", remedy="State the rate with --rate HZ.")
    warnings.append(
        f"The table states no rate: as of a video, {VIDEO_RATE:g} frames per second were guessed; "
        "--rate HZ tells it better."
    )
    guessed = Finding(VIDEO_RATE, "guessed", "nothing tells; the usual rate of a video")
    return _by_number(guessed, numbers, warnings)


def _stated_rate(stated: str) -> Finding | None:
    number = re.match(r"\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+", stated)
    rate = float(number[0]) if number else 0.0
    return Finding(rate, "read", "stated by the table") if 1.0 / FASTEST < rate < FASTEST else None


def _by_number(rate: Finding, numbers: np.ndarray | None, warnings: list[str]) -> Timing:
    """Frames by the numbers of the rows, where these count and leave some out; else each row is a frame."""
    steps = np.diff(numbers) if numbers is not None else np.empty(0)
    if numbers is None or not steps.size or not np.isfinite(numbers).all() or (numbers % 1 != 0).any():
        return Timing(rate, None)
    missing = int(numbers[-1] - numbers[0]) + 1 - len(numbers)
    if missing <= 0 or (steps < 1).any() or np.median(steps) != 1 or missing > _STRETCH * len(numbers):
        return Timing(rate, None)
    rows = np.full(missing + len(numbers), -1)
    rows[(numbers - numbers[0]).astype(int)] = np.arange(len(numbers))
    warnings.append(f"{missing} frames are missing where the numbers of the frames leap.")
    return Timing(rate, rows)
