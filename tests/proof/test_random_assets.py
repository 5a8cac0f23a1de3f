"""The proof against exact booleans on small assets drawn at random, and what once slipped through it.

`ARTGEN_TEST_RANDOM=3000 pytest tests/proof/test_random_assets.py` is the long form.
"""

import math
import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from artgen import Solid, bore, box, cylinder, material, part, tube, union, weld
from artgen.asset import AllowedContact, Asset, Link
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetJoint as Joint
from artgen.asset.certificate import Certificate
from artgen.asset.joint import AssetCoupling as Coupling
from artgen.asset.joint import AssetDependency as Dependency
from artgen.asset.tree import Branch, Tree
from artgen.errors import AssetError
from artgen.proof.overlap import allowed_at, displacement
from artgen.proof.paths import Space
from artgen.proof.recheck import recheck
from support.brute import moving_pairs, overlaps
from support.proof_fridges import evaluated

FIRST = int(os.environ.get("ARTGEN_TEST_RANDOM_FROM", "20"))
COUNT = int(os.environ.get("ARTGEN_TEST_RANDOM", "12"))
POSES = 120
STEEL = material("stainless")
X, Y, Z = np.eye(3)
AXES = [sign * axis for axis in np.eye(3) for sign in (1.0, -1.0)]
Pose = dict[str, float]


# assets


def drawn_solid(draw: np.random.Generator) -> Solid:
    """A box, a cylinder, a hollow, or two of them together."""
    kind = draw.integers(6)
    size = draw.uniform(0.02, 0.12, 3).round(3).tolist()
    if kind < 2:
        return box(*size)
    if kind == 2:
        return cylinder(size[0] / 2, size[2])
    if kind == 3:
        return tube(size[0] / 2 + 0.01, size[0] / 2, size[2])
    if kind == 4:
        return box(0.1, 0.1, size[2]) - bore(size[0] / 3, 0.2)
    return union(box(*size), box(0.02, 0.03, 0.15).at(size[0] / 2, 0.0, 0.0))


def drawn_link(draw: np.random.Generator, name: str, place: np.ndarray) -> Link:
    """A link of one or two labelled parts near a place."""
    parts = []
    for label in ("body", "pad")[: draw.integers(1, 3)]:
        offset = place if label == "body" else place + draw.uniform(-0.05, 0.05, 3).round(3)
        parts.append(part(drawn_solid(draw).at(*offset.tolist()), label, STEEL))
    return replace(evaluated(weld(*parts), name).links[0], name=name, separate="drawn by chance")


def drawn_axis(draw: np.random.Generator) -> np.ndarray:
    if draw.random() < 0.75:
        return AXES[draw.integers(6)]
    axis = draw.normal(size=3)
    return axis / np.linalg.norm(axis)


def drawn_joint(draw: np.random.Generator, name: str, place: np.ndarray, others: Sequence[Joint]) -> Joint:
    """A joint, often about the axis of another one, with limits of either sign."""
    kind = "revolute" if draw.random() < 0.55 else "prismatic"
    axis, pivot = drawn_axis(draw), (place + draw.uniform(-0.05, 0.05, 3)).round(3)
    if others and draw.random() < 0.4:
        other = others[draw.integers(len(others))]
        sign = 1.0 if draw.random() < 0.5 else -1.0
        axis, pivot = sign * other.axis, other.pivot + 0.1 * draw.integers(-1, 2) * other.axis
    elif draw.random() < 0.5:
        pivot = place.copy()
    reach = draw.choice([0.3, 1.2, 2.5, 4.0]) if kind == "revolute" else draw.choice([0.02, 0.1, 0.3])
    ends = [(0.0, reach), (-reach, 0.0), (-reach / 2, reach), (0.3 * reach, reach), (-reach, -0.4 * reach)]
    limits: tuple[float, float] | None = tuple(np.round(ends[draw.integers(5)], 4).tolist())
    chance = draw.random()
    if chance < 0.08:
        at = float(draw.uniform(-reach, reach))
        limits = (at, at)
    elif chance < 0.16 and kind == "revolute":
        limits = None
    return Joint(name, kind, axis, pivot, limits)  # type: ignore[arg-type]


def drawn_condition(draw: np.random.Generator, names: Sequence[str], depth: int = 2) -> Condition:
    if depth == 0 or draw.random() < 0.6:
        kind = "above" if draw.random() < 0.5 else "below"
        return Condition(kind, str(draw.choice(names)), float(draw.uniform(-0.2, 0.3)))  # type: ignore[arg-type]
    terms = tuple(drawn_condition(draw, names, depth - 1) for _ in range(2))
    return Condition("all" if draw.random() < 0.5 else "any", terms=terms)


