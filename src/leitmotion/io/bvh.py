"""BVH: Biovision hierarchy, a tree of joints with channels and a row of numbers a frame.

Angles are degrees, intrinsic, and turn in the order in which a joint's channels stand, joint by joint. Positions may
stand on any joint and in any place; they take the place of the offset. BVH states neither unit nor vertical. Several
roots are several people.

References
----------
.. [1] M. Meredith, S. Maddock: Motion capture file formats explained. University of Sheffield, 2001.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from leitmotion.io.numerals import read_rows
from leitmotion.io.reading import Draft, Finding, SkeletonTake, Source
from leitmotion.motion import Motion, ParameterError, rotations

_CHANNEL = re.compile(r"([xyz])(position|rotation)$", re.IGNORECASE)
_NTSC = (24000 / 1001, 30000 / 1001, 60000 / 1001, 120000 / 1001)
_SNAP = 2e-3  # how far, relatively, a rate may lie from the one that its rounded frame time is taken for

CMU_BVH = frozenset({"lhipjoint", "rhipjoint", "lowerback", "lthumb", "rthumb"})
"""Joints that only the conversions of the CMU archive's own skeleton to BVH have together."""


@dataclass
class _Joint:
    name: str
    parent: int
    offset: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    channels: list[str] = field(default_factory=list)
    first: int = 0
    ends: list[list[float]] = field(default_factory=list)


def read(source: Source) -> Draft:
    """Read a BVH.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a root.

    Raises
    ------
    FormatError
        When the hierarchy or a row of numbers is not what the format says; it names the line.
    """
    warnings: list[str] = []
    joints, position = _hierarchy(source, warnings)
    promised, seconds, start = _motion_header(source, position)
    columns = sum(len(joint.channels) for joint in joints)
    if columns == 0:
        raise source.error("expected at least one channel in the hierarchy, found none.")
    rows = read_rows(source, start, columns)
    if rows.cut:
        warnings.append(
            f"The file ends within its row {len(rows.values) + 1}; the whole rows before it were read."
        )
    if len(rows.values) == 0:
        raise source.error("expected at least one row of numbers after the frame time, found none.")
    if promised != len(rows.values):
        warnings.append(
            f"The header promises {promised} frames, the file has {len(rows.values)}; those it has were read."
        )
    roots = [k for k, joint in enumerate(joints) if joint.parent < 0]
    takes = [
        _take(joints[first:last], first, rows.values) for first, last in zip(roots, [*roots[1:], len(joints)])
    ]
    unit = None
    if {joint.name.lower() for joint in joints} >= CMU_BVH:
        unit = Finding("1/0.45 inch", "guessed", "the joints are those of the CMU archive, whose unit it is")
    return Draft(takes, rate=frame_rate(seconds, source), unit=unit, warnings=warnings)


def frame_rate(text: str, source: Source) -> Finding:
    """Tell the rate that a frame time, rounded or cut to some decimals, stands for.

    Parameters
    ----------
    text : str
        The frame time in seconds as it is written.
    source : Source
        The file, for the error.

    Returns
    -------
    Finding
        The nearest whole or broadcast rate whose frame time differs by less than one unit in the last place written,
        else the reciprocal.
    """
    try:
        seconds = float(text.replace(",", "."))
    except ValueError:
        seconds = np.nan
    if source.options.rate is not None and not (np.isfinite(seconds) and seconds > 0):
        return Finding(source.options.rate, "given", "rate given by the caller")
    if not (np.isfinite(seconds) and seconds > 0):
        raise source.error(
            f"expected a frame time above 0 s, found {text!r}.", remedy="State the rate with --rate HZ."
        )
    exact = 1.0 / seconds
    mantissa, _, power = text.lower().partition("e")
    decimals = len(mantissa.replace(",", ".").partition(".")[2]) - int(power or 0)
    unit = 10.0**-decimals
    near = min((max(1.0, round(exact)), *_NTSC), key=lambda rate: abs(1.0 / rate - seconds))
    if abs(1.0 / near - seconds) < unit and abs(near / exact - 1.0) < _SNAP:
        return Finding(float(near), "read", f"frame time {text} s, taken as {near:.6g} Hz")
    return Finding(exact, "read", f"frame time {text} s")


