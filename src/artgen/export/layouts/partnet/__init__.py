"""Layout of the PartNet-Mobility dataset for SAPIEN, ManiSkill and loaders such as GAPartNet's.

`mobility.urdf` has one collider per convex piece, so its convex twin for ManiSkill is equal. The closed end
of joints in the dataset is the lower limit: a joint that closes at its upper limit is reversed; a joint that
closes between its limits, such as a knob that turns both ways, keeps them.

The dataset has no couplings. SAPIEN 3.0 reads a coupling between two joints of the same body in the wrong
direction, which blocks both, so those are only in the table of names.
"""

from artgen.asset import Asset
from artgen.export.layouts.partnet.meshes import object_meshes
from artgen.export.layouts.partnet.names import NAMES_FILE, ROOT, Naming, naming
from artgen.export.layouts.partnet.tables import tables
from artgen.export.layouts.partnet.urdf import ROOT_MASS, urdf_text
from artgen.export.losses import Layout, Loss, Written, look_losses, loss
from artgen.export.urdf.losses import material_losses, motion_losses

MAIN = "mobility.urdf"
"""File for most loaders."""

TWIN = "mobility_cvx.urdf"
"""File for ManiSkill, which has convex colliders in the dataset."""


def write_partnet(asset: Asset, name: str, textures: int) -> Written:
    """Write an asset in the layout of PartNet-Mobility; see `Layout.write`."""
    assert name == "urdf"
    named = naming(asset)
    meshes = object_meshes(asset, textures)
    text = urdf_text(asset, named, meshes)
    files = {MAIN: text, TWIN: text, **tables(asset, named, meshes.surfaces), **meshes.files}
    return Written(files, _losses(asset, named, textures), main=MAIN)


def _losses(asset: Asset, named: Naming, textures: int) -> tuple[Loss, ...]:
    joints = [step.segment.joint for step in named.steps]
    between = [joint.name for joint in joints if not joint.locked and not _closes_at_an_end(joint.limits)]
    return (
        *loss(
            "names of links and joints",
            [
                *(f"{name} = {named.body(name)}" for name in named.links),
                *(f"{step.segment.joint.name} = {step.name}" for step in named.steps),
            ],
            f"numbers, for loaders look for them; {NAMES_FILE} has the names, semantics.txt the labels",
        ),
        *loss(
            "direction of a joint",
            [step.segment.joint.name for step in named.steps if step.sign < 0],
            "the opposite axis, so that the lower limit is the closed end",
        ),
        *loss("closed position", between, "limits on both sides of it: it is not the lower one"),
        *loss(
            "joint coupling",
            [item.follower.segment.joint.name for item in named.couplings if item.siblings],
            f"nothing: SAPIEN turns it round where both joints start from one body; it is in {NAMES_FILE}",
        ),
        *loss("body without geometry", [ROOT], f"a link of {ROOT_MASS:g} kg that turns the asset upright"),
        *motion_losses(asset, [step.child for step in named.steps if step.segment.child.link is None]),
        *loss(
            "grasp frame",
            [each.name for each in asset.affordances if each.kind == "grasp"],
            "the visual there has handle in its name; the frames are in asset.json",
        ),
        *loss(
            "push frame",
            [each.name for each in asset.affordances if each.kind == "push"],
            "nothing; the frames are in asset.json",
        ),
        *material_losses(asset),
        *look_losses(asset, textures),
    )


def _closes_at_an_end(limits: tuple[float, float] | None) -> bool:
    """Return whether the position nearest to 0 is a limit; False without limits."""
    return limits is None or not limits[0] < 0.0 < limits[1]


PARTNET_MOBILITY = Layout(
    "partnet-mobility",
    "as the PartNet-Mobility dataset, for SAPIEN, ManiSkill and loaders of GAPartNet's kind",
    ("urdf",),
    1,
    write_partnet,
)
