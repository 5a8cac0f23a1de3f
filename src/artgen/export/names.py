"""The table of names of a layout whose files have other names than the asset.

Layouts for the loaders of a dataset name bodies and joints as these loaders expect it. `artgen_names.json`
beside the files gives the asset's own names, for readers that compare the files with the asset.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array

NAMES_FILE = "artgen_names.json"
"""File with artgen's link and joint names for those of a layout."""


@dataclass(frozen=True, eq=False)
class Names:
    """Names of a layout that differ from those of the asset.

    Attributes:
        links: Link of the asset, by name of the body.
        joints: Joint of the asset by name in the file, with -1 for a reversed joint, else 1.
        couplings: Leader, ratio and offset of joints that follow, in the names of the file.
        axes: Rotation from the asset's axes to those of the bodies, by right angles, shape (3, 3).
    """

    links: Mapping[str, str] = field(default_factory=dict)
    joints: Mapping[str, tuple[str, int]] = field(default_factory=dict)
    couplings: Mapping[str, tuple[str, float, float]] = field(default_factory=dict)
    axes: Array = field(default_factory=lambda: np.eye(3))

    def joint(self, name: str) -> tuple[str, int]:
        """Return the joint of the asset for a name in the file, and its sign."""
        return self.joints.get(name, (name, 1))

    def to_data(self) -> dict[str, Any]:
        """Return the table as JSON data."""
        return {
            "links": dict(self.links),
            "joints": {key: {"name": name, "sign": sign} for key, (name, sign) in self.joints.items()},
            "couplings": {name: list(law) for name, law in self.couplings.items()},
            "axes": self.axes.astype(int).tolist(),
        }


def read_names(folder: Path) -> Names:
    """Read the table of an export; without one, the files have the names of the asset."""
    table = folder / NAMES_FILE
    if not table.exists():
        return Names()
    data = json.loads(table.read_text(encoding="utf-8"))
    return Names(
        data["links"],
        {name: (each["name"], each["sign"]) for name, each in data["joints"].items()},
        {name: tuple(law) for name, law in data["couplings"].items()},
        np.array(data["axes"], float),
    )
