"""A window in its frame: casements, an awning, sliding or double-hung sashes, with locks that work.

The front (-y) is the outside, with the sill; levers, locks and pulls are on the inside, at the back.
Casements open inwards or outwards, awnings outwards.

Links: `frame`; the sashes `pane` (`pane_lower` and `pane_upper` of a double-hung window); `handle` and the
cams `bolt` that it slides in the edge of a hinged sash; `lock`, the cam where two sliding sashes meet, or the
latch of one that slides past a fixed one; `shutter_left` and `shutter_right`. Several of a kind are numbered.
Joints: `pane_hinge`, `handle_turn`, `bolt_slide`; `pane_slide`, `lock_slide`; `pane_slide_0`, `pane_slide_1`,
`lock_turn`; `pane_slide_lower`, `pane_slide_upper`, `lock_turn`; `shutter_hinge_left` and `_right`.

A sash opens when its lock is turned: cams stand behind keeps, a latch beside its keep, a cam under its
keeper, which holds both sashes. Casements stay where friction leaves them; an awning by its friction stay, or
it falls shut; hung sashes are balanced by springs.

Sizes are those of catalogues of timber (IV68), PVC (70 mm) and aluminium systems: sashes 0.4-1.0 m wide and
0.4-1.7 m high, frames of 48-60 mm, glass of two sheets of 4 mm (20 kg/m2), or of one in old ones.
"""

from typing import Literal

from artgen import (
    Body,
    Float,
    Material,
    X,
    by,
    category,
    choice,
    count,
    require,
    shades,
    uniform,
    weld,
)
from artgen.categories.shared.finish import FINISH_WEIGHTS, FINISHES, known, paints
from artgen.categories.window.frame import (
    SILL,
    Tracks,
    drip_cap,
    sill_under,
    trickle_vent,
    window_board,
)
from artgen.categories.window.hardware import LeverStyle
from artgen.categories.window.kinds import Draft, Swing, awning, casement
from artgen.categories.window.plan import (
    METAL_WEIGHTS,
    METALS,
    PLASTIC_WEIGHTS,
    PLASTICS,
    SECTIONS,
    SILL_WEIGHTS,
    SILLS,
    WOOD_WEIGHTS,
    WOODS,
    Kind,
)
from artgen.categories.window.sashes import Glazing
from artgen.categories.window.shutters import Shutters, ShutterStyle
from artgen.categories.window.slides import double_hung, sliding, sliding_both

_GLASS = known("glass", "frosted_glass", "tinted_glass")
_NO_ROOM = "a finger on the meeting rail finds no room before the next bar"
_SHUTTERS = paints(520.0, "shutter_paint")


