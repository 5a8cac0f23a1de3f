"""What is printed on bins: the maker's name, what to throw in, and how to use them."""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import recycling
from artgen.categories.trashcan.bins import Can

Sort = Literal["none", "recycling", "paper", "plastic", "glass", "food"]
"""What a bin is for, if it says so."""

_INK = {"recycling": "", "paper": "PAPER", "plastic": "PLASTIC", "glass": "GLASS", "food": "FOOD WASTE"}
_LIGHT = 0.25  # mean of the color from which dark print shows better


def ink_on(finish: ag.Material, *, metal: bool = True) -> ag.Material:
    """Return what print on a finish is made of: dark on light, light on dark, grey on metal."""
    mean = sum(finish.base_color) / 3.0
    if metal and finish.base_metalness > 0.5:
        return ag.colored("abs", "slate") if mean > _LIGHT else ag.colored("abs", "silver")
    return ag.colored("abs", "graphite") if mean > _LIGHT else ag.colored("abs", "white")


def maker_mark(can: Can, maker: str, *, z: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Print the maker's name on the front, small enough to lie on a round one."""
    mark = details.logo(maker, 0.010 * can.width, tracking=0.15)
    return details.printed(mark, can.face(z), material=ink_on(finish), facing=can.facing, proud=0.0006)


def sort_mark(can: Can, sort: Sort, *, z: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Print the sign of what to throw in on the front; nothing where there is none."""
    if sort == "none":
        return []
    ink = ink_on(finish, metal=False)
    flat = can.plan in ("square", "rectangle")
    sign = recycling(0.075 if flat else 0.10 * can.width)
    bodies = [details.printed(sign, can.face(z), material=ink, facing=can.facing, proud=0.0008)]
    words = _INK[sort]
    if words and flat:
        line = details.lettering((words,), 0.012, tracking=0.12, fineness="coarse")
        bodies.append(
            details.printed(line, can.face(z - 0.065), material=ink, facing=can.facing, proud=0.0008)
        )
    return bodies


def plate(at: ag.VectorLike, lines: tuple[str, ...]) -> ag.Body:
    """Make the sticker with type and volume behind a bin."""
    return details.rating_plate(0.026, 0.018, lines, at=at, facing=(0.0, 1.0, 0.0), double_insulated=False)


def top_mark(maker: str, at: ag.VectorLike, finish: ag.Material) -> ag.Body:
    """Print the maker's name on a lid, read from in front."""
    mark = details.logo(maker, 0.0045, tracking=0.2)
    return details.printed(mark, at, material=ink_on(finish), facing=ag.Z, up=(0.0, 1.0, 0.0))


def bag(can: Can) -> ag.Body:
    """Fold a thin bag over the rim of an open bin, only seen."""
    sheet = ag.material("polypropylene").with_(
        name="bag_film", base_color=(0.78, 0.79, 0.80), specular_roughness=0.35, density=920.0
    )
    return ag.detail(can.band(can.top - 0.045, can.top + 0.0008, outer=-0.0009, inner=0.0002), "bag", sheet)
