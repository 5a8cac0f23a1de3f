"""Print, icons, lettering and dials: they read the right way round, fit, and say what is wrong."""

import math
from typing import get_args

import numpy as np
import pytest

from artgen.errors import BuildError, EvaluationError
from artgen.graph.evaluation import Cache, evaluate
from artgen.materials import material
from artgen.nodes.contours import is_disjoint, section
from artgen.nodes.details import (
    BRANDS,
    ICONS,
    dial_band,
    dial_icons,
    dial_scale,
    emblem,
    engraved,
    icon,
    lettering,
    lettering_width,
    logo,
    pointer,
    printed,
    raised,
    relief,
    wrap,
    wrapped,
)
from artgen.nodes.details.icons import icon_outline
from artgen.nodes.details.lettering import Emblem
from artgen.nodes.path import line
from artgen.nodes.profile import circle, polygon, rectangle
from artgen.nodes.text import text
from support.shapes import check_shape, outline_area, same_bytes

INK = material("black_abs")
EMBLEMS = tuple(name for name in get_args(Emblem) if name != "none")
FLAG = polygon([(0.0, 0.0), (0.03, 0.0), (0.0, 0.01)])
FACES = [
    ((0.0, -1.0, 0.0), (1, 0, 0), (0, 0, 1)),
    ((0.0, 1.0, 0.0), (-1, 0, 0), (0, 0, 1)),
    ((1.0, 0.0, 0.0), (0, 1, 0), (0, 0, 1)),
    ((-1.0, 0.0, 0.0), (0, -1, 0), (0, 0, 1)),
    ((0.0, 0.0, 1.0), (1, 0, 0), (0, 1, 0)),
    ((0.0, 0.0, -1.0), (-1, 0, 0), (0, 1, 0)),
]


def value(handle):
    return evaluate(handle, {}, Cache()).value


def points(outline):
    return np.concatenate([contour.points for contour in outline.contours])


@pytest.mark.parametrize(("facing", "right", "up"), FACES)
def test_print_is_not_mirrored_on_any_face(facing, right, up):
    at = np.array([0.1, 0.2, 0.3])
    shape = value(relief(FLAG, tuple(at), facing=facing, proud=0.001, sunk=0.002))
    check_shape(shape)
    local = (shape.mesh.vertices - at) @ np.array([right, up, facing], float).T
    np.testing.assert_allclose(local.min(axis=0), [0.0, 0.0, -0.002], atol=1e-9)
    np.testing.assert_allclose(local.max(axis=0), [0.03, 0.01, 0.001], atol=1e-9)
    # the long foot of the flag points to the right of who reads it, its mast is on the left
    assert local[np.argmax(local[:, 0]), 1] == pytest.approx(0.0, abs=1e-9)
    assert local[np.argmax(local[:, 1]), 0] == pytest.approx(0.0, abs=1e-9)


def test_up_along_facing_is_refused():
    with pytest.raises(EvaluationError, match=r"up \(0, 2, 0\) runs along facing: it must point upward"):
        value(relief(FLAG, up=(0.0, 2.0, 0.0)))


@pytest.mark.parametrize("profile", [rectangle(0.02, 0.01) - circle(0.003), text("B8&", 0.01), circle(0.004)])
def test_sharp_and_soft_reliefs_are_solids(profile):
    flat = value(relief(profile, proud=0.0004, sunk=0.0004))
    soft = value(relief(profile, proud=0.0004, sunk=0.0004, bevel=0.0002))
    for shape in (flat, soft):
        check_shape(shape, covered=False)
    area = outline_area(value(profile).contours)
    assert flat.manifold.volume() == pytest.approx(0.0008 * area, rel=1e-4)
    assert 0.8 * flat.manifold.volume() < soft.manifold.volume() < flat.manifold.volume()


def test_a_bevel_that_does_not_fit_shrinks():
    thin = rectangle(0.0003, 0.01)
    sharp = value(relief(thin, proud=0.0004, sunk=0.0004))
    soft = value(relief(thin, proud=0.0004, sunk=0.0004, bevel=0.0003))
    assert 0.9 < soft.manifold.volume() / sharp.manifold.volume() < 1.0


@pytest.mark.parametrize("make", [printed, raised, engraved])
def test_ink_has_neither_mass_nor_collider_and_stands_out_of_the_face(make):
    (piece,) = value(make(text("On", 0.004), (0.0, -0.05, 0.0), material=INK)).link.pieces
    assert piece.visual
    assert piece.label == "print"
    low, high = piece.shape.bounds()
    assert 0.00009 < -0.05 - low[1] < 0.0006
    assert high[1] > -0.05 + 0.00009


