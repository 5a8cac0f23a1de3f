"""What the reflection model of Blinn and Phong, which MTL and older renderers use, makes of a material."""

from artgen.materials import Material

_DIELECTRIC = 0.04  # share of light that plastic, wood and lacquer reflect head-on
_MOST = 1000.0  # the greatest exponent of MTL


def phong_exponent(roughness: float) -> float:
    """Return the exponent whose highlight is as wide as that of a GGX roughness in 0..1."""
    return min(max(2.0 / max(roughness, 1e-2) ** 4 - 2.0, 1.0), _MOST)


def specular_color(material: Material) -> tuple[float, float, float]:
    """Return the share of light that is reflected head-on, linear RGB."""
    metal = material.base_metalness
    red, green, blue = (metal * channel + (1.0 - metal) * _DIELECTRIC for channel in material.base_color)
    return red, green, blue


def highlight(material: Material, greatest: float) -> tuple[float, float]:
    """Return strength in 0..1 and exponent of the highlight of a material, or of its lacquer if stronger.

    The strength is that of the normalised model, whose highlights get brighter as they get narrower.
    """
    layers = (
        (max(specular_color(material)), material.specular_roughness),
        (material.coat_weight * _DIELECTRIC, material.coat_roughness),
    )
    exponents = [min(phong_exponent(roughness), greatest) for _, roughness in layers]
    peaks = [(exponent + 2.0) / 8.0 * share for exponent, (share, _) in zip(exponents, layers, strict=True)]
    strength, exponent = max(zip(peaks, exponents, strict=True))
    return min(strength, 1.0), exponent
