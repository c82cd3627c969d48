"""``leitmotion patterns --across``: what several recordings share."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from leitmotion.cli.batch import Answer, Outcome
from leitmotion.cli.documents import Document
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import check_output, write_documents, write_figure
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened
from leitmotion.cli.sharing import remarks, shared_result, short_names, show_shared
from leitmotion.cli.together import Gathered, answer_together

if TYPE_CHECKING:
    from leitmotion.api import SharedPatterns

PICTURES = (".png", ".svg", ".pdf")
TABLES = (".json", ".csv")
ENDINGS = (*TABLES, ".html", ".npz", *PICTURES)
OF_ONE = {".eaf": "An ELAN file"}
"""Endings of what shows a single recording only."""
OF_FILES = ("joint_rotations", "marker_posture")
"""Features that need the joints or markers of the file itself, which differ from one to the next."""
COLUMNS = (
    "path", "pattern", "occurrence", "start", "stop", "start_s", "stop_s", "score",
    "kind", "sources", "cycles", "period_s", "cost", "confidence",
)  # fmt: skip
"""Columns of the table, one row per occurrence; "sources" is in how many recordings the pattern occurs."""


def answer_across(arguments: Sequence[str], options: Options) -> Outcome:
    """Search all inputs together and print what they share; an input that fails is named, and the rest go on.

    Parameters
    ----------
    arguments : sequence of str
        The inputs as typed.
    options : Options
        How to read, search and answer.

    Returns
    -------
    Outcome
        The error documents of the inputs that failed, then the one document of all others.
    """
    _check_options(options)
    outcome = answer_together(
        "patterns",
        arguments,
        options,
        lambda gathered, progress: _look(gathered, options, progress),
        check=lambda inputs: _check(inputs, options),
        several=True,
    )
    if options.output is not None and options.output.suffix.lower() in TABLES:
        write_documents(options.output, outcome.documents, COLUMNS, _rows)
    return outcome


def _check_options(options: Options) -> None:
    if options.method != "recurrence":
        raise click.UsageError(f"--across does not go with --method {options.method}.")
    if options.features in OF_FILES:
        raise click.UsageError(f"--across does not go with --features {options.features}.")
    if options.weights != "equal":
        raise click.UsageError(f"--across does not go with --weights {options.weights}.")
    if options.stillness:
        raise click.UsageError("--across does not go with --stillness.")
    ending = options.output.suffix.lower() if options.output is not None else ""
    if options.output is not None and ending in OF_ONE:
        raise click.UsageError(
            f"{OF_ONE[ending]} shows one recording, and --across is about several: end {options.output.name} in "
            f"{', '.join(ENDINGS)}."
        )


def _check(inputs: Sequence[Input], options: Options) -> None:
    if len(inputs) < 2 and all(given.fault is None for given in inputs):
        raise click.UsageError(
            f"--across compares recordings with one another, and there is only {inputs[0].shown}. Name another, or "
            "leave --across out."
        )
    if options.output is not None:
        check_output(options.output, inputs, endings=ENDINGS, force=options.force)


def _look(gathered: Gathered, options: Options, progress: Progress) -> Answer:
    """Search what could be read, and write what was found."""
    found = _search(gathered, options, progress)
    opened = [one for _, one in gathered.opened]
    answer = Answer(
        source=[one.source[0] for one in opened],
        result=shared_result(found),
        show=lambda console: show_shared(console, found),
        parameters={**found.parameters, **gathered.parameters},
        warnings=[*gathered.warnings, *remarks(found, [one.body for one in opened])],
    )
    if options.output is not None and options.output.suffix.lower() not in TABLES:
        _write(options.output, found, gathered.opened, options, progress)
    return answer


def _search(gathered: Gathered, options: Options, progress: Progress) -> SharedPatterns:
    from leitmotion.api import find_shared_patterns
    from leitmotion.motion import DataError

    opened, asked, same = gathered
    if len(opened) < 2 and same:
        raise DataError(
            f"There is only one recording to compare: {same[0].partition(', and')[0]}.",
            remedy="What recordings share takes two or more that differ.",
        )
    if len(opened) < 2:
        raise DataError(
            f"{'Only one' if opened else 'None'} of {asked} inputs could be read.",
            remedy="What recordings share takes two or more.",
        )
    progress.say(f"Looking for what {len(opened)} recordings share")
    passed_over = {"method", "weights"}
    if click.get_current_context().get_parameter_source("features") is ParameterSource.DEFAULT:
        passed_over.add("features")  # people are compared by something else than moments of one
    searching = {name: value for name, value in options.searching.items() if name not in passed_over}
    with compiling_noted(progress):
        return find_shared_patterns(
            [one.body for _, one in opened],
            names=short_names(gathered.names),
            **searching,
        )


def _write(
    path: Path,
    found: SharedPatterns,
    opened: Sequence[tuple[Input, Opened]],
    options: Options,
    progress: Progress,
) -> None:
    ending = path.suffix.lower()
    progress.say(f"Writing {path.name}")
    if ending == ".npz":
        from leitmotion.api import save

        save(found, path)
    elif ending == ".html":
        from leitmotion.api import report_shared

        report_shared(
            [one.body for _, one in opened],
            path,
            shared=found,
            paths=[given.shown for given, _ in opened],
            joints=options.joints or None,
            exclude=options.exclude,
            force=True,  # whether the page may be replaced was asked before any work
        )
    else:
        from leitmotion.view import plot_shared_patterns

        write_figure(path, plot_shared_patterns(found))
    progress.hide()


def _rows(document: Document) -> Iterator[Mapping[str, object]]:
    """One row per occurrence; a failure has none."""
    if "error" in document:
        return
    for pattern in document["result"]["patterns"]:
        for place, occurrence in enumerate(pattern["occurrences"], start=1):
            path = document["source"][occurrence["source"]]["path"]
            row = {"path": path, "pattern": pattern["id"], "occurrence": place} | occurrence | pattern
            yield {column: row[column] for column in COLUMNS} | {"sources": len(pattern["sources"])}
