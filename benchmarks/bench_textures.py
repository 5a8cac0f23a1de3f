"""Time textures: cold and warm, per recipe, in milliseconds of one core and in Fourier transforms.

    python benchmarks/bench_textures.py [--size 512] [recipe ...]

`bake` makes the maps; `png` and `jpg` make all files of a format in an empty cache, maps at hand; `warm`
reads them as another process left them. Ratios to a transform of 512 x 512 numbers, timed in the same run,
compare machines and versions.
"""

import argparse
import os
import statistics
import tempfile
from collections.abc import Callable
from time import process_time

import numpy as np
from rich.console import Console
from rich.table import Table

from artgen.errors import ParameterError, nearest
from artgen.materials import Material
from artgen.materials.textures import RECIPES, SIZES, encoded, kinds, maps
from artgen.materials.textures.bake import MEMORY, bake


def milliseconds(work: Callable[[], object]) -> float:
    """Return how long some work takes the processor [ms]."""
    start = process_time()
    work()
    return 1e3 * (process_time() - start)


def baseline() -> float:
    """Return how long a transform of 512 x 512 numbers takes, forth and back [ms]."""
    field = np.random.default_rng(0).standard_normal((512, 512))
    return min(milliseconds(lambda: np.fft.irfft2(np.fft.rfft2(field))) for _ in range(20))


def write_files(material: Material, size: int, form: str) -> None:
    """Make all files of a material that a format takes."""
    for kind in kinds(material):
        if kind not in {"roughness" if form == "jpg" else "orm", "metalness"}:
            encoded(material, kind, size, "jpg" if form == "jpg" else "png")


def measure(name: str, size: int) -> list[float]:
    """Return how long a recipe takes: bake, PNG, JPEG, both warm [ms]."""
    recipe = RECIPES[name]
    material = Material(name, recipe.base_color, texture=name)
    times = [min(milliseconds(lambda: bake(recipe, 0, size)) for _ in range(2))]
    with tempfile.TemporaryDirectory() as place:
        os.environ["ARTGEN_CACHE"] = place
        for form in ("png", "jpg"):
            maps(material, size)
            times.append(milliseconds(lambda form=form: write_files(material, size, form)))
        for form in ("png", "jpg"):
            MEMORY.clear()
            times.append(milliseconds(lambda form=form: write_files(material, size, form)))
    MEMORY.clear()
    return times


def main() -> None:
    """Measure the recipes that are named, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("recipes", nargs="*", help="recipes; all by default")
    parser.add_argument("--size", type=int, choices=SIZES, default=512, help="texels on a side")
    chosen = parser.parse_args()
    for name in chosen.recipes:
        if name not in RECIPES:
            raise ParameterError(f"there is no recipe {name!r}.{nearest(name, RECIPES)}")
    unit = baseline()
    table = Table("recipe", "bake ms", "FFTs", "png ms", "jpg ms", "warm png ms", "warm jpg ms")
    bakes = []
    bake(RECIPES["flat"], 0, 256)  # what numpy sets up once is not a recipe's
    for name in chosen.recipes or RECIPES:
        times = measure(name, chosen.size)
        bakes.append(times[0])
        table.add_row(name, *(f"{each:.1f}" for each in (times[0], times[0] / unit, *times[1:])))
    middle = statistics.median(bakes)
    table.add_row("median", f"{middle:.1f}", f"{middle / unit:.1f}")
    console = Console()
    console.print(table)
    console.print(f"baseline: {unit:.1f} ms")


if __name__ == "__main__":
    main()
