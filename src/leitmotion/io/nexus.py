"""Nexus CSV: the trajectories that Vicon Nexus exports.

A section begins with its name alone (``Trajectories``), then come the rate, the markers over three columns each, the
axes, their units, and a row a frame up to an empty line. Other sections (``Devices``, ``Model Outputs``) are passed
over.
"""

from __future__ import annotations

import re
from dataclasses import replace

from leitmotion.io.columns import read_rows_of
from leitmotion.io.reading import Draft, Source
from leitmotion.io.text import cells_of

_SECTION = re.compile(
    rb'^"?(Trajectories|Devices|Model Outputs|Joints|Segments|Events)"?[,;\t ]*\r?\n', re.MULTILINE
)


def looks(head: bytes) -> bool:
    """Whether a file that begins like this is one."""
    text = head.removeprefix(b"\xef\xbb\xbf").lstrip()
    return re.match(_SECTION, text) is not None


def read(source: Source) -> Draft:
    """Read the markers of a Nexus CSV.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a subject prefix, else one.

    Raises
    ------
    FormatError
        When it holds no trajectories, or is not what the format says; it names the line.
    """
    sections = {match[1].decode(): match.end() for match in _SECTION.finditer(source.content)}
    if "Trajectories" not in sections:
        raise source.error(
            f"expected a section Trajectories, found {', '.join(sections)}.",
            remedy="Export the trajectories from Nexus.",
        )
    start = sections["Trajectories"]
    end = re.search(rb"^[,;\t ]*\r?\n", source.content[start:], re.MULTILINE)
    if end is not None:
        source = replace(source, content=source.content[: start + end.start()])
    lines, start = _lines(source, start)
    delimiter = max(",\t;", key=lines[2].count)
    rate, markers, axes, units = ([cell.strip() for cell in cells_of(line, delimiter)] for line in lines)
    if axes[:1] != ["Frame"]:
        raise source.error(f"expected a row that begins with Frame, found {', '.join(axes[:4])}.")
    markers += [""] * len(axes)
    header, name = [], ""
    for k, axis in enumerate(axes):
        name = markers[k] or name
        header.append(f"{name}_{axis.lower()}" if axis in ("X", "Y", "Z") else axis)
    stated = {"rate": rate[0] if rate else "", "unit": next((unit for unit in units if unit), "")}
    return read_rows_of(source, start, header, delimiter, stated, exact=True)


def _lines(source: Source, start: int) -> tuple[list[str], int]:
    """The four lines after the name of the section, and the byte after them; no unit where it is left out."""
    lines: list[str] = []
    for _ in range(4):
        stop = source.content.find(b"\n", start)
        line = source.content[start : stop if stop >= 0 else None].decode("utf-8", "replace").rstrip("\r")
        if len(lines) == 3 and re.match(r"\d", line):
            lines.append(",")
            break
        if stop < 0:
            raise source.error("expected rate, markers, axes and units after Trajectories, found the end.")
        lines.append(line)
        start = stop + 1
    return lines, start
