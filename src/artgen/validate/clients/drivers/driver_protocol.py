"""Shared functions of drivers: requests, responses, layouts, and numbers in the form of a response."""

import importlib.metadata
import importlib.util
import json
import os
import re
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

Read = Callable[[dict[str, Any]], dict[str, Any]]

MISSING = 3  # exit code of a driver whose client is not installed
UNLIMITED = 1e5  # limits, efforts and speeds from this number on count as none
_NAMES = "artgen_names.json"  # names of links and joints in the file, signs of reversed joints, and the axes


def require(*modules: str) -> None:
    """End the process if a module of the client is not installed."""
    if any(importlib.util.find_spec(name) is None for name in modules):
        sys.exit(MISSING)


def serve(read: Read) -> None:
    """Answer each request on the command line; add the version of the client's Python distribution."""
    paths = [Path(argument) for argument in sys.argv[1:]]
    for source, target in zip(paths[::2], paths[1::2], strict=True):
        request = json.loads(source.read_text(encoding="utf-8"))
        renamed = (Path(request["directory"]) / _NAMES).exists()
        answer = _read_renamed(read, request) if renamed else read(request)
        if request["distribution"]:
            answer["version"] = importlib.metadata.version(request["distribution"])
        sys.stdout.flush()
        partial = target.with_name(target.name + ".partial")
        partial.write_text(json.dumps(answer, default=_plain), encoding="utf-8")
        os.replace(partial, target)  # noqa: PTH105 - the same in all versions of Python


def _plain(value: Any) -> Any:
    return np.asarray(value, float).tolist()


def _read_renamed(read: Read, request: dict[str, Any]) -> dict[str, Any]:
    """Return a response in the asset's names from a driver that reads links and joints of other names."""
    names = json.loads((Path(request["directory"]) / _NAMES).read_text(encoding="utf-8"))
    links, joints = names["links"], names["joints"]
    numbers = {name: number for number, name in links.items()}
    joint_numbers = {item["name"]: number for number, item in joints.items()}
    signs = {number: item["sign"] for number, item in joints.items()}

    def numbered(joint: dict[str, Any]) -> dict[str, Any]:
        number, follows = joint_numbers[joint["name"]], joint_numbers.get(joint["follows"])
        limits, rest = reverse(number, joint["limits"]), signs[number] * joint["rest"]
        freed = {joint_numbers[name]: side for name, side in joint["freed"].items()}
        freed = {name: side if signs[name] > 0 else 1 - side for name, side in freed.items()}
        changes = {"name": number, "follows": follows, "limits": limits, "rest": rest, "freed": freed}
        if curve := joint["curve"]:
            turned = (signs[each] * np.array(row) for each, row in zip((follows, number), curve, strict=True))
            changes["curve"] = np.array(sorted(zip(*turned, strict=True))).T.tolist()
        return {**joint, **changes}

    def reverse(number: str, limits: Any) -> Any:
        return limits if limits is None or signs[number] > 0 else [-limits[1], -limits[0]]

    poses = [{joint_numbers[name]: value for name, value in pose.items()} for pose in request["poses"]]
    response = read(
        {
            **request,
            "links": [numbers[name] for name in request["links"]],
            "joints": [numbered(joint) for joint in request["joints"]],
            "poses": [{number: signs[number] * value for number, value in pose.items()} for pose in poses],
        }
    )
    axes = np.array(names["axes"], float).T
    turn = transform(axes, np.zeros(3))
    changes: dict[str, Callable[[Any], Any]] = {
        "links": lambda found: {
            links[number]: mass_properties(
                link["mass"], axes @ np.array(link["center"], float), link["inertia"], axes
            )
            for number, link in found.items()
        },
        "joints": lambda found: {
            joints[number]["name"]: {**joint, "limits": reverse(number, joint["limits"])}
            for number, joint in found.items()
        },
        "poses": lambda found: [
            {links[number]: turn @ np.asarray(frame) @ turn.T for number, frame in pose.items()}
            for pose in found
        ],
        "moved": lambda found: {joints[key]["name"]: reverse(key, span) for key, span in found.items()},
        "couplings": lambda found: {
            joints[number]["name"]: [joints[leader]["name"], *law] for number, (leader, *law) in found.items()
        },
    }
    if request["layout"] == "partnet-mobility":
        response.pop("couplings", None)  # the URDF of this layout does not have all of them
    return {key: changes.get(key, lambda same: same)(value) for key, value in response.items()}


