"""Pictures for documentation, path-traced by Mitsuba (extra `artgen[render]`)."""

import math
import os
import re
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.asset.surface import texture_coordinates
from artgen.errors import ParameterError, RenderError, nearest
from artgen.materials import Material
from artgen.materials.textures import check_size
from artgen.view.camera import Camera, View, camera_of
from path_tracing.film import denoised, displayed, tone_mapped
from path_tracing.materials import radiance, scattering
from path_tracing.room import doorway, room
from path_tracing.studio import Rig, Surroundings, backdrop, rig

Studio = Literal["studio", "room", "doorway"]
"""A seamless backdrop; a wall with a skirting board behind the asset; such a wall with the asset in it."""

_OLDEST_LLVM = 16  # Debian's LLVM 15 aborts the process: "Cannot select fminimum"
_LLVM = re.compile(r"libLLVM([-.]\d+)?(\.so|\.dylib)(\.\d+)*")
_BOUNCES = 12


def render_mitsuba(
    asset: Asset,
    q: Mapping[str, float] | None = None,
    *,
    camera: Camera | View | str | None = None,
    size: int | tuple[int, int] = 768,
    samples: int = 64,
    studio: Studio = "studio",
    textures: int = 1024,
) -> NDArray[np.uint8]:
    """Return a path-traced picture of an asset, sRGB, shape (h, w, 3).

    LLVM vectorizes the rendering if a suitable library is installed (`apt install libllvm19`, or
    `DRJIT_LIBLLVM_PATH`); the package `oidn` removes noise if it is installed. Two pictures differ by noise.

    Args:
        asset: What to draw.
        q: Positions by joint name; those not given stand nearest to 0 [rad or m].
        camera: A camera, a view, or the name of one of `artgen.view.camera.VIEWS`; None as in `render`.
        size: Width and height [pixels], or one number for both.
        samples: Paths per pixel.
        studio: What is around it.
        textures: Texels on a side of the materials' maps, 0 for none.

    Raises:
        RenderError: Mitsuba is not installed.
        ParameterError: There is no such studio, or the size, samples or textures are impossible.
        AssetError: A joint is unknown, coupled to another, or beyond its limits.
    """
    width, height = _checked(size, samples, studio, textures)
    mitsuba = load_mitsuba()
    drawn = _posed(asset, q)
    points = {
        link: np.concatenate([mesh.vertices for mesh, _ in surfaces]) for link, surfaces in drawn.items()
    }
    camera = camera_of(camera, asset, points, width / height)
    every = np.concatenate(list(points.values()))
    frame = rig(mitsuba, np.array([every.min(axis=0), every.max(axis=0)]), camera)
    around = _surroundings(studio, frame, asset)
    surfaces = [surface for of_link in drawn.values() for surface in of_link]
    scene: dict[str, Any] = {"type": "scene", "integrator": _integrator(), **around.lights}
    scene |= _meshes(mitsuba, surfaces + around.surfaces, textures)
    scene["sensor"] = _sensor(mitsuba, camera, width, height)
    layers = np.array(mitsuba.render(mitsuba.load_dict(scene), spp=samples, seed=1), np.float32)
    color = tone_mapped(layers[..., :3])
    return displayed(denoised(color, layers[..., -6:-3], layers[..., -3:]))


def load_mitsuba() -> Any:
    """Return the package mitsuba with the fastest variant that works on this machine.

    Raises:
        RenderError: It is not installed.
    """
    library = usable_llvm()
    if library:
        os.environ.setdefault("DRJIT_LIBLLVM_PATH", library)
    try:
        import mitsuba
    except ImportError as error:
        raise RenderError(
            "path-traced pictures need the package mitsuba, which is not installed; "
            'pip install "artgen[render]"'
        ) from error
    if mitsuba.variant() is None:
        if not library:
            warnings.warn(
                "no LLVM library from version 16 on is found, and path tracing is many times as slow without "
                "it: apt install libllvm19",
                stacklevel=2,
            )
        mitsuba.set_variant("llvm_ad_rgb" if library else "scalar_rgb")
    return mitsuba


def usable_llvm() -> str:
    """Return the path of an LLVM library that Mitsuba can use, the newest one; empty if there is none.

    `DRJIT_LIBLLVM_PATH` is used unless its name shows that it is too old.
    """
    given = os.environ.get("DRJIT_LIBLLVM_PATH")
    if given:
        return given if _llvm_version(Path(given)) >= _OLDEST_LLVM else ""
    places = (
        "usr/lib/*-linux-gnu",
        "usr/lib64",
        "usr/lib/llvm-*/lib",
        "usr/lib",
        "opt/homebrew/opt/llvm*/lib",
    )
    found = [path for place in places for path in Path("/").glob(f"{place}/libLLVM*")]
    usable = [path for path in found if _LLVM.fullmatch(path.name) and _llvm_version(path) >= _OLDEST_LLVM]
    return str(max(usable, key=lambda path: (_llvm_version(path), str(path)))) if usable else ""


