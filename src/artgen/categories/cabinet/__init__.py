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

from typing import Any, Literal

import artgen as ag
from artgen.categories.shared import furniture, require_suited
from artgen.categories.shared.finish import known
from artgen.categories.shared.fronts import FrontLook, FrontStyle
from artgen.categories.shared.furniture import WHITE_BOARD, Carcass
from artgen.categories.shared.hanging import Hanging, HingeStyle
from artgen.categories.shared.pulls import bar_pull, cup_pull, edge_pull, knob_pull

_HANDLES = {"knob": knob_pull, "bar": bar_pull, "cup": cup_pull, "edge": edge_pull}
_GLASS = known("glass", "frosted_glass", "tinted_glass")
_CORNERS_MEET = (
    "the free corners of two doors that open together would collide: raise width, lower "
    "door_thickness, hinge=concealed or doors=1"
)
_FINISH = furniture.boards("wood", "lacquer", "melamine", "decor")
_WORKTOP, _LEG, _METAL = furniture.worktops(), furniture.leg_finishes(), furniture.hardware()


_LABELS = "body back shelf pin top plinth leg bracket door glass handle hinge bumper screw"


@ag.category(labels=_LABELS, joints=(1, 2))
def cabinet(
    *,
    kind: Literal["base", "wall", "tall"] = ag.choice({"base": 0.42, "wall": 0.28, "tall": 0.30}),
    look: furniture.BoardLook = ag.choice({"wood": 0.34, "lacquer": 0.36, "melamine": 0.16, "decor": 0.14}),
    style: FrontStyle = ag.by(
        "look",
        wood={"flat": 0.22, "shaker": 0.24, "ramped": 0.18, "fielded": 0.14, "glazed": 0.22},
        lacquer={"flat": 0.2, "shaker": 0.3, "ramped": 0.2, "fielded": 0.08, "glazed": 0.22},
        otherwise={"flat": 0.85, "shaker": 0.15},
        doc="style of the doors",
    ),
    doors: int = ag.choice(1, 2),
    grip: Literal["knob", "bar", "cup", "edge"] = ag.by(
        "kind", tall={"knob": 0.4, "bar": 0.6}, otherwise={"knob": 0.3, "bar": 0.36, "cup": 0.14, "edge": 0.2}
    ),
    hinge: HingeStyle = ag.by("grip", edge="concealed", otherwise={"concealed": 0.62, "butt": 0.38}),
    hand: Literal["left", "right"] = ag.choice("left", "right", doc="hinge side of a single door"),
    stand: furniture.Stand = ag.by(
        "kind", base={"plinth": 0.65, "legs": 0.35}, wall="brackets", tall={"plinth": 0.6, "legs": 0.4}
    ),
    shelves: int = ag.by(
        "kind",
        base={0: 0.2, 1: 0.5, 2: 0.3},
        wall={1: 0.4, 2: 0.45, 3: 0.15},
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
    moulding: Literal["square", "ovolo", "ogee"] = ag.choice({"square": 0.6, "ovolo": 0.22, "ogee": 0.18}),
    panes: int = ag.choice({1: 0.55, 2: 0.25, 3: 0.2}, doc="panes in a column of a glazed door"),
    leg: furniture.LegStyle = ag.choice("tapered", "splayed", "square", "turned", "metal"),
    top: Literal["worktop", "flush", "rails"] = ag.by(
        "kind",
        base=ag.by("stand", plinth={"worktop": 0.85, "flush": 0.15}, otherwise=ag.choice("worktop", "flush")),
        otherwise="flush",
        doc="top; with rails, a unit without a back holds the sink of a room",
    ),
    top_thickness: ag.Float = ag.uniform(0.018, 0.038, "m", doc="thickness of a worktop"),
    overhang: ag.Float = ag.uniform(0.004, 0.018, "m", doc="overhang of a worktop beyond the doors"),
    finish: ag.Material = _FINISH,
    shell: Literal["same", "white"] = ag.by(
        "hinge",
        butt="same",
        concealed=ag.by(
            "stand",
            plinth={"same": 0.7, "white": 0.3},
            brackets={"same": 0.75, "white": 0.25},
            otherwise="same",  # kitchens often have white carcasses, furniture does not
        ),
        doc="finish of the carcass",
    ),
    inside: Literal["same", "white"] = ag.by(
        "look",
        wood={"same": 0.85, "white": 0.15},
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
    case = Carcass(
        width=width,
        low=stand_height,
        high=height - (top_thickness if top == "worktop" else 0.0),
        front=-depth / 2,
        rear=depth / 2,
        thick=thickness,
        finish=WHITE_BOARD if shell == "white" else finish,
        inside=WHITE_BOARD if "white" in (inside, shell) else finish,
        foot=0.0 if stand == "plinth" else None,
    )
    # space for an edge pull at the end of a door that a hand reaches
    room = 0.004 if grip == "edge" else 0.0
    above, below = (0.0, room) if kind == "wall" else (room, 0.0)
    shares = _shares(hinges, shelves)
    hanging = Hanging(case, hinge, doors, door_thickness, shares, above=above, below=below, metal=metal)
    door = hanging.region
    bodies = case.bodies(for_sink=top == "rails")
    bodies += case.standing(stand, setback=setback, leg=leg, finish=leg_finish)
    if top == "worktop":
        # space for fingers between an edge pull and the worktop
        before = case.front - door.y.low + (0.0 if above else overhang)
        bodies.append(case.worktop(top_thickness, worktop, before=before, beside=0.0))
    clear = (case.ceiling - case.floor) / (shelves + 1)
    levels = [case.floor + clear * (at + 1) - thickness / 2 for at in range(shelves)]
    board = (0.006, ag.material("glass")) if shelf_kind == "glass" else (thickness, case.inside)
    behind = 0.020 + (door_thickness if hanging.inset else 0.0)
    bodies += case.shelves(levels, thick=board[0], setback=behind, finish=board[1])
    on_side = hanging.on_side()
    body = ag.weld(*bodies, on_side, *([on_side.mirror(ag.X)] if doors == 2 else []))

    rail = ag.min_(rail, 0.27 * door.x.size)  # stiles of a narrow door leave space for its panel
    front = FrontLook(style, finish, rail, moulding, slope, glass, (1, panes))
    options: dict[str, Any] = {}
    if grip == "bar":  # 0.155 m from the end of a door; on a tall door it is near the middle
        options = {"level": False, "room": 0.92 if kind == "tall" else 0.31}
    elif handle == edge_pull:
        options = {"room": door.x.size}
    at = _handle_place(door, kind, grip, rail)
    for side, name in ((1, "door"),) if doors == 1 else ((1, "door_left"), (-1, "door_right")):
        held: ag.Body = handle(finish=metal, name=f"{name}_handle", **options)
        held = held.mirror(ag.Z) if below else held
        leaf = hanging.leaf(front, held.at(at), name=name)
        joint = hanging.joint(
            name.replace("door", "door_hinge"),
            side=side,
            limit=swing,
            friction=pull * door.x.size,
            damping=hinge_damping,
        )
        body = body.attach(leaf if side > 0 else leaf.mirror(ag.X), joint)
    if doors == 1:
        return body.mirror(ag.X) if hand == "right" else body
    return body.require(hanging.pair_turns(), _CORNERS_MEET) if hanging.inset else body


def _shares(hinges: int, shelves: int) -> list[float]:
    """Return the positions of the hinges between the outermost ones, clear of the shelves."""
    shares = [index / (hinges - 1) for index in range(hinges)]
    taken = [(at + 1) / (shelves + 1) for at in range(shelves)]
    return [
        share + 0.07 if 0.0 < share < 1.0 and any(abs(share - each) < 0.05 for each in taken) else share
        for share in shares
    ]


def _handle_place(door: ag.Region, kind: str, grip: str, rail: ag.Scalar) -> ag.VectorLike:
    """Return the place of a handle near the free edge of a door, at the height of a hand."""
    if grip == "edge":
        return door.anchor(y=-1, z=-1 if kind == "wall" else 1)
    # distance from the end of the door; a cup lies on the rail
    reach = {"knob": 0.055, "bar": 0.155, "cup": 0.014 if kind == "wall" else 0.048}[grip]
    beside = 0.052 if grip == "cup" else ag.max_(rail / 2, 0.030)
    low, high = door.z
    level = {"wall": low + reach, "base": high - reach, "tall": ag.min_(high - 0.5, 1.02)}[kind]
    return (door.x.high - beside, door.y.low, level)
