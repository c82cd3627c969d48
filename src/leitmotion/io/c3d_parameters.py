"""The header and the parameters of a C3D file.

Numbers are stored as the machine that wrote the file stored them: Intel (little-endian), DEC (little-endian integers,
VAX floats) or SGI/MIPS (big-endian). A byte of the parameter section says which.

References
----------
.. [1] The C3D file format user guide. Motion Lab Systems, 2021.
"""

from __future__ import annotations

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
    """What the first block says; only Parameters can overrule it."""

    points: int
    analog: int
    first: int
    last: int
    scale: float
    data_block: int
    rate: float
    machine: Machine
    parameters: dict[tuple[str, str], Any]

    def number(self, group: str, name: str) -> float | None:
        """First number of a parameter, None where it is absent or no finite number."""
        value = self.parameters.get((group, name))
        if not isinstance(value, np.ndarray) or value.size == 0:
            return None
        number = float(value.reshape(-1)[0])
        return number if np.isfinite(number) else None

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
    if len(content) < BLOCK or content[1] != 0x50:
        raise source.error("expected the mark 0x50 of a C3D file in its second byte, found another.")
    start = (content[0] - 1) * BLOCK
    if start < BLOCK or start + 4 > len(content):
        raise source.error(f"expected the parameters in block {content[0]}, found the end of the file.")
    processor = content[start + 3]
    if processor not in (INTEL, DEC, SGI):
        raise source.error(f"expected processor 84, 85 or 86 in the parameters, found {processor}.")
    machine = Machine(processor)
    words = machine.integers(content[:24]).astype(np.int64) & 0xFFFF
    return Header(
        points=int(words[1]),
        analog=int(words[2]),
        first=int(words[3]),
        last=int(words[4]),
        scale=float(machine.floats(content[12:16])[0]),
        data_block=int(words[8]),
        rate=float(machine.floats(content[20:24])[0]),
        machine=machine,
        parameters=_parameters(content, start + 4, machine),
    )


def _parameters(content: bytes, position: int, machine: Machine) -> dict[tuple[str, str], Any]:
    """All parameters by group and name; a damaged tail is left out."""
    groups: dict[int, str] = {}
    found: list[tuple[int, str, Any]] = []
    while position + 2 <= len(content):
        length = abs(int(np.int8(content[position] - 256 if content[position] > 127 else content[position])))
        number = content[position + 1] - 256 if content[position + 1] > 127 else content[position + 1]
        if length == 0 or number == 0:
            break
        name = content[position + 2 : position + 2 + length].decode("latin-1").strip().upper()
        link = position + 2 + length
        if link + 2 > len(content):
            break
        offset = int(machine.integers(content[link : link + 2])[0]) & 0xFFFF
        if number < 0:
            groups[-number] = name
        else:
            found.append((number, name, _value(content, link + 2, machine)))
        if offset == 0:
            break
        position = link + offset
    return {(groups.get(number, str(number)), name): value for number, name, value in found}


def _value(content: bytes, position: int, machine: Machine) -> Any:
    """An array of numbers in the file's order, or a list of strings; None where it is damaged."""
    if position + 2 > len(content):
        return None
    kind = content[position] - 256 if content[position] > 127 else content[position]
    rank = content[position + 1]
    shape = list(content[position + 2 : position + 2 + rank])
    start = position + 2 + rank
    count = int(np.prod(shape, dtype=np.int64)) if shape else 1
    size = abs(kind) * count
    if kind not in (-1, 1, 2, 4) or start + size > len(content):
        return None
    data = content[start : start + size]
    if kind == -1:
        width = shape[0] if shape else 1
        rows = count // width if width else 0
        return [data[k * width : (k + 1) * width].decode("latin-1").strip(" \0\t") for k in range(rows)]
    if kind == 1:
        return np.frombuffer(data, dtype=np.uint8)
    return machine.integers(data) if kind == 2 else machine.floats(data)
