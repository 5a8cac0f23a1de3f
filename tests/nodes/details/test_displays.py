"""Displays and rating plates."""

import numpy as np
import pytest

from artgen.errors import BuildError
from artgen.graph.evaluation import Cache, evaluate
from artgen.nodes.contours import is_disjoint
from artgen.nodes.details import display, rating_plate
from artgen.nodes.details.displays import FIGURES, figures
from support.shapes import check_shape, outline_area


def value(handle):
    return evaluate(handle, {}, Cache()).value


def points(outline):
    return np.concatenate([contour.points for contour in outline.contours])


@pytest.mark.parametrize("character", [character for character in FIGURES if FIGURES[character]])
def test_lit_and_dark_segments_make_an_eight(character):
    eight = value(figures("8", 0.02, lit=True))
    lit = value(figures(character, 0.02, lit=True))
    dark = value(figures(character, 0.02, lit=False)) if len(FIGURES[character]) < 7 else None
    both = [*lit.contours, *(dark.contours if dark else ())]
    assert len(lit.contours) == len(set(FIGURES[character]))
    assert len(both) == 7
    assert is_disjoint([1e3 * contour.points for contour in both])
    assert outline_area(both) == pytest.approx(outline_area(eight.contours), rel=1e-9)


def test_figures_have_the_height_and_lean_to_the_right():
    outline = value(figures("88:88", 0.02, lit=True))
    size = np.ptp(points(outline), axis=0)
    assert size[1] == pytest.approx(0.02, rel=1e-6)
    assert len(outline.contours) == 4 * 7 + 2
    leaning = points(value(figures("8", 0.02, lit=True)))
    assert leaning[np.argmax(leaning[:, 1]), 0] > leaning[np.argmin(leaning[:, 1]), 0]


def test_seven_is_not_mirrored():
    middle = points(value(figures("7", 0.02, lit=True)))
    assert middle[middle[:, 1] < 0.0, 0].min() > 0.0, "its foot is on the right"


def test_a_display_without_dark_segments_has_no_piece_for_them():
    assert len(value(display("88", 0.05, 0.02)).link.pieces) == 2
    assert len(value(display("", 0.05, 0.02)).link.pieces) == 1


@pytest.mark.parametrize("color", ["red", "amber", "green", "blue", "white", "cyan", "lcd"])
def test_displays_shine_and_stay_in_their_pane(color):
    body = value(display("12:30", 0.05, 0.02, at=(0.1, -0.2, 0.3), color=color))
    pane, lit, dark = body.link.pieces
    assert all(piece.visual for piece in body.link.pieces)
    assert (max(lit.material.emission) > 0.3) == (color != "lcd")
    assert max(pane.material.emission) == max(dark.material.emission) == 0.0
    assert len({piece.material.name for piece in body.link.pieces}) == 3
    low, high = pane.shape.bounds()
    np.testing.assert_allclose((low + high)[[0, 2]] / 2, [0.1, 0.3], atol=1e-9)
    for piece in (lit, dark):
        check_shape(piece.shape, covered=False)
        inner_low, inner_high = piece.shape.bounds()
        assert inner_low[0] > low[0]
        assert inner_high[0] < high[0]
        assert inner_low[2] > low[2]
        assert inner_high[2] < high[2]
        assert 5e-5 < low[1] - inner_low[1] < 2e-4, "the figures stand out of the pane"


def test_figures_shrink_to_the_width_of_the_pane():
    _, lit, _ = value(display("12345678", 0.03, 0.02)).link.pieces
    assert np.ptp(lit.shape.bounds(), axis=0)[0] < 0.03


def test_a_display_names_what_it_cannot_show_while_building():
    with pytest.raises(
        BuildError, match=r"no character 'm' \(U\+006D\) of '12 pm'; it shows .* use text"
    ) as caught:
        display("12 pm", 0.05, 0.02)
    assert "test_displays.py" in str(caught.value)


LINES = ("ORMIVELD", "Model KX-420 B", "220-240 V~  50/60 Hz", "1850 W    IPX1", "S/N 240817-00421")


def test_a_rating_plate_is_cheap_and_inside_its_border():
    plate, *films = value(rating_plate(0.07, 0.042, LINES)).link.pieces
    assert sum(len(piece.shape.mesh.triangles) for piece in (plate, *films)) < 4000
    low, high = plate.shape.bounds()
    for piece in (plate, *films):
        assert piece.visual
        check_shape(piece.shape, covered=False)
    for film in films:
        inner_low, inner_high = film.shape.bounds()
        assert (inner_low[[0, 2]] > low[[0, 2]]).all()
        assert (inner_high[[0, 2]] < high[[0, 2]]).all()


@pytest.mark.parametrize("lines", [(), ("  ",), ("x" * 100,)])
def test_a_rating_plate_has_some_letters_but_not_too_many(lines):
    with pytest.raises(BuildError, match=r"1 to 90 letters, got (0|100)"):
        rating_plate(0.07, 0.04, lines)


def test_a_display_shines_in_known_colors_only():
    with pytest.raises(
        BuildError, match=r"cannot shine in 'ambre'\. Did you mean 'amber'\?\n  at .*test_displays"
    ):
        display("12", 0.05, 0.02, color="ambre")
