"""The plan of an oven, and its case: sheet, the enameled cavity, the part below the door, the range's top."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.shared import cooktops
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.controls import ink_on
from artgen.categories.shared.fixings import feet, screws

Build = Literal["built_in", "range"]
"""Built into a kitchen cabinet, or a freestanding range with burners on top."""

BurnerKind = Literal["gas", "radiant", "induction"]
"""Gas flames, radiant heaters under glass, or induction coils under glass."""

LAMP = ag.material("bulb").with_(name="oven_lamp")
"""Lens of the lamp in the cavity."""

SEAL = 0.006
"""Gap between the inside of the door and the cavity, for the gasket [m]."""

LAP = 0.0005
"""Overlap of boards, so that they share no corners [m]."""

UNDER = 0.0003
"""Depth of the boards under a surface with soft edges; the boards have the mass and collide [m]."""

FOOT = 0.022
"""Height of the feet of a range [m]."""

SLAB = 0.024
"""Thickness of floor and ceiling of the cavity with their wool [m]."""

REACH = 0.010
"""Distance from the mouth of the cavity to the front of a rack [m]."""

_TOP = 0.034  # thickness of the top of a range [m]
_SHEET = 0.003  # modeled thickness of a sheet [m]
_FRAME = 0.022  # width of the enameled frame around the mouth [m]
_BLACK = ag.material("powder_coat_black")
_ZINC = ag.material("zinc")


class Plan:
    """The regions that the parts of an oven share: its front faces -y, and z = 0 is the floor."""

    def __init__(
        self,
        build: Build,
        outside: ag.Region,
        *,
        wall: ag.Float,
        panel: ag.Float,
        hinge_height: ag.Float,
        thickness: ag.Float,
    ) -> None:
        inner, rear = outside.y.low + thickness, outside.y.high
        mouth, ranged = inner + SEAL, build == "range"
        top = outside.z.high - (_TOP if ranged else 0)
        self.build, self.outside = build, outside
        self.arm = 0.74 * thickness  # distance from the axis of the door back to its inside [m]
        self.hinge = (0.0, inner - self.arm, hinge_height)  # a point on the axis of the door [m]
        fronts = outside.shrink(x=0.0015)
        panels = fronts if ranged else outside
        self.panel = panels.with_(y=(outside.y.low, mouth), z=(top - panel, top))
        # the gap of 4 mm below the panel is the outlet of cooling air
        self.door = fronts.with_(y=(outside.y.low, inner), z=(hinge_height - 0.008, self.panel.z.low - 0.004))
        # the part below the door of a range begins 18 mm above the feet; its top clears the turning door
        below = (FOOT + 0.018 if ranged else 0, hinge_height - 0.0165)
        self.below = panels.with_(y=(outside.y.low, mouth), z=below)
        # a niche is narrower than the front
        self.shell = outside.shrink(x=0 if ranged else 0.018).with_(
            y=(mouth + 0.0006, rear), z=(FOOT if ranged else 0, top - 0.0008)
        )
        # fan and wool are behind the cavity
        self.cavity = outside.shrink(x=wall).with_(
            y=(mouth, rear - 0.058), z=(hinge_height + 0.032, self.door.z.high - 0.046)
        )
        # racks lie on rails 5 mm off the walls
        self.racks = self.cavity.shrink(x=0.0065, front=REACH, back=0.012)
        self.top = outside.shrink(front=-0.004, back=0.0006).with_(z=(top + 0.0004, outside.z.high))


def walls(plan: Plan, sides: ag.Material, enamel: ag.Material) -> ag.Body:
    """Make the sheets around the case, and the boards of the cavity, whose front edges frame its mouth."""
    shell, cavity = plan.shell, plan.cavity
    left, between, right = shell.across(_SHEET, None, _SHEET)
    between = between.grow(x=LAP)
    (low, high), rear = shell.z, shell.y.high
    bottom = between.shrink(back=LAP).with_(z=(low + 0.0004, low + 0.0024))
    deck = between.shrink(back=0.0012).with_(z=(high - 0.0020, high - 0.0004))
    back = between.shrink(z=0.0008).with_(y=(rear - 0.0030, rear - 0.0008))

    block = cavity.grow(x=_FRAME, back=0.014, bottom=SLAB, top=_FRAME)
    ceiling, middle, floor = block.stack(_FRAME, None, SLAB)
    middle = middle.shrink(x=LAP, back=LAP).grow(z=LAP)
    beside = middle.across(_FRAME - LAP, None, _FRAME - LAP)[::2]
    end = cavity.grow(x=LAP, z=LAP).with_(y=(cavity.y.high, middle.y.high))

    # posts beside the frame and a board above it, behind the panel; those of a range carry its top
    top = high + (0.0016 if plan.build == "range" else -0.0012)
    behind = between.with_(y=(cavity.y.low + 0.0008, block.y.high - 2 * LAP), z=(block.z.low + LAP, top))
    wide = between.x.high - block.x.high + 2 * LAP
    posts = behind.across(wide, None, wide)[::2]
    lintel = block.with_(y=(behind.y.low, behind.y.high - LAP), z=(block.z.high - LAP, top - LAP))

    wool = 390.0 if plan.build == "built_in" else 315.0  # density of walls with their wool [kg/m3]
    boards = [each.box() for each in (floor, ceiling, end, *beside)]
    return ag.weld(
        ag.part([each.box(bevel=0.0010) for each in (left, right)], "body", filled(sides, 2000.0, "sheet")),
        ag.part(bottom.box(), "body", filled(_ZINC, 1800.0, "sheet")),
        ag.detail([deck.box(), back.box()], "body", _ZINC),
        ag.part(boards, "cavity", filled(enamel, wool, "wall")),
        ag.part([each.box() for each in (*posts, lintel)], "body", filled(_BLACK, wool, "frame")),
    )


def air_strip(plan: Plan, finish: ag.Material) -> ag.Body:
    """Make the strip below the door of a built-in oven, with slots for the air."""
    strip = plan.below.shrink(front=0.006).deep(0.016, None)[0]
    front, top = strip.y.low, strip.z.high
    behind = ag.Region(plan.shell.x, (strip.y.high - LAP, plan.below.y.high + 0.004), (0.0004, top - 0.002))
    slots = details.vent_slots(0.86 * plan.outside.x.size, 0.012, 26, slot=0.0090)
    vent = details.relief(slots, (0, front, top / 2), proud=0.0003, sunk=0.0003)
    return ag.weld(
        ag.part(strip.box(bevel=0.0020), "trim", filled(finish, 500.0, "trim")),
        ag.part(behind.box(), "body", filled(_BLACK, 240.0, "base")),
        ag.detail(vent, "vent", DARK),
    )


def base(plan: Plan, finish: ag.Material, *, drawer: bool) -> ag.Body:
    """Make the base of a range: feet, kick plate, and a panel below the door if there is no drawer."""
    front, rear = plan.below.y.high, plan.outside.y.high
    kick = plan.outside.shrink(x=0.004).with_(y=(front + 0.020, front + 0.030), z=(0.010, FOOT + 0.015))
    x = plan.outside.x.high - 0.05
    corners = [(side * x, y) for side in (-1, 1) for y in (front + 0.07, rear - 0.06)]
    body = ag.weld(
        ag.part(kick.box(), "kick_plate", filled(_BLACK, 900.0)),
        feet(corners, radius=0.018, height=FOOT + 0.0004, style="pad", finish=ag.material("black_abs")),
    )
    if drawer:
        return body
    face, behind = plan.below.deep(0.016, None)
    behind = behind.shrink(x=0.001, front=-LAP, back=-0.004, z=0.002)  # between the sides
    return ag.weld(
        body,
        ag.part(face.box(bevel=0.0022), "kick_plate", filled(finish, 300.0, "front")),
        ag.part(behind.box(), "body", filled(_BLACK, 120.0, "base")),
    )


def interior(plan: Plan, enamel: ag.Material, *, convection: bool) -> ag.Body:
    """Make gasket, lamp, embossed back wall and the cover of the fan, visual only."""
    room, inside = plan.cavity, plan.cavity.x.high
    back, tall, level = room.y.high, room.z.size, room.z.mid
    edge = room.grow(x=0.011, z=0.011).shrink(front=0.0002)
    gasket = details.gasket(edge.x.size, edge.z.size, size=0.0056, radius=0.016, section="half_round")
    rubber = ag.material("rubber").with_(name="glass_fibre_seal", base_color=(0.16, 0.155, 0.15))
    field = ag.rectangle(1.72 * inside, 0.80 * tall, radius=0.02)
    rib = details.relief(
        field - field.offset(-0.006), (0, back, level), proud=0.0024, sunk=0.0004, bevel=0.0018
    )
    lamp = (-0.62 * inside, back, room.z.high - 0.25 * tall)
    lens = ag.cylinder(0.026, 0.012, axis=ag.Y, bevel=0.003).at(y=-0.004).at(lamp)
    bodies = [
        ag.detail(gasket.at(edge.anchor(y=-1)), "seal", rubber),
        ag.detail(rib, "cavity", enamel),
        ag.detail(lens, "light", LAMP),
        ag.detail(
            details.relief(ag.ring(0.031, 0.024), lamp, proud=0.004), "light", ag.material("stainless")
        ),
    ]
    if convection:
        cover = details.relief(ag.circle(0.105), (0, back, level), proud=0.010, bevel=0.006)
        petals = details.perforation(ag.circle(0.062), 0.0155, 0.0052)
        holes = details.relief(petals, (0, back - 0.010, level), proud=0.0002)
        slots = details.vent_slots(0.055, 0.026, 3, slot=0.0046, direction="horizontal")
        slots_at = details.relief(slots, (0, back, level), proud=0.0002, sunk=0.0002)
        corners = [(x, z) for x in (-1, 1) for z in (-1, 1)]
        around = ag.array(slots_at, at=[(x * 0.155, 0, z * 0.30 * tall) for x, z in corners])
        heads = [(x * 0.078, back - 0.010, level + z * 0.040) for x, z in corners]
        steel = ag.material("stainless")
        bodies += [
            ag.detail(cover, "fan_cover", enamel),
            ag.detail([holes, around], "fan_cover", DARK),
            *screws(heads, facing="-y", radius=0.0035, finish=steel, head="pan"),
        ]
    return ag.weld(*bodies)


def back_fittings(plan: Plan, maker: str, watts: int) -> ag.Body:
    """Make vents, cover of the terminals, screws, rating plate and the cord on the back."""
    x, plane, tall = plan.shell.x.high, plan.shell.y.high - 0.0008, plan.shell.z
    grille = details.vent_slots(0.30, 0.045, 5, slot=0.0045, direction="horizontal")
    slots = details.vent_slots(0.16, 0.060, 12, slot=0.0045)
    vents = [
        details.relief(each, at, facing=ag.Y, proud=0.0002)
        for each, at in ((grille, (0, plane, tall.high - 0.07)), (slots, (0.12, plane, tall.at(0.22))))
    ]
    lid = ag.rectangle(0.30, 0.30, radius=0.02)
    cover = details.relief(lid, (0, plane, tall.at(0.58)), facing=ag.Y, proud=0.008, bevel=0.005)
    heights = (tall.low + 0.03, tall.mid, tall.high - 0.02)
    heads = [(side * (x - 0.014), plane, z) for side in (-1, 1) for z in heights]
    lines = (f"{maker.upper()} F{watts // 10}", f"230 V~ 50/60 Hz {watts} W")
    plate_at = (-0.12, plane, tall.at(0.22))
    outlet = tall.at(0.10) + 0.03
    return ag.weld(
        ag.detail(vents, "vent", DARK),
        ag.detail(cover, "body", _ZINC),
        *screws(heads, facing="+y", radius=0.0036, finish=_ZINC, head="pan"),
        details.rating_plate(0.080, 0.042, lines, at=plate_at, facing=ag.Y, double_insulated=False),
        cord_stub(height=outlet, reach=0.040, radius=0.0045).at(0.6 * x, plane, outlet),
    )


@dataclass(frozen=True)
class TopPlan(cooktops.Plan):
    """A plan whose burners fill the top except for its border: the dials are on the panel."""

    @cached_property
    def field(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar, ag.Scalar]:
        """Positions of the left, right, front and back of the field of the burners [m]."""
        x, y = self.width / 2 - 0.020, self.depth / 2
        return (-x, x, 0.020 - y, y - 0.046)  # at the back is the steam outlet of the oven


def layout(plan: Plan, burners: int, *, mirrored: bool) -> TopPlan:
    """Return the places of the burners on the top of a range."""
    x, y, _ = plan.top.size
    return TopPlan(burners, 2, 0, "front", x, y, 0.02, 0.07, mirrored)


def top(
    plan: Plan,
    layout: TopPlan,
    kind: BurnerKind,
    finish: ag.Material,
    *,
    brass: bool,
    maker: str,
    edge: float,
) -> ag.Body:
    """Make the top of a range with its burners or zones, and with grates that lift off."""
    glass = kind != "gas"
    slab, height = plan.top.at(y=-plan.top.y.mid), plan.top.z.high
    half = (slab.z.size - (0.005 if glass else 0)) / 2
    sheet = details.relief(
        slab.plan(radius=0.010), (0, 0, slab.z.low + half), facing=ag.Z, proud=half, sunk=half, bevel=0.0028
    )
    # boards under the surface carry the burners; the front edge is hollow
    lip, tray = slab.shrink(UNDER).deep(0.12, None)
    lip = lip.shrink(x=LAP, back=-LAP, bottom=LAP)
    slots = details.vent_slots(0.62 * slab.x.size, 0.014, 34, slot=0.0060)
    vent = details.relief(slots, (0, slab.y.high - 0.024, height), facing=ag.Z, proud=0.0003)
    body = ag.weld(
        ag.detail(sheet, "top", finish),
        ag.part(tray.box(), "top", filled(finish, 560.0, "top")),
        ag.part(lip.box(), "top", filled(finish, edge, "edge")),
        ag.detail(vent, "vent", DARK),
        _glass(layout, kind, slab, maker) if glass else _gas(layout, slab, finish, brass=brass),
    )
    body = body.at(y=plan.top.y.mid)
    if not glass:
        iron, rubber = ag.material("cast_iron"), ag.material("rubber")
        made = cooktops.grates(layout.columns, plate=height, style="continuous", iron=iron, feet=rubber)
        for grate, lift in made:
            body = body.attach(grate.at(y=plan.top.y.mid), lift)
    return body


def _glass(layout: TopPlan, kind: BurnerKind, slab: ag.Region, maker: str) -> ag.Body:
    """Make the glass with its zones and the maker's name."""
    black, height = ag.material("black_glass"), slab.z.high
    pane = ag.extrude(slab.shrink(0.005).plan(radius=0.008), 0.006, bevel=0.0014)
    ink = ink_on(black)
    bodies = [
        ag.part(pane.align((0, 0, height), z=1), "top", black),
        cooktops.printed_zones(layout.places, kind, height, ink, share=0.92),
    ]
    if maker:
        at = (0, slab.y.low + 0.022, height)
        bodies.append(details.printed(details.logo(maker, 0.008), at, material=ink, facing=ag.Z))
    return ag.weld(*bodies)


def _gas(layout: TopPlan, slab: ag.Region, finish: ag.Material, *, brass: bool) -> ag.Body:
    """Make the raised border of a sheet top, and its burners."""
    border = slab.shrink(0.002).plan(radius=0.009) - slab.shrink(0.010).plan(radius=0.007)
    rim = details.relief(border, (0, 0, slab.z.high), facing=ag.Z, proud=0.0018, bevel=0.0014)
    cap = ag.material("enamel_black").with_(name="cap_enamel", specular_roughness=0.5)
    metal = cooktops.BRASS if brass else cooktops.ALUMINIUM
    heads = [
        cooktops.gas_burner(each.size, spreader=metal, cap=cap).at(each.x, each.y, slab.z.high)
        for each in layout.places
    ]
    return ag.weld(ag.detail(rim, "top", finish), *heads)
