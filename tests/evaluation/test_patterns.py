"""Laws of the protocol by which patterns are judged, and its cases by hand."""

import math

import numpy as np
import pytest

from leitmotion.evaluation import (
    FoundPatterns,
    PatternTruth,
    evaluate_patterns,
    interval,
    linked,
    owners,
    pool,
)
from leitmotion.motion import ParameterError, Segmentation

RATE = 100.0


def spans(*rows):
    starts, stops, labels = zip(*rows, strict=True)
    return Segmentation(starts, stops, labels, rate=RATE)


WALKS = spans((0, 400, "walk"), (400, 600, "kick"), (600, 1000, "walk"))
NOTHING = FoundPatterns(Segmentation([], [], rate=RATE))


def test_the_truth_itself_is_right_in_everything():
    truth = PatternTruth(WALKS, cycles=[[1, 1, 1]] * 3)
    scores = evaluate_patterns(truth, FoundPatterns(spans((0, 400, "A"), (600, 1000, "A"))))
    assert (scores.type_one, scores.type_two, scores.precision, scores.recall, scores.f1) == (0, 0, 1, 1, 1)
    assert (scores.paper_type_one, scores.paper_type_two) == (0, 0)
    assert scores.border_error_s == 0
    assert [run.found for run in scores.counts] == [1, 0, 1]
    assert scores.stray_patterns == 0


def test_finding_nothing_misses_everything_and_is_never_wrong():
    scores = evaluate_patterns(PatternTruth(WALKS), NOTHING)
    assert (scores.pairs, scores.missed, scores.true_pairs, scores.missed_pairs) == (0, ("walk",), 1, 1)
    assert math.isnan(scores.type_one)
    assert (scores.type_two, scores.f1, scores.paper_type_two) == (1, 0, 1)


@pytest.mark.parametrize(("stop", "owner"), [(500, "walk"), (501, None)])
def test_a_stretch_belongs_by_80_percent_of_its_frames(stop, owner):
    assert owners(PatternTruth(WALKS), [[0, stop]]) == [owner]


def test_unlabelled_frames_carry_no_label_but_count_as_frames():
    truth = PatternTruth(WALKS, unlabelled=[[350, 450]])
    assert owners(truth, [[0, 400], [0, 437], [0, 438]]) == ["walk", "walk", None]


@pytest.mark.parametrize(
    ("stop", "cycles", "recurs"),
    [
        (300, (2, 1, 3), True),
        (299, (2, 1, 3), False),  # shorter than 3 s
        (300, (1, 1, 2), False),
        (300, (np.nan,) * 3, False),  # nobody counted
        (300, (np.nan, 2, np.inf), True),
    ],
)
def test_one_run_recurs_when_it_is_long_and_two_cycles_are_seen(stop, cycles, recurs):
    truth = PatternTruth(spans((0, stop, "jog")), cycles=[cycles])
    assert truth.recurring == (("jog",) if recurs else ())


def test_runs_that_touch_are_not_separate():
    assert PatternTruth(spans((0, 100, "hop"), (100, 200, "hop"))).recurring == ()
    assert PatternTruth(spans((0, 100, "hop"), (101, 200, "hop"))).recurring == ("hop",)


def test_two_repetitions_that_are_known_exactly_recur_however_short():
    truth = PatternTruth(spans((0, 150, "hop")), repetitions=spans((0, 70, "hop"), (80, 150, "hop")))
    assert truth.recurring == ("hop",)
    assert truth.cyclic.tolist() == [True]


def test_a_pair_is_wrong_when_its_stretches_belong_to_different_actions_or_to_none():
    pairs = [[0, 200, 600, 800], [0, 200, 400, 600], [300, 500, 600, 800], [2000, 2100, 0, 100]]
    scores = evaluate_patterns(PatternTruth(WALKS), FoundPatterns(WALKS[:0], pairs))
    assert (scores.pairs, scores.wrong_pairs, scores.unfounded_pairs) == (4, 3, 0)
    assert scores.type_one == 0.75


def test_a_pair_within_an_action_that_does_not_recur_is_unfounded():
    scores = evaluate_patterns(PatternTruth(WALKS), FoundPatterns(WALKS[:0], [[400, 500, 500, 600]]))
    assert (scores.wrong_pairs, scores.unfounded_pairs, scores.precision) == (0, 1, 0)


