"""What can go wrong, said in one sentence.

::

    LeitmotionError
    ├── ParameterError   an argument is not what the function takes
    ├── FormatError      a file is not what its format says it is
    └── DataError        the file is fine, but it cannot answer this question

The message tells what was expected, what was found and where; `remedy` tells what to do. Both are one line, whatever a
file or its name holds.
"""

from __future__ import annotations

from collections.abc import Collection

_LONGEST = 800  # characters of a sentence


def in_one_line(text: str) -> str:
    r"""Spell a text so that it is one line that can be printed, and not endless.

    Parameters
    ----------
    text : str
        Any text; what cannot be printed stands as Python spells it.

    Returns
    -------
    str
        The line.

    Examples
    --------
    >>> print(in_one_line("There is no file a" + chr(9) + "b.bvh."))
    There is no file a\tb.bvh.
    """
    line = "".join(mark if mark.isprintable() else repr(mark)[1:-1] for mark in text)
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST - 1]}…"


def in_short(names: Collection[str], *, most: int = 8) -> str:
    """List names for a sentence, of many the first.

    Parameters
    ----------
    names : collection of str
        What there is.
    most : int
        How many are named.

    Returns
    -------
    str
        The names.

    Examples
    --------
    >>> in_short(["a", "b"]), in_short(["a", "b", "c", "d"], most=2)
    ('a, b', 'a, b and 2 more')
    """
    named = ", ".join(list(names)[:most])
    return f"{named} and {len(names) - most} more" if len(names) > most else named


class LeitmotionError(Exception):
    """Root of every error that Leitmotion raises on purpose.

    Parameters
    ----------
    message : str
        What was expected, what was found, where.
    remedy : str, optional
        What the person can do about it.
    """

    def __init__(self, message: str, *, remedy: str = "") -> None:
        self.message = in_one_line(message)
        self.remedy = in_one_line(remedy)
        super().__init__(self.message)

    def __str__(self) -> str:
        return f"{self.message} {self.remedy}".strip()


class ParameterError(LeitmotionError, ValueError):
    """An argument is not what the function takes."""


class FormatError(LeitmotionError, ValueError):
    """A file is not what its format says it is."""


class DataError(LeitmotionError):
    """The recording is readable but cannot answer this question."""
