"""Mesh files: readable, exact enough, convex and closed where they must be."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from artgen.asset import Asset, Mesh
from artgen.asset.files import mesh_names, read_obj
from artgen.asset.surface import texture_coordinates
from artgen.colliders import Convex
from artgen.export.hulls import Hull
from artgen.export.maps import MapFiles, highlight, phong_exponent, specular_color
from artgen.export.meshes import display_color, hull_texts, mesh_files, mtl_text, surface_text
from artgen.materials import MATERIALS, Material
from support.textured import PLATE, picture, recipes, textured


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


PLAIN = Material("oak")
coordinates = st.floats(-50.0, 50.0, allow_nan=False)


def words(text: bytes, keyword: str) -> list[list[float]]:
    lines = [line.split() for line in text.decode().splitlines()]
    return [[float(word) for word in line[1:]] for line in lines if line and line[0] == keyword]


def corners(text: bytes) -> list[list[str]]:
    """Return position, texture coordinate and normal of each corner of the faces."""
    lines = [line.split()[1:] for line in text.decode().splitlines() if line.startswith("f")]
    return [corner.split("/") for line in lines for corner in line]


@given(st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=4, max_size=12))
def test_positions_are_written_to_a_tenth_of_a_micrometre(points: list[tuple[float, float, float]]) -> None:
    vertices = np.array(points)
    count = len(vertices)
    mesh = Mesh(vertices, np.zeros((count, 3)), vertices[:, :2], np.zeros(count, int), np.array([[0, 1, 2]]))
    text = surface_text(mesh, np.array([1.0, 2.0, 3.0]), "x.mtl", PLAIN)
    place, uv, _ = np.array(corners(text), int).T - 1
    np.testing.assert_allclose(
        np.array(words(text, "v"))[place], vertices[:3] - [1.0, 2.0, 3.0], atol=0.51e-7
    )
    np.testing.assert_allclose(np.array(words(text, "vt"))[uv], vertices[:3, :2], atol=0.51e-6)
    assert b"-0\n" not in text
    assert b"-0 " not in text
    assert b"e" not in b"".join(line for line in text.splitlines() if line.startswith(b"v"))


def test_surface_text_is_plain_obj() -> None:
    vertices = np.array([[0.0, -0.5, 12.25], [-1e-9, 100.0, -0.001], [1.0, 0.0, 0.0], [1, 2, 3]])
    normals = np.tile([0.0, 0.0, -1.0], (4, 1))
    mesh = Mesh(vertices, normals, vertices[:, :2], np.zeros(4, int), np.array([[0, 2, 1]]))
    assert surface_text(mesh, np.zeros(3), "door.mtl", PLAIN).decode().splitlines() == [
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
        "vn 0 0 -1",
        "f 1/1/1 3/3/1 2/2/1",
    ]


@given(data=st.data())
def test_surface_read_back_has_its_vertices_normals_and_triangles(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    count = data.draw(st.integers(4, 30))
    grid = st.integers(-200_000, 200_000)

    def draw(columns: int) -> NDArray[np.float64]:
        rows = st.lists(st.tuples(*[grid] * columns), min_size=count, max_size=count)
        return np.array(data.draw(rows), float)

    mesh = Mesh(
        draw(3) / 1e5,
        draw(3) / 1e5,
        draw(2) / 1e3,
        np.zeros(count, np.int64),
        np.array([np.arange(count), np.roll(np.arange(count), 1), np.roll(np.arange(count), 2)]).T,
    )
    path = tmp_path_factory.mktemp("obj") / "it.obj"
    path.write_bytes(surface_text(mesh, np.zeros(3), "x.mtl", PLAIN))
    found = read_obj(path, np.zeros(3))
    for name in ("vertices", "normals", "uvs"):
        read, written = (getattr(each, name)[each.triangles] for each in (found, mesh))
        np.testing.assert_allclose(read, written, atol=1e-12)
    rows = np.concatenate([found.vertices, found.normals, found.uvs], axis=1)
    assert len(np.unique(rows, axis=0)) == len(rows)
    # in the order of the numbers that the file gives to what it says, which is that of values to its digits
    order = np.lexsort((*found.uvs.T[::-1], *found.normals.T[::-1], *found.vertices.T[::-1]))
    np.testing.assert_array_equal(order, np.arange(len(rows)))


def test_each_position_normal_and_texture_coordinate_is_written_once(cabinet: Asset) -> None:
    for path, text in mesh_files(cabinet).files.items():
        for keyword in ("v", "vt", "vn"):
            found = words(text, keyword)
            assert len(found) == len({tuple(row) for row in found}), path


def test_kilometres_of_texture_are_written_as_well() -> None:
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    uvs = np.array([[-4e6, 5e6], [0.5, 5e6], [0.5, -5e6], [-4e6, 0.125]])
    mesh = Mesh(vertices, vertices, uvs, np.zeros(4, int), np.array([[0, 1, 2], [0, 2, 3]]))
    text = surface_text(mesh, np.zeros(3), "x.mtl", PLAIN)
    _, uv, _ = np.array(corners(text), int).T - 1
    np.testing.assert_array_equal(np.array(words(text, "vt"))[uv], uvs[mesh.triangles.ravel()])


@pytest.mark.parametrize("triangle", [[0, 1, 2], [1, 2, 0], [2, 0, 1]])
def test_lone_triangle_is_halved_facing_the_same_way(triangle: list[int]) -> None:
    vertices = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0]])
    mesh = Mesh(
        vertices, np.tile([0, 0, 1.0], (3, 1)), vertices[:, :2], np.zeros(3, int), np.array([triangle])
    )
    text = surface_text(mesh, np.zeros(3), "x.mtl", PLAIN)
    points = np.array(words(text, "v"))
    faces = [[int(word.split("/")[0]) - 1 for word in line.split()[1:]]
             for line in text.decode().splitlines() if line.startswith("f")]  # fmt: skip
    areas = [np.cross(points[b] - points[a], points[c] - points[a])[2] / 2 for a, b, c in faces]
    assert len(points) == 4
    np.testing.assert_allclose(areas, [1.0, 1.0])


def test_hulls_are_closed_convex_and_wound_outward() -> None:
    points = np.random.default_rng(5).normal(size=(40, 3))
    hull = Hull.of([(Convex("hull", np.eye(4), (), points), np.array([0.5, 0.0, 0.0]))])
    (text,) = hull_texts(hull)
    mesh = trimesh.load(trimesh.util.wrap_as_stream(text.decode()), file_type="obj")
    assert mesh.is_watertight
    assert mesh.is_convex
    assert mesh.volume == pytest.approx(trimesh.convex.convex_hull(points).volume, rel=1e-9)
    highest = mesh.bounds.max(axis=0) + hull[0].middle
    np.testing.assert_allclose(highest, points.max(axis=0) - [0.5, 0, 0], atol=1e-9)


def test_hull_is_told_about_its_own_middle() -> None:
    """PhysX makes contacts of centimetres between small hulls whose vertices are told from far away."""
    points = np.random.default_rng(6).normal(size=(20, 3)) / 100.0 + 3.0
    (hull,) = Hull.of([(Convex("hull", np.eye(4), (), points), np.array([1.0, 0.0, 0.0]))])
    np.testing.assert_allclose(hull.vertices.min(axis=0), -hull.vertices.max(axis=0), atol=1e-6)
    np.testing.assert_array_equal(hull.middle, np.round(hull.middle, 6))
    np.testing.assert_allclose(hull.placed.max(axis=0), points.max(axis=0) - [1.0, 0.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("off", [0.0, 4e-10])
def test_corner_on_an_edge_of_a_hull_is_left_out(off) -> None:
    """Its triangles would have neither area nor normal."""
    box = np.array([[x, y, z] for x in (0.0, 0.1) for y in (0.0, 0.2) for z in (0.0, 0.3)])
    points = np.vstack([box, [[0.04, -off, -off], [0.06, -off, -off], [0.1 + off, 0.1, 0.3]]])
    (hull,) = Hull.of([(Convex("hull", np.eye(4), (), points), np.zeros(3))])
    assert len(hull.vertices) == 8
    np.testing.assert_allclose(np.linalg.norm(hull.normals, axis=1), 1.0, atol=1e-12)


def test_many_hulls_are_written_like_each_alone() -> None:
    random = np.random.default_rng(8)
    pieces = [
        (Convex("hull", np.eye(4), (), random.normal(size=(n, 3))), random.normal(size=3)) for n in (9, 4, 30)
    ]
    alone = [hull_texts(Hull.of([piece]))[0] for piece in pieces]
    assert hull_texts(Hull.of(pieces)) == alone
    assert len(set(alone)) == 3
    assert hull_texts(Hull.of([])) == []


def test_hull_is_convex_as_it_is_written() -> None:
    """Points of a round cap lie nanometres off each other's planes; the text must not dent it."""
    angle = np.linspace(0.0, np.pi, 40)
    cap = np.array([1e-3 * np.cos(angle), 1e-3 * np.sin(angle), np.zeros(40)]).T
    points = np.concatenate([cap, cap + [0.0, 0.0, 2e-4]]) + 1.0 / 3.0
    (hull,) = Hull.of([(Convex("hull", np.eye(4), (), points), np.full(3, 1.0 / 7.0))])
    written = np.array(words(hull_texts([hull])[0], "v"))
    np.testing.assert_array_equal(written, hull.vertices)
    reach = np.einsum("ik,jk->ij", written, hull.normals)
    on = np.einsum("jk,jk->j", written[hull.triangles[:, 0]], hull.normals)
    assert (reach - on).max() < 1e-12