def _llvm_version(path: Path) -> int:
    """Return the major version in the name or folder of a library; a high number if there is none."""
    numbers = re.findall(r"(?:LLVM|llvm|so)[-.@](\d+)", str(path.resolve()))
    return int(numbers[-1]) if numbers else 999


def _checked(size: int | tuple[int, int], samples: int, studio: str, textures: int) -> tuple[int, int]:
    width, height = (size, size) if isinstance(size, int) else size
    if min(width, height) < 1 or samples < 1:
        raise ParameterError(
            f"a picture of {width} x {height} pixels with {samples} samples cannot be drawn; "
            "all must be at least 1"
        )
    if studio not in get_args(Studio):
        raise ParameterError(f"there is no studio {studio!r}.{nearest(studio, get_args(Studio))}")
    if textures:
        check_size(textures)
    return width, height


def _surroundings(studio: Studio, rig: Rig, asset: Asset) -> Surroundings:
    if studio == "studio":
        return backdrop(rig)
    if studio == "room":
        return room(rig)
    base = asset.links[0]
    built_in = [surface.mesh.vertices for surface in base.surfaces if surface.label == base.label]
    return doorway(rig, np.concatenate(built_in or [surface.mesh.vertices for surface in base.surfaces]))


def _posed(asset: Asset, q: Mapping[str, float] | None) -> dict[str, list[tuple[Mesh, Material]]]:
    """Return the surfaces of each link with their materials."""
    poses = asset.pose(q)
    return {
        link.name: [(each.mesh.moved(poses[link.name]), each.material) for each in link.surfaces]
        for link in asset.links
    }


def _integrator() -> dict[str, Any]:
    return {
        "type": "aov",
        "aovs": "albedo:albedo,normal:sh_normal",
        "image": {"type": "path", "max_depth": _BOUNCES},
    }


def _sensor(mitsuba: Any, camera: Camera, width: int, height: int) -> dict[str, Any]:
    return {
        "type": "perspective",
        "fov": math.degrees(camera.field_of_view),
        "fov_axis": "y",
        "near_clip": 0.005,
        "to_world": mitsuba.ScalarTransform4f().look_at(
            list(camera.position), list(camera.target), camera.axes()[1].tolist()
        ),
        "film": {
            "type": "hdrfilm",
            "width": width,
            "height": height,
            "pixel_format": "rgb",
            # the denoiser wants the noise of neighboring pixels to be independent
            "rfilter": {"type": "box"},
        },
        "sampler": {"type": "independent"},
    }


def _meshes(mitsuba: Any, surfaces: list[tuple[Mesh, Material]], textures: int) -> dict[str, Any]:
    """Return the surfaces as meshes of Mitsuba by name."""
    known: dict[Material, Any] = {}
    result = {}
    for number, (mesh, material) in enumerate(surfaces):
        if material not in known:
            known[material] = mitsuba.load_dict(scattering(mitsuba, material, textures))
        result[f"mesh_{number}"] = _mesh(mitsuba, f"mesh_{number}", mesh, material, known[material])
    return result


def _mesh(mitsuba: Any, name: str, mesh: Mesh, material: Material, bsdf: Any) -> Any:
    properties = mitsuba.Properties()
    properties["bsdf"] = bsdf
    glow = radiance(material)
    if any(glow):
        light = {"type": "area", "radiance": {"type": "rgb", "value": glow}}
        properties["emitter"] = mitsuba.load_dict(light)
    result = mitsuba.Mesh(
        name,
        len(mesh.vertices),
        len(mesh.triangles),
        has_vertex_normals=True,
        has_vertex_texcoords=True,
        props=properties,
    )
    values = mitsuba.traverse(result)
    values["vertex_positions"] = mesh.vertices.ravel().astype(np.float32)
    values["vertex_normals"] = mesh.normals.ravel().astype(np.float32)
    # Mitsuba's maps begin at the top, ours at the bottom
    coordinates = texture_coordinates(mesh, material) * [1.0, -1.0]
    values["vertex_texcoords"] = coordinates.ravel().astype(np.float32)
    values["faces"] = mesh.triangles.ravel().astype(np.uint32)
    values.update()
    return result
