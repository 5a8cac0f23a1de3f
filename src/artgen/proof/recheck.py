"""Verification of a stored proof, without the search that found it and without FCL.

Each cell states that a plane separates pieces of two links in a region of their joint space. The check
verifies that each plane does so, by the closed-form bounds; that the cells of a pair cover all pieces and the
whole joint space; and that the pieces contain the solids.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.certificate import AXIS_FRAME, PROOF_FORMAT, Certificate, PairResult
from artgen.asset.report import Finding
from artgen.errors import AssetError
from artgen.proof.bounds import Motion, around_axis, axis_gap, gap
from artgen.proof.cover import Cover, slot_hosts, stored_cover
from artgen.proof.overlap import allows
from artgen.proof.paths import JointPath, space_of

_BEYOND = 2e-9  # distance by which cells may extend beyond the ends of a range [rad or m]
_TOUCHING = 2e-8  # tolerance of the allowed depth of pieces in contact [m]
_ROUNDING = 1e-9  # rounding of numbers in files [m]
_BOX = (
    np.indices((2, 2, 2)).reshape(3, 8).T
)  # for each corner of a box, the number of the end in each direction


def recheck(
    asset: Asset,
    certificate: Certificate,
    *,
    overlap: float = 0.0,
    only: Callable[[JointPath], bool] = lambda joint_path: True,
) -> list[Finding]:
    """Verify the proof of a certificate; return a finding for each statement that is wrong.

    Args:
        asset: The asset.
        certificate: Its certificate.
        overlap: Overlap that the certificate may permit [m].
        only: Selects the pairs that the certificate must have.

    Raises:
        AssetError: A dependency of the asset cannot be satisfied, or its meshes are missing.
    """
    space = space_of(asset)
    space.check()
    joint_paths = {joint_path.links: joint_path for joint_path in space.joint_paths(only)}
    stated = {pair.links for pair in certificate.pairs}
    findings = [
        _fault("the certificate has no result for this pair, which can move", links)
        for links in joint_paths
        if links not in stated
    ]
    hosts, loose = slot_hosts(asset)
    findings += [_fault(reason, [link]) for link, reason in loose]
    if dict(certificate.slots) != hosts:
        findings.append(_fault("its empty slots are not those of the asset", sorted(hosts)))
    proof = certificate.leaves
    if proof is None:
        return [*findings, _fault("the proof in certificate.json is missing")]
    if proof.get("format") != PROOF_FORMAT:
        marked = f"{proof.get('format')!r} instead of {PROOF_FORMAT!r}"
        return [*findings, _fault(f"the proof in certificate.json has format {marked}")]
    if not certificate.tolerance >= -overlap:
        return [*findings, _fault(f"its tolerance is {certificate.tolerance!r} m")]
    try:
        for pair in certificate.pairs:
            for stored in _stored(pair, proof):
                findings += _recheck_pair(
                    asset, certificate.tolerance, pair, joint_paths[pair.links], stored, proof
                )
    except AssetError:
        raise
    except (KeyError, ValueError, TypeError, IndexError) as error:
        findings.append(_fault(f"the proof in certificate.json is damaged ({error!r})"))
    return findings


def _fault(message: str, links: Sequence[str] = (), **details: Any) -> Finding:
    hint = "certify the asset again and export it"
    return Finding("certificate", message, link=", ".join(links), hint=hint, **details)


def _stored(pair: PairResult, proof: Mapping[str, Any]) -> Iterator[Mapping[str, Any] | None]:
    """Yield the proofs of a pair: of its solids, and of its colliders if they are separate."""
    found = [item for item in proof["pairs"] if tuple(item["links"]) == pair.links]
    of_colliders = [item for item in found if _on_colliders(item, pair, proof)]
    solids = found[0] if found else None
    if pair.verdict == "proven":
        yield solids
    if pair.colliders == "proven" and (pair.verdict != "proven" or (found and solids not in of_colliders)):
        yield of_colliders[0] if of_colliders else None


def _on_colliders(item: Mapping[str, Any], pair: PairResult, proof: Mapping[str, Any]) -> bool:
    return all(proof["pieces"][item["pieces"]][name]["points"] is None for name in pair.links)


def _recheck_pair(
    asset: Asset,
    tolerance: float,
    pair: PairResult,
    joint_path: JointPath,
    stored: Mapping[str, Any] | None,
    proof: Mapping[str, Any],
) -> Iterator[Finding]:
    if stored is None:
        yield _fault("there is no proof of this pair", pair.links)
        return
    covers = [_cover(asset, name, proof["pieces"][stored["pieces"]][name]) for name in pair.links]
    solids = pair.verdict == "proven" and (
        pair.colliders != "proven"
        or not _on_colliders(stored, pair, proof)
        or sum(tuple(item["links"]) == pair.links for item in proof["pairs"]) == 1
    )
    for name, cover in zip(pair.links, covers, strict=True):
        if cover.excess is None and solids:
            yield _fault("its solids extend beyond the pieces of the proof", [name])
    least = tolerance
    if solids and pair.guaranteed is not None:
        least = max(tolerance, pair.guaranteed)
    # normals are rounded as lengths are, which counts by the distance of what they separate
    rounding = _ROUNDING * (1.0 + max(least, 0.0))
    wanted = least + sum(cover.excess or 0.0 for cover in covers) - rounding
    table = np.array(stored["leaves"], float).reshape(-1, 8 + 2 * len(joint_path.variables))
    for row in table:
        limit = _limit(joint_path, covers, row, wanted)
        apart = _gap(joint_path, covers, row, boxes=True)
        if not apart > limit:
            apart = _gap(joint_path, covers, row, boxes=False)
        if not apart > limit:
            gap_text, limit_text = f"{1e3 * apart:.6f} mm", f"{1e3 * limit:.6f} mm"
            message = f"a plane of the proof leaves a gap of {gap_text} instead of {limit_text}"
            yield _fault(message, pair.links, value=apart, unit="m")
            return
    cells = np.concatenate((table[:, :4].reshape(-1, 2, 2), table[:, 8:].reshape(len(table), -1, 2)), axis=1)
    pieces = np.array([[0, len(cover.points)] for cover in covers], float)
    for box in joint_path.boxes:
        missed = uncovered(cells, np.concatenate((pieces, box)))
        if missed is not None:
            pose = dict(zip(joint_path.variables, missed[2:].mean(axis=1).tolist(), strict=True))
            yield _fault("the proof does not cover all of the joint space", pair.links, pose=pose)


def _cover(asset: Asset, link: str, stored: Mapping[str, Any]) -> Cover:
    """Return the pieces of a link in the order in which cells number them."""
    cover, order = stored_cover(asset.link(link), stored), [int(index) for index in stored["order"]]
    if sorted(order) != list(range(len(cover.points))):
        raise ValueError(
            f"the order of the pieces of {link!r} is no permutation of its {len(cover.points)} pieces"
        )
    points = tuple(cover.points[index] for index in order)
    return replace(cover, points=points, labels=tuple(cover.labels[index] for index in order))


def _gap(joint_path: JointPath, covers: Sequence[Cover], row: Array, *, boxes: bool) -> float:
    """Return the bound of a cell's gap [m]; with `boxes` that of bounding boxes, which is less and fast."""
    ranges, frame, normal = row[:4].astype(int), int(row[4]), row[5:8]
    low, high = row[8::2], row[9::2]
    first, second = covers[0].points[slice(*ranges[:2])], covers[1].points[slice(*ranges[2:])]
    if min(ranges) < 0 or (frame != AXIS_FRAME and not 0 <= frame <= len(joint_path.steps)):
        raise ValueError(f"the cell {row.tolist()} counts from below 0 or beyond the joints")
    path = []
    for joint, sign, follower in zip(joint_path.steps, joint_path.signs, joint_path.followers, strict=True):
        number = joint_path.variables.index(follower.leader) if follower.leader else 0
        center, half = follower.interval(low[number : number + 1], high[number : number + 1])
        axis = (sign * joint.axis)[None]
        path.append(Motion(joint.kind, joint.pivot[None], axis, center, half))
    if frame == AXIS_FRAME:
        return _axis_gap(joint_path, first, second, path)
    length = _portable.norm(normal)
    if not length > _ROUNDING:
        return -np.inf
    a, b = (_corners(pieces) if boxes else np.concatenate(pieces) for pieces in (first, second))
    return float(gap(a[None], b[None], path, frame, normal[None, None] / length)[0, 0])


