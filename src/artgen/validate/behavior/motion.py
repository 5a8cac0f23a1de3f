"""Map free joints and their followers to MuJoCo's qpos indices, and positions to text."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, cached_property
from artgen.asset import Asset, AssetJoint
from artgen.export.frames import coupling

_TRAVEL = 1.0  # examined length of a slide without limits [m]


@dataclass(frozen=True, eq=False)
class JointMotion:
    """A free joint with its followers."""

    joint: AssetJoint  # the free joint
    members: tuple[AssetJoint, ...]  # the joint itself and those that follow it
    ratios: Array  # motion of each member per motion of the joint, shape (n,)
    offsets: Array  # position of each member while the joint is at 0, shape (n,)
    positions: NDArray[np.int64]  # indices of the members in MuJoCo's positions, shape (n,)
    speeds: NDArray[np.int64]  # indices of the members in MuJoCo's velocities and forces, shape (n,)
    bodies: frozenset[int]  # MuJoCo's bodies that move with the joint

    @property
    def name(self) -> str:
        """Name of the free joint."""
        return self.joint.name

    @cached_property
    def at(self) -> int:
        """Index of the free joint in MuJoCo's positions."""
        return int(self.positions[0])

    @cached_property
    def dof(self) -> int:
        """Index of the free joint in MuJoCo's velocities and forces."""
        return int(self.speeds[0])

    @property
    def limits(self) -> tuple[float, float]:
        """The examined range: without limits, a full turn or one metre [rad or m]."""
        if self.joint.limits is not None:
            return self.joint.limits
        return (0.0, 2.0 * math.pi if self.joint.kind == "revolute" else _TRAVEL)

    @cached_property
    def range(self) -> float:
        """Length of the examined range [rad or m]."""
        low, high = self.limits
        return high - low

    @cached_property
    def friction(self) -> float:
        """Dry friction of all members, felt at the joint [N m or N]."""
        frictions = [member.friction for member in self.members]
        return float(np.abs(self.ratios) @ np.array(frictions))

    @cached_property
    def stiffness(self) -> float:
        """Stiffness of all springs, felt at the joint [N m/rad or N/m]."""
        return float(self.ratios**2 @ np.array([member.stiffness for member in self.members]))

    @cached_property
    def damping(self) -> float:
        """Damping of all members, felt at the joint [N m s/rad or N s/m]."""
        return float(self.ratios**2 @ np.array([member.damping for member in self.members]))

    @cached_property
    def rest(self) -> float:
        """Rest position of the springs; valid only if there are springs [rad or m]."""
        pulls = [member.stiffness * member.rest for member in self.members]
        stiffness = np.array([member.stiffness for member in self.members])
        return float(self.ratios @ (np.array(pulls) - stiffness * self.offsets)) / self.stiffness


def motions_of(asset: Asset, model: Any) -> dict[str, JointMotion]:
    """Return the free joints of an asset by name, with their indices in MuJoCo's model."""
    for link in asset.links:
        model.body(link.name)
    return {joint.name: _motion(asset, model, joint) for joint in asset.free_joints}


def _motion(asset: Asset, model: Any, joint: AssetJoint) -> JointMotion:
    members, ratios, offsets = [joint], [1.0], [0.0]
    for other in asset.joints:
        law = coupling(asset, other)
        if law is not None and law.leader == joint.name:
            members.append(other)
            ratios.append(law.ratio)
            offsets.append(law.offset)
    found = [model.joint(member.name) for member in members]
    return JointMotion(
        joint,
        tuple(members),
        np.array(ratios),
        np.array(offsets),
        np.array([each.qposadr[0] for each in found]),
        np.array([each.dofadr[0] for each in found]),
        frozenset(body for member in members for body in _subtree(model, member.child)),
    )


def _subtree(model: Any, link: str) -> set[int]:
    found = {int(model.body(link).id)}
    for body in range(model.nbody):
        if int(model.body_parentid[body]) in found:
            found.add(body)
    return found


def length(joint: AssetJoint, distance: float) -> str:
    """Format a distance along a joint in degrees or millimetres."""
    if joint.kind == "revolute":
        return f"{math.degrees(distance):.3g} degrees"
    return f"{1e3 * distance:.3g} mm"


def place(joint: AssetJoint, position: float) -> str:
    """Format a position of a joint in radians or metres."""
    return f"{position + 0.0:.4g} {'rad' if joint.kind == 'revolute' else 'm'}"


def force(joint: AssetJoint, amount: float) -> str:
    """Format a torque or a force at a joint."""
    return f"{amount + 0.0:.3g} {'N m' if joint.kind == 'revolute' else 'N'}"


def unit(joint: AssetJoint) -> str:
    """Return the unit of a joint's positions."""
    return "rad" if joint.kind == "revolute" else "m"
