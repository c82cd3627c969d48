"""NumPy arrays: joints in space or in a picture, or the motions of poselib.

An array of numbers (T, J, 3) or (T, J, 2) holds J joints over T frames. What they are is guessed from how many there
are: 22 are those of HumanML3D, 17 of Human3.6M (in a picture, of COCO), 20, 25 and 32 of a Kinect, 24 of SMPL, 33 of
BlazePose. An array of Python objects is a pickle, which can run code when it is read: it is read only for a caller who
trusts it, and holds a motion where it is one of poselib, which Isaac Gym and AMP use: quaternions (x, y, z, w), metres,
Z up.
"""

from __future__ import annotations

import io
import warnings as warnings_
from collections.abc import Mapping
from typing import Any

import numpy as np

from leitmotion.io.joint_sets import BLAZEPOSE, IN_IMAGES, IN_SPACE, JointSet, set_of
from leitmotion.io.points import FARTHEST, in_pixels, is_confidence, plane_unit, unseen_in_origin
from leitmotion.io.reading import Draft, Finding, PointTake, SkeletonTake, Source

_FEATURES = {
    263: "HumanML3D features, from which places follow only with that project's code",
    251: "KIT-ML features, from which places follow only with that project's code",
}
_COMPLETE = "Was it copied or downloaded completely?"
_SAVE = "Save the places as an array (T, J, 3), or as CSV with the columns time, NAME_x, NAME_y, NAME_z."


def read(source: Source) -> Draft:
    """Read an array.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person.

    Raises
    ------
    FormatError
        When the file is damaged, of another shape, or a pickle that the caller does not trust.
    """
    shape, dtype = _header(source)
    if dtype.hasobject:
        return _pickled(source)
    if dtype.kind not in "fiu":
        raise source.error(f"expected numbers, found {dtype}.", remedy=_SAVE)
    if dtype.itemsize * int(np.prod(shape, dtype=object)) > len(source.content):
        raise source.error(f"its header promises {_size(shape)} numbers, more than it holds.")
    try:
        values = np.load(io.BytesIO(source.content), allow_pickle=False).astype(np.float64)
    except Exception:  # of what is damaged NumPy raises anything
        raise source.error("is damaged.", remedy=_COMPLETE) from None
    return _points(source, values)


