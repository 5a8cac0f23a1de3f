"""Draw the pictures of the documentation with Mitsuba (`pip install "artgen[render]"`).

python scripts/hero.py --out docs/pictures
python scripts/hero.py --out /tmp/pictures --only lever_close --size 512 --samples 16
"""

import argparse
import math
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from path_tracing import Studio, render_mitsuba
from PIL import Image
from rich.console import Console

import artgen
from artgen.view.camera import Camera, View

console = Console(highlight=False, soft_wrap=True)


@dataclass(frozen=True)
class Shot:
    """A picture.

    Attributes:
        category: Category of the asset.
        seed: Seed of the asset.
        parameters: Overrides of its parameters.
        view: Viewing direction.
        studio: Its surroundings.
        opened: Position of free joints by name, as a share of the range; others are closed.
        shape: Width and height as shares of the larger one.
    """

    category: str
    seed: int
    view: View | Camera
    studio: Studio = "studio"
    parameters: Mapping[str, Any] = field(default_factory=dict)
    opened: Mapping[str, float] = field(default_factory=dict)
    shape: tuple[float, float] = (1.0, 1.0)


_OAK_LEVER = {
    "finish": artgen.material("oak").with_(name="oiled_oak", base_color=(0.40, 0.235, 0.105)),
    "fixing": "phillips",
    "frame": "full",
    "frame_finish": "same",
    "hand": "left",
    "handle.style": "wave",
    "layout": "single",
    "leaf": "panel_leaf",
    "metal": artgen.material("satin_nickel"),
    "opener": "lever",
    "opens": "towards",
    "rose": "round",
    "use": "interior",
}
_GLAZED = {"use": "exterior", "layout": "single", "leaf": "glazed_leaf"}
_HALF_LITE = {"use": "exterior", "layout": "single", "leaf": "half_lite_leaf"}
_LOUVERS = {"use": "interior", "layout": "single", "leaf": "louver_leaf"}
_LEVER_SIDE = View(math.radians(-24.0), math.radians(8.0), margin=0.3, link="handle")
_LOCK_SIDE = Camera((0.061, -1.332, 1.228), (0.215, -0.343, 0.985), 0.31)  # past the edge, to the strike
_LEFT = View(math.radians(-28.0), math.radians(6.0))
_RIGHT = View(math.radians(28.0), math.radians(6.0))
_TALL = (0.7, 1.0)

SHOTS = {
    "lever": Shot("door", 7, _LOCK_SIDE, "doorway", _OAK_LEVER, {"door_hinge": 0.38}),
    "lever_close": Shot("door", 7, _LEVER_SIDE, "doorway", _OAK_LEVER),
    "lever_turned": Shot("door", 7, _LEVER_SIDE, "doorway", _OAK_LEVER, {"handle_turn": 0.9}),
    "door_oak_closed": Shot("door", 7, _LEFT, "doorway", _OAK_LEVER, shape=_TALL),
    "door_oak_open": Shot("door", 7, _RIGHT, "doorway", _OAK_LEVER, {"door_hinge": 0.4}, _TALL),
    "door_glazed": Shot("door", 3, _RIGHT, "doorway", _GLAZED, {"door_hinge": 0.5}, _TALL),
    "door_half_lite": Shot("door", 12, _LEFT, "studio", _HALF_LITE, shape=_TALL),
    "door_louvers": Shot("door", 13, _LEFT, "doorway", _LOUVERS, shape=_TALL),
    "handle": Shot("handle", 7, View(math.radians(28.0), math.radians(14.0))),
    "handle_back": Shot("handle", 3, View(math.radians(150.0), math.radians(14.0))),
}
"""The pictures by name."""


def draw(shot: Shot, size: int, samples: int, textures: int) -> Image.Image:
    """Return a picture with the given number of pixels along its longer side."""
    asset = artgen.generate(shot.category, shot.seed, **shot.parameters)
    q = {}
    for name, share in shot.opened.items():
        low, high = asset.joint(name).limits or (-math.pi, math.pi)
        closed = asset.joint(name).closed
        q[name] = closed + share * ((high if high - closed > closed - low else low) - closed)
    width, height = (round(size * share) for share in shot.shape)
    pixels = render_mitsuba(
        asset,
        q,
        camera=shot.view,
        size=(width, height),
        samples=samples,
        studio=shot.studio,
        textures=textures,
    )
    return Image.fromarray(np.asarray(pixels))


def main() -> int:
    """Draw the pictures; exit code 1 if a requested picture does not exist."""
    parser = argparse.ArgumentParser(description="Draw the pictures of the documentation.")
    parser.add_argument("--out", type=Path, default=Path("docs/pictures"))
    parser.add_argument("--only", nargs="*", default=sorted(SHOTS), help="names of pictures")
    parser.add_argument("--size", type=int, default=1024, help="pixels of the longer side")
    parser.add_argument("--samples", type=int, default=64, help="paths per pixel")
    parser.add_argument("--textures", type=int, default=1024, help="texels per side of the maps")
    parser.add_argument("--format", choices=("jpg", "png"), default="jpg")
    options = parser.parse_args()
    unknown = [name for name in options.only if name not in SHOTS]
    if unknown:
        console.print(f"there is no picture {unknown[0]!r}; there are {', '.join(SHOTS)}")
        return 1
    options.out.mkdir(parents=True, exist_ok=True)
    for name in options.only:
        start = time.perf_counter()
        picture = draw(SHOTS[name], options.size, options.samples, options.textures)
        path = options.out / f"{name}.{options.format}"
        picture.save(path, **({"quality": 90} if options.format == "jpg" else {}))
        console.print(f"{path}: {time.perf_counter() - start:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
