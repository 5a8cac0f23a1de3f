"""Substance of a material, in terms shared by labels and sensors."""

from dataclasses import dataclass
from typing import Literal

from artgen.materials.material import Material

Coating = Literal["none", "paint", "clearcoat", "paint_clearcoat"]


@dataclass(frozen=True)
class Substance:
    """A substance with its names in other vocabularies."""

    name: str  # common name
    code: str  # its Wikidata Q-code
    sensed: str  # name in SimReady's table of non-visual materials, for lidar, radar and sonar models
    metal: bool = False  # whether it is a metal


_WOOD = Substance("wood", "Q287", "wood")
_STEEL = Substance("steel", "Q11427", "steel", metal=True)
_METAL = Substance("metal", "Q11426", "steel", metal=True)
_PLASTIC = Substance("plastic", "Q11474", "plastic")
_GLASS = Substance("glass", "Q11469", "clear_glass")
_TEXTILE = Substance("textile", "Q28823", "fabric")
_ALUMINIUM = Substance("aluminium", "Q663", "aluminum", metal=True)
_RUBBER = Substance("rubber", "Q131877", "rubber")
_STONE = Substance("granite", "Q41177", "stone")

_WOODS = (
    "oak", "walnut", "beech", "pine", "mahogany", "maple", "ash", "wood", "mdf", "hollow_core", "wicker",
)  # fmt: skip
# the first matching word of a material's name decides; words for derived parts and sheets come first
_WORDS: dict[str, Substance] = {
    "lens": _PLASTIC,
    "plastic": _PLASTIC,
    "polycarbonate": Substance("plastic", "Q11474", "plexiglass"),
    "frosted_glass": Substance("glass", "Q11469", "frosted_glass"),
    "glass": _GLASS,
    "bulb": _GLASS,
    "stainless": Substance("stainless steel", "Q172587", "steel", metal=True),
    "cast_iron": Substance("cast iron", "Q483269", "iron", metal=True),
    "nickel": Substance("nickel", "Q744", "steel", metal=True),
    "zinc": Substance("zinc", "Q758", "steel", metal=True),
    "brass": Substance("brass", "Q39782", "brass", metal=True),
    "bronze": Substance("bronze", "Q34095", "bronze", metal=True),
    "copper": Substance("copper", "Q753", "bronze", metal=True),
    "aluminium": _ALUMINIUM,
    "anodised": _ALUMINIUM,
    "steel": _STEEL,
    "chrome": _STEEL,
    "powder_coat": _STEEL,
    "enamel": _STEEL,
    "rolled": _STEEL,
    "cardboard": Substance("cardboard", "Q389782", "cardboard"),
    "plywood": Substance("plywood", "Q219803", "wood"),
    **dict.fromkeys(_WOODS, _WOOD),
    "silicone": Substance("silicone", "Q146439", "rubber"),
    "rubber": _RUBBER,
    **dict.fromkeys(("ceramic", "tiles"), Substance("ceramic", "Q45621", "ceramic_glass")),
    "marble": Substance("marble", "Q40861", "marble"),
    "granite": _STONE,
    **dict.fromkeys(("fabric", "linen", "canvas", "velvet", "knitted_mesh"), _TEXTILE),
    "hide": Substance("leather", "Q286", "leather"),
    **dict.fromkeys(("abs", "polypropylene", "foam", "led", "display"), _PLASTIC),
    **dict.fromkeys(("fine_grain", "coarse_grain", "glossy"), _PLASTIC),
}

_PAINTS = ("paint", "powder_coat", "enamel", "lacquered")

_HEAVY = 2000.0
"""Painted materials above this density are metal, below it wood [kg/m^3]."""


def substance_of(material: Material) -> Substance:
    """Return the substance of a material from its name, its maps or its appearance."""
    if _has(material.name, "paint"):
        return _STEEL if material.density > _HEAVY else _WOOD
    for text in (material.name, material.texture):
        for word, substance in _WORDS.items():
            if _has(text, word):
                return substance
    if material.transmission_weight >= 0.5:
        return _GLASS
    return _METAL if material.base_metalness >= 0.5 else _PLASTIC


def coating_of(material: Material) -> Coating:
    """Return the coating of a material."""
    painted = any(_has(text, word) for text in (material.name, material.texture) for word in _PAINTS)
    lacquered = material.coat_weight > 0.0
    if painted:
        return "paint_clearcoat" if lacquered else "paint"
    return "clearcoat" if lacquered else "none"


def _has(text: str, word: str) -> bool:
    """Tell whether words joined by underscores contain given words."""
    return f"_{word}_" in f"_{text}_"
