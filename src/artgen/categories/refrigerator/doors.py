"""Doors of refrigerators: a skin, the lining behind it with its ridges and bins, gasket, handle and signs."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.refrigerator.case import SEAL_GAP, Case
from artgen.categories.refrigerator.leaf import CHEEK, LINING_INSET, SEAL_INSET, Leaf, door_gasket
from artgen.categories.shared.appliances import CLEAR, DARK, filled
from artgen.categories.shared.controls import control_panel
from artgen.categories.shared.pulls import BarStyle, Grip, bar_handle, niche, pocket_grip, recessed_grip
from artgen.categories.shared.shelves import door_bin

_SHEET = 0.002


def dispenser(*, width: ag.Scalar, height: ag.Scalar, deep: ag.Scalar, trim: ag.Material, show: str) -> Grip:
    """Make a niche about the origin of the front y = 0, with spout, lever and tray, under a touch panel."""
    cut = ag.box(width, deep + 0.010, height).at(0.0, deep / 2 - 0.005, 0.0)
    walls = niche(width, height, deep, sheet=_SHEET)
    panel_high = 0.072
    top, bottom = height / 2, -0.5 * height
    frame = ag.rectangle(width + 0.022, height + 0.022, radius=0.008) - ag.rectangle(
        width - 0.003, height - 0.003, radius=0.002
    )
    spout = ag.frustum(0.009, 0.016, 0.03, bevel=0.002).at(0.0, 0.45 * deep, top - 0.016)
    lever = ag.box(0.045, 0.006, 0.085, bevel=0.0025).at(0.0, deep - 0.0045, top - 0.085)
    slots = details.vent_slots(0.8 * width, 0.6 * deep, 7, slot=0.0026)
    tray = ag.box(0.86 * width, 0.8 * deep, 0.006, bevel=0.0015).at(0.0, 0.48 * deep, bottom + 0.005)
    panel = control_panel(
        width + 0.022, panel_high, icons=("drop", "ice", "child_lock", "light"), show=show, color="cyan",
        screen=(0.05, 0.022), pitch=0.026,
    ).at(0.0, 0.0, top + 0.012 + panel_high / 2)  # fmt: skip
    return Grip(
        cut,
        ag.weld(
            *(ag.part(wall, "dispenser", DARK) for wall in walls),
            ag.detail(details.relief(frame, proud=0.0022, bevel=0.0012), "dispenser", trim),
            ag.detail(spout, "dispenser", ag.material("chrome")),
            ag.detail(ag.cylinder(0.011, 0.004).at(0.0, 0.45 * deep, top - 0.003), "dispenser", trim),
            ag.detail(lever, "dispenser", ag.material("black_abs")),
            ag.detail(tray, "dispenser", trim),
            details.printed(
                slots,
                (0.0, 0.48 * deep, bottom + 0.008),
                facing=(0.0, 0.0, 1.0),
                material=DARK,
                label="dispenser",
            ),
            panel,
        ),
    )


BIN_SHY = 0.002
"""Difference in depth between ridges and the bins beside them: drawers strike the ridges first [m]."""

SOFT = 0.024
"""Radius of the corners of a soft front [m]."""

GripKind = Literal["bar", "pocket", "channel", "recessed"]
"""A bar; a pocket in the edge; a channel along the whole edge; a recess in the front with a blade."""

Front = Literal["flat", "soft", "bowed", "framed"]
"""Sharp edges, round edges, a bowed front, or a frame around a panel."""

# thickness of the front part of a door, and of one with a pocket in its edge [m]
_SKIN, _THICK_SKIN = 0.028, 0.042
_FREE_INSET = 0.006  # difference in width between lining and skin at the other edges [m]
_RIDGE = 0.016  # thickness of ridges [m]
_LEAST_BIN = 0.05  # least width of a bin [m]
_SEAL = 0.014  # width of the gasket [m]
_SEAL_FREE = 0.0004  # gap between gasket and cabinet: invisible, and free of contact [m]
_FOAM = 190.0  # 8 kg/m2 of steel, foam, plastic sheet and contents: 9 kg for 0.7 x 1.1 m [kg/m3]
_EDGES = {"flat": 0.0026, "soft": 0.005, "bowed": 0.005, "framed": 0.002}  # radius of the edges [m]
_FRAME = (0.062, 0.0045)  # width and height of the boards of a framed front [m]
# round edge of a bowed front: share of the width, and setback [m]
_BOW = ((1.0, 0.010), (0.988, 0.0035), (0.97, 0.0008))
_TRACKING = 0.3  # letter spacing of the name on a door, in letter heights
_BOWED = (0.9, 0.75, 0.5, 0.25, 0.0, -0.25, -0.5, -0.75, -0.9)
_NO_ROOM = (
    "the bins have no room between the ridges of a door: raise width, lower wall or bin_depth, or take a "
    "freezer_share of about 0.45 where the freezer is beside"
)


@dataclass(frozen=True)
class Dress:
    """Finish and shape of the fronts of a refrigerator."""

    finish: ag.Material  # finish of the fronts
    metal: ag.Material  # metal of handles
    liner: ag.Material  # material of the inner sides
    seal: ag.Material  # material of the gaskets
    trim: ag.Material  # finish of bins and shelves
    form: Front  # shape of the fronts
    bow: ag.Scalar  # height of the bow of a bowed front [m]
    grip: GripKind  # kind of the handles
    bar: BarStyle  # style of a bar
    girth: ag.Scalar  # half of the thickness of a bar [m]
    length: ag.Scalar  # length of a handle, as a share of the front

    @property
    def front(self) -> Front:
        """Return the shape of the fronts: recessed grips need flat fronts."""
        if self.grip == "bar" or self.form in ("flat", "soft"):
            return self.form
        return "soft" if self.form == "bowed" else "flat"

    def rise(self, share: ag.Scalar) -> ag.Scalar:
        """Return the height of the bow at a distance from the middle, as a share of half the width [m]."""
        if self.front == "framed":
            return _FRAME[1]
        return self.bow * (1 - share * share) if self.front == "bowed" else 0.0


def slab(
    case: Case,
    dress: Dress,
    left: ag.Scalar,
    right: ag.Scalar,
    low: ag.Scalar,
    high: ag.Scalar,
    *,
    thick: ag.Scalar = _SKIN,
) -> ag.Solid:
    """Make the front part of a door or drawer."""
    middle, upward, ease = (left + right) / 2, (low + high) / 2, _EDGES[dress.front]
    if dress.front == "soft":
        outline = ag.rectangle(right - left, high - low, radius=SOFT)
        return ag.extrude(outline, thick, axis=ag.Y, bevel=ease).at(middle, case.front + thick / 2, upward)
    if dress.front != "bowed":
        board = ag.box(right - left, thick, high - low, bevel=ease)
        return board.at(middle, case.front + thick / 2, upward)
    half = (right - left) / 2
    edge = [(share * half, back - dress.rise(share)) for share, back in _BOW]
    swell = [(share * half, -dress.rise(share)) for share in _BOWED]
    corners = [(-half, thick), (half, thick), *edge, *swell, *((-x, y) for x, y in reversed(edge))]
    return ag.extrude(ag.polygon(corners), high - low, bevel=ease).at(middle, case.front, upward)


def framing(
    case: Case, dress: Dress, left: ag.Scalar, right: ag.Scalar, low: ag.Scalar, high: ag.Scalar
) -> list[ag.Body]:
    """Make the boards around the panel of a framed front; none for other fronts."""
    if dress.front != "framed":
        return []
    wide, out = _FRAME
    y = case.front - out / 2 + 0.0005
    stile = ag.box(wide, out + 0.001, high - low, bevel=0.0014)
    rail = ag.box(right - left - 2 * wide + 0.001, out + 0.001, wide, bevel=0.0014)
    middle, upward = (left + right) / 2, (low + high) / 2
    boards = [
        *(stile.at(middle + way * (right - left - wide) / 2, y, upward) for way in (-1, 1)),
        *(rail.at(middle, y, upward + way * (high - low - wide) / 2) for way in (-1, 1)),
    ]
    return [ag.part(board, "panel", filled(dress.finish, _FOAM)) for board in boards]


def lining(
    case: Case, left: ag.Scalar, right: ag.Scalar, low: ag.Scalar, high: ag.Scalar, *, thick: ag.Scalar
) -> ag.Solid:
    """Make the rear part of a door or drawer, a little narrower than its front part."""
    deep = case.thickness - thick + 0.001
    return ag.Region((left, right), (case.face - deep, case.face), (low, high)).box(bevel=0.005)


def door(leaf: Leaf, dress: Dress, *, brand: str = "", display: str = "", water: bool = False) -> ag.Body:
    """Make a door in its place, with the link name of its leaf."""
    case = leaf.case
    grip = dress.grip
    if grip in ("pocket", "channel") and leaf.meets:  # no space for hands between two doors
        grip = "recessed"
    thick = _THICK_SKIN if grip in ("pocket", "channel") else _SKIN
    skin = slab(case, dress, leaf.left, leaf.right, leaf.low, leaf.high, thick=thick)
    inner = lining(
        case,
        leaf.left + LINING_INSET,
        leaf.right - _FREE_INSET,
        leaf.low + 0.005,
        leaf.high - 0.005,
        thick=thick,
    )
    cuts: list[Grip] = []
    bodies: list[ag.Body] = []
    if grip == "bar":
        bodies.append(_bar(leaf, dress))
    else:
        cuts.append(_sunk(leaf, dress, grip))
    if water:
        high = ag.min_(0.30, 0.32 * leaf.height)
        made = dispenser(
            width=ag.min_(0.19, 0.55 * leaf.width),
            height=high,
            deep=case.thickness - 0.018,
            trim=dress.metal,
            show="4",
        )
        cuts.append(made.at(leaf.left + 0.44 * leaf.width, case.front, leaf.low + 0.55 * leaf.height))
    for made in cuts:
        skin, inner = skin - made.cut, inner - made.cut
    bodies += [made.shell for made in cuts]
    base = ag.part(skin, leaf.label, filled(dress.finish, _FOAM), name=leaf.name)
    body = ag.weld(
        base,
        ag.part(inner, "liner", filled(dress.liner, _FOAM)),
        *framing(case, dress, leaf.left, leaf.right, leaf.low, leaf.high),
        *bodies,
        _seal(leaf, dress),
        *_inside(leaf, dress),
        *_signs(leaf, dress, brand, display),
    )
    return body.mirror(ag.X) if leaf.mirrored else body


def _bar(leaf: Leaf, dress: Dress) -> ag.Body:
    length = ag.max_(dress.length * leaf.height, 0.17)
    aside = _FRAME[0] / 2 if dress.front == "framed" else 0.048
    share = 1 - 2 * aside / leaf.width
    y = leaf.case.front - dress.rise(share) + (0.0008 if dress.front == "bowed" else 0.0)
    level: ag.Scalar = (leaf.low + leaf.high) / 2
    if leaf.handle == "low":
        level = leaf.low + 0.055 + length / 2
    elif leaf.handle == "high":
        level = leaf.high - 0.055 - length / 2
    out = 0.040 + 1.4 * dress.girth
    bar: ag.Body = bar_handle(
        length=length,
        finish=dress.metal,
        style=dress.bar,
        name=f"{leaf.name}_handle",
        projection=out,
        girth=dress.girth,
    )
    return bar.at(leaf.right - aside, y, level)


def _sunk(leaf: Leaf, dress: Dress, grip: str) -> Grip:
    """Make a recessed grip of a door."""
    y, middle = leaf.case.front, (leaf.low + leaf.high) / 2
    name = f"{leaf.name}_handle"
    if grip == "channel":
        return pocket_grip(leaf.height - 0.03, finish=ag.material("aluminium"), name=name).at(
            leaf.right, y, middle
        )
    length = ag.min_(ag.max_(dress.length * leaf.height, 0.13), 0.34)
    level: ag.Scalar = middle
    if leaf.handle == "low":
        level = leaf.low + 0.05 + length / 2
    elif leaf.handle == "high":
        level = leaf.high - 0.05 - length / 2
    shade = ag.material("black_abs")
    if grip == "pocket":
        return pocket_grip(length, finish=shade, name=name).at(leaf.right, y, level)
    return recessed_grip(length, finish=dress.metal, lining=shade, name=name).at(leaf.right - 0.062, y, level)


def _seal(leaf: Leaf, dress: Dress) -> ag.Body:
    left, right = leaf.left + SEAL_INSET, leaf.right - 0.012
    low, high = leaf.low + 0.008, leaf.high - 0.008
    ring = door_gasket(right - left, high - low, rubber=dress.seal, deep=SEAL_GAP - _SEAL_FREE, size=_SEAL)
    return ring.at((left + right) / 2, leaf.case.face, (low + high) / 2)


def _inside(leaf: Leaf, dress: Dress) -> list[ag.Body]:
    """Make the ridges of the lining and the bins between them."""
    if leaf.ridge is None:
        return []
    left, right = leaf.ridges
    low, high = leaf.cell.low + 0.020, leaf.cell.high - 0.020
    sunk = 0.004
    y = leaf.case.face + (leaf.ridge - sunk) / 2
    white = filled(dress.liner, _FOAM)
    # the free ridge is wide enough to cover the drawers at its side
    first, last = left + _RIDGE, ag.min_(right - _RIDGE, leaf.cell.right - CHEEK - 0.012)
    bodies = [
        ag.part(
            ag.box(end - start, leaf.ridge + sunk, high - low, bevel=0.005).at(
                (start + end) / 2, y, (low + high) / 2
            ),
            "liner",
            white,
        )
        for start, end in ((left, first), (last, right))
    ]
    width = ag.require(last - first + 0.002, last - first > _LEAST_BIN, _NO_ROOM)
    deep = leaf.ridge - BIN_SHY
    pitch = (high - low) / leaf.bins
    middle = ((first + last) / 2, leaf.case.face - 0.001)
    hung = door_bin(
        width,
        deep + 0.001,
        ag.min_(0.095, 0.6 * pitch),
        finish=CLEAR,
        trim=dress.trim,
        at=[(*middle, low + index * pitch + 0.006) for index in range(leaf.bins)],
    )
    return [*bodies, hung]


def _signs(leaf: Leaf, dress: Dress, brand: str, display: str) -> list[ag.Body]:
    """Make the name and the display on the front."""
    bodies = []
    y = leaf.case.front - (dress.bow - 0.0003 if dress.front == "bowed" else 0.0)
    middle = (leaf.left + leaf.right) / 2
    if brand:
        size: ag.Scalar = 0.013
        if dress.front == "bowed":  # the ends reach back to the bowed front
            share = ag.min_(0.28, 0.005 / dress.bow)
            size = ag.min_(size, share * leaf.width / details.lettering_width(brand.upper(), _TRACKING))
        mark = details.logo(brand, size, tracking=_TRACKING)
        drop = 0.09 if dress.front == "framed" else 0.055
        shine = dress.metal if dress.metal.base_metalness > 0.5 else ag.material("chrome")
        bodies.append(
            details.raised(
                mark, (middle, y, leaf.high - drop), material=shine, label="logo", proud=0.0005, bevel=0.0
            )
        )
    if display:
        at = (middle, y, leaf.high - 0.30 * leaf.height)
        pane = details.display(display, 0.125, 0.042, at=at, color="cyan")
        bodies.append(pane)
    return bodies


def mullion(leaf: Leaf, *, finish: ag.Material) -> ag.Body:
    """Make the strip at the free edge of a door that closes the gap to the other door from behind.

    Real strips fold as the door opens; this strip stays within its own door and never touches the other.
    """
    wide, deep = 0.044, 0.013
    strip = ag.box(wide, deep, leaf.cell.height - 0.010, bevel=0.002)
    strip = strip.at(
        leaf.right - 0.012 - wide / 2,
        leaf.case.face + deep / 2 - 0.0005,
        (leaf.cell.low + leaf.cell.high) / 2,
    )
    return ag.part(strip, "mullion", finish)
