"""Visual and collision geometry of a link and its grasp frames as USD prims."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from pxr import Sdf, Vt

from artgen._arrays import Array
from artgen.asset import Asset, Surface
from artgen.asset.affordance import Affordance
from artgen.asset.surface import texture_coordinates
from artgen.colliders import Convex
from artgen.export.frames import local, translation
from artgen.export.hulls import Hull
from artgen.export.usd.layer import (
    TYPES,
    Layers,
    apply,
    define,
    int_array,
    place,
    relate,
    vec3,
    vec3_array,
    write,
)
from artgen.export.usd.runtimes import write_runtime_collider

_THICKNESS = 0.002
"""Width of the line between the fingers [m]."""


def write_holds(prim: Sdf.PrimSpec, asset: Asset, found: Sequence[Affordance]) -> None:
    """Add the grasps and pushes of a link, invisible to cameras.

    Each is a frame with z along the approach; x of a grasp is the closing direction. Its custom data have the
    kind, the opening of the fingers [m] and the joints that a hand moves, the nearest first.

    Args:
        prim: The prim of the link.
        asset: The asset.
        found: Affordances of the link.
    """
    for kind, scope_name in (("grasp", "grasps"), ("push", "pushes")):
        of_kind = [each for each in found if each.kind == kind]
        if of_kind:
            scope = define(prim, scope_name, "Scope")
            for affordance in of_kind:
                _hold(scope, affordance, local(asset, affordance.link, affordance.frame))


def _hold(scope: Sdf.PrimSpec, affordance: Affordance, pose: Array) -> None:
    prim = define(scope, affordance.name, "Xform")
    said = {"joints": Vt.StringArray(affordance.joints), "kind": affordance.kind}
    if affordance.kind == "grasp":
        said["width"] = affordance.width
    prim.SetInfo("customData", {"artgen": said})
    write(prim, TYPES.Token, {"purpose": "guide"}, uniform=True)
    place(prim, pose)
    if affordance.kind == "grasp":
        _line(prim, affordance)


def _line(prim: Sdf.PrimSpec, affordance: Affordance) -> None:
    """Add the line between the fingers; SimReady identifies it by its name."""
    line = define(prim, f"grasp_identifier_{affordance.name}", "BasisCurves")
    # in single precision from here on: readers compute the extent of the written values
    half, margin = np.float32(0.5 * affordance.width), np.float32(0.5) * np.float32(_THICKNESS)
    ends = np.array([[-half, 0.0, 0.0], [half, 0.0, 0.0]], np.float32)
    write(line, TYPES.Point3fArray, {"points": vec3_array(ends)})
    write(line, TYPES.IntArray, {"curveVertexCounts": int_array(np.array([2]))})
    write(line, TYPES.Token, {"type": "linear"}, uniform=True)
    write(line, TYPES.FloatArray, {"widths": Vt.FloatArray([_THICKNESS])}, interpolation="constant")
    write(line, TYPES.Float3Array, {"extent": vec3_array(ends + np.array([[-margin], [margin]]))})


PART_LABEL = "SemanticsLabelsAPI:part"


def write_surface(scope: Sdf.PrimSpec, surface: Surface, origin: Array, material: Sdf.Path) -> None:
    """Add the mesh of a surface.

    Args:
        scope: The parent prim.
        surface: The faces, in asset coordinates.
        origin: The origin of the link's frame, shape (3,) [m].
        material: The prim of its material.
    """
    prim = define(scope, surface.name, "Mesh", ["MaterialBindingAPI", PART_LABEL])
    _label(prim, surface.label)
    relate(prim, "material:binding", material)
    mesh = surface.mesh
    _mesh(prim, mesh.vertices - origin, mesh.triangles)
    write(prim, TYPES.Normal3fArray, {"normals": vec3_array(mesh.normals)}, interpolation="vertex")
    values, indices = _indexed(texture_coordinates(mesh, surface.material))
    write(prim, TYPES.TexCoord2fArray, {"primvars:st": values}, interpolation="vertex")
    write(prim, TYPES.IntArray, {"primvars:st:indices": indices})
    # for viewers that do not read materials
    color = Vt.Vec3fArray([vec3(surface.material.base_color)])
    write(prim, TYPES.Color3fArray, {"primvars:displayColor": color}, interpolation="constant")
    if surface.material.opacity < 1.0:
        opacity = Vt.FloatArray([surface.material.opacity])
        write(prim, TYPES.FloatArray, {"primvars:displayOpacity": opacity}, interpolation="constant")


def write_hull(layers: Layers, scope: Sdf.PrimSpec, name: str, hull: Hull, material: Sdf.Path) -> None:
    """Add a hull collider, invisible to cameras.

    Args:
        layers: Layers for its physics.
        scope: The parent prim.
        name: Its name.
        hull: Its surface.
        material: The prim of its material, for friction.
    """
    prim = define(scope, name, "Mesh")
    _mesh(prim, hull.vertices, hull.triangles)
    place(prim, translation(hull.middle))
    write(prim, TYPES.Normal3fArray, {"normals": vec3_array(hull.normals)}, interpolation="uniform")
    _collide(layers, prim, material, hull=True)


def write_primitive(
    layers: Layers, scope: Sdf.PrimSpec, name: str, convex: Convex, origin: Array, material: Sdf.Path
) -> None:
    """Add a box or round collider, invisible to cameras.

    Args:
        layers: Layers for its physics.
        scope: The parent prim.
        name: Its name.
        convex: The piece, in asset coordinates.
        origin: The origin of the link's frame, shape (3,) [m].
        material: The prim of its material, for friction.
    """
    prim = define(scope, name, _PRIMITIVES[convex.kind])
    _primitive(prim, convex, origin)
    _collide(layers, prim, material, hull=False)


def write_label(prim: Sdf.PrimSpec, taxonomy: str, labels: list[str]) -> None:
    """Add the semantic labels of a prim that has `SemanticsLabelsAPI:<taxonomy>`."""
    write(prim, TYPES.TokenArray, {f"semantics:labels:{taxonomy}": Vt.TokenArray(labels)})


_PRIMITIVES = {"box": "Cube", "cylinder": "Cylinder", "sphere": "Sphere", "capsule": "Capsule"}


def _label(prim: Sdf.PrimSpec, label: str) -> None:
    write_label(prim, "part", [label])


def _collide(layers: Layers, prim: Sdf.PrimSpec, material: Sdf.Path, *, hull: bool) -> None:
    write(prim, TYPES.Token, {"purpose": "guide"}, uniform=True)
    physics = layers.physical(prim)
    apply(physics, *(_HULL if hull else _COLLISION))
    if hull:
        write(physics, TYPES.Token, {"physics:approximation": "convexHull"}, uniform=True)
    relate(physics, "material:binding:physics", material)
    write_runtime_collider(layers, prim, hull=hull)


_COLLISION = ("PhysicsCollisionAPI", "MaterialBindingAPI")

_HULL = (*_COLLISION, "PhysicsMeshCollisionAPI")


def _primitive(prim: Sdf.PrimSpec, convex: Convex, origin: Array) -> None:
    size = convex.size
    pose = translation(-origin) @ convex.pose
    if convex.kind == "box":
        # a cube has a single size, so a box is a scaled unit cube; the body above it stays unscaled
        write(prim, TYPES.Double, {"size": 1.0})
        _extent(prim, np.array([[-0.5] * 3, [0.5] * 3]))
        place(prim, pose, size)
        return
    write(prim, TYPES.Double, {"radius": size[0]})
    half = np.full(3, size[0])
    if convex.kind != "sphere":
        write(prim, TYPES.Double, {"height": size[1]})
        write(prim, TYPES.Token, {"axis": "Z"}, uniform=True)
        half[2] = 0.5 * size[1] + (size[0] if convex.kind == "capsule" else 0.0)
    _extent(prim, np.array([-half, half]))
    place(prim, pose)


def _mesh(prim: Sdf.PrimSpec, points: Array, triangles: NDArray[np.int64]) -> None:
    corners = triangles.ravel()
    write(prim, TYPES.Point3fArray, {"points": vec3_array(points)})
    _extent(prim, np.array([points.min(axis=0), points.max(axis=0)]))
    write(
        prim,
        TYPES.IntArray,
        {
            "faceVertexCounts": int_array(np.full(len(triangles), 3)),
            "faceVertexIndices": int_array(corners),
        },
    )
    write(prim, TYPES.Token, {"subdivisionScheme": "none"}, uniform=True)


def _extent(prim: Sdf.PrimSpec, corners: Array) -> None:
    write(prim, TYPES.Float3Array, {"extent": vec3_array(corners)})


def _indexed(uvs: Array) -> tuple[Vt.Vec2fArray, Vt.IntArray]:
    """Return the distinct texture coordinates and the number of each vertex's own."""
    single = np.ascontiguousarray(uvs, np.float32) + np.float32(0.0)
    # a pair of floats is one 64-bit key: sorting keys is many times faster than sorting rows
    keys, indices = np.unique(single.view(np.int64).ravel(), return_inverse=True)
    values = keys.view(np.float32).reshape(-1, 2)
    return Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(values)), int_array(indices)
