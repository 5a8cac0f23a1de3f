"""The plan of a dishwasher, and its case: the tub as a cavity of boards, with sides, base, top and back."""

import artgen as ag
from artgen import details
from artgen.categories.shared.appliances import DARK, cord_stub, drain_hose, filled, inlet_hose

REACH = 0.005
"""Gap from the rim of the liner to the front of the racks [m]."""

UNDER = 0.020
"""Distance from the treads of the lower rack's rollers up to its wires [m]."""

AXLES = (0.052, 0.016)
"""Heights of the axles of the upper rack and of the tray above their wires [m]."""

FRONT_RIM = 0.105
"""Height of the front of the lower rack above its wires [m]."""

_SHEET = 0.004  # modeled thickness of the sheet of side panels [m]
_FEET = 0.022  # height of the base above the floor [m]
_PLAY = 0.0012  # play of rollers in their rails [m]
_BACK = 0.030  # depth of the recess for hoses at the back [m]
_GREY = ag.colored("polypropylene", "grey")
_ZINC = ag.material("zinc")


class Plan:
    """The regions that the parts of a dishwasher share: its front faces -y, and z = 0 is the floor."""

    def __init__(
        self,
        outside: ag.Region,
        *,
        worktop: bool,
        wall: float,
        thickness: ag.Float,
        hinge_height: ag.Float,
        swing: ag.Float,
        clearance: ag.Float,
        travel: ag.Float,
        upper_level: ag.Float,
    ) -> None:
        front, rear = outside.y
        inner = front + thickness  # inside of the door
        self.outside, self.swing = outside, swing
        self.arm = 0.6 * thickness  # distance from the axis of the door back to the rim of its liner [m]
        self.hinge = (0.0, inner - self.arm, hinge_height)  # a point on the axis of the door [m]
        self.door = outside.shrink(x=0.0015).with_(
            y=(front, inner),  # its lower edge is just below the hinge, so that it turns past the tub
            z=(hinge_height - 0.010, outside.z.high - (0.034 if worktop else 0.004)),
        )
        racks = outside.shrink(x=wall + 0.020).with_(y=(inner + REACH, rear - 0.061))
        self.travel = travel * racks.y.size  # of the racks [m]
        self.over = self.travel - self.arm - REACH  # reach of the extended racks in front of the hinge [m]
        # a door that opens by less than a right angle rises a little to its end; the lower rack keeps its
        # clearance above the door at its farthest reach
        rise = (self.arm + clearance + self.over * ag.cos(swing)) / ag.sin(swing)
        self.treads = hinge_height + rise  # height at which the lower rack rolls [m]
        ceiling = outside.z.high - (0.050 if worktop else 0.022)
        # 6 mm between door and tub are for the gasket
        self.tub = outside.shrink(x=wall).with_(
            y=(inner + 0.006, rear - 0.045), z=(self.treads - 0.047, ceiling)
        )
        self.racks = racks.with_(z=self.tub.z)
        lower = self.treads + UNDER
        upper = lower + upper_level * (ceiling - lower)
        self.floors = (lower, upper, ceiling - 0.068)  # heights of the wires of the racks [m]

    def clear_angle(self, low: ag.Scalar, ahead: float, least: float = 0.0008) -> ag.Scalar:
        """Return the angle of the open door that clears the path of a rack [rad].

        The farthest point that the rack reaches is in front of the hinge and above it; the liner clears this
        point if it leans beyond its direction by the angle that its distance from the hinge's axis, and the
        least gap, subtend at that point.
        """
        across, up = self.over + ahead, low - self.hinge[2]
        far = ag.sqrt(across * across + up * up)
        share = (self.arm + least) / far
        return ag.atan2(across, up) + ag.atan2(share, ag.sqrt(1 - share * share))


