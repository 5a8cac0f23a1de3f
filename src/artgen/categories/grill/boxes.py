"""Grills with a box: gas on a cart with doors and folding shelves, portable gas, a contact grill."""

import math

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.grill.parts import (
    Look,
    bar_on_posts,
    held_lid,
    lifts_out,
    rolls,
    square_grate,
    thermometer,
    wheel,
)
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import corner_feet
from artgen.nodes.fitting import FIT, Fitting

_DEEP = 0.50  # depth of a cart [m]
_OPEN = 1.60  # angle of the open lid of a box [rad]
_SWEEP = 4.2  # turn of a knob [rad]
_BLACK = ag.material("powder_coat_black")
_IRON = ag.material("cast_iron").with_(name="plate_iron", density=2500.0, specular_roughness=0.55)


def _tub(room: ag.Region, wall: float, floor: float) -> list[ag.Solid]:
    """Make an open box."""
    inner = room.shrink(x=wall, y=wall)
    sides = [
        room.with_(y=(room.y.low, inner.y.low)),
        room.with_(y=(inner.y.high, room.y.high)),
        inner.with_(x=(room.x.low, inner.x.low)).grow(y=0.0004),
        inner.with_(x=(inner.x.high, room.x.high)).grow(y=0.0004),
    ]
    return [*(side.box() for side in sides), room.with_(z=(room.z.low, room.z.low + floor)).box()]


def _hood(room: ag.Region, soft: float) -> ag.Solid:
    """Make a lid with a round front and back over a region."""
    y, z = room.y, room.z
    profile = ag.polygon(
        [
            (y.low, z.low), (y.high, z.low), (y.high, z.low + 0.45 * z.size),
            (y.high - 0.30 * y.size, z.high),
            (y.low + 0.42 * y.size, z.high), (y.low + 0.10 * y.size, z.low + 0.62 * z.size),
        ],
        radius=soft,
    )  # fmt: skip
    profile |= ag.rectangle(y.size, 0.4 * z.size).at(y.mid, z.low + 0.2 * z.size)
    return ag.extrude(profile, room.x.size, axis=ag.X, bevel=0.002)


def _lid(room: ag.Region, look: Look, density: float, soft: float, length: ag.Scalar) -> ag.Body:
    """Make the lid of a box with a bar before its front."""
    shell = ag.simplified_collider(_hood(room, soft), 0.001)
    bar, posts = bar_on_posts(length, 0.058, look)
    at = (0, room.y.low + 0.035 * room.y.size, room.z.low + 0.30 * room.z.size)
    hold = ag.grasp_on(bar.at(at), approach=ag.Y, closing=ag.Z, depth=0.014)
    stuff = look.thin(density, "lid")
    return ag.weld(
        ag.part(bar.at(at), "handle", casting(look.grip, 0.5), name="lid", grasp=hold),
        ag.part(posts.at(at), "handle", look.metal),
        ag.part(shell, "lid", stuff),
        _under(room),
    )


def _under(room: ag.Region) -> ag.Body:
    """Print the dark inside of a lid."""
    sheet = ag.rectangle(room.x.size - 0.016, room.y.size - 0.016, radius=0.01)
    return details.printed(sheet, (0, room.y.mid, room.z.low), material=DARK, facing=-ag.Z, label="lid")


