"""What of a recording is compared: its features, of the joints that were asked for, weighed as was asked for."""

from __future__ import annotations

import difflib
import fnmatch
from collections.abc import Mapping, Sequence

from leitmotion.body import ROLES, Body, BodyMap, embody
from leitmotion.features import FEATURES, FeatureSequence, active_weights, extract, weighted
from leitmotion.features.posture import choose_roles
from leitmotion.motion import Motion, ParameterError, Trajectories
from leitmotion.motion.errors import in_short

Recording = Motion | Trajectories | Body
Roles = BodyMap | Mapping[str, str | list[str]]
WEIGHTS = ("equal", "active")
BY_ROLE = ("posture", "velocity")
"""Features of which each role that a body has may be asked for."""


def described(
    recording: Recording,
    name: str,
    *,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
) -> FeatureSequence:
    """Compute the features of that name, of the joints that were asked for.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    name : str
        Of the features.
    joints, exclude, body_map
        As for :func:`leitmotion.find_patterns`.

    Returns
    -------
    FeatureSequence
        One row a frame.
    """
    if name in BY_ROLE:
        body = as_body(recording, body_map)
        roles = _chosen(body.roles, choose_roles(body, None), joints, exclude)
        return extract(name, body, roles=roles)
    whole = extract(name, recording, body_map)
    return only(whole, _chosen(whole.names, whole.names, joints, exclude))


def only(features: FeatureSequence, names: tuple[str, ...]) -> FeatureSequence:
    """Keep the joints of these names, in their order."""
    if names == features.names:
        return features
    places = [features.names.index(name) for name in names]
    values = features.values.reshape(len(features), -1, features.width)[:, places]
    weights = tuple(features.weights[k] for k in places) if features.weights else ()
    return features.replace(values=values.reshape(len(features), -1), names=names, weights=weights)


def weighed(features: FeatureSequence, weights: str) -> FeatureSequence:
    """Weigh the joints equally, or by how much they move.

    Parameters
    ----------
    features : FeatureSequence
        One row a frame.
    weights : {"equal", "active"}
        How.

    Returns
    -------
    FeatureSequence
        Of the same scale.

    Raises
    ------
    ParameterError
        When there are no such weights.
    """
    if known_weights(weights) == "equal":
        return features
    return weighted(features, active_weights(features))


def known_weights(weights: str) -> str:
    """Refuse weights that there are not."""
    if weights not in WEIGHTS:
        raise ParameterError(f"weights must be one of {', '.join(WEIGHTS)}, got {weights!r}.")
    return weights


def as_body(recording: Recording, body_map: Roles | None) -> Body:
    """Make a body of a recording; a body is one."""
    if isinstance(recording, Body):
        return recording
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(
            f"A recording was expected, got {type(recording).__name__}.",
            remedy='Read the file first: leitmotion.read("dance.bvh").',
        )
    return embody(recording, body_map)


def of_body(name: str) -> bool:
    """Whether features are computed from a body, rather than from the recording itself."""
    return name not in FEATURES or FEATURES[name].takes is Body


def _chosen(
    known: Sequence[str],
    usual: tuple[str, ...],
    joints: str | Sequence[str] | None,
    exclude: str | Sequence[str] | None,
) -> tuple[str, ...]:
    wanted = usual if joints is None else _matching(joints, known)
    unwanted = _matching(exclude, (*known, *ROLES)) if exclude else ()
    roles = tuple(role for role in wanted if role not in unwanted)
    if not roles:
        raise ParameterError("No joint is left to compare.", remedy="Exclude fewer.")
    return roles


def _matching(names: str | Sequence[str], known: Sequence[str]) -> tuple[str, ...]:
    """Those of the known roles that the names mean, wildcards allowed, in the order in which they are known."""
    if not isinstance(names, str | Sequence) or not all(isinstance(name, str) for name in names):
        raise ParameterError(
            f"Joints are given by their names, got {names!r}.", remedy='Give ["head", "left_*"].'
        )
    listed = (names,) if isinstance(names, str) else names
    given = [name.strip() for some in listed for name in some.split(",") if name.strip()]
    if not given:
        raise ParameterError(
            "No joint is named.", remedy="Leave joints out to compare those that every body has."
        )
    for name in given:
        if not any(fnmatch.fnmatchcase(role, name) for role in known):
            near = difflib.get_close_matches(name, known, n=1)
            most = (
                len(ROLES) if set(known) <= set(ROLES) else 8
            )  # roles are few, the points of a file may be many
            hint = f"Did you mean {near[0]}? " if near else ""
            raise ParameterError(
                f"The body has no joint {name!r} to compare.",
                remedy=f"{hint}It has {in_short(dict.fromkeys(known), most=most)}.",
            )
    return tuple(role for role in known if any(fnmatch.fnmatchcase(role, name) for name in given))
