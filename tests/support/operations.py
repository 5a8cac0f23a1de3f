"""One sample graph for every operation, from the types of its kernel's inputs."""

import importlib
import pkgutil
import typing
from types import NoneType
from typing import Any

import artgen.nodes
from artgen import asset as values
from artgen import signals
from artgen.asset import Curve, Outline, Shape, Tree
from artgen.graph import OPERATIONS, Handle
from artgen.graph.kernel import alternatives
from artgen.materials import Material, material
from artgen.nodes.body import Array4x4, part
from artgen.nodes.grasp_frames import frame
from artgen.nodes.handles import Array3, ArrayN3, Float
from artgen.nodes.joint import Revolute, detents, soft_closing
from artgen.nodes.path import line, spline
from artgen.nodes.primitive import box
from artgen.nodes.profile import circle, rectangle
from artgen.nodes.vector import Z, row
from support.linkages import open_chain

for _module in pkgutil.walk_packages(artgen.nodes.__path__, "artgen.nodes."):
    importlib.import_module(_module.name)

SIZE = Float.parameter("size")
PARAMETERS = {"size": 0.3}
"""Values at which every sample can be evaluated."""

BLOCK = box(SIZE, 0.4, 0.5)
LEADER = Revolute("leader", axis=Z, limits=(0.0, SIZE))

BY_TYPE: dict[Any, Any] = {
    float: SIZE,
    bool: SIZE > 0.1,
    int: 2,
    str: "sample",
    Material: material("oak"),
    Array3: (SIZE, 0.25, 1.0),
    ArrayN3: row((0.0, 0.0, 0.0), (SIZE, 0.0, 0.0), 2),
    Array4x4: frame((0.0, 0.0, SIZE)),
    Shape: BLOCK,
    Outline: rectangle(SIZE, 0.2),
    Curve: line((0.0, 0.0, 0.0), (0.0, SIZE, 1.0)),
    Tree: part(BLOCK, "block", material("oak")),
    values.AssetJoint: Revolute("turn", axis=Z, limits=(-1.0, 0.0)),
    values.AssetCoupling: 4.0 * LEADER + 0.25,
    values.AssetCondition: LEADER > SIZE,
    values.AssetDependency: (LEADER > SIZE).until(0.25),
    values.AssetDetents: detents((0.0, SIZE), 0.25),
    values.AssetSignal: signals.level(LEADER),
    values.AssetSoftClosing: soft_closing(-0.25, preload=1.0, force=2.0, damping=SIZE),
}
"""What an input of each type is given, unless `OVERRIDES` says otherwise."""

_BASE = part(box(1.0, 1.0, 0.1), "base", material("steel"))

