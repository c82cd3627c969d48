"""Left and right, and points that change places."""

import numpy as np
import pytest

from leitmotion.body import find_roles, swap_sides
from leitmotion.motion import ParameterError, Trajectories, forward_kinematics
from leitmotion.repairs import find_exchanges, mirror_partners, swap_left_right, undo_exchanges
from oracles.body import human, other_side, points_of, skeleton
from oracles.rigid import RATE, tumbling


@pytest.fixture
def walker(rng) -> Trajectories:
    return points_of(human(rng, frames=120))


def crossed(recording, pairs, start, stop):
    positions = recording.positions.copy()
    for one, other in pairs:
        pair = [recording.names.index(one), recording.names.index(other)]
        positions[start:stop, pair] = positions[start:stop, pair[::-1]]
    return recording.replace(positions=positions)


def test_swapped_twice_it_is_the_recording_that_was(rng, walker):
    for recording in (walker, human(rng)):
        once = swap_left_right(recording)
        assert once.recording != recording
        assert swap_left_right(once.recording).recording == recording
        assert [change[:4] for change in once.changes] == [("sides", "", 0, len(recording))]
    part = swap_left_right(walker, frames=(30, 50))
    assert swap_left_right(part.recording, frames=(30, 50)).recording == walker


def test_nothing_moves_but_the_names(rng):
    motion = human(rng)
    swapped = swap_left_right(motion).recording
    assert np.array_equal(forward_kinematics(swapped).positions, forward_kinematics(motion).positions)
    assert swapped.skeleton.names == tuple(other_side(name) for name in motion.skeleton.names)
    points = swap_left_right(points_of(motion)).recording
    left, right = points.names.index("LeftHand"), points.names.index("RightHand")
    assert np.array_equal(points.positions[:, left], points_of(motion).positions[:, right])


def test_the_roles_of_the_swapped_are_the_swapped_roles(rng):
    motion = human(rng)
    names = dict(zip(motion.skeleton.names, swap_left_right(motion).recording.skeleton.names, strict=True))
    here, there = swap_sides(find_roles(motion)), find_roles(swap_left_right(motion).recording)
    assert here.roles == there.roles
    assert tuple(tuple(names[one] for one in members) for members in here.members) == there.members


def test_only_the_frames_that_are_meant(walker):
    part = swap_left_right(walker, frames=(30, 50)).recording.positions
    whole = swap_left_right(walker).recording.positions
    assert np.array_equal(part[30:50], whole[30:50])
    assert np.array_equal(
        np.delete(part, slice(30, 50), axis=0), np.delete(walker.positions, slice(30, 50), axis=0)
    )


def test_a_map_names_the_partners_where_names_do_not():
    bare = Trajectories(("m1", "m2", "m3"), np.arange(9.0).reshape(1, 3, 3), rate=RATE)
    with pytest.raises(ParameterError, match="has a partner on the other side"):
        swap_left_right(bare)
    entries = {"left_knee": "m1", "right_knee": "m3"}
    assert mirror_partners(bare, entries) == {"m1": "m3", "m3": "m1"}
    assert swap_left_right(bare, body_map=entries).recording.positions[0, :, 0].tolist() == [6.0, 3.0, 0.0]


def test_confidence_goes_with_its_point():
    two = Trajectories(("LANK", "RANK"), np.zeros((1, 2, 3)), rate=RATE, confidence=np.array([[0.2, 0.9]]))
    assert swap_left_right(two).recording.confidence.tolist() == [[0.9, 0.2]]


def test_every_joint_of_a_skeleton_with_sides_has_its_partner(rng):
    partners = mirror_partners(human(rng))
    assert partners == {name: other_side(name) for name in skeleton().names if other_side(name) != name}


def test_a_point_without_a_partner_stays_and_is_told():
    three = Trajectories(("LeftKnee", "RightKnee", "LeftWing"), np.arange(9.0).reshape(1, 3, 3), rate=RATE)
    mended = swap_left_right(three)
    assert mended.remarks == ("Without a partner on the other side, left as it is: LeftWing.",)
    assert mended.recording.positions[0, :, 0].tolist() == [3.0, 0.0, 6.0]


def test_the_sides_of_a_skeleton_are_swapped_in_all_frames_or_none(rng):
    with pytest.raises(ParameterError, match="all frames or none"):
        swap_left_right(human(rng), frames=(0, 10))
    with pytest.raises(ParameterError, match="do not lie in the recording"):
        swap_left_right(points_of(human(rng)), frames=(50, 100))


@pytest.mark.parametrize(("start", "stop"), [(40, 70), (1, 20), (90, 120), (40, 41)])
def test_exchanges_are_found_and_undone(walker, start, stop):
    pairs = [("LeftHand", "RightHand"), ("LeftFoot", "RightFoot"), ("Head", "LeftArm")]
    hurt = crossed(walker, pairs, start, stop)
    found = find_exchanges(hurt)
    assert {frozenset(one[:2]) for one in found} == {frozenset(pair) for pair in pairs}
    assert {one[2:] for one in found} == {(start, stop)}
    mended = undo_exchanges(hurt)
    assert mended.recording == walker
    assert len(mended.changes) == 6


def test_an_exchange_behind_a_short_gap_is_found(walker):
    hurt = crossed(walker, [("LeftHand", "RightHand")], 50, 80)
    positions = hurt.positions.copy()
    for name in ("LeftHand", "RightHand"):
        positions[50:54, walker.names.index(name)] = np.nan
    (found,) = find_exchanges(hurt.replace(positions=positions))
    assert {found.first, found.second} == {"LeftHand", "RightHand"}
    assert found[2:] == (54, 80)


def test_movement_and_noise_and_single_jumps_exchange_nothing(rng, walker):
    assert find_exchanges(walker) == ()
    assert find_exchanges(tumbling(rng, jitter=0.003)) == ()
    positions = walker.positions.copy()
    positions[60:, 3] += 0.5
    assert find_exchanges(walker.replace(positions=positions)) == ()
