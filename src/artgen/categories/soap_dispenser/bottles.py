"""Bottles of soap dispensers, and their labels."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

import artgen as ag
from artgen import details
from artgen.categories.shared.vessels import Drawn, Run, blown, drawn, filled, path_of, turned
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
"""The outline of a bottle's body."""

NECK = 0.0150
"""Radius of the upper end of a shoulder, below the collar of a pump [m]."""

_FORMS: dict[str, list[list[Drawn]]] = {
    "round": [
        [(0.95, 0.0, 0.0), (1.0, 0.0, 0.05)],
        [(1.0, 0.0, 0.05), (1.0, 1.0, -0.16)],
        [(1.0, 1.0, -0.16), (0.97, 1.0, -0.06), (0.88, 1.0, 0.0)],
    ],
    "amphora": [
        [(0.54, 0.0, 0.0), (0.58, 0.0, 0.04), (0.56, 0.0, 0.10)],
        [
            (0.52, 0.0, 0.10),
            (0.66, 0.16, 0.05),
            (0.90, 0.40, 0.0),
            (1.0, 0.62, 0.0),
            (0.92, 0.82, 0.0),
            (0.66, 0.95, 0.0),
            (0.46, 1.0, 0.0),
        ],
    ],
    "cone": [
        [(0.96, 0.0, 0.0), (1.0, 0.0, 0.05)],
        [(1.0, 0.0, 0.05), (0.56, 1.0, -0.10)],
        [(0.56, 1.0, -0.10), (0.53, 1.0, -0.03), (0.46, 1.0, 0.0)],
    ],
    "bell": [
        [(0.96, 0.0, 0.0), (1.0, 0.0, 0.06), (0.98, 0.0, 0.16)],
        [(0.95, 0.0, 0.16), (0.86, 0.28, 0.06), (0.80, 0.60, 0.0), (0.70, 0.85, 0.0), (0.46, 1.0, 0.0)],
    ],
    "apothecary": [
        [(0.95, 0.0, 0.0), (1.0, 0.0, 0.06)],
        [(1.0, 0.0, 0.06), (1.0, 1.0, -0.80)],
        [(1.0, 1.0, -0.80), (0.96, 1.0, -0.54), (0.80, 1.0, -0.30), (0.56, 1.0, -0.14), (0.46, 1.0, 0.0)],
    ],
    "beehive": [
        [(0.90, 0.0, 0.0), (0.96, 0.06, 0.0), (0.90, 0.15, 0.0)],
        *([(0.90, low, 0.0), (1.0, low + 0.08, 0.0), (0.90, low + 0.16, 0.0)] for low in (0.15, 0.31, 0.47)),
        [(0.88, 0.63, 0.0), (0.92, 0.71, 0.0), (0.80, 0.79, 0.0)],
        [(0.78, 0.79, 0.0), (0.74, 0.88, 0.0), (0.60, 0.96, 0.0), (0.46, 1.0, 0.0)],
    ],
}

_EDGE = 0.0035  # chamfer of the foot of a blown bottle [m]
_BLOWN: dict[str, tuple[list[Drawn], float]] = {
    # corners of the glass shape, above the foot, and the radius that rounds them; straight slopes need few
    # colliders
    "round": ([(1.0, 1.0, -0.14)], 0.0040),
    "apothecary": ([(1.0, 1.0, -0.60)], 0.0095),
    "cone": ([(0.56, 1.0, -0.16)], 0.0040),
    "bell": ([(0.84, 1.0, -0.42)], 0.0090),
}

_WIDEST = 0.087  # largest width at which colliders follow the bends within a millimeter [m]
_TOO_WIDE = (
    "colliders do not follow the bends of so wide a bottle of glass: "
    f"take a width of {_WIDEST:g} at most, shape=cone or another build"
)
_GLASS = 0.0028  # wall thickness of blown and pressed glass [m]
_FLUTES = 22
_PUMP = 0.0068  # radius of the pump's housing in the neck [m]
_DEEP = 0.030  # depth of the pump's housing below the shoulder [m]
_TUBE = 0.0023  # radius of the dip tube [m]


