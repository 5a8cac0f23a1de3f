"""Helpers for USD layers, and Wikidata codes of categories.

Prims are authored as specs (`Sdf`) instead of through a stage, which composes and notifies after every change
and takes ten times as long. Tests run the validators of `pxr` on the result.
"""

import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, Sdf, Vt

from artgen._arrays import Array, Value, cached
from artgen.asset.record import DECIMALS
from artgen.errors import ExportError
from artgen.export.frames import quaternion

THING = "Q223557"
"""Code of a physical object, for categories without their own code."""

CATEGORY_CODES = {
    "box": "Q188075", "dishwasher": "Q186263", "door": "Q36794", "lamp": "Q1138737",
    "microwave": "Q127956", "oven": "Q36539", "refrigerator": "Q37828", "toaster": "Q14890",
    "trashcan": "Q216530", "window": "Q35473",
}  # fmt: skip
"""Wikidata codes by category; each was looked up. The code of `trashcan` is that of a waste container."""


def category_code(category: str) -> str:
    """Return the Wikidata code of a category; the code of a physical object if it has none."""
    return CATEGORY_CODES.get(category, THING)


Runtime = Literal["physx", "newton", "mujoco"]

RuntimeRow = tuple[Runtime, str, Mapping[str, Any]]
"""A simulator, an API schema that only it reads, and the attributes of the schema."""


@dataclass(frozen=True, eq=False)
class Layers:
    """Layers of an asset, each for one concern."""

    structure: Sdf.Layer  # bodies with their poses and labels, and grasp frames
    geometry: Sdf.Layer  # meshes
    looks: Sdf.Layer  # materials
    physics: Sdf.Layer | None = None  # physics for every simulator; None writes it to the prims themselves
    # attributes of single simulators; empty writes them to the prims, so that each must ignore the others'
    runtimes: Mapping[Runtime, Sdf.Layer] = field(default_factory=dict)
    scope: str = "looks"  # name of the scope of the materials
    maps: str = ""  # path of the material maps, relative to the layer of the materials
    openpbr: bool = False  # whether materials are written as OpenPBR networks as well

    @property
    def apart(self) -> bool:
        """Whether the attributes of simulators are separate."""
        return bool(self.runtimes)

    def physical(self, prim: Sdf.PrimSpec) -> Sdf.PrimSpec:
        """Return the prim for the physics of a prim."""
        return prim if self.physics is None else over(self.physics, prim.path)

    def add_runtime(self, prim: Sdf.PrimSpec, rows: Iterable["RuntimeRow"]) -> None:
        """Apply API schemas of single simulators to a prim, with their attributes."""
        for name, schema, values in rows:
            target = over(self.runtimes[name], prim.path) if self.runtimes else prim
            apply(target, schema)
            write(target, values)


def new_layer(extension: str, default_prim: str) -> Sdf.Layer:
    """Make an empty layer in memory with the conventions of all assets: z up, metres, kilograms."""
    layer = Sdf.Layer.CreateAnonymous(extension)
    layer.defaultPrim = default_prim
    root = layer.pseudoRoot
    root.SetInfo("upAxis", "Z")
    root.SetInfo("metersPerUnit", 1.0)
    root.SetInfo("kilogramsPerUnit", 1.0)
    return layer


def define(
    parent: Sdf.PrimSpec | Sdf.Layer,
    name: str,
    type_name: str = "",
    values: Mapping[str, Any] | None = None,
    *,
    schemas: Sequence[str] = (),
) -> Sdf.PrimSpec:
    """Add a prim; a prim without a type only extends the definition of a stronger layer.

    Args:
        parent: Parent prim or layer.
        name: Identifier, unique in the parent.
        type_name: Its schema.
        values: Its properties, see `write`.
        schemas: The API schemas applied to it.
    """
    specifier = Sdf.SpecifierDef if type_name else Sdf.SpecifierOver
    prim = Sdf.PrimSpec(parent, name, specifier, type_name)
    if schemas:
        apply(prim, *schemas)
    write(prim, values or {})
    return prim


