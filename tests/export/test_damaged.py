"""Damaged and hostile `asset.json`: one error of artgen, with the place of the value and what is allowed."""

import json
import os
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import artgen
from artgen.asset import Asset
from artgen.errors import ArtgenError, AssetError, ExportError
from artgen.validate.files import check_certificate

Place = tuple[str | int, ...]
VALUES: tuple[Any, ...] = (
    {}, [], None, "x", -1, 1e300, float("inf"), float("nan"), "h" * 10_000, [[1]], 10**400,
)  # fmt: skip


CONTACT = {
    "links": ["body", "drawer_0"], "labels": ["box", "front"], "depth": 1.0, "when": None, "reason": "it may",
}  # fmt: skip


@pytest.fixture
def folder(cabinet: Asset, tmp_path: Path) -> Path:
    return cabinet.export(tmp_path / "asset", formats=("urdf",), textures=0)


@pytest.fixture(scope="module")
def certified() -> Asset:
    return artgen.generate("drawer", seed=3, detail="low")


def places(data: Any, place: Place = ()) -> Iterator[Place]:
    """Yield the place of every value, of the items of a list the first."""
    if place:
        yield place
    items = data.items() if isinstance(data, dict) else enumerate(data[:1]) if isinstance(data, list) else ()
    for key, value in items:
        yield from places(value, (*place, key))


def changed(text: str, place: Place, values: tuple[Any, ...]) -> Iterator[Any]:
    """Yield the data with other values in a place, without the value, and with the value twice."""
    for value in (*values, "without", "twice"):
        data = holder = json.loads(text)
        for key in place[:-1]:
            holder = holder[key]
        if value == "without":
            del holder[place[-1]]
        elif value == "twice" and isinstance(holder, list):
            holder.append(holder[place[-1]])
        else:
            holder[place[-1]] = value
        yield data


def use(asset: Asset) -> None:
    """Read what an asset has."""
    assert all((str(asset), repr(asset), asset.to_json(), asset.materials))
    assert len(asset.affordances) == sum(len(link.grasps) + len(link.pushes) for link in asset.links)
    for link in asset.links:
        assert len(link.surfaces) == len(link.to_data()["surfaces"])
        for piece in [*(each.convex for each in link.colliders), *link.covers]:
            assert np.isfinite(piece.bounds()).all()
        assert np.isfinite(link.mass_properties.principal()[0]).all()
        assert asset.origin(link.name).shape == (3,)
    asset.pose()
    asset.fk(asset.project(asset.sample_states(2)))


