"""The scene of an asset for MuJoCo: each link as a posed body, in a studio.

Metal and lacquer mirror the studio: the reflection is a texture with coordinates for each camera.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.asset.surface import texture_coordinates
from artgen.materials import Material
from artgen.materials.textures import displayed, kinds, map_name, maps
from artgen.view.camera import Camera, box_corners
from artgen.view.studio import Backdrop, backdrop, sphere_map

Studio = Literal["studio", "room", "none"]

ASSET_GROUP, GLOSS_GROUP, STUDIO_GROUP = 0, 1, 2
"""MuJoCo's geom groups: surfaces, gloss layers, and surroundings."""

HIDDEN_GROUP = 5
"""MuJoCo's geom group of invisible objects."""

HALF = 0.5
"""Brightness of the single pictures, so that no light is clipped before the average."""

SKY = "studio_sky"
"""Name of the background texture."""

_MIRROR_STEP = 0.05  # roughness steps of the blurred studio
_SHADOW_TEXELS = 2048
_SKY_LIGHT = {"studio": 0.87, "room": 0.87, "none": 1.7}  # the last value becomes white


@dataclass(frozen=True)
class Layer:
    """A MuJoCo material for one pass of a surface."""

    name: str  # name of the material in the model
    mirrors: bool = False  # whether its texture is a reflection of the studio


