"""Kinds of boxes for goods, each assembled from walls, closures, contents and prints."""

import functools
import math
import operator
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.box import prints
from artgen.categories.box.board import LAYER, Board, bottom_flaps, dividers, hand_holes, walls
from artgen.categories.box.closures import Lid, Mouth, Sides, flap_reach, slotted_top
from artgen.categories.box.prints import Look
from artgen.nodes.fitting import Fitting

PLAY = 0.0012
"""Gap between sliding parts, at each side [m]."""


_ENDS: tuple[Mouth, ...] = ("_left", "_right")
_LOW_COVER = "the cover would protrude too little from its tray: raise height"
_NO_DUST = "dust flaps need a lid that lies on the walls: take sides=over or dusted=False"
_SIDES_MEET = (
    "the side flaps of an open end, half the height long, would collide: lower height, or raise "
    "width or aspect"
)


def slotted_box(
    board: Board, case: ag.Region, look: Look, *, taped: bool, holes: bool, rub: ag.Scalar | None = None
) -> ag.Body:
    """Make a slotted box; or, with the friction `rub`, a cover without a bottom in a shallow tray."""
    (width, _, height), half, fit = case.size, rub is not None, board.thick + PLAY
    label, rim, hole = ("sleeve", 0.05 + 0.11 * height, 0.62) if half else ("box", 0.0, 0.66)
    region = case.shrink(x=fit, y=fit, bottom=board.thick + LAYER) if half else case
    free, reach = region.with_(z=(rim, board.under(height))), flap_reach(region)
    shell = walls(board, region, floor=not half).require(free.z.size >= 0.05, _LOW_COVER)
    body = ag.part(shell, label, board.outside)
    if holes:
        body = body.install(hand_holes(board, free, hole * height, label))
    address = look.address((-0.27 * width, 0.46 * reach, 0.0), ag.min_(0.10, 0.8 * reach))
    top, _ = slotted_top(board, region, taped=taped, printed=address, label=label, ground=rim)
    body = ag.weld(body.install(top), *prints.shipping(look, free.shrink(top=0.02), board.outside))
    if rub is None:
        return ag.weld(body, bottom_flaps(board, case))
    tray = ag.part(walls(board, case.with_(z=(0.0, rim))), "box", board.outside)
    return tray.attach(body, _lift("sleeve_lift", body, travel=rim + 0.12, rub=rub))


def _lift(name: str, moved: ag.Body, *, travel: ag.Scalar, rub: ag.Scalar) -> ag.Joint:
    """Make the joint of a loose lid; `rub` is its friction as a share of its weight."""
    weight = moved.weight()
    drag = feel.Feel(damping=4.0, friction=rub * weight, effort=4 * weight + 4.0)  # the gap draws in air
    return ag.Prismatic(name, axis=ag.Z, limits=(0.0, travel), feel=drag)


def open_ended_box(board: Board, case: ag.Region, look: Look, *, taped: bool) -> ag.Body:
    """Make a slotted box with four flaps at each end."""
    tall = ag.require(case.z.high, case.z.high <= case.y.size, _SIDES_MEET)
    upright = _upright(case.with_(z=(0.0, tall)))
    ends = [slotted_top(board, upright, taped=taped, mouth=mouth)[0] for mouth in _ENDS]
    marks = prints.shipping(look, case, board.outside, sides=False)
    return ag.weld(_lying(board, upright, ends), *marks, *_on_top(board, case, look))


def tuck_end_box(board: Board, case: ag.Region, look: Look, *, ears: bool, lips: bool) -> ag.Body:
    """Make a carton with a lid at each end, hinged at the upper edge, with side flaps under the lid."""
    long, wide, tall = case.size
    upright, dust = _upright(case), ag.min_(0.42 * tall, 0.30 * wide)
    lid = functools.partial(Lid, board, upright, ears=ears, dust=dust, lips=lips, lined=0.7 * long, grip=0.05)
    ends = [lid(mouth=mouth).fitting() for mouth in _ENDS]
    name = look.mark(0.62 * long, 0.17 * tall)
    mark = prints.put(name, (0.0, case.y.low, 0.52 * tall), look.ink(board.outside))
    return ag.weld(_lying(board, upright, ends), mark, *_on_top(board, case, look))


def _upright(case: ag.Region) -> ag.Region:
    """Return the region of a box that is set up on its left end, with its front at the side."""
    long, wide, tall = case.size
    return ag.Region((-wide / 2, wide / 2), (-tall / 2, tall / 2), (0.0, long))


def _lying(board: Board, upright: ag.Region, ends: Sequence[Fitting]) -> ag.Body:
    """Lay a tube with a closure at both ends down; each closure is made as the top of an upright box."""
    _, tall, long = upright.size
    below = upright.grow(0.1).with_(z=(-0.01, 0.0))
    tube = walls(board, upright.grow(bottom=0.004), floor=False) - below.box().paint(board.edge)
    body = ag.part(tube, "box", board.outside)
    body = body.install(ends[0].rotate(ag.Y, math.pi, about=upright.center)).install(ends[1])
    return body.rotate(ag.Z, math.pi / 2).rotate(ag.Y, math.pi / 2).at(-long / 2, 0.0, tall / 2)