def _hinged(
    body: ag.Body,
    lid: ag.Body,
    room: ag.Region,
    x: ag.Scalar,
    metal: ag.Material,
    share: float,
    drop: ag.Scalar,
) -> tuple[ag.Body, ag.Joint]:
    """Add a lid on two hinges behind it."""
    y, z = room.y.high + 0.014, room.z.low + 0.010
    lower = ag.Region((0, 0), (drop, y + 0.005), (z - 0.034, z - 0.0112))
    upper = ag.Region((0, 0), (room.y.high + 0.003, y + 0.005), (z - 0.013, z))
    barrels, ears = [], []
    for side in (-1, 1):
        at = side * x
        barrels.append(
            ag.cylinder(0.008, 0.040, axis=ag.X, bevel=0.001).at(at, y, z)
            | ag.Region((at - 0.019, at + 0.019), (room.y.high - 0.006, y), (z - 0.006, z + 0.006)).box()
        )
        ears += [
            ag.cylinder(0.008, 0.010, axis=ag.X, bevel=0.001).at(at + way * 0.0258, y, z)
            | lower.with_(x=(at + way * 0.0258 - 0.005, at + way * 0.0258 + 0.005)).box()
            | upper.with_(x=(at + way * 0.0258 - 0.005, at + way * 0.0258 + 0.005)).box()
            for way in (-1, 1)
        ]
    lid = ag.weld(lid, ag.part(barrels, "hinge", metal))
    hinge = held_lid(lid, (0, y, z), room.y.size, _OPEN, share=share)
    return ag.weld(body, ag.part(ears, "hinge", metal)).attach(lid, hinge), hinge


def _knob(number: int, radius: float, look: Look) -> Fitting:
    """Make the knob of a burner on the plane y = 0: off is up."""
    turn = controls.dial_turn(
        f"dial_turn_{number}",
        low=0.0,
        high=_SWEEP,
        friction=0.05,
        clicks=(0.0, _SWEEP / 2, _SWEEP),
        torque=0.12,
    )
    scale = controls.dial_print(radius, ink=controls.LIGHT_INK, style="band", sweep=_SWEEP, start=0.0)
    return controls.dial(
        turn,
        "bar",
        radius,
        ag.material("black_abs"),
        depth=0.030,
        cap=look.metal,
        scale=scale,
        name=f"dial_{number}",
    )


def gas(wide: ag.Scalar, rim: ag.Scalar, burners: int, look: Look) -> ag.Body:
    """Make gas burners in a box on a cart with doors, two wheels and shelves that fold down."""
    half = wide / 2
    cart = ag.Region((-half, half), (-_DEEP / 2, _DEEP / 2), (0.075, rim - 0.170))
    sheet = 0.014
    panels = [
        cart.with_(x=(-half, sheet - half)),
        cart.with_(x=(half - sheet, half)),
        cart.with_(y=(cart.y.high - sheet, cart.y.high)),
        cart.with_(z=(0.075, 0.100)),
        cart.with_(z=(cart.z.high - sheet, cart.z.high)),
    ]
    panels = [panels.pop(2), *(each.shrink(front=0.022) for each in panels)]
    shelf = _BLACK.with_(name="cart_sheet", density=480.0)
    tub = cart.with_(z=(rim - 0.171, rim))
    front = ag.Region((-half, half), (-_DEEP / 2 - 0.075, 0.004 - _DEEP / 2), (rim - 0.150, rim - 0.020))
    tank = ag.cylinder(0.10, 0.30, bevel=0.04).at(-0.10, 0.04, 0.249)
    valve = ag.cylinder(0.03, 0.06, bevel=0.004).at(-0.10, 0.04, 0.425)
    feet = [
        ag.cylinder(0.016, 0.080, bevel=0.002).at(x * (half - 0.05), 0.05 - _DEEP / 2, 0.040) for x in (-1, 1)
    ]
    back = _DEEP / 2 - 0.075
    rod = ag.cylinder(0.006, wide + 0.010, axis=ag.X).at(0, back, 0.070)
    bearing = [
        ag.Region((x - 0.012, x + 0.012), (back - 0.02, back + 0.02), (0.058, 0.080)).box()
        for x in (0.075 - half, half - 0.075)
    ]
    body = ag.weld(
        ag.part([panel.box() for panel in panels], "body", shelf, name="body"),
        ag.part(_tub(tub, 0.012, 0.012), "body", _BLACK.with_(name="tub", density=1050.0)),
        ag.part(front.box(bevel=0.004), "panel", filled(ag.material("stainless"), 330.0, "panel")),
        ag.part([tank, valve], "tank", ag.colored("enamel", "light_grey").with_(name="tank", density=560.0)),
        ag.part([*feet, rod, *bearing], "leg", casting(_BLACK, 0.5)),
    )
    for number, x in enumerate(controls.places(burners, wide / (burners + 0.6))):
        body = body.install(_knob(number, 0.028, look), at=(x, front.y.low, front.z.mid))
        body = body.output(f"burner_{number}", signals.level(f"dial_turn_{number}"), kind="heat")
    body = ag.weld(
        body,
        details.printed(
            details.logo(look.maker, 0.010),
            (0, front.y.low, front.z.high - 0.016),
            material=controls.DARK_INK,
        ),
    )
    hood = ag.Region((-half, half), (0.002 - _DEEP / 2, _DEEP / 2), (rim + FIT.running, rim + 0.260))
    lid = _lid(hood, look, 105.0, 0.05, 0.72 * wide)
    lid = ag.weld(
        lid,
        *thermometer((0, hood.y.low + 0.16 * _DEEP, hood.z.low + 0.69 * 0.26), (0, -0.66, 0.75), look.metal),
    )
    body, hinge = _hinged(body, lid, hood, 0.36 * wide, look.metal, 0.5, _DEEP / 2 - 0.01)
    grate = square_grate(wide - 0.036, _DEEP - 0.036).at(z=rim - 0.040)
    body = ag.weld(body, ag.part(_ledges(tub, rim - 0.0442), "body", _BLACK))
    body = body.attach(grate, lifts_out(hinge, _OPEN, 0.040))
    body = _doors(body, cart, look)
    body = _shelves(body, half, rim, look)
    place = (half + 0.022, back, 0.070)
    return body.attach_pair(wheel(0.070, 0.030, look.metal).at(place), rolls(place))


