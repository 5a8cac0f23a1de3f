"""The plan of a microwave oven, its case with the cavity, and the turntable."""

import math
from collections.abc import Sequence
from functools import partial

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.appliances import DARK, filled, mains_cord
from artgen.categories.shared.fixings import feet, screws

LAMP = ag.material("bulb").with_(name="oven_lamp")
"""Lens of the lamp in the cavity."""

LAP = 0.0005
"""Overlap of boards, so that no two faces coincide [m]."""

_SEAL = 0.0028  # gap between the inside of the door and the cavity's frame; chokes need 2-3 mm [m]
_GAP = 0.0024  # gap between door and control panel [m]
_EDGE = 0.0012  # distance from the outer edges of door and panel to the sides of the case [m]
_SHEET = 0.0025  # modeled thickness of the sheet of the case [m]
_STILE = 0.036  # distance from the cavity to the control panel: the frame with the slots of the latches [m]
_LEFT = 0.020  # thickness of the left wall, case and cavity together [m]
_UNDER = 0.030  # distance from the underside of the case to the floor of the cavity, above the motor [m]
_OVER = 0.021  # distance from the ceiling of the cavity to the top [m]
_BEHIND = 0.020  # distance from the back of the cavity to that of the case [m]

HOOK = (0.0050, 0.0065, 0.0120)
"""Width, height and reach of a hook of the door behind the cavity's frame [m]."""

BARB = (0.0042, 0.0050)
"""Height and thickness of the barb of a hook [m]."""

_BESIDE = 0.0160  # distance from the cavity to the middle of the hooks [m]
_WALL = 0.0035  # thickness of the cavity's right wall [m]
_FRAME = 0.0030  # thickness of the frame of the cavity in front of the latches [m]
_LATCHES = 0.046 + 0.045  # depth of the space for the latches, and of the boards of the keys behind it [m]
_WORKS = 0.18  # depth of the electronics in all but the smallest ovens [m]
_BACK_SHEET = 0.0008  # distance from the face of the back to the rear edges of the case [m]
_MICA = ag.colored("fabric", "sand").with_(name="mica", texture="", tile=None, specular_roughness=0.35)
# torque of a hand at the rim; geared motors of 3 W give 0.5 before their clutch slips, and synchronous
# motors turn at 5-6 rpm
_MOTOR = feel.Feel(damping=0.002, effort=1.5, velocity=0.7)


class Plan:
    """Regions of a microwave oven.

    Args:
        outside: Space of the oven without a handle, from the front of the door to the back.
        thickness: Thickness of the door [m].
        panel: Width of the control panel [m].
        foot: Height of the feet [m].
    """

    def __init__(
        self, outside: ag.Region, *, thickness: ag.Scalar, panel: ag.Scalar, foot: ag.Scalar
    ) -> None:
        self.case = outside.shrink(front=thickness + _SEAL, bottom=foot)
        leaf = outside.shrink(x=_EDGE, bottom=foot + _EDGE, top=_EDGE)
        split = outside.x.high - panel
        self.door = leaf.with_(x=(leaf.x.low, split - _GAP), y=(leaf.y.low, leaf.y.low + thickness))
        self.panel = leaf.with_(x=(split, leaf.x.high), y=(leaf.y.low, self.case.y.low))
        self.cavity = self.case.shrink(
            left=_LEFT, right=panel + _STILE, front=0, back=_BEHIND, bottom=_UNDER, top=_OVER
        )
        # the axis of the door is near its edge, so that its rear corner clears the frame by 1 mm
        self.pivot = (self.door.x.low + 0.0062, self.door.y.high - 0.0170, outside.z.high / 2)
        x = self.cavity.x.high + _BESIDE
        self.arm = x - self.pivot[0]  # distance from the hinge to the hooks [m]
        levels = (self.cavity.z.at(0.16), self.cavity.z.at(0.80))
        y = (self.door.y.high - 0.004, self.cavity.y.low + HOOK[2])
        self.hooks = [ag.Region.centered(HOOK[0], 0, HOOK[1]).at(x, 0, z).with_(y=y) for z in levels]


def gaps_between(region: ag.Region, gaps: Sequence[ag.Span]) -> list[ag.Region]:
    """Return the regions below, between and above gaps in the height of a region."""
    edges = [region.z.low, *(edge for gap in gaps for edge in gap), region.z.high]
    return [region.with_(z=span) for span in zip(edges[::2], edges[1::2], strict=True)]


