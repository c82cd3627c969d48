"""The picture of a motion graph: the laws of the composite layout, and what stands in the picture."""

import functools
import io
import itertools
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from leitmotion.body import embody
from leitmotion.discovery import MotionGraph, Visit
from leitmotion.features import kinematic_chain, mirrored
from leitmotion.motion import ParameterError
from leitmotion.view import _layout_kernels, plot_graph
from leitmotion.view.graph_layout import lay_out, name_width, points_of
from leitmotion.view.graph_moments import posture_of, time_of
from leitmotion.view.graph_names import pieces_of
from leitmotion.view.graph_places import CARD
from leitmotion.view.graph_plan import plan_picture
from leitmotion.view.graph_visited import most_visited, shown_of
from leitmotion.view.stick_figures import figure_shapes
from leitmotion.view.subspaces import find_subspaces
from oracles import layout as oracle
from oracles.performing import GRAPHS, graph_of, perform, starred

HALF = np.divide(CARD, 2)
every_graph = pytest.mark.parametrize("name", GRAPHS)


@functools.cache
def laid(name):
    return lay_out(GRAPHS[name])


def mirror_partners(items):
    names = {item.name: item for item in items}
    return [(item, names[item.mirror]) for item in items if item.mirror in names and item.mirror != item.name]


@every_graph
def test_symmetric_states_stand_on_the_axis_and_mirror_images_across_it(name):
    graph, layout = GRAPHS[name], laid(name)
    places = layout.places
    assert places.keys() == {state.name for state in graph.states}
    for state in graph.states:
        x = places[state.name][0]
        assert (x == 0) == state.symmetric
        if not state.symmetric:
            assert (x > 0) == ("*" in state.name)
    for state, image in mirror_partners(graph.states):
        assert places[image.name] == (-places[state.name][0], places[state.name][1])


@every_graph
def test_no_two_states_come_nearer_than_a_card(name):
    layout = laid(name)
    for a, b in itertools.combinations(layout.places.values(), 2):
        assert (np.abs(np.subtract(a, b)) >= np.array(CARD) + 0.1).any()


@every_graph
def test_a_path_goes_from_its_source_to_its_target_and_over_no_other_state(name):
    graph, layout = GRAPHS[name], laid(name)
    assert layout.curves.keys() == layout.labels.keys() == {path.name for path in graph.paths}
    for path in graph.paths:
        points = points_of(layout.curves[path.name])
        for end, state in ((points[0], path.source), (points[-1], path.target)):
            beyond = np.abs(end - layout.places[state]) - HALF
            assert 0 < beyond.max() < 0.12
        for place in layout.places.values():
            assert not (np.abs(points - place) < HALF).all(axis=1).any(), path.name


@every_graph
def test_the_image_of_a_path_is_the_image_of_its_curve(name):
    graph, layout = GRAPHS[name], laid(name)
    states = {state.name: state for state in graph.states}
    for path, image in mirror_partners(graph.paths):
        curve, other = layout.curves[path.name], layout.curves[image.name]
        if states[path.source].mirror == path.target != path.source:
            expected = [0, 2 * layout.places[path.source][1]] - curve
        else:
            expected = curve * [-1, 1]
        assert np.allclose(other, expected)


@every_graph
def test_a_name_stands_upon_its_path_and_apart_from_names_and_states(name):
    layout = laid(name)
    boxes = {path: np.array([name_width(path), 0.2]) / 2 for path in layout.labels}
    for path, place in layout.labels.items():
        on_curve = points_of(layout.curves[path], np.linspace(0, 1, 501)) - place
        assert np.hypot(*on_curve.T).min() < 0.02
        for other in layout.places.values():
            assert (np.abs(np.subtract(other, place)) > HALF).any()
        for other, there in layout.labels.items():
            if other != path:
                apart = np.abs(np.subtract(there, place)) - boxes[path] - boxes[other]
                assert apart.max() > 0, (path, other)


def test_a_symmetric_path_runs_along_the_axis_and_an_asymmetric_one_beside_it():
    layout = laid("sun_salutation")
    assert list(layout.places) == ["Y", "X", "T", "W", "V"]
    assert np.all(np.diff([y for _, y in layout.places.values()]) > 0)
    for name in ("yx", "xt", "tw", "vw"):
        assert np.allclose(layout.curves[name][:, 0], 0)
    assert (points_of(layout.curves["wv"])[:, 0] < -0.2).all()
    for name in ("yy", "vv"):
        assert layout.labels[name][0] == pytest.approx(0)


