"""An office swivel chair: five-star base on casters, gas lift, swivel, tilting back, armrests that adjust.

Links: `base`, `caster_0..4`, `wheel_0..4`, `gas_lift`, `seat`, `lever`, `backrest`, `arm_right`, `arm_left`;
`foot_ring` of a stool. Sizes follow EN 1335-1: seat 400-510 mm high, radius of the base below 365 mm.
"""

from math import copysign, cos, pi, sin
from typing import Literal

from numpy import interp

import artgen as ag
from artgen import X, Y, Z, feel

Style = Literal["task", "executive", "stool"]

NYLON, CHROME, STEEL, ALU = map(ag.material, ("black_abs", "chrome", "powder_coat_black", "aluminium"))
TUBE = CHROME.with_(name="chrome_tube", density=2500.0)  # a tube, drawn as a bar
LEATHER = ag.material("black_leather").with_(density=400.0)  # with its padding
COGNAC = ag.material("leather").with_(density=400.0)
MESH = ag.material("mesh").with_(opacity=0.75)
FABRICS = [ag.colored("fabric", name) for name in ("anthracite", "navy", "teal", "slate", "forest")]
LEAN = feel.Feel(damping=3.0, effort=200.0)
SAG = (-0.05, -0.012, 0, -0.012, -0.05)  # depth of the back across its width [m]
LEGS = [2 * pi * leg / 5 - pi / 2 for leg in range(5)]


def caster_of(r: ag.Float, top: ag.Float) -> ag.Body:
    """Make a twin-wheel caster below the origin, its wheels behind its stem."""
    axle = ag.vector(0, 0.6 * r, r)
    core = ag.hull(ag.cylinder(0.55 * r, 0.009, axis=X).at(axle), ag.box(0.009, 0.02, 0.008).at(z=2 * r))
    hood = ag.extrude(ag.bow(r + 0.0035, 0.003, start=0.25, sweep=2.8), 0.052, axis=X).at(axle)
    stem = ag.cylinder(0.0095, top - 2 * r, bevel=0.001).at(z=top / 2 + r)
    sides = [ag.cylinder(r, 0.019, axis=X, bevel=0.004).at(axle + (x, 0, 0)) for x in (-0.0155, 0.0155)]
    wheel = ag.union(*sides, ag.cylinder(0.003, 0.048, axis=X).at(axle))
    body = ag.part((core | hood | stem) - ag.bore(0.0035, 0.02, axis=X).at(axle), "caster", NYLON)
    roll = ag.Revolute("wheel_roll", axis=X, pivot=axle, feel=feel.CASTER, driven="the floor")
    return body.attach(ag.part(wheel, "wheel", ag.material("rubber")), roll)


def base_of(radius: ag.Float, low: ag.Float, top: ag.Float, finish: ag.Material) -> ag.Body:
    """Make the five legs, their undersides at `low`, the hub and the column."""
    hub = low + 0.050
    foot = ag.cylinder(0.015, 0.020, bevel=0.006).at(radius, 0, low + 0.010)
    leg = ag.hull(ag.cylinder(0.024, 0.040, bevel=0.006).at(0.035, 0, hub - 0.022), foot)
    core = ag.cylinder(0.036, hub - low, bevel=0.006).at(z=(hub + low) / 2)
    star = ag.union(core, *(leg.rotate(Z, angle) for angle in LEGS)) - ag.bore(0.0150, 0.5).at(z=low)
    column = ag.simplified_collider(ag.tube(0.0248, 0.0150, top - low)).at(z=(top + low) / 2)
    return ag.weld(ag.part(star, "base", finish), ag.part(column, "column", STEEL))


def ring_of(z: float) -> ag.Body:
    """Make the ring on which the feet rest, which is clamped on the column."""
    spoke = ag.cylinder_between((0.03, 0, z), (0.20, 0, z), 0.006)
    spokes = [spoke.rotate(Z, pi / 4 + pi / 2 * side) for side in range(4)]
    ring = ag.union(ag.torus(0.20, 0.0105), ag.tube(0.036, 0.0256, 0.05)).at(z=z)
    held = ag.grasp_on(spokes[0], approach=-Z, closing=(-1, 1, 0))
    return ag.part(ag.union(ring, *spokes), "foot_ring", TUBE, grasp=held)


