"""Writing assets to USD: a light text layer with the physics, and a binary layer with the meshes."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Sdf, Vt

from artgen.asset import Asset, Grasp, Link
from artgen.export.frames import (
    INTERMEDIATE_INERTIA,
    INTERMEDIATE_MASS,
    Frame,
    base_frame,
    chain,
    local,
    unused,
)
from artgen.export.hulls import hulls
from artgen.export.losses import Written, look_losses
from artgen.export.maps import map_files
from artgen.export.usd_geometry import (
    PART_LABEL,
    write_hull,
    write_label,
    write_primitive,
    write_surface,
)
from artgen.export.usd_joints import joint_losses, write_fixed_joint, write_joints
from artgen.export.usd_layer import (
    TYPES,
    binary,
    define,
    new_layer,
    place,
    quatf,
    text,
    vec3,
    write,
)
from artgen.export.usd_material import write_material

Array = NDArray[np.float64]


def write_usd(asset: Asset, textures: int = 0) -> Written:
    """Write an asset to USD.

    `<name>.usda` has the bodies, joints, primitive colliders, materials and labels; as sublayer it has
    `<name>_geometry.usdc`, which has the meshes. Bodies are siblings below the default prim, unscaled; their
    frames are the link frames as the asset stands. Joints move along or about x of their frames, in degrees.

    Args:
        asset: The asset.
        textures: Texels on a side of the materials' maps; 0 for colours alone.

    Returns:
        Both layers and the map files, and what USD cannot say.
    """
    writer = _Writer(asset, textures)
    with Sdf.ChangeBlock():
        writer.write()
    geometry = f"{asset.name}_geometry.usdc"
    writer.physics.subLayerPaths = [f"./{geometry}"]
    files = {f"{asset.name}.usda": text(writer.physics), geometry: binary(writer.geometry)}
    losses = (*joint_losses(asset, writer.segments), *look_losses(asset, textures))
    return Written({**files, **writer.maps.files}, losses)


class _Writer:
    """The two layers of one asset.

    Attributes:
        asset: The asset.
        physics: The text layer.
        geometry: The layer of the meshes.
        segments: The joints with the frames that they join.
        maps: The maps of the materials.
    """

    def __init__(self, asset: Asset, textures: int) -> None:
        self.asset = asset
        self.maps = map_files(asset, textures)
        self.physics = new_layer(".usda", asset.name)
        self.geometry = new_layer(".usdc", asset.name)
        self.segments = chain(asset)
        taken = {segment.child.name for segment in self.segments} | {asset.links[0].name}
        self._joints_name = unused("joints", taken)
        self._looks_name = unused("looks", taken)

    def write(self) -> None:
        """Author both layers."""
        self._root = _root(self.asset, self.physics)
        self._meshes = define(self.geometry, self.asset.name)
        looks = define(self._root, self._looks_name, "Scope")
        for material in self.asset.materials:
            write_material(looks, material, self.maps.of(material))
        self._body(base_frame(self.asset))
        for segment in self.segments:
            self._body(segment.child)
        self._joints()

    def _joints(self) -> None:
        scope = define(self._root, self._joints_name, "Scope")
        if self.asset.base == "fixed":
            name = unused("root_joint", {joint.name for joint in self.asset.joints})
            base = self._root.path.AppendChild(self.asset.links[0].name)
            write_fixed_joint(scope, name, (None, base))
        write_joints(scope, self.asset, self.segments)

    def _body(self, frame: Frame) -> None:
        schemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
        link = frame.link
        if link is None:
            prim = define(self._root, frame.name, "Xform", schemas)
            _mass(prim, INTERMEDIATE_MASS, np.zeros(3), np.full(3, INTERMEDIATE_INERTIA), np.eye(3))
        else:
            if link is self.asset.links[0] and self.asset.base == "free":
                # which body is the root of a free articulation is left to chance unless one is marked
                schemas.append("PhysicsArticulationRootAPI")
            prim = define(self._root, frame.name, "Xform", [*schemas, PART_LABEL])
            write_label(prim, "part", [link.label])
            properties = link.mass_properties
            moments, axes = properties.principal()
            _mass(prim, properties.mass, properties.center - frame.origin, moments, axes)
            self._content(prim, link, frame.origin)
        place(prim, frame.placement)

    def _content(self, prim: Sdf.PrimSpec, link: Link, origin: Array) -> None:
        """Write what a link looks like, collides with and is held at; meshes go to the binary layer."""
        looks = self._root.path.AppendChild(self._looks_name)
        meshes = define(self._meshes, link.name)
        visuals = define(prim, "visuals", "Scope"), define(meshes, "visuals")
        for surface in link.surfaces:
            write_surface(visuals[1], surface, origin, looks.AppendChild(surface.material.name))
        collisions = define(prim, "collisions", "Scope"), define(meshes, "collisions")
        of_link = hulls(self.asset)[link.name]
        for number, collider in enumerate(link.colliders):
            name = f"{collider.convex.kind}_{number}"
            material = looks.AppendChild(collider.material.name)
            if number in of_link:
                write_hull(collisions[1], name, of_link[number], material)
            else:
                write_primitive(collisions[0], name, collider.convex, origin, material)
        if link.grasps:
            grasps = define(prim, "grasps", "Scope")
            for grasp in link.grasps:
                _grasp(grasps, grasp, local(self.asset, link.name, grasp.frame))


def _root(asset: Asset, layer: Sdf.Layer) -> Sdf.PrimSpec:
    schemas = ["SemanticsLabelsAPI:category"]
    if asset.base == "fixed":
        schemas.insert(0, "PhysicsArticulationRootAPI")
    prim = define(layer, asset.name, "Xform", schemas)
    prim.SetInfo("kind", "component")
    prim.SetInfo("assetInfo", {"name": asset.name, "version": asset.version})
    made = {
        "attempt": asset.attempt,
        "category": asset.category,
        "parameters": asset.parameters,
        "seed": asset.seed,
        "version": asset.version,
    }
    prim.SetInfo("customData", {"artgen": _dictionary(made)})
    write_label(prim, "category", [asset.category])
    return prim


def _mass(prim: Sdf.PrimSpec, mass: float, center: Array, moments: Array, axes: Array) -> None:
    """Write all four mass properties: simulators derive those that are missing from the colliders."""
    write(prim, TYPES.Float, {"physics:mass": mass})
    write(prim, TYPES.Point3f, {"physics:centerOfMass": vec3(center)})
    write(prim, TYPES.Float3, {"physics:diagonalInertia": vec3(moments)})
    write(prim, TYPES.Quatf, {"physics:principalAxes": quatf(axes)})


def _grasp(scope: Sdf.PrimSpec, grasp: Grasp, pose: Array) -> None:
    prim = define(scope, grasp.name, "Xform")
    prim.SetInfo("customData", {"artgen": {"width": grasp.width}})
    write(prim, TYPES.Token, {"purpose": "guide"}, uniform=True)
    place(prim, pose)


def _dictionary(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values as metadata, which has no word for None."""
    return {str(name): _custom(value) for name, value in values.items() if value is not None}


def _custom(value: Any) -> Any:
    """Return a value of a type that metadata can hold, as JSON text where there is no such type."""
    if isinstance(value, bool | str | float):
        return value
    if isinstance(value, int) and -(2**31) <= value < 2**31:
        return value
    if isinstance(value, Mapping):
        return _dictionary(value)
    if isinstance(value, list | tuple) and all(isinstance(item, int | float) for item in value):
        return Vt.DoubleArray([float(item) for item in value])
    return json.dumps(value, default=str)
