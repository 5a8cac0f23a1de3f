"""A washing machine that is loaded from the front.

Links: `body`; `drum`, which a motor turns; `door` with its glass bowl; `drawer` for detergent; `dial` of the
programs; `key_0`, ... with return springs. Sizes are those of catalogs: 0.60 x 0.53-0.62 x 0.85 m, 60-75 kg,
a drum of 52-64 l and a porthole of 30-34 cm for 7-10 kg of laundry.
"""

import math

import artgen as ag
from artgen import details, feel, fittings
from artgen.fittings import FIT

SHEET, PANEL = 0.004, 0.115  # modeled thickness of the sheet, height of the control panel [m]
STEEL = ag.material("stainless").with_(
    name="drum_steel", texture="", density=1600.0
)  # 0.5 mm, drawn 3 mm thick
RUBBER = ag.colored("silicone", "grey").with_(name="bellow")
GLASS = ag.material("glass").with_(name="bowl_glass", opacity=0.25, density=450.0)  # a hollow bowl
CHROME, DARK = ag.material("chrome"), ag.colored("abs", "anthracite")
LIGHT = ag.colored("abs", "light_grey").with_(name="keys", texture="")
KEYS = ("power", "timer", "thermometer", "spin", "play")
PROGRAMS = ("drop", "leaf", "sun", "clock", "snowflake", "fan")


def ring(outer: ag.Scalar, inner: ag.Scalar, y: ag.Span, bevel: float = 0.0) -> ag.Solid:
    """Make a ring about the Y axis between two depths."""
    return ag.tube(outer, inner, y[1] - y[0], axis=ag.Y, bevel=bevel).at(y=(y[0] + y[1]) / 2)


def case_of(
    case: ag.Region, panel: ag.Region, slot: ag.Region, hole: ag.Scalar, at: ag.Vector, white: ag.Material
) -> ag.Body:
    """Make sheet, worktop, control panel, suspension and weights around the tub."""
    lower = case.with_(z=(case.z.low, panel.z.low))
    opening = ag.extrude(ag.regular_polygon(20, hole).rotate(0.157), 0.1, axis=ag.Y)  # few colliders
    face = lower.with_(y=(lower.y.low, lower.y.low + SHEET)).box(bevel=0.0015)
    sides = [case.with_(x=x).shrink(front=SHEET, top=0.03) for x in case.x.split(SHEET, None, SHEET)[::2]]
    rear = case.shrink(x=SHEET, top=0.03).deep(None, SHEET)[1]
    floor = case.shrink(x=SHEET, y=SHEET).stack(None, 0.012)[1]
    top = case.with_(z=(case.z.high - 0.03, case.z.high)).box(bevel=0.003)
    behind = panel.with_(y=(panel.y.low + 0.012, case.y.low + 0.19)).shrink(x=SHEET)
    console = [
        each.box(bevel=0.001) for each in panel.grow(back=0.012).shrink(x=0.001).around(slot, lap=FIT.lap)
    ]
    housing = [each.box() for each in behind.shrink(front=0.0115).around(slot, lap=FIT.lap)]
    tub = case.shrink(x=0.03).with_(
        y=(case.y.high - 0.09, case.y.high - SHEET / 2), z=(at.z - 0.2, at.z + 0.2)
    )
    # weights of concrete, motor, pump and wires
    heavy = ag.material("steel").with_(name="works", density=720.0)
    base = floor.shrink(x=0.02).grow(top=0.04).at(z=0.0119)
    bellow = ring(hole + 0.012, hole - 0.004, (0.001, 0.045), bevel=0.004).at(at)
    return ag.weld(
        ag.part(face - opening.at(at), "body", white),
        ag.part([each.box() for each in (*sides, rear, floor)], "body", white),
        ag.part([top, *console], "body", white),
        ag.part([tub.box(), *housing, base.box()], "works", heavy),
        ag.detail(bellow, "gasket", RUBBER),
        ag.detail(ring(hole + 0.018, hole - 0.001, (-0.0015, 0.0005), bevel=0.0004).at(at), "body", CHROME),
    )


