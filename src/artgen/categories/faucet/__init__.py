"""A faucet on a sample deck or in front of a wall board, as in a shop: its spout turns, its handles open.

Links: `deck`, with the body; `spout`; `handle` of a mixer, or `handle_left` (hot) and `handle_right` (cold);
`spray_head` on its hose; `lift_rod`, `pivot_rod` and `plug` of a pop-up drain. Joints: `spout_swivel`;
`handle_turn` and `handle_lift`, both between the same links, or `handle_turn_left` and `handle_turn_right`;
`spray_head_slide`; `lift_rod_slide`, and `pivot_rod_turn` and `plug_slide`, which follow it.

A single lever turns to both sides for hot and cold and is lifted to open. A pair of handles is shut at 0 and
turns by a quarter; levers then point to the front. The weight on its hose draws a spray head back. A lift rod
comes with its drain, in a piece of a vanity top on a stand: lifted, the rod turns the pivot rod under the
slab, which lowers the plug. With `style="wall"` and `stand="none"` it hangs on the wall of a room.

Sizes are those of shops: valves 0.2 m apart (8 inches, ASME A112.18.1), spouts with a reach of 0.10-0.25 m
and an outlet 0.08-0.30 m above the deck, aerators M22 and M24, ceramic discs with 0.3-0.8 N m of friction.
"""

import functools
from typing import Literal

import artgen as ag
from artgen.categories.shared import taps
from artgen.categories.shared.finish import casting
from artgen.categories.shared.taps import drain, handles, spouts, stands

Style = Literal["widespread", "single_hole", "bridge", "wall", "vessel", "gooseneck", "pull_down"]
Stand = Literal["board", "none"]
"""A sample deck or board, or the wall of a room."""

_METALS = {"satin_brass": 1.2, "brass": 0.8, "satin_nickel": 2.0, "powder_coat_black": 1.8,
           "aged_bronze": 0.8, "chrome": 3.0, "stainless": 1.0}  # fmt: skip
_SHEET = casting(ag.material("stainless_blasted"), 0.14)  # density for a sheet around a board
_DECKS: dict[ag.Material | str, float] = {_SHEET: 0.6, "green_marble": 0.5, "marble": 1.2, "oak": 1.0,
    "black_granite": 1.2, "granite": 1.0, "walnut": 1.0}  # fmt: skip
_STYLES = {"vessel": 0.15, "bridge": 0.11, "single_hole": 0.10, "wall": 0.12, "widespread": 0.16,
           "gooseneck": 0.16, "pull_down": 0.20}  # fmt: skip
_METAL_WEIGHTS, _DECK_WEIGHTS = tuple(_METALS.values()), tuple(_DECKS.values())


