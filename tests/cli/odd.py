"""Recordings that are odd: what a verb that needs a body in three dimensions answers, or refuses in a sentence."""

from pathlib import Path

import numpy as np

import leitmotion as lm
from leitmotion.motion.kinematics import forward_kinematics


def save_points(path: Path, positions: np.ndarray, names: tuple[str, ...], unit: str = "m") -> Path:
    """Save joints as points."""
    lm.save(lm.Trajectories(names, positions, 30.0, unit=unit, kind="joint"), path)
    return path


def planar(path: Path, motion: lm.Motion) -> Path:
    """The same person as a camera sees them."""
    places = forward_kinematics(motion).positions
    return save_points(path, places[..., :2], motion.skeleton.names, unit="px")


def with_gaps(path: Path, motion: lm.Motion) -> Path:
    """Nothing is seen in frames [20, 40), a forearm not in [60, 70)."""
    places = forward_kinematics(motion).positions.copy()
    places[20:40] = np.nan
    places[60:70, motion.skeleton.index("LeftForeArm")] = np.nan
    return save_points(path, places, motion.skeleton.names)


def hands_only(path: Path) -> Path:
    """Two hands that move apart."""
    return save_points(path, np.arange(54.0).reshape(9, 2, 3), ("LeftHand", "RightHand"))
