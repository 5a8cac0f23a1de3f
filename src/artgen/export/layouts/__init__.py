"""Formats and layouts of exports for simulators and readers of well-known datasets."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from artgen._arrays import OPENUSD
from artgen.asset import Asset
from artgen.export.glb import write_glb
from artgen.export.layouts.molmospaces import MOLMOSPACES
from artgen.export.layouts.partnet import PARTNET_MOBILITY
from artgen.export.layouts.parts import write_parts
from artgen.export.layouts.robocasa import ROBOCASA
from artgen.export.losses import Layout, Written
from artgen.export.mjcf import write_mjcf
from artgen.export.sdf import write_sdf
from artgen.export.urdf import write_urdf

Writer = Callable[[Asset, int], Written]


def write_usd(asset: Asset, textures: int) -> Written:
    """Write an asset as USD; see `artgen.export.usd.write_usd`."""
    with OPENUSD:
        from artgen.export.usd import write_usd as write

        return write(asset, textures)


def _write_simready(asset: Asset, name: str, textures: int) -> Written:
    with OPENUSD:
        from artgen.export.layouts.simready import write_simready

        return write_simready(asset, textures)


FORMATS: Mapping[str, Writer] = {
    "urdf": write_urdf, "mjcf": write_mjcf, "usd": write_usd, "glb": write_glb, "sdf": write_sdf,
}  # fmt: skip
"""Writers by format; each takes an asset and the number of texels per side of its maps."""

DEFAULT_FORMATS = ("urdf", "mjcf", "usd")
"""Formats that are written unless others are named; GLB is for viewers, SDFormat for Gazebo and Drake."""

TEXTURES = 512
"""Default number of texels per side of maps."""

_SUFFIXES = {"urdf": ".urdf", "mjcf": ".xml", "usd": ".usda", "glb": ".glb", "sdf": ".sdf"}


FLAT = Layout(
    "flat",
    "one file for each format beside one folder of meshes",
    tuple(FORMATS),
    DEFAULT_FORMATS,
    lambda asset, name, textures: replace(FORMATS[name](asset, textures), main=asset.name + _SUFFIXES[name]),
)


PARTS = Layout(
    "parts",
    "each asset of a room in a folder of its own, and a table of their places",
    tuple(FORMATS),
    ("urdf",),
    lambda asset, name, textures: write_parts(asset, FORMATS[name], textures),
)

SIMREADY = Layout(
    "simready",
    "USD for Isaac Sim and Omniverse, as NVIDIA's profile Robotics-Prop wants it",
    ("usd",),
    ("usd",),
    _write_simready,
)

LAYOUTS: Mapping[str, Layout] = {
    layout.name: layout for layout in (FLAT, SIMREADY, PARTNET_MOBILITY, ROBOCASA, MOLMOSPACES, PARTS)
}
"""All layouts by name."""
