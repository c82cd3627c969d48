"""What a recording holds, how each of its facts is known, and what is wrong with it.

Conventions
-----------
A fact is a :class:`~leitmotion.io.Finding`: its value, whether it was read from the file, guessed or given, and why.
A problem is told, never repaired.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from leitmotion.body import Body, BodyMap, SideCheck, check_sides, embody, map_of
from leitmotion.body import swap_sides as exchanged
from leitmotion.io import Finding, Reading, open_recording
from leitmotion.io.units import METRES
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, joint_points
from leitmotion.repairs import Examined, Problem, find_problems
from leitmotion.repairs.person import sized, upright

Recording = Motion | Trajectories

MISREAD = ("size", "up")  # problems that tell of a unit or a vertical taken wrongly


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
        "format", "unit", "up", "rate", "facing", "size", where it can be told "handedness", and what else the reader
        knows, each with its reason.
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
        return _sentences(self.problems)


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
    swap_sides: bool = False,
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
    swap_sides : bool
        Whether what is called left is the person's right: the roles of the two sides are exchanged, the recording
        is left as it is.

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
        return _describe(source, Reading((source,), {}, (), Path(source.name)), body_map, swap_sides)
    if not isinstance(source, str | Path):
        raise ParameterError(f"A file or a recording was expected, got {type(source).__name__}.")
    reading = open_recording(
        source, skeleton=skeleton, unit=unit, up=up, rate=rate, person=person, trust=trust
    )
    return _describe(reading.recordings[0], reading, body_map, swap_sides)


def _describe(
    recording: Recording,
    reading: Reading,
    body_map: BodyMap | Mapping[str, str | list[str]] | None,
    swap_sides: bool,
) -> Info:
    body_map = map_of(recording, body_map)
    if swap_sides:
        body_map = exchanged(body_map)
    body, unsized = _embodied(recording, body_map)
    sides = check_sides(recording, body_map)
    points = recording if isinstance(recording, Trajectories) else None
    not_from_file = "the recording was not read from a file here"
    findings = {
        **_format(reading),
        "unit": Finding(body.unit, "given", not_from_file),
        "up": Finding("y", "given", not_from_file),
        "rate": Finding(recording.rate, "given", not_from_file),
        **reading.findings,
        **_handedness(sides),
        "facing": _facing(body),
        "size": Finding(
            None if unsized else body.size, "guessed", unsized or _HOW_SIZED[bool(body_map.roles)]
        ),
    }
    problems = find_problems(_examined(recording, body, body_map, findings))
    if unsized:
        problems = (Problem("size", unsized), *problems)
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
        problems=problems,
        dimensions=body.positions.shape[2],
        unseen=0.0 if points is None else float(np.isnan(points.positions).any(axis=2).mean()),
        window=reading.window,
        warnings=reading.warnings,
    )


def misread(
    recording: Recording,
    findings: Mapping[str, Finding],
    body_map: BodyMap | Mapping[str, str | list[str]] | None = None,
) -> tuple[str, ...]:
    """Tell as :attr:`Info.misread` does, without looking for anything else that may be wrong.

    Parameters
    ----------
    recording : Motion or Trajectories
        The recording.
    findings : mapping of str to Finding
        What its reader says of unit and vertical.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell.

    Returns
    -------
    tuple of str
        A sentence each; of what is no body none.
    """
    try:
        roles = map_of(recording, body_map)
        body, unsized = _embodied(recording, roles)
    except DataError:
        return ()
    examined = _examined(recording, body, roles, findings)
    found = (Problem("size", unsized) if unsized else None, sized(examined), upright(examined))
    return _sentences([problem for problem in found if problem is not None])


def _sentences(problems: Sequence[Problem]) -> tuple[str, ...]:
    return tuple(
        f"{problem.message} {problem.remedy}".rstrip() for problem in problems if problem.what in MISREAD
    )


def _examined(recording: Recording, body: Body, roles: BodyMap, findings: Mapping[str, Finding]) -> Examined:
    """What the checks look at; what was not read from a file is in its own unit, and Y is up."""
    unit, up = (findings[what].value if what in findings else None for what in ("unit", "up"))
    return Examined(recording, body, roles, _metres(body.unit if unit is None else unit), str(up or "y"))


def _embodied(recording: Recording, body_map: BodyMap) -> tuple[Body, str]:
    """Make a body; of the bare points, with the reason, where its size cannot be told."""
    try:
        return embody(recording, body_map), ""
    except DataError as error:
        if not len(recording):
            raise
        points = joint_points(recording) if isinstance(recording, Motion) else recording
        facing = np.zeros(len(points))
        bare = Body(points.names, points.positions, facing, points.rate, 1.0, points.unit, facing_told=False)
        return bare, error.message


def _format(reading: Reading) -> dict[str, Finding]:
    if not reading.format:
        return {}
    return {"format": Finding(reading.format, "read", "how the file's name ends, or how it begins")}


def _metres(unit: object) -> float | None:
    """The length of the unit that a file was taken to be in."""
    if isinstance(unit, str):
        number = unit.removesuffix(" m")
        return METRES.get(unit, float(number) if number.replace(".", "", 1).isdigit() else None)
    return None


def _handedness(sides: SideCheck) -> dict[str, Finding]:
    """Say "right" where left is left, "left" where sides or axes are the wrong way round, else nothing."""
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


_HOW_SIZED = {
    True: "ankle to knee to hip plus pelvis to neck to head; a missing part in proportion to the others",
    False: "from the height of all points, as no role is known",
}


def _turning(degrees: float) -> str:
    """Say how far a body turns in all."""
    if degrees < 360:
        return f"turning within {degrees:.0f} degrees"
    return f"turning round {degrees / 360:.1f} times"
