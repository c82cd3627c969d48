"""An hour of movement searched: time, memory, and whether it is what the dense way finds.

The hour is joined from all clips of HDM05 and CMU that the folder holds, in an order drawn anew each time they run
out, each at a tempo of its own, led over to the next in a third of a second. The clips are of many people, so that they
are joined as postures, in body sizes. What is found in the first five minutes of a longer search is held against a
search of these five minutes alone: tests hold that a search without limits follows exactly the paths that an alignment
of the whole matrix has. Stripes are what is alike; how they are grouped into patterns depends on all that is
known, and with it what the pairs are cut to.
"""

from __future__ import annotations

import contextlib
import gc
import json
import resource
import subprocess
import sys
import time
from functools import cache

import numpy as np

from leitmotion import body, discovery, features, io
from leitmotion.discovery.recurrence import USUAL, WORKING_RATE
from leitmotion.discovery.tracing import trace_stripes
from leitmotion.features import FeatureSequence
from leitmotion.features.resampling import resample
from leitmotion.motion import LeitmotionError
from leitmotion.similarity import Distances
from recordings import folder, unpacked

Row = tuple[str, str, str]
ARCHIVES = ("hdm05/hdm05_bd_bk_dg.tar.xz", "cmu_amc/cmu_amc_pack.tar.xz")
LOOSE = ("cmu86", "mocap6")
RATE = 120.0
MINUTES = (5, 20, 60)
FIRST_S = 300.0
SEED = 0
BLEND = 40
TEMPO = 0.08
NOISE = 0.0005
ODD = ("standing still", "one walk", "nothing twice", "gaps")


def main() -> None:
    """Print the table; with the name of a case, measure that one and print it as JSON."""
    if len(sys.argv) > 1:
        print(json.dumps(measured(sys.argv[1])))
        return
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    found = {case: _apart(case) for case in (*map(str, MINUTES), *ODD)}
    clips = postures_of_clips()
    seconds = sum(map(len, clips)) / RATE
    how = f"joined from {len(clips)} clips of {seconds / 60:.1f} min in all, seed {SEED}, 120 Hz; its own process, "
    how += "kernels compiled before, once"
    table = []
    for minutes in MINUTES:
        it = found[str(minutes)]
        table.append((f"{minutes} min searched", _cost(it), f"{how}; {_answer(it)}"))
    dense = found[str(MINUTES[0])]
    for minutes in MINUTES[1:]:
        table += agreement(dense, found[str(minutes)], minutes)
    for case in ODD:
        it = found[case]
        table.append((f"An hour: {case}", _cost(it), f"{STORIES[case]}; {_answer(it)}"))
    return table


def _cost(it: dict) -> str:
    return f"{it['wall']:.0f} s wall, {it['cpu']:.0f} s CPU, {it['gigabytes']:.2f} GB"


def _answer(it: dict) -> str:
    limits = "".join(f", {name} {value}" for name, value in it["limits"].items())
    return f"{it['patterns']} patterns, {it['pair_count']} pairs{limits}"


def agreement(short: dict, long: dict, minutes: int) -> list[Row]:
    """Look for the pairs that the first five minutes show alone among those of a longer search."""
    again, all_pairs = found_again(short["pairs"], long["pairs"])
    traced, all_stripes = found_again(short["stripes"], long["stripes"])
    apart = np.concatenate(again) / RATE
    return [
        (
            f"Stripes of the first 5 min traced again in {minutes} min",
            f"{len(traced)} of {all_stripes} ({len(traced) / all_stripes:.1%})",
            "both stretches overlap by half of their union",
        ),
        (
            f"Pairs of the first 5 min found again in {minutes} min",
            f"{len(again)} of {all_pairs} ({len(again) / all_pairs:.1%})",
            "both stretches overlap by half of their union",
        ),
        (
            f"Their borders in {minutes} min",
            f"{np.mean(apart <= 0.1):.1%} within 0.1 s, {np.median(apart):.3f} s in the median",
            "difference of all four borders of a pair",
        ),
    ]


def found_again(short: list, long: list) -> tuple[list[np.ndarray], int]:
    """Differences of the borders of those pairs of a short search that a long one has, and how many there are."""
    a, b = (np.array(pairs).reshape(-1, 4) for pairs in (short, long))
    differences = [nearest(pair, b) for pair in a]
    return [d for d in differences if d is not None], len(a)


def nearest(pair: np.ndarray, others: np.ndarray) -> np.ndarray | None:
    """Differences of the borders to those of the pair that overlaps most; None where none does by half."""
    shares = np.ones(len(others))
    for k in (0, 2):
        shared = np.minimum(pair[k + 1], others[:, k + 1]) - np.maximum(pair[k], others[:, k])
        union = np.maximum(pair[k + 1], others[:, k + 1]) - np.minimum(pair[k], others[:, k])
        shares = np.minimum(shares, shared / union)
    best = int(np.argmax(shares))
    return np.abs(others[best] - pair) if shares[best] >= 0.5 else None


def _apart(case: str) -> dict:
    out = subprocess.run([sys.executable, __file__, case], capture_output=True, text=True, check=True)
    return dict(json.loads(out.stdout))


def measured(case: str) -> dict:
    """Search one case; what it cost and what was found."""
    discovery.find_patterns(hour(60 * RATE))
    discovery.find_patterns(with_gaps(hour(60 * RATE)))
    gc.collect()
    given = hour(float(case) * 60 * RATE) if case.isdigit() else STRANGE[case](60 * 60 * RATE)
    before = _memory()
    wall, cpu = time.perf_counter(), time.process_time()
    found = discovery.find_patterns(given)
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    pairs = [(*pair.a, *pair.b) for pair in found.pairs if pair.b[1] <= FIRST_S * RATE]
    stripes = traced_in(given) if case.isdigit() else []
    names = ("compared_within_s", "paths_left_out", "pairs_left_out", "stripes_left_out")
    return {
        "wall": wall,
        "cpu": cpu,
        "gigabytes": _memory() - before,
        "patterns": len(found),
        "pair_count": len(found.pairs),
        "pairs": pairs,
        "stripes": stripes,
        "limits": {name: found.parameters[name] for name in names if name in found.parameters},
    }


