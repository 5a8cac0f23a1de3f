"""Materials of bins, and the marks printed on them."""

from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import recycling
from artgen.categories.trashcan.bins import Can

WALL = 0.003
"""Modeled thickness of walls; real sheet is thinner, with the same mass [m]."""

_SHEET = 0.0005  # thickness of the steel of bins, in reality 0.4-0.6 mm [m]
_HOLLOW_LID = 310.0  # density for sheet of 0.4 mm over a thin liner, 3.7 kg/m2 for a lid 12 mm thick [kg/m3]


def _sheet(made: ag.Material) -> ag.Material:
    """Return a finish on sheet: the wall is thicker than the real one, with the same mass."""
    return made.with_(name=f"{made.name}_sheet", density=made.density * _SHEET / WALL)


def _sheets(name: str, colors: Sequence[str]) -> tuple[ag.Material, ...]:
    return tuple(_sheet(ag.colored(name, color)) for color in colors)


def _plastics(name: str, colors: Sequence[str]) -> tuple[ag.Material, ...]:
    return tuple(ag.colored(name, color) for color in colors)


# fingerprint-free steel: a clear lacquer makes it brighter and smoother than bare brushed sheet
_BRIGHT = ag.material("stainless").with_(
    name="bright_steel", base_color=(0.75, 0.745, 0.735), specular_roughness=0.26, coat_weight=0.25
)

STEELS = (
    _sheet(_BRIGHT),
    _sheet(_BRIGHT.with_(name="bright_across", turned=True)),
    _sheet(_BRIGHT.with_(name="satin_steel", texture="satin", specular_roughness=0.34)),
    _sheet(
        ag.material("stainless").with_(
            name="black_stainless", base_color=(0.10, 0.098, 0.098), specular_roughness=0.3
        )
    ),
    _sheet(ag.material("satin_brass")),
    _sheet(ag.material("copper").with_(name="satin_copper", specular_roughness=0.32)),
)
"""Bare sheet steel."""

STEEL_WEIGHTS = (4.0, 1.5, 1.2, 1.0, 0.5, 0.45)

COATED = (
    *_sheets("powder_coat", ("white", "black", "graphite", "sand", "sage", "taupe", "navy", "forest")),
    *_sheets("enamel", ("white", "cream", "red", "sky", "mint", "blush", "mustard", "teal", "black")),
)
"""Painted and enameled sheet."""

COATED_WEIGHTS = (1.5, 0.8, 0.6, 0.8, 1.0, 0.7, 0.7, 0.6, 1.0, 1.1, 1.1, 0.9, 0.8, 0.7, 0.7, 0.8, 0.4)

PLASTICS = (
    *_plastics("polypropylene", ("white", "light_grey", "graphite", "black", "sand", "sage", "sky", "blush")),
    *_plastics("abs", ("white", "silver", "slate", "red", "mint", "lavender")),
    ag.material("leather_grain_abs"),
)
"""Molded plastics."""

PLASTIC_WEIGHTS = (1.5, 1.2, 0.7, 0.6, 1.0, 1.0, 1.0, 0.8, 0.8, 1.2, 0.7, 0.8, 0.8, 0.6, 0.6)

WEAVES = (
    ag.material("wicker"),
    ag.material("plastic_wicker"),
    # 40 % of the area are holes
    ag.material("perforated_steel").with_(name="perforated_sheet", density=790.0),
    ag.material("perforated_steel").with_(
        name="perforated_silver", base_color=(0.42, 0.42, 0.43), base_metalness=0.6, density=790.0
    ),
    ag.material("perforated_steel").with_(
        name="perforated_white", base_color=(0.66, 0.66, 0.64), density=790.0
    ),
)
"""Walls of open bins: wickers first, then perforated sheet."""

BUCKETS = (
    ag.colored("polypropylene", "black"),
    ag.colored("polypropylene", "graphite"),
    ag.colored("polypropylene", "light_grey"),
    ag.colored("polypropylene", "white"),
    _sheet(ag.material("zinc").with_(name="galvanised")),
)
"""Plastics of inner buckets."""

BUCKET_WEIGHTS = (3.0, 1.5, 1.5, 0.8, 1.2)

_CHROMED = ag.material("chrome").with_(name="chromed_plastic", density=1150.0)
TRIMS = (ag.material("black_abs"), ag.colored("abs", "graphite"), _CHROMED, ag.colored("abs", "white"))
"""Materials of rims and bases."""


def lid_of(finish: ag.Material, density: float = _HOLLOW_LID) -> ag.Material:
    """Return the material of a hollow lid with the appearance of a finish."""
    return finish.with_(name=f"{finish.name}_lid", density=density)


Sort = Literal["none", "recycling", "paper", "plastic", "glass", "food"]
"""Kind of waste shown on a bin, if any."""

_INK = {"recycling": "", "paper": "PAPER", "plastic": "PLASTIC", "glass": "GLASS", "food": "FOOD WASTE"}
_LIGHT = 0.25  # mean color value above which dark print has more contrast


def ink_on(finish: ag.Material, *, metal: bool = True) -> ag.Material:
    """Return the material of print on a finish: dark on light, light on dark, gray on metal."""
    mean = sum(finish.base_color) / 3.0
    if metal and finish.base_metalness > 0.5:
        return ag.colored("abs", "slate") if mean > _LIGHT else ag.colored("abs", "silver")
    return ag.colored("abs", "graphite") if mean > _LIGHT else ag.colored("abs", "white")


def maker_mark(can: Can, maker: str, *, z: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Print the maker's name on the front, small enough for a round front."""
    mark = details.logo(maker, 0.010 * can.width, tracking=0.15)
    return details.printed(mark, can.face(z), material=ink_on(finish), facing=can.facing, proud=0.0006)


def sort_mark(can: Can, sort: Sort, *, z: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Print the recycling sign on the front; return None for no sign."""
    if sort == "none":
        return []
    ink = ink_on(finish, metal=False)
    flat = can.plan in ("square", "rectangle")
    sign = recycling(0.075 if flat else 0.10 * can.width)
    bodies = [details.printed(sign, can.face(z), material=ink, facing=can.facing, proud=0.0008)]
    words = _INK[sort]
    if words and flat:
        line = details.lettering((words,), 0.012, tracking=0.12, fineness="coarse")
        bodies.append(
            details.printed(line, can.face(z - 0.065), material=ink, facing=can.facing, proud=0.0008)
        )
    return bodies


def plate(at: ag.VectorLike, lines: tuple[str, ...]) -> ag.Body:
    """Make the sticker with type and volume at the back of a bin."""
    return details.rating_plate(0.026, 0.018, lines, at=at, facing=(0.0, 1.0, 0.0), double_insulated=False)


def top_mark(maker: str, at: ag.VectorLike, finish: ag.Material) -> ag.Body:
    """Print the maker's name on a lid, for a reader in front."""
    mark = details.logo(maker, 0.0045, tracking=0.2)
    return details.printed(mark, at, material=ink_on(finish), facing=ag.Z, up=(0.0, 1.0, 0.0))


def bag(can: Can) -> ag.Body:
    """Make the thin bag folded over the rim of an open bin, visual only."""
    sheet = ag.material("polypropylene").with_(
        name="bag_film", base_color=(0.78, 0.79, 0.80), specular_roughness=0.35, density=920.0
    )
    return ag.detail(can.band(can.top - 0.045, can.top + 0.0008, outer=-0.0009, inner=0.0002), "bag", sheet)
