"""The time line of symmetry: a lane for each motif, all of its stretches, and nothing where nothing was found."""

import numpy as np
import pytest
from matplotlib.patches import Rectangle

from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.motion import ParameterError
from leitmotion.view import plot_motifs


def bars(figure):
    return [patch for patch in figure.axes[0].patches if isinstance(patch, Rectangle)]


def test_every_stretch_has_a_bar_in_the_lane_of_its_motif():
    spans = (
        SymmetrySpan("anti_phase", 30, 150, 0.9, cyclic=True, marks=[30, 60, 90, 120, 150]),
        SymmetrySpan("path_repetition", 0, 30, 0.4, partner=(180, 210)),
        SymmetrySpan("anti_phase", 200, 260, 0.8),
    )
    figure = plot_motifs(Symmetry(spans, 30.0, 300, {}, strikes=[45]))
    drawn = sorted((bar.get_y() // 1, bar.get_x(), bar.get_width()) for bar in bars(figure))
    assert np.allclose(drawn, [(0, 1, 4), (0, 200 / 30, 2), (1, 0, 1), (1, 6, 1)])
    assert [bool(bar.get_hatch()) for bar in sorted(bars(figure), key=lambda bar: bar.get_y())] == [
        False, False, True, True,
    ]  # fmt: skip
    heads = [text.get_text() for text in figure.axes[0].texts]
    assert {"anti-phase", "path repetition"} <= set(heads)
    strikes = [line for line in figure.axes[0].lines if line.get_marker() == "v"]
    assert strikes[0].get_xdata().tolist() == [1.5]


def test_nothing_found_is_said():
    figure = plot_motifs(Symmetry((), 30.0, 300, {}))
    assert bars(figure) == []
    assert [text.get_text() for text in figure.axes[0].texts] == ["No motif of symmetry was found"]


def test_an_unknown_theme_is_refused():
    with pytest.raises(ParameterError, match="theme must be one of light, dark, got 'red'"):
        plot_motifs(Symmetry((), 30.0, 300, {}), theme="red")
