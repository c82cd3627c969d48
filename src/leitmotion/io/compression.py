"""What gzip, bzip2 and xz have compressed, undone piece by piece; how large it becomes is counted."""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import zlib
from collections.abc import Callable, Iterator

from leitmotion.io.files import LARGEST
from leitmotion.motion import FormatError

ENDINGS = (".gz", ".bz2", ".xz")
MARKS = (b"\x1f\x8b", b"BZh", b"\xfd7zXZ\0")
"""What a compressed file begins with, in the order of the endings."""
FIRST = 1 << 20
"""Bytes from which the beginning of what is compressed can be told: bzip2 gives nothing before its first block ends."""
DAMAGE = (gzip.BadGzipFile, zlib.error, lzma.LZMAError, EOFError, OSError, ValueError)
"""What the standard library raises of what is damaged."""

_PIECE = 1 << 20
_ROOM = 64 << 20  # bytes to which anything may unpack
_GROWTH = 25  # by how much it may grow beyond; a text of numbers grows three to tenfold
_DICTIONARY = 256 << 20  # bytes that xz may take for itself


def is_compressed(content: bytes) -> bool:
    """Whether a content, or its beginning, is compressed."""
    return content.startswith(MARKS)


def pieces(content: bytes) -> Iterator[bytes]:
    """Undo the compression, a megabyte at a time; a content that is not compressed is one piece.

    Raises
    ------
    Exception
        One of :data:`DAMAGE`.
    """
    undo = next((undo for mark, undo in _UNDO.items() if content.startswith(mark)), None)
    return iter((content,)) if undo is None else undo(content)


def beginning(head: bytes, length: int) -> bytes:
    """Undo as much as tells how a file begins; empty where its first :data:`FIRST` bytes do not."""
    by: dict[bytes, Callable[[], bytes]] = {
        b"\x1f\x8b": lambda: zlib.decompressobj(wbits=31).decompress(head, length),
        b"BZh": lambda: bz2.BZ2Decompressor().decompress(head, length),
        b"\xfd7zXZ\0": lambda: lzma.LZMADecompressor(memlimit=_DICTIONARY).decompress(head, length),
    }
    try:
        return next((undo() for mark, undo in by.items() if head.startswith(mark)), head[:length])
    except DAMAGE:
        return b""


def bounded(parts: Iterator[bytes], packed: int, name: str) -> Iterator[bytes]:
    """Pass the pieces on, unless they become more than recordings packed so small ever do.

    Parameters
    ----------
    parts : iterator of bytes
        What is unpacked.
    packed : int
        Bytes that it was packed into.
    name : str
        Of the file, for the sentence.

    Raises
    ------
    FormatError
        When they do.
    """
    most, size = min(_ROOM + _GROWTH * packed, LARGEST), 0
    for part in parts:
        size += len(part)
        if size > most:
            raise FormatError(
                f"{name} unpacks to more than {most / 1e6:.0f} MB, and a recording packed into {packed / 1e6:.3g} MB "
                "does not.",
                remedy="Unpack it first if you trust it.",
            )
        yield part


def pieces_of(read: Callable[[int], bytes]) -> Iterator[bytes]:
    """Read to the end, a megabyte at a time."""
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
    b"\x1f\x8b": lambda content: pieces_of(gzip.GzipFile(fileobj=io.BytesIO(content)).read),
    b"BZh": lambda content: pieces_of(bz2.BZ2File(io.BytesIO(content)).read),
    b"\xfd7zXZ\0": _undo_xz,
}
