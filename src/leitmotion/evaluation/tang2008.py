"""The error rates of paper P, from three counts.

References
----------
Paper P (Tang, Leung, Komura, Shum, 2008), section 3.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from leitmotion.motion.errors import ParameterError


class PaperErrorRates(NamedTuple):
    """Both rates as paper P reports them."""

    type_one: float
    """False pairs over the true ones; above 1 where there are more false ones than true."""
    type_two: float
    """Missed pairs over the true ones, 0 to 1."""


def paper_error_rates(found: int, false: int, missed: int) -> PaperErrorRates:
    """Compute the rates u/(U - u + v) and v/(U - u + v) of paper P.

    The denominator is the number of true pairs that are known: those of the pairs found that a person took for right,
    and those that the search for what was left over brought to light
    (:func:`leitmotion.discovery.search_residual`). What neither finds is not counted, so the second rate is a lower
    bound.

    Parameters
    ----------
    found : int
        U, the pairs that were found.
    false : int
        u, those of them that do not show the same movement.
    missed : int
        v, the pairs that were not found but show the same movement.

    Returns
    -------
    PaperErrorRates
        Type I and type II; NaN when there is no true pair.

    Raises
    ------
    ParameterError
        When a count is negative or not whole, or more pairs are false than were found.

    Examples
    --------
    >>> rates = paper_error_rates(found=40, false=4, missed=0)
    >>> round(rates.type_one, 3), rates.type_two
    (0.111, 0.0)
    """
    for name, count in (("found", found), ("false", false), ("missed", missed)):
        if not count >= 0 or int(count) != count:
            raise ParameterError(f"{name} must be a number of pairs, 0 or more, got {count}.")
    if false > found:
        raise ParameterError(f"Of {found} pairs found, {false} cannot be false.")
    true = found - false + missed
    return PaperErrorRates(false / true, missed / true) if true else PaperErrorRates(math.nan, math.nan)
