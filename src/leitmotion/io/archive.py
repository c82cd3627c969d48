"""The archive: any noun of the house as one ``.npz``, without pickle.

The member ``header`` is a JSON text: the archive's version and the noun, its fields by name. A noun is
``{"noun": "room:Name", "fields": {…}}``, an array ``{"array": "a0"}`` and names a member of its own; tuples, lists and
dicts are tagged likewise, so that what is loaded equals what was saved.

The archive holds the nouns of every room, those of higher floors as well, and therefore knows none of them: it saves
and loads whatever derives from :class:`~leitmotion.motion.noun.Noun`, and imports the room that a header names when it
loads from it. Only modules of this package are imported, and of those only public ones.
"""

from __future__ import annotations

import dataclasses
import io
import json
import math
import re
import warnings
import zipfile
from importlib import import_module
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from leitmotion.io.containers import read_file
from leitmotion.io.files import write_whole
from leitmotion.io.reading import Draft, Finding, PointTake, SkeletonTake, Source
from leitmotion.motion import FormatError, LeitmotionError, Motion, ParameterError, Trajectories
from leitmotion.motion.noun import Noun

VERSION = 1
"""Version of the layout; a reader refuses a newer one."""

_HEADER = "header"
_PACKAGE = "leitmotion"
_ROOM = re.compile(rf"{_PACKAGE}(\.[a-z]\w*)+")
"""Modules that a header may name: of this package, none with a leading underscore (``__main__`` would run)."""

_INFLATION = 100  # by how much an array may grow when unpacked, beyond a first 64 MB


def save(noun: Any, path: str | PathLike[str]) -> Path:
    """Save a noun as one ``.npz``.

    Parameters
    ----------
    noun : Motion, Trajectories, Segmentation or any other noun
        What to save.
    path : str or path
        The file, ending in ``.npz``; written whole or not at all.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ParameterError
        When the value or one of its fields is nothing that an archive holds, or the file ends in anything else.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> from leitmotion.motion import Segmentation
    >>> steps = Segmentation([0, 120], [120, 300], ("walk", "punch"), rate=120)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     load(save(steps, pathlib.Path(folder) / "steps.npz")) == steps
    True
    """
    if Path(path).suffix.lower() != ".npz":
        raise ParameterError(f"An archive ends in .npz, got {Path(path).name!r}.")
    return write_whole(path, to_bytes(noun))


def load(path: str | PathLike[str]) -> Any:
    """Load the noun that :func:`save` wrote.

    Parameters
    ----------
    path : str or path
        The file.

    Returns
    -------
    noun
        Equal to what was saved.

    Raises
    ------
    FormatError
        When the file is missing, damaged, no archive of ours, of a newer version or of an unknown type.
    """
    path, content = read_file(Path(path))
    if not content.startswith(b"PK"):
        raise FormatError(
            f"{path.name} is no archive of Leitmotion (.npz).",
            remedy="If it is a recording, leitmotion.read reads it.",
        )
    return from_bytes(content, path.name)


def to_bytes(noun: Any) -> bytes:
    """Make the bytes of an archive; parameters and errors as in :func:`save`."""
    if not _is_noun(type(noun)):
        raise ParameterError(f"An archive holds a noun such as a Motion, got a {type(noun).__name__}.")
    arrays: dict[str, np.ndarray] = {}
    header = {_PACKAGE: VERSION, **_encode(noun, arrays)}
    text = json.dumps(header, ensure_ascii=False, allow_nan=False).encode("utf-8")
    file = io.BytesIO()
    np.savez(file, allow_pickle=False, **{_HEADER: np.frombuffer(text, dtype=np.uint8)}, **arrays)
    return file.getvalue()


def from_bytes(content: bytes, name: str) -> Any:
    """Make the noun that an archive's bytes hold; errors as in :func:`load`, with the file's name."""
    header, arrays = _members(content, name)
    version = header.get(_PACKAGE)
    if not isinstance(version, int):
        raise FormatError(f"{name}: expected the version of a Leitmotion archive, found {version!r}.")
    if version > VERSION:
        raise FormatError(
            f"{name} was written by a newer Leitmotion: archive version {version}, this one reads up to {VERSION}.",
            remedy="Upgrade Leitmotion.",
        )
    try:
        return _decode(header, arrays)
    except FormatError as error:
        raise FormatError(f"{name}: {error.message}", remedy=error.remedy) from None
    except (LeitmotionError, LookupError, TypeError, ValueError, ArithmeticError, RecursionError) as error:
        raise FormatError(f"{name} is damaged: {_sentence(error)}") from None
    except AttributeError:  # a part of another type than its noun asks for
        raise FormatError(f"{name} is damaged: a part of its header is of a wrong type.") from None