@dataclass(frozen=True)
class Sizes:
    """Dimensions of a bottle."""

    width: ag.Scalar  # width of the bottle [m]
    depth: ag.Scalar  # depth of an oval or rectangular bottle, as a share of its width
    height: ag.Scalar  # height from the table to the shoulder [m]


def is_turned(shape: Shape) -> bool:
    """Return whether a bottle is round about its axis."""
    return shape in _FORMS or shape == "ribbed"


def bottle_runs(shape: Shape, sizes: Sizes) -> list[Run]:
    """Return the outline of a turned bottle."""
    if shape == "ribbed":
        return drawn(_FORMS["round"], sizes.width / 2.0, 0.0, sizes.height)
    return drawn(_FORMS[shape], sizes.width / 2.0, 0.0, sizes.height)


def outline(shape: Shape, sizes: Sizes, inset: ag.Scalar = 0.0) -> ag.Profile:
    """Return the outline of the plan of a bottle with flat or oval sides, moved inward."""
    wide = sizes.width - 2.0 * inset
    deep = sizes.width * sizes.depth - 2.0 * inset
    match shape:
        case "hexagonal":
            return ag.regular_polygon(6, wide / 2.0)
        case "oval":
            return ag.ellipse(wide / 2.0, deep / 2.0)
        case _:
            return ag.rectangle(wide, deep)


def opaque(shape: Shape, sizes: Sizes, finish: ag.Material) -> ag.Body:
    """Make an opaque bottle: the link `body`."""
    height = sizes.height
    if shape in _FORMS:
        return turned(bottle_runs(shape, sizes), "body", finish, sides=24)  # bottles are wide
    if shape == "ribbed":
        return _ribbed(sizes, finish)
    if shape == "oval":
        return ag.part(_oval(sizes), "body", finish)
    wide, deep = sizes.width, sizes.width * sizes.depth
    edge = 0.13 * wide if shape == "cube" else 0.10 * wide
    plan = (
        ag.regular_polygon(6, wide / 2.0) if shape == "hexagonal" else ag.rectangle(wide, deep, radius=edge)
    )
    bevel = 0.004
    return ag.part(ag.extrude(plan, height, bevel=bevel).at(0.0, 0.0, height / 2.0), "body", finish)


def _ribbed(sizes: Sizes, finish: ag.Material) -> ag.Body:
    """Make a cylinder with vertical flutes, which are visual only."""
    radius, height = sizes.width / 2.0, sizes.height
    steps = 6 * _FLUTES
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 - 0.045 * (0.5 - 0.5 * math.cos(_FLUTES * angle)) ** 2 for angle in angles]
    plan = ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])
    skin = ag.extrude(plan.scale(radius), height - 0.010, bevel=0.0008).at(0.0, 0.0, height / 2.0 - 0.001)
    core = ag.cylinder(0.955 * radius, height, bevel=0.003).at(0.0, 0.0, height / 2.0)
    return ag.weld(ag.part(core, "body", finish), ag.detail(skin, "body", finish))


def _oval(sizes: Sizes) -> ag.Solid:
    """Make an oval bottle with shoulders that slope to the neck."""
    wide, deep, height = sizes.width / 2.0, sizes.width * sizes.depth / 2.0, sizes.height
    levels: list[tuple[float, ag.Scalar]] = [
        (0.95, 0.0),
        (1.0, 0.003),
        (1.0, 0.74 * height),
        (0.98, 0.82 * height),
        (0.92, 0.89 * height),
        (0.80, 0.945 * height),
        (0.62, 0.985 * height),
    ]
    plans = [ag.ellipse(share * wide, (0.35 + 0.65 * share) * deep) for share, _ in levels]
    plans.append(ag.ellipse(0.46 * wide, NECK + 0.001))
    return ag.loft(plans, [*(level for _, level in levels), height])


