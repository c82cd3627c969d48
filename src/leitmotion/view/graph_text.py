"""The motion graph as text: one document for JSON, and GraphML for other programs."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree

from leitmotion.discovery import MotionGraph, Path, State, Visit, notation, path_label, performed, state_label

MADE_BY = " Leitmotion wrote this. "
"""A remark near the start of every GraphML, by which it is known again."""
NAMESPACE = "http://graphml.graphdrawing.org/xmlns"
NODE_KEYS = {"name": "string", "label": "string", "symmetric": "boolean", "mirror": "string", "count": "int"}
EDGE_KEYS = {
    "name": "string", "label": "string", "symmetric": "boolean", "reversible": "boolean", "reflected": "boolean",
    "mirror": "string", "count": "int", "seconds": "double",
}  # fmt: skip


def graph_document(graph: MotionGraph) -> dict[str, Any]:
    """Make the document of a motion graph: plain values, ready for :func:`json.dumps`.

    Parameters
    ----------
    graph : MotionGraph
        States and paths.

    Returns
    -------
    dict
        ``states`` and ``paths`` with their ``occurrences`` (stretches ``{"start", "stop", "start_s", "stop_s",
        "label", "score"}``, and which ``recording``; of paths whether ``reversed``), ``reflections`` (pairs of names),
        ``notation``, ``performed`` (a line a recording), ``recordings`` and ``confidence``.

    Examples
    --------
    >>> state = State("X", True, (Visit(0, 30, 60),), "X")
    >>> document = graph_document(MotionGraph((state,), (), ("still",), (30.0,), 1.0, {}))
    >>> document["states"][0]["occurrences"][0]["start_s"], document["notation"]
    (1.0, 'X̄')
    """
    return {
        "states": [
            {
                "name": state.name,
                "label": state_label(state),
                "symmetric": state.symmetric,
                "mirror": state.mirror,
                "reflected": not state.visits,
                "occurrences": [_stretch(visit, state.name, graph) for visit in state.visits],
            }
            for state in graph.states
        ],
        "paths": [
            {
                "name": path.name,
                "label": path_label(path),
                "source": path.source,
                "target": path.target,
                "symmetric": path.symmetric,
                "reversible": path.reversible,
                "reflected": path.reflected,
                "mirror": path.mirror,
                "occurrences": [
                    _stretch(visit, path.name, graph) | {"reversed": visit.reversed} for visit in path.visits
                ],
            }
            for path in graph.paths
        ],
        "reflections": [
            {"of": each.name, "is": each.mirror}
            for each in _nodes_and_edges(graph)
            if each.mirror and _comes_first(each)
        ],
        "notation": notation(graph),
        "performed": [performed(graph, k) for k in range(len(graph.recordings))],
        "recordings": [
            {"name": name, "rate": rate} for name, rate in zip(graph.recordings, graph.rates, strict=True)
        ],
        "confidence": round(graph.confidence, 4),
    }


def graphml(graph: MotionGraph) -> str:
    """Write a motion graph as GraphML, which graph programs and networkx read.

    Parameters
    ----------
    graph : MotionGraph
        States and paths.

    Returns
    -------
    str
        A directed graph. A node bears ``name``, ``label``, ``symmetric``, ``mirror`` and ``count`` of its visits, an
        edge besides ``reversible``, ``reflected`` and the median ``seconds`` of its visits.

    Examples
    --------
    >>> state = State("X", True, (Visit(0, 0, 30),), "X")
    >>> text = graphml(MotionGraph((state,), (), ("still",), (30.0,), 1.0, {}))
    >>> 'edgedefault="directed"' in text
    True
    """
    root = ElementTree.Element("graphml", xmlns=NAMESPACE)
    root.append(ElementTree.Comment(MADE_BY))
    for kind, keys in (("node", NODE_KEYS), ("edge", EDGE_KEYS)):
        for name, type_ in keys.items():
            ElementTree.SubElement(
                root, "key", {"id": f"{kind}_{name}", "for": kind, "attr.name": name, "attr.type": type_}
            )
    within = ElementTree.SubElement(root, "graph", id="motion", edgedefault="directed")
    for state in graph.states:
        node = ElementTree.SubElement(within, "node", id=state.name)
        _data(node, "node", _of_state(state))
    for path in graph.paths:
        edge = ElementTree.SubElement(within, "edge", id=path.name, source=path.source, target=path.target)
        _data(edge, "edge", _of_path(path, graph))
    ElementTree.indent(root)
    text: str = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'


def _of_state(state: State) -> dict[str, object]:
    return {
        "name": state.name,
        "label": state_label(state),
        "symmetric": state.symmetric,
        "mirror": state.mirror,
        "count": len(state.visits),
    }


def _of_path(path: Path, graph: MotionGraph) -> dict[str, object]:
    told: dict[str, object] = {
        "name": path.name,
        "label": path_label(path),
        "symmetric": path.symmetric,
        "reversible": path.reversible,
        "reflected": path.reflected,
        "mirror": path.mirror,
        "count": len(path.visits),
    }
    seconds = sorted((visit.stop - visit.start) / graph.rates[visit.recording] for visit in path.visits)
    return told | ({"seconds": round(seconds[len(seconds) // 2], 4)} if seconds else {})


def _data(element: ElementTree.Element, kind: str, told: dict[str, object]) -> None:
    for name, value in told.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        ElementTree.SubElement(element, "data", key=f"{kind}_{name}").text = text


def _stretch(visit: Visit, label: str, graph: MotionGraph) -> dict[str, Any]:
    rate = graph.rates[visit.recording]
    return {
        "start": visit.start,
        "stop": visit.stop,
        "start_s": round(visit.start / rate, 4),
        "stop_s": round(visit.stop / rate, 4),
        "label": label,
        "score": None,
        "recording": visit.recording,
    }


def _nodes_and_edges(graph: MotionGraph) -> list[State | Path]:
    return [*graph.states, *graph.paths]


def _comes_first(each: State | Path) -> bool:
    """Whether it is the one of a pair that has no star, or is its own image."""
    starred = each.name.endswith("*") if isinstance(each, State) else each.name.startswith("(")
    return each.mirror == each.name or not starred
