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
from artgen.categories.dishwasher.console import Console
from artgen.categories.dishwasher.door import CONSOLE_BEFORE_POCKET, RECESS_HALF, Dispenser, Front, HandleKind
from artgen.categories.dishwasher.racks import Racks
from artgen.categories.dishwasher.space import REACH, Build, Controls, Size, Space
from artgen.categories.dishwasher.tub import Cabinet, kick_finish
from artgen.categories.shared.appliances import Look, cabinet_finish, fronts, grip_metals
from artgen.categories.shared.baskets import GRIP_REACH, Grip
from artgen.categories.shared.controls import ButtonShape
from artgen.categories.shared.pulls import BarStyle
from artgen.nodes.details.displays import Color

_TUB_STEEL = ag.material("stainless").with_(
    name="tub_steel", base_color=(0.78, 0.775, 0.77), specular_roughness=0.27
)
_TUB_PLASTIC = ag.colored("polypropylene", "light_grey").with_(name="tub_plastic")
_WIRES = (
    ag.colored("powder_coat", "light_grey"),
    ag.colored("powder_coat", "slate"),
    ag.colored("powder_coat", "white"),
    ag.colored("powder_coat", "sky"),
)
_WORKTOPS = {"stainless": "light_grey", "dark_steel": "graphite", "white": "white", "black": "anthracite"}
_CONSOLES = {  # plastic consoles match the tone of the front; other consoles have its finish
    "stainless": ag.colored("abs", "silver"),
    "dark_steel": ag.colored("abs", "anthracite"),
    "panel": ag.material("black_abs"),
}
_FINISH, _METAL = fronts(), grip_metals()
_PLASTICS = (
    ag.colored("abs", "light_grey"),
    ag.colored("abs", "slate"),
    ag.colored("abs", "grey"),
    ag.colored("abs", "navy"),
)


