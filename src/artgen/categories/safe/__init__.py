"""A safe for a hotel, a home, papers in a fire, or guns: bolts hold its door until a handle draws them.

Links: `body` with its shelf; `door`; `bolts`, with the bar that joins them; `tongue`, the bolt of the lock;
`handle`; `key`, `dial`, or the keys of a keypad, `button_0` to `button_11`. Joints: `door_hinge`;
`bolts_slide`, which follows `handle_turn`; `tongue_slide`, which follows `key_turn` or the last turn of the
dial, `dial_turn`, or which the solenoid of the keypad drives; `button_slide_0` to `button_slide_11`.

At 0 all is locked. The tongue stands behind an arm of the bar until the lock lifts it, so that the handle
does not turn before; the bolts stand behind the frame of the body until the handle draws them.

Sizes are those of shops: hotel safes are 400-430 mm wide and 195-250 mm high for laptops, 10-17 kg; home
safes 310-380 by 200-300 mm, 8-20 kg; fire safes (UL 72) 410-460 by 420-620 mm with walls of 45-55 mm, 26-80
kg; gun cabinets (EN 14450 S1) 300-450 mm wide and 1.3-1.5 m high of sheet of 3 mm, 45-100 kg. Bolts are
16-25 mm thick. Handles turn by 60-90 degrees with 0.2-0.6 N m (EN 1906 allows 2.4 N m for levers of doors),
keys of cylinders with 0.1 N m, solenoids pull 2-8 N over 8-13 mm (catalogs of boltworks and of locks).
"""

import functools
import math
import operator
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, locks
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["hotel", "home", "fire", "gun"]
"""A wide safe for a laptop, a small one, one with thick walls, or a tall cabinet with a rack."""

Lock = Literal["keypad", "dial", "key"]
"""A keypad with a solenoid, the dial of a combination lock, or a key in a cylinder."""

Handle = Literal["knob", "lever", "spokes"]
"""What draws the bolts: a knob with a bar, a lever, or spokes with balls."""

_LIP = 0.018  # width of the frame in front of the cavity [m]
_PLAY = 0.0010  # gap between the bolts and the frame: play of the locked door [m]
_PIN = 0.0065  # radius of the hinges [m]
_SKIN = 0.0025  # sheet of the cover over the bolts [m]
_RISE = 0.0125  # travel of the tongue [m]
_ARM = 0.006  # half of the height of the arm that the tongue stands behind [m]
_FREE = 0.94  # share of a turn from which on the next part is free
_DIAL = 5.2  # last turn of a dial, which draws its tongue [rad]
_KEYS = ("1", "2", "3", "4", "5", "6", "7", "8", "9", "*", "0", "#")
_PITCH = 0.0195  # distance of keys [m]
_CAP = 0.0140  # width of a key [m]

_STEEL = ag.material("black_steel")
_SHEETS = ag.shades(
    *colors("powder_coat", "black graphite light_grey white sand navy forest burgundy"),
    "hammered_bronze",
    weights=(3, 2, 2, 1.5, 1, 1, 1, 0.7, 1),
    color=0.04,
)
_METALS = ag.choice("chrome", "satin_nickel", "black_steel", "satin_brass", weights=(4, 2, 1.5, 1))
_DENSITY = {"hotel": 5200.0, "home": 5200.0, "fire": 620.0, "gun": 6200.0}
"""Density of the walls: thinner sheet than here, or the filling of a fire safe [kg/m3]."""

_FRONTS = {"black": ag.material("powder_coat_black"), "stainless": ag.material("stainless")}
_BLACK = ag.material("black_abs")
_CARPET = ag.material("fabric").with_(name="safe_carpet", base_color=(0.035, 0.037, 0.042))
_SOLENOID = feel.Feel(friction=0.6, damping=2.0, armature=0.02, effort=6.0)


