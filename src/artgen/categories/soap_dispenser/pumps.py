"""Pumps of soap dispensers: the collar on a bottle, and the nozzle that is pressed down and turned.

A pump is about the z axis. The undersides of its collar and of its nozzle are at z = 0; the nozzle
points to the front.
"""

from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import vessels
from artgen.categories.soap_dispenser.bottles import fluted
from artgen.categories.soap_dispenser.finish import ink_on

# a molded saddle; a beak under a cap; a bent tube; a square bar; a thin tube from a post with a cap; the wide
# cap of a foam pump with its short beak
Nozzle = Literal["saddle", "beak", "gooseneck", "bar", "swan", "foamer"]

COLLAR = 0.0245  # height of a collar with its sleeve [m]
GAP = 0.0012  # gap between a nozzle that is pressed home and the sleeve [m]
_STEM = 0.0038  # radius of the stem [m]
_PLAY = 0.0004  # gap around the stem [m]
_ENGAGED = 0.0042  # depth of the stem in the sleeve while the nozzle is up [m]

# sections of a molded spout: distance from the axis, as a length [m] and a share of the reach; width, height,
# height of the middle [m]
_SPOUTS = {
    "saddle": ((-0.0130, 0, 0.0120, 0.0060, 0.0078), (-0.0085, 0, 0.0190, 0.0076, 0.0070),
               (0.0085, 0, 0.0200, 0.0086, 0.0060), (0, 0.45, 0.0130, 0.0080, 0.0066),
               (0, 0.75, 0.0085, 0.0068, 0.0060), (0, 1, 0.0070, 0.0056, 0.0036)),
    "beak": ((0.0040, 0, 0.0100, 0.0080, 0.0066), (0, 0.55, 0.0088, 0.0072, 0.0068),
             (0, 0.86, 0.0074, 0.0064, 0.0062), (0, 1, 0.0066, 0.0050, 0.0048)),
    "foamer": ((0.0100, 0, 0.0160, 0.0100, 0.0185), (0, 0.6, 0.0130, 0.0090, 0.0185),
               (0, 1, 0.0110, 0.0070, 0.0165)),
}  # fmt: skip
# radius of a bent tube [m]; points on its middle: distance from the axis as above, height [m]
_TUBES = {
    "gooseneck": (0.0042, ((0, 0, 0.003), (0, 0, 0.014), (0.0075, 0, 0.0248), (0, 0.42, 0.0298),
                           (0, 0.78, 0.0238), (0, 1, 0.0098))),
    "swan": (0.0036, ((0.002, 0, 0.0105), (0, 0.30, 0.0150), (0, 0.62, 0.0162), (0, 0.88, 0.0110),
                      (0, 1, 0.0030))),
}  # fmt: skip
_TOPS = {"beak": 0.0140, "foamer": 0.0250, "swan": 0.0290}  # height of a cap, which a finger presses [m]


def _cap(radius: float, high: float) -> list[vessels.Run]:
    """Return the outline of a round cap with soft edges and a slightly domed top."""
    return [
        [(radius - 0.0006, 0), (radius, 0.0008)],
        [(radius, 0.0008), (radius, high - 0.0024)],
        [(radius, high - 0.0024), (radius - 0.0008, high - 0.0008), (0.72 * radius, high)],
    ]


_SOCKET: list[vessels.Run] = [
    [(0.0086, 0), (0.0090, 0.0008)],
    [(0.0090, 0.0008), (0.0090, 0.0070)],
    [(0.0090, 0.0070), (0.0076, 0.0098), (0.0050, 0.0110)],
]
_POST: list[vessels.Run] = [
    [(0.0078, 0), (0.0084, 0.0010)],
    [(0.0084, 0.0010), (0.0072, 0.0060), (0.0068, 0.0200)],
]
_KNOB: list[vessels.Run] = [
    [(0.0100, 0.0200), (0.0108, 0.0220)],
    [(0.0108, 0.0220), (0.0096, 0.0265), (0.0050, 0.0287), (0.0030, 0.0290)],
]
_TURNED = {
    "beak": (("cap", _cap(0.0125, _TOPS["beak"])),),
    "foamer": (("cap", _cap(0.0178, _TOPS["foamer"])),),
    "gooseneck": (("nozzle", _SOCKET),),
    "swan": (("nozzle", _POST), ("cap", _KNOB)),
}
_HUBS = {"saddle": (0.006, 0.0088, 0.0008), "bar": (0.004, 0.0080, 0.0006)}  # height, radius, bevel [m]
# short pipe below the end of a spout: distance of its axis from the end, height, radius, length [m]
_MOUTHS = {
    "saddle": (0.0032, 0.0016, 0.0027, 0.003),
    "beak": (0.0030, 0.0030, 0.0025, 0.003),
    "bar": (0.0056, 0.0040, 0.0034, 0.004),
    "foamer": (0.0046, 0.0150, 0.0040, 0.004),
}
# point between the fingers: distance from the axis as above, height [m]; reach of the finger tips [m]
_HOLDS = {
    "saddle": (0.001, 0, 0.005, 0.006),
    "beak": (0, 0.72, 0.0066, 0.006),
    "gooseneck": (0, 0.42, 0.0298, 0.006),
    "bar": (0, 0.6, 0.007, 0.008),
    "swan": (0, 0.62, 0.0162, 0.005),
    "foamer": (0, 0, 0.0125, 0.012),
}


