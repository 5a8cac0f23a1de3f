"""Pumps of soap dispensers: the collar on a bottle, and the nozzle that is pressed down and turned.

A pump is about the z axis. Its nozzle is modeled with its underside at z = 0, and points to the front.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.vessels import Run, core, turned

Nozzle = Literal["saddle", "beak", "gooseneck", "bar", "swan", "foamer"]
"""Shape of a nozzle: a molded saddle; a beak under a cap; a bent tube; a square bar; a thin tube from a post
with a cap; or the wide cap of a foam pump with its short beak."""

HEAD = {
    "saddle": 0.0110,
    "beak": 0.0140,
    "gooseneck": 0.0340,
    "bar": 0.0125,
    "swan": 0.0290,
    "foamer": 0.0250,
}
"""Height of each nozzle above its underside [m]."""

COLLAR = 0.0245
"""Height of a collar with its sleeve [m]."""

GAP = 0.0012
"""Gap between a nozzle that is pressed home and the sleeve [m]."""

_STEM = 0.0038  # radius of the stem [m]
_PLAY = 0.0004  # gap around the stem [m]
_ENGAGED = 0.0042  # depth of the stem in the sleeve while the nozzle is up [m]
_RIBS = 36
_WIDE = {"foamer": 0.0200}  # radius of the collar; others have 28 mm threads
_THREAD = 0.0165


@dataclass(frozen=True)
class PumpLooks:
    """Finish of a pump."""

    finish: ag.Material  # finish of collar and nozzle
    stem: ag.Material  # material of the stem
    ribbed: bool  # whether the collar has ribs for fingers
    ink: ag.Material | None = None  # material of the print; None for no print


def collar(nozzle: Nozzle, low: ag.Scalar, looks: PumpLooks) -> ag.Body:
    """Make the collar on a neck, with the sleeve in which the stem slides."""
    radius = _WIDE.get(nozzle, _THREAD)
    neck = 0.0105 if nozzle != "foamer" else 0.0150
    top = low + COLLAR
    runs: list[Run] = [
        [(radius - 0.0005, low), (radius, low + 0.0008)],
        [(radius, low + 0.0008), (radius, low + 0.0160)],
        [(radius, low + 0.0160), (radius - 0.0006, low + 0.0178), (radius - 0.0022, low + 0.0186)],
        [(neck, low + 0.0186), (neck - 0.0006, top - 0.0008)],
        [(neck - 0.0006, top - 0.0008), (neck - 0.0014, top)],
    ]
    half = _STEM + _PLAY
    hole = ag.Region.between((-half, -half, low - 0.001), (half, half, top + 0.001)).box()
    body = turned(runs, "collar", looks.finish, hole=hole, bore=half)
    if not looks.ribbed:
        return body
    ribs = ag.extrude(_fluted().scale(radius + 0.0007) - ag.circle(radius - 0.0015), 0.0140, bevel=0.0003)
    return ag.weld(body, ag.detail(ribs.at(0.0, 0.0, low + 0.0085), "collar", looks.finish))


def _fluted() -> ag.Profile:
    steps = 4 * _RIBS
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 - 0.018 * (1.0 - math.cos(_RIBS * angle)) for angle in angles]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def nozzle_body(kind: Nozzle, *, reach: ag.Scalar, travel: ag.Scalar, looks: PumpLooks) -> ag.Body:
    """Make a nozzle with its stem: the link `nozzle`."""
    low = -(travel + GAP + _ENGAGED)
    stem = ag.cylinder_between((0.0, 0.0, low), (0.0, 0.0, 0.004), _STEM)
    make = {
        "saddle": _saddle,
        "beak": _beak,
        "gooseneck": _gooseneck,
        "bar": _bar,
        "swan": _swan,
        "foamer": _foamer,
    }[kind]
    return ag.weld(*make(reach, looks), ag.part(stem, "stem", looks.stem))


def _spout(stations: list[tuple[ag.Scalar, float, float, float]]) -> ag.Solid:
    """Make a spout of rounded sections to the front: distance from the axis, width, height, middle's z."""
    plans = [
        ag.rectangle(wide, high, radius=0.42 * min(wide, high)).at(0.0, level)
        for _, wide, high, level in stations
    ]
    return ag.loft(plans, [far for far, *_ in stations], axis=(0.0, -1.0, 0.0))


