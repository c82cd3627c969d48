"""The double metric and the motifs of symmetry: how fast, and how exact.

Wall time is what a person waits for; both matrices are made at once, on two cores.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

import leitmotion as lm
from leitmotion.discovery import find_symmetry
from leitmotion.features import FeatureSequence, kinematic_chain, mirrored
from leitmotion.similarity import double_metric
from recordings import locate

Row = tuple[str, str, str]
MOMENTS, FEWER = 10_000, 2_000
SESSION = "the practice session"


class Took(NamedTuple):
    """How long something took, seconds."""

    wall: float
    cpu: float


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    session = lm.compose_session(seed=0, rate=240.0).motion
    chain = kinematic_chain(session[:MOMENTS])
    few = chain[:: MOMENTS // FEWER]
    names = {"inner": "inner, the cost of paper S", "geodesic": "geodesic, the angle"}
    table = []
    for metric, name in names.items():
        took = best(lambda metric=metric: double_metric(chain, metric=metric))  # type: ignore[misc]
        how = f"{len(chain.names)} links, {SESSION} at 240 Hz; float32; best of 5, compiled before"
        table.append((f"D and D*, {MOMENTS:,} moments, {name}", told(took), how))
    for metric, name in names.items():
        ours = best(lambda metric=metric: double_metric(few, metric=metric))  # type: ignore[misc]
        theirs = best(lambda metric=metric: by_numpy(few, metric))  # type: ignore[misc]
        table.append(
            (
                f"NumPy, a matrix product for each link, against ours, {name}",
                f"{theirs.cpu / ours.cpu:.0f} x as long",
                f"{FEWER:,} moments, float32, CPU time in one run, best of 5: {theirs.cpu:.2f} s against "
                f"{ours.cpu:.3f} s",
            )
        )
    for metric, name in names.items():
        found, exact = double_metric(few, metric=metric), by_numpy(few, metric, np.float64)
        off = max(np.abs(a - b).max() for a, b in zip((found.own, found.mirror), exact, strict=True))
        unit = " rad" if metric == "geodesic" else ""
        table.append(
            (f"Largest difference from double precision, {name}", f"{off:.1e}{unit}", f"{FEWER:,} moments")
        )
    return [*table, *_motifs(chain)]


def _motifs(chain: FeatureSequence) -> list[Row]:
    """Both matrices and the taxonomy: of the session, and of a recording in which everything comes back often."""
    walk = kinematic_chain(lm.read(locate("cmu86/86_01.amc")))[::4]
    often = -(-MOMENTS // len(walk))
    strung = walk.replace(values=np.concatenate([walk.values] * often)[:MOMENTS])
    table = []
    for told_of, what in ((chain, SESSION), (strung, f"CMU 86_01 at 30 Hz, {often} times in a row")):
        counts: list[int] = []
        took = best(
            lambda told_of=told_of, counts=counts: counts.append(  # type: ignore[misc]
                len(find_symmetry(double_metric(told_of)).spans)
            ),
            runs=3,
        )
        table.append(
            (
                f"D, D* and the motifs, {MOMENTS:,} moments",
                told(took),
                f"{what}; {counts[0]} stretches found; inner; best of 3, compiled before",
            )
        )
    return table


def by_numpy(
    chain: FeatureSequence, metric: str, kind: type[np.floating] = np.float32
) -> tuple[np.ndarray, np.ndarray]:
    """Compute both matrices the usual way; angles in single precision lose half their digits where they are small."""
    links = chain.values.astype(kind).reshape(len(chain), -1, 4).transpose(1, 0, 2)
    image = mirrored(chain).values.astype(kind).reshape(len(chain), -1, 4).transpose(1, 0, 2)
    made = []
    for other in (links, image):
        total = np.zeros((len(chain), len(chain)), kind)
        for q, r in zip(links, other, strict=True):
            cosine = np.minimum(np.abs(q @ r.T), kind(1))
            total += 2 * np.arccos(cosine) if metric == "geodesic" else 1 - cosine
        made.append(total / kind(len(links)))
    return made[0], made[1]


def best(run: Callable[[], object], runs: int = 5) -> Took:
    """Time the quickest of several runs after one that compiles."""
    run()
    taken = []
    for _ in range(runs):
        wall, cpu = time.perf_counter(), time.process_time()
        run()
        taken.append(Took(time.perf_counter() - wall, time.process_time() - cpu))
    return Took(min(one.wall for one in taken), min(one.cpu for one in taken))


def told(took: Took) -> str:
    """Say both times."""
    return f"{took.wall:.2f} s of wall time, {took.cpu:.2f} s of CPU time"


if __name__ == "__main__":
    main()
