"""A printer on a table: an inkjet or a laser printer with a scanner, or a plain laser printer.

Links: `body`; `cassette_0`, ..., from below; `flap` over the slot for single sheets of a laser printer; `lid`
over the glass of a scanner; `panel`, with `button_0`, ..., or these keys in the body of a plain printer.
Joints: `cassette_slide_0`, ...; `flap_hinge`; `lid_hinge`; `panel_tilt`; `button_slide_0`, ....

Cassettes slide out to the front, the flap falls open to the front, the panel tilts up to the user, and the
lid stays at any angle. Paper lies in the cassettes.

Sizes are those of shops: inkjet printers with a scanner are 0.42-0.48 m wide, 0.33-0.40 m deep and
0.16-0.26 m high, 6-10 kg; laser printers 0.36-0.42 m, 0.36-0.42 m and 0.21-0.32 m, 7-14 kg; those with a
scanner 0.39-0.45 m, 0.39-0.45 m and 0.36-0.52 m, 12-24 kg. A cassette holds 150-300 sheets of A4.
"""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, furniture, require_size
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import Fitting

Style = Literal["inkjet", "laser", "multi"]
"""An inkjet printer with a scanner, a laser printer, or one with a scanner."""

_BAY = 0.058  # height of a cassette [m]
_DENSITY = {"inkjet": 230.0, "laser": 330.0, "multi": 300.0}  # of a body with its works [kg/m3]
_FOOT = 0.006  # height of the feet [m]
_GLASS = ag.material("black_glass").with_(name="scanner_glass")
_PAPER = ag.material("powder_coat_white").with_(
    name="paper", specular_roughness=0.85, density=800.0, base_color=(0.86, 0.86, 0.84)
)
_DARK = ag.colored("abs", "graphite")
_CASES = colors("leather_grain_abs", "white light_grey graphite black")
_TRIMS = colors("abs", "graphite black grey white")
_KEYS = ("power", "stop", "repeat", "wifi", "return", "check")


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a printer."""

    style: Style
    case: ag.Region  # body without feet and lid
    finish: ag.Material
    trim: ag.Material
    maker: str

    @property
    def shell(self) -> ag.Material:
        """Material of the body, with the works inside."""
        return self.finish.with_(name=f"{self.finish.name}_works", density=_DENSITY[self.style])

    def bay(self, wide: ag.Scalar, low: ag.Scalar, high: ag.Scalar, deep: ag.Scalar) -> ag.Region:
        """Return a bay in the front between two heights, with a width and a depth."""
        front = self.case.y.low
        return ag.Region((-wide / 2, wide / 2), (front, front + deep), (low, high))


@ag.category(
    labels="body foot cassette paper flap lid glass pad feeder panel button display bezel handle socket vent "
    "rating_plate print",
    joints=(4, 11),
)
def printer(
    *,
    style: Style = ag.choice({"inkjet": 0.42, "laser": 0.26, "multi": 0.32}),
    width: ag.Float = ag.by(
        "style",
        inkjet=ag.uniform(0.425, 0.475),
        laser=ag.uniform(0.365, 0.415),
        multi=ag.uniform(0.395, 0.445),
        unit="m",
        within=(0.36, 0.52),
    ),
    depth: ag.Float = ag.by(
        "style",
        inkjet=ag.uniform(0.33, 0.39),
        laser=ag.uniform(0.365, 0.415),
        multi=ag.uniform(0.385, 0.435),
        unit="m",
        within=(0.32, 0.48),
    ),
    cassettes: int = ag.by("style", inkjet={1: 3, 2: 1}, otherwise={1: 3, 2: 2}, doc="cassettes for paper"),
    upper: ag.Float = ag.by(
        "style",
        inkjet=ag.uniform(0.062, 0.085),
        laser=ag.uniform(0.055, 0.085),
        multi=ag.uniform(0.075, 0.10),
        unit="m",
        within=(0.05, 0.13),
        doc="height of the part above the slot of the paper",
    ),
    corner: ag.Float = ag.uniform(0.012, 0.040, "m", doc="radius of the upright edges"),
    feeder: bool = ag.by("style", inkjet={False: 3, True: 1}, multi={True: 2, False: 1}, otherwise=False),
    keys: int = ag.count(2, 6, doc="number of keys"),
    friction: ag.Float = ag.uniform(1.5, 4.0, "N", doc="friction of a cassette"),
    finish: ag.Material = ag.shades(*_CASES, weights=(3, 2, 2, 3), color=0.03),
    trim: ag.Material = ag.choice(*_TRIMS, doc="lid, panel and fronts"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a printer with closed lid and cassettes."""
    depth = require_size(depth, (0.32 if style == "inkjet" else 0.35, 0.48), f"depth of a {style} printer")
    scans = style != "laser"
    slots = _FOOT + 0.010 + _BAY * cassettes
    flap = 0.0 if style == "inkjet" else 0.088
    out = {"inkjet": 0.052, "laser": 0.0, "multi": 0.105}[style]
    high = slots + flap + out + upper
    case = ag.Region.centered(width, depth, 0.0).with_(z=(_FOOT, high))
    plan = _Plan(style, case, finish, trim, maker)
    body = _body(plan, corner, slots, flap, out)
    wide = 0.318 if style == "inkjet" else 0.232
    for number in range(cassettes):
        low = _FOOT + 0.010 + _BAY * number
        bay = plan.bay(wide, low, low + _BAY - 0.004, depth - 0.040)
        drag = feel.Feel(friction=friction, damping=8.0, effort=60.0)
        slide = ag.Prismatic("cassette_slide", axis=-ag.Y, limits=(0, 0.60 * bay.y.size), feel=drag)
        fitting = Fitting.moving(_cassette(bay, plan), slide, cut=bay.grow(front=0.01).box())
        body = body.install(fitting.suffixed(f"_{number}"))
    if style != "inkjet":
        body = body.install(_flap(plan.bay(0.25, slots + 0.006, slots + flap - 0.006, 0.11), plan))
    body = _controls(body, plan, keys, upper)
    return body.attach(*_lid(plan, feeder=feeder)) if scans else body


