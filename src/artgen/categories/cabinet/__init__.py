"""A cabinet: a carcass of boards with shelves behind one door or a pair.

The front faces -y. Doors on concealed hinges lie on the edges of the carcass; doors on butt hinges are
between its sides, flush with them. The doors of a pair have a gap of 3 mm between them.

Links: `body`; `door`, or `door_left` and `door_right`. Joints: `door_hinge`, with the same suffixes.

A wall cabinet is on the ground, as all assets are. Hinges of real cabinets close by themselves in the last
degrees; here friction represents this snap and holds a door at any angle.

Sizes are those of kitchen and storage furniture (DIN EN 1116, IKEA METOD and BESTA): width 30-60 cm with one
door and up to 120 cm with two; base cabinets 56-60 cm deep and 80-92 cm high with a worktop, wall cabinets
30-38 cm deep, tall cabinets up to 210 cm high.
"""

from functools import partial
from typing import Any, Literal

import artgen as ag
from artgen.categories.cabinet.doors import Hanging, HingeStyle
from artgen.categories.shared import require_suited
from artgen.categories.shared.finish import known
from artgen.categories.shared.fronts import FrontLook, FrontStyle
from artgen.categories.shared.furniture import (
    WHITE_BOARD,
    BoardLook,
    Carcass,
    LegStyle,
    Stand,
    boards,
    hardware,
    leg_finishes,
    worktops,
)
from artgen.categories.shared.pulls import bar_pull, cup_pull, edge_pull, knob_pull

_HANDLES = {"knob": knob_pull, "bar": bar_pull, "cup": cup_pull, "edge": edge_pull}
_GLASS = known("glass", "frosted_glass", "tinted_glass")
_CORNERS_MEET = (
    "the free corners of two doors that open together would collide: raise width, lower "
    "door_thickness, hinge=concealed or doors=1"
)
_FINISH = boards("wood", "lacquer", "melamine", "decor")
_WORKTOP, _LEG, _METAL = worktops(), leg_finishes(), hardware()


