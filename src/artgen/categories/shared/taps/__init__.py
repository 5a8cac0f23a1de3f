"""Taps: stands, spouts, handles and drains of faucets and sinks."""

from typing import Literal

import artgen as ag
from artgen.categories.shared.taps import spouts, stands

_PAST = 0.045  # distance from the end of a lever to the middle of a spray head [m]


def ring_of(girth: ag.Scalar) -> ag.Scalar:
    """Return the height of the ring of a straight spout of a tube of some radius [m]."""
    return 2 * girth + 0.010


def attach_spout(
    stand: stands.Stand,
    tube: spouts.Spout,
    style: spouts.SpoutStyle | Literal["pull_down"],
    height: ag.Scalar,
    *,
    hub: ag.Scalar,
    square: bool,
    head: tuple[ag.Scalar, ag.Scalar],
    lever: ag.Scalar,
    turn: ag.Scalar,
    friction: ag.Scalar,
) -> ag.Body:
    """Attach a spout to its stand by `spout_swivel`.

    Args:
        stand: Fixed parts.
        tube: Tube of the spout.
        style: Its course; `pull_down` is a gooseneck with a spray head.
        height: Height of the top above the deck, or above the bar in front of a wall [m].
        hub: Radius of the ring of a straight spout [m].
        square: Whether a straight spout is flat.
        head: Travel [m] and return force [N] of a spray head.
        lever: Length of the lever that a spray head has to pass [m].
        turn: Turn to each side [rad].
        friction: Friction of the seals [N m].
    """
    rise = height - stand.over - tube.radius  # height of the middle of the tube above the foot of a spout
    straight = rise - 0.5 * tube.reach  # height of the start of the arc of a gooseneck
    if style == "beam":
        turned = tube.straight(hub=hub, tall=ring_of(tube.radius), square=square)
    elif style == "low":
        turned = tube.hanging()
    elif style == "pull_down":
        fall = straight - head[0] - 0.017  # length of the straight leg for the hose
        turned = tube.pull_down(height=rise, fall=fall, travel=head[0], force=head[1])
        turned = turned.require(
            tube.reach > lever + _PAST,
            f"the spray head swings past the lever: reach must exceed lever_length by {_PAST:g} m",
        )
    else:
        fall = {"gooseneck": straight - 0.032, "arc": 0.6 * rise}.get(style, rise - 0.032)
        turned = tube.rising(style, height=rise, fall=ag.max_(stand.least, fall))
    swivel = ag.Revolute(
        "spout_swivel", axis=ag.Z, limits=(-turn, turn), feel=spouts.SEALS, friction=friction
    )
    return stand.body.attach(turned, swivel, at=stand.foot)
