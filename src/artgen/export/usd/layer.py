"""Helpers for writing USD layers, and Wikidata codes of categories.

Prims are authored as specs (`Sdf`), not through a stage: a stage composes and notifies after every word,
which takes ten times as long. What a stage would check is checked by the validators of `pxr` in the tests.
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
"""A physical object: what every asset is whose category has no code here."""

CATEGORY_CODES = {
    "box": "Q188075",
    "dishwasher": "Q186263",
    "door": "Q36794",
    "lamp": "Q1138737",
    "microwave": "Q127956",
    "oven": "Q36539",
    "refrigerator": "Q37828",
    "toaster": "Q14890",
    "trashcan": "Q216530",  # Wikidata says waste container
    "window": "Q35473",
}
"""Codes by name of the category; a code stands here only if somebody has looked it up."""


def category_code(category: str) -> str:
    """Return the Q-code of a category; that of a physical object if the category has no code."""
    return CATEGORY_CODES.get(category, THING)


TYPES = Sdf.ValueTypeNames

_TURN_DECIMALS = 13  # of a quaternion: one more than of positions, for its errors add up in a rotation

_PLACED = Vt.TokenArray(["xformOp:translate", "xformOp:orient"])
_PLACED_AND_SCALED = Vt.TokenArray([*_PLACED, "xformOp:scale"])


Runtime = Literal["physx", "newton", "mujoco"]

RUNTIMES: tuple[Runtime, ...] = ("physx", "newton", "mujoco")
"""The simulators that have words of their own in USD."""


@dataclass(frozen=True, eq=False)
class Layers:
    """The layers that an asset is written to, each the place of one concern.

    Attributes:
        structure: Bodies, where they stand, their labels and where hands act.
        geometry: Meshes.
        looks: Materials.
        physics: What every simulator knows; None leaves it on the prims that it is about.
        runtimes: What only one simulator knows, by simulator; empty leaves it on the prims as well, so that
            every simulator has to read past the words of the others.
        scope: Name of the scope of the materials.
        maps: Where the materials' maps lie, seen from the layer of the materials.
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
        """Whether no simulator sees the words of another."""
        return bool(self.runtimes)

    def physical(self, prim: Sdf.PrimSpec) -> Sdf.PrimSpec:
        """Return where a prim's physics is written."""
        return prim if self.physics is None else over(self.physics, prim.path)

    def runtime(self, name: Runtime, prim: Sdf.PrimSpec) -> Sdf.PrimSpec:
        """Return the prim that holds the attributes for one simulator."""
        return over(self.runtimes[name], prim.path) if self.runtimes else prim


def new_layer(extension: str, default_prim: str) -> Sdf.Layer:
    """Make an empty layer in memory with the conventions of every asset: z up, metres, kilograms."""
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
    """Add a prim; one without a type only adds to what a stronger layer defines.

    Args:
        parent: The prim, or the layer, that it belongs to.
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
    """Return the prim at a path of a layer; one that is not there yet adds to what other layers define."""
    return layer.GetPrimAtPath(path) or Sdf.CreatePrimInLayer(layer, path)


def apply(prim: Sdf.PrimSpec, *schemas: str) -> None:
    """Apply API schemas to a prim, after those that it has."""
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
        kind: Their type.
        values: Their values by name.
        uniform: Whether their schema says that they cannot vary in time.
        interpolation: Which elements of a mesh the values belong to, for primvars and normals.
    """
    variability = Sdf.VariabilityUniform if uniform else Sdf.VariabilityVarying
    for name, value in values.items():
        spec = Sdf.AttributeSpec(prim, name, kind, variability)
        spec.default = value
        if interpolation:
            spec.SetInfo("interpolation", interpolation)


def connect(prim: Sdf.PrimSpec, name: str, source: Sdf.Path, kind: Sdf.ValueTypeName = TYPES.Token) -> None:
    """Add an attribute that takes its value from another attribute."""
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
        scale: Factors along its own axes, which act first; None leaves the prim unscaled.
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
    """Return numbers without negative zeros, which would read oddly in the text."""
    plain: list[float] = (np.asarray(values) + 0.0).tolist()
    return plain


def _turn(matrix: Array) -> list[float]:
    """Return a rotation as a quaternion, to the decimals in which machines agree."""
    return _plain(np.round(quaternion(matrix), _TURN_DECIMALS))
