"""Weighing bodies: what a spring or a brake has to hold follows from what it carries."""

from artgen.asset import Tree
from artgen.asset.mass import total
from artgen.graph import kernel
from artgen.nodes.handles import Array3, Body, Float, Vector


@kernel
def _mass(body: Tree) -> float:
    return sum(link.mass_properties.mass for link in body.links())


def mass(body: Body) -> Float:
    """Return the mass of a body with all that is joined to it [kg].

    Examples:
        >>> lid = part(box(0.3, 0.2, 0.01), "lid", material("oak"))
        >>> case = part(box(0.3, 0.2, 0.1).at(z=-0.057), "case", material("walnut"))
        >>> hold = 9.81 * 0.1 * mass(lid)
        >>> hinge = Revolute("hinge", pivot=(0, 0.1, -0.006), axis=-X, limits=(0, 1.5), friction=hold)
        >>> case.attach(lid, hinge)
    """
    return Float.record(_mass, body=body)


@kernel
def _center_of_mass(body: Tree) -> Array3:
    return total([link.mass_properties.moments() for link in body.links()]).center


def center_of_mass(body: Body) -> Vector:
    """Return the centre of mass of a body with all that is joined to it, at rest [m].

    Examples:
        >>> grip = part(cylinder(0.015, 0.3, axis=X), "handle", material("oak"))
        >>> tool = weld(grip, part(box(0.03, 0.04, 0.1).at(0.15), "head", material("steel")))
        >>> mark = torus(0.03, 0.003, axis=X).at(center_of_mass(tool))
        >>> weld(tool, detail(mark, "balance", material("brass")))
    """
    return Vector.record(_center_of_mass, body=body)
