"""Joints of a body, read from its graph before any geometry is made."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from artgen.asset import Tree
from artgen.graph import Graph
from artgen.graph.kernel import OPERATIONS
from artgen.graph.node import Node, nodes_in


@dataclass(frozen=True)
class PlannedJoint:
    """A joint in the author's code."""

    name: str  # name with the suffixes of copies
    kind: str  # `revolute` or `prismatic`
    unlimited: bool  # whether it has neither limits nor a leader
    follows: str  # name of its leader; empty without a coupling
    needs: bool  # whether it depends on other joints


def joints_of(graph: Graph) -> tuple[PlannedJoint, ...]:
    """Return the joints of the body of a graph, those nearest to its base first.

    All bodies of a `switch` count; a `repeat` whose points are not listed in the graph counts as one copy.
    """
    found: dict[str, tuple[PlannedJoint, ...]] = {}  # by key: equal nodes may occur more than once
    for node in graph.nodes:  # inputs come before their users
        if _makes_body(node.op):
            found[node.key] = _joints(node, found)
    return found[graph.result.node.key]


@cache
def _makes_body(op: str) -> bool:
    return op in OPERATIONS and OPERATIONS[op].result is Tree


def _joints(node: Node, found: Mapping[str, tuple[PlannedJoint, ...]]) -> tuple[PlannedJoint, ...]:
    below = {
        joint.name: joint
        for name, value in node.inputs.items()
        if name != "child"
        for body in nodes_in(value)
        for joint in found.get(body.key, ())
    }
    if "child" in node.inputs:
        branch = (*(_planned(joint) for joint in node.inputs["joints"]), *found[node.inputs["child"].key])
        if node.op == "repeat":
            suffixes = [f"_{index}" for index in range(_count(node.inputs["at"]))]
        else:
            suffixes = list(node.inputs.get("suffixes", ("",)))
        copies = [_suffixed(branch, suffix) for suffix in suffixes]
        below.update({joint.name: joint for copy in copies for joint in copy})
    joints = tuple(below.values())
    if node.op == "suffix":
        return _suffixed(joints, node.inputs["suffix"])
    if node.op == "loop":
        return tuple(_led(joint, node.inputs["driver"]) for joint in joints)
    return joints


def _planned(joint: Node) -> PlannedJoint:
    given = joint.inputs
    follows = _leader(given["follows"])
    return PlannedJoint(
        name=given["name"],
        kind=given["kind"],
        unlimited=given["limits"] is None and not follows,
        follows=follows,
        needs=given["needs"] is not None,
    )


def _led(joint: PlannedJoint, driver: str) -> PlannedJoint:
    """Return a joint of a body that a pin closes: all but the input follow it if they have no limits."""
    free = joint.unlimited and joint.name != driver
    return replace(joint, unlimited=False, follows=driver) if free else joint


def _leader(coupling: Node | None) -> str:
    while coupling is not None and "leader" not in coupling.inputs:
        coupling = coupling.inputs["coupling"]
    return "" if coupling is None else str(coupling.inputs["leader"])


def _suffixed(joints: tuple[PlannedJoint, ...], suffix: str) -> tuple[PlannedJoint, ...]:
    """Rename joints and their leaders."""
    names = {joint.name: joint.name + suffix for joint in joints}
    return tuple(
        replace(joint, name=names[joint.name], follows=names.get(joint.follows, joint.follows))
        for joint in joints
    )


def _count(at: Any) -> int:
    """Return the number of points, or 1 if the graph does not list them."""
    if not isinstance(at, Node):
        return len(at)
    match at.op:
        case "points":
            return len(at.inputs["vectors"])
        case "row" | "along" | "ring_points":
            return int(at.inputs["count"])
        case "grid":
            return int(at.inputs["columns"]) * int(at.inputs["rows"])
        case "points_move" | "points_scale":
            return _count(at.inputs["points"])
        case _:
            return 1