def _mouth(
    at: tuple[ag.Scalar, ag.Scalar], radius: float, finish: ag.Material, long: float = 0.004
) -> ag.Body:
    """Make the short downward pipe at the end of a spout."""
    y, z = at
    return ag.part(
        ag.cylinder_between((0.0, y, z - long), (0.0, y, z), radius, bevel=0.0004), "nozzle", finish
    )


def _saddle(reach: ag.Scalar, looks: PumpLooks) -> list[ag.Body]:
    spout = _spout(
        [
            (-0.0130, 0.0120, 0.0060, 0.0078),
            (-0.0085, 0.0190, 0.0076, 0.0070),
            (0.0085, 0.0200, 0.0086, 0.0060),
            (0.45 * reach, 0.0130, 0.0080, 0.0066),
            (0.75 * reach, 0.0085, 0.0068, 0.0060),
            (reach, 0.0070, 0.0056, 0.0036),
        ]
    )
    hub = ag.cylinder_between((0.0, 0.0, 0.0), (0.0, 0.0, 0.006), 0.0088, bevel=0.0008)
    push = ag.push_on(spout, direction=-ag.Z, at=(0.0, 0.0, 0.005))
    hold = ag.grasp_on(spout, approach=-ag.Z, closing=ag.X, at=(0.0, -0.001, 0.005), depth=0.006)
    bodies = [
        ag.part(spout, "nozzle", looks.finish, push=push, grasp=hold),
        ag.part(hub, "nozzle", looks.finish),
        _mouth((-reach + 0.0032, 0.0016), 0.0027, looks.finish, 0.003),
    ]
    if looks.ink is not None:  # direction of locking
        arrow = details.icon("repeat", 0.0065)
        bodies.append(details.printed(arrow, (0.0, 0.0, 0.0104), material=looks.ink, facing=ag.Z))
    return bodies


def _cap_runs(radius: float, low: float, high: float) -> list[Run]:
    """Return the outline of a round cap with soft edges and a slightly domed top."""
    return [
        [(radius - 0.0006, low), (radius, low + 0.0008)],
        [(radius, low + 0.0008), (radius, high - 0.0024)],
        [(radius, high - 0.0024), (radius - 0.0008, high - 0.0008), (0.72 * radius, high)],
    ]


def _beak(reach: ag.Scalar, looks: PumpLooks) -> list[ag.Body]:
    top = HEAD["beak"]
    spout = _spout(
        [
            (0.0040, 0.0100, 0.0080, 0.0066),
            (0.55 * reach, 0.0088, 0.0072, 0.0068),
            (0.86 * reach, 0.0074, 0.0064, 0.0062),
            (reach, 0.0066, 0.0050, 0.0048),
        ]
    )
    runs = _cap_runs(0.0125, 0.0, top)
    cap = turned(runs, "cap", looks.finish)
    block = ag.cylinder_between((0.0, 0.0, 0.004), (0.0, 0.0, top), 0.010)
    hold = ag.grasp_on(spout, approach=-ag.Z, closing=ag.X, at=(0.0, -0.72 * reach, 0.0066), depth=0.006)
    return [
        ag.part(spout, "nozzle", looks.finish, grasp=hold, push=ag.push_on(block, direction=-ag.Z)),
        cap,
        _mouth((-reach + 0.0030, 0.0030), 0.0025, looks.finish, 0.003),
    ]


def _tube(points: list[tuple[ag.Scalar, ag.Scalar]], radius: float) -> ag.Solid:
    """Make a bent tube in the plane x = 0: y and z of its points."""
    return ag.sweep(ag.circle(radius), ag.spline([(0.0, y, z) for y, z in points]))


def _gooseneck(reach: ag.Scalar, looks: PumpLooks) -> list[ag.Body]:
    rise = HEAD["gooseneck"] - 0.0042
    tube = _tube(
        [
            (0.0, 0.003),
            (0.0, 0.014),
            (-0.0075, rise - 0.005),
            (-0.42 * reach, rise),
            (-0.78 * reach, rise - 0.006),
            (-reach, rise - 0.020),
        ],
        0.0042,
    )
    runs: list[Run] = [
        [(0.0086, 0.0), (0.0090, 0.0008)],
        [(0.0090, 0.0008), (0.0090, 0.0070)],
        [(0.0090, 0.0070), (0.0076, 0.0098), (0.0050, 0.0110)],
    ]
    at = (0.0, -0.42 * reach, rise)
    hold = ag.grasp_on(tube, approach=-ag.Z, closing=ag.X, at=at, depth=0.006)
    lip = ag.ring(0.0050, 0.0030)
    mouth = ag.extrude(lip, 0.003, axis=(0.0, -0.35, -1.0)).at(0.0, -reach, rise - 0.020)
    return [
        ag.part(tube, "nozzle", looks.finish, grasp=hold, push=ag.push_on(tube, direction=-ag.Z, at=at)),
        turned(runs, "nozzle", looks.finish, sides=16),
        ag.detail(mouth, "nozzle", looks.finish),
    ]


