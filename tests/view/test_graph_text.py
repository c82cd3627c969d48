"""The motion graph as text: a document that JSON takes, and GraphML that says the same."""

import json
from xml.etree import ElementTree

import pytest

from leitmotion.discovery import MotionGraph, Path, State, Visit, notation, plain_notation
from leitmotion.view import graph_document, graphml

WITHIN = {"g": "http://graphml.graphdrawing.org/xmlns"}


@pytest.fixture
def graph():
    """Kicks to the left and one turn to the front, racemized by hand."""
    states = (
        State("A", False, (Visit(0, 0, 12), Visit(0, 60, 66)), "A*"),
        State("X", True, (Visit(0, 90, 120),), "X"),
        State("A*", False, (), "A"),
    )
    paths = (
        Path("aa", "A", "A", False, False, (Visit(0, 11, 61),), "(aa)*"),
        Path("ax", "A", "X", False, True, (Visit(0, 65, 91),), "(ax)*"),
        Path("(aa)*", "A*", "A*", False, False, (), "aa"),
        Path("(ax)*", "A*", "X", False, True, (), "ax"),
    )
    return MotionGraph(states, paths, ("kicks & <turn>",), (60.0,), 0.8, {"racemized": "all"})


def test_the_document_is_plain_and_whole(graph):
    document = graph_document(graph)
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["notation"] == notation(graph) == "A, X̄; aa →, ax ↔; W: A*; (aa)* →, (ax)* ↔"
    assert plain_notation(graph).isascii()
    assert document["performed"] == ["A aa ax"]
    assert document["reflections"] == [
        {"of": "A", "is": "A*"}, {"of": "X", "is": "X"}, {"of": "aa", "is": "(aa)*"}, {"of": "ax", "is": "(ax)*"},
    ]  # fmt: skip
    assert document["states"][0]["occurrences"][1] == {
        "start": 60, "stop": 66, "start_s": 1.0, "stop_s": 1.1, "label": "A", "score": None, "recording": 0,
    }  # fmt: skip
    assert [path["reflected"] for path in document["paths"]] == [False, False, True, True]


def test_graphml_says_the_same(graph):
    root = ElementTree.fromstring(graphml(graph))
    keys = {key.get("id"): (key.get("for"), key.get("attr.name")) for key in root.findall("g:key", WITHIN)}
    nodes = root.findall("g:graph/g:node", WITHIN)
    told = root.findall("g:graph/g:edge", WITHIN)
    assert [node.get("id") for node in nodes] == ["A", "X", "A*"]
    assert [(edge.get("source"), edge.get("target")) for edge in told] == [
        (path.source, path.target) for path in graph.paths
    ]

    def held(element):
        return {keys[data.get("key")][1]: data.text for data in element.findall("g:data", WITHIN)}

    assert held(nodes[0]) == {"name": "A", "label": "A", "symmetric": "false", "mirror": "A*", "count": "2"}
    assert held(told[3])["reflected"] == "true"
    assert held(told[1])["reversible"] == "true"
    assert float(held(told[0])["seconds"]) == pytest.approx(50 / 60, abs=1e-4)
    for element in (*nodes, *told):
        assert all(keys[data.get("key")][0] == element.tag.rpartition("}")[2] for data in element)
