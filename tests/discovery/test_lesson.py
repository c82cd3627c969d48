"""The typical occurrence, and how the others differ from it."""

import itertools
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import leitmotion as lm
from leitmotion.discovery import Pattern, Patterns, align_occurrences, make_lesson, typical_occurrence
from leitmotion.features import FeatureSequence
from leitmotion.motion import ParameterError, Segmentation

RATE = 60.0


def hand(heights: list[np.ndarray], *, sideways: float = 0.0) -> FeatureSequence:
    """A hand that goes up and down beside a foot that stands; body sizes."""
    y = np.concatenate(heights)
    values = np.zeros((len(y), 6))
    values[:, 1], values[:, 0] = y, sideways
    return FeatureSequence(
        values, ("right_hand", "left_foot"), RATE, invariant_to=("place", "yaw"), width=3, scale=1.5
    )


def pattern(lengths: list[int], name: str = "A", start: int = 0) -> Pattern:
    """Occurrences one after the other."""
    borders = start + np.cumsum([0, *lengths])
    spans = Segmentation(borders[:-1], borders[1:], rate=RATE)
    return Pattern(name, "cyclic", spans, spans, 1.0, 0.0, 1.0)


def bump(height: float, frames: int = 60, *, at: float = 0.5) -> np.ndarray:
    """Up to a height and down again."""
    t = np.linspace(0, 1, frames)
    return height * np.interp(t, [0, at, 1], [0, 1, 0])


def test_the_typical_one_is_nearest_to_all_others() -> None:
    heights = [0.2, 0.9, 0.4, 0.35, 0.3]
    features = hand([bump(height) for height in heights])
    found = pattern([60] * 5)
    assert typical_occurrence(found, features) == 3
    costs = [
        np.mean([align_occurrences(found, min(k, m), max(k, m), features).cost for m in range(5) if m != k])
        for k in range(5)
    ]
    assert int(np.argmin(costs)) == 3


def test_of_two_the_first_is_typical() -> None:
    assert typical_occurrence(pattern([60, 60]), hand([bump(0.2), bump(0.9)])) == 0


def test_the_typical_one_does_not_depend_on_the_rate() -> None:
    features = hand([bump(height) for height in (0.2, 0.9, 0.4, 0.35, 0.3)])
    assert typical_occurrence(pattern([60] * 5), features[::2]) == 3


def test_occurrences_of_minutes_are_laid_over_one_another_in_bounded_memory() -> None:
    long, longer = round(200 * RATE), round(210 * RATE)
    turns = [np.linspace(0, 40 * np.pi, count) for count in (long, longer)]
    values = np.concatenate([np.stack((np.cos(t), np.sin(t), t / 20), axis=1) for t in turns])
    twice = FeatureSequence(values, ("hand",), RATE, ("place",), 3)
    tracemalloc.start()
    laid = align_occurrences(pattern([long, longer]), 0, 1, twice)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < long * longer  # at 30 moments a second, their distances alone
    meant = laid.path[:, 0] * longer / long + long
    np.testing.assert_allclose(laid.path[:, 1], meant, atol=8)


def test_of_very_many_the_typical_one_is_found_soon() -> None:
    heights = 0.3 + 0.1 * np.sin(np.arange(300.0))
    features = hand([bump(float(height), 30) for height in heights])
    found = typical_occurrence(pattern([30] * 300), features)
    assert abs(heights[found] - 0.3) < 0.03


def test_most_frequent_first_then_longest() -> None:
    features = hand([bump(0.3)] * 9)
    twice, thrice = pattern([60, 60], "A"), pattern([30, 30, 30], "B", 120)
    longer = pattern([60, 60, 60], "C", 300)
    steps = make_lesson(features, Patterns((twice, thrice, longer), (), RATE, {})).steps
    assert [(step.pattern, step.count) for step in steps] == [("C", 3), ("B", 3), ("A", 2)]
    assert [step.seconds for step in steps] == [3.0, 1.5, 2.0]


def test_every_occurrence_is_told_once_in_order_of_time() -> None:
    features = hand([bump(height) for height in (0.2, 0.9, 0.4, 0.35, 0.3)])
    (step,) = make_lesson(features, Patterns((pattern([60] * 5),), (), RATE, {})).steps
    assert [each.occurrence for each in step.variations] == [0, 1, 2, 4]
    assert sorted([step.start, *(each.start for each in step.variations)]) == [0, 60, 120, 180, 240]
    for one, two in itertools.pairwise(step.variations):
        assert one.stop <= two.start


