"""An independent look at glTF 2.0: a strict check of what the specification asks for, and poses by 4 x 4 matrices."""

import base64
import json
import struct

import numpy as np
from scipy.spatial.transform import Rotation

TYPES = {5121: "u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Gltf:
    """A .gltf or .glb, unpacked and checked."""

    def __init__(self, content):
        if content[:4] == b"glTF":
            version, total = struct.unpack_from("<II", content, 4)
            assert (version, total) == (2, len(content))
            length, kind = struct.unpack_from("<I4s", content, 12)
            assert kind == b"JSON"
            assert length % 4 == 0
            self.document = json.loads(content[20 : 20 + length])
            size, kind = struct.unpack_from("<I4s", content, 20 + length)
            assert kind == b"BIN\0"
            assert size % 4 == 0
            self.buffer = content[28 + length :]
            assert len(self.buffer) == size
            assert 0 <= size - self.document["buffers"][0]["byteLength"] < 4
        else:
            self.document = json.loads(content.decode("utf-8"))
            kind, _, data = self.document["buffers"][0].pop("uri").partition(",")
            assert kind == "data:application/octet-stream;base64"
            self.buffer = base64.b64decode(data, validate=True)
            assert len(self.buffer) == self.document["buffers"][0]["byteLength"]
        self.nodes = self.document["nodes"]
        self._check()

    def array(self, accessor):
        accessor = self.document["accessors"][accessor]
        view = self.document["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(TYPES[accessor["componentType"]]), WIDTHS[accessor["type"]]
        assert view["byteOffset"] % 4 == 0
        assert view["byteLength"] == accessor["count"] * width * kind.itemsize
        assert view["byteOffset"] + view["byteLength"] <= len(self.buffer)
        values = np.frombuffer(self.buffer, kind, accessor["count"] * width, view["byteOffset"])
        values = values.reshape(-1, width).astype(np.float64)
        if "min" in accessor:
            np.testing.assert_array_equal(accessor["min"], values.min(axis=0))
            np.testing.assert_array_equal(accessor["max"], values.max(axis=0))
        assert np.isfinite(values).all()
        return values

    def parents(self):
        parents = [-1] * len(self.nodes)
        for k, node in enumerate(self.nodes):
            for child in node.get("children", []):
                assert parents[child] == -1, "a node has one parent"
                parents[child] = k
        return parents

    def _check(self):
        document, parents = self.document, self.parents()
        for key in (
            "nodes",
            "meshes",
            "accessors",
            "bufferViews",
            "buffers",
            "scenes",
            "animations",
            "skins",
        ):
            assert document.get(key) != [], f"{key} must not be empty"
        assert document["asset"]["version"] == "2.0"
        tops = document["scenes"][document["scene"]]["nodes"]
        assert sorted(tops) == [k for k, parent in enumerate(parents) if parent < 0]
        for k in range(len(self.nodes)):
            way = set()
            while k >= 0:
                assert k not in way, "the nodes are a tree"
                way.add(k)
                k = parents[k]
        for node in self.nodes:
            assert node.get("children") != []
            assert np.isfinite([*node.get("translation", []), *node.get("scale", [])]).all()
        for mesh in document["meshes"]:
            for primitive in mesh["primitives"]:
                self._check_primitive(primitive)
        for skin in document.get("skins", []):
            matrices = self.array(skin["inverseBindMatrices"])
            assert len(matrices) == len(skin["joints"]) == len(set(skin["joints"]))
            np.testing.assert_array_equal(matrices[:, [3, 7, 11, 15]], [[0, 0, 0, 1]] * len(matrices))
        for node in self.nodes:
            if "skin" in node:
                assert self.nodes.index(node) in tops, "what stands above a skinned mesh would not move it"
        for animation in document.get("animations", []):
            targets = [(c["target"]["node"], c["target"]["path"]) for c in animation["channels"]]
            assert len(set(targets)) == len(targets)
            assert sorted(c["sampler"] for c in animation["channels"]) == list(
                range(len(animation["samplers"]))
            )
            for channel in animation["channels"]:
                self._check_sampler(animation["samplers"][channel["sampler"]], channel["target"]["path"])

    def _check_primitive(self, primitive):
        views, accessors = self.document["bufferViews"], self.document["accessors"]
        attributes = primitive["attributes"]
        assert {views[accessors[a]["bufferView"]]["target"] for a in attributes.values()} == {34962}
        assert views[accessors[primitive["indices"]]["bufferView"]]["target"] == 34963
        points, corners = self.array(attributes["POSITION"]), self.array(primitive["indices"]).astype(int)
        assert {"min", "max"} <= set(accessors[attributes["POSITION"]])
        assert sorted(set(corners.ravel())) == list(range(len(points)))
        a, b, c = points[corners.reshape(-1, 3)].transpose(1, 0, 2)
        middle = points.reshape(-1, 6, 3).mean(axis=1)[corners.reshape(-1, 3)[:, 0] // 6]
        normal = np.cross(b - a, c - a)
        assert (np.einsum("kc,kc->k", normal, a - middle) > 0).all(), "every triangle shows its face outwards"
        if "JOINTS_0" in attributes:
            weights, joints = self.array(attributes["WEIGHTS_0"]), self.array(attributes["JOINTS_0"])
            np.testing.assert_array_equal(weights.sum(axis=1), 1.0)
            assert (joints[weights == 0] == 0).all()
            assert joints.max() < len(self.document["skins"][0]["joints"])

    def _check_sampler(self, sampler, path):
        times, values = self.array(sampler["input"])[:, 0], self.array(sampler["output"])
        accessor = self.document["accessors"][sampler["input"]]
        assert {"min", "max"} <= set(accessor)
        assert times[0] == 0
        assert (np.diff(times) > 0).all()
        assert len(values) == len(times)
        assert sampler["interpolation"] == ("STEP" if path == "scale" else "LINEAR")
        if path == "rotation":
            np.testing.assert_allclose(np.linalg.norm(values, axis=1), 1.0, atol=1e-6)

    def moved(self):
        """Which properties of which nodes are animated: {(name, path): (times, values)}."""
        return {
            (self.nodes[channel["target"]["node"]]["name"], channel["target"]["path"]): (
                self.array(animation["samplers"][channel["sampler"]]["input"])[:, 0],
                self.array(animation["samplers"][channel["sampler"]]["output"]),
            )
            for animation in self.document.get("animations", [])
            for channel in animation["channels"]
        }

    def world(self, time):
        """Matrix of each node in the world at a time that is one of the keys' (to half a millisecond)."""
        local = []
        for node in self.nodes:
            local.append(
                {"translation": np.zeros(3), "rotation": np.array([0.0, 0, 0, 1]), "scale": np.ones(3)}
            )
            local[-1] |= {key: np.array(node[key]) for key in local[-1] if key in node}
        for animation in self.document.get("animations", []):
            for channel in animation["channels"]:
                sampler, target = animation["samplers"][channel["sampler"]], channel["target"]
                times, values = self.array(sampler["input"])[:, 0], self.array(sampler["output"])
                key = np.flatnonzero(times <= time + 5e-4)[-1]
                assert sampler["interpolation"] == "STEP" or len(times) == 1 or abs(times[key] - time) < 5e-4
                local[target["node"]][target["path"]] = values[key]
        world = [None] * len(self.nodes)

        def place(k, above):
            matrix = np.eye(4)
            matrix[:3, :3] = Rotation.from_quat(local[k]["rotation"]).as_matrix() * local[k]["scale"]
            matrix[:3, 3] = local[k]["translation"]
            world[k] = above @ matrix
            return world[k]

        stack = [(k, np.eye(4)) for k in self.document["scenes"][0]["nodes"]]
        while stack:
            k, above = stack.pop()
            matrix = place(k, above)
            stack += [(child, matrix) for child in self.nodes[k].get("children", [])]
        return np.array(world)

    def skinned(self, world):
        """Corners of the skinned mesh in the world, (B, 6, 3)."""
        skin = self.document["skins"][0]
        attributes = self.document["meshes"][0]["primitives"][0]["attributes"]
        inverse = self.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
        points, joints = (
            self.array(attributes["POSITION"]),
            self.array(attributes["JOINTS_0"])[:, 0].astype(int),
        )
        bind = world[skin["joints"]] @ inverse
        return np.einsum("kij,kj->ki", bind[joints][:, :3, :3], points).reshape(-1, 6, 3) + bind[joints][
            :, :3, 3
        ].reshape(-1, 6, 3)
