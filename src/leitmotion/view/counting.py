"""Counts and times in words: numbers to twelve as words, times as a clock shows them."""

from __future__ import annotations

NUMBERS = (
    "no",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
)


def count_word(count: int) -> str:
    """Spell a count: to twelve as a word, beyond in digits.

    Parameters
    ----------
    count : int
        How many.

    Returns
    -------
    str
        The word.

    Examples
    --------
    >>> count_word(3), count_word(40), count_word(1200)
    ('three', '40', '1,200')
    """
    return NUMBERS[count] if 0 <= count < len(NUMBERS) else f"{count:,}"


def times_word(count: int) -> str:
    """Say how often: "once", "twice", "three times".

    Parameters
    ----------
    count : int
        How many times.

    Returns
    -------
    str
        The words.

    Examples
    --------
    >>> times_word(2), times_word(3), times_word(14)
    ('twice', 'three times', '14 times')
    """
    return {1: "once", 2: "twice"}.get(count) or f"{count_word(count)} times"


def plural(count: int, thing: str) -> str:
    """Say how many of a thing, in digits, minding the singular.

    Parameters
    ----------
    count : int
        How many.
    thing : str
        What, in the singular.

    Returns
    -------
    str
        For example ``"1 cycle"`` or ``"3 stretches"``.

    Examples
    --------
    >>> plural(1, "cycle"), plural(3, "stretch")
    ('1 cycle', '3 stretches')
    """
    ending = "" if count == 1 else "es" if thing.endswith(("ch", "sh", "s")) else "s"
    return f"{count:,} {thing}{ending}"


def clock(seconds: float) -> str:
    """Write a moment as minutes, seconds and tenths.

    Parameters
    ----------
    seconds : float
        Since the start.

    Returns
    -------
    str
        The moment.

    Examples
    --------
    >>> clock(38.06), clock(59.97), clock(605)
    ('0:38.1', '1:00.0', '10:05.0')
    """
    tenths = int(seconds * 10 + 0.5)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"