def drum_of(radius: ag.Scalar, y: ag.Span) -> ag.Body:
    """Make the drum about the Y axis, open to the front, with three lifters."""
    wall = ag.rectangle(0.003, y[1] - y[0]).at(radius - 0.0015, 0)
    # a hollow solid collides as one piece for each side; a smooth skin hides them
    shell = ag.revolve(wall, axis=ag.Y, sides=24).at(y=(y[0] + y[1]) / 2)
    skin = ring(radius * math.cos(math.pi / 24) - 0.003, radius - 0.006, y)
    lip = ring(radius - 0.003, radius - 0.04, (y[0] - 0.001, y[0] + 0.004), bevel=0.001)
    back = ag.cylinder(radius * 0.98, 0.004, axis=ag.Y).at(y=y[1] - 0.002)
    side = ag.polygon([(-0.03, 0), (0.03, 0), (0.008, 0.055), (-0.008, 0.055)])
    lifter = ag.extrude(side, y[1] - y[0] - 0.04, axis=ag.Y, bevel=0.004)
    lifter = lifter.at(0, (y[0] + y[1]) / 2, 0.004 - radius)
    lifters = [lifter.rotate(ag.Y, math.tau * turn / 3) for turn in range(3)]
    shaft = ag.cylinder(0.02, 0.02, axis=ag.Y).at(y=y[1] + 0.009)
    return ag.weld(
        ag.part([shell, back, shaft], "drum", STEEL),
        ag.detail([skin, lip], "drum", STEEL),
        ag.part(lifters, "lifter", ag.colored("abs", "grey")),
    )


def door_of(radius: ag.Scalar, hole: ag.Scalar, white: ag.Material) -> ag.Body:
    """Make the round door about the Y axis, before the plane y = 0: a frame with a handle, and the bowl."""
    section = ag.rectangle(radius - hole + 0.03, 0.03, radius=0.008).at((radius + hole - 0.03) / 2, 0.019)
    frame = ag.revolve(section, axis=-ag.Y, sides=36)
    x, out, half = radius - 0.022, -0.072, 0.070
    line = ag.polyline([(x, -0.03, -half), (x, out, -half), (x, out, half), (x, -0.03, half)], fillet=0.014)
    grip = ag.bounding_collider(ag.Region.centered(0.016, 0.008, 2 * half - 0.03).at(x, out).box(bevel=0.003))
    bow = ag.sweep(ag.rectangle(0.016, 0.008, radius=0.003), line)
    trim = ring(radius - 0.036, hole - 0.034, (-0.037, -0.032), bevel=0.002)
    near, far = hole - 0.028, hole - 0.065  # radii of the bowl
    outside = [(0.0, 0.098), (0.03, 0.098), (far, 0.085), (near, 0.004), (near, -0.006), (0.0, -0.006)]
    bowl = ag.revolve(ag.polygon([(r, -y) for r, y in outside]), axis=-ag.Y)  # convex: one collider
    pane = ag.cylinder(hole - 0.028, 0.003, axis=ag.Y).at(y=-0.024)
    return ag.weld(
        ag.part(frame, "door", white),
        ag.part([grip, bow], "handle", CHROME, name="door", grasp=ag.grasp_on(grip, closing=ag.X)),
        ag.detail(trim, "door", CHROME),
        ag.part([bowl, pane], "window", GLASS),
    )


def drawer_of(slot: ag.Region, white: ag.Material) -> ag.Body:
    """Make the detergent drawer with its three chambers, its front and a ledge to pull it."""
    room = slot.shrink(x=FIT.reveal, z=FIT.reveal, front=0.001, back=0.012)
    front, deep = room.grow(front=0.004).deep(0.012, None)
    tub = deep.grow(front=0.001).shrink(x=0.001, top=0.01)
    chambers = [each.shrink(0.0015).grow(top=0.05).box() for each in tub.columns(3)]
    ledge = front.grow(front=0.016).stack(None, 0.009)[1].shrink(x=0.012)
    grip = ledge.box(bevel=0.0035)
    held = ag.grasp_on(grip, approach=ag.Y, closing=ag.Z, depth=0.014)
    return ag.weld(
        ag.part([grip, front.box(bevel=0.003)], "drawer", white, grasp=held),
        ag.part(tub.box() - ag.union(*chambers), "drawer", LIGHT),
    )


