"""A washing machine that loads at the front or from above, or a tumble dryer.

Links: `body`; `drum`; at the front `door`, with a `handle` if a hook holds it, `drawer` and `filter_flap`; or
above `lid` and `agitator`; `dial`, or `dial_0`, ..., and `button_0`, .... Joints: `drum_spin`; `door_hinge`,
`handle_pull`, `drawer_slide`, `flap_hinge`; or `lid_hinge` and `agitator_turn`; `dial_turn` and
`button_slide_0`, ....

The hook of a handle reaches through the front panel, and its barb stands behind the panel: the door opens
only while the handle is pulled. Without a hook, friction holds the door. The drum turns freely: belt and
bearings brake it. It is open, and its colliders leave room for laundry. A lid rests beyond upright. Dials
turn without end and click at their programs; rotary switches have 0.02-0.06 N m (Alps SRBM: 0.04 N m).

Sizes of data sheets and shops. Europe: 600 x 845 x 590 mm and 72 kg (Bosch WAV28EH3GB), 400-480 mm deep if
slim, 510 x 695 x 460 mm if compact. USA: front loaders 27 in wide, 38.5-39 in high, 28-32 in deep with the
door, 82-100 kg (LG: 180-220 lb); top loaders 27 in wide and deep and 44 in high with the console (Whirlpool),
57-70 kg with 4.5 cu ft; compact ones 26-51 kg. Dryers: 50-65 kg.
"""

import math
from typing import Any, Literal, get_args

import artgen as ag
from artgen import details
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import PlainLook, cabinet_finish, fronts, grip_metals
from artgen.categories.washing_machine import case as parts
from artgen.categories.washing_machine.works import BEHIND, Porthole, Rim, TopLoader, washing
from artgen.nodes.details.dials import SWEEP
from artgen.nodes.details.displays import Color

_LOOKS = get_args(PlainLook)
_FINISH, _METAL = fronts(*_LOOKS), grip_metals(*_LOOKS)
_RINGS = {name: ag.colored("abs", name) for name in ("white", "silver", "graphite")}
_RINGS["chrome"] = ag.material("chrome").with_(name="ring_chrome")
_RINGS["black"] = ag.material("glossy_plastic_black")
_CAP = ag.material("brushed_aluminium").with_(name="knob_cap", density=1100)
_KNOBS = (ag.colored("abs", "white"), ag.colored("abs", "silver"), "black_abs", _CAP)
_GLASS = ag.material("glass").with_(name="door_bowl", opacity=0.28, density=900.0)
_SMOKE = ag.material("tinted_glass").with_(name="smoke_bowl", opacity=0.50, density=900.0)
_PROGRAMS = {
    False: ("shirt", "tumbler", "leaf", "timer", "heart", "snowflake", "drop", "spin", "star"),
    True: ("shirt", "sun", "leaf", "timer", "heart", "fan_heat", "moon", "tumbler", "star"),
}  # of washing, and of drying
_CLICKS = [SWEEP * step / 8 for step in range(-4, 5)]  # of a dial, at its nine programs [rad]
_PANE = ag.material("black_glass")
_WHITE_PANE = _PANE.with_(name="white_glass", base_color=(0.80, 0.80, 0.79))
_SIZES = {  # width, height and depth [m]
    "full": ((0.595, 0.600), (0.845, 0.855), (0.55, 0.63)),
    "slim": ((0.595, 0.600), (0.845, 0.855), (0.40, 0.46)),
    "compact": ((0.508, 0.515), (0.695, 0.710), (0.45, 0.48)),
    "wide": ((0.683, 0.687), (0.965, 1.000), (0.68, 0.77)),
}
_TOPS = _SIZES | {
    "compact": ((0.53, 0.57), (0.89, 0.94), (0.54, 0.58)),
    "wide": ((0.683, 0.687), (0.89, 0.94), (0.68, 0.72)),
}


def _odds(share: float) -> dict[bool, float]:
    return {True: share, False: 1 - share}


