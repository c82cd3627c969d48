"""How good an answer is, from files or from values: the door to the room of evaluation."""

from __future__ import annotations

from os import PathLike

import numpy as np

from leitmotion.discovery.pattern import Patterns
from leitmotion.evaluation import FoundPatterns, PatternScores, PatternTruth, evaluate_patterns
from leitmotion.motion import Segmentation
from leitmotion.motion.errors import ParameterError

TASKS = ("patterns",)
Path = str | PathLike[str]


def evaluate(
    task: str,
    truth: PatternTruth | Segmentation,
    found: Patterns | FoundPatterns,
) -> PatternScores:
    """Judge an answer by what a person saw.

    Parameters
    ----------
    task : {"patterns"}
        What was asked for.
    truth : PatternTruth or Segmentation
        What a person saw: runs of actions.
    found : Patterns or FoundPatterns
        The answer.

    Returns
    -------
    PatternScores
        All figures; :mod:`leitmotion.evaluation.patterns` has the protocol.

    Raises
    ------
    ParameterError
        When there is no such task, or the two are of different frame rates.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0)
    >>> scores = lm.evaluate("patterns", session.stretches, lm.find_patterns(session.motion))  # doctest: +SKIP
    >>> scores.type_one, scores.f1                                                             # doctest: +SKIP
    """
    if task not in TASKS:
        raise ParameterError(f"What is evaluated is one of {', '.join(TASKS)}, got {task!r}.")
    if isinstance(truth, Segmentation):
        truth = PatternTruth(truth)
    return evaluate_patterns(truth, found_patterns(found))


def found_patterns(found: Patterns | FoundPatterns) -> FoundPatterns:
    """Lay open what was found: occurrences under the names of their patterns, and pairs as four frames.

    Parameters
    ----------
    found : Patterns or FoundPatterns
        The answer of a search.

    Returns
    -------
    FoundPatterns
        The same for the evaluation.
    """
    if isinstance(found, FoundPatterns):
        return found
    spans = [(start, stop, pattern.id) for pattern in found for start, stop, _, _ in pattern.occurrences]
    occurrences = Segmentation(
        np.array([start for start, _, _ in spans], dtype=np.int64),
        np.array([stop for _, stop, _ in spans], dtype=np.int64),
        tuple(name for _, _, name in spans),
        rate=found.rate,
    )
    pairs = np.array([(*pair.a, *pair.b) for pair in found.pairs], dtype=np.int64).reshape(-1, 4)
    return FoundPatterns(occurrences, pairs)
