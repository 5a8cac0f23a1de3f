"""Bathrooms, offices, corners of workshops, and halls, each drawn from a seed."""

from typing import Any

from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.errors import ParameterError
from artgen.materials import material
from artgen.scene import fixtures
from artgen.scene.furnish import DOORWAY, FRONT, Furnisher, Span, drawn, width_of
from artgen.scene.room import GAP, Wall

_BATHS: tuple[Span, Span] = ((2.3, 3.0), (1.9, 2.6))
_OFFICES: tuple[Span, Span] = ((2.8, 3.8), (2.4, 3.2))
_WORKSHOPS: tuple[Span, Span] = ((2.4, 3.4), (2.0, 2.8))
_HALLS: tuple[Span, Span] = ((1.9, 2.6), (2.6, 3.6))
"""Widths and depths of drawn rooms [m]; the least values are those of rooms that are asked for."""

_DESK = 0.70  # height of what stands under a desk [m]
_BOX: tuple[str, dict[str, Any]] = ("box", {"size": "small", "style": "tuck_end"})
_MILL: tuple[str, dict[str, Any]] = ("pepper_grinder", {})
_SHADES = ("desk", "architect", "led_bar", "mushroom")


def _checked(
    kind: str, size: tuple[float | None, float | None], spans: tuple[Span, Span]
) -> tuple[float | None, float | None]:
    """Return a size that is not too small for a room."""
    for side, given, (least, _) in zip(("wide", "deep"), size, spans, strict=True):
        if given is not None and given < least:
            raise ParameterError(
                f"a {kind} is at least {least:g} m {side}: {least - given:.3f} m are missing"
            )
    return size


