"""Where the pattern of a part begins: anywhere, but not where it has to meet the part's edges."""

import numpy as np
import pytest

from artgen.asset.shape import Mesh
from artgen.asset.surface import shifted, texture_coordinates
from artgen.materials import MATERIALS, Material, material
from artgen.materials.textures import RECIPES, shifts_of

KEYS = [f"board/{number}" for number in range(40)]


def beginnings(made):
    """Return where in the maps the corner of each part lies, in repeats, shape (n, 2)."""
    corner = np.zeros((1, 3))
    mesh = Mesh(corner, corner, np.zeros((1, 2)), np.zeros(1, np.int64), np.zeros((0, 3), np.int64))
    return np.concatenate([texture_coordinates(shifted(mesh, made, key), made) for key in KEYS])


@pytest.mark.parametrize("turned", [False, True])
def test_boards_begin_anywhere(turned):
    begun = beginnings(material("oak").with_(turned=turned)) % 1.0
    assert len(np.unique(begun, axis=0)) > 35
    assert (begun.std(axis=0) > 0.15).all()


@pytest.mark.parametrize("turned", [False, True])
def test_the_liners_of_corrugated_board_stay_at_its_faces(turned):
    made = material("cardboard_edge").with_(turned=turned)
    assert shifts_of(made) == (False, True)
    begun = beginnings(made)
    assert (begun[:, 0] == 0.0).all()  # across the edge
    assert begun[:, 1].std() > 0.15  # along it
    assert (beginnings(made.with_(tile=(0.006, 0.1)))[:, 0] == 0.0).all()


def test_nothing_else_is_held():
    held = {name for name, made in MATERIALS.items() if made.texture and shifts_of(made) != (True, True)}
    assert held == {"cardboard_edge"}
    assert all(recipe.shifts[1] for recipe in RECIPES.values())
    assert (beginnings(Material("plain")) == 0.0).all()
