"""Numbers and names of the bodies, joints and parts of an asset in PartNet-Mobility.

Its loaders look for `base`, `link_0`, `link_1`, ... by number: the number links the URDF, `semantics.txt` and
`mobility_v2.json`. Moving links come first, the asset's base is last.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, Link, Mesh
from artgen.export.frames import Segment, chain, linear_coupling
from artgen.export.names import Names

ROOT = "base"
"""Name of the body without geometry that carries the asset's base, turned upright."""

UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""From asset coordinates (z up, front -y) to those of the dataset's bodies and meshes (y up, front z)."""

_HANDLE = "handle"  # substring that loaders search in the names of visuals
_DOORS = ("door", "freezer_door", "pane")  # a refrigerator or an oven has a `door`, a door a `rotation_door`
_WORDS: Mapping[str, Mapping[str, str]] = {
    "bottle": {"cap": "lid", "stopper": "lid"},
    "box": {"flap_major": "rotation_lid", "flap_minor": "rotation_lid"},
    "dishwasher": {"rack": "shelf"},
    "faucet": {"handle": "switch"},
    "lamp": {"arm_lower": "rotation_bar", "arm_upper": "rotation_bar", "rocker": "switch", "dial": "knob"},
    "microwave": {"dial": "knob", "plate": "rotation_tray"},
    "oven": {"dial": "knob", "rack": "translation_tray"},
    "plier": {"jaw": "leg"},
    "refrigerator": {"inner_drawer": "drawer", "outer_drawer": "drawer"},
    "soap_dispenser": {"nozzle": "pressing_lid"},
    "toaster": {"crumb_tray": "translation_tray", "lever": "slider"},
    "trashcan": {"bucket": "container", "pedal": "foot_pad"},
    "washing_machine": {"dial": "knob"},
}
"""Words of the dataset for moving links, by category and label, where they differ from artgen's labels."""

_BASES: Mapping[str, str] = {
    "box": "box_body", "cabinet": "furniture_body", "drawer": "furniture_body", "faucet": "faucet_base",
    "plier": "leg", "soap_dispenser": "dispenser_body",
}  # fmt: skip
"""Words of the dataset for bases, by category, where they differ from the category and artgen's label."""

_TURNS_OR_SLIDES = {"cabinet": "door", "door": "door", "window": "window"}
"""Categories whose doors and panes are named after their motion, such as `rotation_door`."""

_KINDS = {"prismatic": "slider", "revolute": "hinge"}


@dataclass(frozen=True)
class Part:
    """Visible surfaces of a link with a common semantic label."""

    number: int  # number in `result.json`
    name: str  # name; contains "handle" for parts that a hand grasps
    label: str  # label of its surfaces


@dataclass(frozen=True, eq=False)
class Step:
    """One joint of the URDF."""

    name: str  # name of the joint
    parent: str  # name of the body nearer to the base
    child: str  # name of the moving body
    sign: int  # -1 for a joint that is reversed so that its lower limit is the closed end, else 1
    segment: Segment  # joint with its frames, in artgen's names and coordinates

    @property
    def limits(self) -> tuple[float, float] | None:
        """Lowest and highest position in the file [rad or m]."""
        limits = self.segment.joint.limits
        if limits is None or self.sign > 0:
            return limits
        return -limits[1], -limits[0]

    @property
    def axis(self) -> Array:
        """Unit vector in the dataset's coordinates, shape (3,)."""
        return np.asarray(self.sign * (UPRIGHT @ self.segment.joint.axis))


@dataclass(frozen=True, eq=False)
class Coupled:
    """A joint that follows another, as in the file."""

    follower: Step  # following joint
    leader: Step  # leading joint
    ratio: float  # ratio of follower to leader
    offset: float  # position of the follower while the leader is at 0 [rad or m]

    @property
    def siblings(self) -> bool:
        """Whether both joints have the same parent."""
        return self.follower.parent == self.leader.parent


@dataclass(frozen=True, eq=False)
class Naming:
    """The names of an asset's links, joints and parts in the dataset."""

    links: Mapping[str, int]  # number of each link
    steps: tuple[Step, ...]  # the joints, parents before children
    parts: Mapping[str, tuple[Part, ...]]  # the parts of each link
    couplings: tuple[Coupled, ...]  # joints that follow others

    def body(self, link: str) -> str:
        """Return the name of a link's body."""
        return f"link_{self.links[link]}"

    def of_link(self, link: str) -> tuple[Step, ...]:
        """Return the joints between a link and its parent."""
        return tuple(step for step in self.steps if step.segment.joint.child == link)

    def to_data(self) -> dict[str, Any]:
        """Return the meaning of each number as JSON data."""
        return Names(
            {self.body(name): name for name in self.links},
            {step.name: (step.segment.joint.name, step.sign) for step in self.steps},
            {item.follower.name: (item.leader.name, item.ratio, item.offset) for item in self.couplings},
            UPRIGHT,
        ).to_data()


def naming(asset: Asset) -> Naming:
    """Number the bodies, joints and parts of an asset."""
    base, *moving = asset.links
    links = {link.name: number for number, link in enumerate([*moving, base])}
    steps = _steps(asset, links)
    return Naming(links, steps, _parts(asset, [*moving, base]), _couplings(asset, steps))


