"""Where hands act, as USD prims: frames on the links, and the line along which a gripper closes."""

from collections.abc import Sequence

import numpy as np
from pxr import Sdf, Vt

from artgen._arrays import Array
from artgen.asset import Affordance, Asset
from artgen.export.frames import local
from artgen.export.usd.layer import TYPES, define, int_array, place, vec3_array, write

_THICKNESS = 0.002
"""Width of the drawn line [m]."""


def write_holds(prim: Sdf.PrimSpec, asset: Asset, found: Sequence[Affordance]) -> None:
    """Add the grasps and pushes of a link, unseen by cameras.

    Each is a frame with z along the approach; x of a grasp is the closing direction. Its custom data have the
    kind, the opening that the fingers need [m] and the joints that a hand moves there, the nearest first.

    Args:
        prim: The prim of the link.
        asset: The asset.
        found: What a hand can do with the link.
    """
    for kind, scope_name in (("grasp", "grasps"), ("push", "pushes")):
        of_kind = [each for each in found if each.kind == kind]
        if of_kind:
            scope = define(prim, scope_name, "Scope")
            for affordance in of_kind:
                _hold(scope, affordance, local(asset, affordance.link, affordance.frame))


def _hold(scope: Sdf.PrimSpec, affordance: Affordance, pose: Array) -> None:
    prim = define(scope, affordance.name, "Xform")
    said = {"joints": Vt.StringArray(affordance.joints), "kind": affordance.kind}
    if affordance.kind == "grasp":
        said["width"] = affordance.width
    prim.SetInfo("customData", {"artgen": said})
    write(prim, TYPES.Token, {"purpose": "guide"}, uniform=True)
    place(prim, pose)
    if affordance.kind == "grasp":
        _line(prim, affordance)


def _line(prim: Sdf.PrimSpec, affordance: Affordance) -> None:
    """Add the line from finger to finger through what they hold; SimReady knows it by its name."""
    line = define(prim, f"grasp_identifier_{affordance.name}", "BasisCurves")
    # in single precision from here on, since readers compute the extent of what is written
    half, margin = np.float32(0.5 * affordance.width), np.float32(0.5) * np.float32(_THICKNESS)
    ends = np.array([[-half, 0.0, 0.0], [half, 0.0, 0.0]], np.float32)
    write(line, TYPES.Point3fArray, {"points": vec3_array(ends)})
    write(line, TYPES.IntArray, {"curveVertexCounts": int_array(np.array([2]))})
    write(line, TYPES.Token, {"type": "linear"}, uniform=True)
    write(line, TYPES.FloatArray, {"widths": Vt.FloatArray([_THICKNESS])}, interpolation="constant")
    write(line, TYPES.Float3Array, {"extent": vec3_array(ends + np.array([[-margin], [margin]]))})
