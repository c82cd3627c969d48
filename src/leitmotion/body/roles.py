"""Roles: what a joint or marker *is* on a human body, whatever a file calls it.

A role names a place: ``left_shoulder`` is the joint at the proximal end of the upper arm, ``left_hand`` the
knuckles, ``left_toe`` the ball of the foot. ``left`` is the person's left.
"""

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
