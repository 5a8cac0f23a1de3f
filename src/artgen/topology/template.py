"""The template: a tree of slots for links, with their joints and numbers of colliders.

Links of assets are matched with slots from the base outwards. The children of a link get the slots that leave
the fewest links without one (the assignment problem), and among these the slots of equal names and labels.
"""

import json
import math
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from artgen._names import checked_path
from artgen.asset import Asset
from artgen.asset.joint import is_number
from artgen.asset.record import Record, json_text
from artgen.errors import AssetError, ExportError, ParameterError

_FORMAT = "artgen-topology-1"
# costs of a pair of a link and a slot
_NEW, _NAME, _LABEL = 1e6, 1e-2, 1e-3
_GROWTH = 1e-4  # of a collider that a slot lacks while a topology grows
_EXCESS = 1e3  # the same while an asset is padded


@dataclass(frozen=True)
class SlotJoint(Record):
    """One joint of a slot."""

    name: str  # canonical name
    kind: Literal["hinge", "slide", "fixed"]
    # canonical names of the joints that it follows, of different assets if there are several
    leaders: tuple[str, ...] = ()


@dataclass(frozen=True)
class Slot(Record):
    """A place for one link.

    Attributes:
        name: Canonical name of the link.
        parent: Name of the slot of its parent; empty for the base.
        label: Semantic label of the first link in it.
        joints: Its joints to the parent, the first nearest to the parent.
        colliders: Number of its colliders by kind.
    """

    name: str
    parent: str
    label: str
    joints: tuple[SlotJoint, ...]
    colliders: Mapping[str, int]

    @property
    def kinds(self) -> tuple[tuple[str, bool], ...]:
        """Kind of each joint, and whether it follows another; a link fits a slot of the same kinds."""
        return tuple((each.kind, bool(each.leaders)) for each in self.joints)

    def lacking(self, colliders: Mapping[str, int]) -> dict[str, int]:
        """Return how many colliders of each kind the slot lacks; a box may take the place of a hull."""
        more = {kind: n - self.colliders.get(kind, 0) for kind, n in colliders.items()}
        free = self.colliders.get("hull", 0) - colliders.get("hull", 0)
        more["box"] = more.get("box", 0) - max(free, 0)
        return {kind: n for kind, n in more.items() if n > 0}


