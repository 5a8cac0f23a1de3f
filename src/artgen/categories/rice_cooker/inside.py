"""The inside of a cooker: the pot that lifts out, its well and the heater below it, and lids of glass."""

from typing import NamedTuple

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.finish import casting

FEET = 0.006
"""Height of the feet [m]."""

FLOOR = 0.034
"""Height of the heater above the table [m]."""

HAND = 0.0165
"""Room around the upper wall of a pot, for fingers [m]."""

UP = 0.016
"""Height of this room below the rim [m]."""

WALL = 0.0045
"""Thickness of a pot [m]."""

_PLAY = 0.0022  # gap between a pot and its well [m]
_SIDES = 8  # facets of a well with room for fingers, whose rim a collar covers
_ROUND = 14  # facets of another well
_RING = 14  # facets of the solid inside a pot
_LINING = ag.material("steel").with_(
    name="well", base_color=(0.32, 0.32, 0.33), specular_roughness=0.45, texture=""
)
_COATED = ag.colored("enamel", "anthracite").with_(name="pot_coated", density=3900.0)
_PLATE = ag.material("aluminium").with_(name="heater", specular_roughness=0.5)
_GLASS = ag.material("glass").with_(name="lid_glass", opacity=0.16, density=620.0)
_CARRIED = feel.Feel(friction=0.3, damping=3.0, effort=80.0)


class Look(NamedTuple):
    """Materials of a cooker, and its maker."""

    finish: ag.Material
    trim: ag.Material
    grip: ag.Material
    maker: str

    @property
    def ink(self) -> ag.Material:
        """Return the print on the finish."""
        return controls.ink_on(self.finish)

    @property
    def top(self) -> ag.Material:
        """Return the sheet on top of a lid: steel on plastic, black on steel."""
        return ag.material("black_glass" if self.finish.base_metalness > 0.5 else "stainless")

    def hollow(self, density: float) -> ag.Material:
        """Return the finish of a case with works and air in it [kg/m3]."""
        return filled(self.finish, density, "case")


def well(radius: ag.Scalar, rim: ag.Scalar, *, room: bool = True) -> ag.Solid:
    """Make the cutter of the well of a round pot with its rim at a height, perhaps with room for fingers."""
    deep = rim - FLOOR + 0.0006
    sides = _SIDES if room else _ROUND
    hole = ag.extrude(vessels.around(radius + _PLAY, sides), deep + 0.05).at(z=FLOOR + (deep + 0.05) / 2)
    if room:
        upper = ag.extrude(vessels.around(radius + HAND, _SIDES), UP + 0.05)
        hole |= upper.at(z=rim - UP + (UP + 0.05) / 2)
    return hole.paint(_LINING)


def collar(radius: ag.Scalar) -> ag.Solid:
    """Make the thin sheet around the room for fingers on z = 0, round inside, which hides its facets."""
    inner = radius + HAND
    sheet = vessels.around(inner + 0.0006, _SIDES) - ag.circle(inner - 0.0002)
    return ag.extrude(sheet, 0.0008).at(z=0.0001)


def heater(radius: ag.Scalar) -> ag.Body:
    """Make the plate below a pot, with its sprung sensor, which is only seen."""
    plate = ag.cylinder(0.86 * radius, 0.003, bevel=0.001).at(z=FLOOR - 0.0014)
    sensor = ag.cylinder(0.016, 0.0008, bevel=0.0003).at(z=FLOOR + 0.0001)
    return ag.weld(ag.detail(plate, "heater", _PLATE), ag.detail(sensor, "heater", ag.material("chrome")))


