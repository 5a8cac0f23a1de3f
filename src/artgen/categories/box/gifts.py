"""Boxes with a loose lid or a drawer: trays with a lid, and gift boxes with foam and ribbons."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.box.board import LAYER, Board, Crease, Feel, walls
from artgen.categories.box.prints import pull_tab

PLAY = 0.0012
"""Gap between sliding parts, at each side [m]."""

_GRAVITY = 9.81  # gravity [m/s2]


def lift(name: str, moved: ag.Body, *, travel: ag.Scalar, rub: ag.Scalar) -> ag.Joint:
    """Make the joint of a loose lid."""
    weight = _GRAVITY * moved.mass()
    return ag.Prismatic(
        name,
        axis=ag.Z,
        limits=(0.0, travel),
        friction=rub * weight,
        damping=4.0,  # air drawn in through the gap
        effort=4.0 * weight + 4.0,
        velocity=1.0,
    )


def cap(board: Board, width: ag.Scalar, depth: ag.Scalar, *, top: ag.Scalar, skirt: ag.Scalar) -> ag.Solid:
    """Make an upside-down tray as a lid."""
    return walls(board, width, depth, skirt).rotate(ag.X, math.pi).at(0.0, 0.0, top)


def strap(at: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a riveted strap of webbing on a lid as its handle: a flat arch along x."""
    outline = ag.polygon(
        [(-0.064, 0.0), (-0.049, 0.0), (-0.037, 0.020), (0.037, 0.020), (0.049, 0.0), (0.064, 0.0),
         (0.064, 0.0026), (0.0505, 0.0026), (0.0385, 0.0226),
         (-0.0385, 0.0226), (-0.0505, 0.0026), (-0.064, 0.0026)]
    )  # fmt: skip
    band = ag.extrude(outline, 0.022, axis=ag.Y).at(0.0, 0.0, at - 0.0002)
    hold = ag.grasp_on(band, approach=-ag.Z, closing=ag.Y, at=(0.0, 0.0, at + 0.021), depth=0.010)
    steel = ag.material("satin_nickel")
    rivets = [
        ag.detail(details.rivet(0.0045, (x, 0.0, at + 0.0022), facing=ag.Z), "handle", steel)
        for x in (-0.0572, 0.0572)
    ]
    return ag.weld(ag.part(band, "handle", finish, name="strap", grasp=hold), *rivets)


def drawer_case(board: Board, width: ag.Scalar, depth: ag.Scalar, height: ag.Scalar) -> ag.Solid:
    """Make a sleeve that is open at the front."""
    t = board.thick
    shell = (
        ag.Region.between((-width / 2.0, -depth / 2.0 - 0.01, 0.0), (width / 2.0, depth / 2.0, height))
        .box(bevel=0.0012)
        .paint(board.outside)
    )
    ahead = (
        ag.Region.between((-width, -depth, -0.01), (width, -depth / 2.0, height + 0.01))
        .box()
        .paint(board.outside)
    )
    inside = ag.Region.between(
        (-width / 2.0 + t, -depth, t), (width / 2.0 - t, depth / 2.0 - t, height - t)
    ).box()
    return shell - ahead - inside.paint(board.outside)


Closure = Literal["lift", "flap", "drawer"]
"""Closures: a loose lid, a hinged lid with a flap over the front, or a sleeve with a drawer."""

Hollow = Literal["none", "square", "round"]
"""Shape of the hollow in the foam, if there is foam."""

_RIBBON = 0.0005  # thickness of satin ribbon on a face [m]


