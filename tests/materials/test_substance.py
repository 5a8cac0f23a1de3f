"""What materials are made of, in words of labels and sensors."""

import pytest

from artgen.materials import MATERIALS, Material, material
from artgen.materials.substance import coating_of, substance_of


@pytest.mark.parametrize(
    ("name", "substance", "sensed", "coating"),
    [
        ("oak_flat_sawn", "wood", "wood", "clearcoat"),
        ("stainless_across", "stainless steel", "steel", "none"),
        ("satin_brass", "brass", "brass", "none"),
        ("aged_bronze", "bronze", "bronze", "none"),
        ("black_anodised", "aluminium", "aluminum", "none"),
        ("powder_coat_black", "steel", "steel", "paint"),
        ("painted_wood", "wood", "wood", "paint"),
        ("lacquered_mdf", "wood", "wood", "paint"),
        ("frosted_glass", "glass", "frosted_glass", "none"),
        ("plastic_wicker", "plastic", "plastic", "none"),
        ("black_granite", "granite", "stone", "none"),
        ("polycarbonate", "plastic", "plexiglass", "none"),
        ("cardboard_edge", "cardboard", "cardboard", "none"),
        ("black_leather", "leather", "leather", "none"),
        ("velvet", "textile", "fabric", "none"),
        ("mesh", "textile", "fabric", "none"),
    ],
)
def test_materials_of_the_table(name, substance, sensed, coating):
    found = substance_of(material(name))
    assert (found.name, found.sensed) == (substance, sensed)
    assert coating_of(material(name)) == coating


@pytest.mark.parametrize("name", MATERIALS)
def test_what_looks_metallic_is_a_metal(name):
    stuff = material(name)
    found = substance_of(stuff)
    if stuff.base_metalness >= 0.3:
        assert found.metal
    if found.metal and stuff.base_metalness < 0.3:
        # coated, blackened or anodised: nothing of the bare metal is seen
        assert coating_of(stuff) != "none" or stuff.texture in ("rolled", "anodised", "perforated")
    assert found.code[0] == "Q"
    assert found.code[1:].isdigit()


def test_names_of_an_assets_own_tell_what_they_are_of():
    assert substance_of(Material("paint_sage_6ddfc8", density=700.0)).name == "wood"
    assert substance_of(Material("paint_sage_6ddfc8", density=7850.0)).name == "steel"
    assert substance_of(Material("satin_brass_98926c_recess")).name == "brass"
    assert substance_of(Material("satin_brass_091b9b_lens")).name == "plastic"
    assert substance_of(Material("stand_0d3ca0", texture="fine_grain")).name == "plastic"
    assert substance_of(Material("anything", transmission_weight=0.9)).name == "glass"
    assert substance_of(Material("anything", base_metalness=1.0)).name == "metal"
    assert substance_of(Material("washed")).name == "plastic"  # no ash tree


def test_coats_add_up():
    assert coating_of(Material("paint_red", coat_weight=0.5)) == "paint_clearcoat"
    assert coating_of(Material("oak_7cf052", coat_weight=0.3)) == "clearcoat"
    assert coating_of(Material("front", texture="brushed_paint")) == "paint"
