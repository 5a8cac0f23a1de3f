"""A piece of furniture with drawers: a chest, a bedside table, a filing cabinet or a kitchen drawer unit.

The front faces -y. Fronts lie on the edges of the carcass, or are between its boards, flush with them. Every
drawer is a box of boards on a pair of runners with a standard play of 12.5 mm at each side.

Links: `body` and `drawer_<n>`, row by row from the top left. Joints: `drawer_slide_<n>`.

The friction of the runners, 5-10 N, holds a drawer at any position. Soft runners draw it home over the last
40 mm, in 0.5-3 s, with 18-28 N less by two fifths when it is closed: telescopic slides with a damped self-
retraction do so over 40 mm with 35 N for a pair (catalog of Berger), and EN 15338 allows 50 N. Drawers come
out by up to three quarters of their depth, as on simple runners.

Sizes are those of furniture (IKEA MALM, HEMNES and MAXIMERA, Bisley and HON catalogs): chests 0.6-1.4 m wide
and 0.7-1.3 m high, bedside tables 0.4-0.55 m wide, filing cabinets 0.4-0.47 m wide with drawers 0.28-0.32 m
high for hanging files, kitchen units 0.4-1.4 m wide and 0.82-0.92 m high with a worktop.
"""

from functools import reduce
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.drawer import boxes
from artgen.categories.shared import furniture, require_suited
from artgen.categories.shared.fronts import FrontLook, FrontStyle
from artgen.categories.shared.pulls import bar_pull, cup_pull, groove_pull, knob_pull

_FINISH = furniture.boards("wood", "lacquer", "melamine", "decor", "steel")
_ACCENT, _WORKTOP = furniture.accents(), furniture.worktops()
_LEG, _METAL = furniture.leg_finishes(), furniture.hardware()
_HANDLES = {"knob": knob_pull, "bar": bar_pull, "cup": cup_pull, "groove": groove_pull}
_LEAST = 0.09  # least distance between neighboring drawers [m]
_HOME, _PRELOAD = 0.04, 0.6  # reach of a soft closing [m], and its force when it is closed over the greatest
_FRAMED = {"flat": 0.4, "beaded": 0.15, "shaker": 0.25, "ramped": 0.2}
_MOUNTED = {"overlay": 0.55, "inset": 0.45}
_SLABS = {"flat": 0.7, "beaded": 0.3}  # many framed fronts would need too many colliders
_CHEST_GRIPS = {"knob": 0.35, "bar": 0.25, "cup": 0.18, "groove": 0.22}


