"""Visual and collision geometry of a link and its grasp frames as USD prims."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Sdf, Vt

from artgen._arrays import Array
from artgen.asset import Asset, Link, Surface
from artgen.asset.affordance import Affordance
from artgen.asset.surface import texture_coordinates
from artgen.colliders import Convex
from artgen.export.frames import local, translation
from artgen.export.hulls import Hull
from artgen.export.usd.joints import STIFF
from artgen.export.usd.layer import Layers, apply, define, place, write

PART_LABEL = "SemanticsLabelsAPI:part"

_THICKNESS = 0.002  # width of the line between the fingers [m]
_PRIMITIVES = {"box": "Cube", "cylinder": "Cylinder", "sphere": "Sphere", "capsule": "Capsule"}
_CONTACTS = {"mjc:solimp": (0.95, 0.99, 0.0005, 0.5, 2.0), "mjc:solref": STIFF}


def write_content(
    layers: Layers,
    prims: tuple[Sdf.PrimSpec, Sdf.PrimSpec],
    asset: Asset,
    link: Link,
    of_link: Mapping[int, Hull],
    looks: Sdf.Path,
) -> None:
    """Add surfaces, colliders and grasps of a link.

    Args:
        layers: Layers for the physics of colliders.
        prims: The prim of the link in the layer of the bodies, and in that of the meshes.
        asset: The asset.
        link: The link.
        of_link: Its hulls by number of the collider.
        looks: The scope of the materials.
    """
    body, meshes = prims
    origin = asset.origin(link.name)
    define(body, "visuals", "Scope")
    visuals = define(meshes, "visuals")
    for surface in link.surfaces:
        _write_surface(visuals, surface, origin, looks.AppendChild(surface.material.name))
    primitives, hulls = define(body, "collisions", "Scope"), define(meshes, "collisions")
    for number, collider in enumerate(link.colliders):
        name, convex = f"{collider.convex.kind}_{number}", collider.convex
        if number in of_link:
            prim = _define_hull(hulls, name, of_link[number])
        else:
            prim = _define_primitive(primitives, name, convex, translation(-origin) @ convex.pose)
        write(prim, {"purpose": "guide"})  # invisible to cameras
        physics = layers.physical(prim)
        of_mesh = ["PhysicsMeshCollisionAPI"] if number in of_link else []
        apply(physics, "PhysicsCollisionAPI", "MaterialBindingAPI", *of_mesh)
        if collider.spare:
            write(physics, {"physics:collisionEnabled": False})
        if number in of_link:
            write(physics, {"physics:approximation": "convexHull"})
            layers.add_runtime(prim, [("newton", "NewtonMeshCollisionAPI", {})])
        write(physics, {"material:binding:physics": looks.AppendChild(collider.material.name)})
        layers.add_runtime(prim, [("mujoco", "MjcCollisionAPI", _CONTACTS)])
    for kind, scope_name in (("grasp", "grasps"), ("push", "pushes")):
        found = [each for each in asset.affordances if each.link == link.name and each.kind == kind]
        scope = define(body, scope_name, "Scope") if found else body
        for affordance in found:
            _write_hold(scope, affordance, local(asset, link.name, affordance.frame))


def _write_hold(scope: Sdf.PrimSpec, affordance: Affordance, pose: Array) -> None:
    """Add a grasp or push, invisible to cameras."""
    # z points along the approach, x of a grasp along closing; the joints that move are the nearest first
    prim = define(scope, affordance.name, "Xform", {"purpose": "guide"})
    data = {"joints": Vt.StringArray(affordance.joints), "kind": affordance.kind}
    place(prim, pose)
    if affordance.kind == "grasp":
        data["width"] = affordance.width
        # single precision from here on: readers compute the extent of the written values
        half, margin = np.float32(0.5 * affordance.width), np.float32(0.5) * np.float32(_THICKNESS)
        ends = np.array([[-half, 0.0, 0.0], [half, 0.0, 0.0]], np.float32)
        # SimReady identifies the line between the fingers by its name
        values = {
            "points": ends,
            "curveVertexCounts": np.array([2]),
            "type": "linear",
            "extent": ends + np.array([[-margin], [margin]]),
        }
        line = define(prim, f"grasp_identifier_{affordance.name}", "BasisCurves", values)
        write(line, {"widths": [_THICKNESS]}, interpolation="constant")
    prim.SetInfo("customData", {"artgen": data})


def _write_surface(scope: Sdf.PrimSpec, surface: Surface, origin: Array, material: Sdf.Path) -> None:
    """Add the mesh of a surface."""
    mesh, look = surface.mesh, surface.material
    values = {"semantics:labels:part": [surface.label], "material:binding": material}
    schemas = ["MaterialBindingAPI", PART_LABEL]
    prim = define(scope, surface.name, "Mesh", values, schemas=schemas)
    write(prim, _mesh(mesh.vertices - origin, mesh.triangles))
    uvs, indices = _indexed(texture_coordinates(mesh, look))
    write(prim, {"normals": mesh.normals, "primvars:st": uvs}, interpolation="vertex")
    write(prim, {"primvars:st:indices": indices})
    # for viewers that do not read materials
    plain = {
        "primvars:displayColor": np.array([look.base_color]),
        "primvars:displayOpacity": [look.opacity] if look.opacity < 1.0 else None,
    }
    write(prim, plain, interpolation="constant")


def _define_hull(scope: Sdf.PrimSpec, name: str, hull: Hull) -> Sdf.PrimSpec:
    prim = define(scope, name, "Mesh", _mesh(hull.vertices, hull.triangles))
    place(prim, translation(hull.middle))
    write(prim, {"normals": hull.normals}, interpolation="uniform")
    return prim


def _define_primitive(scope: Sdf.PrimSpec, name: str, convex: Convex, pose: Array) -> Sdf.PrimSpec:
    size, scale = convex.size, None
    values: dict[str, Any]
    if convex.kind == "box":
        # a cube has a single size, so a box is a scaled unit cube; the body above it stays unscaled
        values, half, scale = {"size": 1.0}, np.full(3, 0.5), size
    elif convex.kind == "sphere":
        values, half = {"radius": size[0]}, np.full(3, size[0])
    else:
        values = {"radius": size[0], "height": size[1], "axis": "Z"}
        half = np.array([size[0], size[0], 0.5 * size[1] + (size[0] if convex.kind == "capsule" else 0.0)])
    prim = define(scope, name, _PRIMITIVES[convex.kind], {**values, "extent": np.array([-half, half])})
    place(prim, pose, scale)
    return prim


def _mesh(points: Array, triangles: NDArray[np.int64]) -> dict[str, Any]:
    return {
        "points": points,
        "extent": np.array([points.min(axis=0), points.max(axis=0)]),
        "faceVertexCounts": np.full(len(triangles), 3, np.int32),
        "faceVertexIndices": triangles.ravel(),
        "subdivisionScheme": "none",
    }


def _indexed(uvs: Array) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Return the distinct texture coordinates in single precision and the number of each vertex's own."""
    single = np.ascontiguousarray(uvs, np.float32) + np.float32(0.0)
    # a pair of floats is one 64-bit key: sorting keys is many times faster than sorting rows
    keys, indices = np.unique(single.view(np.int64).ravel(), return_inverse=True)
    return np.ascontiguousarray(keys.view(np.float32).reshape(-1, 2)), indices
