"""A USB stick on a desk: its plug turns out of a cover, slides out, or is under a cap or in a screwed tube.

Links: `cover` and `body` of a stick that turns; `body` and `plug` of those that slide; `body` and `cap` of
the others. Joints: `body_turn`; `plug_slide`; `cap_slide`, or `cap_turn` and its rise `cap_turn_rise`. At 0
the plug is covered.

Sticks lie with their plug to the right. A stick that turns has a cover of sheet around its plug, open at both
sides, and clicks at each quarter of a turn. A slider clicks in at both ends; that of a stick with two plugs
rests in the middle, and each plug comes out at its end. Friction holds a cap: it is drawn off all the way. A
thread ends after its turns.

Sizes are those of SanDisk, Kingston, Verbatim, Lexar and Corsair catalogs. The plug of type A has 12 by 4.5
mm (USB 2.0, figure 6-8), that of type C 8.3 by 2.5 mm and 6.6 mm (USB Type-C, figure 3-3). Sticks are 40-75
mm long, 17-21 mm wide and 8-11 mm thick, and weigh 7-20 g; rugged ones of aluminium are 76-88 mm long and
22-26 mm thick and weigh 30-60 g. Caps and sliders take 3-10 N.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, require_size
from artgen.categories.shared.finish import casting, colors, recess

Style = Literal["swivel", "slider", "dual", "cap", "rugged"]
"""A stick that turns in a cover, with a slider, with two plugs on it, with a cap, or in a screwed tube."""

_WIDE, _TALL, _LONG = 0.0120, 0.0045, 0.0125  # of a plug of type A [m]
_PLAY = 0.0005  # gap between parts that move [m]
_SHEET = 0.0008  # thickness of a cover [m]
_PIVOT = 0.0165  # from the rear end of a stick that turns to its pivot [m]
_STEEL = ag.material("stainless")
_SHELL = _STEEL.with_(name="plug_shell", specular_roughness=0.22)
_TONGUES = ag.choice(*colors("abs", "black white blue"), weights=(3, 2, 2))
_TURN = feel.Feel(friction=0.008, damping=0.002, armature=5e-6, effort=0.3)
_SLIDE = feel.Feel(friction=0.6, damping=4.0, armature=0.03, effort=25.0)
_CAP = feel.Feel(damping=6.0, armature=0.03, effort=40.0)
_THREAD = feel.Feel(friction=0.03, damping=0.004, armature=2e-4, effort=1.0)
_BODIES = ag.shades(*colors("abs", "black blue red white teal orange forest graphite"), color=0.04)
_FINISHES = {
    "swivel": _BODIES,
    "slider": _BODIES,
    "dual": ag.shades(*colors("glossy_plastic", "black white navy teal"), color=0.03),
    "cap": ag.shades(
        *colors("abs", "black white red blue sky"), "brushed_aluminium", "black_anodised", "walnut", "beech",
        color=0.04,
    ),
    "rugged": ag.shades(
        "black_anodised", "brushed_aluminium", *colors("powder_coat", "olive red"), color=0.03
    ),
}  # fmt: skip
_SPANS: dict[Style, tuple[float, float]] = {
    "swivel": (0.050, 0.080), "slider": (0.044, 0.070), "dual": (0.039, 0.060), "cap": (0.054, 0.090),
    "rugged": (0.072, 0.100),
}  # fmt: skip
"""Possible lengths by style [m]."""

_METALS = ag.choice("stainless", "brushed_aluminium", "chrome", "black_anodised", weights=(3, 2, 1, 1))
_SIZES = ag.choice("16 GB", "32 GB", "64 GB", "128 GB", "256 GB")


@ag.category(labels="body cover cap plug tongue slider rail loop ring seal print led", joints=(1, 2))
def usb_stick(
    *,
    style: Style = ag.choice({"swivel": 0.28, "slider": 0.22, "dual": 0.15, "cap": 0.22, "rugged": 0.13}),
    length: ag.Float = ag.by(
        "style",
        swivel=ag.uniform(0.056, 0.062),
        slider=ag.uniform(0.046, 0.056),
        dual=ag.uniform(0.040, 0.046),
        cap=ag.uniform(0.058, 0.074),
        rugged=ag.uniform(0.076, 0.088),
        unit="m",
        within=(0.036, 0.1),
        doc="length with the plug covered",
    ),
    width: ag.Float = ag.by(
        "style",
        rugged=ag.uniform(0.022, 0.026),
        otherwise=ag.uniform(0.0175, 0.0205),
        unit="m",
        within=(0.017, 0.03),
    ),
    height: ag.Float = ag.by(
        "style",
        swivel=ag.uniform(0.0098, 0.0112),
        otherwise=ag.uniform(0.0080, 0.0096),
        unit="m",
        within=(0.0078, 0.0125),
        doc="thickness; a rugged one is round",
    ),
    shape: Literal["square", "round"] = ag.choice("square", "round", doc="corners of a body"),
    force: ag.Float = ag.uniform(
        3.0, 10.0, "N", within=(1.5, 20.0), doc="force that moves a slider or a cap"
    ),
    click: ag.Float = ag.uniform(
        0.02, 0.04, "N m", within=(0.01, 0.08), doc="torque that turns a stick over"
    ),
    size: str = _SIZES,
    finish: ag.Material = ag.by("style", _FINISHES),
    metal: ag.Material = _METALS,
    tongue: ag.Material = _TONGUES,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a USB stick that lies on a desk, with its plug covered."""
    length = require_size(length, _SPANS[style], f"length of a {style} USB stick")
    corner = 0.0025 if shape == "square" else 0.0065
    match style:
        case "swivel":
            return _swivel(length, width, height, click, finish, metal, tongue, (maker, size))
        case "slider":
            return _slider(length, width, height, corner, force, finish, tongue, (maker, size))
        case "dual":
            return _dual(length, width, height, force, finish, metal, tongue, size)
        case "cap":
            return _capped(length, width, height, corner, force, finish, tongue, (maker, size))
    return _rugged(length, width / 2, finish, tongue, maker)


