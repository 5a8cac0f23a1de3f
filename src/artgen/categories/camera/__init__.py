"""A camera: compact, reflex, for film, instant, or for a computer.

Links: `body`; `shutter`; `zoom_ring` or `focus_ring` with `barrel`; `mode_dial`, `flash`, `screen`;
`speed_dial`, `lever`, `rewind_knob`, `back`; `sleeve` and `barrel` of a compact camera; `flap` and `photo` of
an instant one; `clip`, `leg`, `neck`, `head` and `slider` of one for a computer; `button_0`, .... Joints:
`shutter_slide`; `zoom_ring_turn` or `focus_ring_turn`, `barrel_slide`; `mode_dial_turn`, `flash_hinge`,
`screen_hinge`; `speed_dial_turn`, `lever_turn`, `rewind_knob_turn`, `back_hinge`; `sleeve_slide`;
`flap_hinge`, `photo_slide`; `leg_hinge`, `neck_turn`, `head_tilt`, `slider_slide`; `button_slide_0`, ....

At 0 lenses are drawn in, flaps and backs are closed, and a slider leaves its lens free. The front of a lens
follows its ring or its sleeve. The lever that winds film springs back. Positive turns of rings and dials are
clockwise, seen from the front and from above.

Sizes are those of shops: compact cameras are 95-112 by 54-64 by 27-34 mm and weigh 0.12-0.30 kg, reflex
cameras 127-142 by 98-120 mm and 0.5-1.0 kg with a lens of 60-85 mm, cameras for film 131-152 by 88-100 mm and
0.45-0.95 kg, instant ones 106-122 by 110-127 by 85-110 mm and 0.3-0.7 kg, those for computers 78-98 mm wide
and 0.08-0.2 kg with their clip.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.camera import reflex as large
from artgen.categories.camera.reflex import disc, hollow
from artgen.categories.shared import controls, require_size
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT

Style = Literal["compact", "reflex", "film", "instant", "webcam"]
"""A camera for a pocket, one with a large lens and a prism, one for film, one that ejects its pictures,
or one on a clip above a screen."""

_BLACK = ag.material("black_abs")
_GLASS = ag.material("black_glass").with_(name="lens_glass", base_color=(0.012, 0.014, 0.035))
_FOCUS = ag.material("led_amber").with_(name="focus_lamp", emission=(0.0, 0.0, 0.0))
_FLASH = ag.material("frosted_glass").with_(name="flash_glass")
_MOTOR = feel.Feel(friction=0.5, damping=4.0, armature=0.02, effort=8.0)
_STIFF = feel.Feel(friction=0.05, damping=0.01, armature=5e-5, effort=2.0)
_SEES = ag.material("led_green").with_(name="led_recording")
_METALS = ("chrome", "brushed_aluminium", "black_anodised", "satin_nickel")
_FINISHES = ag.by(
    "style",
    compact=ag.shades(
        "brushed_aluminium",
        *colors("abs", "black graphite red navy white"),
        weights=(3, 3, 2, 1, 1, 1),
        color=0.03,
    ),
    reflex=ag.shades(*colors("abs", "black graphite"), weights=(4, 1), color=0.02),
    film=ag.shades(
        *colors("leather_grain_abs", "black graphite brown burgundy"), weights=(5, 1, 2, 1), color=0.03
    ),
    instant=ag.shades(
        *colors("abs", "white black sky blush sage mustard"), weights=(4, 2, 1, 1, 1, 1), color=0.03
    ),
    webcam=ag.shades(*colors("abs", "black graphite white"), weights=(4, 2, 1), color=0.02),
)

_WIDTHS = {
    "compact": (0.090, 0.13), "reflex": (0.122, 0.16), "film": (0.128, 0.16), "instant": (0.102, 0.14),
    "webcam": (0.076, 0.12),
}  # fmt: skip
_LENSES = {
    "compact": (0.0140, 0.0182), "reflex": (0.028, 0.0350), "film": (0.023, 0.0300),
    "instant": (0.018, 0.0240), "webcam": (0.009, 0.0120),
}  # fmt: skip
"""Widths, and radii of lenses, of products of a style [m]."""


@ag.category(
    labels="body cap grip lens mount ring glass shutter button bezel dial flash screen hinge eyepiece lever "
    "knob back tab flap photo slot neck clip foot slider stripe led print",
    joints=(3, 9),
)
def camera(
    *,
    style: Style = ag.choice({"compact": 0.26, "reflex": 0.26, "film": 0.2, "instant": 0.16, "webcam": 0.12}),
    width: ag.Float = ag.by(
        "style",
        compact=ag.uniform(0.095, 0.111),
        reflex=ag.uniform(0.127, 0.140),
        film=ag.uniform(0.131, 0.143),
        instant=ag.uniform(0.106, 0.122),
        webcam=ag.uniform(0.078, 0.098),
        unit="m",
        within=(0.06, 0.18),
    ),
    lens: ag.Float = ag.by(
        "style",
        compact=ag.uniform(0.0155, 0.0178),
        reflex=ag.uniform(0.030, 0.0345),
        film=ag.uniform(0.026, 0.0295),
        instant=ag.uniform(0.020, 0.0235),
        webcam=ag.uniform(0.0095, 0.0115),
        unit="m",
        within=(0.009, 0.045),
        doc="radius of the lens",
    ),
    length: ag.Float = ag.by(
        "style",
        reflex=ag.uniform(0.060, 0.085),
        film=ag.uniform(0.040, 0.050),
        otherwise=0.02,
        unit="m",
        within=(0.015, 0.12),
        doc="length of a lens with a ring",
    ),
    popup: bool = ag.by("style", reflex={True: 0.6, False: 0.4}, otherwise=False, doc="flash that stands up"),
    swings: bool = ag.by(
        "style", reflex={True: 0.6, False: 0.4}, otherwise=False, doc="screen that swings out"
    ),
    keys: int = ag.by(
        "style", compact=ag.count(2, 3), reflex=ag.count(2, 3), otherwise=0, doc="keys at the back"
    ),
    stripes: Literal["rainbow", "none", "line"] = ag.by(
        "style", instant=ag.choice("rainbow", "line", "none"), otherwise="none"
    ),
    finish: ag.Material = _FINISHES,
    metal: ag.Material = ag.choice(*_METALS, weights=(3, 2, 2, 1)),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a camera with its lens drawn in."""
    wide = require_size(width, _WIDTHS[style], f"width of a {style} camera")
    lens = require_size(lens, _LENSES[style], f"radius of the lens of a {style} camera")
    if style in ("reflex", "film"):
        length = require_size(length, (0.036, 0.12), f"length of the lens of a {style} camera")
    match style:
        case "compact":
            return _compact(wide, lens, keys, finish, metal, maker)
        case "instant":
            return _instant(wide, lens, stripes, finish, maker)
        case "webcam":
            return _webcam(wide, lens, finish, maker)
    tall, deep = (0.60 * wide, 0.050) if style == "reflex" else (0.58 * wide, 0.034)
    room = ag.Region((-wide / 2, wide / 2), (-deep / 2, deep / 2), (0.0, tall))
    look = large.Look(room, 0.004 if style == "reflex" else 0.011, lens, length, finish, metal, maker)
    if style == "reflex":
        made = large.reflex(look, popup=popup, swings=swings, keys=keys)
    else:
        made = large.film(look, finish)
    return made.at(y=0.4 * length - 0.004)  # body and lens about the middle


