"""Shades: a material drawn anew for each asset."""

import numpy as np
import pytest

from artgen import Body, Material, box, by, category, choice, material, part, shades
from artgen.errors import ParameterError
from artgen.generator.declare import CATEGORIES


def _drawn(distribution, count=200):
    stream = np.random.default_rng(5)
    return [distribution.draw(stream, {}) for _ in range(count)]


def test_shades_stay_within_their_spread():
    base = material("painted_wood")
    for made in _drawn(shades(base, color=0.1, roughness=0.05)):
        ratio = np.array(made.base_color) / np.array(base.base_color)
        assert ratio.max() < 1.1 * 1.03
        assert ratio.min() > 0.9 * 0.97
        assert abs(made.specular_roughness - base.specular_roughness) <= 0.05 + 1e-4
        assert (made.density, made.friction) == (base.density, base.friction)


def test_shades_differ_and_equal_names_mean_equal_materials():
    made = _drawn(shades("oak", "walnut"))
    assert len({each.base_color for each in made}) > 100
    assert {each.name.rpartition("_")[0] for each in made} == {"oak", "walnut"}
    by_name = {}
    assert all(by_name.setdefault(each.name, each) == each for each in made)


def test_no_spread_keeps_the_color():
    base = material("brass")
    assert {each.base_color for each in _drawn(shades(base, color=0.0))} == {base.base_color}


def test_the_support_lists_the_materials_themselves():
    distribution = shades("oak", "walnut")
    assert distribution.support() == (material("oak"), material("walnut"))


def test_a_mapping_has_the_materials_with_their_weights():
    assert shades({"oak": 0.7, "walnut": 0.3}) == shades("oak", "walnut", weights=(0.7, 0.3))


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (("oka",), {}, r"there is no material 'oka'\. Did you mean 'oak'\?"),
        ((), {}, r"choice needs at least one option"),
        (({"oak": 1.0},), {"weights": (1.0,)}, r"shades takes the weights from its mapping"),
        (("oak",), {"color": 2.0}, r"shades: color = 2\.0 must be in 0\.\.1"),
        (("oak",), {"roughness": -0.1}, r"shades: roughness = -0\.1 must be in 0\.\.1"),
    ],
)
def test_what_cannot_be_drawn_is_refused(arguments, options, message):
    with pytest.raises(ParameterError, match=message):
        shades(*arguments, **options)


def test_a_category_draws_shades_and_takes_plain_materials_instead():
    try:

        @category(labels=("board",))
        def shaded_board(
            *,
            use: str = choice("in", "out"),
            finish: Material = by("use", {"in": shades("oak"), "out": shades("walnut")}),
        ) -> Body:
            return part(box(0.1, 0.02, 0.5), "board", finish)

        colors = {shaded_board.generate(seed).materials[0].base_color for seed in range(8)}
        assert len(colors) == 8
        again = shaded_board.generate(3).materials[0]
        assert again == shaded_board.generate(3).materials[0]
        assert shaded_board.generate(3, finish="brass").materials == (material("brass"),)
    finally:
        CATEGORIES.pop("shaded_board", None)
