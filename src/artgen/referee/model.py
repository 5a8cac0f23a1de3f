"""An articulated model as a file of another tool describes it: bodies, convex colliders and joints.

Readers make it, one for each format; the referee judges it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from artgen.asset import AssetJoint
from artgen.colliders import Convex
from artgen.errors import AssetError

Format = Literal["urdf", "mjcf", "usd"]
Meshes = Literal["hull", "coacd"]
"""How a mesh becomes convex: as one hull, as most simulators take it, or decomposed by CoACD."""

SUFFIXES: dict[str, Format] = {
    ".urdf": "urdf",
    **dict.fromkeys((".xml", ".mjcf"), "mjcf"),
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), "usd"),
}
"""Formats by the end of a file's name."""

MOST_BODIES = 2_000
MOST_GEOMS = 20_000
MOST_BYTES = 200_000_000  # largest file that is read


@dataclass(frozen=True, eq=False)
class ForeignGeom:
    """A convex collider of a body."""

    name: str  # its name in the file or, without one, its body's name and a number; unique in the model
    convex: Convex  # in world coordinates while all joints are at position 0


@dataclass(frozen=True, eq=False)
class ForeignBody:
    """A rigid body and the joints between its parent and the body."""

    name: str  # its name in the file, unique in the model
    geoms: tuple[ForeignGeom, ...] = ()
    parent: str = ""  # name of its parent; empty for a body that is fixed to the world
    # in order from the parent, with the file's positions, limits in rad or m, and axes and pivots in world
    # coordinates at position 0; empty for a body that is welded to its parent
    joints: tuple[AssetJoint, ...] = ()
    # the reason why the body and its children are judged apart from all other bodies, such as
    # "free joint 'root'" or "ball joint 'neck'"; empty for most bodies
    apart: str = ""


@dataclass(frozen=True, eq=False)
class ForeignModel:
    """What a file says, as far as collisions depend on it."""

    path: Path
    format: Format
    bodies: tuple[ForeignBody, ...]  # parents before their children
    # pairs of bodies between which the file permits no collision, with the reason
    excluded: Mapping[frozenset[str], str] = field(default_factory=dict)
    # pairs of geoms between which the file permits no collision, though it does for others of their bodies
    exempt: frozenset[frozenset[str]] = frozenset()
    # joints that a constraint restricts beyond their limits, such as a closed loop, with its description
    restricted: Mapping[str, str] = field(default_factory=dict)
    # what is not judged, or not exactly as the file says, one sentence each
    notes: tuple[str, ...] = ()


def first_of(names: Sequence[str], most: int = 5) -> str:
    """Return the first names as text, and that there are more."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def counted(path: object, **counts: int) -> None:
    """Raise AssetError if a model has more bodies or geoms than the referee reads."""
    for kind, most in (("bodies", MOST_BODIES), ("geoms", MOST_GEOMS)):
        if counts.get(kind, 0) > most:
            raise AssetError(f"{path} has {counts[kind]} {kind}; at most {most} are read: split the file")
