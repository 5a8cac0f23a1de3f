"""The shell of a toaster: its plan, the ends, the sleeve between them with its slots, and visible details.

All parts are modeled with the slots along y and the bay of the carriages at -y. For controls on a broad side,
the finished shell is rotated by 90 degrees, which moves the wall at -x to the front.
"""

import math
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details
from artgen.categories.shared.appliances import cord_stub, mains_cord
from artgen.categories.shared.fixings import corner_feet, screws
from artgen.nodes.fitting import Fitting

BodyStyle = Literal["box", "rounded", "retro", "steel", "classic"]
"""A plain box; rounded shoulders; bulging sides; a steel sleeve between plastic ends; beveled edges."""

_SHEET = 0.0025  # modeled thickness of sheets; their density compensates for it [m]
_BACK = 0.014  # distance between the chamber and the back end [m]
_UNDER = 0.014  # distance from the floor of the sleeve to the chamber, over the crumb tray [m]
_DOME_STEPS = (0.0, 0.3, 0.65, 1.0)  # shares of a quarter turn over a rounded end
_SEAM = 0.00003  # gap between the parts of a rounded end, so that their meshes share no corner [m]
_SURROUND = 0.0065  # width of the trim around the slots [m]


class Form(NamedTuple):
    """Shape of a body style; lengths in m."""

    dome: float  # radius of the rounded front end; 0 for a flat end
    front: float  # thickness of the front end
    back: float  # thickness of the flat back end
    inset: float  # depth of the sleeve inside the outline of the ends, which shows the joint
    corner: tuple[float, float]  # size of the upper corners: share of the shoulder, and largest size
    border: float  # distance from the sides of the front to the control panel
    under: float  # distance from the underside of the front to the control panel
    over: float  # distance from the control panel to the top of the front
    solidity: float  # real share of the modeled volume of the sleeve: a rounded sleeve is modeled thicker
    is_apart: bool  # whether the ends have another material than the sleeve
    is_flat: bool  # whether the broad sides may have controls


FORMS: dict[BodyStyle, Form] = {
    "box": Form(0.0, 0.008, 0.008, 0.0012, (1.0, 0.0075), 0.012, 0.012, 0.018, 1.0, False, True),
    "rounded": Form(0.009, 0.013, 0.009, 0.0012, (0.7, 0.036), 0.021, 0.012, 0.026, 0.75, False, False),
    "retro": Form(0.013, 0.017, 0.009, 0.0016, (0.0, 0.0), 0.026, 0.018, 0.034, 0.42, False, False),
    "steel": Form(0.0, 0.014, 0.014, 0.003, (0.5, 0.017), 0.012, 0.012, 0.018, 0.85, True, True),
    "classic": Form(0.0, 0.007, 0.007, 0.0022, (0.72, 0.034), 0.016, 0.012, 0.032, 1.0, True, False),
}
"""Shapes of the styles."""


