"""What the page shows of much: laws of the choice."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.discovery import Pattern
from leitmotion.motion import Segmentation
from leitmotion.view.choose import choose_key, choose_strips, find_nearest, floor_height, look_across


def circle(count: int, period: int) -> np.ndarray:
    """Distances of a point that goes round and round."""
    angle = 2 * np.pi * np.arange(count) / period
    points = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return np.linalg.norm(points[:, None] - points[None], axis=2).astype(np.float32)


def test_nearest_moments_are_near_and_apart() -> None:
    distances = circle(600, 70)
    frames, found = find_nearest(distances, 30.0, cap=0.5)
    assert frames.shape == found.shape == (600, 3)
    for row in range(600):
        here = frames[row][frames[row] >= 0]
        moments = np.sort([row, *here])
        assert np.diff(moments).min(initial=99) >= 27
        assert (distances[row, here] <= 0.5).all()
        assert np.all(np.diff(found[row][: len(here)]) >= 0)


def test_nearest_finds_the_same_posture_a_round_away() -> None:
    frames, found = find_nearest(circle(600, 60), 30.0, cap=0.1)
    assert frames[300, 0] % 60 == 0
    assert found[300] == pytest.approx(0, abs=1e-5)


def test_nothing_is_near_beyond_the_cap_or_unknown() -> None:
    alone = np.full((100, 100), 5.0, dtype=np.float32)
    assert (find_nearest(alone, 30.0, cap=1.0)[0] == -1).all()
    unknown = np.full((100, 100), np.nan, dtype=np.float32)
    assert (find_nearest(unknown, 30.0, cap=1.0)[0] == -1).all()


def test_nearest_agrees_with_a_naive_search(rng: np.random.Generator) -> None:
    values = rng.random((80, 80)).astype(np.float32)
    frames, _ = find_nearest(values, 10.0, cap=0.9)
    for row in range(80):
        free = np.ones(80, dtype=bool)
        free[max(row - 8, 0) : row + 9] = False
        for k in range(3):
            best = np.where(free, values[row], np.inf).argmin()
            assert frames[row, k] == best
            free[max(best - 8, 0) : best + 9] = False


@settings(max_examples=25, deadline=None)
@given(st.integers(40, 500), st.integers(0, 1000))
def test_strips_stand_in_order_and_apart(count: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    walk = rng.normal(size=(count, 2)).cumsum(axis=0)
    distances = np.linalg.norm(walk[:, None] - walk[None], axis=2)
    for frames in choose_strips(distances, (3, 7, 14)):
        stride = max(1, count // 360)
        assert np.diff(frames).min() >= int(0.955 * (count / len(frames) - stride)) - stride
        assert frames[0] >= 0
        assert frames[-1] < count


def test_a_strip_prefers_postures_that_differ() -> None:
    values = np.zeros(100)
    values[40:44] = 1.0
    chosen = choose_strips(np.abs(values[:, None] - values[None]), (8,))[0]
    assert values[chosen].max() == 1.0


def test_the_key_posture_is_least_like_the_rest() -> None:
    height = np.zeros(300)
    height[100:200] = np.sin(np.linspace(0, 2 * np.pi * 2, 100)) ** 2
    distances = np.abs(height[:, None] - height[None])
    cycles = Segmentation([100, 150], [150, 200], scores=[0.2, 0.9], rate=30.0)
    pattern = Pattern("A", "cyclic", cycles, Segmentation([100], [200], rate=30.0), 1.6, 0.0, 0.9)
    key = choose_key(pattern, distances, 30.0)
    assert 150 <= key < 200
    assert height[key] > 0.95


def test_the_floor_lies_under_the_feet(rng: np.random.Generator) -> None:
    drawn = rng.random((100, 5, 3)) + np.array([0, 2, 0])
    drawn[:, 0, 1] = 1.5
    drawn[3] = np.nan
    assert floor_height(drawn, 1.0) == pytest.approx(1.5 - 0.026)
    assert floor_height(np.full((4, 2, 3), np.nan), 1.0) == 0.0


def test_the_room_camera_stands_beside_a_long_way() -> None:
    drawn = np.zeros((100, 2, 3))
    drawn[..., 2] = np.linspace(0, 5, 100)[:, None]
    yaw = look_across(drawn, np.zeros(100))
    assert abs(np.sin(yaw)) > 0.8
    here = look_across(drawn * 0.01, np.zeros(100))
    assert 0.3 < here < 1.0
    assert look_across(np.full((4, 2, 3), np.nan), np.zeros(4)) == 0.0
