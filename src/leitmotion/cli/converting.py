"""One input converted, in this process or in another: what is asked, what is done, and what came of it.

A file that is there is replaced only where the ledger tells that an earlier run wrote it and it has not been changed
since, or by force; one that holds the very bytes that would be written is left alone.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from leitmotion.cli.batch import LeftOut
from leitmotion.cli.failures import Failure, explain, show_traceback
from leitmotion.cli.inputs import Input
from leitmotion.cli.ledger import Entry, checksum, checksum_of_all, facts, plan, still_holds
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
    noted: bool = False
    """Whether the folder has a ledger."""

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
    from leitmotion.conversion import names_of, prepare
    from leitmotion.io import write_whole
    from leitmotion.io.files import holds
    from leitmotion.motion.errors import DataError, FormatError

    window = {"window": task.given.window} if task.given.window else {}
    parameters = order.parameters | window
    # before reading, so that what is replaced meanwhile is not taken for what was read
    read = _checksums(order, task)
    if (
        task.entry is not None
        and not order.force
        and still_holds(task.entry, order.folder, parameters=parameters, **read)
    ):
        return Told(task.entry, skipped=True)
    try:
        made = prepare(
            task.given.source, order.extension, body_map=order.body_map, **order.reading, **order.writing
        )
    except FormatError as error:
        if task.given.doubtful:
            return LeftOut(error.message)
        raise
    if _checksums(order, task) != read:
        raise DataError(f"{task.given.shown} changed while it was read.", remedy="Convert it again.")
    paths = names_of(task.target, [person for person, _ in made.files])
    files = [(path, content) for path, (_, content) in zip(paths, made.files, strict=True)]
    there = [holds(path, content) for path, content in files]
    ours = [_is_ours(path, order, task, held=held) for path, held in zip(paths, there, strict=True)]
    entry = facts(
        **read,
        parameters=parameters,
        written={
            path.relative_to(order.folder).as_posix(): hashlib.sha256(content).hexdigest()
            for path, content in files
        },
        told={
            "frames": made.frames,
            "rate": made.rate,
            "window": made.window,
            "skeleton": bool(made.skeleton),
            "changes": [change._asdict() for change in made.changes],
            "warnings": list(made.warnings),
        },
    )
    if order.noted:
        plan(order.folder, task.target, task.given.path, entry, before=task.entry)
    for (path, content), held, replace in zip(files, there, ours, strict=True):
        if not held:
            write_whole(path, content, replace=replace)
    return Told(entry, skipped=all(there))


def _checksums(order: Order, task: Task) -> dict[str, str]:
    """What tells one content of the input from another, and of what is read with it: an AMC's skeleton, say."""
    from leitmotion.io.companions import others_read

    others = checksum_of_all(others_read(task.given.path, order.reading.get("skeleton")))
    try:
        return {"sha256": task.given.sha256(), "others": others}
    except OSError:  # which reading it puts in a sentence
        return {"sha256": "", "others": others}


def _is_ours(path: Path, order: Order, task: Task, *, held: bool) -> bool:
    """Tell whether what is at a place may be replaced; refuse one that is not for this input."""
    from leitmotion.conversion import is_same
    from leitmotion.motion.errors import DataError

    if identity(path) in order.inputs or is_same(path, task.given.path):
        raise DataError(
            f"{path} is an input, and inputs are never written over.", remedy="Choose another -o."
        )
    if _of_another(path, order, task):
        raise DataError(
            f"{path} is what another input becomes.", remedy="Convert the two into different folders."
        )
    if held or order.force:
        return True
    if not path.exists():
        return False
    ours = {} if task.entry is None else task.entry["written"]
    if checksum(path) != ours.get(path.relative_to(order.folder).as_posix()):
        raise DataError(f"{path} is there with other content.", remedy="Replace it with --force.")
    return True


def _of_another(path: Path, order: Order, task: Task) -> bool:
    """Whether a person's file is what another input becomes, or would be one of its people.

    A name ``a.b.c.npz`` is of ``a.b.npz`` rather than of ``a.npz`` where both are written, whichever comes first.
    """
    own = len(task.target.stem)
    ends = [k for k, mark in enumerate(path.name) if mark == "." and k > own]
    return any(identity(path.with_name(path.name[:k] + path.suffix)) in order.targets for k in ends)
