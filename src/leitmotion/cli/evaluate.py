"""``leitmotion evaluate``: judge an answer by what a person saw."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from leitmotion.cli.batch import Answer, answer_one, finish
from leitmotion.cli.documents import Document, source_entry, stretch
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, Positive, answering, as_json, examples, force, output, some
from leitmotion.cli.outputs import TABLES, check_output, keep_table
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.evaluating import Judged

COLUMNS = ("measure", "value", "low", "high")
"""Columns of the table, one row per measure."""
WORDS = {
    "type_one": ("type I error", "pairs of stretches that belong to different actions or to none"),
    "type_two": ("type II error", "recurring actions of which less than half was found"),
    "precision": ("precision", "pairs that show what recurs"),
    "recall": ("recall", "pairs of runs, and cyclic runs, that right pairs link"),
    "f1": ("F1", "harmonic mean of both"),
    "paper_type_one": ("u/(U-u+v)", "type I error as Tang et al. (2008) have it"),
    "paper_type_two": ("v/(U-u+v)", "type II error as they have it"),
    "border_error_s": ("borders", "mean error of the ends of the runs of found actions"),
    "inner_border_error_s": ("inner borders", "mean error between repetitions that are known exactly"),
    "counts_within": ("counts", "counted runs whose cycles a person may count so"),
}
"""What each measure is called, and what it is, for a person."""


@click.command(
    epilog=examples(
        "leitmotion evaluate patterns labels.csv found.json",
        "leitmotion evaluate patterns labels/ found.json --json",
    )
)
@click.argument("task", type=click.Choice(["patterns"]), metavar="TASK")
@click.argument("truth", callback=some, metavar="TRUTH")
@click.argument("found", callback=some, metavar="FOUND")
@click.option("--rate", type=Positive(), metavar="HZ", help="Frames per second, when neither file tells.")
@click.option("--trial", metavar="NAME", help="Which recording of a truth that tells of several.")
@click.option("--tier", metavar="NAME", help="Which tier of an .eaf, where it has several.")
@click.option("--ignore", multiple=True, metavar="LABEL", help="A label that is no action, such as 'rest'.")
@output("Also write the measures, by the ending: .json or .csv.")
@force
@as_json
@answering
def evaluate(
    task: str,
    truth: str,
    found: str,
    trial: str | None,
    tier: str | None,
    ignore: tuple[str, ...],
    options: Options,
) -> None:
    """Judge an answer by what a person saw.

    TASK is patterns. TRUTH is a file of labelled runs (.csv, .json, .eaf, or .txt as some data sets have them), or a
    folder with one for each recording. FOUND is what `leitmotion patterns -o` wrote: .json, .csv, .eaf or .npz.
    """
    files = [Input(truth, Path(truth)), Input(found, Path(found))]
    if options.output is not None:
        check_output(options.output, files, endings=TABLES, force=options.force)

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.evaluating import judged

        progress.say(f"Judging {given.path.name}")
        results = judged(truth, found, rate=options.rate, trial=trial, tier=tier, ignore=ignore)
        return Answer(
            source=_sources(results, files),
            result=_result(task, results),
            show=lambda console: _show(console, results),
            parameters=_parameters(options.rate, trial, tier, ignore),
            warnings=_warnings(results),
        )

    outcome = answer_one("evaluate", files[1], options, look)
    keep_table(outcome.documents, options, COLUMNS, _rows)
    finish(outcome)


def _sources(results: Sequence[Judged], files: Sequence[Input]) -> list[Document]:
    """The files of the truth, then that of the answer, with the length of what they tell of."""
    truths = {one.file: one for one in results}
    entries = [
        source_entry(Input(str(file), file), frames=one.frames, rate=one.truth.rate)
        for file, one in truths.items()
    ]
    seconds = sum(one.frames / one.truth.rate for one in results)
    rate = results[0].truth.rate
    return [*entries, source_entry(files[1], frames=round(seconds * rate), rate=rate)]


def _parameters(
    rate: float | None, trial: str | None, tier: str | None, ignore: tuple[str, ...]
) -> dict[str, object]:
    from leitmotion.evaluation.patterns import BELONGS, FOUND

    given = {"rate": rate, "trial": trial, "tier": tier, "ignore": list(ignore) or None}
    rules = {"belongs": BELONGS, "found": FOUND}
    return rules | {name: value for name, value in given.items() if value is not None}


def _result(task: str, results: Sequence[Judged]) -> Document:
    return {"task": task, "metrics": _metrics(results), "recordings": [_recording(one) for one in results]}


def _metrics(results: Sequence[Judged]) -> dict[str, Document]:
    """Each measure of all recordings together, with its interval where there are several."""
    from leitmotion.evaluation import MEASURES, interval, pool

    scores = [one.scores for one in results]
    whole = pool(scores)
    metrics = {}
    for measure in MEASURES:
        low, high = interval(scores, measure)
        metrics[measure] = {"value": getattr(whole, measure), "low": low, "high": high}
    return metrics


def _recording(one: Judged) -> Document:
    scores = one.scores
    counted = (
        "pairs",
        "wrong_pairs",
        "unfounded_pairs",
        "true_pairs",
        "missed_pairs",
        "patterns",
        "stray_patterns",
    )
    return {
        "recording": one.recording,
        **{name: getattr(scores, name) for name in counted},
        "recurring": list(scores.recurring),
        "missed": list(scores.missed),
        "runs": [
            stretch(run.start, run.stop, rate=one.truth.rate, label=run.label)
            | {"found": run.found, "cycles": run.cycles, "least": run.least, "most": run.most}
            for run in scores.counts
        ],
    }


def _warnings(results: Sequence[Judged]) -> list[str]:
    notes = []
    for one in results:
        if one.of_another:
            notes.append(
                f"{one.recording} was judged by what {one.file.name} tells of {one.about}: are they one recording?"
            )
        of = f" of {one.recording}" if len(results) > 1 else ""
        if one.truth.uncertain:
            notes.append(
                f"Nobody counted the cycles{of}: whether {', '.join(one.truth.uncertain)} recurs within its one run is "
                "not known, and not judged. A column cycles in a table tells."
            )
        end = float(one.truth.runs.stops.max()) / one.truth.rate
        last = one.frames / one.truth.rate
        if last - end > 1.0:
            notes.append(
                f"The truth{of} ends at {end:.2f} s of {last:.2f} s: what was found after it belongs to nothing."
            )
    return notes


def _show(console: Console, results: Sequence[Judged]) -> None:
    from leitmotion.evaluation import pool

    whole = pool([one.scores for one in results])
    missed = f" ({', '.join(whole.missed)})" if whole.missed else ""
    console.print(
        f"{whole.wrong_pairs} of {whole.pairs} pairs wrong, {len(whole.missed)} of {len(whole.recurring)} recurring "
        f"actions missed{missed}.",
        style="bold",
    )
    console.print()
    several = len(results) > 1
    rows = []
    for measure, held in _metrics(results).items():
        name, what = WORDS[measure]
        interval = (
            ""
            if math.isnan(held["low"])
            else f"{_said(measure, held['low'])} to {_said(measure, held['high'])}"
        )
        rows.append((name, _said(measure, held["value"]), *([interval] if several else []), what))
    print_table(console, ("", ">", *([">95 % interval"] if several else []), ""), rows)
    off = [
        f"{run.label} {run.start / one.truth.rate:.2f}–{run.stop / one.truth.rate:.2f} s: {run.found} cycles, "
        f"a person counts {run.cycles:g}"
        for one in results
        for run in one.scores.counts
        if run.judged and not run.within
    ]
    if off:
        console.print()
        for line in off:
            console.print(line)


def _said(measure: str, value: float) -> str:
    if math.isnan(value):
        return "–"
    if measure.endswith("_s"):
        return f"{value:.2f} s"
    return f"{value:.2f}" if measure in ("precision", "recall", "f1") else f"{value:.1%}"


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per measure; a failure has none."""
    for measure, held in document.get("result", {}).get("metrics", {}).items():
        yield {"measure": measure} | held
