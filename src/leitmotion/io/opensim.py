"""OpenSim MOT and STO: a column a quantity, of which joint angles and points are read.

A header that ends in the line ``endheader`` and may say whether angles are degrees (``inDegrees``), a line of names, a
row a time. Tabs, blanks or commas divide. Lengths are metres and Y is up, X forward. The names tell what it is: joint
angles move a body of mean proportions (:mod:`leitmotion.io.opensim_body`); ``NAME_X``, ``NAME_tx`` and ``NAME_px`` are
places of points; forces, speeds and activations are no motion.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

import numpy as np

from leitmotion.io.numerals import read_rows, widest_row
from leitmotion.io.opensim_body import STATURE, moves_a_body, pose_body
from leitmotion.io.points import distinct, split_people, unseen_in_origin
from leitmotion.io.reading import Draft, Finding, SkeletonTake, Source
from leitmotion.io.timing import read_times

_PLACE = re.compile(r"^(?P<name>.+?)[_.](?:t|p|trans)?(?P<axis>[xyz])$", re.IGNORECASE)
_TURN = re.compile(r"_O[xyz]$", re.IGNORECASE)
_STATE = re.compile(r"^/?(?:.*/)?([^/]+)/value$")
_ANGLE = re.compile(
    r"^(?:pelvis_(?:tilt|list|rotation)|(?:hip|knee|ankle|subtalar|mtp|lumbar|arm|elbow)_\w+)$"
)
_FORCE = re.compile(r"force|torque|moment|grf|_v[xyz]$|_m[xyz]$|(?:^|_)cop(?:_|$)", re.IGNORECASE)
_MOVING = re.compile(r"velocit|accelerat|speed", re.IGNORECASE)
_COMPUTED = ("center_of_mass", "centre_of_mass")


@dataclass(frozen=True)
class _Table:
    """A MOT or STO."""

    facts: dict[str, str]
    title: str
    names: list[str]
    values: np.ndarray
    start: int

    def column(self, name: str) -> np.ndarray:
        values: np.ndarray = self.values[:, self.names.index(name)]
        return values


def looks(head: bytes) -> bool:
    """Whether a file that begins like this is one."""
    return re.search(rb"^endheader[\t ,]*\r?$", head, re.IGNORECASE | re.MULTILINE) is not None


def read(source: Source) -> Draft:
    """Read the joint angles or the points of a MOT or STO.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        A skeleton where the angles are those of a body; else the points.

    Raises
    ------
    FormatError
        When it holds neither, or is not what the format says; it names the line.
    """
    warnings: list[str] = []
    table = _table(source, warnings)
    coordinates = _coordinates(table)
    if moves_a_body(coordinates):
        return _read_angles(source, table, coordinates, warnings)
    places = _places(table)
    if places:
        return _read_points(source, table, places, warnings)
    raise _refusal(source, table)


def _table(source: Source, warnings: list[str]) -> _Table:
    found = re.search(rb"^endheader[^\n]*(?:\n|\Z)", source.content, re.IGNORECASE | re.MULTILINE)
    if found is None:
        raise source.error("expected a header that ends in the line endheader, found none.")
    lines = source.content[: found.start()].decode("utf-8", "replace").lstrip("\ufeff").splitlines()
    lines = [line.strip(" \t,\r") for line in lines]
    facts = {}
    for line in lines:
        key, mark, value = line.partition("=")
        if mark:
            facts[key.strip().lower()] = value.strip()
    start = found.end()
    while source.content[start : start + 1] in (b"\n", b"\r"):
        start += 1
    stop = source.content.find(b"\n", start)
    if stop < 0:
        raise source.error("expected a line of names and a row a time after endheader, found the end.")
    line = source.content[start:stop].decode("utf-8", "replace").rstrip("\r")
    delimiter = "," if "," in line else "\t" if "\t" in line else " "
    names = [
        name.strip() for name in (line.split() if delimiter == " " else line.rstrip("\t, ").split(delimiter))
    ]
    kind = facts.get("datatype", "double").lower()
    if kind == "vec3":  # cells x,y,z
        names = names[:1] + [f"{name}_{axis}" for name in names[1:] for axis in "XYZ"]
        cells = re.sub(rb"[()~\[\]]", b"", source.content[stop:]).replace(b",", b"\t")
        source = replace(source, content=source.content[:stop] + cells)
    elif kind != "double":
        raise source.error(
            f"expected numbers, found a table of the type {facts['datatype']}.", remedy=_REMEDY
        )
    columns = max(len(names), widest_row(source.content[stop + 1 :], delimiter))
    rows = read_rows(
        source, stop + 1, columns, delimiter=delimiter, missing=True, wanted=range(len(names))
    )  # fmt: skip
    rows.tell_cut(source, warnings)
    count = len(rows.values)
    if count == 0:
        raise source.error("expected a row a time after the names, found none.")
    promised = facts.get("nrows", facts.get("datarows", ""))
    if promised.isdecimal() and int(promised) != count:
        warnings.append(f"The header promises {promised} rows, the file has {count}; those it has were read.")
    return _Table(facts, lines[0] if lines else "", names, rows.values, stop + 1)


_REMEDY = "Read the motion itself: the result of inverse kinematics (.mot), or the markers as TRC."


def _coordinates(table: _Table) -> dict[str, np.ndarray]:
    """Columns by the name of their coordinate, without its path."""
    found: dict[str, np.ndarray] = {}
    for name in table.names:
        match = _STATE.match(name)
        bare = match[1] if match else name
        if "/" not in bare:
            found.setdefault(bare, table.column(name))
    return found


def _unit_of_angles(table: _Table, coordinates: dict[str, np.ndarray], warnings: list[str]) -> Finding:
    """What the header says, else radians in a file of states and where no angle goes beyond a full turn of these."""
    stated = table.facts.get("indegrees", "")
    if stated[:1].lower() in ("y", "n"):
        unit = "degrees" if stated[0].lower() == "y" else "radians"
        return Finding(unit, "read", f"inDegrees is {stated!r}")
    largest = max(
        float(np.fmax.reduce(np.abs(values), initial=0.0))
        for name, values in coordinates.items()
        if _ANGLE.match(name)
    )
    if any(_STATE.match(name) for name in table.names):
        found = Finding("radians", "guessed", "those of a file of states are")
    elif largest <= 2.0 * np.pi:
        found = Finding("radians", "guessed", f"no angle is larger than {largest:.3g}")
    else:
        found = Finding("degrees", "guessed", f"angles are as large as {largest:.3g}")
    warnings.append(
        f"The header does not say whether angles are degrees: {found.value} were guessed, since {found.reason}; "
        "a line inDegrees=yes or inDegrees=no before endheader states it."
    )
    return found


def _read_angles(
    source: Source, table: _Table, coordinates: dict[str, np.ndarray], warnings: list[str]
) -> Draft:
    unit = _unit_of_angles(table, coordinates, warnings)
    if unit.value == "degrees":
        coordinates = {
            name: np.radians(values) if _ANGLE.match(name) else values for name, values in coordinates.items()
        }
    take, used = pose_body(coordinates)
    time = next((name for name in table.names if name.lower() == "time"), None)
    for name in sorted(used):
        holes = np.flatnonzero(~np.isfinite(coordinates[name]))
        if holes.size:
            raise source.error(
                f"expected a number as {name} in each row, found none in row {int(holes[0]) + 1} "
                f"({holes.size} of {len(table.values)} are missing).",
                remedy="Fill them in OpenSim, or read the markers (TRC).",
            )
    warnings.append(
        "The file holds joint angles without lengths: the bones of an adult of mean proportions, "
        f"{STATURE:.2f} m tall, stand in, so that the floor may lie above or below zero."
    )
    unused = [
        name for name in coordinates if name not in used and name != time and not name.endswith("_beta")
    ]
    if unused:
        warnings.append(f"Columns that turn none of the joints read were left out: {_few(unused)}.")
    if not {"pelvis_tx", "pelvis_ty", "pelvis_tz"} <= used:
        warnings.append("The file does not say where the pelvis is: it stays in one place.")
    timing = read_times(source, table.column(time), "time", warnings) if time else None
    if timing is None:
        raise source.error("expected a column time, found none.")
    return Draft(
        [_at_frames(take, timing.rows, warnings)],
        rate=timing.rate,
        unit=Finding("m", "read", "OpenSim's unit is the metre"),
        up=Finding("y", "read", "OpenSim's vertical is Y"),
        findings={
            "bones": Finding(
                f"{STATURE} m", "guessed", "joint angles have no lengths; a mean adult's stand in"
            ),
            "angles": unit,
        },
        warnings=warnings,
    )


def _at_frames(take: SkeletonTake, rows: np.ndarray | None, warnings: list[str]) -> SkeletonTake:
    """The body at each frame; in a gap of the times it keeps the pose before."""
    if rows is None:
        return take
    held = np.maximum.accumulate(np.where(rows < 0, 0, np.arange(len(rows))))
    if (rows < 0).any():
        warnings.append("In these frames the body keeps the pose before.")
    chosen = rows[held]
    return replace(take, positions=take.positions[chosen], rotations=take.rotations[chosen])


def _places(table: _Table) -> dict[str, list[str]]:
    """The three columns of each point, where the file is one of points."""
    if _MOVING.search(table.title) or any(_FORCE.search(name) for name in table.names):
        return {}
    found: dict[str, dict[str, str]] = {}
    turns = 0
    for name in table.names:
        match = _PLACE.match(name)
        turns += _TURN.search(name) is not None
        if match:
            found.setdefault(match["name"], {})[match["axis"].lower()] = name
    places = {name: [axes[k] for k in "xyz"] for name, axes in found.items() if len(axes) == 3}
    others = len(table.names) - 1 - 3 * len(places) - turns
    return places if others == 0 or (len(places) > 1 and 3 * len(places) > others) else {}


def _read_points(source: Source, table: _Table, places: dict[str, list[str]], warnings: list[str]) -> Draft:
    computed = [name for name in places if name.lower() in _COMPUTED and len(places) > 1]
    if computed:
        warnings.append(f"What a model computed was left out: {', '.join(computed)}.")
    names = [name for name in places if name not in computed]
    positions = np.stack([np.stack([table.column(k) for k in places[name]], -1) for name in names], axis=1)
    positions[~np.isfinite(positions).all(axis=-1)] = np.nan
    unseen_in_origin(positions, warnings)
    time = next((name for name in table.names if name.lower() == "time"), None)
    if time is None:
        raise source.error("expected a column time, found none.")
    timing = read_times(source, table.column(time), "time", warnings)
    stated = table.facts.get("units", "").lower()
    unit = Finding(stated, "read", f"Units is {stated!r}") if stated in ("mm", "cm", "m") else None
    return Draft(
        split_people(distinct(names, warnings), timing.place(positions)),
        rate=timing.rate,
        unit=unit or Finding("m", "guessed", "OpenSim's unit is the metre"),
        up=Finding("y", "read", "OpenSim's vertical is Y"),
        warnings=warnings,
    )


def _refusal(source: Source, table: _Table) -> Exception:
    names = [name for name in table.names if name.lower() != "time"]
    what, remedy = "other columns", _REMEDY
    if any(_FORCE.search(name) for name in names):
        what = "forces"
    elif _MOVING.search(table.title):
        what = "speeds or accelerations"
    elif any(name.endswith("activation") for name in names):
        what = "activations of muscles"
    elif "indegrees" in table.facts:
        what, remedy = "other coordinates", "Only whole bodies are known here: save its markers as TRC."
    return source.error(
        "expected the joint angles of a body (pelvis_tilt, hip_flexion_r, knee_angle_r …) or points "
        f"(NAME_X, NAME_Y, NAME_Z), found {what}: {_few(names)}.",
        remedy=remedy,
    )


def _few(names: list[str]) -> str:
    return f"{', '.join(names[:6])}{f' … ({len(names)} in all)' if len(names) > 6 else ''}"