def _body(plan: _Plan, corner: ag.Scalar, slots: ag.Scalar, flap: ag.Scalar, out: ag.Scalar) -> ag.Body:
    """Make the housing on its feet, with the slot or the dish in which printed sheets lie."""
    case = plan.case
    solid = ag.extrude(case.plan(radius=corner), case.z.size, bevel=0.003).at(z=case.z.mid)
    sheets = 0.30 if plan.style == "inkjet" else 0.23
    if plan.style == "laser":
        dish = ag.box(sheets, case.y.size - 0.13, 0.09).rotate(ag.X, -0.16)
        solid -= dish.at(0, -0.012, case.z.high + 0.030)
    else:
        low = slots + flap
        solid -= plan.bay(sheets, low + 0.004, low + out, 0.25).grow(front=0.01).box()
    feet = [
        ag.cylinder(0.012, _FOOT + 0.001, bevel=0.001).at(
            x * (case.x.high - 0.05), y * (case.y.high - 0.05), _FOOT / 2 + 0.0005
        )
        for x in (-1, 1)
        for y in (-1, 1)
    ]
    made = ag.weld(
        ag.part(solid, "body", plan.shell, name="body"),
        ag.part(feet, "foot", ag.material("rubber")),
        *_rear(plan),
    )
    if plan.style == "laser":
        return made
    pane = case.with_(z=(case.z.high - 0.0006, case.z.high + 0.0004)).shrink(0.045, bottom=0, top=0)
    return ag.weld(made, ag.detail(pane.box(), "glass", _GLASS))


def _rear(plan: _Plan) -> list[ag.Body]:
    """Make the plate, the socket and the ports at the back, and vents in both sides."""
    case, ink = plan.case, ag.material("black_abs")
    back, low = case.y.high, case.z.low + 0.035
    lines = (plan.maker.upper(), "220-240 V~ 50/60 Hz", "MADE FOR A4")
    slots = details.vent_slots(0.10, 0.030, 9, slot=0.0035)
    sides = [((way * case.x.high, 0.05, case.z.mid), way * ag.X) for way in (-1, 1)]
    socket = ag.box(0.032, 0.003, 0.026, bevel=0.001).at(0.30 * case.x.high, back, low)
    ports = [
        ag.box(0.016, 0.003, 0.014, bevel=0.001).at((0.45 + 0.16 * n) * -case.x.high, back, low)
        for n in (0, 1)
    ]
    return [
        details.rating_plate(0.066, 0.034, lines, at=(-0.1 * case.x.high, back, low + 0.04), facing=ag.Y),
        ag.detail([socket, *ports], "socket", ink),
        *(details.printed(slots, at, facing=facing, material=ink, label="vent") for at, facing in sides),
    ]


