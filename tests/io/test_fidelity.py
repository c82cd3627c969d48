"""What a format does not keep: nothing of what it keeps is told, and everything that is lost is."""

from types import SimpleNamespace

import numpy as np
import pytest

from leitmotion.datasets import Action, compose
from leitmotion.io import fidelity
from leitmotion.io.fidelity import Loss, differences, losses
from leitmotion.io.formats import writable
from leitmotion.motion import FormatError, Motion, Skeleton, Trajectories, joint_points, rotations


@pytest.fixture(scope="module")
def motion() -> Motion:
    return compose([Action("walk", 1)], seed=4, rate=30.0).motion


@pytest.fixture
def points(rng: np.random.Generator) -> Trajectories:
    positions = rng.normal(size=(20, 3, 3))
    positions[4:7, 1] = np.nan
    return Trajectories(("a", "b", "c"), positions, 50.0, confidence=rng.random((20, 3)))


def whats(changes: tuple[Loss, ...]) -> list[str]:
    return [change.what for change in changes]


def test_an_archive_keeps_everything(motion, points):
    form = writable()[".npz"]
    for recording in (motion, points, points.replace(unit="px", positions=points.positions[..., :2])):
        assert losses(recording, form.write(recording), ".npz") == ()


@pytest.mark.parametrize("unit", ["cm", "m", 0.3])
def test_a_bvh_keeps_a_motion_whatever_its_unit(motion, unit):
    form = writable()[".bvh"]
    assert losses(motion, form.write(motion, unit=unit), ".bvh", unit=unit) == ()


def test_every_format_tells_its_losses_of_a_motion_without_a_fault(motion):
    for extension, form in writable().items():
        unit = form.options.get("unit")
        for change in losses(motion, form.write(motion), extension, unit=unit):
            assert change.frames <= len(motion)
            assert change.detail.endswith(".")
            assert (change.what == "unread") is not bool(form.module)
            assert change.what not in {"frames", "rate", "people", "points", "gaps"}, (form.name, change)


def test_a_bvh_with_blanks_in_a_name_and_a_leaf_without_an_end(motion):
    bare = Skeleton(("hips", "left   arm"), [-1, 0], [[0, 1, 0], [0.3, 0, 0]])
    still = np.tile([1.0, 0, 0, 0], (5, 2, 1))
    arm = Motion(bare, np.broadcast_to(bare.offsets, (5, 2, 3)), still, 30.0)
    form = writable()[".bvh"]
    ends, names = losses(arm, form.write(arm), ".bvh", unit="cm")
    assert (ends.what, ends.detail) == ("end sites", "0 end sites became 1.")
    assert (names.what, names.joint, names.frames) == ("names", "left   arm", 5)
    assert names.detail == "'left   arm' became 'left arm'."


def test_a_rate_that_a_reader_doubts_is_told(motion):
    slow = motion.replace(rate=1 / 25.0)
    form = writable()[".bvh"]
    assert whats(losses(slow, form.write(slow), ".bvh", unit="cm")) == ["rate"]


def test_equal_recordings_do_not_differ(motion, points):
    assert differences(motion, motion) == ()
    assert differences(points, points) == ()


def test_the_order_of_points_is_none_of_their_properties(points):
    turned = points.replace(
        names=points.names[::-1],
        positions=points.positions[:, ::-1],
        confidence=points.confidence[:, ::-1],
    )
    assert differences(points, turned) == ()


def test_a_skeleton_that_became_points(motion):
    changes = differences(motion, joint_points(motion))
    assert whats(changes) == ["rotations", "end sites"]
    assert f"{len(motion.skeleton)} joints became points" in changes[0].detail


def test_what_points_lose(points):
    lesser = points.replace(kind="joint", confidence=None)
    assert whats(differences(lesser, lesser.replace(kind="marker"))) == ["kind"]
    assert whats(differences(points, points.replace(confidence=None))) == ["confidence"]
    fewer = Trajectories(("a", "c"), points.positions[:, [0, 2]], 50.0)
    (lost,) = differences(points.replace(confidence=None), fewer)
    assert lost == Loss("points", "b", 20, "Not kept: b.")


def test_gaps_that_closed_and_gaps_that_opened(points):
    seen = points.replace(positions=np.nan_to_num(points.positions))
    assert differences(points, seen)[0][:3] == ("gaps", "b", 3)
    assert differences(seen, points)[0][:3] == ("gaps", "b", 3)


@pytest.mark.parametrize(("unit", "error"), [("m", 1e-5), ("relative", 1e-5), ("px", 1e-3)])
def test_a_place_may_differ_a_little_and_no_more(points, unit, error):
    given = points.replace(unit=unit)
    moved = given.positions.copy()
    moved[8:10, 2, 0] += 0.9 * error
    assert differences(given, given.replace(positions=moved)) == ()
    moved[8:10, 2, 0] += error
    (change,) = differences(given, given.replace(positions=moved))
    assert change[:3] == ("precision", "c", 2)
    assert f"up to {1.9 * error:.2g} {unit}" in change.detail


def test_a_turn_that_moves_no_joint_is_seen(motion):
    turned = motion.local_rotations.copy()
    hand = (
        motion.skeleton.index("left_hand")
        if "left_hand" in motion.skeleton.names
        else len(motion.skeleton) - 1
    )
    turned[:, hand] = rotations.multiply(turned[:, hand], rotations.from_axis_angle("x", 1e-3))
    (change,) = differences(motion, motion.replace(local_rotations=turned))
    assert change.what == "precision"
    assert change.joint == motion.skeleton.names[hand]
    assert "0.001 rad" in change.detail


def test_frames_and_rate(motion):
    assert whats(differences(motion, motion[1:])) == ["frames"]
    assert whats(differences(motion, motion.replace(rate=30.001))) == ["rate"]


def test_what_is_not_read_again_is_told(motion, monkeypatch):
    form = writable()[".bvh"]
    content = form.write(motion)

    def refuse(_):
        raise FormatError("Nothing is read today.")

    monkeypatch.setattr(fidelity, "recognise", lambda *_: SimpleNamespace(module="bvh", read=refuse))
    (told,) = losses(motion, content, ".bvh", unit="cm")
    assert (told.what, told.detail) == ("unread", "It is not read again: Nothing is read today.")