@ag.category(
    labels="body back top plinth leg foot drawer front runner handle label_holder lock cylinder print screw",
    joints=(1, 15),
)
def drawer(
    *,
    kind: Literal["chest", "bedside", "file", "kitchen"] = ag.choice(
        "chest", "bedside", "file", "kitchen", weights=(0.34, 0.22, 0.2, 0.24)
    ),
    look: furniture.CaseLook = ag.by(
        "kind",
        file="steel",
        kitchen={"wood": 0.25, "lacquer": 0.4, "melamine": 0.2, "decor": 0.15},
        otherwise={"wood": 0.5, "lacquer": 0.28, "melamine": 0.12, "decor": 0.1},
    ),
    rows: int = ag.by(
        "kind",
        chest={3: 0.35, 4: 0.35, 5: 0.3},
        bedside={1: 0.3, 2: 0.45, 3: 0.25},
        file=ag.choice(2, 3, 4),
        kitchen={2: 0.2, 3: 0.45, 4: 0.25, 5: 0.1},
    ),
    columns: int = ag.by(
        "kind",
        chest=ag.by("rows", {5: {1: 0.5, 2: 0.3, 3: 0.2}}, otherwise={1: 0.4, 2: 0.38, 3: 0.22}),
        bedside=1,
        file={1: 0.85, 2: 0.15},
        kitchen=ag.by("rows", {4: {1: 0.7, 2: 0.3}, 5: 1}, otherwise={1: 0.6, 2: 0.27, 3: 0.13}),
    ),
    mounting: boxes.Mounting = ag.by(
        "grip",
        groove="overlay",
        otherwise=ag.by(
            "kind",
            kitchen={"overlay": 0.85, "inset": 0.15},
            # each of the 15 drawers of a chest for herbs, cards or tools has a frame around it
            chest=ag.by("rows", {5: ag.by("columns", {3: "inset"}, otherwise=_MOUNTED)}, otherwise=_MOUNTED),
            otherwise=_MOUNTED,
        ),
        doc="mounting of the fronts: on the carcass or between its boards",
    ),
    style: FrontStyle = ag.by(
        "look",
        steel="flat",
        otherwise=ag.by(
            "grip",
            groove="flat",
            otherwise=ag.by(
                "columns",
                {1: _FRAMED, 2: ag.by("rows", {2: _FRAMED, 3: _FRAMED}, otherwise=_SLABS), 3: _SLABS},
            ),
        ),
        doc="style of the fronts",
    ),
    niche: bool = ag.by(
        "kind",
        bedside=ag.by("rows", {1: ag.choice(False, True), 2: {False: 0.7, True: 0.3}}, otherwise=False),
        otherwise=False,
        doc="whether there is an open compartment under the drawers",
    ),
    stand: Literal["plinth", "legs", "feet"] = ag.by(
        "kind",
        chest={"plinth": 0.4, "legs": 0.6},
        bedside=ag.by(
            "rows",
            {1: ag.by("niche", {True: ag.choice("plinth", "legs"), False: "legs"})},
            otherwise={"plinth": 0.35, "legs": 0.65},
        ),
        file="feet",
        kitchen="plinth",
    ),
    width: ag.Float = ag.by(
        "kind",
        chest=ag.by(
            "columns", {1: ag.uniform(0.60, 0.90), 2: ag.uniform(0.85, 1.30), 3: ag.uniform(1.15, 1.40)}
        ),
        bedside=ag.uniform(0.40, 0.55),
        file=ag.by("columns", {1: ag.uniform(0.40, 0.47), 2: ag.uniform(0.80, 0.92)}),
        kitchen=ag.by(
            "columns", {1: ag.uniform(0.40, 0.90), 2: ag.uniform(0.80, 1.20), 3: ag.uniform(1.20, 1.40)}
        ),
        unit="m",
        within=(0.38, 1.5),
    ),
    depth: ag.Float = ag.by(
        "kind",
        chest=ag.uniform(0.40, 0.52),
        bedside=ag.uniform(0.35, 0.44),
        file=ag.uniform(0.50, 0.58),
        kitchen=ag.uniform(0.51, 0.56),
        unit="m",
        doc="width of the carcass",
        within=(0.33, 0.62),
    ),
    height: ag.Float = ag.by(
        "kind",
        chest=ag.by(
            "rows", {3: ag.uniform(0.70, 0.86), 4: ag.uniform(0.84, 1.06), 5: ag.uniform(1.02, 1.28)}
        ),
        bedside=ag.by(
            "rows",
            {
                1: ag.uniform(0.42, 0.54),
                2: ag.by("niche", {True: ag.uniform(0.57, 0.66), False: ag.uniform(0.46, 0.62)}),
                3: ag.uniform(0.55, 0.68),
            },
        ),
        file=ag.by("rows", {2: ag.uniform(0.66, 0.73), 3: ag.uniform(0.95, 1.04), 4: ag.uniform(1.24, 1.30)}),
        kitchen=ag.uniform(0.82, 0.92),
        unit="m",
        doc="overall height",
        within=(0.41, 1.4),
    ),
    stand_height: ag.Float = ag.by(
        "stand",
        plinth=ag.uniform(0.06, 0.11),
        feet=ag.uniform(0.008, 0.014),
        legs=ag.by(
            "kind",
            bedside=ag.by(
                "rows",
                {1: ag.by("niche", {True: ag.uniform(0.10, 0.16), False: ag.uniform(0.22, 0.27)})},
                otherwise=ag.uniform(0.10, 0.16),
            ),
            otherwise=ag.uniform(0.09, 0.17),
        ),
        unit="m",
        within=(0.005, 0.35),
    ),
    top_share: ag.Float = ag.by(
        "kind",
        kitchen=ag.by(
            "rows", {2: ag.uniform(0.45, 1.0), 3: ag.uniform(0.45, 0.62)}, otherwise=ag.uniform(0.7, 1.0)
        ),
        chest=ag.uniform(0.72, 1.0),
        otherwise=1.0,
        doc="height of the top row, as a share of that of the second row",
    ),
    growth: ag.Float = ag.by(
        "kind", chest=ag.uniform(1.0, 1.14), otherwise=1.0, doc="additional height of each further row"
    ),
    setback: ag.Float = ag.by(
        "kind",
        kitchen=ag.uniform(0.04, 0.06),
        otherwise=ag.uniform(0.004, 0.03),
        unit="m",
        doc="setback of a plinth",
    ),
    thickness: ag.Float = ag.by(
        "look",
        steel=ag.uniform(0.012, 0.015),
        otherwise=ag.uniform(0.016, 0.020),
        unit="m",
        doc="thickness of the boards",
    ),
    front_thickness: ag.Float = ag.by(
        "grip",
        groove=ag.uniform(0.0215, 0.0235),
        otherwise=ag.uniform(0.017, 0.021),
        unit="m",
        within=(0.016, 0.025),
    ),
    rail: ag.Float = ag.uniform(0.034, 0.046, "m", doc="width of the frames of framed fronts"),
    slope: ag.Float = ag.uniform(0.010, 0.018, "m", doc="width of the slope of ramped fronts"),
    leg: furniture.LegStyle = ag.choice("tapered", "splayed", "square", "turned", "metal"),
    top: Literal["worktop", "over", "flush"] = ag.by(
        "kind", kitchen="worktop", file="flush", otherwise=ag.choice("over", "flush")
    ),
    top_thickness: ag.Float = ag.by(
        "top", worktop=ag.uniform(0.018, 0.038), otherwise=ag.uniform(0.014, 0.024), unit="m"
    ),
    overhang: ag.Float = ag.uniform(
        0.004, 0.016, "m", doc="overhang of a top beyond the fronts, and beyond the sides of furniture"
    ),
    finish: ag.Material = _FINISH,
    fronts: Literal["same", "painted", "wood"] = ag.by(
        "kind",
        file="same",
        kitchen="same",
        otherwise=ag.by(
            "look",
            wood={"same": 0.75, "painted": 0.25},
            lacquer={"same": 0.75, "wood": 0.25},
            otherwise="same",
        ),
        doc="finish of the fronts",
    ),
    accent: ag.Material = _ACCENT,
    shell: Literal["same", "white"] = ag.by(
        "kind",
        kitchen=ag.by("mounting", overlay=ag.choice("same", "white"), inset="same"),
        otherwise="same",
        doc="finish of the carcass",
    ),
    worktop: ag.Material = _WORKTOP,
    leg_finish: ag.Material = _LEG,
    box: Literal["ply", "white", "same", "steel"] = ag.by(
        "kind",
        file="steel",
        kitchen={"ply": 0.25, "white": 0.4, "steel": 0.35},
        otherwise={"ply": 0.6, "white": 0.2, "same": 0.2},
        doc="material of the drawer boxes",
    ),
    runner: boxes.RunnerStyle = ag.by("kind", file="ball", otherwise=ag.choice("roller", "ball")),
    metal: ag.Material = _METAL,
    grip: Literal["knob", "bar", "cup", "groove"] = ag.by(
        "kind",
        file={"bar": 0.75, "cup": 0.25},
        chest=ag.by(
            "columns",
            {
                1: _CHEST_GRIPS,
                2: ag.by("rows", {5: ag.choice("knob", "groove")}, otherwise=_CHEST_GRIPS),
                3: "knob",
            },
        ),
        bedside={"knob": 0.42, "bar": 0.2, "cup": 0.14, "groove": 0.24},
        kitchen=ag.by(
            "columns",
            {3: {"knob": 0.3, "bar": 0.5, "cup": 0.2}},
            otherwise={"knob": 0.15, "bar": 0.4, "cup": 0.2, "groove": 0.25},
        ),
    ),
    handle: ag.Generator = ag.by("grip", _HANDLES),
    handles: int = ag.by(
        "kind",
        chest=ag.by("columns", {1: {1: 0.25, 2: 0.75}}, otherwise=1),
        otherwise=1,
        doc="number of handles on a drawer",
    ),
    handle_level: ag.Float = ag.by(
        "kind",
        file=ag.uniform(0.55, 0.68),
        kitchen=ag.uniform(0.55, 0.78),
        otherwise=ag.uniform(0.48, 0.60),
        doc="height of handles, as a share of that of the front",
    ),
    first_index: int = ag.by("kind", file=ag.count(0, 7), otherwise=0, doc="card in the first label holder"),
    locked: bool = ag.by(
        "kind", file={True: 0.8, False: 0.2}, otherwise=False, doc="whether there is a lock"
    ),
    slide_share: ag.Float = ag.uniform(0.60, 0.75, doc="travel, as a share of the depth", within=(0.2, 0.8)),
    slide_friction: ag.Float = ag.by(
        "runner",
        roller=ag.uniform(6.0, 10.0),
        ball=ag.uniform(5.0, 8.0),
        unit="N",
        doc="friction of a pair of runners",
    ),
    slide_damping: ag.Float = ag.uniform(4.0, 12.0, "N s/m"),
    soft: bool = ag.by(
        "runner",
        ball=ag.by("kind", kitchen={True: 0.75, False: 0.25}, file=False, otherwise={True: 0.3, False: 0.7}),
        roller=False,
        doc="whether runners draw the drawers home softly",
    ),
    soft_force: ag.Float = ag.uniform(18.0, 28.0, "N", doc="greatest force that draws a drawer home"),
    soft_damping: ag.Float = ag.uniform(260.0, 380.0, "N s/m", doc="damping on the last 40 mm"),
) -> ag.Body:
    """Make a chest, bedside table, filing cabinet or kitchen drawer unit, with its drawers shut."""
    require_suited(handle, "grip", grip, _HANDLES)
    ag.require(
        style not in ("fielded", "glazed"), f"style={style} is for doors: no handle of a drawer fits it"
    )
    slab = 0.0 if top == "flush" else top_thickness
    height = ag.require(
        height,
        (height - stand_height - slab) * (0.58 if niche else 1.0) > _LEAST * rows,
        f"each drawer must be >= {_LEAST:g} m high: raise height, or lower rows or stand_height",
    )
    case = furniture.Carcass(
        width=width,
        low=stand_height,
        high=height - slab,
        front=-depth / 2,
        rear=depth / 2,
        thick=thickness,
        finish=furniture.WHITE_BOARD if shell == "white" else finish,
        inside=furniture.WHITE_BOARD if kind == "kitchen" else finish,
        foot=0.0 if stand == "plinth" else None,
    )
    dress = finish if fronts == "same" else accent
    stock = {
        "ply": furniture.PLY,
        "white": furniture.WHITE_BOARD,
        "same": dress,
        "steel": furniture.GREY_STEEL,
    }
    made = boxes.Boxes(
        sides=stock[box],
        bottom=furniture.HARDBOARD if box == "white" else stock[box],
        wall=0.009 if box == "steel" else 0.013,
        runner=runner,
        tallest=0.25 if kind == "file" else 0.19,
        solid=rows * columns <= 4,
    )
    deck = case.floor + 0.42 * (case.ceiling - case.floor) if niche else None
    weights: list[ag.Scalar] = [top_share, *(growth**at for at in range(rows - 1))]
    groove = grip == "groove"
    bays = boxes.Bays(case, made, mounting, columns, weights, front_thickness, groove=groove, deck=deck)
    body = ag.weld(
        *case.bodies(),
        *bays.between(),
        *([] if deck is None else [case.deck(deck)]),
        *bays.fixed_members(),
        *case.standing(stand, setback=setback, leg=leg, finish=leg_finish),
    )
    if top != "flush":
        before, beside = case.front - bays.face + overhang, overhang if top == "over" else 0.0
        material = worktop if top == "worktop" else finish
        body = ag.weld(body, case.worktop(slab, material, before=before, beside=beside))

    # space for a hand between the rails of the lowest front
    slim = reduce(ag.min_, (0.25 * places[0].z.size for places in bays.fronts), rail)
    framing = FrontLook(style, dress, slim, "square", slope, ag.material("glass"))
    closing = None
    if soft:
        closing = feel.soft_closing(
            _HOME, preload=_PRELOAD * soft_force, force=soft_force, damping=soft_damping
        )
    for row, places in enumerate(bays.fronts):
        inner, tall = bays.box(row), places[0].z.size
        level = handle_level * tall
        if framing.framed:
            level = ag.min_(level, tall - slim - 0.031)
        for column, place in enumerate(places):
            number, wide = row * columns + column, place.x.size
            if groove:
                end = 1 if column == columns - 1 else -1
                sizes = {"length": wide, "thick": front_thickness, "front": dress, "end": end}
                fixtures = [handle(finish=metal, name="drawer_handle", **sizes).at(z=tall)]
            else:
                ends = {"": 0.0} if handles == 1 else {"_left": -0.28 * wide, "_right": 0.28 * wide}
                room = {"room": wide if handles == 1 else 0.44 * wide} if grip == "bar" else {}
                fixtures = [
                    handle(finish=metal, name=f"drawer_handle{end}", **room).at(
                        x, framing.sunk(front_thickness), level
                    )
                    for end, x in ends.items()
                ]
            if kind == "file":
                index = boxes.INDEXES[(first_index + number) % len(boxes.INDEXES)]
                fixtures += boxes.label_holder(level + 0.058, metal, index)
            if locked and number == 0:
                fixtures += boxes.lock(wide / 2 - 0.032, tall - 0.032)
            one = bays.drawer(row, column, framing, inner, fixtures).suffixed(f"_{number}")
            slide = bays.slide(
                row,
                column,
                share=slide_share,
                friction=slide_friction,
                damping=slide_damping,
                closing=closing,
            )
            body = body.attach(one, slide, at=(bays.middles[column], 0, place.z.low))
    return body
