"""Recordings within other files: compressed by gzip, bzip2 or xz, and members of zip and tar archives.

An *address* is a path that may go on inside an archive, ``pack.zip/inner/clip.bvh``. What is packed is told by how it
begins, and not unpacked beside itself. How large it becomes is counted while it is unpacked: what a header promises may
be false.
"""

from __future__ import annotations

import difflib
import os
import struct
import zipfile
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from leitmotion.io import compression, tape
from leitmotion.io.companions import represented
from leitmotion.io.files import read_bytes
from leitmotion.io.formats import DOUBTFUL, EXTENSIONS, readable
from leitmotion.motion import DataError, FormatError
from leitmotion.motion.errors import in_short

_ZIP = b"PK\x03\x04"

_DAMAGE = (zipfile.BadZipFile, struct.error, *compression.DAMAGE, *tape.DAMAGE)
"""What the standard library raises of what is damaged."""


def read_file(path: Path) -> tuple[Path, bytes]:
    """Read the file at an address, unpacked.

    Parameters
    ----------
    path : Path
        A file, or an address in an archive. The archive itself stands for the one recording in it.

    Returns
    -------
    tuple of Path and bytes
        The address without the ending of a compression, and the content.

    Raises
    ------
    FormatError
        When it is missing, damaged, encrypted or grows beyond reason.
    DataError
        When it is an archive of no recording or of several; the sentence lists them.
    """
    file, inside = _split(path)
    if not inside and is_archive(file):
        path = _the_one(file)
        inside = path.relative_to(file).as_posix()
    content = _member(file, inside) if inside else read_bytes(file)
    name = bare(path)
    if name.suffix.lower() not in tape.ENDINGS:
        content = _unpacked(path, content)
    if _looks_packed(name, content[:256]):
        raise FormatError(
            f"{path.name} holds an archive within an archive.", remedy="Unpack the outer one first."
        )
    if not content.strip():
        raise FormatError(f"{path.name} is empty.", remedy="Was it copied or downloaded completely?")
    return name, content


def bare(path: Path) -> Path:
    """Take the ending of a compression off: ``dance.bvh.gz`` is a ``dance.bvh``.

    Examples
    --------
    >>> bare(Path("dance.bvh.gz")).name, bare(Path("dance.bvh")).name
    ('dance.bvh', 'dance.bvh')
    """
    return path.with_suffix("") if path.suffix.lower() in compression.ENDINGS else path


def on_disk(path: Path) -> Path:
    """Tell which file of the disk holds what is at an address."""
    return _split(path)[0]


def exists(path: Path) -> bool:
    """Whether a file, a folder or a member of an archive is at an address."""
    return os.path.exists(path) or (_split(path)[1] != "" and path in listing(path.parent))


def listing(folder: Path) -> list[Path]:
    """List the files in a folder, or in a folder of an archive; none where there is no such folder."""
    file, _ = _split(folder)
    try:
        if os.path.isfile(file):
            with _archive(file) as archive:
                return list(archive.folders.get(folder, ()))
        return [Path(entry.path) for entry in os.scandir(folder)]
    except (OSError, ValueError):
        return []


def is_archive(path: Path) -> bool:
    """Whether a file is an archive that stands for the recordings in it, as a folder does."""
    if not os.path.isfile(path):
        return False
    if is_called_archive(path):
        return True
    try:
        with path.open("rb") as file:
            if _looks_packed(path, file.read(256)):
                return True
        return not _is_known(bare(path)) and tape.is_tape(path)
    except OSError:
        return False


def is_called_archive(path: Path) -> bool:
    """Whether a file is an archive by its name.

    Examples
    --------
    >>> [is_called_archive(Path(name)) for name in ("a.zip", "a.tar.xz", "a.tgz", "a.bvh.gz")]
    [True, True, True, False]
    """
    return path.suffix.lower() == ".zip" or bare(path).suffix.lower() in tape.ENDINGS


def archive_name(path: Path) -> str:
    """Name an archive without its ending: ``pack.tar.xz`` is called ``pack``."""
    return bare(path).stem


def recordings_in(file: Path) -> list[Path]:
    """List the addresses of the recordings in an archive, in the order in which a folder lists its files.

    Parameters
    ----------
    file : Path
        The archive.

    Returns
    -------
    list of Path
        The members whose ending is one that is read, or the only member there is; of those that are one recording
        together, the one that stands for it.

    Raises
    ------
    FormatError
        When it is damaged, or a member's name leads out of it.
    """
    names = _members(file)
    endings = set(readable())
    found = [name for name in names if bare(Path(name)).suffix.lower() in endings]
    if not found and len(names) == 1:
        found = list(names)
    paths = [file / name for name in sorted(found, key=lambda name: _order(PurePosixPath(name)))]
    others = represented(paths)
    return [path for path in paths if path not in others]


def is_doubtful(path: Path) -> bool:
    """Whether a file that was found somewhere may, by its ending, be something else than a recording."""
    return bare(path).suffix.lower() in DOUBTFUL


def nothing_in(file: Path) -> DataError:
    """Make the error that says that an archive holds no recordings, and what it does hold."""
    endings = sorted({Path(name).suffix.lower() for name in _members(file)} - {""})
    held = f", but files ending in {in_short(endings)}" if endings else ""
    return DataError(
        f"{file.name} holds no recordings{held}.",
        remedy=f"It was searched for files ending in {', '.join(readable())}.",
    )