def _plug(x: ag.Scalar, z: ag.Scalar, tongue: ag.Material) -> list[ag.Body]:
    """Make a plug of type A that points to the right from a position."""
    room = ag.Region((x - 0.0020, x + _LONG), (-_WIDE / 2, _WIDE / 2), (z - _TALL / 2, z + _TALL / 2))
    hollow = room.shrink(0.0004, right=0).with_(x=(x + 0.0010, x + _LONG + 0.01)).box()
    inner = room.shrink(0.0003, right=0.0006, top=0.0026).box()
    marks = ag.rectangle(0.0020, 0.0022)
    windows = details.printed(
        marks.at(0, 0.0025) | marks.at(0, -0.0025), (x + 0.0062, 0, z + _TALL / 2), material=recess(_SHELL),
        facing=ag.Z, up=ag.Y,
    )  # fmt: skip
    pads = [
        ag.box(0.0060, 0.0011, 0.0002).at(x + _LONG - 0.0046, y, z - _TALL / 2 + 0.0019)
        for y in (-0.0035, -0.0011, 0.0011, 0.0035)
    ]
    return [
        ag.part(room.box() - hollow, "plug", _SHELL),
        ag.part(inner, "tongue", tongue),
        ag.detail(pads, "plug", ag.material("satin_brass")),
        windows,
    ]


def _small_plug(x: ag.Scalar, z: ag.Scalar) -> list[ag.Body]:
    """Make a plug of type C that points to the left from a position."""
    outline = ag.rectangle(0.0083, 0.0025, radius=0.0012)
    shell = ag.extrude(outline - ag.rectangle(0.0071, 0.0014, radius=0.0006), 0.0066, axis=ag.X).at(
        x - 0.0033, 0, z
    )
    root = ag.extrude(ag.rectangle(0.0081, 0.0023, radius=0.0011), 0.0018, axis=ag.X).at(x - 0.0001, 0, z)
    return [ag.part(shell, "plug", _SHELL), ag.part(root, "plug", _SHELL)]


def _words(text: tuple[str, str], at: ag.VectorLike, wide: ag.Scalar, face: ag.Material) -> ag.Body:
    """Print the maker and the size on the top of a stick."""
    maker, size = text
    high = ag.min_(0.0026, wide / details.lettering_width(maker.upper(), 0.3))
    lines = details.logo(maker, high).at(0, 0.0024) | details.lettering((size,), 0.9 * high).at(0, -0.0024)
    return details.printed(lines, at, material=controls.ink_on(face), facing=ag.Z, up=ag.Y)


def _bar(
    start: ag.Scalar,
    end: ag.Scalar,
    width: ag.Scalar,
    height: ag.Scalar,
    corner: float,
    bevel: float = 0.0008,
) -> ag.Solid:
    """Make a flat bar on the table between two positions, with round corners seen from above."""
    outline = ag.rectangle(end - start, width, radius=corner).at((start + end) / 2)
    return ag.extrude(outline, height, bevel=bevel).at(z=height / 2)


