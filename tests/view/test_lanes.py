"""The time line of several recordings: a lane for each."""

import numpy as np
import pytest
from matplotlib.patches import Rectangle

from leitmotion.discovery import Places, SharedPattern, SharedPatterns
from leitmotion.motion import ParameterError
from leitmotion.view import plot_shared_patterns


def shared(recordings, names, seconds=10):
    places = Places(recordings, [0] * len(recordings), [30] * len(recordings))
    pattern = SharedPattern("A", "acyclic", places, places, 1.0, 0.1, 0.9)
    count = len(names)
    return SharedPatterns((pattern,), (), names, [30.0] * count, [30 * seconds] * count, {})


def bars(figure):
    found = [patch for patch in figure.axes[0].patches if isinstance(patch, Rectangle)]
    return sorted({int(bar.get_y()) for bar in found}), {bar.get_width() for bar in found}


def test_each_recording_has_its_lane_and_its_own_seconds():
    figure = plot_shared_patterns(shared([0, 2], ("a", "b", "c")))
    lanes, widths = bars(figure)
    assert lanes == [0, 2]
    assert widths == {1.0}
    written = [text.get_text() for text in figure.axes[0].texts]
    assert written[:6] == ["a", "1", "b", "–", "c", "1"]
    assert written[6:] == ["A", "A"]
    assert figure.axes[0].get_xlim() == (0, 10)


def test_many_recordings_and_long_names_stay_readable():
    names = tuple(f"{'folder/' * 9}{k:03d}.bvh" for k in range(60))
    figure = plot_shared_patterns(shared([0, 59], names))
    figure.canvas.draw()
    texts = figure.axes[0].texts
    lane = figure.axes[0].bbox.height / 60
    assert all(text.get_window_extent().height < 1.3 * lane for text in texts[:120])
    for name, count in zip(texts[0:120:2], texts[1:120:2], strict=True):
        assert name.get_window_extent().x0 >= 0
        assert name.get_window_extent().x1 <= count.get_window_extent().x0
        assert name.get_text().endswith(f"{texts.index(name) // 2:03d}.bvh")


def test_an_unknown_theme_is_refused():
    with pytest.raises(ParameterError, match="theme must be one of"):
        plot_shared_patterns(shared([0, 1], ("a", "b")), theme="sepia")


def test_nothing_shared_is_drawn_as_empty_lanes():
    empty = SharedPatterns((), (), ("a", "b"), np.array([30.0, 60.0]), np.array([300, 1200]), {})
    assert bars(plot_shared_patterns(empty)) == ([], set())
