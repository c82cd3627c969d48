"""The features by name: what each is computed from, and what it is invariant to."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from types import MappingProxyType, UnionType
from typing import Any, NamedTuple

from leitmotion.body import Body, BodyMap, embody, map_from
from leitmotion.features.angles import joint_angles
from leitmotion.features.chain import kinematic_chain
from leitmotion.features.directions import limb_directions
from leitmotion.features.markers import marker_posture
from leitmotion.features.posture import posture
from leitmotion.features.rotations import joint_rotations
from leitmotion.features.sequence import FeatureSequence
from leitmotion.features.velocity import velocity
from leitmotion.motion import Motion, ParameterError, Trajectories

ANY = Motion | Trajectories | Body


class Feature(NamedTuple):
    """A way to describe a frame."""

    compute: Callable[..., FeatureSequence]
    """The function."""

    takes: type | UnionType
    """What its first argument is: Body, Motion or Trajectories, or any of them."""

    invariant_to: tuple[str, ...]
    """What may change without changing its values."""

    summary: str
    """What it is, in one line."""

    measured_in: str
    """What a distance of 1 is."""

    alike: Mapping[str, float] = MappingProxyType({})
    """From which distance on two moments are alike, by the weights of the joints; empty where nobody has measured it.
    The equal error rate of the pairs that people labelled, ``benchmarks/bench_calibration.py``."""


FEATURES = {
    "posture": Feature(
        posture,
        Body,
        ("place", "yaw", "body_size", "unit"),
        "where the joints are, seen from the body",
        "body sizes",
        MappingProxyType({"equal": 0.054, "active": 0.086}),
    ),
    "velocity": Feature(
        velocity,
        Body,
        ("place", "yaw", "body_size", "unit"),
        "how fast and which way the joints move",
        "body sizes a second",
        MappingProxyType({"equal": 0.230, "active": 0.319}),
    ),
    "joint_angles": Feature(
        joint_angles,
        Body,
        ("place", "yaw", "body_size", "unit", "bone_lengths"),
        "which way each bone points, seen from the one above",
        "radians",
        MappingProxyType({"equal": 0.222, "active": 0.318}),
    ),
    "limb_directions": Feature(
        limb_directions,
        Body,
        ("place", "yaw", "body_size", "unit", "bone_lengths"),
        "which way the trunk and the long bones point, seen from the front",
        "radians",
        MappingProxyType({"equal": 0.250, "active": 0.288}),
    ),
    "joint_rotations": Feature(
        joint_rotations,
        Motion,
        ("place", "yaw", "body_size", "unit", "bone_lengths"),
        "how each joint is turned against the one above",
        "double radians",
        MappingProxyType({"equal": 0.126, "active": 0.159}),
    ),
    "kinematic_chain": Feature(
        kinematic_chain,
        ANY,
        ("place", "yaw", "body_size", "unit", "bone_lengths"),
        "how the fifteen links of the body are turned (paper S), so that the mirror image is known",
        "double radians",
    ),
    "marker_posture": Feature(
        marker_posture,
        Trajectories,
        ("place", "yaw"),
        "where all markers are (paper P, eq. 1), in metres",
        "metres",
    ),
}
"""The features by name."""

_WANTED: dict[type | UnionType, str] = {
    ANY: "the recording of a person",
    Body: "a body",
    Motion: "how a skeleton's joints are turned",
    Trajectories: "the markers of a recording",
}
_HELD = {
    Body: "a body, which keeps only the places of its joints",
    Motion: "a skeleton",
    Trajectories: "points alone",
}


def extract(
    name: str,
    source: Motion | Trajectories | Body,
    body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None,
    **options: Any,
) -> FeatureSequence:
    """Compute a feature by its name.

    Parameters
    ----------
    name : str
        A key of :data:`FEATURES`.
    source : Motion, Trajectories or Body
        What to describe; a recording becomes a body where the feature takes one.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, also as the content of a map file; by default read from names.
    **options
        Passed on to the feature: ``roles`` for posture, velocity and joint_rotations, ``links`` and ``told_by`` for
        kinematic_chain, ``mid_back`` and ``trunk`` for marker_posture.

    Returns
    -------
    FeatureSequence
        One row a frame.

    Raises
    ------
    ParameterError
        When no feature bears that name, it does not take such a source or such an option, or a body map is given
        where it has no use.

    Examples
    --------
    >>> body = Body(("pelvis",), [[[0, 1, 0]], [[0, 2, 0]]], facing=[0, 0], rate=10, size=1.0)
    >>> extract("velocity", body).values.tolist()
    [[0.0, 10.0, 0.0], [0.0, 10.0, 0.0]]
    """
    if name not in FEATURES:
        near = get_close_matches(name, FEATURES, n=1)
        hint = f"Did you mean {near[0]}? " if near else ""
        raise ParameterError(
            f"There is no feature {name!r}.", remedy=f"{hint}Features are {', '.join(FEATURES)}."
        )
    feature, given = FEATURES[name], type(source)
    if feature.takes is Body and isinstance(source, Motion | Trajectories):
        source, body_map = embody(source, body_map), None
    if not isinstance(source, feature.takes):
        held = _HELD.get(type(source), type(source).__name__)
        raise ParameterError(
            f"The feature {name} compares {_WANTED[feature.takes]}, and this is {held}.",
            remedy=f"Compare one of {', '.join(key for key, one in FEATURES.items() if one.takes in (Body, given))}.",
        )
    known = list(inspect.signature(feature.compute).parameters)[1:]
    if body_map is not None:
        if "body_map" not in known or isinstance(source, Body):
            why = "a body has its roles already" if isinstance(source, Body) else "it has no use for roles"
            raise ParameterError(f"The feature {name} takes no body map here: {why}.")
        options["body_map"] = body_map if isinstance(body_map, BodyMap) else map_from(body_map, source)
    unknown = sorted(set(options) - set(known))
    if unknown:
        raise ParameterError(f"The feature {name} has no option {unknown[0]!r}; it has {', '.join(known)}.")
    return feature.compute(source, **options)