def _compact(
    wide: ag.Scalar, lens: ag.Scalar, keys: int, finish: ag.Material, metal: ag.Material, maker: str
) -> ag.Body:
    """Make a camera whose lens comes out in two steps, with a button on top and keys beside its screen."""
    tall, deep = 0.57 * wide, 0.027
    room = ag.Region((-wide / 2, wide / 2), (-deep / 2, deep / 2), (0.0, tall))
    x, y, z = room.x, room.y, room.z
    middle = ag.vector(0.16 * wide, y.low, 0.50 * tall)
    solid = ag.extrude(room.plan(radius=0.0125), tall, bevel=0.002).at(z=tall / 2)
    well = ag.Region.centered(2 * lens + 0.0024, 0.0, 2 * lens + 0.0024).grow(front=0.01, back=0.0205)
    shell = finish.with_(name=f"{finish.name}_body", density=1150.0)
    ring = ag.tube(1.43 * lens, lens + 0.0010, 0.0032, axis=ag.Y, bevel=0.0010).at(y=-0.0008)
    body = ag.weld(
        ag.part([solid - well.box().at(middle)], "body", shell, name="body"),
        ag.detail(ring, "ring", metal).at(middle),
        ag.detail(
            ag.Region.centered(0.020, 0.0, 0.009).grow(front=0.0006, back=0.001).box(bevel=0.0004),
            "flash",
            _FLASH,
        ).at(x.low + 0.026, y.low, z.high - 0.012),
        ag.detail(disc(0.0022, -0.001, 0.0005), "led", _FOCUS).at(x.low + 0.010, y.low, z.high - 0.012),
        details.printed(
            details.logo(maker, 0.0022), (x.low + 0.022, y.low, 0.009), material=controls.ink_on(finish)
        ),
    )
    body = _telescoped(body, lens, middle, metal)
    top = (x.low + 0.026, 0, z.high)
    shutter = controls.push_button(
        finish=ag.material("chrome"), plate=_BLACK, through=0.010, shape="pill", width=0.015, height=0.010,
        proud=0.003, travel=0.0018, preload=0.4, force=1.6, name="shutter",
    )  # fmt: skip
    body = body.install(shutter.rotate(ag.X, -math.pi / 2), at=top)
    glass = ag.Region(
        (x.low + 0.030, x.high - 0.006), (y.high - 0.0004, y.high + 0.0005), (0.006, z.high - 0.006)
    )
    body = ag.weld(body, ag.detail(glass.box(bevel=0.0003), "screen", large.SCREEN))
    for number in range(keys):
        key = controls.push_button(
            finish=metal,
            plate=_BLACK,
            through=0.007,
            width=0.0085,
            proud=0.0022,
            deep=0.005,
            travel=0.0012,
            force=2.0,
        )
        at = (x.low + 0.017, y.high, 0.011 + 0.0175 * number)
        body = body.install(key.rotate(ag.Z, math.pi).suffixed(f"_{number}"), at=at)
    on = signals.toggle(signals.pressed("button_slide_0" if keys else "shutter_slide"))
    body = large.shows(body, on, range(1, keys))
    body = body.output("lens_out", on, kind="motor", moves="sleeve_slide", speed=0.02)
    body = body.output("lens_in", ~on, kind="motor", moves="sleeve_slide", speed=-0.02)
    taken = signals.pressed("shutter_slide") & on
    body = body.output("focus", taken, kind="light", material=_FOCUS, color=(1.0, 0.45, 0.04))
    return _taken(body, taken)


