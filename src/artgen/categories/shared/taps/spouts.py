"""Spouts of faucets: they turn about the z axis above the plane z = 0, the lower end of their foot."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared.finish import casting
from artgen.nodes.handles import Path

SpoutStyle = Literal["gooseneck", "arc", "angular", "low", "beam"]
"""A gooseneck, a low arc, a bent square tube, a spout below a bar, or a straight spout."""

SEALS = feel.Feel(damping=0.05, armature=0.0005, effort=8.0)
"""Feel of the swivel of a spout, without the friction of its seals."""

CORE = 0.60
"""Radius of the fixed core in the ring of a beam spout, as a share of that of the ring."""

# the weight of 0.5-0.8 kg on the hose of a spray head draws it back; the bend takes a part of its force
_WEIGHT = feel.Feel(damping=12.0, friction=1.0, armature=0.5, effort=40.0)
_GAP = 0.0006  # gap between a spout and its base [m]
_AERATOR = 0.015  # length of an aerator [m]
_HEAD = 0.085  # length of a spray head [m]
_FOOT = 0.024  # height of the hub of a spout [m]
_BORE = 0.0084  # radius of the bore for a hose [m]
_LEAST = 0.0104  # least radius of a spout with that bore [m]
_HOSE = 0.0056  # radius of the hose [m]
_DOCK = 0.010  # length of the hose inside the spout while the head is out [m]
_DROP = 0.0205  # least height of the angle of a square tube above its end [m]
_SIDES = 12  # number of facets of hollow colliders under a smooth surface
_MESH = ag.material("black_abs").with_(name="aerator_mesh", base_color=(0.10, 0.10, 0.10))
_SIEVE = ag.material("stainless").with_(name="sieve_steel", specular_roughness=0.5)


def _aerator(radius: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make an aerator with its sieve, from the origin down."""
    ring = ag.cylinder(radius, _AERATOR, bevel=0.0014).align((0.0, 0.0, 0.001), z=1)
    sieve = ag.cylinder(0.74 * radius, 0.0008).at(z=0.001 - _AERATOR)
    holes = ag.cylinder(0.50 * radius, 0.0010).at(z=0.0009 - _AERATOR)
    return ag.weld(
        ag.part(ring, "aerator", casting(finish, 0.6)),
        ag.detail(sieve, "aerator", _MESH),
        ag.detail(holes, "aerator", _SIEVE),
    )


