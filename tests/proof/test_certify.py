"""The certificate on assets whose clearances and collisions are known by construction."""

import functools
import math
import operator
import re
import time
from collections.abc import Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import artgen
from artgen import (
    Body,
    Prismatic,
    Revolute,
    X,
    Y,
    Z,
    box,
    cylinder,
    hull,
    material,
    part,
    union,
    vector,
    weld,
)
from artgen.asset import Asset
from artgen.asset.certificate import Certificate, PairResult
from artgen.asset.collision import with_colliders
from artgen.catalog import find
from artgen.errors import AssetError
from artgen.proof import certify as proof
from artgen.proof.certify import certify
from artgen.proof.kinematics import JointTable, ProofCells, starting_cells
from artgen.proof.paths import Space
from artgen.proof.recheck import recheck
from artgen.proof.search import Search
from support.proof_fridges import evaluated

STEEL = material("stainless")
REACH = 0.30  # of the drawer [m]


def chest(*, gap: float = 0.002, block: float | None = None, **joint: object) -> Asset:
    """A drawer in an open box; `block` stands in its way, that far in front of it."""
    outer = box(0.5, 0.4, 0.3).at(z=0.15)
    body: Body = part(outer - box(0.46, 0.4, 0.26).at(0, -0.02, 0.15), "body", STEEL)
    if block is not None:
        body = weld(body, part(box(0.02, 0.02, 0.1).at(0, -0.20 - block - 0.01, 0.15), "stop", STEEL))
    drawer = part(box(0.46 - 2 * gap, 0.36, 0.26 - 2 * gap).at(0, -0.02, 0.15), "drawer", STEEL)
    slide = Prismatic("slide", axis=-Y, limits=(0, REACH), **joint)
    return evaluated(body.attach(drawer, slide), "chest")


def only(certificate: Certificate) -> PairResult:
    (pair,) = certificate.pairs
    return pair


@pytest.mark.parametrize("gap", [0.0001, 0.0005, 0.002, 0.006])
def test_the_measured_clearance_brackets_the_known_one(gap: float) -> None:
    pair = only(certify(chest(gap=gap), measure=True))
    assert pair.clear
    assert pair.guaranteed is not None
    assert pair.found is not None
    assert 0.8 * gap - 1e-5 <= pair.guaranteed <= gap
    assert pair.found == pytest.approx(gap, rel=1e-3)
    assert str(pair).startswith("body and drawer: proven apart, at least ")


END = 0.020000006  # rounded it would be beyond itself


def grazing(depth: float) -> PairResult:
    """What is said of two blocks that slide towards each other and overlap at both ends of range only."""
    body: Body = part(box(0.3, 0.05, 0.02).at(z=-0.1), "body", STEEL)
    for name, side in (("left", -1.0), ("right", 1.0)):
        block = part(box(0.05, 0.05, 0.05).at(side * (0.025 + END - depth / 2.0)), name, STEEL)
        body = body.attach(block, Prismatic(f"{name}_slide", axis=(-side, 0.0, 0.0), limits=(0.0, END)))
    (pair,) = (each for each in evaluated(body, "vice").certify().pairs if "body" not in each.links)
    return pair


@pytest.mark.parametrize("depth", [1.5e-5, 3e-5, 1e-4, 2e-4, 3e-4, 1e-3])
def test_pieces_that_graze_each_other_in_a_corner_of_joint_space_collide(depth: float) -> None:
    pair = grazing(depth)
    assert (pair.verdict, pair.colliders) == ("collision", "collision")
    assert pair.witness is not None
    assert 0.0 < pair.witness.depth <= depth + 1e-9
    assert all(0.0 <= position <= END for position in pair.witness.pose.values())


@pytest.mark.parametrize("gap", [5e-6, 3e-5])
def test_pieces_that_just_miss_each_other_do_not_collide(gap: float) -> None:
    assert grazing(-gap).witness is None


