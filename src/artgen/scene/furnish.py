"""What all rooms draw: size, floor, style of fronts, a door, and units under a worktop with their sink."""

from collections.abc import Callable
from typing import Any

import numpy as np

from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.errors import AssetError, ParameterError
from artgen.export.frames import translation
from artgen.materials import Material, material
from artgen.nodes.region import Region
from artgen.scene import fixtures
from artgen.scene.room import GAP, STANDING, Line, Placement, Scene, Wall

THICK = 0.035  # of worktops [m]
DEEP = 0.56  # of the carcass of base units [m]
FACE = GAP + DEEP + 0.021  # from the wall to the faces of doors [m]
FRONT = FACE + 0.02  # from the wall to the front edge of the worktop [m]
KICK, SETBACK = 0.10, 0.05  # height and setback of plinths [m]
PLINTH = {"stand_height": KICK, "setback": SETBACK}
SWING = 1.45  # of doors: wider, their handles would be before the drawers beside them [rad]
DOORWAY = 1.08  # of a wall that a door takes [m]
ATTEMPTS = 8  # draws before a room counts as infeasible
_SINK_DEEP = 0.2  # depth of a sink [m]
_WORKTOPS = ("granite", "black_granite", "marble", "oak", "walnut", "beech")
_GRIPS = ("bar", "bar", "knob", "cup")  # handles that doors and drawers have
_FLOORS = ("oak", "oak_flat_sawn", "ash", "granite", "walnut")

