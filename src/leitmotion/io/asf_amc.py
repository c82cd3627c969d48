"""ASF/AMC: Acclaim motion, a skeleton file and a file of frames.

A bone of an ASF is the joint at its *proximal* end: the joint ``lfemur`` is the left hip. The tip of a bone that has no
child is an end site. AMC states no unit, and seldom a rate. The skeleton that Vicon BodyBuilder wrote for the CMU and
HDM05 archives is known by its bones: 120 Hz, and one unit of length is 1/0.45 inch.

References
----------
.. [1] J. Lander: Working with motion capture file formats. Game Developer, January 1998.
.. [2] M. Müller et al.: Documentation Mocap Database HDM05. Universität Bonn, CG-2007-2, 2007.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from leitmotion.io.asf import Acclaim, fixed_axes, name_at_start, read_asf, spellings
from leitmotion.io.asf_search import find_asf
from leitmotion.io.containers import read_file
from leitmotion.io.numerals import as_bytes, settle
from leitmotion.io.reading import Draft, Finding, SkeletonTake, Source, glimpse
from leitmotion.io.text import as_text
from leitmotion.motion import rotations

BODYBUILDER = frozenset(
    [
        "root",
        "lhipjoint",
        "lfemur",
        "ltibia",
        "lfoot",
        "ltoes",
        "rhipjoint",
        "rfemur",
        "rtibia",
        "rfoot",
        "rtoes",
        "lowerback",
        "upperback",
        "thorax",
        "lowerneck",
        "upperneck",
        "head",
        "lclavicle",
        "lhumerus",
        "lradius",
        "lwrist",
        "lhand",
        "lfingers",
        "lthumb",
        "rclavicle",
        "rhumerus",
        "rradius",
        "rwrist",
        "rhand",
        "rfingers",
        "rthumb",
    ]
)
"""Bones of the skeleton of the CMU and HDM05 archives."""

_USUAL_RATE = 120.0
_HEAD = 4096  # bytes that hold the header
_REMARK = re.compile(rb"#[^\n]*")
_RATE = re.compile(
    rb"^[ \t]*[:#][ \t]*(samples[-_ ]per[-_ ]second|frame[-_ ]?rate|rate|fps)[ \t]*[:=]?[ \t]*(\d+\.?\d*)",
    re.IGNORECASE | re.MULTILINE,
)


def read(source: Source) -> Draft:
    """Read an AMC with its ASF.

    Parameters
    ----------
    source : Source
        The AMC; its skeleton is ``source.options.skeleton`` or is looked for beside it.

    Returns
    -------
    Draft
        One person.

    Raises
    ------
    FormatError
        When there is no skeleton, or a frame does not fit it; it names the line.
    """
    path, how, reason = _skeleton_of(source)
    warnings: list[str] = []
    acclaim = read_asf(Source(path, as_text(path, read_file(path)[1], warnings)))
    channels, dofs = _channels(source, acclaim, warnings)
    unit, known = None, {name.lower() for name in acclaim.names} == BODYBUILDER
    if acclaim.scale == 0.45 and known:
        unit = Finding(
            "1/0.45 inch",
            "guessed",
            "the bones are those of the CMU and HDM05 archives, in whose unit the body is an adult's",
        )
    return Draft(
        [_take(acclaim, channels, dofs, degrees=_degrees(source, acclaim))],
        rate=_rate(source),
        unit=unit,
        up=Finding("y", "guessed", "an ASF states no vertical, and Y is the format's usual one"),
        up_may_err=not known,
        findings={"skeleton": Finding(str(path), how, reason)},
        warnings=warnings,
    )


def _skeleton_of(source: Source) -> tuple[Path, str, str]:
    if source.options.skeleton is not None:
        return Path(source.options.skeleton), "given", "skeleton given by the caller"
    path, reason = find_asf(source.path)
    return path, "guessed", reason


def _channels(
    source: Source, acclaim: Acclaim, warnings: list[str]
) -> tuple[np.ndarray, dict[str, tuple[int, tuple[str, ...]]]]:
    """Numbers of all frames (T, N), and for each bone its first column and its degrees of freedom."""
    from leitmotion.io import _kernels

    source = _without_remarks(source)
    known = {bone.name: bone.dofs for bone in acclaim.bones}
    spelled = spellings(known)
    start, labels = _first_frame(source, spelled)
    dofs: dict[str, tuple[int, tuple[str, ...]]] = {}
    column = 0
    for label in labels:
        name, _ = name_at_start(label.split(), spelled) or ("", 0)
        if not name:
            raise source.fault(start, "bones of the skeleton", repr(label), remedy=_OTHER_SKELETON)
        dofs[name] = (column, known[name])
        column += len(known[name])
    for name, needed in known.items():
        if needed and name not in dofs:
            raise source.fault(
                start, f"a line of bone {name!r} in the first frame", "none", remedy=_OTHER_SKELETON
            )
    content = source.content
    capacity = content.count(b"\n", start) // (len(labels) + 1) + 2
    if column * capacity > len(content):
        capacity = len(content) // max(column, 1) + 2
    values = np.empty((capacity, column))
    numbers = np.empty(capacity, dtype=np.int64)
    doubts = np.empty((values.size, 3), dtype=np.int64)
    words = [label.encode("utf-8", "replace") for label in labels]
    borders = np.cumsum([0, *map(len, words)])
    counts = np.array([len(channels) for _, channels in dofs.values()])
    frames, doubtful, status, stopped, bone = _kernels.scan_amc(
        as_bytes(content), start, as_bytes(b"".join(words)), borders, counts, values, numbers, doubts
    )
    if status != _kernels.DONE:
        _explain(source, status, stopped, labels, counts, bone, frames, warnings)
    inside = doubts[:doubtful]
    settle(source, values, inside[inside[:, 0] < frames * column], missing=True)
    if frames == 0:
        raise source.error("expected at least one whole frame, found none.")
    _check_numbers(numbers[:frames], warnings)
    return values[:frames], dofs


_OTHER_SKELETON = "The recording was made with another skeleton: name its ASF with --skeleton FILE."


def _without_remarks(source: Source) -> Source:
    """The file with blanks in place of its comments, so that every byte keeps its place."""
    return replace(source, content=_REMARK.sub(lambda match: b" " * len(match[0]), source.content))


def _first_frame(source: Source, spelled: Mapping[str, str]) -> tuple[int, list[str]]:
    """Byte where the first frame begins, and its bones in the order of its lines, as they are written."""
    start = -1
    labels: dict[str, None] = {}
    for position, line in source.lines():
        words = line.decode("utf-8", "replace").split()
        if len(words) == 1 and line.strip().isdigit():
            if start >= 0:
                break
            start = position
        elif words and start < 0 and not words[0].startswith(":"):
            raise source.fault(
                position, "the number of the first frame", glimpse(line), remedy="Is this an AMC file?"
            )
        elif words and start >= 0:
            _, count = name_at_start(words, spelled) or ("", 1)
            label = " ".join(words[:count])
            if label in labels:
                raise source.fault(position, "every bone once a frame", f"{label!r} again")
            labels[label] = None
    if start < 0 or not labels:
        raise source.error("expected frames, a number and a line for each bone, found none.")
    return start, list(labels)


def _explain(
    source: Source, status: int, stopped: int, labels: list[str], counts: np.ndarray, bone: int, frames: int,
    warnings: list[str],
) -> None:  # fmt: skip
    from leitmotion.io import _kernels

    if status == _kernels.CUT:
        warnings.append(
            f"The file ends within its frame {frames + 1}, at bone {labels[bone]!r}; the {frames} whole ones were read."
        )
        return
    line = source.content[stopped:].partition(b"\n")[0].strip().decode("utf-8", "replace")
    found = repr(line if len(line) <= 60 else line[:57] + "…")
    if status == _kernels.NOT_A_FRAME:
        expected = "the number of the next frame"
    elif status == _kernels.WRONG_NAME:
        expected = f"bone {labels[bone]!r}, as in the first frame"
    else:
        expected = f"{labels[bone]!r} and {counts[bone]} numbers"
    raise source.fault(stopped, expected, found)


def _check_numbers(numbers: np.ndarray, warnings: list[str]) -> None:
    jumps = np.flatnonzero(np.diff(numbers) != 1)
    if jumps.size:
        k = int(jumps[0])
        warnings.append(
            f"Frame numbers are not consecutive at {jumps.size} places, first where {numbers[k + 1]} follows "
            f"{numbers[k]}; the frames were taken as they stand."
        )


def _rate(source: Source) -> Finding:
    """What some programs write into the header or a comment, else what the large archives have."""
    stated = _RATE.search(source.content[:_HEAD])
    if stated is not None and float(stated[2]) > 0:
        return Finding(float(stated[2]), "read", f"stated as {stated[1].decode()}")
    return Finding(_USUAL_RATE, "guessed", "the AMC states no rate; the CMU and HDM05 archives have 120 Hz")


def _degrees(source: Source, acclaim: Acclaim) -> bool:
    """Whether the angles of the frames are degrees: the AMC's word counts before the ASF's."""
    stated = re.search(rb"^\s*:(DEGREES|RADIANS)\b", source.content[:_HEAD], re.IGNORECASE | re.MULTILINE)
    return acclaim.degrees if stated is None else stated[1].upper() == b"DEGREES"


def _take(
    acclaim: Acclaim, channels: np.ndarray, dofs: dict[str, tuple[int, tuple[str, ...]]], *, degrees: bool
) -> SkeletonTake:
    frames, joints = len(channels), len(acclaim.bones)
    offsets = np.zeros((joints, 3))
    positions = np.empty((frames, joints, 3))
    quaternions = np.empty((frames, joints, 4))
    for j, (bone, parent) in enumerate(zip(acclaim.bones, acclaim.parents)):
        if parent >= 0:
            above = acclaim.bones[parent]
            offsets[j] = above.direction * above.length
        else:
            offsets[j] = acclaim.position
        first, letters = dofs.get(bone.name, (0, ()))
        columns = {dof: channels[:, first + k] for k, dof in enumerate(letters)}
        quaternions[:, j] = _rotation(bone.axis, columns, degrees, frames)
        positions[:, j] = offsets[j]
        moved = [columns.get(dof) for dof in ("tx", "ty", "tz")]
        if any(shift is not None for shift in moved):
            shift = np.stack([np.zeros(frames) if s is None else s for s in moved], axis=-1)
            positions[:, j] += shift if parent < 0 else rotations.rotate(bone.axis, shift)
    for j, parent in enumerate(acclaim.parents):
        stretch = dofs.get(acclaim.bones[parent].name) if parent >= 0 else None
        if stretch and "l" in stretch[1]:
            length = channels[:, stretch[0] + stretch[1].index("l")]
            positions[:, j] += length[:, None] * acclaim.bones[parent].direction
    leaves = [j for j in range(1, joints) if j not in acclaim.parents]
    return SkeletonTake(
        acclaim.names,
        np.array(acclaim.parents),
        offsets,
        np.array(leaves, dtype=np.int64),
        np.array([acclaim.bones[j].direction * acclaim.bones[j].length for j in leaves]).reshape(-1, 3),
        positions,
        quaternions,
    )


def _rotation(axis: np.ndarray, columns: dict[str, np.ndarray], degrees: bool, frames: int) -> np.ndarray:
    """``C M C^-1`` of one bone, (T, 4)."""
    turns = [(dof[1], values) for dof, values in columns.items() if dof[0] == "r"]
    if not turns:
        return np.broadcast_to(rotations.IDENTITY, (frames, 4))
    order = "".join(letter for letter, _ in turns)
    local = fixed_axes(order, np.stack([values for _, values in turns], axis=-1), degrees)
    if axis[0] == 1.0:
        return local
    return rotations.multiply(rotations.multiply(axis, local), rotations.conjugate(axis))
