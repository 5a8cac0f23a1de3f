"""What moves in a washing machine: porthole door with its handle, drum, lid, basket and agitator."""

import math
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.appliances import filled
from artgen.categories.washing_machine.case import GREY, LAP, SKIN, ZINC
from artgen.nodes.fitting import Fitting

Rim = Literal["domed", "stepped", "glass", "solid"]
"""Front of the door: a domed ring, a ring with a step and a thin metal trim, a pane over the whole door,
or a closed cover."""

BEHIND = 0.165
"""Depth of the console behind a lid [m]."""

_GAP = 0.0030  # gap between the door's ring and the front panel [m]
_THICK = 0.028  # thickness of the ring [m]
_LIP = 0.006  # thickness of the front wall of the drum [m]
_BELLOWS = 0.070  # depth of the bellows behind the front [m]
_MOTOR = feel.Feel(damping=0.02, friction=0.3, armature=0.02, effort=40.0, velocity=12.0)
_ROUND = (0.0, math.tau)  # a turn of a dial [rad]
_PULL = feel.Feel(damping=0.02, friction=0.02, armature=2e-4, effort=3.0, velocity=8.0)
_DOOR = feel.Feel(damping=0.2, effort=30.0, velocity=5.0)
_LID = feel.Feel(damping=1.2, effort=40.0, velocity=4.0)
_RUBBER = ag.material("rubber").with_(name="bellows", base_color=(0.20, 0.205, 0.21))
_DRUM = ag.material("stainless").with_(name="drum_steel", density=4200.0)
_HOLES = ag.material("perforated_steel").with_(name="drum_holes")
_STEEL = filled(ZINC, 4000.0)
_SIDES = 18  # of drums: smooth bands and the bellows hide their edges
_NEAR = math.cos(math.pi / _SIDES)  # distance of their sides from the axis over the radius
# shares of the ring's width from its inner edge, and of its thickness from the back
_SECTIONS: dict[Rim, list[tuple[float, float]]] = {
    "domed": [(0, 0), (1, 0), (1, 0.45), (0.96, 0.68), (0.84, 0.88), (0.62, 1), (0.40, 0.95), (0, 0.4)],
    "stepped": [(0, 0), (1, 0), (1, 0.70), (0.66, 0.96), (0.58, 1), (0.30, 1), (0, 0.45)],
    "glass": [(0, 0), (1, 0), (1, 0.80), (0.985, 0.88), (0, 0.88)],
    "solid": [(0, 0), (1, 0), (1, 0.60), (0.97, 0.80), (0.90, 0.94), (0.78, 1), (0, 1)],
}
# the bellows from its lip in front of the panel: distance from the opening [m], depth over the whole depth
_WAVES = [(0.003, 0.004), (0.005, 0.004), (0.005, 0.017), (-0.003, 0.031), (-0.006, 0), (-0.007, -0.09),
          (-0.004, -0.3), (-0.008, -0.42), (-0.003, -0.52), (-0.003, -0.72), (-0.010, -0.84), (-0.010, -1),
          (0.003, -1)]  # fmt: skip


def _drum(radius: ag.Scalar, deep: ag.Scalar, stuff: ag.Material, band: ag.Material) -> ag.Body:
    """Make the wall and the floor of a drum about z from z = 0 up, and the smooth band in it."""
    near = _NEAR * (radius - 0.003)
    ring = ag.regular_polygon(_SIDES, radius) - ag.regular_polygon(_SIDES, radius - 0.003)
    floor = ag.extrude(ag.regular_polygon(_SIDES, radius - LAP), 0.006).at(z=0.003)
    smooth = ag.tube(near + 0.001, near - 0.0004, deep - 0.016).at(z=deep / 2)
    wall = ag.part([ag.extrude(ring, deep).at(z=deep / 2), floor], "drum", stuff, name="drum")
    return ag.weld(wall, ag.detail(smooth, "drum", band))


def _spin(name: str, axis: ag.Vector, friction: ag.Scalar) -> ag.Joint:
    return ag.Revolute(name, axis=axis, friction=friction, feel=_MOTOR, driven="a motor")


