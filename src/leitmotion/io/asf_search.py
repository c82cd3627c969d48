"""Where to find the ASF that belongs to an AMC."""

from __future__ import annotations

import re
from pathlib import Path

from leitmotion.io.containers import bare, listing
from leitmotion.motion import FormatError

_PARENTS = 3  # how many folders above the AMC are searched


def find_asf(amc: Path) -> tuple[Path, str]:
    """Find the ASF that belongs to an AMC.

    In the AMC's folder, then in up to three folders above, the one whose name shares the longest leading tokens with
    the AMC's (``86_09`` → ``86``, ``HDM_mm_…`` → ``HDM_mm``); where none shares any, the only one there.

    Parameters
    ----------
    amc : Path
        The recording.

    Returns
    -------
    tuple of Path and str
        The skeleton, and why it is this one.

    Raises
    ------
    FormatError
        When there is none, or several and none fits; it lists them.
    """
    wanted = _tokens(amc)
    seen: list[Path] = []
    folder = amc.resolve().parent
    for _ in range(_PARENTS + 1):
        here = sorted(p for p in listing(folder) if bare(p).suffix.lower() == ".asf")
        scored = [(_shared(wanted, _tokens(path)), path) for path in here]
        best = max((score for score, _ in scored), default=0)
        if best > 0:
            nearest = next(path for score, path in scored if score == best)
            return nearest, "its name shares the longest beginning with the AMC's"
        seen += here
        if folder.parent == folder:
            break
        folder = folder.parent
    if len(seen) == 1:
        return seen[0], "it is the only ASF file in the AMC's folder and above"
    found = f"{len(seen)} of other names: {', '.join(p.name for p in seen[:8])}" if seen else "none"
    raise FormatError(
        f"{amc.name}: expected its skeleton, an ASF file that starts like it, in its folder or up to three above, "
        f"found {found}.",
        remedy="Name it with --skeleton FILE (skeleton= in Python).",
    )


def _tokens(path: Path) -> list[str]:
    return [token for token in re.split(r"[_\-\s.]+", bare(path).stem.lower()) if token]


def _shared(wanted: list[str], offered: list[str]) -> int:
    """Leading tokens in common, times two; minus one if the skeleton's name goes on otherwise."""
    count = 0
    for a, b in zip(wanted, offered):
        if a != b:
            break
        count += 1
    return 0 if count == 0 else 2 * count - (count < len(offered))
