"""Materials: appearance, density and friction."""

from artgen.materials.material import COLORS, MATERIALS, Material, colored, material, named

__all__ = ["COLORS", "MATERIALS", "Material", "colored", "material", "named"]
