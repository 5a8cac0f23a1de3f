"""What a URDF cannot say, whichever layout it is written for."""

from collections.abc import Iterable

from artgen.asset import Asset
from artgen.export.frames import FAR, INTERMEDIATE_MASS
from artgen.export.losses import Loss, contact_losses, dependency_losses, joints_where, loss


def motion_losses(asset: Asset, inserted: Iterable[str]) -> tuple[Loss, ...]:
    """List what is lost of how joints move.

    Args:
        asset: The asset.
        inserted: Names of the links that were put between two joints of one pair of links.
    """
    moving = {joint.name for joint in asset.joints if not joint.locked}
    return (
        *loss(
            "joint spring",
            joints_where(asset, lambda joint: joint.name in moving and joint.stiffness > 0.0),
            "Gazebo's springStiffness and springReference; other clients have no spring",
        ),
        *loss(
            "joint armature",
            joints_where(asset, lambda joint: joint.name in moving and joint.armature > 0.0),
            "nothing",
        ),
        *loss(
            "unlimited slide",
            joints_where(
                asset,
                lambda joint: joint.name in moving and joint.kind == "prismatic" and joint.limits is None,
            ),
            f"limits of -{FAR:g} m and {FAR:g} m",
        ),
        *dependency_losses(asset),
        *contact_losses(asset),
        *loss(
            "several joints between two links",
            inserted,
            f"a link of {INTERMEDIATE_MASS:g} kg after each joint but the last",
        ),
    )


def material_losses(asset: Asset) -> tuple[Loss, ...]:
    """List what is lost of what links are made of."""
    return (
        *loss(
            "contact friction",
            [link.name for link in asset.links if link.colliders],
            "nothing: clients take their own default; the coefficients are in asset.json",
        ),
        *loss(
            "surface roughness, metalness and coat",
            [material.name for material in asset.materials],
            "Pr, Pm, Pc and norm in the MTL file, which few clients read",
        ),
    )
