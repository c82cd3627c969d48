"""Rotation algebra on arrays of unit quaternions.

Conventions
-----------
A quaternion is ``(w, x, y, z)``, unit, active: ``rotate(q, v)`` turns the vector `v`. ``multiply(a, b)`` turns by
`b` first, then by `a`. Every function takes any leading axes, ``(..., 4)`` and ``(..., 3)``. Euler angles are
radians, *intrinsic*, in the order in which the letters stand (the BVH reading). ``q`` and ``-q`` are one
rotation; :func:`continuous` chooses the signs along time.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])
IDENTITY.flags.writeable = False


def multiply(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Hamilton product: the rotation `b` followed by `a`.

    Parameters
    ----------
    a, b : (..., 4) float
        Quaternions.

    Returns
    -------
    (..., 4) float
        The product.
    """
    aw, ax, ay, az = np.moveaxis(np.asarray(a), -1, 0)
    bw, bx, by, bz = np.moveaxis(np.asarray(b), -1, 0)
    return np.stack(
        (
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ),
        axis=-1,
    )


def conjugate(q: np.ndarray) -> np.ndarray:
    """Inverse of a unit quaternion.

    Parameters
    ----------
    q : (..., 4) float
        Quaternions.

    Returns
    -------
    (..., 4) float
        The rotations that undo them.
    """
    return np.asarray(q) * np.array([1.0, -1.0, -1.0, -1.0])


