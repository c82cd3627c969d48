"""A picture of one labelled stretch: Z and Z* with what was seen and what is told, and the postures of the stretch."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.image import imsave
from matplotlib.patches import Rectangle

import leitmotion as lm
from leitmotion.evaluation import SymmetryVerdict
from leitmotion.evaluation.symmetry import SHOWS, SURE
from leitmotion.motion import Segmentation
from leitmotion.view import symmetry_image
from leitmotion.view.plots import plot_figures
from recordings import locate
from symmetry_clips import Clip

POSTURES = 14
AROUND = 1.0
"""Seconds that are drawn before and after a stretch that was looked for."""
COLOURS = {"together": "#1F7A8C", "one": "#B5590F", "alternate": "#4720AB", "": "#555D68"}


def draw(clip: Clip, verdict: SymmetryVerdict, told: Segmentation, says: str, folder: Path) -> Path:
    """Write the picture of a stretch into a folder, and tell where."""
    recording = lm.read(locate(clip.recording))
    label = verdict.label
    figure = Figure(figsize=(14, 7), dpi=110)
    first, last = _extent(clip, recording)
    left, right = figure.subplots(1, 2, width_ratios=(1, 1.15))
    compared = lm.compare_with_mirror(recording)
    i, j = first // compared.every, -(-last // compared.every)
    found = compared.distances
    cut = found.replace(own=found.own[i:j, i:j], mirror=found.mirror[i:j, i:j])
    left.imshow(symmetry_image(cut), extent=(first, last, last, first), interpolation="nearest")
    size = label.stop - label.start
    left.add_patch(Rectangle((label.start, label.start), size, size, fill=False, ec="yellow", lw=1.2))
    left.set_title(
        f"Z red, Z* cyan; half alike at {np.degrees(found.half_angle):.0f}°", loc="left", fontsize=9
    )
    lanes = [
        (one.start, one.stop, f"seen: {'|'.join(one.motifs) or 'none'}", COLOURS[one.sides], 1.0)
        for one in clip.labels
    ]
    for start, stop, motif, confidence in sorted(
        told, key=lambda span: list(SHOWS).index(span[2]) if span[2] in SHOWS else len(SHOWS)
    ):
        if motif in SHOWS and start < last and stop > first:
            words = f"{motif} {confidence:.2f}"
            lanes.append((start, stop, words, COLOURS[SHOWS[motif][0]], 0.75 if confidence >= SURE else 0.25))
    for lane, (start, stop, words, colour, strength) in enumerate(lanes):
        start, stop = max(start, first), min(stop, last)
        right.barh(lane, stop - start, left=start, height=0.8, color=colour, alpha=strength)
        right.text(max(start, first), lane, f" {words}", va="center", fontsize=7, clip_on=True)
    right.axhline(len(clip.labels) - 0.5, color="black", lw=0.8)
    right.axvspan(label.start, label.stop, color="yellow", alpha=0.25, zorder=-1)
    right.set(xlim=(first, last), ylim=(max(len(lanes), 8) - 0.4, -0.6), yticks=[])
    figure.suptitle(
        f"{clip.recording} [{label.start}, {label.stop}) at {recording.rate:g} Hz: {says}\n"
        f"seen {'|'.join(label.motifs) or 'none'}{'' if label.sure else ' (unsure)'}; "
        f"told {verdict.told} {verdict.confidence:.2f}, fit {verdict.fit:.2f}",
        fontsize=10,
    )
    body = lm.embody(recording)
    frames = np.linspace(label.start, label.stop - 1, POSTURES).round().astype(int)
    strip = plot_figures(body, frames, captions=[str(frame) for frame in frames])
    strip.set_dpi(14 * 110 / strip.get_size_inches()[0])
    folder.mkdir(parents=True, exist_ok=True)
    name = clip.recording.split("/")[-1].split(".")[0]
    path = folder / f"{name}_{label.start}_{label.stop}.png"
    imsave(path, _stacked(_pixels(figure), _pixels(strip)))
    return path


def _extent(clip: Clip, recording: lm.Motion) -> tuple[int, int]:
    """Frames that are drawn: the window, and a second around a stretch that is all of it."""
    first, last = clip.window
    if len(clip.labels) == 1:
        around = round(AROUND * recording.rate)
        first, last = max(0, first - around), min(len(recording), last + around)
    return first, last


def _pixels(figure: Figure) -> np.ndarray:
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3]


def _stacked(above: np.ndarray, below: np.ndarray) -> np.ndarray:
    wide = max(above.shape[1], below.shape[1])
    rows = [
        np.pad(one, ((0, 0), (0, wide - one.shape[1]), (0, 0)), constant_values=255) for one in (above, below)
    ]
    return np.concatenate(rows)