def clear(
    shape: Shape,
    sizes: Sizes,
    glass: ag.Material,
    soap: ag.Material,
    *,
    fill: ag.Scalar,
    plastic: ag.Material,
) -> ag.Body:
    """Make a clear bottle with its soap and the pump's housing and tube in it: the link `body`."""
    height = sizes.height
    level = fill * height
    tube = plastic.with_(name=f"{plastic.name}_tube", density=420.0)
    inside = ag.weld(
        ag.part(
            ag.cylinder_between((0.0, 0.0, height - _DEEP), (0.0, 0.0, height), _PUMP, bevel=0.001),
            "pump",
            plastic,
        ),
        ag.part(
            ag.cylinder_between((0.0, 0.0, 0.0075), (0.0, 0.0, height - _DEEP + 0.001), _TUBE),
            "dip_tube",
            tube,
        ),
    )
    if shape in _BLOWN:
        path, foot = blown_path(shape, sizes), sizes.width / 2.0 - _EDGE
        solid_to = ag.min_(level, _straight(shape, sizes))
        vessel = blown(path, "body", glass, foot=foot, wall=_GLASS, level=solid_to)
        content = filled(path, wall=_GLASS, level=level - 0.0003)
        if shape != "cone":
            vessel = vessel.require(sizes.width <= _WIDEST, _TOO_WIDE)
    else:
        floor = 2.0 * _GLASS
        outer = outline(shape, sizes) if shape == "hexagonal" else _rounded(sizes)
        hollow = ag.extrude(outline(shape, sizes, _GLASS), height - 0.004 - floor)
        block = ag.extrude(outer, height, bevel=0.003).at(0.0, 0.0, height / 2.0)
        vessel = ag.part(block - hollow.at(0.0, 0.0, (height - 0.004 + floor) / 2.0), "body", glass)
        content = ag.extrude(outline(shape, sizes, _GLASS + 0.0002), level - floor - 0.0002)
        content = content.at(0.0, 0.0, (level + floor + 0.0002) / 2.0)
    # the first part names the link; where parts overlap, the first part has priority
    return ag.weld(vessel, inside, ag.part(content, "soap", soap))


def blown_path(shape: Shape, sizes: Sizes) -> Path:
    """Return the outline of a blown bottle, from the edge of its floor to its neck."""
    corners, fillet = _BLOWN[shape]
    radius = sizes.width / 2.0
    (slope,) = drawn([corners], radius, 0.0, sizes.height)
    points = [(radius - _EDGE, 0.0), (radius, _EDGE), *slope, (NECK, sizes.height)]
    return ag.polyline([(r, 0.0, z) for r, z in points], fillet=fillet)


def _straight(shape: Shape, sizes: Sizes) -> ag.Scalar:
    """Return the height up to which a blown bottle has no bends [m]."""
    corners, fillet = _BLOWN[shape]
    _, share, rest = corners[0]
    return share * sizes.height + rest * sizes.width / 2.0 - fillet


def _rounded(sizes: Sizes) -> ag.Profile:
    return ag.rectangle(sizes.width, sizes.width * sizes.depth, radius=0.005)


Content = Literal["soap", "hand_wash", "lotion", "dish_soap"]
"""Contents of a dispenser."""

Print = Literal["none", "word", "icon", "label"]
"""Print on a bottle."""

WORDS: dict[Content, tuple[str, ...]] = {
    "soap": ("SOAP",),
    "hand_wash": ("HAND", "WASH"),
    "lotion": ("LOTION",),
    "dish_soap": ("DISH", "SOAP"),
}
"""Words for the contents."""

_ICONS: dict[Content, str] = {"soap": "drop", "hand_wash": "drop", "lotion": "leaf", "dish_soap": "dish"}
# run of the outline that carries the print
_RUN = {"round": 1, "amphora": 1, "cone": 1, "bell": 1, "apothecary": 1}
# height of the print, as a share; other bottles have it in the middle
_LEVEL = {"apothecary": 0.33, "amphora": 0.60, "bell": 0.40}
PRINTED: tuple[Shape, ...] = tuple(shape for shape in get_args(Shape) if shape not in ("ribbed", "beehive"))
"""Bottles for print: all except those with ribs."""

