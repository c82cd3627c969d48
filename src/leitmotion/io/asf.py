"""ASF: the skeleton of an Acclaim recording, and where to find the one that belongs to an AMC.

Conventions
-----------
A bone points from its joint (the *proximal* end) along `direction` for `length`; directions are in the world's axes at
rest. Its `axis` turns the world's axes to the bone's own, by rotations about fixed axes in the order given. The bone
moves by ``C M C^-1``, M being its degrees of freedom in their order, again about fixed axes, so that all joint frames
are parallel to the world's at rest.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from leitmotion.io.containers import bare, listing
from leitmotion.io.reading import Source
from leitmotion.motion import FormatError, rotations

ROOT = "root"
_DOFS = ("rx", "ry", "rz", "tx", "ty", "tz", "l")
_PARENTS = 3  # how many folders above the AMC are searched


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
    units = dict(_pairs(sections.get("units", [])))
    degrees = units.get("angle", "deg").lower().startswith("deg")
    scale = _number(source, units.get("length", "1"), "a length unit")
    root, position = _root(source, sections, degrees)
    bones = [root, *_bones(source, sections, degrees)]
    parents = _parents(source, sections, [bone.name for bone in bones])
    order = _parents_first(source, bones, parents)
    place = {old: new for new, old in enumerate(order)}
    return Acclaim(
        tuple(bones[k] for k in order),
        tuple(-1 if parents[k] < 0 else place[parents[k]] for k in order),
        position,
        scale,
        degrees,
    )


def find_asf(amc: Path) -> tuple[Path, str]:
    """Find the ASF that belongs to an AMC.

    In the AMC's folder, then in up to three folders above, the one whose name shares the longest leading tokens with
    the AMC's (``86_09`` → ``86``, ``HDM_mm_…`` → ``HDM_mm``); where none shares any, the only one there.

    Parameters
    ----------
    amc : Path
        The recording.

    Returns
    -------
    tuple of Path and str
        The skeleton, and why it is this one.

    Raises
    ------
    FormatError
        When there is none, or several and none fits; it lists them.
    """
    wanted = _tokens(amc)
    seen: list[Path] = []
    folder = amc.resolve().parent
    for _ in range(_PARENTS + 1):
        here = sorted(p for p in listing(folder) if bare(p).suffix.lower() == ".asf")
        scored = [(_shared(wanted, _tokens(path)), path) for path in here]
        best = max((score for score, _ in scored), default=0)
        if best > 0:
            nearest = next(path for score, path in scored if score == best)
            return nearest, "its name shares the longest beginning with the AMC's"
        seen += here
        if folder.parent == folder:
            break
        folder = folder.parent
    if len(seen) == 1:
        return seen[0], "it is the only ASF file in the AMC's folder and above"
    found = f"{len(seen)} of other names: {', '.join(p.name for p in seen[:8])}" if seen else "none"
    raise FormatError(
        f"{amc.name}: expected its skeleton, an ASF file that starts like it, in its folder or up to three above, "
        f"found {found}.",
        remedy="Name it with --skeleton FILE (skeleton= in Python).",
    )


def _tokens(path: Path) -> list[str]:
    return [token for token in re.split(r"[_\-\s.]+", bare(path).stem.lower()) if token]


def _shared(wanted: list[str], offered: list[str]) -> int:
    """Leading tokens in common, times two; minus one if the skeleton's name goes on otherwise."""
    count = 0
    for a, b in zip(wanted, offered):
        if a != b:
            break
        count += 1
    return 0 if count == 0 else 2 * count - (count < len(offered))


def _sections(source: Source) -> dict[str, list[list[str]]]:
    sections: dict[str, list[list[str]]] = {}
    current: list[list[str]] = []
    for line in source.content.decode("utf-8", "replace").splitlines():
        words = line.split("#", 1)[0].split()
        if not words:
            continue
        if words[0].startswith(":"):
            current = sections.setdefault(words[0][1:].lower(), [])
            if len(words) > 1:
                current.append(words[1:])
        else:
            current.append(words)
    for name in ("root", "bonedata", "hierarchy"):
        if name not in sections:
            raise source.error(f"expected a section :{name} of an ASF skeleton, found none.")
    return sections


