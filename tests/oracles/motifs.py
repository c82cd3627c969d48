"""The motifs of symmetry as plain movements of arms and trunk, and the alignment of a signal by recursion."""

from functools import cache

import numpy as np

from leitmotion.motion import Motion, rotations
from oracles import body

HANGING = np.radians(-75.0)
RATE = 60.0


def human_doing(left, right=None, *, rate=RATE) -> Motion:
    """A person whose arms are raised and swung forward by angles in time, (T, 2) a side; right as left by default."""
    right = left if right is None else right
    skeleton = body.skeleton()
    frames = len(left)
    local = np.tile(rotations.IDENTITY, (frames, len(skeleton), 1))
    for side, sign, (raised, forward) in (("Left", 1.0, left.T), ("Right", -1.0, right.T)):
        up = rotations.from_axis_angle("z", sign * (HANGING + raised))
        swing = rotations.from_axis_angle("y", -sign * forward)
        local[:, skeleton.index(f"{side}Arm")] = rotations.multiply(swing, up)
    return Motion(skeleton, np.tile(skeleton.offsets, (frames, 1, 1)), local, rate)


def ease(frames: int) -> np.ndarray:
    """From 0 to 1, slow at both ends."""
    return (1 - np.cos(np.pi * np.arange(frames) / frames)) / 2


def there_and_back(frames: int, times: int = 1) -> np.ndarray:
    """Raised arms come down again, (T, 2)."""
    raised = 2.2 * np.concatenate((ease(frames), ease(frames)[::-1]) * times)
    return np.stack((raised, 0.3 * raised), axis=1)


def circles(frames: int, times: float = 1, begins: float = 0.0) -> np.ndarray:
    """Arms circle one way, (T, 2)."""
    turned = 2 * np.pi * (begins + np.arange(round(frames * times)) / frames)
    return np.stack((1.2 + 0.9 * np.sin(turned), 0.9 - 0.9 * np.cos(turned)), axis=1)


def swings(frames: int, times: int, begins: float = 0.0) -> np.ndarray:
    """Arms swing to and fro, (T, 2)."""
    turned = 2 * np.pi * (begins + np.arange(frames * times) / frames)
    return np.stack((np.zeros(len(turned)), 1.2 * np.sin(turned)), axis=1)


def rest(frames: int) -> np.ndarray:
    """Arms hang, (T, 2)."""
    return np.zeros((frames, 2))


def one_way(frames: int) -> np.ndarray:
    """Arms are raised and stay, (T, 2)."""
    return 2.2 * ease(frames)[:, None] * [1.0, 0.3]


MOVEMENTS = {
    "symmetric_palindrome": (there_and_back(60, 3), None),
    "asymmetric_palindrome": (there_and_back(60, 3), rest(360)),
    "symmetric_cycle": (circles(100, 4), None),
    "asymmetric_cycle": (circles(100, 4), rest(400)),
    "anti_phase": (circles(100, 4), circles(100, 4, 0.5)),
    "anti_palindrome": (swings(100, 4), swings(100, 4, 0.5)),
    "symmetric_path": (one_way(80), None),
}


def movement(motif: str) -> Motion:
    """A person who stands, moves so, and stands."""
    left, right = MOVEMENTS[motif]
    right = left if right is None else right
    first, last = (np.repeat(np.stack((left, right))[:, [k]], 20, axis=1) for k in (0, -1))
    left, right = np.concatenate((first, np.stack((left, right)), last), axis=1)
    return human_doing(left, right)


def align(apart: np.ndarray, lower, upper, ceiling: float):
    """Gain of the best path to each cell, with the ceiling and without, cell by cell from the definition."""

    @cache
    def best(i: int, j: int) -> tuple[float, float]:
        if i < 0 or j < 0 or not lower[i] <= j < upper[i]:
            return 0.0, 0.0
        gain = max(1.0 - apart[i, j], -1.0) if np.isfinite(apart[i, j]) else -1.0
        before = max((best(i - 1, j - 1), best(i - 2, j - 1), best(i - 1, j - 2)), key=lambda each: each[0])
        h = min(before[0], ceiling) + gain
        return (h, before[1] + gain) if h > 0 else (0.0, 0.0)

    cells = np.array([[best(i, j) for j in range(len(apart))] for i in range(len(apart))])
    return cells[..., 0], cells[..., 1]
