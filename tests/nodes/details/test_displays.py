"""Segments, dots, displays and rating plates."""

import numpy as np
import pytest

from artgen.errors import BuildError, EvaluationError
from artgen.graph.evaluation import Cache, evaluate
from artgen.nodes.contours import is_disjoint, outline_area
from artgen.nodes.details import display, dot_matrix, rating_plate, relief, seven_segment
from artgen.nodes.details.dots import FONT, dot_matrix_width
from artgen.nodes.details.segments import FIGURES, has_dark_segments, seven_segment_width
from support.shapes import check_shape


def value(handle):
    return evaluate(handle, {}, Cache()).value


def points(outline):
    return np.concatenate([contour.points for contour in outline.contours])


def millimetres(outline):
    return [1e3 * contour.points for contour in outline.contours]


@pytest.mark.parametrize("character", [character for character in FIGURES if FIGURES[character]])
def test_lit_and_dark_segments_make_an_eight(character):
    lit = value(seven_segment(character, 0.02))
    whole = value(seven_segment(character, 0.02, show="all"))
    assert len(lit.contours) == len(set(FIGURES[character]))
    assert len(whole.contours) == 7
    assert is_disjoint(millimetres(whole))
    if has_dark_segments(character):
        dark = value(seven_segment(character, 0.02, show="dark"))
        assert len(lit.contours) + len(dark.contours) == 7
        total = outline_area(lit.contours) + outline_area(dark.contours)
        assert total == pytest.approx(outline_area(whole.contours), rel=1e-9)


def test_figures_have_the_height_and_the_width():
    outline = value(seven_segment("88:88", 0.02, slant=0.0))
    size = np.ptp(points(outline), axis=0)
    assert size[1] == pytest.approx(0.02, rel=1e-6)
    assert size[0] == pytest.approx(seven_segment_width("88:88") * 0.02, rel=1e-6)
    assert len(outline.contours) == 4 * 7 + 2
    leaning = points(value(seven_segment("8", 0.02, slant=0.2)))
    assert leaning[np.argmax(leaning[:, 1]), 0] > leaning[np.argmin(leaning[:, 1]), 0]


def test_seven_is_not_mirrored():
    middle = points(value(seven_segment("7", 0.02, slant=0.0)))
    assert middle[middle[:, 1] < 0.0, 0].min() > 0.0, "its foot is on the right"


def test_characters_that_segments_cannot_show_are_named():
    with pytest.raises(
        EvaluationError, match=r"no character 'm' \(U\+006D\) of '12 pm'; it shows .*dot_matrix"
    ):
        value(seven_segment("12 pm", 0.02))
    with pytest.raises(EvaluationError, match="no segment of '88' is dark: all of them are lit"):
        value(seven_segment("88", 0.02, show="dark"))
    with pytest.raises(EvaluationError, match="needs at least one character, got ''"):
        value(seven_segment("", 0.02))


def test_every_dot_character_differs_and_fits():
    assert len(set(FONT.values())) == len(FONT) >= 50
    for character, rows in FONT.items():
        assert len(rows) == 7, character
        assert 0 <= min(rows) <= max(rows) < 32, character
        assert character == " " or max(rows) > 0, character


@pytest.mark.parametrize("dot", ["square", "round"])
def test_dots_are_apart_and_stand_in_their_cells(dot):
    outline = value(dot_matrix("AL 5", 0.014, dot=dot))
    count = sum(row.bit_count() for character in "AL 5" for row in FONT[character])
    assert len(outline.contours) == count
    assert is_disjoint(millimetres(outline))
    size = np.ptp(points(outline), axis=0)
    assert size[0] == pytest.approx(dot_matrix_width("AL 5") * 0.014, rel=0.03)
    dark = value(dot_matrix("AL 5", 0.014, dot=dot, show="dark"))
    assert count + len(dark.contours) == 7 * (4 * 6 - 1)
    shape = value(relief(dot_matrix("AL 5", 0.014, dot=dot)))
    check_shape(shape, covered=False)
    assert shape.manifold.volume() == pytest.approx(0.0008 * outline_area(outline.contours), rel=1e-4)


def test_the_dots_of_an_l_read_the_right_way():
    middles = np.array([each.points.mean(axis=0) for each in value(dot_matrix("L", 0.007)).contours])
    upper = middles[middles[:, 1] > 0.0005]
    assert (upper[:, 0] < -0.0015).all(), "its mast is on the left"
    assert (middles[:, 1] < -0.0025).sum() == 5, "its foot is below"


def test_a_missing_dot_character_is_named_with_the_remedy():
    with pytest.raises(
        EvaluationError, match=r"5x7 dot font has no character 'e' \(U\+0065\) of 'He'; write 'E'"
    ):
        value(dot_matrix("He", 0.01))
    with pytest.raises(EvaluationError, match=r"no character '界' \(U\+754C\).*use text"):
        value(dot_matrix("界", 0.01))


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


def test_a_dark_display_and_one_without_ghosts():
    assert len(value(display("", 0.05, 0.02)).link.pieces) == 1
    assert len(value(display("88", 0.05, 0.02)).link.pieces) == 2
    assert len(value(display("PIZZA", 0.05, 0.02, style="dot_matrix", ghosts=False)).link.pieces) == 2


def test_a_display_names_what_it_cannot_show_while_building():
    with pytest.raises(BuildError, match="no character 'x'") as caught:
        display("1x", 0.05, 0.02)
    assert "test_displays.py" in str(caught.value)
    with pytest.raises(BuildError, match="no character 'x'"):
        display("1x", 0.05, 0.02, style="dot_matrix")


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
