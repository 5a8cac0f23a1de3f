"""Bottles of soap dispensers, and their labels.

A bottle fills its space, a region from the table up to the shoulder, centered on the z axis.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import polar, vessels
from artgen.categories.soap_dispenser.finish import ink_on
from artgen.nodes.handles import Path

Shape = Literal[
    "round",
    "square",
    "cube",
    "oval",
    "hexagonal",
    "amphora",
    "cone",
    "bell",
    "apothecary",
    "ribbed",
    "beehive",
]
Content = Literal["soap", "hand_wash", "lotion", "dish_soap"]
Print = Literal["none", "word", "icon", "label"]

WORDS: dict[Content, tuple[str, ...]] = {
    "soap": ("SOAP",),
    "hand_wash": ("HAND", "WASH"),
    "lotion": ("LOTION",),
    "dish_soap": ("DISH", "SOAP"),
}
UNPRINTED = ("ribbed", "beehive")
LABELED = ("round", "square", "cube", "apothecary")  # they have a flat or straight wall for a label

_BEADS: list[list[vessels.Drawn]] = [
    [(0.90, low, 0), (1, low + 0.08, 0), (0.90, low + 0.16, 0)] for low in (0.15, 0.31, 0.47)
]
_FORMS: dict[str, list[list[vessels.Drawn]]] = {
    "round": [
        [(0.95, 0, 0), (1, 0, 0.05)],
        [(1, 0, 0.05), (1, 1, -0.16)],
        [(1, 1, -0.16), (0.97, 1, -0.06), (0.88, 1, 0)],
    ],
    "amphora": [
        [(0.54, 0, 0), (0.58, 0, 0.04), (0.56, 0, 0.10)],
        [(0.52, 0, 0.10), (0.66, 0.16, 0.05), (0.90, 0.40, 0), (1, 0.62, 0), (0.92, 0.82, 0), (0.66, 0.95, 0),
         (0.46, 1, 0)],
    ],
    "cone": [
        [(0.96, 0, 0), (1, 0, 0.05)],
        [(1, 0, 0.05), (0.56, 1, -0.10)],
        [(0.56, 1, -0.10), (0.53, 1, -0.03), (0.46, 1, 0)],
    ],
    "bell": [
        [(0.96, 0, 0), (1, 0, 0.06), (0.98, 0, 0.16)],
        [(0.95, 0, 0.16), (0.86, 0.28, 0.06), (0.80, 0.60, 0), (0.70, 0.85, 0), (0.46, 1, 0)],
    ],
    "apothecary": [
        [(0.95, 0, 0), (1, 0, 0.06)],
        [(1, 0, 0.06), (1, 1, -0.80)],
        [(1, 1, -0.80), (0.96, 1, -0.54), (0.80, 1, -0.30), (0.56, 1, -0.14), (0.46, 1, 0)],
    ],
    "beehive": [
        [(0.90, 0, 0), (0.96, 0.06, 0), (0.90, 0.15, 0)],
        *_BEADS,
        [(0.88, 0.63, 0), (0.92, 0.71, 0), (0.80, 0.79, 0)],
        [(0.78, 0.79, 0), (0.74, 0.88, 0), (0.60, 0.96, 0), (0.46, 1, 0)],
    ],
}  # fmt: skip
# widths and heights of the shoulder of an oval bottle, as shares
_SHOULDER = ((1, 0.74), (0.98, 0.82), (0.92, 0.89), (0.80, 0.945), (0.62, 0.985))

# corner of a blown bottle above its foot, and the radius that rounds it [m]; straight slopes need few
# colliders
_BLOWN: dict[str, tuple[vessels.Drawn, float]] = {
    "round": ((1, 1, -0.14), 0.0040),
    "apothecary": ((1, 1, -0.60), 0.0085),
    "cone": ((0.56, 1, -0.16), 0.0040),
    "bell": ((0.84, 1, -0.42), 0.0065),
}
_NECK = 0.0150  # radius of the upper end of a shoulder, below the collar of a pump [m]
_EDGE = 0.0035  # chamfer of the foot of a blown bottle [m]
_GLASS = 0.0028  # wall thickness of blown and pressed glass [m]
_WIDEST = 0.087  # largest width at which colliders follow the bends within a millimeter [m]
_TOO_WIDE = (
    "colliders do not follow the bends of so wide a bottle of glass: "
    f"take a width of {_WIDEST:g} at most, shape=cone or another build"
)


def _runs(shape: Shape, space: ag.Region) -> list[vessels.Run]:
    return vessels.drawn(_FORMS[shape], space.x.high, 0.0, space.z.high)


def _plan(shape: Shape, space: ag.Region, radius: ag.Scalar) -> ag.Profile:
    return ag.regular_polygon(6, space.x.high) if shape == "hexagonal" else space.plan(radius=radius)


def _between(plan: ag.Profile, low: ag.Scalar, high: ag.Scalar, bevel: ag.Scalar = 0.0) -> ag.Solid:
    return ag.extrude(plan, high - low, bevel=bevel).at(z=(low + high) / 2)


def fluted(count: int, steps: int, depth: float, power: int = 1) -> ag.Profile:
    """Make a circle of radius 1 with flutes of a depth, of so many steps each."""
    angles = [math.tau * step / (steps * count) for step in range(steps * count)]
    return polar([1 - depth * (0.5 - 0.5 * math.cos(count * angle)) ** power for angle in angles])


def opaque(shape: Shape, space: ag.Region, finish: ag.Material) -> ag.Body:
    """Make an opaque bottle: the link `body`."""
    radius, height = space.x.high, space.z.high
    if shape in _FORMS:
        return vessels.turned(_runs(shape, space), "body", finish, sides=24)  # bottles are wide
    if shape == "ribbed":  # a cylinder with flutes, which are visual only
        skin = _between(fluted(22, 6, 0.045, 2).scale(radius), 0.004, height - 0.006, 0.0008)
        core = ag.cylinder(0.955 * radius, height, bevel=0.003).at(z=height / 2)
        return ag.weld(ag.part(core, "body", finish), ag.detail(skin, "body", finish))
    if shape == "oval":  # its shoulders slope to the neck
        sections = [(0.95, 0.0), (1, 0.003), *((share, z * height) for share, z in _SHOULDER)]
        plans = [ag.ellipse(share * radius, (0.35 + 0.65 * share) * space.y.high) for share, _ in sections]
        neck = ag.ellipse(0.46 * radius, _NECK + 0.001)
        return ag.part(ag.loft([*plans, neck], [*(z for _, z in sections), height]), "body", finish)
    corner = (0.13 if shape == "cube" else 0.10) * space.x.size
    return ag.part(_between(_plan(shape, space, corner), 0, height, 0.004), "body", finish)


def clear(shape: Shape, space: ag.Region, glass: ag.Material, soap: ag.Material, fill: ag.Scalar) -> ag.Body:
    """Make a clear bottle with its soap and the pump's housing and tube in it: the link `body`."""
    height = space.z.high
    level = fill * height
    if shape in _BLOWN:
        path, ((_, share, rest), fillet) = _blown_path(shape, space), _BLOWN[shape]
        bend = share * height + rest * space.x.high - fillet
        foot = space.x.high - _EDGE
        vessel = vessels.blown(path, "body", glass, foot=foot, wall=_GLASS, level=ag.min_(level, bend))
        content = vessels.filled(path, wall=_GLASS, level=level - 0.0003)
        if shape != "cone":
            vessel = vessel.require(space.x.size <= _WIDEST, _TOO_WIDE)
    else:
        floor = 2 * _GLASS
        hollow = _between(_plan(shape, space.shrink(_GLASS), 0), floor, height - 0.004)
        vessel = ag.part(_between(_plan(shape, space, 0.005), 0, height, 0.003) - hollow, "body", glass)
        content = _between(_plan(shape, space.shrink(_GLASS + 0.0002), 0), floor + 0.0002, level)
    plastic = ag.material("polypropylene")
    end = height - 0.030  # lower end of the pump's housing in the neck
    housing = ag.cylinder_between((0, 0, end), (0, 0, height), 0.0068, bevel=0.001)
    tube = ag.cylinder_between((0, 0, 0.0075), (0, 0, end + 0.001), 0.0023)
    hollow_plastic = plastic.with_(name=f"{plastic.name}_tube", density=420.0)
    # the first part names the link; where parts overlap, the first part has priority
    return ag.weld(
        vessel,
        ag.part(housing, "pump", plastic),
        ag.part(tube, "dip_tube", hollow_plastic),
        ag.part(content, "soap", soap),
    )


