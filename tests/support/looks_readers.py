"""Views of exported assets by yourdfpy, MuJoCo, OpenUSD and trimesh, and by glTF's specification."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import trimesh
import yourdfpy
from numpy.typing import NDArray
from PIL import Image
from pxr import Usd, UsdGeom, UsdPhysics, UsdShade

from artgen.asset import Asset
from support.looks import Array, Channel, Look, Part, View, constant, displayed, mapped
from support.looks_glb import read_gltf
from support.readers import expected_frames, silence


def read_views(
    asset: Asset, directory: Path, formats: tuple[str, ...] = ("urdf", "mjcf", "usd", "glb")
) -> list[View]:
    """Return the view of every reader of those formats, all of which must read in silence."""
    readers: Mapping[str, tuple[Callable[[Asset, Path], View], ...]] = {
        "urdf": (view_urdf,),
        "mjcf": (view_mjcf,),
        "usd": (view_usd,),
        "glb": (view_glb, view_gltf),
    }
    with silence():
        return [read(asset, directory) for name in formats for read in readers[name]]


def to_rest(asset: Asset) -> dict[str, Array]:
    """Return the motion of each link from where the files place it to rest, shape (4, 4)."""
    positions = asset.positions()
    result = {}
    for name, frame in expected_frames(
        asset, {each.name: positions[each.name] for each in asset.free_joints}
    ).items():
        rest = np.eye(4)
        rest[:3, 3] = asset.origin(name)
        result[name] = rest @ np.linalg.inv(frame)
    return result


def _part(link: str, matrix: Array, mesh: tuple[Array, Array, Array], look: Look) -> Part:
    """Return triangles, corners (m, 3, 3), uvs (m, 3, 2) and normals (m, 3, 3), moved by a rigid motion."""
    corners, uvs, normals = mesh
    turn = matrix[:3, :3]
    return Part(link, corners @ turn.T + matrix[:3, 3], uvs, normals @ turn.T, look)


def pixels_of(image: Image.Image, channels: int = 3) -> NDArray[np.uint8]:
    """Return the pixels of an image, shape (h, w, channels)."""
    if channels == 1:
        assert image.mode == "L", f"a map of one number has the mode {image.mode}"
        return np.asarray(image)[..., None]
    return np.asarray(image.convert("RGB"))


# URDF


def view_urdf(asset: Asset, directory: Path) -> View:
    """Read the URDF with yourdfpy, the meshes and MTL with trimesh."""
    robot = yourdfpy.URDF.load(str(directory / f"{asset.name}.urdf"))
    positions = asset.positions()
    robot.update_cfg({name: positions[name] for name in robot.actuated_joint_names})
    back, links, parts = to_rest(asset), {link.name for link in asset.links}, []
    graph = robot.scene.graph
    for node in graph.nodes_geometry:
        matrix, name = graph.get(node)
        link = node
        while link not in links:
            link = graph.transforms.parents[link]
        mesh = robot.scene.geometry[name]
        look = _mtl_look(mesh.visual, directory / "meshes")
        parts.append(_part(link, back[link] @ matrix, _trimesh_corners(mesh), look))
    return View("yourdfpy", parts)


def _trimesh_corners(mesh: trimesh.Trimesh) -> tuple[Array, Array, Array]:
    uvs = getattr(mesh.visual, "uv", None)
    uvs = np.zeros((len(mesh.vertices), 2)) if uvs is None else np.asarray(uvs)
    faces = mesh.faces
    return np.asarray(mesh.vertices)[faces], uvs[faces], np.asarray(mesh.vertex_normals)[faces]


def _mtl_look(visual: Any, folder: Path) -> Look:
    """Return what the MTL says; trimesh keeps the lines that it does not know itself."""
    material = visual.material
    lines = {name.lower(): value for name, value in material.kwargs.items()}

    def number(word: str, default: float) -> float:
        value = lines.get(word, default)
        return float(np.ravel(np.asarray(value, float))[0])

    def channel(word: str, map_word: str) -> Channel:
        if map_word not in lines:
            return constant(number(word, 0.0))
        return mapped(pixels_of(_opened(folder, lines[map_word]), 1), number(word, 1.0))

    diffuse = np.asarray(material.diffuse, float) / 255.0
    color = constant(*diffuse[:3])
    if material.image is not None:
        color = mapped(pixels_of(material.image), *diffuse[:3])
    emission = np.ravel(np.asarray(lines.get("ke", [0.0] * 3), float))
    look = Look(
        color,
        channel("pr", "map_pr"),
        channel("pm", "map_pm"),
        constant(number("d", 1.0)),
        constant(*_linear(emission)),
    )
    if "norm" in lines:
        look = Look(**(vars(look) | {"normal": mapped(pixels_of(_opened(folder, lines["norm"])))}))
    return look


def _opened(folder: Path, value: Any) -> Image.Image:
    name = value if isinstance(value, str) else " ".join(map(str, value))
    return Image.open(folder / name)


def _linear(encoded: Array) -> Array:
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


# MJCF


def view_mjcf(asset: Asset, directory: Path) -> View:
    """Read the MJCF with MuJoCo's compiler: the arrays that its renderers draw."""
    model = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    back, parts = to_rest(asset), []
    for geom in range(model.ngeom):
        if model.geom_type[geom] != mujoco.mjtGeom.mjGEOM_MESH or model.geom_group[geom] != 2:
            continue
        link = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, model.geom_bodyid[geom])
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
        corners, uvs, normals = _mujoco_corners(model, model.geom_dataid[geom])
        number = model.geom_matid[geom]
        assert number >= 0, f"geom {geom} has no material"
        assert not model.mat_texuniform[number]
        uvs = uvs * model.mat_texrepeat[number]
        # MuJoCo's v grows downwards, from the first row of the image
        uvs = uvs * [1.0, -1.0] + [0.0, 1.0]
        parts.append(_part(link, back[link] @ matrix, (corners, uvs, normals), _mujoco_look(model, number)))
    return View("mujoco", parts)


