"""Motifs and graphs against their truth: perfect answers are right, others are not, and what follows is no error."""

from itertools import permutations, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from leitmotion.datasets import MOTIONS, compose_motif
from leitmotion.evaluation import (
    GoneStep,
    GraphPath,
    GraphShape,
    GraphState,
    MotifSpan,
    evaluate_motifs,
    same_graph,
)
from leitmotion.evaluation.motif_truth import Course
from leitmotion.features import kinematic_chain, mirrored
from leitmotion.motion import ParameterError
from leitmotion.motion.rotations import geodesic_angle

OPPOSITES = {
    "symmetric_cycle": "asymmetric_cycle",
    "asymmetric_cycle": "symmetric_cycle",
    "symmetric_palindrome": "asymmetric_palindrome",
    "anti_palindrome": "symmetric_palindrome",
    "anti_phase": "anti_palindrome",
}


IMPLIED = (("butterfly", "symmetric_path"), ("jumping jacks", "symmetric_path"))


def truth(name, seed=None):
    found = compose_motif(name, seed=seed or 0, rate=30.0, **({"variation": None} if seed is None else {}))
    return [GoneStep(*step) for step in found.steps], [MotifSpan(*span) for span in found.spans]


def shape(found):
    names = {state.name for state in found.states}
    images = {
        name: name if state.symmetric else name[:-1] if name.endswith("*") else name + "*"
        for state in found.states
        for name in [state.name]
    }
    return GraphShape(
        [
            GraphState(s.name, s.symmetric, images[s.name] if images[s.name] in names else "")
            for s in found.states
        ],
        [GraphPath(p.source, p.target, p.symmetric, p.reversible) for p in found.paths],
    )


@pytest.mark.parametrize("seed", [None, 1, 2])
@pytest.mark.parametrize("name", MOTIONS)
def test_the_truth_itself_is_right(name, seed):
    steps, asked = truth(name, seed)
    scores = evaluate_motifs(asked, asked, steps)
    assert scores.right, scores
    assert scores.asked == scores.told == len(asked)


@pytest.mark.parametrize("name", MOTIONS)
def test_each_motif_that_is_left_out_is_missed(name):
    steps, asked = truth(name)
    for k in range(len(asked)):
        if (name, asked[k].motif) in IMPLIED:
            continue
        assert evaluate_motifs([*asked[:k], *asked[k + 1 :]], asked, steps).missed == (asked[k],)


@pytest.mark.parametrize("name", MOTIONS)
def test_the_opposite_motif_is_false(name):
    steps, asked = truth(name)
    for span in asked:
        if span.motif in OPPOSITES:
            other = span._replace(motif=OPPOSITES[span.motif])
            assert other in evaluate_motifs([*asked, other], asked, steps).false


@pytest.mark.parametrize("name", [name for name in MOTIONS if name not in ("sun salutation", "side kicks")])
def test_a_motif_without_its_cyclic_flag_is_missed_but_not_false(name):
    steps, asked = truth(name)
    once = [span._replace(cyclic=False) for span in asked]
    scores = evaluate_motifs(once, asked, steps)
    assert not scores.false
    assert scores.missed == tuple(span for span in asked if span.cyclic)


def test_what_is_told_with_little_confidence_counts_for_nothing():
    steps, asked = truth("walking")
    doubtful = MotifSpan("symmetric_cycle", asked[0].start, asked[0].stop, confidence=0.4)
    assert evaluate_motifs([*asked, doubtful], asked, steps).right
    assert not evaluate_motifs([span._replace(confidence=0.4) for span in asked], asked, steps).right


def test_what_follows_by_definition_is_no_error():
    told = {
        "jumping jacks": [("symmetric_cycle", (0, 12), None), ("path_reversal", (0, 1), (1, 2))],
        "jogging in place": [("anti_phase", (0, 24), None), ("asymmetric_palindrome", (0, 4), None)],
        "walking": [("asymmetric_cycle", (0, 12), None), ("reflected_path_repetition", (0, 1), (1, 2))],
        "side kicks": [("path_repetition", (0, 2), (2, 4))],
        "sun salutation": [("symmetric_palindrome", (1, 5), None), ("symmetric_palindrome", (12, 14), None)],
    }
    for name, spans in told.items():
        steps, asked = truth(name, 4)
        for motif, (a, b), partner in spans:
            other = partner and (steps[partner[0]].start, steps[partner[1] - 1].stop)
            span = MotifSpan(motif, steps[a].start, steps[b - 1].stop, partner=other)
            assert evaluate_motifs([*asked, span], asked, steps).right, (name, motif)


def test_what_does_not_follow_is_an_error():
    told = {
        "butterfly": [("symmetric_palindrome", (0, 2), None), ("path_reversal", (0, 1), (1, 2))],
        "jumping jacks": [("path_repetition", (0, 1), (1, 2)), ("anti_palindrome", (0, 2), None)],
        "jogging in place": [("asymmetric_cycle", (0, 24), None), ("symmetric_path", (0, 24), None)],
        "walking": [("path_repetition", (0, 1), (1, 2)), ("anti_palindrome", (0, 12), None)],
        "limping": [("anti_phase", (0, 6), None), ("reflected_path_repetition", (0, 1), (1, 2))],
        "side kicks": [("path_repetition", (0, 4), (6, 10)), ("asymmetric_cycle", (0, 10), None)],
        "sun salutation": [("symmetric_path", (0, 26), None), ("path_reversal", (7, 8), (9, 10))],
    }
    for name, spans in told.items():
        steps, asked = truth(name, 4)
        for motif, (a, b), partner in spans:
            other = partner and (steps[partner[0]].start, steps[partner[1] - 1].stop)
            span = MotifSpan(motif, steps[a].start, steps[b - 1].stop, partner=other)
            assert evaluate_motifs([*asked, span], asked, steps).false == (span,), (name, motif)