@every_graph
def test_the_same_graph_is_laid_out_alike(name):
    first, second = laid(name), lay_out(GRAPHS[name])
    assert first.places == second.places
    assert first.labels == second.labels
    assert all((first.curves[name] == second.curves[name]).all() for name in first.curves)


def test_a_graph_of_nothing_is_laid_out():
    layout = lay_out(MotionGraph((), (), ("rest",), (30.0,), 0.0, {}))
    assert layout.places == {}
    assert np.isfinite(layout.box).all()


@pytest.mark.parametrize("count", [0, 1, 5, 25])
@pytest.mark.parametrize("name", ["butterfly", "walking", "side_kicks", "sun_salutation", "twelve"])
def test_the_parts_of_the_picture_do_not_overlap_and_are_within(name, count):
    plan = plan_picture(laid(name).box, 7.5, head=0.4, subspaces=True, cells=count)
    parts = [plan.graph, *plan.plots, *plan.cells]
    assert len(plan.cells) == count
    for x, y, wide, high in parts:
        assert x >= 0
        assert y >= 0
        assert x + wide <= 1.001
        assert y + high <= 1.001
    for a, b in itertools.combinations(parts, 2):
        across = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
        along = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
        assert min(across, along) < 1e-6


@pytest.fixture(scope="module")
def racemized():
    return perform(GRAPHS["racemized"], "aa aa ax -ax aa")


def test_the_picture_names_every_state_and_path_once(racemized):
    motion, graph = racemized
    out = io.BytesIO()
    plot_graph(graph, motion, postures=False).savefig(out, format="svg")
    ids = [element.get("id") for element in ElementTree.fromstring(out.getvalue()).iter()]
    named = sorted(told for told in ids if told and told.startswith(("state-", "path-")))
    assert named == sorted(
        ["state-A", "state-X", "state-A*", "path-aa", "path-ax", "path-(ax)*", "path-(aa)*"]
    )


def test_the_picture_is_the_same_twice(racemized):
    motion, graph = racemized
    pictures = []
    for _ in range(2):
        out = io.BytesIO()
        plot_graph(graph, motion, theme="dark").savefig(out, format="png", metadata={"Software": None})
        pictures.append(out.getvalue())
    assert pictures[0] == pictures[1]


def test_what_was_reflected_is_pictured_by_its_mirror_image(racemized):
    motion, graph = racemized
    chains = [kinematic_chain(motion)]
    states = {state.name: state for state in graph.states}
    own, image = (posture_of(states[name], graph, chains) for name in ("A", "A*"))
    assert image == own._replace(mirrored=True)
    paths = {path.name: path for path in graph.paths}
    assert time_of(paths["(aa)*"], graph) == time_of(paths["aa"], graph)._replace(mirrored=True)
    moments = time_of(paths["aa"], graph).moments(5)
    assert [moment.frame for moment in moments] == sorted(moment.frame for moment in moments)


def test_a_path_that_was_only_gone_back_is_pictured_forward():
    graph = graph_of(["X", "Y"], [("xy", "X", "Y", "sr")], {"xy": [Visit(0, 10, 20, True)]})
    frames = [moment.frame for moment in time_of(graph.paths[0], graph).moments(3)]
    assert frames == [19, 14, 10]


def test_a_mirrored_figure_is_that_of_the_mirrored_movement(racemized):
    motion, _ = racemized
    body = embody(motion)
    flipped = body.replace(
        positions=body.positions * [-1, 1, 1],
        facing=-body.facing,
        roles=tuple(starred_role(role) for role in body.roles),
    )
    for a, b in zip(figure_shapes(body, 20, mirrored=True), figure_shapes(flipped, 20), strict=True):
        assert a.side == b.side
        assert np.allclose(a.outline, b.outline)


def starred_role(role):
    for side, other in (("left_", "right_"), ("right_", "left_")):
        if role.startswith(side):
            return other + role.removeprefix(side)
    return role


def test_a_symmetric_posture_lies_at_the_origin_of_the_antisymmetric_subspace(racemized):
    motion, graph = racemized
    chain = kinematic_chain(motion)
    planes = find_subspaces([chain, mirrored(chain)])
    assert np.allclose(planes.symmetric[0], planes.symmetric[1])
    assert np.allclose(planes.antisymmetric[0], -planes.antisymmetric[1])
    visits = {state.name: state.visits for state in graph.states}
    reach = np.abs(planes.antisymmetric[0]).max()
    x = planes.antisymmetric[0][visits["X"][0].start]
    a = planes.antisymmetric[0][visits["A"][0].start]
    assert np.abs(x).max() < 0.02 * reach
    assert np.abs(a).max() > 0.1 * reach