def _ledges(tub: ag.Region, level: ag.Scalar) -> list[ag.Solid]:
    """Make the ledges below a grate."""
    return [
        tub.with_(y=span, z=(level - 0.010, level)).shrink(x=0.010).box()
        for span in ((tub.y.low + 0.010, tub.y.low + 0.030), (tub.y.high - 0.030, tub.y.high - 0.010))
    ]


def _doors(body: ag.Body, cart: ag.Region, look: Look) -> ag.Body:
    """Add the two doors of a cart."""
    leaf = ag.Region(
        (0.0015, cart.x.high - 0.003), (cart.y.low, cart.y.low + 0.018), (0.085, cart.z.high - 0.004)
    )
    bar = ag.cylinder(0.007, 0.16, bevel=0.002).at(0.045, leaf.y.low - 0.034, leaf.z.at(0.72))
    posts = [
        ag.cylinder(0.005, 0.036, axis=ag.Y).at(0.045, leaf.y.low - 0.017, leaf.z.at(0.72) + z)
        for z in (-0.06, 0.06)
    ]
    hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.X, depth=0.012)
    door = ag.weld(
        ag.part(bar, "handle", look.metal, name="door", grasp=hold),
        ag.part(posts, "handle", look.metal),
        ag.part(leaf.box(bevel=0.002), "door", look.thin(900.0, "door")),
    )
    pivot = (cart.x.high - 0.003, cart.y.low + 0.001, 0)
    hinge = ag.Revolute("door_hinge", axis=ag.Z, pivot=pivot, limits=(0, 1.7), feel=feel.HINGE, friction=0.3)
    return body.attach_pair(door, hinge)


