"""glTF in one text file: the document as JSON, its buffer in it as base64. Written only."""

from __future__ import annotations

import base64
import json
from typing import Any

from leitmotion.io.gltf_document import describe
from leitmotion.motion import Motion, ParameterError, Trajectories


def write(recording: Motion | Trajectories) -> bytes:
    """Make the bytes of a .gltf, in metres and seconds, Y up.

    A Motion becomes a tree of nodes, one a joint and one an end site (``NAME_end``), below a node that bears the
    recording's name. Translations and rotations are animated where they change, with a key a frame; a skin of slim
    bones lets programs show them as an armature. Trajectories become a node a point. One that is not seen stays where
    it was last seen, in size 0. Rate and count of frames stand in the extras of the scene. A glTF has no place for a
    confidence.

    Parameters
    ----------
    recording : Motion or Trajectories
        In space and in metres.

    Returns
    -------
    bytes
        The file's content.

    Raises
    ------
    ParameterError
        When the points lie in a plane or are not in metres, there is no frame or no point, a name is no text that UTF-8
        can hold, a number is too large for a 32-bit float, or it lasts so long that two frames have one time.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Trajectories
    >>> content = write(Trajectories(("LFIN", "RFIN"), np.ones((100, 2, 3)), rate=50))
    >>> json.loads(content)["scenes"][0]["extras"]
    {'rate': 50.0, 'frames': 100}
    """
    document, buffer = describe(recording)
    document["buffers"][0]["uri"] = (
        "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()
    )
    return encode(document)


def encode(document: dict[str, Any]) -> bytes:
    """Write a document as JSON.

    Parameters
    ----------
    document : dict
        A glTF document.

    Returns
    -------
    bytes
        UTF-8.

    Raises
    ------
    ParameterError
        When a name is no text that UTF-8 can hold.
    """
    try:
        return json.dumps(document, ensure_ascii=False, separators=(",", ":"), allow_nan=False).encode(
            "utf-8"
        )
    except UnicodeEncodeError as error:
        name = error.object[error.start : error.end]
        raise ParameterError(f"A glTF is a text in UTF-8, which cannot hold {name!r} in a name.") from None
