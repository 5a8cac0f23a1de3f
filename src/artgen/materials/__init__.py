"""Materials: how a surface looks and what a solid of it weighs and grips."""

from artgen.materials.material import Material
from artgen.materials.table import COLORS, MATERIALS, colored, material

__all__ = ["COLORS", "MATERIALS", "Material", "colored", "material"]
