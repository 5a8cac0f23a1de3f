"""A small asset that is quick to check, and edits of what it was exported to."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from artgen.generator import generator
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.joint import Prismatic
from artgen.nodes.primitive import box
from artgen.nodes.vector import Y
from artgen.sampling import choice, uniform

OAK = material("oak")


@generator
def stand(
    *,
    width: Float = uniform(0.30, 0.34, "m", within=(0.2, 0.5)),
    gap: Float = uniform(0.002, 0.004, "m", within=(-0.01, 0.02)),
    travel: Float = 0.2,
    stiffness: Float = choice(0.0, 15.0),
) -> Body:
    """A box with a drawer, which stands `gap` away from it at either side."""
    body = box(width, 0.3, 0.2).at(z=0.1) - box(width - 0.04, 0.28, 0.16).at(0, -0.01, 0.1)
    drawer = box(width - 0.04 - 2 * gap, 0.27, 0.12).at(0, -0.015, 0.1)
    slide = Prismatic("slide", axis=-Y, limits=(0, travel), friction=1.0, stiffness=stiffness, damping=10.0)
    return part(body, "body", OAK).attach(part(drawer, "drawer", OAK), slide)


def edit_json(path: Path, change: Callable[[Any], Any]) -> None:
    """Change the data of a JSON file in place."""
    data = json.loads(path.read_text(encoding="utf-8"))
    change(data)
    path.write_text(json.dumps(data), encoding="utf-8")


def edit_text(path: Path, old: str, new: str) -> None:
    """Replace the first occurrence of a text, which must be there."""
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
