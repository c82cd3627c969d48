"""How good found patterns are: one protocol for every method.

Conventions
-----------
A stretch *belongs* to an action when at least 80 % of its frames carry that label. *Type I* error: pairs whose two
stretches belong to different actions or to none, over all pairs. *Type II* error: recurring actions missed over all
recurring ones; an action is found when at least half of its frames lie in occurrences that belong to it. Beside both
stand the error of the borders and the count of cycles of each run.

A *true pair* is two runs of one recurring action, or a cyclic run with itself. It is *linked* when right pairs show the
one run in the other over at least half of the shorter one. So in recall each two runs count once, however many cycles
they hold and however a method cuts them: one long pair and ten short ones that cover the same are worth the same. Type
I error and precision count pairs.

References
----------
[P] Tang, Leung, Komura, Shum (2008), section 3: the error rates u/(U - u + v) and v/(U - u + v).
"""

from __future__ import annotations

import itertools
import math
from collections import defaultdict

import numpy as np

from leitmotion.evaluation.pattern_scores import PatternScores, RunCount
from leitmotion.evaluation.pattern_truth import FoundPatterns, PatternTruth
from leitmotion.motion.errors import ParameterError

BELONGS = 0.8
"""Share of a stretch's frames that carry the label of the action to which it belongs."""
FOUND = 0.5
"""Share of an action's frames that occurrences cover when it is found, and of a run's when it is linked."""
_EPSILON = 1e-9


def evaluate_patterns(
    truth: PatternTruth, found: FoundPatterns, *, unlabelled: str = "against"
) -> PatternScores:
    """Judge what was found in one recording.

    Parameters
    ----------
    truth : PatternTruth
        What a person saw.
    found : FoundPatterns
        What was found.
    unlabelled : {"against", "aside"}
        How frames without a label count, where an annotator accepts several borders or one movement blends into the
        next: against a stretch that holds them, as the protocol has it, or neither for nor against it. A stretch of
        which more than half carries no label belongs to nothing either way.

    Returns
    -------
    PatternScores
        All figures.

    Raises
    ------
    ParameterError
        When the two are of different frame rates, or `unlabelled` is neither.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> runs = Segmentation([0, 100, 200], [100, 200, 300], ("walk", "kick", "walk"), rate=30)
    >>> occurrences = Segmentation([0, 210], [100, 300], ("A", "A"), rate=30)
    >>> scores = evaluate_patterns(PatternTruth(runs), FoundPatterns(occurrences))
    >>> scores.type_one, scores.type_two, scores.f1, round(scores.border_error_s, 3)
    (0.0, 0.0, 1.0, 0.083)
    """
    if not math.isclose(truth.rate, found.rate, rel_tol=1e-6):
        raise ParameterError(f"The truth is at {truth.rate:g} Hz, what was found at {found.rate:g} Hz.")
    if unlabelled not in ("against", "aside"):
        raise ParameterError(f"unlabelled must be against or aside, got {unlabelled!r}.")
    aside = unlabelled == "aside"
    pairs = found.pairs
    assert pairs is not None  # made from the occurrences where they were not given
    spans = np.stack((found.occurrences.starts, found.occurrences.stops), axis=1)
    frames = int(max(array.max(initial=1) for array in (truth.runs.stops, spans, pairs)))
    which = truth.which_run(frames)
    owner = _owners(truth, which, spans, aside=aside)
    a, b = (_owners(truth, which, pairs[:, side], aside=aside) for side in (slice(0, 2), slice(2, 4)))
    right = np.array([x is not None and x == y for x, y in zip(a, b, strict=True)], dtype=bool)
    recurs = np.array([x in truth.recurring for x in a], dtype=bool)
    once = np.array([x not in truth.recurring and x not in truth.uncertain for x in a], dtype=bool)
    links = linked(truth, pairs[right & recurs])
    return PatternScores(
        pairs=len(pairs),
        wrong_pairs=int((~right).sum()),
        unfounded_pairs=int((right & once).sum()),
        patterns=len(set(found.occurrences.labels)),
        stray_patterns=_strays(truth, found, owner),
        recurring=truth.recurring,
        missed=_missed(truth, which, spans, owner),
        true_pairs=len(links),
        missed_pairs=sum(not link for link in links.values()),
        **_borders_and_counts(truth, found, spans, owner, which),
    )


