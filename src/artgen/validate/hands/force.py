"""Force with which a hand moves each joint from end to end, computed without a simulator.

A slow hand works against dry friction, springs and weight. Damping and inertia depend on its speed and are
left out.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.asset.affordance import GRIPPER, Affordance
from artgen.export.frames import coupling
from artgen.validate.hands.states import standing

MOST_FORCE = 60.0
"""Largest force of a hand, a finger or a foot [N].

Two rubber pads (friction 0.5) that a Franka hand closes with 70 N slip at about this force.
"""

_GRAVITY = 9.81  # gravity [m/s^2]
_STEPS = 16  # number of parts of a range at whose ends the force is computed
_STEP = 1e-5  # step by which a joint is moved to measure lever arms [rad or m]
_SHORTEST = 1e-4  # least lever arm of an effective hand [m/rad or m/m]
# examined range of a joint without limits, in each direction [rad or m]
_LOOKED_AT = {"revolute": math.pi, "prismatic": 0.5}


def hand_forces(asset: Asset) -> dict[str, float]:
    """Return the force with which a hand starts each joint and moves it from end to end [N].

    The grasp or push with the smallest force counts, separately for each direction. A direction in which no
    hand can move the joint, such as the return of a button, is left to its spring. At each position, the hand
    needs the force of friction, springs and weight divided by its lever arm.

    Args:
        asset: The asset, in memory or loaded.

    Returns:
        The force by name, for free joints that a grasp or push moves and no motor drives.
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
    """A joint at one position of its range."""

    load: float  # load of springs and weight towards larger positions [N m or N]
    friction: float  # dry friction of the joint and its followers [N m or N]
    # displacements of links one step before and behind the position
    poses: tuple[Mapping[str, Array], Mapping[str, Array]]
    apart: float  # motion of the joint between these poses [rad or m]


def _places(asset: Asset, joint: AssetJoint) -> list[_Place]:
    """Return positions along the range of a joint; other joints stand where it may move."""
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
    """Return a free joint and its followers, with ratio and offset of each."""
    found = [(joint, 1.0, 0.0)]
    for each in asset.joints:
        law = coupling(asset, each)
        if law is not None and law.leader == joint.name:
            found.append((each, law.ratio, law.offset))
    return found


def _potential(asset: Asset, pose: Mapping[str, Array]) -> float:
    """Return the potential energy of the links [J]."""
    heights = (
        (
            link.mass_properties.mass,
            pose[link.name][2, :3] @ link.mass_properties.center + pose[link.name][2, 3],
        )
        for link in asset.links
    )
    return _GRAVITY * float(sum(mass * height for mass, height in heights))


def _force(hand: Affordance, places: Sequence[_Place], way: float) -> float:
    """Return the largest force that a hand needs; infinite if it cannot move the joint that way [N]."""
    return max(_force_at(hand, place, way) for place in places)


def _force_at(hand: Affordance, place: _Place, way: float) -> float:
    before, behind = (pose[hand.link] @ hand.frame for pose in place.poses)
    arm = _arm(hand, before, behind, way) / place.apart
    if arm < _SHORTEST:
        return math.inf
    return max(place.friction - way * place.load, 0.0) / arm


def _arm(hand: Affordance, before: Array, behind: Array, way: float) -> float:
    """Return the motion of a hand along its force between two poses of its frame [m].

    A finger pushes along its frame. A gripper pulls along the motion of its link, or turns it by opposite
    forces of its pads.
    """
    moved = behind[:3, 3] - before[:3, 3]
    if hand.kind == "push":
        return way * float(moved @ before[:3, 2])
    held = max(hand.width - 2.0 * GRIPPER.clearance, 0.0)
    turned = behind[:3, 0] - before[:3, 0]  # cosine to the direction between the pads
    return max(float(np.linalg.norm(moved)), float(np.linalg.norm(turned)) * held)
