"""Helpers for USD layers, and Wikidata codes of categories.

Prims are authored as specs (`Sdf`) instead of through a stage, which composes and notifies after every change
and takes ten times as long. Tests run the validators of `pxr` on the result.
"""

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, Sdf, Vt

from artgen._arrays import Array
from artgen.asset.record import DECIMALS
from artgen.errors import ExportError
from artgen.export.frames import quaternion

THING = "Q223557"
"""Code of a physical object, for categories without their own code."""

CATEGORY_CODES = {
    "box": "Q188075",
    "dishwasher": "Q186263",
    "door": "Q36794",
    "lamp": "Q1138737",
    "microwave": "Q127956",
    "oven": "Q36539",
    "refrigerator": "Q37828",
    "toaster": "Q14890",
    "trashcan": "Q216530",  # Wikidata: waste container
    "window": "Q35473",
}
"""Wikidata codes by category; each was looked up."""


def category_code(category: str) -> str:
    """Return the Wikidata code of a category; the code of a physical object if it has none."""
    return CATEGORY_CODES.get(category, THING)


TYPES = Sdf.ValueTypeNames

# decimals of a quaternion: one more than of positions, because errors add up in a rotation
_TURN_DECIMALS = 13

_PLACED = Vt.TokenArray(["xformOp:translate", "xformOp:orient"])
_PLACED_AND_SCALED = Vt.TokenArray([*_PLACED, "xformOp:scale"])


Runtime = Literal["physx", "newton", "mujoco"]

RUNTIMES: tuple[Runtime, ...] = ("physx", "newton", "mujoco")
"""Simulators with their own attributes in USD."""


@dataclass(frozen=True, eq=False)
class Layers:
    """Layers of an asset, each for one concern.

    Attributes:
        structure: Bodies with their poses and labels, and grasp frames.
        geometry: Meshes.
        looks: Materials.
        physics: Physics for every simulator; None writes it to the prims themselves.
        runtimes: Attributes of single simulators, by simulator; empty writes them to the prims as well, so
            that every simulator has to ignore those of the others.
        scope: Name of the scope of the materials.
        maps: Path of the material maps, relative to the layer of the materials.
        openpbr: Whether materials are written as OpenPBR networks as well.
    """

    structure: Sdf.Layer
    geometry: Sdf.Layer
    looks: Sdf.Layer
    physics: Sdf.Layer | None = None
    runtimes: Mapping[Runtime, Sdf.Layer] = field(default_factory=dict)
    scope: str = "looks"
    maps: str = ""
    openpbr: bool = False

    @property
    def apart(self) -> bool:
        """Whether the attributes of simulators are separate."""
        return bool(self.runtimes)

    def physical(self, prim: Sdf.PrimSpec) -> Sdf.PrimSpec:
        """Return the prim for the physics of a prim."""
        return prim if self.physics is None else over(self.physics, prim.path)

    def runtime(self, name: Runtime, prim: Sdf.PrimSpec) -> Sdf.PrimSpec:
        """Return the prim that holds the attributes for one simulator."""
        return over(self.runtimes[name], prim.path) if self.runtimes else prim


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
    parent: Sdf.PrimSpec | Sdf.Layer, name: str, type_name: str = "", schemas: Sequence[str] = ()
) -> Sdf.PrimSpec:
    """Add a prim; a prim without a type only extends the definition of a stronger layer.

    Args:
        parent: Parent prim or layer.
        name: Identifier, unique in the parent.
        type_name: Its schema.
        schemas: The API schemas applied to it.
    """
    specifier = Sdf.SpecifierDef if type_name else Sdf.SpecifierOver
    prim = Sdf.PrimSpec(parent, name, specifier, type_name)
    if schemas:
        apply(prim, *schemas)
    return prim


def over(layer: Sdf.Layer, path: Sdf.Path) -> Sdf.PrimSpec:
    """Return the prim at a path of a layer; a new prim only extends the definition of other layers."""
    return layer.GetPrimAtPath(path) or Sdf.CreatePrimInLayer(layer, path)


def apply(prim: Sdf.PrimSpec, *schemas: str) -> None:
    """Apply API schemas to a prim, after its existing ones."""
    known = prim.GetInfo("apiSchemas").prependedItems
    prim.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=[*known, *schemas]))


def write(
    prim: Sdf.PrimSpec,
    kind: Sdf.ValueTypeName,
    values: Mapping[str, Any],
    *,
    uniform: bool = False,
    interpolation: str = "",
) -> None:
    """Add attributes of one type to a prim.

    Args:
        prim: The prim.
        kind: Type of the attributes.
        values: Values by name.
        uniform: Whether the schema declares them as uniform: constant in time.
        interpolation: Interpolation of the values on a mesh, for primvars and normals.
    """
    variability = Sdf.VariabilityUniform if uniform else Sdf.VariabilityVarying
    for name, value in values.items():
        spec = Sdf.AttributeSpec(prim, name, kind, variability)
        spec.default = value
        if interpolation:
            spec.SetInfo("interpolation", interpolation)


def connect(prim: Sdf.PrimSpec, name: str, source: Sdf.Path, kind: Sdf.ValueTypeName = TYPES.Token) -> None:
    """Add an attribute connected to another attribute."""
    spec = Sdf.AttributeSpec(prim, name, kind)
    spec.connectionPathList.explicitItems = [source]


def relate(prim: Sdf.PrimSpec, name: str, target: Sdf.Path) -> None:
    """Add a relationship to one prim."""
    spec = Sdf.RelationshipSpec(prim, name, custom=False)
    spec.targetPathList.explicitItems = [target]


def place(prim: Sdf.PrimSpec, pose: Array, scale: Sequence[float] | None = None) -> None:
    """Place a prim in its parent.

    Args:
        prim: The prim.
        pose: Rigid transform, shape (4, 4) [m].
        scale: Factors along its own axes, applied first; None leaves the prim unscaled.
    """
    write(prim, TYPES.Double3, {"xformOp:translate": Gf.Vec3d(*_plain(np.round(pose[:3, 3], DECIMALS)))})
    write(prim, TYPES.Quatd, {"xformOp:orient": Gf.Quatd(*_turn(pose))})
    if scale is not None:
        write(prim, TYPES.Double3, {"xformOp:scale": Gf.Vec3d(*_plain(scale))})
    order = _PLACED if scale is None else _PLACED_AND_SCALED
    write(prim, TYPES.TokenArray, {"xformOpOrder": order}, uniform=True)


def vec3(value: Array | Sequence[float]) -> Gf.Vec3f:
    """Return a vector, shape (3,), in single precision."""
    return Gf.Vec3f(*_plain(value))


def vec3_array(values: Array | NDArray[np.float32]) -> Vt.Vec3fArray:
    """Return vectors, shape (n, 3), in single precision."""
    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(values, np.float32) + np.float32(0.0))


def int_array(values: NDArray[np.int64]) -> Vt.IntArray:
    """Return integers, shape (n,)."""
    return Vt.IntArray.FromNumpy(np.ascontiguousarray(values, np.int32))


def quatf(rotation: Array) -> Gf.Quatf:
    """Return a rotation, shape (3, 3), as a quaternion in single precision."""
    return Gf.Quatf(*_turn(rotation))


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


def _plain(values: Array | Sequence[float]) -> list[float]:
    """Return numbers without negative zeros."""
    plain: list[float] = (np.asarray(values) + 0.0).tolist()
    return plain


def _turn(matrix: Array) -> list[float]:
    """Return a rotation as a quaternion, rounded to the decimals in which machines agree."""
    return _plain(np.round(quaternion(matrix), _TURN_DECIMALS))