def inner_pot(radius: ag.Scalar, tall: ag.Scalar, *, when: ag.Condition | None = None) -> ag.Body:
    """Make a coated pot about the z axis, its floor at z = 0, with the levels of cups inside.

    With a condition, a hand reaches it only while that holds.
    """
    path = ag.polyline([(0.002, 0, 0), (0.94 * radius, 0, 0), (radius, 0, tall)], fillet=0.010)
    skin = ag.revolve(ag.half_section(path, wall=WALL))
    ring = vessels.ring_wall(0.94 * radius, radius, tall, WALL, _RING)
    floor = ag.frustum(0.94 * radius - 0.009, 0.94 * radius - 0.0016, 0.0034).at(z=0.0019)
    brim = ag.tube(radius + 0.0014, radius - WALL - 0.0004, 0.003, bevel=0.0012).at(z=tall - 0.0015)
    edge = ag.Region((radius - WALL, radius + 0.0006), (-0.014, 0.014), (tall - 0.020, tall - 0.0004)).box()
    holds = [
        ag.grasp_on(each, approach=-ag.Z, closing=ag.X, depth=0.011) for each in (edge, edge.mirror(ag.X))
    ]
    marks = [
        ag.rectangle(0.012 if step % 2 else 0.007, 0.0006).at(0, 0.008 * (step - 2)) for step in range(5)
    ]
    scale = marks[0] | marks[1] | marks[2] | marks[3] | marks[4]
    back = (0, 0.9604 * radius - WALL + 0.0001, 0.34 * tall)
    inward = ag.vector(0, -tall, 0.06 * radius).normalized()
    return ag.weld(
        ag.part(ring, "pot", _COATED, name="pot", grasp=holds, when=when),
        ag.part([floor, edge, edge.mirror(ag.X)], "pot", _COATED),
        ag.detail([skin, brim], "pot", _COATED),
        details.printed(scale, back, material=controls.LIGHT_INK, facing=inward),
    )


def lifts_out(height: ag.Scalar, needs: ag.Dependency | None = None) -> ag.Joint:
    """Make the joint of a pot that lifts out of its well."""
    return ag.Prismatic("pot_lift", axis=ag.Z, limits=(0, height), feel=_CARRIED, needs=needs)


def glass_lid(radius: ag.Scalar, rise: ag.Scalar, grip: ag.Material, *, share: float = 1.0) -> ag.Body:
    """Make a lid of glass over a rim at z = 0, with its knob, a ring of steel and a vent.

    An oval lid is less deep than wide by a share.
    """
    steel = ag.material("stainless")
    disc = ag.extrude(vessels.around(radius, 24), 0.0034).at(z=0.0017).scale(1, share, 1)
    dome = ag.dome(radius - 0.008, height=rise).at(z=0.0032).scale(1, share, 1)
    top = rise + 0.0026
    stem = ag.cylinder(0.0085, 0.012).at(z=top + 0.004)
    cap = ag.frustum(0.0150, 0.0200, 0.018, bevel=0.004).at(z=top + 0.019)
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.X, depth=0.013)
    ring = ag.tube(radius + 0.0005, radius - 0.008, 0.0042, bevel=0.0014).at(z=0.0020).scale(1, share, 1)
    washer = ag.cylinder(0.013, 0.002, bevel=0.0006).at(z=top)
    vent = ag.tube(0.0042, 0.0020, 0.003, bevel=0.0008).at(0.5 * radius, 0, 0.845 * rise + 0.0030)
    return ag.weld(
        ag.part([cap, stem], "knob", casting(grip, 0.8), name="lid", grasp=hold),
        ag.part([disc, ag.simplified_collider(dome, 0.001)], "lid", _GLASS),
        ag.detail([ring, washer, vent], "lid", steel),
    )


def side_handles(x: ag.Scalar, z: ag.Scalar, size: tuple[float, float, float], grip: ag.Material) -> ag.Body:
    """Make a handle at each side of a case, its middle at a place [m]."""
    bar = ag.box(*size, bevel=0.006).at(x, 0, z)
    hold = ag.grasp_on(bar, approach=-ag.X, closing=ag.Z, depth=0.012)
    right, left = (
        ag.part(bar, "handle", casting(grip, 0.6), name=f"handle_{side}", grasp=hold)
        for side in ("right", "left")
    )
    return ag.weld(right, left.mirror(ag.X))


def lid_lift() -> ag.Joint:
    """Make the joint of a loose lid, which lifts far enough for a hand below it."""
    return ag.Prismatic("lid_lift", axis=ag.Z, limits=(0, 0.25), effort=80.0, friction=0.1, damping=2.0)