@dataclass(frozen=True)
class Topology(Record):
    """A tree of slots that all assets of a batch fill.

    Attributes:
        slots: The slots, parents before their children; the first is the base.
    """

    slots: tuple[Slot, ...]

    @classmethod
    def of(cls, assets: "Iterable[Asset | Topology]") -> "Topology":
        """Return the smallest common topology that was found for assets; their order does not matter.

        Topologies may be among the assets: the result holds their assets, too.

        Raises:
            AssetError: There are no assets, or one is padded.
            ParameterError: Something else than assets is given.
        """
        given = checked_assets("Topology.of", assets, Asset, Topology)
        found = {each.to_text(): each for each in map(_outline, given)}
        if not found:
            raise AssetError("a topology needs at least one asset; give some")
        first, *others = sorted(found, key=lambda text: (found[text].size, text), reverse=True)
        result = found[first]
        for text in others:
            result = _united(result, found[text])
        return result

    def with_room(self, share: float) -> "Topology":
        """Return the topology with a share more colliders of each kind in each slot, rounded up.

        Raises:
            ParameterError: The share is no finite number of at least 0.
        """
        if not is_number(share) or not 0.0 <= share < math.inf:
            raise ParameterError(f"share must be a finite number of at least 0, got {share!r}")

        def more(slot: Slot) -> Slot:
            grown = {kind: n + math.ceil(share * n) for kind, n in slot.colliders.items()}
            return replace(slot, colliders=grown)

        return Topology(tuple(map(more, self.slots)))

    @property
    def size(self) -> tuple[int, int]:
        """Number of links and of colliders."""
        return len(self.slots), sum(sum(slot.colliders.values()) for slot in self.slots)

    @property
    def couplings(self) -> tuple[tuple[str, str], ...]:
        """Each pair of joints of which the first follows the second in some asset."""
        joints = [joint for slot in self.slots for joint in slot.joints]
        return tuple((joint.name, leader) for joint in joints for leader in joint.leaders)

    def pad(self, asset: Asset) -> Asset:
        """Return an asset with the links, joints and colliders of the topology.

        Its links and joints have the names of their slots; `originals` has their former names. Empty slots
        get links of 1e-9 kg that a spring holds, whose colliders lie inside a collider of the nearest link
        above them. Spare colliders of present links lie inside another collider of the same link. So they
        touch nothing that this link does not touch, and motions do not change. The certificate is not kept:
        `certify` proves the padded asset.

        Raises:
            AssetError: The asset does not fit the topology, or is padded.
        """
        from artgen.topology import padding

        return padding.pad(asset, self.slots, self.places(asset))

    def places(self, asset: Asset) -> dict[str, str]:
        """Return the slot of each link of an asset.

        Raises:
            AssetError: The asset does not fit the topology, or is padded.
        """
        outline = _outline(*checked_assets("pad", [asset], Asset))
        found = _Match(outline, self, _EXCESS).places()
        slots = {slot.name: slot for slot in self.slots}
        lacking = []
        for link in outline.slots:
            place = found[link.name]
            if place is None:
                joints = " and ".join(each.kind for each in link.joints)
                follows = ", which follows another joint" if any(each.leaders for each in link.joints) else ""
                below = f" below {link.parent!r}" if link.parent else ""
                lacking.append(f"a slot for link {link.name!r}{below} ({joints}{follows})")
            elif more := slots[place].lacking(link.colliders):
                counts = ", ".join(f"{n} of kind {kind}" for kind, n in more.items())
                lacking.append(f"colliders for link {link.name!r} in slot {place!r}: {counts}")
        if lacking:
            raise AssetError(
                f"asset {asset.name!r} does not fit the topology, which lacks {'; '.join(lacking)}. Make one "
                "that holds it: Topology.of([topology, asset])"
            )
        return {name: place for name, place in found.items() if place is not None}

    def save(self, path: str | Path) -> None:
        """Write the topology to a JSON file, as a whole or not at all.

        Raises:
            ExportError: The file cannot be written.
        """
        target = checked_path(path, "path").absolute()
        if target.is_dir() or not target.parent.is_dir():
            raise ExportError(f"cannot write {path}: give a file in a directory that exists")
        partial = target.with_name(f".{target.name}.partial")
        try:
            partial.write_text(self.to_text(), encoding="utf-8")
            partial.replace(target)
        except OSError as error:
            partial.unlink(missing_ok=True)
            raise ExportError(f"cannot write {path}: {error.strerror}; nothing was changed") from error

    @classmethod
    def load(cls, path: str | Path) -> "Topology":
        """Read a topology that `save` wrote.

        Raises:
            AssetError: The file is no topology.
        """
        try:
            data = json.loads(Path(path).read_text(encoding="utf-8"))
            if data["format"] == _FORMAT:
                return cls.from_data(data)
            reason = f"its format is {data['format']!r}, not {_FORMAT!r}"
        except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
            reason = repr(error)
        raise AssetError(f"{path} is no topology: {reason}; write one with Topology.of(assets).save(path)")

    def to_text(self) -> str:
        """Return the topology as JSON text."""
        return json_text({"format": _FORMAT, **self.to_data()})

    def __str__(self) -> str:
        links, colliders = self.size
        joints = Counter(joint.kind for slot in self.slots for joint in slot.joints)
        counted = ", ".join(f"{n} {kind} joint{'s' if n > 1 else ''}" for kind, n in sorted(joints.items()))
        return f"{links} links, {counted or 'no joints'}, {colliders} colliders"


def checked_assets(call: str, assets: Any, *kinds: type) -> list[Any]:
    """Return the assets of an argument as a list; ParameterError for what is none."""
    if isinstance(assets, str) or not isinstance(assets, Iterable):
        raise ParameterError(f"{call} takes several assets, not {assets!r}; write a list, such as [asset]")
    found = list(assets)
    for each in found:
        if not isinstance(each, kinds):
            raise ParameterError(
                f"{call} takes assets, not {each!r}; generate one, such as artgen.generate('door', seed=0)"
            )
    return found


def _outline(asset: Asset | Topology) -> Topology:
    """Return the tree of an asset as a topology that holds only this asset."""
    if isinstance(asset, Topology):
        return asset
    if asset.originals:
        raise AssetError(f"asset {asset.name!r} is padded already; take the asset before `pad`")
    slots = [_slot(asset, asset.links[0].name, "", ())]
    for parent, child, joints in asset.pairs():
        kinds = tuple(
            SlotJoint(
                joint.name,
                "fixed" if joint.locked else "hinge" if joint.kind == "revolute" else "slide",
                () if joint.follows is None or joint.locked else (joint.follows.leader,),
            )
            for joint in joints
        )
        slots.append(_slot(asset, child, parent, kinds))
    order = [link.name for link in asset.links]
    return Topology(tuple(sorted(slots, key=lambda slot: order.index(slot.name))))


