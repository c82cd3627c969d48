"""The Z/Z* plot: its colours mean what they say, in the square and in the triangle."""

import io

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from leitmotion.motion import ParameterError
from leitmotion.similarity import DoubleMetric
from leitmotion.view import plot_symmetry, symmetry_image
from leitmotion.view.symmetry import BLACK, CYAN, FORMS, RED

FAR = 1e3


def told(own, mirror, rate=10.0) -> DoubleMetric:
    return DoubleMetric(np.asarray(own), np.asarray(mirror), "inner", rate, ("pelvis",), [1.0], 2.0)


def test_red_is_like_itself_cyan_like_its_image_white_both():
    image = symmetry_image(told([[0, 0], [0, 0]], [[FAR, 0], [0, FAR]]))
    assert image[0, 0] == pytest.approx(to_rgb(RED))
    assert image[0, 1] == pytest.approx((1.0, 1.0, 1.0), abs=0.1)
    image = symmetry_image(told([[0, FAR], [FAR, 0]], [[FAR, 0], [0, np.nan]]))
    assert image[0, 1] == pytest.approx(to_rgb(CYAN))
    assert image[1, 1] == pytest.approx(to_rgb(RED))
    assert symmetry_image(told([[FAR]], [[FAR]]))[0, 0] == pytest.approx(to_rgb(BLACK))


def test_many_moments_are_averaged():
    own = np.full((5, 5), FAR)
    own[:2, :2] = 0
    image = symmetry_image(told(own, np.full((5, 5), FAR)), cells=3)
    assert image.shape == (3, 3, 3)
    assert image[0, 0] == pytest.approx(to_rgb(RED))
    assert image[2, 2] == pytest.approx(to_rgb(BLACK))


def test_the_triangle_puts_a_pair_above_its_middle():
    count = 20
    own = np.full((count, count), FAR)
    np.fill_diagonal(own, 0)
    own[4, 12] = own[12, 4] = 0
    figure = plot_symmetry(told(own, np.full((count, count), FAR)), form="triangle")
    picture = figure.axes[0].images[0]
    dots, (left, right, low, high) = picture.get_array(), picture.get_extent()
    red = (np.abs(dots[..., :3] - to_rgb(RED)).max(axis=-1) < 0.01) & (dots[..., 3] == 1)
    down, across = np.nonzero(red)
    time = left + (across + 0.5) / dots.shape[1] * (right - left)
    apart = high - (down + 0.5) / dots.shape[0] * (high - low)
    pair = apart > 0.3  # clear of the identity axis
    assert time[pair].mean() == pytest.approx((4.5 + 12.5) / 2 / 10, abs=0.01)
    assert apart[pair].mean() == pytest.approx(0.8, abs=0.01)
    assert apart[~pair].max() < 0.11


@pytest.mark.parametrize("form", FORMS)
def test_beta_stands_in_the_picture_and_it_is_the_same_twice(form):
    found = told([[0, 1], [1, 0]], [[1, 0], [0, 1]])
    figure = plot_symmetry(found, form=form, title="")
    assert "β = 2" in figure.axes[0].get_title(loc="right")
    pictures = []
    for _ in range(2):
        out = io.BytesIO()
        plot_symmetry(found, form=form).savefig(out, format="png", metadata={"Software": None})
        pictures.append(out.getvalue())
    assert pictures[0] == pictures[1]


def test_an_unknown_form_is_refused():
    with pytest.raises(ParameterError, match="form must be one of square, triangle, got 'circle'"):
        plot_symmetry(told([[0]], [[0]]), form="circle")
