"""Comparison of the colliders of an asset with other kinds of colliders: fidelity and speed."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from manifold3d import Manifold, OpType

from artgen.asset import Asset
from artgen.asset.collision import (
    COLLISIONS,
    SolidPart,
    collision_of,
    link_parts,
    made_colliders,
    replace_colliders,
)
from artgen.asset.record import significant
from artgen.export.mjcf import write_mjcf
from artgen.validate.fidelity import Fidelity, fidelity

_SETTLE = 1.0  # simulated time before the measurement [s]
_TIMED = 0.3  # least measured wall-clock time [s]
_BATCH = 50  # steps between two readings of the clock
_DIGITS = 6  # significant digits of numbers in the data


@dataclass(frozen=True)
class ColliderRow:
    """Colliders of one kind."""

    kind: str  # `exact`, `coacd` or `hull`
    # whether the asset has these colliders; the others were made for the comparison
    stored: bool
    links: Mapping[str, Fidelity]  # difference between colliders and solids, by link name
    volume_error: float  # volume in colliders or solids only, as a share of the volume of the solids
    surface_error: float  # largest distance between the surfaces of solids and colliders of a link [m]
    interior_kept: float  # share of the empty volume inside the convex hulls of the links that stays empty
    # MuJoCo steps per second of wall-clock time at the file's time step, with the asset at rest; None without
    # MuJoCo
    steps_per_second: float | None = None

    @property
    def pieces(self) -> int:
        """Number of colliders."""
        return sum(link.pieces for link in self.links.values())

    @property
    def vertices(self) -> int:
        """Number of their corners; round colliders have none."""
        return sum(link.vertices for link in self.links.values())

    def to_data(self) -> dict[str, Any]:
        """Return the row as JSON data, with the same numbers for each link."""
        speed = self.steps_per_second
        return {
            "kind": self.kind,
            "stored": self.stored,
            "pieces": self.pieces,
            "vertices": self.vertices,
            "volume_error": significant(self.volume_error, _DIGITS),
            "surface_error": significant(self.surface_error, _DIGITS),
            "interior_kept": significant(self.interior_kept, _DIGITS),
            "steps_per_second": None if speed is None else round(speed),
            "links": {
                name: {
                    "pieces": link.pieces,
                    "vertices": link.vertices,
                    "volume_error": significant(link.volume_error, _DIGITS),
                    "surface_error": significant(link.surface_error, _DIGITS),
                    "interior_kept": significant(link.interior_kept, _DIGITS),
                }
                for name, link in self.links.items()
            },
        }


def compare_colliders(asset: Asset, *, speed: bool = True) -> tuple[ColliderRow, ...]:
    """Compare the colliders of an asset with CoACD's and with plain convex hulls.

    They are compared with the solids, or for an asset that was read from files with the closed parts of its
    visible meshes. Exact colliders are known at construction only, so they are compared only if the asset has
    them.
    """
    parts = {link.name: link_parts(link) for link in asset.links}
    solids = {name: _united(of_link) for name, of_link in parts.items()}
    stored = collision_of([link.to_data() for link in asset.links])
    variants = [(stored, asset)]
    for kind in COLLISIONS:
        if kind not in ("exact", stored):
            made = {name: made_colliders(of_link, kind) for name, of_link in parts.items()}
            variants.append((kind, replace_colliders(asset, made, kind)))
    return tuple(
        _row(kind, variant, solids, stored=variant is asset, speed=speed) for kind, variant in variants
    )


def _row(
    kind: str, asset: Asset, solids: Mapping[str, Manifold], *, stored: bool, speed: bool
) -> ColliderRow:
    found = {
        link.name: fidelity(solids[link.name], [collider.convex for collider in link.colliders])
        for link in asset.links
    }
    volumes = {name: solid.volume() for name, solid in solids.items()}
    empty = {name: max(solid.hull().volume() - volumes[name], 0.0) for name, solid in solids.items()}
    return ColliderRow(
        kind,
        stored,
        found,
        _mean({name: item.volume_error for name, item in found.items()}, volumes),
        max(item.surface_error for item in found.values()),
        _mean({name: item.interior_kept for name, item in found.items()}, empty),
        steps_per_second(asset) if speed else None,
    )


def steps_per_second(asset: Asset) -> float | None:
    """Return MuJoCo's steps per second of wall-clock time, or None if it is not installed.

    The asset first moves from its initial state for one second. The number depends on the machine and its
    load.
    """
    try:
        import mujoco
    except ImportError:
        return None
    files = dict(write_mjcf(asset).files)
    text = files.pop(f"{asset.name}.xml").decode()
    model = mujoco.MjModel.from_xml_string(text, files)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=max(round(_SETTLE / model.opt.timestep), 1))
    steps, start = 0, time.perf_counter()
    while (elapsed := time.perf_counter() - start) < _TIMED:
        mujoco.mj_step(model, data, nstep=_BATCH)
        steps += _BATCH
    return steps / elapsed


def _united(parts: Sequence[SolidPart]) -> Manifold:
    return Manifold.batch_boolean([part.solid for part in parts], OpType.Add)


def _mean(values: Mapping[str, float], weights: Mapping[str, float]) -> float:
    """Return the mean of the values of the links; 1 if all weights are 0, as nothing was lost."""
    total = sum(weights.values())
    return sum(values[name] * weight for name, weight in weights.items()) / total if total else 1.0
