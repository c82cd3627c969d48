"""The figures of the papers' pages: each is drawn from a small session, and what it shows is what was found."""

import importlib
import re
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.patches import Rectangle

from leitmotion import body, features
from leitmotion.datasets import Action, compose

ROOT = Path(__file__).resolve().parents[1]
PAGES = ROOT / "docs" / "papers"


@pytest.fixture(scope="module")
def script():
    sys.path[:0] = [str(ROOT / "docs"), str(ROOT / "benchmarks")]
    yield importlib.import_module("make_paper_figures")
    del sys.path[:2]


@pytest.fixture(scope="module")
def paper(script):
    return importlib.import_module("paper_p")


@pytest.fixture(scope="module")
def session():
    return compose([Action("squat", 4)], rate=60)


@pytest.fixture(scope="module")
def sequence(session):
    return features.posture(body.embody(session.motion))


def titles(figure):
    return [axes.get_title(loc="left") for axes in figure.axes]


def test_the_grey_matrix_shows_its_lower_half(paper, session, sequence):
    figure = paper.grey_matrix(sequence, session.stretches)
    (image,) = figure.axes[0].images
    shown = np.ma.filled(image.get_array(), np.nan)
    later = np.arange(len(shown)) > np.arange(len(shown))[:, None]
    assert np.isnan(shown[~later]).all()
    assert np.isfinite(shown[later]).all()
    assert "squat" in [text.get_text() for text in figure.axes[0].texts]


def test_a_cut_is_a_piece_of_the_matrix(paper, sequence):
    cut = paper.Cut("crossing", sequence, (2.0, 3.5), (0.5, 1.5))
    figure = paper.dark_patterns([cut, cut])
    assert [text.get_text() for text in figure.texts] == ["(a) crossing", "(b) crossing"]
    assert figure.axes[0].images[0].get_array().shape == (60, 90)
    assert figure.axes[0].images[0].get_extent() == pytest.approx((2.0, 3.5, 0.5, 1.5))


def test_tracing_shows_a_start_point_of_the_method(paper, sequence):
    figure = paper.tracing(sequence, (2.0, 8.0), (0.0, 6.0))
    assert [title[:3] for title in titles(figure)] == ["(a)", "(b)", "(c)", "(d)"]
    steps = paper.traced(sequence)
    marks = figure.axes[0].lines[-1].get_xydata() * paper.RATE
    (start,) = [tuple(round(at) for at in mark) for mark in marks]
    assert start in steps.starts
    regions = {patch.get_xy() for patch in figure.axes[1].patches if isinstance(patch, Rectangle)}
    assert len(regions) == 2
    assert all((x > start[0] / 60) == (y > start[1] / 60) for x, y in regions)
    assert len(figure.axes[2].patches) >= 1


def test_a_family_stands_in_the_matrix_and_in_time(paper, sequence):
    figure = paper.cyclic_family(sequence)
    family = paper.largest_family(paper.traced(sequence))
    assert len(figure.axes[0].lines) == len(family) >= 2
    assert len(figure.axes[1].patches) == 2 * len(family)


def test_peaks_are_the_borders_of_the_cycles(paper, sequence):
    figure = paper.cycle_peaks(sequence)
    assert [text.get_text() for text in figure.axes[0].texts] == ["1", "2", "3"]


def test_figures_are_the_same_to_the_byte(script, paper, sequence):
    once, again = (script.as_webp(paper.cycle_peaks(sequence)) for _ in range(2))
    assert once == again
    assert once[8:12] == b"WEBP"


def test_every_figure_is_on_a_page_and_small(script):
    shown = set()
    for page in PAGES.glob("*.md"):
        shown |= set(re.findall(r"\(figures/([\w-]+)\.webp\)", page.read_text(encoding="utf-8")))
    assert shown == set(script.figures())
    assert {path.stem for path in (PAGES / "figures").iterdir()} == shown
    assert all(path.stat().st_size < 150_000 for path in (PAGES / "figures").iterdir())


def test_an_unknown_figure_is_told(script, capsys, monkeypatch, tmp_path):
    monkeypatch.setenv("LEITMOTION_DATA", str(tmp_path))
    assert script.main(["p-99"]) == 2
    assert "There is no figure p-99; there are p-06-matrix" in capsys.readouterr().err
    monkeypatch.delenv("LEITMOTION_DATA")
    assert script.main([]) == 1
    assert "LEITMOTION_DATA must name the folder" in capsys.readouterr().err
