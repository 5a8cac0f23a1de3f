"""Short texts for values and inputs of nodes."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from artgen.asset.joint import AssetJoint
from artgen.asset.shape import Curve, Outline, Shape
from artgen.asset.tree import Tree
from artgen.graph.node import Node

_NAMES = 4  # most names in a text
_LONGEST = 60  # most characters of a literal
_TURNED = (4, 4)  # shape of a frame


def value_text(value: Any) -> str:
    """Describe the value of a node."""
    if isinstance(value, bool | np.bool_):
        return str(bool(value))
    if isinstance(value, float | int | np.number):
        return _number(value)
    if isinstance(value, np.ndarray):
        return _array(value)
    if isinstance(value, Shape):
        size = np.ptp(value.bounds(), axis=0)
        return f"solid, {' x '.join(f'{each:.3g}' for each in size)} m, {len(value.mesh.triangles)} triangles"
    if isinstance(value, Tree):
        links, joints = [link.name for link in value.links()], [joint.name for joint in value.joints()]
        return _listed("link", links) + (f"; {_listed('joint', joints)}" if joints else "")
    if isinstance(value, AssetJoint):
        return _joint(value)
    if isinstance(value, Outline):
        points = sum(len(contour.points) for contour in value.contours)
        return f"profile, {_count(len(value.contours), 'contour')}, {_count(points, 'point')}"
    if isinstance(value, Curve):
        return f"{'closed path' if value.closed else 'path'}, {_count(len(value.points), 'point')}"
    return _cut(str(value))


def input_text(value: Any, number: Mapping[str, int]) -> list[str | int]:
    """Describe an input; numbers in the result refer to nodes."""
    if isinstance(value, Node):
        return [number[value.key]]
    if isinstance(value, tuple):
        parts: list[str | int] = ["("]
        for index, item in enumerate(value):
            parts += [", "] * (index > 0) + input_text(item, number)
        return [*parts, ")"]
    if isinstance(value, Mapping):  # JSON data of an object: {"$material": {"name": ...}}
        tag, data = next(iter(value.items()), ("", ""))
        named = data.get("name") if isinstance(data, Mapping) else data
        return [_cut(f"{str(tag).removeprefix('$')} {named}")]
    return [_number(value) if isinstance(value, float) else _cut(repr(value))]


def _joint(joint: AssetJoint) -> str:
    unit = "rad" if joint.kind == "revolute" else "m"
    limits = joint.limits
    reach = "unlimited" if limits is None else f"{_number(limits[0])} to {_number(limits[1])} {unit}"
    return f"{joint.kind} {joint.name}, {reach}"


def _array(value: np.ndarray[Any, Any]) -> str:
    if value.shape == _TURNED:
        return f"frame at {_row(value[:3, 3])}"
    if value.ndim == 1 and len(value) <= _NAMES:
        return _row(value)
    return (
        f"{_count(len(value), 'point')}, first {_row(value[0])}"
        if value.ndim == 2 and len(value)
        else "empty"
    )


def _row(values: Any) -> str:
    return f"({', '.join(_number(each) for each in values)})"


def _number(value: Any) -> str:
    return f"{float(value) + 0.0:.5g}"


def _listed(what: str, names: list[str]) -> str:
    more = ", ..." if len(names) > _NAMES else ""
    return f"{_count(len(names), what)}: {', '.join(names[:_NAMES])}{more}"


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"
