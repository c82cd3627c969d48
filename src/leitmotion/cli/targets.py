"""Where each of several inputs is written: in the new folder as it stood in the one that was named, no two alike."""

from __future__ import annotations

import os
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import click

from leitmotion.cli.inputs import Input


@dataclass(frozen=True)
class Targets:
    """Where the inputs are written, in their order."""

    paths: tuple[Path, ...]
    remark: str = ""
    """Which of them could not have the name that one expects; empty where all could."""


def plan(inputs: Sequence[Input], folder: Path, extension: str) -> Targets:
    """Name a file of a folder for each input.

    What was found in a folder keeps its place under it; where several folders were named, each keeps its own name.
    Inputs that would get one name keep what tells them apart: their extension (``walk.amc.c3d``, ``walk.bvh.c3d``),
    their window (``walk.2s-5s.c3d``), else they get a number (``walk-2.c3d``).

    Parameters
    ----------
    inputs : sequence of Input
        What is converted.
    folder : Path
        Where to.
    extension : str
        What the new files end in, with the dot.

    Returns
    -------
    Targets
        A path for each, all different, also where a file system minds neither case nor accents' spelling.
    """
    several = len({given.folder for given in inputs if given.folder}) > 1
    places = [_place(given, several=several) for given in inputs]
    groups: dict[str, list[int]] = {}
    for k, place in enumerate(places):
        groups.setdefault(_key(place), []).append(k)
    taken = {key for key, members in groups.items() if len(members) == 1}
    named: dict[int, Path] = {}
    apart: list[list[int]] = []
    for members in groups.values():
        if len(members) == 1:
            named[members[0]] = places[members[0]]
            continue
        _refuse_twice([inputs[k] for k in members])
        extensions = {_ending(inputs[k]).lower() for k in members}
        for k in members:
            own = places[k].name + (_ending(inputs[k]) if len(extensions) > 1 else "")
            own += inputs[k].window.replace("[", ".").replace(":", "-").replace("]", "").replace(" ", "")
            place, count = places[k].with_name(own), 1
            while _key(place) in taken:
                count += 1
                place = places[k].with_name(f"{own}-{count}")
            taken.add(_key(place))
            named[k] = place
        apart.append(members)
    paths = (folder / named[k].with_name(named[k].name + extension) for k in range(len(inputs)))
    return Targets(tuple(paths), _remark(apart, inputs, named, extension))


def identity(path: Path) -> str:
    """Tell a place from others, however it is written and whether or not something is there."""
    return _key(path.parent.resolve() / path.name)


def _place(given: Input, *, several: bool) -> Path:
    """Where an input stands under the folder that was named, without ending."""
    from leitmotion.io.containers import archive_name, on_disk

    if not given.folder:
        return Path(given.name)
    root, archive = Path(given.folder), on_disk(given.path)
    beneath = os.path.relpath(given.path.parent, root)
    if archive not in (
        root,
        given.path,
    ):  # what an archive in the folder holds stands in a folder of its name
        beneath = os.path.relpath(
            archive.with_name(archive_name(archive)) / given.path.parent.relative_to(archive), root
        )
    own = root.resolve()
    top = archive_name(own) if archive == root else own.name
    return Path(top) / beneath / given.name if several else Path(beneath) / given.name


def _ending(given: Input) -> str:
    """What the name of a file has beyond that of its recording, ``.bvh.gz``."""
    name = given.path.name
    return name.removeprefix(given.name) if name.startswith(given.name) else given.path.suffix


def _key(place: Path) -> str:
    return unicodedata.normalize("NFC", str(place)).casefold()


def _remark(
    apart: list[list[int]], inputs: Sequence[Input], named: Mapping[int, Path], extension: str
) -> str:
    if not apart:
        return ""
    first = [f"{inputs[k].shown} becomes {named[k].name}{extension}" for k in apart[0][:3]]
    count = sum(len(members) for members in apart)
    more = f", and so on: {count} in all" if count > len(first) else ""
    return f"Inputs of one name are told apart: {', '.join(first)}{more}."


def _refuse_twice(inputs: Sequence[Input]) -> None:
    seen: set[tuple[str, str]] = set()
    for given in inputs:
        what = (os.path.abspath(given.path), given.window)
        if what in seen:
            raise click.UsageError(f"{given.shown} is named twice.")
        seen.add(what)
