"""Fronts of refrigerators: doors with their linings, ridges and bins, and freezer drawers."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.refrigerator import plan
from artgen.categories.shared.appliances import CLEAR, DARK, FROSTED, filled
from artgen.categories.shared.controls import control_panel
from artgen.categories.shared.pulls import BarStyle, bar_handle, niche, pocket_grip, recessed_grip
from artgen.categories.shared.shelves import door_bin, open_box
from artgen.nodes.fitting import Fitting

SOFT = 0.024
"""Radius of the corners of a soft front [m]."""

GripKind = Literal["bar", "pocket", "channel", "recessed"]
"""A bar; a pocket in the edge; a channel along the whole edge; a recess in the front with a blade."""

FrontForm = Literal["flat", "soft", "bowed", "framed"]
"""Sharp edges, round edges, a bowed front, or a frame around a panel."""

# thickness of the front part of a door, and of one with a pocket in its edge [m]
_SKIN, _THICK_SKIN = 0.028, 0.042
_BIN_SHY = 0.002  # difference in depth between ridges and bins: drawers strike the ridges first [m]
_RIDGE = 0.016  # thickness of ridges [m]
_LEAST_BIN = 0.05  # least width of a bin [m]
_SEAL = 0.014  # width of the gasket [m]
_SEAL_FREE = 0.0004  # gap between gasket and cabinet: invisible, and free of contact [m]
_FOAM = 190.0  # 8 kg/m2 of steel, foam, plastic sheet and contents: 9 kg for 0.7 x 1.1 m [kg/m3]
_EDGES = {"flat": 0.0026, "soft": 0.005, "bowed": 0.005, "framed": 0.002}  # radius of the edges [m]
_FRAME = (0.062, 0.0045)  # width and height of the boards of a framed front [m]
_BITE = 0.0008  # depth of handles in a bowed front [m]
# round edge of a bowed front: share of the width, and setback [m]
_BOW = ((1.0, 0.010), (0.988, 0.0035), (0.97, 0.0008))
_BOWED = (0.9, 0.75, 0.5, 0.25, 0.0, -0.25, -0.5, -0.75, -0.9)
_TRACKING = 0.3  # letter spacing of the name on a door, in letter heights
_NO_ROOM = (
    "the bins have no room between the ridges of a door: raise width, lower wall or bin_depth, or take a "
    "freezer_share of about 0.45 where the freezer is beside"
)


@dataclass(frozen=True)
class Finish:
    """Finish and shape of the fronts of a refrigerator."""

    front: ag.Material  # fronts
    metal: ag.Material  # handles
    liner: ag.Material  # inner sides
    seal: ag.Material  # gaskets
    trim: ag.Material  # bins and shelves
    drawn: FrontForm  # shape of the fronts, if the handles allow it
    bow: ag.Scalar  # height of the bow of a bowed front [m]
    grip: GripKind  # kind of the handles
    bar: BarStyle  # style of a bar
    girth: ag.Scalar  # half of the thickness of a bar [m]
    length: ag.Scalar  # length of a handle, as a share of the front

    @property
    def form(self) -> FrontForm:
        """Return the shape of the fronts: recessed grips need flat fronts."""
        if self.grip == "bar" or self.drawn in ("flat", "soft"):
            return self.drawn
        return "soft" if self.drawn == "bowed" else "flat"

    def rise(self, share: ag.Scalar) -> ag.Scalar:
        """Return the height of the front at a distance from its middle, as a share of half the width [m]."""
        if self.form == "framed":
            return _FRAME[1]
        return self.bow * (1 - share * share) if self.form == "bowed" else 0

    def handle(self, length: ag.Scalar, name: str, *, more: ag.Scalar = 0, level: bool = False) -> ag.Body:
        """Make a bar about the origin; `more` is the height of a bow in front of its ends [m]."""
        made: ag.Body = bar_handle(
            length=length,
            finish=self.metal,
            style=self.bar,
            level=level,
            name=name,
            projection=0.040 + 1.4 * self.girth + more,
            girth=self.girth,
        )
        return made


def _skin(board: ag.Region, finish: Finish) -> ag.Solid:
    """Make the front part of a door or drawer."""
    ease = _EDGES[finish.form]
    if finish.form == "soft":
        return ag.extrude(board.front(radius=SOFT), board.y.size, axis=ag.Y, bevel=ease).at(y=board.y.mid)
    if finish.form != "bowed":
        return board.box(bevel=ease)
    half = board.x.size / 2
    edge = [(share * half, back - finish.rise(share)) for share, back in _BOW]
    swell = [(share * half, -finish.rise(share)) for share in _BOWED]
    left = [(-x, y) for x, y in reversed(edge)]
    outline = ag.polygon([(-half, board.y.size), (half, board.y.size), *edge, *swell, *left])
    return ag.extrude(outline, board.z.size, bevel=ease).at(board.anchor(y=-1))


def _leaf(
    board: ag.Region,
    finish: Finish,
    label: str,
    name: str,
    *,
    thick: ag.Scalar = _SKIN,
    inset: tuple[ag.Scalar, ag.Scalar] = (0.005, 0.005),
    seal_inset: ag.Scalar = 0.012,
) -> ag.Body:
    """Make the skin of a door or drawer, the boards of a framed front, the lining and the gasket.

    `inset` is the distance of the lining from the left and the right edge, `seal_inset` that of the gasket
    from the left edge [m].
    """
    lining = board.shrink(0.005, front=thick - 0.001, back=0, left=inset[0], right=inset[1])
    foam = filled(finish.front, _FOAM)
    bodies = [
        ag.part(_skin(board.deep(thick, None)[0], finish), label, foam, name=name),
        ag.part(lining.box(bevel=0.005), "liner", filled(finish.liner, _FOAM)),
    ]
    if finish.form == "framed":
        wide, out = _FRAME
        frame = board.with_(y=(board.y.low - out, board.y.low + 0.001))
        left, middle, right = frame.across(wide, None, wide)
        top, _, bottom = middle.grow(0, x=0.0005).stack(wide, None, wide)
        bodies.append(ag.part([each.box(bevel=0.0014) for each in (left, right, top, bottom)], "panel", foam))
    behind = (board.y.high, board.y.high + plan.SEAL_GAP - _SEAL_FREE)
    seal = board.shrink(z=0.008, left=seal_inset, right=0.012).with_(y=behind)
    return ag.weld(*bodies, *_gasket(seal, finish.seal))


def _gasket(ring: ag.Region, rubber: ag.Material) -> list[ag.Body]:
    """Make the gasket of a closed door, with a gap to the cabinet that prevents contact."""
    less = 0.0002  # uprights end inside the horizontal bars, just below their faces
    top, middle, bottom = ring.stack(_SEAL, None, _SEAL)
    inner = middle.grow(0, z=_SEAL / 2).shrink(x=less / 2, y=0, z=0, back=less)
    left, _, right = inner.across(_SEAL - less, None, _SEAL - less)
    bars = [each.box(bevel=0.45 * ring.y.size) for each in (bottom, top, left, right)]
    # a flat ring is the root of the gasket in the door's groove
    root = ring.grow(0.003).front(radius=0.006) - ring.shrink(_SEAL + 0.003).front()
    solid = ag.extrude(root, 0.004, axis=ag.Y).at(y=ring.y.low)
    return [ag.part(bars, "gasket", rubber), ag.detail(solid, "gasket", rubber)]


def door(
    leaf: plan.Leaf, finish: Finish, *, brand: str = "", display: str = "", water: bool = False
) -> ag.Body:
    """Make a door in its place, with the link name of its leaf."""
    board, grip = leaf.board, finish.grip
    if grip in ("pocket", "channel") and leaf.meets:  # no space for hands between two doors
        grip = "recessed"
    thick = _THICK_SKIN if grip in ("pocket", "channel") else _SKIN
    inset = (plan.LINING_INSET, 0.006)
    body = _leaf(board, finish, leaf.label, leaf.name, thick=thick, inset=inset, seal_inset=plan.SEAL_INSET)
    body = body.install(_bar(leaf, finish) if grip == "bar" else _recess(leaf, finish, grip))
    if water:
        size = (ag.min_(0.19, 0.55 * board.x.size), board.y.size - 0.018, ag.min_(0.30, 0.32 * board.z.size))
        at = (board.x.at(0.44), board.y.low, board.z.at(0.55))
        body = body.install(_dispenser(*size, trim=finish.metal), at=at)
    body = ag.weld(body, *_inside(leaf, finish), *_signs(board, finish, brand, display))
    if leaf.side == "left":
        body = ag.weld(body, _mullion(leaf, finish.liner))
    return body.mirror(ag.X) if leaf.mirrored else body


def _level(leaf: plan.Leaf, length: ag.Scalar, margin: ag.Scalar) -> ag.Scalar:
    """Return the height of the middle of a handle with a margin to the nearest edge [m]."""
    low, high = leaf.board.z
    levels = {"low": low + margin + length / 2, "high": high - margin - length / 2}
    return levels.get(leaf.handle, leaf.board.z.mid)


def _bar(leaf: plan.Leaf, finish: Finish) -> ag.Body:
    board = leaf.board
    length = ag.max_(finish.length * board.z.size, 0.17)
    aside = _FRAME[0] / 2 if finish.form == "framed" else 0.048
    y = board.y.low - finish.rise(1 - 2 * aside / board.x.size) + (_BITE if finish.form == "bowed" else 0)
    bar = finish.handle(length, f"{leaf.name}_handle")
    return bar.at(board.x.high - aside, y, _level(leaf, length, 0.055))


def _recess(leaf: plan.Leaf, finish: Finish, grip: str) -> Fitting:
    """Make the recessed grip of a door in its place."""
    board, name, shade = leaf.board, f"{leaf.name}_handle", ag.material("black_abs")
    length = ag.min_(ag.max_(finish.length * board.z.size, 0.13), 0.34)
    level, aside = _level(leaf, length, 0.05), 0.0
    if grip == "recessed":
        made, aside = recessed_grip(length, finish=finish.metal, lining=shade, name=name), 0.062
    elif grip == "pocket":
        made = pocket_grip(length, finish=shade, name=name)
    else:
        made = pocket_grip(board.z.size - 0.03, finish=ag.material("aluminium"), name=name)
        level = board.z.mid
    return made.at(board.x.high - aside, board.y.low, level)


def _dispenser(width: ag.Scalar, deep: ag.Scalar, height: ag.Scalar, *, trim: ag.Material) -> Fitting:
    """Make a niche about the origin of the front y = 0, with spout, lever and tray, under a touch panel."""
    space = ag.Region.centered(width, deep, height).at(y=deep / 2)
    top, bottom = space.z.high, space.z.low
    frame = space.grow(0.011).front(radius=0.008) - space.shrink(0.0015).front(radius=0.002)
    spout = ag.frustum(0.009, 0.016, 0.03, bevel=0.002).at(0, 0.45 * deep, top - 0.016)
    collar = ag.cylinder(0.011, 0.004).at(0, 0.45 * deep, top - 0.003)
    lever = ag.box(0.045, 0.006, 0.085, bevel=0.0025).at(0, deep - 0.0045, top - 0.085)
    tray = ag.box(0.86 * width, 0.8 * deep, 0.006, bevel=0.0015).at(0, 0.48 * deep, bottom + 0.005)
    slots = details.vent_slots(0.8 * width, 0.6 * deep, 7, slot=0.0026)
    icons = ("drop", "ice", "child_lock", "light")
    panel = control_panel(
        width + 0.022, 0.072, icons=icons, show="4", color="cyan", screen=(0.05, 0.022), pitch=0.026
    )
    on_tray = (0, 0.48 * deep, bottom + 0.008)
    shell = ag.weld(
        ag.detail(niche(width, height, deep, sheet=0.002), "dispenser", DARK),  # in front of the cut foam
        ag.detail([details.relief(frame, proud=0.0022, bevel=0.0012), collar, tray], "dispenser", trim),
        ag.detail(spout, "dispenser", ag.material("chrome")),
        ag.detail(lever, "dispenser", ag.material("black_abs")),
        details.printed(slots, on_tray, facing=ag.Z, material=DARK, label="dispenser"),
        panel.at(z=top + 0.048),
    )
    return Fitting(shell, space.grow(0, front=0.010).box())


def _inside(leaf: plan.Leaf, finish: Finish) -> list[ag.Body]:
    """Make the ridges of the lining and the bins between them."""
    if leaf.ridge is None:
        return []
    left, right = leaf.ridges
    face = leaf.board.y.high
    whole = ag.Region((left, right), (face - 0.004, face + leaf.ridge), leaf.cell.shrink(0.020).z)
    # the free ridge is wide enough to cover the drawers at its side
    first, last = left + _RIDGE, ag.min_(right - _RIDGE, leaf.cell.x.high - plan.CHEEK - 0.012)
    ridges = [whole.with_(x=x).box(bevel=0.005) for x in ((left, first), (last, right))]
    width = ag.require(last - first + 0.002, last - first > _LEAST_BIN, _NO_ROOM)
    pitch = whole.z.size / leaf.bins
    places = [
        ((first + last) / 2, face - 0.001, whole.z.low + index * pitch + 0.006) for index in range(leaf.bins)
    ]
    deep, height = leaf.ridge - _BIN_SHY + 0.001, ag.min_(0.095, 0.6 * pitch)
    return [
        ag.part(ridges, "liner", filled(finish.liner, _FOAM)),
        door_bin(width, deep, height, finish=CLEAR, trim=finish.trim, at=places),
    ]


def _signs(board: ag.Region, finish: Finish, brand: str, display: str) -> list[ag.Body]:
    """Make the name and the display on the front."""
    bodies = []
    bowed = finish.form == "bowed"
    x, y = board.x.mid, board.y.low - (finish.bow - 0.0003 if bowed else 0)
    if brand:
        size: ag.Scalar = 0.013
        if bowed:  # the ends reach back to the bowed front
            share = ag.min_(0.28, 0.005 / finish.bow)
            size = ag.min_(size, share * board.x.size / details.lettering_width(brand.upper(), _TRACKING))
        mark = details.logo(brand, size, tracking=_TRACKING)
        at = (x, y, board.z.high - (0.09 if finish.form == "framed" else 0.055))
        shine = finish.metal if finish.metal.base_metalness > 0.5 else ag.material("chrome")
        bodies.append(details.raised(mark, at, material=shine, label="logo", proud=0.0005, bevel=0))
    if display:
        bodies.append(details.display(display, 0.125, 0.042, at=(x, y, board.z.at(0.70)), color="cyan"))
    return bodies


def _mullion(leaf: plan.Leaf, finish: ag.Material) -> ag.Body:
    """Make the strip at the free edge of a door that closes the gap to the other door from behind.

    Real strips fold as the door opens; this strip stays within its own door and never touches the other.
    """
    right, face = leaf.board.x.high - 0.012, leaf.board.y.high - 0.0005
    strip = leaf.cell.shrink(z=0.005).with_(x=(right - 0.044, right), y=(face, face + 0.013))
    return ag.part(strip.box(bevel=0.002), "mullion", finish)


def outer_drawer(
    board: ag.Region, cell: plan.Cell, number: int, finish: Finish, *, share: ag.Scalar, pull: ag.Scalar
) -> Fitting:
    """Make a freezer drawer with its front, gasket, handle and basket on its runners.

    `share` is the travel, as a share of the depth of the basket, and `pull` the friction [N].
    """
    name = f"outer_drawer_{number}"
    body = _leaf(board, finish, "outer_drawer", name)
    x, y, wide = board.x.mid, board.y.low, board.x.size
    if finish.grip == "bar":
        aside = 0.031 if finish.form == "framed" else 0.055
        length = ag.min_(ag.max_(0.62 * wide, 0.2), wide - 0.1)
        ends = finish.rise((length - 0.02) / wide) - (_BITE if finish.form == "bowed" else 0)
        bar = finish.handle(length, f"{name}_handle", more=finish.rise(0) - ends, level=True)
        body = body.install(bar, at=(x, y - ends, board.z.high - aside))
    else:
        lining = ag.material("black_abs")
        grip = recessed_grip(0.26, finish=finish.metal, lining=lining, level=True, name=f"{name}_handle")
        body = body.install(grip, at=(x, y, board.z.high - 0.062))
    behind, floor = board.y.high - 0.002, cell.z.low + 0.012
    deep = cell.y.high - (plan.HUMP_DEEP if cell.humped else 0) - 0.015 - board.y.high
    basket = cell.shrink(0.022).with_(y=(board.y.high, board.y.high + deep))
    tall = 0.62 * cell.z.size
    boards = open_box(basket.x.size, deep + 0.002, tall, wall=0.004, front=0.004)
    rail = ag.box(0.010, deep - 0.02, 0.022, bevel=0.002).at(0, basket.y.mid, cell.z.low + 0.7 * tall)
    rails = [rail.at(x) for x in (basket.x.low - 0.003, basket.x.high + 0.003)]
    body = ag.weld(
        body,
        ag.part([each.at(cell.x.mid, behind, floor) for each in boards], "basket", FROSTED),
        ag.detail(rails, "rail", ag.material("zinc")),
    )
    pivot = board.anchor(y=-1)
    drag = feel.Feel(friction=pull, damping=12, effort=plan.HAND)
    slide = ag.Prismatic(
        f"outer_drawer_slide_{number}", axis=-ag.Y, pivot=pivot, limits=(0, share * deep), feel=drag
    )
    return Fitting.moving(body, slide)
