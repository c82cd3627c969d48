"""A human skeleton of average proportions.

Conventions
-----------
Rest is the T-pose: upright, facing +Z, arms along +X and -X, the soles on the floor when the hips stand at
:data:`HIPS_HEIGHT` body heights. ``LeftArm`` is the joint at the shoulder, ``LeftShoulder`` the one at the inner end of
the clavicle, ``LeftHand`` the wrist, ``LeftFoot`` the ankle, ``LeftToeBase`` the ball of the foot. End sites: top of
the head, finger tips, toe tips and heels.

References
----------
[1] R. Drillis and R. Contini, *Body segment parameters*, Tech. Rep. 1166-03, New York University, 1966; the figure as
    it stands in D. A. Winter, *Biomechanics and Motor Control of Human Movement*, 4th ed., Wiley, 2009, fig. 4.1.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion import ParameterError, Skeleton

# Heights above the floor and lengths of segments as fractions of body height [1].
ANKLE, KNEE, HIP, SHOULDER, CHIN = 0.039, 0.285, 0.530, 0.818, 0.870
UPPER_ARM, FOREARM, HAND, FOOT = 0.186, 0.146, 0.108, 0.152
THIGH, SHANK = HIP - KNEE, KNEE - ANKLE

# Breadths in [1] are those of the outline; these are half the distances between the joint centres within it.
HALF_HIPS, HALF_SHOULDERS = 0.050, 0.105
HIPS_HEIGHT = 0.545  # the root lies between the hip joints, a little above them
HEEL, BALL = 0.030, 0.072  # behind and before the ankle; the toes are the rest of the foot
BALL_HEIGHT, TOE_HEIGHT = 0.011, 0.006

_AXIS = (
    ("Hips", "", (0.0, HIPS_HEIGHT, 0.0)),
    ("Spine", "Hips", (0.0, 0.060, -0.004)),
    ("Chest", "Spine", (0.0, 0.085, -0.006)),
    ("Neck", "Chest", (0.0, SHOULDER + 0.014 - HIPS_HEIGHT - 0.145, 0.004)),
    ("Head", "Neck", (0.0, CHIN + 0.008 - SHOULDER - 0.014, 0.008)),
)
_ARM = (
    ("Shoulder", "Chest", (0.016, SHOULDER - 0.010 - HIPS_HEIGHT - 0.145, 0.010)),
    ("Arm", "Shoulder", (HALF_SHOULDERS - 0.016, 0.0, -0.008)),
    ("ForeArm", "Arm", (UPPER_ARM, 0.0, 0.0)),
    ("Hand", "ForeArm", (FOREARM, 0.0, 0.0)),
)
_LEG = (
    ("UpLeg", "Hips", (HALF_HIPS, HIP - HIPS_HEIGHT, 0.0)),
    ("Leg", "UpLeg", (0.0, -THIGH, 0.0)),
    ("Foot", "Leg", (0.0, -SHANK, 0.0)),
    ("ToeBase", "Foot", (0.0, BALL_HEIGHT - ANKLE, BALL)),
)
_ENDS = (
    ("Hand", (HAND, 0.0, 0.0)),
    ("ToeBase", (0.0, TOE_HEIGHT - BALL_HEIGHT, FOOT - HEEL - BALL)),
    ("Foot", (0.0, -ANKLE, -HEEL)),
)


def human_skeleton(height: float = 1.75) -> Skeleton:
    """Build a skeleton with the segment lengths of an average adult [1].

    Parameters
    ----------
    height : float
        Body height in metres.

    Returns
    -------
    Skeleton
        21 joints, J = 21, in metres.

    Raises
    ------
    ParameterError
        When the height is not a positive length.

    Examples
    --------
    >>> from leitmotion.datasets import human_skeleton
    >>> adult = human_skeleton(1.75)
    >>> shank = adult.offsets[adult.index("LeftFoot")]
    >>> len(adult), round(float(-shank[1]), 3)
    (21, 0.43)
    """
    if not np.isfinite(height) or height <= 0:
        raise ParameterError(f"height must be a positive length in metres, got {height}.")
    joints = list(_AXIS)
    sides = (("Left", 1.0), ("Right", -1.0))
    for limb in (_ARM, _LEG):
        for side, sign in sides:
            for name, parent, (x, y, z) in limb:
                on = parent if parent in ("Hips", "Chest") else side + parent
                joints.append((side + name, on, (sign * x, y, z)))
    names = tuple(name for name, _, _ in joints)
    ends = [("Head", (0.0, 1.0 - CHIN - 0.008, 0.0))]
    for side, sign in sides:
        ends += [(side + name, (sign * x, y, z)) for name, (x, y, z) in _ENDS]
    return Skeleton(
        names,
        np.array([names.index(parent) if parent else -1 for _, parent, _ in joints]),
        height * np.array([offset for _, _, offset in joints]),
        np.array([names.index(parent) for parent, _ in ends]),
        height * np.array([offset for _, offset in ends]),
    )
