"""Which recordings an argument means: a file, a folder or an archive, a window of these, or standard input."""

from __future__ import annotations

import contextlib
import os
import sys
import tempfile
from collections.abc import Collection, Iterator, Sequence, Set
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import IO, TYPE_CHECKING

if TYPE_CHECKING:
    from leitmotion.motion import LeitmotionError

MOST_PIPED = 4 << 30
"""Bytes that are taken from standard input at most."""


@dataclass(frozen=True)
class Input:
    """One recording that a command is to look at.

    Parameters
    ----------
    shown : str
        What it is called in every answer: the path as typed or found, with its window; ``-`` for standard input.
    path : Path
        Where its bytes are; the address may go on inside an archive.
    window : str
        The window as typed, ``"[12s:45s]"``, or nothing.
    doubtful : bool
        Whether it was found in a folder and may be no recording at all.
    fault : LeitmotionError or None
        Why there is nothing to look at, known before reading.
    folder : str
        The folder or the archive that was named, where it was found in one.
    """

    shown: str
    path: Path
    window: str = ""
    doubtful: bool = False
    fault: LeitmotionError | None = None
    folder: str = ""

    @property
    def source(self) -> str:
        """What a reader takes: the path with its window."""
        return f"{self.path}{self.window}"

    @property
    def name(self) -> str:
        """What a file made from it is called, without ending."""
        from leitmotion.io.companions import clip_name
        from leitmotion.io.containers import bare

        return "stdin" if self.shown == "-" else clip_name(self.path) or bare(self.path).stem

    def sha256(self) -> str:
        """Return the checksum of the file on the disk, packed as it is, in hexadecimal; of all frames of a clip."""
        from leitmotion.io.companions import clip_files
        from leitmotion.io.containers import on_disk
        from leitmotion.io.files import checksum

        file = on_disk(self.path)
        if file != self.path:
            facts = file.stat()
            return _of_archive(file, (facts.st_ino, facts.st_size, facts.st_mtime_ns, facts.st_ctime_ns))
        return checksum(*clip_files(file))


@lru_cache(maxsize=16)
def _of_archive(file: Path, facts: tuple[int, ...]) -> str:
    """The checksum of an archive, taken once for all of its members while nothing about it changes."""
    from leitmotion.io.files import checksum

    return checksum(file)


@contextlib.contextmanager
def expand(
    arguments: Sequence[str], extensions: Sequence[str], *, apart: Collection[Path] = ()
) -> Iterator[list[Input]]:
    """Say which recordings the arguments of a command line mean, in the order given.

    Parameters
    ----------
    arguments : sequence of str
        Files, folders and archives (searched through, their files in alphabetical order), each with a window or
        without, or ``-``. Files that hold one recording together are one input, which one of them stands for.
    extensions : sequence of str
        The endings that a recording may have, lower case with the dot; what a folder is searched for.
    apart : collection of Path
        Files and folders that the search of a folder passes over.

    Yields
    ------
    list of Input
        One per recording. A folder without recordings is one input with a fault, so that it stands in the answer.
        A temporary copy of standard input lives as long as the context.
    """
    from leitmotion.io.containers import is_archive
    from leitmotion.io.sources import split_window

    with contextlib.ExitStack() as stack:
        inputs: list[Input] = []
        for argument in arguments:
            path, ends = split_window(argument)
            window = "" if ends is None else f"[{ends[0]}:{ends[1]}]"
            if str(path) == "-":
                path = stack.enter_context(_standard_input())
                held = _in_archive(path, window, argument) if is_archive(path) else []
                inputs += held if len(held) > 1 else [Input(argument, path, window)]
            elif is_archive(path):
                inputs += _in_archive(path, window, argument)
            elif os.path.isdir(path):
                inputs += _in_folder(path, window, argument, extensions, {each.resolve() for each in apart})
            else:
                inputs.append(Input(argument, path, window, fault=_missing(path)))
        yield inputs


def _in_folder(
    folder: Path, window: str, argument: str, extensions: Sequence[str], apart: Set[Path]
) -> list[Input]:
    from leitmotion.io.companions import clips_in, represented
    from leitmotion.io.containers import bare, is_called_archive, is_doubtful
    from leitmotion.motion import DataError

    unreadable: list[OSError] = []
    found: list[Path] = []
    for where, folders, names in os.walk(folder, onerror=unreadable.append):
        here = Path(where)
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") and not _is_among(here / name, apart)
        )
        found += [
            here / name
            for name in sorted(names)
            if not name.startswith(".")
            and (bare(Path(name)).suffix.lower() in extensions or is_called_archive(Path(name)))
            and not _is_among(here / name, apart)
        ]
    others = represented(found)
    found = [path for path in found if path not in others]
    if len(found) == 1 and found[0].parent == folder and clips_in([found[0].name]):
        return [Input(argument, found[0], window)]  # the folder is one recording, a file a frame
    inputs: list[Input] = []
    for path in found:
        if is_called_archive(path):
            held = _in_archive(path, window, f"{path}{window}")
            inputs += [replace(one, folder=str(folder)) for one in held if one.fault is None]
        else:
            shown = f"{path}{window}"
            inputs.append(Input(shown, path, window, doubtful=is_doubtful(path), folder=str(folder)))
    for error in unreadable:
        closed = Path(os.fsdecode(error.filename))
        inputs.append(Input(str(closed), closed, fault=DataError(f"{closed}: {error.strerror}.")))
    if not inputs:
        looked_for = ", ".join(sorted(extensions))
        fault = DataError(
            f"{argument} holds no recordings.",
            remedy=f"It was searched through for files ending in {looked_for}.",
        )
        inputs.append(Input(argument, folder, window, fault=fault))
    return inputs


def _in_archive(file: Path, window: str, argument: str) -> list[Input]:
    """Stand an archive for its recordings, as a folder does."""
    from leitmotion.io.containers import is_doubtful, nothing_in, recordings_in
    from leitmotion.motion import LeitmotionError

    try:
        found = recordings_in(file)
    except LeitmotionError as fault:
        return [Input(argument, file, window, fault=fault)]
    if len(found) == 1:
        return [Input(argument, found[0], window)]
    called = Path("-") if argument.startswith("-") else file
    inputs = [
        Input(
            f"{called / path.relative_to(file)}{window}",
            path,
            window,
            doubtful=is_doubtful(path),
            folder=str(file),
        )
        for path in found
    ]
    return inputs or [Input(argument, file, window, fault=nothing_in(file))]


def _missing(path: Path) -> LeitmotionError | None:
    """Why there is nothing to look at, where nothing is there; all else is for the reader to say."""
    from leitmotion.io.files import missing

    try:
        os.lstat(path)
    except FileNotFoundError:
        return missing(path)
    except (OSError, ValueError):
        return None
    return None


def _is_among(path: Path, apart: Set[Path]) -> bool:
    return bool(apart) and path.resolve() in apart


@contextlib.contextmanager
def _standard_input() -> Iterator[Path]:
    """Keep a copy of standard input as a file without ending: its format is told by how it begins."""
    with tempfile.TemporaryDirectory(prefix="leitmotion-") as folder:
        copy = Path(folder) / "stdin"
        with copy.open("wb") as file:
            _copy(sys.stdin.buffer, file)
        yield copy


def _copy(stream: IO[bytes], file: IO[bytes]) -> None:
    from leitmotion.motion import FormatError

    while piece := stream.read(1 << 20):
        if file.tell() > MOST_PIPED:
            raise FormatError(f"Standard input goes on beyond {MOST_PIPED / 1e9:.1f} GB, and was not read.")
        file.write(piece)