@dataclass(frozen=True)
class _Plan:
    """Measures of one safe, with the center of its floor at the origin of x and y."""

    case: ag.Region
    wall: ag.Scalar  # thickness of the walls [m]
    flange: ag.Scalar  # thickness of frame and door plate [m]
    bolt: float  # radius of the bolts [m]

    @property
    def cavity(self) -> ag.Region:
        """Return the room inside."""
        return self.case.shrink(self.wall, front=self.flange)

    @property
    def opening(self) -> ag.Region:
        """Return the opening in the front."""
        front = self.case.y.low
        return self.case.shrink(x=self.wall + _LIP, z=self.wall + _LIP).with_(y=(front, front + self.flange))

    @property
    def pivot(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return a point on the axis of the door."""
        return (self.opening.x.low - 0.001, self.case.y.low - _PIN - FIT.running, 0.0)

    def swept(self, deep: ag.Scalar) -> ag.Scalar:
        """Return the gap at the free edge of what reaches to a depth behind the front [m]."""
        reach = deep + _PIN + 0.001
        return 0.0025 + 0.53 * reach * reach / self.opening.x.size

    @property
    def plate(self) -> ag.Region:
        """Return the plate of the door."""
        return self.opening.shrink(0.002, y=0, right=self.swept(self.flange))

    @property
    def cover(self) -> ag.Region:
        """Return the box over the bolts behind the plate."""
        deep = self.flange + 2 * (self.bolt + _PLAY) + _SKIN
        back = self.case.y.low + deep
        room = self.opening.shrink(0.008, y=0, right=self.swept(deep) + 0.001)
        return room.with_(y=(self.plate.y.high, back))

    @property
    def throw(self) -> ag.Scalar:
        """Return the travel of the bolts [m]."""
        return self.opening.x.high + _LIP - 0.004 - self.cover.x.high

    @property
    def stop(self) -> ag.Scalar:
        """Return the end of the arm of the bar, past the reach of the drawn bar along x [m]."""
        return self.cover.x.high - 0.046 - self.throw

    @property
    def level(self) -> ag.Scalar:
        """Return the distance of the bolts behind the front [m]."""
        return self.case.y.low + self.flange + self.bolt + _PLAY

    def rods(self, count: int) -> list[ag.Scalar]:
        """Return the heights of the bolts [m]."""
        z = self.cover.z
        return [z.mid + 0.37 * z.size * (2 * index / (count - 1) - 1) for index in range(count)]


@ag.category(
    labels="body door hinge bolt tongue shelf lining handle key cylinder dial button panel bezel "
    "display print",
    joints=(5, 16),
)
def safe(
    *,
    style: Style = ag.choice({"hotel": 0.26, "home": 0.3, "fire": 0.22, "gun": 0.22}),
    lock: Lock = ag.by(
        "style",
        hotel="keypad",
        home={"keypad": 0.45, "key": 0.3, "dial": 0.25},
        fire={"keypad": 0.3, "key": 0.1, "dial": 0.6},
        gun={"keypad": 0.35, "key": 0.35, "dial": 0.3},
    ),
    handle: Handle = ag.by(
        "style",
        hotel="knob",
        home={"knob": 0.5, "lever": 0.5},
        fire={"lever": 0.5, "spokes": 0.5},
        gun={"lever": 0.3, "spokes": 0.7},
    ),
    width: ag.Float = ag.by(
        "style",
        hotel=ag.uniform(0.400, 0.430),
        home=ag.uniform(0.310, 0.380),
        fire=ag.uniform(0.410, 0.460),
        gun=ag.uniform(0.300, 0.450),
        unit="m",
        within=(0.30, 0.60),
        doc="width of the body",
    ),
    height: ag.Float = ag.by(
        "style",
        hotel=ag.uniform(0.200, 0.250),
        home=ag.uniform(0.230, 0.300),
        fire=ag.uniform(0.420, 0.620),
        gun=ag.uniform(1.30, 1.50),
        unit="m",
        within=(0.20, 1.6),
        doc="height of the body",
    ),
    depth: ag.Float = ag.by(
        "style",
        hotel=ag.uniform(0.350, 0.400),
        home=ag.uniform(0.220, 0.300),
        fire=ag.uniform(0.400, 0.480),
        gun=ag.uniform(0.280, 0.400),
        unit="m",
        within=(0.20, 0.6),
        doc="depth of the body",
    ),
    wall: ag.Float = ag.by(
        "style",
        fire=ag.uniform(0.045, 0.055),
        otherwise=ag.uniform(0.0028, 0.0036),
        unit="m",
        within=(0.0025, 0.06),
        doc="thickness of the walls",
    ),
    bolts: int = ag.by("style", hotel=2, home={2: 0.7, 3: 0.3}, fire={2: 0.4, 3: 0.6}, gun={3: 0.4, 4: 0.6}),
    spokes: int = ag.choice({3: 0.6, 5: 0.4}, doc="spokes of a handle with balls"),
    opens: ag.Float = ag.uniform(1.7, 2.1, "rad", within=(1.2, 2.2), doc="angle of the open door"),
    turn: ag.Float = ag.uniform(1.05, 1.5, "rad", within=(0.9, 1.6), doc="range of the handle"),
    torque: ag.Float = ag.uniform(0.2, 0.6, "N m", within=(0.1, 1.0), doc="friction of the handle"),
    paint: ag.Material = _SHEETS,
    front: Literal["plain", "black", "stainless"] = ag.choice(
        {"plain": 0.7, "black": 0.15, "stainless": 0.15},
        doc="finish of the door: that of the body, or its own",
    ),
    metal: ag.Material = _METALS,
    stripe: bool = ag.by("lock", dial={True: 0.6, False: 0.4}, otherwise={True: 0.2, False: 0.8}),
    code: str = ag.by(
        "style",
        hotel={"0000": 1, "8888": 1, "----": 1, "OPEN": 1},
        otherwise="",
        doc="figures on the display",
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a locked safe."""
    thick, least = style == "fire", {"fire": 0.42, "gun": 0.6}.get(style, 0.2)
    height = ag.require(height, height >= least, f"height of a {style} safe must be >= {least:g} m")
    room = {("home", "spokes"): 0.42, ("fire", "spokes"): 0.35, ("hotel", "lever"): 0.37}.get(
        (style, handle), 0.3
    )
    width = ag.require(width, width >= room, f"{handle} of a {style} safe: width must be >= {room:g} m")
    if thick:
        wall = ag.require(wall, wall >= 0.02, "wall of a fire safe must be >= 0.02 m")
    else:
        wall = ag.require(wall, wall <= 0.01, "only fire safes have thick walls: wall must be <= 0.01 m")
    plan = _Plan(
        ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (0, height)),
        wall,
        wall - 0.012 if thick else 0.006,
        {"hotel": 0.0085, "home": 0.009, "fire": 0.0115, "gun": 0.0115}[style],
    )
    sheet = paint.with_(name=f"{paint.name}_{style}", density=_DENSITY[style])
    leaf = sheet if front == "plain" else _FRONTS[front].with_(name=f"{front}_door", density=sheet.density)
    door, free = _locked(
        _door(plan, style, leaf, maker, bolts=bolts, stripe=stripe), plan, style, lock, metal, code
    )
    played = free.beyond(0.85 * _PLAY * turn / plan.throw)
    drag = feel.Feel(friction=torque, damping=0.03, armature=3e-3, effort=1.5)
    pull = ag.Revolute("handle_turn", axis=ag.Y, limits=(0, turn), feel=drag, needs=played)
    draw = ag.Prismatic(
        "bolts_slide", axis=-ag.X, follows=(plan.throw / turn) * pull, damping=4.0, friction=0.5, armature=2.0
    )
    (x, z), (_, level) = _places(plan, style)
    door = door.attach(_handle(handle, spokes, metal), pull, at=(x, plan.case.y.low, z))
    door = door.attach(_bolts(plan, bolts, level), draw)
    wide = plan.opening.x.size
    swing = ag.Revolute(
        "door_hinge",
        axis=-ag.Z,
        pivot=plan.pivot,
        limits=(0, opens),
        feel=feel.HINGE,
        friction=0.3,
        needs=(pull > _FREE * turn)
        .until(1.15 * (plan.flange + 2 * plan.bolt + _PIN + 0.005) / wide)
        .beyond(0.6 * _PLAY / wide),
    )
    return _body(plan, style, sheet).attach(door, swing)


