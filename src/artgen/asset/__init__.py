"""Assets: links, joints, poses and mass properties, as plain data."""

from artgen.asset.affordance import Affordance, Grasp, Hold, Push
from artgen.asset.asset import Asset, Base
from artgen.asset.joint import (
    DYNAMICS,
    AllowedContact,
    AssetCondition,
    AssetCoupling,
    AssetDependency,
    AssetJoint,
    JointKind,
    rotation,
)
from artgen.asset.link import MOST_COLLIDERS, Collider, Link, Piece, PrintDirection, Surface
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
    "AssetCondition",
    "AssetCoupling",
    "AssetDependency",
    "AssetJoint",
    "Base",
    "Branch",
    "Collider",
    "Contour",
    "Curve",
    "Grasp",
    "Hold",
    "JointKind",
    "Link",
    "MassProperties",
    "Mesh",
    "Moments",
    "Outline",
    "Piece",
    "PrintDirection",
    "Push",
    "Shape",
    "Surface",
    "Tree",
    "polyhedron_moments",
    "rotation",
]
