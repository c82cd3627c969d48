"""The HIERARCHY section of a BVH: joints, offsets, channels, end sites.

The grammar is read by lines, so that colons, blanks, braces or the word "end" within a joint's name do no harm.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from leitmotion.io.points import distinct
from leitmotion.io.reading import Source, glimpse

_CHANNEL = re.compile(r"([xyz])(position|rotation)$", re.IGNORECASE)
_END = -1  # stands for an end site among the open braces


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
    """Read the joints of a BVH.

    Parameters
    ----------
    source : Source
        The file.
    warnings : list of str
        Gains a sentence where joints have one name.

    Returns
    -------
    tuple
        The joints in the file's order, parents first, and the byte after the line MOTION.

    Raises
    ------
    FormatError
        When the section is not what the format says; it names the line.
    """
    content = source.content
    if not re.match(rb"(\xef\xbb\xbf)?\s*HIERARCHY\b", content, re.IGNORECASE):
        raise source.fault(0, "the word HIERARCHY", glimpse(content), remedy="Is this a BVH file?")
    tree = _Tree(source)
    position = 0
    while position < len(content):
        stop = content.find(b"\n", position)
        stop = len(content) if stop < 0 else stop
        line = content[position:stop].decode("utf-8", "replace").strip(" \t\r")
        line = line if position else line.lstrip("\ufeff \t")
        if line.upper() == "MOTION":
            tree.close(position)
            return _distinct(tree.joints, warnings), stop + 1
        tree.take(line, position)
        position = stop + 1
    raise source.error(
        "expected a section MOTION after the hierarchy, found the end: the file was cut short."
    )


class _Tree:
    """The joints read so far, and the braces that are open."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.joints: list[Joint] = []
        self.open: list[int] = []  # places of joints, _END for an end site
        self.awaited: int | None = None  # what the next brace opens
        self.columns = 0

    def take(self, line: str, position: int) -> None:
        """Take in one line."""
        if not line.strip("{} \t"):
            for mark in line:
                self._brace(mark, position)
            return
        words = line.split(None, 1)
        brace = line.endswith("{")
        if brace and words[0].upper() in ("ROOT", "JOINT"):
            brace = not self._on_next_line(position)  # else the name ends in one
        if brace:
            words = line[:-1].split(None, 1) or [""]
        word, rest = words[0].upper(), words[1].strip() if len(words) > 1 else ""
        if word in ("ROOT", "JOINT"):
            self._joint(word, rest, position)
        elif word == "END" and rest.upper().startswith("SITE"):
            self._inside(position, "an End Site within a joint", line)
            self.awaited = _END
        elif word == "OFFSET":
            self._offset(rest, position)
        elif word == "CHANNELS":
            self._inside(position, "CHANNELS within a joint", line)
            joint = self.joints[self.open[-1]]
            if joint.channels:
                raise self.source.fault(position, "CHANNELS once a joint", "them again")
            joint.channels, joint.first = _channels(self.source, position, rest.split()), self.columns
            self.columns += len(joint.channels)
        elif word != "HIERARCHY":
            expected = "ROOT, JOINT, End Site, OFFSET, CHANNELS or a brace"
            raise self.source.fault(position, expected, repr(line[:60]))
        if brace:
            self._brace("{", position)

    def close(self, position: int) -> None:
        """Check that the section is complete."""
        if self.open:
            raise self.source.fault(position, f"{len(self.open)} closing braces before MOTION", "none")
        if not self.joints:
            raise self.source.fault(position, "a ROOT before MOTION", "none")

    def _on_next_line(self, position: int) -> bool:
        """Whether the line after the one at a byte that is not blank begins with an opening brace."""
        stop = self.source.content.find(b"\n", position)
        return stop >= 0 and re.compile(rb"\s*\{").match(self.source.content, stop) is not None

    def _joint(self, word: str, name: str, position: int) -> None:
        if (word == "ROOT") == bool(self.open) or self.open[-1:] == [_END] or self.awaited is not None:
            raise self.source.fault(
                position, "a ROOT outside joints and a JOINT within one", f"{word} {name}"
            )
        parent = self.open[-1] if self.open else -1
        self.joints.append(Joint(name or f"joint{len(self.joints)}", parent))
        self.awaited = len(self.joints) - 1

    def _offset(self, rest: str, position: int) -> None:
        if not self.open:
            raise self.source.fault(position, "an OFFSET within a joint", "one outside")
        offset = _floats(self.source, position, rest.split(), 3)
        if self.open[-1] == _END:
            self.joints[self.open[-2]].ends.append(offset)
        else:
            self.joints[self.open[-1]].offset = offset

    def _inside(self, position: int, expected: str, line: str) -> None:
        if not self.open or self.open[-1] == _END:
            raise self.source.fault(position, expected, repr(line[:60]))

    def _brace(self, mark: str, position: int) -> None:
        if mark == "{":
            if self.awaited is None:
                raise self.source.fault(position, "a joint before the brace", "{")
            self.open.append(self.awaited)
            self.awaited = None
        elif mark == "}":
            if not self.open or self.awaited is not None:
                raise self.source.fault(position, "no more closing braces than open ones", "}")
            self.open.pop()


def _channels(source: Source, position: int, words: list[str]) -> list[str]:
    try:
        count = int(words[0])
    except (IndexError, ValueError):
        raise source.fault(position, "a count of channels", repr(" ".join(words)[:60])) from None
    if len(words) - 1 != count:
        raise source.fault(position, f"{count} channels", str(len(words) - 1))
    letters = []
    for word in words[1:]:
        match = _CHANNEL.match(word)
        if not match:
            raise source.fault(position, "channels such as Xposition or Zrotation", repr(word))
        letter = match[1].lower()
        letters.append(letter.upper() if match[2].lower() == "position" else letter)
    moves = [letter for letter in letters if letter.isupper()]
    if len(set(moves)) < len(moves):
        raise source.fault(position, "each position channel once", " ".join(words[1:]))
    return letters


def _floats(source: Source, position: int, words: list[str], count: int) -> list[float]:
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise source.fault(position, f"{count} numbers", repr(" ".join(words)[:60]))
    return values


def _distinct(joints: list[Joint], warnings: list[str]) -> list[Joint]:
    """Number the joints of one name within a person."""
    roots = [k for k, joint in enumerate(joints) if joint.parent < 0]
    for first, last in zip(roots, [*roots[1:], len(joints)]):
        person = joints[first:last]
        for joint, name in zip(person, distinct([joint.name for joint in person], warnings)):
            joint.name = name
    return joints
