"""Joint rotations: how each joint is turned against the one that it hangs on.

Conventions
-----------
Unit quaternions (w, x, y, z). The joint of a role turns against the joint of the role above it
(:data:`leitmotion.body.LINKS`), so that joints in between (twists, a spine of three or of five) do not count;
the pelvis turns against the world, its yaw taken out.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.body import ANALYSIS_ROLES, BodyMap, find_roles
from leitmotion.body.roles import ABOVE
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import DataError, Motion, ParameterError, forward_kinematics
from leitmotion.motion.rotations import conjugate, multiply, yaw_rotation

RADIANS = 2.0  # |p - q| = 2 sin(angle / 4): half the angle, to 3 % up to 100 degrees


def joint_rotations(
    motion: Motion, body_map: BodyMap | None = None, *, roles: Sequence[str] | None = None
) -> FeatureSequence:
    """Describe each frame by the rotations of the joints, whatever the body's place, yaw and proportions.

    The two quaternions of one rotation lie on opposite sides of the sphere. Of each joint that one is taken
    which lies on the side of the joint's mean rotation over the recording (the principal axis of the sum of q
    qᵀ), so that equal rotations have equal values at any two times. Rotations count from the rest pose of the
    file: recordings are comparable when their rest poses agree.

    Parameters
    ----------
    motion : Motion
        T frames of a skeleton.
    body_map : BodyMap, optional
        Which joints stand for which role; by default what :func:`leitmotion.body.find_roles` finds. Roles
        that are a mean of several joints have no rotation and are left out.
    roles : sequence of str, optional
        Which joints; by default those of :data:`leitmotion.body.ANALYSIS_ROLES` that have a rotation.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 4 R), ``width`` 4, ``unit`` "rad": a distance times `scale` is, for small angles, in
        radians.

    Raises
    ------
    ParameterError
        When a role asked for has no joint of its own.
    DataError
        When no role is known.

    Examples
    --------
    >>> from leitmotion.motion import Skeleton
    >>> spine = Skeleton(("Hips", "Head"), [-1, 0], [[0, 0, 0], [0, 0.6, 0]])
    >>> turning = np.stack([yaw_rotation(np.arange(3.0)), yaw_rotation(np.full(3, 0.2))], axis=1)
    >>> motion = Motion(spine, np.tile(spine.offsets, (3, 1, 1)), turning, rate=30)
    >>> joint_rotations(motion).values.round(3).tolist()[2]
    [1.0, 0.0, 0.0, 0.0, 0.995, 0.0, 0.1, 0.0]
    """
    if body_map is None:
        body_map = find_roles(motion)
    joint = {
        role: motion.skeleton.index(members[0])
        for role, members in zip(body_map.roles, body_map.members, strict=True)
        if len(members) == 1
    }
    chosen = _choose(joint, roles)
    turned = forward_kinematics(motion).rotations
    values = np.stack([_relative(role, joint, turned) for role in chosen], axis=1)
    return sequence_of(values, chosen, motion.rate)


def sequence_of(turned: np.ndarray, names: tuple[str, ...], rate: float) -> FeatureSequence:
    """Make a sequence of rotations, each told by that of its two quaternions that is nearer to the mean.

    Parameters
    ----------
    turned : (T, M, 4) float
        Unit quaternions, w first.
    names : tuple of str, M
        What turns.
    rate : float
        Frames per second.

    Returns
    -------
    FeatureSequence
        4 M columns; a distance of 1 is two radians.
    """
    values = turned * towards_mean(turned)
    return FeatureSequence(
        values=values.reshape(len(values), -1),
        names=names,
        rate=rate,
        invariant_to=("place", "yaw", "body_size", "unit", "bone_lengths"),
        width=4,
        scale=RADIANS,
        unit="rad",
    )


def _choose(joint: dict[str, int], roles: Sequence[str] | None) -> tuple[str, ...]:
    chosen = tuple(role for role in ANALYSIS_ROLES if role in joint) if roles is None else tuple(roles)
    missing = [role for role in chosen if role not in joint]
    if missing:
        raise ParameterError(
            f"No single joint stands for {missing[0]!r}.",
            remedy=f"Rotations are known of {', '.join(joint)}.",
        )
    if not chosen:
        raise DataError(
            "No joint of this skeleton has a role, so that its rotations cannot be named.",
            remedy="Give a body map.",
        )
    return chosen


def _relative(role: str, joint: dict[str, int], turned: np.ndarray) -> np.ndarray:
    own = turned[:, joint[role]]
    above = ABOVE.get(role)
    while above is not None and above not in joint:
        above = ABOVE.get(above)
    if above is None:
        twist = 2.0 * np.arctan2(own[:, 2], own[:, 0])
        return multiply(yaw_rotation(-twist), own)
    return multiply(conjugate(turned[:, joint[above]]), own)


def towards_mean(values: np.ndarray) -> np.ndarray:
    """Choose of q and -q the one beside the joint's mean rotation, of which w is not negative.

    Parameters
    ----------
    values : (T, J, 4) float
        Unit quaternions, NaN where unseen.

    Returns
    -------
    (T, J, 1) float
        1 or -1.
    """
    seen = np.where(np.isfinite(values), values, 0.0)
    moments = np.einsum("tji,tjk->jik", seen, seen)
    mean = np.linalg.eigh(moments)[1][..., -1]  # eigenvalues come in ascending order
    mean *= np.where(mean[:, :1] < 0, -1.0, 1.0)
    return np.where(np.einsum("tji,ji->tj", seen, mean) < 0, -1.0, 1.0)[..., None]