Span = tuple[float, float]


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
        under: Height of base units, below their worktop [m].
        floors: Names of materials of the floor.
        worktops: Names of materials of worktops.
    """

    def __init__(
        self,
        kind: str,
        seed: int,
        attempt: int,
        size: tuple[float | None, float | None],
        spans: tuple[Span, Span],
        detail: DetailName,
        *,
        under: float = 0.86,
        floors: tuple[str, ...] = _FLOORS,
        worktops: tuple[str, ...] = _WORKTOPS,
    ) -> None:
        self.kind, self.seed, self.attempt, self.under = kind, seed, attempt, under
        self.draw = np.random.default_rng((seed, attempt, len(kind)))
        (wide, deep), high = spans, self.uniform(2.4, 2.7)
        self.width, self.depth = size[0] or self.uniform(*wide), size[1] or self.uniform(*deep)
        floor, self.top = (material(self.choice(*names)) for names in (floors, worktops))
        self.room = Scene(
            f"{kind}_{seed}",
            seed=seed * ATTEMPTS + attempt,
            width=self.width,
            depth=self.depth,
            height=high,
            floor=floor,
            detail=detail,
        )
        self.fronts, self.finish = _style(self.room, self.choice(*_GRIPS))
        # only wall units are glazed
        self.base = self.fronts | ({"style": "shaker"} if self.fronts["style"] == "glazed" else {})
        self.apron = bool(self.draw.random() < 0.4)  # whether the front of a sink is seen

    @property
    def over(self) -> float:
        """Height of the worktop [m]."""
        return self.under + GAP + THICK

    def choice(self, *values: Any) -> Any:
        """Return one of the values."""
        return values[int(self.draw.integers(len(values)))]

    def uniform(self, low: float, high: float) -> float:
        """Return a length in a range, in whole millimetres [m]."""
        return round(float(self.draw.uniform(low, high)), 3)

    def build(self) -> Asset:
        """Return the room with what was placed in it."""
        return self.room.build(category=self.kind, seed=self.seed, attempt=self.attempt)

    def door(self, wall: Wall, at: float, **values: Any) -> Placement:
        """Set a door into a wall."""
        usual: dict[str, Any] = {
            "layout": "single",
            "use": "interior",
            "opens": "away",
            "stock": "standard",
            "height": 2.03,
        }
        return self.room.inset(wall, "door", at=at + 0.02, **usual | {"opener": "lever"} | values)

    def window(self, wall: Wall, middle: float, *, z: float = 1.32, **values: Any) -> Placement:
        """Set a window into a wall, its middle at a distance from the left end."""
        usual: dict[str, Any] = {
            "width": 0.9,
            "height": 0.85,
            "shutters": "none",
            "style": "sliding",
            "layout": "pair",
        }
        values = usual | values
        width = width_of(self.room.draw("window", **values))
        return self.room.inset(wall, "window", at=middle - 0.5 * width, z=z, **values)

    def board(
        self, label: str, wall: Wall | Line, x: Span, y: Span, z: Span, finish: Material | None = None
    ) -> Placement:
        """Add a board in the frame of a wall, by default with the finish of the fronts."""
        return self.room.slab(label, (x[0], y[0], z[0]), (x[1], y[1], z[1]), finish or self.finish, wall=wall)

    def lay(self, outline: list[Span], holes: list[fixtures.Hole], wall: Wall | Line | None) -> Placement:
        """Lay a worktop with holes, both in the frame of a wall."""
        low, high = self.under + GAP, self.over
        return self.room.fixture(
            "worktop", lambda: fixtures.worktop(outline, low, high, self.top, holes), wall=wall
        )

    def unit(
        self, wall: Wall | Line, at: float, width: float, *, doors: bool, high: float = 0.0, **values: Any
    ) -> Placement:
        """Place a base unit with drawers or doors."""
        size: dict[str, Any] = {"width": width, "height": high or self.under, "depth": DEEP, "top": "flush"}
        if doors:
            kind: dict[str, Any] = {
                "kind": "base",
                "stand": "plinth",
                "doors": 2 if width > 0.6 else 1,
                "swing": SWING,
            }
            return self.room.against(wall, "cabinet", at=at, **size | PLINTH | self.base | kind | values)
        kind = {"kind": "kitchen", "columns": 1}
        if self.base["style"] not in ("flat", "shaker", "ramped"):
            kind["style"] = "flat"  # of drawers
        return self.room.against(wall, "drawer", at=at, **size | PLINTH | self.base | kind | values)

    def hang(self, wall: Wall | Line, at: float, width: float, **values: Any) -> Placement:
        """Hang a wall unit."""
        size: dict[str, Any] = {"kind": "wall", "width": width, "height": 0.72, "depth": 0.33, "top": "flush"}
        doors = {"swing": SWING, "doors": 2 if width > 0.6 else 1}
        return self.room.against(wall, "cabinet", at=at, z=1.45, **self.fronts | size | doors | values)

    def stand(
        self,
        below: Placement,
        at: float,
        deep: float,
        *choices: tuple[str, dict[str, Any]],
        turn: float = 0.0,
    ) -> None:
        """Stand the first of several free objects that fits on something, each a category with parameters."""
        for number, (category, values) in enumerate(choices):
            try:
                self.room.on(below, category, at=at, deep=deep, turn=turn, free=True, **values)
            except ParameterError:
                if number == len(choices) - 1:
                    raise
            else:
                return

    def sink(self, wall: Wall | Line, at: float, width: float, holes: list[fixtures.Hole]) -> None:
        """Place a base unit with doors that is lower than others, and a sink over it with its faucet.

        The holes that the worktop needs are added to `holes`.
        """
        bottom = self.over - _SINK_DEEP - 0.004
        self.unit(wall, at, width, high=bottom - 0.002, doors=True)
        faucet: dict[str, Any] = {
            "style": self.choice("gooseneck", "gooseneck", "pull_down"), "deck_margin": 0.035,
            "deck_thickness": THICK, "surface": self.top,
        }  # fmt: skip
        low, high = self.room.draw("faucet", name="faucet", **faucet).links[0].bounds()
        middle, strip = at + width / 2.0, high[1] - low[1] + 0.05
        x = (at + 0.002, at + width - 0.002) if self.apron else (middle - 0.26, middle + 0.26)
        y = (-FRONT, -strip) if self.apron else (0.06 - FACE, -strip - 0.01)
        finish = material("ceramic" if self.apron else "stainless")
        region = Region(x, y, (bottom, self.over if self.apron else self.over + STANDING))
        wide, rim = (0.016, 0.0) if self.apron else (0.003, 0.012)
        self.room.fixture(
            "sink", lambda: fixtures.basin(region, wall=wide, finish=finish, rim=rim), wall=wall
        )
        # an apron ends the worktop at the front
        holes.append((x[0] - 0.001, x[1] + 0.001, y[0] - (0.05 if self.apron else 0.001), y[1] + 0.001))
        if not self.apron:
            top = (bottom + 0.001, self.under)
            self.board("panel", wall, (at, at + width), (-FACE + 0.001, -FACE + 0.02), top)
            for end in (at, at + width - 0.016):
                self.board("panel", wall, (end, end + 0.016), (-GAP - DEEP, -GAP), top)
        deck, side = high - low, middle - (high[0] - low[0]) / 2.0
        slack, back = 0.0004, -0.02
        holes.append((side - slack, side + deck[0] + slack, back - deck[1] - slack, back + slack))
        self.let_in(wall, "faucet", (side - low[0], back - high[1], self.under + GAP), faucet)

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
