"""Hoods with a front of their own: a flap, a visor that is drawn out, an inclined pane, curved glass."""

import math

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.range_hood.parts import LAMP, Look, duct, lamps, name_of, with_filters, with_keys
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, filled
from artgen.nodes.fitting import FIT, Fitting

_WIDE = 0.75  # angle of an open pane [rad]
_STEEL = ag.material("stainless")
_PANE = ag.material("tinted_glass").with_(name="hood_glass", opacity=0.35)


def cabinet(plan: ag.Region, look: Look, friction: ag.Scalar) -> ag.Body:
    """Make a flat hood below a cabinet, with sliders and a flap at its front."""
    low, front, roof = plan.z.low, plan.y.low, plan.z.high - 0.028
    case = plan.shrink(x=0.002, front=0.030).with_(z=(low, low + 0.100))
    upper = case.with_(y=plan.y, z=(low + 0.096, roof))
    shell = case.box(bevel=0.002) | upper.box(bevel=0.002)
    collar = ag.tube(0.062, 0.058, 0.034, bevel=0.001).at(0, 0.02, roof + 0.011)
    hood = ag.weld(
        ag.part(shell, "hood", filled(look.finish, 165.0, "case"), name="hood"),
        ag.part(collar, "hood", ag.material("black_abs")),
    )
    hood = with_filters(hood, case.shrink(x=0.035, front=0.070, back=0.030), look, 2)
    spots = [(side * 0.20, case.y.low + 0.036) for side in (-1, 1)]
    level = (low + 0.096 + roof) / 2
    hood = ag.weld(hood, *lamps(spots, low, look.metal), name_of(look, (-0.20, front, level)))
    for number, (x, sign, way) in enumerate(((0.09, "light", 1), (0.25, "fan", -1))):
        hood = hood.install(_slider(look, sign, way).suffixed(f"_{number}"), at=(x, front, level))
    hood = hood.output("light", signals.level("slider_slide_0"), kind="light", material=LAMP)
    hood = hood.output("fan", signals.level("slider_slide_1"), kind="flow")
    return _flap(hood, plan, case.y.low, friction, look)


def _slider(look: Look, sign: str, way: int) -> Fitting:
    """Make a slider with three positions on the plane y = 0, which moves to the right or to the left."""
    travel, half = 0.024, 0.005
    nub = ag.Region((-half, half), (-0.0145, -FIT.running), (-0.0055, 0.0055)).box(bevel=0.0012)
    stem = ag.Region((-0.0035, 0.0035), (-0.002, 0.0050), (-0.0016, 0.0016)).box()
    slide = ag.Prismatic(
        "slider_slide", axis=way * ag.X, limits=(0, travel), friction=0.5, damping=3.0, armature=0.02,
        effort=15.0, detents=feel.detents((0.0, travel / 2, travel), 2.0),
    )  # fmt: skip
    push = ag.push_on(nub, direction=way * ag.X, at=(-way * half, -0.0104, 0))
    part = ag.part([nub, stem], "slider", look.metal, name="slider", push=push)
    slot = ag.box(travel + 0.0084, 0.0160, 0.0044).at(way * travel / 2, -0.0020, 0)
    film = details.printed(details.icon(sign, 0.009), (-way * 0.018, 0, 0), material=look.ink)
    dot = ag.circle(0.0008)
    marks = dot | dot.at(way * travel / 2) | dot.at(way * travel)
    dots = details.printed(marks, (0, 0, -0.0085), material=look.ink)
    return Fitting.moving(part, slide, fixed=ag.weld(film, dots), cut=slot.paint(DARK))


def _flap(hood: ag.Body, plan: ag.Region, face: ag.Scalar, friction: ag.Scalar, look: Look) -> ag.Body:
    """Add the flap of smoked plastic at the front, which swings out against the steam."""
    y, z = plan.y.low + 0.0105, plan.z.low + 0.086
    far = plan.x.high
    pane = ag.Region((-far, far), (y - 0.0025, y + 0.0025), (plan.z.low + 0.0005, z - 0.009)).box(
        bevel=0.0012
    )
    web = ag.Region((0.034 - far, far - 0.034), (y - 0.0024, y + 0.0024), (z - 0.012, z)).box()
    barrel = ag.cylinder(0.005, 2 * far - 0.068, axis=ag.X).at(0, y, z)
    ears = []
    for side in (-1, 1):
        x = side * (far - 0.026)
        ears.append(
            ag.cylinder(0.0065, 0.014, axis=ag.X, bevel=0.0005).at(x, y, z)
            | ag.Region((x - 0.007, x + 0.007), (y + 0.001, face + 0.002), (z - 0.0065, z + 0.0065)).box()
        )
    hold = ag.grasp_on(pane, approach=-ag.X, closing=ag.Y, at=(far, y, plan.z.low + 0.034), depth=0.012)
    smoke = ag.material("polycarbonate").with_(name="smoked", base_color=(0.10, 0.095, 0.09), opacity=0.72)
    flap = ag.weld(
        ag.part(pane, "flap", smoke, name="flap", grasp=hold), ag.part([web, barrel], "flap", smoke)
    )
    torque = 1.1 * friction * flap.weight() * 0.05
    swing = ag.Revolute(
        "flap_hinge", axis=-ag.X, pivot=(0, y, z), limits=(0, 1.0), friction=torque, damping=0.01,
        armature=2e-4, effort=6.0,
    )  # fmt: skip
    return ag.weld(hood, ag.part(ears, "hood", ag.material("black_abs"))).attach(flap, swing)


