"""The default layout: one main file for each format, and a directory of meshes that formats share."""

from dataclasses import replace

from artgen.asset import Asset
from artgen.export.formats import DEFAULT_FORMATS, FORMATS
from artgen.export.layouts.layout import Layout
from artgen.export.losses import Written

SUFFIXES = {"urdf": ".urdf", "mjcf": ".xml", "usd": ".usda", "glb": ".glb"}
"""Ending of the main file of each format; its stem is the name of the asset."""


def write_flat(asset: Asset, name: str, textures: int) -> Written:
    """Write one format of an asset; see `Layout.write`."""
    return replace(FORMATS[name](asset, textures), main=asset.name + SUFFIXES[name])


FLAT = Layout(
    "flat",
    "one file for each format beside one folder of meshes",
    tuple(FORMATS),
    len(DEFAULT_FORMATS),
    write_flat,
)
