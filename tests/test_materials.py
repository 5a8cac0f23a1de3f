"""Materials: checked, comparable, and kept by their data."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

import artgen
from artgen.errors import ParameterError
from artgen.materials import COLORS, MATERIALS, Material, colored, material

SHARE = st.floats(0, 1)
MADE = st.builds(
    Material,
    name=st.from_regex(r"[a-z][a-z0-9_]{0,10}", fullmatch=True),
    base_color=st.tuples(SHARE, SHARE, SHARE),
    base_metalness=SHARE,
    specular_roughness=SHARE,
    opacity=SHARE,
    emission=st.tuples(SHARE, SHARE, SHARE),
    density=st.floats(0.1, 2e4),
    friction=st.floats(0, 2),
)


@pytest.mark.parametrize("name", MATERIALS)
def test_the_table_holds_plausible_materials_under_their_names(name):
    made = MATERIALS[name]
    assert made.name == name
    assert material(name) is made
    assert 20 <= made.density <= 9000
    assert 0.2 <= made.friction <= 1.0


def test_paint_numbers_tell_the_materials_apart():
    numbers = {made.number for made in MATERIALS.values()}
    assert len(numbers) == len(MATERIALS)
    assert all(0 < number < 2**53 for number in numbers)


def test_an_unknown_name_gives_the_nearest():
    with pytest.raises(ParameterError, match=r"there is no material 'wallnut'\. Did you mean 'walnut'\?"):
        material("wallnut")


@given(MADE)
def test_data_keeps_a_material(made):
    assert Material.from_data(json.loads(json.dumps(made.to_data()))) == made


def test_whole_numbers_and_lists_make_the_same_material():
    a = Material("a", (1, 0, 0), density=700)
    b = Material("a", [1.0, 0.0, 0.0], density=700.0)  # type: ignore[arg-type]
    assert a == b
    assert hash(a) == hash(b)
    assert json.dumps(a.to_data()) == json.dumps(b.to_data())


def test_with_changes_a_copy():
    oak = material("oak")
    dark = oak.with_(name="dark_oak", base_color=(0.1, 0.1, 0.1))
    assert (dark.name, dark.density) == ("dark_oak", oak.density)
    assert material("oak") is oak
    with pytest.raises(
        ParameterError, match=r"material 'oak' has no field 'color'\. Did you mean 'base_color'\?"
    ):
        oak.with_(color=(1, 1, 1))


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"name": "My Oak"}, "material name 'My Oak' is not a lower-case identifier"),
        ({"name": ""}, "is not a lower-case identifier"),
        ({"name": 5}, "is not a lower-case identifier"),
        ({"base_color": (0.5, 0.5)}, r"material 'a': base_color \(0\.5, 0\.5\) must be 3 numbers in 0\.\.1"),
        ({"base_color": (0.5, 0.5, 1.5)}, "must be 3 numbers in 0..1"),
        ({"base_color": (0.5, 0.5, "x")}, "base_color 'x' must be a finite number"),
        ({"emission": (-1, 0, 0)}, "emission .* must be 3 numbers in 0..1"),
        ({"opacity": 1.5}, r"material 'a': opacity 1\.5 must be in 0\.\.1"),
        ({"specular_roughness": -0.1}, "specular_roughness -0.1 must be in 0..1"),
        ({"base_metalness": None}, "base_metalness None must be a finite number"),
        ({"density": 0.0}, r"density 0\.0 must be positive \[kg/m\^3\]"),
        ({"density": float("inf")}, "density inf must be a finite number"),
        ({"density": float("nan")}, "density nan must be a finite number"),
        ({"friction": -0.5}, r"friction -0\.5 must not be negative"),
    ],
)
def test_impossible_materials_are_refused(fields, message):
    with pytest.raises(ParameterError, match=message):
        Material(**{"name": "a"} | fields)


def test_the_table_has_every_family_of_household_things():
    families = [
        ("oak", "oak_flat_sawn", "walnut", "beech", "pine", "mahogany", "maple", "ash"),
        ("plywood", "plywood_edge", "mdf", "painted_wood", "hollow_core", "cardboard", "cardboard_edge"),
        (
            "stainless",
            "stainless_across",
            "chrome",
            "brass",
            "satin_nickel",
            "black_steel",
            "cast_iron",
            "zinc",
        ),
        ("aluminium", "black_anodised", "aged_bronze", "powder_coat", "enamel_white", "enamel_black"),
        ("abs", "black_abs", "glossy_plastic_white", "polypropylene", "polycarbonate", "rubber", "silicone"),
        ("glass", "frosted_glass", "tinted_glass", "black_glass", "ceramic", "granite", "marble"),
        ("fabric", "linen", "wicker", "plastic_wicker", "foam", "led_white", "led_red", "display"),
        ("leather", "black_leather", "cream_leather", "velvet", "mesh"),
    ]
    assert {name for family in families for name in family} <= set(MATERIALS)
    assert len(MATERIALS) >= 40
    assert material("stainless_across").turned
    assert not material("stainless").turned


@pytest.mark.parametrize("name", MATERIALS)
def test_surfaces_are_no_brighter_and_no_darker_than_real_ones(name):
    made = MATERIALS[name]
    assert min(made.base_color) >= 0.02
    assert max(made.base_color) <= (0.9 if made.transmission_weight < 1.0 else 0.99)
    if made.base_metalness == 1.0:
        assert max(made.base_color) >= 0.5  # bare metal reflects at least half of the light
    assert (made.opacity < 1.0) == (made.transmission_weight > 0.0)
    if any(made.emission):
        assert not made.texture
    else:
        assert made.texture


def test_woods_are_lacquered_and_raw_boards_are_not():
    for name in ("oak", "oak_flat_sawn", "walnut", "pine", "mahogany", "ash"):
        assert 0.2 <= material(name).coat_weight <= 0.35
        assert material(name).coat_roughness < material(name).specular_roughness
    for name in ("plywood_edge", "mdf", "cardboard", "cardboard_edge", "steel", "granite"):
        assert material(name).coat_weight == 0.0


def test_a_pane_of_clear_glass_lets_nearly_all_light_through():
    assert min(material("glass").base_color) > 0.95
    assert max(material("tinted_glass").base_color) < 0.4
    assert material("glass").opacity < material("tinted_glass").opacity < material("frosted_glass").opacity


@pytest.mark.parametrize("name", COLORS)
def test_colors_are_those_of_paints_and_give_materials_their_names(name):
    assert min(COLORS[name]) >= 0.02
    assert max(COLORS[name]) <= 0.82
    made = colored("powder_coat", name)
    assert made.name == f"powder_coat_{name}"
    assert made.base_color == COLORS[name]
    assert made.texture == material("powder_coat").texture
    if made.name in MATERIALS:
        assert made == MATERIALS[made.name]


def test_a_material_in_a_color_is_found_by_its_name() -> None:
    assert material("abs_light_grey") == colored("abs", "light_grey")
    assert material("powder_coat_black") is MATERIALS["powder_coat_black"]
    chair = artgen.generate("chair", 3, certify=False, style="bar", cover="abs_red")
    assert chair.parameters["cover"] == "abs_red"
    with pytest.raises(ParameterError, match="there is no material 'oakk_sage'"):
        material("oakk_sage")


def test_an_unknown_color_gives_the_nearest():
    with pytest.raises(ParameterError, match=r"there is no color 'sagge'\. Did you mean 'sage'\?"):
        colored("powder_coat", "sagge")
    with pytest.raises(
        ParameterError, match=r"there is no material 'powdercoat'\. Did you mean 'powder_coat'\?"
    ):
        colored("powdercoat", "sage")
