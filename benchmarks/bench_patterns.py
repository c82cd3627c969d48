"""Patterns, by default: how good the answer is on recordings of people.

``python benchmarks/bench_patterns.py cases [fit|report|both] [NAME...]`` tells what is wrong in each recording; fit is
what a method may be fitted on, and the default. A name is the beginning of one, such as ``real`` or
``joined/hdm05-bd``.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache

import numpy as np

import cheap_patterns as cheap
import leitmotion as lm
import truths
from intervals import of_mean, of_share
from joined import COUNTS, joined, names
from leitmotion import body, evaluation, features
from leitmotion.evaluating import found_patterns
from leitmotion.evaluation import FoundPatterns, PatternScores, PatternTruth, evaluate_patterns, pool
from pattern_cases import told
from recordings import locate

Row = tuple[str, str, str]
Search = Callable[[lm.Motion], FoundPatterns]
CHEAP = ("one period", "random", "everything")
SHARES = {
    "type_one": "Type I error: wrong pairs",
    "type_two": "Type II error: recurring actions missed",
    "f1": "F1 of pairs",
    "counts_within": "Runs whose count a person may count",
}
"""Figures between 0 and 1, and what each is called."""
CHEAP_HOW = (
    "one period: the whole recording in cycles of its autocorrelation's first peak; random: as many stretches, as long "
    "as those found, anywhere; everything: the recording in stretches of 2 s, all one pattern"
)
HOW = {
    "type_one": "pairs of stretches that belong to different actions or to none, over all pairs",
    "type_two": "less than half of an action's frames lie in occurrences that belong to it",
    "f1": "precision: pairs that show what recurs; recall: pairs of runs (and cyclic runs) that such pairs link",
    "counts_within": "between the least and the most that a person may count",
}


def default(recording: lm.Motion) -> FoundPatterns:
    """Find patterns as a user does who sets nothing."""
    return found_patterns(lm.find_patterns(recording))


def material(split: str) -> Iterator[tuple[str, lm.Motion, PatternTruth]]:
    """Give the recordings whose truth is known, real ones first: name, recording, truth."""
    for name in truths.FIT if split == "fit" else truths.REPORT:
        yield f"real/{name}", lm.read(locate(name)), truths.annotated(name)
    for name in names(split):
        made = joined(name)
        yield f"joined/{name}", made.motion, made.truth


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    return [
        *judged("real/", "report", "cmu86 86_01, mocap6 13_31 and 14_06"),
        *judged("real/", "fit", "mocap6 13_29 and 13_30, on which the method may be fitted"),
        *judged("joined/", "report", _of_actors("report")),
        *judged("joined/", "fit", f"{_of_actors('fit')}, on which the method may be fitted"),
        *empty(),
        *counted(),
    ]


def judged(kind: str, split: str, which: str) -> list[Row]:
    """Judge the answers about the recordings of one kind, and cheap ones."""
    answers = {name: held for name, held in scores(split).items() if name.startswith(kind)}
    ours = [held["default"] for held in answers.values()]
    whole = pool(ours)
    title = f"{kind.rstrip('/').capitalize()} recordings, {'reported' if split == 'report' else 'fitted on'}"
    table = [(title, f"{len(ours)}", which)]
    counts = {
        "type_one": f"{whole.wrong_pairs} of {whole.pairs}: ",
        "type_two": f"{len(whole.missed)} of {len(whole.recurring)}: ",
    }
    others = {other: pool([held[other] for held in answers.values()]) for other in CHEAP}
    for measure, what in SHARES.items():
        low, high = evaluation.interval(ours, measure)
        figure = f"{counts.get(measure, '')}{_said(measure, getattr(whole, measure))}"
        table.append((what, f"{figure} ({_said(measure, low)} to {_said(measure, high)})", HOW[measure]))
        said = ", ".join(f"{other} {_said(measure, getattr(others[other], measure))}" for other in CHEAP)
        table.append(("The same, cheap answers", said, CHEAP_HOW if measure == "type_one" else "as above"))
        if measure == "type_one":
            table += _more_of_type_one(ours, whole)
    of = "U pairs found, u wrong, v true pairs not linked"
    table += _aside(answers.values())
    table += [
        ("The paper's own u / (U - u + v)", f"{whole.paper_type_one:.1%}", of),
        ("The paper's own v / (U - u + v)", f"{whole.paper_type_two:.1%}", "the same"),
    ]
    errors = np.abs(whole.start_errors_s + whole.stop_errors_s)
    low, high = evaluation.interval(ours, "border_error_s")
    table.append(
        (
            "Borders of runs, error",
            f"{whole.border_error_s:.2f} s ({low:.2f} to {high:.2f}), median {np.median(errors):.2f} s",
            f"{len(errors)} ends of runs of found actions",
        )
    )
    if whole.inner_errors_s:
        strict = pool([held["strict"] for held in answers.values()])
        table.append(
            (
                "Type I and type II error, strictly",
                f"{strict.type_one:.1%}, {strict.type_two:.1%}",
                "blends between two repetitions of one move carry no label, either",
            )
        )
        inner = f"{whole.inner_border_error_s:.2f} s, median {np.median(whole.inner_errors_s):.2f} s"
        how = f"{len(whole.inner_errors_s)} borders between repetitions, to the nearest border found"
        table.append(("Borders within runs, error", inner, how))
        equal = pool([held["equal division"] for held in answers.values()])
        table.append(
            (
                "The same, cheap answer",
                f"{equal.inner_border_error_s:.2f} s, median {np.median(equal.inner_errors_s):.2f} s",
                f"true extent and true count, divided equally; {len(equal.inner_errors_s)} borders",
            )
        )
    return table


def _aside(answers: Iterable[dict[str, PatternScores]]) -> list[Row]:
    """What remains of both errors where frames without a label count neither for nor against a stretch."""
    held = list(answers)
    ours = [each["default, aside"] for each in held]
    whole = pool(ours)
    others = {other: pool([each[f"{other}, aside"] for each in held]) for other in CHEAP}
    table: list[Row] = []
    for measure, what in (("type_one", "Type I"), ("type_two", "Type II")):
        low, high = evaluation.interval(ours, measure)
        said = ", ".join(f"{other} {_said(measure, getattr(others[other], measure))}" for other in CHEAP)
        table += [
            (
                f"{what} error, frames without a label left aside",
                f"{_said(measure, getattr(whole, measure))} ({_said(measure, low)} to {_said(measure, high)})",
                "borders that an annotator leaves open and blends count neither for nor against a stretch",
            ),
            ("The same, cheap answers", said, "as above"),
        ]
    return table


def _more_of_type_one(ours: Sequence[PatternScores], whole: PatternScores) -> list[Row]:
    each = [score.type_one for score in ours if score.pairs]
    how = f"each recording with a pair counts once; {len(each)} have one"
    return [
        ("The same, mean over recordings", _of_all(each), how),
        (
            "Pairs within an action done once",
            f"{whole.unfounded_pairs} of {whole.pairs}",
            "right by the rule for type I, but nothing recurs there",
        ),
    ]


@cache
def scores(split: str) -> dict[str, dict[str, PatternScores]]:
    """Judge the default and the cheap answers, recording by recording."""
    held = {}
    for name, recording, truth in material(split):
        found = default(recording)
        answers = {
            "default": found,
            "one period": cheap.one_period(recording),
            "random": cheap.at_random(recording, found),
            "everything": cheap.everything(recording),
            "equal division": cheap.equally(truth),
        }
        held[name] = {which: evaluate_patterns(truth, answer) for which, answer in answers.items()}
        held[name]["strict"] = evaluate_patterns(_strict(truth), found)
        for which in ("default", *CHEAP):
            held[name][f"{which}, aside"] = evaluate_patterns(truth, answers[which], unlabelled="aside")
    return held


def _strict(truth: PatternTruth) -> PatternTruth:
    """Take the label away from what lies between two repetitions of one move as well."""
    known = truth.repetitions
    if known is None:
        return truth
    return truth.replace(unlabelled=np.stack((known.stops[:-1], known.starts[1:]), axis=1))


def empty() -> list[Row]:
    """Count the clips in which nothing recurs and nothing is found."""
    silent: dict[str, list[bool]] = {"default": [], "one period": [], "everything": []}
    found_in = []
    for clip in truths.empty():
        recording = lm.read(locate(clip.recording))[clip.start : clip.stop]
        found = default(recording)
        silent["default"].append(not len(found.occurrences))
        silent["one period"].append(not len(cheap.one_period(recording).occurrences))
        silent["everything"].append(not len(cheap.everything(recording).occurrences))
        if len(found.occurrences):
            found_in.append(f"{clip.recording.split('/')[-1]} ({clip.what})")
    ours = silent["default"]
    low, high = of_share(sum(ours), len(ours))
    said = ", ".join(f"{which} {sum(silent[which])}" for which in ("one period", "everything"))
    return [
        (
            "Clips in which nothing recurs: nothing found",
            f"{sum(ours)} of {len(ours)} ({low:.1%} to {high:.1%})",
            f"labels/empty_clips.csv, 95 % by Wilson's score; found in {'; '.join(found_in) or 'none'}",
        ),
        ("The same, cheap answers", said, "as above"),
    ]


def counted() -> list[Row]:
    """Compare the counts of cycles with those that were counted by eye."""
    runs: list[evaluation.RunCount] = []
    plain, seconds, off = [], [], []
    for name in truths.counted_recordings():
        recording = lm.read(locate(name))
        truth = truths.counted(name, recording.rate)
        counts = evaluate_patterns(truth, default(recording)).counts
        postures = features.posture(body.embody(recording))
        for run in counts:
            runs.append(run)
            every = cheap.period(postures.values[run.start : run.stop], recording.rate)
            plain.append(round((run.stop - run.start) / every) if every else 1)
            seconds.append(round((run.stop - run.start) / recording.rate))
            if run.found != run.cycles:
                off.append(f"{name.split('/')[-1]} {run.label} {run.found}, seen {run.cycles:g}")
    cycles = np.array([run.cycles for run in runs])
    found = np.array([run.found for run in runs])

    def near(counts: Sequence[int] | np.ndarray) -> str:
        error = np.abs(np.asarray(counts) - cycles)
        return f"{np.count_nonzero(error == 0)} exact, {np.count_nonzero(error <= 1)} within one"

    within = sum(run.within for run in runs)
    low, high = of_share(int(np.count_nonzero(np.abs(found - cycles) <= 1)), len(runs))
    return [
        (
            f"Cycles of {len(runs)} counted runs",
            f"{near(found)} ({low:.1%} to {high:.1%}), {within} that a person may count",
            f"labels/counted_runs.csv, the whole recording searched; not exact: {'; '.join(off) or 'none'}",
        ),
        (
            "The same, cheap answers",
            f"autocorrelation {near(plain)}; a cycle a second {near(seconds)}",
            "borders of the run given; its length over the first peak, or over a second",
        ),
    ]


def _of_actors(split: str) -> str:
    return ", ".join(f"{count} of {actor}" for actor, count in COUNTS[split].items())


def _of_all(values: Sequence[float] | np.ndarray) -> str:
    low, high = of_mean(values)
    return f"{np.mean(values):.1%} ({low:.1%} to {high:.1%})"


def _said(measure: str, value: float) -> str:
    if math.isnan(value):
        return "none"
    return f"{value:.2f}" if measure == "f1" else f"{value:.1%}"


def cases(split: str, wanted: tuple[str, ...] = (), search: Search = default) -> None:
    """Print what is wrong, recording by recording, the figures of all, and which are worst."""
    began = time.process_time()
    held: dict[str, PatternScores] = {}
    for name, recording, truth in material(split):
        if wanted and not name.startswith(wanted):
            continue
        found = search(recording)
        held[name] = evaluate_patterns(truth, found)
        print("\n".join(told(name, truth, found, held[name])), flush=True)
    for kind in ("real", "joined", *(f"joined/{actor}" for actor in COUNTS[split])):
        some = [score for name, score in held.items() if name.startswith(f"{kind}/")]
        if some:
            print(f"{kind}, {split}: {summary(some)}")
    worst = sorted(held, key=lambda name: _badness(held[name]))[-10:]
    print(f"worst, last the worst of all: {', '.join(name for name in worst if _badness(held[name]) > 0)}")
    print(f"{time.process_time() - began:.0f} s CPU")


def _badness(score: PatternScores) -> float:
    """Shares of what is wrong and of what is missed, added."""
    return float(np.nansum([score.type_one, score.type_two, 1 - score.f1]))


def summary(some: Sequence[PatternScores]) -> str:
    """Say the figures in a line."""
    whole = pool(some)
    each = [score.type_one for score in some if score.pairs]
    mean = f"{np.mean(each):.1%}" if each else "none"
    return (
        f"type I {whole.wrong_pairs} of {whole.pairs} ({whole.type_one:.1%}; mean over recordings {mean}), "
        f"in actions done once {whole.unfounded_pairs}, "
        f"type II {len(whole.missed)} of {len(whole.recurring)} ({whole.type_two:.1%}), "
        f"F1 {whole.f1:.3f} (precision {whole.precision:.3f}, recall {whole.recall:.3f}), "
        f"border {whole.border_error_s:.2f} s, counts within {whole.counts_within:.0%}, "
        f"stray patterns {whole.stray_patterns} of {whole.patterns}"
    )


def main() -> None:
    """Print what was asked for."""
    if sys.argv[1:2] != ["cases"]:
        for what, figure, protocol in rows():
            print(f"{what}: {figure} ({protocol})")
        return
    asked = sys.argv[2] if len(sys.argv) > 2 else "fit"
    for split in ("fit", "report") if asked == "both" else (asked,):
        cases(split, tuple(sys.argv[3:]))


if __name__ == "__main__":
    main()