@category(
    labels=(
        "frame",
        "sill",
        "pane",
        "glass",
        "seal",
        "hinge",
        "handle",
        "lock",
        "keep",
        "screw",
        "vent",
        "shutter",
    ),
    joints=(2, 14),
)
def window(
    *,
    style: Literal["casement", "awning", "sliding", "double_hung"] = choice(
        "casement", "awning", "sliding", "double_hung", weights=(0.48, 0.12, 0.19, 0.21)
    ),
    layout: Literal["single", "pair", "row", "cross"] = by(
        "style",
        casement=choice("single", "pair", "row", "cross", weights=(0.38, 0.36, 0.12, 0.14)),
        awning="single",
        sliding=choice("pair", "row", weights=(0.65, 0.35)),
        double_hung="pair",
        doc="a row has four side by side, a cross two above two",
    ),
    opens: Literal["inwards", "outwards"] = by(
        "style", casement=choice("inwards", "outwards", weights=(0.6, 0.4)), otherwise="outwards"
    ),
    hand: Literal["left", "right"] = choice("left", "right", doc="side of the hinges, or of what slides"),
    hands: Literal["same", "opposite"] = by(
        "layout", single="same", otherwise=choice("same", "opposite", weights=(0.3, 0.7))
    ),
    slides: Literal["one", "both"] = by(
        "style",
        sliding=by("layout", row="one", otherwise=choice("one", "both")),
        otherwise="both",
        doc="of two sashes side by side: XO or XX; of four (OXXO) the middle ones do",
    ),
    width: Float = by(
        "style",
        casement=by(
            "layout",
            single=uniform(0.48, 0.90),
            pair=uniform(0.95, 1.55),
            row=uniform(1.85, 2.40),
            cross=uniform(0.95, 1.45),
        ),
        awning=uniform(0.50, 1.15),
        sliding=by("layout", row=uniform(1.75, 2.40), otherwise=uniform(0.95, 1.80)),
        double_hung=uniform(0.55, 1.10),
        unit="m",
        doc="of the frame",
        within=(0.4, 2.4),
    ),
    height: Float = by(
        "style",
        casement=by("layout", cross=uniform(1.25, 1.80), otherwise=uniform(0.70, 1.60)),
        awning=uniform(0.50, 0.80),
        sliding=uniform(0.60, 1.40),
        double_hung=uniform(1.05, 1.80),
        unit="m",
        doc="of the frame, on its sill",
        within=(0.45, 1.8),
    ),
    upper: Float = uniform(0.26, 0.36, doc="share of the height above the transom of a cross"),
    columns: int = choice(0, 1, 2, 3, weights=(0.54, 0.27, 0.13, 0.06), doc="upright bars on a pane"),
    rows: int = by(
        "columns",
        {
            0: choice(0, 1, 2, 3, weights=(0.68, 0.22, 0.07, 0.03)),
            1: choice(0, 1, 2, 3, weights=(0.2, 0.4, 0.25, 0.15)),
            2: choice(1, 2, 3, weights=(0.4, 0.35, 0.25)),
            3: choice(1, 2, 3, weights=(0.3, 0.35, 0.35)),
        },
        doc="level bars on a pane",
    ),
    kind: Kind = choice("wood", "pvc", "aluminium", weights=(0.4, 0.35, 0.25)),
    finish: Material = by(
        "kind",
        wood=shades(*WOODS, weights=WOOD_WEIGHTS, color=0.06, roughness=0.04),
        pvc=shades(*PLASTICS, weights=PLASTIC_WEIGHTS, color=0.02, roughness=0.04),
        aluminium=shades(*METALS, weights=METAL_WEIGHTS, color=0.03, roughness=0.04),
    ),
    glass: Material = choice(*_GLASS, weights=(0.82, 0.10, 0.08)),
    sheets: int = by("kind", wood=choice(1, 2, weights=(0.3, 0.7)), otherwise=2),
    sill: Material = shades(*SILLS, weights=SILL_WEIGHTS, color=0.03),
    horns: Float = uniform(0.0, 0.045, "m", doc="how far the sill reaches past the frame"),
    board: bool = by(
        "style",
        awning=False,  # a hand at the lever would strike it
        otherwise=choice(False, True, weights=(0.6, 0.4)),
        doc="whether there is a window board inside",
    ),
    vent: bool = choice(False, True, weights=(0.7, 0.3), doc="a trickle vent in the head"),
    cap: bool = choice(False, True, weights=(0.45, 0.55), doc="a drip cap over the head"),
    shutters: ShutterStyle = by(
        "layout",
        row="none",
        cross=by("opens", inwards=choice("none", "boarded", weights=(0.6, 0.4)), outwards="none"),
        otherwise=by(
            "opens",
            inwards=choice("none", "louvred", "boarded", weights=(0.55, 0.28, 0.17)),
            outwards=by(
                "style",
                double_hung=choice("none", "louvred", "boarded", weights=(0.7, 0.2, 0.1)),
                otherwise="none",
            ),
        ),
    ),
    shutter_finish: Material = shades(*_SHUTTERS, color=0.06, roughness=0.04),
    slats: int = count(9, 12, doc="louvres in half a shutter"),
    shutter_swing: Float = uniform(1.7, 3.0, "rad"),
    metal: Material = shades(*FINISHES, weights=FINISH_WEIGHTS, color=0.03, roughness=0.03),
    lever: LeverStyle = choice("straight", "tapered", "bent"),
    lever_length: Float = uniform(0.105, 0.135, "m", within=(0.09, 0.15)),
    lever_turn: Literal["quarter", "half"] = by(
        "opens",
        inwards=choice("quarter", "half"),
        outwards="quarter",
        doc="half a turn ends where gear for tilting airs",
    ),
    lever_friction: Float = uniform(0.35, 0.8, "N m", doc="of the gear and its detents"),
    lock_friction: Float = by(
        "slides", one=uniform(2.5, 5.0), both=uniform(0.15, 0.4), doc="of a latch [N], of a cam [N m]"
    ),
    swing: Float = by(
        "style", awning=uniform(0.45, 1.1), otherwise=uniform(1.2, 1.5), unit="rad", within=(0.2, 1.52)
    ),
    stay: Literal["friction", "none"] = by(
        "style", awning=choice("friction", "none", weights=(0.65, 0.35)), otherwise="friction"
    ),
    hinge_friction: Float = uniform(0.8, 2.0, "N m", doc="of casement stays"),
    hinge_damping: Float = uniform(0.5, 1.5, "N m s/rad"),
    bar: Float = uniform(0.11, 0.18, "m", doc="of the pulls of sliding sashes"),
    lifts: int = by(
        "style", double_hung=choice(1, 2), otherwise=1, doc="on the lower one of two hung sashes"
    ),
    drag: Float = uniform(9.0, 18.0, "N", doc="of rollers, balances and brushes"),
) -> Body:
    """Make a casement, awning, sliding or double-hung window, shut and locked."""
    require(style == "casement" or opens == "outwards", f"style={style} has opens=outwards only")
    require(
        shutters == "none" or (opens == "inwards" if style == "casement" else style != "awning"),
        f"style={style} that opens {opens} would strike shutters={shutters}: they must be none",
    )
    require(style != "sliding" or layout in ("pair", "row"), "style=sliding has layout=pair or row only")
    abreast = {"single": 1, "row": 4}.get(layout, 2)
    # a row of sashes needs room for the glass of each
    least = (abreast + 1) / 5.0 if style in ("casement", "sliding") else 0.0
    width = require(width, width >= least, f"layout={layout} has narrow sashes: width at least {least:g} m")
    section = SECTIONS[kind]
    wide, tall = width - 2.0 * section.frame, height - SILL - 2.0 * section.frame
    glazing = Glazing(glass, sheets, columns, rows, finish)
    hinged = style in ("casement", "awning")
    draft = Draft(wide, tall, section, glazing, finish, metal, lever_friction if hinged else lock_friction)
    # simulators look at all pairs of what is near: hinges of many leaves only are seen
    few = {"single": 1, "pair": 2}.get(layout, 4) + 2 * (shutters != "none") < 4
    hung = Swing(
        swing,
        hinge_friction,
        hinge_damping,
        lever,
        lever_length,
        1.57 if lever_turn == "quarter" else 3.14,
        stay,
        few,
    )
    first = 1 if hand == "left" else -1
    sides = tuple(first if hands == "same" else 1 - 2 * (index % 2) for index in range(abreast))
    match style:
        case "casement":
            levels = (1.0 - upper, upper) if layout == "cross" else (1.0,)
            body = casement(draft, hung, sides, levels, inward=opens == "inwards")
        case "awning":
            body = awning(draft, hung)
        case "sliding":
            if slides == "both":
                body = sliding_both(draft, bar=bar, drag=drag)
                body = body if columns < 3 else body.require(width > 1.25, _NO_ROOM)
            else:
                body = sliding(draft, 2 if layout == "pair" else 4, bar=bar, drag=drag)
            body = body.mirror(X) if hand == "right" else body
        case "double_hung":
            body = double_hung(draft, lifts=lifts, drag=drag)
            body = body if rows < 3 else body.require(height > 1.28, _NO_ROOM)

    deep = section.back if hinged else Tracks.of(section).back
    front, back = (-deep, 0.0) if opens == "inwards" else (0.0, deep)
    low, high = -height / 2.0 + SILL / 2.0, height / 2.0 - SILL / 2.0
    fixed = [sill_under(width, front, back, low, sill, horns=horns)]
    if cap:
        fixed.append(drip_cap(width, front, high, finish))
    if vent:
        fixed.append(trickle_vent(0.0, back, high - 0.020, finish, length=0.30))
    if board:
        fixed.append(window_board(width, back, low, finish))
    body = weld(body, *fixed)
    if shutters != "none":
        pair = Shutters(shutters, shutter_finish, metal, slats, shutter_swing, hinge_friction, few)
        body = pair.hung(body, front=front, width=width, low=low + 0.010, high=high - 0.030)
    return body.at(0.0, 0.0, SILL - low)
