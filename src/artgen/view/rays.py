"""What rays of a camera hit, exactly, by Embree; needs no graphics."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset.shape import Mesh
from artgen.errors import RenderError


@dataclass(frozen=True, eq=False)
class Hits:
    """The first hits of rays."""

    surfaces: NDArray[np.int32]  # number of the surface that each ray hits from 1, 0 for none, shape (n,)
    distance: Array  # how often the direction fits between origin and hit, infinite for none, shape (n,)
    normals: Array  # unit normals, interpolated over the triangles; zero for none, shape (n, 3)
    # number of the triangle among those of all surfaces, -1 for none, shape (n,)
    triangles: NDArray[np.int64]
    shares: Array  # barycentric coordinates of the hit in its triangle, shape (n, 3)


def cast(meshes: Sequence[Mesh], origin: Array, directions: Array) -> Hits:
    """Return what rays from one point hit first."""
    try:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene
    except ImportError as error:
        raise RenderError(
            f'normals are found by Embree, which cannot be loaded ({error}): pip install "artgen[sim]"'
        ) from error
    corners = np.concatenate([mesh.vertices[mesh.triangles] for mesh in meshes])
    normals = np.concatenate([mesh.normals[mesh.triangles] for mesh in meshes])
    surface = np.repeat(np.arange(1, len(meshes) + 1), [len(mesh.triangles) for mesh in meshes])
    scene = EmbreeScene()
    # Embree counts in single precision: the origin of the rays is the origin of its coordinates
    TriangleMesh(scene, np.ascontiguousarray(corners - origin, np.float32))
    rays = np.ascontiguousarray(directions.reshape(-1, 3), np.float32)
    found = scene.run(np.zeros_like(rays), rays, output=True)
    triangle = np.asarray(found["primID"])
    hit = triangle >= 0
    share = np.stack([1.0 - found["u"] - found["v"], found["u"], found["v"]], axis=1).astype(float)
    smooth = np.zeros((len(rays), 3))
    blended = (share[hit][:, :, None] * normals[triangle[hit]]).sum(axis=1)
    smooth[hit] = blended / np.maximum(np.linalg.norm(blended, axis=1, keepdims=True), 1e-12)
    surfaces = np.zeros(len(rays), np.int32)
    surfaces[hit] = surface[triangle[hit]]
    distance = np.where(hit, np.asarray(found["tfar"], float), np.inf)
    return Hits(surfaces, distance, smooth, np.where(hit, triangle, -1).astype(np.int64), share)
