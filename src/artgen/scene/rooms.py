"""Bathrooms, offices, living rooms, workshops and halls, each drawn from a seed; and all rooms by name."""

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from inspect import signature
from typing import Any, get_args, get_type_hints

import artgen as ag
from artgen._arrays import cached_property
from artgen._names import check_name
from artgen.asset import Asset
from artgen.asset.asset import DetailName, remember
from artgen.catalog import find
from artgen.errors import AssetError, InfeasibleError, ParameterError, nearest
from artgen.generator import Fixed, Parameter
from artgen.generator.generator import check_proof, checked_count
from artgen.generator.signature import RESERVED
from artgen.materials import Material, material
from artgen.nodes.handles import Float
from artgen.nodes.region import Region
from artgen.sampling import Distribution
from artgen.sampling.distributions import stream
from artgen.scene.furnish import DOORWAY, FRONT, PLINTH, Furnisher, Hole, Span, check_room, drawn, width_of
from artgen.scene.kitchens import kitchen
from artgen.scene.room import GAP, STANDING, Placement, Wall

_DESK = 0.70  # height of what stands under a desk [m]
_GIFT: dict[str, Any] = {"style": "gift", "closure": "lift", "size": "small"}
_CLOCK: dict[str, Any] = {"style": "mantel", "width": 0.21, "slender": 1.5, "top": "flat"}
_ROUND = 0.14  # radius of the corners of a bathtub [m]


