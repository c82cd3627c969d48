"""What a recording holds, how each of its facts is known, and what is wrong with it.

Conventions
-----------
A fact is a :class:`~leitmotion.io.Finding`: its value, whether it was read from the file, guessed or given, and why.
A problem is told, never repaired.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from leitmotion.body import ANALYSIS_ROLES, Body, BodyMap, check_sides, embody, find_roles, map_from
from leitmotion.io import Finding, Reading, open_recording
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories

Recording = Motion | Trajectories

BODY_SIZES_M = (0.5, 2.5)  # a child of one year to the tallest adult, along the chain that Body.size measures
FASTEST_POINT_MPS = 40.0  # no hand or foot is faster; a pitcher's hand comes near
FASTEST_BODY_MPS = 13.0  # nor is a whole body: the fastest sprint ever measured is 12.4
MISREAD = ("size", "up")  # problems that tell of a unit or a vertical taken wrongly
SHORT_S = 1.0  # less holds no movement and its return
UNSURE = 0.6  # roles less sure than this are named


class Problem(NamedTuple):
    """One thing that is wrong with a recording, or that should be known about it.

    Attributes
    ----------
    what : str
        Its kind, in one word.
    message : str
        What it is, with its numbers.
    remedy : str
        What the person can do; empty where there is nothing.
    """

    what: str
    message: str
    remedy: str = ""


@dataclass(frozen=True)
class Info:
    """What a recording holds.

    Parameters
    ----------
    name : str
        What the recording is called.
    kind : {"skeleton", "points"}
        Whether it moves joints of a skeleton or points without one.
    names : tuple of str
        Its joints or points.
    frames : int
        How long it is.
    rate : float
        Frames per second.
    people : tuple of str
        Everyone in the file; the rest describes the one that was asked for, else the first.
    roles : BodyMap
        Which joints or markers stand for which role, with the confidence of each.
    findings : dict of str to Finding
        "unit", "up", "rate", "facing", "size", where it can be told "handedness", and what else the reader knows, each
        with its reason.
    problems : tuple of Problem
        What is wrong, worst first; empty when nothing is.
    dimensions : int
        2 for points in a picture, else 3.
    unseen : float
        Share of positions that are missing, 0 to 1.
    window : tuple of int, optional
        Frames of the file that this describes, None for all.
    warnings : tuple of str
        What the reader found odd about the file.
    """

    name: str
    kind: str
    names: tuple[str, ...]
    frames: int
    rate: float
    people: tuple[str, ...]
    roles: BodyMap
    findings: dict[str, Finding]
    problems: tuple[Problem, ...]
    dimensions: int = 3
    unseen: float = 0.0
    window: tuple[int, int] | None = None
    warnings: tuple[str, ...] = ()

    @property
    def duration(self) -> float:
        """Length in seconds."""
        return self.frames / self.rate

    @property
    def misread(self) -> tuple[str, ...]:
        """What tells of a unit or a vertical taken wrongly, so that all that is found then is in doubt."""
        return tuple(
            f"{problem.message} {problem.remedy}".rstrip()
            for problem in self.problems
            if problem.what in MISREAD
        )


def info(
    source: str | Path | Recording,
    *,
    skeleton: str | Path | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    rate: float | None = None,
    person: str | int | None = None,
    trust: bool = False,
    body_map: BodyMap | Mapping[str, str | list[str]] | None = None,
) -> Info:
    """Tell what a recording holds, how each fact is known, and what is wrong with it.

    Parameters
    ----------
    source : path, text or recording
        A file, a file with a window (``"dance.bvh[12s:45s]"``), or a recording that is already read.
    skeleton, unit, up, rate, person, trust
        As for :func:`leitmotion.read`; they count for files only.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell.

    Returns
    -------
    Info
        The facts and the problems; of a file with several people about the first of them.

    Raises
    ------
    FormatError
        When the file is not what its format says.
    DataError
        When the person or the window is not in the file.
    ParameterError
        When the source is neither a file nor a recording, or an option is none of those that exist.

    Examples
    --------
    >>> import leitmotion as lm
    >>> told = lm.info(lm.compose_session(seed=0, rate=30.0).motion)
    >>> told.kind, told.findings["size"].how, told.problems
    ('skeleton', 'guessed', ())
    """
    if isinstance(source, Motion | Trajectories):
        return _describe(source, Reading((source,), {}, (), Path(source.name)), body_map)
    if not isinstance(source, str | Path):
        raise ParameterError(f"A file or a recording was expected, got {type(source).__name__}.")
    reading = open_recording(
        source, skeleton=skeleton, unit=unit, up=up, rate=rate, person=person, trust=trust
    )
    return _describe(reading.recordings[0], reading, body_map)


def _describe(
    recording: Recording, reading: Reading, body_map: BodyMap | Mapping[str, str | list[str]] | None
) -> Info:
    if body_map is None:
        body_map = find_roles(recording)
    elif not isinstance(body_map, BodyMap):
        body_map = map_from(body_map, recording)
    body, unsized = _embodied(recording, body_map)
    points = recording if isinstance(recording, Trajectories) else None
    not_from_file = "the recording was not read from a file here"
    findings = {
        "unit": Finding(body.unit, "given", not_from_file),
        "up": Finding("y", "given", not_from_file),
        "rate": Finding(recording.rate, "given", not_from_file),
        **reading.findings,
        **_handedness(recording, body_map),
        "facing": _facing(body),
        "size": Finding(
            None if unsized else body.size, "guessed", unsized or _HOW_SIZED[bool(body_map.roles)]
        ),
    }
    checks = [Problem("size", unsized) if unsized else None]
    checks += [check(recording, body, body_map) for check in _CHECKS]
    alone = len(reading.recordings) == 1
    return Info(
        name=recording.name,
        kind="skeleton" if isinstance(recording, Motion) else "points",
        names=recording.skeleton.names if isinstance(recording, Motion) else recording.names,
        frames=len(recording),
        rate=recording.rate,
        people=(recording.name,)
        if alone
        else tuple(who or f"{k}" for k, who in enumerate(reading.people, 1)),
        roles=body_map,
        findings=findings,
        problems=tuple(problem for problem in checks if problem is not None),
        dimensions=body.positions.shape[2],
        unseen=0.0 if points is None else float(np.isnan(points.positions).any(axis=2).mean()),
        window=reading.window,
        warnings=reading.warnings,
    )


def _embodied(recording: Recording, body_map: BodyMap) -> tuple[Body, str]:
    """Make a body; of the bare points, with the reason, where its size cannot be told."""
    try:
        return embody(recording, body_map), ""
    except DataError as error:
        if not isinstance(recording, Trajectories) or not len(recording):
            raise
        facing, unit = np.zeros(len(recording)), recording.unit
        points = Body(
            recording.names, recording.positions, facing, recording.rate, 1.0, unit, facing_told=False
        )
        return points, error.message


def _handedness(recording: Recording, roles: BodyMap) -> dict[str, Finding]:
    """Say "right" where left is left, "left" where sides or axes are the wrong way round, else nothing."""
    sides = check_sides(recording, roles)
    hand = {"agree": "right", "swapped": "left"}.get(sides.verdict)
    reason = f"with the sides as they are called {sides.reason}"
    return {"handedness": Finding(hand, "guessed", reason)} if hand else {}


def _facing(body: Body) -> Finding:
    if not body.facing_told:
        flat = body.positions.shape[2] == 2
        needed = "a left and a right hip or shoulder must be named and seen"
        why = "points in a picture have none" if flat else needed
        return Finding(None, "guessed", f"cannot be told: {why}")
    turned = np.degrees(np.ptp(body.facing))
    return Finding(
        float(body.facing[0]),
        "guessed",
        f"from the hips and shoulders, at the first frame, about the vertical; {_turning(turned)}",
    )


def _positions(recording: Recording, body: Body) -> np.ndarray:
    """Positions to look for faults in: every point of a file of points, the roles of a skeleton."""
    return recording.positions if isinstance(recording, Trajectories) else body.positions


def _long_enough(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    if recording.duration >= SHORT_S:
        return None
    return Problem(
        "short", f"It lasts {recording.duration:.2f} s, too short for anything to come back in it."
    )


def _named(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    missing = [role for role in ANALYSIS_ROLES if role not in roles.roles]
    if not missing:
        return None
    what = (
        "No role could be told" if not roles.roles else f"No joint or marker was found for {_listed(missing)}"
    )
    return Problem("roles", f"{what}.", "Name them in a map file: --map roles.json.")


def _sure(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    unsure = [role for role, sure in zip(roles.roles, roles.confidence, strict=True) if sure < UNSURE]
    if not unsure:
        return None
    return Problem(
        "unsure",
        f"Uncertain which joint or marker is {_listed(unsure)}.",
        "Check the roles; --map settles them.",
    )


def _sided(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    sides = check_sides(recording, roles)
    if sides.crossed:
        return Problem(
            "sides", f"Some sides are swapped: {sides.reason}.", "Name the joints: --map roles.json."
        )
    if sides.verdict != "swapped":
        return None
    return Problem(
        "sides",
        f"Left and right look swapped, or the axes are left-handed: with the sides as called {sides.reason}.",
        "If they are, a map file that exchanges them settles it: --map roles.json.",
    )


def _sized(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    smallest, largest = BODY_SIZES_M
    known = set(ANALYSIS_ROLES) <= set(roles.roles)
    if body.unit != "m" or not known or smallest <= body.size <= largest:
        return None
    return Problem(
        "size",
        f"The body measures {body.size:.3g} m from ankles to head; people measure {smallest} to {largest} m.",
        "Say what unit the file is in: --unit cm, mm, inch.",
    )


def _upright(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    if not {"head", "left_ankle", "right_ankle"} <= set(body.roles):
        return None
    head, left, right = (
        body.positions[..., body.roles.index(r), 1] for r in ("head", "left_ankle", "right_ankle")
    )
    seen = np.isfinite(head + left + right)
    low = float(np.mean(head[seen] < (left + right)[seen] / 2 + 0.2 * body.size)) if seen.any() else 0.0
    if low < 0.5:
        return None
    return Problem(
        "up",
        f"The head is not above the feet in {low:.0%} of the frames: the person lies down, or another axis is up.",
        "If the person stands, say with --up which axis is up.",
    )


def _unseen(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    if isinstance(recording, Motion):
        return None
    gone = np.isnan(recording.positions).any(axis=2)
    if not gone.any():
        return None
    never = [name for name, all_gone in zip(recording.names, gone.all(axis=0), strict=True) if all_gone]
    gaps = gone[:, ~gone.all(axis=0)]
    parts = [f"{_listed(never)} {'is' if len(never) == 1 else 'are'} never seen"] if never else []
    if gaps.any():
        lengths = [_longest_run(gaps[:, point]) for point in range(gaps.shape[1])]
        worst = np.flatnonzero(~gone.all(axis=0))[int(np.argmax(lengths))]
        parts.append(
            f"{np.count_nonzero(lengths)} of {gone.shape[1]} points have gaps, the longest {max(lengths)} frames "
            f"({max(lengths) / recording.rate:.2f} s, {recording.names[worst]})"
        )
    return Problem("gaps", "; ".join(parts) + ".")


def _held(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    positions = _positions(recording, body)
    if len(positions) < 2:
        return None
    flat = positions.reshape(len(positions), -1)
    same = ((flat[1:] == flat[:-1]) | (np.isnan(flat[1:]) & np.isnan(flat[:-1]))).all(axis=1)
    same &= np.isfinite(flat[1:]).any(axis=1)
    count = int(same.sum())
    if not count:
        return None
    longest = _longest_run(same)
    return Problem(
        "duplicates",
        f"{count} of {len(positions)} frames repeat the one before exactly; "
        f"the longest such hold is {longest} frames ({longest / recording.rate:.2f} s).",
    )


def _jumps(recording: Recording, body: Body, roles: BodyMap) -> Problem | None:
    positions = _positions(recording, body)
    if body.unit != "m" or len(positions) < 2:
        return None
    speeds = np.linalg.norm(np.diff(positions, axis=0), axis=2) * recording.rate
    seen = np.isfinite(speeds)
    whole = np.where(seen, speeds, 0.0).sum(axis=1) / np.maximum(seen.sum(axis=1), 1)
    wild = (whole > FASTEST_BODY_MPS) | (np.where(seen, speeds, 0.0) > FASTEST_POINT_MPS).any(axis=1)
    if not wild.any():
        return None
    first, count = int(np.argmax(wild)), int(wild.sum())
    if count == 1 and first == 0:
        return Problem(
            "jumps",
            "The first frame is nowhere near the second, as in files that begin with a rest pose.",
            "Take a window that leaves it out: [1:].",
        )
    times = f"{count} times, first" if count > 1 else "once,"
    where = f"after frame {first} ({first / recording.rate:.2f} s)"
    return Problem("jumps", f"Points move faster than a person can {times} {where}.")


def _longest_run(flags: np.ndarray) -> int:
    """Length of the longest run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], flags.astype(np.int8), [0]))))
    return int((edges[1::2] - edges[::2]).max()) if edges.size else 0


def _listed(names: list[str]) -> str:
    shown = names if len(names) <= 6 else [*names[:5], f"{len(names) - 5} more"]
    return ", ".join(shown[:-1]) + f" and {shown[-1]}" if len(shown) > 1 else shown[0]


_HOW_SIZED = {
    True: "ankle to knee to hip plus pelvis to neck to head; a missing part in proportion to the others",
    False: "from the height of all points, as no role is known",
}

_Check = Callable[[Recording, Body, BodyMap], Problem | None]
_CHECKS: tuple[_Check, ...] = (_sized, _upright, _sided, _named, _sure, _jumps, _unseen, _held, _long_enough)


def _turning(degrees: float) -> str:
    """Say how far a body turns in all."""
    if degrees < 360:
        return f"turning within {degrees:.0f} degrees"
    return f"turning round {degrees / 360:.1f} times"