def transform(rotation: Any, position: Any) -> Any:
    """Return a frame, shape (4, 4), of a rotation, shape (3, 3), and a position, shape (3,) [m]."""
    result = np.eye(4)
    result[:3, :3] = np.asarray(rotation).reshape(3, 3)
    result[:3, 3] = position
    return result


def frame_of(pose: Any) -> Any:
    """Return position and quaternion (x, y, z, w) as a frame, shape (4, 4)."""
    x, y, z, w = np.asarray(pose[3:], float) / np.linalg.norm(pose[3:])
    rotation = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return transform(rotation, pose[:3])


def in_base(frames: dict[str, Any], links: list[str]) -> dict[str, Any]:
    """Return the frames of links in the frame of the base, which is the first link."""
    base = np.linalg.inv(np.asarray(frames[links[0]], float))
    return {name: base @ frames[name] for name in links if name in frames}


def mass_properties(mass: Any, center: Any, inertia: Any, axes: Any = None) -> dict[str, Any]:
    """Return a link of a response.

    `inertia` is a matrix, shape (3, 3), or principal moments, shape (3,), about the columns of `axes`.
    """
    inertia = np.asarray(inertia, float)
    if axes is not None:
        axes = np.asarray(axes).reshape(3, 3)
        inertia = axes @ (np.diag(inertia) if inertia.ndim == 1 else inertia) @ axes.T
    return {"mass": mass, "center": center, "inertia": inertia}


def finite_limits(low: Any, high: Any) -> list[Any] | None:
    """Return the limits of a joint; None if they are infinite or larger than any real limit."""
    return [low, high] if abs(low) < UNLIMITED and abs(high) < UNLIMITED else None


def couplings_to_heads(couplings: dict[str, list[Any]]) -> dict[str, list[Any]]:
    """Return couplings to the free joints at the heads of chains of leaders."""

    def to_head(name: str) -> list[Any]:
        leader, ratio, offset = couplings[name]
        if leader not in couplings:
            return [leader, ratio, offset]
        head, above, shift = to_head(leader)
        return [head, ratio * above, ratio * shift + offset]

    return {name: to_head(name) for name in couplings}


def free(request: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the joints of a request that may be driven alone."""
    return [joint for joint in request["joints"] if joint["follows"] is None and not joint["blocked"]]


def ends(joint: dict[str, Any]) -> tuple[float, float]:
    """Return the two end positions for driving a joint [rad or m]."""
    low, high = joint["limits"] or (-1.0, 1.0)
    return float(low), float(high)


# a layer above the asset's own, as in a scene that uses the asset; the units are the asset's
_SCENE = """#usda 1.0
(
    {metadata}
    subLayers = [@{file}@]
)

over "{asset}" (
    variants = {{
        string {runtime} = "Enabled"
    }}
)
{{
}}
"""

_METADATA = re.compile(r"^    ((?:defaultPrim|kilogramsPerUnit|metersPerUnit|upAxis) = .*)$", re.MULTILINE)


@contextmanager
def enabled(request: dict[str, Any], runtime: str) -> Iterator[str]:
    """Yield the path of a stage; in the layout `simready`, the variant of a simulator is enabled."""
    if request["layout"] != "simready":
        yield request["file"]
        return
    with tempfile.TemporaryDirectory() as folder:
        scene, file = Path(folder) / "scene.usda", Path(request["file"])
        metadata = "\n    ".join(_METADATA.findall(file.read_text(encoding="utf-8")))
        text = _SCENE.format(asset=request["asset"], file=file.as_posix(), metadata=metadata, runtime=runtime)
        scene.write_text(text, encoding="utf-8")
        yield str(scene)