def bathroom(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return a bathroom, proven free of collisions in all states of all its joints.

    It has a vanity with a sink and a faucet, a mirror, wall units, a washing machine or dryer, a tall cabinet
    or drawers, a soap dispenser, a waste bin, a window and a door.

    Args:
        seed: Seed of the room and of all assets.
        width: Length of the back wall [m]; drawn by default.
        depth: Depth of the room [m]; drawn by default.
        detail: Level of detail of the assets.

    Raises:
        ParameterError: The room is too small; the message has the length that is missing.
        AssetError: No draw is free of collisions.
    """
    size = _checked("bathroom", (width, depth), _BATHS)

    def draw(attempt: int) -> Asset:
        tops = ("marble", "granite", "oak", "black_granite")
        here = Furnisher(
            "bathroom", seed, attempt, size, _BATHS, detail,
            floors=("granite", "marble", "oak", "ash"), worktops=tops,
        )  # fmt: skip
        room, width, depth = here.room, here.width, here.depth
        machine: dict[str, Any] = {"kind": here.choice("front", "front", "dryer"), "size": "full"}
        wide = width_of(room.draw("washing_machine", name="washing_machine", **machine))
        flip = here.choice(True, False)  # whether the machine is on the left
        vanity = min(here.uniform(0.9, 1.3), width - wide - 0.2)
        start = width - 0.05 - vanity if flip else 0.05
        holes: list[fixtures.Hole] = []
        sink = min(vanity, 0.7)
        spare = vanity - sink - GAP
        first = start if spare < 0.4 else start + (0.0 if flip else spare + GAP)
        here.sink("back", first, vanity if spare < 0.4 else sink, holes)
        if spare >= 0.4:
            here.unit("back", start + (sink + GAP if flip else 0.0), spare, doors=False, rows=3)
        outline = [(start, -FRONT), (start + vanity, -FRONT), (start + vanity, 0.0), (start, 0.0)]
        top = here.lay(outline, holes, "back")
        at = start - 0.04 - wide if flip else start + vanity + 0.04
        room.against("back", "washing_machine", at=at, name="washing_machine", **machine)
        middle = first + (vanity if spare < 0.4 else sink) / 2.0
        mirror = (middle - 0.3, middle + 0.3)
        here.board("mirror", "back", mirror, (-0.022, -0.002), (1.35, 2.05), material("chrome"))
        if spare >= 0.4:
            here.hang("back", start + (sink + GAP if flip else 0.0), spare)
        here.hang("back", at, wide)
        room.on(top, "soap_dispenser", at=0.04 if flip else 0.96, deep=0.2, free=True)
        sides: tuple[Wall, Wall] = ("left", "right")
        side, other = sides if flip else sides[::-1]
        here.door(side, 0.05 if side == "left" else depth - DOORWAY)
        here.window(other, depth * 0.5, z=1.3, width=0.7)
        bin_: dict[str, Any] = {"style": "pedal", "size": "small"}
        room.against(other, "trashcan", at=0.15 if other == "left" else depth - 0.5, **bin_)
        return here.build()

    return drawn(f"bathroom {seed}", draw)


def office(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return an office, proven free of collisions in all states of all its joints.

    It has a desk on files, a lamp, cabinets, boxes, a waste bin, a window and a door. The arguments and
    errors are those of `bathroom`.
    """
    size = _checked("office", (width, depth), _OFFICES)

    def draw(attempt: int) -> Asset:
        tops = ("oak", "walnut", "beech", "ash", "maple")
        here = Furnisher("office", seed, attempt, size, _OFFICES, detail, under=_DESK, worktops=tops)
        room, width, depth = here.room, here.width, here.depth
        flip = here.choice(True, False)
        desk = here.uniform(1.4, min(1.9, width - 1.0))
        start = width - 0.12 - desk if flip else 0.12
        files: dict[str, Any] = {"kind": "file", "height": _DESK, "rows": 2, "columns": 1}
        look = here.choice("steel", "wood")
        if look == "wood":
            files = {
                **here.base,
                "kind": "bedside",
                "height": _DESK,
                "rows": 3,
                "stand": "plinth",
                "depth": 0.44,
            }
            files["style"] = files["style"] if files["style"] in ("flat", "shaker", "ramped") else "flat"
            del files["shell"]
        first = width_of(room.draw("drawer", name="files", **files, width=0.42))
        both = here.choice(True, False)
        room.against("back", "drawer", at=start, name="files", **files, width=0.42)
        last = start + desk - first
        if both:
            room.against("back", "drawer", at=last, name="files_right", **files, width=0.42)
        else:
            here.board("side", "back", (last + first - 0.03, last + first), (-0.6, -0.02), (0.0, _DESK))
        ends = (start - 0.02, start + desk + 0.02)
        outline = [(ends[0], -0.70), (ends[1], -0.70), (ends[1], 0.0), (ends[0], 0.0)]
        top = here.lay(outline, [], "back")
        lamp = ("lamp", {"style": here.choice(*_SHADES)})
        here.stand(top, 0.12 if flip else 0.88, 0.0, lamp, ("lamp", {"style": "mushroom"}), _BOX)
        here.stand(top, 0.8 if flip else 0.2, 0.2, ("box", {"size": "small", "style": "mailer"}), _BOX)
        rest = width - desk - 0.3
        kind = "tall" if here.draw.random() < 0.6 else "chest"
        at = 0.06 if flip else width - rest + 0.02
        wide = min(rest - 0.1, 0.9)
        if kind == "tall":
            values: dict[str, Any] = {
                "kind": "tall",
                "doors": 2 if wide > 0.64 else 1,
                "width": min(wide, 0.6) if wide <= 0.64 else wide,
            }
            tall: dict[str, Any] = {
                "height": 1.9,
                "stand": "plinth",
                "depth": 0.42,
                "swing": 1.5,
                **here.base,
                "grip": "bar",
            }
            room.against("back", "cabinet", at=at, **tall | values)
        else:
            chest = room.against("back", "drawer", at=at, kind="file", rows=3, columns=1)
            here.stand(chest, 0.5, 0.3, _BOX, _MILL)
        here.window("back", start + desk / 2.0, z=1.15, width=1.2, height=1.0)
        side: Wall = "left" if flip else "right"
        here.door("right" if flip else "left", depth - DOORWAY if flip else 0.05)
        low: dict[str, Any] = {
            "kind": "base",
            "height": 0.8,
            "stand": "plinth",
            "depth": 0.36,
            "top": "worktop",
            "swing": 1.5,
        }
        board: dict[str, Any] = {**here.base, **low, "width": 0.8, "doors": 2}
        place = 0.2 if side == "left" else depth - 1.1
        shelf = room.against(side, "cabinet", at=place, name="sideboard", **board)
        here.stand(shelf, 0.3, 0.3, ("box", {"size": "small", "style": "gift"}), _BOX, _MILL)
        room.against("right" if flip else "left", "trashcan", at=0.9 if flip else depth - 1.25, style="swing")
        return here.build()

    return drawn(f"office {seed}", draw)


def workshop(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return the corner of a workshop, proven free of collisions in all states of all its joints.

    It has a bench on drawers and cabinets, wall units, pliers, boxes, a lamp, a waste bin and a window. The
    arguments and errors are those of `bathroom`.
    """
    size = _checked("workshop", (width, depth), _WORKSHOPS)

    def draw(attempt: int) -> Asset:
        tops = ("oak", "beech", "maple", "plywood")
        here = Furnisher(
            "workshop",
            seed,
            attempt,
            size,
            _WORKSHOPS,
            detail,
            floors=("granite", "plywood", "oak"),
            worktops=tops,
        )
        room, width, depth = here.room, here.width, here.depth
        span = width - 0.1
        count = max(round(span / 0.7), 2)
        unit = span / count - GAP
        holes: list[fixtures.Hole] = []
        window = here.draw.integers(count)
        for number in range(count):
            at = 0.05 + number * (unit + GAP)
            here.unit(
                "back",
                at,
                unit,
                doors=number % 2 == 1,
                **({} if number % 2 else {"rows": here.choice(3, 4, 5)}),
            )
            if number == window:
                here.window("back", at + unit / 2.0, width=min(unit, 1.0), z=1.25)
            elif abs(number - window) > 1 or unit > 0.62:
                here.hang("back", at, unit)
        x = (0.05, 0.05 + span - GAP)
        top = here.lay([(x[0], -FRONT), (x[1], -FRONT), (x[1], 0.0), (x[0], 0.0)], holes, "back")
        for number in range(here.choice(2, 3)):
            room.on(top, "plier", at=0.25 + 0.2 * number, deep=0.7, turn=here.uniform(-0.6, 0.6), free=True)
        here.stand(top, 0.85, 0.1, ("box", {"size": "small", "style": "mailer"}), _BOX)
        here.stand(top, 0.03, 0.0, ("lamp", {"style": "architect"}), ("lamp", {"style": "mushroom"}), _BOX)
        other: Wall = here.choice("left", "right")
        room.against(
            other, "trashcan", at=0.2 if other == "left" else depth - 0.6, style="swing", size="large"
        )
        return here.build()

    return drawn(f"workshop {seed}", draw)


def hall(
    seed: int = 0, *, width: float | None = None, depth: float | None = None, detail: DetailName = "full"
) -> Asset:
    """Return a hall with doors, proven free of collisions in all states of all its joints.

    It has an entrance at its end, two or three doors at its sides, a chest with a lamp, and a box. The
    arguments and errors are those of `bathroom`.
    """
    size = _checked("hall", (width, depth), _HALLS)

    def draw(attempt: int) -> Asset:
        here = Furnisher(
            "hall", seed, attempt, size, _HALLS, detail, floors=("oak", "walnut", "granite", "ash")
        )
        room, width, depth = here.room, here.width, here.depth
        here.door("back", (width - DOORWAY) / 2.0, use="exterior", opener=here.choice("lever", "knob"))
        here.door("left", depth - DOORWAY - 0.3)
        here.door("right", 0.3)
        if depth > 3.0 and here.choice(True, False):
            here.door("left", depth - 2.0 * DOORWAY - 0.5)
        values: dict[str, Any] = {
            "kind": "chest",
            "columns": 1,
            "rows": here.choice(3, 4),
            "width": 0.8,
            "depth": 0.40,
        }
        chest = room.against("right", "drawer", at=depth - 1.0, **values)
        here.stand(chest, 0.1, 0.0, ("lamp", {"style": "table"}), ("lamp", {"style": "mushroom"}), _BOX)
        here.stand(chest, 0.95, 0.4, _BOX, _MILL)
        mirror = (depth - 0.9, depth - 0.3)
        here.board("mirror", "right", mirror, (-0.022, -0.002), (1.45, 2.1), material("chrome"))
        return here.build()

    return drawn(f"hall {seed}", draw)
