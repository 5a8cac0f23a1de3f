"""Screws, rivets, vents, seals, feet and racks."""

import math
from itertools import product

import numpy as np
import pytest
from manifold3d import Manifold, OpType

from artgen.errors import EvaluationError
from artgen.graph.evaluation import Cache, evaluate
from artgen.materials import material
from artgen.nodes.contours import is_disjoint, section
from artgen.nodes.details import (
    drive_recess,
    foot,
    gasket,
    perforation,
    relief,
    rivet,
    screw,
    screw_head,
    vent_slots,
    wire_rack,
)
from artgen.nodes.details.seals import gasket_section
from artgen.nodes.profile import circle, rectangle
from support.shapes import check_cover, check_shape, outline_area

DRIVES = ("slot", "phillips", "pozidriv", "hex", "torx")
HEADS = ("pan", "countersunk", "cap")
RNG = np.random.default_rng(7)


def value(handle):
    return evaluate(handle, {}, Cache()).value


def millimetres(outline):
    return [1e3 * contour.points for contour in outline.contours]


@pytest.mark.parametrize(("drive", "head"), list(product(DRIVES, HEADS)))
def test_screw_heads_are_cheap_solids_with_a_recess(drive, head):
    radius = float(RNG.uniform(0.001, 0.006))
    shape = value(screw_head(radius, (0.1, 0.2, 0.3), drive=drive, head=head, turn=0.5))
    check_shape(shape, least_agreement=0.35, covered=False)
    assert len(shape.mesh.triangles) <= 200
    low, high = shape.bounds()
    assert high[1] == pytest.approx(0.2, abs=1e-9), "it sits on the face"
    np.testing.assert_allclose((high - low)[[0, 2]], 2 * radius, rtol=0.06)
    hull = Manifold.hull_points(np.ascontiguousarray(shape.mesh.vertices))
    missing = (hull.volume() - shape.manifold.volume()) / hull.volume()
    assert 0.015 < missing < 0.35, "the recess is cut"


@pytest.mark.parametrize("drive", DRIVES)
def test_recesses_are_symmetric(drive):
    outline = value(drive_recess(0.003, drive))
    region = section([type(c)(1e3 * c.points, c.normals_in, c.normals_out) for c in outline.contours])
    turned = region.rotate(60.0 if drive in ("hex", "torx") else 180.0 if drive == "slot" else 90.0)
    assert (region - turned).area() < 1e-3 * region.area()


def test_a_screw_is_a_head_and_the_dark_of_its_recess():
    head, dark = value(screw(0.004, material=material("steel"))).link.pieces
    assert head.visual
    assert dark.visual
    assert max(dark.material.base_color) < 0.4 * max(head.material.base_color)
    assert -dark.shape.bounds()[0, 1] < -head.shape.bounds()[0, 1], "it lies below the rim"


def test_rivets():
    shape = value(rivet(0.003, (0.0, 0.1, 0.0)))
    check_shape(shape, covered=False)
    low, high = shape.bounds()
    assert high[1] == pytest.approx(0.1, abs=1e-9)
    assert 0.001 < high[1] - low[1] < 0.002


@pytest.mark.parametrize("pattern", ["square", "hex"])
@pytest.mark.parametrize(
    "outline", [circle(0.04), rectangle(0.09, 0.05, radius=0.01), rectangle(0.08, 0.08) - circle(0.02)]
)
def test_holes_keep_their_margin(pattern, outline):
    pitch, radius, margin = 0.005, 0.0015, 0.003
    whole = value(outline)
    punched = value(perforation(outline, pitch, radius, pattern=pattern, margin=margin))
    holes = punched.contours[len(whole.contours) :]
    assert len(holes) > 40
    middles = np.array([hole.points.mean(axis=0) for hole in holes])
    border = np.concatenate(
        [
            np.linspace(start, end, 20)
            for contour in whole.contours
            for start, end in zip(contour.points, np.roll(contour.points, -1, axis=0), strict=True)
        ]
    )
    nearest = np.linalg.norm(middles[:, None] - border, axis=2).min(axis=1)
    assert nearest.min() > radius + margin - 2e-4
    gaps = np.linalg.norm(middles[:, None] - middles, axis=2) + 10.0 * np.eye(len(middles))
    assert gaps.min() == pytest.approx(pitch, rel=1e-6)
    lost = outline_area(whole.contours) - outline_area(punched.contours)
    assert lost == pytest.approx(len(holes) * math.pi * radius**2, rel=0.06)


def test_a_perforation_is_even_and_a_solid_sheet():
    punched = value(perforation(rectangle(0.06, 0.04), 0.004, 0.001))
    middles = np.array([hole.points.mean(axis=0) for hole in punched.contours[1:]])
    low, high = middles.min(axis=0), middles.max(axis=0)
    np.testing.assert_allclose(low[1] + high[1], 0.0, atol=1e-9)
    np.testing.assert_allclose(low[0] + high[0], 0.0, atol=0.0021)
    check_shape(value(relief(perforation(rectangle(0.06, 0.04), 0.004, 0.001))), covered=False)


