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
from functools import reduce
from operator import and_
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.refrigerator.case import COVER, Back, Case, cabinet
from artgen.categories.refrigerator.doors import SOFT, Dress, Front, GripKind, door, mullion
from artgen.categories.refrigerator.drawers import Slot, inner_drawer, inner_slide, outer_drawer, outer_slide
from artgen.categories.refrigerator.inside import Furniture, ShelfKind, flap, flap_reach, flap_swing, furnish
from artgen.categories.refrigerator.leaf import Leaf
from artgen.categories.refrigerator.plan import Divided, Layout, hinges
from artgen.categories.shared.appliances import (
    CLEAR,
    FROSTED,
    LINER,
    LINER_GREY,
    Look,
    cabinet_finish,
    fronts,
    grip_metals,
)
from artgen.categories.shared.pulls import BarStyle

_LABELS = (
    "body", "door", "freezer_door", "inner_drawer", "outer_drawer", "handle", "liner", "gasket",
    "shelf", "bin", "basket", "rail", "egg_tray", "ice_box", "dispenser", "panel", "display",
    "control", "light", "duct", "vent", "hinge", "mullion", "kick_plate", "foot", "compressor",
    "condenser", "cord", "rating_plate", "logo", "print",
)  # fmt: skip
_FINISH, _METAL = fronts(), grip_metals()
_SEALS = {"white": ag.colored("silicone", "light_grey"), "grey": ag.colored("silicone", "grey")}
_TRIMS = (
    ag.material("glossy_plastic_white").with_(name="trim_white"),
    ag.material("aluminium"),
    ag.material("glossy_plastic_white").with_(name="trim_smoke", base_color=(0.16, 0.17, 0.18)),
)
_WIRE_SHELVES = 6  # largest number of wire shelves in a refrigerator
_MORE = 0.12  # opening of a door beyond the angle that its drawers need [rad]


