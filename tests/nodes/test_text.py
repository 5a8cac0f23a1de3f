import numpy as np
import pytest

from artgen.nodes import extrude, text
from artgen.nodes.contours import signed_area
from support.shapes import Y, check_shape


def bounds(outline):
    points = np.concatenate([contour.points for contour in outline.contours])
    return points.min(axis=0), points.max(axis=0)


def test_capitals_have_the_height():
    low, high = bounds(text._text("HE", 0.01, "left"))
    assert low[1] == pytest.approx(0.0, abs=1e-9)
    assert high[1] == pytest.approx(0.01, rel=1e-6)
    assert low[0] > 0.0


@pytest.mark.parametrize(("align", "middle"), [("left", 0.5), ("center", 0.0), ("right", -0.5)])
def test_alignment_moves_the_line(align, middle):
    low, high = bounds(text._text("HOH", 0.01, align))
    assert (low[0] + high[0]) / 2 == pytest.approx(middle * text.text_width("HOH") * 0.01, abs=2e-4)
    center = (low[1] + high[1]) / 2
    assert center == pytest.approx(0.0 if align == "center" else 0.005, abs=3e-4)


def test_letters_with_holes_have_them():
    outline = text._text("o8i", 0.01, "left")
    assert sorted(signed_area(contour.points) > 0.0 for contour in outline.contours) == [
        *[False] * 3, *[True] * 4,
    ]  # fmt: skip


def test_curves_are_smooth_and_corners_sharp():
    round_letter = text._text("O", 0.01, "left").contours[0]
    assert np.einsum("ij,ij->i", round_letter.normals_in, round_letter.normals_out).min() > 0.999
    straight = text._text("I", 0.01, "left").contours[0]
    assert len(straight.points) == 4
    assert np.abs(np.einsum("ij,ij->i", straight.normals_in, straight.normals_out)).max() < 1e-9


@pytest.mark.parametrize("string", ["Power 100%", "Åßé@ &", "0123456789°C"])
def test_text_extrudes_to_a_solid(string):
    outline = text._text(string, 0.008, "center")
    check_shape(extrude._extrude(outline, 0.0006, -Y, 0.0, 0.0, 0.0), covered=False)


def test_a_missing_character_is_named_with_the_font():
    with pytest.raises(ValueError, match=r"no character '界' \(U\+754C\): spell it with others, or draw it"):
        text._text("a界", 0.01, "left")


def test_blank_text_is_refused():
    with pytest.raises(ValueError, match="the text ' ' has nothing to show"):
        text._text(" ", 0.01, "left")
