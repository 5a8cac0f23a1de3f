"""What shower enclosures share: profiles, rails, panes with their seals and handles, trays, long hinges."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import casting, recess

Handle = Literal["knob", "bar", "towel"]
"""A knob, an upright bar, or a bar for a towel."""

Etched = Literal["none", "band", "stripes"]
"""A frosted part of a pane: none, a band at the height of a body, or stripes."""

GAP = 0.006
"""Distance between moving panels and what is around them [m]."""

RIM = 0.060
"""Distance from the front of a tray to the middle of the glass [m]."""

PROFILE = 0.026
"""Width of a profile at a wall [m]."""

HEAD, SILL = 0.040, 0.020
"""Heights of rails above and below doors [m]."""

DIAGONAL = (1.0, -1.0, 0.0)
"""Normal of the plane between the front and the left side of a corner."""

SEAL = ag.material("polycarbonate").with_(name="seal_strip", base_color=(0.78, 0.80, 0.81), density=1150.0)
"""Clear plastic of strips at the edges of panes."""

_FROST = ag.material("frosted_glass").with_(
    name="etching", base_color=(0.86, 0.88, 0.88), texture="", opacity=0.72
)


@dataclass(frozen=True)
class Plan:
    """Measures and materials of an enclosure; its front is the plane y = 0, from the sill to the top."""

    wide: ag.Scalar  # of the front [m]
    low: ag.Scalar  # height of the rim of the tray [m]
    top: ag.Scalar  # height of the glass [m]
    thick: float  # of the glass [m]
    glass: ag.Material
    etched: Etched
    metal: ag.Material
    handle: Handle

    @property
    def profile(self) -> ag.Material:
        """Material of hollow profiles."""
        return casting(self.metal, 700.0 / self.metal.density)

    @property
    def panel(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Heights of a door between the rails [m]."""
        return self.low + SILL + GAP, self.top - HEAD - GAP

    def bar(
        self, x: tuple[ag.Scalar, ag.Scalar], z: tuple[ag.Scalar, ag.Scalar], y: tuple[ag.Scalar, ag.Scalar]
    ) -> ag.Body:
        """Make a fixed profile."""
        return ag.part(ag.Region(x, y, z).box(bevel=0.0012), "frame", self.profile)

    def wall(self, x: ag.Scalar, side: int, y: tuple[float, float] = (-0.0165, 0.0165)) -> ag.Body:
        """Make a profile at a wall at x; the enclosure is at its `side`."""
        return self.bar(ordered(x, x + side * PROFILE, side), (self.low - 0.0009, self.top - 0.0007), y)

    def rails(
        self, x: tuple[ag.Scalar, ag.Scalar], y: tuple[float, float], *, lips: bool = True
    ) -> list[ag.Body]:
        """Make the rails above and below doors, with lips before them."""
        x = (x[0] + 0.0008, x[1] - 0.0008)
        spans = [(self.top - HEAD, self.top), (self.low - 0.0005, self.low + SILL)]
        bars = [self.bar(x, z, y) for z in spans]
        if not lips:
            return bars
        front = (y[0] - 0.003, y[0] + 0.0005)
        x = (x[0] + 0.0004, x[1] - 0.0004)
        ends = [(self.top - HEAD - 0.012, self.top - 0.0005), (self.low - 0.0002, self.low + SILL + 0.009)]
        return [*bars, *(self.bar(x, z, front) for z in ends)]

    def pane(
        self,
        x: tuple[ag.Scalar, ag.Scalar],
        z: tuple[ag.Scalar, ag.Scalar],
        y: ag.Scalar = 0.0,
        *,
        name: str | None = None,
    ) -> list[ag.Body]:
        """Make a pane about a plane y, with its etching."""
        room = ag.Region(x, (y - self.thick / 2, y + self.thick / 2), z)
        return [ag.part(room.box(bevel=0.0008), "glass", self.glass, name=name), *self._etching(room)]

    def _etching(self, room: ag.Region) -> list[ag.Body]:
        """Make a frosted band, or stripes, at the height of a body."""
        if self.etched == "none":
            return []
        wide, tall = room.x.size - 0.002, 0.62 * room.z.size
        shape = ag.rectangle(wide, tall)
        if self.etched == "stripes":
            heights = [0.5 - 0.105 * number for number in range(10)]
            shape = ag.rectangle(wide, 0.050 * tall).at(0, heights[0] * tall)
            for number, height in enumerate(heights[1:], 1):
                shape |= ag.rectangle(wide, (0.050 + 0.003 * number) * tall).at(0, height * tall)
        at = (room.x.mid, room.y.low, room.z.mid)
        return [details.printed(shape, at, material=_FROST)]

    def strip(self, x: ag.Scalar, z: tuple[ag.Scalar, ag.Scalar], y: ag.Scalar = 0.0) -> ag.Body:
        """Make the seal at an upright edge of a pane."""
        room = ag.Region((x - 0.0026, x + 0.0026), (y - 0.005, y + 0.005), z)
        return ag.detail(room.box(bevel=0.0012), "seal", SEAL)

    def stiles(
        self, x: tuple[ag.Scalar, ag.Scalar], z: tuple[ag.Scalar, ag.Scalar], y: ag.Scalar = 0.0
    ) -> ag.Body:
        """Make profiles at both upright edges of a moving pane."""
        ends = ((x[0], x[0] + 0.016), (x[1] - 0.016, x[1]))
        solids = [ag.Region(end, (y - 0.0065, y + 0.0065), z).box(bevel=0.0015) for end in ends]
        return ag.part(solids, "frame", self.profile)

    def grip(self, x: ag.Scalar, y: ag.Scalar, *, out: int = -1, through: bool = True) -> ag.Body:
        """Make a handle on the side `out` of a pane about a plane y, and on the other if it is `through`."""
        at, face = (x, y, self.low + 1.02), self.thick / 2
        sides = (out, -out) if through else (out,)
        solids, hold = _grip_solids("bar" if self.handle == "towel" else self.handle)
        turned = [each if side < 0 else each.rotate(ag.Z, math.pi) for side in sides for each in solids]
        moved = [
            each.at(y=side * face)
            for side, each in zip((side for side in sides for _ in solids), turned, strict=True)
        ]
        frame = ag.frame((0, out * (face + hold), 0), approach=(0, -out, 0), closing=ag.X)
        body = ag.part(
            moved, "handle", casting(self.metal, 0.5), grasp=frame, separate="fixed through the glass"
        )
        cap = ag.cylinder(0.011, 0.003, axis=ag.Y, bevel=0.0008).at(y=-out * (face + 0.0010))
        return (body if through else ag.weld(body, ag.detail(cap, "handle", self.metal))).at(at)

    def rail_for_towels(self, x: tuple[ag.Scalar, ag.Scalar], y: ag.Scalar) -> ag.Body:
        """Make a level bar for a towel outside a pane, along which a hand closes."""
        middle, long, out = (x[0] + x[1]) / 2, 0.72 * (x[1] - x[0]), 0.055
        bar = ag.cylinder(0.0095, long, axis=ag.X, bevel=0.002).at(y=-out)
        posts = [ag.cylinder(0.008, out, axis=ag.Y).at(side * 0.42 * long, -out / 2, 0) for side in (-1, 1)]
        hold = ag.frame((0, -out, 0), approach=ag.Y, closing=ag.Z)
        body = ag.part([bar, *posts], "handle", casting(self.metal, 0.4), grasp=hold)
        return body.at(middle, y - self.thick / 2 + 0.0004, self.low + 0.98)

    def opener(
        self, x: tuple[ag.Scalar, ag.Scalar], edge: ag.Scalar, y: ag.Scalar = 0.0, *, through: bool = True
    ) -> ag.Body:
        """Make what opens a pane: a bar for towels, or a knob or bar beside an edge."""
        if self.handle == "towel":
            return self.rail_for_towels(x, y)
        return self.grip(edge, y, through=through)


