"""With which force a hand moves each joint from end to end, computed from the asset without a simulator.

A hand that moves a joint slowly works against dry friction, springs and weight. Damping and inertia, which
depend on its haste, are left out.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.asset.affordance import Affordance
from artgen.asset.gripper import GRIPPER
from artgen.export.frames import coupling
from artgen.validate.hands.states import standing

MOST_FORCE = 60.0
"""What a hand, a finger or a foot is asked for at most [N].

Two pads of rubber (friction 0.5) that a Franka hand closes with 70 N slip at about as much.
"""

_GRAVITY = 9.81  # [m/s^2]
_STEPS = 16  # parts of a range at whose ends the force is computed
_STEP = 1e-5  # by which a joint is moved to see where things go [rad or m]
_SHORTEST = 1e-4  # lever arm with which a hand cannot move anything [m/rad or m/m]
_LOOKED_AT = {"revolute": math.pi, "prismatic": 0.5}  # either way of a joint without limits [rad or m]


def hand_forces(asset: Asset) -> dict[str, float]:
    """Return the force with which a hand starts each joint and moves it from end to end [N].

    Of all grasps and pushes that move a joint, the one that asks for least counts, for each way by itself;
    a way in which none can move the joint, such as that back of a button, is left to its spring. At each
    place the hand needs what friction, springs and weight ask for, divided by its lever arm there.

    Args:
        asset: The asset, in memory or read back.

    Returns:
        The force by name, for the free joints that some grasp or push moves and that nothing else drives.
    """
    result = {}
    for joint in asset.free_joints:
        hands = [each for each in asset.affordances if joint.name in each.joints]
        if joint.driven or not hands:
            continue
        places = _places(asset, joint)
        forces = [min(_force(hand, places, way) for hand in hands) for way in (1.0, -1.0)]
        reached = [force for force in forces if math.isfinite(force)]
        if reached:
            result[joint.name] = max(reached)
    return result


@dataclass(frozen=True)
class _Place:
    """A joint at one place of its range."""

    load: float  # with what springs and weight push it on, towards larger positions [N m or N]
    friction: float  # dry friction of the joint and of those that follow it [N m or N]
    # how links are displaced a step before and a step behind that place
    poses: tuple[Mapping[str, Array], Mapping[str, Array]]
    apart: float  # the way of the joint between these poses [rad or m]


def _places(asset: Asset, joint: AssetJoint) -> list[_Place]:
    """Return places along the range of a joint; the others stand where it may move."""
    held = standing(asset, joint.name, {}) or {}
    most = _LOOKED_AT[joint.kind]
    low, high = joint.limits or (-most, most)
    followers = list(_followers(asset, joint))
    friction = sum(abs(ratio) * each.friction for each, ratio, _ in followers)
    step = min(_STEP, 0.25 * (high - low))
    places = []
    for at in np.linspace(low + step, high - step, _STEPS + 1).tolist():
        before, behind = (asset.pose({**held, joint.name: at + side * step}) for side in (-1.0, 1.0))
        rise = (_potential(asset, behind) - _potential(asset, before)) / (2.0 * step)
        springs = sum(
            ratio * each.stiffness * (each.rest - ratio * at - offset) for each, ratio, offset in followers
        )
        places.append(_Place(springs - rise, friction, (before, behind), 2.0 * step))
    return places


def _followers(asset: Asset, joint: AssetJoint) -> Sequence[tuple[AssetJoint, float, float]]:
    """Return a free joint and those that follow it, with the ratio and the offset of each."""
    found = [(joint, 1.0, 0.0)]
    for each in asset.joints:
        law = coupling(asset, each)
        if law is not None and law.leader == joint.name:
            found.append((each, law.ratio, law.offset))
    return found


def _potential(asset: Asset, pose: Mapping[str, Array]) -> float:
    """Return the energy of the links' weight [J]."""
    heights = (
        (
            link.mass_properties.mass,
            pose[link.name][2, :3] @ link.mass_properties.center + pose[link.name][2, 3],
        )
        for link in asset.links
    )
    return _GRAVITY * float(sum(mass * height for mass, height in heights))


def _force(hand: Affordance, places: Sequence[_Place], way: float) -> float:
    """Return the force that a hand needs at most; infinite where it cannot move the joint that way [N]."""
    return max(_force_at(hand, place, way) for place in places)


def _force_at(hand: Affordance, place: _Place, way: float) -> float:
    before, behind = (pose[hand.link] @ hand.frame for pose in place.poses)
    arm = _arm(hand, before, behind, way) / place.apart
    if arm < _SHORTEST:
        return math.inf
    return max(place.friction - way * place.load, 0.0) / arm


def _arm(hand: Affordance, before: Array, behind: Array, way: float) -> float:
    """Return how far a hand moves along its force as its frame goes from one pose to the next [m].

    A finger pushes along its frame. A gripper pulls where its link goes, or turns it by a force of each pad.
    """
    moved = behind[:3, 3] - before[:3, 3]
    if hand.kind == "push":
        return way * float(moved @ before[:3, 2])
    held = max(hand.width - 2.0 * GRIPPER.clearance, 0.0)
    turned = behind[:3, 0] - before[:3, 0]  # of the direction from pad to pad
    return max(float(np.linalg.norm(moved)), float(np.linalg.norm(turned)) * held)
