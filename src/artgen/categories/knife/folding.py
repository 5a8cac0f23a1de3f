"""Pocket knives: blades and tools that turn out of a handle, and a ring that locks a blade.

The pivot of a blade is at the origin, and the folded blade points to the left, its edge down.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls

Point = Literal["drop", "clip", "tanto", "sheepsfoot"]
"""Point of a folding blade."""

# back and belly of a blade from its root to its point: shares of its length, and of half of its height
_POINTS: dict[Point, tuple[tuple[tuple[float, float], ...], tuple[tuple[float, float], ...]]] = {
    "drop": (
        ((0.46, 1.0), (0.60, 0.97), (0.72, 0.88), (0.83, 0.70), (0.92, 0.44), (1.0, 0.08)),
        ((0.97, -0.20), (0.92, -0.50), (0.86, -0.74), (0.78, -0.92), (0.68, -1.0)),
    ),
    "clip": (
        ((0.54, 1.0), (0.62, 0.82), (0.72, 0.65), (0.84, 0.51), (1.0, 0.42)),
        ((0.98, 0.06), (0.94, -0.30), (0.88, -0.60), (0.80, -0.84), (0.70, -0.97), (0.60, -1.0)),
    ),
    "tanto": (((0.62, 1.0), (1.0, 0.42)), ((0.80, -1.0),)),
    "sheepsfoot": (
        ((0.68, 1.0), (0.79, 0.90), (0.88, 0.64), (0.94, 0.24), (0.98, -0.28), (1.0, -0.82)),
        ((0.99, -1.0),),
    ),
}
_PLAY = 0.0005  # gap between a blade and its liners, at each side [m]
_LINER = 0.0012  # thickness of a liner [m]
_FRONT = 0.0110  # from a pivot to the front of a handle [m]
_TURN = math.pi  # of a folding blade [rad]
_BEYOND = 0.35  # from the closed position to that to which a back spring draws a blade [rad]
STEEL = ag.material("stainless")
"""Steel of liners, springs and screws."""

BLADE = STEEL.with_(name="blade_steel", density=7800.0)
"""Steel of blades."""

_DARK = ag.material("black_steel").with_(name="coated_blade", density=7800.0)
_RING = feel.Feel(friction=0.06, damping=0.004, armature=2e-5, effort=0.6)
_SWING = feel.Feel(friction=0.015, damping=0.004, armature=2e-5, effort=1.2)


def _swing(name: str, torque: ag.Scalar, *, left: bool = False, pivot: ag.VectorLike = (0, 0, 0)) -> ag.Joint:
    """Make the joint of a tool that turns up out of its handle; a back spring holds it at both ends."""
    snap = feel.detents((-_BEYOND, _TURN + 1.5 * _BEYOND), torque)
    axis = -ag.Y if left else ag.Y
    return ag.Revolute(name, axis=axis, pivot=pivot, limits=(0, _TURN), detents=snap, feel=_SWING)


def _ground(
    point: Point, root: ag.Scalar, length: ag.Scalar, back: float, edge: float, thick: float
) -> ag.Solid:
    """Make a blade that points to the left behind its root, ground to an edge below."""
    mid, half = (back + edge) / 2, (back - edge) / 2
    spine, belly = _POINTS[point]
    way = length + root  # the root is negative
    line = [(root - u * way, mid + v * half) for u, v in (*spine, *belly)]
    flat = ag.polygon([(root + 0.004, back), (root, back), *line, (root, edge), (root + 0.004, edge)])
    start = mid + 0.25 * half
    section = [
        (thick / 2, back + 0.01),
        (thick / 2, start),
        (0.00015, edge),
        (-0.00015, edge),
        (-thick / 2, start),
    ]
    wedge = ag.polygon([*section, (-thick / 2, back + 0.01)])
    return ag.extrude(flat, thick, axis=ag.Y) & ag.extrude(wedge, 1.0, axis=ag.X)


def _nick(at: tuple[ag.Scalar, float], thick: float, steel: ag.Material) -> ag.Body:
    """Make the nick for a nail in the front of a blade."""
    x, z = at
    return details.engraved(ag.slot(0.0105, 0.0016), (x, -thick / 2, z), material=steel)


def _handle_line(rear: ag.Scalar, *, hunter: bool) -> list[tuple[ag.Scalar, ag.Scalar]]:
    """Return the outline of a handle from its front over its open side to its back."""
    front = _FRONT
    if hunter:
        return [
            (front, 0.0050), (front - 0.0030, 0.0092), (-0.012, 0.0088), (-0.030, 0.0084),
            (-0.6 * rear, 0.0090), (0.012 - rear, 0.0086), (-rear, 0.0035), (0.0010 - rear, -0.0050),
            (0.008 - rear, -0.0120), (-0.66 * rear, -0.0168), (-0.40 * rear, -0.0172), (-0.012, -0.0146),
            (front - 0.0020, -0.0118), (front, -0.0080),
        ]  # fmt: skip
    return [
        (front, 0.0030), (front - 0.0040, 0.0092), (-0.015, 0.0090), (-0.024, 0.0068), (-0.036, 0.0072),
        (-0.048, 0.0090), (-0.74 * rear, 0.0086), (0.010 - rear, 0.0070), (-rear, 0.0010),
        (0.0030 - rear, -0.0090), (-0.76 * rear, -0.0142), (-0.40 * rear, -0.0160), (-0.014, -0.0146),
        (front - 0.0030, -0.0118), (front, -0.0060),
    ]  # fmt: skip


def pocket_knife(
    length: ag.Scalar,
    point: Point,
    opened: str,
    torque: ag.Scalar,
    finish: ag.Material,
    bolsters: ag.Material | None,
    maker: str,
    *,
    coated: bool,
) -> ag.Body:
    """Make a folding knife with a clip, or with bolsters of a material, opened by a `stud` or a `nail`."""
    hunter = bolsters is not None
    steel = _DARK if coated else BLADE
    thick = 0.0030 if hunter else 0.0029
    rear = length - _FRONT
    back, edge, reach = 0.0142, -0.0088, rear - 0.0095
    outline = _smooth(_handle_line(rear, hunter=hunter))
    slot = thick + 2 * _PLAY
    cover = 0.0034 if hunter else 0.0033
    half = slot / 2 + _LINER + cover
    low = ag.Region((-1.0, -0.0155), (0, 1), (-1.0, edge - 0.0010))
    end = ag.Region((-1.0, -reach - 0.0025), (0, 1), (-1.0, 1.0))
    spacer = ag.extrude(outline.offset(-0.0003) & (low.front() | end.front()), slot + 0.0004, axis=ag.Y)
    liners = [
        ag.extrude(outline, _LINER, axis=ag.Y).at(y=y) for y in (-(slot + _LINER) / 2, (slot + _LINER) / 2)
    ]
    scales = [
        ag.extrude(outline, cover, axis=ag.Y, bevel=0.0013).at(y=side * (half - cover / 2))
        for side in (-1, 1)
    ]
    if bolsters is None:
        cover_parts = [ag.part(scales, "handle", finish, separate="scales on both liners")]
    else:
        middle = ag.Region((0.025 - rear, -0.026), (-1, 1), (-1, 1)).box()
        wood, ends = [each & middle for each in scales], [each - middle for each in scales]
        cover_parts = [
            ag.part(wood, "handle", finish, separate="scales on both liners"),
            ag.part(ends, "bolster", bolsters, separate="bolsters on both liners"),
        ]
    body = ag.weld(
        ag.part([spacer, *liners], "liner", bolsters or STEEL, name="handle"),
        *cover_parts,
        *_fixings(half, rear, bolsters),
        print_mark(maker, (-0.5 * rear, -half, -0.0030), (rear - 0.069, 0.0036), finish),
    )
    if not hunter:
        body = ag.weld(body, _clip(rear, half))
    flat = _ground(point, -0.012, reach, back, edge, thick)
    root = ag.polygon(
        [(0.0060, 0.0080), (-0.0085, back), (-0.0125, back), (-0.0125, edge + 0.0030), (-0.004, -0.0086)]
    )
    tang = ag.extrude(root | ag.regular_polygon(16, 0.0098), thick, axis=ag.Y)
    blade = flat | tang
    hold = ag.grasp_on(blade, approach=-ag.Z, closing=ag.Y, at=(-0.46 * rear, 0, back - 0.002), depth=0.0042)
    parts = [ag.part(blade, "blade", steel, name="blade", grasp=hold)]
    if opened == "stud":
        pin = ag.cylinder(0.0020, 0.0105, axis=ag.Y, bevel=0.0004).at(-0.0190, 0, back - 0.0012)
        parts.append(ag.part(pin, "blade", _DARK))
    else:
        parts.append(_nick((-0.40 * rear, back - 0.0026), thick, steel))
    body = body.attach(ag.weld(*parts), _swing("blade_hinge", torque))
    return body.at(length / 2 - _FRONT, 0, -scales[0].anchor(z=-1).z)


def _fixings(half: float, rear: ag.Scalar, bolsters: ag.Material | None) -> list[ag.Body]:
    """Make the heads of the pivot, and of screws or pins of the scales, on both sides."""
    heads = []
    for facing, y in ((-ag.Y, -half), (ag.Y, half)):
        if bolsters is not None:
            spots = [(0.0, 0.0, 0.0026), (-0.0310, -0.003, 0.0016), (0.030 - rear, -0.003, 0.0016)]
            pins = [details.rivet(size, (x, y, z), facing=facing) for x, z, size in spots]
            heads.append(ag.detail(pins, "pivot", bolsters))
            continue
        for x, z, size in (
            (0.0, 0.0, 0.0044),
            (-0.26 * rear, -0.0105, 0.0019),
            (0.012 - rear, -0.0010, 0.0021),
        ):
            heads.append(details.screw(size, (x, y, z), material=STEEL, facing=facing, drive="torx"))
    return heads


def _smooth(line: list[tuple[ag.Scalar, ag.Scalar]]) -> ag.Profile:
    """Make a smooth outline through points."""
    return ag.spline([(x, z, 0) for x, z in line], closed=True).profile()


def print_mark(maker: str, at: ag.VectorLike, room: tuple[ag.Scalar, float], face: ag.Material) -> ag.Body:
    """Print the name of the maker on the front of a handle, within a width and a height [m]."""
    wide, tall = room
    high = ag.min_(tall, wide / details.lettering_width(maker.upper(), 0.3))
    return details.printed(details.logo(maker, high), at, material=controls.ink_on(face))


def _clip(rear: ag.Scalar, half: float) -> ag.Body:
    """Make the clip for a pocket on the back of a handle."""
    start, stop = 0.004 - rear, 0.048 - rear
    foot = ag.Region((start, start + 0.012), (half - 0.0003, half + 0.0011), (-0.0065, 0.0015)).box(
        bevel=0.0004
    )
    bar = ag.hull(
        ag.Region((start + 0.011, start + 0.0115), (half + 0.0001, half + 0.0011), (-0.0060, 0.0010)).box(),
        ag.Region((start + 0.017, start + 0.0175), (half + 0.0016, half + 0.0026), (-0.0056, 0.0006)).box(),
    )
    strip = ag.hull(
        ag.Region((start + 0.017, start + 0.0175), (half + 0.0016, half + 0.0026), (-0.0056, 0.0006)).box(),
        ag.Region((stop - 0.002, stop), (half + 0.0010, half + 0.0020), (-0.0048, -0.0002)).box(),
    )
    return ag.part(ag.union(foot, bar, strip), "clip", _DARK.with_(name="spring_steel"))


def ringed_knife(
    length: ag.Scalar, point: Point, torque: ag.Scalar, finish: ag.Material, maker: str
) -> ag.Body:
    """Make a knife with a turned handle of wood, whose ring at the pivot has a slot for the blade."""
    thick = 0.0018
    wide = 2 * (thick / 2 + _PLAY)
    reach, back, edge = 0.775 * length, 0.0124, -0.0078
    # shares of the length, width and height of the handle, and the height of its middle [m]
    turned = (
        (0.0, 0.0172, 0.0196, -0.0008), (0.07, 0.0176, 0.0200, -0.0012), (0.30, 0.0172, 0.0196, -0.0018),
        (0.62, 0.0186, 0.0222, -0.0026), (0.80, 0.0192, 0.0228, -0.0030), (0.93, 0.0180, 0.0204, -0.0040),
        (0.985, 0.0136, 0.0150, -0.0050), (1.0, 0.0090, 0.0100, -0.0054),
    )  # fmt: skip
    sections = [ag.ellipse(broad / 2, tall / 2).at(0, z) for _, broad, tall, z in turned]
    places = [-0.0046 - share * (length - 0.0046) for share, *_ in turned]
    wood = ag.loft(sections[::-1], places[::-1], axis=ag.X)
    groove = ag.Region((-reach - 0.003, 0.02), (-wide / 2, wide / 2), (edge - 0.0012, 0.05)).box()
    through = ag.Region((-0.0100, 0.02), (-wide / 2, wide / 2), (-0.0084, 0.05)).box()
    deep = ag.Region((-0.0100, -0.0040), (-wide / 2, wide / 2), (-0.0096, 0.05)).box()
    ferrule = ag.extrude(ag.regular_polygon(24, 0.0089), 0.0097, axis=ag.X).at(-0.00075) - through - deep
    body = ag.weld(
        ag.part(wood - groove - deep, "handle", finish, name="handle"), ag.part(ferrule, "bolster", STEEL)
    )
    tang = ag.extrude(ag.regular_polygon(16, 0.0080), thick, axis=ag.Y)
    flat = _ground(point, -0.0105, reach, back, edge, thick)
    neck = ag.polygon(
        [
            (-0.002, 0.0070),
            (-0.0046, 0.0076),
            (-0.0046, back),
            (-0.0110, back),
            (-0.0110, edge),
            (-0.0072, -0.0091),
            (-0.0046, -0.0091),
            (-0.0046, -0.0074),
            (-0.002, -0.0070),
        ]
    )
    blade = flat | tang | ag.extrude(neck, thick, axis=ag.Y)
    hold = ag.grasp_on(
        blade, approach=-ag.Z, closing=ag.Y, at=(-0.45 * length, 0, back - 0.002), depth=0.0036
    )
    mark = details.engraved(
        details.logo(maker, 0.0019).rotate(math.pi),
        (-0.21 * length, -thick / 2, back - 0.0042),
        material=BLADE,
    )
    nick = _nick((-0.50 * length, back - 0.0022), thick, BLADE)
    knife_blade = ag.weld(ag.part(blade, "blade", BLADE, name="blade", grasp=hold), nick, mark)
    turn = ag.Revolute("ring_turn", axis=ag.X, limits=(0, 0.9), feel=_RING)
    swing = ag.Revolute(
        "blade_hinge",
        axis=ag.Y,
        limits=(0, _TURN),
        friction=0.5 * torque,
        feel=_SWING,
        needs=(turn < 0.05).until(_TURN - 0.01),
    )
    collar = ag.extrude(ag.regular_polygon(24, 0.0104) - ag.regular_polygon(24, 0.0094), 0.0086, axis=ag.X)
    collar -= ag.Region((-0.02, 0.02), (-wide / 2 - 0.0004, wide / 2 + 0.0004), (0.0, 0.05)).box()
    squeeze = ag.grasp_on(collar, approach=-ag.Z, closing=ag.Y, depth=0.0125)
    ring = ag.part(collar, "ring", STEEL, grasp=squeeze, when=swing > _TURN - 0.005)
    body = body.attach(knife_blade, swing).attach(ring, turn)
    return body.at((length - 0.0080) / 2, 0, -wood.anchor(z=-1).z)


def multi_tool(length: ag.Scalar, torque: ag.Scalar, finish: ag.Material, maker: str) -> ag.Body:
    """Make a multi-tool in two layers: a blade, and an opener and a lifter that point to each other."""
    back, edge, thick, sheet, cover = 0.0118, -0.0028, 0.0021, 0.0007, 0.0028
    end = 0.0060  # from a pivot to the end of the handle [m]
    apart, middle, tall = length - 2 * end, -0.0020, 0.0200
    gap = thick + 2 * 0.00035
    outline = ag.slot(length, tall).at(-apart / 2, middle)
    plates = [ag.extrude(outline, sheet, axis=ag.Y).at(y=number * (gap + sheet)) for number in (-1, 0, 1)]
    low = ag.Region((-apart + 0.008, -0.008), (0, 1), (-1.0, -0.0048)).front()
    levels = [-(gap + sheet) / 2, (gap + sheet) / 2]
    strip = ag.extrude(outline.offset(-0.0002) & low, gap + 0.0004, axis=ag.Y)
    strips = [strip.at(y=y) for y in levels]
    half = 1.5 * sheet + gap + cover
    scales = [
        ag.extrude(outline, cover, axis=ag.Y, bevel=0.0013).at(y=side * (half - cover / 2))
        for side in (-1, 1)
    ]
    alu = ag.material("aluminium")
    body = ag.weld(
        ag.part(plates, "liner", alu, name="handle", separate="joined by the springs"),
        ag.part(strips, "spring", STEEL),
        ag.part(scales, "handle", finish, separate="a scale on each side"),
        print_mark(maker, (-apart / 2, -half, middle), (0.62 * apart, 0.0044), finish),
        _key_ring(-apart - end, middle),
    )
    blade_y, tool_y = levels
    low_back = 0.0074  # of the blade near its pivot
    reach = 0.745 * length
    flat = _ground("drop", -0.0105, reach, back, edge, thick)
    root = ag.polygon(
        [
            (0.0030, 0.0062),
            (-0.0060, low_back),
            (-0.0110, low_back),
            (-0.0110, edge + 0.001),
            (-0.0030, -0.0040),
        ]
    )
    flat -= ag.Region((-0.0275, 0.01), (-0.1, 0.1), (low_back, 0.1)).box()  # beside the opener
    blade = (flat | ag.extrude(root | ag.circle(0.0058), thick, axis=ag.Y)).at(y=blade_y)
    hold = ag.grasp_on(
        blade, approach=-ag.Z, closing=ag.Y, at=(-apart / 2, blade_y, back - 0.001), depth=0.0032
    )
    nick = _nick((-0.62 * reach, back - 0.0024), thick, BLADE).at(y=blade_y)
    swing = _swing("blade_hinge", torque)
    body = body.attach(ag.weld(ag.part(blade, "blade", BLADE, name="blade", grasp=hold), nick), swing)
    opener = [
        (0.0, 0.0056), (-0.006, back), (-0.019, back), (-0.0225, 0.0075), (-0.0232, 0.0012),
        (-0.0195, -0.0022), (-0.0170, 0.0020), (-0.0135, 0.0026), (-0.0120, -0.0020), (-0.003, -0.0048),
    ]  # fmt: skip
    lifter = [
        (0.0, 0.0056), (-0.006, back), (-0.0190, back), (-0.0232, 0.0060), (-0.0232, 0.0020),
        (-0.0180, 0.0018), (-0.0160, -0.0026), (-0.0120, -0.0030), (-0.0105, 0.0012), (-0.0075, -0.0010),
        (-0.003, -0.0048),
    ]  # fmt: skip
    for name, line in (("opener", opener), ("lifter", lifter)):
        left = name == "lifter"
        tool = ag.extrude(ag.polygon(line) | ag.circle(0.0058), thick, axis=ag.Y).at(y=tool_y)
        hold = ag.grasp_on(
            tool, approach=-ag.Z, closing=ag.Y, at=(-0.0165, tool_y, back - 0.001), depth=0.0032
        )
        made = ag.part(tool, name, BLADE, name=name, grasp=hold, when=swing > 2.0 if left else None)
        pivot = (-apart if left else 0.0, 0, 0)
        if left:
            made = made.mirror(ag.X).at(-apart)
        body = body.attach(made, _swing(f"{name}_hinge", 0.6 * torque, left=left, pivot=pivot))
    return body.at(apart / 2 + 0.0078, 0, tall / 2 - middle)


def _key_ring(x: ag.Scalar, z: float) -> ag.Body:
    """Make the ring for keys at the left end of a handle, and its eye."""
    eye = ag.tube(0.0024, 0.0014, 0.0016).at(x - 0.0008, -0.0020, z)
    loop = ag.torus(0.0065, 0.0006, axis=ag.Y).at(x - 0.0086, -0.0020, z)
    return ag.detail([eye, loop], "clip", STEEL)