def _pairs(lines: list[list[str]]) -> list[tuple[str, str]]:
    return [(words[0].lower(), words[1]) for words in lines if len(words) > 1]


def _root(source: Source, sections: dict[str, list[list[str]]], degrees: bool) -> tuple[Bone, np.ndarray]:
    lines = {words[0].lower(): words[1:] for words in sections["root"]}
    dofs = tuple(word.lower() for word in lines.get("order", ["tx", "ty", "tz", "rx", "ry", "rz"]))
    _check_dofs(source, ROOT, dofs)
    order = lines.get("axis", ["XYZ"])[0].lower()
    angles = _numbers(source, lines.get("orientation", ["0"] * 3), 3, "root orientation")
    position = _numbers(source, lines.get("position", ["0"] * 3), 3, "root position")
    return Bone(ROOT, np.zeros(3), 0.0, fixed_axes(order, angles, degrees), dofs), position


def _bones(source: Source, sections: dict[str, list[list[str]]], degrees: bool) -> list[Bone]:
    bones = []
    entry: dict[str, list[str]] = {}
    for words in sections["bonedata"]:
        key = words[0].lower()
        if key == "begin":
            entry = {}
        elif key == "end":
            bones.append(_bone(source, entry, degrees))
        else:
            entry[key] = words[1:]
    if not bones:
        raise source.error("expected bones between begin and end, found none.")
    return bones


def _bone(source: Source, entry: dict[str, list[str]], degrees: bool) -> Bone:
    name = " ".join(entry.get("name", []))
    for key in ("name", "direction", "length"):
        if not entry.get(key):
            raise source.error(f"expected a {key} of bone {name or '?'}, found none.")
    direction = _numbers(source, entry["direction"], 3, f"direction of {name}")
    norm = np.linalg.norm(direction)
    axis = entry.get("axis", ["0", "0", "0", "XYZ"])
    order = axis[3].lower() if len(axis) > 3 else "xyz"
    dofs = tuple(word.lower() for word in entry.get("dof", []))
    _check_dofs(source, name, dofs)
    return Bone(
        name,
        direction / norm if norm > 0 else direction,
        _number(source, entry["length"][0], f"a length of {name}"),
        fixed_axes(order, _numbers(source, axis[:3], 3, f"axis of {name}"), degrees),
        dofs,
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


def _parents(source: Source, sections: dict[str, list[list[str]]], names: list[str]) -> list[int]:
    index = {name: k for k, name in enumerate(names)}
    parents = [-1] * len(names)
    for words in sections["hierarchy"]:
        if words[0].lower() in ("begin", "end") and len(words) == 1:
            continue
        for name in words:
            if name not in index:
                raise source.error(f"expected bones of the section :bonedata in :hierarchy, found {name!r}.")
        for child in words[1:]:
            parents[index[child]] = index[words[0]]
    return parents


def _parents_first(source: Source, bones: list[Bone], parents: list[int]) -> list[int]:
    """Order of bones in which each stands after its parent, else as in the file."""
    order: list[int] = [0]
    waiting = list(range(1, len(bones)))
    while waiting:
        ready = [k for k in waiting if parents[k] in order]
        if not ready:
            raise source.error(
                f"expected every bone to hang on the root, bone {bones[waiting[0]].name!r} does not."
            )
        k = ready[0]
        order.append(k)
        waiting.remove(k)
    return order


def _check_dofs(source: Source, name: str, dofs: tuple[str, ...]) -> None:
    for dof in dofs:
        if dof not in _DOFS:
            raise source.error(
                f"expected degrees of freedom {', '.join(_DOFS)} of bone {name}, found {dof!r}."
            )


def _number(source: Source, word: str, what: str) -> float:
    try:
        value = float(word)
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise source.error(f"expected {what} as a number, found {word!r}.")
    return value


def _numbers(source: Source, words: list[str], count: int, what: str) -> np.ndarray:
    if len(words) < count:
        raise source.error(f"expected {count} numbers for the {what}, found {len(words)}.")
    return np.array([_number(source, word, f"the {what}") for word in words[:count]])