def test_a_clearance_below_the_tolerance_is_not_proven() -> None:
    asset = chest(gap=0.001)
    assert certify(asset, 0.0009).proven
    certificate = certify(asset, 0.0011)
    pair = only(certificate)
    assert (pair.verdict, pair.colliders, pair.witness) == ("not proven", "not proven", None)
    assert not certificate.proven
    assert certificate.failures == (pair,)
    cell = pair.open_cells[0]
    assert cell.labels == ("body", "drawer")
    assert cell.distance == pytest.approx(0.001, abs=1e-6)
    assert 0.0 < pair.open_fraction <= 1.0
    assert "body and drawer: not proven in " in str(certificate)


def test_a_collision_has_a_witness_and_the_first_contact() -> None:
    certificate = certify(chest(block=0.1))
    pair = only(certificate)
    witness = pair.witness
    assert witness is not None
    assert (pair.verdict, pair.colliders) == ("collision", "collision")
    assert witness.labels == ("stop", "drawer")
    assert witness.pose["slide"] > 0.1
    assert witness.first_contact["slide"] == pytest.approx(0.1, abs=1e-4)
    assert witness.volume == pytest.approx(0.02 * min(witness.pose["slide"] - 0.1, 0.02) * 0.1, rel=1e-3)
    assert 0.0 < witness.depth <= 0.2
    x, y, z = witness.place
    assert abs(x) < 1e-6
    assert -0.32 <= y <= -0.3
    assert z == pytest.approx(0.15, abs=1e-6)
    assert "body and drawer collide at slide=" in str(certificate)
    assert "stop presses" in str(certificate)


def test_parts_that_overlap_at_rest_touch_first_at_rest() -> None:
    witness = only(certify(chest(block=-0.005))).witness
    assert witness is not None
    assert witness.first_contact == {"slide": 0.0}


def test_parts_that_touch_are_not_proven() -> None:
    pair = only(certify(chest(gap=0.0)))
    assert pair.verdict == "not proven"
    assert pair.open_cells[0].distance == 0.0


def test_colliders_that_collide_where_solids_do_not_are_called_so() -> None:
    asset = with_colliders(chest(), "hull")
    certificate = certify(asset)
    pair = only(certificate)
    assert (pair.verdict, pair.colliders) == ("proven", "collision")
    assert not certificate.proven
    assert pair.witness is not None
    assert "body and drawer collide in their colliders only at slide=" in str(certificate)


def test_colliders_that_hit_each_other_on_the_way_have_a_first_contact() -> None:
    body = part(box(0.1, 0.5, 0.02).at(0, 0, -0.05), "body", STEEL)
    arch = box(0.1, 0.02, 0.12).at(0, -0.2, 0.02) - box(0.06, 0.1, 0.2).at(0, -0.2, -0.04)
    rod = part(box(0.02, 0.1, 0.02).at(0, 0.1, 0.02), "rod", STEEL)
    slide = Prismatic("slide", axis=-Y, limits=(0, 0.4))
    asset = evaluated(weld(body, part(arch, "arch", STEEL)).attach(rod, slide), "gate")
    pair = only(certify(with_colliders(asset, "hull")))
    assert (pair.verdict, pair.colliders) == ("proven", "collision")
    assert pair.witness is not None
    # the rod begins 50 mm from the middle, the hull of the arch ends 190 mm beyond it
    assert pair.witness.first_contact["slide"] == pytest.approx(0.24, abs=1e-4)


def test_a_tolerance_that_cannot_be_met_is_refuted_soon() -> None:
    asset = find("door").generate(7, certify=False)
    certificate = asset.certify(0.05)
    assert not certificate.proven
    assert all(pair.witness is None for pair in certificate.pairs)
    assert str(certificate).startswith("not proven with 50.000 mm to spare: ")
    cells = [cell for pair in certificate.failures for cell in pair.open_cells]
    assert cells
    for cell in cells:
        assert 0.0 <= cell.distance < 0.0501
        for name, (low, high) in cell.region.items():
            limits = asset.joint(name).limits
            assert limits is not None
            assert limits[0] <= low <= high <= limits[1]


