"""What was converted into a folder: so that a second run does only what is left, and replaces only what it made.

The ledger is a file of the folder, one line of JSON for each input: what it was (by its content), how it was converted
and what was written (by its content). A line is added before a new file is written and when it is done; one that an
interruption cut short, or that is none of ours, is passed over, which costs a conversion and nothing else.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from leitmotion import __version__

NAME = ".leitmotion-convert.jsonl"

Entry = dict[str, Any]


class Ledger:
    """The ledger of one folder.

    Parameters
    ----------
    folder : Path
        Where is written.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._entries = _read(folder / NAME)

    def written(self) -> set[Path]:
        """List the files that were written here, where they are now."""
        return {
            (self._folder / name).resolve() for entry in self._entries.values() for name in entry["written"]
        }

    def entry(self, target: Path, source: Path) -> Entry | None:
        """What was written at a place, None where nothing was or it came from another file."""
        held = self._entries.get(_name(self._folder, target))
        return held if held is not None and held["source"] == _name(self._folder, source) else None

    def add(self, target: Path, source: Path, facts: Entry) -> None:
        """Note what was done; a folder that takes no more is no fault of the conversion."""
        entry = _entry(self._folder, target, source, facts)
        if self._entries.get(entry["target"]) == entry:
            return
        self._entries[entry["target"]] = entry
        _note(self._folder, entry)

    def close(self) -> None:
        """Write the ledger anew, each input once and in order; another run's lines are kept."""
        from leitmotion.io import write_whole
        from leitmotion.motion.errors import FormatError

        entries = _read(self._folder / NAME) | self._entries
        if entries:
            with contextlib.suppress(FormatError):
                write_whole(
                    self._folder / NAME, "".join(f"{_line(entries[name])}\n" for name in sorted(entries))
                )


def plan(folder: Path, target: Path, source: Path, facts: Entry, *, before: Entry | None) -> None:
    """Note what is about to be written where nothing was, so that it is known as ours if this run is killed.

    What was converted before stays as it is noted, for it is still there; so that nothing is skipped for this line.
    """
    held = {} if before is None else before["written"]
    if facts["written"].keys() - held.keys():
        kept = facts if before is None else before
        _note(folder, _entry(folder, target, source, {**kept, "written": facts["written"] | held}))


def _entry(folder: Path, target: Path, source: Path, facts: Entry) -> Entry:
    return {**facts, "target": _name(folder, target), "source": _name(folder, source)}


def _name(folder: Path, path: Path) -> str:
    """A path as seen from a folder, the same wherever the program is called from."""
    here, there = folder.resolve(), path.parent.resolve() / path.name
    try:
        return Path(os.path.relpath(there, here)).as_posix()
    except ValueError:  # on another drive
        return there.as_posix()


def _note(folder: Path, entry: Entry) -> None:
    """Add a line to the ledger of a folder, where it takes one."""
    from leitmotion.io.files import append_line

    with contextlib.suppress(OSError):
        append_line(folder / NAME, _line(entry))


def facts(
    *,
    sha256: str,
    others: str,
    parameters: Mapping[str, object],
    written: Mapping[str, str],
    told: Mapping[str, object],
) -> Entry:
    """Make what the ledger keeps of a conversion.

    Parameters
    ----------
    sha256, others : str
        Checksums of the source, and of the other files that are read with it.
    parameters : mapping
        How it was converted.
    written : mapping of str to str
        The files by their names from the folder on, and their checksums.
    told : mapping
        What the answer said.
    """
    return {
        "leitmotion": __version__,
        "sha256": sha256,
        "others": others,
        "parameters": dict(parameters),
        "written": dict(written),
        "told": dict(told),
    }


def still_holds(
    entry: Entry, folder: Path, *, sha256: str, others: str, parameters: Mapping[str, object]
) -> bool:
    """Tell whether a conversion need not be done again: same source, same way, and all that it wrote still there."""
    now = facts(sha256=sha256, others=others, parameters=parameters, written={}, told={})
    return all(entry[what] == now[what] for what in ("leitmotion", "sha256", "others", "parameters")) and all(
        checksum(folder / name) == held for name, held in entry["written"].items()
    )


def checksum(path: Path) -> str:
    """SHA-256 of a file in hexadecimal, nothing where there is none to read."""
    from leitmotion.io import files

    try:
        return files.checksum(path)
    except OSError:
        return ""


def checksum_of_all(paths: Sequence[Path]) -> str:
    """One checksum of several files, by their names and contents; nothing of none."""
    each = "".join(f"{path.name}\0{checksum(path)}\n" for path in paths)
    return hashlib.sha256(each.encode("utf-8", "surrogateescape")).hexdigest() if each else ""


def _line(entry: Entry) -> str:
    return json.dumps(entry, sort_keys=True)


def _read(path: Path) -> dict[str, Entry]:
    """The entries of a ledger by target, the last of each; lines that are none are passed over."""
    from leitmotion.io.files import read_bytes
    from leitmotion.motion.errors import FormatError

    entries: dict[str, Entry] = {}
    try:
        lines = read_bytes(path).decode("utf-8", "replace").split("\n")
    except FormatError:
        return entries
    for line in lines:
        with contextlib.suppress(ValueError, TypeError, KeyError):
            entry = json.loads(line)
            if all(isinstance(entry[name], kind) for name, kind in _KINDS.items()):
                entries[entry["target"]] = entry
    return entries


_KINDS = {
    "target": str, "source": str, "leitmotion": str, "sha256": str,
    "others": str, "parameters": dict, "written": dict, "told": dict,
}  # fmt: skip
