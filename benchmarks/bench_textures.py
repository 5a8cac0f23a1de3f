"""Time textures: cold and warm, per recipe, beside Fourier transforms."""

import statistics
from collections.abc import Sequence
from functools import partial

import numpy as np
from report import Section, Table, shown
from timing import empty_cache, seconds

from artgen.materials import Material
from artgen.materials.textures import RECIPES, encoded, kinds, maps
from artgen.materials.textures.bake import MEMORY, bake

_COMPARED = """
Processor time of the maps of every recipe of textures, {size} texels on a side. `bake` makes the maps;
`png` and `jpg` make all files of a format in an empty cache, maps at hand; `warm` reads them as another
process left them. The ratio is to a Fourier transform of 512 x 512 numbers, forth and back, timed in the
same run.
"""


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    names = ["flat"] if quick else list(RECIPES)
    size = 256 if quick else 512
    bake(RECIPES["flat"], 0, 256)  # what numpy sets up once is not a recipe's
    unit = transform()
    found = {name: of_recipe(name, size) for name in names}
    middle = [statistics.median(column) for column in zip(*found.values(), strict=True)]
    shares = [1.0 - sum(times[3:]) / sum(times[:3]) for times in found.values()]
    return Section(
        "textures",
        _COMPARED.format(size=size),
        [
            Table(
                "Milliseconds",
                ("recipe", "bake", "bake / transform", "png", "jpg", "warm png", "warm jpg"),
                [_row(name, times, unit) for name, times in {**found, "median": middle}.items()],
            )
        ],
        [
            f"The maps of a recipe take as long as {shown(1e-3 * middle[0] / unit)} transforms (median).",
            f"Read from the cache, they take {shown(100.0 * statistics.median(shares))} % less (median).",
        ],
    )


def transform() -> float:
    """Return the time of a transform of 512 x 512 numbers and its inverse [s]."""
    field = np.random.default_rng(0).standard_normal((512, 512))
    return min(seconds(lambda: np.fft.irfft2(np.fft.rfft2(field))) for _ in range(20))


def write_files(material: Material, size: int, form: str) -> None:
    """Make all files of a material for a format."""
    for kind in kinds(material):
        if kind not in {"roughness" if form == "jpg" else "orm", "metalness"}:
            encoded(material, kind, size, "jpg" if form == "jpg" else "png")


def of_recipe(name: str, size: int) -> list[float]:
    """Return the times of a recipe: bake, PNG, JPEG, both from the cache [ms]."""
    recipe = RECIPES[name]
    material = Material(name, recipe.base_color, texture=name)
    times = [min(seconds(partial(bake, recipe, 0, size)) for _ in range(2))]
    with empty_cache():
        for form in ("png", "jpg"):
            maps(material, size)
            times.append(seconds(partial(write_files, material, size, form)))
        for form in ("png", "jpg"):
            MEMORY.clear()
            times.append(seconds(partial(write_files, material, size, form)))
    MEMORY.clear()
    return [1e3 * each for each in times]


def _row(name: str, times: Sequence[float], unit: float) -> tuple[str | float, ...]:
    return name, times[0], 1e-3 * times[0] / unit, *times[1:]