def bathroom(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return a bathroom, proven free of collisions in all states of all its joints.

    It has a vanity with a sink and its tap, drawers, a mirror, wall units, a bathtub with a tap, a toilet or
    a washing machine or a dryer, a soap dispenser, a bottle, a waste bin, a window and a door.

    Args:
        seed: Seed of the room and of all assets.
        width: Length of the back wall [m]; drawn by default.
        depth: Depth of the room [m]; drawn by default.
        detail: Level of detail of the assets.

    Raises:
        ParameterError: The room is too small; the message has the length that is missing.
        AssetError: No draw is free of collisions.
    """
    return _room("bathroom", _bathroom, ((2.9, 3.5), (2.3, 2.9)), seed, (width, depth), detail)


def office(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return an office, proven free of collisions in all states of all its joints.

    It has a desk on drawers, a chair, a lamp, a laptop or a monitor, a tall cabinet, a sideboard with a globe
    or a clock, boxes, a waste bin, a window and a door. The arguments and errors are those of `bathroom`.
    """
    return _room("office", _office, ((2.9, 3.8), (2.6, 3.3)), seed, (width, depth), detail)


def living_room(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return a living room, proven free of collisions in all states of all its joints.

    It has one or two recliners with a side table before a screen, low units with a clock, a glass cabinet, a
    floor lamp, a fan, boxes, a bottle, a window and a door. The arguments and errors are those of `bathroom`.
    """
    return _room("living_room", _living_room, ((3.5, 4.3), (3.3, 4.0)), seed, (width, depth), detail)


def workshop(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return the corner of a workshop, proven free of collisions in all states of all its joints.

    It has a bench on drawers and cabinets, wall units, pliers, a cutter, a can of paint, a box, a waste bin,
    a window and a door. The arguments and errors are those of `bathroom`.
    """
    return _room("workshop", _workshop, ((2.4, 3.4), (2.0, 2.8)), seed, (width, depth), detail)


def hall(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return a hall with doors, proven free of collisions in all states of all its joints.

    It has an entrance at its end, two or three doors at its sides, a chest with a bottle and a box, and
    a mirror. The arguments and errors are those of `bathroom`.
    """
    return _room("hall", _hall, ((1.9, 2.6), (2.6, 3.6)), seed, (width, depth), detail)


def _room(
    kind: str,
    furnish: Callable[[Furnisher], None],
    spans: tuple[Span, Span],
    seed: int,
    size: tuple[float | None, float | None],
    detail: DetailName,
) -> Asset:
    """Return a room whose width and depth are not less than those that are drawn."""
    check_room(seed, size)
    for side, given, (least, _) in zip(("wide", "deep"), size, spans, strict=True):
        if given is not None and given < least:
            raise ParameterError(
                f"{kind} {seed}: it is at least {least:g} m {side}; {least - given:.3f} m are missing"
            )

    def draw(attempt: int) -> Asset:
        here = Furnisher(kind, seed, attempt, size, spans, detail)
        furnish(here)
        return here.build()

    return drawn(f"{kind} {seed}", draw)


def _bathroom(here: Furnisher) -> None:
    room, width, depth = here.room, here.width, here.depth
    washing: dict[str, Any] = {"kind": here.choice("front", "front", "dryer"), "size": "full", "swing": 1.7}
    corner, values = here.choice(("toilet", {}), ("washing_machine", washing))
    wide = width_of(room.draw(corner, name=corner, **values))
    flip = here.choice(True, False)  # whether the bathtub is on the left
    sides: tuple[Wall, Wall] = ("left", "right") if flip else ("right", "left")
    at = depth - 1.63 if flip else 0.01
    white = material("ceramic")
    room.fixture(
        "bathtub",
        lambda: _tub(Region((at, at + 1.62), (-0.72, -0.001), (STANDING, 0.56)), white),
        wall=sides[0],
    )
    tap: dict[str, Any] = {"style": "wall", "spout": "low", "stand": "none", "reach": 0.2}
    room.against(sides[0], "faucet", at=at + 0.65, z=0.66, **tap)
    # over the end that is away from the corner, where a hand is near its lock
    here.window(sides[0], at + (0.57 if flip else 1.05), width=0.9, height=0.6, z=1.3)
    spare = width - 0.85 - wide - 0.2
    vanity = min(here.uniform(1.02, 1.3), spare)
    start = 0.85 if flip else width - 0.85 - vanity
    sink, units = 0.6, vanity - 0.6 - GAP
    holes: list[Hole] = []
    first = start if flip else start + units + GAP
    beside = start + (sink + GAP if flip else 0.0)
    shape = "sharp" if here.sharp else "square"
    basin: dict[str, Any] = {"shell": white, "shape": shape, "tap": "gooseneck", "reach": 0.18}
    basin["height"] = here.uniform(0.26, 0.32)
    here.sink("back", first, sink, holes, [], bowls="single", **basin)
    here.unit("back", beside, units, doors=False)
    ends = (start, start + vanity)
    top = here.lay([(ends[0], -FRONT), (ends[1], -FRONT), (ends[1], 0.0), (ends[0], 0.0)], holes, "back")
    middle = first + sink / 2.0
    mirror = (middle - 0.28, middle + 0.28)
    here.board("mirror", "back", mirror, (-0.022, -0.002), (1.3, 2.0), material("chrome"))
    here.hang("back", beside, units)
    place = width - 0.1 - wide if flip else 0.1
    room.against("back", corner, at=place, name=corner, **values)
    if corner == "washing_machine":
        here.hang("back", place, wide)
    room.on(top, "soap_dispenser", at=0.95 if flip else 0.05, deep=0.25, free=True, style="bottle")
    room.on(top, "bottle", at=0.75 if flip else 0.25, deep=0.25, free=True, style="pump")
    here.door(sides[1], 0.0 if sides[1] == "left" else depth - DOORWAY)
    before = here.before(sides[0], 0.15)  # a lid needs space behind it
    room.against(before, "trashcan", at=0.1 if flip else depth - 0.4, style="pedal", size="small")


def _office(here: Furnisher) -> None:
    room, width, depth = here.room, here.width, here.depth
    flip = here.choice(True, False)  # whether the desk is on the right
    desk = here.uniform(1.4, min(1.8, width - 1.2))
    start = width - 0.1 - desk if flip else 0.1
    files: dict[str, Any] = {"kind": "file", "rows": 2, "columns": 1, "height": _DESK, "width": 0.42}
    if here.choice(True, False):
        style = here.base["style"] if here.base["style"] in ("flat", "shaker", "ramped") else "flat"
        files = here.base | files | PLINTH | {"kind": "kitchen", "rows": 3, "style": style, "depth": 0.5}
        files["top"] = "flush"
    ends = (start + desk - 0.42, start) if flip else (start, start + desk - 0.42)
    first = room.against("back", "drawer", at=ends[0], **files).asset
    finish = {each.name: each for each in first.materials}.get(first.parameters["finish"])
    if finish is not None:
        files["finish"] = finish  # both of one color
    if two := here.choice(True, False):
        room.against("back", "drawer", at=ends[1], **files)
    else:
        side = ends[1] if flip else ends[1] + 0.39
        here.board("side", "back", (side, side + 0.03), (-0.6, -GAP), (STANDING, _DESK))
    edges = (start - 0.02, start + desk + 0.02)
    deep = 0.70  # so that a hand is near the lock of the window
    outline = [(edges[0], -deep), (edges[1], -deep), (edges[1], 0.0), (edges[0], 0.0)]
    top = here.lay(outline, [], "back", _DESK)
    near, far = (0.95, 0.1) if flip else (0.05, 0.9)
    turn = 0.8 if flip else -0.8  # with the switch on its cord beside it, not behind it
    style, switch = here.choice(("mushroom", "button"), ("mushroom", "rocker"), ("table", "pull_chain"))
    room.on(top, "lamp", at=near, deep=0.1, turn=turn, free=True, style=style, switch=switch)
    _box_on(here, top, far, 0.25)
    if here.choice(True, False):
        room.on(top, "display", at=0.5, deep=0.25, style="tilting", inches=here.choice(22, 24), raised=0.08)
    else:
        room.on(top, "laptop", at=0.5, deep=0.97, free=True)  # a hand opens it before the edge
    room.on(top, "bottle", at=0.28 if flip else 0.72, deep=0.2, free=True, style=here.choice("screw", "flip"))
    here.window("back", start + desk / 2.0, z=1.2, width=1.2, height=1.0)
    tall = {
        "kind": "tall", "doors": 1, "width": 0.55, "depth": 0.42, "height": 1.9, "stand": "plinth",
        "hand": "left" if flip else "right", "swing": 1.5,
    }  # fmt: skip
    room.against("back", "cabinet", at=0.06 if flip else width - 0.61, **here.base | {"grip": "bar"} | tall)
    sides: tuple[Wall, Wall] = ("left", "right") if flip else ("right", "left")
    here.door(sides[1], 0.0 if sides[1] == "left" else depth - DOORWAY)
    low = {
        "kind": "base", "doors": 2, "width": 0.8, "depth": 0.36, "height": 0.8, "top": "worktop",
        "swing": 1.5,
    }  # fmt: skip
    board = room.against(
        sides[0], "cabinet", at=0.1 if flip else depth - 0.9, name="sideboard", **here.base | PLINTH | low
    )
    _box_on(here, board, 0.2, 0.5)
    if here.choice(True, False):
        room.on(board, "globe", at=0.85, deep=0.5, free=True, style="half", diameter=here.uniform(0.18, 0.24))
    else:
        room.on(board, "clock", at=0.85, deep=0.5, free=True, **_CLOCK)
    room.against(sides[1], "trashcan", at=0.85 if flip else depth - 1.17, style="open", size="medium")
    # a chair faces the desk; it turns, with its back tilted, clear of the desk and of open drawers
    knees = start + 0.5 * desk + (0.0 if two else -0.21 if flip else 0.21)
    here.stand("chair", "chair", knees - 0.5 * width, -1.85 if two else -1.3, sway=0.6, style="office")


def _living_room(here: Furnisher) -> None:
    room, width, depth = here.room, here.width, here.depth
    flip = here.choice(True, False)  # whether the door is on the left
    sides: tuple[Wall, Wall] = ("left", "right") if flip else ("right", "left")
    start, unit = 0.5 * width - 0.9, 0.9 - 0.5 * GAP
    low: dict[str, Any] = {"high": 0.56, "depth": 0.40}
    doors = here.unit("back", start, unit, doors=True, **low)
    drawers = here.unit("back", start + unit + GAP, unit, doors=False, rows=2, **low)
    room.on(doors, "bottle", at=0.05, deep=0.5, free=True, style="stopper")
    _box_on(here, drawers, 0.95, 0.5)
    room.on(drawers, "clock", at=0.1, deep=0.5, free=True, **_CLOCK)
    screen = (0.5 * width - 0.56, 0.5 * width + 0.56)
    here.board("screen", "back", screen, (-0.048, -0.012), (0.95, 1.58), material("black_glass"))
    # recliners face the screen, with the table beside them
    two = width > 3.8 and here.choice(True, True, False)
    middle = here.uniform(-0.05, 0.05)
    table = here.stand("table", "table", middle, -2.1, style="side", width=0.45, depth=0.45)
    _box_on(here, table, 0.5, 0.6)
    cover = here.choice("leather", "black_leather", "cream_leather", "velvet", "linen")
    looks = {"style": "recliner", "cover": cover, "arms": here.choice("block", "rolled", "wood")}
    for number, side in enumerate((-1, 1) if two else (1 if flip else -1,)):
        here.stand("chair", f"recliner_{number}", middle + side * 0.8, -2.0, sway=0.12, **looks)
    here.door(sides[0], 0.0 if sides[0] == "left" else depth - DOORWAY)
    here.window(sides[1], 0.5 * depth, z=1.0, width=1.3, height=1.2)
    tall = {
        "kind": "tall", "doors": 2, "width": 0.8, "depth": 0.38, "height": 1.9, "stand": "plinth",
        "style": "glazed", "swing": 1.5, "grip": "bar",
    }  # fmt: skip
    room.against(sides[0], "cabinet", at=depth - 1.7 if flip else 0.9, **here.base | tall)
    corner = (0.5 * width - 0.4) * (1 if sides[1] == "right" else -1)
    here.stand("fan", "fan", corner, -0.9, style="pedestal")
    here.stand("lamp", "lamp", -corner, -0.5, style="floor", switch="pull_chain")


def _workshop(here: Furnisher) -> None:
    room, width, depth = here.room, here.width, here.depth
    span = width - 0.1
    count = max(round(span / 0.7), 2)
    unit = span / count - GAP
    window = int(here.draw.integers(count))
    for number in range(count):
        at = 0.05 + number * (unit + GAP)
        here.unit("back", at, unit, doors=number % 2 == 1)
        if number == window:
            here.window("back", at + unit / 2.0, width=max(min(unit, 0.8), 0.6), height=0.85)
        elif abs(number - window) > 1 or unit > 0.6:
            here.hang("back", at, unit)
    ends = (0.05, 0.05 + span - GAP)
    outline = [(ends[0], -FRONT), (ends[1], -FRONT), (ends[1], 0.0), (ends[0], 0.0)]
    top = here.lay(outline, [], "back")
    for number in range(3):
        turn = here.uniform(-0.6, 0.6)
        with suppress(ParameterError):  # some pliers tip over
            room.on(top, "plier", at=0.25 + 0.25 * number, deep=0.6, turn=turn, free=True, sprung=False)
    _box_on(here, top, 0.03, 0.1)
    side: Wall = here.choice("left", "right")
    here.door(side, 0.0 if side == "left" else depth - DOORWAY)
    other: Wall = "right" if side == "left" else "left"
    room.against(other, "trashcan", at=0.1 if other == "left" else depth - 0.5, style="swing", size="large")
    room.on(top, "knife", at=0.9, deep=0.85, free=True, style="cutter")
    room.on(top, "bucket", at=0.97, deep=0.15, free=True, style="paint", litres=here.choice(1, 3))


def _hall(here: Furnisher) -> None:
    room, width, depth = here.room, here.width, here.depth
    opener, bolted = here.choice("lever", "knob"), here.choice(True, False)
    here.door("back", (width - DOORWAY) / 2.0, use="exterior", opens="towards", opener=opener, bolted=bolted)
    here.door("left", depth - DOORWAY - 0.3)
    if depth > 3.1 and here.choice(True, False):
        here.door("left", depth - 2.0 * DOORWAY - 0.6)
    here.door("right", 0.3)
    size = {
        "kind": "chest",
        "columns": 1,
        "width": 0.8,
        "depth": 0.4,
        "height": 0.8,
        "rows": here.choice(3, 4),
    }
    chest = room.against("right", "drawer", at=depth - 0.9, **size)
    room.on(chest, "bottle", at=0.15, deep=0.4, free=True, style=here.choice("stopper", "pump"))
    _box_on(here, chest, 0.9, 0.4)
    mirror = (depth - 0.8, depth - 0.2)
    here.board("mirror", "right", mirror, (-0.022, -0.002), (1.35, 2.0), material("chrome"))


def _box_on(here: Furnisher, below: Placement, at: float, deep: float) -> None:
    """Stand a small box with a lid as a free object."""
    here.room.on(below, "box", at=at, deep=deep, free=True, **_GIFT)


def _tub(region: Region, finish: Material) -> ag.Body:
    """Make a bathtub that fills a region, with round corners, sloping sides and a drain in its floor."""
    # its colliders are within its visible surface and have plane corners
    wall, x, y = 0.06, region.x.size / 2.0 - 0.06, region.y.size / 2.0 - 0.06
    floor, rim = region.z.low + 1.5 * wall, region.z.high
    levels = [(0.17, floor), (0.15, floor + 0.03), (0.01, rim - 0.03), (0.0, rim - 0.01), (0.0, rim + 0.01)]
    rings = [ag.rectangle(2.0 * (x - less), 2.0 * (y - 0.6 * less), radius=_ROUND) for less, _ in levels]
    ends = (floor - 0.002, rim + 0.01)
    octagons = [_octagon(x - less, y - 0.6 * less) for less in (0.165, -0.004)]
    middle = (region.x.mid, region.y.mid)
    skin = region.box(bevel=0.012) - ag.loft(rings, [z for _, z in levels]).at(*middle)
    core = region.shrink(x=0.001, y=0.001, z=0.001).box() - ag.hull(ag.loft(octagons, ends)).at(*middle)
    drain = ag.cylinder(0.033, 0.004, bevel=0.001).at(middle[0] - 0.4, middle[1], floor + 0.001)
    return ag.weld(
        ag.part(core, "basin", finish),
        ag.detail(skin, "basin", finish),
        ag.part(drain, "drain", ag.material("stainless")),
    )


def _octagon(x: ag.Scalar, y: ag.Scalar) -> ag.Profile:
    """Return a rectangle of half a width and half a depth without its corners."""
    cut = 0.58 * _ROUND
    right = [(x - cut, -y), (x, cut - y), (x, y - cut), (x - cut, y)]
    return ag.polygon([*right, *((-x, -y) for x, y in right)])


@dataclass(frozen=True)
class Room:
    """A kind of room by its name: `artgen.generate`, streams and plans take it like a category.

    Attributes:
        function: Draws the room from a seed.
        contents: Categories of the assets that such rooms may have.
        bodies: Labels of the bodies that belong to such rooms, other than floor and walls.
    """

    function: Callable[..., Asset]
    contents: tuple[str, ...]
    bodies: tuple[str, ...]

    @property
    def name(self) -> str:
        """Its name, which is the category of its assets."""
        return self.function.__name__

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """Labels of such rooms and of all assets in them, sorted."""
        inside = {label for each in self.contents for label in find(each).labels}
        return tuple(sorted({"floor", "wall", *self.bodies} | inside))

    @cached_property
    def parameters(self) -> dict[str, Parameter]:
        """Its parameters by name; by default a room draws them itself."""
        hints = get_type_hints(self.function)
        kinds = {name: get_args(hints[name])[0] for name in hints if name not in (*RESERVED, "return")}
        return {
            name: Parameter(name, Float, Fixed("m")) if kind is float else Parameter(name, kind, Fixed())
            for name, kind in kinds.items()
        }

    def sample(self, seed: int, *, overrides: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """Return the given parameters of a room; distributions are drawn.

        Raises:
            ParameterError: The seed is negative, or a parameter is unknown or has a value of another type.
        """
        checked_count("seed", seed)
        values = {}
        for name, value in (overrides or {}).items():
            if name not in self.parameters:
                raise ParameterError(
                    f"{self.name} has no parameter {name!r}.{nearest(name, self.parameters)}"
                )
            self.parameters[name].check_override(value, name)
            drawn = isinstance(value, Distribution)
            values[name] = value.draw(stream(seed, f"{self.name}/{name}"), {}) if drawn else value
        return values

    def generate(
        self,
        /,
        seed: int = 0,
        *,
        name: str = "",
        certify: Any = True,
        on_collision: str = "redraw",
        detail: DetailName = "full",
        **given: Any,
    ) -> Asset:
        """Return a room, which is drawn again until it is proven, whatever `certify` and `on_collision` are.

        Args:
            seed: Seed of the room and of all assets.
            name: Name of the room; by default its kind and the seed.
            certify: An option of categories, without effect.
            on_collision: An option of categories, without effect.
            detail: Level of detail of the assets.
            **given: Values or distributions by parameter name.

        Raises:
            ParameterError: The room has no such parameter, or is too small, or an option is for categories.
            InfeasibleError: No draw is free of collisions.
        """
        usual = signature(ag.Generator.generate).parameters
        options = {option: given.pop(option) for option in RESERVED if option in given}
        for option, value in options.items():
            if option not in usual or value != usual[option].default:
                raise ParameterError(
                    f"{option} = {value!r} is not allowed: {self.name} is a room, which is fixed to the "
                    "world and proven with the joints and colliders of its assets; leave the option out"
                )
        check_proof(certify, 0.0, on_collision)
        if name:
            check_name(name)
        values = self.sample(seed, overrides=given)
        try:
            room = self.function(seed, detail=detail, **values)
        except AssetError as error:
            raise InfeasibleError(str(error)) from error
        return remember(replace(room, name=name), room.certificate) if name else room


_FRONTS = ("cabinet", "door", "drawer", "window")  # in most rooms
ROOMS: Mapping[str, Room] = {
    each.name: each
    for each in (
        Room(
            bathroom,
            (*_FRONTS, "bottle", "faucet", "sink", "soap_dispenser", "toilet", "trashcan", "washing_machine"),
            ("basin", "mirror", "worktop"),
        ),
        Room(hall, ("bottle", "box", "door", "drawer"), ("mirror",)),
        Room(
            kitchen,
            (
                *(*_FRONTS, "bottle", "chair", "cooktop", "dishwasher", "kettle", "microwave", "oven"),
                *("pepper_grinder", "plier", "range_hood", "refrigerator", "sink", "toaster"),
            ),
            ("filler", "panel", "plinth", "worktop"),
        ),
        Room(living_room, (*_FRONTS, "bottle", "box", "chair", "clock", "fan", "lamp", "table"), ("screen",)),
        Room(
            office,
            (*_FRONTS, "bottle", "box", "chair", "clock", "display", "globe", "lamp", "laptop", "trashcan"),
            ("side", "worktop"),
        ),
        Room(workshop, (*_FRONTS, "box", "bucket", "knife", "plier", "trashcan"), ("worktop",)),
    )
}
"""Kinds of rooms by name."""
