"""Remedies together: nothing differs but what the changes name, whatever the damage and whatever is asked."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import leitmotion as lm
from leitmotion.motion import Motion, ParameterError, rotations
from leitmotion.repairs import Repaired, repair
from oracles.body import human, points_of
from oracles.rigid import tumbling

LOCAL = ("duplicates", "swaps", "frozen", "spikes", "fill")
damage = st.tuples(
    st.sampled_from(("gap", "spike", "swap", "frozen", "hold")),
    st.integers(0, 5),
    st.integers(1, 110),
    st.integers(1, 40),
)


def hurt(recording, harms):
    positions = recording.positions.copy()
    for kind, point, start, length in harms:
        stop = min(start + length, len(positions))
        other = (point + 1) % positions.shape[1]
        if kind == "gap":
            positions[start:stop, point] = np.nan
        elif kind == "spike":
            positions[start : start + 1 + length % 4, point] += [0.2, -0.3, 0.1]
        elif kind == "swap":
            positions[start:stop, [point, other]] = positions[start:stop, [other, point]]
        elif kind == "frozen":
            positions[start:stop, point] = positions[start - 1, point]
        else:
            positions[start:stop] = positions[start - 1]
    return recording.replace(positions=positions)


def named_by(mended: Repaired) -> np.ndarray:
    recording = mended.recording
    names = recording.skeleton.names if isinstance(recording, Motion) else recording.names
    named = np.zeros((len(recording), len(names)), dtype=bool)
    for change in mended.changes:
        named[change.start : change.stop, names.index(change.joint) if change.joint else slice(None)] = True
    return named


@settings(max_examples=60, deadline=None)
@given(
    harms=st.lists(damage, max_size=4),
    asked=st.sets(st.sampled_from(LOCAL)),
    method=st.sampled_from(("linear", "spline", "rigid")),
    walks=st.booleans(),
)
def test_nothing_differs_but_what_the_changes_name(harms, asked, method, walks):
    rng = np.random.default_rng(5)
    whole = points_of(human(rng, frames=120)) if walks else tumbling(rng, frames=120)
    before = hurt(whole, harms)
    kept = before.positions.copy()
    options = {remedy: (method if remedy == "fill" else True) for remedy in asked}
    mended = repair(before, **options)
    after = mended.recording.positions
    same = (after == kept) | (np.isnan(after) & np.isnan(kept))
    assert same.all(axis=2)[~named_by(mended)].all()
    assert np.array_equal(before.positions, kept, equal_nan=True)
    assert all(0 <= change.start < change.stop <= 120 for change in mended.changes)
    assert mended.changes or mended.recording is before


@settings(max_examples=20, deadline=None)
@given(
    at=st.lists(st.tuples(st.integers(0, 21), st.integers(2, 110), st.integers(1, 3)), max_size=3),
    hold=st.integers(0, 5),
)
def test_nor_of_a_skeleton(at, hold):
    motion = human(np.random.default_rng(5), frames=120)
    turns, places = motion.local_rotations.copy(), motion.local_positions.copy()
    for joint, start, length in at:
        turns[start : start + length, joint] = turns[0, (joint + 3) % 22]
    turns[60 : 60 + hold], places[60 : 60 + hold] = turns[59], places[59]
    before = motion.replace(local_rotations=turns, local_positions=places)
    mended = repair(before, duplicates=True, spikes=True)
    untouched = ~named_by(mended)
    after = mended.recording.local_rotations
    assert np.array_equal(np.abs(after[untouched]), np.abs(turns[untouched]))
    assert rotations.geodesic_angle(after[untouched], turns[untouched]).max(initial=0.0) < 1e-7
    assert np.array_equal(mended.recording.local_positions[untouched], places[untouched])


def test_asked_for_nothing_it_does_nothing(rng):
    body = hurt(tumbling(rng), [("gap", 1, 20, 5), ("spike", 2, 60, 1)])
    assert repair(body) == Repaired(body)
    assert repair(body).recording is body


def test_all_together_bring_back_the_truth(rng):
    whole = tumbling(rng, frames=200)
    harms = [("gap", 1, 20, 30), ("spike", 2, 90, 1), ("swap", 3, 120, 20), ("frozen", 0, 150, 40)]
    mended = repair(hurt(whole, harms), swaps=True, frozen=True, spikes=True, fill="rigid", max_gap_s=2.0)
    assert np.abs(mended.recording.positions - whole.positions).max() < 1e-9
    assert {change.what for change in mended.changes} == {"swap", "frozen", "spike", "fill"}
    assert lm.repair is repair


def test_what_does_not_fit_is_refused(rng):
    body = tumbling(rng)
    with pytest.raises(ParameterError, match="swap_sides is not asked for"):
        repair(body, frames=(0, 10))
    with pytest.raises(ParameterError, match="fill= names no method"):
        repair(body, max_gap_s=0.5)
    for option in ({"fill": "linear"}, {"swaps": True}, {"frozen": True}):
        with pytest.raises(ParameterError, match="is a skeleton"):
            repair(human(rng), **option)
    with pytest.raises(ParameterError, match="needs a recording, got str"):
        repair("dance.bvh")
