"""From what a person types to recordings: paths, windows, people.

A source is a path, or a path and a window in brackets: ``clip.bvh[12s:45s]`` in seconds, ``clip.bvh[100:400]`` in
frames, half-open, either end left out. A file whose name really ends in brackets wins over the window. The path may
go on inside a zip or tar archive, ``pack.zip/clip.bvh``.
"""

from __future__ import annotations

import os
import re
from os import PathLike
from pathlib import Path

from leitmotion.io.companions import first_frame_in
from leitmotion.io.conform import conform, refuse_useless
from leitmotion.io.containers import exists, read_file
from leitmotion.io.formats import Format, is_misnamed, readable, recognise
from leitmotion.io.points import distinct
from leitmotion.io.reading import Options, Reading, Source
from leitmotion.io.text import as_text, is_wide
from leitmotion.motion import DataError, FormatError, Motion, ParameterError, Trajectories
from leitmotion.motion.errors import in_one_line

_WINDOW = re.compile(r"^(?P<path>.+)\[(?P<start>[^\[\]:]*):(?P<stop>[^\[\]:]*)\]$", re.DOTALL)
_HEAD = 4096


def read(
    source: str | PathLike[str],
    *,
    skeleton: str | PathLike[str] | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    rate: float | None = None,
    person: str | int | None = None,
    trust: bool = False,
) -> Motion | Trajectories:
    """Read the recording of one person.

    Parameters
    ----------
    source : str or path
        A file, or a file and a window: ``"clip.bvh[12s:45s]"``, ``"clip.bvh[100:400]"``. It may be compressed
        (``"clip.bvh.gz"``), an archive of one recording, or a file in one: ``"pack.zip/clip.bvh"``. A folder with
        the poses of one recording, a file a frame as OpenPose writes them, is a file, too.
    skeleton : str or path, optional
        The ASF of an AMC; else it is looked for beside the AMC and above.
    unit : str or float, optional
        Unit of length of the file, a name ("m", "cm", "mm", "inch", "1/0.45 inch") or a number of metres; else what
        the file states or what the body's size suggests.
    up : str, optional
        The file's vertical, "x", "y", "z", "-x", "-y" or "-z"; else what the file states or the body suggests.
    rate : float, optional
        Frames per second; else what the file states.
    person : str or int, optional
        Who, by name or counted from 1, where a file holds several.
    trust : bool
        Whether to read a file that holds pickled Python objects. Reading one can run any code that its author put
        there; say so only of files whose author you trust.

    Returns
    -------
    Motion or Trajectories
        In metres, Y up, right-handed.

    Raises
    ------
    FormatError
        When the file is missing or is not what its format says.
    DataError
        When it holds several people and `person` is not given; the sentence names them.
    """
    reading = open_recording(
        source, skeleton=skeleton, unit=unit, up=up, rate=rate, person=person, trust=trust
    )
    if len(reading.recordings) > 1:
        raise DataError(
            f"{reading.path.name} holds {len(reading.recordings)} people: {', '.join(reading.people)}.",
            remedy="Choose one with --person NAME (person= in Python).",
        )
    return reading.recordings[0]


def read_all(
    source: str | PathLike[str],
    *,
    skeleton: str | PathLike[str] | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    rate: float | None = None,
    person: str | int | None = None,
    trust: bool = False,
) -> list[Motion | Trajectories]:
    """Read the recordings of every person in a file; parameters as in :func:`read`.

    Returns
    -------
    list of Motion or Trajectories
        One a person, in the file's order.
    """
    return list(
        open_recording(
            source, skeleton=skeleton, unit=unit, up=up, rate=rate, person=person, trust=trust
        ).recordings
    )


def open_recording(
    source: str | PathLike[str],
    *,
    skeleton: str | PathLike[str] | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    rate: float | None = None,
    person: str | int | None = None,
    trust: bool = False,
) -> Reading:
    """Read a file and tell how it was understood; parameters as in :func:`read`.

    Returns
    -------
    Reading
        The recordings, what was read, guessed or given about them, and what is odd.

    Raises
    ------
    FormatError
        When the file is missing or is not what its format says.
    DataError
        When the person or the window is not in the file.
    """
    path, window = split_window(source)
    try:
        return _open(path, window, Options(skeleton, unit, up, rate, trust), person)
    except MemoryError:
        raise DataError(
            f"{path.name} needs more memory than there is.", remedy="Cut it into parts, or free some memory."
        ) from None