def washing(body: ag.Body, door: str, buttons: int, dials: int, *, dryer: bool) -> ag.Body:
    """Let the last key start the drum, which stands behind an open door; the third one spins it fast."""
    keys = [signals.pressed(f"button_slide_{number}") for number in range(buttons)]
    runs = signals.toggle(keys[-1], unless=signals.pressed(door, (0.0, 0.06)))
    hot = signals.toggle(keys[1]) if buttons > 2 else None
    heats = runs if dryer or hot is None else runs & hot
    speed = 0.35 * runs
    if buttons > 3 and not dryer:
        speed |= runs & signals.toggle(keys[2])
    body = body.output("drum", speed, kind="motor", moves="drum_spin", speed=_MOTOR.velocity)
    body = body.output("heat", heats, kind="heat")
    beep = controls.any_pressed(f"button_slide_{number}" for number in range(buttons))
    body = body.output("beep", beep, kind="sound")
    for name in [f"dial_turn_{number}" for number in range(dials)] if dials > 1 else ["dial_turn"] * dials:
        body = body.output(name.replace("dial_turn", "program"), signals.level(name, _ROUND), kind="display")
    return body


class Porthole:
    """A door with its handle, and the opening behind it, about its middle in the face y = 0."""

    def __init__(
        self, radius: ag.Scalar, rim: Rim, ring: ag.Material, accent: ag.Material, *, lever: bool
    ) -> None:
        self.radius, self.rim, self.ring, self.accent, self.lever = radius, rim, ring, accent, lever
        self.hole = radius - 0.042
        self.front = -_GAP - _THICK  # of the door
        self.pivot = ag.vector(radius - 0.034, self.front + 0.007)  # of the handle
        self.axle = ag.vector(-radius - 0.014, self.front + _THICK / 2 - 0.002)

    def panel(self, place: ag.Region, finish: ag.Material) -> ag.Body:
        """Make the front panel around the opening, the bellows and the fixed half of the hinge."""
        x, half = self.axle.x, SKIN / 2
        # the bellows hides the edges of the hole
        outline = place.front(radius=0.002) - ag.regular_polygon(12, self.hole + 0.002)
        plate = details.relief(outline, (0, half, 0), proud=half, sunk=half, bevel=0.0014)
        if self.lever:
            plate = plate - ag.box(0.0272, 0.1, 0.022).at(self.pivot.x + 0.0184)
        shade = GREY.with_(name="collar", base_color=(0.33, 0.33, 0.33)) if self.rim == "solid" else _RUBBER
        bellows = ag.revolve(ag.polygon([(self.hole + out, y * _BELLOWS) for out, y in _WAVES]), axis=-ag.Y)
        # behind the smooth bellows is a band of few sides
        band = vessels.around(self.hole - 0.0007, 8) - vessels.around(self.hole - 0.0025, 8)
        sleeve = ag.extrude(band, _BELLOWS - 0.004, axis=ag.Y).at(y=_BELLOWS / 2)
        foot = ag.Region((x - 0.010, x + 0.008), (self.axle.y, LAP), (-0.031, 0.031))
        mount = ag.box(0.022, 0.0021, 0.096, bevel=0.0006).at(x, -0.00055)
        pin = ag.cylinder(0.0085, 0.062).at(self.axle)
        return ag.weld(
            ag.part(plate, "front", filled(finish, 1150.0, "front")),
            ag.part(sleeve, "seal", shade),
            ag.detail(bellows, "seal", shade),
            ag.part([foot.box(bevel=0.002), pin], "hinge", _STEEL),
            ag.detail(mount, "hinge", ZINC),
        )

    def _ring(self, glass: ag.Material, bowl: ag.Scalar) -> list[ag.Body]:
        """Make ring, window and bowl of the door."""
        solid, inner = self.rim == "solid", 0.0 if self.rim == "solid" else self.hole - 0.030
        slot = ag.box(0.022, 0.1, 0.020).at(self.pivot.x + 0.015)

        def turned(start: ag.Scalar, less: float, sides: int = 0) -> ag.Solid:
            wide, thick = self.radius - less - start, _THICK - 2 * less
            outline = [(start + r * wide, less / 2 + thick * y) for r, y in _SECTIONS[self.rim]]
            made = ag.revolve(ag.polygon(outline), axis=-ag.Y, sides=sides).at(y=-_GAP)
            if solid:  # one collider for each step of its section
                rings = [(vessels.around(r), _GAP + y) for r, y in outline[1:-1]]
                steps = (ag.loft([a, b], [low, high], axis=-ag.Y) for (a, low), (b, high) in pairwise(rings))
                made = ag.bounding_collider(made, *steps)
            return made - slot if self.lever else made

        # a core with few facets, which has colliders, is inside the smooth ring
        core = turned(0.0 if solid else inner + 0.004, 0.001, 20)
        rear = self.hole - 0.050
        shape = [(0, 0.005), (self.hole - 0.023, 0.005), (rear, -bowl), (0, -bowl)]
        cover = ag.loft([vessels.around(rear), vessels.around(self.hole - 0.023)], [-bowl, 0.005], axis=-ag.Y)
        inside = ag.bounding_collider(ag.revolve(ag.polygon(shape), axis=-ag.Y), cover)
        lining = GREY.with_(name="door_lining", density=180.0)
        bodies = [
            ag.part(core, "door", filled(self.ring, 300.0 if solid else 620.0, "ring"), name="door"),
            ag.detail(turned(inner, 0.0), "door", self.ring),
            ag.part(inside, "door" if solid else "glass", lining if solid else glass),
        ]
        if self.rim == "glass":
            pane = ag.cylinder(self.radius - 0.004, 0.006, axis=ag.Y).at(y=0.0025 + self.front)
            tint = ag.material("tinted_glass").with_(name="door_pane", opacity=0.55)
            bodies.append(ag.part(pane - slot if self.lever else pane, "glass", tint))
        elif not solid:
            seam = ag.torus(inner + 0.002, 0.003, axis=ag.Y).at(y=-_GAP - 0.28 * _THICK)
            bodies.append(ag.detail(seam, "door", ag.material("rubber")))
        if self.rim == "stepped":
            trim = ag.torus(0.4 * inner + 0.6 * self.radius, 0.0036, axis=ag.Y)
            bodies.append(ag.detail(trim.at(y=-_GAP - 0.96 * _THICK), "door", self.accent))
        return bodies

    def door(self, glass: ag.Material, bowl: ag.Scalar, swing: ag.Scalar, pull: ag.Scalar) -> Fitting:
        """Make the door with a glass bowl on its hinge, and a handle that frees its hook or a fixed one."""
        axle, x, needs = self.axle, self.pivot.x, None
        arm = ag.Region((axle.x, 0.034 - self.radius), (axle.y - 0.006, axle.y + 0.007), (-0.011, 0.011))
        tab = ag.union(arm.box(bevel=0.002), ag.cylinder(0.0085, 0.022).at(axle))
        tabs = ag.part([tab.at(z=-0.0445), tab.at(z=0.0445)], "hinge", _STEEL)
        end = self.front + (-0.003 if self.lever else 0.001)
        handle = ag.Region((x - 0.002, x + 0.028), (self.front - 0.0165, end), (-0.048, 0.048))
        bar = ag.extrude(handle.front(radius=0.010), handle.y.size, axis=ag.Y, bevel=0.003)
        grip = ag.bounding_collider(bar.at(y=handle.y.mid))
        hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.0095)
        door = ag.weld(*self._ring(glass, bowl), tabs)
        lever = ag.part(grip, "handle", self.accent, name="handle", grasp=hold)
        if self.lever:
            hook = ag.Region((x + 0.006, x + 0.012), (end - LAP, SKIN + 0.011), (-0.008, 0.008))
            barb = hook.shrink(z=LAP).with_(x=(x + 0.0005, x + 0.007), y=(SKIN + 0.0025, hook.y.high))
            strike = ag.part([hook.box(bevel=0.0008), barb.box(bevel=0.0008)], "latch", ZINC)
            spring = ag.Spring(preload=0.20, force=0.45)
            turn = ag.Revolute(
                "handle_pull", axis=-ag.Z, pivot=self.pivot, limits=(0, 0.26), spring=spring, feel=_PULL
            )
            needs = (turn > 0.18).until(0.034 / (x - axle.x))
            door = door.attach(ag.weld(lever, strike), turn)
        else:
            door = ag.weld(door, lever)
        torque = pull * 2 * self.radius
        hinge = ag.Revolute(
            "door_hinge", axis=-ag.Z, pivot=axle, limits=(0, swing), feel=_DOOR, friction=torque, needs=needs
        )
        return Fitting.moving(door, hinge)

    def drum(
        self, radius: ag.Scalar, rear: ag.Scalar, friction: ag.Scalar, *, dryer: bool, paddles: int
    ) -> Fitting:
        """Make the drum, open at the front, with paddles: its shaft is along y."""
        low = _BELLOWS + 0.004
        deep, half, tall = rear - low, 0.038, 0.24 * radius
        lip = ag.regular_polygon(_SIDES, radius) - vessels.around(self.hole - 0.0090, 8)
        stuff = _DRUM.with_(name="dryer_steel", base_color=(0.66, 0.66, 0.65)) if dryer else _DRUM
        outline = [(-half, 0.004), (half, 0.004), (0.36 * half, tall), (-0.36 * half, tall)]
        fin = ag.extrude(ag.polygon(outline, radius=0.008).at(0, -radius), deep - 0.03, axis=ag.Y)
        fin = ag.bounding_collider(fin).at(y=deep / 2)
        fins = [fin.rotate(ag.Y, math.tau * (0.25 + turn / paddles)) for turn in range(paddles)]
        cone = ag.polygon([(0, 0), (0.42 * radius, 0), (0.34 * radius, 0.012), (0, 0.018)])
        bar = ag.box(0.05, 0.004, 1.7 * radius, bevel=0.0018).at(y=deep - 0.0065)
        star = [ag.revolve(cone, axis=-ag.Y).at(y=deep - 0.006)]
        star += [bar.rotate(ag.Y, turn * math.pi / 3) for turn in range(3)]
        drum = _drum(radius, deep, stuff, stuff if dryer else _HOLES)
        body = ag.weld(
            drum.rotate(ag.X, math.pi / 2).at(y=deep),
            ag.part(ag.extrude(lip, _LIP, axis=ag.Y).at(y=_LIP / 2), "drum", stuff),
            ag.part(fins, "paddle", GREY.with_(name="paddle", density=300.0)),
            ag.detail(star, "drum", stuff),
        )
        return Fitting.moving(body, _spin("drum_spin", ag.Y, friction)).at(y=low)


