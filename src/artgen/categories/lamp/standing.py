"""Lamps with a shade on a socket: table lamps, floor lamps, tripods, and globes."""

from dataclasses import dataclass

import artgen as ag
from artgen.categories.lamp.bases import harp
from artgen.categories.lamp.finish import GLOBE
from artgen.categories.lamp.lampshades import HUB, STUD, FabricShade, ShadeKind, drop_of, lamp_holder

CHAIN_BALLS = 26
"""Number of visible balls of a chain."""

_BALL = 0.0016  # radius of a ball: chains of lamps have balls of 3.2 mm [m]
_CORE = 0.0015  # radius of the rod that collides for the chain [m]
KNOB = (0.0052, 0.016)
"""Radius and height of the knob of a chain [m]."""

SPOUT = 0.0064
"""Outer radius of the spout of a switch [m]."""

_BORE = 0.0042  # radius of the bore of the spout [m]
_IN_SPOUT = 0.012  # length of the pulled chain inside the spout [m]


def spout_length(travel: ag.Scalar) -> ag.Scalar:
    """Return the length of the spout of a switch for a chain with a travel [m]."""
    return travel + _IN_SPOUT + 0.006


def spout(travel: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the switch of a pull chain: a bell-mouthed tube down to z = 0, which is welded to a socket."""
    long = spout_length(travel)
    pipe = ag.tube(SPOUT, _BORE, long, bevel=0.0006).at(0.0, 0.0, long / 2.0)
    lid = ag.cylinder(_BORE + 0.0034, 0.005, bevel=0.0012).at(0.0, 0.0, long + 0.0022)
    mouth = ag.tube(SPOUT + 0.0018, SPOUT - 0.0004, 0.004, bevel=0.0008).at(0.0, 0.0, 0.002)
    return ag.weld(
        ag.part(pipe, "socket", finish), ag.part(lid, "socket", finish), ag.detail(mouth, "switch", finish)
    )


def pull_chain(travel: ag.Scalar, hang: ag.Scalar, *, finish: ag.Material, knob: ag.Material) -> ag.Body:
    """Make a chain below a spout with its mouth at the origin: the link `pull_chain`.

    A thin rod collides in place of the chain; the balls of the chain are visual only.
    """
    above = travel + _IN_SPOUT
    rod = ag.capsule(_CORE, hang + above).at(0.0, 0.0, (above - hang) / 2.0)
    pull: ag.Solid = ag.cylinder(*KNOB, bevel=0.0022).at(0.0, 0.0, -hang)
    neck = ag.frustum(0.0044, 0.0020, 0.006).at(0.0, 0.0, 0.0105 - hang)
    step = (0.5 * above + hang - 0.0135) / (CHAIN_BALLS - 1)
    balls = ag.array(ag.sphere(_BALL), at=ag.row((0.0, 0.0, 0.5 * above), (0.0, 0.0, -step), CHAIN_BALLS))
    hold = ag.grasp_on(pull, approach=ag.Y, closing=ag.X)
    return ag.weld(
        ag.part(pull, "pull_chain", knob, grasp=hold),
        ag.part(neck, "pull_chain", knob),
        ag.part(rod, "pull_chain", finish.with_(name=f"{finish.name}_chain", density=1500.0)),
        ag.detail(balls, "pull_chain", finish),
    )


def chain_pull(travel: ag.Scalar, *, force: ag.Scalar) -> ag.Joint:
    """Make the joint of a chain: it is pulled down by a travel, and its spring draws it up again."""
    preload = 0.35 * force  # preload for the weight of chain and knob, 0.1 N, and the friction
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        "switch_pull",
        axis=(0.0, 0.0, -1.0),
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=2.0,
        friction=0.2,
        armature=0.02,  # inertia of the ratchet of the switch
        effort=20.0,
    )


_GAP = 0.0004  # gap above and below the hub of a shade [m]
_SEAT = 0.0027  # height of the hub above the bar of a harp [m]
_BOW = 0.042  # half of the width of a harp [m]
_OUT = 0.046  # distance of the chain from the axis: a finger closes between it and the pole [m]
_BELOW = 0.052  # depth of the middle of the knob below the shade, for a hand past the rim [m]
_OUTSIDE = 0.014  # least free length of the chain under the spout, so that the knob stays outside [m]
_PULLED_INTO = (
    "a pull chain would be pulled into the part under it: raise height, or lower "
    "chain_travel, shade_radius, shade_height or body_radius"
)
_HANGS_LOW = (
    "the shade would touch the floor, the base or the switch on the cord: raise height, or lower "
    "shade_radius or shade_height"
)

BESIDE = _OUT - KNOB[0]
"""Distance from the axis that a lamp may reach without being under its chain [m]."""


@dataclass(frozen=True)
class Chain:
    """A pull chain."""

    travel: ag.Scalar  # travel of the chain [m]
    force: ag.Scalar  # spring force of the chain pulled out [N]
    knob: ag.Material  # material of the knob
    under: ag.Scalar  # height of the part under the chain [m]


def harp_rise(height: ag.Scalar, kind: ShadeKind) -> ag.Float:
    """Return the height of a harp above the mouth of its socket [m].

    A cloth shade hides the socket: its rim is about 34 mm below the mouth. A dome ends near the mouth.
    """
    below = 0.004 if kind == "dome" else drop_of(kind) + 0.037
    return ag.clamp(height - below, 0.112, 0.24)


def crown(rise: ag.Float) -> ag.Float:
    """Return the height of the finial of a harp above the mouth of the socket [m]."""
    return rise + 0.012 + 0.018


def shaded(
    base: ag.Body,
    shade: FabricShade,
    *,
    mouth: ag.Scalar,
    height: ag.Scalar,
    metal: ag.Material,
    friction: ag.Scalar,
    over: ag.Scalar,
    chain: Chain | None = None,
) -> ag.Body:
    """Put a socket with its bulb, a harp and a shade on a base.

    The shade rests on the harp and turns on its stud; friction under its weight and the finial holds it.
    """
    top = mouth + harp_rise(height, shade.kind)
    bow = harp(
        saddle=mouth - 0.005,
        top=top,
        half=_BOW,
        metal=metal,
        stud=HUB + _SEAT + 0.0003,
        stud_radius=STUD,
        finial=shade.kind != "dome",
    )
    bodies = [base, lamp_holder(metal).at(0.0, 0.0, mouth), *bow]
    level = top + _SEAT + _GAP - shade.hub  # height of the lower rim
    if chain is not None:
        bodies.append(_chained(chain, mouth, level, metal))
    turn = ag.Revolute("shade_turn", axis=ag.Z, friction=friction, damping=0.01, armature=0.0002, effort=3.0)
    cover = shade.body.at(0.0, 0.0, level).require(level > over, _HANGS_LOW)
    return ag.weld(*bodies).attach(cover, turn)


def _chained(chain: Chain, mouth: ag.Scalar, rim: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the switch beside a socket with its chain, in front."""
    outlet = mouth - 0.048
    hang = ag.max_(outlet - rim + _BELOW, _OUTSIDE)
    long = _OUT - SPOUT + 0.001
    stem = ag.cylinder(0.0042, long, axis=ag.Y).at(0.0, -0.5 * long, mouth - 0.030)
    switch = ag.weld(ag.part(stem, "socket", metal), spout(chain.travel, metal).at(0.0, -_OUT, outlet))
    pull = pull_chain(chain.travel, hang, finish=metal, knob=chain.knob).at(0.0, -_OUT, outlet)
    lowest = outlet - hang - KNOB[1] / 2.0 - chain.travel
    pull = pull.require(lowest > chain.under + 0.001, _PULLED_INTO)
    return switch.attach(pull, chain_pull(chain.travel, force=chain.force))


def globed(base: ag.Body, *, top: ag.Scalar, radius: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Put a globe of opal glass with its bulb on a base with its top at a height."""
    cup = ag.tube(0.030, 0.026, 0.016, bevel=0.0012).at(0.0, 0.0, top + 0.008)
    floor = ag.cylinder(0.029, 0.004, bevel=0.0012).at(0.0, 0.0, top + 0.002)
    sunk = 0.010 - 0.0045  # depth of a globe of 0.1 m in a ring of 26 mm
    return ag.weld(
        base,
        ag.part(ag.sphere(radius).at(0.0, 0.0, top + sunk + radius), "shade", GLOBE),
        ag.part(cup, "socket", metal),
        ag.part(floor, "socket", metal),
    )
