"""The shell of a toaster: two ends, the sleeve between them with its slots, and their trim."""

import math
from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen.categories.shared.fixings import screws
from artgen.categories.toaster.plan import Plan

_STEPS = (0.0, 0.3, 0.65, 1.0)  # shares of a quarter turn over a rounded end
_SEAM = 0.00003  # gap between the parts of a rounded end, so that their meshes share no corner [m]
_SURROUND = 0.0065  # width of the trim around the slots [m]


@dataclass(frozen=True)
class ShellLooks:
    """Materials of the shell."""

    sleeve: ag.Material  # material of the sleeve
    ends: ag.Material  # material of both ends
    trim: ag.Material  # material of the trim around the slots
    piping: ag.Material | None  # material of bright lines at the joints of ends and sleeve; None for none


@dataclass(frozen=True)
class Cuts:
    """Cutters of the shell."""

    # the opening of the control panel in the front end; None for a panel on a broad side
    front: ag.Solid | None = None
    side: tuple[ag.Solid, ...] = ()  # openings in the sleeve
    back: tuple[ag.Solid, ...] = ()  # openings in the back end


def shell(plan: Plan, looks: ShellLooks, cuts: Cuts) -> ag.Body:
    """Make the shell, on feet of the plan's height, with its slots cut."""
    middle = 0.5 * (plan.height + plan.foot)
    front = _front(plan).at(0.0, 0.0, middle)
    fronts = [front] if cuts.front is None else _pierced(plan, front, cuts.front)
    half = plan.length / 2
    # short sides of the outline, as those of a bulging body, allow only a smaller bevel
    back = details.relief(
        plan.outline, (0.0, half, middle), facing=ag.Y, proud=0.003, sunk=plan.back_cap - 0.003, bevel=0.0028
    ).at(0.0, -0.003, 0.0)
    for cut in cuts.back:
        back = back - cut
    bodies = [
        ag.part(_sleeve(plan, cuts).at(0.0, 0.0, middle), "body", looks.sleeve, name="body"),
        *(ag.part(each, "body", looks.ends) for each in fronts),
        ag.part(back, "body", looks.ends),
        ag.detail(_surround(plan), "trim", looks.trim),
    ]
    if looks.piping is not None:
        bodies.append(ag.detail(_piping(plan).at(0.0, 0.0, middle), "trim", looks.piping))
    return ag.weld(*bodies)


def _front(plan: Plan) -> ag.Solid:
    """Make the front end about z = 0: a flat or a rounded plate."""
    face = -plan.length / 2
    if not plan.dome:
        bevel = {"steel": 0.004}.get(plan.style, 0.0026)
        plate = ag.extrude(plan.outline, plan.cap, axis=ag.Y, bevel=bevel)
        return plate.at(0.0, face + plan.cap / 2, 0.0)
    straight = plan.cap - plan.dome
    turns = [0.5 * math.pi * step for step in _STEPS]
    rings: list[ag.Profile] = [plan.outline]
    heights = [0.0]
    for turn in turns:
        inset = plan.dome * (1.0 - math.cos(turn))
        rings.append(_shrunk(plan, inset))
        heights.append(straight + plan.dome * math.sin(turn))
    return ag.loft(rings, heights, axis=-ag.Y).at(0.0, face + plan.cap, 0.0)


def _pierced(plan: Plan, front: ag.Solid, hole: ag.Solid) -> list[ag.Solid]:
    """Cut the opening of the panel through the front end; a rounded end remains as convex parts around it."""
    if not plan.dome:
        return [front - hole]
    low, high = hole.anchor(x=-1, z=-1), hole.anchor(x=1, z=1)
    reach = 0.5 * plan.length
    across, quarter = ag.box(high.x - low.x - _SEAM, 1.0, reach), ag.box(reach, 1.0, reach - _SEAM)
    middle, level = 0.5 * (low.x + high.x), 0.5 * (low.z + high.z)
    parts = [across.at(middle, 0.0, high.z + reach / 2), across.at(middle, 0.0, low.z - reach / 2)]
    for end in (-1, 1):  # quarters, because a hull has at most 64 corners
        z = level + end * reach / 2
        parts += [quarter.at(low.x - reach / 2, 0.0, z), quarter.at(high.x + reach / 2, 0.0, z)]
    return [ag.bounding_collider(front & each) for each in parts]


