"""A pen on a desk: with a button, that twists, with six sides, a marker, a highlighter, or a fountain pen.

Links: `barrel`; `button` with the refill of a click pen; `top` and `refill` of a twist pen; `cap` of the
others. Joints: `button_slide`; `top_turn` and `refill_slide`, which follows it; `cap_slide`, or `cap_turn` of
a fountain pen with a thread and its rise, `cap_turn_rise`. At 0 points are inside and caps are on.

Pens lie with their points to the right. A spring returns the button, which carries the refill: the cam that
holds a real one out at every second stroke is left out. A twist pen stops at both ends, where it snaps.
Friction holds a cap: it is drawn off all the way. A thread ends after its turns.

Sizes are those of BIC, Parker, Lamy, Pilot, edding and STABILO catalogs. Click pens are 136-146 mm long and
9.8-12 mm thick, 7-14 g of plastic and 15-30 g of metal; twist pens 128-140 mm and 18-40 g. Hexagonal pens
have 8.3 mm, 149 mm with the cap and 5-7 g; markers 130-142 mm, 15-18 mm and 12-26 g; flat highlighters
104-112 by 25-27 by 16-17 mm and 17-30 g; fountain pens 130-142 mm, 12-14 mm and 11-30 g. Buttons take 4-8 N
over 5.5 mm, caps 4-15 N, a twist 0.02-0.05 N m.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, require_size
from artgen.categories.shared.finish import casting, colors

Style = Literal["click", "twist", "hexagonal", "marker", "highlighter", "fountain"]
"""A pen with a button, that twists, clear with six sides, a marker, a flat highlighter, a fountain pen."""

_PLAY = 0.0004  # gap between a cap and a barrel, or a refill and its bore [m]
_TRAVEL = 0.0055  # of a button and a refill [m]
_TURN = 2.1  # of a twist pen [rad]
_STEEL = ag.material("stainless")
_BRASS = ag.material("brass")
_CLEAR = ag.material("polycarbonate").with_(name="clear_barrel", opacity=0.30)
_FELT = ag.material("fabric").with_(name="felt_nib", texture="", density=400.0)
_PRESS = feel.Feel(friction=0.2, damping=3.0, armature=0.03, effort=20.0)
_CAP = feel.Feel(damping=6.0, armature=0.03, effort=40.0)
_TWIST = feel.Feel(friction=0.003, damping=0.002, armature=1e-5, effort=0.3)
_THREAD = feel.Feel(friction=0.01, damping=0.004, armature=2e-4, effort=1.0)

_INKS = {"blue": (0.012, 0.035, 0.26), "black": (0.012, 0.012, 0.014), "red": (0.42, 0.012, 0.016),
         "green": (0.01, 0.17, 0.055)}  # fmt: skip
_FLUORESCENT = {"yellow": (0.86, 0.82, 0.02), "pink": (0.86, 0.10, 0.32), "green": (0.20, 0.78, 0.09),
                "orange": (0.90, 0.30, 0.03), "blue": (0.03, 0.42, 0.80)}  # fmt: skip


def _plastic(name: str, color: tuple[float, float, float]) -> ag.Material:
    """Make a glossy plastic in the color of an ink."""
    return ag.material("glossy_plastic").with_(name=name, base_color=color, density=950.0)


_FINISHES = {
    "click": ag.shades(
        *colors("abs", "blue black white red graphite teal"), "stainless", "black_anodised", "aluminium",
        color=0.04,
    ),
    "twist": ag.shades(
        "chrome", "satin_nickel", "stainless",
        *colors("powder_coat", "black navy red burgundy white"), color=0.03,
    ),
    "hexagonal": ag.choice(*(_plastic(f"ink_{name}", color) for name, color in _INKS.items())),
    "marker": ag.choice(*(_plastic(f"ink_{name}", color) for name, color in _INKS.items())),
    "highlighter": ag.choice(*(_plastic(f"neon_{name}", color) for name, color in _FLUORESCENT.items())),
    "fountain": ag.shades(
        *colors("glossy_plastic", "black navy burgundy forest red yellow"), "brushed_aluminium", color=0.03
    ),
}  # fmt: skip


_SPANS: dict[Style, tuple[float, float]] = {
    "click": (0.0094, 0.0160), "twist": (0.0092, 0.0140), "hexagonal": (0.0080, 0.0086),
    "marker": (0.0140, 0.0220), "highlighter": (0.0230, 0.0300), "fountain": (0.0118, 0.0160),
}  # fmt: skip
"""Possible widths by style [m]."""


@ag.category(labels="barrel grip button refill tip top ring clip cap section nib plug print", joints=(1, 2))
def pen(
    *,
    style: Style = ag.choice(
        {
            "click": 0.24,
            "twist": 0.14,
            "hexagonal": 0.15,
            "marker": 0.17,
            "highlighter": 0.14,
            "fountain": 0.16,
        }
    ),
    length: ag.Float = ag.by(
        "style",
        click=ag.uniform(0.136, 0.146),
        twist=ag.uniform(0.128, 0.140),
        hexagonal=0.149,
        marker=ag.uniform(0.130, 0.142),
        highlighter=ag.uniform(0.104, 0.112),
        fountain=ag.uniform(0.130, 0.142),
        unit="m",
        within=(0.1, 0.16),
        doc="length with its point inside or its cap on",
    ),
    width: ag.Float = ag.by(
        "style",
        click=ag.uniform(0.0098, 0.0120),
        twist=ag.uniform(0.0096, 0.0116),
        hexagonal=0.0083,
        marker=ag.uniform(0.0150, 0.0180),
        highlighter=ag.uniform(0.0250, 0.0270),
        fountain=ag.uniform(0.0122, 0.0138),
        unit="m",
        within=(0.008, 0.03),
        doc="largest thickness without the clip",
    ),
    thread: bool = ag.by(
        "style", fountain={True: 0.4, False: 0.6}, otherwise=False, doc="a cap with a thread"
    ),
    soft: bool = ag.by("style", click={True: 0.5, False: 0.5}, otherwise=False, doc="a soft grip"),
    force: ag.Float = ag.by(
        "style",
        click=ag.uniform(4.0, 8.0),
        marker=ag.uniform(6.0, 15.0),
        otherwise=ag.uniform(4.0, 10.0),
        unit="N",
        within=(2.0, 25.0),
        doc="force that presses a button or draws off a cap",
    ),
    torque: ag.Float = ag.uniform(0.02, 0.05, "N m", doc="torque that twists a pen"),
    finish: ag.Material = ag.by("style", _FINISHES),
    trim: ag.Material = ag.choice({"chrome": 3.0, "brass": 1.0, "black_steel": 1.0}, doc="clip and rings"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a pen that lies on a desk, closed."""
    width = require_size(width, _SPANS[style], f"width of a {style} pen")
    match style:
        case "click":
            return _click(length, width / 2, force, finish, trim, maker, soft=soft)
        case "twist":
            return _twist(length, width / 2, torque, finish, trim, maker)
        case "hexagonal":
            return _hexagonal(length, width / 2, force, finish)
        case "marker":
            return _marker(length, width / 2, force, finish, maker)
        case "highlighter":
            return _highlighter(length, width, force, finish, maker)
    return _fountain(length, width / 2, force, finish, trim, maker, thread=thread)