def telescopic(plan: ag.Region, look: Look) -> ag.Body:
    """Make a hood that fills a cabinet, with a visor that is drawn out."""
    plan = plan.at(z=-plan.z.low)
    far, front, back = plan.x.high, plan.y.low, plan.y.high
    roof = plan.z.high - 0.030
    steel = ag.material("steel").with_(name="zinc_sheet", base_color=(0.50, 0.51, 0.52))
    case = ag.Region((0.034 - far, far - 0.034), (front + 0.0235, back), (0.012, 0.200))
    block = case.with_(z=(0.054, 0.200))
    walls = [
        case.with_(x=(case.x.low, case.x.low + 0.004), z=(0.012, 0.056)),
        case.with_(x=(case.x.high - 0.004, case.x.high), z=(0.012, 0.056)),
        case.with_(y=(back - 0.020, back), z=(0.012, 0.056)),
    ]
    box = block.shrink(x=0.055, y=0.020).with_(z=(0.198, roof))
    collar = ag.tube(0.062, 0.058, 0.036, bevel=0.001).at(0, case.y.mid, roof + 0.012)
    hood = ag.weld(
        ag.part(block.box(bevel=0.0012), "hood", filled(steel, 150.0, "case"), name="hood"),
        ag.part([wall.box() for wall in walls], "hood", filled(steel, 2600.0, "wall")),
        ag.part(box.box(bevel=0.003), "hood", filled(steel, 190.0, "blower")),
        ag.part(collar, "hood", ag.material("black_abs")),
    )
    tray = case.shrink(x=0.0050, front=-0.004, back=0.050).with_(z=(0.018, 0.0530))
    strip = ag.Region((-far, far), (front, front + 0.0215), (0, 0.062))
    hold = ag.grasp_on(strip.box(), approach=-ag.X, closing=ag.Y, at=(far, strip.y.mid, 0.037), depth=0.014)
    spots = [(side * 0.19, tray.y.low + 0.040) for side in (-1, 1)]
    field = ag.rectangle(tray.x.size - 0.03, tray.y.size - 0.095, radius=0.006)
    mesh = details.printed(
        field, (0, tray.y.mid + 0.034, tray.z.low), material=ag.material("mesh"), facing=-ag.Z, label="mesh"
    )
    visor = ag.weld(
        ag.part(
            strip.box(bevel=0.002), "visor", filled(look.finish, 900.0, "strip"), name="visor", grasp=hold
        ),
        ag.part(tray.box(), "visor", filled(steel, 210.0, "tray")),
        mesh,
        *lamps(spots, tray.z.low, look.metal),
        name_of(look, (-0.62 * far, front, 0.031)),
    )
    visor = with_keys(visor, look, (0.0, front, 0.031), count=4)
    slide = ag.Prismatic(
        "visor_slide", axis=-ag.Y, limits=(0, tray.y.size - 0.055), feel=feel.RUNNER, friction=7.0
    )
    return hood.attach(visor, slide).output("light", slide > 0.02, kind="light", material=LAMP)


def inclined(plan: ag.Region, look: Look, glass: ag.Material, friction: ag.Scalar) -> ag.Body:
    """Make a hood behind an inclined pane that swings out at its lower end."""
    low, front, back, far = plan.z.low, plan.y.low, plan.y.high, plan.x.high
    foot, head = (front + 0.026, low + 0.040), (back - 0.172, low + 0.430)
    run, rise = head[0] - foot[0], head[1] - foot[1]
    lean, long = ag.atan2(run, rise), ag.sqrt(run * run + rise * rise)
    half = far - 0.045
    outline = ag.polygon([(back, low), (foot[0], low), foot, head, (back, head[1])])
    body = ag.extrude(outline, 2 * half, axis=ag.X, bevel=0.0015)
    strip = ag.Region((-far, far), (front, foot[0] + 0.02), (low, foot[1])).box(bevel=0.002)
    hood = ag.weld(
        ag.part(body, "hood", filled(look.finish, 120.0, "case"), name="hood"),
        ag.part(strip, "hood", filled(look.finish, 700.0, "strip")),
        duct(plan, look, head[1] - 0.001, back - 0.084, 0.168),
    )
    room = ag.Region((0.03 - half, half - 0.03), (foot[0] + 0.030, back - 0.035), (low, low + 0.1))
    hood = with_filters(hood, room, look, 2)
    spots = [(side * 0.55 * far, front + 0.034) for side in (-1, 1)]
    hood = ag.weld(hood, *lamps(spots, low, look.metal))
    hood = with_keys(hood, look, (0.30 * far, front, low + 0.020))
    pane = _pane(look, glass, far, long, lean, friction)
    middle = (0.0, (foot[0] + head[0]) / 2, (foot[1] + head[1]) / 2)
    return hood.install(pane.rotate(ag.X, -lean), at=middle)


