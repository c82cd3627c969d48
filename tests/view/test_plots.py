"""Static figures: what is drawn where, in which colour, and that nothing global is touched."""

import io
import subprocess
import sys

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from leitmotion.body import ANALYSIS_ROLES, Body
from leitmotion.discovery import Pattern, PatternPair, Patterns
from leitmotion.motion import ParameterError, Segmentation
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view.palette import THEMES
from leitmotion.view.payload import page_payload
from leitmotion.view.plots import plot_figures, plot_matrix, plot_patterns
from leitmotion.view.stick_figures import figure_shapes
from leitmotion.view.words import lane_head

LIGHT = THEMES["light"]


def matrix(unit="m", scale=1.0, n=120, rate=30.0):
    t = np.arange(n) / rate
    return SimilarityMatrix(abs(np.sin(3 * t)[:, None] - np.sin(3 * t)), "mean_norm", rate, rate, scale, unit)


def pattern(name="A", kind="cyclic", confidence=0.9, rate=30.0):
    cycles = Segmentation([0, 30, 60], [30, 60, 90], (name,) * 3, [0.9] * 3, rate)
    stretch = Segmentation([0], [100], (name,), [0.9], rate) if kind == "cyclic" else cycles
    return Pattern(name, kind, cycles, stretch, 1.0, 0.05, confidence)


def patterns(*which):
    path = np.stack([np.arange(60), np.arange(60) + 30], axis=1)
    return Patterns(which, (), 30.0, {}, stripes=tuple(PatternPair(p.id, path, 0.05) for p in which))


def person(turn=0.0, place=(0.0, 0.0, 0.0), roles=ANALYSIS_ROLES):
    at = {
        "pelvis": (0, 1.0, 0), "neck": (0, 1.5, 0), "head": (0, 1.65, 0.03),
        "shoulder": (0.18, 1.45, 0), "elbow": (0.2, 1.15, -0.05), "wrist": (0.2, 0.9, 0.1),
        "hip": (0.1, 0.95, 0), "knee": (0.1, 0.5, 0.05), "ankle": (0.1, 0.08, -0.05),
    }  # fmt: skip
    points = []
    for role in roles:
        side, _, joint = role.rpartition("_")
        x, y, z = at[joint]
        points.append(((-x if side == "right" else x), y, z))
    x, y, z = np.array(points).T
    turned = [np.cos(turn) * x + np.sin(turn) * z, y, np.cos(turn) * z - np.sin(turn) * x]
    positions = np.stack(turned, axis=1) + place
    return Body(roles, positions[None], np.array([turn]), rate=60, size=1.5)


def texts(figure):
    return [t.get_text() for t in figure.texts] + [t.get_text() for ax in figure.axes for t in ax.texts]


def test_a_stripe_stands_above_the_diagonal_in_its_colour():
    figure = plot_matrix(matrix(), patterns(pattern("B")))
    lines = [line for line in figure.axes[0].lines if len(line.get_xdata()) == 60]
    (stripe,) = lines
    assert to_hex(stripe.get_color(), keep_alpha=False).upper() == LIGHT.patterns[1]
    np.testing.assert_allclose(stripe.get_xdata() - stripe.get_ydata(), 1.0)
    low, high = figure.axes[0].get_ylim()
    assert (low, high) == (4.0, 0.0)


@pytest.mark.parametrize(
    ("unit", "scale", "words"),
    [
        ("m", 0.1, "cm apart or more"),
        ("m", 0.01, "8 cm apart or more"),
        ("rad", 1.0, "° apart or more"),
        ("px", 1.0, "px apart or more"),
        ("px", 0.2, "10% of body size apart or more"),
        ("m/s", 0.1, "cm/s apart or more"),
    ],
)
def test_the_legend_speaks_the_recordings_unit(unit, scale, words):
    assert any(words in text for text in texts(plot_matrix(matrix(unit, scale))))


def test_time_stands_in_seconds():
    figure = plot_matrix(matrix(n=300))
    labels = [label.get_text() for label in figure.axes[0].get_xticklabels()]
    assert labels[:3] == ["0 s", "2", "4"]
    assert 3 <= len(labels) <= 9


