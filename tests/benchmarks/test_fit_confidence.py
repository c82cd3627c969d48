"""What the confidence is fitted on: the same patterns that a user is told of, with what speaks for each."""

import importlib
from pathlib import Path

import numpy as np
import pytest

from leitmotion import find_patterns
from leitmotion.datasets import compose_session
from leitmotion.discovery.confidence import confidence
from leitmotion.evaluation import PatternTruth

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


@pytest.fixture
def fitting(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("fit_confidence")


@pytest.fixture(scope="module")
def session():
    return compose_session(seed=0)


def test_the_evidence_is_that_of_what_a_user_is_told(fitting, session):
    told, found = find_patterns(session.motion), fitting.written(session.motion)
    assert found.patterns == told.patterns
    assert found.pairs == told.pairs
    assert [round(confidence(each), 3) for each in found.evidence] == [p.confidence for p in told.patterns]


def test_patterns_are_judged_by_the_share_of_their_pairs_within_one_action(fitting, session):
    truth = PatternTruth(session.stretches)
    judged = list(fitting.judged_in("nobody", session.motion, truth))
    assert {each.actor for each in judged} == {"nobody"}
    assert [each.share for each in judged] == [1.0] * len(find_patterns(session.motion))
    elsewhere = truth.replace(runs=session.stretches.replace(starts=session.stretches.stops - 1))
    assert {each.share for each in fitting.judged_in("nobody", session.motion, elsewhere)} == {0.0}


def test_the_regression_finds_the_weights_that_made_its_answers(fitting, rng, monkeypatch):
    monkeypatch.setattr(fitting, "PENALTY", 0.0)
    weights = np.array([0.5, 1.0, -2.0, 0.7])
    x = rng.normal(size=(20_000, 3))
    right = rng.random(len(x)) < fitting.probability(x, weights)
    np.testing.assert_allclose(fitting.fit(x, right), weights, atol=0.1)


def test_each_actor_is_told_by_weights_fitted_on_the_others(fitting, monkeypatch, capsys, rng):
    made = [
        fitting.Judged(actor, float(rng.random()), fitting.Evidence(*rng.uniform(0.2, 1, 3)))
        for actor in "abc"
        for _ in range(20)
    ]
    monkeypatch.setattr(fitting, "fit_set", lambda: tuple(made))
    fitted_on = []
    usual = fitting.fit

    def fit(x, right):
        fitted_on.append(len(x))
        return usual(x, right)

    monkeypatch.setattr(fitting, "fit", fit)
    fitting.main()
    assert sorted(fitted_on) == [40, 40, 40, 60]
    said = capsys.readouterr().out
    assert f"{fitting.WEIGHTS} = " in said
    assert "FITTED = (" in said
