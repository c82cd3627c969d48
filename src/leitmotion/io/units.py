"""Units of length and what they are called."""

from __future__ import annotations

import numpy as np

from leitmotion.motion import ParameterError

METRES = {
    "m": 1.0,
    "cm": 0.01,
    "mm": 0.001,
    "dm": 0.1,
    "inch": 0.0254,
    "ft": 0.3048,
    "1/0.45 inch": 0.0254 / 0.45,
}
"""Length of each unit in metres; the last is that of the CMU and HDM05 archives."""

_SPELLINGS = {
    "meter": "m", "meters": "m", "metre": "m", "metres": "m",
    "centimeter": "cm", "centimeters": "cm", "centimetre": "cm", "centimetres": "cm",
    "millimeter": "mm", "millimeters": "mm", "millimetre": "mm", "millimetres": "mm",
    "in": "inch", "inches": "inch", "feet": "ft", "foot": "ft", "cmu": "1/0.45 inch",
}  # fmt: skip


def unit_named(word: str) -> str | None:
    """Tell which unit a word names, None for a word that names none.

    Examples
    --------
    >>> unit_named("Millimeters"), unit_named("furlong")
    ('mm', None)
    """
    word = word.strip().strip("[]()").lower()
    word = _SPELLINGS.get(word, word)
    return word if word in METRES else None


def unit_in_metres(unit: str | float) -> tuple[str, float]:
    """Name a unit and tell its length.

    Parameters
    ----------
    unit : str or float
        A name such as "cm", or a number of metres.

    Returns
    -------
    tuple of str and float
        The name as the house spells it, its length in metres.

    Raises
    ------
    ParameterError
        When the name is unknown or the number is not positive.

    Examples
    --------
    >>> unit_in_metres("cm"), unit_in_metres("0.3")
    (('cm', 0.01), ('0.3 m', 0.3))
    """
    word = unit_named(unit) if isinstance(unit, str) else None
    if word is not None:
        return word, METRES[word]
    try:
        metres = float(unit)
    except ValueError:
        raise ParameterError(
            f"The unit must be one of {', '.join(METRES)} or a number of metres, got {unit!r}."
        ) from None
    if not (np.isfinite(metres) and metres > 0):
        raise ParameterError(f"The unit must be a positive number of metres, got {unit}.")
    return f"{metres:g} m", metres
