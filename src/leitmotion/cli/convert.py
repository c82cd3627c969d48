"""``leitmotion convert``: recordings in another format, one or whole folders, several at a time."""

from __future__ import annotations

import contextlib
import os
import sys
from collections import Counter
from collections.abc import Generator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.batch import Answer, LeftOut, Outcome, answer_all, finish
from leitmotion.cli.converting import Order, Task, Told, work
from leitmotion.cli.documents import source_entry
from leitmotion.cli.failures import Failure
from leitmotion.cli.inputs import Input, expand
from leitmotion.cli.ledger import Ledger
from leitmotion.cli.options import (
    Options,
    Positive,
    as_json,
    common,
    examples,
    known_unit,
    output,
    takes_inputs,
)
from leitmotion.cli.outputs import check_output, check_place
from leitmotion.cli.pool import Died, each_as_done, usable_processors
from leitmotion.cli.printing import answer_console
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import unused_skeleton
from leitmotion.cli.targets import identity, plan

if TYPE_CHECKING:
    from rich.console import Console


@click.command(
    epilog=examples(
        "leitmotion convert dance.bvh -o dance.npz",
        "leitmotion convert recordings/ -o converted/ --to bvh",
        "leitmotion convert dance.bvh[2s:5s] --fps 30 -o - --to bvh > part.bvh",
    )
)
@takes_inputs
@output(
    "The file to write, its format by its ending; of several inputs a folder, with --to; - for standard output.",
    folder=True,
    required=True,
)
@click.option("--to", metavar="FORMAT", help="The format to write, by its ending: bvh, c3d, glb, npz, …")
@click.option(
    "--out-unit",
    callback=known_unit,
    metavar="UNIT",
    help="Unit of length to write, where the format leaves it open; else the format's usual one.",
)
@click.option("--fps", type=Positive(), metavar="HZ", help="Frames per second to write: resample.")
@click.option(
    "--jobs",
    "-j",
    type=click.IntRange(min=1),
    metavar="N",
    help="How many inputs at a time; as many as there are processors by default.",
)
@click.option("--force", is_flag=True, help="Convert all anew, and replace files that something else wrote.")
@as_json
@common(searching=False, sides=False)
def convert(
    inputs: tuple[str, ...],
    to: str | None,
    out_unit: str | None,
    fps: float | None,
    jobs: int | None,
    options: Options,
) -> None:
    """Write recordings in another format, whole folders at once.

    A second run does only what is left. An input that cannot be converted says so in its place, and the rest go on.
    """
    out = options.output or Path()
    alone = _is_file(out)  # asked once: a folder may be made meanwhile
    extension = _extension(to, out, out_unit, alone=alone)
    writing = {name: value for name, value in (("fps", fps), ("out_unit", out_unit)) if value is not None}
    if str(out) == "-":
        _to_standard_output(inputs, extension, writing, options)
        return
    folder = out.parent if alone else out
    ledger = None if alone else Ledger(folder)
    tasks: list[Task] = []

    def check(given: Sequence[Input]) -> None:
        targets = _targets(given, out, extension, options, alone=alone)
        for one, target in zip(given, targets, strict=True):
            tasks.append(Task(one, target, ledger.entry(target, one.path) if ledger is not None else None))

    def answers(given: Sequence[Input], progress: Progress) -> Generator[Answer | Failure | LeftOut]:
        order = Order(
            folder=folder,
            extension=extension,
            reading=options.reading,
            body_map=options.map_entries(),
            writing=writing,
            force=options.force,
            noted=ledger is not None,
            traceback=options.traceback,
            inputs=frozenset(identity(one.path) for one in given),
            targets=frozenset(identity(task.target) for task in tasks),
        )
        return _in_order(order, tasks, jobs or usable_processors(), ledger, options, progress)

    outcome = answer_all(
        "convert",
        inputs,
        options,
        answers,
        check=check,
        apart=() if ledger is None else {folder, *ledger.written()},
    )
    if ledger is not None:
        ledger.close()
    if len(outcome.documents) > 1 and not options.as_json:
        _summarise(outcome)
    finish(outcome)


def _extension(to: str | None, out: Path, out_unit: str | None, *, alone: bool) -> str:
    """The format to write, as ``.bvh``, of what was said and of the file's ending."""
    from leitmotion.io.formats import writable

    forms = writable()
    known = ", ".join(form.removeprefix(".") for form in forms)
    if to is None and not alone:
        where = "standard output" if str(out) == "-" else out
        raise click.UsageError(f"Say which format to write into {where}: --to with one of {known}.")
    extension = out.suffix.lower() if to is None else f".{to.removeprefix('.').lower()}"
    if extension not in forms:
        raise click.BadParameter(
            f"{to!r} is no format that is written; these are: {known}.", param_hint="--to"
        )
    if alone and out.suffix.lower() != extension:
        raise click.UsageError(f"{out.name} ends in {out.suffix}, but --to says {to}.")
    if out_unit is not None and "unit" not in forms[extension].options:
        raise click.UsageError(f"--out-unit does not go with {extension}, which has a unit of its own.")
    return extension


def _is_file(out: Path) -> bool:
    """Whether OUT names a file of a format that is written, and no folder."""
    from leitmotion.io.formats import writable

    return out.suffix.lower() in writable() and not os.path.isdir(out)


