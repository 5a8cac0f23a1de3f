"""Single prims of a USD stage: colliders as convex pieces, and joints with frames, limits and couplings."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from manifold3d import triangulate
from pxr import Gf, Usd, UsdPhysics

from artgen import _portable
from artgen._arrays import Array, Indices, affine
from artgen.colliders import Convex
from artgen.colliders.triangles import cross
from artgen.errors import AssetError
from artgen.referee.files import shown
from artgen.referee.meshes import Hulls

WORLD = "world"
"""Body of all colliders that are part of no rigid body."""

START = Usd.TimeCode.EarliestTime()
"""The time at which a stage is read."""

EVEN = 1e-6
"""Errors of angles and scales that come from numbers of single precision."""

_TURNS = {"X": np.eye(3)[:, [1, 2, 0]], "Y": np.eye(3)[:, [2, 0, 1]], "Z": np.eye(3)}  # from z to an axis
_AXES = ("transX", "transY", "transZ", "rotX", "rotY", "rotZ")
_ROUND = ("Cylinder", "Capsule", "Cone", "Cylinder_1", "Capsule_1")  # prims with an axis
_MEET = 1e-4  # distance of frames that meet in the authored pose [m or rad]
_UNREACHABLE = 1e5  # larger limits count as none [rad or m]
_SIDES = 64  # of a circle of a cone
_HALF = np.pi / _SIDES


def get(prim: Any, name: str, default: Any = None) -> Any:
    """Return the value of an attribute; the default if it has none."""
    attribute = prim.GetAttribute(name)
    value = attribute.Get(START) if attribute else None
    return default if value is None else value


def targets(prim: Any, name: str) -> list[Any]:
    """Return the paths that a relationship names."""
    relation = prim.GetRelationship(name)
    return list(relation.GetTargets()) if relation else []


def applied(prim: Any) -> list[str]:
    """Return the API schemas of a prim, including those unknown to OpenUSD."""
    schemas = prim.GetMetadata("apiSchemas")
    return [] if schemas is None else list(schemas.GetAppliedItems())


def named(prims: Iterable[Any]) -> dict[Any, str]:
    """Return the names of prims by their paths: the path itself where several have one name."""
    paths = [prim.GetPath() for prim in prims]
    count = Counter(path.name for path in paths)
    return {path: path.name if count[path.name] == 1 and path.name != WORLD else str(path) for path in paths}


def fault(prim: Any, text: str) -> AssetError:
    """Return an error in a prim."""
    name = prim.GetStage().GetRootLayer().GetDisplayName()
    return AssetError(f"{name}: {prim.GetTypeName()} {prim.GetPath()}: {text}")


def _axis(prim: Any, default: str) -> str:
    axis = str(get(prim, "physics:axis" if prim.IsA(UsdPhysics.Joint) else "axis", default))
    if axis not in _TURNS:
        raise fault(prim, f"its axis is {shown(axis)}; give X, Y or Z")
    return axis


def convexes(prim: Any, matrix: Array, hulls: Hulls) -> list[Convex]:
    """Return a collider as convex pieces; no pieces for an unknown type.

    Args:
        prim: The collider.
        matrix: Its transform, with scale [m].
        hulls: The maker of convex pieces of meshes.

    Raises:
        AssetError: It has a wrong number.
        ValueError: It has no volume.
    """
    if prim.GetTypeName() == "Mesh":
        return _mesh(prim, matrix, hulls)
    # the scale goes to the sizes first, so that facets of round pieces have their tolerance in meters
    matrix = _tidied(matrix)
    scale = float(np.linalg.norm(matrix[:3, :3], axis=0).max())
    if not scale > 0.0:
        raise ValueError("its scale is 0")
    matrix[:3, :3] /= scale
    if prim.GetTypeName() in _ROUND:
        matrix[:3, :3] = matrix[:3, :3] @ _TURNS[_axis(prim, "Z")]

    def size(name: str) -> float:
        value = float(get(prim, name, 0.0))
        if not 0.0 < value < np.inf:
            raise fault(prim, f"its {name} is {value:g}; give a positive number")
        return scale * value

    piece = _primitive(str(prim.GetTypeName()), size)
    return [piece.transformed(matrix)] if piece is not None else []


def _primitive(kind: str, size: Callable[[str], float]) -> Convex | None:
    """Return a primitive along z; None for an unknown type."""
    match kind:
        case "Cube":
            return Convex.box((size("size"),) * 3)
        case "Sphere":
            return Convex.sphere(size("radius"))
        case "Cylinder":
            return Convex.cylinder(size("radius"), size("height"))
        case "Capsule":
            return Convex.capsule(size("radius"), size("height"))
        case "Cone":
            return _tapered(size("radius"), 0.0, size("height"))
        case "Cylinder_1" | "Capsule_1":
            bottom, top, height = size("radiusBottom"), size("radiusTop"), size("height")
            if kind == "Capsule_1":
                return Convex.capsule(top, height) if bottom == top else None
            return Convex.cylinder(top, height) if bottom == top else _tapered(bottom, top, height)
    return None


def _tapered(bottom: float, top: float, length: float) -> Convex:
    """Return a hull around a cone along z, or around a part of one."""
    angle = 2.0 * _HALF * np.arange(_SIDES)
    circle = np.stack((_portable.cos(angle), _portable.sin(angle)), axis=1) / _portable.cos(_HALF)
    ends = ((bottom, -length / 2.0), (top, length / 2.0))
    rings = [np.column_stack((radius * circle, np.full(_SIDES, z))) for radius, z in ends]
    return Convex.hull(np.unique(np.concatenate(rings), axis=0))


def _tidied(matrix: Array) -> Array:
    """Return an affine matrix without the errors of single precision in its angles and scales."""
    result = matrix.copy()
    scales = np.linalg.norm(matrix[:3, :3], axis=0)
    if scales.min() > 0.0:
        unit = matrix[:3, :3] / scales
        if np.abs(unit.T @ unit - np.eye(3)).max() <= EVEN:
            left, _, right = np.linalg.svd(unit)
            even = np.ptp(scales) <= EVEN * scales.max()
            result[:3, :3] = left @ right * (np.full(3, scales.mean()) if even else scales)
    return result


def _mesh(prim: Any, matrix: Array, hulls: Hulls) -> list[Convex]:
    points, corners, counts = _faces(prim)
    shape = get(prim, "physics:approximation") if prim.HasAPI(UsdPhysics.MeshCollisionAPI) else None
    vertices = points @ matrix[:3, :3].T + matrix[:3, 3]
    if shape == "convexHull":
        return [Convex.hull(vertices[np.unique(corners)])]
    if shape in ("boundingCube", "boundingSphere"):
        used = np.unique(corners)
        low, high = points[used].min(axis=0), points[used].max(axis=0)
        placed = matrix.copy()
        placed[:3, 3] += matrix[:3, :3] @ (low + high) / 2.0
        if shape == "boundingCube":
            return [Convex.box(high - low).transformed(_tidied(placed))]
        placed[:3, :3] = np.eye(3)
        radius = np.linalg.norm(vertices[used] - placed[:3, 3], axis=1).max()
        return [Convex.sphere(float(radius), placed)]
    mirrored = (np.linalg.det(matrix[:3, :3]) < 0.0) != (get(prim, "orientation") == "leftHanded")
    used, number = np.unique(_triangles(points, corners, counts), return_inverse=True)
    triangles = number.reshape(-1, 3)
    parts = [(vertices[used], triangles[:, ::-1] if mirrored else triangles)]
    return list(hulls.pieces(prim.GetPath(), prim.GetName(), lambda: parts))


def _triangles(points: Array, corners: Indices, counts: Indices) -> Indices:
    """Return the triangles of faces with many corners: a fan for each, unless the fan leaves the face."""
    inner, first = np.maximum(counts - 2, 0), np.cumsum(counts) - counts
    face, start = np.repeat(np.arange(len(counts)), inner), np.repeat(first, inner)
    step = start + np.arange(len(face)) - np.repeat(np.cumsum(inner) - inner, inner)
    result = corners[np.stack((start, step + 1, step + 2), axis=1)]
    a, b, c = points[result].swapaxes(0, 1)
    normals, sums = cross(b - a, c - a), np.zeros((len(counts), 3))
    np.add.at(sums, face, normals)
    wrong = np.unique(face[np.einsum("ij,ij->i", normals, sums[face]) < 0.0])
    found = [result[~np.isin(face, wrong)]]
    for number in wrong.tolist():
        axis = int(np.abs(sums[number]).argmax())
        outline = corners[first[number] : first[number] + counts[number]]
        flat = points[outline][:, ((axis + 1) % 3, (axis + 2) % 3)]
        flat[:, 0] *= np.sign(sums[number, axis])
        found.append(outline[np.asarray(triangulate([flat]), np.int64).reshape(-1, 3)])
    return np.concatenate(found)


def _faces(prim: Any) -> tuple[Array, Indices, Indices]:
    """Return points of a mesh, vertices of its corners, and the number of corners of each face."""
    points = np.array(get(prim, "points", ()), np.float64).reshape(-1, 3)
    corners = np.array(get(prim, "faceVertexIndices", ()), np.int64)
    counts = np.array(get(prim, "faceVertexCounts", ()), np.int64)
    if not len(points) or not np.isfinite(points).all():
        raise fault(prim, "its points are missing or not finite; export the mesh again")
    if not len(counts) or counts.min() < 0 or counts.sum() != len(corners):
        raise fault(
            prim, f"its faces need {counts.sum()} vertices, but it names {len(corners)}; export it again"
        )
    wrong = corners[(corners < 0) | (corners >= len(points))]
    if len(wrong):
        raise fault(prim, f"a face has the vertex {wrong[0]} of {len(points)}; export the mesh again")
    return points, corners, counts


@dataclass(eq=False)
class StageJoint:
    """An enabled joint of a stage.

    Attributes:
        prim: Its prim.
        name: Its name, unique among joints.
        targets: Paths of the prims that it connects; None for the world.
        frames: Its frames at both ends in the authored pose, shape (4, 4), with z up [m].
        length: Meters per unit of length.
        motion: Its kind; `apart` for several axes.
        column: Number of its axis: 0 for x.
        ends: Names of the attributes of its limits; empty without an axis.
        why: Why its child is judged apart; empty for other kinds.
    """

    prim: Any
    name: str
    targets: tuple[Any, Any]
    frames: tuple[Array, Array]
    length: float
    motion: Literal["revolute", "prismatic", "welded", "apart", "distance"] = "welded"
    column: int = 0
    ends: tuple[str, ...] = ()
    why: str = ""

    def __post_init__(self) -> None:
        if self.prim.IsA(UsdPhysics.RevoluteJoint) or self.prim.IsA(UsdPhysics.PrismaticJoint):
            self.motion = "revolute" if self.prim.IsA(UsdPhysics.RevoluteJoint) else "prismatic"
            self.column = "XYZ".index(_axis(self.prim, "X"))
            self.ends = ("physics:lowerLimit", "physics:upperLimit")
        elif self.prim.IsA(UsdPhysics.SphericalJoint):
            self.motion, self.why = "apart", f"ball joint {self.name!r}"
        elif self.prim.IsA(UsdPhysics.DistanceJoint):
            self.motion = "distance"
        elif not self.prim.IsA(UsdPhysics.FixedJoint):
            self._set_generic()

    def _set_generic(self) -> None:
        """Set the motion of a joint that is locked by limits of its axes."""
        free = []
        for axis in _AXES:
            low, high = (float(get(self.prim, name, end)) for name, end in _ends(axis).items())
            limited = f"PhysicsLimitAPI:{axis}" in applied(self.prim)
            if not limited or not (low > high or low == high == 0.0):
                free.append(axis)
        if len(free) == 1:
            self.motion = "revolute" if free[0].startswith("rot") else "prismatic"
            self.column = "XYZ".index(free[0][-1])
            self.ends = tuple(_ends(free[0]))
        elif free:
            kind = "free joint" if len(free) == len(_AXES) else f"joint of {len(free)} axes"
            self.motion, self.why = "apart", f"{kind} {self.name!r}"

    @property
    def moves(self) -> bool:
        """Whether it is a revolute or prismatic joint."""
        return self.motion in ("revolute", "prismatic")

    @property
    def unit(self) -> float:
        """SI units per unit of its positions: radians per degree, or meters per unit of length."""
        return np.pi / 180.0 if self.motion == "revolute" else self.length

    def limits(self) -> tuple[float, float]:
        """Return its limits [rad or m], infinite ones without a limit.

        Raises:
            AssetError: They are inverted or not numbers.
        """
        found = zip(self.ends, (-np.inf, np.inf), strict=True)
        low, high = (float(get(self.prim, name, end)) for name, end in found)
        if not low <= high:
            raise fault(self.prim, f"its limits are {low:g} and {high:g}; give the lower one first")
        low, high = low * self.unit, high * self.unit
        return (low if low > -_UNREACHABLE else -np.inf), (high if high < _UNREACHABLE else np.inf)

    def meets(self) -> bool:
        """Tell whether its frames differ in the authored pose by its own motion only."""
        between = np.linalg.inv(self.frames[0]) @ self.frames[1]
        if self.motion == "prismatic":
            between[self.column, 3] = 0.0
        if self.motion == "revolute":
            between[:3, :3] = np.eye(3) + np.abs(between[:3, self.column] - np.eye(3)[self.column]).max()
        return bool(np.abs(between - np.eye(4)).max() <= _MEET)

    def laws(self, moving: Mapping[Any, "StageJoint"]) -> Iterator[tuple[Any, float, float]]:
        """Yield leader, ratio and offset [rad, m] in the schemas of PhysX, Newton and MuJoCo.

        Args:
            moving: Joints by their paths.
        """

        def unit(target: Any) -> float:
            return moving[target].unit if target in moving else self.unit

        def numbers(*names: str) -> list[float]:
            return [float(get(self.prim, name, 0.0)) for name in names]

        for schema in applied(self.prim):
            kind, _, instance = schema.partition(":")
            prefix = f"physxMimicJoint:{instance}:"
            for target in (
                targets(self.prim, f"{prefix}referenceJoint") if kind == "PhysxMimicJointAPI" else ()
            ):
                # position + gearing * leader + offset = 0 in degrees and units of length
                gearing, offset = numbers(f"{prefix}gearing", f"{prefix}offset")
                yield target, -gearing * self.unit / unit(target), -offset * self.unit
        if get(self.prim, "newton:mimicEnabled", True):
            for target in targets(self.prim, "newton:mimicJoint"):
                offset, ratio = numbers("newton:mimicCoef0", "newton:mimicCoef1")
                yield target, ratio, offset * self.unit
        for target in targets(self.prim, "mjc:target"):
            offset, ratio, *curved = numbers(*(f"mjc:coef{power}" for power in range(5)))
            yield target, np.nan if any(curved) else ratio, offset


def _ends(axis: str) -> dict[str, float]:
    """Return the attributes of the limits of an axis of a generic joint, with their defaults."""
    return {f"limit:{axis}:physics:low": -np.inf, f"limit:{axis}:physics:high": np.inf}


def joint_frame(prim: Any, end: int, matrix: Array) -> Array:
    """Return the frame of a joint at one end, shape (4, 4), where the prim at that end is placed by a matrix.

    Raises:
        AssetError: The frame has no finite numbers or no rotation.
    """
    at = np.array(get(prim, f"physics:localPos{end}", (0.0, 0.0, 0.0)), np.float64)
    turn = Gf.Quatd(get(prim, f"physics:localRot{end}", Gf.Quatf(1.0)))
    if not (np.isfinite(at).all() and 1e-3 < turn.GetLength() < np.inf):
        found = f"localPos{end} is {tuple(at.tolist())} and its localRot{end} {turn}"
        raise fault(prim, f"its {found}; give finite numbers and a rotation other than 0")
    # Gf.Rotation would lose precision near 0: its angle is an arccosine
    rotation = _rotation(matrix) @ np.array(Gf.Matrix3d(turn.GetNormalized())).T
    return affine(rotation, matrix[:3, :3] @ at + matrix[:3, 3])


def _rotation(matrix: Array) -> Array:
    """Return the rotation of an affine matrix, without its scale and reflection, shape (3, 3)."""
    left, _, right = np.linalg.svd(matrix[:3, :3])
    turn: Array = left @ right * np.sign(np.linalg.det(left @ right))
    return turn