def _places(plan: _Plan, style: Style) -> tuple[tuple[ag.Scalar, ag.Scalar], tuple[ag.Scalar, ag.Scalar]]:
    """Return the places of the handle and of the lock in the plate, x and z [m]."""
    x, z = plan.plate.x, plan.plate.z
    match style:
        case "hotel":
            return (x.at(0.42), z.mid), (x.high - 0.070, z.mid)
        case "home":
            return (x.at(0.64), z.mid), (x.at(0.32), z.mid)
        case "fire":
            return (x.at(0.58), z.mid - 0.075), (x.at(0.58), z.mid + 0.075)
        case "gun":
            return (x.at(0.58), z.at(0.52)), (x.at(0.58), z.at(0.52) + 0.155)


def _hinges(plan: _Plan, *, moving: bool) -> list[ag.Solid]:
    """Make the knuckles on the door, or those on the body below them, with their tabs."""
    x, y, _ = plan.pivot
    front, level = plan.case.y.low, 0.42 * plan.opening.z.size - 0.030
    tall = ag.Region((x, x), (front - 0.0028, front - 0.0005), (0.0004, 0.030))
    if moving:
        inner = tall.with_(x=(plan.plate.x.low + 0.001, plan.plate.x.low + 0.013)).grow(back=0.001)
        knuckle = ag.union(tall.with_(x=(x, plan.plate.x.low + 0.012)).box(), inner.box())
    else:
        knuckle = tall.grow(left=0.013, back=0.001).at(z=-0.0304).box()
    barrel = ag.cylinder(_PIN - (0.0003 if moving else 0.0), 0.0296, bevel=0.001)
    knuckle |= barrel.at(x, y, 0.0152 if moving else -0.0152)
    return [knuckle.at(z=plan.opening.z.mid + way * level) for way in (-1, 1)]