def _mujoco_corners(model: Any, mesh: int) -> tuple[Array, Array, Array]:
    faces = slice(model.mesh_faceadr[mesh], model.mesh_faceadr[mesh] + model.mesh_facenum[mesh])
    vertices = model.mesh_vert[model.mesh_vertadr[mesh] :].astype(float)
    normals = model.mesh_normal[model.mesh_normaladr[mesh] :].astype(float)
    assert model.mesh_texcoordadr[mesh] >= 0, f"mesh {mesh} has no texture coordinates"
    uvs = model.mesh_texcoord[model.mesh_texcoordadr[mesh] :].astype(float)
    return (
        vertices[model.mesh_face[faces]],
        uvs[model.mesh_facetexcoord[faces]],
        normals[model.mesh_facenormal[faces]],
    )


def _mujoco_look(model: Any, number: int) -> Look:
    rgba = model.mat_rgba[number].astype(float)
    roles = mujoco.mjtTextureRole

    def channel(role: Any, *factor: float) -> Channel:
        texture = int(model.mat_texid[number, role])
        if texture < 0:
            return constant(*factor)
        height, width = int(model.tex_height[texture]), int(model.tex_width[texture])
        depth, start = int(model.tex_nchannel[texture]), int(model.tex_adr[texture])
        assert model.tex_type[texture] == mujoco.mjtTexture.mjTEXTURE_2D
        pixels = model.tex_data[start : start + height * width * depth].reshape(height, width, depth)
        if len(factor) == 1:
            assert depth == 1 or (pixels == pixels[..., :1]).all(), f"texture {texture} has {depth} numbers"
        return mapped(pixels[..., : len(factor)], *factor)

    glow = float(model.mat_emission[number])
    emission = channel(roles.mjTEXROLE_EMISSIVE, glow, glow, glow)
    return Look(
        channel(roles.mjTEXROLE_RGB, *rgba[:3]),
        channel(roles.mjTEXROLE_ROUGHNESS, float(model.mat_roughness[number])),
        channel(roles.mjTEXROLE_METALLIC, float(model.mat_metallic[number])),
        constant(rgba[3]),
        emission,
        channel(roles.mjTEXROLE_NORMAL, 1.0, 1.0, 1.0)
        if model.mat_texid[number, roles.mjTEXROLE_NORMAL] >= 0
        else constant(128 / 255, 128 / 255, 1.0),
    )


# USD


def view_usd(asset: Asset, directory: Path) -> View:
    """Read the USD with OpenUSD: bound materials, their networks and the images that they name."""
    stage = Usd.Stage.Open(str(directory / f"{asset.name}.usda"))
    cache, back, parts = UsdGeom.XformCache(), to_rest(asset), []
    for prim in stage.Traverse():
        if not prim.IsA(UsdGeom.Mesh) or UsdGeom.Imageable(prim).ComputePurpose() != UsdGeom.Tokens.default_:
            continue
        body = prim
        while not body.HasAPI(UsdPhysics.RigidBodyAPI):
            body = body.GetParent()
        link = body.GetName()
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        matrix = np.array(cache.GetLocalToWorldTransform(prim)).T
        parts.append(_part(link, back[link] @ matrix, _usd_corners(UsdGeom.Mesh(prim)), _usd_look(material)))
    return View("usd", parts)


def _usd_corners(mesh: UsdGeom.Mesh) -> tuple[Array, Array, Array]:
    assert set(mesh.GetFaceVertexCountsAttr().Get()) == {3}
    assert mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.rightHanded
    faces = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
    points = np.array(mesh.GetPointsAttr().Get(), float)
    st = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st")
    uvs, normals = np.array(st.ComputeFlattened(), float), np.array(mesh.GetNormalsAttr().Get(), float)
    corners = [
        values[faces] if kind in ("vertex", "varying") else values.reshape(*faces.shape, -1)
        for values, kind in ((uvs, st.GetInterpolation()), (normals, mesh.GetNormalsInterpolation()))
    ]
    return points[faces], corners[0], corners[1]