def _on_top(board: Board, case: ag.Region, look: Look) -> list[ag.Body]:
    """Print the name on the upper wall, with the address label in front of it."""
    width, depth, height = case.size
    name = look.mark(0.55 * width, 0.16 * depth)
    label = look.address((-0.27 * width, -0.30 * depth, height), ag.min_(0.105, 0.45 * depth))
    return [prints.put(name, (0.0, 0.0, height), look.ink(board.outside), ag.Z), *label]


def lidded_box(
    board: Board, case: ag.Region, look: Look, *, pizza: bool, sides: Sides, ears: bool, dusted: bool
) -> ag.Body:
    """Make a mailer, or a pizza box with vents."""
    width, depth, height = case.size
    ag.require(not (dusted and sides == "tucked"), _NO_DUST)
    dust = ag.min_(0.28 * depth, 0.30 * width) if dusted else None
    lid = Lid(board, case, sides=sides, ears=ears, dust=dust)
    shell = walls(board, case)
    if pizza:
        vent = ag.extrude(ag.regular_polygon(8, 0.0065), 3 * width, axis=ag.X).paint(board.edge)
        for share in (-0.30, 0.30):
            shell = shell - vent.at(0.0, share * depth, 0.55 * height)
        printed, marks = prints.pizza(look, lid.top), prints.pizza_front(look, case)
    else:
        printed = prints.mailer(look, lid.top, board.outside, board.inside)
        size = ag.min_(ag.min_(0.105, 0.96 * height), 0.5 * width)
        marks = look.address((-0.24 * width, case.y.low, 0.5 * height), size, prints.FRONT)
    return ag.weld(ag.part(shell, "box", board.outside).install(lid.fitting(printed)), *marks)


def tray_box(
    board: Board, case: ag.Region, look: Look, *, skirt: ag.Scalar, rub: ag.Scalar, strap: ag.Body
) -> ag.Body:
    """Make a tray with a lid over it; a strap on the lid is its handle."""
    width, depth, height = case.size
    deep = ag.max_(skirt * height, 0.035)
    front = case.with_(z=(0.004, height - deep - 0.004)).shrink(y=board.thick + PLAY)  # below the lid
    at = front.with_(x=(0.0, 0.52 * width)).anchor(y=-1)
    label = look.address(at, ag.min_(0.085, 1.3 * ag.max_(front.z.size, 0.012)), prints.FRONT)
    name = look.mark(0.52 * width, 0.055 * depth)
    mark = prints.put(name, (0.0, -0.27 * depth, height), look.ink(board.outside), ag.Z)
    return capped(board, case, deep, rub, on_base=label, on_lid=[strap.at(z=height), mark])


def capped(
    board: Board,
    case: ag.Region,
    skirt: ag.Scalar,
    rub: ag.Scalar,
    *,
    on_base: Sequence[ag.Body],
    on_lid: Sequence[ag.Body],
) -> ag.Body:
    """Make a tray with an upside-down tray as its lid, whose walls go down by `skirt` [m]."""
    base = case.shrink(x=board.thick + PLAY, y=board.thick + PLAY, top=board.thick + LAYER)
    body = ag.weld(ag.part(walls(board, base), "box", board.outside), *on_base)
    cap = walls(board, case.with_(z=(0.0, skirt))).rotate(ag.X, math.pi).at(z=case.z.high)
    lid = ag.weld(ag.part(cap, "lid", board.outside), *on_lid)
    return body.attach(lid, _lift("lid_lift", lid, travel=skirt + 0.06, rub=rub))


Wine = Literal["none", "red", "white", "rose"]

_CELLS = {2: (2, 1), 3: (3, 1), 6: (3, 2), 12: (4, 3)}  # numbers of cells along x and y, by their product
_FULL = 1450.0  # 0.5 kg of glass and 0.75 l of wine: 1.25 kg in the 0.86 l of the facets [kg/m3]
_RADIUS, _NECK = 0.0372, 0.0142  # radii of the body and the neck of a Bordeaux bottle [m]
_BODY, _SHOULDER, _TALL = 0.192, 0.226, 0.300  # heights of the ends of body and shoulder, and of the top [m]
_SPARE = 0.0025  # least gap above a bottle [m]
_DEEP = 0.1  # largest gap below a lid: a hand reaches the neck, and the lift takes the bottle out [m]
_TOO_DEEP = "a hand cannot reach bottles of 0.3 m in so deep a box: lower height"
_NO_ROOM = "bottles of 0.3 m would collide with the lid over them: raise height, or take a thinner flute"
# kinds of wine: name and color of the glass, and color of the foil
_BOTTLES: dict[Wine, tuple[str, tuple[float, float, float], str]] = {
    "red": ("green", (0.012, 0.026, 0.012), "burgundy"),
    "white": ("yellow_green", (0.16, 0.20, 0.05), "mustard"),
    "rose": ("pink", (0.52, 0.18, 0.13), "silver"),
}