def over(layer: Sdf.Layer, path: Sdf.Path) -> Sdf.PrimSpec:
    """Return the prim at a path of a layer; a new prim only extends the definition of other layers."""
    return layer.GetPrimAtPath(path) or Sdf.CreatePrimInLayer(layer, path)


def apply(prim: Sdf.PrimSpec, *schemas: str) -> None:
    """Apply API schemas to a prim, after its existing ones."""
    known = prim.GetInfo("apiSchemas").prependedItems
    prim.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=[*known, *schemas]))


def write(prim: Sdf.PrimSpec, values: Mapping[str, Any], *, interpolation: str = "") -> None:
    """Add properties to a prim.

    Args:
        prim: The prim.
        values: Values by name; None adds nothing. A path is the target of a relationship, or the source of a
            connection for inputs and outputs of shaders. Vectors, rotations and arrays are NumPy arrays.
        interpolation: Interpolation of the values on a mesh, for primvars and normals.
    """
    for name, value in values.items():
        if value is None:
            continue
        is_path = type(value) is Sdf.Path
        if is_path and not name.startswith(_OF_SHADERS):
            relationship = Sdf.RelationshipSpec(prim, name, custom=False)
            relationship.targetPathList.explicitItems = [value]
            continue
        kind, variability, convert = _declaration(name, type(value))
        spec = Sdf.AttributeSpec(prim, name, kind, variability)
        if is_path:
            spec.connectionPathList.explicitItems = [value]
        else:
            spec.default = value if convert is None else convert(value)
        if interpolation:
            spec.SetInfo("interpolation", interpolation)


def place(prim: Sdf.PrimSpec, pose: Array, scale: Sequence[float] | None = None) -> None:
    """Place a prim in its parent.

    Args:
        prim: The prim.
        pose: Rigid transform, shape (4, 4) [m].
        scale: Factors along its own axes, applied first; None leaves the prim unscaled.
    """
    values = {
        "xformOp:translate": np.round(pose[:3, 3], DECIMALS),
        "xformOp:orient": pose,
        "xformOp:scale": scale,
    }
    order = [name for name, value in values.items() if value is not None]
    write(prim, {**values, "xformOpOrder": order})


def vec3(value: Array | Sequence[float]) -> Gf.Vec3f:
    """Return a vector, shape (3,), in single precision."""
    return Gf.Vec3f(*_plain(value))


def quatf(rotation: Array) -> Gf.Quatf:
    """Return a rotation, shape (3, 3), as a quaternion in single precision."""
    return Gf.Quatf(*_turn(rotation))


def _vec3_array(values: Array | NDArray[np.float32]) -> Vt.Vec3fArray:
    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(values, np.float32) + np.float32(0.0))


def _int_array(values: NDArray[np.int64]) -> Vt.IntArray:
    return Vt.IntArray.FromNumpy(np.ascontiguousarray(values, np.int32))


def _shared(convert: Callable[[Any], Value]) -> Callable[[Sequence[Any]], Value]:
    """Return a conversion of sequences that repeats none: an asset has many equal labels and constants."""
    remembered = cached(256)(convert)
    return lambda values: remembered(tuple(values))


def _plain(values: Array | Sequence[float]) -> list[float]:
    """Return numbers without negative zeros."""
    listed: list[float] = values.tolist() if isinstance(values, np.ndarray) else list(values)
    return [float(value) + 0.0 for value in listed]


def _turn(matrix: Array) -> list[float]:
    """Return a rotation as a quaternion, rounded to the decimals in which machines agree."""
    return [round(value * _TURN_STEPS) / _TURN_STEPS for value in quaternion(matrix).tolist()]


TYPES = Sdf.ValueTypeNames

_TURN_STEPS = 1e13  # rounding steps of quaternions: finer than positions, because errors add up in a rotation

_OF_SHADERS = ("inputs:", "outputs:")
_VARYING = (*_OF_SHADERS, "omni:", "semantics:")  # words of other attributes are constant in time

