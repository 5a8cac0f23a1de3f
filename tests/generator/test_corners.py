"""Corners of parameter ranges: which ends are combined, with which options."""

from typing import Literal

import pytest

from artgen import catalog
from artgen.errors import ParameterError
from artgen.generator import Generator, generator, one_of
from artgen.generator.corners import MOST_CORNERS, corners
from artgen.materials import Material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Bool, Float, Solid
from artgen.nodes.primitive import box, sphere
from artgen.sampling import by, choice, count, fixed, loguniform, truncated_normal, uniform
from support.generators import OAK


@generator
def ball(*, radius: Float = uniform(0.01, 0.02, "m")) -> Solid:
    return sphere(radius)


@generator
def block(*, width: Float = uniform(0.03, 0.04, "m")) -> Solid:
    return box(width, width, width)


@generator
def plain(
    *,
    width: Float = uniform(0.5, 1.0, "m"),
    height: Float = truncated_normal(1.0, 0.1, 0.75, 1.5, "m"),
    ratio: Float = loguniform(0.25, 4.0),
    depth: Float = 0.3,
    still: Float = uniform(0.2, 0.2),
    step: Float = choice(0.1, 0.2),
) -> Body:
    return part(box(width, depth, height), "block", OAK)


@generator
def chooses(
    *,
    layout: Literal["french", "single"] = choice("french", "single"),
    swing: Float = by("layout", french=uniform(1.0, 1.25), single=2.0),
    grip: Generator = one_of(ball, block),
    wood: Material = choice("oak", "walnut"),
    shiny: Bool = choice(True, False),
    shelves: int = count(1, 3),
) -> Body:
    return part(grip(), "block", wood)


def many(numbers):
    """Return a generator with that many numbers that vary, from 0 to 1."""
    parameters = ", ".join(f"p{index:03d}: Float = uniform(0.0, 1.0)" for index in range(numbers))
    namespace = {"Float": Float, "Body": Body, "uniform": uniform, "part": part, "box": box, "OAK": OAK}
    code = f"def many(*, {parameters}) -> Body:\n    return part(box(1.0, 1.0, 1.0), 'box', OAK)"
    exec(code, namespace)  # noqa: S102 - its own text
    return generator(namespace["many"])


def test_few_numbers_are_combined_in_every_way():
    found = corners(plain, 0, {})
    assert all(point["depth"] == 0.3 and point["still"] == 0.2 for point in found)
    ends = {(point["width"], point["height"], point["ratio"]) for point in found}
    assert ends == {(w, h, r) for w in (0.5, 1.0) for h in (0.75, 1.5) for r in (0.25, 4.0)}
    # each with each of the options
    assert {(point["width"], point["step"]) for point in found} == {
        (w, s) for w in (0.5, 1.0) for s in (0.1, 0.2)
    }
    assert len(found) == 16


def test_overrides_change_the_ranges():
    overrides = {"width": 0.7, "height": uniform(1.0, 1.1), "step": 0.1}
    found = corners(plain, 0, overrides)
    assert {point["width"] for point in found} == {0.7}
    assert {point["height"] for point in found} == {1.0, 1.1}
    assert len(found) == 4


def test_overrides_reach_the_numbers_of_a_sub_generator():
    found = corners(chooses, 0, {"grip": "ball", "grip.ball.radius": uniform(0.02, 0.03), "layout": "single"})
    assert {point["grip.radius"] for point in found} == {0.02, 0.03}


def test_ends_are_those_of_the_options_that_were_drawn():
    found = corners(chooses, 0, {})
    assert len(found) > 32
    seen = set()
    for point in found:
        names = {"ball": "grip.radius", "block": "grip.width"}
        inner = names[point["grip"].name]
        assert set(names.values()) & set(point) == {inner}
        assert point[inner] in ((0.01, 0.02) if inner == "grip.radius" else (0.03, 0.04))
        assert point["swing"] in ((1.0, 1.25) if point["layout"] == "french" else (2.0,))
        seen.add((point["layout"], point["swing"], inner, point[inner]))
    assert len(seen) == (2 + 1) * (2 + 2)


