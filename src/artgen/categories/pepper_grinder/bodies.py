"""Bodies of pepper mills: turned of one piece, or a clear tube full of peppercorns between two ends."""

import math
from typing import Literal

import artgen as ag
from artgen.categories.pepper_grinder.forms import BodyForm, body_runs, fitting, head_runs
from artgen.categories.pepper_grinder.works import STORE, store, works
from artgen.categories.shared.vessels.turned import Run, skin, turned

Content = Literal["pepper", "salt", "mixed"]
"""What is ground: black peppercorns, salt, or peppercorns of four colors."""

INSET = 0.0016
"""How far a clear tube stands back behind its foot and collar [m]."""

_WALL = 0.0028  # of a clear tube [m]
_BULK = 560.0  # peppercorns poured into a mill [kg/m3]
_AROUND = 20  # grains in a ring behind the clear wall
_GRAINS = {
    "pepper": ((0.060, 0.036, 0.022), 0.0024),
    "salt": ((0.82, 0.80, 0.78), 0.0021),
    "mixed": ((0.070, 0.042, 0.026), 0.0024),
}  # color, and radius of a grain [m]
_OTHERS = {"pepper": (0.105, 0.066, 0.042), "salt": (0.88, 0.86, 0.84), "mixed": (0.28, 0.05, 0.03)}
_ROOM = 0.0036  # half the width of holes in which the shaft turns [m]


def wooden(form: BodyForm, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a body turned of one piece, with its store and works: the link `body`."""
    runs = body_runs(form, radius, 0.0, height)
    return ag.weld(
        turned(runs, "body", finish, hole=store(-0.001, height + 0.001), bore=STORE),
        works(),
    )


def capped(
    body: ag.Body, form: BodyForm, radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar, metal: ag.Material
) -> ag.Body:
    """Put the domed cap of a mill with a crank on its body."""
    # a little lower, so that its corners are not those of the body
    runs = head_runs("crank", radius, low - 0.0002, height + 0.0002, across=fitting(form, "crank"))
    return ag.weld(
        body, turned(runs, "cap", metal, hole=store(low - 0.001, low + height + 0.001, _ROOM), bore=_ROOM)
    )


def ring(radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the thin band of metal around a body, only seen."""
    runs: list[Run] = [
        [(radius - 0.0004, low), (radius, low + 0.0004)],
        [(radius, low + 0.0004), (radius, high - 0.0004)],
        [(radius, high - 0.0004), (radius - 0.0004, high)],
    ]
    return ag.detail(skin(runs, bore=radius - 0.002), "ring", metal)


def clear(
    radius: ag.Scalar,
    height: ag.Scalar,
    finish: ag.Material,
    ends: ag.Material,
    *,
    content: Content,
    rings: int,
) -> ag.Body:
    """Make a clear tube with its contents between a foot and a collar: the link `body`."""
    foot, collar = 0.020 + 0.10 * radius, 0.010
    below: list[Run] = [
        [(0.97 * radius, 0.0), (radius, 0.0016)],
        [(radius, 0.0016), (radius, foot - 0.0012)],
        [(radius, foot - 0.0012), (radius - 0.0012, foot)],
    ]
    top = height - collar
    above: list[Run] = [
        [(radius - 0.0010, top), (radius, top + 0.0010)],
        [(radius, top + 0.0010), (radius, height - 0.0010)],
        [(radius, height - 0.0010), (radius - 0.0010, height)],
    ]
    outer = radius - INSET
    tube = ag.revolve(
        ag.half_section(ag.line((outer, 0.0, foot - 0.001), (outer, 0.0, top + 0.001)), wall=_WALL)
    )
    inner = outer - _WALL
    filled = foot + 0.82 * (top - foot)
    return ag.weld(
        turned(below, "body", ends, hole=store(-0.001, foot + 0.001), bore=STORE),
        turned(above, "body", ends, hole=store(top - 0.001, height + 0.001), bore=STORE),
        ag.part(ag.simplified_collider(tube), "body", finish.with_(name="clear_tube", density=1180.0)),
        _filling(content, inner, foot, filled, rings),
        works(),
    )


def _filling(content: Content, inner: ag.Scalar, low: ag.Scalar, high: ag.Scalar, rings: int) -> ag.Body:
    """Make the peppercorns in a tube: a core that weighs, and the grains that are seen at the wall."""
    color, size = _GRAINS[content]
    stuff = ag.material("polypropylene").with_(
        name=f"grains_{content}", base_color=color, density=_BULK, texture="", specular_roughness=0.8
    )
    others = stuff.with_(name=f"grains_{content}_light", base_color=_OTHERS[content])
    wide = inner - 1.6 * size
    heap = ag.revolve(
        ag.polygon([(0.0, low - 0.0005), (wide, low - 0.0005), (wide, high), (0.0, high)]), sides=16
    )
    hole = store(low - 0.01, high + 0.01, _ROOM)
    grain = ag.revolve(
        ag.polygon([(0.0, -1.0), (0.85, -0.55), (1.0, 0.15), (0.7, 0.8), (0.0, 1.0)]), sides=6
    ).scale(size)
    step = (high - low - 2.0 * size) / (2 * rings - 1)
    seen = []
    for index, grains in enumerate((stuff, others)):
        ring_ = ag.ring_points(
            (0.0, 0.0, low + size + index * step),
            inner - 1.15 * size,
            count=_AROUND,
            start=index * math.pi / _AROUND,
        )
        column = ag.array(
            ag.array(grain, at=ring_), at=ag.row((0.0, 0.0, 0.0), (0.0, 0.0, 2.0 * step), rings)
        )
        seen.append(ag.detail(column, "peppercorns", grains))
    lid = ag.array(grain, at=ag.ring_points((0.0, 0.0, high), 0.62 * inner, count=11))
    return ag.weld(ag.part(heap - hole, "peppercorns", stuff), *seen, ag.detail(lid, "peppercorns", stuff))