def _closed_end_first(joint: AssetJoint) -> int:
    """Return -1 for a joint that must be reversed to be closed at its lower limit, else 1."""
    low, high = joint.limits or (0.0, 0.0)
    return -1 if low != high and joint.closed == high else 1


def kind_of(joints: Sequence[AssetJoint], base: str = "fixed") -> str:
    """Return the motion of a link as a word of `semantics.txt`."""
    if not joints:
        return "static" if base == "fixed" else "free"
    kinds = [_KINDS[joint.kind] for joint in joints if not joint.locked]
    if "slider" in kinds and "hinge" in kinds:
        return "slider+"
    return kinds[-1] if kinds else "static"


def semantic(asset: Asset, link: Link, joints: Sequence[AssetJoint]) -> str:
    """Return the name of a link as one word of `semantics.txt`."""
    label = link.label
    if not joints:
        return _BASES.get(asset.category) or (
            label if asset.category in label else f"{asset.category}_{label}"
        )
    if label in _DOORS:
        what, slides = _TURNS_OR_SLIDES.get(asset.category), kind_of(joints) == "slider"
        if what is not None:
            return f"translation_{what}" if slides else f"rotation_{what}"
        return "translation_door" if slides else "door"
    return _WORDS.get(asset.category, {}).get(label, label)


def _steps(asset: Asset, links: Mapping[str, int]) -> tuple[Step, ...]:
    """Name the joints: `joint_3` moves `link_3`; a further joint of the pair moves `link_3_helper`."""
    helpers: dict[str, str] = {}
    spare = len(links)
    result = []
    for segment in chain(asset):
        child = segment.child
        if child.link is not None:
            name, body = f"joint_{links[child.name]}", f"link_{links[child.name]}"
        else:
            name, spare = f"joint_{spare}", spare + 1
            body = f"link_{links[segment.joint.child]}_helper"
            while body in helpers.values():
                body += "_"
            helpers[child.name] = body
        parent = helpers.get(segment.parent.name) or f"link_{links[segment.parent.name]}"
        result.append(Step(name, parent, body, _closed_end_first(segment.joint), segment))
    return tuple(result)


def _couplings(asset: Asset, steps: Sequence[Step]) -> tuple[Coupled, ...]:
    by_name = {step.segment.joint.name: step for step in steps}
    result = []
    for name, step in by_name.items():
        follows = linear_coupling(asset, asset.joint(name))
        if follows is not None and not step.segment.joint.locked:
            leader = by_name[follows.leader]
            ratio, offset = step.sign * leader.sign * follows.ratio, step.sign * follows.offset
            result.append(Coupled(step, leader, ratio, offset))
    return tuple(result)


def _parts(asset: Asset, links: Sequence[Link]) -> dict[str, tuple[Part, ...]]:
    """Number the parts of all links; 0 is the whole object."""
    result, number = {}, 1
    for link in links:
        held = _held_label(asset, link)
        found = []
        for label in dict.fromkeys(surface.label for surface in link.surfaces):
            name = f"{_HANDLE}_{label}" if label == held else label
            found.append(Part(number, name, label))
            number += 1
        result[link.name] = tuple(found)
    return result


def _held_label(asset: Asset, link: Link) -> str:
    """Return the label whose name gets "handle", empty if none needs it."""
    # the nearest to the grasps; a link moved by a handle with its own joint uses the rose below the lever
    labels = dict.fromkeys(surface.label for surface in link.surfaces)
    if any(_HANDLE in label for label in labels):
        return ""
    points = [grasp.frame[:3, 3] for grasp in link.grasps]
    apart = _borrowed(asset, link) if not points else []
    if not points and not apart:
        return ""
    if apart and len(labels) > 1:
        labels.pop(link.label, None)

    def distance(label: str) -> float:
        meshes = [surface.mesh for surface in link.surfaces if surface.label == label]
        if points:
            return round(min(_distance(mesh, point) for mesh in meshes for point in points), 6)
        # readers aim at the center of the box; a pane of glass is near every lever, but its center is not
        corners = np.concatenate([mesh.vertices for mesh in meshes])
        middle = (corners.min(axis=0) + corners.max(axis=0)) / 2.0
        return round(min(_portable.norm(middle - point) for point in apart), 6)

    return min(labels, key=distance)


def _borrowed(asset: Asset, link: Link) -> list[Array]:
    """Return the points at which a hand moves a link by another link, preferably by handles [m]."""
    own = {joint.name for joint in asset.joints if joint.child == link.name and not joint.locked}
    found = [item for item in asset.affordances if item.kind == "grasp" and own & set(item.joints)]
    handles = [item for item in found if _HANDLE in asset.link(item.link).label]
    return [item.frame[:3, 3] for item in handles or found]


def _distance(mesh: Mesh, point: Array) -> float:
    """Return the distance of a point, shape (3,), from the faces of a mesh [m]."""
    from trimesh.triangles import closest_point

    corners = mesh.vertices[mesh.triangles]
    nearest = closest_point(corners, np.broadcast_to(point, (len(corners), 3)))  # type: ignore[no-untyped-call]
    return float(np.linalg.norm(nearest - point, axis=1).min())
