"""The floor: found under the feet, and brought back to level and to 0."""

import numpy as np
import pytest

from leitmotion.datasets import Action, compose
from leitmotion.motion import DataError, Trajectories, joint_points, rotations
from leitmotion.repairs import find_floor, level_floor


@pytest.fixture(scope="module")
def walk():
    """A person who walks in a bow, so that the feet tell the floor in both directions."""
    return compose([Action("still"), Action("walk", 8, turn=3.0), Action("still")], seed=3, rate=30.0).motion


def tilted(recording, degrees, by):
    """The recording on a floor that is turned about the axis x and z, and raised."""
    turn = rotations.from_euler("xz", np.radians(np.array(degrees, dtype=float)))
    rise = np.array([0.0, by, 0.0])
    if isinstance(recording, Trajectories):
        return recording.replace(positions=rotations.rotate(turn, recording.positions) + rise)
    places, turns = recording.local_positions.copy(), recording.local_rotations.copy()
    places[:, 0] = rotations.rotate(turn, places[:, 0]) + rise
    turns[:, 0] = rotations.multiply(np.broadcast_to(turn, turns[:, 0].shape), turns[:, 0])
    return recording.replace(local_positions=places, local_rotations=turns)


def normal_of(floor):
    normal = np.array([-floor.slopes[0], 1.0, -floor.slopes[1]])
    return normal / np.linalg.norm(normal)


def test_the_floor_of_a_session_is_level(walk):
    floor = find_floor(walk)
    assert floor.blind == 0
    assert np.degrees(floor.tilt) < 0.2
    assert floor.share > 0.5


@pytest.mark.parametrize(("degrees", "by"), [((4, 0), 0.0), ((-3, 6), 0.4), ((0, -12), -1.0)])
@pytest.mark.parametrize("as_points", [False, True])
def test_a_tilted_copy_is_levelled_back(walk, degrees, by, as_points):
    recording = joint_points(walk) if as_points else walk
    hurt = tilted(recording, degrees, by)
    assert np.degrees(find_floor(hurt).tilt) == pytest.approx(np.hypot(*degrees), abs=0.3)
    mended = level_floor(hurt)
    after = find_floor(mended.recording)
    assert np.degrees(after.tilt) < 0.2
    assert abs(after.height) < 0.002
    assert [change[:4] for change in mended.changes] == [("level", "", 0, len(walk))]


def test_the_body_stays_as_it_is(walk):
    hurt = tilted(joint_points(walk), (3, 5), 0.7)
    mended = level_floor(hurt).recording.positions
    apart = np.linalg.norm(mended[:, 1:] - mended[:, :-1], axis=2)
    assert apart == pytest.approx(np.linalg.norm(hurt.positions[:, 1:] - hurt.positions[:, :-1], axis=2))


def test_level_twice_is_level_once(walk):
    once = level_floor(tilted(walk, (5, -2), 0.3)).recording
    twice = level_floor(once).recording
    assert np.abs(twice.local_positions - once.local_positions).max() < 1e-3


def test_a_foot_in_the_air_is_not_the_floor(walk):
    """One foot is held up, still, for half of the time."""
    points = joint_points(walk)
    positions = points.positions.copy()
    names = [name for name in points.names if name.startswith("Left") and ("Foot" in name or "Toe" in name)]
    assert names
    held = [points.names.index(name) for name in names]
    positions[: len(points) // 2, held] = positions[:1, held] + [0.0, 0.5, 0.0]
    floor = find_floor(points.replace(positions=positions))
    assert floor.height == pytest.approx(find_floor(points).height, abs=0.01)
    assert np.degrees(floor.tilt) < 0.5


def test_feet_that_stay_together_tell_no_tilt():
    still = compose([Action("still"), Action("squat", 3)], seed=1, rate=60.0).motion
    mended = level_floor(tilted(still, (0, 0), 0.3))
    assert find_floor(still).blind == 2
    assert mended.remarks == (
        "The feet stand too close together to tell a tilt: only the height was mended.",
    )
    assert np.array_equal(mended.recording.local_rotations, still.local_rotations)


def test_what_has_no_floor_says_why(walk):
    points = joint_points(walk)
    with pytest.raises(DataError, match="no ankle or toe is known"):
        find_floor(points.replace(names=("a", "b", "c"), positions=points.positions[:, :3]))
    with pytest.raises(DataError, match="metres and in space"):
        find_floor(points.replace(unit="relative"))
    with pytest.raises(DataError, match="no foot ever stands still"):
        find_floor(points.replace(positions=points.positions + np.arange(len(points))[:, None, None]))
    with pytest.raises(DataError, match="that is no floor"):
        level_floor(tilted(points, (0, 33), 0.0))


@pytest.mark.parametrize("seen", [12, 30, 200])
def test_a_point_of_the_feet_that_is_hardly_ever_seen_counts_and_is_no_hindrance(rng, seen):
    """Of many moments few tell the plane, but of every point of the feet those that it takes."""
    feet = np.array([[0.1, 0.09, 0.0], [0.1, 0.02, 0.15], [-0.1, 0.09, 0.0], [-0.1, 0.02, 0.15]])
    stood = feet + rng.normal(scale=1e-4, size=(30_000, 4, 3))
    names = ("LANK", "LTOE", "RANK", "RTOE")
    whole = find_floor(Trajectories(names, stood, rate=100))
    for start in range(0, 60, 6):
        positions = stood.copy()
        positions[:, 3] = np.nan
        positions[100 : 100 + seen, 3] = stood[100 : 100 + seen, 3] - [0, 0.015, 0]
        floor = find_floor(Trajectories(names, positions[start:], rate=100))
        assert floor.height == pytest.approx(whole.height - 0.015, abs=2e-3)
