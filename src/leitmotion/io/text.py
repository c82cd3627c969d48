"""Text as readers take it: UTF-8 with line feeds, however a program wrote it."""

from __future__ import annotations

import csv
from pathlib import Path

from leitmotion.motion import FormatError

_MARKS = (b"\xff\xfe", b"\xfe\xff")
_SUB = b"\x1a"  # with which DOS ended a text


def is_wide(head: bytes) -> bool:
    """Whether a text that begins so is UTF-16: it begins with the mark, or every other byte is zero."""
    if head[:2] in _MARKS:
        return True
    return len(head) >= 8 and any(head[::2]) != any(head[1::2])


def as_text(path: Path, content: bytes, warnings: list[str]) -> bytes:
    """Bring a text to UTF-8 with line feeds.

    Parameters
    ----------
    path : Path
        The file, for the error.
    content : bytes
        UTF-8 or UTF-16; what is neither is taken as Windows-1252, a superset of Latin-1, in which old programs of the
        West wrote.
    warnings : list of str
        Gains a sentence where the text ends in zeros.

    Returns
    -------
    bytes
        The text.

    Raises
    ------
    FormatError
        When it holds zeros as no text does; it names the line.
    """
    if is_wide(content[:64]):
        content = _narrow(content)
    content = content.rstrip(_SUB)
    if b"\0" in content:
        kept = content.rstrip(b"\0\r\n\t ")
        place = kept.find(b"\0")
        if place >= 0 or not kept:
            line = kept.count(b"\n", 0, max(place, 0)) + 1
            raise FormatError(
                f"{path.name}, line {line}: expected text, found NUL bytes: the file is binary or damaged.",
                remedy="Was it copied or downloaded completely?",
            )
        zeros = content.count(b"\0")
        warnings.append(f"The file ends in {zeros} NUL bytes, as after a broken copy; they were left out.")
        content = kept + b"\n"
    if b"\n" not in content:  # line ends of a lone carriage return
        content = content.replace(b"\r", b"\n")
    return _as_utf8(content)


def _narrow(content: bytes) -> bytes:
    """UTF-8 of UTF-16, whose byte order the mark tells, or the place of the zeros."""
    if content[:2] in _MARKS:
        encoding = "utf-16"
    else:
        encoding = "utf-16-le" if any(content[:64:2]) else "utf-16-be"
    return content.decode(encoding, "replace").encode("utf-8", "replace")


def _as_utf8(content: bytes) -> bytes:
    if content.isascii():
        return content
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        try:
            return content.decode("cp1252").encode("utf-8")
        except UnicodeDecodeError:  # five bytes stand for nothing there
            return content.decode("latin-1").encode("utf-8")
    return content


def cells_of(line: str, delimiter: str = ",") -> list[str]:
    """Part one line of a table into its cells, which may be quoted.

    Examples
    --------
    >>> cells_of('1,"left, upper",3')
    ['1', 'left, upper', '3']
    """
    try:
        return next(csv.reader([line], delimiter=delimiter), [])
    except csv.Error:  # of a carriage return in a cell, or of a cell without end
        return line.split(delimiter)
