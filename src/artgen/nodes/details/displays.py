"""Displays: a dark pane with luminous figures, or a grey pane with black figures."""

from typing import Literal

from artgen.errors import BuildError, nearest
from artgen.graph.node import authors_line
from artgen.materials import MATERIALS, Material
from artgen.nodes.body import detail, weld
from artgen.nodes.details.dots import dot_matrix, dot_matrix_width, dots_of
from artgen.nodes.details.relief import FRONT, reading, relief
from artgen.nodes.details.segments import Lit, has_dark_segments, seven_segment, seven_segment_width
from artgen.nodes.handles import Body, Profile, Scalar, Solid, VectorLike
from artgen.nodes.profile import rectangle
from artgen.nodes.scalar import min_

Color = Literal["red", "amber", "green", "blue", "white", "cyan", "lcd"]
"""Appearance of the figures: luminous in a color, or black on a grey-green liquid crystal."""

_PANE = 0.0008  # height of the pane above the face [m]
_FILM = 0.0001  # height of the figures above the pane [m]

_GLOW: dict[str, tuple[float, float, float]] = {
    "red": (1.0, 0.04, 0.02),
    "amber": (1.0, 0.32, 0.02),
    "green": (0.10, 0.95, 0.16),
    "blue": (0.10, 0.32, 1.0),
    "white": (0.90, 0.95, 1.0),
    "cyan": (0.12, 0.85, 0.95),
}


def glow(color: str) -> Material:
    """Return the material of luminous figures in a color."""
    tone = _GLOW[color]
    name = "display" if color == "cyan" else f"led_{color}"
    if name in MATERIALS:
        return MATERIALS[name]
    dim = tuple(0.3 * channel for channel in tone)
    return MATERIALS["abs"].with_(
        name=name, base_color=dim, emission=tone, specular_roughness=0.3, texture="", tile=None
    )


def _black_glass() -> Material:
    if "black_glass" in MATERIALS:
        return MATERIALS["black_glass"]
    return MATERIALS["glass"].with_(
        name="black_glass", base_color=(0.012, 0.012, 0.014), specular_roughness=0.06, opacity=1.0
    )


def _materials(color: str) -> tuple[Material, Material, Material]:
    """Return the materials of the pane, of lit and of dark segments."""
    if color not in (*_GLOW, "lcd"):
        raise BuildError(
            f"a display cannot shine in {color!r}.{nearest(color, [*_GLOW, 'lcd'])}\n  at {authors_line()}"
        )
    if color == "lcd":
        pane = MATERIALS["abs"].with_(
            name="lcd", base_color=(0.34, 0.39, 0.31), specular_roughness=0.22, texture="", tile=None
        )
        ghost = pane.with_(name="lcd_dark", base_color=(0.295, 0.34, 0.265))
        return pane, pane.with_(name="lcd_lit", base_color=(0.02, 0.024, 0.02)), ghost
    pane = _black_glass()
    faint = tuple(0.014 + 0.022 * channel for channel in _GLOW[color])
    dark = pane.with_(name=f"led_{color}_dark", base_color=faint, texture="", tile=None)
    return pane, glow(color), dark


def _width(string: str, style: str) -> float:
    """Return the width of a text relative to the height of its figures."""
    try:
        if style == "dot_matrix":
            return dot_matrix_width(string) if dots_of(string).any() else 0.0
        return seven_segment_width(string) + 0.12  # slant of the figures
    except ValueError as error:
        raise BuildError(f"{error}\n  at {authors_line()}") from None


def display(
    string: str,
    width: Scalar,
    height: Scalar,
    *,
    at: VectorLike = (0.0, 0.0, 0.0),
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    style: Literal["seven_segment", "dot_matrix"] = "seven_segment",
    color: Color = "red",
    share: Scalar = 0.56,
    ghosts: bool = True,
    label: str = "display",
) -> Body:
    """Make a display on a face: a pane 0.8 mm above the face with visual figures.

    Args:
        string: Displayed text, known while building; `""` is dark.
        width: Width of the pane [m].
        height: Height of the pane [m].
        at: Center of the pane on the face [m].
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        style: Seven-segment figures or a dot matrix.
        color: Color of luminous figures on black glass, or a liquid crystal.
        share: Height of the figures as a share of the pane's; less if they would be too wide.
        ghosts: Whether dark segments are faintly visible.
        label: Semantic label of pane and figures.

    Raises:
        BuildError: The style cannot show a character.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, details.display("12:30", 0.05, 0.02, at=(0, -0.002, 0), color="green"))
    """
    pane, lit, dark = _materials(color)

    def plate(profile: Profile, proud: float, bevel: float = 0.0) -> Solid:
        return relief(profile, at, facing=facing, up=up, proud=proud, sunk=0.0004, bevel=bevel)

    corner = 0.06 * min_(width, height)
    turns = {"reads": reading(facing, up), "about": at}
    bodies = [detail(plate(rectangle(width, height, radius=corner), _PANE, 0.0003), label, pane, **turns)]
    wide = _width(string, style) if string.strip() else 0.0
    if wide > 0.0:
        tall = min_(share * height, 0.84 * width / wide)

        def figures(show: Lit) -> Profile:
            if style == "dot_matrix":
                return dot_matrix(string, tall, show=show)
            return seven_segment(string, tall, show=show)

        bodies.append(detail(plate(figures("lit"), _PANE + _FILM), label, lit, **turns))
        if ghosts and (style == "dot_matrix" or has_dark_segments(string)):
            bodies.append(detail(plate(figures("dark"), _PANE + _FILM), label, dark, **turns))
    return weld(*bodies)
