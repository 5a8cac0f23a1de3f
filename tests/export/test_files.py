"""Exports appear whole or not at all, keep what is not artgen's, and can be read back."""

import dataclasses
import errno
import json
import os
import shutil
import stat
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest

import artgen
from artgen.asset import Asset
from artgen.asset.files import load
from artgen.errors import AssetError, ExportError, ParameterError
from artgen.export import export

FORMATS = ("urdf", "mjcf")


def tree(directory: Path) -> dict[str, bytes]:
    """Return every file below a directory, hidden ones and siblings' leftovers included."""
    return {
        path.relative_to(directory).as_posix(): path.read_bytes()
        for path in sorted(directory.rglob("*"))
        if path.is_file()
    }


def full_disk(*arguments: object, **keywords: object) -> NoReturn:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def after(calls: int, method: Callable[..., object], failure: Callable[..., object]) -> Callable[..., object]:
    """Return a method that works for a number of calls and then fails."""
    left = [calls]

    def wrapped(*arguments: object, **keywords: object) -> object:
        left[0] -= 1
        return (method if left[0] >= 0 else failure)(*arguments, **keywords)

    return wrapped


def test_files_of_every_format_are_recorded(cabinet: Asset, tmp_path: Path) -> None:
    directory = export(cabinet, tmp_path / "cabinet", formats=FORMATS)
    assert directory == tmp_path / "cabinet"
    data = json.loads((directory / "asset.json").read_text())
    recorded = {path for record in data["formats"].values() for path in record["files"]}
    assert recorded | {"asset.json"} == set(tree(directory))
    assert {"cabinet_7.urdf", "cabinet_7.xml", "meshes/cabinet_7.mtl"} <= recorded
    features = {loss["feature"] for loss in data["formats"]["urdf"]["losses"]}
    assert "joint spring" in features


def test_every_format_is_written_unless_told_otherwise(nested: Asset, tmp_path: Path) -> None:
    data = json.loads((nested.export(tmp_path / "arm") / "asset.json").read_text())
    assert list(data["formats"]) == ["urdf", "mjcf", "usd"]
    assert {"arm_1.urdf", "arm_1.xml", "arm_1.usda"} <= set(tree(tmp_path / "arm"))


@pytest.mark.parametrize("fixture", ["cabinet", "free_cabinet", "nested"])
def test_read_back_it_is_the_same_asset(fixture: str, request: pytest.FixtureRequest, tmp_path: Path) -> None:
    asset: Asset = request.getfixturevalue(fixture)
    loaded = Asset.load(export(asset, tmp_path / "it", formats=FORMATS))
    assert loaded.to_data() == json.loads(json.dumps(asset.to_data()))
    assert loaded.mass == pytest.approx(asset.mass, rel=1e-11)
    for name, transform in asset.pose().items():
        np.testing.assert_allclose(loaded.pose()[name], transform, atol=1e-11)
    for link in asset.links:
        for found, surface in zip(loaded.link(link.name).surfaces, link.surfaces, strict=True):
            np.testing.assert_allclose(found.mesh.vertices, surface.mesh.vertices, atol=1e-7)
            np.testing.assert_allclose(found.mesh.normals, surface.mesh.normals, atol=1e-5)
            np.testing.assert_allclose(found.mesh.uvs, surface.mesh.uvs, atol=1e-6)
            np.testing.assert_array_equal(found.mesh.triangles, surface.mesh.triangles)


def test_asset_read_back_is_exported_to_the_same_bytes(cabinet: Asset, tmp_path: Path) -> None:
    first = export(cabinet, tmp_path / "first", formats=FORMATS)
    second = export(load(first), tmp_path / "second", formats=FORMATS)
    assert tree(first) == tree(second)


def test_asset_without_meshes_has_numbers_but_no_surfaces(cabinet: Asset, tmp_path: Path) -> None:
    loaded = load(export(cabinet, tmp_path / "cabinet", formats=()))
    assert loaded.to_data() == json.loads(json.dumps(cabinet.to_data()))
    with pytest.raises(
        AssetError, match=r"there is no .*\.obj: .*'flat' or 'robocasa' with 'urdf' or 'mjcf'"
    ):
        _ = loaded.links[0].surfaces


