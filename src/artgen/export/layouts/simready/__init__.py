"""Layout of NVIDIA's SimReady profile: a light interface layer, with a variant per simulator."""

from artgen._arrays import OPENUSD
from artgen.asset import Asset
from artgen.export.losses import Layout, Written


def write_simready(asset: Asset, name: str, textures: int) -> Written:
    """Write one format of an asset; see `Layout.write` and `artgen.export.layouts.simready.usd`."""
    del name  # USD is its only format
    with OPENUSD:
        from artgen.export.layouts.simready.usd import write_package

        return write_package(asset, textures)


SIMREADY = Layout(
    "simready",
    "USD for Isaac Sim and Omniverse, as NVIDIA's profile Robotics-Prop wants it",
    ("usd",),
    1,
    write_simready,
)
"""One folder named like the asset; see `artgen.export.layouts.simready.usd`."""
