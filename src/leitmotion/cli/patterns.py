"""``leitmotion patterns``: find what recurs in a recording."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from leitmotion.cli.across import answer_across
from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import Document, patterns_result, residual_result
from leitmotion.cli.finding import search, show_patterns, warnings_of
from leitmotion.cli.inputs import Input
from leitmotion.cli.lesson import lesson_option, teach
from leitmotion.cli.options import Options, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.outputs import (
    PICTURES,
    TABLES,
    check_output,
    keep_table,
    tell_written,
    will_be_written,
    write_documents,
    write_figure,
)
from leitmotion.cli.pages import write_page
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import Opened, open_one
from leitmotion.cli.residual import COLUMNS as RESIDUAL
from leitmotion.cli.residual import residual_rows, search_left_over, show_residual, table_beside
from leitmotion.cli.summary import summarise, summary_options

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Patterns, Residual, Segmentation

OF_ONE = (".html", ".eaf", ".npz", *PICTURES)
"""Endings of what shows a single recording."""
COLUMNS = (
    "path", "pattern", "occurrence", "start", "stop", "start_s", "stop_s", "score",
    "kind", "cycles", "period_s", "cost", "confidence",
)  # fmt: skip
"""Columns of the table, one row per occurrence."""


@click.command(
    epilog=examples(
        "leitmotion patterns dance.bvh",
        "leitmotion patterns dance.bvh[12s:45s] -o dance.csv",
        "leitmotion patterns dance.bvh --residual",
        "leitmotion patterns recordings/ --json",
        "leitmotion patterns recordings/ --across",
        "leitmotion patterns dance.bvh --summary -o short.bvh",
        "leitmotion patterns dance.bvh --lesson",
    )
)
@takes_inputs
@click.option(
    "--residual",
    is_flag=True,
    help="Also tell what may have been missed: moves left over that correlate. Beside -o FOUND.csv they stand in "
    "FOUND-residual.csv.",
)
@output(
    "Also write what was found, by the ending: .json or .csv; of one input .html, .eaf (ELAN), "
    ".png, .svg, .pdf or .npz."
)
@click.option(
    "--across",
    is_flag=True,
    help="Search all inputs together: what do they share? By limb directions, unless --features is given.",
)
@summary_options
@lesson_option
@force
@as_json
@common()
def patterns(
    inputs: tuple[str, ...],
    residual: bool,
    summary: bool,
    contents: Path | None,
    lesson: bool,
    across: bool,
    options: Options,
) -> None:
    """Find what recurs in a recording."""
    if residual + summary + lesson + across > 1:
        raise click.UsageError(
            "--residual, --summary, --lesson and --across are answers of their own: ask for one of them."
        )
    if contents is not None and (not summary or options.output is None):
        raise click.UsageError(
            "--contents is the table of contents of a summary: give --summary and -o as well."
        )
    if across:
        _share(inputs, options)
        return
    if summary or lesson:
        summarise(inputs, contents, options) if summary else teach(inputs, options)
        return
    beside = table_beside(options.output) if residual else None

    def look(given: Input, progress: Progress) -> Answer:
        opened = open_one(given, options, progress)
        found = search(opened, options, progress)
        kept = []
        if options.output is not None and options.output.suffix.lower() in OF_ONE:
            kept.append(_write_one(options.output, opened, found, options, progress))
        missed = search_left_over(opened, found, progress) if residual else None

        def show(console: Console) -> None:
            show_patterns(console, found, seconds=opened.source[0]["seconds"], body=opened.body)
            if missed is not None:
                show_residual(console, missed)

        return Answer(
            source=opened.source,
            result=patterns_result(found) | (residual_result(missed) if missed is not None else {}),
            show=show,
            parameters={**found.parameters, **opened.parameters},
            warnings=[*warnings_of(opened, found), *_not_kept(options.output, missed)],
            written=kept,
        )

    def check(given: Sequence[Input]) -> None:
        if options.output is None:
            return
        for file in (options.output, beside):
            if file is not None:
                check_output(file, given, endings=TABLES + OF_ONE, force=options.force)
        if len(given) > 1 and options.output.suffix.lower() in OF_ONE:
            raise click.UsageError(
                f"{options.output.name} shows one recording, but there are {len(given)}. Write a .csv or .json of "
                "them all, or a page of each: leitmotion report INPUT... -o FOLDER."
            )

    outcome = answer_each("patterns", inputs, options, look, check=check)
    keep_table(outcome.documents, options, COLUMNS, _rows)
    if beside is not None:
        tell_written(write_documents(beside, outcome.documents, RESIDUAL, residual_rows), options)
    hint = "" if options.quiet or options.as_json else _share_hint(outcome.documents)
    if hint:
        click.echo(f"Note: {hint}", err=True)
    finish(outcome)


def _share(inputs: tuple[str, ...], options: Options) -> None:
    told = "" if options.output is None else will_be_written(options.output)
    outcome = answer_across(inputs, options)
    tell_written(told if "result" in outcome.documents[-1] else "", options)
    finish(outcome)


def _not_kept(path: Path | None, missed: Residual | None) -> list[str]:
    """Say that what may have been missed is not in the file, where its format has no place for it."""
    if path is None or missed is None or not missed.candidates or path.suffix.lower() not in OF_ONE:
        return []
    return [f"{path.name} does not hold what may have been missed; write a .csv or .json to keep that."]


def _share_hint(documents: Sequence[Document]) -> str:
    """Name --across to who searched several recordings one by one and found nothing in any."""
    results = [document["result"] for document in documents if "result" in document]
    if len(results) < 2 or any(result["patterns"] for result in results):
        return ""
    return "Each recording was searched for itself; --across tells what they share."


def _write_one(path: Path, opened: Opened, found: Patterns, options: Options, progress: Progress) -> str:
    ending = path.suffix.lower()
    if ending == ".html":
        return write_page(path, opened, found, options, progress)
    progress.say(f"Writing {path.name}")
    told = will_be_written(path)
    if ending == ".eaf":
        from leitmotion.io import write_annotations

        write_annotations(_as_labels(found, opened.first_frame), path, tier="patterns")
    elif ending == ".npz":
        from leitmotion.api import save

        save(found, path)
    else:
        from leitmotion.view import plot_patterns

        write_figure(path, plot_patterns(found, seconds=opened.source[0]["seconds"]))
    return told


def _as_labels(found: Patterns, first: int) -> Segmentation:
    """Give each occurrence the name of its pattern, in frames of the whole file, as ELAN plays it."""
    import numpy as np

    from leitmotion.api import Segmentation

    spans = [pattern.occurrences for pattern in found.patterns]
    return Segmentation(
        starts=np.concatenate([np.zeros(0, dtype=np.int64), *(span.starts + first for span in spans)]),
        stops=np.concatenate([np.zeros(0, dtype=np.int64), *(span.stops + first for span in spans)]),
        labels=tuple(pattern.id for pattern in found.patterns for _ in pattern.occurrences),
        scores=np.concatenate([np.zeros(0), *(span.scores for span in spans)]),
        rate=found.rate,
    )


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per occurrence; a failure has none."""
    if "error" in document:
        return
    path = document["source"][0]["path"]
    for pattern in document["result"]["patterns"]:
        for place, occurrence in enumerate(pattern["occurrences"], start=1):
            row = {"path": path, "pattern": pattern["id"], "occurrence": place} | occurrence | pattern
            yield {column: row[column] for column in COLUMNS}
