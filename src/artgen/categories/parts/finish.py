"""Materials that derive from the finish of a set of hardware."""

from artgen import Material, material

FINISHES = tuple(
    material(name) for name in ("satin_nickel", "chrome", "stainless", "brass", "aged_bronze", "black_steel")
)
"""What door hardware is sold in."""


def casting(finish: Material, share: float = 0.35) -> Material:
    """Return the material of a hollow casting or a tube with the looks of a finish.

    Args:
        finish: The metal that is seen.
        share: What the hollow thing weighs as a share of a full one.
    """
    return finish.with_(name=f"{finish.name}_hollow_{round(100 * share)}", density=share * finish.density)


def recess(finish: Material) -> Material:
    """Return the material of slots and holes in a finish, which look dark."""
    return finish.with_(
        name=f"{finish.name}_recess",
        base_color=(0.02, 0.02, 0.02),
        base_metalness=0.0,
        specular_roughness=0.7,
    )
