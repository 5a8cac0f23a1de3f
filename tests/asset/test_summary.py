"""What a person reads of an asset: its text, its card in a notebook, and its links and joints by name."""

import base64
import copy
import re
from io import BytesIO

import pytest
from PIL import Image

import artgen
from artgen.errors import AssetError


@pytest.fixture(scope="module")
def microwave() -> artgen.Asset:
    return artgen.generate("microwave", seed=1, certify=False, controls="keypad")


def test_the_text_has_the_facts_in_about_ten_lines(microwave: artgen.Asset) -> None:
    text = str(microwave)
    lines = text.splitlines()
    assert lines[0] == "microwave_1: microwave, seed 1"
    assert len(lines) <= 11
    assert max(map(len, lines)) <= 130
    low, high = microwave.bounds()
    assert f"{high[0] - low[0]:.3g} x {high[1] - low[1]:.3g} x {high[2] - low[2]:.3g} m" in text
    assert f"{microwave.mass:.3g} kg" in text
    assert f"{len(microwave.links)} links" in text
    assert re.search(r"door_hinge +revolute 0 to \S+ rad \(0 to \d+ degrees\)", text)
    assert re.search(r"plate_spin +revolute unlimited \[rad\]", text)
    assert re.search(r"ring_spin +revolute unlimited \[rad\], follows plate_spin", text)
    assert f"and {len(microwave.joints) - 3} more: key_slide_0" in text
    assert "not certified: certify() proves that no two links collide" in text
    assert f"{sum(len(link.colliders) for link in microwave.links)} convex colliders" in text
    assert "controls=keypad" in text


def test_the_text_says_what_is_proven() -> None:
    asset = artgen.generate("handle", seed=0)
    assert str(asset.certificate).splitlines()[0] in str(asset)
    assert "handle_0" in repr(asset)
    assert "\n" not in repr(asset)


def test_a_notebook_shows_a_light_card_with_a_picture(microwave: artgen.Asset) -> None:
    card = microwave._repr_html_()
    assert len(card) < 40_000
    assert "microwave_1: microwave, seed 1" in card
    assert "door_hinge" in card
    (picture,) = re.findall(r'src="data:image/jpeg;base64,([^"]+)"', card)
    with Image.open(BytesIO(base64.b64decode(picture))) as image:
        assert len(image.convert("L").getcolors(1 << 16)) > 50  # it is not empty


def test_links_and_joints_are_read_by_name(microwave: artgen.Asset) -> None:
    assert microwave.joints["door_hinge"] is microwave.joint("door_hinge") is microwave.joints[0]
    assert microwave.links["door"] is microwave.link("door")
    assert microwave.links.names == tuple(link.name for link in microwave.links)
    assert isinstance(microwave.joints[:2], tuple)
    assert isinstance(microwave.joints, tuple)


def test_copies_are_read_by_name_too(microwave: artgen.Asset) -> None:
    changed = copy.replace(microwave, joints=microwave.joints[:1]) if hasattr(copy, "replace") else microwave
    assert changed.joints["door_hinge"].name == "door_hinge"
    assert microwave.with_limits("independent").rounded().links["door"].name == "door"


def test_an_unknown_name_gives_the_nearest_and_the_others(microwave: artgen.Asset) -> None:
    with pytest.raises(AssetError) as caught:
        microwave.joints["dor_hinge"]
    message = str(caught.value)
    assert message.startswith(
        "asset 'microwave_1' has no joint 'dor_hinge'. Did you mean 'door_hinge'? It has: door"
    )
    assert "plate_spin" in message
    assert "\n" not in message
    with pytest.raises(AssetError, match=r"has no link 'lid'. Allowed: body, door"):
        microwave.links["lid"]
    with pytest.raises(AssetError, match=r"has no joint None. Allowed: door"):
        microwave.joint(None)


def test_load_reads_what_export_wrote(microwave: artgen.Asset, tmp_path) -> None:
    folder = microwave.export(tmp_path / "out", formats=("glb",), textures=0)
    read = artgen.load(folder)
    assert read.joints["door_hinge"].limits == pytest.approx(microwave.joints["door_hinge"].limits)