def test_no_corner_comes_twice():
    found = corners(chooses, 0, {})
    assert all(point not in found[:index] for index, point in enumerate(found))


def test_eight_numbers_are_exact_and_nine_are_not():
    eight = corners(many(8), 0, {})
    assert len({tuple(point.values()) for point in eight}) == 2**8
    assert {value for point in eight for value in point.values()} == {0.0, 1.0}
    assert len(corners(many(9), 0, {"p000": uniform(0.5, 0.5)})) == 2**8  # a range without width is none
    nine = corners(many(9), 0, {})
    drawn = many(9).sample(0)
    for name in drawn:
        for end in (0.0, 1.0):
            assert {**drawn, name: end} in nine
    assert dict.fromkeys(drawn, 0.0) in nine
    assert dict.fromkeys(drawn, 1.0) in nine
    assert len(nine) <= MOST_CORNERS
    whole = [point for point in nine if set(point.values()) <= {0.0, 1.0}]
    assert len(whole) > 100
    shares = [sum(point[name] for point in whole) / len(whole) for name in drawn]
    assert all(0.3 < share < 0.7 for share in shares)


def test_all_ends_of_one_kind_are_a_corner():
    twenty = corners(many(20), 0, {})
    for end in (0.0, 1.0):
        assert dict.fromkeys(many(20).own, end) in twenty


def test_each_number_is_at_its_ends_alone_with_options_that_have_it():
    @generator
    def varied(
        *,
        a: Float = uniform(0.0, 1.0),
        b: Float = uniform(0.0, 1.0),
        c: Float = uniform(0.0, 1.0),
        d: Float = uniform(0.0, 1.0),
        e: Float = uniform(0.0, 1.0),
        f: Float = uniform(0.0, 1.0),
        g: Float = uniform(0.0, 1.0),
        grip: Generator = one_of(ball, block),
    ) -> Body:
        return part(grip(), "block", OAK)

    ends = dict.fromkeys("abcdefg", (0.0, 1.0)) | {"grip.radius": (0.01, 0.02), "grip.width": (0.03, 0.04)}
    alone = []
    for point in corners(varied, 0, {}):
        at_end = [(name, point[name]) for name in ends if name in point and point[name] in ends[name]]
        alone += at_end if len(at_end) == 1 else []
    assert set(alone) == {(name, end) for name, pair in ends.items() for end in pair}


def test_very_many_numbers_keep_to_the_most():
    assert len(corners(many(200), 0, {})) == MOST_CORNERS


def test_they_are_the_same_each_time_and_combined_ends_do_not_depend_on_the_seed():
    assert corners(many(9), 3, {}) == corners(many(9), 3, {})
    ends = [
        [point for point in corners(many(9), seed, {}) if set(point.values()) <= {0.0, 1.0}]
        for seed in (3, 4)
    ]
    assert ends[0] == ends[1]


def test_where_no_number_varies_there_are_none():
    @generator
    def rigid(*, depth: Float = fixed(0.3, "m"), wood: Material = choice("oak", "walnut")) -> Body:
        return part(box(1.0, depth, 1.0), "block", wood)

    assert corners(rigid, 0, {}) == []


@pytest.mark.long
def test_each_corner_is_a_sample_that_a_user_can_ask_for():
    for name in catalog.categories():
        category = catalog.find(name)
        found = corners(category, 5, {})
        assert 0 < len(found) <= MOST_CORNERS
        for point in found[::16]:
            assert category.sample(0, overrides=point) == point


def test_an_unknown_override_is_refused():
    with pytest.raises(ParameterError, match="plain has no parameter 'widht'"):
        corners(plain, 0, {"widht": 1.0})
