"""A kettle: an electric one that lifts off its base, or a whistling one for a stove.

Links: `base` and `jug` of an electric kettle, or `jug` alone; `lid`; `switch`; `bail`, the folding handle of
a stove kettle, and `whistle`, the cap of its spout. Joints: `jug_lift` and `jug_turn`; `lid_hinge`, or
`lid_lift` of a lid that lifts off; `switch_turn`; `bail_turn`; `whistle_hinge`.

The lid of a stove kettle lifts off only beside its folded handle. A jug turns and lifts on its base, and a
lid stays open beyond upright.

Sizes are those of shops: electric kettles hold 1.0-1.7 l, are 140-165 mm wide at the foot and 190-240 mm high
on a base of 155-175 mm, and weigh 0.9-1.2 kg empty; stove kettles hold 1.5-2.5 l and are 180-215 mm wide.
Kettles are filled by half: the density of a jug is that with its water.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["spout", "gooseneck", "stove"]
"""An electric kettle with a short spout or with a gooseneck, or a whistling kettle for a stove."""

Form = Literal["cone", "barrel", "straight", "dome"]
"""Outline of a jug: it narrows to the top, bulges, or has straight walls; a dome of a stove kettle."""

_WALL = 0.0014  # thickness of the visible wall [m]
_BASE = 0.022  # height of the base [m]
_SIDES = 20  # facets of the core of a jug
_FORMS = {
    "cone": ((1.0, 0.0), (0.93, 0.34), (0.84, 0.68), (0.74, 1.0)),
    "barrel": ((0.92, 0.0), (1.0, 0.30), (0.97, 0.66), (0.80, 1.0)),
    "straight": ((1.0, 0.0), (1.0, 0.34), (1.0, 0.68), (0.98, 1.0)),
    "dome": ((0.95, 0.0), (1.0, 0.16), (0.96, 0.42), (0.78, 0.78), (0.48, 1.0)),
}
"""Shares of the radius and of the height, from the floor to the rim."""

_SHELLS = ag.choice(
    "stainless", "stainless_blasted", "copper", *colors("enamel", "white cream red sage black sky")
)
_GRIPS = ag.choice("black_abs", "walnut", "beech", ag.colored("abs", "white"), ag.colored("abs", "graphite"))
_LID = feel.Feel(friction=0.1, damping=2.0, effort=4.0)


@ag.category(
    labels="base foot cord jug rim lid knob handle spout switch bail whistle hinge print", joints=(3, 4)
)
def kettle(
    *,
    style: Style = ag.choice({"spout": 0.45, "gooseneck": 0.2, "stove": 0.35}),
    form: Form = ag.by(
        "style", spout={"cone": 0.5, "barrel": 0.3, "straight": 0.2}, gooseneck="cone", stove="dome"
    ),
    width: ag.Float = ag.by(
        "style",
        stove=ag.uniform(0.180, 0.212),
        gooseneck=ag.uniform(0.140, 0.155),
        otherwise=ag.uniform(0.142, 0.162),
        unit="m",
        within=(0.13, 0.23),
        doc="largest width of the jug",
    ),
    height: ag.Float = ag.by(
        "style",
        stove=ag.uniform(0.115, 0.145),
        gooseneck=ag.uniform(0.125, 0.150),
        otherwise=ag.uniform(0.165, 0.205),
        unit="m",
        within=(0.10, 0.23),
        doc="height of the jug up to its rim",
    ),
    opens: ag.Float = ag.uniform(1.65, 1.85, "rad", within=(1.2, 1.9), doc="angle of an open lid"),
    friction: ag.Float = ag.uniform(0.05, 0.12, "N m", doc="friction of the folding handle"),
    shell: ag.Material = _SHELLS,
    grip: ag.Material = _GRIPS,
    metal: ag.Material = ag.shades("chrome", "stainless", "black_steel", weights=(2, 3, 1)),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed kettle, on its base or on its own feet."""
    radius = width / 2
    if style == "stove":
        height = ag.require(height, height >= 0.117, "height of a stove kettle must be >= 0.117 m")
        return _stove(radius, height, friction, shell, grip, metal, maker)
    if form == "dome":
        radius = ag.require(radius, width <= 0.14, "width of a dome with a base must be <= 0.14 m")
    jug, rim = _jug(form, radius, height, shell, maker)
    jug = ag.weld(jug, _handle(radius, rim, height, grip))
    jug = ag.weld(jug, _beak(rim, height, shell) if style == "spout" else _gooseneck(radius, height, shell))
    jug = jug.install(_lid(rim, opens, grip, metal), at=(0, 0, height))
    jug = jug.install(_switch(grip), at=(0, rim + 0.045, ag.min_(0.030, 0.30 * height - 0.0105)))
    low = _BASE + FIT.running
    lift = ag.Prismatic("jug_lift", axis=ag.Z, limits=(0, 0.15), friction=0.2, damping=2.0, effort=80.0)
    turn = ag.Revolute("jug_turn", axis=ag.Z, friction=0.02, damping=0.01, effort=5.0)
    heats = signals.pressed("switch_turn") & (lift < 0.004)
    return _base(radius, metal).attach(jug, lift, turn, at=(0, 0, low)).output("heat", heats, kind="heat")


