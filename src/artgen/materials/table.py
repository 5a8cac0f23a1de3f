"""The materials that the categories use; densities and dry friction of common stock."""

from typing import Any

from artgen.errors import ParameterError, nearest
from artgen.materials.material import Material


def _table(*materials: Material) -> dict[str, Material]:
    return {material.name: material for material in materials}


_METAL: dict[str, Any] = {"base_metalness": 1.0, "density": 7850.0, "friction": 0.6}
_WOOD: dict[str, Any] = {"specular_roughness": 0.42, "density": 700.0, "friction": 0.5}

MATERIALS: dict[str, Material] = _table(
    # woods and boards
    Material("oak", (0.44, 0.27, 0.13), **_WOOD),
    Material("walnut", (0.16, 0.085, 0.045), **_WOOD),
    Material("beech", (0.60, 0.40, 0.24), **_WOOD),
    Material("pine", (0.66, 0.45, 0.24), specular_roughness=0.48, density=500.0, friction=0.5),
    Material("mahogany", (0.22, 0.075, 0.035), **_WOOD),
    Material("plywood", (0.62, 0.45, 0.28), specular_roughness=0.55, density=600.0, friction=0.5),
    Material("mdf", (0.42, 0.31, 0.21), specular_roughness=0.7, density=750.0, friction=0.5),
    Material("painted_wood", (0.80, 0.79, 0.76), specular_roughness=0.38, density=700.0, friction=0.5),
    Material("hollow_core", (0.80, 0.79, 0.76), specular_roughness=0.38, density=330.0, friction=0.5),
    # metals
    Material("steel", (0.55, 0.55, 0.56), specular_roughness=0.4, **_METAL),
    Material(
        "stainless",
        (0.62, 0.61, 0.60),
        specular_roughness=0.32,
        base_metalness=1.0,
        density=7900.0,
        friction=0.5,
    ),
    Material("chrome", (0.78, 0.78, 0.79), specular_roughness=0.08, **_METAL),
    Material("satin_nickel", (0.64, 0.60, 0.55), specular_roughness=0.34, **_METAL),
    Material(
        "brass", (0.80, 0.58, 0.25), specular_roughness=0.2, base_metalness=1.0, density=8500.0, friction=0.45
    ),
    Material(
        "aged_bronze",
        (0.12, 0.085, 0.06),
        specular_roughness=0.42,
        base_metalness=0.8,
        density=8500.0,
        friction=0.45,
    ),
    Material(
        "aluminium",
        (0.75, 0.76, 0.77),
        specular_roughness=0.35,
        base_metalness=1.0,
        density=2700.0,
        friction=0.5,
    ),
    Material(
        "cast_iron",
        (0.04, 0.04, 0.042),
        specular_roughness=0.65,
        base_metalness=0.3,
        density=7200.0,
        friction=0.6,
    ),
    Material(
        "zinc", (0.60, 0.60, 0.61), specular_roughness=0.35, base_metalness=1.0, density=6600.0, friction=0.5
    ),
    Material("black_steel", (0.025, 0.025, 0.027), specular_roughness=0.45, density=7850.0, friction=0.6),
    # plastics, rubber, glass, other
    Material("abs", (0.70, 0.70, 0.69), specular_roughness=0.4, density=1050.0, friction=0.35),
    Material("black_abs", (0.025, 0.025, 0.026), specular_roughness=0.45, density=1050.0, friction=0.35),
    Material("polypropylene", (0.75, 0.75, 0.74), specular_roughness=0.45, density=905.0, friction=0.3),
    Material(
        "polycarbonate",
        (0.85, 0.88, 0.9),
        specular_roughness=0.1,
        opacity=0.35,
        density=1200.0,
        friction=0.35,
    ),
    Material("rubber", (0.03, 0.03, 0.03), specular_roughness=0.8, density=1150.0, friction=0.9),
    Material(
        "glass", (0.85, 0.92, 0.90), specular_roughness=0.03, opacity=0.25, density=2500.0, friction=0.4
    ),
    Material(
        "frosted_glass", (0.86, 0.90, 0.90), specular_roughness=0.5, opacity=0.6, density=2500.0, friction=0.4
    ),
    Material("ceramic", (0.85, 0.84, 0.81), specular_roughness=0.15, density=2400.0, friction=0.45),
    Material("granite", (0.25, 0.24, 0.24), specular_roughness=0.25, density=2700.0, friction=0.6),
    Material("cardboard", (0.48, 0.33, 0.19), specular_roughness=0.85, density=180.0, friction=0.45),
    Material("foam", (0.80, 0.78, 0.70), specular_roughness=0.9, density=35.0, friction=0.6),
    Material("fabric", (0.75, 0.71, 0.64), specular_roughness=0.9, density=300.0, friction=0.6),
)


def material(name: str) -> Material:
    """Return the material of that name from the table.

    Raises:
        ParameterError: The table has no such material; the message has the nearest name.
    """
    if name not in MATERIALS:
        raise ParameterError(f"there is no material {name!r}.{nearest(name, MATERIALS)}")
    return MATERIALS[name]