def _taken(body: ag.Body, shutter: signals.Signal) -> ag.Body:
    """Let the shutter click and the flash shine."""
    body = body.output("shutter", shutter, kind="sound")
    flash = signals.timer(shutter, 0.1)
    return body.output("flash", flash, kind="light", material=_FLASH, color=(1.0, 1.0, 1.0))


def _telescoped(body: ag.Body, lens: ag.Scalar, at: ag.VectorLike, metal: ag.Material) -> ag.Body:
    """Add the two steps of a lens that a motor drives out."""
    inner = lens - 0.0040
    solid = hollow(lens, inner + 0.0006, (-0.0190, 0.0010))
    seen = ag.tube(lens + 0.0002, inner + 0.0004, 0.0200, axis=ag.Y, bevel=0.0005).at(y=0.0090)
    barrel = disc(inner, -0.0195, 0.0008)
    rim = ag.tube(inner + 0.0001, 0.55 * lens, 0.0016, axis=ag.Y, bevel=0.0005).at(y=-0.0008)
    pupil = ag.dome(0.54 * lens, height=0.0012, axis=-ag.Y).at(y=-0.0006)
    steel = casting(metal, 0.5)
    front = ag.weld(
        ag.part(barrel, "lens", casting(_BLACK, 0.8), name="barrel"),
        ag.detail(rim, "lens", metal),
        ag.detail(pupil, "glass", _GLASS),
    )
    first = ag.Prismatic("sleeve_slide", axis=-ag.Y, limits=(0.0, 0.0155), feel=_MOTOR, driven="a motor")
    second = ag.Prismatic("barrel_slide", axis=-ag.Y, follows=1.0 * first, damping=1.0, armature=0.01)
    sleeve = ag.weld(ag.part(solid, "lens", steel, name="sleeve"), ag.detail(seen, "lens", metal))
    return body.attach(sleeve.attach(front, second), first, at=at)


