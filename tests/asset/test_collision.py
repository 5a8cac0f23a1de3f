"""Colliders of other kinds: what they cover, what they keep of the asset, and what is refused."""

import json

import numpy as np
import pytest
from manifold3d import Manifold, OpType

from artgen import Region, part
from artgen.asset import Asset, collision
from artgen.asset.collision import SolidPart, link_parts, made_colliders, with_colliders
from artgen.asset.shape import Mesh
from artgen.asset.shells import file_shells, skins
from artgen.errors import AssetError, ExportError
from artgen.export import export
from artgen.export.files import encode
from artgen.generator import generator
from support.trays import RUBBER, STEEL, comb, tray

pytestmark = pytest.mark.usefixtures("coacd_cache")


@pytest.fixture(scope="module")
def asset():
    return tray.generate(certify=False)


def united(manifolds):
    return Manifold.batch_boolean(list(manifolds), OpType.Add)


def solids_of(link):
    return united(piece.shape.manifold for piece in link.pieces if not piece.visual)


def cover_of(link):
    return united(collider.convex.manifold(1e-6) for collider in link.colliders)


def test_hulls_contain_the_solids_and_close_their_hollows(asset):
    base = with_colliders(asset, "hull").link("tray")
    assert [(collider.label, collider.material) for collider in base.colliders] == [
        ("tray", STEEL),
        ("foot", RUBBER),
    ]
    assert (solids_of(base) - cover_of(base)).volume() == pytest.approx(0.0, abs=1e-12)
    assert [collider.convex.volume for collider in base.colliders] == pytest.approx([1e-3, 4e-6])


def test_hulls_of_round_solids_have_few_vertices_and_contain_them():
    ball = SolidPart("ball", STEEL, Manifold.sphere(0.05, 100))
    assert ball.solid.num_vert() > 1000
    (collider,) = made_colliders([ball], "hull")
    assert len(collider.convex.points) <= 64
    assert (ball.solid - collider.convex.manifold()).volume() == pytest.approx(0.0, abs=1e-12)
    assert collider.convex.volume < 1.15 * ball.solid.volume()


def test_too_many_parts_are_joined_with_their_neighbors():
    link = comb.generate(certify=False).links[0]
    parts = [SolidPart(piece.label, piece.material, piece.shape.manifold) for piece in link.pieces]
    colliders = made_colliders(parts, "hull")
    assert len(colliders) == 64
    lengths = sorted(np.ptp(collider.convex.bounds(), axis=0)[0] for collider in colliders)
    assert lengths == pytest.approx([0.002] * 58 + [0.006] * 6)  # six pairs of neighbors


def test_a_joined_hull_is_named_like_the_largest_of_its_parts(monkeypatch):
    monkeypatch.setattr(collision, "MOST_COLLIDERS", 1)
    blocks = [
        SolidPart(label, material, Manifold.cube((size,) * 3).translate((x, 0, 0)))
        for label, material, size, x in (("small", STEEL, 0.01, 0.0), ("large", RUBBER, 0.02, 0.02))
    ]
    (collider,) = made_colliders(blocks, "hull")
    assert (collider.label, collider.material) == ("large", RUBBER)


@pytest.mark.long
def test_coacd_keeps_the_hollow_open_and_names_its_pieces(asset):
    pytest.importorskip("coacd")
    base = with_colliders(asset, "coacd").link("tray")
    solids, cover = solids_of(base), cover_of(base)
    assert {(each.label, each.material) for each in base.colliders} == {("tray", STEEL), ("foot", RUBBER)}
    assert sum(collider.label == "foot" for collider in base.colliders) == 1
    assert 5 <= len(base.colliders) <= 10
    assert (solids - cover).volume() + (cover - solids).volume() < 0.1 * solids.volume()
    inside = Manifold.cube((0.16, 0.06, 0.02), True).translate((0, 0, 0.035))
    assert (inside ^ cover).volume() < 0.01 * inside.volume()


