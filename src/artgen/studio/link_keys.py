"""Keys by which a viewer tells that a link still looks as it did, so that it is not sent again."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Link
from artgen.asset.link import MovedLink
from artgen.asset.shape import ComposedShape, MovedShape, Shape

Key = tuple[Any, ...]


@dataclass(frozen=True, eq=False)
class Placed:
    """A link as what it looks like and where it stands at rest."""

    link: Link  # the link, shifted so that where it stands does not matter
    offset: Array  # where it stands, shape (3,) [m]
    key: Key  # decides how the shifted link looks: equal keys, equal surfaces


def placed(link: Link) -> Placed:
    """Tell how a link looks from where it stands.

    A key holds the solids that it speaks of by identity: evaluation gives the same ones again where nothing
    changed, so that neither triangles nor their hashes need to be made.
    """
    base, matrix = _unmoved(link)
    linear = matrix.copy()
    linear[:3, 3] = 0.0
    return Placed(base.moved(linear), matrix[:3, 3], (linear.tobytes(), *_link_key(base)))


def _unmoved(link: Link) -> tuple[Link, Array]:
    """Return the link before it was moved, and how it was, shape (4, 4); a new name lays textures anew."""
    if isinstance(link, MovedLink) and link.name == link.source.name:
        base, matrix = _unmoved(link.source)
        return base, link.matrix @ matrix
    return link, np.eye(4)


def _link_key(link: Link) -> Key:
    if isinstance(link, MovedLink):
        return (link.name, link.matrix.tobytes(), *_link_key(link.source))
    pieces = tuple((piece.label, piece.material, _shape_key(piece.shape)) for piece in link.pieces)
    return (link.name, pieces)


def _shape_key(shape: Shape) -> Key:
    if isinstance(shape, MovedShape):
        return (shape.matrix.tobytes(), _shape_key(shape.source))
    if isinstance(shape, ComposedShape):
        return tuple(_shape_key(each) for each in shape.shapes)
    return (_Same(shape),)


class _Same:
    """Equal to itself and to what stands for the same object, which it keeps."""

    def __init__(self, held: Any) -> None:
        self._held = held

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and self._held is other._held

    def __hash__(self) -> int:
        return id(self._held)
