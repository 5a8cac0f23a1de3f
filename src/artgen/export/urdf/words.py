"""What the URDFs of all layouts say alike."""

from typing import Any

import numpy as np

from artgen.asset import Joint
from artgen.colliders import Convex
from artgen.export.frames import translation


def primitives(convex: Convex) -> list[tuple[str, Convex]]:
    """Return the primitives of a piece that is no hull, each with a suffix for its name.

    URDF has no capsule: a cylinder between two balls is the same solid.
    """
    if convex.kind != "capsule":
        return [("", convex)]
    radius, length = convex.size
    ends = [convex.pose @ translation(np.array([0.0, 0.0, end])) for end in (-length / 2.0, length / 2.0)]
    balls = [(f"_end_{number}", Convex("sphere", end, (radius,))) for number, end in enumerate(ends)]
    return [("", Convex("cylinder", convex.pose, convex.size)), *balls]


def add_spring(robot: Any, name: str, joint: Joint, rest: float) -> None:
    """Add Gazebo's word for a spring, which other clients pass over, where a joint has one.

    Args:
        robot: The root of the tree.
        name: What the joint is called in it.
        joint: The joint.
        rest: Where the spring is at ease, with the sign of the joint there [rad or m].
    """
    if not joint.stiffness or joint.locked:
        return
    spring = add(robot, "gazebo", reference=name)
    add(spring, "springStiffness").text = digits(joint.stiffness)
    add(spring, "springReference").text = digits(rest)


def add(parent: Any, tag: str, **attributes: str) -> Any:
    """Add an element to a tree of `lxml` or of the standard library."""
    element = parent.makeelement(tag, attributes)
    parent.append(element)
    return element


def digits(value: float) -> str:
    """Write a number with as many digits as `asset.json`."""
    return f"{value + 0.0:.12g}"
