"""Paper P's own error rates, and what its residual search brings to light.

U pairs are found, u of them are false; v candidates of the residual search (eq. 6) are pairs that were missed. Where
the paper asked observers, labels tell: a stretch belongs to an action when 80 % of its frames carry that label.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from itertools import combinations

import numpy as np

from leitmotion import body, datasets, features, io
from leitmotion.discovery import Patterns, find_patterns, search_residual
from leitmotion.evaluation import paper_error_rates
from leitmotion.features import FeatureSequence
from leitmotion.motion import Segmentation
from recordings import locate

Row = tuple[str, str, str]
Labelled = tuple[FeatureSequence, np.ndarray]
METHODS = ("tang2008", "recurrence")
SEEDS = range(41, 51)
MOCAP6 = ("13_29", "13_30", "13_31", "14_06")
SHARE = 0.8
UNSURE_S = 0.25
CUT_AT = 12  # AMC frames a label of mocap6 stands for


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    table = []
    for name, recordings in (
        ("86_01", [cmu86()]),
        ("mocap6, 4 recordings", [mocap6(trial) for trial in MOCAP6]),
        (f"practice sessions of seeds {SEEDS[0]} to {SEEDS[-1]}", [composed(seed) for seed in SEEDS]),
    ):
        for method in METHODS:
            table.append(row(f"{name}, {method}", recordings, method))
    return [*table, ten_minutes()]


def row(what: str, recordings: Iterable[Labelled], method: str) -> Row:
    """Count pairs and candidates, right and wrong, over recordings."""
    found = false = 0
    judged: list[str] = []
    prior: list[float] = []
    for sequence, labels in recordings:
        patterns = find_patterns(sequence, method=method)
        found += len(patterns.pairs)
        false += sum(verdict(labels, pair.a, pair.b) != "one" for pair in patterns.pairs)
        residual = search_residual(sequence, patterns)
        judged += [verdict(labels, one.a, one.b) for one in residual]
        prior += [verdict(labels, a, b) == "one" for a, b in any_pairs(patterns, residual.left_over)]
    missed = judged.count("one")
    rates = paper_error_rates(found, false, missed)
    chance = f"{np.mean(prior):.0%}" if prior else "none"
    return (
        what,
        f"type I {rates.type_one:.1%}, type II {rates.type_two:.1%}",
        f"U {found}, u {false}, v {missed}; of {len(judged)} candidates {missed} join one action, "
        f"{judged.count('two')} two different ones, {judged.count('none')} a stretch of no action; "
        f"of any two windows left over {chance} join one action",
    )


def verdict(labels: np.ndarray, a: tuple[int, int], b: tuple[int, int]) -> str:
    """Say whether two stretches belong to one action, to two, or one of them to none."""
    first, second = action(labels, a), action(labels, b)
    if "" in (first, second):
        return "none"
    return "one" if first == second else "two"


def action(labels: np.ndarray, span: tuple[int, int]) -> str:
    """Name the action that a stretch belongs to; empty where there is none."""
    names, counts = np.unique(labels[slice(*span)], return_counts=True)
    best = int(np.argmax(counts))
    return str(names[best]) if counts[best] >= SHARE * (span[1] - span[0]) else ""


def any_pairs(
    patterns: Patterns, left_over: Segmentation, window_s: float = 0.5
) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """Pair all windows left over: what a blind choice would join."""
    length = round(window_s * patterns.rate)
    windows = [(k, k + length) for a, b, _, _ in left_over for k in range(a, b - length + 1, length)]
    return combinations(windows, 2)


def cmu86() -> Labelled:
    """Read 86_01; frames between an annotator's earliest and latest border carry no label."""
    sequence = posture_of("cmu86/86_01.amc")
    labels = np.full(len(sequence), "", dtype="U32")
    text = (locate("cmu86/86_01.amc").parent / "mocap.txt").read_text()
    block = text.replace("\r", "").split("86 01\n")[1].split("\n\n")[0]
    start, last = 0, len(block.splitlines()) - 1
    for k, line in enumerate(block.splitlines()):
        name, earliest, _, latest = line.split()[:4]
        labels[start : len(labels) if k == last else int(earliest)] = name
        start = int(latest)
    return sequence, labels


def mocap6(trial: str) -> Labelled:
    """Read a trial; frames within a quarter of a second of a change carry no label."""
    sequence = posture_of(f"mocap6/{trial}.amc")
    codes = np.array(locate(f"mocap6/{trial}.txt").read_text().split()).repeat(CUT_AT)[: len(sequence)]
    labels = codes.astype("U32")
    near = round(UNSURE_S * sequence.rate)
    for change in np.flatnonzero(codes[1:] != codes[:-1]) + 1:
        labels[max(0, change - near) : change + near] = ""
    return sequence, labels


def composed(seed: int) -> Labelled:
    """Compose a session; stillness is no action."""
    session = datasets.compose_session(seed=seed)
    sequence = features.posture(body.embody(session.motion))
    labels = np.full(len(sequence), "", dtype="U32")
    for start, stop, name, _ in session.stretches:
        labels[start:stop] = "" if name == "still" else name
    return sequence, labels


def posture_of(name: str) -> FeatureSequence:
    """Read a recording by its name."""
    return features.posture(body.embody(io.read(locate(name))))


def ten_minutes() -> Row:
    """Search ten minutes of which nothing is held by a pattern."""
    sequence, _ = composed(0)
    joined = sequence.replace(values=np.concatenate([sequence.values] * 10))
    nothing = Patterns((), (), joined.rate, {})
    seconds = []
    for _ in range(3):
        began = time.process_time()
        found = search_residual(joined, nothing)
        seconds.append(time.process_time() - began)
    return (
        "Ten minutes searched, nothing of them held by a pattern",
        f"{min(seconds):.1f} s",
        f"CPU time, best of 3; ten practice sessions joined, {len(joined):,} frames at 120 Hz; "
        f"{len(found):,} candidates",
    )


if __name__ == "__main__":
    main()
