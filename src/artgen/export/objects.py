"""Assets as objects of other libraries, in memory: `mujoco.MjSpec`, `trimesh.Scene` and `Usd.Stage`.

Each has the content of the exported files, made by the same writers.
"""

import tempfile
from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from artgen import _portable
from artgen._arrays import OPENUSD, cached
from artgen.asset import Asset
from artgen.errors import needed
from artgen.export.files import write_files
from artgen.export.frames import translation
from artgen.export.glb import write_glb
from artgen.export.maps import TEXTURE_DIRECTORY
from artgen.export.mjcf import Tendons, write_mjcf
from artgen.materials.textures import check_size

if TYPE_CHECKING:
    import mujoco
    import trimesh
    from pxr import Usd

_SCENE = "world"  # frame of a trimesh scene: the coordinates of the asset


def mjspec(asset: Asset, textures: int, tendons: Tendons | None = None) -> "mujoco.MjSpec":
    """Return an asset as an editable model of MuJoCo, with meshes and maps as its assets.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.
        tendons: Those of the model; see `write_mjcf`.

    Raises:
        ExportError: MuJoCo is not installed.
        ParameterError: The size of maps is not allowed.
    """
    with needed('an MjSpec needs MuJoCo, which cannot be loaded ({error}): pip install "artgen[sim]"'):
        import mujoco
    files = dict(write_mjcf(_stored(asset, textures), textures, tendons).files)
    return mujoco.MjSpec.from_string(files.pop(f"{asset.name}.xml").decode(), assets=files)


def _stored(asset: Asset, textures: int) -> Asset:
    """Return an asset with as many digits as files keep, after a check of the size of its maps."""
    check_size(textures, plain=True)
    return asset.rounded()


def trimesh_scene(
    asset: Asset, q: Mapping[str, float] | None, textures: int, *, colliders: bool
) -> "trimesh.Scene":
    """Return an asset at a pose as a scene whose nodes are the links, each below its parent.

    Args:
        asset: The asset.
        q: Positions by joint name, completed as in `Asset.positions` [rad or m].
        textures: Texels per side of the material maps; 0 for colors only.
        colliders: Whether the nodes have the convex colliders instead of the surfaces.

    Raises:
        AssetError: A joint is unknown, coupled to another, or beyond its limits.
        ParameterError: The size of maps is not allowed.
    """
    import trimesh

    poses = {name: motion @ translation(asset.origin(name)) for name, motion in asset.pose(q).items()}
    scene = trimesh.Scene(base_frame=_SCENE)
    parents = {child: parent for parent, child, _ in asset.pairs()}
    for name, pose in poses.items():
        parent = parents.get(name)
        local = pose if parent is None else _portable.inverse(poses[parent]) @ pose
        scene.graph.update(name, parent or _SCENE, matrix=local)  # type: ignore[no-untyped-call]
    if colliders:
        for link in asset.links:
            for number, collider in enumerate(link.colliders):
                mesh = collider.convex.manifold().to_mesh64()
                vertices = np.asarray(mesh.vert_properties)[:, :3] - asset.origin(link.name)
                made = trimesh.Trimesh(vertices, np.asarray(mesh.tri_verts), process=False)
                made.metadata |= {"label": collider.label, "material": collider.material.name}
                name = f"{link.name}/collider_{number}"
                scene.add_geometry(made, node_name=name, geom_name=name, parent_node_name=link.name)
        return scene
    (model,) = write_glb(_stored(asset, textures), textures).files.values()
    read = trimesh.load_scene(BytesIO(model), file_type="glb")
    link_of = {}
    for node in read.graph.nodes_geometry:  # a link with one surface carries it, others have a node for each
        link = node if node in poses else read.graph.transforms.parents[node]
        link_of[read.graph[node][1]] = link
    surfaces = {link.name: iter(link.surfaces) for link in asset.links}
    for geometry, made in read.geometry.items():
        link = link_of[geometry]
        name = f"{link}/{next(surfaces[link]).name}"
        scene.add_geometry(made, node_name=name, geom_name=name, parent_node_name=link)
    return scene


@cached(1)
def _map_folder() -> "tempfile.TemporaryDirectory[str]":
    """Return the folder of the maps of stages, which is removed when Python ends."""
    return tempfile.TemporaryDirectory(prefix="artgen_maps_")


def usd_stage(asset: Asset, textures: int) -> "Usd.Stage":
    """Return an asset as a USD stage of two layers in memory.

    USD reads images from files only: material maps lie in a temporary folder until Python ends.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only, and no file.

    Raises:
        ParameterError: The size of maps is not allowed.
    """
    with OPENUSD:
        from pxr import Usd

        from artgen.export.usd import author
        from artgen.export.usd.layer import Layers, new_layer

        folder = Path(tempfile.mkdtemp(dir=_map_folder().name)) if textures else Path()
        main, geometry = new_layer(".usda", asset.name), new_layer(".usda", asset.name)
        layers = Layers(main, geometry, main, maps=(folder / TEXTURE_DIRECTORY).as_posix())
        write_files(author(_stored(asset, textures), layers, textures).files, folder)
        main.subLayerPaths = [geometry.identifier]
        return Usd.Stage.Open(main)
