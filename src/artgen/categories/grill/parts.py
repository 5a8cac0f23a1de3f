"""Parts that grills share: bowls, grates, handles, wheels, and lids on a hinge that friction holds."""

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls
from artgen.categories.shared.finish import casting

_SIDES = 14  # facets of a bowl
_IRON = ag.material("cast_iron").with_(name="grate_iron", specular_roughness=0.6)
_RUBBER = ag.material("rubber").with_(name="grill_tyre", density=500.0)
_GRATE = feel.Feel(friction=0.4, damping=3.0, effort=60.0)


class Look(NamedTuple):
    """Materials of a grill, and its maker."""

    finish: ag.Material
    metal: ag.Material
    grip: ag.Material
    maker: str

    @property
    def ink(self) -> ag.Material:
        """Return the print on the finish."""
        return controls.ink_on(self.finish)

    def thin(self, density: float, what: str) -> ag.Material:
        """Return the finish of a part that is hollow or thin [kg/m3]."""
        return self.finish.with_(name=f"{self.finish.name}_{what}", density=density)


def bowl(
    radius: ag.Scalar,
    rim: ag.Scalar,
    steps: Sequence[tuple[float, float]],
    wall: float,
    density: float,
    look: Look,
) -> ag.Body:
    """Make the link `body` of an open bowl with a floor about the z axis.

    Args:
        radius: Radius of its rim [m].
        rim: Height of its rim [m].
        steps: Radii and heights from the floor to the rim, both over the radius, from the height of the rim.
        wall: Thickness [m].
        density: Density of the faceted solid [kg/m3].
        look: Materials of the grill.
    """
    outline, pieces = ag.regular_polygon(_SIDES, 1.0), []
    for (low, below), (high, above) in itertools.pairwise(steps):
        ends = [rim + below * radius - 0.0012, rim + above * radius]  # rings share no corners
        out = [outline.scale(share * radius) for share in (low, high)]
        inside = [outline.scale(share * radius - wall) for share in (low, high)]
        pieces.append(ag.loft(out, ends) - ag.loft(inside, ends))
    low, below = steps[0]
    base = ag.extrude(outline.scale(low * radius - 0.0015), wall).at(z=rim + below * radius + wall / 2)
    side = ag.spline([(share * radius, 0.0, rim + level * radius) for share, level in steps])
    skin = ag.revolve(ag.half_section(side, wall=0.4 * wall))
    solid = ag.part([base, *pieces], "body", look.thin(density, "bowl"), name="body")
    return ag.weld(solid, ag.detail(skin, "bowl", look.finish))


def round_grate(radius: ag.Scalar) -> ag.Body:
    """Make a round grate about z = 0, with a bow for a hand at each side."""
    sides, thick, wide = 12, 0.006, 0.008
    out = math.cos(math.pi / sides) * radius
    edge = ag.box(wide, 2 * math.tan(math.pi / sides) * radius, thick).at(out - wide / 2, 0, 0)
    ring = [edge.rotate(ag.Z, math.tau * (number + 0.5) / sides) for number in range(sides)]
    bars = []
    for number in range(9):
        x = (number - 4) / 5
        length = 2 * (math.sqrt(1 - x * x) - 0.02) * out
        bars.append(ag.box(0.006, length, 0.0056).at(x * out, 0, 0))
    cross = ag.box(2 * out - 0.008, 0.007, 0.0050)
    return _with_bows([*ring, *bars, cross], out * 3 / 5)