OVERRIDES: dict[str, dict[str, Any]] = {
    "allow_contact": {
        "body": _BASE.attach(part(BLOCK, "block", material("oak")), LEADER),
        "a": "base",
        "b": "block/block",
    },
    "array": {"at": row((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), 3), "around": None},
    "attach": {"parent": _BASE},
    "attach_pair": {"parent": _BASE, "suffixes": ("_right", "_left")},
    "cut": {"tool": BLOCK.scale(0.5)},
    "bezier": {"points": ((0.0, 0.0, 0.0), (SIZE, 0.0, 1.0), (1.0, 0.0, 1.0))},
    "enclosed_by": {"path": spline([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, SIZE, 0.0)], closed=True)},
    "bow": {"width": 0.02, "radius": 0.5},
    "capsule": {"length": 0.75},
    "clamp": {"high": 0.75},
    "output": {"kind": "light", "material": None, "color": (), "joint": None, "speed": None},
    "latest": {"signals": (signals.level(LEADER), LEADER > SIZE), "values": (0.0, SIZE)},
    "level": {"ends": (0.0, SIZE)},
    "pressed": {"ends": ()},
    "simplified_collider": {"within": 0.0005},
    "component": {"index": 2},
    "difference": {"b": BLOCK.at(0.1, 0.1, 0.1)},
    "dependency_beyond": {"position": 0.01},
    "dependency_until": {"needs": (LEADER > SIZE).beyond(0.01)},
    "dial_band": {"width": 0.01, "end_width": 0.02, "start": None},
    "dial_icons": {"names": ("fan", "", "light"), "height": 0.03},
    "dial_scale": {"ticks": 3, "width": 0.01, "major_every": 2, "numbers": ("0", "1")},
    "extrude": {"bevel": 0.01, "taper": 0.9, "twist": 0.0},
    "frame": {"closing": (1.0, 0.0, 0.0)},
    "frustum": {"bottom_radius": 0.4, "bevel": 0.0},
    "fillet": {"solid": BLOCK.at(z=0.25), "point": (0.0, 0.0, 0.0), "normal": Z, "radius": 0.05},
    "figures": {"string": "12:30"},
    "gasket_section": {"size": 0.012},
    "half_section": {
        "path": line((0.5, 0.0, 0.0), (0.4, 0.0, SIZE)),
        "wall": None,
        "inset": 0.01,
        "bore": 0.05,
        "within": 0.001,
    },
    "grasp_on": {"closing": (1.0, 0.0, 0.0), "at": None, "depth": None},
    "helix": {"turns": 2.0},
    "icon": {"name": "power"},
    "lettering": {"leading": 1.7},
    "perforation": {"pitch": 0.05, "radius": 0.01, "margin": 0.01},
    "middle": {"up": (0.0, 1.0, 0.0)},
    "reading": {"up": (0.0, 1.0, 0.0)},
    "relief": {"up": (0.0, 1.0, 0.0)},
    "vent_slots": {"slot": 0.002},
    "wrap": {"path": line((0.5, 0.0, 0.0), (0.4, 0.0, 1.0)), "height": 0.5, "proud": 0.002},
    "wire_rack": {"depth": 0.4, "pitch": 0.03, "wire": 0.0015, "frame": 0.003, "corner": 0.02},
    "bent_wires": {
        "path": line((0.0, 0.0, 0.0), (0.0, SIZE, 0.0)),
        "radius": 0.002,
        "at": row((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), 3),
    },
    "box": {"bevel": 0.01, "crown": 0.1},
    "cylinder_between": {"start": (0.0, 0.1, 0.0), "end": (SIZE, 0.4, 0.5), "radius": 0.2, "bevel": 0.01},
    "box_between": {"low": (0.0, 0.0, 0.0), "high": (SIZE, 0.4, 0.5), "bevel": 0.01},
    "cylinder": {"bevel": 0.01},
    "joint": {"rest": -0.25, "limits": None, "follows": None, "closing": None},
    "joint_above": {"joint": "leader"},
    "joint_below": {"joint": "leader"},
    "loop": {
        "body": open_chain(),
        "a": "rod",
        "b": "rocker",
        "at": (0.1, 0.0, 0.07),
        "axis": (0.0, 1.0, 0.0),
        "driver": "crank_turn",
    },
    "line": {"end": (1.0, 2.0, SIZE)},
    "loft": {"profiles": (circle(SIZE), circle(0.2)), "heights": (0.0, 1.0)},
    "offset": {"distance": 0.01},
    "polygon": {"points": ((0.0, 0.0), (SIZE, 0.0), (0.0, 1.0)), "radius": 0.0},
    "polyline": {
        "points": ((0.0, 0.0, 0.0), (SIZE, 0.0, 0.0), (1.0, 1.0, 0.0)),
        "fillet": 0.0,
        "closed": False,
    },
    "power": {"b": -2.0},
    "profile_difference": {"b": circle(0.05)},
    "rectangle": {"radius": 0.01},
    "regular_polygon": {"sides": 6},
    "repeat": {"parent": _BASE},
    "revolve": {"profile": rectangle(0.1, 0.2).at(SIZE), "sides": 8},
    "ring": {"outer": 0.4},
    "shell": {"thickness": 0.01},
    "slot": {"length": 0.5},
    "soft_closing": {"preload": 0.1},
    "split": {"point": (0.0, 0.0, 0.0)},
    "spline": {"points": ((0.0, 0.0, 0.0), (SIZE, 0.0, 1.0), (1.0, 0.0, 0.0)), "closed": False},
    "suffix": {"suffix": "_left"},
    "sweep": {"profile": circle(0.05)},
    "torus": {"minor": 0.05},
    "tube": {"outer": 0.4, "bevel": 0.0},
    "weld": {"bodies": (_BASE, part(BLOCK, "block", material("oak")))},
}
"""Inputs that an operation needs to be other than its types alone tell."""


def value_of(hint: Any) -> Any:
    """Return a value for an input of a type."""
    option = next(item for item in alternatives(hint) if item is not NoneType)
    if option in BY_TYPE:
        return BY_TYPE[option]
    if typing.get_origin(option) is typing.Literal:
        return typing.get_args(option)[0]
    if typing.get_origin(option) is tuple:
        members = typing.get_args(option)
        if members[-1] is Ellipsis:
            return (value_of(members[0]),)
        return tuple(value_of(member) for member in members)
    raise LookupError(f"no sample value of type {option!r}; enter one in BY_TYPE")


def sample(name: str) -> Handle:
    """Return a handle whose node is of that operation."""
    known = OPERATIONS[name]
    given = OVERRIDES.get(name, {})
    inputs = {key: given[key] if key in given else value_of(hint) for key, hint in known.inputs.items()}
    return Handle.HANDLES[known.result].record(name, **inputs)
