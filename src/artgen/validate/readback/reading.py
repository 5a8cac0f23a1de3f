"""Values that a reader found in an exported file, and the expected ones."""

import logging
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.asset.report import Finding
from artgen.export.frames import FAR
from artgen.validate.readback.pieces import ReadCollider

Frames = Callable[[Mapping[str, float]], dict[str, Array]]


@dataclass(frozen=True, eq=False)
class Inertial:
    """Mass properties of a link as a file has them."""

    mass: float  # [kg]
    center: Array  # center of mass in the link's frame, shape (3,) [m]
    inertia: Array  # about the center, along the axes of the link's frame, shape (3, 3) [kg m^2]


@dataclass(frozen=True)
class Said:
    """One number of a joint's dynamics that a file states."""

    field: str  # which of `artgen.asset.joint.DYNAMICS`
    value: float  # in SI units
    source: str  # what the file calls it


@dataclass(frozen=True, eq=False)
class Faces:
    """Visible faces of a link as a file has them, in the link's frame."""

    name: str  # what the file calls them
    bounds: Array  # corners of the bounding box, shape (2, 3) [m]
    count: int  # number of triangles


@dataclass(frozen=True, eq=False)
class Reading:
    """The values that one reader found in an exported asset.

    Attributes:
        file: Name of the file.
        frames: Gives the frame of each link, shape (4, 4), at positions of all joints.
        standing: The frames of links as the file places them, shape (4, 4), apart from its joints.
        inertials: Mass properties of each link.
        mass: Of everything in the file; None where it is not known [kg].
        base: Whether the base is `fixed` or `free`; empty where the format has no word for it.
        kinds: `revolute` or `prismatic` for each joint that can move.
        ends: Names of the parent and the child of each joint that can move.
        limits: Lowest and highest position of each joint that can move; None is unlimited [rad or m].
        axes: Axis in the child's frame, shape (3,), of the joints of which the file tells it.
        dynamics: What the file says of the springs, dampers, friction and so on of each joint.
        couplings: Leader, ratio and offset of each joint that follows.
        more_couplings: The same as the file says it once more, by the simulator that it says it to.
        colliders: The colliders of each link.
        faces: The visible faces of each link.
        holds: Link, and frame in the link's frame, shape (4, 4) [m], of each grasp and push; None where the
            layout has none.
        findings: What is wrong with the file whatever the asset is.
        said: What the reader complained of.
    """

    file: str
    frames: Frames
    standing: dict[str, Array] = field(default_factory=dict)
    inertials: dict[str, Inertial] = field(default_factory=dict)
    mass: float | None = None
    base: str = ""
    kinds: dict[str, str] = field(default_factory=dict)
    ends: dict[str, tuple[str, str]] = field(default_factory=dict)
    limits: dict[str, tuple[float, float] | None] = field(default_factory=dict)
    axes: dict[str, Array] = field(default_factory=dict)
    dynamics: dict[str, tuple[Said, ...]] = field(default_factory=dict)
    couplings: dict[str, tuple[str, float, float]] = field(default_factory=dict)
    more_couplings: dict[str, dict[str, tuple[str, float, float]]] = field(default_factory=dict)
    colliders: dict[str, tuple[ReadCollider, ...]] = field(default_factory=dict)
    faces: dict[str, tuple[Faces, ...]] = field(default_factory=dict)
    holds: dict[str, tuple[str, Array]] | None = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    said: tuple[str, ...] = ()


@contextmanager
def listening() -> Iterator[list[str]]:
    """Collect log messages and warnings instead of showing them."""
    said: list[str] = []
    handler = logging.Handler(logging.WARNING)
    handler.emit = lambda record: said.append(record.getMessage())  # type: ignore[method-assign]
    root = logging.getLogger()
    before = root.handlers[:]
    root.handlers[:] = [handler]
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            # yourdfpy calls trimesh in a way that trimesh is about to drop, whatever the file
            warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
            yield said
        said += [str(item.message) for item in caught]
    finally:
        root.handlers[:] = before


def expected_frames(asset: Asset, q: Mapping[str, float]) -> dict[str, Array]:
    """Return the frame of each link, shape (4, 4), at positions of the free joints."""
    result = {}
    for name, displacement in asset.pose(q).items():
        result[name] = displacement.copy()
        result[name][:3, 3] += displacement[:3, :3] @ asset.origin(name)
    return result


def expected_limits(form: str, joint: AssetJoint) -> tuple[float, float] | None:
    """Return the limits of a joint in a format: URDF wants some of a slide that has none [rad or m]."""
    if form == "urdf" and joint.kind == "prismatic" and joint.limits is None:
        return -FAR, FAR
    return joint.limits


def spelled_limits(limits: Sequence[float] | None, unit: str) -> str:
    """Spell the limits of a joint."""
    return "none" if limits is None else f"{limits[0]:.7g} to {limits[1]:.7g} {unit}"


def sampled_positions(asset: Asset, count: int) -> list[dict[str, float]]:
    """Return poses of the free joints: as the asset stands, and others drawn over the whole ranges."""
    draw = np.random.default_rng(0)
    spans = {joint.name: joint.limits or (-np.pi, np.pi) for joint in asset.free_joints}
    drawn = [{name: float(draw.uniform(*span)) for name, span in spans.items()} for _ in range(count)]
    return [{}, *drawn]
