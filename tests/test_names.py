"""Names and paths of foreign files: nothing outside the folder is read, overwritten or removed."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import artgen
from artgen._names import check_names, inside, is_identifier, is_plain_path
from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.dataset.places import Disk
from artgen.errors import AssetError, ExportError

HOSTILE = (
    "../../victim/config",
    "..",
    "/etc/victim",
    "a/b",
    "a\\b",
    "a\0b",
    "a\n",
    "C:x",
    "",
    " ",
    "é",
    "x" * 300,
)
PLACES: dict[str, Callable[[dict[str, Any]], tuple[dict[str, Any], str]]] = {
    "asset": lambda data: (data, "name"),
    "category": lambda data: (data, "category"),
    "link": lambda data: (data["links"][0], "name"),
    "label": lambda data: (data["links"][0], "label"),
    "surface": lambda data: (data["links"][0]["surfaces"][0], "name"),
    "material": lambda data: (data["materials"][0], "name"),
    "joint": lambda data: (data["joints"][0], "name"),
    "child": lambda data: (data["joints"][0], "child"),
    "collider": lambda data: (data["links"][0]["colliders"][0], "label"),
    "affordance": lambda data: (data["affordances"][0], "name"),
}


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    folder = artgen.generate("drawer", 0, certify=False).export(
        tmp_path_factory.mktemp("whole") / "drawer", formats=("urdf",), textures=0
    )
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


def written(files: dict[str, bytes], folder: Path, change: Callable[[dict[str, Any]], None]) -> Path:
    """Write an export whose asset.json was changed, beside a file that nobody may touch."""
    for name, content in files.items():
        (folder / "asset" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "asset" / name).write_bytes(content)
    data = json.loads(files["asset.json"])
    change(data)
    (folder / "asset" / "asset.json").write_text(json.dumps(data))
    (folder / "victim").mkdir()
    (folder / "victim" / "config").write_text("mine")
    return folder / "asset"


def snapshot(folder: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("place", PLACES)
def test_a_hostile_name_is_refused(exported: dict[str, bytes], tmp_path: Path, place: str, name: str) -> None:
    def change(data: dict[str, Any]) -> None:
        holder, key = PLACES[place](data)
        holder[key] = name

    folder = written(exported, tmp_path, change)
    before = snapshot(tmp_path)
    with pytest.raises(AssetError, match=r"asset\.json: \w+.* is no.* identifier; use letters, digits and _"):
        Asset.load(folder).export(tmp_path / "out" / "deep" / "asset", formats=("urdf", "mjcf", "usd"))
    assert snapshot(tmp_path) == before


PATHS = [name for name in HOSTILE if name != "a/b" and len(name) < 300]


@pytest.mark.parametrize("path", PATHS)
def test_a_hostile_path_is_refused(exported: dict[str, bytes], tmp_path: Path, path: str) -> None:
    def change(data: dict[str, Any]) -> None:
        data["formats"]["urdf"]["main"] = path
        data["formats"]["urdf"]["files"].append(path)

    folder = written(exported, tmp_path, change)
    for read in (Asset.load, main_files):
        with pytest.raises(AssetError, match="must be relative and stay in the folder of the asset"):
            read(folder)


def test_files_of_a_hostile_list_are_not_replaced(exported: dict[str, bytes], tmp_path: Path) -> None:
    """What a foreign asset.json calls files of the export is not removed with it."""
    folder = written(
        exported, tmp_path, lambda data: data["formats"]["urdf"]["files"].append("../victim/config")
    )
    asset = artgen.generate("drawer", 0, certify=False)
    with pytest.raises(ExportError, match="is no earlier export of artgen"):
        asset.export(folder, formats=("urdf",), textures=0)
    assert (tmp_path / "victim" / "config").read_text() == "mine"


@given(
    st.one_of(
        st.text(), st.lists(st.sampled_from(["..", ".", "", "a", "a.b", "~", "C:", "\\"])).map("/".join)
    )
)
def test_a_plain_path_stays_in_its_folder(path: str) -> None:
    if is_plain_path(path):
        place = inside(Path("/nowhere/folder"), path)
        assert place.is_relative_to("/nowhere/folder")
        assert ".." not in place.parts
        assert place != Path("/nowhere/folder")
    else:
        with pytest.raises(ExportError, match="it must be a relative path that stays there"):
            inside(Path("/nowhere/folder"), path)


@given(st.text())
def test_an_identifier_is_a_plain_path(name: str) -> None:
    assert not is_identifier(name) or is_plain_path(name)


def test_a_link_that_leads_outside_is_refused(tmp_path: Path) -> None:
    (tmp_path / "outside").mkdir()
    (tmp_path / "set").mkdir()
    (tmp_path / "set" / "door").symlink_to(tmp_path / "outside", target_is_directory=True)
    (tmp_path / "set" / "dataset.json").symlink_to(tmp_path / "outside" / "file")
    disk = Disk(tmp_path / "set")
    with disk.opened():
        for write in (
            lambda: disk.write("door/table", b""),
            lambda: disk.write("dataset.json", b""),
            lambda: disk.put({"asset.json": b""}, "door/door_0", share=False),
        ):
            with pytest.raises(ExportError, match="a symbolic link leads out of"):
                write()
    assert list((tmp_path / "outside").iterdir()) == []


def test_a_manifest_cannot_name_other_folders(tmp_path: Path) -> None:
    artgen.dataset.generate_many(
        artgen.dataset.Plan(("handle",), 1, formats=("urdf",), textures="none"), tmp_path / "set"
    )
    manifest = tmp_path / "set" / "manifest.jsonl"
    record = json.loads(manifest.read_text())
    manifest.write_text(json.dumps(record | {"path": "../../victim"}) + "\n")
    with pytest.raises(ExportError, match=r"line 1 is damaged \(cannot use '../../victim' below"):
        artgen.Dataset(tmp_path / "set")


def test_parameters_may_have_the_names_of_fields(tmp_path: Path) -> None:
    """Of an asset, and of an asset in a room."""
    placed = [{"name": "box", "parameters": {"label": True, "name": "a b"}}]
    check_names({"name": "room", "parameters": {"label": 0.5}, "placed": placed}, tmp_path)
    with pytest.raises(AssetError, match=r"placed\[0\]\.name 'a b' is no identifier"):
        check_names({"name": "room", "placed": [{"name": "a b"}]}, tmp_path)


def test_a_link_name_can_be_too_long() -> None:
    part = artgen.part(artgen.box(0.1, 0.1, 0.1), "b" * 300, artgen.material("oak"))
    with pytest.raises(
        artgen.errors.EvaluationError, match="no identifier; use letters, digits and _, at most 100"
    ):
        artgen.Graph(part).evaluate()