def collar(kind: Nozzle, finish: ag.Material) -> ag.Body:
    """Make the collar on a neck, with the sleeve in which the stem slides."""
    radius, neck = (0.0200, 0.0150) if kind == "foamer" else (0.0165, 0.0105)  # others have 28 mm threads
    runs: list[vessels.Run] = [
        [(radius - 0.0005, 0), (radius, 0.0008)],
        [(radius, 0.0008), (radius, 0.0160)],
        [(radius, 0.0160), (radius - 0.0006, 0.0178), (radius - 0.0022, 0.0186)],
        [(neck, 0.0186), (neck - 0.0006, COLLAR - 0.0008)],
        [(neck - 0.0006, COLLAR - 0.0008), (neck - 0.0014, COLLAR)],
    ]
    bore = _STEM + _PLAY
    hole = ag.Region.centered(2 * bore, 2 * bore, COLLAR + 0.002).at(z=COLLAR / 2).box()
    body = vessels.turned(runs, "collar", finish, hole=hole, bore=bore)
    if finish.base_metalness > 0.5:
        return body
    ribs = fluted(36, 4, 0.036).scale(radius + 0.0007) - ag.circle(radius - 0.0015)
    return ag.weld(body, ag.detail(ag.extrude(ribs, 0.0140, bevel=0.0003).at(z=0.0085), "collar", finish))


def nozzle(kind: Nozzle, finish: ag.Material, reach: ag.Scalar, travel: ag.Scalar) -> ag.Body:
    """Make a nozzle with its stem: the link `nozzle`."""
    arm = _arm(kind, reach)
    turned = _TURNED.get(kind, ())
    far, share, z, depth = _HOLDS[kind]
    at = (0, -far - share * reach, z)
    held = vessels.core(turned[0][1]) if kind == "foamer" else arm
    hold = ag.grasp_on(held, approach=-ag.Z, closing=ag.X, at=at, depth=depth)
    if kind in _TOPS:
        push = ag.frame((0, 0, _TOPS[kind]), approach=-ag.Z, closing=ag.X)
    else:
        push = ag.push_on(arm, direction=-ag.Z, at=at if kind == "gooseneck" else (0, 0, z))
    bodies = [ag.part(arm, "nozzle", finish, grasp=() if kind == "foamer" else hold, push=push)]
    for label, runs in turned:
        sides = vessels.SIDES if kind in _SPOUTS else 16
        grasp = hold if kind == "foamer" else ()
        bodies.append(vessels.turned(runs, label, finish, sides=sides, grasp=grasp))
    if kind in _HUBS:
        high, radius, bevel = _HUBS[kind]
        hub = ag.cylinder_between((0, 0, 0), (0, 0, high), radius, bevel=bevel)
        bodies.append(ag.part(hub, "nozzle", finish))
    if kind in _MOUTHS:
        before, top, radius, long = _MOUTHS[kind]
        y = before - reach
        pipe = ag.cylinder_between((0, y, top - long), (0, y, top), radius, bevel=0.0004)
        bodies.append(ag.part(pipe, "nozzle", finish))
    if kind == "gooseneck":
        lip = ag.extrude(ag.ring(0.0050, 0.0030), 0.003, axis=(0, -0.35, -1)).at(0, -reach, 0.0098)
        bodies.append(ag.detail(lip, "nozzle", finish))
    is_metal = finish.base_metalness > 0.5
    if kind == "saddle" and not is_metal:  # direction of locking
        arrow = details.icon("repeat", 0.0065)
        bodies.append(details.printed(arrow, (0, 0, 0.0104), material=ink_on(finish), facing=ag.Z))
    stem = ag.cylinder_between((0, 0, -(travel + GAP + _ENGAGED)), (0, 0, 0.004), _STEM)
    return ag.weld(*bodies, ag.part(stem, "stem", ag.material("chrome" if is_metal else "polypropylene")))


def _arm(kind: Nozzle, reach: ag.Scalar) -> ag.Solid:
    """Make the spout, tube or bar of a nozzle."""
    if kind == "bar":
        return ag.Region((-0.0056, 0.0056), (-reach, 0.0085), (0.0025, 0.0125)).box(bevel=0.0012)
    if kind in _TUBES:
        radius, points = _TUBES[kind]
        middle = ag.spline([(0, -far - share * reach, z) for far, share, z in points])
        return ag.sweep(ag.circle(radius), middle)
    sections = _SPOUTS[kind]
    plans = [ag.rectangle(x, z, radius=0.42 * min(x, z)).at(0, mid) for *_, x, z, mid in sections]
    return ag.loft(plans, [far + share * reach for far, share, *_ in sections], axis=(0, -1, 0))


def slide(
    name: str, axis: ag.VectorLike, travel: ag.Scalar, force: ag.Scalar, damping: ag.Scalar
) -> ag.Joint:
    """Make the joint of the pressed part, against the spring of a pump."""
    spring = ag.Spring(preload=0.35 * force, force=force)  # that of a lotion pump starts at a third
    # friction of the piston's lips, and inertia of the soap in the pump
    drag = feel.Feel(damping=damping, friction=0.5, armature=0.03, effort=40.0)
    return ag.Prismatic(name, axis=axis, limits=(0.0, travel), spring=spring, feel=drag)
