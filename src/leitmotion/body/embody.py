"""From any recording to one kind of body: positions by role, facing, size."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from leitmotion.body.body import Body, BodyMap
from leitmotion.body.facing import yaw_of_trunk
from leitmotion.body.mapfile import map_of
from leitmotion.body.names import parse_names
from leitmotion.body.roles import ANALYSIS_ROLES
from leitmotion.body.size import size_of_body, size_of_cloud
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, forward_kinematics

FEWEST_ROLES = 6
"""With fewer of the :data:`~leitmotion.body.ANALYSIS_ROLES` a recording is analysed by its own points."""

HELPERS = (
    "end", "nub", "site", "tip", "twist", "roll", "thumb", "finger", "index", "middle", "mid", "ring",
    "pinky", "eye", "jaw", "prop", "helper", "ik",
)  # fmt: skip


def embody(
    recording: Motion | Trajectories,
    body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None,
) -> Body:
    """Turn a recording into a body: points that have a role, which way they face, how large they are.

    A role of several members stands at their mean; it is NaN in a frame where one of them is unseen, since
    the mean of the others would jump. Facing is explained in :mod:`leitmotion.body.facing`, size in
    :mod:`leitmotion.body.size`.

    With fewer than six :data:`ANALYSIS_ROLES` the points keep the names that the recording gives them (a
    skeleton's fingers, twist joints and joints that coincide with their parent left out). Facing and size are
    still told by the few roles where they can; else facing is zero and size comes from the points' height.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames, Y up.
    body_map : BodyMap or mapping of str, optional
        Which of its points stand for which role, also as the content of a map file (:func:`map_from`); by
        default what :func:`find_roles` finds.

    Returns
    -------
    Body
        The roles in the order of :data:`leitmotion.body.ROLES`, in the unit of the recording.

    Raises
    ------
    ParameterError
        When the map names a point that the recording lacks.
    DataError
        When the recording has no frame, or nothing in it tells a size.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Trajectories
    >>> names = ("LeftHip", "LeftKnee", "LeftAnkle", "RightHip", "RightKnee", "RightAnkle", "Head")
    >>> x, y = [0.1, 0.1, 0.1, -0.1, -0.1, -0.1, 0], [0.9, 0.5, 0.1, 0.9, 0.5, 0.1, 1.6]
    >>> standing = np.stack([x, y, np.zeros(7)], axis=1)[None]
    >>> body = embody(Trajectories(names, standing, rate=30, kind="joint"))
    >>> body.roles[:3], body.facing.tolist(), round(body.size, 2)
    (('pelvis', 'head', 'left_hip'), [0.0], 1.4)
    """
    if len(recording) == 0:
        raise DataError(f"A body needs at least one frame, {recording.name or 'the recording'} has none.")
    body_map = map_of(recording, body_map)
    names, positions = _points(recording)
    _check_members(body_map, names)
    place = {name: i for i, name in enumerate(names)}
    by_role = {
        role: positions[:, [place[name] for name in members]].mean(axis=1)
        for role, members in zip(body_map.roles, body_map.members, strict=True)
    }
    yaw = yaw_of_trunk(by_role) if positions.shape[2] == 3 else None
    if len(set(by_role) & set(ANALYSIS_ROLES)) >= FEWEST_ROLES:
        roles, placed = tuple(by_role), np.stack(list(by_role.values()), axis=1)
    else:
        kept = _own_points(recording)
        roles, placed = tuple(names[i] for i in kept), positions[:, kept]
    size = size_of_body(by_role) or size_of_cloud(placed)
    if size is None:
        raise DataError(
            f"The size of the body cannot be told: the points of {recording.name or 'the recording'} "
            f"({len(roles)}) are never seen apart from one another."
        )
    return Body(
        roles=roles,
        positions=placed,
        facing=np.zeros(len(recording)) if yaw is None else yaw,
        rate=recording.rate,
        size=size,
        unit="m" if isinstance(recording, Motion) else recording.unit,
        name=recording.name,
        facing_told=yaw is not None,
    )


def _points(recording: Motion | Trajectories) -> tuple[tuple[str, ...], np.ndarray]:
    if isinstance(recording, Motion):
        return recording.skeleton.names, forward_kinematics(recording).positions
    return recording.names, recording.positions


def _check_members(body_map: BodyMap, names: tuple[str, ...]) -> None:
    for role, members in zip(body_map.roles, body_map.members, strict=True):
        missing = [name for name in members if name not in names]
        if missing:
            raise ParameterError(
                f"The body map needs {missing[0]!r} for {role}, which the recording lacks.",
                remedy=f"It has {', '.join(names)}.",
            )


def _own_points(recording: Motion | Trajectories) -> list[int]:
    """Which points speak for a recording whose roles are unknown."""
    if isinstance(recording, Trajectories):
        return list(range(len(recording.names)))
    skeleton = recording.skeleton
    apart = np.abs(recording.local_positions).max(axis=(0, 2)) > 0
    kept = [
        joint
        for joint, name in enumerate(parse_names(skeleton.names))
        if (apart[joint] or skeleton.parents[joint] < 0)
        and not name.word.startswith(HELPERS)
        and not name.word.endswith(HELPERS)
    ]
    return kept or list(range(len(skeleton)))