def limited(joints: Sequence[Joint], name: str) -> bool:
    """Tell whether a joint and all that it follows have limits."""
    joint = next(each for each in joints if each.name == name)
    return joint.limits is not None and (joint.follows is None or limited(joints, joint.follows.leader))


def bound(draw: np.random.Generator, joints: list[Joint]) -> list[Joint]:
    """Couple some joints to others, and let some need others."""
    result = list(joints)
    for index in range(1, len(result)):
        if draw.random() < 0.25:
            leader = result[draw.integers(index)].name
            ratio = float(draw.choice([-2.0, -1.0, -0.5, 0.5, 1.0, 1.5, 3.0]))
            offset = float(draw.choice([0.0, 0.0, 0.1, -0.2]))
            result[index] = replace(result[index], follows=Coupling(leader, ratio, offset))
    known = [joint.name for joint in result if limited(result, joint.name)]
    for index, joint in enumerate(result):
        others = [name for name in known if name != joint.name]
        if others and draw.random() < 0.25:
            until = float(draw.uniform(0.02, 0.2)) if draw.random() < 0.4 else None
            beyond = float(draw.uniform(0.005, 0.015)) if draw.random() < 0.4 else None
            needs = Dependency(drawn_condition(draw, others), until, beyond)
            result[index] = replace(joint, needs=needs)
    return result


def drawn_contacts(
    draw: np.random.Generator, parents: Sequence[int], joints: Sequence[Joint]
) -> Iterator[AllowedContact]:
    """Contacts of links that are joined, everywhere or where joints between them stand so."""
    for child in range(1, len(parents)):
        if draw.random() < 0.3:
            between = [joint.name for joint in joints if joint.child == f"l{child}"]
            when = drawn_condition(draw, between, 1) if draw.random() < 0.5 else None
            links = (f"l{parents[child]}", f"l{child}")
            if draw.random() < 0.5:
                links = links[::-1]
            labels = (str(draw.choice(["body", "pad"])), str(draw.choice(["body", "pad"])))
            depth = float(draw.choice([0.0, 0.002, 0.03]))
            yield AllowedContact(links, labels, depth, "drawn by chance", when)


def drawn_asset(seed: int) -> Asset:
    """An asset of 3 to 5 links in a chain, a star or between, some of them moved or reflected once made."""
    draw = np.random.default_rng(seed)
    count = int(draw.integers(3, 6))
    step = draw.choice([0.05, 0.12, 0.2])
    places = [(step * draw.integers(-1, 2, 3)).round(3) + (step * index, 0.0, 0.0) for index in range(count)]
    links = [drawn_link(draw, f"l{index}", place) for index, place in enumerate(places)]
    star = draw.random()
    parents = [0, *(0 if draw.random() < star else int(draw.integers(index)) for index in range(1, count))]
    joints: list[Joint] = []
    for index in range(1, count):
        for number in range(1 if draw.random() < 0.75 else 2):
            joint = drawn_joint(draw, f"j{index}_{number}", places[index], joints)
            joints.append(replace(joint, parent=f"l{parents[index]}", child=f"l{index}"))
    joints = bound(draw, joints)
    contacts = tuple(drawn_contacts(draw, parents, joints))

    def tree(index: int) -> Tree:
        branches = []
        for child in range(1, count):
            if parents[child] == index:
                own = tuple(joint for joint in joints if joint.child == f"l{child}")
                branches.append(Branch(own, tree(child)))
        return Tree(links[index], tuple(branches))

    whole = replace(tree(0), contacts=contacts)
    if draw.random() < 0.3:
        motion = np.diag([-1.0, 1.0, 1.0, 1.0]) if draw.random() < 0.5 else np.eye(4)
        motion[:3, 3] = draw.uniform(-0.3, 0.3, 3)
        whole = whole.moved(motion)
    return Asset.from_tree(whole, f"drawn_{seed}", "drawn")


# poses


def thresholds(asset: Asset) -> dict[str, list[float]]:
    """Positions of free joints at which something begins or ends."""
    found = {}
    for joint in asset.free_joints:
        low, high = joint.limits or (-math.pi, math.pi)
        found[joint.name] = [low, high, joint.closed]
    conditions = [contact.when for contact in asset.contacts if contact.when is not None]
    conditions += [joint.needs.condition for joint in asset.joints if joint.needs is not None]
    for name in found:
        for condition in conditions:
            found[name] += [term.value for term in terms(condition) if term.joint == name]
    return found