def test_perforations_that_do_not_work_say_so():
    with pytest.raises(EvaluationError, match=r"about \d+ holes is too fine .* allows 2000; .* texture"):
        value(perforation(rectangle(1.0, 1.0), 0.004, 0.001))
    with pytest.raises(EvaluationError, match="no hole of radius 1 mm fits inside a margin of 30 mm"):
        value(perforation(rectangle(0.05, 0.05), 0.004, 0.001, margin=0.03))
    with pytest.raises(EvaluationError, match="radius must be within"):
        value(perforation(rectangle(0.05, 0.05), 0.004, 0.002))


@pytest.mark.parametrize("direction", ["vertical", "horizontal"])
def test_slots_fill_their_rectangle(direction):
    outline = value(vent_slots(0.1, 0.06, 7, slot=0.002, direction=direction))
    assert len(outline.contours) == 7
    assert is_disjoint(millimetres(outline))
    points = np.concatenate([contour.points for contour in outline.contours])
    np.testing.assert_allclose(np.ptp(points, axis=0), [0.1, 0.06], rtol=0.02)
    np.testing.assert_allclose(points.min(axis=0) + points.max(axis=0), 0.0, atol=1e-9)


def test_too_many_slots_are_refused():
    with pytest.raises(EvaluationError, match="60 slots 2 mm wide do not fit into 100 mm"):
        value(vent_slots(0.1, 0.06, 60))


@pytest.mark.parametrize("kind", ["bulb", "lip", "bulb_lip", "half_round"])
def test_gaskets_lie_on_the_face_and_seal_towards_the_front(kind):
    shape = value(gasket(0.4, 0.6, size=0.012, section=kind))
    check_shape(shape, covered=False)
    low, high = shape.bounds()
    assert high[1] == pytest.approx(0.0, abs=1e-9)
    assert -0.013 < low[1] < -0.005
    np.testing.assert_allclose((high - low)[[0, 2]], [0.4 + 0.0108, 0.6 + 0.0108], rtol=0.01)
    outline = value(gasket_section(0.012, kind))
    length = 2 * (0.4 + 0.6) - (8 - math.tau) * 0.02
    assert shape.manifold.volume() == pytest.approx(outline_area(outline.contours) * length, rel=0.02)
    assert len(shape.mesh.triangles) < 4000


def test_lips_lean_inward():
    shape = value(gasket(0.4, 0.6, section="lip"))
    tips = shape.mesh.vertices[shape.mesh.vertices[:, 1] < -0.0085]
    right = tips[(tips[:, 0] > 0.15) & (np.abs(tips[:, 2]) < 0.25)]
    assert (right[:, 0] < 0.2).all()


@pytest.mark.parametrize("style", ["pad", "round", "levelling"])
def test_feet_stand_on_the_floor(style):
    shape = value(foot(0.015, 0.02, style=style))
    check_shape(shape)
    low, high = shape.bounds()
    np.testing.assert_allclose([low[2], high[2]], [0.0, 0.02], atol=1e-9)
    np.testing.assert_allclose((high - low)[:2], 0.03, rtol=0.05)


@pytest.mark.parametrize("seed", range(4))
def test_the_wires_of_racks_are_free_of_each_other(seed):
    rng = np.random.default_rng(seed)
    width, depth = rng.uniform(0.2, 0.5, 2)
    frame = rng.uniform(0.002, 0.004)
    rack = wire_rack(
        width, depth, pitch=rng.uniform(0.012, 0.04), wire=rng.uniform(0.001, 0.002), frame=frame,
        corner=rng.uniform(0.012, 0.03), direction=("depth", "width")[seed % 2], supports=seed % 3,
    )  # fmt: skip
    shape = value(rack)
    check_shape(shape, covered=False)
    parts = [member.manifold for member in shape.members]
    whole = Manifold.batch_boolean(parts, OpType.Add)
    assert shape.manifold.volume() == pytest.approx(whole.volume(), rel=1e-9), "no wire runs into another"
    assert len(shape.manifold.decompose()) == len(parts)
    low, high = shape.bounds()
    np.testing.assert_allclose((high - low)[:2], [width, depth], rtol=0.002)
    # each wire touches something: grown by 10 micrometres, all of them hang together
    frame_wire = shape.members[0].manifold
    for wire in parts[1:]:
        assert frame_wire.min_gap(wire, 0.002) < 2e-4


def test_racks_are_covered_and_racks_that_cannot_be_are_refused():
    check_cover(value(wire_rack(0.12, 0.1, pitch=0.03)))
    with pytest.raises(EvaluationError, match="width must be within"):
        value(wire_rack(0.01, 0.3))
    with pytest.raises(EvaluationError, match=r"a rack of \d+ wires is too fine, 200 are allowed"):
        value(wire_rack(1.2, 0.3, pitch=0.004))
    with pytest.raises(EvaluationError, match="supports must be 0 or more, got -1"):
        value(wire_rack(0.3, 0.3, supports=-1))
