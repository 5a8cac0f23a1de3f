"""An oven with its racks, built into a kitchen cabinet or as a range with burners on top.

The door is hinged at its lower edge. Springs balance it, and friction holds it at any angle, as for grilling.
Links: `body`; `door`; `rack_0` (the lowest), ...; one rack may be a deep pan; `dial`, or `dial_0`, ... from
left to right; `drawer` under the oven of a range; `grate_0`, ... over gas burners. Joints: `door_hinge`,
`rack_slide_0`, ..., `dial_turn` (numbered if there are several), `drawer_slide` and `grate_lift_0`, ....

Racks lie on rods at the sides. A rack slides out after the door is open beyond the angle that clears the
rack's path; this angle is computed from the height and travel of the rack. Behind the closed door a rack has
a small play.

Sizes are those of EN 60350 ovens for niches of 60 cm, with fronts of 595 mm, and of ranges 60-76 cm wide (24
and 30 in) with burners at a height of 85-92 cm. Masses: 30-45 kg built in, 45-90 kg for ranges.
"""

from typing import Literal, get_args

import artgen as ag
from artgen import details
from artgen.categories.oven.body import Cabinet
from artgen.categories.oven.door import BEHIND, Door, Drawer, HandleKind, Window
from artgen.categories.oven.panel import Panel
from artgen.categories.oven.racks import Racks, element
from artgen.categories.oven.space import Build, Space
from artgen.categories.oven.top import BurnerKind, Top
from artgen.categories.shared.appliances import cabinet_finish, fronts, grip_metals
from artgen.categories.shared.controls import DialStyle
from artgen.categories.shared.pulls import BarStyle
from artgen.nodes.details.displays import Color

Look = Literal["stainless", "dark_steel", "white", "black", "pastel"]
"""Families of finishes, the same as those of other appliances."""

_LOOKS: tuple[Look, ...] = get_args(Look)
_FINISH, _METAL = fronts(*_LOOKS), grip_metals(*_LOOKS)
_ENAMELS = (
    ag.colored("enamel", "anthracite").with_(name="cavity_anthracite", specular_roughness=0.22),
    ag.colored("enamel", "slate").with_(name="cavity_slate", specular_roughness=0.22),
    ag.colored("enamel", "navy").with_(name="cavity_blue", specular_roughness=0.22),
)
_KNOBS = (  # plastic caps under a metal skin
    *(
        ag.material(name).with_(name=f"{name}_cap", density=1100.0)
        for name in ("stainless", "aluminium", "chrome", "satin_brass")
    ),
    ag.material("black_abs"),
    ag.colored("abs", "light_grey"),
)
_CHROME = ag.material("chrome").with_(
    name="rack_chrome", density=15000.0
)  # density with the visual-only wires
_PAN = ag.colored("enamel", "anthracite").with_(
    name="pan_enamel", density=2200.0
)  # density for 0.6 mm of sheet, modeled 2.2 mm thick
_RACKS_MEET = (
    "racks would collide with each other or with the heating element: raise height, lower hinge_height, "
    "panel or racks, or take pan=False"
)
_DRAWER_MEETS = (
    "the handle of the open door would strike the drawer: lower drawer_travel or depth, or raise height"
)
_LEVELS = {1: (2,), 2: (1, 3), 3: (1, 2, 4)}  # levels of the racks, by their number