def _corners(pieces: Sequence[Array]) -> Array:
    """Return the corners of the bounding box of pieces, or the vertices of a single one [m]."""
    points = np.concatenate(pieces)
    return points if len(pieces) == 1 else np.array([points.min(axis=0), points.max(axis=0)])[_BOX, range(3)]


def _axis_gap(
    joint_path: JointPath, first: Sequence[Array], second: Sequence[Array], path: Sequence[Motion]
) -> float:
    """Return the bound of the gap of pieces whose joints all have the axis of the first joint [m]."""
    axis, origin = joint_path.steps[0].axis, joint_path.steps[0].pivot
    for joint in joint_path.steps:
        away = (joint.pivot - origin) if joint.kind == "revolute" else np.zeros(3)
        if np.abs(np.cross([joint.axis, away], axis)).max() > _ROUNDING:
            return -np.inf
    slides = [motion for motion in path if motion.kind == "prismatic"]
    shift = sum((_portable.dot(motion.axis[0], axis) * motion.center for motion in slides), np.zeros(1))
    half = sum((motion.half for motion in slides), np.zeros(1))
    about = [[around_axis(points[None], origin, axis) for points in side] for side in (first, second)]
    return min(float(axis_gap(a, b, shift, half)[0]) for a in about[0] for b in about[1])


