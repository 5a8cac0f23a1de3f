"""A cabinet with a door and a drawer, as other tools would write it, in three formats."""

import math
from pathlib import Path
from typing import Any

import numpy as np

FORMATS = ("urdf", "mjcf", "usd")

SOUND: dict[str, Any] = {
    "hinge_low": 0.0,
    "hinge_x": -0.42,
    "hinge_axis": -1,
    "leaf_top": 0.598,
    "drawer_low": 0.0,
    "drawer_axis": (0, -1, 0),
    "tray_width": 0.72,
    "shelf": 0.6,
}
"""Dimensions of a cabinet without collisions [m, rad]."""

FAULTS: dict[str, Any] = {
    "hinge_low": -0.2,
    "hinge_x": -0.2,
    "hinge_axis": 1,
    "leaf_top": 0.61,
    "drawer_low": -0.05,
    "drawer_axis": (1, 0, 0),
    "tray_width": 0.77,
    "shelf": 0.615,
}
"""A wrong value for each dimension, with which links collide."""

HINGE, SLIDE = (0.0, 1.9), (0.0, 0.4)


def boxes(size: dict[str, Any]) -> dict[str, list[tuple[str, list[float], list[float]]]]:
    """Return name, center and full lengths of the boxes of each body [m]."""
    top = size["leaf_top"]
    return {
        "case": [
            ("left", [-0.4, 0.0, 0.5], [0.04, 0.6, 1.0]),
            ("right", [0.4, 0.0, 0.5], [0.04, 0.6, 1.0]),
            ("shelf", [0.0, 0.0, size["shelf"]], [0.76, 0.6, 0.02]),
        ],
        "door": [("leaf", [0.0, -0.311, top / 2], [0.84, 0.018, top])],
        "drawer": [
            ("tray", [0.0, 0.0, 0.76], [size["tray_width"], 0.56, 0.28]),
            ("front", [0.0, -0.311, 0.801], [0.84, 0.018, 0.398]),
        ],
    }


def joints(size: dict[str, Any]) -> list[tuple[str, str, tuple[float, ...], list[float], list[float]]]:
    """Return name, child, axis, pivot and limits of the joints."""
    hinge = [size["hinge_x"], -0.302, 0.0]
    return [
        ("hinge", "door", (0, 0, size["hinge_axis"]), hinge, [size["hinge_low"], HINGE[1]]),
        ("slide", "drawer", size["drawer_axis"], [0.0, 0.0, 0.0], [size["drawer_low"], SLIDE[1]]),
    ]


def cabinet(form: str, folder: Path, *, extra: str = "", **changes: Any) -> Path:
    """Write the cabinet with changed dimensions; `extra` goes before the end of the file's root."""
    write = {"urdf": _urdf, "mjcf": _mjcf, "usd": _usd}[form]
    path = folder / f"cabinet.{ {'mjcf': 'xml', 'usd': 'usda'}.get(form, form) }"
    path.write_text(write(SOUND | changes, extra), encoding="utf-8")
    return path


def _text(numbers: Any) -> str:
    return " ".join(f"{number:.9g}" for number in numbers)


def _local(center: list[float], pivot: list[float]) -> list[float]:
    return [a - b for a, b in zip(center, pivot, strict=True)]


def _urdf(size: dict[str, Any], extra: str) -> str:
    pivots = {child: pivot for _, child, _, pivot, _ in joints(size)}
    lines = ['<robot name="cabinet">']
    for body, solids in boxes(size).items():
        lines.append(f'<link name="{body}">')
        for name, center, lengths in solids:
            at = _text(_local(center, pivots.get(body, [0.0, 0.0, 0.0])))
            lines.append(f'<collision name="{name}"><origin xyz="{at}"/>')
            lines.append(f'<geometry><box size="{_text(lengths)}"/></geometry></collision>')
        lines.append("</link>")
    for name, child, axis, pivot, (low, high) in joints(size):
        kind = "revolute" if name == "hinge" else "prismatic"
        lines.append(f'<joint name="{name}" type="{kind}"><parent link="case"/><child link="{child}"/>')
        lines.append(f'<origin xyz="{_text(pivot)}"/><axis xyz="{_text(axis)}"/>')
        lines.append(f'<limit lower="{low:.9g}" upper="{high:.9g}" effort="10" velocity="1"/></joint>')
    return "\n".join([*lines, extra, "</robot>\n"])


def _mjcf(size: dict[str, Any], extra: str) -> str:
    found = boxes(size)

    def geoms(body: str) -> str:
        return "\n".join(
            f'<geom name="{name}" type="box" pos="{_text(center)}" size="{_text(0.5 * np.array(lengths))}"/>'
            for name, center, lengths in found[body]
        )

    lines = ['<mujoco><compiler angle="radian"/>', '<worldbody><body name="case">', geoms("case")]
    for name, child, axis, pivot, (low, high) in joints(size):
        kind = "hinge" if name == "hinge" else "slide"
        lines.append(f'<body name="{child}"><joint name="{name}" type="{kind}" axis="{_text(axis)}"')
        lines.append(f'pos="{_text(pivot)}" limited="true" range="{low:.9g} {high:.9g}"/>')
        lines += [geoms(child), "</body>"]
    return "\n".join([*lines, "</body></worldbody>", extra, "</mujoco>\n"])


def _usd(size: dict[str, Any], extra: str) -> str:
    head = ["#usda 1.0", "(", 'defaultPrim = "cabinet"', "metersPerUnit = 1", 'upAxis = "Z"', ")"]
    lines = [*head, 'def Xform "cabinet" {']
    for body, solids in boxes(size).items():
        lines.append(f'def Xform "{body}" (prepend apiSchemas = ["PhysicsRigidBodyAPI"]) {{')
        if body == "case":
            lines.append("bool physics:kinematicEnabled = 1")
        for name, center, lengths in solids:
            lines.append(f'def Cube "{name}" (prepend apiSchemas = ["PhysicsCollisionAPI"]) {{')
            lines.append("double size = 1")
            lines.append(f"double3 xformOp:translate = ({', '.join(map(str, center))})")
            lines.append(f"double3 xformOp:scale = ({', '.join(map(str, lengths))})")
            lines.append('uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]\n}')
        lines.append("}")
    for name, child, axis, pivot, limits in joints(size):
        kind = "PhysicsRevoluteJoint" if name == "hinge" else "PhysicsPrismaticJoint"
        low, high = (math.degrees(end) if name == "hinge" else end for end in limits)
        index = next(number for number, each in enumerate(axis) if each)
        low, high = (low, high) if axis[index] > 0 else (-high, -low)
        lines.append(f'def {kind} "{name}" {{')
        lines.append(f'uniform token physics:axis = "{"XYZ"[index]}"')
        lines.append(f"rel physics:body0 = </cabinet/case>\nrel physics:body1 = </cabinet/{child}>")
        lines.append("bool physics:collisionEnabled = 1")
        at = f"({', '.join(map(str, pivot))})"
        lines.append(f"point3f physics:localPos0 = {at}\npoint3f physics:localPos1 = {at}")
        lines.append(f"float physics:lowerLimit = {low!r}\nfloat physics:upperLimit = {high!r}\n}}")
    return "\n".join([*lines, extra, "}\n"])
