"""A syringe: with a Luer tip, of glass, for doses by mouth, a pen for insulin, or one for icing.

Links: `barrel` with the `plunger` and the `cap`; a pen has the `dial` and its `button`, a syringe for icing
the `nozzle`. Joints: `plunger_slide`, `cap_slide`; `dial_turn` with its rise, `button_slide`; `nozzle_turn`
with its rise. At 0 the plunger is pushed in, the dial is at 0 units, caps and nozzles are on.

Syringes lie with their tips to the left. Friction of the stopper holds the plunger, and draws no liquid. The
scale begins where the stopper ends. The dial of a pen turns out by its thread, and holds by friction; the
motor of the thread that turns it back under the thumb is left out. A spring returns the button.

Sizes are those of catalogs of BD, B. Braun (ISO 7886-1), Fortuna, Baxa, Novo Nordisk and Kaiser. The bore
follows from volume and stroke: 1 ml has 4.7 by 58 mm, 10 ml 15.4 by 54 mm, 60 ml 28.6 by 93 mm; with their
plungers they are 73-136 mm long and weigh 2-32 g, of glass 14-85 g. Pens for insulin are 155-170 mm long and
17 mm thick, 25-40 g; syringes for icing 245-295 by 48 mm, 0.08-0.31 kg. A plunger takes 2-10 N, of icing
6-15 N, a button 4-9 N.
"""

import math
from functools import reduce
from operator import or_
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, require_size
from artgen.categories.shared.finish import casting, colors

Style = Literal["luer", "glass", "oral", "pen", "icing"]
"""A syringe with a Luer tip, of glass, for doses by mouth, a pen for insulin, or for icing."""

Volume = Literal["1", "2.5", "3", "5", "10", "20", "30", "60"]
"""Volume of a syringe [ml]."""

_PLAY = 0.0003  # around a plunger, and between a cap and a barrel [m]
_FRONT = 0.0016  # thickness of the front wall of a barrel [m]
_CAP = feel.Feel(damping=4.0, armature=0.02, effort=30.0)
_DIAL = feel.Feel(friction=0.02, damping=0.004, armature=2e-4, effort=0.6)
_NOZZLE = feel.Feel(friction=0.08, damping=0.02, armature=4e-4, effort=2.0)
_PRESS = feel.Feel(friction=0.2, damping=3.0, armature=0.03, effort=20.0)
_CLEAR = ag.material("polycarbonate").with_(name="clear_polypropylene", opacity=0.32, density=905.0)
_GLASS = ag.material("glass").with_(name="borosilicate", opacity=0.35, density=2230.0)
_FROSTED = ag.material("frosted_glass").with_(name="ground_glass", opacity=0.9, density=1500.0)
_RUBBER = ag.material("rubber").with_(name="stopper_rubber")
_INK = ag.material("black_abs").with_(name="scale_ink")
_STEEL = ag.material("stainless")
# volume [ml]: bore [mm], wall [mm], volumes between lines and between numbers [ml]
_SIZES: dict[float, tuple[float, float, float, float]] = {
    1.0: (4.7, 0.85, 0.05, 0.2), 2.5: (8.9, 0.85, 0.1, 0.5), 3.0: (8.9, 0.85, 0.1, 0.5),
    5.0: (12.4, 0.90, 0.2, 1.0), 10.0: (15.4, 0.95, 0.5, 2.0), 20.0: (20.0, 1.05, 1.0, 5.0),
    30.0: (22.5, 1.2, 1.0, 5.0), 60.0: (28.6, 1.3, 2.0, 10.0),
}  # fmt: skip
_FINISHES = {
    "luer": ag.choice(*colors("polypropylene", "white white sky forest red")),
    "oral": ag.choice(*colors("polypropylene", "burgundy orange sky white yellow")),
    "glass": ag.choice("chrome", "satin_nickel"),
    "pen": ag.shades(*colors("glossy_plastic", "navy light_grey graphite sky orange"), "black_anodised"),
    "icing": ag.choice("stainless", "aluminium", *colors("abs", "white red")),
}
_CAPS = ag.choice(*colors("polypropylene", "red white sky orange"), doc="cap, or button of a pen")