def base(plan: Plan, kick: ag.Material, ballast: float) -> ag.Body:
    """Make the base with pump, motor and ballast of a density [kg/m3], its kick plate and feet."""
    front, rear = plan.tub.y.low + 0.034, plan.outside.y.high - _BACK
    black = ag.material("black_abs")
    pan = plan.outside.shrink(x=0.004).with_(y=(front, rear - 0.002), z=(_FEET, plan.tub.z.low - 0.014))
    plate = plan.outside.shrink(x=0.001).with_(
        y=(front - 0.0125, front + 0.001), z=(0.012, plan.door.z.low + 0.016)
    )
    x = plan.outside.x.high - 0.045
    corners = [(side * x, y, 0) for side in (-1, 1) for y in (front + 0.045, rear - 0.05)]
    disc = ag.cylinder(0.019, 0.008, bevel=0.0015).at(z=0.004)
    stem = ag.cylinder(0.007, _FEET).at(z=_FEET / 2 + 0.002)
    slots = details.vent_slots(0.24, 0.012, 14, slot=0.0036)
    vent = details.relief(slots, (0, plate.y.low, 0.045), proud=0.0003, sunk=0.0003)
    screwed = "each foot is screwed into the base"
    return ag.weld(
        ag.part(pan.box(bevel=0.004), "body", filled(black, ballast, "base")),
        ag.part(plate.box(bevel=0.002), "kick_plate", filled(kick, 900.0)),
        ag.detail(vent, "kick_plate", DARK),
        ag.part(ag.array(disc, at=corners), "foot", black, separate=screwed),
        ag.part(ag.array(stem, at=corners), "foot", _ZINC),
    )


def walls(plan: Plan, liner: ag.Material) -> ag.Body:
    """Make floor, ceiling, back and sides of the tub; their front edges frame the opening."""
    tub, rear = plan.tub, plan.outside.y.high
    wide = plan.outside.shrink(x=_SHEET).with_(y=tub.y, z=tub.z).shrink(back=-0.001, z=-0.001)
    side = wide.x.high - tub.x.high
    boards = [
        wide.with_(y=(tub.y.low, rear - _BACK), z=(tub.z.low - 0.016, tub.z.low)),
        wide.with_(y=(tub.y.low, rear - 0.002), z=(tub.z.high, tub.z.high + 0.016)),
        wide.with_(y=(tub.y.high, tub.y.high + 0.012)),
        *wide.across(side, None, side)[::2],
    ]
    edge = tub.grow(x=0.010, top=0.006).shrink(front=0.0002)
    gasket = details.gasket(edge.x.size, edge.z.size, size=0.0062, radius=0.016, section="half_round")
    return ag.weld(
        ag.part([each.box() for each in boards], "tub", filled(liner, 190.0, "tub")),
        ag.detail(gasket.at(edge.anchor(y=-1)), "seal", ag.material("rubber")),
    )


def sides(plan: Plan, finish: ag.Material, *, worktop: bool, felt: bool) -> ag.Body:
    """Make the outer panels: painted ones, or galvanized frames around the insulated tub."""
    case, tub = plan.outside.shrink(top=0.032 if worktop else 0.002), plan.tub
    low = tub.z.low - 0.014
    upper = case.with_(y=(tub.y.low + 0.0006, case.y.high), z=(low, case.z.high))
    lower = case.with_(y=(tub.y.low + 0.030, case.y.high - 0.002), z=(0.026, low + 0.001))
    sheets = [each.box(bevel=0.0012) for each in upper.across(_SHEET, None, _SHEET)[::2]]
    sheets += [each.box() for each in lower.across(_SHEET, None, _SHEET)[::2]]
    body = ag.part(sheets, "body", filled(finish, 2400.0, "sheet"))
    if not felt:
        return body
    field = ag.Region(
        case.x, (tub.y.low + 0.045, case.y.high - 0.065), (tub.z.low + 0.02, case.z.high - 0.03)
    )
    sheet = ag.rectangle(field.y.size, field.z.size, radius=0.012)
    pads = [
        details.relief(sheet, field.anchor(x=side), facing=(side, 0, 0), proud=0.0006, sunk=0.0006)
        for side in (-1, 1)
    ]
    bitumen = ag.colored("fabric", "graphite").with_(name="bitumen_felt")
    return ag.weld(body, ag.detail(pads, "insulation", bitumen))


def cover(plan: Plan, finish: ag.Material, worktop: ag.Material | None) -> ag.Body:
    """Make the deck over the tub, and the worktop on it."""
    top, low = plan.outside.z.high, plan.tub.z.high + 0.016
    case = plan.outside.with_(y=(plan.tub.y.low, plan.outside.y.high))
    stuff = filled(finish, 300.0, "deck")
    if worktop is None:
        return ag.part(case.shrink(x=_SHEET).with_(z=(low - 0.001, top)).box(), "body", stuff)
    deck = case.shrink(x=0.002).with_(z=(low, top - 0.029)).box()
    plate = plan.outside.shrink(front=0.004).with_(z=(top - 0.030, top)).box(bevel=0.005)
    return ag.weld(ag.part(deck, "body", stuff), ag.part(plate, "worktop", filled(worktop, 620.0, "top")))


