"""Weighing bodies: what a spring or a brake has to hold follows from what it carries."""

from artgen.asset import Tree
from artgen.asset.mass import total
from artgen.graph import kernel
from artgen.nodes.handles import Array3, Body, Float, Vector


@kernel
def _mass(body: Tree) -> float:
    return sum(link.mass_properties.mass for link in body.links())


def mass(body: Body) -> Float:
    """Return the mass of a body with all that is joined to it [kg]."""
    return Float.record(_mass, body=body)


@kernel
def _center_of_mass(body: Tree) -> Array3:
    return total([link.mass_properties.moments() for link in body.links()]).center


def center_of_mass(body: Body) -> Vector:
    """Return the centre of mass of a body with all that is joined to it, at rest [m]."""
    return Vector.record(_center_of_mass, body=body)