def _cassette(bay: ag.Region, plan: _Plan) -> ag.Body:
    """Make a cassette in its bay, with a lip on its front and paper in it."""
    face = bay.shrink(0.0012, front=-0.0025, back=0).with_(y=(bay.y.low - 0.0025, bay.y.low + 0.010))
    room = bay.shrink(left=0.0015, right=0.0015, bottom=0.0015, top=0.010, front=0.0095, back=0.004)
    inner = room.shrink(0.0022, front=0.0, top=0.0)
    lip = ag.Region(
        (-0.055, 0.055), (face.y.low - 0.011, face.y.low + 0.0005), (face.z.high - 0.018, face.z.high - 0.004)
    )
    bar = lip.box(bevel=0.004)
    hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.Z, depth=0.009)
    wide, deep = (0.297, 0.210) if plan.style == "inkjet" else (0.210, 0.297)
    sheets = (
        ag.Region.centered(wide, deep, 0.0)
        .at(y=inner.y.low + deep / 2 + 0.004)
        .with_(z=(inner.z.low - 0.0002, inner.z.low + 0.018))
    )
    return ag.weld(
        ag.part(face.box(bevel=0.002), "cassette", plan.trim, name="cassette"),
        ag.part(furniture.open_box(room, inner), "cassette", _DARK),
        ag.part(bar, "handle", plan.trim, grasp=hold),
        ag.part(sheets.box(), "paper", _PAPER),
    )


def _flap(bay: ag.Region, plan: _Plan) -> Fitting:
    """Make the flap over the slot for single sheets, which falls open to the front."""
    face = bay.shrink(0.0015, front=-0.0015, back=0).with_(y=(bay.y.low - 0.0015, bay.y.low + 0.0045))
    plate = face.box(bevel=0.0015)
    lip = ag.Region(
        (-0.032, 0.032), (face.y.low - 0.010, face.y.low + 0.0004), (face.z.high - 0.013, face.z.high - 0.003)
    )
    bar = lip.box(bevel=0.003)
    hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.Z, depth=0.008)
    made = ag.weld(
        ag.part(plate, "flap", plan.trim, name="flap"),
        ag.part(bar, "handle", plan.trim, name="lip", grasp=hold),
    )
    pivot = (0, face.y.mid, face.z.low + 0.003)
    hinge = ag.Revolute(
        "flap_hinge", axis=ag.X, pivot=pivot, limits=(0, 1.45), feel=feel.PIVOT,
        detents=feel.detents((0.0, 1.45), 0.12), friction=0.03,
    )  # fmt: skip
    return Fitting.moving(made, hinge, cut=bay.grow(front=0.01).box())


