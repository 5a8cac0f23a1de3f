"""Kinds of boxes, each assembled from walls, closures, contents and prints."""

from dataclasses import dataclass

import artgen as ag
from artgen.categories.box.board import (
    LAYER,
    Board,
    Feel,
    bottom_flaps,
    cells,
    hand_holes,
    hole_corners,
    walls,
)
from artgen.categories.box.bottles import Bottles, Wine
from artgen.categories.box.finish import GOLD, foam
from artgen.categories.box.flaps import Top
from artgen.categories.box.gifts import PLAY, Closure, Gift, Hollow, cap, lift, strap
from artgen.categories.box.lids import Lidded, Sides
from artgen.categories.box.prints import (
    Ink,
    Look,
    address_label,
    mailer_print,
    name_on_lid,
    pizza_front,
    pizza_print,
    shipping_print,
    side_label,
    vents,
    wine_print,
)

_NO_DUST = "dust flaps need a lid that lies on the walls: take sides=over or dusted=False"
_LOW_COVER = "the cover would protrude too little from its tray: raise height"
_GRID = {2: (2, 1), 3: (3, 1), 6: (3, 2), 12: (4, 3)}  # numbers of cells along x and y, by their product


@dataclass(frozen=True)
class Draft:
    """Common data of boxes of all kinds."""

    board: Board  # board of the box
    width: ag.Scalar  # outer width along x [m]
    depth: ag.Scalar  # outer depth along y [m]
    height: ag.Scalar  # height of the closed box [m]
    feel: Feel  # resistance of creases
    swing: ag.Scalar  # opening angle of flaps without obstacles [rad]
    look: Look  # prints of the box

    def flap_label(self, top: Top) -> dict[str, list[ag.Body]]:
        """Return the address label on the front flap of a slotted top, in the frame of its sheet."""
        if not self.look.label:
            return {}
        size = ag.min_(0.10, 0.8 * top.reach)
        at = (-0.27 * self.width, 0.46 * top.reach, 0.0)
        return {"front": address_label(at, facing=ag.Z, size=size, number=self.look.model)}


def slotted_box(draft: Draft, *, taped: bool, holes: bool) -> ag.Body:
    """Make a regular slotted box."""
    board, width, depth = draft.board, draft.width, draft.depth
    top = Top(board, width, depth, draft.height, draft.swing, taped)
    shell = top.creased(walls(board, width, depth, draft.height))
    corners: list[ag.Body] = []
    if holes:
        shell = hand_holes(shell, width, 0.66 * draft.height, board, depth=depth, span=(0.0, top.low))
        corners = hole_corners(width, 0.66 * draft.height, board)
    body = ag.weld(
        ag.part(shell, "box", board.outside),
        *corners,
        bottom_flaps(board, width, depth),
        *top.tape_ends(),
        *shipping_print(draft.look, width, depth, low=0.0, high=top.low - 0.02, finish=board.outside),
    )
    return top.attached(body, draft.feel, printed=draft.flap_label(top))


def half_slotted_box(draft: Draft, *, taped: bool, holes: bool, rub: ag.Scalar) -> ag.Body:
    """Make a cover without a bottom in a shallow tray, with four flaps at its top."""
    board, wider = draft.board, 2.0 * (draft.board.thick + PLAY)
    rim = 0.05 + 0.11 * draft.height
    foot = board.thick + LAYER
    tray = ag.part(walls(board, draft.width, draft.depth, rim), "box", board.outside)
    width, depth = draft.width - wider, draft.depth - wider
    top = Top(board, width, depth, draft.height, draft.swing, taped, rim)
    shell = top.creased(walls(board, width, depth, draft.height, base=foot, floor=False))
    shell = shell.require(top.low - rim >= 0.05, _LOW_COVER)
    corners: list[ag.Body] = []
    if holes:
        shell = hand_holes(shell, width, 0.62 * draft.height, board, depth=depth, span=(rim, top.low))
        corners = hole_corners(width, 0.62 * draft.height, board, label="sleeve")
    sleeve = ag.weld(
        ag.part(shell, "sleeve", board.outside),
        *corners,
        *top.tape_ends(),
        *shipping_print(draft.look, width, depth, low=rim, high=top.low - 0.02, finish=board.outside),
    )
    sleeve = top.attached(sleeve, draft.feel, printed=draft.flap_label(top), label="sleeve")
    return tray.attach(sleeve, lift("sleeve_lift", sleeve, travel=rim + 0.12, rub=rub))


def lidded_box(
    draft: Draft, *, pizza: bool, sides: Sides, ears: bool, dusted: bool, opening: ag.Scalar
) -> ag.Body:
    """Make a mailer, or a pizza box with vents."""
    board, look = draft.board, draft.look
    ag.require(not (dusted and sides == "tucked"), _NO_DUST)
    dust = ag.min_(0.28 * draft.depth, 0.30 * draft.width) if dusted else None
    plan = Lidded(board, draft.width, draft.depth, draft.height, sides, ears, dust, opening)
    shell = plan.creased(walls(board, draft.width, draft.depth, draft.height))
    marks: list[ag.Body] = []
    if pizza:
        hole = ag.extrude(vents(0.0065), 3.0 * draft.width, axis=ag.X).paint(board.edge)
        for share in (-0.30, 0.30):
            shell = shell - hole.at(0.0, share * draft.depth, 0.55 * draft.height)
        on_lid = pizza_print(look, 2.0 * plan.half, plan.reach)
        marks = [pizza_front(look, draft.width, draft.depth, draft.height)]
    else:
        on_lid = mailer_print(
            look, 2.0 * plan.half, plan.reach, finish=board.outside, inner=board.inside, thick=board.thick
        )
        if look.label:
            marks = side_label(
                look, draft.width, draft.depth, height=0.5 * draft.height, tall=0.8 * draft.height
            )
    body = ag.weld(ag.part(shell, "box", board.outside), *plan.rims(), *marks)
    return plan.attached(body, draft.feel, printed=on_lid, swing=draft.swing)