def test_meshes_lie_in_their_links_frame(cabinet: Asset) -> None:
    text = mesh_files(cabinet).files["meshes/lid_lid_oak.obj"]
    expected = cabinet.link("lid").surfaces[0].mesh.vertices - cabinet.origin("lid")
    np.testing.assert_allclose(words(text, "v"), np.unique(expected.round(7), axis=0), atol=1e-7)


def test_every_material_is_in_the_library_beside_the_meshes(cabinet: Asset) -> None:
    files = mesh_files(cabinet).files
    library = files["meshes/cabinet_7.mtl"].decode()
    for path, text in files.items():
        for line in text.decode().splitlines():
            if line.startswith("usemtl"):
                assert f"newmtl {line.split()[1]}\n" in library, path
            if line.startswith("mtllib"):
                assert line == "mtllib cabinet_7.mtl"


def blocks(text: bytes) -> dict[str, dict[str, str]]:
    """Return the words of each material of an MTL text."""
    result: dict[str, dict[str, str]] = {}
    for line in text.decode().splitlines():
        word, _, value = line.partition(" ")
        if word == "newmtl":
            result[value] = {}
        elif word:
            result[list(result)[-1]][word] = value
    return result


def test_library_says_opacity_glow_and_coat() -> None:
    lamp = Material("lamp", (1.0, 0.0, 0.5), opacity=0.25, emission=(1.0, 1.0, 0.0), coat_weight=0.5)
    assert mtl_text([lamp, lamp], MapFiles()).decode().splitlines() == [
        "newmtl lamp", "Kd 1 0 0.735357", "Ks 0.220916 0.220916 0.220916", "Ke 1 1 0", "Ns 30", "d 0.25",
        "illum 2", "Pr 0.5", "Pm 0", "Pc 0.5", "Pcr 0.1",
    ]  # fmt: skip


