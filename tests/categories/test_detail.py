"""Levels of detail: every category at low detail, and the rules of the levels on small parts."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from manifold3d import CrossSection, FillRule
from scipy.spatial import cKDTree

import artgen as ag
from artgen import Body, Float, uniform
from artgen.asset import Asset
from artgen.asset.tree import Reduction
from artgen.catalog import categories, find
from artgen.dataset.run import record_of
from artgen.errors import ParameterError
from artgen.export.files import encode
from artgen.graph import DETAILS, Cache, Graph
from artgen.validate import validate
from artgen.validate.colliders import check_colliders, fidelity
from support.cases import some

MOST = 2800
"""Triangles of any asset of low detail; only those of `LARGE` may have more than 2,000."""

LARGE = {"dishwasher", "refrigerator"}

SLENDER = {"pen"}
"""Categories of round parts 8 to 15 mm thick: 8 facets take up to 13 % of their mass; others lose 5 %."""


def triangles(asset: Asset) -> int:
    return sum(len(surface.mesh.triangles) for link in asset.links for surface in link.surfaces)


@pytest.mark.parametrize("category", some(categories(), 6))
def test_low_detail_changes_the_solids_alone(category: str) -> None:
    cache = Cache(100_000)
    low, _ = find(category).evaluate(0, detail="low", cache=cache)
    full, _ = find(category).evaluate(0, certify=False, cache=cache)
    assert low.certificate is not None
    assert low.certificate.proven
    assert triangles(low) <= (MOST if category in LARGE else 2000)
    assert low.parameters == full.parameters
    assert [joint.to_data() for joint in low.joints] == [joint.to_data() for joint in full.joints]
    assert [link.name for link in low.links] == [link.name for link in full.links]
    for link, exact in zip(low.links, full.links, strict=True):
        for held, wanted in zip((*link.grasps, *link.pushes), (*exact.grasps, *exact.pushes), strict=True):
            assert held.name == wanted.name
            assert np.array_equal(held.frame, wanted.frame)
            assert getattr(held, "width", 0.0) == pytest.approx(getattr(wanted, "width", 0.0), abs=0.003)
    assert low.mass == pytest.approx(full.mass, rel=0.14 if category in SLENDER else 0.05)


@ag.generator
def block(*, width: Float = uniform(0.1, 0.2, "m")) -> Body:
    solid = ag.box(width, 0.08, 0.05, bevel=0.004) | ag.cylinder(0.03, 0.1, bevel=0.001)
    body = ag.part(solid, "block", ag.material("abs"))
    ink = ag.details.printed(ag.text("Artgen", 0.01), (0, -0.04, 0), material=ag.material("steel"))
    return ag.weld(body, ink)


def outline(asset: Asset, right: np.ndarray, up: np.ndarray) -> np.ndarray:
    """Return points of the outline of an asset in a view, at most 0.2 mm apart, shape (n, 2) [m]."""
    corners = np.concatenate([each.mesh.vertices[each.mesh.triangles] for each in asset.links[0].surfaces])
    flat = np.stack([corners @ right, corners @ up], axis=-1)
    a, b = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    flat[area < 0.0] = flat[area < 0.0, ::-1]
    region = CrossSection(list(flat[np.abs(area) > 1e-12]), FillRule.Positive)
    points = []
    for polygon in map(np.asarray, region.to_polygons()):
        for start, end in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
            steps = max(1, int(np.ceil(np.linalg.norm(end - start) / 2e-4)))
            points.append(start + (end - start) * np.linspace(0.0, 1.0, steps, endpoint=False)[:, None])
    return np.concatenate(points)


@pytest.mark.parametrize("detail", ["medium", "low"])
@pytest.mark.parametrize("category", some(categories(), 8))
def test_colliders_contain_and_follow_the_solids_of_a_level(category: str, detail: Any) -> None:
    assert not check_colliders(find(category).generate(1, detail=detail, certify=False)).faults


def test_the_outline_of_low_detail_is_within_a_millimetre() -> None:
    low, full = block.generate(1, detail="low"), block.generate(1)
    assert triangles(low) < triangles(full) / 8
    for right, up in ((0, 2), (1, 2), (0, 1)):
        views = [cKDTree(outline(each, np.eye(3)[right], np.eye(3)[up])) for each in (low, full)]
        for one, other in (views, views[::-1]):
            assert other.query(one.data)[0].max() < 0.001


def test_print_is_built_at_full_and_medium_detail_only() -> None:
    labels = {name: block.generate(1, detail=name).links[0].labels for name in ("full", "medium", "low")}
    assert labels["full"] == labels["medium"] == ("block", "print")
    assert labels["low"] == ("block",)


def test_one_cache_keeps_the_levels_apart() -> None:
    cache = Cache()
    before = encode(block.evaluate(2, cache=Cache())[0], ("mjcf",), textures=0)
    block.evaluate(2, cache=cache, detail="low")
    block.evaluate(2, cache=cache, detail="medium")
    assert encode(block.evaluate(2, cache=cache)[0], ("mjcf",), textures=0) == before


def test_measures_are_those_of_full_detail() -> None:
    round_ = ag.cylinder(0.02, 0.1)
    assert Graph(round_.volume()).evaluate(detail=DETAILS["low"]).value == pytest.approx(
        Graph(round_.volume()).evaluate().value
    )
    low, full = (Graph(round_).evaluate(detail=DETAILS[name]).value for name in ("low", "full"))
    assert low.manifold.volume() < 0.97 * full.manifold.volume()


@ag.generator
def tight() -> Body:
    bush = ag.part(ag.box(0.06, 0.06, 0.02) - ag.cylinder(0.0205, 0.03), "bush", ag.material("steel"))
    shaft = ag.part(ag.cylinder(0.02, 0.05), "shaft", ag.material("steel"))
    return bush.attach(shaft, ag.Revolute("turn", axis=ag.Z, limits=(0, 1)))


def test_solids_that_are_too_coarse_for_the_proof_become_finer() -> None:
    # the sides of a coarse hole would reach 0.8 mm inward, and the shaft has a play of 0.5 mm
    asset = tight.generate(0, detail="low", on_collision="fail")
    assert asset.certificate is not None
    assert asset.certificate.proven
    coarse = Graph(tight.build({})).evaluate(detail=DETAILS["low"]).value
    assert asset.links["bush"].pieces[0].shape.manifold.num_tri() > (
        coarse.link.pieces[0].shape.manifold.num_tri()
    )


def test_visual_details_wait_until_they_are_looked_at() -> None:
    plate = ag.part(ag.box(0.06, 0.004, 0.04), "plate", ag.material("abs"))
    stripe = ag.box(0.03, 0.001, 0.01).at(y=-0.0025)
    body = ag.weld(plate, ag.detail(stripe, "stripe", ag.material("copper")))
    full, low = (Graph(body).evaluate(detail=DETAILS[name]) for name in ("full", "low"))
    assert (full.runs["box"], low.runs["box"]) == (2, 1)
    link = low.value.link
    assert np.allclose(link.pieces[1].shape.bounds(), [[-0.015, -0.003, -0.005], [0.015, -0.002, 0.005]])
    assert low.runs["box"] == 2


def test_a_detail_that_fails_when_it_is_coarse_is_made_finer() -> None:
    plate = ag.part(ag.box(0.06, 0.004, 0.04), "plate", ag.material("abs"))
    ring = ag.cylinder(0.02, 0.01) - ag.cylinder(0.0199, 0.02)
    body = ag.weld(
        plate, ag.detail(ring - ag.box(0.0392, 0.0392, 0.1, bevel=0.0), "ring", ag.material("steel"))
    )
    tree = Graph(body).evaluate(detail=DETAILS["low"]).value
    assert tree.link.pieces[1].shape.manifold.volume() > 0.0


def test_a_requirement_of_a_detail_does_not_wait() -> None:
    plate = ag.part(ag.box(0.06, 0.004, 0.04), "plate", ag.material("abs"))
    size = ag.box(0.01, 0.01, 0.01).volume()
    stripe = ag.box(ag.require(size, size > 1.0, "too small"), 0.001, 0.01)
    body = ag.weld(plate, ag.detail(stripe, "stripe", ag.material("copper")))
    with pytest.raises(ag.errors.InfeasibleError, match="too small"):
        Graph(body).evaluate(detail=DETAILS["low"])


def test_an_unknown_level_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"detail = 'tiny' is not allowed.*'full', 'medium', 'low'"):
        block.generate(1, detail="tiny")  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match="detail is full, medium or low, not 'tiny'"):
        ag.dataset.Plan(("drawer",), 1, detail="tiny")  # type: ignore[arg-type]


def test_files_of_low_detail_have_plain_colors_and_name_the_level(tmp_path: Path) -> None:
    plan = ag.dataset.Plan(("drawer",), 1, seed=3, detail="low", formats=("mjcf",))
    files = plan.files(next(plan.items()))
    assert not [path for path in files if path.endswith(".png")]
    assert record_of(files["asset.json"], "drawer/drawer_3")["detail"] == "low"
    for path, content in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_bytes(content)
    asset = Asset.load(tmp_path)
    assert asset.detail == "low"
    assert triangles(asset) <= 2000
    assert "detail" not in find("drawer").generate(3, certify=False).to_data()


@ag.generator
def ball() -> Body:
    return ag.part(ag.sphere(0.05), "ball", ag.material("abs"))


def test_colliders_need_not_follow_solids_of_low_detail_closely() -> None:
    asset = ball.generate(0, detail="low")
    link = asset.links["ball"]
    # the collider is the sphere, more than a millimetre from the middle of a facet
    found = fidelity(link.pieces[0].shape.manifold, [each.convex for each in link.colliders])
    assert found.surface_error > 0.001
    report = validate(asset, checks=("colliders", "grasps"))
    assert not report.faults
    assert "full detail" in {each.check: each.skipped for each in report.results}["grasps"]


@ag.generator
def linked() -> Body:
    """Two blocks that a chain of two rods joins, a thin plate on the second rod, and many small knobs."""
    steel = ag.material("steel")
    blocks = ag.part([ag.box(0.02, 0.02, 0.02), ag.box(0.02, 0.02, 0.02).at(x=0.1)], "block", steel)
    rods = [ag.cylinder_between((x, 0, 0), (x + 0.05, 0, 0), 0.002) for x in (0.005, 0.045)]
    badge = ag.box(0.01, 0.004, 0.0008).at(0.07, 0, 0.002)
    ball = ag.sphere(0.003)
    knobs = [ball.at(x - 0.007 + 0.002 * step, 0, 0.01) for x in (0.0, 0.1) for step in range(8)]
    return ag.weld(
        blocks,
        *(ag.detail(each, label, steel) for each, label in zip(rods, ("near", "far"), strict=True)),
        ag.detail(badge, "badge", steel),
        *(ag.detail(each, "knob", steel) for each in knobs),
    )


def test_details_by_which_solids_hang_together_stay() -> None:
    tree = Graph(linked.build({})).evaluate(detail=DETAILS["low"]).value
    full = {piece.label for piece in tree.link.pieces}
    assert full == {"block", "near", "far", "badge", "knob"}
    counts = {piece.label: len(piece.shape.mesh.triangles) for piece in tree.link.pieces}
    assert tree.solid_triangles() == 2 * counts["block"]
    bare = Reduction(tree, 0.0, 0.001).result
    kept = [piece.label for piece in bare.link.pieces]
    assert kept == ["block", "block", "near", "far"]
    assert [piece.label for piece in bare.link.solids] == ["block", "block"]
    most = sum(counts[label] for label in kept) + 16 * counts["knob"]
    some = Reduction(tree, most).result
    assert "badge" not in {piece.label for piece in some.link.pieces}
    assert [piece.label for piece in some.link.pieces].count("knob") == 16


def test_a_detail_leaves_after_those_that_hang_on_it() -> None:
    steel = ag.material("steel")
    arm = ag.cylinder_between((0, 0, 0.005), (0, 0, 0.06), 0.001)
    sign = ag.box(0.03, 0.03, 0.01).at(z=0.064)
    body = ag.weld(
        ag.part(ag.box(0.02, 0.02, 0.02), "block", steel),
        ag.detail(arm, "arm", steel),
        ag.detail(sign, "sign", steel),
    )
    tree = Graph(body).evaluate(detail=DETAILS["low"]).value
    counts = {piece.label: len(piece.shape.mesh.triangles) for piece in tree.link.pieces}
    total = sum(counts.values())
    for most, kept in ((total, 3), (total - 1, 2), (total - counts["sign"], 2), (counts["block"], 1)):
        labels = [piece.label for piece in Reduction(tree, most).result.link.pieces]
        assert labels == ["block", "arm", "sign"][:kept]
