"""Dynamics: how well recordings of jumps obey physics between take-off and landing, beside cheap answers.

The centre of mass should fall with 9.81 m/s² and the whole body's angular momentum about it stay constant. The filter
is chosen on recordings of three people (``FIT``); all other figures are of other recordings.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

import leitmotion as lm
from leitmotion.body import Dynamics, Flight
from leitmotion.body.flight import GRAVITY, judge_flight
from leitmotion.body.joints import joints_by_role
from leitmotion.motion.smoothing import derivative, smooth
from leitmotion.repairs import choose_cutoff
from recordings import locate

Row = tuple[str, str, str]
PACK, HOPS = "cmu_amc/cmu_amc_pack.tar.xz/16/16_", "hdm05/hdm05_bd_bk_dg.tar.xz/hopBothLegs1hops/HDM_"
FIT = ("cmu_amc/01_01.amc", "mocap6/13_29.amc", "mocap6/13_30.amc", f"{PACK}01.amc", f"{PACK}05.amc")
GROUPS = {
    "CMU 86_01, two jumps forward": ("cmu86/86_01.amc",),
    "CMU 02_04, one jump": ("cmu_amc/02_04.amc",),
    "CMU 16, jumps": tuple(f"{PACK}{k}.amc" for k in ("02", "04", "07", "10")),
    "CMU 13_31 and 14_06, jumps and jumping jacks": ("mocap6/13_31.amc", "mocap6/14_06.amc"),
    "CMU jumping jacks, 30 Hz": ("cmu_bvh/jumping_jacks.bvh",),
    "HDM05, 30 hops on both legs by three people": tuple(
        f"{HOPS}{who}_hopBothLegs1hops_{k:03d}_120.amc"
        for who, ks in (("bd", range(1, 13)), ("bk", range(13, 22)), ("dg", range(22, 31)))
        for k in ks
    ),
    "Berkeley MHAD, five jumps, points at 480 Hz": (
        "berkeley_mhad/skl_s01_a01_r01_pos.zip/skl_s01_a01_r01_pos.csv",
    ),
}
CUTOFFS = (4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0)
WINDOWS = (0.1, 0.15, 0.2, 0.3)
HOW = "medians over flights, in brackets the 90th percentile; g by the parabola through the unfiltered centre of mass"


def rows() -> list[Row]:
    """The filters, the recordings, cheap answers beside them, and the time it takes."""
    return [*_filters(), *_recordings(), *_cheap(), _speed()]


def _filters() -> list[Row]:
    """Error of the vertical acceleration and straying of the momentum in flight, by filter."""
    read = [lm.read(locate(name)) for name in FIT]
    spans = [_spans(lm.dynamics(one)) for one in read]
    count = sum(len(held) for held in spans)
    how = f"{count} flights of {len(FIT)} recordings to choose by: {', '.join(name.rsplit('/')[-1] for name in FIT)}"
    made: dict[str, Callable[[lm.Trajectories], lm.Trajectories]] = {"no filter": lambda one: one}
    for cutoff in CUTOFFS:
        made[f"Butterworth, {cutoff:g} Hz"] = lambda one, cutoff=cutoff: one.replace(  # type: ignore[misc]
            positions=smooth(one.positions, cutoff, one.rate)
        )
    for window in WINDOWS:
        made[f"Savitzky-Golay, cubic, {window:g} s"] = lambda one, window=window: _savitzky_golay(one, window)  # type: ignore[misc]
    table = []
    for name, calm in made.items():
        errors, shares = [], []
        for one, held in zip(read, spans, strict=True):
            found = lm.dynamics(calm(_points(one)), cutoff_hz=None)
            fall = derivative(derivative(found.centre_of_mass[:, 1], found.rate), found.rate)
            errors += [float(np.sqrt(np.mean((fall[a:b] / GRAVITY + 1) ** 2))) for a, b in held]
            shares += [flight.drift_share for flight in _judged(found, held)]
        told = f"acceleration {np.median(errors):.1%} of g off, momentum strays by {np.median(shares):.1%}"
        table.append((f"Filter: {name}", told, f"{how}; median over flights of the root mean square"))
    chosen = [choose_cutoff(_points(one)) for one in read]
    told = f"{min(chosen):.1f} to {max(chosen):.1f} Hz"
    return [
        *table,
        (
            "Filter: cutoff at which the signal lost equals the noise kept",
            told,
            "residual analysis of the same recordings",
        ),
    ]


def _recordings() -> list[Row]:
    table = []
    for name, files in GROUPS.items():
        found = [lm.dynamics(lm.read(locate(file))) for file in files]
        table.append((name, _told([flight for one in found for flight in one.flights]), HOW))
    return table


def _cheap() -> list[Row]:
    """The same flights, judged by what costs less."""
    ours: list[Flight] = []
    points: list[Flight] = []
    raw: list[Flight] = []
    hips: list[Flight] = []
    for file in (file for files in GROUPS.values() for file in files):
        recording = lm.read(locate(file))
        found = lm.dynamics(recording)
        held = _spans(found)
        ours += found.flights
        unfiltered = lm.dynamics(recording, cutoff_hz=None)
        raw += _judged(unfiltered, held)
        points += _judged(lm.dynamics(_points(recording)), held)
        joints, _, rate = joints_by_role(recording, None)
        middle = (joints["left_hip"] + joints["right_hip"]) / 2
        nothing = np.zeros_like(middle)
        hips += [judge_flight(span, middle, nothing, nothing[:, None], rate) for span in held]
    how = f"the {len(ours)} flights of all recordings above"
    at_hips = _told(hips).partition(", momentum")[0]
    return [
        ("All", _told(ours), how),
        ("All, rotations of the files left unused", _told(points), how),
        ("All, not filtered", _told(raw), f"{how}; differences of raw frames"),
        ("All, a point mass at the hips", f"{at_hips}, no momentum of turning", how),
    ]


def _speed() -> Row:
    motion = lm.compose_session(seed=0, rate=240.0).motion[:10_000]
    lm.dynamics(motion[:100])
    took = []
    for _ in range(3):
        began = time.process_time()
        lm.dynamics(motion)
        took.append(time.process_time() - began)
    return (
        "Time for 10,000 frames",
        f"{min(took):.2f} s",
        f"{len(motion)} frames with rotations, best of three",
    )


def _told(flights: list[Flight]) -> str:
    gravity = np.array([flight.gravity for flight in flights])
    error = np.abs(gravity / GRAVITY - 1)
    off = 1000 * np.median([flight.residual for flight in flights])
    share = [flight.drift_share for flight in flights]
    return (
        f"{len(flights)} flight{'' if len(flights) == 1 else 's'}, g {np.median(gravity):.2f} m/s², "
        f"{np.median(error):.1%} off ({np.quantile(error, 0.9):.1%}), {off:.1f} mm from the parabola, "
        f"momentum strays by {np.median(share):.1%} ({np.quantile(share, 0.9):.1%})"
    )


def _spans(found: Dynamics) -> list[tuple[int, int]]:
    return [(flight.start, flight.stop) for flight in found.flights]


def _judged(found: Dynamics, spans: list[tuple[int, int]]) -> list[Flight]:
    """Judge other dynamics in given flights."""
    away = found.centres - found.centre_of_mass[:, None]
    apart = found.velocities - (found.linear_momentum / found.mass)[:, None]
    parts = found.angular_momenta + np.cross(away, found.masses[:, None] * apart)
    return [
        judge_flight(span, found.centre_of_mass, found.angular_momentum, parts, found.rate) for span in spans
    ]


def _points(recording: lm.Motion | lm.Trajectories) -> lm.Trajectories:
    """The joints as points by their roles."""
    joints, _, rate = joints_by_role(recording, None)
    return lm.Trajectories(
        tuple(joints), np.stack(list(joints.values()), axis=1), rate, unit="m", kind="joint"
    )


def _savitzky_golay(recording: lm.Trajectories, seconds: float) -> lm.Trajectories:
    from scipy.signal import savgol_filter

    window = max(5, 2 * round(seconds * recording.rate / 2) + 1)
    return recording.replace(positions=savgol_filter(recording.positions, window, 3, axis=0))