def wine_box(draft: Draft, *, bottles: int, wine: Wine | None, opening: ag.Scalar, taped: bool) -> ag.Body:
    """Make a box for bottles: a tall carton with a tucked lid for a few bottles, a slotted box for more."""
    board, (columns, rows) = draft.board, _GRID[bottles]
    t = board.thick
    inner = (draft.width * columns, draft.width * rows)
    width = inner[0] + 2.0 * t
    depth = inner[1] + (4.0 if rows == 1 else 2.0) * t
    marks = wine_print(draft.look, width, depth, draft.height, bottles=bottles, finish=board.outside)
    dust = 0.66 * draft.width if wine is None else None  # no space for a hand under dust flaps with bottles
    plan = Lidded(board, width, depth, draft.height, "over", False, dust, opening)
    low = 2.0 * t - 0.0002 if rows > 1 else t - 0.0002
    high = 0.60 * draft.height
    if rows == 1:
        high = ag.min_(high, draft.height - plan.tuck - 0.004)  # below the tuck
    grid = cells(board, inner[0], depth - 2.0 * t, columns=columns, rows=rows, low=low, high=high)
    within = [grid] if grid is not None else []
    ceiling = draft.height - t if rows == 1 else draft.height - 2.0 * t - LAYER
    filling = None if wine is None else Bottles(wine, columns, rows, draft.width, low, ceiling, t + LAYER)
    if rows > 1:
        beside = 0.0 if rows % 2 == 0 else draft.width / 2.0  # between two bottles
        top = Top(board, width, depth, draft.height, draft.swing, taped, beside=beside)
        shell = top.creased(walls(board, width, depth, draft.height))
        shell = hand_holes(shell, width, 0.78 * draft.height, board, depth=depth, span=(low, top.low))
        body = ag.weld(
            ag.part(shell, "box", board.outside),
            *hole_corners(width, 0.78 * draft.height, board),
            bottom_flaps(board, width, depth),
            *top.tape_ends(),
            *marks,
            *within,
        )
        return top.attached(body, draft.feel, bottles=filling)
    shell = plan.creased(walls(board, width, depth, draft.height))
    body = ag.weld(ag.part(shell, "box", board.outside), *plan.rims(), *marks, *within)
    return plan.attached(body, draft.feel, printed=[], swing=draft.swing, bottles=filling)


def tray_box(draft: Draft, *, skirt: ag.Scalar, rub: ag.Scalar, strapping: ag.Material) -> ag.Body:
    """Make a tray with a lid over it; a strap on the lid is its handle."""
    board, inset = draft.board, 2.0 * (draft.board.thick + PLAY)
    width, depth, top = draft.width, draft.depth, draft.height
    deep = ag.max_(skirt * top, 0.035)
    base = walls(board, width - inset, depth - inset, top - board.thick - LAYER)
    body = ag.weld(
        ag.part(base, "box", board.outside),
        *_base_label(draft, depth - inset, low=0.004, high=top - deep - 0.004),
    )
    printer = Ink(draft.look.ink(board.outside), ag.Z)
    mark = printer.put(draft.look.mark(0.52 * width, 0.055 * depth), (0.0, -0.27 * depth, top))
    lid = ag.weld(
        ag.part(cap(board, width, depth, top=top, skirt=deep), "lid", board.outside),
        strap(top, strapping),
        mark,
    )
    return body.attach(lid, lift("lid_lift", lid, travel=deep + 0.06, rub=rub))


def _base_label(draft: Draft, depth: ag.Scalar, *, low: ag.Scalar, high: ag.Scalar) -> list[ag.Body]:
    """Return the label with the contents, on the free part of the front of a tray."""
    if not draft.look.label:
        return []
    tall = ag.max_(high - low, 0.012)
    size = ag.min_(0.085, 1.3 * tall)
    return address_label(
        (0.26 * draft.width, -depth / 2.0, (low + high) / 2.0),
        facing=-ag.Y,
        size=size,
        number=draft.look.model,
    )


def gift_box(
    draft: Draft,
    closure: Closure,
    *,
    satin: ag.Material,
    wide: ag.Scalar,
    crossed: bool,
    hollow: Hollow,
    rounded: bool,
    skirt: ag.Scalar,
    rub: ag.Scalar,
    opening: ag.Scalar,
) -> ag.Body:
    """Make a gift box."""
    board, top = draft.board, draft.height
    gift = Gift(board, draft.width, draft.depth, top, satin, wide, hollow, foam(board.inside))
    match closure:
        case "flap":
            # in the frame of the lid's sheet, with the free edge in front
            mark = name_on_lid(draft.look, draft.width, draft.depth)
            foil = Ink(GOLD, ag.Z, (0.0, -1.0, 0.0)).put(mark, (0.0, 0.5 * draft.depth, 0.0))
            reach = (0.45 + 0.55 * skirt) * top
            return gift.flapped(draft.feel, opening=opening, reach=reach, rounded=rounded, printed=[foil])
        case "drawer":
            mark = name_on_lid(draft.look, draft.width, draft.depth)
            return gift.drawn(1.0 + 3.0 * rub, printed=[Ink(GOLD, ag.Z).put(mark, (0.0, 0.0, top))])
        case _:
            return gift.lifted(skirt * top, rub, crossed=crossed, printed=[])
