"""Gift boxes of wrapped grayboard with a loose lid, a flap over the front, or a drawer; handles of lids."""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.box.board import Board, walls
from artgen.categories.box.finish import GOLD, foam
from artgen.categories.box.kinds import PLAY, capped
from artgen.categories.box.prints import Look, pull_tab, put

Closure = Literal["lift", "flap", "drawer"]
"""Closures: a loose lid, a hinged lid with a flap over the front, or a sleeve with a drawer."""

Hollow = Literal["none", "square", "round"]
"""Shape of the hollow in the foam, if there is foam."""

_RIBBON = 0.0005  # thickness of satin ribbon on a face [m]


def strap(finish: ag.Material) -> ag.Body:
    """Make a riveted strap of webbing on a lid at z = 0 as its handle: a flat arch along x."""
    outline = ag.polygon(
        [(-0.064, 0.0), (-0.049, 0.0), (-0.037, 0.020), (0.037, 0.020), (0.049, 0.0), (0.064, 0.0),
         (0.064, 0.0026), (0.0505, 0.0026), (0.0385, 0.0226),
         (-0.0385, 0.0226), (-0.0505, 0.0026), (-0.064, 0.0026)]
    )  # fmt: skip
    band = ag.extrude(outline, 0.022, axis=ag.Y).at(z=-0.0002)
    hold = ag.grasp_on(band, approach=-ag.Z, closing=ag.Y, at=(0.0, 0.0, 0.021), depth=0.010)
    rivets = [details.rivet(0.0045, (x, 0.0, 0.0022), facing=ag.Z) for x in (-0.0572, 0.0572)]
    body = ag.part(band, "handle", finish, name="strap", grasp=hold)
    return ag.weld(body, ag.detail(rivets, "handle", ag.material("satin_nickel")))


def lifted(
    board: Board,
    case: ag.Region,
    satin: ag.Material,
    wide: ag.Scalar,
    *,
    crossed: bool,
    skirt: ag.Scalar,
    rub: ag.Scalar,
) -> ag.Body:
    """Make a base with a loose lid, and a ribbon with a bow around both."""
    fit, foot = board.thick + PLAY, case.z.high - skirt
    seen = ag.max_(foot - 0.004, 0.0015)  # visible height of the base, below the lid [m]
    base = case.shrink(x=fit, y=fit).with_(z=(0.0, seen))
    lid = case.with_(z=(foot, case.z.high))
    bands = [_bands(each, wide, crossed=crossed, over=over) for each, over in ((base, False), (lid, True))]
    ribbons = [ag.detail(each, "ribbon", satin) for each in bands]
    bow = _bow(satin, wide).at(z=case.z.high + _RIBBON)
    return capped(board, case, skirt, rub, on_base=ribbons[:1], on_lid=[ribbons[1], bow])


def _bands(on: ag.Region, wide: ag.Scalar, *, crossed: bool, over: bool) -> list[ag.Solid]:
    """Make the ribbon on the front, the back and the top of a part, or on all its sides."""
    bands = []
    for long, turn in ((on.y.size, 0.0), (on.x.size, math.pi / 2))[: 2 if crossed else 1]:
        band = ag.Region.centered(wide, long, 0.0).with_(z=(on.z.low + 0.0003, on.z.high))
        front = band.with_(y=(band.y.low - _RIBBON, band.y.low + 0.0002))
        back = band.with_(y=(band.y.high - 0.0002, band.y.high + _RIBBON))
        top = band.grow(y=_RIBBON).with_(z=(on.z.high - 0.0002, on.z.high + _RIBBON))
        strips = [front, back, top] if over else [front, back]
        bands += [strip.box().rotate(ag.Z, turn) for strip in strips]
    return bands


def _bow(satin: ag.Material, wide: ag.Scalar) -> ag.Body:
    """Make a bow on the plane z = 0: a knot to grasp, two loops and two ends."""
    knot = ag.Region((-0.011, 0.011), (-0.0095, 0.0095), (-0.001, 0.024)).box(bevel=0.006)
    hold = ag.grasp_on(knot, approach=-ag.Z, closing=ag.Y, depth=0.014)
    loop = ag.extrude(ag.ellipse(0.034, 0.0135) - ag.ellipse(0.0325, 0.012), 0.8 * wide, axis=ag.Y)
    inner = ag.extrude(ag.ellipse(0.024, 0.0095) - ag.ellipse(0.0225, 0.008), 0.66 * wide, axis=ag.Y)
    tail = ag.Region((0.0, 0.062), (-0.36 * wide, 0.36 * wide), (-0.0004, 0.0004)).box()
    half = [loop.rotate(ag.Y, -0.22).at(0.042, 0.0, 0.015), inner.rotate(ag.Y, -0.5).at(0.031, 0.0, 0.022)]
    loops = [each.rotate(ag.Z, turn) for turn in (math.pi, 0.0) for each in half]
    ends = [tail.at(0.006, 0.0, 0.001).rotate(ag.Z, turn).at(z=0.0006) for turn in (math.pi - 2.1, -0.3)]
    body = ag.part(knot, "ribbon", satin, name="bow", grasp=hold)
    return ag.weld(body, ag.detail([*loops, *ends], "ribbon", satin))