def test_coacd_takes_convex_solids_as_they_are_and_overlapping_ones_as_one(monkeypatch):
    seen = []

    def spy(vertices, triangles, **keywords):
        seen.append(len(triangles))
        raise ValueError("CoACD fails on a mesh")

    monkeypatch.setattr(collision, "coacd_pieces", spy)
    cubes = [
        SolidPart("cube", STEEL, Manifold.cube((1, 1, 1)).translate(place))
        for place in ((0, 0, 0), (1 + 1e-7, 0, 0), (2 - 1e-7, 0, 0))  # as near as files tell
    ]
    colliders = made_colliders(cubes, "coacd")
    assert [collider.convex.kind for collider in colliders] == ["box"] * 3
    assert not seen
    overlapping = SolidPart("cube", STEEL, Manifold.cube((1, 1, 1)).translate((0.5, 0.5, 0)))
    with pytest.raises(ExportError, match="cannot make colliders of kind 'coacd': CoACD fails on a mesh"):
        made_colliders([*cubes[::2], overlapping], "coacd")
    assert len(seen) == 1


@pytest.mark.parametrize("kind", ["coacd", "hull"])
def test_all_else_stays(asset, kind):
    changed = with_colliders(asset, kind)
    before, after = asset.to_data(), changed.to_data()
    for link in (*before["links"], *after["links"]):
        del link["colliders"]
    assert all(link.pop("collision") == kind for link in after["links"])
    assert after == before
    assert changed.mass == asset.mass
    assert with_colliders(changed, kind).to_json() == changed.to_json()
    assert changed.link("tray").moved(np.eye(4)).colliders[0].convex.volume == pytest.approx(
        changed.link("tray").colliders[0].convex.volume
    )


def test_the_certificate_is_not_of_other_colliders(asset):
    asset.certify()
    assert asset.certificate is not None
    assert with_colliders(asset, "exact").certificate is asset.certificate
    assert with_colliders(asset, "hull").certificate is None
    files = encode(asset, ("urdf",), "hull")
    assert json.loads(files["asset.json"])["certificate"] is None
    assert json.loads(encode(asset, ("urdf",))["asset.json"])["certificate"] is not None


@pytest.mark.parametrize("kind", ["coacd", "hull"])
def test_an_export_records_its_kind_and_keeps_it(asset, kind, tmp_path):
    directory = export(asset, tmp_path / kind, formats=("urdf", "mjcf"), collision=kind)
    data = json.loads((directory / "asset.json").read_text())
    assert data["collision"] == kind
    loaded = Asset.load(directory)
    counts = [len(link.colliders) for link in with_colliders(asset, kind).links]
    assert [len(link.colliders) for link in loaded.links] == counts
    assert (directory / "tray_0.xml").read_text().count("<geom name=") == sum(counts) + 5
    again = loaded.export(tmp_path / "again", formats=("urdf", "mjcf"))
    assert json.loads((again / "asset.json").read_text()) == data


def test_exact_is_what_is_exported_unless_told_otherwise(asset, tmp_path):
    files = encode(asset, ("urdf", "mjcf", "usd"), "exact")
    assert encode(asset, ("urdf", "mjcf", "usd")) == files
    data = json.loads(files["asset.json"])
    assert data["collision"] == "exact"
    assert all("collision" not in link for link in data["links"])
    assert asset.export(tmp_path / "out").joinpath("tray_0.xml").read_bytes() == files["tray_0.xml"]


def test_wrong_use_is_refused(asset, tmp_path):
    with pytest.raises(ExportError, match=r"there is no collision 'coacdd'\. Did you mean 'coacd'\?"):
        asset.export(tmp_path / "out", collision="coacdd")
    with pytest.raises(ExportError, match=r"no collision 'boxes'\. Allowed: coacd, exact, hull\."):
        with_colliders(asset, "boxes")
    assert not list(tmp_path.iterdir())
    loaded = Asset.load(asset.export(tmp_path / "out", formats=("urdf",)))
    assert with_colliders(loaded, "exact") is loaded
    with pytest.raises(
        AssetError,
        match=r"asset 'tray_0' was read from files, which keep no solids, so its colliders cannot be "
        r"replaced by 'hull'; generate the asset again, or write it with collision='exact'",
    ) as caught:
        loaded.export(tmp_path / "other", collision="hull")
    assert caught.value.link == "tray"
    assert not (tmp_path / "other").exists()


