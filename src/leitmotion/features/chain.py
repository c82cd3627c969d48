"""Kinematic chain: a posture as fifteen rotations of which the mirror image is known (paper S, chapter 2)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.body import Body, BodyMap, chain_rotations, embody, find_roles, turned_by_file
from leitmotion.features.rotations import sequence_of
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import Motion, ParameterError, Trajectories

TOLD_BY = ("auto", "rotations", "places")


def kinematic_chain(
    recording: Motion | Trajectories | Body,
    body_map: BodyMap | None = None,
    *,
    told_by: str = "auto",
    links: Sequence[str] | None = None,
) -> FeatureSequence:
    """Describe each frame by how the links of the body are turned, whatever its place, yaw and proportions.

    The state of paper S, section 2.9: a unit quaternion for each of :data:`leitmotion.body.CHAIN_LINKS`, seen from the
    link that bears it, and the pelvis from the vertical: how it leans is kept, where it is and which way it faces is
    not. Rotations count from a rest pose in which every link is parallel to the axes of the body
    (:mod:`leitmotion.body.chain`), so that :func:`leitmotion.features.mirrored` is the mirror image.

    Of q and -q, which are one rotation, that one is taken which lies on the side of the joint's mean.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        T frames of one person in three dimensions.
    body_map : BodyMap, optional
        Which joints or points stand for which role; by default what :func:`leitmotion.body.find_roles` finds.
    told_by : {"auto", "rotations", "places"}
        What tells the turn of trunk and head, and of upper arms and thighs about themselves: the rotations of the file,
        or the places of the joints. "auto" takes rotations where the file has them and its zero pose is a posture.
    links : sequence of str, optional
        Which links; by default all that the body has.

    Returns
    -------
    FeatureSequence
        ``values`` (T, 4 L), ``width`` 4, ``unit`` "rad"; NaN where a joint was unseen.

    Raises
    ------
    ParameterError
        When a link is none, the recording has no such rotations, or `told_by` is none of these.
    DataError
        When the recording is planar, or the joints of the trunk are unknown.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)
    >>> len(chain.names), chain.values.shape[1]
    (15, 60)
    """
    if told_by not in TOLD_BY:
        raise ParameterError(f"told_by must be one of {', '.join(TOLD_BY)}, got {told_by!r}.")
    if isinstance(recording, Body):
        body = recording
    else:
        body_map = find_roles(recording) if body_map is None else body_map
        body = embody(recording, body_map)
    turned = None
    if isinstance(recording, Motion) and body_map is not None and told_by != "places":
        turned = turned_by_file(recording, body_map)
    if turned is None and told_by == "rotations":
        raise ParameterError(
            "The rotations of this recording cannot be counted from a rest pose of the body.",
            remedy='Leave told_by at "auto": the places of the joints tell it then.',
        )
    told = chain_rotations({role: body.positions[:, k] for k, role in enumerate(body.roles)}, turned)
    chosen = _choose(tuple(told), links)
    values = np.stack([told[link] for link in chosen], axis=1)
    return sequence_of(values, chosen, body.rate)


def _choose(known: tuple[str, ...], links: Sequence[str] | None) -> tuple[str, ...]:
    chosen = known if links is None else tuple(links)
    missing = [link for link in chosen if link not in known]
    if missing or not chosen:
        asked = f"no {missing[0]!r}" if missing else "nothing asked of it"
        raise ParameterError(f"The chain has {asked}.", remedy=f"It has {', '.join(known)}.")
    return chosen
