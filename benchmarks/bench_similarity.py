"""Similarity: self-distance and alignment.

The self-distance runs in a process of its own, so that the memory it needs can be told from everybody else's.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np

from leitmotion.features import FeatureSequence
from leitmotion.similarity import align, cross_distance, self_distance

Row = tuple[str, str, str]
POINTS, MOMENTS, FEWER = 35, 10_000, 2_000


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    alone = json.loads(
        subprocess.run([sys.executable, __file__, "alone"], check=True, capture_output=True, text=True).stdout
    )
    few = sequence(FEWER)
    ours = best(lambda: self_distance(few))
    theirs = best(lambda: cdist_per_point(few), runs=3)
    exact = cdist_per_point(few)
    error = np.abs(self_distance(few).values - exact).max() / exact.max()
    a, b = sequence(300, 20, seed=1), sequence(300, 20, seed=2)
    distances = cross_distance(a, b).values
    walk = f"random walk of {POINTS} points"
    return [
        (
            f"Self-distance, {MOMENTS:,} moments x {POINTS} points",
            f"{alone['seconds']:.2f} s",
            f"mean of norms, full symmetric float32, {walk}; CPU time, best of 5, compiled before",
        ),
        (
            "Memory of the same",
            f"{alone['memory']:.2f} x the result",
            "peak resident above the process after one small matrix; everything the call makes, result included",
        ),
        (
            "The same, from a process that had not loaded the kernels",
            f"{alone['cold_memory']:.2f} x the result",
            "peak resident above the process before its first matrix: the compiler's library comes on top",
        ),
        (
            "One cdist per point (scipy) against ours",
            f"{theirs / ours:.0f} x as long",
            f"{FEWER:,} moments, CPU time in one run, best of 3: {theirs:.2f} s against {ours:.3f} s",
        ),
        (
            "Largest difference from double precision",
            f"{error:.1e} of the largest distance",
            f"{walk}, {FEWER:,} moments",
        ),
        (
            "Alignment, 300 x 300, with its path",
            f"{best(lambda: align(distances), runs=20) * 1e3:.2f} ms",
            "from given distances, step symmetric1; CPU time, best of 20",
        ),
        (
            "Alignment, 300 x 300, from 60 features",
            f"{best(lambda: align(a, b), runs=20) * 1e3:.2f} ms",
            "distances of 20 points included; CPU time, best of 20",
        ),
    ]


def sequence(moments: int, points: int = POINTS, *, seed: int = 0) -> FeatureSequence:
    """Let points walk at random."""
    values = np.random.default_rng(seed).standard_normal((moments, points * 3)).cumsum(axis=0)
    return FeatureSequence(values, tuple(f"p{k}" for k in range(points)), rate=60, width=3)


def cdist_per_point(features: FeatureSequence) -> np.ndarray:
    """Compute the same matrix the usual way, a scipy call for each point."""
    from scipy.spatial.distance import cdist

    points = features.values.reshape(len(features), -1, 3)
    total = np.zeros((len(features), len(features)))
    for m in range(points.shape[1]):
        total += cdist(points[:, m], points[:, m])
    return total / points.shape[1]


def best(run: Callable[[], object], runs: int = 5) -> float:
    """Time the quickest of several runs after one that compiles, CPU seconds."""
    run()
    times = []
    for _ in range(runs):
        began = time.process_time()
        run()
        times.append(time.process_time() - began)
    return min(times)


def measure_alone() -> None:
    """Print time and memory of the large matrix, in a process that does nothing else."""
    import resource

    import psutil

    def resident() -> int:
        return int(psutil.Process().memory_info().rss)

    def peak() -> int:
        unit = 1 if sys.platform == "darwin" else 1024
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit

    features = sequence(MOMENTS)
    cold = resident()
    self_distance(features[:300])
    warm = resident()
    result = MOMENTS**2 * 4
    self_distance(features)
    memory, cold_memory = (peak() - warm) / result, (peak() - cold) / result
    print(
        json.dumps({
            "memory": memory, "cold_memory": cold_memory, "seconds": best(lambda: self_distance(features))
        })
    )  # fmt: skip


if __name__ == "__main__":
    measure_alone() if sys.argv[1:] == ["alone"] else main()
