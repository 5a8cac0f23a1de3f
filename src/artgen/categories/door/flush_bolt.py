"""The flush bolt that holds the inactive leaf of a double door in the head of its frame.

Everything is drawn about the top of the leaf: the origin is on the axis of the bolt (along Z), in the middle
of the leaf's thickness, level with its top. The front of the leaf, with the thumb slide, faces -y.
"""

from artgen import (
    Body,
    Float,
    Joint,
    Material,
    Prismatic,
    Scalar,
    Solid,
    X,
    Y,
    Z,
    box,
    cylinder,
    detail,
    generator,
    grasp_on,
    part,
    union,
    weld,
)

_ROD = 0.010  # width of the square bolt [m]
_PLAY = 0.0004  # around the bolt in the leaf [m]
_STEM = (0.006, 0.012)  # width and height of what joins the bolt and its slide [m]
_BELOW = 0.420  # the slide is this far below the top of the leaf, within reach [m]
_GRASP = 0.012  # engagement in the head [m]
_PLATE = (0.024, 0.0018, 0.075)  # of the cover around the slide [m]


def throw(gap: Scalar) -> Scalar:
    """Return how far the bolt stands out of the leaf at rest [m]."""
    return gap + _GRASP


def flush_bolt_slide(gap: Scalar, *, name: str = "flush_bolt_slide") -> Joint:
    """Make the joint of the bolt: 0 is thrown, positive is drawn down; friction carries its weight."""
    # 1 mm further than flush
    return Prismatic(
        name, axis=-Z, limits=(0.0, throw(gap) + 0.001), friction=12.0, damping=20.0, effort=100.0
    )


@generator
def flush_bolt(*, thickness: Float, gap: Float, finish: Material) -> Body:
    """Make the bolt with its thumb slide: the link `flush_bolt`."""
    long = _BELOW + 0.012 + throw(gap)
    rod = box(_ROD, _ROD, long, bevel=0.001).at(0.0, 0.0, throw(gap) - long / 2.0)
    face = thickness / 2.0 + _PLATE[1]
    stem = box(_STEM[0], face + 0.002, _STEM[1]).at(0.0, -(face + 0.002) / 2.0, -_BELOW)
    thumb = box(0.018, 0.010, 0.024, bevel=0.003).at(0.0, -(face + 0.0055), -_BELOW)
    hold = grasp_on(thumb, approach=Y, closing=X, depth=0.009)  # 1 mm less than it stands out
    return part(union(rod, stem, thumb), "flush_bolt", finish, grasp=hold)


def flush_bolt_channel(thickness: Scalar, gap: Scalar) -> Solid:
    """Make the tool that cuts the bolt's channel and the slot of its slide into the leaf."""
    long = _BELOW + 0.012 + throw(gap) + 0.007  # 4 mm out of the leaf, 2 mm below the drawn bolt
    channel = box(_ROD + 2 * _PLAY, _ROD + 2 * _PLAY, long).at(0.0, 0.0, 0.004 - long / 2.0)
    return channel | _slot(thickness / 2.0 + 0.004, gap)


def _slot(reach: Scalar, gap: Scalar) -> Solid:
    tall = _STEM[1] + throw(gap) + 0.003
    return box(_STEM[0] + 2 * _PLAY, reach, tall).align(
        (0.0, 0.0, -_BELOW + _STEM[1] / 2.0 + 0.001), y=1.0, z=1.0
    )


def flush_bolt_pocket(gap: Scalar) -> Solid:
    """Make the tool that cuts the hole for the thrown bolt into the head; the leaf rattles by 0.7 mm."""
    deep = throw(gap) + 0.004
    pocket = box(_ROD + 0.004, _ROD + 0.0007 + 0.002, deep - gap + 0.002)
    return pocket.align((0.0, -_ROD / 2.0 - 0.0007, deep), y=-1.0, z=1.0)


@generator
def flush_bolt_plate(*, thickness: Float, gap: Float, finish: Material) -> Body:
    """Make the cover around the slide, to be welded to the leaf; it has the label `faceplate`."""
    wide, thick, tall = _PLATE
    middle = -_BELOW - throw(gap) / 2.0
    plate = box(wide, thick, tall, bevel=0.0004).at(0.0, -(thickness / 2.0 + thick / 2.0 - 0.0004), middle)
    screws = [
        detail(
            cylinder(0.003, 0.0008, axis=Y, bevel=0.0002).at(0.0, -(thickness / 2.0 + thick - 0.0004), place),
            "screw",
            finish,
        )
        for place in (middle - tall / 2.0 + 0.006, middle + tall / 2.0 - 0.006)
    ]
    cover = plate - _slot(thickness / 2.0 + 0.004, gap)
    return weld(detail(cover, "faceplate", finish), *screws)  # thin, and behind the slide
