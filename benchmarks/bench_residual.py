"""Paper P's own error rates, and what its residual search brings to light.

U pairs are found, u of them are false; v candidates of the residual search (eq. 6) are pairs that were missed. Where
the paper asked observers, labels tell, by the protocol of `leitmotion.evaluation`: a stretch belongs to an action when
80 % of its frames carry that label.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from itertools import combinations

import numpy as np

from leitmotion import body, datasets, features, io
from leitmotion.discovery import Patterns, Residual, find_patterns, search_residual
from leitmotion.evaluation import PatternTruth, owners, paper_error_rates
from leitmotion.features import FeatureSequence
from leitmotion.motion import Segmentation
from recordings import locate
from truths import annotated

Row = tuple[str, str, str]
Judged = tuple[FeatureSequence, PatternTruth]
METHODS = ("tang2008", "recurrence")
MOCAP6 = ("13_29", "13_30", "13_31", "14_06")
SEEDS = range(41, 51)


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    table = []
    for name, recordings in (
        ("86_01", [recorded("cmu86/86_01.amc")]),
        ("mocap6, 4 recordings", [recorded(f"mocap6/{trial}.amc") for trial in MOCAP6]),
        (f"practice sessions of seeds {SEEDS[0]} to {SEEDS[-1]}", [composed(seed) for seed in SEEDS]),
    ):
        table += [row(f"{name}, {method}", recordings, method) for method in METHODS]
    return [*table, ten_minutes()]


def row(what: str, recordings: Iterable[Judged], method: str) -> Row:
    """Count pairs and candidates, right and wrong, over recordings."""
    pairs: list[str] = []
    candidates: list[str] = []
    windows: list[str] = []
    for sequence, truth in recordings:
        patterns = find_patterns(sequence, method=method)
        residual = search_residual(sequence, patterns)
        pairs += verdicts(truth, [(pair.a, pair.b) for pair in patterns.pairs])
        candidates += verdicts(truth, [(one.a, one.b) for one in residual])
        windows += verdicts(truth, list(combinations(windows_of(residual), 2)))
    found, false, missed = len(pairs), len(pairs) - pairs.count("one"), candidates.count("one")
    rates = paper_error_rates(found, false, missed)
    blind = f"; of any two windows left over {windows.count('one') / len(windows):.0%} do" if windows else ""
    return (
        what,
        f"type I {rates.type_one:.1%}, type II {rates.type_two:.1%}",
        f"U {found}, u {false}, v {missed}; of {len(candidates)} candidates {missed} join one action, "
        f"{candidates.count('two')} two different ones, {candidates.count('none')} a stretch of none{blind}",
    )


def verdicts(truth: PatternTruth, pairs: list[tuple[tuple[int, int], tuple[int, int]]]) -> list[str]:
    """Say of each pair whether its stretches belong to one action, to two, or one of them to none."""
    if not pairs:
        return []
    a, b = (owners(truth, np.array(side)) for side in zip(*pairs, strict=True))
    return ["none" if None in (x, y) else "one" if x == y else "two" for x, y in zip(a, b, strict=True)]


def windows_of(residual: Residual, window_s: float = 0.5) -> list[tuple[int, int]]:
    """All windows left over: what a blind choice would pair."""
    length = round(window_s * residual.rate)
    return [(k, k + length) for a, b, _, _ in residual.left_over for k in range(a, b - length + 1, length)]


def recorded(name: str) -> Judged:
    """Read an annotated recording."""
    return features.posture(body.embody(io.read(locate(name)))), annotated(name)


def composed(seed: int) -> Judged:
    """Compose a session; stillness is no action."""
    session = datasets.compose_session(seed=seed)
    moving = [(a, b, name) for a, b, name, _ in session.stretches if name != "still"]
    starts, stops, names = zip(*moving, strict=True)
    runs = Segmentation(starts, stops, names, rate=session.stretches.rate)
    return features.posture(body.embody(session.motion)), PatternTruth(runs)


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
