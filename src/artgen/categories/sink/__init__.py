"""A sink with its tap: inset, undermount or with an apron for a kitchen; on a vanity, a wall or a pedestal.

Links: `sink`, with all that stands still; `spout`, and `spray_head` on its hose; `handle`, or `handle_left`
(hot) and `handle_right` (cold); `strainer`, the basket in the drain of a kitchen sink, with `knob`, which
lifts it; `plug` of a washbasin, with `lift_rod` and `pivot_rod`; `door_left` and `door_right` of a cabinet.
Joints: those of a faucet; `strainer_lift` of a basket that is lifted out, or `knob_turn` and
`strainer_slide`, which follows it; `plug_lift`, or `lift_rod_slide` with `pivot_rod_turn` and `plug_slide`,
which follow it; `door_hinge_left` and `door_hinge_right`.

A second bowl has the suffix `_right`. With `stand="none"` a sink hangs in the worktop of a room by its rim.

Sizes are those of EN 13310, EN 14688 and of shops: kitchen bowls 340-500 by 340-420 mm and 150-220 mm deep,
worktops 600 mm deep at 860-920 mm, drains of 90 mm with baskets of 80 mm; washbasins 400-650 by 360-480 mm
with rims at 820-870 mm, drains of 1 1/4 inch. Steel is 0.8-1.2 mm thick, fireclay 20 mm. An apron sink of
fireclay weighs 30-50 kg, a washbasin 9-20 kg, a pedestal 7-10 kg. A rotary waste turns by a quarter and
lifts its basket by 10-14 mm.
"""

import functools
import math
import operator
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import controls, require_suited, sanitary, taps
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fronts import FrontLook, FrontStyle
from artgen.categories.shared.furniture import DECORS, LACQUERS, MELAMINES, WOODS
from artgen.categories.shared.pulls import bar_pull, knob_pull
from artgen.categories.shared.taps import drain, handles, spouts, stands
from artgen.categories.sink.bowls import (
    BACK,
    HOLE,
    KITCHEN,
    Bowls,
    Cabinet,
    Plan,
    Stand,
    Style,
    kitchen,
    vessel,
    washbasin,
)
from artgen.nodes.fitting import Fitting

Shape = Literal["round", "soft", "square", "sharp"]
"""Outline of a bowl from above, by the radius of its corners."""

_POWERS: dict[Shape, float] = {"round": 1.0, "soft": 0.6, "square": 0.25, "sharp": 0.15}
_CUP = 0.042  # depth of the strainer below the floor of a bowl [m]
_LIFT = 0.012  # stroke of a rotary waste [m]

_STEEL = ag.material("stainless").with_(name="sink_steel", density=2700.0)  # 1 mm of it in a wall of 3 mm
_CLAY = ag.material("ceramic").with_(name="fireclay", base_color=(0.84, 0.83, 0.80), specular_roughness=0.12)
_STONE = ag.material("granite").with_(name="composite", density=2200.0, specular_roughness=0.55)
_COMPOSITES = {
    "graphite": (0.050, 0.052, 0.056),
    "cream": (0.66, 0.60, 0.50),
    "grey": (0.26, 0.26, 0.26),
    "brown": (0.12, 0.085, 0.065),
}
_STONES = {
    _STONE.with_(name=f"composite_{name}", base_color=rgb, texture=""): 0.1
    for name, rgb in _COMPOSITES.items()
}
_METALS = ag.shades(
    "chrome", "stainless", "satin_nickel", "satin_brass", "powder_coat_black", weights=(4, 3, 2, 1, 2)
)
_GLASS = ag.material("glass")
_PULLS = {"knob": knob_pull, "bar": bar_pull}
_PLACED = {"knob": {}, "bar": {"level": False, "room": 0.31}}
_WHITE = ag.material("polypropylene").with_(name="trap_white", base_color=(0.75, 0.75, 0.73))


