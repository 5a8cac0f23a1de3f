"""Names, sites and regions that RoboCasa's classes of fixtures look for.

Each class of `robocasa.models.fixtures` finds what it turns, fills and watches by fixed names: joints such
as `door_joint`, geoms such as `start_button`, sites such as `burner_on_front_left`, boxes such as `reg_tray`.
The tables below give these names for artgen's categories. They were read from the source of RoboCasa at
0c81ff9, and of its ovens, sinks and dishwashers at 8f3c96e.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array, FrozenArrays
from artgen.asset import Asset, Link
from artgen.asset.joint import JointKind
from artgen.colliders import Convex
from artgen.export.layouts.robocasa.regions import Grid, interiors

_GAPS = (0.008, 0.012, 0.018, 0.027)  # between parts of the marks of one burner [m]
_LEAST, _ROUND = 0.045, 1.5  # least size of a burner [m], and its greatest length over its width
_COLUMN = 0.03  # burners of a column differ by less from left to right [m]
_SHARE = 0.8  # share of the width of a link that the region above it has
_FLAME = (0.06, 0.001)  # radius and half height of the site of a burner that is on [m]
_STREAM = 0.004  # radius of a stream of water or coffee [m]
_WALL = 0.04  # least width of the wall between two basins [m]
_CUP = 0.08  # least length of a stream of coffee [m]
_ROWS = ("front", "rear")
_SIDES = {1: ("center",), 2: ("left", "right"), 3: ("left", "center", "right")}
_BURNERS = ("burner", "zone", "coil")  # labels of what heats pans
_POINTS = 9  # points per side at which the floor of a link is looked for
_LONG = 0.9  # share of the longest piece of a carriage from which a piece is the floor of a slot
_DIGITS = 12  # keys of a microwave with digits


@dataclass(frozen=True, eq=False)
class Site(FrozenArrays):
    """A site in the body of a link; one of the base is in the body of the object."""

    name: str
    link: str
    place: Array  # in asset coordinates at rest, shape (3,) [m]
    size: tuple[float, float]  # radius and half height of a cylinder [m]
    rgb: str


@dataclass
class Fixture:
    """What RoboCasa looks for in one asset: new names by those of the asset, sites and regions."""

    rooms: Sequence[Array]  # boxes of its interior, each of shape (2, 3) [m]
    joints: dict[str, str] = field(default_factory=dict)
    links: dict[str, str] = field(default_factory=dict)
    geoms: dict[str, str] = field(default_factory=dict)
    sites: list[Site] = field(default_factory=list)
    regions: dict[str, Array] = field(default_factory=dict)  # boxes in the asset's frame, shape (2, 3) [m]

    def name_parts(self, asset: Asset, parts: "_Parts") -> None:
        """Name the joints, and where RoboCasa asks for it the bodies, of the links of a name."""
        links = called(asset, parts.link, upwards=parts.upwards)
        names = parts.names.get(len(links)) or parts.names.get(0, ())
        for number, link in enumerate(links):
            if not names or (number >= len(names) and "{}" not in names[0]):
                continue
            name = names[min(number, len(names) - 1)].format(number)
            for joint in asset.joints:
                if joint.child == link.name and joint.kind == parts.kind and not joint.locked:
                    self.joints[joint.name] = name
                    if parts.body:
                        self.links[link.name] = parts.body.format(number)


@dataclass(frozen=True)
class _Parts:
    """Names of the joints of the links of one name."""

    link: str  # name of the links, without their numbers
    names: Mapping[
        int, tuple[str, ...]
    ]  # by the number of such links, 0 for any; `{}` is the number of a link
    kind: JointKind = "revolute"  # of the joints
    upwards: bool = False  # whether the links are counted upwards, otherwise from left to right
    body: str = ""  # name of their bodies; empty if they keep theirs


_DOOR = _Parts("door", {1: ("door_joint",)})
_RACKS = _Parts("rack", {0: ("rack{}_joint",)}, "prismatic", upwards=True, body="rack{}")

_PARTS: Mapping[str, Sequence[_Parts]] = {
    "cabinet": (_Parts("door", {1: ("doorhinge",), 2: ("leftdoorhinge", "rightdoorhinge")}),),
    "dishwasher": (_DOOR, _RACKS),
    "drawer": (_Parts("drawer", {1: ("slidejoint",)}, "prismatic"),),
    "faucet": (_Parts("spout", {1: ("spout_joint",)}),),
    "kettle": (_Parts("lid", {1: ("lid_joint",)}), _Parts("switch", {1: ("switch_joint",)})),
    "microwave": (_Parts("door", {1: ("microjoint",)}),),
    "oven": (_DOOR, _RACKS),
    "refrigerator": (
        _Parts("door", {0: ("fridge_door{}_joint",)}),
        _Parts("freezer_door", {0: ("freezer_door{}_joint",)}),
    ),
    "sink": (_Parts("spout", {1: ("spout_joint",)}),),
    "stand_mixer": (
        _Parts("head", {1: ("head_joint",)}),
        _Parts("bowl", {1: ("bowl_joint",)}),
        _Parts("knob", {1: ("knob_speed_joint",)}),
        _Parts("button", {1: ("button_head_lock_joint",)}, "prismatic"),
    ),
    "toaster_oven": (_DOOR, _RACKS),
    "toaster": (
        _Parts("lever", {0: ("lever{}_joint",)}, "prismatic"),
        _Parts("knob", {0: ("knob_doneness{}_joint",)}),
        _Parts("button", {0: ("button_cancel{}_joint",)}, "prismatic"),
    ),
}


def fixture(asset: Asset, rooms: Sequence[Array]) -> Fixture:
    """Return what RoboCasa looks for in an asset with boxes of its interior, each of shape (2, 3) [m]."""
    found = Fixture(rooms)
    for parts in _PARTS.get(asset.category, ()):
        found.name_parts(asset, parts)
    for add in _MORE.get(asset.category, ()):
        add(asset, found)
    return found


def called(asset: Asset, name: str, *, upwards: bool = False) -> list[Link]:
    """Return the moving links of a name, numbered or not, from left to right, or upwards."""
    order = (2, 0, 1) if upwards else (0, 1, 2)
    links = [link for link in asset.links[1:] if re.fullmatch(f"{name}(_left|_right|_[0-9]+)*", link.name)]
    return sorted(links, key=lambda link: [round(float(link.bounds()[:, axis].mean()), 4) for axis in order])


def _fridge(asset: Asset, found: Fixture) -> None:
    """Add the interior behind each door: RoboCasa tells cold and frozen regions by their names."""
    doors = [("fridge", link) for link in called(asset, "door")]
    doors += [("freezer", link) for link in called(asset, "freezer_door")]
    for room in found.rooms:
        seen = [(_overlap(room, link.bounds()), name) for name, link in doors]
        most, name = max(seen, default=(0.0, ""))
        if most > 0.0:
            number = sum(each.startswith(name) for each in found.regions)
            found.regions[f"{name}{number}"] = room


def _overlap(first: Array, second: Array) -> float:
    """Return the area that two boxes share, seen from the front [m2]."""
    sides = np.minimum(first[1], second[1]) - np.maximum(first[0], second[0])
    return float(max(sides[0], 0.0) * max(sides[2], 0.0))


def _racks(asset: Asset, found: Fixture) -> None:
    for link, name in found.links.items():
        found.regions[name] = room_above(asset, asset.link(link))


def _oven(asset: Asset, found: Fixture) -> None:
    dials = _dials(asset)
    burners = _stove(asset, found, dials)
    for name, link in zip(("temp", "time"), dials[burners:], strict=False):
        _name_turn(asset, link, f"knob_{name}_joint", found)


def _knobs(asset: Asset, found: Fixture) -> None:
    dials = _dials(asset)
    for name, link in zip(_KNOBS.get(len(dials), ()), dials, strict=False):
        _name_turn(asset, link, f"knob_{name}_joint", found)


def _bowl(asset: Asset, found: Fixture) -> None:
    for link in called(asset, "bowl"):
        found.regions["bowl"] = room_above(asset, link)


def _microwave(asset: Asset, found: Fixture) -> None:
    """Add the room on the plate, and the keys: the last one starts, the one on its left or below 7 stops."""
    for link in called(asset, "plate"):
        found.regions["tray"] = room_above(asset, link)
    keys = [link for link in asset.links if link.name.startswith("key_")]
    if len(keys) > 1:
        stop = keys[-3] if len(keys) >= _DIGITS else keys[-2]
        found.geoms[f"{keys[-1].name}_collider_0"] = "start_button"
        found.geoms[f"{stop.name}_collider_0"] = "stop_button"


def _cooktop(asset: Asset, found: Fixture) -> None:
    _stove(asset, found, _dials(asset))


def _stove(asset: Asset, found: Fixture, dials: Sequence[Link]) -> int:
    """Add the sites of the burners and name their dials; return the number of burners."""
    places = _burner_places(asset, len(dials))
    columns = [list(column) for column in _split(places, _COLUMN)]
    if len(columns) > max(_SIDES) or any(len(column) > len(_ROWS) for column in columns):
        return len(places)
    names = []
    for column, side in zip(columns, _SIDES.get(len(columns), ()), strict=True):
        column.sort(key=lambda place: place[1])
        names += [(f"{row}_{side}" if len(column) > 1 else side, place)
                  for row, place in zip(_ROWS, column, strict=False)]  # fmt: skip
    base = asset.links[0]
    for (name, (x, y)), dial in zip(names, dials, strict=False):
        top = _top(asset, x, y)
        for site in (f"burner_on_{name}", f"burner_{name}_place_site"):
            found.sites.append(Site(site, base.name, np.array([x, y, top]), _FLAME, "1 0.35 0.1"))
        _name_turn(asset, dial, f"knob_{name}_joint", found)
    return len(places)


def _burner_places(asset: Asset, dials: int) -> list[tuple[float, float]]:
    """Return the middles of the burners from left to right, from what is seen of them [m]."""
    # dashes of a zone are joined over longer and longer gaps until each burner has a dial
    found = [each.mesh.vertices[:, :2] for each in asset.links[0].surfaces if each.label in _BURNERS]
    for gap in _GAPS if found else ():
        boxes = _clusters(np.concatenate(found), gap)
        sizes = np.array([box[1] - box[0] for box in boxes])
        if len(boxes) <= dials:
            apart = sizes.min() > _LEAST and (sizes.max(axis=1) < _ROUND * sizes.min(axis=1)).all()
            middles = [np.round(box.mean(axis=0), 6) for box in boxes]
            return sorted((float(x), float(y)) for x, y in middles) if apart else []
    return []


def _clusters(points: Array, gap: float) -> list[Array]:
    """Return boxes of points that are about a gap apart, without those whose middle is in a larger one."""
    from scipy.ndimage import label

    cells = np.floor(points / gap).astype(int)
    cells -= cells.min(axis=0)
    marked = np.zeros(cells.max(axis=0) + 1, dtype=bool)
    marked[tuple(cells.T)] = True
    numbers = label(marked, np.ones((3, 3)))[0][tuple(cells.T)]
    groups = [points[numbers == number] for number in range(1, numbers.max() + 1)]
    boxes = [np.array([group.min(axis=0), group.max(axis=0)]) for group in groups]
    result: list[Array] = []
    for box in sorted(boxes, key=lambda box: -float(np.prod(box[1] - box[0]))):
        middle = box.mean(axis=0)
        if not any(((each[0] <= middle) & (middle <= each[1])).all() for each in result):
            result.append(box)
    return result


def _split(places: Sequence[tuple[float, float]], apart: float) -> list[list[tuple[float, float]]]:
    """Return places from left to right in columns."""
    columns: list[list[tuple[float, float]]] = []
    for place in places:
        if columns and place[0] - columns[-1][-1][0] < apart:
            columns[-1].append(place)
        else:
            columns.append([place])
    return columns


def _toaster(asset: Asset, found: Fixture) -> None:
    """Name the floors of the slots, and add the room above each."""
    floors = []
    for link in asset.links[1:]:
        boxes = [
            (f"{link.name}_collider_{number}", collider.convex.bounds())
            for number, collider in enumerate(link.colliders)
            if collider.label == "carriage"
        ]
        longest = max((float((box[1] - box[0])[:2].max()) for _, box in boxes), default=0.0)
        floors += [each for each in boxes if (each[1][1] - each[1][0])[:2].max() > _LONG * longest]
    if len(floors) not in _SLOTS:
        return
    across = int(np.argmin((floors[0][1][1] - floors[0][1][0])[:2]))
    floors.sort(key=lambda each: float(each[1][0, across]))
    for slot, (name, box) in zip(_SLOTS[len(floors)], floors, strict=True):
        found.geoms[name] = f"{slot}_floor"
        half = np.maximum((box[1] - box[0]) / 2.0, _SLOT / 2.0)
        room = box.mean(axis=0) + [-half, half]
        room[:, 2] = box[1, 2], asset.links[0].bounds()[1, 2]
        found.regions[slot] = np.round(room, 6)


def _tap(asset: Asset, found: Fixture) -> None:
    """Name the joints of the first handle, and add the water below the outlet."""
    handles = called(asset, "handle")
    for joint in asset.joints:
        if handles and joint.child == handles[0].name and joint.kind == "revolute":
            both = sum(each.child == joint.child and each.kind == "revolute" for each in asset.joints) > 1
            turns = both and joint.name.startswith("handle_turn")
            found.joints[joint.name] = "handle_temp_joint" if turns else "handle_joint"
    for link in asset.links:
        outlets = [each.mesh.vertices for each in link.surfaces if each.label == "aerator"]
        if outlets:
            points = np.concatenate(outlets)
            x, y, _ = (points.min(axis=0) + points.max(axis=0)) / 2.0
            low = float(points[:, 2].min())
            half = max((low - asset.bounds()[0, 2]) / 2.0, _STREAM)
            place = np.array([x, y, low - half])
            spouts = called(asset, "spout")
            holder = spouts[0].name if spouts else ""
            found.sites.append(Site("water", holder, place, (_STREAM, half), "0.5 0.7 1"))
            return


def _basins(asset: Asset, found: Fixture) -> None:
    """Add the basins; rooms to the left and right of a spout are one basin, one below is a cabinet."""
    basins: list[Array] = []
    bowls = [each.convex.bounds()[0, 2] for each in asset.links[0].colliders if each.label == "bowl"]
    rooms = interiors(asset, min(bowls)) if bowls else found.rooms
    for room in sorted(rooms, key=lambda room: float(room[0, 0])):
        if basins and room[0, 0] - basins[-1][1, 0] < _WALL:
            basins[-1] = np.array([np.minimum(basins[-1][0], room[0]), np.maximum(basins[-1][1], room[1])])
        else:
            basins.append(room)
    names = {1: ("basin",), 2: ("basin_left", "basin_right")}.get(len(basins), ())
    found.regions.update(zip(names, basins, strict=False))


def _coffee(asset: Asset, found: Fixture) -> None:
    """Name the first button, and add the place of the cup and the stream of coffee."""
    for link in called(asset, "button")[:1]:
        found.geoms[f"{link.name}_collider_0"] = "start_button"
    base = asset.links[0]
    marks = [each.convex.bounds() for each in base.colliders if each.label in ("spout", "group", "plate")]
    trays = called(asset, "drip_tray")
    if not marks:
        return
    x, y, _ = np.mean([box.mean(axis=0) for box in marks], axis=0)
    holders = trays[0].colliders if trays else [each for each in base.colliders if each.label == "plate"]
    spans = [span for each in holders if (span := _span(each.convex, x, y))]
    floor = max((span[1] for span in spans), default=float(holders[0].convex.bounds()[1, 2]))
    found.sites.append(Site("receptacle_place_site", base.name, np.array([x, y, floor]), _FLAME, "0 1 0"))
    half = max((min(box[0, 2] for box in marks) - floor) / 2.0, _CUP / 2.0)
    place = np.array([x, y, floor + half])
    found.sites.append(Site("coffee_liquid", base.name, place, (_STREAM, half), "0.25 0.13 0.05"))


def _dials(asset: Asset) -> list[Link]:
    """Return the dials in the order of their author: first those of the burners."""
    return [link for link in asset.links[1:] if re.fullmatch(r"(burner_)?dial_\d+", link.name)]


def _name_turn(asset: Asset, link: Link, name: str, found: Fixture) -> None:
    for joint in asset.joints:
        if joint.child == link.name and joint.kind == "revolute" and not joint.locked:
            found.joints[joint.name] = name


def room_above(asset: Asset, link: Link) -> Array:
    """Return the box above the floor of a link and below what is over it, shape (2, 3) [m]."""
    low, high = link.bounds()
    middle, half = (low + high) / 2.0, _SHARE * (high - low) / 2.0
    box = np.array([middle - half, middle + half])
    box[0, 2] = np.median([_lowest(link, x, y) for x, y in _points(box)])
    box[1, 2] = asset.bounds()[1, 2]
    others = [each.name for each in asset.links if each.name != link.name]
    grid = Grid(box)
    taken = np.array(grid.occupied(asset, {}, others).any(axis=(0, 1)))
    levels = grid.origin[2] + grid.step * np.arange(len(taken))
    above = levels[taken & (levels > high[2])]
    box[1, 2] = max(float(high[2]), float(above.min()) if len(above) else 0.0)
    return np.round(box, 6)


def _points(box: Array) -> list[tuple[float, float]]:
    x, y = (np.linspace(box[0, axis], box[1, axis], _POINTS) for axis in (0, 1))
    return [(float(a), float(b)) for a in x for b in y]


def _lowest(link: Link, x: float, y: float) -> float:
    """Return the upper side of the lowest collider of a link at a point, or the link's lower side."""
    spans = [span for each in link.colliders if (span := _span(each.convex, x, y))]
    return min(spans)[1] if spans else float(link.bounds()[0, 2])


