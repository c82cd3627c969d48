"""ASF: the skeleton of an Acclaim recording.

Conventions
-----------
A bone points from its joint (the *proximal* end) along `direction` for `length`; directions are in the world's axes at
rest. Its `axis` turns the world's axes to the bone's own, by rotations about fixed axes in the order given. The bone
moves by ``C M C^-1``, M being its degrees of freedom in their order, again about fixed axes, so that all joint frames
are parallel to the world's at rest.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from heapq import heappop, heappush
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.io.reading import Source
from leitmotion.motion import rotations

ROOT = "root"
_DOFS = ("rx", "ry", "rz", "tx", "ty", "tz", "l")
_WORDS = 8  # of the longest name
_LARGEST = 1e12  # of a length or an angle


class Line(NamedTuple):
    """A line of an ASF without its comment: the byte at which it begins, and its words."""

    position: int
    words: list[str]


@dataclass(frozen=True)
class Bone:
    """A bone of an ASF."""

    name: str
    direction: np.ndarray
    length: float
    axis: np.ndarray
    dofs: tuple[str, ...]


@dataclass(frozen=True)
class Acclaim:
    """The skeleton of an ASF file: bones, parents first, the root being bone 0, lengths in the file's unit."""

    bones: tuple[Bone, ...]
    parents: tuple[int, ...]
    position: np.ndarray
    scale: float
    degrees: bool

    @property
    def names(self) -> list[str]:
        """Names of the bones, the root first."""
        return [bone.name for bone in self.bones]


def read_asf(source: Source) -> Acclaim:
    """Read an ASF file.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Acclaim
        Its skeleton.

    Raises
    ------
    FormatError
        When a section is missing or a bone is not what the format says.
    """
    sections = _sections(source)
    units = _units(sections.get("units", []))
    degrees = not units.get("angle", "deg").lower().startswith("rad")
    scale = _number(source, 0, units.get("length", "1"), "a unit of length")
    root, position = _root(source, sections["root"], degrees)
    bones = [root, *_bones(source, sections["bonedata"], degrees)]
    parents = _parents(source, sections["hierarchy"], [bone.name for bone in bones])
    order = _parents_first(source, bones, parents)
    place = {old: new for new, old in enumerate(order)}
    return Acclaim(
        tuple(bones[k] for k in order),
        tuple(-1 if parents[k] < 0 else place[parents[k]] for k in order),
        position,
        scale,
        degrees,
    )


def spellings(names: Iterable[str]) -> dict[str, str]:
    """Map every way to spell a name, as it is or in lower case, to the name; the former goes first."""
    names = list(names)
    return {name.lower(): name for name in reversed(names)} | {name: name for name in names}


def name_at_start(words: list[str], spelled: Mapping[str, str]) -> tuple[str, int] | None:
    """Tell which bone the words begin with; its name may hold blanks, and be written in another case.

    Parameters
    ----------
    words : list of str
        What a line is made of.
    spelled : mapping of str
        The bones by their :func:`spellings`.

    Returns
    -------
    tuple of str and int, or None
        The bone's name and of how many words it is; None where it is none of the bones.

    Examples
    --------
    >>> name_at_start(["LEFT", "foot", "1.5"], spellings(["left", "left foot"]))
    ('left foot', 2)
    """
    for count in range(min(len(words), _WORDS), 0, -1):
        told = " ".join(words[:count])
        name = spelled.get(told) or spelled.get(told.lower())
        if name is not None:
            return name, count
    return None


def _sections(source: Source) -> dict[str, list[Line]]:
    sections: dict[str, list[Line]] = {}
    current: list[Line] = []
    for position, line in source.lines():
        words = line.decode("utf-8", "replace").split("#", 1)[0].split()
        if words and words[0].startswith(":"):
            current = sections.setdefault(words[0][1:].lower(), [])
            del words[0]
        if words:
            current.append(Line(position, words))
    for name in ("root", "bonedata", "hierarchy"):
        if name not in sections:
            raise source.error(f"expected a section :{name} of an ASF skeleton, found none.")
    return sections


def _units(lines: list[Line]) -> dict[str, str]:
    words = [word for line in lines for word in line.words]
    return {key.lower(): value for key, value in pairwise(words) if key.lower() in ("length", "angle")}


def _root(source: Source, lines: list[Line], degrees: bool) -> tuple[Bone, np.ndarray]:
    told = {line.words[0].lower(): Line(line.position, line.words[1:]) for line in lines}
    order = told.get("order", Line(0, ["tx", "ty", "tz", "rx", "ry", "rz"]))
    axis = told.get("axis", Line(0, ["xyz"]))
    zeros = Line(0, ["0", "0", "0"])
    angles = _numbers(source, told.get("orientation", zeros), "root orientation")
    position = _numbers(source, told.get("position", zeros), "root position")
    letters = _letters(source, axis.position, " ".join(axis.words))
    turn = fixed_axes(letters, angles, degrees)
    return Bone(ROOT, np.zeros(3), 0.0, turn, _dofs(source, ROOT, order)), position