@ag.category(
    labels="bowl rim drainer worktop cabinet foot wall tile pedestal drain trap basket plug knob escutcheon "
    "body valve collar handle index spout aerator spray_head hose guide lift_rod strap pivot_rod print "
    "door glass hinge bumper screw",
    joints=(4, 9),
)
def sink(
    *,
    style: Style = ag.choice(
        {"inset": 0.3, "undermount": 0.16, "apron": 0.16, "vessel": 0.14, "hung": 0.12, "pedestal": 0.12}
    ),
    stand: Stand = ag.by(
        "style",
        vessel={"cabinet": 0.7, "legs": 0.3},
        hung="wall",
        pedestal="pedestal",
        otherwise={"cabinet": 0.75, "legs": 0.25},
    ),
    bowls: Bowls = ag.by(
        "style",
        inset={"single": 0.5, "half": 0.25, "double": 0.25},
        undermount={"single": 0.5, "half": 0.2, "double": 0.3},
        apron={"single": 0.7, "double": 0.3},
        otherwise="single",
    ),
    drainer: Literal["none", "left", "right"] = ag.by(
        "style", inset={"none": 0.3, "left": 0.35, "right": 0.35}, otherwise="none"
    ),
    shape: Shape = ag.by(
        "style",
        vessel={"round": 0.4, "soft": 0.25, "square": 0.35},
        hung={"round": 0.3, "soft": 0.3, "square": 0.4},
        pedestal={"round": 0.4, "soft": 0.6},
        otherwise={"square": 0.65, "sharp": 0.35},
    ),
    width: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.40, 0.50),
        hung=ag.uniform(0.50, 0.64),
        pedestal=ag.uniform(0.52, 0.62),
        otherwise=ag.by(
            "bowls", single=ag.uniform(0.42, 0.54), half=ag.uniform(0.34, 0.40), double=ag.uniform(0.33, 0.39)
        ),
        unit="m",
        within=(0.3, 0.8),
        doc="width of a bowl, or of a washbasin",
    ),
    deep: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.35, 0.40),
        hung=ag.uniform(0.42, 0.48),
        pedestal=ag.uniform(0.44, 0.50),
        otherwise=ag.uniform(0.36, 0.41),
        unit="m",
        within=(0.33, 0.52),
        doc="the same from front to back",
    ),
    hollow: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.105, 0.135),
        hung=ag.uniform(0.115, 0.135),
        pedestal=ag.uniform(0.125, 0.15),
        apron=ag.uniform(0.19, 0.22),
        otherwise=ag.uniform(0.15, 0.20),
        unit="m",
        within=(0.09, 0.25),
        doc="depth of a bowl",
    ),
    rim: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.72, 0.77),
        hung=ag.uniform(0.82, 0.87),
        pedestal=ag.uniform(0.80, 0.86),
        otherwise=ag.uniform(0.86, 0.92),
        unit="m",
        within=(0.65, 1.0),
        doc="height of the worktop or of the rim",
    ),
    margin: ag.Float = ag.uniform(0.05, 0.12, "m", within=(0.04, 0.3), doc="of a worktop beside the sink"),
    tap: Literal["gooseneck", "pull_down", "beam", "pair"] = ag.by(
        "style",
        vessel="beam",
        hung={"beam": 0.65, "pair": 0.35},
        pedestal={"beam": 0.4, "pair": 0.6},
        otherwise={"gooseneck": 0.5, "pull_down": 0.5},
    ),
    height: ag.Float = ag.by(
        "tap",
        gooseneck=ag.uniform(0.32, 0.42),
        pull_down=ag.uniform(0.40, 0.45),
        pair=ag.uniform(0.145, 0.19),
        beam=ag.by("style", vessel=ag.uniform(0.20, 0.25), otherwise=ag.uniform(0.070, 0.10)),
        unit="m",
        within=(0.05, 0.45),
        doc="height of the spout, or of the column under a straight one",
    ),
    reach: ag.Float = ag.by(
        "tap",
        beam=ag.uniform(0.120, 0.150),
        pair=ag.uniform(0.115, 0.15),
        otherwise=ag.uniform(0.18, 0.22),
        unit="m",
        within=(0.1, 0.26),
    ),
    spout: Literal["gooseneck", "arc", "angular"] = ag.choice(
        "arc", "angular", doc="spout between two handles"
    ),
    grip: handles.HandleStyle = ag.choice("lever", "blade", "cross", doc="style of two handles"),
    lever: handles.LeverStyle = ag.choice("rod", "blade", "paddle", doc="lever of a mixer"),
    square: bool = ag.choice(False, True, doc="whether a straight spout is flat"),
    plug: Literal["basket", "knob", "stopper", "rod"] = ag.by(
        "style",
        vessel="stopper",
        hung="stopper",
        pedestal={"stopper": 0.4, "rod": 0.6},
        otherwise={"basket": 0.55, "knob": 0.45},
        doc="a basket or stopper that lifts off, or a knob or rod that moves it",
    ),
    metal: ag.Material = _METALS,
    shell: ag.Material = ag.by(
        "style",
        inset=ag.choice({_STEEL: 0.6, **_STONES}),
        undermount=ag.choice({_STEEL: 1.6, **_STONES}),
        apron=ag.choice({_CLAY: 1.6, _STEEL: 0.5, **_STONES}),
        otherwise=sanitary.GLAZES,
        doc="material of the bowl",
    ),
    top: ag.Material = ag.by(
        "style",
        inset=ag.choice("oak", "walnut", "beech", "granite", "black_granite", *DECORS[:2]),
        undermount=ag.choice("granite", "black_granite", "marble", "green_marble"),
        otherwise=ag.choice("oak", "walnut", "marble", "black_granite", "granite"),
        doc="material of the worktop",
    ),
    finish: ag.Material = ag.choice(*LACQUERS[:8], *WOODS[:3], *MELAMINES[:2], doc="boards of a cabinet"),
    doors: Literal[0, 2] = ag.by(
        "stand", cabinet=ag.by("style", vessel={0: 0.3, 2: 0.7}, otherwise=2), otherwise=0, doc="of a cabinet"
    ),
    front: FrontStyle = ag.choice("flat", "shaker", "ramped", doc="style of the doors"),
    pull: Literal["knob", "bar"] = ag.choice("knob", "bar", doc="kind of the handles of doors"),
    handle: ag.Generator = ag.by("pull", _PULLS),
    swing: ag.Float = ag.uniform(1.6, 2.0, "rad", doc="angle of an open door", within=(0.5, 2.2)),
    tiles: ag.Material = sanitary.TILES,
    tile: ag.Float = ag.uniform(0.10, 0.30, "m", within=(0.1, 0.4), doc="height of the tiles of a wall"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a sink with the plug in its drain and with its tap shut; worktops and walls are at the back."""
    ag.require((style in KITCHEN) == (tap in ("gooseneck", "pull_down")), "kitchens have high spouts")
    ag.require((style in KITCHEN) == (plug in ("basket", "knob")), "kitchens have strainers")
    ag.require(style not in ("vessel", "hung") or plug != "rod", "a lift rod is for style=pedestal")
    ag.require(stand != "none" or style == "inset", "stand=none is for style=inset, which has a rim")
    if shape == "round" and style in ("hung", "pedestal"):
        most = "width of a round washbasin must be <= 0.65 m and at most 0.23 m more than deep"
        width = ag.require(width, ag.max_(width - 0.65, width - deep - 0.23) <= 0.0, most)
    ag.require(doors == 0 or stand == "cabinet", "doors are for stand=cabinet")
    require_suited(handle, "pull", pull, _PULLS)
    look = FrontLook(front, finish, 0.058, "square", 0.018, _GLASS, (1, 1))
    cabinet = Cabinet(look, doors, lambda name: handle(finish=metal, name=name, **_PLACED[pull]), swing)
    middle: ag.Scalar = 0.0
    plan = Plan(style, stand, _POWERS[shape], width, deep, hollow, rim, margin, shell, metal, top, cabinet)
    if style in KITCHEN:
        body, places, ledge, middle = kitchen(plan, bowls, drainer)
    elif style == "vessel":
        over = "the tap of a vessel must be 0.034 m higher: raise height, or lower hollow"
        height = ag.require(height, height - hollow >= 0.034, over)
        body, places, ledge = vessel(plan)
    else:
        body, places, ledge = washbasin(plan, maker, tiles, tile)
    body = _tapped(body, plan, ledge, tap, height, reach, spout, grip, lever, square=square)
    return _drained(body, plan, places, plug, middle)


def _tapped(
    body: ag.Body,
    plan: Plan,
    ledge: ag.Scalar,
    tap: str,
    height: ag.Scalar,
    reach: ag.Scalar,
    spout: spouts.SpoutStyle,
    grip: handles.HandleStyle,
    lever: handles.LeverStyle,
    *,
    square: bool,
) -> ag.Body:
    """Set a tap on the sink, or on the worktop behind it."""
    girth, radius, disc = 0.0120, 0.0235, 0.5
    length = 0.095 if plan.style in KITCHEN else 0.082
    place, tube = stands.Ledge(body, ledge), spouts.Spout(reach, girth, plan.metal)

    def mixer(size: float) -> ag.Body:
        return handles.mixer(lever, length, plan.metal, 0.45, disc, size)

    match tap:
        case "beam":
            stand = stands.topped_column(
                place, radius, height, taps.ring_of(girth), mixer(radius), plan.metal
            )
            spout = "beam"
        case "pair":
            stand = stands.widespread(place, girth, plan.metal)
        case _:
            stand = stands.sided_column(place, radius, mixer(stands.SIDE), "right", plan.metal)
            spout = "gooseneck"
    body = taps.attach_spout(
        stand,
        tube,
        "pull_down" if tap == "pull_down" else spout,
        height,
        hub=radius,
        square=square,
        head=(0.06, 11.0),
        lever=length,
        turn=1.5 if plan.style in KITCHEN else 1.1,
        friction=1.0,
    )
    if stand.valves:
        pair = (stand.valves, grip, 0.062, plan.metal, plan.metal, disc)
        body = handles.install_pair(
            body, *pair, flange=True, from_tip=False, lean=0.4 if plan.stand == "wall" else 0.0
        )
    return handles.running(body, pair=bool(stand.valves))


def _drained(body: ag.Body, plan: Plan, places: list[ag.Vector], plug: str, middle: ag.Scalar) -> ag.Body:
    """Put drains with plugs and traps under the bowls; stand all of it with its middle on the floor."""
    if plug == "rod":
        at, thick = places[0], plan.wall
        body = drain.install(
            body, at, stands.ROD_AT - at.y, thick + 0.004, plan.metal, 7.0, above=plan.hollow
        )
    elif plug == "stopper":
        body = drain.stopped(body, places[0], 0.054 if plan.style == "vessel" else plan.wall, plan.metal)
    else:
        turn = None
        if plug == "knob":
            turn = controls.dial_turn(low=0.0, high=math.pi / 2, friction=0.12)
            knob = controls.control_knob(
                finish=plan.metal, style="round", radius=0.018, depth=0.022, mark=controls.DARK_INK
            )
            waste = Fitting.moving(knob, turn).rotate(ag.X, -math.pi / 2).rotate(ag.Z, math.pi / 2)
            body = body.install(waste, at=(-0.125, 0.0, 0.0025 if plan.style == "inset" else 0.0))
        for number, at in enumerate(places):
            suffix = "" if number == 0 else "_right"
            body = _strained(body, at, suffix, turn if number == 0 else None)
    for at in places:
        body = ag.weld(body, _trap(plan, at))
    return body.at(x=-middle, z=plan.rim)


def _strained(body: ag.Body, at: ag.Vector, suffix: str, knob: ag.Joint | None) -> ag.Body:
    """Put a strainer with its basket into the floor of a bowl; a knob lifts the basket, or a hand does."""
    steel, low = ag.material("stainless"), -_CUP
    cup = ag.box(0.082, 0.082, 0.004).at(z=low + 0.001)
    bore = HOLE - 0.001
    rim = [(bore, low + 0.003), (bore + 0.0006, -0.006), (bore + 0.004, -0.0002), (0.0605, -0.0004)]
    rim += [(0.0595, 0.0011), (bore + 0.005, 0.0013), (bore, -0.006), (bore - 0.0006, low + 0.003)]
    pipe = ag.cylinder(0.019, 0.10).at(z=low - 0.0505)
    fixed = ag.weld(
        ag.part([cup, pipe], "drain", steel.with_(name="strainer_steel", density=3000.0)),
        ag.detail(ag.revolve(ag.polygon(rim)), "drain", steel),
    )
    floor = low + 0.0045
    disc = ag.cylinder(0.0330, 0.003, bevel=0.0008).at(z=floor + 0.0015)
    neck = ag.cylinder_between((0, 0, floor + 0.002), (0, 0, 0.006), 0.0035)
    knot = ag.cylinder(0.0095, 0.013, bevel=0.003).at(z=0.0105)
    side = [(0.0318, floor + 0.0006), (0.0366, -0.003), (0.0385, 0.0004), (0.0385, 0.0014), (0.0372, 0.0012)]
    side += [(0.0356, -0.003), (0.0308, floor + 0.0010)]
    holes = [ag.circle(0.0022).at(r * math.cos(a), r * math.sin(a)) for r, a in _sieve()]
    film = details.printed(
        functools.reduce(operator.or_, holes),
        (0, 0, floor + 0.003),
        facing=ag.Z,
        material=controls.DARK_INK,
        label="basket",
        proud=0.0001,
    )
    hold = ag.grasp_on(knot, approach=-ag.Z, closing=ag.Y, depth=0.0095)  # half a bowl is narrow
    basket = ag.weld(
        ag.part(ag.union(disc, neck, knot), "basket", steel, name="strainer", grasp=hold),
        ag.detail(ag.revolve(ag.polygon(side)), "basket", steel),
        film,
    )
    moves = drain.lifted("strainer_lift")
    if knob is not None:
        stroke = (_LIFT / (math.pi / 2)) * knob
        moves = ag.Prismatic("strainer_slide", axis=ag.Z, follows=stroke, damping=2.0, armature=0.01)
    return body.install(Fitting.moving(basket, moves, fixed=fixed).suffixed(suffix), at=at)


def _sieve() -> list[tuple[float, float]]:
    """Return radii and angles of the holes of a basket."""
    rings = ((0.013, 8), (0.020, 14), (0.027, 20))
    return [(radius, math.tau * step / count) for radius, count in rings for step in range(count)]


def _trap(plan: Plan, at: ag.Vector) -> ag.Body:
    """Make a bottle trap below a drain, with its pipe to the wall."""
    kitchen = plan.style in KITCHEN
    low = at - ag.Z * (0.13 if kitchen else drain.HANGS - 0.004)
    bottle = ag.cylinder(0.030, 0.11, bevel=0.004).align(low, z=1)
    end = ag.vector(at.x, BACK - 0.012, low.z - 0.035)
    arm = ag.cylinder_between(low - ag.Z * 0.035, end, 0.016)
    finish = _WHITE if kitchen else plan.metal
    return ag.part(bottle | arm, "trap", casting(finish, 0.3))