def test_colliders_that_do_not_contain_the_solids_prove_nothing_of_them() -> None:
    asset = chest(block=0.1)
    body = asset.link("body")
    kept = tuple(collider for collider in body.colliders if collider.label != "stop")
    thinner = replace(body)
    vars(thinner)["colliders"] = kept
    pair = only(certify(replace(asset, links=(thinner, asset.link("drawer")))))
    assert (pair.verdict, pair.colliders) == ("collision", "proven")


def test_dependencies_cut_the_space_and_until_ends_them() -> None:
    def gate(needs: object) -> Asset:
        post = part(box(0.05, 0.05, 0.5).at(0, 0, 0.25), "post", STEEL)
        bar = part(box(0.04, 0.2, 0.04).at(0.06, -0.1, 0.3), "bar", STEEL)
        stop = part(box(0.04, 0.04, 0.04).at(0.06, -0.25, 0.3), "stop", STEEL)
        lift = Prismatic("lift", axis=Z, limits=(0, 0.1))
        push = Prismatic("push", axis=-Y, limits=(0, 0.2), needs=needs(lift) if needs else None)  # type: ignore[operator]
        return evaluated(post.attach(stop, lift).attach(bar, push), "gate")

    def verdict(asset: Asset) -> str:
        (pair,) = (pair for pair in certify(asset).pairs if set(pair.links) == {"stop", "bar"})
        return pair.verdict

    assert verdict(gate(None)) == "collision"
    assert verdict(gate(lambda lift: lift > 0.05)) == "proven"
    assert verdict(gate(lambda lift: lift > 0.03)) == "collision"  # the bar is 40 mm high
    # beyond `until` the bar may stand in the stop's place
    assert verdict(gate(lambda lift: (lift > 0.05).until(0.1))) == "collision"
    assert verdict(gate(lambda lift: (lift > 0.05) | (lift < -1))) == "proven"
    assert verdict(gate(lambda lift: (lift > 0.05) & (lift < 0.09))) == "proven"


def test_a_coupled_joint_moves_with_its_leader() -> None:
    def lid(ratio: float) -> Asset:
        body = part(box(0.3, 0.3, 0.3).at(z=0.15), "body", STEEL)
        pedal = part(box(0.05, 0.1, 0.01).at(0.3, 0, 0.05), "pedal", STEEL)
        arm = part(box(0.05, 0.1, 0.01).at(0.3, 0, 0.12), "arm", STEEL)
        press = Prismatic("press", axis=Z, limits=(0, 0.1))
        raised = Prismatic("raise", axis=Z, follows=ratio * press)
        return evaluated(body.attach(pedal, press).attach(arm, raised), "lid")

    assert certify(lid(1.0)).proven
    assert certify(lid(0.5)).proven  # 60 mm apart at rest, 10 mm at the end
    failed = certify(lid(0.3)).failures
    assert [set(pair.links) for pair in failed] == [{"pedal", "arm"}]
    assert failed[0].joints == ("press",)
    witness = failed[0].witness
    assert witness is not None
    assert witness.first_contact["press"] == pytest.approx(0.06 / 0.7, abs=1e-4)


def test_an_unlimited_joint_is_proven_over_a_full_turn() -> None:
    def dial(post: float) -> Asset:
        plate = part(box(0.2, 0.2, 0.01).at(z=0.005), "plate", STEEL)
        pin = part(cylinder(0.004, 0.03).at(post, 0, 0.025), "pin", STEEL)
        pointer = part(box(0.06, 0.01, 0.01).at(0.02, 0, 0.02), "dial", STEEL)
        return evaluated(weld(plate, pin).attach(pointer, Revolute("turn", axis=Z)), "dial")

    assert certify(dial(-0.06)).proven
    pair = only(certify(dial(-0.04)))
    assert pair.verdict == "collision"
    assert pair.witness is not None
    assert abs(pair.witness.pose["turn"]) > 2.9