def _header(source: Source) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Shape and type that the file promises."""
    content = io.BytesIO(source.content)
    try:
        with warnings_.catch_warnings():
            warnings_.simplefilter("ignore")  # of headers that Python 2 wrote
            version = np.lib.format.read_magic(content)
            form = np.lib.format
            read_header = form.read_array_header_1_0 if version == (1, 0) else form.read_array_header_2_0
            shape, _, dtype = read_header(content)
    except Exception:  # of what is damaged NumPy raises anything
        raise source.error("is no NumPy array or is damaged.", remedy=_COMPLETE) from None
    return shape, dtype


def _points(source: Source, values: np.ndarray) -> Draft:
    if values.ndim == 2 and values.shape[1] in _FEATURES:
        raise source.error(
            f"holds {values.shape[1]} numbers a frame: {_FEATURES[values.shape[1]]}.",
            remedy="Save the places of the joints that they stand for, as an array (T, 22, 3).",
        )
    if values.ndim != 3 or values.shape[2] not in (2, 3) or 0 in values.shape:
        raise source.error(
            f"expected joints over time, (T, J, 3), found {_size(values.shape)}.", remedy=_SAVE
        )
    warnings: list[str] = []
    count, sure = values.shape[1], None
    if values.shape[2] == 3 and in_pixels(values[..., :2]) and is_confidence(values[..., 2]):
        values, sure = values[..., :2], np.clip(np.nan_to_num(values[..., 2]), 0.0, 1.0)
        warnings.append("The third numbers lie within 0 and 1 beside pixels and were taken as confidences.")
    flat = values.shape[2] == 2
    joints = set_of(count, IN_IMAGES if flat else IN_SPACE) or set_of(count, IN_SPACE if flat else IN_IMAGES)
    joints = joints or JointSet("numbered points", tuple(f"point_{k}" for k in range(count)))
    values = np.where(np.isfinite(values).all(axis=-1, keepdims=True), values, np.nan)
    if flat:
        unseen_in_origin(values, warnings)
    kind = "no known joint set has so many" if joints.name.startswith("numbered") else f"because J = {count}"
    warnings.append(f"The array names nothing: its joints were taken as {joints.name} ({kind}).")
    if source.options.rate is None:
        warnings.append(f"No rate is stated; {joints.rate:g} Hz was guessed, --rate states another.")
    up = None
    if flat:
        up = Finding("-y", "guessed", "points in a picture: y points down")
    elif joints is BLAZEPOSE:
        up = Finding("-y", "guessed", "the axes of BlazePose: y points down")
    return Draft(
        [PointTake(list(joints.joints), values, "joint", sure)],
        rate=Finding(joints.rate, "guessed", joints.usual),
        unit=plane_unit(values) if flat else None,
        up=up,
        findings={"joints": Finding(joints.name, "guessed", kind)},
        warnings=warnings,
    )


def _pickled(source: Source) -> Draft:
    if not source.options.trust:
        raise source.error(
            "holds pickled Python objects, which can run code when they are read.",
            remedy="If you trust where it comes from, read it with --trust (trust=True in Python).",
        )
    try:
        held = np.load(io.BytesIO(source.content), allow_pickle=True)
        motion = held.item() if held.shape == () else None
    except Exception as error:  # a pickle may raise anything
        raise source.error(f"its pickle cannot be read: {error}.") from None
    if not isinstance(motion, Mapping) or not {"rotation", "root_translation", "skeleton_tree"} <= set(
        motion
    ):
        found = (
            f"the keys {', '.join(map(str, list(motion)[:6]))}" if isinstance(motion, Mapping) else "others"
        )
        raise source.error(
            f"expected a motion of poselib with rotation, root_translation and skeleton_tree, found {found}.",
            remedy=_SAVE,
        )
    try:
        return _poselib(source, motion)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        raise source.error(f"its motion of poselib is damaged: {error!r}.") from None


def _poselib(source: Source, motion: Mapping[str, Any]) -> Draft:
    tree = motion["skeleton_tree"]
    names = [str(name) for name in tree["node_names"]]
    parents = np.asarray(tree["parent_indices"]["arr"], dtype=np.int64)
    offsets = np.asarray(tree["local_translation"]["arr"], dtype=np.float64)
    root = np.asarray(motion["root_translation"]["arr"], dtype=np.float64)
    turns = np.roll(np.asarray(motion["rotation"]["arr"], dtype=np.float64), 1, axis=-1)
    frames, joints = len(root), len(names)
    if turns.shape != (frames, joints, 4) or offsets.shape != (joints, 3) or parents.shape != (joints,):
        raise source.error(
            f"expected rotations of {frames} frames and {joints} joints, found {_size(turns.shape)} numbers."
        )
    lengths = np.linalg.norm(turns, axis=-1)
    if not ((np.abs(root) < FARTHEST).all() and np.isfinite(turns).all() and lengths.min(initial=1.0) > 0.5):
        raise source.error("expected unit quaternions and finite places, found others.")
    if not motion.get("is_local", True):
        raise source.error(
            "its rotations are in the world's frame, which is not read.", remedy="Save local ones."
        )
    positions = np.broadcast_to(offsets, (frames, joints, 3)).copy()
    positions[:, 0] = root
    rest = offsets.copy()
    rest[0] = 0.0
    take = SkeletonTake(
        names,
        parents,
        rest,
        np.empty(0, dtype=np.int64),
        np.empty((0, 3)),
        positions,
        turns / lengths[..., None],
    )
    return Draft(
        [take],
        rate=Finding(float(np.asarray(motion["fps"]).item()), "read", "stated as fps"),
        unit=Finding("m", "read", "a motion of poselib"),
        up=Finding("z", "read", "a motion of poselib"),
    )


def _size(shape: tuple[int, ...]) -> str:
    return " × ".join(map(str, shape)) or "one"