_TYPES = {
    "Asset": "inputs:file",
    "Color3f": "inputs:diffuseColor inputs:emissiveColor inputs:base_color inputs:emission_color "
    "inputs:transmission_color",
    "Color3fArray": "primvars:displayColor",
    "Double": "height radius size",
    "Double3": "xformOp:scale xformOp:translate",
    "Float2": "inputs:st inputs:texcoord",
    "Float3": "inputs:geometry_normal inputs:in physics:diagonalInertia",
    "Float3Array": "extent",
    "Float4": "inputs:bias inputs:fallback inputs:scale",
    "FloatArray": "primvars:displayOpacity widths",
    "Int": "physxArticulation:solverPositionIterationCount",
    "IntArray": "curveVertexCounts faceVertexCounts faceVertexIndices primvars:st:indices",
    "Normal3f": "inputs:normal",
    "Normal3fArray": "normals",
    "Point3f": "physics:centerOfMass physics:localPos0 physics:localPos1",
    "Point3fArray": "points",
    "Quatd": "xformOp:orient",
    "Quatf": "physics:localRot0 physics:localRot1 physics:principalAxes",
    "String": "inputs:geomprop inputs:varname",
    "TexCoord2fArray": "primvars:st",
}
"""Attributes by type, if their Python value does not tell it; other numbers are `Float`, texts `Token`."""

_TYPE_OF = {name: kind for kind, names in _TYPES.items() for name in names.split()}

_CONVERTED: Mapping[Callable[[Any], Any], str] = {
    Sdf.AssetPath: "Asset",
    vec3: "Color3f Float3 Point3f",
    _vec3_array: "Color3fArray Float3Array Normal3fArray Point3fArray",
    lambda value: Gf.Vec3d(*_plain(value)): "Double3",
    lambda value: Gf.Vec4f(*value): "Float4",
    lambda value: Gf.Quatd(*_turn(value)): "Quatd",
    quatf: "Quatf",
    _shared(Vt.DoubleArray): "DoubleArray",
    Vt.FloatArray: "FloatArray",
    _int_array: "IntArray",
    Vt.Vec2fArray.FromNumpy: "TexCoord2fArray",
    _shared(Vt.TokenArray): "TokenArray",
}
"""Types by the function that converts their values; values of other types stay as they are."""

_CONVERSIONS = {kind: convert for convert, kinds in _CONVERTED.items() for kind in kinds.split()}


@cached(None)
def _declaration(name: str, value: type) -> tuple[Sdf.ValueTypeName, Sdf.Variability, Any]:
    """Return the type of an attribute, its variability, and the conversion of its values."""
    kind, of_mujoco = _TYPE_OF.get(name), name.startswith("mjc:")
    if kind is None and issubclass(value, int | float):
        kind = "Bool" if value is bool else "Double" if of_mujoco else "Float"
    elif kind is None and issubclass(value, list | tuple):
        kind = "DoubleArray" if of_mujoco else "TokenArray"
    elif kind is None:
        kind = "Float" if name.startswith("inputs:") and value is Sdf.Path else "Token"
    uniform = of_mujoco or (kind.startswith("Token") and not name.startswith(_VARYING))
    variability = Sdf.VariabilityUniform if uniform else Sdf.VariabilityVarying
    return getattr(TYPES, kind), variability, _CONVERSIONS.get(kind)


def text(layer: Sdf.Layer) -> bytes:
    """Return a layer as text."""
    return str(layer.ExportToString()).encode()


def binary(layer: Sdf.Layer) -> bytes:
    """Return a layer in the binary format.

    Raises:
        ExportError: The temporary directory cannot be written to.
    """
    # pxr writes this format to files only
    with tempfile.TemporaryDirectory() as directory:
        path = Path(directory) / "layer.usdc"
        if not layer.Export(str(path)):
            raise ExportError(f"cannot write the temporary file {path}; free some space or set TMPDIR")
        return path.read_bytes()
