"""The motion graph: the seven motions of paper S, and what the mirror, time, rate and place do to it."""

import unicodedata
from itertools import permutations

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.datasets import MOTIONS, Action, compose, compose_motif
from leitmotion.discovery import build_graph, notation, performed, racemized
from leitmotion.discovery.evening import matched_bias
from leitmotion.discovery.racemizing import starred
from leitmotion.evaluation import GraphPath, GraphShape, GraphState, same_graph
from leitmotion.features import kinematic_chain, mirrored, without_bias
from leitmotion.features.resampling import resample
from leitmotion.io import load, save
from leitmotion.motion import DataError, ParameterError, rotations
from leitmotion.similarity import double_metric
from oracles import body as oracle
from oracles import danced as motifs

SEEDS = (0, 1)


def written(graph):
    return unicodedata.normalize("NFC", notation(graph))


def edges(graph, names, *, backwards=False):
    """What there is between which states, renamed."""
    told = []
    for path in graph.paths:
        ends = [names[path.source], names[path.target]][:: -1 if backwards else 1]
        told.append((*(sorted(ends) if path.reversible else ends), path.reversible, path.symmetric))
    return sorted(told)


def shape(graph):
    return GraphShape(
        [GraphState(state.name, state.symmetric, state.mirror) for state in graph.states],
        [GraphPath(path.source, path.target, path.symmetric, path.reversible) for path in graph.paths],
    )


def shape_of_truth(composed):
    held = {state.name for state in composed.states}
    image = {name: name if symmetric else starred(name) for name, symmetric, _ in composed.states}
    return GraphShape(
        [
            GraphState(state.name, state.symmetric, image[state.name] if image[state.name] in held else "")
            for state in composed.states
        ],
        [GraphPath(path.source, path.target, path.symmetric, path.reversible) for path in composed.paths],
    )


def isomorphic(one, other, *, backwards=False):
    """Whether some renaming of states makes one graph the other, gone about as often."""
    counts = [sum(len(path.visits) for path in graph.paths) for graph in (one, other)]
    if len(one.states) != len(other.states) or abs(counts[0] - counts[1]) > 1:
        return False
    wanted = edges(other, {state.name: state.name for state in other.states})
    for order in permutations(one.states):
        pairs = list(zip(order, other.states, strict=True))
        names = {a.name: b.name for a, b in pairs}
        if (
            all(a.symmetric == b.symmetric for a, b in pairs)
            and edges(one, names, backwards=backwards) == wanted
        ):
            return True
    return False


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", motifs.GRAPHS)
def test_the_motions_of_the_thesis_have_its_graphs(name, seed):
    assert written(build_graph([motifs.performed(name, seed)])) == motifs.GRAPHS[name]


@pytest.mark.parametrize("name", motifs.GRAPHS)
def test_the_mirror_conjugates_the_graph(name):
    chain = motifs.performed(name, 2)
    graph, image = build_graph([chain]), build_graph([mirrored(chain)])
    assert written(image) == written(graph)  # whichever side comes first is called A
    assert isomorphic(image, graph)
    both = build_graph([chain, mirrored(chain)])
    first = {state.name for state in both.states if any(visit.recording == 0 for visit in state.visits)}
    second = {state.name for state in both.states if any(visit.recording == 1 for visit in state.visits)}
    assert second == {state.mirror for state in both.states if state.name in first}


@pytest.mark.parametrize("name", motifs.GRAPHS)
def test_time_that_runs_backwards_turns_the_arrows_round(name):
    chain = motifs.performed(name, 3)
    back = chain.replace(values=chain.values[::-1])
    assert isomorphic(build_graph([back]), build_graph([chain]), backwards=True)


@pytest.mark.parametrize("name", motifs.GRAPHS)
def test_the_rate_and_missing_links_change_nothing(name):
    chain = motifs.performed(name, 4, rate=120.0)
    graph = build_graph([chain])
    assert isomorphic(build_graph([resample(chain, 45.0)]), graph)
    values = chain.values.reshape(len(chain), -1, 4)
    kept = [k for k, link in enumerate(chain.names) if link not in ("lower_neck", "upper_neck", "lower_back")]
    fewer = chain.replace(
        values=values[:, kept].reshape(len(chain), -1), names=tuple(chain.names[k] for k in kept)
    )
    assert isomorphic(build_graph([fewer]), graph)


def test_yaw_and_place_change_nothing(rng):
    motion = oracle.human(rng, frames=240, bend=0.9)
    there = oracle.moved(motion, yaw=2.0, by=[3.0, 0.0, -1.0])
    one, other = (build_graph([kinematic_chain(each)]) for each in (motion, there))
    assert (one.states, one.paths) == (other.states, other.paths)


