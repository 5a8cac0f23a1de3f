"""Reading an export in the layout `partnet-mobility` back, as loaders of the dataset do."""

import json
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import yourdfpy
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.validate.readback.compare import expected_frames

Array = NDArray[np.float64]

# columns are where the asset's x, y and z point: mesh coordinates are y up with the front to z
TO_MESH = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
# and `base` is z up with the front to -x
TO_BASE = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def robot(directory: Path, name: str = "mobility.urdf") -> ET.Element:
    """Return the URDF of an export."""
    return ET.parse(directory / name).getroot()


def table(directory: Path, name: str) -> Any:
    """Return one of its JSON files."""
    return json.loads((directory / name).read_text(encoding="utf-8"))


def pose_errors(asset: Asset, directory: Path, q: Mapping[str, float]) -> dict[str, float]:
    """Return how far each body's frame is from where the asset has it, in `base` [m or radians]."""
    names = table(directory, "artgen_names.json")
    reader = yourdfpy.URDF.load(
        str(directory / "mobility.urdf"), load_meshes=False, build_scene_graph=True, mesh_dir=str(directory)
    )
    positions = asset.positions(q)
    reader.update_cfg(
        {
            number: item["sign"] * positions[item["name"]]
            for number, item in names["joints"].items()
            if number in reader.actuated_joint_names
        }
    )
    frames = expected_frames(asset, dict(q))
    errors = {}
    for number, name in names["links"].items():
        found = np.array(reader.get_transform(number, "base"))
        wanted = np.eye(4)
        wanted[:3, :3] = TO_BASE @ frames[name][:3, :3] @ TO_MESH.T
        wanted[:3, 3] = TO_BASE @ frames[name][:3, 3]
        errors[name] = float(np.abs(found - wanted).max())
    return errors
