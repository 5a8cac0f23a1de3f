"""A window in its frame: casements, an awning, sliding or double-hung sashes, with working locks.

The front (-y) is the outside, with the sill; levers, locks and pulls are on the inside, at the back.
Casements open inwards or outwards, awnings outwards.

Links: `frame`; the sashes `pane` (`pane_lower` and `pane_upper` of a double-hung window); `handle` and the
cams `bolt` that it slides in the edge of a hinged sash; `lock`, the cam at the meeting rails of two sliding
sashes, or the latch of a sash that slides past a fixed one; `shutter_left` and `shutter_right`. Several links
of a kind are numbered. Joints: `pane_hinge`, `handle_turn`, `bolt_slide`; `pane_slide`, `lock_slide`;
`pane_slide_0`, `pane_slide_1`, `lock_turn`; `pane_slide_lower`, `pane_slide_upper`, `lock_turn`;
`shutter_hinge_left` and `_right`.

A sash opens after its lock is turned: cams are behind keeps, a latch is beside its keep, a cam is under its
keeper and locks both sashes. Friction holds casements; a friction stay holds an awning, which falls shut
without one; springs balance hung sashes.

Sizes are those of catalogs of timber (IV68), PVC (70 mm) and aluminum systems: sashes 0.4-1.0 m wide and
0.4-1.7 m high, frames of 48-60 mm, glass of two sheets of 4 mm (20 kg/m2), or of one sheet in old windows.
"""

from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import FINISH_WEIGHTS, FINISHES, known, paints
from artgen.categories.window import frame, sashes
from artgen.categories.window.frame import SILL
from artgen.categories.window.hardware import LeverStyle
from artgen.categories.window.shutters import Style as ShutterStyle
from artgen.categories.window.shutters import hang_shutters

_GLASS = known("glass", "frosted_glass", "tinted_glass")
_SHEET = 0.004  # thickness of a sheet of glass [m]
_NO_ROOM = (
    "a finger on the meeting rail has no room before the next bar: raise width or height, or lower columns "
    "or rows"
)
_SHUTTERS = paints(520.0, "shutter_paint")