def _hierarchy(source: Source, warnings: list[str]) -> tuple[list[_Joint], int]:
    """Joints in the file's order, which is parents first, and the byte where the section MOTION begins."""
    joints: list[_Joint] = []
    stack: list[int | None] = []  # the open braces: a joint, or None for an end site
    pending: int | None = None
    awaiting = False
    columns = 0
    position = 0
    content = source.content
    if not re.match(rb"(\xef\xbb\xbf)?\s*HIERARCHY\b", content, re.IGNORECASE):
        raise source.fault(0, "the word HIERARCHY", _glimpse(content), remedy="Is this a BVH file?")
    while position < len(content):
        stop = content.find(b"\n", position)
        stop = len(content) if stop < 0 else stop
        line = content[position:stop].decode("utf-8", "replace").replace("\ufeff", "").strip()
        if line.endswith("{") and len(line) > 1:
            line, brace = line[:-1].strip(), True
        else:
            brace = False
        word, _, rest = line.partition(" ") if " " in line else line.partition("\t")
        word, rest = word.upper().strip(), rest.strip()
        if "\t" in word:
            word, _, more = word.partition("\t")
            rest = line[len(word) :].strip()
        if word in ("ROOT", "JOINT"):
            if awaiting:
                raise source.fault(position, "a brace {", line)
            if (word == "ROOT") != (not stack):
                raise source.fault(position, "a JOINT within a joint and a ROOT outside", line)
            if word == "JOINT" and stack[-1] is None:
                raise source.fault(position, "no JOINT within an End Site", line)
            joints.append(_Joint(rest or f"joint{len(joints)}", -1 if not stack else int(stack[-1] or 0)))
            pending, awaiting = len(joints) - 1, True
        elif word == "END" and rest.upper().startswith("SITE"):
            if not stack or stack[-1] is None:
                raise source.fault(position, "an End Site within a joint", line)
            pending, awaiting = None, True
        elif word == "OFFSET":
            if not stack:
                raise source.fault(position, "an OFFSET within a joint", line)
            offset = _floats(source, position, rest.split(), 3)
            if stack[-1] is None:
                joints[_owner(stack)].ends.append(offset)
            else:
                joints[stack[-1]].offset = offset
        elif word == "CHANNELS":
            if not stack or stack[-1] is None:
                raise source.fault(position, "CHANNELS within a joint", line)
            joint = joints[stack[-1]]
            joint.channels, joint.first = _channels(source, position, rest.split()), columns
            columns += len(joint.channels)
        elif word == "MOTION":
            if stack:
                raise source.fault(position, f"{len(stack)} closing braces before MOTION", "none")
            if not joints:
                raise source.fault(position, "a ROOT before MOTION", "none")
            return _distinct(joints, warnings), stop + 1
        elif line and set(line) - set("{} \t") and word != "HIERARCHY":
            raise source.fault(
                position, "ROOT, JOINT, End Site, OFFSET, CHANNELS or a brace", repr(line[:60])
            )
        for mark in "{" * brace + (line if not set(line) - set("{} \t") else ""):
            if mark == "{":
                if not awaiting:
                    raise source.fault(position, "a JOINT before the brace", "{")
                stack.append(pending)
                awaiting = False
            elif mark == "}":
                if not stack:
                    raise source.fault(position, "no more closing braces than open ones", "}")
                stack.pop()
        position = stop + 1
    raise source.error(
        "expected a section MOTION after the hierarchy, found the end: the file was cut short."
    )


