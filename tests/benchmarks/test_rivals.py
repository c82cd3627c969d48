"""Laws of the comparison with other engines: each answer becomes sets of stretches, and is judged as any other."""

import importlib
from pathlib import Path

import numpy as np
import pytest

from leitmotion.evaluation import PatternScores, PatternTruth, evaluate_patterns
from leitmotion.motion import Segmentation

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"
RUNS = Segmentation([0, 40, 80, 120], [40, 80, 120, 160], ("kick", "squat", "kick", "squat"), rate=30)


@pytest.fixture
def engines(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("engines")


@pytest.fixture
def rivals(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("bench_rivals")


def judged(engines, sets):
    return evaluate_patterns(PatternTruth(RUNS), engines.found_patterns(sets, 30.0))


def test_motif_sets_with_representatives_count_each_motif_once(engines):
    answer = [
        ((0, 40), [(np.int32(0), np.int32(40)), (80, 120)]),
        ((120, 160), [(120, 160), (40, 80)]),
    ]
    sets = engines.of_locomotif(answer)
    assert sets == [[(0, 40), (80, 120)], [(40, 80), (120, 160)]]
    scores = judged(engines, sets)
    assert (scores.pairs, scores.wrong_pairs, scores.f1) == (2, 0, 1.0)


def test_starts_of_matches_become_windows_and_padding_none(engines):
    sets = engines.of_stumpy(np.array([[80, 0, 118], [121, 41, -1]]), 38)
    assert sets == [[(0, 38), (80, 118), (118, 156)], [(41, 79), (121, 159)]]
    scores = judged(engines, sets)
    assert (scores.pairs, scores.wrong_pairs, scores.missed_pairs) == (4, 2, 0)


def test_no_set_is_an_answer(engines):
    scores = judged(engines, [])
    assert (scores.pairs, scores.missed, scores.missed_pairs) == (0, ("kick", "squat"), 2)


def test_a_match_is_nearer_than_most_but_the_nearest_always_counts(engines):
    distances = np.array([1.0, 2.0, np.inf, 3.0, 2.0])
    assert engines.within(distances, 0.0) == 2.0
    assert engines.within(distances, 9.0) == 1.0


def test_each_column_or_all_values_get_deviation_one(engines):
    values = np.random.default_rng(0).normal(size=(50, 3)) * [1.0, 10.0, 0.0] + 4.0
    columns = engines.scaled(values, "columns")
    assert np.allclose(columns.std(axis=0), [1, 1, 0])
    whole = engines.scaled(values, "whole")
    assert whole.std() == pytest.approx(1.0)
    assert whole[:, 1].std() / whole[:, 0].std() == pytest.approx(values[:, 1].std() / values[:, 0].std())


def test_who_did_not_answer_is_told_and_left_out_of_the_ratio(rivals):
    ours = [rivals.Answer(PatternScores(pairs=4, true_pairs=4), 1.0), rivals.Answer(PatternScores(), 5.0)]
    theirs = [rivals.Answer(PatternScores(pairs=4, wrong_pairs=2, true_pairs=4), 30.0), None]
    quality, cost = rivals.told("stumpy", 3000, theirs, ours, "two")
    assert "no answer within 600 s on 1 of 2" in quality[2]
    assert cost[1] == "30.00 s, 30.0 x ours"
    (nothing,) = rivals.told("stumpy", 3000, [None, None], ours, "two")
    assert nothing[1] == "no answer within 600 s on 2 of 2"


@pytest.mark.data
def test_recordings_strung_together_keep_every_repetition_where_it_is(monkeypatch, data):
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    joined, strung = (importlib.import_module(name) for name in ("joined", "strung"))
    one = strung.strung("cmu-02", 0, 1000)
    made = joined.joined("cmu-02/00")
    from leitmotion import body, features

    alone = features.resample(features.posture(body.embody(made.motion)), strung.RATE)
    assert 800 < len(one.postures) <= 1000
    assert one.postures.values.shape == (one.truth.repetitions.stops[-1], 45)
    first = made.truth.repetitions
    known = len(first)
    assert one.truth.repetitions.labels[:known] == first.labels
    assert np.abs(one.truth.repetitions.starts[:known] - first.starts / 4).max() <= 0.5
    assert np.allclose(one.postures.values[: len(alone)], alone.values, atol=0.02)
