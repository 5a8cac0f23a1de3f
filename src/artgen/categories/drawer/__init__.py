"""A piece of furniture with drawers: a chest, a bedside table, a filing cabinet or a kitchen drawer unit.

The front faces -y. Fronts lie on the edges of the carcass, or are between its boards, flush with them. Every
drawer is a box of boards on a pair of runners with a standard play of 12.5 mm at each side.

Links: `body` and `drawer_<n>`, row by row from the top left. Joints: `drawer_slide_<n>`.

The friction of the runners, 5-10 N, holds a drawer at any position. Drawers come out by up to three quarters
of their depth, as on simple runners.

Sizes are those of furniture (IKEA MALM, HEMNES and MAXIMERA, Bisley and HON catalogs): chests 0.6-1.4 m wide
and 0.7-1.3 m high, bedside tables 0.4-0.55 m wide, filing cabinets 0.4-0.47 m wide with drawers 0.28-0.32 m
high for hanging files, kitchen units 0.4-1.4 m wide and 0.82-0.92 m high with a worktop.
"""

from functools import reduce
from typing import Literal

import artgen as ag
from artgen.categories.drawer.boxes import (
    INDEXES,
    BoxLook,
    Mounting,
    Rows,
    RunnerStyle,
    drawer_box,
    fixed_members,
    label_holder,
    lock,
    slide,
)
from artgen.categories.drawer.boxes import drawer as drawer_of
from artgen.categories.shared import require_suited
from artgen.categories.shared.fronts import FrontLook, FrontStyle
from artgen.categories.shared.furniture import (
    GREY_STEEL,
    HARDBOARD,
    PLY,
    WHITE_BOARD,
    Carcass,
    CaseLook,
    LegStyle,
    accents,
    boards,
    hardware,
    leg_finishes,
    worktops,
)
from artgen.categories.shared.pulls import bar_pull, cup_pull, groove_pull, knob_pull

_FINISH, _ACCENT = boards("wood", "lacquer", "melamine", "decor", "steel"), accents()
_WORKTOP, _LEG, _METAL = worktops(), leg_finishes(), hardware()
_HANDLES = {"knob": knob_pull, "bar": bar_pull, "cup": cup_pull, "groove": groove_pull}
_LEAST = 0.09  # least distance between neighboring drawers [m]
_FRAMED = ag.choice("flat", "beaded", "shaker", "ramped", weights=(0.4, 0.15, 0.25, 0.2))
_MOUNTED = ag.choice("overlay", "inset", weights=(0.55, 0.45))
_SLABS = ag.choice("flat", "beaded", weights=(0.7, 0.3))  # many framed fronts would need too many colliders