def test_which_joint_differs_where_and_whereto() -> None:
    features = hand([bump(0.3), bump(0.3), bump(0.4)])
    (step,) = make_lesson(features, Patterns((pattern([60] * 3),), (), RATE, {})).steps
    same, higher = step.variations
    assert same.distance == pytest.approx(0.0, abs=1e-9)
    most, foot = higher.differences
    assert (most.joint, foot.joint) == ("right_hand", "left_foot")
    assert most.distance == pytest.approx(0.1, abs=0.02)
    assert most.phase == pytest.approx(0.5, abs=0.1)
    np.testing.assert_allclose(most.offset, [0.0, most.distance, 0.0], atol=1e-9)
    assert foot.distance == 0.0


def test_tempo_is_how_fast_not_how_long() -> None:
    features = hand([bump(0.3, 60), bump(0.3, 60), bump(0.3, 48), bump(0.3, 75)])
    (step,) = make_lesson(features, Patterns((pattern([60, 60, 48, 75]),), (), RATE, {})).steps
    of = {each.occurrence: each.tempo for each in step.variations} | {step.typical: 1.0}
    assert of[2] / of[3] == pytest.approx(75 / 48)
    assert of[2] == pytest.approx(60 / 48)


def test_what_comes_later_is_behind() -> None:
    features = hand([bump(0.3), bump(0.3), bump(0.3, at=0.7), bump(0.3, at=0.3)])
    (step,) = make_lesson(features, Patterns((pattern([60] * 4),), (), RATE, {})).steps
    same, later, earlier = step.variations
    assert same.lag_s == 0.0
    assert later.lag_s == pytest.approx(0.2, abs=0.05)
    assert earlier.lag_s == pytest.approx(-0.2, abs=0.05)
    assert later.lag_phase == pytest.approx(0.5, abs=0.15)


def test_an_uncertain_border_is_no_difference() -> None:
    """One cut comes a twentieth too late: what lies at the very ends is not told."""
    features = hand([bump(0.3)] * 3)
    spans = Segmentation([0, 60, 123], [60, 120, 180], rate=RATE)
    late = Pattern("A", "cyclic", spans, spans, 1.0, 0.0, 1.0)
    (step,) = make_lesson(features, Patterns((late,), (), RATE, {})).steps
    assert step.variations[1].differences[0].distance < 0.012


def test_moments_unseen_are_left_out() -> None:
    values = hand([bump(0.3), bump(0.3), bump(0.4)]).values.copy()
    values[140:160] = np.nan
    features = hand([bump(0.3)] * 3).replace(values=values)
    (step,) = make_lesson(features, Patterns((pattern([60] * 3),), (), RATE, {})).steps
    assert all(np.isfinite(each.distance) for each in step.variations)
    assert all(np.isfinite(one.distance) for each in step.variations for one in each.differences)


def test_nothing_recurs_nothing_to_learn() -> None:
    assert len(make_lesson(hand([bump(0.3)]), Patterns((), (), RATE, {}))) == 0


def test_what_are_no_places_or_end_too_soon_is_refused() -> None:
    found = Patterns((pattern([60] * 3),), (), RATE, {})
    turns = FeatureSequence(np.ones((180, 4)), ("hip",), RATE, width=4, unit="rad")
    with pytest.raises(ParameterError, match="compares where joints are"):
        make_lesson(turns, found)
    with pytest.raises(ParameterError, match=r"reaches to 3\.00 s, but the features cover 2\.00 s"):
        make_lesson(hand([bump(0.3)] * 2), found)


def test_a_lesson_is_saved_and_loaded(tmp_path) -> None:  # type: ignore[no-untyped-def]
    lesson = make_lesson(hand([bump(0.3)] * 3), Patterns((pattern([60] * 3),), (), RATE, {}))
    lm.save(lesson, tmp_path / "lesson.npz")
    assert lm.load(tmp_path / "lesson.npz") == lesson


