"""From recordings to files."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import Any

from leitmotion.io.files import write_whole
from leitmotion.io.formats import writable
from leitmotion.motion import Motion, ParameterError, Trajectories


def write(recording: Motion | Trajectories, path: str | PathLike[str], **options: Any) -> Path:
    """Write a recording in the format that the extension names, whole or not at all.

    Parameters
    ----------
    recording : Motion or Trajectories
        What to write.
    path : str or path
        ``.bvh`` (a Motion; option `unit`, "cm" unless said otherwise), ``.c3d`` or ``.trc`` (points, or a Motion's
        joints; option `unit`, "mm" unless said otherwise), ``.csv`` or ``.parquet`` (the same; option `unit`, the
        recording's own unless said otherwise), ``.glb``, ``.gltf`` or ``.npz``.
    **options
        What the format's own ``write`` takes.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ParameterError
        When the extension is not written, or the recording is of a kind that the format does not hold.
    """
    path = Path(path)
    forms = writable()
    form = forms.get(path.suffix.lower())
    if form is None:
        raise ParameterError(
            f"Recordings are written as {', '.join(forms)}, got {path.suffix or path.name!r}.",
            remedy="Choose one of these extensions.",
        )
    return write_whole(path, form.write(recording, **options))