def owners(truth: PatternTruth, spans: np.ndarray) -> list[str | None]:
    """Name the action that each stretch belongs to: the one whose label at least 80 % of its frames carry.

    Parameters
    ----------
    truth : PatternTruth
        What a person saw.
    spans : (K, 2) int
        Stretches, frames ``[start, stop)``.

    Returns
    -------
    list of str or None, K
        The labels; None of a stretch that belongs to no action.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> truth = PatternTruth(Segmentation([0, 100], [100, 200], ("walk", "kick"), rate=30))
    >>> owners(truth, np.array([[0, 125], [0, 126], [90, 200]]))
    ['walk', None, 'kick']
    """
    spans = np.asarray(spans, dtype=np.int64).reshape(-1, 2)
    frames = int(max(truth.runs.stops.max(initial=1), spans.max(initial=1)))
    return _owners(truth, truth.which_run(frames), spans)


def linked(truth: PatternTruth, pairs: np.ndarray) -> dict[tuple[int, int], bool]:
    """Say of each true pair whether pairs link it.

    A pair stands for the straight path from the start of both stretches to their ends. Where that path runs in two
    labelled runs, its moments are linked.

    Parameters
    ----------
    truth : PatternTruth
        What a person saw.
    pairs : (K, 4) int
        Pairs that are right: start and stop of the one stretch, start and stop of the other.

    Returns
    -------
    dict of (int, int) to bool
        Two runs of one recurring action, by their place, and whether at least half of the shorter is linked to the
        other; and each cyclic run with itself, and whether at least half of it is.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> runs = Segmentation([0, 200, 400], [100, 300, 500], ("walk",) * 3, rate=30)
    >>> linked(PatternTruth(runs), np.array([[0, 100, 200, 300], [0, 40, 400, 440]]))
    {(0, 1): True, (0, 2): False, (1, 2): False}
    """
    pairs = np.asarray(pairs, dtype=np.int64).reshape(-1, 4)
    which = truth.which_run(int(max(truth.runs.stops.max(initial=1), pairs.max(initial=1))))
    covered: dict[tuple[int, int], list[set[int]]] = defaultdict(lambda: [set(), set()])
    for start_a, stop_a, start_b, stop_b in pairs.tolist():
        share = (np.arange(max(stop_a - start_a, stop_b - start_b)) + 0.5) / max(
            stop_a - start_a, stop_b - start_b
        )
        a = start_a + (share * (stop_a - start_a)).astype(np.int64)
        b = start_b + (share * (stop_b - start_b)).astype(np.int64)
        runs = np.sort(np.stack((which[a], which[b])), axis=0)
        for k, m in {(k, m) for k, m in runs.T.tolist() if k >= 0}:
            for moments, others in ((a, b), (b, a)):
                covered[k, m][0].update(moments[(which[moments] == k) & (which[others] == m)].tolist())
                covered[k, m][1].update(moments[(which[moments] == m) & (which[others] == k)].tolist())
    lengths = np.bincount(which[which >= 0], minlength=len(truth.runs))

    def enough(k: int, m: int) -> bool:
        shorter = 0 if lengths[k] <= lengths[m] else 1
        return len(covered[k, m][shorter]) >= FOUND * int(lengths[(k, m)[shorter]]) - _EPSILON

    labels, recurring, cyclic = truth.runs.labels, truth.recurring, truth.cyclic
    return {
        (k, m): enough(k, m)
        for k, m in itertools.combinations_with_replacement(range(len(labels)), 2)
        if labels[k] in recurring and labels[k] == labels[m] and (k != m or cyclic[k])
    }


