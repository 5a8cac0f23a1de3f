"""The table of concepts says what the writers write, and all that they report as lost."""

import json
import re
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from concepts.concept import FORMAT_TITLES
from concepts.page import concept_page
from concepts.table import CONCEPTS
from pxr import Sdf

from artgen.asset import AllowedContact, Asset, Push
from artgen.asset import AssetJoint as Joint
from artgen.export.files import encode
from artgen.export.layouts import FORMATS

PAGE = Path(__file__).parents[2] / "docs" / "concept_mapping.md"


def rich(asset: Asset) -> Asset:
    """Return the cabinet with what it lacks: a push, and a contact by design."""
    push = Push("knob_face", np.eye(4))
    links = [replace(link, pushes=(push,)) if link.name == "knob" else link for link in asset.links]
    contact = AllowedContact(("body", "lid"), ("body", "lid"), 0.001, "a gasket")
    return replace(asset, links=tuple(links), contacts=(contact,))


@pytest.fixture(scope="module")
def assets(cabinet: Asset, free_cabinet: Asset, nested: Asset) -> list[Asset]:
    """Assets that have every concept between them."""
    strong = replace(cabinet.joint("lever_turn"), stiffness=1e3)
    slide = replace(cabinet.joint("tray_slide"), limits=None)
    changed: dict[str, Joint] = {"lever_turn": strong, "tray_slide": slide}
    odd = replace(cabinet, joints=tuple(changed.get(joint.name, joint) for joint in cabinet.joints))
    return [rich(cabinet), free_cabinet, odd, nested]


def text_of(path: str, content: bytes) -> str:
    """Return what a file says; of binary ones, their words."""
    if path.endswith(".glb"):
        length = struct.unpack("<I", content[12:16])[0]
        return content[20 : 20 + length].decode()
    return content.decode() if path.endswith((".urdf", ".xml", ".usda", ".mtl", ".sdf")) else ""


@pytest.fixture(scope="module")
def said(assets: list[Asset], tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What all files of each format say."""
    result = dict.fromkeys(FORMATS, "")
    for asset in assets:
        for name in FORMATS:
            files = encode(asset, (name,), textures=256)
            for path, content in files.items():
                if path.endswith(".usdc"):
                    place = tmp_path_factory.mktemp("layers") / Path(path).name
                    place.write_bytes(content)
                    result[name] += Sdf.Layer.FindOrOpen(str(place)).ExportToString()
                else:
                    result[name] += text_of(path, content)
    return result


@pytest.fixture(scope="module")
def lost(assets: list[Asset]) -> dict[str, set[str]]:
    """The features that the writers report as lost, with and without maps."""
    result: dict[str, set[str]] = {name: set() for name in FORMATS}
    for asset in assets:
        for name in FORMATS:
            for textures in (0, 256):
                record = json.loads(encode(asset, (name,), textures=textures)["asset.json"])["formats"]
                result[name] |= {loss["feature"] for loss in record[name]["losses"]}
    return result


def test_the_page_is_that_of_the_table() -> None:
    assert PAGE.read_text(encoding="utf-8") == concept_page(), "run scripts/concept_mapping.py"


def test_every_format_has_a_column() -> None:
    assert set(FORMAT_TITLES) == set(FORMATS)
    assert all(set(concept.cells) == set(FORMATS) for concept in CONCEPTS)


@pytest.mark.parametrize("name", FORMATS)
def test_the_words_of_the_table_stand_in_the_files(said: dict[str, str], name: str) -> None:
    for concept in CONCEPTS:
        for word in re.findall(r"`([^`]+)`", concept.cells[name].text):
            assert word in said[name], f"{concept.name}: {name} does not say {word}"


@pytest.mark.parametrize("name", FORMATS)
def test_the_losses_of_the_table_are_those_of_the_writer(lost: dict[str, set[str]], name: str) -> None:
    listed = {loss for concept in CONCEPTS for loss in concept.cells[name].losses}
    assert lost[name] - listed == set(), f"{name} reports losses that the table has not"
    assert listed - lost[name] - {"animation"} == set(), f"the table has losses that {name} never reports"


def test_the_fields_are_those_of_asset_json(assets: list[Asset]) -> None:
    data = json.loads(encode(assets[0], ())["asset.json"])
    for concept in CONCEPTS:
        first = ""
        for field in filter(None, concept.field.split(", ")):
            first = first if field.startswith(".") else field.rpartition(".")[0]
            value = data
            for step in (first + field if field.startswith(".") else field).split("."):
                assert step.removesuffix("[]") in value, f"{concept.name}: asset.json has no {field}"
                value = value[step.removesuffix("[]")]
                value = value[0] if step.endswith("[]") else value
