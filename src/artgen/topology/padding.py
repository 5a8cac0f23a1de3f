"""Links of a padded asset: links with spare colliders, and links that fill empty slots.

A spare collider lies inside another collider of the same body, so that it touches nothing that the body does
not touch. Writers switch spare colliders off where a format can.
"""

import itertools
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, ClassVar, get_args

import numpy as np

from artgen import _portable
from artgen._arrays import Array, affine, cached_property
from artgen._names import ByName
from artgen.asset import Asset
from artgen.asset.joint import AssetJoint, JointKind
from artgen.asset.link import Collider, DerivedLink, Link, Surface
from artgen.asset.mass import MassProperties, total
from artgen.asset.record import rounded, rounded_coordinates
from artgen.colliders import TOLERANCE, Convex, Kind
from artgen.errors import AssetError

if TYPE_CHECKING:
    from artgen.topology.template import Slot

KINDS: tuple[Kind, ...] = get_args(Kind)
"""Kinds of colliders, in the order of the colliders of a padded link."""

MASS = 1e-9
"""Mass of a link that fills an empty slot; MuJoCo asks for more than 1e-15 [kg]."""

RANGE = 1e-6
"""Such a link moves by at most this to either side; simulators require a range [rad or m]."""

_INERTIA = 2e-10  # each principal moment of such a link [kg m^2]
# its center lies beside its joints: MuJoCo takes shortcuts for centered bodies, and worlds share these
_OFF_AXIS = np.full(3, 1e-4)  # [m]
_LARGEST = 1e-3  # largest length of a spare collider [m]
_SMALLEST = 5e-5  # smallest one; of less, MuJoCo makes no mesh [m]
# a spring with critical damping that holds the joint without its limits
_HELD: Mapping[str, Any] = {
    "stiffness": 0.1,
    "damping": 0.00632455532034,
    "armature": 1e-4,
    "effort": 1e-6,
    "velocity": 1.0,
}


@dataclass(frozen=True)
class Host:
    """A ball inside one collider of a link, in which spare colliders lie."""

    link: str  # name of the link
    collider: Collider  # the collider
    center: tuple[float, ...]  # center of the ball in asset coordinates at rest [m]
    radius: float  # its radius [m]

    @staticmethod
    def of(link: Link) -> "Host":
        """Return the largest ball about the middle of a collider of a link.

        Raises:
            AssetError: The link has no collider, or all are too thin.
        """
        balls = [_ball(link.name, each) for each in link.colliders]
        best = max(balls, key=lambda each: each.radius, default=None)
        if best is None or best.radius < _SMALLEST:
            raise AssetError(
                f"link {link.name!r} has no collider of at least {2e3 * _SMALLEST:g} mm in every direction, "
                "which could hold spare colliders; give it a thicker solid",
                link=link.name,
            )
        return best

    def place(self, number: int = 0, count: int = 1) -> Array:
        """Return the middle of one of several parts of the ball, shape (3,) [m]."""
        along = self.radius * ((number + 0.5) / count - 0.5)
        return np.asarray(rounded_coordinates(np.array(self.center) + np.array([along, 0.0, 0.0])))

    def colliders(self, kinds: Sequence[Kind], number: int = 0, count: int = 1) -> tuple[Collider, ...]:
        """Return spare colliders of some kinds in the part of the ball with a number among several parts."""
        size = rounded(min(_LARGEST, self.radius / (2 * count)))
        label, material = self.collider.label, self.collider.material
        result = []
        for index, kind in enumerate(kinds):
            pose = affine(np.eye(3), self.place(number, count))
            pose[2, 3] = round(pose[2, 3] + 0.5 * size * ((index + 0.5) / len(kinds) - 0.5), 12)  # none alike
            result.append(Collider(_MAKERS[kind](size, pose), label, material, spare=True))
        return tuple(result)


def _ball(link: str, collider: Collider) -> Host:
    faces = collider.convex.inner_polytope(TOLERANCE)
    low, high = faces.bounds
    middles = (faces.points.mean(axis=0), 0.5 * (low + high))
    gaps = [
        float((faces.planes[:, 3] - _portable.product(faces.planes[:, :3], each)).min()) for each in middles
    ]
    best = int(gaps[1] > gaps[0])
    return Host(link, collider, tuple(middles[best].tolist()), gaps[best])


def _octahedron(size: float, pose: Array) -> Convex:
    reach = 0.5 * size * np.eye(3)
    return Convex.hull(rounded_coordinates(np.concatenate((reach, -reach)) + pose[:3, 3]))


def _hull_of(box: Convex) -> Convex:
    """Return a box as a hull of its corners."""
    signs = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))
    corners = signs * box.size @ box.pose[:3, :3].T + box.pose[:3, 3]
    return Convex("hull", np.eye(4), points=rounded_coordinates(corners))


_MAKERS: Mapping[Kind, Callable[[float, Array], Convex]] = {
    "box": lambda size, pose: Convex.box((size, size, size), pose),
    "cylinder": lambda size, pose: Convex.cylinder(size / 2, size, pose),
    "sphere": lambda size, pose: Convex.sphere(size / 2, pose),
    "capsule": lambda size, pose: Convex.capsule(size / 4, size / 2, pose),
    "hull": _octahedron,
}


