"""Odd recordings: empty, short, unseen, in a picture, at a strange rate: answered or refused in a sentence."""

import contextlib
import itertools

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.motion import Trajectories
from leitmotion.repairs import repair
from oracles.body import human

REMEDIES = (
    {"duplicates": True}, {"swaps": True}, {"frozen": True}, {"spikes": True}, {"fill": "linear"},
    {"fill": "spline"}, {"fill": "rigid", "max_gap_s": 9.0}, {"filter": 0.4}, {"filter": "auto"},
    {"level": True}, {"swap_sides": True}, {"swap_sides": True, "frames": (0, 1)},
)  # fmt: skip
FEET = ("LASI", "RASI", "LKNE", "RKNE", "LANK", "RANK", "LTOE", "RTOE")


def odd(rng):
    for frames, components, lost in itertools.product((0, 1, 2, 6, 60), (2, 3), (0.0, 0.5, 1.0)):
        positions = np.cumsum(rng.normal(scale=0.01, size=(frames, 8, components)), axis=0)
        positions[rng.random((frames, 8)) < lost] = np.nan
        yield Trajectories(FEET, positions, rate=50, unit="m" if components == 3 else "px")
    for rate in (1e-3, 1.0, 1e6):
        yield Trajectories(FEET, np.zeros((50, 8, 3)), rate=rate)
    yield Trajectories(("one",), np.zeros((50, 1, 3)), rate=50)
    for frames in (1, 2, 3, 6):
        yield human(rng, frames=frames)


@pytest.mark.filterwarnings("error")
def test_odd_recordings_are_answered_or_refused_in_a_sentence(rng):
    answered = 0
    for recording in odd(rng):
        for remedy in REMEDIES:
            with contextlib.suppress(lm.LeitmotionError):
                answered += len(repair(recording, **remedy).recording) == len(recording)
        with contextlib.suppress(lm.LeitmotionError):
            answered += lm.info(recording).frames == len(recording)
    assert answered > 200