def read(source: Source) -> Draft:
    """Read a recording from an archive; one that holds another noun is for :func:`load`."""
    noun = from_bytes(source.content, source.path.name)
    how = "an archive is in the house's units"
    facts = {
        "rate": Finding(noun.rate, "read", "stated in the archive") if hasattr(noun, "rate") else None,
        "up": Finding("y", "read", how),
    }
    take: SkeletonTake | PointTake
    if isinstance(noun, Motion):
        skeleton = noun.skeleton
        take = SkeletonTake(
            list(skeleton.names), skeleton.parents, skeleton.offsets, skeleton.end_parents, skeleton.end_offsets,
            noun.local_positions, noun.local_rotations,
        )  # fmt: skip
        facts["unit"] = Finding("m", "read", how)
    elif isinstance(noun, Trajectories):
        take = PointTake(list(noun.names), noun.positions, noun.kind, noun.confidence)
        facts["unit"] = Finding(noun.unit, "read", "stated in the archive")
    else:
        raise source.error(
            f"expected a recording, found a {type(noun).__name__}.", remedy="Open it with leitmotion.load."
        )
    return Draft([take], name=noun.name, as_saved=True, **facts)  # type: ignore[arg-type]


def write(recording: Motion | Trajectories) -> bytes:
    """Make the bytes of an archive of a recording; as :func:`to_bytes`."""
    return to_bytes(recording)


def _encode(value: Any, arrays: dict[str, np.ndarray]) -> Any:
    if isinstance(value, np.ndarray):
        if value.dtype.hasobject:
            raise ParameterError("An archive holds arrays of numbers or text, got one of Python objects.")
        key = f"a{len(arrays)}"
        arrays[key] = value
        return {"array": key}
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return {"float": repr(value)}
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, (tuple, list)):
        return {type(value).__name__: [_encode(item, arrays) for item in value]}
    if isinstance(value, dict):
        return {"dict": [[_encode(key, arrays), _encode(item, arrays)] for key, item in value.items()]}
    if _is_noun(type(value)):
        fields = {f.name: _encode(getattr(value, f.name), arrays) for f in dataclasses.fields(value)}
        return {"noun": _address(type(value)), "fields": fields}
    raise ParameterError(f"An archive holds nouns, arrays, numbers and text, got a {type(value).__name__}.")


def _decode(value: Any, arrays: dict[str, np.ndarray]) -> Any:
    if not isinstance(value, dict):
        return value
    if "noun" in value:
        kind, fields = _class_at(value["noun"]), value["fields"]
        if not isinstance(fields, dict):
            raise ValueError(
                f"expected the fields of a {kind.__name__} by name, found a {type(fields).__name__}."
            )
        return kind(**{name: _decode(item, arrays) for name, item in fields.items()})
    if "array" in value:
        return arrays[value["array"]]
    if "tuple" in value:
        return tuple(_decode(item, arrays) for item in value["tuple"])
    if "list" in value:
        return [_decode(item, arrays) for item in value["list"]]
    if "dict" in value:
        return {_decode(key, arrays): _decode(item, arrays) for key, item in value["dict"]}
    if "float" in value:
        return float(value["float"])
    raise ValueError(f"its header holds {sorted(value)}")


def _address(kind: type) -> str:
    """Name a noun by its room where the room offers it, else by its module."""
    room = ".".join(kind.__module__.split(".")[:2])
    offered = getattr(import_module(room), kind.__name__, None)
    return f"{room if offered is kind else kind.__module__}:{kind.__name__}"


def _class_at(address: object) -> type:
    module, _, name = str(address).partition(":")
    kind = None
    if _ROOM.fullmatch(module):
        try:
            kind = getattr(import_module(module), name, None)
        except ImportError:
            kind = None
    if not (isinstance(kind, type) and _is_noun(kind)):
        raise FormatError(
            f"holds a {address}, which this Leitmotion does not know.", remedy="Was it saved by a newer one?"
        )
    return kind


def _is_noun(kind: type) -> bool:
    return (
        dataclasses.is_dataclass(kind)
        and issubclass(kind, Noun)
        and kind.__module__.split(".")[0] == _PACKAGE
    )


def promises_too_much(unpacked: int, packed: int) -> bool:
    """Whether arrays of so many bytes are more than so few can hold.

    Examples
    --------
    >>> promises_too_much(1 << 26, 1000), promises_too_much(1 << 30, 1000)
    (False, True)
    """
    return unpacked > _INFLATION * packed + (64 << 20)


def _members(content: bytes, name: str) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as box:
            promised = sum(member.file_size for member in box.infolist())
            if promises_too_much(promised, len(content)):
                raise FormatError(f"{name} promises {promised / 1e9:.1f} GB, more than such a file can hold.")
        with np.load(io.BytesIO(content), allow_pickle=False) as box, warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of a header that looks as Python 2 wrote it
            if _HEADER not in box.files:
                raise FormatError(
                    f"{name} is a NumPy archive without Leitmotion's header: it holds {', '.join(box.files[:8])}.",
                    remedy="Save the points as CSV with the columns time, NAME_x, NAME_y, NAME_z.",
                )
            header = json.loads(np.asarray(box[_HEADER]).tobytes().decode("utf-8"))
            arrays = {key: box[key] for key in box.files if key != _HEADER}
    except FormatError:
        raise
    except Exception as error:  # of what is damaged NumPy raises anything, from SyntaxError to OverflowError
        raise FormatError(f"{name} is no archive or is damaged: {_sentence(error)}") from None
    if not isinstance(header, dict):
        raise FormatError(f"{name}: expected a header with names, found a {type(header).__name__}.")
    return header, arrays


def _sentence(error: Exception) -> str:
    return f"{str(error).rstrip('.') or type(error).__name__}."