@ag.category(
    labels="body works gasket drum lifter door handle window drawer dial button display print foot",
    joints=(8, 9),
)
def front_loader(
    *,
    width: ag.Float = ag.uniform(0.595, 0.600, "m", within=(0.58, 0.62)),
    depth: ag.Float = ag.uniform(0.53, 0.62, "m", doc="depth of the case", within=(0.50, 0.66)),
    height: ag.Float = ag.uniform(0.845, 0.850, "m", within=(0.82, 0.87)),
    hole: ag.Float = ag.uniform(0.152, 0.170, "m", doc="radius of the porthole", within=(0.145, 0.175)),
    radius: ag.Float = ag.uniform(0.238, 0.252, "m", doc="radius of the drum", within=(0.22, 0.255)),
    swing: ag.Float = ag.uniform(2.0, 2.6, "rad", doc="largest angle of the door", within=(1.5, 2.7)),
    keys: int = ag.count(4, 5, doc="number of keys"),
    finish: ag.Material = ag.shades("powder_coat_white", "powder_coat_graphite", weights=(0.8, 0.2)),
    show: str = ag.choice("0:59", "2:15", "3:29", doc="text of the display"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a washing machine, its door and its drawer closed."""
    finish = finish.with_(density=1200.0)  # sheets of 0.7 mm and plastic, drawn thicker
    case = ag.Region((-width / 2, width / 2), (0, depth), (0.012, height))
    panel = case.with_(y=(-0.002, SHEET + 0.006), z=(height - 0.03 - PANEL, height - 0.03))
    left, middle, right = panel.shrink(x=0.012, z=0.014).across(0.19, 0.10, None)
    slot = left.with_(y=(panel.y.low, 0.19))
    center = ag.vector(0, 0, 0.012 + (panel.z.low - 0.012) * 0.53)
    body = case_of(case, panel, slot, hole, center, finish)

    dial = fittings.dial(
        radius=0.030, depth=0.022, limits=None, scale="icons", icons=PROGRAMS, finish=CHROME, ink=DARK
    )
    screen, row = right.shrink(x=0.012).stack(0.040, 0.016, gap=0.018)
    cells = [cell.shrink(x=0.004) for cell in row.columns(keys)]
    shown = details.display(show, 0.075, 0.03, at=screen.anchor(x=-0.4, y=-1), color="white")
    name = details.printed(details.logo(maker, 0.008), screen.anchor(x=0.62, y=-1), material=CHROME)
    feet = ag.array(
        details.foot(0.02, 0.013), at=[(x, y, 0) for x in (-0.25, 0.25) for y in (0.06, depth - 0.06)]
    )
    body = ag.weld(body, shown, name, ag.part(feet, "foot", DARK))
    for index, (cell, icon) in enumerate(zip(cells, KEYS, strict=False)):
        key = fittings.push_button(
            shape="bar",
            width=cell.x.size,
            height=cell.z.size,
            icon=icon,
            finish=LIGHT,
            plate=None,
            name="key",
        )
        body = body.install(key.suffixed(f"_{index}"), at=cell.anchor(y=-1))
    body = body.install(dial, at=middle.anchor(y=-1))

    pull = ag.Prismatic("drawer_slide", axis=-ag.Y, limits=(0, 0.15), feel=feel.RUNNER)
    spin = ag.Revolute("drum_spin", axis=ag.Y, friction=0.3, damping=0.02, driven="a motor")
    door = door_of(hole + 0.045, hole, finish)
    hinge = ag.Revolute(
        "door_hinge",
        axis=-ag.Z,
        pivot=(-hole - 0.052, -0.018, 0),
        limits=(0, swing),
        feel=feel.HINGE,
        friction=1.2,
    )
    body = body.attach(drawer_of(slot, finish), pull)
    body = body.attach(drum_of(radius, (0.06, depth - 0.14)), spin, at=center)
    return body.attach(door, hinge, at=center)
