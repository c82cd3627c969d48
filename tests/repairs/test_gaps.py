"""Filling gaps: exact where the method's idea holds, never beyond what was seen, never a changed bit beside a gap."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from leitmotion.motion import ParameterError, Trajectories
from leitmotion.repairs import fill_gaps
from leitmotion.repairs.rigid import carried, companions, spanning
from oracles.rigid import RATE, cut, tumbling

METHODS = ("linear", "spline", "rigid")


def one(path: np.ndarray) -> Trajectories:
    return Trajectories(("LFIN",), path[:, None], rate=RATE)


@pytest.mark.parametrize("method", METHODS)
def test_without_a_gap_the_recording_is_the_same_value(rng, method):
    body = tumbling(rng)
    mended = fill_gaps(body, method=method)
    assert mended.recording is body
    assert (mended.changes, mended.remarks) == ((), ())


@pytest.mark.parametrize("method", METHODS)
def test_what_was_seen_keeps_its_bits(rng, method):
    whole = cut(cut(tumbling(rng, jitter=0.002), 1, 60, 70), 3, 64, 80)
    mended = fill_gaps(whole, method=method)
    seen = np.isfinite(whole.positions)
    assert np.array_equal(mended.recording.positions[seen], whole.positions[seen])
    assert np.isfinite(mended.recording.positions).all()
    assert [change[:4] for change in mended.changes] == [("fill", "p1", 60, 70), ("fill", "p3", 64, 80)]


def test_a_piece_cut_out_of_a_rigid_body_is_restored_exactly(rng):
    body = tumbling(rng)
    mended = fill_gaps(cut(body, 2, 50, 130), method="rigid")
    assert np.abs(mended.recording.positions - body.positions).max() < 1e-12
    assert mended.changes[0].detail == "rigid, by 4 neighbours"


def test_two_points_lost_at_once_are_carried_by_those_left(rng):
    body = tumbling(rng, points=5)
    lost = cut(cut(body, 0, 50, 80), 1, 60, 90)
    mended = fill_gaps(lost, method="rigid")
    assert np.abs(mended.recording.positions - body.positions).max() < 1e-12


def test_a_flat_body_in_a_plane_is_carried_by_two():
    t = np.arange(100) / RATE
    turn = Rotation.from_euler("z", 2 * t[:, None]).as_matrix()[:, :2, :2]
    corners = np.array([[0.0, 0.1], [0.2, 0.0], [-0.1, -0.1]])
    body = Trajectories(("a", "b", "c"), np.einsum("tij,pj->tpi", turn, corners), rate=RATE, unit="px")
    mended = fill_gaps(cut(body, 0, 30, 60), method="rigid")
    assert np.abs(mended.recording.positions - body.positions).max() < 1e-12


def test_a_line_is_restored_by_linear_and_a_cubic_by_spline():
    t = np.arange(60) / RATE
    line = np.stack((t, 2 - t, 0 * t + 1), axis=1)
    cubic = np.stack((t**3 - t, 1 - t**2, 4 * t**3), axis=1)
    for path, method in ((line, "linear"), (cubic, "spline")):
        mended = fill_gaps(cut(one(path), 0, 25, 40), method=method)
        assert np.abs(mended.recording.positions[:, 0] - path).max() < 1e-12


@pytest.mark.parametrize("method", METHODS)
def test_the_filled_piece_meets_what_was_seen_without_a_jump(rng, method):
    body = tumbling(rng, jitter=0.001)
    mended = fill_gaps(cut(body, 2, 60, 78), method=method).recording.positions[:, 2]
    steps = np.linalg.norm(np.diff(mended, axis=0), axis=1)
    assert steps[58:80].max() < 2 * np.median(steps[40:100])


@pytest.mark.parametrize("method", METHODS)
def test_nothing_is_extrapolated(rng, method):
    lost = cut(cut(tumbling(rng), 0, 0, 5), 1, 190, 200)
    mended = fill_gaps(lost, method=method)
    assert mended.recording is lost
    assert mended.remarks == ("2 gaps at the start or the end were left (p0 and p1).",)


def test_a_longer_gap_is_left_and_told(rng):
    lost = cut(tumbling(rng), 0, 50, 75)
    left = fill_gaps(lost, method="linear")
    assert left.recording is lost
    assert left.remarks == ("1 gap longer than 0.2 s was left (p0).",)
    assert len(fill_gaps(lost, method="linear", max_gap_s=0.25).changes) == 1


def test_a_point_that_nobody_accompanies_is_filled_by_a_spline_or_left(rng):
    wander = np.cumsum(rng.normal(scale=0.02, size=(300, 4, 3)), axis=0)
    loose = Trajectories(("a", "b", "c", "d"), wander, rate=RATE)
    short = fill_gaps(cut(loose, 0, 50, 60), method="rigid")
    assert short.changes[0].detail == "spline, as no three neighbours bridge it"
    long = fill_gaps(cut(loose, 0, 50, 100), method="rigid")
    assert long.changes == ()
    assert long.remarks == ("1 gap without three steady neighbours was left (a).",)


def test_points_in_a_line_carry_nothing(rng):
    body = tumbling(rng, points=4)
    first, second = body.positions[:, 1], body.positions[:, 2]
    aligned = np.stack((body.positions[:, 0], first, second, (first + second) / 2), axis=1)
    mended = fill_gaps(cut(body.replace(positions=aligned), 0, 50, 100), method="rigid")
    assert mended.changes == ()
    assert spanning(aligned[0, 1:]) == 0


def test_the_fit_is_that_of_scipy(rng):
    before, after = rng.normal(size=(4, 3)), rng.normal(size=(4, 3))
    point = rng.normal(size=3)
    turn, _ = Rotation.align_vectors(after - after.mean(axis=0), before - before.mean(axis=0))
    expected = turn.apply(point - before.mean(axis=0)) + after.mean(axis=0)
    assert carried(before, after[None], point)[0] == pytest.approx(expected, abs=1e-12)


def test_companions_are_those_of_the_same_body(rng):
    one_body, other = tumbling(rng, points=4), tumbling(rng, points=4)
    both = np.concatenate((one_body.positions, other.positions[::-1] + 1.0), axis=1)
    assert set(companions(both, 1)) == {0, 2, 3}
    assert set(companions(both, 6)) == {4, 5, 7}


def test_an_unknown_method_is_refused(rng):
    with pytest.raises(ParameterError, match="one of linear, spline, rigid, got 'magic'"):
        fill_gaps(tumbling(rng), method="magic")
    with pytest.raises(ParameterError, match="positive number of seconds"):
        fill_gaps(tumbling(rng), max_gap_s=-1.0)


def test_filled_twice_short_gaps_are_the_splines_and_long_ones_the_neighbours(rng):
    lost = cut(cut(tumbling(rng), 1, 60, 80), 3, 100, 121)
    first = fill_gaps(lost, method="spline")
    second = fill_gaps(first.recording, method="rigid")
    told = [(change.joint, change.detail) for change in (*first.changes, *second.changes)]
    assert told == [("p1", "spline"), ("p3", "rigid, by 4 neighbours")]
    assert first.remarks == ("1 gap longer than 0.2 s was left (p3).",)
