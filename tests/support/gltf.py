"""A reader of GLB files that shares nothing with the writer: structure, arrays, and nodes that move."""

import json
import struct

import numpy as np

_TYPES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_FORMS = {5123: np.dtype("<u2"), 5125: np.dtype("<u4"), 5126: np.dtype("<f4")}
_UPRIGHT = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
"""From glTF's axes, y up, to those of assets, z up."""


class Gltf:
    """A GLB file whose container, views and accessors were checked while it was read."""

    def __init__(self, content):
        magic, version, length = struct.unpack_from("<4sII", content)
        assert (magic, version, length) == (b"glTF", 2, len(content))
        size, kind = struct.unpack_from("<I4s", content, 12)
        assert kind == b"JSON"
        assert size % 4 == 0
        self.data = json.loads(content[20 : 20 + size])
        binary_size, kind = struct.unpack_from("<I4s", content, 20 + size)
        assert kind == b"BIN\0"
        assert binary_size % 4 == 0
        self.binary = content[28 + size :]
        assert len(self.binary) == binary_size == self.data["buffers"][0]["byteLength"]
        self._check_views()
        self.nodes = {node["name"]: node for node in self.data["nodes"]}
        assert len(self.nodes) == len(self.data["nodes"])

    @property
    def root(self):
        (number,) = self.data["scenes"][self.data["scene"]]["nodes"]
        return self.data["nodes"][number]

    @property
    def joints(self):
        return {joint["name"]: joint for joint in self.root["extras"]["artgen"]["joints"]}

    def _check_views(self):
        end = 0
        for view in self.data["bufferViews"]:
            assert view["byteOffset"] % 4 == 0
            assert view["byteOffset"] >= end
            end = view["byteOffset"] + view["byteLength"]
            assert view["byteLength"] > 0
        assert end <= len(self.binary)

    def view(self, number):
        view = self.data["bufferViews"][number]
        return self.binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]

    def array(self, number):
        """An accessor, whose bounds, alignment and size are checked."""
        accessor = self.data["accessors"][number]
        form, columns = _FORMS[accessor["componentType"]], _TYPES[accessor["type"]]
        view = self.data["bufferViews"][accessor["bufferView"]]
        row = form.itemsize * columns
        assert view.get("byteStride", row) == row
        assert accessor["byteOffset"] % form.itemsize == 0
        assert accessor["byteOffset"] + accessor["count"] * row <= view["byteLength"]
        values = np.frombuffer(
            self.view(accessor["bufferView"]), form, accessor["count"] * columns, accessor["byteOffset"]
        )
        rows = values.reshape(-1, columns)
        for bound, found in (("min", rows.min(axis=0)), ("max", rows.max(axis=0))):
            if bound in accessor:
                assert accessor[bound] == found.tolist()
        return values if columns == 1 else rows

    def primitives(self, node):
        """What a node shows: for each primitive its arrays by attribute, its triangles and its material."""
        mesh = self.data["meshes"][self.nodes[node]["mesh"]]
        for primitive in mesh["primitives"]:
            arrays = {name: self.array(number) for name, number in primitive["attributes"].items()}
            triangles = self.array(primitive["indices"]).reshape(-1, 3)
            yield primitive, arrays, triangles, self.data["materials"][primitive["material"]]

    def placed(self, changes=None):
        """Where each node stands in asset coordinates, shape (4, 4), some local transforms being changed.

        `changes` has `translation` and `rotation` of nodes by their names.
        """
        result = {}
        todo = [(self.root, _UPRIGHT)]
        while todo:
            node, above = todo.pop()
            local = {**node, **(changes or {}).get(node["name"], {})}
            matrix = np.eye(4)
            matrix[:3, :3] = turned(local.get("rotation", [0, 0, 0, 1]))
            matrix[:3, 3] = local.get("translation", [0, 0, 0])
            result[node["name"]] = above @ matrix
            children = node.get("children", [])
            todo += [(self.data["nodes"][number], result[node["name"]]) for number in children]
        assert len(result) == len(self.nodes)
        return result

    def moved(self, positions):
        """The changes of nodes that put free joints at positions, as a viewer makes them."""
        result = {}
        for joint in self.joints.values():
            if joint["type"] == "fixed":
                continue
            mimic = joint["mimic"]
            name = mimic["joint"] if mimic else joint["name"]
            at = positions.get(name, self.joints[name]["position"])
            at = mimic["multiplier"] * at + mimic["offset"] if mimic else at
            axis, origin = np.array(joint["axis"]), np.array(joint["origin"])
            if joint["type"] == "prismatic":
                result[joint["node"]] = {"translation": origin + at * axis}
            else:
                result[joint["node"]] = {"rotation": [*(np.sin(at / 2) * axis), np.cos(at / 2)]}
        return result

    def animation(self, name):
        (found,) = [each for each in self.data["animations"] if each["name"] == name]
        return found

    def keys(self, name):
        """Times of an animation's keys."""
        (number,) = {sampler["input"] for sampler in self.animation(name)["samplers"]}
        return self.array(number).astype(float)

    def at(self, name, time):
        """The changes of nodes that an animation makes at a time."""
        animation, times = self.animation(name), self.keys(name)
        number = min(int(np.searchsorted(times, time, side="right")) - 1, len(times) - 2)
        share = (time - times[number]) / (times[number + 1] - times[number])
        result = {}
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            assert sampler.get("interpolation", "LINEAR") == "LINEAR"
            a, b = self.array(sampler["output"]).astype(float)[number : number + 2]
            path = channel["target"]["path"]
            value = a + share * (b - a) if path == "translation" else _between(a, b, share)
            node = self.data["nodes"][channel["target"]["node"]]["name"]
            result.setdefault(node, {})[path] = value
        return result

    def position(self, joint, changes):
        """Where a joint stands once nodes are changed [rad or m]; turns are known up to full ones."""
        node = self.nodes[joint["node"]]
        if joint["type"] == "prismatic":
            place = changes.get(joint["node"], {}).get("translation", node.get("translation", [0, 0, 0]))
            return float((np.array(place) - joint["origin"]) @ joint["axis"])
        turn = changes.get(joint["node"], {}).get("rotation", node.get("rotation", [0, 0, 0, 1]))
        return float(2.0 * np.arctan2(np.array(turn[:3]) @ joint["axis"], turn[3]))


def turned(quaternion):
    """The rotation of a unit quaternion (x, y, z, w), shape (3, 3)."""
    x, y, z, w = quaternion
    assert abs(np.linalg.norm(quaternion) - 1.0) < 1e-5
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def _between(a, b, share):
    """Spherical interpolation, the shorter way."""
    cosine = float(a @ b)
    if cosine < 0.0:
        b, cosine = -b, -cosine
    angle = np.arccos(min(cosine, 1.0))
    if angle < 1e-6:
        return a + share * (b - a)
    return (np.sin((1 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)
