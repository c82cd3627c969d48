"""Strikes: what is stopped or thrown back at once, and nothing that turns as arms and legs do."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.discovery.spikes import find_strikes
from oracles import body as oracle
from oracles import motifs as made


def punches(stopped_s, *, times=3):
    """The left arm is thrown forward, ever faster, stopped within some seconds, and drawn back slowly."""
    out = np.linspace(0.0, 1.0, 15) ** 2
    slope = out[-1] - out[-2]
    stop = np.cumsum(np.linspace(slope, 0.0, max(int(stopped_s * made.RATE), 1)))
    way = np.concatenate((out, out[-1] + stop))
    back = way[-1] * made.ease(60)[::-1]
    once = np.concatenate((np.zeros(30), way, back))
    raised = np.tile(once / once.max(), times)
    struck = 30 + len(out) - 1 + len(once) * np.arange(times)
    return np.stack((1.3 * raised, 2.2 * raised), axis=1), struck


def both(arms):
    return made.human_doing(arms)


def test_a_strike_is_told_where_it_lands():
    arms, struck = punches(0.03)
    strikes = lm.find_symmetry(both(arms)).strikes
    assert len(strikes) == len(struck)
    assert np.abs(strikes - struck).max() <= 6


def test_the_same_way_braked_slowly_is_none():
    arms, _ = punches(0.5)
    assert len(lm.find_symmetry(both(arms)).strikes) == 0


def test_mirror_and_place_do_not_matter():
    motion = both(punches(0.03)[0])
    strikes = lm.find_symmetry(motion).strikes
    for same in (oracle.mirrored(motion), oracle.moved(motion, yaw=2.0, by=(1.0, 0.0, 2.0))):
        assert np.array_equal(lm.find_symmetry(same).strikes, strikes)


@pytest.mark.parametrize("motif", made.MOVEMENTS)
def test_what_turns_smoothly_is_none(motif):
    assert len(lm.find_symmetry(made.movement(motif)).strikes) == 0


def test_of_few_moments_a_second_nothing_is_told():
    distances = lm.compare_with_mirror(both(punches(0.03)[0])).distances
    thin = distances.replace(own=distances.own[::3, ::3], mirror=distances.mirror[::3, ::3], rate=10.0)
    assert len(find_strikes(distances)) > 0
    assert len(find_strikes(thin)) == 0


@pytest.mark.data
def test_punches_and_kicks_are_strikes_and_walks_and_jumping_jacks_are_none(data):
    fight = lm.find_symmetry(lm.read(data / "cmu86" / "86_01.amc"))
    seconds = fight.strikes / fight.rate
    borders = np.array([4.6, 9.6, 16.5, 21.0, 26.9, 33.6, 38.2])  # walk, jump, walk, punch, walk, kick, punch
    assert (np.searchsorted(borders, seconds) >= 3).all()
    assert {3, 5, 6} == set(np.searchsorted(borders, seconds).tolist())
    for calm in ("cmu_bvh/jumping_jacks.bvh", "bandai_namco/dataset-1_walk_normal_001.bvh"):
        assert len(lm.find_symmetry(lm.read(data / calm)).strikes) == 0