@pytest.mark.parametrize("name", MOTIONS)
def test_the_composed_motions_have_their_graphs_whatever_way_they_are_told(name):
    composed = compose_motif(name, seed=7, rate=60.0)
    graph = lm.motion_graph(composed.motion)
    assert same_graph(shape(graph), shape_of_truth(composed))
    image = oracle.mirrored(composed.motion)
    assert isomorphic(lm.motion_graph(image), graph)
    there = oracle.moved(composed.motion, yaw=2.0, by=[3.0, 0.0, -1.0])
    assert isomorphic(lm.motion_graph(there), graph)


@pytest.mark.parametrize("name", MOTIONS)
def test_points_tell_what_joints_tell(name):
    exact = compose_motif(name, rate=30.0, variation=None)
    assert same_graph(shape(lm.motion_graph(oracle.points_of(exact.motion))), shape_of_truth(exact))


def test_visits_follow_one_another_and_paths_lie_between_them():
    graph = build_graph([motifs.performed("sun salutation", 0, varied=False, noise=0.0)])
    states = sorted((v.start, v.stop, s.name) for s in graph.states for v in s.visits)
    paths = sorted((v.start, v.stop, p, v.reversed) for p in graph.paths for v in p.visits)
    assert len(paths) == len(states) - 1
    for (_, begins, here), (start, stop, path, back), (ends, _, there) in zip(
        states[:-1], paths, states[1:], strict=True
    ):
        assert abs(start - begins) <= 2
        assert abs(stop - ends) <= 2
        assert (here, there) == ((path.target, path.source) if back else (path.source, path.target))
    assert performed(graph).split()[:4] == ["X̄", "x̄y", "x̄y", "x̄x"]


def test_states_are_shared_across_recordings():
    left = motifs.performed("jumping jacks", 5)
    right = motifs.performed("jumping jacks", 5, rate=30.0)
    graph = build_graph([left, right], names=["first", "second"])
    assert written(graph) == motifs.GRAPHS["jumping jacks"]
    for state in graph.states:
        assert {visit.recording for visit in state.visits} == {0, 1}
    assert graph.rates == (60.0, 30.0)


def test_a_turning_point_that_is_held_is_a_state():
    chain = kinematic_chain(compose([Action("squat", 3), Action("left side kick", 2)], seed=0).motion)
    kicks = build_graph([chain])
    assert written(kicks) == unicodedata.normalize("NFC", "X̄, A; x̄x ↔, xa ↔, aa ↔")
    times = np.ones(len(chain), dtype=int)
    for visit in kicks.paths[-1].visits:
        way = chain.values[visit.start : visit.stop]
        times[visit.start + np.linalg.norm(way - way[0], axis=1).argmax()] = round(1.2 * chain.rate)
    held = build_graph([chain.replace(values=np.repeat(chain.values, times, axis=0))])
    assert written(held) == unicodedata.normalize("NFC", "X̄, A, B; x̄x ↔, xa ↔, ab ↔")


@pytest.mark.parametrize("unseen", [6, 30, 60])
@pytest.mark.parametrize("name", ["walking", "jumping jacks"])
def test_no_way_leads_across_what_nobody_saw(name, unseen):
    chain = kinematic_chain(compose_motif(name, rate=60.0).motion)
    first = len(chain) // 2
    values = chain.values.copy()
    values[first : first + unseen] = np.nan
    graph = build_graph([chain.replace(values=values)])
    assert shape(graph) == shape(build_graph([chain]))
    visits = [visit for each in (*graph.states, *graph.paths) for visit in each.visits]
    assert all(visit.stop <= first + 1 or visit.start >= first + unseen - 1 for visit in visits)
    assert max(visit.stop for visit in visits) <= len(chain)


def test_nothing_that_moves_has_one_state():
    still = np.tile([1.0, 0.0, 0.0, 0.0], (90, 15))
    graph = build_graph([motifs.performed("walking", 0).replace(values=still)])
    assert written(graph) == "X̄"
    assert (graph.states[0].visits[0].start, graph.states[0].visits[0].stop) == (0, 90)


def test_different_paths_between_the_same_states_bear_figures():
    session = compose([Action("arm raise", 2), Action("squat", 2)], seed=0)
    graph = lm.motion_graph(session.motion)
    assert written(graph) == "X̄; x̄x₁ ↔, x̄x₂ ↔"
    assert performed(graph) == "X̄ x̄x₁ x̄x₁ x̄x₂ x̄x₂"


def test_a_constant_offset_is_told_from_how_the_body_moves():
    walk = motifs.performed("walking", 0, noise=0.0, varied=False)
    assert matched_bias(walk) is None  # nothing to take out
    values = walk.values.reshape(len(walk), -1, 4).copy()
    link = walk.names.index("left_femur")
    turn = rotations.from_rotation_vector(np.radians([[0.0, 9.0, 0.0]]))
    values[:, link] = rotations.multiply(values[:, link], turn)
    crooked = walk.replace(values=values.reshape(len(walk), -1))
    bias = matched_bias(crooked)
    assert np.degrees(bias.angles[link]) == pytest.approx(9.0, abs=0.5)
    assert np.degrees(np.delete(bias.angles, [link, walk.names.index("right_femur")]).max()) < 1.0
    even = without_bias(crooked, bias)
    assert (
        double_metric(even).mirror.min(axis=1).max() < 0.2 * double_metric(crooked).mirror.min(axis=1).max()
    )
    assert matched_bias(motifs.performed("limping", 0)) is None


