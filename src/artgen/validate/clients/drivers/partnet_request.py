"""Requests about exports in the layout `partnet-mobility`, whose links and joints are numbered.

`artgen_names.json` has the meaning of the numbers, the reversed joints, and the axes.
"""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

_LAYOUT = "partnet-mobility"
_NAMES = "artgen_names.json"

Read = Callable[[dict[str, Any]], dict[str, Any]]


def numbered(read: Read) -> Read:
    """Return a function that answers requests in that layout by calling `read` with the numbers."""

    def answer(request: dict[str, Any]) -> dict[str, Any]:
        if request["layout"] != _LAYOUT:
            return read(request)
        names = json.loads((Path(request["directory"]) / _NAMES).read_text(encoding="utf-8"))
        return _named(read(_with_numbers(request, names)), names)

    return answer


def _with_numbers(request: dict[str, Any], names: dict[str, Any]) -> dict[str, Any]:
    links = {name: number for number, name in names["links"].items()}
    joints = {item["name"]: (number, item["sign"]) for number, item in names["joints"].items()}

    def changed(joint: dict[str, Any]) -> dict[str, Any]:
        number, sign = joints[joint["name"]]
        leader = joint["follows"]
        return {
            **joint,
            "name": number,
            "limits": _turned(joint["limits"], sign),
            "rest": sign * joint["rest"],
            "follows": None if leader is None else joints[leader][0],
        }

    return {
        **request,
        "links": [links[name] for name in request["links"]],
        "joints": [changed(joint) for joint in request["joints"]],
        "poses": [
            {joints[name][0]: joints[name][1] * value for name, value in pose.items()}
            for pose in request["poses"]
        ],
    }


def _named(response: dict[str, Any], names: dict[str, Any]) -> dict[str, Any]:
    links, joints = names["links"], names["joints"]
    axes = np.array(names["axes"], float)
    turn = np.eye(4)
    turn[:3, :3] = axes.T

    def link(found: dict[str, Any]) -> dict[str, Any]:
        center, inertia = np.array(found["center"], float), np.array(found["inertia"], float)
        return {"mass": found["mass"], "center": axes.T @ center, "inertia": axes.T @ inertia @ axes}

    def joint(number: str, found: dict[str, Any]) -> dict[str, Any]:
        sign = joints[number]["sign"]
        result = {**found, "limits": _turned(found["limits"], sign)}
        return {**result, "rest": sign * found["rest"]} if "rest" in found else result

    changed: dict[str, Any] = {
        "links": {links[name]: link(found) for name, found in response.get("links", {}).items()},
        "joints": {joints[name]["name"]: joint(name, found) for name, found in response["joints"].items()},
        "poses": [
            {links[name]: turn @ np.asarray(frame) @ turn.T for name, frame in pose.items()}
            for pose in response.get("poses", [])
        ],
        "moved": {
            joints[name]["name"]: _turned(found, joints[name]["sign"])
            for name, found in response.get("moved", {}).items()
        },
    }
    told = {key: value for key, value in response.items() if key != "couplings"}  # not all are in the URDF
    return {**told, **{key: value for key, value in changed.items() if key in told}}


def _turned(limits: Any, sign: int) -> Any:
    """Return lowest and highest position of a joint, reversed for the sign -1."""
    return limits if limits is None or sign > 0 else [-limits[1], -limits[0]]