def _shelves(body: ag.Body, half: ag.Scalar, rim: ag.Scalar, look: Look) -> ag.Body:
    """Add a shelf at each side, which folds down."""
    y, z = _DEEP / 2 - 0.03, rim - 0.035
    plate = ag.Region((half + 0.0245, half + 0.300), (-y, y), (z - 0.014, z + 0.014))
    barrel = ag.cylinder(0.009, 0.34, axis=ag.Y, bevel=0.001).at(half + 0.0135, 0, z)
    web = ag.Region((half + 0.0135, half + 0.028), (-0.165, 0.165), (z - 0.008, z + 0.008)).box()
    ears = [
        ag.cylinder(0.009, 0.030, axis=ag.Y, bevel=0.001).at(half + 0.0135, side * 0.1858, z)
        | ag.Region(
            (half - 0.006, half + 0.0135),
            (side * 0.1858 - 0.015, side * 0.1858 + 0.015),
            (z - 0.009, z + 0.009),
        ).box()
        for side in (-1, 1)
    ]
    sheet = plate.box(bevel=0.004)
    press_down = ag.push_on(sheet, direction=-ag.Z, at=(half + 0.270, 0, z))
    shelf = ag.weld(
        ag.part(sheet, "shelf", filled(look.metal, 900.0, "shelf"), name="shelf", push=press_down),
        ag.part([barrel, web], "hinge", look.metal.with_(name="shelf_hinge", density=2000.0)),
    )
    moment = shelf.weight() * 0.16
    fold = ag.Revolute(
        "shelf_hinge", axis=ag.Y, pivot=(half + 0.0135, 0, z), limits=(0, 1.52),
        friction=1.2 * moment, damping=0.2, armature=2e-3, effort=40.0,
    )  # fmt: skip
    fixed = ag.part(ears, "hinge", look.metal)
    return ag.weld(body, fixed, fixed.mirror(ag.X)).attach_pair(shelf, fold)


def portable(wide: ag.Scalar, rim: ag.Scalar, look: Look) -> ag.Body:
    """Make a small gas grill for a table on two bent legs."""
    deep, half = 0.33, wide / 2
    tub = ag.Region((-half, half), (-deep / 2, deep / 2), (rim - 0.105, rim))
    legs = []
    for side in (-1, 1):
        x = side * (half - 0.05)
        y, sole = deep / 2 + 0.0075, 0.009 * math.cos(math.pi / 8)
        line = [(x, -y, rim - 0.06), (x, -y, sole), (x, y, sole), (x, y, rim - 0.06)]
        legs.append(ag.sweep(ag.regular_polygon(8, 0.009), ag.polyline(line)))
    tray = tub.shrink(x=0.10, y=0.06).with_(z=(rim - 0.128, rim - 0.104)).box(bevel=0.003)
    front = ag.Region((-0.062, 0.062), (-deep / 2 - 0.030, 0.004 - deep / 2), (rim - 0.092, rim - 0.018)).box(
        bevel=0.005
    )
    body = ag.weld(
        ag.part(_tub(tub, 0.012, 0.012), "body", look.thin(950.0, "tub"), name="body"),
        ag.part(front, "panel", casting(ag.material("black_abs"), 0.5)),
        ag.part([*legs], "leg", casting(look.metal, 0.4)),
        ag.part(tray, "tray", look.metal.with_(name="drip_tray", density=350.0)),
        ag.part(_ledges(tub, rim - 0.0442), "body", _BLACK),
    )
    body = body.install(_knob(0, 0.022, look), at=(0, -deep / 2 - 0.030, rim - 0.056))
    body = body.output("burner_0", signals.level("dial_turn_0"), kind="heat")
    hood = ag.Region((-half, half), (0.002 - deep / 2, deep / 2), (rim + FIT.running, rim + 0.145))
    lid = _lid(hood, look, 165.0, 0.035, 0.30)
    lid = ag.weld(
        lid,
        *thermometer((0, hood.y.low + 0.16 * deep, hood.z.low + 0.69 * 0.145), (0, -0.44, 0.9), look.metal),
    )
    body, hinge = _hinged(body, lid, hood, 0.34 * wide, look.metal, 0.2, deep / 2 - 0.01)
    grate = square_grate(wide - 0.036, deep - 0.036).at(z=rim - 0.040)
    handles = []
    for side, name in ((-1, "left"), (1, "right")):
        bar = ag.cylinder(0.011, 0.13, axis=ag.Y, bevel=0.003).at(side * (half + 0.036), 0, rim - 0.035)
        posts = [
            ag.cylinder(0.006, 0.042, axis=ag.X).at(side * (half + 0.016), y, rim - 0.035)
            for y in (-0.045, 0.045)
        ]
        hold = ag.grasp_on(bar, approach=-side * ag.X, closing=ag.Z, depth=0.014)
        handles += [
            ag.part(bar, "handle", casting(look.grip, 0.8), name=f"handle_{name}", grasp=hold),
            ag.part(posts, "handle", look.metal),
        ]
    body = ag.weld(body, *handles)
    return body.attach(grate, lifts_out(hinge, _OPEN, 0.040))


