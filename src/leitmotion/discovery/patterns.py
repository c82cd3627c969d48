"""Patterns: which movements recur in a recording, and where.

Methods
-------
- ``recurrence``: the default, no parameter needed; :mod:`leitmotion.discovery.recurrence`.
- ``tang2008``: paper P to the letter; :mod:`leitmotion.discovery.tang2008`.
"""

from __future__ import annotations

from collections.abc import Callable
from numbers import Real
from typing import Any

from leitmotion.discovery.pattern import Patterns
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import DataError, ParameterError

METHODS = ("recurrence", "tang2008")
MIN_RATE = 4.0  # hertz: two frames in the shortest stretch


def find_patterns(features: FeatureSequence, *, method: str = "recurrence", **options: Any) -> Patterns:
    """Find the movements that recur: cyclic ones (steps, squats) and acyclic ones (a turn that comes back later).

    Parameters
    ----------
    features : FeatureSequence
        Postures, T frames; see :func:`leitmotion.features.posture`.
    method : {"recurrence", "tang2008"}
        How to look.
    **options
        Of the method: see :func:`leitmotion.discovery.find_recurrences` and
        :func:`leitmotion.discovery.find_patterns_tang2008`. An unknown one is refused.

    Returns
    -------
    Patterns
        The pattern that fills most time first; none when nothing repeats.

    Raises
    ------
    ParameterError
        When the method or an option is unknown.
    DataError
        When the recording has fewer than four frames a second.
    """
    import inspect

    if features.rate < MIN_RATE:
        raise DataError(
            f"Patterns need {MIN_RATE:g} frames a second or more, got {features.rate:g}.",
            remedy="Between two such frames a person may do anything.",
        )
    find: Callable[..., Patterns]
    if method == "recurrence":
        from leitmotion.discovery.recurrence import find_recurrences

        find = find_recurrences
    elif method == "tang2008":
        from leitmotion.discovery.tang2008 import find_patterns_tang2008

        find = find_patterns_tang2008
    else:
        raise ParameterError(f"method must be one of {', '.join(METHODS)}, got {method!r}.")
    parameters = inspect.signature(find).parameters
    known = [name for name, p in parameters.items() if p.kind is p.KEYWORD_ONLY]
    unknown = sorted(set(options) - set(known))
    if unknown:
        raise ParameterError(f"method {method!r} has no option {unknown[0]!r}; it has {', '.join(known)}.")
    for name, value in options.items():
        if isinstance(parameters[name].default, float) and not isinstance(value, Real):
            raise ParameterError(f"{name} must be a number, got {value!r}.")
    return find(features, **options)
