"""The HIERARCHY section of a BVH: joints, offsets, channels, end sites.

The grammar is read by lines, so that colons, blanks, braces or the word "end" within a joint's name do no harm.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from leitmotion.io.points import distinct
from leitmotion.io.reading import Source, glimpse

SCALE = "s"
"""Stands for a channel of scale, whose numbers are left out."""

_CHANNEL = re.compile(r"([xyz])(position|rotation|scale)$", re.IGNORECASE)
_END_SITE = re.compile(r"end([\s_]*site\b.*)?$", re.IGNORECASE)
_RUN_ON = re.compile(r"\{\s*(OFFSET|CHANNELS)\s", re.IGNORECASE)
_REMARK = ("#", "//")
_BEGIN = re.compile(rb"(\xef\xbb\xbf)?(\s*(#|//)[^\n]*\n)*\s*HIERARCHY\b", re.IGNORECASE)
_END = -1  # stands for an end site among the open braces
_NAMED = 8  # joints that a warning names


@dataclass
class Joint:
    """A joint as the file has it: channel letters in upper case move, in lower case turn."""

    name: str
    parent: int
    offset: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    channels: list[str] = field(default_factory=list)
    first: int = 0
    ends: list[list[float]] = field(default_factory=list)
    placed: bool = False


@dataclass(frozen=True)
class Hierarchy:
    """What the section says."""

    joints: list[Joint]
    """In the file's order, parents first."""

    columns: int
    """Numbers a frame."""

    stop: int
    """The byte after the line MOTION."""


def read_hierarchy(source: Source, warnings: list[str]) -> Hierarchy:
    """Read the joints of a BVH.

    Parameters
    ----------
    source : Source
        The file.
    warnings : list of str
        Gains a sentence where joints have one name or no offset, and where channels are left out.

    Returns
    -------
    Hierarchy
        The joints.

    Raises
    ------
    FormatError
        When the section is not what the format says; it names the line.
    """
    content = source.content
    if not _BEGIN.match(content):
        raise source.fault(0, "the word HIERARCHY", glimpse(content), remedy="Is this a BVH file?")
    tree = _Tree(source)
    for position, raw in source.lines():
        line = raw.decode("utf-8", "replace").strip(" \t\r")
        line = line if position else line.lstrip("\ufeff \t")
        if line.upper().rstrip(": ") == "MOTION":
            tree.close(position)
            warnings += tree.odd()
            return Hierarchy(_distinct(tree.joints, warnings), tree.columns, position + len(raw) + 1)
        if not line.startswith(_REMARK):
            tree.take(line, position)
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
        self.left = 0  # channels whose numbers are left out

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
        closing = 0
        if word in ("OFFSET", "CHANNELS"):
            bare = rest.rstrip("} \t")
            rest, closing = bare, rest[len(bare) :].count("}")
        if word in ("ROOT", "JOINT"):
            self._joint(word, rest, position)
        elif _END_SITE.match(line.removesuffix("{").strip()):
            self._inside(position, "an End Site within a joint", line)
            self.awaited = _END
        elif word == "OFFSET":
            self._offset(rest, position)
        elif word == "CHANNELS":
            self._channels(rest, position, line)
        elif word == "HIERARCHY" and rest:
            self.take(rest, position)
        elif word != "HIERARCHY":
            expected = "ROOT, JOINT, End Site, OFFSET, CHANNELS or a brace"
            raise self.source.fault(position, expected, repr(line[:60]))
        for mark in "{" * brace + "}" * closing:
            self._brace(mark, position)

    def odd(self) -> list[str]:
        """Say what is odd about the joints."""
        told = []
        if self.left:
            told.append(f"Channels of scale or of end sites were left out, {self.left} in number.")
        bare = [joint.name for joint in self.joints if not joint.placed]
        if bare:
            names = f"{', '.join(bare[:_NAMED])}{' …' if len(bare) > _NAMED else ''}"
            told.append(f"Joints without an OFFSET were taken to have 0 0 0: {names}.")
        return told

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
        if _RUN_ON.search(name):
            raise self.source.fault(position, "a line for each joint, OFFSET and CHANNELS", repr(name[:60]))
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
        offset = _floats(self.source, position, rest, 3)
        if self.open[-1] == _END:
            self.joints[self.open[-2]].ends.append(offset)
            return
        joint = self.joints[self.open[-1]]
        if joint.placed:
            raise self.source.fault(position, "OFFSET once a joint", "it again")
        joint.offset, joint.placed = offset, True

    def _channels(self, rest: str, position: int, line: str) -> None:
        if not self.open:
            raise self.source.fault(position, "CHANNELS within a joint", repr(line[:60]))
        letters = _channels(self.source, position, rest.split())
        self.left += len(letters) if self.open[-1] == _END else letters.count(SCALE)
        if self.open[-1] != _END:
            joint = self.joints[self.open[-1]]
            if joint.channels:
                raise self.source.fault(position, "CHANNELS once a joint", "them again")
            joint.channels, joint.first = letters, self.columns
        self.columns += len(letters)

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
        kind, letter = match[2].lower(), match[1].lower()
        letters.append(SCALE if kind == "scale" else letter.upper() if kind == "position" else letter)
    moves = [letter for letter in letters if letter.isupper()]
    if len(set(moves)) < len(moves):
        raise source.fault(position, "each position channel once", " ".join(words[1:]))
    return letters


def _floats(source: Source, position: int, text: str, count: int) -> list[float]:
    """Numbers with decimal points or commas, divided by blanks or by commas."""
    words = text.split()
    words = (
        text.replace(",", " ").split()
        if len(words) != count or ", " in text
        else text.replace(",", ".").split()
    )
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise source.fault(position, f"{count} numbers", repr(text[:60]))
    return values


def _distinct(joints: list[Joint], warnings: list[str]) -> list[Joint]:
    """Number the joints of one name within a person."""
    roots = [k for k, joint in enumerate(joints) if joint.parent < 0]
    for first, last in zip(roots, [*roots[1:], len(joints)]):
        person = joints[first:last]
        for joint, name in zip(person, distinct([joint.name for joint in person], warnings)):
            joint.name = name
    return joints