def _swivel(
    length: ag.Scalar,
    width: ag.Scalar,
    height: ag.Scalar,
    click: ag.Scalar,
    finish: ag.Material,
    metal: ag.Material,
    tongue: ag.Material,
    words: tuple[str, str],
) -> ag.Body:
    """Make a stick that turns in its cover; the pivot is at the origin."""
    front = length - _PIVOT  # of the cover [m]
    broad = width - 0.0016
    mid, end = height / 2, front - _SHEET - 0.0012
    low, high = _SHEET + _PLAY, height - _SHEET - _PLAY
    plug = end - _LONG
    plan = ag.rectangle(front, broad).at(front / 2) | ag.circle(broad / 2)
    plates = [ag.extrude(plan, _SHEET).at(z=z) for z in (_SHEET / 2, height - _SHEET / 2)]
    wall = ag.Region((front - _SHEET, front), (-broad / 2, broad / 2), (0, height)).box()
    axle = ag.cylinder(0.0024, height - 0.0002).at(z=mid)
    rivet = ag.tube(0.0042, 0.0026, 0.0006, bevel=0.0002).at(z=height + 0.0001)
    cover = ag.weld(
        ag.part(
            [*plates, wall], "cover", casting(metal, 0.65 if metal.density > 5000.0 else 1.0), name="cover"
        ),
        ag.part(axle, "ring", metal),
        ag.detail(rivet, "ring", metal),
        details.engraved(
            _fitted(words, 0.0038, front - 0.022),
            (front / 2 + 0.004, 0, height),
            material=metal,
            facing=ag.Z,
            up=ag.Y,
        ),
    )
    outline = ag.rectangle(plug + _PIVOT, width, radius=0.0030).at((plug - _PIVOT) / 2)
    bore = ag.regular_polygon(8, 0.0024 + 0.0006)
    eye = ag.rectangle(0.0024, 0.0080, radius=0.0010).at(-_PIVOT + 0.0030)
    case = ag.extrude(outline - bore - eye, high - low, bevel=0.0006).at(z=mid)
    hold = ag.grasp_on(case, approach=-ag.Z, closing=ag.Y, at=(-0.0205, 0, mid), depth=0.0072)
    touch = ag.push_on(case, direction=-ag.Y, at=(-0.0110, 0, mid))
    body = ag.weld(
        ag.part(case, "body", casting(finish, 0.95), name="body", grasp=hold, push=touch),
        *_plug(plug, mid, tongue),
    )
    snap = feel.detents(tuple(quarter * math.pi / 2 for quarter in range(3)), click)
    turn = ag.Revolute("body_turn", axis=ag.Z, limits=(0, math.pi), detents=snap, feel=_TURN)
    return cover.attach(body, turn).at(-(front - broad / 2) / 2)


def _fitted(words: tuple[str, str], tall: float, wide: ag.Scalar) -> ag.Profile:
    """Make the name of the maker within a height and a width."""
    maker, _ = words
    return details.logo(maker, ag.min_(tall, wide / details.lettering_width(maker.upper(), 0.3)))


def _thumb(
    x: ag.Scalar, top: ag.Scalar, finish: ag.Material, hold_depth: float
) -> tuple[list[ag.Solid], ag.Frame, ag.Body]:
    """Make a thumb slider on top of a stick with its stem, its grasp and its ribs."""
    pad = ag.Region((x - 0.0060, x + 0.0060), (-0.0045, 0.0045), (top + 0.0003, top + 0.0034))
    stem = ag.Region((x - 0.0035, x + 0.0035), (-0.0022, 0.0022), (top - 0.0030, top + 0.0010)).box()
    ribs = [
        ag.box(0.0008, 0.0080, 0.0006).at(x + (number - 1.5) * 0.0024, 0, top + 0.0035) for number in range(4)
    ]
    hold = ag.grasp_on(pad.box(), approach=-ag.Z, closing=ag.Y, depth=hold_depth)
    return [pad.box(bevel=0.0008), stem], hold, ag.detail(ribs, "slider", finish)


