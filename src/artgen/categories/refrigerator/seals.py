"""Gaskets of doors: profiles of rubber with a magnet in them, in the gap between a door and its cabinet."""

from artgen import Body, Material, Scalar, Solid, Y, box, detail, extrude, part, rectangle, weld


def door_gasket(
    width: Scalar,
    height: Scalar,
    *,
    rubber: Material,
    deep: Scalar,
    size: Scalar = 0.014,
    label: str = "gasket",
) -> Body:
    """Make the gasket of a door in the plane of X and Z about the origin; its foot is y = 0, it faces +y.

    It fills the gap of a closed door but for what the caller leaves: 0.3-0.5 mm is not seen, and lets door
    and cabinet be free of each other; or the gap is less, and `allow_contact` says so.
    """
    bodies = [part(bar, label, rubber) for bar in _ring(width, height, deep, size, 0.45 * deep)]
    # a flat ring is the root by which it sits in the door's groove
    inner = rectangle(width - 2 * size - 0.006, height - 2 * size - 0.006)
    root = rectangle(width + 0.006, height + 0.006, radius=0.006) - inner
    return weld(*bodies, detail(extrude(root, 0.004, axis=Y), label, rubber))


def _ring(width: Scalar, height: Scalar, deep: Scalar, size: Scalar, bevel: Scalar) -> list[Solid]:
    less = 0.0002  # uprights end inside of the level bars, a hair below their faces
    level = box(width, deep, size, bevel=bevel)
    upright = box(size - less, deep - less, height - size, bevel=bevel)
    return [
        *(level.at(0.0, deep / 2, way * (height - size) / 2) for way in (-1, 1)),
        *(upright.at(way * (width - size) / 2, deep / 2 - less / 2, 0.0) for way in (-1, 1)),
    ]
