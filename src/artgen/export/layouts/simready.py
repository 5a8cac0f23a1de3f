"""Layout of NVIDIA's SimReady profile: a light interface layer, with a variant per simulator.

    <asset>/usd/<asset>.usda                       interface: metadata, the variants of the simulators
    <asset>/usd/.thumbs/256x256/<asset>.usda.png   picture
    <asset>/usd/payloads/<asset>_base.usda         bodies, labels, grasp frames
    <asset>/usd/payloads/<asset>_physics.usda      attributes that every simulator reads
    <asset>/usd/payloads/<asset>_meshes.usdc       meshes and materials
    <asset>/usd/payloads/textures/                 maps of the materials
    <asset>/usd/runnables/physics/                 attributes of PhysX, Newton and MuJoCo: physx.usda, ...

The interface is neutral until one of its variants `PhysX`, `Newton` and `MuJoCo` is set to `Enabled`.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from pxr import Gf, Sdf

from artgen.asset import Asset
from artgen.export.frames import chain, seen_box
from artgen.export.losses import Written
from artgen.export.thumbnail import thumbnail
from artgen.export.usd import author
from artgen.export.usd.layer import Layers, Runtime, binary, category_code, define, new_layer, text
from artgen.materials.textures.maps import png

PROFILE = ("Robotics-Prop", "4.0.0")
"""The SimReady profile of the layout, and its version."""

LICENSE = "Apache-2.0"
"""License of artgen, which also covers its assets."""

UNDATED = "undated: equal bytes for equal seeds, whenever they are made"
"""Replaces a date, which would make two exports of one asset differ."""


VARIANTS: Mapping[Runtime, str] = {"physx": "PhysX", "newton": "Newton", "mujoco": "MuJoCo"}
"""Name of the variant set of each simulator."""

_RUNNABLES = "runnables/physics"
_TEXTURES = "textures"


def write_simready(asset: Asset, textures: int) -> Written:
    """Write an asset in the SimReady layout."""
    name = asset.name
    base, physics, meshes = (new_layer(kind, name) for kind in (".usda", ".usda", ".usdc"))
    runtimes = {runtime: new_layer(".usda", name) for runtime in VARIANTS}
    layers = Layers(
        base, meshes, meshes, physics, runtimes, scope="Looks", maps=f"./{_TEXTURES}", openpbr=True
    )
    written = author(asset, layers, textures)
    base.subLayerPaths = [f"./{name}_physics.usda", f"./{name}_meshes.usdc"]
    usd = f"{name}/usd"
    files = {
        f"{usd}/{name}.usda": text(_interface(asset)),
        f"{usd}/.thumbs/256x256/{name}.usda.png": png(thumbnail(asset)),
        f"{usd}/payloads/{name}_base.usda": text(base),
        f"{usd}/payloads/{name}_physics.usda": text(physics),
        f"{usd}/payloads/{name}_meshes.usdc": binary(meshes),
        **{f"{usd}/{_RUNNABLES}/{runtime}.usda": text(layer) for runtime, layer in runtimes.items()},
    }
    for path, content in written.files.items():
        files[f"{usd}/payloads/{_TEXTURES}/{path.rpartition('/')[2]}"] = content
    return Written(files, written.losses, f"{usd}/{name}.usda")


def _interface(asset: Asset) -> Sdf.Layer:
    """Return the root layer, which references the base and has a variant for each simulator."""
    layer = new_layer(".usda", asset.name)
    prim = define(layer, asset.name, "Xform")
    prim.SetInfo("kind", "component")
    prim.referenceList.prependedItems = [Sdf.Reference(f"./payloads/{asset.name}_base.usda")]
    for runtime, name in VARIANTS.items():
        variants = Sdf.VariantSetSpec(prim, name)
        Sdf.VariantSpec(variants, "Disabled")
        enabled = Sdf.VariantSpec(variants, "Enabled").primSpec
        enabled.payloadList.prependedItems = [Sdf.Payload(f"./{_RUNNABLES}/{runtime}.usda")]
        prim.variantSelections[name] = "Disabled"
    prim.variantSetNameList.prependedItems = list(VARIANTS.values())
    metadata = _metadata(asset)
    # the oldest version of the profile's core requires these outside as well
    outside = ("asset_name", "asset_type", "source_file", "usd_date_generated")
    layer.customLayerData = {"SimReady_Metadata": metadata, **{name: metadata[name] for name in outside}}
    return layer


def _metadata(asset: Asset) -> dict[str, Any]:
    profile, version = PROFILE
    variants = {
        name: {"activateOption": "Enabled", "prim": f"/{asset.name}", "variantSetName": name}
        for name in sorted(VARIANTS.values())
    }
    return {
        "Variants": {"Physics": variants},
        "artgen_version": asset.version,
        "asset_extents": Gf.Vec3f(*np.ptp(seen_box(asset), axis=0).round(6).tolist()),
        "asset_license": LICENSE,
        "asset_name": asset.name,
        "asset_type": "prop",
        "author": "artgen",
        "category": asset.category,
        "mass": float(f"{asset.mass:.6g}"),
        "qcode": category_code(asset.category),
        "rigid_body_count": 1 + len(chain(asset)),
        "seed": str(asset.seed),
        "source_file": f"artgen.generate({asset.category!r}, seed={asset.seed})",
        "usd_date_generated": UNDATED,
        "validation": {"profile": profile, "profile_version": version},
    }
