"""The pop-up drain of a basin: a rod behind the spout lowers a plug, through a strap and a pivot rod.

Parts are modeled about the middle of the drain, with the upper face of the slab on z = 0. The pivot rod turns
about a ball in the rear of the drain pipe. Its outer end is in the strap under the lift rod and rises with
it; its inner end is in the eye of the plug and moves down in proportion to the lengths of the arms.
"""

import artgen as ag
from artgen import feel
from artgen.categories.shared.finish import casting

FLANGE = 0.032
"""Radius of the flange in the slab [m]."""

HOLE = 0.0395
"""Width of the square hole under the flange [m]."""

HANGS = 0.165
"""Length of the pipe below the top of the slab [m]."""

_TRAVEL = 0.028  # travel of the lift rod [m]
_PIPE = (0.0162, 0.0186)  # inner and outer radius of the 1 1/4 inch tailpiece [m]
_PLUG = 0.0205  # radius of the cap of the plug [m]
_SHUT = 0.0012  # gap between the shut cap and the seat [m]
_BALL = 0.022  # inner arm of the pivot rod: distance from the middle of the pipe to the ball [m]
_ARM = 0.095  # outer arm: distance from the ball to the strap [m]
_DOWN = 0.120  # depth of the ball below the top of the slab [m]
_ROD = 0.0030  # radius of the lift rod [m]
_PIVOT = 0.0020  # radius of the pivot rod [m]
_GUIDE = 0.012  # height of the collar that the lift rod passes [m]
_STANDS = 0.038  # height of the knob above the collar [m]
_PLAY = 0.0005  # gap around the lift rod [m]
_TILT = 0.5 * _TRAVEL / _ARM  # tilt of the pivot rod at each end of its range [rad]


def install(
    body: ag.Body,
    at: ag.Vector,
    rod: ag.Scalar,
    thick: ag.Scalar,
    finish: ag.Material,
    friction: ag.Scalar,
    *,
    above: ag.Scalar = 0.0,
) -> ag.Body:
    """Install a drain with its plug and rods in a slab.

    The lift rod is at y = `rod` from the middle of the drain, and its collar at the height `above` over it;
    `friction` is that of the ball and the collar, measured at the lift rod [N].
    """
    metal = casting(finish, 0.9)
    pull = feel.Feel(damping=3.0, friction=friction, armature=0.02, effort=30.0)
    lift = ag.Prismatic("lift_rod_slide", axis=ag.Z, limits=(0.0, _TRAVEL), feel=pull)
    turn = ag.Revolute("pivot_rod_turn", axis=ag.X, follows=(1 / _ARM) * lift, damping=0.002, armature=5e-5)
    fall = ag.Prismatic("plug_slide", axis=-ag.Z, follows=(_BALL / _ARM) * lift, damping=1.0, armature=0.01)
    body = ag.weld(
        body,
        _guide(finish, metal).at(at + ag.vector(0.0, rod, above)),
        _pipe(finish, metal, thick, pivot=True).at(at),
    )
    body = body.attach(_lift_rod(metal, rod, thick, above).at(at), lift)
    body = body.attach(_pivot_rod(), turn, at=at + ag.vector(0.0, _BALL, -_DOWN))
    return body.attach(_plug(finish, metal).at(at), fall)


