"""A small asset with maps of every kind, whose picture shows where it is upright, mirrored or turned."""

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest

from artgen import Prismatic, Revolute, X, Z, box, material, part
from artgen.asset import Asset
from artgen.materials import Material
from artgen.materials.textures import RECIPES, Pattern, Recipe
from support.proof_fridges import evaluated

QUADRANTS = np.array([[[0.6, 0.1, 0.1], [0.1, 0.6, 0.1]], [[0.1, 0.1, 0.6], [0.4, 0.4, 0.4]]])
"""Linear albedo of the picture's quarters, shape (2, 2, 3): row 0 is its top, column 0 its left."""


def _picture(stream: np.random.Generator, size: int) -> Pattern:
    albedo = QUADRANTS.repeat(size // 2, axis=0).repeat(size // 2, axis=1)
    rows, columns = np.mgrid[:size, :size] / size
    relief = 1e-3 * np.sin(2 * np.pi * columns) + 2e-3 * np.sin(2 * np.pi * rows)
    return Pattern(albedo, 0.2 * (0.5 - rows), None, relief)


def _halves(stream: np.random.Generator, size: int) -> Pattern:
    rows, columns = np.mgrid[:size, :size] / size
    return Pattern(None, 0.2 * np.where(rows < 0.5, 1.0, -1.0), np.where(columns < 0.5, 1.0, 0.0))


@contextmanager
def recipes() -> Iterator[None]:
    """Have the recipes of this module among artgen's."""
    with pytest.MonkeyPatch.context() as patch:
        for recipe in (
            Recipe("test_picture", (0.3, 0.3, 0.3), _picture, (0.25, 0.5)),
            Recipe("test_halves", (0.5, 0.5, 0.5), _halves, (0.1, 0.2)),
        ):
            patch.setitem(RECIPES, recipe.name, recipe)
        yield


BOARD = material("oak").with_(name="board", texture="test_picture", base_color=(0.45, 0.3, 0.15))
PLATE = material("steel").with_(name="plate", texture="test_halves", coat_weight=0.5)
TURNED = BOARD.with_(name="turned", turned=True, tile=(0.1, 0.3), specular_roughness=0.3)
PANE = material("glass").with_(name="pane", texture="flat", transmission_weight=1.0)
LAMP = Material("lamp", (0.1, 0.2, 0.1), emission=(0.2, 0.8, 0.1))


def picture(u: float, v: float, stuff: Material) -> tuple[float, float, float]:
    """Return the linear color of a place in the picture, u to the right and v upwards, tinted."""
    quarter = QUADRANTS[int(v % 1.0 < 0.5), int(u % 1.0 >= 0.5)]
    red, green, blue = quarter * np.array(stuff.base_color) / 0.3
    return red, green, blue


def textured() -> Asset:
    """Return an asset of a board, a plate, a board of turned grain, a pane and a lamp, amid `recipes`."""
    body = part(box(0.5, 0.5, 0.05).at(z=0.025), "board", BOARD)
    plate = part(box(0.3, 0.3, 0.02).at(z=0.1), "plate", PLATE)
    plank = part(box(0.1, 0.02, 0.4).at(0.2, 0.2, 0.4), "plank", TURNED)
    pane = part(box(0.2, 0.01, 0.2).at(-0.1, 0.2, 0.3), "pane", PANE)
    lamp = part(box(0.04, 0.04, 0.04).at(-0.2, -0.2, 0.2), "lamp", LAMP)
    body = body.attach(plate, Prismatic("lift", axis=Z, limits=(0, 0.03)))
    body = body.attach(plank, Prismatic("slide", axis=X, limits=(0, 0.1)))
    body = body.attach(pane, Revolute("swing", pivot=(-0.2, 0.2, 0.3), axis=Z, limits=(0, 1.0)))
    return evaluated(body.attach(lamp, Prismatic("drop", axis=Z, limits=(0, 0.1))), "textured")
