"""Layout of the PartNet-Mobility dataset for SAPIEN, ManiSkill and loaders such as GAPartNet's.

`mobility.urdf` has one collider per convex piece, so its convex twin for ManiSkill is equal. The closed end
of joints in the dataset is the lower limit: a joint that closes at its upper limit is reversed; a joint that
closes between its limits, such as a knob that turns both ways, keeps them.

The dataset has no couplings. SAPIEN 3.0 reads a coupling between two joints of the same body in the wrong
direction, which blocks both, so those are only in the table of names.
"""

from collections.abc import Iterator

from artgen.asset import Asset, AssetJoint
from artgen.export.layouts.partnet.names import ROOT, UPRIGHT, Naming, naming
from artgen.export.layouts.partnet.tables import tables
from artgen.export.layouts.partnet.urdf import urdf_text
from artgen.export.losses import Layout, Row, Written, affordance_rows, look_rows, losses
from artgen.export.meshes import arranged_files
from artgen.export.names import NAMES_FILE
from artgen.export.urdf import MARKER_MASS, material_rows, motion_rows

MAIN = "mobility.urdf"
"""File for most loaders."""

TWIN = "mobility_cvx.urdf"
"""File for ManiSkill, which has convex colliders in the dataset."""

VISUALS = "textured_objs"
"""Directory of visual meshes with their MTL file and maps; readers take every OBJ file in it as visible."""

COLLIDERS = "convex_objs"
"""Directory of convex pieces."""


def write_partnet(asset: Asset, name: str, textures: int) -> Written:
    """Write an asset in the layout of PartNet-Mobility; see `Layout.write`."""
    assert name == "urdf"
    named = naming(asset)
    meshes = arranged_files(asset, textures, (VISUALS, COLLIDERS), "materials.mtl", UPRIGHT)
    text = urdf_text(asset, named, meshes)
    files = {MAIN: text, TWIN: text, **tables(asset, named, meshes.surfaces), **meshes.files}
    return Written(files, losses(*_rows(asset, named), *look_rows(asset, textures)), main=MAIN)


def _rows(asset: Asset, named: Naming) -> Iterator[Row]:
    joints = {step.segment.joint.name: step for step in named.steps}
    names = [f"{link} = {named.body(link)}" for link in named.links]
    names += [f"{joint} = {step.name}" for joint, step in joints.items()]
    instead = f"numbers, for loaders look for them; {NAMES_FILE} has the names, semantics.txt the labels"
    yield "names of links and joints", names, instead
    reversed_joints = [name for name, step in joints.items() if step.sign < 0]
    instead = "the opposite axis, so that the lower limit is the closed end"
    yield "direction of a joint", reversed_joints, instead
    between = [name for name, step in joints.items() if not _closes_at_an_end(step.segment.joint)]
    yield "closed position", between, "limits on both sides of it: it is not the lower one"
    siblings = [item.follower.segment.joint.name for item in named.couplings if item.siblings]
    instead = f"nothing: SAPIEN turns it round where both joints start from one body; it is in {NAMES_FILE}"
    yield "joint coupling", siblings, instead
    yield "body without geometry", [ROOT], f"a link of {MARKER_MASS:g} kg that turns the asset upright"
    yield from motion_rows(asset, [step.child for step in named.steps if step.segment.child.link is None])
    instead = "the visual there has handle in its name; the frames are in asset.json"
    yield from affordance_rows(asset, instead, "nothing; the frames are in asset.json")
    yield from material_rows(asset)


def _closes_at_an_end(joint: AssetJoint) -> bool:
    """Return whether the position nearest to 0 is a limit or the joint has no range."""
    return joint.locked or joint.limits is None or not joint.limits[0] < 0.0 < joint.limits[1]


PARTNET_MOBILITY = Layout(
    "partnet-mobility",
    "as the PartNet-Mobility dataset, for SAPIEN, ManiSkill and loaders of GAPartNet's kind",
    ("urdf",),
    ("urdf",),
    write_partnet,
)
