"""Appliances: materials and colors of fronts, cabinets and matching metals; mains cords.

A category first draws a look; the finish of its front and the metal of its handles depend on it:

    look: Look = choice(*LOOKS, weights=(...))
    finish: Material = fronts()
    metal: Material = grip_metals()

Walls of appliances are sheet metal around foam, wool or air: `filled` gives them their density. Cords have no
colliders.
"""

import math
from collections.abc import Sequence
from typing import Any, Literal, get_args

import artgen as ag
from artgen.categories.shared.finish import colors
from artgen.materials import COLORS

Look = Literal["stainless", "dark_steel", "white", "black", "pastel", "glass", "panel"]
"""Families of finishes: product lines of a shop."""

LOOKS: tuple[Look, ...] = get_args(Look)

PlainLook = Literal["stainless", "dark_steel", "white", "black", "pastel"]
"""Looks of appliances that have no fronts of glass, and none behind the panels of a kitchen."""

_DARK_STEEL = (
    ag.material("stainless").with_(name="black_stainless", base_color=(0.105, 0.105, 0.110)),
    ag.material("stainless").with_(name="slate_steel", base_color=(0.235, 0.235, 0.242)),
    ag.material("stainless").with_(name="bronze_steel", base_color=(0.225, 0.190, 0.160)),
)
_PLAIN_STEEL = (
    ag.material("stainless"),
    ag.material("stainless_across"),
    ag.material("stainless").with_(name="silver_steel", base_color=(0.50, 0.505, 0.515)),
)
_WHITE = (ag.material("enamel_white"), ag.colored("enamel", "cool_white"), ag.material("powder_coat_white"))
_BLACK = (
    ag.material("enamel_black"),
    ag.material("powder_coat_black"),
    ag.colored("powder_coat", "anthracite"),
)
_PASTEL = colors("enamel", "cream mint sky blush red navy black sage mustard orange")
_GLASS = (
    ag.material("black_glass"),
    ag.material("black_glass").with_(name="white_glass", base_color=COLORS["cool_white"]),
    ag.material("black_glass").with_(name="grey_glass", base_color=COLORS["slate"]),
)
_PANEL = (
    ag.material("oak"),
    ag.material("walnut"),
    ag.material("ash"),
    *colors("lacquered_mdf", "white sage navy graphite taupe"),
)

FRONTS: dict[Look, tuple[tuple[ag.Material, ...], tuple[float, ...]]] = {
    "stainless": (_PLAIN_STEEL, (0.5, 0.2, 0.3)),
    "dark_steel": (_DARK_STEEL, (0.5, 0.3, 0.2)),
    "white": (_WHITE, (0.5, 0.25, 0.25)),
    "black": (_BLACK, (0.5, 0.2, 0.3)),
    "pastel": (_PASTEL, (2.0, 1.3, 1.3, 1.0, 1.3, 0.7, 0.7, 0.9, 0.5, 0.5)),
    "glass": (_GLASS, (0.45, 0.35, 0.2)),
    "panel": (_PANEL, (1.2, 1.0, 0.6, 1.2, 0.7, 0.6, 0.6, 0.4)),
}
"""Materials of the fronts of each look, and their weights in a random choice."""

_METALS: dict[Look, dict[str, float]] = {
    "stainless": {"stainless": 3.0, "chrome": 1.0, "powder_coat_black": 0.4},
    "dark_steel": {"powder_coat_graphite": 1.5, "stainless": 1.0, "powder_coat_black": 1.0},
    "white": {"chrome": 1.0, "stainless": 1.0, "enamel_white": 1.5, "aluminium": 0.8},
    "black": {"stainless": 1.0, "powder_coat_black": 1.2, "chrome": 0.6, "satin_brass": 0.3},
    "pastel": {"chrome": 3.0, "stainless": 0.6, "satin_brass": 0.4},
    "glass": {"aluminium": 1.0, "stainless": 1.0, "powder_coat_black": 0.6},
    "panel": {"stainless": 1.0, "satin_brass": 1.0, "powder_coat_black": 1.0, "aged_bronze": 0.6},
}

