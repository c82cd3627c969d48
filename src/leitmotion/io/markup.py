"""XML from anywhere: elements and their texts, and nothing that a hostile file could make of it.

Document types and entities are refused before they are looked at, depth and size are bounded, and nothing outside the
file is ever opened.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.parsers import expat

from leitmotion.motion import FormatError

_DEPTH = 64
_SIZE = 256 << 20  # bytes


@dataclass
class Element:
    """An element with its attributes, its text and the elements in it."""

    tag: str
    attributes: dict[str, str]
    children: list[Element] = field(default_factory=list)
    text: str = ""

    def all(self, tag: str) -> Iterator[Element]:
        """Go through the children of a name."""
        return (child for child in self.children if child.tag == tag)


def parse(content: bytes, path: Path) -> Element:
    """Read a whole XML document.

    Parameters
    ----------
    content : bytes
        The file.
    path : Path
        What it is called, for errors.

    Returns
    -------
    Element
        Its root.

    Raises
    ------
    FormatError
        When it is no XML, declares a document type, or is too deep or too large.
    """
    if len(content) > _SIZE:
        raise FormatError(
            f"{path.name}: expected XML of at most {_SIZE >> 20} MB, found {len(content) >> 20} MB."
        )
    top = Element("", {})
    stack, texts = [top], [[""]]
    parser = expat.ParserCreate()

    def refuse(*_: Any) -> None:
        raise FormatError(
            f"{path.name}, line {parser.CurrentLineNumber}: expected plain XML, found a document type or entities, "
            "which are not read.",
            remedy="Save it anew from the program that made it.",
        )

    def start(tag: str, attributes: dict[str, str]) -> None:
        if len(stack) > _DEPTH:
            raise FormatError(f"{path.name}: expected elements at most {_DEPTH} deep, found deeper ones.")
        element = Element(tag, attributes)
        stack[-1].children.append(element)
        stack.append(element)
        texts.append([])

    def end(_: str) -> None:
        stack.pop().text = "".join(texts.pop())

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = lambda text: texts[-1].append(text)
    parser.StartDoctypeDeclHandler = refuse  # before any entity is declared
    try:
        parser.Parse(content, True)
    except expat.ExpatError as error:
        raise FormatError(
            f"{path.name}, line {error.lineno}: expected XML, found that it breaks there "
            f"({expat.errors.messages[error.code]}).",
            remedy="Was it copied or downloaded completely?",
        ) from None
    except FormatError:
        raise
    except (ValueError, LookupError):  # an encoding that nobody knows
        raise FormatError(f"{path.name}: expected XML in a known encoding, found another.") from None
    return top.children[0]
