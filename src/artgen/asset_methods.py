"""Methods of `Asset` that need higher layers: proof, checks, writers, pictures.

`artgen/__init__.py` binds them, so that `artgen.asset` imports nothing above itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from artgen.asset import Asset
from artgen.asset.asset import Limits, remember
from artgen.asset.certificate import Certificate

if TYPE_CHECKING:
    import mujoco
    import trimesh
    from pxr import Usd

    from artgen.asset.report import Report
    from artgen.view import Camera, Page, Picture, View


def certify(
    self: Asset, tolerance: float = 0.0, *, measure: bool = False, seconds: float = math.inf
) -> Certificate:
    """Prove that no two links collide anywhere in the joint ranges; see `artgen.proof.certify.certify`.

    The asset keeps the certificate, and `export` writes it.

    Args:
        tolerance: Clearance to prove between links that move against each other [m].
        measure: Whether to bracket each pair's smallest clearance, within a fifth and up to 10 mm.
        seconds: Time limit; pairs that are left after it are not proven, and the certificate names them [s].

    Raises:
        AssetError: The asset has no links, or a joint has no usable range or can never move.
    """
    from artgen.proof import certify

    certificate = certify.certify(self, tolerance, measure=measure, seconds=seconds)
    remember(self, certificate)
    return certificate


def safe_limits(self: Asset) -> dict[str, tuple[float, float]]:
    """Return for each free joint the largest range around rest without a collision [rad or m].

    See `artgen.proof.limits.safe_limits`.
    """
    from artgen.proof import limits

    return limits.safe_limits(self)


def with_limits(self: Asset, limits: Limits, keep: str | Iterable[str] = ()) -> Asset:
    """Return the asset with joint ranges in which every state is free; see `artgen.proof.limits.with_limits`.

    Args:
        limits: `independent`; `full` changes nothing.
        keep: Names of joints, or patterns such as `rack_*`, that keep their range where possible.

    Raises:
        AssetError: The ranges are narrowed already, or a pattern fits no joint.
    """
    from artgen.proof import limits as proof_limits

    return proof_limits.with_limits(self, limits, keep)


def with_colliders(self: Asset, most: int | Mapping[str, int], openings: float = 0.024) -> Asset:
    """Return the asset with fewer colliders, proven free of collisions; see `artgen.proof.fewer`.

    Joined pieces contain the solids, touch no other link in any joint state, and leave free each grasp and
    each opening of a link into which a ball fits from outside.

    Args:
        most: Largest number of colliders of the asset, or of single links by name.
        openings: Diameter of the widest ball whose ways from outside stay open [m].

    Raises:
        ParameterError: A number is not allowed.
        AssetError: The asset was read from files, it has no link of a name, or it needs more colliders; the
            message has the fewest that were found for each link.
    """
    from artgen.proof import fewer

    return fewer.with_colliders(self, most, openings)


def clearance(self: Asset, q: Mapping[str, float] | None = None) -> dict[tuple[str, str], float]:
    """Return the distance between the links of each pair at one pose, negative for overlaps [m].

    See `artgen.proof.limits.clearance`.
    """
    from artgen.proof import limits

    return limits.clearance(self, q)


def validate(self: Asset, *, behavior: bool = True) -> Report:
    """Export the asset to a temporary directory and run every check on the files.

    Args:
        behavior: Whether to simulate the asset in MuJoCo, if it is installed.
    """
    from artgen.validate import validate

    return validate(self, behavior=behavior)


def export(
    self: Asset,
    directory: str | Path,
    *,
    formats: Sequence[str] | None = None,
    collision: Literal["exact", "coacd", "hull"] = "exact",
    textures: int = 512,
    layout: str = "flat",
    mesh_precision: float = 0.0,
    limits: Limits = "full",
    frames: bool = True,
    states: int = 0,
) -> Path:
    """Write the asset to a directory, with its own colliders or others; see `artgen.export.export`."""
    from artgen.export import files

    return files.export(
        self,
        directory,
        formats=formats,
        collision=collision,
        textures=textures,
        layout=layout,
        mesh_precision=mesh_precision,
        limits=limits,
        frames=frames,
        states=states,
    )


def to_mjspec(self: Asset, *, textures: int = 512) -> mujoco.MjSpec:
    """Return the asset as an editable model of MuJoCo, as exported; see `artgen.export.objects.mjspec`."""
    from artgen.export import objects

    return objects.mjspec(self, textures)


def to_trimesh(
    self: Asset, q: Mapping[str, float] | None = None, *, colliders: bool = False, textures: int = 512
) -> trimesh.Scene:
    """Return the asset at a pose as a scene; see `artgen.export.objects.trimesh_scene`."""
    from artgen.export import objects

    return objects.trimesh_scene(self, q, textures, colliders=colliders)


def to_usd(self: Asset, *, textures: int = 512) -> Usd.Stage:
    """Return the asset as a USD stage in memory, as exported; see `artgen.export.objects.usd_stage`."""
    from artgen.export import objects

    return objects.usd_stage(self, textures)


def render(
    self: Asset,
    q: Mapping[str, float] | None = None,
    *,
    camera: Camera | View | str | None = None,
    size: int | tuple[int, int] = 768,
    studio: Literal["studio", "room", "none"] = "studio",
    textures: int = 512,
    samples: int = 8,
) -> Picture:
    """Render a picture of the asset, with masks, depth and normals; see `artgen.view.render`."""
    from artgen import view

    return view.render(self, q, camera=camera, size=size, studio=studio, textures=textures, samples=samples)


def show(self: Asset, *, textures: int = 512, height: int = 600) -> Page:
    """Return a page with a slider for each joint, which notebooks show; see `artgen.view.page_of`."""
    from artgen.view import page_of

    return page_of(self, textures=textures, height=height)


def _repr_html_(self: Asset) -> str:
    """Return the card that notebooks show: a small picture, and the facts of `print(asset)`."""
    from artgen.view.page import card

    return card(self)


def load(directory: str | Path) -> Asset:
    """Read an asset that `export` wrote; see `artgen.asset.files.load`."""
    from artgen.asset import files

    return files.load(directory)


def _reduce(self: Asset) -> tuple[Any, ...]:
    """Pickle the asset like its files: the unpickled asset has no solids, like a loaded one."""
    from artgen.asset.files import pack, unpack

    return unpack, pack(self)


def bind() -> None:
    """Make these functions methods of `Asset`."""
    own = (certify, safe_limits, with_limits, clearance, validate, export, to_mjspec, to_trimesh, to_usd)
    for method in (*own, with_colliders, render, show, _repr_html_):
        setattr(Asset, method.__name__, method)
    Asset.load = staticmethod(load)
    Asset.__reduce__ = _reduce  # type: ignore[method-assign, assignment]