@pytest.mark.parametrize("name", ICONS)
def test_icons_fill_their_square(name):
    for weight in ("light", "regular", "bold"):
        outline = icon_outline(name, 20.0, weight)
        assert is_disjoint([contour.points for contour in outline.contours])
        assert outline_area(outline.contours) > (5.0 if name == "minus" else 14.0)
    reach = np.ptp(points(icon_outline(name, 20.0, "regular")), axis=0)
    assert 15.0 < reach.max() <= 20.5, f"{name} spans {reach}"
    assert np.abs(points(icon_outline(name, 20.0, "bold"))).max() <= 10.6, name
    assert len(points(icon_outline(name, 20.0, "regular"))) < 300, "more than 1200 triangles"


@pytest.mark.parametrize(
    "name", ["power", "pause", "plus", "warning", "lock", "light", "glass", "drop", "snowflake", "wheat"]
)
def test_symmetric_icons_are_symmetric(name):
    region = section(icon_outline(name, 20.0, "regular").contours)
    if name == "drop":  # but for its glint
        region = (
            region.decompose()[0]
            if len(region.decompose()) == 1
            else max(region.decompose(), key=lambda r: r.area())
        )
    difference = (region - region.mirror((1.0, 0.0))).area()
    assert difference < 0.01 * region.area()


def test_icons_scale_and_extrude():
    outline = value(icon("power", 0.012))
    assert np.ptp(points(outline), axis=0).max() == pytest.approx(0.012, rel=0.1)
    check_shape(value(relief(icon("child_lock", 0.012))), covered=False)
    assert same_bytes(value(relief(icon("fan", 0.01))), value(relief(icon("fan", 0.01))))


def test_there_are_many_icons():
    assert len(ICONS) >= 60
    wanted = (
        "power timer clock fan light child_lock lock unlock key drop snowflake flame steam defrost plus minus"
    )
    assert set(wanted.split()) <= set(ICONS)


def test_an_unknown_icon_names_the_nearest_and_the_line():
    with pytest.raises(
        BuildError, match=r"there is no icon 'snowflak'. Did you mean 'snowflake'\?"
    ) as caught:
        icon("snowflak", 0.01)
    assert "test_print.py" in str(caught.value)


def test_lettering_is_as_wide_as_it_says():
    plain, spaced = (points(value(lettering(("HOH",), 0.01, tracking=by))) for by in (0.0, 0.4))
    assert np.ptp(spaced[:, 0]) - np.ptp(plain[:, 0]) == pytest.approx(0.008, rel=1e-6)
    assert (lettering_width("HOH", 0.4) - lettering_width("HOH")) == pytest.approx(0.8)
    rows = points(value(lettering(("HH", "HH", "HH"), 0.01, leading=2.0)))
    assert np.ptp(rows[:, 1]) == pytest.approx(0.05, rel=1e-3)
    assert rows[:, 1].mean() == pytest.approx(0.0, abs=1e-4)


def test_coarse_letters_are_cheap_and_keep_their_area():
    fine, coarse = (value(lettering(("Model 230 S&g",), 0.002, fineness=each)) for each in ("fine", "coarse"))
    assert len(points(coarse)) < 0.6 * len(points(fine))
    assert outline_area(coarse.contours) == pytest.approx(outline_area(fine.contours), rel=0.05)


def test_a_missing_character_of_lettering_is_named():
    with pytest.raises(EvaluationError, match=r"Roboto Medium has no character '界' \(U\+754C\)"):
        value(lettering(("a界",), 0.01))


def test_marks_of_all_brands():
    assert len(set(BRANDS)) == len(BRANDS) >= 12
    for name, sign in zip(BRANDS, [*EMBLEMS, "none"] * 2, strict=False):
        outline = value(logo(name, 0.006, sign=sign))
        assert is_disjoint([1e3 * contour.points for contour in outline.contours]), (name, sign)
        low, high = points(outline).min(axis=0), points(outline).max(axis=0)
        assert (low[0] + high[0]) / 2 == pytest.approx(0.0, abs=0.001)
    for sign in EMBLEMS:
        assert np.abs(points(value(emblem(sign, 0.02)))).max() <= 0.0125


