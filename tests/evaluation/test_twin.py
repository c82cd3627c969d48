"""The protocol agrees with its twin, which looks at one frame after another."""

import itertools

import numpy as np
import pytest

from leitmotion.evaluation import FoundPatterns, PatternTruth, evaluate_patterns, linked, owners
from leitmotion.motion import Segmentation
from oracles import pattern_protocol as twin

FRAMES = 240


@pytest.fixture(params=range(12))
def drawn(request):
    """Runs, unlabelled spans, occurrences and pairs at random."""
    rng = np.random.default_rng(request.param)
    ends = np.sort(rng.choice(np.arange(1, FRAMES), size=6, replace=False))
    runs = [
        (int(a), int(b), str(rng.choice(["walk", "kick", ""])))
        for a, b in itertools.pairwise(ends)
        if rng.uniform() < 0.9
    ]
    unlabelled = [(int(a), int(a) + int(rng.integers(1, 12))) for a in rng.integers(0, FRAMES - 20, 3)]

    def near_runs(count):
        chosen = [runs[k] for k in rng.integers(0, len(runs), count)]
        spans = [(max(0, a + int(rng.integers(-6, 7))), b + int(rng.integers(-6, 7))) for a, b, _ in chosen]
        return [(a, max(a + 1, b)) for a, b in spans]

    pairs = [(*a, *b) for a, b in zip(near_runs(25), near_runs(25))]
    return runs, unlabelled, near_runs(8), pairs


def test_every_figure_is_that_of_the_twin(drawn):
    runs, unlabelled, occurrences, pairs = drawn
    starts, stops, labels = zip(*runs)
    truth = PatternTruth(
        Segmentation(starts, stops, labels, rate=30), unlabelled=unlabelled, cycles=[[2, 2, 2]] * len(runs)
    )
    spans = Segmentation(*zip(*sorted(occurrences)), rate=30)
    scores = evaluate_patterns(truth, FoundPatterns(spans, pairs))
    assert owners(truth, occurrences) == [twin.owner(*span, runs, unlabelled) for span in occurrences]
    assert scores.wrong_pairs == twin.wrong(pairs, runs, unlabelled)
    assert set(scores.missed) == {
        action
        for action in truth.recurring
        if not twin.found(action, occurrences, runs, unlabelled, FRAMES + 20)
    }
    right = [pair for pair in pairs if not twin.wrong([pair], runs, unlabelled)]
    links = linked(truth, right)
    assert links == {(k, m): twin.link(k, m, right, runs, unlabelled) for k, m in links}
    assert scores.missed_pairs == sum(not link for link in links.values())


def test_the_twin_tells_a_link_from_none():
    assert twin.link(0, 1, [(0, 10, 20, 30)], [(0, 10, "a"), (20, 30, "a")], [])
    assert not twin.link(0, 1, [(0, 4, 20, 24)], [(0, 10, "a"), (20, 30, "a")], [])
