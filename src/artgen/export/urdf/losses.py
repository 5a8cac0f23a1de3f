"""Features that URDF cannot express, and elements shared by all layouts."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from artgen.asset import Asset, AssetJoint
from artgen.colliders import Convex
from artgen.export.frames import FAR, INTERMEDIATE_MASS, translation
from artgen.export.losses import Loss, contact_losses, dependency_losses, joints_where, loss


def primitives(convex: Convex) -> list[tuple[str, Convex]]:
    """Return the primitives of a piece that is not a hull, each with a suffix for its name.

    URDF has no capsule: a cylinder between two balls is the same solid.
    """
    if convex.kind != "capsule":
        return [("", convex)]
    radius, length = convex.size
    ends = [convex.pose @ translation(np.array([0.0, 0.0, end])) for end in (-length / 2.0, length / 2.0)]
    balls = [(f"_end_{number}", Convex("sphere", end, (radius,))) for number, end in enumerate(ends)]
    return [("", Convex("cylinder", convex.pose, convex.size)), *balls]


def add_spring(robot: Any, name: str, joint: AssetJoint, rest: float) -> None:
    """Add Gazebo's element for the spring of a joint, which other simulators ignore.

    Args:
        robot: Root of the tree.
        name: Name of the joint in the tree.
        joint: The joint.
        rest: Rest position of the spring, with the sign of the joint in the tree [rad or m].
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
    """Format a number with the digits of `asset.json`."""
    return f"{value + 0.0:.12g}"


def motion_losses(asset: Asset, inserted: Iterable[str]) -> tuple[Loss, ...]:
    """Return the losses of the motion of joints.

    Args:
        asset: The asset.
        inserted: Names of the links inserted between two joints of one pair of links.
    """
    moving = {joint.name for joint in asset.joints if not joint.locked}
    return (
        *loss(
            "joint spring",
            joints_where(asset, lambda joint: joint.name in moving and joint.stiffness > 0.0),
            "Gazebo's springStiffness and springReference; other clients have no spring",
        ),
        *loss(
            "joint armature",
            joints_where(asset, lambda joint: joint.name in moving and joint.armature > 0.0),
            "nothing",
        ),
        *loss(
            "unlimited slide",
            joints_where(
                asset,
                lambda joint: joint.name in moving and joint.kind == "prismatic" and joint.limits is None,
            ),
            f"limits of -{FAR:g} m and {FAR:g} m",
        ),
        *dependency_losses(asset),
        *contact_losses(asset),
        *loss(
            "several joints between two links",
            inserted,
            f"a link of {INTERMEDIATE_MASS:g} kg after each joint but the last",
        ),
    )


def material_losses(asset: Asset) -> tuple[Loss, ...]:
    """Return the losses of the materials of links."""
    return (
        *loss(
            "contact friction",
            [link.name for link in asset.links if link.colliders],
            "nothing: clients take their own default; the coefficients are in asset.json",
        ),
        *loss(
            "surface roughness, metalness and coat",
            [material.name for material in asset.materials],
            "Pr, Pm, Pc and norm in the MTL file, which few clients read",
        ),
    )