def traced_in(given: FeatureSequence) -> list[tuple[float, ...]]:
    """Trace a recording; both stretches of each stripe that lies within the first five minutes, frames."""
    work = resample(given, WORKING_RATE)
    distances = Distances(work)
    stripes = trace_stripes(
        distances,
        USUAL.likeness(distances),
        max_distance=USUAL.max_distance,
        min_duration_s=USUAL.shortest / WORKING_RATE,
    ).stripes
    ratio = given.rate / WORKING_RATE
    return [
        tuple(ratio * moment for moment in (*stripe.a, *stripe.b))
        for stripe in stripes
        if stripe.b[1] * ratio <= FIRST_S * given.rate
    ]


def _memory() -> float:
    """Most memory the process has had, gigabytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20


@cache
def postures_of_clips() -> tuple[np.ndarray, ...]:
    """Postures of every clip that is 120 frames a second and has a skeleton, in order of the names."""
    paths = [path for name in ARCHIVES for path in sorted(unpacked(name).rglob("*.amc"))]
    paths += [path for name in LOOSE for path in sorted((folder() / name).glob("*.amc"))]
    clips = []
    for path in paths:
        with contextlib.suppress(LeitmotionError):
            clips.append(features.posture(body.embody(io.read(path))))
    names = clips[0].names
    return tuple(clip.values for clip in clips if clip.names == names and round(clip.rate) == RATE)


def hour(frames: float, *, seed: int = SEED) -> FeatureSequence:
    """Join clips until there are so many frames."""
    rng = np.random.default_rng(seed)
    clips = postures_of_clips()
    pieces: list[np.ndarray] = []
    order: list[int] = []
    while sum(map(len, pieces)) < frames:
        order = order or rng.permutation(len(clips)).tolist()
        clip = clips[order.pop()]
        at = np.linspace(0, len(clip) - 1, round(len(clip) * rng.uniform(1 - TEMPO, 1 + TEMPO)))
        before = np.minimum(at.astype(int), len(clip) - 2)
        clip = clip[before] + (at - before)[:, None] * (clip[before + 1] - clip[before])
        if pieces:
            share = (1 - np.cos(np.pi * np.arange(1, BLEND + 1) / (BLEND + 1)))[:, None] / 2
            pieces.append((1 - share) * pieces[-1][-1] + share * clip[0])
        pieces.append(clip)
    values = np.concatenate(pieces)[: int(frames)]
    return _sequence(values + rng.normal(scale=NOISE, size=values.shape))


def standing_still(frames: float) -> FeatureSequence:
    """One posture, and the noise of a sensor."""
    rng = np.random.default_rng(SEED)
    posture = postures_of_clips()[0][0]
    return _sequence(posture + rng.normal(scale=0.002, size=(int(frames), posture.size)))


def one_walk(frames: float) -> FeatureSequence:
    """A composed walk without a break; every cycle is like every other."""
    from leitmotion.datasets import Action, compose

    walk = features.posture(body.embody(compose([Action("walk", 400)], seed=SEED, rate=RATE).motion)).values
    values = np.tile(walk, (int(np.ceil(frames / len(walk))), 1))[: int(frames)]
    return _sequence(values + np.random.default_rng(SEED).normal(scale=0.001, size=values.shape))


def nothing_twice(frames: float) -> FeatureSequence:
    """Every quarter of a second another posture, drawn at random around one that wanders."""
    rng = np.random.default_rng(SEED)
    goals = np.cumsum(rng.normal(scale=0.02, size=(int(frames) // 30 + 2, 45)), axis=0)
    goals = 0.5 * np.sin(goals) + rng.normal(scale=0.05, size=goals.shape)
    at = np.arange(int(frames)) / 30
    before = at.astype(int)
    share = (1 - np.cos(np.pi * (at - before)))[:, None] / 2
    return _sequence((1 - share) * goals[before] + share * goals[before + 1])


def with_gaps(given: FeatureSequence | float) -> FeatureSequence:
    """The hour, with stretches in which nothing or one joint was not seen, three in a minute."""
    whole = given if isinstance(given, FeatureSequence) else hour(given)
    rng = np.random.default_rng(SEED)
    values = whole.values.copy()
    for _ in range(round(3 * len(values) / RATE / 60)):
        start, length, joint = rng.integers(len(values)), rng.integers(5, 300), rng.integers(0, 30)
        columns = slice(3 * joint, 3 * joint + 3) if joint < 15 else slice(None)
        values[start : start + length, columns] = np.nan
    return whole.replace(values=values)


def _sequence(values: np.ndarray) -> FeatureSequence:
    names = tuple(f"joint {k}" for k in range(values.shape[1] // 3))
    return FeatureSequence(values, names, RATE, ("place", "yaw", "body_size", "unit"), 3)


STRANGE = dict(zip(ODD, (standing_still, one_walk, nothing_twice, with_gaps), strict=True))
STORIES = {
    "standing still": "one posture and noise of 0.2 % of the body size",
    "one walk": "a composed walk without a break, every cycle like every other",
    "nothing twice": "postures drawn at random",
    "gaps": "the hour above, three times a minute nothing or one joint unseen for up to 2.5 s",
}

if __name__ == "__main__":
    main()
