"""A refrigerator: one to three doors, freezer drawers, and an interior that moves only after its doors open.

Doors are hinged near their outer front corner. A drawer behind a door comes forward until it strikes the
closed door; it comes out further only after the door is open beyond an angle, which follows from the
dimensions of the door.

Links: `body`; `door`, or `door_left` and `door_right`; `freezer_door` (the flap of an ice box);
`inner_drawer_<n>` behind doors, crispers first; `outer_drawer_<n>` with their own fronts. Joints:
`door_hinge` (with `_left` and `_right` for two doors), `freezer_door_hinge`, `inner_drawer_slide_<n>`,
`outer_drawer_slide_<n>`.

Varied properties: layout, size, hand, look and shape of the fronts, handles, shelves, bins, drawers, ice box,
water dispenser, display, back, and all dimensions. Layouts with two doors side by side are wide, those with
one door narrow.

Sizes are those of appliance catalogs: under-counter 82-90 cm high, free-standing 55-76 cm wide and up to 183
cm high, American two-door models 33-36 in wide. Masses: 55-75 kg for a 60 cm combination, 100-130 kg for a
French-door model, 30-45 kg under a counter. A door needs 15-45 N at the handle against the magnets in the
gasket; UL 250 and IEC 60335-2-24 let a child push a door open from inside with 70 N.
"""

from collections.abc import Mapping, Sequence
from functools import partial, reduce
from operator import and_, or_
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.refrigerator import inside as interior
from artgen.categories.refrigerator.case import Back, cabinet
from artgen.categories.refrigerator.doors import SOFT, Finish, FrontForm, GripKind, door, outer_drawer
from artgen.categories.refrigerator.plan import COVER, Layout, Leaf, Plan, hinges
from artgen.categories.shared import appliances
from artgen.categories.shared.pulls import BarStyle

_FINISH, _METAL = appliances.fronts(), appliances.grip_metals()
_SEALS = {"white": ag.colored("silicone", "light_grey"), "grey": ag.colored("silicone", "grey")}
_WHITE = ag.material("glossy_plastic_white").with_(name="trim_white")
_TRIMS = (_WHITE, ag.material("aluminium"), _WHITE.with_(name="trim_smoke", base_color=(0.16, 0.17, 0.18)))
_WIRE_SHELVES = 6  # largest number of wire shelves in a refrigerator
_MORE = 0.12  # opening of a door beyond the angle that its drawers need [rad]


