"""Surfaces with fewer triangles, for small files that load fast."""

import math
from dataclasses import dataclass, field, replace
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import cached_property
from artgen._names import ByName
from artgen.asset import Asset, Mesh, Surface
from artgen.asset.asset import remember
from artgen.asset.collision import need_solids
from artgen.asset.joint import is_number
from artgen.asset.link import DerivedLink, Piece
from artgen.asset.surface import POSITION_DECIMALS, coarser, joined, rounded_mesh
from artgen.errors import ParameterError

COARSEST = 0.005
"""Largest allowed precision of visible meshes [m]."""

_PRINT = 0.1  # share of the precision that applies to print with its small letters
_ROUNDING = 0.01  # share of the precision for rounding of vertices along each axis
_DECIMALS = 4  # decimals of normals and texture coordinates


def with_precision(asset: Asset, precision: float) -> Asset:
    """Return an asset whose surfaces have fewer triangles; everything else stays.

    Surfaces of one color lose their texture coordinates. The certificate stays valid and is kept without its
    proof, which cannot be verified without the solids.
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
    result = replace(asset, links=ByName(links))
    if asset.certificate is not None:
        remember(result, replace(asset.certificate, leaves=None))
    return result


def check_precision(precision: float) -> None:
    """Raise ParameterError for a precision that is not allowed."""
    if not is_number(precision) or not 0.0 <= precision <= COARSEST:
        raise ParameterError(
            f"surfaces are precise to 0 (all that was made) to {COARSEST:g} m, not {precision!r}"
        )


@dataclass(frozen=True, eq=False, repr=False)
class CoarseLink(DerivedLink):
    """A link with fewer triangles in its surfaces; everything else comes from the source."""

    precision: float = field(kw_only=True)  # largest distance from the source's surfaces [m]
    origin: tuple[float, float, float] = field(kw_only=True)  # origin of the link's frame in files [m]

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of the source with fewer triangles; those of one color have no texture coordinates."""
        step, origin = self.precision * _ROUNDING, np.array(self.origin)
        return tuple(_rounded(surface, step, origin) for surface in self.source.surfaces_of(self._mesh))

    def _mesh(self, piece: Piece) -> Mesh:
        precision = (1.0 - 2.0 * _ROUNDING) * self.precision  # rounding uses its share
        return coarser(piece.shape, precision if piece.reading is None else _PRINT * precision)

    listed_surfaces = cached_property(attrgetter("surfaces"))
    details = cached_property(lambda link: [])  # details identify the solids in exact meshes only

    @property
    def changes(self) -> dict[str, Any]:
        """How colliders and surfaces were replaced, as JSON data."""
        return {**self.source.changes, "mesh_precision": self.precision}


def _rounded(surface: Surface, step: float, origin: NDArray[np.float64]) -> Surface:
    """Return a surface with rounded numbers in the frame at `origin`."""
    # without maps it has no texture coordinates: vertices that are otherwise equal become one
    mesh, material = surface.mesh, surface.material
    decimals = min(math.ceil(-math.log10(step)), POSITION_DECIMALS)
    if not material.texture:
        mesh = replace(mesh, uvs=np.zeros_like(mesh.uvs))
    rounded = rounded_mesh(mesh, origin, material, positions=decimals, normals=_DECIMALS, uvs=_DECIMALS)
    return replace(surface, mesh=joined([rounded]))
