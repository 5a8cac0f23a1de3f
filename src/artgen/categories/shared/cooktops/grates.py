"""Pan supports over gas burners: cast bars on rubber feet, to be lifted off for cleaning.

Each is a link of its own, `grate_0` and on, that rests on the plate and slides up from it.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen.categories.shared.cooktops.plan import Column, Place

GrateStyle = Literal["continuous", "single", "diagonal"]
"""One for each column of burners, one for each burner, or the same with fingers from the corners."""

TOP = 0.043
"""How high above the plate the pots stand [m]."""

LIFT = 0.10
"""How far a grate is lifted off [m]."""

_WIDE, _HIGH = 0.0095, 0.0115  # of a bar [m]
_SLIM = 0.84  # width of a finger, as a share of that
_APART = 0.003  # from a grate to the border of its field [m]
_BARE = 0.020  # around the middle of a burner, which the fingers leave free [m]
_REST = 0.0003  # between the feet and the plate, which the joint's limit keeps [m]
_SOFT = 0.0022  # radius of the edges [m]


def _bars(
    size: tuple[ag.Scalar, ag.Scalar], at: list[tuple[ag.Scalar, ag.Scalar]], top: ag.Scalar
) -> ag.Solid:
    """Make level bars of one length along x and y, their middles at places [m]."""
    x, y = size
    low = (-0.5 * x, -0.5 * y, top - _HIGH)
    bar = ag.box_between(low, (0.5 * x, 0.5 * y, top), bevel=_SOFT)
    return ag.array(bar, at=[(i, j, 0.0) for i, j in at])


def _fingers(
    burners: Sequence[Place], half: tuple[ag.Scalar, ag.Scalar], *, diagonal: bool, top: ag.Scalar
) -> list[ag.Solid]:
    """Make four fingers that point to the middle of each burner from the frame around it."""
    wide, deep = half
    middles = [(place.x, place.y) for place in burners]
    slim, low = _SLIM * _WIDE, top - 0.04 * _HIGH
    if not diagonal:
        x, y = 0.5 * (wide + _BARE), 0.5 * (deep + _BARE)
        beside = [(i + way * x, j) for i, j in middles for way in (-1, 1)]
        before = [(i, j + way * y) for i, j in middles for way in (-1, 1)]
        return [_bars((wide - _BARE, slim), beside, low), _bars((slim, deep - _BARE), before, low)]
    inner = 0.71 * _BARE
    x, y = wide - inner, deep - inner
    made = []
    for way in (-1, 1):  # two fingers in a line have one direction
        start = ag.box_between(
            (0.0, -0.5 * slim, low - _HIGH), (ag.sqrt(x * x + y * y), 0.5 * slim, low), bevel=_SOFT
        )
        finger = start.rotate(ag.Z, ag.atan2(way * y, x))
        first = [(i + inner, j + way * inner) for i, j in middles]
        second = [(i - wide, j - way * deep) for i, j in middles]
        made.append(ag.array(finger, at=[(i, j, 0.0) for i, j in (*first, *second)]))
    return made


def grate(
    name: str,
    burners: Sequence[Place],
    *,
    half: tuple[ag.Scalar, ag.Scalar],
    plate: ag.Scalar,
    style: GrateStyle,
    iron: ag.Material,
    feet: ag.Material,
) -> ag.Body:
    """Make a grate over one burner, or over several behind each other."""
    top = plate + TOP
    wide, deep = half
    first, last = burners[0], burners[-1]
    x, front, back = first.x, first.y - deep, last.y + deep
    levels = [front, *(0.5 * (a.y + b.y) for a, b in pairwise(burners)), back]
    across = _bars((2.0 * wide + _WIDE, _WIDE), [(x, y) for y in levels], top)
    ends = [(x + way * wide, 0.5 * (front + back)) for way in (-1, 1)]
    sides = _bars((_WIDE, back - front), ends, top - 0.0002)
    inner = _fingers(burners, half, diagonal=style == "diagonal", top=top)
    # legs under the corners, whose ends have rubber around them
    corners = [ag.vector(x + i * wide, y, 0.0) for i in (-1, 1) for y in (front, back)]
    leg = ag.box_between((-0.0046, -0.0046, plate + _REST), (0.0046, 0.0046, top - 0.004), bevel=_SOFT)
    pad = ag.box_between((-0.0052, -0.0052, plate + _REST), (0.0052, 0.0052, plate + 0.006), bevel=0.0015)
    # a hand takes it by a finger, where no other grate is beside it; its tips reach 10 mm down
    slim, grip = _SLIM * _WIDE, top - 0.04 * _HIGH - 0.001
    if style == "diagonal":
        start, share = 0.71 * _BARE, 0.5
        run, rise = wide - start, deep - start
        at = (first.x - start - share * run, first.y + start + share * rise, grip)
        hold = ag.frame(at, approach=-ag.Z, closing=ag.vector(rise, run, 0.0))
    else:
        hold = ag.frame((first.x - 0.5 * (wide + _BARE), first.y, grip), approach=-ag.Z, closing=ag.Y)
    apart = "each bar is cast onto the others"
    return ag.weld(
        ag.part(inner[0], "grate", iron, name=name, grasp=hold, grasp_width=slim + 0.010, separate=apart),
        *(
            ag.part(each, "grate", iron, separate=apart)
            for each in (*inner[1:], across, sides, ag.array(leg, at=corners))
        ),
        ag.detail(ag.array(pad, at=corners), "grate", feet),
    )


def grate_lift(name: str) -> ag.Joint:
    """Make the joint by which a grate is lifted off the plate; its weight brings it back."""
    return ag.Prismatic(name, axis=ag.Z, limits=(0.0, LIFT), damping=4.0, effort=60.0)


def grates(
    columns: Sequence[Column], *, plate: ag.Scalar, style: GrateStyle, iron: ag.Material, feet: ag.Material
) -> list[tuple[ag.Body, ag.Joint]]:
    """Make all grates of a cooktop with the joints by which they are lifted."""
    inset = _APART + _WIDE / 2
    groups: list[tuple[Sequence[Place], tuple[ag.Scalar, ag.Scalar]]] = []
    for column in columns:
        deep = 0.5 * column.depth / len(column.burners)
        if style == "continuous":
            groups.append((column.burners, (0.5 * column.width - inset, deep - inset)))
        else:
            most = 1.3 * column.burners[0].reach
            around = (ag.min_(0.5 * column.width, most) - inset, ag.min_(deep, most) - inset)
            groups += [((burner,), around) for burner in column.burners]
    made = []
    for number, (burners, half) in enumerate(groups):
        name = f"grate_{number}"
        body = grate(name, burners, half=half, plate=plate, style=style, iron=iron, feet=feet)
        made.append((body, grate_lift(f"grate_lift_{number}")))
    return made
