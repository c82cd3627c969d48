"""The symmetric and the antisymmetric subspace: the way of a movement in each (paper S, sections 2.11 and 3.4).

Conventions
-----------
Each plot shows the first two principal axes of one part of the postures. Both have one scale, in units of the chain's
quaternions, and the origin of the antisymmetric part is where a posture is its own mirror image; so a symmetric path
stays at its origin. In the picture of a graph it is the mean of the symmetric states, where there are any, as a suit
that sits askew is no asymmetry of the movement. Lines lighten as time goes on, what only reflection made is dotted.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from leitmotion.discovery import MotionGraph
from leitmotion.features import FeatureSequence, symmetry_parts
from leitmotion.view.graph_moments import posture_of, time_of
from leitmotion.view.graph_names import in_math
from leitmotion.view.palette import Theme, mixed
from leitmotion.view.plots import SMALL, halo, style_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SMOOTH_S = 0.2  # over which the ways are averaged
MOST, IN_ALL, LEAST = 12, 72, 3  # times of one path that are drawn, about so many of all paths together
LIGHTEST = 0.72  # how far the end of a path is mixed into the surface
WORDS = ("symmetric part", "antisymmetric part")
AIR = 1.14  # around the ways
DOTTED = (0, (0.6, 2.2))
IN_A_ROW = 4  # names of states that lie together
PIECES, POINTS = 24, 9  # of a line, each lighter than the one before; of a piece, as many as are seen


class Subspaces(NamedTuple):
    """The postures of recordings in two planes."""

    symmetric: list[np.ndarray]
    """(T, 2) of each recording: the first two principal axes of S, from its mean."""

    antisymmetric: list[np.ndarray]
    """(T, 2) of each recording: the first two principal axes of A, from the origin; negative in the mirror image."""


def find_subspaces(chains: Sequence[FeatureSequence]) -> Subspaces:
    """Lay the symmetric and antisymmetric parts of postures into planes.

    Parameters
    ----------
    chains : sequence of FeatureSequence
        The kinematic chain of each recording, of the same links.

    Returns
    -------
    Subspaces
        The two planes in which most of the movement goes on; moments that were not seen are NaN.

    Raises
    ------
    ParameterError
        When the features have no mirror image.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> planes = find_subspaces([kinematic_chain(compose_session(seed=0, rate=30.0).motion)])
    >>> planes.antisymmetric[0].shape[1]
    2
    """
    parts = [symmetry_parts(_on_one_side(chain, chains[0])) for chain in chains]
    return Subspaces(
        _plane([part.symmetric.values for part in parts], centred=True),
        _plane([part.antisymmetric.values for part in parts], centred=False),
    )


def plot_subspaces(
    axes: Sequence[Axes], graph: MotionGraph, chains: Sequence[FeatureSequence], colours: Theme
) -> None:
    """Draw a graph's states and paths in both subspaces.

    Parameters
    ----------
    axes : sequence of two Axes
        For S and for A.
    graph : MotionGraph
        Its visits count frames of `chains`.
    chains : sequence of FeatureSequence
        The kinematic chain of each recording.
    colours : Theme
        Of which theme.
    """
    planes = [
        [_smoothed(line, chain.rate) for line, chain in zip(plane, chains, strict=True)]
        for plane in find_subspaces(chains)
    ]
    planes[1] = [line - _origin(graph, k, line) for k, line in enumerate(planes[1])]
    lines = [_lines(graph, plane, hand) for plane, hand in zip(planes, (1.0, -1.0), strict=True)]
    marks = [_marks(graph, plane, hand, chains) for plane, hand in zip(planes, (1.0, -1.0), strict=True)]
    told = [
        np.concatenate(
            [
                np.zeros((1, 2)),
                *(line for line, _ in some),
                *(list(each.values()) for each in [where] if where),
            ]
        )
        for some, where in zip(lines, marks, strict=True)
    ]
    low, high = np.nanmin(told[0][1:], axis=0, initial=0.0), np.nanmax(told[0][1:], axis=0, initial=0.0)
    reach = AIR * max(float((high - low).max()) / 2, float(np.nanmax(np.abs(told[1]))), 1e-6)
    middles = ((low + high) / 2, np.zeros(2))
    for plot, word, some, where, middle in zip(axes, WORDS, lines, marks, middles, strict=True):
        style_axes(plot, colours)
        plot.set(xlim=middle[0] + np.array([-reach, reach]), ylim=middle[1] + np.array([-reach, reach]))
        plot.set(xticks=[], yticks=[], aspect="equal")
        plot.set_title(word, loc="left", fontsize=SMALL, color=colours.ink2, pad=4)
        for spine in plot.spines.values():
            spine.set(visible=True, color=colours.line, linewidth=0.6)
        if word == WORDS[1]:
            plot.axhline(0, color=colours.line, lw=0.6, zorder=0)
            plot.axvline(0, color=colours.line, lw=0.6, zorder=0)
        for line, reflected in some:
            _draw_line(plot, line, reflected, colours)
        _name(plot, graph, where, 0.16 * reach, colours)


def _smoothed(line: np.ndarray, rate: float) -> np.ndarray:
    """Average over :data:`SMOOTH_S`, so that noise does not hide the way."""
    window = np.hanning(max(1, round(SMOOTH_S * rate)) + 2)[1:-1]
    ends = len(window) // 2, len(window) - 1 - len(window) // 2
    padded = np.pad(line, (ends, (0, 0)), mode="edge")
    return np.stack([np.convolve(column, window / window.sum(), mode="valid") for column in padded.T], axis=1)


def _origin(graph: MotionGraph, recording: int, line: np.ndarray) -> np.ndarray:
    """Where a recording's symmetric states lie in the antisymmetric subspace: 0 where it visits none."""
    visits = [visit for state in graph.states if state.symmetric for visit in state.visits]
    middles = [(visit.start + visit.stop - 1) // 2 for visit in visits if visit.recording == recording]
    seen = line[middles][np.isfinite(line[middles]).all(axis=1)]
    return np.asarray(seen.mean(axis=0)) if len(seen) else np.zeros(2)


def _lines(graph: MotionGraph, plane: Sequence[np.ndarray], hand: float) -> list[tuple[np.ndarray, bool]]:
    """The ways of all paths in a plane, and whether only reflection made them."""
    found = []
    most = min(MOST, max(LEAST, IN_ALL // max(len(graph.paths), 1)))
    for path in graph.paths:
        if path.reflected:
            time = time_of(path, graph)
            visits = [] if time is None else [time.visit]
        else:
            visits = list(path.visits[:most])
        for visit in visits:
            line = plane[visit.recording][visit.start : visit.stop]
            found.append((line * (hand if path.reflected else 1.0), path.reflected))
    return found


def _marks(
    graph: MotionGraph, plane: Sequence[np.ndarray], hand: float, chains: Sequence[FeatureSequence]
) -> dict[str, np.ndarray]:
    """The places of the states in a plane."""
    found = {}
    for state in graph.states:
        moment = posture_of(state, graph, chains)
        if moment is not None:
            found[state.name] = plane[moment.recording][moment.frame] * (hand if moment.mirrored else 1.0)
    return found


def _draw_line(plot: Axes, line: np.ndarray, reflected: bool, colours: Theme) -> None:
    """Draw a way that lightens as time goes on, or a dotted one."""
    from matplotlib.collections import LineCollection

    if reflected:
        grey = mixed(colours.ink, 0.5, colours.surface)
        plot.plot(*line.T, color=grey, lw=1.0, ls=DOTTED, dash_capstyle="round", zorder=1)
        return
    cuts = np.linspace(0, len(line) - 1, min(PIECES, max(len(line) - 1, 1)) + 1).round().astype(int)
    pieces = [
        line[np.unique(np.linspace(a, b, POINTS).round().astype(int))] for a, b in itertools.pairwise(cuts)
    ]
    tones = [mixed(colours.ink, 1 - LIGHTEST * k / PIECES, colours.surface) for k in range(len(pieces))]
    plot.add_collection(LineCollection(pieces, colors=tones, linewidths=1.1, capstyle="round", zorder=2))


def _name(plot: Axes, graph: MotionGraph, marks: dict[str, np.ndarray], near: float, colours: Theme) -> None:
    """Mark the states; those that lie together share a line of names."""
    together: list[list[str]] = []
    for name, place in marks.items():
        group = next((each for each in together if np.hypot(*(marks[each[0]] - place)) < near), None)
        if group is None:
            together.append([name])
        else:
            group.append(name)
    states = {state.name: state for state in graph.states}
    for group in together:
        for name in group:
            plot.plot(*marks[name], "o", ms=3.4, color=colours.ink, mec=colours.surface, mew=0.8, zorder=4)
        rows = [group[k : k + IN_A_ROW] for k in range(0, len(group), IN_A_ROW)]
        words = "\n".join("$" + ",\\,".join(in_math(states[name]) for name in row) + "$" for row in rows)
        place = np.mean([marks[name] for name in group], axis=0)
        leftward = place[0] > sum(plot.get_xlim()) / 2
        plot.annotate(
            words, place, xytext=(-5 if leftward else 5, 3), textcoords="offset points", fontsize=SMALL,
            ha="right" if leftward else "left", color=colours.ink,
            path_effects=halo(colours, 2.2)["path_effects"], zorder=5,
        )  # fmt: skip


def _on_one_side(chain: FeatureSequence, first: FeatureSequence) -> FeatureSequence:
    """Of q and -q take, link by link, the one on the side of the first recording."""
    means = [np.nanmean(each.values, axis=0).reshape(-1, each.width) for each in (chain, first)]
    signs = np.where((means[0] * means[1]).sum(axis=1) < 0, -1.0, 1.0)
    return chain.replace(values=chain.values * np.repeat(signs, chain.width))


def _plane(parts: Sequence[np.ndarray], *, centred: bool) -> list[np.ndarray]:
    """Project onto the two axes along which most of the movement goes."""
    told = np.concatenate(parts)
    told = told[np.isfinite(told).all(axis=1)]
    middle = told.mean(axis=0) if centred and len(told) else np.zeros(parts[0].shape[1])
    _, axes = np.linalg.eigh((told - middle).T @ (told - middle))
    two = axes[:, ::-1][:, :2]
    two = two * np.sign(two[np.abs(two).argmax(axis=0), [0, 1]])
    return [(part - middle) @ two for part in parts]
