"""Solids of a link that was read from files, reconstructed from its visual meshes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from manifold3d import Error, Manifold, Mesh64

from artgen._arrays import Array, FrozenArrays, cached_per_object
from artgen.asset import Link, Surface
from artgen.asset.collision import SolidPart, connected_parts, solid_parts
from artgen.errors import AssetError

_ONE_POINT = 3e-7  # vertices of a file nearer than this are one; files have seven decimals [m]
_ONE_BOX = 1e-6  # tolerance of bounding boxes in files [m]


@dataclass(frozen=True, eq=False)
class Details(FrozenArrays):
    """Visual details of a loaded link."""

    boxes: Mapping[str, Array] = field(default_factory=dict)  # bounding boxes by label, shape (n, 2, 3) [m]

    @staticmethod
    def of(data: Sequence[Mapping[str, Any]]) -> "Details":
        """Read the record."""
        boxes: dict[str, list[Any]] = {}
        for each in data:
            boxes.setdefault(each["label"], []).append(each["bounds"])
        return Details({label: np.array(of_label, float) for label, of_label in boxes.items()})

    def have(self, label: str, bounds: Array) -> bool:
        """Tell whether a part with a label and a bounding box, shape (2, 3), is a visual detail."""
        known = self.boxes.get(label)
        return known is not None and bool((np.abs(known - bounds).max(axis=(1, 2)) <= _ONE_BOX).any())


def mesh_precision(*links: Link) -> float:
    """Return the mesh precision that links were exported with; 0 for exact meshes [m]."""
    read = [link.to_data() for link in links if not link.pieces]
    return max((float(data.get("mesh_precision", 0.0)) for data in read), default=0.0)


@cached_per_object
def link_parts(link: Link) -> tuple[SolidPart, ...]:
    """Return the solids of a link; for a link that was read from files, the closed parts of its meshes.

    Visual details, such as heads of screws, are left out: label and bounding box identify them.
    """
    if link.pieces:
        return tuple(solid_parts(link))
    if precision := mesh_precision(link):
        raise AssetError(
            f"the meshes of link {link.name!r} have a precision of {1e3 * precision:g} mm and do not give "
            f"its exact solids; export the asset with mesh_precision=0",
            link=link.name,
        )
    groups: dict[str, list[Surface]] = {}
    for surface in link.surfaces:
        groups.setdefault(surface.label, []).append(surface)
    known = {collider.label: collider.material for collider in link.colliders}
    closed = {label: _closed(link, label, surfaces) for label, surfaces in groups.items()}
    details = Details.of(link.to_data().get("details", ()))
    return tuple(
        SolidPart(label, known.get(label, groups[label][0].material), part)
        for label, parts in closed.items()
        for part in parts
        if not details.have(label, np.reshape(part.bounding_box(), (2, 3)))
    )


def _closed(link: Link, label: str, surfaces: list[Surface]) -> list[Manifold]:
    """Return the closed parts of the surfaces of one label, with their hollows."""
    offsets = np.cumsum([0, *(len(surface.mesh.vertices) for surface in surfaces[:-1])])
    mesh = Mesh64(
        np.concatenate([surface.mesh.vertices for surface in surfaces]),
        np.concatenate(
            [surface.mesh.triangles + offset for surface, offset in zip(surfaces, offsets, strict=True)]
        ).astype(np.uint64),
        tolerance=_ONE_POINT,
    )
    mesh.merge()
    whole = Manifold(mesh)
    if whole.status() != Error.NoError:
        raise AssetError(
            f"the meshes of link {link.name!r} with label {label!r} do not close to a solid "
            f"({whole.status().name}); export the asset again",
            link=link.name,
        )
    if whole.is_empty():
        raise AssetError(
            f"the meshes of link {link.name!r} with label {label!r} are empty; export the asset again",
            link=link.name,
        )
    return connected_parts(whole)
