"""How a file that is there tells that Leitmotion wrote it, so that the next answer may take its place.

A page, a picture, a document, a table and a saved search say so themselves: by a word near their start or end, or by
the columns of a table. ELAN's file loses the remark as soon as ELAN saves it, with the work that a person put in. A
recording tells nothing: it is compared with what would be written, by :func:`leitmotion.conversion.refuse_other`.
"""

from __future__ import annotations

import importlib
import os
import re
from collections.abc import Callable
from pathlib import Path

WITH_TABLES = (
    "info",
    "calibrate",
    "patterns",
    "residual",
    "across",
    "lesson",
    "summary",
    "evaluate",
    "postures",
    "mirrored",
    "symmetry",
    "shares",
    "graph",
    "dynamics",
)
"""Modules of this package with the ``COLUMNS`` of a table that they write."""
CREATOR = "Leitmotion"
"""What pictures name as the program that made them."""
_ENDS = 4096  # bytes at the start and at the end of a file that are looked at


def is_ours(path: Path) -> bool:
    """Tell whether a file is empty, or an answer that Leitmotion wrote.

    Parameters
    ----------
    path : Path
        A file; its ending says what to look for.

    Returns
    -------
    bool
        False also where it cannot be read.
    """
    tells = _TELLS.get(path.suffix.lower())
    try:
        with path.open("rb") as file:
            head = file.read(_ENDS)
            file.seek(-min(_ENDS, os.fstat(file.fileno()).st_size), os.SEEK_END)
            tail = file.read()
    except OSError:
        return False
    return not head or (tells is not None and tells(head, tail))


def _page(head: bytes, tail: bytes) -> bool:
    from leitmotion.view.report import GENERATOR

    return GENERATOR in head


def _picture(head: bytes, tail: bytes) -> bool:
    """A PNG and an SVG name their creator at the start, a PDF at the end."""
    return re.search(rb"(Software\0|<dc:title>|/Creator \()" + CREATOR.encode(), head + tail) is not None


def _document(head: bytes, tail: bytes) -> bool:
    return re.match(rb'\s*\[?\s*\{\s*"leitmotion"\s*:\s*"[^"]*"\s*,\s*"verb"', head) is not None


def _table(head: bytes, tail: bytes) -> bool:
    first = head.partition(b"\n")[0].rstrip(b"\r").decode("utf-8", "replace")
    modules = (importlib.import_module(f"leitmotion.cli.{name}") for name in WITH_TABLES)
    return any(first == ",".join(module.COLUMNS)[:_ENDS] for module in modules)  # no more was looked at


def _search(head: bytes, tail: bytes) -> bool:
    """A saved answer, by the header of its archive; a recording is saved in the same format."""
    kinds = rb"(Shared)?Patterns|SimilarityMatrix|DoubleMetric|Symmetry|MotionGraph|Dynamics"
    return re.search(rb'"noun": "[\w.]+:(' + kinds + rb')"', head) is not None


def _annotations(head: bytes, tail: bytes) -> bool:
    from leitmotion.io.elan_writing import REMARK

    return REMARK.encode() in head


def _graph(head: bytes, tail: bytes) -> bool:
    from leitmotion.view.graph_text import MADE_BY

    return MADE_BY.encode() in head


_TELLS: dict[str, Callable[[bytes, bytes], bool]] = {
    ".html": _page,
    ".png": _picture,
    ".svg": _picture,
    ".pdf": _picture,
    ".json": _document,
    ".csv": _table,
    ".npz": _search,
    ".graphml": _graph,
    ".eaf": _annotations,
}