def _usd_look(material: UsdShade.Material) -> Look:
    shader, _, _ = material.ComputeSurfaceSource()
    assert shader.GetIdAttr().Get() == "UsdPreviewSurface"

    def channel(name: str, *default: float) -> Channel:
        found = shader.GetInput(name)
        if not found:
            return constant(*default)
        sources, _ = found.GetConnectedSources()
        if not sources:
            value = found.Get()
            value = np.ravel(np.array(default if value is None else value, float))
            return constant(*(displayed(value) if name == "diffuseColor" else value))
        return _usd_map(UsdShade.Shader(sources[0].source), sources[0].sourceName, name)

    return Look(
        channel("diffuseColor", 0.18, 0.18, 0.18),
        channel("roughness", 0.5),
        channel("metallic", 0.0),
        channel("opacity", 1.0),
        channel("emissiveColor", 0.0, 0.0, 0.0),
        channel("normal", 128 / 255, 128 / 255, 1.0),
    )


def _usd_map(reader: UsdShade.Shader, output: str, name: str) -> Channel:
    assert reader.GetIdAttr().Get() == "UsdUVTexture"
    path = reader.GetInput("file").Get().resolvedPath
    assert path, f"the map {reader.GetInput('file').Get().path} of {name} is not found"
    for wrap in ("wrapS", "wrapT"):
        assert reader.GetInput(wrap).Get() == "repeat"
    space = reader.GetInput("sourceColorSpace").Get()
    assert space == ("sRGB" if name == "diffuseColor" else "raw"), (name, space)
    sources, _ = reader.GetInput("st").GetConnectedSources()
    primvar = UsdShade.Shader(sources[0].source)
    assert primvar.GetIdAttr().Get() == "UsdPrimvarReader_float2"
    assert primvar.GetInput("varname").Get() == "st"
    scale = reader.GetInput("scale").Get() if reader.GetInput("scale") else None
    if name == "normal":
        assert tuple(scale) == (2.0, 2.0, 2.0, 1.0)
        assert tuple(reader.GetInput("bias").Get()) == (-1.0, -1.0, -1.0, 0.0)
        scale = None
    pixels = pixels_of(Image.open(path), 1 if output == "r" else 3)
    assert scale is None or tuple(scale) == (1.0, 1.0, 1.0, 1.0)
    return mapped(pixels)


# GLB

Z_UP = np.array([[1.0, 0, 0, 0], [0, 0, -1.0, 0], [0, 1.0, 0, 0], [0, 0, 0, 1.0]])
"""Takes glTF's axes, y up and z to the front, to ours, z up and -y to the front."""


def view_glb(asset: Asset, directory: Path) -> View:
    """Read the GLB with trimesh."""
    scene = trimesh.load_scene(str(directory / f"{asset.name}.glb"))
    back, links, parts = to_rest(asset), {link.name for link in asset.links}, []
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph.get(node)
        link = node
        while link not in links:
            link = scene.graph.transforms.parents[link]
        mesh = scene.geometry[name]
        look = _pbr_look(mesh.visual.material)
        parts.append(_part(link, back[link] @ Z_UP @ matrix, _trimesh_corners(mesh), look))
    return View("trimesh glb", parts)


def _pbr_look(material: Any) -> Look:
    factor = (
        np.full(4, 255.0) if material.baseColorFactor is None else np.asarray(material.baseColorFactor, float)
    )
    color = displayed(factor[:3] / 255.0)
    metal, rough = (
        1.0 if value is None else float(value)
        for value in (material.metallicFactor, material.roughnessFactor)
    )
    orm = material.metallicRoughnessTexture
    planes = None if orm is None else pixels_of(orm)
    return Look(
        constant(*color)
        if material.baseColorTexture is None
        else mapped(pixels_of(material.baseColorTexture), *color),
        constant(rough) if planes is None else mapped(planes[..., 1], rough),
        constant(metal) if planes is None else mapped(planes[..., 2], metal),
        constant(factor[3] / 255.0),
        constant(
            *([0.0] * 3 if material.emissiveFactor is None else np.asarray(material.emissiveFactor, float))
        ),
        constant(128 / 255, 128 / 255, 1.0)
        if material.normalTexture is None
        else mapped(pixels_of(material.normalTexture)),
    )


def view_gltf(asset: Asset, directory: Path) -> View:
    """Read the GLB as glTF's specification says, and nothing else."""
    back = to_rest(asset)
    links = {link.name for link in asset.links}
    parts = []
    for names, matrix, mesh, look in read_gltf((directory / f"{asset.name}.glb").read_bytes()):
        link = next(name for name in reversed(names) if name in links)
        parts.append(_part(link, back[link] @ Z_UP @ matrix, mesh, look))
    return View("gltf", parts)