def _pane(
    look: Look, glass: ag.Material, far: ag.Scalar, long: ag.Scalar, lean: ag.Scalar, friction: ag.Scalar
) -> Fitting:
    """Make the pane before a wall y = 0 with its hinges at the top, upright."""
    pane = ag.Region((-far, far), (-0.0220, -0.0160), (0.006 - long / 2, long / 2 + 0.002))
    y, z = -0.0080, long / 2 - 0.006
    lugs, ears = [], []
    for side in (-1, 1):
        x = side * 0.16
        lugs.append(
            ag.cylinder(0.005, 0.030, axis=ag.X, bevel=0.0005).at(x, y, z)
            | ag.Region((x - 0.015, x + 0.015), (-0.0170, y), (z - 0.005, z + 0.005)).box()
        )
        ears += [
            ag.cylinder(0.005, 0.010, axis=ag.X, bevel=0.0005).at(x + way * 0.0206, y, z)
            | ag.Region(
                (x + way * 0.0206 - 0.005, x + way * 0.0206 + 0.005), (y, 0.003), (z - 0.005, z + 0.005)
            ).box()
            for way in (-1, 1)
        ]
    sheet = pane.box(bevel=0.0015)
    hold = ag.grasp_on(sheet, approach=-ag.X, closing=ag.Y, at=(far, pane.y.mid, -0.05), depth=0.012)
    light = glass.with_(name=f"{glass.name}_pane", density=2500.0)
    front = ag.weld(
        ag.part(sheet, "panel", light, name="panel", grasp=hold),
        ag.part(lugs, "panel", _STEEL),
        name_of(look, (0, pane.y.low, -0.36 * long), controls.ink_on(glass)),
    )
    # a spring carries a part of the weight, and friction holds the rest
    moment = front.weight() * long / 2
    stiffness = 0.7 * moment * ag.sin(lean + 0.4) / 2.6
    drag = friction * (moment * ag.sin(lean + _WIDE) - stiffness * (3.0 - _WIDE))
    swing = ag.Revolute(
        "panel_hinge", axis=-ag.X, pivot=(0, y, z), limits=(0, _WIDE), stiffness=stiffness, rest=3.0,
        friction=drag, damping=0.6, effort=60.0,
    )  # fmt: skip
    steel = ag.part(ears, "hood", _STEEL)
    field = ag.rectangle(2 * far - 0.20, 0.62 * long, radius=0.01)
    grease = details.printed(field, (0, 0, -0.03), material=ag.material("mesh"), label="mesh")
    return Fitting.moving(front, swing, fixed=ag.weld(steel, grease))


def curved(plan: ag.Region, look: Look) -> ag.Body:
    """Make a narrow canopy below a curved pane of glass, with a chimney on it."""
    low, half = plan.z.low, ag.min_(0.56, plan.x.size - 0.10) / 2
    radius, crest = 1.9 * plan.x.size, low + 0.078
    xs = [half * step / 6 for step in range(6, -7, -1)]
    top = [(x, crest - radius + ag.sqrt(radius * radius - x * x)) for x in xs]
    deep = plan.y.size - 0.090
    outline = ag.polygon([(-half, low), (half, low), *top])
    slab = ag.extrude(outline, deep, axis=ag.Y, bevel=0.0015).at(y=plan.y.high - deep / 2)
    hood = ag.part(slab, "hood", filled(look.finish, 330.0, "canopy"), name="hood")
    angle = 2.0 * math.asin(0.5 / 1.9)
    bow = ag.bow(radius + 0.0025, 0.006, start=math.pi / 2 - angle / 2, sweep=angle)
    sheet = ag.extrude(bow, plan.y.size, axis=ag.Y).at(z=crest - radius)
    hood = ag.weld(
        hood, ag.part(sheet, "glass", _PANE), duct(plan, look, crest + 0.002, plan.y.high - 0.132, 0.262)
    )
    front = plan.y.high - deep
    room = plan.with_(x=(0.030 - half, half - 0.030), y=(front + 0.070, plan.y.high - 0.035))
    hood = with_filters(hood, room, look, 2)
    spots = [(side * 0.62 * half, front + 0.038) for side in (-1, 1)]
    level = low + 0.027
    hood = ag.weld(hood, *lamps(spots, low, look.metal), name_of(look, (-0.66 * half, front, level)))
    return with_keys(hood, look, (0.0, front, level))
