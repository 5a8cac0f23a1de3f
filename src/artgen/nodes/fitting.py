"""Fittings: bodies that are installed on a host, with the hole that they need in it; and clearances."""

from dataclasses import dataclass

from artgen.nodes.handles import Body, Scalar, Solid, VectorLike, offset_of, steps_of
from artgen.nodes.joint import Joint


@dataclass(frozen=True)
class Fitting:
    """A bought part: a body for a host to carry, and the hole that it needs in the host.

    The host takes over the fixed parts of the body (plate, print, lining) and the links that are joined to
    them. A fitting is modeled about the origin on the plane y = 0, the face of its host, and faces -Y.

    Args:
        body: Fixed parts with the moving links that are attached to them, or one part without joints.
        cut: Solid that is cut out of the host.

    Examples:
        >>> cap = part(cylinder(0.006, 0.010, axis=Y).at(y=0.001), "button", material("black_abs"))
        >>> spring = Spring(preload=0.6, force=3.0)
        >>> slide = Prismatic("button_slide", axis=Y, limits=(0, 0.002), spring=spring)
        >>> button = Fitting.moving(cap, slide, cut=cylinder(0.0064, 0.03, axis=Y))
        >>> panel = part(box(0.1, 0.012, 0.05).at(y=0.006), "panel", material("abs"))
        >>> panel = panel.install(button.suffixed("_0"), at=(-0.02, 0, 0))
        >>> panel.install(button.suffixed("_1"), at=(0.02, 0, 0))
    """

    body: Body
    cut: Solid | None = None

    @classmethod
    def moving(
        cls, child: Body, *joints: Joint, fixed: Body | None = None, cut: Solid | None = None
    ) -> "Fitting":
        """Make a fitting of a moving link with its joints, and the `fixed` parts that the host carries."""
        if fixed is None:
            return cls(Body.record("mounted", child=child, joints=steps_of(joints)), cut)
        return cls(fixed.attach(child, *joints), cut)

    def at(self, x: Scalar | VectorLike = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> "Fitting":
        """Move by a vector, or by x, y and z [m]."""
        offset = offset_of(x, y, z)
        return Fitting(self.body.at(offset), None if self.cut is None else self.cut.at(offset))

    def rotate(self, axis: VectorLike, angle: Scalar, *, about: VectorLike = (0.0, 0.0, 0.0)) -> "Fitting":
        """Turn about an axis through the point `about` by an angle [rad]."""
        cut = None if self.cut is None else self.cut.rotate(axis, angle, about=about)
        return Fitting(self.body.rotate(axis, angle, about=about), cut)

    def mirror(self, normal: VectorLike) -> "Fitting":
        """Reflect in the plane through the origin with that normal."""
        return Fitting(self.body.mirror(normal), None if self.cut is None else self.cut.mirror(normal))

    def suffixed(self, suffix: str) -> "Fitting":
        """Add a suffix to the names of all its links, joints, grasps and pushes."""
        return Fitting(self.body.suffixed(suffix), self.cut)


@dataclass(frozen=True, kw_only=True)
class Fits:
    """Clearances between parts by their kind of fit, all on one side [m]."""

    film: float = 0.0002  # height of print above its face
    sliding: float = 0.0004  # a cap in its hole, a bolt in its guide
    lap: float = 0.0005  # overlap of joined boards, so that no two faces coincide
    running: float = 0.0006  # a wheel beside its fork, a dial before its panel
    reveal: float = 0.002  # joint between two fronts, or between a front and its frame
    runner: float = 0.0127  # space of a ball-bearing drawer runner at each side of a drawer
    floor: float = 0.010  # gap between a swinging leaf and the floor


FIT = Fits()
"""The clearances that all categories share."""
