"""Confidence of patterns: how often what is said is right, on recordings that nothing was fitted on.

A pattern is right when 80 % of its pairs join two stretches of one action. The weights of the confidence come from
``fit_confidence.py``, which uses other people. Beside it stand the cheapest answers: the share that is right where it
was fitted, said of every pattern, and the contrast as it is.
"""

from __future__ import annotations

import os

import numpy as np

from bench_patterns import material
from fit_confidence import RIGHT, fit_set, judged_in
from intervals import of_share
from leitmotion.discovery.confidence import confidence

Row = tuple[str, str, str]
BINS = ((0.0, 0.7), (0.7, 0.8), (0.8, 0.9), (0.9, 1.0))
HOW = "64 joined recordings of four actors and the three annotated ones that are reported"


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line; nothing without the recordings."""
    if not os.environ.get("LEITMOTION_DATA"):
        return []
    told = [
        each for name, recording, truth in material("report") for each in judged_in(name, recording, truth)
    ]
    right = np.array([each.share >= RIGHT for each in told])
    said = np.array([confidence(each.evidence) for each in told])
    contrast = np.clip([each.evidence.contrast for each in told], 0, 1)
    usual = float(np.mean([each.share >= RIGHT for each in fit_set()]))
    table = []
    for low, high in BINS:
        here = (said > low) & (said <= high)
        if here.any():
            a, b = of_share(int(right[here].sum()), int(here.sum()))
            table.append(
                (
                    f"Said {low:.1f} to {high:.1f}, on average {said[here].mean():.2f}",
                    f"{right[here].mean():.1%} right ({a:.1%} to {b:.1%})",
                    f"{here.sum()} patterns; {HOW}; 95 % by Wilson's score",
                )
            )
    for what, probability in (
        ("Ours", said),
        (f"Cheap: {usual:.3f} for all", np.full(len(right), usual)),
        ("Cheap: the contrast", contrast),
    ):
        table.append(
            (
                f"Brier score: {what[0].lower() + what[1:]}",
                f"{np.mean((probability - right) ** 2):.3f}",
                f"mean squared difference from right or not, {len(right)} patterns, {right.mean():.1%} right",
            )
        )
    return table


if __name__ == "__main__":
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")
