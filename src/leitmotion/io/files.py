"""Bytes in and out: files that are read with a word why not, and written whole or not at all."""

from __future__ import annotations

import contextlib
import difflib
import hashlib
import os
import platform
import secrets
import stat
import zlib
from os import PathLike
from pathlib import Path

from leitmotion.motion import DataError, FormatError

_SPECIAL = "a device or a pipe"

LARGEST = 4 << 30
"""Bytes of the largest file that is read."""

_SHORT = 50  # letters of a name that a part bears: file systems take 255 bytes, and a letter has up to four


def read_bytes(path: Path) -> bytes:
    """Read a whole file, or say in one sentence why not.

    Parameters
    ----------
    path : Path
        The file.

    Returns
    -------
    bytes
        Its content.

    Raises
    ------
    FormatError
        When it is missing, a folder or a device, larger than :data:`LARGEST` or not to be read.
    """
    try:
        facts = os.stat(path)
        if stat.S_ISDIR(facts.st_mode):
            raise FormatError(f"Expected a file, {path} is a folder.", remedy="Name a recording in it.")
        if not stat.S_ISREG(facts.st_mode):
            raise FormatError(
                f"Expected a file, {path} is {_SPECIAL}.",
                remedy="What comes from a pipe is read as standard input, named -.",
            )
        if facts.st_size > LARGEST:
            raise FormatError(
                f"{path.name} is {facts.st_size / 1e9:.1f} GB, and files of up to {LARGEST / 1e9:.1f} GB are read.",
                remedy="Cut it into parts.",
            )
        return path.read_bytes()
    except FormatError:
        raise
    except (FileNotFoundError, NotADirectoryError, ValueError):  # the last of a name that no file can have
        if os.path.islink(path):
            raise FormatError(f"{path} is a link to {os.readlink(path)}, where there is no file.") from None
        raise missing(path) from None
    except PermissionError:
        raise FormatError(f"The file {path} may not be read.", remedy="Check its permissions.") from None
    except OSError as error:
        raise FormatError(f"The file {path} cannot be read: {error.strerror or error}.") from None


def missing(path: Path) -> FormatError:
    """Make the error that says that nothing is at a place, and what is called nearly so."""
    what = "file" if path.suffix else "file or folder"
    return FormatError(f"There is no {what} {path}.", remedy=_suggest(path))


def _suggest(path: Path) -> str:
    try:
        names = os.listdir(path.parent)
    except (OSError, ValueError):
        return f"There is no folder {path.parent} either."
    # the ending, which is alike for most, says nothing about how alike two names are
    stems: dict[str, list[str]] = {}
    for name in sorted(names, key=lambda name: (Path(name).suffix.lower() != path.suffix.lower(), name)):
        stems.setdefault(Path(name).stem.lower(), []).append(name)
    near = [
        stems[stem][0] for stem in difflib.get_close_matches(path.stem.lower(), list(stems), n=3, cutoff=0.7)
    ]
    return f"Did you mean {' or '.join(near)}?" if near else ""


def write_whole(path: str | PathLike[str], content: str | bytes, *, replace: bool = True) -> Path:
    """Write a file so that nobody ever sees half of it.

    The content goes to a temporary file in the same folder, is flushed to the disk and takes the name in one step; an
    interruption or a full disk leaves what was there before.

    Parameters
    ----------
    path : str or path
        The file; its folder is made where it is missing.
    content : str or bytes
        What it holds; text is written as UTF-8 with the newlines it has.
    replace : bool
        Whether it may take the place of a file that is there; else the two are told apart in one step with the
        writing, so that a file that appears meanwhile stays.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FormatError
        When the folder cannot be written to, the disk is full, or the path is a device.
    DataError
        When a file is there that may not be replaced.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_whole(pathlib.Path(folder) / "a.txt", "whole").read_text()
    'whole'
    """
    path = Path(path)
    # what no UTF-8 holds, half a character of a name, is spelled out
    data = content.encode("utf-8", "backslashreplace") if isinstance(content, str) else content
    temporary = ""
    try:
        if path.exists() and not (path.is_file() or path.is_dir()):  # which a file would take the place of
            raise FormatError(f"{path} cannot be written: it is {_SPECIAL}.", remedy="Choose another place.")
        path.parent.mkdir(parents=True, exist_ok=True)
        # not by tempfile, whose files are for their owner alone: this one gets the mode of any file that is made
        beside = path.parent / f".{path.name[:_SHORT]}.{owner(os.getpid())}-{secrets.token_hex(8)}.part"
        handle = os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
        temporary = str(beside)
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        _name(temporary, path, replace=replace)
    except FormatError:
        raise
    except (OSError, ValueError) as error:  # the latter of a name that no file can have
        _discard(temporary)
        raise FormatError(
            f"{path} cannot be written: {getattr(error, 'strerror', None) or error}.",
            remedy="Choose another place, or make room and check the permissions.",
        ) from None
    except BaseException:  # an interruption, too, leaves nothing behind
        _discard(temporary)
        raise
    return path


def discard_parts(folder: Path, process: int) -> None:
    """Remove what :func:`write_whole` left in a folder when its process was killed.

    Parameters
    ----------
    folder : Path
        Where the process wrote.
    process : int
        The number of the process, which is no more.
    """
    for left in folder.glob(f".*.{owner(process)}-*.part"):
        _discard(str(left))


def holds(path: Path, content: bytes) -> bool:
    """Tell whether a file holds exactly these bytes."""
    return path.is_file() and path.stat().st_size == len(content) and path.read_bytes() == content


def checksum(*paths: Path) -> str:
    """SHA-256 of files, one after the other, in hexadecimal.

    Raises
    ------
    OSError
        When one cannot be read.
    """
    digest = hashlib.sha256()
    for path in paths:
        with path.open("rb") as file:
            while piece := file.read(1 << 20):
                digest.update(piece)
    return digest.hexdigest()


def append_line(path: Path, line: str) -> None:
    """Add a line to the end of a text file, which is made where it is missing.

    Raises
    ------
    OSError
        When it cannot be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("a", encoding="utf-8") as file:
        file.write(f"{line}\n")


def owner(process: int) -> str:
    """A process among those of all machines that share a folder."""
    return f"{zlib.crc32(platform.node().encode()):08x}-{process}"


def _name(temporary: str, path: Path, *, replace: bool) -> None:
    """Give a file its name, in one step; where it has to be a new one and no links can be made, in two."""
    if not replace:
        with contextlib.suppress(OSError, AttributeError):
            os.link(temporary, path)
            _discard(temporary)
            return
        if os.path.lexists(path):
            raise DataError(f"{path} is there with other content.")
    os.replace(temporary, path)


def _discard(temporary: str) -> None:
    if temporary:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
