"""The page of a recording: written, and opened in the browser."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from leitmotion.cli.finding import warnings_of
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import will_be_written
from leitmotion.cli.progress import Progress

if TYPE_CHECKING:
    from leitmotion.api import Mirrored, MotionGraph, Patterns, Segmentation, Symmetry
    from leitmotion.cli.recordings import Opened


def write_page(
    page: Path,
    opened: Opened,
    found: Patterns,
    options: Options,
    progress: Progress,
    *,
    labels: Segmentation | None = None,
    labels_from: str = "",
    notes: Sequence[str] = (),
    opens_with: str = "repeats",
    mirrored: Mirrored | None = None,
    symmetry: Symmetry | None = None,
    graph: MotionGraph | None = None,
) -> str:
    """Write the page that shows what recurs in a recording.

    Parameters
    ----------
    page : Path
        The file.
    opened : Opened
        The recording.
    found : Patterns
        What recurs in it.
    options : Options
        Which joints were compared.
    progress : Progress
        Told what is being done.
    labels : Segmentation, optional
        Labels from elsewhere.
    labels_from : str
        Where they are from.
    notes : sequence of str
        What else the person should know, about the labels.
    opens_with : {"repeats", "lesson", "symmetry", "graph"}
        What the page shows first.
    mirrored : Mirrored, optional
        The recording beside its mirror image, as it was asked for.
    symmetry : Symmetry, optional
        The motifs that were found in it.
    graph : MotionGraph, optional
        Its motion graph, likewise.

    Returns
    -------
    str
        What to tell of it.
    """
    from leitmotion.api import report

    progress.say(f"Writing {page.name}")
    told = will_be_written(page)
    report(
        opened.recording,  # with its rotations, which tell symmetry what places do not
        page,
        body_map=opened.roles,
        labels=labels,
        labels_from=labels_from,
        patterns=found,
        source=(opened.source[0] if opened.source else {})
        | {"warnings": [*warnings_of(opened, found), *notes]},
        joints=options.joints or None,
        exclude=options.exclude,
        opens_with=opens_with,
        mirrored=mirrored,
        symmetry=symmetry,
        graph=graph,
        force=True,  # whether the page may be replaced was asked before any work
    )
    return told


def open_page(page: Path) -> bool:
    """Show a page in the browser, when this machine has a screen.

    Parameters
    ----------
    page : Path
        An HTML file.

    Returns
    -------
    bool
        Whether a browser was asked to.
    """
    screen = sys.platform in ("win32", "darwin") or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "WSL_DISTRO_NAME")
    )
    if not screen:
        return False
    import webbrowser

    return webbrowser.open(page.resolve().as_uri())
