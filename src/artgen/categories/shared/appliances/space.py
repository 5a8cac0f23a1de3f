"""Where things are in a kitchen appliance with a door: what follows from its size, whatever is inside."""

from dataclasses import dataclass
from functools import cached_property

from artgen import Float, Scalar


@dataclass(frozen=True, kw_only=True)
class ApplianceSpace:
    """The measures that appliances share."""

    width: Float  # of everything [m]
    height: Float  # of everything but what stands on a range [m]
    depth: Float  # of everything, a handle included [m]
    projection: Scalar  # of a handle before the door [m]
    thickness: Float  # of the door [m]

    @cached_property
    def half(self) -> Scalar:
        """Half the width [m]."""
        return self.width / 2.0

    @cached_property
    def front(self) -> Scalar:
        """The outer face of the door, along y [m]."""
        return self.projection - self.depth / 2.0

    @cached_property
    def inner(self) -> Scalar:
        """The inside of the door, along y [m]."""
        return self.front + self.thickness

    @cached_property
    def rear(self) -> Scalar:
        """The back of everything, along y [m]."""
        return self.depth / 2.0
