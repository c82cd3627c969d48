"""The HIERARCHY section of a BVH: joints, offsets, channels, end sites.

The grammar is read by lines and tabs, colons, the word "end" or blanks within a joint's name do no harm.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from leitmotion.io.people import distinct
from leitmotion.io.reading import Source

_CHANNEL = re.compile(r"([xyz])(position|rotation)$", re.IGNORECASE)


@dataclass
class Joint:
    """A joint as the file has it: channel letters in upper case move, in lower case turn."""

    name: str
    parent: int
    offset: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    channels: list[str] = field(default_factory=list)
    first: int = 0
    ends: list[list[float]] = field(default_factory=list)


def read_hierarchy(source: Source, warnings: list[str]) -> tuple[list[Joint], int]:
    """Joints in the file's order, which is parents first, and the byte where the section MOTION begins."""
    joints: list[Joint] = []
    stack: list[int | None] = []  # the open braces: a joint, or None for an end site
    pending: int | None = None
    awaiting = False
    columns = 0
    position = 0
    content = source.content
    if not re.match(rb"(\xef\xbb\xbf)?\s*HIERARCHY\b", content, re.IGNORECASE):
        raise source.fault(0, "the word HIERARCHY", glimpse(content), remedy="Is this a BVH file?")
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
            joints.append(Joint(rest or f"joint{len(joints)}", -1 if not stack else int(stack[-1] or 0)))
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


def _floats(source: Source, position: int, words: list[str], count: int) -> list[float]:
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise source.fault(position, f"{count} numbers", repr(" ".join(words)[:60]))
    return values


def glimpse(content: bytes) -> str:
    return repr(content[:40].decode("latin-1"))


def _distinct(joints: list[Joint], warnings: list[str]) -> list[Joint]:
    """Number the joints of one name within a person."""
    roots = [k for k, joint in enumerate(joints) if joint.parent < 0]
    for first, last in zip(roots, [*roots[1:], len(joints)]):
        person = joints[first:last]
        for joint, name in zip(person, distinct([joint.name for joint in person], warnings)):
            joint.name = name
    return joints