def _instant(wide: ag.Scalar, lens: ag.Scalar, stripes: str, finish: ag.Material, maker: str) -> ag.Body:
    """Make a camera that ejects its pictures, with a flap for their pack below the lens."""
    deep, step, tall = 0.80 * wide, 0.0525, 1.04 * wide
    front = -deep / 2
    low = ag.Region((-wide / 2, wide / 2), (front, deep / 2), (0.0, step))
    face = front + 0.020
    side = ag.polygon(
        [
            (face, step - 0.001),
            (deep / 2, step - 0.001),
            (deep / 2, 0.8 * tall),
            (deep / 2 - 0.022, tall),
            (face, tall),
        ],
        radius=0.005,
    )
    upper = ag.extrude(side, wide, axis=ag.X, bevel=0.003)
    bay = ag.Region((-0.0444, 0.0444), (front - 0.001, front + 0.060), (0.0060, 0.0420))
    slot = ag.Region((-0.0462, 0.0462), (front - 0.001, front + 0.072), (0.0460, 0.0500))
    shell = finish.with_(name=f"{finish.name}_instant", density=440.0)
    middle = ag.vector(0.006, face, step + 0.50 * (tall - step))
    window = ag.Region.centered(0.026, 0.0, 0.017).grow(front=0.0010, back=0.001).box(bevel=0.0006)
    finder = ag.Region.centered(0.013, 0.0, 0.013).grow(front=0.0012, back=0.001).box(bevel=0.0006)
    upper_left = (-wide / 2 + 0.022, face, tall - 0.018)
    body = ag.weld(
        ag.part([low.box(bevel=0.004) - bay.box() - slot.box(), upper], "body", shell, name="body"),
        ag.part(
            [disc(lens + 0.004, -0.002, 0.008, 0.0015), disc(lens, 0.0075, 0.016, 0.0015)], "lens", _BLACK
        ).at(middle),
        ag.detail(disc(0.62 * lens, 0.015, 0.0164), "mount", ag.material("chrome")).at(middle),
        ag.detail(ag.dome(0.54 * lens, height=0.003, axis=-ag.Y).at(y=-0.0162), "glass", _GLASS).at(middle),
        ag.detail(window, "flash", _FLASH).at(upper_left),
        ag.detail(finder, "glass", _GLASS).at(wide / 2 - 0.014, face, tall - 0.016),
        *_stripes(stripes, front, face, step, middle.z - lens - 0.004),
    )
    shutter = controls.push_button(
        finish=ag.colored("abs", "red"), plate=_BLACK, through=0.012, width=0.013, proud=0.0045, deep=0.007,
        preload=0.5, force=2.5, name="shutter",
    )  # fmt: skip
    body = body.install(shutter, at=(-wide / 2 + 0.018, face, step + 0.016))
    taken = signals.pressed("shutter_slide")
    ejected = signals.timer(taken, 2.5, unless=signals.pressed("flap_hinge", (0.0, 0.2)))
    body = _taken(body, taken).output("ejecting", ejected, kind="motor", moves="photo_slide", speed=0.025)
    return _ejecting(body, bay, slot, finish, maker)


def _stripes(kind: str, front: ag.Scalar, face: ag.Scalar, step: float, end: ag.Scalar) -> list[ag.Body]:
    """Make the stripes that run from the lens over the ledge."""
    if kind == "none":
        return []
    names = ["red", "orange", "mustard", "forest", "sky"] if kind == "rainbow" else ["graphite"]
    made = []
    for number, x in enumerate(controls.places(len(names), 0.0034, middle=0.006)):
        up, along = end - step + 0.0025, face - front - 0.003
        bars = (
            ag.box(0.0034, 0.0008, up).at(x, face, step + up / 2 - 0.002),
            ag.box(0.0034, along, 0.0008).at(x, (front + face) / 2 + 0.001, step),
        )
        made.append(ag.detail(list(bars), "stripe", ag.colored("abs", names[number])))
    return made


