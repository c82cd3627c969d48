# mypy: allow-untyped-defs
"""Kernels that turn decimal text into numbers: plain loops over bytes, no checks, no exceptions.

A decimal whose digits make an integer of at most 2^53 and whose power of ten is at most 22 in size is converted
exactly by one multiplication or division [1]_. Any other token is left as a *doubt*: its place in the output and
its bytes, for :func:`leitmotion.io.numerals.settle` to convert by Python's own ``float``.

References
----------
.. [1] W. D. Clinger: How to read floating point numbers accurately. PLDI 1990.
"""

import numpy as np
from numba import njit

DONE, NOT_A_FRAME, WRONG_NAME, TOO_FEW, TOO_MANY, CUT = range(6)

_POWERS = 10.0 ** np.arange(23)
_EXACT = np.uint64(1 << 53)
_ROOM = np.uint64((1 << 63) // 10)  # a mantissa below this takes one more digit without overflow

_SPACE, _TAB, _LF, _CR = 32, 9, 10, 13
_PLUS, _MINUS, _POINT, _ZERO, _E = 43, 45, 46, 48, 101


@njit(cache=True)
def scan_number(text, i, n, delimiter):
    """Convert the token at `i`; returns value, end of the token, whether the value is exact."""
    negative = text[i] == _MINUS
    if negative or text[i] == _PLUS:
        i += 1
    mantissa = np.uint64(0)
    exponent = 0
    digits = 0
    exact = True
    while i < n and _ZERO <= text[i] <= _ZERO + 9:
        if mantissa < _ROOM:
            mantissa = mantissa * np.uint64(10) + np.uint64(text[i] - _ZERO)
        else:
            exact = False
        digits += 1
        i += 1
    if i < n and text[i] == _POINT:
        i += 1
        while i < n and _ZERO <= text[i] <= _ZERO + 9:
            if mantissa < _ROOM:
                mantissa = mantissa * np.uint64(10) + np.uint64(text[i] - _ZERO)
                exponent -= 1
            else:
                exact = False
            digits += 1
            i += 1
    if digits > 0 and i + 1 < n and (text[i] | 32) == _E:
        i += 1
        down = text[i] == _MINUS
        if down or text[i] == _PLUS:
            i += 1
        power = 0
        exact = exact and i < n and _ZERO <= text[i] <= _ZERO + 9
        while i < n and _ZERO <= text[i] <= _ZERO + 9:
            if power < 100000:
                power = power * 10 + (text[i] - _ZERO)
            i += 1
        exponent += -power if down else power
    if i < n and not _ends(text[i], delimiter):
        exact = False
        while i < n and not _ends(text[i], delimiter):
            i += 1
    if mantissa == 0:
        exponent = 0
    if not exact or digits == 0 or mantissa > _EXACT or exponent > 22 or exponent < -22:
        return np.nan, i, False
    value = np.float64(mantissa)
    if exponent >= 0:
        value *= _POWERS[exponent]
    else:
        value /= _POWERS[-exponent]
    return (-value if negative else value), i, True


@njit(cache=True)
def scan_amc(text, i, labels, borders, counts, values, numbers, doubts):
    """Fill `values` (F, C) frame by frame from lines ``name number …`` that follow a line with the frame's number.

    Bone b is called ``labels[borders[b]:borders[b + 1]]`` and has ``counts[b]`` numbers. Returns the count of whole
    frames, of doubts, a status, where it stopped and the bone.
    """
    n = text.size
    bones = counts.size
    channels = values.shape[1]
    frame = 0
    doubtful = 0
    while True:
        i = _skip_blank(text, i, n)
        if i >= n:
            return frame, doubtful, DONE, i, -1
        start = i
        number = 0
        while i < n and _ZERO <= text[i] <= _ZERO + 9 and i - start < 18:
            number = number * 10 + (text[i] - _ZERO)
            i += 1
        if i == start or (i < n and not _ends(text[i], _SPACE)):
            return frame, doubtful, NOT_A_FRAME, start, -1
        i = _skip_space(text, i, n)
        if i < n and text[i] != _LF:
            return frame, doubtful, NOT_A_FRAME, start, -1
        if frame == values.shape[0]:
            return frame, doubtful, DONE, start, -1
        numbers[frame] = number
        column = frame * channels
        for b in range(bones):
            i = _skip_blank(text, i, n)
            start = i
            for k in range(borders[b], borders[b + 1]):
                if i >= n:
                    return frame, doubtful, CUT, start, b
                if text[i] != labels[k]:
                    return frame, doubtful, WRONG_NAME, start, b
                i += 1
            if i < n and not _ends(text[i], _SPACE):
                return frame, doubtful, WRONG_NAME, start, b
            for _ in range(counts[b]):
                i = _skip_space(text, i, n)
                if i >= n:
                    return frame, doubtful, CUT, start, b
                if text[i] == _LF:
                    return frame, doubtful, TOO_FEW, start, b
                token = i
                value, i, exact = scan_number(text, i, n, _SPACE)
                values.flat[column] = value
                if not exact:
                    doubts[doubtful, 0] = column
                    doubts[doubtful, 1] = token
                    doubts[doubtful, 2] = i
                    doubtful += 1
                column += 1
            i = _skip_space(text, i, n)
            if i < n and text[i] != _LF:
                return frame, doubtful, TOO_MANY, start, b
        frame += 1


@njit(cache=True)
def scan_rows(text, i, delimiter, pad, values, doubts):
    """Fill `values` (R, C) from lines of C numbers; blank lines are skipped.

    With the delimiter space any run of blanks divides two numbers; with another an empty cell stays NaN, and
    `pad` leaves the missing last cells of a short line NaN. Returns the count of whole rows, of doubts, a status,
    where it stopped and the column.
    """
    n = text.size
    columns = values.shape[1]
    row = 0
    doubtful = 0
    while True:
        i = _skip_blank(text, i, n) if delimiter != _TAB else _skip_lines(text, i, n)
        if i >= n or row == values.shape[0]:
            return row, doubtful, DONE, i, 0
        start = i
        for column in range(columns):
            values[row, column] = np.nan
            i = _skip_space(text, i, n) if delimiter != _TAB else _skip_only(text, i, n)
            if i >= n or text[i] == _LF:
                if pad:
                    continue
                return row, doubtful, (CUT if i >= n else TOO_FEW), start, column
            if delimiter != _SPACE and text[i] == delimiter:
                i += 1
                continue
            token = i
            value, i, exact = scan_number(text, i, n, delimiter)
            if delimiter != _SPACE:
                i = _skip_space(text, i, n) if delimiter != _TAB else _skip_only(text, i, n)
                while i < n and text[i] != delimiter and text[i] != _LF:  # a cell of several words
                    exact = False
                    i += 1
            values[row, column] = value
            if not exact:
                doubts[doubtful, 0] = row * columns + column
                doubts[doubtful, 1] = token
                doubts[doubtful, 2] = i
                doubtful += 1
            if delimiter != _SPACE and i < n and text[i] == delimiter:
                i += 1
        while i < n and text[i] != _LF:
            if not _ends(text[i], delimiter):
                return row, doubtful, TOO_MANY, start, columns
            i += 1
        row += 1


@njit(cache=True)
def _ends(c, delimiter):
    return c in (_SPACE, _LF, _CR, _TAB, delimiter)


@njit(cache=True)
def _skip_space(text, i, n):
    while i < n and (text[i] == _SPACE or text[i] == _TAB or text[i] == _CR):
        i += 1
    return i


@njit(cache=True)
def _skip_only(text, i, n):
    while i < n and (text[i] == _SPACE or text[i] == _CR):
        i += 1
    return i


@njit(cache=True)
def _skip_blank(text, i, n):
    while i < n and (text[i] == _SPACE or text[i] == _TAB or text[i] == _CR or text[i] == _LF):
        i += 1
    return i


@njit(cache=True)
def _skip_lines(text, i, n):
    """Skip lines that hold nothing but blanks; a leading tab of a line that holds more is an empty cell."""
    while True:
        k = _skip_space(text, i, n)
        if k >= n:
            return n
        if text[k] != _LF:
            return i
        i = k + 1