class SceneBuilder:
    """Adds lights, materials and meshes to a specification of MuJoCo, each material and texture once.

    Attributes:
        spec: The specification.
    """

    def __init__(self, place: Backdrop) -> None:
        import mujoco

        self.spec: Any = mujoco.MjSpec()
        self.spec.stat.extent = place.radius
        self.spec.stat.center = place.center
        self._layers: dict[str, tuple[Layer, ...]] = {}
        self._textures: set[str] = set()
        for number in range(4):
            self.spec.worldbody.add_light(
                name=f"lamp_{number}", type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, castshadow=number < 2
            )
        light = _SKY_LIGHT[place.kind] * HALF
        self.spec.add_texture(
            name=SKY,
            type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
            builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT,
            rgb1=[light] * 3,
            rgb2=[light] * 3,
            width=8,
            height=48,
        )
        visual = self.spec.visual
        visual.headlight.active = 0
        visual.quality.offsamples = 0
        visual.quality.shadowsize = _SHADOW_TEXELS
        visual.map.fogstart, visual.map.fogend = 1e4, 1e5

    def add_surface(self, body: Any, name: str, mesh: Mesh, material: Material, texels: int) -> list[str]:
        """Add a surface of the asset to a body; return the names of its meshes that mirror the studio."""
        mirrors = []
        for number, layer in enumerate(self._layers_of(material, texels)):
            group = GLOSS_GROUP if number else ASSET_GROUP
            self._add_mesh(body, f"{name}_{number}", mesh, material, layer, group)
            if layer.mirrors:
                mirrors.append(f"{name}_{number}")
        return mirrors

    def add_surroundings(self, body: Any, name: str, mesh: Mesh, material: Material, texels: int) -> None:
        """Add a surface of the surroundings to a body."""
        self._add_mesh(body, name, mesh, material, self._layers_of(material, texels)[0], STUDIO_GROUP)

    def _add_mesh(
        self, body: Any, name: str, mesh: Mesh, material: Material, layer: Layer, group: int
    ) -> None:
        import mujoco

        coordinates = texture_coordinates(mesh, material)
        # MuJoCo counts v down from the first row of a texture
        coordinates = np.column_stack([coordinates[:, 0], 1.0 - coordinates[:, 1]])
        triangles = np.ascontiguousarray(mesh.triangles, np.int32).ravel()
        self.spec.add_mesh(
            name=name,
            inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL,
            uservert=mesh.vertices.ravel(),
            usernormal=mesh.normals.ravel(),
            usertexcoord=coordinates.ravel(),
            userface=triangles,
            userfacenormal=triangles,
            userfacetexcoord=triangles,
        )
        body.add_geom(
            name=name,
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=name,
            material=layer.name,
            group=group,
            castshadow=group == ASSET_GROUP and material.opacity == 1.0,
            contype=0,
            conaffinity=0,
        )

    def _layers_of(self, material: Material, texels: int) -> tuple[Layer, ...]:
        """Return the passes of a material in draw order."""
        if material.name not in self._layers:
            self._layers[material.name] = self._add_layers(material, texels)
        return self._layers[material.name]

    def _add_layers(self, material: Material, texels: int) -> tuple[Layer, ...]:
        color = displayed(material.base_color)
        if material.base_metalness >= 0.5:
            layer = Layer(f"{material.name}_metal", mirrors=True)
            mirror = self._mirror(material.specular_roughness)
            self._add_material(layer.name, (*(0.46 * color), 1.0), mirror, emission=0.75)
            return (layer,)
        texture = ""
        if texels and "albedo" in kinds(material):
            color = np.ones(3)
            albedo = maps(material, texels).albedo
            assert albedo is not None
            texture = self._texture(map_name(material, "albedo"), albedo)
        glow = max(material.emission)
        if glow:
            color = displayed(np.array(material.emission) / max(1.0, glow))
        if material.opacity < 1.0:  # clear glass scatters less light than frosted glass
            color = color * (0.6 + 0.4 * min(1.0, material.specular_roughness / 0.5))
        self._add_material(material.name, (*color, material.opacity), texture, emission=1.0 if glow else 0.0)
        return (Layer(material.name), *self._add_gloss(material))

    def _add_gloss(self, material: Material) -> tuple[Layer, ...]:
        """Return the layer in which a smooth surface slightly mirrors the studio."""
        roughness, share = material.specular_roughness, 0.16 * (1.0 - material.specular_roughness / 0.5)
        if material.coat_weight > 0.0:
            roughness = min(roughness, material.coat_roughness)
            share = max(share, 0.16 * material.coat_weight * (1.0 - roughness / 0.5))
        if material.opacity < 1.0:
            share *= 1.3
        if share < 0.02:
            return ()
        layer = Layer(f"{material.name}_gloss", mirrors=True)
        self._add_material(layer.name, (1.0, 1.0, 1.0, share), self._mirror(roughness), emission=0.5)
        return (layer,)

    def _mirror(self, roughness: float) -> str:
        """Return the texture of the studio as a surface of this roughness mirrors it."""
        step = round(roughness / _MIRROR_STEP)
        light = displayed(sphere_map(_MIRROR_STEP * step))
        pixels = np.repeat(np.rint(255 * light).astype(np.uint8)[..., None], 3, axis=2)
        return self._texture(f"studio_mirror_{step}", pixels)

    def _texture(self, name: str, pixels: NDArray[np.uint8]) -> str:
        import mujoco

        if name not in self._textures:
            self._textures.add(name)
            height, width, channels = pixels.shape
            texture = self.spec.add_texture(
                name=name, type=mujoco.mjtTexture.mjTEXTURE_2D, width=width, height=height, nchannel=channels
            )
            texture.data = np.ascontiguousarray(pixels).tobytes()
        return name

    def _add_material(self, name: str, rgba: Any, texture: str, emission: float) -> None:
        import mujoco

        made = self.spec.add_material(
            name=name,
            rgba=[float(each) for each in rgba],
            emission=emission,
            specular=0.0,
            shininess=0.0,
            reflectance=0.0,
        )
        if texture:
            roles = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
            roles[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = texture
            made.textures = roles


@dataclass(frozen=True, eq=False)
class Drawn:
    """A surface of the asset in the model."""

    link: int  # number of its link
    mesh: Mesh  # faces in asset coordinates at rest
    mirrors: tuple[int, ...]  # numbers of its meshes in the model that mirror the studio


class RenderScene:
    """An asset in a studio, compiled for MuJoCo's renderer.

    Attributes:
        asset: The asset.
        model: MuJoCo's model: a movable body for each link, and the surroundings.
        data: State of the model.
        drawn: Every visible surface, in the order of the links.
        surface_of_geom: For each geom of the model the number of its surface from 1, 0 for other geoms.
        place: The surroundings.
    """

    def __init__(self, asset: Asset, studio: Studio, texels: int) -> None:
        import mujoco

        self.asset = asset
        self.place = backdrop(asset, studio)
        builder = SceneBuilder(self.place)
        self.add_surroundings(builder, texels)
        surfaces = []
        for number, link in enumerate(asset.links):
            body = builder.spec.worldbody.add_body(name=f"link_{number}", mocap=True)
            for of_link, surface in enumerate(link.surfaces):
                name = f"{number}_{of_link}"
                mirrors = builder.add_surface(body, name, surface.mesh, surface.material, texels)
                surfaces.append((name, number, surface.mesh, mirrors))
        self.model = builder.spec.compile()
        self.data = mujoco.MjData(self.model)
        self.drawn = tuple(
            Drawn(link, mesh, tuple(self.model.mesh(mirror).id for mirror in mirrors))
            for _, link, mesh, mirrors in surfaces
        )
        self.surface_of_geom = np.zeros(self.model.ngeom, np.int32)
        for index, (name, *_) in enumerate(surfaces, start=1):
            self.surface_of_geom[self.model.geom(f"{name}_0").id] = index

    def add_surroundings(self, builder: SceneBuilder, texels: int) -> None:
        """Add the surfaces around the asset."""
        for mesh, material in self.place.meshes:
            builder.add_surroundings(
                builder.spec.worldbody, f"studio_{material.name}", mesh, material, texels
            )

    def placed(self, camera: Camera, poses: Mapping[str, Array]) -> tuple[Camera, list[Array]]:
        """Pose the links for a camera; return camera and poses in studio coordinates."""
        import mujoco

        studio = self.place.turned(camera)
        moved = [studio @ poses[link.name] for link in self.asset.links]
        for number, matrix in enumerate(moved):
            mocap = self.model.body(f"link_{number}").mocapid[0]
            turn = np.zeros(4)
            mujoco.mju_mat2Quat(turn, np.ascontiguousarray(matrix[:3, :3]).ravel())
            self.data.mocap_pos[mocap] = matrix[:3, 3]
            self.data.mocap_quat[mocap] = turn
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_camlight(self.model, self.data)
        return camera.moved(studio), moved

    def depth_range(self, camera: Camera, poses: list[Array]) -> tuple[float, float]:
        """Return the range of visible depths along a camera's axis [m], in studio coordinates."""
        forward = camera.axes()[2]
        corners = [
            box_corners(link.bounds(), pose) for link, pose in zip(self.asset.links, poses, strict=True)
        ]
        depths = forward @ (np.concatenate(corners) - camera.position).T
        near = max(0.5 * float(depths.min()), 0.002 * self.place.radius)
        return near, float(depths.max()) + 60.0 * self.place.radius  # the backdrop is behind the asset
