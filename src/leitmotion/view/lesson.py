"""A lesson in words: how often each movement comes, and how each time differs from the typical one."""

from __future__ import annotations

from typing import Any

from leitmotion.discovery import Difference, Lesson, Step, Variation
from leitmotion.view.counting import times_word
from leitmotion.view.words import role_word

WORTH_NAMING_M = 0.03
WORTH_NAMING = 0.02  # body sizes, where there are no metres
WORTH_NAMING_S = 0.1
NAMED = 2  # joints
TEMPO = 0.05  # a smaller difference is none that a person sees
DIRECTIONS = (("farther left", "farther right"), ("higher", "lower"), ("farther forward", "farther back"))
AS_TYPICAL = "as the typical one"


def step_words(step: Step) -> str:
    """Say how often a movement comes, and how long that lasts in all.

    Parameters
    ----------
    step : Step
        One movement of a lesson.

    Returns
    -------
    str
        For example ``"three times, 4.5 s in all"``.
    """
    return f"{times_word(step.count)}, {step.seconds:.1f} s in all"


def variation_words(variation: Variation, lesson: Lesson) -> list[str]:
    """Say how one time differs from the typical one: joints, then tempo, then what comes sooner or later.

    Parameters
    ----------
    variation : Variation
        One time.
    lesson : Lesson
        The lesson that it belongs to.

    Returns
    -------
    list of str
        For example ``["right hand 12 cm higher at 40 %", "8 % faster"]``; what no person would see is left out, and
        where nothing is left, it says so.
    """
    named = [each for each in variation.differences if _is_worth_naming(each, lesson)][:NAMED]
    told = [difference_words(each, lesson) for each in named]
    told += [word for word in (tempo_words(variation.tempo), lag_words(variation)) if word]
    return [*(told or [AS_TYPICAL]), *filter(None, [shift_words(variation)])]


def difference_words(difference: Difference, lesson: Lesson) -> str:
    """Say where a joint is, compared with the typical time.

    Parameters
    ----------
    difference : Difference
        How far one joint is from where it is in the typical one.
    lesson : Lesson
        The lesson that it belongs to.

    Returns
    -------
    str
        For example ``"right hand 12 cm higher at 40 %"``.

    Examples
    --------
    >>> raised = Difference("right_hand", 0.1, 0.4, [0.01, 0.1, 0.0])
    >>> difference_words(raised, Lesson((), rate=30, scale=1.2))
    'right hand 12 cm higher at 40 %'
    """
    main = int(abs(difference.offset).argmax())
    toward = "away"
    if lesson.turned or (main == 1 and len(difference.offset) == 3):
        toward = DIRECTIONS[main][int(difference.offset[main] < 0)]
    length = length_words(difference.distance, lesson, digits=0)
    return f"{role_word(difference.joint)} {length} {toward} at {100 * difference.phase:.0f} %"


def length_words(distance: float, lesson: Lesson, *, digits: int = 1) -> str:
    """Say a distance in centimetres, or as a share of the body's size where there are no metres.

    Parameters
    ----------
    distance : float
        Body sizes.
    lesson : Lesson
        Tells the unit.
    digits : int
        Decimals.

    Returns
    -------
    str
        For example ``"4.2 cm"``.
    """
    if lesson.unit == "m":
        return f"{100 * lesson.scale * distance:.{digits}f} cm"
    return f"{100 * distance:.{digits}f} % of body size"


def tempo_words(tempo: float) -> str:
    """Say how much faster or slower one time is; empty where a person would not see it.

    Parameters
    ----------
    tempo : float
        1.25 takes four fifths of the time of the typical one.

    Returns
    -------
    str
        For example ``"25 % faster"``.

    Examples
    --------
    >>> tempo_words(1.25), tempo_words(0.8), tempo_words(1.01)
    ('25 % faster', '20 % slower', '')
    """
    if abs(tempo - 1) < TEMPO:
        return ""
    return f"{100 * abs(tempo - 1):.0f} % {'faster' if tempo > 1 else 'slower'}"


def lag_words(variation: Variation) -> str:
    """Say where one time is most behind or ahead of the typical one; empty where a person would not see it."""
    if abs(variation.lag_s) < WORTH_NAMING_S:
        return ""
    when = "later" if variation.lag_s > 0 else "earlier"
    return f"{abs(variation.lag_s):.1f} s {when} at {100 * variation.lag_phase:.0f} %"


def shift_words(variation: Variation) -> str:
    """Say that one time was cut at another phase, and compared from where it is in that of the typical one."""
    if not variation.shift_s:
        return ""
    when = "later" if variation.shift_s > 0 else "earlier"
    return f"cut elsewhere: compared from {abs(variation.shift_s):.1f} s {when} on"


def step_payload(step: Step, lesson: Lesson) -> dict[str, Any]:
    """Make of a movement what the page shows: its words, and its times in seconds, the typical one first.

    Parameters
    ----------
    step : Step
        One movement of a lesson.
    lesson : Lesson
        The lesson.

    Returns
    -------
    dict
        `times`, `seconds` in words; `takes` with `start`, `stop`, `cut` (its own
        borders), `apart` in words, `distance` in body sizes, `words`,
        and the `length` of their paths.
    """
    typical = {
        "start": step.start / lesson.rate,
        "stop": step.stop / lesson.rate,
        "cut": [step.start / lesson.rate, step.stop / lesson.rate],
        "apart": "",
        "distance": 0.0,
        "words": [],
        "length": 0,
    }
    return {
        "times": times_word(step.count),
        "seconds": f"{step.seconds:.1f} s in all",
        "takes": [
            typical,
            *(
                {
                    "start": each.path[0, 1] / lesson.rate if each.shift_s else each.start / lesson.rate,
                    "stop": (each.path[-1, 1] + 1) / lesson.rate if each.shift_s else each.stop / lesson.rate,
                    "cut": [each.start / lesson.rate, each.stop / lesson.rate],
                    "apart": length_words(each.distance, lesson),
                    "distance": round(each.distance, 4),
                    "words": variation_words(each, lesson),
                    "length": len(each.path),
                }
                for each in step.variations
            ),
        ],
    }


def _is_worth_naming(difference: Difference, lesson: Lesson) -> bool:
    if lesson.unit == "m":
        return difference.distance * lesson.scale >= WORTH_NAMING_M
    return difference.distance >= WORTH_NAMING
