"""The scene of an asset for MuJoCo: each link as a posed body, in a studio."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.asset.surface import texture_coordinates
from artgen.materials import Material
from artgen.view.camera import Camera
from artgen.view.studio import Backdrop, backdrop

Studio = Literal["studio", "room", "none"]

ASSET_GROUP, GLOSS_GROUP, STUDIO_GROUP = 0, 1, 2
"""MuJoCo's geom groups: surfaces, gloss layers, and surroundings."""

HIDDEN_GROUP = 5
"""MuJoCo's geom group of invisible objects."""


@dataclass(frozen=True)
class Layer:
    """A MuJoCo material for one pass of a surface."""

    name: str  # name of the material in the model
    mirrors: bool = False  # whether its texture is a reflection of the studio


class Dress(Protocol):
    """Converts artgen's materials to MuJoCo's for one of its renderers."""

    def layers(self, spec: Any, material: Material, textures: int) -> tuple[Layer, ...]:
        """Add the textures and materials of a surface; return the material passes in draw order."""

    def surroundings(self, spec: Any, place: Backdrop) -> None:
        """Add lights and the sky to a specification."""


@dataclass(frozen=True, eq=False)
class Drawn:
    """A surface of the asset in the model."""

    link: int  # number of its link
    mesh: Mesh  # faces in asset coordinates at rest
    mirrors: tuple[int, ...]  # numbers of its meshes in the model that mirror the studio


class RenderScene:
    """An asset in a studio, compiled for one of MuJoCo's renderers.

    Attributes:
        asset: The asset.
        model: MuJoCo's model: a movable body for each link, and the surroundings.
        data: State of the model.
        drawn: Every visible surface, in the order of the links.
        surface_of_geom: For each geom of the model the number of its surface from 1, 0 for other geoms.
        place: The surroundings.
    """

    def __init__(self, asset: Asset, studio: Studio, textures: int, dress: Dress) -> None:
        import mujoco

        self.asset = asset
        self.place = backdrop(asset, studio)
        spec = mujoco.MjSpec()
        spec.stat.extent = self.place.radius
        spec.stat.center = self.place.center
        dress.surroundings(spec, self.place)
        for mesh, material in self.place.meshes:
            layer = dress.layers(spec, material, textures)[0]
            add_geom(spec, spec.worldbody, f"studio_{material.name}", mesh, material, layer, STUDIO_GROUP)
        names = []
        for number, link in enumerate(asset.links):
            body = spec.worldbody.add_body(name=f"link_{number}", mocap=True)
            for surface_number, surface in enumerate(link.surfaces):
                layers = dress.layers(spec, surface.material, textures)
                for layer_number, layer in enumerate(layers):
                    name = f"{number}_{surface_number}_{layer_number}"
                    group = GLOSS_GROUP if layer_number else ASSET_GROUP
                    add_geom(spec, body, name, surface.mesh, surface.material, layer, group)
                names.append((number, surface, layers, f"{number}_{surface_number}"))
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        self.surface_of_geom = np.zeros(self.model.ngeom, np.int32)
        drawn = []
        for index, (number, surface, layers, name) in enumerate(names):
            self.surface_of_geom[self.model.geom(f"{name}_0").id] = index + 1
            mirrors = tuple(
                self.model.mesh(f"{name}_{layer_number}").id
                for layer_number, layer in enumerate(layers)
                if layer.mirrors
            )
            drawn.append(Drawn(number, surface.mesh, mirrors))
        self.drawn = tuple(drawn)

    def placed(self, camera: Camera, poses: Mapping[str, Array]) -> tuple[Camera, list[Array]]:
        """Pose the links as seen by a camera, which always stands at the studio's front."""
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
        corner, turned = studio[:3, 3], camera.turned(studio[:3, :3])
        return (
            Camera(
                tuple(np.add(turned.position, corner)),
                tuple(np.add(turned.target, corner)),
                camera.field_of_view,
            ),
            moved,
        )

    def depth_range(self, camera: Camera, poses: list[Array]) -> tuple[float, float]:
        """Return the range of visible depths along a camera's axis [m], in studio coordinates."""
        forward = camera.axes()[2]
        depths = []
        for link, pose in zip(self.asset.links, poses, strict=True):
            corners = np.array(np.meshgrid(*link.bounds().T)).reshape(3, -1)
            depths.append(
                forward @ (pose[:3, :3] @ corners + pose[:3, 3:] - np.array(camera.position)[:, None])
            )
        least = min(float(depth.min()) for depth in depths)
        most = max(float(depth.max()) for depth in depths)
        near = max(0.5 * least, 0.002 * self.place.radius)
        return near, most + self.place.beyond


def add_geom(
    spec: Any, body: Any, name: str, mesh: Mesh, material: Material, layer: Layer, group: int
) -> None:
    """Add a mesh to a body of a specification, drawn with one layer of its material."""
    import mujoco

    coordinates = texture_coordinates(mesh, material)
    # MuJoCo counts v down from the first row of a texture
    coordinates = np.column_stack([coordinates[:, 0], 1.0 - coordinates[:, 1]])
    triangles = np.ascontiguousarray(mesh.triangles, np.int32).ravel()
    spec.add_mesh(
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
