"""Laws of joined recordings: the truth is exact, the blends go on smoothly, the same name gives the same bytes."""

import importlib
from pathlib import Path

import numpy as np
import pytest

from leitmotion.motion import Motion, Skeleton, forward_kinematics, rotations

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"
SOME = ("hdm05-dg/17", "hdm05-bk/08", "bandai-2/04", "cmu-16/03", "cmu-02/02")


@pytest.fixture
def joining(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("joining")


@pytest.fixture
def joined(monkeypatch, data):
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("joined")


def speeds(motion):
    """Metres a second of the fastest joint, between each two frames."""
    return (
        np.linalg.norm(np.diff(forward_kinematics(motion).positions, axis=0), axis=2).max(axis=1)
        * motion.rate
    )


def walker(*, heading, speed, frames=60, rate=60.0):
    """Two joints that go straight on."""
    body = Skeleton(("hips", "left", "right"), [-1, 0, 0], [[0, 1, 0], [0.1, -0.9, 0], [-0.1, -0.9, 0]])
    along = np.arange(frames)[:, None] / rate * speed * np.array([np.sin(heading), 0, np.cos(heading)])
    positions = np.broadcast_to(body.offsets, (frames, 3, 3)).copy()
    positions[:, 0] += along
    turns = np.tile([1.0, 0, 0, 0], (frames, 3, 1))
    turns[:, 0] = rotations.yaw_rotation(np.array(heading))
    return Motion(body, positions, turns, rate=rate)


def test_who_walks_straight_on_goes_on_walking_straight(joining):
    before, clip = walker(heading=0.7, speed=1.4), walker(heading=-2.0, speed=1.4)
    after = joining.placed(clip, before, 18)
    blend = joining.blended(before, after, 18)
    whole = np.concatenate([piece.local_positions[:, 0] for piece in (before, blend, after)])
    steps = np.diff(whole, axis=0) * before.rate
    assert np.allclose(steps, 1.4 * np.array([np.sin(0.7), 0, np.cos(0.7)]), atol=1e-9)


def test_a_blend_begins_and_ends_at_the_speed_of_the_clips(joining):
    before, clip = walker(heading=0.0, speed=2.0), walker(heading=0.0, speed=0.5)
    swing = rotations.from_axis_angle("x", 0.02 * np.arange(60))
    turns = before.local_rotations.copy()
    turns[:, 1] = swing
    before = before.replace(local_rotations=turns)
    after = joining.placed(clip, before, 40)
    blend = joining.blended(before, after, 40)
    first = rotations.geodesic_angle(before.local_rotations[-1, 1], blend.local_rotations[0, 1])
    assert first == pytest.approx(0.02, abs=0.005)
    last = rotations.geodesic_angle(blend.local_rotations[-1, 1], after.local_rotations[0, 1])
    assert last < 0.005
    step = np.linalg.norm(blend.local_positions[0, 0] - before.local_positions[-1, 0])
    assert step * before.rate == pytest.approx(2.0, abs=0.1)


def test_a_warp_keeps_both_ends_and_its_bounds(joining, rng):
    clip = walker(heading=0.0, speed=1.0, frames=200)
    for _ in range(20):
        warped = joining.warped(clip, rng)
        assert np.allclose(warped.local_positions[[0, -1]], clip.local_positions[[0, -1]])
        speed = np.diff(warped.local_positions[:, 0, 2]) * clip.rate
        assert 0.84 < speed.min() <= speed.max() < 1.16
        assert np.abs(np.diff(speed)).max() < 0.02


@pytest.mark.data
@pytest.mark.parametrize("name", SOME)
def test_the_truth_covers_the_clips_exactly(joined, name):
    made = joined.joined(name)
    known, rate = made.truth.repetitions, made.motion.rate
    assert (known.starts[0], known.stops[-1]) == (0, len(made.motion))
    blends = (known.starts[1:] - known.stops[:-1]) / rate
    assert (blends > 0.2 - 1 / rate).all()
    assert (blends < 0.4 + 1 / rate).all()
    which = made.truth.which_run(len(made.motion))
    for k, (start, stop, label, _) in enumerate(known):
        assert {made.truth.runs.labels[run] for run in which[start:stop]} == {label}
        if k + 1 < len(known) and known.labels[k + 1] != label:
            assert (which[stop : known.starts[k + 1]] == -1).all()


@pytest.mark.data
@pytest.mark.parametrize("name", SOME)
def test_clips_are_left_as_they_are(joined, name):
    """Within a clip the joints move as in the take: only where it is and which way it faces is changed."""
    made = joined.joined(name)
    takes = [take for move in joined.moves(name.split("/")[0]) for take in move.takes]
    lengths = {len(joined._clip(take)): take for take in takes}
    same = 0
    for start, stop, _, _ in made.truth.repetitions:
        if stop - start in lengths:
            take = joined._clip(lengths[stop - start])
            inside = rotations.geodesic_angle(
                made.motion.local_rotations[start:stop, 2:], take.local_rotations[:, 2:]
            )
            same += bool(inside.max() < 1e-6)
    assert same >= 1


@pytest.mark.data
@pytest.mark.parametrize("name", SOME)
def test_seams_are_no_faster_than_the_clips(joined, name):
    made = joined.joined(name)
    fast = speeds(made.motion)
    inside = np.zeros(len(made.motion) - 1, dtype=bool)
    for start, stop, _, _ in made.truth.repetitions:
        inside[start : stop - 1] = True
    assert fast[~inside].max() < 2 * fast[inside].max()


@pytest.mark.data
def test_the_same_name_gives_the_same_bytes_and_another_one_others(joined):
    once, again, other = (joined.joined(name) for name in ("hdm05-bd/04", "hdm05-bd/04", "hdm05-bd/05"))
    assert once.motion == again.motion
    assert once.truth == again.truth
    assert len(once.motion) != len(other.motion)


@pytest.mark.data
def test_no_take_comes_twice_while_there_are_others(joined):
    rng = np.random.default_rng(3)
    for _ in range(5):
        clips = [(move, clip.name) for move, clip in joined._clips("hdm05-bd", rng)]
        for move in {move.label: move for move, _ in clips}.values():
            taken = [name for own, name in clips if own == move]
            assert len(set(taken)) == min(len(taken), len(move.takes))


@pytest.mark.data
def test_actors_to_fit_on_are_none_to_report_on(joined):
    fit, report = (set(joined.COUNTS[split]) for split in ("fit", "report"))
    assert not fit & report
    assert len(joined.names("fit")) >= 40
    assert len(joined.names("report")) >= 60
