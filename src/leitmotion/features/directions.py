"""Limb directions: which way the trunk and the long bones point, seen from the front of the body.

Conventions
-----------
A direction is a unit vector; of two directions the distance of their vectors is 2 sin(angle / 2), so the angle in
radians, to 5 % up to 60 degrees. Yaw is the body's facing, turned to +Z.

People differ in how long their bones are and in how wide their hips and shoulders are, and files differ in where they
put these. Lengths change no direction, widths none but through the facing, and what differs at one joint does not add
up along a limb as it does in places.
"""

from __future__ import annotations

import numpy as np

from leitmotion.body import Body
from leitmotion.features.posture import turn_to_front
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import DataError

BONES = {
    "neck": "pelvis",
    **{
        f"{side}_{lower}": f"{side}_{upper}"
        for side in ("left", "right")
        for upper, lower in (("shoulder", "elbow"), ("elbow", "wrist"), ("hip", "knee"), ("knee", "ankle"))
    },
}
"""Each bone by the role at its lower end, and the role at its upper end; the trunk is named neck."""


def limb_directions(body: Body) -> FeatureSequence:
    """Describe each frame by where the trunk and the long bones point, whatever the place, yaw, size and proportions.

    ========================== ============================
    name                       direction
    ========================== ============================
    neck                       the trunk: pelvis to neck
    left_elbow, right_elbow    upper arm: shoulder to elbow
    left_wrist, right_wrist    forearm: elbow to wrist
    left_knee, right_knee      thigh: hip to knee
    left_ankle, right_ankle    shank: knee to ankle
    ========================== ============================

    Parameters
    ----------
    body : Body
        T frames in three dimensions.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 3 R), ``width`` 3, ``unit`` "rad", those of the list whose two joints the body has; NaN where a
        joint was unseen or two coincide. Invariant to place, body size, unit, the lengths of these bones, and to yaw
        where the body knows its facing.

    Raises
    ------
    DataError
        When the recording is planar, or the body has none of these bones.

    Examples
    --------
    >>> arm = Body(("left_elbow", "left_wrist"), [[[0, 1, 0], [0, 1, 0.25]]], facing=[0.0], rate=30, size=1.5)
    >>> limb_directions(arm).names, limb_directions(arm).values.tolist()
    (('left_wrist',), [[0.0, 0.0, 1.0]])
    """
    if body.positions.shape[2] != 3:
        raise DataError("Limb directions need joints in three dimensions, got two.")
    names = limbs_of(body)
    if not names:
        raise DataError(
            "The body has no two joints of one limb.",
            remedy="Name its joints in a map file; `info` lists them.",
        )
    upper, lower = (
        body.positions[:, [body.roles.index(role) for role in roles]]
        for roles in ([BONES[name] for name in names], names)
    )
    bones = turn_to_front(lower - upper, body.facing)
    lengths = np.linalg.norm(bones, axis=2, keepdims=True)
    values = np.divide(bones, lengths, out=np.full_like(bones, np.nan), where=lengths > 0)
    told = ("yaw",) if body.facing_told else ()
    return FeatureSequence(
        values=values.reshape(len(values), -1),
        names=names,
        rate=body.rate,
        invariant_to=("place", *told, "body_size", "unit", "bone_lengths"),
        width=3,
        unit="rad",
    )


def limbs_of(body: Body) -> tuple[str, ...]:
    """Name the bones whose two ends a body has.

    Parameters
    ----------
    body : Body
        Any.

    Returns
    -------
    tuple of str
        Keys of :data:`BONES`.
    """
    return tuple(name for name, above in BONES.items() if name in body.roles and above in body.roles)