def _blown_path(shape: Shape, space: ag.Region) -> Path:
    """Return the outline of a blown bottle, from the edge of its floor to its neck."""
    corner, fillet = _BLOWN[shape]
    radius, height = space.x.high, space.z.high
    (bend,) = vessels.drawn([[corner]], radius, 0.0, height)
    points = [(radius - _EDGE, 0.0), (radius, _EDGE), *bend, (_NECK, height)]
    return ag.polyline([(r, 0.0, z) for r, z in points], fillet=fillet)


def marks(
    kind: Print,
    content: Content,
    maker: str,
    shape: Shape,
    space: ag.Region,
    finish: ag.Material,
    *,
    clear: bool,
) -> list[ag.Body]:
    """Print a bottle."""
    words, ink = WORDS[content], ink_on(finish)
    level = space.z.at({"apothecary": 0.33, "amphora": 0.60, "bell": 0.40}.get(shape, 0.45))
    prints: list[tuple[ag.Profile, float]] = []  # what to print, and its height above the level [m]
    if kind == "word":
        size = 0.0080 if max(map(len, words)) < 5 else 0.0066
        prints = [(details.lettering(words, size, tracking=0.25, leading=1.9), 0)]
    elif kind == "icon":
        sign = {"lotion": "leaf", "dish_soap": "dish"}.get(content, "drop")
        small = details.lettering((" ".join(words),), 0.0032, tracking=0.3, fineness="coarse")
        prints = [(details.icon(sign, 0.018), 0), (small, -0.0165)]
    elif kind == "label":
        ink = ag.colored("abs", "anthracite")
        volume = details.lettering(("300 ML  10 FL OZ",), 0.0020, tracking=0.2, fineness="coarse")
        prints = [
            (details.logo(maker, 0.0026, tracking=0.2), 0.0155),
            (details.lettering(words, 0.0052, tracking=0.25, leading=1.8), 0.0030),
            (ag.rectangle(0.020, 0.0004), -0.0080),
            (volume, -0.0150),
        ]
    bodies = [_paper(shape, space, level)] if kind == "label" else []
    proud = 0.0006 if kind == "label" else 0.0003
    path, y = _front(shape, space, clear=clear)
    for profile, rise in prints:
        if path is None:
            print_ = details.printed(profile, (0, y, level + rise), material=ink, proud=proud)
        else:
            print_ = details.wrapped(profile, path, level + rise, material=ink, proud=proud).at(y=y)
        bodies.append(print_)
    return bodies


