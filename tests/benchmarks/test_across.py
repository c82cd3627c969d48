"""Folders of the benchmark of patterns across recordings: who is fitted on is not reported."""

import importlib
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


@pytest.fixture
def across(monkeypatch, data):
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("bench_across")


@pytest.mark.data
def test_no_pair_that_is_reported_was_fitted_on(across):
    for kind in across.SETS:
        fitted = {clip.name for number in range(20) for clip in across.folder(kind, "fit", number)}
        for number in range(20):
            clips = across.folder(kind, "report", number)
            assert not fitted & {clip.name for clip in clips}
            assert clips == across.folder(kind, "report", number)
            pairs = across.counted(kind, "report", clips)
            assert (pairs == pairs.T).all()
            for a, b in combinations(range(len(clips)), 2):
                actors = {clips[a].actor, clips[b].actor}
                if pairs[a, b]:
                    assert not actors <= set(across.SETS[kind]["fit"])
                    assert len(actors) == (1 if kind == "one actor" else 2)


@pytest.mark.data
def test_a_cheap_answer_joins_as_many_pairs_as_are_of_one_class(across):
    clips = across.folder("three actors", "report", 0)
    among = across.counted("three actors", "report", clips)
    joined = across.nearest(across.at_random(clips), clips, among)
    hits, same, wrong, other = across.scores(clips, joined, among)
    assert hits + wrong == same == 8
    assert other == 24
    assert not (joined & ~among).any()
    truth = np.array([[a.label == b.label for b in clips] for a in clips])
    assert across.scores(clips, truth, among) == (8, 8, 0, 24)