@ag.category(
    labels=(
        "body", "tub", "seal", "insulation", "worktop", "kick_plate", "foot", "rail", "filter", "hose",
        "cord", "rating_plate", "door", "panel", "handle", "print", "display", "vent", "hinge", "dispenser",
        "rinse_cap", "detergent_flap", "button", "knob", "rack", "grip", "roller", "cutlery_basket",
        "cup_shelf", "spray_arm",
    ),
    joints=(4, 15),
)  # fmt: skip
def dishwasher(
    *,
    build: Build = ag.choice("built_in", "freestanding", weights=(0.62, 0.38)),
    size: Size = ag.choice("full", "slim", weights=(0.66, 0.34), doc="width of the machine: 60 or 45 cm"),
    controls: Controls = ag.by(
        "build",
        built_in=ag.choice("front", "top", weights=(0.5, 0.5)),
        freestanding="front",
        doc="position of the console: in front, or on the upper edge of the door",
    ),
    look: Look = ag.by(
        "build",
        built_in=ag.by(
            "controls",
            front=ag.choice(
                "stainless", "dark_steel", "white", "black", "glass", weights=(0.35, 0.2, 0.15, 0.15, 0.15)
            ),
            top=ag.choice(
                "stainless",
                "dark_steel",
                "white",
                "black",
                "glass",
                "panel",
                weights=(0.22, 0.14, 0.08, 0.08, 0.08, 0.4),
            ),
        ),
        freestanding=ag.choice(
            "stainless", "dark_steel", "white", "black", "pastel", weights=(0.28, 0.12, 0.25, 0.1, 0.25)
        ),
    ),
    handle: HandleKind = ag.by(
        "build",
        built_in=ag.by(
            "controls",
            front=ag.choice("bar", "pocket", "recessed", weights=(0.4, 0.35, 0.25)),
            top=ag.choice("bar", "recessed", weights=(0.72, 0.28)),
        ),
        freestanding=ag.choice("bar", "recessed", weights=(0.5, 0.5)),
    ),
    racks: int = ag.by(
        "size",
        full=ag.choice(2, 3, weights=(0.45, 0.55)),
        slim=ag.choice(1, 2, 3, weights=(0.2, 0.5, 0.3)),
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
        "look",
        white=ag.choice("steel", "plastic", weights=(0.6, 0.4)),
        otherwise=ag.choice("steel", "plastic", weights=(0.9, 0.1)),
    ),
    pane: bool = ag.by(
        "look",
        white=ag.choice(False, True, weights=(0.75, 0.25)),
        pastel=ag.choice(False, True, weights=(0.8, 0.2)),
        stainless=ag.choice(False, True),
        otherwise=ag.choice(False, True, weights=(0.3, 0.7)),
        doc="whether black glass lies on the console",
    ),
    dial: Literal["", "round", "fluted", "bar", "skirted", "capped"] = ag.by(
        "controls",
        front=ag.choice("", "round", "fluted", "bar", "skirted", "capped", weights=(7, 1, 1, 0.6, 0.6, 1)),
        top="",
        doc="style of the cycle dial of older machines; empty for none",
    ),
    buttons: int = ag.by("size", full=ag.count(0, 8), slim=ag.count(0, 5)),
    button_shape: ButtonShape = ag.choice("round", "square", "pill", "bar"),
    button_travel: ag.Float = ag.uniform(0.0016, 0.0030, "m"),
    button_force: ag.Float = ag.uniform(2.0, 5.0, "N"),
    show: str = ag.by(
        "controls",
        front=ag.choice("", "1:25", "3:10", "0:45", "24h", weights=(0.25, 0.25, 0.2, 0.15, 0.15)),
        top=ag.choice("", "2:05", "0:30"),
        doc="text of the display; empty for none",
    ),
    figures: Color = ag.choice("white", "red", "amber", "cyan", "green"),
    maker: str = ag.choice(*details.BRANDS),
    wire: ag.Material = ag.shades(*_WIRES, weights=(3, 2, 1.5, 0.7), color=0.05),
    plastic: ag.Material = ag.shades(*_PLASTICS, weights=(2, 2, 1.5, 0.6), color=0.05),
    grip: Grip = ag.choice("bar", "plate"),
    shelves: bool = ag.choice(True, False, weights=(0.65, 0.35), doc="cup shelves in the upper rack"),
    ballast: Literal["steel", "concrete"] = ag.choice("steel", "concrete", doc="material of the ballast"),
    rack_friction: ag.Float = ag.uniform(3.0, 8.0, "N"),
    pull: ag.Float = ag.uniform(17.0, 24.0, "N", doc="force at the handle that opens the door"),
) -> ag.Body:
    """Make a dishwasher: door, console, racks, spray arms, detergent flap."""
    if handle == "recessed":
        door_thickness = ag.require(
            door_thickness,
            door_thickness > 0.051,
            "a recessed handle needs depth: door_thickness must be > 0.051 m",
        )
    worktop = build == "freestanding" and controls == "front" and handle != "pocket"
    slim = size == "slim"
    girth = 0.0080
    projection = 0.040
    space = Space(
        width=width,
        height=height,
        depth=depth,
        projection=projection + 2.0 * girth if handle == "bar" else 0.0,
        thickness=door_thickness,
        plinth=plinth,
        wall=0.027 if slim else 0.031,
        roof=0.050 if worktop else 0.022,
        swing=swing,
        clearance=clearance,
        travel=travel,
    )
    lowest = Racks(space, size, wire, plastic, grip, rack_friction, racks < 3, shelves, height)
    room = space.ceiling - lowest.floor
    upper = lowest.floor + upper_level * room
    inside = Racks(space, size, wire, plastic, grip, rack_friction, racks < 3, shelves, upper)
    levels = (inside.upper_axle, inside.tray_axle)[: racks - 1]
    look_of_tub = _TUB_STEEL if tub == "steel" else _TUB_PLASTIC
    sides = ag.material("zinc") if build == "built_in" else cabinet_finish(look, finish)
    cabinet = Cabinet(
        space,
        build,
        worktop,
        sides,
        look_of_tub,
        kick_finish(sides, build),
        sides if look in ("pastel", "glass", "panel") else ag.colored("lacquered_mdf", _WORKTOPS[look]),
        {"steel": 520.0, "concrete": 640.0}[ballast],
        levels,
        maker,
    )

    high = 0.112
    grip_length = 0.12 if slim else 0.17
    half = width / 2.0
    let_in = handle == "recessed" and controls == "front"
    console = Console(
        width=width - 0.003,
        height=high if controls == "front" else door_thickness,
        finish=_CONSOLES.get(look, finish),
        pane=pane and not let_in,
        buttons=min(buttons, 5) if let_in else buttons,
        shape=button_shape,
        cap=ag.material("black_abs") if pane or look in ("black", "dark_steel") else ag.material("aluminium"),
        travel=button_travel,
        force=button_force,
        dial=dial,
        show=show,
        color=figures,
        middle=-0.54 * half,
        aside=0.30 * half if not let_in else 0.60 * half,
        far=0.80 * half,
        upper=controls == "top",
        opening=(grip_length / 2.0, RECESS_HALF) if let_in else (0.0, 0.0),
        thickness=CONSOLE_BEFORE_POCKET if handle == "pocket" and controls == "front" else 0.018,
    )
    dispenser = Dispenser(space, inside.rim, 0.100 if slim else 0.128)
    front = Front(
        space=space,
        worktop=worktop,
        controls=controls,
        console=console,
        high=high,
        handle=handle,
        bar=bar,
        length=0.72 * width if handle == "bar" else grip_length,
        projection=projection,
        girth=girth,
        metal=metal,
        finish=finish,
        framed=framed and handle != "recessed",
        liner=look_of_tub,
        maker="" if look == "panel" else maker,
        dispenser=dispenser,
    )

    hinge = front.hinge(pull)
    play = REACH - 0.0006
    door = front.body().attach(dispenser.flap(), dispenser.slide((hinge > 1.2).beyond(dispenser.slack)))
    body = cabinet.body().attach(door, hinge)
    body = body.attach(inside.lower_arm("spray_arm_0"), inside.spin("spray_arm_spin_0"))
    made = [inside.lower, inside.upper_rack, inside.tray][:racks]
    for number, make in enumerate(made):
        rack = make(f"rack_{number}")
        if number == 1:
            rack = rack.attach(inside.upper_arm("spray_arm_1"), inside.spin("spray_arm_spin_1"))
        clear = space.angle_over(inside.low_ends[number], GRIP_REACH if number else 0.0)
        body = body.attach(rack, inside.slide(f"rack_slide_{number}", (hinge > clear).beyond(play)))
    return body
