"""The rate of a table from its column of times."""

from __future__ import annotations

import numpy as np

from leitmotion.io.reading import Finding, Source

_NEAR = 5e-3  # how far, relatively, the rate of rounded times may lie from the whole one it is taken for
_UNEVEN = 0.2  # share of a step by which steps may differ without a word


def rate_of_times(source: Source, times: np.ndarray, column: str, warnings: list[str]) -> Finding:
    """Tell the rate from a column of times.

    Seconds; milliseconds or microseconds where the column says so or a step would be longer than a second.

    Parameters
    ----------
    source : Source
        The file, for the error and for a rate that the caller gave.
    times : (T,) float
        What the column holds.
    column : str
        What it is called.
    warnings : list of str
        Gains a sentence where the frames are unevenly spaced.

    Returns
    -------
    Finding
        Frames per second.

    Raises
    ------
    FormatError
        When the times do not grow.
    """
    steps = np.diff(times[np.isfinite(times)])
    step = float(np.median(steps)) if steps.size else 0.0
    if not step > 0:
        if source.options.rate is not None:
            return Finding(float(source.options.rate), "given", "rate given by the caller")
        raise source.error(
            f"expected times that grow in the column {column!r}, found none.",
            remedy="State the rate with --rate HZ.",
        )
    word = column.lower()
    unit, scale = "s", 1.0
    if "us" in word.split("_") or step > 1000.0:
        unit, scale = "µs", 1e-6
    elif word.endswith(("ms", "msec", "milliseconds")) or step > 1.0:
        unit, scale = "ms", 1e-3
    mean = float((np.nanmax(times) - np.nanmin(times)) / steps.size) * scale
    uneven = float(np.mean(np.abs(steps - step) > _UNEVEN * step))
    if uneven > 0.05:
        warnings.append(
            f"The frames are unevenly spaced: {uneven:.0%} of the steps differ from the median; they were taken as "
            f"even, {mean * 1000:.1f} ms apart on average."
        )
    exact = 1.0 / mean
    whole = round(exact)
    if whole > 0 and abs(whole / exact - 1.0) < _NEAR and uneven <= 0.05:
        return Finding(float(whole), "read", f"column {column!r} in {unit}, taken as {whole} Hz")
    return Finding(exact, "read", f"column {column!r} in {unit}")