def _slot(asset: Asset, name: str, parent: str, joints: tuple[SlotJoint, ...]) -> Slot:
    link = asset.link(name)
    counts = Counter(each.convex.kind for each in link.colliders)
    return Slot(name, parent, link.label, joints, dict(sorted(counts.items())))


class _Match:
    """The best slots for the links of one outline."""

    def __init__(self, one: Topology, into: Topology, excess: float) -> None:
        self._one, self._into, self._excess = one.slots, into.slots, excess
        self._below = {
            id(slot): [other for other in tree if other.parent == slot.name]
            for tree in (one.slots, into.slots)
            for slot in tree
        }
        self._known: dict[tuple[int, int], tuple[float, list[tuple[Slot, Slot | None]]]] = {}

    def places(self) -> dict[str, str | None]:
        """Return the slot of each link, None for links without one."""
        result: dict[str, str | None] = dict.fromkeys(slot.name for slot in self._one)
        pairs: list[tuple[Slot, Slot | None]] = [(self._one[0], self._into[0])]
        for link, slot in pairs:  # grows
            if slot is not None:
                result[link.name] = slot.name
                pairs += self._children(link, slot)[1]
        return result

    def _children(self, link: Slot, slot: Slot) -> tuple[float, list[tuple[Slot, Slot | None]]]:
        """Return the cost of the best slots for the children of a link in a slot, and these slots."""
        key = id(link), id(slot)
        if key not in self._known:
            self._known[key] = self._assigned(self._below[id(link)], self._below[id(slot)])
        return self._known[key]

    def _assigned(self, links: list[Slot], slots: list[Slot]) -> tuple[float, list[tuple[Slot, Slot | None]]]:
        if not links:
            return 0.0, []
        from scipy.optimize import linear_sum_assignment  # takes a third of a second to load

        costs = np.full((len(links), len(slots) + len(links)), np.inf)
        for row, link in enumerate(links):
            costs[row, : len(slots)] = [self._cost(link, slot) for slot in slots]
            costs[row, len(slots) + row] = _NEW * self._links(link)
        rows, columns = linear_sum_assignment(costs)
        chosen = [slots[column] if column < len(slots) else None for column in columns]
        return float(costs[rows, columns].sum()), list(zip(links, chosen, strict=True))

    def _cost(self, link: Slot, slot: Slot) -> float:
        if link.kinds != slot.kinds:
            return np.inf
        differ = _NAME * (link.name != slot.name) + _LABEL * (link.label != slot.label)
        excess = self._excess * sum(slot.lacking(link.colliders).values())
        return differ + excess + self._children(link, slot)[0]

    def _links(self, link: Slot) -> int:
        return 1 + sum(map(self._links, self._below[id(link)]))


def _united(topology: Topology, other: Topology) -> Topology:
    """Return a topology with slots for the links of another one."""
    places = _Match(other, topology, _GROWTH).places()
    slots = {slot.name: slot for slot in topology.slots}
    names: dict[str, str] = {}  # of the joints of the other one
    taken = {*slots, *(joint.name for slot in topology.slots for joint in slot.joints)}

    def unused(name: str) -> str:
        number = 2
        result = name
        while result in taken:
            result, number = f"{name}_{number}", number + 1
        taken.add(result)
        return result

    for link in other.slots:
        place = places[link.name]
        if place is None:
            place = places[link.name] = unused(link.name)
            joints = tuple(replace(each, name=unused(each.name), leaders=()) for each in link.joints)
            slots[place] = replace(link, name=place, parent=str(places[link.parent]), joints=joints)
        before = slots[place]
        most = Counter(before.colliders) | Counter(link.colliders)
        slots[place] = replace(before, colliders=dict(sorted(most.items())))
        names |= {own.name: each.name for own, each in zip(link.joints, before.joints, strict=True)}
    for link in other.slots:
        slot = slots[str(places[link.name])]
        joints = tuple(
            replace(
                each, leaders=tuple(dict.fromkeys((*each.leaders, *(names[name] for name in own.leaders))))
            )
            for own, each in zip(link.joints, slot.joints, strict=True)
        )
        slots[slot.name] = replace(slot, joints=joints)
    return Topology(tuple(slots.values()))
