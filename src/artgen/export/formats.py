"""The formats that an asset can be written in, by name."""

from collections.abc import Callable, Mapping

from artgen._caching import OPENUSD
from artgen.asset import Asset
from artgen.export.glb import write_glb
from artgen.export.losses import Written
from artgen.export.mjcf import write_mjcf
from artgen.export.urdf import write_urdf

Writer = Callable[[Asset, int], Written]


def write_usd(asset: Asset, textures: int) -> Written:
    """Write an asset as USD; see `artgen.export.usd.write_usd`."""
    with OPENUSD:
        from artgen.export.usd import write_usd as write

        return write(asset, textures)


FORMATS: Mapping[str, Writer] = {
    "urdf": write_urdf,
    "mjcf": write_mjcf,
    "usd": write_usd,
    "glb": write_glb,
}
"""The writers by the names of their formats; each takes an asset and the texels on a side of its maps."""

DEFAULT_FORMATS = ("urdf", "mjcf", "usd")
"""What simulators read; GLB is for pictures."""

TEXTURES = 512
"""Texels on a side of the maps unless more or fewer are asked for."""
