"""USD: a light text layer with the physics, and a binary layer with the meshes."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
from pxr import Sdf, Vt

from artgen.asset import Asset
from artgen.asset.valid_states import KEY
from artgen.export import frames
from artgen.export.hulls import hulls
from artgen.export.losses import Written, look_rows, losses
from artgen.export.maps import TEXTURE_DIRECTORY, map_files
from artgen.export.text import states_text
from artgen.export.usd.geometry import PART_LABEL, write_content
from artgen.export.usd.joints import joint_rows, write_joints
from artgen.export.usd.layer import (
    Layers,
    RuntimeRow,
    apply,
    binary,
    category_code,
    define,
    new_layer,
    over,
    place,
    text,
    write,
)
from artgen.export.usd.materials import write_materials

_BODY: RuntimeRow = ("physx", "PhysxRigidBodyAPI", {"physxRigidBody:angularDamping": 0.0})
"""Only joints slow a body: by default, PhysX damps its rotation."""

_PHYSX = {
    "physxArticulation:enabledSelfCollisions": True,
    "physxArticulation:solverPositionIterationCount": 32,  # for couplings and heavy doors
}
_ROOT: tuple[RuntimeRow, ...] = (
    ("physx", "PhysxArticulationAPI", _PHYSX),
    ("newton", "NewtonArticulationRootAPI", {"newton:selfCollisionEnabled": True}),
)
"""The parts collide with each other, as in MJCF: a bolt and its strike interact by contact."""


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
    maps, segments = map_files(asset, textures), frames.chain(asset)
    bodies = [frames.base_frame(asset), *(segment.child for segment in segments)]
    taken = {frame.name for frame in bodies}
    with Sdf.ChangeBlock():
        root = _write_root(layers, asset)
        meshes = over(layers.geometry, root.path)
        looks = write_materials(
            layers, over(layers.looks, root.path), frames.unused(layers.scope, taken), asset, maps
        )
        for frame in bodies:
            body = _write_body(layers, root, asset, frame)
            if frame.link is not None:
                prims = body, define(meshes, frame.name)
                write_content(layers, prims, asset, frame.link, hulls(asset)[frame.name], looks)
            place(body, frame.placement)
        anchor = write_joints(layers, root, frames.unused("joints", taken), asset, segments)
        if anchor is not None and asset.loose:
            # at the root it would make free bodies part of the articulation
            _write_articulation(layers, anchor)
    rows = joint_rows(asset, segments, apart=layers.apart)
    return Written(maps.files, losses(*rows, *look_rows(asset, textures)))


def _write_root(layers: Layers, asset: Asset) -> Sdf.PrimSpec:
    labels = {"category": asset.category, "wikidata_qcode": category_code(asset.category)}
    prim = define(
        layers.structure,
        asset.name,
        "Xform",
        {f"semantics:labels:{name}": [label] for name, label in labels.items()},
        schemas=[f"SemanticsLabelsAPI:{name}" for name in labels],
    )
    if asset.base == "fixed" and not asset.loose:
        _write_articulation(layers, prim)
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
    states = Sdf.AttributeSpec(prim, KEY, Sdf.ValueTypeNames.String, Sdf.VariabilityUniform)
    states.custom, states.default = True, states_text(asset)
    return prim


def _write_body(layers: Layers, root: Sdf.PrimSpec, asset: Asset, frame: frames.LinkFrame) -> Sdf.PrimSpec:
    link = frame.link
    prim = define(root, frame.name, "Xform", schemas=[] if link is None else [PART_LABEL])
    physics = layers.physical(prim)
    apply(physics, "PhysicsRigidBodyAPI", "PhysicsMassAPI")
    layers.add_runtime(prim, [_BODY])
    mass, center = frames.INTERMEDIATE_MASS, np.zeros(3)
    moments, axes = np.full(3, frames.INTERMEDIATE_INERTIA), np.eye(3)
    if link is not None:
        if link is asset.links[0] and asset.base == "free":
            # the root of a free articulation is undefined unless one body is marked
            _write_articulation(layers, prim)
        if link.name in asset.loose and any(joint.parent == link.name for joint in asset.joints):
            _write_articulation(layers, prim)
        write(prim, {"semantics:labels:part": [link.label]})
        mass, center = link.mass_properties.mass, link.mass_properties.center - frame.origin
        moments, axes = link.mass_properties.principal()
    # all four: simulators derive missing ones from the colliders
    values = {"mass": mass, "centerOfMass": center, "diagonalInertia": moments, "principalAxes": axes}
    write(physics, {f"physics:{name}": value for name, value in values.items()})
    return prim


def _write_articulation(layers: Layers, prim: Sdf.PrimSpec) -> None:
    apply(layers.physical(prim), "PhysicsArticulationRootAPI")
    layers.add_runtime(prim, _ROOT)


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