def _owner(stack: list[int | None]) -> int:
    return next(joint for joint in reversed(stack) if joint is not None)


def _channels(source: Source, position: int, words: list[str]) -> list[str]:
    """Channel letters: upper case moves, lower case turns."""
    try:
        count = int(words[0])
    except (IndexError, ValueError):
        raise source.fault(position, "a count of channels", repr(" ".join(words))) from None
    if len(words) - 1 != count:
        raise source.fault(position, f"{count} channels", str(len(words) - 1))
    letters = []
    for word in words[1:]:
        match = _CHANNEL.match(word)
        if not match:
            raise source.fault(position, "channels such as Xposition or Zrotation", repr(word))
        letter = match[1].lower()
        letters.append(letter.upper() if match[2].lower() == "position" else letter)
    for letter in set(letters):
        if letter.isupper() and letters.count(letter) > 1:
            raise source.fault(position, "each position channel once", f"{letter}position twice")
    return letters


def _motion_header(source: Source, position: int) -> tuple[int, str, int]:
    """How many frames are promised, the frame time as written, the byte of the first row."""
    header = re.compile(
        rb"\s*Frames\s*:?\s*(\S+)[^\n]*\n\s*Frame\s*Time\s*:?\s*([^\s]+)[^\n]*(?:\n|$)", re.IGNORECASE
    ).match(source.content, position)
    if header is None:
        raise source.fault(
            position, "the lines 'Frames:' and 'Frame Time:'", _glimpse(source.content[position:])
        )
    try:
        promised = int(float(header[1]))
    except (ValueError, OverflowError):
        raise source.fault(header.start(1), "a count of frames", repr(header[1].decode("latin-1"))) from None
    return promised, header[2].decode("latin-1"), header.end()


def _floats(source: Source, position: int, words: list[str], count: int) -> list[float]:
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise source.fault(position, f"{count} numbers", repr(" ".join(words)[:60]))
    return values


def _glimpse(content: bytes) -> str:
    return repr(content[:40].decode("latin-1"))


def _distinct(joints: list[_Joint], warnings: list[str]) -> list[_Joint]:
    """Give joints of one name within a person a number each."""
    seen: dict[str, int] = {}
    doubled = []
    for joint in joints:
        if joint.parent < 0:
            seen = {}
        seen[joint.name] = seen.get(joint.name, 0) + 1
        if seen[joint.name] > 1:
            doubled.append(joint.name)
            joint.name = f"{joint.name}#{seen[joint.name]}"
    if doubled:
        warnings.append(f"Names stand twice and were numbered: {', '.join(sorted(set(doubled)))}.")
    return joints


def _take(joints: list[_Joint], first: int, values: np.ndarray) -> SkeletonTake:
    frames = len(values)
    offsets = np.array([joint.offset for joint in joints])
    parents = np.array([joint.parent - first if joint.parent >= 0 else -1 for joint in joints])
    positions = np.empty((frames, len(joints), 3))
    quaternions = np.empty((frames, len(joints), 4))
    for j, joint in enumerate(joints):
        positions[:, j] = offsets[j]
        order, turning = "", []
        for k, letter in enumerate(joint.channels):
            column = values[:, joint.first + k]
            if letter.isupper():
                positions[:, j, "XYZ".index(letter)] = column
            else:
                order += letter
                turning.append(column)
        if order:
            quaternions[:, j] = rotations.from_euler(order, np.deg2rad(np.stack(turning, axis=-1)))
        else:
            quaternions[:, j] = rotations.IDENTITY
    ends = [(j, end) for j, joint in enumerate(joints) for end in joint.ends]
    return SkeletonTake(
        [joint.name for joint in joints],
        parents,
        offsets,
        np.array([j for j, _ in ends], dtype=np.int64),
        np.array([end for _, end in ends]).reshape(-1, 3),
        positions,
        rotations.continuous(quaternions),
        person=joints[0].name,
    )
