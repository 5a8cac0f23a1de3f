"""Requests to clients about an export, and the comparison of an answer with the asset."""

import itertools
import json
import os
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array, cached_property
from artgen.asset import Asset, AssetJoint
from artgen.asset.affordance import head
from artgen.asset.files import ASSET_FILE, main_files
from artgen.asset.joint import DYNAMICS, joints_above
from artgen.asset.report import Finding
from artgen.errors import ExportError
from artgen.validate.clients.registry import Client
from artgen.validate.joints import unit
from artgen.validate.readback.compare import Comparison, Expected
from artgen.validate.readback.reading import UNLIMITED, Inertial, Reading, ReadJoint, Stated
from artgen.validate.room import MOST_SHARE, MOST_WAY, SETTLE_TIME, WATCH_TIME

_PINNED = ("mjcf", "usd")  # formats with the pins of closed chains
_SAMPLES = 65  # of the law of a joint of a closed chain
_POSES = 4  # number of random poses, in addition to the rest pose


@dataclass(frozen=True)
class ClientExport:
    """An export directory with its asset."""

    directory: Path  # the directory
    asset: Asset  # the asset in `asset.json`
    layout: str  # layout of the files
    mains: Mapping[str, Path]  # main file of each format

    @cached_property
    def expected(self) -> Expected:
        """Values that clients should find."""
        return Expected(self.asset, _POSES)

    def is_read_by(self, client: Client) -> bool:
        """Return whether the export has a file of the client's format in a layout that it reads."""
        return client.format in self.mains and self.layout in client.layouts

    def is_blocked(self, joint: AssetJoint) -> bool:
        """Return whether a dependency blocks a joint while the asset is closed."""
        return joint.needs is not None and not joint.needs.condition.holds(self.asset.positions())

    def poses(self) -> list[dict[str, float]]:
        """Return several positions of every joint that can move; the first are those at rest."""
        moving = [joint.name for joint in self.asset.joints if not joint.locked]
        return [{name: positions[name] for name in moving} for _, positions, _ in self.expected.poses]

    def request(self, client: Client) -> dict[str, Any]:
        """Return the request to a client's driver; see `drivers/README.md`."""
        return {
            "client": client.name,
            "distribution": client.distribution,
            "file": os.path.abspath(self.mains[client.format]),  # noqa: PTH100 - a link stays a link
            "format": client.format,
            "directory": os.path.abspath(self.directory),  # noqa: PTH100
            "layout": self.layout,
            "asset": self.asset.name,
            "base": self.asset.base,
            "links": [link.name for link in self.asset.links],
            "joints": [self._joint(joint, client.format) for joint in self.asset.joints if not joint.locked],
            "poses": self.poses(),
            "free_links": self.free_links(client),
            "rest": [SETTLE_TIME, WATCH_TIME, MOST_WAY, MOST_SHARE] if self.asset.placed else [],
        }

    def free_links(self, client: Client) -> list[str]:
        """Return the links of free bodies, which stay in their place while joints of the room are posed.

        A URDF has none: it fixes them.
        """
        asset = self.asset
        return [
            link.name
            for link in (asset.links if client.format != "urdf" else ())
            if any(joint.child in asset.loose for joint in joints_above(asset.joints, link.name))
        ]

    def _joint(self, joint: AssetJoint, form: str) -> dict[str, Any]:
        return {
            **{key: getattr(joint, key) for key in ("name", "kind", *DYNAMICS)},
            "limits": None if joint.limits is None else list(joint.limits),
            "follows": None if joint.follows is None else head(joint, self.asset).name,
            "curve": self._curve(joint, form),
            "blocked": self.is_blocked(joint),
            "freed": self._freed(joint),
        }

    def _curve(self, joint: AssetJoint, form: str) -> list[list[float]] | None:
        """Return positions of the leader and a joint of a closed chain; empty if the format has no pins."""
        if joint.follows is None or joint.follows.curve is None:
            return None
        leader = head(joint, self.asset)
        if form not in _PINNED or leader.limits is None:
            return []
        places = np.linspace(*leader.limits, _SAMPLES).tolist()
        return [places, [self.asset.positions({leader.name: place})[joint.name] for place in places]]

    def _freed(self, joint: AssetJoint) -> dict[str, int]:
        """Return the limits, 0 or 1, of other joints that free a blocked joint; empty if none do."""
        if joint.needs is None:
            return {}
        condition, asset = joint.needs.condition, self.asset
        heads = dict.fromkeys(head(asset.joint(name), asset).name for name in condition.joints())
        limits = {name: ends for name in heads if (ends := asset.joint(name).limits)}
        for sides in itertools.product((1, 0), repeat=len(limits)):
            places = {name: ends[side] for side, (name, ends) in zip(sides, limits.items(), strict=True)}
            if condition.holds(asset.positions(places)):
                return dict(zip(limits, sides, strict=True))
        return {}


def read_exported(directory: str | Path) -> ClientExport:
    """Read an export.

    Raises:
        ExportError: There is no readable `asset.json`.
        AssetError: The file has another format, or names that artgen does not write.
    """
    folder = Path(directory)
    asset = Asset.load(folder)
    layout = json.loads((folder / ASSET_FILE).read_text(encoding="utf-8")).get("layout", "flat")
    if not isinstance(layout, str):
        raise ExportError(f"the layout of {folder} is {layout!r}, but must be a name; export the asset again")
    return ClientExport(folder, asset, layout, main_files(folder))


_REQUIRED = {"links": ("mass", "center", "inertia"), "joints": ("kind", "limits")}
_LEAST_MOTION = 0.1  # share of its range that a driven joint has to move
_MOST_BEYOND = 0.1  # share of its range by which a joint may exceed a limit, in addition to:
_SOFT = 0.02  # [rad or m]
_UNLIMITED = 1.0  # distance that an unlimited joint is driven [rad or m]