def ordered(first: ag.Scalar, second: ag.Scalar, side: int) -> tuple[ag.Scalar, ag.Scalar]:
    """Return both ends of a span, lowest first."""
    return (first, second) if side > 0 else (second, first)


def _grip_solids(kind: str) -> tuple[list[ag.Solid], float]:
    """Make a knob or an upright bar on the face y = 0, to -y; return the distance of a hand from the face."""
    if kind == "knob":
        neck = ag.cylinder(0.0075, 0.020, axis=ag.Y).at(y=-0.0098)
        return [ag.cylinder(0.016, 0.022, axis=ag.Y, bevel=0.003).at(y=-0.030), neck], 0.030
    bar = ag.cylinder(0.0095, 0.26, bevel=0.002).at(y=-0.045)
    posts = [ag.cylinder(0.0075, 0.045, axis=ag.Y).at(y=-0.0223, z=side * 0.095) for side in (-1, 1)]
    return [bar, *posts], 0.045


def hung(plan: Plan, x: tuple[ag.Scalar, ag.Scalar], y: float) -> list[ag.Body]:
    """Make a framed pane between the rails, with its seals."""
    z = plan.panel
    inner = (x[0] + 0.006, x[1] - 0.006)
    return [
        *plan.pane(inner, z, y, name="door"),
        plan.stiles(x, z, y),
        plan.strip(x[0], z, y),
        plan.strip(x[1], z, y),
    ]