@ag.category(
    labels=(
        "body door freezer_door inner_drawer outer_drawer handle liner gasket shelf bin basket rail egg_tray "
        "ice_box dispenser panel display control light duct vent hinge mullion kick_plate foot compressor "
        "condenser cord rating_plate logo print"
    ),
    joints=(1, 7),
)
def refrigerator(
    *,
    layout: Layout = ag.choice(
        {"single": 0.22, "top_freezer": 0.17, "bottom_freezer": 0.25, "french": 0.2, "side_by_side": 0.16}
    ),
    build: Literal["under_counter", "medium", "tall"] = ag.by(
        "layout",
        single={"under_counter": 0.4, "medium": 0.3, "tall": 0.3},
        top_freezer={"medium": 0.35, "tall": 0.65},
        otherwise="tall",
    ),
    hand: Literal["left", "right"] = ag.choice("left", "right", doc="hinge side of a single door"),
    width: ag.Float = ag.by(
        "layout",
        single=ag.by("build", under_counter=ag.uniform(0.55, 0.60), otherwise=ag.uniform(0.58, 0.70)),
        top_freezer=ag.by("build", medium=ag.uniform(0.55, 0.62), otherwise=ag.uniform(0.58, 0.76)),
        bottom_freezer=ag.uniform(0.55, 0.76),
        otherwise=ag.uniform(0.83, 0.92),
        unit="m",
        within=(0.5, 1.1),
    ),
    depth: ag.Float = ag.by(
        "layout",
        single=ag.uniform(0.60, 0.68),
        top_freezer=ag.uniform(0.61, 0.72),
        bottom_freezer=ag.uniform(0.61, 0.72),
        otherwise=ag.uniform(0.66, 0.80),
        unit="m",
        doc="depth from front to back, without handles",
        within=(0.56, 0.9),
    ),
    height: ag.Float = ag.by(
        "layout",
        single=ag.by(
            "build",
            under_counter=ag.uniform(0.80, 0.90),
            medium=ag.uniform(1.20, 1.50),
            tall=ag.uniform(1.55, 1.83),
        ),
        top_freezer=ag.by("build", medium=ag.uniform(1.25, 1.50), otherwise=ag.uniform(1.50, 1.80)),
        bottom_freezer=ag.uniform(1.60, 1.83),
        otherwise=ag.uniform(1.70, 1.83),
        unit="m",
        within=(0.78, 2.1),
    ),
    look: appliances.Look = ag.by(
        "layout",
        single={"white": 3, "pastel": 3, "stainless": 2, "black": 1, "panel": 1, "dark_steel": 0.6},
        top_freezer={"white": 3, "stainless": 2.5, "pastel": 1.6, "black": 1, "dark_steel": 0.8},
        bottom_freezer={
            "stainless": 2.6,
            "white": 1.6,
            "pastel": 1.2,
            "dark_steel": 1,
            "glass": 1,
            "panel": 0.9,
            "black": 0.7,
        },
        otherwise={"stainless": 3, "dark_steel": 1.4, "white": 0.8, "black": 0.9, "glass": 1.1, "panel": 0.9},
    ),
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    form: FrontForm = ag.by(
        "look",
        pastel={"bowed": 0.75, "soft": 0.25},
        panel=ag.choice("framed", "flat"),
        white=ag.choice("soft", "flat"),
        glass="flat",
        otherwise={"flat": 0.65, "soft": 0.35},
        doc="finish of the fronts",
    ),
    bow: ag.Float = ag.uniform(0.008, 0.018, "m", doc="height of the bow of a front", within=(0.002, 0.03)),
    grip: GripKind = ag.by(
        "look",
        pastel="bar",
        otherwise=ag.by(
            "layout",
            french={"bar": 0.78, "recessed": 0.22},
            side_by_side={"bar": 0.72, "recessed": 0.28},
            otherwise={"bar": 0.56, "pocket": 0.18, "channel": 0.12, "recessed": 0.14},
        ),
        doc="style of the handles: bars, or grips in the front or its edge",
    ),
    bar: BarStyle = ag.by(
        "look",
        pastel=ag.choice("bow", "arched", "pro"),
        white=ag.choice("bow", "strap", "arched", "round"),
        panel=ag.choice("strap", "square", "pro", "round"),
        glass=ag.choice("square", "strap"),
        otherwise=ag.choice("round", "square", "pro", "arched", "strap"),
    ),
    girth: ag.Float = ag.uniform(
        0.0075, 0.0105, "m", doc="half of the width of a bar", within=(0.006, 0.014)
    ),
    grip_length: ag.Float = ag.uniform(
        0.30, 0.60, doc="handle length, share of the front", within=(0.2, 0.75)
    ),
    door_thickness: ag.Float = ag.by(
        "water",
        {True: ag.uniform(0.070, 0.078), False: ag.uniform(0.056, 0.070)},
        unit="m",
        within=(0.054, 0.09),
    ),
    wall: ag.Float = ag.uniform(0.046, 0.056, "m", doc="thickness of the sides", within=(0.044, 0.08)),
    gap: ag.Float = ag.uniform(0.0034, 0.0042, "m", doc="gap between two fronts", within=(0.0032, 0.006)),
    kick_height: ag.Float = ag.uniform(
        0.055, 0.095, "m", doc="height of the kick plate under the lowest front", within=(0.05, 0.14)
    ),
    freezer_share: ag.Float = ag.by(
        "layout",
        top_freezer=ag.uniform(0.25, 0.33),
        bottom_freezer=ag.uniform(0.31, 0.40),
        french=ag.uniform(0.32, 0.42),
        side_by_side=ag.uniform(0.40, 0.46),
        otherwise=0.3,
        doc="size of the freezer, as a share of the height or the width",
        within=(0.2, 0.55),
    ),
    outer_drawers: int = ag.by(
        "layout", bottom_freezer={0: 0.5, 1: 0.3, 2: 0.2}, french=ag.choice(1, 2), otherwise=0
    ),
    crispers: int = ag.by(
        "layout",
        single=ag.by("build", under_counter=ag.choice(0, 1), otherwise=ag.choice(0, 1, 2)),
        bottom_freezer=ag.by("outer_drawers", {0: ag.choice(0, 1)}, otherwise=ag.choice(1, 2)),
        french=ag.choice(2, 3),
        otherwise=ag.choice(1, 2),
        doc="number of drawers behind the door of the refrigerator",
    ),
    freezer_drawers: int = ag.by(
        "layout",
        bottom_freezer=ag.by(
            "outer_drawers", {0: ag.by("crispers", {0: ag.choice(2, 3)}, otherwise=2)}, otherwise=0
        ),
        side_by_side=ag.choice(0, 1),
        otherwise=0,
        doc="number of drawers behind the door of the freezer",
    ),
    crisper_height: ag.Float = ag.uniform(0.165, 0.215, "m", within=(0.155, 0.26)),
    ice_box: bool = ag.by("layout", single={False: 0.55, True: 0.45}, otherwise=False),
    shelves: int = ag.by(
        "build",
        under_counter=ag.by("ice_box", {True: 1, False: ag.choice(1, 2)}),
        medium=ag.choice(2, 3),
        tall=ag.by(
            "layout", single=ag.choice(3, 4, 5), side_by_side=ag.choice(3, 4), otherwise=ag.choice(2, 3)
        ),
    ),
    shelf_kind: interior.ShelfKind = ag.by(
        "layout", side_by_side="glass", french="glass", otherwise={"glass": 0.65, "wire": 0.35}
    ),
    freezer_shelves: int = ag.by(
        "layout", top_freezer=ag.choice(0, 1), side_by_side=ag.choice(3, 4), otherwise=0
    ),
    bins: int = ag.by(
        "build",
        under_counter=ag.choice(1, 2),
        medium=ag.choice(2, 3),
        tall=ag.choice(2, 3, 4),
        doc="number of bins on each door",
    ),
    bin_depth: ag.Float = ag.uniform(0.078, 0.105, "m", within=(0.05, 0.12)),
    egg_tray: bool = ag.choice(False, True),
    water: bool = ag.by(
        "layout",
        french={False: 0.5, True: 0.5},
        side_by_side={False: 0.35, True: 0.65},
        otherwise=False,
        doc="whether a door has a water dispenser",
    ),
    display: str = ag.by(
        "look",
        pastel="",
        panel="",
        otherwise={"": 0.6, "4 -18": 0.15, "3 -20": 0.15, "5": 0.1},
        doc="display on the door",
    ),
    control: Literal["dial", "touch"] = ag.by(
        "build", under_counter="dial", otherwise=ag.choice("dial", "touch")
    ),
    inside: Literal["white", "grey"] = ag.by(
        "look",
        dark_steel=ag.choice("white", "grey"),
        stainless={"white": 0.75, "grey": 0.25},
        otherwise="white",
    ),
    trim: ag.Material = ag.shades(*_TRIMS, color=0.03, doc="finish of the trim of shelves and bins"),
    back: Back = ag.by(
        "layout", french="panel", side_by_side="panel", otherwise=ag.choice("grille", "panel")
    ),
    maker: str = ag.choice(*details.BRANDS),
    swing: ag.Float = ag.uniform(
        1.6, 3.0, "rad", doc="opening angle of doors; larger if drawers need it", within=(1.6, 3.0)
    ),
    pull: ag.Float = ag.uniform(15.0, 20.0, "N", doc="force at the handle of a door", within=(2.0, 45.0)),
    door_damping: ag.Float = ag.uniform(1.0, 2.5, "N m s/rad"),
    flap_limit: ag.Float = ag.uniform(1.1, 1.4, "rad", doc="opening of an ice box flap", within=(0.5, 1.5)),
    drawer_share: ag.Float = ag.uniform(0.60, 0.80, doc="travel, as a share of the depth", within=(0.3, 0.9)),
    drawer_friction: ag.Float = ag.uniform(3.0, 8.0, "N", doc="friction of plastic drawers on plastic rails"),
    drawer_pull: ag.Float = ag.uniform(15.0, 30.0, "N", doc="force of gasket and runners of freezer drawers"),
) -> ag.Body:
    """Make a refrigerator: doors, freezer doors, drawers, shelves and bins inside."""
    ag.require(
        layout != "french" or outer_drawers > 0, "layout=french has drawers: outer_drawers must be 1 or 2"
    )
    ag.require(
        shelf_kind == "glass" or shelves + freezer_shelves <= _WIRE_SHELVES,
        f"wire shelves have many colliders: shelves + freezer_shelves must be <= {_WIRE_SHELVES}",
    )
    # drawers fill a freezer up to the flat inside of its door
    full = layout == "bottom_freezer" or (layout == "top_freezer" and freezer_drawers > 0)
    boxed = ice_box and layout == "single"
    outside = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (0, height - COVER))
    plan = Plan(
        layout,
        outside,
        thickness=door_thickness,
        wall=wall,
        gap=gap,
        kick=kick_height,
        share=freezer_share,
        ridge=bin_depth,
        freezer_ridge=None if full else 0.72 * bin_depth,
        bins=bins,
        drawers=outer_drawers,
    )
    light = look in ("white", "pastel")
    liner = appliances.LINER if inside == "white" else appliances.LINER_GREY
    pale = light and sum(finish.base_color) > 1.0  # navy, black and red have dark fittings
    seal = _SEALS["white" if pale else "grey"]
    shell = appliances.cabinet_finish(look, finish)
    style = Finish(finish, metal, liner, seal, trim, form, bow, grip, bar, girth, grip_length)
    corner = {"bowed": 0.012, "soft": SOFT}.get(style.form)
    kick = shell if light else ag.material("powder_coat_graphite")
    cover = _WHITE if pale else ag.material("black_abs")
    block = cabinet(plan, shell, liner, kick, back, corner)

    rows = _rows(crispers, stacked=layout in ("single", "side_by_side"))
    furnish = partial(interior.furnish, finish=style, kind=shelf_kind)
    cold = furnish(
        plan.cold,
        plan.doors[0],
        drawers=rows,
        drawer_height=crisper_height,
        shelves=shelves,
        iced=boxed,
        eggs=egg_tray,
        control=control,
        show=display or "4",
    )
    rooms = {"door": cold}
    if plan.freezer:
        drawers, tall = (1,) * freezer_drawers, None if full else crisper_height
        boards = 0 if full else freezer_shelves
        rooms["freezer_door"] = furnish(
            plan.freezer.cell, plan.freezer, drawers=drawers, drawer_height=tall, shelves=boards
        )
    fixed = [each for room in rooms.values() for each in room.bodies]
    body = ag.weld(block, *fixed, *hinges(plan, cover=cover, metal=metal))

    # a door opens at least as far as the parts behind it need
    swings: dict[str, ag.Joint] = {}
    flap = (interior.flap_reach(plan.cold), plan.cold.x.high)
    for leaf in plan.leaves:
        first = leaf is plan.doors[0]
        behind = [slot.space.x for slot in rooms[leaf.label].slots] + ([flap] if boxed else [])
        limit = reduce(ag.max_, [leaf.frees(x) + _MORE for x in behind], swing)
        swings[leaf.name] = leaf.hinge(limit=limit, pull=pull, damping=door_damping)
        shown = display if first and not water else ""
        wet = water and leaf is (plan.freezer or plan.doors[0])
        made = door(leaf, style, brand=maker if first else "", display=shown, water=wet)
        body = body.attach(made, swings[leaf.name])
    slots = [(label, slot) for label, room in rooms.items() for slot in room.slots]
    for number, (label, slot) in enumerate(slots):
        opened = _opened(slot, plan.leaves, label, swings)
        drawer = interior.inner_drawer(
            slot, number, opened, trim, share=drawer_share, friction=drawer_friction
        )
        body = body.install(drawer)
    for number, (board, cell) in enumerate(plan.fronts):
        body = body.install(outer_drawer(board, cell, number, style, share=drawer_share, pull=drawer_pull))
    body = _lit(body, rooms, plan.leaves, swings)
    if boxed:
        (leaf,) = plan.leaves
        opened = swings[leaf.name] > leaf.frees(flap)
        body = body.install(
            interior.flap(plan.cold, cold.front, opened, far=leaf.ridges[1], limit=flap_limit)
        )
    body = body.require(
        cold.spread > 0.085, "shelves and drawers have no room: raise height, or take fewer of them"
    )
    return body.mirror(ag.X) if hand == "right" and layout not in ("french", "side_by_side") else body


