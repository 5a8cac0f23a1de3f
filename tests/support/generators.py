"""Generators that tests draw from."""

from typing import Literal

from artgen.generator import Generator, generator, one_of
from artgen.materials import Material, material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Bool, Float, Solid, Vector
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box, sphere
from artgen.nodes.scalar import require, sqrt
from artgen.nodes.vector import X, Y
from artgen.sampling import by, choice, count, loguniform, truncated_normal, uniform

OAK, STEEL = material("oak"), material("steel")


@generator
def round_grip(*, radius: Float = uniform(0.01, 0.02, "m")) -> Solid:
    return sphere(radius)


@generator
def square_grip(*, width: Float = uniform(0.01, 0.02, "m"), radius: Float = uniform(0.001, 0.002)) -> Solid:
    return box(width, width, width, bevel=radius)


@generator
def lever(
    *,
    thickness: Float,
    toward: int = 1,
    length: Float = uniform(0.10, 0.14, "m", within=(0.05, 0.4)),
    grip: Generator = one_of(round_grip, square_grip),
    axis: Vector = X,
) -> Body:
    return part(box(length, thickness, 0.02) | grip().at(axis * (toward * length / 2)), "handle", STEEL)


@generator
def knob(*, thickness: Float, radius: Float = uniform(0.02, 0.03, "m"), grip: Solid | None = None) -> Body:
    solid = sphere(radius).at(0, thickness) if grip is None else grip
    return part(solid, "handle", STEEL)


@generator
def door(
    *,
    width: Float = uniform(0.75, 1.05, "m", doc="of the leaf", within=(0.3, 2.0)),
    height: Float = truncated_normal(2.0, 0.1, 1.9, 2.2, "m"),
    ratio: Float = loguniform(0.5, 2.0),
    layout: Literal["french", "single"] = choice("french", "single"),
    swing: Float = by("layout", french=uniform(1.4, 1.6), single=uniform(1.8, 2.0), unit="rad"),
    panels: int = count(1, 4),
    glazed: bool = choice(True, False),
    shiny: Bool = choice(True, False),
    wood: Material = choice("oak", "walnut"),
    offset: Vector = (0.0, 0.0, 0.5),
    note: str = "plain",
    handle: Generator = one_of(lever, knob),
) -> Body:
    leaf = part(box(width, 0.04 * ratio, height).at(offset), "door", wood)
    turn = Revolute("turn", axis=X, limits=(0.0, swing))
    return leaf.attach(handle(thickness=width / 20).at(2.0, 0.0, 0.0), turn)


@generator
def chest(
    *,
    gap: Float = uniform(0.001, 0.004, "m", within=(-0.1, 0.1)),
    depth: Float = uniform(0.2, 0.3, "m"),
    least: Float = 0.0,
    stroke: Float = 0.1,
    place: Vector = (0.0, 0.0, 0.5),
) -> Body:
    """A drawer between two walls, which it overlaps where the gap is negative."""
    wall = box(0.01, depth, 0.1)
    walls = part(wall.at(0.055 + gap) | wall.at(-0.055 - gap), "box", OAK)
    drawer = part(box(0.1, depth * sqrt(10 * stroke), 0.1), "drawer", OAK)
    body = walls.attach(drawer, Prismatic("slide", axis=-Y, limits=(0.0, stroke)))
    return require(body, depth >= least, "the drawer is too short").at(place)


NAMES = list(door.sample(0))


def block(name="block"):
    return part(box(0.1, 0.1, 0.1), name, OAK)