def _split(path: Path) -> tuple[Path, str]:
    """The file of the disk, and the place within it where the address goes on."""
    for parent in path.parents:
        if os.path.isfile(parent):
            return parent, path.relative_to(parent).as_posix()
        if os.path.isdir(parent):
            break
    return path, ""


def _is_known(path: Path) -> bool:
    return path.suffix.lower() in EXTENSIONS


def _looks_packed(path: Path, head: bytes) -> bool:
    """Whether a file is an archive and none of the formats that are zip archives themselves, as ``.npz`` is."""
    if not head.startswith(_ZIP) or _is_known(path):
        return False
    (length,) = struct.unpack_from("<H", head.ljust(30, b"\0"), 26)
    return not head[30 : 30 + length].endswith(b".npy")


def _order(path: PurePosixPath) -> tuple[tuple[bool, str], ...]:
    """Files of a folder before its folders, both in alphabetical order."""
    return *((True, part) for part in path.parts[:-1]), (False, path.name)


def _the_one(file: Path) -> Path:
    found = recordings_in(file)
    sure = [path for path in found if not is_doubtful(path)]
    if len(found) == 1 or len(sure) == 1:
        return (found if len(found) == 1 else sure)[0]
    names = [path.relative_to(file).as_posix() for path in sure or found]
    if not names:
        raise nothing_in(file)
    raise DataError(
        f"{file.name} holds {len(names)} recordings: {in_short(names)}.",
        remedy=f"Name one of them, such as {file / names[0]}.",
    )


class _Archive(NamedTuple):
    """An open archive, and the files in it by name."""

    read: Callable[[str], bytes]
    """Unpacks one of them."""
    members: Collection[str]
    folders: dict[Path, list[Path]]
    """The addresses of the files in each folder."""


@lru_cache(
    maxsize=4
)  # the frames of a clip may be thousands of members, and pairs are often of several archives
def _opened(file: Path, _version: tuple[int, ...]) -> _Archive:
    with file.open("rb") as opened:
        zipped = opened.read(4) == _ZIP or file.suffix.lower() == ".zip"
    if zipped:
        box = zipfile.ZipFile(file)
        infos = {info.filename.replace("\\", "/"): info for info in box.infolist()}
        names, read = list(infos), lambda name: _of_zip(box, infos[name], file)
    else:
        held = tape.open_tape(file)
        names, read = list(held.members), held.read
    for name in names:
        if name.startswith("/") or ".." in name.split("/") or "\0" in name:
            raise FormatError(
                f"{file.name} names a file outside itself, {name!r}, and was not read.",
                remedy="Get it from somewhere else.",
            )
    members = dict.fromkeys(name for name in names if not _is_junk(name))
    folders: dict[Path, list[Path]] = {}
    for name in members:
        folders.setdefault((file / name).parent, []).append(file / name)
    return _Archive(read, members, folders)


@contextmanager
def _archive(file: Path) -> Iterator[_Archive]:
    """The archive, opened once for as long as the file and the process stay the same."""
    try:
        facts = os.stat(file)
        yield _opened(file, (facts.st_ino, facts.st_size, facts.st_mtime_ns, os.getpid()))
    except FormatError:
        raise
    except NotImplementedError as error:
        raise FormatError(
            f"{file.name} is packed in a way that is not read: {error}.", remedy="Unpack it first."
        ) from None
    except (*_DAMAGE, RuntimeError) as error:
        kind = "tar" if bare(file).suffix.lower() in tape.ENDINGS else "zip"
        raise FormatError(
            f"{file.name} is no {kind} archive or is damaged: {error}.",
            remedy="Was it copied or downloaded completely?",
        ) from None


def _is_junk(name: str) -> bool:
    """Whether a member is a folder, or what the system that packed the archive left there for itself."""
    return name.endswith("/") or any(
        part.startswith(".") or part in ("", "__MACOSX") for part in name.split("/")
    )


def _members(file: Path) -> Collection[str]:
    with _archive(file) as archive:
        return archive.members


def _member(file: Path, inside: str) -> bytes:
    if not is_archive(file):
        raise FormatError(
            f"There is no file {file / inside}: {file.name} is a file, not a folder, and no archive.",
            remedy="Unpack it into a folder of that name, or name a file that is there.",
        )
    members = _members(file)
    if inside not in members:
        near = difflib.get_close_matches(inside, list(members), n=3, cutoff=0.5)
        raise FormatError(
            f"There is no {inside} in {file}.", remedy=f"Did you mean {' or '.join(near)}?" if near else ""
        )
    with _archive(file) as archive:
        return archive.read(inside)


def _of_zip(box: zipfile.ZipFile, info: zipfile.ZipInfo, file: Path) -> bytes:
    name = info.filename
    if info.flag_bits & 1:
        raise FormatError(f"{name} in {file.name} is encrypted.", remedy="Unpack it first.")
    with box.open(info) as stream:
        parts = compression.pieces_of(stream.read)
        content = b"".join(compression.bounded(parts, info.compress_size, name))
    if len(content) != info.file_size:
        raise zipfile.BadZipFile(f"{name} states {info.file_size} bytes and has {len(content)}")
    return content


def _unpacked(path: Path, content: bytes) -> bytes:
    """Undo a compression, if there is one."""
    try:
        return b"".join(compression.bounded(compression.pieces(content), len(content), path.name))
    except FormatError:
        raise
    except compression.DAMAGE as error:
        raise FormatError(
            f"{path.name} is damaged where it is compressed: {error}.",
            remedy="Was it copied or downloaded completely?",
        ) from None