@ag.category(
    labels=(
        "body", "back", "shelf", "pin", "top", "plinth", "leg", "bracket", "door", "glass", "handle", "hinge",
        "bumper", "screw",
    ),
    joints=(1, 2),
)  # fmt: skip
def cabinet(
    *,
    kind: Literal["base", "wall", "tall"] = ag.choice("base", "wall", "tall", weights=(0.42, 0.28, 0.30)),
    look: BoardLook = ag.choice("wood", "lacquer", "melamine", "decor", weights=(0.34, 0.36, 0.16, 0.14)),
    style: FrontStyle = ag.by(
        "look",
        wood=ag.choice(
            "flat", "shaker", "ramped", "fielded", "glazed", weights=(0.22, 0.24, 0.18, 0.14, 0.22)
        ),
        lacquer=ag.choice(
            "flat", "shaker", "ramped", "fielded", "glazed", weights=(0.2, 0.3, 0.2, 0.08, 0.22)
        ),
        otherwise=ag.choice("flat", "shaker", weights=(0.85, 0.15)),
        doc="style of the doors",
    ),
    doors: int = ag.choice(1, 2),
    grip: Literal["knob", "bar", "cup", "edge"] = ag.by(
        "kind",
        tall=ag.choice("knob", "bar", weights=(0.4, 0.6)),
        otherwise=ag.choice("knob", "bar", "cup", "edge", weights=(0.3, 0.36, 0.14, 0.2)),
    ),
    hinge: HingeStyle = ag.by(
        "grip", edge="concealed", otherwise=ag.choice("concealed", "butt", weights=(0.62, 0.38))
    ),
    hand: Literal["left", "right"] = ag.choice("left", "right", doc="hinge side of a single door"),
    stand: Stand = ag.by(
        "kind",
        base=ag.choice("plinth", "legs", weights=(0.65, 0.35)),
        wall="brackets",
        tall=ag.choice("plinth", "legs", weights=(0.6, 0.4)),
    ),
    shelves: int = ag.by(
        "kind",
        base=ag.choice(0, 1, 2, weights=(0.2, 0.5, 0.3)),
        wall=ag.choice(1, 2, 3, weights=(0.4, 0.45, 0.15)),
        tall=ag.choice(3, 4, 5),
        doc="number of shelves behind the doors, without the bottom",
    ),
    shelf_kind: Literal["board", "glass"] = ag.by(
        "style", glazed=ag.choice("board", "glass"), otherwise="board"
    ),
    width: ag.Float = ag.by(
        "doors",
        {
            1: ag.uniform(0.30, 0.60),
            2: ag.by(
                "kind", base=ag.uniform(0.60, 1.20), wall=ag.uniform(0.60, 1.0), tall=ag.uniform(0.64, 1.10)
            ),
        },
        unit="m",
        within=(0.28, 1.3),
    ),
    depth: ag.Float = ag.by(
        "kind",
        base=ag.by("stand", plinth=ag.uniform(0.51, 0.56), otherwise=ag.uniform(0.36, 0.48)),
        wall=ag.uniform(0.29, 0.36),
        tall=ag.by("stand", plinth=ag.uniform(0.36, 0.56), otherwise=ag.uniform(0.36, 0.48)),
        unit="m",
        doc="width of the carcass",
        within=(0.25, 0.65),
    ),
    height: ag.Float = ag.by(
        "kind",
        base=ag.by("stand", plinth=ag.uniform(0.82, 0.92), otherwise=ag.uniform(0.72, 0.90)),
        wall=ag.uniform(0.60, 0.92),
        tall=ag.uniform(1.60, 2.10),
        unit="m",
        doc="overall height",
        within=(0.55, 2.2),
    ),
    stand_height: ag.Float = ag.by(
        "stand",
        plinth=ag.uniform(0.07, 0.12),
        legs=ag.uniform(0.12, 0.20),
        otherwise=0.0,
        unit="m",
        within=(0.0, 0.3),
    ),
    setback: ag.Float = ag.uniform(0.030, 0.060, "m", doc="setback of a plinth"),
    thickness: ag.Float = ag.uniform(0.016, 0.019, "m", doc="thickness of the boards"),
    door_thickness: ag.Float = ag.uniform(0.018, 0.021, "m", within=(0.016, 0.024)),
    rail: ag.Float = ag.uniform(0.052, 0.068, "m", doc="width of the stiles and rails of framed doors"),
    slope: ag.Float = ag.uniform(0.014, 0.026, "m", doc="width of the slope of ramped doors"),
    moulding: Literal["square", "ovolo", "ogee"] = ag.choice(
        "square", "ovolo", "ogee", weights=(0.6, 0.22, 0.18)
    ),
    panes: int = ag.choice(1, 2, 3, weights=(0.55, 0.25, 0.2), doc="panes in a column of a glazed door"),
    leg: LegStyle = ag.choice("tapered", "splayed", "square", "turned", "metal"),
    top: Literal["worktop", "flush"] = ag.by(
        "kind",
        base=ag.by(
            "stand",
            plinth=ag.choice("worktop", "flush", weights=(0.85, 0.15)),
            otherwise=ag.choice("worktop", "flush"),
        ),
        otherwise="flush",
    ),
    top_thickness: ag.Float = ag.uniform(0.018, 0.038, "m", doc="thickness of a worktop"),
    overhang: ag.Float = ag.uniform(0.004, 0.018, "m", doc="overhang of a worktop beyond the doors"),
    finish: ag.Material = _FINISH,
    shell: Literal["same", "white"] = ag.by(
        "hinge",
        butt="same",
        concealed=ag.by(
            "stand",
            plinth=ag.choice("same", "white", weights=(0.7, 0.3)),
            brackets=ag.choice("same", "white", weights=(0.75, 0.25)),
            otherwise="same",  # kitchens often have white carcasses, furniture does not
        ),
        doc="finish of the carcass",
    ),
    inside: Literal["same", "white"] = ag.by(
        "look",
        wood=ag.choice("same", "white", weights=(0.85, 0.15)),
        otherwise=ag.choice("same", "white"),
        doc="finish of back and shelves",
    ),
    worktop: ag.Material = _WORKTOP,
    leg_finish: ag.Material = _LEG,
    glass: ag.Material = ag.choice(*_GLASS, weights=(0.65, 0.25, 0.1)),
    metal: ag.Material = _METAL,
    handle: ag.Generator = ag.by("grip", _HANDLES),
    hinges: int = ag.by("kind", tall=ag.choice(3, 4), otherwise=2, doc="number of hinges of a door"),
    swing: ag.Float = ag.by(
        "hinge", concealed=ag.uniform(1.6, 2.2), butt=ag.uniform(1.6, 2.3), unit="rad", within=(0.5, 2.35)
    ),
    pull: ag.Float = ag.uniform(
        5.0, 9.0, "N", doc="pull at the edge of a door against the snap of its hinges"
    ),
    hinge_damping: ag.Float = ag.uniform(0.2, 0.8, "N m s/rad"),
) -> ag.Body:
    """Make a base, wall or tall cabinet with its doors shut: hinges, shelves, pulls."""
    ag.require(stand != "feet", "stand=feet is for drawers only: stand must be plinth, legs or brackets")
    require_suited(handle, "grip", grip, _HANDLES)
    if kind == "tall":
        height = ag.require(height, height >= 1.0, "height of a tall cabinet must be >= 1 m")
    ag.require(
        hinge == "concealed" or grip != "edge",
        "a door between the sides has no free edge: grip must not be edge, or hinge must be concealed",
    )
    slab = top_thickness if top == "worktop" else 0.0
    case = Carcass(
        width=width,
        low=stand_height,
        high=height - slab,
        front=-depth / 2,
        rear=depth / 2,
        thick=thickness,
        finish=WHITE_BOARD if shell == "white" else finish,
        inside=WHITE_BOARD if "white" in (inside, shell) else finish,
        foot=0.0 if stand == "plinth" else None,
    )
    on_top, on_bottom = grip == "edge" and kind != "wall", grip == "edge" and kind == "wall"
    hanging = Hanging(
        case,
        hinge,
        doors,
        door_thickness,
        _shares(hinges, shelves),
        above=0.004 if on_top else 0.0,
        below=0.004 if on_bottom else 0.0,
        metal=metal,
    )
    body = ag.weld(*case.bodies(), *case.standing(stand, setback=setback, leg=leg, finish=leg_finish))
    if top == "worktop":
        # space for fingers between an edge pull and the worktop
        before = case.front - hanging.face + (0.0 if on_top else overhang)
        body = ag.weld(body, case.worktop(top_thickness, worktop, before=before, beside=0.0))
    behind = 0.020 + (door_thickness if hanging.inset else 0.0)
    of_glass = shelf_kind == "glass"
    clear = (case.ceiling - case.floor) / (shelves + 1)
    levels = [case.floor + clear * (at + 1) - 0.5 * thickness for at in range(shelves)]
    body = ag.weld(
        body,
        *case.shelves(
            levels,
            thick=0.006 if of_glass else thickness,
            setback=behind,
            finish=ag.material("glass") if of_glass else case.inside,
        ),
    )

    rail = ag.min_(rail, 0.27 * hanging.width)  # stiles of a narrow door leave space for its panel
    look_ = FrontLook(style, finish, rail, moulding, slope, glass, (1, panes))
    hung = partial(hanging.joint, limit=swing, friction=pull * hanging.width, damping=hinge_damping)
    if doors == 1:
        body = ag.weld(body, *hanging.on_side())
        leaf = hanging.leaf(look_, _handled(hanging, kind, grip, handle, metal, rail, "door"), name="door")
        body = body.attach(leaf, hung("door_hinge"))
        return body.mirror(ag.X) if hand == "right" else body
    halves = [half for each in hanging.on_side() for half in (each, each.mirror(ag.X))]
    body = ag.weld(body, *halves)
    for side, name in ((1, "door_left"), (-1, "door_right")):
        leaf = hanging.leaf(look_, _handled(hanging, kind, grip, handle, metal, rail, name), name=name)
        joint = hung(f"{name.replace('door', 'door_hinge')}", side=side)
        body = body.attach(leaf if side > 0 else leaf.mirror(ag.X), joint)
    return body.require(hanging.pair_turns(), _CORNERS_MEET) if hanging.inset else body