def differences(client: Client, exported: ClientExport, answer: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield the differences between a client's answer and the asset, and the missing values."""
    yield from _missing(client, exported, answer)
    parts = {part for part in ("links", "joints", "couplings", "poses") if part in answer}
    count = len(answer.get("poses", ()))
    if "poses" in answer and count != len(exported.poses()):
        yield Finding(client.name, f"its answer has {count} of {len(exported.poses())} poses")
        parts.remove("poses")
    reading = _reading(client, exported, answer, frozenset(parts))
    yield from Comparison(
        client.name, exported.expected, reading, client.format, *client.tolerances, hint=""
    ).differences()
    if not answer.get("finite", True):
        yield Finding(client.name, "positions become infinite or NaN in simulation")
    misplaced = _misplaced(client, exported)
    for name, span in answer.get("moved", {}).items():
        joint = exported.asset.joint(name)
        yield from _motion(client, joint, span, stuck=joint.child in misplaced)


def _missing(client: Client, exported: ClientExport, answer: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield the values missing in an answer, in total or for a link or joint."""
    parts = [key for key in client.reports if "." not in key]
    if missing := [key for key in parts if key not in answer]:
        yield Finding(client.name, f"its answer lacks {', '.join(missing)}")
    for part, quantities in _REQUIRED.items():
        required = [f"{part}.{quantity}" for quantity in quantities] if part in parts else []
        required += [key for key in client.reports if key.startswith(f"{part}.")]
        for name, read in answer.get(part, {}).items():
            lost = [
                quantity
                for key in required
                if (quantity := key.partition(".")[2]) not in read and key not in client.omits
            ]
            if lost:
                where = {part.removesuffix("s"): name}
                yield Finding(client.name, f"its answer lacks {', '.join(lost)}", **where)
    if "moved" in client.reports and "moved" in answer and not exported.asset.placed:  # rooms are at rest
        for joint in exported.asset.free_joints:
            if joint.name not in answer["moved"] and not exported.is_blocked(joint):
                yield Finding(client.name, "it was not driven in simulation", joint=joint.name)
    if "steps" in client.reports and not answer.get("steps", 1) > 0:
        yield Finding(client.name, "it simulated no steps")


def _reading(
    client: Client, exported: ClientExport, answer: Mapping[str, Any], parts: frozenset[str]
) -> Reading:
    """Return an answer as the values of a reader."""
    asset = exported.asset
    links = {asset.link(name).name: read for name, read in answer.get("links", {}).items()}
    joints = answer.get("joints", {})
    kinds = {joint.name: joint.kind for joint in asset.joints}
    poses = iter(answer.get("poses", ()))
    return Reading(
        exported.mains[client.format].name if client.format in exported.mains else client.name,
        lambda _: {name: _array(frame, 4, 4) for name, frame in next(poses).items()},
        parts=parts,
        partial=True,
        misplaced=_misplaced(client, exported) | frozenset(exported.free_links(client)),
        inertials={
            name: Inertial(
                float(read["mass"]),
                _array(read["center"], 3) if "center" in read else None,
                _array(read["inertia"], 3, 3) if "inertia" in read else None,
            )
            for name, read in links.items()
        },
        joints={
            name: ReadJoint(
                read.get("kind", kinds.get(name, "")),
                limits=tuple(_array(read["limits"] or UNLIMITED, 2).tolist()) if "limits" in read else None,
                dynamics=tuple(
                    Stated(field, float(read[field]), client.name) for field in DYNAMICS if field in read
                ),
            )
            for name, read in joints.items()
        },
        couplings={
            name: (leader, ratio, offset)
            for name, (leader, ratio, offset) in answer.get("couplings", {}).items()
        },
        holds=None,
    )


def _misplaced(client: Client, exported: ClientExport) -> frozenset[str]:
    """Return the links that a client puts elsewhere, where they may touch others."""
    return moved_by_several(exported.asset) if client.misplaces else frozenset()


def moved_by_several(asset: Asset) -> frozenset[str]:
    """Return the links with several joints, and their descendants."""
    joints = [joint for joint in asset.joints if not joint.locked]
    found = {name for name, count in Counter(joint.child for joint in joints).items() if count > 1}
    for joint in asset.joints:  # parents come before children
        if joint.parent in found:
            found.add(joint.child)
    return frozenset(found)


def _motion(client: Client, joint: AssetJoint, span: Any, *, stuck: bool) -> Iterator[Finding]:
    """Yield the faults in the motion of a joint, which may be stuck."""
    least, most = (float(end) for end in span)
    low, high = joint.limits or (-_UNLIMITED, _UNLIMITED)
    if not stuck and not most - least >= _LEAST_MOTION * (high - low):
        force = f"{joint.effort:g} {unit(joint, 'effort')}"
        message = f"driven by {force} it moves only from {least:.4g} to {most:.4g}"
        yield Finding(client.name, message, joint=joint.name, value=most - least)
    slack = _SOFT + _MOST_BEYOND * (high - low)
    if joint.limits is not None and not (low - slack <= least and most <= high + slack):
        message = f"it leaves its limits of {low:.4g} to {high:.4g}: it moves from {least:.4g} to {most:.4g}"
        yield Finding(client.name, message, joint=joint.name, value=max(low - least, most - high))


def _array(value: Any, *shape: int) -> Array:
    """Return numbers as an array; raise ValueError for another shape."""
    result = np.array(value, float)
    if result.shape != shape:
        raise ValueError(f"an array has the shape {result.shape} instead of {shape}")
    return result
