"""Stages of the manipulation tasks: which joints of an asset a hand moves, by which contacts, and how far."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypeVar

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.asset.affordance import Affordance, head
from artgen.asset.signals import AssetOutput
from artgen.envs.motion import BACK, FAR_BACK, ON, Contact, Move, Stage, contact_of, lifted
from artgen.errors import EnvError, ParameterError, nearest
from artgen.sampling.distributions import is_number

T = TypeVar("T")
Choice = tuple[Stage, ...]  # possible stages of a task on an asset
Chooser = Callable[[Asset, np.random.Generator], Iterator[Choice]]  # all choices, in random order

AJAR = 0.40  # opening of a dishwasher by its handle [rad]
_STEEP = 1.0  # least total opening of a dishwasher [rad]
_SHUT = 0.02  # opening of a door that counts as shut [rad]
_LOOKED, _PAUSE = 41, 0.5  # positions of a control at which outputs are looked at, and time between two [s]
_PAST = 0.08  # distance of the scripted policy beyond a goal, relative to the distance to the goal


def one_joint(
    part: str,
    kind: Literal["grasp", "push"],
    joint_kind: Literal["revolute", "prismatic"],
    share: float = 0.0,
    *,
    at_least: float = 0.0,
    back: float = BACK,
) -> Chooser:
    """Return the `choose` of a task that moves one joint of a part from rest, by a grasp or a push on it.

    Args:
        part: Text in the names of the links that have the grasp or push; empty for all links.
        kind: `grasp` or `push`.
        joint_kind: Kind of the joint nearest to the part. It has limits and no dependency.
        share: Goal as a share of the range of the joint.
        at_least: Goal if `share` is 0, at most 0.98 of the range [rad or m].
        back: Distance at which the hand begins its approach; large for parts that random motion would move
            [m].

    Raises:
        ParameterError: An argument is impossible, or there is no goal, or two.
    """
    _check_option("kind", kind, ("grasp", "push"))
    _check_option("joint_kind", joint_kind, ("revolute", "prismatic"))
    for name, value, most in (("share", share, 1.0), ("at_least", at_least, np.inf)):
        if value:
            check_positive(name, value, most)
    check_positive("back", back)
    if bool(share) == bool(at_least):
        raise ParameterError(
            "one_joint needs one goal: share=0.5 of the range of the joint, or at_least=0.3 rad or m; got "
            f"share = {share!r} and at_least = {at_least!r}"
        )

    def choose(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
        for affordance in _shuffled(found(asset, part, kind, joint_kind), rng):
            yield (stage(asset, affordance, share, at_least, back=back),)

    return choose


def check_positive(name: str, value: Any, most: float = np.inf) -> None:
    """Check that a number is positive, and at most another one."""
    if not is_number(value) or not 0.0 < value <= most:
        limit = f" of at most {most:g}" if most < np.inf else ""
        raise ParameterError(f"{name} = {value!r} is not allowed: it must be a positive number{limit}")


def _check_option(name: str, value: Any, options: Sequence[str]) -> None:
    if value not in options:
        raise ParameterError(f"{name} = {value!r} is not allowed.{nearest(value, options)}")


def found(asset: Asset, part: str, kind: str, joint_kind: str, *, free: bool = True) -> list[Affordance]:
    """Return the affordances, at least one, of a part whose nearest joint has a kind and limits.

    The joint has no dependency, unless `free` is False.
    """
    result = []
    for each in asset.affordances:
        if each.kind != kind or not each.joints or part not in asset.originals.get(each.link, each.link):
            continue
        joint = asset.joint(each.joints[0])
        if joint.kind == joint_kind and not (free and _needed(joint)) and joint.limits is not None:
            result.append(each)
    if not result:
        have = ", ".join(f"{each.name} ({each.link})" for each in asset.affordances) or "none"
        raise EnvError(
            f"asset {asset.name!r} of category {asset.category!r} has no {part or 'part'} that a hand can "
            f"{kind} to move a {joint_kind} joint; it has these grasps and pushes: {have}. Draw it with the "
            "part, as the task's own generate(seed) does"
        )
    return result


def _shuffled(items: list[T], rng: np.random.Generator) -> list[T]:
    return [items[index] for index in rng.permutation(len(items))]


def stage(
    asset: Asset,
    affordance: Affordance,
    share: float,  # goal as a share of the range of the joint
    at_least: float = 0.0,  # goal if `share` is 0 [rad or m]
    *,
    back: float = BACK,  # start of the approach; far for joints that random motion moves easily [m]
) -> Stage:
    """Return the stage that moves the nearest joint of an affordance from rest towards larger positions."""
    joint = asset.joint(affordance.joints[0])
    assert joint.limits is not None
    start, end = joint.closed, joint.limits[1]
    goal = start + share * (end - start) if share else start + min(at_least, 0.98 * (end - start))
    return _towards(asset, affordance, goal, end, back)


def _towards(
    asset: Asset, affordance: Affordance, goal: float, end: float, back: float, output: str | None = None
) -> Stage:
    """Return the stage that moves the nearest joint of an affordance from rest towards one of its limits."""
    joint = asset.joint(affordance.joints[0])
    start = joint.closed
    past = goal + _PAST * (goal - start) + 0.01 * (end - start)
    move = Move(joint.name, min(past, end) if end > start else max(past, end), contact_of(affordance, back))
    return Stage(joint.name, start, goal, affordance, (move,), output=output)


def by_lever(part: str, goal: float, until: float, *, pushes: bool = False) -> Chooser:
    """Return the `choose` of a task that turns a lever and moves the joint that it frees, with one grasp.

    If the lever itself needs another joint, such as the key of a safe, that one is turned first.

    Args:
        part: Text in the name of the link of the lever.
        goal: Goal of the freed joint [rad or m].
        until: Position at which the scripted policy releases it [rad or m].
        pushes: Whether grasps are left out with which the hand would pull.

    Raises:
        ParameterError: A number is impossible.
    """
    check_positive("until", until)
    check_positive("goal", goal, until)

    def choose(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
        for grasp in _shuffled(found(asset, part, "grasp", "revolute", free=False), rng):
            lever, *others = (asset.joint(name) for name in grasp.joints)
            moved = next((each for each in others if lever.name in _needed(each)), None)
            keys = [each for each in asset.affordances if set(each.joints[:1]) & _needed(lever)]
            if moved is None or (_needed(lever) and not keys):
                continue
            if pushes and _forward(moved, grasp, 0.0, 0.1) <= 0.0:
                continue  # the hand would pull
            first = [_turn(asset, key, lever.name) for key in keys[:1]]
            highest = np.inf if moved.limits is None else moved.limits[1]
            move = Move(moved.name, min(until, highest), None)
            last = Stage(moved.name, 0.0, min(goal, 0.98 * highest), grasp, (move,))
            yield *first, _turn(asset, grasp, moved.name), last

    return choose


def by_output(part: str = "") -> Chooser:
    """Return the `choose` of a task that switches an output on: a light, a burner, a motor.

    A hand moves one control, or two in order where one is not enough, such as a main switch and a key. An
    output is on from three tenths, and the task is done as soon as it is on.

    Args:
        part: Text in the names of the outputs; empty for all outputs.
    """

    def choose(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
        outputs = [each for each in asset.outputs if part in each.name]
        if not outputs:
            have = ", ".join(each.name for each in asset.outputs) or "none"
            raise EnvError(
                f"asset {asset.name!r} of category {asset.category!r} has no output {part!r}; it has these: "
                f"{have}. Draw it with one, as the task's own generate(seed) does"
            )
        for output in _shuffled(outputs, rng):
            yield from _switched_on(asset, output, rng)

    return choose


def _switched_on(asset: Asset, output: AssetOutput, rng: np.random.Generator) -> Iterator[Choice]:
    """Yield the stages of one control that switches an output on; of two in order, if none does alone."""
    read = {head(asset.joint(name), asset).name for name in output.signal.joints()}
    hands = _shuffled([each for each in asset.affordances if each.joints and each.joints[0] in read], rng)
    rest = np.array([asset.joint(name).closed for name in asset.dof_names])
    alone = [
        (each, end, goal)
        for each, end in _controls(asset, hands, rest)
        if (goal := _goal(asset, output.name, [rest], each, end)) is not None
    ]
    for each, end, goal in alone:
        yield (_towards(asset, each, goal, end, FAR_BACK, output.name),)
    if alone:
        return
    for first, pushed in _controls(asset, hands, rest):
        joint = asset.joint(first.joints[0])
        used = rest.copy()
        used[asset.dof_names.index(joint.name)] = pushed
        left = rest if joint.stiffness > 0.0 and joint.detents is None else used
        for each, end in _controls(asset, hands, left):
            goal = _goal(asset, output.name, [rest, used, left], each, end)
            if goal is not None and each.joints[0] != joint.name:
                before = _towards(
                    asset, first, joint.closed + 0.9 * (pushed - joint.closed), pushed, FAR_BACK
                )
                yield before, _towards(asset, each, goal, end, FAR_BACK, output.name)


def _controls(asset: Asset, hands: Sequence[Affordance], q: Array) -> Iterator[tuple[Affordance, float]]:
    """Yield the affordances that a hand reaches in a state and whose joint is free there, with its end."""
    positions = asset.positions(dict(zip(asset.dof_names, q.tolist(), strict=True)))
    for each in hands:
        joint = asset.joint(each.joints[0])
        if not _moves(joint, positions) or not (each.when is None or each.when.holds(positions)):
            continue
        for end in joint.limits or ():
            little = joint.closed + 0.01 * (end - joint.closed)
            forward = each.kind == "grasp" or _forward(joint, each, joint.closed, little) > 0.0
            if end != joint.closed and forward:
                yield each, end


def _goal(asset: Asset, output: str, before: Sequence[Array], hand: Affordance, end: float) -> float | None:
    """Return the position at which a joint switches an output on after some states, or None."""
    joint = asset.joint(hand.joints[0])
    way = np.linspace(joint.closed, end, _LOOKED)
    rows = np.tile(before[-1], (len(way), 1))
    rows[:, asset.dof_names.index(joint.name)] = way
    controller = asset.controller(len(way))
    for state in before:
        controller.step(state, _PAUSE)
    on = controller.step(rows, _PAUSE)[output] >= ON
    if on[0] or not on.any():
        return None
    first = int(np.argmax(on))
    return float(way[first + 1] if first < len(way) - 2 else way[first])


def _forward(joint: AssetJoint, affordance: Affordance, start: float, end: float) -> float:
    """Return the way along which a hand follows its own approach while a joint moves [m]."""
    moved = (joint.motion(end) - joint.motion(start)) @ affordance.frame[:, 3]
    return float(moved[:3] @ affordance.frame[:3, 2])


def _moves(joint: AssetJoint, positions: Mapping[str, float]) -> bool:
    """Tell whether a joint with limits is free to move from closed, given the positions of all joints."""
    return joint.limits is not None and (joint.needs is None or joint.needs.condition.holds(positions))


def _needed(joint: AssetJoint) -> set[str]:
    """Return the names of the joints that a joint needs."""
    return set() if joint.needs is None else set(joint.needs.condition.joints())


def _turn(asset: Asset, grasp: Affordance, freed: str) -> Stage:
    """Return the stage that turns the nearest joint of a grasp until it frees another joint."""
    joint = asset.joint(grasp.joints[0])
    assert joint.limits is not None
    free = frees(asset, freed, joint.name)
    goal = max(0.3, free + 0.02 * (joint.limits[1] - free))
    turn = Move(joint.name, 0.5 * (goal + joint.limits[1]), contact_of(grasp, FAR_BACK))
    return Stage(joint.name, 0.0, goal, grasp, (turn,))


def frees(asset: Asset, blocked: str, lever: str) -> float:
    """Return the least position of a lever at which a joint is free [rad]."""
    needs, limits = asset.joint(blocked).needs, asset.joint(lever).limits
    assert limits is not None
    low, high = limits
    if needs is None:
        return low
    if not needs.condition.holds(asset.positions({lever: high})):
        raise EnvError(f"asset {asset.name!r}: {lever} alone does not free {blocked}; it needs {needs}")
    for _ in range(40):
        middle = 0.5 * (low + high)
        free = needs.condition.holds(asset.positions({lever: middle}))
        low, high = (low, middle) if free else (middle, high)
    return high


def open_dishwasher(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
    """Yield the door, pulled ajar and then pressed down from inside, and a rack behind it.

    Racks that need a smaller opening of the door come first.
    """
    grasp = found(asset, "door", "grasp", "revolute")[0]
    door = asset.joint(grasp.joints[0])
    racks = [each for each in asset.affordances if each.link.startswith("rack") and each.kind == "grasp"]
    if not racks:
        raise EnvError(f"asset {asset.name!r} has no rack that a hand can grasp; take one with a rack")
    freed = {each.name: frees(asset, each.joints[0], door.name) for each in racks}
    assert door.limits is not None
    for rack in sorted(_shuffled(racks, rng), key=lambda each: freed[each.name] > _STEEP):
        goal = min(max(_STEEP, freed[rack.name] + 0.1), 0.97 * door.limits[1])
        pull = stage(asset, rack, 0.5)
        for side in rng.permutation([-1.0, 1.0, 0.0]):
            ajar = Move(door.name, AJAR, contact_of(grasp, back=0.15))
            within = _from_within(asset, grasp, door.motion(AJAR), 0.12 * side)
            down = Move(door.name, min(goal + 0.15, door.limits[1]), within)
            yield Stage(door.name, 0.0, goal, grasp, (ajar, down), holds=True), pull


def _from_within(asset: Asset, grasp: Affordance, ajar: Array, beside: float) -> Contact:
    """Return the contact of closed fingers with the inside of the upper edge of a door that is ajar.

    They point to the hinge, come from above the edge, and press the door down.
    """
    link = asset.link(grasp.link)
    boxes = np.array([each.convex.bounds() for each in link.colliders])
    top = float(boxes[:, 1, 2].max())
    inner = float(boxes[boxes[:, 1, 2] > top - 0.03, 1, 1].max())
    frame = np.diag([1.0, -1.0, -1.0, 1.0])
    frame[:3, 3] = (grasp.frame[0, 3] + beside, inner + 0.012, top - 0.03)
    return Contact("push", link.name, frame, through=(lifted(ajar @ frame, -0.25),))


def third_drawer(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
    """Yield the pull of the third drawer from above of each base unit with drawers."""
    names = [f"{each.name}_drawer_2" for each in asset.placed if each.category == "drawer"]
    for grasp in _shuffled(_free_grasps(asset, names, "third drawer"), rng):
        yield (stage(asset, grasp, 0.5),)


def open_and_close(asset: Asset, rng: np.random.Generator) -> Iterator[Choice]:
    """Yield the pull of a door of a refrigerator, and the push with the same grasp until it is shut."""
    names = [link.name for link in asset.links if re.fullmatch(r"refrigerator_\w*door\w*", link.name)]
    for grasp in _shuffled(_free_grasps(asset, names, "door of a refrigerator"), rng):
        opening = stage(asset, grasp, 0.0, AJAR)
        joint, shut = asset.joint(opening.joint), opening.start + _SHUT
        closing = Move(joint.name, joint.closed, None)
        yield opening, Stage(joint.name, opening.goal, shut, grasp, (closing,), holds=True)


def _free_grasps(asset: Asset, links: Sequence[str], what: str) -> list[Affordance]:
    """Return the grasps on links whose nearest joint moves while all others are closed; at least one."""
    rest = asset.positions()
    result = []
    for each in asset.affordances:
        grasped = each.kind == "grasp" and each.link in links and each.joints
        if grasped and _moves(asset.joint(each.joints[0]), rest):
            result.append(each)
    if not result:
        raise EnvError(f"asset {asset.name!r} has no {what} that a hand can grasp; take another seed")
    return result