def test_scales_run_clockwise_from_the_lower_left():
    outline = value(dial_scale(0.02, 11, length=0.002, major_length=0.002, numbers=()))
    middles = np.array([contour.points.mean(axis=0) for contour in outline.contours])
    np.testing.assert_allclose(np.linalg.norm(middles, axis=1), 0.021, rtol=1e-6)
    angle = np.unwrap(np.arctan2(middles[:, 0], middles[:, 1]))
    np.testing.assert_allclose(np.diff(angle), math.radians(27.0), rtol=1e-6)
    assert middles[0, 0] < 0.0 > middles[0, 1]
    np.testing.assert_allclose(middles[5], [0.0, 0.021], atol=1e-9)


def test_a_full_circle_does_not_repeat_its_first_tick():
    outline = value(dial_scale(0.02, 12, sweep=math.tau))
    middles = np.array([contour.points.mean(axis=0) for contour in outline.contours])
    gaps = np.linalg.norm(middles - np.roll(middles, 1, axis=0), axis=1)
    assert gaps.min() == pytest.approx(gaps.max(), rel=1e-6)


def test_numbers_stand_clear_of_ticks_and_each_other():
    numbers = [str(number) for number in range(0, 275, 25)]
    dial = dial_scale(0.02, 31, major_every=3, numbers=numbers)
    outline = value(dial)
    assert is_disjoint([1e3 * contour.points for contour in outline.contours])
    reach = np.linalg.norm(points(outline), axis=1)
    assert reach.min() >= 0.02 - 1e-9
    assert sum(np.linalg.norm(c.points, axis=1).min() > 0.0233 for c in outline.contours) >= len(numbers)


def test_dials_say_what_does_not_fit():
    with pytest.raises(EvaluationError, match=r"3 numbers for 11 long ticks \(every 1 of 11\)"):
        value(dial_scale(0.02, 11, numbers=("0", "1", "2")))
    with pytest.raises(EvaluationError, match=r"400 ticks 0.4 mm wide do not fit: on a radius of 20 mm"):
        value(dial_scale(0.02, 400))
    with pytest.raises(EvaluationError, match="3 icons 50 mm high overlap"):
        value(dial_icons(("fan", "light", "timer"), 0.02, 0.05))
    with pytest.raises(EvaluationError, match=r"there is no icon 'fann'. Did you mean 'fan'"):
        value(dial_icons(("fann", "light"), 0.02, 0.005))
    with pytest.raises(EvaluationError, match="a dial has at least 2 places, got 1"):
        value(dial_scale(0.02, 1))


def test_bands_grow_clockwise_and_pointers_point_up():
    band = points(value(dial_band(0.02, 0.001, 0.004)))
    reach = np.linalg.norm(band, axis=1)
    assert reach.max() == pytest.approx(0.024, rel=1e-6)
    assert band[np.argmax(reach), 0] > 0.0, "its wide end is on the right"
    for style in ("line", "triangle", "dot"):
        mark = points(value(pointer(0.005, 0.015, 0.001, style=style)))
        assert mark[:, 1].max() == pytest.approx(0.015, rel=1e-6)
        assert np.abs(mark[:, 0]).max() == pytest.approx(0.0005, rel=1e-6)


def test_wrapped_print_lies_on_a_turned_wall_and_reads_to_the_right() -> None:
    wall = line((0.03, 0.0, 0.0), (0.02, 0.0, 0.1))
    print_ = evaluate(wrap(rectangle(0.03, 0.01).at(0.005, 0.0), wall, 0.05, proud=0.0002)).value
    x, y, z = np.asarray(print_.mesh.vertices).T
    radius, own = np.hypot(x, y), 0.03 - 0.1 * z
    assert np.abs(radius - own).max() == pytest.approx(0.0002, abs=1e-6)
    assert y.max() < 0.0
    assert 0.045 - 1e-9 <= z.min() <= z.max() <= 0.055 + 1e-9
    assert x.max() == pytest.approx(0.0255 * math.sin(0.02 / 0.025), abs=4e-4)
    assert x.min() == pytest.approx(-0.0255 * math.sin(0.01 / 0.025), abs=4e-4)
    check_shape(print_)


@pytest.mark.parametrize(
    ("height", "wide", "message"), [(0.002, 0.01, "the line only from"), (0.05, 0.3, "more than once around")]
)
def test_print_that_does_not_fit_around_is_refused(height: float, wide: float, message: str) -> None:
    wall = line((0.03, 0.0, 0.0), (0.03, 0.0, 0.1))
    with pytest.raises(EvaluationError, match=message):
        evaluate(wrapped(rectangle(wide, 0.01), wall, height, material=INK))