def _bones(source: Source, lines: list[Line], degrees: bool) -> list[Bone]:
    bones: dict[str, Bone] = {}
    entry: dict[str, Line] = {}
    for position, words in lines:
        key = words[0].lower()
        if key == "begin":
            entry = {}
        elif key == "end":
            bone = _bone(source, position, entry, degrees)
            if bone.name in bones or bone.name.lower() == ROOT:
                raise source.fault(position, "every bone once", f"{bone.name!r} again")
            bones[bone.name] = bone
        else:
            entry[key] = Line(position, words[1:])
    if not bones:
        raise source.error("expected bones between begin and end, found none.")
    return list(bones.values())


def _bone(source: Source, end: int, entry: dict[str, Line], degrees: bool) -> Bone:
    name = " ".join(entry["name"].words) if "name" in entry else ""
    for key in ("name", "direction", "length"):
        if key not in entry or not entry[key].words:
            raise source.fault(end, f"a {key} of bone {name or '?'} before its end", "none")
    direction = _numbers(source, entry["direction"], f"direction of {name}")
    norm = np.linalg.norm(direction)
    length = entry["length"]
    axis = entry.get("axis", Line(0, ["0", "0", "0"]))
    letters = _letters(source, axis.position, " ".join(axis.words[3:]) or "xyz")
    return Bone(
        name,
        direction / norm if norm > 0 else direction,
        _number(source, length.position, length.words[0], f"a length of {name}"),
        fixed_axes(letters, _numbers(source, axis, f"axis of {name}"), degrees),
        _dofs(source, name, entry.get("dof", Line(0, []))),
    )


def fixed_axes(order: str, angles: np.ndarray, degrees: bool) -> np.ndarray:
    """Quaternion of turns about the fixed axes, one after the other in the order of the letters.

    Parameters
    ----------
    order : str
        Letters x, y, z.
    angles : (..., len(order)) float
        One column a letter.
    degrees : bool
        Whether they are degrees.

    Returns
    -------
    (..., 4) float
        Unit quaternions.
    """
    angles = np.deg2rad(angles) if degrees else np.asarray(angles)
    return rotations.from_euler(order[::-1], angles[..., ::-1])


def _parents(source: Source, lines: list[Line], names: list[str]) -> list[int]:
    index, spelled = {name: k for k, name in enumerate(names)}, spellings(names)
    parents = [-1] * len(names)
    for position, words in lines:
        if words[0].lower() in ("begin", "end") and len(words) == 1:
            continue
        family = []
        while words:
            named = name_at_start(words, spelled)
            if named is None:
                raise source.fault(position, "bones of the section :bonedata", repr(words[0]))
            family.append(index[named[0]])
            words = words[named[1] :]
        for child in family[1:]:
            if child == 0:
                raise source.fault(position, "a root that hangs on no bone", " ".join(words) or ROOT)
            parents[child] = family[0]
    return parents


def _parents_first(source: Source, bones: list[Bone], parents: list[int]) -> list[int]:
    """Order of bones in which each stands after its parent, else as in the file."""
    children: list[list[int]] = [[] for _ in bones]
    for child, parent in enumerate(parents):
        if parent >= 0:
            children[parent].append(child)
    order, ready = [], [0]
    while ready:
        order.append(heappop(ready))
        for child in children[order[-1]]:
            heappush(ready, child)
    if len(order) < len(bones):
        loose = min(set(range(len(bones))) - set(order))
        raise source.error(f"expected every bone to hang on the root, bone {bones[loose].name!r} does not.")
    return order


def _dofs(source: Source, name: str, line: Line) -> tuple[str, ...]:
    dofs = tuple(word.lower() for word in line.words)
    for k, dof in enumerate(dofs):
        if dof not in _DOFS or dof in dofs[:k]:
            expected = f"degrees of freedom of bone {name}, each of {', '.join(_DOFS)} once"
            raise source.fault(line.position, expected, repr(" ".join(line.words)))
    return dofs


def _letters(source: Source, position: int, word: str) -> str:
    letters = word.lower()
    if sorted(letters) != ["x", "y", "z"]:
        raise source.fault(position, "an order of axes such as XYZ", repr(word))
    return letters


def _number(source: Source, position: int, word: str, what: str) -> float:
    try:
        value = float(word)
    except ValueError:
        value = np.nan
    if not abs(value) < _LARGEST:
        raise source.fault(position, f"{what} as a number below {_LARGEST:.0e}", repr(word))
    return value


def _numbers(source: Source, line: Line, what: str) -> np.ndarray:
    if len(line.words) < 3:
        raise source.fault(line.position, f"3 numbers for the {what}", str(len(line.words)))
    return np.array([_number(source, line.position, word, f"the {what}") for word in line.words[:3]])