@dataclass(frozen=True, eq=False, repr=False)
class PaddedLink(DerivedLink):
    """A link with a canonical name, with its colliders in the order of kinds and spare ones among them."""

    counts: Mapping[str, int] = field(kw_only=True)  # number of colliders by kind
    inside: tuple[MassProperties, ...] = field(kw_only=True)  # of links in empty slots that move with it

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Those of the source without the links inside, so that together they are those of the source."""
        own = self.source.mass_properties
        if not self.inside:
            return own
        return total([own.moments(), *(each.moments().scaled(-1.0) for each in self.inside)])

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders of the source and spare ones, by kind; hulls replace boxes that are too many."""
        own = list(self.source.colliders)
        boxes = [number for number, each in enumerate(own) if each.convex.kind == "box"]
        for number in boxes[self.counts.get("box", 0) :]:
            own[number] = replace(own[number], convex=_hull_of(own[number].convex))
        have = Counter(each.convex.kind for each in own)
        lacking = [kind for kind in KINDS for _ in range(self.counts.get(kind, 0) - have[kind])]
        spare = Host.of(self.source).colliders(lacking) if lacking else ()
        return tuple(sorted((*own, *spare), key=lambda each: KINDS.index(each.convex.kind)))


@dataclass(frozen=True, eq=False, repr=False)
class SlotLink(Link):
    """A link that fills an empty slot: nearly massless, with colliders inside a present link."""

    absent: ClassVar = True
    rounded: ClassVar = True

    spares: tuple[Collider, ...] = field(kw_only=True)  # its colliders
    inertial: MassProperties = field(kw_only=True)  # mass, center and inertia that simulators accept

    @property
    def mass_properties(self) -> MassProperties:
        """The given ones."""
        return self.inertial

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The spare colliders."""
        return self.spares

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """None: it is not seen."""
        return ()

    @property
    def changes(self) -> dict[str, Any]:
        """That it fills an empty slot, as JSON data."""
        return {"absent": True}


def slot_joint(name: str, kind: str, pivot: Array, parent: str, child: str) -> AssetJoint:
    """Return the joint of a link that fills an empty slot: a spring holds it, and it cannot move visibly."""
    moves: JointKind = "prismatic" if kind == "slide" else "revolute"
    limits = (0.0, 0.0) if kind == "fixed" else (-RANGE, RANGE)
    joint = AssetJoint(name, moves, np.array([1.0, 0.0, 0.0]), pivot, limits, parent=parent, child=child)
    return joint if kind == "fixed" else replace(joint, **_HELD)


def pad(asset: Asset, slots: "Sequence[Slot]", places: Mapping[str, str]) -> Asset:
    """Return an asset with a link in every slot; `places` has the slot of each of its links."""
    links = {place: asset.link(name) for name, place in places.items()}
    above = {child: joints for _, child, joints in asset.pairs()}
    names = {  # canonical names of the joints
        own.name: slot.name
        for each in slots
        if each.name in links
        for own, slot in zip(above.get(links[each.name].name, ()), each.joints, strict=True)
    }
    taken = {name for each in slots for name in (each.name, *(joint.name for joint in each.joints))}
    hosts = _hosts(slots, links)
    small = {  # mass properties of the links in empty slots
        name: MassProperties(MASS, rounded_coordinates(host.place(*at) + _OFF_AXIS), _INERTIA * np.eye(3))
        for name, (host, *at) in hosts.items()
    }
    result: list[Link] = []
    joints: list[AssetJoint] = []
    for slot in slots:
        if slot.name in links:
            link = links[slot.name]
            inside = tuple(small[name] for name, (host, *_) in hosts.items() if host.link == link.name)
            result.append(_renamed(link, slot, names, taken, inside))
            joints += [
                replace(each.renamed(names), parent=slot.parent, child=slot.name)
                for each in above.get(link.name, ())
            ]
            continue
        host, number, count = hosts[slot.name]
        spares = host.colliders(
            [kind for kind in KINDS for _ in range(slot.colliders.get(kind, 0))], number, count
        )
        pivot = host.place(number, count)
        result.append(SlotLink(slot.name, slot.label, spares=spares, inertial=small[slot.name]))
        joints += [slot_joint(each.name, each.kind, pivot, slot.parent, slot.name) for each in slot.joints]
    originals = {place: link.name for place, link in links.items()}
    originals |= {name: own for own, name in names.items()}
    return replace(
        asset,
        links=ByName(result),
        joints=ByName(joints),
        labels=tuple(dict.fromkeys((*asset.labels, *(link.label for link in result)))),
        contacts=tuple(each.renamed(places, names) for each in asset.contacts),
        loops=tuple(each.renamed(places, names) for each in asset.loops),
        outputs=tuple(each.renamed(each.name, names, {}) for each in asset.outputs),
        originals=originals,
    )


def _hosts(slots: "Sequence[Slot]", links: Mapping[str, Link]) -> dict[str, tuple[Host, int, int]]:
    """Return for each empty slot the host of its colliders, its number in the host, and their count."""
    nearest: dict[str, str] = {}
    for slot in slots:
        if slot.name not in links:
            nearest[slot.name] = nearest.get(slot.parent, slot.parent)
    found = {name: Host.of(links[name]) for name in dict.fromkeys(nearest.values())}
    counts = Counter(nearest.values())
    used: Counter[str] = Counter()
    result = {}
    for name, host in nearest.items():
        result[name] = (found[host], used[host], counts[host])
        used[host] += 1
    return result


def _renamed(
    link: Link,
    slot: "Slot",
    joints: Mapping[str, str],
    taken: Collection[str],
    inside: tuple[MassProperties, ...],
) -> Link:
    """Return a link with the name and colliders of a slot; its holds keep names that no slot has."""

    def hold(each: Any) -> Any:
        return each.renamed(lambda name: f"{name}_" if name in taken else name, joints)

    return PaddedLink.of(
        link,
        name=slot.name,
        grasps=tuple(map(hold, link.grasps)),
        pushes=tuple(map(hold, link.pushes)),
        counts=slot.colliders,
        inside=inside,
    )