@pytest.mark.parametrize("order", ["knob first", "post first"])
def test_a_slide_along_the_axis_of_a_turn_is_seen_from_both_sides(order: str) -> None:
    def column(travel: float) -> Asset:
        base = part(box(0.2, 0.2, 0.01).at(z=-0.2), "base", STEEL)
        knob = part(cylinder(0.02, 0.02), "knob", STEEL)
        post = part(cylinder(0.02, 0.02).at(z=0.05), "post", STEEL)
        turn, slide = Revolute("turn", axis=Z), Prismatic("slide", axis=-Z, limits=(0, travel))
        spin = Revolute("spin", axis=Z)
        if order == "knob first":
            return evaluated(base.attach(knob, turn).attach(post, slide, spin), "column")
        return evaluated(base.attach(post, slide, spin).attach(knob, turn), "column")

    def pair_of(asset: Asset) -> PairResult:
        (pair,) = (each for each in certify(asset, measure=True).pairs if set(each.links) == {"knob", "post"})
        return pair

    pair = pair_of(column(0.028))  # 30 mm apart at rest
    assert pair.clear
    assert pair.guaranteed is not None
    assert 0.0015 <= pair.guaranteed <= 0.002
    assert pair_of(column(0.031)).verdict == "collision"


def test_a_shaft_in_its_bore_is_proven_with_all_of_its_play() -> None:
    block = part(box(0.04, 0.04, 0.04) - cylinder(0.0052, 0.1), "block", STEEL)
    shaft = part(union(cylinder(0.005, 0.06), box(0.03, 0.004, 0.004).at(0, 0, 0.028)), "shaft", STEEL)
    asset = evaluated(block.attach(shaft, Revolute("turn", axis=Z)), "bearing")
    pair = only(certify(asset, measure=True))
    assert pair.clear
    assert pair.guaranteed is not None
    assert 5e-5 <= pair.guaranteed <= 0.0002  # less the facets of colliders, which are outside the block


@pytest.mark.parametrize("gap", [0.0005, 0.002, 0.003, 0.0043])
def test_measuring_proves_what_is_proven_where_fcl_takes_other_points_for_the_nearest(gap: float) -> None:
    """FCL finds 3 mm between two leaning bars that are closer: no plane is as far from both."""
    base = part(box(0.02, 0.4, 0.01).at(0.02, 0, -0.01), "base", STEEL)
    for sign, name in ((-1, "front"), (1, "back")):
        disc, low = cylinder(0.006, 0.003, axis=X), vector(0, sign * (0.1 + gap / 2), 0)
        leaning = hull(disc.at(low), disc.at(0, sign * (gap / 2 + 0.006), 0.112))
        turn = Revolute(f"turn_{name}", axis=-sign * X, pivot=low, limits=(0, 1.0))
        base = base.attach(part(leaning, "bar", STEEL, name=f"bar_{name}"), turn)
    asset = evaluated(base, "bars")
    pairs = {}
    for measure in (False, True):
        found = certify(asset, measure=measure).pairs
        (pairs[measure],) = (each for each in found if set(each.links) == {"bar_front", "bar_back"})
    assert pairs[False].clear
    assert pairs[True].clear, pairs[True]
    assert pairs[True].found == pytest.approx(gap, rel=1e-3)
    assert 0.8 * gap - 1e-4 <= pairs[True].guaranteed <= gap


