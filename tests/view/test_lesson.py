"""The lesson in words."""

import numpy as np
import pytest

from leitmotion.discovery import Difference, Lesson, Variation
from leitmotion.view.lesson import AS_TYPICAL, difference_words, length_words, variation_words

METRES = Lesson((), rate=30, scale=1.5)


def variation(*differences: Difference, tempo: float = 1.0, lag_s: float = 0.0) -> Variation:
    return Variation(1, 0, 30, 0.02, tempo, lag_s, 0.6, differences, np.zeros((1, 2), int))


@pytest.mark.parametrize(
    ("offset", "word"),
    [
        ([0.1, 0.0, 0.0], "farther left"),
        ([-0.1, 0.05, 0.0], "farther right"),
        ([0.0, 0.1, 0.0], "higher"),
        ([0.0, -0.1, 0.05], "lower"),
        ([0.0, 0.0, 0.1], "farther forward"),
        ([0.0, 0.0, -0.1], "farther back"),
    ],
)
def test_whereto(offset: list[float], word: str) -> None:
    told = difference_words(Difference("left_wrist", 0.1, 0.25, offset), METRES)
    assert told == f"left wrist 15 cm {word} at 25 %"


def test_without_a_facing_only_up_and_down_are_told() -> None:
    lesson = METRES.replace(turned=False)
    aside, up = (Difference("head", 0.1, 0.5, offset) for offset in ([0.1, 0, 0], [0, 0.1, 0]))
    assert difference_words(aside, lesson) == "head 15 cm away at 50 %"
    assert difference_words(up, lesson) == "head 15 cm higher at 50 %"
    flat = Difference("head", 0.1, 0.5, [0.0, 0.1])
    assert difference_words(flat, lesson.replace(unit="px")) == "head 10 % of body size away at 50 %"


def test_joints_then_tempo_then_what_comes_later() -> None:
    raised = Difference("right_wrist", 0.08, 0.4, [0.0, 0.08, 0.0])
    assert variation_words(variation(raised, tempo=0.8, lag_s=-0.25), METRES) == [
        "right wrist 12 cm higher at 40 %",
        "20 % slower",
        "0.2 s earlier at 60 %",
    ]


def test_what_no_person_would_see_is_left_out() -> None:
    small = Difference("right_wrist", 0.019, 0.4, [0.0, 0.019, 0.0])
    assert variation_words(variation(small, tempo=1.04, lag_s=0.09), METRES) == [AS_TYPICAL]


def test_lengths_are_centimetres_or_shares_of_the_body() -> None:
    assert length_words(0.028, METRES) == "4.2 cm"
    assert length_words(0.028, METRES.replace(unit="px")) == "2.8 % of body size"


def test_another_cut_is_told_last_and_not_as_a_way_of_moving() -> None:
    cut = variation().replace(shift_s=-0.74)
    assert variation_words(cut, METRES) == [
        AS_TYPICAL,
        "cut elsewhere: compared from 0.7 s earlier on",
    ]
