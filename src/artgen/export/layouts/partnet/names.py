"""How PartNet-Mobility counts and calls the bodies, joints and parts of an asset.

Its loaders look for `base`, `link_0`, `link_1`, ... by number: the number is the key between the URDF,
`semantics.txt` and `mobility_v2.json`. The links that move come first, the asset's base is the last one.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, Link, Mesh
from artgen.export.frames import Segment, chain, coupling

ROOT = "base"
"""Name of the body that has no geometry and carries the asset's base, turned upright."""

NAMES_FILE = "artgen_names.json"
"""The file that says which of artgen's links and joints a number stands for."""

UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""From asset coordinates (z up, front -y) to those of the dataset's bodies and meshes (y up, front z)."""

_HANDLE = "handle"  # what loaders search for in the names of visuals
_DOORS = ("door", "freezer_door", "pane")  # a refrigerator or an oven has a `door`, a door a `rotation_door`
_WORDS: Mapping[tuple[str, str], str] = {
    ("box", "flap_major"): "rotation_lid",
    ("box", "flap_minor"): "rotation_lid",
    ("dishwasher", "rack"): "shelf",
    ("faucet", "handle"): "switch",
    ("lamp", "arm_lower"): "rotation_bar",
    ("lamp", "arm_upper"): "rotation_bar",
    ("lamp", "rocker"): "switch",
    ("lamp", "dial"): "knob",
    ("microwave", "dial"): "knob",
    ("microwave", "plate"): "rotation_tray",
    ("oven", "dial"): "knob",
    ("oven", "rack"): "translation_tray",
    ("plier", "jaw"): "leg",
    ("refrigerator", "inner_drawer"): "drawer",
    ("refrigerator", "outer_drawer"): "drawer",
    ("soap_dispenser", "nozzle"): "pressing_lid",
    ("toaster", "crumb_tray"): "translation_tray",
    ("toaster", "lever"): "slider",
    ("trashcan", "bucket"): "container",
    ("trashcan", "pedal"): "foot_pad",
}
"""The dataset's words for moving links, by category and label, where they are not artgen's labels."""

_BASES: Mapping[str, str] = {
    "box": "box_body",
    "cabinet": "furniture_body",
    "drawer": "furniture_body",
    "faucet": "faucet_base",
    "plier": "leg",
    "soap_dispenser": "dispenser_body",
}
"""The dataset's words for bases, by category, where they are not the category and artgen's label."""

_TURNS_OR_SLIDES = {"cabinet": "door", "door": "door", "window": "window"}
"""Categories whose doors and panes are called after how they move, as `rotation_door`."""

_KINDS = {"prismatic": "slider", "revolute": "hinge"}


@dataclass(frozen=True)
class Part:
    """The visible faces of a link that share a semantic label."""

    number: int  # its number in `result.json`
    name: str  # what it is called; holds "handle" where a hand takes hold
    label: str  # the label of its surfaces


@dataclass(frozen=True, eq=False)
class Step:
    """One joint of the URDF."""

    name: str  # name of the joint
    parent: str  # name of the body nearer to the base
    child: str  # name of the body that moves
    sign: int  # -1 where the joint is turned round so that its lower limit is the closed end, else 1
    segment: Segment  # the joint with its frames, in artgen's names and coordinates

    @property
    def limits(self) -> tuple[float, float] | None:
        """Lowest and highest position as written [rad or m]."""
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
    """A joint that follows another, as written."""

    follower: Step  # the joint that follows
    leader: Step  # the joint that it follows
    ratio: float  # positions of the follower for one of the leader
    offset: float  # position of the follower where the leader is at 0 [rad or m]

    @property
    def siblings(self) -> bool:
        """Whether both joints start from one body."""
        return self.follower.parent == self.leader.parent


@dataclass(frozen=True, eq=False)
class Naming:
    """The names of an asset's links, joints and parts in the dataset.

    Attributes:
        links: Number of each link.
        steps: The joints, parents before children.
        parts: The parts of each link.
        couplings: The joints that follow others.
    """

    links: Mapping[str, int]
    steps: tuple[Step, ...]
    parts: Mapping[str, tuple[Part, ...]]
    couplings: tuple[Coupled, ...]

    def body(self, link: str) -> str:
        """Return the name of a link's body."""
        return f"link_{self.links[link]}"

    def of_link(self, link: str) -> tuple[Step, ...]:
        """Return the joints between a link and its parent."""
        return tuple(step for step in self.steps if step.segment.joint.child == link)

    def to_data(self) -> dict[str, Any]:
        """Return as JSON data what each number stands for."""
        return {
            "links": {self.body(name): name for name in self.links},
            "joints": {
                step.name: {"name": step.segment.joint.name, "sign": step.sign} for step in self.steps
            },
            "couplings": {
                item.follower.name: [item.leader.name, item.ratio, item.offset] for item in self.couplings
            },
            "axes": UPRIGHT.astype(int).tolist(),
        }


