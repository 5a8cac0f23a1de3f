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
from artgen.categories.oven import case, front
from artgen.categories.oven import racks as inside
from artgen.categories.oven.case import Build, BurnerKind
from artgen.categories.oven.front import HandleKind, Window
from artgen.categories.shared.appliances import fronts, grip_metals
from artgen.categories.shared.baskets import rack_slide
from artgen.categories.shared.controls import PANE, DialStyle, dial, dial_turn, ink_on
from artgen.categories.shared.pulls import BarStyle, bar_handle
from artgen.nodes.details.displays import Color

Look = Literal["stainless", "dark_steel", "white", "black", "pastel"]
"""Families of finishes, the same as those of other appliances."""

_LOOKS: tuple[Look, ...] = get_args(Look)
_FINISH, _METAL = fronts(*_LOOKS), grip_metals(*_LOOKS)
_ENAMELS = [
    ag.colored("enamel", color).with_(name=f"cavity_{name}", specular_roughness=0.22)
    for color, name in (("anthracite", "anthracite"), ("slate", "slate"), ("navy", "blue"))
]
_METALS = ("stainless", "aluminium", "chrome", "satin_brass")
_KNOBS = (  # plastic caps under a metal skin, or plastic
    *(ag.material(name).with_(name=f"{name}_cap", density=1100.0) for name in _METALS),
    ag.material("black_abs"),
    ag.colored("abs", "light_grey"),
)
_RACKS_MEET = (
    "racks would collide with each other or with the heating element: raise height, lower hinge_height, "
    "panel or racks, or take pan=False"
)
_DRAWER_MEETS = (
    "the handle of the open door would strike the drawer: lower drawer_travel or depth, or raise height"
)
_LEVELS = {1: (2,), 2: (1, 3), 3: (1, 2, 4)}  # levels of the racks, by their number


