"""Kinematic chain: fifteen links, each turned against the one that bears it, told by rotations or by places alone.

Conventions
-----------
In the rest pose a person stands upright, faces +Z and holds the arms out to the sides; there the frame of every link is
parallel to the axes of the body, +X to the person's left. Only so is ``(w, x, -y, -z)`` with the sides exchanged the
mirror image of a posture.

- *Pelvis* and *thorax* are what bears the hips and the shoulders. What turns the thorax against the pelvis is shared
  evenly among lower back, upper back and thorax, what turns the head against the thorax among lower neck, upper neck
  and head: a spine of three joints and one of five then say the same.
- *Femur* and *humerus* point along the bone and are turned about it so that knee and elbow bend in one plane: the shank
  to the back, the forearm (of an arm held out) to the front.
- *Tibia* and *radius* are hinges: the shortest way from the straight limb to the bent one.

References
----------
Paper S, sections 2.7 to 2.10.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

import numpy as np

from leitmotion.body.rest import LIMBS, Turned, rest_axes
from leitmotion.body.settling import settled
from leitmotion.motion import DataError
from leitmotion.motion.directions import between, from_axes, power
from leitmotion.motion.errors import in_short
from leitmotion.motion.rotations import IDENTITY, conjugate, multiply, rotate

AXIAL_LINKS = ("pelvis", "lower_back", "upper_back", "thorax", "lower_neck", "upper_neck", "head")
LIMB_LINKS = ("femur", "tibia", "humerus", "radius")
CHAIN_LINKS = AXIAL_LINKS + tuple(f"{side}_{link}" for side, link in product(("left", "right"), LIMB_LINKS))
"""The links of the body (paper S, section 2.7): seven along the axis, four to each side."""

BEARER = dict(zip(AXIAL_LINKS[1:], AXIAL_LINKS, strict=False)) | {
    f"{side}_{link}": above if link in ("femur", "humerus") else f"{side}_{above}"
    for side, (link, above) in product(
        ("left", "right"),
        {"femur": "pelvis", "tibia": "femur", "humerus": "thorax", "radius": "humerus"}.items(),
    )
}
"""The link that bears each."""

BENT = 0.25  # sine of the bend from which on the plane of a limb tells its turn rather than the shortest way

Points = Mapping[str, np.ndarray]


def chain_rotations(at: Points, turned: Turned | None = None) -> dict[str, np.ndarray]:
    """Turn each link of a body against the one that bears it.

    Parameters
    ----------
    at : mapping of str to (T, 3) float
        Positions by role, NaN where unseen.
    turned : Turned, optional
        How the file turns trunk, head and upper bones; what trunk, head and thighs prefer to one side, and the places
        of joints do not, is taken out (:mod:`leitmotion.body.settling`). Without it the trunk is told by its line
        (pelvis to neck) and those of hips and shoulders, the head by the line from the neck alone, the turn of an upper
        bone about itself by the plane of its limb; of a straight limb it is the shortest way from rest.

    Returns
    -------
    dict of str to (T, 4) float
        Unit quaternions by link, those of :data:`CHAIN_LINKS` whose joints the body has on both sides, in their order;
        the pelvis against the world, its yaw taken out. NaN where a joint was unseen or two coincide.

    Raises
    ------
    DataError
        When the body is planar, or lacks the pelvis, the neck, the hips or the shoulders.
    """
    _check(at)
    bones = {
        f"{side}_{bone}": unit(at[f"{side}_{middle}"] - at[f"{side}_{upper}"])
        for side, (bone, (upper, middle, _)) in product(("left", "right"), LIMBS.items())
        if _on_both(at, middle)
    }
    seen = _seen(at, bones)
    told = seen if turned is None else settled(turned, seen, bones)
    links = {"pelvis": _without_yaw(told.pelvis)}
    links |= dict.fromkeys(AXIAL_LINKS[1:4], power(multiply(conjugate(told.pelvis), told.thorax), 1 / 3))
    if told.head is not None:
        links |= dict.fromkeys(AXIAL_LINKS[4:], power(multiply(conjugate(told.thorax), told.head), 1 / 3))
    for name, bone in bones.items():
        bearer = told.pelvis if name.endswith("femur") else told.thorax
        links |= _limb(name, bone, _below(at, name), bearer, told.bends[name])
    return {link: links[link] for link in CHAIN_LINKS if link in links}


def _check(at: Points) -> None:
    wanted = ("pelvis", "neck", "left_hip", "right_hip", "left_shoulder", "right_shoulder")
    missing = [role for role in wanted if role not in at]
    if missing:
        raise DataError(
            f"The kinematic chain begins with the trunk, but no {missing[0]} is known among {in_short(at)}.",
            remedy="Name it in a map file, --map FILE (body_map= in Python). Of legs or arms alone only what recurs "
            "can be told: leitmotion patterns.",
        )
    if at["pelvis"].shape[-1] != 3:
        raise DataError(
            "The kinematic chain needs joints in three dimensions, got two.",
            remedy="Give the same movement with its depth. What recurs can be told in two: leitmotion patterns.",
        )


def _trunk(at: Points, joint: str) -> np.ndarray:
    """Frame of pelvis or thorax: up along the trunk, left along the line of hips or shoulders."""
    up = unit(at["neck"] - at["pelvis"])
    front = unit(np.cross(at[f"left_{joint}"] - at[f"right_{joint}"], up))
    return from_axes(np.cross(up, front), up, front)


def _head(at: Points, thorax: np.ndarray) -> np.ndarray:
    up = np.array([0.0, 1.0, 0.0])
    return multiply(thorax, between(up, rotate(conjugate(thorax), unit(at["head"] - at["neck"]))))


def _seen(at: Points, bones: Points) -> Turned:
    """How the places of the joints tell that a body is turned."""
    pelvis, thorax = (_trunk(at, joint) for joint in ("hip", "shoulder"))
    bends = {}
    for name, bone in bones.items():
        bearer = pelvis if name.endswith("femur") else thorax
        along, bend = rest_axes(*_side_last(name))
        towards = rotate(bearer, _shortest(along, bend, rotate(conjugate(bearer), bone)))
        below = _below(at, name)
        bends[name] = towards if below is None else _plane(bone, below, towards)
    return Turned(pelvis, thorax, _head(at, thorax) if "head" in at else None, bends)


def _below(at: Points, name: str) -> np.ndarray | None:
    """Which way the bone points that hangs on an upper one."""
    bone, side = _side_last(name)
    _, middle, lower = LIMBS[bone]
    return unit(at[f"{side}_{lower}"] - at[f"{side}_{middle}"]) if _on_both(at, lower) else None


def _limb(
    name: str, bone: np.ndarray, below: np.ndarray | None, bearer: np.ndarray, bends: np.ndarray
) -> dict[str, np.ndarray]:
    along, bend = rest_axes(*_side_last(name))
    seen, towards = (rotate(conjugate(bearer), each) for each in (bone, bends))
    towards = unit(towards - (towards * seen).sum(axis=-1, keepdims=True) * seen)
    at_rest = from_axes(along, bend, np.cross(along, bend))
    own = multiply(from_axes(seen, towards, np.cross(seen, towards)), conjugate(at_rest))
    links = {name: own}
    if below is not None:
        hinge = name.replace("femur", "tibia").replace("humerus", "radius")
        links[hinge] = between(along, rotate(conjugate(multiply(bearer, own)), below))
    return links


def _side_last(name: str) -> tuple[str, str]:
    side, _, bone = name.partition("_")
    return bone, side


def _on_both(at: Points, joint: str) -> bool:
    return f"left_{joint}" in at and f"right_{joint}" in at


def _shortest(along: np.ndarray, bend: np.ndarray, seen: np.ndarray) -> np.ndarray:
    """Where the shortest way from rest to the bone takes the direction of the bend; shorter the longer the way."""
    nearness = (1.0 + (seen @ along)[..., None]) / 2.0
    return nearness * rotate(between(along, seen), np.broadcast_to(bend, seen.shape))


def _plane(bone: np.ndarray, below: np.ndarray, shortest: np.ndarray) -> np.ndarray:
    """Which way the lower bone is bent; of a straight limb the shortest way decides, and there is no step between."""
    bent: np.ndarray = below - (below * bone).sum(axis=-1, keepdims=True) * bone
    return bent + BENT * shortest


def _without_yaw(q: np.ndarray) -> np.ndarray:
    """Keep the swing of the pelvis: what is left when its twist about the vertical is taken out."""
    twist = q * [1.0, 0.0, 1.0, 0.0]
    length = np.linalg.norm(twist, axis=-1, keepdims=True)
    upside_down = length < 1e-9
    twist = np.where(upside_down, IDENTITY, twist / np.where(upside_down, 1.0, length))
    return multiply(conjugate(twist), q)


def unit(vectors: np.ndarray) -> np.ndarray:
    """Scale vectors to length 1; NaN where there is no direction."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    scaled: np.ndarray = vectors / np.where(length > 0, length, np.nan)
    return scaled
