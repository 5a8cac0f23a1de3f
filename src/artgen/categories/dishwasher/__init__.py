"""A dishwasher, slim or full width, for a kitchen front or on its own, with its racks and spray arms.

The door is hinged at its lower edge and balanced by springs; racks roll out over the open door. Links:
`body`; `door`, with `button_0`, ... and `knob` on its console and the `detergent_flap` inside; `rack_0`
(lower), `rack_1` (upper) and `rack_2` (a tray for cutlery), if present; `spray_arm_0` on the tub's floor and
`spray_arm_1` under the upper rack. Joints: `door_hinge`, `button_slide_0`, ..., `knob_turn`,
`detergent_flap_slide`, `rack_slide_0`, ... and `spray_arm_spin_0`, ....

A rack rolls out after the door is open beyond the angle that clears the rack's path; this angle is computed
from the height and travel of the rack. Behind the closed door a rack has a small play. The tab of the
detergent flap is above the rim of the lower rack: the flap slides only while the door is open.

Sizes are those of EN 50242 machines: 595-600 mm wide for 60 cm niches, 445-450 mm for 45 cm niches, both
815-875 mm high with leveling feet; ASSE and makers' data sheets give 35-55 kg, 30-45 kg for slim machines.
"""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.dishwasher import tub as case
from artgen.categories.dishwasher.front import Console, Controls, Front, HandleKind, dispenser, liner_details
from artgen.categories.dishwasher.racks import Racks, Size
from artgen.categories.shared.appliances import Look, cabinet_finish, fronts, grip_metals
from artgen.categories.shared.baskets import Grip, rack_slide
from artgen.categories.shared.controls import ButtonShape
from artgen.categories.shared.finish import colors
from artgen.categories.shared.pulls import BarStyle, bar_handle
from artgen.nodes.details.displays import Color

Build = Literal["built_in", "freestanding"]
"""Built-in with bare sheet sides, or freestanding with painted sides and a worktop."""

_TUBS = {
    "steel": ag.material("stainless").with_(
        name="tub_steel", base_color=(0.78, 0.775, 0.77), specular_roughness=0.27
    ),
    "plastic": ag.colored("polypropylene", "light_grey").with_(name="tub_plastic"),
}
_BALLASTS = {"steel": 520.0, "concrete": 640.0}  # density of the base with pump and motor [kg/m3]
_WIRES = colors("powder_coat", "light_grey slate white sky")
_PLASTICS = colors("abs", "light_grey slate grey navy")
_WORKTOPS = {"stainless": "light_grey", "dark_steel": "graphite", "white": "white", "black": "anthracite"}
_CONSOLES = {  # plastic consoles match the tone of the front; other consoles have its finish
    "stainless": ag.colored("abs", "silver"),
    "dark_steel": ag.colored("abs", "anthracite"),
    "panel": ag.material("black_abs"),
}
_FINISH, _METAL = fronts(), grip_metals()


