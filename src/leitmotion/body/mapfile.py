"""The map file: a person says which joint or marker stands for which role.

A map file is a JSON object, role to name or to a list of names: ``{"left_knee": "Channel104", "head":
["Channel101", "Channel102"]}``. Roles that it leaves out are absent; it is not mixed with what
:func:`find_roles` would find.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches

import numpy as np

from leitmotion.body.body import BodyMap
from leitmotion.body.mapping import find_roles
from leitmotion.body.roles import ROLES
from leitmotion.motion import Motion, ParameterError, Trajectories


def map_from(entries: Mapping[str, str | Sequence[str]], recording: Motion | Trajectories) -> BodyMap:
    """Make a body map of what a person wrote.

    Parameters
    ----------
    entries : mapping of str to str or sequence of str
        The content of a map file: role to joint or marker, or to several whose mean it is.
    recording : Motion or Trajectories
        What the map is for.

    Returns
    -------
    BodyMap
        The same, in the order of :data:`leitmotion.body.ROLES`, each with confidence 1.

    Raises
    ------
    ParameterError
        When a role is none of those, a name is none of the recording's, or an entry is empty or no name at
        all.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> two = Trajectories(("m1", "m2"), np.zeros((1, 2, 3)), rate=100)
    >>> map_from({"head": ["m1", "m2"]}, two).members
    (('m1', 'm2'),)
    """
    if not isinstance(entries, Mapping):
        raise ParameterError(
            f"A body map is an object of roles and names, got {type(entries).__name__}.",
            remedy='Write {"left_knee": "LKNE", "head": ["LFHD", "RFHD"]}.',
        )
    names = recording.skeleton.names if isinstance(recording, Motion) else recording.names
    for role in entries:
        if role not in ROLES:
            raise ParameterError(
                f"The body map has no role {role!r} to give.", remedy=_hint(role, ROLES, "Roles are")
            )
    members = {role: _members(role, entry, names) for role, entry in entries.items()}
    roles = tuple(role for role in ROLES if role in members)
    return BodyMap(roles, tuple(members[role] for role in roles), np.ones(len(roles)))


def map_of(
    recording: Motion | Trajectories, body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None
) -> BodyMap:
    """Take the body map that was given, in whichever form, or find one.

    Parameters
    ----------
    recording : Motion or Trajectories
        What the map is for.
    body_map : BodyMap or mapping of str, optional
        Which joints or points stand for which role; by default what :func:`find_roles` finds.

    Returns
    -------
    BodyMap
        The map; the very same value where it is one already.

    Raises
    ------
    ParameterError
        As for :func:`map_from`.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> two = Trajectories(("LeftKnee", "m2"), np.zeros((1, 2, 3)), rate=100)
    >>> map_of(two).roles, map_of(two, {"head": "m2"}).roles
    (('left_knee',), ('head',))
    """
    if body_map is None:
        return find_roles(recording)
    return body_map if isinstance(body_map, BodyMap) else map_from(body_map, recording)


def map_to_entries(body_map: BodyMap) -> dict[str, str | list[str]]:
    """Write a body map as the content of a map file; :func:`map_from` reads it back.

    Parameters
    ----------
    body_map : BodyMap
        Any map.

    Returns
    -------
    dict
        Role to name, or to a list of names.
    """
    return {
        role: members[0] if len(members) == 1 else list(members)
        for role, members in zip(body_map.roles, body_map.members, strict=True)
    }


def _members(role: str, entry: object, names: Sequence[str]) -> tuple[str, ...]:
    members = (entry,) if isinstance(entry, str) else tuple(entry) if isinstance(entry, Sequence) else ()
    if not members or not all(isinstance(name, str) for name in members):
        raise ParameterError(f"The body map must give {role} a name or a list of names, got {entry!r}.")
    for name in members:
        if name not in names:
            raise ParameterError(
                f"The body map says that {role} is {name!r}, but the recording has no such point.",
                remedy=_hint(name, names, "It has"),
            )
    if len(set(members)) != len(members):
        raise ParameterError(f"The body map names a point twice for {role}: {', '.join(members)}.")
    return members


def _hint(word: str, known: Sequence[str], lead: str) -> str:
    folded = {name.lower(): name for name in known}
    near = [folded[name] for name in get_close_matches(word.lower(), folded, n=3, cutoff=0.6)]
    listed = f"{lead} {', '.join(known)}."
    return f"Did you mean {' or '.join(near)}? {listed}" if near else listed