def _bar(reach: ag.Scalar, looks: PumpLooks) -> list[ag.Body]:
    top = HEAD["bar"]
    bar = ag.Region.between((-0.0056, -reach, 0.0025), (0.0056, 0.0085, top)).box(bevel=0.0012)
    hub = ag.cylinder_between((0.0, 0.0, 0.0), (0.0, 0.0, 0.004), 0.0080, bevel=0.0006)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.X, at=(0.0, -0.6 * reach, 0.007), depth=0.008)
    push = ag.push_on(bar, direction=-ag.Z, at=(0.0, 0.0, 0.007))
    return [
        ag.part(bar, "nozzle", looks.finish, grasp=hold, push=push),
        ag.part(hub, "nozzle", looks.finish),
        _mouth((-reach + 0.0056, 0.0040), 0.0034, looks.finish, 0.0040),
    ]


def _swan(reach: ag.Scalar, looks: PumpLooks) -> list[ag.Body]:
    top = HEAD["swan"]
    post: list[Run] = [
        [(0.0078, 0.0), (0.0084, 0.0010)],
        [(0.0084, 0.0010), (0.0072, 0.0060), (0.0068, top - 0.0090)],
        [(0.0100, top - 0.0090), (0.0108, top - 0.0070)],
        [(0.0108, top - 0.0070), (0.0096, top - 0.0025), (0.0050, top - 0.0003), (0.0030, top)],
    ]
    tube = _tube(
        [
            (-0.002, 0.0105),
            (-0.30 * reach, 0.0150),
            (-0.62 * reach, 0.0162),
            (-0.88 * reach, 0.0110),
            (-reach, 0.0030),
        ],
        0.0036,
    )
    hold = ag.grasp_on(tube, approach=-ag.Z, closing=ag.X, at=(0.0, -0.62 * reach, 0.0162), depth=0.005)
    block = ag.cylinder_between((0.0, 0.0, 0.010), (0.0, 0.0, top), 0.006)
    return [
        ag.part(tube, "nozzle", looks.finish, grasp=hold, push=ag.push_on(block, direction=-ag.Z)),
        turned(post[:2], "nozzle", looks.finish, sides=16),
        turned(post[2:], "cap", looks.finish, sides=16),
    ]


def _foamer(reach: ag.Scalar, looks: PumpLooks) -> list[ag.Body]:
    top, radius = HEAD["foamer"], 0.0178
    spout = _spout(
        [
            (0.0100, 0.0160, 0.0100, 0.0185),
            (0.6 * reach, 0.0130, 0.0090, 0.0185),
            (reach, 0.0110, 0.0070, 0.0165),
        ]
    )
    runs = _cap_runs(radius, 0.0, top)
    hold = ag.grasp_on(core(runs), approach=-ag.Z, closing=ag.X, depth=0.012)
    cap = turned(runs, "cap", looks.finish, grasp=hold)
    block = ag.cylinder_between((0.0, 0.0, 0.0), (0.0, 0.0, top), radius - 0.002)
    return [
        ag.part(spout, "nozzle", looks.finish, push=ag.push_on(block, direction=-ag.Z)),
        cap,
        _mouth((-reach + 0.0046, 0.0150), 0.0040, looks.finish, 0.004),
    ]


def pump_slide(
    name: str = "nozzle_slide",
    *,
    travel: ag.Scalar,
    force: ag.Scalar,
    damping: ag.Scalar,
    axis: tuple[float, float, float] = (0.0, 0.0, -1.0),
) -> ag.Joint:
    """Make the joint of the pressed part, against the spring of a pump."""
    preload = 0.35 * force  # the spring of a lotion pump starts at a third of its force
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=axis,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.5,  # friction of the piston's lips
        armature=0.03,  # inertia of the soap in the pump
        effort=40.0,
    )


def nozzle_turn(friction: ag.Scalar) -> ag.Joint:
    """Make the joint by which a nozzle turns on its stem, without limits."""
    return ag.Revolute(
        "nozzle_turn", axis=ag.Z, friction=friction, damping=0.001, armature=0.00001, effort=0.6
    )
