"""All inputs answered in one: each is read or fails in its own place, those that were read are looked at together."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import click

from leitmotion.cli.batch import Answer, LeftOut, Outcome, attempt, line
from leitmotion.cli.documents import Document, answer_document, as_line, error_document
from leitmotion.cli.failures import Failure, explain, show_traceback
from leitmotion.cli.inputs import Input, expand
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import reader_may_leave, tell_written
from leitmotion.cli.printing import answer_console
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import Opened, open_one


class Gathered(NamedTuple):
    """What came of reading all inputs."""

    opened: list[tuple[Input, Opened]]
    """Those that could be read, no recording twice."""

    asked: int
    """How many there were."""

    same: list[str]
    """A sentence about each that is one of the others again."""

    @property
    def names(self) -> list[str]:
        """What the recordings are called."""
        return [given.shown for given, _ in self.opened]

    @property
    def warnings(self) -> list[str]:
        """What the person should know about the inputs, under their names where there are several."""
        told = [
            f"{given.shown}: {warning}" if self.asked > 1 else warning
            for given, one in self.opened
            for warning in one.warnings
        ]
        return [*self.same, *told]

    @property
    def parameters(self) -> Document:
        """What was said about reading, which is alike for all, and the window of each where any has one."""
        told = {name: value for name, value in self.opened[0][1].parameters.items() if name != "window"}
        windows = [one.parameters.get("window") for _, one in self.opened]
        if not any(windows):
            return told
        return told | ({"window": windows[0]} if self.asked == 1 else {"windows": windows})


Look = Callable[[Gathered, Progress], Answer]
Check = Callable[[list[Input]], None]


def answer_together(
    verb: str,
    arguments: Sequence[str],
    options: Options,
    look: Look,
    *,
    check: Check,
    read: Callable[[Input, Options, Progress], Opened] = open_one,
    several: bool = False,
) -> Outcome:
    """Look at all inputs together and print what was found; an input that fails is named, and the rest go on.

    Parameters
    ----------
    verb : str
        What is asked.
    arguments : sequence of str
        The inputs as typed.
    options : Options
        How to read and to answer.
    look : callable
        Answers about all that could be read; whatever it raises becomes the failure of them all.
    check : callable
        Looks at the list of inputs before the first is read, and may refuse it as wrong usage.
    read : callable
        Opens one input, or says why it cannot be looked at.
    several : bool
        Whether it takes two or more, so that `look` is to say what is missing where none could be read.

    Returns
    -------
    Outcome
        The error documents of the inputs that failed, then the one document of all others.
    """
    from leitmotion.io.formats import readable

    documents: list[Document] = []
    with contextlib.ExitStack() as stack:
        inputs = stack.enter_context(expand(arguments, readable()))
        progress = stack.enter_context(Progress(len(inputs), quiet=options.quiet))
        check(inputs)
        alone = len(inputs) == 1 and not several
        opened: list[tuple[Input, Opened]] = []
        for given in inputs:
            came = attempt(given, lambda one, told: read(one, options, told), progress)
            progress.step()
            if isinstance(came, Opened):
                opened.append((given, came))
                continue
            progress.hide()
            if isinstance(came, LeftOut):
                progress.note(line(given, "Left out, as no recording", came.why, alone=alone))
            else:
                documents.append(_failed(verb, given, came, options, alone=alone))
        distinct, same = _distinct(opened)
        if opened or several:
            gathered = Gathered(distinct, len(inputs), same)
            documents.append(_answered(verb, inputs, gathered, look, options, progress))
        elif not documents:
            failure = Failure("DataError", f"Nothing in {' and '.join(arguments)} is a recording.")
            documents.append(
                _failed(verb, Input(arguments[0], Path(arguments[0])), failure, options, alone=True)
            )
    return Outcome(documents, any("error" in document for document in documents))


def _failed(verb: str, given: Input, failure: Failure, options: Options, *, alone: bool) -> Document:
    """Print why an input could not be read, and return its document."""
    document = error_document(verb, given, failure)
    if options.traceback and failure.error is not None:
        show_traceback(failure.error)
    if options.as_json:
        click.echo(as_line(document))
    else:
        click.echo(line(given, "Error", failure.text, alone=alone), err=True)
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


def _answered(
    verb: str,
    inputs: Sequence[Input],
    gathered: Gathered,
    look: Look,
    options: Options,
    progress: Progress,
) -> Document:
    """Print what was found in all that could be read, or why nothing was, and return the document."""
    try:
        answer = look(gathered, progress)
    except (click.ClickException, click.exceptions.Exit, BrokenPipeError):
        raise
    except Exception as error:
        progress.hide()
        read = [given for given, _ in gathered.opened]
        return _none_answered(verb, read or inputs, explain(error), options)
    progress.hide()
    document = answer_document(
        verb, answer.source, parameters=answer.parameters, warnings=answer.warnings, result=answer.result
    )
    with reader_may_leave(options):
        if options.as_json:
            click.echo(as_line(document))
        else:
            answer.show(answer_console())
    if not options.as_json and not options.quiet:
        for warning in answer.warnings:
            click.echo(f"Note: {warning}", err=True)
    for sentence in answer.written:
        tell_written(sentence, options)
    return document


def _none_answered(verb: str, inputs: Sequence[Input], failure: Failure, options: Options) -> Document:
    """Print why nothing could be answered, and return the document that names all inputs."""
    document = error_document(verb, inputs[0], failure) | {"source": [{"path": one.shown} for one in inputs]}
    if options.traceback and failure.error is not None:
        show_traceback(failure.error)
    if options.as_json:
        click.echo(as_line(document))
    else:
        click.echo(failure.sentence, err=True)
    return document
