"""Cookers whose lid springs open at a button: with sloping keys and a bail, or upright with a lock on top."""

import math

import artgen as ag
from artgen import details, feel
from artgen.categories.rice_cooker.inside import (
    FEET,
    FLOOR,
    HAND,
    Look,
    collar,
    heater,
    inner_pot,
    lifts_out,
    well,
)
from artgen.categories.rice_cooker.keys import FOUR, SIX, with_keys
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import corner_feet
from artgen.nodes.fitting import FIT, Fitting

_SIDE = 0.015  # thickness of the sides beside the room for fingers [m]
_UNDER = 0.0012  # gap between the case and its lid [m]
_AXLE = 0.0100  # height of the hinge above the case [m]
_PRESS = 0.005  # travel of the button that opens the lid [m]
_OPEN = 1.60  # angle of an open lid [rad]
_LOCK = math.pi / 2  # turn of the lock on a lid [rad]
_STEEL = ag.material("stainless").with_(name="inner_lid", texture="", specular_roughness=0.3)
_RUBBER = ag.material("silicone").with_(name="lid_gasket", base_color=(0.45, 0.45, 0.44))
_BAIL = feel.Feel(friction=0.35, damping=0.03, effort=20.0)


class Plan:
    """Measures of a cooker with a hinged lid, about the middle of its pot [m]."""

    def __init__(
        self, width: ag.Scalar, height: ag.Scalar, slope: ag.Scalar, look: Look, *, upright: bool
    ) -> None:
        self.look, self.upright = look, upright
        self.high = height
        self.half = width / 2
        self.radius = self.half - HAND - _SIDE
        self.cover = 0.064 if upright else 0.054  # height of the lid
        self.seam = height - self.cover
        self.rim = self.seam - 0.0006
        self.front = -(self.radius + HAND + 0.020)  # front edge at the seam
        self.rear = self.radius + HAND + 0.032
        self.foot = self.front - slope  # front edge at the table
        self.corner = 0.080 if upright else 0.052
        self.front_ends = (FEET + 0.012, self.seam)  # heights between which the front leans
        self.lean = ag.atan2(slope, self.seam - FEET - 0.012)

    def panel(self, up: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return the point on the front at a share of its height."""
        low, top = self.front_ends
        return (0.0, self.foot + (self.front - self.foot) * up, low + (top - low) * up)


def hinged(plan: Plan) -> ag.Body:
    """Make the cooker, closed."""
    look, radius, rim = plan.look, plan.radius, plan.rim
    body = _case(plan)
    body = with_keys(
        body, look, FOUR if plan.upright else SIX, at=plan.panel(0.60), lean=plan.lean,
        size=(0.122, 0.100) if plan.upright else (0.136, 0.068), text="12:30",
        color="white" if plan.upright else "amber", dial=plan.upright,
    )  # fmt: skip
    lid, free = _lid(plan)
    lid = lid if plan.upright else _bail(lid, plan)
    axle = (0, plan.rear - 0.013, plan.seam + _AXLE)
    hold = 1.35 * lid.weight() * plan.half
    hinge = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=axle, limits=(0, _OPEN), friction=hold, damping=0.2, armature=1e-3,
        effort=25.0, needs=free.until(0.06).beyond(0.0012),
    )  # fmt: skip
    body = body.attach(lid, hinge)
    pot = inner_pot(radius, rim - FLOOR - 0.0006).at(z=FLOOR + 0.0006)
    body = body.attach(pot, lifts_out(rim - FLOOR + 0.05, (hinge > _OPEN - 0.04).beyond(0.0002)))
    return body.at(y=-(plan.foot + plan.rear) / 2)


def _case(plan: Plan) -> ag.Body:
    """Make the case with its well, its hinge and its feet."""
    look, wide = plan.look, 2 * plan.half
    deep = plan.rear - plan.foot
    sole = ag.extrude(ag.rectangle(wide - 0.012, deep - 0.012, radius=plan.corner), 0.002)
    low = ag.extrude(ag.rectangle(wide, deep, radius=plan.corner), 0.004)
    top = ag.extrude(ag.rectangle(wide, plan.rear - plan.front, radius=plan.corner), 0.006)
    case = ag.hull(
        sole.at(0, (plan.rear + plan.foot) / 2, FEET + 0.001),
        low.at(0, (plan.rear + plan.foot) / 2, FEET + 0.010),
        top.at(0, (plan.rear + plan.front) / 2, plan.seam - 0.003),
    )
    case = ag.simplified_collider(case, 0.001) - well(plan.radius, plan.rim)
    case -= _catch(plan)
    y, z = plan.rear - 0.013, plan.seam + _AXLE
    ears = [
        ag.Region((x - 0.008, x + 0.008), (y - 0.0095, y + 0.0095), (plan.seam - 0.004, z)).box()
        | ag.cylinder(0.0095, 0.016, axis=ag.X, bevel=0.001).at(x, y, z)
        for x in (-0.062, 0.062)
    ]
    band = ag.rectangle(wide + 0.0008, plan.rear - plan.front + 0.0008, radius=plan.corner)
    band -= ag.rectangle(wide - 0.006, plan.rear - plan.front - 0.006, radius=plan.corner - 0.003)
    ring = ag.extrude(band, 0.0045, bevel=0.0008).at(0, (plan.rear + plan.front) / 2, plan.seam - 0.0022)
    lines = (f"{look.maker.upper()} 900 W", "220-240 V~ 50/60 Hz")
    return ag.weld(
        ag.part(case, "body", look.hollow(340.0 if plan.upright else 285.0), name="body"),
        ag.part(ears, "hinge", look.finish),
        ag.detail([ring, collar(plan.radius).at(z=plan.seam)], "trim", look.trim),
        heater(plan.radius),
        corner_feet(wide - 0.02, deep - 0.04, inset=0.045, height=FEET).at(0, (plan.rear + plan.foot) / 2, 0),
        cord_stub(height=0.030).at(0.045, plan.rear, 0.030),
        details.rating_plate(0.056, 0.022, lines, at=(-0.015, plan.rear, 0.035), facing=ag.Y),
    )


def _catch(plan: Plan) -> ag.Solid:
    """Make the cutter of the slot for the latch, with a ledge over its barb."""
    slot = ag.Region(
        (-0.012, 0.012), (plan.front + 0.0070, plan.front + 0.0160), (plan.seam - 0.0110, plan.seam + 0.01)
    )
    below = slot.with_(
        y=(plan.front + 0.0032, plan.front + 0.0080), z=(plan.seam - 0.0110, plan.seam - 0.0050)
    )
    return (slot.box() | below.box()).paint(DARK)


def _lid(plan: Plan) -> tuple[ag.Body, ag.Condition]:
    """Make the lid with its inner plate and the cap of its vent, and return what frees its latch."""
    look = plan.look
    wide, low = 2 * plan.half, plan.seam + _UNDER
    front, back = plan.front, plan.rear - 0.026
    deep, y = back - front, (back + front) / 2
    share = 0.90 if plan.upright else 0.84
    edge = ag.extrude(ag.rectangle(wide, deep, radius=plan.corner), 0.012 if plan.upright else 0.008)
    top = ag.extrude(
        ag.rectangle(share * wide, share * deep, radius=share * plan.corner), 0.010, bevel=0.0045
    )
    middle = ag.extrude(ag.rectangle(0.965 * wide, 0.965 * deep, radius=0.965 * plan.corner), 0.010)
    shell = ag.hull(
        edge.at(0, y, low + (0.006 if plan.upright else 0.004)),
        middle.at(0, y, low + 0.66 * (plan.high - low)),
        top.at(0, y, plan.high - 0.005),
    )
    shell = ag.simplified_collider(shell, 0.001)
    sheet = ag.rectangle(0.80 * share * wide, 0.80 * share * deep, radius=0.7 * share * plan.corner)
    cover = details.printed(sheet, (0, y, plan.high), material=look.top, facing=ag.Z, label="trim")
    axle, z = plan.rear - 0.013, plan.seam + _AXLE
    barrel = ag.cylinder(0.0085, 0.104, axis=ag.X, bevel=0.001).at(0, axle, z)
    tongue = ag.Region((-0.052, 0.052), (back - 0.006, axle), (z - 0.0055, z + 0.0055)).box()
    plate = ag.cylinder(plan.radius + 0.006, 0.0012, bevel=0.0004).at(z=low - 0.0002)
    seal = ag.tube(plan.radius + 0.003, plan.radius - 0.004, 0.0011).at(z=low - 0.0004)
    lid = ag.weld(
        ag.part(shell, "lid", filled(look.finish, 250.0, "lid"), name="lid"),
        ag.part([barrel, tongue], "hinge", look.finish),
        ag.detail(plate, "lid", _STEEL),
        ag.detail(seal, "gasket", _RUBBER),
        cover,
        details.printed(
            details.logo(look.maker, 0.0065),
            (0, front + 0.072, plan.high + 0.0002),
            material=controls.ink_on(look.top),
            facing=ag.Z,
        ),
    )
    lid = lid.install(_vent(plan), at=(0, back - 0.058, plan.high))
    lid, driver, travel = (_lock if plan.upright else _button)(lid, plan)
    hook = ag.Region(
        (-0.010, 0.010), (front + 0.0075, front + 0.0100), (plan.seam - 0.0090, low + 0.010)
    ).box()
    barb = ag.Region(
        (-0.010, 0.010), (front + 0.0040, front + 0.0080), (plan.seam - 0.0090, plan.seam - 0.0056)
    ).box()
    slide = ag.Prismatic(
        "latch_slide",
        axis=ag.Y,
        follows=(_PRESS / travel) * driver,
        damping=0.5,
        friction=0.02,
        armature=0.004,
    )
    hollow = ag.Region((-0.012, 0.012), (front + 0.0066, front + 0.0160), (low - 0.01, low + 0.0115)).box()
    latch = ag.part([hook, barb], "latch", look.grip, name="latch")
    return lid.cut(hollow).attach(latch, slide), driver > 0.85 * travel


def _button(lid: ag.Body, plan: Plan) -> tuple[ag.Body, ag.Joint, float]:
    """Add the button that draws the latch."""
    look = plan.look
    cap = controls.button_cap(
        finish=look.grip, shape="bar", width=0.056, height=0.020, proud=0.0072, deep=0.0060,
        icon=details.lettering(("OPEN",), 0.0042), ink=controls.ink_on(look.grip), name="open",
    )  # fmt: skip
    press = controls.button_press("open_slide", travel=_PRESS, preload=2.0, force=6.0, effort=20.0)
    button = Fitting.moving(cap, press, cut=controls.button_hole(0.056, 0.020, through=0.014))
    return (
        lid.install(button.rotate(ag.X, -math.pi / 2), at=(0, plan.front + 0.044, plan.high)),
        press,
        _PRESS,
    )


def _vent(plan: Plan) -> Fitting:
    """Make the cap of the vent in its frame, which lifts off for washing."""
    outline = ag.rectangle(0.060, 0.036, radius=0.010)
    cap = ag.extrude(outline, 0.0114, bevel=0.003).at(z=0.0063)
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.X, depth=0.0095)
    holes = details.vent_slots(0.034, 0.012, 6, slot=0.0025)
    film = details.printed(holes, (0, 0, 0.012), material=ag.material("black_abs"), facing=ag.Z)
    lift = ag.Prismatic("vent_lift", axis=ag.Z, limits=(0, 0.026), friction=0.8, damping=1.0, effort=20.0)
    vent = ag.weld(ag.part(cap, "vent", casting(plan.look.grip, 0.45), grasp=hold, name="vent"), film)
    ring = ag.rectangle(0.068, 0.044, radius=0.013) - ag.rectangle(0.061, 0.037, radius=0.0105)
    frame = ag.detail(ag.extrude(ring, 0.0040, bevel=0.001).at(z=0.0014), "trim", plan.look.trim)
    return Fitting.moving(vent, lift, fixed=frame)


def _lock(lid: ag.Body, plan: Plan) -> tuple[ag.Body, ag.Joint, float]:
    """Add the handle in the middle of a lid, which draws the latch by a quarter of a turn."""
    look, z = plan.look, plan.high
    disc = ag.cylinder(0.034, 0.006, bevel=0.002).at(z=z + FIT.running + 0.003)
    bar = ag.box(0.064, 0.020, 0.020, bevel=0.006).at(z=z + 0.0160)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, depth=0.014)
    mark = details.printed(
        details.pointer(0.018, 0.028, 0.002),
        (0, 0, z + 0.026),
        material=controls.ink_on(look.trim),
        facing=ag.Z,
    )
    handle = ag.weld(
        ag.part(bar, "handle", casting(look.trim, 0.4), name="lock", grasp=hold),
        ag.part(disc, "handle", casting(look.grip, 0.6)),
        mark.rotate(ag.Z, -math.pi / 2),
    )
    turn = ag.Revolute(
        "lock_turn", axis=ag.Z, limits=(0, _LOCK), detents=feel.detents((0.0, _LOCK), 0.35),
        friction=0.08, damping=0.03, armature=4e-4, effort=4.0,
    )  # fmt: skip
    signs = [
        details.printed(
            details.icon(name, 0.008), (x, y, z + 0.0002), material=controls.ink_on(look.top), facing=ag.Z
        )
        for name, x, y in (("lock", 0.046, 0.0), ("unlock", 0.0, 0.046))
    ]
    return ag.weld(lid, *signs).attach(handle, turn), turn, _LOCK


def _bail(lid: ag.Body, plan: Plan) -> ag.Body:
    """Add the handle that lies around the front of the lid and swings up over it."""
    look = plan.look
    y, z, x = -0.004, plan.seam + 0.014, plan.half + 0.0052
    reach = y - plan.front + 0.016
    cut, far = 0.020, y - reach
    half = [(x, y, z), (x, far + cut, z), (x - cut, far, z)]
    line = [*half, *((-a, b, c) for a, b, c in reversed(half))]
    hoop = ag.sweep(ag.rectangle(0.007, 0.016, radius=0.0025), ag.polyline(line))
    eye = ag.cylinder(0.011, 0.0068, axis=ag.X, bevel=0.001)
    eyes = [eye.at(side * x, y, z) for side in (-1, 1)]
    boss = ag.cylinder(0.007, 0.004, axis=ag.X)
    hold = ag.grasp_on(hoop, approach=ag.Y, closing=ag.Z, at=(0, y - reach, z), depth=0.006)
    bail = ag.part([hoop, *eyes], "handle", casting(look.grip, 0.8), name="bail", grasp=hold)
    swing = ag.Revolute(
        "bail_swing", axis=-ag.X, pivot=(0, y, z), limits=(0, math.pi / 2), feel=_BAIL,
    )  # fmt: skip
    caps = [boss.at(side * (plan.half + 0.0095), y, z) for side in (-1, 1)]
    return lid.attach(ag.weld(bail, ag.detail(caps, "handle", look.trim)), swing)
