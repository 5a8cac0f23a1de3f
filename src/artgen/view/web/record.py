"""Data of the viewer as JSON: joints, links, symbols, exploded view, parameters and proof of an asset."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.asset.certificate import Certificate, PairResult
from artgen.export.frames import regions
from artgen.export.glb.motion import opening
from artgen.view.camera import box_corners
from artgen.view.opening import opened
from artgen.view.overlays import Overlays, overlays
from artgen.view.sheet import shots

_GAP = 0.06  # free space between two boxes, as a share of the asset's size
_FAR = 0.5  # share of its own length above which a slide comes out in its direction, unlike a bolt
_SIDES = np.concatenate([np.eye(3), -np.eye(3)])


@dataclass
class _Group:
    """A link with its descendants, already separated."""

    box: Array  # corners of its bounding box, shape (2, 3) [m]
    shifts: dict[str, Array]  # offset of each of its links by name, shape (3,) [m]

    def moved(self, shift: Array) -> "_Group":
        """Return the group with an offset, shape (3,) [m]."""
        return _Group(self.box + shift, {name: before + shift for name, before in self.shifts.items()})


def exploded(asset: Asset) -> dict[str, Array]:
    """Return the offset of each link in an exploded view, in asset coordinates at rest, shape (3,) [m].

    Long slides move in their direction, all other links by the shortest way out of the box of their parent.
    """
    low, high = asset.bounds()
    return _group(asset, asset.links[0].name, _GAP * float(np.linalg.norm(high - low))).shifts


def _group(asset: Asset, link: str, gap: float) -> _Group:
    """Move the children of a link away from it, the nearest first."""
    whole = _Group(asset.link(link).bounds(), {link: np.zeros(3)})
    own = whole.box
    children = []
    for parent, child, joints in asset.pairs():
        if parent == link:
            side = _side(own, asset.link(child).bounds(), joints)
            children.append((side, _group(asset, child, gap)))
    # on one side, outer children have to leave room for inner ones
    children.sort(key=lambda each: round(float((each[0] @ each[1].box.T).max()), 6))
    placed: list[_Group] = []
    for side, group in children:
        way = max(
            (_way(group.box, other, side, gap) for other in (own, *(one.box for one in placed))), default=0.0
        )
        placed.append(group.moved(max(way, 0.0) * side))
    for group in placed:
        whole.box = np.array([np.minimum(whole.box[0], group.box[0]), np.maximum(whole.box[1], group.box[1])])
        whole.shifts |= group.shifts
    return whole


def _side(parent: Array, child: Array, joints: Sequence[AssetJoint]) -> Array:
    """Return the direction along an axis in which a child leaves its parent, boxes of shape (2, 3)."""
    for joint in reversed(joints):
        low, high = joint.limits or (0.0, 0.0)
        way = joint.axis * (high if high + low >= 0.0 else low)
        side = np.asarray(_SIDES[int(np.argmax(np.round(_SIDES @ way, 9)))])
        if joint.kind == "prismatic" and way @ side >= _FAR * abs(side @ (child[1] - child[0])):
            return side
    ways = [_way(child, parent, side, 0.0) for side in _SIDES]
    return np.asarray(_SIDES[int(np.argmin(np.round(ways, 6)))])


def _way(box: Array, other: Array, side: Array, gap: float) -> float:
    """Return the distance of a box in one direction until another one is behind it; 0 if it passes it [m]."""
    across = side == 0.0
    if ((box[0] >= other[1]) | (box[1] <= other[0]))[across].any():
        return 0.0
    return float((side @ other.T).max() - (side @ box.T).min()) + gap


_DECIMALS = 5  # decimals of drawn points: 10 micrometres


def viewer_data(asset: Asset) -> dict[str, Any]:
    """Return the data of the viewer for an asset, without its meshes."""
    signs = overlays(asset)
    low, high = asset.bounds()
    view = shots(asset)[1][1]
    return {
        "name": asset.name,
        "category": asset.category,
        "seed": asset.seed,
        "version": asset.version,
        "base": asset.base,
        "mass": asset.mass,
        "bounds": [low.tolist(), high.tolist()],
        "space": _space(asset, ({}, opened(asset))),
        "view": {"azimuth": view.azimuth, "elevation": view.elevation},
        "links": _links(asset, signs),
        "joints": [_joint(asset, joint, signs) for joint in asset.joints],
        "open": opened(asset),
        "parameters": {name: plain_value(value) for name, value in asset.parameters.items()},
        "colors": {label: list(color) for label, color in signs.colors.items()},
        "certificate": _certificate(asset),
    }


def _space(asset: Asset, poses: Sequence[Mapping[str, float]]) -> Any:
    """Return the corners of the bounding box of an asset in several poses, shape (2, 3) [m]."""
    corners = []
    for q in poses:
        corners += [box_corners(asset.link(name).bounds(), pose) for name, pose in asset.pose(q).items()]
    points = np.concatenate(corners)
    return _drawn(np.array([points.min(axis=0), points.max(axis=0)]))


def _links(asset: Asset, signs: Overlays) -> list[dict[str, Any]]:
    shifts = exploded(asset)
    result = []
    for link in asset.links:
        sign = signs.links[link.name]
        result.append(
            {
                "name": link.name,
                "label": link.label,
                "origin": asset.origin(link.name).tolist(),
                "shift": _drawn(shifts[link.name]),
                "mass": sign.mass,
                "center": _drawn(sign.center),
                "colliders": [
                    {
                        "label": each.label,
                        "vertices": _drawn(each.vertices.ravel()),
                        "triangles": each.triangles.ravel().tolist(),
                    }
                    for each in sign.colliders
                ],
                "holds": [
                    {
                        "name": each.name,
                        "kind": each.kind,
                        "frame": each.frame.tolist(),
                        "width": each.width,
                    }
                    for each in sign.holds
                ],
            }
        )
    return result


def _joint(asset: Asset, joint: AssetJoint, signs: Overlays) -> dict[str, Any]:
    """Return the data of a joint for `asset.positions`, `asset.blocked` and `asset.pose`, and its symbol."""
    sign = signs.joints.get(joint.name)
    needs = None if joint.needs is None else {**joint.needs.to_data(), "text": str(joint.needs)}
    stops = opening(asset, joint) if joint in asset.free_joints else None
    return {
        **joint.to_data(),
        "closed": joint.closed,
        "locked": joint.locked,
        "needs": needs,
        "stops": None if stops is None else list(stops),
        "sign": None
        if sign is None
        else {"axis": _drawn(sign.axis), "range": _drawn(sign.range), "hand": _drawn(sign.hand)},
    }


def _certificate(asset: Asset) -> dict[str, Any] | None:
    """Return the certificate of an asset, each pair with its worst pose."""
    certificate = _measured(asset)
    if certificate is None:
        return None
    order = [*certificate.failures, *sorted((pair for pair in certificate.pairs if pair.clear), key=_room)]
    return {
        "proven": certificate.proven,
        "tolerance": certificate.tolerance,
        "text": str(certificate).partition("\n")[0],
        "contacts": [str(contact) for contact in certificate.contacts],
        "pairs": [_pair(asset, pair) for pair in order],
    }


def _measured(asset: Asset) -> Certificate | None:
    """Return the certificate of an asset with the nearest pose of each pair, if all pairs are proven."""
    certificate = asset.certificate
    if certificate is None or not certificate.proven or any(pair.found_at for pair in certificate.pairs):
        return certificate
    # a copy: the asset keeps its own certificate
    return replace(asset).certify(certificate.tolerance, measure=True)


def _room(pair: PairResult) -> tuple[float, tuple[str, str]]:
    return float("inf") if pair.guaranteed is None else pair.guaranteed, pair.links


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
        "found": pair.found,
        "pose": _allowed(asset, pose),
        "place": place,
        "depth": depth,
    }


def _allowed(asset: Asset, pose: Mapping[str, float]) -> dict[str, float]:
    """Return a pose of several joints, with the others where the dependencies of these joints hold.

    For a drawer behind two doors, the nearest pose to one door does not include the other door, which has to
    be open.
    """
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


def plain_value(value: Any) -> Any:
    """Return a parameter as JSON has it."""
    return value.item() if isinstance(value, np.generic) else value


def _drawn(points: Array) -> Any:
    """Return points as lists, with the visible digits."""
    return (np.round(points, _DECIMALS) + 0.0).tolist()
