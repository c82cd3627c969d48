"""A rigid body that tumbles and travels: points whose distances never change."""

import numpy as np

from leitmotion.motion import Trajectories, rotations

RATE = 100.0


def tumbling(
    rng: np.random.Generator, *, frames: int = 200, points: int = 6, jitter: float = 0.0
) -> Trajectories:
    """Points on a body of the size of a head; `jitter` is the standard deviation of each coordinate's noise."""
    t = np.arange(frames) / RATE
    corners = rng.normal(scale=0.1, size=(points, 3))
    turn = rotations.from_euler("xyz", np.stack((np.sin(3 * t), 0.8 * np.cos(2 * t), 4 * t), axis=1))
    path = np.stack((t, np.sin(2 * t), t**2), axis=1)
    placed = rotations.rotate(turn[:, None], corners) + path[:, None]
    noise = rng.normal(scale=jitter, size=placed.shape) if jitter else 0.0
    return Trajectories(tuple(f"p{k}" for k in range(points)), placed + noise, rate=RATE)


def cut(recording: Trajectories, point: int, start: int, stop: int) -> Trajectories:
    """The same with one point unseen for a while."""
    positions = recording.positions.copy()
    positions[start:stop, point] = np.nan
    return recording.replace(positions=positions)
