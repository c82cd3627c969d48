"""The joints of a recording that dynamics needs, and when they are seen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from leitmotion.body.body import Body, BodyMap
from leitmotion.body.mapfile import map_of
from leitmotion.body.segments import NEEDED, has_no_length
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, forward_kinematics
from leitmotion.motion.smoothing import SHORTEST

OPTIONAL = {
    "left_hand": "left_wrist", "right_hand": "right_wrist", "left_toe": "left_ankle", "right_toe": "right_ankle",
}  # fmt: skip
"""Roles that are used where a recording has them, and where their segment begins."""


def joints_by_role(
    recording: Motion | Trajectories | Body,
    body_map: BodyMap | Mapping[str, str | Sequence[str]] | None,
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray], float]:
    """Take the joints that segments end in.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person, T frames.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role.

    Returns
    -------
    dict of str to (T, 3) float
        Global positions by role, m, NaN where unseen.
    dict of str to (T, 4) float
        Global rotations by role, of such as are one joint of a skeleton.
    float
        Frames per second.

    Raises
    ------
    ParameterError
        When it is no recording, or a map is given for a Body.
    DataError
        When it is not in metres and three dimensions.
    """
    if isinstance(recording, Body):
        if body_map is not None:
            raise ParameterError("The roles of a Body are settled.", remedy="Give the recording itself.")
        _check_metres(recording.unit, recording.positions.shape[2])
        return _by_role(recording.roles, recording.positions), {}, recording.rate
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(
            f"A recording was expected, got {type(recording).__name__}.",
            remedy='Read the file first: leitmotion.read("dance.bvh").',
        )
    held = map_of(recording, body_map)
    if isinstance(recording, Trajectories):
        _check_metres(recording.unit, recording.positions.shape[2])
        names, positions, turned = recording.names, recording.positions, None
    else:
        pose = forward_kinematics(recording)
        names, positions, turned = recording.skeleton.names, pose.positions, pose.rotations
    place = {name: k for k, name in enumerate(names)}
    points, turns = {}, {}
    for role, members in zip(held.roles, held.members, strict=True):
        points[role] = positions[:, [place[name] for name in members]].mean(axis=1)
        if turned is not None and len(members) == 1:
            turns[role] = turned[:, place[members[0]]]
    return _wanted(points), turns, recording.rate


def _by_role(roles: Sequence[str], positions: np.ndarray) -> dict[str, np.ndarray]:
    return _wanted({role: positions[:, k] for k, role in enumerate(roles)})


def _wanted(points: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The roles that segments end in; of hands and toes those that stand apart, seen whenever all others are."""
    kept = {role: points[role] for role in NEEDED if role in points}
    seen = np.isfinite(np.stack(list(kept.values()), axis=1)).all(axis=(1, 2)) if kept else np.zeros(0, bool)
    for role, upper in OPTIONAL.items():
        if role not in points or upper not in kept or has_no_length(points[role], kept[upper]):
            continue
        if np.isfinite(points[role][seen]).all():
            kept[role] = points[role]
    return kept


def seen_runs(points: Mapping[str, np.ndarray], name: str) -> list[tuple[int, int]]:
    """List the stretches in which every joint is seen, long enough to be filtered; refuse where there is none."""
    seen = np.isfinite(np.stack(list(points.values()), axis=1)).all(axis=(1, 2))
    borders = np.flatnonzero(np.diff(np.concatenate(([False], seen, [False]))))
    runs = [(start, stop) for start, stop in borders.reshape(-1, 2).tolist() if stop - start >= SHORTEST]
    if len(seen) < SHORTEST:
        raise DataError(
            f"Dynamics needs {SHORTEST} frames in a row, {name or 'the recording'} has {len(seen)}.",
            remedy="Give a longer recording, or a longer window of it.",
        )
    if not runs:
        raise DataError(
            f"Dynamics needs {SHORTEST} frames in a row in which every joint is seen, "
            f"{name or 'the recording'} has none.",
            remedy="Fill the gaps first: leitmotion repair.",
        )
    return runs


def _check_metres(unit: str, dimensions: int) -> None:
    if unit != "m" or dimensions != 3:
        raise DataError(
            f"Dynamics needs metres in three dimensions, the recording has {dimensions} in {unit}."
        )
