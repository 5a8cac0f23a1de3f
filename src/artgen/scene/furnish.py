"""What all rooms draw: size, floor, style of fronts, a door, units under a worktop with a sink."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

import artgen as ag
from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.errors import AssetError, ParameterError
from artgen.export.frames import translation
from artgen.generator.generator import checked_count
from artgen.materials import Material, colored, material
from artgen.scene.room import GAP, SIZES, STANDING, Line, Placement, Scene, Wall, check_length, turned

THICK = 0.035  # of worktops [m]
UNDER = 0.86  # height of base units, below their worktop [m]
OVER = UNDER + GAP + THICK  # height of worktops [m]
DEEP = 0.56  # of the carcass of base units [m]
FACE = GAP + DEEP + 0.021  # from the wall to the faces of doors [m]
FRONT = FACE + 0.02  # from the wall to the front edge of the worktop [m]
KICK, SETBACK = 0.10, 0.05  # height and setback of plinths [m]
PLINTH = {"stand_height": KICK, "setback": SETBACK}
SWING = 1.45  # of doors: wider, their handles would be before the drawers beside them [rad]
DOORWAY = 1.08  # of a wall that a door takes [m]
_CORNER = 0.15  # distance from a wall within which a hand does not fit beside a handle [m]
_TAP = 0.109  # from the wall to the axis of the tap of a sink: a hand turns beside the wall [m]
_BOWL = 0.349  # depth of the bowls of a sink from front to back, between the rails of the unit [m]
_HUNG_IN = 0.116  # by which the inside of the bowls is narrower than their unit [m]
_BOWLS = {
    "single": (0.0, 1.0, 0.40, 0.52),
    "half": (0.026, 1.45, 0.34, 0.42),
    "double": (0.026, 2.0, 0.33, 0.42),
}
"""By kind of bowls: wall between two, total width over the width of the first, range of this width [m]."""

ATTEMPTS = 8  # draws before a room counts as infeasible
_WORKTOPS = ("granite", "black_granite", "marble", "oak", "walnut", "beech")
_GRIPS = ("bar", "bar", "knob", "cup")  # handles that doors and drawers have
_BOARDS = tuple(material(f"{wood}_boards") for wood in ("oak", "ash", "walnut"))
_TILES = (material("floor_tiles"), *(colored("floor_tiles", color) for color in ("sand", "slate")))
_FLOORS = {"living_room": _BOARDS, "office": _BOARDS, "bathroom": _TILES, "workshop": _TILES}
_WALLS = {
    "bathroom": (material("wall_tiles"), *(colored("wall_tiles", color) for color in ("cool_white", "sage")))
}

Span = tuple[float, float]
Hole = tuple[float, float, float, float]
"""Sides of a hole in plan: lowest and highest x, lowest and highest y [m]."""


def drawn(name: str, draw: Callable[[int], Asset]) -> Asset:
    """Return the first of several draws, by the number of the attempt, that is free of collisions."""
    error: AssetError | None = None
    for attempt in range(ATTEMPTS):
        try:
            return draw(attempt)
        except AssetError as found:
            error = found
    assert error is not None
    raise AssetError(f"{name}: {ATTEMPTS} draws failed; the last: {error}") from error


def check_room(seed: Any, size: tuple[Any, Any]) -> None:
    """Check the arguments that all rooms have."""
    checked_count("seed", seed)
    for name, length in zip(("width", "depth"), size, strict=True):
        if length is not None:
            check_length(name, length, *SIZES)


def width_of(asset: Asset) -> float:
    """Return the width of an asset [m]."""
    low, high = asset.bounds()
    return float(high[0] - low[0])


class Furnisher:
    """A draw of a room: its size and style, and the methods that furnish it.

    Args:
        kind: Name of the room.
        seed: Seed of the room.
        attempt: Number of draws before this one.
        size: Width and depth [m]; None where they are drawn.
        spans: Ranges of both [m].
        detail: Level of detail of the assets.
    """

    def __init__(
        self,
        kind: str,
        seed: int,
        attempt: int,
        size: tuple[float | None, float | None],
        spans: tuple[Span, Span],
        detail: DetailName,
    ) -> None:
        self.kind, self.seed, self.attempt = kind, seed, attempt
        self.draw = np.random.default_rng((seed, attempt, len(kind)))
        high, pairs = self.uniform(2.4, 2.7), zip(size, spans, strict=True)
        self.width, self.depth = (self.uniform(*span) if given is None else given for given, span in pairs)
        floor = self.choice(*_FLOORS.get(kind, _BOARDS + _TILES))
        self.top = material(self.choice(*_WORKTOPS))
        self.room = Scene(
            f"{kind}_{seed}",
            seed=seed * ATTEMPTS + attempt,
            width=self.width,
            depth=self.depth,
            height=high,
            floor=floor,
            paint=self.choice(*_WALLS.get(kind, (None,))),
            detail=detail,
        )
        self.fronts, self.finish = _style(self.room, self.choice(*_GRIPS))
        # only wall units are glazed
        self.base = self.fronts | ({"style": "shaker"} if self.fronts["style"] == "glazed" else {})
        self.sharp = bool(self.draw.random() < 0.4)  # whether a washbasin has sharp corners

    def choice(self, *values: Any) -> Any:
        """Return one of the values."""
        return values[int(self.draw.integers(len(values)))]

    def uniform(self, low: float, high: float) -> float:
        """Return a length in a range, in whole millimetres [m]."""
        return round(float(self.draw.uniform(low, high)), 3)

    def build(self, **parameters: Any) -> Asset:
        """Return the room with what was placed in it; it records its size and further parameters."""
        size = {"width": self.width, "depth": self.depth}
        return self.room.build(
            category=self.kind, seed=self.seed, attempt=self.attempt, parameters=size | parameters
        )

    def door(self, wall: Wall, at: float, **values: Any) -> Placement:
        """Set a door with a straight head into a wall."""
        if at < 0.0:
            raise ParameterError(
                f"{self.kind} {self.seed} of {self.width:g} x {self.depth:g} m: a door takes {DOORWAY:g} m "
                f"of a wall; {-at:.3f} m are missing"
            )
        usual: dict[str, Any] = {
            "layout": "single", "use": "interior", "opens": "away", "stock": "standard", "height": 2.03,
            "opener": "lever", "frame": self.choice("jambs", "full", "full"), "bolted": False,
            "swing": self.uniform(1.4, 1.57),
        }  # fmt: skip
        return self.room.inset(wall, "door", at=at + 0.02, **usual | values)

    def window(self, wall: Wall, middle: float, *, z: float = 1.32, **values: Any) -> Placement:
        """Set a window into a wall with its handles inside, its middle at a distance from the left end."""
        usual: dict[str, Any] = {
            "width": 0.9, "height": 0.85, "style": "sliding", "layout": "pair", "shutters": "none",
        }  # fmt: skip
        values = usual | values
        width = width_of(self.room.draw("window", **values))
        return self.room.inset(wall, "window", at=middle - 0.5 * width, z=z, turn=math.pi, **values)

    def board(
        self, label: str, wall: Wall | Line, x: Span, y: Span, z: Span, finish: Material | None = None
    ) -> Placement:
        """Add a board in the frame of a wall, by default with the finish of the fronts."""
        return self.room.slab(label, (x[0], y[0], z[0]), (x[1], y[1], z[1]), finish or self.finish, wall=wall)

    def before(self, wall: Wall, distance: float) -> Line:
        """Return a line along a wall, at a distance before it [m]."""
        frame, length = self.room.frame(wall)
        left, right = ((frame @ (x, -distance, 0.0, 1.0))[:2].tolist() for x in (0.0, length))
        return (left[0], left[1]), (right[0], right[1])

    def stand(
        self, category: str, name: str, x: float, y: float, *, sway: float = 0.0, **values: Any
    ) -> Placement:
        """Stand a free object in the room, facing the back wall or aside by up to an angle [rad]."""
        facing = turned(math.pi + (self.uniform(-sway, sway) if sway else 0.0))
        pose = translation(np.array([x, y, STANDING])) @ facing
        return self.room.add(category, pose, free=True, name=name, **values)

    def lay(
        self, outline: list[Span], holes: list[Hole], wall: Wall | Line | None, under: float = UNDER
    ) -> Placement:
        """Lay a worktop with holes, both in the frame of a wall, over units of a height."""
        low, high = under + GAP, under + GAP + THICK
        return self.room.fixture("worktop", lambda: worktop(outline, low, high, self.top, holes), wall=wall)

    def unit(
        self, wall: Wall | Line, at: float, width: float, *, doors: bool, high: float = UNDER, **values: Any
    ) -> Placement:
        """Place a base unit with drawers or doors; `values` are other parameters of it."""
        size: dict[str, Any] = {"width": width, "height": high, "depth": DEEP, "top": "flush"}
        if doors:
            kind: dict[str, Any] = {
                "kind": "base",
                "stand": "plinth",
                "doors": 2 if width > 0.6 else 1,
                "swing": SWING,
                **self._hinges(wall, at, width),
            }
            return self.room.against(wall, "cabinet", at=at, **size | PLINTH | self.base | kind | values)
        kind = {"kind": "kitchen", "columns": 1}
        if self.base["style"] not in ("flat", "shaker", "ramped"):
            kind["style"] = "flat"  # of drawers
        return self.room.against(wall, "drawer", at=at, **size | PLINTH | self.base | kind | values)

    def sink(
        self, wall: Wall | Line, at: float, width: float, holes: list[Hole], drains: list[str], **values: Any
    ) -> None:
        """Place a base unit and a sink that hangs in the worktop over it, and add the hole of the sink.

        A drainer may be at the sides `drains`; `values` are other parameters of the sink.
        """
        self.unit(wall, at, width, doors=True, top="rails", shelves=0)
        fit = {
            bowls: min((width - _HUNG_IN - between) / times, most)
            for bowls, (between, times, least, most) in _BOWLS.items()
            if (width - _HUNG_IN - between) / times >= least and values.get("bowls", bowls) == bowls
        }
        bowls = self.choice(*fit)
        sink: dict[str, Any] = {
            "style": "inset", "stand": "none", "bowls": bowls, "width": fit[bowls], "deep": _BOWL,
            "drainer": self.choice("none", *drains), **values,
        }  # fmt: skip
        made = self.room.draw("sink", name="sink", **sink)
        top = made.parameters["rim"]
        below = [each.convex.bounds() for each in made.links[0].colliders if each.label == "bowl"]
        below = [each for each in below if each[0, 2] < top - 0.01]
        (x0, y0, _), (x1, y1, _) = np.min(below, axis=0)[0], np.max(below, axis=0)[1]
        x = at + 0.5 * (width - x0 - x1)
        holes.append((x + x0 - 0.002, x + x1 + 0.002, y0 - _TAP - 0.002, y1 - _TAP + 0.002))
        self.let_in(wall, "sink", (x, -_TAP, OVER + STANDING - top), sink)

    def hang(self, wall: Wall | Line, at: float, width: float, hinges: str = "") -> Placement:
        """Hang a wall unit; a single door has its hinges at a side, or else where it meets a corner."""
        size: dict[str, Any] = {"kind": "wall", "width": width, "height": 0.72, "depth": 0.33, "top": "flush"}
        doors: dict[str, Any] = {"swing": SWING, "doors": 2 if width > 0.6 else 1}
        doors |= {"hand": hinges} if hinges else self._hinges(wall, at, width)
        return self.room.against(wall, "cabinet", at=at, z=1.45, **self.fronts | size | doors)

    def _hinges(self, wall: Wall | Line, at: float, width: float) -> dict[str, Any]:
        """Return the hinge side of a single door in a corner: its handle is away from the other wall."""
        ends = {"left": at, "right": self.room.frame(wall)[1] - at - width}
        corners = [side for side in ends if isinstance(wall, str) and side != wall]  # no front wall
        near = next((side for side in corners if ends[side] < _CORNER), None)
        return {} if near is None else {"hand": near}

    def let_in(
        self, wall: Wall | Line, category: str, place: tuple[float, float, float], values: dict[str, Any]
    ) -> Placement:
        """Place an asset, such as a faucet, with its origin at a place in the frame of a wall."""
        pose = self.room.frame(wall)[0] @ translation(np.array(place))
        return self.room.add(category, pose, name=category, **values)


def _style(room: Scene, grip: str) -> tuple[dict[str, Any], Material]:
    """Return the look, style and finish of the fronts from one base unit, and the finish."""
    model = room.draw("cabinet", kind="base", stand="plinth", top="flush", grip=grip)
    found = {each.name: each for each in model.materials}
    style = {key: model.parameters[key] for key in ("look", "style", "grip")}
    if (metal := found.get(model.parameters["metal"])) is not None:  # not where a door has no metal
        style["metal"] = metal
    finish = found[model.parameters["finish"]]
    return style | {"finish": finish, "shell": "same"}, finish


# bodies without joints, in the coordinates of a wall: x along it, y into it; the front is at -y


def worktop(
    outline: list[tuple[float, float]], low: float, high: float, finish: Material, holes: list[Hole]
) -> ag.Body:
    """Make a worktop of a convex outline between two heights, with holes."""
    slab = ag.extrude(ag.polygon(outline), high - low, bevel=0.002).at(z=(low + high) / 2)
    for x0, x1, y0, y1 in holes:
        slab = slab - ag.Region((x0, x1), (y0, y1), (low - 0.01, high + 0.01)).box()
    return ag.part(slab, "worktop", finish)