def case(
    plan: Plan, finish: ag.Material, inside: ag.Material, *, vents: str, maker: str, watts: int
) -> ag.Body:
    """Make the case with its cavity; `vents` is the side of the air inlet."""
    bodies = [*_sheets(plan, finish), *_walls(plan, inside), *_interior(plan, inside)]
    return ag.weld(*bodies, *_vents(plan, -1 if vents == "left" else 1), *_back(plan, maker, watts))


def _walls(plan: Plan, inside: ag.Material) -> list[ag.Body]:
    """Make floor, ceiling, sides and back of the cavity, and the frame with the slots of the latches."""
    room = plan.cavity
    block = plan.case.shrink(x=LAP + _SHEET / 2, front=0, back=0.0012, bottom=0.0004, top=_SHEET / 2)
    middle = block.shrink(back=LAP).with_(z=room.grow(z=LAP).z)
    left, across, right = middle.across(room.x.low - block.x.low, room.x.size, None)
    boards = [left, across.grow(x=LAP).with_(y=(room.y.high, middle.y.high)), right.across(_WALL, None)[0]]
    # the transformer and the fan are at the back; in front of them are the latches and the boards of the keys
    beside = right.shrink(left=_WALL - LAP)
    heavy_from = ag.max_(room.y.low + _LATCHES, block.y.high - _WORKS)
    works = beside.shrink(back=LAP).with_(y=(heavy_from, beside.y.high - LAP))
    end = plan.panel.x.low - 0.0045  # the frame ends behind the panel
    light = beside.with_(x=(end, beside.x.high), y=(room.y.low, heavy_from + LAP))
    frame = beside.with_(x=(beside.x.low, end + LAP)).deep(_FRAME, None)[0]
    slots = [hook.grow(left=0.0025, right=0.0017, bottom=0.0016, top=BARB[0] + 0.0016) for hook in plan.hooks]
    seen = []  # the visible slots are narrower than the gaps of the colliding frame
    strip = frame.grow(x=LAP, y=-LAP)
    for slot in slots:
        z = (slot.z.low - LAP, slot.z.high + LAP)
        seen += [
            strip.with_(x=(strip.x.low, slot.x.low), z=z),
            strip.with_(x=(slot.x.high, strip.x.high), z=z),
        ]
    # densities with the motor of the turntable, the stirrer, the wires, and the transformer and magnetron
    made: list[tuple[list[ag.Region], float, str]] = [
        ([block.with_(z=(block.z.low, room.z.low))], 300, "floor"),
        ([block.with_(z=(room.z.high, block.z.high))], 210, "ceiling"),
        ([*boards, *gaps_between(frame, [slot.z for slot in slots])], 265, "wall"),
        ([works], 740, "works"),
        ([light], 120, "keys"),
    ]
    return [
        ag.detail([each.box() for each in seen], "cavity", inside),
        *(
            ag.part([each.box() for each in group], "cavity", filled(inside, density, name))
            for group, density, name in made
        ),
    ]


def _sheets(plan: Plan, finish: ag.Material) -> list[ag.Body]:
    """Make the wrapper over top and sides, the bottom, the back and the feet."""
    whole = plan.case.grow(front=0.0016)
    left, _, right = whole.shrink(top=0.0006).across(_SHEET, None, _SHEET)
    top = whole.shrink(x=0.0006).stack(_SHEET, None)[0]
    bottom = whole.shrink(x=0.001, front=0.006, back=0.0006).stack(None, _SHEET)[1]
    inset = whole.shrink(x=0.001, back=_BACK_SHEET, bottom=0.0008, top=0.0012)
    back = inset.deep(None, _SHEET - _BACK_SHEET)[1]
    stand = plan.case.shrink(x=0.040, y=0.035)
    return [
        ag.part(
            [each.box(bevel=0.001) for each in (left, right, top)], "body", filled(finish, 2000, "sheet")
        ),
        # around the boards of the cavity
        ag.detail([bottom.box(), back.box()], "body", ag.material("zinc")),
        feet([(x, y) for x in stand.x for y in stand.y], radius=0.011, height=plan.case.z.low),
    ]


