"""What tasks ask of an asset: which joints, how far, and where hands act, in all its choices."""

from collections.abc import Callable, Iterator
from typing import Literal

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.affordance import Affordance
from artgen.envs.motion import BACK, FAR_BACK, Contact, Move, Stage, contact_of, lifted
from artgen.errors import EnvError

Choice = tuple[Stage, ...]
Chooser = Callable[[Asset, np.random.Generator], Iterator[Choice]]
"""Yields what a task may ask of an asset, in random order."""

_AJAR = 0.40  # how far a dishwasher is opened by its handle [rad]
_STEEP = 1.0  # how far it is opened at least [rad]
_PAST = 0.08  # share of the way by which the scripted policy goes past a goal, within the limits


def simple(
    part: str,
    kind: Literal["grasp", "push"],
    joint_kind: Literal["revolute", "prismatic"],
    share: float = 0.0,
    *,
    at_least: float = 0.0,
    back: float = BACK,
) -> Chooser:
    """Return what moves one joint of a part by a share of its range, or by a length or an angle.

    Args:
        part: Links whose names have this in them.
        kind: How the hand moves it.
        joint_kind: Kind of the joint.
        share: Share of the joint's range up to the goal.
        at_least: The goal itself where `share` is 0 [rad or m].
        back: How far away the hand begins its approach; far where chance moves the joint easily [m].
    """

    def choose(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
        for affordance in shuffled(found(asset, part, kind, joint_kind), rng):
            yield (stage(asset, affordance, share, at_least, back=back),)

    return choose


def found(asset: Asset, part: str, kind: str, joint_kind: str) -> list[Affordance]:
    """Return the affordances of a part whose nearest joint is of a kind and free to move from the start.

    Raises:
        EnvError: The asset has none.
    """
    result = []
    for each in asset.affordances:
        if each.kind != kind or not each.joints or part not in each.link:
            continue
        joint = asset.joint(each.joints[0])
        if joint.kind == joint_kind and joint.needs is None and joint.limits is not None:
            result.append(each)
    if not result:
        way = "grasp" if kind == "grasp" else "push"
        have = ", ".join(f"{each.name} ({each.link})" for each in asset.affordances) or "none"
        raise EnvError(
            f"asset {asset.name!r} of category {asset.category!r} has no {part} that a hand can {way} "
            f"to move a {joint_kind} joint; it has these grasps and pushes: {have}. Draw it with the part, "
            "as the task's own generate(seed) does"
        )
    return result


def shuffled(items: list[Affordance], rng: np.random.Generator) -> list[Affordance]:
    """Return items in random order."""
    return [items[index] for index in rng.permutation(len(items))]


def stage(
    asset: Asset, affordance: Affordance, share: float, at_least: float = 0.0, *, back: float = BACK
) -> Stage:
    """Return the stage that moves the nearest joint of an affordance from rest upwards."""
    joint = asset.joint(affordance.joints[0])
    assert joint.limits is not None
    start, end = joint.closed, joint.limits[1]
    goal = start + share * (end - start) if share else start + min(at_least, 0.98 * (end - start))
    until = min(goal + _PAST * (goal - start) + 0.01 * (end - start), end)
    move = Move(joint.name, until, contact_of(affordance, back))
    return Stage(joint.name, start, goal, affordance, (move,))


def push_door(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
    """Yield the lever, which frees the latch, and the leaf, which is pushed with the same hold."""
    for grasp in shuffled(found(asset, "handle", "grasp", "revolute"), rng):
        lever, *others = (asset.joint(name) for name in grasp.joints)
        hinge = next((each for each in others if each.kind == "revolute" and each.needs is not None), None)
        if hinge is None or lever.limits is None or not _is_pushed(grasp, hinge.motion(0.1)):
            continue
        freed = _frees(asset, hinge.name, lever.name)
        goal = max(0.3, freed + 0.02 * (lever.limits[1] - freed))
        turn = Stage(
            lever.name,
            0.0,
            goal,
            grasp,
            (Move(lever.name, 0.5 * (goal + lever.limits[1]), contact_of(grasp, FAR_BACK)),),
        )
        push = Stage(hinge.name, 0.0, 0.3, grasp, (Move(hinge.name, 0.34, None),))
        yield (turn, push)


def _is_pushed(affordance: Affordance, motion: Array) -> bool:
    """Tell whether a motion carries an affordance along its approach, so that the hand pushes."""
    before = affordance.frame[:3, 3]
    way = motion[:3, :3] @ before + motion[:3, 3] - before
    return bool(way @ affordance.frame[:3, 2] > 0.0)


def _frees(asset: Asset, blocked: str, lever: str) -> float:
    """Return the position of a lever from which on a joint may move [rad]."""
    needs, limits = asset.joint(blocked).needs, asset.joint(lever).limits
    assert limits is not None
    if needs is None:
        return limits[0]
    low, high = limits
    if not needs.condition.holds(asset.positions({lever: high})):
        raise EnvError(f"asset {asset.name!r}: {lever} alone does not free {blocked}; it needs {needs}")
    for _ in range(40):
        middle = 0.5 * (low + high)
        if needs.condition.holds(asset.positions({lever: middle})):
            high = middle
        else:
            low = middle
    return high


def open_dishwasher(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
    """Yield the door, pulled ajar and then pressed down from within, and a rack behind it.

    Racks before which the door need not lie quite flat come first.
    """
    grasp = found(asset, "door", "grasp", "revolute")[0]
    door = asset.joint(grasp.joints[0])
    racks = [each for each in asset.affordances if each.link.startswith("rack") and each.kind == "grasp"]
    if not racks:
        raise EnvError(f"asset {asset.name!r} has no rack that a hand can take")
    freed = {each.name: _frees(asset, each.joints[0], door.name) for each in racks}
    assert door.limits is not None
    for rack in sorted(shuffled(racks, rng), key=lambda each: freed[each.name] > _STEEP):
        goal = min(max(_STEEP, freed[rack.name] + 0.1), 0.97 * door.limits[1])
        pull = stage(asset, rack, 0.5)
        for side in rng.permutation([-1.0, 1.0, 0.0]):
            ajar = Move(door.name, _AJAR, contact_of(grasp, back=0.15))
            within = _from_within(asset, grasp, door.motion(_AJAR), 0.12 * side)
            down = Move(door.name, min(goal + 0.15, door.limits[1]), within)
            yield (Stage(door.name, 0.0, goal, grasp, (ajar, down), holds=True), pull)


def _from_within(asset: Asset, grasp: Affordance, ajar: Array, beside: float) -> Contact:
    """Return where closed fingers lie on the inner side of a door's upper edge, pointing to its hinge.

    They come from above the edge of the door that is ajar, and press it down as it opens.
    """
    link = asset.link(grasp.link)
    boxes = np.array([each.convex.bounds() for each in link.colliders])
    top = float(boxes[:, 1, 2].max())
    inner = float(boxes[boxes[:, 1, 2] > top - 0.03, 1, 1].max())
    frame = np.eye(4)
    frame[:3, 0], frame[:3, 1], frame[:3, 2] = (1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)
    frame[:3, 3] = (grasp.frame[0, 3] + beside, inner + 0.012, top - 0.03)
    return Contact("push", link.name, frame, through=(lifted(ajar @ frame, -0.25),))
