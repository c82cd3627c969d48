"""Small performances whose motion graph is known, because they are posed along it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.datasets._posing import ABDUCTION, ELBOW, FLEXION, Posture, as_motion, pose
from leitmotion.datasets.skeleton import human_skeleton
from leitmotion.discovery import MotionGraph, Path, State, Visit
from leitmotion.motion import Motion

RATE, DWELL_S, WAY_S, HEIGHT = 30.0, 0.3, 0.8, 1.75
Way = tuple[str, str, str]  # name, source, target


def starred(name: str) -> str:
    """Name the mirror image of a state or a path."""
    if name.endswith(")*"):
        return name[1:-2]
    if name.endswith("*") and len(name) == 2:
        return name[:-1]
    return name + "*" if len(name) == 1 else f"({name})*"


def graph_of(
    states: Sequence[str],
    ways: Sequence[tuple[str, str, str, str]],
    visits: dict[str, list[Visit]] | None = None,
) -> MotionGraph:
    """Write a graph down: of each path its name, ends, and of "s" symmetric, "r" reversible, "d" dotted what it is."""
    seen = {} if visits is None else visits

    def gone(name: str, kind: str = "") -> tuple[Visit, ...]:
        if visits is not None or "d" in kind:
            return tuple(seen.get(name, []))
        return Visit(0, 0, 30), Visit(0, 40, 70)

    names = {way[0] for way in ways}
    made = []
    for name in states:
        symmetric = name in "XYZTUVWSR"
        mirror = name if symmetric else starred(name) if starred(name) in states else ""
        made.append(State(name, symmetric, gone(name), mirror))
    paths = []
    for name, source, target, kind in ways:
        mirror = name if "s" in kind else starred(name) if starred(name) in names else ""
        paths.append(Path(name, source, target, "s" in kind, "r" in kind, gone(name, kind), mirror))
    return MotionGraph(tuple(made), tuple(paths), ("performed",), (RATE,), 0.9, {})


GRAPHS = {
    "butterfly": graph_of(["X"], [("xx", "X", "X", "s")]),
    "jumping_jacks": graph_of(["X", "Y"], [("xy", "X", "Y", "sr")]),
    "jogging": graph_of(["A", "X", "A*"], [("ax", "A", "X", "r"), ("(ax)*", "A*", "X", "r")]),
    "walking": graph_of(["A", "A*"], [("aa*", "A", "A*", ""), ("(aa*)*", "A*", "A", "")]),
    "limping": graph_of(["A"], [("aa", "A", "A", "")]),
    "side_kicks": graph_of(
        ["A", "X", "A*"],
        [("aa", "A", "A", ""), ("ax", "A", "X", "r"), ("(ax)*", "A*", "X", "r"), ("(aa)*", "A*", "A*", "")],
    ),
    "racemized": graph_of(
        ["A", "X", "A*"],
        [("aa", "A", "A", ""), ("ax", "A", "X", "r"), ("(ax)*", "A*", "X", "rd"), ("(aa)*", "A*", "A*", "d")],
    ),
    "sun_salutation": graph_of(
        ["Y", "X", "T", "W", "V"],
        [
            ("yx", "Y", "X", "sr"), ("yy", "Y", "Y", "sr"), ("xt", "X", "T", "sr"), ("tw", "T", "W", "sr"),
            ("wv", "W", "V", ""), ("vv", "V", "V", "s"), ("vw", "V", "W", "s"),
        ],
    ),
    "twelve": graph_of(
        ["X", "Y", "A", "B", "C", "D", "E", "A*", "B*", "C*", "D*", "E*"],
        [
            ("xa", "X", "A", ""), ("ab", "A", "B", ""), ("bc1", "B", "C", ""), ("bc2", "B", "C", ""),
            ("cx", "C", "X", ""), ("xd", "X", "D", "r"), ("dd", "D", "D", ""), ("de", "D", "E", ""),
            ("ey", "E", "Y", ""), ("xy", "X", "Y", "s"), ("yx", "Y", "X", ""), ("(xa)*", "X", "A*", ""),
            ("(ab)*", "A*", "B*", "d"), ("(bc1)*", "B*", "C*", "d"), ("(bc2)*", "B*", "C*", "d"),
            ("(cx)*", "C*", "X", "d"), ("(xd)*", "X", "D*", "rd"), ("(dd)*", "D*", "D*", "d"),
            ("(de)*", "D*", "E*", "d"), ("(ey)*", "E*", "Y", "d"), ("(yx)*", "Y", "X", "d"),
            ("aa*", "A", "A*", ""), ("(aa*)*", "A*", "A", ""),
        ],
    ),
    "twelve_one_sided": graph_of(
        ["X", "Y", "Z", "A", "B", "C", "D", "E", "F", "G", "H", "I"],
        [
            ("xa", "X", "A", ""), ("ab", "A", "B", ""), ("bc", "B", "C", ""), ("cy", "C", "Y", ""),
            ("yd", "Y", "D", ""), ("de", "D", "E", "r"), ("ef", "E", "F", ""), ("fz", "F", "Z", ""),
            ("zx", "Z", "X", "s"), ("zg", "Z", "G", ""), ("gh", "G", "H", ""), ("hi", "H", "I", ""),
            ("ix", "I", "X", ""), ("hh", "H", "H", ""), ("yz", "Y", "Z", "sr"),
        ],
    ),
    "nine_symmetric": graph_of(
        ["X", "Y", "Z", "T", "U", "V", "W", "S", "R"],
        [
            ("xy", "X", "Y", "sr"), ("yz", "Y", "Z", "s"), ("zx", "Z", "X", "s"), ("zt", "Z", "T", "s"),
            ("tu", "T", "U", "s"), ("ut", "U", "T", "s"), ("uv", "U", "V", ""), ("vw", "V", "W", "s"),
            ("ws", "W", "S", "s"), ("sr", "S", "R", "s"), ("rx", "R", "X", "s"),
        ],
    ),
}  # fmt: skip
"""The graphs of paper S, 3.5 and 3.6, and larger ones; their visits are made up."""


def perform(graph: MotionGraph, course: str, *, seed: int = 0) -> tuple[Motion, MotionGraph]:
    """Pose a person along the paths of a graph, and give it the visits of what was performed.

    `course` names the paths in order, one that is gone back with a minus. Each state gets a posture by its
    letter, an asymmetric one with different arms; a path from a state to itself goes by way of another posture.
    """
    paths = {path.name: path for path in graph.paths}
    visits: dict[str, list[Visit]] = {}
    spans: list[np.ndarray] = []
    frames = 0
    dwell, way = round(DWELL_S * RATE), round(WAY_S * RATE)
    rng = np.random.default_rng(seed)

    def hold(name: str) -> None:
        nonlocal frames
        spans.append(np.tile(_numbers(name), (dwell, 1)))
        visits.setdefault(name, []).append(Visit(0, frames, frames + dwell))
        frames += dwell

    for step in course.split():
        name, back = step.lstrip("-"), step.startswith("-")
        path = paths[name]
        ends = [path.source, path.target][:: -1 if back else 1]
        if not spans:
            hold(ends[0])
        length = way + int(rng.integers(-5, 6))
        part = (1 - np.cos(np.linspace(0, np.pi, length + 2)[1:-1]))[:, None] / 2
        between = _numbers(ends[0]) * (1 - part) + _numbers(ends[1]) * part
        via = np.sin(np.pi * part) * (_numbers("~" + name) - between)
        spans.append(between + (via if path.source == path.target or not path.symmetric else 0.3 * via))
        visits.setdefault(name, []).append(Visit(0, frames, frames + length, back))
        frames += length
        hold(ends[1])
    told = np.concatenate(spans)
    skeleton = human_skeleton(HEIGHT)
    hips, turned = pose(skeleton, _posture(told), height=HEIGHT)
    motion = as_motion(skeleton, hips, turned, rate=RATE, name="performed")
    whole = graph_of(
        [state.name for state in graph.states],
        [
            (
                path.name,
                path.source,
                path.target,
                "s" * path.symmetric + "r" * path.reversible + "d" * path.reflected,
            )
            for path in graph.paths
        ],
        {name: told for name, told in visits.items()},
    )
    return motion, whole


def _numbers(name: str) -> np.ndarray:
    """A posture as ten numbers by its name: of each arm flexion, abduction and bend, of each foot how it is lifted."""
    base = name.strip("~()*").lower()
    rng = np.random.default_rng(
        [ord(letter) for letter in name.replace("*", "").replace("(", "").replace(")", "")]
    )
    arms = rng.uniform((0, 0.1, 0.1), (2.4, 1.6, 1.5), (2, 3))
    feet = np.array([0.0, 0.45 if name.startswith("~") else 0.0])
    bend = rng.uniform(0, 0.5)
    if all(letter in "xyztuvwsr" for letter in base):
        arms[1], feet[:] = arms[0], 0.0
    if "*" in name:
        arms, feet = arms[::-1], feet[::-1]
    return np.concatenate([arms.ravel(), feet, [bend, bend]])


def _posture(told: np.ndarray) -> Posture:
    posture = Posture.standing(len(told))
    arms = told[:, :6].reshape(-1, 2, 3)
    posture.arms[..., FLEXION], posture.arms[..., ABDUCTION], posture.arms[..., ELBOW] = np.moveaxis(
        arms, 2, 0
    )
    posture.feet[..., 1] += told[:, 6:8] * 0.4
    posture.feet[..., 0] += told[:, 6:8] * 0.6
    posture.free[:] = np.minimum(1, told[:, 6:8] * 5)
    posture.hips[:, 1] -= 0.12 * told[:, 8]
    posture.trunk[:, 1] += told[:, 8]
    return posture
