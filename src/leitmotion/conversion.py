"""From one format to another: read, resampled where asked, made anew, and compared with what was read.

A conversion is two steps: :func:`prepare` makes the bytes and tells what the format does not keep; :func:`convert`
writes them as well, and never over an input or over what something else wrote.
"""

from __future__ import annotations

import os
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

from leitmotion.body import BodyMap
from leitmotion.inspection import misread
from leitmotion.io import open_recording, write_whole
from leitmotion.io.containers import on_disk
from leitmotion.io.fidelity import Loss, losses
from leitmotion.io.files import holds
from leitmotion.io.formats import Format, writable
from leitmotion.io.sources import split_window
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, resample

Roles = BodyMap | Mapping[str, str | list[str]]


@dataclass(frozen=True)
class Prepared:
    """What a recording is in another format, before it is written."""

    files: tuple[tuple[str, bytes], ...]
    """A file's content for each person, with the person's name where there are several."""

    changes: tuple[Loss, ...]
    """What the format does not keep, and what was changed on the way."""

    warnings: tuple[str, ...]
    """What is odd about the source."""

    frames: int
    """How many frames were read."""

    rate: float
    """How many of them make a second."""

    window: tuple[int, int] | None = None
    """Which frames of the source these are, None for all."""

    skeleton: str = ""
    """The other file from which the skeleton came."""


@dataclass(frozen=True)
class Converted:
    """What became of a recording in another format."""

    written: tuple[Path, ...]
    """The files, one a person."""

    changes: tuple[Loss, ...]
    """What the format does not keep, and what was changed on the way."""

    warnings: tuple[str, ...]
    """What is odd about the source."""


def convert(
    source: str | PathLike[str], path: str | PathLike[str], *, force: bool = False, **options: Any
) -> Converted:
    """Convert a file to another format, which the extension of the new one names.

    Parameters
    ----------
    source : str or path
        A file, or a file and a window: ``"clip.bvh[2s:5s]"``.
    path : str or path
        The file to write; of several people one each: ``clip.c3d`` becomes ``clip.ANNA.c3d``, ``clip.BEN.c3d``.
    force : bool
        Whether a file of other content that is there may be replaced. The source never is.
    **options
        As for :func:`prepare`: `skeleton`, `unit`, `up`, `rate`, `person`, `trust` and `body_map` say how to read,
        `fps` and `out_unit` how to write.

    Returns
    -------
    Converted
        The files, what the format does not keep, and what is odd about the source.

    Raises
    ------
    FormatError
        When the source is not what its format says, or the new file cannot be written.
    DataError
        When a file of other content is there.
    ParameterError
        When the format does not hold such a recording, or an option is unknown.

    Examples
    --------
    >>> import leitmotion as lm
    >>> lm.write(lm.compose_session(rate=30).motion, "dance.bvh")
    PosixPath('dance.bvh')
    >>> made = lm.convert("dance.bvh", "slow.bvh", fps=10, out_unit="m")
    >>> made.written, made.changes[0].detail
    ((PosixPath('slow.bvh'),), 'Resampled from 30 Hz to 10 Hz.')
    """
    path = Path(path)
    prepared = prepare(source, path.suffix, **options)
    targets = names_of(path, [person for person, _ in prepared.files])
    named = [(target, content) for target, (_, content) in zip(targets, prepared.files, strict=True)]
    for target, content in named:
        if is_same(target, split_window(source)[0]):
            raise ParameterError(f"{target} is the input, and inputs are never written over.")
        refuse_other(target, content, force=force)
    written = tuple(put(target, content, force=force) for target, content in named)
    return Converted(written, prepared.changes, prepared.warnings)


