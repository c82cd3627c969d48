"""The header and the parameters of a C3D file.

Numbers are stored as the machine that wrote the file stored them: Intel (little-endian), DEC (little-endian integers,
VAX floats) or SGI/MIPS (big-endian). A byte of the parameter section says which.

References
----------
.. [1] The C3D file format user guide. Motion Lab Systems, 2021.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from leitmotion.io.reading import Source

BLOCK = 512
INTEL, DEC, SGI = 84, 85, 86


@dataclass(frozen=True)
class Machine:
    """How a processor stores numbers."""

    processor: int

    @property
    def order(self) -> str:
        """Byte order as NumPy spells it."""
        return ">" if self.processor == SGI else "<"

    def integers(self, content: bytes | memoryview) -> np.ndarray:
        """16-bit integers, signed."""
        return np.frombuffer(content, dtype=f"{self.order}i2")

    def floats(self, content: bytes | memoryview) -> np.ndarray:
        """32-bit floats; of a VAX the halves stand swapped and the exponent is two larger."""
        if self.processor != DEC:
            return np.frombuffer(content, dtype=f"{self.order}f4")
        halves = np.frombuffer(content, dtype="<u2").reshape(-1, 2)
        with np.errstate(invalid="ignore"):  # a damaged file may hold any bits
            return np.ascontiguousarray(halves[:, ::-1]).view("<f4").reshape(-1) / np.float32(4.0)


@dataclass(frozen=True)
class Header:
    """What the first block says, and the parameters, which say some of it again."""

    points: int
    analog: int
    first: int
    last: int
    scale: float
    data_block: int
    samples: int
    rate: np.floating
    machine: Machine
    parameters: dict[tuple[str, str], Any]
    parameters_end: int
    """The block after the parameters, by the count of blocks that they begin with."""

    damaged: bool
    """Whether the parameters end in the midst of one."""

    def number(self, group: str, name: str) -> float | None:
        """First number of a parameter, None where it is absent or no finite number."""
        value = self.parameters.get((group, name))
        if not isinstance(value, np.ndarray) or value.size == 0:
            return None
        number = float(value[0])
        if not math.isfinite(number):
            return None
        # the shortest decimal of a 32-bit float is what was meant: 119.88, not 119.87999725
        return float(str(value[0])) if value.dtype.kind == "f" else number

    def count(self, group: str, name: str) -> int | None:
        """First number of a parameter as a count: of 16 bits without a sign, None where it is absent or below zero."""
        number = self.number(group, name)
        if number is None:
            return None
        value = self.parameters[group, name]
        count = int(number)
        if value.dtype.kind == "i" and count < 0:
            count &= 0xFFFF
        return count if count >= 0 else None

    def texts(self, group: str, name: str) -> list[str]:
        """Strings of a parameter; those of NAME, NAME2, NAME3 … one after the other."""
        found: list[str] = []
        k = 1
        while isinstance(value := self.parameters.get((group, name if k == 1 else f"{name}{k}")), list):
            found += value
            k += 1
        return found


def read_header(source: Source) -> Header:
    """Read the first block and the parameter section.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Header
        Counts, rate, scale and all parameters by group and name.

    Raises
    ------
    FormatError
        When it is no C3D or ends before its data.
    """
    content = source.content
    if content[1:2] != b"\x50":
        raise source.error(
            f"expected the mark 0x50 of a C3D file in its second byte, found {content[1:2].hex() or 'none'}.",
            remedy="Is this a C3D file?",
        )
    if len(content) < BLOCK:
        raise source.error(
            f"expected a first block of {BLOCK} bytes, found the end after {len(content)}: the file was cut short."
        )
    start = (content[0] - 1) * BLOCK
    if start < BLOCK or start + 4 > len(content):
        raise source.error(f"expected the parameters in block {content[0]}, found the end of the file.")
    processor = content[start + 3]
    if processor not in (INTEL, DEC, SGI):
        raise source.error(f"expected processor 84, 85 or 86 in the parameters, found {processor}.")
    machine = Machine(processor)
    words = machine.integers(content[:24]).astype(np.int64) & 0xFFFF
    data = (int(words[8]) - 1) * BLOCK
    stop = data if start < data <= len(content) else min(len(content), start + 255 * BLOCK)
    parameters, damaged = _parameters(content[:stop], start + 4, machine)
    return Header(
        points=int(words[1]),
        analog=int(words[2]),
        first=int(words[3]),
        last=int(words[4]),
        scale=float(machine.floats(content[12:16])[0]),
        data_block=int(words[8]),
        samples=int(words[9]),
        rate=machine.floats(content[20:24])[0],
        machine=machine,
        parameters=parameters,
        parameters_end=content[0] + content[start + 2],
        damaged=damaged,
    )


def _parameters(content: bytes, position: int, machine: Machine) -> tuple[dict[tuple[str, str], Any], bool]:
    """All parameters by group and name, and whether something damaged ended them.

    A group may stand after its parameters. The length of a name is negative where the group or parameter is locked.
    Where the way to the next one leads out of the parameters, the length of this one is the way.
    """
    groups: dict[int, str] = {}
    found: list[tuple[int, str, Any]] = []
    damaged = False
    while position + 2 <= len(content):
        length, number = abs(_signed(content[position])), _signed(content[position + 1])
        if length == 0 or number == 0:
            break
        link = position + 2 + length
        name = _text(content[position + 2 : link]).upper()
        if link + 2 > len(content) or not name.isprintable():
            damaged = True
            break
        offset = int(machine.integers(content[link : link + 2])[0]) & 0xFFFF
        end = link + 2
        if number < 0:
            groups[-number] = name
        else:
            value, end = _value(content, end, machine)
            damaged |= value is None
            found.append((number, name, value))
        if offset == 0:
            break
        position = link + offset
        if position > len(content):
            position = end + 1 + content[end] if end < len(content) else len(content)
            damaged |= position > len(content)
    return {(groups.get(number, str(number)), name): value for number, name, value in found}, damaged


def _signed(byte: int) -> int:
    return byte - 256 if byte > 127 else byte


def _text(raw: bytes) -> str:
    """Without its padding; the format's text is ASCII, and programs that write more write UTF-8 or Latin-1."""
    try:
        return raw.decode("utf-8").strip(" \0\t")
    except UnicodeDecodeError:
        return raw.decode("latin-1").strip(" \0\t")


def _value(content: bytes, position: int, machine: Machine) -> tuple[Any, int]:
    """An array of numbers in the file's order or a list of strings, None where it is damaged; the byte after it."""
    if position + 2 > len(content):
        return None, len(content)
    kind = _signed(content[position])
    rank = content[position + 1]
    shape = list(content[position + 2 : position + 2 + rank])
    start = position + 2 + rank
    count = math.prod(shape)
    size = abs(kind) * count
    end = start + size
    if kind not in (-1, 1, 2, 4) or end > len(content):
        return None, len(content)
    data = content[start:end]
    if kind == -1:
        width = shape[0] if shape else 1
        rows = count // width if width else 0
        return [_text(data[k * width : (k + 1) * width]) for k in range(rows)], end
    if kind == 1:
        return np.frombuffer(data, dtype=np.uint8), end
    return (machine.integers(data) if kind == 2 else machine.floats(data)), end