def _jug(
    form: Form, radius: ag.Scalar, height: ag.Scalar, shell: ag.Material, maker: str
) -> tuple[ag.Body, ag.Scalar]:
    """Make an open jug with its rim, and return it with the radius of the rim."""
    points = [(share * radius, z * height) for share, z in _FORMS[form]]
    rim = points[-1][0]
    runs: list[vessels.Run] = [
        [(points[0][0] - 0.004, 0), (points[0][0], 0.004)],
        [(points[0][0], 0.004), *points[1:]],
    ]
    inside = ag.extrude(ag.regular_polygon(14, 0.86 * rim), height).at(z=0.16 * height + height / 2)
    core = vessels.core(runs, sides=_SIDES) - inside
    skin = ag.revolve(ag.half_section(vessels.path_of(points), wall=_WALL), sides=48)
    brim = ag.tube(rim + 0.0008, 0.84 * rim, 0.003, bevel=0.001).at(z=height - 0.0015)
    round_ = 0.838 * rim  # within the plane walls of the core
    liner = ag.tube(round_, round_ - 0.0008, 0.84 * height - 0.001).align((0.0, 0.0, height - 0.001), z=1)
    wet = shell.with_(name=f"{shell.name}_jug", density=620.0)
    jug = ag.weld(
        ag.part(core, "jug", wet), ag.detail([skin, liner], "jug", shell), ag.detail(brim, "rim", shell)
    )
    wall = ag.spline([(r, 0.0, z) for r, z in points])
    mark = details.wrapped(details.logo(maker, 0.006), wall, 0.30 * height, material=controls.ink_on(shell))
    return ag.weld(jug, mark.rotate(ag.Z, -math.pi / 2)), rim


def _handle(radius: ag.Scalar, rim: ag.Scalar, height: ag.Scalar, grip: ag.Material) -> ag.Body:
    """Make the handle behind a jug, with the block for the hinge of the lid on it."""
    top, low = height - 0.012, 0.30 * height
    line = [(0, rim - 0.008, top), (0, rim + 0.056, top), (0, rim + 0.052, low), (0, 0.93 * radius, low)]
    bend = ag.min_(0.018, rim + 0.051 - 0.93 * radius)
    bar = ag.sweep(ag.rectangle(0.022, 0.015, radius=0.005), ag.polyline(line, fillet=bend))
    hold = ag.grasp_on(bar, approach=-ag.Y, closing=ag.X, at=(0, rim + 0.054, (top + low) / 2), depth=0.012)
    block = ag.Region((-0.017, 0.017), (rim - 0.004, rim + 0.016), (top - 0.002, height)).box(bevel=0.002)
    return ag.part(bar | block, "handle", grip.with_(name=f"{grip.name}_handle", density=900.0), grasp=hold)


def _beak(rim: ag.Scalar, height: ag.Scalar, shell: ag.Material) -> ag.Body:
    """Make a short spout at the rim, open above."""
    tip = ag.cylinder(0.0055, 0.006, bevel=0.0015).at(0, -rim - 0.024, height - 0.0035)
    side = ag.cylinder(0.007, 0.008, bevel=0.0015)
    roots = [side.at(x, -rim + 0.003, height - 0.0045) for x in (-0.019, 0.019)]
    foot = ag.sphere(0.006).at(0, -rim + 0.006, height - 0.055)
    mouth = ag.polygon([(-0.018, 0.0), (-0.003, -0.022), (0.003, -0.022), (0.018, 0.0)], radius=0.002)
    tin = shell.with_(name=f"{shell.name}_spout", density=900.0)
    return ag.weld(
        ag.part(ag.hull(tip, *roots, foot), "spout", tin),
        _mouth(mouth, ag.vector(0, -rim, height - 0.0005), ag.Z, ag.Y),
    )


