"""What a reader found in an exported file, and what it should have found."""

import logging
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset

Array = NDArray[np.float64]
Frames = Callable[[Mapping[str, float]], dict[str, Array]]


@dataclass(frozen=True, eq=False)
class Inertial:
    """Mass properties of a link as a file has them.

    Attributes:
        mass: [kg].
        center: Centre of mass in the link's frame, shape (3,) [m].
        inertia: About the centre, along the axes of the link's frame, shape (3, 3) [kg m^2].
    """

    mass: float
    center: Array
    inertia: Array


@dataclass(frozen=True, eq=False)
class Reading:
    """What one reader found in an exported asset.

    Attributes:
        file: Name of the file.
        frames: Gives the frame of each link, shape (4, 4), at positions of all joints.
        inertials: Mass properties of each link.
        kinds: `revolute` or `prismatic` for each joint that can move.
        limits: Lowest and highest position of each joint that can move; None is unlimited [rad or m].
        axes: Axis in the child's frame, shape (3,), of the joints of which the file tells it.
        couplings: Leader, ratio and offset of each joint that follows.
        colliders: Number and total volume of the colliders of each link [m^3].
        said: What the reader complained of.
    """

    file: str
    frames: Frames
    inertials: dict[str, Inertial] = field(default_factory=dict)
    kinds: dict[str, str] = field(default_factory=dict)
    limits: dict[str, tuple[float, float] | None] = field(default_factory=dict)
    axes: dict[str, Array] = field(default_factory=dict)
    couplings: dict[str, tuple[str, float, float]] = field(default_factory=dict)
    colliders: dict[str, tuple[int, float]] = field(default_factory=dict)
    said: tuple[str, ...] = ()


@contextmanager
def listening() -> Iterator[list[str]]:
    """Collect what is logged or warned of meanwhile instead of showing it."""
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


def sampled_positions(asset: Asset, count: int) -> list[dict[str, float]]:
    """Return poses of the free joints: as the asset stands, and others drawn over the whole ranges."""
    draw = np.random.default_rng(0)
    spans = {joint.name: joint.limits or (-np.pi, np.pi) for joint in asset.free_joints}
    drawn = [{name: float(draw.uniform(*span)) for name, span in spans.items()} for _ in range(count)]
    return [{}, *drawn]


def mesh_volume(vertices: Array, triangles: NDArray[np.int64]) -> float:
    """Return the volume inside closed triangles, shape (m, 3) [m^3]."""
    a, b, c = (vertices - vertices.mean(axis=0))[triangles.T]
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)
