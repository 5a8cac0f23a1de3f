"""Assets: links, joints, poses and mass properties, as plain data."""

from artgen.asset.affordance import Grasp, Push
from artgen.asset.asset import Asset
from artgen.asset.coupling import AssetCoupling, AssetCurve, AssetLoop
from artgen.asset.joint import (
    AllowedContact,
    AssetCondition,
    AssetDependency,
    AssetDetents,
    AssetJoint,
    AssetSoftClosing,
    rotation,
)
from artgen.asset.link import Collider, Link, Piece, Surface
from artgen.asset.shape import Curve, Mesh, Outline, Shape
from artgen.asset.signals import AssetOutput, AssetSignal
from artgen.asset.tree import Branch, Tree

__all__ = [
    "AllowedContact", "Asset", "AssetCondition", "AssetCoupling", "AssetCurve", "AssetDependency",
    "AssetDetents", "AssetJoint", "AssetLoop", "AssetOutput", "AssetSignal", "AssetSoftClosing", "Branch",
    "Collider", "Curve", "Grasp", "Link", "Mesh", "Outline", "Piece", "Push", "Shape", "Surface", "Tree",
    "rotation",
]  # fmt: skip