def test_a_racemized_graph_is_its_own_image_and_stays_so():
    for name in motifs.GRAPHS:
        graph = racemized(build_graph([motifs.performed(name, 0)]))
        assert racemized(graph) == graph
        if name == "limping":
            assert graph.parameters["racemized"] == "nothing"
            assert written(graph) == motifs.GRAPHS[name]
            continue
        assert graph.parameters["racemized"] == "all"
        states = {state.name: state for state in graph.states}
        for path in graph.paths:
            twin = next(other for other in graph.paths if other.name == path.mirror)
            assert (twin.source, twin.target) == (states[path.source].mirror, states[path.target].mirror)
    salutation = racemized(build_graph([motifs.performed("sun salutation", 0)]))
    assert [path.name for path in salutation.paths if path.reflected] == ["(wv)*"]
    assert written(salutation).endswith("; W: (wv)* →")


def test_a_graph_is_saved_whole(tmp_path):
    graph = racemized(build_graph([motifs.performed("side kicks", 0)]))
    assert load(save(graph, tmp_path / "kicks.npz")) == graph


def test_what_is_asked_wrongly_is_told():
    with pytest.raises(ParameterError, match="one recording at least"):
        lm.motion_graph([])
    motion = lm.compose_session(seed=0, rate=30.0).motion
    with pytest.raises(ParameterError, match="bias must be one of"):
        lm.motion_graph(motion, bias="left")
    with pytest.raises(ParameterError, match="has one name"):
        lm.motion_graph([motion], names=["a", "b"])
    chain = kinematic_chain(motion[:30])
    with pytest.raises(DataError, match="needs a body that was seen"):
        build_graph([chain.replace(values=np.full_like(chain.values, np.nan))])


@pytest.mark.data
@pytest.mark.parametrize(
    ("file", "expected"),
    [
        ("cmu_bvh/jumping_jacks.bvh", "X̄, Ȳ; x̄y ↔"),
        ("cmu_bvh/cmu_12_01_walk.bvh", "A, A*; aa* →, (aa*)* →"),
        ("bandai_namco/dataset-1_walk_normal_001.bvh", "A, A*; aa* →, (aa*)* →"),
        ("bandai_namco/dataset-1_bow_normal_001.bvh", "X̄, Ȳ; x̄y ↔"),  # the bow is held for a second
    ],
)
def test_real_recordings_are_what_they_are(data, file, expected):
    assert written(lm.motion_graph(lm.read(data / file))) == expected


@pytest.mark.data
def test_a_hand_raised_is_the_mirror_image_of_the_other_in_another_recording(data):
    folder = data / "bandai_namco"
    names = (
        "raise-up-both-hands_normal_008",
        "raise-up-left-hand_normal_021",
        "raise-up-right-hand_normal_039",
    )
    graph = lm.motion_graph([lm.read(folder / f"dataset-2_{name}.bvh") for name in names])
    assert [state.symmetric for state in graph.states if len({v.recording for v in state.visits}) == 3] == [
        True
    ]
    gone = [path for path in graph.paths if {visit.recording for visit in path.visits} & {1, 2}]
    left, right = gone
    assert (left.mirror, right.mirror) == (right.name, left.name)
    assert left.reversible
    there_and_back = [(visit.recording, visit.reversed) for visit in (*left.visits, *right.visits)]
    assert [recording for recording, _ in there_and_back] == [1, 1, 2, 2]  # the hand is held up for a while
    assert {back for _, back in there_and_back} == {False, True}


@pytest.mark.data
def test_movements_of_different_size_keep_their_graphs_side_by_side(data):
    walk, jacks = (lm.read(data / "cmu_bvh" / name) for name in ("cmu_12_01_walk.bvh", "jumping_jacks.bvh"))
    assert written(lm.motion_graph([walk, jacks])) == "A, A*, X̄, Ȳ; aa* →, (aa*)* →, x̄y ↔"


@pytest.mark.data
@pytest.mark.parametrize("window", [(200, 960), (240, 900), (240, 960), (250, 950), (300, 960)])
def test_what_is_held_is_a_state_whatever_the_window(data, window):
    first, last = window
    whole = lm.read(data / "cmu_amc/135_06-martialArts.amc")
    graph = lm.motion_graph(whole[first:last])
    punch, block = 384 - first, 720 - first  # 3.2 s and 6.0 s, each held for 0.7 s
    for held in (punch, block):
        assert any(visit.start <= held < visit.stop for state in graph.states for visit in state.visits)
    assert 2 <= len(graph.states) <= 3
    assert 1 <= len(graph.paths) <= 3