@ag.category(
    labels=(
        "body", "back", "top", "plinth", "leg", "foot", "drawer", "front", "runner", "handle", "label_holder",
        "lock", "cylinder", "print", "screw",
    ),
    joints=(1, 15),
)  # fmt: skip
def drawer(
    *,
    kind: Literal["chest", "bedside", "file", "kitchen"] = ag.choice(
        "chest", "bedside", "file", "kitchen", weights=(0.34, 0.22, 0.2, 0.24)
    ),
    look: CaseLook = ag.by(
        "kind",
        file="steel",
        kitchen=ag.choice("wood", "lacquer", "melamine", "decor", weights=(0.25, 0.4, 0.2, 0.15)),
        otherwise=ag.choice("wood", "lacquer", "melamine", "decor", weights=(0.5, 0.28, 0.12, 0.1)),
    ),
    rows: int = ag.by(
        "kind",
        chest=ag.choice(3, 4, 5, weights=(0.35, 0.35, 0.3)),
        bedside=ag.choice(1, 2, 3, weights=(0.3, 0.45, 0.25)),
        file=ag.choice(2, 3, 4),
        kitchen=ag.choice(2, 3, 4, 5, weights=(0.2, 0.45, 0.25, 0.1)),
    ),
    columns: int = ag.by(
        "kind",
        chest=ag.by(
            "rows",
            {5: ag.choice(1, 2, 3, weights=(0.5, 0.3, 0.2))},
            otherwise=ag.choice(1, 2, 3, weights=(0.4, 0.38, 0.22)),
        ),
        bedside=1,
        file=ag.choice(1, 2, weights=(0.85, 0.15)),
        kitchen=ag.by(
            "rows",
            {4: ag.choice(1, 2, weights=(0.7, 0.3)), 5: 1},
            otherwise=ag.choice(1, 2, 3, weights=(0.6, 0.27, 0.13)),
        ),
    ),
    mounting: Mounting = ag.by(
        "grip",
        groove="overlay",
        otherwise=ag.by(
            "kind",
            kitchen=ag.choice("overlay", "inset", weights=(0.85, 0.15)),
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
        bedside=ag.by(
            "rows",
            {1: ag.choice(False, True), 2: ag.choice(False, True, weights=(0.7, 0.3))},
            otherwise=False,
        ),
        otherwise=False,
        doc="whether there is an open compartment under the drawers",
    ),
    stand: Literal["plinth", "legs", "feet"] = ag.by(
        "kind",
        chest=ag.choice("plinth", "legs", weights=(0.4, 0.6)),
        bedside=ag.by(
            "rows",
            {1: ag.by("niche", {True: ag.choice("plinth", "legs"), False: "legs"})},
            otherwise=ag.choice("plinth", "legs", weights=(0.35, 0.65)),
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
        within=(0.38, 1.4),
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
    leg: LegStyle = ag.choice("tapered", "splayed", "square", "turned", "metal"),
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
            wood=ag.choice("same", "painted", weights=(0.75, 0.25)),
            lacquer=ag.choice("same", "wood", weights=(0.75, 0.25)),
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
        kitchen=ag.choice("ply", "white", "steel", weights=(0.25, 0.4, 0.35)),
        otherwise=ag.choice("ply", "white", "same", weights=(0.6, 0.2, 0.2)),
        doc="material of the drawer boxes",
    ),
    runner: RunnerStyle = ag.by("kind", file="ball", otherwise=ag.choice("roller", "ball")),
    metal: ag.Material = _METAL,
    grip: Literal["knob", "bar", "cup", "groove"] = ag.by(
        "kind",
        file=ag.choice("bar", "cup", weights=(0.75, 0.25)),
        chest=ag.by(
            "columns",
            {
                1: ag.choice("knob", "bar", "cup", "groove", weights=(0.35, 0.25, 0.18, 0.22)),
                2: ag.by(
                    "rows",
                    {5: ag.choice("knob", "groove")},
                    otherwise=ag.choice("knob", "bar", "cup", "groove", weights=(0.35, 0.25, 0.18, 0.22)),
                ),
                3: "knob",
            },
        ),
        bedside=ag.choice("knob", "bar", "cup", "groove", weights=(0.42, 0.2, 0.14, 0.24)),
        kitchen=ag.by(
            "columns",
            {3: ag.choice("knob", "bar", "cup", weights=(0.3, 0.5, 0.2))},
            otherwise=ag.choice("knob", "bar", "cup", "groove", weights=(0.15, 0.4, 0.2, 0.25)),
        ),
    ),
    handle: ag.Generator = ag.by("grip", _HANDLES),
    handles: int = ag.by(
        "kind",
        chest=ag.by("columns", {1: ag.choice(1, 2, weights=(0.25, 0.75))}, otherwise=1),
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
        "kind",
        file=ag.choice(True, False, weights=(0.8, 0.2)),
        otherwise=False,
        doc="whether there is a lock",
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
) -> ag.Body:
    """Make a chest, bedside table, filing cabinet or kitchen drawer unit, with its drawers shut."""
    require_suited(handle, "grip", grip, _HANDLES)
    ag.require(
        style not in ("fielded", "glazed"), f"style={style} is for doors: no handle of a drawer fits it"
    )
    slab = 0.0 if top == "flush" else top_thickness
    height = ag.require(
        height,
        height - stand_height - slab > _LEAST * rows,
        f"each drawer must be >= {_LEAST:g} m high: raise height, or lower rows or stand_height",
    )
    case = Carcass(
        width=width,
        low=stand_height,
        high=height - slab,
        front=-depth / 2,
        rear=depth / 2,
        thick=thickness,
        finish=WHITE_BOARD if shell == "white" else finish,
        inside=WHITE_BOARD if kind == "kitchen" else finish,
        foot=0.0 if stand == "plinth" else None,
    )
    shelf = case.floor + 0.42 * (case.ceiling - case.floor)
    weights: list[ag.Scalar] = [top_share, *(growth**at for at in range(rows - 1))]
    bays = Rows(case, mounting, columns, weights, front_thickness, grip == "groove", shelf if niche else None)
    dress = finish if fronts == "same" else accent
    sides = {"ply": PLY, "white": WHITE_BOARD, "same": dress, "steel": GREY_STEEL}[box]
    boxes = BoxLook(
        sides,
        HARDBOARD if box == "white" else sides,
        wall=0.009 if box == "steel" else 0.013,
        floor=0.006,
        runner=runner,
        tallest=0.25 if kind == "file" else 0.19,
        solid=rows * columns <= 4,
    )
    body = ag.weld(
        *case.bodies(),
        *bays.between(solid=boxes.solid),
        *([case.deck(shelf)] if niche else []),
        *fixed_members(bays, boxes),
        *case.standing(stand, setback=setback, leg=leg, finish=leg_finish),
    )
    if top != "flush":
        before = case.front - bays.face + overhang
        beside = overhang if top == "over" else 0.0
        body = ag.weld(
            body, case.worktop(slab, worktop if top == "worktop" else finish, before=before, beside=beside)
        )

    # space for a hand between the rails of the lowest front
    slim = reduce(ag.min_, (0.25 * (high - low) for low, high in bays.spans), rail)
    look_ = FrontLook(style, dress, slim, "square", slope, ag.material("glass"))
    for row, (low, high) in enumerate(bays.spans):
        made, tall = drawer_box(bays, row, boxes), high - low
        level = handle_level * tall
        if look_.framed:
            level = ag.min_(level, tall - slim - 0.031)
        for column, middle in enumerate(bays.middles):
            left, right = bays.outer(column)
            number, wide = row * columns + column, right - left
            if grip == "groove":
                end = 1 if column == columns - 1 else -1
                edge = handle(
                    length=wide,
                    thick=front_thickness,
                    front=dress,
                    finish=metal,
                    end=end,
                    name="drawer_handle",
                )
                on_front = [edge.at(0.0, 0.0, tall)]
            else:
                ends = {"": 0.0} if handles == 1 else {"_left": -0.28 * wide, "_right": 0.28 * wide}
                at = (look_.sunk(front_thickness), level)
                room = {"room": wide if handles == 1 else 0.44 * wide} if grip == "bar" else {}
                on_front = [
                    handle(finish=metal, name=f"drawer_handle{end}", **room).at(x, *at)
                    for end, x in ends.items()
                ]
            if kind == "file":
                index = INDEXES[(first_index + number) % len(INDEXES)]
                on_front += label_holder(z=level + 0.058, finish=metal, index=index)
            if locked and number == 0:
                on_front += lock(x=wide / 2 - 0.032, z=tall - 0.032, finish=ag.material("chrome"))
            body = body.attach(
                drawer_of(bays, row, column, look_, made, on_front)
                .suffixed(f"_{number}")
                .at(middle, 0.0, low),
                slide(bays, row, column, share=slide_share, friction=slide_friction, damping=slide_damping),
            )
    return body
