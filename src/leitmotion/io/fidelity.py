"""What a format does not keep of a recording: the file's bytes are read again and compared with what was to be written.

So nothing has to be promised by a format: what is told here is what a reader of the file misses.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from leitmotion.io.conform import IMAGE_UNITS, conform
from leitmotion.io.formats import recognise
from leitmotion.io.reading import Options, Source
from leitmotion.motion import (
    LeitmotionError,
    Motion,
    Trajectories,
    forward_kinematics,
    rotations,
)

NOTICED = {"m": 1e-5, "px": 1e-3, "relative": 1e-5}
"""By how much a position may differ without a word: a hundredth of a millimetre, finer than any system measures."""
NOTICED_ANGLE = 1e-5
"""By how much a rotation may differ without a word, radians."""
NOTICED_RATE = 1e-6
"""By how much a rate may differ without a word, relatively: a frame in a million."""
_SHOWN = 4  # names that a sentence lists


class Loss(NamedTuple):
    """One thing that is not in a written file as it was in the recording.

    Attributes
    ----------
    what : str
        "rotations", "end sites", "points", "names", "kind", "confidence", "gaps", "precision", "frames", "rate",
        "people", or "unread" of a format that is only written.
    joint : str
        The joint or point; empty where there are several.
    frames : int
        How many frames it concerns.
    detail : str
        What became of it, in a sentence.
    """

    what: str
    joint: str
    frames: int
    detail: str


def losses(
    recording: Motion | Trajectories, content: bytes, extension: str, *, unit: str | float | None = None
) -> tuple[Loss, ...]:
    """Read a file's bytes again, and tell what differs from the recording that was written.

    Parameters
    ----------
    recording : Motion or Trajectories
        What was written.
    content : bytes
        What a format made of it.
    extension : str
        What the file ends in.
    unit : str or float, optional
        The unit of length that was written, where the file does not state it.

    Returns
    -------
    tuple of Loss
        What the file does not hold, or holds otherwise.
    """
    form = recognise(content[:4096], extension)
    if form is None or not form.module:
        how = f"A {extension} is not read here, so that nothing is known of what it keeps."
        return (_loss("unread", recording, (), how),)
    source = Source(Path(f"recording{extension}"), content)
    changes = []
    try:
        draft = form.read(source)
    except LeitmotionError as error:  # a rate that a reader doubts has to be told it
        try:
            draft = form.read(replace(source, options=Options(rate=recording.rate)))
        except LeitmotionError as refusal:
            return (_loss("unread", recording, (), f"It is not read again: {refusal.message}"),)
        changes.append(_loss("rate", recording, (), f"Reading it again needs the rate. {error.remedy}"))
    stated = draft.unit is not None and draft.unit.how == "read"
    of_a_picture = isinstance(recording, Trajectories) and recording.unit in IMAGE_UNITS
    known = Options(
        unit=None if stated else recording.unit if of_a_picture else unit,  # type: ignore[union-attr]
        up=draft.up.value if draft.up is not None else "y",
        rate=recording.rate if changes or draft.rate.how != "read" else None,
    )
    again, _ = conform(draft, known, recording.name)
    if len(again) != 1:
        people = ", ".join(take.person for take in draft.takes)
        changes.append(_loss("people", recording, (), f"One person is read again as several: {people}."))
        return tuple(changes)
    return tuple(changes) + differences(recording, again[0])


def differences(before: Motion | Trajectories, after: Motion | Trajectories) -> tuple[Loss, ...]:
    """Tell what of one recording is not in another that was made from it.

    Parameters
    ----------
    before, after : Motion or Trajectories
        The recording, and what a format kept of it.

    Returns
    -------
    tuple of Loss
        Nothing where both hold the same.
    """
    if len(before) != len(after):
        return (_loss("frames", before, (), f"{len(before)} frames became {len(after)}."),)
    changes = []
    if abs(after.rate / before.rate - 1.0) > NOTICED_RATE:
        changes.append(_loss("rate", before, (), f"{before.rate:.9g} Hz became {after.rate:.9g} Hz."))
    if isinstance(before, Motion):
        changes += _of_a_skeleton(before, after)
    elif isinstance(after, Trajectories):
        changes += _of_points(before, after)
    pairs, renamed = _pairs(before, after, changes)
    changes += renamed
    changes += _of_places(before, after, pairs)
    return tuple(changes)


def _of_a_skeleton(before: Motion, after: Motion | Trajectories) -> list[Loss]:
    count, ends = len(before.skeleton), len(before.skeleton.end_parents)
    if isinstance(after, Motion):
        kept = len(after.skeleton.end_parents)
        if kept == ends:
            return []
        how = f"{ends} end sites became {kept}."
        return [_loss("end sites", before, (), how)]
    changes = [
        _loss(
            "rotations",
            before,
            (),
            f"A skeleton of {count} joints became points: its rotations are not kept.",
        )
    ]
    if ends and len(after.names) <= count:
        changes.append(_loss("end sites", before, (), f"{ends} end sites are not kept."))
    return changes


def _of_points(before: Trajectories, after: Trajectories) -> list[Loss]:
    changes = []
    if before.kind != after.kind:
        changes.append(_loss("kind", before, (), f"Points of kind {before.kind} became {after.kind}s."))
    if before.confidence is not None and after.confidence is None:
        changes.append(_loss("confidence", before, (), "How sure each point was is not kept."))
    return changes


def _names(recording: Motion | Trajectories) -> tuple[str, ...]:
    return recording.skeleton.names if isinstance(recording, Motion) else recording.names


def _pairs(
    before: Motion | Trajectories, after: Motion | Trajectories, changes: Sequence[Loss]
) -> tuple[list[tuple[int, int]], list[Loss]]:
    """Which joint of one is which of the other, and what became of their names."""
    old, new = _names(before), _names(after)
    places = {name: k for k, name in enumerate(new)}
    lost = [name for name in old if name not in places]
    if lost and len(old) == len(new):
        renamed = [(a, b) for a, b in zip(old, new, strict=True) if a != b]
        how = f"{_listed([f'{a!r} became {b!r}' for a, b in renamed])}."
        return [(k, k) for k in range(len(old))], [_loss("names", before, [a for a, _ in renamed], how)]
    pairs = [(k, places[name]) for k, name in enumerate(old) if name in places]
    if not lost:
        return pairs, []
    return pairs, [_loss("points", before, lost, f"Not kept: {_listed(lost)}.")]


def _of_places(
    before: Motion | Trajectories, after: Motion | Trajectories, pairs: list[tuple[int, int]]
) -> list[Loss]:
    """What became of the places, and of the rotations where both have them."""
    if not pairs:
        return []
    here, there = (list(side) for side in zip(*pairs, strict=True))
    (a, turned), (b, turned_after) = _placed(before, here), _placed(after, there)
    if a.shape != b.shape:
        return [_loss("points", before, (), f"{a.shape[-1]} coordinates became {b.shape[-1]}.")]
    names = [_names(before)[k] for k in here]
    seen, seen_after = np.isfinite(a).all(axis=2), np.isfinite(b).all(axis=2)
    changes = []
    other = seen != seen_after
    if other.any():
        where = [names[k] for k in np.flatnonzero(other.any(axis=0))]
        how = f"{int(other.sum())} places are seen in one and not in the other."
        changes.append(Loss("gaps", _only(where), int(other.any(axis=1).sum()), how))
    both = (seen & seen_after)[..., None]
    apart = np.linalg.norm(np.subtract(a, b, out=np.zeros_like(a), where=both), axis=2)
    unit = before.unit if isinstance(before, Trajectories) else "m"
    changes += _beyond(names, apart, NOTICED[unit], unit)
    if turned is not None and turned_after is not None:
        angles = rotations.geodesic_angle(turned, turned_after)
        changes += _beyond(names, angles, NOTICED_ANGLE, "rad")
    return changes


def _placed(recording: Motion | Trajectories, chosen: list[int]) -> tuple[np.ndarray, np.ndarray | None]:
    """Where the chosen joints or points are, and how the joints are turned in the world."""
    if isinstance(recording, Trajectories):
        return recording.positions[:, chosen], None
    pose = forward_kinematics(recording)
    return pose.positions[:, chosen], pose.rotations[:, chosen]


def _beyond(names: list[str], apart: np.ndarray, noticed: float, unit: str) -> list[Loss]:
    far = apart > noticed
    if not far.any():
        return []
    where = [names[k] for k in np.flatnonzero(far.any(axis=0))]
    what = "rotations" if unit == "rad" else "places"
    how = f"The {what} differ by up to {apart.max():.2g} {unit}."
    return [Loss("precision", _only(where), int(far.any(axis=1).sum()), how)]


def _loss(what: str, recording: Motion | Trajectories, names: Sequence[str], detail: str) -> Loss:
    return Loss(what, _only(names), len(recording), detail)


def _only(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else ""


def _listed(names: Sequence[str]) -> str:
    more = [f"{len(names) - _SHOWN} more"] if len(names) > _SHOWN + 1 else []
    return ", ".join([*names[: _SHOWN if more else None], *more])
