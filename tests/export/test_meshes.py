"""Mesh files: readable, exact enough, convex and closed where they must be."""

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from artgen.asset import Asset, Mesh
from artgen.asset.files import mesh_names
from artgen.colliders import Convex
from artgen.export.meshes import display_color, hull_text, mesh_files, mtl_text, surface_text
from artgen.materials import Material

coordinates = st.floats(-50.0, 50.0, allow_nan=False)


def words(text: bytes, keyword: str) -> list[list[float]]:
    lines = [line.split() for line in text.decode().splitlines()]
    return [[float(word) for word in line[1:]] for line in lines if line and line[0] == keyword]


@given(st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=4, max_size=12))
def test_positions_are_written_to_a_tenth_of_a_micrometre(points: list[tuple[float, float, float]]) -> None:
    vertices = np.array(points)
    count = len(vertices)
    mesh = Mesh(vertices, np.zeros((count, 3)), vertices[:, :2], np.zeros(count, int), np.array([[0, 1, 2]]))
    text = surface_text(mesh, np.array([1.0, 2.0, 3.0]), "x.mtl", "oak")
    np.testing.assert_allclose(words(text, "v"), vertices - [1.0, 2.0, 3.0], atol=0.51e-7)
    np.testing.assert_allclose(words(text, "vt"), vertices[:, :2], atol=0.51e-6)
    assert b"-0\n" not in text
    assert b"-0 " not in text
    assert b"e" not in b"".join(line for line in text.splitlines() if line.startswith(b"v"))


def test_surface_text_is_plain_obj() -> None:
    vertices = np.array([[0.0, -0.5, 12.25], [-1e-9, 100.0, -0.001], [1.0, 0.0, 0.0], [1, 2, 3]])
    normals = np.tile([0.0, 0.0, -1.0], (4, 1))
    mesh = Mesh(vertices, normals, vertices[:, :2], np.zeros(4, int), np.array([[0, 2, 1]]))
    assert surface_text(mesh, np.zeros(3), "door.mtl", "oak").decode().splitlines() == [
        "mtllib door.mtl",
        "usemtl oak",
        "v 0 -0.5 12.25",
        "v 0 100 -0.001",
        "v 1 0 0",
        "v 1 2 3",
        "vt 0 -0.5",
        "vt 0 100",
        "vt 1 0",
        "vt 1 2",
        *["vn 0 0 -1"] * 4,
        "f 1/1/1 3/3/3 2/2/2",
    ]


@pytest.mark.parametrize("corners", [[0, 1, 2], [1, 2, 0], [2, 0, 1]])
def test_lone_triangle_is_halved_facing_the_same_way(corners: list[int]) -> None:
    vertices = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0]])
    mesh = Mesh(
        vertices, np.tile([0, 0, 1.0], (3, 1)), vertices[:, :2], np.zeros(3, int), np.array([corners])
    )
    text = surface_text(mesh, np.zeros(3), "x.mtl", "oak")
    points = np.array(words(text, "v"))
    faces = [[int(word.split("/")[0]) - 1 for word in line.split()[1:]]
             for line in text.decode().splitlines() if line.startswith("f")]  # fmt: skip
    areas = [np.cross(points[b] - points[a], points[c] - points[a])[2] / 2 for a, b, c in faces]
    assert len(points) == 4
    np.testing.assert_allclose(areas, [1.0, 1.0])


def test_hulls_are_closed_convex_and_wound_outward() -> None:
    points = np.random.default_rng(5).normal(size=(40, 3))
    text = hull_text(Convex("hull", np.eye(4), (), points), np.array([0.5, 0.0, 0.0]))
    mesh = trimesh.load(trimesh.util.wrap_as_stream(text.decode()), file_type="obj")
    assert mesh.is_watertight
    assert mesh.is_convex
    assert mesh.volume == pytest.approx(trimesh.convex.convex_hull(points).volume, rel=1e-9)
    np.testing.assert_allclose(mesh.bounds.max(axis=0), points.max(axis=0) - [0.5, 0, 0], atol=1e-9)


def test_meshes_lie_in_their_links_frame(cabinet: Asset) -> None:
    text = mesh_files(cabinet).files["meshes/lid_lid_oak.obj"]
    expected = cabinet.link("lid").surfaces[0].mesh.vertices - cabinet.origin("lid")
    np.testing.assert_allclose(words(text, "v"), expected, atol=1e-7)


def test_every_material_is_in_the_library_beside_the_meshes(cabinet: Asset) -> None:
    files = mesh_files(cabinet).files
    library = files["meshes/cabinet_7.mtl"].decode()
    for path, text in files.items():
        for line in text.decode().splitlines():
            if line.startswith("usemtl"):
                assert f"newmtl {line.split()[1]}\n" in library, path
            if line.startswith("mtllib"):
                assert line == "mtllib cabinet_7.mtl"


def test_library_says_opacity_and_glow() -> None:
    text = mtl_text([Material("lamp", (1.0, 0.0, 0.5), opacity=0.25, emission=(1.0, 1.0, 0.0))]).decode()
    assert text.splitlines() == [
        "newmtl lamp", "Kd 1 0 0.735357", "Ke 1 1 0", "d 0.25", "Pr 0.5", "Pm 0",
    ]  # fmt: skip


def test_colours_are_encoded_for_display() -> None:
    assert display_color((0.0, 0.2140411, 1.0)) == pytest.approx((0.0, 0.5, 1.0), abs=1e-6)


@given(
    st.dictionaries(
        st.sampled_from(["a", "a_b", "A", "a_", "b"]),
        st.lists(st.sampled_from(["b", "b_c", "c", "C", "_c"]), max_size=5),
    )
)
def test_file_names_differ_whatever_the_names(names: dict[str, list[str]]) -> None:
    files = mesh_names(names)
    flat = [file.lower() for of_link in files.values() for file in of_link]
    assert len(flat) == len(set(flat))
    assert {link: len(found) for link, found in files.items()} == {link: len(n) for link, n in names.items()}
