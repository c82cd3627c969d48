"""GLB, glTF in one binary file: a chunk of JSON and a chunk of bytes. Written only."""

from __future__ import annotations

import struct

from leitmotion.io.gltf import encode
from leitmotion.io.gltf_document import describe
from leitmotion.motion import Motion, ParameterError, Trajectories

_LARGEST = 0xFFFFFFFF  # bytes of a file, whose length is 32 bits


def write(recording: Motion | Trajectories) -> bytes:
    """Make the bytes of a .glb, in metres and seconds, Y up: what :func:`leitmotion.io.gltf.write` says, packed.

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
        As :func:`leitmotion.io.gltf.write`, and when it takes up 4 GiB or more.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Trajectories
    >>> content = write(Trajectories(("LFIN", "RFIN"), np.ones((100, 2, 3)), rate=50))
    >>> content[:4], len(content) % 4
    (b'glTF', 0)
    """
    document, buffer = describe(recording)
    text = encode(document)
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(buffer)
    if total > _LARGEST:
        raise ParameterError(f"A .glb has less than 4 GiB, got {total:,} bytes.", remedy="Write it in parts.")
    head = struct.pack("<4sII", b"glTF", 2, total)
    chunks = (
        struct.pack("<I4s", len(text), b"JSON"),
        text,
        struct.pack("<I4s", len(buffer), b"BIN\0"),
        buffer,
    )
    return b"".join((head, *chunks))
