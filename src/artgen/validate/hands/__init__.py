"""Check of grasps and pushes: a hand can approach, grasp, and move the joints."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetCondition
from artgen.asset.affordance import GRIPPER, Affordance
from artgen.asset.report import CheckResult, Finding
from artgen.validate.colliders import FACETS
from artgen.validate.hands.motion import (
    MOST_FORCE,
    HandSpace,
    Opened,
    hand_forces,
    openable,
    positions_to_move,
    reach_of,
    tendency,
)

CHECK = "grasps"

Faults = tuple[list[Finding], str]
"""Obstacles of a hand, and the link that it strikes; empty if that is its own link."""

COMES_FROM = 0.100
"""Distance from which the hand approaches [m]."""

_PAD_GIVES = 0.0005  # compliance of rubber pads and finger tips [m]
_LEAST_ROOM = 0.003  # distance between an open finger and the object [m]
_MOST_ROOM = 0.010  # tolerance of the grasp [m]
_OFF_CENTRE = 0.002  # thickness of the held object along the closing direction [m]
_HELD = 0.002  # least length of contact on a pad, along the approach and across [m]
_FRICTION = 0.5  # friction of rubber on metal or wood, conservative
_OFF_SURFACE = 0.001  # tolerance of the point at which a finger pushes [m]
_FOOTHOLD = 0.002  # least width of contact under a pushing finger [m]
_ALONG = 0.5  # least cosine between a push and the motion of its point
_LEAST_SHARE = 0.2  # share of the range through which a hand has to move a joint
_NEARLY_ALL = 0.999
_GRAZES = 1e-4  # largest reach of a hand below the ground [m]


def check_grasps(asset: Asset) -> CheckResult:
    """Check every grasp with a parallel gripper and every push with a finger, at the approach and in motion.

    A hand approaches where its joint may move: a drawer behind a door is approached with the door open.

    Args:
        asset: The asset, in memory or loaded.

    Returns:
        A fault for each impossible grasp, each ineffective push, and each free joint that no hand can move
        with at most `MOST_FORCE`. A note if each hand strikes something before the end of a range, and if
        something has to be opened first without a dependency. An asset without grasps and pushes has one
        note. With independent limits, all findings are notes.
    """
    free = [joint.name for joint in asset.free_joints if not joint.driven]
    found = asset.affordances
    if not found:
        hint = "give parts that hands move grasp=grasp_on(...) or push=push_on(...)"
        note = Finding(CHECK, f"no grasp or push moves {', '.join(free)}", hint=hint, severity="note")
        return CheckResult(CHECK, (note,) if free else (), "no grasps, no pushes")
    space = HandSpace(asset)
    findings: list[Finding] = []
    best = dict.fromkeys((joint.name for joint in asset.free_joints), 0.0)
    faulty: set[str] = set()
    for affordance in found:
        opened, faults = _approach(space, affordance)
        findings += faults
        if any(each.severity == "fault" for each in faults):
            faulty |= set(affordance.joints)
        else:
            findings += _floor_findings(space, affordance, opened)
            findings += _motion_findings(space, affordance, opened, best)
    # notes about a hand are irrelevant if another hand moves the joint all the way
    findings = [
        each for each in findings if each.severity == "fault" or best.get(each.joint, 0.0) < _NEARLY_ALL
    ]
    forces = hand_forces(asset)
    findings += _joint_findings(asset, best, forces, faulty)
    if asset.limits != "full":  # hands are given for whole ranges: a part may stand open now, out of reach
        findings = [replace(each, severity="note") for each in findings]
    grasps = sum(each.kind == "grasp" for each in found)
    detail = f"{grasps} grasps, {len(found) - grasps} pushes"
    name, most = max(forces.items(), key=lambda force: force[1], default=("", 0.0))
    if most >= 0.01:
        detail += f"; with at most {most:.3g} N, at {name}"
    return CheckResult(CHECK, tuple(findings), detail)


def _approach(space: HandSpace, affordance: Affordance) -> tuple[Opened, list[Finding]]:
    """Approach with a hand where its joint may move, and open obstacles if possible."""
    given = {} if affordance.when is None else {"": affordance.when}
    opened: dict[str, AssetCondition] = dict(given)
    faults, struck = _faults(space, affordance, opened)
    first = faults
    while faults:
        candidates = openable(space.asset, affordance, struck) if struck else ()
        name, where = next((each for each in candidates if each[0] not in opened), ("", None))
        if where is None:
            return given, first
        opened[name] = where
        faults, struck = _faults(space, affordance, opened)
    message = f"{affordance.kind} {affordance.name}: a hand reaches it only where {_listed(opened)}"
    note = Finding(CHECK, message, affordance.link, severity="note")
    return opened, [note] if opened != given else []


def _faults(space: HandSpace, affordance: Affordance, opened: Opened) -> Faults:
    pose = _pose(space.asset, affordance, opened)
    if pose is None:
        return [_fault(affordance, f"{_listed(opened)} cannot be", "come from another direction")], ""
    faults = _grasp_faults if affordance.kind == "grasp" else _push_faults
    return faults(space, affordance, pose)


def _pose(asset: Asset, affordance: Affordance, opened: Opened) -> dict[str, Array] | None:
    """Return the displacements of links during the approach; None without a valid position."""
    q = positions_to_move(asset, affordance.joints[0] if affordance.joints else "", opened)
    if q is None and opened:
        return None
    return asset.pose(q or {})


def _listed(opened: Opened) -> str:
    return " and ".join(str(condition) for condition in opened.values())


def _fault(
    affordance: Affordance, message: str, hint: str, value: float | None = None, joint: str = ""
) -> Finding:
    text, unit = f"{affordance.kind} {affordance.name}: {message}", "" if value is None else "m"
    return Finding(CHECK, text, affordance.link, joint, value, unit, hint=hint)


def _mm(length: float) -> str:
    return f"{1e3 * length:.3g} mm"


def _grasp_faults(space: HandSpace, grasp: Affordance, pose: Mapping[str, Array]) -> Faults:
    """Return the first obstacle of an open gripper that approaches and closes on the link."""
    if not 0.0 < grasp.width <= GRIPPER.stroke + 1e-9:
        message = f"its width is {_mm(grasp.width)}, and the gripper opens to {_mm(GRIPPER.stroke)}"
        hint = "grip it where it is thinner, or along another direction"
        return [_fault(grasp, message, hint, grasp.width)], ""
    half, frame = grasp.width / 2.0, pose[grasp.link] @ grasp.frame
    for name, box in GRIPPER.blocks(-half, half, COMES_FROM).items():
        touch = space.first_touch(box, frame, pose)
        if touch is not None:
            message = f"on its way to the grasp the {name} strikes {touch}"
            hint = "move the frame, come from another direction, or make the width that of the object"
            return [_fault(grasp, message, hint)], touch.link
    between = GRIPPER.between(half)
    own = space.inside(between, grasp.frame, grasp.link)
    if not len(own):
        hint = "put its origin into the middle of the held object"
        return [_fault(grasp, f"the fingers close on nothing of link {grasp.link}", hint)], ""
    low, high = float(own[:, 0].min()), float(own[:, 0].max())
    for touch, points in space.others_inside(between, frame, pose, grasp.link):
        ahead = max(float(points[:, 0].max()) - high, low - float(points[:, 0].min()))
        if ahead > -_PAD_GIVES / 10.0:
            message = f"a closing finger touches {touch} {_mm(max(ahead, 0.0))} before the link"
            return [_fault(grasp, message, "move the frame away from it, or turn it", ahead)], touch.link
    return [*_width_faults(grasp, low, high), *_contact_faults(space, grasp, low, high)], ""


def _floor_findings(space: HandSpace, grasp: Affordance, opened: Opened) -> Iterator[Finding]:
    """Yield the depth of the hand below the ground, if the asset stands on the ground."""
    # a note: the user decides whether there is a ground
    pose = _pose(space.asset, grasp, opened)
    if grasp.kind == "push" or pose is None:
        return
    frame = pose[grasp.link] @ grasp.frame
    for name, box in GRIPPER.blocks(-grasp.width / 2.0, grasp.width / 2.0).items():
        corners = np.stack(np.meshgrid(*box.T), axis=-1).reshape(-1, 3)
        below = space.lowest - float((corners @ frame[2, :3]).min() + frame[2, 3])
        if below > _GRAZES:
            message = (
                f"grasp {grasp.name}: the {name} reaches {_mm(below)} below the lowest point of the asset, "
                "where the ground may be"
            )
            yield Finding(CHECK, message, grasp.link, value=below, unit="m", severity="note")
            return


def _width_faults(grasp: Affordance, low: float, high: float) -> Iterator[Finding]:
    thickness, middle = high - low, (high + low) / 2.0
    room = (grasp.width - thickness) / 2.0
    if thickness + 2.0 * _LEAST_ROOM > GRIPPER.stroke + 1e-6:
        message = f"the held object is {_mm(thickness)} thick; the gripper opens to {_mm(GRIPPER.stroke)}"
        yield _fault(grasp, message, "grip it where it is thinner, or along another direction", thickness)
    elif not _LEAST_ROOM - 1e-6 <= room <= _MOST_ROOM + 1e-6:
        message = (
            f"its width of {_mm(grasp.width)} leaves each finger {_mm(room)} beside the held object, "
            f"{_mm(thickness)} thick; {_mm(_LEAST_ROOM)} to {_mm(_MOST_ROOM)} are right"
        )
        wanted = GRIPPER.opening(thickness)
        yield _fault(grasp, message, f"make grasp_width {wanted:.4g}, or leave it out", grasp.width)
    if abs(middle) > _OFF_CENTRE + 1e-6:
        message = f"the held object is {_mm(abs(middle))} off the middle between the fingers"
        hint = "move the frame along the closing direction, by at most 2 mm off"
        yield _fault(grasp, message, hint, middle)


def _contact_faults(space: HandSpace, grasp: Affordance, low: float, high: float) -> Iterator[Finding]:
    """Yield the faults of the contact of the pads."""
    patches, gives = [], _PAD_GIVES + FACETS[space.asset.detail] - FACETS["full"]
    for side, at in ((1.0, high), (-1.0, low)):
        corners = GRIPPER.between(0.0)
        corners[:, 0] = sorted((at - side * gives, at + side * gives))
        points = space.inside(corners, grasp.frame, grasp.link)[:, 1:]
        patch = np.array([points.min(axis=0), points.max(axis=0)])
        along = float(patch[1, 1]) - max(float(patch[0, 1]), -GRIPPER.pad / 2.0)
        across = float(patch[1, 0] - patch[0, 0])
        if min(along, across) < _HELD:
            message = f"only {_mm(max(along, 0.0))} by {_mm(across)} of a pad touch the link"
            room = f"each pad needs at least {_mm(_HELD)}"
            hint = f"move the frame along the approach or across; {room}"
            yield _fault(grasp, message, hint, min(along, across))
            return
        patches.append(patch)
    first, second = patches
    gap = np.maximum(np.maximum(first[0] - second[1], second[0] - first[1]), 0.0)
    slope = float(np.linalg.norm(gap)) / max(high - low, 1e-9)
    if slope > _FRICTION:
        apart = _mm(float(np.linalg.norm(gap)))
        message = f"the pads touch it {apart} apart sideways: it rotates out of the grasp"
        yield _fault(grasp, message, f"close on faces that are opposite each other (slope {slope:.2g} > 0.5)")


def _push_faults(space: HandSpace, push: Affordance, pose: Mapping[str, Array]) -> Faults:
    """Return the obstacle of a finger on its straight path to the point of a push."""
    depths = space.finger_depths(pose[push.link] @ push.frame, pose, COMES_FROM)
    own = depths.pop(push.link, None)
    if own is None:
        message = f"a finger of {_mm(GRIPPER.finger)} touches nothing of link {push.link} there"
        return [_fault(push, message, "put its origin on the surface of the link, the approach into it")], ""
    first = min(depths, key=lambda link: depths[link], default="")
    if first and depths[first] < own + 1e-5:
        message = f"the finger touches {first} {_mm(own - depths[first])} before link {push.link}"
        return [_fault(push, message, "move the point away from it", own - depths[first])], first
    if abs(own) > _OFF_SURFACE:
        where = "before" if own < 0.0 else "behind"
        message = f"the surface is {_mm(abs(own))} {where} its point"
        return [_fault(push, message, "put its origin on the surface", abs(own))], ""
    patch = space.finger_patch(push.frame, own, _PAD_GIVES, push.link)
    outside = max(float(patch[0].max()), float(-patch[1].min()))
    if outside > _OFF_SURFACE or float((patch[1] - patch[0]).min()) < _FOOTHOLD:
        message = f"the finger touches the link beside its point, {_mm(max(outside, 0.0))} off or at an edge"
        hint = "put its origin into the middle of a face that is opposite the finger"
        return [_fault(push, message, hint)], ""
    return [], ""


def _motion_findings(
    space: HandSpace, affordance: Affordance, opened: Opened, best: dict[str, float]
) -> Iterator[Finding]:
    """Yield the obstacles of the hand in motion; `best` collects the largest share of each joint."""
    asset = space.asset
    for number, name in enumerate(affordance.joints):
        if affordance.kind == "push":
            along = tendency(asset, affordance, name)
            if along < _ALONG:
                if not number:
                    message = "it pushes against the limit of the joint"
                    if along > 0.0:
                        message = f"only {along:.2g} of its force moves the joint"
                    hint = "turn the push towards the opening direction of the joint"
                    yield _fault(affordance, message, hint, joint=name)
                continue
        reach = reach_of(space, affordance, name, opened)
        best[name] = max(best[name], reach.share)
        if reach.share >= _NEARLY_ALL or reach.touch is None:
            continue
        message = (
            f"{affordance.kind} {affordance.name}: the hand moves the joint through "
            f"{100 * reach.share:.0f} % of its range, then the {reach.part} strikes {reach.touch}"
        )
        finding = partial(Finding, CHECK, message, affordance.link, name, reach.share, pose=reach.pose)
        if not number and reach.share < _LEAST_SHARE:
            yield finding(hint="turn or move the frame so that the hand stays clear of it")
        else:
            yield finding(severity="note")


def _joint_findings(
    asset: Asset, best: Mapping[str, float], forces: Mapping[str, float], faulty: Collection[str]
) -> Iterator[Finding]:
    """Yield the free joints that no hand moves, or moves with too much force."""
    # joints whose grasps and pushes have faults are left out
    for name, share in best.items():
        joint, force = asset.joint(name), forces.get(name, 0.0)
        moving = [each.name for each in asset.affordances if name in each.joints]
        if joint.driven or name in faulty or asset.link(joint.child).absent:
            continue
        if not moving:
            hint = (
                f"give {joint.child} or a link behind it a grasp or a push, or name its actuator: driven=..."
            )
            yield Finding(CHECK, "no grasp or push moves it", joint=name, hint=hint)
        elif share < _LEAST_SHARE:
            message = (
                f"no hand at {', '.join(moving)} moves it through {100 * _LEAST_SHARE:.0f} % of its range"
            )
            hint = "correct one of them, or add another"
            yield Finding(CHECK, message, joint=name, value=share, hint=hint)
        if force > MOST_FORCE:
            message = (
                f"a hand needs {force:.3g} N to move it against friction, springs and weight, more than "
                f"{MOST_FORCE:.3g} N"
            )
            hint = (
                "weaken friction or spring, balance the weight with a spring, or let the hand act "
                "farther from the axis"
            )
            yield Finding(CHECK, message, joint.child, name, force, "N", hint=hint)