def _ejecting(body: ag.Body, bay: ag.Region, slot: ag.Region, finish: ag.Material, maker: str) -> ag.Body:
    """Add the flap before the pack, and the picture that a motor ejects above it."""
    front = bay.y.low + 0.001
    leaf = bay.shrink(x=0.0008, top=0.0008, bottom=0.0016).with_(y=(front, front + 0.004))
    lip = ag.Region(
        (-0.016, 0.016), (front - 0.009, front + 0.001), (leaf.z.high - 0.0050, leaf.z.high - 0.0015)
    )
    hold = ag.grasp_on(lip.box(), approach=ag.Y, closing=ag.X, depth=0.0075)
    pack = bay.with_(y=(front + 0.0055, front + 0.0605)).shrink(x=0.0012, z=0.0012)
    label = ag.detail(
        pack.with_(y=(front + 0.0050, front + 0.0056)).shrink(x=0.02, z=0.01).box(),
        "print",
        ag.colored("abs", "white"),
    )
    flap = ag.part(leaf.box(bevel=0.0012) | lip.box(bevel=0.0008), "flap", finish, name="flap", grasp=hold)
    mark = details.printed(
        details.logo(maker, 0.0050), (0, front, leaf.z.low + 0.011), material=controls.ink_on(finish)
    )
    pivot = (0, front + 0.0020, leaf.z.low + 0.0020)
    hinge = ag.Revolute("flap_hinge", axis=ag.X, pivot=pivot, limits=(0.0, 1.45), feel=_STIFF)
    room = slot.shrink(x=0.0012, z=0.0012).with_(y=(front + 0.004, slot.y.high - 0.002))
    image = room.shrink(x=0.0055, front=0.0165, back=0.005)
    photo = ag.weld(
        ag.part(room.box(), "photo", ag.colored("abs", "white").with_(name="photo_paper"), name="photo"),
        ag.detail(
            image.with_(z=(room.z.high - 0.0002, room.z.high + 0.0001)).box(), "photo",
            ag.material("black_glass").with_(name="photo_dark", base_color=(0.03, 0.045, 0.05)),
        ),
    )  # fmt: skip
    out = ag.Prismatic("photo_slide", axis=-ag.Y, limits=(0.0, 0.055), feel=_MOTOR, driven="a motor")
    full = ag.part(pack.box(), "body", ag.material("black_abs").with_(name="film_pack", density=800.0))
    return ag.weld(body, full, label).attach(ag.weld(flap, mark), hinge).attach(photo, out)