def terms(condition: Condition) -> Iterator[Condition]:
    for term in condition.terms:
        yield from terms(term)
    if not condition.terms:
        yield condition


def allowed_poses(asset: Asset, count: int, seed: int) -> list[Pose]:
    """Positions of the free joints that no dependency forbids; none if chance finds none."""
    draw = np.random.default_rng(seed)
    special, poses = thresholds(asset), []
    for _ in range(count):
        q: Pose = {}
        for joint in asset.free_joints:
            low, high = joint.limits or (-math.pi, math.pi)
            q[joint.name] = float(draw.uniform(low, high))
            if draw.random() < 0.3:
                near = float(draw.choice(special[joint.name])) + float(draw.choice([-1e-6, 0.0, 1e-6]))
                q[joint.name] = min(max(near, low), high)
        for _ in range(3):
            blocked = [name for name in asset.blocked(q) if name in q]
            q |= {name: asset.joint(name).closed for name in blocked}
        if not asset.blocked(q):
            poses.append(q)
    return poses


def distance(asset: Asset, links: tuple[str, str], q: Pose, most: float) -> float:
    """Return the exact distance of two links at a pose, at most a length [m]."""
    poses = asset.pose(q)
    first, second = (
        [piece.shape.manifold.transform(poses[name][:3]) for piece in asset.link(name).pieces]
        for name in links
    )
    return min(a.min_gap(b, most) for a in first for b in second)


# what is claimed


def certified(asset: Asset, **settings: Any) -> Certificate | None:
    """Return the certificate; None where a dependency that was drawn can never be met."""
    try:
        return asset.certify(**settings)
    except AssetError as error:
        assert "it could never move" in str(error) or "contradict each other" in str(error)  # noqa: PT017 - by chance
        return None


def check_proven(asset: Asset, certificate: Certificate, poses: Sequence[Pose]) -> None:
    proven = [pair.links for pair in certificate.pairs if pair.verdict == "proven"]
    found = overlaps(asset, poses, pairs=proven)
    assert not found, f"{found[0][1:]} is proven, at {poses[found[0][0]]}"


def check_distances(asset: Asset, certificate: Certificate, poses: Sequence[Pose]) -> None:
    """Assert that no pair comes nearer than what is guaranteed of it."""
    touching = {frozenset(contact.links) for contact in asset.contacts}
    for pair in certificate.pairs:
        if pair.guaranteed is None or frozenset(pair.links) in touching:
            continue
        assert pair.guaranteed >= certificate.tolerance - 1e-9
        assert pair.found is None or pair.found >= pair.guaranteed
        for q in poses:
            nearest = distance(asset, pair.links, q, 0.02)
            assert nearest >= min(pair.guaranteed, 0.02) - 1e-9, (pair.links, q)


def completed(asset: Asset, pose: Pose, poses: Sequence[Pose]) -> Pose | None:
    """Return the pose of a pair with the other free joints where nothing is forbidden."""
    free = {joint.name for joint in asset.free_joints}
    own = {name: position for name, position in pose.items() if name in free}
    rest = {joint.name: joint.closed for joint in asset.free_joints}
    candidates = [rest | own, *(q | own for q in poses)]
    return next((q for q in candidates if not asset.blocked(q)), None)


def check_witnesses(asset: Asset, certificate: Certificate, poses: Sequence[Pose]) -> None:
    free = {joint.name for joint in asset.free_joints}
    for pair in certificate.pairs:
        if pair.verdict == "collision" and set(pair.joints) <= free:
            assert pair.witness is not None
            q = completed(asset, dict(pair.witness.pose), poses)
            if q is None:  # what the others must be for it is for chance to find
                continue
            assert overlaps(asset, [q], pairs=[pair.links], least=0.0), (pair.links, q)


