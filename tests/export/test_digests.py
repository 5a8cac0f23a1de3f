"""Digests of files: of PNG files what they say, however they are packed."""

import hashlib
import zlib

import numpy as np
import pytest

from artgen.export import files as module
from artgen.export.files import digest, digests
from artgen.materials.textures.maps import png

TEXELS = (np.arange(64 * 64) % 251).astype(np.uint8).reshape(64, 64)


def repacked(content: bytes) -> bytes:
    """Return a PNG file whose texels are packed in another way."""
    start = content.index(b"IDAT") - 4
    length = int.from_bytes(content[start : start + 4], "big")
    data = zlib.compress(zlib.decompress(content[start + 8 : start + 8 + length]), 9)
    head = b"IDAT" + data
    chunk = len(data).to_bytes(4, "big") + head + zlib.crc32(head).to_bytes(4, "big")
    return content[:start] + chunk + content[start + 12 + length :]


def test_text_has_the_digest_of_its_bytes():
    assert digests({"b": b"two", "a": b"one"}) == {
        "a": hashlib.sha256(b"one").hexdigest(),
        "b": hashlib.sha256(b"two").hexdigest(),
    }


def test_packing_does_not_matter_but_texels_do():
    content = png(TEXELS)
    other = repacked(content)
    assert other != content
    assert digest(other) == digest(content)
    assert digest(png(TEXELS + 1)) != digest(content)


def test_damaged_maps_have_digests_of_their_own():
    content = png(TEXELS)
    assert digest(content[:100]) == hashlib.sha256(content[:100]).hexdigest()


def test_the_same_map_is_unpacked_once(monkeypatch):
    content = png(TEXELS + 2)
    first = digest(content)
    monkeypatch.setattr(module.zlib, "decompress", lambda data: pytest.fail("it was unpacked again"))
    assert digest(content) == first
    assert digest(bytes(bytearray(content))) == first