@ag.category(labels="frame sill pane glass seal hinge handle lock keep screw vent shutter", joints=(2, 14))
def window(
    *,
    style: Literal["casement", "awning", "sliding", "double_hung"] = ag.choice(
        {"casement": 0.48, "awning": 0.12, "sliding": 0.19, "double_hung": 0.21}
    ),
    layout: Literal["single", "pair", "row", "cross"] = ag.by(
        "style",
        casement={"single": 0.38, "pair": 0.36, "row": 0.12, "cross": 0.14},
        awning="single",
        sliding={"pair": 0.65, "row": 0.35},
        double_hung="pair",
        doc="arrangement of the sashes; a row has four side by side, a cross two above two",
    ),
    opens: Literal["inwards", "outwards"] = ag.by(
        "style", casement={"inwards": 0.6, "outwards": 0.4}, otherwise="outwards"
    ),
    hand: Literal["left", "right"] = ag.choice("left", "right", doc="side of the hinges, or of the slider"),
    hands: Literal["same", "opposite"] = ag.by(
        "layout", single="same", otherwise={"same": 0.3, "opposite": 0.7}
    ),
    slides: Literal["one", "both"] = ag.by(
        "style",
        sliding=ag.by("layout", row="one", otherwise=ag.choice("one", "both")),
        otherwise="both",
        doc="which sashes slide: of two, one (XO) or both (XX); of four, the middle ones (OXXO)",
    ),
    width: ag.Float = ag.by(
        "style",
        casement=ag.by(
            "layout",
            single=ag.uniform(0.48, 0.90),
            pair=ag.uniform(0.95, 1.55),
            row=ag.uniform(1.85, 2.40),
            cross=ag.uniform(0.95, 1.45),
        ),
        awning=ag.uniform(0.50, 1.15),
        sliding=ag.by("layout", row=ag.uniform(1.75, 2.40), otherwise=ag.uniform(0.95, 1.80)),
        double_hung=ag.uniform(0.55, 1.10),
        unit="m",
        doc="width of the frame",
        within=(0.4, 2.4),
    ),
    height: ag.Float = ag.by(
        "style",
        casement=ag.by("layout", cross=ag.uniform(1.25, 1.80), otherwise=ag.uniform(0.70, 1.60)),
        awning=ag.uniform(0.50, 0.80),
        sliding=ag.uniform(0.60, 1.40),
        double_hung=ag.uniform(1.05, 1.80),
        unit="m",
        doc="height of the frame, on its sill",
        within=(0.45, 1.8),
    ),
    upper: ag.Float = ag.uniform(0.26, 0.36, doc="share of the height above the transom of a cross"),
    columns: int = ag.choice({0: 0.54, 1: 0.27, 2: 0.13, 3: 0.06}, doc="number of vertical bars"),
    rows: int = ag.by(
        "columns",
        {
            0: {0: 0.68, 1: 0.22, 2: 0.07, 3: 0.03},
            1: {0: 0.2, 1: 0.4, 2: 0.25, 3: 0.15},
            2: {1: 0.4, 2: 0.35, 3: 0.25},
            3: {1: 0.3, 2: 0.35, 3: 0.35},
        },
        doc="number of horizontal glazing bars on a pane",
    ),
    kind: frame.Kind = ag.choice({"wood": 0.4, "pvc": 0.35, "aluminium": 0.25}),
    finish: ag.Material = ag.by("kind", frame.FINISHES),
    glass: ag.Material = ag.choice(*_GLASS, weights=(0.82, 0.10, 0.08)),
    sheets: int = ag.by("kind", wood={1: 0.3, 2: 0.7}, otherwise=2),
    sill: ag.Material = frame.SILLS,
    horns: ag.Float = ag.uniform(0.0, 0.045, "m", doc="length of the sill beyond each side of the frame"),
    board: bool = ag.by(
        "style",
        awning=False,  # a hand at the lever would strike a window board
        otherwise={False: 0.6, True: 0.4},
        doc="whether there is a window board inside",
    ),
    vent: bool = ag.choice({False: 0.7, True: 0.3}, doc="whether the head has a trickle vent"),
    cap: bool = ag.choice({False: 0.45, True: 0.55}, doc="whether there is a drip cap over the head"),
    shutters: ShutterStyle = ag.by(
        "layout",
        row="none",
        cross=ag.by("opens", inwards={"none": 0.6, "boarded": 0.4}, outwards="none"),
        otherwise=ag.by(
            "opens",
            inwards={"none": 0.55, "louvred": 0.28, "boarded": 0.17},
            outwards=ag.by(
                "style", double_hung={"none": 0.7, "louvred": 0.2, "boarded": 0.1}, otherwise="none"
            ),
        ),
    ),
    shutter_finish: ag.Material = ag.shades(*_SHUTTERS, color=0.06, roughness=0.04),
    slats: int = ag.count(9, 12, doc="number of louvers in half a shutter"),
    shutter_swing: ag.Float = ag.uniform(1.7, 3.0, "rad"),
    metal: ag.Material = ag.shades(*FINISHES, weights=FINISH_WEIGHTS, color=0.03, roughness=0.03),
    lever: LeverStyle = ag.choice("straight", "tapered", "bent"),
    lever_length: ag.Float = ag.uniform(0.105, 0.135, "m", within=(0.09, 0.15)),
    lever_turn: Literal["quarter", "half"] = ag.by(
        "opens",
        inwards=ag.choice("quarter", "half"),
        outwards="quarter",
        doc="range of the lever; half a turn on gear for tilting sashes",
    ),
    lever_friction: ag.Float = ag.uniform(0.35, 0.8, "N m", doc="friction of the gear and its detents"),
    lock_friction: ag.Float = ag.by(
        "slides",
        one=ag.uniform(2.5, 5.0),
        both=ag.uniform(0.15, 0.4),
        doc="friction of a latch [N] or a cam [N m]",
    ),
    swing: ag.Float = ag.by(
        "style", awning=ag.uniform(0.45, 1.1), otherwise=ag.uniform(1.2, 1.5), unit="rad", within=(0.2, 1.52)
    ),
    stay: Literal["friction", "none"] = ag.by(
        "style", awning={"friction": 0.65, "none": 0.35}, otherwise="friction"
    ),
    hinge_friction: ag.Float = ag.uniform(0.8, 2.0, "N m", doc="friction of casement stays"),
    hinge_damping: ag.Float = ag.uniform(0.5, 1.5, "N m s/rad"),
    bar: ag.Float = ag.uniform(0.11, 0.18, "m", doc="length of the pulls of sliding sashes"),
    lifts: int = ag.by("style", double_hung=ag.choice(1, 2), otherwise=1, doc="lifts on the lower sash"),
    drag: ag.Float = ag.uniform(9.0, 18.0, "N", doc="friction of rollers, balances and brushes"),
) -> ag.Body:
    """Make a casement, awning, sliding or double-hung window, shut and locked."""
    ag.require(
        style == "casement" or opens == "outwards",
        f"opens={opens} is not allowed with style={style}: opens must be outwards",
    )
    ag.require(
        shutters == "none" or (opens == "inwards" if style == "casement" else style != "awning"),
        f"style={style} with opens={opens} would strike shutters={shutters}: shutters must be none",
    )
    ag.require(style != "sliding" or layout in ("pair", "row"), "layout of style=sliding must be pair or row")
    abreast = {"single": 1, "row": 4}.get(layout, 2)
    # a row of sashes needs space for the glass of each
    least = (abreast + 1) / 5 if style in ("casement", "sliding") else 0.0
    width = ag.require(
        width, width >= least, f"layout={layout} has narrow sashes: width must be >= {least:g} m"
    )
    hinged, inward = style in ("casement", "awning"), opens == "inwards"
    section = frame.SECTIONS[kind]
    density = glass.density * _SHEET * sheets / sashes.PANE
    panes = glass.with_(name=f"{glass.name}_{sheets}_sheets", density=density)
    opening = ag.Region.centered(width - 2 * section.frame, 0.0, height - SILL - 2 * section.frame)
    friction = lever_friction if hinged else lock_friction
    draft = frame.Draft(opening, section, finish, metal, panes, columns, rows, friction)
    # simulators test all pairs of close colliders: hinges of many leaves have none
    few = {"single": 1, "pair": 2}.get(layout, 4) + 2 * (shutters != "none") < 4
    turn = 1.57 if lever_turn == "quarter" else 3.14
    hung = sashes.Swing(swing, hinge_friction, hinge_damping, lever, lever_length, turn, stay, few)
    if style == "casement":
        first = 1 if hand == "left" else -1
        sides = [first if hands == "same" else 1 - 2 * (index % 2) for index in range(abreast)]
        shares = (1 - upper, upper) if layout == "cross" else (1.0,)
        body = sashes.casement(draft, hung, sides, shares, inward=inward)
    elif style == "awning":
        body = sashes.awning(draft, hung)
    elif style == "double_hung":
        body = sashes.double_hung(draft, lifts=lifts, drag=drag)
        body = body if rows < 3 else body.require(height > 1.28, _NO_ROOM)
    elif slides == "both":
        body = sashes.sliding_both(draft, bar=bar, drag=drag)
        body = body if columns < 3 else body.require(width > 1.25, _NO_ROOM)
    else:
        body = sashes.sliding(draft, 2 if layout == "pair" else 4, bar=bar, drag=drag)
    if style == "sliding" and hand == "right":
        body = body.mirror(ag.X)

    deep = section.back if hinged else section.tracked
    whole = ag.Region.centered(width, 0.0, height - SILL).with_(y=(-deep, 0.0) if inward else (0.0, deep))
    fixed = [frame.sill_under(whole, sill, horns=horns)]
    for wanted, make in ((cap, frame.drip_cap), (vent, frame.trickle_vent), (board, frame.window_board)):
        fixed += [make(whole, finish)] if wanted else []
    body = ag.weld(body, *fixed)
    if shutters != "none":
        body = hang_shutters(
            body,
            whole.shrink(bottom=0.010, top=0.030),
            style=shutters,
            finish=shutter_finish,
            metal=metal,
            slats=slats,
            swing=shutter_swing,
            friction=hinge_friction,
            solid=few,
        )
    return body.at(z=height / 2 + SILL / 2)