def _top(asset: Asset, x: float, y: float) -> float:
    """Return the height at which a pan stands over a point: the greatest around it [m]."""
    around = [(x + dx, y + dy) for dx in (-_FLAME[0], 0.0, _FLAME[0]) for dy in (-_FLAME[0], 0.0, _FLAME[0])]
    spans = [
        span
        for link in asset.links
        for each in link.colliders
        for point in around
        if (span := _span(each.convex, *point))
    ]
    return round(max(span[1] for span in spans), 6)


def _span(convex: Convex, x: float, y: float) -> tuple[float, float] | None:
    """Return the heights between which a vertical line is inside a convex piece, None if it misses it."""
    low, high = (float(end[0]) for end in convex.faces.spans(np.array([[x, y]])))
    return (low, high) if low < high else None


_SLOT = np.array([0.02, 0.02, 0.0])
"""Least size of the region of a slot [m]."""

_SLOTS = {2: ("slotL", "slotR"), 4: ("sideL_slotL", "sideL_slotR", "sideR_slotL", "sideR_slotR")}
"""Names of the slots of a toaster by their number; RoboCasa knows no others."""

_KNOBS = {2: ("temp", "time"), 3: ("temp", "function", "time"), 4: ("temp", "function", "doneness", "time")}
"""What the dials of a toaster oven set, by their number."""

_Adder = Callable[[Asset, Fixture], None]

_MORE: Mapping[str, Sequence[_Adder]] = {
    "coffee_machine": (_coffee,),
    "cooktop": (_cooktop,),
    "dishwasher": (_racks,),
    "faucet": (_tap,),
    "microwave": (_microwave,),
    "oven": (_oven, _racks),
    "refrigerator": (_fridge,),
    "sink": (_tap, _basins),
    "stand_mixer": (_bowl,),
    "toaster": (_toaster,),
    "toaster_oven": (_racks, _knobs),
}
"""What goes beyond names of joints, by category."""