@pytest.mark.parametrize(("cycles", "unfounded"), [((1, 1, 1), 1), ((np.nan,) * 3, 0), ((3, 3, 3), 0)])
def test_where_nobody_counted_nobody_knows_whether_a_pair_is_unfounded(cycles, unfounded):
    truth = PatternTruth(spans((0, 400, "walk")), cycles=[cycles])
    scores = evaluate_patterns(truth, FoundPatterns(WALKS[:0], [[0, 100, 100, 200]]))
    assert (scores.wrong_pairs, scores.unfounded_pairs) == (0, unfounded)
    assert truth.uncertain == (("walk",) if np.isnan(cycles[0]) else ())


@pytest.mark.parametrize(("covered", "missed"), [(400, ()), (399, ("walk",))])
def test_an_action_is_found_by_half_of_its_frames(covered, missed):
    found = FoundPatterns(spans((0, covered // 2, "A"), (600, 600 + covered - covered // 2, "A")))
    assert evaluate_patterns(PatternTruth(WALKS), found).missed == missed


def test_occurrences_that_belong_to_nothing_find_nothing():
    found = FoundPatterns(spans((0, 501, "A"), (499, 1000, "A")))
    scores = evaluate_patterns(PatternTruth(WALKS), found)
    assert scores.missed == ("walk",)
    assert scores.stray_patterns == 1


def test_borders_are_those_of_the_first_start_and_the_last_stop_in_a_run():
    found = FoundPatterns(spans((20, 200, "A"), (200, 390, "A"), (590, 1010, "A")))
    scores = evaluate_patterns(PatternTruth(WALKS), found)
    assert scores.start_errors_s == pytest.approx((0.2, -0.1))
    assert scores.stop_errors_s == pytest.approx((-0.1, 0.1))
    assert scores.border_error_s == pytest.approx(0.125)


def test_inner_borders_may_lie_anywhere_between_two_repetitions():
    truth = PatternTruth(
        spans((0, 330, "hop")),
        cycles=[[3, 3, 3]],
        repetitions=spans((0, 100, "hop"), (110, 210, "hop"), (230, 330, "hop")),
    )
    found = FoundPatterns(spans((0, 105, "A"), (105, 200, "A"), (240, 330, "A")))
    assert evaluate_patterns(truth, found).inner_errors_s == pytest.approx((0, 0.1))


def test_a_count_is_that_of_the_pattern_that_covers_most_of_the_run():
    found = FoundPatterns(
        spans((0, 200, "A"), (200, 400, "A"), (0, 50, "B"), (50, 100, "B"), (100, 150, "B"))
    )
    truth = PatternTruth(WALKS, cycles=[[3, 2, 4], [1, 1, 1], [2, 2, 2]])
    counts = evaluate_patterns(truth, found).counts
    assert [run.found for run in counts] == [2, 0, 0]
    assert [run.within for run in counts] == [True, False, False]
    assert [run.judged for run in counts] == [True, False, True]  # the kick is done once


@pytest.mark.parametrize("pieces", [1, 2, 5, 40])
def test_one_long_pair_and_many_short_ones_that_cover_the_same_are_worth_the_same(pieces):
    ends = np.linspace(0, 400, pieces + 1).astype(int)
    pairs = np.stack((ends[:-1], ends[1:], 600 + ends[:-1], 600 + ends[1:]), axis=1)
    half = pairs[: math.ceil(pieces / 2)]
    assert linked(PatternTruth(WALKS), pairs) == {(0, 2): True}
    assert linked(PatternTruth(WALKS), half) == {(0, 2): True}


def test_the_shorter_run_decides_whether_two_are_linked():
    truth = PatternTruth(spans((0, 100, "walk"), (200, 2200, "walk")))
    assert linked(truth, [[0, 50, 1000, 1050]]) == {(0, 1): True}
    assert linked(truth, [[0, 49, 1000, 1049]]) == {(0, 1): False}
    assert linked(truth, [[1000, 1050, 0, 50]]) == {(0, 1): True}


def test_a_cyclic_run_is_linked_with_itself():
    truth = PatternTruth(spans((0, 400, "jog")), cycles=[[4, 4, 4]])
    assert linked(truth, [[0, 100, 100, 200]]) == {(0, 0): True}
    assert linked(truth, [[0, 99, 100, 199]]) == {(0, 0): False}


def test_a_long_pair_links_every_two_runs_that_its_path_passes():
    truth = PatternTruth(spans((0, 100, "walk"), (150, 250, "walk"), (500, 600, "walk"), (650, 750, "walk")))
    links = linked(truth, [[0, 250, 500, 750]])
    assert [pair for pair, link in links.items() if link] == [(0, 2), (1, 3)]


def test_figures_do_not_depend_on_the_order_of_what_was_found():
    rng = np.random.default_rng(0)
    starts = rng.integers(0, 900, 30)
    found = Segmentation(
        starts, starts + rng.integers(20, 90, 30), tuple(rng.choice(["A", "B"], 30)), rate=RATE
    )
    pairs = FoundPatterns(found).pairs
    order = rng.permutation(30)
    shuffled = found.replace(
        starts=found.starts[order], stops=found.stops[order], labels=tuple(found.labels[k] for k in order)
    )
    truth = PatternTruth(WALKS, cycles=[[3, 3, 3]] * 3)
    once = evaluate_patterns(truth, FoundPatterns(found, pairs))
    again = evaluate_patterns(
        truth, FoundPatterns(shuffled, pairs[rng.permutation(len(pairs))][:, [2, 3, 0, 1]])
    )
    assert once == again


def test_figures_do_not_depend_on_the_rate():
    def scores(factor):
        def faster(held):
            return held.replace(
                starts=held.starts * factor, stops=held.stops * factor, rate=held.rate * factor
            )

        found = spans((20, 200, "A"), (200, 390, "A"), (590, 1010, "A"))
        truth = PatternTruth(faster(WALKS), unlabelled=np.array([[390, 410]]) * factor)
        return evaluate_patterns(truth, FoundPatterns(faster(found)))

    slow, fast = scores(1), scores(3)
    assert slow.start_errors_s == pytest.approx(fast.start_errors_s)
    assert (slow.type_one, slow.missed, slow.f1) == (fast.type_one, fast.missed, fast.f1)


def test_pooled_figures_are_those_of_all_counts_together():
    truth = PatternTruth(WALKS)
    good = evaluate_patterns(truth, FoundPatterns(spans((0, 400, "A"), (600, 1000, "A"))))
    bad = evaluate_patterns(truth, FoundPatterns(WALKS[:0], [[0, 200, 400, 600]] * 3))
    both = pool([good, bad])
    assert (both.type_one, both.type_two) == (0.75, 0.5)
    assert pool([good]) == good
    assert pool([]).pairs == 0


def test_an_interval_holds_the_figure_and_is_the_same_every_time():
    truth = PatternTruth(WALKS)
    some = [
        evaluate_patterns(
            truth, FoundPatterns(WALKS[:0], [[0, 200, 600, 800]] * right + [[0, 200, 400, 600]])
        )
        for right in (1, 3, 9, 9)
    ]
    low, high = interval(some, "type_one")
    assert low < pool(some).type_one < high
    assert interval(some, "type_one") == (low, high)
    assert all(map(math.isnan, interval(some[:1], "type_one")))
    with pytest.raises(ParameterError, match="measure must be one of type_one"):
        interval(some, "type_three")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: PatternTruth(spans((0, 20, "a"), (10, 30, "b"))), "in order without overlap"),
        (lambda: PatternTruth(WALKS, cycles=[[1, 1, 1]]), "must have shape"),
        (lambda: FoundPatterns(WALKS, [[0, 10, 20, 20]]), "must start at frame 0 or later and stop after"),
        (
            lambda: evaluate_patterns(PatternTruth(WALKS), FoundPatterns(WALKS.replace(rate=30.0))),
            "at 100 Hz",
        ),
    ],
)
def test_what_makes_no_truth_or_answer_is_refused(make, message):
    with pytest.raises(ParameterError, match=message):
        make()


def test_frames_without_a_label_may_be_left_aside():
    runs = Segmentation([0, 100], [100, 200], ("walk", "kick"), rate=30)
    truth = PatternTruth(runs, unlabelled=[[80, 120]], cycles=[[2, 2, 2], [1, 1, 1]])
    found = FoundPatterns(Segmentation([0, 45], [45, 100], ("A", "A"), rate=30))
    assert evaluate_patterns(truth, found).wrong_pairs == 1  # the second is walk by 64 %
    assert evaluate_patterns(truth, found, unlabelled="aside").wrong_pairs == 0
    mostly_open = FoundPatterns(Segmentation([0, 75], [45, 110], ("A", "A"), rate=30))
    assert evaluate_patterns(truth, mostly_open, unlabelled="aside").wrong_pairs == 1
    with pytest.raises(ParameterError, match="against or aside"):
        evaluate_patterns(truth, found, unlabelled="ignored")
