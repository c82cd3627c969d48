"""Arrays as the page reads them: a JavaScript typed array's name, its lengths and its bytes in base64."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

JS_TYPES = {
    "i2": "Int16Array",
    "i4": "Int32Array",
    "u1": "Uint8Array",
    "u2": "Uint16Array",
    "f4": "Float32Array",
}


def array(values: np.ndarray, kind: str) -> dict[str, Any]:
    """Pack an array for the page.

    Parameters
    ----------
    values : array
        Of any shape; what the kind cannot hold is not checked.
    kind : {"i2", "i4", "u1", "u2", "f4"}
        Of its numbers.

    Returns
    -------
    dict
        ``type``, ``shape`` and ``data``: little-endian bytes in base64.

    Examples
    --------
    >>> array(np.array([1, 2]), "u1")
    {'type': 'Uint8Array', 'shape': [2], 'data': 'AQI='}
    """
    packed = np.ascontiguousarray(values, dtype="<" + kind)
    return {
        "type": JS_TYPES[kind],
        "shape": list(packed.shape),
        "data": base64.b64encode(packed.tobytes()).decode("ascii"),
    }
