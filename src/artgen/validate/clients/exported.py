"""An export as input of clients: the file to open, and the questions about it."""

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from artgen.asset import Asset, AssetJoint
from artgen.asset.affordance import head
from artgen.asset.files import ASSET_FILE, main_files
from artgen.errors import ExportError
from artgen.validate.clients.client import Client
from artgen.validate.readback.reading import sampled_positions

_POSES = 4  # beside the one as the asset stands


@dataclass(frozen=True)
class ClientExport:
    """An asset with the directory that it was exported to."""

    directory: Path  # the directory
    asset: Asset  # what `asset.json` says
    layout: str  # how the files lie
    mains: Mapping[str, Path]  # the file that a client opens, by format

    def is_read_by(self, client: Client) -> bool:
        """Return whether there is something for a client: a file of its format, in a layout that it reads."""
        return client.format in self.mains and self.layout in client.layouts

    def is_blocked(self, joint: AssetJoint) -> bool:
        """Return whether a dependency keeps a joint from moving alone while the asset is closed."""
        return joint.needs is not None and not joint.needs.condition.holds(self.asset.positions())

    def poses(self) -> list[dict[str, float]]:
        """Return some positions of every joint that can move; the first is how the asset stands."""
        moving = [joint.name for joint in self.asset.joints if not joint.locked]
        complete = [self.asset.positions(q) for q in sampled_positions(self.asset, _POSES)]
        return [{name: positions[name] for name in moving} for positions in complete]

    def request(self, client: Client) -> dict[str, Any]:
        """Return the request for a client's driver; see `drivers/README.md`."""
        return {
            "file": os.path.abspath(self.mains[client.format]),  # noqa: PTH100 - a link stays a link
            "format": client.format,
            "directory": os.path.abspath(self.directory),  # noqa: PTH100
            "layout": self.layout,
            "asset": self.asset.name,
            "base": self.asset.base,
            "links": [link.name for link in self.asset.links],
            "joints": [self._joint(joint) for joint in self.asset.joints if not joint.locked],
            "poses": self.poses(),
        }

    def _joint(self, joint: AssetJoint) -> dict[str, Any]:
        return {
            "name": joint.name,
            "kind": joint.kind,
            "limits": None if joint.limits is None else list(joint.limits),
            "follows": None if joint.follows is None else head(joint, self.asset).name,
            "damping": joint.damping,
            "stiffness": joint.stiffness,
            "rest": joint.rest,
            "friction": joint.friction,
            "armature": joint.armature,
            "effort": joint.effort,
            "velocity": joint.velocity,
            "blocked": self.is_blocked(joint),
            "mass": _moved_mass(self.asset, joint),
        }


def read_exported(directory: str | Path) -> ClientExport:
    """Read an export."""
    folder = Path(directory)
    asset = Asset.load(folder)
    layout = json.loads((folder / ASSET_FILE).read_text(encoding="utf-8")).get("layout", "flat")
    if not isinstance(layout, str):
        raise ExportError(f"the layout of {folder} is {layout!r}, which is no name; export the asset again")
    return ClientExport(folder, asset, layout, main_files(folder))


def _moved_mass(asset: Asset, joint: AssetJoint) -> float:
    moved = {joint.child}
    for parent, child, _ in asset.pairs():  # parents come before their children
        if parent in moved:
            moved.add(child)
    return float(sum(asset.link(name).mass_properties.mass for name in moved))