def press(wide: ag.Scalar, rim: ag.Scalar, look: Look) -> ag.Body:
    """Make an electric contact grill, whose upper plate floats."""
    deep, half = 0.30, wide / 2
    base = ag.Region((-half, half), (-deep / 2, deep / 2), (0.010, rim - 0.006))
    slot = ag.Region((-0.11, 0.11), (base.y.low - 0.01, base.y.low + 0.17), (0.022, 0.044))
    lower = ag.Region(
        (0.012 - half, half - 0.012), (base.y.low + 0.012, base.y.high - 0.030), (rim - 0.008, rim)
    )
    ears = []
    z, y = rim + 0.050, base.y.high - 0.012
    for side in (-1, 1):
        x = side * (half + 0.0125)
        ears.append(
            ag.Region((x - 0.008, x + 0.008), (y - 0.022, y + 0.014), (0.030, z + 0.036)).box(bevel=0.003)
        )
        ears.append(
            ag.Region(
                (x - 0.016, x + 0.002) if side > 0 else (x - 0.002, x + 0.016),
                (y - 0.020, y + 0.012),
                (0.032, rim - 0.010),
            ).box()
        )
    shell = base.box(bevel=0.008) - slot.box().paint(DARK)
    body = ag.weld(
        ag.part(shell, "body", filled(ag.material("black_abs"), 300.0, "base"), name="body"),
        ag.part(lower.box(bevel=0.002), "plate", _IRON),
        ag.part(ears, "hinge", filled(look.finish, 900.0, "arm")),
        corner_feet(wide, deep, inset=0.03, height=0.010),
        cord_stub(height=0.030).at(0.06, base.y.high, 0.030),
        *_ribs(lower, rim, ag.Z),
        details.rating_plate(
            0.056,
            0.022,
            (f"{look.maker.upper()} 2000 W", "220-240 V~ 50/60 Hz"),
            at=(-0.04, base.y.high, 0.045),
            facing=ag.Y,
        ),
    )
    button = controls.push_button(
        finish=look.metal, through=0.0125, width=0.018, icon="power", ink=controls.ink_on(look.metal)
    )
    body = body.install(button, at=(half - 0.032, base.y.low, 0.060))
    on = signals.toggle(signals.pressed("button_slide"))
    heats = signals.timer(on, 180.0, unless=~on)
    body = body.output("heat", on, kind="heat")
    for x, name, led, lit in ((-0.03, "power", "led_green", on), (-0.045, "heating", "led_red", heats)):
        lamp = ag.material(led).with_(name=f"lamp_{name}", emission=(0.0, 0.0, 0.0))
        body = ag.weld(
            body,
            details.printed(
                ag.circle(0.0025), (half - 0.032 + x, base.y.low, 0.060), material=lamp, label="lamp"
            ),
        )
        body = body.output(name, lit, kind="light", material=lamp, color=ag.material(led).emission)
    tray = slot.shrink(0.0015, front=0.010).grow(front=0.0)
    face = ag.Region((-0.108, 0.108), (base.y.low - 0.0150, base.y.low + 0.001), (0.0235, 0.0425)).box(
        bevel=0.002
    )
    lip = ag.box(0.060, 0.022, 0.010, bevel=0.003).at(0, base.y.low - 0.024, 0.0335)
    hold = ag.grasp_on(lip, approach=ag.Y, closing=ag.X, depth=0.016)
    drawer = ag.weld(
        ag.part(lip, "handle", ag.material("black_abs"), name="tray", grasp=hold),
        ag.part([face, tray.box()], "tray", filled(ag.material("black_abs"), 420.0, "tray")),
    )
    slide = ag.Prismatic("tray_slide", axis=-ag.Y, limits=(0, 0.14), friction=1.5, damping=4.0, effort=40.0)
    body = body.attach(drawer, slide)
    return _upper(body, lower, rim, y, z, half, look)


