"""Gaps: stretches in which a point was not seen, filled by a method that has a name.

Conventions
-----------
A gap is a run of frames in which a point lacks a coordinate, between two frames that show it. What lies before the
first or after the last frame that shows a point is no gap: nothing is extrapolated. A frame that was seen keeps its
bits, and a filled stretch meets them without a jump.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion import ParameterError, Trajectories
from leitmotion.repairs.lines import line, shares
from leitmotion.repairs.repaired import Change, Repaired, listed, need_points, placed_anew, runs
from leitmotion.repairs.rigid import MOST, carried, companions, spanning

SPLINE_S = 0.2  # a gap up to this long is better filled by a spline than by neighbours (docs/benchmarks.md)
LONGEST_S = {"linear": 0.2, "spline": SPLINE_S, "rigid": 1.0}
"""Methods, and the longest gap that each fills unless told otherwise, seconds."""
KNOTS = 8  # frames on each side that a spline runs through


def fill_gaps(
    trajectories: Trajectories, *, method: str = "rigid", max_gap_s: float | None = None
) -> Repaired:
    """Fill the gaps of each point.

    Parameters
    ----------
    trajectories : Trajectories
        T frames of P points.
    method : {"linear", "spline", "rigid"}
        A straight line between the last frame before the gap and the first after it; a cubic spline through the eight
        frames before and the eight after it (not-a-knot: a cubic is restored exactly); or as part of a rigid body: of
        the points that keep their distance to the lost one, the steadiest that show the whole gap, at least three
        (two in a plane) and not in a line, carry it along, from the last frame before the gap and from the first
        after it; the two answers are blended in proportion to the time, so that both ends fit. A piece cut out of a
        rigid body is restored exactly. A gap that too few such points bridge is filled by a spline if it is not
        longer than that fills; the change says so. Markers on the skin are not quite a rigid body: up to 0.2 s a
        spline is nearer to the truth, so that "spline" first and then "rigid" is better than "rigid" alone.
    max_gap_s : float, optional
        The longest gap to fill, seconds; by default 0.2, and 1 for "rigid".

    Returns
    -------
    Repaired
        The points, a change "fill" for every gap that was filled, and a remark that counts those that were not. The
        confidence of a filled stretch is the lesser of those before and after it.

    Raises
    ------
    ParameterError
        When it is no recording of points, or the method is none of these.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> walk = np.arange(20.0).reshape(20, 1, 1) * [1.0, 0.5, 0.0]
    >>> walk[8:11] = np.nan
    >>> mended = fill_gaps(Trajectories(("LANK",), walk, rate=100), method="linear")
    >>> mended.recording.positions[9].tolist(), mended.changes[0][:4]
    ([[9.0, 4.5, 0.0]], ('fill', 'LANK', 8, 11))
    """
    trajectories = need_points(trajectories, "Filling gaps")
    if method not in LONGEST_S:
        raise ParameterError(f"The method must be one of {', '.join(LONGEST_S)}, got {method!r}.")
    longest_s = LONGEST_S[method] if max_gap_s is None else max_gap_s
    if not longest_s > 0:
        raise ParameterError(f"max_gap_s must be a positive number of seconds, got {max_gap_s!r}.")
    rate, seen_positions = trajectories.rate, trajectories.positions
    positions = seen_positions.copy()
    changes: list[Change] = []
    too_long, unbridged, at_ends = [], [], []
    for point, name in enumerate(trajectories.names):
        lost = np.isnan(seen_positions[:, point]).any(axis=1)
        if not lost.any() or lost.all():
            continue
        body = companions(seen_positions, point) if method == "rigid" else None
        for start, stop in runs(lost):
            if start == 0 or stop == len(lost):
                at_ends.append(name)
            elif (stop - start) > longest_s * rate + 1e-6:
                too_long.append(name)
            else:
                how, filled = _filled(seen_positions, point, start, stop, method, body, rate)
                if filled is None:
                    unbridged.append(name)
                    continue
                positions[start:stop, point] = filled
                changes.append(Change("fill", name, start, stop, how))
    remarks = [
        f"{len(names)} {'gap' if len(names) == 1 else 'gaps'} {why} left ({listed(sorted(set(names)))})."
        for names, why in (
            (too_long, f"longer than {longest_s:g} s {'was' if len(too_long) == 1 else 'were'}"),
            (unbridged, f"without three steady neighbours {'was' if len(unbridged) == 1 else 'were'}"),
            (at_ends, f"at the start or the end {'was' if len(at_ends) == 1 else 'were'}"),
        )
        if names
    ]
    recording = placed_anew(trajectories, positions) if changes else trajectories
    return Repaired(recording, tuple(changes), tuple(remarks))


def _filled(
    positions: np.ndarray,
    point: int,
    start: int,
    stop: int,
    method: str,
    body: np.ndarray | None,
    rate: float,
) -> tuple[str, np.ndarray | None]:
    """Fill one gap; None where nothing bridges it."""
    if body is not None:
        helpers = _helpers(positions, start, stop, body)
        if helpers.size:
            return f"rigid, by {helpers.size} neighbours", _by_body(positions, point, start, stop, helpers)
        if stop - start > SPLINE_S * rate + 1e-6:
            return "", None
        return "spline, as no three neighbours bridge it", _by_spline(positions[:, point], start, stop)
    if method == "spline":
        return "spline", _by_spline(positions[:, point], start, stop)
    return "linear", line(positions[:, point], start, stop)


def _by_spline(path: np.ndarray, start: int, stop: int) -> np.ndarray:
    from scipy.interpolate import CubicSpline

    seen = np.flatnonzero(np.isfinite(path).all(axis=1))
    knots = np.concatenate((seen[seen < start][-KNOTS:], seen[seen >= stop][:KNOTS]))
    curve: np.ndarray = CubicSpline(knots - start, path[knots])(np.arange(stop - start))
    return curve


def _helpers(positions: np.ndarray, start: int, stop: int, body: np.ndarray) -> np.ndarray:
    """The steadiest companions that show the whole gap and its borders; none where they tell no rotation."""
    shown = np.isfinite(positions[start - 1 : stop + 1, body]).all(axis=(0, 2))
    usable = body[shown][:MOST]
    needed = spanning(positions[start - 1, usable]) if usable.size else 0
    return usable[: max(needed, min(len(usable), 4))] if needed else usable[:0]


def _by_body(positions: np.ndarray, point: int, start: int, stop: int, helpers: np.ndarray) -> np.ndarray:
    gap = positions[start:stop, helpers]
    from_before = carried(positions[start - 1, helpers], gap, positions[start - 1, point])
    from_after = carried(positions[stop, helpers], gap, positions[stop, point])
    share = shares(start, stop)[:, None]
    blend: np.ndarray = (1 - share) * from_before + share * from_after
    return blend