def _shares(hinges: int, shelves: int) -> list[float]:
    """Return the positions of the hinges between the outermost ones, clear of the shelves."""
    shares = [index / (hinges - 1) for index in range(hinges)]
    taken = [(at + 1) / (shelves + 1) for at in range(shelves)]
    return [
        share + 0.07 if 0.0 < share < 1.0 and any(abs(share - each) < 0.05 for each in taken) else share
        for share in shares
    ]


def _handled(
    hanging: Hanging,
    kind: str,
    grip: str,
    handle: ag.Generator,
    metal: ag.Material,
    rail: ag.Scalar,
    name: str,
) -> ag.Body:
    """Make the handle of a door near its free edge, at the height of a hand."""
    # a bar is 0.155 m from the end of a door; on a tall door it is near the middle
    placed: dict[str, Any] = {}
    if grip == "bar":
        placed = {"level": False, "room": 0.92 if kind == "tall" else 0.31}
    elif handle == edge_pull:
        placed = {"room": hanging.width}
    pull: ag.Body = handle(finish=metal, name=f"{name}_handle", **placed)
    left, right = hanging.left, hanging.left + hanging.width
    low, high, face = hanging.low, hanging.high, hanging.face
    if grip == "edge":
        if kind == "wall":
            return pull.mirror(ag.Z).at((left + right) / 2, face, low)
        return pull.at((left + right) / 2, face, high)
    beside = ag.max_(0.5 * rail, 0.030)
    # distance from the end of the door; a cup lies on the rail
    reach = {"knob": 0.055, "bar": 0.155, "cup": 0.014 if kind == "wall" else 0.048}[grip]
    level = low + reach if kind == "wall" else high - reach if kind == "base" else ag.min_(high - 0.5, 1.02)
    return pull.at(right - (0.052 if grip == "cup" else beside), face, level)
