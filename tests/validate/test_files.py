"""The check of an export's files knows the maps: there, whole, and none that is named in vain."""

import struct
import zlib
from collections.abc import Iterator
from pathlib import Path

import pytest
from PIL import Image, ImageOps

import artgen
from artgen.asset import Asset
from artgen.export import export
from artgen.validate.files import read_export
from artgen.validate.readback import check_formats
from support.exports import edit_json
from support.textured import recipes, textured

AGAIN = "export the asset again"


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    return export(textured(), tmp_path / "it", textures=256)


def found(directory: Path) -> list[str]:
    return [str(finding) for finding in read_export(directory).result.findings]


def a_map(directory: Path, kind: str) -> Path:
    return next(iter(sorted((directory / "meshes/textures").glob(f"*_{kind}*.png"))))


def test_maps_are_files_of_the_export(directory: Path) -> None:
    assert not found(directory)


def test_missing_map_is_named_with_the_formats_that_need_it(directory: Path) -> None:
    path = a_map(directory, "albedo")
    path.unlink()
    (text,) = found(directory)
    assert f"meshes/textures/{path.name} is missing, which urdf and mjcf and usd need" in text
    assert AGAIN in text


@pytest.mark.parametrize("cut", [10, 400])
def test_damaged_map_is_no_image(directory: Path, cut: int) -> None:
    path = a_map(directory, "normal")
    path.write_bytes(path.read_bytes()[:cut])
    (text,) = found(directory)
    assert f"meshes/textures/{path.name} is not a readable image, which urdf" in text


def test_map_that_nobody_wrote_is_a_fault_among_textures(directory: Path) -> None:
    (directory / "meshes/textures/old.png").write_bytes(b"old")
    (text,) = found(directory)
    assert "meshes/textures/old.png is not listed in asset.json" in text


def test_map_that_was_painted_anew_is_a_note(directory: Path) -> None:
    path = a_map(directory, "albedo")
    with Image.open(path) as image:
        ImageOps.invert(image.convert("RGB")).save(path)
    result = read_export(directory).result
    (finding,) = result.findings
    assert finding.severity == "note"
    assert f"meshes/textures/{path.name} was changed after the export" in finding.message
    assert "keep it if the change was intended" in finding.hint
    assert not result.faults


def test_map_that_was_packed_anew_is_the_same(directory: Path) -> None:
    """Machines differ in how they pack; the digest is of what the file says unpacked."""
    path = a_map(directory, "albedo")
    content = path.read_bytes()
    start = content.index(b"IDAT")
    (length,) = struct.unpack_from(">I", content, start - 4)
    packed = zlib.compress(zlib.decompress(content[start + 4 : start + 4 + length]), 9)
    chunk = b"IDAT" + packed
    anew = struct.pack(">I", len(packed)) + chunk + struct.pack(">I", zlib.crc32(chunk))
    path.write_bytes(content[: start - 4] + anew + content[start + 8 + length :])
    assert path.read_bytes() != content
    assert not found(directory)


@pytest.mark.parametrize(
    ("suffix", "severity"), [(".urdf", "note"), (".xml", "note"), (".usda", "note"), (".mtl", "note")]
)
def test_comment_in_what_other_checks_compare_is_a_note(directory: Path, suffix: str, severity: str) -> None:
    (path,) = directory.rglob(f"*{suffix}")
    comment = {".urdf": "<!-- mine -->", ".xml": "<!-- mine -->"}.get(suffix, "# mine")
    path.write_text(f"{path.read_text()}{comment}\n")
    assert [finding.severity for finding in read_export(directory).result.findings] == [severity]


def test_mesh_that_was_changed_is_a_fault(directory: Path) -> None:
    path = min(directory.rglob("*.obj"))
    path.write_text(f"{path.read_text()}# mine\n")
    (finding,) = read_export(directory).result.faults
    assert finding.hint == "export the asset again; keep files of your own in another directory"


def test_sets_of_states_belong_to_an_export(tmp_path: Path) -> None:
    directory = export(textured(), tmp_path / "it", formats=("urdf",), textures=0, states=3)
    assert not found(directory)
    (directory / "states.npz").write_bytes(b"other states")
    (message,) = found(directory)
    assert message.startswith(
        "states.npz was changed after the export: its digest is not the one in asset.json"
    )
    (directory / "states.npz").unlink()
    (message,) = found(directory)
    assert message.startswith("states.npz is missing, which the set of valid states needs")


def test_a_file_without_links_for_grasps_says_so(tmp_path: Path) -> None:
    plain = artgen.generate("switch", 0).export(tmp_path / "it", formats=("urdf",), textures=0, frames=False)
    asset = Asset.load(plain)
    assert [each.faults for each in check_formats(asset, plain)] == [()]
    edit_json(plain / "asset.json", lambda data: data["formats"]["urdf"].update(losses=[]))
    ((fault,),) = [each.faults for each in check_formats(asset, plain)]
    assert fault.message == "switch_0.urdf has no frame of the grasp 'knob_grasp'"


def test_export_without_digests_does_not_tell_what_was_changed(directory: Path) -> None:
    edit_json(directory / "asset.json", lambda data: data.pop("digests"))
    (message,) = found(directory)
    assert message.startswith("asset.json has no digest of ")
    assert message.endswith("so changes cannot be noticed; export the asset again")


def test_maps_alone_are_no_visible_faces(tmp_path: Path) -> None:
    exported = read_export(export(textured(), tmp_path / "it", formats=("usd",), textures=256))
    assert not exported.meshes
    assert not exported.result.findings