def _front(shape: Shape, space: ag.Region, *, clear: bool) -> tuple[Path | None, ag.Scalar]:
    """Return the outline that a print follows around the front, if any, and its place along y [m]."""
    if shape in _FORMS:
        return _blown_path(shape, space) if clear else vessels.path_of(_runs(shape, space)[1]), 0.0
    if shape == "oval":
        radius = space.x.high * space.x.high / space.y.high  # of curvature of the front of an ellipse
        return ag.line((radius, 0, 0), (radius, 0, space.z.high)), radius - space.y.high
    return None, space.x.low * math.cos(math.pi / 6) if shape == "hexagonal" else space.y.low


def _paper(shape: Shape, space: ag.Region, z: ag.Scalar) -> ag.Body:
    """Make the paper of a label, around a straight wall or on a flat one."""
    paper = ag.material("cardboard").with_(name="label_paper", base_color=(0.80, 0.78, 0.72), texture="")
    wide, high = 0.036, 0.044
    if shape in _FORMS:
        angle = wide / space.x.high
        around = ag.revolve(ag.rectangle(0.0006, high).at(space.x.high, z), angle=angle)
        return ag.detail(around.rotate(ag.Z, -(math.pi + angle) / 2), "label", paper)
    return ag.detail(ag.box(wide, 0.0006, high).at(0, space.y.low, z), "label", paper)
