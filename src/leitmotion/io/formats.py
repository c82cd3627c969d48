"""The one table of file formats and their extensions.

A format that is read is one line here and one module with a function ``read(source) -> Draft``. A format that is known
but not read has a sentence instead, which says what to do.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from leitmotion.io.reading import Draft, Source
from leitmotion.motion import Motion, ParameterError, Trajectories


@dataclass(frozen=True)
class Format:
    """A file format."""

    name: str
    """What it is called."""

    extensions: tuple[str, ...]
    """How its files end, in lower case, with the dot."""

    module: str = ""
    """The module of this room that reads it; empty where it is not read."""

    looks: Callable[[bytes], bool] | None = None
    """Whether a file that begins like this is one, where the extension tells nothing or several formats share it."""

    writer: str = ""
    """The module of this room that writes it, ``write(recording, **options) -> bytes``; empty where none does."""

    of_skeletons: bool = False
    """Whether what it holds is a skeleton, so that points cannot be written."""

    text: bool = False
    """Whether its files are text."""

    remedy: str = ""
    """What to do where it is not read."""

    def read(self, source: Source) -> Draft:
        """Read a file of this format."""
        draft: Draft = _module(self.module).read(source)
        return draft

    def write(self, recording: Motion | Trajectories, **options: Any) -> bytes:
        """Make the bytes of a file of this format."""
        unknown = sorted(set(options) - set(self.options))
        if unknown:
            known = ", ".join(self.options) or "none"
            raise ParameterError(f"{self.name} files have the options {known}, got {', '.join(unknown)}.")
        content: bytes = _module(self.writer).write(recording, **options)
        return content

    @property
    def options(self) -> dict[str, Any]:
        """What its writer takes beside the recording, by name, with the defaults."""
        parameters = inspect.signature(_module(self.writer).write).parameters
        return {name: p.default for name, p in parameters.items() if p.kind is p.KEYWORD_ONLY}


def _module(name: str) -> Any:
    return import_module(f"leitmotion.io.{name}")


def _starts(pattern: bytes) -> Callable[[bytes], bool]:
    compiled = re.compile(rb"(?:\xef\xbb\xbf)?\s*" + pattern, re.IGNORECASE)
    return lambda head: compiled.match(head) is not None


_ZIP = b"PK\x03\x04"  # of a NumPy archive the name of the first member stands at byte 30

FORMATS = (
    Format("C3D", (".c3d",), "c3d", lambda head: head[:2] == b"\x02\x50", writer="c3d_writing"),
    Format("BVH", (".bvh",), "bvh", _starts(rb"HIERARCHY\b"), writer="bvh", of_skeletons=True, text=True),
    Format(
        "AMC",
        (".amc",),
        "asf_amc",
        _starts(rb"(?:#[^\r\n]*[\r\n]\s*)*:(?:FULLY-SPECIFIED|DEGREES|RADIANS)\b"),
        text=True,
    ),
    Format("TRC", (".trc",), "trc", _starts(rb"PathFileType\b"), writer="trc_writing", text=True),
    Format(
        "OpenSim MOT", (".mot", ".sto"), "opensim", lambda head: _module("opensim").looks(head), text=True
    ),
    Format("Qualisys TSV", (".tsv",), "qualisys", lambda head: _module("qualisys").looks(head), text=True),
    Format(
        "DeepMimic",
        (".txt", ".json"),
        looks=lambda head: _module("unread").is_deepmimic(head),
        remedy="Its rotations need their skeleton: convert it to BVH.",
        text=True,
    ),
    Format(
        "exponential map",
        (".txt", ".csv"),
        looks=lambda head: _module("unread").is_exponential_maps(head),
        remedy="Its rotations need their skeleton: take the AMC or BVH of the same recording.",
        text=True,
    ),
    Format("UI-PRMD", (".txt", ".csv"), "uiprmd", lambda head: _module("uiprmd").looks(head), text=True),
    Format("Kinect table", (".csv", ".txt"), "kinect", lambda head: _module("kinect").looks(head), text=True),
    Format("Motive CSV", (".csv",), "motive", lambda head: _module("motive").looks(head), text=True),
    Format("Nexus CSV", (".csv", ".txt"), "nexus", lambda head: _module("nexus").looks(head), text=True),
    Format(
        "DeepLabCut CSV", (".csv",), "deeplabcut", lambda head: _module("deeplabcut").looks(head), text=True
    ),
    Format("table", (".tsv", ".txt"), "table", text=True),
    Format(
        "table",
        (".csv",),
        "table",
        lambda head: _module("table").looks(head),
        writer="table_writing",
        text=True,
    ),
    Format("Parquet", (".parquet",), "parquet", lambda head: head.startswith(b"PAR1"), writer="parquet"),
    Format("AMASS", (".npz",), "amass", lambda head: _module("amass").looks(head)),
    Format(
        "archive",
        (".npz",),
        "archive",
        lambda head: head[:4] == _ZIP and head[30:40] == b"header.npy",
        writer="archive",
    ),
    Format("NumPy array", (".npy",), "npy", lambda head: head.startswith(b"\x93NUMPY")),
    Format("NTU RGB+D", (".skeleton",), "ntu", lambda head: _module("ntu").looks(head), text=True),
    Format("poses", (".json",), "pose_json", lambda head: _module("pose_json").looks(head), text=True),
    Format(
        "joint-angle table", (".4d",), remedy="Angles alone make no body: read the AMC of the same trial."
    ),
    Format("ASF", (".asf",), remedy="It holds a skeleton without motion: read the AMC that belongs to it."),
    Format("FBX", (".fbx",), remedy="Save it as BVH, for instance in Blender."),
    Format("glTF", (".gltf",), writer="gltf", remedy="Save it as BVH, for instance in Blender."),
    Format("GLB", (".glb",), writer="glb", remedy="Save it as BVH, for instance in Blender."),
    Format(
        "MATLAB", (".mat",), remedy="Save the points as CSV with the columns time, NAME_x, NAME_y, NAME_z."
    ),
    Format(
        "HDF5",
        (".h5", ".hdf5"),
        remedy="Save the points as CSV with the columns time, NAME_x, NAME_y, NAME_z.",
    ),
    Format("Qualisys project", (".qtm",), remedy="Export its trajectories as C3D or TSV."),
    Format(
        "archive of files",
        (".tar", ".tgz", ".tbz2", ".txz", ".7z", ".rar"),
        remedy="Unpack it, and read the files or their folder.",
    ),
    Format("video", (".mp4", ".avi", ".mov", ".mkv", ".webm"), remedy="Take the poses from it first."),
)

DOUBTFUL = (".csv", ".json", ".npz", ".tsv", ".txt")
"""Extensions that a recording may have, and much else: a file found somewhere may be something else."""

_LOOSE = {".csv", ".json", ".tsv", ".txt"}  # extensions of files that are told by their columns or keys

EXTENSIONS: dict[str, tuple[Format, ...]] = {
    extension: tuple(form for form in FORMATS if extension in form.extensions)
    for extension in dict.fromkeys(extension for form in FORMATS for extension in form.extensions)
}
"""Formats by extension, in lower case, with the dot; of several that share one the last is the usual."""


def readable() -> list[str]:
    """Extensions that :func:`leitmotion.io.read` reads."""
    return [extension for extension, forms in EXTENSIONS.items() if any(form.module for form in forms)]


def writable() -> dict[str, Format]:
    """Formats that :func:`leitmotion.io.write` writes, by extension."""
    written = {extension: [form for form in forms if form.writer] for extension, forms in EXTENSIONS.items()}
    return {extension: forms[-1] for extension, forms in written.items() if forms}


def recognise(head: bytes, extension: str = "") -> Format | None:
    """Tell a format by its extension and by how a file begins, None where nothing fits.

    Parameters
    ----------
    head : bytes
        The first kilobytes of a file.
    extension : str
        How its name ends, with the dot. One that several formats share chooses among these first, then among all, and
        is the usual one where none looks right; one that no format has tells nothing. One that a single format has is
        believed, unless the file begins unlike it and like a format that is told by more than a table's columns.

    Returns
    -------
    Format or None
        The format.
    """
    forms = EXTENSIONS.get(extension.lower(), ())
    candidates = (*forms, *FORMATS)
    if len(forms) == 1:
        candidates = (*forms, *(form for form in FORMATS if not set(form.extensions) <= _LOOSE))
    fitting = (form for form in candidates if form.looks is not None and form.looks(head))
    return next(fitting, forms[-1] if forms else None)


def is_misnamed(form: Format, extension: str) -> bool:
    """Tell whether an extension is that of other formats alone, and is not one of those that say little."""
    forms = EXTENSIONS.get(extension.lower(), ())
    return bool(forms) and form not in forms and extension.lower() not in DOUBTFUL