def _targets(
    given: Sequence[Input], out: Path, extension: str, options: Options, *, alone: bool
) -> Sequence[Path]:
    """Where each input is written; what cannot be is refused before any work."""
    if alone:
        if len(given) > 1:
            raise click.UsageError(
                f"{out} names one file, but there are {len(given)} recordings. "
                f"Name a folder: -o {out.with_suffix('')} --to {extension.removeprefix('.')}."
            )
        check_output(out, given, endings=(extension,), force=options.force, recording=True)
        return [out]
    if out.exists() and not out.is_dir():
        raise click.UsageError(f"{out} is a file, not a folder.")
    check_place(out / f"recording{extension}")
    targets = plan(given, out, extension)
    if targets.remark and not options.quiet:
        click.echo(f"Note: {targets.remark}", err=True)
    return targets.paths


def _in_order(
    order: Order,
    tasks: Sequence[Task],
    jobs: int,
    ledger: Ledger | None,
    options: Options,
    progress: Progress,
) -> Generator[Answer | Failure | LeftOut]:
    """What comes of each task, in their order, noted in the ledger as soon as it is done."""
    done: dict[int, Answer | Failure | LeftOut] = {}
    following = 0
    progress.say("Converting")
    with contextlib.closing(_as_done(order, tasks, jobs)) as results:
        for place, result in results:
            task = tasks[place]
            if isinstance(result, Told):
                if ledger is not None:
                    ledger.add(task.target, task.given.path, result.entry)
                done[place] = _answer(order, task, result, options, alone=len(tasks) == 1)
            else:
                done[place] = _killed(task, result) if isinstance(result, Died) else result
            progress.step()
            while following in done:
                yield done.pop(following)
                following += 1
            progress.say("Converting")


def _as_done(
    order: Order, tasks: Sequence[Task], jobs: int
) -> Generator[tuple[int, Told | Failure | LeftOut | Died]]:
    if len(tasks) == 1:  # another process would take longer to start than to convert
        yield 0, work(order, tasks[0])
    else:
        yield from each_as_done(partial(work, order), tasks, jobs)


def _killed(task: Task, died: Died) -> Failure:
    from leitmotion.io.files import discard_parts

    discard_parts(task.target.parent, died.process)
    how = f"by signal {-died.status}" if died.status < 0 else f"with status {died.status}"
    return Failure(
        "ProcessError",
        f"The process that converted {task.given.shown} was ended {how}.",
        "Was there enough memory? Try it alone, or with --jobs 1.",
    )


def _answer(order: Order, task: Task, told: Told, options: Options, *, alone: bool) -> Answer:
    entry, facts = told.entry, told.entry["told"]
    written = [str(order.folder / name) for name in entry["written"]]
    window = {"window": dict(zip(("start", "stop"), facts["window"]))} if facts["window"] else {}
    beside = {"skeleton": True} if facts["skeleton"] else {}

    def show(console: Console) -> None:
        as_it_was = " (was there already)" if told.skipped else ""
        console.print(f"{task.given.shown} → {', '.join(written)}{as_it_was}")
        for change in facts["changes"] if alone else ():
            console.print(f"Changed: {change['detail']}")

    return Answer(
        source=[source_entry(task.given, frames=facts["frames"], rate=facts["rate"], sha256=entry["sha256"])],
        parameters=order.parameters | window,
        result={"changes": facts["changes"], "written": written, "skipped": told.skipped},
        show=show,
        warnings=[*facts["warnings"], *unused_skeleton(options, beside)],
        headed=False,
        silent=told.skipped,
    )


def _summarise(outcome: Outcome) -> None:
    """Say how many were converted, and of how many something was not kept."""
    results = [document["result"] for document in outcome.documents if "result" in document]
    skipped = sum(result["skipped"] for result in results)
    failed = len(outcome.documents) - len(results)
    console = answer_console()
    console.print(
        f"Converted {len(results) - skipped} of {len(outcome.documents)}; {failed} failed, {skipped} skipped."
    )
    made = [result for result in results if not result["skipped"]]
    counts = Counter(what for result in made for what in {change["what"] for change in result["changes"]})
    unread = counts.pop("unread", 0)
    if counts:
        told = ", ".join(f"{what} of {count}" for what, count in sorted(counts.items()))
        console.print(f"Changed: {told}. With --json each is told.")
    if unread:
        console.print(f"Not compared with what was read, as such files are only written here: {unread}.")


def _to_standard_output(
    inputs: Sequence[str], extension: str, writing: dict[str, Any], options: Options
) -> None:
    from leitmotion.conversion import form_of, prepare
    from leitmotion.io.formats import readable
    from leitmotion.motion.errors import DataError

    if options.as_json:
        raise click.UsageError("-o - writes the recording to standard output, where --json would stand.")
    if sys.stdout.isatty() and not form_of(extension).text:
        raise click.UsageError(f"A {extension} is not for a terminal: send it to a file or another program.")
    with expand(inputs, readable()) as given, Progress(1, quiet=options.quiet) as progress:
        if len(given) != 1:
            raise click.UsageError(f"Standard output takes one recording, but there are {len(given)}.")
        if given[0].fault is not None:
            raise given[0].fault
        progress.say(f"Converting {given[0].path.name}")
        made = prepare(
            given[0].source, extension, body_map=options.map_entries(), **options.reading, **writing
        )
        if len(made.files) > 1:
            people = ", ".join(person for person, _ in made.files)
            raise DataError(
                f"{given[0].shown} holds {len(made.files)} people: {people}.",
                remedy="Choose one with --person NAME.",
            )
        progress.hide()
        for warning in made.warnings:
            progress.note(f"Note: {warning}")
        sys.stdout.buffer.write(made.files[0][1])
        sys.stdout.buffer.flush()
