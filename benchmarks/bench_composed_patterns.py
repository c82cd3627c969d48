"""Patterns, by default: known movements, real recordings, time and memory.

The composed sessions have an exact truth but are made by this project; how good the answer is on recordings of people
is told by bench_patterns. Cheap answers stand beside ours.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from intervals import of_mean
from leitmotion import body, datasets, discovery, features, io

Row = tuple[str, str, str]
SEEDS = range(41, 51)
RECORDINGS = (
    ("bandai_namco/dataset-1_walk_normal_001.bvh", "a walk"),
    ("cmu_bvh/jumping_jacks.bvh", "3 jumping jacks"),
    ("hdm05/lieDownFloor/HDM_bd_lieDownFloor_001_120.amc", "lying down once: nothing recurs"),
    ("cmu86/86_01.amc", "walk, jump, walk, punch, walk, kick, punch: 4 movements recur"),
)
LONG = "long"


def main() -> None:
    """Print the table; `long` measures ten minutes in a process of its own."""
    if sys.argv[1:] == [LONG]:
        print(*ten_minutes())
        return
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line; recordings only where their folder is."""
    table = composed()
    folder = os.environ.get("LEITMOTION_DATA")
    for name, truth in RECORDINGS if folder else ():
        table.append(recording(Path(str(folder)) / name, truth))
    seconds, gigabytes = subprocess.run(
        [sys.executable, __file__, LONG], capture_output=True, text=True, check=True
    ).stdout.split()
    how = "ten practice sessions joined, 71,000 frames at 120 Hz, 1 mm of noise; kernels compiled before"
    table.append(
        (
            "Ten minutes searched",
            f"{seconds} s, {gigabytes} GB above the process before",
            f"{how}; CPU time, once",
        )
    )
    return table


def composed() -> list[Row]:
    """Compare what is found in composed sessions with what was composed, and with two cheap answers."""
    actions = found_actions = strays = cycles = 0
    count_errors, count_plain, lengths, lengths_equal = [], [], [], []
    for seed in SEEDS:
        session = datasets.compose_session(seed=seed)
        postures = features.posture(body.embody(session.motion))
        patterns = discovery.find_patterns(postures).patterns
        owners = [owner(pattern, session.stretches) for pattern in patterns]
        strays += owners.count(None)
        for label in sorted(set(session.cycles.labels)):
            actions += 1
            mine = [p for p, o in zip(patterns, owners, strict=True) if o == label]
            found_actions += bool(mine)
            truth = np.array([(a, b) for a, b, name, _ in session.cycles if name == label])
            cycles += len(truth)
            given = np.array([(a, b) for p in mine for a, b, _, _ in p.occurrences]).reshape(-1, 2)
            for start, stop, name, _ in session.stretches:
                if name != label:
                    continue
                true_here = truth[(truth[:, 0] >= start) & (truth[:, 1] <= stop)]
                here = given[(given[:, 0] >= start - 60) & (given[:, 1] <= stop + 60)]
                count_errors.append(abs(len(here) - len(true_here)))
                count_plain.append(abs(plain_count(postures.values[start:stop]) - len(true_here)))
                true_lengths = np.diff(true_here, axis=1)[:, 0] / postures.rate
                lengths_equal += list(np.abs(true_lengths - true_lengths.mean()))
                if len(here) == len(true_here):
                    lengths += list(np.abs(true_lengths - np.diff(here, axis=1)[:, 0] / postures.rate))
    how = f"practice sessions of seeds {SEEDS[0]} to {SEEDS[-1]}, none of them looked at while the method was made"
    low, high = of_mean(lengths)
    wrong, of = np.count_nonzero(count_errors), len(count_errors)
    plain = np.count_nonzero(count_plain)
    return [
        ("Actions found", f"{found_actions} of {actions}", how),
        (
            "Patterns that are no action",
            f"{strays}",
            "an occurrence belongs to an action by 80 % of its frames",
        ),
        ("Stretches with a wrong count", f"{wrong} of {of}", f"{cycles} cycles in all"),
        (
            "The same, cheap answer",
            f"{plain} of {of}",
            "autocorrelation of each true stretch, length over first peak",
        ),
        (
            "Length of a cycle, error",
            f"{np.mean(lengths):.3f} s ({low:.3f} to {high:.3f})",
            f"mean over {len(lengths)} cycles in stretches of right count, 95 % bootstrap over cycles; "
            "where in a cycle it is cut is a matter of taste and not compared",
        ),
        (
            "The same, cheap answer",
            f"{np.mean(lengths_equal):.3f} s",
            "true extent and true count, divided equally",
        ),
    ]


def owner(pattern: discovery.Pattern, truth) -> str | None:
    """Name the action that 80 % of every occurrence belongs to."""
    owners = set()
    for start, stop, _, _ in pattern.occurrences:
        shares = dict.fromkeys(truth.labels, 0.0)
        for a, b, label, _ in truth:
            shares[label] += max(0, min(stop, b) - max(start, a)) / (stop - start)
        label = max(shares, key=lambda name: shares[name])
        owners.add(label if shares[label] >= 0.8 else None)
    return owners.pop() if len(owners) == 1 else None


def plain_count(values: np.ndarray) -> int:
    """Length of a stretch over the first peak of its autocorrelation."""
    x = values - values.mean(axis=0)
    lags = np.array([(x[: len(x) - k] * x[k:]).sum() / (x * x).sum() for k in range(len(x) // 2 + 1)])
    peaks = [k for k in range(1, len(lags) - 1) if lags[k - 1] < lags[k] >= lags[k + 1] and k > 36]
    return round(len(x) / peaks[0]) if peaks else 1


def recording(path: Path, truth: str) -> Row:
    """Search one recording, from file to answer."""
    seconds = []
    for _ in range(3):
        began = time.process_time()
        found = discovery.find_patterns(features.posture(body.embody(io.read(path))))
        seconds.append(time.process_time() - began)
    said = ", ".join(
        f"{p.id} {p.cycles} cycles of {p.period_s:.2f} s in {len(p.stretches)}" if p.cycles
        else f"{p.id} {len(p.occurrences)} times {p.period_s:.2f} s"
        for p in found.patterns
    )  # fmt: skip
    return (
        f"{path.name}: {truth}",
        said or "nothing",
        f"from file to answer {min(seconds):.2f} s CPU, best of 3",
    )


def ten_minutes() -> tuple[str, str]:
    """Search ten minutes: CPU seconds, and gigabytes above what the process had."""
    postures = features.posture(body.embody(datasets.compose_session(seed=0).motion))
    discovery.find_patterns(postures)
    noise = np.random.default_rng(0).normal(scale=0.0007, size=(10 * len(postures), postures.values.shape[1]))
    joined = postures.replace(values=np.concatenate([postures.values] * 10) + noise)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    began = time.process_time()
    discovery.find_patterns(joined)
    seconds = time.process_time() - began
    return f"{seconds:.0f}", f"{(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 2**20:.1f}"


if __name__ == "__main__":
    main()