def _size(axis: int, within: tuple[float, float], doc: str = "") -> Any:
    """Draw the width, height or depth by kind and size."""
    tops, others = ({key: ag.uniform(*each[axis]) for key, each in kind.items()} for kind in (_TOPS, _SIZES))
    cases = {"top": ag.by("size", tops), "otherwise": ag.by("size", others)}
    return ag.by("kind", cases, unit="m", within=within, doc=doc)


_WIDTH, _HEIGHT = _size(0, (0.50, 0.70)), _size(1, (0.68, 1.02), "height of the worktop or the deck")
_DEPTH = _size(2, (0.39, 0.80), "depth of the case; the door stands out by 0.045 m")


@ag.category(
    labels="body front console panel worktop base foot kick_plate filter_flap filter vent seal hinge door "
    "glass handle latch drum paddle drawer drawer_housing lid tub_cover agitator dial button print display "
    "hose cord screw rating_plate",
    joints=(5, 12),
)
def washing_machine(
    *,
    kind: Literal["front", "top", "dryer"] = ag.choice({"front": 0.52, "top": 0.24, "dryer": 0.24}),
    size: Literal["full", "slim", "compact", "wide"] = ag.by(
        "kind",
        front={"full": 0.5, "slim": 0.2, "compact": 0.12, "wide": 0.18},
        top={"wide": 0.6, "compact": 0.4},
        dryer={"full": 0.65, "wide": 0.35},
        doc="full: 60 cm; slim: 60 cm and shallow; compact: 51-56 cm; wide: 68 cm, of the USA",
    ),
    look: PlainLook = ag.choice({"white": 5, "black": 1, "dark_steel": 1.7, "stainless": 1, "pastel": 1.3}),
    width: ag.Float = _WIDTH,
    height: ag.Float = _HEIGHT,
    depth: ag.Float = _DEPTH,
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    rim: Rim = ag.by(
        "kind",
        dryer={"solid": 0.34, "domed": 0.22, "stepped": 0.2, "glass": 0.24},
        otherwise={"domed": 0.36, "stepped": 0.36, "glass": 0.28},
        doc="front of the door",
    ),
    ring: Literal["white", "chrome", "silver", "graphite", "black"] = ag.by(
        "look",
        white={"white": 0.34, "chrome": 0.2, "silver": 0.2, "graphite": 0.14, "black": 0.12},
        pastel={"chrome": 0.6, "white": 0.4},
        stainless={"silver": 0.4, "chrome": 0.3, "black": 0.3},
        otherwise={"black": 0.45, "chrome": 0.25, "graphite": 0.3},
        doc="finish of the door's ring",
    ),
    porthole: ag.Float = ag.uniform(0.30, 0.345, doc="radius of a door over the width", within=(0.28, 0.36)),
    bowl: ag.Float = ag.uniform(0.060, 0.085, "m", doc="depth of the glass bowl", within=(0.04, 0.10)),
    lever: bool = ag.by("kind", dryer=_odds(0.25), otherwise=_odds(0.7), doc="hook that a handle frees"),
    swing: ag.Float = ag.uniform(1.95, 2.80, "rad", doc="range of a door", within=(1.4, 2.85)),
    lid_swing: ag.Float = ag.uniform(1.62, 1.72, "rad", doc="range of a lid", within=(1.3, 1.75)),
    pull: ag.Float = ag.uniform(4.0, 9.0, "N", doc="force at the edge that moves a door"),
    glazed: bool = ag.choice(_odds(0.6), doc="window in a lid"),
    agitator: bool = ag.by("size", wide=_odds(0.7), otherwise=_odds(0.15), doc="agitator, or a low impeller"),
    backsplash: ag.Float = ag.by(
        "size",
        wide=ag.uniform(0.15, 0.18),
        otherwise=ag.uniform(0.09, 0.115),
        unit="m",
        within=(0.07, 0.2),
        doc="height behind a lid",
    ),
    console: ag.Float = ag.uniform(0.112, 0.135, "m", doc="height in front", within=(0.105, 0.16)),
    pane: bool = ag.by(
        "look", white=_odds(0.25), pastel=_odds(0.1), otherwise=_odds(0.6), doc="glass on the console"
    ),
    dials: int = ag.by("kind", top={0: 2, 1: 4, 3: 4}, front={1: 9, 0: 1}, dryer={1: 7, 2: 3}),
    dial_style: controls.DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    dial_radius: ag.Float = ag.uniform(0.019, 0.025, "m", within=(0.016, 0.027)),
    dial_torque: ag.Float = ag.uniform(0.02, 0.05, "N m", doc="greatest torque of the detents of a dial"),
    knob: ag.Material = ag.shades(*_KNOBS, color=0.03, roughness=0.03, doc="material of dials"),
    scale: controls.DialScale = ag.choice({"icons": 0.5, "ticks": 0.25, "numbers": 0.25}),
    buttons: int = ag.by("size", compact=ag.count(2, 4), otherwise=ag.count(2, 6)),
    button_shape: controls.ButtonShape = ag.choice("round", "square", "pill", "bar"),
    button_force: ag.Float = ag.uniform(2.0, 4.0, "N"),
    show: str = ag.by(
        "dials", {3: ""}, otherwise=ag.choice("1:25", "0:45", "2:10", "60", ""), doc="text of the display"
    ),
    figures: Color = ag.choice("white", "red", "amber", "cyan", "green"),
    drawer: bool = ag.by(
        "kind", top=False, front=True, dryer=ag.by("size", full=_odds(0.7), wide=False), doc="tray or tank"
    ),
    drawer_friction: ag.Float = ag.uniform(3.0, 6.0, "N"),
    flap: bool = ag.by(
        "kind", top=False, front=_odds(0.85), dryer=_odds(0.5), doc="flap before the filter of the pump"
    ),
    flap_side: Literal["left", "right"] = ag.choice({"right": 0.75, "left": 0.25}),
    paddles: int = ag.choice({3: 0.85, 4: 0.15}),
    drum_friction: ag.Float = ag.uniform(0.15, 0.5, "N m", doc="friction of belt and bearings"),
    ballast: Literal["steel", "concrete"] = ag.choice("steel", "concrete", doc="material of the ballast"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a washing machine or a dryer, closed: drum, door or lid, drawer, flap, dials, buttons."""
    if kind == "top":
        depth = ag.require(depth, depth >= 0.45, "depth of a top loader must be >= 0.45 m")
    else:
        height = ag.require(height, height - width >= 0.05, "height must exceed width by 0.05 m")
    outside = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (0, height))
    sides, dryer, wide = cabinet_finish(look, finish), kind == "dryer", size == "wide"
    dark, pale = look in ("black", "dark_steel"), look in ("white", "pastel")
    heavy = {"steel": 0.93, "concrete": 1.07}[ballast]
    glass = (_WHITE_PANE if pale and ring in ("white", "silver") else _PANE) if pane else None
    plan = parts.Plan(outside, console=console, top=0.004 if wide else 0.030, drawer=0.19 if drawer else 0.0)
    space, dial_size, name = plan.console, dial_radius, maker
    if kind == "top":
        if not wide:  # it leans back by more
            backsplash = ag.require(
                backsplash, backsplash <= 0.15, f"backsplash of a {size} machine must be <= 0.15 m"
            )
        space = ag.Region(outside.shrink(x=0.002).x, (0, 0.022), (height, height + backsplash))
        dial_size, name = ag.min_(dial_radius, 0.26 * backsplash), ""
    caps = ag.material("black_abs") if dark else ag.colored("abs", "silver")
    ink, icons = controls.ink_on(glass or finish), _PROGRAMS[dryer]
    print_ = controls.dial_print(dial_size, ink=ink, style=scale, count=9, icons=icons)
    turn = controls.dial_turn("dial_turn", friction=0.01, endless=True, clicks=_CLICKS, torque=dial_torque)
    dial = controls.dial(turn, dial_style, dial_size, knob, depth=0.022, cap=metal, scale=print_)
    keys, screen = (buttons, button_shape, caps, button_force), (show, figures)
    face = parts.console(space, finish, glass, [dial] * dials, keys, screen, name)

    if kind == "top":
        lean = 0.6 if wide else 0.8
        top = TopLoader(outside, finish, metal, (_SMOKE if dark else _GLASS) if glazed else None)
        skin = outside.shrink(x=0.001, top=0.050 - parts.LAP, bottom=0.022).deep(parts.SKIN, None)[0]
        low, rear = outside.y.high - BEHIND + 0.016, outside.y.high
        rise, run = backsplash * math.cos(lean), backsplash * math.sin(lean)
        front, over = low + 0.0235 / math.cos(lean), height + rise - 0.002
        wedge = [(front, height - 0.001), (rear, height - 0.001), (rear, over), (front + run, over)]
        shell = ag.extrude(ag.polygon(wedge), width - 0.004, axis=ag.X, bevel=0.002)
        body = ag.weld(
            parts.sheets(outside, sides, front=skin.y.high, high=height - 0.050),
            ag.part(skin.box(bevel=0.002), "front", finish.with_(name=f"{finish.name}_front", density=700.0)),
            parts.base(outside, 0.25, skin.y.high + 0.004, heavy * (150 if wide else 210)),
            parts.back(outside, maker, "T75 230 V~", low=0.30, vented=False),
            top.top(),
            ag.part(shell, "console", finish.with_(name=f"{finish.name}_console", density=180.0)),
            face.rotate(ag.X, -lean).at(0, low + run / 2, height + rise / 2),
        )
        body = body.install(top.basket(0.28, drum_friction, agitator=agitator))
        return washing(
            body.install(top.lid(lid_swing, 0.35 * pull, maker)), "lid_hinge", buttons, dials, dryer=False
        )

    window = _SMOKE if rim == "glass" or dark else _GLASS
    port = Porthole(porthole * width, rim, finish if rim == "solid" else _RINGS[ring], metal, lever=lever)
    middle = ag.vector(0, outside.y.low, plan.center)
    room = ag.min_(plan.center - 0.150, plan.console.z.low - plan.center - 0.004)
    radius = ag.min_(width / 2 - 0.045, room)
    low = plan.center - radius - 0.012
    density = ((120 if wide else 270) if dryer else 400 if wide else 800) * heavy
    worktop = plan.top.shrink(front=0.002, back=0.004).box(bevel=0.002 if wide else 0.005)
    board = ag.colored("lacquered_mdf", "white" if pale else "graphite")
    top_name, top_density = (f"{finish.name}_top", 2400.0) if wide else ("worktop", 620.0)
    body = ag.weld(
        parts.sheets(outside, sides, front=plan.panel.y.high, high=plan.top.z.low + parts.LAP),
        port.panel(plan.panel.at(z=-plan.center), finish).at(middle),
        parts.base(outside, low, outside.y.low + 0.040, density),
        ag.part(worktop, "worktop", (finish if wide else board).with_(name=top_name, density=top_density)),
        parts.back(outside, maker, "2100 W 230 V~", low=0.22, vented=dryer and not drawer),
        face.at(plan.console.x.mid, plan.console.y.low, plan.console.z.mid),
        parts.kick_plate(plan, finish, flap_side if flap else ""),
    )
    drum = port.drum(radius, depth - 0.055, drum_friction, dryer=dryer, paddles=paddles)
    body = body.install(drum, at=middle)
    if drawer:
        body = ag.weld(body, parts.drawer(plan, finish, tank=dryer, friction=drawer_friction))
    return washing(
        body.install(port.door(window, bowl, swing, pull), at=middle),
        "door_hinge",
        buttons,
        dials,
        dryer=dryer,
    )
