"""Control panels: a strip of black glass, a display, printed icons and lamps, all visual only.

All parts lie on the plane y = 0 and face -y; move them to their face, or rotate them with `rotate`. Buttons
and dials, which move, are attached at the same positions, which `places` returns.
"""

from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.controls.buttons import PLAY, ButtonShape, button_outline
from artgen.nodes.details.displays import Color

PANE = 0.0006
"""Height of an inlay above its face [m]."""

_LAMP = 0.0009  # radius of a lamp beside an icon [m]
_FILM = 0.0002  # height of print above its face [m]

LIGHT_INK = ag.colored("abs", "light_grey").with_(name="light_ink", texture="", tile=None)
"""Print on dark faces."""

DARK_INK = ag.colored("abs", "graphite").with_(name="dark_ink", texture="", tile=None)
"""Print on bright faces."""


def ink_on(face: ag.Material) -> ag.Material:
    """Return the print with good contrast on a face."""
    luminance = sum(share * one for share, one in zip((0.21, 0.72, 0.07), face.base_color, strict=True))
    return DARK_INK if luminance > 0.12 else LIGHT_INK


def places(count: int, pitch: ag.Scalar, *, middle: ag.Scalar = 0.0) -> list[ag.Scalar]:
    """Return the centers of a row of parts along x [m]."""
    return [middle + (index - (count - 1) / 2.0) * pitch for index in range(count)]


def inlay(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    finish: ag.Material | None = None,
    radius: ag.Scalar = 0.003,
    holes: ag.Profile | None = None,
    proud: ag.Scalar = PANE,
    label: str = "panel",
) -> ag.Body:
    """Make a thin pane on the face, about the origin."""
    outline = ag.rectangle(width, height, radius=radius)
    if holes is None:
        solid = details.relief(outline, proud=proud, sunk=0.0006, bevel=0.0003)
    else:
        solid = ag.extrude(outline - holes, proud + 0.0006, axis=ag.Y).at(0.0, (0.0006 - proud) / 2.0, 0.0)
    return ag.detail(solid, label, finish or ag.MATERIALS["black_glass"])


def button_holes(
    shape: ButtonShape,
    width: ag.Scalar,
    height: ag.Scalar,
    at: Sequence[ag.Scalar],
    *,
    level: ag.Scalar = 0.0,
) -> ag.Profile:
    """Make the holes of a row of buttons with gaps around the caps, to be cut out of an `inlay`."""
    hole = button_outline(shape, width + 2.0 * PLAY, height + 2.0 * PLAY)
    holes = hole.at(at[0], level)
    for place in at[1:]:
        holes = holes | hole.at(place, level)
    return holes


def icon_row(
    icons: Sequence[str],
    at: Sequence[ag.Scalar],
    *,
    height: ag.Scalar = 0.007,
    level: ag.Scalar = 0.0,
    ink: ag.Material = LIGHT_INK,
    proud: ag.Scalar = PANE,
) -> ag.Body:
    """Print a row of icons as one film."""
    found = [
        details.icon(name, height).at(place, level) for name, place in zip(icons, at, strict=False) if name
    ]
    film = found[0]
    for one in found[1:]:
        film = film | one
    return details.printed(film, (0.0, -proud, 0.0), material=ink, proud=_FILM)


def lamp_row(
    at: Sequence[ag.Scalar],
    *,
    level: ag.Scalar = 0.0,
    lit: int = 0,
    color: Literal["white", "green", "blue", "amber", "red"] = "white",
    proud: ag.Scalar = PANE,
) -> ag.Body:
    """Make a row of small lamps; one of them is lit."""
    dark = ag.MATERIALS["abs"].with_(name="lamp_dark", base_color=(0.10, 0.10, 0.10), texture="", tile=None)
    groups = [
        ([place for index, place in enumerate(at) if (index == lit) == shines], each)
        for shines, each in ((True, ag.MATERIALS[f"led_{color}"]), (False, dark))
    ]
    bodies = []
    for found, finish in groups:
        if found:
            film = ag.circle(_LAMP).at(found[0], level)
            for place in found[1:]:
                film = film | ag.circle(_LAMP).at(place, level)
            solid = details.relief(film, (0.0, -proud, 0.0), proud=0.0003)
            bodies.append(ag.detail(solid, "print", finish))
    return ag.weld(*bodies)


def control_panel(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    icons: Sequence[str] = (),
    pitch: ag.Scalar = 0.022,
    icon_height: ag.Scalar = 0.008,
    show: str = "",
    screen: tuple[ag.Scalar, ag.Scalar] = (0.05, 0.018),
    color: Color = "white",
    upright: bool = False,
    finish: ag.Material | None = None,
    ink: ag.Material | None = None,
    radius: ag.Scalar = 0.004,
) -> ag.Body:
    """Make a touch panel about the origin: a pane with a display and a row of icons, each with a lamp.

    The display is in the middle with half of the icons at each side, or above the icons of a vertical panel.
    """
    face = finish or ag.MATERIALS["black_glass"]
    print_ = ink or ink_on(face)
    bodies = [inlay(width, height, finish=face, radius=radius)]
    if show:
        top = 0.5 * height - 0.9 * screen[1]
        at = (0.0, -PANE, top if upright and icons else 0.0)
        bodies.append(details.display(show, *screen, at=at, color=color))
    if icons and upright:
        bodies.append(_column(icons, pitch, icon_height, -0.5 * screen[1] if show else 0.0, print_))
    elif icons:
        aside = 0.5 * screen[0] + 0.4 * pitch if show else 0.0
        row = _beside(len(icons), pitch, aside) if show else places(len(icons), pitch)
        bodies.append(icon_row(icons, row, height=icon_height, ink=print_))
        bodies.append(lamp_row(row, level=-0.85 * icon_height))
    return ag.weld(*bodies)


def _beside(count: int, pitch: ag.Scalar, aside: ag.Scalar) -> list[ag.Scalar]:
    """Return positions at both sides of a display, at least `aside` from x = 0 [m]."""
    half = (count + 1) // 2
    left = [-aside - (half - index - 0.5) * pitch for index in range(half)]
    return [*left, *(aside + (index + 0.5) * pitch for index in range(count - half))]


def _column(
    icons: Sequence[str], pitch: ag.Scalar, height: ag.Scalar, middle: ag.Scalar, ink: ag.Material
) -> ag.Body:
    """Print a column of icons."""
    rows = [middle + ((len(icons) - 1) / 2.0 - index) * pitch for index in range(len(icons))]
    return ag.weld(
        *(
            icon_row([name], [0.0], height=height, level=level, ink=ink)
            for name, level in zip(icons, rows, strict=True)
        )
    )