def naming(asset: Asset) -> Naming:
    """Give the bodies, joints and parts of an asset their numbers."""
    base, *moving = asset.links
    links = {link.name: number for number, link in enumerate([*moving, base])}
    steps = _steps(asset, links)
    return Naming(links, steps, _parts(asset, [*moving, base]), _couplings(asset, steps))


def closed_end_first(joint: AssetJoint) -> int:
    """Return -1 where a joint is to be turned round, so that it is closed at its lower limit, else 1."""
    if joint.limits is None or joint.locked:
        return 1
    low, high = joint.limits
    return -1 if joint.closed == high and joint.closed != low else 1


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
    return _WORDS.get((asset.category, label), label)


def _steps(asset: Asset, links: Mapping[str, int]) -> tuple[Step, ...]:
    """Name the joints: `joint_3` moves `link_3`; a further joint of that pair moves `link_3_helper`."""
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
        result.append(Step(name, parent, body, closed_end_first(segment.joint), segment))
    return tuple(result)


def _couplings(asset: Asset, steps: Sequence[Step]) -> tuple[Coupled, ...]:
    by_name = {step.segment.joint.name: step for step in steps}
    result = []
    for name, step in by_name.items():
        follows = coupling(asset, asset.joint(name))
        if follows is not None and not step.segment.joint.locked:
            leader = by_name[follows.leader]
            ratio, offset = step.sign * leader.sign * follows.ratio, step.sign * follows.offset
            result.append(Coupled(step, leader, ratio, offset))
    return tuple(result)


def _parts(asset: Asset, links: Sequence[Link]) -> dict[str, tuple[Part, ...]]:
    """Number the parts of all links; 0 is the object as a whole."""
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
    """Return the label that gets "handle" into its name, empty if none needs it.

    That is where a hand takes hold of the link: the label next to its grasps. A link that is moved by a
    handle with a joint of its own, as a door leaf by its lever, has the rose or plate on which that sits.
    """
    labels = dict.fromkeys(surface.label for surface in link.surfaces)
    if any(_HANDLE in label for label in labels):
        return ""
    points = [grasp.frame[:3, 3] for grasp in link.grasps]
    apart = _borrowed(asset, link) if not points else []
    if not points and not apart:
        return ""
    if apart and len(labels) > 1:
        labels.pop(link.label, None)
    meshes = {
        label: [surface.mesh for surface in link.surfaces if surface.label == label] for label in labels
    }

    def distance(label: str) -> float:
        if points:
            return round(min(_distance(mesh, point) for mesh in meshes[label] for point in points), 6)
        # readers aim at the middle of the box; a pane of glass comes near to any lever, its middle does not
        corners = np.concatenate([mesh.vertices for mesh in meshes[label]])
        middle = (corners.min(axis=0) + corners.max(axis=0)) / 2.0
        return round(min(float(np.linalg.norm(middle - point)) for point in apart), 6)

    return min(labels, key=distance)


def _borrowed(asset: Asset, link: Link) -> list[Array]:
    """Return where a hand moves a link by another one, on handles alone if there are some [m]."""
    own = {joint.name for joint in asset.joints if joint.child == link.name and not joint.locked}
    found = [item for item in asset.affordances if item.kind == "grasp" and own & set(item.joints)]
    handles = [item for item in found if _HANDLE in asset.link(item.link).label]
    return [item.frame[:3, 3] for item in handles or found]


def _distance(mesh: Mesh, point: Array) -> float:
    """Return how far a point, shape (3,), is from the faces of a mesh [m]."""
    corners = mesh.vertices[mesh.triangles] - point
    ends = np.roll(corners, -1, axis=1)
    sides = ends - corners
    squares = (sides**2).sum(axis=2)
    share = -(corners * sides).sum(axis=2) / np.where(squares > 0.0, squares, 1.0)
    nearest = corners + np.clip(share, 0.0, 1.0)[..., None] * sides
    to_sides = np.sqrt((nearest**2).sum(axis=2)).min(axis=1)
    normals = np.cross(sides[:, 0], sides[:, 1])
    lengths = np.sqrt((normals**2).sum(axis=1))
    normals /= np.where(lengths > 0.0, lengths, 1.0)[:, None]
    heights = np.abs((corners[:, 0] * normals).sum(axis=1))
    # the foot of the perpendicular is on the face if the point is on the inner side of all three sides
    above = ((np.cross(sides, -corners) * normals[:, None]).sum(axis=2) >= 0.0).all(axis=1) & (lengths > 0.0)
    return float(np.where(above, heights, to_sides).min())
