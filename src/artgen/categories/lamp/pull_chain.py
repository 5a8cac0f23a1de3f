"""Pull chains: a ball chain with a knob, which hangs out of its switch and springs back."""

from artgen import (
    Body,
    Joint,
    Material,
    Prismatic,
    Scalar,
    Solid,
    X,
    Y,
    array,
    capsule,
    cylinder,
    detail,
    frustum,
    grasp_on,
    part,
    row,
    sphere,
    tube,
    weld,
)

CHAIN_BALLS = 26
"""How many balls of a chain are seen."""

_BALL = 0.0016  # radius of a ball: chains of lamps have 3.2 mm balls [m]
_CORE = 0.0015  # radius of what stands for the chain [m]
KNOB = (0.0052, 0.016)
"""Radius and height of its knob [m]."""

SPOUT = 0.0064
"""Outer radius of the spout of a switch [m]."""

_BORE = 0.0042  # of the spout of the switch [m]
_IN_SPOUT = 0.012  # how much of the chain is left in the spout when it is pulled [m]


def spout_length(travel: Scalar) -> Scalar:
    """Return how long the spout of a switch is from which a chain comes out by a travel [m]."""
    return travel + _IN_SPOUT + 0.006


def spout(travel: Scalar, finish: Material) -> Body:
    """Make the switch of a pull chain: a bell-mouthed tube down to z = 0, to be welded to a socket."""
    long = spout_length(travel)
    pipe = tube(SPOUT, _BORE, long, bevel=0.0006).at(0.0, 0.0, long / 2.0)
    lid = cylinder(_BORE + 0.0034, 0.005, bevel=0.0012).at(0.0, 0.0, long + 0.0022)
    mouth = tube(SPOUT + 0.0018, SPOUT - 0.0004, 0.004, bevel=0.0008).at(0.0, 0.0, 0.002)
    return weld(part(pipe, "socket", finish), part(lid, "socket", finish), detail(mouth, "switch", finish))


def pull_chain(travel: Scalar, hang: Scalar, *, finish: Material, knob: Material) -> Body:
    """Make a chain that hangs out of a spout whose mouth is the origin: the link `pull_chain`.

    A thin rod stands for the chain, whose balls are only seen.
    """
    above = travel + _IN_SPOUT
    rod = capsule(_CORE, hang + above).at(0.0, 0.0, (above - hang) / 2.0)
    pull: Solid = cylinder(*KNOB, bevel=0.0022).at(0.0, 0.0, -hang)
    neck = frustum(0.0044, 0.0020, 0.006).at(0.0, 0.0, 0.0105 - hang)
    step = (0.5 * above + hang - 0.0135) / (CHAIN_BALLS - 1)
    balls = array(sphere(_BALL), at=row((0.0, 0.0, 0.5 * above), (0.0, 0.0, -step), CHAIN_BALLS))
    hold = grasp_on(pull, approach=Y, closing=X)
    return weld(
        part(pull, "pull_chain", knob, grasp=hold),
        part(neck, "pull_chain", knob),
        part(rod, "pull_chain", finish.with_(name=f"{finish.name}_chain", density=1500.0)),
        detail(balls, "pull_chain", finish),
    )


def chain_pull(travel: Scalar, *, force: Scalar) -> Joint:
    """Make the joint of a chain: it comes down by a travel, and its spring takes it up again."""
    preload = 0.35 * force  # carries chain and knob, 0.1 N, and the friction
    stiffness = (force - preload) / travel
    return Prismatic(
        "switch_pull",
        axis=(0.0, 0.0, -1.0),
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=2.0,
        friction=0.2,
        armature=0.02,  # the ratchet of the switch
        effort=20.0,
    )