def _gooseneck(radius: ag.Scalar, height: ag.Scalar, shell: ag.Material) -> ag.Body:
    """Make a thin bent spout from the foot of the jug to above its rim."""
    start, top = 0.90 * radius, height + 0.012
    points = [
        (0, -start, 0.022), (0, -start - 0.026, 0.036), (0, -start - 0.039, 0.45 * top),
        (0, -start - 0.044, 0.80 * top), (0, -start - 0.062, top), (0, -start - 0.088, 0.93 * top),
    ]  # fmt: skip
    way = ag.spline(points)
    pipe = ag.sweep(ag.regular_polygon(8, 0.0058), way)
    root = ag.hull(ag.sphere(0.013).at(0, -start, 0.026), ag.sphere(0.0064).at(0, -start - 0.028, 0.042))
    look = ag.sweep(ag.circle(0.0061), way)
    hollow = shell.with_(name=f"{shell.name}_spout", density=1500.0)
    end = (ag.vector(*points[-1]) - ag.vector(*points[-2])).normalized()
    tip = ag.vector(*points[-1]) + end * 0.001
    lip = ag.cylinder_between(tip - end * 0.005, tip, 0.0068, bevel=0.001)
    return ag.weld(
        ag.part(pipe | root, "spout", hollow),
        ag.detail(look, "spout", shell),
        ag.detail(lip, "spout", shell),
        _mouth(ag.circle(0.0050), tip, end, ag.X),
    )


def _mouth(outline: ag.Profile, at: ag.Vector, way: ag.Vector, up: ag.Vector) -> ag.Body:
    """Make the dark opening of a spout."""
    return details.printed(outline, at, material=ag.material("black_abs"), facing=way, up=up, label="spout")


def _lid(rim: ag.Scalar, opens: ag.Scalar, grip: ag.Material, metal: ag.Material) -> Fitting:
    """Make the lid on the rim with its knob, hinged at the handle behind it."""
    axle, up = rim + 0.007, 0.0062
    disc = ag.cylinder(rim - 0.001, 0.006, bevel=0.0015).at(z=FIT.running + 0.003)
    dome = ag.dome(0.82 * rim, height=0.010).at(z=0.0062)
    knob = ag.cylinder(0.011, 0.017, bevel=0.003).at(z=0.0225)
    tongue = ag.Region((-0.0085, 0.0085), (rim - 0.012, axle), (0.0025, 0.0085)).box()
    barrel = ag.cylinder(0.0045, 0.017, axis=ag.X, bevel=0.0005).at(0, axle, up)
    ears = [
        ag.cylinder(0.0045, 0.006, axis=ag.X, bevel=0.0005).at(x, axle, up)
        | ag.box(0.006, 0.008, up + 0.001).align((x, axle, -0.001), z=-1)
        for x in (-0.0122, 0.0122)
    ]
    hold = ag.grasp_on(knob, approach=-ag.Z, closing=ag.X, depth=0.014)
    lid = ag.weld(
        ag.part(knob, "knob", grip, name="lid", grasp=hold),
        ag.part(disc | dome | tongue | barrel, "lid", metal.with_(name="lid_shell", density=2200.0)),
    )
    turn = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=(0, axle, up), limits=(0, opens), feel=feel.PIVOT, friction=0.02
    )
    return Fitting.moving(lid, turn, fixed=ag.part(ears, "hinge", metal, separate="two ears"))


def _switch(grip: ag.Material) -> Fitting:
    """Make the lever below the handle that switches the heater on."""
    bracket = ag.part(ag.box(0.012, 0.012, 0.03).at(z=0.02), "handle", grip)
    plate = ag.Region((-0.011, 0.011), (-0.006, 0.044), (-0.0035, 0.0035)).box(bevel=0.0025)
    press = ag.push_on(plate, direction=-ag.Z, at=(0, 0.034, 0.0035))
    lever = ag.part(plate, "switch", ag.material("black_abs"), push=press)
    turn = ag.Revolute("switch_turn", axis=-ag.X, limits=(0, 0.2), feel=feel.LEVER, friction=0.04, effort=2.0)
    return Fitting.moving(lever.at(z=-0.002), turn, fixed=bracket)