def cushion_of(style: Style, width: ag.Float, depth: ag.Float, top: ag.Float) -> ag.Solid:
    """Make the cushion with its upper side at `top`."""
    if style == "stool":
        r = width / 2 - 0.06
        crown = ag.ellipsoid(r - 0.03, r - 0.03, 0.02).at(z=top - 0.020)
        return ag.hull(ag.torus(r - 0.026, 0.026).at(z=top - 0.036), crown)
    if style == "executive":  # three padded rolls, the front one falls off
        third = (depth - 0.03) / 3
        roll = ag.box(width - 0.03, third + 0.012, 0.068, bevel=0.028).align((0, 0, top), z=1)
        front = roll.rotate(X, 0.16, about=(0, 0, top - 0.03)).at(y=0.004 - third, z=-0.012)
        return ag.union(roll.at(y=third), roll, front)
    corners = [
        ag.torus(r, 0.022).at(sx * (width / 2 - r - 0.022), sy * (depth / 2 - r - 0.022), top - drop)
        for sx in (-1, 1)
        for sy, r, drop in ((-1, 0.09, 0.044), (1, 0.06, 0.032))
    ]
    return ag.hull(*corners, ag.ellipsoid(width / 2 - 0.09, depth / 2 - 0.08, 0.02).at(0, 0.02, top - 0.020))


def seat_of(
    style: Style, width: ag.Float, depth: ag.Float, mech: ag.Float, top: ag.Float, fabric: ag.Material
) -> ag.Body:
    """Make cushion, pan and mechanism, with the lever of the lift, and the sleeves of the armrests."""
    case = ag.box(0.15, 0.24, 0.044, bevel=0.005).align((0, 0, mech), z=-1)
    body = ag.part(case - ag.bore(0.0145, 0.0201).at(z=mech + 0.01), "mechanism", STEEL)
    pan = ag.circle(width / 2 - 0.08)
    if style != "stool":
        pan = ag.rectangle(width - 0.09, depth - 0.09, radius=0.05)
    plate = ag.extrude(pan, 0.034, bevel=0.006).align((0, 0, mech + 0.040), z=-1)
    soft = ag.part(cushion_of(style, width, depth, top), "cushion", fabric)
    seat = ag.weld(soft, ag.part(plate, "seat", NYLON), body)
    if style != "stool":
        x = width / 2 + 0.020
        bar = ag.Region((0.06, x + 0.014), (-0.005, 0.055), (mech + 0.022, mech + 0.040)).box(bevel=0.005)
        post = ag.Region((x - 0.014, x + 0.014), (-0.005, 0.055), (mech + 0.022, mech + 0.215))
        sleeve = (bar | post.box(bevel=0.006)) - post.shrink(0.0065, y=0.0115, bottom=0.023, top=-0.1).box()
        neck = ag.box(0.084, depth / 2 - 0.10, 0.014, bevel=0.004).align((0, 0.08, mech + 0.022), y=-1)
        ear = ag.box(0.012, 0.05, 0.052, bevel=0.004).at(0.036, depth / 2, mech + 0.040)
        right = ag.union(ear, sleeve)
        seat = ag.weld(seat, ag.part(ag.union(neck, right, right.mirror(X)), "sleeve", NYLON))
    rod = ag.cylinder_between((0.030, 0, -0.004), (width / 2 - 0.035, 0, -0.004), 0.004)
    paddle = ag.box(0.06, 0.026, 0.010, bevel=0.004).at(width / 2 - 0.02, 0, -0.004)
    lever = ag.part(rod | paddle, "lever", NYLON, grasp=ag.grasp_on(paddle, approach=-X, closing=Z))
    spring = ag.Spring(preload=0.3, force=0.6)
    press = ag.Revolute("lift_lever", axis=-Y, limits=(0, 0.14), spring=spring, damping=0.005)
    return seat.attach(lever, press, at=(0.05, -0.04, mech + 0.016))