def _body(plan: _Plan, style: Style, sheet: ag.Material) -> ag.Body:
    """Make the body with its lining, its shelf and, for guns, a rack."""
    room, front = plan.cavity, plan.opening.grow(front=0.01, back=0.001)
    shell = plan.case.box(bevel=0.012 if style == "fire" else 0.002) - room.box() - front.box()
    floor = ag.detail(room.with_(z=(room.z.low - 0.0005, room.z.low + 0.002)).box(), "lining", _CARPET)
    body = ag.weld(
        ag.part(shell, "body", sheet), ag.part(_hinges(plan, moving=False), "hinge", _STEEL), floor
    )
    inside = room.grow(x=0.0005, back=0.0005).with_(y=(plan.cover.y.high + 0.012, room.y.high + 0.0005))
    if style == "hotel":
        return body
    level = room.z.at(0.82 if style == "gun" else 0.5)
    boards = [inside.with_(z=(level, level + 0.003)).box()]
    boards.append(
        inside.with_(z=(level - 0.014, level + 0.001), y=(inside.y.low, inside.y.low + 0.003)).box()
    )
    body = ag.weld(body, ag.part(boards, "shelf", sheet))
    if style != "gun":
        return body
    level = room.z.at(0.58)
    rack = inside.with_(z=(level, level + 0.022)).grow(front=-0.45 * room.y.size)
    notches = [ag.cylinder(0.017, 0.05).at(rack.x.at(share), rack.y.low, level) for share in (0.2, 0.5, 0.8)]
    return ag.weld(body, ag.part(rack.box() - ag.union(*notches), "shelf", ag.material("foam")))


def _door(plan: _Plan, style: Style, sheet: ag.Material, maker: str, *, bolts: int, stripe: bool) -> ag.Body:
    """Make the door with the box over its bolts, hinges, the maker's name and a thin stripe."""
    plate, cover = plan.plate, plan.cover.grow(front=0.0005)
    channel = cover.shrink(_SKIN, front=0, right=0.004)
    half = plan.bolt + FIT.running
    hole = ag.Region(
        (cover.x.high - 0.01, cover.x.high + 0.01), (plan.level - half, plan.level + half), (-half, half)
    )
    holes = [hole.at(z=z).box() for z in plan.rods(bolts)]
    box = cover.box() - channel.box() - ag.union(*holes)
    face = plate.y.low
    door = ag.weld(
        ag.part([plate.box(bevel=0.0012), box], "door", sheet, name="door"),
        ag.part(_hinges(plan, moving=True), "hinge", _STEEL),
    )
    ink = controls.ink_on(sheet)
    at = (plate.x.mid, face, plate.z.high - 0.022)
    door = ag.weld(door, details.printed(details.logo(maker, 0.006), at, material=ink))
    if style == "fire":
        words = details.lettering(("FIRE RESISTANT", "60 MIN"), 0.0042, tracking=0.1)
        door = ag.weld(
            door, details.printed(words, (plate.x.low + 0.06, face, plate.z.low + 0.022), material=ink)
        )
    if stripe:
        outer = ag.rectangle(plate.x.size - 0.022, plate.z.size - 0.022, radius=0.006)
        line = outer - ag.rectangle(plate.x.size - 0.026, plate.z.size - 0.026, radius=0.005)
        gold = ag.material("satin_brass")
        door = ag.weld(door, details.printed(line, (plate.x.mid, face, plate.z.mid), material=gold))
    return door