def rails(plan: Plan, racks: int) -> ag.Body:
    """Make the ledges of the lower rack, and the channels of the upper racks."""
    tub, ledge = plan.tub, plan.treads - _PLAY
    rail = ag.Region((tub.x.high - 0.017, tub.x.high + 0.001), tub.shrink(front=0.004, back=0.006).y, (0, 0))
    ledges = rail.with_(z=(ledge - 0.008, ledge)).box(bevel=0.002)
    grey = ag.colored("polypropylene", "light_grey").with_(name="rail_plastic")
    bodies = [ag.part([ledges, ledges.mirror(ag.X)], "rail", grey)]
    for floor, axle in list(zip(plan.floors[1:], AXLES, strict=True))[: racks - 1]:
        for way in (-1, 1):
            z = floor + axle + way * (0.0115 + _PLAY)
            strip = rail.with_(z=(z - 0.002, z + 0.002)).box(bevel=0.0008)
            bodies.append(ag.part([strip, strip.mirror(ag.X)], "rail", ag.material("stainless")))
    return ag.weld(*bodies)


def interior(plan: Plan, liner: ag.Material) -> ag.Body:
    """Make sump, filter, feed pipe, embossed walls and the nozzle of the ceiling, visual only."""
    tub, middle = plan.tub, plan.racks.y.mid
    low, high = tub.z
    sump = ag.cylinder(0.085, 0.003, bevel=0.001).at(0, middle - 0.075, low + 0.0006)
    mesh = ag.cylinder(0.078, 0.0012).at(0, middle - 0.075, low + 0.0022)
    cup = ag.cylinder(0.034, 0.014, bevel=0.003).at(0, middle - 0.105, low + 0.006)
    bar = ag.box(0.012, 0.056, 0.006, bevel=0.002).at(0, middle - 0.105, low + 0.0145)
    pipe = ag.Region((-0.016, 0.016), (tub.y.high - 0.009, tub.y.high + 0.001), (low, high - 0.06))
    nozzle = ag.cylinder(0.028, 0.008, bevel=0.002).at(0, middle, high - 0.003)
    rib = ag.box(0.006, 0.004, 0.55 * tub.z.size, bevel=0.0019)  # ribs stiffen the sheet
    ribs = [(share * tub.x.high, tub.y.high, tub.z.mid) for share in (-0.68, -0.42, 0.42, 0.68)]
    return ag.weld(
        ag.detail(sump, "filter", ag.material("stainless")),
        ag.detail(mesh, "filter", ag.material("perforated_steel")),
        ag.detail(cup, "filter", _GREY),
        ag.detail(bar, "filter", ag.colored("polypropylene", "blue")),
        ag.detail([pipe.box(), nozzle], "tub", _GREY),
        ag.detail(ag.array(rib, at=ribs), "tub", liner),
    )


def back(plan: Plan, maker: str) -> ag.Body:
    """Make the back panel above the recess, and the connections for water and mains in the recess."""
    case, rear, services = plan.outside.shrink(x=_SHEET), plan.outside.y.high, 0.26
    recess = rear - _BACK
    panel = case.with_(y=(plan.tub.y.high + 0.011, rear - 0.003), z=(services, plan.tub.z.high + 0.002))
    wall = case.with_(y=(recess - 0.004, recess), z=(_FEET + 0.004, services + 0.001))
    side = plan.outside.x.high - 0.10
    lines, at = (maker, "230 V~ 1900 W"), (0, rear - 0.003, 0.55)
    return ag.weld(
        ag.part([panel.box(), wall.box()], "body", filled(_ZINC, 700.0, "sheet")),
        drain_hose().at(-side, recess, 0.08),
        inlet_hose().at(side, recess, 0.08),
        cord_stub(height=0.16, reach=0.026).at(0, recess, 0.16),
        details.rating_plate(0.085, 0.045, lines, at=at, facing=ag.Y, double_insulated=False),
    )
