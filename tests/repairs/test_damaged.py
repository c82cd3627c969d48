"""Damage: however little of a person is seen, `info` answers, and without a warning of its own."""

import itertools

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.motion import Trajectories, joint_points

NAN = np.nan


def briefly(positions, rng):
    """Each point in a few frames of its own."""
    seen = np.full_like(positions, NAN)
    for point in range(positions.shape[1]):
        start, count = rng.integers(len(positions)), rng.integers(1, 30)
        seen[start : start + count, point] = positions[start : start + count, point]
    return seen


def one_briefly(positions, rng):
    """All points but one all the time."""
    point, start = rng.integers(positions.shape[1]), rng.integers(len(positions))
    seen = positions.copy()
    seen[:, point] = NAN
    seen[start : start + 12, point] = positions[start : start + 12, point]
    return seen


def one_point(positions, rng):
    return np.where((np.arange(positions.shape[1]) == 4)[:, None], positions, NAN)


def one_frame(positions, rng):
    return np.where((np.arange(len(positions)) == len(positions) // 2)[:, None, None], positions, NAN)


def nothing(positions, rng):
    return np.full_like(positions, NAN)


def by_turns(positions, rng):
    """No two neighbouring points in the same frame."""
    even = np.add.outer(np.arange(len(positions)), np.arange(positions.shape[1])) % 2 == 0
    return np.where(even[..., None], positions, NAN)


def holes(positions, rng):
    return np.where(rng.random(positions.shape[:2])[..., None] < 0.2, positions, NAN)


def single_numbers(positions, rng):
    return np.where(rng.random(positions.shape) < 0.7, positions, NAN)


def no_height(positions, rng):
    return np.where(np.arange(positions.shape[2]) == 1, NAN, positions)


def constant(positions, rng):
    return np.repeat(positions[:1], len(positions), axis=0)


def all_in_one_place(positions, rng):
    return np.repeat(positions[:, :1], positions.shape[1], axis=1)


def zero(positions, rng):
    return np.zeros_like(positions)


def coarse(positions, rng):
    return np.round(positions, 1)


DAMAGE = (briefly, one_briefly, one_point, one_frame, nothing, by_turns, holes, single_numbers, no_height, constant,
          all_in_one_place, zero, coarse)  # fmt: skip


@pytest.fixture(scope="module")
def person():
    return joint_points(lm.compose_session(seed=0, rate=60.0).motion)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("damage", DAMAGE, ids=lambda damage: damage.__name__)
def test_info_answers(person, rng, damage):
    for frames, components, unit in itertools.product((1, 2, 3, 5, 90), (2, 3), ("m", "px", "relative")):
        whole = person.positions[200 : 200 + frames, :, :components]
        told = lm.info(Trajectories(person.names, damage(whole, rng), rate=person.rate, unit=unit))
        assert (told.frames, told.dimensions) == (frames, components)


@pytest.mark.filterwarnings("error")
def test_info_answers_where_a_toe_is_seen_briefly_in_a_long_recording(person, rng):
    """Who stands for minutes tells the floor by more moments than are looked at."""
    names = [name for name in person.names if "Arm" not in name and "Hand" not in name]
    place = [person.names.index(name) for name in names]
    stood = person.positions[0, place] + rng.normal(scale=1e-4, size=(20_000, len(names), 3))
    toe = names.index("LeftToeBase")
    for frames in range(19_960, 20_000, 7):
        positions = stood[:frames].copy()
        positions[:, toe] = NAN
        positions[500:512, toe] = stood[500:512, toe]
        told = lm.info(Trajectories(tuple(names), positions, rate=60))
        assert told.unseen == pytest.approx((frames - 12) / frames / len(names))
