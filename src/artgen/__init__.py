"""Procedural CAD of articulated, simulation-ready assets.

    asset = artgen.generate("door", seed=7)
    asset.export("out/door_7", formats=("urdf", "mjcf", "usd"))

A category is a typed function over the handles (`Float`, `Solid`, `Body`, ...) and the operations below; its
signature declares the parameters. Importing the package loads no simulator, no USD and no category.
"""

from artgen import asset_methods, catalog
from artgen.asset import Asset
from artgen.asset.certificate import Certificate
from artgen.catalog import generate
from artgen.dataset import Dataset, stream
from artgen.errors import (
    ArtgenError,
    AssetError,
    BuildError,
    CheckError,
    ClientError,
    EnvError,
    EvaluationError,
    ExportError,
    GraphError,
    InfeasibleError,
    ParameterError,
    RenderError,
)
from artgen.generator import Generator, category, generator, one_of, shades
from artgen.graph import Cache, Evaluation, Graph
from artgen.materials import COLORS, MATERIALS, Material, colored, material
from artgen.nodes import details
from artgen.nodes.body import detail, part, weld
from artgen.nodes.choose import require, switch
from artgen.nodes.condition import Condition, Dependency
from artgen.nodes.csg import array, coarse, enclosed, hull, intersection, shell, split, union
from artgen.nodes.extrude import extrude, revolve
from artgen.nodes.grasp_frames import Frame, frame, grasp_on, push_on
from artgen.nodes.half_section import half_section
from artgen.nodes.handles import (
    Body,
    Bool,
    Float,
    Path,
    Points,
    Profile,
    Scalar,
    Solid,
    Span,
    Vector,
    VectorLike,
)
from artgen.nodes.joint import Coupling, Joint, Prismatic, Revolute
from artgen.nodes.loft import loft
from artgen.nodes.measure import center_of_mass, mass
from artgen.nodes.path import arc, bezier, helix, line, polyline, spline
from artgen.nodes.points import along, grid, points, ring_points, row
from artgen.nodes.primitive import (
    board,
    bore,
    box,
    box_between,
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
from artgen.nodes.scalar import (
    and_,
    atan2,
    clamp,
    cos,
    floor,
    lerp,
    max_,
    min_,
    not_,
    or_,
    round_,
    sin,
    sqrt,
    tan,
)
from artgen.nodes.sweep import sweep
from artgen.nodes.text import text, text_width
from artgen.nodes.vector import X, Y, Z, cross, dot, norm, normalize, vector
from artgen.range_proof import prove_range
from artgen.sampling import Distribution, by, choice, count, fixed, given, loguniform, normal, uniform
from artgen.version import __version__

asset_methods.bind()

__all__ = [
    "COLORS",
    "MATERIALS",
    "ArtgenError",
    "Asset",
    "AssetError",
    "Body",
    "Bool",
    "BuildError",
    "Cache",
    "Certificate",
    "CheckError",
    "ClientError",
    "Condition",
    "Coupling",
    "Dataset",
    "Dependency",
    "Distribution",
    "EnvError",
    "Evaluation",
    "EvaluationError",
    "ExportError",
    "Float",
    "Frame",
    "Generator",
    "Graph",
    "GraphError",
    "InfeasibleError",
    "Joint",
    "Material",
    "ParameterError",
    "Path",
    "Points",
    "Prismatic",
    "Profile",
    "RenderError",
    "Revolute",
    "Scalar",
    "Solid",
    "Span",
    "Vector",
    "VectorLike",
    "X",
    "Y",
    "Z",
    "__version__",
    "along",
    "and_",
    "arc",
    "array",
    "atan2",
    "bezier",
    "board",
    "bore",
    "bow",
    "box",
    "box_between",
    "by",
    "capsule",
    "catalog",
    "category",
    "center_of_mass",
    "choice",
    "circle",
    "clamp",
    "coarse",
    "colored",
    "cos",
    "count",
    "cross",
    "cylinder",
    "cylinder_between",
    "detail",
    "details",
    "dome",
    "dot",
    "ellipse",
    "ellipsoid",
    "enclosed",
    "extrude",
    "fixed",
    "floor",
    "frame",
    "frustum",
    "generate",
    "generator",
    "given",
    "grasp_on",
    "grid",
    "half_section",
    "helix",
    "hull",
    "intersection",
    "lerp",
    "line",
    "loft",
    "loguniform",
    "mass",
    "material",
    "max_",
    "min_",
    "norm",
    "normal",
    "normalize",
    "not_",
    "one_of",
    "or_",
    "part",
    "points",
    "polygon",
    "polyline",
    "prove_range",
    "push_on",
    "rectangle",
    "regular_polygon",
    "require",
    "revolve",
    "ring",
    "ring_points",
    "round_",
    "row",
    "shades",
    "shell",
    "sin",
    "slot",
    "sphere",
    "spline",
    "split",
    "sqrt",
    "stream",
    "sweep",
    "switch",
    "tan",
    "text",
    "text_width",
    "torus",
    "tube",
    "uniform",
    "union",
    "vector",
    "wedge",
    "weld",
]