class Plan:
    """Regions and outlines of a toaster.

    Args:
        style: Style of the body.
        body: Space of the body, above its feet.
        area: Width and length of all slots side by side.
        slots: Number of slots.
        bridge: Gap between two slots [m].
        wires: Number of guide wires along a slot, and of prongs of a carriage.
    """

    def __init__(
        self, style: BodyStyle, body: ag.Region, area: ag.Region, slots: int, bridge: ag.Float, wires: int
    ) -> None:
        form = FORMS[style]
        self.style, self.form, self.body, self.bridge, self.wires = style, form, body, bridge, wires
        self.sleeve = body.shrink(form.inset, front=form.front, back=form.back)
        self.floor = self.sleeve.z.low + _SHEET  # height of the inner face of the bottom [m]
        end = self.sleeve.y.high - _BACK
        levels = (self.floor + _UNDER, self.sleeve.z.high - 0.002)  # into the sheet of the top
        self.chamber = area.with_(y=(end - area.y.size, end), z=levels)
        self.slots = self.chamber.columns(slots, gap=bridge)
        self.bay = (self.chamber.y.low + self.sleeve.y.low) / 2  # y of the posts of the carriages [m]
        self._corner = ag.min_(form.corner[0] * (body.x.high - area.x.high), form.corner[1])
        self.outline = self._outline(body, sides=40)  # of the ends, about their middle

    def _outline(self, region: ag.Region, sides: int) -> ag.Profile:
        """Return the outline of an end or a sleeve about its middle; a bulge has the corners of a polygon."""
        wide, _, high = region.size
        match self.style:
            case "box" | "steel":
                return ag.rectangle(wide, high, radius=self._corner)
            case "rounded":
                shoulders = ag.rectangle(wide, high, radius=self._corner)
                return shoulders | ag.rectangle(wide, 0.6 * high, radius=0.0075).at(0.0, -0.2 * high)
            case "retro":
                angles = [math.tau * side / sides for side in range(sides)]
                disc = ag.polygon([(math.cos(angle), math.sin(angle)) for angle in angles])
                bulge = disc.scale(wide / 2, 1.15 * high).at(0.0, -0.04 * high)
                return (ag.rectangle(1.1 * wide, high) & bulge).offset(-0.022).offset(0.022)
            case "classic":
                return _cornered(wide / 2, high / 2, self._corner, steep=1.5, radius=0.004)

    def section(self) -> ag.Profile:
        """Return the section of the sleeve about its middle; few corners inside make few colliders."""
        inside = self.sleeve.shrink(_SHEET)
        x, z = inside.x.high, inside.z.size / 2
        match self.style:
            case "box":
                hollow = ag.rectangle(2 * x, 2 * z)
            case "steel":
                hollow = _cornered(x, z, self._corner - _SHEET, lower=True)
            case "rounded":
                hollow = _cornered(x, z, self._corner - _SHEET)
            case "classic":
                hollow = _cornered(x, z, self._corner, steep=1.5)
            case "retro":
                low, high = 0.93 * x - 0.013, 0.895 * x - 0.013
                right = [(low, -z), (x, -0.06 * z), (high, z)]
                hollow = ag.polygon([*right, *((-each, level) for each, level in reversed(right))])
        return self._outline(self.sleeve, sides=200) - hollow  # a bulge shows no facets


def _cornered(
    x: ag.Scalar,
    z: ag.Scalar,
    size: ag.Scalar,
    *,
    lower: bool = False,
    steep: float = 1.0,
    radius: float = 0.0,
) -> ag.Profile:
    """Make a rectangle with its upper corners cut off, and its lower corners as well if `lower`."""
    right: list[tuple[ag.Scalar, ag.Scalar]] = [(x, z - steep * size), (x - size, z)]
    right = [*((x, -z) for x, z in reversed(right)), *right] if lower else [(x, -z), *right]
    left = [(-each, level) for each, level in reversed(right)]
    return ag.polygon([*right, *left], radius=radius)


def shell(
    plan: Plan,
    sleeve: ag.Material,
    ends: ag.Material,
    trim: ag.Material,
    panel: ag.Region,
    controls: str,
    tray: Fitting,
    way: str,
) -> ag.Body:
    """Make the shell with the opening of the panel in its final pose, and with the crumb tray."""
    body, sunk = plan.body, plan.form.back - 0.003
    at = (0.0, body.y.high - 0.003, body.z.mid)
    # short sides of the outline, as those of a bulging body, allow only a smaller bevel
    cover = details.relief(plan.outline, at, facing=ag.Y, proud=0.003, sunk=sunk, bevel=0.0028)
    back = ag.part(cover, "body", ends)
    tube = plan.sleeve.grow(y=0.001)  # overlap with both ends
    top = (plan.sleeve.z.high + body.z.high) / 2
    solid = ag.extrude(plan.section(), tube.y.size, axis=ag.Y).at(0.0, tube.y.mid, body.z.mid)
    solid = solid - ag.union(*(slot.with_(z=(top - 0.02, top + 0.02)).box() for slot in plan.slots))
    wall = ag.part(solid, "body", sleeve, name="body")
    if controls == "side":
        wall = wall.cut(panel.box().rotate(ag.Z, -math.pi / 2))
    if way == "side":
        wall = wall.install(tray)
    else:
        back = back.install(tray)
    surround = plan.chamber.grow(_SURROUND).plan(radius=0.007)
    for slot in plan.slots:
        surround = surround - slot.shrink(0.0005).plan(radius=0.004)
    bodies = [
        wall,
        ag.part(_front(plan, None if controls == "side" else panel), "body", ends),
        back,
        ag.detail(ag.extrude(surround, 0.0022, bevel=0.0004).at(z=plan.sleeve.z.high), "trim", trim),
    ]
    if plan.style == "retro":  # bright lines along the joints of the ends
        ring = plan.outline.offset(0.0006) - plan.outline.offset(-0.004)
        band = details.relief(ring, facing=ag.Y, proud=0.0017, sunk=0.0017, bevel=0.0008)
        joints = [(0.0, y, body.z.mid) for y in plan.sleeve.y]
        bodies.append(ag.detail(ag.array(band, at=joints), "trim", trim))
    return ag.weld(*bodies)


