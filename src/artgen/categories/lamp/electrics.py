"""Switches of lamps: buttons, rockers, dials and pull chains; and the cord."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared.appliances import CORD, strain_relief
from artgen.categories.shared.controls import button_cap, button_hole, button_press, control_knob
from artgen.nodes.fitting import FIT, Fitting

SwitchKind = Literal["button", "rocker", "dial"]  # a finger presses or turns it

CASE = (0.034, 0.080, 0.024)  # width, length and height of a case on the cord [m]

_ROCK = 0.25  # tilt of a rocker to each side [rad]
_BUTTON = 0.017  # width of a button [m]
_ROCKER = (0.012, 0.021)  # width and length of a rocker [m]
_TAIL = 0.21  # length of the cord behind its switch [m]
_ALONE = 0.15  # additional length of a cord without a switch [m]
_JOINED = "its cord, which is only seen, joins it to the base"
# distance from the middle of a switch to its front and back edges [m]
HALF = {"button": _BUTTON / 2 + 0.0045, "rocker": (_ROCKER[1] + 0.007) / 2, "dial": 0.0165}

_BALLS = 26  # number of visible balls of a chain
_BALL = 0.0016  # radius of a ball: chains of lamps have balls of 3.2 mm [m]
_CORE = 0.0015  # radius of the rod that collides for the chain [m]
_KNOB = (0.0052, 0.016)  # radius and height of the knob of a chain [m]
_SPOUT = 0.0064  # outer radius of the spout of a switch [m]
_BORE = 0.0042  # radius of the bore of the spout [m]
_IN_SPOUT = 0.012  # length of the pulled chain inside the spout [m]
_OUT = 0.046  # distance of the chain from the axis: a finger closes between it and the pole [m]
_BELOW = 0.052  # depth of the middle of the knob below the shade, for a hand past the rim [m]
_OUTSIDE = 0.014  # least free length of the chain under the spout, so that the knob stays outside [m]
_PULLED_INTO = (
    "a pull chain would be pulled into the part under it: raise height, or lower "
    "chain_travel, shade_radius, shade_height or body_radius"
)
BESIDE = _OUT - _KNOB[0]  # distance from the axis that a lamp may reach without being under its chain [m]
# the contact spring snaps over the middle: about 2.5 N at the end
_SNAP = feel.Feel(friction=0.02, damping=0.002, armature=0.00001, effort=0.15)
# with the inertia of the ratchet of the switch
_CHAIN = feel.Feel(damping=2.0, friction=0.2, armature=0.02, effort=20.0)


def switch(kind: SwitchKind, finish: ag.Material, ink: ag.Material, *, on: str) -> Fitting:
    """Make a switch in an upward-facing face: the link `button`, `rocker` or `dial` with its joint."""
    ag.require(on != "socket", "a switch in the socket has a chain: switch must be pull_chain")
    if kind == "rocker":
        return _rocker(finish, ink)
    if kind == "button":
        cap = button_cap(finish=finish, width=_BUTTON, proud=0.0042, deep=0.006, icon="power", ink=ink)
        press = button_press("switch_slide", travel=0.003, preload=1.0, force=4.0)  # keys of lamps: 4 N
        sheet = ag.circle(HALF["button"]) - ag.circle(_BUTTON / 2 + FIT.sliding)
        ring = ag.extrude(sheet, 0.0014, axis=ag.Y, bevel=0.0004).at(y=-0.0002)
        hole = button_hole(_BUTTON, through=0.0105)
        fitting = Fitting.moving(cap, press, fixed=ag.detail(ring, "switch", finish), cut=hole)
    else:
        knob = control_knob(
            finish=finish, style="fluted", radius=0.014, depth=0.017, mark=ink, name="dial", label="dial"
        )
        # friction of the wiper of a dimmer without stops
        turn = ag.Revolute(
            "switch_turn", axis=ag.Y, friction=0.03, damping=0.002, armature=0.00002, effort=0.5
        )
        plate = ag.cylinder(HALF["dial"], 0.0010, axis=ag.Y).at(y=0.0003)
        fitting = Fitting.moving(knob, turn, fixed=ag.detail(plate, "switch", finish))
    return fitting.rotate(ag.X, -math.pi / 2)


def lit(
    body: ag.Body,
    kind: SwitchKind | Literal["pull_chain"],
    bulb: ag.Material,
    cloth: ag.Material | None = None,
) -> ag.Body:
    """Let the switch of a lamp light its bulb, and a shade of cloth around it; a dial dims them."""
    chained = "only a lamp with a shade on a harp has a pull chain: switch must be button, rocker or dial"
    ag.require(kind != "pull_chain" or cloth is not None, chained)
    if kind == "dial":
        on = signals.level("switch_turn", (0.0, 4.7))
    elif kind == "rocker":
        on = signals.pressed("switch_rock", (-_ROCK, _ROCK))
    else:
        on = signals.toggle(signals.pressed("switch_slide" if kind == "button" else "switch_pull"))
    body = body.output("light", on, kind="light", material=bulb)
    if cloth is None or not cloth.name.startswith(("fabric", "linen", "wicker")):
        return body
    red, green, blue = cloth.base_color
    return body.output(
        "shade", on, kind="light", material=cloth, color=(0.62 * red, 0.5 * green, 0.34 * blue)
    )


def _rocker(finish: ag.Material, ink: ag.Material) -> Fitting:
    wide, long = _ROCKER
    half, edge, middle = long / 2, 0.0054, 0.0038
    # seen from the side it is a flat V; the pivot is in the face
    side = ag.polygon([(-half, -0.0015), (half, -0.0015), (half, edge), (0, middle), (-half, edge)])
    share = 0.85  # position of the finger, as a share of the distance to the end
    height = middle + share * (edge - middle)
    pushes = [ag.frame((0, y, height), approach=-ag.Z, closing=ag.X) for y in (-share * half, share * half)]
    belly = ag.cylinder(0.0040, 0.7 * wide, axis=ag.X).at(z=-0.0015)
    solids = [ag.extrude(side, wide, axis=ag.X, bevel=0.0005), belly]
    on, off = ag.ring(0.0016, 0.0011), ag.rectangle(0.0006, 0.0034)
    print_at = middle + 0.0009
    rocker = ag.weld(
        ag.part(solids, "rocker", finish, push=pushes),
        details.printed(on, (0, 0.0055, print_at), material=ink, facing=ag.Z),
        details.printed(off, (0, -0.0055, print_at), material=ink, facing=ag.Z),
    )
    tilt = ag.Revolute("switch_rock", axis=ag.X, limits=(-_ROCK, _ROCK), feel=_SNAP)
    opening = (wide + 2 * FIT.running, long + 2 * FIT.running)
    sheet = ag.rectangle(wide + 0.007, long + 0.007, radius=0.002) - ag.rectangle(*opening)
    bezel = ag.extrude(sheet, 0.0016, bevel=0.0004).at(z=0.0002)
    hole = ag.box(*opening, 0.020).at(z=0.0015)
    return Fitting.moving(rocker, tilt, fixed=ag.detail(bezel, "switch", finish), cut=hole)


def cord(
    finish: ag.Material,
    start: ag.Scalar,
    end: ag.Scalar,
    height: ag.Scalar,
    switched: Fitting | None,
    *,
    stiff: float = 0.022,
) -> ag.Body:
    """Make a cord from an outlet at y = `start`, with a switch in a case at y = `end` if there is one."""
    if switched is None:
        return _run(finish, start, end + _ALONE, height, sway=0.04, stiff=stiff)
    case = ag.Region.centered(*CASE).at(z=CASE[2] / 2)
    foot = case.shrink(x=0.005, y=0.006).with_(z=(0, 0.002))
    seam = case.shrink(x=0.002, y=0.002).with_(z=(0.0084, 0.0096))
    body = ag.weld(
        ag.part(case.shrink(bottom=0.001).box(bevel=0.005), "switch", finish, separate=_JOINED),
        ag.part(foot.box(bevel=0.0006), "switch", finish),
        ag.detail(seam.box(), "switch", finish),
    )
    near, far = end + case.y.low + 0.002, end + case.y.high
    return ag.weld(
        body.install(switched, at=(0, 0, CASE[2])).at(y=end),
        _run(finish, start, near, height, stiff=stiff),
        _run(finish, far, far + _TAIL, 0.010, sway=0.03),
    )


def _run(
    finish: ag.Material,
    start: ag.Scalar,
    end: ag.Scalar,
    height: ag.Scalar,
    *,
    sway: float = 0.0,
    stiff: float = 0.022,
) -> ag.Body:
    """Make a length of cord; it is straight at its outlet, and from high up it bends down in a wider arc."""
    free, rest = start + 0.022, end - start - 0.022
    path = ag.bezier(  # the path stays above the floor, as its control points do
        [
            (0, start - 0.004, height),
            (0, start + stiff, height - 0.001),
            (1.2 * sway, free + 0.30 * rest, CORD),
            (3.0 * sway, free + 0.50 * rest, CORD),
            (-3.0 * sway, free + 0.75 * rest, CORD),
            (0, end, CORD),
        ]
    )
    relief = [each.at(y=start, z=height) for each in strain_relief()]
    return ag.detail([*relief, ag.sweep(ag.circle(CORD - 0.0002), path)], "cord", finish)


@dataclass(frozen=True)
class Chain:
    """A pull chain."""

    travel: ag.Scalar  # travel of the chain [m]
    force: ag.Scalar  # spring force of the chain pulled out [N]
    under: ag.Scalar  # height of the part under the chain [m]

    def beside(self, mouth: ag.Scalar, rim: ag.Scalar, metal: ag.Material) -> ag.Body:
        """Make the switch in front of a socket, a bell-mouthed tube, with its chain."""
        outlet, pipe = mouth - 0.048, self.travel + _IN_SPOUT + 0.006
        stem = ag.cylinder_between((0, 0, mouth - 0.030), (0, _SPOUT - 0.001 - _OUT, mouth - 0.030), 0.0042)
        tube = ag.tube(_SPOUT, _BORE, pipe, bevel=0.0006).at(z=pipe / 2)
        lid = ag.cylinder(_BORE + 0.0034, 0.005, bevel=0.0012).at(z=pipe + 0.0022)
        bell = ag.tube(_SPOUT + 0.0018, _SPOUT - 0.0004, 0.004, bevel=0.0008).at(z=0.002)
        switch = ag.weld(
            ag.part([stem, *(each.at(0, -_OUT, outlet) for each in (tube, lid))], "socket", metal),
            ag.detail(bell.at(0, -_OUT, outlet), "switch", metal),
        )
        hang = ag.max_(outlet - rim + _BELOW, _OUTSIDE)
        # preload for the weight of chain and knob, 0.1 N, and the friction
        spring = ag.Spring(preload=0.35 * self.force, force=self.force)
        pull = ag.Prismatic("switch_pull", axis=-ag.Z, limits=(0.0, self.travel), spring=spring, feel=_CHAIN)
        lowest = outlet - hang - _KNOB[1] / 2 - self.travel
        chain = (
            self._hanging(hang, metal).at(0, -_OUT, outlet).require(lowest > self.under + 0.001, _PULLED_INTO)
        )
        return switch.attach(chain, pull)

    def _hanging(self, hang: ag.Scalar, metal: ag.Material) -> ag.Body:
        """Make the link `pull_chain`: a thin rod collides in place of its balls."""
        above = self.travel + _IN_SPOUT
        rod = ag.capsule(_CORE, hang + above).at(z=(above - hang) / 2)
        knob = ag.cylinder(*_KNOB, bevel=0.0022).at(z=-hang)
        neck = ag.frustum(0.0044, 0.0020, 0.006).at(z=0.0105 - hang)
        step = (above / 2 + hang - 0.0135) / (_BALLS - 1)
        balls = ag.array(ag.sphere(_BALL), at=ag.row((0, 0, above / 2), (0, 0, -step), _BALLS))
        hold = ag.grasp_on(knob, approach=ag.Y, closing=ag.X)
        return ag.weld(
            ag.part([knob, neck], "pull_chain", metal, grasp=hold),
            ag.part(rod, "pull_chain", metal.with_(name=f"{metal.name}_chain", density=1500.0)),
            ag.detail(balls, "pull_chain", metal),
        )
