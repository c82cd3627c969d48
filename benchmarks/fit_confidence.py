"""Fit the weights of a pattern's confidence: ``python benchmarks/fit_confidence.py`` prints all that is to be pasted.

Logistic regression on the recordings that a method may be fitted on: the annotated ones and joined ones of three
actors. How well it holds is told of each actor by weights fitted on the others.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

import leitmotion as lm
import truths
from joined import joined
from leitmotion.body import embody
from leitmotion.discovery.confidence import Evidence, predictors
from leitmotion.discovery.pattern import Pattern, PatternPair
from leitmotion.discovery.recurrence import USUAL, WORKING_RATE, look
from leitmotion.discovery.writing import Scribe, Written
from leitmotion.evaluation import PatternTruth, owners
from leitmotion.features import posture
from leitmotion.features.resampling import resample
from leitmotion.similarity import Distances
from recordings import locate

ACTORS = {"hdm05-bd": 72, "bandai-1": 24, "cmu-02": 24}
"""Joined recordings of each actor; the first of them are those that stand in the tables."""
ANNOTATED = "cmu-13"
"""Who performs the annotated recordings."""
RIGHT = 0.8
"""Share of its pairs that are right in a pattern that is right."""
PENALTY = 0.02
BINS = (0.0, 0.6, 0.7, 0.8, 0.9, 1.0)
WEIGHTS = "CONSTANT, CONTRAST, APART, LENGTH"


class Judged(NamedTuple):
    """A pattern that was found, beside the truth."""

    actor: str
    share: float
    """Of its pairs that join two stretches of one action."""

    evidence: Evidence


def main() -> None:
    """Fit, and print what is to be pasted and how well it holds."""
    judged = fit_set()
    actors = np.array([each.actor for each in judged])
    right = np.array([each.share >= RIGHT for each in judged])
    x = np.array([predictors(each.evidence) for each in judged])
    weights = ", ".join(f"{weight:.2f}" for weight in fit(x, right))
    print(f"src/leitmotion/discovery/confidence.py:\n{WEIGHTS} = {weights}\n")
    print(f"tests/discovery/test_confidence.py:\nFITTED = ({weights})\n")
    print(f"{len(judged)} patterns, {right.mean():.1%} right; each actor by weights fitted on the others:")
    held_out = np.zeros(len(judged))
    shares = np.zeros(len(judged))
    for actor in dict.fromkeys(actors.tolist()):
        here = actors == actor
        held_out[here] = probability(x[here], fit(x[~here], right[~here]))
        shares[here] = right[~here].mean()
        print(
            f"{actor}: {_told(held_out[here], right[here])}; the share of the others {_told(shares[here], right[here])}"
        )
    print(f"all: {_told(held_out, right)}; the share of the others {_told(shares, right)}")
    for low, high in pairwise(BINS):
        here = (held_out > low) & (held_out <= high)
        if here.any():
            print(f"said {held_out[here].mean():.2f}, right {right[here].mean():.2f} of {here.sum()}")


def _told(said: np.ndarray, right: np.ndarray) -> str:
    """How far what is said is from what is so."""
    brier = np.mean((said - right) ** 2)
    log_loss = -np.mean(np.log(np.where(right, said, 1 - said)))
    how = f"Brier {brier:.3f}, log loss {log_loss:.3f}"
    return f"said {said.mean():.2f}, right {right.mean():.2f} of {len(right)}, {how}"


@cache
def fit_set() -> tuple[Judged, ...]:
    """Judge every pattern that is found in what may be fitted on."""
    return tuple(
        each for actor, recording, truth in material() for each in judged_in(actor, recording, truth)
    )


def material() -> Iterator[tuple[str, lm.Motion, PatternTruth]]:
    """Give what may be fitted on: actor, recording, truth."""
    for name in truths.FIT:
        yield ANNOTATED, lm.read(locate(name)), truths.annotated(name)
    for actor, count in ACTORS.items():
        for k in range(count):
            made = joined(f"{actor}/{k:02d}")
            yield actor, made.motion, made.truth


def judged_in(actor: str, recording: lm.Motion, truth: PatternTruth) -> Iterator[Judged]:
    """Judge each pattern that is found in a recording and has pairs."""
    found = written(recording)
    shares = shares_right(truth, found.patterns, found.pairs)
    for pattern, evidence in zip(found.patterns, found.evidence, strict=True):
        if pattern.id in shares:
            yield Judged(actor, shares[pattern.id], evidence)


def written(recording: lm.Motion) -> Written:
    """Search a recording as ``find_patterns`` does by default, and keep what speaks for each pattern."""
    features = posture(embody(recording))
    distances = Distances(resample(features, WORKING_RATE))
    found, _ = look(features, distances, USUAL)
    return Scribe(features, distances, USUAL).write(found)


def shares_right(
    truth: PatternTruth, patterns: Sequence[Pattern], every: Sequence[PatternPair]
) -> dict[str, float]:
    """Tell of each pattern by its id which share of its pairs is right."""
    told: dict[str, float] = {}
    for pattern in patterns:
        pairs = np.array([(*pair.a, *pair.b) for pair in every if pair.pattern == pattern.id]).reshape(-1, 4)
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
