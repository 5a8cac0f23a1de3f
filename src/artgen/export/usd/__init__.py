"""USD: a light text layer with the physics, and a binary layer with the meshes."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
from pxr import Sdf, Vt

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.export.frames import (
    INTERMEDIATE_INERTIA,
    INTERMEDIATE_MASS,
    LinkFrame,
    base_frame,
    chain,
    unused,
)
from artgen.export.hulls import hulls
from artgen.export.losses import Written, look_rows, losses
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, map_files
from artgen.export.usd.geometry import (
    PART_LABEL,
    write_holds,
    write_hull,
    write_label,
    write_primitive,
    write_surface,
)
from artgen.export.usd.joints import joint_losses, write_fixed_joint, write_joints
from artgen.export.usd.layer import (
    TYPES,
    Layers,
    apply,
    binary,
    category_code,
    define,
    new_layer,
    over,
    place,
    quatf,
    text,
    vec3,
    write,
)
from artgen.export.usd.materials import write_material
from artgen.export.usd.runtimes import write_runtime_body, write_runtime_root


def write_usd(asset: Asset, textures: int = 0) -> Written:
    """Write an asset to USD.

    `<name>.usda` has the bodies, joints, primitive colliders, materials and labels; its sublayer
    `<name>_geometry.usdc` has the meshes. Bodies are unscaled siblings below the default prim; their frames
    are the link frames at the initial positions. Joints move along or about x of their frames, in degrees.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.

    Returns:
        Both layers and the map files, and the losses of USD.
    """
    main, geometry = new_layer(".usda", asset.name), new_layer(".usdc", asset.name)
    written = author(asset, Layers(main, geometry, main, maps=f"./{TEXTURE_DIRECTORY}"), textures)
    meshes = f"{asset.name}_geometry.usdc"
    main.subLayerPaths = [f"./{meshes}"]
    files = {f"{asset.name}.usda": text(main), meshes: binary(geometry)}
    return Written({**files, **written.files}, written.losses)


def author(asset: Asset, layers: Layers, textures: int) -> Written:
    """Write an asset to layers.

    Args:
        asset: The asset.
        layers: The layers; the default prim of each has the name of the asset.
        textures: Texels per side of the material maps; 0 for colors only.

    Returns:
        The map files, and the losses of USD.
    """
    maps = map_files(asset, textures)
    writer = _Writer(asset, layers, maps)
    with Sdf.ChangeBlock():
        writer.write()
    lost = joint_losses(asset, writer.segments, apart=layers.apart)
    return Written(maps.files, (*lost, *losses(*look_rows(asset, textures))))


class _Writer:
    """The layers of one asset under construction."""

    def __init__(self, asset: Asset, layers: Layers, maps: MapFiles) -> None:
        # the asset
        self.asset = asset
        # the layers
        self.layers = layers
        # the maps of the materials
        self.maps = maps
        # joints with their frames
        self.segments = chain(asset)
        self._affordances = asset.affordances
        taken = {segment.child.name for segment in self.segments} | {asset.links[0].name}
        self._joints_name = unused("joints", taken)
        self._looks_name = unused(layers.scope, taken)

    def write(self) -> None:
        """Author all layers."""
        self._root = _root(self.asset, self.layers)
        self._meshes = over(self.layers.geometry, self._root.path)
        self._materials()
        self._body(base_frame(self.asset))
        for segment in self.segments:
            self._body(segment.child)
        self._joints()

    def _materials(self) -> None:
        looks = define(over(self.layers.looks, self._root.path), self._looks_name, "Scope")
        seen = {surface.material.name for link in self.asset.links for surface in link.surfaces}
        for material in self.asset.materials:
            write_material(self.layers, looks, material, self.maps.of(material), seen=material.name in seen)

    def _joints(self) -> None:
        scope = define(self.layers.physical(self._root), self._joints_name, "Scope")
        if self.asset.base == "fixed":
            name = unused("root_joint", {joint.name for joint in self.asset.joints})
            base = self._root.path.AppendChild(self.asset.links[0].name)
            write_fixed_joint(scope, name, (None, base))
        write_joints(self.layers, scope, self.asset, self.segments)

    def _body(self, frame: LinkFrame) -> None:
        link = frame.link
        prim = define(self._root, frame.name, "Xform", [] if link is None else [PART_LABEL])
        physics = self.layers.physical(prim)
        apply(physics, "PhysicsRigidBodyAPI", "PhysicsMassAPI")
        write_runtime_body(self.layers, prim)
        if link is None:
            _mass(physics, INTERMEDIATE_MASS, np.zeros(3), np.full(3, INTERMEDIATE_INERTIA), np.eye(3))
        else:
            if link is self.asset.links[0] and self.asset.base == "free":
                # the root of a free articulation is undefined unless one body is marked
                apply(physics, "PhysicsArticulationRootAPI")
                write_runtime_root(self.layers, prim)
            write_label(prim, "part", [link.label])
            properties = link.mass_properties
            moments, axes = properties.principal()
            _mass(physics, properties.mass, properties.center - frame.origin, moments, axes)
            self._content(prim, link, frame.origin)
        place(prim, frame.placement)

    def _content(self, prim: Sdf.PrimSpec, link: Link, origin: Array) -> None:
        """Write surfaces, colliders and grasps of the links; meshes go to their own layer."""
        looks = self._root.path.AppendChild(self._looks_name)
        meshes = define(self._meshes, link.name)
        define(prim, "visuals", "Scope")
        visuals = define(meshes, "visuals")
        for surface in link.surfaces:
            write_surface(visuals, surface, origin, looks.AppendChild(surface.material.name))
        collisions = define(prim, "collisions", "Scope"), define(meshes, "collisions")
        of_link = hulls(self.asset)[link.name]
        for number, collider in enumerate(link.colliders):
            name = f"{collider.convex.kind}_{number}"
            material = looks.AppendChild(collider.material.name)
            if number in of_link:
                write_hull(self.layers, collisions[1], name, of_link[number], material)
            else:
                write_primitive(self.layers, collisions[0], name, collider.convex, origin, material)
        write_holds(prim, self.asset, [each for each in self._affordances if each.link == link.name])


def _root(asset: Asset, layers: Layers) -> Sdf.PrimSpec:
    schemas = ["SemanticsLabelsAPI:category", "SemanticsLabelsAPI:wikidata_qcode"]
    prim = define(layers.structure, asset.name, "Xform", schemas)
    if asset.base == "fixed":
        apply(layers.physical(prim), "PhysicsArticulationRootAPI")
        write_runtime_root(layers, prim)
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
    write_label(prim, "wikidata_qcode", [category_code(asset.category)])
    return prim


def _mass(prim: Sdf.PrimSpec, mass: float, center: Array, moments: Array, axes: Array) -> None:
    """Write all four mass properties: simulators derive missing ones from the colliders."""
    write(prim, TYPES.Float, {"physics:mass": mass})
    write(prim, TYPES.Point3f, {"physics:centerOfMass": vec3(center)})
    write(prim, TYPES.Float3, {"physics:diagonalInertia": vec3(moments)})
    write(prim, TYPES.Quatf, {"physics:principalAxes": quatf(axes)})


def _dictionary(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values as metadata, which cannot hold None."""
    return {str(name): _custom(value) for name, value in values.items() if value is not None}


def _custom(value: Any) -> Any:
    """Return a value of a type that metadata support, as JSON text for other types."""
    if isinstance(value, bool | str | float):
        return value
    if isinstance(value, int) and -(2**31) <= value < 2**31:
        return value
    if isinstance(value, Mapping):
        return _dictionary(value)
    if isinstance(value, list | tuple) and all(isinstance(item, int | float) for item in value):
        return Vt.DoubleArray([float(item) for item in value])
    return json.dumps(value, default=str)
