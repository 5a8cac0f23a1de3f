"""What moves in a washing machine: porthole door with its handle, drum, lid, basket and agitator."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import filled
from artgen.categories.washing_machine.case import LAP, SKIN, Plan, around_hole, panel_with
from artgen.nodes.fitting import Fitting

Rim = Literal["domed", "stepped", "glass", "solid"]
"""Front of the door: a domed ring, a ring with a step and a thin metal trim, a pane over the whole door,
or a closed cover."""

_GAP = 0.0030  # gap between the door's ring and the front panel [m]
_THICK = 0.028  # thickness of the ring [m]
_ASIDE = 0.014  # distance from the ring to the axis of the hinge [m]
_WALL = 0.005  # thickness of the glass bowl [m]
_LIP = 0.006  # thickness of the front wall of the drum [m]
_BELLOWS = 0.070  # depth of the bellows behind the front [m]
_PLAY = 0.004  # gap between the bellows and the drum [m]
_LEVER = (0.030, 0.096)  # width and height of the handle [m]
_MOTOR = feel.Feel(damping=0.02, friction=0.3, armature=0.02, effort=40.0, velocity=12.0)
_RUBBER = ag.material("rubber").with_(name="bellows", base_color=(0.20, 0.205, 0.21))
_DRUM = ag.material("stainless").with_(name="drum_steel", density=4200.0)
_HOLES = ag.material("perforated_steel").with_(name="drum_holes")
_SECTIONS: dict[Rim, list[tuple[float, float]]] = {
    # shares of the ring's width from its inner edge, and of its thickness from the back
    "domed": [(0, 0), (1, 0), (1, 0.45), (0.96, 0.68), (0.84, 0.88), (0.62, 1), (0.40, 0.95), (0, 0.4)],
    "stepped": [(0, 0), (1, 0), (1, 0.70), (0.66, 0.96), (0.58, 1), (0.30, 1), (0, 0.45)],
    "glass": [(0, 0), (1, 0), (1, 0.80), (0.985, 0.88), (0, 0.88)],
    "solid": [(0, 0), (1, 0), (1, 0.60), (0.97, 0.80), (0.90, 0.94), (0.78, 1), (0, 1)],
}


@dataclass(frozen=True)
class Porthole:
    """The door of a machine and the opening behind it."""

    plan: Plan
    radius: ag.Scalar  # of the door [m]
    rim: Rim
    lever: bool  # whether a hook holds the door until its handle is pulled
    ring: ag.Material
    accent: ag.Material  # handle and trim
    glass: ag.Material
    hole: ag.Scalar  # radius of the opening [m]
    bowl: ag.Scalar  # depth of the bowl behind the front [m]

    @property
    def face(self) -> ag.Scalar:
        """Position of the front panel along y [m]."""
        return self.plan.outside.y.low

    @property
    def _pivot(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Axis of the handle in x and y [m]."""
        return self.radius - 0.034, self.face - _GAP - _THICK + 0.007

    def panel(self, finish: ag.Material) -> ag.Body:
        """Make the front panel around the opening, the bellows and the fixed half of the hinge."""
        center, slots = self.plan.center, []
        x = self._pivot[0]
        if self.lever:
            slots = [ag.Region((x + 0.0048, x + 0.032), (0, 0), (center - 0.011, center + 0.011))]
        shade = ag.colored("polypropylene", "grey").with_(name="collar") if self.rim == "solid" else _RUBBER
        rh, end = self.hole, _BELLOWS
        waves = [(0.003, 0.0012 / end), (-0.003, 0.0022 / end), (-0.006, 0), (-0.007, -0.09), (-0.004, -0.3)]
        waves += [
            (-0.008, -0.42),
            (-0.003, -0.52),
            (-0.003, -0.72),
            (-0.010, -0.84),
            (-0.010, -1),
            (0.003, -1),
        ]
        outline = ag.polygon([(rh + out, in_ * end) for out, in_ in waves])
        collar = ag.revolve(outline, axis=-ag.Y).at(0, self.face, center)
        # under the smooth bellows is a band of few sides
        band = ag.regular_polygon(16, rh + 0.0042) - ag.regular_polygon(16, rh + 0.0024)
        sleeve = ag.extrude(band, end - 0.004, axis=ag.Y).at(0, self.face + end / 2, center)
        y = self.face - _GAP - _THICK / 2 - 0.002
        axis = -self.radius - _ASIDE
        foot = ag.Region((axis - 0.010, axis + 0.008), (y, self.face + LAP), (center - 0.031, center + 0.031))
        pin = ag.cylinder(0.0085, 0.062, bevel=0.001).at(axis, y, center)
        plate = ag.Region(
            (axis - 0.011, axis + 0.011),
            (self.face - 0.0016, self.face + LAP),
            (center - 0.048, center + 0.048),
        )
        return ag.weld(
            panel_with(self.plan.panel, rh, center, finish, slots),
            ag.part(sleeve, "seal", shade),
            ag.detail(collar, "seal", shade),
            ag.part([foot.box(bevel=0.002), pin], "hinge", filled(ag.material("zinc"), 4000.0)),
            ag.detail(plate.box(bevel=0.0006), "hinge", ag.material("zinc")),
        )

    def _ring(self) -> list[ag.Body]:
        """Make ring, window and bowl of the door."""
        at = (0, self.face - _GAP, self.plan.center)
        inner = 0.0 if self.rim == "solid" else self.hole - 0.030
        wide = self.radius - inner
        outline = ag.polygon([(inner + r * wide, y * _THICK) for r, y in _SECTIONS[self.rim]])
        ring = ag.revolve(outline, axis=-ag.Y).at(at)
        x, z = self._pivot[0], self.plan.center
        slot = ag.Region(
            (x + 0.004, x + 0.026), (at[1] - _THICK - 0.01, at[1] + 0.01), (z - 0.010, z + 0.010)
        ).box()
        stuff = filled(self.ring, 300.0 if self.rim == "solid" else 620.0, "ring")
        if self.rim == "solid":
            solid = ag.bounding_collider(ring)
            bodies = [ag.part(solid - slot if self.lever else solid, "door", stuff, name="door")]
        else:  # a core with few facets, which has colliders, inside the smooth ring
            core = [
                (inner + 0.004 + r * (wide - 0.005), 0.0005 + 0.97 * y * _THICK)
                for r, y in _SECTIONS[self.rim]
            ]
            solid = ag.revolve(ag.polygon(core), axis=-ag.Y, sides=20).at(at)
            bodies = [
                ag.part(solid - slot if self.lever else solid, "door", stuff, name="door"),
                ag.detail(ring - slot if self.lever else ring, "door", self.ring),
            ]
        front, rear, deep = self.hole - 0.027, self.hole - 0.054, self.bowl + _GAP
        shape = ag.revolve(
            ag.polygon(
                [(0, 0.002), (front + 0.004, 0.002), (rear + 0.008, 0.014 - deep), (rear, -deep), (0, -deep)]
            ),
            axis=-ag.Y,
        )
        lens = ag.bounding_collider(shape.at(at))
        if self.rim == "solid":
            plastic = ag.colored("polypropylene", "light_grey").with_(name="door_lining", density=180.0)
            bodies.append(ag.part(lens, "door", plastic))
        else:
            bodies.append(ag.part(lens, "glass", self.glass))
        if self.rim == "glass":
            pane = (
                ag.cylinder(self.radius - 0.004, 0.006, axis=ag.Y, bevel=0.0015).at(y=0.0025 - _THICK).at(at)
            )
            tint = ag.material("tinted_glass").with_(name="door_pane", opacity=0.55)
            pane = pane - slot if self.lever else pane
            bodies.append(ag.part(pane, "glass", tint))
        if self.rim == "stepped":
            major = inner + 0.60 * wide
            trim = ag.torus(major, 0.0036, axis=ag.Y).at(0, -0.96 * _THICK, 0).at(at)
            bodies.append(ag.detail(trim, "door", self.accent))
        lens = ag.torus(inner + 0.002, 0.003, axis=ag.Y).at(0, -0.28 * _THICK, 0).at(at)
        return (
            bodies
            if self.rim in ("solid", "glass")
            else [*bodies, ag.detail(lens, "door", ag.material("rubber"))]
        )

    def door(self, swing: ag.Scalar, pull: ag.Scalar) -> Fitting:
        """Make the door on its hinge, with a handle that frees its hook or a fixed one."""
        z, front = self.plan.center, self.face - _GAP - _THICK
        y, axis = front + _THICK / 2 - 0.002, -self.radius - _ASIDE
        arm = ag.Region((axis, -self.radius + 0.034), (y - 0.006, y + 0.007), (z + 0.0335, z + 0.0555))
        knuckle = ag.cylinder(0.0085, 0.022, bevel=0.001).at(axis, y, arm.z.mid)
        tabs = [arm.box(bevel=0.002), knuckle]
        tabs += [each.at(z=-0.089) for each in tabs]
        x, wide, high = self._pivot[0], *_LEVER
        lever = ag.Region(
            (x - 0.002, x - 0.002 + wide), (front - 0.0165, front - 0.0030), (z - high / 2, z + high / 2)
        )
        grip = ag.bounding_collider(
            details.relief(
                lever.front(radius=0.010), (0, lever.y.mid, 0), proud=0.00675, sunk=0.00675, bevel=0.003
            )
        )
        hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.0095)
        bodies = [*self._ring(), ag.part(tabs, "hinge", filled(ag.material("zinc"), 4000.0))]
        needs = None
        if self.lever:
            hook = ag.Region(
                (x + 0.006, x + 0.012), (lever.y.high - LAP, self.face + SKIN + 0.011), (z - 0.008, z + 0.008)
            )
            barb = hook.with_(x=(x + 0.0005, x + 0.007), y=(self.face + SKIN + 0.0025, hook.y.high)).shrink(
                z=LAP
            )
            strike = ag.part([hook.box(bevel=0.0008), barb.box(bevel=0.0008)], "latch", ag.material("zinc"))
            handle = ag.weld(ag.part(grip, "handle", self.accent, name="handle", grasp=hold), strike)
            turn = ag.Revolute(
                "handle_pull",
                axis=-ag.Z,
                pivot=(*self._pivot, z),
                limits=(0, 0.26),
                spring=ag.Spring(preload=0.20, force=0.45),
                feel=feel.LEVER,
                friction=0.02,
                effort=3.0,
            )
            needs = (turn > 0.18).until(0.034 / (x - axis))
            door = ag.weld(*bodies).attach(handle, turn)
        else:
            fixed = lever.grow(back=0.004)
            grip = ag.bounding_collider(
                details.relief(
                    fixed.front(radius=0.010), (0, fixed.y.mid, 0), proud=0.00875, sunk=0.00875, bevel=0.003
                )
            )
            door = ag.weld(*bodies, ag.part(grip, "handle", self.accent, grasp=hold))
        hinge = ag.Revolute(
            "door_hinge",
            axis=-ag.Z,
            pivot=(axis, y, z),
            limits=(0, swing),
            friction=pull * 2 * self.radius,
            damping=0.2,
            effort=30.0,
            velocity=5.0,
            needs=needs,
        )
        return Fitting.moving(door, hinge)

    def drum(
        self, radius: ag.Scalar, rear: ag.Scalar, friction: ag.Scalar, *, dryer: bool, paddles: int
    ) -> Fitting:
        """Make the drum, open at the front, with paddles: its shaft is along y."""
        low = self.face + _BELLOWS + _PLAY
        deep = rear - low
        mouth = self.hole - 0.008
        at = (0, low, self.plan.center)
        # polygons of few sides, which the bellows and a smooth band hide
        outer, inner = ag.regular_polygon(24, radius), ag.regular_polygon(24, radius - 0.003)
        shell = ag.extrude(outer - inner, deep, axis=ag.Y).at(y=deep / 2)
        front = ag.extrude(outer - ag.regular_polygon(24, mouth + 0.002), _LIP, axis=ag.Y).at(y=_LIP / 2)
        back = ag.extrude(ag.regular_polygon(24, radius - LAP), 0.005, axis=ag.Y).at(y=deep - 0.0025)
        stuff = _DRUM.with_(name="dryer_steel", base_color=(0.66, 0.66, 0.65)) if dryer else _DRUM
        half, tall = 0.038, 0.24 * radius
        outline = ag.polygon(
            [
                (-half, -radius + 0.004),
                (half, -radius + 0.004),
                (0.36 * half, tall - radius),
                (-0.36 * half, tall - radius),
            ],
            radius=0.008,
        )
        fin = ag.bounding_collider(ag.extrude(outline, deep - 0.03, axis=ag.Y, bevel=0.004)).at(y=deep / 2)
        fins = [fin.rotate(ag.Y, math.tau * (0.25 + turn / paddles)) for turn in range(paddles)]
        plastic = ag.colored("polypropylene", "light_grey").with_(name="paddle", density=300.0)
        bowl = ag.revolve(
            ag.polygon([(0, 0), (0.42 * radius, 0), (0.34 * radius, 0.012), (0, 0.018)]), axis=-ag.Y
        )
        star = [
            ag.box(0.05, 0.004, 1.7 * radius, bevel=0.0018).rotate(ag.Y, turn * math.pi / 3)
            for turn in range(3)
        ]
        bodies = [
            ag.part([shell, front, back], "drum", stuff, name="drum"),
            ag.part(fins, "paddle", plastic),
            ag.detail([bowl.at(y=deep - 0.005), *(each.at(y=deep - 0.0055) for each in star)], "drum", stuff),
        ]
        near = 0.9914 * (radius - 0.003)
        band = ag.tube(near + 0.001, near - 0.0004, deep - 0.016, axis=ag.Y).at(y=deep / 2)
        bodies.append(ag.detail(band, "drum", stuff if dryer else _HOLES))
        spin = ag.Revolute("drum_spin", axis=ag.Y, pivot=at, friction=friction, feel=_MOTOR, driven="a motor")
        return Fitting.moving(ag.weld(*bodies).at(at), spin)


