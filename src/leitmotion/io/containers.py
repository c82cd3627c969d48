"""Recordings within other files: compressed by gzip, bzip2 or xz, and members of zip archives.

An *address* is a path that may go on inside a zip archive, ``pack.zip/inner/clip.bvh``. What is packed is told by how
it begins, not by its name, and never unpacked to the disk. How large it becomes is counted while it is unpacked: what a
header promises may be false.
"""

from __future__ import annotations

import bz2
import difflib
import gzip
import io
import lzma
import os
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from leitmotion.io.companions import represented
from leitmotion.io.files import LARGEST, read_bytes
from leitmotion.io.formats import DOUBTFUL, EXTENSIONS, readable
from leitmotion.motion import DataError, FormatError

_COMPRESSED = (".gz", ".bz2", ".xz")
_TAPES = (".tar", ".tgz", ".tbz2", ".txz")  # not read, and not unpacked in order to say so
_ZIP = b"PK\x03\x04"
_PIECE = 1 << 20
_ROOM = 64 << 20  # bytes to which anything may unpack
_GROWTH = 25  # by how much it may grow beyond; a text of numbers grows three to tenfold
_DICTIONARY = 256 << 20  # bytes that xz may take for itself
_NAMED = 8  # recordings that a sentence names

_DAMAGE = (
    zipfile.BadZipFile,
    gzip.BadGzipFile,
    zlib.error,
    lzma.LZMAError,
    EOFError,
    OSError,
    ValueError,
    struct.error,
)
"""What the standard library raises of what is damaged."""


def read_file(path: Path) -> tuple[Path, bytes]:
    """Read the file at an address, unpacked.

    Parameters
    ----------
    path : Path
        A file, or an address in a zip archive. The archive itself stands for the one recording in it.

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
    if name.suffix.lower() not in _TAPES:
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
    return path.with_suffix("") if path.suffix.lower() in _COMPRESSED else path


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
    """Whether a file is a zip archive that stands for the recordings in it, as a folder does."""
    if not os.path.isfile(path):
        return False
    if path.suffix.lower() == ".zip":
        return True
    try:
        with path.open("rb") as file:
            return _looks_packed(path, file.read(256))
    except OSError:
        return False


def recordings_in(file: Path) -> list[Path]:
    """List the addresses of the recordings in a zip archive, in the order in which a folder lists its files.

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
    """Make the error that says that a zip archive holds no recordings, and what it does hold."""
    endings = sorted({Path(name).suffix.lower() for name in _members(file)} - {""})
    held = f", but files ending in {', '.join(endings[:_NAMED])}" if endings else ""
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
    """Whether a file is a zip archive and none of the formats that are zip archives themselves, as ``.npz`` is."""
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
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    raise DataError(
        f"{file.name} holds {len(names)} recordings: {', '.join(names[:_NAMED])}{more}.",
        remedy=f"Name one of them, such as {file / names[0]}.",
    )


class _Archive(NamedTuple):
    """An open zip archive, and the files in it by name."""

    box: zipfile.ZipFile
    members: dict[str, zipfile.ZipInfo]
    folders: dict[Path, list[Path]]
    """The addresses of the files in each folder."""


@lru_cache(maxsize=1)  # the frames of a clip may be thousands of members, and all are named in one place
def _opened(file: Path, _version: tuple[int, ...]) -> _Archive:
    box = zipfile.ZipFile(file)
    members = {info.filename.replace("\\", "/"): info for info in box.infolist()}
    for name in members:
        if name.startswith("/") or ".." in name.split("/") or "\0" in name:
            box.close()
            raise FormatError(
                f"{file.name} names a file outside itself, {name!r}, and was not read.",
                remedy="Get it from somewhere else.",
            )
    held = {name: info for name, info in members.items() if not _is_junk(name)}
    folders: dict[Path, list[Path]] = {}
    for name in held:
        folders.setdefault((file / name).parent, []).append(file / name)
    return _Archive(box, held, folders)


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
        raise FormatError(
            f"{file.name} is no zip archive or is damaged: {error}.",
            remedy="Was it copied or downloaded completely?",
        ) from None


def _is_junk(name: str) -> bool:
    """Whether a member is a folder, or what the system that packed the archive left there for itself."""
    return name.endswith("/") or any(
        part.startswith(".") or part in ("", "__MACOSX") for part in name.split("/")
    )


def _members(file: Path) -> dict[str, zipfile.ZipInfo]:
    with _archive(file) as archive:
        return archive.members


def _member(file: Path, inside: str) -> bytes:
    if not is_archive(file):
        raise FormatError(
            f"There is no file {file / inside}: {file.name} is a file, not a folder, and no zip archive.",
            remedy="Unpack it into a folder of that name, or name a file that is there.",
        )
    members = _members(file)
    info = members.get(inside)
    if info is None:
        near = difflib.get_close_matches(inside, list(members), n=3, cutoff=0.5)
        raise FormatError(
            f"There is no {inside} in {file}.", remedy=f"Did you mean {' or '.join(near)}?" if near else ""
        )
    if info.flag_bits & 1:
        raise FormatError(f"{inside} in {file.name} is encrypted.", remedy="Unpack it first.")
    with _archive(file) as archive, archive.box.open(info) as stream:
        content = _joined(_pieces(stream.read), info.compress_size, inside)
        if len(content) != info.file_size:
            raise zipfile.BadZipFile(f"{inside} states {info.file_size} bytes and has {len(content)}")
        return content


def _unpacked(path: Path, content: bytes) -> bytes:
    """Undo a compression, if there is one."""
    for mark, undo in _UNDO.items():
        if content.startswith(mark):
            try:
                return _joined(undo(content), len(content), path.name)
            except FormatError:
                raise
            except _DAMAGE as error:
                raise FormatError(
                    f"{path.name} is damaged where it is compressed: {error}.",
                    remedy="Was it copied or downloaded completely?",
                ) from None
    return content


def _joined(pieces: Iterator[bytes], packed: int, name: str) -> bytes:
    """Put the pieces together, unless they become more than a recording packed so small ever does."""
    most = min(_ROOM + _GROWTH * packed, LARGEST)
    kept, size = [], 0
    for piece in pieces:
        kept.append(piece)
        size += len(piece)
        if size > most:
            raise FormatError(
                f"{name} unpacks to more than {most / 1e6:.0f} MB, and a recording packed into {packed / 1e6:.3g} MB "
                "does not.",
                remedy="Unpack it first if you trust it.",
            )
    return b"".join(kept)


def _pieces(read: Callable[[int], bytes]) -> Iterator[bytes]:
    while piece := read(_PIECE):
        yield piece


def _undo_xz(content: bytes) -> Iterator[bytes]:
    """What xz has compressed; its own files know no bound for the memory that a header asks for."""
    while content:
        undo = lzma.LZMADecompressor(memlimit=_DICTIONARY)
        yield undo.decompress(content, _PIECE)
        while not undo.eof:
            if undo.needs_input:
                raise EOFError("it ends too early")
            yield undo.decompress(b"", _PIECE)
        content = undo.unused_data.lstrip(b"\0")  # one stream may follow another


_UNDO: dict[bytes, Callable[[bytes], Iterator[bytes]]] = {
    b"\x1f\x8b": lambda content: _pieces(gzip.GzipFile(fileobj=io.BytesIO(content)).read),
    b"BZh": lambda content: _pieces(bz2.BZ2File(io.BytesIO(content)).read),
    b"\xfd7zXZ\0": _undo_xz,
}
"""What a compressed file begins with, and the pieces of what is in it."""
