"""The viewer of an asset as a page: joints, symbols, exploded view, parameters and proof."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.certificate import Certificate, PairResult
from artgen.asset.record import plain
from artgen.export import write_glb
from artgen.export.frames import regions
from artgen.export.glb.animations import opening
from artgen.materials.textures import check_size
from artgen.view.camera import box_corners
from artgen.view.overlays import collider_mesh, joint_symbol, label_colors
from artgen.view.page import Page, page_html, three_js
from artgen.view.sheet import shots

_SCRIPTS = ("elements", "kinematics", "controller", "studio", "model", "symbols", "orbit", "panel", "main")
_DECIMALS = 5  # decimals of drawn points: 10 micrometres
_GAP = 0.06  # free space between two boxes, as a share of the asset's size
_FAR = 0.5  # share of its own length above which a slide moves out along its axis, unlike a bolt
_SIDES = np.concatenate([np.eye(3), -np.eye(3)])


def page_of(asset: Asset, *, textures: int = 512, height: int = 600) -> Page:
    """Make the viewer of an asset.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.
        height: Height of the notebook cell [pixels].

    Raises:
        ParameterError: The size of maps is not allowed.
        AssetError: The asset was read from files that have no surfaces.
    """
    if textures:
        check_size(textures, plain=True)
    (model,) = write_glb(asset, textures).files.values()
    scripts = [f"view/web/{name}.js" for name in _SCRIPTS]
    data = viewer_data(asset)
    text = page_html("view/web/viewer", asset.name, scripts, data, three=three_js(), model=model)
    return Page(asset.name, text, height)


def viewer_data(asset: Asset) -> dict[str, Any]:
    """Return the data of the viewer for an asset, without its meshes."""
    (open_pose, view), shifts = shots(asset)[1], exploded(asset)
    return {
        "name": asset.name,
        "category": asset.category,
        "seed": asset.seed,
        "mass": asset.mass,
        "bounds": asset.bounds().tolist(),
        "space": _space(asset, ({}, open_pose)),
        "view": {"azimuth": view.azimuth, "elevation": view.elevation},
        "links": [_link(asset, link, shifts[link.name]) for link in asset.links],
        "joints": [_joint(asset, joint) for joint in asset.joints],
        "outputs": [{**plain(each), "text": str(each)} for each in asset.outputs],
        "open": open_pose,
        "parameters": plain(asset.parameters),
        "colors": {label: list(color) for label, color in label_colors(asset).items()},
        "certificate": _certificate(asset),
    }


def _space(asset: Asset, poses: Sequence[Mapping[str, float]]) -> Any:
    """Return the corners of the bounding box of an asset in several poses, shape (2, 3) [m]."""
    corners = []
    for q in poses:
        corners += [box_corners(asset.link(name).bounds(), pose) for name, pose in asset.pose(q).items()]
    points = np.concatenate(corners)
    return _drawn(np.array([points.min(axis=0), points.max(axis=0)]))


def _link(asset: Asset, link: Link, shift: Array) -> dict[str, Any]:
    colliders = [(each.label, *collider_mesh(each.convex)) for each in link.colliders]
    return {
        "name": link.name,
        "label": link.label,
        "origin": asset.origin(link.name).tolist(),
        "shift": _drawn(shift),
        "mass": link.mass_properties.mass,
        "center": _drawn(link.mass_properties.center),
        "colliders": [
            {"label": label, "vertices": _drawn(vertices.ravel()), "triangles": triangles.ravel().tolist()}
            for label, vertices, triangles in colliders
        ],
        "holds": [
            {"name": each.name, "kind": each.kind, "frame": each.frame.tolist(), "width": each.width}
            for each in asset.affordances
            if each.link == link.name
        ],
    }


def _joint(asset: Asset, joint: AssetJoint) -> dict[str, Any]:
    """Return the data of a joint for `asset.positions`, `asset.blocked` and `asset.pose`, and its symbol."""
    stops = opening(asset, joint) if joint in asset.free_joints else None
    drawn = None
    if not joint.locked:
        symbol = joint_symbol(asset, joint)
        drawn = {name: _drawn(getattr(symbol, name)) for name in ("axis", "range", "hand")}
    return {
        **joint.to_data(),
        "closed": joint.closed,
        "locked": joint.locked,
        "stops": None if stops is None else list(stops),
        "symbol": drawn,
    }


def _certificate(asset: Asset) -> dict[str, Any] | None:
    """Return the certificate of an asset, each pair with its worst pose."""
    certificate = _measured(asset)
    if certificate is None:
        return None
    clear = [pair for pair in certificate.pairs if pair.clear]
    clear.sort(key=lambda pair: (math.inf if pair.guaranteed is None else pair.guaranteed, pair.links))
    return {
        "proven": certificate.proven,
        "tolerance": certificate.tolerance,
        "text": str(certificate).partition("\n")[0],
        "contacts": [str(contact) for contact in certificate.contacts],
        "pairs": [_pair(asset, pair) for pair in (*certificate.failures, *clear)],
    }


def _measured(asset: Asset) -> Certificate | None:
    """Return the certificate of an asset with the nearest pose of each pair, if all pairs are proven."""
    certificate = asset.certificate
    if certificate is None or not certificate.proven or any(pair.found_at for pair in certificate.pairs):
        return certificate
    # a copy, so that the asset keeps its own certificate
    return replace(asset).certify(certificate.tolerance, measure=True)


def _pair(asset: Asset, pair: PairResult) -> dict[str, Any]:
    witness, place, depth = pair.witness, None, None
    pose: Mapping[str, float] = pair.found_at
    if witness is not None:
        pose, place, depth = witness.pose, list(witness.place), witness.depth
    elif not pair.clear and pair.open_cells:
        region = pair.open_cells[0].region
        pose = {name: (low + high) / 2.0 for name, (low, high) in region.items()}
    return {
        "links": list(pair.links),
        "clear": pair.clear,
        "text": str(pair),
        "guaranteed": pair.guaranteed,
        "pose": _allowed(asset, pose),
        "place": place,
        "depth": depth,
    }


def _allowed(asset: Asset, pose: Mapping[str, float]) -> dict[str, float]:
    """Return a pose of several joints with positions of the other joints that satisfy the dependencies."""
    # behind two doors, the nearest pose to one does not include the other, which has to be open
    result = dict(pose)
    for name in asset.blocked(pose):
        needs = asset.joint(name).needs
        assert needs is not None
        for region in regions(asset, needs.condition):
            others = {each: _middle(asset, each, region[each]) for each in region if each not in pose}
            if name not in asset.blocked({**result, **others}):
                result |= others
                break
    return result


def _middle(asset: Asset, name: str, interval: tuple[float, float]) -> float:
    """Return the center of the intersection of an interval with the limits of a joint."""
    limits = asset.joint(name).limits or (-np.pi, np.pi)
    low, high = max(interval[0], limits[0]), min(interval[1], limits[1])
    return float(min(max((low + high) / 2.0, limits[0]), limits[1]))


def _drawn(points: Array) -> Any:
    """Return points as lists, rounded to visible digits."""
    return (np.round(points, _DECIMALS) + 0.0).tolist()


def exploded(asset: Asset) -> dict[str, Array]:
    """Return the offset of each link in an exploded view, in asset coordinates at rest, shape (3,) [m].

    Long slides move along their axes, all other links by the shortest distance out of their parent's box.
    """
    low, high = asset.bounds()
    return _separated(asset, asset.links[0].name, _GAP * float(np.linalg.norm(high - low)))[1]


def _separated(asset: Asset, link: str, gap: float) -> tuple[Array, dict[str, Array]]:
    """Return the box of a link with its separated descendants, shape (2, 3) [m], and the offset of each."""
    own = asset.link(link).bounds()
    children = [
        (_side(own, asset.link(child).bounds(), joints), *_separated(asset, child, gap))
        for parent, child, joints in asset.pairs()
        if parent == link
    ]
    # on each side, inner children are placed first
    children.sort(key=lambda each: round(float((each[0] @ each[1].T).max()), 6))
    boxes, shifts = [own], {link: np.zeros(3)}
    for side, box, inner in children:
        shift = max(0.0, *(_distance(box, other, side, gap) for other in boxes)) * side
        boxes.append(box + shift)
        shifts |= {name: before + shift for name, before in inner.items()}
    corners = np.array(boxes)
    return np.array([corners[:, 0].min(axis=0), corners[:, 1].max(axis=0)]), shifts


def _side(parent: Array, child: Array, joints: Sequence[AssetJoint]) -> Array:
    """Return the direction along an axis in which a child leaves its parent, boxes of shape (2, 3)."""
    for joint in reversed(joints):
        low, high = joint.limits or (0.0, 0.0)
        motion = joint.axis * (high if high + low >= 0.0 else low)
        side = np.asarray(_SIDES[int(np.argmax(np.round(_SIDES @ motion, 9)))])
        if joint.kind == "prismatic" and motion @ side >= _FAR * abs(side @ (child[1] - child[0])):
            return side
    distances = [_distance(child, parent, side, 0.0) for side in _SIDES]
    return np.asarray(_SIDES[int(np.argmin(np.round(distances, 6)))])


def _distance(box: Array, other: Array, side: Array, gap: float) -> float:
    """Return the motion of a box in one direction until another one is behind it; 0 if it passes it [m]."""
    across = side == 0.0
    if ((box[0] >= other[1]) | (box[1] <= other[0]))[across].any():
        return 0.0
    return float((side @ other.T).max() - (side @ box.T).min()) + gap
