"""Pairs of shutters in front of a window: louvers in a frame, or boards on ledges."""

from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared.fronts import Opening, slats_in
from artgen.categories.window import hardware
from artgen.categories.window.frame import SEAM
from artgen.categories.window.hardware import BARREL

Style = Literal["none", "louvred", "boarded"]

_THICK = 0.032  # thickness of a leaf [m]
_OFF = 0.012  # gap from a leaf to the frame behind it [m]
_STILE, _RAIL = 0.048, 0.062  # widths of the boards [m]
_PIN_IN = 0.004  # distance from the face of a leaf to its pin [m]
_LEDGE = 0.016  # thickness of the ledges that hold boards together [m]


def hang_shutters(
    body: ag.Body,
    frame: ag.Region,
    *,
    style: Style,
    finish: ag.Material,
    metal: ag.Material,
    slats: int,
    swing: ag.Scalar,
    friction: ag.Scalar,
    solid: bool,
) -> ag.Body:
    """Attach a pair of shutters in front of a frame."""
    x, y = frame.x.low + BARREL, frame.y.low - _OFF - _THICK + _PIN_IN
    behind, free = _THICK - _PIN_IN, -x - 0.0003
    # the back corner of a leaf swings past the other leaf; 4 mm between the widest points of both
    edge = -ag.max_(0.002, -x - ag.sqrt(free * free - behind * behind))
    y0 = frame.y.low - _OFF
    leaf = ag.Region((x + BARREL + 0.002, edge), (y0 - _THICK, y0), frame.z)
    levels = [(x, y, leaf.z.at(share)) for share in (0.16, 0.84)]
    on_frame, on_leaf = hardware.barrel_hinges(
        tall=0.075, arm=BARREL + 0.002, foot=frame.y.low - y, at=levels, finish=metal, solid=solid
    )
    boards = (_louvred if style == "louvred" else _boarded)(leaf, slats, finish)
    pull = hardware.bow_pull(length=0.12, girth=0.0048, finish=metal)
    pull = pull.at(edge - _STILE / 2, leaf.y.low, leaf.z.mid)
    drag = feel.Feel(friction=friction, damping=0.4, effort=60, velocity=6)
    hinge = ag.Revolute("shutter_hinge", axis=-ag.Z, pivot=(x, y, 0.0), limits=(0, swing), feel=drag)
    body = ag.weld(body, on_frame, on_frame.mirror(ag.X))
    return body.attach_pair(ag.weld(*boards, pull, on_leaf), hinge, suffixes=("_left", "_right"))


def _louvred(leaf: ag.Region, slats: int, finish: ag.Material) -> list[ag.Body]:
    """Make stiles, three rails and two fields of louvers; `slats` are in each of them."""
    left, inner, right = leaf.across(_STILE, None, _STILE)
    top, upper, middle, lower, bottom = inner.stack(_RAIL, (leaf.z.size - 3 * _RAIL) / 2, _RAIL, None, _RAIL)
    rails = [each.shrink(x=SEAM / 2, y=0.0002).box(bevel=0.0015) for each in (bottom, middle, top)]
    stiles = [each.box(bevel=0.0025) for each in (left, right)]
    bodies = [ag.part([*stiles, *rails], "shutter", finish)]
    for field in (lower, upper):
        opening = Opening(field.x.size + 0.002, field.z.size, [field.center], 1, finish, "shutter")
        bodies += slats_in(opening, _THICK, slats, joined=True)
    return bodies


def _boarded(leaf: ag.Region, slats: int, finish: ag.Material) -> list[ag.Body]:
    """Make vertical boards, a third of the slats, with a V at every joint, on two ledges behind them."""
    front, back = leaf.deep(None, _LEDGE)
    ledge = ag.box(leaf.x.size - 0.030, _LEDGE + 0.0005, 0.085, bevel=0.003)
    boards = [each.box(bevel=0.003) for each in front.columns(max(3, slats // 3))]
    x, y, z = back.center
    at = [(x, y, z + share * leaf.z.size) for share in (-0.34, 0.34)]
    return [ag.part([*boards, ag.array(ledge, at=at)], "shutter", finish)]
