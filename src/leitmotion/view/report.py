"""The page: one self-contained HTML file, assembled of its parts.

Conventions
-----------
The parts lie in ``page/``: ``page.html``, ``style.css`` and the scripts of ``js/``, which are joined in the order of
:data:`SCRIPTS` inside one function. The page asks nothing of anywhere: its policy forbids every request and runs the
one script and the one style sheet whose hashes it names.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import re
from importlib.resources import files
from pathlib import Path
from typing import Any

from leitmotion.body import Body, Dynamics
from leitmotion.discovery import MotionGraph, Patterns
from leitmotion.motion import ParameterError, Segmentation
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view.graph_words import NOT_COMPUTED as NO_GRAPH
from leitmotion.view.payload import page_payload
from leitmotion.view.symmetry_answer import NOT_COMPUTED
from leitmotion.view.symmetry_payload import Mirroring

SCRIPTS = (
    "data", "theme", "state", "words", "views", "space", "mirror", "figure", "stage", "differences", "cameras",
    "matrix", "matrix_mirror", "stripes", "pointing", "timeline", "sheets", "row_strip", "row_lanes", "row_motifs",
    "row_shared", "row_labels", "row_curve", "panel", "panel_mirror", "table", "table_motifs", "save", "play",
    "lesson", "beside", "graph", "graph_field", "graph_list", "row_graph", "table_graph", "keys", "main",
)  # fmt: skip
"""The parts of the script, in the order in which they are joined: each uses only those before it when it loads."""

GENERATOR = b'name="generator" content="Leitmotion'
"""Stands near the start of every page."""


def report_page(
    body: Body,
    patterns: Patterns,
    matrix: SimilarityMatrix,
    *,
    source: dict[str, Any],
    labels: Segmentation | None = None,
    labels_from: str = "",
    mirroring: Mirroring | str = NOT_COMPUTED,
    dynamics: Dynamics | None = None,
    graph: MotionGraph | str = NO_GRAPH,
    opens_with: str = "repeats",
) -> str:
    """Draw what recurs in a recording as one HTML page that needs nothing beside it.

    Parameters
    ----------
    body : Body
        The person, at the recording's own rate.
    patterns : Patterns
        What recurs; may be none, the page is worth opening all the same.
    matrix : SimilarityMatrix
        Every moment of `body` against every other; its rate may be lower than the body's.
    source : dict
        Where the recording is from: ``path`` and whatever else the JSON contract tells.
    labels : Segmentation, optional
        What someone wrote about the recording, shown beside the finding.
    labels_from : str
        The file name of the labels.
    mirroring : Mirroring or str
        Symmetry, or a sentence that says why there is none.
    dynamics : Dynamics, optional
        Of the body, for curves.
    graph : MotionGraph or str
        States and paths, racemized where it can be, or a sentence that says why there are none.
    opens_with : {"repeats", "lesson", "symmetry", "graph"}
        What the page shows first.

    Returns
    -------
    str
        The page.

    Raises
    ------
    ParameterError
        When the matrix is not square or does not cover the body.
    """
    return assembled(
        page_payload(
            body,
            patterns,
            matrix,
            source=source,
            labels=labels,
            labels_from=labels_from,
            mirroring=mirroring,
            dynamics=dynamics,
            graph=graph,
            opens_with=opens_with,
        )
    )


def assembled(payload: dict[str, Any]) -> str:
    """Put what a page holds, its script and its style into the one file.

    Parameters
    ----------
    payload : dict
        The document of :func:`page_payload` or :func:`shared_payload`.

    Returns
    -------
    str
        The page.
    """
    script, style = _script(), _part("style.css")
    policy = (
        f"default-src 'none'; script-src '{_hash(script)}'; style-src '{_hash(style)}'; "
        "img-src data: blob:; base-uri 'none'; form-action 'none'"
    )
    replacements = {
        "policy": policy,
        "name": html.escape(payload["source"]["name"]),
        "title": html.escape(payload["title"]),
        "style": style,
        "payload": json.dumps(payload, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c"),
        "script": script,
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda slot: replacements[slot[1]], _part("page.html"))


def check_page(target: Path, *, force: bool) -> None:
    """Refuse a place for a page that is none, or holds a page that Leitmotion did not write.

    Parameters
    ----------
    target : Path
        Where the page is to be written.
    force : bool
        Whether somebody else's page may be replaced.

    Raises
    ------
    ParameterError
        When the name does not end in ``.html``, or the file is somebody else's.
    """
    if target.suffix.lower() != ".html":
        raise ParameterError(f"A page ends in .html, got {target.name!r}.")
    if target.is_file() and not force and not is_ours(target):
        raise ParameterError(
            f"{target} exists, and Leitmotion did not write it.", remedy="Replace it with force=True."
        )


def is_ours(path: Path) -> bool:
    """Tell whether a file is a page that Leitmotion wrote.

    Parameters
    ----------
    path : Path
        A file.

    Returns
    -------
    bool
        Whether it says so near its start.
    """
    with path.open("rb") as file:
        return GENERATOR in file.read(4096)


def _script() -> str:
    """All parts inside one function, so that the page's only global is its description of itself."""
    parts = "\n".join(_part(f"js/{name}.js") for name in SCRIPTS)
    return f'(() => {{\n"use strict";\n{parts}\n}})();\n'


def _part(name: str) -> str:
    return files("leitmotion.view").joinpath("page", name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    digest = hashlib.sha256(text.encode("utf-8")).digest()
    return "sha256-" + base64.b64encode(digest).decode("ascii")
