"""How near alike postures are: thresholds from labelled pairs, tried on other people.

The pairs of ``benchmarks/labels/posture_pairs.csv`` were labelled by eye before any distance was seen. Thresholds are
those of the group `fit`; the group `check` holds other people and decides nothing. Cheap answers stand beside ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

import leitmotion as lm
import recordings
from leitmotion.evaluation import Calibration
from leitmotion.io import LabelledPair, read_pairs

Row = tuple[str, str, str]
TABLE = Path(__file__).resolve().parent / "labels" / "posture_pairs.csv"
FEATURES = ("posture", "velocity", "joint_angles", "limb_directions", "joint_rotations")
WEIGHTS = ("equal", "active")
CHEAP = {
    "height of the pelvis alone": ["pelvis"],
    "the two hands alone": ["left_wrist", "right_wrist"],
    "the two feet alone": ["left_ankle", "right_ankle"],
}
"""Answers that compare some joints only; the pelvis has its height alone, as its place is taken out."""


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    table = [
        _row(f"{name}, {weights} weights", calibrated(name, weights), lm.features.FEATURES[name].measured_in)
        for name in FEATURES
        for weights in WEIGHTS
    ]
    table += [
        _row(words, calibrated("posture", joints=joints), "body sizes") for words, joints in CHEAP.items()
    ]
    return [*table, ("a guess", "50.0 %", "by definition: both rates of a coin are one half")]


def calibrated(features: str, weights: str = "equal", joints: Sequence[str] | None = None) -> Calibration:
    """Calibrate on the group fit, and try it on the group check."""
    pairs, read = labelled()
    return lm.calibrate(
        pairs, read, features=features, weights=weights, joints=joints, group="fit", check="check"
    )


@cache
def labelled() -> tuple[tuple[LabelledPair, ...], dict[str, lm.Motion | lm.Trajectories]]:
    """Read the pairs, and each of their recordings once."""
    pairs = read_pairs(TABLE)
    names = dict.fromkeys(name for pair in pairs for name in (pair.recording_a, pair.recording_b))
    return pairs, {name: lm.read(recordings.locate(name)) for name in names}


def _row(what: str, found: Calibration, unit: str) -> Row:
    check = found.check
    if check is None:
        raise ValueError("no check group was measured")
    (low, high), (least, most) = found.threshold_interval, found.rate_interval
    figure = (
        f"equal error {found.equal_error_rate:.1%} ({least:.1%} to {most:.1%}) at {found.threshold:.3f} "
        f"({low:.3f} to {high:.3f}) {unit}; on other people {check.error:.1%} "
        f"({check.interval[0]:.1%} to {check.interval[1]:.1%})"
    )
    protocol = (
        f"fit: {found.alike} pairs alike, {found.not_alike} not; check: {check.alike} and {check.not_alike}, "
        f"of which {check.false_non_match:.1%} were missed and {check.false_match:.1%} taken for alike; "
        "95 % bootstrap, people drawn"
    )
    return what, figure, protocol


if __name__ == "__main__":
    main()
