"""Proximity signals: the kernel beside its twin, and what a signal is."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.datasets import compose_motif
from leitmotion.discovery import _signal_kernels as kernels
from leitmotion.discovery.signals import find_signals
from leitmotion.discovery.waypoints import find_waypoints
from leitmotion.features import kinematic_chain
from leitmotion.similarity import double_metric
from oracles import motifs as twin


def found_in(motif):
    return find_waypoints(double_metric(kinematic_chain(twin.movement(motif))[::2]))


@pytest.mark.parametrize("reverse", [False, True])
def test_the_alignment_is_what_the_recursion_says(rng, reverse):
    count = 40
    apart = rng.uniform(0, 2.0, (count, count)).astype(np.float32)
    apart[rng.uniform(size=apart.shape) < 0.05] = np.nan
    lower = np.zeros(count, int) if reverse else np.arange(count) + rng.integers(1, 4, count)
    upper = np.arange(count - 1, -1, -1) if reverse else np.full(count, count)
    H, S = np.zeros((2, count, count), np.float32)
    how = np.zeros((count, count), np.uint8)
    kernels.align(apart, lower, upper, np.float32(3.0), H, S, how)
    gained, whole = twin.align(apart, lower, upper, 3.0)
    assert np.abs(H - gained).max() < 1e-4
    assert np.abs(S - whole).max() < 1e-3
    assert H.max() > 3.0  # the ceiling was met


def test_waypoints_are_a_step_apart_and_stillness_makes_none():
    metric = double_metric(kinematic_chain(twin.human_doing(twin.rest(100))))
    assert find_waypoints(metric).at.tolist() == [0]
    waypoints = found_in("symmetric_palindrome")
    steps = np.diagonal(waypoints.own, 1)
    moments = np.diff(waypoints.at)
    assert (
        steps.min()
        >= 0.999 * 0.2 * double_metric(kinematic_chain(twin.movement("symmetric_palindrome"))[::2]).half_angle
    )
    assert moments[0] > 5  # the person stands first


def test_the_body_stays_at_its_last_waypoint_to_the_end_of_what_was_seen():
    chain = kinematic_chain(twin.movement("symmetric_palindrome"))[::2]
    rest = np.repeat(chain.values[-1:], 40, axis=0)
    unseen = np.full_like(rest, np.nan)
    longer = chain.replace(values=np.concatenate((chain.values, rest, unseen)))
    waypoints = find_waypoints(double_metric(longer))
    last = len(waypoints.at) - 1
    assert waypoints.left(last) == len(chain) + 39
    assert waypoints.stretch(last, last) == (waypoints.at[last], len(chain) + 40)


@pytest.mark.parametrize(
    ("motif", "mirror", "reverse"),
    [
        ("symmetric_cycle", False, False),
        ("anti_phase", True, False),
        ("asymmetric_palindrome", False, True),
        ("anti_palindrome", True, True),
    ],
)
def test_each_motif_has_its_signal(motif, mirror, reverse):
    best = find_signals(found_in(motif), mirror=mirror, reverse=reverse)[0]
    assert (best.mirror, best.reversed) == (mirror, reverse)
    assert best.cost < 0.2
    assert best.extent > 2.0
    assert (np.diff(best.path[:, 0]) > 0).all()
    assert (np.sign(np.diff(best.path[:, 1])) == (-1 if reverse else 1)).all()


@pytest.mark.parametrize(
    ("motif", "mirror", "reverse"),
    [
        ("symmetric_cycle", False, True),
        ("asymmetric_cycle", True, False),
        ("asymmetric_palindrome", True, True),
        ("anti_phase", False, True),
    ],
)
def test_what_a_movement_lacks_makes_no_signal_of_any_extent(motif, mirror, reverse):
    assert all(
        signal.extent < 1.5 for signal in find_signals(found_in(motif), mirror=mirror, reverse=reverse)
    )


def test_what_lies_between_two_rests_is_alike_or_no_signal():
    motion = compose_motif("sun salutation", seed=104).motion
    waypoints = find_waypoints(lm.compare_with_mirror(motion).distances)
    costs = [
        signal.cost
        for mirror in (False, True)
        for reverse in (False, True)
        for signal in find_signals(waypoints, mirror=mirror, reverse=reverse)
    ]
    assert max(costs) < 1
    assert lm.find_symmetry(motion).spans


def test_no_signal_runs_in_the_band_of_another():
    signals = find_signals(found_in("symmetric_palindrome"), mirror=False, reverse=False)
    cells = [set(map(tuple, signal.path.tolist())) for signal in signals]
    assert len(cells) > 1
    for k, one in enumerate(cells):
        for other in cells[k + 1 :]:
            assert min(max(abs(a - c), abs(b - d)) for a, b in one for c, d in other) > 3