@pytest.mark.parametrize("values", [np.zeros((5, 5)), np.full((4, 4), np.nan), np.zeros((1, 1))])
def test_a_matrix_without_distances_is_still_drawn(values):
    figure = plot_matrix(SimilarityMatrix(values, "mean_norm", 30, 30))
    figure.savefig(io.BytesIO(), dpi=40)


def test_lanes_hold_stretches_and_cycles():
    axes = plot_patterns(patterns(pattern("A"), pattern("B", "acyclic")), seconds=5).axes[0]
    bars = [patch for patch in axes.patches if isinstance(patch, Rectangle)]
    assert len(bars) == (1 + 3) + (3 + 3)
    words = [text.get_text() for text in axes.texts]
    assert [w for w in words if "stretch" in w] == ["1 stretch", "3 stretches"]
    assert [w for w in words if "of " in w] == ["3 cycles of 1.00 s", "of 1.00 s"]
    assert {"A", "B"} <= set(words)


def test_a_lane_says_what_the_page_says():
    for shown in (pattern("A"), pattern("A", "acyclic")):
        words = {text.get_text() for text in plot_patterns(patterns(shown), seconds=5).axes[0].texts}
        assert set(lane_head(shown)) <= words


@pytest.mark.parametrize("scale", [0.01, 0.1, 1.0])
def test_the_map_ends_where_the_pages_does(scale):
    body = person()
    body = body.replace(positions=np.repeat(body.positions, 120, axis=0), facing=np.zeros(120), rate=30)
    told = page_payload(body, patterns(), matrix(scale=scale), source={})["distance"]
    far = plot_matrix(matrix(scale=scale)).axes[0].images[0].get_clim()[1]
    assert far == pytest.approx(told["cap"] * told["factor"])
    assert 8 <= far <= 16


def test_cycles_are_numbered_within_their_stretch():
    cycles = Segmentation([5, 35, 105, 135], [35, 65, 135, 165], ("A",) * 4, [0.9] * 4, 30)
    stretches = Segmentation([0, 100], [70, 170], ("A",) * 2, [0.9] * 2, 30)
    found = Pattern("A", "cyclic", cycles, stretches, 1.0, 0.05, 0.9)
    axes = plot_patterns(patterns(found)).axes[0]
    assert [t.get_text() for t in axes.texts if t.get_text().isdigit()] == ["1", "2", "1", "2"]
    crowded = plot_patterns(patterns(found), seconds=120).axes[0]
    assert not [t for t in crowded.texts if t.get_text().isdigit()]


def test_the_uncertain_is_hatched():
    axes = plot_patterns(patterns(pattern("A"), pattern("B", confidence=0.3))).axes[0]
    hatched = {patch.get_hatch() is not None: patch.get_y() for patch in axes.patches}
    assert hatched[True] > 1 > hatched[False]


def test_past_the_eighth_the_letter_does_the_work():
    axes = plot_patterns(patterns(pattern("I"), pattern("AA"))).axes[0]
    chips = [t for t in axes.texts if t.get_text() in ("I", "AA")]
    assert {to_hex(t.get_bbox_patch().get_facecolor()).upper() for t in chips} == {LIGHT.ink2}


def test_given_labels_have_a_lane_in_ink():
    labels = Segmentation([0, 60], [60, 100], ("walk", "jump"), rate=30)
    axes = plot_patterns(patterns(pattern("A")), labels=labels).axes[0]
    words = {text.get_text(): text for text in axes.texts}
    assert {"walk", "jump", "Given labels"} <= set(words)
    assert words["walk"].get_color() == LIGHT.ink2


def test_a_label_too_long_for_its_stretch_is_not_written():
    labels = Segmentation([0, 3], [3, 300], ("a very long word", "walk"), rate=30)
    words = texts(plot_patterns(patterns(pattern("A")), seconds=10, labels=labels))
    assert "walk" in words
    assert "a very long word" not in words