def _interior(plan: Plan, inside: ag.Material) -> list[ag.Body]:
    """Make the visible parts of the cavity: the cover of the wave guide, the lamp, the air holes."""
    room = plan.cavity
    right = partial(details.relief, facing=-ag.X)
    cover = ag.rectangle(0.30 * room.y.size, 0.45 * room.z.size, radius=0.006)
    lamp, at = ag.rectangle(0.036, 0.022, radius=0.003), (room.x.high, room.y.at(0.22), room.z.at(0.70))
    holes = details.perforation(ag.rectangle(0.050, 0.034), 0.0074, 0.0025, margin=0.001)
    outlet = details.vent_slots(0.050, 0.034, 5, slot=0.0040)
    on_left = (room.x.low, room.y.at(0.72), room.z.at(0.76))
    # a pressed edge stiffens the back wall
    rim, mouth = room.shrink(0.015).front(radius=0.02), room.grow(0.002).front(radius=0.006)
    rib = details.relief(rim - rim.offset(-0.005), (0, room.y.high, 0), proud=0.0016, bevel=0.0008)
    seam = details.relief(mouth - mouth.offset(-0.002), (0, room.y.low, 0), proud=0.0002, sunk=0.0006)
    return [
        ag.detail(
            right(cover, (room.x.high, room.y.at(0.56), room.z.at(0.55)), proud=0.0012, sunk=0.0006),
            "wave_guide_cover",
            _MICA,
        ),
        ag.detail(right(lamp, at, proud=0.0001, sunk=0.0006), "light", LAMP),
        ag.detail(right(holes, at, proud=0.0002), "vent", DARK),
        ag.detail(details.relief(outlet, on_left, facing=ag.X, proud=0.0002), "vent", DARK),
        ag.detail(rib, "cavity", inside),
        ag.detail(seam, "cavity", ag.material("zinc")),
    ]


def _vents(plan: Plan, side: int) -> list[ag.Body]:
    """Make the air inlet and outlet slots of the fan, in both sides."""
    x, y, z = plan.case.x.high, plan.case.y.high - 0.085, plan.case.z
    inlet = details.vent_slots(0.11, 0.052, 13, slot=0.0030)
    outlet = details.vent_slots(0.085, 0.030, 10, slot=0.0030)
    on_side = details.relief(inlet, (side * x, y, z.at(0.66)), facing=(side, 0, 0), proud=0.0002)
    other = details.relief(outlet, (-side * x, y - 0.03, z.at(0.24)), facing=(-side, 0, 0), proud=0.0002)
    return [ag.detail([on_side, other], "vent", DARK)]


def _back(plan: Plan, maker: str, watts: int) -> list[ag.Body]:
    """Make vents, screws, rating plate, spacers and the cord."""
    half, y, z = plan.case.x.high, plan.case.y.high - _BACK_SHEET, plan.case.z
    slots = details.vent_slots(0.085, 0.070, 9, slot=0.0036, direction="horizontal")
    grille = details.perforation(ag.circle(0.043), 0.0092, 0.0031)
    fan = (half - 0.085, y, z.at(0.62))  # the fan is behind the control panel
    back = partial(details.relief, facing=ag.Y, proud=0.0002)
    vents = [back(slots, (-0.42 * half, y, z.at(0.62))), back(grille, fan).at(y=0.0012)]
    ring = ag.cylinder(0.047, 0.002, axis=ag.Y, bevel=0.0008).at(fan).at(y=-0.0002)
    heads = [
        (side * (half - 0.012), y, each)
        for side in (-1, 1)
        for each in (z.low + 0.016, z.mid, z.high - 0.014)
    ]
    heads += [(side * 0.3 * half, y, z.high - 0.012) for side in (-1, 1)]
    lines = (f"{maker.upper()} M{watts // 10}", f"230 V~ {watts} W 2450 MHz")
    label = details.rating_plate(
        0.070, 0.040, lines, at=(-0.35 * half, y, z.at(0.24)), facing=ag.Y, double_insulated=False
    )
    outlet = z.low + 0.05
    spacer = ag.box(0.016, 0.018, 0.030, bevel=0.004)
    zinc = ag.material("zinc")
    return [
        ag.detail(ring, "body", zinc),
        ag.detail(vents, "vent", DARK),
        *screws(heads, facing="+y", radius=0.0032, finish=zinc, head="pan"),
        label,
        mains_cord(height=outlet, length=0.15, side=-1).at(fan[0] + 0.03, y, outlet),
        ag.detail(
            [spacer.at(share * half, y + 0.0089, z.high - 0.030) for share in (-0.62, 0.05)],
            "body",
            ag.material("black_abs"),
        ),
    ]


