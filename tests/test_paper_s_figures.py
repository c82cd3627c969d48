"""The figures of paper S: every motif has two examples, and what stands beneath a picture is what was told."""

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.datasets import compose_motif
from leitmotion.discovery.symmetry_span import MOTIFS, PAIRED

ROOT = Path(__file__).resolve().parents[1]
COMPOSED, REAL = 0, 1


@pytest.fixture(scope="module")
def paper():
    sys.path[:0] = [str(ROOT / "docs"), str(ROOT / "benchmarks")]
    yield importlib.import_module("paper_s")
    del sys.path[:2]


@pytest.fixture(scope="module")
def motions(paper):
    return importlib.import_module("paper_s_motions")


def texts(figure):
    return [text.get_text() for text in figure.texts]


def test_every_motif_has_its_figure(paper):
    assert tuple(paper.CASES) == MOTIFS
    for motif, cases in paper.CASES.items():
        assert f"s-{motif.replace('_', '-')}" in paper.FIGURES
        assert all((case.partner is not None) == (motif in PAIRED) for case in cases)
    assert all(cases[COMPOSED].source in {*lm.datasets.MOTIONS, paper.KICK} for cases in paper.CASES.values())


@pytest.mark.parametrize("motif", MOTIFS)
def test_composed_examples_are_told(paper, motif):
    case = paper.CASES[motif][COMPOSED]
    span = paper.told(case, motif)
    assert span is not None
    rate = paper.read(case.source).rate
    told = [(span.start, span.stop), *([span.partner] if span.partner else [])]
    wanted = [case.at, *([case.partner] if case.partner else [])]
    for (start, stop), (a, b) in zip(told, wanted, strict=True):
        assert min(stop / rate, b) - max(start / rate, a) > 0.5 * min(b - a, (stop - start) / rate)


def test_a_motif_that_is_not_told_is_dashed(paper):
    walk = paper.Case("walking", (0.0, 2.0), (0.5, 1.5))
    assert paper.told(walk, "stillness") is None
    figure = paper.new_figure(paper.BASE, 1.0)
    axes = figure.add_axes((0, 0, 1, 1))
    paper._beneath(axes, walk, None)
    (bracket,) = axes.lines
    assert bracket.is_dashed()
    seconds = bracket.get_xdata()[[0, -1]] * 2.0 / paper.BASE
    assert seconds == pytest.approx([0.5, 1.5])


def test_a_bracket_is_where_the_motif_was_told(paper):
    case = paper.CASES["anti_phase"][COMPOSED]
    span = paper.told(case, "anti_phase")
    axes = paper.new_figure(paper.BASE, 1.0).add_axes((0, 0, 1, 1))
    paper._beneath(axes, case, span)
    bracket, *ticks = axes.lines
    assert not bracket.is_dashed()
    rate, (start, stop) = paper.read("walking").rate, case.shown
    marks = [tick.get_xdata()[0] / paper.BASE * (stop - start) + start for tick in ticks]
    assert marks == pytest.approx([mark / rate for mark in span.marks[1:-1] if start < mark / rate < stop])
    assert len(marks) >= 9


def test_z_and_its_mirror_make_the_picture(paper):
    figure = paper.composition()
    own, mirror, both = (axes.images[0].get_array() for axes in figure.axes)
    assert own.shape == mirror.shape == both.shape
    assert np.allclose(np.minimum(own + mirror, 1.0), both, atol=0.13)  # black is not quite black
    assert own[..., 0].max() > 0.9 > 0.5 > own[..., 1].max()
    assert mirror[..., 2].max() > 0.8 > 0.2 > mirror[..., 0].max()


def test_a_worked_motion_shows_its_notation_and_visits(motions):
    motion = compose_motif("side kicks", seed=0, rate=60).motion
    graph = lm.motion_graph(motion)
    figure = motions.draw_worked(motion, graph)
    visits = sum(len(state.visits) for state in graph.states)
    square = figure.axes[0]
    assert len(square.texts) == visits > 5
    places = sorted(text.get_position()[1] for text in square.texts)
    assert min(np.diff(places)) > 0
    assert "A" in texts(figure)[0]
    assert len(figure.axes) == 2 + len(graph.paths)
    high = figure.get_size_inches()[1]
    assert all(axes.get_position().y0 * high + 1e-6 >= 0 for axes in figure.axes)


def test_strikes_are_marked_and_the_fastest_cut_out(motions):
    motion = compose_motif("jumping jacks", seed=0, rate=60).motion
    strikes = np.array([1.0, 2.0, 3.5, 5.0])
    square, curve, *cuts = motions.draw_strikes(motion, strikes).axes
    assert square.lines[0].get_xdata() == pytest.approx(strikes)
    assert curve.lines[0].get_xdata() == pytest.approx(strikes)
    middles = [float(np.mean(cut.get_xlim())) for cut in cuts]
    assert len(middles) == 3
    assert middles == sorted(middles)
    assert all(np.isclose(strikes, middle).any() for middle in middles)


def test_letters_are_spread_and_stay_in_order(motions):
    at = np.array([0.0, 0.1, 0.15, 5.0, 9.9, 10.0])
    spread = motions.spread(at, 0.5, 10.0)
    assert (np.diff(spread) >= 0.5 - 1e-9).all()
    assert spread[-1] <= 10.0
    assert spread[3] == 5.0
    assert (motions.spread(at, 0.01, 10.0) == at).all()


@pytest.mark.data
@pytest.mark.parametrize("motif", MOTIFS)
def test_real_examples_are_told(paper, motif, data, monkeypatch):
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    figure = paper.motif_figure(motif)
    assert "not told" not in texts(figure)
