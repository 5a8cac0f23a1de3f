"""Materials as Mitsuba's scattering functions."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.materials import Material
from artgen.materials.textures import maps

Data = dict[str, Any]

_SMOOTH = 0.1  # roughness below which glass is polished
_LEAST_ROUGHNESS = 0.03  # a mirror that is sharper only makes fireflies
_GLOW = 6.0  # radiance of an emission of 1, where white paper has about 1


def scattering(mitsuba: Any, material: Material, size: int) -> Data:
    """Return a material as a dictionary for `mitsuba.load_dict`.

    Args:
        mitsuba: The package, with a variant chosen.
        material: What to translate.
        size: Texels on a side of its maps, 0 for none.

    Raises:
        ParameterError: The maps cannot have that many texels.
    """
    solid = _opaque(mitsuba, material, size)
    share = material.transmission_weight
    if share == 0.0:
        if material.opacity == 1.0:
            return solid
        return {"type": "mask", "opacity": material.opacity, "bsdf": solid}
    if share == 1.0:
        return _glass(material)
    return {"type": "blendbsdf", "weight": share, "opaque": solid, "transparent": _glass(material)}


def radiance(material: Material) -> list[float]:
    """Return the emission of a material; zero if it does not glow."""
    return [_GLOW * channel for channel in material.emission]


def _opaque(mitsuba: Any, material: Material, size: int) -> Data:
    roughness: Any = max(material.specular_roughness, _LEAST_ROUGHNESS)
    color: Any = {"type": "rgb", "value": list(material.base_color)}
    metallic: Any = material.base_metalness
    normals = None
    if material.texture and size:
        found = maps(material, size)
        normals = found.normal
        roughness = _bitmap(mitsuba, np.maximum(found.roughness, round(255 * _LEAST_ROUGHNESS)), raw=True)
        if found.albedo is not None:
            color = _bitmap(mitsuba, found.albedo, raw=False)
        if found.metalness is not None:
            metallic = _bitmap(mitsuba, found.metalness, raw=True)
    data: Data = {"type": "principled", "base_color": color, "roughness": roughness, "metallic": metallic}
    data["specular"] = 0.5
    if material.coat_weight > 0.0:
        # Mitsuba's coat has a width of 0.1 without gloss and 0.001 with it
        width = min(max(material.coat_roughness**2, 0.001), 0.1)
        data |= {"clearcoat": material.coat_weight, "clearcoat_gloss": (0.1 - width) / 0.099}
    if normals is not None:
        data = {"type": "normalmap", "normalmap": _bitmap(mitsuba, normals, raw=True), "bsdf": data}
    return {"type": "twosided", "bsdf": data}


def _glass(material: Material) -> Data:
    # light passes two faces of a pane, each of which takes its half of the color
    tint = {"type": "rgb", "value": [channel**0.5 for channel in material.base_color]}
    data: Data = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0, "specular_transmittance": tint}
    if material.specular_roughness >= _SMOOTH:
        data |= {"type": "roughdielectric", "alpha": material.specular_roughness**2, "distribution": "ggx"}
    return data


def _bitmap(mitsuba: Any, pixels: NDArray[np.uint8], *, raw: bool) -> Data:
    """Return a map as a texture; `raw` ones are numbers, others sRGB colors."""
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    return {
        "type": "bitmap",
        "bitmap": mitsuba.Bitmap(np.ascontiguousarray(pixels)),
        "raw": raw,
        "wrap_mode": "repeat",
    }
