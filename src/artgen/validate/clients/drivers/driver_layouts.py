"""Layouts of exports that change what a client reads: numbered links and joints, and variants of a stage."""

import json
import re
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

_NAMES = "artgen_names.json"  # meaning of the numbers, the reversed joints, and the axes


def with_layout_names(
    read: Callable[[dict[str, Any]], dict[str, Any]], request: dict[str, Any]
) -> dict[str, Any]:
    """Return the response of a driver, which reads numbers for names in the layout `partnet-mobility`."""
    if request["layout"] != "partnet-mobility":
        return read(request)
    names = json.loads((Path(request["directory"]) / _NAMES).read_text(encoding="utf-8"))
    return _with_names(read(_with_numbers(request, names)), names)


def _with_numbers(request: dict[str, Any], names: dict[str, Any]) -> dict[str, Any]:
    links = {name: number for number, name in names["links"].items()}
    joints = {item["name"]: (number, item["sign"]) for number, item in names["joints"].items()}

    def numbered(joint: dict[str, Any]) -> dict[str, Any]:
        (number, sign), leader = joints[joint["name"]], joint["follows"]
        return {
            **joint,
            "name": number,
            "limits": _reversed(joint["limits"], sign),
            "rest": sign * joint["rest"],
            "follows": None if leader is None else joints[leader][0],
        }

    return {
        **request,
        "links": [links[name] for name in request["links"]],
        "joints": [numbered(joint) for joint in request["joints"]],
        "poses": [
            {joints[name][0]: joints[name][1] * value for name, value in pose.items()}
            for pose in request["poses"]
        ],
    }


def _with_names(response: dict[str, Any], names: dict[str, Any]) -> dict[str, Any]:
    links, joints = names["links"], names["joints"]
    axes = np.array(names["axes"], float)
    turn = np.eye(4)
    turn[:3, :3] = axes.T

    def link(found: dict[str, Any]) -> dict[str, Any]:
        center, inertia = np.array(found["center"], float), np.array(found["inertia"], float)
        return {"mass": found["mass"], "center": axes.T @ center, "inertia": axes.T @ inertia @ axes}

    def joint(found: dict[str, Any], sign: int) -> dict[str, Any]:
        result = {**found, "limits": _reversed(found["limits"], sign)}
        return {**result, "rest": sign * found["rest"]} if "rest" in found else result

    def by_joint(part: str, change: Callable[[Any, int], Any]) -> dict[str, Any]:
        found = response.get(part, {}).items()
        return {joints[number]["name"]: change(value, joints[number]["sign"]) for number, value in found}

    changed: dict[str, Any] = {
        "links": {links[number]: link(found) for number, found in response.get("links", {}).items()},
        "joints": by_joint("joints", joint),
        "poses": [
            {links[number]: turn @ np.asarray(frame) @ turn.T for number, frame in pose.items()}
            for pose in response.get("poses", [])
        ],
        "moved": by_joint("moved", _reversed),
    }
    # the URDF of this layout does not have all couplings
    return {key: changed.get(key, value) for key, value in response.items() if key != "couplings"}


def _reversed(limits: Any, sign: int) -> Any:
    """Return lowest and highest position of a joint, reversed for the sign -1."""
    return limits if limits is None or sign > 0 else [-limits[1], -limits[0]]


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
    """Give the path of a stage for a simulator; in the layout `simready`, its variant is enabled."""
    if request["layout"] != "simready":
        yield request["file"]
        return
    with tempfile.TemporaryDirectory() as folder:
        scene, file = Path(folder) / "scene.usda", Path(request["file"])
        metadata = "\n    ".join(_METADATA.findall(file.read_text(encoding="utf-8")))
        text = _SCENE.format(asset=request["asset"], file=file.as_posix(), metadata=metadata, runtime=runtime)
        scene.write_text(text, encoding="utf-8")
        yield str(scene)