@pytest.mark.long
def test_every_wrong_value_is_one_error_with_its_place(folder: Path) -> None:
    text = (folder / "asset.json").read_text()
    whole = json.loads(text)
    refused = 0
    for place in places(whole):
        if place[0] in ("parameters", "digests", "formats") and len(place) > 3:
            continue
        before = whole
        for key in place:
            before = before[key]
        for data in changed(text, place, VALUES):
            (folder / "asset.json").write_text(json.dumps(data))
            try:
                use(artgen.load(folder))
            except ArtgenError as error:
                refused += 1
                message = str(error)
                names = [str(key) for key in place if isinstance(key, str)]
                found = [name for name in (*names, str(before)) if name.rstrip("s") in message]
                assert found or "links[" in message or "the path" in message, (place, message)
                assert "Error(" not in message, message
                assert len(message) < 600, message
    assert refused > 800


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        (("links",), {}, "links is {}, but it must be a list"),
        (("links", 0, "surfaces"), {}, r"links\[0\].surfaces is {}, but it must be a list"),
        (("materials", 0, "texture"), {}, r"materials\[0\].texture is {}, but it must be text"),
        (("joints", 0, "axis"), [0, 2, 0], r"joints\[0\].axis is \[0.0, 2.0, 0.0\], .* a vector of length 1"),
        (("joints", 0, "axis"), ["1", 0, 0], r"joints\[0\].axis is .* a list of 3 numbers"),
        (("joints", 0, "limits"), [1, 0], r"joints\[0\].limits is \[1, 0\], .* lowest and the highest"),
        (("joints", 0, "parent"), "roof", r"joints\[0\].parent is 'roof', .* the name of one of the links"),
        (("joints", 0, "effort"), "strong", r"joints\[0\].effort is 'strong', .* a number of at most"),
        (("joints", 1, "name"), "lid_hinge", r"joints\[1\].name is 'lid_hinge', .* it is taken"),
        (("links", 1, "mass"), 0.0, r"links\[1\].mass is 0.0, but it must be positive"),
        (
            ("links", 1, "inertia"),
            [[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.3]],
            r"links\[1\].inertia is .* a tensor of positive moments, each at most the sum of the others",
        ),
        (("joints", 0, "stiffness"), -5.0, r"joints\[0\].stiffness is -5.0, but it must be 0 or more"),
        (
            ("links", 0, "colliders", 0, "kind"),
            "cone",
            r"colliders\[0\].kind is 'cone', .* 'box', 'cylinder'",
        ),
        (("links", 0, "colliders", 0, "pose"), [[1]], r"colliders\[0\].pose is .* lists of 4 x 4 numbers"),
        (("links", 0, "colliders", 0, "material"), "mist", r"material is 'mist', .* one of the materials"),
        (("joints", 5, "follows"), {"leader": "lever"}, r"joints\[5\].follows.ratio is missing"),
        (("base",), "flying", "base is 'flying', but it must be one of 'fixed', 'free'"),
    ],
)
def test_the_message_has_value_place_and_what_is_allowed(
    folder: Path, place: Place, value: Any, message: str
) -> None:
    data = next(changed((folder / "asset.json").read_text(), place, (value,)))
    (folder / "asset.json").write_text(json.dumps(data))
    with pytest.raises(AssetError, match=rf"asset.json: .*{message}.*; export the asset again"):
        Asset.load(folder).export(folder.parent / "again", formats=("urdf",), textures=0)
    assert not (folder.parent / "again").exists()


@pytest.mark.parametrize("text", ["[" * 100_000, '{"a":' * 100_000, "", "{", "\ud800", "1" * 10_000])
def test_text_that_is_no_asset_is_one_error(folder: Path, text: str) -> None:
    (folder / "asset.json").write_bytes(text.encode("utf-8", "surrogatepass"))
    with pytest.raises((AssetError, ExportError), match=r"asset\.json"):
        artgen.load(folder)


def test_conditions_that_are_nested_too_deeply_are_one_error(folder: Path) -> None:
    text = (folder / "asset.json").read_text()
    data = json.loads(text)
    data["joints"][0]["needs"]["condition"] = "deep"
    deep = '{"kind":"all","terms":[' * 400 + '{"kind":"above","joint":"lever_turn","value":0}' + "]}" * 400
    (folder / "asset.json").write_text(json.dumps(data).replace('"deep"', deep))
    with pytest.raises((AssetError, ExportError), match=r"asset\.json"):
        use(artgen.load(folder))
    shutil.rmtree(folder)


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        (r"(?m)^v \S+", "v nan", "a number of a line 'v' is not in -1e+06..1e+06"),
        (r"(?m)^v \S+", "v 1e30", "a number of a line 'v'"),
        (r"(?m)^v \S+", "v " + "1" * 400, "a number of a line 'v'"),
        (r"(?m)^vn \S+", "vn nan", "a number of a line 'vn'"),
        (r"(?m)^vt \S+", "vt 1e300", "a number of a line 'vt'"),
        (r"(?m)^f \d+", "f 0", "whose numbers are those of 'v', 'vt' and 'vn', from 1 on"),
        (r"(?m)^f \d+", "f -1", "from 1 on"),
        (r"(?m)^f \d+", "f nan", "from 1 on"),
        (r"(?m)^f (\d+)", r"f \1.5", "from 1 on"),
        (r"(?m)^f \d+", "f 9" + "0" * 30, "from 1 on"),
        (r"(?m)^f .*\n", "", "it needs lines 'f'"),
        (r"(?m)^v \S+", "v x", "could not convert"),
    ],
)
def test_a_damaged_mesh_is_one_error_that_names_the_line(
    folder: Path, old: str, new: str, fault: str
) -> None:
    path = artgen.load(folder).links[0].meshes[0]
    text = path.read_text()
    path.write_text(re.sub(old, new, text, count=0 if not new else 1))
    assert path.read_text() != text
    with pytest.raises(
        AssetError, match=rf"{path.name} is not a mesh that artgen wrote: .*{re.escape(fault)}"
    ):
        use(artgen.load(folder))


