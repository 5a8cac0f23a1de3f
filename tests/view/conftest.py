"""A small cabinet to take pictures of, and what pictures need."""

import pytest

from artgen.asset import Asset
from artgen.generator import generator
from artgen.materials import material
from artgen.nodes.body import part, weld
from artgen.nodes.handles import Body
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box
from artgen.nodes.vector import Y, Z

RED = material("painted_wood").with_(name="red_paint", base_color=(0.6, 0.02, 0.02))
BLUE = material("painted_wood").with_(name="blue_paint", base_color=(0.02, 0.05, 0.6))
WHITE, GLASS, CHROME = material("painted_wood"), material("glass"), material("chrome")


@generator
def cabinet(*, glazed: bool = False) -> Body:
    """A white box, blue inside, with a red or glass door, a chrome knob and a blue drawer below."""
    shell = box(0.6, 0.4, 0.8) - box(0.52, 0.4, 0.5).at(0, -0.05, 0.1)
    leaf = box(0.56, 0.02, 0.54).at(0, -0.215, 0.1)
    knob = box(0.03, 0.04, 0.03, bevel=0.006).at(0.2, -0.245, 0.1)
    lining = box(0.5, 0.02, 0.48).at(0, 0.13, 0.1)
    body = weld(part(shell, "body", WHITE), part(lining, "inside", BLUE))
    door = weld(part(leaf, "door", GLASS if glazed else RED), part(knob, "knob", CHROME))
    drawer = part(box(0.5, 0.02, 0.12).at(0, -0.215, -0.3), "drawer", BLUE)
    hinge = Revolute("door_hinge", pivot=leaf.anchor(x=-1, y=-1), axis=-Z, limits=(0, 1.5))
    slide = Prismatic("drawer_slide", axis=-Y, limits=(0, 0.3))
    return body.attach(door, hinge).attach(drawer, slide)


@pytest.fixture(scope="session")
def red_cabinet() -> Asset:
    return cabinet.generate()


@pytest.fixture(scope="session")
def glass_cabinet() -> Asset:
    return cabinet.generate(glazed=True)
