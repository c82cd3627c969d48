"""One kind of body for every recording: points that have a role, which way they face, how large they are."""

from __future__ import annotations

import numpy as np

from leitmotion.body.roles import ROLES, mirror_role
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array, set_names


@noun
class BodyMap(Noun):
    """Which joints or markers of a recording stand for which role.

    Parameters
    ----------
    roles : tuple of str, R
        The roles that were found.
    members : tuple of tuple of str, R
        For each role the joints or markers whose mean it is (one joint; four head markers).
    confidence : (R,) float
        How sure each is, 0 to 1.

    Raises
    ------
    ParameterError
        When lengths disagree.
    """

    roles: tuple[str, ...]
    members: tuple[tuple[str, ...], ...]
    confidence: np.ndarray

    def __post_init__(self) -> None:
        roles = set_names(self, "roles")
        object.__setattr__(self, "members", tuple(tuple(m) for m in self.members))
        set_array(self, "confidence", dtype=np.float64, shape=(len(roles),))
        if len(self.members) != len(roles):
            raise ParameterError(
                f"BodyMap.members must be {len(roles)}, one a role, got {len(self.members)}."
            )

    def mirror(self, role: str) -> str | None:
        """Name the mirror partner of a role, None where the recording lacks it."""
        partner = mirror_role(role)
        return partner if partner in self.roles else None


def swap_sides(body_map: BodyMap) -> BodyMap:
    """Call left what was called right, and right what was called left.

    Only the names of the sides change place: each pair of roles exchanges its members and its confidence. That is what
    a file needs whose sides were named the wrong way round; a recording that was mirrored needs its axes turned.

    Parameters
    ----------
    body_map : BodyMap
        Any map.

    Returns
    -------
    BodyMap
        The roles in the order of :data:`leitmotion.body.ROLES`. Swapped twice it is the first again.

    Examples
    --------
    >>> found = BodyMap(("head", "left_knee"), (("skull",), ("l_shin",)), (1.0, 0.9))
    >>> swapped = swap_sides(found)
    >>> swapped.roles, swapped.members
    (('head', 'right_knee'), (('skull',), ('l_shin',)))
    """
    called = [mirror_role(role) for role in body_map.roles]
    order = sorted(range(len(called)), key=lambda place: ROLES.index(called[place]))
    return BodyMap(
        roles=tuple(called[place] for place in order),
        members=tuple(body_map.members[place] for place in order),
        confidence=body_map.confidence[order],
    )


@noun
class Body(Noun):
    """A person in motion as points with roles.

    Parameters
    ----------
    roles : tuple of str, R
        What each point is: a role of :data:`leitmotion.body.ROLES`; the recording's own point names where no
        role could be told.
    positions : (T, R, 3) float
        Where each is in the world, metres (or the recording's own unit), NaN where unseen. Y up.
    facing : (T,) float
        Yaw of the body's front about the vertical, radians; 0 faces +Z, pi/2 faces +X. Unwrapped along time.
        All zero where it cannot be told.
    rate : float
        Frames per second.
    size : float
        Body size: median length of the chain ankle-knee-hip plus pelvis-neck-head, in the unit of
        `positions`.
    unit : {"m", "px", "relative"}
        What a number of `positions` means.
    name : str
        What the recording is called.
    facing_told : bool
        Whether `facing` says which way the body faces, rather than being left at zero.

    Raises
    ------
    ParameterError
        When shapes disagree.
    """

    roles: tuple[str, ...]
    positions: np.ndarray
    facing: np.ndarray
    rate: float
    size: float
    unit: str = "m"
    name: str = ""
    facing_told: bool = True

    def __post_init__(self) -> None:
        roles = set_names(self, "roles")
        frames = set_array(
            self, "positions", dtype=np.float64, shape=(None, len(roles), None), finite=False
        ).shape[0]
        set_array(self, "facing", dtype=np.float64, shape=(frames,))
        check_rate(self)
        if not np.isfinite(self.size) or self.size <= 0:
            raise ParameterError(f"Body.size must be a positive length, got {self.size}.")

    def __len__(self) -> int:
        return self.positions.shape[0]
