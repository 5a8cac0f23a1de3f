"""The pop-up drain of a basin: a rod behind the spout lowers a plug, through a strap and a pivot rod.

The drain is in a slab whose upper face is z = `top`. The pivot rod turns about a ball in the rear of the
drain pipe. Its outer end is in the strap under the lift rod and rises with it; its inner end is in the eye of
the plug and moves down in proportion to the lengths of the arms.
"""

from dataclasses import dataclass

import artgen as ag
from artgen.categories.shared.finish import casting

ROD_TRAVEL = 0.028
"""Travel of the lift rod [m]."""

FLANGE = 0.032
"""Radius of the flange in the slab [m]."""

HOLE = 0.0395
"""Width of the square hole under the flange [m]."""

HANGS = 0.165
"""Length of the pipe below the top of the slab [m]."""

_PIPE = (0.0162, 0.0186)  # inner and outer radius of the 1 1/4 inch tailpiece [m]
_PLUG = 0.0205  # radius of the cap of the plug [m]
_SHUT = 0.0012  # gap between the shut cap and the seat [m]
_BALL = 0.022  # inner arm of the pivot rod: distance from the middle of the pipe to the ball [m]
_ARM = 0.095  # outer arm: distance from the ball to the strap [m]
_DOWN = 0.120  # depth of the ball below the top of the slab [m]
_ROD = 0.0030  # radius of the lift rod [m]
_PIVOT = 0.0020  # radius of the pivot rod [m]
_GUIDE = 0.012  # height of the collar that the lift rod passes [m]
_STANDS = 0.038  # height of the knob above the collar [m]
_PLAY = 0.0005  # gap around the lift rod [m]
_TILT = 0.5 * ROD_TRAVEL / _ARM  # tilt of the pivot rod at each end of its range [rad]


