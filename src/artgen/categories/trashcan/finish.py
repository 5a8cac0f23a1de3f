"""Materials of bins, with their weights in a random choice."""

import artgen as ag
from artgen.categories.shared.finish import colored_weights

WALL = 0.003  # modeled thickness of walls; real sheet is thinner, with the same mass [m]
_SHEET = 0.0005  # thickness of the steel of bins, in reality 0.4-0.6 mm [m]


def _sheet(made: ag.Material) -> ag.Material:
    """Return a finish on sheet: the wall is thicker than the real one, with the same mass."""
    return made.with_(name=f"{made.name}_sheet", density=made.density * _SHEET / WALL)


# fingerprint-free steel: a clear lacquer makes it brighter and smoother than bare brushed sheet
_STAINLESS = ag.material("stainless")
_BRIGHT = _STAINLESS.with_(
    name="bright_steel", base_color=(0.75, 0.745, 0.735), specular_roughness=0.26, coat_weight=0.25
)
_DARK = _STAINLESS.with_(name="black_stainless", base_color=(0.10, 0.098, 0.098), specular_roughness=0.3)
BARE = _sheet(_BRIGHT)
_STEELS = {
    BARE: 4,
    _sheet(_BRIGHT.with_(name="bright_across", turned=True)): 1.5,
    _sheet(_BRIGHT.with_(name="satin_steel", texture="satin", specular_roughness=0.34)): 1.2,
    _sheet(_DARK): 1,
    _sheet(ag.material("satin_brass")): 0.5,
    _sheet(ag.material("copper").with_(name="satin_copper", specular_roughness=0.32)): 0.45,
}
STEELS = ag.shades(_STEELS, color=0.04)

_POWDERS = {"white": 1.5, "black": 0.8, "graphite": 0.6, "sand": 0.8, "sage": 1, "taupe": 0.7, "navy": 0.7,
            "forest": 0.6}  # fmt: skip
_ENAMELS = {"white": 1, "cream": 1.1, "red": 1.1, "sky": 0.9, "mint": 0.8, "blush": 0.7, "mustard": 0.7,
            "teal": 0.8, "black": 0.4}  # fmt: skip
_COATS = {**colored_weights("powder_coat", _POWDERS), **colored_weights("enamel", _ENAMELS)}
COATED = ag.shades({_sheet(each): weight for each, weight in _COATS.items()})

_SATIN = {"white": 1.5, "light_grey": 1.2, "graphite": 0.7, "black": 0.6, "sand": 1, "sage": 1, "sky": 1,
          "blush": 0.8}  # fmt: skip
_GLOSSY = {"white": 0.8, "silver": 1.2, "slate": 0.7, "red": 0.8, "mint": 0.8, "lavender": 0.6}
_PLASTICS = {**colored_weights("polypropylene", _SATIN), **colored_weights("abs", _GLOSSY)}
PLASTICS = ag.shades({**_PLASTICS, ag.material("leather_grain_abs"): 0.6})

WICKER = ag.shades("wicker", "plastic_wicker")
_HOLED = ag.material("perforated_steel").with_(name="perforated_sheet", density=790.0)  # 40 % are holes
_SILVER = _HOLED.with_(name="perforated_silver", base_color=(0.42, 0.42, 0.43), base_metalness=0.6)
_WHITE = _HOLED.with_(name="perforated_white", base_color=(0.66, 0.66, 0.64))
MESH = ag.shades(_HOLED, _SILVER, _WHITE, color=0.04)

_BUCKETS = colored_weights("polypropylene", {"black": 3, "graphite": 1.5, "light_grey": 1.5, "white": 0.8})
BUCKETS = ag.shades({**_BUCKETS, _sheet(ag.material("zinc").with_(name="galvanised")): 1.2})

BLACK = ag.material("black_abs")
_CHROMED = ag.material("chrome").with_(name="chromed_plastic", density=1150.0)
TRIMS = {BLACK: 0.55, ag.colored("abs", "graphite"): 0.2, _CHROMED: 0.1, ag.colored("abs", "white"): 0.15}


def lid_of(finish: ag.Material, density: float) -> ag.Material:
    """Return the material of a hollow lid with the appearance of a finish."""
    return finish.with_(name=f"{finish.name}_lid", density=density)


def ink_on(finish: ag.Material, *, metal: bool = True) -> ag.Material:
    """Return the material of print on a finish: dark on light, light on dark, gray on metal."""
    on_metal = metal and finish.base_metalness > 0.5
    dark, light = ("slate", "silver") if on_metal else ("graphite", "white")
    return ag.colored("abs", dark if sum(finish.base_color) / 3 > 0.25 else light)
