"""The figure of a calibration shows what was calibrated."""

import numpy as np
import pytest

from leitmotion.evaluation import equal_error_rate, errors_at
from leitmotion.motion import ParameterError
from leitmotion.view import plot_calibration


@pytest.fixture
def found(rng):
    distances = np.concatenate((rng.gamma(3.0, 0.02, 40), rng.gamma(4.0, 0.06, 30)))
    alike = np.arange(70) < 40
    calibration = equal_error_rate(distances, alike)
    return calibration.replace(check=errors_at(calibration.threshold, distances[::3], alike[::3]))


def test_both_curves_and_where_they_are_equal(found):
    axes = plot_calibration(found).axes[0]
    lines = {line.get_label(): line for line in axes.get_lines()}
    for rates, words in ((found.false_non_match, "alike, but taken for different (of 40)"),
                         (found.false_match, "different, but taken for alike (of 30)")):  # fmt: skip
        assert lines[words].get_xdata()[: len(rates)].tolist() == found.thresholds.tolist()
        assert lines[words].get_ydata()[: len(rates)].tolist() == rates.tolist()
        assert lines[words].get_drawstyle() == "steps-post"
    (point,) = (line for label, line in lines.items() if label.startswith("both rates equal"))
    assert (point.get_xdata()[0], point.get_ydata()[0]) == (found.threshold, found.equal_error_rate)


def test_the_check_group_stands_at_the_threshold(found):
    axes = plot_calibration(found, theme="dark").axes[0]
    rings = [line for line in axes.get_lines() if line.get_label().startswith("check group")]
    assert [ring.get_ydata()[0] for ring in rings] == [found.check.false_non_match, found.check.false_match]
    assert {ring.get_xdata()[0] for ring in rings} == {found.threshold}
    without = plot_calibration(found.replace(check=None)).axes[0]
    assert len(without.get_lines()) == len(axes.get_lines()) - 2


def test_the_unit_and_the_theme(found):
    assert plot_calibration(found, measured_in="radians").axes[0].get_xlabel().endswith("radians")
    with pytest.raises(ParameterError, match="theme must be one of"):
        plot_calibration(found, theme="red")


def test_the_axes_have_titles_and_the_band_a_word(found):
    axes = plot_calibration(found).axes[0]
    assert axes.get_ylabel() == "pairs judged wrongly"
    (band,) = (patch for patch in axes.patches if patch.get_label() == "95 % interval of the threshold")
    low, high = found.threshold_interval
    assert (band.get_x(), band.get_x() + band.get_width()) == pytest.approx((low, high))
    assert "95 % interval of the threshold" in [text.get_text() for text in axes.get_legend().get_texts()]