def _bolts(plan: _Plan, count: int, level: ag.Scalar) -> ag.Body:
    """Make the thrown bolts on their bar, with the arm that the tongue of the lock stands before."""
    cover, deep = plan.cover, plan.bolt - 0.0015
    tip, start = plan.cover.x.high + plan.throw, cover.x.high - 0.030
    bar = ag.Region((start - 0.012, start + 0.003), (plan.level - deep, plan.level + deep), cover.z)
    rods = plan.rods(count)
    bar = bar.with_(z=(rods[0] - plan.bolt, rods[-1] + plan.bolt))
    arm = bar.with_(x=(plan.stop, start - 0.011), z=(level - _ARM, level + _ARM)).shrink(y=0.001)
    rod = ag.cylinder(plan.bolt, tip - start, axis=ag.X, bevel=0.0012).at((tip + start) / 2, plan.level)
    thrown = [rod.at(z=z) for z in rods]
    return ag.part(ag.union(bar.box(), arm.box(), *thrown), "bolt", ag.material("chrome"), name="bolts")


def _locked(
    door: ag.Body, plan: _Plan, style: Style, lock: Lock, metal: ag.Material, code: str
) -> tuple[ag.Body, ag.Condition]:
    """Add the lock with its tongue; return the door and the condition under which its handle turns."""
    _, (x, z) = _places(plan, style)
    at = (x, plan.case.y.low, z)
    start = plan.stop - _PLAY
    deep = plan.bolt - 0.0025
    block = ag.Region((start - 0.016, start), (plan.level - deep, plan.level + deep), (z - 0.005, z + 0.005))
    tongue = ag.part(block.box(bevel=0.0006), "tongue", ag.material("steel"))
    if lock == "keypad":
        slide = ag.Prismatic(
            "tongue_slide", axis=ag.Z, limits=(0, _RISE), feel=_SOLENOID, driven="the solenoid of the keypad"
        )
        door = _coded(door.install(_keypad(code), at=at))
        return door.attach(tongue, slide), slide > 0.97 * _RISE
    most = math.pi / 2 if lock == "key" else _DIAL
    fitting, turn = _key(plan.flange, metal) if lock == "key" else _dial(metal)
    slide = ag.Prismatic("tongue_slide", axis=ag.Z, follows=(_RISE / most) * turn, damping=2.0, friction=0.2)
    return door.install(fitting, at=at).attach(tongue, slide), turn > 0.97 * most


def _coded(door: ag.Body) -> ag.Body:
    """Let keys beep, and let the last one draw the tongue for a time after a figure."""
    *figures, enter = [f"button_slide_{number}" for number in range(len(_KEYS))]
    typed = controls.any_pressed(figures)
    door = door.output("beep", typed | signals.pressed(enter), kind="sound")
    free = signals.timer(signals.pressed(enter) & signals.timer(typed, 10.0), 5.0)
    return door.output("unlocking", free, kind="motor", moves="tongue_slide", speed=0.05)


def _key(thick: ag.Scalar, metal: ag.Material) -> tuple[Fitting, ag.Joint]:
    """Make a key in its cylinder through a plate."""
    radius = 0.0085
    solids, hold = locks.inserted_key(thick, radius=radius)
    turn = ag.Revolute("key_turn", axis=ag.Y, limits=(0, math.pi / 2), feel=feel.DETENT)
    collar = ag.extrude(ag.ring(0.0180, radius + 0.0004), 0.0022, axis=ag.Y, bevel=0.0006).at(y=-0.0006)
    made = ag.part(solids, "key", metal, name="key", grasp=hold)
    cut = ag.bore(radius + FIT.sliding, 2 * thick + 0.01, axis=ag.Y)
    return Fitting.moving(made, turn, fixed=ag.detail(collar, "cylinder", metal), cut=cut), turn


def _dial(metal: ag.Material) -> tuple[Fitting, ag.Joint]:
    """Make the dial of a combination lock, with its ring on the door."""
    skirt = ag.frustum(0.040, 0.037, 0.006, axis=-ag.Y, bevel=0.0008).at(y=-0.0046)
    grip = ag.frustum(0.0195, 0.0175, 0.022, axis=-ag.Y, bevel=0.0015).at(y=-0.0180)
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.018)
    numbers = [str(number) for number in range(0, 100, 10)]
    scale = details.dial_scale(
        0.0285,
        50,
        sweep=math.tau,
        major_every=5,
        length=0.0018,
        major_length=0.0030,
        numbers=numbers,
        number_height=0.0028,
    )
    cap = ag.cylinder(0.0145, 0.0008, axis=ag.Y, bevel=0.0002).at(y=-0.0292)
    dial = ag.weld(
        ag.part([grip, skirt], "dial", _BLACK, name="dial", grasp=hold),
        ag.detail(cap, "dial", metal),
        details.printed(scale, (0, -0.0076, 0), material=controls.LIGHT_INK),
    )
    turn = ag.Revolute("dial_turn", axis=ag.Y, limits=(0, _DIAL), feel=feel.DIAL)
    ring = ag.extrude(ag.ring(0.0455, 0.0415), 0.006, axis=ag.Y, bevel=0.0012).at(y=-0.0028)
    mark = details.printed(
        ag.polygon([(0, 0.0420), (-0.0022, 0.0452), (0.0022, 0.0452)]), (0, -0.0058, 0), material=_BLACK
    )
    return Fitting.moving(dial, turn, fixed=ag.weld(ag.detail(ring, "bezel", metal), mark)), turn


