"""Fit the weights of a pattern's confidence: ``python benchmarks/fit_confidence.py``.

Prints what stands in ``leitmotion/discovery/confidence.py``, fitted by logistic regression on the recordings that a
method may be fitted on: the annotated ones and joined ones of three actors, each recording left out in turn to tell
how well it holds.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

import leitmotion as lm
import truths
from joined import joined
from leitmotion.discovery import writing
from leitmotion.discovery.confidence import Evidence, predictors
from leitmotion.evaluation import PatternTruth, owners
from recordings import locate

ACTORS = {"hdm05-bd": 72, "bandai-1": 24, "cmu-02": 24}
"""Joined recordings of each actor; the first of them are those that stand in the tables."""
RIGHT = 0.8
"""Share of its pairs that are right in a pattern that is right."""
PENALTY = 0.02


def main() -> None:
    """Fit, and print weights and how well they hold."""
    rows = [row for name, recording, truth in material() for row in patterns_of(name, recording, truth)]
    names = np.array([name for name, _, _ in rows])
    right = np.array([share >= RIGHT for _, share, _ in rows])
    x = np.array([predictors(evidence) for _, _, evidence in rows])
    held_out = np.zeros(len(rows))
    for name in dict.fromkeys(names.tolist()):
        held_out[names == name] = probability(x[names == name], fit(x[names != name], right[names != name]))
    weights = fit(x, right)
    print("CONSTANT, CONTRAST, APART, LENGTH = " + ", ".join(f"{weight:.2f}" for weight in weights))
    print(f"{len(rows)} patterns, {right.mean():.1%} right")
    for low, high in ((0.0, 0.6), (0.6, 0.7), (0.7, 0.8), (0.8, 0.9), (0.9, 1.0)):
        here = (held_out > low) & (held_out <= high)
        if here.any():
            print(f"said {held_out[here].mean():.2f}, right {right[here].mean():.2f} of {here.sum()}")


def material() -> Iterator[tuple[str, lm.Motion, PatternTruth]]:
    """Give what may be fitted on: name, recording, truth."""
    for name in truths.FIT:
        yield name, lm.read(locate(name)), truths.annotated(name)
    for actor, count in ACTORS.items():
        for k in range(count):
            made = joined(f"{actor}/{k:02d}")
            yield made.name, made.motion, made.truth


def patterns_of(
    name: str, recording: lm.Motion, truth: PatternTruth
) -> Iterator[tuple[str, float, Evidence]]:
    """Give each pattern found: name of the recording, share of its pairs that are right, what speaks for it."""
    told: list[Evidence] = []
    usual = writing.confidence

    def noted(evidence: Evidence) -> float:
        told.append(evidence)
        return len(told)  # the pattern bears the number of its evidence instead of a confidence

    writing.confidence = noted
    try:
        found = lm.find_patterns(recording)
    finally:
        writing.confidence = usual
    shares = shares_right(truth, found)
    for pattern in found.patterns:
        if pattern.id in shares:
            yield name, shares[pattern.id], told[int(pattern.confidence) - 1]


def shares_right(truth: PatternTruth, found: lm.Patterns) -> dict[str, float]:
    """Tell of each pattern by its id which share of its pairs is right."""
    told: dict[str, float] = {}
    for pattern in found.patterns:
        pairs = np.array([(*pair.a, *pair.b) for pair in found.pairs if pair.pattern == pattern.id]).reshape(
            -1, 4
        )
        a, b = owners(truth, pairs[:, :2]), owners(truth, pairs[:, 2:])
        if len(pairs):
            told[pattern.id] = float(np.mean([x is not None and x == y for x, y in zip(a, b, strict=True)]))
    return told


def fit(x: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Logistic regression with a small penalty on the standardised weights: constant, then one for each predictor."""
    from scipy.optimize import minimize

    mean, spread = x.mean(axis=0), x.std(axis=0)
    z = (x - mean) / spread
    signs = np.where(right, -1.0, 1.0)

    def loss(w: np.ndarray) -> float:
        return float(np.logaddexp(0, signs * (w[0] + z @ w[1:])).mean() + PENALTY * (w[1:] ** 2).sum())

    w = minimize(loss, np.zeros(x.shape[1] + 1)).x
    weights = w[1:] / spread
    return np.array([w[0] - weights @ mean, *weights])


def probability(x: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """What the weights say, (K,)."""
    return np.asarray(1 / (1 + np.exp(-(weights[0] + x @ weights[1:]))))


if __name__ == "__main__":
    main()