def test_a_contact_by_design_holds_for_its_pieces_its_depth_and_its_range() -> None:
    def sealed(
        depth: float, upto: float | None, *, declared: bool = True, swollen: float = 0.0
    ) -> Certificate:
        body = part(box(0.4, 0.02, 0.4).at(0, 0.01, 0.2), "body", STEEL)
        leaf = part(box(0.4, 0.02, 0.4).at(0, -0.014, 0.2), "leaf", STEEL)
        seal = part(box(0.38, 0.006 + swollen, 0.38).at(0, -0.002 + swollen / 2, 0.2), "seal", STEEL)
        hinge = Revolute("hinge", axis=-Z, pivot=(-0.21, -0.03, 0), limits=(0, 1.5))
        whole = body.attach(weld(leaf, seal), hinge)
        if declared:
            when = None if upto is None else hinge < upto
            whole = whole.allow_contact("seal", "body", depth=depth, when=when, reason="it seals")
        return certify(evaluated(whole, "door"))

    allowed = sealed(0.0012, 0.05)  # it presses 1 mm into the body when closed
    assert allowed.proven
    assert [str(contact) for contact in allowed.contacts] == [
        "leaf/seal may press 1.2 mm into body/body where hinge < 0.05: it seals"
    ]
    assert sealed(0.0012, None).proven
    assert only(sealed(0.0005, 0.05)).verdict == "collision"  # deeper than declared
    assert only(sealed(0.0012, 0.0005)).verdict == "collision"  # longer than declared
    assert only(sealed(0.0012, 0.05, declared=False)).verdict == "collision"
    assert only(sealed(0.0012, 0.05, swollen=0.001)).verdict == "collision"


def test_an_allowed_contact_of_pieces_with_one_middle_is_no_more_than_that() -> None:
    block = part(box(0.1, 0.1, 0.1), "block", STEEL)
    core = part(box(0.02, 0.02, 0.02), "core", STEEL)  # all of it in the middle of the block
    body = block.attach(core, Revolute("turn", axis=Z, limits=(-1, 1)))
    body = body.allow_contact("core", "block", depth=0.001, reason="it is pressed in")
    assert only(certify(evaluated(body, "block"))).verdict == "collision"


def test_two_pieces_that_may_touch_everywhere_have_no_clearance() -> None:
    rail = part(box(0.02, 0.5, 0.02), "rail", STEEL)
    runner = part(box(0.02, 0.1, 0.02).at(0, -0.2, 0.02), "runner", STEEL)
    slide = Prismatic("slide", axis=Y, limits=(0, 0.4))
    body = rail.attach(runner, slide).allow_contact("runner", "rail", depth=0.0, reason="it slides on it")
    certificate = certify(evaluated(body, "rail"))
    pair = only(certificate)
    assert pair.clear
    assert pair.guaranteed is None
    assert certificate.clearance is None
    assert str(pair) == "rail and runner: proven to touch only as their allowed contacts permit"


@pytest.mark.parametrize("tolerance", [-0.001, 0.2, math.nan, math.inf, True, "0.001", None])
def test_a_tolerance_that_is_no_length_is_refused(tolerance: float) -> None:
    with pytest.raises(
        artgen.errors.AssetError, match=r"tolerance must be a length of 0 to 0\.1 m \(metres, not mm\), got "
    ):
        chest().certify(tolerance)


def test_wrong_use_is_one_clear_error() -> None:
    asset = chest()
    with pytest.raises(
        artgen.errors.AssetError, match=r"asset 'chest' has no links; there is nothing to certify"
    ):
        replace(asset, links=(), joints=()).certify()
    tiny = replace(asset, joints=(replace(asset.joints[0], limits=(0.0, 1e-9)),))
    with pytest.raises(
        artgen.errors.AssetError, match=r"joint 'slide' has a range of 1e-09 .* equal limits to lock it"
    ):
        tiny.certify()
    locked = replace(asset, joints=(replace(asset.joints[0], limits=(0.0, 0.0)),))
    assert str(locked.certify()) == "nothing moves: there is nothing to prove"


