"""``leitmotion patterns --across``: what several recordings share."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from leitmotion.cli.batch import LeftOut, Outcome, attempt, line
from leitmotion.cli.documents import Document, answer_document, as_line, error_document
from leitmotion.cli.failures import Failure, explain, show_traceback
from leitmotion.cli.inputs import Input, expand
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import check_output, write_documents, write_figure
from leitmotion.cli.printing import answer_console
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened, open_one
from leitmotion.cli.sharing import remarks, shared_result, short_names, show_shared

if TYPE_CHECKING:
    from leitmotion.api import SharedPatterns

VERB = "patterns"
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
    from leitmotion.io.formats import readable

    _check_options(options)
    documents: list[Document] = []
    with contextlib.ExitStack() as stack:
        inputs = stack.enter_context(expand(arguments, readable()))
        progress = stack.enter_context(Progress(len(inputs), quiet=options.quiet))
        _check(inputs, options)
        opened: list[tuple[Input, Opened]] = []
        for given in inputs:
            read = attempt(given, lambda one, told: open_one(one, options, told), progress)
            progress.step()
            if isinstance(read, Opened):
                opened.append((given, read))
            elif isinstance(read, LeftOut):
                progress.hide()
                progress.note(line(given, "Left out, as no recording", read.why, alone=False))
            else:
                progress.hide()
                documents.append(_failed(given, read, options))
        distinct, same = _distinct(opened)
        documents.append(_together(inputs, distinct, same, options, progress))
    if options.output is not None and options.output.suffix.lower() in TABLES:
        write_documents(options.output, documents, COLUMNS, _rows)
    return Outcome(documents, any("error" in document for document in documents))


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


def _failed(given: Input, failure: Failure, options: Options) -> Document:
    """Print why an input could not be read, and return its document."""
    document = error_document(VERB, given, failure)
    if options.traceback and failure.error is not None:
        show_traceback(failure.error)
    if options.as_json:
        click.echo(as_line(document))
    else:
        click.echo(line(given, "Error", failure.text, alone=False), err=True)
    return document


def _distinct(opened: Sequence[tuple[Input, Opened]]) -> tuple[list[tuple[Input, Opened]], list[str]]:
    """Those that differ, and a sentence about each that is one of them again: the same path, a copy, a link."""
    kept: dict[tuple[object, ...], tuple[Input, Opened]] = {}
    same: list[str] = []
    for given, one in opened:
        body = one.body
        first = kept.setdefault(
            (body.roles, body.rate, body.positions.shape, body.positions.tobytes()), (given, one)
        )
        if first[1] is one:
            continue
        again = (
            "is named twice"
            if first[0].shown == given.shown
            else f"is the same recording as {first[0].shown}"
        )
        same.append(f"{given.shown} {again}, and was compared once.")
    return list(kept.values()), list(dict.fromkeys(same))


def _together(
    inputs: Sequence[Input],
    opened: Sequence[tuple[Input, Opened]],
    same: Sequence[str],
    options: Options,
    progress: Progress,
) -> Document:
    """Search what could be read, print and write what was found, and return its document."""
    read = [given for given, _ in opened]
    try:
        found = _search(opened, len(inputs), same, options, progress)
        progress.hide()
        warnings = [*same, *_warnings(opened), *remarks(found, [one.body for _, one in opened])]
        document = answer_document(
            VERB,
            [one.source[0] for _, one in opened],
            parameters={**found.parameters, **_how_read([one for _, one in opened])},
            warnings=warnings,
            result=shared_result(found),
        )
        if options.output is not None and options.output.suffix.lower() not in TABLES:
            _write(options.output, found, opened, options, progress)
    except (click.ClickException, click.exceptions.Exit, BrokenPipeError):
        raise
    except Exception as error:
        progress.hide()
        return _none_together(read or inputs, explain(error), options)
    if options.as_json:
        click.echo(as_line(document))
        return document
    show_shared(answer_console(), found)
    for warning in warnings if not options.quiet else ():
        click.echo(f"Note: {warning}", err=True)
    return document


def _search(
    opened: Sequence[tuple[Input, Opened]],
    asked: int,
    same: Sequence[str],
    options: Options,
    progress: Progress,
) -> SharedPatterns:
    from leitmotion.api import find_shared_patterns
    from leitmotion.motion import DataError

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
            names=short_names([given.shown for given, _ in opened]),
            **searching,
        )


def _none_together(inputs: Sequence[Input], failure: Failure, options: Options) -> Document:
    """Print why nothing could be searched, and return the document."""
    document = error_document(VERB, inputs[0], failure) | {"source": [{"path": one.shown} for one in inputs]}
    if options.traceback and failure.error is not None:
        show_traceback(failure.error)
    if options.as_json:
        click.echo(as_line(document))
    else:
        click.echo(failure.sentence, err=True)
    return document


def _how_read(opened: Sequence[Opened]) -> Document:
    """What was said about reading, which is alike for all, and the window of each where any has one."""
    told = {name: value for name, value in opened[0].parameters.items() if name != "window"}
    windows = [one.parameters.get("window") for one in opened]
    return told | ({"windows": windows} if any(windows) else {})


def _warnings(opened: Sequence[tuple[Input, Opened]]) -> list[str]:
    return [f"{given.shown}: {warning}" for given, one in opened for warning in one.warnings]


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
