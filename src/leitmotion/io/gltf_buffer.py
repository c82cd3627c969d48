"""The one buffer of a glTF, and the accessors that say what its bytes mean.

References
----------
.. [1] Khronos Group: glTF 2.0 specification, sections 3.6 (buffers, accessors) and 3.6.2.4 (alignment).
"""

from __future__ import annotations

from typing import Any

import numpy as np

VERTICES, INDICES = 34962, 34963
"""What the view of a buffer is used for, where it is a mesh."""

_COMPONENTS = {"<f4": 5126, "|u1": 5121, "<u2": 5123, "<u4": 5125}
_KINDS = {(): "SCALAR", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}


class Buffer:
    """Arrays one after the other, each from a multiple of four bytes on, with a view and an accessor of its own."""

    def __init__(self) -> None:
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []
        self._parts: list[bytes] = []
        self._size = 0

    def add(self, array: np.ndarray, *, target: int | None = None, bounds: bool = False) -> int:
        """Append an array of N elements.

        Parameters
        ----------
        array : (N,), (N, 3), (N, 4) or (N, 4, 4) of little-endian 32-bit floats or unsigned integers
            Matrices by columns.
        target : int, optional
            `VERTICES` or `INDICES`.
        bounds : bool
            Whether the accessor tells the least and the largest of each component.

        Returns
        -------
        int
            The accessor's number.
        """
        content = array.tobytes()
        view: dict[str, Any] = {"buffer": 0, "byteOffset": self._size, "byteLength": len(content)}
        if target is not None:
            view["target"] = target
        accessor: dict[str, Any] = {
            "bufferView": len(self.views),
            "componentType": _COMPONENTS[array.dtype.str],
            "count": len(array),
            "type": _KINDS[array.shape[1:]],
        }
        if bounds:
            accessor["min"] = np.atleast_1d(array.min(axis=0)).tolist()
            accessor["max"] = np.atleast_1d(array.max(axis=0)).tolist()
        self.views.append(view)
        self.accessors.append(accessor)
        self._parts += [content, bytes(-len(content) % 4)]
        self._size += len(content) + -len(content) % 4
        return len(self.accessors) - 1

    def content(self) -> bytes:
        """All bytes."""
        return b"".join(self._parts)
