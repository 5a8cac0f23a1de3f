"""The solids of a link that was read from files, made of the meshes that are seen."""

import numpy as np
from manifold3d import Error, Manifold, Mesh64
from numpy.typing import NDArray

from artgen.asset import Link, Surface
from artgen.colliders.connected import connected_parts
from artgen.errors import AssetError
from artgen.export.collision import Part, solid_parts

Array = NDArray[np.float64]

_ONE_POINT = 3e-7  # [m]: vertices of a file nearer than this are one; it has seven decimals
_ONE_BOX = 1e-6  # [m] that a bounding box may be off in a file


def link_parts(link: Link) -> list[Part]:
    """Return the solids of a link; where it was read from files, the closed parts of its meshes.

    What has neither mass nor collider, such as the head of a screw, is told by its label and bounding box.

    Raises:
        AssetError: The meshes of a label do not close.
    """
    if link.pieces:
        return solid_parts(link)
    groups: dict[str, list[Surface]] = {}
    for surface in link.surfaces:
        groups.setdefault(surface.label, []).append(surface)
    known = {collider.label: collider.material for collider in link.colliders}
    closed = {label: _closed(link, label, surfaces) for label, surfaces in groups.items()}
    details: dict[str, list[Array]] = {}
    for detail in link.to_data().get("details", ()):
        details.setdefault(detail["label"], []).append(np.array(detail["bounds"], np.float64))
    return [
        Part(label, known.get(label, groups[label][0].material), part)
        for label, parts in closed.items()
        for part in parts
        if not any(_is_box_of(part, box) for box in details.get(label, ()))
    ]


def _closed(link: Link, label: str, surfaces: list[Surface]) -> list[Manifold]:
    """Return the closed parts of the faces that share a label, with their hollows."""
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


def _is_box_of(part: Manifold, box: Array) -> bool:
    found = np.array(part.bounding_box(), np.float64).reshape(2, 3)
    return bool(np.abs(found - box).max() <= _ONE_BOX)