@ag.category(
    labels="body tub seal insulation worktop kick_plate foot rail filter hose cord rating_plate door panel "
    "handle print display vent hinge dispenser rinse_cap detergent_flap button knob rack grip roller "
    "cutlery_basket cup_shelf spray_arm",
    joints=(4, 15),
)
def dishwasher(
    *,
    build: Build = ag.choice({"built_in": 0.62, "freestanding": 0.38}),
    size: Size = ag.choice({"full": 0.66, "slim": 0.34}, doc="width of the machine: 60 or 45 cm"),
    controls: Controls = ag.by(
        "build",
        built_in={"front": 0.5, "top": 0.5},
        freestanding="front",
        doc="position of the console: in front, or on the upper edge of the door",
    ),
    look: Look = ag.by(
        "build",
        built_in=ag.by(
            "controls",
            front={"stainless": 0.35, "dark_steel": 0.2, "white": 0.15, "black": 0.15, "glass": 0.15},
            top={
                "stainless": 0.22,
                "dark_steel": 0.14,
                "white": 0.08,
                "black": 0.08,
                "glass": 0.08,
                "panel": 0.4,
            },
        ),
        freestanding={"stainless": 0.28, "dark_steel": 0.12, "white": 0.25, "black": 0.1, "pastel": 0.25},
    ),
    handle: HandleKind = ag.by(
        "build",
        built_in=ag.by(
            "controls",
            front={"bar": 0.4, "pocket": 0.35, "recessed": 0.25},
            top={"bar": 0.72, "recessed": 0.28},
        ),
        freestanding={"bar": 0.5, "recessed": 0.5},
    ),
    racks: int = ag.by(
        "size",
        full={2: 0.45, 3: 0.55},
        slim={1: 0.2, 2: 0.5, 3: 0.3},
        doc="number of racks; the third is a cutlery tray; a single rack is that of a glass washer",
    ),
    width: ag.Float = ag.by(
        "size", full=ag.uniform(0.595, 0.599), slim=ag.uniform(0.446, 0.450), unit="m", within=(0.44, 0.62)
    ),
    height: ag.Float = ag.by(
        "build",
        built_in=ag.uniform(0.82, 0.88),
        freestanding=ag.uniform(0.84, 0.88),
        unit="m",
        within=(0.80, 0.92),
    ),
    depth: ag.Float = ag.by(
        "handle",
        bar=ag.uniform(0.600, 0.620),
        otherwise=ag.uniform(0.570, 0.600),
        unit="m",
        doc="overall depth, handle included",
        within=(0.55, 0.68),
    ),
    door_thickness: ag.Float = ag.uniform(0.052, 0.060, "m", within=(0.050, 0.070)),
    plinth: ag.Float = ag.uniform(0.095, 0.120, "m", doc="hinge height above floor", within=(0.09, 0.15)),
    swing: ag.Float = ag.uniform(1.54, 1.57, "rad", within=(1.50, 1.5707)),
    clearance: ag.Float = ag.uniform(0.0022, 0.0030, "m", doc="gap between the lower rack and the open door"),
    travel: ag.Float = ag.uniform(
        0.74, 0.88, doc="travel of the racks, share of their depth", within=(0.3, 0.92)
    ),
    upper_level: ag.Float = ag.uniform(0.44, 0.50, doc="height of the upper rack, share of the free space"),
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    bar: BarStyle = ag.by(
        "look",
        pastel=ag.choice("bow", "arched", "round"),
        panel=ag.choice("round", "square", "strap", "pro"),
        otherwise=ag.choice("round", "square", "bow", "strap", "pro", "arched"),
    ),
    framed: bool = ag.by(
        "look", panel=ag.choice(False, True), otherwise=False, doc="frame on a wooden front"
    ),
    tub: Literal["steel", "plastic"] = ag.by(
        "look", white={"steel": 0.6, "plastic": 0.4}, otherwise={"steel": 0.9, "plastic": 0.1}
    ),
    pane: bool = ag.by(
        "look",
        white={False: 0.75, True: 0.25},
        pastel={False: 0.8, True: 0.2},
        stainless=ag.choice(False, True),
        otherwise={False: 0.3, True: 0.7},
        doc="whether black glass lies on the console",
    ),
    dial: Literal["", "round", "fluted", "bar", "skirted", "capped"] = ag.by(
        "controls",
        front={"": 7, "round": 1, "fluted": 1, "bar": 0.6, "skirted": 0.6, "capped": 1},
        top="",
        doc="style of the cycle dial of older machines; empty for none",
    ),
    buttons: int = ag.by("size", full=ag.count(0, 8), slim=ag.count(0, 5)),
    button_shape: ButtonShape = ag.choice("round", "square", "pill", "bar"),
    button_travel: ag.Float = ag.uniform(0.0016, 0.0030, "m"),
    button_force: ag.Float = ag.uniform(2.0, 5.0, "N"),
    show: str = ag.by(
        "controls",
        front={"": 0.25, "1:25": 0.25, "3:10": 0.2, "0:45": 0.15, "24h": 0.15},
        top=ag.choice("", "2:05", "0:30"),
        doc="text of the display; empty for none",
    ),
    figures: Color = ag.choice("white", "red", "amber", "cyan", "green"),
    maker: str = ag.choice(*details.BRANDS),
    wire: ag.Material = ag.shades(*_WIRES, weights=(3, 2, 1.5, 0.7), color=0.05),
    plastic: ag.Material = ag.shades(*_PLASTICS, weights=(2, 2, 1.5, 0.6), color=0.05),
    grip: Grip = ag.choice("bar", "plate"),
    shelves: bool = ag.choice({True: 0.65, False: 0.35}, doc="cup shelves in the upper rack"),
    ballast: Literal["steel", "concrete"] = ag.choice("steel", "concrete", doc="material of the ballast"),
    rack_friction: ag.Float = ag.uniform(3.0, 8.0, "N"),
    pull: ag.Float = ag.uniform(17.0, 24.0, "N", doc="force at the handle that opens the door"),
) -> ag.Body:
    """Make a dishwasher: door, console, racks, spray arms, detergent flap."""
    if handle == "recessed":
        deep = "a recessed handle needs depth: door_thickness must be > 0.051 m"
        door_thickness = ag.require(door_thickness, door_thickness > 0.051, deep)
    if handle == "bar":
        depth = ag.require(depth, depth >= 0.58, "a bar stands out: depth must be >= 0.58 m")
    slim, upper, built_in = size == "slim", controls == "top", build == "built_in"
    worktop = not built_in and not upper and handle != "pocket"
    projection, girth = 0.040, 0.0080  # of a bar [m]
    front_y = projection + 2 * girth - depth / 2 if handle == "bar" else -depth / 2
    plan = case.Plan(
        ag.Region((-width / 2, width / 2), (front_y, depth / 2), (0, height)),
        worktop=worktop,
        wall=0.027 if slim else 0.031,
        thickness=door_thickness,
        hinge_height=plinth,
        swing=swing,
        clearance=clearance,
        travel=travel,
        upper_level=upper_level,
    )
    liner = _TUBS[tub]
    sides = ag.material("zinc") if built_in else cabinet_finish(look, finish)
    top = ag.colored("lacquered_mdf", _WORKTOPS[look]) if look in _WORKTOPS else sides
    body = ag.weld(
        case.base(plan, ag.material("powder_coat_black") if built_in else sides, _BALLASTS[ballast]),
        case.walls(plan, liner),
        case.sides(plan, sides, worktop=worktop, felt=built_in),
        case.cover(plan, sides, top if worktop else None),
        case.rails(plan, racks),
        case.interior(plan, liner),
        case.back(plan, maker),
    )

    length = 0.72 * width if handle == "bar" else 0.12 if slim else 0.17
    front = Front(plan, handle, length, upper=upper)
    dark_caps = pane or look in ("black", "dark_steel")
    console = Console(
        front.console,
        front.console_hole,
        upper=upper,
        finish=_CONSOLES.get(look, finish),
        pane=pane and front.console_hole is None,
        buttons=buttons if front.console_hole is None else min(buttons, 5),
        shape=button_shape,
        cap=ag.material("black_abs") if dark_caps else ag.material("aluminium"),
        dial=dial,
    )
    boards = front.boards(finish, liner)
    hinge = front.hinge(boards, console.boards, pull)
    if handle == "bar":
        grip_body: ag.Body = bar_handle(
            length=length, finish=metal, style=bar, level=True, projection=projection, girth=girth
        ).at(0, front_y, front.grip)
    else:
        grip_body = front.hollow_grip(metal)
    aside = 0.100 if slim else 0.128  # of the dispenser [m]
    name = "" if look == "panel" else maker
    door = ag.weld(
        *(ag.part(solid, "door", stuff) for solid, stuff in boards),
        *front.trim(finish, name, framed=framed and handle != "recessed"),
        *liner_details(plan, -aside),
        grip_body,
        front.place(console.body(show, figures, travel=button_travel, force=button_force)),
    )
    body = body.attach(door.install(dispenser(plan, aside, hinge)), hinge)
    inside = Racks(plan, size, wire, plastic, grip)
    body = inside.with_arm(body, 0)
    for number in range(racks):
        rack = inside.make(number, cutlery=racks < 3, shelves=shelves)
        if number == 1:
            rack = inside.with_arm(rack, 1)
        needs = (hinge > inside.clear_angle(number)).beyond(case.REACH - 0.0006)
        slide = rack_slide(
            f"rack_slide_{number}", travel=plan.travel, friction=rack_friction, damping=8, needs=needs
        )
        body = body.attach(rack, slide)
    return console.used(body)