def test_library_names_the_maps_below_the_meshes_and_leaves_the_numbers_at_one() -> None:
    asset = textured()
    written = mesh_files(asset, 256)
    library = blocks(written.files["meshes/textured.mtl"])
    board, plate = library["board"], library["plate"]
    assert {"map_Kd", "map_Pr", "norm"} <= set(board)
    assert (board["Kd"], board["Pr"], board["Pm"]) == ("1 1 1", "1", "0")
    assert {"map_Pr", "map_Pm"} <= set(plate)
    assert not {"map_Kd", "norm"} & set(plate)
    assert (plate["Pr"], plate["Pm"]) == ("1", "1")
    assert plate["Kd"] == " ".join(f"{x:.6g}" for x in display_color(PLATE.base_color))
    for words_of in library.values():
        for word, value in words_of.items():
            if word.startswith(("map_", "norm")):
                assert f"meshes/{value}" in written.files
                assert ".." not in value


def test_trimesh_shows_the_picture_upright_and_in_scale(tmp_path: Path) -> None:
    """What the library's reader finds at the texture coordinates of a face is what the recipe drew there."""
    asset = textured()
    for path, content in mesh_files(asset, 256).files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / path).write_bytes(content)
    surface = asset.link("board").surfaces[0]
    mesh = trimesh.load_mesh(tmp_path / "meshes/board_board_board.obj", process=False)
    image = mesh.visual.material.image
    assert image.size == (256, 256)
    assert list(mesh.visual.material.diffuse[:3]) == [255, 255, 255]
    wanted = texture_coordinates(surface.mesh, surface.material)[surface.mesh.triangles]
    np.testing.assert_allclose(mesh.visual.uv[mesh.faces], wanted, atol=1e-6)
    for u, v in ((0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)):
        found = np.array(image)[int((1.0 - v) * 256), int(u * 256)]
        wanted = 255.0 * np.array(display_color(picture(u, v, surface.material)))
        np.testing.assert_allclose(found, wanted, atol=1.01)  # the tint is one of 8 bits
    roughness = mesh.visual.material.to_pbr().roughnessFactor
    assert roughness == pytest.approx(surface.material.specular_roughness, rel=1e-4)


@pytest.mark.parametrize("name", MATERIALS)
def test_highlights_of_phong_are_those_of_the_material(name: str) -> None:
    found = MATERIALS[name]
    exponent = phong_exponent(found.specular_roughness)
    if 1.0 < exponent < 1000.0:
        assert (2.0 / (exponent + 2.0)) ** 0.25 == pytest.approx(found.specular_roughness)
    strength, width = highlight(found, 128.0)
    assert 0.0 < strength <= 1.0
    assert 1.0 <= width <= 128.0
    if found.base_metalness == 1.0:
        assert specular_color(found) == pytest.approx(found.base_color)


def test_lacquer_shines_over_a_dull_material() -> None:
    dull = Material("dull", specular_roughness=0.8)
    lacquered = dull.with_(coat_weight=1.0, coat_roughness=0.1)
    assert highlight(lacquered, 128.0)[0] > 10.0 * highlight(dull, 128.0)[0]
    assert highlight(lacquered, 128.0)[1] == 128.0


def test_colors_are_encoded_for_display() -> None:
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
