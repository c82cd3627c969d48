"""What came nearest where no two recordings share a movement."""

import re

import numpy as np
import pytest

from leitmotion.discovery import find_shared_patterns, nearest_across
from leitmotion.discovery.recurrence import SECOND_LOOK
from leitmotion.features import FeatureSequence


def circling(*, shift: float = 0.0, still: float = 2.0, rate: float = 30.0) -> FeatureSequence:
    """A hand that keeps still, then goes round once in a second and a half, body sizes."""
    phase = np.linspace(0, 2 * np.pi, round(1.5 * rate))
    wave = np.stack([0.3 * (1 - np.cos(phase)), 0.3 * np.sin(phase), 0.3 * np.sin(2 * phase)], axis=1)
    rest = np.zeros((round(still * rate), 3))
    values = np.concatenate([rest, wave, rest]) + np.array([0.0, shift, 0.0])
    return FeatureSequence(values, ("hand",), rate, invariant_to=("place",), width=3, scale=1.5)


def test_it_tells_both_stretches_in_seconds_of_their_own_recording_and_how_far_they_are() -> None:
    hands = [circling(), circling(shift=0.16, still=3.0, rate=60.0)]
    found = find_shared_patterns(hands, names=("a", "b"))
    assert not found.shared
    told = nearest_across(hands, found)
    numbers = [float(number) for number in re.findall(r"\d+\.\d+", told)]
    assert " s of a and " in told
    assert told.endswith(f"; the limit is 0.08, at the second look {SECOND_LOOK.wider * 0.08:g}.")
    assert numbers[:2] == pytest.approx([2.0, 3.5], abs=0.35)
    assert numbers[2:4] == pytest.approx([3.0, 4.5], abs=0.35)
    assert numbers[4] == pytest.approx(0.15, abs=0.02)
    assert numbers[5] == pytest.approx(100 * 1.5 * numbers[4], abs=0.1)


def test_nothing_is_told_where_something_is_shared_or_nothing_comes_near() -> None:
    alike, far = [circling(), circling()], [circling(), circling(shift=0.5)]
    for hands in (alike, far):
        assert nearest_across(hands, find_shared_patterns(hands)) == ""
    assert find_shared_patterns(alike).shared