def circling(cycles: float, *, frames: int = 60, begin: float = 0.0, slow: float = 1.0) -> np.ndarray:
    """A hand that goes round and up and down, from some phase on, (T, 3) body sizes."""
    t = 2 * np.pi * (begin + np.arange(round(cycles * frames * slow)) / (frames * slow))
    return np.stack([0.3 * np.cos(t), 0.2 * np.sin(2 * t + 0.4), 0.3 * np.sin(t)], axis=1)


def runs(*parts: np.ndarray) -> FeatureSequence:
    """Parts of one recording; the joint that is compared is the right hand."""
    whole = np.concatenate(parts)
    return FeatureSequence(whole, ("right_hand",), RATE, invariant_to=("place", "yaw"), width=3, scale=1.5)


@pytest.mark.parametrize(("begin", "slow"), [(0.3, 1.0), (0.6, 1.0), (0.25, 1.2)])
def test_a_run_cut_at_another_phase_differs_by_its_cut_alone(begin: float, slow: float) -> None:
    """Two runs of one circling; in the second the cuts lie at another phase, as a search may set them."""
    features = runs(circling(3), circling(3, begin=begin, slow=slow))
    starts = [0, 60, 120, 180 + round(60 * slow)]
    spans = Segmentation(starts, [60, 120, 180, starts[3] + round(60 * slow)], rate=RATE)
    (step,) = make_lesson(
        features, Patterns((Pattern("A", "cyclic", spans, spans, 1.0, 0.0, 1.0),), (), RATE, {})
    ).steps
    *same, cut = step.variations
    assert [each.shift_s for each in same] == [0.0, 0.0]
    assert cut.occurrence == 3
    behind = (0.5 - begin) % 1 - 0.5  # of a cycle
    assert cut.shift_s == pytest.approx(behind * slow * 60 / RATE, abs=0.07)
    assert cut.tempo == pytest.approx(1 / slow, abs=0.06)
    assert cut.distance < 0.025
    assert cut.differences[0].distance < 0.06
    assert abs(cut.lag_s) < 0.1


def test_what_differs_in_movement_is_not_taken_for_another_cut() -> None:
    features = hand([bump(0.3), bump(0.6), bump(0.3, at=0.3), bump(0.25)])
    (step,) = make_lesson(features, Patterns((pattern([60] * 4),), (), RATE, {})).steps
    assert {each.shift_s for each in step.variations} == {0.0}
    for each in step.variations:
        assert (each.path[0, 1], each.path[-1, 1]) == pytest.approx((each.start, each.stop - 1), abs=2)


@given(st.lists(st.integers(2, 90), min_size=2, max_size=5), st.integers(0, 2**32 - 1))
@settings(max_examples=30, deadline=None)
def test_any_lengths_make_a_lesson_within_the_recording(lengths: list[int], seed: int) -> None:
    values = np.random.default_rng(seed).normal(size=(sum(lengths), 3)).cumsum(axis=0)
    values[np.random.default_rng(seed).random(len(values)) < 0.1] = np.nan
    (step,) = make_lesson(runs(values), Patterns((pattern(lengths),), (), RATE, {})).steps
    for each in step.variations:
        assert each.path.min() >= 0
        assert each.path.max() < len(values)
        assert (np.diff(each.path, axis=0) >= 0).all()
        assert each.tempo > 0


@pytest.mark.data
def test_two_runs_of_a_walk_cut_half_a_cycle_apart(data: Path) -> None:
    """CMU 86_01: the first run is cut a step away from the others; no ankle is 40 cm off."""
    features = lm.features.posture(lm.embody(lm.read(data / "cmu86" / "86_01.amc")))
    spans = Segmentation([84, 312, 2544, 2760, 2988], [312, 492, 2760, 2988, 3228], rate=120)
    walk = Pattern("A", "cyclic", spans, spans, 1.9, 0.0, 1.0)
    (step,) = make_lesson(features, Patterns((walk,), (), 120.0, {})).steps
    moved = [each.shift_s for each in step.variations if each.occurrence < 2]
    assert moved == pytest.approx([1.0, -0.75], abs=0.15)
    assert all(each.shift_s == 0.0 for each in step.variations if each.occurrence >= 2)
    for each in step.variations:
        assert each.distance * features.scale < 0.035
        assert max(one.distance for one in each.differences) * features.scale < 0.25
