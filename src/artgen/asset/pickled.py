"""Assets between processes: the numbers of `asset.json` and the surfaces, without their solids."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from artgen.asset.asset import Asset, remember
from artgen.asset.certificate import Certificate
from artgen.asset.files import as_stored, asset_from_data
from artgen.asset.link import Surface

Packed = tuple[Mapping[str, Any], Mapping[str, tuple[Surface, ...]], Certificate | None]


def pack(asset: Asset) -> Packed:
    """Return what is sent of an asset: its data, the surfaces of its links, and its certificate."""
    stored = as_stored(asset)
    return stored.to_data(), {link.name: link.surfaces for link in stored.links}, asset.certificate


def unpack(*packed: Any) -> Asset:
    """Return the asset of what `pack` returned; like one read from files, it keeps no solids."""
    data, surfaces, certificate = packed
    asset = asset_from_data({**data, "certificate": None}, Path())
    for link in asset.links:
        # a cached property lives in its instance's dictionary; found there, no file is read
        vars(link)["surfaces"] = surfaces[link.name]
    if certificate is not None:
        remember(asset, certificate)
    return asset
