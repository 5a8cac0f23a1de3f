"""Surfaces of fewer triangles: near what was made, closed, of the same names; nothing else changes."""

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh

from artgen import generate
from artgen.asset import Asset
from artgen.asset.manifolds import is_closed
from artgen.asset.surface import coarser
from artgen.dataset.run import record_of
from artgen.errors import AssetError, ParameterError
from artgen.export.files import encode
from artgen.validate import validate

PRECISION = 0.0005


@pytest.fixture(scope="module")
def asset() -> Asset:
    return generate("toaster", seed=3, certify=False)


@pytest.fixture(scope="module")
def exports(asset: Asset, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Write the asset with all its triangles, and with fewer."""
    folder = tmp_path_factory.mktemp("precision")
    options = {"formats": ("mjcf", "usd"), "textures": 0}
    return (
        asset.export(folder / "all", **options),
        asset.export(folder / "fewer", **options, mesh_precision=PRECISION),
    )


def surfaces(directory: Path) -> dict[str, trimesh.Trimesh]:
    found = {}
    for path in sorted((directory / "meshes").glob("*.obj")):
        if "collider" not in path.name:
            mesh = trimesh.load(path, force="mesh", process=False)
            mesh.merge_vertices(merge_tex=True, merge_norm=True)
            found[path.name] = mesh
    return found


def test_fewer_triangles_lie_near_all_of_them(exports: tuple[Path, Path]) -> None:
    before, after = (surfaces(directory) for directory in exports)
    assert list(before) == list(after)
    count = [sum(len(mesh.faces) for mesh in found.values()) for found in (before, after)]
    assert count[1] < 0.65 * count[0]
    for name, mesh in after.items():
        assert is_closed(np.asarray(mesh.faces)), name  # walls may come to touch at an edge
        far = max(
            np.abs(trimesh.proximity.closest_point(other, points)[1]).max()
            for other, points in ((before[name], mesh.vertices), (mesh, before[name].vertices[::7]))
        )
        assert far < 1.01 * PRECISION, f"{name}: {1000.0 * far:.3f} mm"


def test_files_are_smaller_and_say_how_precise_they_are(exports: tuple[Path, Path]) -> None:
    size = [sum(path.stat().st_size for path in each.rglob("*.*")) for each in exports]
    assert size[1] < 0.75 * size[0]
    full, coarse = (json.loads((each / "asset.json").read_text()) for each in exports)
    assert all(link["mesh_precision"] == PRECISION for link in coarse["links"])
    for link, other in zip(full["links"], coarse["links"], strict=True):
        fewer, more = ([each.pop("triangles") for each in one["surfaces"]] for one in (other, link))
        assert sum(fewer) < sum(more) or more == [12] * len(more)
        assert {**link, "details": [], "mesh_precision": PRECISION} == other
    written = sum(len(mesh.faces) for mesh in surfaces(exports[1]).values())
    data = json.loads((exports[1] / "asset.json").read_text())
    assert sum(each["triangles"] for link in data["links"] for each in link["surfaces"]) == written


def test_numbers_have_as_few_digits_as_they_are_precise(exports: tuple[Path, Path]) -> None:
    rows: dict[str, list[str]] = {"v": [], "vt": [], "vn": []}
    for path in (exports[1] / "meshes").glob("*.obj"):
        if "collider" not in path.name:
            for head, *numbers in map(str.split, path.read_text().splitlines()):
                rows.get(head, []).extend(numbers)
    digits = {head: [len(each.partition(".")[2]) for each in numbers] for head, numbers in rows.items()}
    assert (max(digits["v"]), max(digits["vn"])) == (6, 4)  # a hundredth of half a millimetre is 5e-6 m
    assert np.quantile(digits["vt"], 0.97) == 4  # some vertices where faces touch in a point are set apart


@pytest.mark.parametrize(("category", "seed", "label"), [("lamp", 0, "base"), ("toaster", 0, "knob")])
def test_steps_along_a_curve_do_not_add_up(category: str, seed: int, label: str) -> None:
    """These lay up to five times as far from what was made."""
    precision = 0.001
    links = generate(category, seed=seed, certify=False).links
    count = [0, 0]
    for piece in (piece for link in links for piece in link.pieces if piece.label == label):
        mesh = coarser(piece.shape, precision)
        other = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
        points = np.unique(piece.shape.mesh.vertices, axis=0)
        assert np.abs(trimesh.proximity.closest_point(other, points)[1]).max() < 1.001 * precision
        count = [count[0] + len(mesh.triangles), count[1] + len(piece.shape.mesh.triangles)]
    assert 0 < count[0] < 0.8 * count[1]


def test_what_was_proven_is_kept_without_its_proof(tmp_path: Path) -> None:
    made = generate("drawer", seed=1)
    folder = made.export(tmp_path / "drawer", textures=0, mesh_precision=0.001)
    assert not (folder / "certificate.json").exists()
    assert record_of((folder / "asset.json").read_bytes(), "drawer")["proven"] is True
    read = Asset.load(folder)
    assert read.certificate == made.certificate
    assert made.certificate is not None
    assert made.certificate.leaves is not None  # the asset itself keeps it
    report = validate(folder, behavior=False)
    assert report.passed
    skipped = {each.check: each.skipped for each in report.results if each.skipped}
    why = "its meshes, precise to 1 mm, are not those of the solids"
    assert skipped == {"solids": why, "colliders": why, "grasps": why, "behavior": "not requested"}
    (note,) = next(each for each in report.results if each.check == "certificate").findings
    assert note.severity == "note"
    assert str(note) == (
        "the proof is not verified: an export with a mesh precision does not keep it; export with "
        "mesh_precision=0 as well"
    )


def test_what_needs_solids_says_that_there_are_none(exports: tuple[Path, Path]) -> None:
    with pytest.raises(
        AssetError,
        match=r"the meshes of link 'body' have a precision of 0\.5 mm and do not give its exact solids; "
        r"export the asset with mesh_precision=0",
    ):
        Asset.load(exports[1]).certify()


def test_shading_of_large_faces_stays_even() -> None:
    """The normals of a rounded edge do not shade the face beside it once the edge is gone."""
    microwave = generate("microwave", seed=1, certify=False)
    body = microwave.links[0]
    for piece in body.pieces:
        mesh = coarser(piece.shape, PRECISION)
        corners = mesh.vertices[mesh.triangles]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area = 0.5 * np.linalg.norm(across, axis=1)
        large = area > 0.002
        flat = across[large] / (2.0 * area[large])[:, None]
        cosine = np.einsum("ijk,ik->ij", mesh.normals[mesh.triangles[large]], flat)
        assert (cosine > np.cos(0.05)).all(), piece.label


def test_the_same_numbers_every_time(asset: Asset) -> None:
    again = generate("toaster", seed=3, certify=False)
    files = [encode(each, ("mjcf",), textures=0, mesh_precision=PRECISION) for each in (asset, again)]
    assert files[0] == files[1]


def test_an_asset_that_was_read_is_refused_and_written_again_as_it_is(
    exports: tuple[Path, Path], tmp_path: Path
) -> None:
    read = Asset.load(exports[1])
    with pytest.raises(
        AssetError, match=r"keep no solids, so its surfaces cannot be simplified within 0\.001 m"
    ):
        read.export(tmp_path / "a", mesh_precision=0.001)
    again = read.export(tmp_path / "b", formats=("mjcf", "usd"), textures=0)
    files = [
        {path.relative_to(each): path.read_bytes() for path in each.rglob("*.*")}
        for each in (exports[1], again)
    ]
    assert files[0] == files[1]


@pytest.mark.parametrize("precision", [-0.001, 0.006, float("nan")])
def test_other_precisions_are_refused(asset: Asset, tmp_path: Path, precision: float) -> None:
    with pytest.raises(
        ParameterError, match=r"surfaces are precise to 0 \(all that was made\) to 0\.005 m, not"
    ):
        asset.export(tmp_path / "a", mesh_precision=precision)
    assert not (tmp_path / "a").exists()
