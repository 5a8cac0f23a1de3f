"""A link as a GLB file of its own, as the browser draws it."""

import numpy as np

from artgen.asset import Link
from artgen.export.glb.buffer import Buffer
from artgen.export.glb.materials import Looks
from artgen.export.glb.meshes import primitive
from artgen.materials.textures import Kind


def link_glb(link: Link, textures: int) -> bytes:
    """Return the visible surfaces of a link."""
    buffer = Buffer()
    looks = Looks(buffer, textures)
    primitives = []
    for surface in link.surfaces:
        # without tangents, which take as long as the rest: browsers find the directions of maps by themselves
        maps: tuple[Kind, ...] = ("albedo",) if looks.maps(surface.material) else ()
        shown = primitive(buffer, surface, np.zeros(3), maps)
        primitives.append({**shown, "material": looks.number(surface.material)})
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": link.name, "mesh": 0}],
        "meshes": [{"primitives": primitives}],
        **looks.to_data(),
    }
    return buffer.glb(scene)