def _base(radius: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the base of an electric kettle with its cord."""
    plate = ag.cylinder(radius + 0.007, _BASE - 0.002, bevel=0.004).at(z=_BASE / 2 + 0.001)
    feet = ag.cylinder(radius - 0.008, 0.003, bevel=0.0005).at(z=0.0015)
    ring = ag.detail(ag.tube(radius + 0.0076, radius + 0.004, 0.004, bevel=0.001).at(z=0.012), "base", metal)
    line = [
        (0, radius, 0.006),
        (0, radius + 0.035, 0.006),
        (0.02, radius + 0.07, 0.0038),
        (0.06, radius + 0.085, 0.0038),
    ]
    cord = ag.sweep(ag.regular_polygon(8, 0.0034), ag.spline(line))
    black = ag.material("black_abs")
    return ag.weld(
        ag.part(plate, "base", black),
        ag.part(feet, "foot", ag.material("rubber")),
        ag.part(cord, "cord", black),
        ring,
    )


def _stove(
    radius: ag.Scalar,
    height: ag.Scalar,
    friction: ag.Scalar,
    shell: ag.Material,
    grip: ag.Material,
    metal: ag.Material,
    maker: str,
) -> ag.Body:
    """Make a whistling kettle with a lid that lifts off and a handle that folds to both sides."""
    jug, neck = _jug("dome", radius, height, shell, maker)
    start = ag.vector(0, -0.90 * radius, 0.30 * height)
    way = ag.vector(0, -0.70, 0.714)
    tip = start + way * 0.085
    spout = ag.hull(ag.sphere(0.024).at(start), ag.cylinder_between(tip - way * 0.004, tip, 0.0125))
    tin = shell.with_(name=f"{shell.name}_spout", density=900.0)
    jug = ag.weld(jug, ag.part(spout, "spout", tin), _mouth(ag.circle(0.0105), tip, way, ag.X))
    knob = ag.cylinder(0.0125, 0.018, bevel=0.004).at(z=height + 0.023)
    disc = ag.cylinder(neck + 0.003, 0.005, bevel=0.0015).at(z=height + FIT.running + 0.0025)
    dome = ag.dome(0.94 * neck, height=0.012).at(z=height + 0.005)
    hold = ag.grasp_on(knob, approach=-ag.Z, closing=ag.X, depth=0.015)
    cover = metal.with_(name="lid_shell", density=2200.0)
    lid = ag.weld(ag.part(knob, "knob", grip, name="lid", grasp=hold), ag.part(disc | dome, "lid", cover))
    jug = jug.install(_whistle(metal), at=tip)
    axle, reach = 0.70 * height, 0.84 * radius
    up = height + 0.057 - axle  # from the axis of the handle to its grip [m]
    pivots = [
        ag.Region((-0.008, 0.008), (y - 0.009, y + 0.009), (axle - 0.030, axle + 0.006))
        for y in (-reach, reach)
    ]
    jug = ag.weld(jug, ag.part([pivot.box(bevel=0.002) for pivot in pivots], "hinge", metal))
    outer = reach + 0.009 + FIT.running + 0.003
    line = [(0, -outer, axle), (0, -outer, axle + up), (0, outer, axle + up), (0, outer, axle)]
    hoop = ag.sweep(ag.rectangle(0.010, 0.005, radius=0.002), ag.polyline(line, fillet=0.035))
    eyes = [ag.cylinder(0.0085, 0.0058, axis=ag.Y, bevel=0.0008).at(0, y, axle) for y in (-outer, outer)]
    wood = ag.cylinder(0.0125, 0.10, axis=ag.Y, bevel=0.004).at(z=axle + up)
    held = ag.grasp_on(wood, approach=-ag.Z, closing=ag.X, depth=0.018)
    bail = ag.weld(
        ag.part(wood, "bail", grip, name="bail", grasp=held), ag.part(ag.union(hoop, *eyes), "bail", metal)
    )
    drag = feel.Feel(friction=friction, damping=0.01, effort=8.0)
    fold = ag.Revolute("bail_turn", axis=ag.Y, pivot=(0, 0, axle), limits=(-1.1, 1.1), feel=drag)
    lift = ag.Prismatic(
        "lid_lift", axis=ag.Z, limits=(0, 0.09), feel=_LID, needs=(fold > 0.95).beyond(0.0108)
    )
    return jug.attach(bail, fold).attach(lid, lift)


def _whistle(metal: ag.Material) -> Fitting:
    """Make the cap of a spout, hinged above its tip at the origin."""
    slant = 0.775  # of the spout from upright [rad]
    cap = ag.cylinder(0.0145, 0.010, bevel=0.002).at(z=FIT.running + 0.005)
    barrel = ag.cylinder(0.004, 0.010, axis=ag.X, bevel=0.0004).at(0, 0.0195, 0.005)
    tongue = ag.Region((-0.005, 0.005), (0.008, 0.0195), (0.002, 0.008)).box()
    ears = []
    for x in (-0.0078, 0.0078):
        foot = ag.Region((x - 0.002, x + 0.002), (0.0158, 0.0225), (-0.012, 0.004)).box()
        foot |= ag.Region((x - 0.002, x + 0.002), (0.004, 0.0225), (-0.012, -0.003)).box()
        ears.append(ag.cylinder(0.004, 0.004, axis=ag.X, bevel=0.0004).at(x, 0.0195, 0.005) | foot)
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.X, depth=0.008)
    made = ag.part(ag.union(cap, barrel, tongue), "whistle", metal, grasp=hold)
    turn = ag.Revolute(
        "whistle_hinge", axis=-ag.X, pivot=(0, 0.0195, 0.005), limits=(0, 1.3), feel=feel.PIVOT, friction=0.01
    )
    return Fitting.moving(made, turn, fixed=ag.part(ears, "hinge", metal)).rotate(ag.X, slant)