def arm_of(width: ag.Float, mech: ag.Float, look: ag.Material) -> ag.Body:
    """Make the armrest at the right: its blade in the sleeve, and its pad."""
    x = width / 2 + 0.020
    blade = ag.Region((x - 0.007, x + 0.007), (0.007, 0.043), (mech + 0.055, mech + 0.235)).box(bevel=0.001)
    pad = ag.hull(*(ag.torus(0.022, 0.012).at(x, y, mech + 0.244) for y in (-0.09, 0.13)))
    held = ag.grasp_on(pad, approach=-X, closing=Z, depth=0.018)
    return ag.weld(ag.part(pad, "armrest", look, name="arm", grasp=held), ag.part(blade, "armrest", STEEL))


def back_of(
    style: Style, width: ag.Float, back: ag.Float, hinge: ag.Vector, seat: ag.Float, fabric: ag.Material
) -> ag.Body:
    """Make the backrest, upright, with the spine that turns about the hinge."""
    y, bottom = hinge.y + 0.045, seat + 0.05

    def at(side: float, up: float) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return a point of the surface: from -1 to 1 sideways, from 0 to 1 upward."""
        away = interp(up, (-0.1, 0.28, 0.65, 1.15), (0.0064, -0.018, 0.010, 0.067))
        away += interp(side, (-1, -0.5, 0, 0.5, 1), SAG)
        return (width / 2 - 0.02) * side, y + away, bottom + up * back

    bend = (0, y + 0.004, bottom + 0.3 * back)
    line = [hinge, hinge + (0, 0.05, 0), (0, y + 0.030, bottom), bend, (0, y + 0.020, bottom + 0.45 * back)]
    spine = ag.sweep(ag.rectangle(0.05, 0.016, radius=0.005), ag.polyline(line, fillet=0.02))
    arm = ag.part(spine | ag.cylinder(0.012, 0.052, axis=X).at(hinge), "frame", NYLON)
    if style == "executive":
        rolls = zip((0.064, 0.064, 0.060, 0.058, 0.068), (0.12, 0.05, -0.06, -0.14, -0.12), strict=True)
        pads = []
        for i, (thick, turn) in enumerate(rolls):
            pad = ag.box(width - 0.05, thick, back / 5 + 0.014, bevel=0.026)
            pads.append(pad.rotate(X, turn).at(at(0, (i + 0.5) / 5)))
        held = ag.grasp_on(pads[4], approach=-Z, closing=Y, depth=0.03)
        return ag.weld(ag.part(ag.union(*pads), "backrest", fabric, grasp=held), arm)
    turns = [2 * pi * (i + 0.5) / 28 for i in range(28)]
    rim = [(copysign(abs(cos(a)) ** 0.5, cos(a)), copysign(abs(sin(a)) ** 0.5, sin(a))) for a in turns]
    frame = ag.sweep(ag.ellipse(0.010, 0.013), ag.polyline([at(u, (1 + v) / 2) for u, v in rim], closed=True))
    inside = ag.extrude(ag.polygon([(at(u, 0)[0], at(0, (1 + v) / 2)[2]) for u, v in rim]), 1.2, axis=Y)
    section = [(at(u, 0)[0], depth) for u, depth in zip((-1, -0.5, 0, 0.5, 1), SAG, strict=True)]
    strip = ag.polygon([(x, d - 0.002) for x, d in section] + [(x, d + 0.002) for x, d in reversed(section)])
    mesh = ag.sweep(strip, ag.polyline([at(0, up) for up in (-0.1, 0.28, 0.65, 1.15)])) & inside
    lumbar = ag.hull(*(ag.torus(0.022, 0.010, axis=Y).at(at(u, 0.30)).at(0, 0.012, 0) for u in (-0.28, 0.28)))
    held = ag.grasp_on(frame, approach=-Z, closing=Y, at=at(0, 1))
    rest = ag.weld(ag.part(mesh, "backrest", MESH), ag.part(frame, "frame", NYLON, grasp=held))
    return ag.weld(rest, ag.part(lumbar, "frame", NYLON), arm)


@ag.category(
    labels="base caster wheel column foot_ring gas_lift seat cushion mechanism lever backrest frame sleeve "
    "armrest",
    joints=(13, 17),
)
def office_chair(
    *,
    style: Style = ag.choice({"task": 3, "executive": 2, "stool": 1}),
    seat_height: ag.Float = ag.by("style", stool=ag.uniform(0.58, 0.66), otherwise=ag.uniform(0.42, 0.46)),
    lift: ag.Float = ag.uniform(0.09, 0.12, "m", within=(0.03, 0.14), doc="stroke of the gas lift"),
    width: ag.Float = ag.uniform(0.47, 0.52, "m", within=(0.40, 0.60), doc="width of the seat"),
    depth: ag.Float = ag.uniform(0.45, 0.49, "m", within=(0.38, 0.56), doc="depth of the seat"),
    back: ag.Float = ag.by("style", executive=ag.uniform(0.62, 0.72), otherwise=ag.uniform(0.50, 0.58)),
    tilt: ag.Float = ag.uniform(0.30, 0.42, "rad", within=(0.1, 0.5), doc="largest angle of the back"),
    base_radius: ag.Float = ag.uniform(0.30, 0.34, "m", within=(0.26, 0.36), doc="radius to the casters"),
    caster_radius: ag.Float = ag.uniform(0.025, 0.030, "m", within=(0.02, 0.04)),
    arm_travel: ag.Float = ag.uniform(0.06, 0.09, "m", within=(0.02, 0.10), doc="travel of the armrests"),
    fabric: ag.Material = ag.by("style", executive=ag.shades(LEATHER, COGNAC), otherwise=ag.shades(*FABRICS)),
    finish: ag.Material = ag.by("style", task={NYLON: 2, ALU: 1}, otherwise={CHROME: 1, NYLON: 1}),
) -> ag.Body:
    """Make an office swivel chair at its lowest, upright."""
    low, mech = 2 * caster_radius + 0.012, seat_height - 0.125  # undersides of the legs and of the mechanism
    base = base_of(base_radius, low, mech - 0.012, finish)
    caster = caster_of(caster_radius, low - 0.0006).rotate(Z, 0.4)
    turn = ag.Revolute("caster_swivel", axis=Z, feel=feel.CASTER, driven="the floor")
    feet = ag.ring_points((0, 0, 0), base_radius, count=5, start=-pi / 2)
    base = base.repeat(caster, turn, at=feet, around=Z)
    seat = seat_of(style, width, depth, mech, seat_height, fabric)
    if style == "stool":
        climb = ag.Prismatic("foot_ring_height", axis=Z, limits=(0, 0.10), friction=25.0, damping=5.0)
        base = base.attach(ring_of(0.24), climb)
    else:
        hinge, spring = ag.vector(0, depth / 2 + 0.008, mech + 0.046), ag.Spring(stiffness=60.0, rest=-0.3)
        lean = ag.Revolute("back_tilt", axis=-X, pivot=hinge, limits=(0, tilt), spring=spring, feel=LEAN)
        slide = ag.Prismatic("arm_lift", axis=Z, limits=(0, arm_travel), friction=20.0)
        seat = seat.attach(back_of(style, width, back, hinge, seat_height, fabric), lean)
        seat = seat.attach_pair(arm_of(width, mech, LEATHER if style == "executive" else NYLON), slide)
    bar = ag.cylinder(0.0140, lift + 0.08, bevel=0.001).align((0, 0, mech + 0.02), z=1)
    carrier = ag.part(bar, "gas_lift", CHROME)
    carrier = carrier.attach(seat, ag.Revolute("seat_swivel", axis=Z, friction=0.5, damping=0.2))
    hold = 15 * seat.mass()  # one and a half times its weight
    rise = ag.Prismatic(
        "seat_lift", axis=Z, limits=(0, lift), feel=feel.GAS_SPRING, friction=hold, driven="gas"
    )
    return base.attach(carrier, rise)