def _webcam(wide: ag.Scalar, lens: ag.Scalar, finish: ag.Material, maker: str) -> ag.Body:
    """Make a camera on a neck above a clip, with a slider that covers its lens."""
    top, tall, deep = 0.0350, 0.030, 0.026
    plate = ag.Region((-0.024, 0.024), (-0.024, 0.026), (0.0285, 0.0335))
    lip = ag.Region((-0.024, 0.024), (-0.024, -0.0205), (0.0, 0.0295))
    ears = [
        ag.Region((x - 0.003, x + 0.003), (0.0185, 0.0260), (0.0200, 0.0295)).box(bevel=0.001)
        for x in (-0.019, 0.019)
    ]
    pads = ag.Region((-0.020, 0.020), (-0.0208, -0.0195), (0.004, 0.020)).box()
    stuff = finish.with_(name=f"{finish.name}_clip", density=1250.0)
    clip = ag.weld(
        ag.part([plate.box(bevel=0.0015), lip.box(bevel=0.0012), *ears], "clip", stuff, name="clip"),
        ag.detail(pads, "foot", ag.material("rubber")),
    )
    leg = ag.union(
        ag.Region((-0.0152, 0.0152), (0.0200, 0.0245), (0.0, 0.0230)).box(bevel=0.0012),
        ag.cylinder(0.0030, 0.0304, axis=ag.X).at(0, 0.0222, 0.0230),
    )
    foot = ag.part(
        leg,
        "foot",
        stuff,
        name="leg",
        grasp=ag.grasp_on(leg, approach=-ag.Y, closing=ag.X, at=(0, 0.0222, 0.009), depth=0.004),
    )
    spread = ag.Revolute("leg_hinge", axis=ag.X, pivot=(0, 0.0222, 0.0230), limits=(0.0, 1.2), feel=_STIFF)
    neck = ag.part(
        [
            ag.cylinder(0.011, 0.005, bevel=0.001).at(z=0.0335 + FIT.running + 0.0025),
            ag.Region((-0.0045, 0.0045), (-0.007, 0.007), (top + 0.002, top + 0.0130)).box(bevel=0.001),
        ],
        "neck", stuff, name="neck",
    )  # fmt: skip
    pivot = (0, 0, top + 0.0095)
    low = top + 0.0170
    room = ag.Region((-wide / 2, wide / 2), (-deep / 2, deep / 2), (low, low + tall))
    shell = finish.with_(name=f"{finish.name}_head", density=760.0)
    solid = ag.extrude(room.front(radius=0.0125), deep, axis=ag.Y, bevel=0.003).at(y=0)
    lugs = [
        ag.hull(
            ag.cylinder(0.0045, 0.0056, axis=ag.X).at(*pivot),
            ag.box(0.0056, 0.009, 0.001).at(0, 0, low + 0.002),
        ).at(x)
        for x in (-0.0082, 0.0082)
    ]
    center = ag.vector(0, room.y.low, room.z.mid)
    edge = (wide / 2 - 0.0105, 0, room.z.high)
    hold = ag.grasp_on(solid, approach=-ag.Z, closing=ag.Y, at=edge, depth=0.012)
    head = ag.weld(
        ag.part([solid, *lugs], "body", shell, name="head", grasp=hold),
        ag.part(disc(lens, -0.001, 0.0022, 0.0006), "lens", _BLACK).at(center),
        ag.detail(ag.dome(0.6 * lens, height=0.0016, axis=-ag.Y).at(y=-0.0021), "glass", _GLASS).at(center),
        ag.detail(disc(0.0012, -0.001, 0.0004), "led", _SEES).at(center + ag.vector(0.24 * wide, 0, 0.004)),
        details.printed(
            details.logo(maker, 0.0020),
            (0.31 * wide, room.y.low, room.z.mid - 0.006),
            material=controls.ink_on(finish),
        ),
    )
    head = _slid(head, lens, center)
    tilt = ag.Revolute("head_tilt", axis=ag.X, pivot=pivot, limits=(-0.30, 0.30), feel=_STIFF)
    turn = ag.Revolute("neck_turn", axis=ag.Z, limits=(-0.7, 0.7), feel=_STIFF)
    return clip.attach(foot, spread).attach(neck.attach(head, tilt), turn)


def _slid(head: ag.Body, lens: ag.Scalar, center: ag.Vector) -> ag.Body:
    """Add the slider beside the lens, between two rails."""
    half, travel = lens + 0.0016, 2.0 * lens + 0.0035
    rails = [
        ag.Region((-half - travel, half + 0.001), (-0.0046, 0.0005), (z - 0.0010, z + 0.0010)).box(
            bevel=0.0004
        )
        for z in (-half - 0.0016, half + 0.0016)
    ]
    plate = ag.Region((-half, half), (-0.0044, -0.0028), (-half, half)).box(bevel=0.0004)
    ridge = ag.Region((-0.0022, 0.0022), (-0.0100, -0.0040), (-0.7 * half, 0.7 * half)).box(bevel=0.0008)
    hold = ag.grasp_on(ridge, approach=ag.Y, closing=ag.X, depth=0.0042)
    slider = ag.part([plate, ridge], "slider", _BLACK, name="slider", grasp=hold, grasp_width=0.0144).at(
        -travel
    )
    slide = ag.Prismatic(
        "slider_slide", axis=ag.X, limits=(0.0, travel), friction=0.6, damping=2.0, armature=0.005, effort=8.0
    )
    open_ = ~signals.pressed("slider_slide")
    head = head.output("recording", open_, kind="light", material=_SEES, color=_SEES.emission)
    return ag.weld(head, ag.part(rails, "body", _BLACK).at(center)).attach(slider, slide, at=center)
