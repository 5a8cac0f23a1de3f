"""Links: what welded pieces weigh, look like and collide with."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import artgen as ag
from artgen.asset import Grasp, Link, Piece, Shape, rotation
from artgen.asset.link import MOST_COLLIDERS
from artgen.errors import AssetError
from artgen.materials import Material

BoxShape = Callable[..., Shape]

WOOD = Material("wood", density=500.0)
IRON = Material("iron", density=8000.0)


def test_overlap_of_welded_solids_counts_once_and_for_the_first(box_shape: BoxShape) -> None:
    plank, rod = box_shape((1.0, 1.0, 1.0)), box_shape((0.5, 0.5, 2.0))
    volume, sticking_out = 1.0, 0.5 * 0.5 * 1.0
    for pieces, mass in (
        ([Piece("plank", WOOD, plank), Piece("rod", IRON, rod)], 500.0 * volume + 8000.0 * sticking_out),
        ([Piece("rod", IRON, rod), Piece("plank", WOOD, plank)], 8000.0 * 0.5 + 500.0 * 0.75),
    ):
        assert Link("it", "it", tuple(pieces)).mass_properties.mass == pytest.approx(mass)


def test_solid_inside_another_adds_nothing(box_shape: BoxShape) -> None:
    block = Piece("block", WOOD, box_shape((1.0, 1.0, 1.0)))
    nail = Piece("nail", IRON, box_shape((0.1, 0.1, 0.5)))
    assert Link("it", "it", (block, nail)).mass_properties.mass == pytest.approx(500.0)


def test_touching_solids_add_up(box_shape: BoxShape) -> None:
    pieces = tuple(Piece("block", WOOD, box_shape((1.0, 1.0, 1.0), (x, 0.0, 0.0))) for x in (0.0, 1.0, 5.0))
    assert Link("it", "it", pieces).mass_properties.mass == pytest.approx(1500.0)


def test_visual_piece_is_only_seen(box_shape: BoxShape) -> None:
    body = Piece("body", WOOD, box_shape())
    sticker = Piece("sticker", IRON, box_shape((0.1, 0.1, 0.1), (0.0, -0.55, 0.0)), visual=True)
    link = Link("it", "it", (body, sticker))
    assert link.mass_properties.mass == pytest.approx(500.0)
    assert [collider.label for collider in link.colliders] == ["body"]
    assert [surface.label for surface in link.surfaces] == ["body", "sticker"]
    assert link.labels == ("it", "body", "sticker")


def test_faces_of_one_label_and_material_are_one_surface(box_shape: BoxShape) -> None:
    pieces = (
        Piece("leaf", WOOD, box_shape((0.1, 0.1, 0.1), (0.0, 0.0, 0.0))),
        Piece("leaf", WOOD, box_shape((0.1, 0.1, 0.1), (1.0, 0.0, 0.0))),
        Piece("leaf", IRON, box_shape((0.1, 0.1, 0.1), (2.0, 0.0, 0.0))),
    )
    surfaces = Link("it", "it", pieces).surfaces
    assert [(surface.name, len(surface.mesh.triangles)) for surface in surfaces] == [
        ("leaf_wood", 24),
        ("leaf_iron", 12),
    ]


def test_surface_does_not_depend_on_how_it_was_cached(box_shape: BoxShape) -> None:
    first = Link("it", "it", (Piece("leaf", WOOD, box_shape((0.3, 0.2, 0.1))),)).surfaces[0].mesh
    second = Link("it", "it", (Piece("leaf", WOOD, box_shape((0.3, 0.2, 0.1))),)).surfaces[0].mesh
    for field in ("vertices", "normals", "uvs", "triangles"):
        assert getattr(first, field).tobytes() == getattr(second, field).tobytes()


def test_surface_keeps_the_volume_of_the_solid(box_shape: BoxShape) -> None:
    mesh = Link("it", "it", (Piece("leaf", WOOD, box_shape((0.3, 0.2, 0.1))),)).surfaces[0].mesh
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]] for corner in range(3))
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0 == pytest.approx(0.006)


def test_more_solids_than_colliders_is_refused(box_shape: BoxShape) -> None:
    pieces = tuple(
        Piece("slat", WOOD, box_shape((0.01, 0.01, 0.01), (0.1 * index, 0.0, 0.0)))
        for index in range(MOST_COLLIDERS + 1)
    )
    with pytest.raises(AssetError, match=r"link 'grid' is made of 65 solids.*at most 64.*make them details"):
        _ = Link("grid", "grid", pieces).colliders


def test_link_carried_along_takes_everything_with_it(box_shape: BoxShape) -> None:
    grasp = Grasp("edge", np.eye(4), 0.05)
    link = Link("it", "it", (Piece("leaf", WOOD, box_shape((0.3, 0.2, 0.1))),), (grasp,))
    matrix = np.eye(4)
    matrix[:3, :3] = rotation(np.array([0.0, 0.0, 1.0]), np.pi / 2)
    matrix[:3, 3] = [1.0, 2.0, 3.0]
    moved = link.moved(matrix)
    np.testing.assert_allclose(moved.bounds(), [[0.9, 1.85, 2.95], [1.1, 2.15, 3.05]], atol=1e-9)
    np.testing.assert_allclose(moved.mass_properties.center, [1, 2, 3], atol=1e-9)
    np.testing.assert_allclose(moved.grasps[0].frame, matrix)


def test_mirrored_grasp_is_still_a_rotation() -> None:
    moved = Grasp("edge", np.eye(4)).moved(np.diag([-1.0, 1.0, 1.0, 1.0]))
    assert np.linalg.det(moved.frame[:3, :3]) == pytest.approx(1.0)
    np.testing.assert_allclose(moved.frame[:3, 2], [0, 0, 1])


def test_suffix_reaches_the_grasps(box_shape: BoxShape) -> None:
    link = Link("door", "door", (Piece("door", WOOD, box_shape()),), (Grasp("edge", np.eye(4)),))
    renamed = link.renamed("{}_1".format, {})
    assert (renamed.name, renamed.label) == ("door_1", "door")
    assert [grasp.name for grasp in renamed.grasps] == ["edge_1"]


def test_link_without_solids_says_so(box_shape: BoxShape) -> None:
    link = replace(Link("it", "it", (Piece("leaf", WOOD, box_shape()),)), pieces=())
    with pytest.raises(AssetError, match="'it' was read from files and has no exact solids; generate"):
        _ = link.mass_properties


def test_details_are_recorded_part_by_part_wherever_they_are_moved(box_shape: BoxShape) -> None:
    first, second = box_shape((1.0, 1.0, 1.0)), box_shape((1.0, 2.0, 1.0), (4.0, 0.0, 0.0))
    letters = Shape(first.manifold + second.manifold, first.pieces)
    link = Link("lid", "lid", (Piece("lid", WOOD, first), Piece("print", IRON, letters, visual=True)))
    turned = np.eye(4)
    turned[:3, :3], turned[:3, 3] = [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]], (0.1, 0.2, 0.3)
    mirrored = np.diag([-1.0, 1.0, 1.0, 1.0])
    for matrix in (np.eye(4), turned, mirrored, mirrored @ turned):
        moved = link.moved(matrix)
        parts = moved.pieces[1].shape.manifold.decompose()
        boxes = sorted(np.round(part.bounding_box(), 9).reshape(2, 3).tolist() for part in parts)
        assert len(boxes) == 2
        found = [item["bounds"] for item in moved.to_data()["details"]]
        assert np.array(found) == pytest.approx(np.array(boxes), abs=2e-9)


def test_too_many_colliders_name_the_parts_that_need_most_and_the_remedy() -> None:
    holes = ag.array(ag.bore(0.008, 1), at=ag.grid((0, 0, 0), 0.03 * ag.X, 0.03 * ag.Y, columns=4, rows=4))
    plate = ag.part(ag.box(0.2, 0.2, 0.01) - holes, "plate", ag.material("steel"))
    pin = ag.part(ag.box(0.01, 0.01, 0.05).at(z=0.03), "pin", ag.material("oak"))

    def toy() -> ag.Body:
        return ag.weld(plate, pin)

    message = r"bounding_collider\(solid, box\(...\)\); most are of its parts plate \d+, pin 1"
    with pytest.raises(AssetError, match=message):
        _ = ag.Generator(toy).generate(0, certify=False).links[0].colliders