def _owners(
    truth: PatternTruth, which: np.ndarray, spans: np.ndarray, *, aside: bool = False
) -> list[str | None]:
    labels = np.array([*truth.runs.labels, ""])
    sums = {label: np.concatenate(([0], np.cumsum(labels[which] == label))) for label in truth.actions}
    labelled = np.concatenate(([0], np.cumsum(which >= 0)))
    found: list[str | None] = []
    for start, stop in spans.tolist():
        frames = stop - start
        if aside and labelled[stop] - labelled[start] >= frames / 2:
            frames = labelled[stop] - labelled[start]
        enough = (name for name, s in sums.items() if s[stop] - s[start] >= BELONGS * frames - _EPSILON)
        found.append(next(enough, None))
    return found


def _strays(truth: PatternTruth, found: FoundPatterns, owner: list[str | None]) -> int:
    held: dict[str, list[str | None]] = defaultdict(list)
    for pattern, action in zip(found.occurrences.labels, owner, strict=True):
        held[pattern].append(action)
    return sum(all(actions.count(action) < 2 for action in truth.recurring) for actions in held.values())


def _missed(
    truth: PatternTruth, which: np.ndarray, spans: np.ndarray, owner: list[str | None]
) -> tuple[str, ...]:
    labels = np.array([*truth.runs.labels, ""])[which]
    missed = []
    for action in truth.recurring:
        covered = np.zeros(len(which), dtype=bool)
        for (start, stop), own in zip(spans.tolist(), owner, strict=True):
            covered[start:stop] |= own == action
        frames = labels == action
        if (covered & frames).sum() < FOUND * frames.sum() - _EPSILON:
            missed.append(action)
    return tuple(missed)


def _borders_and_counts(
    truth: PatternTruth, found: FoundPatterns, spans: np.ndarray, owner: list[str | None], which: np.ndarray
) -> dict[str, tuple]:
    """Errors of the borders, and the counts, run by run."""
    judged = set(truth.recurring) - set(_missed(truth, which, spans, owner))
    homes = _homes(truth, spans, owner)
    starts, stops, inner, counts = [], [], [], []
    for k, (start, stop, label, _) in enumerate(truth.runs):
        if not label:
            continue
        here = spans[homes == k]
        patterns = np.array(found.occurrences.labels)[homes == k]
        time = {own: int(np.diff(here[patterns == own], axis=1).sum()) for own in patterns}
        widest = max(time, key=lambda own: time[own], default="")
        count = int((patterns == widest).sum())
        cycles, least, most = truth.cycles[k].tolist()
        recurs = label in truth.recurring
        counts.append(RunCount(label, start, stop, count, cycles, least, most, recurs))
        if not len(here) or label not in judged:
            continue
        starts.append((here.min() - start) / truth.rate)
        stops.append((here.max() - stop) / truth.rate)
        inner += [float(error) / truth.rate for error in _inner_errors(truth, k, here)]
    return {
        "start_errors_s": tuple(map(float, starts)),
        "stop_errors_s": tuple(map(float, stops)),
        "inner_errors_s": tuple(inner),
        "counts": tuple(counts),
    }


def _homes(truth: PatternTruth, spans: np.ndarray, owner: list[str | None]) -> np.ndarray:
    """The run of its own action in which most of each occurrence lies, shape (K,); -1 where it has no action."""
    homes = np.full(len(spans), -1)
    for place, ((start, stop), own) in enumerate(zip(spans.tolist(), owner, strict=True)):
        shared = np.minimum(stop, truth.runs.stops) - np.maximum(start, truth.runs.starts)
        shared[[label != own for label in truth.runs.labels]] = 0
        if own is not None:
            homes[place] = int(shared.argmax())
    return homes


def _inner_errors(truth: PatternTruth, run: int, found: np.ndarray) -> list[int]:
    """Frames from where a repetition that is known exactly gives way to the next to the nearest border found."""
    known = truth.within(run)
    if len(known) != truth.cycles[run, 0]:  # each repetition holds several cycles, which may be cut anywhere
        return []
    return [
        int(np.maximum(0, np.maximum(stop - found, found - start)).min())
        for stop, start in zip(known[:-1, 1], known[1:, 0], strict=True)
    ]
