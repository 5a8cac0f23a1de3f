"""Text: the outlines of a string as a profile."""

from __future__ import annotations

import functools
from collections.abc import Iterator, Sequence
from io import BytesIO
from pathlib import Path
from threading import Lock
from typing import Any, Literal

import numpy as np

from artgen import _portable
from artgen._arrays import Array, cached
from artgen.asset.shape import Contour, Outline
from artgen.graph import records
from artgen.nodes import validators as check
from artgen.nodes.contours import is_disjoint, moved_outline, outline_of, section
from artgen.nodes.handles import Profile, Scalar

_SMOOTH = 0.94  # cosine of the turn (20 degrees) below which curves of a letter join smoothly
_READING = Lock()  # fontTools reads a font lazily
_STEP = 0.45  # largest turn of a curve per side [rad]


@functools.cache
def _font() -> Any:
    # imported on first use: `import artgen` must not read a font
    from font_roboto import RobotoMedium
    from fontTools.ttLib import TTFont

    return TTFont(BytesIO(Path(RobotoMedium).read_bytes()), lazy=True)  # leaves no open file


def _curve(points: Array) -> tuple[Array, Array]:
    """Return samples of a quadratic Bezier curve without its start, and tangents with its start."""
    first, last = points[1] - points[0], points[2] - points[1]
    cross = abs(first[0] * last[1] - first[1] * last[0])
    steps = max(1, int(np.ceil(_portable.arctan2(cross, _portable.dot(first, last)) / _STEP)))
    t = (np.arange(steps + 1) / steps)[:, None]
    tangents = (1.0 - t) * first + t * last
    samples = (1.0 - t) ** 2 * points[0] + 2.0 * t * (1.0 - t) * points[1] + t**2 * points[2]
    return samples[1:], tangents


def _contour(curves: list[Array]) -> Contour | None:
    """Join closed sequences of lines (2 points) and quadratic curves (3 points), in units of the font."""
    points: list[Array] = []
    arriving: list[Array] = []
    leaving: list[Array] = []
    for curve in curves:
        if len(curve) == 2:
            samples = curve[1:]
            tangents = np.stack([curve[1] - curve[0]] * 2)
        else:
            samples, tangents = _curve(curve)
        points.extend(samples)
        arriving.extend(tangents[1:])
        leaving.extend(tangents[:-1])
    if len(points) < 3:
        return None
    normals = []
    for tangents_at in (np.array(arriving), np.array([*leaving[1:], leaving[0]])):
        across = np.column_stack([tangents_at[:, 1], -tangents_at[:, 0]])
        normals.append(across / np.linalg.norm(across, axis=1, keepdims=True))
    mean = normals[0] + normals[1]
    mean /= np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-12)
    joined = (np.einsum("ij,ij->i", *normals) > _SMOOTH)[:, None]
    # TrueType borders run clockwise; reversed, their outside is on the right
    return Contour(
        np.array(points)[::-1],
        np.where(joined, -mean, -normals[1])[::-1],
        np.where(joined, -mean, -normals[0])[::-1],
    )


@cached(256)
def _glyph(character: str) -> tuple[tuple[Contour, ...], float]:
    """Return the contours of a character and its advance, in capital heights."""
    from fontTools.pens.recordingPen import DecomposingRecordingPen

    font = _font()
    with _READING:
        name = font.getBestCmap().get(ord(character))
        if name is None:
            family = font["name"].getDebugName(4)
            raise ValueError(
                f"the font {family} has no character {character!r} (U+{ord(character):04X}): spell it with "
                "others, or draw it with polygon() or details.icon()"
            )
        glyphs = font.getGlyphSet()
        pen = DecomposingRecordingPen(glyphs)
        glyphs[name].draw(pen)
        unit, width = 1.0 / font["OS/2"].sCapHeight, glyphs[name].width
    contours = [_contour(curves) for curves in _borders(pen.value)]
    kept = (contour for contour in contours if contour is not None)
    scaled = tuple(Contour(each.points * unit, each.normals_in, each.normals_out) for each in kept)
    return scaled, width * unit


def _borders(drawing: Sequence[tuple[str, tuple[Any, ...]]]) -> Iterator[list[Array]]:
    """Yield the lines (2 points) and quadratic curves (3 points) of each recorded border."""
    from fontTools.pens.basePen import decomposeQuadraticSegment

    curves: list[Array] = []
    at = start = (0.0, 0.0)
    for verb, arguments in drawing:
        if verb == "moveTo":
            at = start = arguments[0]
            curves = []
        elif verb == "lineTo":
            curves.append(np.array([at, arguments[0]], float))
            at = arguments[0]
        elif verb == "qCurveTo":
            if arguments[-1] is None:  # a border of control points alone starts between two of them
                last, first = arguments[-2], arguments[0]
                at = start = (0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1]))
                curves = []
            knots = arguments if arguments[-1] is not None else (*arguments[:-1], start)
            for control, end in decomposeQuadraticSegment(knots):
                curves.append(np.array([at, control, end], float))
                at = end
        else:
            if at != start:
                curves.append(np.array([at, start], float))
            yield [curve for curve in curves if np.abs(np.diff(curve, axis=0)).max() > 0.0]


def _text(string: str, height: float, align: Literal["left", "center", "right"]) -> Outline:
    check.positive("height", height)
    contours: list[Contour] = []
    pen = 0.0
    for character in string:
        glyph, advance = _glyph(character)
        contours.extend(
            Contour(one.points + np.array([pen, 0.0]), one.normals_in, one.normals_out) for one in glyph
        )
        pen += advance
    if not contours:
        raise ValueError(f"the text {string!r} has nothing to show")
    outline = Outline(tuple(contours))
    if not is_disjoint([contour.points for contour in contours]):
        # parts of a letter overlap, such as a crossed stroke
        outline = outline_of(section(outline.contours), f"the text {string!r}")
    shift = {"left": 0.0, "center": -0.5 * pen, "right": -pen}[align]
    rise = -0.5 if align == "center" else 0.0
    return moved_outline(outline, np.eye(2) * height, np.array([shift, rise]) * height)


@records(_text)
def text(string: str, height: Scalar, *, align: Literal["left", "center", "right"] = "center") -> Profile:
    """Make the outlines of a line of text in Roboto Medium.

    Args:
        string: The text, known while building.
        height: Height of the capital letters [m].
        align: `center` centers the line on the origin in both directions; `left` and `right` put that end of
            the base line on the origin.

    Examples:
        >>> text("Push 42", 0.02)
    """


def text_width(string: str) -> float:
    """Return the length of a line of text, in heights of its capital letters.

    Examples:
        >>> width = 0.02 * text_width("PUSH") + 0.02
        >>> extrude(rectangle(width, 0.04) - text("PUSH", 0.02), 0.004, axis=-Y)
    """
    return sum(_glyph(character)[1] for character in string)