def _turned(*line: tuple[ag.Scalar, ag.Scalar], bore: Sequence[tuple[ag.Scalar, float]] = ()) -> ag.Solid:
    """Make a body turned about x from pairs (x, radius), with bores from (x, radius) to the next x."""
    outside = ((radius, x) for x, radius in line)
    made = ag.revolve(ag.polygon([(0, line[0][0]), *outside, (0, line[-1][0])]), axis=ag.X)
    for (start, radius), (end, _) in pairwise(bore):
        hole = ag.extrude(ag.regular_polygon(12, radius / math.cos(math.pi / 12)), end - start, axis=ag.X)
        made -= hole.at((start + end) / 2)
    return made


def _ring(x: ag.Scalar, radius: ag.Scalar, wide: float, finish: ag.Material, label: str = "ring") -> ag.Body:
    """Make a visible ring around a barrel."""
    return ag.detail(ag.tube(radius, radius - 0.0012, wide, axis=ag.X, bevel=0.0002).at(x), label, finish)


def _clip(start: ag.Scalar, end: ag.Scalar, radius: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a clip above a barrel, fixed at its start, along x."""
    way = ag.switch(end > start, 1.0, -1.0)
    foot = ag.box(0.0050, 0.0030, 0.0030, bevel=0.0004).at(start + 0.0025 * way, 0, radius + 0.0006)
    bar = ag.hull(
        ag.box(0.0020, 0.0032, 0.0008).at(start + 0.0012 * way, 0, radius + 0.0017),
        ag.box(0.0020, 0.0022, 0.0008).at(end - 0.0016 * way, 0, radius + 0.0013),
    )
    ball = ag.ellipsoid(0.0022, 0.0013, 0.0009).at(end - 0.0026 * way, 0, radius + 0.0008)
    return ag.part([foot, bar, ball], "clip", finish)


def _hold(x: ag.Scalar, radius: ag.Scalar, solid: ag.Solid) -> ag.Frame:
    """Return the grasp from above around a round part."""
    return ag.grasp_on(solid, approach=-ag.Z, closing=ag.Y, at=(x, 0, 0), depth=1.7 * radius)


def _print(maker: str, x: ag.Scalar, radius: ag.Scalar, tall: float, face: ag.Material) -> ag.Body:
    """Print the name of the maker on the front of a barrel."""
    mark = details.logo(maker, tall)
    return details.printed(
        mark, (x, -radius * 0.86, radius * 0.5), material=controls.ink_on(face),
        facing=ag.vector(0, -0.866, 0.5), up=ag.vector(0, 0.5, 0.866),
    )  # fmt: skip


def _click(
    length: ag.Scalar,
    radius: ag.Scalar,
    force: ag.Scalar,
    finish: ag.Material,
    trim: ag.Material,
    maker: str,
    *,
    soft: bool,
) -> ag.Body:
    """Make a click pen: its button carries the refill through the barrel."""
    front, rear = length / 2, -length / 2 + 0.0105  # of the barrel [m]
    cone = front - 0.020
    metal = finish.density > 2000.0
    wall = 0.0008 if metal else 0.0014
    outer = [
        (rear, radius - 0.0012),
        (rear + 0.002, radius - 0.0004),
        (rear + 0.05, radius),
        (cone, 0.95 * radius),
    ]
    barrel = _turned(*outer, bore=[(rear - 0.001, 0.0034), (cone + 0.001, 0.0)])
    tip = _turned(
        (cone, 0.95 * radius), (cone + 0.010, 0.66 * radius), (front, 0.0021),
        bore=[(cone - 0.001, 0.0026), (front - 0.008, 0.0014), (front + 0.001, 0.0)],
    )  # fmt: skip
    density = wall / 0.0018 * finish.density if metal else 1.05 * finish.density
    stuff = finish.with_(name=f"{finish.name}_barrel", density=density)
    body = ag.weld(
        ag.part(barrel, "barrel", stuff, name="barrel"),
        ag.part(tip, "tip", casting(trim, 0.35)),
        _clip(rear + 0.003, rear + 0.042, radius - 0.0002, trim),
        _ring(rear + 0.0012, radius - 0.0004, 0.0024, trim),
        _ring(length * 0.02, radius + 0.0002, 0.0016, trim),
        _print(maker, -0.10 * length, radius, 0.0022, finish),
    )
    if soft:
        rubber = ag.colored("rubber", "graphite") if not metal else ag.material("rubber")
        rings = [ag.torus(radius - 0.0001, 0.0007, axis=ag.X).at(cone - 0.004 - 0.0032 * n) for n in range(9)]
        sleeve = ag.tube(radius + 0.0004, radius - 0.0012, 0.032, axis=ag.X, bevel=0.0003).at(cone - 0.0165)
        body = ag.weld(body, ag.detail([sleeve, *rings], "grip", rubber))
    start, point = -length / 2, front - 0.0008
    key = ag.cylinder(0.0029, 0.0160, axis=ag.X, bevel=0.0006).at(start + 0.0080)
    shaft = ag.cylinder_between((start + 0.015, 0, 0), (front - 0.014, 0, 0), 0.0016)
    needle = ag.cylinder_between((front - 0.0145, 0, 0), (point - 0.0014, 0, 0), 0.0009)
    ball = ag.frustum(0.0009, 0.0003, 0.0016, axis=ag.X).at(point - 0.0008)
    touch = ag.push_on(key, direction=ag.X)
    button = ag.weld(
        ag.part(
            key, "button", trim.with_(name=f"{trim.name}_button", density=1400.0), name="button", push=touch
        ),
        ag.part(shaft, "refill", _plastic("refill", (0.6, 0.6, 0.6))),
        ag.part([needle, ball], "refill", _BRASS),
    )
    spring = ag.Spring(preload=0.35 * force, force=force)
    slide = ag.Prismatic("button_slide", axis=ag.X, limits=(0, _TRAVEL), spring=spring, feel=_PRESS)
    return body.attach(button, slide).at(-0.0052, 0, radius + (0.0006 if soft else 0.0002))


def _twist(
    length: ag.Scalar,
    radius: ag.Scalar,
    torque: ag.Scalar,
    finish: ag.Material,
    trim: ag.Material,
    maker: str,
) -> ag.Body:
    """Make a twist pen: its upper barrel at the left drives the refill."""
    front, rear, joint = length / 2, -length / 2, -0.002
    cone = front - 0.026
    lower = [
        _turned((joint, radius), (cone, 0.90 * radius), bore=[(joint - 0.001, 0.0021), (cone + 0.001, 0.0)]),
        _turned(
            (cone, 0.90 * radius),
            (front - 0.006, 0.52 * radius),
            bore=[(cone - 0.001, 0.0021), (front - 0.005, 0.0)],
        ),
    ]
    end = _turned(
        (front - 0.006, 0.52 * radius), (front, 0.0019), bore=[(front - 0.007, 0.0014), (front + 0.001, 0.0)]
    )
    sheet = casting(finish.with_(density=8500.0), 0.30)
    body = ag.weld(
        ag.part(lower, "barrel", sheet, name="barrel"),
        ag.part(end, "tip", sheet),
        _ring(joint + 0.0020, radius + 0.0003, 0.0040, trim),
        _ring(front - 0.0055, 0.52 * radius + 0.0006, 0.0014, trim),
    )
    upper = _turned((rear + 0.003, 0.62 * radius), (rear + 0.012, 0.88 * radius), (joint - _PLAY, radius))
    knob = ag.cylinder(0.55 * radius, 0.0040, axis=ag.X, bevel=0.0008).at(rear + 0.0020)
    hold = _hold(rear + 0.034, 0.94 * radius, upper)
    top = ag.weld(
        ag.part(upper, "top", sheet, name="top", grasp=hold),
        ag.part(knob, "top", trim),
        _clip(rear + 0.007, rear + 0.044, 0.96 * radius, trim),
        _print(maker, -0.014, radius, 0.0019, finish),
    )
    snap = feel.detents((-0.50, _TURN + 0.70), torque)
    turn = ag.Revolute("top_turn", axis=ag.X, limits=(0, _TURN), detents=snap, feel=_TWIST)
    point = front - 0.0008
    shaft = ag.cylinder_between((joint + 0.002, 0, 0), (front - 0.0135, 0, 0), 0.0016)
    needle = ag.cylinder_between((front - 0.0140, 0, 0), (point - 0.0014, 0, 0), 0.0009)
    ball = ag.frustum(0.0009, 0.0003, 0.0016, axis=ag.X).at(point - 0.0008)
    refill = ag.weld(
        ag.part(shaft, "refill", casting(_BRASS, 0.4), name="refill"),
        ag.part([needle, ball], "refill", _BRASS),
    )
    slide = ag.Prismatic("refill_slide", axis=ag.X, follows=_TRAVEL / _TURN * turn, armature=0.002)
    return body.attach(top, turn).attach(refill, slide).at(-(joint + front) / 2, 0, radius + 0.0003)


def _drawn(force: ag.Scalar, travel: ag.Scalar) -> ag.Joint:
    """Make the joint of a cap that is drawn off to the right."""
    return ag.Prismatic("cap_slide", axis=ag.X, limits=(0, travel), friction=force, feel=_CAP)


def _hexagonal(length: ag.Scalar, radius: ag.Scalar, force: ag.Scalar, ink: ag.Material) -> ag.Body:
    """Make a clear pen with six sides, through which its ink is seen."""
    rear, front = -length / 2, length / 2
    neck = front - 0.032  # end of the hexagonal barrel [m]
    six = ag.regular_polygon(6, radius)
    barrel = ag.extrude(six, neck - rear - 0.003, axis=ag.X).at((neck + rear + 0.003) / 2)
    hollow = ag.extrude(ag.regular_polygon(6, 0.0026), 0.2, axis=ag.X).at(neck - 0.1 + 0.0002)
    cone = _turned((neck, 0.0034), (neck + 0.012, 0.0030), (neck + 0.019, 0.0012))
    point = ag.frustum(0.0011, 0.0004, 0.0040, axis=ag.X).at(neck + 0.0205)
    fill = ag.cylinder(0.0015, 0.7 * length, axis=ag.X).at(rear + 0.012 + 0.35 * length)
    straw = ag.tube(0.0019, 0.0014, neck - rear - 0.006, axis=ag.X).at((neck + rear) / 2 + 0.003)
    plug = ag.cylinder(0.0030, 0.0045, axis=ag.X, bevel=0.0005).at(rear + 0.0022)
    body = ag.weld(
        ag.part(barrel - hollow, "barrel", _CLEAR, name="barrel"),
        ag.part(cone, "tip", _plastic("tip_white", (0.75, 0.74, 0.70))),
        ag.part(point, "tip", _BRASS),
        ag.part(plug, "plug", ink),
        ag.part(straw, "refill", _CLEAR, separate="held by the tip and the plug"),
        ag.detail(fill, "refill", ink),
    )
    inner = 0.0039
    start = neck - 0.0150  # the cap reaches over the barrel [m]
    clear = ag.extrude(ag.regular_polygon(6, radius + 1.2 * _PLAY), 0.0168, axis=ag.X).at(start + 0.0073)
    cap = _turned((start, 0.0054), (front - 0.010, 0.0050), (front, 0.0036)) - clear
    cap -= ag.extrude(ag.regular_polygon(12, inner), 0.030, axis=ag.X).at(neck + 0.0120)
    bar = ag.hull(
        ag.box(0.0030, 0.0038, 0.0020).at(front - 0.0055, 0, 0.0060),
        ag.box(0.0020, 0.0028, 0.0012).at(start + 0.006, 0, 0.0066),
    )
    foot = ag.box(0.0060, 0.0038, 0.0030).at(front - 0.0065, 0, 0.0050)
    hold = _hold(front - 0.022, 0.0050, cap)
    lid = ag.weld(ag.part(cap, "cap", ink, name="cap", grasp=hold), ag.part([bar, foot], "clip", ink))
    return body.attach(lid, _drawn(force, 0.060)).at(0.0048, 0, 0.0054)


def _marker(length: ag.Scalar, radius: ag.Scalar, force: ag.Scalar, ink: ag.Material, maker: str) -> ag.Body:
    """Make a marker with a thick barrel and a cap in the color of its ink."""
    rear, front = -length / 2, length / 2
    seam = front - 0.050  # between barrel and cap [m]
    shell = ag.colored("abs", "light_grey") if ink.name != "ink_black" else ag.colored("abs", "graphite")
    barrel = _turned(
        (rear + 0.002, radius - 0.0012), (rear + 0.004, radius - 0.0003), (seam - 0.0006, radius)
    )
    plug = ag.cylinder(radius - 0.0020, 0.0060, axis=ag.X, bevel=0.0008).at(rear + 0.0030)
    neck = _turned(
        (seam - 0.0008, 0.76 * radius),
        (seam + 0.014, 0.74 * radius),
        (seam + 0.020, 0.42 * radius),
        (seam + 0.026, 0.38 * radius),
    )
    nib = ag.hull(
        ag.cylinder(0.0026, 0.004, axis=ag.X).at(seam + 0.0270),
        ag.box(0.0006, 0.0044, 0.0012).at(seam + 0.0345, 0, -0.0012),
    )
    light = casting(shell, 0.62)
    high = details.lettering_width(maker.upper(), 0.3)
    body = ag.weld(
        ag.part(barrel, "barrel", light, name="barrel"),
        ag.part(plug, "plug", casting(ink, 0.5)),
        ag.part(neck, "section", casting(shell, 0.5)),
        ag.part(nib, "nib", _FELT.with_(name="felt_inked", base_color=ink.base_color)),
        _ring(rear + 0.020, radius + 0.0002, 0.0060, ink, "print"),
        _print(maker, (rear + seam) / 2 + 0.006, radius, min(0.0046, 0.044 / high), shell),
    )
    cap = _turned((seam, radius), (front - 0.003, 0.92 * radius), (front, 0.80 * radius))
    cap -= ag.extrude(ag.regular_polygon(16, 0.82 * radius), 0.042, axis=ag.X).at(seam + 0.0205)
    ribs = [
        ag.torus(0.945 * radius, 0.0006, axis=ag.X).at(front - 0.0080 - 0.0024 * number)
        for number in range(5)
    ]
    hold = _hold(front - 0.024, 0.95 * radius, cap)
    lid = ag.weld(
        ag.part(cap, "cap", ink, name="cap", grasp=hold),
        ag.detail(ribs, "cap", ink),
        _clip(front - 0.004, front - 0.040, 0.97 * radius, ink),
    )
    return body.attach(lid, _drawn(force, 0.055)).at(0.0075, 0, radius + 0.0002)


def _highlighter(
    length: ag.Scalar, width: ag.Scalar, force: ag.Scalar, ink: ag.Material, maker: str
) -> ag.Body:
    """Make a flat highlighter: a dark cap on a body in the color of its ink."""
    rear, front, tall = -length / 2, length / 2, 0.63 * width
    seam = front - 0.036
    dark = ag.colored("abs", "anthracite")

    def flat(start: ag.Scalar, end: ag.Scalar, inset: float, bevel: float = 0.0) -> ag.Solid:
        """Make a bar with rounded edges between two positions."""
        outline = ag.rectangle(width - 2 * inset, tall - 2 * inset, radius=0.0050 - inset)
        return ag.extrude(outline, end - start, axis=ag.X, bevel=bevel).at((start + end) / 2)

    neck = ag.frustum(0.0056, 0.0040, 0.010, axis=ag.X).at(seam + 0.0145)
    nib = ag.hull(
        ag.box(0.002, 0.0050, 0.0044).at(seam + 0.0195),
        ag.box(0.001, 0.0050, 0.0010).at(seam + 0.0260, 0, -0.0014),
    )
    body = ag.weld(
        ag.part(flat(rear + 0.010, seam - 0.0004, 0.0), "barrel", casting(ink, 0.60), name="barrel"),
        ag.part(flat(rear, rear + 0.0102, 0.0004, 0.0016), "plug", casting(dark, 0.5)),
        ag.part(flat(seam - 0.001, seam + 0.010, 0.0026), "section", casting(dark, 0.55)),
        ag.part(neck, "section", casting(dark, 0.55)),
        ag.part(nib, "nib", _FELT.with_(name="felt_inked", base_color=ink.base_color)),
        details.printed(
            details.logo(maker, min(0.0062, 0.040 / details.lettering_width(maker.upper(), 0.3))),
            ((rear + seam) / 2 + 0.005, 0, tall / 2), material=controls.DARK_INK, facing=ag.Z, up=ag.Y,
        ),
    )  # fmt: skip
    room = ag.Region(
        (seam - 0.001, front - 0.0020),
        (-width / 2 + 0.0020, width / 2 - 0.0020),
        (-tall / 2 + 0.0020, tall / 2 - 0.0020),
    )
    cap = flat(seam, front, 0.0, 0.0014) - room.box()
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.Y, depth=0.85 * tall)
    bar = ag.Region(
        (seam + 0.004, front - 0.002), (-0.0030, 0.0030), (tall / 2 - 0.0004, tall / 2 + 0.0012)
    ).box(bevel=0.0005)
    lid = ag.weld(ag.part(cap, "cap", dark, name="cap", grasp=hold), ag.part(bar, "clip", dark))
    return body.attach(lid, _drawn(force, 0.045)).at(0.0048, 0, tall / 2)


def _fountain(
    length: ag.Scalar,
    radius: ag.Scalar,
    force: ag.Scalar,
    finish: ag.Material,
    trim: ag.Material,
    maker: str,
    *,
    thread: bool,
) -> ag.Body:
    """Make a fountain pen, whose cap is drawn off or screwed off."""
    rear, front = -length / 2, length / 2
    seam = front - 0.064  # between barrel and cap [m]
    metal = finish.density > 2000.0
    stuff = casting(finish, 0.55 if metal else 1.15)
    barrel = _turned((rear, 0.62 * radius), (rear + 0.004, 0.74 * radius), (seam, 0.93 * radius))
    section = _turned(
        (seam - 0.0004, 0.72 * radius),
        (seam + 0.008, 0.72 * radius),
        (seam + 0.020, 0.60 * radius),
        (seam + 0.024, 0.66 * radius),
    )
    feed = ag.frustum(0.0026, 0.0012, 0.016, axis=ag.X).at(seam + 0.031, 0, -0.0010)
    half = [(0.0, 0.0034), (0.008, 0.0036), (0.016, 0.0014), (0.0205, 0.0003)]
    outline = ag.polygon([*half, *((x, -y) for x, y in reversed(half))])
    leaf = ag.extrude(outline, 0.0006).at(seam + 0.0235, 0, 0.0016)
    slit = ag.box(0.012, 0.0002, 0.0002).at(seam + 0.0370, 0, 0.0019)
    hole = ag.cylinder(0.0006, 0.0002).at(seam + 0.0305, 0, 0.0019)
    gold = trim.with_(name=f"{trim.name}_nib")
    body = ag.weld(
        ag.part(barrel, "barrel", stuff, name="barrel"),
        ag.part(section, "section", ag.colored("glossy_plastic", "black")),
        ag.part(feed, "nib", ag.colored("abs", "black")),
        ag.part(leaf, "nib", gold),
        ag.detail([slit, hole], "nib", ag.colored("abs", "black")),
        _ring(seam - 0.0016, 0.93 * radius + 0.0002, 0.0014, trim),
        _ring(rear + 0.0050, 0.755 * radius + 0.0002, 0.0012, trim),
    )
    start = seam + 0.0004
    cap = _turned(
        (start, radius),
        (front - 0.006, 0.90 * radius),
        (front - 0.001, 0.66 * radius),
        (front, 0.50 * radius),
    )
    cap -= ag.extrude(ag.regular_polygon(16, 0.83 * radius), 0.050, axis=ag.X).at(seam + 0.0240)
    hold = _hold(front - 0.030, 0.94 * radius, cap)
    lid = ag.weld(
        ag.part(cap, "cap", stuff.with_(name=f"{finish.name}_cap"), name="cap", grasp=hold),
        _ring(start + 0.0030, radius + 0.0002, 0.0044, trim),
        _clip(front - 0.007, front - 0.048, 0.93 * radius, trim),
        _print(maker, start + 0.0190, radius, 0.0018, finish),
    )
    if not thread:
        return body.attach(lid, _drawn(force, 0.060)).at(0.0100, 0, radius + 0.0002)
    turn = ag.Screw("cap_turn", pitch=0.0024, axis=ag.X, limits=(0, 1.5 * math.tau), feel=_THREAD)
    return body.attach(lid, turn).at(0.0100, 0, radius + 0.0002)
