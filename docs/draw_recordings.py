"""Draw one frame of each recording, many to a page: where the person stands, what is left, and which way they face.

The viewer looks along −Z and a little down: of a person who faces the viewer the left (red) is on the viewer's right.
The line is the ground (the lowest height of any point), the arrow on it is the way the body faces.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import leitmotion as lm
from leitmotion.body import embody, find_roles
from leitmotion.body.roles import LINKS
from leitmotion.motion import Motion, Trajectories, forward_kinematics

ACROSS, DOWN = 7, 4
TILT = math.radians(12)
LEFT, RIGHT, MIDDLE, OTHER = "#c8102e", "#1f4fb4", "#333333", "#9a9a9a"


def draw(recordings: Sequence[tuple[str, Path]], folder: Path) -> Iterator[Path]:
    """Draw the sheets.

    Parameters
    ----------
    recordings : sequence of str and Path
        What each is called, and where it is.
    folder : Path
        Where to.

    Yields
    ------
    Path
        A page, as PNG.
    """
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    folder.mkdir(parents=True, exist_ok=True)
    size = ACROSS * DOWN
    for count, start in enumerate(range(0, len(recordings), size), start=1):
        figure, axes = plt.subplots(DOWN, ACROSS, figsize=(ACROSS * 2.6, DOWN * 3.1))
        for ax in axes.flat:
            ax.set_axis_off()
        for ax, (name, path) in zip(axes.flat, recordings[start : start + size], strict=False):
            _draw_one(ax, name, lm.read_all(path)[0])
        figure.tight_layout(pad=0.4)
        sheet = folder / f"recordings-{count:02d}.png"
        figure.savefig(sheet, dpi=80)
        plt.close(figure)
        yield sheet


def _draw_one(ax: Any, name: str, recording: Motion | Trajectories) -> None:
    names, positions, bones = _points(recording)
    frame = _frame(positions)
    roles = find_roles(recording)
    sides = {member: role for role, held in zip(roles.roles, roles.members, strict=True) for member in held}
    colours = [_colour(sides.get(each, "")) for each in names]
    here = positions[frame]
    ground = float(np.nanmin(positions[..., 1]))
    flat = _seen(here)
    for a, b in bones:
        colour = colours[b] if colours[b] != OTHER else colours[a]
        ax.plot(flat[[a, b], 0], flat[[a, b], 1], color=colour, linewidth=1.6)
    ax.scatter(flat[:, 0], flat[:, 1], c=colours, s=5 if bones else 11, zorder=3)
    middle = np.nanmean(here, axis=0)
    _draw_body(ax, recording, frame, ground, middle)
    ax.set_aspect("equal")
    ax.margins(0.12)
    ax.set_title(_title(name, recording, frame), fontsize=6.5)


def _points(recording: Motion | Trajectories) -> tuple[Sequence[str], np.ndarray, list[tuple[int, int]]]:
    """Names, positions and bones of all joints or points."""
    if isinstance(recording, Motion):
        parents = recording.skeleton.parents
        bones = [(int(parent), k) for k, parent in enumerate(parents) if parent >= 0]
        return recording.skeleton.names, forward_kinematics(recording).positions, bones
    return recording.names, recording.positions, []


def _draw_body(
    ax: Any, recording: Motion | Trajectories, frame: int, ground: float, middle: np.ndarray
) -> None:
    """The ground with the arrow of the facing, and for points the bones between roles."""
    try:
        body = embody(recording)
    except lm.DataError:
        return
    reach = 0.45 * body.size
    span = np.array([[middle[0] - reach, ground], [middle[0] + reach, ground]])
    if len(middle) == 3:
        span = _seen(np.array([[x, ground, middle[2]] for x, _ in span]))
    ax.plot(span[:, 0], span[:, 1], color="#2c7a3f", linewidth=1.0, zorder=1)
    if body.facing_told and len(middle) == 3:
        yaw = body.facing[frame]
        foot = np.array([middle[0], ground, middle[2]])
        tip = foot + reach * np.array([math.sin(yaw), 0.0, math.cos(yaw)])
        start, stop = _seen(np.array([foot, tip]))
        ax.annotate("", stop, start, arrowprops={"arrowstyle": "->", "color": "#e08a00", "linewidth": 1.8})
    if isinstance(recording, Trajectories):
        at = {role: k for k, role in enumerate(body.roles)}
        flat = _seen(body.positions[frame])
        for a, b in LINKS:
            if a in at and b in at:
                both = flat[[at[a], at[b]]]
                ax.plot(both[:, 0], both[:, 1], color=_colour(b), linewidth=1.2, alpha=0.7)


def _frame(positions: np.ndarray) -> int:
    """Of the frames in which most points are seen the one nearest to the middle."""
    seen = np.isfinite(positions).all(axis=2).sum(axis=1)
    best = np.flatnonzero(seen == seen.max())
    return int(best[np.abs(best - len(positions) // 2).argmin()])


def _seen(points: np.ndarray) -> np.ndarray:
    """Where the viewer sees points: along −Z and a little down; those in a plane as they are."""
    if points.shape[1] == 2:
        return points
    return np.stack((points[:, 0], points[:, 1] * math.cos(TILT) - points[:, 2] * math.sin(TILT)), axis=1)


def _colour(role: str) -> str:
    side = role.partition("_")[0]
    return {"left": LEFT, "right": RIGHT, "": OTHER}.get(side, MIDDLE)


def _title(name: str, recording: Motion | Trajectories, frame: int) -> str:
    folder, _, file = name.rpartition("/")
    return f"{folder[-34:]}\n{file[-34:]}\nframe {frame}, {len(recording)} at {recording.rate:g} Hz"