def _limit(joint_path: JointPath, covers: Sequence[Cover], row: Array, wanted: float) -> float:
    """Return the gap that a cell has to prove, negative for two pieces that may touch [m]."""
    ranges, cell = row[:4].astype(int), row[8:].reshape(-1, 2)
    if ranges[1] - ranges[0] != 1 or ranges[3] - ranges[2] != 1:
        return wanted
    labels = covers[0].labels[ranges[0]], covers[1].labels[ranges[2]]
    depths = [
        contact.depth
        for box, allowed in zip(joint_path.boxes, joint_path.allowed, strict=True)
        if (box[:, 0] - _BEYOND <= cell[:, 0]).all() and (cell[:, 1] <= box[:, 1] + _BEYOND).all()
        for contact in allowed
        if allows(contact, joint_path.links, labels)
    ]
    return -max(depths) - _TOUCHING if depths else wanted


def uncovered(cells: Array, region: Array) -> Array | None:
    """Return a part of a region, shape (d, 2), that cells, shape (n, d, 2), do not cover; None if they do."""
    todo = [(np.arange(len(cells)), region)]
    while todo:
        rows, part = todo.pop()
        low, high = cells[rows, :, 0], cells[rows, :, 1]
        flat = part[:, 0] == part[:, 1]
        within = (low <= part[:, 0]) & (high >= part[:, 1])
        meets = np.where(flat, within, (low < part[:, 1]) & (high > part[:, 0])).all(axis=1)
        if not meets.any():
            return part
        if within.all(axis=1).any():
            continue
        rows, low, high = rows[meets], low[meets], high[meets]
        inner = np.concatenate((low, high))
        candidate, dimension = np.nonzero((inner > part[:, 0]) & (inner < part[:, 1]))
        place = float(inner[candidate[0], dimension[0]])
        for end in (0, 1):
            half = part.copy()
            half[dimension[0], 1 - end] = place
            todo.append((rows, half))
    return None
