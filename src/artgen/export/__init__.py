"""Writers of URDF, MJCF, USD, GLB and SDFormat files, and the function that writes them to disk.

Every writer returns the bytes of its files and a list of losses of its format.
"""

from artgen.export.files import export
from artgen.export.glb import write_glb
from artgen.export.layouts import DEFAULT_FORMATS, FORMATS, LAYOUTS, TEXTURES, write_usd
from artgen.export.losses import Layout, Loss, Written
from artgen.export.mjcf import write_mjcf
from artgen.export.sdf import write_sdf
from artgen.export.urdf import write_urdf

__all__ = [
    "DEFAULT_FORMATS", "FORMATS", "LAYOUTS", "TEXTURES", "Layout", "Loss", "Written",
    "export", "write_glb", "write_mjcf", "write_sdf", "write_urdf", "write_usd",
]  # fmt: skip