def _slider(
    length: ag.Scalar,
    width: ag.Scalar,
    height: ag.Scalar,
    corner: float,
    force: ag.Scalar,
    finish: ag.Material,
    tongue: ag.Material,
    words: tuple[str, str],
) -> ag.Body:
    """Make a stick whose plug a thumb slides out of its case."""
    half, travel, mid = length / 2, 0.0135, height / 2
    case = _bar(-half, half, width, height, corner)
    carriage = ag.Region(
        (half - 0.0330, half - _LONG - 0.0016), (-0.0062, 0.0062), (mid - 0.0021, mid + 0.0021)
    )
    room = ag.Region(
        (half - 0.0345, half + 0.01),
        (-_WIDE / 2 - 0.0006, _WIDE / 2 + 0.0006),
        (mid - _TALL / 2 - 0.0005, mid + _TALL / 2 + 0.0005),
    )
    x = half - 0.0250
    slit = ag.Region((x - 0.0042, x + travel + 0.0042), (-0.0028, 0.0028), (mid, height + 0.01))
    solids, hold, ribs = _thumb(x, height, finish, 0.0026)
    light = casting(finish, 1.1)
    side = ag.Region(
        (-half + 0.0035 + corner, half - 0.0035 - corner),
        (-width / 2 - 0.0002, width / 2 + 0.0002),
        (mid - 0.0004, mid + 0.0004),
    )
    seam = side.box() - side.shrink(y=0.0006).grow(x=0.01).box()
    body = ag.weld(
        ag.part(case - room.box() - slit.box(), "body", light, name="body"),
        ag.detail(seam, "rail", recess(finish)),
        _words(words, (-0.0148, 0, height), 2 * half - 0.0365, finish),
    )
    moving = ag.weld(
        ag.part(solids, "slider", tongue.with_(name=f"{tongue.name}_slider"), name="plug", grasp=hold),
        ag.part(carriage.box(), "body", casting(ag.material("black_abs"), 1.2)),
        *_plug(half - _LONG - 0.0010, mid, tongue),
        ribs,
    )
    snap = feel.detents((-0.0015, travel + 0.0025), force)
    slide = ag.Prismatic("plug_slide", axis=ag.X, limits=(0, travel), detents=snap, feel=_SLIDE)
    return body.attach(moving, slide)


def _dual(
    length: ag.Scalar,
    width: ag.Scalar,
    height: ag.Scalar,
    force: ag.Scalar,
    finish: ag.Material,
    metal: ag.Material,
    tongue: ag.Material,
    size: str,
) -> ag.Body:
    """Make a stick with a plug of type A at the right and one of type C at the left, on one slider."""
    half, mid = length / 2, height / 2
    out, back = 0.0125, 0.0070  # travel to both sides [m]
    case = _bar(-half, half, width, height, 0.0030, 0.0010)
    room = ag.Region(
        (-half - 0.01, half + 0.01),
        (-_WIDE / 2 - 0.0006, _WIDE / 2 + 0.0006),
        (mid - _TALL / 2 - 0.0005, mid + _TALL / 2 + 0.0005),
    )
    slit = ag.Region((-back - 0.0042, out + 0.0042), (-0.0028, 0.0028), (mid, height + 0.01))
    solids, hold, ribs = _thumb(0.0, height, finish, 0.0026)
    plate = ag.Region(
        (-half + 0.0030, -back - 0.0075),
        (-width / 2 + 0.003, width / 2 - 0.003),
        (height - 0.0004, height + 0.0002),
    )
    body = ag.weld(
        ag.part(case - room.box() - slit.box(), "body", casting(finish, 1.1), name="body"),
        ag.detail(plate.box(), "cover", metal),
        details.printed(
            details.lettering((size,), 0.0022), (0, -width / 2, mid), material=controls.ink_on(finish)
        ),
    )
    plug = half - _LONG - 0.0010
    rear = -half + 0.0066 + 0.0010
    board = ag.Region((rear - 0.0008, plug - 0.0006), (-0.0056, 0.0056), (mid - 0.0020, mid + 0.0020)).box()
    moving = ag.weld(
        ag.part(solids, "slider", metal, name="plug", grasp=hold),
        ag.part(board, "body", casting(ag.material("black_abs"), 1.2)),
        *_plug(plug, mid, tongue),
        *_small_plug(rear, mid),
        ribs,
    )
    snap = feel.detents((-back, 0.0, out), force)
    slide = ag.Prismatic("plug_slide", axis=ag.X, limits=(-back, out), detents=snap, feel=_SLIDE)
    return body.attach(moving, slide)


