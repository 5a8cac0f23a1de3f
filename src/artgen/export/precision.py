"""Surfaces of fewer triangles, for files that are small and quick to load."""

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import cached_property
from artgen.asset import Asset, Link, Mesh, Surface
from artgen.asset.asset import remember
from artgen.asset.collision import need_solids
from artgen.asset.decimate import coarser
from artgen.asset.link import DerivedLink, Piece
from artgen.asset.rounding import POSITION_DECIMALS, rounded_mesh
from artgen.asset.surface import joined
from artgen.errors import ParameterError

COARSEST = 0.005
"""The farthest that what is seen may lie from what was made [m]."""

_PRINT = 0.1  # share of the precision that holds for print, whose letters are small
_ROUNDING = 0.01  # share of the precision that vertices move by at most, along each axis, for fewer digits
_DECIMALS = 4  # of normals and texture coordinates


def with_precision(asset: Asset, precision: float) -> Asset:
    """Return an asset whose surfaces have fewer triangles; colliders, masses and all else stay.

    Surfaces of one color, which need none, lose their texture coordinates. What was proven stays true, and
    is kept without its proof, which nobody could verify: that needs the solids.
    """
    check_precision(precision)
    if not precision:
        return asset
    need_solids(
        asset,
        f"its surfaces cannot be simplified within {precision:g} m",
        "mesh_precision=0, which keeps the surfaces that it has",
    )
    links = [
        CoarseLink.of(link, precision=precision, origin=tuple(asset.origin(link.name).tolist()))
        for link in asset.links
    ]
    result = replace(asset, links=tuple(links))
    if asset.certificate is not None:
        remember(result, replace(asset.certificate, leaves=None))
    return result


def check_precision(precision: float) -> None:
    """Refuse a precision that surfaces cannot have."""
    if not 0.0 <= precision <= COARSEST:
        raise ParameterError(
            f"surfaces are precise to 0 (all that was made) to {COARSEST:g} m, not {precision!r}"
        )


@dataclass(frozen=True, eq=False)
class CoarseLink(DerivedLink):
    """A link with surfaces of fewer triangles; the rest is the source's."""

    precision: float = field(kw_only=True)  # how far they may lie from the source's [m]
    origin: tuple[float, float, float] = field(kw_only=True)  # of its frame, in which files have them [m]

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The visible faces of the source, of fewer triangles; those of one color lie on one texel."""
        step, origin = self.precision * _ROUNDING, np.array(self.origin)
        return tuple(_rounded(surface, step, origin) for surface in self.source.surfaces_of(self._mesh))

    def _mesh(self, piece: Piece) -> Mesh:
        precision = (1.0 - 2.0 * _ROUNDING) * self.precision  # rounding takes its share
        return coarser(piece.shape, precision if piece.reading is None else _PRINT * precision)

    def surface_data(self) -> list[dict[str, Any]]:
        """Return label, material and number of triangles of each surface as JSON data."""
        return Link.surface_data(self)

    def details_data(self) -> list[dict[str, Any]]:
        """Return an empty list: details serve to tell the solids in the meshes, which these do not show."""
        return []

    def origin_data(self) -> dict[str, Any]:
        """Return how colliders and surfaces were made, as JSON data."""
        return {**super().origin_data(), "mesh_precision": self.precision}


def _rounded(surface: Surface, step: float, origin: NDArray[np.float64]) -> Surface:
    """Return a surface whose numbers have few digits in the frame at `origin`, positions to at most `step`.

    Without maps it has no texture coordinates: vertices that differ in nothing else are one.
    """
    mesh, material = surface.mesh, surface.material
    decimals = min(math.ceil(-math.log10(step)), POSITION_DECIMALS)
    if not material.texture:
        mesh = replace(mesh, uvs=np.zeros_like(mesh.uvs))
    rounded = rounded_mesh(mesh, origin, material, positions=decimals, normals=_DECIMALS, uvs=_DECIMALS)
    return replace(surface, mesh=joined([rounded]))
