"""Kitchens: base units under one worktop, appliances, wall units, a door and a window, in one style."""

from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.errors import AssetError, ParameterError
from artgen.materials import Material, material
from artgen.scene.room import GAP, Placement, Scene

_UNDER = 0.86  # height of base units and dishwashers, below the worktop [m]
_THICK = 0.035  # of the worktop [m]
_DEEP = 0.56  # of the carcass of base units [m]
_OVERHANG = 0.02  # of the worktop over the carcass [m]
_ABOVE = 1.45  # bottom of the wall units [m]
_MARGIN = 0.05  # filler between a run and a side wall, which lets doors open [m]
_UNIT = 0.4  # least width of a base unit [m]
_NARROWEST, _WIDEST = 3.0, 4.8  # widths of the room [m]
_ATTEMPTS = 8  # draws before a kitchen counts as infeasible
_WORKTOPS = ("granite", "black_granite", "marble", "oak", "walnut", "beech")
_GRIPS = ("bar", "bar", "knob", "cup")  # handles that doors and drawers have
_FLOORS = ("oak", "oak_flat_sawn", "ash", "granite", "walnut")


def kitchen(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return a kitchen along one wall, proven free of collisions in all states of all its joints.

    It has a refrigerator, a range, base units with drawers and doors and a dishwasher under one worktop, wall
    units, a window in the left wall and a door in the right one.

    Args:
        seed: Seed of the layout and of all assets.
        width: Length of the back wall [m]; drawn from 3.0 to 4.8 by default.
        depth: Depth of the room [m]; drawn from 2.4 to 3.2 by default.
        detail: Level of detail of the assets.

    Raises:
        ParameterError: The room is too small; the message has the length that is missing.
        AssetError: No draw is free of collisions.
    """
    error: AssetError | None = None
    for attempt in range(_ATTEMPTS):
        try:
            return _drawn(seed, attempt, width, depth, detail)
        except AssetError as found:
            error = found
    assert error is not None
    raise AssetError(f"kitchen {seed}: {_ATTEMPTS} draws failed; the last: {error}") from error


def _drawn(seed: int, attempt: int, width: float | None, depth: float | None, detail: DetailName) -> Asset:
    draw = np.random.default_rng((seed, attempt))
    spans = ((_NARROWEST, _WIDEST), (2.4, 3.2), (2.4, 2.7))
    size = [round(float(draw.uniform(*span)), 3) for span in spans]
    size[0], size[1] = width or size[0], depth or size[1]
    floor, top = (material(str(draw.choice(names))) for names in (_FLOORS, _WORKTOPS))
    room = Scene(
        f"kitchen_{seed}",
        seed=seed * _ATTEMPTS + attempt,
        width=size[0],
        depth=size[1],
        height=size[2],
        floor=floor,
        detail=detail,
    )
    left = bool(draw.random() < 0.5)  # whether the refrigerator is at the left end
    cold = ("refrigerator", {"build": "tall", "hand": "right" if left else "left"})
    wide = str(draw.choice(["full", "slim"]))
    fixed: list[tuple[str, dict[str, Any]]] = [
        ("dishwasher", {"build": "built_in", "height": _UNDER, "size": wide}),
        ("oven", {"build": "range", "width": 0.6}),
    ]
    taken = sum(_width(room.draw(name, **values)) for name, values in (cold, *fixed))
    spare = size[0] - 2.0 * _MARGIN - taken - GAP * len(fixed)
    count = max(1, round(spare / 0.62))
    unit = spare / count - GAP
    if unit < _UNIT:
        raise ParameterError(
            f"a kitchen of {size[0]:.3f} m is too narrow: with a refrigerator, a dishwasher and an oven, "
            f"{_UNIT - unit:.3f} m are missing for a base unit"
        )
    style, finish = _style(room, str(draw.choice(_GRIPS)))
    units = [_unit(number, unit, style | {"finish": finish}) for number in range(count)]
    row: list[tuple[str, dict[str, Any]]] = [*fixed, *units]
    row = [row[index] for index in draw.permutation(len(row))]
    placed = room.run("back", *([cold, *row] if left else [*row, cold]), at=_MARGIN)
    _worktops(room, placed, top)
    for number, each in enumerate(placed):
        if each.asset.category in ("drawer", "cabinet"):
            at = float(each.bounds[0, 0]) + size[0] / 2.0
            hung = {"kind": "wall", "width": unit, "height": 0.72, "top": "flush", "finish": finish}
            hung |= {key: style[key] for key in ("look", "style", "grip")}
            room.against("back", "cabinet", at=at, z=_ABOVE, name=f"wall_unit_{number}", **hung)
    room.inset("left", "window", at=0.5 * (size[1] - 1.2), z=1.0, width=0.9, height=1.0, shutters="none")
    room.inset(
        "right", "door", at=0.1, layout="single", use="interior", opens="away", stock="standard", height=2.03
    )
    return room.build(category="kitchen", seed=seed, attempt=attempt)


def _width(asset: Asset) -> float:
    low, high = asset.bounds()
    return float(high[0] - low[0])


def _style(room: Scene, grip: str) -> tuple[dict[str, Any], Material]:
    """Return the look and style of the fronts, and their material, from one base unit."""
    model = room.draw("cabinet", kind="base", stand="plinth", top="flush", grip=grip)
    found = {each.name: each for each in model.materials}
    style = {key: model.parameters[key] for key in ("look", "style", "grip")}
    if (metal := found.get(model.parameters["metal"])) is not None:  # not where a door has no metal
        style["metal"] = metal
    return style, found[model.parameters["finish"]]


def _unit(number: int, width: float, style: dict[str, Any]) -> tuple[str, dict[str, Any]]:
    """Return a base unit with drawers or doors, by turns."""
    size = {"width": width, "height": _UNDER, "depth": _DEEP, "top": "flush"}
    if number % 2:
        return "cabinet", {
            **size,
            **style,
            "kind": "base",
            "stand": "plinth",
            "doors": 2 if width > 0.6 else 1,
        }
    return "drawer", {**size, **style, "kind": "kitchen", "columns": 1, "style": _front(style["style"])}


def _front(style: str) -> str:
    """Return the style of drawer fronts that go with doors."""
    return style if style in ("flat", "shaker", "ramped") else "flat"


def _worktops(room: Scene, placed: list[Placement], top: Material) -> None:
    """Lay worktops over neighboring base units and dishwashers."""
    runs: list[list[Array]] = [[]]
    for each in placed:
        if each.asset.category in ("refrigerator", "oven"):
            runs.append([])
        else:
            runs[-1].append(each.bounds)
    for run in filter(None, runs):
        low, high = run[0][0, 0], run[-1][1, 0]
        front = -GAP - _DEEP - _OVERHANG - 0.02  # the fronts of doors are thick
        room.slab("worktop", (low, front, _UNDER + GAP), (high, 0.0, _UNDER + GAP + _THICK), top)