def prepare(
    source: str | PathLike[str],
    extension: str,
    *,
    skeleton: str | PathLike[str] | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    rate: float | None = None,
    person: str | int | None = None,
    trust: bool = False,
    body_map: Roles | None = None,
    fps: float | None = None,
    out_unit: str | float | None = None,
) -> Prepared:
    """Make what a file is in another format, without writing it.

    Parameters
    ----------
    source : str or path
        A file, or a file and a window.
    extension : str
        The format, by its extension: ``".bvh"``.
    skeleton, unit, up, rate, person, trust
        How to read, as for :func:`leitmotion.read`; of several people each is converted unless `person` chooses.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, by which size and vertical are looked at for a misreading.
    fps : float, optional
        Frames per second to write; else those of the source.
    out_unit : str or float, optional
        Unit of length to write, for formats that leave it open; else the format's usual one.

    Returns
    -------
    Prepared
        The content of the files, what the format does not keep, and what is odd about the source.

    Raises
    ------
    FormatError
        When the source is not what its format says.
    ParameterError
        When the extension is not written, or the format does not hold such a recording.
    """
    extension = f".{extension.removeprefix('.').lower()}"
    form_of(extension)  # refused before anything is read
    options: dict[str, Any] = {} if out_unit is None else {"unit": out_unit}
    reading = open_recording(
        source, skeleton=skeleton, unit=unit, up=up, rate=rate, person=person, trust=trust
    )
    files, warnings = [], list(reading.warnings)
    changes: dict[Loss, None] = {}  # of several people each is told once
    for who, recording in zip(reading.people, reading.recordings, strict=True):
        warnings += misread(recording, reading.findings, body_map)
        wanted = recording if fps is None else resample(recording, fps)
        content, lost = written_as(wanted, extension, **options)
        changes |= dict.fromkeys((*_resampled(recording, wanted), *lost))
        files.append((who if len(reading.people) > 1 else "", content))
    first = reading.recordings[0]
    beside = reading.findings.get("skeleton")
    return Prepared(
        files=tuple(files),
        changes=tuple(changes),
        warnings=tuple(dict.fromkeys(warnings)),
        frames=len(first),
        rate=first.rate,
        window=reading.window,
        skeleton="" if beside is None else str(beside.value),
    )


def written_as(
    recording: Motion | Trajectories, extension: str, **options: Any
) -> tuple[bytes, tuple[Loss, ...]]:
    """Make the bytes of a recording in a format, and tell what they do not keep of it."""
    form = form_of(extension)
    content = form.write(recording, **options)
    unit = options.get("unit", form.options.get("unit"))
    return content, losses(recording, content, extension, unit=unit)


def refuse_other(path: Path, content: bytes, *, force: bool, by: str = "force=True") -> None:
    """Refuse to write over a file of other content, unless by force."""
    if not force and os.path.lexists(path) and not holds(path, content):
        raise DataError(f"{path} is there with other content.", remedy=f"Replace it with {by}.")


def put(path: Path, content: bytes, *, force: bool) -> Path:
    """Write a file that :func:`refuse_other` let pass; one of the same content is left alone."""
    return path if holds(path, content) else write_whole(path, content, replace=force)


def form_of(extension: str) -> Format:
    """Tell the format that an extension names.

    Parameters
    ----------
    extension : str
        In lower case, with the dot: ``".bvh"``.

    Returns
    -------
    Format
        One that is written.

    Raises
    ------
    ParameterError
        When no format that is written has it.
    """
    forms = writable()
    form = forms.get(extension)
    if form is None:
        raise ParameterError(
            f"Recordings are written as {', '.join(forms)}, got {extension!r}.",
            remedy="Choose one of these extensions.",
        )
    return form


def names_of(path: Path, people: Sequence[str]) -> list[Path]:
    """Name the file of each of several people, no two alike; of a single one it is the path itself.

    Names that are alike once they are safe, or where capitals are small letters, are numbered.

    Examples
    --------
    >>> [each.name for each in names_of(Path("duo.c3d"), ["Anna: lead", "Anna? lead"])]
    ['duo.Anna_ lead.c3d', 'duo.Anna_ lead-2.c3d']
    """
    named: list[Path] = []
    taken: set[str] = set()
    for person in people:
        own = name_of(path, person)
        one, count = own, 1
        while (key := unicodedata.normalize("NFC", one.name).casefold()) in taken:
            count += 1
            one = own.with_name(f"{own.stem}-{count}{own.suffix}")
        taken.add(key)
        named.append(one)
    return named


def name_of(path: Path, person: str) -> Path:
    """Name the file of one of several people; of a single one it is the path itself.

    Examples
    --------
    >>> name_of(Path("duo.c3d"), "Anna: lead").name
    'duo.Anna_ lead.c3d'
    """
    if not person:
        return path
    spoken = unicodedata.normalize("NFC", person)
    safe = "".join(mark if mark.isprintable() and mark not in '<>:"/\\|?*' else "_" for mark in spoken)
    return path.with_name(f"{path.stem}.{safe.strip(' .') or '_'}{path.suffix}")


def is_same(target: Path, source: Path) -> bool:
    """Tell whether a place to write to is the file, or the archive, that is read."""
    source = on_disk(source)
    return target.exists() and source.exists() and target.samefile(source)


def _resampled(before: Motion | Trajectories, after: Motion | Trajectories) -> tuple[Loss, ...]:
    if before.rate == after.rate:
        return ()
    how = f"Resampled from {before.rate:.9g} Hz to {after.rate:.9g} Hz."
    return (Loss("rate", "", len(after), how),)
