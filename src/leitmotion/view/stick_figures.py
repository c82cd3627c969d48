"""Stick figures: what a posture looks like from the front, a little to its left, as flat outlines, and their painting.

Conventions
-----------
The body is turned to face the viewer's direction and seen without perspective. Outlines are metres to the
viewer's right and up; the pelvis stands at 0 across. Shapes come in the order they are painted, far ones first.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from leitmotion.body import Body, mirror_role
from leitmotion.view.palette import Theme, mixed
from leitmotion.view.payload import FULL_SIZE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SEEN_FROM = 0.45  # radians to the left of the body's front
LIMBS = (
    ("shoulder", "elbow", 0.047, 0.039),
    ("elbow", "wrist", 0.039, 0.029),
    ("wrist", "hand", 0.029, 0.02),
    ("hip", "knee", 0.069, 0.05),
    ("knee", "ankle", 0.05, 0.034),
    ("ankle", "toe", 0.034, 0.026),
)
TORSO_STROKE, DOT = 0.125, 0.018
HEAD, HEAD_ABOVE_NECK = (0.095, 0.122), (0.19, 0.25)
ARC = np.linspace(0, 2 * np.pi, 49)
HALO, OUTLINE = 0.7, 0.9  # points


class Shape(NamedTuple):
    """One part of the figure."""

    outline: np.ndarray
    """(K, 2) a closed polygon: right and up, metres."""
    side: str
    """"left", "right" or "middle"."""
    depth: float
    """Toward the viewer, metres."""
    stroke: float = 0.0
    """How wide its border is drawn, metres; 0 for none."""
    parted: bool = True
    """Whether a halo sets it apart from what is behind it."""


def figure_shapes(body: Body, frame: int, *, mirrored: bool = False) -> list[Shape]:
    """Outline a posture.

    Parameters
    ----------
    body : Body
        Points with roles; without roles each point is a dot.
    frame : int
        Which moment.
    mirrored : bool
        Whether its mirror image is outlined.

    Returns
    -------
    list of Shape
        Far to near. Parts of which a joint was not seen are left out.

    Examples
    --------
    >>> arm = Body(("right_shoulder", "right_elbow"), [[[0, 1.4, 0], [-0.3, 1.4, 0]]], [0.0], rate=1, size=1.5)
    >>> [shape.side for shape in figure_shapes(arm, 0)]
    ['right']
    """
    seen = _seen(body, frame, mirrored)
    girth = body.size / FULL_SIZE
    shapes = []
    for side in ("left", "right"):
        for start, end, wide, narrow in LIMBS:
            a, b = seen.get(f"{side}_{start}"), seen.get(f"{side}_{end}")
            if a is not None and b is not None:
                outline = _capsule(a[:2], b[:2], wide * girth, narrow * girth)
                shapes.append(Shape(outline, side, (a[2] + b[2]) / 2))
    shapes += _trunk(seen, girth)
    if not shapes:
        shapes = [Shape(_disc(p[:2], DOT * girth), _side(role), p[2]) for role, p in seen.items()]
    return sorted(shapes, key=lambda shape: shape.depth)


def paint_figure(
    axes: Axes,
    shapes: Sequence[Shape],
    place: tuple[float, float],
    per_metre: tuple[float, float],
    points_per_metre: float,
    colours: Theme,
    *,
    fade: float = 0.0,
    order: float = 1.0,
) -> None:
    """Paint a figure from far to near, each part on a halo that keeps crossings readable.

    Parameters
    ----------
    axes : Axes
        Where.
    shapes : sequence of Shape
        The posture, far parts first.
    place : (float, float)
        Where its pelvis' foot point stands, in the units of the axes.
    per_metre : (float, float)
        Units of the axes a metre, right and up.
    points_per_metre : float
        The same in points, for borders.
    colours : Theme
        Of which theme.
    fade : float
        How far it is mixed into the surface, 0 to 1.
    order : float
        How high it is stacked.
    """
    from matplotlib.collections import PolyCollection

    def tone(colour: str, share: float = 1.0) -> Any:
        return mixed(colour, share * (1 - fade), colours.surface)

    ink, left, trunk = tone(colours.ink), tone(colours.left), tone(colours.ink, 0.66)
    fills = {"right": ink, "left": tone(colours.left, 0.1), "middle": trunk}
    outlines, faces, edges, widths = [], [], [], []
    for shape in shapes:
        outline = np.add(shape.outline * per_metre, place)
        width = OUTLINE if shape.side == "left" else 0.0
        edge = left if shape.side == "left" else fills[shape.side]
        if shape.stroke:
            edge, width = fills[shape.side], shape.stroke * points_per_metre
        layers = [(fills[shape.side], edge, width)]
        if shape.parted:
            surface = mixed(colours.surface, 1.0, colours.surface)
            layers.insert(0, (surface, surface, width + 2 * HALO))
        for face, border, wide in layers:
            outlines.append(outline)
            faces.append(face)
            edges.append(border)
            widths.append(wide)
    axes.add_collection(
        PolyCollection(
            outlines, facecolors=faces, edgecolors=edges, linewidths=widths, joinstyle="round", zorder=order
        ),
        autolim=False,
    )


def _seen(body: Body, frame: int, mirrored: bool) -> dict[str, np.ndarray]:
    """Place the seen points before the viewer: right, up, toward; the pelvis at 0."""
    points = np.zeros((len(body.roles), 3))
    points[:, : body.positions.shape[2]] = body.positions[frame]
    known = np.asarray(np.isfinite(points).all(axis=1))
    if not known.any():
        return {}
    has_pelvis = "pelvis" in body.roles and known[body.roles.index("pelvis")]
    root = points[body.roles.index("pelvis")] if has_pelvis else points[known].mean(axis=0)
    x, y, z = (points - root * [1, 0, 1]).T
    hand = -1.0 if mirrored else 1.0
    x = hand * x
    if body.positions.shape[2] == 3:
        turn = hand * body.facing[frame] + SEEN_FROM
        x, z = np.cos(turn) * x - np.sin(turn) * z, np.sin(turn) * x + np.cos(turn) * z
    placed = np.stack([x, y, z], axis=1)
    called = [mirror_role(role) if mirrored else role for role in body.roles]
    return {role: placed[k] for k, role in enumerate(called) if known[k]}


def _trunk(seen: dict[str, np.ndarray], girth: float) -> list[Shape]:
    """Outline torso, neck and head."""
    shapes = []
    corners = [seen.get(role) for role in ("left_shoulder", "right_shoulder", "left_hip", "right_hip")]
    neck, head = seen.get("neck"), seen.get("head")
    if all(corner is not None for corner in corners):
        ls, rs, lh, rh = (np.asarray(corner) for corner in corners)
        shoulders, hips = (ls + rs) / 2, (lh + rh) / 2
        neck = shoulders if neck is None else neck
        waist = hips + 0.34 * (shoulders - hips)
        half = 0.36 * ((lh + 0.34 * (ls - lh)) - (rh + 0.34 * (rs - rh)))
        polygon = np.array([
            ls + 0.16 * (shoulders - ls), (neck + shoulders) / 2, rs + 0.16 * (shoulders - rs), waist - half,
            rh + 0.12 * (hips - rh), lh + 0.12 * (hips - lh), waist + half,
        ])  # fmt: skip
        shapes.append(Shape(polygon[:, :2], "middle", float(polygon[:, 2].mean()), TORSO_STROKE * girth))
    if head is None:
        return shapes
    up = np.array([0.0, 1.0, 0.0])
    centre, depth = head, float(head[2])
    if neck is not None and np.linalg.norm(head - neck) > 1e-6:
        up = (head - neck) / np.linalg.norm(head - neck)
        centre = neck + up * np.clip(np.linalg.norm(head - neck), *np.multiply(HEAD_ABOVE_NECK, girth))
        depth = max([float(neck[2]), *(shape.depth for shape in shapes)]) + 1e-6  # between torso and head
        outline = _capsule(neck[:2], centre[:2], 0.05 * girth, 0.045 * girth)
        shapes.append(Shape(outline, "middle", depth, parted=False))
    shapes.append(Shape(_ellipse(centre, up, girth), "middle", max(depth + 1e-6, float(centre[2]))))
    return shapes


def _ellipse(centre: np.ndarray, up: np.ndarray, girth: float) -> np.ndarray:
    """Outline the head: seen along its axis it is round."""
    upright = float(np.hypot(up[0], up[1]))
    across, along = HEAD[0] * girth, (HEAD[0] + (HEAD[1] - HEAD[0]) * upright) * girth
    axis = up[:2] / upright if upright > 1e-6 else np.array([0.0, 1.0])
    sideways = np.array([axis[1], -axis[0]])
    return np.asarray(
        centre[:2] + along * np.cos(ARC)[:, None] * axis + across * np.sin(ARC)[:, None] * sideways
    )


def _disc(centre: np.ndarray, radius: float) -> np.ndarray:
    return np.asarray(centre + radius * np.stack([np.cos(ARC), np.sin(ARC)], axis=1))


def _capsule(a: np.ndarray, b: np.ndarray, wide: float, narrow: float) -> np.ndarray:
    """Outline two discs and what lies between their common tangents."""
    length = float(np.hypot(*(b - a)))
    if length <= abs(wide - narrow):
        return _disc(a if wide > narrow else b, max(wide, narrow))
    toward = np.arctan2(b[1] - a[1], b[0] - a[0])
    open_by = np.arccos((wide - narrow) / length)  # where the tangents touch, either side of the axis
    about_a = toward + np.linspace(open_by, 2 * np.pi - open_by, 25)
    about_b = toward + np.linspace(-open_by, open_by, 25)
    arcs = [
        centre + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        for centre, radius, angle in ((a, wide, about_a), (b, narrow, about_b))
    ]
    return np.concatenate([*arcs, arcs[0][:1]])


def _side(role: str) -> str:
    return next((side for side in ("left", "right") if role.startswith(side)), "middle")
