"""Frames that repeat: replaced by what lies between, the time kept."""

import numpy as np
import pytest

from leitmotion.motion import ParameterError, rotations
from leitmotion.repairs import replace_duplicates
from leitmotion.repairs.duplicates import repeated_frames
from oracles.body import human
from oracles.rigid import RATE, cut, tumbling


def held(recording, start, stop):
    positions = recording.positions.copy()
    positions[start:stop] = positions[start - 1]
    return recording.replace(positions=positions)


def test_movement_repeats_nothing(rng):
    for recording in (tumbling(rng), human(rng)):
        mended = replace_duplicates(recording)
        assert mended.recording is recording
        assert mended.changes == ()


def test_a_hold_is_replaced_by_the_line_over_it(rng):
    body = tumbling(rng)
    mended = replace_duplicates(held(body, 60, 63))
    line = np.linspace(body.positions[59], body.positions[63], 5)
    assert np.abs(mended.recording.positions[59:64] - line).max() < 1e-12
    assert len(mended.recording) == len(body)
    assert [change[2:4] for change in mended.changes] == [(60, 63)]
    assert not repeated_frames(mended.recording.positions).any()


def test_every_second_frame_doubled_is_half_the_rate_interpolated(rng):
    body = tumbling(rng)
    doubled = body.replace(positions=np.repeat(body.positions[::2], 2, axis=0))
    mended = replace_duplicates(doubled).recording.positions
    assert np.array_equal(mended[::2], body.positions[::2])
    assert np.abs(mended - body.positions)[:-1].max() < 0.003


def test_a_held_skeleton_turns_on_the_shortest_way(rng):
    motion = human(rng)
    turns, places = motion.local_rotations.copy(), motion.local_positions.copy()
    turns[30:33], places[30:33] = turns[29], places[29]
    mended = replace_duplicates(motion.replace(local_rotations=turns, local_positions=places)).recording
    expected = rotations.slerp(turns[29], turns[33], 0.5)
    assert rotations.geodesic_angle(mended.local_rotations[31], expected).max() < 1e-7
    assert rotations.geodesic_angle(mended.local_rotations, motion.local_rotations).max() < 0.02
    with pytest.raises(ParameterError, match="A skeleton has no gaps"):
        replace_duplicates(motion, leave="gap")


def test_a_hold_may_become_a_gap_and_keeps_what_was_unseen(rng):
    body = held(cut(tumbling(rng), 1, 59, 70), 60, 63)
    gone = np.isnan(replace_duplicates(body, leave="gap").recording.positions)
    assert gone[60:63].all()
    mended = replace_duplicates(body).recording.positions
    assert np.array_equal(np.isnan(mended), np.isnan(body.positions))


def test_a_long_hold_and_the_end_are_left(rng):
    body = tumbling(rng)
    for start, stop in ((60, 60 + round(0.6 * RATE)), (190, 200)):
        mended = replace_duplicates(held(body, start, stop))
        assert mended.changes == ()
        assert mended.remarks == ("1 hold was left: it is longer than 0.5 s or at the end.",)