_PLAY = 0.0004  # gap between floor, rollers and plate [m]
_ROLLER, _WHEEL = 0.0075, 0.0085  # radius and width of a roller [m]
_GLASS, _RIM = 0.0052, 0.011  # thickness of the plate, and height of its rim above its underside [m]
_TRACK = 0.66  # radius of the ring, as a share of that of the plate
_HUB, _SHAFT = 0.0125, 0.0042  # radii of the coupler and of the motor's shaft [m]


def turntable(radius: ag.Scalar, friction: ag.Scalar) -> ag.Body:
    """Make the plate on its roller ring about the shaft of the motor; `friction` is at the plate [N m]."""
    track = _TRACK * radius
    groove = ag.tube(track + 0.012, track - 0.012, 0.0004).at(z=0.0001)
    pin = ag.cylinder(_SHAFT, 0.001).at(z=0.0003)
    spin = ag.Revolute("plate_spin", axis=ag.Z, friction=friction, feel=_MOTOR, driven="a motor")
    # the wheels roll under the plate, and turn the ring at half speed; armature: inertia of the wheels
    roll = ag.Revolute("ring_spin", axis=ag.Z, damping=0.0005, armature=0.0001, follows=0.5 * spin)
    shaft = ag.weld(
        ag.detail(groove, "cavity", ag.colored("enamel", "light_grey")),
        ag.detail(pin, "cavity", ag.material("stainless")),
    )
    return shaft.attach(_plate(radius), spin).attach(_ring(track), roll)


def _thirds(solid: ag.Solid, start: float = 0.0) -> list[ag.Solid]:
    return [solid.rotate(ag.Z, start + turn * math.tau / 3) for turn in range(3)]


def _plate(radius: ag.Scalar) -> ag.Body:
    """Make the glass plate with the coupler under it."""
    low = 2 * _ROLLER + 2 * _PLAY
    top = low + _GLASS
    glass = ag.material("glass").with_(name="plate_glass", opacity=0.30)
    disc = ag.cylinder(radius, _GLASS, bevel=0.002).at(z=low + _GLASS / 2)
    rim = ag.polygon([
        (radius - 0.016, top - 0.0008), (radius - 0.0005, top - 0.0014), (radius, low + _RIM - 0.001),
        (radius - 0.0015, low + _RIM), (radius - 0.0045, low + _RIM - 0.0015),
    ])  # fmt: skip
    rings = [ag.torus(share * radius, 0.0011).at(z=top - 0.0003) for share in (0.40, 0.78)]
    plastic = ag.colored("polypropylene", "light_grey").with_(name="coupler_plastic")
    hub = ag.cylinder(_HUB, low - 2 * _PLAY - 0.0016, bevel=0.0015).at(z=(low + 0.0016) / 2)
    lobe = ag.box(0.030, 0.0075, 0.0062, bevel=0.0015).at(0.0135, 0, low - _PLAY - 0.0029)
    return ag.weld(
        ag.part(disc, "plate", glass),
        ag.part(hub, "coupler", plastic, separate="the plate lies on the coupler"),
        ag.detail(_thirds(lobe), "coupler", plastic),  # through the space inside the ring
        ag.detail([ag.revolve(rim), *rings], "plate", glass),
    )


def _ring(track: ag.Scalar) -> ag.Body:
    """Make the ring of rollers."""
    white = ag.colored("polypropylene", "ivory").with_(name="roller_plastic")
    wheel = ag.cylinder(_ROLLER, _WHEEL, axis=ag.X, bevel=0.001).at(track)
    # spokes in a triangle carry the wheels; the round ring above them is visual only
    spoke = ag.box(0.004, math.sqrt(3) * track - 0.012, 0.0038, bevel=0.001).at(track / 2)
    solids = [*_thirds(wheel, math.pi / 2), *_thirds(spoke, math.pi / 6)]
    hoop = ag.tube(track + 0.0062, track - 0.0062, 0.0042, bevel=0.0008)
    return ag.weld(
        ag.part(solids, "roller_ring", white, separate="its wheels turn on pins in the ring"),
        ag.detail(hoop, "roller_ring", white),
    ).at(z=_PLAY + _ROLLER)