def wine_box(
    board: Board, cell: ag.Scalar, height: ag.Scalar, look: Look, *, bottles: int, wine: Wine, taped: bool
) -> ag.Body:
    """Make a box for bottles: a tall carton with a tucked lid for a few bottles, a slotted box for more."""
    (columns, rows), t = _CELLS[bottles], board.thick
    depth = rows * cell + (4 if rows == 1 else 2) * t
    case = ag.Region.centered(columns * cell + 2 * t, depth, 0.0).with_(z=(0.0, height))
    marks = prints.wine(look, case, board.outside, bottles=bottles)
    shell, high = walls(board, case), 0.60 * height
    if rows == 1:
        dust = 0.66 * cell if wine == "none" else None  # no space for a hand under dust flaps with bottles
        lid = Lid(board, case, dust=dust)
        low, ceiling = t - 0.0002, height - t
        high = ag.min_(high, height - lid.tuck - 0.004)  # below the tuck
        body = ag.part(shell, "box", board.outside).install(lid.fitting())
        opened = [lid.away]
    else:
        beside = 0.0 if rows % 2 == 0 else cell / 2  # between two bottles
        low, ceiling = 2 * t - 0.0002, board.under(height) - t
        holes = hand_holes(board, case.with_(z=(low, board.under(height))), 0.78 * height)
        top, opened = slotted_top(board, case, taped=taped, beside=beside)
        body = ag.part(shell, "box", board.outside).install(holes).install(top)
        body = ag.weld(body, bottom_flaps(board, case))
    room = case.shrink(x=t, y=t).with_(z=(low, high))
    body = ag.weld(body, *marks, dividers(board, room, columns=columns, rows=rows))
    if wine == "none":
        return body
    bottle = _bottle(wine, ag.X if rows == 1 else ag.Y)  # an open lid is behind a single row
    low = low + 0.0006
    most = ceiling + t + LAYER  # below the major flaps
    body = body.require(ceiling - low >= _TALL + _SPARE, _NO_ROOM)
    body = body.require(most - low <= _TALL + _DEEP, _TOO_DEEP)
    for number in range(bottles):
        row, column = divmod(number, columns)
        cells = (row, rows - 1 - row, column, columns - 1 - column)  # to the sides with flaps
        over = [each + 0.08 < rows / 2 for each in cells]
        needs = [flap for flap, above in zip(opened, over, strict=False) if above]
        above = ceiling if rows == 1 or any(over[2:]) else most
        slide = ag.Prismatic(
            f"bottle_lift_{number}",
            axis=ag.Z,
            limits=(0.0, 0.32),
            friction=0.3,
            damping=3.0,
            effort=1.03 * bottle.weight() + 0.3,  # the lifting force opens no flap
            needs=functools.reduce(operator.and_, needs).beyond(above - low - _TALL - 0.002),
        )
        at = (cell * (column - (columns - 1) / 2), cell * (row - (rows - 1) / 2), low)
        body = body.attach(bottle.at(at).suffixed(f"_{number}"), slide)
    return body


def _bottle(wine: Wine, across: ag.Vector) -> ag.Body:
    """Make a bottle with its bottom at the origin, which fingers grasp across its neck."""
    name, color, cap = _BOTTLES[wine]
    glass = ag.material("black_glass").with_(name=f"{name}_bottle", base_color=color, density=_FULL)
    foil = ag.colored("abs", cap).with_(name=f"{wine}_foil", texture="")
    paper = ag.colored("abs", "cream").with_(name="wine_label", texture="", specular_roughness=0.7)
    # a hull of few facets just under the round surface carries the weight and collides
    core = ag.extrude(ag.regular_polygon(12, _RADIUS - 0.0001), _BODY).at(z=_BODY / 2)
    stem = ag.extrude(ag.regular_polygon(12, _NECK - 0.0001), _TALL - _BODY + 0.01)
    stem = stem.at(z=(_TALL + _BODY - 0.01) / 2)
    hold = ag.grasp_on(stem, approach=-ag.Z, closing=across, depth=0.010)
    slope = ag.frustum(_RADIUS, _NECK + 0.003, _SHOULDER - _BODY + 0.004)
    seen = [
        ag.cylinder(_RADIUS, _BODY, bevel=0.004).at(z=_BODY / 2),
        slope.at(z=(_SHOULDER + _BODY) / 2 - 0.003),
        ag.cylinder_between((0.0, 0.0, _SHOULDER - 0.004), (0.0, 0.0, _TALL), _NECK, bevel=0.001),
    ]
    return ag.weld(
        ag.part(core | stem, "bottle", glass, grasp=hold),
        ag.detail(seen, "bottle", glass),
        ag.detail(ag.tube(_NECK + 0.0003, _NECK - 0.001, 0.052).at(z=_TALL - 0.0257), "bottle", foil),
        ag.detail(ag.tube(_RADIUS + 0.0002, _RADIUS - 0.001, 0.085).at(z=0.082), "bottle", paper),
    )