def _keypad(code: str) -> Fitting:
    """Make a keypad of twelve keys in a housing, with a display above them or without."""
    out, rim, more = 0.0110, 0.0105, 0.026 if code else 0.0
    keys = ag.Region.centered(2 * _PITCH + _CAP, 0.0, 3 * _PITCH + _CAP).at(z=-more / 2)
    housing = keys.grow(x=rim, bottom=rim, top=rim + more).with_(y=(-out, 0.0)).grow(back=0.0005)
    pocket = keys.grow(x=0.0012, z=0.0012).with_(y=(-out - 0.01, -0.0025))
    panel = ag.part(housing.box(bevel=0.0025) - pocket.box(), "panel", _BLACK)
    if code:
        panel = ag.weld(
            panel, details.display(code, 0.044, 0.017, at=(0, -out, keys.z.high + 0.021), color="red")
        )
    holes = []
    for index, (sign, cell) in enumerate(zip(_KEYS, keys.grid(3, 4, gap=_PITCH - _CAP), strict=True)):
        at = (cell.x.mid, -out, cell.z.mid)
        cap = controls.button_cap(
            finish=_BLACK,
            shape="square",
            width=_CAP,
            proud=0.0035,
            deep=0.0055,
            icon=details.lettering((sign,), 0.0062),
            ink=controls.LIGHT_INK,
        )
        press = controls.button_press(travel=0.0020, preload=0.5, force=2.2)
        panel = panel.install(Fitting.moving(cap, press).suffixed(f"_{index}"), at=at)
        holes.append(ag.rectangle(_CAP + 0.0008, _CAP + 0.0008, radius=0.002).at(at[0], at[2] - keys.z.mid))
    grid = ag.rectangle(keys.x.size + 0.006, keys.z.size + 0.006, radius=0.003)
    sheet = ag.extrude(grid - functools.reduce(operator.or_, holes), 0.0012, axis=ag.Y)
    return Fitting(ag.weld(panel, ag.detail(sheet.at(0, -out, keys.z.mid), "bezel", _BLACK)))


def _handle(kind: Handle, spokes: int, metal: ag.Material) -> ag.Body:
    """Make the handle about its spindle on the plane y = 0."""
    hub = ag.cylinder(0.0165, 0.030, axis=ag.Y, bevel=0.002).at(y=-FIT.running - 0.015)
    if kind == "knob":
        mark = controls.ink_on(metal)
        return controls.control_knob(
            finish=metal, style="bar", radius=0.024, depth=0.030, mark=mark, label="handle", name="handle"
        )
    if kind == "lever":
        arm = ag.hull(
            ag.cylinder(0.0120, 0.013, axis=ag.Y, bevel=0.003),
            ag.cylinder(0.0080, 0.012, axis=ag.Y, bevel=0.003).at(0.085),
        ).at(y=-0.0365)
        hold = ag.grasp_on(arm, approach=ag.Y, closing=ag.Z, at=(0.068, -0.0365, 0), depth=0.013)
        return ag.part(hub.at(y=-0.008) | arm, "handle", casting(metal, 0.6), name="handle", grasp=hold)
    rod = ag.cylinder(0.0050, 0.066, axis=ag.Z).at(0, -0.0240, 0.043)
    ball = ag.sphere(0.0115).at(0, -0.0240, 0.080)
    arms = [each.rotate(ag.Y, math.tau * step / spokes) for step in range(spokes) for each in (rod, ball)]
    hold = ag.grasp_on(ball, approach=ag.Y, closing=ag.X, depth=0.015)
    return ag.part(ag.union(hub, *arms), "handle", metal, name="handle", grasp=hold)