def rotate(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Turn vectors: ``q v q*``, written with two cross products.

    Parameters
    ----------
    q : (..., 4) float
        Unit quaternions.
    v : (..., 3) float
        Vectors.

    Returns
    -------
    (..., 3) float
        The turned vectors.

    Examples
    --------
    >>> rotate(from_axis_angle("y", np.pi / 2), np.array([0.0, 0.0, 1.0])).round(6)
    array([1., 0., 0.])
    """
    w, axis = np.asarray(q)[..., :1], np.asarray(q)[..., 1:]
    t = 2.0 * np.cross(axis, v)
    return v + w * t + np.cross(axis, t)


def normalize(q: np.ndarray) -> np.ndarray:
    """Scale quaternions to unit length.

    Parameters
    ----------
    q : (..., 4) float
        Quaternions, none of them zero.

    Returns
    -------
    (..., 4) float
        Unit quaternions.
    """
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def continuous(q: np.ndarray) -> np.ndarray:
    """Choose the sign of each quaternion so that it is near its predecessor in time.

    Parameters
    ----------
    q : (T, ..., 4) float
        Unit quaternions, time first.

    Returns
    -------
    (T, ..., 4) float
        The same rotations.
    """
    q = np.asarray(q)
    if len(q) < 2:
        return q.copy()
    flips = np.where(np.einsum("...i,...i->...", q[1:], q[:-1]) < 0, -1.0, 1.0)
    signs = np.concatenate((np.ones_like(flips[:1]), np.cumprod(flips, axis=0)))
    return q * signs[..., None]


def geodesic_angle(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Angle between two rotations, a metric.

    Parameters
    ----------
    a, b : (..., 4) float
        Unit quaternions.

    Returns
    -------
    (...) float
        Radians in [0, pi].
    """
    relative = multiply(conjugate(a), b)
    return 2.0 * np.arctan2(np.linalg.norm(relative[..., 1:], axis=-1), np.abs(relative[..., 0]))


def slerp(a: np.ndarray, b: np.ndarray, t: np.ndarray | float) -> np.ndarray:
    """Turn from `a` to `b` along the shorter way at constant speed.

    Parameters
    ----------
    a, b : (..., 4) float
        Unit quaternions.
    t : (...) float
        0 at `a`, 1 at `b`.

    Returns
    -------
    (..., 4) float
        Unit quaternions.
    """
    a, b, t = np.asarray(a), np.asarray(b), np.asarray(t)[..., None]
    dot = np.einsum("...i,...i->...", a, b)[..., None]
    b = np.where(dot < 0, -b, b)
    angle = np.arccos(np.clip(np.abs(dot), 0.0, 1.0))
    sine = np.sin(angle)
    near = sine < 1e-6  # the limit is the straight line; the division below must stay harmless
    safe = np.where(near, 1.0, sine)
    left = np.where(near, 1.0 - t, np.sin((1.0 - t) * angle) / safe)
    right = np.where(near, t, np.sin(t * angle) / safe)
    return normalize(left * a + right * b)


def from_axis_angle(axis: str, angle: np.ndarray | float) -> np.ndarray:
    """Quaternion that turns about one of the axes.

    Parameters
    ----------
    axis : {"x", "y", "z"}
        The axis.
    angle : (...) float
        Radians.

    Returns
    -------
    (..., 4) float
        Unit quaternions.
    """
    half = 0.5 * np.asarray(angle, dtype=np.float64)
    q = np.zeros((*half.shape, 4))
    q[..., 0] = np.cos(half)
    q[..., 1 + _axis(axis)] = np.sin(half)
    return q


def from_rotation_vector(vectors: np.ndarray) -> np.ndarray:
    """Turn about an axis by the length of the axis, in radians: what SMPL and exponential maps tell.

    Parameters
    ----------
    vectors : (..., 3) float
        Axis times angle.

    Returns
    -------
    (..., 4) float
        Unit quaternions.

    Examples
    --------
    >>> from_rotation_vector(np.array([0.0, np.pi / 2, 0.0])).round(6).tolist()
    [0.707107, 0.0, 0.707107, 0.0]
    """
    vectors = np.asarray(vectors, dtype=np.float64)
    half = np.linalg.norm(vectors, axis=-1, keepdims=True) / 2
    # np.sinc is sin(pi x) / (pi x) and knows its limit
    return np.concatenate((np.cos(half), vectors / 2 * np.sinc(half / np.pi)), axis=-1)


def from_euler(order: str, angles: np.ndarray) -> np.ndarray:
    """Quaternion of intrinsic Euler angles, the order given by letters.

    Parameters
    ----------
    order : str
        One to three of the letters x, y, z: the first turns first, the next about the turned axis.
    angles : (..., len(order)) float
        Radians, one column a letter.

    Returns
    -------
    (..., 4) float
        Unit quaternions.

    Examples
    --------
    >>> from_euler("zyx", np.zeros((2, 3))).tolist()
    [[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]]
    """
    half = 0.5 * np.moveaxis(np.asarray(angles, dtype=np.float64), -1, 0)
    if len(half) != len(order):
        raise ParameterError(
            f"angles must have {len(order)} columns for the order {order!r}, got {len(half)}."
        )
    cosines, sines = np.cos(half), np.sin(half)
    zero = np.zeros(half.shape[1:])
    q = [cosines[0], zero, zero, zero]
    q[1 + _axis(order[0])] = sines[0]
    for letter, cosine, sine in zip(order[1:], cosines[1:], sines[1:], strict=True):
        q = _turn(q, _axis(letter), cosine, sine)
    return np.stack(q, axis=-1)


def as_euler(order: str, q: np.ndarray) -> np.ndarray:
    """Intrinsic Euler angles of quaternions; at gimbal lock the last angle is set to zero.

    Parameters
    ----------
    order : str
        Three of the letters x, y, z.
    q : (..., 4) float
        Unit quaternions.

    Returns
    -------
    (..., 3) float
        Radians.
    """
    import warnings

    from scipy.spatial.transform import Rotation

    q = np.asarray(q)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Gimbal lock")
        flat = Rotation.from_quat(q.reshape(-1, 4)[:, [1, 2, 3, 0]]).as_euler(order.upper())
    return flat.reshape(*q.shape[:-1], 3)


def from_matrix(matrix: np.ndarray) -> np.ndarray:
    """Quaternion of rotation matrices.

    Parameters
    ----------
    matrix : (..., 3, 3) float
        Rotation matrices; columns are the turned axes.

    Returns
    -------
    (..., 4) float
        Unit quaternions.
    """
    from scipy.spatial.transform import Rotation

    matrix = np.asarray(matrix)
    flat = Rotation.from_matrix(matrix.reshape(-1, 3, 3)).as_quat()
    return flat[:, [3, 0, 1, 2]].reshape(*matrix.shape[:-2], 4)


def as_matrix(q: np.ndarray) -> np.ndarray:
    """Rotation matrices of quaternions.

    Parameters
    ----------
    q : (..., 4) float
        Unit quaternions.

    Returns
    -------
    (..., 3, 3) float
        Columns are the turned axes.
    """
    from scipy.spatial.transform import Rotation

    q = np.asarray(q)
    return Rotation.from_quat(q.reshape(-1, 4)[:, [1, 2, 3, 0]]).as_matrix().reshape(*q.shape[:-1], 3, 3)


def yaw_rotation(yaw: np.ndarray) -> np.ndarray:
    """Quaternion that turns about the vertical.

    Parameters
    ----------
    yaw : (...) float
        Radians; 0 faces +Z, pi/2 faces +X.

    Returns
    -------
    (..., 4) float
        Unit quaternions.
    """
    return from_axis_angle("y", yaw)


def _turn(q: list[np.ndarray], axis: int, cosine: np.ndarray, sine: np.ndarray) -> list[np.ndarray]:
    """Product of a quaternion with a turn about one axis, of which two components are zero."""
    w, x, y, z = q
    if axis == 0:
        return [w * cosine - x * sine, w * sine + x * cosine, y * cosine + z * sine, z * cosine - y * sine]
    if axis == 1:
        return [w * cosine - y * sine, x * cosine - z * sine, w * sine + y * cosine, z * cosine + x * sine]
    return [w * cosine - z * sine, x * cosine + y * sine, y * cosine - x * sine, w * sine + z * cosine]


def _axis(letter: str) -> int:
    place = "xyz".find(letter.lower())
    if place < 0 or len(letter) != 1:
        raise ParameterError(f"An axis must be one of x, y, z, got {letter!r}.")
    return place