def _front(plan: Plan, panel: ag.Region | None) -> list[ag.Solid]:
    """Make the flat or rounded front end; a rounded one with a panel is convex parts around its opening."""
    form, (wide, _, high) = plan.form, plan.body.size
    if not form.dome:
        bevel = 0.004 if plan.style == "steel" else 0.0026
        plate = ag.extrude(plan.outline, form.front, axis=ag.Y, bevel=bevel)
        plate = plate.at(0.0, plan.body.y.low + form.front / 2, plan.body.z.mid)
        return [plate if panel is None else plate - panel.box()]
    rings, heights = [plan.outline], [0.0]
    for step in _DOME_STEPS:
        turn = step * math.pi / 2
        inset = 2 * form.dome * (1 - math.cos(turn))
        # scaling keeps the corners for the loft
        rings.append(plan.outline.scale(1 - inset / wide, 1 - inset / high))
        heights.append(form.front - form.dome + form.dome * math.sin(turn))
    front = ag.loft(rings, heights, axis=-ag.Y).at(0.0, plan.sleeve.y.low, plan.body.z.mid)
    if panel is None:
        return [front]
    left, right, below, above = panel.grow(plan.body.y.size / 2).around(panel, lap=-_SEAM / 2)
    # quarters at the sides, because a hull has at most 64 corners
    parts = [below, above, *left.rows(2, gap=_SEAM), *right.rows(2, gap=_SEAM)]
    return [ag.bounding_collider(front & each.box()) for each in parts]


def outside(plan: Plan, lines: tuple[str, ...]) -> ag.Body:
    """Make the feet, a dark base, hooks for the cord, and the vents, screws and rating plate on the back."""
    body, foot = plan.body, plan.body.z.low
    dark = ag.material("black_abs").with_(name="vent", base_color=(0.006, 0.006, 0.006), texture="")
    vents = details.vent_slots(body.x.size / 2, 0.09 * body.z.size, 12, slot=0.0024)
    at = (0.0, body.y.high, body.z.at(0.64))
    corners = [(x, body.y.high, body.z.at(share)) for x in body.shrink(0.032).x for share in (0.26, 0.76)]
    steel = ag.material("stainless").with_(name="screw")
    base = ag.box(body.x.size - 0.030, body.y.size - 0.018, 0.006, bevel=0.0012).at(z=foot)
    neck = ag.box(0.030, 0.006, foot - 0.004, bevel=0.0008).at(z=foot / 2)
    lip = ag.box(0.034, 0.016, 0.0022, bevel=0.0008).at(z=0.0032)
    reach = 0.22 * body.y.size
    hooks = ag.array(neck | lip, at=[(0.0, -reach, 0.0), (0.0, reach, 0.0)])
    return ag.weld(
        corner_feet(body.x.size, body.y.size, inset=0.028, height=plan.sleeve.z.low),
        ag.detail(base, "base", ag.material("black_abs").with_(name="base_black")),
        ag.detail(hooks, "cord_wrap", ag.material("black_abs")),
        details.rating_plate(0.056, 0.020, lines, at=(0.0, body.y.high, body.z.at(0.36)), facing=ag.Y),
        details.printed(vents, at, material=dark, facing=ag.Y, label="vent", proud=0.0001),
        *screws(corners, facing="+y", radius=0.0032, finish=steel, head="pan"),
    )


def cord(plan: Plan, controls: str, cord_side: str, tray: str) -> ag.Body:
    """Make the cord, which leaves at the back and lies behind the body."""
    height, length = plan.body.z.low + 0.032, 0.125
    # a rotation by 90 degrees moves the wall at x to the back, and the bay to the right
    if controls == "side":
        turned = mains_cord(height=height, length=length, side=-1).rotate(ag.Z, -math.pi / 2)
        return turned.at(plan.sleeve.x.high, plan.bay, height)
    side = 1 if cord_side == "right" else -1
    # a plug on the floor would block a tray at the back
    blocked = tray == "back"
    made = cord_stub(height=height) if blocked else mains_cord(height=height, length=length, side=-side)
    return made.at(side * (plan.body.x.high - 0.018), plan.body.y.high, height)