def _lit(
    body: ag.Body, rooms: Mapping[str, interior.Room], leaves: Sequence[Leaf], swings: Mapping[str, ag.Joint]
) -> ag.Body:
    """Let the lamp of each room shine while a door in front of it is open."""
    for label, room in rooms.items():
        opened = [swings[leaf.name] > _AJAR for leaf in leaves if leaf.label == label]
        if room.lamp is not None:
            name = "light" if label == "door" else "freezer_light"
            body = body.output(name, reduce(or_, opened), kind="light", material=room.lamp, color=_COLD)
    return body


_AJAR = 0.06  # turn of a door at which the lamp behind it is on [rad]
_COLD = (0.86, 0.94, 1.0)  # light of a lamp, linear RGB


def _rows(count: int, *, stacked: bool) -> tuple[int, ...]:
    """Return the number of drawers side by side in each row, from below."""
    if stacked or count < 2:
        return (1,) * count
    return (2, *(1,) * (count - 2))


def _opened(
    slot: interior.Slot, leaves: Sequence[Leaf], label: str, swings: Mapping[str, ag.Joint]
) -> ag.Condition:
    """Return the conditions under which the doors in front of a drawer have cleared its path."""
    found = [leaf for leaf in leaves if leaf.label == label]
    if len(found) == 2:
        found = [leaf for leaf in found if (1 if leaf.mirrored else -1) in slot.sides]
    return reduce(and_, [swings[leaf.name] > leaf.frees(slot.space.x) for leaf in found])