@ag.category(
    labels="deck foot screw escutcheon body valve collar handle index spout aerator spray_head hose guide "
    "lift_rod strap pivot_rod drain plug",
    joints=(3, 6),
)
def faucet(
    *,
    style: Style = ag.choice(_STYLES),
    spout: spouts.SpoutStyle = ag.by(
        "style",
        widespread={"gooseneck": 0.3, "arc": 0.4, "angular": 0.3},
        bridge={"gooseneck": 0.7, "angular": 0.3},
        wall={"gooseneck": 0.45, "low": 0.55},
        single_hole="beam",
        vessel="beam",
        otherwise="gooseneck",
    ),
    height: ag.Float = ag.by(
        "style",
        widespread=ag.by(
            "spout",
            gooseneck=ag.uniform(0.20, 0.30),
            arc=ag.uniform(0.145, 0.20),
            otherwise=ag.uniform(0.145, 0.22),
        ),
        bridge=ag.uniform(0.30, 0.40),
        wall=ag.uniform(0.24, 0.29),
        single_hole=ag.uniform(0.062, 0.095),
        vessel=ag.uniform(0.17, 0.25),
        gooseneck=ag.uniform(0.32, 0.44),
        pull_down=ag.uniform(0.40, 0.45),
        unit="m",
        doc="height of the spout above the deck or wall bar, or of the column under a straight spout",
        within=(0.05, 0.45),
    ),
    reach: ag.Float = ag.by(
        "style",
        widespread=ag.uniform(0.11, 0.16),
        single_hole=ag.uniform(0.115, 0.15),
        vessel=ag.uniform(0.12, 0.18),
        bridge=ag.uniform(0.17, 0.22),
        wall=ag.uniform(0.15, 0.22),
        otherwise=ag.uniform(0.18, 0.22),
        unit="m",
        doc="reach of the spout from its axis",
        within=(0.08, 0.26),
    ),
    girth: ag.Float = ag.by(
        "style",
        widespread=ag.uniform(0.0095, 0.0125),
        pull_down=ag.uniform(0.0125, 0.0145),
        otherwise=ag.uniform(0.0105, 0.0135),
        unit="m",
        doc="radius of the spout's tube",
        within=(0.009, 0.016),
    ),
    body_radius: ag.Float = ag.uniform(
        0.0215, 0.0265, "m", doc="column radius of a mixer", within=(0.02, 0.03)
    ),
    square: bool = ag.choice(False, True, doc="whether a straight spout is flat"),
    swivel_limit: ag.Float = ag.by(
        "style",
        single_hole=ag.uniform(1.57, 2.1),  # clear of the rod behind it
        wall=ag.uniform(1.57, 1.75),  # clear of the wall
        otherwise=ag.uniform(1.57, 3.14),
        unit="rad",
        doc="turn of the spout to each side",
        within=(0.5, 3.14),
    ),
    handle: handles.HandleStyle = ag.choice(
        {"lever": 0.35, "blade": 0.25, "cross": 0.25, "knob": 0.15}, doc="style of a pair of handles"
    ),
    lever: handles.LeverStyle = ag.choice("rod", "blade", "paddle", doc="lever style of a mixer"),
    handle_length: ag.Float = ag.uniform(
        0.058, 0.076, "m", doc="length of a pair of handles, from the axis", within=(0.045, 0.09)
    ),
    lever_length: ag.Float = ag.by(
        "style",
        single_hole=ag.uniform(0.078, 0.100),
        vessel=ag.uniform(0.078, 0.100),
        otherwise=ag.uniform(0.085, 0.115),
        unit="m",
        doc="length of the lever of a mixer, from the axis",
        within=(0.07, 0.14),
    ),
    side: Literal["left", "right"] = ag.choice({"right": 0.8, "left": 0.2}, doc="side of the lever"),
    lift: ag.Float = ag.uniform(0.42, 0.50, "rad", doc="angle of the lifted lever", within=(0.3, 0.55)),
    rod: bool = ag.by(
        "style",
        widespread=ag.choice(True, False),
        single_hole=ag.choice(True, False),
        otherwise=False,
        doc="whether there is a pop-up drain with a lift rod",
    ),
    finish: ag.Material = ag.shades(*_METALS, weights=_METAL_WEIGHTS, color=0.03, roughness=0.03),
    accent: Literal["same", "ceramic"] = ag.choice(
        {"same": 0.6, "ceramic": 0.4}, doc="material of the buttons on a pair of handles"
    ),
    surface: ag.Material = ag.shades(
        *_DECKS, weights=_DECK_WEIGHTS, color=0.06, doc="finish of deck or wall"
    ),
    deck_margin: ag.Float = ag.uniform(
        0.045, 0.075, "m", doc="width of the deck around the parts on it", within=(0.035, 0.12)
    ),
    deck_thickness: ag.Float = ag.uniform(0.020, 0.030, "m", within=(0.020, 0.05)),
    swivel_friction: ag.Float = ag.uniform(0.6, 1.4, "N m", doc="friction of the seals", within=(0.2, 4.0)),
    handle_friction: ag.Float = ag.uniform(
        0.35, 0.75, "N m", doc="friction of ceramic discs", within=(0.1, 2.0)
    ),
    head_travel: ag.Float = ag.uniform(0.050, 0.075, "m", doc="travel of a spray head", within=(0.03, 0.09)),
    head_force: ag.Float = ag.uniform(9.0, 14.0, "N", doc="return force of the head", within=(5.0, 30.0)),
    rod_friction: ag.Float = ag.uniform(5.0, 9.0, "N"),
    stand: Stand = "board",
) -> ag.Body:
    """Make a faucet, shut: spout, one or two handles, spray head, lift rod."""
    ag.require(
        (spout == "beam") == (style in ("single_hole", "vessel")),
        f"spout={spout} is not allowed with style={style}: single_hole and vessel have a beam, "
        "other styles have none",
    )
    ag.require(spout != "low" or style == "wall", f"spout=low is for style=wall, not for style={style}")
    ag.require(not rod or style != "wall", "style=wall has no lift rod: rod must be False")
    ag.require(stand == "board" or style == "wall", "stand=none is for style=wall, in a room")
    if style == "wall":
        clear = "the spout meets the wall: swivel_limit must be <= 1.75 rad"
        swivel_limit = ag.require(swivel_limit, swivel_limit <= 1.75, clear)
    # slabs on a wall are thinner than worktops
    thick = ag.min_(deck_thickness, 0.024) if style == "wall" else deck_thickness
    board = stands.Board(deck_margin, thick, surface, reach if rod else None)
    ring = taps.ring_of(girth)
    mixer = functools.partial(handles.mixer, lever, lever_length, finish, lift, handle_friction)
    match style:
        case "widespread":
            mount = stands.widespread(board, girth, finish)
        case "bridge":
            mount = stands.bridge(board, finish)
        case "wall":
            mount = stands.before_wall(board if stand == "board" else None, finish, hangs=spout == "low")
        case "single_hole" | "vessel":
            mount = stands.topped_column(board, body_radius, height, ring, mixer(body_radius), finish)
        case _:
            mount = stands.sided_column(board, body_radius, mixer(stands.SIDE), side, finish)

    body = taps.attach_spout(
        mount,
        spouts.Spout(reach, girth, finish),
        "pull_down" if style == "pull_down" else spout,
        height,
        hub=body_radius,
        square=square,
        head=(head_travel, head_force),
        lever=lever_length,
        turn=swivel_limit,
        friction=swivel_friction,
    )
    if mount.valves:
        button = finish if accent == "same" else ag.material("ceramic")
        pair = (mount.valves, handle, handle_length, finish, button, handle_friction)
        body = handles.install_pair(body, *pair, flange=mount.flanges, from_tip=style == "wall")
    if rod:
        middle = ag.vector(0.0, -reach, board.top)
        body = drain.install(body, middle, stands.ROD_AT + reach, deck_thickness, finish, rod_friction)
    return handles.running(body, pair=bool(mount.valves))
