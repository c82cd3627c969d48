"""Loops: a recording that is one stretch, copied, is as many cycles as there are copies."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d

from leitmotion import body, features, io
from leitmotion.discovery import find_patterns, loops
from leitmotion.discovery.loops import COPIED, loop_length
from leitmotion.features import FeatureSequence


def motion(rng, frames):
    """Smooth motion that never comes back. (frames, 9)."""
    values = gaussian_filter1d(rng.normal(size=(frames, 9)), 8, axis=0)
    return 0.2 * values / values.std()


def sequence(values, rate=30.0):
    return FeatureSequence(values, ("a", "b", "c"), rate, ("place",), 3)


def told(found):
    return [(pattern.kind, [(start, stop) for start, stop, _, _ in pattern.occurrences]) for pattern in found]


@pytest.mark.parametrize("copies", [2, 3, 7])
@pytest.mark.parametrize(("frames", "rate"), [(200, 30.0), (479, 120.0), (301, 50.0)])
def test_copies_are_cycles_at_any_rate(rng, copies, frames, rate):
    loop = sequence(np.tile(motion(rng, frames), (copies, 1)), rate)
    assert told(find_patterns(loop)) == [("cyclic", [(frames * k, frames * (k + 1)) for k in range(copies)])]


def test_a_loop_may_break_off_and_miss_what_was_not_seen(rng):
    once = motion(rng, 150)
    once[40:60], once[90:120, :3] = np.nan, np.nan
    loop = np.tile(once, (4, 1))[:520]
    assert loop_length(sequence(loop), 15) == 150
    assert told(find_patterns(sequence(loop))) == [("cyclic", [(0, 150), (150, 300), (300, 450)])]


def test_what_differs_in_one_frame_is_no_loop(rng):
    loop = np.tile(motion(rng, 150), (3, 1))
    assert loop_length(sequence(loop + rng.uniform(-0.4, 0.4, loop.shape) * COPIED), 15) == 150
    for frame in (0, 149, 150, 311, 449):
        other = loop.copy()
        other[frame, 4] += 3 * COPIED
        assert loop_length(sequence(other), 15) is None
    assert loop_length(sequence(loop[:299]), 15) is None


def test_no_copy_is_shorter_than_a_movement_and_stillness_is_none(rng):
    assert loop_length(sequence(np.tile(motion(rng, 10), (12, 1))), 15) == 20
    assert told(find_patterns(sequence(np.tile(motion(rng, 1), (300, 1))))) == []


def test_of_a_body_that_keeps_still_nearly_always_few_lengths_are_tried(rng, monkeypatch):
    tried = []
    same = loops._same
    monkeypatch.setattr(loops, "_same", lambda *sides: tried.append(sides) or same(*sides))
    for still in (slice(0, -100), slice(100, None)):
        values = motion(rng, 20_000)
        values[still] = values[500]
        assert loop_length(sequence(values), 15) is None
    assert len(tried) < 1000


def test_a_movement_that_comes_back_after_a_rest_is_no_loop(rng):
    once = 0.5 * motion(rng, 60) * np.sin(np.linspace(0, np.pi, 60))[:, None]
    for rest, kind in ((10, "cyclic"), (60, "acyclic")):
        loop = np.tile(np.concatenate((once, np.zeros((rest, 9)))), (2, 1))
        ((found, spans),) = told(find_patterns(sequence(loop)))
        assert (found, len(spans)) == (kind, 2)


@pytest.mark.data
@pytest.mark.parametrize("copies", [2, 3, 5])
def test_a_loop_of_a_real_recording_is_told_as_its_copies(data, copies):
    once = features.posture(body.embody(io.read(data / "animated_drawings" / "zombie.bvh")))
    loop = once.replace(values=np.tile(once.values, (copies, 1)))
    frames = len(once)
    assert told(find_patterns(loop)) == [("cyclic", [(frames * k, frames * (k + 1)) for k in range(copies)])]
