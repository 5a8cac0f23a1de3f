"""Assets: links, joints, poses and mass properties, as plain data."""

from artgen.asset.affordance import Affordance, Grasp, Hold, Push
from artgen.asset.asset import Asset, Base
from artgen.asset.contact import AllowedContact
from artgen.asset.joint import DYNAMICS, Condition, Coupling, Dependency, Joint, JointKind, rotation
from artgen.asset.link import MOST_COLLIDERS, Collider, Link, Piece, Reading, Surface
from artgen.asset.manifolds import PROPERTIES
from artgen.asset.mass import MassProperties, Moments, polyhedron_moments
from artgen.asset.shape import Contour, Curve, Mesh, Outline, Shape
from artgen.asset.tree import Branch, Tree

__all__ = [
    "DYNAMICS",
    "MOST_COLLIDERS",
    "PROPERTIES",
    "Affordance",
    "AllowedContact",
    "Asset",
    "Base",
    "Branch",
    "Collider",
    "Condition",
    "Contour",
    "Coupling",
    "Curve",
    "Dependency",
    "Grasp",
    "Hold",
    "Joint",
    "JointKind",
    "Link",
    "MassProperties",
    "Mesh",
    "Moments",
    "Outline",
    "Piece",
    "Push",
    "Reading",
    "Shape",
    "Surface",
    "Tree",
    "polyhedron_moments",
    "rotation",
]
