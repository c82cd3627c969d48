"""Frames from a column of times: the rate, and where rows are not evenly spaced, which row each frame takes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.io.reading import Finding, Source

_NEAR = 5e-3  # how far, relatively, the rate of rounded times may lie from the whole one it is taken for
_UNEVEN = 0.2  # share of the median step by which steps may differ without a word
_SHORTEST = 1e-12  # of a step that is one
_GAP = 10.0  # median steps without a row that are a gap
_DRIFT = 2.0  # steps by which a row may lie from where even steps put it
_STRETCH = 10.0  # frames a row beyond which a table is mostly gap
_LAST = 1e20  # beyond it a number is no time; the nanoseconds since 1970 are 1.8e18
_TOLD = 3  # gaps that a warning names
_AS_FRAMES = "or state the rate with --rate HZ, which makes each row a frame."


class Timing(NamedTuple):
    """When the rows of a table are."""

    rate: Finding
    """Frames per second."""

    rows: np.ndarray | None
    """(T,) the row that each frame takes, -1 where none is near; None where each row is a frame."""

    def place(self, values: np.ndarray, missing: float = np.nan) -> np.ndarray:
        """Bring an array of rows (R, …) to frames (T, …)."""
        if self.rows is None:
            return values
        placed = values[self.rows]
        placed[self.rows < 0] = missing
        return placed


def read_times(source: Source, times: np.ndarray, column: str, warnings: list[str]) -> Timing:
    """Tell rate and frames from a column of times.

    Seconds; milliseconds or microseconds where the column says so or a step would be longer than a second. The step is
    the mean of those that are no gap, where rows so spaced stay near their times, else the usual one, the mean of
    those near the median; then every frame takes the row nearest in time. In a gap no frame takes a row. A rate that
    the caller gave makes each row a frame.

    Parameters
    ----------
    source : Source
        The file, for the error and for a rate that the caller gave.
    times : (R,) float
        What the column holds.
    column : str
        What it is called.
    warnings : list of str
        Gains a sentence where rows are unevenly spaced, and one where rows are missing.

    Returns
    -------
    Timing
        The rate and the frames.

    Raises
    ------
    FormatError
        When there is one row only, the times do not grow, or the gaps are much longer than what lies between them.
    """
    timed = np.flatnonzero(np.abs(times) < _LAST)
    spans, counts = np.diff(times[timed]), np.diff(timed)
    steps = spans / counts
    median = float(np.median(steps)) if steps.size else 0.0
    gaps = steps > (_GAP * median if median > 0 else np.inf)
    if source.options.rate is not None:
        if gaps.any():
            warnings.append(
                f"The column {column!r} leaps; with the rate given, each row was taken as a frame."
            )
        return Timing(Finding(source.options.rate, "given", "rate given by the caller"), None)
    _check_growth(source, spans, timed, median, column)

    name, scale = _unit(column, median)
    mean = float(spans[~gaps].sum() / counts[~gaps].sum())
    closed = np.concatenate(([0.0], np.cumsum(np.where(gaps, mean * counts, spans))))
    adrift = bool(np.abs(closed - (timed - timed[0]) * mean).max() > _DRIFT * mean)
    usual = np.abs(steps - median) <= _UNEVEN * median
    uneven = float(np.mean(~usual & ~gaps))
    step = mean
    if adrift:
        step = float(steps[usual].mean()) if usual.any() else median
    rate = _rate(step * scale, uneven, f"column {column!r} in {name}", adrift)
    spread = f"The frames are unevenly spaced: {uneven:.0%} of the steps differ from the median"
    if uneven > 0.05 and not adrift:
        warnings.append(f"{spread}; they were taken as even, {step * scale * 1000:.1f} ms apart on average.")
    if not (adrift or gaps.any()):
        return Timing(rate, None)

    where = (times[timed] - times[timed].min()) * scale * rate.value  # in frames
    if not adrift:  # between gaps, each row is a frame
        leaps = np.cumsum(np.where(gaps, spans * scale * rate.value - counts, 0.0))
        where = timed - timed[0] + np.concatenate(([0.0], np.rint(leaps)))
    if where.max() > _STRETCH * len(times):
        raise source.error(
            f"the column {column!r} spans {where.max() / rate.value:.6g} s, in which its {len(times)} rows, "
            f"{step * scale * 1000:.3g} ms apart, would be lost.",
            remedy=f"Part the file where its times leap (row {int(timed[np.argmax(steps) + 1]) + 1}), {_AS_FRAMES}",
        )
    rows = _nearest(where, timed, _GAP * median * scale * rate.value)
    if adrift:
        taken = np.unique(rows[rows >= 0])
        again, unused = int((rows >= 0).sum()) - len(taken), len(times) - len(taken)
        warnings.append(
            f"{spread}; every {1000 / rate.value:.1f} ms a frame took the row nearest in time: "
            f"{again} frames repeat a row, {unused} rows were left out."
        )
    if gaps.any():
        warnings.append(_tell_gaps(gaps, spans * scale, timed, (times - times[timed[0]]) * scale, rows))
    return Timing(rate, rows)


def _check_growth(source: Source, spans: np.ndarray, timed: np.ndarray, median: float, column: str) -> None:
    if len(timed) == 1:
        raise source.error("one row of numbers tells no rate.", remedy="State the rate with --rate HZ.")
    if not median > _SHORTEST:
        raise source.error(
            f"expected times that grow from row to row in the column {column!r}, found that they mostly do not.",
            remedy="State the rate with --rate HZ.",
        )
    back = np.flatnonzero(spans < -_GAP * median)
    if back.size:
        raise source.error(
            f"expected times that grow in the column {column!r}, found that they leap back in row "
            f"{int(timed[back[0] + 1]) + 1} of the table.",
            remedy=f"Part the file there, {_AS_FRAMES}",
        )


def _unit(column: str, step: float) -> tuple[str, float]:
    word = column.lower()
    if "us" in word.split("_") or step > 1000.0:
        return "µs", 1e-6
    if word.endswith(("ms", "msec", "milliseconds")) or step > 1.0:
        return "ms", 1e-3
    return "s", 1.0


def _rate(seconds: float, uneven: float, reason: str, adrift: bool) -> Finding:
    exact = 1.0 / seconds
    if adrift:
        reason = f"{reason}, its usual step of {seconds * 1000:.1f} ms"
    whole = round(exact)
    if whole > 0 and abs(whole / exact - 1.0) < _NEAR and uneven <= 0.05:
        return Finding(float(whole), "read", f"{reason}, taken as {whole} Hz")
    return Finding(exact, "read", reason)


def _nearest(where: np.ndarray, timed: np.ndarray, gap: float) -> np.ndarray:
    """The row nearest to each frame; -1 within a gap, more than half a frame from its borders."""
    order = np.argsort(where, kind="stable")
    where = where[order]
    frames = np.arange(round(float(where[-1])) + 1)
    after = np.clip(np.searchsorted(where, frames), 1, len(where) - 1)
    before = after - 1
    nearest = np.where(frames - where[before] <= where[after] - frames, before, after)
    alone = (where[after] - where[before] > gap) & (np.abs(frames - where[nearest]) > 0.5)
    return np.where(alone, -1, timed[order][nearest])


def _tell_gaps(
    gaps: np.ndarray, seconds: np.ndarray, timed: np.ndarray, times: np.ndarray, rows: np.ndarray
) -> str:
    places = np.flatnonzero(gaps)
    told = [
        f"{seconds[k]:.3g} s after row {timed[k] + 1} (at {times[timed[k]]:.2f} s)" for k in places[:_TOLD]
    ]
    more = f" and {len(places) - _TOLD} more" if len(places) > _TOLD else ""
    return f"{int((rows < 0).sum())} frames are missing where the times leap: {', '.join(told)}{more}."