@ag.category(
    labels="body cavity top trim kick_plate foot rail seal light element fan_cover vent screw rating_plate "
    "cord panel display print dial door window handle hinge rack pan drawer burner burner_cap igniter zone "
    "grate",
    joints=(2, 14),
)
def oven(
    *,
    build: Build = ag.choice({"built_in": 0.48, "range": 0.52}),
    look: Look = ag.by(
        "build",
        built_in={"stainless": 2.0, "dark_steel": 1.0, "white": 1.2, "black": 1.2, "pastel": 0.9},
        range={"stainless": 2.0, "dark_steel": 0.7, "white": 1.4, "black": 0.9, "pastel": 1.8},
    ),
    window: Window = ag.by(
        "look",
        pastel={"partial": 0.8, "none": 0.2},
        white={"none": 0.2, "partial": 0.5, "full": 0.3},
        otherwise={"none": 0.08, "partial": 0.5, "full": 0.42},
        doc="window of the door; full is a glass front",
    ),
    handle: HandleKind = ag.by("look", pastel={"bar": 0.8, "box": 0.2}, otherwise={"bar": 0.65, "box": 0.35}),
    burner: BurnerKind = ag.by(
        "build",
        built_in="gas",
        range={"gas": 0.55, "radiant": 0.25, "induction": 0.2},
        doc="kind of burners of a range",
    ),
    burners: int = ag.by("build", built_in=0, range={4: 0.65, 5: 0.35}),
    drawer: bool = ag.by(
        "build", built_in=False, range={True: 0.7, False: 0.3}, doc="whether there is a drawer below the oven"
    ),
    racks: int = ag.choice({1: 0.25, 2: 0.45, 3: 0.3}),
    pan: bool = ag.choice({False: 0.55, True: 0.45}, doc="whether the second rack is a deep pan"),
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
    convection: bool = ag.choice({True: 0.7, False: 0.3}, doc="whether there is a fan at the back wall"),
    dials: int = ag.by(
        "build",
        built_in={0: 0.25, 1: 0.1, 2: 0.45, 3: 0.2},
        range=ag.by(
            "burner",
            gas=ag.by("burners", {4: ag.choice(5, 6)}, otherwise=6),
            otherwise=ag.by("burners", {4: {0: 0.25, 4: 0.15, 5: 0.35, 6: 0.25}}, otherwise=ag.choice(0, 6)),
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
            6: ag.by("build", built_in="", range={"": 0.7, "12:30": 0.3}),
        },
        otherwise={"": 0.3, "12:30": 0.3, "7:45": 0.2, "18:05": 0.2},
        doc="text of the display; empty for none",
    ),
    figures: Color = ag.choice("white", "red", "amber", "cyan", "green"),
    mirrored: bool = ag.choice(False, True, doc="whether the large burners are on the right"),
    brass: bool = ag.choice({False: 0.75, True: 0.25}, doc="whether gas burners are of brass"),
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
    ranged = build == "range"
    ag.require(not drawer or ranged, "only build=range has a drawer below the door: drawer must be False")
    ag.require(burners > 0 or not ranged, "a range has burners: burners must be 4 or 5")
    if ranged:
        room = "the drawer below the door needs room: hinge_height must be > 0.18 m"
        hinge_height = ag.require(hinge_height, hinge_height > 0.18, room)
        height = ag.require(height, height >= 0.8, "height of a range must be >= 0.8 m")
    before = projection + front.BEHIND
    outside = ag.Region((-width / 2, width / 2), (before - depth / 2, depth / 2), (0, height))
    plan = case.Plan(
        build, outside, wall=wall, panel=panel, hinge_height=hinge_height, thickness=door_thickness
    )
    sides = finish if look in ("white", "pastel") else ag.colored("powder_coat", "anthracite")
    pane = window == "full" and look != "stainless"
    signs = {"door": "", "panel": "", signed: maker}
    levels = _LEVELS[racks]
    body = ag.weld(
        case.walls(plan, sides if ranged else ag.material("zinc"), enamel),
        case.base(plan, finish, drawer=drawer) if ranged else case.air_strip(plan, finish),
        case.interior(plan, enamel, convection=convection),
        case.back_fittings(plan, maker, watts),
        front.panel(plan, finish, signs["panel"], pane=pane, show=show, color=figures, touch=not dials),
        inside.rails(plan, levels),
        inside.element(plan),
    )
    if ranged:
        layout = case.layout(plan, burners, mirrored=mirrored)
        density = 150.0 if drawer else 420.0  # of the front edge [kg/m3]
        body = ag.weld(body, case.top(plan, layout, burner, finish, brass=brass, maker=maker, edge=density))
    body = body.require(inside.apart(plan, levels, pan=pan), _RACKS_MEET)

    length = handle_length * width
    if handle == "bar":
        grip: ag.Body = bar_handle(
            length=length, finish=metal, style=bar, level=True, projection=projection, girth=0.008
        )
    else:
        grip = front.box_handle(length, projection, metal)
    view = None if window == "none" else front.window_region(plan, window_width, window_height)
    face = front.BLACK if window == "full" else finish
    door, hinge = front.door(
        plan, view, face, signs["door"], trimmed=window == "partial", swing=swing, pull=pull
    )
    body = body.attach(door.install(grip, at=(0, outside.y.low, plan.door.z.high - front.DOWN)), hinge)
    for number, level in enumerate(levels):
        deep = pan and number == 1
        make = inside.pan if deep else inside.rack
        clear = inside.clear_angle(plan, level, travel=travel, pan=deep)
        needs = (hinge > clear).beyond(inside.PLAY)
        slide = rack_slide(
            f"rack_slide_{number}", travel=travel, friction=rack_friction, damping=6, needs=needs
        )
        body = body.attach(make(plan, level, f"rack_{number}"), slide)
    if drawer:
        box = front.Drawer(plan, drawer_travel)
        body = ag.weld(body, box.runners(plan))
        body = body.attach(box.body(finish, metal, 0.24 * width), box.slide(drawer_friction))
        body = body.require(box.reach < front.handle_reach(plan, swing) - 0.001, _DRAWER_MEETS)
    kinds = front.dial_kinds(dials, min(burners, dials) if burners else max(dials - 2, 0))
    places = front.dial_places(plan, dials, dial_radius, show)
    surface, proud = (front.BLACK, PANE) if pane else (finish, 0.0)
    for number, (x, kind) in enumerate(zip(places, kinds, strict=True)):
        tail = f"_{number}" if dials > 1 else ""
        clicks, held = (front.CLICKS, 0.4 * dial_friction) if kind[0] == "icons" else ((), dial_friction)
        turn = dial_turn(f"dial_turn{tail}", low=0, high=front.SWEEP, friction=held, clicks=clicks)
        scale = front.scale(dial_radius, *kind, ink_on(surface))
        turned = dial(
            turn, dial_style, dial_radius, knob, depth=0.022, cap=metal, scale=scale, name=f"dial{tail}"
        )
        body = body.install(turned, at=(x, outside.y.low - proud, plan.panel.z.mid))
    return front.used(body, burner if burners else "gas", kinds)
