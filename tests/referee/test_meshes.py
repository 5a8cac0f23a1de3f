"""Meshes of foreign files: their formats, their faults, and the convex pieces that stand for them."""

import json
import struct

import numpy as np
import pytest
import trimesh

from artgen.errors import AssetError
from artgen.referee import meshes
from artgen.referee.meshes import Hulls, load_mesh, noted

DAE = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset/>
<library_nodes>{nodes}</library_nodes>
<library_visual_scenes><visual_scene id="s"><node><instance_node url="#n0"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""
CUBE = trimesh.creation.box((1, 2, 3))


def glb(header, data=b""):
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


@pytest.mark.parametrize("kind", ["stl", "obj", "ply", "glb", "dae"])
def test_each_format_has_its_triangles(tmp_path, kind):
    pytest.importorskip("collada")
    path = tmp_path / f"a.{kind.upper()}"
    data = CUBE.export(file_type=kind)
    path.write_bytes(data.encode() if isinstance(data, str) else data)
    for scale in ((1, 1, 1), (-1, 2, 0.5)):
        ((vertices, triangles),) = load_mesh(path, scale)
        mesh = trimesh.Trimesh(vertices, triangles)
        assert np.allclose(mesh.extents, np.abs(scale) * (1, 2, 3))
        assert mesh.volume == pytest.approx(6 * abs(np.prod(scale)))  # mirrored, but not inside out


def test_the_materials_of_a_mesh_are_not_parts(tmp_path):
    quads = [CUBE.submesh([range(6)], append=True), CUBE.submesh([range(6, 12)], append=True)]
    scene = trimesh.Scene(quads)
    data = scene.export(file_type="glb")
    length = struct.unpack("<I", data[12:16])[0]
    header = json.loads(data[20 : 20 + length])
    header["meshes"] = [{"primitives": [each["primitives"][0] for each in header["meshes"]]}]
    header["nodes"] = [{"mesh": 0, "translation": [0, 0, 5]}]
    header["scenes"] = [{"nodes": [0]}]
    (tmp_path / "a.glb").write_bytes(glb(header, data[28 + length :]))
    ((vertices, triangles),) = load_mesh(tmp_path / "a.glb")
    assert trimesh.Trimesh(vertices, triangles).volume == pytest.approx(6)
    assert np.allclose(vertices.min(axis=0), (-0.5, -1, 3.5))


@pytest.mark.parametrize(
    ("name", "data", "fault"),
    [
        ("a.stl", b"solid", "has no triangles; export it again"),
        ("a.stl", b"\0" * 80 + b"\xff\xff\xff\x7f", "has no triangles|cannot be read as STL"),
        ("a.obj", b"v 0 0 0\nf 1 2 9\n", r"cannot be read as OBJ \(IndexError"),
        ("a.obj", b"v 0 nan 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\n", "not finite or exceed 1e.06 m"),
        ("a.obj", b"v 0 1e9 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\n", "not finite or exceed 1e.06 m"),
        (
            "a.ply",
            b"ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n1",
            "PLY",
        ),
        ("a.glb", b"glTF\2\0\0\0", "cannot be read as GLB"),
        ("a.glb", glb({"buffers": [{"uri": "/etc/passwd", "byteLength": 9}]}), "GLB"),
        ("a.dae", b"<COLLADA/>", "cannot be read as DAE|another package"),
        ("a.dae", b"<!DOCTYPE a [<!ENTITY b 'c'>]><COLLADA/>", "declares a document type"),
        ("a.msh", b"", "has the format 'msh'; convert the mesh to one of DAE, GLB, OBJ, PLY, STL"),
        ("a", b"", "has the format ''"),
    ],
)
def test_a_damaged_mesh_has_one_clear_error(tmp_path, name, data, fault):
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(AssetError, match=fault) as caught:
        load_mesh(path, where="line 3: <mesh>")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("accessors", "fault"),
    [([{"count": 10**11}], "more than 50000000 values"), ([{"count": 5}], "export it without compression")],
)
def test_values_that_a_mesh_only_claims_are_refused(tmp_path, accessors, fault):
    (tmp_path / "a.glb").write_bytes(glb({"accessors": accessors}))
    with pytest.raises(AssetError, match=f"^mesh 'a.glb': it has .*{fault}"):
        load_mesh(tmp_path / "a.glb")


def test_instances_of_instances_are_counted(tmp_path):
    node = '<node id="n{0}"><instance_node url="#n{1}"/><instance_node url="#n{1}"/></node>'
    nodes = "".join(node.format(number, number + 1) for number in range(60)) + '<node id="n60"/>'
    (tmp_path / "a.dae").write_text(DAE.format(nodes=nodes), encoding="utf-8")
    with pytest.raises(AssetError, match="more than 20000 nodes"):
        load_mesh(tmp_path / "a.dae")


def test_scenes_of_many_nodes_are_refused(tmp_path, monkeypatch):
    trimesh.Scene([CUBE, CUBE.copy()]).export(tmp_path / "a.glb")
    monkeypatch.setattr(meshes, "MOST_BODIES", 2)
    with pytest.raises(AssetError, match="more than 2 nodes"):
        load_mesh(tmp_path / "a.glb")


def part(mesh):
    return [(mesh.vertices.view(np.ndarray), mesh.faces.view(np.ndarray))]


def test_a_convex_mesh_is_one_hull_whatever_its_triangles(coacd_cache):
    soup = trimesh.Trimesh(*trimesh.triangles.to_kwargs(CUBE.triangles).values(), process=False)
    inside_out = CUBE.copy()
    inside_out.invert()
    for mode in ("hull", "coacd"):
        hulls = Hulls(mode)
        for number, mesh in enumerate((soup, inside_out, trimesh.creation.icosphere())):
            assert len(hulls.pieces(number, "m", lambda mesh=mesh: part(mesh))) == 1
        assert hulls.notes() == []


def test_a_mesh_is_made_once_and_noted_once(coacd_cache):
    step = trimesh.util.concatenate([CUBE, CUBE.copy().apply_translation((0.5, 4, 0))])
    hulls, calls = Hulls("hull"), []

    def load():
        calls.append(1)
        return part(step)

    first = hulls.pieces("a", "a.stl", load)
    assert hulls.pieces("a", "a.stl", load) is first
    assert len(calls) == 1
    assert hulls.notes() == ["1 mesh ('a.stl'): not convex: taken as hulls, as most simulators take them"]
    decomposed = Hulls("coacd")
    pieces = decomposed.pieces("a", "a.stl", load)
    assert sum(piece.volume for piece in pieces) == pytest.approx(12, rel=0.01)
    assert "by CoACD" in decomposed.notes()[0]


def test_where_coacd_fails_the_hull_stands(monkeypatch):
    def fail(*_):
        raise ValueError("it fails")

    monkeypatch.setattr(meshes, "coacd_pieces", fail)
    hulls = Hulls("coacd")
    step = trimesh.util.concatenate([CUBE, CUBE.copy().apply_translation((0.5, 4, 0))])
    (hull,) = hulls.pieces("a", "a.stl", lambda: part(step))
    assert hull.volume > 12
    assert hulls.notes() == ["1 mesh ('a.stl'): not convex, and CoACD fails on them: taken as hulls"]


def test_notes_name_the_first_few():
    assert noted("joint", "joints", ["a", "b", "c", "d"], "bad") == "4 joints ('a', 'b', 'c', ...): bad"
    assert noted("joint", "joints", ["a\n"], "bad") == r"1 joint ('a\n'): bad"
