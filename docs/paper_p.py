"""Figures 6, 7, 8, 10, 12 and 13 of paper P, remade from real recordings.

As in the paper the later moment x runs to the right, the earlier y upwards, and only y < x is shown; the darker, the
nearer two postures. The steps are those of :mod:`leitmotion.discovery.tang2008`, at the paper's 60 moments a second.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from leitmotion import body, features, io
from leitmotion.discovery import _tang_kernels as kernels
from leitmotion.discovery import autocorrelation, tang2008
from leitmotion.discovery.tang2008 import Trace
from leitmotion.features import FeatureSequence
from leitmotion.features.resampling import resample
from leitmotion.motion import Segmentation
from leitmotion.similarity import self_distance
from leitmotion.view.palette import THEMES
from recordings import locate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

RATE = 60.0
THRESHOLD, WINDOWS, DEAREST, SHORTEST, REACH = 0.26, (30, 50), 0.5, 30, 3
LIGHT = THEMES["light"]
VIOLET, ORANGE, TEAL, WINE = LIGHT.patterns[:4]
SMALL, BODY, TITLE = 7.5, 9.0, 11.0
DANCE, SESSION = "animated_drawings/jesse_dance.bvh", "cmu86/86_01.amc"
DANCING = f"{DANCE}[1.5s:9.2s]"
Span = tuple[float, float]


class Cut(NamedTuple):
    """A piece of a recording's matrix."""

    name: str
    sequence: FeatureSequence
    x: Span
    """The later stretch, seconds."""
    y: Span
    """The earlier stretch, seconds."""


class Traced(NamedTuple):
    """What the steps of section 2.3 make of a recording."""

    C: np.ndarray
    minima: np.ndarray
    starts: list[tuple[int, int]]
    traces: list[Trace]
    values: np.ndarray


def traced(sequence: FeatureSequence) -> Traced:
    """Take a recording through section 2.3."""
    work = resample(sequence, RATE)
    C, _ = tang2008._scaled(self_distance(work).values)
    minima = np.zeros(C.shape, np.bool_)
    kernels.thin(C, THRESHOLD, SHORTEST, minima)
    found = tang2008._trace_patterns(C, THRESHOLD, WINDOWS, DEAREST, SHORTEST, REACH)
    traces = tang2008._distinct(found, len(C), SHORTEST, REACH)
    return Traced(C, minima, kernels.start_points(minima, REACH), traces, work.values)


def grey_matrix(sequence: FeatureSequence, labels: Segmentation | None = None) -> Figure:
    """Figure 6: the matrix of posture distances in grey, its lower half."""
    C, _ = tang2008._scaled(self_distance(resample(sequence, RATE)).values)
    figure = _figure(5.2, 5.2)
    axes = figure.add_axes((0.09, 0.085, 0.89, 0.89))
    later = np.arange(len(C)) > np.arange(len(C))[:, None]
    _grey(axes, np.where(later, C, np.nan), (0.0, 0.0))
    for start, stop, word, _ in labels or ():
        middle = (start + stop) / 2 / labels.rate
        axes.text(
            middle - 0.4, middle + 0.6, word.replace("_", " "), ha="right", fontsize=SMALL, color=LIGHT.ink
        )
        for border in (start, stop):
            at = border / labels.rate
            axes.plot([at - 0.6, at], [at + 0.6, at], color=LIGHT.ink2, lw=0.8)
    _seconds(axes)
    return figure


def dark_patterns(cuts: Sequence[Cut]) -> Figure:
    """Figure 7: the five dark patterns."""
    figure = _figure(7.2, 1.85)
    width = 1 / len(cuts)
    for k, cut in enumerate(cuts):
        axes = figure.add_axes((k * width + 0.005, 0.14, width - 0.01, 0.84))
        C, _ = tang2008._scaled(self_distance(resample(cut.sequence, RATE)).values)
        (x0, x1), (y0, y1) = ((round(a * RATE), round(b * RATE)) for a, b in (cut.x, cut.y))
        piece = C[y0:y1, x0:x1]
        _grey(axes, piece, (cut.x[0], cut.y[0]), nearest=float(np.nanmin(piece)))
        axes.set(xticks=[], yticks=[], aspect="auto")
        figure.text(
            (k + 0.5) * width,
            0.03,
            f"({'abcde'[k]}) {cut.name}",
            ha="center",
            fontsize=SMALL,
            color=LIGHT.ink,
        )
    return figure


