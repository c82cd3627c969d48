"""Confidence: it agrees with the positions after every remedy, and stays where they stay."""

import numpy as np
import pytest

from leitmotion.motion import Trajectories
from leitmotion.repairs import Exchange, repair, undo_exchanges
from oracles.rigid import RATE, cut, tumbling

SPIKE, GAP, HOLD, LOST = (1, 40, 42), (2, 60, 66), (90, 93), (3, 120, 170)
"""(point, start, stop) each; the hold is of all points."""


@pytest.fixture
def hurt(rng):
    """A body with a gap, a spike, a hold and a point that is lost but written on, each frame as sure as it can be."""
    whole = cut(tumbling(rng, jitter=0.0005), *GAP)
    positions = whole.positions.copy()
    positions[slice(*SPIKE[1:]), SPIKE[0]] += 0.4
    positions[slice(*HOLD)] = positions[HOLD[0] - 1]
    positions[slice(*LOST[1:]), LOST[0]] = positions[LOST[1] - 1, LOST[0]]
    sure = rng.uniform(0.1, 1.0, size=positions.shape[:2])
    sure[np.isnan(positions).any(axis=2)] = 0.0
    return Trajectories(whole.names, positions, rate=RATE, confidence=sure)


@pytest.mark.parametrize(
    ("remedy", "mended"),
    [
        ({"fill": "linear"}, [GAP]),
        ({"fill": "spline"}, [GAP]),
        ({"fill": "rigid"}, [GAP]),
        ({"spikes": True}, [SPIKE]),
        ({"spikes": True, "fill": "spline"}, [SPIKE, GAP]),
        ({"duplicates": True}, [(point, *HOLD) for point in range(4)]),
        ({"frozen": True, "fill": "rigid"}, [LOST, GAP]),
    ],
)
def test_what_is_made_is_as_sure_as_the_less_sure_of_its_ends(hurt, remedy, mended):
    after, expected = repair(hurt, **remedy).recording, hurt.confidence.copy()
    for point, start, stop in mended:
        assert np.isfinite(after.positions[start:stop, point]).all()
        assert not np.array_equal(after.positions[start:stop, point], hurt.positions[start:stop, point])
        expected[start:stop, point] = hurt.confidence[[start - 1, stop], point].min()
    points = sorted({point for point, *_ in mended})
    assert np.array_equal(after.confidence[:, points], expected[:, points])
    same = (after.positions == hurt.positions).all(axis=2)
    assert np.array_equal(after.confidence[same], hurt.confidence[same])


def test_what_is_released_is_not_sure_at_all(hurt):
    after = repair(hurt, frozen=True).recording
    point, start, stop = LOST
    assert np.isnan(after.positions[start:stop, point]).all()
    assert not after.confidence[start:stop, point].any()
    elsewhere = np.isfinite(after.positions).all(axis=2)
    assert np.array_equal(after.confidence[elsewhere], hurt.confidence[elsewhere])


def test_what_gets_its_name_back_takes_it_along(hurt):
    order = [1, 0, 2, 3, 4, 5]
    crossed = hurt.confidence.copy()
    crossed[20:30] = crossed[20:30, order]
    mended = undo_exchanges(hurt.replace(confidence=crossed), [Exchange("p0", "p1", 20, 30)])
    assert np.array_equal(mended.recording.confidence, hurt.confidence)


def test_a_filter_leaves_it(hurt):
    after = repair(hurt, filter=6.0).recording
    assert not np.array_equal(after.positions, hurt.positions, equal_nan=True)
    assert np.array_equal(after.confidence, hurt.confidence)