def stopped(body: ag.Body, at: ag.Vector, thick: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Install a drain with a stopper, which lifts off by its knob, in a slab."""
    metal = casting(finish, 0.9)
    body = ag.weld(body, _pipe(finish, metal, thick, pivot=False).at(at))
    low = _SHUT + 0.0008
    knob = ag.cylinder(0.0075, 0.012, bevel=0.003).at(z=low + 0.019)
    neck = ag.cylinder_between((0.0, 0.0, low + 0.002), (0.0, 0.0, low + 0.014), 0.0032)
    under = ag.cylinder_between((0.0, 0.0, -0.010), (0.0, 0.0, low + 0.001), 0.0105)
    cap = ag.cylinder(_PLUG, 0.0034, bevel=0.001).at(z=low + 0.0017)
    hold = ag.grasp_on(knob, approach=-ag.Z, closing=ag.X, depth=0.010)
    plug = ag.weld(
        ag.part(ag.union(knob, neck, cap), "plug", finish, grasp=hold),
        ag.part(under, "plug", ag.material("rubber")),
    )
    return body.attach(plug, lifted("plug_lift"), at=at)


def lifted(name: str) -> ag.Joint:
    """Make the joint of a plug or a basket that a hand lifts off."""
    return ag.Prismatic(name, axis=ag.Z, limits=(0.0, 0.12), friction=0.2, damping=2.0, effort=20.0)


def _frame(width: ag.Scalar, hole: ag.Scalar, height: ag.Scalar) -> ag.Solid:
    """Make a square tube, which collides as four boards, within a round one."""
    return ag.box(width, width, height) - ag.box(hole, hole, height + 0.02)


def _guide(finish: ag.Material, metal: ag.Material) -> ag.Body:
    """Make the collar behind the spout."""
    hole, outer = _ROD + _PLAY, 0.0082
    ring = _frame(1.38 * outer, 2 * hole, _GUIDE).at(z=_GUIDE / 2)
    skin = ag.tube(outer, hole / 0.966, _GUIDE + 0.0004, bevel=0.0008).at(z=_GUIDE / 2)
    return ag.weld(ag.part(ring, "guide", metal), ag.detail(skin, "guide", finish))


def _pipe(finish: ag.Material, metal: ag.Material, thick: ag.Scalar, *, pivot: bool) -> ag.Body:
    """Make the flange with its seat, the pipe, and the opening for a pivot rod with its nut."""
    inner, outer = _PIPE
    rim = [(inner, -0.0004), (FLANGE, -0.0004), (FLANGE - 0.0006, 0.0014), (0.0262, 0.0030),
           (0.0232, 0.0026), (0.0222, 0.0008), (inner, 0.0004)]  # fmt: skip
    flange, flat = ag.revolve(ag.polygon(rim)), _frame(0.0430, 0.0240, 0.0007)
    pipe = _frame(0.0260, 0.0236, HANGS).at(z=-HANGS / 2)
    skin = ag.tube(outer, inner - 0.0006, HANGS).at(z=-HANGS / 2)
    collar = ag.tube(outer + 0.0055, outer - 0.0004, 0.012, bevel=0.001).at(z=-thick - 0.008)
    nut = ag.detail(collar, "drain", ag.material("black_abs"))
    if not pivot:
        return ag.weld(ag.part([flat, pipe], "drain", metal), ag.detail([flange, skin], "drain", finish), nut)
    ball = ag.Region((0.0, 0.0), (0.010, 0.030), (-_DOWN, -_DOWN))
    window = ball.grow(x=0.0055, z=0.0055).box()
    near, far = outer - 0.0004, ball.y.high
    frame = ball.shrink(front=0.0025, x=-0.0080, z=-0.0080).box()
    frame = frame - ball.grow(x=0.0052, z=0.0052, back=0.01).box()
    neck = ag.tube(0.0118, 0.0055, far - near + 0.0004, axis=ag.Y, bevel=0.001)
    neck = neck.at(0.0, (near + far) / 2, -_DOWN)
    return ag.weld(
        ag.part([flat, pipe - window, frame], "drain", metal),
        ag.detail([flange, skin - window, neck], "drain", finish),
        nut,
    )


def _plug(finish: ag.Material, metal: ag.Material) -> ag.Body:
    """Make the open plug: its cap, and a stem with an eye for the pivot rod."""
    rise = _TRAVEL * _BALL / _ARM
    low, eye = _SHUT + 0.0008 + rise, rise / 2 - _DOWN
    core = ag.extrude(ag.regular_polygon(16, _PLUG - 0.0004), 0.0026).at(z=low + 0.0015)
    rim = ag.cylinder(_PLUG, 0.0030, bevel=0.0009).at(z=low + 0.0015)
    cap = ag.dome(_PLUG - 0.0012, height=0.0022).at(z=low + 0.0026)
    stem = ag.cylinder_between((0.0, 0.0, eye + 0.0048), (0.0, 0.0, low + 0.0010), 0.0040)
    sides = [ag.box(0.0016, 0.0050, 0.0128).at(x, 0.0, eye) for x in (-0.0040, 0.0040)]
    bars = [ag.box(0.0084, 0.0048, 0.0030).at(0.0, 0.0, eye + z) for z in (-0.0048, 0.0048)]
    seal = ag.tube(_PLUG - 0.0030, _PLUG - 0.0055, 0.0012).at(z=low - 0.0004)
    return ag.weld(
        ag.part([core, ag.union(stem, *sides, *bars)], "plug", metal),
        ag.detail(rim | cap, "plug", finish),
        ag.detail(seal, "plug", ag.material("rubber")),
    )


def _pivot_rod() -> ag.Body:
    """Make the rod through the ball at the origin, with its outer end down: the plug is open."""
    rod = ag.cylinder_between((0.0, -_BALL - 0.006, 0.0), (0.0, _ARM + 0.014, 0.0), _PIVOT)
    body = ag.part(rod.rotate(ag.X, -_TILT), "pivot_rod", ag.material("stainless"))
    return ag.weld(body, ag.detail(ag.sphere(0.0046), "pivot_rod", ag.material("abs")))


def _lift_rod(metal: ag.Material, at: ag.Scalar, thick: ag.Scalar, above: ag.Scalar) -> ag.Body:
    """Make the rod with its knob, and the bent strap that a thumbscrew clamps to its lower end."""
    high = above + _GUIDE + _STANDS
    under = -thick - _TRAVEL - 0.006  # height of the upper end of the strap
    rod = ag.cylinder_between((0.0, at, under - 0.020), (0.0, at, high), _ROD)
    knob: ag.Solid = ag.sphere(0.0068).at(0.0, at, high)
    hold = ag.grasp_on(knob, approach=-ag.Y, closing=ag.X)
    hole, eye, thin = _BALL + _ARM, -_DOWN - _TRAVEL / 2, 0.0008
    upper = ag.Region((-0.0050, 0.0050), (at - 0.0044, at - 0.0044 + 2 * thin), (under - 0.022, under))
    lower = upper.with_(y=(hole - thin, hole + thin), z=(eye - 0.012, eye + 0.010))
    slot = ag.Region((-0.0032, 0.0032), (hole - 0.01, hole + 0.01), (eye - 0.0032, eye + 0.0032))
    start, end = upper.with_(z=(under - 0.0218, under - 0.0205)), lower.with_(z=(eye + 0.0085, eye + 0.0098))
    strap = [upper.box(), ag.hull(start.box(), end.box()), lower.box() - slot.box()]
    screw = ag.cylinder_between((0.0, at - 0.013, under - 0.012), (0.0, at + 0.006, under - 0.012), 0.0045)
    return ag.weld(
        ag.part(rod | knob, "lift_rod", metal, grasp=hold),
        ag.part([*strap, screw], "strap", ag.material("stainless")),
    )