@dataclass(frozen=True)
class Spout:
    """Spouts of one tube; each method makes the link `spout`."""

    reach: ag.Scalar  # distance from the axis to the outlet [m]
    radius: ag.Scalar  # radius of the tube [m]
    finish: ag.Material

    def _pipe(self, pipe: ag.Solid, end: ag.Vector, *, above: float, hangs: bool = False) -> ag.Body:
        """Weld a pipe to its hub, from which a hand at a height above its end turns it."""
        metal, side = casting(self.finish, 0.32), 1 if hangs else -1
        thin, wide = (self.radius + 0.0035, self.radius + 0.0065)[::side]
        hub = ag.frustum(thin, wide, _FOOT, bevel=0.0015).align((0.0, 0.0, -side * _GAP), z=side)
        hold = ag.frame(end + ag.Z * above, approach=ag.Y, closing=ag.X)
        body = ag.part(hub, "spout", metal, grasp=hold, grasp_width=2 * self.radius + 0.012)
        return ag.weld(body, ag.part(pipe, "spout", metal))

    def _course(self, height: ag.Scalar, fall: ag.Scalar, fillet: ag.Scalar) -> Path:
        """Return the center line of a tube that goes up, forward and down."""
        places = ((0.0, 0.004), (0.0, height), (-self.reach, height), (-self.reach, fall))
        return ag.polyline([(0.0, y, z) for y, z in places], fillet=fillet)

    def _gooseneck(self, height: ag.Scalar, fall: ag.Scalar) -> Path:
        """Return the center line of a gooseneck."""
        low = "height of a gooseneck must exceed half of its reach: raise height, or lower reach"
        height = ag.require(height, height - ag.max_(fall, 0.004) > 0.5 * self.reach, low)
        return self._course(height, fall, 0.4985 * self.reach)

    def rising(self, style: SpoutStyle, *, height: ag.Scalar, fall: ag.Scalar) -> ag.Body:
        """Make a spout that goes up from its foot and ends at the height `fall`."""
        section = ag.circle(self.radius)
        if style == "gooseneck":
            course = self._gooseneck(height, fall)
        elif style == "arc":
            tight = "the arc bends too tightly for its tube: raise height, or lower girth"
            least = 0.08 * self.reach + 4.0 * self.radius + 0.0576
            height = ag.require(height, height >= least, tight)
            drop = height - fall
            line = ((0.0, 0.004), (0.0, 0.50 * height), (0.16, 0.86 * height), (0.52, height),
                    (0.88, height - 0.30 * drop), (1.0, fall + 0.35 * drop), (1.0, fall))  # fmt: skip
            course = ag.spline([(0.0, -share * self.reach, z) for share, z in line])
        else:
            section = ag.rectangle(1.8 * self.radius, 1.8 * self.radius, radius=0.3 * self.radius)
            low = "an angular spout is too low to clear the handles: raise height"
            height = ag.require(height, height - fall >= _DROP, low)
            course = self._course(height, fall, 0.020)
        end = ag.vector(0.0, -self.reach, fall)
        pipe = self._pipe(ag.sweep(section, course), end, above=0.004)
        return ag.weld(pipe, _aerator(self.radius + 0.0012, self.finish).at(end))

    def hanging(self) -> ag.Body:
        """Make a spout below its foot that goes forward and a little up."""
        places = ((0.0, -0.004), (0.0, -0.050), (-self.reach, -0.028), (-self.reach, -0.062))
        course = ag.polyline([(0.0, y, z) for y, z in places], fillet=0.021)
        end = ag.vector(0.0, -self.reach, -0.062)
        pipe = self._pipe(ag.sweep(ag.circle(self.radius), course), end, above=0.006, hangs=True)
        return ag.weld(pipe, _aerator(self.radius + 0.0012, self.finish).at(end))

    def straight(self, *, hub: ag.Scalar, tall: ag.Scalar, square: bool) -> ag.Body:
        """Make a beam from a ring about a column, which has few facets under a smooth surface."""
        reach, radius, middle = self.reach, self.radius, tall / 2
        start, out, high = -0.80 * hub, hub - 0.0006, tall - 3 * _GAP
        inner = (CORE * hub + 0.0004) * 1.04  # the facets clear the core
        center = _GAP + high / 2
        section = ag.rectangle(out - inner, high).at((out + inner) / 2, center)
        skin = ag.tube(hub, hub - 0.0016, high, bevel=0.0006).at(z=center)
        if square:
            drop = middle - 0.75 * radius
            long = (-reach - 1.1 * radius, start)
            beam = ag.Region((-1.3 * radius, 1.3 * radius), long, (drop, middle + 0.75 * radius))
            pipe = beam.box(bevel=0.0025)
        else:
            drop = middle - 1.6 * radius
            line = [(0.0, start, middle), (0.0, -reach, middle), (0.0, -reach, drop)]
            pipe = ag.sweep(ag.circle(radius), ag.polyline(line, fillet=1.25 * radius))
        metal, hold = casting(self.finish, 0.35), ag.grasp_on(pipe, approach=ag.Y, closing=ag.X, depth=0.018)
        return ag.weld(
            ag.part(ag.revolve(section, sides=_SIDES), "spout", metal),
            ag.detail(skin, "spout", self.finish),
            ag.part(pipe, "spout", metal, grasp=hold),
            _aerator(0.92 * radius, self.finish).at(0.0, -reach, drop),
        )

    def pull_down(
        self, *, height: ag.Scalar, fall: ag.Scalar, travel: ag.Scalar, force: ag.Scalar
    ) -> ag.Body:
        """Make a gooseneck with a spray head, whose hose slides in a bore in its straight end."""
        narrow = f"the spout holds the hose of a spray head: girth must be > {_LEAST:g} m"
        radius = ag.require(self.radius, self.radius > _LEAST, narrow)
        deep, end = travel + _DOCK + 0.006, ag.vector(0.0, -self.reach, fall)  # depth of the bore
        pipe = ag.sweep(ag.circle(radius), self._gooseneck(height, fall + deep))
        out, inner = radius - 0.0006, _BORE / 0.966  # facets inside the smooth surface
        section = ag.rectangle(out - inner, deep + 0.0005).at((out + inner) / 2, deep / 2)
        skin = ag.tube(radius, radius - 0.0014, deep + 0.0006).at(z=deep / 2 + 0.0003)
        spout = ag.weld(
            self._pipe(pipe, end, above=0.012),
            ag.part(ag.revolve(section, sides=_SIDES).at(end), "spout", casting(self.finish, 0.8)),
            ag.detail(skin.at(end), "spout", self.finish),
        )
        pull = ag.Spring(preload=0.75 * force, force=force)
        slide = ag.Prismatic("spray_head_slide", axis=-ag.Z, limits=(0.0, travel), spring=pull, feel=_WEIGHT)
        return spout.attach(_spray_head(radius, travel, self.finish), slide, at=end)


def _spray_head(radius: ag.Scalar, travel: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a spray head below the origin, with the hose above it."""
    low, wide, metal = -_HEAD - _GAP, radius + 0.0045, casting(finish, 0.28)
    grip = ag.frustum(wide, radius + 0.0004, 0.75 * _HEAD, bevel=0.001).align((0.0, 0.0, -_GAP), z=1)
    nose = ag.cylinder(wide, 0.26 * _HEAD, bevel=0.002).align((0.0, 0.0, low), z=-1)
    hose = ag.cylinder(_HOSE, travel + _DOCK + 0.002).align((0.0, 0.0, -_GAP - 0.002), z=-1)
    at = [
        (ring * wide * math.cos(turn), ring * wide * math.sin(turn), low - 0.0006)
        for ring, count in ((0.3, 6), (0.62, 12))
        for turn in (math.tau * step / count for step in range(count))
    ]
    jets = ag.array(ag.cylinder(0.0012, 0.0012), at=at)
    rocker = ag.Region((-0.0042, 0.0042), (-wide - 0.0012, -radius), (-0.62 * _HEAD, -0.36 * _HEAD))
    face, dark = ag.cylinder(0.84 * wide, 0.0012).at(z=low + 0.0001), ag.material("black_abs")
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X)
    return ag.weld(
        ag.part([grip, nose], "spray_head", metal, grasp=hold),
        ag.part(hose, "hose", ag.material("rubber")),
        ag.detail(rocker.box(bevel=0.0016), "spray_head", dark),
        ag.detail(face, "aerator", dark),
        ag.detail(jets, "aerator", ag.material("silicone")),
    )
