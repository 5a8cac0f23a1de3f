"""Materials of leaves, frames and hardware, and materials derived from a finish."""

from collections.abc import Mapping, Sequence

import artgen as ag


def known(*names: str) -> tuple[ag.Material, ...]:
    """Return the library materials with these names."""
    return tuple(ag.MATERIALS[name] for name in names if name in ag.MATERIALS)


def colors(base: str, names: str) -> tuple[ag.Material, ...]:
    """Return a library material in several colors of products, for example `colors("abs", "red sky")`."""
    return tuple(ag.colored(base, name) for name in names.split())


_HARDWARE = {
    "satin_nickel": 2.0, "stainless": 2.0, "chrome": 1.2, "brass": 1.0,
    "satin_brass": 1.2, "aged_bronze": 0.9, "powder_coat_black": 0.8, "black_steel": 0.8,
}  # fmt: skip

FINISHES = known(*_HARDWARE)
"""Finishes of door hardware."""

FINISH_WEIGHTS = tuple(_HARDWARE[finish.name] for finish in FINISHES)
"""Weights of `FINISHES` in a random choice."""


def colored_weights(base: str, weights: Mapping[str, float]) -> dict[ag.Material, float]:
    """Return a library material in several colors, with the weights of these colors."""
    return {ag.colored(base, color): weight for color, weight in weights.items()}


def casting(finish: ag.Material, share: float = 0.35) -> ag.Material:
    """Return the material of a hollow casting, a molding or a tube with the appearance of a finish."""
    return finish.with_(name=f"{finish.name}_hollow_{round(100 * share)}", density=share * finish.density)


def recess(finish: ag.Material) -> ag.Material:
    """Return the dark material of slots and holes in a finish."""
    return finish.with_(
        name=f"{finish.name}_recess",
        base_color=(0.02, 0.02, 0.02),
        base_metalness=0.0,
        specular_roughness=0.7,
        coat_weight=0.0,
        texture="",
        variant=0,
        tile=None,
        turned=False,
    )


def weighing(materials: Sequence[ag.Material], density: float, prefix: str) -> tuple[ag.Material, ...]:
    """Return materials with another density [kg/m3] and name, for example veneers on a light core."""
    return tuple(each.with_(name=f"{prefix}_{each.name}", density=density) for each in materials)


def across(finish: ag.Material) -> ag.Material:
    """Return a finish with its grain across the long side of a part."""
    if not finish.texture:
        return finish
    return finish.with_(name=f"{finish.name}_across", turned=not finish.turned)


# linear colors of paints, with their weights for rooms and for entrances
_PAINTS: dict[str, tuple[tuple[float, float, float], float, float]] = {
    "white": ((0.80, 0.79, 0.76), 5.0, 1.5), "ivory": ((0.74, 0.69, 0.58), 1.5, 0.5),
    "linen": ((0.62, 0.57, 0.48), 1.0, 0.4), "dove": ((0.48, 0.48, 0.46), 1.0, 0.5),
    "grey": ((0.26, 0.27, 0.275), 1.0, 0.8), "graphite": ((0.050, 0.054, 0.060), 0.6, 1.4),
    "black": ((0.022, 0.022, 0.023), 0.3, 1.2), "sage": ((0.30, 0.36, 0.27), 0.8, 1.0),
    "olive": ((0.115, 0.125, 0.065), 0.4, 0.6), "forest": ((0.022, 0.060, 0.040), 0.5, 1.0),
    "powder_blue": ((0.36, 0.46, 0.52), 0.5, 0.6), "teal": ((0.030, 0.130, 0.140), 0.5, 0.6),
    "navy": ((0.024, 0.042, 0.090), 0.5, 1.2), "terracotta": ((0.37, 0.12, 0.060), 0.4, 0.5),
    "oxblood": ((0.130, 0.020, 0.022), 0.4, 0.8), "red": ((0.33, 0.030, 0.026), 0.3, 0.8),
    "mustard": ((0.52, 0.30, 0.055), 0.4, 0.5),
}  # fmt: skip
# factory finishes; brushes leave marks in other paints
_SPRAYED = ("black", "graphite", "grey", "dove", "teal")


def paints(density: float, prefix: str) -> tuple[ag.Material, ...]:
    """Return the paints over a wood of some density [kg/m3], with names that begin with the prefix."""
    base = ag.material("painted_wood")
    return tuple(
        base.with_(
            name=f"{prefix}_{color}",
            base_color=rgb,
            density=density,
            texture="sprayed_paint" if color in _SPRAYED and base.texture else base.texture,
        )
        for color, (rgb, _, _) in _PAINTS.items()
    )


INDOORS = tuple(inside for _, inside, _ in _PAINTS.values())
"""Weights of the paints in rooms."""

OUTDOORS = tuple(outside for _, _, outside in _PAINTS.values())
"""Weights of the paints on entrances."""
