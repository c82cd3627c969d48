"""Files that belong together: the frames of a clip, and the two halves of a recording.

OpenPose writes a file a frame, ``CLIP_000000000012_keypoints.json``. UI-PRMD parts a recording into ``…_positions.txt``
and ``…_angles.txt``, in one folder or in two, ``Positions`` and ``Angles``. One of the files stands for all.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from contextlib import suppress
from os import PathLike
from pathlib import Path

from leitmotion.motion import FormatError

_FRAME = re.compile(r"^(?P<clip>.*?)_?(?P<frame>\d+)_keypoints\.json$", re.IGNORECASE)

_KIND = re.compile(r"(positions|angles)(?!.*(?:positions|angles))", re.IGNORECASE)
OTHER = {"positions": "angles", "angles": "positions"}
"""Of each half of a recording the other."""


def frame_of(name: str) -> tuple[str, int] | None:
    """Tell the clip and the frame of which a file holds the poses, None for a name that says no such thing.

    Examples
    --------
    >>> frame_of("dance_000000000012_keypoints.json")
    ('dance', 12)
    """
    match = _FRAME.match(name)
    return (match["clip"], int(match["frame"])) if match else None


def clips_in(names: Iterable[str]) -> dict[str, dict[int, str]]:
    """Gather the names of files with a frame each by their clip.

    Examples
    --------
    >>> clips_in(["a_1_keypoints.json", "a_0_keypoints.json", "b.json"])
    {'a': {0: 'a_0_keypoints.json', 1: 'a_1_keypoints.json'}}
    """
    clips: dict[str, dict[int, str]] = {}
    for place, name in sorted((place, name) for name in names if (place := frame_of(name)) is not None):
        clips.setdefault(place[0], {})[place[1]] = name
    return clips


def clip_name(path: Path) -> str:
    """Name the clip of which a file holds one frame, after its folder where the file does not; else empty."""
    place = frame_of(path.name)
    return "" if place is None else place[0] or path.resolve().parent.name


def clip_files(path: Path) -> list[Path]:
    """List the files with the frames of the clip that a file is one of, in order; the file alone where it is none."""
    place = frame_of(path.name)
    if place is None or not path.parent.is_dir():
        return [path]
    names = clips_in(os.listdir(path.parent)).get(place[0], {place[1]: path.name})
    return [path.parent / name for name in names.values()]


def first_frame_in(path: Path) -> Path:
    """Name the file that stands for a folder of poses: the first frame of the only clip in it.

    Parameters
    ----------
    path : Path
        Anything; what is no folder, or one without files of a frame each, is returned as it is.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FormatError
        When the folder holds several clips; the sentence names them.
    """
    try:
        clips = clips_in(os.listdir(path))
    except (OSError, ValueError):  # no folder, or none that may be looked into: whoever opens it says so
        return path
    if len(clips) > 1:
        shown = ", ".join(repr(clip) for clip in list(clips)[:6])
        raise FormatError(
            f"The folder {path} holds the poses of {len(clips)} clips: {shown}{' …' if len(clips) > 6 else ''}.",
            remedy="Name a file of one of them.",
        )
    return path / min(next(iter(clips.values())).items())[1] if clips else path


def kind_of(name: str) -> str:
    """Tell which half of a recording a file holds, "positions", "angles" or, where its name says neither, "".

    Examples
    --------
    >>> kind_of("m01_s01_e01_angles.txt"), kind_of("m01.txt")
    ('angles', '')
    """
    match = _KIND.search(name)
    return match[0].lower() if match else ""


def partners(path: Path) -> list[Path]:
    """Say where the other half of a recording may be: beside it, else in the folder of its kind beside its own.

    Parameters
    ----------
    path : Path
        One of the halves.

    Returns
    -------
    list of Path
        Files that may or may not be there; none where the name says no half.
    """
    kind = kind_of(path.name)
    if not kind:
        return []
    name = _KIND.sub(lambda match: _as_written(OTHER[kind], match[0]), path.name)
    beside = [path.parent / name]
    if path.parent.name.lower() == kind:
        beside.append(path.parent.parent / _as_written(OTHER[kind], path.parent.name) / name)
    return beside


def others_read(path: Path, skeleton: str | PathLike[str] | None = None) -> list[Path]:
    """Say which other files of the disk are read with one: the rest of its clip, its other half, its skeleton.

    Parameters
    ----------
    path : Path
        A recording, or its address in an archive.
    skeleton : str or path, optional
        The skeleton that is given.

    Returns
    -------
    list of Path
        Those that are there, in a fixed order. What lies in the same archive is no other file.
    """
    from leitmotion.io.asf_search import find_asf
    from leitmotion.io.containers import bare, on_disk

    found = [*clip_files(path), *partners(path)]
    if bare(path).suffix.lower() == ".amc":
        with suppress(FormatError):
            found.append(Path(skeleton) if skeleton is not None else find_asf(path)[0])
    here = on_disk(path)
    return [each for each in dict.fromkeys(map(on_disk, found)) if each != here and each.is_file()]


def represented(paths: Iterable[Path]) -> set[Path]:
    """Tell which of some files another of them stands for: all frames of a clip but the first, angles beside positions.

    Examples
    --------
    >>> sorted(str(path) for path in represented([Path("a_positions.txt"), Path("a_angles.txt")]))
    ['a_angles.txt']
    """
    given = set(paths)
    by_folder: dict[Path, list[str]] = {}
    for path in given:
        by_folder.setdefault(path.parent, []).append(path.name)
    later = {
        folder / name
        for folder, names in by_folder.items()
        for frames in clips_in(names).values()
        for name in list(frames.values())[1:]
    }
    halves = {
        path
        for path in given
        if path.suffix.lower() == ".txt"
        and kind_of(path.name) == "angles"
        and given.intersection(partners(path))
    }
    return later | halves


def _as_written(word: str, like: str) -> str:
    """A word in capitals or small letters like another."""
    return word.upper() if like.isupper() else word.capitalize() if like[0].isupper() else word