def test_a_reversed_dependency_is_refused_with_its_numbers() -> None:
    body = part(box(0.5, 0.4, 0.3), "body", STEEL)
    door = part(box(0.5, 0.02, 0.3).at(0, -0.22), "door", STEEL)
    rack = part(box(0.1, 0.1, 0.1).at(0, 0.3), "rack", STEEL)
    hinge = Revolute("hinge", axis=X, pivot=(0, -0.23, -0.15), limits=(0, 1.5))
    slide = Prismatic("slide", axis=Y, limits=(0, 0.2), needs=hinge < -0.5)
    asset = evaluated(body.attach(door, hinge).attach(rack, slide), "oven")
    message = (
        r"joint 'slide' needs hinge < -0.5, but hinge ranges from 0 to 1.5: it could never move; reverse the "
        r"comparison or correct its value"
    )
    with pytest.raises(artgen.errors.AssetError, match=message):
        asset.certify()


def test_the_certificate_stays_with_the_asset_but_not_with_one_made_of_it() -> None:
    asset = chest()
    assert asset.certificate is None
    certificate = asset.certify()
    assert asset.certificate is certificate
    assert asset.with_base("free").certificate is certificate
    assert replace(asset, name="other").certificate is None
    assert Certificate.from_data(certificate.to_data()) == certificate


def test_the_same_asset_gives_the_same_proof() -> None:
    first, second = (chest(block=0.4).certify() for _ in range(2))
    assert first == second
    assert first.leaves == second.leaves


def test_clearance_is_the_distance_at_one_pose() -> None:
    asset = chest(gap=0.002, block=0.1)
    assert asset.clearance()["body", "drawer"] == pytest.approx(0.002, abs=1e-9)
    assert asset.clearance({"slide": 0.0995})["body", "drawer"] == pytest.approx(0.0005, abs=1e-9)
    assert asset.clearance({"slide": 0.11})["body", "drawer"] == pytest.approx(-np.cbrt(0.02 * 0.01 * 0.1))
    with pytest.raises(
        artgen.errors.AssetError, match=r"joint 'slide' cannot be at 1; its limits are 0 to 0\.3"
    ):
        asset.clearance({"slide": 1.0})


def test_safe_limits_end_where_a_collision_begins() -> None:
    low, high = chest(block=0.1).safe_limits()["slide"]
    assert low == 0.0
    assert 0.1 - REACH / 512 - 1e-4 <= high < 0.1
    assert chest().safe_limits() == {"slide": (0.0, REACH)}
    assert chest(block=-0.005).safe_limits() == {"slide": (0.0, 0.0)}


def chain(joints: int) -> Asset:
    """Small links in a row, on hinges that turn almost fully."""
    last: Body = part(box(0.02, 0.02, 0.02).at(joints * 0.1), f"link_{joints}", STEEL)
    for number in reversed(range(joints)):
        link = part(box(0.02, 0.02, 0.02).at(number * 0.1), f"link_{number}", STEEL)
        hinge = Revolute(f"hinge_{number}", axis=Z, pivot=(number * 0.1, 0.0, 0.0), limits=(-3.1, 3.1))
        last = link.attach(last, hinge)
    return evaluated(last, "chain")


@pytest.mark.parametrize("joints", [3, 5, 14])
def test_the_first_cells_hold_the_whole_joint_space_and_stay_few(joints: int) -> None:
    (path,) = (
        each for each in Space(chain(joints)).joint_paths() if set(each.links) == {"link_0", f"link_{joints}"}
    )
    cells = starting_cells(path)
    assert len(cells) == (4 ** min(joints, 6))  # four parts of at most 1.6 rad
    volume = sum(float(np.prod(cell[:, 1] - cell[:, 0])) for _, cell in cells)
    assert volume == pytest.approx(6.2**joints, rel=1e-6)
    assert min(cell[:, 0].min() for _, cell in cells) <= -3.1


def test_the_time_limit_holds_for_a_long_chain() -> None:
    start = time.monotonic()
    certificate = certify(chain(14), seconds=0.5, only=lambda path: "link_14" in path.links)
    assert time.monotonic() - start < 30.0
    assert {pair.verdict for pair in certificate.pairs} <= {"proven", "collision", "not proven"}