_CABINETS: dict[Look, str] = {
    "stainless": "silver",
    "dark_steel": "graphite",
    "white": "white",
    "black": "anthracite",
    "glass": "light_grey",
    "panel": "light_grey",
}


def fronts(*looks: Look) -> Any:
    """Draw the material of a front by the parameter `look`."""
    cases = {}
    for look in looks or LOOKS:
        stock, weights = FRONTS[look]
        cases[look] = ag.shades(*stock, weights=weights, color=0.04, roughness=0.03)
    return ag.by("look", cases, doc="finish of the front")


def grip_metals(*looks: Look) -> Any:
    """Draw the metal (or lacquer) of handles by the parameter `look`."""
    cases = {look: ag.shades(_METALS[look], color=0.03, roughness=0.03) for look in looks or LOOKS}
    return ag.by("look", cases, doc="metal of handles and trim")


def cabinet_finish(look: Look, finish: ag.Material) -> ag.Material:
    """Return the finish of the sides of an appliance for the finish of its front.

    Steel and panel fronts have cabinets of painted sheet; colored appliances have one color all around.
    """
    if look in ("pastel", "white", "black"):
        return finish
    if look == "glass" and max(finish.base_color) < 0.2:
        return ag.colored("powder_coat", "anthracite")
    return ag.colored("powder_coat", _CABINETS[look])


def filled(finish: ag.Material, density: float, what: str = "filled") -> ag.Material:
    """Return a finish of sheet metal filled with foam, wool or air."""
    return finish.with_(name=f"{finish.name}_{what}_{round(density)}", density=density)


LINER = ag.material("glossy_plastic_white").with_(name="liner_white", specular_roughness=0.3)
"""White polystyrene of liners [vacuum-formed HIPS sheet]."""

LINER_GREY = LINER.with_(name="liner_grey", base_color=(0.33, 0.34, 0.35), specular_roughness=0.4)
"""Gray lining, as behind steel fronts."""

CLEAR = ag.material("polycarbonate").with_(
    name="clear_polystyrene", base_color=(0.86, 0.91, 0.94), opacity=0.34, density=1050.0
)
"""Clear polystyrene of bins and drawers."""

FROSTED = CLEAR.with_(name="frosted_polystyrene", specular_roughness=0.45, opacity=0.72)
"""Cloudy polystyrene of freezer drawers."""

DARK = ag.material("black_abs").with_(
    name="dark_recess", base_color=(0.02, 0.02, 0.021), specular_roughness=0.6
)
"""Dark material of gaps, recesses and spaces behind grilles."""


CORD = 0.0032
"""Radius of the cord of a small appliance, H03VV-F 3 x 0.75 mm2 [m]."""

_RELIEF = 0.024  # length of the strain relief [m]
_RIBS = 4  # number of ribs around the strain relief
_REACH = 0.045  # distance of a cord from the back of its appliance [m]
_RUBBER = ag.material("rubber")


def strain_relief(*, radius: ag.Scalar = CORD) -> list[ag.Solid]:
    """Make the ribbed sleeve against kinks of a cord: from y = 0 back, about the y axis."""
    pitch, edge = _RELIEF / _RIBS, 0.0004
    core = radius + 0.0007
    line: list[tuple[ag.Scalar, ag.Scalar]] = [(0.0, 0.0)]
    for rib in range(_RIBS):
        out, low, high = radius + 0.0030 - 0.00055 * rib, rib * pitch, (rib + 0.62) * pitch
        line += [(out - edge, low), (out, low + edge), (out, high - edge), (out - edge, high), (core, high)]
        line.append((core, (rib + 1.0) * pitch))
    line.append((0.0, 1.0 * _RELIEF))
    return [ag.revolve(ag.polygon(line)).rotate(ag.X, -0.5 * math.pi)]


