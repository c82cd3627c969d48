"""Filling gaps: how far each method is from the hidden truth.

Markers of real C3D recordings are hidden for a while and filled again: each marker that is seen throughout, five times,
at evenly spaced moments. The error of a marker is the mean over its gaps of the root-mean-square distance to the
truth; told are the mean over all markers and its 95 % interval, by 2,000 bootstrap draws of markers.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from leitmotion import io
from leitmotion.motion import Trajectories
from leitmotion.repairs import fill_gaps
from leitmotion.repairs.rigid import companions

Row = tuple[str, str, str]
FILES = (
    "btk/Dance.c3d", "btk/Gait.c3d", "btk/golfswing.c3d", "btk/Dec_real.c3d", "btk/PiG_Motion3_FF.c3d",
    "pycgm/Movement_trial.c3d",
)  # fmt: skip
LENGTHS_S = (0.1, 0.3, 1.0)
PLACES = 5
DRAWS = 2000
METHODS = (
    "hold the last value",
    "linear",
    "spline",
    "rigid",
    "rigid, the two steadiest neighbours hidden too",
)


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    named = os.environ.get("LEITMOTION_DATA", "")
    paths = [Path(named) / name for name in FILES]
    if not named or not all(path.is_file() for path in paths):
        return [("Filling gaps", "not measured", "needs the folder of recordings that LEITMOTION_DATA names")]
    recordings = [io.read_all(path)[0] for path in paths]
    table = []
    for length in LENGTHS_S:
        errors: dict[str, list[float]] = {method: [] for method in METHODS}
        bridged: dict[str, list[bool]] = {method: [] for method in METHODS}
        for recording in recordings:
            for point in range(len(recording.names)):
                if np.isfinite(recording.positions[:, point]).all():
                    _measure(recording, point, length, errors, bridged)
        for method in METHODS:
            mean, low, high = _interval(np.array(errors[method]))
            protocol = f"mean over {len(errors[method])} markers of {len(FILES)} recordings, 95 % interval"
            if method.startswith("rigid"):
                protocol += (
                    f"; {np.mean(bridged[method]):.0%} of the gaps bridged by neighbours, the rest by spline"
                )
            figure = f"{mean:.1f} mm ({low:.1f} to {high:.1f})"
            table.append((f"gap of {length:g} s, {method}", figure, protocol))
    return table


def _measure(
    recording: Trajectories,
    point: int,
    length_s: float,
    errors: dict[str, list[float]],
    bridged: dict[str, list[bool]],
) -> None:
    truth = recording.positions[:, point]
    gap = max(1, round(length_s * recording.rate))
    starts = np.linspace(0, len(truth) - gap, PLACES + 2)[1:-1].astype(int)
    if starts[0] < 2:
        return
    held: dict[str, list[float]] = {method: [] for method in METHODS}
    for start in starts:
        stop = int(start) + gap
        for method in METHODS:
            hidden = recording.positions.copy()
            hidden[start:stop, point] = np.nan
            if method.endswith("hidden too"):
                for neighbour in companions(hidden, point)[:2]:
                    hidden[start:stop, neighbour] = np.nan
            if method.startswith("hold"):
                filled = np.broadcast_to(truth[start - 1], (gap, 3))
            else:
                mended = _filled(recording, hidden, point, method.partition(",")[0])
                filled = mended.recording.positions[start:stop, point]
                how = next(c.detail for c in mended.changes if c.joint == recording.names[point])
                bridged[method].append(how.startswith("rigid"))
            off = np.linalg.norm(filled - truth[start:stop], axis=1)
            held[method].append(1000 * float(np.sqrt(np.mean(off**2))))
    for method in METHODS:
        errors[method].append(float(np.mean(held[method])))


def _filled(recording: Trajectories, hidden: np.ndarray, point: int, method: str):
    """Fill by a method; by a spline of any length where no neighbours bridge the gap."""
    hurt = recording.replace(positions=hidden)
    mended = fill_gaps(hurt, method=method, max_gap_s=2.0)
    if any(change.joint == recording.names[point] for change in mended.changes):
        return mended
    return fill_gaps(hurt, method="spline", max_gap_s=2.0)


def _interval(errors: np.ndarray) -> tuple[float, float, float]:
    rng = np.random.default_rng(0)
    means = errors[rng.integers(0, len(errors), (DRAWS, len(errors)))].mean(axis=1)
    return float(errors.mean()), *(float(edge) for edge in np.quantile(means, (0.025, 0.975)))


if __name__ == "__main__":
    main()
