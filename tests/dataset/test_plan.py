"""Plans: errors before anything is written, and the order of the assets."""

import pytest

from artgen.dataset import Item, Plan
from artgen.errors import ExportError, ParameterError


def test_categories_alternate_and_longer_plans_begin_like_shorter_ones() -> None:
    long, short = Plan(("lamp", "door"), 5, seed=7), Plan(("lamp", "door"), 3, seed=7)
    assert [item.name for item in long.items()] == ["lamp_7", "door_7", "lamp_8", "door_8", "lamp_9"]
    assert list(short.items()) == list(long.items())[:3]
    assert next(long.items()) == Item("lamp", 7)


def test_a_plan_is_the_same_after_it_was_written() -> None:
    plan = Plan(("door",), 2, overrides=("width=0.9",), formats=("mjcf",), textures="none")
    assert Plan.from_data(plan.to_data()) == plan
    assert plan.texels == 0


def test_formats_are_those_of_the_layout() -> None:
    assert Plan(("door",), 1).formats == ("urdf", "mjcf", "usd")


def test_one_name_stands_for_a_tuple_of_one() -> None:
    assert Plan("drawer", 2) == Plan(("drawer",), 2)


def test_overrides_for_one_category_replace_those_for_all() -> None:
    plan = Plan(("door", "window"), 2, overrides=("width=0.9", "window:width=0.8"))
    assert plan.overrides_of("door") == {"width": 0.9}
    assert plan.overrides_of("window") == {"width": 0.8}


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"categories": ()}, "a dataset needs at least one category"),
        ({"categories": ("door", "dor")}, r"there is no category 'dor'\. Did you mean 'door'\?"),
        ({"categories": ("door", "door")}, "the category 'door' is named twice; leave one of them out"),
        ({"count": 0}, "count is a whole number from 1 to 1000000000, not 0"),
        ({"texture_size": 300}, "textures have 256, 512, 1024, 2048 texels on a side, not 300"),
        ({"textures": "jpg"}, "textures are shared, embedded or none, not 'jpg'"),
        ({"overrides": ("widht=0.9",)}, r"no parameter 'widht'\. Did you mean 'width'\?"),
        ({"overrides": ("width=3",)}, r"width = 3 is out of range: 0\.6 to 1\.25 m is allowed"),
        (
            {"overrides": ("lamp:width=3",)},
            "is for 'lamp', which is not in the plan; its categories are door",
        ),
    ],
)
def test_impossible_plans_are_errors(options: dict[str, object], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        Plan(**{"categories": ("door",), "count": 1, **options})  # type: ignore[arg-type]


def test_an_unknown_format_is_refused() -> None:
    with pytest.raises(ExportError, match=r"there is no format 'obj'\. Allowed: glb, mjcf, urdf, usd"):
        Plan(("door",), 1, formats=("obj",))
