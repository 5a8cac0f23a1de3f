"""Procedural CAD of articulated, simulation-ready assets.

    asset = artgen.generate("door", seed=7)
    asset.export("out/door_7", formats=("urdf", "mjcf", "usd"))

A category is a typed function over the handles (`Float`, `Solid`, `Body`, ...) and the operations below; its
signature declares the parameters. Importing the package loads no simulator, no USD and no category.
"""

import importlib
import sys
import typing

from artgen import asset_methods, catalog
from artgen.asset import Asset
from artgen.asset_methods import load
from artgen.catalog import generate
from artgen.errors import ArtgenError, BuildError, InfeasibleError, ParameterError
from artgen.generator import Generator, category, generator, one_of, shades
from artgen.graph import Graph
from artgen.materials import MATERIALS, Material, colored, material
from artgen.nodes import details
from artgen.nodes.body import detail, part, weld
from artgen.nodes.csg import array, bounding_collider, hull, shell, simplified_collider, union
from artgen.nodes.extrude import extrude, half_section, revolve
from artgen.nodes.grasp_frames import Frame, frame, grasp_on, push_on
from artgen.nodes.handles import Body, Bool, Float, Points, Profile, Scalar, Solid, Span, Vector, VectorLike
from artgen.nodes.joint import Condition, Dependency, Joint, Prismatic, Revolute, Screw, Spring
from artgen.nodes.loft import loft
from artgen.nodes.path import arc, bezier, helix, line, polyline, spline
from artgen.nodes.primitive import (
    bore,
    box,
    capsule,
    cylinder,
    cylinder_between,
    dome,
    ellipsoid,
    frustum,
    sphere,
    torus,
    tube,
    wedge,
)
from artgen.nodes.profile import bow, circle, ellipse, polygon, rectangle, regular_polygon, ring, slot
from artgen.nodes.region import Region
from artgen.nodes.scalar import atan2, clamp, cos, max_, min_, require, sin, sqrt, switch, tan
from artgen.nodes.sweep import sweep
from artgen.nodes.text import text
from artgen.nodes.vector import X, Y, Z, grid, ring_points, row, vector
from artgen.range_proof import prove_range
from artgen.sampling import by, choice, count, fixed, given, loguniform, truncated_normal, uniform
from artgen.version import __version__ as __version__

if typing.TYPE_CHECKING:
    from artgen.dataset import Dataset, stream

asset_methods.bind()


_MODULES = ("feel", "fittings", "images", "signals")


def __getattr__(name: str) -> typing.Any:
    """Import a module that few programs need, such as datasets with their processes, when it is used."""
    if name in _MODULES:
        return importlib.import_module(f"artgen.{name}")
    if name not in ("Dataset", "dataset", "stream"):
        raise AttributeError(
            f"module 'artgen' has no attribute {name!r}", name=name, obj=sys.modules[__name__]
        )
    dataset = importlib.import_module("artgen.dataset")
    return dataset if name == "dataset" else getattr(dataset, name)


def __dir__() -> list[str]:
    return [*__all__, "dataset", "errors", *_MODULES]


__all__ = [
    "MATERIALS", "ArtgenError", "Asset", "Body", "Bool", "BuildError", "Condition", "Dataset", "Dependency",
    "Float", "Frame", "Generator", "Graph", "InfeasibleError", "Joint", "Material", "ParameterError",
    "Points", "Prismatic", "Profile", "Region", "Revolute", "Scalar", "Screw", "Solid", "Span", "Spring",
    "Vector", "VectorLike", "X", "Y", "Z", "arc", "array", "atan2", "bezier", "bore", "bounding_collider",
    "bow", "box", "by", "capsule", "catalog", "category", "choice", "circle", "clamp", "colored", "cos",
    "count", "cylinder", "cylinder_between", "detail", "details", "dome", "ellipse", "ellipsoid", "extrude",
    "fixed", "frame", "frustum", "generate", "generator", "given", "grasp_on", "grid", "half_section",
    "helix", "hull", "line", "load", "loft", "loguniform", "material", "max_", "min_", "one_of", "part",
    "polygon", "polyline", "prove_range", "push_on", "rectangle", "regular_polygon", "require", "revolve",
    "ring", "ring_points", "row", "shades", "shell", "simplified_collider", "sin", "slot", "sphere",
    "spline", "sqrt", "stream", "sweep", "switch", "tan", "text", "torus", "truncated_normal", "tube",
    "uniform", "union", "vector", "wedge", "weld",
]  # fmt: skip