def test_link_read_back_refuses_to_be_changed(cabinet: Asset, tmp_path: Path) -> None:
    loaded = load(export(cabinet, tmp_path / "cabinet", formats=()))
    with pytest.raises(AssetError, match="'lid' was read from files and cannot be changed"):
        loaded.link("lid").moved(np.eye(4))


def test_directory_that_is_no_export_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match=r"cannot read .*asset\.json.*is this a directory that artgen"):
        load(tmp_path)
    (tmp_path / "asset.json").write_text('{"format": "other"}')
    with pytest.raises(AssetError, match="has format 'other'; this version reads 'artgen-asset-1'"):
        load(tmp_path)
    (tmp_path / "asset.json").write_text('{"format": "artgen-asset-1"}')
    with pytest.raises(AssetError, match=r"asset\.json: name is missing; export the asset again"):
        load(tmp_path)


def test_unknown_format_names_the_nearest(cabinet: Asset, tmp_path: Path) -> None:
    with pytest.raises(ExportError, match=r"there is no format 'mjfc'\. Did you mean 'mjcf'\?"):
        export(cabinet, tmp_path / "cabinet", formats=("urdf", "mjfc"))
    assert not (tmp_path / "cabinet").exists()


@pytest.mark.parametrize("textures", [None, 300, "512"])
def test_maps_of_no_such_size_are_refused(cabinet: Asset, tmp_path: Path, textures: object) -> None:
    with pytest.raises(ParameterError, match=f"texels on a side, not {textures!r}"):
        export(cabinet, tmp_path / "cabinet", textures=textures)  # type: ignore[arg-type]
    assert not (tmp_path / "cabinet").exists()


def test_a_name_that_is_no_identifier_is_refused(cabinet: Asset, tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match=r"name = 'a b' is no identifier; use letters, digits and _"):
        export(dataclasses.replace(cabinet, name="a b"), tmp_path / "cabinet")
    assert not (tmp_path / "cabinet").exists()


def test_new_export_replaces_the_old_and_keeps_what_is_not_artgens(
    cabinet: Asset, nested: Asset, tmp_path: Path
) -> None:
    directory = export(cabinet, tmp_path / "it", formats=FORMATS)
    (directory / "notes").mkdir()
    (directory / "notes" / "mine.txt").write_text("keep me")
    (directory / "meshes" / "mine.obj").write_text("keep me too")
    export(nested, directory, formats=("urdf",))
    files = tree(directory)
    assert files["notes/mine.txt"] == b"keep me"
    assert files["meshes/mine.obj"] == b"keep me too"
    assert "arm_1.urdf" in files
    assert not [path for path in files if "cabinet" in path]
    assert [path.name for path in tmp_path.iterdir()] == ["it"]


