"""Real products: the sizes and masses that are sold, one line for each category and kind of it.

Sizes are those of the whole thing at rest, with what sticks out of it, such as handles and levers, but
without what is only seen, such as a cord. A new category enters its line; where kinds of it differ, as a
table lamp and a floor lamp do, each has one.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset

Span = tuple[float, float]

_SLACK = 0.0005  # what rounding and a bevel may add to a size [m]


@dataclass(frozen=True)
class Product:
    """What is sold of a kind.

    Attributes:
        kind: What it is, in a few words.
        width: From left to right, least and most [m].
        depth: From front to back [m].
        height: From the ground [m].
        mass: [kg].
        turns: Whether some stand with their long side to the front, and others with the short one.
    """

    kind: str
    width: Span
    depth: Span
    height: Span
    mass: Span
    turns: bool = False

    def misfits(self, asset: Asset) -> list[str]:
        """Return in what an asset is no such product, with the number and what is sold."""
        size = size_of(asset)
        both = (size, size[[1, 0, 2]]) if self.turns else (size,)
        ways = [
            [
                f"{name} {length:.3f} m, {least:g} to {most:g} m are sold"
                for name, length, (least, most) in zip(
                    ("width", "depth", "height"), each, (self.width, self.depth, self.height), strict=True
                )
                if not least - _SLACK <= length <= most + _SLACK
            ]
            for each in both
        ]
        least, most = self.mass
        heavy = [] if least <= asset.mass <= most else [f"mass {asset.mass:.2f} kg, {least:g} to {most:g} kg"]
        return [*min(ways, key=len), *heavy]


PRODUCTS: Mapping[str, tuple[Product, ...]] = {
    # leaves 0.61-1.07 x 1.98-2.44 m of 15-35 kg indoors and 30-60 kg outdoors, in frames of 0.03-0.09 m
    # at each side; softwood frames weigh 2-4 kg a metre
    "door": (
        Product("single door", (0.64, 1.30), (0.09, 0.36), (2.00, 2.75), (16.0, 110.0)),
        Product("double door", (1.25, 2.40), (0.09, 0.36), (2.00, 2.75), (30.0, 190.0)),
    ),
    # roses of 0.05-0.08 m and levers of 0.10-0.16 m on a sample board of a shop
    "handle": (Product("handle on a stand", (0.15, 0.40), (0.10, 0.30), (0.20, 0.60), (1.5, 9.0)),),
    # bodies of 0.45 or 0.60 x 0.57-0.62 x 0.82-0.88 m; handles and hoses stand out by up to 0.06 m
    "dishwasher": (
        Product("slim dishwasher", (0.44, 0.46), (0.56, 0.68), (0.81, 0.89), (30.0, 45.0)),
        Product("dishwasher", (0.59, 0.61), (0.56, 0.68), (0.81, 0.89), (35.0, 55.0)),
    ),
    # bases of 0.08-0.18 m radius; arms and arcs reach farther
    "lamp": (
        Product("table lamp", (0.14, 0.90), (0.14, 0.90), (0.28, 0.90), (0.8, 8.0)),
        Product("floor lamp", (0.16, 1.60), (0.16, 1.60), (1.15, 2.05), (2.0, 22.0)),
    ),
    # cabinets of 0.55-0.92 x 0.60-0.80 x 0.80-1.83 m; handles stand out by up to 0.07 m, hinge caps by 0.03 m
    "refrigerator": (
        Product("refrigerator", (0.54, 0.93), (0.58, 0.88), (1.20, 1.87), (50.0, 130.0)),
        Product("refrigerator under a counter", (0.54, 0.71), (0.58, 0.88), (0.79, 1.20), (25.0, 60.0)),
    ),
    # bodies of 0.25-0.40 x 0.15-0.32 x 0.18-0.22 m; levers, knobs and crumb trays stand out by up to 0.06 m
    "toaster": (Product("toaster", (0.24, 0.46), (0.14, 0.38), (0.17, 0.24), (1.0, 3.5), turns=True),),
    # pedals, lids that overhang and handles stand out of bodies of 0.15-0.45 m by up to 0.08 m
    "trashcan": (Product("trash can", (0.14, 0.53), (0.14, 0.53), (0.24, 0.83), (0.3, 10.0)),),
}
"""What is sold, by the name of the category."""


def size_of(asset: Asset) -> NDArray[np.float64]:
    """Return width, depth and height of an asset at rest, without what is only seen, shape (3,) [m]."""
    solids = [piece.shape.bounds() for link in asset.links for piece in link.pieces if not piece.visual]
    boxes = np.array(solids or [asset.bounds()])  # what was read from files has no solids
    size: NDArray[np.float64] = boxes[:, 1].max(axis=0) - boxes[:, 0].min(axis=0)
    return size


def misfits(asset: Asset) -> list[str]:
    """Return in what an asset is like no product of its category; nothing if it is like one.

    Of the kinds of a category, the one that it is most like counts.
    """
    ways = [product.misfits(asset) for product in PRODUCTS.get(asset.category, ())]
    return min(ways, key=len, default=[])
