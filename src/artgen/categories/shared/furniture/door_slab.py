"""What every door leaf has in common: its measures, its wood, and what is done to it."""

from dataclasses import dataclass

from artgen import Float, Frame, Material, Scalar, Solid, box, frame
from artgen.categories.shared.furniture.arch import Arch

EASED = 0.0008
"""Edges of boards are sanded to this radius [m]: joints show as a fine line."""

_FROM_EDGE = 0.094  # from the lock edge to where hands push: beside a pull, still on a stile [m]


@dataclass(frozen=True)
class Fittings:
    """What a leaf carries besides its lock."""

    finish: Material  # their metal
    letters: bool = False  # whether it has a letter plate
    number: str = ""  # the number of the house; empty for none
    viewer: bool = False  # whether one can look out
    kick: bool = False  # whether a plate protects its foot
    sweep: bool = False  # whether a brush seals the gap to the floor

    def bare(self) -> "Fittings":
        """Return those of a leaf that nobody enters by."""
        return Fittings(self.finish, kick=self.kick, sweep=self.sweep)


@dataclass(frozen=True)
class Blank:
    """What every leaf has in common."""

    width: Float  # [m]
    bottom: Float  # height of its bottom above the floor [m]
    top: Float  # height of its top above the floor, of the crown of an arch [m]
    thickness: Float  # [m]
    rise: Float | None  # rise of an arched top over its ends [m]; None for a straight one
    cut: Solid | None  # what the hardware needs taken out of the lock stile; None for nothing
    finish: Material  # what the leaf is made of
    fittings: Fittings  # what an entrance has besides its lock
    reach: Float  # height above the floor at which hands push it [m]

    @property
    def straight(self) -> Scalar:
        """The height above the floor to which its edges are straight [m]."""
        return self.top if self.rise is None else self.top - self.rise

    @property
    def arch(self) -> Arch | None:
        """The arch of its top, if any."""
        return None if self.rise is None else Arch.over(self.width, spring=self.straight, rise=self.rise)

    @property
    def upright(self) -> Scalar:
        """The length of its edges [m]."""
        return self.straight - self.bottom

    @property
    def waist(self) -> Scalar:
        """The height of the middle of its edges above the floor [m]."""
        return (self.straight + self.bottom) / 2.0

    @property
    def push(self) -> Frame:
        """Where a hand pushes it open: on its back, which faces +y, near the lock edge."""
        at = (self.width / 2.0 - _FROM_EDGE, self.thickness / 2.0, self.reach)
        return frame(at, approach=(0.0, -1.0, 0.0), closing=(1.0, 0.0, 0.0))

    def carved(self, solid: Solid) -> Solid:
        """Return a solid without what the hardware needs."""
        return solid if self.cut is None else solid - self.cut

    def board(self, x: Scalar, z: Scalar, bevel: Scalar = EASED) -> Solid:
        """Make a board as thick as the leaf about the origin."""
        return box(x, self.thickness, z, bevel=bevel)