def _ribs(plate: ag.Region, level: ag.Scalar, facing: ag.Vector) -> list[ag.Body]:
    """Make the ribs of a plate, which are only seen."""
    slots = details.vent_slots(plate.x.size - 0.02, plate.y.size - 0.02, 18, slot=0.006)
    return [details.printed(slots, (0, plate.y.mid, level), material=DARK, facing=facing, label="plate")]


def _upper(
    body: ag.Body, lower: ag.Region, rim: ag.Scalar, y: ag.Scalar, z: ag.Scalar, half: ag.Scalar, look: Look
) -> ag.Body:
    """Add the upper plate with its case, on a hinge that floats."""
    low = rim + 0.0012
    plate = lower.with_(z=(low, low + 0.010)).box(bevel=0.002)
    case = ag.Region(
        (0.006 - half, half - 0.006), (lower.y.low - 0.006, lower.y.high + 0.004), (low + 0.008, low + 0.062)
    )
    shell = ag.hull(
        case.with_(z=(case.z.low, case.z.low + 0.030)).box(bevel=0.006),
        case.shrink(x=0.016, y=0.020).with_(z=(case.z.high - 0.010, case.z.high)).box(bevel=0.004),
    )
    pins = [ag.cylinder(0.010, 0.014, axis=ag.X).at(side * (half - 0.004), y, z) for side in (-1, 1)]
    arms = [
        ag.Region(
            (side * (half - 0.006) - 0.005, side * (half - 0.006) + 0.005),
            (case.y.high - 0.04, y),
            (z - 0.010, z + 0.010),
        ).box()
        for side in (-1, 1)
    ]
    out = case.y.low - 0.050
    x, y_in = half - 0.05, case.y.low + 0.02
    line = [(-x, y_in, low + 0.036), (-x, out, low + 0.046), (x, out, low + 0.046), (x, y_in, low + 0.036)]
    bar = ag.sweep(ag.regular_polygon(8, 0.0085), ag.polyline(line))
    grip = ag.cylinder(0.0120, 2 * half - 0.14, axis=ag.X, bevel=0.003).at(0, out, low + 0.046)
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.Z, depth=0.014)
    lid = ag.weld(
        ag.part(grip, "handle", casting(look.grip, 0.6), name="lid", grasp=hold),
        ag.part(bar, "handle", casting(look.metal, 0.4)),
        ag.part(shell, "lid", filled(look.finish, 260.0, "lid")),
        ag.part(plate, "plate", _IRON),
        ag.part([*pins, *arms], "hinge", filled(look.finish, 900.0, "arm")),
        *_ribs(lower, low, -ag.Z),
        details.printed(
            details.logo(look.maker, 0.010),
            (0, case.y.mid - 0.02, case.z.high),
            material=look.ink,
            facing=ag.Z,
        ),
    )
    lift = ag.Prismatic("lid_lift", axis=ag.Z, limits=(0, 0.025), friction=0.3, damping=20.0, effort=60.0)
    moment = lid.weight() * 0.15
    hinge = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=(0, y, z), limits=(0, 1.62), friction=1.15 * moment, damping=0.3,
        armature=5e-3, effort=40.0,
    )  # fmt: skip
    return body.attach(lid, lift, hinge)
