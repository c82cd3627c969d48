"""Files that are written whole or not at all."""

from __future__ import annotations

import contextlib
import os
import tempfile
from os import PathLike
from pathlib import Path

from leitmotion.motion import FormatError


def write_whole(path: str | PathLike[str], content: str | bytes) -> Path:
    """Write a file so that nobody ever sees half of it.

    The content goes to a temporary file in the same folder, is flushed to the disk and takes the name in one step; an
    interruption or a full disk leaves what was there before.

    Parameters
    ----------
    path : str or path
        The file; its folder is made where it is missing.
    content : str or bytes
        What it holds; text is written as UTF-8 with the newlines it has.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FormatError
        When the folder cannot be written to or the disk is full.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_whole(pathlib.Path(folder) / "a.txt", "whole").read_text()
    'whole'
    """
    path = Path(path)
    data = content.encode("utf-8") if isinstance(content, str) else content
    temporary = ""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".part", dir=path.parent)
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, path)
    except OSError as error:
        _discard(temporary)
        raise FormatError(
            f"{path} cannot be written: {error.strerror or error}.",
            remedy="Choose another place, or make room and check the permissions.",
        ) from None
    except BaseException:  # an interruption, too, leaves nothing behind
        _discard(temporary)
        raise
    return path


def _discard(temporary: str) -> None:
    if temporary:
        with contextlib.suppress(OSError):
            os.unlink(temporary)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
