"""What pixels of images show, found without artgen's renderer: rays against what a URDF's reader loads."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
import yourdfpy
from numpy.typing import NDArray
from trimesh.ray.ray_pyembree import RayMeshIntersector

Array = NDArray[np.float64]


class Solid:
    """An exported asset that rays are cast at.

    Args:
        directory: An export with `urdf`.
    """

    def __init__(self, directory: Path) -> None:
        record = json.loads((directory / "asset.json").read_text(encoding="utf-8"))
        self.labels = {
            f"{link['name']}_{surface['name']}": (link["name"], surface["label"])
            for link in record["links"]
            for surface in link["surfaces"]
        }
        self.urdf = yourdfpy.URDF.load(
            str(directory / record["formats"]["urdf"]["main"]), load_meshes=False, build_scene_graph=True
        )
        self.visuals = [
            (link.name, visual.name, visual.origin, _loaded(directory / visual.geometry.mesh.filename))
            for link in self.urdf.robot.links
            for visual in link.visuals
        ]

    def seen(self, image: dict[str, Any], pixels: Array) -> tuple[list[tuple[str, str]], Array]:
        """Return link and label that each pixel shows, empty for none, and its depth [m].

        Args:
            image: What COCO says of the image.
            pixels: Column and row of points of it, shape (n, 2) [pixels].
        """
        self.urdf.update_cfg({name: image["joints"][name] for name in self.urdf.actuated_joint_names})
        meshes, owners = [], []
        for link, _, origin, mesh in self.visuals:
            pose = self.urdf.get_transform(link) @ (np.eye(4) if origin is None else origin)
            meshes.append(mesh.copy().apply_transform(np.array(image["extrinsics"]) @ pose))
            owners.append(np.full(len(mesh.faces), len(owners)))
        whole = trimesh.util.concatenate(meshes)
        owner = np.concatenate(owners)
        camera = np.linalg.inv(np.array(image["intrinsics"]))
        rays = np.column_stack([pixels, np.ones(len(pixels))]) @ camera.T
        points, which, faces = RayMeshIntersector(whole).intersects_location(
            np.zeros_like(rays), rays, multiple_hits=False
        )
        found, depth = [("", "")] * len(pixels), np.full(len(pixels), np.inf)
        for point, ray, face in zip(points, which, faces, strict=True):
            found[ray] = self.labels[self.visuals[owner[face]][1]]
            depth[ray] = point[2]
        return found, depth


def _loaded(path: Path) -> trimesh.Trimesh:
    return trimesh.load_mesh(path, process=False, skip_materials=True)