def _insert(board: Board, room: ag.Region, hollow: Hollow) -> list[ag.Body]:
    """Make the foam for the contents, with a hollow, or nothing."""
    if hollow == "none":
        return []
    width, depth, height = room.size
    block = ag.Region.centered(width, depth, height).box(bevel=0.001)
    block = block.scale((width - 0.0012) / width, (depth - 0.0012) / depth, 1.0)
    if hollow == "round":
        pit = ag.simplified_collider(ag.cylinder(0.32 * ag.min_(width, depth), height))
    else:
        pit = ag.box(0.74 * width, 0.62 * depth, height)
    solid = (block - pit.at(z=0.25 * height)).at(room.center).at(z=-0.0002)
    return [ag.part(solid, "insert", foam(board.inside))]


def flapped(
    board: Board,
    case: ag.Region,
    look: Look,
    satin: ag.Material,
    hollow: Hollow,
    *,
    reach: ag.Scalar,
    rounded: bool,
) -> ag.Body:
    """Make a base with a lid that is hinged at the back and ends in a flap over the front."""
    (width, depth, height), t = case.size, board.thick
    long, wide, low = depth + t + 0.0008, width + 0.004, board.under(height)
    outline = ag.rectangle(wide, reach).at(0.0, reach / 2)
    if rounded:
        radius = ag.min_(0.36 * reach, 0.46 * width)  # at most half a circle, on a narrow flap
        tip = ag.rectangle(wide, 0.8 * reach, radius=radius).at(0.0, 0.6 * reach)
        outline = tip | ag.rectangle(wide, 0.5 * reach).at(0.0, 0.25 * reach)
    tab = pull_tab("tab", label="ribbon", material=satin).at(0.0, reach - 0.012)
    cover = ag.weld(ag.part(board.sheet(outline), "lid", board.outside, name="flap_front"), tab)
    turn = board.crease("flap_front_hinge", length=width, reach=reach, opening=2.4, fresh=True)
    sheet = ag.Region((-wide / 2, wide / 2), (0.0, long), (-t, 0.0))
    front = board.fold(cover, turn, sheet, "back", bead=width, label="lid", hangs=True)
    # the name, for a reader at the free edge
    name = put(look.stamp(case), (0.0, 0.5 * depth, 0.0), GOLD, ag.Z, (0.0, -1.0, 0.0))
    top = ag.part(board.sheet(sheet.plan()), "lid", board.outside).install(front)
    moment = feel.GRAVITY * board.outside.density * t * width * long * 0.62 * long  # of the open lid [N m]
    swing = board.crease(
        "lid_hinge", length=width, reach=long, opening=board.opening, fresh=True, holding=0.4 * moment
    )
    lid = board.fold(ag.weld(top, name), swing, case, "back", bead=width)
    above = ag.Region((-width, width), (-depth, case.y.high - 1.6 * t), (low, height + 0.01))
    shell = walls(board, case) - above.box().paint(board.outside)
    body = ag.part(shell, "box", board.outside).install(lid)
    return ag.weld(body, *_insert(board, case.shrink(x=t, y=t).with_(z=(t, t + 0.55 * low)), hollow))


def drawn(
    board: Board, case: ag.Region, look: Look, satin: ag.Material, hollow: Hollow, *, friction: ag.Scalar
) -> ag.Body:
    """Make a sleeve with a drawer that has a ribbon as its pull."""
    t, fit, paper = board.thick, board.thick + PLAY, board.outside
    front = case.y.low
    shell = case.grow(front=0.01).box(bevel=0.0012).paint(paper)
    ahead = case.grow(0.1).with_(y=(front - 0.1, front)).box().paint(paper)
    cavity = case.shrink(t, front=-0.1).box().paint(paper)
    sleeve = ag.part(shell - ahead - cavity, "box", paper)
    inside = case.shrink(x=fit, z=fit, back=fit)
    tab = pull_tab("tab", label="ribbon", material=satin).rotate(ag.X, math.pi / 2).rotate(ag.Y, math.pi / 2)
    floor = inside.z.low + t
    room = inside.shrink(x=t, y=t).with_(z=(floor, floor + 0.6 * inside.z.size))
    drawer = ag.weld(
        ag.part(walls(board, inside), "drawer", paper),
        *_insert(board, room, hollow),
        tab.at(0.0, front, case.z.mid),
    )
    travel = 0.86 * inside.y.size
    slide = ag.Prismatic(
        "drawer_slide", axis=-ag.Y, limits=(0.0, travel), friction=friction, damping=3.0, effort=20.0
    )
    name = put(look.stamp(case), (0.0, 0.0, case.z.high), GOLD, ag.Z)
    return ag.weld(sleeve, name).attach(drawer, slide)
