"""One input after another: each is answered or fails in its own place, and the rest go on."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Collection, Generator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from leitmotion.cli.documents import Document, answer_document, as_line, error_document
from leitmotion.cli.failures import Failure, explain, show_traceback
from leitmotion.cli.inputs import Input, expand
from leitmotion.cli.outputs import reader_may_leave, tell_written
from leitmotion.cli.printing import answer_console
from leitmotion.cli.progress import Progress

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.cli.options import Options


@dataclass(frozen=True)
class Answer:
    """What a verb found in one input.

    Parameters
    ----------
    source : list of dict
        What was read, as :func:`~leitmotion.cli.documents.source_entry` makes it.
    result : dict
        The result of the contract.
    show : callable
        Prints it for a person.
    parameters : mapping
        What was looked for, and how.
    warnings : sequence of str
        What the person should know about the input.
    """

    source: list[Document]
    result: Document
    show: Callable[[Console], None]
    parameters: Mapping[str, object] = field(default_factory=dict)
    warnings: Sequence[str] = ()
    written: Sequence[str] = ()
    """What was written about this input alone, a sentence for each file."""
    headed: bool = True
    """Whether beside others it stands under its input's name, apart from them."""
    silent: bool = False
    """Whether beside others a person needs no word of it."""


@dataclass(frozen=True)
class LeftOut:
    """A file found in a folder is no recording but something else, such as a table of labels."""

    why: str


@dataclass(frozen=True)
class Outcome:
    """What came of all inputs: their documents in the order given, and whether any failed."""

    documents: list[Document]
    failed: bool


T = TypeVar("T")
Look = Callable[[Input, Progress], Answer]
Answers = Callable[[list[Input], Progress], Generator[Answer | Failure | LeftOut]]
Check = Callable[[list[Input]], None]


def answer_each(
    verb: str, arguments: Sequence[str], options: Options, look: Look, *, check: Check | None = None
) -> Outcome:
    """Look at every input and print what was found, as sentences or as the documents of the contract.

    Parameters
    ----------
    verb : str
        What is asked.
    arguments : sequence of str
        The inputs as typed.
    options : Options
        How to answer.
    look : callable
        Answers one input; whatever it raises becomes that input's failure, wrong usage excepted.
    check : callable, optional
        Looks at the list of inputs before the first is read, and may refuse it as wrong usage.

    Returns
    -------
    Outcome
        The documents, in order, and whether any is a failure.
    """

    def answers(inputs: list[Input], progress: Progress) -> Generator[Answer | Failure | LeftOut]:
        for given in inputs:
            yield attempt(given, look, progress)
            progress.step()

    return answer_all(verb, arguments, options, answers, check=check)


def answer_all(
    verb: str,
    arguments: Sequence[str],
    options: Options,
    answers: Answers,
    *,
    check: Check | None = None,
    apart: Collection[Path] = (),
) -> Outcome:
    """Print what comes of all inputs; as :func:`answer_each`, which looks at one after another.

    Parameters
    ----------
    verb, arguments, options, check
        As for :func:`answer_each`.
    answers : callable
        Gives what came of each input, in their order.
    apart : collection of Path
        What the search of folders passes over.
    """
    from leitmotion.io.formats import readable

    documents: list[Document] = []
    with contextlib.ExitStack() as stack:
        inputs = stack.enter_context(expand(arguments, readable(), apart=apart))
        progress = stack.enter_context(Progress(len(inputs), quiet=options.quiet))
        if check is not None:
            check(inputs)
        alone = len(inputs) == 1 and inputs[0].shown in arguments
        each = stack.enter_context(contextlib.closing(answers(inputs, progress)))
        for given, answer in zip(inputs, each, strict=True):
            progress.hide()
            if isinstance(answer, LeftOut):
                progress.note(line(given, "Left out, as no recording", answer.why, alone=alone))
                continue
            documents.append(_print(verb, given, answer, options, first=not documents, alone=alone))
        if not documents:
            none = Input(arguments[0], Path(arguments[0]))
            failure = Failure("DataError", f"Nothing in {' and '.join(arguments)} is a recording.", "")
            documents.append(_print(verb, none, failure, options, first=True, alone=True))
    return Outcome(documents, any("error" in document for document in documents))


def answer_one(verb: str, given: Input, options: Options, look: Look) -> Outcome:
    """Answer about what is not a recording that an argument names; otherwise as :func:`answer_each`."""
    with Progress(1, quiet=options.quiet) as progress:
        answer = attempt(given, look, progress)
        progress.hide()
        if isinstance(answer, LeftOut):
            raise AssertionError("nothing that was named is left out")
        document = _print(verb, given, answer, options, first=True, alone=True)
    return Outcome([document], "error" in document)


def attempt(given: Input, look: Callable[[Input, Progress], T], progress: Progress) -> T | Failure | LeftOut:
    """Look at one input; whatever is raised becomes its failure, wrong usage excepted."""
    try:
        if given.fault is not None:
            raise given.fault
        return look(given, progress)
    except (click.ClickException, click.exceptions.Exit, BrokenPipeError):
        raise
    except Exception as error:
        failure = explain(error)
        if given.doubtful and failure.type == "FormatError":
            return LeftOut(failure.message)
        return failure


def _print(
    verb: str, given: Input, answer: Answer | Failure, options: Options, *, first: bool, alone: bool
) -> Document:
    """Print one answer or failure, and return its document."""
    if isinstance(answer, Failure):
        document = error_document(verb, given, answer)
        if options.traceback and answer.error is not None:
            show_traceback(answer.error)
    else:
        document = answer_document(
            verb, answer.source, parameters=answer.parameters, warnings=answer.warnings, result=answer.result
        )
    with reader_may_leave(options):
        if options.as_json:
            click.echo(as_line(document))
        elif isinstance(answer, Failure):
            click.echo(line(given, "Error", answer.text, alone=alone), err=True)
        elif alone or not answer.silent:
            _show(given, answer, options, first=first, alone=alone)
    for sentence in () if isinstance(answer, Failure) else answer.written:
        apart = options.as_json and not alone and sentence  # on standard error, among the lines about others
        tell_written(f"{given.shown}: {sentence}" if apart else sentence, options)
    return document


def _show(given: Input, answer: Answer, options: Options, *, first: bool, alone: bool) -> None:
    console = answer_console()
    if answer.headed and not first:
        console.print()
    if answer.headed and not alone:
        console.print(given.shown, style="bold")
    answer.show(console)
    if not options.quiet:
        for warning in answer.warnings:
            click.echo(line(given, "Note", warning, alone=alone), err=True)


def line(given: Input, kind: str, text: str, *, alone: bool) -> str:
    """Say something on standard error about an input; beside others the line begins with its name."""
    if alone:
        return f"{kind}: {text}"
    name = given.path.name
    return f"{given.shown}: {kind}: {text.removeprefix(f'{name}, ').removeprefix(f'{name}: ')}"


def finish(outcome: Outcome) -> Any:
    """End with status 1 when any input failed."""
    if outcome.failed:
        click.get_current_context().exit(1)
