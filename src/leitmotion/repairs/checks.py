"""Every check, worst first: what is wrong with a recording."""

from __future__ import annotations

from collections.abc import Callable

from leitmotion.repairs import faults, person
from leitmotion.repairs.problem import Examined, Problem

Check = Callable[[Examined], Problem | None]

CHECKS: tuple[Check, ...] = (
    person.sized,
    person.upright,
    person.sided,
    person.named,
    person.sure,
    faults.jumps,
    faults.exchanged,
    faults.spikes,
    faults.frozen,
    faults.unseen,
    faults.repeated,
    faults.drifting,
    person.floored,
    person.long_enough,
)


def find_problems(seen: Examined) -> tuple[Problem, ...]:
    """Find what is wrong with a recording.

    Parameters
    ----------
    seen : Examined
        The recording, its body, and how its file was understood.

    Returns
    -------
    tuple of Problem
        Worst first; empty when nothing is wrong. Nothing is repaired.

    Examples
    --------
    >>> import leitmotion as lm
    >>> motion = lm.compose_session(seed=0, rate=30.0).motion
    >>> find_problems(Examined(motion, lm.embody(motion), lm.find_roles(motion)))
    ()
    """
    return tuple(problem for check in CHECKS if (problem := check(seen)) is not None)