def _open(path: Path, window: tuple[str, str] | None, options: Options, person: str | int | None) -> Reading:
    path, content = read_file(first_frame_in(path))
    form = _format_of(path, content)
    warnings: list[str] = []
    if is_misnamed(form, path.suffix):
        warnings.append(
            f"Its name ends in {path.suffix}, but it begins like {form.name} and was read as that."
        )
    if form.text:
        content = as_text(path, content, warnings)
    opened = Source(path, content, options)
    draft = form.read(opened)
    refuse_useless(opened, draft)
    draft.warnings += warnings
    for take, own in zip(draft.takes, distinct([take.person for take in draft.takes], draft.warnings)):
        take.person = own
    recordings, findings = conform(draft, options, draft.name or _as_text(path.stem))
    people = tuple(take.person for take in draft.takes)
    recordings, people = _choose(recordings, people, person, path)
    frames = None
    if window is not None:
        frames = _frames_of(window, recordings[0].rate, len(recordings[0]), path, draft.warnings)
        recordings = [recording[slice(*frames)] for recording in recordings]
    told = tuple(map(in_one_line, draft.warnings))
    return Reading(tuple(recordings), findings, told, path, frames, people, form.name)


def _as_text(name: str) -> str:
    """A file's name as a text, what is no UTF-8 in it spelled out."""
    return os.fsencode(name).decode("utf-8", "backslashreplace")


def split_window(source: str | PathLike[str]) -> tuple[Path, tuple[str, str] | None]:
    """Part a source into its path and its window.

    Parameters
    ----------
    source : str or path
        A path, or a path and a window.

    Returns
    -------
    tuple
        The path, and the two ends as written or None.

    Raises
    ------
    ParameterError
        When the source is no path.

    Examples
    --------
    >>> path, window = split_window("clip.bvh[12s:45s]")
    >>> path.name, window
    ('clip.bvh', ('12s', '45s'))
    """
    if not isinstance(source, str | PathLike):
        raise ParameterError(f"A recording is named by a path, got {source!r}.")
    text = os.fspath(source)
    match = _WINDOW.match(text)
    if match is None or exists(Path(text)):
        return Path(text), None
    return Path(match["path"]), (match["start"].strip(), match["stop"].strip())


def _format_of(path: Path, content: bytes) -> Format:
    head = content[:_HEAD]
    if re.match(rb"\s*<(!doctype html|html|head|body)", head, re.IGNORECASE):
        raise FormatError(
            f"{path.name} is a web page, not a recording.",
            remedy="Download the file itself, not the page about it.",
        )
    form = recognise(head, path.suffix)
    if (form is None or form.text) and is_wide(head[:64]):
        form = recognise(as_text(path, head, []), path.suffix)
    if form is None:
        ending = f" ends in {path.suffix!r}, which is no format known here, and" if path.suffix else ""
        raise FormatError(
            f"{path.name}{ending} does not begin like any format known here.",
            remedy=f"These are read: {', '.join(readable())}.",
        )
    if not form.module:
        raise FormatError(f"{path.name}: {form.name} files are not read.", remedy=form.remedy)
    return form


def _choose(
    recordings: list[Motion | Trajectories], people: tuple[str, ...], person: str | int | None, path: Path
) -> tuple[list[Motion | Trajectories], tuple[str, ...]]:
    if person is None:
        return recordings, people
    place = None
    if str(person) in people:
        place = people.index(str(person))
    elif str(person).isdecimal() and 1 <= int(person) <= len(people):
        place = int(person) - 1
    if place is None:
        named = ", ".join(name or f"{k + 1}" for k, name in enumerate(people))
        raise DataError(f"{path.name} holds no person {person!r}; it holds {named}.")
    return [recordings[place]], (people[place],)


def _frames_of(
    window: tuple[str, str], rate: float, count: int, path: Path, warnings: list[str]
) -> tuple[int, int]:
    """Frames ``[start, stop)`` of a window, within the recording."""
    text = f"[{window[0]}:{window[1]}]"
    ends = []
    if all(window) and window[0].endswith("s") != window[1].endswith("s"):
        raise ParameterError(
            f"A window must be in seconds or in frames, such as [12s:45s] or [100:400], got both in {text}."
        )
    for word, default in zip(window, (0, count)):
        match = re.fullmatch(r"(\d+(?:\.\d*)?|\.\d+)\s*s|(\d+)", word)
        if not word:
            ends.append(default)
        elif match is None:
            raise ParameterError(
                f"A window must be seconds or frames such as [12s:45s] or [100:400], got {text}."
            )
        else:
            ends.append(round(float(match[1]) * rate) if match[1] else int(match[2]))
    start, stop = ends[0], min(ends[1], count)
    if start >= stop:
        raise DataError(
            f"The window {text} holds no frame of {path.name}, which has {count} ({count / rate:.2f} s)."
        )
    if ends[1] > count:
        warnings.append(
            f"The window {text} reaches beyond the recording, which has {count} frames ({count / rate:.2f} s): "
            f"it was cut to the frames [{start}:{stop}]."
        )
    return start, stop