def test_names_are_written_with_bar_star_and_subscript():
    graph = graph_of(["X", "A", "A*"], [("xx2", "X", "X", "s"), ("(aa*)*", "A*", "A", "")])
    assert [pieces_of(state) for state in graph.states] == [
        (("X", "bar"),),
        (("A", "plain"),),
        (("A", "plain"), ("*", "above")),
    ]
    assert pieces_of(graph.paths[0]) == (("xx", "bar"), ("2", "below"))
    assert pieces_of(graph.paths[1]) == (("(aa", "plain"), ("*", "above"), (")", "plain"), ("*", "above"))
    assert starred(starred("(aa*)*")) == "(aa*)*"


def test_recordings_that_are_not_the_graphs_are_refused(racemized):
    motion, graph = racemized
    with pytest.raises(ParameterError, match="The graph is of 1 recordings, got 2"):
        plot_graph(graph, [motion, motion])
    with pytest.raises(ParameterError, match=r"was visited until frame .* which has 20"):
        plot_graph(graph, motion[:20])


@pytest.mark.parametrize("seed", range(5))
def test_the_kernels_of_the_layout_tell_what_their_twins_tell(seed):
    rng = np.random.default_rng(seed)
    a, b, cards = rng.uniform(-4, 4, (3, 12, 2))
    assert _layout_kernels.count_crossings(a, b) == oracle.crossings(a, b)
    assert _layout_kernels.count_passed(a, b, cards, 0.5, 0.65) == oracle.passed(a, b, cards, HALF)
    curves = np.array([points_of(curve) for curve in rng.uniform(-2, 2, (6, 4, 2))])
    told = _layout_kernels.crowd(curves[0], curves[1:], 0.34, 0.05, 4, 6)
    assert told == pytest.approx(oracle.crowd(curves[0], curves[1:], 0.34, 0.05, 4, 6))


def test_a_line_along_the_edge_of_a_card_does_not_pass_over_it():
    cards = np.array([[0.0, 0.0]])
    for x, over in ((0.5, 0), (0.49, 1)):
        assert (
            _layout_kernels.count_passed(np.array([[x, -3.0]]), np.array([[x, 3.0]]), cards, 0.5, 0.65)
            == over
        )


def test_a_graph_without_a_state_says_so(racemized):
    motion, graph = racemized
    figure = plot_graph(graph.replace(states=(), paths=()), motion)
    assert [text.get_text() for text in figure.axes[0].texts] == ["no state"]


def test_a_posture_that_was_not_seen_is_left_out(racemized):
    motion, graph = racemized
    body = embody(motion)
    positions = body.positions.copy()
    unseen = {state.name: state.visits for state in graph.states}["X"][0]
    positions[unseen.start : unseen.stop] = np.nan
    figure = plot_graph(graph, body.replace(positions=positions))
    whole = plot_graph(graph, body)
    assert len(figure.axes[0].collections) == len(whole.axes[0].collections) - 1


def test_of_a_large_graph_what_was_visited_most_is_drawn():
    graph = GRAPHS["twelve"]
    counts = {name: k + 1 for k, name in enumerate("XYABCDE")}

    def often(items):
        return tuple(
            item.replace(visits=item.visits[:1] * counts[item.name[0]] if item.visits else ())
            if item.name[0] in counts and len(item.name) <= 2
            else item
            for item in items
        )

    graph = graph.replace(states=often(graph.states))
    shown = most_visited(graph, states=4, paths=3)
    performed = [state for state in shown.states if state.visits]
    assert len(performed) <= 4
    names = {state.name for state in shown.states}
    assert {"D", "E"} <= names
    for state in shown.states:
        assert state.mirror in {*names, ""}
    for path in shown.paths:
        assert {path.source, path.target} <= names
    assert sum(bool(path.visits) for path in shown.paths) <= 3
    assert shown_of(shown, graph).startswith(f"The most visited: {len(performed)} of ")
    assert most_visited(graph) == graph
    assert shown_of(graph, graph) == ""


def test_a_state_is_pictured_by_a_typical_visit_whatever_the_sign_of_its_quaternions():
    motion, graph = perform(GRAPHS["racemized"], "aa aa ax -ax aa")
    chain = kinematic_chain(motion)
    state = graph.states[0]
    odd = graph.states[1].visits[0]  # as if it had been taken for the same state once
    mixed = state.replace(visits=(odd, *state.visits))
    told = posture_of(mixed, graph, [chain])
    assert not odd.start <= told.frame < odd.stop
    signs = np.where(np.arange(len(chain)) % 2, 1.0, -1.0)[:, None]
    assert posture_of(mixed, graph, [chain.replace(values=chain.values * signs)]) == told