def cord_stub(*, height: ag.Scalar, radius: ag.Scalar = CORD, reach: ag.Scalar = _REACH) -> ag.Body:
    """Make a strain relief on the plane y = 0 and a cord from it down to the floor at the back (+y)."""
    cord = _cord(radius, reach, height - radius)
    return ag.detail([*strain_relief(radius=radius), cord], "cord", _RUBBER)


def mains_cord(*, height: ag.Scalar, length: ag.Scalar = 0.16, side: int = 1) -> ag.Body:
    """Make a cord with its plug: from its outlet on y = 0 down to the floor and along it to one side."""
    fall, run = height - CORD, side * 1.0 * (length - 0.052)
    end = (run, _REACH, -fall)
    plug = [(each if side > 0 else each.mirror(ag.X)).at(end) for each in _plug(CORD)]
    return ag.detail([*strain_relief(radius=CORD), _cord(CORD, _REACH, fall, end), *plug], "cord", _RUBBER)


def _cord(radius: ag.Scalar, reach: ag.Scalar, fall: ag.Scalar, *ends: ag.VectorLike) -> ag.Solid:
    """Make a cord from inside its sleeve down to the floor, and on to further corners."""
    corners = [(0.0, 0.4 * _RELIEF, 0.0), (0.0, reach, 0.0), (0.0, reach, -fall), *ends]
    return ag.sweep(ag.circle(radius), ag.polyline(corners, fillet=ag.min_(0.016, 0.45 * fall)))


def _plug(radius: ag.Scalar) -> list[ag.Solid]:
    """Make a flat molded plug with two pins, along x from the end of its cord at the origin."""
    body = ag.extrude(ag.rectangle(0.0260, 0.0130, radius=0.0048), 0.034, axis=ag.X, bevel=0.0018)
    sleeve = ag.cylinder(radius + 0.0012, 0.014, axis=ag.X, bevel=0.0008)
    low = 0.0065 - radius  # the plug lies on the floor too
    pin = ag.cylinder(0.0020, 0.019, axis=ag.X, bevel=0.0009)
    base = ag.box(0.004, 0.0190, 0.0090, bevel=0.0015)
    return [
        body.at(0.026, 0.0, low),
        sleeve.at(0.006, 0.0, 0.0012),
        base.at(0.0440, 0.0, low),
        *(pin.at(0.0545, y * 0.0095, low) for y in (-1, 1)),
    ]


def _hose(radius: float, bend: float, path: Sequence[ag.VectorLike]) -> ag.Solid:
    return ag.sweep(ag.circle(radius), ag.polyline(path, fillet=bend))


def drain_hose() -> ag.Body:
    """Make a corrugated hose with its collar, from the origin up."""
    radius = 0.009
    hose = _hose(
        radius, 1.8 * radius, [(0, -0.004, 0), (0, 0.016, 0), (0.05, 0.016, -0.01), (0.06, 0.016, 0.14)]
    )
    rib = ag.cylinder(radius + 0.0012, 0.0035, axis=ag.Y, bevel=0.001)
    ribs = ag.array(rib, at=ag.row((0, 0.004, 0), (0, 0.006, 0), 3))
    collar = ag.cylinder(1.45 * radius, 0.004, axis=ag.Y, bevel=0.001).at(y=0.001)
    return ag.detail([hose, collar, ribs], "hose", ag.colored("polypropylene", "grey"))


def inlet_hose() -> ag.Body:
    """Make a smooth pressure hose with the hexagon nut of its valve, from the origin up."""
    radius = 0.0055
    hose = _hose(radius, 2 * radius, [(0, 0.006, 0), (0, 0.021, 0), (-0.06, 0.021, 0), (-0.07, 0.021, 0.16)])
    nut = ag.extrude(ag.regular_polygon(6, 2 * radius), 0.014, axis=ag.Y, bevel=0.001).at(y=0.007)
    return ag.weld(
        ag.detail(hose, "hose", ag.colored("abs", "light_grey")),
        ag.detail(nut, "hose", ag.colored("abs", "sky")),
    )
