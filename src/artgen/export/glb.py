"""GLB."""

from artgen.asset import Asset
from artgen.export.losses import Written


def write_glb(asset: Asset, textures: int = 0) -> Written:
    """Write an asset as one GLB file."""
    raise NotImplementedError
