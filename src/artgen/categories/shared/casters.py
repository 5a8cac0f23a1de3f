"""Casters of furniture and of equipment."""

import artgen as ag
from artgen import feel
from artgen.categories.shared import fixings
from artgen.nodes.fitting import FIT, Fitting

_SUNK = 0.0003  # overlap of fixed parts with the face [m]


def caster(
    *,
    radius: ag.Scalar,
    width: ag.Scalar,
    finish: ag.Material,
    tread: ag.Material = ag.MATERIALS["rubber"],
    swivel: bool = True,
    name: str = "caster",
) -> Fitting:
    """Make a caster on the plane y = 0: a plate, a fork that swivels, and a wheel on its axle.

    It faces -y; links are `{name}_fork` and `{name}_wheel`, joints `{name}_swivel` and `{name}_roll`.

    Args:
        radius: Radius of the wheel [m]; the caster is 2 * radius + 0.0155 high.
        width: Width of the wheel [m].
        finish: Metal or plastic of plate and fork.
        tread: Material of the wheel.
        swivel: Whether the fork swivels; otherwise the wheel rolls along z.
        name: First part of the names of links and joints.
    """
    plate = ag.box(0.050, 0.0025, 0.050, bevel=0.0008).at(y=_SUNK - 0.00125)
    race = ag.cylinder(0.015, 0.0065, axis=ag.Y, bevel=0.0010).at(y=-0.0055)
    screws = [(x, _SUNK - 0.0025, z) for x in (-0.019, 0.019) for z in (-0.019, 0.019)]
    fixed = ag.weld(
        ag.part([plate, race], "caster", finish),
        *fixings.screws(screws, facing="-y", radius=0.0034, finish=finish, head="pan"),
    )
    trail = 0.6 * radius  # offset of the wheel, which makes it follow
    axle = (0.0, -(0.0155 + radius), -trail)
    crown = ag.cylinder(0.016, 0.0032, axis=ag.Y, bevel=0.0006).at(y=-0.0110)
    bridge = ag.box(width + 0.0082, 0.0026, 0.018, bevel=0.0006).at(y=-0.0110)
    cheek = ag.hull(
        ag.box(0.0025, 0.0028, 0.020).at(y=-0.0110),
        ag.cylinder(0.0065, 0.0025, axis=ag.X).at(0.0, axle[1], axle[2]),
    )
    aside = width / 2 + FIT.running + 0.00125
    cheeks = [cheek.at(side * aside) for side in (-1, 1)]
    bolt = ag.cylinder(0.0045, width + 0.0120, axis=ag.X, bevel=0.0010) - ag.box(width + 0.005, 0.02, 0.02)
    fork = ag.weld(
        ag.part([crown, bridge, *cheeks], "caster", finish, name=f"{name}_fork"),
        ag.detail(bolt.at(axle), "caster", finish),
    )
    wheel = ag.cylinder(radius, width, axis=ag.X, bevel=0.0035)
    hold = ag.grasp_on(wheel, approach=ag.Y, closing=ag.X, depth=0.4 * radius)
    rolling = ag.weld(
        ag.part(wheel, "wheel", tread, name=f"{name}_wheel", grasp=hold),
        ag.detail(ag.cylinder(0.55 * radius, width + 0.0006, axis=ag.X, bevel=0.0010), "wheel", finish),
    )
    roll = ag.Revolute(f"{name}_roll", axis=ag.X, feel=feel.CASTER)
    if not swivel:
        return Fitting(ag.weld(fixed, fork).attach(rolling, roll, at=axle))
    turn = ag.Revolute(f"{name}_swivel", axis=ag.Y, feel=feel.CASTER)
    return Fitting.moving(fork.attach(rolling, roll, at=axle), turn, fixed=fixed)