def tracing(sequence: FeatureSequence, x: Span, y: Span) -> Figure:
    """Figure 8: minima, a start point with its regions, the windows, and the optimal path, in a piece of the matrix."""
    steps = traced(sequence)
    inside = [p for p in steps.starts if _within(p, x, y)]
    followed = {
        start: kernels.trace(steps.C, steps.minima, *start, SHORTEST, *WINDOWS, DEAREST) for start in inside
    }
    start = max(followed, key=lambda one: len([p for p in followed[one] if _within(p, x, y)]))
    points = np.array(followed[start])
    path = tang2008._optimal_path(steps.C, points, SHORTEST).path / RATE
    near = tuple((at / RATE - 0.16, at / RATE + 0.16) for at in start)
    figure = _figure(6.4, 6.5)
    panels = (
        ("(a) local minima of each column below T", x, y),
        ("(b) a start point: none in B, some in A", *near),
        ("(c) windows cut columns, slope ½ to 2", x, y),
        ("(d) the optimal path", x, y),
    )
    for k, (title, across, up) in enumerate(panels):
        axes = figure.add_axes((0.065 + 0.49 * (k % 2), 0.555 - 0.495 * (k // 2), 0.42, 0.405))
        _cloud(axes, steps, across, up, size=26.0 if k == 1 else 1.6)
        axes.set_title(title, loc="left", fontsize=BODY, color=LIGHT.ink, pad=4)
        if k == 1:
            _regions(axes, start)
        elif k == 2:
            _windows(axes, points)
        elif k == 3:
            axes.plot(path[:, 1], path[:, 0], color=VIOLET, lw=2.2, zorder=4)
        axes.plot(*np.divide(start, RATE), "o", ms=6, mfc="none", mec=ORANGE, mew=1.6, zorder=5)
        axes.set(xlim=across, ylim=up)
    return figure


def cyclic_family(sequence: FeatureSequence) -> Figure:
    """Figure 10: the largest family of traces in the matrix, and its segments side by side in time."""
    steps = traced(sequence)
    family = sorted(largest_family(steps), key=lambda trace: trace.segments[1])
    figure = _figure(7.2, 3.6)
    axes = figure.add_axes((0.06, 0.115, 0.42, 0.82))
    later = np.arange(len(steps.C)) > np.arange(len(steps.C))[:, None]
    _grey(axes, np.where(later, steps.C, np.nan), (0.0, 0.0), alpha=0.45)
    for k, trace in enumerate(family, start=1):
        earlier, late = trace.path.T / RATE
        axes.plot(late, earlier, color=VIOLET, lw=1.8)
        axes.annotate(
            f"P{k}", (late[-1], earlier[-1]), (3, 0), textcoords="offset points", fontsize=SMALL, va="center"
        )
    axes.set_title("(a) a family of cyclic traces", loc="left", fontsize=BODY, color=LIGHT.ink, pad=4)
    _seconds(axes)
    _alignment(figure.add_axes((0.56, 0.115, 0.42, 0.82)), family)
    return figure


def cycle_peaks(sequence: FeatureSequence) -> Figure:
    """Figure 12: the autocorrelation of the largest family over the lag, and the peaks that are borders of cycles."""
    steps = traced(sequence)
    family = largest_family(steps)
    start, stop = min(t.s_min for t in family), max(t.e_max for t in family)
    values = steps.values[start:stop]
    r = autocorrelation._autocorrelation(values)
    peaks = np.array(autocorrelation.cycle_lags(values, SHORTEST), int)
    lag = np.arange(len(r)) / RATE
    figure = _figure(6.4, 2.7)
    axes = figure.add_axes((0.085, 0.17, 0.9, 0.78))
    axes.axhline(0, color=LIGHT.line, lw=0.8)
    axes.plot(lag, autocorrelation.PEAK * (1 - lag / lag[-1]), color=LIGHT.ink2, lw=0.9, ls=(0, (4, 3)))
    axes.plot(lag, r, color=LIGHT.ink, lw=1.4)
    axes.plot(lag[peaks], r[peaks], "o", ms=5, color=VIOLET)
    for k, peak in enumerate(peaks, start=1):
        axes.annotate(
            str(k), (lag[peak], r[peak]), (0, 5), textcoords="offset points", fontsize=SMALL, ha="center"
        )
    axes.set(xlim=(0, lag[-1]), ylim=(r.min() - 0.08, 1.05), xlabel="lag, s", ylabel="correlation r")
    _style(axes)
    return figure


def largest_family(steps: Traced) -> list[Trace]:
    """The family with the most traces (section 2.4)."""
    return max(tang2008._cluster(steps.traces, 0.05), key=len)


def _cloud(axes: Axes, steps: Traced, x: Span, y: Span, *, size: float) -> None:
    """The binary cloud in light grey, the minima in ink."""
    (x0, x1), (y0, y1) = ((max(0, int(a * RATE)), int(b * RATE) + 2) for a, b in (x, y))
    near = steps.C[x0:x1, y0:y1] < THRESHOLD
    shade = np.where(near, 0.88, 1.0).T
    half = 0.5 / RATE
    extent = (x0 / RATE - half, x1 / RATE - half, y0 / RATE - half, y1 / RATE - half)
    axes.imshow(shade, cmap="gray", vmin=0, vmax=1, origin="lower", extent=extent, aspect="auto")
    marks = np.add(np.argwhere(steps.minima[x0:x1, y0:y1]), (x0, y0)) / RATE
    axes.scatter(marks[:, 0], marks[:, 1], s=size, color=LIGHT.ink, linewidths=0, zorder=3)
    _style(axes)


def _regions(axes: Axes, start: tuple[int, int]) -> None:
    """Region A to the right and above the start point, B to the left and below, its row included."""
    from matplotlib.patches import Rectangle

    x, y = start
    width, height = REACH / RATE, 2 * REACH / RATE
    for name, left, low, tall, beside, colour in (
        ("A", x + 0.5, y + 0.5, height, height + 0.012, TEAL),
        ("B", x - REACH - 0.5, y - 2 * REACH - 0.5, height + 1 / RATE, -0.022, WINE),
    ):
        corner = left / RATE, low / RATE
        axes.add_patch(Rectangle(corner, width, tall, fc=colour, alpha=0.18, ec="none", zorder=1))
        axes.add_patch(Rectangle(corner, width, tall, fc="none", ec=colour, lw=1.2, zorder=2))
        axes.text(
            corner[0] + width / 2, corner[1] + beside, name,
            color=colour, fontsize=TITLE, weight="bold", ha="center",
        )  # fmt: skip


def _windows(axes: Axes, points: np.ndarray) -> None:
    """Each window as the wedge of slopes allowed, with the column that it cuts."""
    from matplotlib.patches import Polygon

    for k, (x, y) in enumerate(points[:-1]):
        reach = WINDOWS[min(k, 1)]
        wedge = np.array([(x, y), (x + reach, y + reach / 2), (x + reach, y + 2 * reach)]) / RATE
        axes.add_patch(Polygon(wedge, fc=TEAL, alpha=0.12, ec="none", zorder=1))
        step = points[k + 1, 0] - x
        cut = np.array([(x + step, y + step / 2), (x + step, y + 2 * step)]) / RATE
        axes.plot(*cut.T, color=TEAL, lw=1.1, zorder=2)
    chosen = points / RATE
    axes.plot(chosen[:, 0], chosen[:, 1], color=VIOLET, lw=1.0, marker="o", ms=3.6, zorder=4)


def _alignment(axes: Axes, family: Sequence[Trace]) -> None:
    """Both segments of each trace as bars; Smin and Emax are dashed."""
    count = len(family)
    for k, trace in enumerate(family):
        for (start, stop), height, shade in zip(trace.segments, (0.18, 0.5), (0.55, 1.0), strict=True):
            axes.barh(
                k + height, (stop - start) / RATE, 0.27, start / RATE, color=VIOLET, alpha=shade, align="edge"
            )
        axes.text(
            -0.01,
            k + 0.5,
            f"P{k + 1}",
            ha="right",
            va="center",
            fontsize=SMALL,
            transform=axes.get_yaxis_transform(),
        )
    s_min, e_max = (float(np.mean(ends)) for ends in zip(*((t.s_min, t.e_max) for t in family), strict=True))
    for name, moment, side in (("Smin", s_min, "left"), ("Emax", e_max, "right")):
        axes.axvline(moment / RATE, color=ORANGE, lw=1.2, ls=(0, (4, 3)), zorder=0)
        axes.text(moment / RATE, -0.12, f" {name} ", ha=side, va="bottom", fontsize=SMALL, color=ORANGE)
    axes.set(xlim=(0, None), ylim=(count, -0.6), yticks=[], xlabel="s")
    axes.set_title("(b) their segments in time", loc="left", fontsize=BODY, color=LIGHT.ink, pad=4)
    _style(axes)


def _within(point: tuple[int, int], x: Span, y: Span) -> bool:
    return x[0] <= point[0] / RATE <= x[1] and y[0] <= point[1] / RATE <= y[1]


def _grey(axes: Axes, C: np.ndarray, corner: Span, *, nearest: float = 0.0, alpha: float = 1.0) -> None:
    """Distances, rows the earlier moments upwards, columns the later ones."""
    from matplotlib.colors import LinearSegmentedColormap

    ramp = LinearSegmentedColormap.from_list("distance", ("#000000", *LIGHT.ramp[::-1][1:], "#FFFFFF"))
    height, width = C.shape
    extent = (corner[0], corner[0] + width / RATE, corner[1], corner[1] + height / RATE)
    axes.imshow(
        C,
        cmap=ramp,
        vmin=nearest,
        vmax=float(np.nanquantile(C, 0.94)),
        origin="lower",
        extent=extent,
        alpha=alpha,
    )


def _seconds(axes: Axes) -> None:
    left, right, low, high = axes.images[0].get_extent()
    axes.set(xlim=(left, right), ylim=(low, high), xlabel="later moment, s", ylabel="earlier moment, s")
    _style(axes)


def _style(axes: Axes) -> None:
    axes.tick_params(length=2.5, width=0.6, labelsize=SMALL, color=LIGHT.ink2, labelcolor=LIGHT.ink2)
    axes.xaxis.label.set(fontsize=SMALL, color=LIGHT.ink2)
    axes.yaxis.label.set(fontsize=SMALL, color=LIGHT.ink2)
    for spine in axes.spines.values():
        spine.set(color=LIGHT.line, linewidth=0.8)


def _figure(width: float, height: float) -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), facecolor=LIGHT.surface)


def recorded(name: str) -> FeatureSequence:
    """Read a recording by its name; its postures."""
    return features.posture(body.embody(io.read(locate(name))))


def _figure_6() -> Figure:
    sequence = recorded(SESSION)
    labels = io.read_annotations(
        locate("cmu86/mocap.txt"), rate=sequence.rate, trial="86_01", frames=len(sequence)
    )
    return grey_matrix(sequence, labels)


def _figure_7() -> Figure:
    exercises = recorded("mocap6/13_29.amc")
    return dark_patterns([
        Cut("diagonal", recorded(SESSION), (21.4, 24.4), (11.0, 14.0)),
        Cut("anti-diagonal", exercises, (14.2, 16.0), (11.0, 13.4)),
        Cut("crossing", exercises, (35.0, 37.4), (32.1, 34.4)),
        Cut("V-shape", exercises, (33.2, 36.0), (31.4, 33.2)),
        Cut("horizontal / vertical", recorded(DANCE), (2.0, 5.0), (0.1, 1.5)),
    ])  # fmt: skip


def _figure_13() -> Figure:
    from bench_calibration import calibrated
    from leitmotion.view import plot_calibration

    return plot_calibration(calibrated("posture"), width=6.4)


FIGURES: dict[str, Any] = {
    "p-06-matrix": _figure_6,
    "p-07-dark-patterns": _figure_7,
    "p-08-tracing": lambda: tracing(recorded(DANCE), (4.2, 8.0), (1.4, 5.2)),
    "p-10-family": lambda: cyclic_family(recorded(DANCING)),
    "p-12-peaks": lambda: cycle_peaks(recorded(DANCING)),
    "p-13-threshold": _figure_13,
}
