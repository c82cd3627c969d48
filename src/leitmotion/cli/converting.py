"""One input converted, in this process or in another: what is asked, what is done, and what came of it.

A file that is there is replaced only where the ledger tells that an earlier run wrote it and it has not been changed
since, or by force; one that holds the very bytes that would be written is left alone.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from leitmotion.cli.batch import LeftOut
from leitmotion.cli.failures import Failure, explain, show_traceback
from leitmotion.cli.inputs import Input
from leitmotion.cli.ledger import Entry, checksum, checksum_of_all, facts, still_holds
from leitmotion.cli.targets import identity


@dataclass(frozen=True)
class Order:
    """What is asked of every input."""

    folder: Path
    """Where is written, and where the ledger is."""

    extension: str
    reading: Mapping[str, Any] = field(default_factory=dict)
    body_map: Mapping[str, Any] | None = None
    writing: Mapping[str, Any] = field(default_factory=dict)
    force: bool = False
    traceback: bool = False
    inputs: frozenset[str] = frozenset()
    """The identities of what is read, never written over."""

    targets: frozenset[str] = frozenset()
    """The identities of what the inputs become, each for its own."""

    @property
    def parameters(self) -> dict[str, Any]:
        """How it is converted, as the answer tells it."""
        reading = {"reading": dict(self.reading)} if self.reading else {}
        mapped = {"map": dict(self.body_map)} if self.body_map else {}
        return {"to": self.extension.removeprefix("."), **reading, **mapped, **self.writing}


@dataclass(frozen=True)
class Task:
    """One input, and what it becomes."""

    given: Input
    target: Path
    entry: Entry | None = None
    """What the ledger says of the target."""


@dataclass(frozen=True)
class Told:
    """What came of a conversion."""

    entry: Entry
    """What the ledger is to keep."""

    skipped: bool
    """Whether it was there already."""


def work(order: Order, task: Task) -> Told | Failure | LeftOut:
    """Convert one input; whatever goes wrong is what came of it."""
    try:
        if task.given.fault is not None:
            raise task.given.fault
        return _convert(order, task)
    except Exception as error:
        if order.traceback:
            show_traceback(error)
        failure = explain(error)
        return Failure(failure.type, failure.message, failure.remedy)  # an exception need not pass a pipe


def _convert(order: Order, task: Task) -> Told | LeftOut:
    from leitmotion.conversion import holds, name_of, prepare
    from leitmotion.io import write_whole
    from leitmotion.motion.errors import FormatError

    window = {"window": task.given.window} if task.given.window else {}
    parameters = order.parameters | window
    if task.entry is not None and not order.force:
        now = {"sha256": task.given.sha256(), "others": _others(order, task)}
        if still_holds(task.entry, order.folder, parameters=parameters, **now):
            return Told(task.entry, skipped=True)
    try:
        made = prepare(
            task.given.source, order.extension, body_map=order.body_map, **order.reading, **order.writing
        )
    except FormatError as error:
        if task.given.doubtful:
            return LeftOut(error.message)
        raise
    files = [(name_of(task.target, person), content) for person, content in made.files]
    there = [holds(path, content) for path, content in files]
    for (path, _), held in zip(files, there, strict=True):
        _refuse(path, order, task, held=held)
    for (path, content), held in zip(files, there, strict=True):
        if not held:
            write_whole(path, content)
    entry = facts(
        sha256=task.given.sha256(),
        others=_others(order, task),
        parameters=parameters,
        written={path.relative_to(order.folder).as_posix(): checksum(path) for path, _ in files},
        told={
            "frames": made.frames,
            "rate": made.rate,
            "window": made.window,
            "skeleton": bool(made.skeleton),
            "changes": [change._asdict() for change in made.changes],
            "warnings": list(made.warnings),
        },
    )
    return Told(entry, skipped=all(there))


def _others(order: Order, task: Task) -> str:
    """The checksum of what is read with the input: an AMC's skeleton, the other frames of a clip."""
    from leitmotion.io.companions import others_read

    return checksum_of_all(others_read(task.given.path, order.reading.get("skeleton")))


def _refuse(path: Path, order: Order, task: Task, *, held: bool) -> None:
    """Refuse a place that is not for this input, or that holds what is not ours."""
    from leitmotion.conversion import is_same
    from leitmotion.motion.errors import DataError

    own = identity(path)
    if own in order.inputs or is_same(path, task.given.path):
        raise DataError(
            f"{path} is an input, and inputs are never written over.", remedy="Choose another -o."
        )
    if path != task.target and own in order.targets:
        raise DataError(
            f"{path} is what another input becomes.", remedy="Convert the two into different folders."
        )
    if held or order.force or not path.exists():
        return
    ours = {} if task.entry is None else task.entry["written"]
    if checksum(path) != ours.get(path.relative_to(order.folder).as_posix()):
        raise DataError(f"{path} is there with other content.", remedy="Replace it with --force.")