def fenced_arms(gaps: Sequence[float]) -> Asset:
    """Arms of two hinges, each in a ring of blocks that it misses by a gap [m]."""
    fences, arms = [], []
    for number, gap in enumerate(gaps):
        y, inner = 2.0 * number, 0.1 + math.hypot(0.11, 0.01) + gap
        block = box(0.02, 2.0 * (inner + 0.02) * math.tan(math.pi / 24.0), 0.02).at(inner + 0.01, 0.0, 0.0)
        fences += [block.rotate(Z, turn * math.pi / 12.0).at(0.0, y, 0.0) for turn in range(24)]
        upper = part(box(0.1, 0.02, 0.02).at(0.05, y, 0.0), f"upper_{number}", STEEL)
        lower = part(box(0.11, 0.02, 0.02).at(0.155, y, 0.0), f"lower_{number}", STEEL)
        elbow = Revolute(f"elbow_{number}", axis=Z, pivot=(0.1, y, 0.0), limits=(-1.0, 1.0))
        shoulder = Revolute(f"shoulder_{number}", axis=Z, pivot=(0.0, y, 0.0), limits=(-3.1, 3.1))
        arms.append((upper.attach(lower, elbow), shoulder))
    body = part(functools.reduce(operator.or_, fences), "fence", STEEL)
    for arm, shoulder in arms:
        body = body.attach(arm, shoulder)
    return evaluated(body, "fenced")


def test_a_pair_that_takes_too_long_leaves_time_for_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """Time is counted in cells: 1 ms each. Without a share of its own, the easy pair is not proven either."""
    cells, examine = [0], Search._examine

    def counted(self: Search, some: ProofCells, table: JointTable) -> list[ProofCells]:
        cells[0] += len(some)
        return examine(self, some, table)

    monkeypatch.setattr(Search, "_examine", counted)
    monkeypatch.setattr("artgen.proof.search.time", SimpleNamespace(monotonic=lambda: cells[0] / 1000.0))
    asset = fenced_arms([2e-3, 6e-5])

    def proven(seconds: float) -> dict[str, PairResult]:
        cells[0] = 0
        wanted = [("fence", "lower_0"), ("fence", "lower_1")]
        found = certify(asset, seconds=seconds, only=lambda path: path.links in wanted)
        return {pair.links[1]: pair for pair in found.pairs}

    assert all(pair.clear for pair in proven(100.0).values())
    easy, hard = proven(3.0).values()
    assert easy.clear
    assert (hard.links, hard.verdict) == (("fence", "lower_1"), "not proven")
    message = r"fence and lower_1: not proven after [0-9.]+ s: fence and lower_1, with shoulder_1 in"
    assert re.match(message, str(hard))


def test_colliders_leave_half_of_the_time_for_finer_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    searched, limits = proof._searched, []

    def search(*arguments: Any, seconds: float, **options: Any) -> Any:
        limits.append(seconds)
        return searched(*arguments, seconds=seconds, **options)

    monkeypatch.setattr(proof, "_searched", search)
    assert certify(chest(), seconds=60.0).proven
    assert limits[0] == 30.0 < limits[1] <= 60.0


def test_an_overlap_is_permitted_by_name_only() -> None:
    pressed = chest(block=-0.000005)
    with pytest.raises(AssetError, match="tolerance must be a length of 0 to"):
        certify(pressed, tolerance=-0.000008)
    with pytest.raises(AssetError, match=r"overlap must be a length of 0 to 1e-05 m, got 0\.001"):
        certify(pressed, overlap=0.001)
    certificate = certify(pressed, overlap=0.00001)
    assert certificate.tolerance == -0.00001
    assert recheck(pressed, certificate, overlap=0.00001) == []
    (fault,) = recheck(pressed, certificate)
    assert "its tolerance is -1e-05 m" in str(fault)