@ag.category(
    labels="barrel tip flange plunger stopper cap cartridge dial button nozzle ring print window",
    joints=(1, 4),
)
def syringe(
    *,
    style: Style = ag.choice({"luer": 0.36, "glass": 0.14, "oral": 0.18, "pen": 0.16, "icing": 0.16}),
    volume: Volume = ag.by(
        "style",
        luer={"1": 0.15, "2.5": 0.15, "5": 0.2, "10": 0.2, "20": 0.16, "60": 0.14},
        oral={"1": 0.2, "3": 0.2, "5": 0.3, "10": 0.3},
        glass={"2.5": 0.2, "5": 0.2, "10": 0.3, "20": 0.15, "30": 0.15},
        otherwise="60",
        doc="volume of a syringe [ml]",
    ),
    length: ag.Float = ag.by(
        "style",
        pen=ag.uniform(0.155, 0.170),
        otherwise=ag.uniform(0.160, 0.190),
        unit="m",
        within=(0.14, 0.21),
        doc="length of a pen with its cap, or of the barrel for icing",
    ),
    lock: bool = ag.by("style", luer={True: 0.5, False: 0.5}, otherwise=False, doc="a collar about the tip"),
    capped: bool = ag.by(
        "style", luer={True: 0.6, False: 0.4}, oral={True: 0.7, False: 0.3}, otherwise=False
    ),
    force: ag.Float = ag.by(
        "style",
        icing=ag.uniform(6.0, 15.0),
        pen=ag.uniform(4.0, 9.0),
        glass=ag.uniform(2.0, 4.0),
        otherwise=ag.uniform(2.0, 10.0),
        unit="N",
        within=(1.0, 25.0),
        doc="force that moves a plunger or presses a button",
    ),
    grip: Literal["ring", "knob"] = ag.by("style", icing={"ring": 0.6, "knob": 0.4}, otherwise="knob"),
    finish: ag.Material = ag.by("style", _FINISHES),
    accent: ag.Material = _CAPS,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a syringe on a table, empty and closed."""
    if style == "pen":
        return _pen(require_size(length, (0.150, 0.185), "length of a pen"), force, finish, accent, maker)
    if style == "icing":
        long = require_size(length, (0.145, 0.205), "length of a barrel for icing")
        return _icing(long, force, finish, ring=grip == "ring")
    return _syringe(style, float(volume), force, finish, accent, maker, lock=lock, capped=capped)


_FACETS = ((24, 0.0095), (20, 0.0060), (16, 0.0036), (12, 0.0))  # of circles, with their least radius [m]
_SIDES = 16  # of the inside of a tube, each with a collider


def _circle(radius: float) -> ag.Profile:
    """Make a circle with so few sides that low detail has nearly the same mass."""
    return ag.regular_polygon(next(sides for sides, least in _FACETS if radius >= least), radius)


def _bored(outer: float, inner: float, x: tuple[ag.Scalar, ag.Scalar], *, sides: int = _SIDES) -> ag.Solid:
    """Make a tube along x with flat sides, clear of its inner radius."""
    long, middle = x[1] - x[0], (x[0] + x[1]) / 2
    hole = ag.extrude(ag.regular_polygon(sides, inner / math.cos(math.pi / sides)), long + 0.002, axis=ag.X)
    return (ag.extrude(_circle(outer), long, axis=ag.X) - hole).at(middle)


def _disc(radius: float, x: tuple[ag.Scalar, ag.Scalar], bevel: float = 0.0) -> ag.Solid:
    """Make a cylinder between two places along x."""
    return ag.extrude(_circle(radius), x[1] - x[0], axis=ag.X, bevel=bevel).at((x[0] + x[1]) / 2)


def _scale(volume: float, radius: float, stroke: float, start: float, end: float) -> ag.Body:
    """Print lines and numbers on a barrel, from its zero at `start`; it ends at `end` along x."""
    _, _, step, major = _SIZES[volume]
    film = 0.00016 if radius < 0.004 else 0.00005  # a decimal point has some volume
    tall = min(0.0030, 0.36 * radius, 0.62 * stroke * major / volume)
    marks = []
    for index in range(round(volume / step) + 1):
        amount = index * step
        numbered = abs(amount / major - round(amount / major)) < 1e-6
        y = end - start - stroke * amount / volume
        long = (0.80 if numbered else 0.45) * radius
        marks.append(
            ag.rectangle(long, 0.00032 if radius < 0.004 else 0.0004).at(long / 2 - 0.80 * radius, y)
        )
        if numbered and index:
            marks.append(ag.text(f"{amount:g}", tall, align="left").at(0.12 * radius, y - 0.36 * tall))
    unit = ag.text("ml", tall, align="left").at(0.12 * radius, end - start - stroke - 1.7 * tall)
    outline = ag.line((radius, 0, 0), (radius, 0, end))
    print_ = details.wrapped(reduce(or_, [*marks, unit]), outline, 0.0, material=_INK, proud=film)
    return print_.rotate(ag.Y, -math.pi / 2).rotate(ag.X, -0.95).at(end)


def _syringe(
    style: Style,
    volume: float,
    force: ag.Scalar,
    finish: ag.Material,
    accent: ag.Material,
    maker: str,
    *,
    lock: bool,
    capped: bool,
) -> ag.Body:
    """Make a barrel with its scale, tip and flange, its plunger and its cap; the bore begins at x = 0."""
    bore, wall, _, _ = _SIZES[volume]
    inner, outer = bore / 2000.0, bore / 2000.0 + wall / 1000.0
    stroke = 1e-6 * volume / (math.pi * inner**2)
    seal = max(0.004, 0.6 * inner) if style != "glass" else 0.004
    end = stroke + seal + 0.006
    glass = style == "glass"
    stuff = _GLASS if glass else _tinted(finish) if style == "oral" else _CLEAR
    tip = 0.0034 if style == "oral" else 0.0021
    cone = -_FRONT - 0.0104  # end of the tip [m]
    tips = [ag.hull(_disc(tip, (-_FRONT, 0.0004 - _FRONT)), _disc(0.92 * tip, (cone, cone + 0.0010)))]
    if volume > 2.0:
        tips.append(ag.frustum(0.75 * outer, 1.1 * tip, 0.0022, axis=-ag.X).at(-_FRONT - 0.0008))
    sides = _SIDES if volume > 2.0 else 8  # so that its colliders keep clear of the plunger
    hole = ag.regular_polygon(sides, inner / math.cos(math.pi / sides))
    wing, high = outer + (0.0075 if volume > 2.0 else 0.0050), outer + 0.0012
    plate = ag.rectangle(2 * wing, 2 * high, radius=0.9 * high) - hole
    flange = ag.extrude(plate, 0.0018, axis=ag.X).at(end - 0.0009)
    wall_solid = _bored(outer, inner, (0.0, end), sides=sides)
    front = _disc(outer, (-_FRONT, 0.0002), bevel=0.0003)
    parts = [
        ag.part(wall_solid | front, "barrel", stuff, name="barrel"),
        ag.part(flange, "flange", _STEEL if glass else stuff),
        ag.part(ag.union(*tips), "tip", finish if glass else stuff),
        _scale(volume, outer, stroke, 0.0004, end),
    ]
    if glass:
        collar = _bored(outer + 0.0007, outer - 0.0002, (-_FRONT, 0.0050))
        cap = _disc(outer + 0.0007, (-_FRONT - 0.0009, 0.0004 - _FRONT), bevel=0.0003)
        parts.append(ag.part(collar | cap, "ring", finish))
    if lock:
        parts.append(
            ag.part(_bored(0.0039, 0.0031, (-_FRONT - 0.0090, 0.0002 - _FRONT), sides=8), "tip", stuff)
        )
    body = ag.weld(*parts)
    plunger = _plunger(style, inner, seal, end, finish)
    slide = ag.Prismatic(
        "plunger_slide", axis=ag.X, limits=(0, stroke), friction=force,
        feel=feel.Feel(damping=12.0, armature=0.02, effort=40.0),
    )  # fmt: skip
    body = body.attach(plunger, slide)
    if capped:
        body = body.attach(
            _cap(0.0044 if lock or style == "oral" else 0.0034, accent), _draw("cap_slide", 0.016, 3.0)
        )
    return body.at((_FRONT + 0.0104 - end) / 2, 0, high)


def _tinted(finish: ag.Material) -> ag.Material:
    """Return the clear plastic of a barrel in a tint of the plunger."""
    color = tuple(0.45 * share + 0.50 for share in finish.base_color)
    return _CLEAR.with_(name=f"clear_{finish.name}", base_color=color, opacity=0.42)


def _draw(name: str, travel: float, force: ag.Scalar) -> ag.Joint:
    """Make the joint of a cap that is drawn off to the left."""
    return ag.Prismatic(name, axis=-ag.X, limits=(0, travel), friction=force, feel=_CAP)


def _cap(radius: float, finish: ag.Material) -> ag.Body:
    """Make a cap with ribs over a tip."""
    x = (-_FRONT - 0.0150, -_FRONT - 0.0020)
    shell = _disc(radius + 0.0011, (x[0], x[0] + 0.0016), bevel=0.0005)
    tube = _bored(radius + 0.0011, radius, (x[0] + 0.0014, x[1]), sides=8)
    bars = [
        ag.box(0.0095, 0.0007, 0.0007)
        .at((x[0] + x[1]) / 2, 0, radius + 0.0011)
        .rotate(ag.X, math.tau * step / 10)
        for step in range(10)
    ]
    # before the barrel: fingers are 20 mm wide
    at = (-_FRONT - 0.0125, 0, 0)
    hold = ag.grasp_on(tube, approach=-ag.Z, closing=ag.Y, at=at, depth=1.5 * radius)
    return ag.weld(
        ag.part(shell | tube, "cap", finish, name="cap", grasp=hold), ag.detail(bars, "cap", finish)
    )


def _plunger(style: Style, inner: float, seal: float, end: float, finish: ag.Material) -> ag.Body:
    """Make a plunger, pushed in: a stopper, a rod, and a disc for the thumb."""
    thumb = end + 0.0085
    radius = max(1.12 * inner, 0.0042)
    disc = _disc(radius, (thumb, thumb + 0.0026), bevel=0.0006)
    # behind the flange: fingers are 20 mm wide
    hold = ag.grasp_on(disc, approach=-ag.Z, closing=ag.Y, at=(thumb + 0.0092, 0, 0), depth=1.4 * radius)
    if style == "glass":
        rod = _disc(inner - _PLAY, (0.0004, thumb - 0.003), bevel=0.0003)
        neck = _disc(0.72 * inner, (thumb - 0.0032, thumb + 0.0005))
        return ag.part(ag.union(rod, neck, disc), "plunger", _FROSTED, name="plunger", grasp=hold)
    rubber = [
        _disc(inner - _PLAY, (0.0012, seal), bevel=0.0003),
        ag.frustum(inner - 0.0008, 0.25 * inner, 0.0010, axis=-ag.X).at(0.0009),
    ]
    groove = ag.tube(inner - _PLAY + 0.00005, inner - 0.0010, 0.30 * seal, axis=ag.X).at(0.55 * seal)
    wide, thin = 1.72 * (inner - _PLAY), max(0.0011, 0.16 * inner)
    start = seal - 0.0004
    blades = [
        ag.Region((start, thumb + 0.0004), (-y / 2, y / 2), (-z / 2, z / 2)).box()
        for y, z in ((wide, thin), (thin, wide))
    ]
    collars = [_disc(inner - _PLAY - 0.0001, (x, x + 0.0012)) for x in (start, end - 0.0022)]
    body = ag.part(ag.union(disc, *blades, *collars), "plunger", finish, name="plunger", grasp=hold)
    dark = _RUBBER.with_(name="groove", base_color=(0.01, 0.01, 0.01))
    return ag.weld(body, ag.part(rubber, "stopper", _RUBBER), ag.detail(groove, "stopper", dark))


def _pen(
    length: ag.Scalar, force: ag.Scalar, finish: ag.Material, accent: ag.Material, maker: str
) -> ag.Body:
    """Make a pen for insulin; its cartridge is at x < 0, its dial at the right."""
    radius, seam = 0.0084, 0.48 * length  # end of the body [m]
    cap_end = seam + 0.0160 - length
    bore, shaft = 0.0066, 0.0061
    shell = casting(finish, 0.45 if finish.density > 2000.0 else 0.75)
    hollow = _bored(radius, bore, (seam - 0.040, seam))
    solid = _disc(radius, (0.0, seam - 0.0398), bevel=0.0006)
    holder = _disc(0.0062, (cap_end + 0.018, 0.0005))
    hub = _disc(0.0046, (cap_end + 0.0105, cap_end + 0.0182))
    liquid = ag.detail(_disc(0.00635, (cap_end + 0.024, -0.008)), "window", _CLEAR)
    pane = ag.extrude(ag.rectangle(0.0100, 0.0046, radius=0.0012), 0.0008).at(
        seam - 0.010, 0, radius - 0.0002
    )
    digit = details.printed(
        ag.text("0", 0.0030), (seam - 0.010, 0, radius + 0.0002), material=_INK, facing=ag.Z, up=ag.Y
    )
    mark = details.logo(maker, ag.min_(0.0034, 0.030 / details.lettering_width(maker.upper(), 0.3)))
    name = details.printed(
        mark, (0.34 * seam, 0, radius), material=controls.ink_on(finish), facing=ag.Z, up=ag.Y
    )
    body = ag.weld(
        ag.part(solid | hollow, "barrel", shell, name="barrel"),
        ag.part([holder, hub], "cartridge", _GLASS.with_(name="cartridge", density=1600.0)),
        liquid, ag.detail(pane, "window", ag.material("glossy_plastic_white")), digit, name,
    )  # fmt: skip
    tube = _bored(radius + 0.0002, 0.0066, (cap_end + 0.0018, -0.0004))
    lid = _disc(radius + 0.0002, (cap_end, cap_end + 0.0020), bevel=0.0008)
    clip = ag.hull(
        ag.box(0.004, 0.0044, 0.0020).at(cap_end + 0.004, 0, radius + 0.0008),
        ag.box(0.003, 0.0034, 0.0012).at(cap_end + 0.040, 0, radius + 0.0012),
    )
    hold = ag.grasp_on(tube, approach=-ag.Z, closing=ag.Y, depth=1.5 * radius)
    cap = ag.part(ag.union(tube, lid, clip), "cap", shell, name="cap", grasp=hold)
    knob = _bored(0.0080, 0.0034, (seam + 0.0006, seam + 0.0130), sides=8)
    sleeve = _bored(shaft, 0.0034, (seam - 0.034, seam + 0.0010), sides=8)
    grooves = [
        ag.box(0.0090, 0.0008, 0.0008).at(seam + 0.0070, 0, 0.0080).rotate(ag.X, math.tau * step / 20)
        for step in range(20)
    ]
    grab = ag.grasp_on(knob, approach=-ag.Z, closing=ag.Y, at=(seam + 0.0115, 0, 0), depth=0.0110)
    white = ag.material("glossy_plastic_white").with_(name="dose_sleeve", density=950.0)
    dial = ag.weld(
        ag.part(knob, "dial", shell, name="dial", grasp=grab),
        ag.part(sleeve, "dial", white),
        ag.detail(grooves, "dial", shell),
    )
    top, stem = (
        _disc(0.0070, (seam + 0.0156, seam + 0.0182), bevel=0.0006),
        _disc(0.0030, (seam + 0.004, seam + 0.0160)),
    )
    button = ag.part(top | stem, "button", accent, name="button", push=ag.push_on(top, direction=-ag.X))
    spring = ag.Spring(preload=0.4 * force, force=force)
    dial = dial.attach(
        button, ag.Prismatic("button_slide", axis=-ag.X, limits=(0, 0.0020), spring=spring, feel=_PRESS)
    )
    turn = ag.Screw("dial_turn", pitch=0.0096, axis=ag.X, limits=(0, 2.5 * math.tau), feel=_DIAL)
    body = body.attach(dial, turn).attach(cap, _draw("cap_slide", 0.088, 6.0))
    return body.at(-(seam + cap_end + 0.0105) / 2, 0, (radius + 0.0002) * math.cos(math.pi / 20))


def _icing(length: ag.Scalar, force: ag.Scalar, finish: ag.Material, *, ring: bool) -> ag.Body:
    """Make a syringe for icing: a cylinder, a nozzle on a thread, a lid with wings, a piston."""
    inner, outer, end = 0.0205, 0.0218, length
    metal = finish.density > 2000.0
    shell = finish.with_(name=f"{finish.name}_tube", density=0.55 * finish.density) if metal else finish
    stuff = shell if metal else _CLEAR
    tube = _bored(outer, inner, (0.0, end))
    lid = _bored(outer + 0.0014, 0.0050, (end - 0.0002, end + 0.0035), sides=8)
    skirt = _bored(outer + 0.0014, outer - 0.0002, (end - 0.0120, end + 0.0002))
    wings = [
        ag.hull(
            ag.box(0.0035, 0.020, 0.024).at(end + 0.0016, side * 0.018, 0),
            ag.cylinder(0.0090, 0.0035, axis=ag.X).at(end + 0.0016, side * 0.036, 0),
        )
        for side in (-1, 1)
    ]
    marks = [ag.rectangle(0.012 if index % 2 else 0.018, 0.0006).at(0, -0.018 * index) for index in range(7)]
    lines = details.wrapped(
        reduce(or_, marks), ag.line((outer, 0, 0), (outer, 0, end)), 0.80 * end, material=_INK, proud=0.0001
    )
    body = ag.weld(
        ag.part(tube, "barrel", stuff, name="barrel"),
        ag.part([skirt, lid, *wings], "flange", finish if not metal else shell),
        lines.rotate(ag.Y, -math.pi / 2).rotate(ag.X, -0.95).at(end),
    )
    collar = _bored(outer + 0.0020, outer + _PLAY, (-0.0022, 0.0120))
    face = _bored(outer + 0.0020, 0.0070, (-0.0040, -0.0020), sides=8)
    cone = [_bored(radius, 0.0030, (x, x + 0.0092), sides=8) for radius, x in ((0.0095, -0.0125),)]
    tip = ag.frustum(0.0085, 0.0040, 0.026, axis=-ag.X).at(-0.0250)
    hold = ag.grasp_on(collar, approach=-ag.Z, closing=ag.Y, depth=0.024)
    ridges = [
        ag.box(0.0110, 0.0014, 0.0014).at(0.0050, 0, outer + 0.0020).rotate(ag.X, math.tau * step / 24)
        for step in range(24)
    ]
    nozzle = ag.weld(
        ag.part(collar | face, "cap", finish if not metal else shell, name="nozzle", grasp=hold),
        ag.part([*cone, tip], "nozzle", _STEEL.with_(name="nozzle_sheet", density=2200.0)),
        ag.detail(ridges, "cap", finish),
    )
    turn = ag.Screw("nozzle_turn", pitch=-0.0050, axis=ag.X, limits=(0, 1.5 * math.tau), feel=_NOZZLE)
    rod_end = end + 0.034
    rod = _disc(0.0046, (0.0110, rod_end))
    piston = [_disc(inner - 0.0004, (0.0010, 0.0050), bevel=0.0006), _disc(0.8 * inner, (0.0048, 0.0112))]
    if ring:
        handle = ag.torus(0.0150, 0.0042, axis=ag.Z).at(rod_end + 0.0150)
        grab = ag.frame((rod_end + 0.0150, 0, 0), approach=-ag.Z, closing=ag.Y)
    else:
        handle = ag.cylinder(0.0145, 0.0120, axis=ag.X, bevel=0.0030).at(rod_end + 0.0055)
        grab = ag.grasp_on(handle, approach=-ag.Z, closing=ag.Y, depth=0.018)
    plunger = ag.weld(
        ag.part(ag.union(rod, handle), "plunger", shell, name="plunger", grasp=grab),
        ag.part(piston, "stopper", ag.material("silicone")),
    )
    slide = ag.Prismatic(
        "plunger_slide", axis=ag.X, limits=(0, end - 0.020), friction=force,
        feel=feel.Feel(damping=20.0, armature=0.1, effort=60.0),
    )  # fmt: skip
    return body.attach(nozzle, turn).attach(plunger, slide).at(-end / 2, 0, outer + 0.0027)