def mutants(asset: Asset, draw: np.random.Generator) -> Iterator[Asset]:
    """Assets that differ in one joint, in one link or in what may touch."""
    for index, joint in enumerate(asset.joints):
        changes: list[dict[str, Any]] = [
            {"axis": -joint.axis},
            {"pivot": joint.pivot + draw.uniform(-0.05, 0.05, 3)},
        ]
        if joint.needs is not None:
            changes.append({"needs": None})
            changes.append({"needs": replace(joint.needs, until=0.01)})
        if joint.follows is not None:
            changes.append({"follows": replace(joint.follows, ratio=-joint.follows.ratio)})
            changes.append({"follows": replace(joint.follows, offset=joint.follows.offset + 0.1)})
        elif joint.limits is not None and not joint.locked:
            low, high = joint.limits
            changes.append({"limits": (low - 0.5 * (high - low), high)})
            changes.append({"limits": (low, high + 0.5 * (high - low))})
        changed = replace(joint, **changes[draw.integers(len(changes))])
        yield replace(asset, joints=(*asset.joints[:index], changed, *asset.joints[index + 1 :]))
    if asset.contacts:
        yield replace(asset, contacts=asset.contacts[1:])
        yield replace(asset, contacts=tuple(replace(each, depth=0.0) for each in asset.contacts))
    matrix = np.eye(4)
    matrix[:3, 3] = draw.uniform(-0.05, 0.05, 3)
    yield replace(asset, links=(*asset.links[:-1], asset.links[-1].moved(matrix)))


def check_transplants(asset: Asset, certificate: Certificate, seed: int) -> int:
    """Assert that the proof is refused on mutants that collide; return how many there were."""
    proven = [pair.links for pair in certificate.pairs if pair.verdict == "proven"]
    count = 0
    for mutant in mutants(asset, np.random.default_rng(seed)):
        poses = allowed_poses(mutant, POSES // 3, seed)
        if poses and overlaps(mutant, poses, pairs=proven, most=1):
            count += 1
            assert recheck(mutant, certificate), f"a false proof is accepted; seed {seed}"
    return count


def check_seed(seed: int) -> tuple[int, int, int]:
    """Check all that is claimed of one asset; return how much was proven, collides and was refused."""
    asset = drawn_asset(seed)
    certificate = certified(asset)
    if certificate is None:
        return 0, 0, 0
    judged = {frozenset(pair.links) for pair in certificate.pairs}
    assert judged == {frozenset(pair) for pair in moving_pairs(asset)}
    poses = allowed_poses(asset, POSES, seed)
    check_proven(asset, certificate, poses)
    check_witnesses(asset, certificate, poses)
    assert recheck(asset, certificate) == []
    refused = check_transplants(asset, certificate, seed)
    measured = certified(asset, tolerance=(0.0, 0.001, 0.004)[seed % 3], measure=True)
    assert measured is not None
    check_proven(asset, measured, poses)
    check_distances(asset, measured, poses[:: 1 + len(poses) // 12])
    assert recheck(asset, measured) == []
    verdicts = [pair.verdict for pair in certificate.pairs]
    return verdicts.count("proven"), verdicts.count("collision"), refused


def test_what_is_claimed_of_drawn_assets_is_so() -> None:
    totals = np.zeros(3, np.int64)
    for seed in range(FIRST, FIRST + COUNT):
        try:
            totals += check_seed(seed)
        except AssertionError as error:
            raise AssertionError(f"seed {seed}: {error}") from error
    assert (totals > COUNT // 20).all(), totals


def test_the_ways_of_drawn_assets_hold_every_allowed_pose_and_lead_where_it_does() -> None:
    seen = 0
    for seed in range(FIRST, FIRST + 7 * COUNT):
        asset = drawn_asset(seed)
        try:
            joint_paths = Space(asset).joint_paths()
        except AssetError as error:
            assert "it could never move" in str(error)  # noqa: PT017 - drawn by chance
            continue
        for q in allowed_poses(asset, 12, seed):
            positions, poses = asset.positions(q), asset.pose(q)
            for joint_path in joint_paths:
                at = np.array([positions[name] for name in joint_path.variables])
                expected = np.linalg.inv(poses[joint_path.links[0]]) @ poses[joint_path.links[1]]
                np.testing.assert_allclose(displacement(joint_path, at), expected, atol=1e-9)
                if any(asset.joint(name).limits is None for name in joint_path.variables):
                    continue
                within = [
                    ((box[:, 0] <= at + 1e-9) & (at - 1e-9 <= box[:, 1])).all() for box in joint_path.boxes
                ]
                assert any(within), (seed, joint_path.links, q)
                allowed = set(allowed_at(joint_path, at))  # at a threshold it may hold on one side only
                for contact in asset.contacts:
                    if (
                        contact in allowed
                        and contact.when is not None
                        and not touches(contact.when, positions)
                    ):
                        assert contact.when.holds(positions), (seed, joint_path.links, q)
                seen += 1
    assert seen > 70 * COUNT


def touches(condition: Condition, positions: Pose) -> bool:
    return any(abs(term.value - positions[term.joint]) < 1e-5 for term in terms(condition))