def _capped(
    length: ag.Scalar,
    width: ag.Scalar,
    height: ag.Scalar,
    corner: float,
    force: ag.Scalar,
    finish: ag.Material,
    tongue: ag.Material,
    words: tuple[str, str],
) -> ag.Body:
    """Make a stick with a cap over its plug."""
    half, mid = length / 2, height / 2
    seam = half - 0.0190  # between body and cap [m]
    whole = _bar(-half, half, width, height, corner)
    case = whole.split(point=(seam, 0, 0), normal=-ag.X)
    cover = whole.split(point=(seam + 0.0003, 0, 0), normal=ag.X)
    room = ag.Region(
        (seam - 0.001, seam + _LONG + 0.0020),
        (-_WIDE / 2 - 0.0005, _WIDE / 2 + 0.0005),
        (mid - _TALL / 2 - 0.0005, mid + _TALL / 2 + 0.0005),
    )
    metal = finish.density > 2000.0
    stuff = casting(finish, 0.5 if metal else 1.2)
    eye = ag.extrude(ag.rectangle(0.0022, 0.0070, radius=0.0010).at(-half + 0.0036), 0.05)
    lamp = ag.cylinder(0.0009, 0.0004).at(-half + 0.0090, 0, height)
    body = ag.weld(
        ag.part(case - eye, "body", stuff, name="body"),
        *_plug(seam, mid, tongue),
        ag.detail(lamp, "led", ag.material("led_green")),
        _words(words, ((seam - half) / 2 + 0.004, 0, height), seam + half - 0.017, finish),
    )
    hold = ag.grasp_on(cover, approach=-ag.Z, closing=ag.Y, at=(half - 0.0078, 0, mid), depth=0.85 * height)
    grooves = [
        ag.box(0.0008, 0.60 * width, 0.0003).at(half - 0.0060 - 0.0022 * number, 0, height)
        for number in range(4)
    ]
    cap = ag.weld(
        ag.part(cover - room.box(), "cap", casting(finish, 0.6) if metal else finish, name="cap", grasp=hold),
        ag.detail(grooves, "cap", recess(finish)),
    )
    slide = ag.Prismatic("cap_slide", axis=ag.X, limits=(0, 0.030), friction=force, feel=_CAP)
    return body.attach(cap, slide).at((half - seam - _LONG) / 2)


def _rugged(
    length: ag.Scalar, radius: ag.Scalar, finish: ag.Material, tongue: ag.Material, maker: str
) -> ag.Body:
    """Make a stick in a tube of aluminium: its end is screwed into the tube with a seal."""
    half = length / 2
    seam = -half + 0.0240  # between the end and the tube [m]
    sheet = finish.with_(name=f"{finish.name}_tube", density=2000.0)
    end = ag.cylinder(radius, seam + half, axis=ag.X, bevel=0.0010).at((seam - half) / 2)
    core = ag.cylinder(0.72 * radius, 0.0160, axis=ag.X).at(seam + 0.0070)
    seal = ag.torus(0.71 * radius, 0.0006, axis=ag.X).at(seam + 0.0040)
    bands = [ag.tube(radius + 0.0006, radius - 0.001, 0.0034, axis=ag.X, bevel=0.0005).at(x)
             for x in (-half + 0.0060, seam - 0.0060)]  # fmt: skip
    rubber = ag.material("rubber")
    body = ag.weld(
        ag.part(end, "body", sheet, name="body"),
        ag.part(core, "body", casting(ag.material("black_abs"), 1.2)),
        ag.detail(seal, "seal", rubber),
        ag.detail(bands, "ring", rubber),
        *_plug(seam + 0.0148, 0, tongue),
    )
    tube = ag.cylinder(radius, half - seam - 0.0006, axis=ag.X, bevel=0.0010).at((half + seam + 0.0006) / 2)
    room = ag.extrude(ag.regular_polygon(16, 0.80 * radius), half - seam - 0.0040, axis=ag.X)
    tube -= room.at((half - 0.0040 + seam) / 2 - 0.0004)
    hold = ag.grasp_on(tube, approach=-ag.Z, closing=ag.Y, at=(half - 0.016, 0, 0), depth=1.7 * radius)
    rings = [
        ag.tube(radius + 0.0006, radius - 0.001, 0.0034, axis=ag.X, bevel=0.0005).at(half - x)
        for x in (0.006, 0.012)
    ]
    wide = details.lettering_width(maker.upper(), 0.3)
    mark = details.logo(maker, min(0.0034, 0.030 / wide))
    cap = ag.weld(
        ag.part(tube, "cap", sheet, name="cap", grasp=hold),
        ag.detail(rings, "ring", rubber),
        details.printed(
            mark, ((half + seam) / 2 - 0.006, -0.5 * radius, 0.86 * radius), material=controls.ink_on(finish),
            facing=ag.vector(0, -0.5, 0.866), up=ag.vector(0, 0.866, 0.5),
        ),
    )  # fmt: skip
    turn = ag.Screw("cap_turn", pitch=0.0020, axis=ag.X, limits=(0, 3.0 * math.tau), feel=_THREAD)
    return body.attach(cap, turn).at(half - (seam + 0.0273 + half) / 2, 0, radius + 0.0006)
