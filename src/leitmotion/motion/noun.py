"""What makes a noun: a frozen value, checked once when made, its arrays read-only.

Conventions
-----------
A noun is a dataclass decorated with :func:`noun`. Its ``__post_init__`` calls :func:`set_array` for each array
field, which coerces, checks the shape and forbids writing. Two nouns are equal when their fields are, ``NaN``
being equal to ``NaN``. A noun has no hash: it holds arrays. A dict in a noun stays a dict, to be read only by
agreement: a read-only view of one can be neither pickled, nor deeply copied, nor written as JSON.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence
from typing import Any, Self, TypeVar, dataclass_transform

import numpy as np

from leitmotion.motion.errors import ParameterError

T = TypeVar("T")


@dataclass_transform(eq_default=True, frozen_default=True)
def noun(cls: type[T]) -> type[T]:
    """Make a class a noun of the house: a frozen dataclass with value equality.

    Parameters
    ----------
    cls : type
        A class with annotated fields.

    Returns
    -------
    type
        The same class as a frozen dataclass.
    """
    made: Any = dataclasses.dataclass(frozen=True, eq=False)(cls)
    return made


class Noun:
    """What every noun can do: be compared by value, and be copied with changes."""

    __hash__ = None  # type: ignore[assignment]

    def replace(self, **changes: Any) -> Self:
        """Copy with some fields changed, checked anew.

        Parameters
        ----------
        **changes
            New values by field.

        Returns
        -------
        noun
            The copy.
        """
        return dataclasses.replace(self, **changes)  # type: ignore[type-var]

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return all(
            _same(getattr(self, field.name), getattr(other, field.name))
            for field in dataclasses.fields(self)  # type: ignore[arg-type]
        )


def set_array(
    owner: Any, field: str, *, dtype: type, shape: Sequence[int | None], finite: bool = True
) -> np.ndarray:
    """Coerce, check and freeze an array field of a noun under construction.

    What somebody could still write to is copied; what is read-only down to its memory, a broadcast of it or a view,
    is taken over.

    Parameters
    ----------
    owner : noun
        The value being made.
    field : str
        Name of the field.
    dtype : type
        What its elements become.
    shape : sequence of int or None
        The length of each axis, None for any.
    finite : bool
        Whether NaN and infinity are refused.

    Returns
    -------
    ndarray
        The frozen array that the field now holds.

    Raises
    ------
    ParameterError
        When it is no array of numbers, the shape differs, a number is not finite, or one of an int field not whole.
    """
    given = getattr(owner, field)
    kind = type(owner).__name__
    array = _numbers(f"{kind}.{field}", given, dtype)
    wanted = "(" + ", ".join("any" if n is None else str(n) for n in shape) + ")"
    if array.ndim != len(shape) or any(
        n is not None and n != m for n, m in zip(shape, array.shape, strict=False)
    ):
        raise ParameterError(f"{kind}.{field} must have shape {wanted}, got {array.shape}.")
    if finite and array.dtype.kind == "f" and not np.isfinite(array).all():
        where = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        raise ParameterError(
            f"{kind}.{field} must be finite, got {array[where]} at {where}.",
            remedy="Missing values belong in Trajectories." if kind == "Motion" else "",
        )
    array = _frozen(array, ours=array is not given and isinstance(given, (list, tuple, np.ndarray)))
    object.__setattr__(owner, field, array)
    return array


def set_names(owner: Any, field: str, *, unique: bool = True, empty: bool = False) -> tuple[str, ...]:
    """Coerce a field to a tuple of strings and check that none is empty or doubled.

    Parameters
    ----------
    owner : noun
        The value being made.
    field : str
        Name of the field.
    unique : bool
        Whether a name may stand only once.
    empty : bool
        Whether a name may be empty.

    Returns
    -------
    tuple of str
        The names.

    Raises
    ------
    ParameterError
        When it is no sequence of texts, a name is doubled or empty.
    """
    given, what = getattr(owner, field), f"{type(owner).__name__}.{field}"
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise ParameterError(f"{what} must be a sequence of texts, got {given!r}.")
    names = tuple(str(name) for name in given)
    if not empty and not all(name.strip() for name in names):
        place = next(k for k, name in enumerate(names) if not name.strip())
        raise ParameterError(f"{what} must not be empty, got {names[place]!r} at {place}.")
    if unique and len(set(names)) != len(names):
        doubled = sorted({name for name in names if names.count(name) > 1})
        raise ParameterError(f"{what} must differ from one another, got {doubled} twice.")
    object.__setattr__(owner, field, names)
    return names


def check_rate(owner: Any) -> float:
    """Check that the field `rate` is a positive, finite number of hertz.

    Parameters
    ----------
    owner : noun
        The value being made.

    Returns
    -------
    float
        The rate.

    Raises
    ------
    ParameterError
        When it is not.
    """
    try:
        rate = float(owner.rate)
    except (TypeError, ValueError):
        rate = np.nan
    if not np.isfinite(rate) or rate <= 0:
        raise ParameterError(
            f"{type(owner).__name__}.rate must be a positive number of hertz, got {owner.rate!r}."
        )
    object.__setattr__(owner, "rate", rate)
    return rate


def _numbers(what: str, given: Any, dtype: type) -> np.ndarray:
    """Coerce to an array of a type, without cutting off decimals."""
    try:
        array: np.ndarray = np.asarray(given)
        if array.dtype.kind != "f" or np.dtype(dtype).kind not in "iu":
            return np.asarray(array, dtype=dtype)
    except (TypeError, ValueError, OverflowError):
        raise ParameterError(f"{what} must be numbers, got {given!r:.60}.") from None
    with np.errstate(invalid="ignore"):
        whole: np.ndarray = array.astype(dtype)
    if not np.array_equal(whole, array):
        where = tuple(int(i) for i in np.argwhere(whole != array)[0])
        raise ParameterError(f"{what} must be whole numbers, got {array[where]} at {where}.")
    return whole


def _frozen(array: np.ndarray, *, ours: bool) -> np.ndarray:
    """The array, or a copy where somebody else could write to its memory."""
    holder: Any = array
    while isinstance(holder, np.ndarray) and not holder.flags.writeable:
        holder = holder.base
    if holder is None or isinstance(holder, bytes):
        return array
    if ours and array.base is None:
        array.flags.writeable = False
        return array
    # of what is broadcast one copy is enough
    once = tuple(slice(0, 1) if step == 0 else slice(None) for step in array.strides)
    copy = array[once].copy()
    copy.flags.writeable = False
    return copy if copy.shape == array.shape else np.broadcast_to(copy, array.shape)


def _same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        a, b = np.asarray(a), np.asarray(b)
        return a.shape == b.shape and bool(np.array_equal(a, b, equal_nan=a.dtype.kind in "fc"))
    if isinstance(a, float) and isinstance(b, float):
        return a == b or (a != a and b != b)
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(_same(x, y) for x, y in zip(a, b, strict=True))
    return bool(a == b)