LABELLED: tuple[Shape, ...] = ("round", "square", "cube", "apothecary")
"""Bottles with a flat or straight wall for a label."""


def _printed(
    profile: ag.Profile,
    shape: Shape,
    sizes: Sizes,
    ink: ag.Material,
    *,
    clear: bool,
    rise: ag.Scalar = 0.0,
    proud: float = 0.0003,
) -> ag.Body:
    """Print a profile on the front of a bottle."""
    level = _LEVEL.get(shape, 0.45) * sizes.height + rise
    half = sizes.width / 2.0
    if shape in _RUN:
        path = blown_path(shape, sizes) if clear else path_of(bottle_runs(shape, sizes)[_RUN[shape]])
        return details.wrapped(profile, path, level, material=ink, proud=proud)
    deep = half * sizes.depth
    if shape == "oval":  # the curvature of the front of an ellipse
        round_ = half * half / deep
        path = ag.line((round_, 0.0, 0.0), (round_, 0.0, sizes.height))
        film = details.wrap(profile, path, level, proud=proud).at(0.0, round_ - deep, 0.0)
        return ag.detail(film, "print", ink, reads=(1.0, 0.0, 0.0))
    front = half * math.cos(math.pi / 6.0) if shape == "hexagonal" else deep
    return details.printed(profile, (0.0, -front, level), material=ink, proud=proud)


def marks(
    kind: Print, content: Content, maker: str, *, shape: Shape, sizes: Sizes, ink: ag.Material, clear: bool
) -> list[ag.Body]:
    """Print a bottle."""
    words = WORDS[content]
    match kind:
        case "word":
            size = 0.0080 if max(map(len, words)) < 5 else 0.0066
            profile = details.lettering(words, size, tracking=0.25, leading=1.9)
            return [_printed(profile, shape, sizes, ink, clear=clear)]
        case "icon":
            small = details.lettering((" ".join(words),), 0.0032, tracking=0.3, fineness="coarse")
            return [
                _printed(details.icon(_ICONS[content], 0.018), shape, sizes, ink, clear=clear),
                _printed(small, shape, sizes, ink, clear=clear, rise=-0.0165),
            ]
        case "label":
            dark = ag.colored("abs", "anthracite")
            wide, high = 0.036, 0.044
            texts = (
                (details.logo(maker, 0.0026, tracking=0.2), 0.0155),
                (details.lettering(words, 0.0052, tracking=0.25, leading=1.8), 0.0030),
                (ag.rectangle(0.020, 0.0004), -0.0080),
                (details.lettering(("300 ML  10 FL OZ",), 0.0020, tracking=0.2, fineness="coarse"), -0.0150),
            )
            return [
                _paper(shape, sizes, wide, high),
                *(
                    _printed(profile, shape, sizes, dark, clear=clear, rise=rise, proud=0.0006)
                    for profile, rise in texts
                ),
            ]
        case _:
            return []


def _paper(shape: Shape, sizes: Sizes, wide: float, high: float) -> ag.Body:
    """Make the paper of a label, around a straight wall or on a flat one."""
    paper = ag.material("cardboard").with_(name="label_paper", base_color=(0.80, 0.78, 0.72), texture="")
    level, half = _LEVEL.get(shape, 0.45) * sizes.height, sizes.width / 2.0
    if shape in _RUN:
        angle = wide / half
        sheet = ag.revolve(ag.rectangle(0.0006, high).at(half, level), angle=angle)
        return ag.detail(sheet.rotate(ag.Z, -0.5 * (math.pi + angle)), "label", paper)
    front = half * sizes.depth
    sheet = ag.Region.between(
        (-0.5 * wide, -front - 0.0003, level - 0.5 * high), (0.5 * wide, -front + 0.0003, level + 0.5 * high)
    ).box()
    return ag.detail(sheet, "label", paper)