def fold_hinge(
    plan: Plan, at: ag.VectorLike, z: tuple[ag.Scalar, ag.Scalar], way: int
) -> tuple[ag.Body, ag.Body]:
    """Make both halves of a long hinge, on the side of the panels to which `way` points."""
    tall, middle = z[1] - z[0], (z[0] + z[1]) / 2
    knuckle = ag.cylinder(0.0065, tall).at(z=middle)
    leaf = ag.Region((0.0015, 0.012), ordered(-way * 0.0085, -way * 0.0012, way), z).box()
    fixed = ag.part([knuckle, leaf.mirror(ag.X)], "hinge", plan.profile)
    return fixed.at(at), ag.detail(leaf, "hinge", plan.profile).at(at)


def bent(
    radius: ag.Scalar, wide: float, z: tuple[ag.Scalar, ag.Scalar], start: float, sweep: float, count: int
) -> list[ag.Solid]:
    """Make a curved wall about the origin in pieces with convex colliders; angles are in degrees."""
    step = math.radians(sweep) / count
    outline = [
        ag.bow(radius, wide, start=math.radians(start) + step * index, sweep=step) for index in range(count)
    ]
    solids = [ag.extrude(each, z[1] - z[0]).at(z=(z[0] + z[1]) / 2) for each in outline]
    return [ag.bounding_collider(solid, ag.hull(solid)) for solid in solids]


def tray_with_drain(plan: Plan, room: ag.Region, tray: ag.Material) -> ag.Body:
    """Make a rectangular tray on the floor with its rims and drain."""
    plate = room.with_(z=(0, plan.low - 0.014)).box(bevel=0.002)
    rim = ag.extrude(room.plan() - room.shrink(0.05, z=0).plan(), 0.0145).at(z=plan.low - 0.00725)
    return ag.weld(
        ag.part(plate | rim, "tray", tray, name="tray"),
        *drain(plan.metal, (room.x.mid, room.y.high - 0.16, plan.low - 0.0142)),
    )


def drain(metal: ag.Material, at: ag.VectorLike) -> list[ag.Body]:
    """Make the cover of a drain, with the dark slot around it."""
    cover = ag.cylinder(0.052, 0.005, bevel=0.002)
    slot = ag.cylinder(0.057, 0.0012)
    return [ag.detail(cover.at(at), "drain", metal), ag.detail(slot.at(at), "drain", recess(metal))]
