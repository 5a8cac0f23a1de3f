"""Icons: the signs beside buttons, knobs and lamps, all drawn with one weight of line."""

from typing import Literal

import numpy as np

from artgen._caching import cached
from artgen.asset.outline import Outline
from artgen.errors import BuildError, nearest
from artgen.graph import kernel
from artgen.graph.node import authors_line
from artgen.nodes import validators as inputs
from artgen.nodes.contours import moved_outline
from artgen.nodes.details.icon_kitchen import KITCHEN
from artgen.nodes.details.icon_signs import SIGNS
from artgen.nodes.details.ink import drawing
from artgen.nodes.details.pen import SQUARE
from artgen.nodes.handles import Profile, Scalar

Weight = Literal["light", "regular", "bold"]
"""How heavy the lines of an icon are."""

_WIDTHS: dict[str, float] = {"light": 1.1, "regular": 1.5, "bold": 1.9}  # in units of the square

_DRAWINGS = SIGNS | KITCHEN

ICONS: tuple[str, ...] = tuple(sorted(_DRAWINGS))
"""The names of all icons."""


def checked_icon(name: str) -> str:
    """Return the name of an icon."""
    if name not in _DRAWINGS:
        raise ValueError(f"there is no icon {name!r}.{nearest(name, ICONS)} artgen.ICONS lists all")
    return name


@cached(512)
def icon_outline(name: str, weight: str) -> Outline:
    """Return an icon in units of its square."""
    return drawing(_DRAWINGS[checked_icon(name)], _WIDTHS[weight], f"the icon {name!r}")


@kernel
def _icon(name: str, height: float, weight: Weight) -> Outline:
    inputs.positive("height", height)
    return moved_outline(icon_outline(name, weight), np.eye(2) * (height / SQUARE), np.zeros(2))


def icon(name: str, height: Scalar, *, weight: Weight = "regular") -> Profile:
    """Make an icon such as `"power"`, `"timer"` or `"child_lock"`; `ICONS` lists them.

    Icons of one height look right beside each other: they are drawn on one square with lines of one width.

    Args:
        name: Which one; known while building.
        height: Side of the square about the origin, which the icon fills or nearly fills [m].
        weight: How heavy its lines are.

    Raises:
        BuildError: There is no such icon; the message has the nearest name.

    Examples:
        >>> details.icon("power", 0.01)
    """
    try:
        checked_icon(name)
    except ValueError as error:
        raise BuildError(f"{error}\n  at {authors_line()}") from None
    return Profile.record(_icon, name=name, height=height, weight=weight)
