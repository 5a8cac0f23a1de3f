"""Values that a reader found in an exported file, and the messages of the reader."""

import logging
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset.report import Finding
from artgen.colliders import Convex

MOST_VERTICES = 64
"""Vertices that a collider may have; the budget of GPU simulators."""

Frames = Callable[[Mapping[str, float]], Mapping[str, Array]]
Law = tuple[str, float, float]
"""Leader, ratio and offset of a joint that follows."""


@dataclass(frozen=True, eq=False)
class Inertial:
    """Mass properties of a link as a file has them."""

    mass: float  # [kg]
    center: Array | None  # center of mass in the link's frame, shape (3,) [m]; None if it was not read
    inertia: Array | None  # about the center, along the axes of the link's frame, shape (3, 3) [kg m^2]


@dataclass(frozen=True)
class Stated:
    """One number of a joint's dynamics that a file states."""

    field: str  # one of `artgen.asset.joint.DYNAMICS`
    value: float  # in SI units
    source: str  # name in the file


@dataclass(frozen=True, eq=False)
class Faces:
    """A visible mesh of a link as a file has it, in the link's frame."""

    name: str  # name in the file
    bounds: Array  # corners of the bounding box, shape (2, 3) [m]
    count: int  # number of triangles

    @staticmethod
    def of(name: str, vertices: Array, triangles: Indices) -> "Faces":
        """Return the summary of a mesh."""
        return Faces(name, np.array([vertices.min(axis=0), vertices.max(axis=0)]), len(triangles))


@dataclass(frozen=True, eq=False)
class ReadJoint:
    """A joint that can move, as a file has it."""

    kind: str  # `revolute` or `prismatic`
    ends: tuple[str, str] | None = None  # parent and child
    limits: tuple[float, float] | None = None  # lowest and highest position, may be infinite [rad or m]
    axis: Array | None = None  # in the frame of the child, shape (3,)
    dynamics: tuple[Stated, ...] | None = None  # springs, dampers, friction and so on


UNLIMITED = (-np.inf, np.inf)
"""Limits of a joint without limits [rad or m]."""


@dataclass(frozen=True, eq=False)
class ReadCollider:
    """A collider, in the frame of its link."""

    name: str  # name in the file
    bounds: Array  # corners of the bounding box, shape (2, 3) [m]
    middle: Array  # centroid of its volume, shape (3,) [m]; rounding adds and drops vertices of plane faces
    volume: float  # [m^3]
    friction: float | None = None  # coefficient of sliding friction; None if the file has none
    # vertices of a mesh, each once, shape (n, 3) [m]
    vertices: Array = field(default_factory=lambda: np.zeros((0, 3)))
    flaw: str = ""  # fault that a simulator would refuse or silently change, with the number

    @staticmethod
    def primitive(name: str, convex: Convex, friction: float | None = None, flaw: str = "") -> "ReadCollider":
        """Return the collider of a box or a round piece."""
        return ReadCollider(name, convex.bounds(), convex.pose[:3, 3], convex.volume, friction, flaw=flaw)

    @staticmethod
    def mesh(
        name: str, vertices: Array, triangles: Indices, friction: float | None = None, flaw: str = ""
    ) -> "ReadCollider":
        """Return the collider of a mesh; vertices at one place are one."""
        open_edges = _open_edges(triangles)
        if open_edges or len(vertices) > MOST_VERTICES:
            vertices, numbers = np.unique(vertices, axis=0, return_inverse=True)
            triangles = numbers.reshape(-1)[triangles]
            open_edges = _open_edges(triangles)
        middle = vertices.mean(axis=0)
        a, b, c = (vertices - middle)[triangles.T]
        volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
        volume = float(volumes.sum())
        if volume > 0.0:
            middle = middle + volumes @ (a + b + c) / (4.0 * volume)
        if not np.isfinite(vertices).all():
            flaw = flaw or "has coordinates that are not finite"
        elif open_edges:
            flaw = flaw or f"is open: {open_edges} edges have a face on one side only"
        elif volume <= 0.0:
            flaw = flaw or f"is inside out: its volume is {1e6 * volume:.4g} cm^3"
        elif len(vertices) > MOST_VERTICES:
            flaw = flaw or f"has {len(vertices)} vertices; GPU simulators take at most {MOST_VERTICES}"
        bounds = np.array([vertices.min(axis=0), vertices.max(axis=0)])
        return ReadCollider(name, bounds, middle, volume, friction, vertices, flaw)


def dent(vertices: Array) -> float | None:
    """Return how far a vertex lies inside the hull of the others; None if they have no hull [m]."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        planes = ConvexHull(vertices).equations
    except (QhullError, ValueError, IndexError):
        return None
    return float(-(planes[:, :3] @ vertices.T + planes[:, 3:]).max(axis=0).min())


def _open_edges(triangles: Indices) -> int:
    """Return the number of edges that do not have one triangle on either side."""
    if not len(triangles):
        return 1
    most = int(triangles.max()) + 1
    first, second = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    forth, back = np.sort(first * most + second), np.sort(second * most + first)
    return int((forth[1:] == forth[:-1]).sum()) + len(np.setdiff1d(forth, back))


@dataclass(frozen=True, eq=False)
class Reading:
    """Values that one reader found in an exported asset; None if they were not read."""

    file: str  # name of the file
    frames: Frames  # function from the positions of all joints to the frame of each link, shape (4, 4)
    # the parts that were read, of `links`, `joints`, `couplings` and `poses`
    parts: frozenset[str] = frozenset({"links", "joints", "couplings", "poses"})
    partial: bool = False  # whether the reader may leave out links that no joint moves
    misplaced: frozenset[str] = frozenset()  # links whose frames are not compared
    # frames of links as the file places them, independent of its joints, shape (4, 4)
    placements: Mapping[str, Array] = field(default_factory=dict)
    inertials: Mapping[str, Inertial] = field(default_factory=dict)  # mass properties of each link
    mass: float | None = None  # mass of everything in the file [kg]
    base: str = ""  # `fixed` or `free`; empty if the format cannot say it
    joints: Mapping[str, ReadJoint] = field(default_factory=dict)  # the joints that can move
    couplings: Mapping[str, Law] = field(default_factory=dict)  # law of each joint that follows
    # laws that the file repeats for single simulators, by simulator
    more_couplings: Mapping[str, Mapping[str, Law]] = field(default_factory=dict)
    colliders: Mapping[str, tuple[ReadCollider, ...]] = field(default_factory=dict)  # of each link
    faces: Mapping[str, tuple[Faces, ...]] = field(default_factory=dict)  # visible meshes of each link
    # link of each grasp and push, and the frame in the link's frame, shape (4, 4)
    holds: Mapping[str, tuple[str, Array]] | None = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()  # faults of the file that do not depend on the asset
    complaints: tuple[str, ...] = ()  # messages of the reader


@contextmanager
def collected_messages() -> Iterator[list[str]]:
    """Collect log messages and warnings instead of showing them."""
    messages: list[str] = []
    handler = logging.Handler(logging.WARNING)
    handler.emit = lambda record: messages.append(record.getMessage())  # type: ignore[method-assign]
    root = logging.getLogger()
    before = root.handlers[:]
    root.handlers[:] = [handler]
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            # yourdfpy calls a deprecated function of trimesh for every file
            warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
            yield messages
        messages += [str(item.message) for item in caught]
    finally:
        root.handlers[:] = before
