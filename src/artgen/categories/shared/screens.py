"""Pictures on screens: hills below a sky, with the dock of a desktop."""

import functools
import operator
from collections.abc import Iterable

import artgen as ag
from artgen import details, signals

_COLORS = {
    "dusk": ((0.09, 0.08, 0.26), (0.55, 0.24, 0.26)),
    "sea": ((0.03, 0.14, 0.28), (0.16, 0.42, 0.50)),
    "meadow": ((0.10, 0.26, 0.40), (0.12, 0.30, 0.10)),
}
"""Colors of the sky and of the hills of each picture."""

_DOCK = {"dock": (0.22, 0.24, 0.28), "icons": (0.75, 0.78, 0.82)}

PICTURES = (*_COLORS, "off")
"""Names of the pictures; the last is a dark screen."""

GLASS = ag.material("black_glass").with_(name="screen_glass", specular_roughness=0.12)
"""Dark pane around a picture."""

_RIDGE = (
    (-0.5, -0.5), (0.5, -0.5), (0.5, 0.06), (0.30, -0.10),
    (0.12, 0.16), (-0.1, -0.05), (-0.28, 0.10), (-0.5, -0.12),
)  # fmt: skip
"""Outline of the hills, in shares of the width and the height."""


def picture_films(
    picture: str,
    size: tuple[ag.Scalar, ag.Scalar],
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar],
    *,
    facing: ag.VectorLike,
    up: ag.VectorLike | None = None,
    dock: bool = True,
) -> list[ag.Body]:
    """Make the lit films of a picture on a pane; none for a dark screen.

    Args:
        picture: One of `PICTURES`.
        size: Width and height of the picture [m].
        at: Its middle on the pane [m].
        facing: Direction of the viewer.
        up: Direction of its upper edge.
        dock: Whether it has the dock of a desktop, for a screen of 0.2 m or more.
    """
    if picture == "off":
        return []
    wide, tall = size
    sky, hills = (
        _glowing(f"{picture}_{name}", color)
        for name, color in zip(("sky", "hills"), _COLORS[picture], strict=True)
    )
    whole = ag.rectangle(wide, tall)
    land = ag.polygon([(x * wide, y * tall) for x, y in _RIDGE])
    if not dock:
        return _films(((whole - land, sky), (land, hills)), at, facing, up)
    tray = ag.rectangle(0.30 * wide, 0.055 * tall, radius=0.004).at(0, -0.43 * tall)
    icon = ag.rectangle(0.007, 0.007, radius=0.002)
    icons = functools.reduce(
        operator.or_, [icon.at(0.042 * wide * place, -0.43 * tall) for place in range(-3, 4)]
    )
    layers = (
        (whole - land, sky),
        (land - tray, hills),
        (tray - icons, _glowing("dock", _DOCK["dock"])),
        (icons, _glowing("icons", _DOCK["icons"])),
    )
    return _films(layers, at, facing, up)


def powered(picture: str, key: signals.Signal) -> signals.Signal:
    """Return the signal of a screen that each press of a key switches; its picture is on at delivery."""
    return signals.toggle(key) if picture == "off" else ~signals.toggle(key)


def lit(body: ag.Body, picture: str, on: signals.Signal, *, dock: bool = True) -> ag.Body:
    """Let a picture shine: an output for each film, `display` for its sky; a dark screen has no film."""
    if picture == "off":
        return body.output("display", on, kind="display")
    sky, hills = _COLORS[picture]
    films = {f"{picture}_sky": sky, f"{picture}_hills": hills, **(_DOCK if dock else {})}
    for name, color in films.items():
        film, part = _glowing(name, color), name.removeprefix(f"{picture}_")
        output = "display" if part == "sky" else f"display_{part}"
        body = body.output(output, on, kind="display", material=film, color=film.emission)
    return body


def _films(
    layers: Iterable[tuple[ag.Profile, ag.Material]],
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar],
    facing: ag.VectorLike,
    up: ag.VectorLike | None,
) -> list[ag.Body]:
    """Make the lit films of profiles on a pane."""
    return [
        details.printed(profile, at, material=color, facing=facing, up=up, label="display", proud=0.00015)
        for profile, color in layers
    ]


def _glowing(name: str, color: tuple[float, float, float]) -> ag.Material:
    """Make the material of a lit part of a screen."""
    dim, lit = (tuple(share * value for value in color) for share in (0.05, 0.3))
    return ag.material("display").with_(
        name=f"screen_{name}", base_color=dim, emission=lit, specular_roughness=0.15
    )