@dataclass(frozen=True)
class Drain:
    """A pop-up drain."""

    at: ag.Scalar  # middle of the drain along y [m]
    rod: ag.Scalar  # position of the lift rod along y [m]
    top: ag.Scalar  # height of the slab [m]
    thick: ag.Scalar  # thickness of the slab [m]
    finish: ag.Material  # metal of the drain
    friction: ag.Scalar  # friction of the ball and the collar, measured at the lift rod [N]

    def on(self, body: ag.Body) -> ag.Body:
        """Attach the drain, its plug and its rods to the body with the slab."""
        lift = self._lift()
        turn = ag.Revolute(
            "pivot_rod_turn",
            axis=ag.X,
            pivot=(0.0, self.at + _BALL, self.top - _DOWN),
            follows=(1.0 / _ARM) * lift,
            damping=0.002,
            armature=0.00005,
        )
        fall = ag.Prismatic(
            "plug_slide", axis=-ag.Z, follows=(_BALL / _ARM) * lift, damping=1.0, armature=0.01
        )
        body = ag.weld(body, self._guide(), self._pipe())
        return body.attach(self._lift_rod(), lift).attach(self._pivot_rod(), turn).attach(self._plug(), fall)

    def _lift(self) -> ag.Joint:
        return ag.Prismatic(
            "lift_rod_slide",
            axis=ag.Z,
            limits=(0.0, ROD_TRAVEL),
            friction=self.friction,
            damping=3.0,
            armature=0.02,
            effort=30.0,
        )

    def _guide(self) -> ag.Body:
        """Make the collar behind the spout."""
        inner, outer = (_ROD + _PLAY) / 0.966, 0.0082
        # a square collar within the round one collides: four boards
        wide, hole = 1.38 * outer, 2.0 * (_ROD + _PLAY)
        ring = ag.box(wide, wide, _GUIDE) - ag.box(hole, hole, 2.0 * _GUIDE)
        skin = ag.tube(outer, inner, _GUIDE + 0.0004, bevel=0.0008).at(0.0, 0.0, 0.5 * _GUIDE)
        place = ag.vector(0.0, self.rod, self.top)
        return ag.weld(
            ag.part(ring.at(0.0, 0.0, 0.5 * _GUIDE).at(place), "guide", casting(self.finish, 0.9)),
            ag.detail(skin.at(place), "guide", self.finish),
        )

    def _pipe(self) -> ag.Body:
        """Make the flange with its seat, the pipe with the opening for the pivot rod, and its nut."""
        inner, outer = _PIPE
        place = ag.vector(0.0, self.at, self.top)
        rim = [(inner, -0.0004), (FLANGE, -0.0004), (FLANGE - 0.0006, 0.0014), (0.0262, 0.0030)]
        seat = [(0.0232, 0.0026), (0.0222, 0.0008), (inner, 0.0004)]
        flange = ag.revolve(ag.polygon([*rim, *seat]))
        flat = ag.box(0.0430, 0.0430, 0.0007) - ag.box(0.0240, 0.0240, 0.01)
        # a square pipe within the round one collides: four boards
        pipe = ag.box(0.0260, 0.0260, HANGS) - ag.box(0.0236, 0.0236, HANGS + 0.01)
        window = ag.Region((-0.0055, 0.0055), (0.010, 0.030), (-_DOWN - 0.0055, -_DOWN + 0.0055)).box()
        pipe = pipe.at(0.0, 0.0, -0.5 * HANGS) - window
        skin = ag.tube(outer, inner - 0.0006, HANGS).at(0.0, 0.0, -0.5 * HANGS) - window
        collar = ag.tube(outer + 0.0055, outer - 0.0004, 0.012, bevel=0.001).at(0.0, 0.0, -self.thick - 0.008)
        half, near, far = 0.0052, outer - 0.0004, 0.0300
        frame = (
            ag.Region((-0.0080, 0.0080), (0.0125, far), (-_DOWN - 0.0080, -_DOWN + 0.0080)).box()
            - ag.Region((-half, half), (0.010, far + 0.01), (-_DOWN - half, -_DOWN + half)).box()
        )
        nut = ag.tube(0.0118, 0.0055, far - near + 0.0004, axis=ag.Y, bevel=0.001)
        metal = casting(self.finish, 0.9)
        return ag.weld(
            ag.part(flat.at(place), "drain", metal),
            ag.part(pipe.at(place), "drain", metal),
            ag.part(frame.at(place), "drain", metal),
            ag.detail(flange.at(place), "drain", self.finish),
            ag.detail(skin.at(place), "drain", self.finish),
            ag.detail(collar.at(place), "drain", ag.material("black_abs")),
            ag.detail(nut.at(0.0, 0.5 * (near + far), -_DOWN).at(place), "drain", self.finish),
        )

    def _plug(self) -> ag.Body:
        """Make the open plug: its cap, and a stem with an eye for the pivot rod."""
        rise = ROD_TRAVEL * _BALL / _ARM
        low = _SHUT + 0.0008 + rise
        core = ag.extrude(ag.regular_polygon(16, _PLUG - 0.0004), 0.0026).at(0.0, 0.0, low + 0.0015)
        rim = ag.cylinder(_PLUG, 0.0030, bevel=0.0009).at(0.0, 0.0, low + 0.0015)
        cap = ag.dome(_PLUG - 0.0012, height=0.0022).at(0.0, 0.0, low + 0.0026)
        eye = -_DOWN + 0.5 * rise
        stem = ag.cylinder_between((0.0, 0.0, eye + 0.0048), (0.0, 0.0, low + 0.0010), 0.0040)
        sides = [
            ag.Region(
                (side * 0.0040 - 0.0008, side * 0.0040 + 0.0008),
                (-0.0025, 0.0025),
                (eye - 0.0064, eye + 0.0064),
            ).box()
            for side in (-1, 1)
        ]
        bars = [
            ag.Region(
                (-0.0042, 0.0042),
                (-0.0024, 0.0024),
                (eye + way * 0.0048 - 0.0015, eye + way * 0.0048 + 0.0015),
            ).box()
            for way in (-1, 1)
        ]
        seal = ag.tube(_PLUG - 0.0030, _PLUG - 0.0055, 0.0012).at(0.0, 0.0, low - 0.0004)
        place = ag.vector(0.0, self.at, self.top)
        metal = casting(self.finish, 0.9)
        return ag.weld(
            ag.part(core.at(place), "plug", metal, name="plug"),
            ag.part(ag.union(stem, *sides, *bars).at(place), "plug", metal),
            ag.detail(ag.union(rim, cap).at(place), "plug", self.finish),
            ag.detail(seal.at(place), "plug", ag.material("rubber")),
        )

    def _pivot_rod(self) -> ag.Body:
        """Make the rod through the ball, with its outer end down: the plug is open."""
        rod = ag.cylinder_between((0.0, -_BALL - 0.006, 0.0), (0.0, _ARM + 0.014, 0.0), _PIVOT)
        ball = ag.sphere(0.0046)
        place = ag.vector(0.0, self.at + _BALL, self.top - _DOWN)
        steel = ag.material("stainless")
        return ag.weld(
            ag.part(rod.rotate(ag.X, -_TILT).at(place), "pivot_rod", steel, name="pivot_rod"),
            ag.detail(ball.at(place), "pivot_rod", ag.material("abs")),
        )

    def _lift_rod(self) -> ag.Body:
        """Make the rod with its knob, and the bent strap that a thumbscrew clamps to its lower end."""
        at, top = self.rod, self.top
        high = top + _GUIDE + _STANDS
        under = top - self.thick - ROD_TRAVEL - 0.006  # height of the upper end of the strap
        rod = ag.cylinder_between((0.0, at, under - 0.020), (0.0, at, high), _ROD)
        knob: ag.Solid = ag.sphere(0.0068).at(0.0, at, high)
        metal = casting(self.finish, 0.9)
        held = ag.part(
            ag.union(rod, knob), "lift_rod", metal, grasp=ag.grasp_on(knob, approach=-ag.Y, closing=ag.X)
        )
        hole = self.at + _BALL + _ARM
        eye = top - _DOWN - 0.5 * ROD_TRAVEL
        thin, wide = 0.0008, 0.0050
        upper = ag.Region(
            (-wide, wide), (at - 0.0044, at - 0.0044 + 2.0 * thin), (under - 0.022, under)
        ).box()
        lower = (
            ag.Region((-wide, wide), (hole - thin, hole + thin), (eye - 0.012, eye + 0.010)).box()
            - ag.Region((-0.0032, 0.0032), (hole - 0.01, hole + 0.01), (eye - 0.0032, eye + 0.0032)).box()
        )
        run = ag.hull(
            ag.Region(
                (-wide, wide), (at - 0.0044, at - 0.0044 + 2.0 * thin), (under - 0.0218, under - 0.0205)
            ).box(),
            ag.Region((-wide, wide), (hole - thin, hole + thin), (eye + 0.0085, eye + 0.0098)).box(),
        )
        screw = ag.cylinder_between(
            (0.0, at - 0.013, under - 0.012), (0.0, at + 0.006, under - 0.012), 0.0045
        )
        steel = ag.material("stainless")
        return ag.weld(
            held,
            *(ag.part(each, "strap", steel) for each in (upper, run, lower)),
            ag.part(screw, "strap", steel),
        )
