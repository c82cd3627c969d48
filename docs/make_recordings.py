"""Read every recording at hand, and write what was understood of it: ``python docs/make_recordings.py [SHEETS]``.

Reads the folder that ``LEITMOTION_DATA`` names: every loose file of a known format, and of each archive in it
(``.zip``, ``.tar.xz`` and the like) some members, spread evenly; archives are unpacked once into the folder that
``LEITMOTION_CACHE`` names, else ``~/.cache/leitmotion``. Rewrites ``recordings.md``. With SHEETS, a folder, it also
draws one frame of each, many to a page, for a person to look at; those pages hold the data and are not committed.
"""

from __future__ import annotations

import math
import os
import re
import shutil
import sys
import tarfile
import tempfile
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import leitmotion as lm
from leitmotion.body import ANALYSIS_ROLES
from leitmotion.io import EXTENSIONS, Finding
from leitmotion.io.companions import represented

PAGE = Path(__file__).resolve().parent / "recordings.md"
ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2")
OF_EACH_ARCHIVE = 6
COLUMNS = (
    "recording", "format", "frames", "rate", "unit", "up", "facing", "size", "people", "roles", "problems",
)  # fmt: skip

INTRODUCTION = f"""# Recordings

What Leitmotion understands of real recordings: written by `make docs-recordings`, which reads the folder that
`LEITMOTION_DATA` names, and some files of each archive in it.

- A question mark: the file does not say, and it was guessed.
- *Facing* is which way the person faces: 0° towards +Z, 90° towards +X. *Size* is the way from ankle to head along the
  joints, in metres where the unit is a length.
- *Roles* are those found of the {len(ANALYSIS_ROLES)} that analyses compare.
- *Problems* are those that `leitmotion info` tells in full.
"""


class Row(NamedTuple):
    """One file, and what came of it."""

    name: str
    """Its path from the folder on."""

    path: Path
    """Where it is on this machine; in no table."""

    cells: tuple[str, ...] = ()
    """What was understood, column by column; empty where it was not read."""

    error: str = ""
    """The sentence that says why it was not read."""


def main(arguments: Sequence[str]) -> int:
    """Write the table, and the sheets where a folder is named."""
    data = os.environ.get("LEITMOTION_DATA", "")
    if not Path(data).is_dir() or not data:
        print("LEITMOTION_DATA must name the folder of recordings.", file=sys.stderr)
        return 2
    rows = [understood(name, path) for name, path in recordings(Path(data))]
    PAGE.write_text(page(rows), encoding="utf-8")
    read = [row for row in rows if row.cells]
    print(f"{len(read)} of {len(rows)} files were read: {PAGE}")
    if arguments:
        from draw_recordings import draw

        for sheet in draw([(row.name, row.path) for row in read], Path(arguments[0])):
            print(sheet)
    return 0


def recordings(data: Path) -> Iterator[tuple[str, Path]]:
    """Every loose file of a known format, and some of each archive, by their names from the folder on."""
    loose = [path for path in _files(data) if _known(path)]
    found = [(path.relative_to(data).as_posix(), path) for path in _standing_for_all(loose)]
    for archive in _files(data):
        if archive.name.lower().endswith(ARCHIVES):
            name = archive.relative_to(data).as_posix()
            folder = unpacked(archive, name)
            members = _standing_for_all([path for path in _files(folder) if _readable(path)])
            step = max(1, math.ceil(len(members) / OF_EACH_ARCHIVE))
            found += [(f"{name}/{path.relative_to(folder).as_posix()}", path) for path in members[::step]]
    yield from sorted(found)


def _files(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file())


def _standing_for_all(paths: Sequence[Path]) -> list[Path]:
    """Without those that another file stands for: the later frames of a clip, the second half of a recording."""
    others = represented(paths)
    return [path for path in paths if path not in others]


def _known(path: Path) -> bool:
    return path.suffix.lower() in EXTENSIONS


def _readable(path: Path) -> bool:
    return any(form.module for form in EXTENSIONS.get(path.suffix.lower(), ()))


def unpacked(archive: Path, name: str) -> Path:
    """Unpack an archive into the cache, whole or not at all, where that has not been done."""
    cache = Path(os.environ.get("LEITMOTION_CACHE") or Path.home() / ".cache" / "leitmotion") / "recordings"
    target = cache / name.replace("/", "_")
    if target.is_dir():
        return target
    cache.mkdir(parents=True, exist_ok=True)
    scratch = Path(tempfile.mkdtemp(dir=cache))
    try:
        if archive.name.lower().endswith(".zip"):
            with zipfile.ZipFile(archive) as box:
                box.extractall(scratch)
        else:
            with tarfile.open(archive) as box:
                box.extractall(scratch, filter="data")
        scratch.rename(target)
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    return target


def understood(name: str, path: Path) -> Row:
    """Read a file, and say what is known of it."""
    try:
        told = lm.info(path)
    except lm.LeitmotionError as error:
        sentence = f"{error.message} {error.remedy}".strip().replace(f"{path.parent}{os.sep}", "")
        return Row(name, path, error=sentence)
    found = told.findings
    roles = sum(role in told.roles.roles for role in ANALYSIS_ROLES)
    cells = (
        name,
        _format(path),
        f"{told.frames:,}",
        _cell(found["rate"], "{:g} Hz"),
        _cell(found["unit"], "{}"),
        _cell(found["up"], "{}"),
        _cell(found.get("facing"), "{:.0f}°", math.degrees),
        _cell(found.get("size"), "{:.2f}"),
        str(len(told.people)),
        str(roles),
        ", ".join(problem.what for problem in told.problems),
    )
    return Row(name, path, cells)


def _format(path: Path) -> str:
    from leitmotion.io.formats import recognise

    form = recognise(path.read_bytes()[:4096], path.suffix)
    return form.name if form else ""


def _cell(finding: Finding | None, pattern: str, convert: object = None) -> str:
    """A finding as a cell, with a question mark where it was guessed and belongs to the file."""
    if finding is None or finding.value is None:
        return "–"
    value = convert(finding.value) if callable(convert) else finding.value
    mark = "?" if finding.how == "guessed" and convert is None and pattern != "{:.2f}" else ""
    return pattern.format(value).replace("-0°", "0°") + mark


def page(rows: Sequence[Row]) -> str:
    """Format the page: what was read, by folder, and what was not."""
    read, refused = [row for row in rows if row.cells], [row for row in rows if not row.cells]
    lines = [INTRODUCTION, "## Read", "", *_table(COLUMNS, [row.cells for row in read]), ""]
    if refused:
        lines += ["## Not read", "", *_table(("files", "why"), _by_reason(refused)), ""]
    return "\n".join(lines)


def _by_reason(rows: Sequence[Row]) -> list[tuple[str, str]]:
    """Files of one folder that were refused for one reason, whatever the counts in it, on one line."""
    groups: dict[tuple[str, str], list[tuple[str, str]]] = {}
    for row in rows:
        folder, _, file = row.name.rpartition("/")
        reason = row.error.replace(f"{file}: ", "").replace(file, "it")
        reason = reason[:1].upper() + reason[1:]
        groups.setdefault((folder, re.sub(r"\d+", "0", reason)), []).append((row.name, reason))
    return [
        (held[0][0] + (f" and {len(held) - 1} more" if len(held) > 1 else ""), held[0][1])
        for held in groups.values()
    ]


def _table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    made = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return made + ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
