"""Push bars (panic hardware): a touch bar that slides towards the leaf between fixed cases."""

import artgen as ag
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


def _bar_span(length: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return the middle and the length of the touch bar along X."""
    near = _CASE_LENGTH / 2 + _END_GAP  # the case over the lock is centered on its axis
    far = length - _CASE_LENGTH - _END_GAP
    return -(near + far) / 2, far - near


def push_slide(
    name: str = "handle_push",
    *,
    travel: ag.Scalar,
    side: int = 1,
    preload: ag.Scalar = 15.0,
    force: ag.Scalar = 45.0,
    damping: ag.Scalar = 40.0,
    friction: ag.Scalar = 1.0,
) -> ag.Joint:
    """Make the joint of a push bar that a spring returns; positive moves it towards the leaf."""
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=(0.0, -side, 0.0),
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=friction,
        effort=200.0,
    )


@ag.generator
def push_bar(
    *, thickness: ag.Float, length: ag.Float, travel: ag.Float, finish: ag.Material, side: int = ag.given(1)
) -> ag.Body:
    """Make the touch bar, the link `handle`; attach it with `push_slide`; weld `push_bar_case` on."""
    middle, span = _bar_span(length)
    back = thickness / 2 + _SHEET + _BOTTOM + travel
    front = thickness / 2 + _BAR_REACH
    bar = ag.box(span, front - back, _BAR_HEIGHT, bevel=0.004).align((middle, side * front, 0.0), y=side)
    at = (middle + 0.25 * span, side * front, 0.0)  # nearer to the lock: far from the hinges
    return ag.part(
        bar, "handle", casting(finish, _FULL), push=ag.push_on(bar, direction=(0.0, -side, 0.0), at=at)
    )


def push_bar_case(*, thickness: ag.Scalar, length: ag.Scalar, finish: ag.Material, side: int = 1) -> ag.Body:
    """Make the rail and the cases of a push bar, to be welded to the leaf; it has the label `rose`."""
    face = thickness / 2 - 0.0005
    middle, span = _bar_span(length)
    inner = _BAR_HEIGHT / 2 + _PLAY
    back = ag.box(span + 0.004, _SHEET + 0.0005, 2 * inner + 0.002)
    flange = ag.box(span + 0.004, _CHANNEL_DEPTH + 0.0005, _SHEET, bevel=0.001)
    flanges = [
        flange.at(middle, side * (face + _CHANNEL_DEPTH / 2), end * (inner + _SHEET / 2)) for end in (-1, 1)
    ]
    low, high = -_CASE_LENGTH / 2, _CASE_TO_EDGE
    near = ag.box(high - low, _CASE_DEPTH, _CASE_HEIGHT, bevel=0.005)
    far = ag.box(_CASE_LENGTH / 2, _CASE_DEPTH, _CASE_HEIGHT, bevel=0.005)
    far_middle = _CASE_LENGTH * 0.75 - length
    dark = recess(finish)
    plate = ag.box(0.034, 0.0004, 0.007).at(0.0, side * (face + _CASE_DEPTH), 0.014)
    return ag.weld(
        ag.part(
            near.at((low + high) / 2, side * (face + _CASE_DEPTH / 2), 0.0), "rose", casting(finish, _FULL)
        ),
        ag.part(far.at(far_middle, side * (face + _CASE_DEPTH / 2), 0.0), "rose", casting(finish, _FULL)),
        ag.part(back.at(middle, side * (face + _SHEET / 2), 0.0), "rose", finish),
        *(ag.part(each, "rose", finish) for each in flanges),
        ag.detail(plate, "screw", dark),
    )
