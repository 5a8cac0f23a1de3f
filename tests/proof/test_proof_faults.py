"""Faults that proofs, verifications and their helpers once had, each with the asset that showed it."""

import copy
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from artgen import Solid, box, material, part, union, weld
from artgen.asset import AllowedContact, Asset, Link
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetJoint as Joint
from artgen.asset.certificate import Certificate
from artgen.asset.collision import replace_colliders
from artgen.asset.joint import AssetCoupling as Coupling
from artgen.asset.joint import AssetDependency as Dependency
from artgen.asset.tree import Branch, Tree
from artgen.colliders import Convex
from artgen.errors import AssetError
from artgen.proof.bounds import Motion, enclosing_points
from artgen.proof.recheck import recheck
from support.brute import overlaps
from support.proof_fridges import block, evaluated

STEEL = material("stainless")
X, Y, Z = np.eye(3)


def cube(x: float, y: float = 0.0, z: float = 0.0) -> Solid:
    return box(0.1, 0.1, 0.1).at(x, y, z)


def link(name: str, **solids: Solid) -> Link:
    """A link with one solid for each label."""
    parts = [part(solid, label, STEEL) for label, solid in solids.items()]
    whole = weld(*parts) if len(parts) > 1 else parts[0]
    return replace(evaluated(whole, name).links[0], name=name, separate="made for a test")


def joint(name: str, kind: str, axis: np.ndarray, limits: tuple[float, float] | None, **fields: Any) -> Joint:
    return Joint(name, kind, axis, fields.pop("pivot", np.zeros(3)), limits, **fields)  # type: ignore[arg-type]


def joined(base: Link, *branches: tuple[Joint | tuple[Joint, ...], Link], contact: Any = None) -> Asset:
    """An asset whose links all hang on the first one."""
    found = tuple(Branch(own if isinstance(own, tuple) else (own,), Tree(child)) for own, child in branches)
    return Asset.from_tree(Tree(base, found, () if contact is None else (contact,)), "made", "made")


def pusher(reach: float, **fields: Any) -> Asset:
    """A cube that slides towards another one, 0.2 m away."""
    return joined(
        link("base", body=cube(0.0)),
        (joint("a", "prismatic", -X, (0.0, reach)), link("arm", body=cube(0.3))),
        **fields,
    )


def forged(good: Certificate, rows: list[list[float]]) -> Certificate:
    """A certificate whose only pair has other leaves."""
    leaves = copy.deepcopy(dict(good.leaves or {}))
    leaves["pairs"][0]["leaves"] = rows
    return replace(good, leaves=leaves)


def test_a_frame_before_the_first_joint_is_refused() -> None:
    def sliding(reach: float) -> Asset:
        slides = (
            joint("a", "prismatic", -X, (0.0, reach)),
            joint("b", "prismatic", Z, (0.0, 0.01)),
            joint("c", "prismatic", Z, (0.0, 0.01)),
        )
        return joined(link("base", body=cube(0.0)), (slides, link("arm", body=cube(0.3))))

    good = sliding(0.1).certify()
    row = [0, 1, 0, 1, -1, 1.0, 0.0, 0.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0]
    assert sliding(0.25).certify().pairs[0].verdict == "collision"
    (finding,) = recheck(sliding(0.25), forged(good, [row]))
    assert "is damaged" in finding.message


def test_pieces_that_are_counted_from_the_end_are_refused() -> None:
    def two(reach: float) -> Asset:
        arm = link("arm", body=union(cube(0.3), cube(0.0, 0.0, 1.0)))
        return joined(link("base", body=cube(0.0)), (joint("a", "prismatic", -X, (0.0, reach)), arm))

    good = two(0.1).certify()
    for order in ([0, 1], [1, 0]):
        false = forged(good, [[0, 1, -1, 2, 0, 0.0, 0.0, 1.0, -1.0, 1.0]])
        assert false.leaves is not None
        false.leaves["pieces"][0]["arm"]["order"] = order
        assert two(0.25).certify().pairs[0].verdict == "collision"
        assert recheck(two(0.25), false)


def test_a_negative_tolerance_and_a_clearance_that_is_not_proven_are_refused() -> None:
    good = pusher(0.19).certify()
    wider = [[0, 1, 0, 1, 0, 1.0, 0.0, 0.0, -1.0, 0.3]]
    assert recheck(pusher(0.25), replace(forged(good, wider), tolerance=-1.0))
    pair = replace(good.pairs[0], guaranteed=0.15)
    (finding,) = recheck(pusher(0.19), replace(good, pairs=(pair,)))
    assert "leaves a gap of 10.000000 mm" in finding.message or "leaves a gap of 9.99999" in finding.message