@ag.category(labels=_LABELS, joints=(1, 7))
def refrigerator(
    *,
    layout: Layout = ag.choice(
        "single",
        "top_freezer",
        "bottom_freezer",
        "french",
        "side_by_side",
        weights=(0.22, 0.17, 0.25, 0.2, 0.16),
    ),
    build: Literal["under_counter", "medium", "tall"] = ag.by(
        "layout",
        single=ag.choice("under_counter", "medium", "tall", weights=(0.4, 0.3, 0.3)),
        top_freezer=ag.choice("medium", "tall", weights=(0.35, 0.65)),
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
    look: Look = ag.by(
        "layout",
        single=ag.choice(
            "white", "pastel", "stainless", "black", "panel", "dark_steel", weights=(3, 3, 2, 1, 1, 0.6)
        ),
        top_freezer=ag.choice(
            "white", "stainless", "pastel", "black", "dark_steel", weights=(3, 2.5, 1.6, 1, 0.8)
        ),
        bottom_freezer=ag.choice(
            "stainless",
            "white",
            "pastel",
            "dark_steel",
            "glass",
            "panel",
            "black",
            weights=(2.6, 1.6, 1.2, 1, 1, 0.9, 0.7),
        ),
        otherwise=ag.choice(
            "stainless",
            "dark_steel",
            "white",
            "black",
            "glass",
            "panel",
            weights=(3, 1.4, 0.8, 0.9, 1.1, 0.9),
        ),
    ),
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    form: Front = ag.by(
        "look",
        pastel=ag.choice("bowed", "soft", weights=(0.75, 0.25)),
        panel=ag.choice("framed", "flat"),
        white=ag.choice("soft", "flat"),
        glass="flat",
        otherwise=ag.choice("flat", "soft", weights=(0.65, 0.35)),
        doc="finish of the fronts",
    ),
    bow: ag.Float = ag.uniform(0.008, 0.018, "m", doc="height of the bow of a front", within=(0.002, 0.03)),
    grip: GripKind = ag.by(
        "look",
        pastel="bar",
        otherwise=ag.by(
            "layout",
            french=ag.choice("bar", "recessed", weights=(0.78, 0.22)),
            side_by_side=ag.choice("bar", "recessed", weights=(0.72, 0.28)),
            otherwise=ag.choice("bar", "pocket", "channel", "recessed", weights=(0.56, 0.18, 0.12, 0.14)),
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
        "layout",
        bottom_freezer=ag.choice(0, 1, 2, weights=(0.5, 0.3, 0.2)),
        french=ag.choice(1, 2),
        otherwise=0,
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
    ice_box: bool = ag.by("layout", single=ag.choice(False, True, weights=(0.55, 0.45)), otherwise=False),
    shelves: int = ag.by(
        "build",
        under_counter=ag.by("ice_box", {True: 1, False: ag.choice(1, 2)}),
        medium=ag.choice(2, 3),
        tall=ag.by(
            "layout", single=ag.choice(3, 4, 5), side_by_side=ag.choice(3, 4), otherwise=ag.choice(2, 3)
        ),
    ),
    shelf_kind: ShelfKind = ag.by(
        "layout",
        side_by_side="glass",
        french="glass",
        otherwise=ag.choice("glass", "wire", weights=(0.65, 0.35)),
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
        french=ag.choice(False, True, weights=(0.5, 0.5)),
        side_by_side=ag.choice(False, True, weights=(0.35, 0.65)),
        otherwise=False,
        doc="whether a door has a water dispenser",
    ),
    display: str = ag.by(
        "look",
        pastel="",
        panel="",
        otherwise=ag.choice("", "4 -18", "3 -20", "5", weights=(0.6, 0.15, 0.15, 0.1)),
        doc="display on the door",
    ),
    control: Literal["dial", "touch"] = ag.by(
        "build", under_counter="dial", otherwise=ag.choice("dial", "touch")
    ),
    inside: Literal["white", "grey"] = ag.by(
        "look",
        dark_steel=ag.choice("white", "grey"),
        stainless=ag.choice("white", "grey", weights=(0.75, 0.25)),
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
    case = Case(width, depth, height - COVER, kick_height, door_thickness, wall, gap)
    # drawers fill a freezer up to the flat inside of its door
    full = layout == "bottom_freezer" or (layout == "top_freezer" and freezer_drawers > 0)
    ag.require(
        shelf_kind == "glass" or shelves + freezer_shelves <= _WIRE_SHELVES,
        f"wire shelves have many colliders: shelves + freezer_shelves must be <= {_WIRE_SHELVES}",
    )
    boxed = ice_box and layout == "single"
    divided = Divided(case, freezer_share, bin_depth, None if full else 0.72 * bin_depth, bins, outer_drawers)
    plan = divided.plan(layout)
    liner = LINER if inside == "white" else LINER_GREY
    seal = _SEALS["white" if look in ("white", "pastel") else "grey"]
    dress = Dress(finish, metal, liner, seal, trim, form, bow, grip, bar, girth, grip_length)
    shell = cabinet_finish(look, finish)
    light = look in ("white", "pastel")
    kick = shell if light else ag.material("powder_coat_graphite")
    cover = _TRIMS[0] if light else ag.material("black_abs")
    block = cabinet(
        case,
        plan.cells,
        finish=shell,
        liner=liner,
        corner={"bowed": 0.012, "soft": SOFT}.get(dress.front),
        kick=kick,
        back=back,
        abreast=plan.abreast,
    )

    held = Furniture(
        _rows(crispers, stacked=layout in ("single", "side_by_side")),
        crisper_height,
        shelves,
        shelf_kind,
        trim,
        liner,
        boxed,
        egg_tray,
        control,
        display or "4",
    )
    cold = furnish(case, plan.cold, bin_depth, held)
    rooms = {"door": cold}
    bodies = [*cold.bodies, *hinges(plan, case, cover=cover, metal=metal)]
    if plan.freezer is not None:
        tall = None if full else crisper_height
        held = Furniture(
            (1,) * freezer_drawers, tall, 0 if full else freezer_shelves, shelf_kind, trim, liner
        )
        rooms["freezer_door"] = furnish(case, plan.freezer.cell, plan.freezer.ridge, held)
        bodies += rooms["freezer_door"].bodies
    body = ag.weld(block, *bodies)

    # a door opens at least as far as the drawers behind it need
    swings: dict[str, ag.Joint] = {}
    for leaf in plan.leaves:
        behind = rooms[leaf.label]
        ways = [leaf.frees(slot.left, slot.right) for slot in behind.slots]
        ways += [leaf.frees(flap_reach(plan.cold), plan.cold.right)] if boxed else []
        limit = reduce(ag.max_, [way + _MORE for way in ways], swing)
        swings[leaf.name] = leaf.hinge(limit=limit, pull=pull, damping=door_damping)
        first = leaf is plan.doors[0]
        made = door(
            leaf,
            dress,
            brand=maker if first else "",
            display=display if first and not water else "",
            water=water and leaf is (plan.freezer or first),
        )
        if leaf.name == "door_left":
            made = ag.weld(made, mullion(leaf, finish=liner))
        body = body.attach(made, swings[leaf.name])

    number = 0
    for label, room in rooms.items():
        front = FROSTED if label == "freezer_door" else CLEAR
        for slot in room.slots:
            opened = _opened(slot, plan.leaves, label, swings)
            slide = inner_slide(slot, number, opened, share=drawer_share, friction=drawer_friction)
            body = body.attach(inner_drawer(slot, number, finish=front, front=front, lip=trim), slide)
            number += 1
    for index, part_ in enumerate(plan.fronts):
        slide = outer_slide(case, part_, index, share=drawer_share, pull=drawer_pull)
        body = body.attach(outer_drawer(case, part_, index, dress, finish=FROSTED), slide)
    if boxed:
        (leaf,) = plan.leaves
        opened = swings[leaf.name] > leaf.frees(flap_reach(plan.cold), plan.cold.right)
        swing_ = flap_swing(plan.cold, opened, front=cold.front, far=leaf.ridges[1], limit=flap_limit)
        body = body.attach(flap(plan.cold, low=cold.ice, front=cold.front, finish=FROSTED), swing_)
    body = body.require(
        cold.spread > 0.085, "shelves and drawers have no room: raise height, or take fewer of them"
    )
    return body.mirror(ag.X) if hand == "right" and layout not in ("french", "side_by_side") else body


def _rows(count: int, *, stacked: bool) -> tuple[int, ...]:
    """Return the number of drawers side by side in each row, from below."""
    if stacked or count < 2:
        return (1,) * count
    return (2, *(1,) * (count - 2))


def _opened(slot: Slot, leaves: Sequence[Leaf], label: str, swings: Mapping[str, ag.Joint]) -> ag.Condition:
    """Return the conditions under which the doors in front of a drawer have cleared its path."""
    found = [leaf for leaf in leaves if leaf.label == label]
    if len(found) == 2:
        found = [leaf for leaf in found if (1 if leaf.mirrored else -1) in slot.sides]
    return reduce(and_, [swings[leaf.name] > leaf.frees(slot.left, slot.right) for leaf in found])
