"""What a search for patterns got wrong, recording by recording."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from leitmotion.evaluation import FoundPatterns, PatternScores, PatternTruth, owners


def told(name: str, truth: PatternTruth, found: FoundPatterns, scores: PatternScores) -> Iterator[str]:
    """Tell one recording in lines: what is wrong, with times in seconds, and what it should be."""
    yield (
        f"{name}: {scores.wrong_pairs} of {scores.pairs} pairs wrong, {scores.unfounded_pairs} in an action done once; "
        f"{len(scores.missed)} of {len(scores.recurring)} actions missed; {scores.missed_pairs} of {scores.true_pairs} "
        f"true pairs not linked"
    )
    pairs = np.asarray(found.pairs)
    for (a0, a1, b0, b1), a, b in zip(
        pairs.tolist(), owners(truth, pairs[:, :2]), owners(truth, pairs[:, 2:]), strict=True
    ):
        if a is None or a != b:
            yield (
                f"  wrong pair {_span(a0, a1, truth)} with {_span(b0, b1, truth)}: "
                f"{a or _inside(a0, a1, truth)} / {b or _inside(b0, b1, truth)}"
            )
        elif a not in truth.recurring and a not in truth.uncertain:
            yield f"  done once {_span(a0, a1, truth)} with {_span(b0, b1, truth)}: {a}"
    for action in scores.missed:
        runs = [_span(a, b, truth) for a, b, label, _ in truth.runs if label == action]
        yield f"  missed {action}: {', '.join(runs)}"
    for run in scores.counts:
        if run.judged and not run.within:
            asked = (
                f"{run.cycles:g}"
                if run.least == run.most
                else f"{run.cycles:g} ({run.least:g} to {run.most:g})"
            )
            yield f"  count {_span(run.start, run.stop, truth)} {run.label}: {run.found}, should be {asked}"


def _span(start: int, stop: int, truth: PatternTruth) -> str:
    return f"{start / truth.rate:.2f}-{stop / truth.rate:.2f}"


def _inside(start: int, stop: int, truth: PatternTruth) -> str:
    """What a stretch that belongs to nothing consists of: ``walk 55 % + jump 30 %``."""
    which = truth.which_run(stop)[start:]
    shares: dict[str, float] = {}
    for k in which:
        label = truth.runs.labels[k] if k >= 0 else "unlabelled"
        shares[label] = shares.get(label, 0.0) + 1 / len(which)
    most = sorted(shares.items(), key=lambda item: -item[1])[:3]
    return "[" + " + ".join(f"{label} {share:.0%}" for label, share in most) + "]"