def _shrunk(plan: Plan, inset: float) -> ag.Profile:
    """Return the outline, smaller by an inset on all sides; scaling keeps its corners for the loft."""
    high = plan.height - plan.foot
    return plan.outline.scale(1.0 - 2.0 * inset / plan.width, 1.0 - 2.0 * inset / high)


def _sleeve(plan: Plan, cuts: Cuts) -> ag.Solid:
    """Make the sleeve about z = 0, a tube of sheet with the openings of the slots."""
    long = plan.length - plan.cap - plan.back_cap + 0.002  # overlap of 1 mm with both ends
    along = 0.5 * (plan.cap - plan.back_cap)
    sleeve = ag.extrude(plan.section() - plan.hollow(), long, axis=ag.Y).at(0.0, along, 0.0)
    begin, end = plan.chamber
    hole = ag.box(plan.slot_width, end - begin, 0.04).at(
        0.0, 0.5 * (begin + end), 0.5 * (plan.top - plan.foot)
    )
    sleeve = sleeve - ag.array(hole, at=[(x, 0.0, 0.0) for x in plan.middles])
    middle = 0.5 * (plan.height + plan.foot)
    for cut in cuts.side:
        sleeve = sleeve - cut.at(0.0, 0.0, -middle)
    return sleeve


def _surround(plan: Plan) -> ag.Solid:
    """Make the trim on the top, a thin sheet with the slots in it."""
    begin, end = plan.chamber
    long = end - begin
    sheet = ag.rectangle(plan.span + 2 * _SURROUND, long + 2 * _SURROUND, radius=0.007)
    for x in plan.middles:
        sheet = sheet - ag.rectangle(plan.slot_width - 0.001, long - 0.001, radius=0.004).at(x, 0.0)
    solid = ag.extrude(sheet, 0.0022, axis=ag.Z, bevel=0.0004)
    return solid.at(0.0, 0.5 * (begin + end), plan.top)


def _piping(plan: Plan) -> ag.Solid:
    """Make the bright lines along the joints of the ends, about z = 0."""
    outer = plan.outline
    ring = outer.offset(0.0006) - outer.offset(-0.004)
    band = details.relief(ring, facing=ag.Y, proud=0.0017, sunk=0.0017, bevel=0.0008)
    half = plan.length / 2
    return ag.array(band, at=[(0.0, plan.cap - half, 0.0), (0.0, half - plan.back_cap, 0.0)])


def back_print(plan: Plan, lines: tuple[str, ...]) -> ag.Body:
    """Make the visible parts of the back: vents, screws and the rating plate with its lines."""
    back, high = plan.length / 2, plan.height - plan.foot
    dark = ag.material("black_abs").with_(name="vent", base_color=(0.006, 0.006, 0.006), texture="")
    vents = details.vent_slots(0.5 * plan.width, 0.09 * high, 12, slot=0.0024)
    steel = ag.material("stainless").with_(name="screw")
    corners = [
        (x * (0.5 * plan.width - 0.032), back, plan.foot + share * high)
        for x in (-1, 1)
        for share in (0.26, 0.76)
    ]
    plate = details.rating_plate(0.056, 0.020, lines, at=(0.0, back, plan.foot + 0.36 * high), facing=ag.Y)
    at = (0.0, back, plan.foot + 0.64 * high)
    return ag.weld(
        plate,
        details.printed(vents, at, material=dark, facing=ag.Y, label="vent", proud=0.0001),
        *screws(corners, facing="+y", radius=0.0032, finish=steel, head="pan"),
    )


def underside(plan: Plan) -> ag.Body:
    """Make the visible parts of the bottom: a dark base with a shadow line over it, hooks for the cord."""
    black = ag.material("black_abs").with_(name="base_black")
    dark = ag.box(plan.width - 0.030, plan.length - 0.018, 0.006, bevel=0.0012)
    neck = ag.box(0.030, 0.006, plan.foot - 0.004, bevel=0.0008).at(0.0, 0.0, plan.foot / 2)
    lip = ag.box(0.034, 0.016, 0.0022, bevel=0.0008).at(0.0, 0.0, 0.0032)
    reach = 0.22 * plan.length
    hooks = ag.array(neck | lip, at=[(0.0, -reach, 0.0), (0.0, reach, 0.0)])
    return ag.weld(
        ag.detail(dark.at(0.0, 0.0, plan.foot), "base", black),
        ag.detail(hooks, "cord_wrap", ag.material("black_abs")),
    )