def test_a_pair_that_is_out_of_step_is_false():
    steps, asked = truth("limping")
    length = steps[0].stop - steps[0].start
    for shift, right in ((0, True), (length // 2, False)):
        span = MotifSpan("path_repetition", 0, length, partner=(length + shift, 2 * length + shift))
        assert (not evaluate_motifs([span], asked, steps).false) is right


def test_pairs_may_be_told_in_parts_and_either_way_round():
    steps, asked = truth("sun salutation")
    parts = []
    for span in asked:
        if span.motif == "path_repetition":
            for k in range(13):
                there, again = steps[k], steps[k + 13]
                parts.append(
                    MotifSpan("path_repetition", again.start, again.stop, partner=(there.start, there.stop))
                )
        else:
            parts.append(span)
    assert evaluate_motifs(parts, asked, steps).right


@given(st.integers(-20, 20), st.integers(-20, 20))
def test_small_errors_of_the_borders_are_forgiven(first, last):
    steps, asked = truth_of_walking()
    span = asked[0]
    moved = span._replace(start=max(0, span.start + first), stop=span.stop + last)
    assert evaluate_motifs([moved], asked, steps).right


def truth_of_walking():
    steps = [
        GoneStep("aa*", 30 * k, 30 * k + 30, False, k % 2 == 1, False, "A*"[: 1 + k % 2], "A*"[: 2 - k % 2])
        for k in range(12)
    ]
    return steps, [MotifSpan("anti_phase", 0, 360, cyclic=True)]


@pytest.mark.parametrize("name", MOTIONS)
def test_a_graph_is_itself_whatever_its_letters(name):
    graph = shape(compose_motif(name, rate=30.0, variation=None))
    for letters in list(permutations("ABCDE", len(graph.states)))[:20]:
        new = {state.name: letter for state, letter in zip(graph.states, letters, strict=True)} | {"": ""}
        renamed = GraphShape(
            [state._replace(name=new[state.name], mirror=new[state.mirror]) for state in graph.states[::-1]],
            [path._replace(source=new[path.source], target=new[path.target]) for path in graph.paths[::-1]],
        )
        assert same_graph(graph, renamed)


def test_the_graphs_of_the_thesis_are_all_different():
    graphs = [shape(compose_motif(name, rate=30.0, variation=None)) for name in MOTIONS]
    for k, a in enumerate(graphs):
        assert [same_graph(a, b) for b in graphs] == [j == k for j in range(len(graphs))]


@pytest.mark.parametrize("name", MOTIONS)
def test_a_graph_with_one_change_is_another(name):
    graph = shape(compose_motif(name, rate=30.0, variation=None))
    first, *others = graph.paths
    assert not same_graph(graph, GraphShape(graph.states, others))
    for change in ({"reversible": not first.reversible}, {"symmetric": not first.symmetric}):
        assert not same_graph(graph, GraphShape(graph.states, [first._replace(**change), *others]))
    state, *rest = graph.states
    lone = [state._replace(symmetric=not state.symmetric), *rest]
    assert not same_graph(graph, GraphShape(lone, graph.paths))


def test_the_mirror_image_of_a_state_is_part_of_a_graph():
    paths = [GraphPath("A", "B", False, False), GraphPath("B", "A", False, False)]
    plain = GraphShape([GraphState("A", False), GraphState("B", False)], paths)
    mirrored = GraphShape([GraphState("A", False, "B"), GraphState("B", False, "A")], paths)
    assert not same_graph(plain, mirrored)


def test_nonsense_is_refused():
    steps, asked = truth_of_walking()
    with pytest.raises(ParameterError, match="must be one of"):
        evaluate_motifs([MotifSpan("dance", 0, 3)], asked, steps)
    with pytest.raises(ParameterError, match="ends after it began"):
        evaluate_motifs([MotifSpan("stillness", 3, 3)], asked, steps)
    with pytest.raises(ParameterError, match="one step at least"):
        evaluate_motifs([], asked, [])


@pytest.mark.parametrize("name", MOTIONS)
def test_steps_are_alike_where_their_postures_are_and_only_there(name):
    found = compose_motif(name, rate=120.0, variation=None)
    course = Course.of([GoneStep(*step) for step in found.steps])
    chain = kinematic_chain(found.motion)
    values = [each.values.reshape(len(chain), -1, 4) for each in (chain, mirrored(chain))]
    first = {(step.path, step.reversed, step.mirrored): k for k, step in enumerate(found.steps)}
    for j, k, mirror, back in product(first.values(), first.values(), (False, True), (False, True)):
        a, b = (
            np.linspace(course.steps[each].start, course.steps[each].stop - 1, 15).astype(int)
            for each in (j, k)
        )
        ends = values[0][a], values[int(mirror)][b[::-1] if back else b]
        apart = np.degrees(geodesic_angle(*ends)).mean(axis=1)
        told = f"{found.steps[j]} and {found.steps[k]}, mirror {mirror}, back {back}: {apart}"
        if course.alike(j, k, mirror=mirror, back=back):
            assert np.median(apart) < 2.0, told
        else:
            assert apart.max() > 6.0, told