@pytest.mark.parametrize("content", ['{"rows": [NaN]}', '{"rows": [1e999]}'])
def test_a_proof_with_numbers_that_json_lacks_is_unreadable(
    folder: Path, content: str, tmp_path: Path
) -> None:
    (folder / "certificate.json").write_text(content)
    certified = json.loads((folder / "asset.json").read_text())
    certified["certificate"] = {"tolerance": 0.0, "pairs": [], "contacts": []}
    (folder / "asset.json").write_text(json.dumps(certified))
    asset = artgen.load(folder)
    assert asset.certificate is not None
    assert "unreadable" in str(asset.certificate.leaves)
    asset.export(tmp_path / "again", formats=("urdf",), textures=0)


def test_a_loose_link_is_one_of_the_links(folder: Path) -> None:
    data = json.loads((folder / "asset.json").read_text())
    data["loose"] = [data["links"][1]["name"], "mug"]
    (folder / "asset.json").write_text(json.dumps(data))
    with pytest.raises(AssetError, match=r"loose\[1\] is 'mug', but it must be the name of one of the links"):
        artgen.load(folder)


def pipe(path: Path) -> None:
    os.mkfifo(path)


def zeros(path: Path) -> None:
    path.symlink_to("/dev/zero")


def hole(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(1 << 36)


@pytest.mark.parametrize("name", ["asset.json", "certificate.json", "meshes"])
@pytest.mark.parametrize("endless", [pipe, zeros, hole])
def test_a_file_that_never_ends_is_not_read(folder: Path, name: str, endless: Callable[[Path], None]) -> None:
    file = folder / name if name != "meshes" else artgen.load(folder).links[0].meshes[0]
    file.unlink(missing_ok=True)
    endless(file)
    if name == "certificate.json":  # the check of certificates reports it
        certified = json.loads((folder / "asset.json").read_text())
        certified["certificate"] = {"tolerance": 0.0, "pairs": [], "contacts": []}
        (folder / "asset.json").write_text(json.dumps(certified))
        certificate = artgen.load(folder).certificate
        assert certificate is not None
        assert "unreadable" in str(certificate.leaves)
        return
    with pytest.raises(
        ExportError, match=rf"cannot read .*{file.name}: it (is a device, a pipe|has more than)"
    ):
        use(artgen.load(folder))


@pytest.mark.parametrize(
    ("place", "value", "changes"),
    [
        (("joints", 0, "limits"), [0.0, 0.3], "the motion"),
        (("joints", 0, "pivot"), [0.0, 0.0, 0.5], "the motion"),
        (("joints", 0, "kind"), "revolute", "the motion"),
        (("links", 1, "colliders", 0, "pose", 0, 3), 0.4, "the motion"),
        (("contacts",), [CONTACT], "the motion"),
        (("joints", 0, "friction"), 0.2, "nothing"),
        (("parameters", "width"), 9.0, "nothing"),
    ],
)
def test_a_certificate_holds_only_for_what_it_was_made_for(
    certified: Asset, tmp_path: Path, place: Place, value: Any, changes: str
) -> None:
    folder = certified.export(tmp_path / "asset", formats=("urdf",), textures=0)
    data = next(changed((folder / "asset.json").read_text(), place, (value,)))
    (folder / "asset.json").write_text(json.dumps(data))
    asset = artgen.load(folder)
    messages = [finding.message for finding in check_certificate(asset).findings]
    assert (asset.certificate == certified.certificate) == (changes == "nothing")
    if changes != "nothing":
        assert asset.certificate is None
        assert messages[0].startswith(
            "asset.json has other colliders, joints or contacts than those that were"
        )