def square_grate(wide: ag.Scalar, deep: ag.Scalar) -> ag.Body:
    """Make a grate of cast bars about z = 0, with a bow for a hand at each side."""
    count, thick = 15, 0.007
    pitch = (wide - 0.009) / (count - 1)
    bars = [ag.box(0.009, deep, thick).at((n - count // 2) * pitch, 0, 0) for n in range(count)]
    ends = [ag.box(wide, 0.009, thick - 0.0004).at(0, side * (deep / 2 - 0.0045), 0) for side in (-1, 1)]
    return _with_bows([*bars, *ends], 5 * pitch)


def _with_bows(bars: list[ag.Solid], x: ag.Scalar) -> ag.Body:
    """Make the link of a grate with its two bows, which stand on bars."""
    line = [(0, -0.036, 0), (0, -0.036, 0.030), (0, 0.036, 0.030), (0, 0.036, 0)]
    bow = ag.sweep(ag.regular_polygon(6, 0.0048).rotate(math.pi / 6), ag.polyline(line)).at(x, 0, 0)
    hold = ag.grasp_on(bow, approach=-ag.Z, closing=ag.X, depth=0.012)
    steel = ag.material("stainless")
    right, left = (ag.part(bow, "handle", steel, name=name, grasp=hold) for name in ("grate", "grate_left"))
    return ag.weld(right, left.mirror(ag.X), ag.part(bars, "grate", _IRON))


def lifts_out(hinge: ag.Joint, opens: float, drop: float) -> ag.Joint:
    """Make the joint of a grate below a lid that opens, its height below the rim given [m]."""
    free = (hinge > opens - 0.06).beyond(drop - 0.0352)  # up to there its bows are below the lid
    return ag.Prismatic("grate_lift", axis=ag.Z, limits=(0, 0.22), feel=_GRATE, needs=free)


def bar_on_posts(
    length: ag.Scalar, reach: float, look: Look, radius: float = 0.0125
) -> tuple[ag.Solid, ag.Solid]:
    """Make a bar along x before the plane y = 0, and its posts."""
    bar = ag.cylinder(radius, length, axis=ag.X, bevel=0.003).at(0, -reach, 0)
    post = ag.cylinder(0.007, reach + 0.004, axis=ag.Y).at(0.38 * length, 0.002 - reach / 2, 0)
    return bar, ag.union(post, post.mirror(ag.X))


def held_lid(
    lid: ag.Body, axle: ag.VectorLike, deep: ag.Scalar, opens: float, *, share: float = 0.0
) -> ag.Joint:
    """Make the hinge at the back of a lid: a spring carries a share of it, friction holds the rest."""
    moment = lid.weight() * deep / 2
    stiffness = share * moment / opens
    drag = (1.25 - share) * moment + 0.2
    return ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=axle, limits=(0, opens), friction=drag, damping=0.5, armature=0.01,
        effort=90.0, stiffness=stiffness, rest=opens,
    )  # fmt: skip


def wheel(radius: float, width: float, metal: ag.Material) -> ag.Body:
    """Make a wheel about the x axis, on the right of a grill."""
    tyre = ag.cylinder(radius, width, axis=ag.X, bevel=0.008)
    cap = ag.cylinder(0.42 * radius, width + 0.006, axis=ag.X, bevel=0.003)
    ring = ag.tube(0.78 * radius, 0.66 * radius, width + 0.003, axis=ag.X, bevel=0.001)
    return ag.weld(ag.part(tyre, "wheel", _RUBBER, name="wheel"), ag.detail([cap, ring], "wheel", metal))


def rolls(at: ag.VectorLike) -> ag.Joint:
    """Make the axle of a wheel."""
    return ag.Revolute("wheel_roll", axis=ag.X, pivot=at, feel=feel.CASTER, driven="the floor")


def thermometer(at: ag.VectorLike, facing: ag.VectorLike, metal: ag.Material) -> list[ag.Body]:
    """Make a thermometer on a face, which is only seen."""
    white = ag.material("abs").with_(name="dial_face", base_color=(0.80, 0.79, 0.75), texture="")
    scale = details.dial_scale(0.016, 9, major_every=2, length=0.003, major_length=0.005, width=0.0008)
    hand = details.pointer(-0.004, 0.015, 0.0016).rotate(1.9)
    return [
        details.printed(ag.circle(0.028), at, material=metal, facing=facing, label="gauge", proud=0.003),
        details.printed(ag.circle(0.024), at, material=white, facing=facing, label="gauge", proud=0.0034),
        details.printed(scale, at, material=controls.DARK_INK, facing=facing, proud=0.0037),
        details.printed(
            hand, at, material=ag.material("led_red"), facing=facing, label="gauge", proud=0.0039
        ),
    ]


def side_handles(reach: ag.Scalar, z: ag.Scalar, look: Look) -> ag.Body:
    """Make a handle on two posts at each side."""
    bar = ag.cylinder(0.0125, 0.130, axis=ag.Y, bevel=0.003).at(reach + 0.042, 0, z)
    post = ag.cylinder(0.006, 0.052, axis=ag.X).at(reach + 0.018, 0.044, z)
    hold = ag.grasp_on(bar, approach=-ag.X, closing=ag.Z, depth=0.014)
    right, left = (
        ag.weld(
            ag.part(bar, "handle", casting(look.grip, 0.8), name=f"handle_{side}", grasp=hold),
            ag.part([post, post.mirror(ag.Y)], "handle", look.metal),
        )
        for side in ("right", "left")
    )
    return ag.weld(right, left.mirror(ag.X))