@ag.category(
    labels=(
        "body", "cavity", "top", "trim", "kick_plate", "foot", "rail", "seal", "light", "element",
        "fan_cover", "vent", "screw", "rating_plate", "cord", "panel", "display", "print", "dial", "door",
        "window", "handle", "hinge", "rack", "pan", "drawer", "burner", "burner_cap", "igniter",
        "zone", "grate",
    ),
    joints=(2, 14),
)  # fmt: skip
def oven(
    *,
    build: Build = ag.choice("built_in", "range", weights=(0.48, 0.52)),
    look: Look = ag.by(
        "build",
        built_in=ag.choice(*_LOOKS, weights=(2.0, 1.0, 1.2, 1.2, 0.9)),
        range=ag.choice(*_LOOKS, weights=(2.0, 0.7, 1.4, 0.9, 1.8)),
    ),
    window: Window = ag.by(
        "look",
        pastel=ag.choice("partial", "none", weights=(0.8, 0.2)),
        white=ag.choice("none", "partial", "full", weights=(0.2, 0.5, 0.3)),
        otherwise=ag.choice("none", "partial", "full", weights=(0.08, 0.5, 0.42)),
        doc="window of the door; full is a glass front",
    ),
    handle: HandleKind = ag.by(
        "look",
        pastel=ag.choice("bar", "box", weights=(0.8, 0.2)),
        otherwise=ag.choice("bar", "box", weights=(0.65, 0.35)),
    ),
    burner: BurnerKind = ag.by(
        "build",
        built_in="gas",
        range=ag.choice("gas", "radiant", "induction", weights=(0.55, 0.25, 0.2)),
        doc="kind of burners of a range",
    ),
    burners: int = ag.by("build", built_in=0, range=ag.choice(4, 5, weights=(0.65, 0.35))),
    drawer: bool = ag.by(
        "build",
        built_in=False,
        range=ag.choice(True, False, weights=(0.7, 0.3)),
        doc="whether there is a drawer below the oven",
    ),
    racks: int = ag.choice(1, 2, 3, weights=(0.25, 0.45, 0.3)),
    pan: bool = ag.choice(False, True, weights=(0.55, 0.45), doc="whether the second rack is a deep pan"),
    width: ag.Float = ag.by(
        "build",
        built_in=ag.uniform(0.56, 0.60),
        range=ag.by("burners", {4: ag.uniform(0.60, 0.70)}, otherwise=ag.uniform(0.68, 0.76)),
        unit="m",
        within=(0.55, 0.92),
    ),
    height: ag.Float = ag.by(
        "build",
        built_in=ag.uniform(0.600, 0.640),
        range=ag.uniform(0.85, 0.92),
        unit="m",
        doc="height without grates",
        within=(0.59, 0.95),
    ),
    depth: ag.Float = ag.by(
        "build",
        built_in=ag.uniform(0.560, 0.620),
        range=ag.uniform(0.600, 0.650),
        unit="m",
        doc="overall depth, handle included",
        within=(0.55, 0.72),
    ),
    door_thickness: ag.Float = ag.uniform(0.038, 0.046, "m", within=(0.036, 0.055)),
    hinge_height: ag.Float = ag.by(
        "build",
        built_in=ag.uniform(0.076, 0.082),
        range=ag.uniform(0.215, 0.245),
        unit="m",
        doc="height of the axis of the door",
        within=(0.074, 0.30),
    ),
    panel: ag.Float = ag.uniform(0.090, 0.112, "m", doc="height of the control panel", within=(0.085, 0.13)),
    wall: ag.Float = ag.uniform(
        0.050, 0.062, "m", doc="distance from the sides to the cavity", within=(0.045, 0.09)
    ),
    window_width: ag.Float = ag.uniform(
        0.72, 0.94, doc="width of the window, as a share of the cavity's", within=(0.4, 0.95)
    ),
    window_height: ag.Float = ag.by(
        "window",
        full=ag.uniform(0.84, 1.0),
        otherwise=ag.uniform(0.62, 0.86),
        doc="height of the window, as a share of the available space",
        within=(0.4, 1.0),
    ),
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    enamel: ag.Material = ag.shades(*_ENAMELS, weights=(3, 1.5, 1.5), color=0.05, doc="enamel of the cavity"),
    bar: BarStyle = ag.by(
        "look",
        pastel=ag.choice("bow", "arched", "round"),
        otherwise=ag.choice("round", "square", "bow", "strap", "arched"),
    ),
    handle_length: ag.Float = ag.uniform(
        0.70, 0.90, doc="length of the handle, as a share of the width", within=(0.4, 0.95)
    ),
    projection: ag.Float = ag.uniform(
        0.038, 0.046, "m", doc="projection of the handle", within=(0.036, 0.055)
    ),
    convection: bool = ag.choice(
        True, False, weights=(0.7, 0.3), doc="whether there is a fan at the back wall"
    ),
    dials: int = ag.by(
        "build",
        built_in=ag.choice(0, 1, 2, 3, weights=(0.25, 0.1, 0.45, 0.2)),
        range=ag.by(
            "burner",
            gas=ag.by("burners", {4: ag.choice(5, 6)}, otherwise=6),
            otherwise=ag.by(
                "burners",
                {4: ag.choice(0, 4, 5, 6, weights=(0.25, 0.15, 0.35, 0.25))},
                otherwise=ag.choice(0, 6),
            ),
        ),
        doc="number of dials, first those of the burners",
    ),
    dial_style: DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    dial_radius: ag.Float = ag.by(
        "build",
        built_in=ag.uniform(0.0200, 0.0245),
        range=ag.uniform(0.0195, 0.0235),
        unit="m",
        within=(0.014, 0.026),
    ),
    dial_friction: ag.Float = ag.uniform(0.04, 0.09, "N m", doc="friction of switches or greased taps"),
    knob: ag.Material = ag.shades(*_KNOBS, weights=(2, 1.5, 1, 0.4, 2, 0.6), color=0.03, roughness=0.03),
    show: str = ag.by(
        "dials",
        {
            0: ag.choice("12:30", "180", "7:45", "220"),
            6: ag.by("build", built_in="", range=ag.choice("", "12:30", weights=(0.7, 0.3))),
        },
        otherwise=ag.choice("", "12:30", "7:45", "18:05", weights=(0.3, 0.3, 0.2, 0.2)),
        doc="text of the display; empty for none",
    ),
    figures: Color = ag.choice("white", "red", "amber", "cyan", "green"),
    mirrored: bool = ag.choice(False, True, doc="whether the large burners are on the right"),
    brass: bool = ag.choice(False, True, weights=(0.75, 0.25), doc="whether gas burners are of brass"),
    swing: ag.Float = ag.uniform(1.54, 1.57, "rad", within=(1.53, 1.5707)),
    pull: ag.Float = ag.uniform(16.0, 24.0, "N", doc="force at the handle that opens the door"),
    travel: ag.Float = ag.uniform(0.30, 0.36, "m", doc="travel of the racks", within=(0.2, 0.37)),
    rack_friction: ag.Float = ag.uniform(3.0, 7.0, "N"),
    drawer_travel: ag.Float = ag.uniform(
        0.68, 0.80, doc="travel, as a share of its depth", within=(0.3, 0.82)
    ),
    drawer_friction: ag.Float = ag.uniform(6.0, 14.0, "N"),
    watts: int = ag.count(2100, 3600),
    maker: str = ag.choice(*details.BRANDS),
    signed: Literal["door", "panel"] = ag.choice("door", "panel", doc="position of the maker's name"),
) -> ag.Body:
    """Make an oven or a range, closed: door, racks, drawer, dials."""
    girth = 0.0080
    ag.require(
        not drawer or build == "range", "only build=range has a drawer below the door: drawer must be False"
    )
    if build == "range":
        hinge_height = ag.require(
            hinge_height,
            hinge_height > 0.18,
            "the drawer below the door needs room: hinge_height must be > 0.18 m",
        )
        height = ag.require(height, height >= 0.8, "height of a range must be >= 0.8 m")
    space = Space(
        build=build,
        width=width,
        height=height,
        depth=depth,
        projection=projection + BEHIND,
        thickness=door_thickness,
        hinge_height=hinge_height,
        panel=panel,
        wall=wall,
        swing=swing,
        slide=travel,
    )
    glass = ag.material("black_glass")
    sides = ag.colored("powder_coat", "anthracite") if build == "range" else ag.material("zinc")
    cabinet = Cabinet(
        space,
        cabinet_finish(look, finish) if look in ("white", "pastel") and build == "range" else sides,
        enamel,
        wool=390.0 if build == "built_in" else 315.0,
        bay=drawer,
        finish=finish,
        convection=convection,
        maker=maker,
        watts=watts,
    )
    leaf = Door(
        space,
        window=window,
        across=window_width,
        tall=window_height,
        handle=handle,
        bar=bar,
        length=handle_length * width,
        projection=projection,
        girth=girth,
        finish=finish,
        glass=glass,
        metal=metal,
        maker=maker if signed == "door" else "",
    )
    front = Panel(
        space,
        finish=finish,
        pane=window == "full" and look != "stainless",
        dials=dials,
        burners=max(dials - 2, 0) if not burners else min(burners, dials),
        style=dial_style,
        radius=dial_radius,
        knob=knob,
        metal=metal,
        friction=dial_friction,
        show=show,
        color=figures,
        maker=maker if signed == "panel" else "",
    )
    inside, levels = Racks(space, _CHROME, _PAN, rack_friction), _LEVELS[racks]

    body = ag.weld(cabinet.body(), front.body(), inside.rails(levels), element(space))
    body = body.require(inside.apart(levels, pan=pan), _RACKS_MEET)
    pans = Drawer(space, finish, metal, 0.24 * width, drawer_travel, drawer_friction)
    if drawer:
        body = ag.weld(body, pans.runners())
    if build == "range":
        top = Top(space, burner, burners, mirrored, finish, brass, maker, drawer)
        body = top.joined(ag.weld(body, top.body()))
    hinge = leaf.hinge(pull)
    body = body.attach(leaf.body(), hinge)
    for number, level in enumerate(levels):
        deep = pan and number == 1
        name = f"rack_{number}"
        rack = inside.pan(name, level) if deep else inside.rack(name, level)
        clear = space.angle_over(inside.low(level, pan=deep))
        needs = (hinge > clear).beyond(space.play)
        body = body.attach(rack, inside.slide(f"rack_slide_{number}", needs))
    if drawer:
        body = body.attach(pans.body(), pans.slide())
        body = body.require(pans.before < leaf.handle_before - 0.001, _DRAWER_MEETS)
    return front.joined(body)