def test_pieces_that_stand_off_their_solids_by_less_than_these_stick_out_are_refused() -> None:
    good, reach = pusher(0.19).certify(), 0.2 - 2e-6
    assert recheck(
        pusher(reach),
        replace(
            forged(good, [[0, 1, 0, 1, 0, 1.0, 0.0, 0.0, -1e-9, reach + 1e-9]]),
            pairs=(replace(good.pairs[0], guaranteed=None),),
        ),
    )


def test_a_contact_is_verified_to_its_depth_and_only_where_it_is_allowed() -> None:
    def pressed(reach: float, when: Condition | None = None) -> Asset:
        return pusher(reach, contact=AllowedContact(("base", "arm"), ("body", "body"), 0.01, "a pad", when))

    certificate = pressed(0.209).certify()
    assert recheck(pressed(0.209), certificate) == []
    for reach, when in ((0.212, None), (0.209, Condition("below", "a", 0.205))):
        false = forged(certificate, [[0, 1, 0, 1, 0, 1.0, 0.0, 0.0, -1e-9, reach + 1e-9]])
        (finding, *_) = recheck(pressed(reach, when), false)
        assert "leaves a gap of" in finding.message


def padded() -> Asset:
    """A pusher whose cube carries a pad that may press in; the cube itself hits."""
    pad = AllowedContact(("base", "arm"), ("body", "pad"), 0.05, "a pad")
    arm = link("arm", body=cube(0.3), pad=cube(0.35))
    return joined(link("base", body=cube(0.0)), (joint("a", "prismatic", -X, (0.0, 0.23)), arm), contact=pad)


def test_pieces_do_not_pass_for_solids_of_another_label() -> None:
    asset = padded()
    certificate = asset.certify()
    assert certificate.pairs[0].verdict == "collision"
    pieces = {
        each.name: {
            "order": list(range(len(each.colliders))),
            "excess": 0.0,
            "points": [collider.convex.outer_points(2e-5).tolist() for collider in each.colliders],
            "labels": ["pad" if each.name == "arm" else "body"] * len(each.colliders),
        }
        for each in asset.links
    }
    rows = [[0, 1, index, index + 1, 0, 1.0, 0.0, 0.0, -1e-9, 0.23 + 1e-9] for index in (0, 1)]
    proof = {
        "format": "artgen-certificate-1",
        "pieces": [pieces],
        "pairs": [{"links": ["base", "arm"], "pieces": 0, "leaves": rows}],
    }
    pair = replace(certificate.pairs[0], verdict="proven", witness=None)
    found = recheck(asset, replace(certificate, pairs=(pair,), leaves=proof))
    assert any("extend beyond the pieces" in finding.message for finding in found)


def test_colliders_with_another_label_than_their_solids_prove_nothing_of_these() -> None:
    asset = padded()
    colliders = {each.name: each.colliders for each in asset.links}
    colliders["arm"] = tuple(replace(collider, label="pad") for collider in colliders["arm"])
    certificate = replace_colliders(asset, colliders, "coacd").certify()
    assert certificate.pairs[0].verdict == "collision"


def test_what_is_said_of_colliders_needs_a_proof_of_its_own() -> None:
    asset = pusher(0.1)
    corners = np.array([[x, y, z] for x in (-0.2, 0.4) for y in (-0.1, 0.1) for z in (-0.1, 0.1)])
    arm = asset.link("arm").colliders[0]
    colliders = {"base": asset.link("base").colliders, "arm": (replace(arm, convex=Convex.hull(corners)),)}
    wide = replace_colliders(asset, colliders, "hull")
    certificate = wide.certify()
    (pair,) = certificate.pairs
    assert (pair.verdict, pair.colliders) == ("proven", "collision")
    assert recheck(wide, certificate) == []
    false = replace(certificate, pairs=(replace(pair, colliders="proven", witness=None),))
    assert [finding.message for finding in recheck(wide, false)] == ["there is no proof of this pair"]


@pytest.mark.parametrize(("kind", "value", "turns"), [("above", -4.0, -1), ("below", 3.2, 1)])
def test_a_contact_within_one_turn_is_not_allowed_in_the_next(kind: Any, value: float, turns: int) -> None:
    when = Condition(kind, "spin", value)
    pad = AllowedContact(("base", "arm"), ("body", "body"), 0.04, "a pad", when)
    arm = link("arm", body=block((0.05, -0.05, -0.05), (0.28, 0.05, 0.05)))
    asset = joined(link("base", body=cube(0.3)), (joint("spin", "revolute", Z, None), arm), contact=pad)
    assert overlaps(asset, [{"spin": 2.0 * math.pi * turns}])
    assert asset.certify().pairs[0].verdict == "collision"


