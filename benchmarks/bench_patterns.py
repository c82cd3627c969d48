"""Patterns, by default: on real recordings, joined ones, clips in which nothing recurs, and counted runs.

``python benchmarks/bench_patterns.py cases [fit|report|both] [NAME...]`` tells what is wrong in each recording; fit is
what a method may be fitted on, and the default. A name is the beginning of one, such as ``joined/hdm05-bd``.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator

import leitmotion as lm
import truths
from joined import joined, names
from leitmotion.evaluating import found_patterns
from leitmotion.evaluation import FoundPatterns, PatternScores, PatternTruth, evaluate_patterns, pool
from pattern_cases import told
from recordings import locate

Search = Callable[[lm.Motion], FoundPatterns]


def default(recording: lm.Motion) -> FoundPatterns:
    """Find patterns as a user does who sets nothing."""
    return found_patterns(lm.find_patterns(recording))


def material(split: str) -> Iterator[tuple[str, lm.Motion, PatternTruth]]:
    """Give the recordings whose truth is known, real ones first: name, recording, truth."""
    for name in truths.FIT if split == "fit" else truths.REPORT:
        yield name, lm.read(locate(name)), truths.annotated(name)
    for name in names(split):
        made = joined(name)
        yield f"joined/{name}", made.motion, made.truth


def cases(split: str, wanted: tuple[str, ...] = (), search: Search = default) -> None:
    """Print what is wrong, recording by recording, and the figures of all."""
    began = time.process_time()
    scores: dict[str, list[PatternScores]] = {"real": [], "joined": []}
    for name, recording, truth in material(split):
        if wanted and not name.startswith(wanted):
            continue
        found = search(recording)
        score = evaluate_patterns(truth, found)
        scores["joined" if name.startswith("joined/") else "real"].append(score)
        print("\n".join(told(name, truth, found, score)), flush=True)
    for kind, held in scores.items():
        if held:
            print(f"{kind}, {split}: {summary(pool(held))}")
    print(f"{time.process_time() - began:.0f} s CPU")


def summary(scores: PatternScores) -> str:
    """Say the figures in a line."""
    return (
        f"type I {scores.wrong_pairs} of {scores.pairs} ({scores.type_one:.1%}), in actions done once "
        f"{scores.unfounded_pairs}, type II {len(scores.missed)} of {len(scores.recurring)} ({scores.type_two:.1%}), "
        f"F1 {scores.f1:.3f} (precision {scores.precision:.3f}, recall {scores.recall:.3f}), "
        f"border {scores.border_error_s:.2f} s, counts within {scores.counts_within:.0%}, "
        f"stray patterns {scores.stray_patterns} of {scores.patterns}"
    )


def main() -> None:
    """Print what was asked for."""
    if sys.argv[1:2] == ["cases"]:
        asked = sys.argv[2] if len(sys.argv) > 2 else "fit"
        for split in ("fit", "report") if asked == "both" else (asked,):
            cases(split, tuple(sys.argv[3:]))


if __name__ == "__main__":
    main()