def _controls(body: ag.Body, plan: _Plan, keys: int, upper: ag.Scalar) -> ag.Body:
    """Put keys and a display on a panel that tilts, or into the body of a plain printer."""
    front, top = plan.case.y.low, plan.case.z.high
    pitch, level = 0.022, top - 0.40 * upper
    row = controls.places(keys, pitch, middle=0.030 + 0.011 * keys)
    icons = _KEYS[:keys]
    face = plan.trim if plan.style != "laser" else plan.finish
    mark = details.logo(plan.maker, 0.009)
    at = (0.075 - plan.case.x.high, front, level)
    body = ag.weld(body, details.printed(mark, at, material=controls.ink_on(plan.finish)))

    def equipped(host: ag.Body, y: ag.Scalar) -> ag.Body:
        """Add the display and the keys on a face."""
        host = ag.weld(host, details.display("1 20", 0.052, 0.020, at=(-0.012, y, level), color="white"))
        for number, (x, icon) in enumerate(zip(row, icons, strict=True)):
            key = controls.push_button(
                finish=_DARK, plate=face, through=0.0090, width=0.0115, proud=0.0025, deep=0.006,
                travel=0.002, icon=icon, ink=controls.LIGHT_INK,
            )  # fmt: skip
            host = host.install(key.suffixed(f"_{number}"), at=(x, y, level))
        return _working(host, keys) if keys else host

    if plan.style == "laser":
        return equipped(body, front)
    room = ag.Region((-0.050, 0.052 + pitch * keys), (front, front + 0.020), (level - 0.021, level + 0.021))
    board = room.shrink(0.0010, front=-0.0015, back=0.0095, bottom=0.0024)
    tab = ag.Region(
        (-0.038, -0.012), (board.y.low - 0.011, board.y.low + 0.0005), (board.z.low, board.z.low + 0.006)
    ).box(bevel=0.002)
    hold = ag.grasp_on(tab, approach=ag.Y, closing=ag.Z, depth=0.009)
    plain = ag.weld(
        ag.part(board.box(bevel=0.002), "panel", face, name="panel"),
        ag.part(tab, "handle", face, name="tab", grasp=hold),
    )
    panel = equipped(plain, board.y.low)
    tilt = ag.Revolute(
        "panel_tilt", axis=-ag.X, pivot=(0, board.y.low + 0.0022, board.z.high - 0.0022), limits=(0, 0.9),
        feel=feel.Feel(friction=0.25, damping=0.02, armature=1e-4, effort=6.0),
    )  # fmt: skip
    return body.cut(room.grow(front=0.01).box()).attach(panel, tilt)


def _working(host: ag.Body, keys: int) -> ag.Body:
    """Let the first key switch the display, the second one stop, and the third one copy; each beeps."""
    key = [signals.pressed(f"button_slide_{number}") for number in range(keys)]
    figures = ag.material("led_white")
    off = signals.toggle(key[0])
    host = host.output("display", ~off, kind="display", material=figures, color=figures.emission)
    beep = controls.any_pressed(f"button_slide_{number}" for number in range(keys))
    host = host.output("beep", beep, kind="sound")
    if keys < 3:
        return host
    return host.output("copying", signals.timer(key[2], 8.0, unless=key[1] | off), kind="sound")


def _lid(plan: _Plan, *, feeder: bool) -> tuple[ag.Body, ag.Joint]:
    """Make the lid over the glass of the scanner, with a feeder for sheets."""
    case = plan.case
    seam, thick = case.z.high + 0.0014, 0.026
    slab = case.with_(z=(seam, seam + thick)).shrink(0.0005, front=-0.012, back=0.001)
    solid = slab.box(bevel=0.006)
    hold = ag.grasp_on(solid, approach=ag.Y, closing=ag.Z, depth=0.010)
    cover = plan.trim.with_(name=f"{plan.trim.name}_lid", density=330.0)
    pad = case.with_(z=(seam - 0.0006, seam + 0.001)).shrink(0.045, bottom=0, top=0)
    lid = ag.weld(
        ag.part(solid, "lid", cover, name="lid", grasp=hold),
        ag.detail(pad.box(), "pad", ag.material("powder_coat_white")),
    )
    if feeder:
        left = slab.with_(
            x=(slab.x.low + 0.02, slab.x.low + 0.15), z=(slab.z.high - 0.001, slab.z.high + 0.045)
        )
        left = left.shrink(front=0.05, back=0.03)
        tray = left.with_(
            x=(left.x.high - 0.001, slab.x.high - 0.03), z=(slab.z.high + 0.020, slab.z.high + 0.024)
        )
        post = tray.with_(x=(tray.x.high - 0.02, tray.x.high - 0.01), z=(slab.z.high - 0.001, tray.z.high))
        lid = ag.weld(
            lid,
            ag.part(left.box(bevel=0.010), "feeder", cover),
            ag.part([tray.box(bevel=0.001), post.shrink(front=0.03, back=0.03).box()], "feeder", plan.trim),
        )
    pivot = (0, slab.y.high - 0.004, case.z.high + 0.0092)
    hinge = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=pivot, limits=(0, 1.15), damping=0.4,
        friction=1.15 * lid.weight() * (pivot[1] - lid.center_of_mass().y), effort=60.0,
    )  # fmt: skip
    return lid, hinge
