"""The files in a tar archive, plain or compressed by gzip, bzip2 or xz.

A compressed one is solid: its last file is known only once all before it are unpacked. So it is unpacked once, into
memory, or where it is large into a file without a name that is gone with the process, and read there from then on.
"""

from __future__ import annotations

import tarfile
import tempfile
from pathlib import Path
from typing import IO

from leitmotion.io.compression import FIRST, beginning, bounded, is_compressed, pieces
from leitmotion.io.files import read_bytes

ENDINGS = (".tar", ".tgz", ".tbz2", ".txz")
"""Endings that a tar archive may have once that of a compression is taken off."""
DAMAGE = (tarfile.TarError, EOFError, OSError, ValueError, OverflowError)
"""What the standard library raises of what is damaged."""

_IN_MEMORY = 64 << 20  # bytes that are kept in memory
_MARK = slice(257, 262)


class Tape:
    """A tar archive, unpacked; what it is read from is closed when nobody holds it any more."""

    def __init__(self, file: IO[bytes]) -> None:
        self.file = file
        self.members: dict[str, tuple[int, int]] = {}
        """Where each file begins and how many bytes it has, by its name."""

    def __del__(self) -> None:
        self.file.close()

    def read(self, name: str) -> bytes:
        """Read a file."""
        start, size = self.members[name]
        self.file.seek(start)
        content = self.file.read(size)
        if len(content) != size:
            raise EOFError("it ends too early")
        return content


def is_tape(path: Path) -> bool:
    """Whether a file begins as a tar archive does, compressed or not."""
    with path.open("rb") as file:
        head = file.read(_MARK.stop)
        if is_compressed(head):
            head = beginning(head + file.read(FIRST), _MARK.stop)
    return head[_MARK] == b"ustar"


def open_tape(path: Path) -> Tape:
    """Unpack a tar archive and list its files; links, devices and folders are none.

    Raises
    ------
    FormatError
        When it unpacks to more than such an archive does.
    Exception
        One of :data:`DAMAGE`, of the decompressors' or a RecursionError, when it is damaged.
    """
    held = Tape(path.open("rb"))
    if is_compressed(held.file.read(8)):
        content = read_bytes(path)
        held = Tape(tempfile.SpooledTemporaryFile(max_size=_IN_MEMORY))  # noqa: SIM115
        for piece in bounded(pieces(content), len(content), path.name):
            held.file.write(piece)
    held.file.seek(0)
    last = -1
    with tarfile.open(fileobj=held.file, mode="r:") as box:
        for info in box:
            if info.offset <= last or info.size < 0:  # a size below 0 leads back, for ever
                raise tarfile.ReadError("its headers contradict each other")
            last = info.offset
            if info.type in (tarfile.REGTYPE, tarfile.AREGTYPE):
                held.members[info.name.removeprefix("./")] = (info.offset_data, info.size)
    return held
