"""Push bars (panic hardware): a touch bar that slides towards the leaf between fixed cases."""

from artgen import (
    Body,
    Float,
    Joint,
    Material,
    Prismatic,
    Scalar,
    box,
    detail,
    generator,
    given,
    part,
    push_on,
    weld,
)
from artgen.categories.shared.finish import casting, recess

_CHANNEL_DEPTH = 0.028  # how far the flanges of the rail stand out of the leaf [m]
_SHEET = 0.0028  # thickness of the rail [m]
_BAR_HEIGHT = 0.046
_BAR_REACH = 0.048  # face of the leaf to the front of the bar at rest [m]
_PLAY = 0.0008  # between the bar and the flanges above and below it [m]
_CASE_DEPTH = 0.052
_CASE_HEIGHT = 0.070
_CASE_LENGTH = 0.085  # of a full case; half of it is behind the lock, and the far one is half as long [m]
_CASE_TO_EDGE = 0.027  # from the lock to the end of its case: in front is the overlap of a second leaf [m]
_END_GAP = 0.0015  # between the bar and its cases [m]
_FULL = 0.2  # cases and bars are sheet metal around little: share of a full one's weight
_BOTTOM = 0.002  # what the innermost position leaves to the rail [m]


def _bar_span(length: Scalar) -> tuple[Scalar, Scalar]:
    """Return the middle and the length of the touch bar along X."""
    near = _CASE_LENGTH / 2 + _END_GAP  # the case over the lock is centered on its axis
    far = length - _CASE_LENGTH - _END_GAP
    return -(near + far) / 2, far - near


def push_slide(
    name: str = "handle_push",
    *,
    travel: Scalar,
    side: int = 1,
    preload: Scalar = 15.0,
    force: Scalar = 45.0,
    damping: Scalar = 40.0,
    friction: Scalar = 1.0,
) -> Joint:
    """Make the joint of a push bar that a spring returns; positive moves it towards the leaf."""
    stiffness = (force - preload) / travel
    return Prismatic(
        name,
        axis=(0.0, -side, 0.0),
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=friction,
        effort=200.0,
    )


@generator
def push_bar(
    *, thickness: Float, length: Float, travel: Float, finish: Material, side: int = given(1)
) -> Body:
    """Make the touch bar, the link `handle`; attach it with `push_slide`; weld `push_bar_case` on."""
    middle, span = _bar_span(length)
    back = thickness / 2 + _SHEET + _BOTTOM + travel
    front = thickness / 2 + _BAR_REACH
    bar = box(span, front - back, _BAR_HEIGHT, bevel=0.004).align((middle, side * front, 0.0), y=side)
    at = (middle + 0.25 * span, side * front, 0.0)  # nearer to the lock: far from the hinges
    return part(bar, "handle", casting(finish, _FULL), push=push_on(bar, direction=(0.0, -side, 0.0), at=at))


def push_bar_case(*, thickness: Scalar, length: Scalar, finish: Material, side: int = 1) -> Body:
    """Make the rail and the cases of a push bar, to be welded to the leaf; it has the label `rose`."""
    face = thickness / 2 - 0.0005
    middle, span = _bar_span(length)
    inner = _BAR_HEIGHT / 2 + _PLAY
    back = box(span + 0.004, _SHEET + 0.0005, 2 * inner + 0.002)
    flange = box(span + 0.004, _CHANNEL_DEPTH + 0.0005, _SHEET, bevel=0.001)
    flanges = [
        flange.at(middle, side * (face + _CHANNEL_DEPTH / 2), end * (inner + _SHEET / 2)) for end in (-1, 1)
    ]
    low, high = -_CASE_LENGTH / 2, _CASE_TO_EDGE
    near = box(high - low, _CASE_DEPTH, _CASE_HEIGHT, bevel=0.005)
    far = box(_CASE_LENGTH / 2, _CASE_DEPTH, _CASE_HEIGHT, bevel=0.005)
    far_middle = _CASE_LENGTH * 0.75 - length
    dark = recess(finish)
    plate = box(0.034, 0.0004, 0.007).at(0.0, side * (face + _CASE_DEPTH), 0.014)
    return weld(
        part(near.at((low + high) / 2, side * (face + _CASE_DEPTH / 2), 0.0), "rose", casting(finish, _FULL)),
        part(far.at(far_middle, side * (face + _CASE_DEPTH / 2), 0.0), "rose", casting(finish, _FULL)),
        part(back.at(middle, side * (face + _SHEET / 2), 0.0), "rose", finish),
        *(part(each, "rose", finish) for each in flanges),
        detail(plate, "screw", dark),
    )
