"""Values that a reader found in an exported file."""

import logging
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset.report import Finding
from artgen.validate.readback.pieces import ReadCollider

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
class Said:
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
class Reading:
    """Values that one reader found in an exported asset.

    Attributes:
        file: Name of the file.
        frames: Function from the positions of all joints to the frame of each link, shape (4, 4).
        told: The parts that were read, of `links`, `joints`, `couplings` and `poses`.
        partial: Whether the reader may leave out links that no joint moves.
        misplaced: Names of links whose frames are not compared.
        standing: Frames of links as the file places them, independent of its joints, shape (4, 4).
        inertials: Mass properties of each link.
        mass: Mass of everything in the file; None if unknown [kg].
        base: `fixed` or `free`; empty if the format cannot say it.
        kinds: `revolute` or `prismatic` for each joint that can move.
        ends: Names of parent and child of each joint that can move.
        limits: Lowest and highest position of each joint that can move; None is unlimited [rad or m].
        axes: Axis of joints in the frame of the child, shape (3,).
        dynamics: Springs, dampers, friction and so on of each joint.
        couplings: Law of each joint that follows.
        more_couplings: Laws that the file repeats for single simulators, by simulator.
        colliders: Colliders of each link.
        faces: Visible meshes of each link.
        holds: Link of each grasp and push, and the frame in the link's frame, shape (4, 4) [m]; None if the
            layout has no such frames.
        findings: Faults of the file that do not depend on the asset.
        said: Complaints of the reader.
    """

    file: str
    frames: Frames
    told: frozenset[str] = frozenset({"links", "joints", "couplings", "poses"})
    partial: bool = False
    misplaced: frozenset[str] = frozenset()
    standing: Mapping[str, Array] = field(default_factory=dict)
    inertials: Mapping[str, Inertial] = field(default_factory=dict)
    mass: float | None = None
    base: str = ""
    kinds: Mapping[str, str] = field(default_factory=dict)
    ends: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    limits: Mapping[str, tuple[float, float] | None] = field(default_factory=dict)
    axes: Mapping[str, Array] = field(default_factory=dict)
    dynamics: Mapping[str, tuple[Said, ...]] = field(default_factory=dict)
    couplings: Mapping[str, Law] = field(default_factory=dict)
    more_couplings: Mapping[str, Mapping[str, Law]] = field(default_factory=dict)
    colliders: Mapping[str, tuple[ReadCollider, ...]] = field(default_factory=dict)
    faces: Mapping[str, tuple[Faces, ...]] = field(default_factory=dict)
    holds: Mapping[str, tuple[str, Array]] | None = field(default_factory=dict)
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
            # yourdfpy calls a deprecated function of trimesh for every file
            warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
            yield said
        said += [str(item.message) for item in caught]
    finally:
        root.handlers[:] = before
