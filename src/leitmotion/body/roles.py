"""Roles: what a joint or marker *is* on a human body, whatever a file calls it.

A role names a place: ``left_shoulder`` is the joint at the proximal end of the upper arm, ``left_hand`` the
knuckles, ``left_toe`` the ball of the foot. ``left`` is the person's left.
"""

from __future__ import annotations

from collections.abc import Collection

AXIAL_ROLES = ("pelvis", "spine", "chest", "neck", "head")
LIMB_ROLES = ("clavicle", "shoulder", "elbow", "wrist", "hand", "hip", "knee", "ankle", "toe")
ROLES = AXIAL_ROLES + tuple(f"{side}_{limb}" for side in ("left", "right") for limb in LIMB_ROLES)

ANALYSIS_ROLES = (
    "pelvis", "neck", "head",
    "left_shoulder", "left_elbow", "left_wrist", "left_hip", "left_knee", "left_ankle",
    "right_shoulder", "right_elbow", "right_wrist", "right_hip", "right_knee", "right_ankle",
)  # fmt: skip
"""The joints that every skeleton has: what analyses compare, so that 22- and 43-joint files answer alike."""

LINKS = (
    ("pelvis", "spine"), ("spine", "chest"), ("chest", "neck"), ("neck", "head"),
    *(
        (f"{side}_{a}" if a in LIMB_ROLES else a, f"{side}_{b}")
        for side in ("left", "right")
        for a, b in (
            ("chest", "clavicle"), ("clavicle", "shoulder"), ("shoulder", "elbow"), ("elbow", "wrist"),
            ("wrist", "hand"), ("pelvis", "hip"), ("hip", "knee"), ("knee", "ankle"), ("ankle", "toe"),
        )
    ),
)  # fmt: skip
"""Pairs of roles that a bone joins."""


ABOVE = {below: above for above, below in LINKS}
"""The role that each role hangs on."""


def links_between(roles: Collection[str]) -> tuple[tuple[str, str], ...]:
    """Join the roles that a body has, over the gaps that missing ones leave.

    Each role is joined to the nearest one above it; a shoulder whose clavicle and chest are missing to the neck.

    Parameters
    ----------
    roles : collection of str
        The roles of a body; names that are no roles are joined to nothing.

    Returns
    -------
    tuple of pair of str
        Pairs (upper, lower) that a line should join.

    Examples
    --------
    >>> links_between(["pelvis", "neck", "left_shoulder", "left_elbow", "left_knee"])
    (('pelvis', 'neck'), ('neck', 'left_shoulder'), ('left_shoulder', 'left_elbow'), ('pelvis', 'left_knee'))
    """
    joined = []
    for role in (role for role in ROLES if role in roles):
        above = ABOVE.get(role)
        while above is not None and above not in roles:
            above = (
                "neck"
                if above == "chest" and role not in AXIAL_ROLES and "neck" in roles
                else ABOVE.get(above)
            )
        if above is not None:
            joined.append((above, role))
    return tuple(joined)


def mirror_role(role: str) -> str:
    """Name the role on the other side of the body.

    Parameters
    ----------
    role : str
        A role.

    Returns
    -------
    str
        Its mirror partner; an axial role is its own.

    Examples
    --------
    >>> mirror_role("left_knee"), mirror_role("head")
    ('right_knee', 'head')
    """
    if role.startswith("left_"):
        return "right_" + role.removeprefix("left_")
    if role.startswith("right_"):
        return "left_" + role.removeprefix("right_")
    return role