def test_no_pattern_is_a_sentence():
    assert "Nothing repeats here" in texts(plot_patterns(patterns(), seconds=9))


def test_right_is_filled_and_left_is_hollow():
    figure = plot_figures(person(), [0])
    (painted,) = figure.axes[0].collections
    edges = [to_hex(colour).upper() for colour in painted.get_edgecolor()]
    faces = [to_hex(colour).upper() for colour in painted.get_facecolor()]
    assert edges.count(LIGHT.left) == 4
    assert faces.count(LIGHT.ink) == 4


def test_a_figure_does_not_depend_on_place_and_turn():
    here, there = figure_shapes(person(), 0), figure_shapes(person(2.2, (5.0, 0.0, -3.0)), 0)
    assert [s.side for s in here] == [s.side for s in there]
    for a, b in zip(here, there, strict=True):
        np.testing.assert_allclose(a.outline, b.outline, atol=1e-9)


def test_the_persons_left_is_on_the_viewers_right():
    across = {s.side: s.outline[:, 0].mean() for s in figure_shapes(person(), 0)}
    assert across["left"] > across["right"]


def test_a_limb_without_its_joint_is_absent():
    body = person()
    positions = body.positions.copy()
    positions[0, body.roles.index("left_elbow")] = np.nan
    less = figure_shapes(body.replace(positions=positions), 0)
    assert len(figure_shapes(body, 0)) - len(less) == 2
    nothing = body.replace(positions=np.full_like(positions, np.nan))
    assert figure_shapes(nothing, 0) == []
    plot_figures(nothing, [0]).savefig(io.BytesIO(), dpi=40)


@pytest.mark.parametrize("dimensions", [2, 3])
def test_points_without_roles_are_dots(rng, dimensions):
    cloud = Body(("C1", "C2", "C3"), rng.random((1, 3, dimensions)), [0.0], rate=60, size=1.0)
    assert [s.side for s in figure_shapes(cloud, 0)] == ["middle"] * 3
    plot_figures(cloud, [0])


def test_captions_are_times_or_what_is_given():
    body = person()
    twice = body.replace(positions=np.repeat(body.positions, 200, axis=0), facing=np.zeros(200))
    assert texts(plot_figures(twice, [0, 150])) == ["0:00.0", "0:02.5"]
    assert texts(plot_figures(twice.replace(rate=199 / 59.97), [199])) == ["1:00.0"]
    assert texts(plot_figures(twice, [0, 150], captions=["start", "end"])) == ["start", "end"]


def test_what_cannot_be_drawn_says_why():
    with pytest.raises(ParameterError, match="light, dark, got 'sepia'"):
        plot_matrix(matrix(), theme="sepia")
    with pytest.raises(ParameterError, match=r"some of 0 to 0, got \[3\]"):
        plot_figures(person(), [3])
    with pytest.raises(ParameterError, match="captions must be 1"):
        plot_figures(person(), [0], captions=["a", "b"])


@pytest.mark.parametrize("theme", sorted(THEMES))
@pytest.mark.parametrize("format", ["png", "pdf", "svg"])
def test_figures_save_in_every_format(theme, format):
    for figure in (
        plot_matrix(matrix(), patterns(pattern()), theme=theme, width=2),
        plot_patterns(patterns(pattern()), theme=theme, width=3),
        plot_figures(person(), [0], theme=theme, height=1),
    ):
        assert isinstance(figure, Figure)
        figure.savefig(to := io.BytesIO(), format=format, dpi=40)
        assert to.tell() > 500


def test_no_window_and_no_global_setting_is_touched():
    code = """
import sys, matplotlib, numpy as np
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view.plots import plot_matrix
settings = lambda: {k: matplotlib.rcParams[k] for k in matplotlib.rcParams if k != "backend"}
before = settings()
plot_matrix(SimilarityMatrix(np.eye(9), "mean_norm", 30, 30))
assert "matplotlib.pyplot" not in sys.modules
assert settings() == before
"""
    subprocess.run([sys.executable, "-c", code], check=True)
