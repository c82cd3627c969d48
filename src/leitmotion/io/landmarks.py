"""Landmarks of BlazePose in tables: 33 points under its names or numbers, in a picture or in space."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.io.joint_sets import BLAZEPOSE
from leitmotion.io.points import plane_unit
from leitmotion.io.reading import Finding

_COUNT = len(BLAZEPOSE.joints)
_BOTH_SIGNS = (
    0.1  # share of coordinates below zero that points about the hips have, and those in a picture have not
)


class Landmarks(NamedTuple):
    """What the points of a table are."""

    names: list[str]
    positions: np.ndarray
    unit: Finding


def find_landmarks(names: list[str], positions: np.ndarray, warnings: list[str]) -> Landmarks | None:
    """Tell the landmarks of BlazePose by their names, or by their numbers from 0 or 1.

    Parameters
    ----------
    names : list of str, P
        What the points are called.
    positions : (T, P, C) float
        Where they are.
    warnings : list of str
        Gains a sentence where the depth of points in a picture was left out: it is no length in the picture's unit.

    Returns
    -------
    Landmarks or None
        None where the points are others.
    """
    words = [name.lower() for name in names]
    numbered = words in ([str(k) for k in range(_COUNT)], [str(k + 1) for k in range(_COUNT)])
    if not numbered and set(words) != set(BLAZEPOSE.joints):
        return None
    own = list(BLAZEPOSE.joints) if numbered else words
    flat = positions[..., :2]
    seen = flat[np.isfinite(flat)]
    if positions.shape[-1] == 3 and seen.size and float(np.mean(seen < 0.0)) > _BOTH_SIGNS:
        return Landmarks(own, positions, Finding("m", "guessed", "landmarks about the middle of the hips"))
    if positions.shape[-1] == 3:
        warnings.append("The depth of the points is no length in the picture's unit and was left out.")
    return Landmarks(own, flat, plane_unit(flat, "landmarks in a picture"))
