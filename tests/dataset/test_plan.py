"""Plans: errors before anything is written, and the order of the assets."""

from dataclasses import replace
from pathlib import Path

import pytest

from artgen.dataset import Item, Plan
from artgen.dataset.plan import _loaded
from artgen.errors import ExportError, ParameterError

BLOCKS = """
import artgen as ag

@ag.category(labels="block")
def cube(*, size: ag.Float = ag.uniform(0.1, 0.2, within=(0.1, 0.5))) -> ag.Body:
    return ag.part(ag.box(size, size, size).at(z=size / 2), "block", ag.material("oak"))

@ag.category(labels="block")
def slab(*, size: ag.Float = ag.uniform(0.1, 0.2)) -> ag.Body:
    return ag.part(ag.box(size, size, 0.01).at(z=0.005), "block", ag.material("oak"))
"""


def test_categories_alternate_and_longer_plans_begin_like_shorter_ones() -> None:
    long, short = Plan(("lamp", "door"), 5, seed=7), Plan(("lamp", "door"), 3, seed=7)
    assert [item.name for item in long.items()] == ["lamp_7", "door_7", "lamp_8", "door_8", "lamp_9"]
    assert list(short.items()) == list(long.items())[:3]
    assert next(long.items()) == Item("lamp", 7)


def test_a_plan_without_maps_has_no_texels() -> None:
    assert Plan(("door",), 2, textures="none").texels == 0


def test_a_file_stands_for_the_category_that_it_defines(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("shop.py").write_text(BLOCKS)
    plan = Plan(("shop.py:cube", "drawer"), 3, overrides=("cube:size=0.3",))
    assert plan.categories == ("cube", "drawer")
    assert [item.path for item in plan.items()] == ["cube/cube_0", "drawer/drawer_0", "cube/cube_1"]
    assert plan.draw(Item("cube", 1)).parameters == {"size": 0.3}
    assert replace(plan, count=1).to_data() == plan.to_data() | {"count": 1}
    assert str(tmp_path) not in str(plan.to_data()), "data are equal in every folder"


def test_a_file_with_several_categories_or_a_taken_name_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "shop.py").write_text(BLOCKS)
    with pytest.raises(ParameterError, match=r"defines 2 categories; pick one: shop.py:cube or shop.py:slab"):
        Plan(str(tmp_path / "shop.py"), 1)
    with pytest.raises(ParameterError, match="the category 'cube' is named twice"):
        Plan((f"{tmp_path}/shop.py:cube",) * 2, 1)
    with pytest.raises(ParameterError, match=r"there is no Python file 'nowhere\.py'"):
        Plan("nowhere.py", 1)


def test_a_file_that_is_changed_or_removed_during_a_run_makes_no_assets(tmp_path: Path) -> None:
    file = tmp_path / "shop.py"
    file.write_text(BLOCKS)
    plan = Plan(f"{file}:slab", 2)
    _loaded.cache_clear()  # as in a worker
    file.write_text(BLOCKS.replace("0.01", "0.02"))
    with pytest.raises(ParameterError, match=r"shop.py has changed during the run; begin again in another"):
        plan.draw(Item("slab", 0))
    file.unlink()
    with pytest.raises(
        ParameterError, match="No such file or directory; a dataset of a file needs it on every"
    ):
        plan.draw(Item("slab", 0))


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
        ({"categories": ()}, "a dataset needs the names of its categories"),
        ({"categories": ("door", "dor")}, r"there is no category 'dor'\. Did you mean 'door'\?"),
        ({"categories": ("door", "door")}, "the category 'door' is named twice; leave one of them out"),
        ({"count": 0}, "count is a whole number from 1 to 1000000000, not 0"),
        ({"texture_size": 300}, "textures have 256, 512, 1024, 2048 texels on a side, not 300"),
        ({"textures": "jpg"}, "textures are shared, embedded or none, not 'jpg'"),
        ({"base": "x"}, "base is fixed or free, not 'x'"),
        ({"tolerance": -1.0}, r"tolerance = -1\.0 is not allowed: it is the clearance to prove"),
        ({"on_collision": "x"}, "on_collision = 'x' is not allowed: it must be one of 'redraw'"),
        (
            {"overrides": {"width": 1}},
            r"overrides = \{'width': 1\} is not allowed: give a tuple of texts, such as \('width=0\.4',\)",
        ),
        ({"overrides": "width=0.4"}, r"overrides = 'width=0\.4' is not allowed: give a tuple of texts"),
        ({"overrides": 3}, "overrides = 3 is not allowed"),
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
    with pytest.raises(ExportError, match=r"there is no format 'obj'\. Allowed: glb, mjcf, sdf, urdf, usd"):
        Plan(("door",), 1, formats=("obj",))