@dataclass(frozen=True)
class TopLoader:
    """The upper part of a machine that loads from above: its deck, lid, basket and agitator."""

    case: ag.Region  # from the floor to the deck
    deck: float  # height of the deck [m]
    behind: ag.Scalar  # depth of the console behind the lid [m]
    finish: ag.Material
    metal: ag.Material
    glass: ag.Material | None  # window of the lid; None for a closed lid

    @property
    def opening(self) -> ag.Region:
        """Opening of the deck."""
        return self.case.shrink(x=0.060, front=0.050, back=self.behind + 0.055).with_(
            z=(self.case.z.high - self.deck, self.case.z.high)
        )

    @property
    def radius(self) -> ag.Scalar:
        """Radius of the basket [m]."""
        return ag.min_(self.case.x.size / 2 - 0.052, self.opening.y.size / 2 + 0.028)

    def top(self) -> ag.Body:
        """Make the deck around the opening, with the cover of the tub below it."""
        hole, case = self.opening, self.case.with_(z=self.opening.z)
        left, _, right = case.across(hole.x.low - case.x.low, None, case.x.high - hole.x.high)
        between = case.with_(x=hole.grow(x=LAP).x)
        front, _, rear = between.deep(hole.y.low - case.y.low, None, case.y.high - hole.y.high)
        boards = [each.box(bevel=0.003) for each in (left, right, front, rear)]
        outline = case.plan(radius=0.012) - hole.plan(radius=0.003)
        sheet = ag.extrude(outline, 0.004, bevel=0.0018).at(z=case.z.high - 0.0014)
        frame = hole.grow(x=0.03, y=0.03).at(0, -hole.y.mid, 0)
        plate = ag.Region(frame.x, (-0.003, 0.003), frame.y)
        ring = ag.rectangle(frame.x.size, frame.y.size) - ag.circle(self.radius - 0.022)
        covers = [each.rotate(ag.X, math.pi / 2) for each in around_hole(plate, self.radius - 0.022)]
        cover = ag.bounding_collider(ag.extrude(ring, 0.006), *covers)
        plastic = ag.colored("polypropylene", "light_grey").with_(name="tub_cover")
        return ag.weld(
            ag.part(boards, "body", filled(self.finish, 320.0, "deck")),
            ag.detail(sheet, "body", self.finish),
            ag.part(cover.at(0, hole.y.mid, hole.z.low - 0.0025), "tub_cover", plastic),
        )

    def lid(self, swing: ag.Scalar, friction: ag.Scalar, maker: str) -> Fitting:
        """Make the lid with its window and grip, hinged behind the opening."""
        z, hole = self.case.z.high, self.opening
        leaf = hole.shrink(x=0.003, y=0.003).with_(z=(z - 0.022, z + 0.002))
        pane = leaf.shrink(x=0.052, front=0.075, back=0.060)
        boards = [leaf.box(bevel=0.004)]
        if self.glass:
            left, _, right = leaf.across(0.052, None, 0.052)
            near, _, far = leaf.with_(x=pane.grow(x=LAP).x).deep(0.075, None, 0.060)
            boards = [each.box(bevel=0.002) for each in (left, right, near, far)]
        ridge = ag.Region.centered(0.17, 0.014, 0.022).at(0, leaf.y.low + 0.024, leaf.z.high + 0.010)
        grip = ridge.box(bevel=0.004)
        hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.Y, depth=0.0195)
        stuff = filled(self.finish, 330.0, "lid")
        bodies = [ag.part(boards, "lid", stuff, name="lid"), ag.part(grip, "handle", self.metal, grasp=hold)]
        if self.glass:
            window = pane.grow(0.004).with_(z=(leaf.z.mid, leaf.z.mid + 0.006)).box()
            rim = pane.plan() - pane.plan().offset(-0.004)
            bodies.append(ag.part(window, "glass", self.glass))
            bodies.append(ag.detail(ag.extrude(rim, 0.004).at(z=leaf.z.high - 0.009), "lid", self.metal))
        ink = controls.ink_on(self.finish)
        sign = details.logo(maker, 0.012)
        at = (0, leaf.y.low + 0.052, leaf.z.high)
        bodies.append(details.printed(sign, at, material=ink, facing=ag.Z, up=ag.Y))
        y = leaf.y.high
        hinge = ag.Revolute(
            "lid_hinge",
            axis=-ag.X,
            pivot=(0, y, leaf.z.high),
            limits=(0, swing),
            friction=friction,
            damping=1.2,
            effort=40.0,
            velocity=4.0,
        )
        pin = ag.cylinder(0.006, 0.05, axis=ag.X, bevel=0.001)
        side = 0.36 * leaf.x.size
        pins = [pin.at(way * side, y - 0.002, leaf.z.high) for way in (-1, 1)]
        return Fitting.moving(ag.weld(*bodies, ag.detail(pins, "hinge", ag.material("zinc"))), hinge)

    def basket(self, low: ag.Scalar, friction: ag.Scalar, *, agitator: bool) -> Fitting:
        """Make the basket about its upright shaft, with the agitator or a low impeller in it."""
        radius, high = self.radius, self.opening.z.low - 0.016
        deep, y = high - low, self.opening.y.mid
        outer, inner = ag.regular_polygon(24, radius), ag.regular_polygon(24, radius - 0.003)
        wall = ag.extrude(outer - inner, deep).at(z=low + deep / 2)
        floor = ag.extrude(ag.regular_polygon(24, radius - LAP), 0.006).at(z=low + 0.003)
        near = 0.9914 * (radius - 0.003)
        balance = ag.tube(near + 0.001, radius - 0.022, 0.052, bevel=0.006).at(z=high - 0.027)
        band = ag.tube(near + 0.001, near - 0.0004, 0.72 * deep).at(z=low + 0.44 * deep)
        white = ag.colored("polypropylene", "light_grey").with_(name="balance_ring")
        basket = ag.weld(
            ag.part([wall, floor], "drum", _DRUM, name="drum"),
            ag.detail(balance, "drum", white),
            ag.detail(band, "drum", _HOLES),
        )
        tall = 0.80 * deep if agitator else 0.055
        foot = low + 0.009
        skirt = (0.60 if agitator else 0.74) * radius
        color = ag.colored("polypropylene", "white" if agitator else "silver").with_(name="agitator_plastic")
        disc = ag.frustum(skirt, 0.6 * skirt, 0.034, bevel=0.006).at(z=foot + 0.017)
        solids = [disc]
        if agitator:
            solids.append(
                ag.frustum(0.075, 0.052, tall - 0.02, bevel=0.010).at(z=foot + 0.02 + (tall - 0.02) / 2)
            )
        vane_high = 0.30 * deep if agitator else 0.022
        vane = ag.hull(
            ag.box(0.62 * skirt, 0.012, 0.01, bevel=0.003).at(0.62 * skirt, 0, foot + 0.030),
            ag.box(0.25 * skirt, 0.010, 0.01, bevel=0.003).at(0.40 * skirt, 0, foot + 0.030 + vane_high),
        )
        vanes = 4 if agitator else 6
        solids += [vane.rotate(ag.Z, math.tau * turn / vanes) for turn in range(vanes)]
        post = ag.part(
            [ag.bounding_collider(each) for each in solids], "agitator", filled(color, 420.0), name="agitator"
        )
        bodies = [post]
        if agitator:
            flight = ag.sweep(ag.circle(0.010), ag.helix(0.062, 0.16, 1.6)).at(z=foot + 0.62 * tall)
            cap = ag.cylinder(0.050, 0.012, bevel=0.005).at(z=foot + tall + 0.004)
            bodies.append(ag.detail([flight, cap], "agitator", color))
        turn = ag.Revolute("agitator_turn", axis=ag.Z, friction=0.5 * friction, feel=_MOTOR, driven="a motor")
        spin = ag.Revolute("drum_spin", axis=ag.Z, friction=friction, feel=_MOTOR, driven="a motor")
        return Fitting.moving(basket.attach(ag.weld(*bodies), turn), spin).at(0, y, 0)
