"""Settling: the rotations of a file, with no side preferred but where the places of the joints prefer it too.

Conventions
-----------
A file's rotations count from a zero pose, and that was fitted: its hips may be a little higher on one side, its head
look a little aside. Such a constant makes every posture lopsided, though the joints are where they should be. Where the
rotations and the places of the joints differ to the same side nearly throughout a recording, the usual difference is
taken out of the rotations, as far as a mirror would reverse it: a turn or a lean to the side, the turn of a thigh about
itself where the other is turned otherwise. What both sides have in common stays the file's, such as how the pelvis is
tilted against the trunk; so does what differs now to one side, now to the other, for that is movement. The turn of an
upper arm stays the file's too: the bend of an elbow tells it less well than that of a knee.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from leitmotion.body.rest import Turned
from leitmotion.motion.rotations import conjugate, from_rotation_vector, multiply, normalize

THIGHS = ("left_femur", "right_femur")
NEARLY = 0.9  # of the moments have to differ to the same side


def settled(told: Turned, seen: Turned, bones: Mapping[str, np.ndarray]) -> Turned:
    """Take out of a file's rotations by what constant turn they prefer a side that the places of joints do not.

    Parameters
    ----------
    told : Turned
        How the file turns the body, T frames.
    seen : Turned
        How the places of its joints tell that it is turned.
    bones : mapping of str to (T, 3) float
        Which way each upper bone points, unit vectors in the world.

    Returns
    -------
    Turned
        Its trunk, head and thighs no more to one side, on the whole, than the places say.
    """
    bends = dict(told.bends)
    thighs = [name for name in THIGHS if name in seen.bends]
    if thighs:  # of mirror images one is turned the other way round, so that a mean is what the two have not in common
        twists = [_twist(told.bends[name], seen.bends[name], bones[name]) for name in thighs]
        (angle,) = _shared(np.mean(twists, axis=0)[:, None])
        for name in thighs:
            bends[name] = np.cos(angle) * bends[name] + np.sin(angle) * np.cross(bones[name], bends[name])
    head = told.head if told.head is None or seen.head is None else _even(told.head, seen.head)
    return Turned(_even(told.pelvis, seen.pelvis), _even(told.thorax, seen.thorax), head, bends)


def _even(told: np.ndarray, seen: np.ndarray) -> np.ndarray:
    """Follow rotations by the constant turn to what is seen, but for what turns about the left axis."""
    turn = multiply(conjugate(told), seen)
    with np.errstate(
        invalid="ignore"
    ):  # of half a turn to the side nothing tells what part is about the left axis
        about = normalize(turn * [1.0, 1.0, 0.0, 0.0])
    aside = multiply(turn, conjugate(about))
    half = np.arctan2(np.linalg.norm(aside[:, 1:], axis=1), aside[:, 0])[:, None]
    return multiply(told, from_rotation_vector(_shared(2.0 * aside[:, 1:] / np.sinc(half / np.pi))))


def _twist(told: np.ndarray, seen: np.ndarray, bone: np.ndarray) -> np.ndarray:
    """The angle about a bone from one direction to another, at each frame."""
    told, seen = (each - (each * bone).sum(axis=-1, keepdims=True) * bone for each in (told, seen))
    angle: np.ndarray = np.arctan2((np.cross(told, seen) * bone).sum(axis=-1), (told * seen).sum(axis=-1))
    return angle


def _shared(values: np.ndarray) -> np.ndarray:
    """The usual value of each column where nearly all rows have its sign, else zero."""
    values = values[np.isfinite(values).all(axis=1)]
    if not len(values):
        return np.zeros(values.shape[1])
    low, usual, high = np.quantile(values, (1.0 - NEARLY, 0.5, NEARLY), axis=0)
    return np.where(low * high > 0, usual, 0.0)