def test_directory_with_other_files_is_refused(cabinet: Asset, tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("years of work")
    with pytest.raises(ExportError, match=r"it holds 'thesis\.tex' and is no earlier export.*choose another"):
        export(cabinet, tmp_path, formats=FORMATS)
    assert tree(tmp_path) == {"thesis.tex": b"years of work"}


def test_file_in_the_way_of_a_new_one_is_refused(cabinet: Asset, tmp_path: Path) -> None:
    directory = export(cabinet, tmp_path / "it", formats=("urdf",))
    (directory / "cabinet_7.xml").write_text("written by hand")
    before = tree(tmp_path)
    with pytest.raises(ExportError, match=r"'cabinet_7\.xml' is not artgen's and would be overwritten; move"):
        export(cabinet, directory, formats=FORMATS)
    assert tree(tmp_path) == before


def test_file_at_the_place_of_the_directory_is_refused(cabinet: Asset, tmp_path: Path) -> None:
    (tmp_path / "it").write_text("a file")
    with pytest.raises(ExportError, match="it is a file; choose another directory"):
        export(cabinet, tmp_path / "it", formats=FORMATS)


def test_empty_directory_is_used(cabinet: Asset, tmp_path: Path) -> None:
    (tmp_path / "it").mkdir()
    assert "cabinet_7.urdf" in tree(export(cabinet, tmp_path / "it", formats=FORMATS))


def test_working_directory_is_refused(
    cabinet: Asset, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ExportError, match="cannot be replaced as a whole; choose a directory in it"):
        export(cabinet, ".", formats=FORMATS)


@pytest.mark.parametrize("earlier", [False, True])
@pytest.mark.parametrize("written", [0, 3, 9])
def test_full_disk_changes_nothing(
    cabinet: Asset, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, earlier: bool, written: int
) -> None:
    target = tmp_path / "deep" / "deeper" / "it"
    if earlier:
        export(cabinet, target, formats=("urdf",))
    before = tree(tmp_path)
    monkeypatch.setattr(Path, "write_bytes", after(written, Path.write_bytes, full_disk))
    with pytest.raises(
        ExportError, match=r"'cabinet_7' to .*it: No space left on device; nothing was changed"
    ):
        export(cabinet, target, formats=FORMATS)
    monkeypatch.undo()
    assert tree(tmp_path) == before
    assert earlier or not list(tmp_path.iterdir())


def test_unwritable_place_is_named_with_the_reason(
    cabinet: Asset, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def denied(*arguments: object, **keywords: object) -> NoReturn:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(Path, "mkdir", denied)
    with pytest.raises(ExportError, match=r"cannot write asset 'cabinet_7' to .*/it: Permission denied"):
        export(cabinet, tmp_path / "it", formats=FORMATS)


@pytest.mark.parametrize("renames", [0, 1])
@pytest.mark.parametrize("failure", [KeyboardInterrupt, full_disk])
def test_failure_while_swapping_puts_the_old_directory_back(
    cabinet: Asset,
    nested: Asset,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    renames: int,
    failure: Callable[..., object],
) -> None:
    def fail(*arguments: object) -> NoReturn:
        monkeypatch.undo()
        raise KeyboardInterrupt if failure is KeyboardInterrupt else OSError(errno.EIO, "Input/output error")

    export(cabinet, tmp_path / "it", formats=("urdf",))
    before = tree(tmp_path)
    monkeypatch.setattr(Path, "rename", after(renames, Path.rename, fail))
    with pytest.raises((KeyboardInterrupt, ExportError)):
        export(nested, tmp_path / "it", formats=("urdf",))
    assert tree(tmp_path) == before


def test_what_a_killed_process_left_is_cleared_by_the_next(
    cabinet: Asset, nested: Asset, tmp_path: Path
) -> None:
    """Killed between two renames: the old directory is set aside, the new one is not in place."""
    directory = export(cabinet, tmp_path / "it", formats=("urdf",))
    (directory / "mine.txt").write_text("keep me")
    directory.rename(tmp_path / ".it.previous")
    (tmp_path / ".it.partial").mkdir()
    (tmp_path / ".it.partial" / "half.obj").write_text("v 0 0")
    export(nested, directory, formats=("urdf",))
    assert [path.name for path in tmp_path.iterdir()] == ["it"]
    assert tree(directory)["mine.txt"] == b"keep me"
    assert "half.obj" not in tree(directory)


@pytest.mark.parametrize("file", ["", "asset.json"])
def test_what_a_killed_process_set_aside_can_be_read(cabinet: Asset, tmp_path: Path, file: str) -> None:
    directory = export(cabinet, tmp_path / "it", formats=("urdf",))
    before = tree(directory)
    directory.rename(tmp_path / ".it.previous")
    loaded = load(directory / file)
    assert loaded.to_data() == json.loads(json.dumps(cabinet.to_data()))
    assert len(loaded.link("lid").surfaces[0].mesh.triangles)
    assert tree(tmp_path) == {f".it.previous/{path}": content for path, content in before.items()}


def test_new_directory_is_read_before_what_was_set_aside(
    cabinet: Asset, nested: Asset, tmp_path: Path
) -> None:
    """Killed after both renames: the old directory is still to be removed."""
    export(cabinet, tmp_path / "it", formats=("urdf",)).rename(tmp_path / ".it.previous")
    export(nested, tmp_path / "new", formats=("urdf",)).rename(tmp_path / "it")
    assert load(tmp_path / "it").name == nested.name
    export(nested, tmp_path / "it", formats=("urdf",))
    assert [path.name for path in tmp_path.iterdir()] == ["it"]


def test_files_set_aside_outlive_an_empty_directory_in_their_place(
    cabinet: Asset, nested: Asset, tmp_path: Path
) -> None:
    directory = export(cabinet, tmp_path / "it", formats=("urdf",))
    (directory / "mine.txt").write_text("keep me")
    directory.rename(tmp_path / ".it.previous")
    directory.mkdir()
    assert load(directory).name == cabinet.name
    export(nested, directory, formats=("urdf",))
    assert load(directory).name == nested.name
    assert tree(directory)["mine.txt"] == b"keep me"
    assert [path.name for path in tmp_path.iterdir()] == ["it"]


def test_process_killed_while_writing_leaves_no_directory(tmp_path: Path) -> None:
    """Kill a process by its own hand halfway through its files."""
    script = """
import os, sys
from pathlib import Path
import numpy as np
from artgen.asset import Asset, Link, Piece, Shape, Tree
from artgen.colliders import Exact, Convex
from artgen.export import export
from support.exports import edit_json
from artgen.materials import material
corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
pieces = Exact((Convex("hull", np.eye(4), (), corners),))
shape = Shape.from_mesh(corners, corners, corners[:, :2], faces, pieces)
asset = Asset.from_tree(Tree(Link("a", "a", (Piece("a", material("oak"), shape),))), "a", "a")
write, left = Path.write_bytes, [2]
def dying(self, content):
    left[0] -= 1
    if left[0] < 0:
        os._exit(9)
    return write(self, content)
Path.write_bytes = dying
export(asset, sys.argv[1], formats=("mjcf",))
"""
    target = tmp_path / "it"
    path = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    result = subprocess.run([sys.executable, "-c", script, str(target)], env=path, check=False)
    assert result.returncode == 9
    assert not target.exists()
    shutil.rmtree(tmp_path / ".it.partial")


def test_export_is_deterministic(tmp_path: Path, make_asset: Callable[[str], Asset]) -> None:
    first = tree(export(make_asset("cabinet"), tmp_path / "first", formats=FORMATS))
    second = tree(export(make_asset("cabinet"), tmp_path / "second", formats=FORMATS))
    assert first == second


def test_export_is_light_to_import() -> None:
    code = (
        "import sys, artgen.export; "
        "heavy = {'pxr', 'mujoco', 'yourdfpy', 'trimesh', 'lxml', 'scipy', 'fcl', 'coacd'}; "
        "sys.exit(', '.join(sorted(heavy & set(sys.modules))) or 0)"
    )
    path = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    subprocess.run([sys.executable, "-c", code], env=path, check=True)


def test_threads_that_export_to_one_folder_wait_for_each_other(cabinet: Asset, tmp_path: Path) -> None:
    other = artgen.generate("plier", 1, certify=False)
    folder, errors = tmp_path / "new" / "it", []

    def write(asset: Asset) -> None:
        for _ in range(6):
            try:
                export(asset, folder, formats=("urdf",), textures=0)
            except ExportError as error:
                errors.append(error)

    threads = [threading.Thread(target=write, args=(asset,)) for asset in (cabinet, other, cabinet)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not errors
    assert [path.name for path in folder.parent.iterdir()] == ["it"]
    kept = artgen.load(folder)
    assert {path.name for path in folder.glob("*.urdf")} == {f"{kept.name}.urdf"}


@pytest.mark.skipif(os.name == "nt", reason="no groups and permissions of this kind")
def test_a_folder_keeps_its_permissions(cabinet: Asset, tmp_path: Path) -> None:
    (tmp_path / "it").mkdir()
    (tmp_path / "it").chmod(0o2770)
    for _ in range(2):
        export(cabinet, tmp_path / "it", formats=("urdf",), textures=0)
        assert stat.S_IMODE((tmp_path / "it").stat().st_mode) == 0o2770
