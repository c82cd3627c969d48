"""Shapes by which a program that opens a glTF shows bones and points: octahedra of eight triangles."""

from __future__ import annotations

import numpy as np

from leitmotion.motion import Skeleton

_SLIM = 0.08  # half the width of a bone over its length
_WAIST = 0.15  # where along a bone it is widest
RADIUS = 0.015
"""Half the size of the shape of a point, and of a joint from which no bone starts, in metres."""

_AROUND = np.array([1, 2, 3, 4])
_TRIANGLES = np.concatenate(
    (
        np.stack([np.full(4, 5), _AROUND, np.roll(_AROUND, -1)], axis=1),
        np.stack([np.full(4, 0), np.roll(_AROUND, -1), _AROUND], axis=1),
    )
)


def octahedra(heads: np.ndarray, tips: np.ndarray, waist: float, widths: np.ndarray) -> np.ndarray:
    """Corners of slim octahedra.

    Parameters
    ----------
    heads, tips : (B, 3) float
        Where each begins and ends.
    waist : float
        Where between the two it is widest, 0 to 1.
    widths : (B,) float
        Half the width there.

    Returns
    -------
    (B, 6, 3) float
        Head, four corners around the waist, tip.
    """
    along = tips - heads
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    least = np.eye(3)[np.abs(along).argmin(axis=1)]
    u = np.cross(along, least)
    u *= (widths / np.linalg.norm(u, axis=1))[:, None]
    v = np.cross(along, u)
    middle = heads + waist * (tips - heads)
    return np.stack([heads, middle + u, middle + v, middle - u, middle - v, tips], axis=1)


def triangles(count: int) -> np.ndarray:
    """Corners of the triangles of octahedra, counter-clockwise seen from outside.

    Parameters
    ----------
    count : int
        How many octahedra.

    Returns
    -------
    (24 * count,) int
        Numbers of corners, three a triangle.
    """
    return (6 * np.arange(count)[:, None, None] + _TRIANGLES).reshape(-1)


def point_shape() -> np.ndarray:
    """Corners of a regular octahedron in the origin, (6, 3) in metres."""
    up = np.array([[0.0, RADIUS, 0.0]])
    return octahedra(-up, up, 0.5, np.array([RADIUS]))[0]


def bone_shapes(skeleton: Skeleton, rest: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners of an octahedron for each bone, and for each joint from which no bone starts.

    Parameters
    ----------
    skeleton : Skeleton
        J joints and their end sites.
    rest : (J, 3) float
        Where the joints are at rest, metres.

    Returns
    -------
    tuple of (B, 6, 3) float and (B,) int
        The corners at rest, and the joint with which each octahedron moves.
    """
    children = np.flatnonzero(skeleton.parents >= 0)
    on = np.concatenate((skeleton.parents[children], skeleton.end_parents))
    reach = np.concatenate((skeleton.offsets[children], skeleton.end_offsets))
    lengths = np.linalg.norm(reach, axis=1)
    there = lengths > 1e-6
    on, reach, lengths = on[there], reach[there], lengths[there]
    bones = octahedra(rest[on], rest[on] + reach, _WAIST, _SLIM * lengths)
    bare = np.setdiff1d(np.arange(len(skeleton)), on)
    return np.concatenate((bones, rest[bare][:, None] + point_shape())), np.concatenate((on, bare))
