import shutil
from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen import box, part
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.asset.shells import _skin
from artgen.validate.solids import check_solids
from support.blocks import STEEL, block, with_shapes


@artgen.generator
def crate(*, hollow: bool = True) -> artgen.Body:
    solid = box(0.1, 0.1, 0.1)
    return part(solid - box(0.05, 0.05, 0.05) if hollow else solid, "crate", STEEL)


@pytest.fixture(scope="module")
def door():
    return artgen.generate("door", 3, certify=False)


@pytest.fixture(scope="module")
def exported(door, tmp_path_factory):
    return door.export(tmp_path_factory.mktemp("exported") / "door", formats=("urdf",))


@pytest.fixture
def copy(exported, tmp_path):
    return shutil.copytree(exported, tmp_path / "door")


def messages(asset):
    return [finding.message for finding in check_solids(asset).findings]


@pytest.mark.parametrize(("category", "seed"), [("door", 0), ("door", 2), ("handle", 5)])
@pytest.mark.long
def test_solids_of_categories_are_sound_in_memory_and_read_back(category, seed, tmp_path):
    asset = artgen.generate(category, seed, certify=False)
    result = check_solids(asset)
    assert not result.findings
    solids = int(result.detail.split(", ")[1].split()[0])
    assert solids >= sum(len(link.pieces) for link in asset.links)
    read = check_solids(Asset.load(asset.export(tmp_path / "out", formats=("mjcf",))))
    assert not read.findings
    assert not read.skipped


def test_a_hollow_is_no_solid_turned_inside_out():
    result = check_solids(crate.generate(certify=False))
    assert not result.findings
    assert result.detail == "1 links, 2 solids, 24 triangles"


def test_a_solid_turned_inside_out_is_found():
    found = check_solids(with_shapes(crate.generate(certify=False), block((0.02, 0.02, 0.02), inward=True)))
    (finding,) = found.faults
    assert (
        finding.message == "solid 'extra' at (0.0, 0.0, 0.0) mm is turned inside out: its volume is -8 cm^3"
    )
    assert (finding.link, finding.unit) == ("crate", "m^3")
    assert finding.value == pytest.approx(-8e-6)


def test_a_solid_that_is_there_twice_is_found(door):
    frame = door.links[0].pieces[0]
    finding = check_solids(with_shapes(door, frame.shape)).findings[0]
    assert finding.message.startswith("solid 'frame' and 'extra' at (")
    assert "exists twice" in finding.message


def test_solids_with_one_center_and_volume_are_not_one():
    asset = with_shapes(crate.generate(hollow=False, certify=False), block((0.2, 0.1, 0.05)))
    assert messages(asset) == []


@pytest.mark.parametrize(
    ("size", "message"),
    [
        ((0.02, 0.02, 0.00003), "is a sliver, 0.0299"),
        ((0.0002, 0.0002, 0.0002), "is a particle of 0.008 mm^3"),
        ((0.02, 0.02, 0.00006), None),
        ((0.0003, 0.0003, 0.0003), None),
    ],
)
def test_slivers_and_crumbs_are_found(size, message):
    found = messages(with_shapes(crate.generate(certify=False), block(size, (0.05, 0.0, 0.0))))
    if message is None:
        assert found == []
    else:
        (text,) = found
        assert message in text


@pytest.mark.parametrize("number", [np.nan, np.inf])
def test_coordinates_that_are_not_finite_are_found(door, number):
    shape = block((0.1, 0.1, 0.1))
    vars(shape)["mesh"] = replace(shape.mesh, vertices=shape.mesh.vertices * number)
    assert messages(with_shapes(door, shape)) == ["solid 'extra' has coordinates that are not finite"]


def edit(directory, change):
    """Change the lines of the handle's mesh file."""
    (path,) = (directory / "meshes").glob("handle_handle_*.obj")
    path.write_text("\n".join(change(path.read_text().splitlines())) + "\n")


def test_a_removed_triangle_opens_the_surface(copy):
    def without_a_face(lines):
        number = max(n for n, line in enumerate(lines) if line.startswith("f "))
        return lines[:number] + lines[number + 1 :]

    edit(copy, without_a_face)
    (finding,) = check_solids(Asset.load(copy)).faults
    assert finding.link == "handle"
    assert finding.message.startswith("its mesh is not closed: 3 edges have a face on one side only")
    assert finding.value == 3.0


def test_a_turned_triangle_is_found(copy):
    def turned(lines):
        longest = max((line for line in lines if line.startswith("f ")), key=len)
        keyword, a, b, c = longest.split()
        return [f"{keyword} {a} {c} {b}" if line == longest else line for line in lines]

    edit(copy, turned)
    found = check_solids(Asset.load(copy)).faults
    assert found[0].message.startswith("its mesh has 3 edges whose faces are wound against each other")
    assert {finding.link for finding in found} == {"handle"}


def test_a_mesh_turned_inside_out_is_found(copy):
    def turned(lines):
        return [
            " ".join([line.split()[0], *line.split()[:0:-1]]) if line.startswith("f ") else line
            for line in lines
        ]

    edit(copy, turned)
    found = [finding.message for finding in check_solids(Asset.load(copy)).faults]
    assert any("triangles that lean away from their normals" in message for message in found)
    assert any("is turned inside out" in message for message in found)


def test_a_moved_vertex_is_found(copy):
    def moved(lines):
        number = next(n for n, line in enumerate(lines) if line.startswith("v "))
        keyword, x, y, z = lines[number].split()
        lines[number] = f"{keyword} {float(x) + 0.03:.7f} {y} {z}"
        return lines

    edit(copy, moved)
    found = check_solids(Asset.load(copy)).faults
    assert {finding.link for finding in found} == {"handle"}
    assert any("triangles that lean away from their normals" in finding.message for finding in found), found


def test_triangles_on_others_are_found(copy):
    def doubled(lines):
        return lines + [line for line in lines if line.startswith("f ")]

    edit(copy, doubled)
    (finding,) = check_solids(Asset.load(copy)).faults
    assert "triangles that lie on others of the same winding" in finding.message


def test_a_missing_mesh_is_a_fault_and_no_meshes_are_not(copy):
    (path,) = (copy / "meshes").glob("handle_handle_*.obj")
    path.unlink()
    (finding,) = check_solids(Asset.load(copy)).faults
    assert finding.link == "handle"
    assert path.name in finding.message
    shutil.rmtree(copy / "meshes")
    result = check_solids(Asset.load(copy))
    assert not result.findings
    assert result.skipped == "no mesh files; export it with urdf or mjcf among the formats"


def test_a_coarse_sphere_does_not_lean_away_from_its_normals():
    # eight facets between the axes of an ellipsoid; two normals of each stand more than 60 degrees from it
    points = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    flat = (points[:, :, None] * np.eye(3)).reshape(-1, 3)
    order = np.arange(24).reshape(8, 3)
    faces = np.where(points.prod(axis=1, keepdims=True) > 0, order, order[:, ::-1])
    sizes = np.array([0.0052, 0.0054, 0.0088])
    none = np.zeros((24, 2)), np.zeros(24, int)
    assert _skin(Mesh(flat * sizes, flat, *none, faces), ("egg",), 1e-7).against == 0
    turned = flat * np.where(flat[:, 2:] > 0.0, -1.0, 1.0)
    assert _skin(Mesh(flat * sizes, turned, *none, faces), ("egg",), 1e-7).against == 4
    leaning = np.where(flat[:, :1] > 0.0, [[0.0, 0.0, -1.0]], flat)
    assert _skin(Mesh(flat * sizes, leaning, *none, faces), ("egg",), 1e-7).against >= 2