class TopLoader:
    """The upper part of a machine that loads from above, in the case from the floor to its deck."""

    def __init__(
        self, case: ag.Region, finish: ag.Material, metal: ag.Material, glass: ag.Material | None
    ) -> None:
        self.case, self.finish, self.metal, self.glass = case, finish, metal, glass
        hole = case.shrink(x=0.060, front=0.050, back=BEHIND + 0.055)
        self.opening = hole.with_(z=(case.z.high - 0.050, case.z.high))
        self.radius = ag.min_(case.x.size / 2 - 0.052, hole.y.size / 2 + 0.028)  # of the basket

    def top(self) -> ag.Body:
        """Make the deck around the opening, with the cover of the tub below it."""
        hole, case = self.opening, self.case.with_(z=self.opening.z)
        left, _, right = case.across(hole.x.low - case.x.low, None, case.x.high - hole.x.high)
        between = case.with_(x=hole.grow(x=LAP).x)
        front, _, rear = between.deep(hole.y.low - case.y.low, None, case.y.high - hole.y.high)
        boards = [each.box() for each in (left, right, front, rear)]
        sheet = ag.extrude(case.plan(radius=0.012) - hole.plan(radius=0.003), 0.004, bevel=0.0018)
        plate = ag.rectangle(hole.x.size + 0.06, hole.y.size + 0.06)
        cover = ag.extrude(plate - ag.regular_polygon(32, self.radius - 0.022), 0.006)
        return ag.weld(
            ag.part(boards, "body", filled(self.finish, 320.0, "deck")),
            ag.detail(sheet.at(z=case.z.high - 0.0014), "body", self.finish),
            ag.part(cover.at(0, hole.y.mid, hole.z.low - 0.0025), "tub_cover", GREY.with_(name="tub_cover")),
        )

    def lid(self, swing: ag.Scalar, friction: ag.Scalar, maker: str) -> Fitting:
        """Make the lid with its window and grip, hinged behind the opening."""
        z, hole = self.case.z.high, self.opening
        leaf = hole.shrink(x=0.003, y=0.003).with_(z=(z - 0.022, z + 0.002))
        pane = leaf.shrink(x=0.052, front=0.075, back=0.060)
        left, _, right = leaf.across(0.052, None, 0.052)
        near, _, far = leaf.with_(x=pane.grow(x=LAP).x).deep(0.075, None, 0.060)
        boards = [each.box(bevel=0.002) for each in (left, right, near, far)]
        stuff = filled(self.finish, 330.0, "lid")
        grip = ag.box(0.17, 0.014, 0.022, bevel=0.004).at(0, leaf.y.low + 0.024, leaf.z.high + 0.010)
        hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.Y, depth=0.0195)
        window = pane.grow(0.004).with_(z=(leaf.z.mid, leaf.z.mid + (0.006 if self.glass else 0.010))).box()
        rim = ag.extrude(pane.plan() - pane.plan().offset(-0.004), 0.004).at(z=leaf.z.high - 0.009)
        bodies = [
            ag.part(boards, "lid", stuff, name="lid"),
            ag.part(grip, "handle", self.metal, grasp=hold),
            ag.part(window, "glass" if self.glass else "lid", self.glass or stuff),
        ]
        if self.glass:
            bodies.append(ag.detail(rim, "lid", self.metal))
        at, ink = (0, leaf.y.low + 0.052, leaf.z.high), controls.ink_on(self.finish)
        bodies.append(details.printed(details.logo(maker, 0.012), at, material=ink, facing=ag.Z, up=ag.Y))
        at = (0, leaf.y.high, leaf.z.high)
        hinge = ag.Revolute(
            "lid_hinge", axis=-ag.X, pivot=at, limits=(0, swing), feel=_LID, friction=friction
        )
        pin = ag.cylinder(0.006, 0.05, axis=ag.X, bevel=0.001).at(0, leaf.y.high - 0.002, leaf.z.high)
        pins = [pin.at(way * 0.36 * leaf.x.size) for way in (-1, 1)]
        return Fitting.moving(ag.weld(*bodies, ag.detail(pins, "hinge", ZINC)), hinge)

    def basket(self, low: ag.Scalar, friction: ag.Scalar, *, agitator: bool) -> Fitting:
        """Make the basket about its upright shaft, with the agitator or a low impeller in it."""
        radius, deep = self.radius, self.opening.z.low - 0.016 - low
        ring = ag.tube(_NEAR * (radius - 0.003) + 0.001, radius - 0.022, 0.052, bevel=0.006)
        balance = ag.detail(ring.at(z=deep - 0.027), "drum", GREY.with_(name="balance_ring"))
        basket = ag.weld(_drum(radius, deep, _DRUM, _HOLES), balance)
        tall, skirt, vanes = (0.80 * deep, 0.60 * radius, 4) if agitator else (0.055, 0.74 * radius, 6)
        color = ag.colored("polypropylene", "white" if agitator else "silver").with_(name="agitator_plastic")
        rise = 0.30 * deep if agitator else 0.022
        vane = ag.hull(
            ag.box(0.62 * skirt, 0.012, 0.01, bevel=0.003).at(0.62 * skirt, 0, 0.009 + 0.030),
            ag.box(0.25 * skirt, 0.010, 0.01, bevel=0.003).at(0.40 * skirt, 0, 0.009 + 0.030 + rise),
        )
        solids = [ag.frustum(skirt, 0.6 * skirt, 0.034, bevel=0.006).at(z=0.009 + 0.017)]
        solids += [vane.rotate(ag.Z, math.tau * turn / vanes) for turn in range(vanes)]
        seen = []
        if agitator:
            solids.append(ag.frustum(0.075, 0.052, tall - 0.02, bevel=0.010).at(z=0.009 + tall / 2 + 0.01))
            flight = ag.sweep(ag.circle(0.010), ag.helix(0.062, 0.16, 1.6)).at(z=0.009 + 0.62 * tall)
            cap = ag.cylinder(0.050, 0.012, bevel=0.005).at(z=0.009 + tall + 0.004)
            seen = [ag.detail([flight, cap], "agitator", color)]
        covers = [ag.bounding_collider(each) for each in solids]
        stirrer = ag.weld(ag.part(covers, "agitator", filled(color, 420.0), name="agitator"), *seen)
        basket = basket.attach(stirrer, _spin("agitator_turn", ag.Z, 0.5 * friction))
        return Fitting.moving(basket, _spin("drum_spin", ag.Z, friction)).at(0, self.opening.y.mid, low)