CUBE = ((0.0, 0.1), (0.0, 0.1), (0.0, 0.1))


def blocks_in_files(folder, *blocks):
    @generator
    def blocks_of_one_label():
        return part([Region(*block).box() for block in blocks], "block", STEEL)

    return blocks_of_one_label.generate(certify=False).export(folder, formats=("urdf",))


@pytest.mark.parametrize(
    ("second", "volume"),
    [
        (((0.1, 0.2), (0.1, 0.2), (0.0, 0.1)), 1e-3),  # share an edge
        (((0.1, 0.2), (0.0, 0.1), (0.05, 0.1)), 5e-4),  # share an edge, with tops in one plane
        (((0.1, 0.2), (0.0, 0.1), (0.0, 0.1)), 1e-3),  # share a face
        (((0.1, 0.2), (0.1, 0.2), (0.1, 0.2)), 1e-3),  # share a corner
        (((0.0, 0.2), (0.0, 0.1), (0.0, 0.1)), 2e-3),  # overlap, and share a face of one winding
    ],
)
def test_solids_that_touch_are_read_from_files_one_by_one(tmp_path, second, volume):
    link = Asset.load(blocks_in_files(tmp_path / "blocks", CUBE, second)).links[0]
    volumes = [each.solid.volume() for each in link_parts(link)]
    assert volumes == pytest.approx(sorted([1e-3, volume]), rel=1e-9)


def test_four_blocks_around_a_corner_are_read_one_by_one(tmp_path):
    near, far = (0.0, 0.1), (0.1, 0.2)
    blocks = ((near, near, near), (far, far, near), (near, far, far), (far, near, far))
    link = Asset.load(blocks_in_files(tmp_path / "blocks", *blocks)).links[0]
    assert [each.solid.volume() for each in link_parts(link)] == pytest.approx([1e-3] * 4, rel=1e-9)
    (skin,) = skins(link)
    assert skin.closed
    assert [shell.volume for shell in skin.shells] == pytest.approx([1e-3] * 4, rel=1e-9)


def test_each_triangle_that_is_missing_at_a_shared_edge_is_found(tmp_path):
    directory = blocks_in_files(tmp_path / "blocks", CUBE, ((0.1, 0.2), (0.1, 0.2), (0.0, 0.1)))
    (mesh,) = directory.glob("meshes/*.obj")
    lines = mesh.read_text().splitlines()
    faces = [number for number, line in enumerate(lines) if line.startswith("f ")]
    assert len(faces) == 24
    for face in faces:
        mesh.write_text("\n".join(line for number, line in enumerate(lines) if number != face) + "\n")
        link = Asset.load(directory).links[0]
        assert not skins(link)[0].closed
        with pytest.raises(AssetError, match=r"label 'block' do not close to a solid \(NotManifold\)"):
            link_parts(link)


def test_a_fold_on_an_edge_is_no_part():
    cube = Manifold.cube((0.1, 0.1, 0.1)).to_mesh64()
    corners = np.array(cube.vert_properties)[:, :3]
    (start, end, _), *_ = faces = np.array(cube.tri_verts).astype(np.int64)
    points = np.append(corners, [[0.2, 0.3, 0.4]], axis=0)
    fold = [[start, end, len(corners)], [end, start, len(corners)]]
    nothing = np.zeros((len(points), 3))
    mesh = Mesh(
        points, nothing, nothing[:, :2], np.zeros(len(points), np.int64), np.append(faces, fold, axis=0)
    )
    (shell,) = file_shells(mesh, "block")
    assert len(shell.triangles) == 12
    assert shell.volume == pytest.approx(1e-3)