def test_axes_that_are_not_quite_parallel_are_not_one_axis() -> None:
    tilt, reach, radius = 1.3e-6, 30.0, 0.3 * math.sqrt(2.0)
    arm = link("arm", body=block((-0.3, -0.3, -reach - 0.1), (0.3, 0.3, -reach)))
    base = link("base", body=block((radius + 2e-5, -0.5, -0.5), (1.0, 0.5, 0.05)))
    ways = (
        joint("first", "revolute", Z, (0.0, 1e-5)),
        joint("slide", "prismatic", np.array([math.sin(tilt), 0.0, math.cos(tilt)]), (0.0, reach)),
        joint("turn", "revolute", Z, (-4.0, 4.0)),
    )
    asset = joined(base, (ways, arm))
    assert overlaps(asset, [{"slide": reach, "turn": math.pi / 4.0}])
    assert asset.certify().pairs[0].verdict == "collision"


def test_dependencies_that_contradict_each_other_are_named() -> None:
    first = Dependency(Condition("above", "d", 0.8))
    second = Dependency(Condition("below", "d", 0.5))
    asset = joined(
        link("base", body=cube(0.0)),
        (joint("d", "prismatic", X, (0.0, 1.0)), link("door", body=cube(3.0))),
        (joint("b", "prismatic", Y, (0.2, 0.5), needs=first), link("b", body=cube(1.0))),
        (joint("c", "prismatic", Y, (0.2, 0.5), needs=second), link("c", body=cube(2.0))),
    )
    for measure in (False, True):
        with pytest.raises(AssetError, match="contradict each other"):
            asset.certify(measure=measure)


def test_safe_limits_of_a_joint_that_another_one_needs() -> None:
    door = link("door", body=block((0.06, -0.5, -0.1), (0.1, 0.5, 0.1)))
    needs = Dependency(Condition("above", "door", 1.0))
    asset = joined(
        link("base", body=union(cube(0.0), cube(0.0, 0.0, -2.0))),
        (joint("door", "revolute", Z, (0.0, 1.5), pivot=np.array([0.08, -0.5, 0.0])), door),
        (joint("rack", "prismatic", -X, (0.0, 0.3), needs=needs), link("rack", body=cube(-0.2))),
    )
    limits = asset.safe_limits()
    assert limits["rack"] == (0.0, 0.3)
    low, high = limits["door"]
    assert low == 0.0
    assert 0.01 < high < 0.03
    assert not overlaps(asset, [{"door": high}])
    assert overlaps(asset, [{"door": high + 0.01}])


def test_safe_limits_of_an_unlimited_joint_know_what_follows_it() -> None:
    asset = joined(
        link("base", body=union(cube(0.0, 0.0, -1.0), cube(-0.2))),
        (joint("spin", "revolute", Z, None), link("knob", body=cube(0.0, 0.0, 1.0))),
        (
            joint("lid", "revolute", Z, None, follows=Coupling("spin", 1.5)),
            link("lid", body=block((0.06, -0.05, -0.05), (0.3, 0.05, 0.05))),
        ),
    )
    low, high = asset.safe_limits()["spin"]
    assert overlaps(asset, [{"spin": math.pi / 1.5}])
    assert 1.0 < high < math.pi / 1.5
    assert not overlaps(asset, [{"spin": high}, {"spin": low}])


def test_thin_contacts_on_two_sides_are_each_as_thick_as_they_are() -> None:
    grip = union(
        block((-0.05, 0.0, 0.0), (0.001, 0.1, 0.1)),
        block((0.099, 0.0, 0.0), (0.15, 0.1, 0.1)),
        block((-0.05, 0.0, 0.0), (-0.03, 0.2, 0.1)),
        block((0.13, 0.0, 0.0), (0.15, 0.2, 0.1)),
        block((-0.05, 0.15, 0.0), (0.15, 0.2, 0.1)),
    )
    pads = AllowedContact(("base", "clip"), ("body", "body"), 0.0012, "a clip")
    asset = joined(
        link("base", body=block((0.0, 0.0, 0.0), (0.1, 0.1, 0.1))),
        (joint("s", "prismatic", Z, (0.0, 0.02)), link("clip", body=grip)),
        contact=pads,
    )
    assert not overlaps(asset, [{"s": 0.0}])
    assert asset.certify().pairs[0].verdict == "proven"
    assert asset.clearance()["base", "clip"] >= 0.0


def test_a_bound_does_not_depend_on_what_else_is_bounded() -> None:
    draw = np.random.default_rng(5)
    points, half = draw.normal(size=(2, 6, 3)), np.array([1.1, 2.0])
    axis = np.array([Z, X])
    both = Motion("revolute", np.zeros((2, 3)), axis, np.zeros(2), half)
    alone = Motion("revolute", np.zeros((1, 3)), axis[:1], np.zeros(1), half[:1])
    normals = draw.normal(size=(1, 9, 3))
    reach = [
        np.matmul(enclosing_points(motion, points[: len(motion.half)])[:1], normals.transpose(0, 2, 1)).max(
            axis=1
        )
        for motion in (both, alone)
    ]
    np.testing.assert_array_equal(*reach)
