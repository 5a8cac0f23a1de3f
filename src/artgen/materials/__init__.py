"""Materials: appearance, density and friction."""

from artgen.materials.material import Material
from artgen.materials.table import COLORS, MATERIALS, colored, material

__all__ = ["COLORS", "MATERIALS", "Material", "colored", "material"]
