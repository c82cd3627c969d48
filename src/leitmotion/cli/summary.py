"""``leitmotion patterns --summary``: a short recording that shows each movement once, and its table of contents."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.copies import copy_targets, write_copy
from leitmotion.cli.documents import Document, patterns_result, stretch
from leitmotion.cli.finding import search, show_patterns, warnings_of
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import check_output, tell_written, write_documents
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import open_one

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Patterns, Summary

COLUMNS = (
    "path", "pattern", "kind", "start", "stop", "start_s", "stop_s",
    "source_start", "source_stop", "source_start_s", "source_stop_s",
)  # fmt: skip
"""Columns of the table of contents, one row per movement shown."""


def summary_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the options ``--summary`` and ``--contents``."""
    command = click.option(
        "--contents",
        type=click.Path(dir_okay=False, path_type=Path),
        metavar="FILE",
        help="With --summary: write its table of contents, .csv or .json.",
    )(command)
    return click.option(
        "--summary",
        is_flag=True,
        help="Make a short recording that shows each movement once: -o names it, or a folder for several.",
    )(command)


def summarise(inputs: tuple[str, ...], contents: Path | None, options: Options) -> None:
    """Answer each input with its summary.

    Parameters
    ----------
    inputs : tuple of str
        As typed.
    contents : Path or None
        Where the table of contents is written.
    options : Options
        How to read, search and answer.
    """
    targets: dict[str, Path] = {}

    def check(given: Sequence[Input]) -> None:
        if options.output is not None:
            targets.update(copy_targets(given, options.output, force=options.force))
        if contents is not None:
            check_output(contents, given, endings=(".csv", ".json"), force=options.force)
            if contents in targets.values():
                raise click.UsageError(f"{contents} is the summary itself: name another file for --contents.")

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.api import summarize

        opened = open_one(given, options, progress)
        found = search(opened, options, progress)
        shown, target, kept, lost = None, None, "", tuple[str, ...]()
        if found.patterns:
            progress.say(f"Making a summary of {given.path.name}")
            shown = summarize(
                opened.recording,
                found,
                joints=options.joints or None,
                exclude=options.exclude,
                body_map=opened.roles,
            )
            target = targets.get(given.shown)
            if target is not None:
                kept, lost = write_copy(shown.recording, target, force=options.force)
        seconds = opened.source[0]["seconds"]

        def show(console: Console) -> None:
            if shown is None:
                show_patterns(console, found, seconds=seconds, body=opened.body)
                console.print("So there is nothing to summarise, and no recording was written.")
            else:
                _show(console, shown, found, target, seconds=seconds)

        return Answer(
            source=opened.source,
            result=patterns_result(found) | {"contents": _contents(shown, found), "written": target},
            show=show,
            parameters={**found.parameters, **opened.parameters},
            warnings=[*warnings_of(opened, found), *lost],
            written=[kept],
        )

    outcome = answer_each("patterns", inputs, options, look, check=check)
    if contents is not None:
        tell_written(write_documents(contents, outcome.documents, COLUMNS, _rows), options)
    finish(outcome)


def _contents(shown: Summary | None, found: Patterns) -> list[Document]:
    if shown is None:
        return []
    kinds = {pattern.id: pattern.kind for pattern in found.patterns}
    return [
        stretch(start, stop, rate=found.rate, label=name)
        | {
            "pattern": name,
            "kind": kinds[name],
            "source": stretch(first, last, rate=found.rate, label=name),
        }
        for (start, stop, name, _), (first, last, *_) in zip(shown.contents, shown.sources, strict=True)
    ]


def _show(console: Console, shown: Summary, found: Patterns, target: Path | None, *, seconds: float) -> None:
    from leitmotion.view.counting import clock, plural

    where = "; it was not written: name it with -o" if target is None else ""
    count = plural(len(shown.contents), "movement")
    console.print(
        f"{count} in {shown.recording.duration:.1f} s, of a recording of {seconds:.1f} s{where}.",
        style="bold",
    )
    console.print()
    kinds = {pattern.id: pattern.kind for pattern in found.patterns}
    rate = found.rate
    print_table(
        console,
        ("", "kind", "in the summary", "in the recording"),
        [
            (
                name,
                kinds[name],
                f"{clock(start / rate)}–{clock(stop / rate)}",
                f"{clock(first / rate)}–{clock(last / rate)}",
            )
            for (start, stop, name, _), (first, last, *_) in zip(shown.contents, shown.sources, strict=True)
        ],
    )


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per movement shown; a failure has none."""
    if "error" in document:
        return
    path = document["source"][0]["path"]
    for entry in document["result"]["contents"]:
        source = {f"source_{field}": value for field, value in entry["source"].items()}
        row = {"path": path} | entry | source
        yield {column: row[column] for column in COLUMNS}
