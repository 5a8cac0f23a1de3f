"""The layout of the PartNet-Mobility dataset, which SAPIEN, ManiSkill and loaders of GAPartNet's kind read.

`mobility.urdf` has one collider for each convex piece, so its convex twin, which ManiSkill asks for, says the
same. The dataset's closed end is the lower limit: a joint that closes at its upper limit is turned round; one
that closes between its limits, as a knob that turns both ways, keeps them.

The dataset has no couplings. SAPIEN 3.0 reads one between two joints of the same body the wrong way round,
which blocks both, so those are left to the table of names.
"""

from artgen.asset import Asset
from artgen.export.layouts.partnet.meshes import object_meshes
from artgen.export.layouts.partnet.names import NAMES_FILE, ROOT, Naming, naming
from artgen.export.layouts.partnet.tables import tables
from artgen.export.layouts.partnet.urdf import ROOT_MASS, urdf_text
from artgen.export.losses import Layout, Loss, Written, look_losses, loss
from artgen.export.urdf.losses import material_losses, motion_losses

MAIN = "mobility.urdf"
"""The file that most loaders open."""

TWIN = "mobility_cvx.urdf"
"""The file that ManiSkill opens, which in the dataset has convex colliders."""


def write_partnet(asset: Asset, name: str, textures: int) -> Written:
    """Write an asset as PartNet-Mobility has it; see `Layout.write`."""
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
    """Return whether the position nearest to 0 is an end of the limits; without limits there is none."""
    return limits is None or not limits[0] < 0.0 < limits[1]


PARTNET_MOBILITY = Layout(
    "partnet-mobility",
    "as the PartNet-Mobility dataset, for SAPIEN, ManiSkill and loaders of GAPartNet's kind",
    ("urdf",),
    1,
    write_partnet,
)