@dataclass(frozen=True)
class Gift:
    """A gift box."""

    board: Board  # wrapped grayboard
    width: ag.Scalar  # outer width along x [m]
    depth: ag.Scalar  # outer depth along y [m]
    height: ag.Scalar  # height of the closed box [m]
    satin: ag.Material  # material of the ribbon
    wide: ag.Scalar  # width of the ribbon [m]
    hollow: Hollow  # hollow in the foam inside a box with a flap or a drawer
    foam: ag.Material  # material of the foam

    def lifted(self, skirt: ag.Scalar, rub: ag.Scalar, *, crossed: bool, printed: list[ag.Body]) -> ag.Body:
        """Make a base with a loose lid, and a ribbon with a bow around both."""
        inset = 2.0 * (self.board.thick + PLAY)
        wide, deep = self.width - inset, self.depth - inset
        base_top = self.height - self.board.thick - LAYER
        base = ag.part(walls(self.board, wide, deep, base_top), "box", self.board.outside)
        foot = self.height - skirt
        seen = ag.max_(foot - 0.004, 0.0015)  # visible height of the base, below the lid [m]
        body = ag.weld(base, *self._bands(wide, deep, 0.0, seen, crossed=crossed, over=False))
        lid = ag.weld(
            ag.part(
                cap(self.board, self.width, self.depth, top=self.height, skirt=skirt),
                "lid",
                self.board.outside,
            ),
            *self._bands(self.width, self.depth, foot, self.height, crossed=crossed, over=True),
            self._bow(),
            *printed,
        )
        return body.attach(lid, lift("lid_lift", lid, travel=skirt + 0.06, rub=rub))

    def _bands(
        self,
        width: ag.Scalar,
        depth: ag.Scalar,
        low: ag.Scalar,
        high: ag.Scalar,
        *,
        crossed: bool,
        over: bool,
    ) -> list[ag.Body]:
        """Make the ribbon on the walls and the top of one part."""
        half, out = self.wide / 2.0, _RIBBON
        made = []
        ways = ("y", "x") if crossed else ("y",)
        for way in ways:
            long = depth if way == "y" else width
            spans = [((-long / 2.0 - out, -long / 2.0 + 0.0002), (low + 0.0003, high))]
            spans += [((long / 2.0 - 0.0002, long / 2.0 + out), (low + 0.0003, high))]
            if over:
                spans.append(((-long / 2.0 - out, long / 2.0 + out), (high - 0.0002, high + out)))
            for (near, far), (bottom, top) in spans:
                corners = ((-half, near, bottom), (half, far, top))
                if way == "x":
                    corners = ((near, -half, bottom), (far, half, top))
                made.append(ag.detail(ag.Region.between(*corners).box(), "ribbon", self.satin))
        return made

    def _bow(self) -> ag.Body:
        """Make the bow on the lid: a knot to grasp, two loops and two ends."""
        top = self.height + _RIBBON
        tall = 0.024
        knot = ag.Region.between((-0.011, -0.0095, top - 0.001), (0.011, 0.0095, top + tall)).box(bevel=0.006)
        hold = ag.grasp_on(knot, approach=-ag.Z, closing=ag.Y, depth=0.014)
        bodies = [ag.part(knot, "ribbon", self.satin, name="bow", grasp=hold)]
        loop = ag.extrude(ag.ellipse(0.034, 0.0135) - ag.ellipse(0.0325, 0.012), 0.8 * self.wide, axis=ag.Y)
        inner = ag.extrude(ag.ellipse(0.024, 0.0095) - ag.ellipse(0.0225, 0.008), 0.66 * self.wide, axis=ag.Y)
        tail = ag.Region.between((0.0, -0.36 * self.wide, -0.0004), (0.062, 0.36 * self.wide, 0.0004)).box()
        for side in (-1.0, 1.0):
            turned = 0.0 if side > 0.0 else math.pi
            for each, at, rise, raised in ((loop, 0.042, 0.015, 0.22), (inner, 0.031, 0.022, 0.5)):
                bow = each.rotate(ag.Y, -raised).at(at, 0.0, rise).rotate(ag.Z, turned)
                bodies.append(ag.detail(bow.at(0.0, 0.0, top), "ribbon", self.satin))
            end = tail.at(0.006, 0.0, 0.001).rotate(ag.Z, turned + side * 0.9 - 1.2)
            bodies.append(ag.detail(end.at(0.0, 0.0, top + 0.0006), "ribbon", self.satin))
        return ag.weld(*bodies)

    def _insert(
        self,
        width: ag.Scalar,
        depth: ag.Scalar,
        at: tuple[ag.Scalar, ag.Scalar, ag.Scalar],
        height: ag.Scalar,
    ) -> list[ag.Body]:
        """Make the foam for the contents, with a hollow; return None for a box without foam."""
        if self.hollow == "none":
            return []
        block = ag.Region.between((-width / 2.0, -depth / 2.0, 0.0), (width / 2.0, depth / 2.0, height)).box(
            bevel=0.001
        )
        block = block.scale((width - 0.0012) / width, (depth - 0.0012) / depth, 1.0)
        if self.hollow == "round":
            pit = ag.cylinder(0.32 * ag.min_(width, depth), height, bevel=0.0)
            pit = ag.simplified_collider(pit)
        else:
            pit = ag.box(0.74 * width, 0.62 * depth, height)
        solid = (block - pit.at(0.0, 0.0, 0.75 * height)).at(at[0], at[1], at[2] - 0.0002)
        return [ag.part(solid, "insert", self.foam)]

    def flapped(
        self, feel: Feel, *, opening: ag.Scalar, reach: ag.Scalar, rounded: bool, printed: list[ag.Body]
    ) -> ag.Body:
        """Make a base with a lid that is hinged at the back and ends in a flap over the front."""
        board, t = self.board, self.board.thick
        long = self.depth + t + 0.0008
        hinge = Crease(0.0, self.depth / 2.0, self.height, turn=math.pi)
        front = Crease(0.0, long, folded=True)
        low = self.height - t - LAYER
        over = (
            ag.Region.between(
                (-self.width, -self.depth, low), (self.width, self.depth / 2.0 - 1.6 * t, self.height + 0.01)
            )
            .box()
            .paint(board.outside)
        )
        shell = board.creased(walls(board, self.width, self.depth, self.height) - over, hinge)
        sheet = board.creased(board.sheet(ag.rectangle(self.width + 0.004, long).at(0.0, long / 2.0)), front)
        lid = ag.weld(
            ag.part(sheet, "lid", board.outside), front.bead(self.width, "lid", board.outside), *printed
        )
        outline = ag.rectangle(self.width + 0.004, reach).at(0.0, reach / 2.0)
        if rounded:
            radius = ag.min_(0.36 * reach, 0.46 * self.width)  # at most half a circle, on a narrow flap
            tongue = ag.rectangle(self.width + 0.004, 0.8 * reach, radius=radius)
            outline = tongue.at(0.0, 0.6 * reach) | ag.rectangle(self.width + 0.004, 0.5 * reach).at(
                0.0, 0.25 * reach
            )
        flap = board.sheet(outline)
        tab = pull_tab().at(0.0, reach - 0.012, 0.0)
        hold = ag.grasp_on(tab, approach=-ag.Z, closing=ag.Y, depth=0.016)
        cover = ag.weld(
            ag.part(flap, "lid", board.outside, name="flap_front"),
            ag.part(tab, "ribbon", self.satin, name="tab", grasp=hold),
        )
        turn = front.joint("flap_front_hinge", feel=feel, length=self.width, reach=reach, opening=2.4)
        weight = 9.81 * board.outside.density * t * self.width * long * 0.62 * long
        swing = hinge.joint(
            "lid_hinge", feel=feel, length=self.width, reach=long, opening=opening, holding=0.4 * weight
        )
        body = ag.weld(
            ag.part(shell, "box", board.outside),
            hinge.bead(self.width, "box", board.outside),
            *self._insert(self.width - 2.0 * t, self.depth - 2.0 * t, (0.0, 0.0, t), 0.55 * low),
        )
        return body.attach(hinge.place(lid.attach(front.place(cover), turn)), swing)

    def drawn(self, friction: ag.Scalar, *, printed: list[ag.Body]) -> ag.Body:
        """Make a sleeve with a drawer that has a ribbon as its pull."""
        board, t = self.board, self.board.thick
        case = ag.part(drawer_case(board, self.width, self.depth, self.height), "box", board.outside)
        wide, tall = self.width - 2.0 * (t + PLAY), self.height - 2.0 * (t + PLAY)
        long = self.depth - t - PLAY
        inside = walls(board, wide, long, tall).at(0.0, (-self.depth + long) / 2.0, t + PLAY)
        face = -self.depth / 2.0
        tab = (
            pull_tab()
            .rotate(ag.X, math.pi / 2.0)
            .rotate(ag.Y, math.pi / 2.0)
            .at(0.0, face, self.height / 2.0)
        )
        hold = ag.grasp_on(tab, approach=ag.Y, closing=ag.X, depth=0.016)
        middle = ((0.0, (-self.depth + long) / 2.0, 2.0 * t + PLAY), 0.6 * tall)
        drawer = ag.weld(
            ag.part(inside, "drawer", board.outside),
            *self._insert(wide - 2.0 * t, long - 2.0 * t, *middle),
            ag.part(tab, "ribbon", self.satin, name="tab", grasp=hold),
        )
        slide = ag.Prismatic(
            "drawer_slide",
            axis=-ag.Y,
            limits=(0.0, 0.86 * long),
            friction=friction,
            damping=3.0,
            effort=20.0,
            velocity=1.0,
        )
        return ag.weld(case, *printed).attach(drawer, slide)
