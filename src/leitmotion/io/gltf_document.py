"""What a glTF says about a recording: a tree of nodes, how they move, and shapes to see them by.

glTF is in metres and seconds, right-handed and Y up, and so are the nouns: only the quaternions' order differs. Times
are the frames' over the rate, in 32-bit floats, and what lies between two frames is interpolated linearly.

References
----------
.. [1] Khronos Group: glTF 2.0 specification, sections 3.7 (skins) and 3.11 (animations).
"""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

from leitmotion.io.gltf_buffer import INDICES, VERTICES, Buffer
from leitmotion.io.gltf_shapes import bone_shapes, point_shape, triangles
from leitmotion.motion import Motion, ParameterError, Skeleton, Trajectories

_GREY = {"baseColorFactor": [0.8, 0.8, 0.8, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.8}


def describe(recording: Motion | Trajectories) -> tuple[dict[str, Any], bytes]:
    """Make a glTF document and the content of its one buffer.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames, in metres and in space.

    Returns
    -------
    tuple of dict and bytes
        The document, whose only buffer has no ``uri`` yet, and the buffer's bytes.

    Raises
    ------
    ParameterError
        When the points lie in a plane or are not in metres, there is no frame or no point, a number is too large for a
        32-bit float, or it lasts so long that two frames have one time.
    """
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(f"A glTF holds a recording, got a {type(recording).__name__}.")
    _check(recording)
    scene = _Scene(recording)
    if isinstance(recording, Motion):
        roots = _put_skeleton(scene, recording)
    else:
        roots = _put_points(scene, recording)
    content = scene.buffer.content()
    document = {
        "asset": {"version": "2.0", "generator": _generator()},
        "scene": 0,
        "scenes": [{"nodes": roots, "extras": {"rate": recording.rate, "frames": len(recording)}}],
        "nodes": scene.nodes,
        "meshes": scene.meshes,
        "materials": [{"name": "grey", "pbrMetallicRoughness": _GREY}],
        "skins": scene.skins,
        "animations": [{"name": scene.name, "channels": scene.channels, "samplers": scene.samplers}],
        "accessors": scene.buffer.accessors,
        "bufferViews": scene.buffer.views,
        "buffers": [{"byteLength": len(content)}],
    }
    if not scene.channels:
        del document["animations"]
    if not scene.skins:
        del document["skins"]
    return document, content


class _Scene:
    """The lists of a document as they grow."""

    def __init__(self, recording: Motion | Trajectories) -> None:
        self.name = recording.name or "recording"
        self.buffer = Buffer()
        self.nodes: list[dict[str, Any]] = []
        self.meshes: list[dict[str, Any]] = []
        self.skins: list[dict[str, Any]] = []
        self.channels: list[dict[str, Any]] = []
        self.samplers: list[dict[str, Any]] = []
        self._times = (np.arange(len(recording)) / recording.rate).astype("<f4")
        self._inputs: dict[bytes, int] = {}

    def add_mesh(self, name: str, corners: np.ndarray, **attributes: np.ndarray) -> int:
        """A mesh of octahedra (B, 6, 3) with further attributes of its corners."""
        points = corners.reshape(-1, 3).astype("<f4")
        kind = "<u2" if len(points) <= 0xFFFF else "<u4"
        columns = {"POSITION": self.buffer.add(points, target=VERTICES, bounds=True)}
        columns |= {key: self.buffer.add(column, target=VERTICES) for key, column in attributes.items()}
        indices = self.buffer.add(triangles(len(corners)).astype(kind), target=INDICES)
        primitive = {"attributes": columns, "indices": indices, "material": 0}
        self.meshes.append({"name": name, "primitives": [primitive]})
        return len(self.meshes) - 1

    def animate(self, node: int, path: str, values: np.ndarray, rest: Any, *, step: bool = False) -> None:
        """Move a property of a node through `values`, one a frame, unless it always is at rest.

        What stays in another place than at rest gets one key, a step one where it changes.
        """
        changes = np.flatnonzero((values[1:] != values[:-1]).any(axis=1)) + 1
        if not changes.size and np.array_equal(values[0], np.asarray(rest, dtype="<f4")):
            return
        keys = np.concatenate(([0], changes)) if step or not changes.size else slice(None)
        times = self._times[keys]
        stamp = times.tobytes()
        if stamp not in self._inputs:
            self._inputs[stamp] = self.buffer.add(times, bounds=True)
        sampler = {
            "input": self._inputs[stamp],
            "output": self.buffer.add(values[keys]),
            "interpolation": "STEP" if step else "LINEAR",
        }
        self.channels.append({"sampler": len(self.samplers), "target": {"node": node, "path": path}})
        self.samplers.append(sampler)


def _put_skeleton(scene: _Scene, motion: Motion) -> list[int]:
    """A node a joint and end site, a skin of bones over them; the nodes at the top."""
    skeleton = motion.skeleton
    joints, ends = len(skeleton), len(skeleton.end_parents)
    names = [*skeleton.names, *_end_names(skeleton)]
    parents = np.concatenate((skeleton.parents, skeleton.end_parents))
    offsets = np.concatenate((skeleton.offsets, skeleton.end_offsets))
    children: list[list[int]] = [[] for _ in names]
    for node, parent in enumerate(parents.tolist()):
        if parent >= 0:
            children[parent].append(node)
    for name, offset, below in zip(names, offsets.astype("<f4"), children):
        scene.nodes.append(
            {"name": name, "translation": offset.tolist()} | ({"children": below} if below else {})
        )
    armature, skin = joints + ends, joints + ends + 1
    tops = np.flatnonzero(parents < 0).tolist()
    scene.nodes.append({"name": scene.name, "children": tops})

    rest = offsets.copy()
    for node, parent in enumerate(parents):
        if parent >= 0:
            rest[node] += rest[parent]
    inverse = np.tile(np.eye(4), (len(names), 1, 1))
    inverse[:, 3, :3] = -rest  # a matrix stands by columns
    corners, moves_with = bone_shapes(skeleton, rest[:joints])
    bound = np.zeros((6 * len(corners), 4), dtype="|u1" if len(names) <= 256 else "<u2")
    bound[:, 0] = np.repeat(moves_with, 6)
    weights = np.tile(np.array([1, 0, 0, 0], dtype="<f4"), (len(bound), 1))
    mesh = scene.add_mesh("bones", corners, JOINTS_0=bound, WEIGHTS_0=weights)
    scene.nodes.append({"name": f"{scene.name} bones", "mesh": mesh, "skin": 0})
    matrices = scene.buffer.add(inverse.astype("<f4"))
    scene.skins.append(
        {"skeleton": armature, "joints": list(range(len(names))), "inverseBindMatrices": matrices}
    )

    positions = _by_point(motion.local_positions)
    quaternions = _by_point(motion.local_rotations[..., [1, 2, 3, 0]])
    for joint in range(joints):
        scene.animate(joint, "translation", positions[joint], skeleton.offsets[joint])
        scene.animate(joint, "rotation", quaternions[joint], (0.0, 0.0, 0.0, 1.0))
    return [armature, skin]


def _put_points(scene: _Scene, points: Trajectories) -> list[int]:
    """A node a point, of scale 0 where it is unseen; the nodes at the top."""
    mesh = scene.add_mesh("point", point_shape()[None])
    frames, count = points.positions.shape[:2]
    seen = ~np.isnan(points.positions).any(axis=-1)
    # an unseen point stays where it was last seen, before that where it is first seen
    last = np.maximum.accumulate(np.where(seen, np.arange(frames)[:, None], seen.argmax(axis=0)), axis=0)
    places = _by_point(np.nan_to_num(np.take_along_axis(points.positions, last[..., None], axis=0)))
    sizes = np.repeat(seen.T.astype("<f4")[..., None], 3, axis=-1)
    for k, name in enumerate(points.names):
        node = {"name": name, "mesh": mesh, "translation": places[k, 0].tolist()}
        scene.nodes.append(node if seen[0, k] else node | {"scale": [0.0, 0.0, 0.0]})
        scene.animate(k, "translation", places[k], places[k, 0])
        scene.animate(k, "scale", sizes[k], sizes[k, 0], step=True)
    scene.nodes.append({"name": scene.name, "children": list(range(count))})
    return [count]


def _by_point(values: np.ndarray) -> np.ndarray:
    """32-bit floats, (J, T, C), each point's contiguous."""
    return np.ascontiguousarray(values.transpose(1, 0, 2), dtype="<f4")


def _end_names(skeleton: Skeleton) -> list[str]:
    counts: dict[int, int] = {}
    names = []
    for joint in skeleton.end_parents.tolist():
        counts[joint] = counts.get(joint, 0) + 1
        names.append(f"{skeleton.names[joint]}_end{counts[joint] if counts[joint] > 1 else ''}")
    return names


def _check(recording: Motion | Trajectories) -> None:
    frames = len(recording)
    if isinstance(recording, Trajectories):
        count, components = recording.positions.shape[1:]
        if components != 3 or recording.unit != "m":
            what = "with 2 coordinates" if components != 3 else f"in the unit {recording.unit!r}"
            raise ParameterError(
                f"A glTF holds points in space, in metres, got points {what}.",
                remedy="Write them as .csv or .npz.",
            )
        if not count:
            raise ParameterError("A glTF of points holds at least one, got none.")
        largest = np.nanmax(np.abs(recording.positions), initial=0.0)
    else:
        largest = np.abs(recording.local_positions).max(initial=0.0)
    if not frames:
        raise ParameterError("A glTF holds at least one frame, got none.")
    if largest > np.finfo(np.float32).max:
        raise ParameterError(f"A glTF holds 32-bit floats, got a place of {largest:g} m.")
    times = (np.arange(frames) / recording.rate).astype(np.float32)
    if not np.isfinite(times[-1]) or (np.diff(times) <= 0).any():
        raise ParameterError(
            f"A glTF holds times as 32-bit floats, in which frames of {1 / recording.rate:g} s at "
            f"{frames / recording.rate:g} s are one.",
            remedy="Write it in parts.",
        )


def _generator() -> str:
    try:
        return f"Leitmotion {version('leitmotion')}"
    except PackageNotFoundError:  # run from its sources
        return "Leitmotion"
